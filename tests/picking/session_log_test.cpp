#include "picking/session_log.h"

#include "support/catch.h"

using namespace cambrian;

TEST_CASE("decisions are timed from the command that led to their grid", "[picking][log]") {
    SessionLog log;
    CHECK(median_decision_seconds(log) == 0.0);
    log.shown_since = 100.0;
    log.decide(110.0, false);
    log.decide(114.0, false);
    log.go_back(120.0);
    log.decide(121.0, true);
    CHECK(log.decision_seconds == std::vector<double>{10.0, 4.0, 1.0});
    CHECK(median_decision_seconds(log) == 4.0);
    log.decide(123.0, false);
    CHECK(median_decision_seconds(log) == 3.0);
    CHECK(log.decisions == 4);
    CHECK(log.branches == 1);
    CHECK(log.backs == 1);
}

TEST_CASE("a clock that goes backwards gives no negative times", "[picking][log]") {
    SessionLog log;
    log.decide(5.0, false);
    log.decide(1.0, false);
    CHECK(log.decision_seconds == std::vector<double>{5.0, 0.0});
}
