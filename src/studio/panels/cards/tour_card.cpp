#include "studio/panels/cards/tour_card.h"

#include "studio/help/tour.h"
#include "studio/widgets/panel_keys.h"
#include "studio/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kWidth = 340.0F;
constexpr float kHeight = 158.0F;
constexpr float kTourGap = 12.0F;

Rect shifted_inside(Rect card, const Rect& window) {
    const float edge = px(kTourGap);
    card.x = std::clamp(card.x, window.x + edge, window.x + window.width - card.width - edge);
    card.y = std::clamp(card.y, window.y + edge, window.y + window.height - card.height - edge);
    return {std::round(card.x), std::round(card.y), card.width, card.height};
}

// Outlines the subject of a step, in front of everything else.
void outline_subject(const Rect& subject) {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const float out = px(2);
    list.AddRect({subject.x - out, subject.y - out},
                 {subject.x + subject.width + out, subject.y + subject.height + out},
                 paint(colors().accent), px(8), 0, px(2.5F));
}

}  // namespace

Rect tour_card_place(const Rect& subject, const Rect& window) {
    const float w = px(kWidth);
    const float h = px(kHeight);
    const float gap = px(kTourGap);
    const ImVec2 low = subject.low();
    const ImVec2 high = subject.high();
    std::array sides = {Rect{high.x + gap, low.y, w, h}, Rect{low.x - gap - w, low.y, w, h},
                        Rect{low.x, high.y + gap, w, h}, Rect{low.x, low.y - gap - h, w, h}};
    // A tall subject has its card at the left or right, a wide one above or below.
    if (subject.height < h) std::rotate(sides.begin(), sides.begin() + 2, sides.end());
    for (const Rect& side : sides) {
        if (side.x >= window.x && side.x + w <= window.x + window.width && side.y >= window.y &&
            side.y + h <= window.y + window.height)
            return shifted_inside(side, window);
    }
    const ImVec2 middle = subject.center();
    return shifted_inside({middle.x - 0.5F * w, middle.y - 0.5F * h, w, h}, window);
}

Rect tour_place(const FrameContext& frame, const CardSpace& space) {
    const auto& places = ui().places;
    const auto is_shown = [&places](const auto& found) {
        return found != places.end() && found->second.frame == ImGui::GetFrameCount() &&
               found->second.rect.width > 1.0F;
    };
    const auto step = static_cast<std::size_t>(frame.guide.tour_step);
    const auto found = places.find(tour_steps()[step].place);
    if (!is_shown(found)) return tour_card_place(space.window, space.window);
    outline_subject(found->second.rect);
    const char* over = tour_steps()[step].over;
    const auto covered = over == nullptr ? places.end() : places.find(over);
    if (!is_shown(covered)) return tour_card_place(found->second.rect, space.window);
    const ImVec2 middle = covered->second.rect.center();
    return shifted_inside(
        {middle.x - 0.5F * px(kWidth), middle.y - 0.5F * px(kHeight), px(kWidth), px(kHeight)},
        space.window);
}

void TourCard::draw(const FrameContext& frame, Requests& out) {
    const auto steps = tour_steps();
    const int count = static_cast<int>(steps.size());
    const TourStep& step = steps[static_cast<std::size_t>(frame.guide.tour_step)];
    {
        const WithFont font(ui().fonts.title);
        ImGui::TextUnformatted(step.title);
    }
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(step.text);
    ImGui::PopTextWrapPos();
    const bool last = frame.guide.tour_step + 1 == count;
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::SetCursorPosY(ImGui::GetWindowHeight() - px(30) - px(16));
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    {
        const WithTextColor muted(colors().muted);
        ImGui::Text("%d of %d", frame.guide.tour_step + 1, count);
    }
    const float next_width = px(84);
    const float skip_width = last ? 0.0F : px(84) + px(8);
    ImGui::SameLine(left + width - next_width - skip_width);
    if (!last) {
        if (push_button("Skip", {.look = ButtonLook::kGhost,
                                 .width = px(84),
                                 .tooltip = "End the tour (Esc); Help has it again"}))
            out.ask(TurnTour{count});
        ImGui::SameLine();
    }
    const bool pressed =
        push_button(last ? "Done" : "Next", {.width = next_width, .tooltip = "Enter"});
    if (pressed || panel_key(ImGuiKey_Enter)) out.ask(TurnTour{frame.guide.tour_step + 1});
}

}  // namespace cambrian
