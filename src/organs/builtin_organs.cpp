#include "organs/kinds.h"

namespace cambrian {

// Digests of genes include numbers of kinds in this order, so new kinds must be added at the end.
OrganRegistry builtin_organs() {
    OrganRegistry organs;
    add_sound_organ(organs);
    add_scent_organ(organs);
    add_deformer_organ(organs);
    add_mouth_organ(organs);
    return organs;
}

}  // namespace cambrian
