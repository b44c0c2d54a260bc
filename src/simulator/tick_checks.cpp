#include "simulator/tick_checks.h"

#include <algorithm>

namespace cambrian {

void note_tick(TickChecks& checks, const Trial& trial) {
    if (checks.size() >= kMostTickChecks) return;
    Hash64 digest;
    trial.scene().add_to_digest(digest);
    checks.push_back(static_cast<std::uint8_t>(digest.value() >> 32));
}

std::optional<std::size_t> first_different_tick(const TickChecks& a, const TickChecks& b) {
    const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (in_a == a.end() && in_b == b.end()) return std::nullopt;
    return static_cast<std::size_t>(in_a - a.begin()) + 1;
}

}  // namespace cambrian
