#include "studio/panels/viewport/space_overlays.h"

#include "math/elementary.h"
#include "world/environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

constexpr double kNearestPoint = 0.02;  // m from the camera; nearer points are not drawn
constexpr int kArcPieces = 20;          // of half a turn
constexpr double kLeastArc = 0.08;      // m; least radius of arcs about a joint
constexpr double kHaloPixels = 2.0;     // by which the shade under a line is wider
const Color kHalo = color_of(0x0B0E12, 0.38F);

Vec3 turned(const Vec3& vector, const Vec3& axis, double angle) {
    const auto [sine, cosine] = sine_cosine(angle);
    return cosine * vector + sine * axis.cross(vector) + (1.0 - cosine) * axis.dot(vector) * axis;
}

// The present place of a degree of freedom of a joint.
struct DegreePlace {
    Vec3 pivot;
    Vec3 axis;                // of length 1
    Vec3 needle;              // the same, across the axis, as the part points now
    double radius = 0.0;      // m; of arcs about the joint
    double coordinate = 0.0;  // rad or m
    DegreeLimits limits;
    bool slides = false;
};

DegreePlace place_of(const OverlayScene& over, const JointDegree& degree) {
    const PlannedPart& part = over.look.phenotype.plan.parts[degree.part];
    const Pose& pose = over.look.poses[degree.part];
    DegreePlace place;
    place.pivot = transform(pose, part.anchor_in_child);
    place.coordinate = over.scene.joint_coordinate(degree);
    place.limits = limits_of(part, degree.degree);
    place.slides = part.motion == JointMotion::kSlide;
    place.radius = std::max(kLeastArc, 0.75 * part.half_extents.x());
    Vec3 axis = Vec3::Unit(place.slides ? 0 : part.axes[degree.degree]);
    // The hinges after it have turned the part away from its axis; those of a ball are the part's.
    const std::size_t hinges = part.motion == JointMotion::kBall ? 0 : degrees_of(part);
    for (std::size_t after = degree.degree + std::size_t{1}; after < hinges; ++after) {
        const JointDegree other{degree.part, static_cast<std::uint8_t>(after)};
        axis = turned(axis, Vec3::Unit(part.axes[after]), -over.scene.joint_coordinate(other));
    }
    place.axis = pose.orientation * axis;
    Vec3 needle = pose.orientation * Vec3::UnitX();
    needle -= needle.dot(place.axis) * place.axis;
    if (needle.norm() < 0.3) {
        needle = pose.orientation * Vec3::UnitY();
        needle -= needle.dot(place.axis) * place.axis;
    }
    place.needle = needle.normalized();
    return place;
}

// Part of a circle about a joint's axis.
struct Arc {
    double radius, from, to;  // m, rad, rad
};

// Draws lines from each point to the next, over a shade that tells them from a bright ground.
void add_path(SceneFrame& frame, const SpaceCamera& camera, std::span<const Vec3> points,
              double pixels, const Color& color) {
    for (const Vec3& point : points) {
        if (camera.look_at(point).distance < kNearestPoint) return;
    }
    for (const bool shade : {true, false}) {
        for (std::size_t i = 1; i < points.size(); ++i)
            frame.add_line(in_picture(camera, points[i - 1]), in_picture(camera, points[i]),
                           shade ? pixels + kHaloPixels : pixels,
                           shade ? with_alpha(kHalo, kHalo.a * color.a) : color);
    }
}

void add_arc(SceneFrame& frame, const SpaceCamera& camera, const DegreePlace& joint, const Arc& arc,
             double pixels, const Color& color) {
    const auto [radius, from, to] = arc;
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(kArcPieces * std::fabs(to - from) / kPi)));
    std::vector<Vec3> points;
    for (int i = 0; i <= pieces; ++i)
        points.push_back(joint.pivot + radius * turned(joint.needle, joint.axis,
                                                       from + (to - from) * i / pieces));
    add_path(frame, camera, points, pixels, color);
}

