#pragma once

// Lets all creatures of a preserve think and move for a tick, on any number of workers.

#include "preserve/bodies/solid_bodies.h"
#include "preserve/preserve_world.h"

#include <memory>
#include <vector>

namespace cambrian {

class ResidentMotion {
public:
    explicit ResidentMotion(const PreserveWorld& world);

    void advance(const Residents& residents, ThreadPool& pool);
    // Forgets contacts of solid bodies, as after a snapshot.
    void forget();
    SolidCounts counts() const;

private:
    void advance_solid(const Residents& residents, ThreadPool& pool);
    void make_workspaces(const Residents& residents, std::size_t workers);
    bool walls_have_images() const;
    void surround(Resident& resident, const Bounds& bounds) const;

    const PreserveWorld& world_;
    std::unique_ptr<SolidBodies> solid_;                       // if bodies are solid
    std::vector<std::unique_ptr<SceneWorkspace>> workspaces_;  // one for each worker
};

}  // namespace cambrian
