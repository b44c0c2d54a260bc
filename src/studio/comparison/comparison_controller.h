#pragma once

// Owns the comparison of settings that goes on in the background.

#include "core/threads/thread_share.h"
#include "studio/background/services.h"
#include "studio/comparison/comparison_contract.h"
#include "studio/comparison/running_comparison.h"
#include "studio/experiment/experiment_controller.h"

#include <filesystem>
#include <memory>

namespace cambrian {

class ComparisonController {
public:
    // The references in `services`, and `experiment`, must outlive the controller. Each of the
    // `threads` computes a run.
    ComparisonController(const Services& services, const ExperimentController& experiment,
                         const ThreadShare& threads);

    // Keeps comparisons in folders inside this one from now on.
    void keep_in(const std::filesystem::path& folder) { folder_ = folder; }
    // Runs whose settings say so take founders from this museum.
    void take_founders_from(const std::filesystem::path& museum) { museum_ = museum; }
    // Must be called once a frame.
    void update();
    void carry_out(const ComparisonRequest& request);
    const ComparisonView& facts() const { return facts_; }

private:
    struct Handler;
    void begin();
    Result<RunningComparison::Job> job() const;
    void end();

    Services services_;
    const ExperimentController& experiment_;
    ThreadShare threads_;
    std::filesystem::path folder_;
    std::filesystem::path museum_;
    ComparisonView facts_;
    std::unique_ptr<RunningComparison> running_;  // null if none is under way
};

}  // namespace cambrian
