#pragma once

// Everything that defines an experiment. The engine replaces settings and never edits them in
// place. The same settings give the same results.

#include "breeding/mutation_settings.h"
#include "creature/phenotype.h"
#include "evolution/settings/kind_parameter.h"
#include "evolution/settings/preserve_settings.h"
#include "genome/founder_settings.h"
#include "simulator/trial.h"

#include <cstdint>
#include <map>
#include <string>

namespace cambrian {

struct PopulationSettings {
    int size = 300;         // creatures per generation
    double survival = 0.2;  // share that survives and breeds
    int max_clones = 1;     // survivors with the same phenotype
    int immigrants = 0;     // offspring places for random immigrants
    double tuned = 0.4;     // share of the offspring that are tuned copies of the best of a line
    // Fills the places that given founders leave: "mutants" of them or "random" creatures.
    std::string fill = "mutants";
    // Share of the founders that come from a museum (persist/creature/champion_museum.h). Random
    // creatures take the other places, and one of the founders joins each generation in turn.
    double museum = 0.0;

    friend bool operator==(const PopulationSettings&, const PopulationSettings&) = default;
};

struct SelectionSettings {
    std::string method = "truncation";  // id of a registered selection
    int elites = 2;                     // creatures that survive where all may breed
    std::string map_across = "parts";   // ids of map axes, evolution/individual/map_axis.h
    std::string map_up = "mass";
    // Largest share of the survivors for one founder's line; 1 for no limit.
    double line_share = 0.2;
    int plan_copies = 2;           // survivors with the same body plan; 0 for no limit
    int confirmations = 2;         // number of other worlds in which survivors are evaluated again
    double confirm_jitter = 0.01;  // relative change of gravity, friction and drag in these
    double confirm_tilt = 2.0;     // degrees by which the ground slopes in these, to and fro
    ParameterValues own;           // values of the parameters that single methods define

    friend bool operator==(const SelectionSettings&, const SelectionSettings&) = default;
};

struct BreedingSettings {
    // "shares", or "attribute": the first parent's gene decides, and shares if it has none.
    std::string choice = "shares";
    // Share of offspring by method id; methods that are not listed keep their default share.
    std::map<std::string, double> shares;

    friend bool operator==(const BreedingSettings&, const BreedingSettings&) = default;
};

struct ExperimentSettings {
    std::uint64_t seed = 1;
    // Limits of a run without a window; the first one reached ends it.
    int generations = 100;
    int max_evaluations = 1'000'000'000;
    double target_fitness = 0.0;  // in the goal's unit; 0 for none
    std::string goal = "walking";
    bool terminate_early = true;  // terminates trials early that cannot lead to survival
    TrialWorld world;
    PopulationSettings population;
    SelectionSettings selection;
    BreedingSettings breeding;
    MutationSettings mutation;
    FounderSettings founders = {.rhythmic_share = 0.5};
    ExpressionSettings expression;
    PreserveSettings preserve;  // only a preserve has other ones than the defaults

    friend bool operator==(const ExperimentSettings&, const ExperimentSettings&) = default;
};

// Returns whether scores given under one are valid under the other.
inline bool same_judgement(const ExperimentSettings& a, const ExperimentSettings& b) {
    return a.goal == b.goal && a.world == b.world && a.expression == b.expression;
}

using SettingsPtr = std::shared_ptr<const ExperimentSettings>;

}  // namespace cambrian
