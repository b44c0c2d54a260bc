#pragma once

#include "world/environment.h"

#include <span>

namespace cambrian {

struct EnvironmentPreset {
    const char* label;
    const char* help;
    // Keeps the density of bodies, which is not the world's.
    Environment (*apply)(Environment present);
};

std::span<const EnvironmentPreset> environment_presets();

}  // namespace cambrian
