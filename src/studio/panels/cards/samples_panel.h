#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Shows the sample creatures as tiles; a click displays one.
class SamplesPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;
    // Draws the tiles alone.
    void draw_tiles(const SampleLibrary& library, Requests& out);

private:
    void move_by_keys(std::size_t count, int columns);

    std::size_t aimed_ = 0;  // index of the tile chosen with the keyboard
};

}  // namespace cambrian
