#pragma once

#include "studio/frame/panel.h"
#include "studio/look/ui_context.h"
#include "studio/panels/inspector/brain_graph.h"

#include <cstddef>
#include <memory>

namespace cambrian {

// Shows the network at work. Each node has the colour of its present value over a short history;
// links are coloured by weight. A clicked node gets a longer history and, if it is a neuron, a
// slider that forces its value. Pointing at a node highlights its part on the body, and the
// reverse.
class BrainTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void rebuild(const FrameContext& frame);
    void draw_nodes(const Rect& area, const FrameContext& frame, Requests& out);
    void draw_history(const FrameContext& frame) const;
    void draw_force(const FrameContext& frame, Requests& out);
    bool is_forced(const FrameContext& frame, const BrainNode& node) const;
    std::size_t neuron_of(const BrainNode& node) const;

    std::shared_ptr<const Phenotype> phenotype_;  // the phenotype whose graph is shown
    BrainGraph graph_;
    std::size_t chosen_ = 0;  // index of the node clicked last
};

}  // namespace cambrian
