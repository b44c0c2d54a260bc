#pragma once

// The physics without its scene, so that tests can set speeds.

#include "planar/bodies.h"
#include "planar/integrators/builtin_integrators.h"
#include "planar/model_building.h"
#include "planar/stepping/audit.h"

namespace cambrian {

struct Rig {
    Rig(const BodyPlan& plan, const Environment& environment,
        const std::string& integrator = "bogacki-shampine", double tolerance = 1e-3,
        double contact_step = SceneSettings{}.contact_step);

    // Starts the energy audit.
    void begin();
    bool run(double duration);

    double energy() const;
    double angular_momentum() const;  // kg m^2/s, about the origin
    double speed() const;             // largest |speed| of any coordinate

    PlanarModel model;
    Forcing forcing;
    ContactLaw law;
    SimulationState state;
    StepControl control;
};

}  // namespace cambrian
