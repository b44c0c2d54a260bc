#include "studio/viewer/viewer_controller.h"

#include "core/text/counted.h"
#include "core/text/pretty_text.h"
#include "genome/genome.h"
#include "studio/background/people_words.h"
#include "studio/viewer/drawing_edits.h"

#include <utility>

namespace cambrian {
namespace {

constexpr double kPlaybackBudget = 0.006;  // s per frame
constexpr double kGhostBudget = 0.004;     // s per frame

}  // namespace

// Has one overload for each kind of request.
struct ViewerController::Handler {
    ViewerController& self;

    Playback& playback() const { return self.viewer_.playback(); }

    void operator()(const TogglePlayback&) const {
        playback().pace().playing = !playback().pace().playing;
    }
    void operator()(const RestartPlayback&) const { playback().restart(); }
    void operator()(const StepPlayback&) const {
        playback().step();
        self.log_tick();
    }
    void operator()(const StepPlaybackBack&) const {
        playback().step_back();
        self.log_tick();
    }
    void operator()(const TurnTrial& request) const {
        if (playback().empty()) return;
        const int trials = playback().exhibit().settings().world.trial.trials;
        const int shown = playback().creature().trial_number();
        playback().show_trial((shown + request.steps + trials) % trials);
        self.services_.feedback.log().write(
            "trial", {{"number", static_cast<double>(playback().creature().trial_number())}});
    }
    void operator()(const SeekPlayback& request) const { playback().seek(request.tick); }
    void operator()(const FitView&) const { ++self.facts_.fits_asked; }
    void operator()(const ToggleGroundPen&) const {
        self.facts_.ground_pen = !self.facts_.ground_pen;
        if (!self.facts_.ground_pen) return;
        self.draw_or_play(false);
        playback().restart();
        ++self.facts_.fits_asked;
    }
    void operator()(const LookFrom& request) const {
        ++self.facts_.sides_asked;
        self.facts_.side = request.side;
    }
    // A part or neuron may be one of the creature that another request has just replaced.
    void operator()(const PokePart& request) const {
        if (playback().empty()) return;
        if (request.part >= playback().creature().phenotype().parts.size()) return;
        playback().creature().pull(Hold{request.part, request.point_in_part, request.target});
    }
    void operator()(const ReleasePoke&) const { playback().creature().pull(std::nullopt); }
    void operator()(const ForceNeuron& request) const {
        if (has_neuron(request.neuron)) playback().creature().force(request.neuron, request.value);
    }
    void operator()(const ReleaseNeuron& request) const {
        if (has_neuron(request.neuron)) playback().creature().force(request.neuron, std::nullopt);
    }
    bool has_neuron(std::size_t neuron) const {
        return !playback().empty() &&
               neuron < playback().creature().phenotype().network.neurons.size();
    }
    void operator()(const ShowHighlight& request) const {
        self.facts_.highlight.join(request.highlight);
    }
    void operator()(const HoldShown&) const { self.attended_ = true; }
    void operator()(const ShowExhibit& request) const {
        self.view_.newest_champion = false;
        self.show(*request.exhibit);
    }
    void operator()(const StudySenses&) const {
        if (!playback().empty()) self.senses_.begin(playback().exhibit());
    }
    void operator()(const StopSenseStudy&) const { self.senses_.clear(); }
    void operator()(const EditGenes& request) const {
        if (playback().empty()) return;
        const auto faults = validate(*request.genome, self.services_.kinds.creature.catalog);
        if (!faults.empty())
            return self.services_.feedback.tell(
                NoticeKind::kProblem, "Nothing was changed, as the genes would not be valid: " +
                                          people_words(faults.front()));
        self.view_.newest_champion = false;
        self.genes_.edit(playback().exhibit(), request.genome, request.change);
        self.services_.feedback.log().write("gene edited", {{"place", request.change.place},
                                                            {"from", request.change.from},
                                                            {"to", request.change.to}});
        self.show_edited();
    }
    void operator()(const FinishGeneEdit&) const { self.genes_.finish(); }
    void operator()(const StudyLesions& request) const {
        if (!playback().empty()) self.lesions_.study(playback().exhibit(), request.pairs);
    }
    void operator()(const InflictLesions& request) const {
        const Status begun = playback().deprive(request.lesions);
        if (!begun) return self.services_.feedback.report(begun);
        self.view_.newest_champion = false;
        self.clear_highlight();
        self.services_.feedback.log().write(
            "lesions", {{"count", static_cast<double>(request.lesions.size())}});
    }
    void operator()(const PruneShown&) const {
        if (!playback().empty()) self.lesions_.prune(playback().exhibit());
    }
    void operator()(const StopLesions&) const { self.lesions_.stop(); }
    void operator()(const ToggleDrawing&) const { self.draw_or_play(!self.facts_.drawing.on); }
    void operator()(const ChoosePart& request) const { self.facts_.drawing.chosen = request.part; }
    void operator()(const MirrorNewParts& request) const {
        self.facts_.drawing.mirror = request.sides;
    }
    void operator()(const RemovePart&) const { self.edit_drawing(without_chosen); }
    void operator()(const RepeatPart& request) const {
        self.edit_drawing(
            [&request](const DrawnBody& body) { return with_repeats(body, request.times); });
    }
    void operator()(const SwitchPair&) const { self.edit_drawing(with_pair_switched); }
    void operator()(const GiveRhythm& request) const {
        self.edit_drawing(
            [&request](const DrawnBody& body) { return with_given_rhythm(body, request.rhythm); });
    }
};

ViewerController::ViewerController(const Services& services, ViewState& view)
    : services_(services),
      view_(view),
      viewer_(services.worker, services.kinds),
      senses_(services.kinds),
      lesions_(services.kinds),
      ghosts_(services.kinds.creature),
      facts_{.playback = viewer_.playback(),
             .genes = &genes_,
             .senses = &senses_,
             .lesions = &lesions_} {}

void ViewerController::update(double elapsed, const EvolutionSnapshot& snapshot) {
    senses_.update();
    if (const auto pruning = lesions_.update()) show_pruned(*pruning);
    viewer_.playback().pace().speed = view_.speed;
    viewer_.playback().advance(elapsed, kPlaybackBudget);
    const ScoreReport* score = viewer_.score();
    const double travel = score == nullptr || score->record.samples.empty()
                              ? 0.0
                              : score->record.samples.back().center_of_mass.x() -
                                    score->record.samples.front().center_of_mass.x();
    ghosts_.update(snapshot, view_.ghosts, viewer_.playback(), travel, kGhostBudget);
}

void ViewerController::carry_out(const ViewerRequest& request) {
    std::visit(Handler{*this}, request);
}

ViewerView ViewerController::facts() const {
    ViewerView facts = facts_;
    facts.score = viewer_.score();
    facts.ghosts = ghosts_.all();
    return facts;
}

void ViewerController::show(Exhibit exhibit) {
    const std::string name = exhibit.name();
    const std::string title = exhibit.title;
    const std::string uid = uid_text(exhibit.individual().uid);
    if (Status status = viewer_.show(std::move(exhibit)); !status)
        return services_.feedback.report(status);
    genes_.clear();
    senses_.clear();
    clear_highlight();
    facts_.drawing.chosen.reset();
    shown_since_ = services_.feedback.now();
    services_.feedback.log().write("shown", {{"name", name}, {"title", title}, {"uid", uid}});
}

void ViewerController::use_environment(const Environment& environment) {
    viewer_.playback().creature().set_environment(environment);
}

bool ViewerController::undo_gene_edit() {
    return genes_.can_undo() && step_gene_edit(&GeneEditor::undo, "gene undone");
}

bool ViewerController::redo_gene_edit() {
    return genes_.can_redo() && step_gene_edit(&GeneEditor::redo, "gene redone");
}

bool ViewerController::step_gene_edit(void (GeneEditor::*step)(), const char* news) {
    (genes_.*step)();
    services_.feedback.log().write(news);
    show_edited();
    return true;
}

bool ViewerController::held() const {
    const PlayedCreature& creature = viewer_.playback().creature();
    if (creature.empty()) return false;
    return facts_.drawing.on || attended_ || creature.hold() != nullptr ||
           !creature.replay().forced().empty();
}

double ViewerController::shown_for() const {
    return services_.feedback.now() - shown_since_;
}

bool ViewerController::animating() const {
    const Playback& playback = viewer_.playback();
    return (playback.pace().playing && !playback.empty()) || playback.seeking() ||
           senses_.running() || lesions_.running();
}

void ViewerController::show_edited() {
    services_.feedback.report(viewer_.show(genes_.exhibit()));
    senses_.clear();
    clear_highlight();
    shown_since_ = services_.feedback.now();
}

void ViewerController::show_pruned(const LesionLab::Pruning& pruning) {
    const Playback& playback = viewer_.playback();
    const std::size_t count = pruning.twin.removed.size();
    services_.feedback.log().write("pruned", {{"genes", static_cast<double>(count)}});
    if (playback.empty() || playback.exhibit().genome() != pruning.whole)
        return services_.feedback.tell(
            NoticeKind::kProblem,
            "The creature that was pruned is no longer displayed; show it "
            "and prune it again.");
    if (count == 0)
        return services_.feedback.tell(NoticeKind::kDone,
                                       "Nothing can be pruned: every gene counts.");
    carry_out(EditGenes{pruning.twin.genome, {"pruned", "", counted(count, "gene") + " removed"}});
    genes_.finish();
    services_.feedback.tell(NoticeKind::kDone, "Pruned: without " + counted(count, "gene") + ", " +
                                                   pretty_number(pruning.twin.after) + " of " +
                                                   pretty_number(pruning.twin.before) +
                                                   " is left. Ctrl+Z takes it back.");
}

void ViewerController::draw_or_play(bool draws) {
    Playback& playback = viewer_.playback();
    if (playback.empty() || facts_.drawing.on == draws) return;
    facts_.drawing.on = draws;
    if (draws) {
        facts_.ground_pen = false;
        view_.newest_champion = false;
    }
    playback.creature().pull(std::nullopt);
    playback.restart();
    playback.pace().playing = !draws;
    ++facts_.fits_asked;
    services_.feedback.log().write(draws ? "drawing" : "drawn");
}

// The edit is one step to undo, except that of a slider, which ends when it is released.
template <class Edit>
void ViewerController::edit_drawing(const Edit& edit) {
    if (viewer_.playback().empty()) return;
    const Exhibit& shown = viewer_.playback().exhibit();
    const SketchRules rules{services_.kinds.creature, shown.settings().expression,
                            shown.settings().world.scene};
    Result<DrawnEdit> edited =
        edit(DrawnBody{sketch_of(*shown.genome(), rules), rules, facts_.drawing});
    if (!edited)
        return services_.feedback.tell(NoticeKind::kProblem,
                                       capitalized(edited.error().message) + ".");
    carry_out(EditGenes{std::make_shared<const Genome>(std::move(edited->genome)),
                        std::move(edited->change)});
    if (edited->is_complete) genes_.finish();
}

void ViewerController::log_tick() {
    services_.feedback.log().write(
        "tick", {{"number", static_cast<double>(viewer_.playback().tick_shown())}});
}

}  // namespace cambrian
