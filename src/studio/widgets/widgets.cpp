#include "studio/widgets/widgets.h"

#include "studio/widgets/keyboard_focus.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

struct ButtonColors {
    Color back;
    Color front;
};

ButtonColors button_colors(const ButtonStyle& style, bool hovered, bool held) {
    const Palette& p = colors();
    ButtonColors c{p.raised, p.text};
    if (style.look == ButtonLook::kPrimary) c = {p.accent, p.on_accent};
    if (style.look == ButtonLook::kGhost) c = {with_alpha(p.raised, 0.0F), p.muted};
    if (style.look == ButtonLook::kSelected) c = {mix(p.raised, p.accent, 0.3F), p.text};
    if (!style.enabled) return {with_alpha(c.back, 0.5F * c.back.a), with_alpha(p.muted, 0.5F)};
    if (hovered && style.look == ButtonLook::kPrimary) c.back = mix(c.back, p.text, 0.12F);
    if (hovered && style.look != ButtonLook::kPrimary) c = {p.hovered, p.text};
    if (held) c.back = mix(c.back, p.window, 0.15F);
    return c;
}

void draw_button(const std::string& label, const ButtonStyle& style, const ButtonColors& c) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    list.AddRectFilled(low, high, paint(c.back), px(6));
    const float icon_size = style.icon == Icon::kNone ? 0.0F : px(13);
    const ImVec2 text_size =
        style.label_shown ? ImGui::CalcTextSize(label.c_str()) : ImVec2(0.0F, 0.0F);
    const float gap = icon_size > 0.0F && style.label_shown ? px(8) : 0.0F;
    float x = 0.5F * (low.x + high.x - icon_size - gap - text_size.x);
    const float middle = 0.5F * (low.y + high.y);
    if (icon_size > 0.0F) {
        draw_icon(list, style.icon, {x + 0.5F * icon_size, middle}, icon_size, c.front);
        x += icon_size + gap;
    }
    if (style.label_shown) {
        list.AddText({std::floor(x), std::floor(middle - 0.5F * text_size.y)}, paint(c.front),
                     label.c_str());
    }
}

ImVec2 button_size(const std::string& label, const ButtonStyle& style) {
    const float text = style.label_shown ? ImGui::CalcTextSize(label.c_str()).x : 0.0F;
    const float icon = style.icon == Icon::kNone ? 0.0F : px(13);
    const float gap = text > 0.0F && icon > 0.0F ? px(8) : 0.0F;
    const float padding = style.label_shown ? px(24) : px(17);
    return {style.width > 0.0F ? style.width : text + gap + icon + padding,
            style.height > 0.0F ? style.height : px(30)};
}

// Returns how many of `count` labels go on each line so that the lines are about equally long.
int labels_a_line(int count, float together, float room) {
    const int lines = std::max(1, static_cast<int>(std::ceil(together / std::max(room, 1.0F))));
    return (count + lines - 1) / lines;
}

float row_width(const std::vector<std::string>& labels, float padding) {
    float width = 0.0F;
    for (const std::string& label : labels)
        width += ImGui::CalcTextSize(label.c_str()).x + padding;
    return width;
}

}  // namespace

bool push_button(const std::string& label, const ButtonStyle& style) {
    const bool pressed = ImGui::InvisibleButton(label.c_str(), button_size(label, style));
    note_place(label);
    draw_button(label, style, button_colors(style, ImGui::IsItemHovered(), ImGui::IsItemActive()));
    const bool entered = focus_stop();
    if (style.tooltip != nullptr) tooltip(style.tooltip);
    return (pressed || entered) && style.enabled;
}

bool toggle_switch(const std::string& label, bool& on) {
    const ImVec2 size = {px(38), px(22)};
    bool pressed = ImGui::InvisibleButton(label.c_str(), size);
    note_place(label);
    pressed |= focus_stop();
    if (pressed) on = !on;
    const Palette& p = colors();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float radius = 0.5F * size.y;
    const Color track = on ? p.accent : ImGui::IsItemHovered() ? p.hovered : p.raised;
    list.AddRectFilled(low, high, paint(track), radius);
    const float knob_x = on ? high.x - radius : low.x + radius;
    list.AddCircleFilled({knob_x, low.y + radius}, radius - px(4),
                         paint(on ? p.on_accent : p.muted), 20);
    return pressed;
}

