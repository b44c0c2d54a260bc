#pragma once

// Creatures of files against which the champions of a run can be compared.

#include "evolution/individual/judged_individual.h"
#include "evolution/kinds/evolution_kinds.h"

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace cambrian {

struct JudgedRival {
    std::string name;
    JudgedIndividual creature;
    double score = 0.0;   // in the unit of the goal
    double travel = 0.0;  // m to the right in its trial
};

// Returns the creatures of a folder that were scored for the goal and in the environment of the
// settings, lowest score first. Their scores are computed anew, with these settings and in as many
// slightly changed worlds as survivors are confirmed in, so that they can be compared with those of
// the run. Files that cannot be read are left out, as is all if a stop is requested.
std::vector<JudgedRival> judge_rivals(const std::filesystem::path& folder,
                                      const ExperimentSettings& settings,
                                      const EvolutionKinds& kinds, const std::stop_token& stop);

}  // namespace cambrian