// Draws the two lines from a joint that touch the outline of a ring in the picture, if the joint is
// outside of it.
void add_tangents(SceneFrame& frame, const SpaceCamera& camera, const Vec3& pivot,
                  std::span<const Vec3> ring, double pixels, const Color& color) {
    const Vec2 from = in_picture(camera, pivot);
    Vec2 middle = Vec2::Zero();
    for (const Vec3& point : ring)
        middle += in_picture(camera, point) - from;
    std::array<const Vec3*, 2> ends = {&ring.front(), &ring.front()};
    std::array<double, 2> most = {0.0, 0.0};  // tangents of the angles to each side
    for (const Vec3& point : ring) {
        const Vec2 way = in_picture(camera, point) - from;
        const double along = way.dot(middle);
        if (along <= 0.0) return;
        const double aside = (middle.x() * way.y() - middle.y() * way.x()) / along;
        if (aside > most[0]) ends[0] = &point;
        if (aside < most[1]) ends[1] = &point;
        most = {std::max(most[0], aside), std::min(most[1], aside)};
    }
    for (const Vec3* end : ends)
        add_line(frame, camera, pivot, *end, pixels, color);
}

// Draws the cone in which a ball may swing, where its part points, and how far it may twist: an arc
// round its tip.
void add_ball_limits(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over,
                     const JointDegree& twist, const DegreePlace& joint) {
    constexpr int pieces = 2 * kArcPieces;
    constexpr double kTwistShare = 0.45;  // radius of the arc of twist
    const std::vector<PlannedPart>& parts = over.look.phenotype.plan.parts;
    const PlannedPart& part = parts[twist.part];
    const auto parent = static_cast<std::size_t>(part.parent);
    // The frame of the part if the joint were at rest.
    const Rotation rest = over.look.poses[parent].orientation *
                          parts[parent].rest_pose.orientation.conjugate() *
                          part.rest_pose.orientation;
    const auto [sine, cosine] = sine_cosine(limits_of(part, 0).high);
    std::vector<Vec3> rim;
    for (int piece = 0; piece <= pieces; ++piece) {
        const auto [across, up] = sine_cosine(2.0 * kPi * piece / pieces);
        rim.emplace_back(joint.pivot +
                         joint.radius * (rest * Vec3(cosine, sine * up, sine * across)));
    }
    const Color swing = mix(axis_color(2), over.palette.text, 0.25F);
    add_tangents(frame, camera, joint.pivot, rim, 1.2, with_alpha(swing, 0.8F));
    add_path(frame, camera, rim, 2.0, swing);
    DegreePlace tip = joint;
    tip.pivot = joint.pivot + joint.radius * joint.axis;
    tip.radius = kTwistShare * joint.radius;
    const Color turn = mix(axis_color(0), over.palette.text, 0.25F);
    add_arc(frame, camera, tip,
            {tip.radius, joint.limits.low - joint.coordinate, joint.limits.high - joint.coordinate},
            2.0, turn);
    const std::array<Vec3, 3> needle = {joint.pivot, tip.pivot,
                                        tip.pivot + tip.radius * joint.needle};
    add_path(frame, camera, needle, 2.0, over.palette.accent);
}

void add_dot(SceneFrame& frame, const SpaceCamera& camera, const Vec3& at, double pixels,
             const Color& color) {
    if (camera.look_at(at).distance > kNearestPoint)
        frame.add_circle(in_picture(camera, at), pixels, color);
}

}  // namespace

const Color& axis_color(int axis) {
    static const std::array<Color, 3> kAxes = {color_of(0xE2605A), color_of(0x7CB74E),
                                               color_of(0x4F8FE0)};
    return kAxes[static_cast<std::size_t>(axis)];
}

void add_line(SceneFrame& frame, const SpaceCamera& camera, const Vec3& from, const Vec3& to,
              double pixels, const Color& color) {
    const std::array<Vec3, 2> points = {from, to};
    add_path(frame, camera, points, pixels, color);
}

