// Replaces the subcommands that draw in a program built without its window.
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

class MissingPictures final : public Subcommand {
public:
    void add_options(CLI::App& app) override { app.allow_extras(); }
    ExitStatus run(const EvolutionKinds& /*kinds*/) override {
        return fail({"this program was built without its window and pictures "
                     "(CAMBRIAN_BUILD_STUDIO=OFF); `cambrian simulate CREATURE` works without "
                     "them"},
                    ExitStatus::kFailed);
    }
};

std::unique_ptr<Subcommand> make_missing() {
    return std::make_unique<MissingPictures>();
}

}  // namespace

SubcommandKind render_subcommand() {
    return {.id = "render",
            .summary = "Make a picture, clip or card; this program was built without it.",
            .example = "cambrian render champion-walking-seed7.creature.json -o clip.mp4",
            .make = make_missing};
}

SubcommandKind film_subcommand() {
    return {.id = "film",
            .summary = "Make a film of a run; this program was built without it.",
            .example = "cambrian film walking-seed1.cambrian -o film.mp4",
            .make = make_missing};
}

SubcommandKind race_subcommand() {
    return {.id = "race",
            .summary = "Make a clip of a race; this program was built without it.",
            .example = "cambrian race a.creature.json b.creature.json -o race.mp4",
            .make = make_missing};
}

SubcommandKind view_subcommand() {
    return {.id = "view",
            .summary = "Watch one creature; this program was built without it.",
            .example = "cambrian view champion-walking-seed7.creature.json",
            .make = make_missing};
}

}  // namespace cambrian
