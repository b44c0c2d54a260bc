#pragma once

// The identity of the file that a name or a descriptor refers to. Two names of one file have the
// same identity.

#include <sys/stat.h>
#include <utility>

namespace cambrian {

using FileIdentity = std::pair<dev_t, ino_t>;

inline FileIdentity identity_of(const struct stat& facts) {
    return {facts.st_dev, facts.st_ino};
}

}  // namespace cambrian
