#pragma once

// Plays the creature on display: live on the main thread, within a time budget, forwards and back.

#include "studio/playback/played_creature.h"

#include <cstdint>
#include <optional>

namespace cambrian {

inline constexpr double kLongestGap =
    0.1;  // s; after a longer pause of the window, play goes on from here

class Playback {
public:
    struct Pace {
        bool playing = true;
        double speed = 1.0;  // 1 is real time
    };

    // Must outlive it.
    explicit Playback(const Kinds& kinds) : creature_(kinds) {}

    // Plays another creature from its start; on failure the one before stays.
    Status show(Exhibit exhibit);
    void restart();

    Pace& pace() { return pace_; }
    const Pace& pace() const { return pace_; }
    // Plays on by so much wall time, spending at most `budget` seconds on it; falls behind instead.
    void advance(double elapsed, double budget);
    void step();  // pauses one tick later
    // Pauses one tick earlier than now, or than the moment sought.
    void step_back();
    // To the moment so many ticks after the start, ahead or back; advance() goes there, and until
    // then what is shown stays. Going back forgets the pokes after it.
    void seek(std::uint64_t tick);
    bool seeking() const { return sought_.has_value(); }
    // Where it is, or is going.
    std::uint64_t tick_shown() const { return sought_.value_or(empty() ? 0 : trial().ticks()); }
    // Ticks of settling and test phase together, as far as known, and of what was played beyond.
    std::uint64_t length() const;
    // How far between the last two ticks the moment on display is; 1 is the last.
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
    double owed_ = 0.0;                    // s of motion due, under one tick unless falling behind
    std::optional<std::uint64_t> sought_;  // tick
};

}  // namespace cambrian
