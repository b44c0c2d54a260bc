#pragma once

// The studio without its window: the open experiment, what is on show, files, notices, and what
// each request of a panel does to them.

#include "studio/background/status_log.h"
#include "studio/experiment/open_experiment.h"
#include "studio/files/file_desk.h"
#include "studio/files/sample_shelf.h"
#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"
#include "studio/hand_picking/hand_picking.h"
#include "studio/help/help_book.h"
#include "studio/playback/ghosts.h"
#include "studio/remembered.h"
#include "studio/viewer/gene_editor.h"
#include "studio/viewer/stage.h"
#include "studio/widgets/notices.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace cambrian {

class Session {
public:
    // kinds must outlive it. `clock` is in seconds, for notices.
    Session(Remembered remembered, const EvolutionKinds& kinds, std::size_t workers,
            const std::filesystem::path& status_log);

    // From now on, keeps arrangement, settings and experiment in a folder whenever they changed.
    void remember_in(const std::filesystem::path& folder);
    // In the background: the experiment that was open when the folder was last used.
    void reopen_last();
    void keep_memory();
    // Shows one creature and offers nothing else.
    void be_viewer() { viewer_ = true; }
    // Help pages and samples come from here.
    void use_assets(const std::filesystem::path& folder);
    // The tour, unless it was taken before.
    void offer_tour();
    // Puts a file on show or in force at once, before the first frame.
    void open_now(const std::filesystem::path& path, ExhibitSource source);
    // A random creature takes the stage, so that it is never empty.
    void show_newcomer();
    // Once a frame, before drawing: news of engine and files, then `elapsed` seconds of playback.
    void update(double now, double elapsed);
    void carry_out(Requests& requests);
    FrameContext frame_context() const;

    const ViewState& view() const { return view_; }
    StatusLog& log() { return log_; }
    bool quit_wanted() const { return quit_wanted_; }
    bool animating() const;  // whether the next frame differs even without input
    double playback_seconds() const { return playback_seconds_; }  // spent in the last update
    void drop(const std::filesystem::path& path) { apply(LoadFile{path}); }
    void tell(NoticeKind kind, const std::string& text);
    // What the window's graphics have drawn for a card that was asked for.
    void keep_card(const PreparedCard& card, Image picture);
    void keep_picture(const std::filesystem::path& path, Image image);
    bool take_fit() { return std::exchange(fit_wanted_, false); }
    std::optional<std::filesystem::path> take_picture_request() {
        return std::exchange(picture_wanted_, std::nullopt);
    }
    std::optional<SavePlotPicture> take_plot_request() {
        return std::exchange(plot_wanted_, std::nullopt);
    }

    std::optional<PreparedCard> take_card_request() {
        return std::exchange(card_wanted_, std::nullopt);
    }

private:
    void apply(const ToggleEvolution&);
    void apply(const RunOneGeneration&);
    void apply(const EditSettings& action);
    void apply(const FinishEdit&);
    void apply(const UndoEdit&);
    void apply(const RedoEdit&);
    void apply(const StartNewRun& action);
    void apply(const AddNewcomers& action);
    void apply(const StartFromShown&);
    void apply(const DropStructuralEdits&);
    void apply(const TogglePlayback&);
    void apply(const RestartPlayback&);
    void apply(const StepPlayback&);
    void apply(const StepPlaybackBack&);
    void apply(const SeekPlayback& action) { stage_.playback().seek(action.tick); }
    void apply(const ChangeView& action);
    void apply(const FitView&) { fit_wanted_ = true; }
    void apply(const PokePart& action);
    void apply(const ReleasePoke&) { stage_.playback().release(); }
    void apply(const ShowHighlight& action) { highlight_.join(action.highlight); }
    void apply(const ShowChampion& action);
    void apply(const ShowIndividual& action);
    void apply(const ShowNewest&);
    void apply(const ToggleStar& action);
    void apply(const ToggleStarOfShown&);
    void apply(const RestoreStar&) { stars_.restore(); }
    void apply(const FocusPlace& action) { focus_ = action.place; }
    void apply(const ToggleHandPicking&);
    void apply(const HandOverPicks& action);
    void apply(const AskPicking& action);
    void apply(const FocusCell& action) { picking_.focus(action.cell); }
    void apply(const ShowCell& action);
    void apply(const ShowGrid&);
    void apply(const SaveCell& action);
    void apply(const ChangePickingOptions& action) { picking_.set_options(action.options); }
    void apply(const ShowExhibit& action);
    void apply(const ForceNeuron& action);
    void apply(const ReleaseNeuron& action);
    void apply(const EditGenes& action);
    void apply(const FinishGeneEdit&) { genes_.finish(); }
    void apply(const OpenFilePanel& action);
    void apply(const CloseFilePanel&) { files_.open = false; }
    void apply(const ListFolder& action) { desk_.list(action.folder, files_.task); }
    void apply(const LoadFile& action) { desk_.load(action.path); }
    void apply(const SaveCreatureFile& action);
    void apply(const SaveExperimentFile& action);
    void apply(const OpenPreviousRun&);
    void apply(const SaveSettingsFile& action);
    void apply(const SaveStatisticsFile& action);
    void apply(const SavePlotPicture& action) { plot_wanted_ = action; }
    void apply(const SaveScreenshot& action) { picture_wanted_ = action.path; }
    void apply(const DismissNotice&) { notices_.dismiss(); }
    void apply(const FindSetting&);
    void apply(const ToggleSamples&);
    void apply(const ToggleHelp&);
    void apply(const ShowHelp& action);
    void apply(const TurnTour& action);
    void apply(const QuitStudio&) { quit_wanted_ = true; }

