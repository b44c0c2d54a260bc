#pragma once

// Owns the displayed creature: its playback, its score, the edits of its genes, and the ghosts
// beside it.

#include "studio/background/services.h"
#include "studio/look/view_state.h"
#include "studio/viewer/viewer.h"
#include "studio/viewer/viewer_contract.h"

namespace cambrian {

class ViewerController {
public:
    // The references in `services`, and `view`, must outlive the controller.
    ViewerController(const Services& services, ViewState& view);

    // Must be called once a frame unless the viewport is hidden; plays on by `elapsed` seconds.
    void update(double elapsed, const EvolutionSnapshot& snapshot);
    // Must be called before a frame's requests, since a highlight lasts one frame, as does the
    // user's attention. A highlight is also of one creature only.
    void clear_highlight() {
        facts_.highlight = {};
        attended_ = false;
    }
    void carry_out(const ViewerRequest& request);
    ViewerView facts() const;

    // Displays another creature; reports the error if that is impossible.
    void show(Exhibit exhibit);
    // Replaces the scores of the displayed creature by those of an audit.
    void rejudge(IndividualPtr individual) {
        viewer_.playback().creature().rejudge(std::move(individual));
    }
    // Displays a creature beside each champion of the experiment; nothing for none.
    void run_beside(std::optional<Companion> companion) {
        ghosts_.run_beside(std::move(companion));
    }
    // Applies an environment that the user changed to the displayed creature at once.
    void use_environment(const Environment& environment);
    // Takes up the pen that draws the displayed creature, or lays it down and plays the creature.
    void draw_or_play(bool draws);
    // Undo or redo an edit of the genes; return false if there is none.
    bool undo_gene_edit();
    bool redo_gene_edit();

    const Playback& playback() const { return viewer_.playback(); }
    const ScoreReport* score() const { return viewer_.score(); }
    // Whether the user is at work on the displayed creature, so that no other one may replace it by
    // itself: draws it, pulls it, forces a neuron, or has the pointer in its controls.
    bool held() const;
    double shown_for() const;  // s since the creature was displayed
    bool animating() const;    // whether the next frame differs without input

private:
    struct Handler;
    bool step_gene_edit(void (GeneEditor::*step)(), const char* news);
    void show_edited();
    void log_tick();
    void show_pruned(const LesionLab::Pruning& pruning);
    template <class Edit>
    void edit_drawing(const Edit& edit);

    Services services_;
    ViewState& view_;
    Viewer viewer_;
    SenseStudy senses_;
    GeneEditor genes_;  // edits of the displayed creature
    LesionLab lesions_;
    Ghosts ghosts_;
    ViewerView facts_;
    bool attended_ = false;     // the pointer is in the creature's controls
    double shown_since_ = 0.0;  // s; time at which the creature was displayed
};

}  // namespace cambrian
