#include "app/command_line/command_files.h"

#include "core/files/database_companions.h"
#include "core/files/file_errors.h"
#include "core/files/file_identity.h"
#include "core/files/file_io.h"
#include "core/files/file_lock.h"
#include "core/files/output_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace cambrian {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExperimentEnding = ".cambrian";

// Compares the files that the paths lead to or, if they do not exist, the paths.
bool is_same_file(const fs::path& one, const fs::path& other) {
    struct stat first {};
    struct stat second {};
    if (::stat(one.c_str(), &first) == 0 && ::stat(other.c_str(), &second) == 0)
        return identity_of(first) == identity_of(second) && S_ISREG(first.st_mode);
    std::error_code unknown;
    return fs::weakly_canonical(one, unknown) == fs::weakly_canonical(other, unknown) && !unknown;
}

bool is_standard_output(const fs::path& path) {
    struct stat output {};
    struct stat file {};
    return ::fstat(STDOUT_FILENO, &output) == 0 && S_ISREG(output.st_mode) &&
           ::stat(path.c_str(), &file) == 0 && identity_of(output) == identity_of(file);
}

bool belongs_to_experiment(const fs::path& path) {
    const std::string name = path.filename().string();
    return std::any_of(kDatabaseCompanions.begin(), kDatabaseCompanions.end(),
                       [&name](std::string_view ending) {
                           return name.ends_with(std::string(kExperimentEnding).append(ending));
                       });
}

void add(std::vector<fs::path>& paths, const std::string& path) {
    std::error_code unknown;
    if (!path.empty() && path.back() != '/' && !fs::is_directory(path, unknown))
        paths.emplace_back(path);
}

Status check_there(const fs::path& path) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) == 0) return {};
    return Error{
        fmt::format("cannot open {}: {}", path.string(), std::generic_category().message(errno))};
}

// Checks a file that is appended to: it must be writable or, if new, its folder must be.
Status check_log(const fs::path& path) {
    if (::access(path.c_str(), W_OK) == 0) return {};
    if (errno != ENOENT) return write_outcome(path, errno);
    return check_writable(path);
}

Status check_folder_name(const fs::path& path) {
    constexpr std::array<std::string_view, 10> kEndings = {
        ".cambrian", ".json", ".toml", ".csv", ".png", ".mp4", ".gif", ".apng", ".html", ".md"};
    std::error_code unknown;
    const std::string ending = path.extension().string();
    const bool like_file = std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
    if (!like_file || fs::is_directory(path, unknown)) return {};
    return cannot_write(
        path, fmt::format("it will be a folder; {}/ makes one of that name", path.string()));
}

// Fails if another process of this program is writing the file.
Status check_free(const fs::path& path) {
    const Result<OutputTarget> target = output_target(path);
    if (!target) return target.error();
    if (target->kind != OutputTarget::Kind::kFile) return {};
    const Status free = FileLock::check_free(target->path);
    return free ? Status() : Status(cannot_write(path, free.error().message));
}

}  // namespace

bool is_experiment_name(const fs::path& path) {
    return path.extension() == kExperimentEnding;
}

Status check_ending(const fs::path& path, const OutputForm& form) {
    const std::string name = path.filename().string();
    const bool fits =
        std::any_of(form.endings.begin(), form.endings.end(), [&](std::string_view ending) {
            return name.size() > ending.size() && name.ends_with(ending);
        });
    // A target that is none is reported by those who open it.
    const Result<OutputTarget> target = output_target(path);
    if (fits || name.empty() || !target || target->kind != OutputTarget::Kind::kFile) return {};
    // The ending of experiments has a message of its own.
    if (is_experiment_name(path)) return {};
    const auto last = form.endings.end() - 1;
    std::string endings = fmt::format("{}", fmt::join(form.endings.begin(), last, ", "));
    if (!endings.empty()) endings += " or ";
    return cannot_write(path, fmt::format("it will be {}; expected a name that ends in {}{}",
                                          form.what, endings, *last));
}

CommandFiles& CommandFiles::reads(const std::string& path) {
    add(inputs_, path);
    add(required_, path);
    return *this;
}

CommandFiles& CommandFiles::reads_each(const std::vector<std::string>& paths) {
    for (const std::string& path : paths)
        add(inputs_, path);
    return *this;
}

CommandFiles& CommandFiles::writes(const std::string& path) {
    add(outputs_, path);
    return *this;
}

CommandFiles& CommandFiles::writes(const std::string& path, const OutputForm& form) {
    if (!path.empty()) named_.push_back({path, form});
    return writes(path);
}

CommandFiles& CommandFiles::appends(const std::string& path, const OutputForm& form) {
    if (!path.empty()) named_.push_back({path, form});
    return appends(path);
}

CommandFiles& CommandFiles::appends(const std::string& path) {
    add(logs_, path);
    return *this;
}

CommandFiles& CommandFiles::fills(const std::string& folder) {
    if (!folder.empty()) folders_.emplace_back(folder);
    return *this;
}

CommandFiles& CommandFiles::keeps(const std::string& path) {
    add(experiments_, path);
    return *this;
}

Status CommandFiles::check_inputs(const fs::path& output) const {
    for (const fs::path& input : inputs_) {
        if (is_same_file(input, output))
            return cannot_write(output, "it is read by the same command; name another file");
    }
    return {};
}

Status CommandFiles::check_output(const fs::path& path) const {
    if (is_experiment_name(path) || belongs_to_experiment(path))
        return cannot_write(path, "the ending .cambrian is reserved for experiments");
    if (Status other = check_inputs(path); !other) return other;
    return check_free(path);
}

// Checks the outputs against the inputs and against one another.
Status CommandFiles::check_outputs(const std::vector<fs::path>& outputs) const {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (Status possible = check_output(outputs[i]); !possible) return possible;
        for (std::size_t other = 0; other < i; ++other) {
            if (is_same_file(outputs[i], outputs[other]))
                return cannot_write(outputs[i], "the same command writes something else to it");
        }
    }
    return {};
}

Status CommandFiles::check() const {
    for (const fs::path& input : required_) {
        if (Status there = check_there(input); !there) return there;
    }
    for (const fs::path& input : inputs_) {
        if (is_standard_output(input))
            return Error{
                fmt::format("cannot write to standard output: it leads to {}, which is read by the "
                            "same command",
                            input.string())};
    }
    for (const fs::path& experiment : experiments_) {
        if (Status other = check_inputs(experiment); !other) return other;
    }
    std::vector<fs::path> outputs = outputs_;
    outputs.insert(outputs.end(), logs_.begin(), logs_.end());
    if (Status apart = check_outputs(outputs); !apart) return apart;
    for (const fs::path& log : logs_) {
        if (Status place = check_log(log); !place) return place;
    }
    for (const fs::path& output : outputs_) {
        if (Status writable = check_writable(output); !writable) return writable;
    }
    for (const fs::path& folder : folders_) {
        if (Status fits = check_folder_name(folder); !fits) return fits;
    }
    for (const Named& output : named_) {
        if (Status fits = check_ending(output.path, output.form); !fits) return fits;
    }
    return {};
}

}  // namespace cambrian
