#pragma once

// The services that every controller of the studio uses.

#include "evolution/kinds/evolution_kinds.h"
#include "studio/background/background_worker.h"
#include "studio/background/feedback.h"

#include <filesystem>
#include <functional>

namespace cambrian {

struct Services {
    const EvolutionKinds& kinds;
    BackgroundWorker& worker;
    Feedback& feedback;
};

// The services of one studio, with the log of events at that path.
struct OwnServices {
    // `kinds` must outlive them.
    OwnServices(const EvolutionKinds& kinds, const std::filesystem::path& status_log)
        : feedback(status_log), shared{kinds, worker, feedback} {}
    OwnServices(const OwnServices&) = delete;
    OwnServices& operator=(const OwnServices&) = delete;

    Feedback feedback;
    BackgroundWorker worker;
    const Services shared;
};

// Runs `write` on the worker's thread and shows a notice if it fails.
void write_in_background(const Services& services, std::function<Status()> write);

}  // namespace cambrian
