#include "studio/panels/viewport/scene_overlays.h"

#include "math/elementary.h"
#include "pictures/scene/shown_shape.h"
#include "world/environment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

Vec2 drawn_point(const Vec3& point) {
    return point.head<2>();
}

Vec2 direction(double angle) {
    const SineCosine turn = sine_cosine(angle);
    return {turn.cosine, turn.sine};
}

// The present position of a joint.
struct JointPlace {
    Vec2 pivot;
    double radius = 0.0;      // m; radius of arcs about the joint
    double angle = 0.0;       // rad; direction of the part
    double rest = 0.0;        // rad; direction of the part with the joint at rest
    double coordinate = 0.0;  // rad or m; joint coordinate
    bool slides = false;
};

JointPlace place_of(const OverlayScene& over, std::size_t index) {
    const BodyPlan& plan = over.look.phenotype.plan;
    const PlannedPart& part = plan.parts[index];
    const Pose& pose = over.look.poses[index];
    JointPlace place;
    place.pivot =
        drawn_point(transform(pose, shown_point(part.anchor_in_child, over.look.stretches, index)));
    place.radius = std::max(14.0 * over.pixel, 0.6 * part.half_extents.x());
    place.angle = planar_angle(pose);
    place.coordinate = over.scene.joint_coordinate(index);
    place.slides = part.motion == JointMotion::kSlide;
    place.rest = place.slides ? place.angle : place.angle - place.coordinate;
    return place;
}

void add_joint_reading(SceneFrame& frame, const OverlayScene& over, const JointPlace& joint) {
    const Color& color = over.palette.plot_median;
    const double width = 3.0 * over.pixel;
    if (joint.slides) {
        const Vec2 along = joint.coordinate * direction(joint.angle);
        frame.add_line(joint.pivot - along, joint.pivot, width, color);
    } else {
        frame.add_arc(joint.pivot, 0.7 * joint.radius, {joint.rest, joint.angle}, width, color);
    }
    frame.add_circle(joint.pivot, 1.2 * width, color);
}

// Draws a lamp: bright for a reading of +1, dark for -1.
void add_lamp(SceneFrame& frame, const OverlayScene& over, std::size_t index) {
    const WiredSensor& sensor = over.creature.phenotype().sensors[index];
    const SensorKind& kind = over.kinds.sensors[sensor.kind];
    const Vec3 share = kind.spot ? kind.spot(sensor.channel, sensor.mirror.across) : Vec3::Zero();
    const Vec3 inside = share.cwiseProduct(
        shown_half_extents(over.look.phenotype.plan, over.look.stretches, sensor.part));
    const Vec2 at = drawn_point(transform(over.look.poses[sensor.part], inside));
    const double reading = over.creature.reading(index, over.scene, over.surroundings);
    const auto light = static_cast<float>(std::clamp(0.5 + 0.5 * reading, 0.0, 1.0));
    const double radius = 4.0 * over.pixel;
    frame.add_circle(at, radius, color_of(0x0B0E12, 0.8F));
    frame.add_circle(at, 0.7 * radius, mix(over.palette.faint, over.palette.plot_best, light));
}

}  // namespace

void add_joint_limits(SceneFrame& frame, const OverlayScene& over) {
    const Color color = with_alpha(over.palette.text, 0.75F);
    const double width = 1.5 * over.pixel;
    for (const auto& [index, degree] : over.look.phenotype.effectors) {
        if (degree > 0) continue;
        const PlannedPart& part = over.look.phenotype.plan.parts[index];
        const JointPlace joint = place_of(over, index);
        if (joint.slides) {
            const Vec2 axis = direction(joint.angle);
            const Vec2 rest = joint.pivot - joint.coordinate * axis;
            frame.add_line(rest + part.limit_low * axis, rest + part.limit_high * axis, width,
                           color);
            frame.add_circle(joint.pivot, 2.0 * width, over.palette.accent);
            continue;
        }
        const double low = joint.rest + part.limit_low;
        const double high = joint.rest + part.limit_high;
        frame.add_arc(joint.pivot, joint.radius, {low, high}, width, color);
        for (const double end : {low, high}) {
            frame.add_line(joint.pivot + 0.8 * joint.radius * direction(end),
                           joint.pivot + 1.1 * joint.radius * direction(end), width, color);
        }
        frame.add_line(joint.pivot, joint.pivot + joint.radius * direction(joint.angle), width,
                       over.palette.accent);
    }
}

void add_joint_torques(SceneFrame& frame, const OverlayScene& over) {
    for (const auto& [index, degree] : over.look.phenotype.effectors) {
        if (degree > 0) continue;
        const PlannedPart& part = over.look.phenotype.plan.parts[index];
        if (part.max_effort <= 0.0) continue;
        const double share =
            std::clamp(over.scene.joint_effort(index) / part.max_effort, -1.0, 1.0);
        if (std::fabs(share) < 0.01) continue;
        const JointPlace joint = place_of(over, index);
        const double width = 4.0 * over.pixel;
        const Color color =
            mix(over.palette.plot_best, over.palette.danger, static_cast<float>(std::fabs(share)));
        Vec2 tip;
        if (joint.slides) {
            tip = joint.pivot + share * joint.radius * direction(joint.angle);
            frame.add_line(joint.pivot, tip, width, color);
        } else {
            const double end = joint.angle + share * kFullTorqueTurn;
            tip = joint.pivot + 0.85 * joint.radius * direction(end);
            frame.add_arc(joint.pivot, 0.85 * joint.radius, {joint.angle, end}, width, color);
        }
        frame.add_circle(tip, 1.2 * width, color);
    }
}

void add_sensor_readings(SceneFrame& frame, const OverlayScene& over) {
    const std::vector<WiredSensor>& sensors = over.creature.phenotype().sensors;
    for (std::size_t i = 0; i < sensors.size(); ++i) {
        if (over.kinds.sensors[sensors[i].kind].reads_joint) {
            add_joint_reading(frame, over, place_of(over, sensors[i].part));
        } else {
            add_lamp(frame, over, i);
        }
    }
}

void add_contact_forces(SceneFrame& frame, const OverlayScene& over) {
    std::vector<SceneContact> contacts;
    over.scene.list_contacts(contacts);
    const double weight = over.scene.mass() * kEarthGravity;
    for (const SceneContact& contact : contacts) {
        const Vec2 at = drawn_point(contact.point);
        const double length = kForceLength * std::min(contact.force / weight, 6.0);
        frame.add_line(at, at + length * drawn_point(contact.normal), 2.0 * over.pixel,
                       over.palette.accent);
        frame.add_circle(at, 3.5 * over.pixel, over.palette.accent);
    }
}

void add_center_of_mass(SceneFrame& frame, const OverlayScene& over, const Vec2& center) {
    const double radius = 7.0 * over.pixel;
    frame.add_circle(center, radius + 1.5 * over.pixel, color_of(0x0B0E12, 0.8F));
    frame.add_ring(center, radius, 2.0 * over.pixel, color_of(0xF2F4F7));
    frame.add_circle(center, 2.5 * over.pixel, color_of(0xF2F4F7));
}

}  // namespace cambrian
