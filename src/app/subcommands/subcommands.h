#pragma once

#include "app/command_line/subcommand.h"

namespace cambrian {

SubcommandKind challenge_subcommand();
SubcommandKind cluster_subcommand();
SubcommandKind compare_subcommand();
SubcommandKind completion_subcommand();
SubcommandKind evolve_subcommand();
SubcommandKind export_subcommand();
SubcommandKind film_subcommand();
SubcommandKind manual_subcommand();
SubcommandKind page_subcommand();
SubcommandKind preserve_subcommand();
SubcommandKind race_subcommand();
SubcommandKind render_subcommand();
SubcommandKind rescore_subcommand();
SubcommandKind lesion_subcommand();
SubcommandKind lift_subcommand();
SubcommandKind schema_subcommand();
SubcommandKind settings_subcommand();
SubcommandKind simulate_subcommand();
SubcommandKind studio_subcommand();
SubcommandKind terrain_subcommand();
SubcommandKind verify_subcommand();
SubcommandKind view_subcommand();
SubcommandKind worker_subcommand();

}  // namespace cambrian
