#pragma once

// The finished runs of a comparison, summed up for the window.

#include "comparison/arm_result.h"
#include "comparison/curves.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

struct ComparedArm {
    std::string name;
    std::size_t finished = 0;         // runs
    std::optional<ArmResult> result;  // none before the first run is finished
    CurveBand band;                   // of the finished runs
    std::filesystem::path champion;   // file of the best finished run's; empty before
};

struct ComparisonResults {
    std::vector<ComparedArm> arms;  // in the order of the plan; the first is the reference
    std::size_t planned = 0;        // runs of each arm
    bool ended = false;             // whether no run is under way any more
    std::string problem;            // why it ended early; empty unless it failed

    std::size_t finished() const;      // runs of all arms
    std::size_t planned_runs() const;  // of all arms
};

// Sums up the finished runs of these arms.
ComparisonResults results_of(const std::vector<std::string>& arms, std::size_t planned,
                             const std::vector<ComparedRun>& finished,
                             const std::filesystem::path& folder);

}  // namespace cambrian
