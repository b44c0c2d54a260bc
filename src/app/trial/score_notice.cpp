#include "app/trial/score_notice.h"

#include "app/process/messages.h"
#include "persist/creature/rescoring.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

void say_other(const std::string& file, const std::optional<std::string>& other) {
    if (other) say(fmt::format("{}: {}; 'cambrian rescore' scores it with this one", file, *other));
}

}  // namespace

void say_of_simulator(const std::string& file, const CreatureDocument& document) {
    say_other(file, other_simulator(document));
}

void say_of_simulator(const std::string& file, const SavedExperiment& saved) {
    say_other(file, other_simulator(saved));
}

}  // namespace cambrian
