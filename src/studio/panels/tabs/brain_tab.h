#pragma once

#include "studio/brain_graph.h"
#include "studio/panel.h"
#include "studio/ui_context.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace cambrian {

// The network at work: nodes coloured by their present value, links by weight, and the recent
// history of the node under the mouse. What is pointed at lights up on the body, and the other way
// round.
class BrainTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void rebuild(const FrameContext& frame);
    void watch(const FrameContext& frame);
    void draw_links(const Rect& area) const;
    void draw_nodes(const Rect& area, const FrameContext& frame, Requests& out);
    void draw_history() const;
    ImVec2 point_of(const Rect& area, std::size_t node) const;

    std::shared_ptr<const Phenotype> phenotype_;  // the graph is of
    BrainGraph graph_;
    std::size_t chosen_ = 0;  // node whose history is shown
    std::uint64_t seen_tick_ = 0;
    std::vector<std::vector<float>> histories_;  // one a node, newest last
};

}  // namespace cambrian
