#pragma once

#include <cstddef>

namespace cambrian::test {

// Allocations by the calling thread so far. A program that links this has its operator new replaced
// by one that counts; sanitizers bring their own, so suites leave such tests out under them.
std::size_t allocation_count();

}  // namespace cambrian::test
