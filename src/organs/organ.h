#pragma once

// A registered kind of organ: what a part does with a signal besides moving its joint
// (creature/README.md 9).

#include "core/registry.h"
#include "world/emissions.h"
#include "world/physics_scene.h"
#include "world/scene_settings.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

// A number that genes give each organ of a kind.
struct OrganParameter {
    const char* name;  // in messages: "band"
    const char* key;   // in files
    double low = 0.0;  // range, both ends included
    double high = 1.0;
    double fallback = 0.0;  // of a new organ
    bool whole = false;     // only whole numbers are in range
    const char* unit = "";
    const char* help = "";  // what it means, in a sentence
};

// The part that an organ belongs to.
struct OrganSite {
    PhysicsScene& scene;
    const PlannedPart& part;
    std::size_t index = 0;               // index of the part
    std::span<const double> parameters;  // as many as the kind has
    double dt = 0.0;                     // s, length of the tick
    double smoothing_share = 1.0;        // of the targets of muscles, in the tick
    double& memory;                      // a number of the organ's own, 0 at birth
};

// The look of an organ on its part.
enum class OrganMark : std::uint8_t { kArcs, kDots, kArrows, kMouth };

struct OrganKind {
    // Uses a signal (within +-10, weight included) for one tick. Adds at most one sound and one
    // scent, and only of the sorts that its kind says it gives off.
    using Act = void (*)(const OrganSite& site, double signal, Emissions& emissions);
    // Makes a grown part deformable.
    using Shape = void (*)(std::span<const double> parameters, const SceneSettings& settings,
                           PlannedPart& part);
    // Returns what an organ does, in one sentence.
    using Words = std::string (*)(std::span<const double> parameters);

    std::string id;
    std::string label;
    std::vector<OrganParameter> parameters = {};  // at most 2
    Act act = nullptr;
    Words words = nullptr;
    // Place on the part, along its length from the middle, as a share of its half length.
    double place = 0.0;
    OrganMark mark = OrganMark::kDots;
    bool sounds = false;    // gives off sound
    bool scents = false;    // gives off scent
    bool eats = false;      // its part eats in a preserve; its first parameter is the diet
    Shape shape = nullptr;  // of a muscle of the part itself, of which a part has at most one
};

using OrganRegistry = Registry<OrganKind>;

OrganRegistry builtin_organs();

}  // namespace cambrian
