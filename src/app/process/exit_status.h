#pragma once

namespace cambrian {

// What the program tells the shell.
enum class ExitStatus : int {
    kDone = 0,
    kFailed = 1,    // something went wrong on the way: a full disk, a replay that differs
    kBadInput = 2,  // usage, or a file that cannot be used
};

}  // namespace cambrian
