#include "evolution/evaluation/early_termination.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

// Shares of the trial after which the score is estimated.
constexpr std::array<double, 6> kMoments = {0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
constexpr double kLeastTime = 4.5;  // s, before which a slow gait may not have shown its best speed
constexpr double kAhead = 0.5;      // s; a part that lags by half a stride may catch up at any time
constexpr double kSpeedUp = 1.5;
constexpr double kSamplePeriod = kTicksPerSample * kBrainTick;  // s
constexpr std::size_t kSecond = 10;                             // samples

// Returns the highest mean speed of the centre of mass over any second, in m/s. A trial shorter
// than a second counts as one.
double best_speed(const TrialRecord& record) {
    const auto& samples = record.samples;
    const std::size_t span = std::min(kSecond, samples.size() - 1);
    if (span == 0) return 0.0;
    double best = 0.0;
    for (std::size_t i = span; i < samples.size(); ++i) {
        const double moved = (samples[i].center_of_mass - samples[i - span].center_of_mass).norm();
        best = std::max(best, moved / (static_cast<double>(span) * kSamplePeriod));
    }
    return best;
}

// Returns the record that the trial would have if the creature continued with the given velocity
// from where it would be in half a second.
TrialRecord ran_on(TrialRecord record, const Vec3& velocity) {
    const MotionSample last = record.samples.back();
    for (double time = kBrainTick; time < record.duration - last.time; time += kBrainTick) {
        const Vec3 center = last.center_of_mass + time * velocity;
        record.jumps.watch(last.bounds.low.y() + time * velocity.y(), center.dot(record.up));
    }
    Vec3 before = Vec3::Zero();
    while (record.samples.back().time < record.duration) {
        MotionSample next = last;
        next.time = std::min(record.samples.back().time + kSamplePeriod, record.duration);
        const Vec3 moved = (next.time - last.time + kAhead) * velocity;
        next.center_of_mass += moved;
        next.bounds.low += moved;
        next.bounds.high += moved;
        record.samples.push_back(next);
        record.repeat_supports(moved - before);
        before = moved;
    }
    return record;
}

// Returns the directions for the rest of the trial: that of the motion so far, right, left, up, and
// none. Creatures in space may go on along any heading as well.
std::array<Vec3, 5> promising_directions(const TrialRecord& record) {
    const Vec3 way = record.samples.back().center_of_mass - record.samples.front().center_of_mass;
    const double length = way.norm();
    const Vec3 on = length > 0.0 ? Vec3(way / length) : Vec3::Zero();
    return {on, Vec3(1.0, 0.0, 0.0), Vec3(-1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3::Zero()};
}

}  // namespace

bool may_exceed(double threshold, const TrialRecord& so_far, const GoalKind& goal) {
    const double speed = kSpeedUp * best_speed(so_far);
    const auto directions = promising_directions(so_far);
    const auto succeeds = [&](const Vec3& direction) {
        return goal.score(ran_on(so_far, speed * direction)).value > threshold;
    };
    if (std::any_of(directions.begin(), directions.end(), succeeds)) return true;
    return so_far.dimensions == 3 && std::any_of(headings().begin(), headings().end(), succeeds);
}

Result<TerminableTrial> run_terminable_trial(std::shared_ptr<const Phenotype> phenotype,
                                             const Kinds& kinds, const TrialWorld& world,
                                             const TrialEnds& ends) {
    auto trial = Trial::start(std::move(phenotype), kinds, world);
    if (!trial) return trial.error();
    TerminableTrial result;
    std::size_t estimates = ends.threshold ? 0 : kMoments.size();
    while ((*trial)->tick()) {
        (*trial)->poll_cancel(ends.stop);
        const double time = (*trial)->time();
        if (estimates == kMoments.size() || result.terminable ||
            time < kMoments[estimates] * world.trial.duration)
            continue;
        ++estimates;
        if (time < kLeastTime) continue;
        result.terminable = !may_exceed(ends.threshold->score, (*trial)->record(), ends.goal);
        if (!result.terminable || ends.threshold->audited) continue;
        (*trial)->stop_early(Outcome::kStoppedEarly, "could not survive any more");
        break;
    }
    result.record = (*trial)->take_record();
    return result;
}

}  // namespace cambrian
