#pragma once

// The data of comparisons that panels see, and the requests they may make of them.

#include "studio/comparison/comparison_draft.h"
#include "studio/comparison/comparison_results.h"

#include <memory>
#include <string>
#include <variant>

namespace cambrian {

// Opens or closes the card of comparisons.
struct ToggleComparison {};
struct EditComparison {
    ComparisonDraft draft;
};
// Compares by the draft, in the world of the present settings, or goes on with what was stopped.
struct BeginComparison {};
struct StopComparison {};

using ComparisonRequest =
    std::variant<ToggleComparison, EditComparison, BeginComparison, StopComparison>;

struct ComparisonView {
    bool card_open = false;
    ComparisonDraft draft;
    bool running = false;
    double share = 0.0;  // of the trials that the present comparison began with
    // Belongs to the last comparison; null before the first.
    std::shared_ptr<const ComparisonResults> results;
    std::string unit;     // of the compared scores
    std::string folder;   // of the last comparison
    std::string problem;  // why the last one could not begin or ended early; empty if it did not
};

}  // namespace cambrian
