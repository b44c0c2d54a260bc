#pragma once

// What follows if the results of several workers differ from this machine's.

#include "cluster/coordinator/worker_roster.h"

#include <cstdint>
#include <span>
#include <string>

namespace cambrian {

struct Disagreement {
    std::string failure;    // ends the run; empty if it goes on
    std::string complaint;  // empty if there is none
};

// `workers` are those that were refused since a result differed. One login may invent any number of
// workers, so theirs alone end no run.
Disagreement judge_disagreement(std::span<const std::uint64_t> workers, const WorkerRoster& roster);

}  // namespace cambrian
