#pragma once

#include "pictures/scene/character.h"
#include "studio/look/theme.h"

#include <array>

namespace cambrian {

// The quantity that the timeline plots over the generations.
enum class TimelineQuantity : unsigned char {
    kFitness,
    kDiversity,
    kKinds,
    kLines,
    kParts,
    kNeurons,
    kTrials,
    kInvalid,
    kTerrainLevel
};

// The quantity by which the tiles of the population are sorted, largest first.
enum class TileOrder : unsigned char { kFitness, kAge, kParts, kMass, kDifference };

// The playback speeds to choose from; 1 is real time.
inline constexpr std::array kPlaybackSpeeds = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};

// The sizes of the interface to choose from, in per cent of what the desktop tells.
inline constexpr std::array kInterfaceSizes = {80, 90, 100, 110, 125, 150, 175, 200};

// Which champions of other generations are displayed beside the creature.
enum class GhostChoice : unsigned char { kNone, kImprovements, kTenths, kAcross };

// The amount of scenery that is drawn. kAutomatic leaves it to the time that frames take; a
// light one has fewer small things, a plain one is the background alone.
enum class Scenery : unsigned char { kAutomatic, kFull, kLight, kPlain };

// The overlays that are drawn over the creature; overlays.h describes them.
struct OverlaysShown {
    bool trail = true;
    bool contacts = true;
    bool grid = true;
    bool ruler = false;
    bool names = false;
    bool forces = false;
    bool center_of_mass = false;
    bool torques = false;
    bool limits = false;
    bool sensors = false;
    bool sounds = false;
    bool scent = false;

    friend bool operator==(const OverlaysShown&, const OverlaysShown&) = default;
};

// Which panels are shown beside the viewport, and their sizes if the user set them, in units of
// 1/96 inch. The size 0 follows the window.
struct PanelSizes {
    bool left = true;
    bool right = true;
    bool bottom = true;
    float left_width = 0.0F;
    float right_width = 0.0F;
    float bottom_height = 0.0F;

    friend bool operator==(const PanelSizes&, const PanelSizes&) = default;
};

// The arrangement of the window and its overlays, stored between runs of the program.
struct ViewState {
    ThemeKind theme = ThemeKind::kDark;
    LookMode look = LookMode::kLife;
    Scenery scenery = Scenery::kAutomatic;
    int size = 100;      // of the interface, one of kInterfaceSizes
    bool follow = true;  // the camera follows the creature
    OverlaysShown overlays;
    PanelSizes panels;
    bool all_settings = false;  // the panel of settings shows more than the plain ones
    GhostChoice ghosts = GhostChoice::kNone;
    bool rival = true;            // a sample runs beside the champions
    double speed = 1.0;           // speed of playback; 1 is real time
    bool tour_taken = false;      // the user took or declined the tour
    bool newest_champion = true;  // displays the best of each finished generation
    TimelineQuantity quantity = TimelineQuantity::kFitness;
    TileOrder order = TileOrder::kFitness;
    bool starred_only = false;  // the population shows starred creatures only
    bool one_a_plan = false;    // the population shows the best of each body plan only

    friend bool operator==(const ViewState&, const ViewState&) = default;
};

}  // namespace cambrian
