#pragma once

// The creature on show, simulated live on the main thread by the very trial that judges it, tick by
// tick within a time budget.

#include "core/result.h"
#include "math/pose.h"
#include "studio/energy_trace.h"
#include "studio/exhibit.h"
#include "studio/signal_trace.h"

#include <map>
#include <memory>
#include <vector>

namespace cambrian {

class Playback {
public:
    explicit Playback(const Kinds& kinds) : kinds_(&kinds) {}

    // Expresses the creature and starts its trial; on failure what was on show stays.
    Status show(Exhibit exhibit);
    // From the start, as judged, except that an environment changed by hand is kept.
    void restart();
    void set_environment(const Environment& environment);

    void set_playing(bool playing) { playing_ = playing; }
    bool playing() const { return playing_; }
    void set_speed(double speed) { speed_ = speed; }  // 1 is real time
    double speed() const { return speed_; }
    void step();  // one tick

    // Plays on by so much wall time, spending at most `budget` seconds on it; falls behind instead.
    void advance(double elapsed, double budget);

    // Pulls a part by a point towards a place in the world until release(); marks the motion as
    // disturbed until restarted.
    void poke(std::size_t part, const Vec3& point_in_part, const Vec3& target);
    void release() { poked_part_ = -1; }
    bool disturbed() const { return disturbed_; }
    // From the next tick on a neuron says this value, whatever it computes, until released or
    // restarted; disturbs as a poke does.
    void force(std::size_t neuron, double value);
    void release_neuron(std::size_t neuron);
    const std::map<std::size_t, double>& forced() const { return forced_; }
    const SignalTrace& signals() const { return signals_; }
    const EnergyTrace& energy() const { return energy_; }  // of the test phase

    bool empty() const { return trial_ == nullptr; }
    const Exhibit& exhibit() const { return exhibit_; }
    const Phenotype& phenotype() const { return *phenotype_; }
    std::shared_ptr<const Phenotype> shared_phenotype() const { return phenotype_; }
    const Trial& trial() const { return *trial_; }
    // As played: the world that judges the creature, or what it was changed to by hand.
    const Environment& environment() const { return environment_; }
    bool diverged() const;
    // Part poses at the moment on show, between two ticks.
    const std::vector<Pose>& poses() const { return shown_; }
    Vec3 center_of_mass() const { return shown_center_; }
    // Where the centre of mass was, oldest first, fourteen a second.
    const std::vector<Vec2>& trail() const { return trail_; }
    int poked_part() const { return poked_part_; }
    Vec3 poke_target() const { return poke_target_; }
    Vec3 poke_point() const { return poke_point_; }

private:
    void begin(std::unique_ptr<Trial> trial);
    void tick();
    void pull();
    void keep_readings();
    void capture(std::vector<Pose>& poses) const;
    void interpolate();

    const Kinds* kinds_;
    Exhibit exhibit_;
    Environment environment_;
    std::shared_ptr<const Phenotype> phenotype_;
    std::unique_ptr<Trial> trial_;
    bool playing_ = true;
    double speed_ = 1.0;
    double owed_ = 0.0;  // s of motion due, under one tick unless falling behind
    std::vector<Pose> previous_;
    std::vector<Pose> current_;
    std::vector<Pose> shown_;
    Vec3 previous_center_ = Vec3::Zero();
    Vec3 current_center_ = Vec3::Zero();
    Vec3 shown_center_ = Vec3::Zero();
    std::vector<Vec2> trail_;
    bool disturbed_ = false;
    std::map<std::size_t, double> forced_;  // neurons and what they are made to say
    SignalTrace signals_;
    EnergyTrace energy_;
    int poked_part_ = -1;
    Vec3 poke_point_ = Vec3::Zero();
    Vec3 poke_target_ = Vec3::Zero();
};

}  // namespace cambrian
