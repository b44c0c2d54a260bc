#pragma once

// The finished runs of a comparison as one CSV file, a row a run.

#include "comparison/compared_run.h"
#include "core/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// The curve is the last column: "300:0.012 600:0.05", trials and score.
std::string run_table_csv(const std::vector<ComparedRun>& runs);

// Fails, naming the line, for text that is no such table.
Result<std::vector<ComparedRun>> parse_run_table(std::string_view text, std::string_view source);
// None where there is no file.
Result<std::vector<ComparedRun>> load_run_table(const std::filesystem::path& path);

}  // namespace cambrian
