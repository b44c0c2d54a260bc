#include "studio/preserve/preserve_controller.h"

#include "picking/handover.h"
#include "preserve/laws.h"

#include <fmt/core.h>

#include <algorithm>
#include <random>
#include <system_error>
#include <utility>

namespace cambrian {
namespace {

// Returns a name beside the file that tells where a branch begins, and that is not taken.
std::filesystem::path branch_of(const std::filesystem::path& file, std::uint64_t tick) {
    const std::string stem = fmt::format("{}-from-{}s", file.stem().string(), tick / 60);
    std::filesystem::path path = file.parent_path() / (stem + ".cambrian");
    std::error_code unknown;
    for (int number = 2; std::filesystem::exists(path, unknown); ++number)
        path = file.parent_path() / fmt::format("{}-{}.cambrian", stem, number);
    return path;
}

// Returns whether the creatures of a choice live on ground.
bool live_on_ground(FounderChoice choice, const PreserveSubjects& subjects) {
    const auto has_ground = [](const ExperimentSettings& settings) {
        return settings.world.environment.has_ground;
    };
    const Playback& playback = subjects.viewer.playback();
    const auto& stars = subjects.generations.facts().stars.all();
    const PickingView* grid = subjects.picking.facts();
    switch (choice) {
        case FounderChoice::kShown:
            return !playback.empty() && has_ground(playback.exhibit().settings());
        case FounderChoice::kStarred:
            return std::all_of(stars.begin(), stars.end(), [&](const JudgedIndividual& star) {
                return has_ground(*star.settings);
            });
        case FounderChoice::kPicked:
            return grid != nullptr && has_ground(*grid->snapshot.settings);
        case FounderChoice::kWalkers:
            return true;
        case FounderChoice::kSwimmers:
        case FounderChoice::kRandom:
            break;
    }
    return false;
}

// Returns no genomes for random creatures and samples, which are read later.
std::vector<GenomePtr> genomes_of_choice(FounderChoice choice, const PreserveSubjects& subjects) {
    const Playback& playback = subjects.viewer.playback();
    if (choice == FounderChoice::kShown && !playback.empty()) return {playback.exhibit().genome()};
    std::vector<GenomePtr> genomes;
    if (choice == FounderChoice::kStarred) {
        for (const JudgedIndividual& each : subjects.generations.facts().stars.all())
            genomes.push_back(each.individual->genome);
    }
    const PickingView* grid = subjects.picking.facts();
    if (choice == FounderChoice::kPicked && grid != nullptr && !grid->snapshot.tree.empty())
        genomes = genomes_of(picked_creatures(grid->snapshot));
    return genomes;
}

}  // namespace

// Requests of the lists about the world: its laws and its museum.
struct PreserveController::WorldLists {
    PreserveController& self;

    void operator()(const ShowList& request) const {
        self.tools_.list = request.list;
        self.services_.feedback.log().write(
            "world list", {{"name", kWorldListNames[static_cast<std::size_t>(request.list)]}});
    }
    void operator()(const TypeLaws&) const {
        self.tools_.list = WorldList::kLaws;
        ++self.tools_.laws_asked;
    }
    void operator()(const SetLaw& request) const {
        self.send(Intervene{law_change(request.law, request.value)});
    }
    void operator()(const ChoosePiece& request) const {
        if (!self.on() || request.index >= self.picture_->museum->size()) return;
        self.tools_.list = WorldList::kMuseum;
        self.tools_.piece = request.index;
        const MuseumPiece& piece = (*self.picture_->museum)[request.index];
        self.services_.feedback.log().write(
            "museum piece",
            {{"number", static_cast<double>(piece.number)}, {"reason", piece.reason}});
    }
    void operator()(const ShowPiece&) const {
        self.tools_.single = self.show_alone(WorldSubject::kPiece);
    }
};

// Requests that concern the place where the pointer or the view is.
struct PreserveController::WorldTools : WorldLists {
    using WorldLists::operator();

    const ResidentPicture* picked() const { return self.open_ ? self.open_->picked() : nullptr; }
    void intervene(const char* what, std::uint64_t number) const {
        self.send(Intervene{
            {.what = what, .number = number, .x = self.tools_.aim.x(), .y = self.tools_.aim.y()}});
    }

