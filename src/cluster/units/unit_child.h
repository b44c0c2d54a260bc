#pragma once

// Computes a unit in a separate process, because its workers disappeared and it may have crashed
// them. `cambrian worker --unit` reads the question on standard input and writes the answer on
// standard output.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

namespace cambrian {

struct ChildEnd {
    bool crashed = false;  // ended by a signal, for example after a failed assertion
    std::string cause;     // message: "signal 6 (Aborted)"
    std::string output;    // standard output, if it did not crash
};

// Starts the process, passes the question and waits for its end. After a stop request it ends the
// process, and the result is meaningless. Returns an Error if the process cannot be started, or if
// it ended with a message instead of an answer. Several threads may call it at the same time.
using ChildProcess =
    std::function<Result<ChildEnd>(std::string_view question, const std::stop_token& stop)>;

// Returns the unit and the settings to compute it with, in the form that the process reads.
std::string question_text(std::string_view settings, std::string_view unit);

// The work of the process: returns the answer, a unit's result (result_text.h), to the question
// read from standard input. Fails if the text is not a question of this version.
Result<std::string> answer_question(std::string_view question, const EvolutionKinds& kinds);

}  // namespace cambrian
