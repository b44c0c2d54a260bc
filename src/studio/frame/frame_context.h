#pragma once

// What a panel may see this frame; all const.

#include "evolution/setting_field.h"
#include "evolution/snapshot.h"
#include "studio/experiment/progress_view.h"
#include "studio/experiment/settings_editor.h"
#include "studio/files/file_browser.h"
#include "studio/files/sample_shelf.h"
#include "studio/frame/requests.h"
#include "studio/hand_picking/picking_view.h"
#include "studio/help/help_book.h"
#include "studio/look/view_state.h"
#include "studio/playback/ghosts.h"
#include "studio/playback/playback.h"
#include "studio/viewer/gene_editor.h"
#include "studio/viewer/stars.h"
#include "studio/widgets/notices.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

struct FrameContext {
    const EvolutionKinds& kinds;
    const std::vector<SettingField>& fields;
    const EvolutionSnapshot& snapshot;
    const ProgressView& progress;
    const SettingsEditor& editor;
    const Playback& playback;
    const ScoreReport* score = nullptr;  // of the creature on show, once computed
    const ViewState& view;
    const FileBrowser& files;
    const Stars& stars;
    const Notice* notice = nullptr;
    bool help_shown = false;
    bool viewer = false;  // the viewport and its transport alone
    Highlight highlight = {};
    std::span<const std::unique_ptr<Ghost>> ghosts = {};
    const HelpBook* help = nullptr;
    const SampleShelf* samples = nullptr;
    int tour_step = -1;                    // none
    unsigned find_asked = 0;               // how often a setting was to be found
    Place focus = Place::kNone;            // to get the keyboard now
    const PickingView* picking = nullptr;  // null in automatic evolution
    const GeneEditor* genes = nullptr;  // of the creature on show; null where it cannot be edited
    bool previous_run = false;          // whether there is one that could be opened

    bool can_undo() const { return editor.can_undo() || (genes != nullptr && genes->can_undo()); }
    bool can_redo() const { return editor.can_redo() || (genes != nullptr && genes->can_redo()); }
};

}  // namespace cambrian
