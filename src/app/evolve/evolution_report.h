#pragma once

#include "app/evolve/run_outputs.h"
#include "evolution/evolution.h"

#include <string>
#include <string_view>

namespace cambrian {

// One line about a generation, for a person or (json) as a JSON object. cluster: an object of who
// took part, kept under that key; empty for none.
std::string generation_line(const GenerationStatistics& statistics, const std::string& unit,
                            bool json, const std::string& cluster = "");

// Where a creature comes from: when and how it was bred, and every mutation from what to what.
std::string origin_in_words(const Individual& individual);

// What came out of all generations, the files kept and why the run is over: a stop_reason(),
// "interruption" or "failure". One generation at least was evaluated.
std::string final_line(const Evolution& evolution, const std::string& unit,
                       const Individual& champion, const RunOutputs& files,
                       std::string_view stopped_by, bool json);

}  // namespace cambrian
