#include "preserve/life/resident.h"

#include "creature/overlap.h"
#include "preserve/world/fastest_point.h"
#include "preserve/world/rectangle.h"
#include "preserve/world/walls.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cambrian {

Result<std::unique_ptr<PhysicsScene>> scene_of(const Phenotype& body, const Kinds& kinds,
                                               const ExperimentSettings& settings) {
    if (settings.expression.strict_overlap && overlaps_itself(body.plan))
        return Error{"parts overlap that no joint connects"};
    return kinds.scene.make(body.plan, world_environment(settings), settings.world.scene);
}

Result<std::unique_ptr<Resident>> Resident::grow(Life begun, const Kinds& kinds,
                                                 const ExperimentSettings& settings,
                                                 const CommonSenses& senses) {
    const Phenotype grown =
        express(*begun.genome, kinds, settings.expression, settings.world.scene);
    auto phenotype = std::make_unique<const Phenotype>(grown);  // a copy has no spare capacity
    auto scene = scene_of(*phenotype, kinds, settings);
    if (!scene) return scene.error();
    return std::unique_ptr<Resident>(new Resident(std::move(begun), std::move(phenotype), kinds,
                                                  settings, senses, std::move(*scene)));
}

Resident::Resident(Life begun, std::unique_ptr<const Phenotype> phenotype, const Kinds& kinds,
                   const ExperimentSettings& settings, const CommonSenses& senses,
                   std::unique_ptr<PhysicsScene> scene)
    : life(std::move(begun)),
      settings_(&settings),
      phenotype_(std::move(phenotype)),
      scene_(std::move(scene)),
      senses_(senses, life.number),
      creature_(std::make_unique<Creature>(*phenotype_, kinds, settings.world.scene)),
      mouths_(mouths_of(*phenotype_, kinds.organs)),
      rectangles_(phenotype_->parts.size()) {
    life.mass = scene_->mass();
    life.parts = static_cast<std::uint32_t>(phenotype_->parts.size());
    life.neurons = static_cast<std::uint32_t>(phenotype_->network.order.size());
    double diets = 0.0;
    for (const Mouth& mouth : mouths_)
        diets += mouth.diet;
    life.diet = diets / static_cast<double>(mouths_.size());
    place(Vec3::Zero(), Vec3::Zero());
    for (const Rectangle& part : rectangles_) {
        for (const Vec3& corner : corners_of(part))
            radius_ = std::max(radius_, corner.norm());
    }
}

void Resident::find_places() {
    for (std::size_t i = 0; i < rectangles_.size(); ++i)
        rectangles_[i] = rectangle_of(*scene_, i, scene_->part_half_extents(i));
    bounds_ = scene_->bounds();
    center_ = scene_->center_of_mass();
    velocity_ = scene_->center_of_mass_velocity();
    if (is_solid(settings_->preserve)) fastest_ = fastest_point(*scene_);
}

Vec3 Resident::standing_at(double x, const WorldArea& area) const {
    if (!area.ground) return {x, center_.y() - bounds_.low.y() + kStartClearance, 0.0};
    const Vec3 aside(x - center_.x(), 0.0, 0.0);
    double sunk = -std::numeric_limits<double>::infinity();
    for (const Rectangle& part : rectangles_)
        sunk = std::max(sunk, depth_below(*area.ground, moved(part, aside)));
    return {x, center_.y() + sunk + kStartClearance, 0.0};
}

void Resident::place(const Vec3& center, const Vec3& velocity) {
    scene_->translate(center - scene_->center_of_mass());
    SceneMotion motion = scene_->motion();
    const std::size_t count = motion.speeds.size();
    motion.speeds[count - 2] = velocity.x();
    motion.speeds[count - 1] = velocity.y();
    broken_ = !scene_->begin_at(motion);
    find_places();
}

void Resident::surround_by(std::vector<FixedBox> boxes) {
    boxes_ = std::move(boxes);
    scene_->set_fixed_boxes(boxes_);
}

void Resident::live(std::unique_ptr<SceneWorkspace>& workspace, const WorldArea& area) {
    scene_->give_workspace(std::move(workspace));
    act(area);
    end_tick(scene_->advance(kBrainTick));
    workspace = scene_->take_workspace();
}

void Resident::act(const WorldArea& area) {
    bitten = false;
    work_before_ = scene_->audit().gross_motor_work;
    creature_->act(*scene_, senses_, kBrainTick);
    push_back(*scene_, *phenotype_, rectangles_, area, settings_->world.environment.density);
}

void Resident::end_tick(SceneStatus status) {
    const SceneAudit& audit = scene_->audit();
    const TrialSettings& guards = settings_->world.trial;
    broken_ = status != SceneStatus::kRunning || audit.max_part_speed > guards.max_part_speed ||
              audit.max_part_spin > guards.max_part_spin;
    work_ = broken_ ? 0.0 : std::max(audit.gross_motor_work - work_before_, 0.0);
    if (broken_) return;
    find_places();
    if (settings_->preserve.ramming > 0.0) scene_->list_impacts(impacts_);
}

double Resident::age(std::uint64_t tick) const {
    return static_cast<double>(tick - life.born) * kBrainTick;
}

ResidentState Resident::save() const {
    const Creature::State mind = creature_->save();
    const auto values = mind.brain.values();
    const auto memory = mind.brain.memory();
    return {.life = life,
            .store = store,
            .body = body,
            .last_birth = last_birth,
            .motion = scene_->motion(),
            .brain_values = {values.begin(), values.end()},
            .brain_memory = {memory.begin(), memory.end()},
            .sensor_memory = mind.sensor_memory,
            .effector_memory = mind.effector_memory};
}

bool Resident::restore(const ResidentState& state) {
    Creature::State mind = creature_->save();
    if (state.sensor_memory.size() != mind.sensor_memory.size() ||
        state.effector_memory.size() != mind.effector_memory.size() ||
        !mind.brain.go_on_from(state.brain_values, state.brain_memory) ||
        !scene_->begin_at(state.motion))
        return false;
    mind.sensor_memory = state.sensor_memory;
    mind.effector_memory = state.effector_memory;
    creature_->restore(mind);
    const Life grown = std::exchange(life, state.life);
    life.mass = grown.mass;
    life.parts = grown.parts;
    life.neurons = grown.neurons;
    life.diet = grown.diet;
    store = state.store;
    body = state.body;
    last_birth = state.last_birth;
    find_places();
    return true;
}

}  // namespace cambrian
