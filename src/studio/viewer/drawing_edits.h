#pragma once

// What the user does to a drawn body besides strokes, with the words of each edit.

#include "core/result.h"
#include "studio/viewer/viewer_contract.h"

namespace cambrian {

struct DrawnBody {
    BodySketch sketch;
    SketchRules rules;
    const DrawingView& drawing;
};
struct DrawnEdit {
    Genome genome;
    GeneChange change;
    bool is_complete = true;  // false for that of a slider, which goes on
};

// Change the chosen part. They fail, in words, where there is none or where its genes do not allow
// it.
Result<DrawnEdit> without_chosen(const DrawnBody& body);
Result<DrawnEdit> with_repeats(const DrawnBody& body, int times);
Result<DrawnEdit> with_pair_switched(const DrawnBody& body);

Result<DrawnEdit> with_given_rhythm(const DrawnBody& body, const Rhythm& rhythm);

}  // namespace cambrian
