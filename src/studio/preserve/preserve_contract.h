#pragma once

// The requests that panels may make of a preserve. The data they see is in preserve_view.h.

#include "evolution/fields/setting_field.h"
#include "preserve/engine/preserve_command.h"
#include "studio/preserve/opened_world.h"
#include "studio/preserve/preserve_view.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <variant>

namespace cambrian {

// Opens or closes the card with which a preserve is begun.
struct TogglePreserveCard {};
// Opens the card for a preserve with the settings of a file.
struct PlanPreserve {
    std::filesystem::path settings;
    bool ground = false;
};
struct BeginPreserve {
    std::optional<FounderChoice> founders;  // none: opens the last one that was begun here
    bool wraps = false;                     // edges meet
    TerrainSettings ground = {};            // of a new meadow
};
// Returns to the experiment. The preserve remains in its file.
struct ClosePreserve {};
struct TogglePlay {};
struct AskPreserve {
    PreserveCommand command;
};
struct PickResident {
    std::uint64_t number = 0;  // 0 for none
};
struct PickNext {
    int steps = 1;  // among the living, in the order of numbers
};
struct FollowPicked {};  // or no longer
struct PinPicked {};     // or unpin
struct InheritPins {};   // lets descendants of pinned creatures be pinned, or no longer
struct ShowPicked {};    // alone, in the viewer
struct ShowWorld {};
struct RemovePicked {};
// Sets the place at which food and creatures arrive.
struct AimAt {
    double x = 0.0;  // m
    double y = 0.0;
};
struct FeedThere {};
struct MovePickedThere {};
// Begins a wall where the user points, or ends it there.
struct DrawWall {};
// Lets the next clicks draw a wall, or no longer.
struct ToggleWalls {};
// Erases the wall where the user points.
struct EraseWallThere {};
// Adds a copy of the creature on display.
struct AddShown {};
struct FitWorld {};
struct ToggleEnergyRings {};
// Goes so many plots of the series further.
struct TurnPlot {
    int steps = 1;
};
struct ShowList {
    WorldList list = WorldList::kLineages;
};
// Lets the user type the value of the first law, from which Tab leads to the others.
struct TypeLaws {};
// Changes a law of the world from now on.
struct SetLaw {
    SettingField law;
    double value = 0.0;
};
// Chooses a creature of the museum, and shows the museum.
struct ChoosePiece {
    std::size_t index = 0;
};
struct ShowPiece {};  // the chosen one alone, in the viewer
// Goes on from a snapshot, in a file of its own.
struct BranchFrom {
    std::uint64_t tick = 0;
};

using PreserveRequest =
    std::variant<TogglePreserveCard, PlanPreserve, BeginPreserve, ClosePreserve, TogglePlay,
                 AskPreserve, PickResident, PickNext, FollowPicked, PinPicked, InheritPins,
                 ShowPicked, ShowWorld, RemovePicked, AimAt, FeedThere, MovePickedThere, DrawWall,
                 ToggleWalls, EraseWallThere, AddShown, FitWorld, ToggleEnergyRings, TurnPlot,
                 ShowList, TypeLaws, SetLaw, ChoosePiece, ShowPiece, BranchFrom>;

// The card with which a preserve is begun.
struct PreserveCardView {
    bool open = false;
    bool shown = false;                      // whether a creature is on display
    std::size_t starred = 0;                 // creatures
    std::size_t picked = 0;                  // by hand
    bool before = false;                     // whether there is a preserve to continue
    std::set<FounderChoice> on_ground = {};  // the choices whose creatures live on ground
    PlanPreserve plan = {};                  // without settings, those of the samples are used
};

}  // namespace cambrian
