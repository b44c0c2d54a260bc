#include "cluster/coordinator/cluster_backend.h"

#include "cluster/coordinator/batch.h"
#include "cluster/coordinator/crash_search.h"
#include "cluster/coordinator/disagreement.h"
#include "cluster/coordinator/worker_roster.h"
#include "cluster/messages/hello_text.h"
#include "cluster/messages/judging_settings.h"
#include "cluster/messages/proof_set.h"
#include "cluster/messages/unit_text.h"
#include "core/stopwatch.h"
#include "core/thread_time.h"
#include "core/threads/thread_pool.h"
#include "evolution/evaluation/longest_first.h"
#include "evolution/evaluation/trials.h"
#include "persist/text/digest_text.h"
#include "simulator/simulator_version.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <numeric>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kLongestPoll{50};
constexpr milliseconds kLongestNap{50};
constexpr std::size_t kWantedUnitBytes = 512'000;  // well below the default limit of servers
class ClusterBackend final : public EvaluationBackend {
public:
    ClusterBackend(const EvolutionKinds& kinds, std::unique_ptr<CoordinatorQueue> queue,
                   ClusterOptions options);
    ~ClusterBackend() override;

    bool evaluate(std::span<const EvaluationRequest> requests,
                  std::span<std::optional<EvaluationResult>> results,
                  const ExperimentSettings& settings, EvaluationProgress& progress,
                  std::stop_token stop) override;
    BackendStatus status() const override;

private:
    // Data that the threads of one call of evaluate() share.
    struct Call {
        const ExperimentSettings& settings;
        std::optional<JudgingSettings> judging;  // none if they cannot travel
        EvaluationProgress& progress;
        std::uint32_t done_before = 0;
        std::stop_source ended;  // stops all computations that still run
        std::unique_ptr<Batch> batch;
    };

    std::optional<JudgingSettings> travelling(const ExperimentSettings& settings);
    bool run(Call& call, const std::stop_token& stop);

    // The part of a call that one core of this machine does.
    void serve_core(Call& call, const std::stop_token& stop);
    void perform(Call& call, const Batch::HomeTask& task);
    void compute_here(Call& call, std::size_t creature);
    void compute_apart(Call& call, const std::vector<std::size_t>& creatures);
    void after_change(Call& call);  // mutex_ is held

    // Runs on the dispatcher's thread.
    void dispatch(const std::stop_token& stop);
    void watch_link();
    void say_hello();
    void take(CoordinatorNews news);
    void take_result(const UnitMessage& message);
    void note_malformed() {
        const std::lock_guard lock(mutex_);
        ++memory_.counts.malformed;
    }

    void store_settings();
    // Publishes as many units as are wanted now; the caller holds publishing_.
    void publish_units();
    bool publish_unit(Call& call);
    Cores cores() const;  // mutex_ is held
    bool is_of_call(const UnitId& id) const {
        return call_ != nullptr && id.run == options_.run &&
               id.generation == call_->batch->generation();
    }
    void fail(std::string why) {  // mutex_ is held
        if (failure_.empty()) failure_ = std::move(why);
        changed_.notify_all();
    }
    double now() const { return clock_.seconds(); }

    const EvolutionKinds& kinds_;
    const ClusterOptions options_;
    const std::vector<ProofTrial> proof_trials_;
    const std::uint64_t proof_;
    const Stopwatch clock_;
    const std::unique_ptr<CoordinatorQueue> queue_;
    ThreadPool pool_;
    std::mutex evaluating_;  // one call at a time; guards the next
    KeptJudgingSettings judging_;

    std::mutex publishing_;  // guards the writer and the end of a call; taken before mutex_
    UnitWriter writer_;

    mutable std::mutex mutex_;  // guards all below
    std::condition_variable changed_;
    Call* call_ = nullptr;
    std::optional<std::uint64_t> stored_settings_;  // key of what the server has
    std::uint32_t calls_ = 0;
    Batch::Memory memory_;
    WorkerRoster roster_;
    ClusterLink link_ = ClusterLink::kConnecting;
    std::string complaint_;
    std::string failure_;
    double useful_cores_ = 0.0;

    std::jthread dispatcher_;  // last: uses everything above
};

