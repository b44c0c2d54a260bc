#pragma once

namespace cambrian {

// The exit status of the program.
enum class ExitStatus : int {
    kDone = 0,
    kFailed = 1,    // failure while working: a full disk, a replay that differs
    kBadInput = 2,  // wrong usage, or a file that cannot be used
};

}  // namespace cambrian
