#pragma once

#include "studio/frame/panel.h"
#include "studio/widgets/phenotype_cache.h"

namespace cambrian {

// Shows the creatures that were kept while picking; they can be put back into any grid.
class ShelfPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void draw_tile(std::size_t place, const FrameContext& frame, Requests& out);

    PhenotypeCache bodies_;
};

}  // namespace cambrian
