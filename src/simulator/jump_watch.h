#pragma once

// The highest jump of a trial, measured in every tick. A creature is in the air while its lowest
// point is more than 1 cm above the ground. Then h is the height of that point, and r is the rise
// of the centre of mass above its stance, the highest position in the last second on the ground
// (however long ago). The height of a jump is the greatest min(h, r).
//
// Pulling up the feet in a fall raises h, but r stays below 0. Standing up raises the centre of
// mass, but h stays 0. The height gained before take-off is part of the stance.

#include <array>
#include <cstddef>

namespace cambrian {

struct Jump {
    double height = 0.0;          // m, the lesser of the following two
    double clearance = 0.0;       // m, of the lowest point above the ground
    double rise = 0.0;            // m, of the centre of mass above its stance
    double take_off_speed = 0.0;  // m/s upwards, of the centre of mass in the first tick in the air
};

class JumpWatch {
public:
    // Must be called with the heights (m) of lowest point and centre of mass, once at the start and
    // then after every tick. The start counts as being on the ground.
    void watch(double lowest, double center);

    const Jump& best() const { return best_; }
    // Returns the greatest mean upward speed of the centre of mass over any 0.1 s, in m/s.
    double upward_speed() const { return upward_speed_; }

private:
    static constexpr std::size_t kStanceTicks = 60;  // 1 s
    static constexpr std::size_t kSpeedTicks = 6;    // 0.1 s

    void stand(double center);
    void fly(double lowest, double center);
    void measure_speed(double center);

    // Heights of the centre of mass in the last ticks on the ground.
    std::array<double, kStanceTicks> standing_ = {};
    // Heights of the centre of mass in the last ticks.
    std::array<double, kSpeedTicks> recent_ = {};
    std::size_t stood_ = 0;        // ticks on the ground so far
    std::size_t watched_ = 0;      // ticks so far
    double stance_ = 0.0;          // m, stance of the present jump
    double take_off_speed_ = 0.0;  // m/s, of the present jump
    bool flying_ = false;
    Jump best_;
    double upward_speed_ = 0.0;
};

}  // namespace cambrian
