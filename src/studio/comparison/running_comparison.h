#pragma once

// A comparison on threads of its own. Its runs and the champions of finished runs are in a folder;
// what is there already is not run again.

#include "comparison/comparison.h"
#include "core/threads/snapshot_channel.h"
#include "core/threads/thread_share.h"
#include "studio/comparison/comparison_results.h"

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace cambrian {

class RunningComparison {
public:
    struct Job {
        std::vector<PlannedRun> runs;
        std::vector<std::string> arms;  // in the order of the plan
        std::filesystem::path folder;
        ThreadShare threads;  // one run at a time on each
    };

    // Starts at once. `kinds` must outlive it.
    RunningComparison(Job job, const EvolutionKinds& kinds);
    // The destructor waits until the trials under way are stopped. Unfinished runs are lost.
    ~RunningComparison() = default;
    RunningComparison(const RunningComparison&) = delete;
    RunningComparison& operator=(const RunningComparison&) = delete;

    void stop() { thread_.request_stop(); }
    // Returns the latest results; null before the folder is open. For the window's thread.
    std::shared_ptr<const ComparisonResults> latest() { return channel_.latest(); }
    // Returns the share of the trials that are done.
    double share() const;

private:
    void work(const std::stop_token& stop);
    Status perform(const std::stop_token& stop);
    void publish(const std::vector<ComparedRun>& finished, bool ended, const Status& status);

    const Job job_;
    const EvolutionKinds& kinds_;
    SnapshotChannel<ComparisonResults> channel_;
    std::unique_ptr<Comparison> comparison_;         // of the thread
    std::atomic<const Comparison*> open_ = nullptr;  // the same once it is open
    std::jthread thread_;  // last member, so that it is joined before the others are destroyed
};

}  // namespace cambrian
