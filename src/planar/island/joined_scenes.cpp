
#include "core/assert.h"
#include "planar/island/joined_model.h"
#include "planar/island/packed_body.h"
#include "planar/island/scene_body.h"
#include "planar/stepping/audit.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

// Offsets of a member's numbers among those of all.
struct Offset {
    int body = 0, tree = 0, part = 0;
};

BodyScene& body_scene(PhysicsScene& scene) {
    auto* found = dynamic_cast<BodyScene*>(&scene);
    CAMBRIAN_ASSERT(found != nullptr, "a scene of an articulated body");
    return *found;
}

struct JoinedState final : SceneState {
    JoinedState(const PackedBody& saved, bool saved_new) : packed(saved), is_new(saved_new) {}
    PackedBody packed;
    bool is_new;
};

class JoinedBodies final : public JoinedScenes {
public:
    explicit JoinedBodies(std::span<PhysicsScene* const> scenes) : offsets_(scenes.size()) {
        Offset end;
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            offsets_[i] = end;
            const SceneSize size = scenes[i]->size();
            end.body += size.bodies;
            end.tree += size.trees;
            end.part += size.parts;
        }
    }

    SceneStatus advance(std::span<PhysicsScene* const> scenes, double duration,
                        SceneWorkspace& workspace) override;
    std::unique_ptr<SceneState> save() const override {
        return std::make_unique<JoinedState>(packed_, is_new_);
    }
    void restore(const SceneState& state) override;

private:
    void begin();
    SceneStatus move(double duration, StepControl& control);
    void gather();
    bool follows(const SceneBody& member, const Offset& offset) const;
    template <class From, class To, class Visit>
    void visit_coordinates(From& from, To& to, const SceneBody& member, const Offset& offset,
                           const Visit& visit) const;
    void begin_anew(const SceneBody& member, const Offset& offset);
    void take_drive(const SceneBody& member, const Offset& offset);
    void take_pulls(const SceneBody& member, const Offset& offset);
    void spread(double duration, SceneBody& member, std::size_t index) const;
    void give_motion(SceneBody& member, const Offset& offset) const;
    void give_touches(SceneBody& member, const Offset& offset) const;
    const PhysicsScene* scene_of(int body) const;
    void give_impacts(SceneBody& member, const Offset& offset) const;
    void give_works(SceneBody& member, std::size_t index) const;
    void give_audit(SceneBody& member) const;
    double share() const { return 1.0 / static_cast<double>(offsets_.size()); }

    std::vector<Offset> offsets_;
    PackedBody packed_;
    SceneBody* all_ = nullptr;         // in the workspace of the present tick
    std::vector<SceneBody*> members_;  // the scenes' bodies, also there
    std::span<PhysicsScene* const> scenes_;
    bool is_new_ = true;
};

SceneStatus JoinedBodies::advance(std::span<PhysicsScene* const> scenes, double duration,
                                  SceneWorkspace& workspace) {
    CAMBRIAN_ASSERT(scenes.size() == offsets_.size(), "the scenes that were joined");
    auto* steps = dynamic_cast<StepWorkspace*>(&workspace);
    CAMBRIAN_ASSERT(steps != nullptr, "a workspace of an articulated body");
    members_.clear();
    for (std::size_t i = 0; i < scenes.size(); ++i)
        members_.push_back(&body_scene(*scenes[i]).open(steps->room(i)));
    all_ = &steps->joined_room();
    scenes_ = scenes;
    if (is_new_)
        begin();
    else
        packed_.unpack(*all_);
    const SceneStatus status = move(duration, steps->control);
    for (PhysicsScene* scene : scenes)
        body_scene(*scene).close();
    packed_.pack(*all_);
    is_new_ = false;
    return status;
}

void JoinedBodies::begin() {
    std::vector<const PlanarModel*> models;
    for (const SceneBody* member : members_)
        models.push_back(&member->model);
    all_->model = join_models(models);
    all_->state = SimulationState{};
    all_->forcing = Forcing{};
}

