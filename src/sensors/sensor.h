#pragma once

// A registered kind of sensor, which reads channels of one part. Channels are numbered in the
// registry's order; each kind's channels are consecutive.

#include "core/registry.h"
#include "world/body_view.h"
#include "world/joint_kind.h"
#include "world/surroundings.h"

#include <string>
#include <vector>

namespace cambrian {

struct SensorChannel {
    std::string id;  // "joint", "contact-distal", ...
    std::string label;
};

// The part that a sensor belongs to, in its body and in the world.
struct SensorSite {
    const BodyView& body;
    const Surroundings& surroundings;
    const PlannedPart& part;
    std::size_t index = 0;    // index of the part
    std::size_t channel = 0;  // channel of the kind
    Mirror mirror = {};       // of the part, and of its joint
    // Share of the way from the last reading to the present value, for smoothing
    // (SensorKind::time_constant); 0 repeats the last reading.
    double share = 1.0;
};

struct SensorKind {
    // Returns the reading of one channel. `memory` is one value per wired sensor, 0 at birth.
    using Read = double (*)(const SensorSite& site, double& memory);

    // Returns the point of a part where a lamp displays the channel's reading: in the part's frame,
    // as shares of its half extents.
    using Spot = Vec3 (*)(std::size_t channel, int handedness);

    std::string id;
    std::string label;
    std::string group = {};  // of senses that settings show together; the label of the group
    std::vector<SensorChannel> channels;
    Read read = nullptr;
    // The reading is the joint's coordinate. For a sliding joint, genes use lengths of the part
    // (creature/README.md 7), and mirroring has no effect.
    bool reads_joint = false;    // it is drawn along the joint's motion
    Spot spot = nullptr;         // if null, the lamp is in the middle of the part
    double time_constant = 0.0;  // s, time constant of smoothing; 0 for none
    bool reads_forces = false;   // needs PlannedPart::measures_forces
    bool smells = false;         // reads Surroundings::scent
    bool sees = false;           // reads Surroundings::light
    // Reads Surroundings::distance_to_ground or ground_height.
    bool feels_ground = false;
    bool usual = true;  // enabled in founders and mutations by default
};

using SensorRegistry = Registry<SensorKind>;

SensorRegistry builtin_sensors();
// Returns those of bodies in space: the same without obstacles, whiskers and heights, and the
// senses of further degrees of freedom and of the faces that only they have.
SensorRegistry spatial_sensors();

}  // namespace cambrian
