#pragma once

// Shows the best creatures one after the other: the starred ones, then the champions that improved
// on all before, the newest first; where there are none, the samples.

#include "studio/playback/exhibit.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace cambrian {

// Returns which creatures of an experiment are shown, each once.
std::vector<Exhibit> best_exhibits(const std::vector<JudgedIndividual>& stars,
                                   const std::vector<JudgedIndividual>& champions);

class Presentation {
public:
    // Begins; `before` is the creature on display, which returns at the end.
    void begin(std::vector<Exhibit> exhibits, std::optional<Exhibit> before);
    // Ends; returns the creature that was on display before.
    std::optional<Exhibit> end();
    bool on() const { return on_; }
    bool empty() const { return exhibits_.empty(); }
    void show(std::vector<Exhibit> exhibits) { exhibits_ = std::move(exhibits); }

    // Must be called once a frame; `over` tells whether the trial on display is. Returns the next
    // creature when its time has come.
    const Exhibit* update(double now, bool over);

private:
    bool on_ = false;
    std::vector<Exhibit> exhibits_;
    std::optional<Exhibit> before_;
    std::size_t next_ = 0;
    std::optional<double> since_;  // s; when the present one was shown
};

}  // namespace cambrian
