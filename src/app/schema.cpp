#include "app/builtin_kinds.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "persist/creature/creature_schema.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

class SchemaSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("--dimensions", dimensions_,
                       "Dimensions of the creatures: 2 (version 3 of the format) or 3 (version 4)")
            ->check(CLI::IsMember({2, 3}))
            ->capture_default_str();
    }
    ExitStatus run(const EvolutionKinds& /*kinds*/) override {
        return print_result(creature_schema(builtin_kinds(dimensions_)));
    }

private:
    int dimensions_ = 2;
};

}  // namespace

SubcommandKind schema_subcommand() {
    return {.id = "schema",
            .summary = "Write the rules of creature files as a JSON Schema.",
            .example = "cambrian schema > creature-3.schema.json",
            .make = make_subcommand<SchemaSubcommand>};
}

}  // namespace cambrian
