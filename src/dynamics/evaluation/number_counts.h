#pragma once

// How many numbers of each kind a model has. Memory that serves several models in turn is filled
// and cleared by these counts.

#include "dynamics/model/planar_model.h"

#include <algorithm>

namespace cambrian {

struct NumberCounts {
    int bodies = 0, coordinates = 0, parts = 0, trees = 0;
    int members = 0;       // begins of members and the end of the last; 0 for one creature
    int measured = 0;      // parts whose forces are measured
    int dense_matrix = 0;  // numbers of a matrix of the dense form

    friend bool operator==(const NumberCounts&, const NumberCounts&) = default;
};

inline NumberCounts counts_of(const PlanarModel& model) {
    const bool is_dense = model.dense.blocks > 0;
    return {.bodies = model.body_count,
            .coordinates = coordinate_count(model),
            .parts = model.part_count,
            .trees = model.tree_count,
            .members = model.member_count > 1 ? model.member_count + 1 : 0,
            .measured = model.measured_parts != 0 ? model.part_count : 0,
            .dense_matrix = is_dense ? kMaxDenseBodies * kMaxDenseBodies : 0};
}

// Returns counts that are rounded up to the vector width where vectors are used.
inline NumberCounts lanes_of(NumberCounts counts) {
    for (int* count : {&counts.bodies, &counts.coordinates, &counts.parts, &counts.measured})
        *count = round_up_to_lanes(*count);
    return counts;
}

// The counts of the present model, and of the one that used the same memory before.
struct ChangedCounts {
    NumberCounts now, before;
};

// Visits numbers of doubles that vectors use, one field of `owner` after the other. A visitor has
// three functions: one(number), some(numbers, count, before), and lanes() for some() of these.
template <class Fields, class Owner, class Visitor>
void visit_lanes(Owner& owner, const Fields& fields, int now, int before, Visitor& visitor) {
    for (const auto field : fields)
        visitor.lanes(owner.*field, now, before);
}

// A visitor that sets what was used before, beyond the counts, to 0.
class Clearing {
public:
    template <class Number>
    void one(const Number&) {}
    void lanes(double* numbers, int count, int before) { some(numbers, count, before); }
    template <class Number>
    void some(Number* numbers, int count, int before) {
        if (before > count) std::fill(numbers + count, numbers + before, Number{});
    }
};

}  // namespace cambrian
