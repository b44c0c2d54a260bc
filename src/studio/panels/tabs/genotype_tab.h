#pragma once

#include "studio/graph_layout.h"
#include "studio/panel.h"
#include "studio/ui_context.h"

#include <cstddef>
#include <vector>

namespace cambrian {

// The directed graph of part genes: what each node grows into, which node follows which, how often
// it repeats. Pointing at a node lights every part grown from it.
class GenotypeTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void rebuild(const GenomePtr& genome);
    ImVec2 point_of(std::size_t node) const;
    void draw_edges() const;
    void draw_nodes(const FrameContext& frame, Requests& out);
    void draw_facts(const FrameContext& frame) const;

    GenomePtr genome_;  // the graph is of
    std::vector<GraphPoint> points_;
    std::size_t row_count_ = 1;
    std::size_t chosen_ = 0;
    Rect area_;
};

// Steps from the root along the edges; nodes that cannot be reached come after all others.
std::vector<std::size_t> steps_from_root(const Genome& genome);

}  // namespace cambrian
