#include "studio/panels/generations/population_panel.h"

#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"
#include "genome/creature_name.h"
#include "studio/frame/change_view.h"
#include "studio/frame/help_mark.h"
#include "studio/viewer/origin_words.h"
#include "studio/viewer/score_words.h"
#include "studio/widgets/creature_tile.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kCreatureWidth = 74.0F;   // at least
constexpr float kCreatureHeight = 78.0F;  // about
constexpr float kHeightShare = 0.15F;     // by which the height may differ
constexpr float kCreatureGap = 6.0F;
constexpr float kStarRoom = 22.0F;      // side of the square in the tile's corner for the star
constexpr std::size_t kNotedTiles = 4;  // number of tiles whose positions are recorded
constexpr int kMostGrown = 24;

bool on_show(const FrameContext& frame, const Individual& individual) {
    return !frame.viewer.playback.empty() &&
           frame.viewer.playback.exhibit().genome() == individual.genome;
}

bool judged(const EvaluationResult& result) {
    return result.outcome == Outcome::kCompleted;
}

// Returns the score or, without one, why there is none.
std::string tile_score(const EvaluationResult& result) {
    switch (result.outcome) {
        case Outcome::kCompleted:
            return shown_score(result.fitness, "");
        case Outcome::kStoppedEarly:
            return "stopped";
        case Outcome::kRejected:
            return "rejected";
        default:
            return "invalid";
    }
}

std::string tile_words(const Tile& tile, const FrameContext& frame) {
    const Individual& individual = *tile.creature.individual;
    const EvaluationResult& result = individual.result;
    std::string text = creature_name(*individual.genome);
    text += tile.rank > 0 ? fmt::format(", rank {}\n", tile.rank)
                          : fmt::format(" of generation {}\n", tile.creature.generation);
    if (judged(result)) {
        const std::string unit = goal_unit(tile.creature.settings->goal, frame.kinds.goals);
        text += "Fitness " + shown_score(result.fitness, unit);
        const std::string range = confirmed_range(result);
        if (!range.empty()) text += ", " + range;
    } else {
        text += capitalized(std::string(outcome_name(result.outcome)));
        if (!result.reason.empty()) text += ": " + result.reason;
    }
    text += fmt::format("\n{} parts, {} neurons, {}\n\n", result.parts, result.neurons,
                        measured(result.mass, "kg"));
    return text + origin_words(individual, frame.experiment.snapshot.population, frame.kinds);
}

void draw_order(const FrameContext& frame, Requests& out) {
    const TileSorting& chosen = tile_sorting(frame.view.order);
    const bool open = begin_choice("##order", chosen.name, px(104));
    note_place("tile order");
    if (!open) return tooltip("The order of the creatures. " + std::string(chosen.what));
    for (const TileSorting& sorting : tile_sortings()) {
        if (choice_line(sorting.name, sorting.order == chosen.order)) {
            change_view(frame, out, [&](ViewState& view) { view.order = sorting.order; });
        }
        note_place(fmt::format("by {}", sorting.id));
        tooltip(sorting.what);
    }
    ImGui::EndCombo();
}

// A button that toggles one flag of the view.
void draw_toggle(const char* label, bool ViewState::*flag, ButtonStyle style,
                 const FrameContext& frame, Requests& out) {
    style.look = frame.view.*flag ? ButtonLook::kSelected : ButtonLook::kGhost;
    style.height = ImGui::GetFrameHeight();
    if (push_button(label, style))
        change_view(frame, out, [flag](ViewState& view) { view.*flag = !(view.*flag); });
}

void draw_filter(const FrameContext& frame, Requests& out) {
    draw_toggle("Starred", &ViewState::starred_only,
                {.icon = Icon::kStar,
                 .tooltip = "Only creatures with a star, of all generations. A click on a "
                            "tile's corner or K gives a star or takes it away."},
                frame, out);
    constexpr const char* plans = "One per body plan";
    const float end = ImGui::GetItemRectMax().x + ImGui::CalcTextSize(plans).x + px(32);
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (end > right - px(kHelpMarkRoom)) return;  // the palette has it, too
    ImGui::SameLine();
    draw_toggle(plans, &ViewState::one_a_plan,
                {.tooltip = "Only the best of each body plan: of creatures whose parts and "
                            "joints form the same tree, whatever their sizes."},
                frame, out);
    if (!frame.view.starred_only || !frame.generations.stars.can_restore()) return;
    ImGui::SameLine();
    if (push_button("Give back", {.look = ButtonLook::kGhost,
                                  .height = ImGui::GetFrameHeight(),
                                  .tooltip = "The star that was taken away last"}))
        out.ask(RestoreStar{});
}

