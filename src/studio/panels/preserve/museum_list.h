#pragma once

#include "studio/frame/panel.h"
#include "studio/widgets/phenotype_cache.h"

#include <cstddef>

namespace cambrian {

// The museum of a preserve: a drawing of each creature, why it is there and since when.
class MuseumList final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void draw_pieces(const FrameContext& frame, Requests& out);
    bool draw_piece(const FrameContext& frame, std::size_t index);

    PhenotypeCache bodies_;
    std::size_t seen_ = 0;  // index of the chosen one
};

}  // namespace cambrian
