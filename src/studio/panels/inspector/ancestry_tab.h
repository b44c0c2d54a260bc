#pragma once

#include "studio/frame/panel.h"
#include "studio/panels/inspector/ancestry.h"
#include "studio/widgets/phenotype_cache.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

// Shows the line of parents down to the first ancestor: their bodies, what changed and the fitness
// gained. A click displays an ancestor; the line stays while one of its members is displayed.
class AncestryTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void follow(const Exhibit& shown);
    void draw_step(std::size_t index, const FrameContext& frame, Requests& out);
    void draw_body(std::size_t index, const FrameContext& frame, const ImVec2& at);

    std::shared_ptr<const Exhibit> head_;  // the creature whose line is shown
    std::vector<AncestryStep> line_;
    PhenotypeCache bodies_;
};

}  // namespace cambrian
