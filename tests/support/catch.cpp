// Compiles the precompiled header that all suites share.
#include "support/catch.h"
