#include "sketch/outline.h"

#include "math/angle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kShareOfFace = 0.9;      // of a face that carries children
constexpr double kBelowOne = 1.0 - 1e-9;  // the end of a face belongs to the next one

int face_of(double position) {
    return std::min(static_cast<int>(4.0 * position), 3);
}

double normal_of(double position) {
    constexpr std::array normals = {0.0, 0.5 * kPi, kPi, -0.5 * kPi};
    return normals[static_cast<std::size_t>(face_of(position))];
}

// Returns the nearest place of one face.
OutlinePlace nearest_of_face(int face, const BodyPart& part, const Vec2& inside) {
    const bool is_end = face % 2 == 0;
    const double across = is_end ? part.width : part.length;
    const double most = 0.5 * kShareOfFace * across;
    const double walked = std::clamp(is_end ? inside.y() : inside.x(), -most, most);
    const double out = (face < 2 ? 0.5 : -0.5) * (is_end ? part.length : part.width);
    OutlinePlace place;
    place.point = is_end ? Vec2(out, walked) : Vec2(walked, out);
    const double share = walked / (kShareOfFace * across) + 0.5;
    place.position = 0.25 * (face + std::clamp(share, 0.0, kBelowOne));
    place.distance = (inside - place.point).norm();
    return place;
}

int side_of(const BodySketch& sketch, std::size_t part) {
    return sketch.body.parts[part].mirror.across;
}

double mirrored_angle(double angle, MirrorAxis axis) {
    return axis == MirrorAxis::kAlong ? -angle : kPi - angle;
}

}  // namespace

OutlinePlace nearest_on_outline(const BodyPart& part, const Vec2& inside) {
    const Vec2 own(inside.x(), part.mirror.across * inside.y());
    OutlinePlace best = nearest_of_face(0, part, own);
    for (int face = 1; face < 4; ++face) {
        const OutlinePlace place = nearest_of_face(face, part, own);
        if (place.distance < best.distance) best = place;
    }
    best.point.y() *= part.mirror.across;
    return best;
}

double aimed_position(const BodySketch& sketch, std::size_t parent,
                      std::optional<MirrorAxis> image_by, const Vec2& joint) {
    Vec2 inside = into_part(sketch.body.plan.parts[parent], joint);
    if (image_by == MirrorAxis::kAlong) inside.y() = -inside.y();
    if (image_by == MirrorAxis::kAcross) inside.x() = -inside.x();
    return nearest_on_outline(sketch.body.parts[parent], inside).position;
}

double aimed_angle(const BodySketch& sketch, std::size_t parent, std::optional<MirrorAxis> image_by,
                   double position, double direction) {
    double angle =
        side_of(sketch, parent) * (direction - sketch.body.plan.parts[parent].rest_angle);
    if (image_by) angle = mirrored_angle(angle, *image_by);
    return std::clamp(wrap_angle(angle - normal_of(position)), -gene_range::kMaxEdgeAngle,
                      gene_range::kMaxEdgeAngle);
}

double direction_of(const BodySketch& sketch, std::size_t parent,
                    std::optional<MirrorAxis> image_by, const EdgeGene& edge) {
    double angle = normal_of(edge.position) + edge.angle;
    if (image_by) angle = mirrored_angle(angle, *image_by);
    return sketch.body.plan.parts[parent].rest_angle + side_of(sketch, parent) * angle;
}

}  // namespace cambrian
