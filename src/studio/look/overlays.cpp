#include "studio/look/overlays.h"

#include <array>

namespace cambrian {
namespace {

constexpr std::array kOverlays = {
    OverlayKind{"grid", "Grid", "Lines at each metre, or at equal parts of it, without scenery.",
                &OverlaysShown::grid},
    OverlayKind{"ruler", "Ruler", "Distances along the ground, in metres, with scenery.",
                &OverlaysShown::ruler},
    OverlayKind{"trail", "Trail", "The path of the centre of mass in the last six seconds.",
                &OverlaysShown::trail},
    OverlayKind{"contacts", "Touching faces",
                "Faces light up while they touch the ground or another part.",
                &OverlaysShown::contacts},
    OverlayKind{"forces", "Contact forces",
                "The force at each point of contact. A line of a third of a metre is a force as "
                "large as the creature's weight.",
                &OverlaysShown::forces},
    OverlayKind{"center-of-mass", "Centre of mass", "The centre of mass of the body.",
                &OverlaysShown::center_of_mass},
    OverlayKind{"torques", "Joint torques",
                "The torque of each joint's motor, as an arc in its direction. A longer and redder "
                "arc is nearer to the motor's limit.",
                &OverlaysShown::torques},
    OverlayKind{"limits", "Joint limits",
                "The range of each joint, with a needle at its present position.",
                &OverlaysShown::limits},
    OverlayKind{"sensors", "Sensors",
                "The readings of the brain: a dot for each sensor, brighter the closer its reading "
                "is to 1, lit for a face while it touches, and an arc for each joint angle.",
                &OverlaysShown::sensors},
    OverlayKind{"sounds", "Sounds",
                "What can be heard: a dot at each voice and impact, and rings where a half, a "
                "quarter and an eighth of a full sound are left. Band 1 is blue, 2 orange, 3 green "
                "and 4 red.",
                &OverlaysShown::sounds},
    OverlayKind{"scent", "Scent",
                "The scent around, as a pink tint that is stronger where a nose reads more. In a "
                "trial only the creature's own glands give off scent.",
                &OverlaysShown::scent},
    OverlayKind{"names", "Part names", "The number of each part and the gene it grew from.",
                &OverlaysShown::names},
};

}  // namespace

std::span<const OverlayKind> overlay_kinds() {
    return kOverlays;
}

std::optional<Scenery> scenery_named(std::string_view name) {
    for (std::size_t i = 0; i < kSceneryNames.size(); ++i)
        if (name == kSceneryNames[i]) return static_cast<Scenery>(i);
    return std::nullopt;
}

const DrawnWorld* shown_world(const ViewState& view, Scenery scenery,
                              const Environment& environment) {
    if (scenery == Scenery::kPlain || view.look == LookMode::kMechanics) return nullptr;
    return &drawn_world(world_kind_of(environment), daytime_of(view.theme));
}

}  // namespace cambrian
