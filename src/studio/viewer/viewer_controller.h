#pragma once

// Owns the creature on display: its playback, its score, edits of its genes, and the champions that
// are played beside it.

#include "studio/background/services.h"
#include "studio/look/view_state.h"
#include "studio/viewer/stage.h"
#include "studio/viewer/viewer_contract.h"

namespace cambrian {

class ViewerController {
public:
    // Everything that `services` names and `view` must outlive it.
    ViewerController(const Services& services, ViewState& view);

    // Once a frame, unless the viewport is hidden: plays on by `elapsed` seconds.
    void update(double elapsed, const EvolutionSnapshot& snapshot);
    // Before a frame's requests: a highlight lasts one frame.
    void clear_highlight() { facts_.highlight = {}; }
    void carry_out(const ViewerRequest& request);
    ViewerView facts() const;

    // Puts another creature on display; reports why if that is impossible.
    void show(Exhibit exhibit);
    // An environment changed by hand acts on the creature on display at once.
    void use_environment(const Environment& environment);
    // Undo and redo of an edit of the genes; false if there is none.
    bool undo_gene_edit();
    bool redo_gene_edit();

    const Playback& playback() const { return stage_.playback(); }
    const ScoreReport* score() const { return stage_.score(); }
    double shown_for() const;  // s, since the creature came on display
    bool animating() const;    // whether its next frame differs even without input

private:
    struct Handler;
    bool step_gene_edit(void (GeneEditor::*step)(), const char* news);
    void show_edited();
    void log_tick();

    Services services_;
    ViewState& view_;
    Stage stage_;
    GeneEditor genes_;  // of the creature on display
    Ghosts ghosts_;
    ViewerView facts_;
    double shown_since_ = 0.0;  // s
};

}  // namespace cambrian
