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
    std::uint64_t experiment = 0;  // counts StartExperiment; a new number is a new experiment
    EngineStatus status = EngineStatus::kPaused;
    std::string failure;                    // if kFailed
    std::uint32_t generation = 0;           // being evaluated or waiting for it
    SettingsPtr settings;                   // in force for that generation
    std::vector<IndividualPtr> population;  // newest finished generation, best first; empty before
    std::vector<GenerationStatistics> history;
    std::vector<double> wall_times;           // s, of evaluating each of these; 0 where unknown
    std::vector<JudgedIndividual> champions;  // the best of each finished generation
    std::vector<JournalEntry> journal;
};

}  // namespace cambrian
