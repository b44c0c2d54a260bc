#pragma once

// Advances solid bodies by a tick: those that may touch as one, all others alone
// (preserve/README.md 9).

#include "core/threads/thread_pool.h"
#include "preserve/bodies/islands.h"
#include "preserve/bodies/swept_bounds.h"
#include "preserve/world/broad_phase.h"
#include "world/joined_scenes.h"
#include "world/scene_kind.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace cambrian {

struct SolidBody {
    std::uint64_t number = 0;  // never used for another body
    PhysicsScene* scene = nullptr;
    Bounds bounds = {};                          // before the tick
    double fastest = 0.0;                        // m/s; no point of it is faster before the tick
    int pulls = 0;                               // forces that it may be given for this tick
    SceneStatus status = SceneStatus::kRunning;  // after the tick
};

// Calls for what bodies do besides moving, by index, on any worker.
struct SolidActs {
    // While the scene has a workspace.
    std::function<void(std::size_t)> begin;  // once, before the body moves
    std::function<void(std::size_t)> end;    // after it moved; once more if it has to move again
    // Before it moves, with the bounds of all that move with it; once more if it has to move again.
    // May be empty.
    std::function<void(std::size_t, const Bounds&)> surround = {};
};

// Sums over all ticks.
struct SolidCounts {
    std::uint64_t ticks = 0;          // of one body
    std::uint64_t joined_ticks = 0;   // of one body, in an island of several
    std::uint64_t crowded_ticks = 0;  // of one body and each spring that pressed it
    std::uint64_t redone = 0;         // islands that were advanced once more
};

class SolidBodies {
public:
    using Workspaces = std::span<std::unique_ptr<SceneWorkspace>>;  // one for each worker

    // Scenes must be of this kind. The kind must outlive it.
    explicit SolidBodies(const SceneKind& kind, const Torus& torus = {})
        : kind_(&kind), torus_(torus), broad_phase_(torus) {}

    // Advances all bodies, in ascending order of numbers; their scenes have no workspace. A body
    // whose motion fails does not move, and the others move as if it were not there. Those that are
    // advanced as one are first moved to their images beside each other. The result is the same on
    // any number of workers.
    void advance(std::span<SolidBody> bodies, double duration, const SolidActs& acts,
                 Workspaces workspaces, ThreadPool& pool);

    // Forgets contacts, as after a snapshot, and frees what the next tick computes again.
    void forget();

    const SolidCounts& counts() const { return counts_; }
    // Returns whether two bodies, by index, were advanced as one in the last tick.
    bool were_joined(std::uint32_t a, std::uint32_t b) const { return islands_.are_joined(a, b); }
    // Pairs for which there was no room.
    const std::vector<NearPair>& crowded() const { return islands_.crowded(); }

private:
    using Memory = std::map<std::vector<std::uint64_t>, std::unique_ptr<JoinedScenes>>;
    struct Island {
        std::vector<std::uint32_t> members;               // indices, ascending
        std::unique_ptr<JoinedScenes>* joined = nullptr;  // of several members
    };
    struct Tick {
        std::span<SolidBody> bodies;
        double duration;
        const SolidActs& acts;
        Workspaces workspaces;
        ThreadPool& pool;
    };

    void look_around(const Tick& tick);
    std::vector<NearPair> expected_pairs() const;
    Vec3 shift_of(const NearPair& pair) const;
    void bring_together(const Tick& tick);
    void press_crowded(const Tick& tick);
    std::vector<Island> list_islands(const Tick& tick, const std::vector<bool>& wanted);
    void run(const Tick& tick, std::vector<Island> islands);
    void begin(const Tick& tick, std::uint32_t body, std::size_t worker);
    void surround(const Tick& tick, std::span<const std::uint32_t> members) const;
    void run_alone(const Tick& tick, std::uint32_t body, std::size_t worker);
    void run_joined(const Tick& tick, const Island& island, std::size_t worker);
    void run_members(const Tick& tick, const Island& island, std::size_t worker) const;
    void end(const Tick& tick, std::uint32_t body);
    static std::size_t find_culprit(const Tick& tick, std::span<const std::uint32_t> members,
                                    std::unique_ptr<SceneWorkspace>& workspace);
    std::vector<bool> find_leavers(const Tick& tick);
    bool is_settled(const Tick& tick, const NearPair& pair) const;
    std::vector<NearPair> missed_pairs(const Tick& tick);
    void redo(const Tick& tick, const std::vector<NearPair>& missed);
    void count(const Tick& tick);

    const SceneKind* kind_;
    Torus torus_;
    BroadPhase broad_phase_;
    std::vector<Bounds> reach_;         // within which every body surely stays
    std::vector<NearPair> neighbours_;  // pairs that could meet at all
    std::vector<bool> is_awake_;        // has a neighbour
    std::vector<SweptBounds> before_, after_;
    Islands islands_;
    std::vector<Periods> images_;  // to which each body was moved in this tick
    Memory memory_, next_memory_;
    SolidCounts counts_;
};

}  // namespace cambrian
