#pragma once

// The genes of one part, and the central brain with the root's, as rows to edit by hand.

#include "creature/kinds.h"
#include "genome/genome.h"
#include "studio/viewer/gene_editor.h"

#include <optional>

namespace cambrian {

struct GeneEdit {
    std::optional<GeneChange> change;  // made to the genome this frame
    bool finished = false;             // the control was let go
};

// Edits `genome` in place. Typed numbers may lie outside the genes' ranges: whoever takes the
// genome validates it.
GeneEdit gene_table(Genome& genome, std::size_t node, const Kinds& kinds);

}  // namespace cambrian
