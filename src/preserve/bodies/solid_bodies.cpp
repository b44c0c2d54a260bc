#include "preserve/bodies/solid_bodies.h"

#include "core/assert.h"
#include "preserve/bodies/crowding.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr double kSpareSpeed = 2.0;      // m/s; gain in speed that is expected at most
constexpr double kSurelySpeed = 10.0;    // m/s; gain in speed of a body that touches nobody
constexpr double kTouchDistance = 0.02;  // m; nearer bodies have contacts

SceneStatus advance_alone(PhysicsScene& scene, double duration,
                          std::unique_ptr<SceneWorkspace>& workspace) {
    scene.give_workspace(std::move(workspace));
    const SceneStatus status = scene.advance(duration);
    workspace = scene.take_workspace();
    return status;
}

}  // namespace

void SolidBodies::advance(std::span<SolidBody> bodies, double duration, const SolidActs& acts,
                          Workspaces workspaces, ThreadPool& pool) {
    CAMBRIAN_ASSERT(workspaces.size() >= pool.workers(), "a workspace for each worker");
    const Tick tick{bodies, duration, acts, workspaces, pool};
    look_around(tick);
    std::vector<SceneSize> sizes;
    for (const SolidBody& body : bodies)
        sizes.push_back(body.scene->size());
    islands_.begin(sizes, kind_->largest_join);
    islands_.join(expected_pairs());
    images_.assign(bodies.size(), {});
    bring_together(tick);
    press_crowded(tick);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (is_awake_[i]) bodies[i].scene->mark();
    }
    run(tick, list_islands(tick, std::vector<bool>(bodies.size(), true)));
    for (std::vector<NearPair> missed = missed_pairs(tick); !missed.empty();
         missed = missed_pairs(tick))
        redo(tick, missed);
    memory_ = std::exchange(next_memory_, {});
    count(tick);
}

void SolidBodies::forget() {
    memory_.clear();
    before_.clear();
    after_.clear();
}

// Finds who could meet whom. All who could begin their tick, and their extents are found.
void SolidBodies::look_around(const Tick& tick) {
    const std::size_t count = tick.bodies.size();
    reach_.resize(count);
    before_.resize(count);
    after_.resize(count);
    is_awake_.assign(count, false);
    for (std::size_t i = 0; i < count; ++i) {
        const SolidBody& body = tick.bodies[i];
        reach_[i] =
            grown(body.bounds, (body.fastest + kSurelySpeed) * tick.duration + kTouchDistance);
    }
    neighbours_.clear();
    for (const auto& [first, second, image] : broad_phase_.find(reach_)) {
        neighbours_.push_back({0.0, first, second, image});
        is_awake_[first] = true;
        is_awake_[second] = true;
    }
    std::vector<std::uint32_t> awake;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (is_awake_[i]) awake.push_back(i);
    }
    tick.pool.parallel_for(
        awake.size(), [&](std::size_t i, std::size_t worker) { begin(tick, awake[i], worker); });
}

void SolidBodies::begin(const Tick& tick, std::uint32_t body, std::size_t worker) {
    const SolidBody& begun = tick.bodies[body];
    begun.scene->give_workspace(std::move(tick.workspaces[worker]));
    tick.acts.begin(body);
    before_[body].growth = (begun.fastest + kSpareSpeed) * tick.duration + 0.5 * kTouchDistance;
    find_parts(*begun.scene, before_[body]);
    tick.workspaces[worker] = begun.scene->take_workspace();
}

std::vector<NearPair> SolidBodies::expected_pairs() const {
    std::vector<NearPair> pairs;
    SweptBounds image;
    for (const NearPair& pair : neighbours_) {
        const SweptBounds& a = before_[pair.first];
        const SweptBounds& b = seen(before_[pair.second], torus_.shift_of(pair.image), image);
        const double reach = a.growth + b.growth;
        const double gap = gap_between(a, b, reach);
        if (gap <= reach) pairs.push_back({gap, pair.first, pair.second, pair.image});
    }
    return pairs;
}

// Returns how far the image of the second body that the first one may touch is from it now.
Vec3 SolidBodies::shift_of(const NearPair& pair) const {
    return torus_.shift_of(images_[pair.first] + pair.image - images_[pair.second]);
}

// Moves the members of each island to their images beside its first one.
void SolidBodies::bring_together(const Tick& tick) {
    for (std::uint32_t i = 0; i < tick.bodies.size(); ++i) {
        const Periods image = islands_.image(i);
        if (image == images_[i]) continue;
        const Vec3 shift = torus_.shift_of(image - images_[i]);
        tick.bodies[i].scene->translate(shift);
        tick.bodies[i].scene->mark();
        move(before_[i], shift);
        images_[i] = image;
    }
}

