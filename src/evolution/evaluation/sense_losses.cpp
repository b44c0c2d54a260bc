#include "evolution/evaluation/sense_losses.h"

#include "evolution/evaluation/trials.h"
#include "simulator/trial.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace cambrian {
namespace {

using Held = std::vector<std::optional<double>>;

// The readings of one sensor over a trial.
struct Readings {
    double least = 0.0, greatest = 0.0, sum = 0.0;
    int count = 0;

    void note(double reading) {
        least = count == 0 ? reading : std::min(least, reading);
        greatest = count == 0 ? reading : std::max(greatest, reading);
        sum += reading;
        ++count;
    }
    double at(double share) const { return least + share * (greatest - least); }
    // The constants of a set for all sensors, and of a pass over one.
    std::array<double, 5> of_sets() const {
        return {0.0, least, greatest, count > 0 ? sum / count : 0.0, at(0.5)};
    }
    SenseConstants of_pass() const { return {0.0, least, at(0.25), at(0.5), at(0.75), greatest}; }
};

// Adds the readings of a trial, which is run for them.
void note_readings(std::vector<Readings>& readings, const std::shared_ptr<const Phenotype>& body,
                   const EvolutionKinds& kinds, const TrialWorld& world,
                   const std::stop_token& stop) {
    const auto trial = Trial::start(body, kinds.creature, world);
    if (!trial) return;
    while ((*trial)->tick() && !stop.stop_requested()) {
        if ((*trial)->settling()) continue;
        for (std::size_t i = 0; i < readings.size(); ++i)
            readings[i].note(
                (*trial)->creature().reading(i, (*trial)->scene(), (*trial)->surroundings()));
    }
}

// Scores the creature with constants instead of readings.
class Search {
public:
    Search(const GenomePtr& genome, const ExperimentSettings& settings, const EvolutionKinds& kinds,
           const std::stop_token& stop, std::function<void(int)> note = {})
        : genome_(genome),
          settings_(settings),
          kinds_(kinds),
          stop_(stop),
          note_(std::move(note)) {}

    double score(const Held& held) {
        if (note_) note_(scores_);
        ++scores_;
        std::vector<Lesion> lesions;
        for (std::uint32_t i = 0; i < held.size(); ++i)
            if (held[i]) lesions.push_back({LesionKind::kHeldSensor, i, 0, *held[i]});
        return held_out_score(genome_, settings_, kinds_, stop_, std::move(lesions));
    }
    // Takes over the constant of a sensor that leaves most; returns the score.
    double improve(Held& held, std::size_t sensor, double best, const SenseConstants& constants) {
        Held tried = held;
        for (const double constant : constants) {
            if (stopped()) break;
            tried[sensor] = constant;
            const double left = score(tried);
            if (left > best || !held[sensor]) {
                best = left;
                held[sensor] = constant;
            }
        }
        return best;
    }
    // Returns the most that is left with a constant for each sensor; looks no further once that is
    // more than `enough`.
    double hold_all(const std::vector<Readings>& readings, double enough) {
        Held all;
        double most = 0.0;
        for (std::size_t set = 0; set < readings.front().of_sets().size() && !stopped(); ++set) {
            Held held;
            for (const Readings& each : readings)
                held.emplace_back(each.of_sets()[set]);
            const double left = score(held);
            if (!all.empty() && left <= most) continue;
            most = left;
            all = std::move(held);
            if (most > enough) return most;
        }
        for (std::size_t i = 0; i < readings.size() && !(most > enough) && !stopped(); ++i)
            most = improve(all, i, most, readings[i].of_pass());
        return most;
    }
    bool stopped() const { return stop_.stop_requested(); }

private:
    const GenomePtr& genome_;
    const ExperimentSettings& settings_;
    const EvolutionKinds& kinds_;
    const std::stop_token& stop_;
    std::function<void(int)> note_;
    int scores_ = 0;
};

// Returns the readings of all sensors in two trials, which have the two sides of what has sides.
std::vector<Readings> readings_of(const std::shared_ptr<const Phenotype>& body,
                                  const ExperimentSettings& settings, const EvolutionKinds& kinds,
                                  const std::stop_token& stop) {
    std::vector<Readings> readings(body->sensors.size());
    for (int trial = 0; trial < 2; ++trial) {
        TrialWorld world = first_trial_world(settings);
        world.light.trial = trial;
        note_readings(readings, body, kinds, world, stop);
    }
    return readings;
}

}  // namespace

std::vector<SenseConstants> sense_constants(const std::shared_ptr<const Phenotype>& body,
                                            const ExperimentSettings& settings,
                                            const EvolutionKinds& kinds,
                                            const std::stop_token& stop) {
    std::vector<SenseConstants> constants;
    for (const Readings& each : readings_of(body, settings, kinds, stop))
        constants.push_back(each.of_pass());
    return constants;
}

SenseLosses sense_losses(const GenomePtr& genome, const ExperimentSettings& settings,
                         const EvolutionKinds& kinds, const std::stop_token& stop,
                         const std::function<void(double)>& note) {
    const auto body = grow(*genome, settings, kinds);
    const std::size_t sensors = body->sensors.size();
    const double all = 1.0 + 5.0 + 12.0 * static_cast<double>(sensors);  // scores
    const std::function<void(int)> count = [&](int scores) {
        if (note) note(scores / all);
    };
    const std::vector<Readings> readings = readings_of(body, settings, kinds, stop);
    Search search(genome, settings, kinds, stop, count);
    SenseLosses losses;
    losses.intact = search.score({});
    losses.without_all = losses.intact;
    if (sensors == 0) return losses;
    losses.without_all = search.hold_all(readings, std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < sensors && !stop.stop_requested(); ++i) {
        Held alone(sensors);
        const double left = search.improve(alone, i, 0.0, readings[i].of_pass());
        if (!alone[i]) break;
        const WiredSensor& wired = body->sensors[i];
        losses.each.push_back({kinds.creature.sensors[wired.kind].channels[wired.channel].id,
                               wired.part, *alone[i], left});
    }
    return losses;
}

bool needs_senses(const GenomePtr& genome, const ExperimentSettings& settings,
                  const EvolutionKinds& kinds, const std::stop_token& stop) {
    const auto body = grow(*genome, settings, kinds);
    if (body->sensors.empty()) return false;
    Search search(genome, settings, kinds, stop);
    const double enough = kNeededShare * search.score({});
    return enough > 0.0 &&
           search.hold_all(readings_of(body, settings, kinds, stop), enough) <= enough;
}

}  // namespace cambrian
