#pragma once

// Where an experiment is kept while it runs, and what can be had back from there. Files are one
// such place (persist/experiment/experiment_file.h).

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

// What changes the course of an experiment once it has begun.
using SteeringCommand = std::variant<ChangeSettings, InjectGenome, AddNewcomers, RescorePopulation>;

// A command, and the generation that was present when it was given: newly bred, not yet evaluated
// to the end.
struct NotedCommand {
    std::uint32_t generation = 0;
    SteeringCommand command;
};

// All calls belong to the thread that evolves. A call that fails has changed nothing and may be
// repeated.
class ExperimentLog {
public:
    virtual ~ExperimentLog() = default;
    // Generation 0 of these founders and settings; comes first, once.
    virtual Status begin(const SettingsPtr& settings, const std::vector<GenomePtr>& founders) = 0;
    virtual Status note(const NotedCommand& command) = 0;
    // The generation just evaluated, before it is bred from.
    virtual Status record(const Evolution& evolution) = 0;
};

// A version of the simulator, and the first generation it computed.
struct SimulatorChange {
    std::uint32_t generation = 0;
    std::string version;
};

// An experiment as it was kept.
struct SavedExperiment {
    std::vector<SimulatorChange> simulators;  // in order; the first computed generation 0
    SettingsPtr settings;                     // at generation 0
    std::vector<GenomePtr> founders;
    std::vector<NotedCommand> journal;        // in order
    std::vector<JudgedIndividual> champions;  // one a recorded generation
    std::vector<std::uint64_t> digests;       // population_digest() of each
    std::optional<EvolutionState> latest;     // newest recorded generation
};

// Gives an evolution that has come to the generation the commands noted while it was present.
void give_commands(Evolution& evolution, const std::vector<NotedCommand>& journal,
                   std::uint32_t generation);

// Where settings changed, generation 0 included.
std::vector<JournalEntry> setting_changes(const SavedExperiment& saved);

// The experiment from its beginning, as it was when generation 0 had not been evaluated.
Evolution begun_anew(const SavedExperiment& saved, const EvolutionKinds& kinds);
// As it was when it was last kept: the generation after the newest recorded one.
Evolution resumed(const SavedExperiment& saved, const EvolutionKinds& kinds);

}  // namespace cambrian
