#include "studio/panels/preserve/new_preserve_card.h"

#include "studio/panels/cards/card_title.h"
#include "studio/widgets/panel_keys.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

struct Choice {
    std::optional<FounderChoice> founders;  // none: goes on with the last preserve
    const char* label;
    const char* help;
};
constexpr std::array kChoices = {
    Choice{std::nullopt, "Go on with the last preserve", "It is where it was left"},
    Choice{FounderChoice::kShown, "The creature on display", "Copies of it, until there are 40"},
    Choice{FounderChoice::kStarred, "The starred creatures", "Those you marked with a star"},
    Choice{FounderChoice::kPicked, "The picked creatures", "Those you picked by hand in the grid"},
    Choice{FounderChoice::kSwimmers, "The swimmers among the samples",
           "Evolved before; they reach food from the first minute"},
    Choice{FounderChoice::kWalkers, "The walkers among the samples",
           "Evolved before; they live on a meadow"},
    Choice{FounderChoice::kRandom, "Random creatures",
           "Most starve; copies of founders come until some live by themselves"},
};

struct GroundChoice {
    const char* label;
    const char* help;
    TerrainSettings terrain;
};

const std::vector<GroundChoice>& ground_choices() {
    static const std::vector<GroundChoice> choices = {
        {"Flat ground", "A level floor. Page Down leads to the next ground", {}},
        {"Hills",
         "Round hills up to 1.4 m high; each new world has others",
         {.kind = "hills", .height = 1.4, .spacing = 4.0}},
        {"Rough", "Bumps as high as a foot", {.kind = "rough", .height = 0.12, .spacing = 0.5}},
        {"Stairs",
         "A valley with steps of 12 cm up to both sides",
         {.kind = "stairs", .height = 0.12, .spacing = 0.6}},
    };
    return choices;
}

std::size_t choice_of(FounderChoice founders) {
    std::size_t i = 0;
    while (kChoices[i].founders != founders)
        ++i;
    return i;
}

std::string world_words(const PlanPreserve& plan) {
    if (plan.settings.empty()) return "It is water or, for those that live on ground, a meadow.";
    return fmt::format("It has the settings of {}.", plan.settings.filename().string());
}

bool is_possible(std::optional<FounderChoice> founders, const PreserveCardView& card) {
    if (!founders) return card.before;
    switch (*founders) {
        case FounderChoice::kShown:
            return card.shown;
        case FounderChoice::kStarred:
            return card.starred > 0;
        case FounderChoice::kPicked:
            return card.picked > 0;
        case FounderChoice::kSwimmers:
        case FounderChoice::kWalkers:
        case FounderChoice::kRandom:
            break;
    }
    return true;
}

}  // namespace

void NewPreserveCard::draw(const FrameContext& frame, Requests& out) {
    const PreserveCardView& card = frame.preserve_card;
    follow_plan(card.plan);
    move_by_keys(card);
    if (card_title("New preserve", "Close the card", "preserve", out))
        out.ask(TogglePreserveCard{});
    muted_text(fmt::format(
        "A closed world that goes on by itself: creatures eat, bite, bear children and die. {} "
        "Who begins it?",
        world_words(card.plan)));
    ImGui::Dummy({0, px(4)});
    for (std::size_t i = 0; i < kChoices.size(); ++i) {
        if (draw_choice(i, is_possible(kChoices[i].founders, card))) chosen_ = i;
    }
    ImGui::Dummy({0, px(6)});
    const bool planned = !card.plan.settings.empty();
    const std::optional<FounderChoice> founders = kChoices[chosen_].founders;
    const bool meadow = founders && card.on_ground.contains(*founders);
    if (!planned) {
        draw_edges(founders.has_value());
        draw_ground(meadow);
    }
    const bool possible = is_possible(kChoices[chosen_].founders, card);
    const bool entered = possible && panel_key(ImGuiKey_Enter);
    if (push_button("Begin", {.look = ButtonLook::kPrimary,
                              .width = px(110),
                              .height = px(34),
                              .enabled = possible,
                              .tooltip = "Enter"}) ||
        entered)
        out.ask(BeginPreserve{
            founders, wraps_ && !planned,
            meadow && !planned ? ground_choices()[ground_].terrain : TerrainSettings{}});
}

