#pragma once

// The only include of the test framework.
#include <catch2/catch.hpp>
