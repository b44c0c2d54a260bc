#include "studio/playback/ghosts.h"

#include "core/stopwatch.h"
#include "evolution/evaluation/trials.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kImprovements = 3;
constexpr std::uint32_t kTenth = 10;  // generations between two ghosts
constexpr std::size_t kMostTenths = 6;
constexpr std::size_t kAcross = 5;

using Records = std::vector<const JudgedIndividual*>;

// Returns the champions that are fitter than all before them.
Records improvements(const std::vector<JudgedIndividual>& champions) {
    Records found;
    for (const JudgedIndividual& each : champions) {
        if (found.empty() || fitter(each.individual->result, found.back()->individual->result))
            found.push_back(&each);
    }
    return found;
}

Records tenths(const std::vector<JudgedIndividual>& champions) {
    Records found;
    for (const JudgedIndividual& each : champions) {
        if (each.generation % kTenth == 0) found.push_back(&each);
    }
    return found;
}

Records across(const std::vector<JudgedIndividual>& champions) {
    Records found;
    const std::size_t count = std::min(kAcross, champions.size());
    for (std::size_t i = 0; i < count; ++i)
        found.push_back(
            &champions[i * (champions.size() - 1) / std::max<std::size_t>(1, count - 1)]);
    return found;
}

// Returns the newest `most` of them; no genome occurs twice.
Records newest(const Records& records, std::size_t most, const Genome* shown) {
    Records kept;
    for (auto each = records.rbegin(); each != records.rend() && kept.size() < most; ++each) {
        const Genome* genome = (*each)->individual->genome.get();
        const bool known =
            std::any_of(kept.begin(), kept.end(), [genome](const JudgedIndividual* other) {
                return other->individual->genome.get() == genome;
            });
        if (genome != shown && !known) kept.push_back(*each);
    }
    std::reverse(kept.begin(), kept.end());
    return kept;
}

std::uint64_t test_ticks(const Trial& trial) {
    return trial.ticks() - trial.settle_ticks();
}

}  // namespace

std::vector<const JudgedIndividual*> choose_ghosts(const std::vector<JudgedIndividual>& champions,
                                                   GhostChoice choice, const Genome* shown) {
    switch (choice) {
        case GhostChoice::kNone:
            break;
        case GhostChoice::kImprovements:
            return newest(improvements(champions), kImprovements, shown);
        case GhostChoice::kTenths:
            return newest(tenths(champions), kMostTenths, shown);
        case GhostChoice::kAcross:
            return newest(across(champions), kAcross, shown);
    }
    return {};
}

std::unique_ptr<Ghost> Ghost::start(const Companion& companion, const Kinds& kinds,
                                    const Environment& environment, int trial) {
    const ExperimentSettings& settings = *companion.creature.settings;
    TrialSetup setup = trial_setup(companion.creature.individual->genome, settings, trial);
    setup.world.environment = environment;
    auto phenotype = std::make_shared<const Phenotype>(
        express(*setup.genome, kinds, settings.expression, setup.world.scene));
    auto replay = Replay::start(std::move(phenotype), kinds, setup.world);
    if (!replay) return nullptr;
    return std::unique_ptr<Ghost>(new Ghost(companion, std::move(*replay)));
}

Ghost::Ghost(Companion companion, std::unique_ptr<Replay> replay)
    : it_(std::move(companion)), replay_(std::move(replay)) {
    motion_.jump_to(trial().scene());
}

bool Ghost::go_back(std::uint64_t tick) {
    replay_->go_back(tick);
    motion_.jump_to(trial().scene());
    return true;
}

void Ghost::show(double share, double travel) {
    motion_.show(share);
    mirrored_.clear();
    const Environment& world = replay_->environment();
    const bool symmetric =
        world.gravity_direction == -90.0 && !world.has_light && world.dimensions == 2;
    if (!symmetric || it_.travel * travel >= 0.0) return;
    for (const Pose& pose : motion_.poses())
        mirrored_.push_back(
            planar_pose(-pose.position.x(), pose.position.y(), -planar_angle(pose)));
}

bool Ghost::follow(const Playback& playback) {
    if (!(replay_->environment() == playback.creature().replay().environment()))
        replay_->set_environment(playback.creature().replay().environment());
    const Trial& leader = playback.trial();
    if (leader.settling()) {
        if (trial().ticks() > leader.ticks()) return go_back(leader.ticks());
        if (!trial().settling() || trial().ticks() == leader.ticks()) return false;
    } else if (!trial().settling()) {
        const std::uint64_t due = test_ticks(leader);
        if (test_ticks(trial()) > due) return go_back(trial().settle_ticks() + due);
        if (test_ticks(trial()) == due) return false;
    }
    if (replay_->diverged()) return false;
    replay_->tick();
    motion_.follow(trial().scene());
    return true;
}

void Ghosts::choose(const EvolutionSnapshot& snapshot, GhostChoice choice,
                    const Playback& playback) {
    const Exhibit& exhibit = playback.exhibit();
    const bool raced = companion_ && exhibit.source == ExhibitSource::kChampion &&
                       exhibit.experiment == snapshot.experiment;
    const Basis basis{snapshot.experiment,
                      snapshot.champions.size(),
                      choice,
                      exhibit.genome(),
                      raced ? companion_->creature.individual->genome : nullptr,
                      raced ? companion_->words : std::string()};
    if (basis == basis_) return;
    basis_ = basis;
    std::vector<Companion> chosen;
    for (const JudgedIndividual* each :
         choose_ghosts(snapshot.champions, choice, basis.shown.get()))
        chosen.push_back({*each, fmt::format("generation {}", each->generation)});
    if (raced) chosen.push_back(*companion_);
    const auto is = [](const Companion& companion, const Ghost& ghost) {
        return &companion.creature.genome() == &ghost.genome() && companion.words == ghost.words();
    };
    std::erase_if(ghosts_, [&](const auto& ghost) {
        return std::none_of(chosen.begin(), chosen.end(),
                            [&](const Companion& each) { return is(each, *ghost); });
    });
    called_.clear();
    for (Companion& each : chosen) {
        const bool here = std::any_of(ghosts_.begin(), ghosts_.end(),
                                      [&](const auto& ghost) { return is(each, *ghost); });
        if (!here) called_.push_back(std::move(each));
    }
}

void Ghosts::call_next(const Trial& beside, const Environment& environment) {
    if (called_.empty()) return;
    auto ghost = Ghost::start(called_.back(), *kinds_, environment, beside.world().light.trial);
    called_.pop_back();
    if (ghost != nullptr) ghosts_.push_back(std::move(ghost));
}

void Ghosts::update(const EvolutionSnapshot& snapshot, GhostChoice choice, const Playback& playback,
                    double travel, double budget) {
    if (playback.empty()) return;
    if (std::exchange(trial_, playback.creature().trial_number()) !=
        playback.creature().trial_number()) {
        ghosts_.clear();
        basis_ = {};
    }
    choose(snapshot, choice, playback);
    call_next(playback.trial(), playback.creature().replay().environment());
    if (playback.seeking()) return;
    const Stopwatch spent;
    bool moved = true;
    while (moved && spent.seconds() < budget) {
        moved = false;
        for (const auto& ghost : ghosts_)
            moved = ghost->follow(playback) || moved;
    }
    for (const auto& ghost : ghosts_)
        ghost->show(playback.share(), travel);
}

}  // namespace cambrian
