#include "evolution/fields/setting_table.h"
#include "evolution/individual/map_axis.h"

#include <algorithm>

namespace cambrian::setting_table {
namespace {

std::vector<std::string> axis_ids() {
    std::vector<std::string> ids;
    for (const MapAxis& axis : map_axes())
        ids.emplace_back(axis.id);
    return ids;
}

bool everybody_breeds(const Settings& settings) {
    const std::string& method = settings.selection.method;
    return method == "roulette" || (method == "tournament" && settings.selection.tournament_of_all);
}

// Returns a condition that is true while one of these methods is selected.
auto with_method(std::vector<std::string> methods) {
    return [methods = std::move(methods)](const Settings& settings) {
        return std::find(methods.begin(), methods.end(), settings.selection.method) !=
               methods.end();
    };
}

void add_truncation(TableBuilder& selection) {
    selection
        .number(
            "survival", "Survivors", "", Range{0.01, 1},
            "Share of a generation that survives and breeds; smaller is harsher.",
            [](Settings & s) -> auto& { return s.population.survival; })
        .applies = [](const Settings& settings) {
        return with_method({"truncation", "rank", "tournament"})(settings) &&
               !everybody_breeds(settings);
    };
    selection
        .number(
            "max-clones", "Clones kept", "", Range{1, 1000},
            "Creatures with the same body and live brain that may survive together.",
            [](Settings & s) -> auto& { return s.population.max_clones; })
        .applies = with_method({"truncation", "rank", "tournament", "roulette"});
    const auto truncates = [](const Settings& settings) {
        return with_method({"truncation", "rank", "tournament"})(settings) &&
               !everybody_breeds(settings);
    };
    selection
        .number(
            "line-share", "Share of a line", "", Range{0.01, 1},
            "Share of the survivors that may descend from one founder, by mothers; 1 for no limit.",
            [](Settings & s) -> auto& { return s.selection.line_share; })
        .applies = truncates;
    selection
        .number(
            "plan-copies", "Copies of a body plan", "creatures", Range{0, 20000},
            "Survivors whose parts and joints form the same tree; 0 for no limit.",
            [](Settings & s) -> auto& { return s.selection.plan_copies; })
        .applies = truncates;
}

void add_confirmation(TableBuilder& selection) {
    selection.number(
        "confirmations", "Confirming trials", "", Range{0, 20},
        "Worlds a hair different in which whoever would survive is tried again; its score is then "
        "the median of all.",
        [](Settings & s) -> auto& { return s.selection.confirmations; });
    selection
        .number(
            "confirm-jitter", "Confirming changes", "", Range{0, 0.2},
            "Share by which gravity, friction and drag of these worlds differ at most, and rad by "
            "which the start pose does.",
            [](Settings & s) -> auto& { return s.selection.confirm_jitter; })
        .applies = [](const Settings& settings) { return settings.selection.confirmations > 0; };
}

void add_tournament(TableBuilder& selection) {
    selection
        .number(
            "tournament-size", "Tournament size", "creatures", Range{1, 100},
            "Contestants of a tournament; more are harsher.",
            [](Settings & s) -> auto& { return s.selection.tournament_size; })
        .applies = with_method({"tournament"});
    selection
        .flag(
            "tournament-of-all", "Tournaments of all",
            "Contestants come from all of the generation instead of its survivors.",
            [](Settings & s) -> auto& { return s.selection.tournament_of_all; })
        .applies = with_method({"tournament"});
    selection
        .number(
            "elites", "Elites", "creatures", Range{1, 1000},
            "The best that survive where everybody may breed.",
            [](Settings & s) -> auto& { return s.selection.elites; })
        .applies = everybody_breeds;
}

void add_map(TableBuilder& selection) {
    const auto axis = [&](const char* key, const char* label, const char* help, auto at) {
        selection.choice(key, label, axis_ids(), help, at).applies = with_method({"map-elites"});
    };
    axis(
        "map-across", "Map, across", "What kinds of creatures differ in, one of two.",
        [](Settings & s) -> auto& { return s.selection.map_across; });
    axis(
        "map-up", "Map, up", "What kinds of creatures differ in, the other of two.",
        [](Settings & s) -> auto& { return s.selection.map_up; });
}

void add_novelty(TableBuilder& selection) {
    selection
        .number(
            "novelty-neighbors", "Neighbors", "creatures", Range{1, 1000},
            "The most similar creatures that novelty is measured against.",
            [](Settings & s) -> auto& { return s.selection.novelty_neighbors; })
        .applies = with_method({"novelty"});
    selection
        .number(
            "novelty-threshold", "Novelty to be kept", "", Range{1e-3, 100},
            "Distance from others, in standard deviations, from which a creature is remembered as "
            "novel; only where it begins, since it adapts.",
            [](Settings & s) -> auto& { return s.selection.novelty_threshold; })
        .applies = with_method({"novelty"});
}

}  // namespace

void add_selection(std::vector<SettingField>& fields, const EvolutionKinds& kinds) {
    TableBuilder selection(fields, "selection");
    selection.choice(
        "method", "Method", ids_of(kinds.selections), "Who survives and who breeds how often.",
        [](Settings & s) -> auto& { return s.selection.method; });
    add_truncation(selection);
    add_confirmation(selection);
    add_tournament(selection);
    add_map(selection);
    add_novelty(selection);
}

}  // namespace cambrian::setting_table
