#pragma once

// The services that every controller of the studio uses.

#include "evolution/kinds/evolution_kinds.h"
#include "studio/background/background_worker.h"
#include "studio/background/feedback.h"

#include <filesystem>
#include <functional>

namespace cambrian {

struct Services {
    const EvolutionKinds& kinds;  // of the world that the studio is in
    BackgroundWorker& worker;
    Feedback& feedback;
    // Those of the world with other dimensions; null where there is none, as in tests.
    const EvolutionKinds* elsewhere = nullptr;

    int dimensions() const { return kinds.creature.scene.dimensions; }
    // Returns the kinds of a world with so many dimensions or, where there is none, those at hand.
    const EvolutionKinds& kinds_in(int wanted) const {
        return elsewhere != nullptr && wanted != dimensions() ? *elsewhere : kinds;
    }
};

// The services of one studio, with the log of events at that path.
struct OwnServices {
    // All kinds must outlive them.
    OwnServices(const EvolutionKinds& kinds, const EvolutionKinds* elsewhere,
                const std::filesystem::path& status_log)
        : feedback(status_log), shared{kinds, worker, feedback, elsewhere} {}
    OwnServices(const OwnServices&) = delete;
    OwnServices& operator=(const OwnServices&) = delete;

    Feedback feedback;
    BackgroundWorker worker;
    const Services shared;
};

// Runs `write` on the worker's thread and shows a notice if it fails.
void write_in_background(const Services& services, std::function<Status()> write);

}  // namespace cambrian
