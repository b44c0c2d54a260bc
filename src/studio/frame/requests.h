#pragma once

// What a panel may ask for: commands for the engine and actions of the studio. Collected while the
// panels draw, carried out after.

#include "evolution/command.h"
#include "evolution/snapshot.h"
#include "picking/picking_command.h"
#include "pictures/highlight.h"
#include "studio/files/file_browser.h"
#include "studio/hand_picking/picking_view.h"
#include "studio/look/view_state.h"
#include "studio/playback/exhibit.h"
#include "studio/viewer/gene_editor.h"

#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cambrian {

// Places of the window that the keyboard can be sent to.
enum class Place : std::uint8_t { kNone, kTimeline, kPopulation };

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
struct StepPlaybackBack {};
// The moment so many ticks after the trial's start.
struct SeekPlayback {
    std::uint64_t tick = 0;
};
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
// A creature of some generation, under the settings that judged it.
struct ShowIndividual {
    ChampionRecord creature;
};
struct ShowNewest {};
struct ToggleStar {
    ChampionRecord creature;
};
struct ToggleStarOfShown {};
struct RestoreStar {};  // the one taken away last
struct FocusPlace {
    Place place = Place::kNone;
};
struct ShowExhibit {
    std::shared_ptr<const Exhibit> exhibit;
};

// The creature on show with one gene changed.
struct EditGenes {
    GenomePtr genome;
    GeneChange change;
};
struct FinishGeneEdit {};  // the control was let go

// Between automatic evolution and selection by hand.
struct ToggleHandPicking {};
// Back to automatic evolution, with what was picked among the next generation's creatures, or with
// a new run that begins with it.
enum class PicksUse : std::uint8_t { kInject, kFound };
struct HandOverPicks {
    PicksUse use = PicksUse::kInject;
};
struct AskPicking {
    PickingCommand command;
};
struct FocusCell {
    std::size_t cell = 0;
};
// A creature of the grid takes the stage: alone until ShowGrid, or to be saved.
struct ShowCell {
    std::size_t cell = 0;
};
struct ShowGrid {};
struct SaveCell {
    std::size_t cell = 0;
};
struct ChangePickingOptions {
    PickingOptions options;
};

struct OpenFilePanel {
    FileTask task = FileTask::kOpen;
    PictureSize picture = {};  // of a plot
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
struct SaveExperimentFile {
    std::filesystem::path path;
};
struct OpenPreviousRun {};
struct SaveSettingsFile {
    std::filesystem::path path;
};
struct SaveStatisticsFile {
    std::filesystem::path path;
};
struct SavePlotPicture {
    std::filesystem::path path;
    PictureSize size;
};
struct SaveScreenshot {
    std::filesystem::path path;  // empty: a new name in the present folder
};

// The filter of the settings gets the keyboard.
struct FindSetting {};
struct ToggleSamples {};
struct DismissNotice {};
struct ToggleHelp {};
// A page by its name: the file's in the help folder, or one of help_book.h.
struct ShowHelp {
    std::string page;
};
// To a step of the tour; beyond the last, or below 0, ends it.
struct TurnTour {
    int step = 0;
};
struct QuitStudio {};

using StudioAction =
    std::variant<ToggleEvolution, RunOneGeneration, EditSettings, FinishEdit, UndoEdit, RedoEdit,
                 StartNewRun, StartFromShown, DropStructuralEdits, AddNewcomers, TogglePlayback,
                 RestartPlayback, StepPlayback, StepPlaybackBack, SeekPlayback, ChangeView, FitView,
                 PokePart, ReleasePoke, ForceNeuron, ReleaseNeuron, ShowHighlight, ShowChampion,
                 ShowIndividual, ShowNewest, ShowExhibit, EditGenes, FinishGeneEdit, ToggleStar,
                 ToggleStarOfShown, RestoreStar, FocusPlace, ToggleHandPicking, HandOverPicks,
                 AskPicking, FocusCell, ShowCell, ShowGrid, SaveCell, ChangePickingOptions,
                 OpenFilePanel, CloseFilePanel, ListFolder, LoadFile, SaveCreatureFile,
                 SaveExperimentFile, OpenPreviousRun, SaveSettingsFile, SaveStatisticsFile,
                 SavePlotPicture, SaveScreenshot, FindSetting, ToggleSamples, DismissNotice,
                 ToggleHelp, ShowHelp, TurnTour, QuitStudio>;

class Requests {
public:
    void ask(StudioAction action) { actions_.push_back(std::move(action)); }
    const std::vector<StudioAction>& actions() const { return actions_; }
    std::vector<StudioAction> take() { return std::exchange(actions_, {}); }

private:
    std::vector<StudioAction> actions_;
};

}  // namespace cambrian