SceneStatus JoinedBodies::move(double duration, StepControl& control) {
    gather();
    SimulationState& state = all_->state;
    if (!state.cache_is_current) {
        all_->forcing.held = nullptr;
        evaluate_accelerations(all_->model, all_->forcing, state.motion, {}, state.cache(),
                               state.free_rate);
        state.cache_is_current = true;
    }
    start_audit(all_->model, all_->forcing.medium, state);
    std::fill(std::begin(state.member_work), std::end(state.member_work), MemberWork{});
    control.change_model(all_->model);
    state.detection = 0;
    control.advance(all_->model, all_->law, all_->forcing, duration, state);
    if (state.status != SceneStatus::kRunning) return state.status;
    for (std::size_t i = 0; i < members_.size(); ++i)
        spread(duration, *members_[i], i);
    end_tick(*all_);
    return state.status;
}

void JoinedBodies::restore(const SceneState& state) {
    const auto* joined = dynamic_cast<const JoinedState*>(&state);
    CAMBRIAN_ASSERT(joined != nullptr, "a state of joined scenes");
    packed_ = joined->packed;
    is_new_ = joined->is_new;
}

// Takes over what the members do in the next tick, and their motions unless they still follow.
void JoinedBodies::gather() {
    const SceneBody& first = *members_.front();
    bool follow = !is_new_;
    for (std::size_t i = 0; follow && i < members_.size(); ++i)
        follow = follows(*members_[i], offsets_[i]);
    if (!follow) {
        static_cast<SceneMoment&>(all_->state) = SceneMoment{};
        all_->state.has_last_acceleration = true;
        all_->state.proposed_step = first.state.proposed_step;
        all_->state.cache_is_current = false;
    }
    all_->law = first.law;
    all_->forcing.medium = first.forcing.medium;
    all_->forcing.drive.frequency = first.forcing.drive.frequency;
    all_->forcing.drive.speed_limit = first.forcing.drive.speed_limit;
    all_->forcing.pulls.clear();
    for (std::size_t i = 0; i < members_.size(); ++i) {
        SceneBody& member = *members_[i];
        if (!follow) begin_anew(member, offsets_[i]);
        begin_tick(member);
        take_drive(member, offsets_[i]);
        take_pulls(member, offsets_[i]);
    }
    if (!all_->forcing.pulls.empty()) all_->state.cache_is_current = false;
}

// Calls visit(from, to, count) for the coordinates of a member's bodies and of its centres.
template <class From, class To, class Visit>
void JoinedBodies::visit_coordinates(From& from, To& to, const SceneBody& member,
                                     const Offset& offset, const Visit& visit) const {
    visit(from, to + offset.body, member.model.body_count);
    visit(from + member.model.body_count, to + center_of(all_->model, offset.tree),
          2 * member.model.tree_count);
}

// Whether a member still has the motion that the last tick gave it.
bool JoinedBodies::follows(const SceneBody& member, const Offset& offset) const {
    bool same = true;
    const auto compare = [&](const double* own, const double* joined, int count) {
        same = same && std::equal(own, own + count, joined);
    };
    const Motion& own = member.state.motion;
    const Motion& joined = all_->state.motion;
    visit_coordinates(own.position, joined.position, member, offset, compare);
    visit_coordinates(own.speed, joined.speed, member, offset, compare);
    return same;
}

