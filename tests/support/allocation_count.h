#pragma once

#include <cstddef>

namespace cambrian::test {

// Returns the number of allocations by the calling thread so far. Programs that link this file have
// an operator new that counts. Sanitizers replace operator new themselves, so such tests are left
// out with them.
std::size_t allocation_count();

}  // namespace cambrian::test
