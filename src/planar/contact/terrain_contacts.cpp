#include "planar/contact/terrain_contacts.h"

#include "core/assert.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace cambrian {
namespace {

constexpr int kMostNearPieces = 512;  // below one body
constexpr double kStraightOn = 1e-9;  // sine of a turn
// Sine of the angle by which a face may be turned out of the cone of the ground's normals at a
// point. A box that lies flat on a narrow block has its face at the edges of both cones.
constexpr double kConeSlack = 0.15;

struct GroundSpot {
    double x, y;
};

double turn_sine(double ax, double ay, double bx, double by) {
    return ax * by - ay * bx;
}

// Pieces of the ground that follow each other, from left to right.
using Pieces = std::span<const GroundPiece>;
struct NearPieces {
    GroundPiece items[kMostNearPieces];
};

// The search begins at piece `guess`, which becomes the first one. It does not decide the result.
Pieces find_near_pieces(const Terrain& terrain, double left, double right, int& guess,
                        NearPieces& near) {
    constexpr int kFar = 16;       // pieces
    constexpr double kAway = 1e6;  // m; a scene is invalid there
    left = std::clamp(left, -kAway, kAway);
    const auto is_before = [&](int number) { return left < terrain.piece(number).left(); };
    const auto is_past = [&](int number) { return left >= terrain.piece(number).right(); };
    if (is_before(guess - kFar) || is_past(guess + kFar)) guess = terrain.piece_at(left);
    while (is_before(guess))
        --guess;
    while (is_past(guess))
        ++guess;
    std::size_t count = 0;
    for (int number = guess; count < kMostNearPieces; ++number) {
        near.items[count] = terrain.piece(number);
        if (count > 0 && near.items[count].left() > right) break;
        ++count;
    }
    return {near.items, count};
}

Pieces between(Pieces pieces, double left, double right) {
    while (pieces.size() > 1 && pieces.front().right() < left)
        pieces = pieces.subspan(1);
    while (pieces.size() > 1 && pieces.back().left() > right)
        pieces = pieces.first(pieces.size() - 1);
    return pieces;
}

double highest_of(Pieces pieces) {
    double highest = pieces.front().y;
    for (const GroundPiece& piece : pieces)
        highest = std::max({highest, piece.y, piece.end_y});
    return highest;
}

// Half the sides of the upright box around a part, m.
GroundSpot extent_of(const PlacedBox& box) {
    const double along = std::fabs(box.axis_x);
    const double across = std::fabs(box.axis_y);
    return {along * box.half_length + across * box.half_width,
            across * box.half_length + along * box.half_width};
}

GroundSpot box_corner(const PlacedBox& box, int corner) {
    const double along = (corner & 1) != 0 ? box.half_length : -box.half_length;
    const double across = (corner & 2) != 0 ? box.half_width : -box.half_width;
    return {box.x + box.axis_x * along - box.axis_y * across,
            box.y + box.axis_y * along + box.axis_x * across};
}

// Where the foot of a point is along a piece, and its distance in front of it, m.
struct PieceFoot {
    double along, gap;
};

PieceFoot foot_on(const GroundPiece& piece, const GroundSpot& point) {
    const double x = point.x - piece.x;
    const double y = point.y - piece.y;
    return {x * piece.way_x + y * piece.way_y, x * piece.normal_x + y * piece.normal_y};
}

// Whether the foot is within the piece. A piece goes on by `margin` behind what is before it, where
// the ground is concave.
bool reaches(const GroundPiece& piece, const PieceFoot& foot, double margin) {
    const double before = piece.inner_turn > kStraightOn ? margin : 0.0;
    const double beyond = piece.outer_turn > kStraightOn ? margin : 0.0;
    return foot.along >= -before && foot.along <= piece.length + beyond;
}

const GroundPiece& outer_of(const GroundPiece& left, const GroundPiece& right) {
    return right.number > 0 ? right : left;
}

// The sine of the turn from one piece to the next.
double turn_between(const GroundPiece& left, const GroundPiece& right) {
    return outer_of(left, right).inner_turn;
}

// Features are numbered outwards from the start, so that a mirror image has the same order.
int feature_of_piece(int number) {
    return (number > 0 ? 2 * number - 1 : -2 * number) & (kTerrainFeatures / 2 - 1);
}

// The contacts of one part with the ground.
class PartOnTerrain {
public:
    PartOnTerrain(const PlanarModel& model, const Kinematics& k, const PartPlaces& places, int part,
                  ContactSet& contacts)
        : k_(k),
          places_(places),
          box_(placed_box(places, part)),
          part_(part),
          body_(model.part_body[part]),
          contacts_(contacts) {}