void JoinedBodies::begin_anew(const SceneBody& member, const Offset& offset) {
    SimulationState& all = all_->state;
    const SimulationState& own = member.state;
    const int bodies = member.model.body_count;
    const int parts = member.model.part_count;
    const auto copy = [](const double* from, double* to, int count) {
        std::copy_n(from, count, to);
    };
    visit_coordinates(own.motion.position, all.motion.position, member, offset, copy);
    visit_coordinates(own.motion.speed, all.motion.speed, member, offset, copy);
    visit_coordinates(own.last_acceleration, all.last_acceleration, member, offset, copy);
    all.has_last_acceleration = all.has_last_acceleration && own.has_last_acceleration;
    all.proposed_step = std::min(all.proposed_step, own.proposed_step);
    all.evaluation_debt = std::max(all.evaluation_debt, own.evaluation_debt);
    std::copy_n(own.warm.ground_friction, bodies, all.warm.ground_friction + offset.body);
    std::copy_n(own.warm.limit, bodies, all.warm.limit + offset.body);
    std::copy_n(own.forces.speed_x, parts, all.forces.speed_x + offset.part);
    std::copy_n(own.forces.speed_y, parts, all.forces.speed_y + offset.part);
}

void JoinedBodies::take_drive(const SceneBody& member, const Offset& offset) {
    const int bodies = member.model.body_count;
    const MotorDrive& drive = member.forcing.drive;
    std::copy_n(drive.start, bodies, all_->forcing.drive.start + offset.body);
    std::copy_n(drive.end, bodies, all_->forcing.drive.end + offset.body);
}

void JoinedBodies::take_pulls(const SceneBody& member, const Offset& offset) {
    for (const HeldForce& pull : member.forcing.pulls) {
        all_->forcing.pulls.push_back(pull);
        all_->forcing.pulls.back().body_a += offset.body;
    }
}

// Gives a member its share of the tick.
void JoinedBodies::spread(double duration, SceneBody& member, std::size_t index) const {
    const Offset& offset = offsets_[index];
    give_motion(member, offset);
    give_touches(member, offset);
    give_impacts(member, offset);
    SimulationState& own = member.state;
    own.time += duration;
    own.detection = 0;
    own.known_spins = 0;
    own.warm.count = 0;
    member.forcing.held = nullptr;
    evaluate_accelerations(member.model, member.forcing, own.motion, {.tick_share = 1.0},
                           own.cache(), own.free_rate);
    own.cache_is_current = true;
    own.energy.reset();
    give_audit(member);
    give_works(member, index);
    end_tick(member);
}

void JoinedBodies::give_motion(SceneBody& member, const Offset& offset) const {
    const SimulationState& all = all_->state;
    SimulationState& own = member.state;
    const auto copy = [](double* to, const double* from, int count) {
        std::copy_n(from, count, to);
    };
    visit_coordinates(own.motion.position, all.motion.position, member, offset, copy);
    visit_coordinates(own.motion.speed, all.motion.speed, member, offset, copy);
    visit_coordinates(own.last_acceleration, all.last_acceleration, member, offset, copy);
    own.has_last_acceleration = all.has_last_acceleration;
    own.proposed_step = all.proposed_step;
    own.evaluation_debt = all.evaluation_debt;
    const int bodies = member.model.body_count;
    std::copy_n(all.warm.ground_friction + offset.body, bodies, own.warm.ground_friction);
    std::copy_n(all.warm.limit + offset.body, bodies, own.warm.limit);
}

void JoinedBodies::give_touches(SceneBody& member, const Offset& offset) const {
    const SimulationState& all = all_->state;
    SimulationState& own = member.state;
    const int parts = member.model.part_count;
    std::copy_n(all.touched + offset.part, parts, own.touched);
    for (const auto numbers : {&PartForces::speed_x, &PartForces::speed_y, &PartForces::specific_x,
                               &PartForces::specific_y, &PartForces::load})
        std::copy_n(all.forces.*numbers + offset.part, parts, own.forces.*numbers);
    own.held_count = 0;
    for (int c = 0; c < all.held_count; ++c) {
        HeldContact held = all.held[c];
        held.body_a -= offset.body;
        if (held.body_a < 0 || held.body_a >= member.model.body_count) continue;
        own.held[own.held_count++] = held;
    }
}