bool tick_box(const std::string& label, Tick tick) {
    const float side = px(18);
    bool pressed = ImGui::InvisibleButton(label.c_str(), {side, side});
    note_place(label);
    pressed |= focus_stop();
    const Palette& p = colors();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const Color empty = ImGui::IsItemHovered() ? p.hovered : p.raised;
    list.AddRectFilled(low, high, paint(tick == Tick::kOff ? empty : p.accent), px(4));
    const ImVec2 middle = {0.5F * (low.x + high.x), 0.5F * (low.y + high.y)};
    const float width = px(2);
    if (tick == Tick::kSome) {
        list.AddLine({middle.x - px(4), middle.y}, {middle.x + px(4), middle.y}, paint(p.on_accent),
                     width);
    } else if (tick == Tick::kOn) {
        const ImVec2 bend = {middle.x - px(1), middle.y + px(4)};
        list.AddLine({middle.x - px(5), middle.y}, bend, paint(p.on_accent), width);
        list.AddLine(bend, {middle.x + px(5), middle.y - px(4)}, paint(p.on_accent), width);
    }
    return pressed;
}

int segmented(const std::string& name, const std::vector<std::string>& labels, int chosen,
              const std::vector<std::string>& tooltips, const std::vector<bool>& possible) {
    ImGui::PushID(name.c_str());
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(2), 0.0F));
    const bool roomy = row_width(labels, px(18)) <= ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(roomy ? ui().fonts.body : ui().fonts.small);
    int pressed = -1;
    const float room = ImGui::GetContentRegionAvail().x;
    const float right_edge = ImGui::GetCursorScreenPos().x + room;
    const int a_line = labels_a_line(static_cast<int>(labels.size()),
                                     row_width(labels, px(roomy ? 18 : 10)) - px(2), room);
    for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
        const auto index = static_cast<std::size_t>(i);
        const std::string& label = labels[index];
        ButtonStyle style;
        style.look = i == chosen ? ButtonLook::kSelected : ButtonLook::kGhost;
        style.width = ImGui::CalcTextSize(label.c_str()).x + (roomy ? px(16) : px(8));
        const float end = ImGui::GetItemRectMax().x + px(2) + style.width;
        if (i % a_line != 0 && end <= right_edge) ImGui::SameLine();
        style.height = px(28);
        if (index < tooltips.size()) style.tooltip = tooltips[index].c_str();
        if (index < possible.size()) style.enabled = possible[index];
        if (push_button(label, style)) pressed = i;
    }
    ImGui::PopFont();
    ImGui::PopStyleVar();
    ImGui::PopID();
    return pressed;
}

bool begin_choice(const char* id, const std::string& shown, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::SetNextItemWidth(width);
    const std::string fitting = fit_text(shown, width - choice_width(""));
    const ImGuiID combo = ImGui::GetID(id);
    const bool open = ImGui::BeginCombo(id, fitting.c_str(), ImGuiComboFlags_NoArrowButton);
    if (open) {
        begin_focus_layer();
    } else {
        if (focus_stop()) ImGui::OpenPopupEx(ImHashStr("##ComboPopup", 0, combo));
        draw_icon(*ImGui::GetWindowDrawList(), Icon::kChevronDown,
                  {at.x + width - px(15), at.y + 0.5F * ImGui::GetFrameHeight()}, px(10),
                  colors().muted);
    }
    return open;
}

bool choice_line(const std::string& label, bool chosen) {
    const bool pressed = ImGui::Selectable(label.c_str(), chosen);
    KeyboardFocus& focus = ui().focus;
    if (chosen && ImGui::IsWindowAppearing() && focus.control != 0)
        focus.control = ImGui::GetItemID();
    if (!focus_stop()) return pressed;
    ImGui::CloseCurrentPopup();
    return true;
}

float choice_width(const std::string& shown) {
    constexpr float chevron_room = 25.0F;
    return std::ceil(ImGui::CalcTextSize(shown.c_str()).x) + ImGui::GetStyle().FramePadding.x +
           px(chevron_room);
}