void SolidBodies::press_crowded(const Tick& tick) {
    if (islands_.crowded().empty()) return;
    std::vector<int> room;
    for (const SolidBody& body : tick.bodies)
        room.push_back(kMostPulls - body.pulls);
    SweptBounds image;
    for (const NearPair& pair : islands_.crowded()) {
        const auto pressed = [&](std::uint32_t i, const Vec3& shift) {
            return PressedBody{*tick.bodies[i].scene, seen(before_[i], shift, image), room[i],
                               shift};
        };
        if (press_apart(pressed(pair.first, Vec3::Zero()), pressed(pair.second, shift_of(pair))))
            counts_.crowded_ticks += 2;
    }
}

// Lists the islands of the wanted bodies, in the order of their first members. Bodies whose motion
// failed belong to none.
std::vector<SolidBodies::Island> SolidBodies::list_islands(const Tick& tick,
                                                           const std::vector<bool>& wanted) {
    std::vector<Island> islands;
    std::vector<std::size_t> place(tick.bodies.size(), tick.bodies.size());
    for (std::uint32_t i = 0; i < tick.bodies.size(); ++i) {
        if (!wanted[i] || tick.bodies[i].status != SceneStatus::kRunning) continue;
        std::size_t& found = place[islands_.find(i)];
        if (found == tick.bodies.size()) {
            found = islands.size();
            islands.emplace_back();
        }
        islands[found].members.push_back(i);
    }
    for (Island& island : islands) {
        if (island.members.size() == 1) continue;
        std::vector<std::uint64_t> numbers;
        for (const std::uint32_t member : island.members)
            numbers.push_back(tick.bodies[member].number);
        auto known = memory_.extract(numbers);
        const auto kept = known.empty() ? next_memory_.try_emplace(std::move(numbers)).first
                                        : next_memory_.insert(std::move(known)).position;
        island.joined = &kept->second;
    }
    return islands;
}

void SolidBodies::run(const Tick& tick, std::vector<Island> islands) {
    tick.pool.parallel_for(islands.size(), [&](std::size_t i, std::size_t worker) {
        const Island& island = islands[i];
        if (island.members.size() > 1) return run_joined(tick, island, worker);
        run_alone(tick, island.members.front(), worker);
    });
}

void SolidBodies::surround(const Tick& tick, std::span<const std::uint32_t> members) const {
    if (!tick.acts.surround) return;
    Bounds all;
    for (const std::uint32_t member : members) {
        const Bounds& before = tick.bodies[member].bounds;
        const Bounds bounds = moved(before, torus_.shift_of(images_[member]));
        all.add(bounds.low);
        all.add(bounds.high);
    }
    for (const std::uint32_t member : members)
        tick.acts.surround(member, all);
}

void SolidBodies::run_alone(const Tick& tick, std::uint32_t body, std::size_t worker) {
    surround(tick, {&body, 1});
    SolidBody& alone = tick.bodies[body];
    alone.scene->give_workspace(std::move(tick.workspaces[worker]));
    if (!is_awake_[body]) tick.acts.begin(body);
    alone.status = alone.scene->advance(tick.duration);
    end(tick, body);
    tick.workspaces[worker] = alone.scene->take_workspace();
}

void SolidBodies::end(const Tick& tick, std::uint32_t body) {
    tick.acts.end(body);
    if (is_awake_[body]) find_parts(*tick.bodies[body].scene, after_[body]);
}

void SolidBodies::run_joined(const Tick& tick, const Island& island, std::size_t worker) {
    surround(tick, island.members);
    run_members(tick, island, worker);
    for (const std::uint32_t member : island.members) {
        PhysicsScene& scene = *tick.bodies[member].scene;
        scene.give_workspace(std::move(tick.workspaces[worker]));
        end(tick, member);
        tick.workspaces[worker] = scene.take_workspace();
    }
}

// Advances the members as one. If that fails, the culprit is left out and the others try again.
void SolidBodies::run_members(const Tick& tick, const Island& island, std::size_t worker) const {
    std::vector<std::uint32_t> members = island.members;
    std::unique_ptr<SceneWorkspace>& workspace = tick.workspaces[worker];
    while (members.size() > 1) {
        std::vector<PhysicsScene*> scenes;
        for (const std::uint32_t member : members)
            scenes.push_back(tick.bodies[member].scene);
        const bool are_all = members.size() == island.members.size();
        std::unique_ptr<JoinedScenes> others;
        std::unique_ptr<JoinedScenes>& joined = are_all ? *island.joined : others;
        if (!joined) joined = kind_->join(scenes);
        if (joined->advance(scenes, tick.duration, *workspace) == SceneStatus::kRunning) return;
        joined.reset();
        const std::size_t culprit = find_culprit(tick, members, workspace);
        tick.bodies[members[culprit]].status = SceneStatus::kInvalid;
        members.erase(members.begin() + static_cast<std::ptrdiff_t>(culprit));
    }
    SolidBody& last = tick.bodies[members.front()];
    last.status = advance_alone(*last.scene, tick.duration, workspace);
}

