#pragma once

// The scores that offspring need to survive, for early termination (evolution/README.md 4). They
// depend on founder line and body plan, since the survivors of both are limited.

#include "evolution/selections/selection.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace cambrian {

class SurvivalThresholds {
public:
    // Knows no score.
    SurvivalThresholds() = default;
    // The survivors have scores and remain in the population. No score is known if there are none,
    // if one of them did not complete its trial, or if the selection can let a creature survive or
    // breed that is worse than all of them, or if creatures have several trials.
    SurvivalThresholds(std::span<const IndividualPtr> survivors, const ExperimentSettings& settings,
                       const SelectionKind& selection);

    // Returns the score that an offspring of the line and the body plan needs at least, if known. A
    // creature below it survives only if others lose their places in an unusual order.
    std::optional<double> of(std::uint64_t line, std::uint64_t plan) const;

private:
    // Survivors that have something in common.
    struct Group {
        std::size_t size = 0;
        double worst = std::numeric_limits<double>::infinity();  // least score

        void add(double score) {
            ++size;
            worst = std::min(worst, score);
        }
    };
    void group(std::span<const IndividualPtr> survivors);

    std::optional<double> base_;
    std::size_t most_of_line_ = 0;  // largest numbers of survivors
    std::size_t most_of_plan_ = 0;
    std::map<std::uint64_t, Group> lines_;
    std::map<std::pair<std::uint64_t, std::uint64_t>, Group> lines_and_plans_;
};

}  // namespace cambrian
