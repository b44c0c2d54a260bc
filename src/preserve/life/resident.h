#pragma once

// A living creature of a preserve: its life so far, its energy, and its body in a scene of its own.

#include "creature/creature.h"
#include "evolution/settings/experiment_settings.h"
#include "evolution/settings/world_area.h"
#include "preserve/life/diet.h"
#include "preserve/life/life.h"
#include "preserve/world/common_senses.h"
#include "preserve/world/rectangle.h"

#include <memory>
#include <span>
#include <vector>

namespace cambrian {

// All of a resident that changes from tick to tick, but for its contacts.
struct ResidentState {
    Life life;
    Energy store = 0;
    Energy body = 0;
    std::uint64_t last_birth = 0;  // tick of the last attempt at one, or of its own birth
    SceneMotion motion;
    std::vector<double> brain_values, brain_memory;
    std::vector<double> sensor_memory, effector_memory;
};

// Makes the scene of a grown body. Fails, with a reason, if physics or the settings reject it.
Result<std::unique_ptr<PhysicsScene>> scene_of(const Phenotype& body, const Kinds& kinds,
                                               const ExperimentSettings& settings);

class Resident {
public:
    // Grows the creature at its rest pose around the origin, without energy. Fails, with a reason,
    // if physics or the settings reject the body. Kinds, settings and senses must outlive it.
    static Result<std::unique_ptr<Resident>> grow(Life begun, const Kinds& kinds,
                                                  const ExperimentSettings& settings,
                                                  const CommonSenses& senses);
    Resident(const Resident&) = delete;
    Resident& operator=(const Resident&) = delete;

    // Gives up what is needed only while it is placed: call it once it has its place.
    void give_up_workspace() { scene_->take_workspace(); }
    // Returns the centre of mass of its present pose when it stands on the ground.
    Vec3 standing_at(double x, const WorldArea& area) const;
    // Moves the centre of mass, and gives all parts that velocity.
    void place(const Vec3& center, const Vec3& velocity);
    // Lets it collide with these boxes instead of those before.
    void surround_by(std::vector<FixedBox> boxes);
    // Thinks and moves for a tick in a workspace of its scene. Changes nothing else, so residents
    // may do so at the same time.
    void live(std::unique_ptr<SceneWorkspace>& workspace, const WorldArea& area);
    // Do the same in two parts: what it does before its scene is advanced, and after. The scene
    // needs a workspace.
    void act(const WorldArea& area);
    void end_tick(SceneStatus status);
    PhysicsScene& scene() { return *scene_; }
    const PhysicsScene& scene() const { return *scene_; }

    // The work of the motors in the last tick, in J.
    double work() const { return work_; }
    // Whether the last tick failed, or a part moves faster than bodies can. Then only the
    // rectangles and bounds, which are those before that tick, still are of use.
    bool is_broken() const { return broken_; }
    std::span<const Rectangle> rectangles() const { return rectangles_; }
    const Bounds& bounds() const { return bounds_; }    // of the rectangles
    const Vec3& center() const { return center_; }      // of mass
    const Vec3& velocity() const { return velocity_; }  // of the centre of mass
    double fastest() const { return fastest_; }  // m/s; no point is faster; 0 if it is ghostly
    double radius() const { return radius_; }  // m, at rest, of a circle around the centre of mass
    bool can_move() const { return phenotype_->can_move() && phenotype_->has_live_control; }
    // Impacts of the last tick, if ramming counts in this world.
    std::span<const SceneImpact> impacts() const { return impacts_; }
    const Brain& brain() const { return creature_->brain(); }
    const Emissions& emissions() const { return creature_->emissions(); }
    std::span<const Mouth> mouths() const { return mouths_; }
    const Phenotype& phenotype() const { return *phenotype_; }
    const GenomePtr& genome() const { return life.genome; }
    double age(std::uint64_t tick) const;  // s
    void feel(double energy) { senses_.set_energy(energy); }

    ResidentState save() const;
    // Returns false if the state is not one of this body.
    bool restore(const ResidentState& state);

    Life life;
    Energy store = 0;  // E
    Energy body = 0;   // B
    std::uint64_t last_birth = 0;
    bool bitten = false;  // in the last tick

private:
    Resident(Life begun, std::unique_ptr<const Phenotype> phenotype, const Kinds& kinds,
             const ExperimentSettings& settings, const CommonSenses& senses,
             std::unique_ptr<PhysicsScene> scene);
    void find_places();

    const ExperimentSettings* settings_;
    std::unique_ptr<const Phenotype> phenotype_;
    std::unique_ptr<PhysicsScene> scene_;
    CreatureSenses senses_;
    std::unique_ptr<Creature> creature_;
    std::vector<Mouth> mouths_;
    std::vector<Rectangle> rectangles_;
    std::vector<SceneImpact> impacts_;
    std::vector<FixedBox> boxes_;  // of its own, if any
    Bounds bounds_;
    Vec3 center_ = Vec3::Zero(), velocity_ = Vec3::Zero();
    double fastest_ = 0.0;
    double radius_ = 0.0;
    double work_before_ = 0.0;  // J, of the motors up to the last tick
    double work_ = 0.0;
    bool broken_ = false;
};

}  // namespace cambrian
