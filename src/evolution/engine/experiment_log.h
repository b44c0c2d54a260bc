#pragma once

// The interface to the storage of a running experiment, and the data that can be loaded from it.
// Files implement it (persist/experiment/experiment_file.h).

#include "core/result.h"
#include "evolution/engine/command.h"
#include "evolution/engine/snapshot.h"
#include "evolution/evolution.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace cambrian {

// Commands that change the course of a running experiment.
using SteeringCommand =
    std::variant<ChangeSettings, InjectGenome, AddImmigrants, RescorePopulation>;

// A command and the generation in which it was given: bred, but not yet completely evaluated.
struct NotedCommand {
    std::uint32_t generation = 0;
    SteeringCommand command;
};

// Only the evolving thread calls it. A failed call changes nothing and may be repeated.
class ExperimentLog {
public:
    virtual ~ExperimentLog() = default;
    // Stores generation 0 of these founders and settings. Must be called first, and once.
    virtual Status begin(const SettingsPtr& settings, const std::vector<GenomePtr>& founders) = 0;
    virtual Status note(const NotedCommand& command) = 0;
    // Stores a generation that was evaluated and not yet bred from.
    virtual Status record(const Evolution& evolution) = 0;
    // Stores the audited champion (Evolution::confirmed_champion()) of the newest recorded
    // generation, in place of its best by score.
    virtual Status crown(const JudgedIndividual& champion) = 0;
};

// A version of the simulator, and the first generation it computed.
struct SimulatorChange {
    std::uint32_t generation = 0;
    std::string version;
};

// A stored experiment.
struct SavedExperiment {
    std::vector<SimulatorChange> simulators;  // in order; the first computed generation 0
    SettingsPtr settings;                     // settings of generation 0
    std::vector<GenomePtr> founders;
    std::vector<NotedCommand> journal;  // in order
    // One per recorded generation: the audited champion or, if there is none, the best by score.
    std::vector<JudgedIndividual> champions;
    std::vector<std::uint64_t> digests;    // population_digest() of each recorded generation
    std::optional<EvolutionState> latest;  // newest recorded generation
};

// Applies to an evolution the commands that were given in its present generation.
void give_commands(Evolution& evolution, const std::vector<NotedCommand>& journal);

// Returns the settings of generation 0 and every later change.
std::vector<JournalEntry> setting_changes(const SavedExperiment& saved);

// The experiment at its start, with generation 0 not yet evaluated.
Evolution begun_anew(const SavedExperiment& saved, const EvolutionKinds& kinds);
// The experiment at its end: the generation after the newest stored one.
Evolution resumed(const SavedExperiment& saved, const EvolutionKinds& kinds);

}  // namespace cambrian