// Returns the first member that cannot move alone either, or else the fastest one.
std::size_t SolidBodies::find_culprit(const Tick& tick, std::span<const std::uint32_t> members,
                                      std::unique_ptr<SceneWorkspace>& workspace) {
    std::size_t fastest = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const SolidBody& alone = tick.bodies[members[i]];
        if (alone.fastest > most) fastest = i;
        most = std::max(most, alone.fastest);
        if (advance_alone(*alone.scene, tick.duration, workspace) != SceneStatus::kRunning)
            return i;
        alone.scene->go_back();
    }
    return fastest;
}

// Returns who got farther than expected. Its extent afterwards has the boxes of all it swept.
std::vector<bool> SolidBodies::find_leavers(const Tick& tick) {
    std::vector<bool> left(tick.bodies.size(), false);
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (!is_awake_[i] || tick.bodies[i].status != SceneStatus::kRunning) continue;
        if (!has_left(before_[i], after_[i])) continue;
        left[i] = true;
        for (std::size_t part = 0; part < after_[i].boxes.size(); ++part) {
            after_[i].boxes[part].add(before_[i].boxes[part].low);
            after_[i].boxes[part].add(before_[i].boxes[part].high);
        }
    }
    return left;
}

bool SolidBodies::is_settled(const Tick& tick, const NearPair& pair) const {
    return tick.bodies[pair.first].status != SceneStatus::kRunning ||
           tick.bodies[pair.second].status != SceneStatus::kRunning ||
           islands_.are_together(pair) ||
           std::any_of(islands_.crowded().begin(), islands_.crowded().end(),
                       [&](const NearPair& other) {
                           return other.first == pair.first && other.second == pair.second &&
                                  other.image == pair.image;
                       });
}

// Returns the pairs that could have met after all, because one of them got farther than expected.
std::vector<NearPair> SolidBodies::missed_pairs(const Tick& tick) {
    const std::vector<bool> left = find_leavers(tick);
    const auto extent = [&](std::uint32_t i) -> const SweptBounds& {
        return left[i] ? after_[i] : before_[i];
    };
    const auto room = [&](std::uint32_t i) {
        return left[i] ? 0.5 * kTouchDistance : before_[i].growth;
    };
    std::vector<NearPair> missed;
    SweptBounds image;
    for (const NearPair& pair : neighbours_) {
        if (!left[pair.first] && !left[pair.second]) continue;
        if (is_settled(tick, pair)) continue;
        const SweptBounds& second = seen(extent(pair.second), shift_of(pair), image);
        const double gap = gap_between_boxes(extent(pair.first), second);
        if (gap <= room(pair.first) + room(pair.second))
            missed.push_back({gap, pair.first, pair.second, pair.image});
    }
    return missed;
}

// Joins more islands and advances them again.
void SolidBodies::redo(const Tick& tick, const std::vector<NearPair>& missed) {
    islands_.join(missed);
    std::vector<bool> grows(tick.bodies.size(), false);
    for (const NearPair& pair : missed) {
        if (islands_.are_joined(pair.first, pair.second)) grows[islands_.find(pair.first)] = true;
    }
    std::vector<bool> again(tick.bodies.size(), false);
    for (std::uint32_t i = 0; i < tick.bodies.size(); ++i) {
        if (!grows[islands_.find(i)]) continue;
        again[i] = true;
        if (tick.bodies[i].status == SceneStatus::kRunning) tick.bodies[i].scene->go_back();
    }
    bring_together(tick);
    std::vector<Island> islands = list_islands(tick, again);
    counts_.redone += islands.size();
    run(tick, std::move(islands));
}

void SolidBodies::count(const Tick& tick) {
    std::vector<std::uint32_t> members(tick.bodies.size(), 0);
    for (std::uint32_t i = 0; i < tick.bodies.size(); ++i)
        ++members[islands_.find(i)];
    counts_.ticks += tick.bodies.size();
    for (std::uint32_t i = 0; i < tick.bodies.size(); ++i)
        counts_.joined_ticks += members[islands_.find(i)] > 1 ? 1U : 0U;
}

}  // namespace cambrian
