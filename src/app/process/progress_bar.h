#pragma once

// The progress of an evolution as a line on the terminal.

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
    // `progress` counts the trials of one generation and must outlive the object. Of all
    // generations, `known` were finished before. `remark` returns the text behind the numbers; it
    // is called repeatedly on another thread.
    ProgressBar(const EvaluationProgress& progress, std::uint32_t generations, std::uint32_t known,
                std::function<std::string()> remark = {});

    // Prints the line of a finished generation above the bar. Fails if standard output fails.
    Status finish_generation(std::string_view line);
    // Prints a message above the bar. May be called on any thread.
    void say_above(std::string_view message);

private:
    std::string text() const;
    std::string numbers() const;

    const EvaluationProgress& progress_;
    const std::uint32_t generations_;
    const std::uint32_t known_;
    const std::function<std::string()> remark_;  // may be empty
    std::uint32_t finished_ = 0;  // of the others; changes only while the line is interrupted
    // In finished generations; changes only while the line is interrupted.
    std::uint64_t trials_done_ = 0;
    ProgressLine line_;  // last member, since it reads the others
};

}  // namespace cambrian
