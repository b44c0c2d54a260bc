#pragma once

#include "core/threads/thread_priority.h"
#include "evolution/evaluation/evaluation_backend.h"

#include <cstddef>
#include <memory>

namespace cambrian {

// Evaluates on this machine, one trial a worker at a time, with this priority; so does the thread
// that asks for it. kinds must outlive it.
std::unique_ptr<EvaluationBackend> make_thread_pool_backend(
    const EvolutionKinds& kinds, std::size_t workers,
    ThreadPriority priority = ThreadPriority::kNormal);

}  // namespace cambrian
