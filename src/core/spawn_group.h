#pragma once

#include <spawn.h>

namespace cambrian {

// Attributes for posix_spawn() that put the child in its own process group. Ctrl+C then reaches
// only this program, which must end the child itself.
class SpawnGroup {
public:
    SpawnGroup() {
        ::posix_spawnattr_init(&attributes_);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    }
    ~SpawnGroup() { ::posix_spawnattr_destroy(&attributes_); }
    SpawnGroup(const SpawnGroup&) = delete;
    SpawnGroup& operator=(const SpawnGroup&) = delete;
    const posix_spawnattr_t* get() const { return &attributes_; }

private:
    posix_spawnattr_t attributes_{};
};

}  // namespace cambrian
