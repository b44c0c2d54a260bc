#include "app/command_line/subcommand.h"
#include "app/subcommands/subcommands.h"

namespace cambrian {

SubcommandRegistry builtin_subcommands() {
    SubcommandRegistry subcommands;
    subcommands.add(studio_subcommand());
    subcommands.add(view_subcommand());
    subcommands.add(evolve_subcommand());
    subcommands.add(compare_subcommand());
    subcommands.add(challenge_subcommand());
    subcommands.add(preserve_subcommand());
    subcommands.add(worker_subcommand());
    subcommands.add(cluster_subcommand());
    subcommands.add(export_subcommand());
    subcommands.add(simulate_subcommand());
    subcommands.add(lesion_subcommand());
    subcommands.add(render_subcommand());
    subcommands.add(film_subcommand());
    subcommands.add(race_subcommand());
    subcommands.add(page_subcommand());
    subcommands.add(verify_subcommand());
    subcommands.add(rescore_subcommand());
    subcommands.add(lift_subcommand());
    subcommands.add(settings_subcommand());
    subcommands.add(terrain_subcommand());
    subcommands.add(schema_subcommand());
    subcommands.add(manual_subcommand());
    subcommands.add(completion_subcommand());
    return subcommands;
}

}  // namespace cambrian
