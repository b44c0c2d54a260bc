#pragma once

// Films and races, drawn and written in the background.

#include "persist/experiment/kept_experiment.h"
#include "studio/files/clip_maker.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace cambrian {

// A film of a run, which may be running. The choice's seconds are those of each champion.
struct RunFilm {
    std::filesystem::path path;
    std::shared_ptr<const KeptExperiment> run;
    ClipChoice choice;
    Palette palette;
};
Status write_run_film(const RunFilm& film, const EvolutionKinds& kinds, const TrialWatch& watch);

// A race of creatures in the world of the settings.
struct CreatureRace {
    std::filesystem::path path;
    std::vector<JudgedIndividual> creatures;
    ExperimentSettings settings;
    ClipChoice choice;
    Palette palette;
};
Status write_creature_race(const CreatureRace& race, const EvolutionKinds& kinds,
                           const TrialWatch& watch);

}  // namespace cambrian
