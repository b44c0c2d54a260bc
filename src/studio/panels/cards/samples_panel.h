#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// The creatures that come with the program, one tile each; a click puts one on show.
class SamplesPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void draw_tiles(const SampleShelf& shelf, Requests& out);
    void move_by_keys(std::size_t count, int columns);

    std::size_t aimed_ = 0;  // by the keyboard
};

}  // namespace cambrian
