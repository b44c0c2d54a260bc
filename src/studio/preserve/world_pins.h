#pragma once

// The pins of the open preserve, kept up to date with its births and deaths.

#include "preserve/engine/preserve_picture.h"
#include "preserve/pins.h"

#include <cstdint>

namespace cambrian {

class WorldPins {
public:
    // Takes over the pins of a preserve that was opened; births up to this picture count as known.
    void begin(Pins pins, const PreservePicture& picture);
    void toggle(std::uint64_t creature);
    void toggle_inheritance() { pins_.inherited = !pins_.inherited; }
    // Pins the children of pinned creatures born since the last picture, if pins are inherited, and
    // forgets those that died.
    void follow(const PreservePicture& picture);

    const Pins& pins() const { return pins_; }
    // Returns whether they changed since the last call.
    bool take_change();

private:
    void pin_children(const PreservePicture& picture);

    Pins pins_;
    Pins taken_;                // as of the last take_change()
    std::uint64_t newest_ = 0;  // number of the last creature that was seen
};

}  // namespace cambrian