void add_edges(SceneFrame& frame, const SpaceCamera& camera, const CreatureLook& look,
               const Color& ink) {
    constexpr double kEdgePixels = 1.4;
    constexpr float kHiddenShare = 0.3F;
    for (std::size_t i = 0; i < look.poses.size(); ++i) {
        const Pose& pose = look.poses[i];
        const Vec3& half = look.phenotype.plan.parts[i].half_extents;
        const Color color = mix(part_color(look.phenotype.parts[i], look.hue), ink, 0.6F);
        const Vec3 eye = pose.orientation.conjugate() * Vec3(camera.place() - pose.position);
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            for (const auto& [a, b] :
                 {std::pair{-1.0, -1.0}, {-1.0, 1.0}, {1.0, -1.0}, {1.0, 1.0}}) {
                Vec3 end = Vec3::Zero();
                end[u] = a * half[u];
                end[v] = b * half[v];
                end[axis] = half[axis];
                Vec3 start = end;
                start[axis] = -half[axis];
                const bool seen = a * eye[u] > half[u] || b * eye[v] > half[v];
                if (camera.look_at(transform(pose, start)).distance < kNearestPoint ||
                    camera.look_at(transform(pose, end)).distance < kNearestPoint)
                    continue;
                frame.add_line(in_picture(camera, transform(pose, start)),
                               in_picture(camera, transform(pose, end)), kEdgePixels,
                               with_alpha(color, seen ? 0.9F : kHiddenShare));
            }
        }
    }
}

void add_joint_axes(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over,
                    bool of_balls) {
    for (const JointDegree& degree : over.look.phenotype.effectors) {
        const DegreePlace joint = place_of(over, degree);
        const PlannedPart& part = over.look.phenotype.plan.parts[degree.part];
        if (part.motion == JointMotion::kBall && !of_balls) continue;
        const double half = 0.8 * part.half_extents.tail<2>().maxCoeff() + 0.02;
        const int axis = joint.slides ? 0 : part.axes[degree.degree];
        add_line(frame, camera, joint.pivot - half * joint.axis, joint.pivot + half * joint.axis,
                 2.5, axis_color(axis));
        add_dot(frame, camera, joint.pivot, 4.5, color_of(0x14171C, 0.9F));
        add_dot(frame, camera, joint.pivot, 3.0, color_of(0xF2F4F7));
    }
}

void add_joint_limits(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over) {
    for (const JointDegree& degree : over.look.phenotype.effectors) {
        const DegreePlace joint = place_of(over, degree);
        const PlannedPart& part = over.look.phenotype.plan.parts[degree.part];
        const Color color =
            mix(axis_color(joint.slides ? 0 : part.axes[degree.degree]), over.palette.text, 0.25F);
        if (part.motion == JointMotion::kBall) {
            if (degree.degree == 2) add_ball_limits(frame, camera, over, degree, joint);
            continue;
        }
        const double low = joint.limits.low - joint.coordinate;
        const double high = joint.limits.high - joint.coordinate;
        if (joint.slides) {
            add_line(frame, camera, joint.pivot + low * joint.axis, joint.pivot + high * joint.axis,
                     2.0, color);
            add_dot(frame, camera, joint.pivot, 3.0, over.palette.accent);
            continue;
        }
        add_arc(frame, camera, joint, {joint.radius, low, high}, 2.0, color);
        for (const double end : {low, high})
            add_line(frame, camera, joint.pivot,
                     joint.pivot + joint.radius * turned(joint.needle, joint.axis, end), 1.2,
                     with_alpha(color, 0.7F));
        add_line(frame, camera, joint.pivot, joint.pivot + joint.radius * joint.needle, 2.0,
                 over.palette.accent);
    }
}

void add_joint_torques(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over) {
    for (const JointDegree& degree : over.look.phenotype.effectors) {
        const DegreePlace joint = place_of(over, degree);
        if (joint.limits.max_effort <= 0.0) continue;
        const double share =
            std::clamp(over.scene.joint_effort(degree) / joint.limits.max_effort, -1.0, 1.0);
        if (std::fabs(share) < 0.01) continue;
        const Color color =
            mix(over.palette.plot_best, over.palette.danger, static_cast<float>(std::fabs(share)));
        Vec3 tip = joint.pivot + share * joint.radius * joint.axis;
        if (joint.slides) {
            add_line(frame, camera, joint.pivot, tip, 4.0, color);
        } else {
            const double end = share * kFullTorqueTurn;
            add_arc(frame, camera, joint, {0.85 * joint.radius, 0.0, end}, 4.0, color);
            tip = joint.pivot + 0.85 * joint.radius * turned(joint.needle, joint.axis, end);
        }
        add_dot(frame, camera, tip, 5.0, color);
    }
}

