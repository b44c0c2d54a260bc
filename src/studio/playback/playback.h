#pragma once

// Plays the displayed creature on the main thread, within a time budget, forwards and backwards.

#include "studio/playback/played_creature.h"

#include <cstdint>
#include <optional>

namespace cambrian {

inline constexpr double kLongestGap = 0.1;  // s; a longer pause of the window is not played

class Playback {
public:
    struct Pace {
        bool playing = true;
        double speed = 1.0;  // 1 is real time
    };

    // `kinds` must outlive the object.
    explicit Playback(const Kinds& kinds) : creature_(kinds) {}

    // Plays another creature from its start. On failure, the creature before stays.
    Status show(Exhibit exhibit);
    void restart();
    // Plays the present trial with these lesions from its start (PlayedCreature::deprive).
    Status deprive(std::vector<Lesion> lesions);
    // Plays another of the creature's trials from its start (PlayedCreature::show_trial).
    void show_trial(int trial);

    Pace& pace() { return pace_; }
    const Pace& pace() const { return pace_; }
    // Plays on by `elapsed` seconds of wall time but computes for at most `budget` seconds.
    // Playback slows down if that is not enough.
    void advance(double elapsed, double budget);
    void step();  // advances one tick and pauses
    // Pauses one tick before the displayed one or, while seeking, before the tick sought.
    void step_back();
    // Seeks a tick after the trial's start, forwards or backwards. advance() computes up to it, and
    // until then the displayed instant stays. Pokes after that tick are forgotten.
    void seek(std::uint64_t tick);
    bool seeking() const { return sought_.has_value(); }
    // The displayed tick or, while seeking, the tick sought.
    std::uint64_t tick_shown() const { return sought_.value_or(empty() ? 0 : trial().ticks()); }
    // Returns the trial's length in ticks, settling included, or the ticks played if these are
    // more.
    std::uint64_t length() const;
    // Returns where the displayed instant lies between the last two ticks; 1 is the last tick.
    double share() const;

    PlayedCreature& creature() { return creature_; }
    const PlayedCreature& creature() const { return creature_; }
    bool empty() const { return creature_.empty(); }
    const Exhibit& exhibit() const { return creature_.exhibit(); }
    const Trial& trial() const { return creature_.replay().trial(); }

private:
    void go_on_seeking(double budget);

    PlayedCreature creature_;
    Pace pace_;
    double owed_ = 0.0;  // s of motion still to play; less than a tick unless playback is too slow
    std::optional<std::uint64_t> sought_;  // tick sought
};

}  // namespace cambrian
