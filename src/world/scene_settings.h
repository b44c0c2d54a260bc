#pragma once

#include <string>

namespace cambrian {

inline constexpr double kLeastContactStep = 1e-4;  // s
inline constexpr double kMostEvaluations = 1e6;    // per simulated second

// Settings of the physics and the strength of motors, fixed during a trial. The constants of the
// motor law strongly influence evolution (creature/README.md 6).
struct SceneSettings {
    std::string integrator = "bogacki-shampine";  // id of a registered integrator
    double tolerance = 4e-3;         // error per step, relative to 0.1 m, 0.1 rad and 1 + |speed|
    double contact_step = 1.0 / 60;  // s; longest step during contact or at a stop
    double max_evaluations = 5e4;  // of the accelerations per simulated second; more end the trial
    double muscle_strength =
        25.0;  // N/m; largest torque of a joint over its squared section (N/m^2)
    double target_smoothing = 0.1;        // s; time constant of the motor target
    double motor_speed_limit = 6.0;       // rad/s or m/s; largest speed that a motor aims for
    double deform_speed_limit = 1.5;      // 1/s; largest rate of stretching a deformer aims for
    double motor_frequency = 25.0;        // rad/s; omega_0 of the motor's critically damped law
    std::string motor_mode = "position";  // one of kMotorModeIds
    int brain_steps = 1;                  // evaluations of a brain per tick; 1 or 2

    friend bool operator==(const SceneSettings&, const SceneSettings&) = default;
};

}  // namespace cambrian
