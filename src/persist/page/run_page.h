#pragma once

#include "persist/page/page_file.h"
#include "simulator/trial_watch.h"

#include <filesystem>

namespace cambrian {

inline constexpr std::size_t kPageChampions = 12;  // most on a page of a run

// Returns what a page of an experiment shows: champions spread over its generations, the last one
// first, and the course of the run. Computes what their scores lack, notes how many champions are
// done, and fails if it is stopped.
Result<PageContent> content_of_run(const std::filesystem::path& run, const EvolutionKinds& kinds,
                                   const TrialWatch& watch = {});

// Returns what a page of one creature shows.
PageContent content_of_creature(CreatureDocument document, const std::string& title);

}  // namespace cambrian
