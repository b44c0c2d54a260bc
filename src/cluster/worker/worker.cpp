#include "cluster/worker/worker.h"

#include "cluster/messages/hello_text.h"
#include "cluster/messages/judging_settings.h"
#include "cluster/messages/proof_set.h"
#include "cluster/messages/text_for_people.h"
#include "cluster/messages/unit_text.h"
#include "cluster/units/recent_work.h"
#include "cluster/units/unit_work.h"
#include "cluster/worker/settings_cache.h"
#include "core/stopwatch.h"
#include "persist/text/digest_text.h"
#include "simulator/simulator_version.h"

#include <fmt/core.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

using std::chrono::milliseconds;

constexpr std::size_t kUnitsACore = 2;  // one being computed, one waiting
constexpr milliseconds kLongestWait{250};
constexpr milliseconds kRepeatAfter{100};
constexpr milliseconds kWithoutSettings{1'000};
constexpr milliseconds kNotForThisBuild{5'000};
constexpr double kProgressEvery = 2.0;  // s
constexpr int kMostPublishing = 10;     // attempts to publish a result
// Time in s for which the refusal is reported after the last refused unit.
constexpr double kRefusalShown = 10.0;
constexpr double kRefusalHeeded = 3.0 * kHelloEvery;  // s after a run has said it last
constexpr std::size_t kMostRunsTold = 64;             // runs about which a message was printed

// A unit that the worker has taken.
struct InHand {
    Delivery delivery;
    bool begun = false;
    double deadline = 0.0;  // on the worker's clock, set when begun
    std::stop_source stop;
};
using InHandPtr = std::shared_ptr<InHand>;

class Worker {
public:
    Worker(const EvolutionKinds& kinds, WorkerQueue& queue, const WorkerOptions& options)
        : kinds_(kinds),
          queue_(queue),
          options_(options),
          proof_trials_(proof_trials(kinds)),
          proof_(proof_of(proof_trials_)) {}

    void run(const std::stop_token& stop);

private:
    // Runs on the calling thread: it fetches units, sends hellos and watches deadlines.
    void fetch();
    void keep_in_hand();
    void listen();
    void hear(const Hello& hello);
    void heed(std::uint64_t run, const std::string& reason);
    // Returns why that run refuses this worker now; empty if it does not.
    std::string refusal_by(std::uint64_t run);
    void watch_link();
    void say_hello(bool leaving);
    void give_back_waiting();
    void stop_begun();

    // Runs on one thread for each core.
    void serve_core(const std::stop_token& stop);
    InHandPtr take();
    void work_on(InHand& unit, const std::stop_token& stop);
    // Returns the reason why this build does not compute the unit; empty if it does.
    std::string mismatch(const UnitOutline& outline) const;
    SettingsPtr settings_for(InHand& unit, std::uint64_t key);
    bool publish(const UnitMessage& message, const std::stop_token& stop);
    void note_done(std::size_t creatures, std::uint64_t work);
    void refuse_unit(const InHand& unit, const std::string& why);
    void discard(const InHand& unit, const std::string& why);
    void tell_once(std::uint64_t run, const std::string& line);

    const EvolutionKinds& kinds_;
    WorkerQueue& queue_;
    const WorkerOptions& options_;
    const std::vector<ProofTrial> proof_trials_;
    const std::uint64_t proof_;
    const Stopwatch clock_;
    SettingsCache settings_;

    std::mutex mutex_;  // guards the following members
    std::condition_variable_any changed_;
    std::list<InHandPtr> in_hand_;
    std::size_t waiting_ = 0;  // units in hand that are not begun
    RecentWork recent_;
    RecentSum recent_units_;
    std::set<std::pair<std::uint64_t, std::string>> told_;
    std::string refusal_;  // reason of refused units, reported for kRefusalShown after refused_at_
    double refused_at_ = 0.0;
    // Runs that say they refuse this worker, with the reason and the time until which this holds.
    struct Refused {
        std::string reason;
        double until = 0.0;  // on the worker's clock
    };
    std::map<std::uint64_t, Refused> refused_by_;

    std::set<std::uint64_t> known_runs_;  // used by the calling thread
    bool was_connected_ = false;
    double next_hello_ = 0.0;
    double next_progress_ = 0.0;

    std::vector<std::jthread> cores_;  // last member, since they use the others
};

void Worker::run(const std::stop_token& stop) {
    for (std::size_t core = 0; core < options_.threads.workers; ++core)
        cores_.emplace_back([this](const std::stop_token& end) {
            take_priority(options_.threads.priority);
            serve_core(end);
        });
    const std::stop_callback wake(stop, [this] { changed_.notify_all(); });
    while (!stop.stop_requested()) {
        watch_link();
        listen();
        keep_in_hand();
        if (clock_.seconds() >= next_hello_) say_hello(false);
        fetch();
    }
    give_back_waiting();
    for (std::jthread& core : cores_)
        core.request_stop();
    stop_begun();
    cores_.clear();
    say_hello(true);
}

void Worker::watch_link() {
    const bool connected = queue_.connected();
    if (connected != was_connected_ && options_.say)
        options_.say(connected ? "connected" : "lost the connection, trying again");
    if (connected && !was_connected_) next_hello_ = 0.0;
    was_connected_ = connected;
}

// Fetches at most two units per core, so that a core has its next unit while another one is
// fetched.
void Worker::fetch() {
    std::size_t wanted = 0;
    {
        std::unique_lock lock(mutex_);
        const auto has_room = [this] {
            return in_hand_.size() < kUnitsACore * options_.threads.workers;
        };
        changed_.wait_for(lock, kLongestWait, has_room);
        if (!has_room()) return;
        wanted = kUnitsACore * options_.threads.workers - in_hand_.size();
    }
    std::vector<Delivery> deliveries = queue_.fetch(wanted, kLongestWait);
    const std::lock_guard lock(mutex_);
    for (Delivery& delivery : deliveries) {
        auto unit = std::make_shared<InHand>();
        unit->delivery = std::move(delivery);
        in_hand_.push_back(std::move(unit));
        ++waiting_;
    }
    changed_.notify_all();
}

void Worker::keep_in_hand() {
    const double now = clock_.seconds();
    std::vector<InHandPtr> units;
    {
        const std::lock_guard lock(mutex_);
        units.assign(in_hand_.begin(), in_hand_.end());
        for (const InHandPtr& unit : units) {
            if (unit->begun && now > unit->deadline) unit->stop.request_stop();
        }
    }
    if (now < next_progress_) return;
    next_progress_ = now + kProgressEvery;
    for (const InHandPtr& unit : units)
        queue_.in_progress(unit->delivery.ticket);
}

void Worker::listen() {
    const WorkerNews news = queue_.poll();
    for (const std::string& text : news.hellos) {
        if (const Result<Hello> hello = parse_hello(text)) hear(*hello);
    }
    for (const std::string& complaint : news.complaints) {
        if (options_.say) options_.say(complaint);
    }
    const std::lock_guard lock(mutex_);
    for (const std::uint64_t run : news.ended_runs) {
        known_runs_.erase(run);
        for (const InHandPtr& unit : in_hand_) {
            if (unit->delivery.unit.id.run == run) unit->stop.request_stop();
        }
    }
}

void Worker::hear(const Hello& hello) {
    if (hello.role != Hello::Role::kCoordinator) return;
    if (known_runs_.size() < kMostRunsTold && known_runs_.insert(hello.id).second) {
        next_hello_ = 0.0;  // announces the worker to a new run at once
        if (hello.simulator == kSimulatorVersion && hello.proof != proof_)
            tell_once(hello.id,
                      fmt::format("run {}: this machine's bits differ in {}", hex_text(hello.id),
                                  differing_trials(hello.trials, proof_trials_)));
    }
    for (const Refusal& refusal : hello.refusals) {
        if (refusal.worker != options_.id) continue;
        heed(hello.id, refusal.reason);
    }
}

// The worker goes on for other runs, since anyone who may announce a run could say this.
void Worker::heed(std::uint64_t run, const std::string& reason) {
    tell_once(run, fmt::format("run {} refuses this worker: {}", hex_text(run), reason));
    const double now = clock_.seconds();
    const std::lock_guard lock(mutex_);
    std::erase_if(refused_by_, [now](const auto& entry) { return entry.second.until < now; });
    if (refused_by_.size() < kMostRunsTold || refused_by_.contains(run))
        refused_by_[run] = {reason, now + kRefusalHeeded};
}

std::string Worker::refusal_by(std::uint64_t run) {
    const std::lock_guard lock(mutex_);
    const auto found = refused_by_.find(run);
    if (found == refused_by_.end() || found->second.until < clock_.seconds()) return {};
    return "refuses this worker: " + found->second.reason;
}

void Worker::say_hello(bool leaving) {
    const double now = clock_.seconds();
    next_hello_ = now + kHelloEvery;
    Hello hello = introduction(Hello::Role::kWorker, options_.id, options_.name,
                               options_.threads.workers, proof_);
    hello.leaving = leaving;
    {
        const std::lock_guard lock(mutex_);
        hello.busy = static_cast<int>(in_hand_.size() - waiting_);
        hello.creatures_per_second = recent_.creatures_per_second(now);
        hello.work_per_second = recent_.work_per_second(now);
        hello.units_per_second = recent_units_.rate(now, kRateSeconds);
        if (now - refused_at_ < kRefusalShown) hello.refused = refusal_;
    }
    queue_.say_hello(hex_text(options_.id), hello_text(hello));
}

void Worker::give_back_waiting() {
    const std::lock_guard lock(mutex_);
    std::erase_if(in_hand_, [this](const InHandPtr& unit) {
        if (unit->begun) return false;
        queue_.give_back(unit->delivery.ticket, milliseconds(0));
        --waiting_;
        return true;
    });
}

// Ends units that are begun; what is left of each is given back.
void Worker::stop_begun() {
    const std::lock_guard lock(mutex_);
    for (const InHandPtr& unit : in_hand_)
        unit->stop.request_stop();
}

void Worker::serve_core(const std::stop_token& stop) {
    while (true) {
        InHandPtr unit;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return waiting_ > 0; })) return;
            unit = take();
        }
        work_on(*unit, stop);
        const std::lock_guard lock(mutex_);
        in_hand_.remove(unit);
        changed_.notify_all();
    }
}

