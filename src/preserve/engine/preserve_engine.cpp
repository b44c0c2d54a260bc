#include "preserve/engine/preserve_engine.h"

#include <algorithm>
#include <exception>
#include <variant>

namespace cambrian {
namespace {

constexpr double kPictureInterval = 1.0 / 30.0;  // s
constexpr std::size_t kMostDeaths = 200;
constexpr std::size_t kMostNews = 16;

}  // namespace

PreserveEngine::PreserveEngine(PreserveStart start, const ThreadShare& threads)
    : start_(std::move(start)), threads_(threads) {
    shown_.kept = start_.log != nullptr;
    shown_.series = std::make_shared<const std::vector<SeriesRow>>(std::move(start_.series));
    shown_.museum = std::make_shared<const std::vector<MuseumPiece>>(std::move(start_.museum));
    shown_.died = std::make_shared<const std::vector<Life>>();
    shown_.snapshots = std::make_shared<const std::vector<std::uint64_t>>(
        start_.log ? start_.log->snapshots() : std::vector<std::uint64_t>());
    publish();
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

PreserveEngine::~PreserveEngine() {
    thread_.request_stop();
    thread_.join();
}

void PreserveEngine::run(const std::stop_token& stop) {
    ThreadPool pool(threads_.workers, threads_.priority);
    while (!stop.stop_requested())
        guard([&] { work(pool, stop); });
    guard([&] { obey(); });
    guard([&] { keep(); });
}

void PreserveEngine::work(ThreadPool& pool, const std::stop_token& stop) {
    obey();
    if (!shown_.playing && !single_tick_) {
        inbox_.wait(stop);
        return;
    }
    inbox_.work_until_command(
        stop, [&](const std::stop_token& interrupted) { advance(pool, interrupted); });
}

template <class Work>
void PreserveEngine::guard(const Work& work) {
    try {
        work();
    } catch (const std::exception& failure) {
        shown_.broken = true;
        stop_with(failure.what());
        publish();
    }
}

// Obeys all commands that have arrived.
void PreserveEngine::obey() {
    const bool commanded = inbox_.drain([this](PreserveCommand command) {
        std::visit([this](const auto& each) { apply(each); }, command);
    });
    if (commanded) publish();
}

void PreserveEngine::advance(ThreadPool& pool, const std::stop_token& interrupted) {
    if (std::exchange(single_tick_, false)) {
        tick(pool);
        return publish();
    }
    while (shown_.playing && pacing_.wait(interrupted)) {
        tick(pool);
        pacing_.count();
        if (published_.seconds() >= kPictureInterval) publish();
    }
    if (!shown_.playing) publish();
}

void PreserveEngine::tick(ThreadPool& pool) {
    start_.preserve->tick(pool);
    take_chronicle();
    if (start_.preserve->ticks() % kTicksPerSnapshot == 0) write();
}

void PreserveEngine::take_chronicle() {
    Chronicle chronicle = start_.preserve->take_chronicle();
    if (!chronicle.died.empty()) {
        std::vector<Life> died = *shown_.died;
        died.insert(died.end(), chronicle.died.begin(), chronicle.died.end());
        if (died.size() > kMostDeaths)
            died.erase(died.begin(), died.end() - std::ptrdiff_t{kMostDeaths});
        shown_.died = std::make_shared<const std::vector<Life>>(std::move(died));
    }
    if (!chronicle.series.empty()) {
        std::vector<SeriesRow> series = *shown_.series;
        series.insert(series.end(), chronicle.series.begin(), chronicle.series.end());
        shown_.series = std::make_shared<const std::vector<SeriesRow>>(std::move(series));
    }
    if (!chronicle.museum.empty()) {
        std::vector<MuseumPiece> museum = *shown_.museum;
        add_pieces(museum, chronicle.museum);
        shown_.museum = std::make_shared<const std::vector<MuseumPiece>>(std::move(museum));
    }
    if (start_.log) append(unwritten_, std::move(chronicle));
}

// Writes what happened. After a failure it remains unwritten, and the preserve is paused.
void PreserveEngine::write() {
    if (!start_.log) return;
    if (const Status written = start_.log->write(unwritten_, *start_.preserve); !written)
        return stop_with(written.error().message);
    unwritten_ = {};
    if (const Status kept = unwritten_pins_ ? start_.log->keep_pins(*unwritten_pins_) : Status();
        !kept)
        return stop_with(kept.error().message);
    unwritten_pins_.reset();
    shown_.snapshots = std::make_shared<const std::vector<std::uint64_t>>(start_.log->snapshots());
}

// A rest is an intervention, so that replays have it, too. A preserve at its snapshot needs none.
void PreserveEngine::keep() {
    const Preserve& preserve = *start_.preserve;
    if (!start_.log || shown_.broken) return;
    const bool changed =
        preserve.snapshot_tick() != preserve.ticks() || !unwritten_.interventions.empty();
    if (changed) {
        static_cast<void>(start_.preserve->intervene({.what = intervention::kRest}));
        take_chronicle();
    }
    write();
}

void PreserveEngine::stop_with(std::string failure) {
    shown_.playing = false;
    shown_.failure = std::move(failure);
}

void PreserveEngine::tell(PreserveNews news) {
    news.id = shown_.news.empty() ? 1 : shown_.news.back().id + 1;
    shown_.news.push_back(std::move(news));
    if (shown_.news.size() > kMostNews) shown_.news.erase(shown_.news.begin());
}

void PreserveEngine::apply(PlayPreserve command) {
    if (shown_.broken) return;
    shown_.playing = command.playing;
    shown_.failure.clear();
    pacing_.begin();
}

void PreserveEngine::apply(StepPreserve) {
    if (shown_.broken) return;
    shown_.playing = false;
    single_tick_ = true;
}

void PreserveEngine::apply(PacePreserve command) {
    pacing_.set(command.factor);
}

void PreserveEngine::apply(const Intervene& command) {
    const Result<std::uint64_t> done = shown_.broken
                                           ? Result<std::uint64_t>(Error{shown_.failure})
                                           : start_.preserve->intervene(command.intervention);
    tell({.what = command.intervention.what,
          .number = done ? *done : 0,
          .problem = done ? std::string() : done.error().message});
    take_chronicle();
}

void PreserveEngine::apply(KeepPins command) {
    unwritten_pins_ = std::move(command.pins);
}

void PreserveEngine::apply(WatchBrain command) {
    camera_.watch(command.creature);
}

void PreserveEngine::publish() {
    auto picture = std::make_shared<PreservePicture>(shown_);
    camera_.take(*start_.preserve, *picture);
    picture->pace = pacing_.factor();
    picture->factor = shown_.playing ? pacing_.reached() : 0.0;
    pictures_.publish(std::move(picture));
    published_.restart();
}

}  // namespace cambrian
