#include "studio/panels/viewport/space_overlays.h"

#include "math/elementary.h"
#include "world/environment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kNearestPoint = 0.02;  // m from the camera; nearer points are not drawn
constexpr int kArcPieces = 20;          // of half a turn

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
    place.radius = 0.6 * part.half_extents.x();
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

void add_arc(SceneFrame& frame, const SpaceCamera& camera, const DegreePlace& joint, const Arc& arc,
             double pixels, const Color& color) {
    const auto [radius, from, to] = arc;
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(kArcPieces * std::fabs(to - from) / kPi)));
    Vec3 before = joint.pivot + radius * turned(joint.needle, joint.axis, from);
    for (int i = 1; i <= pieces; ++i) {
        const Vec3 next = joint.pivot + radius * turned(joint.needle, joint.axis,
                                                        from + (to - from) * i / pieces);
        add_line(frame, camera, before, next, pixels, color);
        before = next;
    }
}

// Draws the cone in which a ball may swing, and where its part points.
void add_cone(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over,
              const JointDegree& degree, const Color& color) {
    constexpr int pieces = 2 * kArcPieces;
    constexpr int kEvery = 5;  // pieces between two lines from the joint
    const std::vector<PlannedPart>& parts = over.look.phenotype.plan.parts;
    const PlannedPart& part = parts[degree.part];
    const auto parent = static_cast<std::size_t>(part.parent);
    const Pose& pose = over.look.poses[degree.part];
    const Vec3 pivot = transform(pose, part.anchor_in_child);
    // The frame of the part if the joint were at rest.
    const Rotation rest = over.look.poses[parent].orientation *
                          parts[parent].rest_pose.orientation.conjugate() *
                          part.rest_pose.orientation;
    const double radius = 0.6 * part.half_extents.x();
    const auto [sine, cosine] = sine_cosine(limits_of(part, 0).high);
    const auto rim = [&, sine = sine, cosine = cosine](int piece) {
        const auto [across, up] = sine_cosine(2.0 * kPi * piece / pieces);
        return Vec3(pivot + radius * (rest * Vec3(cosine, sine * up, sine * across)));
    };
    for (int piece = 0; piece < pieces; ++piece) {
        add_line(frame, camera, rim(piece), rim(piece + 1), 2.0, color);
        if (piece % kEvery == 0)
            add_line(frame, camera, pivot, rim(piece), 1.0, with_alpha(color, 0.5F));
    }
    add_line(frame, camera, pivot, pivot + radius * (pose.orientation * Vec3::UnitX()), 2.0,
             over.palette.accent);
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
    if (camera.look_at(from).distance < kNearestPoint ||
        camera.look_at(to).distance < kNearestPoint)
        return;
    frame.add_line(in_picture(camera, from), in_picture(camera, to), pixels, color);
}

void add_joint_axes(SceneFrame& frame, const SpaceCamera& camera, const OverlayScene& over) {
    for (const JointDegree& degree : over.look.phenotype.effectors) {
        const DegreePlace joint = place_of(over, degree);
        const PlannedPart& part = over.look.phenotype.plan.parts[degree.part];
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
        if (part.motion == JointMotion::kBall && degree.degree < 2) {
            if (degree.degree == 0) add_cone(frame, camera, over, degree, color);
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
        const Vec3 share = kind.spot ? kind.spot(sensor.channel, sensor.handedness) : Vec3::Zero();
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
