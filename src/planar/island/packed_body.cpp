#include "planar/island/packed_body.h"

#include "core/assert.h"
#include "planar/evaluation/cache_numbers.h"
#include "planar/island/model_fields.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace cambrian {
namespace {

constexpr PerPart PartForces::*kForceNumbers[] = {&PartForces::speed_x, &PartForces::speed_y,
                                                  &PartForces::specific_x, &PartForces::specific_y,
                                                  &PartForces::load};

// A number that the lists leave out would be lost.
static_assert(sizeof(PartForces) == std::size(kForceNumbers) * sizeof(PerPart));
static_assert(sizeof(MotorLaw) == std::size(kMotorNumbers) * sizeof(PerBody));

// Sums up the bytes of what it is given.
class ByteCount {
public:
    template <class Number>
    void one(const Number&) {
        bytes_ += sizeof(Number);
    }
    void lanes(const double* numbers, int count, int) { some(numbers, count, 0); }
    template <class Number>
    void some(const Number*, int count, int) {
        bytes_ += static_cast<std::size_t>(count) * sizeof(Number);
    }
    std::size_t bytes() const { return bytes_; }

private:
    std::size_t bytes_ = 0;
};

// Numbers in lanes are as many as fill the vectors, which makes their copies short.
class Packing {
public:
    explicit Packing(PackedNumbers& to) : to_(to.data()) {}
    template <class Number>
    void one(const Number& number) {
        put(&number, sizeof(Number));
    }
    void lanes(const double* numbers, int count, int) {
        for (int i = 0; i < count; i += kLanes)
            put(numbers + i, sizeof(Simd4d));
    }
    template <class Number>
    void some(const Number* numbers, int count, int) {
        put(numbers, static_cast<std::size_t>(count) * sizeof(Number));
    }

private:
    CAMBRIAN_INLINE void put(const void* from, std::size_t bytes) {
        std::memcpy(to_, from, bytes);
        to_ += bytes;
    }

    std::byte* to_;
};

// Sets what was used before beyond the counts to 0.
class Unpacking {
public:
    explicit Unpacking(const PackedNumbers& from) : from_(from.data()) {}
    template <class Number>
    void one(Number& number) {
        get(&number, sizeof(Number));
    }
    void lanes(double* numbers, int count, int before) {
        for (int i = 0; i < count; i += kLanes)
            get(numbers + i, sizeof(Simd4d));
        for (int i = count; i < before; i += kLanes)
            store_lanes(numbers + i, Simd4d{});
    }
    template <class Number>
    void some(Number* numbers, int count, int before) {
        get(numbers, static_cast<std::size_t>(count) * sizeof(Number));
        if (before > count) std::fill(numbers + count, numbers + before, Number{});
    }

private:
    CAMBRIAN_INLINE void get(void* to, std::size_t bytes) {
        std::memcpy(to, from_, bytes);
        from_ += bytes;
    }

