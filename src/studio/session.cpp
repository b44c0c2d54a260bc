#include "studio/session.h"

#include "core/pretty_text.h"
#include "core/random.h"
#include "core/stopwatch.h"
#include "genome/random_genome.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace cambrian {
namespace {

constexpr double kPlaybackBudget = 0.006;  // s a frame
constexpr double kGhostBudget = 0.004;     // s a frame
constexpr double kMemoryInterval = 2.0;    // s
constexpr double kLeastStay = 5.0;         // s a champion is watched before the next may come

}  // namespace

Session::Session(Remembered remembered, const EvolutionKinds& kinds, std::size_t workers,
                 const std::filesystem::path& status_log)
    : kinds_(kinds),
      log_(status_log),
      desk_(worker_, kinds),
      stage_(worker_, kinds),
      experiment_(std::move(remembered.settings), kinds, workers),
      picking_(kinds, workers),
      view_(remembered.view),
      kept_{view_, experiment_.editor().draft(), std::move(remembered.experiment)},
      ghosts_(kinds.creature) {
    stage_.playback().set_speed(view_.speed);
    files_.listing.folder = std::filesystem::current_path();
}

void Session::open_now(const std::filesystem::path& path, ExhibitSource source) {
    FileEvent event = load_file(path, kinds_);
    if (auto* creature = std::get_if<CreatureLoaded>(&event)) {
        show(exhibit_from(creature->document, source, path));
        if (source == ExhibitSource::kFile) log_.write("loaded", {{"path", path.string()}});
        return;
    }
    std::visit([this](auto& each) { receive(each); }, event);
}

void Session::show_newcomer() {
    const ExperimentSettings& settings = experiment_.editor().draft();
    RandomStream stream(settings.seed);
    Exhibit exhibit;
    exhibit.genome = std::make_shared<const Genome>(
        random_genome(settings.founders, kinds_.creature.catalog, stream));
    exhibit.world = settings.world;
    exhibit.goal = settings.goal;
    exhibit.expression = settings.expression;
    exhibit.title = "A random creature";
    exhibit.method = "random";
    show(std::move(exhibit));
}

void Session::update(double now, double elapsed) {
    now_ = now;
    worker_.deliver();
    for (FileEvent& event : desk_.take_events())
        std::visit([this](auto& each) { receive(each); }, event);
    experiment_.poll();
    follow_engine();
    const Stopwatch spent;
    follow_picking(elapsed);
    if (!picking_.grid_shown()) {
        stage_.playback().advance(elapsed, kPlaybackBudget);
        ghosts_.update(experiment_.snapshot(), view_.ghosts, stage_.playback(), kGhostBudget);
    }
    playback_seconds_ = spent.seconds();
    keep_stars();
    notice_ = notices_.current(now);
    if (now - kept_at_ > kMemoryInterval) keep_memory();
}

void Session::carry_out(Requests& requests) {
    highlight_ = {};
    focus_ = Place::kNone;
    for (const StudioAction& action : requests.take())
        std::visit([this](const auto& each) { apply(each); }, action);
}

FrameContext Session::frame_context() const {
    return {.kinds = kinds_,
            .fields = experiment_.fields(),
            .snapshot = experiment_.snapshot(),
            .progress = experiment_.progress(),
            .editor = experiment_.editor(),
            .playback = stage_.playback(),
            .score = stage_.score(),
            .view = view_,
            .files = files_,
            .stars = stars_,
            .notice = notice_,
            .help_shown = help_shown_,
            .viewer = viewer_,
            .highlight = highlight_,
            .ghosts = ghosts_.all(),
            .help = &help_,
            .samples = &samples_,
            .tour_step = tour_step_,
            .find_asked = find_asked_,
            .focus = focus_,
            .picking = picking_view_ ? &*picking_view_ : nullptr,
            .genes = &genes_,
            .previous_run = previous_run_};
}

bool Session::animating() const {
    const bool playing = stage_.playback().playing() && !stage_.playback().empty();
    return playing || stage_.playback().seeking() || picking_.on() || experiment_.running() ||
           !worker_.idle() || notice_ != nullptr;
}

void Session::tell(NoticeKind kind, const std::string& text) {
    notices_.tell(kind, text, now_);
    log_.write("notice", {{"text", text}, {"problem", kind == NoticeKind::kProblem}});
}

