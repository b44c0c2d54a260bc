#pragma once

// What a panel may ask for: commands for the engine and actions of the studio. Collected while the
// panels draw, carried out after.

#include "evolution/command.h"
#include "evolution/individual.h"
#include "studio/exhibit.h"
#include "studio/gene_editor.h"
#include "studio/highlight.h"
#include "studio/view_state.h"

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cambrian {

struct ToggleEvolution {};
struct RunOneGeneration {};

// The draft replaced after an edit of one field ("environment.gravity").
struct EditSettings {
    ExperimentSettings settings;
    std::string field;
};
struct FinishEdit {};  // the control was let go: the engine gets the draft
struct UndoEdit {};    // of the genes on show; if none was edited, of the settings
struct RedoEdit {};
// Generation 0 anew with the draft, from random creatures or the present population.
struct StartNewRun {
    bool keep_population = false;
};
// The same from the creature on show and what the settings fill up with.
struct StartFromShown {};
struct DropStructuralEdits {};  // back to what is running

struct TogglePlayback {};
struct RestartPlayback {};
struct StepPlayback {};
struct ChangeView {
    ViewState view;
};
struct FitView {};
struct PokePart {
    std::size_t part = 0;
    Vec3 point_in_part = Vec3::Zero();
    Vec3 target = Vec3::Zero();
};
struct ReleasePoke {};
// A neuron says the value, whatever it computes, until released or restarted.
struct ForceNeuron {
    std::size_t neuron = 0;
    double value = 0.0;
};
struct ReleaseNeuron {
    std::size_t neuron = 0;
};
// For the next frame, in viewport, brain and genotype alike.
struct ShowHighlight {
    Highlight highlight;
};

struct ShowChampion {
    std::uint32_t generation = 0;
};
struct ShowIndividual {
    IndividualPtr individual;
};
struct ShowNewest {};
struct ShowExhibit {
    std::shared_ptr<const Exhibit> exhibit;
};

// The creature on show with one gene changed.
struct EditGenes {
    GenomePtr genome;
    GeneChange change;
};
struct FinishGeneEdit {};  // the control was let go

enum class FileTask : std::uint8_t { kOpen, kSaveCreature, kSaveSettings };
struct OpenFilePanel {
    FileTask task = FileTask::kOpen;
};
struct CloseFilePanel {};
struct ListFolder {
    std::filesystem::path folder;
};
struct LoadFile {
    std::filesystem::path path;
};
struct SaveCreatureFile {
    std::filesystem::path path;
};
struct SaveSettingsFile {
    std::filesystem::path path;
};
struct SaveScreenshot {
    std::filesystem::path path;  // empty: a new name in the present folder
};

struct DismissNotice {};
struct ToggleHelp {};
struct QuitStudio {};

using StudioAction =
    std::variant<ToggleEvolution, RunOneGeneration, EditSettings, FinishEdit, UndoEdit, RedoEdit,
                 StartNewRun, StartFromShown, DropStructuralEdits, AddNewcomers, TogglePlayback,
                 RestartPlayback, StepPlayback, ChangeView, FitView, PokePart, ReleasePoke,
                 ForceNeuron, ReleaseNeuron, ShowHighlight, ShowChampion, ShowIndividual,
                 ShowNewest, ShowExhibit, EditGenes, FinishGeneEdit, OpenFilePanel, CloseFilePanel,
                 ListFolder, LoadFile, SaveCreatureFile, SaveSettingsFile, SaveScreenshot,
                 DismissNotice, ToggleHelp, QuitStudio>;

class Requests {
public:
    void ask(StudioAction action) { actions_.push_back(std::move(action)); }
    const std::vector<StudioAction>& actions() const { return actions_; }
    std::vector<StudioAction> take() { return std::exchange(actions_, {}); }

private:
    std::vector<StudioAction> actions_;
};

}  // namespace cambrian