    const std::byte* from_;
};

// The functions below visit all numbers of a body that have a meaning between two ticks.

template <class Visitor>
void visit_dense(DenseForm& dense, const ChangedCounts& counts, Visitor& visitor) {
    visitor.one(dense.blocks);
    for (auto* matrix : {&dense.inertia_cosine, &dense.inertia_sine, &dense.arm_x, &dense.arm_y,
                         &dense.lever_x, &dense.lever_y})
        visitor.lanes(*matrix, counts.now.dense_matrix, counts.before.dense_matrix);
}

template <class Visitor>
void visit_model(PlanarModel& model, const ChangedCounts& counts, Visitor& visitor) {
    const NumberCounts& now = counts.now;
    const NumberCounts& before = counts.before;
    visitor.one(model.tree_count);
    visitor.one(model.body_count);
    visitor.one(model.part_count);
    visitor.one(model.contact_count);
    visitor.one(model.member_count);
    visitor.one(model.density);
    visitor.one(model.total_mass);
    visitor.one(model.measured_parts);
    visitor.one(model.has_slides);
    visitor.one(model.roots);
    visitor.one(model.stretch_count);
    visitor.some(model.member_begin, now.members, before.members);
    visitor.some(model.tree_begin, now.trees + 1, before.trees + 1);
    visit_lanes(model, kBodyNumbers, now.bodies, before.bodies, visitor);
    visit_lanes(model.motor, kMotorNumbers, now.bodies, before.bodies, visitor);
    visit_lanes(model, kPartNumbers, now.parts, before.parts, visitor);
    visitor.lanes(model.corner_x, 4 * now.parts, 4 * before.parts);
    visitor.lanes(model.corner_y, 4 * now.parts, 4 * before.parts);
    for (const auto field : kTreeNumbers)
        visitor.some(model.*field, now.trees, before.trees);
    visitor.some(model.motion, now.bodies, before.bodies);
    visitor.some(model.motor_mode, now.bodies, before.bodies);
    visitor.some(model.root_path, now.bodies, before.bodies);
    for (auto* indices : {&model.parent, &model.parent_slot, &model.by_depth, &model.stretch_slot})
        visitor.some(*indices, now.bodies, before.bodies);
    visitor.some(model.part_body, now.parts, before.parts);
    visitor.some(model.part_joint, now.parts, before.parts);
    for (TreeMembers& tree : model.members) {
        visitor.lanes(tree.share, now.bodies, before.bodies);
        visitor.lanes(tree.membership, now.bodies, before.bodies);
    }
    visit_dense(model.dense, counts, visitor);
}

template <class Moment, class Visitor>
void visit_moment(Moment& moment, const ChangedCounts& counts, Visitor& visitor) {
    // PackedBody::motion() reads these first.
    const NumberCounts& now = counts.now;
    const NumberCounts& before = counts.before;
    visitor.lanes(moment.motion.position, now.coordinates, before.coordinates);
    visitor.lanes(moment.motion.speed, now.coordinates, before.coordinates);
    visitor.lanes(moment.drive_end, now.bodies, before.bodies);

    visitor.lanes(moment.drive_start, now.bodies, before.bodies);
    visitor.lanes(moment.last_acceleration, now.coordinates, before.coordinates);
    visitor.one(moment.motion.work);
    visitor.one(moment.time);
    visitor.one(moment.status);
    visitor.one(moment.proposed_step);
    visitor.one(moment.has_last_acceleration);
    visitor.one(moment.evaluation_debt);
    visitor.one(moment.warm.count);
    visitor.some(moment.warm.id, moment.warm.count, 0);
    visitor.some(moment.warm.normal, moment.warm.count, 0);
    visitor.some(moment.warm.friction, moment.warm.count, 0);
    visitor.lanes(moment.warm.ground_friction, now.bodies, before.bodies);
    visitor.lanes(moment.warm.limit, now.bodies, before.bodies);
    visitor.some(moment.touched, now.parts, before.parts);
    for (const auto field : kForceNumbers)
        visitor.lanes(moment.forces.*field, now.measured, before.measured);
    visitor.one(moment.held_count);
    visitor.some(moment.held, moment.held_count, 0);
    visitor.one(moment.impact_count);
    visitor.some(moment.impacts, moment.impact_count, 0);
    visitor.one(moment.audit);
    visitor.one(moment.energy_reference);
    visitor.some(moment.spin, now.trees, before.trees);
    visitor.one(moment.known_spins);
}

template <class Visitor>
void visit_rest(SceneBody& body, const ChangedCounts& counts, Visitor& visitor) {
    visitor.one(body.motors_off);
    visitor.one(body.forcing.medium);
    MotorDrive& drive = body.forcing.drive;
    visitor.one(drive.frequency);
    visitor.one(drive.speed_limit);
    visitor.lanes(drive.start, counts.now.bodies, counts.before.bodies);
    visitor.lanes(drive.end, counts.now.bodies, counts.before.bodies);
    visit_rate(body.state.free_rate, counts, visitor);
    visitor.one(body.state.cache_is_current);
    visitor.one(body.state.energy);
    visit_cache(body.state.cache(), counts, visitor);
}

// Stores what `visit` visits, in exactly the memory it needs.
template <class Visit>
void store(PackedNumbers& numbers, const Visit& visit) {
    ByteCount measure;
    visit(measure);
    if (measure.bytes() > numbers.capacity()) numbers = PackedNumbers();
    numbers.resize(measure.bytes());
    Packing packing(numbers);
    visit(packing);
}

void store_moment(const SceneMoment& moment, const NumberCounts& same, PackedNumbers& numbers) {
    store(numbers, [&](auto& visitor) { visit_moment(moment, {same, same}, visitor); });
}

}  // namespace

void pack_moment(const SceneBody& body, PackedNumbers& moment) {
    store_moment(body.state, lanes_of(counts_of(body.model)), moment);
}

void unpack_moment(const PackedNumbers& moment, SceneBody& body) {
    const NumberCounts same = lanes_of(counts_of(body.model));
    Unpacking load(moment);
    visit_moment(body.state, {same, same}, load);
}

void PackedBody::pack(SceneBody& body) {
    counts_ = lanes_of(counts_of(body.model));
    bodies_ = body.model.body_count;
    coordinates_ = coordinate_count(body.model);
    const ChangedCounts counts{counts_, counts_};
    if (model_.empty())
        store(model_, [&](auto& visitor) { visit_model(body.model, counts, visitor); });
    store_moment(body.state, counts_, moment_);
    store(rest_, [&](auto& visitor) { visit_rest(body, counts, visitor); });
    law_ = body.law;
    swap_lists(body);
}

void PackedBody::unpack(SceneBody& body) {
    CAMBRIAN_ASSERT(!model_.empty(), "a body that was packed");
    const NumberCounts before = lanes_of(counts_of(body.model));
    const ChangedCounts counts{counts_, before};
    body.model.members.resize(static_cast<std::size_t>(counts_.trees));
    Unpacking model(model_);
    visit_model(body.model, counts, model);
    if (before.bodies > counts_.bodies) clear_slots(body.model, counts_.bodies);
    Unpacking moment(moment_);
    visit_moment(body.state, counts, moment);
    Unpacking rest(rest_);
    visit_rest(body, counts, rest);
    body.state.detection = 0;
    body.forcing.held = nullptr;
    body.law = law_;
    swap_lists(body);
}

SceneMotion PackedBody::motion() const {
    const std::byte* from = moment_.data();
    const auto read = [&](int count, int slots) {
        std::vector<double> numbers(static_cast<std::size_t>(count));
        std::memcpy(numbers.data(), from, numbers.size() * sizeof(double));
        from += static_cast<std::size_t>(slots) * sizeof(double);
        return numbers;
    };
    SceneMotion motion;
    motion.positions = read(coordinates_, counts_.coordinates);
    motion.speeds = read(coordinates_, counts_.coordinates);
    motion.targets = read(bodies_, counts_.bodies);
    return motion;
}

void PackedBody::swap_lists(SceneBody& body) {
    std::swap(body.model.colliding_pairs, colliding_pairs_);
    std::swap(body.forcing.pulls, pulls_);
}

}  // namespace cambrian