    void add_corners(Pieces near, double highest);
    void add_points(Pieces near);

private:
    void add_corner(Pieces near, int corner, const GroundSpot& at);
    void add_sunk_corner(Pieces near, int corner, const GroundSpot& at, std::size_t below);
    void add_point(const GroundPiece& left, const GroundPiece& right);
    void add_face(int feature, const GroundSpot& point, const GroundPiece& left,
                  const GroundPiece& right, const GroundSpot& inside);
    void add(int feature, int kind, const GroundSpot& point, const GroundSpot& normal, double gap);
    void add_at_piece(const GroundPiece& piece, int corner, const GroundSpot& at, double gap) {
        add(2 * feature_of_piece(piece.number), corner, at, {piece.normal_x, piece.normal_y}, gap);
    }

    const Kinematics& k_;
    const PartPlaces& places_;
    PlacedBox box_;
    int part_, body_;
    ContactSet& contacts_;
};

void PartOnTerrain::add(int feature, int kind, const GroundSpot& point, const GroundSpot& normal,
                        double gap) {
    Contact* place = contacts_.make_room(gap);
    if (place == nullptr) return;
    Contact& c = *place;
    c = Contact{};
    c.id = kTerrainContactIds + kIdsPerFeature * (kTerrainFeatures * body_ + feature) + 8 * part_ +
           kind;
    c.body_a = body_;
    c.part_a = part_;
    c.normal_x = normal.x;
    c.normal_y = normal.y;
    c.face_a = touching_face(places_, part_, -normal.x, -normal.y);
    c.arm_ax = point.x - k_.x[body_];
    c.arm_ay = point.y - k_.y[body_];
    c.point_x = k_.cosine[body_] * c.arm_ax + k_.sine[body_] * c.arm_ay;
    c.point_y = k_.cosine[body_] * c.arm_ay - k_.sine[body_] * c.arm_ax;
    c.gap = gap;
    c.closing_speed = -(normal.x * (k_.velocity_x[body_] - k_.spin[body_] * c.arm_ay) +
                        normal.y * (k_.velocity_y[body_] + k_.spin[body_] * c.arm_ax));
}

// From the lowest corner up, so that a mirror image has the same order.
void PartOnTerrain::add_corners(Pieces near, double highest) {
    const double along_y = box_.axis_y * box_.half_length;
    const double across_y = box_.axis_x * box_.half_width;
    const int lowest = (along_y > 0.0 ? 0 : 1) + (across_y > 0.0 ? 0 : 2);
    const int next = std::fabs(along_y) < std::fabs(across_y) ? 1 : 2;
    for (const int corner : {lowest, lowest ^ next, lowest ^ next ^ 3, lowest ^ 3}) {
        const GroundSpot at = box_corner(box_, corner);
        if (at.y <= highest + kContactMargin) add_corner(near, corner, at);
    }
}

void PartOnTerrain::add_corner(Pieces near, int corner, const GroundSpot& at) {
    for (std::size_t i = 0; i < near.size(); ++i) {
        if (at.x < near[i].left() || at.x >= near[i].right()) continue;
        if (foot_on(near[i], at).gap < 0.0) return add_sunk_corner(near, corner, at, i);
    }
    for (const GroundPiece& piece : near) {
        const PieceFoot foot = foot_on(piece, at);
        if (foot.gap < 0.0 || foot.gap > kContactMargin) continue;
        if (reaches(piece, foot, kContactMargin)) add_at_piece(piece, corner, at, foot.gap);
    }
}

// A corner in the ground leaves it by the nearest piece. Where the ground is concave beside that
// piece, the corner must be in front of both.
void PartOnTerrain::add_sunk_corner(Pieces near, int corner, const GroundSpot& at,
                                    std::size_t below) {
    std::size_t nearest = below;
    double gap = -1e9;
    for (std::size_t i = 0; i < near.size(); ++i) {
        const PieceFoot foot = foot_on(near[i], at);
        if (foot.gap >= 0.0 || foot.gap <= gap || !reaches(near[i], foot, 0.0)) continue;
        nearest = i;
        gap = foot.gap;
    }
    const std::size_t first = nearest > 0 ? nearest - 1 : 0;
    for (std::size_t i = first; i < std::min(near.size(), nearest + 2); ++i) {
        const PieceFoot foot = foot_on(near[i], at);
        if (i != nearest) {
            const double turn =
                turn_between(near[std::min(i, nearest)], near[std::max(i, nearest)]);
            if (turn <= kStraightOn || foot.gap > kContactMargin ||
                !reaches(near[i], foot, kContactMargin))
                continue;
        }
        add_at_piece(near[i], corner, at, foot.gap);
    }
}

// Adds contacts of the points at which the ground is convex.
void PartOnTerrain::add_points(Pieces near) {
    for (std::size_t i = 0; i + 1 < near.size(); ++i)
        add_point(near[i], near[i + 1]);
}

void PartOnTerrain::add_point(const GroundPiece& left, const GroundPiece& right) {
    const GroundPiece& outer = outer_of(left, right);
    if (outer.inner_turn >= -kStraightOn) return;
    const GroundSpot point{outer.x, outer.y};
    const double x = point.x - box_.x;
    const double y = point.y - box_.y;
    const GroundSpot inside{box_.axis_x * x + box_.axis_y * y, box_.axis_x * y - box_.axis_y * x};
    const double along = std::fabs(inside.x) - box_.half_length;
    const double across = std::fabs(inside.y) - box_.half_width;
    if (along > kContactMargin || across > kContactMargin) return;
    const int feature = 2 * feature_of_piece(outer.number) + 1;
    if (!(along > 0.0 && across > 0.0)) return add_face(feature, point, left, right, inside);
    const int corner = (inside.x > 0.0 ? 1 : 0) + (inside.y > 0.0 ? 2 : 0);
    const GroundSpot at = box_corner(box_, corner);
    const double away_x = at.x - point.x;
    const double away_y = at.y - point.y;
    const double gap = std::sqrt(away_x * away_x + away_y * away_y);
    const bool in_cone =
        turn_sine(left.normal_x, left.normal_y, away_x, away_y) <= 0.0 &&
        turn_sine(away_x, away_y, right.normal_x, right.normal_y) <= 0.0 &&
        away_x * (left.normal_x + right.normal_x) + away_y * (left.normal_y + right.normal_y) > 0.0;
    if (in_cone && gap > 0.0 && gap <= kContactMargin)
        add(feature, 4 + corner, at, {away_x / gap, away_y / gap}, gap);
}

// Returns the distance of a box in front of a piece that has no ends, m.
double distance_before(const PlacedBox& box, const GroundPiece& piece) {
    const double along = box.axis_x * piece.normal_x + box.axis_y * piece.normal_y;
    const double across = box.axis_x * piece.normal_y - box.axis_y * piece.normal_x;
    return foot_on(piece, {box.x, box.y}).gap - std::fabs(along) * box.half_length -
           std::fabs(across) * box.half_width;
}

// Adds the contact of a point of the ground with the face that it is nearest to, of those whose
// normal is in the cone of the ground's normals there. Of all directions in which the box may leave
// the ground around the point it must be the nearest one; the pieces' own are for its corners.
void PartOnTerrain::add_face(int feature, const GroundSpot& point, const GroundPiece& left,
                             const GroundPiece& right, const GroundSpot& inside) {
    int nearest = -1;
    double gap = -1e9;
    GroundSpot normal{0.0, 0.0};
    for (int face = 0; face < 4; ++face) {
        const bool is_end = face < 2;
        const double sign = (face & 1) != 0 ? 1.0 : -1.0;
        const double beside =
            is_end ? std::fabs(inside.y) - box_.half_width : std::fabs(inside.x) - box_.half_length;
        const double distance =
            is_end ? sign * inside.x - box_.half_length : sign * inside.y - box_.half_width;
        if (beside > 0.0 || distance <= gap || distance > kContactMargin) continue;
        const GroundSpot into = is_end ? GroundSpot{-sign * box_.axis_x, -sign * box_.axis_y}
                                       : GroundSpot{sign * box_.axis_y, -sign * box_.axis_x};
        if (turn_sine(left.normal_x, left.normal_y, into.x, into.y) > kConeSlack ||
            turn_sine(into.x, into.y, right.normal_x, right.normal_y) > kConeSlack ||
            into.x * (left.normal_x + right.normal_x) + into.y * (left.normal_y + right.normal_y) <=
                0.0)
            continue;
        nearest = face;
        gap = distance;
        normal = into;
    }
    const double before = std::max(distance_before(box_, left), distance_before(box_, right));
    if (nearest >= 0 && gap >= before - kContactBand) add(feature, nearest, point, normal, gap);
}

int feature_group(const Contact& contact) {
    return (contact.id - kTerrainContactIds) / kIdsPerFeature;
}

// Sorts by body and feature.
void sort_by_group(ContactSet& contacts) {
    for (int i = 1; i < contacts.count; ++i) {
        const int group = feature_group(contacts.items[i]);
        if (group >= feature_group(contacts.items[i - 1])) continue;
        const Contact moved = contacts.items[i];
        int place = i;
        for (; place > 0 && feature_group(contacts.items[place - 1]) > group; --place)
            contacts.items[place] = contacts.items[place - 1];
        contacts.items[place] = moved;
    }
}

double piece_height(const GroundPiece& piece, double x) {
    return piece.y + (x - piece.x) * (piece.way_y / piece.way_x);
}

// Returns the least height of a box above pieces. It is at a corner of the box or at a point of the
// ground.
double height_above(const PlacedBox& box, Pieces near) {
    constexpr std::pair<int, int> kEdges[] = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
    double least = 1e9;
    for (int corner = 0; corner < 4; ++corner) {
        const GroundSpot at = box_corner(box, corner);
        for (const GroundPiece& piece : near) {
            if (at.x >= piece.left() && at.x < piece.right())
                least = std::min(least, at.y - piece_height(piece, at.x));
        }
    }
    for (const GroundPiece& piece : near.first(near.size() - 1)) {
        const double x = piece.right();
        const double top = piece.number < 0 ? piece.y : piece.end_y;
        for (const auto& [from, to] : kEdges) {
            const GroundSpot a = box_corner(box, from);
            const GroundSpot b = box_corner(box, to);
            if ((a.x - x) * (b.x - x) > 0.0 || a.x == b.x) continue;
            least = std::min(least, a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y) - top);
        }
    }
    return least;
}

}  // namespace

