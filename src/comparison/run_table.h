#pragma once

// The finished runs of a comparison as a CSV file with one row per run.

#include "comparison/compared_run.h"
#include "core/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// The last column is the curve: "300:0.012 600:0.05", trials and score.
std::string run_table_csv(const std::vector<ComparedRun>& runs);

// Fails, naming the line, if the text is not such a table.
Result<std::vector<ComparedRun>> parse_run_table(std::string_view text, std::string_view source);
// Returns no runs if the file does not exist.
Result<std::vector<ComparedRun>> load_run_table(const std::filesystem::path& path);

}  // namespace cambrian
