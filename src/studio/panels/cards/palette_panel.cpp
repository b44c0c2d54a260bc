#include "studio/panels/cards/palette_panel.h"

#include "studio/widgets/keyboard_focus.h"
#include "studio/widgets/widgets.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr float kPaletteLineHeight = 34.0F;

// Sees keys while text is typed, too.
bool key_pressed(ImGuiKey key) {
    const int index = ImGui::GetKeyIndex(key);
    return index >= 0 && ImGui::IsKeyPressed(index);
}

}  // namespace

// Returns whether Enter was pressed.
bool PalettePanel::draw_words(const FrameContext& frame) {
    const bool opened = ImGui::IsWindowAppearing();
    if (opened) {
        ImGui::SetWindowFocus();
        words_.fill('\0');
        help_ =
            frame.guide.help == nullptr ? std::vector<HelpPlace>() : help_places(*frame.guide.help);
    }
    const bool idle = !ImGui::IsAnyItemActive() && !ImGui::GetIO().MouseDown[0];
    if (opened || (idle && ui().focus.control == 0)) ImGui::SetKeyboardFocusHere();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(36), px(9)));
    const std::array<char, 100> before = words_;
    const bool entered = ImGui::InputTextWithHint(
        "##words", "What to do, a setting, or words of the help", words_.data(), words_.size(),
        ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopStyleVar();
    note_place("palette words");
    focus_stop_for_text();
    draw_icon(*ImGui::GetWindowDrawList(), Icon::kSearch,
              {at.x + px(18), at.y + 0.5F * ImGui::GetItemRectSize().y}, px(14), colors().muted);
    if (opened || words_ != before) {
        lines_ = palette_lines(words_.data(), frame, help_);
        chosen_ = 0;
        moved_ = true;
    }
    return entered;
}

void PalettePanel::move_by_keys() {
    const int steps =
        (key_pressed(ImGuiKey_DownArrow) ? 1 : 0) - (key_pressed(ImGuiKey_UpArrow) ? 1 : 0) +
        (key_pressed(ImGuiKey_PageDown) ? 8 : 0) - (key_pressed(ImGuiKey_PageUp) ? 8 : 0);
    if (steps == 0 || lines_.empty()) return;
    const int last = static_cast<int>(lines_.size()) - 1;
    chosen_ = static_cast<std::size_t>(std::clamp(static_cast<int>(chosen_) + steps, 0, last));
    moved_ = true;
}

// Returns whether the line was pressed.
bool PalettePanel::draw_line(std::size_t index) {
    const PaletteLine& line = lines_[index];
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, px(kPaletteLineHeight)};
    ImGui::PushID(static_cast<int>(index));
    const bool pressed = ImGui::InvisibleButton("line", size);
    ImGui::PopID();
    note_place("found " + line.title);
    const ImVec2 mouse = ImGui::GetIO().MouseDelta;
    if (ImGui::IsItemHovered() && (mouse.x != 0.0F || mouse.y != 0.0F)) chosen_ = index;
    if (index == chosen_ && moved_ && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    if (!ImGui::IsItemVisible()) return pressed;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (index == chosen_) {
        list.AddRectFilled(low, high, paint(mix(colors().overlay, colors().accent, 0.22F)), px(6));
        list.AddRectFilled(low, {low.x + px(3), high.y}, paint(colors().accent), px(2));
    }
    const float y = std::floor(0.5F * (low.y + high.y - ImGui::GetFontSize()));
    const bool is_key = line.kind != "help" && line.kind != "setting";
    const float kind = ImGui::CalcTextSize(line.kind.c_str()).x;
    const float right = high.x - px(12);
    list.AddText({right - kind, y}, paint(is_key ? colors().text : colors().muted),
                 line.kind.c_str());
    const float left = low.x + px(14);
    const float room = right - kind - px(18) - left;
    const std::string title = fit_text(line.title, room);
    const Color color = line.enabled ? colors().text : with_alpha(colors().muted, 0.6F);
    list.AddText({left, y}, paint(color), title.c_str());
    const float used = ImGui::CalcTextSize(title.c_str()).x + px(14);
    const WithFont font(ui().fonts.small);
    if (!line.what.empty() && room - used > px(40))
        list.AddText({left + used, y + px(1)}, paint(colors().muted),
                     fit_text(line.what, room - used).c_str());
    return pressed;
}

void PalettePanel::draw(const FrameContext& frame, Requests& out) {
    const bool entered = draw_words(frame);
    move_by_keys();
    ImGui::BeginChild("lines", {0, 0}, false, ImGuiWindowFlags_NoBackground);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, px(1)));
    if (lines_.empty()) muted_text("Nothing has these words in this order.");
    const PaletteLine* taken = nullptr;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (draw_line(i) || (entered && i == chosen_)) taken = &lines_[i];
    }
    moved_ = false;
    ImGui::PopStyleVar();
    ImGui::EndChild();
    if (taken == nullptr || !taken->enabled) return;
    out.ask(TogglePalette{});
    taken->go(frame, out);
}

}  // namespace cambrian
