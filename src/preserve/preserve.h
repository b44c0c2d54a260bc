#pragma once

// A closed world in which creatures feed, hunt, breed and die by themselves (preserve/README.md 1).
// It is a function of settings, founders and seed: the number of threads has no influence.

#include "core/random.h"
#include "core/result.h"
#include "core/threads/thread_pool.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "evolution/settings/light_patches.h"
#include "preserve/bodies/solid_bodies.h"
#include "preserve/chronicle.h"
#include "preserve/life/room.h"
#include "preserve/series.h"
#include "preserve/state.h"
#include "preserve/world/common_senses.h"
#include "preserve/world/drawn_walls.h"
#include "preserve/world/meetings.h"
#include "preserve/world/pellets.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
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
    const SettingsPtr& settings() const { return settings_; }
    // The same with all changes of laws so far.
    const SettingsPtr& laws() const { return laws_; }
    std::uint64_t ticks() const { return tick_; }
    const Residents& residents() const { return residents_; }
    const Pellets& plants() const { return plants_; }
    const Pellets& flesh() const { return flesh_; }
    const DrawnWalls& walls() const { return walls_; }
    const std::vector<LightPatch>& patches() const { return patches_; }
    Energy ambient() const { return ambient_; }
    Energy total_energy() const;  // the same in every tick
    Energy founding_energy() const { return constant_; }
    SeriesRow row() const;  // of the present moment
    // Of solid bodies since the preserve began or was resumed; 0 if bodies are ghostly.
    SolidCounts solid_counts() const;

    PreserveState save() const;
    // The tick of the last snapshot, which is taken at each rest and multiple of 60 s.
    std::uint64_t snapshot_tick() const { return snapshot_tick_; }
    Chronicle take_chronicle();

private:
    Preserve(SettingsPtr settings, const EvolutionKinds& kinds, std::vector<GenomePtr> founders);
    Status found();
    void sow();
    Result<std::uint64_t> carry_out(const Intervention& asked);
    Result<std::uint64_t> serve(const Vec3& place);
    Result<std::uint64_t> admit(const GenomePtr& genome, const Vec3& place);
    Result<std::uint64_t> build_wall(const WallLine& wall);
    Result<std::uint64_t> erase_wall(const Vec3& place);
    Status change_law(const Intervention& asked);
    void use_laws(SettingsPtr laws);
    Status make_way(const DrawnWalls& walls);
    void use_walls(std::vector<WallLine> lines);
    void take_snapshot();
    void rest();
    bool adds_up(const PreserveState& state) const;
    Status restore(const PreserveState& state);

    void live(ThreadPool& pool);
    void move_solid(ThreadPool& pool);
    void make_workspaces(std::size_t workers);
    Room room() const { return {area_, walls_, residents_, solid_ != nullptr}; }
    bool walls_have_images() const { return area_.torus().meets() && !walls_.lines().empty(); }
    void surround(Resident& resident, const Bounds& bounds) const;
    void sense();
    void bite();
    void feed();
    void spend();
    void bury(std::uint64_t tick);
    void end_life(Resident& resident, std::uint64_t tick);
    void breed();
    void try_birth(Resident& parent);
    void bear(Resident& parent, std::unique_ptr<Resident> child, RandomStream& stream);
    void remember_lineage(std::uint64_t lineage);
    void remember_parent();
    void restock();
    Vec3 draw_bright_place(RandomStream& draws) const;
    void add_plant(RandomStream& draws);
    void grow_plants();
    void record();

    RandomStream stream(std::uint64_t index, std::uint64_t use) const;
    Result<std::unique_ptr<Resident>> newcomer(std::size_t place, std::string method);
    std::uint64_t newcomer_uid() const;
    Energy price_of(const Resident& resident) const;
    bool afford(const Resident& resident);
    void settle(std::unique_ptr<Resident> resident);
    void take_in(std::unique_ptr<Resident> resident);
    void join_lineage(Resident& resident, const Resident* parent);
    void feel_energy();
    void forget_lineages();

    SettingsPtr settings_;  // with which it began; residents refer to them
    SettingsPtr laws_;      // the same with all changes so far
    const EvolutionKinds& kinds_;
    std::vector<GenomePtr> founders_;
    WorldArea area_;
    Energy constant_;
    CommonSenses senses_;
    DrawnWalls walls_;
    std::vector<LightPatch> patches_;
    Pellets plants_, flesh_;
    Energy ambient_ = 0;
    Residents residents_;
    std::map<std::uint64_t, GenomePtr> lineages_;  // founders by number
    std::uint64_t tick_ = 0;
    std::uint64_t next_number_ = 1;
    std::uint64_t attempts_ = 0;
    std::uint64_t restocked_ = 0;
    Tally tally_;
    Chronicle chronicle_;
    std::uint64_t snapshot_tick_ = 0;
    Meetings meetings_;
    std::unique_ptr<SolidBodies> solid_;  // if bodies are solid
    std::vector<Bounds> bounds_;
    std::vector<std::unique_ptr<SceneWorkspace>> workspaces_;  // one for each worker
};

}  // namespace cambrian
