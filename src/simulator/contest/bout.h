#pragma once

// The other bodies of a contest: a free cube, and an opponent on the other side of it
// (simulator/README.md 7).

#include "core/result.h"
#include "creature/creature.h"
#include "simulator/contest/bout_distances.h"
#include "simulator/surroundings/trial_surroundings.h"
#include "world/environment.h"
#include "world/physics_scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace cambrian {

inline constexpr double kHalfCube = 0.15;  // m

struct BoutWorld {
    const Environment& environment;
    const SceneSettings& scene;
    const LightDraw& light;
};

class Bout {
public:
    // Places the cube at x = 0 on the ground, the creature that is judged to the left of it, and
    // the opponent to the right. Fails if physics rejects the opponent, or has no room for all. The
    // kinds must outlive the bout.
    static Result<std::unique_ptr<Bout>> start(std::shared_ptr<const Phenotype> opponent,
                                               const Kinds& kinds, const BoutWorld& world,
                                               PhysicsScene& own);

    // Advances both creatures by a tick (s) before the bout, each by itself; the opponent holds its
    // rest pose. Returns the status of the creature that is judged.
    SceneStatus settle(PhysicsScene& own, double duration);
    // Moves both along the ground to the same distance from the cube, which neither can reach by
    // falling over: 1 m and the greater height from its near face. Without an opponent, its
    // distance is this one.
    void begin(PhysicsScene& own);
    // Has the opponent act in the next tick.
    void act(std::uint64_t tick);
    // Advances all bodies by a tick (s). An opponent whose own motion cannot be computed leaves the
    // bout; its distance stays what it was. After any other failure nothing moves any more.
    SceneStatus advance(PhysicsScene& own, double duration);
    // Lets the opponent sense from the next tick on what it gave off in this one.
    void pass_on_emissions(std::uint64_t tick);
    bool is_calm() const;  // whether the opponent has settled

    BoutDistances distances(const PhysicsScene& own) const;
    void set_environment(const Environment& environment);
    void set_motors_off(bool off);
    void add_to_digest(Hash64& digest) const;

    const PhysicsScene& cube() const { return *cube_; }
    // The opponent, also after it left; null if there is none.
    const PhysicsScene* opponent() const { return opponent_.get(); }
    // The grown opponent; null if there is none.
    const std::shared_ptr<const Phenotype>& opponent_body() const { return phenotype_; }

    struct State {
        std::unique_ptr<SceneState> cube, opponent, joined;
        std::optional<Creature::State> creature;
        std::optional<TrialSurroundings::Moment> surroundings;
        SceneStatus status = SceneStatus::kRunning;
        bool is_present = false;
        double last_distance = 0.0;
    };
    State save() const;
    void restore(const State& state, PhysicsScene& own);

private:
    Bout(std::shared_ptr<const Phenotype> opponent, const Kinds& kinds, const BoutWorld& world);
    Status make_scenes(const BoutWorld& world, const PhysicsScene& own);
    void join(PhysicsScene& own);
    SceneStatus advance_joined(double duration);
    bool opponent_fails_alone(double duration);
    double distance_to_cube(const PhysicsScene& scene) const;

    std::shared_ptr<const Phenotype> phenotype_;  // of the opponent, or null
    const Kinds* kinds_;
    SceneSettings settings_;
    std::unique_ptr<PhysicsScene> cube_, opponent_;
    std::optional<TrialSurroundings> surroundings_;  // of the opponent
    std::unique_ptr<Creature> creature_;             // the opponent
    double length_ = 0.0;                            // m, of the opponent at rest
    std::unique_ptr<SceneWorkspace> workspace_;
    std::vector<PhysicsScene*> scenes_;  // of all that take part
    std::unique_ptr<JoinedScenes> joined_;
    std::vector<SceneImpact> impacts_;  // of the opponent in the last tick
    SceneStatus status_ = SceneStatus::kRunning;
    bool is_present_ = false;     // whether the opponent takes part
    double last_distance_ = 0.0;  // m, of an opponent that does not
};

}  // namespace cambrian
