#pragma once

// Creature files, *.creature.json (persist/README.md 1): one genotype, its origin and the trial
// that scored it. Any text is safe to read: the result is a valid genome or a message.

#include "core/result.h"
#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "evolution/settings/judged_settings.h"
#include "simulator/simulator_version.h"
#include "simulator/tick_checks.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// The scores of a creature in the trial's world and in slightly different ones.
struct ConfirmedScore {
    double median = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    int worlds = 0;

    friend bool operator==(const ConfirmedScore&, const ConfirmedScore&) = default;
};

// The trial that scored the creature: all that is needed to run it again.
struct ScoredRecord {
    TrialWorld world;
    ExpressionSettings expression;
    std::string goal;        // id
    std::uint64_t seed = 0;  // seed of the experiment
    double fitness = 0.0;    // in `unit`; score of the trial itself
    std::optional<ConfirmedScore> confirmed;
    std::string unit;              // unit of the goal's score: "BL/s"
    std::uint64_t trajectory = 0;  // digest of the motion
    TickChecks ticks = {};         // of the first trial, if they were recorded
    std::optional<FinerResult> finer;
    std::string simulator{kSimulatorVersion};

    friend bool operator==(const ScoredRecord&, const ScoredRecord&) = default;
};

struct CreatureDocument {
    Genome genome;
    std::string uid;                        // 16 hexadecimal digits, or empty
    std::vector<std::string> parents;       // uids, at most 2
    std::string method;                     // breeding method
    std::optional<std::uint64_t> ancestry;  // ancestry_digest(), if the ancestors are known
    std::optional<ScoredRecord> scored;
    // Warnings of reading, about harmless oddities (W01 to W03).
    std::vector<std::string> warnings;
};

// Reads the JSON text of a creature file or card (creature_card.h).
Result<std::string> read_creature_text(const std::filesystem::path& path);

// Loads a creature file or card, whatever its name. The error message names the file and the first
// error; further errors follow, one per line.
Result<CreatureDocument> load_creature(const std::filesystem::path& path,
                                       const EvolutionKinds& kinds);
Status save_creature(const std::filesystem::path& path, const CreatureDocument& document,
                     const EvolutionKinds& kinds);

// Does the same for text; `source` names it in messages.
Result<CreatureDocument> parse_creature(std::string_view text, std::string_view source,
                                        const EvolutionKinds& kinds);
// The genome must be valid.
std::string write_creature(const CreatureDocument& document, const EvolutionKinds& kinds);

// Returns a message for each kind that a genome uses and an experiment has not enabled (W04).
std::vector<std::string> foreign_kinds(const Genome& genome, const FounderSettings& settings,
                                       const EvolutionKinds& kinds);

// Returns the document of an individual that was evaluated with these settings.
CreatureDocument creature_document(const Individual& individual, const ExperimentSettings& settings,
                                   const EvolutionKinds& kinds);

// Runs the scored trial again to record its ticks, and once with finer settings to record that
// score (simulator/README.md 4), unless the document has them. If stopped, it records nothing.
void complete_score(CreatureDocument& document, const EvolutionKinds& kinds,
                    const std::stop_token& stop = {});

}  // namespace cambrian
