#pragma once

// One creature in one environment, advanced tick by tick with motors. This is the interface between
// physics and the other layers. A scene must be used by one thread at a time. Its time starts at 0.

#include "core/hash.h"
#include "math/types.h"
#include "world/body_view.h"
#include "world/environment.h"
#include "world/fixed_box.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace cambrian {

enum class SceneStatus : std::uint8_t {
    kRunning,
    kInvalid,    // the motion is not finite or diverges
    kOverBudget  // the motion would take more evaluations than the settings allow
};

// A point of contact, for display.
struct SceneContact {
    Vec3 point = Vec3::Zero();   // m, world
    Vec3 normal = Vec3::Zero();  // unit vector out of the touched surface
    double force = 0.0;          // N along the normal
};

class PhysicsScene;

// The impacts of two parts, or of a part on something fixed, during one tick.
struct SceneImpact {
    Vec3 point = Vec3::Zero();  // m, world
    int part = 0;
    int other_part = -1;   // -1: the ground, a fixed box or a part of another scene
    double impulse = 0.0;  // N s, sum of the normal impulses
    double lost = 0.0;     // J, kinetic energy that they took
    // The scene of the other part, if scenes are advanced as one and it is of another one.
    const PhysicsScene* other_scene = nullptr;
};

// The energy audit of the motion so far (simulator/README.md 4). Works are in J.
struct SceneAudit {
    double motor_work = 0.0;        // net work
    double gross_motor_work = 0.0;  // integral of |power|
    double drag_work = 0.0;         // <= 0
    double contact_work = 0.0;      // resting and sliding contact
    double limit_work = 0.0;        // joint limits
    double impulse_work = 0.0;      // impacts
    double positive_work = 0.0;     // energy added by contacts, limits and impacts; 0 in reality
    double energy_residual = 0.0;   // change of mechanical energy not explained by the works
    double energy_scale = 0.0;      // gross motor work + weight * 1 cm; reference for the residual
    // kg m^2/s, both seen once a second while nothing touches the body: the greatest change of its
    // angular momentum that nothing outside explains, and the greatest sum of its parts' momenta
    // plus that of 1e-3 rad/s. They are not stored.
    double spin_gained = 0.0;
    double spin_scale = 0.0;
    double max_penetration = 0.0;    // m
    double max_limit_overrun = 0.0;  // rad or m
    double max_part_speed = 0.0;     // m/s, at the ends of ticks
    double max_part_spin = 0.0;      // rad/s, at the ends of ticks
    std::uint64_t evaluations = 0;   // of the accelerations
    std::uint64_t steps = 0;         // accepted
    std::uint64_t rejections = 0;
    std::uint64_t events = 0;     // impacts
    std::uint64_t fallbacks = 0;  // complementarity problems that the solver failed on
};

// A stored state. It may be restored only by the scene that made it, or one with the same plan.
class SceneState {
public:
    virtual ~SceneState() = default;
};

// Scenes with equal ones can be advanced as one (joined_scenes.h).
struct SceneSize {
    int bodies = 0, trees = 0, parts = 0;

    SceneSize& operator+=(const SceneSize& other) {
        bodies += other.bodies;
        trees += other.trees;
        parts += other.parts;
        return *this;
    }
    bool fits(const SceneSize& room) const {
        return bodies <= room.bodies && trees <= room.trees && parts <= room.parts;
    }
};

// The memory in which scenes compute a tick; it holds nothing of a scene between two ticks.
class SceneWorkspace {
public:
    virtual ~SceneWorkspace() = default;
};

// All that a scene needs to go on with its motion, without what it remembers of contacts.
struct SceneMotion {
    // Of its coordinates; the last are those of the centre of mass of a body without loops.
    std::vector<double> positions, speeds;
    std::vector<double> targets;  // of the motors
};

inline constexpr std::size_t kMostImpacts = 16;
inline constexpr int kMostPulls = 4;

class PhysicsScene : public BodyView {
public:
    // Writes the coordinate of each of these degrees of freedom, in their order.
    virtual void list_joint_coordinates(std::span<const JointDegree> degrees,
                                        std::span<double> coordinates) const = 0;

    // Sets the motor target of a joint between a part and its parent, in the unit of the motor
    // mode: joint coordinate, joint rate, or share of max_effort. The motor's target approaches it
    // linearly during the next tick and then stays. Ignored where there is no such joint.
    virtual void set_target(const JointDegree& degree, double target) = 0;
    virtual double target(const JointDegree& degree) const = 0;
    // Do the same for a joint's first degree of freedom.
    void set_target(std::size_t part, double target) { set_target(first_degree(part), target); }
    double target(std::size_t part) const { return target(first_degree(part)); }
    // Returns the largest change of a motor's target in the last advance(), each in its own unit.
    virtual double largest_target_change() const = 0;
    // Does the same for the stretch of a deformable part. Ignored for rigid parts.
    virtual void set_stretch_target(std::size_t part, double target) = 0;

    // Advances by a tick of the given length (s). A scene that finds no valid motion keeps the
    // state before the tick and does not move any more.
    virtual SceneStatus advance(double duration) = 0;
    virtual SceneStatus status() const = 0;
    virtual double time() const = 0;  // s

    // Changes the environment from the next advance() on, for live changes of the displayed world.
    virtual void set_environment(const Environment& environment) = 0;

    // Sets the boxes with which bodies collide from the next advance() on. They must outlive the
    // scene, or remain until others are set.
    virtual void set_fixed_boxes(std::span<const FixedBox> boxes) = 0;

    // While motors are off, they give no effort and nothing rubs against anything.
    virtual void set_motors_off(bool off) = 0;

    // Translates all parts (m). Velocities do not change.
    virtual void translate(const Vec3& offset) = 0;

    // Applies one more force to a point of a part (world, N and m) during the next advance() only.
    // There may be kMostPulls; others are ignored.
    virtual void pull(std::size_t part, const Vec3& point_in_part, const Vec3& force) = 0;

    virtual SceneSize size() const = 0;
    // Remembers the present moment, with the forces of the next tick, until the next call.
    virtual void mark() = 0;
    // Goes back to that moment, but for what speeds up the search of contacts.
    virtual void go_back() = 0;

    virtual std::unique_ptr<SceneState> save() const = 0;
    virtual void restore(const SceneState& state) = 0;

    // Scenes of equal settings may use one workspace in turn. A scene is made with one of its own;
    // after it was taken, the scene must be given one before advance().
    virtual std::unique_ptr<SceneWorkspace> take_workspace() = 0;
    virtual void give_workspace(std::unique_ptr<SceneWorkspace> workspace) = 0;

    virtual SceneMotion motion() const = 0;
    // Begins at that motion as a new scene does: nothing touches, and the audit starts again.
    // Returns false, without an effect, if the motion is not one of this body or not finite.
    virtual bool begin_at(const SceneMotion& motion) = 0;

    virtual double energy() const = 0;  // J, kinetic + potential
    virtual const SceneAudit& audit() const = 0;
    // Restarts the audit and its counters at the present state.
    virtual void restart_audit() = 0;
    virtual void list_contacts(std::vector<SceneContact>& contacts) const = 0;
    // Lists the impacts of the last tick, each pair of bodies once, in the order of their first
    // impact; at most kMostImpacts. Impacts within one creature are left out.
    virtual void list_impacts(std::vector<SceneImpact>& impacts) const = 0;

    // Adds the bits of the state (positions and velocities) to a digest of the motion.
    virtual void add_to_digest(Hash64& digest) const = 0;
};

}  // namespace cambrian
