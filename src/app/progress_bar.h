#pragma once

// How far an evolution is, as a line on a terminal.

#include "app/progress_line.h"
#include "core/result.h"
#include "evolution/evaluation_backend.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace cambrian {

class ProgressBar {
public:
    // progress counts the trials of one generation and must outlive the bar.
    ProgressBar(const EvaluationProgress& progress, std::uint32_t generations);

    // A generation is complete: prints its line above the bar. Fails if standard output does.
    Status finish_generation(std::string_view line);

private:
    std::string text() const;

    const EvaluationProgress& progress_;
    const std::uint32_t generations_;
    std::uint32_t finished_ = 0;     // generations; changed while the line is interrupted
    std::uint64_t trials_done_ = 0;  // of finished generations; likewise
    ProgressLine line_;              // last: asks for the text
};

}  // namespace cambrian
