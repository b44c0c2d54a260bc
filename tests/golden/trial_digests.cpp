#include "evolution/settings/goal_defaults.h"
#include "golden/audit.h"
#include "golden/founders.h"
#include "golden/golden.h"
#include "simulator/trial.h"
#include "support/kinds.h"

namespace cambrian::golden {
namespace {

constexpr int kTrials = 5;
constexpr double kDuration = 4.0;  // s

void add_record(Hash64& hash, const TrialRecord& record) {
    hash.add(record.digest);
    hash.add(static_cast<std::uint64_t>(record.outcome));
    for (const double number :
         {record.settle_time, record.body_length, record.mass, record.reversal_rate})
        hash.add(number);
    for (const MotionSample& sample : record.samples) {
        hash.add(sample.center_of_mass.x());
        hash.add(sample.center_of_mass.y());
        hash.add(sample.bounds.high.x());
        hash.add(sample.bounds.low.y());
    }
    add_audit(hash, record.audit);
}

// Runs founders that can move, from a different first number for each goal.
std::uint64_t digest_of_trials(const GoalKind& goal, const TrialWorld& world, const Kinds& kinds,
                               int first) {
    Hash64 hash;
    for (int number = first, done = 0; done < kTrials; ++number) {
        const auto grown = std::make_shared<const Phenotype>(
            express(founder(number, kinds.catalog), kinds, {}, world.scene));
        if (!grown->can_move() || !grown->has_live_control) continue;
        ++done;
        const auto record = run_trial(grown, kinds, world);
        if (!record) continue;
        add_record(hash, *record);
        hash.add(goal.score(*record).value);
    }
    return hash.value();
}

TrialWorld world_of(const GoalKind& goal, int first) {
    TrialWorld world;
    world.environment = goal.default_environment();
    world.trial.duration = kDuration;
    world.trial.has_cube = goal.default_trial.has_cube;
    if (goal.is_contest)
        world.opponents.genomes = {std::make_shared<const Genome>(founder(first + 500))};
    return world;
}

std::uint64_t digest_in_space(const char* goal_id, bool self_contact) {
    const EvolutionKinds& kinds = test::spatial_kinds();
    const GoalKind& goal = *kinds.goals.find(goal_id);
    ExperimentSettings settings;
    adopt_defaults(settings, goal);
    adopt_space(settings.world);
    settings.world.environment.self_contact = self_contact;
    settings.world.trial.duration = kDuration;
    return digest_of_trials(goal, settings.world, kinds.creature, 0);
}

// Adds what was heard and smelled in the last tick.
void add_surroundings(Hash64& hash, const TrialSurroundings& surroundings) {
    for (const Sound& sound : surroundings.sounds()) {
        hash.add_byte(static_cast<std::uint8_t>(sound.band));
        hash.add(sound.loudness);
        hash.add(sound.place.x());
    }
    if (const ScentField* field = surroundings.scent_field()) hash.add(field->total());
}

std::uint64_t digest_of_organs(Genome (*make)(int)) {
    TrialWorld world;
    world.trial.duration = kDuration;
    Hash64 hash;
    for (int number = 0, done = 0; done < kTrials; ++number) {
        const auto grown = std::make_shared<const Phenotype>(
            express(make(number), test::kinds().creature, {}, world.scene));
        if (!grown->has_live_control || grown->organs.empty()) continue;
        ++done;
        auto trial = Trial::start(grown, test::kinds().creature, world);
        if (!trial) continue;
        while ((*trial)->tick())
            add_surroundings(hash, (*trial)->surroundings());
        add_record(hash, (*trial)->record());
    }
    return hash.value();
}

}  // namespace

void add_trial_digests(Digests& digests) {
    int first = 1000;
    for (const GoalKind& goal : test::kinds().goals.all()) {
        digests.push_back({"trial." + goal.id, digest_of_trials(goal, world_of(goal, first),
                                                                test::creature_kinds(), first)});
        first += 1000;
    }
    digests.push_back({"trial.organs", digest_of_organs(founder_with_organs)});
    digests.push_back({"trial.deformers", digest_of_organs(founder_with_deformers)});
    digests.push_back({"space.trial.swimming", digest_in_space("swimming", false)});
    for (const char* goal : {"swimming", "walking"})
        digests.push_back(
            {std::string("space.trial.") + goal + ".self_contact", digest_in_space(goal, true)});
}

}  // namespace cambrian::golden
