#include "evolution/fields/setting_table.h"

namespace cambrian::setting_table {
namespace {

bool several(const Settings& settings) {
    return settings.world.trial.trials > 1;
}

bool depends_on_chance(const Settings& settings) {
    const Environment& world = settings.world.environment;
    return several(settings) || (world.has_light && world.light_motion != "still");
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
    SettingField& renewal = trial.number(
        "trials-renewed", "Renewed every", "generations", Range{0, 1e6},
        "Generations after which changes and ways of the light are drawn again, for everyone, and "
        "all scores computed again; 0 for never.",
        [](Settings & s) -> auto& { return s.world.trial.renewal; });
    renewal.later = true;
    renewal.applies = depends_on_chance;
    SettingField& draw = trial.number(
        "draw", "Times renewed", "", Range{0, 1e6},
        "How often these were drawn again so far; the run itself counts on.",
        [](Settings & s) -> auto& { return s.world.trial.draw; });
    draw.later = true;
    draw.live = false;
    draw.by_run = true;
    draw.applies = [](const Settings&) { return false; };
}

}  // namespace cambrian::setting_table
