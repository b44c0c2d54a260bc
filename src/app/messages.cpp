#include "app/messages.h"

#include "core/output_stream.h"

#include <cstdio>

namespace cambrian {

void say(std::string_view message) {
    std::fprintf(stderr, "cambrian: %.*s\n", static_cast<int>(message.size()), message.data());
}

void say_of(const std::string& file, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        std::fprintf(stderr, "cambrian: %s: %s\n", file.c_str(), warning.c_str());
}

ExitStatus fail(const Error& error, ExitStatus status) {
    say(error.message);
    return status;
}

Status print(std::string_view text) {
    OutputStream output = OutputStream::standard_output();
    if (Status written = output.write(text); !written) return written;
    return output.finish();
}

Status print_line(std::string_view line) {
    return print(std::string(line) + "\n");
}

ExitStatus print_result(std::string_view text) {
    const Status printed = print(text);
    return printed ? ExitStatus::kDone : fail(printed.error(), ExitStatus::kFailed);
}

ExitStatus print_result_line(std::string_view line) {
    return print_result(std::string(line) + "\n");
}

}  // namespace cambrian
