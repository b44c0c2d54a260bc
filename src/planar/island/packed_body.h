#pragma once

// A body between two ticks, in as little memory as its numbers need (planar/README.md 23).

#include "planar/evaluation/cache_numbers.h"
#include "planar/island/scene_body.h"

#include <cstddef>
#include <vector>

namespace cambrian {

using PackedNumbers = std::vector<std::byte>;

// Returns what a body must have to go back to the present moment, without its cache.
void pack_moment(const SceneBody& body, PackedNumbers& moment);
// Goes back to such a moment of the same body.
void unpack_moment(const PackedNumbers& moment, SceneBody& body);

class PackedBody {
public:
    // Takes over the numbers and lists of a body. It must not be used until unpack().
    void pack(SceneBody& body);
    // Gives them back to this or another body, whose numbers are lost. Slots beyond the counts are
    // set to 0.
    void unpack(SceneBody& body);
    // Must be called when the model changed.
    void forget_model() { model_.clear(); }

    // What may be read and changed meanwhile.
    PackedNumbers& moment() { return moment_; }
    ContactLaw& law() { return law_; }
    std::vector<HeldForce>& pulls() { return pulls_; }
    SceneMotion motion() const;

private:
    void swap_lists(SceneBody& body);

    int bodies_ = 0, coordinates_ = 0;
    NumberCounts counts_;  // in lanes
    PackedNumbers model_, moment_, rest_;
    ContactLaw law_;
    std::vector<PartPair> colliding_pairs_;
    std::vector<HeldForce> pulls_;
};

}  // namespace cambrian
