#pragma once

// The interface through which sensors read the world around a creature. Reading changes nothing.

#include "math/types.h"

#include <limits>

namespace cambrian {

// The direction and intensity of light at one point.
struct Light {
    Vec3 direction = Vec3::Zero();  // unit vector to the lamp; 0 where it is dark
    double intensity = 0.0;         // the lamp's brightness at the lamp
};

class Surroundings {
public:
    virtual ~Surroundings() = default;

    // Returns the unit vector against gravity; 0 without gravity.
    virtual Vec3 up() const = 0;
    virtual Light light(const Vec3& point) const = 0;
    // Returns the loudness of a band of sound; what the creature itself gave off is left out.
    virtual double sound(const Vec3& point, int band) const = 0;
    // Returns the concentration of scent, at least 0.
    virtual double scent(const Vec3& point) const = 0;
    // Returns the distance in m to an obstacle to the right (+x, direction 1) or to the left (-1);
    // infinity if there is none.
    virtual double obstacle(const Vec3& /*point*/, int /*direction*/) const {
        return std::numeric_limits<double>::infinity();
    }
    // Returns the distance in m from a point along a unit vector to ground or to what stands on it,
    // if it is within reach (m); infinity if there is none.
    virtual double distance_to_ground(const Vec3& /*from*/, const Vec3& /*direction*/,
                                      double /*reach*/) const {
        return std::numeric_limits<double>::infinity();
    }
    virtual double ground_height(double /*x*/) const { return 0.0; }  // m
    // The following are 0 where nothing is eaten.
    // Return the concentration of the smell of plants and of flesh, at least 0.
    virtual double plant_smell(const Vec3& /*point*/) const { return 0.0; }
    virtual double flesh_smell(const Vec3& /*point*/) const { return 0.0; }
    // Returns the creature's own store of energy as a share of that of a newborn.
    virtual double energy() const { return 0.0; }
};

}  // namespace cambrian
