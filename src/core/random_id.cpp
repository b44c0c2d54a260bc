#include "core/random_id.h"

#include <random>

namespace cambrian {

std::uint64_t random_id() {
    std::random_device chance;
    return (std::uint64_t{chance()} << 32U) | chance();
}

}  // namespace cambrian
