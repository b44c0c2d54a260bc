#include "app/command_line/priority_option.h"

#include <CLI/CLI.hpp>

#include <string>

namespace cambrian {
namespace {

constexpr const char* kBackground = "background";
constexpr const char* kNormal = "normal";

}  // namespace

void add_priority(CLI::App& app, ThreadPriority& priority) {
    priority = ThreadPriority::kBackground;
    app.add_option_function<std::string>(
           "--priority",
           [&priority](const std::string& name) {
               priority = name == kNormal ? ThreadPriority::kNormal : ThreadPriority::kBackground;
           },
           "Priority of the computation; 'background' yields to all other programs")
        ->check(CLI::IsMember({kBackground, kNormal}))
        ->default_str(kBackground);
}

}  // namespace cambrian
