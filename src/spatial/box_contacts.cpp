#include "spatial/box_contacts.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian::spatial {
namespace {

// Another axis is preferred only if it is better by this much, so that parallel faces do not
// alternate.
constexpr double kLeastBetter = 1e-4;       // m
constexpr double kEdgeBetter = 0.05;        // share of the gap; of edges against faces
constexpr double kLeastSquaredSine = 1e-4;  // of the angle between edges that count as crossing
constexpr double kNearlyAlong = 0.97;       // cosine between a normal across edges and a face's
constexpr double kFlatness = 1e-4;          // m; deeper points are kept for their depth

// A face of a box by its axis, or two edges by theirs.
struct GapAxis {
    double gap = -1e9;  // m, between the projections
    bool is_edge = false;
    bool of_first = true;  // the face
    int axis = 0;          // of the face, or of the first box's edge
    int second = 0;        // of the second box's edge
};

// How two boxes lie. Index 0 is the first box's axis.
class BoxAxes {
public:
    BoxAxes(const PlacedBox& a, const PlacedBox& b)
        : a_(a), b_(b), from_first_(a.axes.back(b.center - a.center)) {
        const Vec3 from_second = b.axes.back(b.center - a.center);
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                along_[i][j] = dot(a.axes.axis[i], b.axes.axis[j]);
                size_[i][j] = std::fabs(along_[i][j]);
            }
        }
        for (int i = 0; i < 3; ++i) {
            face_gap_[0][i] = std::fabs(from_first_[i]) - a.half[i] - size_[i][0] * b.half.x() -
                              size_[i][1] * b.half.y() - size_[i][2] * b.half.z();
            face_gap_[1][i] = std::fabs(from_second[i]) - b.half[i] - size_[0][i] * a.half.x() -
                              size_[1][i] * a.half.y() - size_[2][i] * a.half.z();
        }
    }

    // Returns the face of the largest gap.
    GapAxis best_face() const {
        GapAxis best;
        for (const bool of_first : {true, false}) {
            for (int i = 0; i < 3; ++i) {
                const double gap = face_gap_[of_first ? 0 : 1][i];
                if (gap > best.gap + kLeastBetter) best = {gap, false, of_first, i};
            }
        }
        return best;
    }

    // Returns the edges of the largest gap, if there are edges that cross.
    GapAxis best_edges() const {
        GapAxis best;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) {
                const double squared = 1.0 - along_[i][j] * along_[i][j];
                if (squared < kLeastSquaredSine) continue;
                const double gap = edge_gap(i, j) / std::sqrt(squared);
                if (gap > best.gap + kLeastBetter) best = {gap, true, true, i, j};
            }
        }
        return best;
    }

    // Which side of the first box the second one is on, along the product of two edges: 1 or -1.
    double side_of(int i, int j) const { return projection(i, j) < 0.0 ? -1.0 : 1.0; }
    double along(int i, int j) const { return along_[i][j]; }

private:
    // The centres' distance along the product of the axes, times its length.
    double projection(int i, int j) const {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        return from_first_[i2] * along_[i1][j] - from_first_[i1] * along_[i2][j];
    }
    double edge_gap(int i, int j) const {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        const int j1 = (j + 1) % 3;
        const int j2 = (j + 2) % 3;
        return std::fabs(projection(i, j)) - a_.half[i1] * size_[i2][j] -
               a_.half[i2] * size_[i1][j] - b_.half[j1] * size_[i][j2] - b_.half[j2] * size_[i][j1];
    }

    const PlacedBox& a_;
    const PlacedBox& b_;
    Vec3 from_first_;  // from the first centre to the second, in the first box's axes
    double along_[3][3];
    double size_[3][3];
    double face_gap_[2][3];
};

double signed_half(const PlacedBox& box, int axis, const Vec3& normal) {
    return dot(box.axes.axis[axis], normal) < 0.0 ? -box.half[axis] : box.half[axis];
}

// Returns the middle of the edge along this axis that is farthest along the normal, and adds its
// number, 0 to 3, to the feature.
Vec3 edge_middle(const PlacedBox& box, int axis, const Vec3& normal, int& feature) {
    Vec3 middle = box.center;
    for (const int across : {(axis + 1) % 3, (axis + 2) % 3}) {
        const double way = signed_half(box, across, normal);
        middle += way * box.axes.axis[across];
        feature = 2 * feature + (way > 0.0 ? 1 : 0);
    }
    return middle;
}

