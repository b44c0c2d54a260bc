#include "cluster/memory_work_queue.h"

#include "core/random.h"

#include <condition_variable>
#include <list>
#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace cambrian::test {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

}  // namespace

struct StoredUnit {
    std::string body;
    int times = 0;
    Clock::time_point not_before = Clock::now();  // earliest time of the next delivery
    std::uint64_t ticket = 0;                     // number of the last delivery
};

struct StoredResult {
    UnitMessage message;
    Clock::time_point not_before = Clock::now();
};

struct MemoryServer::State {
    explicit State(const Faults& given) : faults(given), random(given.seed) {}

    Faults faults;
    std::mutex mutex;
    std::condition_variable changed;
    bool running = true;
    std::uint64_t run = 0;
    std::uint64_t next_ticket = 1;
    std::size_t deliveries = 0;
    RandomStream random;
    std::function<void(std::string&)> change_result;
    std::map<UnitId, StoredUnit> units;
    std::set<UnitId> published;
    std::list<StoredResult> results;
    std::map<std::string, std::string> settings;
    CoordinatorNews coordinator_news;
    std::map<int, WorkerNews> worker_news;  // by worker

    bool chance(double probability) { return probability > 0.0 && random.chance(probability); }

    void store_result(const UnitMessage& message) {
        const auto delay = faults.longest_delay.count() == 0
                               ? 0
                               : random.between(0, static_cast<int>(faults.longest_delay.count()));
        results.push_back({message, Clock::now() + milliseconds(delay)});
        changed.notify_all();
    }

    // Moves the results that are due to the coordinator's news.
    void deliver_results() {
        for (auto each = results.begin(); each != results.end();) {
            if (each->not_before > Clock::now()) {
                ++each;
                continue;
            }
            if (each->message.id.run == run) coordinator_news.results.push_back(each->message);
            each = results.erase(each);
        }
        if (faults.reorders) random.shuffle(std::span(coordinator_news.results));
    }

    void erase_units(std::uint64_t of_run, std::optional<std::uint32_t> generation) {
        std::erase_if(units, [&](const auto& entry) {
            return entry.first.run == of_run &&
                   (!generation || entry.first.generation == *generation);
        });
    }

    // Returns a unit that is due; units that were delivered too often are reported instead.
    std::map<UnitId, StoredUnit>::iterator next_unit() {
        std::vector<std::map<UnitId, StoredUnit>::iterator> ready;
        for (auto unit = units.begin(); unit != units.end(); ++unit) {
            if (unit->second.not_before > Clock::now()) continue;
            if (unit->second.times == faults.most_deliveries) {
                unit->second.not_before = Clock::time_point::max();
                coordinator_news.not_deliverable.push_back(unit->first);
                changed.notify_all();
                continue;
            }
            ready.push_back(unit);
        }
        if (ready.empty()) return units.end();
        return faults.reorders ? random.pick(ready) : ready.front();
    }

    StoredUnit* delivered(std::uint64_t ticket) {
        for (auto& [id, unit] : units) {
            if (unit.ticket == ticket) return &unit;
        }
        return nullptr;
    }
};

namespace {

using State = MemoryServer::State;

class MemoryCoordinatorQueue final : public CoordinatorQueue {
public:
    explicit MemoryCoordinatorQueue(std::shared_ptr<State> state) : state_(std::move(state)) {}

