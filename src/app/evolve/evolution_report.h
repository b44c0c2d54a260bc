#pragma once

#include "app/evolve/run_outputs.h"
#include "evolution/evolution.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace cambrian {

// Facts that all lines about a run share.
struct ReportedRun {
    std::uint64_t seed = 0;
    std::string unit;   // of the goal
    bool json = false;  // lines are JSON objects
};

// Returns one line about a generation. `cluster` is a JSON object that says who took part; it is
// added to JSON under that key unless empty.
std::string generation_line(const GenerationStatistics& statistics, const ReportedRun& run,
                            const std::string& cluster);

// Returns a creature's origin: generation and method of breeding, and every mutation with both
// values.
std::string origin_in_words(const Individual& individual);

// A champion. Goals that judge all trials together add its score in trials that evolution did not
// use.
struct ReportedChampion {
    const Individual& individual;
    std::optional<double> held_out = {};
};

// Returns the result of the run, its files and why it ended: a stop_reason(), "interruption" or
// "failure". At least one generation must have been evaluated.
std::string final_line(const Evolution& evolution, const ReportedRun& run,
                       const ReportedChampion& champion, const RunOutputs& files,
                       std::string_view stopped_by);

}  // namespace cambrian
