#pragma once

#include "evolution/statistics.h"

#include <filesystem>
#include <span>
#include <string>

namespace cambrian {

// One line about a generation, for a person or (json) as a JSON object.
std::string generation_line(const GenerationStatistics& statistics, const std::string& unit,
                            bool json);

// What came out of all of them. history is not empty.
std::string final_line(std::span<const GenerationStatistics> history, const std::string& unit,
                       const std::filesystem::path& champion, bool interrupted, bool json);

}  // namespace cambrian
