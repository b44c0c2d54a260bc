#include "evolution/fields/setting_table.h"
#include "evolution/settings/chance.h"

namespace cambrian::setting_table {
namespace {

bool several(const Settings& settings) {
    return settings.world.trial.trials > 1;
}

}  // namespace

void add_trials(TableBuilder& trial) {
    trial
        .flag(&TrialSettings::has_cube, "cube", "Cube",
              "A free cube lies on the ground. The creature starts beside it, across from an "
              "opponent if the goal is a competition.")
        .later = true;
    trial.number(&TrialSettings::trials, "trials", "Trials", "", Range{1, 50},
                 "The number of trials of each creature. The first is in the world as it is; "
                 "further ones have the changes below, the same for all creatures.");
    trial
        .number(&TrialSettings::friction_jitter, "friction-jitter", "Friction jitter", "",
                Range{0, 1}, "The largest relative change of the friction in further trials.")
        .applies = several;
    trial
        .number(&TrialSettings::tilt_jitter, "tilt-jitter", "Tilt jitter", "deg", Range{0, 90},
                "The largest angle by which the start pose of further trials is turned.")
        .applies = several;
    trial
        .choice(&TrialSettings::combine, "combine", "Score of trials",
                {kCombineIds.begin(), kCombineIds.end()},
                "The rule that makes one score of several trials. The minimum selects for robust "
                "creatures; \"worse half\" is 0.9 times the mean of the worse half and 0.1 times "
                "the mean of all, for choices between two ways.")
        .applies = several;
    SettingField& renewal = trial.number(
        &TrialSettings::renewal, "trials-renewed", "Renewal interval", "generations", Range{0, 1e6},
        "The number of generations after which the changes, the motions of the light and the "
        "walls are drawn again, for all creatures, and all scores are computed again. 0 means "
        "never.");
    renewal.later = true;
    renewal.applies = [](const Settings& settings) { return has_chance(settings.world); };
    SettingField& draw = trial.number(&TrialSettings::draw, "draw", "Renewals", "", Range{0, 1e6},
                                      "The number of times that the changes were drawn again so "
                                      "far. The run itself counts them.");
    draw.later = true;
    draw.live = false;
    draw.by_run = true;
    draw.applies = [](const Settings&) { return false; };
}

}  // namespace cambrian::setting_table
