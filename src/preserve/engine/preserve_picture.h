#pragma once

// What a user sees of a preserve at one moment. Immutable; shared between threads.

#include "creature/phenotype.h"
#include "evolution/settings/experiment_settings.h"
#include "evolution/settings/light_patches.h"
#include "preserve/life/life.h"
#include "preserve/museum.h"
#include "preserve/series.h"
#include "preserve/world/area.h"
#include "preserve/world/pellets.h"
#include "preserve/world/rectangle.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

class Preserve;

struct ResidentPicture {
    Life life;
    double store = 0.0;       // J
    double body = 0.0;        // J
    double birth_need = 0.0;  // J in store above which it may bear a child of its size
    bool bitten = false;      // in the last tick
    Vec3 center = Vec3::Zero();
    std::vector<Rectangle> parts;
    std::shared_ptr<const Phenotype> phenotype;
};

// The answer to an intervention.
struct PreserveNews {
    std::uint64_t id = 0;  // ascending
    std::string what;      // of the intervention, or "keep"
    std::uint64_t number = 0;
    std::string problem;  // why it could not be done, or empty
};

struct PreservePicture {
    std::uint64_t tick = 0;
    bool playing = false;
    double pace = 1.0;    // wanted, as a factor of real time; kFullSpeed for as fast as it goes
    double factor = 0.0;  // reached
    bool kept = false;    // whether a log keeps it
    std::string failure;  // why it stopped, or empty
    SettingsPtr laws;     // in force
    WalledArea area;
    SeriesRow now;
    std::vector<ResidentPicture> residents;  // in ascending order of numbers
    std::vector<Pellet> plants, flesh;
    std::vector<Rectangle> walls;  // within the area
    std::vector<LightPatch> patches;
    std::shared_ptr<const std::vector<SeriesRow>> series;
    std::shared_ptr<const std::vector<MuseumPiece>> museum;
    std::shared_ptr<const std::vector<Life>> died;                // the last ones
    std::shared_ptr<const std::vector<std::uint64_t>> snapshots;  // ticks
    std::vector<PreserveNews> news;                               // the last ones

    // Returns null if it is not alive.
    const ResidentPicture* find(std::uint64_t number) const;
};

// Takes pictures of one preserve; keeps the phenotypes of the living, which pictures share.
class PreserveCamera {
public:
    // Fills in what there is to see of the world at this moment: all but who plays it, and how.
    void take(const Preserve& preserve, PreservePicture& picture);

private:
    std::vector<ResidentPicture> residents_of(const Preserve& preserve);

    struct Known {
        std::uint64_t number = 0;
        std::shared_ptr<const Phenotype> phenotype;
    };
    std::vector<Known> known_;  // in ascending order
};

}  // namespace cambrian
