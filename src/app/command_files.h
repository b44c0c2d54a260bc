#pragma once

// The files that one command reads and writes, so that it never writes onto what it reads, onto
// another of its outputs or onto an experiment.

#include "core/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace cambrian {

class CommandFiles {
public:
    // Paths as they were typed; empty ones and folders do not count.
    CommandFiles& reads(const std::string& path);
    // Files that the command takes one by one: one that is missing leaves the others to it.
    CommandFiles& reads_each(const std::vector<std::string>& paths);
    CommandFiles& writes(const std::string& path);
    // Written where it is, not replaced.
    CommandFiles& appends(const std::string& path);
    // An experiment file that is made.
    CommandFiles& keeps(const std::string& path);

    // Whether all of them, and standard output, can be used, also together. The message names the
    // file.
    Status check() const;
    // The same for an output whose name was found out later.
    Status check_output(const std::filesystem::path& path) const;

private:
    Status check_inputs(const std::filesystem::path& output) const;
    Status check_outputs(const std::vector<std::filesystem::path>& outputs) const;

    std::vector<std::filesystem::path> inputs_;
    std::vector<std::filesystem::path> required_;  // among the inputs
    std::vector<std::filesystem::path> outputs_;
    std::vector<std::filesystem::path> logs_;
    std::vector<std::filesystem::path> experiments_;
};

// Whether a name is that of an experiment file (*.cambrian).
bool is_experiment_name(const std::filesystem::path& path);

}  // namespace cambrian