    void receive(CreatureLoaded& event);
    void receive(const SettingsLoaded& event);
    void receive(ExperimentLoaded& event);
    void receive(const FileSaved& event);
    void receive(CardPrepared& event) { card_wanted_ = std::move(event.card); }
    void receive(FolderListed& event) { files_.listing = std::move(event.listing); }
    void receive(const FileFailed& event);

    void follow_picking(double elapsed);
    void keep_picking();
    void keep_stars();
    void enter_picking();
    void leave_picking();
    bool show_cell(std::size_t cell);
    void follow_engine();
    void follow_status();
    void follow_champion();
    void show(Exhibit exhibit);
    void show_champion(const ChampionRecord& champion);
    const ChampionRecord* champion_of(std::uint32_t generation) const;
    std::optional<ChampionRecord> creature_on_show() const;
    void show_edited();
    void commit_settings();
    void log_tick();
    void follow_world(const Environment& before);
    void report(const Status& status);
    Exhibit exhibit_from(const CreatureDocument& document, ExhibitSource source,
                         const std::filesystem::path& path) const;
    CreatureDocument document_on_show() const;

    const EvolutionKinds& kinds_;
    StatusLog log_;
    BackgroundWorker worker_;
    FileDesk desk_;
    Stage stage_;
    GeneEditor genes_;  // of the creature on show
    OpenExperiment experiment_;
    HandPicking picking_;
    std::optional<PickingView> picking_view_;  // of this frame
    bool evolved_before_picking_ = false;
    ViewState view_;
    std::filesystem::path memory_;  // folder; empty remembers nothing
    Remembered kept_;
    double kept_at_ = 0.0;  // s
    bool previous_run_ = false;
    bool reopening_ = false;  // what was open last is being read
    std::shared_ptr<const PickingSnapshot> kept_picking_;
    std::uint64_t kept_stars_ = 0;  // revision
    FileBrowser files_;
    Notices notices_;
    double now_ = 0.0;
    const Notice* notice_ = nullptr;
    Ghosts ghosts_;
    HelpBook help_;
    bool help_shown_ = false;
    std::filesystem::path samples_folder_;
    SampleShelf samples_;
    int tour_step_ = -1;
    unsigned find_asked_ = 0;
    bool viewer_ = false;
    bool quit_wanted_ = false;
    bool fit_wanted_ = false;
    std::optional<std::filesystem::path> picture_wanted_;
    std::optional<SavePlotPicture> plot_wanted_;
    std::optional<PreparedCard> card_wanted_;
    Stars stars_;
    Highlight highlight_;
    Place focus_ = Place::kNone;
    double playback_seconds_ = 0.0;
    double shown_since_ = 0.0;  // s, of the creature on show
    std::uint64_t seen_experiment_ = 0;
    std::size_t seen_champions_ = 0;
    EngineStatus seen_status_ = EngineStatus::kPaused;
};

}  // namespace cambrian
