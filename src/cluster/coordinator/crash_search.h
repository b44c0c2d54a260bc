#pragma once

// Evaluates creatures in separate processes. If one of these crashes, it finds the creature that
// causes it by bisection and writes its genome and world to a file.

#include "cluster/messages/result_text.h"
#include "cluster/units/unit_child.h"
#include "evolution/evaluation/evaluation.h"
#include "evolution/kinds/evolution_kinds.h"

#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

struct Apart {
    std::vector<SlotResult> results;
    // Message if no process could be started, gave a result or could be understood.
    std::string trouble;
    std::string failure;  // message if a creature crashes every process that evaluates it
};

class CrashSearch {
public:
    CrashSearch(const EvolutionKinds& kinds, const ChildProcess& child, const std::string& settings,
                const std::filesystem::path& folder)
        : kinds_(kinds), child_(child), settings_(settings), folder_(folder) {}

    // Needs at least one request. Results are missing only after a stop request, with `trouble` or
    // after a failure.
    Apart compute(std::span<const EvaluationRequest> requests, const std::stop_token& stop) const;

private:
    void compute_part(std::span<const EvaluationRequest> requests, const std::stop_token& stop,
                      Apart& apart) const;
    static void take_answer(std::string_view output, std::span<const EvaluationRequest> requests,
                            Apart& apart);
    std::string describe(const EvaluationRequest& request, const std::string& cause) const;

    const EvolutionKinds& kinds_;
    const ChildProcess& child_;
    const std::string& settings_;  // text (judging_settings.h)
    const std::filesystem::path& folder_;
};

}  // namespace cambrian
