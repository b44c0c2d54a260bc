#include "app/process/messages.h"

#include "core/files/output_stream.h"
#include "core/text/shown_text.h"

#include <fmt/core.h>

#include <cstdio>

namespace cambrian {

void say(std::string_view message) {
    std::fprintf(stderr, "cambrian: %s\n", shown_lines(message).c_str());
}

void say_of(const std::string& file, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        say(fmt::format("{}: {}", file, warning));
}

ExitStatus fail(const Error& error, ExitStatus status) {
    say(error.message);
    return status;
}

Status print(std::string_view text) {
    OutputStream output = OutputStream::standard_output();
    if (Status written = output.write(shown_lines(text)); !written) return written;
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
