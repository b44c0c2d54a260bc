#pragma once

// The record of a preserve, for its file.

#include "genome/genome.h"
#include "preserve/life/life.h"
#include "preserve/museum.h"
#include "preserve/series.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

struct PreserveState;

// Names of all that people may do to a preserve, and of what it does by itself that is no birth
// and no death (preserve/README.md 8).
namespace intervention {
inline constexpr const char* kRestock = "restock";  // by itself
inline constexpr const char* kFeed = "feed";
inline constexpr const char* kAdd = "add";
inline constexpr const char* kRemove = "remove";
inline constexpr const char* kMove = "move";
inline constexpr const char* kRest = "rest";
inline constexpr const char* kWall = "wall";
inline constexpr const char* kErase = "erase";
inline constexpr const char* kLaw = "law ";  // followed by the key of the setting (laws.h)
}  // namespace intervention

struct Intervention {
    std::uint64_t tick = 0;  // ticks before it
    std::string what = {};   // one of the names above
    std::uint64_t number =
        0;  // of the creature; of plants for kFeed, of all walls for kWall, kErase
    // m; the place for kFeed, kAdd, kMove and kErase, an end for kWall. For kLaw, x is the new
    // value of the setting.
    double x = 0.0, y = 0.0;
    double to_x = 0.0, to_y = 0.0;  // m; the other end for kWall
    GenomePtr genome = {};          // for kAdd
};

// All that happened since it was taken last.
struct Chronicle {
    std::vector<Life> born;
    std::vector<Life> died;
    std::vector<SeriesRow> series;
    std::vector<Intervention> interventions;
    std::vector<MuseumPiece> museum;  // a creature may come into it again for the same reason
    // The last that was taken, from which the preserve itself went on; null if none was.
    std::shared_ptr<const PreserveState> snapshot;
};

// Adds what happened later.
void append(Chronicle& all, Chronicle later);

}  // namespace cambrian