    bool connected() const override {
        const std::lock_guard lock(state_->mutex);
        return state_->running;
    }
    void begin_run(std::uint64_t run) override {
        const std::lock_guard lock(state_->mutex);
        state_->run = run;
        state_->erase_units(run, std::nullopt);
        state_->coordinator_news = {};
    }
    bool put_settings(std::string_view key, std::string_view text) override {
        const std::lock_guard lock(state_->mutex);
        if (state_->running) state_->settings[std::string(key)] = text;
        return state_->running;
    }
    Publishing publish(const UnitMessage& unit) override {
        const std::lock_guard lock(state_->mutex);
        if (unit.body.size() > state_->faults.most_bytes) return Publishing::kTooLarge;
        if (!state_->running || state_->units.size() >= state_->faults.most_units)
            return Publishing::kWait;
        if (state_->published.insert(unit.id).second) state_->units[unit.id] = {.body = unit.body};
        state_->changed.notify_all();
        return Publishing::kAccepted;
    }
    CoordinatorNews poll(milliseconds longest) override {
        std::unique_lock lock(state_->mutex);
        const auto end = Clock::now() + longest;
        while (true) {
            if (state_->running) state_->deliver_results();
            if ((state_->running && !state_->coordinator_news.empty()) || Clock::now() >= end)
                break;
            // Results become due without a notification.
            state_->changed.wait_until(lock, std::min(end, Clock::now() + milliseconds(2)));
        }
        if (!state_->running) return {};
        return std::exchange(state_->coordinator_news, {});
    }
    void withdraw(const UnitId& unit) override {
        const std::lock_guard lock(state_->mutex);
        state_->units.erase(unit);
    }
    void withdraw_generation(std::uint64_t run, std::uint32_t generation) override {
        const std::lock_guard lock(state_->mutex);
        state_->erase_units(run, generation);
    }
    void end_run(std::uint64_t run) override {
        const std::lock_guard lock(state_->mutex);
        state_->erase_units(run, std::nullopt);
        state_->results.clear();
        for (auto& [worker, news] : state_->worker_news)
            news.ended_runs.push_back(run);
    }
    void say_hello(std::string_view, std::string_view text) override {
        const std::lock_guard lock(state_->mutex);
        if (!state_->running) return;
        for (auto& [worker, news] : state_->worker_news)
            news.hellos.emplace_back(text);
    }

private:
    std::shared_ptr<State> state_;
};

class MemoryWorkerQueue final : public WorkerQueue {
public:
    MemoryWorkerQueue(std::shared_ptr<State> state, std::string login)
        : state_(std::move(state)), login_(std::move(login)) {
        const std::lock_guard lock(state_->mutex);
        number_ = static_cast<int>(state_->next_ticket++);
        state_->worker_news[number_];
    }
    ~MemoryWorkerQueue() override {
        const std::lock_guard lock(state_->mutex);
        state_->worker_news.erase(number_);
    }

