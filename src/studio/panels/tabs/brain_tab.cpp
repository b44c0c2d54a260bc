#include "studio/panels/tabs/brain_tab.h"

#include "studio/plot.h"
#include "studio/text.h"
#include "studio/widgets.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr std::size_t kHistoryLength = 180;  // ticks: 3 s
constexpr std::size_t kMostInRow = 7;
constexpr float kHistoryHeight = 84.0F;
constexpr double kFullColor = 2.0;  // signals are mostly within +-2

// Orange for positive, blue for negative, grey for none.
Color value_color(double value) {
    const auto share = static_cast<float>(std::clamp(std::fabs(value) / kFullColor, 0.0, 1.0));
    const Color& end = value >= 0.0 ? colors().plot_best : colors().plot_median;
    return mix(colors().raised, end, share);
}

double value_of(const BrainNode& node, const Brain& brain) {
    if (node.kind == BrainNodeKind::kEffector) return brain.output(node.index);
    return brain.value(static_cast<Slot>(node.index));
}

std::string words_for(const BrainNode& node, double value) {
    const char* kind = node.kind == BrainNodeKind::kSensor   ? "Sensor"
                       : node.kind == BrainNodeKind::kNeuron ? "Neuron"
                                                             : "Effector";
    const std::string where =
        node.part < 0 ? std::string("central brain") : "part " + std::to_string(node.part);
    return std::string(kind) + ": " + node.label + "\n" + where + "\nNow " + pretty_number(value);
}

struct ShapeStyle {
    Color fill;
    Color rim;
    float rim_width;
};

void draw_shape(ImDrawList& list, BrainNodeKind kind, const ImVec2& at, float radius,
                const ShapeStyle& style) {
    if (kind == BrainNodeKind::kNeuron) {
        list.AddCircleFilled(at, radius, paint(style.fill), 20);
        list.AddCircle(at, radius, paint(style.rim), 20, style.rim_width);
        return;
    }
    const float rounding = kind == BrainNodeKind::kSensor ? 0.0F : px(4);
    const ImVec2 low = {at.x - radius, at.y - radius};
    const ImVec2 high = {at.x + radius, at.y + radius};
    list.AddRectFilled(low, high, paint(style.fill), rounding);
    list.AddRect(low, high, paint(style.rim), rounding, ImDrawFlags_None, style.rim_width);
}

}  // namespace

void BrainTab::rebuild(const FrameContext& frame) {
    phenotype_ = frame.playback.shared_phenotype();
    graph_ = brain_graph(*phenotype_, frame.kinds.creature, kMostInRow);
    histories_.assign(graph_.nodes.size(), {});
    chosen_ = 0;
    seen_tick_ = 0;
}

void BrainTab::watch(const FrameContext& frame) {
    const std::uint64_t tick = frame.playback.trial().ticks();
    if (tick == seen_tick_) return;
    seen_tick_ = tick;
    const Brain& brain = frame.playback.trial().creature().brain();
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
        std::vector<float>& history = histories_[i];
        if (history.size() == kHistoryLength) history.erase(history.begin());
        history.push_back(static_cast<float>(value_of(graph_.nodes[i], brain)));
    }
}

ImVec2 BrainTab::point_of(const Rect& area, std::size_t node) const {
    const GraphPoint& place = graph_.nodes[node].place;
    return {area.x + place.x * area.width, area.y + place.y * area.height};
}

void BrainTab::draw(const FrameContext& frame, Requests& out) {
    if (phenotype_ != frame.playback.shared_phenotype()) rebuild(frame);
    watch(frame);
    muted_text("Sensors on top, joints at the bottom. Orange is positive, blue negative.");
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float rows = static_cast<float>(graph_.row_count);
    const float height = std::max(room.y - px(kHistoryHeight + 30), rows * px(30));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect area = {at.x, at.y, room.x, height};
    draw_links(area);
    draw_nodes(area, frame, out);
    ImGui::SetCursorScreenPos({at.x, at.y + height});
    draw_history();
}

void BrainTab::draw_links(const Rect& area) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (const BrainLink& link : graph_.links) {
        const ImVec2 from = point_of(area, link.edge.from);
        const ImVec2 to = point_of(area, link.edge.to);
        const auto weight = static_cast<float>(std::min(4.0, std::fabs(link.weight)));
        const Color& tint = link.weight >= 0.0 ? colors().plot_best : colors().plot_median;
        const ImU32 color = paint(with_alpha(tint, 0.2F + 0.1F * weight));
        const float width = px(0.8F + 0.35F * weight);
        if (link.edge.from == link.edge.to) {
            list.AddCircle({from.x + px(9), from.y - px(9)}, px(8), color, 16, width);
            continue;
        }
        const float bend = 0.5F * (to.y - from.y);
        list.AddBezierCubic(from, {from.x, from.y + bend}, {to.x, to.y - bend}, to, color, width,
                            14);
    }
}

void BrainTab::draw_nodes(const Rect& area, const FrameContext& frame, Requests& out) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Brain& brain = frame.playback.trial().creature().brain();
    const float radius = px(9);
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
        const BrainNode& node = graph_.nodes[i];
        const ImVec2 at = point_of(area, i);
        ImGui::SetCursorScreenPos({at.x - radius, at.y - radius});
        ImGui::PushID(static_cast<int>(i));
        ImGui::InvisibleButton("node", {2 * radius, 2 * radius});
        ImGui::PopID();
        const double value = value_of(node, brain);
        const bool lit =
            node.part >= 0 &&
            frame.highlight.covers(static_cast<std::size_t>(node.part),
                                   phenotype_->parts[static_cast<std::size_t>(node.part)]);
        const bool strong = lit || i == chosen_;
        draw_shape(
            list, node.kind, at, radius,
            {value_color(value), strong ? colors().text : colors().faint, strong ? px(2) : px(1)});
        if (!ImGui::IsItemHovered()) continue;
        chosen_ = i;
        if (node.part >= 0) out.ask(ShowHighlight{{.part = node.part}});
        tooltip(words_for(node, value));
    }
}

void BrainTab::draw_history() const {
    if (chosen_ >= graph_.nodes.size()) return;
    const std::vector<float>& history = histories_[chosen_];
    caption(graph_.nodes[chosen_].label + ", the last 3 s");
    if (history.size() < 2) return;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect area = {at.x, at.y, ImGui::GetContentRegionAvail().x, px(kHistoryHeight - 24)};
    double most = 1.0;
    std::vector<double> xs;
    std::vector<double> ys;
    for (std::size_t i = 0; i < history.size(); ++i) {
        xs.push_back(static_cast<double>(kHistoryLength - history.size() + i));
        ys.push_back(static_cast<double>(history[i]));
        most = std::max(most, std::fabs(ys.back()));
    }
    const PlotScale scale{area, 0.0, static_cast<double>(kHistoryLength - 1), -most, most};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(area.low(), area.high(), paint(with_alpha(colors().raised, 0.5F)), px(4));
    const float zero = std::floor(scale.y_at(0.0)) + 0.5F;
    list.AddLine({area.x, zero}, {area.x + area.width, zero}, paint(colors().border));
    draw_curve(list, scale, xs, ys, colors().accent, px(1.5F));
    ImGui::Dummy({area.width, area.height});
}

}  // namespace cambrian
