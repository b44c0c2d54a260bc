#pragma once

// Where each creature of a batch is: not begun, in a unit that was published, at home, answered.
// Creatures are numbered in the order of handing out, those that may take longest first. Time is
// given by the caller, in seconds of any clock.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace cambrian {

class UnitLedger {
public:
    // seconds: that each creature may take on one core.
    explicit UnitLedger(std::vector<double> seconds);

    double open_seconds() const { return open_seconds_; }

    // The next creatures for a unit: as many as take that long, at least one, at most `most`. Empty
    // if none is open.
    std::vector<std::size_t> take_for_unit(double seconds, std::size_t most);
    // One for the own cores, of those that take least time.
    std::optional<std::size_t> take_for_home();
    // They are open once more, unless they were answered.
    void reopen(const std::vector<std::size_t>& creatures);

    // These were published now. They are late at `due`.
    void publish(std::uint32_t unit, std::vector<std::size_t> creatures, double now, double due);
    // Units without an answer, and the work in them.
    std::size_t outstanding() const { return units_.size(); }
    double outstanding_seconds() const { return outstanding_seconds_; }
    double seconds_of(const std::vector<std::size_t>& creatures) const;
    // Creatures of a unit that was answered or given up; empty if it is not outstanding.
    std::vector<std::size_t> close(std::uint32_t unit);
    // Late from now on, whenever it is due.
    void expect_no_more(std::uint32_t unit);

    void answered(std::size_t creature);
    void unanswered(std::size_t creature);  // its answer was taken back: open once more

    // Of the unit that is late for longest, an own core's part of what is not answered and not
    // taken at home already: the whole divided by `parts`.
    struct Late {
        std::uint32_t unit = 0;
        bool first = false;  // nothing of the unit was taken before
        double published = 0.0;
        std::vector<std::size_t> creatures;
    };
    std::optional<Late> take_late(double now, std::size_t parts);
    // When the next unit will be late; none if none is outstanding that is not taken back whole.
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
    std::vector<bool> at_home_;  // taken back from a late unit
};

}  // namespace cambrian
