#pragma once

#include "studio/frame/panel.h"
#include "studio/panels/inspector/ancestry.h"
#include "studio/widgets/phenotype_cache.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

// The line of parents down to the first ancestor: each one's body, what changed in it and what
// that gained. A click shows it; the line stays while one of its members is on show.
class AncestryTab final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void follow(const Exhibit& shown);
    void draw_step(std::size_t index, const FrameContext& frame, Requests& out);
    void draw_body(std::size_t index, const FrameContext& frame, const ImVec2& at);

    std::shared_ptr<const Exhibit> head_;  // the line is of
    std::vector<AncestryStep> line_;
    PhenotypeCache bodies_;
};

}  // namespace cambrian
