#include "studio/panels/inspector/network_drawing.h"

#include "core/text/pretty_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kFullColor = 2.0;  // value at full colour; most signals are within +-2

}  // namespace

Color value_color(double value) {
    const auto share = static_cast<float>(std::clamp(std::fabs(value) / kFullColor, 0.0, 1.0));
    const Color& end = value >= 0.0 ? colors().plot_best : colors().plot_median;
    return mix(colors().raised, end, share);
}

std::string words_for(const BrainNode& node, double value) {
    const char* kind = node.kind == BrainNodeKind::kSensor   ? "Sensor"
                       : node.kind == BrainNodeKind::kNeuron ? "Neuron"
                                                             : "Effector";
    const std::string where =
        node.part < 0 ? std::string("central brain") : fmt::format("part {}", node.part);
    return fmt::format("{}: {}\n{}\nNow {}", kind, node.label, where, pretty_number(value));
}

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

ImVec2 point_of(const BrainGraph& graph, const Rect& area, std::size_t node) {
    const GraphPoint& place = graph.nodes[node].place;
    return {area.x + place.x * area.width, area.y + place.y * area.height};
}

void draw_links(ImDrawList& list, const BrainGraph& graph, const Rect& area) {
    for (const BrainLink& link : graph.links) {
        const ImVec2 from = point_of(graph, area, link.edge.from);
        const ImVec2 to = point_of(graph, area, link.edge.to);
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

}  // namespace cambrian
