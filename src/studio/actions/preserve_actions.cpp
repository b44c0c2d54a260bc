// A preserve.

#include "studio/actions/subjects.h"
#include "studio/preserve/notables.h"
#include "studio/preserve/world_words.h"

#include <algorithm>

namespace cambrian {
namespace {

void step_world(const FrameContext&, Requests& out) {
    out.ask(AskPreserve{StepPreserve{}});
}

// Goes to a faster or slower pace of the world.
template <int Steps>
void change_pace(const FrameContext& frame, Requests& out) {
    const auto found =
        std::find(kPreservePaces.begin(), kPreservePaces.end(), frame.preserve->picture.pace);
    const int last = static_cast<int>(kPreservePaces.size()) - 1;
    const int next = std::clamp(static_cast<int>(found - kPreservePaces.begin()) + Steps, 0, last);
    out.ask(AskPreserve{PacePreserve{kPreservePaces[static_cast<std::size_t>(next)]}});
}

bool is_kept(const FrameContext& frame) {
    return !frame.preserve->file.empty();
}
bool is_picked(const FrameContext& frame) {
    return frame.preserve->picked != nullptr;
}

void keep_preserve(const FrameContext& frame, Requests& out) {
    if (is_kept(frame)) out.ask(OpenFilePanel{FileTask::kSavePreserve});
}

// Goes to the last snapshot before the present tick, so that repeated presses go through all.
void go_back(const FrameContext& frame, Requests& out) {
    const auto& ticks = *frame.preserve->picture.snapshots;
    if (ticks.empty()) return;
    const auto later = std::lower_bound(ticks.begin(), ticks.end(), frame.preserve->picture.tick);
    out.ask(BranchFrom{later == ticks.begin() ? *later : *(later - 1)});
}

// Returns the creature so many places after the picked one, or the first or the last one.
std::uint64_t next_of(const std::vector<std::uint64_t>& creatures, std::uint64_t picked,
                      int steps) {
    const auto count = static_cast<int>(creatures.size());
    const auto found = std::find(creatures.begin(), creatures.end(), picked);
    int next = steps > 0 ? 0 : count - 1;
    if (found != creatures.end())
        next = (static_cast<int>(found - creatures.begin()) + steps + count) % count;
    return creatures[static_cast<std::size_t>(next)];
}

// Picks the eldest of the next lineage in the order of their sizes.
template <int Steps>
void pick_lineage(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    std::vector<std::uint64_t> eldest;
    std::uint64_t here = 0;
    for (const LineageCount& lineage : lineages_in(preserve.picture)) {
        eldest.push_back(lineage.eldest);
        if (preserve.picked != nullptr && preserve.picked->life.lineage == lineage.number)
            here = lineage.eldest;
    }
    if (!eldest.empty()) out.ask(PickResident{next_of(eldest, here, Steps)});
}

void pick_notable(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    std::vector<std::uint64_t> notables;
    for (const Notable& each : notables_in(preserve.picture)) {
        if (std::find(notables.begin(), notables.end(), each.creature) == notables.end())
            notables.push_back(each.creature);
    }
    if (notables.empty()) return;
    const std::uint64_t here = preserve.picked == nullptr ? 0 : preserve.picked->life.number;
    out.ask(PickResident{next_of(notables, here, 1)});
}

// Picks the parent that comes first in this order, if it is alive, or else the other one.
template <int First>
void pick_parent(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    if (preserve.picked == nullptr) return;
    const auto& parents = preserve.picked->life.parents;
    for (const std::uint64_t parent : {parents[First], parents[1 - First]}) {
        if (preserve.picture.find(parent) != nullptr) return out.ask(PickResident{parent});
    }
}

void pick_child(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    if (preserve.picked == nullptr) return;
    const std::uint64_t number = preserve.picked->life.number;
    for (const ResidentPicture& each : preserve.picture.residents) {
        const auto& parents = each.life.parents;
        if (std::find(parents.begin(), parents.end(), number) != parents.end())
            return out.ask(PickResident{each.life.number});
    }
}

// Picks the next of those with the same first parent.
void pick_sibling(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    if (preserve.picked == nullptr || preserve.picked->life.parents[0] == 0) return;
    std::vector<std::uint64_t> siblings;
    for (const ResidentPicture& each : preserve.picture.residents) {
        if (each.life.parents[0] == preserve.picked->life.parents[0])
            siblings.push_back(each.life.number);
    }
    if (!siblings.empty())
        out.ask(PickResident{next_of(siblings, preserve.picked->life.number, 1)});
}

void open_left_panels(const FrameContext& frame, Requests& out) {
    if (!frame.view.panels.left) toggles<&ViewState::panels, &PanelSizes::left>(frame, out);
}

void show_next_list(const FrameContext& frame, Requests& out) {
    open_left_panels(frame, out);
    const auto next = (static_cast<std::size_t>(frame.preserve->list) + 1) % kWorldListNames.size();
    out.ask(ShowList{static_cast<WorldList>(next)});
}

// Shows the museum or, if it is shown already, goes so many creatures further in it.
template <int Steps>
void turn_museum(const FrameContext& frame, Requests& out) {
    open_left_panels(frame, out);
    const PreserveView& preserve = *frame.preserve;
    const auto count = static_cast<int>(preserve.picture.museum->size());
    if (count == 0 || preserve.list != WorldList::kMuseum)
        return out.ask(ShowList{WorldList::kMuseum});
    const int next = (static_cast<int>(preserve.piece) + Steps + count) % count;
    out.ask(ChoosePiece{static_cast<std::size_t>(next)});
}

void type_laws(const FrameContext& frame, Requests& out) {
    open_left_panels(frame, out);
    out.ask(TypeLaws{});
}

}  // namespace

std::vector<Action> preserve_actions() {
    // clang-format off
    return {
        {"play", "Space", "Play or pause the world", asks<TogglePlay{}>},
        {"tick", ".", "One tick of the world, then pause", step_world},
        {"slower", "[", "Slower", change_pace<-1>},
        {"faster", "]", "Faster, up to as fast as it goes", change_pace<1>},
        {"pick-next", "Tab", "Pick the next creature", asks<PickNext{1}>},
        {"pick-before", "Shift+Tab", "Pick the one before", asks<PickNext{-1}>},
        {"pick-lineage", "L", "Pick the eldest of the next lineage", pick_lineage<1>},
        {"pick-lineage-before", "Shift+L", "Pick the eldest of the lineage before", pick_lineage<-1>},
        {"pick-notable", "O", "Pick the next outstanding creature", pick_notable},
        {"pick-parent", "U", "Pick the picked creature's parent", pick_parent<0>, is_picked},
        {"pick-other-parent", "Shift+U", "Pick its other parent", pick_parent<1>, is_picked},
        {"pick-child", "C", "Pick its eldest living child", pick_child, is_picked},
        {"pick-sibling", "Shift+C", "Pick the next child of its first parent", pick_sibling, is_picked},
        {"plot", "T", "Show the next plot of the history", asks<TurnPlot{1}>},
        {"plot-before", "Shift+T", "Show the plot before", asks<TurnPlot{-1}>},
        {"list", "N", "Show the next list on the left", show_next_list, {}, {}, "Lineages, laws, museum."},
        {"laws", "J", "Type the value of the first law", type_laws, {}, {}, "Tab goes on to the next, Enter takes it."},
        {"museum", "G", "Show the museum; choose its next creature", turn_museum<1>},
        {"museum-before", "Shift+G", "Show the museum; choose the creature before", turn_museum<-1>},
        {"museum-alone", "Enter", "View the chosen creature of the museum alone", asks<ShowPiece{}>},
        {"museum-save", "Shift+S", "Save the chosen creature of the museum", asks<SavePiece{}>},
        {"follow", "F", "Follow the picked creature with the camera", asks<FollowPicked{}>, is_picked},
        {"pin", "P", "Pin the picked creature, or unpin it", asks<PinPicked{}>, is_picked},
        {"pin-descendants", "Shift+P", "Pin descendants of pinned creatures, too, or no longer", asks<InheritPins{}>},
        {"save-creature", "Ctrl+S or S", "Save creature…", asks<SaveResident{}>, is_picked, {}, "The picked one."},
        {"view-alone", "V", "View the picked creature alone", asks<ShowPicked{}>, is_picked},
        {"remove", "Delete", "Remove the picked creature; its energy becomes flesh", asks<RemovePicked{}>, is_picked},
        {"move", "M", "Move the picked creature to the mouse, or to the middle of the view", asks<MovePickedThere{}>, is_picked},
        {"feed", "E", "Feed ten plants there", asks<FeedThere{}>},
        {"add-shown", "A", "Add a copy of the creature on display there", asks<AddShown{}>},
        {"wall", "W", "Begin a wall there, or end it there", asks<DrawWall{}>},
        {"erase-wall", "X", "Erase the wall there", asks<EraseWallThere{}>},
        {"energy-rings", "R", "Show the store of each creature as a ring, or no longer", asks<ToggleEnergyRings{}>},
        {"fit", "Home", "Fit into view", asks<FitWorld{}>, {}, {}, "The whole world."},
        {"go-back", "Ctrl+Z", "Go back to the snapshot before, in a file of its own", go_back},
        {"add-file", "Ctrl+O", "Add creature to preserve…", asks<OpenFilePanel{FileTask::kOpen}>},
        {"keep-preserve", "Ctrl+K", "Keep preserve in another file…", keep_preserve, is_kept},
    };
    // clang-format on
}

}  // namespace cambrian
