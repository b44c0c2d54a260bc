#include "studio/hand_picking/picking_controller.h"

#include "picking/handover.h"

#include <utility>
#include <variant>

namespace cambrian {

// Has one overload for each kind of request.
struct PickingController::Handler {
    PickingController& self;

    void operator()(const ToggleHandPicking&) const {
        if (!self.picking_.on()) return self.enter();
        self.leave(true);
    }
    void operator()(const HandOverPicks& request) const {
        if (!self.picking_.on()) return;
        Feedback& feedback = self.services_.feedback;
        const std::vector<IndividualPtr> picks = self.picking_.picks();
        if (picks.empty())
            return feedback.tell(NoticeKind::kProblem, "Pick at least one creature first.");
        OpenExperiment& experiment = self.experiment_.open();
        if (request.use == PicksUse::kFound) {
            const Status begun = experiment.start_new_run(genomes_of(picks));
            if (!begun) return feedback.report(begun);
            feedback.log().write("new run");
            feedback.tell(NoticeKind::kDone,
                          "A new run begins with the picks. Press Evolve to go on.");
        } else {
            for (EngineCommand& command : injection_of(picks))
                experiment.send(std::move(command));
            feedback.log().write("injected", {{"count", static_cast<double>(picks.size())}});
            feedback.tell(
                NoticeKind::kDone,
                "The picks join the next generation that is bred. Press Evolve to go on.");
        }
        self.leave(false);
    }
    void operator()(const AskPicking& request) const {
        if (!self.picking_.on()) return;
        if (std::holds_alternative<VisitGrid>(request.command)) (*this)(ShowGrid{});
        self.picking_.send(request.command);
    }
    void operator()(const FocusCell& request) const {
        self.picking_.choices().focus = request.cell;
    }
    void operator()(const ShowCell& request) const {
        if (self.show_cell(request.cell)) self.picking_.choices().single = true;
    }
    void operator()(const ShowGrid&) const { self.picking_.choices().single = false; }
    void operator()(const ChangePickingOptions& request) const {
        self.picking_.choices().options = request.options;
    }
};

PickingController::PickingController(const Services& services, ViewState& view,
                                     ViewerController& viewer, ExperimentController& experiment,
                                     const ThreadShare& threads)
    : services_(services),
      view_(view),
      viewer_(viewer),
      experiment_(experiment),
      picking_(services.kinds, threads) {}

void PickingController::update(double elapsed) {
    const unsigned run = experiment_.open().runs_begun();
    if (std::exchange(seen_run_, run) != run) {
        if (picking_.on()) leave(false);
        restore({});
    }
    picking_.use(experiment_.open().snapshot().settings);
    picking_.update(elapsed * view_.speed, services_.feedback.log());
    facts_.reset();
    if (picking_.on()) facts_.emplace(picking_.view());
    keep();
}

void PickingController::carry_out(const PickingRequest& request) {
    std::visit(Handler{*this}, request);
}

bool PickingController::take_over(const ViewerRequest& request) {
    if (!picking_.grid_shown()) return false;
    if (std::holds_alternative<RestartPlayback>(request)) {
        picking_.restart_motion();
        return true;
    }
    if (!std::holds_alternative<TogglePlayback>(request)) return false;
    picking_.choices().playing = !picking_.choices().playing;
    return true;
}

bool PickingController::show_cell(std::size_t cell) {
    if (!picking_.has_cell(cell)) return false;
    view_.newest_champion = false;
    viewer_.show(picking_.exhibit(cell));
    return true;
}

// The present grids are those of another experiment and must not be saved in this one.
void PickingController::restore(PickingRecord record) {
    picking_.restore(std::move(record));
    kept_ = picking_.shared_snapshot();
    seen_run_ = experiment_.open().runs_begun();
}

void PickingController::enter() {
    experiment_.suspend();
    const Playback& playback = viewer_.playback();
    picking_.enter(experiment_.open().snapshot(),
                   playback.empty() ? nullptr : playback.exhibit().genome());
    services_.feedback.log().write("hand-picking", {{"on", true}});
}

void PickingController::leave(bool resume) {
    picking_.leave(experiment_.open().snapshot());
    experiment_.release(resume);
    facts_.reset();
    services_.feedback.log().write("hand-picking", {{"on", false}});
}

// Saves every change of the picking tree in the experiment's file as it happens.
void PickingController::keep() {
    const std::shared_ptr<const PickingSnapshot> picking = picking_.shared_snapshot();
    if (!picking || picking == kept_ || picking->tree.empty()) return;
    kept_ = picking;
    write_in_background(services_, [picking, kept = experiment_.open().files().kept()] {
        return kept->keep_picking({picking->tree, picking->picks, picking->shelf});
    });
}

}  // namespace cambrian
