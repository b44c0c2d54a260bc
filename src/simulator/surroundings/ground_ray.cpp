#include "simulator/surroundings/ground_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cambrian {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// The part of a ray that is within a slab.
struct RaySpan {
    double enters = 0.0, leaves = kNever;

    // Keeps what is within `half` of the middle of a slab, which the ray crosses at this rate.
    void cut(double start, double rate, double half) {
        if (rate == 0.0) {
            if (std::fabs(start) > half) leaves = -1.0;
            return;
        }
        const double one = (-half - start) / rate;
        const double other = (half - start) / rate;
        enters = std::max(enters, std::min(one, other));
        leaves = std::min(leaves, std::max(one, other));
    }
};

double distance_to_piece(const GroundPiece& piece, const Vec3& from, const Vec3& direction) {
    const double towards = direction.x() * piece.normal_x + direction.y() * piece.normal_y;
    if (!(towards < 0.0)) return kNever;
    const double dx = piece.x - from.x();
    const double dy = piece.y - from.y();
    const double distance = (dx * piece.normal_x + dy * piece.normal_y) / towards;
    const double along = (distance * direction.x() - dx) * piece.way_x +
                         (distance * direction.y() - dy) * piece.way_y;
    const bool meets = distance >= 0.0 && along >= 0.0 && along <= piece.length;
    if (!meets) return kNever;
    return distance;
}

}  // namespace

double distance_to_level_ground(const Vec3& from, const Vec3& direction) {
    if (from.y() <= 0.0) return 0.0;
    if (direction.y() >= 0.0) return kNever;
    return from.y() / -direction.y();
}

double distance_to_box(const FixedBox& box, const Vec3& from, const Vec3& direction) {
    const Vec3 across(-box.axis.y(), box.axis.x(), 0.0);
    const Vec3 start = from - box.center;
    RaySpan span;
    span.cut(start.dot(box.axis), direction.dot(box.axis), box.half_length);
    span.cut(start.dot(across), direction.dot(across), box.half_width);
    if (span.enters > span.leaves) return kNever;
    return span.enters;
}

double distance_to_terrain(const Terrain& terrain, const Vec3& from, const Vec3& direction,
                           double reach) {
    if (from.y() <= terrain.height(from.x())) return 0.0;
    const double end = from.x() + reach * direction.x();
    const int first = terrain.piece_at(std::min(from.x(), end)) - 1;
    const int last = terrain.piece_at(std::max(from.x(), end)) + 1;
    double nearest = kNever;
    for (int number = first; number <= last; ++number)
        nearest = std::min(nearest, distance_to_piece(terrain.piece(number), from, direction));
    if (nearest > reach) return kNever;
    return nearest;
}

}  // namespace cambrian
