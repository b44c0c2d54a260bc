#pragma once

// A closed world in which creatures feed, hunt, breed and die by themselves (preserve/README.md 1).
// It is a function of settings, founders and seed: the number of threads has no influence.

#include "core/result.h"
#include "core/threads/thread_pool.h"
#include "preserve/population.h"
#include "preserve/preserve_world.h"
#include "preserve/resident_motion.h"
#include "preserve/state.h"
#include "preserve/world/broad_phase.h"

#include <memory>
#include <vector>

namespace cambrian {

inline constexpr std::uint64_t kTicksPerSnapshot = 3600;  // 60 s

class Preserve {
public:
    // Settings must have passed check_preserve(); founders must be valid and are used in turn.
    // Fails if a founder cannot live in these settings.
    static Result<std::unique_ptr<Preserve>> begin(SettingsPtr settings,
                                                   const EvolutionKinds& kinds,
                                                   std::vector<GenomePtr> founders);
    // Goes on from a state, under the laws of that time (laws.h); null for those of the settings.
    // Fails if the state does not suit the settings.
    static Result<std::unique_ptr<Preserve>> resume(SettingsPtr settings,
                                                    const EvolutionKinds& kinds,
                                                    std::vector<GenomePtr> founders,
                                                    const PreserveState& state,
                                                    SettingsPtr laws = nullptr);
    Preserve(const Preserve&) = delete;
    Preserve& operator=(const Preserve&) = delete;

    // Advances by 1/60 s.
    void tick(ThreadPool& pool);

    // Does what a person asks before the next tick, whatever its own tick is, and notes it. Returns
    // the number of the creature, or of plants. Fails if it cannot be done; nothing changes then.
    Result<std::uint64_t> intervene(Intervention asked);

    // The settings with which it began.
    const SettingsPtr& settings() const { return world_.settings; }
    // The same with all changes of laws so far.
    const SettingsPtr& laws() const { return world_.laws; }
    std::uint64_t ticks() const { return world_.tick; }
    const Residents& residents() const { return population_.living(); }
    const Food& plants() const { return world_.energy.plants; }
    const Food& flesh() const { return world_.energy.flesh; }
    const WorldArea& area() const { return world_.area; }
    const DrawnWalls& walls() const { return world_.walls; }
    const std::vector<LightPatch>& patches() const { return world_.patches; }
    Energy ambient() const { return world_.energy.light; }
    Energy total_energy() const;  // the same in every tick
    Energy founding_energy() const { return world_.energy.constant; }
    SeriesRow row() const;  // of the present moment
    // Counts solid bodies since the preserve began or was resumed; 0 if bodies are ghostly.
    SolidCounts solid_counts() const { return motion_.counts(); }

    PreserveState save() const;
    // The tick of the last snapshot, which is taken at each rest and multiple of 60 s.
    std::uint64_t snapshot_tick() const { return snapshot_tick_; }
    Chronicle take_chronicle();

private:
    Preserve(SettingsPtr settings, const EvolutionKinds& kinds, std::vector<GenomePtr> founders);
    Status found();
    Status restore(const PreserveState& state);
    void sense();
    void bite();
    void feed();
    void spend();
    void record();
    void take_snapshot();
    void rest();

    PreserveWorld world_;
    Population population_;
    ResidentMotion motion_;
    BroadPhase broad_phase_;
    std::vector<Bounds> bounds_;
    std::uint64_t snapshot_tick_ = 0;
};

}  // namespace cambrian
