#pragma once

// A preserve as panels see it.

#include "preserve/engine/preserve_picture.h"
#include "preserve/pins.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace cambrian {

// The speeds to choose from; kFullSpeed is the last one.
inline constexpr std::array kPreservePaces = {0.1, 1.0, 4.0, 0.0};

inline constexpr std::size_t kWorldPlotCount = 5;  // of the series

// The left panel lists these.
enum class WorldList : std::uint8_t { kLineages, kLaws, kMuseum };
inline constexpr std::array kWorldListNames = {"Lineages", "Laws", "Museum"};

// A creature that is seen alone or saved.
enum class WorldSubject : std::uint8_t { kPicked, kPiece };

// A wall that the user draws.
struct WallTool {
    bool on = false;
    std::optional<Vec2> from;  // m; its first end, once there is one
};

struct PreserveView {
    const PreservePicture& picture;
    const std::filesystem::path& file;  // empty if it is not kept
    // The creature that was picked, alive or dead; null if none was. For a dead one it is as it
    // was last seen.
    const ResidentPicture* picked = nullptr;
    const Pins& pins;
    SettingsPtr founding = nullptr;  // with which it began; null while another world is being read
    bool follow = false;             // the camera follows the picked creature
    bool energy = false;             // a ring around each creature shows its store
    bool single = false;             // the viewer shows one creature instead of the world
    bool opening = false;            // another world is being read
    // Whether the view is fitted to most of the creatures rather than to the world, which on a
    // meadow is many times wider than high.
    bool near = false;
    unsigned fits_asked = 0;  // number of FitWorld requests so far
    WallTool wall = {};
    std::size_t plot = 0;  // index of the one shown
    WorldList list = WorldList::kLineages;
    unsigned laws_asked = 0;  // number of TypeLaws requests so far
    std::size_t piece = 0;    // index of the chosen creature of the museum

    bool picked_is(std::uint64_t number) const {
        return picked != nullptr && picked->life.number == number;
    }
};

}  // namespace cambrian
