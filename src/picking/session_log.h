#pragma once

// What a session of picking came to (picking/README.md 2). It has no clock: commands bring times.

#include <vector>

namespace cambrian {

struct SessionLog {
    int decisions = 0;  // breeding, newcomers, assistance
    int branches = 0;   // decisions where another one had been made before
    int waits = 0;      // decisions whose grid was not ready at once
    int backs = 0;
    int saves = 0;
    // s, of each decision: from the command that led to the grid to the decision itself.
    std::vector<double> decision_seconds;
    double shown_since = 0.0;  // s, on the user's clock

    void decide(double time, bool branches_off);
    void go_back(double time);
};

double median_decision_seconds(const SessionLog& log);  // 0 before the first

}  // namespace cambrian
