#pragma once

#include "studio/frame/panel.h"
#include "studio/look/ui_context.h"
#include "studio/widgets/graph_layout.h"

#include <cstddef>
#include <vector>

namespace cambrian {

// Shows the directed graph of part genes: the body of each node, its edges and their recursive
// limits. Pointing at a node highlights every part grown from it. A click keeps them highlighted
// and shows the node's genes for editing.
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

    GenomePtr genome_;  // the genome whose graph is shown
    std::vector<GraphPoint> points_;
    std::size_t row_count_ = 1;
    std::size_t chosen_ = 0;  // index of the node whose genes are shown
    bool lit_ = false;        // its parts stay highlighted
    Rect area_;
};

// Returns the number of edges from the root to each node; nodes that cannot be reached get the
// largest number.
std::vector<std::size_t> steps_from_root(const Genome& genome);

}  // namespace cambrian