bool menu_item(const char* label, const char* keys, bool enabled, bool chosen) {
    const bool pressed = ImGui::MenuItem(label, keys, chosen, enabled);
    note_place(label);
    if (!focus_stop() || !enabled) return pressed;
    ImGui::CloseCurrentPopup();
    return true;
}

void caption(const std::string& text) {
    const WithFont font(ui().fonts.small);
    const WithTextColor color(colors().muted);
    ImGui::TextUnformatted(text.c_str());
}

void panel_title(const std::string& text) {
    const WithFont font(ui().fonts.strong);
    ImGui::TextUnformatted(text.c_str());
}

void section(const char* title) {
    ImGui::Dummy({0, px(4)});
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddLine(at, {at.x + width, at.y}, paint(colors().border));
    ImGui::Dummy({0, px(2)});
    const WithFont font(ui().fonts.strong);
    ImGui::TextUnformatted(title);
}

void fact(const std::string& label, const std::string& value) {
    note_letters(value);
    const float left = ImGui::GetCursorPosX();
    const float right = left + ImGui::GetContentRegionAvail().x;
    {
        const WithTextColor color(colors().muted);
        ImGui::TextUnformatted(label.c_str());
    }
    const float beside = right - left - ImGui::GetItemRectSize().x - px(12);
    const bool fits_beside = ImGui::CalcTextSize(value.c_str()).x <= beside;
    const std::string shown = fits_beside ? value : fit_text(value, right - left);
    const float start = right - ImGui::CalcTextSize(shown.c_str()).x;
    if (fits_beside) {
        ImGui::SameLine(start);
    } else {
        ImGui::SetCursorPosX(start);
    }
    ImGui::TextUnformatted(shown.c_str());
    if (shown != value) tooltip(value);
}

void muted_text(const std::string& text) {
    note_letters(text);
    const WithFont font(ui().fonts.small);
    const WithTextColor color(colors().muted);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

void progress_bar(float share, float width, float height) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float full = width > 0.0F ? width : ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({full, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = 0.5F * height;
    list.AddRectFilled(low, {low.x + full, low.y + height}, paint(colors().raised), radius);
    const float filled = full * std::clamp(share, 0.0F, 1.0F);
    if (filled < 1.0F) return;
    list.AddRectFilled(low, {low.x + std::max(filled, height), low.y + height},
                       paint(colors().accent), radius);
}

void set_up_column(const char* title, float width) {
    const bool fixed = width > 0.0F;
    ImGui::TableSetupColumn(
        title, fixed ? ImGuiTableColumnFlags_WidthFixed : ImGuiTableColumnFlags_WidthStretch,
        px(width));
}

void tooltip(const std::string& text) {
    constexpr double delay = 0.45;  // s under the mouse before a tooltip appears
    if (!ImGui::IsItemHovered() || ImGui::GetIO().MouseDown[0]) return;
    note_letters(text);
    const ImVec2 low = ImGui::GetItemRectMin();
    UiContext& context = ui();
    if (context.hovered.x != low.x || context.hovered.y != low.y) {
        context.hovered = low;
        context.hovered_since = ImGui::GetTime();
    }
    if (ImGui::GetTime() - context.hovered_since < delay) return;
    // Placed below the control, which stays visible, or above it near the window's bottom.
    const float foot = ImGui::GetItemRectMax().y;
    const bool above = foot > ImGui::GetIO().DisplaySize.y - px(160);
    const float wide = ImGui::CalcTextSize(text.c_str(), nullptr, false, px(320)).x + px(24);
    const float x =
        std::min(ImGui::GetIO().MousePos.x, ImGui::GetIO().DisplaySize.x - wide - px(4));
    const ImVec2 at = {std::max(0.0F, x), above ? low.y - px(6) : foot + px(6)};
    ImGui::SetNextWindowPos(at, ImGuiCond_Always, {0.0F, above ? 1.0F : 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(12), px(9)));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(px(320));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
}

std::string fit_text(const std::string& text, float width) {
    note_letters(text);
    if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
    std::string cut = text;
    while (!cut.empty() && ImGui::CalcTextSize((cut + "…").c_str()).x > width) {
        // Removes a complete UTF-8 character.
        while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xC0U) == 0x80U)
            cut.pop_back();
        if (!cut.empty()) cut.pop_back();
    }
    return cut + "…";
}

}  // namespace cambrian
