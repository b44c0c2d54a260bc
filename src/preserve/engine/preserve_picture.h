#pragma once

// A preserve at one moment, as a user sees it. It is immutable and shared between threads.

#include "creature/phenotype.h"
#include "evolution/settings/experiment_settings.h"
#include "evolution/settings/light_patches.h"
#include "evolution/settings/world_area.h"
#include "preserve/life/life.h"
#include "preserve/museum.h"
#include "preserve/series.h"
#include "preserve/world/food.h"
#include "preserve/world/rectangle.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

class Preserve;

struct ResidentPicture {
    Life life;
    double store = 0.0;              // J
    double body = 0.0;               // J
    double birth_need = 0.0;         // J in store above which it may bear a child of its size
    bool bitten = false;             // in the last tick
    std::uint64_t bitten_since = 0;  // tick of the first of the pictures in which it was; 0: is not
    std::uint64_t fed = 0;       // tick of the first picture after it last ate or bit; 0: none did
    Vec3 center = Vec3::Zero();  // m; where edges meet, of the image in the area
    Vec3 velocity = Vec3::Zero();  // m/s, of the centre of mass
    std::vector<Rectangle> parts;
    std::shared_ptr<const Phenotype> phenotype;
};

// The signals of a brain at the moment of a picture.
struct LiveBrain {
    std::uint64_t creature = 0;   // number; 0 for none
    std::vector<double> slots;    // the value of each slot of its network
    std::vector<double> outputs;  // of effectors, then of organs
};

// The answer to an intervention.
struct PreserveNews {
    std::uint64_t id = 0;  // ascending
    std::string what;      // of the intervention
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
    // Whether an exception stopped it in the middle of a change. Then it neither goes on nor is
    // written; its log keeps the last snapshot.
    bool broken = false;
    SettingsPtr laws;  // in force
    WorldArea area;
    SeriesRow now;
    std::vector<ResidentPicture> residents;  // in ascending order of numbers
    LiveBrain brain;                         // of the creature that is watched, while it lives
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

// Takes pictures of one preserve; keeps the phenotypes of the living, which pictures share, and
// when they ate.
class PreserveCamera {
public:
    // Fills in what there is to see of the world at this moment: all but who plays it, and how.
    void take(const Preserve& preserve, PreservePicture& picture);
    // Shows the brain of a creature in the following pictures; 0 for none.
    void watch(std::uint64_t creature) { watched_ = creature; }

private:
    LiveBrain brain_in(const Preserve& preserve) const;
    std::vector<ResidentPicture> residents_of(const Preserve& preserve);

    struct Known {
        std::uint64_t number = 0;
        std::shared_ptr<const Phenotype> phenotype;
        Energy gained = 0;               // by eating and biting
        std::uint64_t fed = 0;           // as in its picture
        std::uint64_t bitten_since = 0;  // the same
    };
    std::vector<Known> known_;  // in ascending order
    std::uint64_t watched_ = 0;
};

}  // namespace cambrian
