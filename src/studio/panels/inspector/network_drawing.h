#pragma once

// The parts of which pictures of a network are drawn.

#include "studio/look/ui_context.h"
#include "studio/panels/inspector/brain_graph.h"

#include <cstddef>
#include <string>

namespace cambrian {

// Returns orange for positive values, blue for negative ones, grey for zero.
Color value_color(double value);

// Returns what a node is and its present value, in words.
std::string words_for(const BrainNode& node, double value);

struct ShapeStyle {
    Color fill;
    Color rim;
    float rim_width;
};

void draw_shape(ImDrawList& list, BrainNodeKind kind, const ImVec2& at, float radius,
                const ShapeStyle& style);

ImVec2 point_of(const BrainGraph& graph, const Rect& area, std::size_t node);
void draw_links(ImDrawList& list, const BrainGraph& graph, const Rect& area);

}  // namespace cambrian
