#pragma once

// What panels see of the creature on display and what they may request of the viewer.

#include "pictures/highlight.h"
#include "studio/playback/ghosts.h"
#include "studio/playback/playback.h"
#include "studio/viewer/gene_editor.h"

#include <cstdint>
#include <memory>
#include <span>
#include <variant>

namespace cambrian {

struct TogglePlayback {};
struct RestartPlayback {};
struct StepPlayback {};
struct StepPlaybackBack {};
// Goes to the moment so many ticks after the trial's start.
struct SeekPlayback {
    std::uint64_t tick = 0;
};
// Brings the creature to a good size in the viewport.
struct FitView {};
struct PokePart {
    std::size_t part = 0;
    Vec3 point_in_part = Vec3::Zero();
    Vec3 target = Vec3::Zero();
};
struct ReleasePoke {};
// A neuron has the value, whatever it computes, until released or restarted.
struct ForceNeuron {
    std::size_t neuron = 0;
    double value = 0.0;
};
struct ReleaseNeuron {
    std::size_t neuron = 0;
};
// Highlights a part or neuron in the next frame, in viewport, brain and genotype alike.
struct ShowHighlight {
    Highlight highlight;
};
struct ShowExhibit {
    std::shared_ptr<const Exhibit> exhibit;
};
// Replaces the genome on display by one in which one gene is changed.
struct EditGenes {
    GenomePtr genome;
    GeneChange change;
};
// The control was released, so that the next edit is a new step to undo.
struct FinishGeneEdit {};

using ViewerRequest =
    std::variant<TogglePlayback, RestartPlayback, StepPlayback, StepPlaybackBack, SeekPlayback,
                 FitView, PokePart, ReleasePoke, ForceNeuron, ReleaseNeuron, ShowHighlight,
                 ShowExhibit, EditGenes, FinishGeneEdit>;

struct ViewerView {
    const Playback& playback;
    const ScoreReport* score = nullptr;  // of the creature on display, once computed
    const GeneEditor* genes = nullptr;   // null where the creature cannot be edited
    std::span<const std::unique_ptr<Ghost>> ghosts = {};
    Highlight highlight = {};
    unsigned fits_asked = 0;  // how often the creature was to be fitted into the viewport
};

}  // namespace cambrian
