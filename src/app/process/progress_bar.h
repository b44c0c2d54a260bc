#pragma once

// How far an evolution is, as a line on a terminal.

#include "app/process/progress_line.h"
#include "core/result.h"
#include "evolution/evaluation/evaluation_backend.h"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace cambrian {

class ProgressBar {
public:
    // progress counts the trials of one generation and must outlive the bar.
    // remark: asked for again and again from another thread; what is shown behind the numbers.
    ProgressBar(const EvaluationProgress& progress, std::uint32_t generations,
                std::function<std::string()> remark = {});

    // A generation is complete: prints its line above the bar. Fails if standard output does.
    Status finish_generation(std::string_view line);
    // A message that appears above the bar. Any thread.
    void say_above(std::string_view message);

private:
    std::string text() const;
    std::string numbers() const;

    const EvaluationProgress& progress_;
    const std::uint32_t generations_;
    const std::function<std::string()> remark_;  // may be none
    std::uint32_t finished_ = 0;     // generations; changed while the line is interrupted
    std::uint64_t trials_done_ = 0;  // of finished generations; likewise
    ProgressLine line_;              // last: asks for the text
};

}  // namespace cambrian