void detect_terrain_contacts(const PlanarModel& model, const Kinematics& k,
                             const PartPlaces& places, const TerrainSearch& search,
                             ContactSet& contacts) {
    PerPart reach;
    double left = 1e9;
    double right = -1e9;
    for (int part = 0; part < model.part_count; ++part) {
        const GroundSpot extent = extent_of(placed_box(places, part));
        reach[part] = extent.x + kContactMargin;
        left = std::min(left, places.x[part] - reach[part]);
        right = std::max(right, places.x[part] + reach[part]);
    }
    NearPieces memory;
    const Pieces near = find_near_pieces(search.terrain, left, right, search.guess, memory);
    const double highest = highest_of(near);
    for (int part = 0; part < model.part_count; ++part) {
        const double low = places.y[part] - extent_of(placed_box(places, part)).y - kContactMargin;
        if (low > highest) continue;
        const Pieces below =
            between(near, places.x[part] - reach[part], places.x[part] + reach[part]);
        const double top = highest_of(below);
        if (low > top) continue;
        PartOnTerrain on_terrain(model, k, places, part, contacts);
        on_terrain.add_corners(below, top);
        on_terrain.add_points(below);
    }
    sort_by_group(contacts);
}

double count_looks_at_terrain(const BoxEnds& ends, const BoxTravels& travels,
                              const Terrain& terrain) {
    double looks = 1.0;
    int guess = 0;
    NearPieces memory;
    for (int part = 0; part < ends.model.part_count; ++part) {
        const double travel = travel_of(ends, travels, part);
        if (travel <= looks * terrain.narrowest()) continue;
        const PlacedBox box = placed_box(ends.from, part);
        const GroundSpot reach = extent_of(box);
        const Pieces near = find_near_pieces(terrain, box.x - reach.x - travel,
                                             box.x + reach.x + travel, guess, memory);
        if (box.y - reach.y - travel <= highest_of(near)) looks = travel / terrain.narrowest();
    }
    return looks;
}

double height_above_terrain(const PlanarModel& model, const PartPlaces& places,
                            const Terrain& terrain) {
    double left = 1e9;
    double right = -1e9;
    for (int part = 0; part < model.part_count; ++part) {
        const double reach = extent_of(placed_box(places, part)).x;
        left = std::min(left, places.x[part] - reach);
        right = std::max(right, places.x[part] + reach);
    }
    int guess = 0;
    NearPieces memory;
    const Pieces near = find_near_pieces(terrain, left, right, guess, memory);
    double least = 1e9;
    for (int part = 0; part < model.part_count; ++part) {
        const PlacedBox box = placed_box(places, part);
        const double reach = extent_of(box).x;
        least = std::min(least, height_above(box, between(near, box.x - reach, box.x + reach)));
    }
    return least;
}

}  // namespace cambrian
