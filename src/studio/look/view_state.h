#pragma once

#include "studio/look/theme.h"

#include <array>

namespace cambrian {

// What the timeline plots over the generations.
enum class TimelineQuantity : unsigned char {
    kFitness,
    kDiversity,
    kKinds,
    kLines,
    kParts,
    kNeurons,
    kTrials,
    kInvalid
};

// The quantity that sorts the tiles of the population, largest first.
enum class TileOrder : unsigned char { kFitness, kAge, kParts, kMass, kDifference };

// Speeds of playback offered; 1 is real time.
inline constexpr std::array kPlaybackSpeeds = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};

// Champions of other generations that accompany the creature shown.
enum class GhostChoice : unsigned char { kNone, kImprovements, kTenths, kAcross };

// What is laid over the picture of a creature; overlays.h tells what each is.
struct OverlaysShown {
    bool trail = true;
    bool contacts = true;
    bool grid = true;
    bool names = false;
    bool forces = false;
    bool center_of_mass = false;
    bool torques = false;
    bool limits = false;
    bool sensors = false;

    friend bool operator==(const OverlaysShown&, const OverlaysShown&) = default;
};

// Which panels are shown beside the viewport, and their sizes where a person set them, in units of
// 1/96 inch; 0 follows the window.
struct PanelSizes {
    bool left = true;
    bool right = true;
    bool bottom = true;
    float left_width = 0.0F;
    float right_width = 0.0F;
    float bottom_height = 0.0F;

    friend bool operator==(const PanelSizes&, const PanelSizes&) = default;
};

// How the window is arranged and what is overlaid; remembered between runs of the program.
struct ViewState {
    ThemeKind theme = ThemeKind::kDark;
    bool follow = true;  // the camera keeps to the creature
    OverlaysShown overlays;
    PanelSizes panels;
    GhostChoice ghosts = GhostChoice::kNone;
    double speed = 1.0;           // of playback
    bool tour_taken = false;      // or declined
    bool newest_champion = true;  // the best of each finished generation takes the stage
    TimelineQuantity quantity = TimelineQuantity::kFitness;
    TileOrder order = TileOrder::kFitness;
    bool starred_only = false;  // of the population's tiles
    bool one_a_plan = false;    // of the population's tiles, the best of each body plan only

    friend bool operator==(const ViewState&, const ViewState&) = default;
};

}  // namespace cambrian
