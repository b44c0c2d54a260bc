#include "picking/picking_session.h"

#include "picking/grid/grid_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

// Returns the picks by cell. Picks keep their cells; those beyond the end of a smaller grid take
// the first free cells.
std::map<std::size_t, IndividualPtr> kept_in_place(const std::vector<std::size_t>& picks,
                                                   const std::vector<IndividualPtr>& creatures,
                                                   std::size_t cells) {
    std::map<std::size_t, IndividualPtr> kept;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        if (picks[i] < cells) kept.emplace(picks[i], creatures[i]);
    }
    std::size_t free = 0;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        if (picks[i] < cells) continue;
        while (!kept.emplace(free, creatures[i]).second)
            ++free;
    }
    return kept;
}

// Returns a creature that was evaluated with `settings`; it loses its score if `judged_by` would
// score it differently.
IndividualPtr scored_by(const ExperimentSettings& settings, const IndividualPtr& creature,
                        const ExperimentSettings& judged_by) {
    return same_judgement(settings, judged_by) ? creature : without_score(*creature);
}

Status check_genomes(const std::vector<GenomePtr>& genomes, const KindCatalog& catalog) {
    if (genomes.size() > kMostPicks)
        return Error{fmt::format("a grid starts from at most 4 creatures, not {}", genomes.size())};
    for (const GenomePtr& genome : genomes) {
        if (!genome) return Error{"there is no creature to start from"};
        const std::vector<std::string> faults = validate(*genome, catalog);
        if (!faults.empty()) return Error{"the creature cannot be used: " + faults.front()};
    }
    return {};
}

}  // namespace

PickingSession::PickingSession(SettingsPtr settings, const EvolutionKinds& kinds) : kinds_(kinds) {
    shown_.settings = std::move(settings);
}

void PickingSession::apply(PickingCommand command) {
    const Status done = std::visit([this](auto& each) { return carry_out(each); }, command);
    shown_.message = done ? std::string() : done.error().message;
}

// --- first grids

Status PickingSession::carry_out(ShowPopulation& command) {
    if (!command.settings) return Error{"a population comes with its settings"};
    shown_.settings = std::move(command.settings);
    GridOrder order = order_of({});
    order.pool = std::move(command.population);
    begin(draft_of(GridOrigin::kPopulation), std::move(order));
    shown_.status = PickingStatus::kBreeding;
    return {};
}

Status PickingSession::carry_out(StartFromCreatures& command) {
    if (Status valid = check_genomes(command.genomes, kinds_.creature.catalog); !valid)
        return valid;
    GridOrder order = order_of(import_creatures(command.genomes, next_number(), *shown_.settings));
    if (!order.parents.empty()) order.kept.emplace(0, order.parents.front());
    begin(draft_of(GridOrigin::kCreatures), std::move(order));
    shown_.status = PickingStatus::kBreeding;
    return {};
}

Status PickingSession::carry_out(RestoreGrids& command) {
    const std::size_t cells = command.tree.empty() ? 0 : command.tree.current().creatures.size();
    for (const std::size_t pick : command.picks) {
        if (pick >= cells) return Error{fmt::format("the grid has no cell {}", pick + 1)};
    }
    stop_work();
    shown_.tree = std::move(command.tree);
    shown_.picks = std::move(command.picks);
    shown_.shelf = std::move(command.shelf);
    if (shown_.tree.empty()) return {};
    shown_.grid = shown_.tree.current().grid;
    breed_ahead();
    return {};
}

// --- settings of the next grid

Status PickingSession::carry_out(UseSettings& command) {
    if (!command.settings) return Error{"there are no settings to use"};
    shown_.settings = std::move(command.settings);
    if (!deciding()) breed_ahead();
    return {};
}

Status PickingSession::carry_out(const ChangeGrid& command) {
    if (Status valid = check_grid(command.grid); !valid) return valid;
    if (shown_.grid == command.grid) return {};
    shown_.grid = command.grid;
    if (!deciding()) breed_ahead();
    return {};
}

Status PickingSession::carry_out(const TogglePick& command) {
    if (Status open = check_open(); !open) return open;
    if (Status exists = check_cell(command.node, command.cell); !exists) return exists;
    const auto found = std::find(shown_.picks.begin(), shown_.picks.end(), command.cell);
    if (found != shown_.picks.end()) {
        shown_.picks.erase(found);
    } else if (shown_.picks.size() == kMostPicks) {
        return Error{"at most 4 creatures can be picked"};
    } else {
        shown_.picks.push_back(command.cell);
    }
    breed_ahead();
    return {};
}

