#include "studio/main_window.h"

#include "studio/help/tour.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

void draw_padded(const char* name, const Rect& rect, const ImVec2& padding, Panel& panel,
                 const FrameContext& frame, Requests& out) {
    begin_place(name, rect, padding.x, padding.y);
    panel.draw(frame, out);
    end_place();
}

void draw_in(const char* name, const Rect& rect, Panel& panel, const FrameContext& frame,
             Requests& out, Place place = Place::kNone) {
    if (rect.width < 1.0F || rect.height < 1.0F) return;
    if (place != Place::kNone && place == frame.focus) ImGui::SetNextWindowFocus();
    begin_place(name, rect);
    panel.draw(frame, out);
    end_place();
}

// Soft and around the window being drawn, so that it stands out from what it covers.
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

// A window over the panels.
void begin_overlay(const char* name, const Rect& rect, const ImVec2& padding, float rounding) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, rounding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, paint(colors().overlay));
    ImGui::SetNextWindowPos(rect.low());
    ImGui::SetNextWindowSize({rect.width, rect.height});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    draw_shadow(rect, rounding);
    note_place(std::string("panel ") + name, rect);
}

void end_overlay() {
    ImGui::End();
    ImGui::PopStyleVar(3);
    ImGui::PopStyleColor();
}

// A card in the middle of the window.
Rect card_place(const Rect& over, float width, float height) {
    const float w = std::min(px(width), over.width - px(24));
    const float h = std::min(px(height), over.height - px(24));
    return {std::round(over.center().x - 0.5F * w), std::round(over.center().y - 0.5F * h), w, h};
}

void draw_card(const char* name, const Rect& rect, Panel& panel, const FrameContext& frame,
               Requests& out) {
    begin_overlay(name, rect, {px(20), px(18)}, px(10));
    panel.draw(frame, out);
    end_overlay();
}

Rect notice_place(const Rect& viewport, const std::string& text) {
    const float wide = std::min(px(620), viewport.width - px(32));
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wide - px(94));
    const float height = std::min(size.y + px(20), viewport.height);
    const float width = std::min(wide, size.x + px(104));
    return {std::round(viewport.center().x - 0.5F * width),
            std::round(viewport.y + viewport.height - height - px(14)), std::round(width),
            std::round(height)};
}

}  // namespace

void MainWindow::draw(const FrameContext& frame, int framebuffer_height, Requests& out) {
    viewport_.set_framebuffer_height(framebuffer_height);
    grid_.set_framebuffer_height(framebuffer_height);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    if (frame.viewer) {
        const Layout layout = viewer_layout(size.x, size.y, ui().scale);
        draw_stage(frame, layout, out);
        draw_overlays(frame, layout, out);
    } else {
        draw_studio(frame, divide_window(size.x, size.y, frame.view, ui().scale), out);
    }
}

void MainWindow::draw_studio(const FrameContext& frame, const Layout& layout, Requests& out) {
    draw_gaps(layout);
    draw_padded("bar", layout.bar, {px(12), px(10)}, bar_, frame, out);
    draw_in("experiment", layout.experiment, experiment_, frame, out);
    const bool picking = frame.picking != nullptr;
    if (picking && !frame.picking->single) {
        draw_grid(frame, layout, out);
    } else {
        draw_stage(frame, layout, out);
    }
    if (picking) {
        draw_in("tree", layout.timeline, tree_, frame, out);
        draw_in("shelf place", layout.population, shelf_, frame, out);
    } else {
        draw_in("timeline", layout.timeline, timeline_, frame, out, Place::kTimeline);
        draw_in("population", layout.population, population_, frame, out, Place::kPopulation);
    }
    ViewState view = frame.view;
    if (drag_gaps(layout, view)) out.ask(ChangeView{view});
    draw_overlays(frame, layout, out);
}

// One creature, and what there is to know of it.
void MainWindow::draw_stage(const FrameContext& frame, const Layout& layout, Requests& out) {
    draw_padded("viewport", layout.viewport, {0, 0}, viewport_, frame, out);
    draw_padded("transport", layout.transport, {px(10), px(6)}, transport_, frame, out);
    draw_in("inspector", layout.inspector, inspector_, frame, out);
}

// The creatures to pick from.
void MainWindow::draw_grid(const FrameContext& frame, const Layout& layout, Requests& out) {
    draw_padded("picking grid", layout.viewport, {0, 0}, grid_, frame, out);
    draw_padded("picking strip", layout.transport, {px(10), px(8)}, strip_, frame, out);
    draw_in("picking", layout.inspector, picking_, frame, out);
}

void MainWindow::draw_tour(const FrameContext& frame, const Rect& whole, Requests& out) {
    const auto& places = ui().places;
    const auto found = places.find(tour_steps()[static_cast<std::size_t>(frame.tour_step)].place);
    const bool shown = found != places.end() && found->second.frame == ImGui::GetFrameCount();
    const Rect subject = shown ? found->second.rect : Rect{};
    if (subject.width > 1.0F) outline_subject(subject);
    draw_card("tour", tour_card_place(subject.width > 1.0F ? subject : whole, whole), tour_, frame,
              out);
}

void MainWindow::draw_overlays(const FrameContext& frame, const Layout& layout, Requests& out) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const Rect whole = {0, 0, size.x, size.y};
    if (frame.files.open) draw_card("files", card_place(whole, 620, 560), files_, frame, out);
    if (frame.help_shown) draw_card("help", card_place(whole, 860, 640), help_, frame, out);
    if (frame.samples != nullptr && frame.samples->open)
        draw_card("samples", card_place(whole, 780, 560), samples_, frame, out);
    if (frame.tour_step >= 0) draw_tour(frame, whole, out);
    if (frame.notice == nullptr) return;
    begin_overlay("notice", notice_place(layout.viewport, frame.notice->text), {px(18), px(10)},
                  px(4));
    notice_.draw(frame, out);
    end_overlay();
}

}  // namespace cambrian
