#include "studio/playback/played_creature.h"

#include "evolution/evaluation/trials.h"

#include <utility>

namespace cambrian {

Status PlayedCreature::show(Exhibit exhibit) {
    auto phenotype = std::make_shared<const Phenotype>(express(
        *exhibit.genome(), *kinds_, exhibit.settings().expression, exhibit.settings().world.scene));
    auto replay = Replay::start(phenotype, *kinds_, first_trial_world(exhibit.settings()));
    if (!replay) return replay.error();
    replay_.reset();
    exhibit_ = std::move(exhibit);
    phenotype_ = std::move(phenotype);
    readings_ = {};
    begin(std::move(*replay));
    return {};
}

void PlayedCreature::show_trial(int trial) {
    const TrialSetup setup = trial_setup(exhibit_.genome(), exhibit_.settings(), trial);
    auto phenotype = std::make_shared<const Phenotype>(
        express(*setup.genome, *kinds_, exhibit_.settings().expression, setup.world.scene));
    auto replay = Replay::start(phenotype, *kinds_, setup.world);
    if (!replay) return;
    phenotype_ = std::move(phenotype);
    readings_ = {};
    begin(std::move(*replay));
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