    void operator()(const RemovePicked&) const {
        if (picked() != nullptr) intervene(intervention::kRemove, picked()->life.number);
    }
    void operator()(const AimAt& request) const { self.tools_.aim = {request.x, request.y}; }
    void operator()(const FeedThere&) const { intervene(intervention::kFeed, 0); }
    void operator()(const MovePickedThere&) const {
        if (picked() != nullptr) intervene(intervention::kMove, picked()->life.number);
    }
    void operator()(const DrawWall&) const {
        WallTool& wall = self.tools_.wall;
        if (!self.on()) return;
        const Vec3 aim(self.tools_.aim.x(), self.tools_.aim.y(), 0.0);
        const Vec2 here = self.picture_->area.between_walls(aim).head<2>();
        if (!wall.from) {
            wall = {true, here};
            return;
        }
        self.send(Intervene{{.what = intervention::kWall,
                             .x = wall.from->x(),
                             .y = wall.from->y(),
                             .to_x = here.x(),
                             .to_y = here.y()}});
        wall = {};
    }
    void operator()(const ToggleWalls&) const { self.tools_.wall = {!self.tools_.wall.on, {}}; }
    void operator()(const EraseWallThere&) const { intervene(intervention::kErase, 0); }
    void operator()(const AddShown&) const {
        const Playback& playback = self.subjects_.viewer.playback();
        if (!playback.empty()) self.add(playback.exhibit().genome());
    }
};

// Has one overload for each kind of request.
struct PreserveController::Handler : WorldTools {
    using WorldTools::operator();