void Session::report(const Status& status) {
    if (!status) tell(NoticeKind::kProblem, status.error().message);
}

void Session::follow_engine() {
    const EvolutionSnapshot& snapshot = experiment_.snapshot();
    if (snapshot.experiment != seen_experiment_) {
        seen_experiment_ = snapshot.experiment;
        seen_champions_ = 0;
    }
    for (std::size_t i = seen_champions_; i < snapshot.champions.size(); ++i) {
        const ChampionRecord& champion = snapshot.champions[i];
        log_.write("generation", {{"number", static_cast<double>(champion.generation)},
                                  {"best", champion.individual->result.fitness}});
    }
    seen_champions_ = snapshot.champions.size();
    if (snapshot.status != seen_status_) follow_status();
    const bool followed = view_.newest_champion && !picking_.on();
    if (followed && !snapshot.champions.empty()) follow_champion();
}

void Session::follow_status() {
    const EvolutionSnapshot& snapshot = experiment_.snapshot();
    seen_status_ = snapshot.status;
    switch (seen_status_) {
        case EngineStatus::kRunning:
            log_.write("running");
            break;
        case EngineStatus::kPaused:
            log_.write("paused");
            break;
        case EngineStatus::kFailed:
            tell(NoticeKind::kProblem,
                 "Evolution stopped: " + snapshot.failure + ". Press Evolve to try again.");
            break;
    }
}

// The newest champion comes on as soon as the one before it was watched for a while; the first one
// at once.
void Session::follow_champion() {
    const Playback& playback = stage_.playback();
    if (playback.hold() != nullptr) return;
    const ChampionRecord& newest = experiment_.snapshot().champions.back();
    const bool first = playback.empty() || playback.exhibit().source != ExhibitSource::kChampion;
    const bool same = !first && playback.exhibit().genome == newest.individual->genome;
    if (!same && (first || now_ - shown_since_ > kLeastStay)) show_champion(newest);
}

void Session::show(Exhibit exhibit) {
    const std::string title = exhibit.title;
    const std::string uid = exhibit.uid;
    if (Status status = stage_.show(std::move(exhibit)); !status) return report(status);
    genes_.clear();
    shown_since_ = now_;
    log_.write("shown", {{"title", title}, {"uid", uid}});
}

void Session::show_champion(const ChampionRecord& champion) {
    Exhibit exhibit = exhibit_of(*champion.individual, *champion.settings, champion.generation,
                                 ExhibitSource::kChampion);
    exhibit.experiment = experiment_.snapshot().experiment;
    show(std::move(exhibit));
}

void Session::commit_settings() {
    report(experiment_.commit());
}

// A world changed by hand is felt on stage at once; any other edit leaves the stage alone.
void Session::follow_world(const Environment& before) {
    const Environment& after = experiment_.editor().draft().world.environment;
    if (!(after == before)) stage_.playback().set_environment(after);
}

void Session::apply(const ToggleEvolution&) {
    if (picking_.on()) return;
    if (!experiment_.running()) view_.newest_champion = true;
    experiment_.toggle();
}

void Session::apply(const RunOneGeneration&) {
    if (experiment_.running() || picking_.on()) return;
    view_.newest_champion = true;
    experiment_.step();
}

void Session::apply(const EditSettings& action) {
    const Environment before = experiment_.editor().draft().world.environment;
    experiment_.edit(action.settings, action.field);
    follow_world(before);
    log_.write("edited", {{"field", action.field}});
}

void Session::apply(const FinishEdit&) {
    commit_settings();
}

void Session::apply(const UndoEdit&) {
    if (genes_.can_undo()) {
        genes_.undo();
        log_.write("gene undone");
        return show_edited();
    }
    const Environment before = experiment_.editor().draft().world.environment;
    experiment_.undo();
    follow_world(before);
    commit_settings();
}

void Session::apply(const RedoEdit&) {
    if (genes_.can_redo()) {
        genes_.redo();
        log_.write("gene redone");
        return show_edited();
    }
    const Environment before = experiment_.editor().draft().world.environment;
    experiment_.redo();
    follow_world(before);
    commit_settings();
}

void Session::apply(const StartNewRun& action) {
    std::vector<GenomePtr> founders;
    for (const IndividualPtr& individual : experiment_.snapshot().population) {
        if (action.keep_population) founders.push_back(individual->genome);
    }
    previous_run_ = previous_run_ || (!memory_.empty() && !experiment_.snapshot().history.empty());
    report(experiment_.start_new_run(std::move(founders)));
    log_.write("new run");
}

