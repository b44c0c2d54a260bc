#include "app/cluster/cluster_watch.h"

#include "core/text/counted.h"
#include "persist/json/json_text.h"

#include <fmt/core.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>

namespace cambrian {
namespace {

constexpr int kPatience = 4;
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
            if (worker.state != WorkerState::kRefused) continue;
            const std::string words = fmt::format("{} is refused: {}", worker.name, worker.refusal);
            if (said_.insert(words).second) say_(words);
        }
    }

private:
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
    news.look(backend_.status());
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
                        {"malformed", since(now.malformed, before.malformed)},
                        {"poisoned", since(now.poisoned, before.poisoned)}});
}

}  // namespace cambrian
