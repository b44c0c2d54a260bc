#pragma once

// What a panel may see this frame, by subject; all const.

#include "studio/frame/requests.h"

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
    const PickingView* picking = nullptr;  // null in automatic evolution

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
