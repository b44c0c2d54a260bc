#pragma once

// The data that panels see in this frame, by subject. Everything is const.

#include "goals/goal.h"
#include "studio/frame/requests.h"

#include <string>

namespace cambrian {

struct FrameContext {
    const EvolutionKinds& kinds;
    const ViewState& view;
    ExperimentView experiment;
    GenerationsView generations;
    ViewerView viewer;
    FilesView files;
    GuideView guide = {};
    WindowView window = {};
    const PickingView* picking = nullptr;        // null unless the user selects by hand
    const MachinesView* machines = nullptr;      // null where nothing is evaluated
    const ComparisonView* comparison = nullptr;  // null where nothing is compared
    CoachView coach = {};
    const PreserveView* preserve = nullptr;  // null while no preserve is open
    PreserveCardView preserve_card = {};

    // Whether creatures live in three dimensions.
    bool in_space() const { return kinds.creature.scene.dimensions == 3; }
    // Whether the viewport shows a world of the experiment whose ground can be drawn by hand.
    bool may_draw_ground() const {
        const TrialWorld& world = experiment.editor.draft().world;
        const Environment& environment = world.environment;
        const bool light_moves = environment.has_light && environment.light_motion != "still";
        return !in_space() && !viewer.playback.empty() && environment.has_ground &&
               !environment.has_wall && !world.trial.has_cube && !light_moves &&
               preserve == nullptr && picking == nullptr && !founders_shown() && !drawing();
    }
    // Whether the body of the creature on display can be drawn by hand.
    bool may_draw_creature() const {
        return !in_space() && !viewer.playback.empty() && preserve == nullptr &&
               picking == nullptr && !window.viewer_only && !window.presenting;
    }
    // Whether it is drawn now: it rests, and the viewport is paper.
    bool drawing() const { return viewer.drawing.on && may_draw_creature(); }
    bool grid_shown() const { return picking != nullptr && !picking->single; }
    bool founders_shown() const {
        return coach.founders != nullptr && picking == nullptr && preserve == nullptr &&
               !window.presenting && !drawing();
    }
    bool world_shown() const { return preserve != nullptr && !preserve->single; }
    // The tour waits while a preserve is open.
    bool tour_shown() const { return guide.tour_step >= 0 && preserve == nullptr; }
    bool start_shown() const { return files.start != nullptr && files.start->open; }
    bool samples_shown() const { return files.samples != nullptr && files.samples->open; }
    // Whether a card lies over the grid or the world, so that keys are not for these.
    bool covered() const {
        return window.palette_open || files.browser.open || guide.help_shown ||
               preserve_card.open || samples_shown() || start_shown() || tour_shown();
    }
    bool machines_told() const { return machines != nullptr && cluster_wanted(*machines); }
    // Whether a line of text is shown along the bottom.
    bool foot_shown() const { return preserve != nullptr || machines_told(); }
    std::string unit_of_goal() const {
        return goal_unit(experiment.snapshot.settings->goal, kinds.goals);
    }
    bool can_undo() const {
        return experiment.new_run || experiment.editor.can_undo() ||
               (viewer.genes != nullptr && viewer.genes->can_undo());
    }
    bool can_redo() const {
        return experiment.editor.can_redo() ||
               (viewer.genes != nullptr && viewer.genes->can_redo());
    }
};

}  // namespace cambrian
