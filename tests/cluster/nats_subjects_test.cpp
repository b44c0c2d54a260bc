#include "cluster/nats/nats_subjects.h"

#include <catch2/catch.hpp>

using namespace cambrian;

namespace {

const NatsSubjects kLab("lab");
const UnitId kUnit{0x00f3a1b2c4d5e6f7, 12, 345};

}  // namespace

TEST_CASE("a subject tells the unit it was made for") {
    CHECK(kLab.work(kUnit) == "lab.work.00f3a1b2c4d5e6f7.12.345");
    CHECK(kLab.result(kUnit, "two") == "lab.result.00f3a1b2c4d5e6f7.12.345.two");
    for (const std::string& subject : {kLab.work(kUnit), kLab.result(kUnit, "two")}) {
        const auto unit = kLab.unit_of(subject);
        REQUIRE(unit);
        CHECK(*unit == kUnit);
    }
}

TEST_CASE("subjects of nobody's are told from those of units") {
    for (const char* subject :
         {"", "lab", "lab.work", "lab.work.", "other.work.00f3a1b2c4d5e6f7.12.345",
          "lab.hello.00f3a1b2c4d5e6f7.12.345", "lab.work.f3a1b2c4d5e6f7.12.345",
          "lab.work.00f3a1b2c4d5e6f7.12", "lab.work.00f3a1b2c4d5e6f7.12.345.6",
          "lab.work.00f3a1b2c4d5e6f7.-1.345", "lab.work.00f3a1b2c4d5e6f7.12.4294967296",
          "lab.work.00f3a1b2c4d5e6f7..345", "lab.work.00f3a1b2c4d5e6g7.12.345",
          "lab.work.00f3a1b2c4d5e6f7.12.3x", "lab.result.00f3a1b2c4d5e6f7.12.345",
          "lab.result.00f3a1b2c4d5e6f7.12.345.", "lab.result.00f3a1b2c4d5e6f7.12.345.a.b",
          "........"}) {
        INFO(subject);
        CHECK_FALSE(kLab.unit_of(subject));
    }
}

TEST_CASE("a subject tells the login of who may publish on it") {
    CHECK(kLab.login_of(kLab.result(kUnit, "two")) == "two");
    CHECK(kLab.login_of(kLab.worker_hello("two", "00f3a1b2c4d5e6f7")) == "two");
    for (const std::string& subject :
         {kLab.work(kUnit), kLab.coordinator_hello("00f3a1b2c4d5e6f7"), std::string(),
          std::string("lab.hello.worker.two"), std::string("lab.result.1.2.3.two.x"),
          std::string("lab.result.1.2.3"), std::string("other.result.1.2.3.two")}) {
        INFO(subject);
        CHECK(kLab.login_of(subject).empty());
    }
}

TEST_CASE("the end of a run names the run") {
    CHECK(kLab.stopped_run(kLab.stop(kUnit.run)) == kUnit.run);
    CHECK_FALSE(kLab.stopped_run("lab.stop."));
    CHECK_FALSE(kLab.stopped_run("lab.stop.1"));
    CHECK_FALSE(kLab.stopped_run("other.stop.00f3a1b2c4d5e6f7"));
}
