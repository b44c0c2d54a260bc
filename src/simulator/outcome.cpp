#include "simulator/outcome.h"

namespace cambrian {

bool is_invalid(Outcome outcome) {
    return outcome == Outcome::kDiverged || outcome == Outcome::kDisqualified ||
           outcome == Outcome::kOverBudget;
}

int shortfall(Outcome outcome) {
    switch (outcome) {
        case Outcome::kCompleted:
            return 0;
        case Outcome::kStoppedEarly:
            return 1;
        case Outcome::kRejected:
            return 2;
        default:
            return 3;
    }
}

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
        case Outcome::kDisqualified:
            return "cheated";
        case Outcome::kOverBudget:
            return "over-budget";
        case Outcome::kInterrupted:
            return "interrupted";
    }
    return "unknown";
}

}  // namespace cambrian
