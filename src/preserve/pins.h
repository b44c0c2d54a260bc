#pragma once

// The creatures of a preserve that a person marked. Pins have no influence on the world.

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace cambrian {

struct Pins {
    std::set<std::uint64_t> creatures = {};  // numbers
    bool inherited = false;  // whether children of pinned creatures are pinned at birth

    friend bool operator==(const Pins&, const Pins&) = default;
};

// Returns 1 if they are inherited, or 0, and the numbers: "1 3 17".
std::string pins_text(const Pins& pins);
// Returns nothing for any other text.
std::optional<Pins> pins_of(std::string_view text);

}  // namespace cambrian
