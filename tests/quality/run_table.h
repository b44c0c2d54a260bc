#pragma once

// Finished runs as CSV, one line each. An interrupted benchmark can thus be continued, and others
// can compute their own statistics.

#include "core/result.h"
#include "quality/run.h"

#include <filesystem>

namespace cambrian::quality {

std::string run_header();
std::string run_line(const RunResult& result);
std::string curve_header();
std::string curve_lines(const RunResult& result);

// Reads runs without curves. An incomplete line is left out, so that its run is repeated. A file
// that does not exist has no runs.
Result<std::vector<RunResult>> read_runs(const std::filesystem::path& path);

}  // namespace cambrian::quality
