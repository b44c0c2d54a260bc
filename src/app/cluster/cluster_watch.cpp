#include "app/cluster/cluster_watch.h"

#include "core/text/counted.h"
#include "persist/json/json_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <set>
#include <string>

namespace cambrian {
namespace {

constexpr int kPatience = 4;
constexpr std::size_t kMostNamed = 3;         // refused workers with a line of their own
constexpr std::size_t kMostRefused = 10'000;  // those that are counted
constexpr std::uint64_t kGrowth = 10;
constexpr auto kWatchPause = std::chrono::milliseconds(500);

// Turns states into messages and says each message once.
class ClusterNews {
public:
    explicit ClusterNews(const std::function<void(std::string_view)>& say) : say_(say) {}

    void look(const BackendStatus& status) {
        look_at_link(status.link);
        look_at_others(status);
        if (!status.trouble.empty() && said_.insert(status.trouble).second) say_(status.trouble);
        for (const WorkerStatus& worker : status.workers) {
            if (worker.state == WorkerState::kRefused) note_refused(worker);
        }
        if (status.counts.unknown > 0 && unknown_told_ == 0)
            say_("results of workers that have not announced themselves do not count");
        say_of(status.counts.unknown, unknown_told_, 1, "results of unknown workers");
        say_of(refused_.size(), refused_told_, kMostNamed, "workers are refused");
    }

    // Says the counts that have grown since they were said.
    void look_back(const BackendStatus& status) {
        look(status);
        say_last(status.counts.unknown, unknown_told_, 1, "results of unknown workers");
        say_last(refused_.size(), refused_told_, kMostNamed, "workers are refused");
    }

private:
    // Names the first of them; anyone can invent more.
    void note_refused(const WorkerStatus& worker) {
        if (refused_.size() >= kMostRefused || !refused_.insert(worker.id).second) return;
        if (refused_.size() <= kMostNamed)
            say_(fmt::format("{} is refused: {}", worker.name, worker.refusal));
    }

    // Says a count whenever it is ten times what was said; the first `named` have a line of their
    // own.
    void say_of(std::uint64_t count, std::uint64_t& told, std::uint64_t named, const char* what) {
        if (told == 0 && count > 0) told = std::min(count, named);
        if (count < kGrowth * std::max(told, named)) return;
        say_last(count, told, named, what);
    }
    void say_last(std::uint64_t count, std::uint64_t& told, std::uint64_t named, const char* what) {
        if (count <= std::max(told, named)) return;
        say_(fmt::format("{} {} so far", count, what));
        told = count;
    }

    void look_at_link(ClusterLink link) {
        if (link == link_) return;
        // Connecting takes a moment, so the message is delayed.
        if (link == ClusterLink::kConnecting && ++connecting_ < kPatience) return;
        if (link == ClusterLink::kAway) say_("cluster away, working alone");
        if (link == ClusterLink::kConnecting) say_("cluster not reached yet, working alone");
        if (link == ClusterLink::kConnected && link_ != ClusterLink::kNone)
            say_("cluster reached again");
        link_ = link;
    }

    void look_at_others(const BackendStatus& status) {
        const bool others = totals(status).machines > 1;
        if (others_ && !others && status.link == ClusterLink::kConnected)
            say_("no other machine is left, working alone");
        others_ = others;
    }

    const std::function<void(std::string_view)>& say_;
    bool others_ = false;  // whether other machines take part
    int connecting_ = 0;   // number of looks at which it was connecting
    ClusterLink link_ = ClusterLink::kNone;
    std::set<std::string> said_;
    std::set<std::string> refused_;  // ids of workers
    std::uint64_t refused_told_ = 0;
    std::uint64_t unknown_told_ = 0;
};

}  // namespace

std::string cluster_remark(const BackendStatus& status) {
    if (status.link == ClusterLink::kNone) return "";
    if (status.link != ClusterLink::kConnected) return "cluster away, working alone";
    const WorkerTotals all = totals(status);
    if (all.machines <= 1) return "no other machine, working alone";
    return fmt::format("{}, {}", counted(all.machines, "machine"), counted(all.cores, "core"));
}

ClusterWatch::ClusterWatch(const EvaluationBackend& backend,
                           std::function<void(std::string_view)> say)
    : backend_(backend),
      say_(std::move(say)),
      thread_([this](const std::stop_token& stop) { watch(stop); }) {}

void ClusterWatch::watch(const std::stop_token& stop) {
    ClusterNews news(say_);
    std::mutex mutex;
    std::condition_variable_any woken;
    std::unique_lock lock(mutex);
    while (!stop.stop_requested()) {
        news.look(backend_.status());
        woken.wait_for(lock, stop, kWatchPause, [] { return false; });
    }
    news.look_back(backend_.status());
}

std::string cluster_json(const BackendStatus& status, const BackendCounts& before) {
    const WorkerTotals all = totals(status);
    const BackendCounts& now = status.counts;
    const auto since = [](std::uint64_t later, std::uint64_t earlier) {
        return std::to_string(later - earlier);
    };
    return json_object({{"connected", json_truth(status.link == ClusterLink::kConnected)},
                        {"machines", std::to_string(all.machines)},
                        {"cores", std::to_string(all.cores)},
                        {"units", since(now.units, before.units)},
                        {"redelivered", since(now.redelivered, before.redelivered)},
                        {"duplicates", since(now.duplicates, before.duplicates)},
                        {"overdue_at_home", since(now.overdue_at_home, before.overdue_at_home)},
                        {"checked", since(now.checked, before.checked)},
                        {"refused", since(now.refused, before.refused)},
                        {"unknown", since(now.unknown, before.unknown)},
                        {"malformed", since(now.malformed, before.malformed)},
                        {"poisoned", since(now.poisoned, before.poisoned)}});
}

}  // namespace cambrian