void add_sensor_readings(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over) {
    const std::vector<WiredSensor>& sensors = over.creature.phenotype().sensors;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        const WiredSensor& sensor = sensors[i];
        const SensorKind& kind = over.kinds.sensors[sensor.kind];
        const PlannedPart& part = over.look.phenotype.plan.parts[sensor.part];
        if (kind.reads_joint && degrees_of(part) > 0) {
            const DegreePlace joint = place_of(over, {sensor.part, 0});
            const Color& color = over.palette.plot_median;
            if (joint.slides) {
                add_line(frame, camera, joint.pivot - joint.coordinate * joint.axis, joint.pivot,
                         3.0, color);
            } else {
                add_arc(frame, camera, joint, {0.7 * joint.radius, -joint.coordinate, 0.0}, 3.0,
                        color);
            }
            add_dot(frame, camera, joint.pivot, 3.6, color);
            continue;
        }
        const Vec3 share =
            kind.spot ? kind.spot(sensor.channel, sensor.mirror.across) : Vec3::Zero();
        const Vec3 at =
            transform(over.look.poses[sensor.part], share.cwiseProduct(part.half_extents));
        const double reading = over.creature.reading(i, over.scene, over.surroundings);
        const auto light = static_cast<float>(std::clamp(0.5 + 0.5 * reading, 0.0, 1.0));
        add_dot(frame, camera, at, 4.0, color_of(0x0B0E12, 0.8F));
        add_dot(frame, camera, at, 2.8, mix(over.palette.faint, over.palette.plot_best, light));
    }
}

void add_contact_forces(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over) {
    std::vector<SceneContact> contacts;
    over.scene.list_contacts(contacts);
    const double weight = over.scene.mass() * kEarthGravity;
    for (const SceneContact& contact : contacts) {
        const double length = kForceLength * std::min(contact.force / weight, 6.0);
        add_line(frame, camera, contact.point, contact.point + length * contact.normal, 2.0,
                 over.palette.accent);
        add_dot(frame, camera, contact.point, 3.5, over.palette.accent);
    }
}

void add_center_of_mass(SceneFrame& frame, const SpaceCamera& camera, const Vec3& center,
                        bool has_ground) {
    if (camera.look_at(center).distance < kNearestPoint) return;
    if (has_ground)
        add_line(frame, camera, center, {center.x(), 0.0, center.z()}, 1.2,
                 color_of(0xF2F4F7, 0.6F));
    const Vec2 at = in_picture(camera, center);
    frame.add_circle(at, 8.5, color_of(0x0B0E12, 0.8F));
    frame.add_ring(at, 7.0, 2.0, color_of(0xF2F4F7));
    frame.add_circle(at, 2.5, color_of(0xF2F4F7));
}

void add_touched_faces(SceneFrame& frame, const SpaceCamera& camera, const CreatureLook& look,
                       const Color& color) {
    // The normals of the faces, in their order.
    constexpr std::array<std::array<int, 2>, 6> kNormals = {
        {{0, 1}, {1, 1}, {0, -1}, {1, -1}, {2, 1}, {2, -1}}};
    for (std::size_t i = 0; i < look.touched.size(); ++i) {
        const Vec3& half = look.phenotype.plan.parts[i].half_extents;
        for (std::size_t face = 0; face < std::min(kFaceCount, kNormals.size()); ++face) {
            if ((look.touched[i] & face_bit(static_cast<Face>(face))) == 0) continue;
            const int axis = kNormals[face][0];
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            std::array<Vec3, 4> corners;
            for (std::size_t k = 0; k < corners.size(); ++k) {
                Vec3 inside = Vec3::Zero();
                inside[axis] = kNormals[face][1] * half[axis];
                inside[u] = (k == 1 || k == 2 ? 1.0 : -1.0) * half[u];
                inside[v] = (k >= 2 ? 1.0 : -1.0) * half[v];
                corners[k] = transform(look.poses[i], inside);
            }
            for (std::size_t k = 0; k < corners.size(); ++k)
                add_line(frame, camera, corners[k], corners[(k + 1) % corners.size()], 2.5, color);
        }
    }
}

}  // namespace cambrian
