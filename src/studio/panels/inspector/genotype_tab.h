#pragma once

#include "studio/frame/panel.h"
#include "studio/look/ui_context.h"
#include "studio/widgets/graph_layout.h"

#include <cstddef>
#include <vector>

namespace cambrian {

// The directed graph of part genes: what each node grows into, which node follows which, how often
// it repeats. Pointing at a node lights every part grown from it; a click keeps them lit and shows
// the node's genes, to be edited.
class GenotypeTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void rebuild(const GenomePtr& genome);
    ImVec2 point_of(std::size_t node) const;
    void draw_edges() const;
    void draw_nodes(const FrameContext& frame, Requests& out);
    void draw_heading(const FrameContext& frame, Requests& out) const;
    void draw_genes(const FrameContext& frame, Requests& out) const;

    GenomePtr genome_;  // the graph is of
    std::vector<GraphPoint> points_;
    std::size_t row_count_ = 1;
    std::size_t chosen_ = 0;  // node whose genes are shown
    bool lit_ = false;        // its parts stay lit
    Rect area_;
};

// Steps from the root along the edges; nodes that cannot be reached come after all others.
std::vector<std::size_t> steps_from_root(const Genome& genome);

}  // namespace cambrian
