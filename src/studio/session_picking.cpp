// What a session does in selection by hand.

#include "picking/handover.h"
#include "studio/session.h"

#include <utility>
#include <variant>

namespace cambrian {

void Session::follow_picking(double elapsed) {
    picking_.use(experiment_.snapshot().settings, now_);
    picking_.update(elapsed * view_.speed, log_);
    picking_view_.reset();
    if (picking_.on()) picking_view_.emplace(picking_.view());
    keep_picking();
}

void Session::enter_picking() {
    evolved_before_picking_ = experiment_.running();
    experiment_.pause();
    GenomePtr shown;
    if (!stage_.playback().empty()) shown = stage_.playback().exhibit().genome;
    picking_.enter(experiment_.snapshot(), shown, now_);
    log_.write("hand-picking", {{"on", true}});
}

void Session::leave_picking() {
    picking_.leave(experiment_.snapshot());
    picking_view_.reset();
    log_.write("hand-picking", {{"on", false}});
}

void Session::apply(const ToggleHandPicking&) {
    if (!picking_.on()) return enter_picking();
    leave_picking();
    if (evolved_before_picking_) experiment_.resume();
}

void Session::apply(const HandOverPicks& action) {
    if (!picking_.on()) return;
    const std::vector<IndividualPtr> picks = picking_.picks();
    if (picks.empty()) return tell(NoticeKind::kProblem, "Pick at least one creature first.");
    if (action.use == PicksUse::kFound) {
        const Status begun = experiment_.start_new_run(genomes_of(picks));
        if (!begun) return report(begun);
        log_.write("new run");
        tell(NoticeKind::kDone, "A new run begins with the picks. Press Evolve to go on.");
    } else {
        experiment_.inject(picks);
        log_.write("injected", {{"count", static_cast<double>(picks.size())}});
        tell(NoticeKind::kDone,
             "The picks join the next generation that is bred. Press Evolve to go on.");
    }
    leave_picking();
}

void Session::apply(const AskPicking& action) {
    if (!picking_.on()) return;
    if (std::holds_alternative<VisitGrid>(action.command)) apply(ShowGrid{});
    picking_.send(action.command, now_);
}

bool Session::show_cell(std::size_t cell) {
    if (!picking_.has_cell(cell)) return false;
    view_.newest_champion = false;
    show(picking_.exhibit(cell));
    return true;
}

void Session::apply(const ShowCell& action) {
    if (!show_cell(action.cell)) return;
    picking_.show_single(true);
}

void Session::apply(const ShowGrid&) {
    picking_.show_single(false);
}

void Session::apply(const SaveCell& action) {
    if (show_cell(action.cell)) apply(OpenFilePanel{FileTask::kSaveCreature});
}

}  // namespace cambrian