void draw_heading(const FrameContext& frame, std::size_t count, Requests& out) {
    place_title("Population", "timeline", out);
    const WithFont font(ui().fonts.small);
    ImGui::SameLine(0, px(10));
    draw_order(frame, out);
    ImGui::SameLine();
    draw_filter(frame, out);
    if (frame.experiment.snapshot.history.empty()) return;
    const char* plans = frame.view.one_a_plan ? "plans " : "";
    const std::string words =
        frame.view.starred_only ? fmt::format("{} kept", count)
                                : fmt::format("{} {}of generation {}", count, plans,
                                              frame.experiment.snapshot.history.back().generation);
    ImGui::SameLine(0, px(12));
    const float room =
        ImGui::GetContentRegionAvail().x - px(kHelpMarkRoom) - ImGui::CalcTextSize(words.c_str()).x;
    if (room < 0.0F) return ImGui::NewLine();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
    const WithTextColor muted(colors().muted);
    ImGui::TextUnformatted(words.c_str());
}

void small_words(const std::string& words, const ImVec2& at, const Color& color) {
    ImGui::GetWindowDrawList()->AddText(ui().fonts.small, px(12), at, paint(color), words.c_str());
}

float small_width(const std::string& words) {
    return ui().fonts.small->CalcTextSizeA(px(12), 1e6F, 0.0F, words.c_str()).x;
}

Rect star_of(const Rect& tile) {
    return {tile.x + tile.width - px(kStarRoom), tile.y, px(kStarRoom), px(kStarRoom)};
}

std::string star_words(bool starred) {
    return starred ? "Takes the star away."
                   : "A star: the creature stays when its generation has "
                     "passed.";
}

void draw_star(const Rect& room, bool starred, bool tile_hovered) {
    const bool pointed_at = tile_hovered && room.contains(ImGui::GetIO().MousePos);
    if (!starred && !tile_hovered) return;
    const Color& color = starred || pointed_at ? colors().accent : colors().muted;
    draw_icon(*ImGui::GetWindowDrawList(), starred ? Icon::kStar : Icon::kStarOutline,
              room.center(), px(13), color);
}

}  // namespace

void PopulationPanel::gather(const FrameContext& frame) {
    const EvolutionSnapshot& snapshot = frame.experiment.snapshot;
    const ListedFor wanted = {snapshot.experiment,
                              snapshot.history.size(),
                              frame.generations.stars.revision(),
                              frame.view.order,
                              {frame.view.starred_only, frame.view.one_a_plan}};
    if (wanted == listed_for_) return;
    if (wanted.experiment != listed_for_.experiment) {
        bodies_.clear();
        from_top_ = true;
    }
    listed_for_ = wanted;
    tiles_ = list_tiles(snapshot, frame.generations.stars, wanted.order, wanted.filter);
}

void PopulationPanel::draw(const FrameContext& frame, Requests& out) {
    gather(frame);
    draw_heading(frame, tiles_.size(), out);
    tiles_drawn_ = 0;
    if (tiles_.empty()) {
        ImGui::Dummy({0, px(2)});
        muted_text(frame.view.starred_only
                       ? "No creature has a star. Point at a tile and click its corner, or press K "
                         "for the creature on display: it stays when its generation has passed."
                       : "The creatures of the newest finished generation are here, best first.");
        return;
    }
    bodies_.begin_frame(kMostGrown);
    ImGui::BeginChild("tiles", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    if (std::exchange(from_top_, false)) ImGui::SetScrollY(0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kCreatureGap), px(kCreatureGap)));
    draw_tiles(frame, out);
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

// Returns tiles of which columns and rows fill the room.
PopulationPanel::TileGrid PopulationPanel::grid_in(const ImVec2& room) {
    const float gap = px(kCreatureGap);
    const float usual = px(kCreatureHeight);
    const int columns = tiles_across(room.x, px(kCreatureWidth), gap);
    const float rows = std::max(1.0F, std::round((room.y + gap) / (usual + gap)));
    const float width = (room.x + gap) / static_cast<float>(columns) - gap;
    const float height = std::clamp((room.y + gap) / rows - gap, (1.0F - kHeightShare) * usual,
                                    (1.0F + kHeightShare) * usual);
    return {static_cast<std::size_t>(columns), {std::floor(width), std::floor(height)}};
}

