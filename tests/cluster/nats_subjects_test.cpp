#include "cluster/nats/nats_subjects.h"

#include <catch2/catch.hpp>

using namespace cambrian;

namespace {

const NatsSubjects kLab("lab");
const UnitId kUnit{0x00f3a1b2c4d5e6f7, 12, 345};

}  // namespace

TEST_CASE("a subject tells the unit it was made for") {
    CHECK(kLab.work(kUnit) == "lab.work.00f3a1b2c4d5e6f7.12.345");
    CHECK(kLab.result(kUnit) == "lab.result.00f3a1b2c4d5e6f7.12.345");
    for (const std::string& subject : {kLab.work(kUnit), kLab.result(kUnit)}) {
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
          "lab.work.00f3a1b2c4d5e6f7.12.3x", "........"}) {
        INFO(subject);
        CHECK_FALSE(kLab.unit_of(subject));
    }
}

TEST_CASE("the end of a run names the run") {
    CHECK(kLab.stopped_run(kLab.stop(kUnit.run)) == kUnit.run);
    CHECK_FALSE(kLab.stopped_run("lab.stop."));
    CHECK_FALSE(kLab.stopped_run("lab.stop.1"));
    CHECK_FALSE(kLab.stopped_run("other.stop.00f3a1b2c4d5e6f7"));
}
