#pragma once

#include <string>

namespace cambrian {

// How the physics is computed and how strong its motors are; fixed for a trial. Constants of the
// motor law are fitness-critical (creature/README.md 6): changing one changes what evolves.
struct SceneSettings {
    std::string integrator = "bogacki-shampine";  // id of a registered integrator
    double tolerance = 4e-3;         // error a step, relative to 0.1 m, 0.1 rad and 1 + |speed|
    double contact_step = 1.0 / 60;  // s; longest step while anything touches or a stop is met
    double max_evaluations = 5e4;    // of the accelerations a simulated second; more end a trial
    double muscle_strength = 25.0;   // N/m; a joint's torque cap is this times section squared
    double target_smoothing = 0.1;   // s; time constant of the motor target
    double motor_speed_limit = 6.0;  // rad/s; the speed a motor asks for at most
    double motor_frequency = 25.0;   // rad/s; omega_0 of the motor's critically damped law
    std::string motor_mode = "position";  // one of kMotorModeIds
    int brain_steps = 1;                  // times a brain thinks in a tick; 1 or 2

    friend bool operator==(const SceneSettings&, const SceneSettings&) = default;
};

}  // namespace cambrian
