#include "app/preserve/preserve_report.h"

#include "core/text/number_text.h"
#include "persist/json/json_text.h"
#include "persist/text/digest_text.h"
#include "persist/text/quoted_text.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

std::string time_words(std::uint64_t tick) {
    const std::uint64_t seconds = tick / 60;
    return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::string count_words(std::uint64_t count, const char* one, const char* several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
}

}  // namespace

std::string preserve_words(const SeriesRow& row, double factor) {
    const double all = row.light + row.plants + row.flesh + row.stores + row.bodies;
    const auto percent = [all](double energy) { return all > 0.0 ? 100.0 * energy / all : 0.0; };
    return fmt::format(
        "{}  {} · {} · {:.1f} × real time · energy: light {:.0f} % plants {:.0f} % flesh {:.0f} % "
        "stores {:.0f} % bodies {:.0f} %",
        time_words(row.tick), count_words(row.population, "creature", "creatures"),
        count_words(row.lineages, "lineage", "lineages"), factor, percent(row.light),
        percent(row.plants), percent(row.flesh), percent(row.stores), percent(row.bodies));
}

std::string preserve_json(const SeriesRow& row, double factor, std::uint64_t digest) {
    return json_object(
        {{"time", real_text(static_cast<double>(row.tick) / 60.0)},
         {"tick", std::to_string(row.tick)},
         {"population", std::to_string(row.population)},
         {"lineages", std::to_string(row.lineages)},
         {"births", std::to_string(row.births)},
         {"restocked", std::to_string(row.restocked)},
         {"stillborn", std::to_string(row.stillborn)},
         {"deaths", json_object({{"hunger", std::to_string(row.hunger)},
                                 {"eaten", std::to_string(row.eaten)},
                                 {"broken physics", std::to_string(row.broken_physics)}})},
         {"energy", json_object({{"light", real_text(row.light)},
                                 {"plants", real_text(row.plants)},
                                 {"flesh", real_text(row.flesh)},
                                 {"stores", real_text(row.stores)},
                                 {"bodies", real_text(row.bodies)}})},
         {"mass", real_text(row.mass)},
         {"parts", real_text(row.parts)},
         {"speed", real_text(row.speed)},
         {"diet", real_text(row.diet)},
         {"age", real_text(row.age)},
         {"real_time_factor", real_text(factor)},
         {"digest", quoted_text(digest_text(digest))}});
}

}  // namespace cambrian
