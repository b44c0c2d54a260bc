#include "preserve/engine/preserve_picture.h"

#include "preserve/preserve.h"

#include <algorithm>
#include <utility>

namespace cambrian {

const ResidentPicture* PreservePicture::find(std::uint64_t number) const {
    const auto found = std::lower_bound(residents.begin(), residents.end(), number,
                                        [](const ResidentPicture& each, std::uint64_t wanted) {
                                            return each.life.number < wanted;
                                        });
    return found == residents.end() || found->life.number != number ? nullptr : &*found;
}

void PreserveCamera::take(const Preserve& preserve, PreservePicture& picture) {
    picture.tick = preserve.ticks();
    picture.laws = preserve.laws();
    picture.area = preserve.area();
    picture.walls = preserve.walls().rectangles();
    picture.patches = preserve.patches();
    picture.now = preserve.row();
    picture.residents = residents_of(preserve);
    picture.brain = brain_in(preserve);
    picture.plants.assign(preserve.plants().all().begin(), preserve.plants().all().end());
    picture.flesh.assign(preserve.flesh().all().begin(), preserve.flesh().all().end());
}

LiveBrain PreserveCamera::brain_in(const Preserve& preserve) const {
    LiveBrain live;
    const auto found =
        std::find_if(preserve.residents().begin(), preserve.residents().end(),
                     [this](const auto& each) { return each->life.number == watched_; });
    if (found == preserve.residents().end()) return live;
    const Brain& brain = (*found)->brain();
    live.creature = watched_;
    live.slots.assign(brain.values().begin(), brain.values().end());
    for (std::size_t i = 0; i < (*found)->phenotype().network.outputs.size(); ++i)
        live.outputs.push_back(brain.output(i));
    return live;
}

std::vector<ResidentPicture> PreserveCamera::residents_of(const Preserve& preserve) {
    const PreserveSettings& laws = preserve.settings()->preserve;
    const Torus torus = preserve.area().torus();
    std::vector<ResidentPicture> pictures;
    std::vector<Known> living;
    pictures.reserve(preserve.residents().size());
    living.reserve(preserve.residents().size());
    auto known = known_.begin();
    for (const auto& each : preserve.residents()) {
        const std::uint64_t number = each->life.number;
        while (known != known_.end() && known->number < number)
            ++known;
        const bool seen = known != known_.end() && known->number == number;
        const Life& life = each->life;
        const Energy gained = life.eaten_plants + life.eaten_flesh + life.bitten;
        Known now{number, nullptr, gained, 0, each->bitten ? preserve.ticks() : 0};
        if (seen) {
            now.phenotype = std::move(known->phenotype);
            now.fed = gained > known->gained ? preserve.ticks() : known->fed;
            if (each->bitten && known->bitten_since != 0) now.bitten_since = known->bitten_since;
        } else {
            now.phenotype = std::make_shared<const Phenotype>(each->phenotype());
        }
        living.push_back(std::move(now));
        const Vec3 center = torus.shortest(each->center());
        std::vector<Rectangle> parts;
        for (const Rectangle& part : each->rectangles())
            parts.push_back(moved(part, center - each->center()));
        pictures.push_back(
            {.life = life,
             .store = joules(each->store),
             .body = joules(each->body),
             .birth_need = (2.0 * laws.birth_energy + laws.body_energy) * each->life.mass,
             .bitten = each->bitten,
             .bitten_since = living.back().bitten_since,
             .fed = living.back().fed,
             .center = center,
             .velocity = each->velocity(),
             .parts = std::move(parts),
             .phenotype = living.back().phenotype});
    }
    known_ = std::move(living);
    return pictures;
}

}  // namespace cambrian
