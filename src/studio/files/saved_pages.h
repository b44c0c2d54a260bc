#pragma once

// Pages for browsers, written in the background.

#include "persist/experiment/kept_experiment.h"
#include "persist/page/page_file.h"
#include "studio/files/long_files.h"

#include <filesystem>
#include <memory>
#include <string>

namespace cambrian {

// A page of one creature. `title` is for a creature without a name.
struct CreaturePage {
    std::filesystem::path path;
    CreatureDocument document;
    std::string title;
};
Status write_creature_page(CreaturePage page, const PageParts& parts, const EvolutionKinds& kinds,
                           const TrialWatch& watch);

// A page of the champions of a run, which may be running.
struct RunPage {
    std::filesystem::path path;
    std::shared_ptr<const KeptExperiment> run;
    std::string title;
};
Status write_run_page(const RunPage& page, const PageParts& parts, const EvolutionKinds& kinds,
                      const TrialWatch& watch);

}  // namespace cambrian
