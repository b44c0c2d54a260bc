#include "studio/main_window.h"

#include "studio/widgets/keyboard_focus.h"

#include <string>

namespace cambrian {
namespace {

const Rect& area_of(const Layout& layout, PanelArea area) {
    switch (area) {
        case PanelArea::kBar:
            return layout.bar;
        case PanelArea::kLeft:
            return layout.experiment;
        case PanelArea::kUnderCenter:
            return layout.transport;
        case PanelArea::kRight:
            return layout.inspector;
        case PanelArea::kBottomLeft:
            return layout.timeline;
        case PanelArea::kBottomRight:
            return layout.population;
        case PanelArea::kUnderAll:
            return layout.foot;
        case PanelArea::kCenter:
        case PanelArea::kCard:
            break;
    }
    return layout.viewport;
}

// Converts a length to pixels; a negative one means the style's and is kept.
float length(float units) {
    return units < 0.0F ? units : px(units);
}

// Draws a soft shadow around a card, to set it off from the panels under it.
void draw_shadow(const Rect& rect, float rounding) {
    constexpr int rings = 14;
    const Color edge =
        with_alpha(color_of(0x000000), ui().theme == ThemeKind::kLight ? 0.06F : 0.22F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    for (int ring = 1; ring <= rings; ++ring) {
        const float out = px(static_cast<float>(ring) - 0.5F);
        const float left = 1.0F - static_cast<float>(ring) / (rings + 1);
        list.AddRect(
            {rect.x - out, rect.y - out}, {rect.x + rect.width + out, rect.y + rect.height + out},
            paint(with_alpha(edge, edge.a * left)), rounding + out, ImDrawFlags_None, px(1.5F));
    }
    list.PopClipRect();
}

// Begins the ImGui window of a card, which lies over the panels.
void begin_card(const char* name, const Rect& rect, const PanelPlace& place) {
    const float rounding = px(place.rounding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, rounding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2{px(place.padding_x), px(place.padding_y)});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, paint(colors().overlay));
    ImGui::SetNextWindowPos(rect.low());
    ImGui::SetNextWindowSize({rect.width, rect.height});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    begin_focus_layer();
    draw_shadow(rect, rounding);
    note_place(std::string("panel ") + name, rect);
}

void end_card() {
    ImGui::End();
    ImGui::PopStyleVar(3);
    ImGui::PopStyleColor();
}

}  // namespace

MainWindow::MainWindow(std::span<const PanelKind> kinds, Renderer* renderer) : kinds_(kinds) {
    for (const PanelKind& kind : kinds)
        panels_.push_back(kind.make(renderer));
}

void MainWindow::draw(const FrameContext& frame, Requests& out) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    if (frame.window.presenting) {
        Layout whole;
        whole.viewport = {0, 0, size.x, size.y};
        center_ = whole.viewport;
        return draw_areas(frame, whole, out);
    }
    const bool alone = frame.window.viewer_only;
    const Layout layout =
        alone ? viewer_layout(size.x, size.y, ui().scale)
              : divide_window(size.x, size.y, frame.view, ui().scale, frame.foot_shown());
    center_ = layout.viewport;
    if (!alone) draw_gaps(layout);
    draw_areas(frame, layout, out);
    ViewState view = frame.view;
    if (!alone && drag_gaps(layout, view)) out.ask(ChangeView{view});
    draw_cards(frame, layout, out);
}

void MainWindow::draw_areas(const FrameContext& frame, const Layout& layout, Requests& out) {
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
        const PanelKind& kind = kinds_[i];
        if (kind.place.area == PanelArea::kCard || !kind.shown(frame)) continue;
        const Rect& rect = area_of(layout, kind.place.area);
        if (rect.width < 1.0F || rect.height < 1.0F) continue;
        const Place keyboard = kind.place.keyboard;
        if (keyboard != Place::kNone && keyboard == frame.window.focus) ImGui::SetNextWindowFocus();
        begin_place(kind.name, rect, length(kind.place.padding_x), length(kind.place.padding_y));
        panels_[i]->draw(frame, out);
        end_place();
    }
}

void MainWindow::draw_cards(const FrameContext& frame, const Layout& layout, Requests& out) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const CardSpace space = {.window = {0, 0, size.x, size.y}, .viewport = layout.viewport};
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
        const PanelKind& kind = kinds_[i];
        if (kind.place.area != PanelArea::kCard || !kind.shown(frame)) continue;
        begin_card(kind.name, kind.place.card(frame, space), kind.place);
        panels_[i]->draw(frame, out);
        end_card();
    }
}

}  // namespace cambrian
