#pragma once

// The files that a command reads and writes. It checks that no output would overwrite an input,
// another output or an experiment.

#include "core/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// A form of output, and the endings that its file's name may have; the first is the usual
// one.
struct OutputForm {
    std::string_view what;  // "a creature"
    std::vector<std::string_view> endings;
};

namespace output_form {
inline const OutputForm kCreature{"a creature", {".creature.json", ".json"}};
inline const OutputForm kTable{"a table", {".csv"}};
inline const OutputForm kSettings{"a settings file", {".toml"}};
inline const OutputForm kChallenge{"a challenge", {".challenge.toml"}};
inline const OutputForm kBoard{"a board", {".md", ".html"}};
inline const OutputForm kPage{"a page", {".html"}};
inline const OutputForm kPicture{"a picture", {".png"}};
inline const OutputForm kClip{"a clip", {".mp4", ".gif", ".apng"}};
inline const OutputForm kDrawing{"a picture, a clip or a page",
                                 {".png", ".mp4", ".gif", ".apng", ".html"}};
}  // namespace output_form

// Fails unless the name has an ending of the form. Folders and streams, such as /dev/stdout, may
// have any name.
Status check_ending(const std::filesystem::path& path, const OutputForm& form);

class CommandFiles {
public:
    // Paths as typed; empty ones and folders do not count.
    CommandFiles& reads(const std::string& path);
    // Files that the command reads one by one; it reports a missing one itself and continues.
    CommandFiles& reads_each(const std::vector<std::string>& paths);
    CommandFiles& writes(const std::string& path);
    // The name must fit what is written.
    CommandFiles& writes(const std::string& path, const OutputForm& form);
    // A file to which the command appends.
    CommandFiles& appends(const std::string& path);
    CommandFiles& appends(const std::string& path, const OutputForm& form);
    // A folder that the command makes unless it is there; its name must not look like a file's.
    CommandFiles& fills(const std::string& folder);
    // An experiment file that the command creates.
    CommandFiles& keeps(const std::string& path);

    const std::vector<std::filesystem::path>& inputs() const { return inputs_; }

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
    struct Named {
        std::filesystem::path path;
        OutputForm form;
    };
    std::vector<std::filesystem::path> folders_;
    std::vector<Named> named_;  // those of the outputs and logs whose names must fit
};

// Returns whether a path names an experiment file (*.cambrian).
bool is_experiment_name(const std::filesystem::path& path);

}  // namespace cambrian
