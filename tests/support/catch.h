#pragma once

// Includes the test framework. No other file includes it.
#include <catch2/catch.hpp>
