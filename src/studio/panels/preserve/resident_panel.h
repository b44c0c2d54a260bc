#pragma once

#include "studio/frame/panel.h"
#include "studio/panels/inspector/brain_graph.h"

#include <memory>

namespace cambrian {

// The life of the picked creature of a preserve.
class ResidentPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void draw_picked(const FrameContext& frame, Requests& out);
    void draw_brain(const FrameContext& frame);

    std::shared_ptr<const Phenotype> phenotype_;  // the phenotype whose network is shown
    BrainGraph graph_;
};

}  // namespace cambrian
