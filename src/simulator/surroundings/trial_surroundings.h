#pragma once

// The surroundings of a creature in the world of a trial.

#include "simulator/surroundings/light_source.h"
#include "simulator/surroundings/scent_field.h"
#include "simulator/surroundings/used_senses.h"
#include "world/environment.h"
#include "world/fixed_box.h"
#include "world/physics_scene.h"
#include "world/surroundings.h"
#include "world/terrain.h"

#include <memory>
#include <optional>
#include <span>

namespace cambrian {

class TrialSurroundings final : public Surroundings {
public:
    TrialSurroundings(const Environment& environment, const LightDraw& draw,
                      const UsedSenses& used = {});

    void set_environment(const Environment& environment);

    Vec3 up() const override { return up_; }
    Light light(const Vec3& point) const override { return source_.at(point); }
    // A trial has one creature, which does not hear itself, so there is nothing to hear.
    double sound(const Vec3& /*point*/, int /*band*/) const override { return 0.0; }
    double scent(const Vec3& point) const override;
    double obstacle(const Vec3& point, int direction) const override;
    double distance_to_ground(const Vec3& from, const Vec3& direction, double reach) const override;
    double ground_height(double x) const override;
    // Takes the trial's wall, which must outlive the object, or null.
    void set_wall(const FixedBox* wall) { wall_ = wall; }

    const LightSource& source() const { return source_; }
    LightSource& source() { return source_; }
    // Returns the sounds of the last tick: those of the creature's organs, then those of its
    // impacts.
    std::span<const Sound> sounds() const { return sounds_; }
    // The scent, or null if the creature has no use for it.
    const ScentField* scent_field() const { return field_ ? &*field_ : nullptr; }

    // Takes what the creature gave off in a tick. It can be smelled from the next tick on. `tick`
    // counts the ticks of the test from 0. Allocates nothing.
    void take(const Emissions& emissions, std::span<const SceneImpact> impacts,
              std::uint64_t tick) {
        const bool nothing = impacts.empty() && emissions.sounds.empty() && sounds_.empty();
        if (!nothing || field_) take_all(emissions, impacts, tick);
    }
    // Returns whether the world may still change for a creature that rests.
    bool changes() const;

    // The data that change from tick to tick.
    struct Moment {
        LightSource::Moment light;
        std::vector<Sound> sounds;
        ScentField::Moment scent;
    };
    Moment save() const;
    void restore(const Moment& moment);

private:
    void take_all(const Emissions& emissions, std::span<const SceneImpact> impacts,
                  std::uint64_t tick);
    void find_up();
    void lay_out_field();
    void find_ground();

    Environment environment_;
    UsedSenses used_;
    Vec3 up_ = Vec3::Zero();
    const FixedBox* wall_ = nullptr;
    std::shared_ptr<const Terrain> terrain_;  // null unless a sense feels its shape
    LightSource source_;
    std::vector<Sound> sounds_;
    std::optional<ScentField> field_;
};

}  // namespace cambrian
