#pragma once

// Computes a unit in a separate process, because its workers vanished and it may have crashed them.
// `cambrian worker --unit` reads the question on standard input and writes the answer on standard
// output.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

namespace cambrian {

struct ChildEnd {
    bool crashed = false;  // ended by a signal, as a failed assertion does too
    std::string cause;     // for people: "signal 6 (Aborted)"
    std::string output;    // what it wrote on standard output if it did not crash
};

// Starts the process, gives it the question, waits until it ends; ends it as soon as a stop is
// asked for, and then returns anything. An Error if none can be started, or if it ended with a
// message of its own instead of an answer. Several threads may call it at the same time.
using ChildProcess =
    std::function<Result<ChildEnd>(std::string_view question, const std::stop_token& stop)>;

// The unit and the settings it is to be computed under, as the process reads them.
std::string question_text(std::string_view settings, std::string_view unit);

// What the process does: the question as read to the end of standard input, the answer to write.
// It is a unit's result (result_text.h).
// Fails with a message if that was no question of this version.
Result<std::string> answer_question(std::string_view question, const EvolutionKinds& kinds);

}  // namespace cambrian