// Chooses samples that can live in a world that was just planned.
void NewPreserveCard::follow_plan(const PlanPreserve& plan) {
    if (std::exchange(settings_, plan.settings) == plan.settings || plan.settings.empty()) return;
    chosen_ = choice_of(plan.ground ? FounderChoice::kWalkers : FounderChoice::kSwimmers);
}

// A preserve that goes on keeps its edges.
void NewPreserveCard::draw_edges(bool possible) {
    ImGui::BeginDisabled(!possible);
    const int pressed =
        segmented("edges", {"Soft walls around it", "Edges that meet"}, wraps_ ? 1 : 0,
                  {"Creatures are pushed back into the world. Left arrow",
                   "What leaves the world on one side enters it on the other; on a "
                   "meadow, to the left and the right. Right arrow"});
    ImGui::EndDisabled();
    if (pressed >= 0) wraps_ = pressed == 1;
    ImGui::Dummy({0, px(6)});
}

// Water has no ground.
void NewPreserveCard::draw_ground(bool possible) {
    std::vector<std::string> labels;
    std::vector<std::string> helps;
    for (const GroundChoice& each : ground_choices()) {
        labels.emplace_back(each.label);
        helps.emplace_back(each.help);
    }
    ImGui::BeginDisabled(!possible);
    const int pressed =
        segmented("ground", labels, possible ? static_cast<int>(ground_) : 0, helps);
    ImGui::EndDisabled();
    if (pressed >= 0) ground_ = static_cast<std::size_t>(pressed);
    ImGui::Dummy({0, px(6)});
}

void NewPreserveCard::move_by_keys(const PreserveCardView& card) {
    const std::size_t grounds = ground_choices().size();
    if (panel_key(ImGuiKey_PageDown)) ground_ = (ground_ + 1) % grounds;
    if (panel_key(ImGuiKey_PageUp)) ground_ = (ground_ + grounds - 1) % grounds;
    if (panel_key(ImGuiKey_LeftArrow)) wraps_ = false;
    if (panel_key(ImGuiKey_RightArrow)) wraps_ = true;
    const std::size_t count = kChoices.size();
    std::size_t step = 0;
    if (panel_key(ImGuiKey_DownArrow)) step = 1;
    if (panel_key(ImGuiKey_UpArrow)) step = count - 1;
    if (step == 0) return;
    do {
        chosen_ = (chosen_ + step) % count;
    } while (!is_possible(kChoices[chosen_].founders, card));
}

// Returns true when it was pressed.
bool NewPreserveCard::draw_choice(std::size_t index, bool possible) {
    const Choice& choice = kChoices[index];
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, px(46)};
    const bool pressed = ImGui::InvisibleButton(choice.label, size) && possible;
    note_place(choice.label);
    const bool chosen = index == chosen_;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    Color back = colors().raised;
    if (chosen) back = mix(colors().raised, colors().accent, 0.3F);
    if (ImGui::IsItemHovered() && possible && !chosen) back = colors().hovered;
    const float alpha = possible ? 1.0F : 0.45F;
    list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, paint(with_alpha(back, alpha)),
                       px(6));
    list.AddText({low.x + px(14), low.y + px(5)}, paint(with_alpha(colors().text, alpha)),
                 choice.label);
    list.AddText(ui().fonts.small, px(13), {low.x + px(14), low.y + px(25)},
                 paint(with_alpha(colors().muted, alpha)),
                 possible ? choice.help : "There is none yet");
    return pressed;
}

}  // namespace cambrian
