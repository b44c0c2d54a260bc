#include "comparison/challenge_board.h"

#include "core/text/shown_score.h"
#include "evolution/evaluation/trials.h"
#include "evolution/fields/setting_field.h"
#include "evolution/settings/chance.h"
#include "genome/creature_name.h"
#include "persist/creature/rescoring.h"
#include "persist/text/digest_text.h"
#include "persist/text/setting_value.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

namespace cambrian {
namespace {

// Returns the settings with the judgement of others, except for what chance draws anew in a run,
// and for the number of trials and their renewal if entries are ranked by others.
ExperimentSettings judging_as(const ExperimentSettings& own, const ExperimentSettings& other,
                              bool chance) {
    ExperimentSettings judging = own;
    judging.goal = other.goal;
    judging.world = other.world;
    judging.world.trial.draw = own.world.trial.draw;
    judging.world.light = own.world.light;
    if (chance) {
        judging.world.trial.trials = own.world.trial.trials;
        judging.world.trial.renewal = own.world.trial.renewal;
    }
    judging.expression = other.expression;
    return judging;
}

// Returns in what the entry's world differs, or nothing.
std::string other_world(const ExperimentSettings& challenge, const ExperimentSettings& entry,
                        const EvolutionKinds& kinds) {
    const ExperimentSettings judging = judging_as(challenge, entry, has_chance(challenge.world));
    if (same_judgement(challenge, judging)) return {};
    for (const SettingField& field : setting_fields(kinds)) {
        const SettingValue expected = value_of(field, challenge);
        const SettingValue found = value_of(field, judging);
        if (found == expected) continue;
        return fmt::format("was scored in another world: {} is {}, the challenge has {}",
                           path_of(field), setting_text(found), setting_text(expected));
    }
    return "was scored in another world";
}

// Returns what is wrong with an entry's file itself, or nothing.
std::string fault_of(const CreatureDocument& document, const EvaluationResult& again) {
    const EvaluationResult& scored = document.result();
    const std::string& unit = document.notes.unit;
    if (again.digest != scored.digest)
        return fmt::format("moves otherwise than its file says: motion {}, not {}",
                           digest_text(again.digest), digest_text(scored.digest));
    if (again.fitness != document.score())
        return fmt::format("scores {}, not {} as its file says", shown_score(again.fitness, unit),
                           shown_score(document.score(), unit));
    return {};
}

void judge(BoardEntry& entry, const Challenge& challenge, const EvolutionKinds& kinds,
           const std::stop_token& stop) {
    Result<CreatureDocument> loaded = load_creature(entry.file, kinds);
    if (!loaded) {
        entry.refusal = loaded.error().message;
        return;
    }
    entry.document = *std::move(loaded);
    const CreatureDocument& document = *entry.document;
    entry.name = creature_name(document.genome());
    if (!document.scored()) {
        entry.refusal = "holds no score";
        return;
    }
    if (const auto version = other_simulator(document)) {
        entry.refusal = *version + "; `cambrian rescore` scores it anew";
        return;
    }
    entry.refusal = other_world(challenge.settings, document.settings(), kinds);
    if (!entry.refusal.empty()) return;
    const EvaluationResult again = run_scored_trial(document, kinds, stop);
    entry.refusal = fault_of(document, again);
    if (!entry.refusal.empty()) return;
    ExperimentSettings settings = challenge.settings;
    settings.seed = challenge.table.held_out_seed;
    const EvaluationResult result =
        has_chance(settings.world)
            ? held_out_result(document.creature.individual->genome, settings, kinds, stop)
            : again;
    entry.score = result.fitness;
    entry.motion = result.digest;
    entry.parts =
        express(document.genome(), kinds.creature, settings.expression, settings.world.scene)
            .parts.size();
    if (result.outcome != Outcome::kCompleted)
        entry.refusal = fmt::format("does not finish the trials of the challenge: {}",
                                    outcome_name(result.outcome));
}

// Refuses those that move like one before them.
void refuse_copies(std::vector<BoardEntry>& entries) {
    std::vector<const BoardEntry*> known;
    for (BoardEntry& entry : entries) {
        if (!entry.refusal.empty()) continue;
        const auto original =
            std::find_if(known.begin(), known.end(),
                         [&](const BoardEntry* other) { return other->motion == entry.motion; });
        if (original == known.end())
            known.push_back(&entry);
        else
            entry.refusal = fmt::format("is the creature of {}: every bit of the motion is equal",
                                        (*original)->file.filename().string());
    }
}

}  // namespace

Status check_challenge(const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    const GoalKind* goal = kinds.goals.find(settings.goal);
    if (goal == nullptr || !goal->is_contest) return {};
    return Error{
        fmt::format("[goal] behavior: a score in {} depends on the opponent, so it cannot "
                    "be that of a challenge",
                    settings.goal)};
}

Result<ChallengeBoard> judge_entries(const Challenge& challenge,
                                     const std::vector<std::filesystem::path>& files,
                                     const EvolutionKinds& kinds, ThreadPool& pool,
                                     const TrialWatch& watch) {
    std::vector<BoardEntry> entries(files.size());
    std::atomic<std::size_t> judged = 0;
    const bool complete = pool.parallel_for(
        files.size(),
        [&](std::size_t i, std::size_t) {
            entries[i].file = files[i];
            judge(entries[i], challenge, kinds, watch.stop);
            watch.note(static_cast<double>(++judged));
        },
        watch.stop);
    if (!complete || watch.stop.stop_requested()) return Error{"interrupted; nothing was written"};
    refuse_copies(entries);
    ChallengeBoard board{challenge, {}, {}};
    for (BoardEntry& entry : entries)
        (entry.refusal.empty() ? board.ranked : board.refused).push_back(std::move(entry));
    std::stable_sort(board.ranked.begin(), board.ranked.end(),
                     [](const BoardEntry& a, const BoardEntry& b) { return a.score > b.score; });
    return board;
}

}  // namespace cambrian
