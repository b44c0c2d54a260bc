#include "cluster/bit_flipper.h"

#include "cluster/messages/result_text.h"

#include <bit>
#include <cstdint>

namespace cambrian::test {

bool BitFlipper::change(UnitMessage& unit) {
    UnitResult results = *parse_unit_result(unit.body);
    const bool same_batch =
        last_ && last_->run == unit.id.run && last_->generation == unit.id.generation;
    if (same_batch || results.results.empty()) return false;
    double& fitness = results.results.front().result.fitness;
    fitness = std::bit_cast<double>(std::bit_cast<std::uint64_t>(fitness) ^ 1U);
    last_ = unit.id;
    unit.body = write_unit_result(results);
    return true;
}

}  // namespace cambrian::test
