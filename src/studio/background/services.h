#pragma once

// What every controller of the studio uses.

#include "evolution/evolution_kinds.h"
#include "studio/background/background_worker.h"
#include "studio/background/feedback.h"

namespace cambrian {

struct Services {
    const EvolutionKinds& kinds;
    BackgroundWorker& worker;
    Feedback& feedback;
};

}  // namespace cambrian