void Session::apply(const StartFromShown&) {
    if (stage_.playback().empty()) return;
    report(experiment_.start_new_run({stage_.playback().exhibit().genome}));
    log_.write("new run");
}

void Session::apply(const DropStructuralEdits&) {
    experiment_.drop_structural_edits();
}

void Session::apply(const AddNewcomers& action) {
    experiment_.add_newcomers(action);
    log_.write("newcomers");
}

void Session::apply(const TogglePlayback&) {
    if (picking_.grid_shown()) return picking_.toggle_motion();
    stage_.playback().set_playing(!stage_.playback().playing());
}

void Session::apply(const RestartPlayback&) {
    if (picking_.grid_shown()) return picking_.restart_motion();
    stage_.playback().restart();
}

void Session::apply(const StepPlayback&) {
    stage_.playback().step();
    log_tick();
}

void Session::apply(const StepPlaybackBack&) {
    stage_.playback().step_back();
    log_tick();
}

void Session::log_tick() {
    log_.write("tick", {{"number", static_cast<double>(stage_.playback().tick_shown())}});
}

void Session::apply(const ChangeView& action) {
    view_ = action.view;
    stage_.playback().set_speed(view_.speed);
}

void Session::apply(const PokePart& action) {
    stage_.playback().poke(action.part, action.point_in_part, action.target);
}

const ChampionRecord* Session::champion_of(std::uint32_t generation) const {
    const auto& champions = experiment_.snapshot().champions;
    const auto found = std::lower_bound(
        champions.begin(), champions.end(), generation,
        [](const ChampionRecord& each, std::uint32_t wanted) { return each.generation < wanted; });
    const bool known = found != champions.end() && found->generation == generation;
    return known ? &*found : nullptr;
}

// Null for one that belongs to no generation of this experiment and has no star.
std::optional<ChampionRecord> Session::creature_on_show() const {
    if (stage_.playback().empty()) return std::nullopt;
    const Exhibit& exhibit = stage_.playback().exhibit();
    for (const ChampionRecord& starred : stars_.all()) {
        if (starred.individual->genome == exhibit.genome) return starred;
    }
    const ChampionRecord* champion = champion_of(exhibit.generation);
    if (champion == nullptr) return std::nullopt;
    if (champion->individual->genome == exhibit.genome) return *champion;
    for (const IndividualPtr& individual : experiment_.snapshot().population) {
        if (individual->genome == exhibit.genome)
            return ChampionRecord{exhibit.generation, individual, champion->settings};
    }
    return std::nullopt;
}

void Session::apply(const ShowChampion& action) {
    view_.newest_champion = false;
    const ChampionRecord* champion = champion_of(action.generation);
    if (champion == nullptr) return;
    const Playback& playback = stage_.playback();
    const bool shown = !playback.empty() && playback.exhibit().source == ExhibitSource::kChampion &&
                       playback.exhibit().generation == action.generation;
    if (!shown) show_champion(*champion);
}

void Session::apply(const ShowIndividual& action) {
    view_.newest_champion = false;
    const ChampionRecord& creature = action.creature;
    Exhibit exhibit = exhibit_of(*creature.individual, *creature.settings, creature.generation,
                                 ExhibitSource::kPopulation);
    const ChampionRecord* contemporary = champion_of(creature.generation);
    if (contemporary != nullptr && contemporary->settings == creature.settings)
        exhibit.experiment = experiment_.snapshot().experiment;
    show(std::move(exhibit));
}

void Session::apply(const ToggleStar& action) {
    stars_.toggle(action.creature);
    const Individual& individual = *action.creature.individual;
    log_.write(stars_.has(individual) ? "starred" : "star taken",
               {{"uid", uid_text(individual.uid)}});
}

void Session::apply(const ToggleStarOfShown&) {
    if (const auto creature = creature_on_show()) return apply(ToggleStar{*creature});
    tell(NoticeKind::kProblem,
         "Only creatures of this experiment can have a star; save this one "
         "to keep it.");
}

void Session::apply(const ShowNewest&) {
    view_.newest_champion = true;
    if (!experiment_.snapshot().champions.empty())
        show_champion(experiment_.snapshot().champions.back());
}

}  // namespace cambrian
