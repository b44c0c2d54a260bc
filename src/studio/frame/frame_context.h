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
    const PickingView* picking = nullptr;    // null unless the user selects by hand
    const MachinesView* machines = nullptr;  // null where nothing is evaluated

    bool grid_shown() const { return picking != nullptr && !picking->single; }
    bool machines_told() const { return machines != nullptr && cluster_wanted(*machines); }
    std::string unit_of_goal() const {
        return goal_unit(experiment.snapshot.settings->goal, kinds.goals);
    }
    bool can_undo() const {
        return experiment.editor.can_undo() ||
               (viewer.genes != nullptr && viewer.genes->can_undo());
    }
    bool can_redo() const {
        return experiment.editor.can_redo() ||
               (viewer.genes != nullptr && viewer.genes->can_redo());
    }
};

}  // namespace cambrian
