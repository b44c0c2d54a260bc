#include "preserve/resident_motion.h"

#include "core/assert.h"
#include "preserve/world/walls.h"

#include <algorithm>

namespace cambrian {

ResidentMotion::ResidentMotion(const PreserveWorld& world) : world_(world) {
    if (is_solid(world.settings->preserve))
        solid_ = std::make_unique<SolidBodies>(world.kinds.creature.scene, world.area.torus());
}

void ResidentMotion::forget() {
    if (solid_) solid_->forget();
}

SolidCounts ResidentMotion::counts() const {
    return solid_ ? solid_->counts() : SolidCounts{};
}

void ResidentMotion::advance(const Residents& residents, ThreadPool& pool) {
    make_workspaces(residents, pool.workers());
    if (solid_) return advance_solid(residents, pool);
    pool.parallel_for(residents.size(), [&](std::size_t index, std::size_t worker) {
        Resident& resident = *residents[index];
        if (walls_have_images()) surround(resident, resident.bounds());
        resident.live(workspaces_[worker], world_.area);
    });
}

void ResidentMotion::advance_solid(const Residents& residents, ThreadPool& pool) {
    std::vector<SolidBody> bodies;
    for (const auto& each : residents)
        bodies.push_back({.number = each->life.number,
                          .scene = &each->scene(),
                          .bounds = each->bounds(),
                          .fastest = each->fastest(),
                          .pulls = kPullsOfWalls});
    SolidActs acts{
        .begin = [&](std::size_t index) { residents[index]->act(world_.area); },
        .end = [&](std::size_t index) { residents[index]->end_tick(bodies[index].status); }};
    if (walls_have_images()) {
        acts.surround = [&](std::size_t index, const Bounds& bounds) {
            surround(*residents[index], bounds);
        };
    }
    solid_->advance(bodies, kBrainTick, acts, workspaces_, pool);
}

bool ResidentMotion::walls_have_images() const {
    return world_.area.torus().meets() && !world_.walls.lines().empty();
}

// Gives a resident the images of the walls that bodies within these bounds can reach. Where edges
// do not meet, all have the same walls.
void ResidentMotion::surround(Resident& resident, const Bounds& bounds) const {
    resident.surround_by(world_.walls.boxes_around(bounds));
}

void ResidentMotion::make_workspaces(const Residents& residents, std::size_t workers) {
    workspaces_.resize(std::max(workspaces_.size(), workers));
    for (std::size_t worker = 0; worker < workers && !residents.empty(); ++worker) {
        if (workspaces_[worker]) continue;
        const auto scene =
            world_.kinds.creature.scene.make(residents.front()->phenotype().plan,
                                             world_.environment(), world_.settings->world.scene);
        CAMBRIAN_ASSERT(scene.has_value(), "a resident's body suits physics");
        workspaces_[worker] = (*scene)->take_workspace();
    }
}

}  // namespace cambrian
