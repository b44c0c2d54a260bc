#include "evolution/fields/setting_table.h"

namespace cambrian::setting_table {
namespace {

using Applies = SelectionRows::Applies;

// Returns a condition that is true while the selected method has that rule of survival.
Applies survival_is(const SelectionRegistry& selections, SurvivalRule rule) {
    return [&selections, rule](const Settings& settings) {
        const SelectionKind* kind = selections.find(settings.selection.method);
        return kind != nullptr && kind->survival_under(settings.selection) == rule;
    };
}

void add_survival(TableBuilder& selection, const SelectionRegistry& selections) {
    const Applies best_share = survival_is(selections, SurvivalRule::kBestShare);
    const Applies own_rule = survival_is(selections, SurvivalRule::kOwn);
    selection
        .number(&PopulationSettings::survival, "survival", "Survivors", "", Range{0.01, 1},
                "The share of a generation that survives and breeds. A smaller share is a stronger "
                "selection.")
        .applies = best_share;
    selection
        .number(&PopulationSettings::max_clones, "max-clones", "Clones at most", "", Range{1, 1000},
                "The largest number of survivors with the same body and live brain.")
        .applies = [own_rule](const Settings& settings) { return !own_rule(settings); };
    selection
        .number(&SelectionSettings::line_share, "line-share", "Share of a lineage", "",
                Range{0.01, 1},
                "The largest share of the survivors that may descend from one founder through "
                "mothers. 1 means no limit.")
        .applies = best_share;
    selection
        .number(&SelectionSettings::plan_copies, "plan-copies", "Copies of a body plan",
                "creatures", Range{0, 20000},
                "The largest number of survivors whose parts and joints form the same tree. 0 "
                "means no limit.")
        .applies = best_share;
}

void add_confirmation(TableBuilder& selection) {
    selection.number(&SelectionSettings::confirmations, "confirmations", "Confirming trials", "",
                     Range{0, 20},
                     "The number of slightly different worlds in which creatures that would "
                     "survive are tried again. Their score is then the median of all trials.");
    const auto confirms = [](const Settings& settings) {
        return settings.selection.confirmations > 0;
    };
    selection
        .number(&SelectionSettings::confirm_jitter, "confirm-jitter", "Confirmation jitter", "",
                Range{0, 0.2},
                "The largest relative change of gravity, friction and drag in these worlds, and "
                "the largest change of the start pose in rad.")
        .applies = confirms;
    SettingField& tilt = selection.number(
        &SelectionSettings::confirm_tilt, "confirm-tilt", "Confirmation tilt", "deg", Range{0, 30},
        "The largest slope of the ground in these worlds, to one side in the "
        "first half of the trial and to the other in the second.");
    tilt.later = true;
    tilt.applies = confirms;
}

void add_own_settings(TableBuilder& selection, const SelectionRegistry& selections) {
    const Applies elites_only = survival_is(selections, SurvivalRule::kElitesOnly);
    for (const SelectionKind& kind : selections.all()) {
        if (kind.add_settings == nullptr) continue;
        SelectionRows rows{
            selection,
            [id = kind.id](const Settings& settings) { return settings.selection.method == id; },
            elites_only};
        kind.add_settings(rows);
    }
}

}  // namespace

void add_selection(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder selection(fields, "selection");
    selection.kind_choice(
        &SelectionSettings::method, "method", "Method", kinds.selections.all(),
        "The rule that decides which creatures survive and how often they breed.");
    add_survival(selection, kinds.selections);
    add_confirmation(selection);
    add_own_settings(selection, kinds.selections);
}

}  // namespace cambrian::setting_table
