#pragma once

// The state of the engine for other threads: immutable, shallow, published after every change.

#include "evolution/individual/judged_individual.h"
#include "evolution/individual/statistics.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

enum class EngineStatus : std::uint8_t { kPaused, kRunning, kFailed };

// A change of settings and the first generation it applied to.
struct JournalEntry {
    std::uint32_t generation = 0;
    SettingsPtr settings;
};

struct EvolutionSnapshot {
    // Number of StartExperiment commands so far; identifies the experiment.
    std::uint64_t experiment = 0;
    EngineStatus status = EngineStatus::kPaused;
    std::string failure;           // message if the state is kFailed
    std::uint32_t generation = 0;  // generation being evaluated or waiting for it
    SettingsPtr settings;          // settings of that generation
    // Newest finished generation, best first; empty at first.
    std::vector<IndividualPtr> population;
    std::vector<GenerationStatistics> history;
    // Evaluation time of each row of the history, in s; 0 where unknown.
    std::vector<double> wall_times;
    // The champion of each finished generation: audited, if evolution was paused after it,
    // otherwise the best by score.
    std::vector<JudgedIndividual> champions;
    std::vector<JournalEntry> journal;
};

}  // namespace cambrian
