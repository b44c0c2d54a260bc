#include "studio/preserve/notables.h"

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

struct Measure {
    const char* label;
    double (*number)(const ResidentPicture& each, std::uint64_t tick);
    const char* unit;
};
constexpr std::array kMeasures = {
    Measure{"Eldest",
            [](const ResidentPicture& each, std::uint64_t tick) { return age_of(each.life, tick); },
            "s"},
    Measure{"Most children",
            [](const ResidentPicture& each, std::uint64_t) {
                return static_cast<double>(each.life.children);
            },
            ""},
    Measure{"Heaviest", [](const ResidentPicture& each, std::uint64_t) { return each.life.mass; },
            "kg"},
    Measure{
        "Best grazer",
        [](const ResidentPicture& each, std::uint64_t) { return joules(each.life.eaten_plants); },
        "J"},
    Measure{"Best hunter",
            [](const ResidentPicture& each, std::uint64_t) { return joules(each.life.bitten); },
            "J"},
};

}  // namespace

std::vector<Notable> notables_in(const PreservePicture& picture) {
    std::vector<Notable> notables;
    for (const Measure& measure : kMeasures) {
        const auto most = std::max_element(picture.residents.begin(), picture.residents.end(),
                                           [&](const ResidentPicture& a, const ResidentPicture& b) {
                                               return measure.number(a, picture.tick) <
                                                      measure.number(b, picture.tick);
                                           });
        if (most == picture.residents.end()) break;
        const double number = measure.number(*most, picture.tick);
        if (number > 0.0)
            notables.push_back({measure.label, most->life.number, number, measure.unit});
    }
    return notables;
}

double age_of(const Life& life, std::uint64_t tick) {
    const std::uint64_t until = life.died != 0 ? life.died : tick;
    return static_cast<double>(until - life.born) / 60.0;
}

}  // namespace cambrian
