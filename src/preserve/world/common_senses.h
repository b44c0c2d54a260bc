#pragma once

// All that creatures of a preserve can sense of it alike: light, sounds, scent, and the smell of
// food. It changes between two ticks only.

#include "evolution/settings/world_area.h"
#include "preserve/world/drawn_walls.h"
#include "preserve/world/food.h"
#include "simulator/surroundings/light_source.h"
#include "simulator/surroundings/loudness_sum.h"
#include "simulator/surroundings/scent_field.h"
#include "world/emissions.h"
#include "world/environment.h"
#include "world/surroundings.h"

#include <cstdint>
#include <memory>

namespace cambrian {

class CommonSenses {
public:
    // The walls, if any, must outlive the object.
    CommonSenses(const WorldArea& area, const Environment& environment,
                 const DrawnWalls* walls = nullptr);

    const Environment& environment() const { return environment_; }
    Vec3 up() const { return up_; }
    Light light(const Vec3& point) const;
    double sound(const Vec3& point, int band, std::uint64_t creature) const;
    double scent(const Vec3& point) const { return concentration(scent_, point); }
    double plant_smell(const Vec3& point) const { return concentration(plants_, point); }
    double flesh_smell(const Vec3& point) const { return concentration(flesh_, point); }

    // On flat ground, nobody senses the ground, as in worlds of before it had a shape.
    double distance_to_ground(const Vec3& from, const Vec3& direction, double reach) const;
    double ground_height(double x) const {
        return ground_ && !environment_.numb ? ground_->height(x) : 0.0;
    }

    // Take what creatures gave off in a tick: after begin_tick(), each creature's in ascending
    // order of numbers, then end_tick().
    void begin_tick();
    void take(const Emissions& emissions, std::uint64_t creature);
    // Lets scents spread every 6 ticks.
    void end_tick(std::uint64_t tick, const Food& plants, const Food& flesh);

    // The scents. Sounds last one tick and are not kept.
    struct Moment {
        ScentField::Moment scent, plants, flesh;
    };
    Moment save() const { return {scent_.save(), plants_.save(), flesh_.save()}; }
    // The cells must be as many as cells(), or none.
    void restore(const Moment& moment);
    std::size_t cells() const;

private:
    double concentration(const ScentField& field, const Vec3& point) const {
        return environment_.scentless ? 0.0 : field.at(in_fields(point));
    }
    Vec3 in_fields(const Vec3& point) const;
    void give_off(const Food& pellets, ScentField& field) const;

    Environment environment_;
    Torus torus_;
    std::shared_ptr<const Terrain> ground_;  // null if it is flat
    const DrawnWalls* walls_;
    Vec3 stretch_;
    Vec3 up_ = Vec3::Zero();
    LightSource light_;
    LoudnessSum sounds_;
    ScentField scent_, plants_, flesh_;
};

// The surroundings of one creature of a preserve.
class CreatureSenses final : public Surroundings {
public:
    // The common senses must outlive the object.
    CreatureSenses(const CommonSenses& common, std::uint64_t creature)
        : common_(common), creature_(creature) {}

    Vec3 up() const override { return common_.up(); }
    Light light(const Vec3& point) const override { return common_.light(point); }
    double sound(const Vec3& point, int band) const override {
        return common_.sound(point, band, creature_);
    }
    double scent(const Vec3& point) const override { return common_.scent(point); }
    double plant_smell(const Vec3& point) const override { return common_.plant_smell(point); }
    double flesh_smell(const Vec3& point) const override { return common_.flesh_smell(point); }
    double distance_to_ground(const Vec3& from, const Vec3& direction,
                              double reach) const override {
        return common_.distance_to_ground(from, direction, reach);
    }
    double ground_height(double x) const override { return common_.ground_height(x); }
    double energy() const override { return energy_; }
    void set_energy(double energy) { energy_ = energy; }

private:
    const CommonSenses& common_;
    std::uint64_t creature_;
    double energy_ = 1.0;
};

}  // namespace cambrian
