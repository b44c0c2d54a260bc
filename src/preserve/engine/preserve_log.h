#pragma once

// The file of a preserve, as its engine sees it.

#include "core/result.h"
#include "preserve/chronicle.h"
#include "preserve/pins.h"

#include <cstdint>
#include <vector>

namespace cambrian {

class Preserve;

class PreserveLog {
public:
    PreserveLog() = default;
    virtual ~PreserveLog() = default;
    PreserveLog(const PreserveLog&) = delete;
    PreserveLog& operator=(const PreserveLog&) = delete;

    // Writes what happened since the last call, and the snapshot if one was taken.
    virtual Status write(const Chronicle& chronicle, const Preserve& preserve) = 0;
    // Replaces the pins that it has.
    virtual Status keep_pins(const Pins& pins) = 0;
    // Returns the ticks of the snapshots it has, in ascending order.
    virtual std::vector<std::uint64_t> snapshots() const = 0;
};

}  // namespace cambrian
