#include "app/command_line/output_path.h"

#include "core/files/file_io.h"

#include <fmt/core.h>

#include <system_error>

namespace cambrian {

Result<std::filesystem::path> output_path(const std::string& asked, const std::string& name,
                                          const CommandFiles& files) {
    std::filesystem::path path = asked.empty() ? name : asked;
    std::error_code failure;
    if (!asked.empty() && asked.back() == '/') {
        std::filesystem::create_directories(path, failure);
        if (failure)
            return Error{fmt::format("cannot make the folder {}: {}", asked, failure.message())};
    }
    if (std::filesystem::is_directory(path, failure)) path /= name;
    if (const Status other = files.check_output(path); !other) return other.error();
    if (const Status writable = check_writable(path); !writable) return writable.error();
    return path;
}

}  // namespace cambrian
