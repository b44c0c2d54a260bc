#pragma once

// Contacts between boxes of one creature (planar/README.md 8).

#include "planar/contact/box_contacts.h"
#include "planar/contact/contact.h"

#include <cstdint>

namespace cambrian {

// List of the pairs that are near enough to be tested. It is rebuilt when boxes have moved too far;
// the contacts do not depend on when that happened.
class PairList {
public:
    // Adds all contacts nearer than kContactMargin, at most two for each pair, in the order of the
    // model's pairs.
    void detect(const PlanarModel& model, const Kinematics& kinematics, const PartPlaces& places,
                ContactSet& contacts);
    // Returns into how many equal parts the motion between the last two detections must be divided
    // so that no pair which might meet moves farther past each other than its smaller side in one
    // of them. The result is not whole, and at least 1.
    [[gnu::noinline]] double count_looks(const BoxEnds& ends, const BoxTravels& travels,
                                         const BoxSides& sides) const;
    bool is_empty() const { return !was_rebuilt_ && listed_count_ == 0; }
    // Before the positions or the pairs of another model.
    void forget() { is_grouped_ = is_built_ = false; }

private:
    // Consecutive pairs of one box with some of four others, which are tested at once.
    struct Group {
        std::uint16_t index;  // of the first pair, among the model's
        std::uint8_t first;   // part
        std::uint8_t second;  // part; the first of the four, a multiple of kLanes
        std::uint8_t lanes;   // that are pairs: a bit for each of the four
        std::uint8_t near;    // lanes with pairs near enough to be tested
    };

    void group_pairs(const PlanarModel& model);
    bool has_expired(const PlanarModel& model, const PartPlaces& places) const;
    void rebuild(const PlanarModel& model, const PartPlaces& places);
    void add_contacts(const PlanarModel& model, const Kinematics& kinematics,
                      const PartPlaces& places, const Group& group, unsigned lanes,
                      ContactSet& contacts);

    bool is_grouped_ = false, is_built_ = false;
    bool was_rebuilt_ = false;  // by the last detection
    int group_count_ = 0, listed_count_ = 0;
    Group groups_[kMostPairs];
    Group listed_[kMostPairs];   // those with pairs near enough to be tested
    PerPart built_x_, built_y_;  // m, relative to part 0
};

}  // namespace cambrian
