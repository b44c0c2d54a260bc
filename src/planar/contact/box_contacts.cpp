#include "planar/contact/box_contacts.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// Another axis is preferred only if it is better by this much, so that parallel faces do not
// alternate.
constexpr double kAxisPreference = 1e-4;  // m

struct SeparatingAxis {
    double gap = -1e9;  // m, between the boxes' projections
    bool of_first = true;
    bool along_length = true;
};

// Tests both axes of one box; returns false if one of them separates by more than the margin.
bool try_axes(const AxisGaps<double>& gaps, bool of_first, double margin, SeparatingAxis& best) {
    if (gaps.length > margin || gaps.width > margin) return false;
    if (gaps.length > best.gap + kAxisPreference) best = {gaps.length, of_first, true};
    if (gaps.width > best.gap + kAxisPreference) best = {gaps.width, of_first, false};
    return true;
}

struct Vertex {
    double x, y;
    int corner;
};

Vertex vertex_of(const PlacedBox& box, int corner) {
    const double along = (corner & 1) != 0 ? box.half_length : -box.half_length;
    const double across = (corner & 2) != 0 ? box.half_width : -box.half_width;
    return {box.x + box.axis_x * along - box.axis_y * across,
            box.y + box.axis_y * along + box.axis_x * across, corner};
}

// Finds the ends of the face that is most opposed to the normal.
void incident_face(const PlacedBox& box, double normal_x, double normal_y, Vertex (&ends)[2]) {
    const double along = normal_x * box.axis_x + normal_y * box.axis_y;
    const double across = normal_y * box.axis_x - normal_x * box.axis_y;
    if (std::fabs(along) > std::fabs(across)) {
        const int side = along < 0.0 ? 1 : 0;
        ends[0] = vertex_of(box, side);
        ends[1] = vertex_of(box, side + 2);
    } else {
        const int side = across < 0.0 ? 2 : 0;
        ends[0] = vertex_of(box, side);
        ends[1] = vertex_of(box, side + 1);
    }
}

// Clips the face to tangential coordinates between -edge and edge. Each end is clipped by itself,
// so that a mirror image is clipped the same.
void clip(double edge, const double (&tangential)[2], Vertex (&ends)[2]) {
    const Vertex whole[2] = {ends[0], ends[1]};
    for (int i = 0; i < 2; ++i) {
        const double excess = std::fabs(tangential[i]) - edge;
        if (excess <= 0.0) continue;
        const int other = 1 - i;
        const double share = excess / std::fabs(tangential[i] - tangential[other]);
        CAMBRIAN_TICK_ASSERT(!(share < 0.0 || share > 1.0 + 1e-9), "a cut within the face");
        ends[i].x += share * (whole[other].x - whole[i].x);
        ends[i].y += share * (whole[other].y - whole[i].y);
    }
}

}  // namespace

