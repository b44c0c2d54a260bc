// What a session does to the creature on show: its genes, its neurons, its ancestors.

#include "studio/session.h"

#include <utility>

namespace cambrian {

void Session::apply(const ForceNeuron& action) {
    if (!stage_.playback().empty()) stage_.playback().force(action.neuron, action.value);
}

void Session::apply(const ReleaseNeuron& action) {
    if (!stage_.playback().empty()) stage_.playback().release_neuron(action.neuron);
}

void Session::apply(const ShowExhibit& action) {
    view_.newest_champion = false;
    show(*action.exhibit);
}

void Session::apply(const EditGenes& action) {
    if (stage_.playback().empty()) return;
    const auto faults = validate(*action.genome, kinds_.creature.catalog);
    if (!faults.empty())
        return tell(NoticeKind::kProblem,
                    "Nothing was changed, as the genes would not be valid: " + faults.front());
    view_.newest_champion = false;
    genes_.edit(stage_.playback().exhibit(), action.genome, action.change);
    log_.write(
        "gene edited",
        {{"place", action.change.place}, {"from", action.change.from}, {"to", action.change.to}});
    show_edited();
}

void Session::show_edited() {
    report(stage_.show(genes_.exhibit()));
    shown_since_ = now_;
}

}  // namespace cambrian
