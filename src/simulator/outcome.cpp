#include "simulator/outcome.h"

namespace cambrian {

std::string_view outcome_name(Outcome outcome) {
    switch (outcome) {
        case Outcome::kCompleted:
            return "completed";
        case Outcome::kStoppedEarly:
            return "stopped-early";
        case Outcome::kRejected:
            return "rejected";
        case Outcome::kDiverged:
            return "diverged";
        case Outcome::kCheated:
            return "cheated";
    }
    return "unknown";
}

}  // namespace cambrian
