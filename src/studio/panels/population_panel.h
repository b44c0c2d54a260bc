#pragma once

#include "studio/panel.h"
#include "studio/phenotype_cache.h"
#include "studio/ui_context.h"

namespace cambrian {

// The newest finished generation, best first, a tile a creature; a click shows it.
class PopulationPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void draw_tile(std::size_t rank, const FrameContext& frame, Requests& out);

    PhenotypeCache bodies_;
};

}  // namespace cambrian
