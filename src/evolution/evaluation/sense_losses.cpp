#include "evolution/evaluation/sense_losses.h"

#include "evolution/evaluation/trials.h"
#include "simulator/trial.h"

#include <algorithm>
#include <array>

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
    std::array<double, 6> of_pass() const {
        return {0.0, least, at(0.25), at(0.5), at(0.75), greatest};
    }
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

class Search {
public:
    Search(const GenomePtr& genome, const ExperimentSettings& settings, const EvolutionKinds& kinds,
           const std::stop_token& stop)
        : genome_(genome), settings_(settings), kinds_(kinds), stop_(stop) {}

    double score(const Held& held) const {
        return held_out_score(genome_, settings_, kinds_, stop_, held);
    }
    // Takes over the constant of a sensor that leaves most; returns the score.
    double improve(Held& held, std::size_t sensor, double best,
                   const std::array<double, 6>& constants) const {
        Held tried = held;
        for (const double constant : constants) {
            tried[sensor] = constant;
            const double left = score(tried);
            if (left > best || !held[sensor]) {
                best = left;
                held[sensor] = constant;
            }
        }
        return best;
    }

private:
    const GenomePtr& genome_;
    const ExperimentSettings& settings_;
    const EvolutionKinds& kinds_;
    const std::stop_token& stop_;
};

}  // namespace

SenseLosses sense_losses(const GenomePtr& genome, const ExperimentSettings& settings,
                         const EvolutionKinds& kinds, const std::stop_token& stop) {
    const auto body = std::make_shared<const Phenotype>(
        express(*genome, kinds.creature, settings.expression, settings.world.scene));
    const std::size_t sensors = body->sensors.size();
    std::vector<Readings> readings(sensors);
    for (int trial = 0; trial < 2; ++trial) {
        TrialWorld world = first_trial_world(settings);
        world.light.trial = trial;
        note_readings(readings, body, kinds, world, stop);
    }
    const Search search(genome, settings, kinds, stop);
    SenseLosses losses;
    losses.intact = search.score({});
    losses.without_all = losses.intact;
    if (sensors == 0) return losses;
    Held all;
    for (std::size_t set = 0; set < readings.front().of_sets().size(); ++set) {
        Held held;
        for (const Readings& each : readings)
            held.emplace_back(each.of_sets()[set]);
        const double left = search.score(held);
        if (!all.empty() && left <= losses.without_all) continue;
        losses.without_all = left;
        all = std::move(held);
    }
    for (std::size_t i = 0; i < sensors && !stop.stop_requested(); ++i) {
        losses.without_all = search.improve(all, i, losses.without_all, readings[i].of_pass());
        Held alone(sensors);
        const double left = search.improve(alone, i, 0.0, readings[i].of_pass());
        const WiredSensor& wired = body->sensors[i];
        losses.each.push_back({kinds.creature.sensors[wired.kind].channels[wired.channel].id,
                               wired.part, *alone[i], left});
    }
    return losses;
}

}  // namespace cambrian
