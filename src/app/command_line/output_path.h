#pragma once

#include "app/command_line/command_files.h"
#include "core/result.h"

#include <filesystem>
#include <string>

namespace cambrian {

// Returns the path of a result: `asked` itself or, if that is a folder, `name` inside it. A folder
// may exist or end in '/' and is then created. Fails at once if no file can be written there, so
// that a long computation is not lost. `files` are the other files of the command, which must not
// be overwritten.
Result<std::filesystem::path> output_path(const std::string& asked, const std::string& name,
                                          const CommandFiles& files);

}  // namespace cambrian
