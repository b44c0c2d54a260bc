#include "studio/playback/played_creature.h"

#include "evolution/evaluation/trials.h"

#include <utility>

namespace cambrian {

Status PlayedCreature::show(Exhibit exhibit) {
    auto whole = std::make_shared<const Phenotype>(express(
        *exhibit.genome(), *kinds_, exhibit.settings().expression, exhibit.settings().world.scene));
    Status begun = begin(std::move(whole), {}, first_trial_world(exhibit.settings()));
    if (begun) exhibit_ = std::move(exhibit);
    return begun;
}

Status PlayedCreature::deprive(std::vector<Lesion> lesions) {
    const int trial = trial_number();
    TrialWorld world = trial_setup(exhibit_.genome(), exhibit_.settings(), trial).world;
    world.environment = replay_->environment();
    return begin(whole_, std::move(lesions), world);
}

void PlayedCreature::show_trial(int trial) {
    const TrialSetup setup = trial_setup(exhibit_.genome(), exhibit_.settings(), trial);
    auto whole = std::make_shared<const Phenotype>(
        express(*setup.genome, *kinds_, exhibit_.settings().expression, setup.world.scene));
    static_cast<void>(begin(std::move(whole), lesions_, setup.world));
}

Status PlayedCreature::begin(std::shared_ptr<const Phenotype> whole, std::vector<Lesion> lesions,
                             const TrialWorld& world) {
    std::shared_ptr<const Phenotype> body = whole;
    if (!lesions.empty()) {
        Phenotype deprived = *whole;
        inflict(lesions, deprived);
        body = std::make_shared<const Phenotype>(std::move(deprived));
    }
    auto replay = Replay::start(body, *kinds_, world);
    if (!replay) return replay.error();
    whole_ = std::move(whole);
    lesions_ = std::move(lesions);
    replay_.reset();
    phenotype_ = std::move(body);
    readings_ = {};
    begin(std::move(*replay));
    return {};
}

void PlayedCreature::restart() {
    TrialWorld world = trial_setup(exhibit_.genome(), exhibit_.settings(), trial_number()).world;
    world.environment = replay_->environment();
    auto replay = Replay::start(phenotype_, *kinds_, world);
    if (replay) begin(std::move(*replay));
}

void PlayedCreature::begin(std::unique_ptr<Replay> replay) {
    replay_ = std::move(replay);
    hold_.reset();
    readings_.begin(replay_->trial());
    show_present();
}

void PlayedCreature::tick() {
    if (replay_->diverged()) return;
    replay_->tick(hold());
    motion_.follow(replay_->trial().scene());
    bout_.follow(replay_->trial().bout());
    readings_.add(replay_->trial(), phenotype_->network.outputs.size());
}

void PlayedCreature::go_back(std::uint64_t tick) {
    replay_->go_back(tick);
    readings_.go_back(replay_->trial());
}

void PlayedCreature::set_environment(const Environment& environment) {
    if (empty() || replay_->environment() == environment) return;
    const bool other_ground = !(replay_->environment().terrain == environment.terrain);
    replay_->set_environment(environment);
    if (other_ground) restart();
}

void PlayedCreature::force(std::size_t neuron, std::optional<double> value) {
    auto forced = replay_->forced();
    if (value) {
        forced[neuron] = *value;
    } else {
        forced.erase(neuron);
    }
    replay_->set_forced(forced);
}

}  // namespace cambrian