BoxManifold collide_boxes(const PlacedBox& first, const PlacedBox& second, double margin) {
    CAMBRIAN_TICK_ASSERT(first.half_length > 0.0 && first.half_width > 0.0, "a box has an area");
    CAMBRIAN_TICK_ASSERT(second.half_length > 0.0 && second.half_width > 0.0, "a box has an area");
    BoxManifold manifold;
    SeparatingAxis axis;
    const BoxRelation<double> relation = relation_of(first, second);
    if (!try_axes(axis_gaps(first, second, relation), true, margin, axis)) return manifold;
    if (!try_axes(axis_gaps(second, first, relation), false, margin, axis)) return manifold;
    manifold.first_is_incident = !axis.of_first;
    const PlacedBox& reference = axis.of_first ? first : second;
    const PlacedBox& incident = axis.of_first ? second : first;
    double normal_x = axis.along_length ? reference.axis_x : -reference.axis_y;
    double normal_y = axis.along_length ? reference.axis_y : reference.axis_x;
    const double x = incident.x - reference.x;
    const double y = incident.y - reference.y;
    if (normal_x * x + normal_y * y < 0.0) {
        normal_x = -normal_x;
        normal_y = -normal_y;
    }
    manifold.normal_x = normal_x;
    manifold.normal_y = normal_y;
    const double face = axis.along_length ? reference.half_length : reference.half_width;
    const double edge = axis.along_length ? reference.half_width : reference.half_length;
    Vertex ends[2];
    incident_face(incident, normal_x, normal_y, ends);
    double tangential[2];
    for (int i = 0; i < 2; ++i)
        tangential[i] = normal_x * (ends[i].y - reference.y) - normal_y * (ends[i].x - reference.x);
    if (std::min(tangential[0], tangential[1]) > edge ||
        std::max(tangential[0], tangential[1]) < -edge)
        return manifold;
    clip(edge, tangential, ends);
    double gaps[2];
    for (int i = 0; i < 2; ++i)
        gaps[i] =
            normal_x * (ends[i].x - reference.x) + normal_y * (ends[i].y - reference.y) - face;
    // The deeper point comes first, so that a mirror image has the same order.
    const int deeper = gaps[1] < gaps[0] ? 1 : 0;
    for (const int i : {deeper, 1 - deeper}) {
        const Vertex& end = ends[i];
        if (gaps[i] > margin) continue;
        CAMBRIAN_TICK_ASSERT(manifold.count < 2, "two points a pair of boxes");
        manifold.corner[manifold.count] = end.corner;
        manifold.x[manifold.count] = end.x;
        manifold.y[manifold.count] = end.y;
        manifold.gap[manifold.count] = gaps[i];
        ++manifold.count;
    }
    return manifold;
}

namespace {

// Returns the smaller sides of four boxes, at the end where they are smaller.
CAMBRIAN_INLINE Simd4d smaller_sides(const BoxEnds& ends, int first) {
    const auto at = [&](const PartPlaces& places) {
        return lesser(load_lanes(places.half_length + first),
                      load_lanes(places.half_width + first));
    };
    return 2.0 * (ends.model.stretch_count > 0 ? lesser(at(ends.from), at(ends.to)) : at(ends.to));
}

}  // namespace

void find_sides(const BoxEnds& ends, BoxSides& sides) {
    CAMBRIAN_TICK_ASSERT(ends.model.part_count > 0, "a body has a box");
    Simd4d thinnest = all_lanes(1e9);
    for (int first = 0; first < ends.model.part_count; first += kLanes) {
        const Simd4d thin = smaller_sides(ends, first);
        store_lanes(sides.thin + first, thin);
        thinnest = lesser(thinnest, thin > Simd4d{} ? thin : thinnest);  // slots beyond are 0
    }
    sides.thinnest = -largest_of(-thinnest);
}

void find_travels(const BoxEnds& ends, const PerBody& from_angle, const PerBody& to_angle,
                  BoxTravels& travels) {
    const PlanarModel& model = ends.model;
    const bool deforms = model.stretch_count > 0;
    const double x = ends.to.x[0] - ends.from.x[0];
    const double y = ends.to.y[0] - ends.from.y[0];
    Simd4d farthest = {};  // beside box 0
    for (int first = 0; first < model.part_count; first += kLanes) {
        const int* bodies = model.part_body + first;
        const Simd4d turn = gather(to_angle, bodies) - gather(from_angle, bodies);
        Simd4d swing = load_lanes(model.radius + first) * magnitude(turn);
        if (deforms) swing += growths_of(ends, first);
        store_lanes(travels.turn + first, turn);
        store_lanes(travels.swing + first, swing);
        const Simd4d move_x = load_lanes(ends.to.x + first) - load_lanes(ends.from.x + first) - x;
        const Simd4d move_y = load_lanes(ends.to.y + first) - load_lanes(ends.from.y + first) - y;
        const Simd4d beside = most_length(move_x, move_y) + swing;
        store_lanes(travels.beside + first, beside);
        farthest = greater(farthest, beside);
    }
    travels.most_past = 2.0 * largest_of(farthest);
}

double travel_of(const BoxEnds& ends, const BoxTravels& travels, int part) {
    const double x = ends.to.x[part] - ends.from.x[part];
    const double y = ends.to.y[part] - ends.from.y[part];
    return std::sqrt(x * x + y * y) + travels.swing[part];
}

}  // namespace cambrian
