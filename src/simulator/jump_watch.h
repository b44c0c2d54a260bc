#pragma once

// The highest jump of a trial, measured tick by tick. A creature is in the air while its lowest
// point is more than 1 cm above the ground; then h is the height of that point and r the rise of
// the centre of mass above its stance: the highest place it had in the last second of standing,
// however long ago that second was. The height of a jump is the greatest min(h, r).
//
// Feet pulled up in a fall lift h, but r stays below 0; getting up lifts the centre, but h stays 0;
// what the push adds before take-off is part of the stance.

#include <array>
#include <cstddef>

namespace cambrian {

struct Jump {
    double height = 0.0;          // m, the lesser of the two that follow
    double clearance = 0.0;       // m, of the lowest point above the ground
    double rise = 0.0;            // m, of the centre of mass above its stance
    double take_off_speed = 0.0;  // m/s upwards, of the centre of mass in the first tick in the air
};

class JumpWatch {
public:
    // Heights (m) of the lowest point and of the centre of mass: once at the start, which counts as
    // standing wherever it is, then after every tick.
    void watch(double lowest, double center);

    const Jump& best() const { return best_; }
    // Greatest mean speed of the centre of mass over any 0.1 s, upwards; m/s.
    double upward_speed() const { return upward_speed_; }

private:
    static constexpr std::size_t kStanceTicks = 60;  // 1 s
    static constexpr std::size_t kSpeedTicks = 6;    // 0.1 s

    void stand(double center);
    void fly(double lowest, double center);
    void measure_speed(double center);

    std::array<double, kStanceTicks> standing_ = {};  // centres, of the last ticks on the ground
    std::array<double, kSpeedTicks> recent_ = {};     // centres, of the last ticks
    std::size_t stood_ = 0;                           // ticks
    std::size_t watched_ = 0;                         // ticks
    double stance_ = 0.0;                             // m, of the jump under way
    double take_off_speed_ = 0.0;                     // m/s, of the same
    bool flying_ = false;
    Jump best_;
    double upward_speed_ = 0.0;
};

}  // namespace cambrian
