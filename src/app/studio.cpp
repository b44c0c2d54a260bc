#include "studio/studio.h"

#include "app/builtin_kinds.h"
#include "app/cluster/cluster_options.h"
#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/priority_option.h"
#include "app/command_line/window_options.h"
#include "app/evolve/without_window.h"
#include "app/page/page_making.h"
#include "app/process/assets_folder.h"
#include "app/process/interruption.h"
#include "app/subcommands/subcommands.h"
#include "cluster/join_cluster.h"
#include "studio/preferences.h"

#include <CLI/CLI.hpp>

#include <cstdlib>

namespace cambrian {
namespace {

// Returns the folder for state kept between runs (XDG base directories); empty if there is none.
std::filesystem::path usual_state_dir() {
    // Called before any thread starts.
    const char* state = std::getenv("XDG_STATE_HOME");  // NOLINT(concurrency-mt-unsafe)
    if (state != nullptr && *state == '/') return std::filesystem::path(state) / "cambrian";
    const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe)
    if (home == nullptr || *home != '/') return {};
    return std::filesystem::path(home) / ".local/state/cambrian";
}

// Makes the back-end of a cluster. Jobs that the same folder's studio left in the cluster are
// deleted. A genome that crashes a process is written to that folder.
ClusterJoining joining(const EvolutionKinds& kinds, const std::filesystem::path& state_dir) {
    const std::filesystem::path experiment =
        state_dir.empty() ? std::filesystem::path() : own_experiment(state_dir);
    return [&kinds, experiment](
               const ClusterAddress& address,
               const ThreadShare& threads) -> Result<std::shared_ptr<EvaluationBackend>> {
        auto backend = join_cluster(kinds, address, {.threads = threads, .experiment = experiment});
        if (!backend) return backend.error();
        return std::shared_ptr<EvaluationBackend>(*std::move(backend));
    };
}

class StudioSubcommand final : public Subcommand {
public:
    StudioSubcommand() {
        options_.state_dir = usual_state_dir();
        options_.assets = assets_folder();
        options_.page_parts = page_parts();
    }
    void add_options(CLI::App& app) override {
        app.add_option("file", options_.open_file,
                       "Creature file, card, settings file or experiment file to open")
            ->type_name(option_type::kAnyOfOurs);
        app.add_flag("--evolve", options_.evolve, "Evolution begins when the window opens");
        take_whole(
            *app.add_option("-t,--threads", options_.machines.threads.workers,
                            "Number of threads that evaluate creatures; one per core by default"),
            1, 1024);
        add_priority(app, options_.machines.threads.priority);
        add_cluster_choice(app, cluster_);
        add_window_options(app, options_);
        app.add_option("--state-dir", options_.state_dir,
                       "Folder that keeps the state from one start to the next, \"\" for none; "
                       "$XDG_STATE_HOME/cambrian or ~/.local/state/cambrian by default")
            ->type_name(option_type::kFolder);
        without_window_.add_options(app);
    }
    CommandFiles files() const override {
        CommandFiles files =
            window_files(options_).reads(options_.open_file).reads(without_window_.settings_file());
        add_login_files(files, cluster_);
        return files;
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (!cluster_.servers.empty()) options_.machines.cluster = cluster_;
        const EvolutionKinds plane = builtin_kinds(2);
        const EvolutionKinds space = builtin_kinds(3);
        options_.machines.join = joining(plane, options_.state_dir);
        const Status shown = show(plane, space);
        return shown ? ExitStatus::kDone : without_window_.run(shown.error(), kinds);
    }

private:
    // Ctrl+C and termination requests close the window.
    Status show(const EvolutionKinds& plane, const EvolutionKinds& space) {
        const Interruption interruption;
        options_.end = interruption.token();
        return run_studio(options_, plane, space);
    }

    ClusterLogin cluster_;
    StudioOptions options_;
    WithoutWindow without_window_;
};

}  // namespace

SubcommandKind studio_subcommand() {
    return {.id = "studio",
            .summary = "Open the studio: watch, steer and pick while creatures evolve.",
            .example = "cambrian studio champion-walking-seed7.creature.json",
            .make = make_subcommand<StudioSubcommand>};
}

}  // namespace cambrian
