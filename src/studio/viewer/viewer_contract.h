#pragma once

// The data of the displayed creature that panels see, and the requests they may make of the viewer.

#include "pictures/scene/highlight.h"
#include "sketch/rhythm.h"
#include "sketch/strokes.h"
#include "studio/playback/ghosts.h"
#include "studio/playback/playback.h"
#include "studio/viewer/gene_editor.h"
#include "studio/viewer/lesion_lab.h"
#include "studio/viewer/sense_study.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace cambrian {

struct TogglePlayback {};
struct RestartPlayback {};
struct StepPlayback {};
struct StepPlaybackBack {};
// Plays the trial that comes so many after the displayed one, of those that the score combines; the
// first follows the last.
struct TurnTrial {
    int steps = 1;
};
// Seeks a tick after the trial's start.
struct SeekPlayback {
    std::uint64_t tick = 0;
};
// Moves and scales the camera so that the creature fits the viewport.
struct FitView {};
// Takes up the pen that draws ground in the viewport, or lays it down.
struct ToggleGroundPen {};
// The sides from which a creature in space can be looked at.
enum class ViewSide : unsigned char { kSlanted, kFront, kRight, kTop };
struct LookFrom {
    ViewSide side = ViewSide::kSlanted;
};
struct PokePart {
    std::size_t part = 0;
    Vec3 point_in_part = Vec3::Zero();
    Vec3 target = Vec3::Zero();
};
struct ReleasePoke {};
// Forces the value of a neuron until it is released or the trial restarts.
struct ForceNeuron {
    std::size_t neuron = 0;
    double value = 0.0;
};
struct ReleaseNeuron {
    std::size_t neuron = 0;
};
// Highlights a part or neuron in the next frame, in viewport, brain and genotype.
struct ShowHighlight {
    Highlight highlight;
};
// Says that the user is busy with the displayed creature, which therefore stays in the next frame.
struct HoldShown {};
struct ShowExhibit {
    std::shared_ptr<const Exhibit> exhibit;
};
// Finds what the displayed creature loses without its senses, or gives that up.
struct StudySenses {};
struct StopSenseStudy {};
// Replaces the displayed creature's genome by one with one gene changed.
struct EditGenes {
    GenomePtr genome;
    GeneChange change;
};
// Ends an edit when the control is released, so that the next edit is a new step to undo.
struct FinishGeneEdit {};
// Studies what the displayed creature loses by lesions, the worst ones also two at a time.
struct StudyLesions {
    bool pairs = false;
};
// Plays the displayed creature with these lesions; with none, it is whole again.
struct InflictLesions {
    std::vector<Lesion> lesions;
};
// Removes the genes of the displayed creature that cost nothing.
struct PruneShown {};
struct StopLesions {};
// Takes up the pen that draws the displayed creature's body at rest, or lays it down and plays it.
struct ToggleDrawing {};
struct ChoosePart {
    std::optional<PartName> part;
};
struct MirrorNewParts {
    MirrorSides sides = MirrorSides::kNone;
};
// The following change the chosen part, each as one step to undo.
struct RemovePart {};
struct RepeatPart {
    int times = 1;
};
// Gives it a mirror image, or takes it away.
struct SwitchPair {};
// Lets all joints of the displayed creature follow a rhythm.
struct GiveRhythm {
    Rhythm rhythm;
};

using ViewerRequest =
    std::variant<TogglePlayback, RestartPlayback, StepPlayback, StepPlaybackBack, TurnTrial,
                 SeekPlayback, FitView, ToggleGroundPen, LookFrom, PokePart, ReleasePoke,
                 ForceNeuron, ReleaseNeuron, ShowHighlight, HoldShown, ShowExhibit, StudySenses,
                 StopSenseStudy, EditGenes, FinishGeneEdit, StudyLesions, InflictLesions,
                 PruneShown, StopLesions, ToggleDrawing, ChoosePart, MirrorNewParts, RemovePart,
                 RepeatPart, SwitchPair, GiveRhythm>;

// The drawing of the displayed creature by hand.
struct DrawingView {
    bool on = false;
    MirrorSides mirror = MirrorSides::kNone;  // of new parts
    std::optional<PartName> chosen = {};
};

struct ViewerView {
    const Playback& playback;
    const ScoreReport* score = nullptr;  // score of the displayed creature, null until computed
    const GeneEditor* genes = nullptr;   // null if the creature cannot be edited
    const SenseStudy* senses = nullptr;  // of the displayed creature; may be null
    const LesionLab* lesions = nullptr;
    std::span<const std::unique_ptr<Ghost>> ghosts = {};
    Highlight highlight = {};
    unsigned fits_asked = 0;             // number of FitView requests so far
    unsigned sides_asked = 0;            // of LookFrom requests
    ViewSide side = ViewSide::kSlanted;  // of the last of them
    bool ground_pen = false;             // the left button draws ground
    DrawingView drawing = {};
};

}  // namespace cambrian
