#pragma once

// The files that a command reads and writes. It checks that no output would overwrite an input,
// another output or an experiment.

#include "core/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace cambrian {

class CommandFiles {
public:
    // Paths as typed; empty ones and folders do not count.
    CommandFiles& reads(const std::string& path);
    // Files that the command reads one by one; it reports a missing one itself and continues.
    CommandFiles& reads_each(const std::vector<std::string>& paths);
    CommandFiles& writes(const std::string& path);
    // A file to which the command appends.
    CommandFiles& appends(const std::string& path);
    // An experiment file that the command creates.
    CommandFiles& keeps(const std::string& path);

    // Checks that all files and standard output can be used together. The message names the file at
    // fault.
    Status check() const;
    // Checks an output whose name becomes known later.
    Status check_output(const std::filesystem::path& path) const;

private:
    Status check_inputs(const std::filesystem::path& output) const;
    Status check_outputs(const std::vector<std::filesystem::path>& outputs) const;

    std::vector<std::filesystem::path> inputs_;
    std::vector<std::filesystem::path> required_;  // inputs that must exist
    std::vector<std::filesystem::path> outputs_;
    std::vector<std::filesystem::path> logs_;
    std::vector<std::filesystem::path> experiments_;
};

// Returns whether a path names an experiment file (*.cambrian).
bool is_experiment_name(const std::filesystem::path& path);

}  // namespace cambrian
