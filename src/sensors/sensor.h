#pragma once

// A registered sensor: reads channels of one part. Channel numbers are absolute: the registry's
// order, each kind's channels consecutive.

#include "core/registry.h"
#include "world/body_view.h"

#include <string>
#include <vector>

namespace cambrian {

struct SensorChannel {
    std::string id;  // "joint", "contact-distal", ...
    std::string label;
};

struct SensorKind {
    // Reading of one of the kind's channels on a part. handedness is +1, or -1 on mirrored parts,
    // whose left and right are exchanged and whose joint is mirrored too (creature/README.md 2).
    using Read = double (*)(const BodyView& body, std::size_t part, std::size_t channel,
                            int handedness);

    // Where on a part a lamp shows the reading of one of the kind's channels: a point in the part's
    // frame, as shares of its half extents.
    using Spot = Vec3 (*)(std::size_t channel, int handedness);

    std::string id;
    std::string label;
    std::vector<SensorChannel> channels;
    Read read = nullptr;
    // The reading is the joint's coordinate: genes want it in lengths of the part where the joint
    // slides (creature/README.md 7), and sliding has no handedness.
    bool reads_joint = false;  // then it is drawn along the joint's motion
    Spot spot = nullptr;       // without one, the lamp is in the middle of the part
};

using SensorRegistry = Registry<SensorKind>;

SensorRegistry builtin_sensors();

}  // namespace cambrian
