#include "evolution/fields/setting_table.h"

namespace cambrian::setting_table {
namespace {

bool several(const Settings& settings) {
    return settings.world.trial.trials > 1;
}

}  // namespace

void add_trials(TableBuilder& trial) {
    trial.number(
        "trials", "Trials", "", Range{1, 50},
        "Trials of each creature: the first in the world as it is, further ones with the changes "
        "below, the same for everyone.",
        [](Settings & s) -> auto& { return s.world.trial.trials; });
    trial
        .number(
            "friction-jitter", "Friction, more or less", "", Range{0, 1},
            "Share of the friction by which further trials differ at most.",
            [](Settings & s) -> auto& { return s.world.trial.friction_jitter; })
        .applies = several;
    trial
        .number(
            "tilt-jitter", "Start tilt", "deg", Range{0, 90},
            "Angle by which the start pose of further trials is turned at most.",
            [](Settings & s) -> auto& { return s.world.trial.tilt_jitter; })
        .applies = several;
    trial
        .choice(
            "combine", "Score of trials", {"mean", "minimum"},
            "What the scores of several trials come to; the minimum asks for robust creatures.",
            [](Settings & s) -> auto& { return s.world.trial.combine; })
        .applies = several;
}

}  // namespace cambrian::setting_table