    bool connected() const override {
        const std::lock_guard lock(state_->mutex);
        return state_->running;
    }
    std::vector<Delivery> fetch(std::size_t most, milliseconds longest) override {
        std::unique_lock lock(state_->mutex);
        std::vector<Delivery> deliveries;
        const auto end = Clock::now() + longest;
        while (deliveries.empty() && Clock::now() < end) {
            while (state_->running && deliveries.size() < most && deliver(deliveries)) {
            }
            if (deliveries.empty())
                state_->changed.wait_until(lock, std::min(end, Clock::now() + milliseconds(20)));
        }
        return deliveries;
    }
    void in_progress(std::uint64_t ticket) override {
        const std::lock_guard lock(state_->mutex);
        if (StoredUnit* unit = state_->delivered(ticket))
            unit->not_before = Clock::now() + state_->faults.patience;
    }
    void acknowledge(std::uint64_t ticket) override {
        const std::lock_guard lock(state_->mutex);
        if (!state_->running) return;
        std::erase_if(state_->units,
                      [&](const auto& entry) { return entry.second.ticket == ticket; });
    }
    void give_back(std::uint64_t ticket, milliseconds delay) override {
        const std::lock_guard lock(state_->mutex);
        if (StoredUnit* unit = state_->delivered(ticket)) unit->not_before = Clock::now() + delay;
        state_->changed.notify_all();
    }
    void discard(std::uint64_t ticket) override { acknowledge(ticket); }
    bool publish_result(const UnitMessage& result) override {
        const std::lock_guard lock(state_->mutex);
        if (!state_->running) return false;
        if (state_->chance(state_->faults.lost_result)) return true;
        UnitMessage message = result;
        message.login = login_;
        if (state_->change_result) state_->change_result(message.body);
        const int copies = state_->chance(state_->faults.repeated_result) ? 2 : 1;
        for (int copy = 0; copy < copies; ++copy)
            state_->store_result(message);
        return true;
    }
    FetchedSettings fetch_settings(std::string_view key) override {
        const std::lock_guard lock(state_->mutex);
        if (!state_->running) return {};
        const auto found = state_->settings.find(std::string(key));
        if (found == state_->settings.end()) return {SettingsState::kMissing, {}};
        return {SettingsState::kFound, found->second};
    }
    WorkerNews poll() override {
        const std::lock_guard lock(state_->mutex);
        return std::exchange(state_->worker_news[number_], {});
    }
    void say_hello(std::string_view, std::string_view text) override {
        const std::lock_guard lock(state_->mutex);
        if (!state_->running) return;
        state_->coordinator_news.hellos.push_back({std::string(text), login_});
        state_->changed.notify_all();
    }

private:
    // Returns false if there is no unit. A lost delivery counts, since the server believes it was
    // made.
    bool deliver(std::vector<Delivery>& deliveries) {
        const auto unit = state_->next_unit();
        if (unit == state_->units.end()) return false;
        StoredUnit& stored = unit->second;
        ++state_->deliveries;
        ++stored.times;
        stored.ticket = state_->next_ticket++;
        const bool repeated = state_->chance(state_->faults.repeated_delivery);
        stored.not_before = Clock::now() + (repeated ? milliseconds(0) : state_->faults.patience);
        if (state_->chance(state_->faults.lost_delivery)) return true;
        deliveries.push_back({{unit->first, stored.body}, stored.times, stored.ticket});
        return true;
    }

    std::shared_ptr<State> state_;
    const std::string login_;
    int number_ = 0;
};

}  // namespace

MemoryServer::MemoryServer(const Faults& faults) : state_(std::make_shared<State>(faults)) {}
MemoryServer::~MemoryServer() = default;

std::unique_ptr<CoordinatorQueue> MemoryServer::coordinator() {
    return std::make_unique<MemoryCoordinatorQueue>(state_);
}

std::unique_ptr<WorkerQueue> MemoryServer::worker(std::string login) {
    return std::make_unique<MemoryWorkerQueue>(state_, std::move(login));
}

void MemoryServer::set_running(bool running) {
    const std::lock_guard lock(state_->mutex);
    state_->running = running;
    state_->changed.notify_all();
}

void MemoryServer::change_results(std::function<void(std::string& body)> change) {
    const std::lock_guard lock(state_->mutex);
    state_->change_result = std::move(change);
}

void MemoryServer::inject_unit(const UnitMessage& unit) {
    const std::lock_guard lock(state_->mutex);
    state_->units[unit.id] = {.body = unit.body};
    state_->changed.notify_all();
}

void MemoryServer::inject_result(const UnitMessage& result) {
    const std::lock_guard lock(state_->mutex);
    state_->store_result(result);
}

void MemoryServer::inject_hello(const std::string& text, const std::string& login) {
    const std::lock_guard lock(state_->mutex);
    state_->coordinator_news.hellos.push_back({text, login});
    for (auto& [worker, news] : state_->worker_news)
        news.hellos.push_back(text);
    state_->changed.notify_all();
}

std::size_t MemoryServer::stored_units() const {
    const std::lock_guard lock(state_->mutex);
    return state_->units.size();
}

std::size_t MemoryServer::deliveries() const {
    const std::lock_guard lock(state_->mutex);
    return state_->deliveries;
}

std::uint64_t MemoryServer::run() const {
    const std::lock_guard lock(state_->mutex);
    return state_->run;
}

}  // namespace cambrian::test
