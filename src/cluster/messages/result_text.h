#pragma once

// Results as text: every field of EvaluationResult, bit for bit, with the id of the worker.

#include "core/result.h"
#include "evolution/evaluation/evaluation.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kLongestResultReason = 400;  // bytes

struct SlotResult {
    std::uint32_t slot = 0;
    std::uint64_t genome_hash = 0;  // of the creature that was evaluated
    EvaluationResult result;
};

// Returns the number of evaluations of the accelerations in all of them.
std::uint64_t total_work(std::span<const SlotResult> results);

// The results of one unit, or of the part of it that was finished before its deadline.
struct UnitResult {
    std::uint64_t worker = 0;  // id of the worker
    int deliveries = 1;        // deliveries of the unit so far
    double seconds = 0.0;      // s of computing on one core
    std::vector<SlotResult> results;
};

std::string write_unit_result(const UnitResult& result);
Result<UnitResult> parse_unit_result(std::string_view text);

// Write and read a single result.
std::string result_text(const EvaluationResult& result);
Result<EvaluationResult> parse_result(std::string_view text);
// Compares every bit, through the texts.
bool same_result(const EvaluationResult& a, const EvaluationResult& b);

}  // namespace cambrian