ClusterBackend::ClusterBackend(const EvolutionKinds& kinds, std::unique_ptr<CoordinatorQueue> queue,
                               ClusterOptions options)
    : kinds_(kinds),
      options_(std::move(options)),
      proof_trials_(proof_trials(kinds)),
      proof_(proof_of(proof_trials_)),
      queue_(std::move(queue)),
      pool_(options_.threads.workers, options_.threads.priority),
      writer_(kinds),
      memory_{.trust = Trust(options_.secret)},
      roster_({std::string(kSimulatorVersion), proof_}, options_.name, options_.threads.workers) {
    queue_->begin_run(options_.run);
    dispatcher_ = std::jthread([this](const std::stop_token& stop) { dispatch(stop); });
}

ClusterBackend::~ClusterBackend() {
    dispatcher_.request_stop();
    dispatcher_.join();
    queue_->end_run(options_.run);
}

bool ClusterBackend::evaluate(std::span<const EvaluationRequest> requests,
                              std::span<std::optional<EvaluationResult>> results,
                              const ExperimentSettings& settings, EvaluationProgress& progress,
                              std::stop_token stop) {
    const std::lock_guard one_at_a_time(evaluating_);
    const std::vector<std::size_t> open = open_longest_first(requests, results);
    std::vector<EvaluationRequest> ordered;
    for (const std::size_t i : open)
        ordered.push_back(requests[i]);
    const auto done_before = static_cast<std::uint32_t>(requests.size() - open.size());
    progress.done = done_before;
    progress.total = static_cast<std::uint32_t>(requests.size());
    Call call{.settings = settings,
              .judging = travelling(settings),
              .progress = progress,
              .done_before = done_before,
              .ended = {},
              .batch = nullptr};
    {
        const std::lock_guard lock(mutex_);
        call.batch = std::make_unique<Batch>(std::move(ordered), ++calls_, memory_);
    }
    const bool whole = run(call, stop);
    for (std::size_t place = 0; place < open.size(); ++place) {
        const EvaluationResult* result = call.batch->result(place);
        if (result != nullptr) results[open[place]] = *result;
    }
    return whole;
}

// Returns the settings that are sent to workers.
std::optional<JudgingSettings> ClusterBackend::travelling(const ExperimentSettings& settings) {
    const Result<JudgingSettings>& judging = judging_.of(settings, kinds_);
    if (judging) return *judging;
    const std::lock_guard lock(mutex_);
    complaint_ = judging.error().message;
    return std::nullopt;
}

bool ClusterBackend::run(Call& call, const std::stop_token& stop) {
    const double begun = now();
    {
        const std::lock_guard lock(mutex_);
        call_ = &call;
    }
    const std::stop_callback wake(stop, [&] {
        call.ended.request_stop();
        const std::lock_guard lock(mutex_);
        changed_.notify_all();
    });
    pool_.parallel_for(options_.threads.workers,
                       [&](std::size_t, std::size_t) { serve_core(call, stop); });
    bool whole = false;
    bool left = false;
    {
        const std::scoped_lock both(publishing_, mutex_);
        call_ = nullptr;
        whole = failure_.empty() && call.batch->complete();
        left = call.batch->anything_outstanding();
        const double work = call.batch->core_seconds();
        if (whole && work > 0.0)
            useful_cores_ = useful_cores_of_batch(work, now() - begun, cores());
    }
    if (left) queue_->withdraw_generation(options_.run, call.batch->generation());
    return whole;
}

void ClusterBackend::serve_core(Call& call, const std::stop_token& stop) {
    if (std::unique_lock publishing(publishing_, std::try_to_lock); publishing) publish_units();
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested() && failure_.empty() && !call.batch->complete()) {
        const double moment = now();
        if (const auto task = call.batch->next_home_task(moment, cores())) {
            if (task->silent_since) roster_.doubt_silent(*task->silent_since);
            lock.unlock();
            perform(call, *task);
            lock.lock();
            continue;
        }
        const double due = call.batch->next_due().value_or(moment + 1.0) - moment;
        const auto nap = std::chrono::duration<double>(std::max(due, 1e-3));
        changed_.wait_for(lock, std::min<std::chrono::duration<double>>(nap, kLongestNap));
    }
    call.ended.request_stop();
    changed_.notify_all();
}

