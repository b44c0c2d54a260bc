#include "picking/session_log.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

void SessionLog::decide(double time, bool branches_off) {
    ++decisions;
    if (branches_off) ++branches;
    decision_seconds.push_back(std::fmax(time - shown_since, 0.0));
    shown_since = time;
}

void SessionLog::go_back(double time) {
    ++backs;
    shown_since = time;
}

double median_decision_seconds(const SessionLog& log) {
    std::vector<double> sorted = log.decision_seconds;
    if (sorted.empty()) return 0.0;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t middle = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

}  // namespace cambrian
