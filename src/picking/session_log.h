#pragma once

// Statistics of a session of picking (picking/README.md 2). It has no clock; commands carry times.

#include <vector>

namespace cambrian {

struct SessionLog {
    int decisions = 0;  // breeding, random creatures or assistance
    int branches = 0;   // decisions on a grid that already had another child
    int waits = 0;      // decisions whose grid was not ready at once
    int backs = 0;
    int saves = 0;
    // For each decision, the time in s since the command that displayed its grid.
    std::vector<double> decision_seconds;
    double shown_since = 0.0;  // s, on the user's clock

    void decide(double time, bool branches_off);
    void go_back(double time);
};

double median_decision_seconds(const SessionLog& log);  // s; 0 before the first decision

}  // namespace cambrian
