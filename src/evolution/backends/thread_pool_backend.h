#pragma once

#include "core/threads/thread_priority.h"
#include "evolution/evaluation/evaluation_backend.h"

#include <cstddef>
#include <memory>

namespace cambrian {

// Makes a back-end that evaluates on this machine, one trial at a time per worker thread, with this
// priority. The thread that calls evaluate() evaluates too. `kinds` must outlive the back-end.
std::unique_ptr<EvaluationBackend> make_thread_pool_backend(
    const EvolutionKinds& kinds, std::size_t workers,
    ThreadPriority priority = ThreadPriority::kNormal);

}  // namespace cambrian
