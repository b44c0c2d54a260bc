#pragma once

#include "sketch/body_sketch.h"
#include "sketch/rhythm.h"
#include "studio/frame/panel.h"

#include <optional>

namespace cambrian {

// The line below the paper on which a creature is drawn: what is done to the chosen part, and the
// rhythm of its joints.
class DrawingStrip final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void follow(const FrameContext& frame);
    void draw_part(const FrameContext& frame, Requests& out) const;
    void draw_rhythm(Requests& out);
    struct RhythmRow;
    bool rhythm_slider(const RhythmRow& row, Rhythm& rhythm, Requests& out);

    GenomePtr genome_;  // that was sketched
    BodySketch sketch_;
    std::optional<Rhythm> rhythm_;
    Rhythm given_;          // the last one seen
    bool sliding_ = false;  // one of the sliders is held
};

}  // namespace cambrian