// Returns the scene of a body of all; null for -1.
const PhysicsScene* JoinedBodies::scene_of(int body) const {
    const PhysicsScene* found = nullptr;
    for (std::size_t i = 0; i < offsets_.size(); ++i) {
        if (offsets_[i].body <= body) found = scenes_[i];
    }
    return found;
}

// Both members of an impact note it, as one with something outside.
void JoinedBodies::give_impacts(SceneBody& member, const Offset& offset) const {
    SimulationState& own = member.state;
    own.impact_count = 0;
    const auto is_own = [&](int body) {
        return body >= offset.body && body < offset.body + member.model.body_count;
    };
    for (int i = 0; i < all_->state.impact_count; ++i) {
        NotedImpact noted = all_->state.impacts[i];
        if (!is_own(noted.body_a)) {
            if (!is_own(noted.body_b)) continue;
            std::swap(noted.body_a, noted.body_b);
            std::swap(noted.part_a, noted.part_b);
        }
        const bool within = is_own(noted.body_b);
        noted.other = within ? nullptr : scene_of(noted.body_b);
        noted.body_a -= offset.body;
        noted.part_a -= offset.part;
        noted.body_b = within ? noted.body_b - offset.body : -1;
        noted.part_b = within ? noted.part_b - offset.part : -1;
        own.impacts[own.impact_count++] = noted;
    }
}

// Works of motors are measured for each member by the trapezoidal rule, and what that differs from
// the work of all is shared in proportion. Other works are shared in equal parts: those of a
// contact of two are split half and half.
void JoinedBodies::give_works(SceneBody& member, std::size_t index) const {
    const SimulationState& all = all_->state;
    MemberWork sum;
    for (std::size_t i = 0; i < offsets_.size(); ++i) {
        sum.net += all.member_work[i].net;
        sum.gross += all.member_work[i].gross;
    }
    const MemberWork& own = all.member_work[index];
    const double proportion = sum.gross > 0.0 ? own.gross / sum.gross : share();
    double* work = member.state.motion.work;
    const double residual = member.state.audit.energy_residual;
    work[kMotorWork] += own.net + proportion * (all.motion.work[kMotorWork] - sum.net);
    work[kGrossMotorWork] += proportion * all.motion.work[kGrossMotorWork];
    work[kDragWork] += share() * all.motion.work[kDragWork];
    work[kPullWork] += share() * all.motion.work[kPullWork];
    update_audit(member.model, member.forcing.medium, member.state);
    const double wanted = residual + share() * all.audit.energy_residual;
    member.state.energy_reference += member.state.audit.energy_residual - wanted;
    member.state.audit.energy_residual = wanted;
}

void JoinedBodies::give_audit(SceneBody& member) const {
    const SceneAudit& all = all_->state.audit;
    SceneAudit& own = member.state.audit;
    own.contact_work += share() * all.contact_work;
    own.limit_work += share() * all.limit_work;
    own.impulse_work += share() * all.impulse_work;
    own.positive_work += share() * all.positive_work;
    own.spin_gained = std::max(own.spin_gained, all.spin_gained);
    own.spin_scale = std::max(own.spin_scale, all.spin_scale);
    own.max_penetration = std::max(own.max_penetration, all.max_penetration);
    own.max_limit_overrun = std::max(own.max_limit_overrun, all.max_limit_overrun);
    own.evaluations += all.evaluations;
    own.steps += all.steps;
    own.rejections += all.rejections;
    own.events += all.events;
    own.fallbacks += all.fallbacks;
    note_speeds(member.model, member.state.cache().kinematics, own);
}

}  // namespace

std::unique_ptr<JoinedScenes> join_body_scenes(std::span<PhysicsScene* const> scenes) {
    CAMBRIAN_ASSERT(!scenes.empty(), "something to join");
    return std::make_unique<JoinedBodies>(scenes);
}

}  // namespace cambrian
