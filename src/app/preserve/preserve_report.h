#pragma once

#include "preserve/series.h"

#include <cstdint>
#include <string>

namespace cambrian {

// Returns the state in words for people; `factor` is its speed over real time.
std::string preserve_words(const SeriesRow& row, double factor);

// Returns a row as one line of JSON.
std::string preserve_json(const SeriesRow& row, double factor, std::uint64_t digest);

}  // namespace cambrian