InHandPtr Worker::take() {
    const auto unit = std::find_if(in_hand_.begin(), in_hand_.end(),
                                   [](const InHandPtr& each) { return !each->begun; });
    (*unit)->begun = true;
    (*unit)->deadline = clock_.seconds() + 3'600.0;  // until the unit's own deadline is known
    --waiting_;
    return *unit;
}

void Worker::work_on(InHand& unit, const std::stop_token& stop) {
    const UnitMessage& message = unit.delivery.unit;
    if (stop.stop_requested()) return queue_.give_back(unit.delivery.ticket, milliseconds(0));
    if (unit.stop.stop_requested()) return queue_.discard(unit.delivery.ticket);
    if (const std::string why = refusal_by(message.id.run); !why.empty())
        return refuse_unit(unit, why);
    const Result<UnitOutline> outline = parse_unit_outline(message.body);
    if (!outline) return discard(unit, outline.error().message);
    const std::string why = mismatch(*outline);
    if (!why.empty()) return refuse_unit(unit, why);
    const SettingsPtr settings = settings_for(unit, outline->terms.settings);
    if (settings == nullptr) return;
    UnitReader reader(kinds_);
    const Result<Unit> read = reader.read(message.body);
    if (!read) return discard(unit, read.error().message);
    {
        const std::lock_guard lock(mutex_);
        unit.deadline = clock_.seconds() + read->terms.deadline;
    }
    UnitResult result = compute_unit(*read, *settings, kinds_, unit.stop.get_token());
    result.worker = options_.id;
    result.deliveries = unit.delivery.times;
    const bool whole = result.results.size() == read->requests.size();
    const bool stored =
        result.results.empty() || publish({message.id, write_unit_result(result)}, stop);
    if (whole && stored)
        queue_.acknowledge(unit.delivery.ticket);
    else
        queue_.give_back(unit.delivery.ticket, milliseconds(0));
    note_done(result.results.size(), total_work(result.results));
}

