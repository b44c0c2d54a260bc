#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "persist/creature/creature_schema.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

class SchemaSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& /*app*/) override {}
    ExitStatus run(const EvolutionKinds& kinds) override {
        return print_result(creature_schema(kinds));
    }
};

}  // namespace

SubcommandKind schema_subcommand() {
    return {.id = "schema",
            .summary = "Write the rules of creature files as a JSON Schema.",
            .example = "cambrian schema > creature-3.schema.json",
            .make = make_subcommand<SchemaSubcommand>};
}

}  // namespace cambrian
