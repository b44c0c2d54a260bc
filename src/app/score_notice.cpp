#include "app/score_notice.h"

#include "app/messages.h"
#include "persist/rescoring.h"

namespace cambrian {

void say_of_simulator(const std::string& file, const CreatureDocument& document) {
    if (!document.scored) return;
    if (const auto other = other_simulator(*document.scored))
        say(file + ": " + *other + "; 'cambrian rescore' scores it with this one");
}

}  // namespace cambrian