Status PickingSession::carry_out(const ClearPicks& /*command*/) {
    if (Status open = check_open(); !open) return open;
    shown_.picks.clear();
    breed_ahead();
    return {};
}

// --- decisions

Status PickingSession::carry_out(const BreedPicks& /*command*/) {
    if (Status open = check_open(); !open) return open;
    if (shown_.picks.empty()) return Error{"pick at least one creature to breed"};
    if (!work_) breed_ahead();  // work is missing if breeding ahead failed
    decide();
    return {};
}

Status PickingSession::carry_out(const ReplaceUnpicked& /*command*/) {
    if (Status open = check_open(); !open) return open;
    const auto cells = static_cast<std::size_t>(shown_.grid.cells);
    if (shown_.picks.size() >= cells) return Error{"every creature of the grid is picked"};
    GridOrder order = order_of({});
    order.kept = kept_in_place(shown_.picks, parents(), cells);
    begin(draft_of(GridOrigin::kImmigrants), std::move(order));
    decide();
    return {};
}

Status PickingSession::carry_out(const AskEvolution& command) {
    if (Status open = check_open(); !open) return open;
    if (shown_.picks.empty()) return Error{"pick at least one creature to evolve from"};
    if (command.generations < 1 || command.generations > kMostAssistedGenerations)
        return Error{fmt::format("evolution can be asked for 1 to 1000 generations, not {}",
                                 command.generations)};
    GridOrder order = order_of(parents());
    order.immigrant_cells = 0;
    GridNode draft = draft_of(GridOrigin::kAssistance);
    draft.generations = command.generations;
    begin(std::move(draft), std::move(order));
    work_->assistance.emplace(work_->order.parents, command.generations, next_number(),
                              *shown_.settings, kinds_);
    decide();
    shown_.status = PickingStatus::kEvolving;
    shown_.generations_done = 0;
    shown_.generations_asked = command.generations;
    return {};
}

Status PickingSession::carry_out(const CancelDecision& /*command*/) {
    if (!deciding()) return Error{"no decision is waiting for its grid"};
    breed_ahead();
    return {};
}

// --- navigation in the tree

Status PickingSession::carry_out(const GoBack& /*command*/) {
    const bool takes_back = deciding();
    if (!takes_back && !shown_.tree.back()) return Error{"this is the first grid"};
    if (!takes_back) recall_picks();
    breed_ahead();
    return {};
}

Status PickingSession::carry_out(const GoForward& /*command*/) {
    if (!shown_.tree.forward()) return Error{"no grid was bred from this one"};
    recall_picks();
    breed_ahead();
    return {};
}

Status PickingSession::carry_out(const VisitGrid& command) {
    if (Status visited = shown_.tree.visit(command.node); !visited) return visited;
    recall_picks();
    breed_ahead();
    return {};
}

// --- the shelf

Status PickingSession::carry_out(const PinCreature& command) {
    if (Status exists = check_cell(command.node, command.cell); !exists) return exists;
    const GridNode& grid = shown_.tree.current();
    shown_.shelf.push_back(grid.cell(command.cell));
    return {};
}

Status PickingSession::carry_out(const UnpinCreature& command) {
    if (command.place >= shown_.shelf.size()) return Error{"no such creature is on the shelf"};
    shown_.shelf.erase(shown_.shelf.begin() + static_cast<std::ptrdiff_t>(command.place));
    return {};
}

Status PickingSession::carry_out(const PlacePinned& command) {
    if (Status open = check_open(); !open) return open;
    if (Status exists = check_cell(command.node, command.cell); !exists) return exists;
    if (command.place >= shown_.shelf.size()) return Error{"no such creature is on the shelf"};
    GridNode node = shown_.tree.current();
    node.origin = GridOrigin::kShelf;
    node.picks = shown_.picks;
    node.generations = 0;
    node.creatures[command.cell] = scored_by(*node.settings, shown_.shelf[command.place].individual,
                                             *shown_.shelf[command.place].settings);
    show_grid(std::move(node));
    return {};
}

// --- making grids

bool PickingSession::has_work() const {
    return work_ && !(work_->making && work_->making->done());
}

