#pragma once

// Creature files, *.creature.json (persist/README.md 1): one genotype, its origin and the trial
// that scored it. Any text is safe to read: the result is a valid genome or a message.

#include "core/result.h"
#include "evolution/individual/judged_individual.h"
#include "evolution/kinds/evolution_kinds.h"
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

// The facts of a score that a file has besides the individual's result.
struct ScoreNotes {
    std::optional<ConfirmedScore> confirmed = {};
    std::string unit = {};  // unit of the goal's score: "BL/s"
    TickChecks ticks = {};  // of the first trial, if they were recorded
    std::string simulator{kSimulatorVersion};

    friend bool operator==(const ScoreNotes&, const ScoreNotes&) = default;
};

// A creature and the facts that only its file has. If there is a score, the individual is evaluated
// and the settings that decide the score are those of its trial. Otherwise they are the world in
// which the creature is to be seen, or the defaults.
struct CreatureDocument {
    JudgedIndividual creature;
    std::optional<std::uint64_t> ancestry = {};  // ancestry_digest(), if the ancestors are known
    ScoreNotes notes = {};                       // valid if there is a score
    // Warnings of reading, about harmless oddities (W01 to W03, W05).
    std::vector<std::string> warnings = {};

    bool scored() const { return creature.individual->evaluated; }
    // Returns whether a creature without a score has a world other than the defaults.
    bool has_world() const;
    // Returns the score of the trial itself, in the unit of `notes`.
    double score() const { return unconfirmed_score(creature.individual->result); }
    const EvaluationResult& result() const { return creature.individual->result; }
    const Genome& genome() const { return creature.genome(); }
    const ExperimentSettings& settings() const { return *creature.settings; }
};

// Returns whether both have the same score of the same trial, or neither has a score.
bool same_score(const CreatureDocument& a, const CreatureDocument& b);

// Reads the JSON text of a creature file or card (creature_card.h).
Result<std::string> read_creature_text(const std::filesystem::path& path);

// Loads a creature file or card, whatever its name. The error message names the file and the first
// error; further errors follow, one per line.
Result<CreatureDocument> load_creature(const std::filesystem::path& path,
                                       const EvolutionKinds& kinds);
Status save_creature(const std::filesystem::path& path, const CreatureDocument& document,
                     const EvolutionKinds& kinds);

// Returns in how many dimensions the creature of a text lives; 2 for texts of other kinds.
int dimensions_of_creature(std::string_view text);

// Does the same for text; `source` names it in messages.
Result<CreatureDocument> parse_creature(std::string_view text, std::string_view source,
                                        const EvolutionKinds& kinds);
// The genome must be valid.
std::string write_creature(const CreatureDocument& document, const EvolutionKinds& kinds);

// Returns a message for each kind that a genome uses and an experiment has not enabled (W04).
std::vector<std::string> foreign_kinds(const Genome& genome, const FounderSettings& settings,
                                       const EvolutionKinds& kinds);

// Returns the document of a creature. It has no score if the trial was terminated early.
CreatureDocument creature_document(JudgedIndividual creature, const EvolutionKinds& kinds);

// Runs the scored trial again to record its ticks, and once with finer settings to record that
// score (simulator/README.md 4), unless the document has them. If stopped, it records nothing.
void complete_score(CreatureDocument& document, const EvolutionKinds& kinds,
                    const std::stop_token& stop = {});

}  // namespace cambrian