// Where the edges pass each other. Returns false if they do so beyond an end of either.
bool cross_edges(const PlacedBox& first, const PlacedBox& second, const BoxAxes& both,
                 const GapAxis& axis, BoxManifold& manifold) {
    constexpr int kFaceFeatures = kBoxFeatures - 9 * 16;
    const Vec3& along = first.axes.axis[axis.axis];
    const Vec3& other = second.axes.axis[axis.second];
    const double cosine = both.along(axis.axis, axis.second);
    const double squared = 1.0 - cosine * cosine;
    const Vec3 normal =
        (-both.side_of(axis.axis, axis.second) / std::sqrt(squared)) * cross(along, other);
    int feature = 3 * axis.axis + axis.second;
    const Vec3 here = edge_middle(first, axis.axis, -normal, feature);
    const Vec3 there = edge_middle(second, axis.second, normal, feature);
    const Vec3 way = there - here;
    const double one = dot(along, way);
    const double two = dot(other, way);
    const double share = (one - cosine * two) / squared;
    const double other_share = (cosine * one - two) / squared;
    if (std::fabs(share) > first.half[axis.axis] ||
        std::fabs(other_share) > second.half[axis.second])
        return false;
    manifold.first_is_incident = true;
    manifold.surface = {{normal, other, cross(normal, other)}};
    manifold.count = 1;
    manifold.points[0] = {kFaceFeatures + feature, here + share * along, -dot(normal, way)};
    return true;
}

// A corner of the part of a face inside another face.
struct FaceCorner {
    double u = 0.0, v = 0.0;  // m, along the reference face
    double gap = 0.0;         // m, above it
    int edge = 0;             // that leads to the next corner: 0 to 3 of the face, 4 to 7 of cuts
    int before = 0;           // that leads to it
};

// A face of four corners and what cuts leave of it.
struct FacePolygon {
    static constexpr int kMost = 8;
    int count = 0;
    FaceCorner corners[kMost];

    void add(const FaceCorner& corner) {
        CAMBRIAN_TICK_ASSERT(count < kMost, "four cuts of four corners leave eight");
        if (count < kMost) corners[count++] = corner;
    }
    void remove(int index) {
        std::copy(corners + index + 1, corners + count, corners + index);
        --count;
    }
};

// Cuts off what is beyond an edge of the reference face, which has the number `cut`: 4 and 5 are
// those at u = +-limit, 6 and 7 those at v.
void clip_face(int cut, double limit, FacePolygon& polygon) {
    const auto beyond = [cut, limit](const FaceCorner& corner) {
        const double along = cut < 6 ? corner.u : corner.v;
        return (cut % 2 == 0 ? along : -along) - limit;
    };
    FacePolygon left;
    for (int c = 0; c < polygon.count; ++c) {
        const FaceCorner& corner = polygon.corners[c];
        const FaceCorner& next = polygon.corners[c + 1 < polygon.count ? c + 1 : 0];
        const double here = beyond(corner);
        const double there = beyond(next);
        if (here <= 0.0) left.add(corner);
        if ((here <= 0.0) == (there <= 0.0)) continue;
        const bool leaves = here <= 0.0;
        const FaceCorner& in = leaves ? corner : next;
        const FaceCorner& out = leaves ? next : corner;
        const double share = (leaves ? here : there) / (leaves ? here - there : there - here);
        left.add({in.u + share * (out.u - in.u), in.v + share * (out.v - in.v),
                  in.gap + share * (out.gap - in.gap), leaves ? cut : corner.edge});
    }
    polygon = left;
}

// Takes away the corners that add least to the area, until four are left. One that is clearly the
// deepest remains.
void reduce_corners(FacePolygon& polygon) {
    while (polygon.count > kBoxPoints) {
        const auto [deepest, highest] = std::minmax_element(
            polygon.corners, polygon.corners + polygon.count,
            [](const FaceCorner& a, const FaceCorner& b) { return a.gap < b.gap; });
        const bool is_flat = highest->gap - deepest->gap < kFlatness;
        int least = 0;
        double least_area = 1e9;
        for (int c = 0; c < polygon.count; ++c) {
            if (!is_flat && polygon.corners + c == deepest) continue;
            const FaceCorner& corner = polygon.corners[c];
            const FaceCorner& one = polygon.corners[c > 0 ? c - 1 : polygon.count - 1];
            const FaceCorner& two = polygon.corners[c + 1 < polygon.count ? c + 1 : 0];
            const double area = std::fabs((one.u - corner.u) * (two.v - corner.v) -
                                          (one.v - corner.v) * (two.u - corner.u));
            if (area >= least_area) continue;
            least = c;
            least_area = area;
        }
        polygon.remove(least);
    }
}