std::string Worker::mismatch(const UnitOutline& outline) const {
    if (outline.version != kUnitVersion)
        return fmt::format("wants units of version {}, this is {}", outline.version, kUnitVersion);
    if (outline.terms.simulator != kSimulatorVersion)
        return fmt::format("wants simulator {}, this is {}",
                           text_for_people(outline.terms.simulator, kLongestName),
                           kSimulatorVersion);
    if (outline.terms.proof != proof_) return "gets other bits in the proof trials";
    return {};
}

// Returns null if the settings cannot be read; the unit is then discarded or given back.
SettingsPtr Worker::settings_for(InHand& unit, std::uint64_t key) {
    if (SettingsPtr known = settings_.find(key)) return known;
    const FetchedSettings fetched = queue_.fetch_settings(hex_text(key));
    if (fetched.state != SettingsState::kFound) {
        queue_.give_back(unit.delivery.ticket, kWithoutSettings);
        return nullptr;
    }
    Result<SettingsPtr> read = settings_.add(key, fetched.text, kinds_);
    if (read) return *read;
    discard(unit, read.error().message);
    return nullptr;
}

// Stores the result before it acknowledges the unit; in the other order a crash would lose the
// result. If the server can be reached but rejects the result, there are only a few attempts; if it
// cannot be reached, they continue until it answers.
bool Worker::publish(const UnitMessage& message, const std::stop_token& stop) {
    if (message.body.size() > kMostResultBytes) return false;
    for (int tried = 0; tried < kMostPublishing;) {
        if (queue_.publish_result(message)) return true;
        if (stop.stop_requested() || queue_.connected()) ++tried;
        std::this_thread::sleep_for(kRepeatAfter);
    }
    return false;
}

