#pragma once

// What is done to a chosen part of a drawn body besides strokes (sketch/README.md 2). All return
// valid genomes.

#include "core/result.h"
#include "sketch/strokes.h"

namespace cambrian {

// Removes a part and all that grows from it: its mirror image, too; of a repetition, it and the
// copies after it. Must not be the root.
Genome remove_part(const BodySketch& sketch, std::size_t part, const SketchRules& rules);

// Returns how often a part occurs in a row: 1 unless its node has an edge to itself.
int repeats_of(const BodySketch& sketch, std::size_t part);
// Lets a part occur so often, 1 to kMaxRecursion, one at the end of the other. Fails if the part
// carries too many others already.
Result<Genome> repeat_part(const BodySketch& sketch, std::size_t part, int times,
                           const SketchRules& rules);

bool is_paired(const BodySketch& sketch, std::size_t part);
// Gives a part, but not the root, a mirror image, or takes it away. Fails where the image would
// not grow.
Result<Genome> switch_pair(const BodySketch& sketch, std::size_t part, MirrorSides sides,
                           const SketchRules& rules);

}  // namespace cambrian