void PopulationPanel::draw_tiles(const FrameContext& frame, Requests& out) {
    const TileGrid grid = grid_in(ImGui::GetContentRegionAvail());
    follow_keys(grid, frame, out);
    const std::size_t rows = (tiles_.size() + grid.columns - 1) / grid.columns;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows), grid.tile.y + px(kCreatureGap));
    while (clipper.Step()) {
        const std::size_t first = static_cast<std::size_t>(clipper.DisplayStart) * grid.columns;
        const std::size_t end = static_cast<std::size_t>(clipper.DisplayEnd) * grid.columns;
        for (std::size_t i = first; i < std::min(end, tiles_.size()); ++i) {
            if (i % grid.columns > 0) ImGui::SameLine();
            draw_tile(i, grid.tile, frame, out);
        }
    }
}

void PopulationPanel::draw_tile(std::size_t index, const ImVec2& size, const FrameContext& frame,
                                Requests& out) {
    const Tile& tile = tiles_[index];
    const std::string name = fmt::format("tile {}", index);
    const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
    const ImVec2 low = ImGui::GetItemRectMin();
    const Rect area = {low.x, low.y, size.x, size.y};
    const Rect star = star_of(area);
    if (index < kNotedTiles) {
        note_place(name);
        note_place(fmt::format("star {}", index), star);
    }
    if (pressed && star.contains(ImGui::GetIO().MousePos)) {
        out.ask(ToggleStar{tile.creature});
    } else if (pressed) {
        out.ask(ShowIndividual{tile.creature});
    }
    draw_content(tile, area, frame);
    if (ImGui::IsItemHovered()) {
        const bool on_star = star.contains(ImGui::GetIO().MousePos);
        tooltip(on_star ? star_words(tile.starred) : tile_words(tile, frame));
    }
    ++tiles_drawn_;
}

void PopulationPanel::draw_content(const Tile& tile, const Rect& area, const FrameContext& frame) {
    const Individual& individual = *tile.creature.individual;
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Color back = hovered ? colors().hovered : mix(colors().panel, colors().raised, 0.6F);
    list.AddRectFilled(area.low(), area.high(), paint(back), px(5));
    if (on_show(frame, individual))
        list.AddRect(area.low(), area.high(), paint(colors().accent), px(5), ImDrawFlags_None,
                     px(2));
    const ExperimentSettings& settings = *tile.creature.settings;
    const Rect body = {area.x + px(8), area.y + px(18), area.width - px(16), area.height - px(38)};
    const Phenotype* phenotype = bodies_.find(individual.genome, frame.kinds.creature,
                                              settings.expression, settings.world.scene);
    if (phenotype != nullptr)
        draw_creature_tile(list, body, *phenotype, individual.genome->hue, individual.line);
    const std::string place =
        tile.rank > 0 ? std::to_string(tile.rank) : fmt::format("gen {}", tile.creature.generation);
    const WithFont font(ui().fonts.small);
    const std::string named = fmt::format("{} {}", place, creature_name(*individual.genome));
    const float taken = tile.starred || hovered ? px(kStarRoom) : px(4);
    small_words(fit_text(named, area.width - px(6) - taken), {area.x + px(6), area.y + px(3)},
                colors().muted);
    draw_star(star_of(area), tile.starred, hovered);
    const bool valid = !disqualified(individual);
    const std::string score = tile_score(individual.result);
    small_words(score, {area.center().x - 0.5F * small_width(score), area.y + area.height - px(18)},
                valid ? colors().muted : colors().danger);
}

// The arrow keys move from the displayed creature, or to the first tile if it has none.
void PopulationPanel::follow_keys(const TileGrid& grid, const FrameContext& frame,
                                  Requests& out) const {
    if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) return;
    if (ImGui::GetIO().WantTextInput) return;
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    const auto row = static_cast<std::ptrdiff_t>(grid.columns);
    const std::ptrdiff_t steps = pressed(ImGuiKey_RightArrow)  ? 1
                                 : pressed(ImGuiKey_LeftArrow) ? -1
                                 : pressed(ImGuiKey_DownArrow) ? row
                                 : pressed(ImGuiKey_UpArrow)   ? -row
                                                               : 0;
    if (steps == 0) return;
    const auto shown = std::find_if(tiles_.begin(), tiles_.end(), [&frame](const Tile& tile) {
        return on_show(frame, *tile.creature.individual);
    });
    const auto last = static_cast<std::ptrdiff_t>(tiles_.size()) - 1;
    const std::ptrdiff_t wanted = shown == tiles_.end() ? 0 : shown - tiles_.begin() + steps;
    if (wanted < 0 || wanted > last) return;
    out.ask(ShowIndividual{tiles_[static_cast<std::size_t>(wanted)].creature});
    const std::ptrdiff_t line = wanted / row;
    const float top = static_cast<float>(line) * (grid.tile.y + px(kCreatureGap));
    const float lowest = top + grid.tile.y - ImGui::GetWindowHeight();
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY(), std::min(lowest, top), top));
}

}  // namespace cambrian
