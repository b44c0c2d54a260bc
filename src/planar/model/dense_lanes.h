#pragma once

// Values of all bodies of a dense form side by side in vectors, and sums over its arms.

#include "planar/model/kinematics.h"

namespace cambrian {

// Values of up to kBlocks * kLanes bodies.
template <int kBlocks>
struct BodyLanes {
    Simd4d block[std::size_t{kBlocks}];

    CAMBRIAN_INLINE Simd4d& operator[](int b) { return block[b]; }
    CAMBRIAN_INLINE const Simd4d& operator[](int b) const { return block[b]; }
    CAMBRIAN_INLINE double at(int body) const { return block[body / kLanes][body % kLanes]; }
    CAMBRIAN_INLINE void put_at(int body, double value) {
        for (int b = 0; b < kBlocks; ++b)
            block[b] = with_lane(block[b], body - b * kLanes, value);
    }
    CAMBRIAN_INLINE void add_at(int body, double value) {
        const auto slot = static_cast<unsigned>(body);
        block[slot / kLanes][slot % kLanes] += value;
    }
    CAMBRIAN_INLINE void fill(double value) {
        for (int b = 0; b < kBlocks; ++b)
            block[b] = all_lanes(value);
    }
    CAMBRIAN_INLINE void load(const double* from) {
        for (int b = 0; b < kBlocks; ++b)
            block[b] = load_lanes(from + b * kLanes);
    }
    CAMBRIAN_INLINE void store(double* to) const {
        for (int b = 0; b < kBlocks; ++b)
            store_lanes(to + b * kLanes, block[b]);
    }
    // Stores 0 for the padding.
    CAMBRIAN_INLINE void store_members(const PlanarModel& model, double* to) const {
        for (int b = 0; b < kBlocks; ++b)
            store_lanes(to + b * kLanes,
                        load_lanes(model.members_of(0).membership + b * kLanes) * block[b]);
    }
};

// Stores the bodies' values and then those of the centre's two coordinates.
template <int kBlocks>
CAMBRIAN_INLINE void store_coordinates(const BodyLanes<kBlocks>& of_bodies, int bodies, double x,
                                       double y, double* to) {
    of_bodies.store(to);
    store_lanes(to + kBlocks * kLanes, Simd4d{});
    to[bodies] = x;
    to[bodies + 1] = y;
}

// A planar vector for every body.
template <int kBlocks>
struct BodyVectors {
    BodyLanes<kBlocks> x, y;
};

// Multiplies the inverse mass matrix, given by columns, by a vector.
template <int kBlocks>
CAMBRIAN_INLINE BodyLanes<kBlocks> times_inverse(const double* inverse, int bodies,
                                                 const BodyLanes<kBlocks>& vector) {
    constexpr int lines = kBlocks * kLanes;
    BodyLanes<kBlocks> product = {};
    for (int k = 0; k < (kBlocks == 1 ? kLanes : bodies); ++k) {
        const Simd4d value = all_lanes(vector.at(k));
        for (int b = 0; b < kBlocks; ++b)
            product[b] += load_lanes(inverse + k * lines + b * kLanes) * value;
    }
    return product;
}

// Generalised forces of all angles under forces on the bodies' centres.
template <int kBlocks>
class Levers {
public:
    CAMBRIAN_INLINE Levers(const DenseForm& form, const Kinematics& k) : form_(form) {
        sine_.load(k.sine);
        cosine_.load(k.cosine);
    }

    CAMBRIAN_INLINE void add_force(int body, double x, double y) {
        constexpr int lines = kBlocks * kLanes;
        for (int b = 0; b < kBlocks; ++b) {
            const Simd4d d_x = load_lanes(form_.lever_x + body * lines + b * kLanes);
            const Simd4d d_y = load_lanes(form_.lever_y + body * lines + b * kLanes);
            turning_[b] += d_x * y - d_y * x;
            stretching_[b] += d_x * x + d_y * y;
        }
    }

    // Returns the torques, in N m, of all forces that were added.
    CAMBRIAN_INLINE Simd4d torque(int b) const {
        return cosine_[b] * turning_[b] - sine_[b] * stretching_[b];
    }

private:
    const DenseForm& form_;
    BodyLanes<kBlocks> sine_, cosine_;
    BodyLanes<kBlocks> turning_ = {}, stretching_ = {};
};

}  // namespace cambrian
