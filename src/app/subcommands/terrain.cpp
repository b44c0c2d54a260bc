#include "world/terrain.h"

#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "core/files/file_io.h"
#include "core/text/number_text.h"
#include "persist/settings/ground_import.h"
#include "persist/settings/settings_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr std::size_t kMostGroundBytes = 4'000'000;
constexpr double kListedGround = 64.0;  // m, to both sides

// Returns the ground's points as lines "x,y".
std::string point_table(const Terrain& ground) {
    std::vector<GroundPoint> points;
    ground.list_points(-kListedGround, kListedGround, points);
    std::string table;
    for (const GroundPoint& point : points)
        table += fmt::format("{},{}\n", short_text(point.x), short_text(point.y));
    return table;
}

class TerrainSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("settings", file_, "Settings file whose ground is listed")
            ->type_name(option_type::kSettings);
        app.add_option(
               "--import", world_,
               "World of EvoGym (*.json) or points (*.csv, lines x,y in m) to make settings "
               "of")
            ->type_name("FILE.json|FILE.csv")
            ->excludes("settings");
        app.add_option("--voxel", voxel_, "Size of a voxel of EvoGym's, in m")
            ->check(CLI::Range(0.05, 10.0))
            ->capture_default_str();
        app.add_flag("--ignore-loose", ignore_loose_,
                     "Leave out voxels that move or lie above air");
        app.add_option("-o,--out", out_,
                       "File to write: points (*.csv), or settings of an import (*.toml); standard "
                       "output by default")
            ->type_name("FILE.csv|FILE.toml");
    }
    CommandFiles files() const override {
        return CommandFiles().reads(file_).reads(world_).writes(out_);
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (file_.empty() == world_.empty())
            return fail(Error{"terrain: expected a settings file or --import"});
        const Result<std::string> text = world_.empty() ? listed(kinds) : imported(kinds);
        if (!text) return fail(text.error());
        if (out_.empty()) return print_result(*text);
        const auto path = output_path(out_, world_.empty() ? "ground.csv" : "ground.toml", files());
        if (!path) return fail(path.error());
        const Status written = write_file(*path, *text);
        return written ? ExitStatus::kDone : fail(written.error(), ExitStatus::kFailed);
    }

private:
    Result<std::string> listed(const EvolutionKinds& kinds) const {
        const auto settings = load_settings(file_, kinds);
        if (!settings) return settings.error();
        const auto ground = Terrain::make(settings->world.environment.terrain);
        if (!ground) return Error{file_ + ": " + ground.error().message};
        if (*ground == nullptr) return Error{file_ + ": the ground is flat"};
        return point_table(**ground);
    }
    Result<std::string> imported(const EvolutionKinds& kinds) const {
        const auto bytes = read_file(world_, kMostGroundBytes);
        if (!bytes) return bytes.error();
        const LooseVoxels loose = ignore_loose_ ? LooseVoxels::kDropped : LooseVoxels::kRefused;
        const auto points = world_.ends_with(".csv") ? ground_of_table(*bytes)
                                                     : ground_of_voxels(*bytes, voxel_, loose);
        if (!points) return Error{world_ + ": " + points.error().message};
        ExperimentSettings settings = default_settings("walking", kinds);
        settings.world.environment.terrain.kind = "drawn";
        settings.world.environment.terrain.points = *points;
        return write_settings(settings, kinds);
    }

    std::string file_;
    std::string world_;
    double voxel_ = kVoxelSize;
    bool ignore_loose_ = false;
    std::string out_;
};

}  // namespace

SubcommandKind terrain_subcommand() {
    return {.id = "terrain",
            .summary = "List the points of settings' ground, or make settings of ground of others.",
            .example = "cambrian terrain --import UpStepper-v0.json --out upstepper.toml",
            .make = make_subcommand<TerrainSubcommand>};
}

}  // namespace cambrian
