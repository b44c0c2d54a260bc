#pragma once

// The services that every controller of the studio uses.

#include "evolution/kinds/evolution_kinds.h"
#include "studio/background/background_worker.h"
#include "studio/background/feedback.h"

#include <functional>

namespace cambrian {

struct Services {
    const EvolutionKinds& kinds;
    BackgroundWorker& worker;
    Feedback& feedback;
};

// Runs `write` on the worker's thread and shows a notice if it fails.
void write_in_background(const Services& services, std::function<Status()> write);

}  // namespace cambrian