bool PickingSession::work(EvaluationBackend& backend, EvaluationProgress& progress,
                          const std::stop_token& stop) {
    if (!has_work()) return true;
    if (work_->assistance) {
        Assistance& assistance = *work_->assistance;
        if (!assistance.step(backend, progress, stop)) return false;
        shown_.generations_done = assistance.generations_done();
        if (!assistance.done()) return true;
        work_->order.pool = assistance.elites();
        work_->assistance.reset();
        begin(std::move(work_->draft), std::move(work_->order));
    }
    if (!work_->making->run(backend, progress, stop)) return false;
    if (deciding()) {
        finish_decision();
    } else {
        shown_.children_ready = true;
    }
    return true;
}

void PickingSession::fail(std::string message) {
    stop_work();
    shown_.message = std::move(message);
}

Status PickingSession::check_open() const {
    if (deciding()) return Error{"the next grid is not ready yet"};
    if (shown_.tree.empty()) return Error{"there is no grid yet"};
    return {};
}

Status PickingSession::check_cell(std::uint32_t node, std::size_t cell) const {
    if (shown_.tree.empty() || node != shown_.tree.current().number)
        return Error{"that grid is not shown any more"};
    if (cell >= shown_.tree.current().creatures.size())
        return Error{fmt::format("the grid has no cell {}", cell + 1)};
    return {};
}

std::uint32_t PickingSession::next_number() const {
    return static_cast<std::uint32_t>(shown_.tree.size());
}

// Returns the picks as parents; scores that the present settings would not give are removed.
std::vector<IndividualPtr> PickingSession::parents() const {
    std::vector<IndividualPtr> picked = picked_creatures(shown_);
    for (IndividualPtr& creature : picked)
        creature = scored_by(*shown_.settings, creature, *shown_.tree.current().settings);
    return picked;
}

GridNode PickingSession::draft_of(GridOrigin origin) const {
    GridNode draft;
    draft.origin = origin;
    draft.picks = shown_.picks;
    draft.grid = shown_.grid;
    draft.settings = shown_.settings;
    return draft;
}

GridOrder PickingSession::order_of(std::vector<IndividualPtr> parents) const {
    GridOrder order;
    order.node = next_number();
    order.cells = shown_.grid.cells;
    order.fitness_weight = shown_.grid.fitness_weight;
    order.extra_mutations = extra_mutations(shown_.grid.boldness);
    if (!parents.empty()) order.immigrant_cells = immigrant_cells(shown_.grid);
    order.parents = std::move(parents);
    return order;
}

void PickingSession::begin(GridNode draft, GridOrder order) {
    Work work{std::move(draft), std::move(order), std::nullopt, std::nullopt};
    work.making.emplace(work.order, work.draft.settings, kinds_);
    work_ = std::move(work);
    shown_.children_ready = false;
}

// Makes the present work the next grid, which is shown when it is done.
void PickingSession::decide() {
    ++shown_.decisions;
    if (shown_.tree.next()) ++shown_.branches;
    shown_.status = PickingStatus::kBreeding;
    if (!has_work()) finish_decision();
}

void PickingSession::finish_decision() {
    GridNode node = std::move(work_->draft);
    node.creatures = work_->making->cells();
    show_grid(std::move(node));
}

// Breeds the children of the picks in advance, so that they are ready when requested.
void PickingSession::breed_ahead() {
    stop_work();
    if (shown_.picks.empty()) return;
    GridOrder order = order_of(parents());
    order.kept.emplace(0, order.parents.front());
    begin(draft_of(GridOrigin::kBreeding), std::move(order));
}

void PickingSession::stop_work() {
    work_.reset();
    shown_.status = PickingStatus::kOpen;
    shown_.children_ready = false;
}

void PickingSession::show_grid(GridNode node) {
    stop_work();
    shown_.tree.add(std::move(node));
    recall_picks();
}

// Restores the picks that the displayed grid had when it was left.
void PickingSession::recall_picks() {
    const std::optional<std::uint32_t> child = shown_.tree.next();
    shown_.picks.clear();
    if (child) shown_.picks = shown_.tree.node(*child).picks;
}

std::vector<IndividualPtr> picked_creatures(const PickingSnapshot& snapshot) {
    std::vector<IndividualPtr> picked;
    for (const std::size_t cell : snapshot.picks)
        picked.push_back(snapshot.tree.current().creatures[cell]);
    return picked;
}

}  // namespace cambrian
