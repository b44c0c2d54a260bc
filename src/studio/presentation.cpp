#include "studio/presentation.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostChampions = 9;
constexpr double kShortestShow = 4.0;  // s that a creature is shown at least
constexpr double kLongestShow = 15.0;

}  // namespace

std::vector<Exhibit> best_exhibits(const std::vector<JudgedIndividual>& stars,
                                   const std::vector<JudgedIndividual>& champions) {
    std::vector<Exhibit> exhibits;
    for (const JudgedIndividual& star : stars)
        exhibits.push_back(exhibit_of(star, ExhibitSource::kPopulation));
    std::vector<const JudgedIndividual*> better;
    for (const JudgedIndividual& champion : champions) {
        const bool improves = better.empty() || champion.individual->result.fitness >
                                                    better.back()->individual->result.fitness;
        if (improves && champion.individual->evaluated) better.push_back(&champion);
    }
    std::reverse(better.begin(), better.end());
    for (const JudgedIndividual* champion : better) {
        if (exhibits.size() >= stars.size() + kMostChampions) break;
        const bool starred =
            std::any_of(stars.begin(), stars.end(), [champion](const JudgedIndividual& star) {
                return star.individual->uid == champion->individual->uid;
            });
        if (!starred) exhibits.push_back(exhibit_of(*champion, ExhibitSource::kChampion));
    }
    return exhibits;
}

void Presentation::begin(std::vector<Exhibit> exhibits, std::optional<Exhibit> before) {
    on_ = true;
    exhibits_ = std::move(exhibits);
    before_ = std::move(before);
    next_ = 0;
    since_.reset();
}

std::optional<Exhibit> Presentation::end() {
    on_ = false;
    exhibits_.clear();
    return std::exchange(before_, std::nullopt);
}

const Exhibit* Presentation::update(double now, bool over) {
    if (!on_ || exhibits_.empty()) return nullptr;
    if (since_) {
        const double shown = now - *since_;
        if (shown < kShortestShow || (!over && shown < kLongestShow)) return nullptr;
    }
    since_ = now;
    return &exhibits_[std::exchange(next_, (next_ + 1) % exhibits_.size())];
}

}  // namespace cambrian