// The corners of the incident box's face that is most opposed to the normal. Returns its number.
int incident_corners(const PlacedBox& box, const PlacedBox& reference, int axis, const Vec3& normal,
                     FacePolygon& polygon) {
    int facing = 0;
    double most = -1.0;
    for (int i = 0; i < 3; ++i) {
        const double size = std::fabs(dot(normal, box.axes.axis[i]));
        if (size <= most) continue;
        facing = i;
        most = size;
    }
    const double toward = -signed_half(box, facing, normal);
    const int one = (facing + 1) % 3;
    const int two = (facing + 2) % 3;
    const Vec3 middle = box.center + toward * box.axes.axis[facing] - reference.center;
    constexpr double kSigns[4][2] = {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}};
    for (int c = 0; c < 4; ++c) {
        const Vec3 way = middle + (kSigns[c][0] * box.half[one]) * box.axes.axis[one] +
                         (kSigns[c][1] * box.half[two]) * box.axes.axis[two];
        polygon.add({dot(way, reference.axes.axis[(axis + 1) % 3]),
                     dot(way, reference.axes.axis[(axis + 2) % 3]),
                     dot(way, normal) - reference.half[axis], c});
    }
    return 2 * facing + (toward > 0.0 ? 1 : 0);
}

// The points of a box at a face of the other.
void clip_faces(const PlacedBox& first, const PlacedBox& second, const GapAxis& face, double margin,
                BoxManifold& manifold) {
    manifold.first_is_incident = !face.of_first;
    const PlacedBox& reference = face.of_first ? first : second;
    const PlacedBox& incident = face.of_first ? second : first;
    const int axis = face.axis;
    const Vec3& outward = reference.axes.axis[axis];
    const bool is_above = dot(outward, incident.center - reference.center) >= 0.0;
    const Vec3 normal = is_above ? outward : Vec3(-outward);
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    manifold.surface = {{normal, reference.axes.axis[u], reference.axes.axis[v]}};
    FacePolygon polygon;
    const int facing = incident_corners(incident, reference, axis, normal, polygon);
    for (int cut = 4; cut < 8; ++cut)
        clip_face(cut, reference.half[cut < 6 ? u : v], polygon);
    for (int c = 0; c < polygon.count; ++c)
        polygon.corners[c].before = polygon.corners[c > 0 ? c - 1 : polygon.count - 1].edge;
    for (int c = polygon.count - 1; c >= 0; --c) {
        if (!(polygon.corners[c].gap <= margin)) polygon.remove(c);
    }
    reduce_corners(polygon);
    const int side = 2 * axis + (is_above ? 1 : 0);
    const int faces = (2 * side + (manifold.first_is_incident ? 1 : 0)) * 6 + facing;
    for (int c = 0; c < polygon.count; ++c) {
        const FaceCorner& corner = polygon.corners[c];
        const Vec3 place = reference.center + corner.u * reference.axes.axis[u] +
                           corner.v * reference.axes.axis[v] +
                           (reference.half[axis] + corner.gap) * normal;
        manifold.points[manifold.count++] = {64 * faces + 8 * corner.before + corner.edge, place,
                                             corner.gap};
    }
    std::sort(manifold.points, manifold.points + manifold.count,
              [](const BoxPoint& a, const BoxPoint& b) { return a.feature < b.feature; });
}

// Finds the face whose normal is nearest to a direction. Returns whether it is near.
bool find_face_along(const PlacedBox& first, const PlacedBox& second, const Vec3& direction,
                     GapAxis& face) {
    double most = kNearlyAlong;
    for (const bool of_first : {true, false}) {
        for (int i = 0; i < 3; ++i) {
            const Vec3& normal = (of_first ? first : second).axes.axis[i];
            const double along = std::fabs(dot(direction, normal));
            if (along <= most) continue;
            most = along;
            face = {0.0, false, of_first, i};
        }
    }
    return most > kNearlyAlong;
}

}  // namespace

double gap_between(const PlacedBox& first, const PlacedBox& second) {
    const BoxAxes both(first, second);
    return std::max(both.best_face().gap, both.best_edges().gap);
}

BoxManifold collide_boxes(const PlacedBox& first, const PlacedBox& second, double margin) {
    BoxManifold manifold;
    const BoxAxes both(first, second);
    GapAxis face = both.best_face();
    if (face.gap > margin) return manifold;
    const GapAxis edges = both.best_edges();
    if (edges.gap > margin) return manifold;
    const double better = std::max(kLeastBetter, kEdgeBetter * std::fabs(face.gap));
    if (edges.gap > face.gap + better && cross_edges(first, second, both, edges, manifold)) {
        // An edge that lies nearly flat on a face would rock from one of its edges to the other.
        if (!find_face_along(first, second, manifold.surface.axis[0], face)) return manifold;
        BoxManifold flat;
        clip_faces(first, second, face, margin, flat);
        return flat.count > 0 ? flat : manifold;
    }
    clip_faces(first, second, face, margin, manifold);
    return manifold;
}

}  // namespace cambrian::spatial
