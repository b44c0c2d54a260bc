#include "cluster/bit_flipper.h"

#include "cluster/messages/result_text.h"

#include <bit>
#include <cstdint>

namespace cambrian::test {
namespace {

constexpr int kOneIn = 50;  // one result of so many is changed

}  // namespace

bool BitFlipper::change(UnitMessage& unit) {
    UnitResult results = *parse_unit_result(unit.body);
    bool flipped = false;
    for (SlotResult& each : results.results) {
        if (results_++ % kOneIn != 0) continue;
        const auto bits = std::bit_cast<std::uint64_t>(each.result.fitness);
        each.result.fitness = std::bit_cast<double>(bits ^ 1U);
        flipped = true;
    }
    unit.body = write_unit_result(results);
    return flipped;
}

}  // namespace cambrian::test