    void operator()(const TogglePreserveCard&) const {
        self.tools_.card_open = !self.tools_.card_open;
        self.tools_.plan = {};
    }
    void operator()(const PlanPreserve& request) const {
        self.tools_.card_open = true;
        self.tools_.plan = request;
    }
    void operator()(const BeginPreserve& request) const {
        self.tools_.card_open = false;
        // It would move the file aside that the attempt before is about to use.
        if (self.unfinished_ > 0) {
            return self.services_.feedback.tell(
                NoticeKind::kProblem, "Another preserve is being opened; try again after that.");
        }
        if (request.founders) return self.begin(*request.founders, request);
        self.close();
        self.open_later([file = self.own_file_,
                         &kinds = self.services_.kinds] { return open_world(file, kinds); },
                        false);
    }
    // A world that is still being opened is dropped when it arrives.
    void operator()(const ClosePreserve&) const {
        ++self.attempts_;
        if (self.on()) self.leave();
    }
    void operator()(const TogglePlay&) const {
        if (self.on()) self.send(PlayPreserve{!self.picture_->playing});
    }
    void operator()(const AskPreserve& request) const { self.send(request.command); }
    void operator()(const PickResident& request) const {
        if (!self.open_) return;
        self.open_->pick(request.number);
        if (request.number == 0) self.tools_.follow = false;
        self.services_.feedback.log().write("picked",
                                            {{"number", static_cast<double>(request.number)}});
    }
    void operator()(const PickNext& request) const {
        if (!self.open_ || self.picture_->residents.empty()) return;
        const auto& all = self.picture_->residents;
        const auto count = static_cast<std::int64_t>(all.size());
        std::int64_t at = request.steps > 0 ? -1 : count;
        for (std::int64_t i = 0; picked() != nullptr && i < count; ++i) {
            if (all[static_cast<std::size_t>(i)].life.number <= picked()->life.number) at = i;
        }
        const std::int64_t next = (at + request.steps + count) % count;
        (*this)(PickResident{all[static_cast<std::size_t>(next)].life.number});
    }
    void operator()(const FollowPicked&) const {
        self.tools_.follow = !self.tools_.follow && picked() != nullptr;
        self.services_.feedback.log().write("follow", {{"on", self.tools_.follow}});
    }
    void operator()(const PinPicked&) const {
        if (picked() == nullptr) return;
        self.pins_.toggle(picked()->life.number);
    }
    void operator()(const InheritPins&) const { self.pins_.toggle_inheritance(); }
    void operator()(const ShowPicked&) const {
        self.tools_.single = self.show_alone(WorldSubject::kPicked);
    }
    void operator()(const ShowWorld&) const { self.tools_.single = false; }
    void operator()(const FitWorld&) const {
        self.tools_.follow = false;
        self.tools_.near = false;
        ++self.tools_.fits_asked;
    }
    void operator()(const ToggleEnergyRings&) const {
        self.tools_.energy = !self.tools_.energy;
        self.services_.feedback.log().write("energy rings", {{"on", self.tools_.energy}});
    }
    void operator()(const TurnPlot& request) const {
        const auto count = static_cast<int>(kWorldPlotCount);
        const int next = static_cast<int>(self.tools_.plot) + request.steps;
        self.tools_.plot = static_cast<std::size_t>((next % count + count) % count);
        self.services_.feedback.log().write("world plot",
                                            {{"index", static_cast<double>(self.tools_.plot)}});
    }
    void operator()(const BranchFrom& request) const {
        if (!self.open_ || self.open_->file().empty()) return;
        self.branch(request.tick, branch_of(self.open_->file(), request.tick));
    }
};

PreserveController::PreserveController(const Services& services, const PreserveSubjects& subjects,
                                       const ThreadShare& threads)
    : services_(services), subjects_(subjects), threads_(threads) {}

void PreserveController::keep_in(const std::filesystem::path& folder) {
    if (!folder.empty()) own_file_ = folder / "preserve.cambrian";
}

void PreserveController::update() {
    if (open_) {
        open_->update(services_.feedback);
        picture_ = open_->picture();
        pins_.follow(*picture_);
        if (pins_.take_change()) {
            send(KeepPins{pins_.pins()});
            services_.feedback.log().write(
                "pins", {{"creatures", static_cast<double>(pins_.pins().creatures.size())},
                         {"inherited", pins_.pins().inherited}});
        }
    }
    facts_.reset();
    if (!on()) return;
    static const std::filesystem::path no_file;
    const ResidentPicture* picked = open_ ? open_->picked() : nullptr;
    if (picked == nullptr || picked->life.died != 0) tools_.follow = false;
    facts_.emplace(PreserveView{.picture = *picture_,
                                .file = open_ ? open_->file() : no_file,
                                .picked = picked,
                                .pins = pins_.pins(),
                                .founding = open_ ? open_->settings() : nullptr,
                                .follow = tools_.follow,
                                .energy = tools_.energy,
                                .single = tools_.single,
                                .opening = open_ == nullptr,
                                .near = tools_.near,
                                .fits_asked = tools_.fits_asked,
                                .wall = tools_.wall,
                                .plot = tools_.plot,
                                .list = tools_.list,
                                .laws_asked = tools_.laws_asked,
                                .piece = tools_.piece});
}

void PreserveController::carry_out(const PreserveRequest& request) {
    const bool enters = std::holds_alternative<TogglePreserveCard>(request) ||
                        std::holds_alternative<BeginPreserve>(request);
    if (enters && services_.dimensions() == 3) {
        return services_.feedback.tell(
            NoticeKind::kProblem,
            "Preserves are flat: their creatures live in two dimensions. Edit > New run in two "
            "dimensions leads there.");
    }
    std::visit(Handler{{{*this}}}, request);
}

PreserveCardView PreserveController::card() const {
    if (!tools_.card_open) return {};
    std::error_code unknown;
    std::set<FounderChoice> on_ground;
    for (const FounderChoice choice : kFounderChoices) {
        if (live_on_ground(choice, subjects_)) on_ground.insert(choice);
    }
    return {.open = true,
            .shown = !subjects_.viewer.playback().empty(),
            .starred = subjects_.generations.facts().stars.all().size(),
            .picked = genomes_of_choice(FounderChoice::kPicked, subjects_).size(),
            .before = !own_file_.empty() && std::filesystem::exists(own_file_, unknown),
            .on_ground = std::move(on_ground),
            .plan = tools_.plan};
}

void PreserveController::send(PreserveCommand command) {
    if (open_) open_->send(std::move(command));
}

void PreserveController::begin(FounderChoice choice, const BeginPreserve& request) {
    WorldPlan plan;
    plan.settings = std::exchange(tools_.plan, {}).settings;
    if (plan.settings.empty()) {
        const bool on_ground = live_on_ground(choice, subjects_);
        plan.settings = assets_ / "settings" / (on_ground ? "meadow.toml" : "pond.toml");
        plan.seed = std::random_device{}();
        if (on_ground) plan.ground = request.ground;
    }
    plan.wraps = request.wraps;
    plan.choice = choice;
    plan.founders = genomes_of_choice(choice, subjects_);
    plan.samples = assets_ / "creatures";
    plan.file = own_file_;
    if (!is_open_choice(choice) && plan.founders.empty()) {
        return services_.feedback.tell(NoticeKind::kProblem,
                                       "There are no such creatures to begin a preserve with.");
    }
    close();
    open_later(
        [plan = std::move(plan), &kinds = services_.kinds] { return begin_world(plan, kinds); },
        true);
}

// Stops the thread in the background, since it may have to write first.
void PreserveController::close() {
    if (!open_) return;
    services_.worker.submit([held = std::exchange(open_, nullptr)](const std::stop_token&) mutable {
        held.reset();
        return BackgroundWorker::Completion([] {});
    });
}

void PreserveController::leave() {
    close();
    picture_.reset();
    facts_.reset();
    tools_.single = false;
    subjects_.experiment.release(true);
    services_.feedback.log().write("preserve", {{"on", false}});
}

void PreserveController::open_later(std::function<Result<OpenedWorld>()> make, bool play) {
    ++unfinished_;
    services_.worker.submit(
        [this, make = std::move(make), play, number = ++attempts_](const std::stop_token&) {
            auto made = std::make_shared<Result<OpenedWorld>>(make());
            return BackgroundWorker::Completion([this, made, play, number] {
                --unfinished_;
                if (number != attempts_) return;
                if (*made) {
                    open(std::move(**made));
                    if (play) send(PlayPreserve{true});
                    return;
                }
                services_.feedback.tell(NoticeKind::kProblem, made->error().message);
                if (on() && !open_) leave();
            });
        });
}

void PreserveController::open(OpenedWorld opened) {
    ++attempts_;
    if (!on()) {
        if (subjects_.picking.on()) subjects_.picking.carry_out(ToggleHandPicking{});
        subjects_.experiment.suspend();
    }
    close();
    const std::vector<std::string> warnings = std::move(opened.warnings);
    Pins pins = std::move(opened.pins);
    open_ = std::make_shared<OpenPreserve>(std::move(opened), threads_);
    picture_ = open_->picture();
    pins_.begin(std::move(pins), *picture_);
    tools_.wall = {};
    tools_.single = false;
    tools_.follow = false;
    tools_.piece = 0;
    tools_.near = picture_->area.has_ground;
    ++tools_.fits_asked;
    services_.feedback.log().write(
        "preserve", {{"on", true},
                     {"path", open_->file().string()},
                     {"tick", static_cast<double>(picture_->tick)},
                     {"creatures", static_cast<double>(picture_->residents.size())}});
    if (!warnings.empty()) services_.feedback.tell(NoticeKind::kProblem, warnings.front());
}

void PreserveController::add(const GenomePtr& genome) {
    send(Intervene{
        {.what = intervention::kAdd, .x = tools_.aim.x(), .y = tools_.aim.y(), .genome = genome}});
}

bool PreserveController::show_alone(WorldSubject subject) {
    if (!open_) return false;
    const auto show = [this](std::uint64_t number, const GenomePtr& genome,
                             const std::string& method) {
        const SettingsPtr settings = trial_settings(picture_->laws, services_.kinds);
        subjects_.viewer.show({.creature = unjudged(genome, settings, method),
                               .source = ExhibitSource::kPreserve,
                               .title = fmt::format("Creature {} of the preserve", number)});
        return true;
    };
    if (subject == WorldSubject::kPiece) {
        const auto& museum = *picture_->museum;
        if (tools_.piece >= museum.size()) return false;
        const MuseumPiece& piece = museum[tools_.piece];
        return show(piece.number, piece.genome, piece.reason);
    }
    const ResidentPicture* picked = open_->picked();
    return picked != nullptr && show(picked->life.number, picked->life.genome, picked->life.method);
}

void PreserveController::move_to(const std::filesystem::path& path) {
    if (!open_) return;
    if (open_->file().empty()) {
        return services_.feedback.tell(
            NoticeKind::kProblem,
            "This preserve has no file to copy, since the studio keeps no state (--state-dir).");
    }
    branch(std::nullopt, path);
}

// The file is copied after the thread has ended, which writes all that is missing.
void PreserveController::branch(std::optional<std::uint64_t> tick,
                                const std::filesystem::path& to) {
    const std::filesystem::path from = open_->file();
    close();
    open_later(
        [from, tick, to, &kinds = services_.kinds] { return branch_world(from, tick, to, kinds); },
        false);
}

}  // namespace cambrian
