#pragma once

// Results as text: every field of EvaluationResult, bit for bit, with the name of who computed
// them.

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
    std::uint64_t genome_hash = 0;  // of the creature that was judged
    EvaluationResult result;
};

// Evaluations of the accelerations that all of them took.
std::uint64_t total_work(std::span<const SlotResult> results);

// Of one unit, or of the part of it that was finished before its deadline.
struct UnitResult {
    std::uint64_t worker = 0;  // its id
    int deliveries = 1;        // of the unit, so far
    double seconds = 0.0;      // s of one core that computing took
    std::vector<SlotResult> results;
};

std::string write_unit_result(const UnitResult& result);
Result<UnitResult> parse_unit_result(std::string_view text);

// One result alone.
std::string result_text(const EvaluationResult& result);
// Every bit of them, by their texts.
bool same_result(const EvaluationResult& a, const EvaluationResult& b);

}  // namespace cambrian