void ClusterBackend::perform(Call& call, const Batch::HomeTask& task) {
    if (task.late && options_.child) return compute_apart(call, task.creatures);
    for (const std::size_t creature : task.creatures) {
        if (call.ended.stop_requested()) return;
        compute_here(call, creature);
    }
}

void ClusterBackend::compute_here(Call& call, std::size_t creature) {
    const double begun = now();
    ThreadTimer timer;
    EvaluationResult result = evaluate_in_trials(call.batch->requests()[creature], call.settings,
                                                 kinds_, call.ended.get_token());
    if (result.outcome == Outcome::kInterrupted) return;
    const double moment = now();
    const Batch::Took took{.processor = timer.lap(), .wall = moment - begun};
    const std::lock_guard lock(mutex_);
    roster_.worked_at_home(1, result.work, moment);
    call.batch->finish_at_home(creature, std::move(result), took);
    after_change(call);
}

void ClusterBackend::compute_apart(Call& call, const std::vector<std::size_t>& creatures) {
    const CrashSearch search{kinds_, options_.child, call.judging->text, options_.crash_folder};
    Apart apart = search.compute(call.batch->requests_of(creatures), call.ended.get_token());
    {
        const std::lock_guard lock(mutex_);
        ++memory_.counts.poisoned;
        for (SlotResult& each : apart.results) {
            roster_.worked_at_home(1, each.result.work, now());
            call.batch->finish_at_home(each.slot, std::move(each.result), {});
        }
        if (!apart.trouble.empty()) complaint_ = apart.trouble;
        if (!apart.failure.empty()) fail(std::move(apart.failure));
        after_change(call);
    }
    if (apart.trouble.empty()) return;
    for (const std::size_t creature : creatures)
        compute_here(call, creature);
}

void ClusterBackend::after_change(Call& call) {
    call.progress.done = call.done_before + static_cast<std::uint32_t>(call.batch->settled());
    Disagreement found = judge_disagreement(memory_.other_bits, roster_);
    if (!found.failure.empty()) fail(std::move(found.failure));
    if (!found.complaint.empty()) complaint_ = std::move(found.complaint);
    changed_.notify_all();
}

Cores ClusterBackend::cores() const {
    const bool usable = link_ == ClusterLink::kConnected;
    return {options_.threads.workers, usable ? roster_.cores(now(), memory_.trust) : 0};
}

// Only the dispatcher's thread may wait for the server; the other threads evaluate.
void ClusterBackend::store_settings() {
    std::optional<JudgingSettings> wanted;
    {
        const std::lock_guard lock(mutex_);
        const bool missing = call_ != nullptr && call_->judging && cores().remote > 0 &&
                             stored_settings_ != call_->judging->key;
        if (missing) wanted = call_->judging;
    }
    if (!wanted || !queue_->put_settings(hex_text(wanted->key), wanted->text)) return;
    const std::lock_guard lock(mutex_);
    stored_settings_ = wanted->key;
}

void ClusterBackend::publish_units() {
    Call* call = nullptr;
    {
        const std::lock_guard lock(mutex_);
        const bool wanted = call_ != nullptr && call_->judging && failure_.empty() &&
                            stored_settings_ == call_->judging->key;
        if (wanted) call = call_;
    }
    while (call != nullptr && publish_unit(*call)) {
    }
}

bool ClusterBackend::publish_unit(Call& call) {
    std::optional<Batch::UnitPlan> plan;
    {
        const std::lock_guard lock(mutex_);
        plan = call.batch->next_unit(now(), cores());
    }
    if (!plan) return false;
    const UnitTerms terms{.settings = call.judging->key,
                          .simulator = std::string(kSimulatorVersion),
                          .proof = proof_,
                          .deadline = unit_deadline(plan->seconds)};
    UnitMessage message{{options_.run, call.batch->generation(), plan->number},
                        writer_.write(terms, call.batch->requests_of(plan->creatures))};
    const bool divisible = plan->creatures.size() > 1;
    const Publishing outcome = divisible && message.body.size() > kWantedUnitBytes
                                   ? Publishing::kTooLarge
                                   : queue_->publish(message);
    if (outcome == Publishing::kAccepted) return true;
    const std::lock_guard lock(mutex_);
    if (outcome == Publishing::kTooLarge)
        call.batch->too_large(*plan);
    else
        call.batch->not_published(plan->number);
    changed_.notify_all();
    return outcome == Publishing::kTooLarge;
}

