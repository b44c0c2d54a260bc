#pragma once

// Contacts between boxes of one creature (dynamics/README.md 8).

#include "dynamics/contact/contact.h"
#include "dynamics/model/part_places.h"

namespace cambrian {

// List of the pairs that are near enough to be tested. It is rebuilt when boxes have moved too far;
// the contacts do not depend on when that happened.
class PairList {
public:
    // Adds all contacts nearer than kContactMargin, at most two for each pair.
    void detect(const PlanarModel& model, const Kinematics& kinematics, const PartPlaces& places,
                ContactSet& contacts);
    void forget() { built_ = false; }  // before the positions of another model

private:
    void add_contacts(const PlanarModel& model, const Kinematics& kinematics,
                      const PartPlaces& places, int pair, ContactSet& contacts);
    bool has_expired(const PlanarModel& model, const PartPlaces& places) const;
    void rebuild(const PlanarModel& model, const PartPlaces& places);

    bool built_ = false;
    int count_ = 0;
    // Of each pair. The padding to the vector width has parts, too, but is no pair.
    int index_[kMostPairs];                       // of the model's pairs
    int first_[kMostPairs], second_[kMostPairs];  // parts
    double reach_squared_[kMostPairs];            // m^2, between the centres
    bool by_second_[kMostPairs];  // an axis of the second box is tried first to separate the boxes
    PerPart built_x_, built_y_;   // m, relative to part 0
};

}  // namespace cambrian
