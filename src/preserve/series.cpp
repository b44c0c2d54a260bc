#include "preserve/series.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace cambrian {
namespace {

// Sets the mean and the standard deviation of a number of each resident.
template <class Number>
void summarize(const Residents& residents, Number number, double& mean, double& spread) {
    if (residents.empty()) return;
    const auto count = static_cast<double>(residents.size());
    double sum = 0.0;
    for (const auto& each : residents)
        sum += number(*each);
    mean = sum / count;
    double squares = 0.0;
    for (const auto& each : residents)
        squares += (number(*each) - mean) * (number(*each) - mean);
    spread = std::sqrt(squares / count);
}

}  // namespace

SeriesRow series_row(std::uint64_t tick, const Residents& residents, Energy ambient,
                     const Food& plants, const Food& flesh, const Tally& tally) {
    SeriesRow row{tally};
    row.tick = tick;
    row.population = residents.size();
    Energy stores = 0;
    Energy bodies = 0;
    std::set<std::uint64_t> lineages;
    for (const auto& each : residents) {
        stores += each->store;
        bodies += each->body;
        lineages.insert(each->life.lineage);
    }
    row.lineages = lineages.size();
    row.light = joules(ambient);
    row.plants = joules(plants.energy());
    row.flesh = joules(flesh.energy());
    row.stores = joules(stores);
    row.bodies = joules(bodies);
    const auto mass = [](const Resident& each) { return each.life.mass; };
    const auto parts = [](const Resident& each) { return static_cast<double>(each.life.parts); };
    const auto speed = [](const Resident& each) { return each.velocity().norm(); };
    const auto diet = [](const Resident& each) { return each.life.diet; };
    summarize(residents, mass, row.mass, row.mass_spread);
    summarize(residents, parts, row.parts, row.parts_spread);
    summarize(residents, speed, row.speed, row.speed_spread);
    summarize(residents, diet, row.diet, row.diet_spread);
    double age_spread = 0.0;
    summarize(
        residents, [&](const Resident& each) { return each.age(tick); }, row.age, age_spread);
    return row;
}

}  // namespace cambrian
