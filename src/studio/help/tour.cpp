#include "studio/help/tour.h"

#include <array>

namespace cambrian {
namespace {

constexpr std::array kSteps = {
    TourStep{"Evolve", "Evolve",
             "This button, or Space, breeds creatures, tries them in their world and selects the "
             "best. Press it again to pause."},
    TourStep{"panel experiment", "Experiment",
             "All rules are here and can be changed while creatures evolve. Drag the gravity and "
             "the creature on display feels it at once."},
    TourStep{
        "panel viewport", "Viewport",
        "The creature on display moves exactly as when it was scored. Take hold of it with the "
        "mouse, drag with the right button to look around, scroll to come closer."},
    TourStep{"panel timeline", "Timeline",
             "Each generation adds its best, median and spread. Click to watch the champion of "
             "any past generation."},
    TourStep{"panel inspector", "Inspector",
             "The body, brain and genes of the creature on display, live. Save what you like with "
             "Ctrl+S; F1 tells the rest."},
};

}  // namespace

std::span<const TourStep> tour_steps() {
    return kSteps;
}

}  // namespace cambrian
