#include "studio/help/tour.h"

#include <array>

namespace cambrian {
namespace {

// clang-format off
const std::array kSteps = {
    TourStep{"Evolve", "panel timeline", "Press Evolve",
             "Or the space bar. Creatures are judged in their world; the best of them have children.",
             [](const Deeds& before, const Deeds& now) {
                 return now.evolving || now.generations > before.generations;
             }},
    TourStep{"panel timeline", nullptr, "Watch a generation pass",
             "Each one adds its best and its median here, and its best creature takes the front.",
             [](const Deeds& before, const Deeds& now) {
                 const bool stopped = !now.evolving && now.generations > 0;
                 return stopped || now.generations > before.generations;
             }},
    TourStep{"environment.gravity", nullptr, "Change a law",
             "Drag the gravity. The creature in front feels it at once; its descendants have to "
             "live with it.",
             [](const Deeds& before, const Deeds& now) {
                 return !(now.environment == before.environment);
             }},
    TourStep{"panel viewport", nullptr, "Look inside: press L",
             "L shows the bones through a pale skin, then the boxes that physics moves, then life "
             "again.",
             [](const Deeds& before, const Deeds& now) { return now.look != before.look; }},
    TourStep{"Save it", nullptr, "Keep it: press Ctrl+S",
             "Save the creature in front to a file. With a name that ends in .png it becomes a "
             "card to share.",
             [](const Deeds& before, const Deeds& now) { return now.saves > before.saves; }},
};
// clang-format on

}  // namespace

std::span<const TourStep> tour_steps() {
    return kSteps;
}

}  // namespace cambrian
