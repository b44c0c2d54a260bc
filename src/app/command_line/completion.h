#pragma once

#include "app/command_line/command_tree.h"

#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// A shell for which a completion script can be written.
struct CompletionShell {
    std::string_view name;
    std::string (*script)(const Command& program) = nullptr;
};

std::string bash_completion(const Command& program);
std::string zsh_completion(const Command& program);
std::string fish_completion(const Command& program);

inline constexpr CompletionShell kCompletionShells[] = {
    {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};

}  // namespace cambrian
