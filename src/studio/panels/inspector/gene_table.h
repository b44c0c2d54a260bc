#pragma once

// Editable rows for the genes of one part; the root's include the central brain.

#include "creature/kinds.h"
#include "genome/genome.h"
#include "studio/viewer/gene_editor.h"

#include <optional>

namespace cambrian {

struct GeneEdit {
    std::optional<GeneChange> change;  // the edit of this frame, if any
    bool begun = false;                // a control became active
    bool finished = false;             // the control was released
};

// Edits `genome` in place. A typed number may lie outside the gene's range, so the caller must
// validate the genome.
GeneEdit gene_table(Genome& genome, std::size_t node, const Kinds& kinds);

}  // namespace cambrian