// Beside evaluations in the background there is a window, which must not wait for messages.
void ClusterBackend::dispatch(const std::stop_token& stop) {
    if (options_.threads.priority == ThreadPriority::kBackground)
        take_priority(ThreadPriority::kServing);
    double next_hello = 0.0;
    while (!stop.stop_requested()) {
        take(queue_->poll(kLongestPoll));
        watch_link();
        store_settings();
        if (const std::lock_guard publishing(publishing_); true) publish_units();
        if (now() < next_hello) continue;
        next_hello = now() + kHelloEvery;
        say_hello();
    }
}

void ClusterBackend::watch_link() {
    const bool connected = queue_->connected();
    const std::lock_guard lock(mutex_);
    const bool was_connected = link_ == ClusterLink::kConnected;
    if (connected == was_connected) return;
    if (connected) {
        link_ = ClusterLink::kConnected;
        complaint_.clear();
        stored_settings_.reset();  // the server may have lost its store
    } else {
        link_ = ClusterLink::kAway;
    }
    changed_.notify_all();
}

void ClusterBackend::say_hello() {
    Hello hello = introduction(Hello::Role::kCoordinator, options_.run, options_.name,
                               options_.threads.workers, proof_);
    hello.trials = proof_trials_;
    {
        const std::lock_guard lock(mutex_);
        hello.busy = call_ != nullptr ? hello.cores : 0;
        hello.refusals = memory_.trust.refusals();
    }
    queue_->say_hello(hex_text(options_.run), hello_text(hello));
}

void ClusterBackend::take(CoordinatorNews news) {
    for (const HeardHello& heard : news.hellos) {
        const Result<Hello> hello = parse_hello(heard.text);
        if (!hello) {
            note_malformed();
            continue;
        }
        const std::lock_guard lock(mutex_);
        roster_.hear(*hello, heard.login, now(), memory_.trust);
    }
    for (const UnitMessage& message : news.results)
        take_result(message);
    const std::lock_guard lock(mutex_);
    for (const UnitId& id : news.not_published) {
        if (is_of_call(id)) call_->batch->not_published(id.unit);
    }
    for (const UnitId& id : news.not_deliverable) {
        if (is_of_call(id)) call_->batch->not_deliverable(id.unit);
        queue_->withdraw(id);
    }
    memory_.counts.malformed += news.garbage;
    if (!news.complaints.empty()) complaint_ = std::move(news.complaints.back());
    if (!news.empty()) changed_.notify_all();
}

void ClusterBackend::take_result(const UnitMessage& message) {
    const Result<UnitResult> result = parse_unit_result(message.body);
    if (!result) return note_malformed();
    const std::lock_guard lock(mutex_);
    if (!is_of_call(message.id)) return;
    if (!roster_.counts(result->worker, message.login)) {
        ++memory_.counts.unknown;
        return;
    }
    const auto taken = call_->batch->take_result(message.id.unit, *result, now(), cores());
    if (!taken) {
        ++memory_.counts.malformed;
        return;
    }
    roster_.worked(result->worker, taken->creatures, taken->work, now());
    after_change(*call_);
}

BackendStatus ClusterBackend::status() const {
    const std::lock_guard lock(mutex_);
    BackendStatus status;
    status.link = link_;
    status.server = options_.server;
    status.cluster = options_.cluster;
    status.trouble = complaint_;
    status.failure = failure_;
    status.workers =
        roster_.rows(now(), memory_.trust,
                     {.own_busy = call_ != nullptr, .reachable = link_ == ClusterLink::kConnected});
    status.counts = memory_.counts;
    status.useful_cores = useful_cores_;
    return status;
}

}  // namespace

std::unique_ptr<EvaluationBackend> make_cluster_backend(const EvolutionKinds& kinds,
                                                        std::unique_ptr<CoordinatorQueue> queue,
                                                        ClusterOptions options) {
    return std::make_unique<ClusterBackend>(kinds, std::move(queue), std::move(options));
}

}  // namespace cambrian
