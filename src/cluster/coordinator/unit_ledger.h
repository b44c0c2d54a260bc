#pragma once

// The state of each creature of a batch: open, in a published unit, on this machine or answered.
// Creatures are numbered in the order of their publication, the longest first. The caller gives the
// time, in seconds of any clock.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace cambrian {

class UnitLedger {
public:
    // `seconds` are the expected times of the creatures on one core.
    explicit UnitLedger(std::vector<double> seconds);

    double open_seconds() const { return open_seconds_; }

    // Takes the next creatures for a unit of that much time, at least one and at most `most`. Empty
    // if none is open.
    std::vector<std::size_t> take_for_unit(double seconds, std::size_t most);
    // Takes the shortest open creature, for the cores of this machine.
    std::optional<std::size_t> take_for_home();
    // Makes creatures open again unless they were answered.
    void reopen(const std::vector<std::size_t>& creatures);

    // Records the publication of a unit, which is late at `due`.
    void publish(std::uint32_t unit, std::vector<std::size_t> creatures, double now, double due);
    // Units without an answer, and the work in them.
    std::size_t outstanding() const { return units_.size(); }
    double outstanding_seconds() const { return outstanding_seconds_; }
    double seconds_of(const std::vector<std::size_t>& creatures) const;
    // Creatures of a unit that was answered or abandoned; empty if it is not outstanding.
    std::vector<std::size_t> close(std::uint32_t unit);
    // Makes a unit late from now on.
    void expect_no_more(std::uint32_t unit);

    void answered(std::size_t creature);
    void unanswered(std::size_t creature);  // its answer was revoked, so it is open again

    // The part of the most overdue unit that one core of this machine takes over: the creatures
    // that are neither answered nor taken over yet, divided by `parts`.
    struct Late {
        std::uint32_t unit = 0;
        bool first = false;  // nothing of the unit was taken before
        double published = 0.0;
        double due = 0.0;
        std::vector<std::size_t> creatures;
    };
    std::optional<Late> take_late(double now, std::size_t parts);
    // Returns the time at which the next unit is late; nothing if all outstanding units are
    // completely taken over.
    std::optional<double> next_due() const;

private:
    struct OutstandingUnit {
        std::vector<std::size_t> creatures;
        double published = 0.0;
        double due = 0.0;
        double seconds = 0.0;
        bool taken = false;  // in part
    };
    bool wanted(std::size_t creature) const { return !answered_[creature] && !at_home_[creature]; }
    bool has_wanted(const OutstandingUnit& unit) const;
    std::size_t take_open(bool from_front);

    std::vector<double> seconds_;
    std::deque<std::size_t> open_;
    double open_seconds_ = 0.0;
    std::map<std::uint32_t, OutstandingUnit> units_;
    double outstanding_seconds_ = 0.0;
    std::vector<bool> is_open_;
    std::vector<bool> answered_;
    std::vector<bool> at_home_;  // taken over from a late unit
};

}  // namespace cambrian
