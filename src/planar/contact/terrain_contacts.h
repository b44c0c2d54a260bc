#pragma once

// Contacts of boxes with ground that has a shape (planar/README.md 24).

#include "planar/contact/box_contacts.h"
#include "planar/contact/contact.h"
#include "planar/model/kinematics.h"
#include "world/terrain.h"

namespace cambrian {

// The ground, and the piece at which the search for those below a body begins.
struct TerrainSearch {
    const Terrain& terrain;
    int& guess;
};

// Adds all contacts nearer than kContactMargin to an empty set, by body and then by feature of the
// ground, outwards from the start.
void detect_terrain_contacts(const PlanarModel& model, const Kinematics& kinematics,
                             const PartPlaces& places, const TerrainSearch& search,
                             ContactSet& contacts);

// Returns into how many equal parts a motion must be divided so that no box that is near the ground
// moves farther than the width of its narrowest ridge in one of them. The result is not whole, and
// at least 1.
[[gnu::noinline]] double count_looks_at_terrain(const BoxEnds& ends, const BoxTravels& travels,
                                                const Terrain& terrain);

// Returns the least height of a part above the ground, straight down, in m.
double height_above_terrain(const PlanarModel& model, const PartPlaces& places,
                            const Terrain& terrain);

}  // namespace cambrian