void Worker::note_done(std::size_t creatures, std::uint64_t work) {
    const std::lock_guard lock(mutex_);
    recent_.add(clock_.seconds(), creatures, work);
    recent_units_.add(1.0, clock_.seconds());
}

void Worker::refuse_unit(const InHand& unit, const std::string& why) {
    const std::uint64_t run = unit.delivery.unit.id.run;
    queue_.give_back(unit.delivery.ticket, kNotForThisBuild);
    tell_once(run, fmt::format("run {} {}", hex_text(run), why));
    const std::lock_guard lock(mutex_);
    refusal_ = why;
    refused_at_ = clock_.seconds();
}

void Worker::discard(const InHand& unit, const std::string& why) {
    const std::uint64_t run = unit.delivery.unit.id.run;
    queue_.discard(unit.delivery.ticket);
    tell_once(run, fmt::format("run {} sent what cannot be read: {}", hex_text(run),
                               text_for_people(why, kLongestReason)));
}

void Worker::tell_once(std::uint64_t run, const std::string& line) {
    if (!options_.say) return;
    {
        const std::lock_guard lock(mutex_);
        if (told_.size() >= kMostRunsTold || !told_.emplace(run, line).second) return;
    }
    options_.say(line);
}

}  // namespace

void work_for_cluster(const EvolutionKinds& kinds, WorkerQueue& queue, const WorkerOptions& options,
                      const std::stop_token& stop) {
    Worker(kinds, queue, options).run(stop);
}

}  // namespace cambrian
