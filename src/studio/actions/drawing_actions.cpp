// What keys do on the paper on which a creature is drawn.

#include "sketch/part_edits.h"
#include "studio/actions/subjects.h"

namespace cambrian {
namespace {

void turn_mirror(const FrameContext& frame, Requests& out) {
    const int next = (static_cast<int>(frame.viewer.drawing.mirror) + 1) % 3;
    out.ask(MirrorNewParts{static_cast<MirrorSides>(next)});
}

template <int Steps>
void repeat_chosen(const FrameContext& frame, Requests& out) {
    const Exhibit& exhibit = frame.viewer.playback.exhibit();
    const BodySketch sketch = sketch_of(
        *exhibit.genome(),
        {frame.kinds.creature, exhibit.settings().expression, exhibit.settings().world.scene});
    if (!frame.viewer.drawing.chosen) return;
    const auto part = find_part(sketch, *frame.viewer.drawing.chosen);
    if (!part) return;
    const int times = repeats_of(sketch, *part) + Steps;
    if (times >= 1 && times <= gene_range::kMaxRecursion) out.ask(RepeatPart{times});
}

bool has_strokes(const FrameContext& frame) {
    return frame.viewer.genes != nullptr && frame.viewer.genes->can_undo();
}
bool had_strokes(const FrameContext& frame) {
    return frame.viewer.genes != nullptr && frame.viewer.genes->can_redo();
}
void undo_stroke(const FrameContext& frame, Requests& out) {
    if (has_strokes(frame)) out.ask(UndoEdit{});
}
void redo_stroke(const FrameContext& frame, Requests& out) {
    if (had_strokes(frame)) out.ask(RedoEdit{});
}

bool has_chosen(const FrameContext& frame) {
    return frame.viewer.drawing.chosen.has_value();
}

}  // namespace

std::vector<Action> drawing_actions() {
    // clang-format off
    return {
        {"play", "P or Enter", "Lay the pen down and play the creature", asks<ToggleDrawing{}>},
        {"undo", "Ctrl+Z", "Take the last stroke back", undo_stroke, has_strokes},
        {"redo", "Ctrl+Shift+Z", "Draw it again", redo_stroke, had_strokes},
        {"mirror-new", "M", "Mirror new parts", turn_mirror, {}, {}, "Left and right, above and below, or no longer."},
        {"mirror-chosen", "Shift+M", "The chosen part on both sides, or on one", asks<SwitchPair{}>, has_chosen},
        {"repeat-more", "Plus", "Repeat the chosen part once more", repeat_chosen<1>, has_chosen, {}, "In a row, each at the end of the one before."},
        {"repeat-less", "Minus", "Repeat it once less", repeat_chosen<-1>, has_chosen},
        {"remove-chosen", "Delete or Backspace", "Remove the chosen part", asks<RemovePart{}>, has_chosen, {}, "With all that grows from it."},
    };
    // clang-format on
}

}  // namespace cambrian
