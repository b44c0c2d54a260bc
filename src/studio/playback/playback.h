#pragma once

// The creature on show, simulated live on the main thread by the very trial that judges it, tick by
// tick within a time budget, forwards and back.

#include "core/result.h"
#include "math/pose.h"
#include "studio/playback/energy_trace.h"
#include "studio/playback/exhibit.h"
#include "studio/playback/replay.h"
#include "studio/playback/shown_motion.h"
#include "studio/playback/signal_trace.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
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
    // Pauses one tick earlier than now, or than the moment sought.
    void step_back();
    // To the moment so many ticks after the start, ahead or back; advance() goes there, and until
    // then what is shown stays. Going back forgets the pokes after it.
    void seek(std::uint64_t tick);
    bool seeking() const { return sought_.has_value(); }
    // Where it is, or is going.
    std::uint64_t tick_shown() const { return sought_.value_or(empty() ? 0 : replay_->ticks()); }
    // Ticks of settling and test phase together, as far as known, and of what was played beyond.
    std::uint64_t length() const;

    // Plays on by so much wall time, spending at most `budget` seconds on it; falls behind instead.
    void advance(double elapsed, double budget);

    // Pulls a part by a point towards a place in the world until release(); marks the motion as
    // disturbed until restarted, or until the moment shown lies before the poke.
    void poke(std::size_t part, const Vec3& point_in_part, const Vec3& target);
    void release() { hold_.reset(); }
    bool disturbed() const { return !empty() && (hold_ || replay_->disturbed()); }
    // From the next tick on a neuron says this value, whatever it computes, until released or
    // restarted; disturbs as a poke does.
    void force(std::size_t neuron, double value);
    void release_neuron(std::size_t neuron);
    const std::map<std::size_t, double>& forced() const { return replay_->forced(); }
    const SignalTrace& signals() const { return signals_; }
    const EnergyTrace& energy() const { return energy_; }  // of the test phase

    bool empty() const { return replay_ == nullptr; }
    const Exhibit& exhibit() const { return exhibit_; }
    const Phenotype& phenotype() const { return *phenotype_; }
    std::shared_ptr<const Phenotype> shared_phenotype() const { return phenotype_; }
    const Trial& trial() const { return replay_->trial(); }
    // As played: the world that judges the creature, or what it was changed to by hand.
    const Environment& environment() const { return replay_->environment(); }
    bool diverged() const { return !empty() && replay_->diverged(); }
    // Part poses at the moment on show, between two ticks.
    const std::vector<Pose>& poses() const { return motion_.poses(); }
    Vec3 center_of_mass() const { return motion_.center(); }
    // How far between the last two ticks that moment is; 1 is the last.
    double share() const;
    // Where the centre of mass was, oldest first, fourteen a second.
    std::span<const Vec2> trail() const;
    // What is held by the mouse, or null.
    const Hold* hold() const { return hold_ ? &*hold_ : nullptr; }

private:
    void begin(std::unique_ptr<Replay> replay);
    void tick();
    void go_on_seeking(double budget);
    void keep_readings();
    void show_present() { motion_.jump_to(trial().scene()); }

    const Kinds* kinds_;
    Exhibit exhibit_;
    std::shared_ptr<const Phenotype> phenotype_;
    std::unique_ptr<Replay> replay_;
    bool playing_ = true;
    double speed_ = 1.0;
    double owed_ = 0.0;                    // s of motion due, under one tick unless falling behind
    std::optional<std::uint64_t> sought_;  // tick
    ShownMotion motion_;
    std::vector<Vec2> dots_;  // of the trail, all since the start
    std::optional<Hold> hold_;
    SignalTrace signals_;
    EnergyTrace energy_;
};

}  // namespace cambrian
