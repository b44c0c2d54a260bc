#include "studio/preserve/world_words.h"

#include "core/text/counted.h"
#include "genome/creature_name.h"
#include "preserve/world_time.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace cambrian {

std::string world_words(const PreservePicture& picture) {
    const SeriesRow& now = picture.now;
    const double all = now.light + now.plants + now.flesh + now.stores + now.bodies;
    const auto percent = [all](double energy) { return all > 0.0 ? 100.0 * energy / all : 0.0; };
    const std::string pace =
        picture.playing ? fmt::format("{:.1f} × real time", picture.factor) : "paused";
    return fmt::format(
        "{} · {} · {} · energy: light {:.0f} % plants {:.0f} % flesh {:.0f} % stores {:.0f} % "
        "bodies {:.0f} %",
        counted(now.population, "creature"), counted(now.lineages, "lineage"), pace,
        percent(now.light), percent(now.plants), percent(now.flesh), percent(now.stores),
        percent(now.bodies));
}

std::string fate_words(const Life& life) {
    const std::string when = world_time(life.died);
    switch (life.cause) {
        case DeathCause::kAlive:
            break;
        case DeathCause::kHunger:
            return "died of hunger at " + when;
        case DeathCause::kEaten:
            return "was eaten at " + when;
        case DeathCause::kBrokenPhysics:
            return "died as its motion failed at " + when;
        case DeathCause::kRemoved:
            return "was removed at " + when;
    }
    return "alive";
}

std::string reason_words(const MuseumPiece& piece) {
    if (piece.reason == museum_reason::kLineage)
        return fmt::format("founded a lineage of {}", piece.count);
    if (piece.reason == museum_reason::kChildren)
        return fmt::format("had the most children: {}", piece.count);
    return piece.reason;
}

std::string called(const PreservePicture& picture, std::uint64_t number) {
    GenomePtr genome;
    const auto look_at = [&](const auto& each) {
        if (each.number == number) genome = each.genome;
    };
    if (const ResidentPicture* living = picture.find(number)) look_at(living->life);
    if (picture.museum != nullptr)
        std::for_each(picture.museum->begin(), picture.museum->end(), look_at);
    if (picture.died != nullptr) std::for_each(picture.died->begin(), picture.died->end(), look_at);
    return fmt::format("{} {}", genome ? creature_name(*genome) : "creature", number);
}

std::vector<LineageCount> lineages_in(const PreservePicture& picture) {
    std::map<std::uint64_t, LineageCount> counts;
    for (const ResidentPicture& each : picture.residents) {
        LineageCount& count = counts[each.life.lineage];
        if (count.members++ == 0) {
            count.number = each.life.lineage;
            count.eldest = each.life.number;
            count.phenotype = each.phenotype;
        }
    }
    std::vector<LineageCount> sorted;
    for (auto& [number, count] : counts)
        sorted.push_back(std::move(count));
    std::stable_sort(
        sorted.begin(), sorted.end(),
        [](const LineageCount& a, const LineageCount& b) { return a.members > b.members; });
    return sorted;
}

}  // namespace cambrian
