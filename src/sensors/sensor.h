#pragma once

// A registered sensor: reads channels of one part. Channel numbers are absolute: the registry's
// order, each kind's channels consecutive.

#include "core/registry.h"
#include "world/body_view.h"
#include "world/surroundings.h"

#include <string>
#include <vector>

namespace cambrian {

struct SensorChannel {
    std::string id;  // "joint", "contact-distal", ...
    std::string label;
};

// What a sensor is read from: its part in the body and in the world.
struct SensorSite {
    const BodyView& body;
    const Surroundings& surroundings;
    const PlannedPart& part;
    std::size_t index = 0;    // of the part
    std::size_t channel = 0;  // of the kind
    // +1, or -1 on mirrored parts, whose left and right are exchanged and whose joint is mirrored
    // too (creature/README.md 2).
    int handedness = 1;
    double dt = 0.0;  // s, since the last reading; 0 reads once more what was read last
};

struct SensorKind {
    // Reading of one channel. `memory` is one value a wired sensor, 0 at birth.
    using Read = double (*)(const SensorSite& site, double& memory);

    // Where on a part a lamp shows the reading of one of the kind's channels: a point in the part's
    // frame, as shares of its half extents.
    using Spot = Vec3 (*)(std::size_t channel, int handedness);

    std::string id;
    std::string label;
    std::vector<SensorChannel> channels;
    Read read = nullptr;
    // The reading is the joint's coordinate: genes want it in lengths of the part where the joint
    // slides (creature/README.md 7), and sliding has no handedness.
    bool reads_joint = false;   // then it is drawn along the joint's motion
    Spot spot = nullptr;        // without one, the lamp is in the middle of the part
    bool reads_forces = false;  // needs BodyPlan::measures_forces
    bool usual = true;  // whether founders and mutations use it unless settings say otherwise
};

using SensorRegistry = Registry<SensorKind>;

SensorRegistry builtin_sensors();

}  // namespace cambrian
