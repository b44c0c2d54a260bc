#include "studio/playback/ghosts.h"

#include "core/stopwatch.h"
#include "evolution/evaluation/trials.h"

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

std::unique_ptr<Ghost> Ghost::start(const JudgedIndividual& champion, const Kinds& kinds,
                                    const Environment& environment) {
    TrialWorld world = first_trial_world(*champion.settings);
    world.environment = environment;
    auto phenotype = std::make_shared<const Phenotype>(
        express(*champion.individual->genome, kinds, champion.settings->expression, world.scene));
    auto replay = Replay::start(std::move(phenotype), kinds, world);
    if (!replay) return nullptr;
    return std::unique_ptr<Ghost>(new Ghost(champion, std::move(*replay)));
}

Ghost::Ghost(JudgedIndividual champion, std::unique_ptr<Replay> replay)
    : champion_(std::move(champion)), replay_(std::move(replay)) {
    motion_.jump_to(trial().scene());
}

bool Ghost::go_back(std::uint64_t tick) {
    replay_->go_back(tick);
    motion_.jump_to(trial().scene());
    return true;
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
    const Basis basis{snapshot.experiment, snapshot.champions.size(), choice,
                      playback.exhibit().genome()};
    if (basis == basis_) return;
    basis_ = basis;
    const auto chosen = choose_ghosts(snapshot.champions, choice, basis.shown.get());
    const auto wanted = [&chosen](const std::unique_ptr<Ghost>& ghost) {
        return std::any_of(chosen.begin(), chosen.end(), [&ghost](const JudgedIndividual* each) {
            return each->individual->genome.get() == &ghost->genome();
        });
    };
    std::erase_if(ghosts_, [&wanted](const auto& ghost) { return !wanted(ghost); });
    called_.clear();
    for (const JudgedIndividual* each : chosen) {
        const bool here = std::any_of(ghosts_.begin(), ghosts_.end(), [each](const auto& ghost) {
            return &ghost->genome() == each->individual->genome.get();
        });
        if (!here) called_.push_back(*each);
    }
}

void Ghosts::call_next(const Environment& environment) {
    if (called_.empty()) return;
    auto ghost = Ghost::start(called_.back(), *kinds_, environment);
    called_.pop_back();
    if (ghost != nullptr) ghosts_.push_back(std::move(ghost));
}

void Ghosts::update(const EvolutionSnapshot& snapshot, GhostChoice choice, const Playback& playback,
                    double budget) {
    if (playback.empty()) return;
    choose(snapshot, choice, playback);
    call_next(playback.creature().replay().environment());
    if (playback.seeking()) return;
    const Stopwatch spent;
    bool moved = true;
    while (moved && spent.seconds() < budget) {
        moved = false;
        for (const auto& ghost : ghosts_)
            moved = ghost->follow(playback) || moved;
    }
    for (const auto& ghost : ghosts_)
        ghost->show(playback.share());
}

}  // namespace cambrian
