#pragma once

// Makes pages (creature/page_document.h): one file for a browser, without a network, in which
// creatures move and are verified, and populations evolve. The engine that computes this there is
// the program itself as WebAssembly (src/app/engine); without it, a page plays recorded motions.

#include "evolution/individual/statistics.h"
#include "persist/creature/creature_file.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cambrian {

struct PageCreature {
    CreatureDocument document;
    std::string label;                             // of its button, where there are several
    std::optional<std::uint32_t> generation = {};  // of the run that it was the champion of
};

// The course of a run, which the page draws.
struct PageCourse {
    std::vector<GenerationStatistics> history;
    std::string unit;  // of the fitness
};

// An evolution that the page offers.
struct PageEvolution {
    ExperimentSettings settings;
    std::vector<std::uint64_t> digests;  // of the first generations' populations
};

struct PageContent {
    std::string title;
    std::vector<PageCreature> creatures;  // the first one is shown
    std::optional<PageEvolution> evolution = {};
    std::optional<PageCourse> course = {};
};

// What pages are made of.
struct PageParts {
    std::string version;             // of the program
    std::filesystem::path folder;    // of the template and the scripts
    std::filesystem::path engine;    // cambrian.wasm; need not exist
    std::filesystem::path licences;  // of what the engine contains; need not exist
};

// Returns the text of a page. Fails if a part is missing or if physics rejects a body.
Result<std::string> make_page(const PageContent& content, const PageParts& parts,
                              const EvolutionKinds& kinds);

}  // namespace cambrian
