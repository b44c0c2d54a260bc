#pragma once

#include <string_view>

namespace cambrian {

// Must be raised when the same genome and settings would move or score differently:
//
//     1.0
//     1.1  contact problems solved exactly
//     1.2  contact forces in the middle of steps twice as long; jumping by height measured in every
//          tick, walking by its slowest quarter
//     1.3  lengths of bodies by their corners' distances; walking counts uphill on a slope;
//          contests from equal distances; angular momentum restored in every tick, steps that gain
//          energy made again
inline constexpr std::string_view kSimulatorVersion = "1.3";

// That of the simulator of bodies in space, whose numbers begin with its dimensions. Until 3d-1.0
// it may change with every version of the program.
//
//     3d-0.1
//     3d-0.2  ground; stops solved together with contacts
//     3d-0.3  contact between parts; ball joints
inline constexpr std::string_view kSpatialSimulatorVersion = "3d-0.3";

constexpr std::string_view simulator_version(int dimensions) {
    return dimensions == 3 ? kSpatialSimulatorVersion : kSimulatorVersion;
}

}  // namespace cambrian
