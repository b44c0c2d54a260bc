#include "app/command_line/completion.h"

#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>

namespace cambrian {
namespace {

class CompletionSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        std::vector<std::string> names;
        for (const CompletionShell& shell : kCompletionShells)
            names.emplace_back(shell.name);
        app.add_option("shell", shell_, "Name of the shell")
            ->required()
            ->check(CLI::IsMember(names));
    }
    ExitStatus run(const EvolutionKinds& /*kinds*/) override {
        const auto* shell = std::find_if(std::begin(kCompletionShells), std::end(kCompletionShells),
                                         [this](const auto& each) { return each.name == shell_; });
        return print_result(shell->script(command_tree()));
    }

private:
    std::string shell_;
};

}  // namespace

SubcommandKind completion_subcommand() {
    return {
        .id = "completion",
        .summary = "Write the completion of this command line for a shell.",
        .example = "cambrian completion bash > ~/.local/share/bash-completion/completions/cambrian",
        .make = make_subcommand<CompletionSubcommand>};
}

}  // namespace cambrian
