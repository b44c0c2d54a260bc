#include "studio/look/overlays.h"

#include <array>

namespace cambrian {
namespace {

constexpr std::array kOverlays = {
    OverlayKind{"grid", "Grid", "Lines at metres or parts of them.", &OverlaysShown::grid},
    OverlayKind{"trail", "Trail", "Where the centre of mass was in the last six seconds.",
                &OverlaysShown::trail},
    OverlayKind{"contacts", "Touching faces",
                "Faces light up while they touch the ground or another part.",
                &OverlaysShown::contacts},
    OverlayKind{"forces", "Contact forces",
                "A line from each touching point; as long as a third of a metre for a force of "
                "the creature's weight.",
                &OverlaysShown::forces},
    OverlayKind{"center-of-mass", "Centre of mass", "The centre of mass of the body.",
                &OverlaysShown::center_of_mass},
    OverlayKind{"torques", "Joint torques",
                "An arc at each joint, the way its motor pushes; the longer and redder, the nearer "
                "to the most it can.",
                &OverlaysShown::torques},
    OverlayKind{"limits", "Joint limits",
                "The range of each joint, with a needle at its present position.",
                &OverlaysShown::limits},
    OverlayKind{"sensors", "Sensors",
                "What the brain reads: a dot for each face it feels, lit while it touches, and an "
                "arc for each joint angle.",
                &OverlaysShown::sensors},
    OverlayKind{"names", "Part names", "The number of each part and the gene it grew from.",
                &OverlaysShown::names},
};

}  // namespace

std::span<const OverlayKind> overlay_kinds() {
    return kOverlays;
}

}  // namespace cambrian
