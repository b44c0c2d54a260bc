#pragma once

// Finished runs as CSV, a line each, so that a benchmark that was interrupted can be finished, and
// anybody can do other statistics.

#include "core/result.h"
#include "quality/run.h"

#include <filesystem>

namespace cambrian::quality {

std::string run_header();
std::string run_line(const RunResult& result);
std::string curve_header();
std::string curve_lines(const RunResult& result);

// Reads runs without curves. An incomplete line is left out, so its run is done again. A file that
// does not exist has no lines.
Result<std::vector<RunResult>> read_runs(const std::filesystem::path& path);

}  // namespace cambrian::quality
