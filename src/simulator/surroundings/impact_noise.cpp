#include "simulator/surroundings/impact_noise.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kLeastImpulse = 0.02;  // N s; smaller impacts are silent
constexpr double kFullImpulse = 0.5;    // N s; larger impacts are no louder

}  // namespace

void add_noise(std::span<const SceneImpact> impacts, std::vector<Sound>& sounds) {
    for (const SceneImpact& impact : impacts) {
        if (!(impact.impulse > kLeastImpulse)) continue;
        const bool on_ground = impact.other_part < 0 && impact.other_scene == nullptr;
        const int band = on_ground ? kGroundBand : kCreatureBand;
        sounds.push_back({impact.point, band, std::min(1.0, impact.impulse / kFullImpulse)});
    }
}

}  // namespace cambrian
