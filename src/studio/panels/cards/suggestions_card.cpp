#include "studio/panels/cards/suggestions_card.h"

#include "studio/panels/cards/card_title.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr float kSuggestionsWidth = 344.0F;
constexpr float kSuggestionsHeight = 264.0F;
constexpr double kNewcomers = 0.2;  // share of the next generation
constexpr double kMostMutation = 8.0;
constexpr int kMostCreatures = 20'000;
constexpr double kLunarGravity = 1.62;  // m/s^2
constexpr double kEarthGravity = 9.81;  // m/s^2

void change(const FrameContext& frame, Requests& out, const char* field,
            void (*edit)(ExperimentSettings& settings)) {
    ExperimentSettings edited = frame.experiment.editor.draft();
    edit(edited);
    out.ask(EditSettings{std::move(edited), field});
    out.ask(FinishEdit{});
}

// Returns the first selection method that keeps the fittest of every cell of the map, or null.
const SelectionKind* mapping_method(const SelectionRegistry& selections) {
    const auto found = std::find_if(selections.all().begin(), selections.all().end(),
                                    [](const SelectionKind& kind) { return kind.fills_map; });
    return found == selections.all().end() ? nullptr : &*found;
}

const ExperimentSettings& draft_of(const FrameContext& frame) {
    return frame.experiment.editor.draft();
}

bool always_fits(const FrameContext&) {
    return true;
}
bool on_earth(const FrameContext& frame) {
    const Environment& world = draft_of(frame).world.environment;
    return world.has_ground && world.gravity > kLunarGravity;
}
bool on_moon(const FrameContext& frame) {
    const Environment& world = draft_of(frame).world.environment;
    return world.has_ground && world.gravity <= kLunarGravity;
}

// Something to change when evolution is stuck.
struct Suggestion {
    const char* label;
    const char* help;
    bool (*fits)(const FrameContext& frame);
    void (*take)(const FrameContext& frame, Requests& out);
};

const std::array kSuggestions = {
    Suggestion{"Mutate more",
               "Children differ twice as much from their parents: the mutation rate "
               "is doubled.",
               [](const FrameContext& frame) {
                   return draft_of(frame).mutation.rate <= 0.5 * kMostMutation;
               },
               [](const FrameContext& frame, Requests& out) {
                   change(frame, out, "mutation.rate",
                          [](ExperimentSettings& s) { s.mutation.rate *= 2.0; });
               }},
    Suggestion{"Breed more", "Twice as many creatures a generation. Each generation takes longer.",
               [](const FrameContext& frame) {
                   return 2 * draft_of(frame).population.size <= kMostCreatures;
               },
               [](const FrameContext& frame, Requests& out) {
                   change(frame, out, "population.size",
                          [](ExperimentSettings& s) { s.population.size *= 2; });
               }},
    Suggestion{"Add immigrants", "Random immigrants become a fifth of the next generation, once.",
               always_fits,
               [](const FrameContext&, Requests& out) { out.ask(AddImmigrants{kNewcomers}); }},
    Suggestion{"Many kinds",
               "Keep the fittest of every kind of body: the selection method becomes MAP-Elites.",
               [](const FrameContext& frame) {
                   const SelectionKind* mapped = mapping_method(frame.kinds.selections);
                   return mapped != nullptr && draft_of(frame).selection.method != mapped->id;
               },
               [](const FrameContext& frame, Requests& out) {
                   ExperimentSettings edited = draft_of(frame);
                   edited.selection.method = mapping_method(frame.kinds.selections)->id;
                   out.ask(EditSettings{std::move(edited), "selection.method"});
                   out.ask(FinishEdit{});
               }},
    Suggestion{"To the Moon", "The same creatures go on in the Moon's gravity.", on_earth,
               [](const FrameContext& frame, Requests& out) {
                   change(frame, out, "environment.gravity", [](ExperimentSettings& s) {
                       s.world.environment.gravity = kLunarGravity;
                   });
               }},
    Suggestion{"To the Earth", "The same creatures go on in the Earth's gravity.", on_moon,
               [](const FrameContext& frame, Requests& out) {
                   change(frame, out, "environment.gravity", [](ExperimentSettings& s) {
                       s.world.environment.gravity = kEarthGravity;
                   });
               }},
    Suggestion{"Another seed",
               "A new run from other random creatures. Ctrl+Z goes back to this one.", always_fits,
               [](const FrameContext&, Requests& out) { out.ask(StartNewRun{}); }},
    Suggestion{"Pick by hand", "Choose yourself who breeds, from a grid of creatures.", always_fits,
               [](const FrameContext&, Requests& out) { out.ask(ToggleHandPicking{}); }},
};

}  // namespace

void SuggestionsCard::draw(const FrameContext& frame, Requests& out) {
    if (card_title("Stuck?", "Close suggestions", "first_minute", out))
        out.ask(ShowSuggestions{false});
    const int still = frame.experiment.snapshot.history.back().generations_without_progress;
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(
        fmt::format("The best has not risen for {} generations. Change one thing:", still).c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, px(2)});
    const float gap = px(8);
    const float width = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    int column = 0;
    for (const Suggestion& each : kSuggestions) {
        if (!each.fits(frame)) continue;
        if (column % 2 == 1) ImGui::SameLine(0, gap);
        ++column;
        if (!push_button(each.label, {.width = width, .height = px(30), .tooltip = each.help}))
            continue;
        each.take(frame, out);
        out.ask(ShowSuggestions{false});
    }
}

Rect suggestions_place(const FrameContext&, const CardSpace& space) {
    const Rect& over = space.viewport;
    const float w = std::min(px(kSuggestionsWidth), over.width - px(24));
    const float h = std::min(px(kSuggestionsHeight), over.height - px(24));
    return {std::round(over.x + over.width - w - px(12)), std::round(over.y + px(48)), w, h};
}

}  // namespace cambrian
