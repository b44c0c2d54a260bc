#pragma once

#include "breeding/mutation_kind.h"

namespace cambrian {

// Changes numbers of a valid genome and leaves its structure unchanged (breeding/README.md 9):
// either by small random steps, all or three tenths of them at once, or by repeating the step that
// led to the genome from that of its mother, `before`, if that has the same structure; or by both.
// `before` is null if it is unknown. Numbers of one kind that are equal stay equal. Describes the
// change.
MutationRecord tune(Genome& genome, const Genome* before, const KindCatalog& catalog,
                    RandomStream& stream);

}  // namespace cambrian
