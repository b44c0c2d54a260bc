#pragma once

// The board of a challenge: every entry is computed again, checked against its file, and ranked by
// its score in the challenge's world.

#include "core/threads/thread_pool.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/challenge_file.h"
#include "simulator/trial_watch.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

struct BoardEntry {
    std::filesystem::path file;
    std::optional<CreatureDocument> document;  // empty if the file could not be read
    std::string name;
    double score = 0.0;        // in the unit of the goal
    std::size_t parts = 0;     // of the body
    std::uint64_t motion = 0;  // digest of the trials that gave the score
    std::string refusal;       // why it is not on the board, or empty
};

struct ChallengeBoard {
    Challenge challenge;
    std::vector<BoardEntry> ranked;   // best first; equal ones in the order given
    std::vector<BoardEntry> refused;  // in the order given
};

// Fails if the settings cannot be a challenge: if a score depends on other creatures.
Status check_challenge(const ExperimentSettings& settings, const EvolutionKinds& kinds);

// Judges creature files, cards and pages. An entry is refused if it has no score, if its score or
// motion is not what its trial gives, if its world or version of the simulator is another one, or
// if it moves to the last bit like one before it. Where trials draw something by chance, entries
// are ranked by trials that no search has seen. Notes how many are judged; fails if stopped.
Result<ChallengeBoard> judge_entries(const Challenge& challenge,
                                     const std::vector<std::filesystem::path>& files,
                                     const EvolutionKinds& kinds, ThreadPool& pool,
                                     const TrialWatch& watch = {});

}  // namespace cambrian
