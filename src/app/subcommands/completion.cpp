#include "app/completion.h"

#include "app/subcommands/subcommands.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace cambrian {
namespace {

class CompletionSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        std::vector<std::string> names;
        for (const CompletionShell& shell : kCompletionShells)
            names.emplace_back(shell.name);
        app.add_option("shell", shell_, "The shell to write for")
            ->required()
            ->check(CLI::IsMember(names));
    }
    ExitStatus run(const EvolutionKinds& /*kinds*/) override {
        for (const CompletionShell& shell : kCompletionShells) {
            if (shell.name == shell_) std::fputs(shell.script(command_tree()).c_str(), stdout);
        }
        return ExitStatus::kDone;
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
        .make = []() -> std::unique_ptr<Subcommand> {
            return std::make_unique<CompletionSubcommand>();
        }};
}

}  // namespace cambrian
