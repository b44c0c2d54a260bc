// Carries the precompiled header the suites share.
#include "support/catch.h"
