// Ground of other programs.
#include "persist/settings/ground_import.h"

#include "support/catch.h"
#include "world/terrain.h"

#include <fmt/format.h>

using namespace cambrian;

namespace {

// A world of 5 columns: floors of 1 voxel, a step of 2, and an empty column at the end.
std::string world(const std::string& objects) {
    return fmt::format(R"({{"grid_width": 5, "grid_height": 4, "objects": {{{}}}}})", objects);
}

const char* const kStep =
    R"("ground": {"indices": [0, 1, 2, 3, 8], "types": [5, 5, 5, 5, 5], "neighbors": {}})";

std::string fault_of(const Result<std::string>& ground) {
    return ground ? std::string() : ground.error().message;
}

std::string voxels_fault(const std::string& objects, LooseVoxels loose = LooseVoxels::kRefused) {
    return fault_of(ground_of_voxels(world(objects), 0.2, loose));
}

}  // namespace

TEST_CASE("the tops of fixed voxels become ground", "[persist][terrain]") {
    const auto points = ground_of_voxels(world(kStep), 0.2, LooseVoxels::kRefused);
    REQUIRE(points);
    TerrainSettings settings;
    settings.kind = "drawn";
    settings.points = *points;
    const auto ground = Terrain::make(settings);
    REQUIRE(ground);
    CHECK((*ground)->height(0.0) == 0.0);
    CHECK((*ground)->height(-0.4) == 0.0);
    CHECK((*ground)->height(0.2) == Approx(0.2));
    CHECK((*ground)->height(0.4) == Approx(-2.2));  // the pit
}

TEST_CASE("worlds that are no ground are refused with their fault", "[persist][terrain]") {
    const auto object = [](const char* indices, const char* types) {
        return fmt::format(R"("box": {{"indices": [{}], "types": [{}]}})", indices, types);
    };
    CHECK_THAT(fault_of(ground_of_voxels("{", 0.2, LooseVoxels::kRefused)),
               Catch::Contains("the world"));
    CHECK_THAT(fault_of(ground_of_voxels("{}", 0.2, LooseVoxels::kRefused)),
               Catch::Contains("grid_width"));
    CHECK_THAT(voxels_fault(""), Catch::Contains("no fixed voxels"));
    CHECK_THAT(voxels_fault(object("0, 1", "5")), Catch::Contains("of one length"));
    CHECK_THAT(voxels_fault(object("20", "5")), Catch::Contains("outside the grid"));
    CHECK_THAT(voxels_fault(object("0", "6")), Catch::Contains("unknown type 6"));
    CHECK_THAT(voxels_fault(object("0, 0", "5, 5")), Catch::Contains("where another one is"));
    CHECK_THAT(voxels_fault(object("0", "2")), Catch::Contains("\"box\" moves"));
    CHECK_THAT(voxels_fault(object("0, 10", "5, 5")), Catch::Contains("above air"));
    CHECK(voxels_fault(object("0, 1, 10", "5, 5, 5"), LooseVoxels::kDropped).empty());
    CHECK_THAT(
        fault_of(ground_of_voxels(R"({"grid_width": 10000000, "grid_height": 1, "objects": {}})",
                                  0.2, LooseVoxels::kRefused)),
        Catch::Contains("from 1 to 900"));
}

TEST_CASE("tables of points name the line that is wrong", "[persist][terrain]") {
    const auto points = ground_of_table("0,0\r\n1,0.5\r\n");
    REQUIRE(points);
    CHECK(*points == "0 0; 1 0.5");
    CHECK_THAT(fault_of(ground_of_table("x,y\n0,0\n1,1\n")), Catch::Contains("line 1"));
    CHECK_THAT(fault_of(ground_of_table("0,0\n1,5,0\n")), Catch::Contains("line 2"));
    CHECK_THAT(fault_of(ground_of_table("0\n1\n")), Catch::Contains("line 1"));
    CHECK_THAT(fault_of(ground_of_table("0,0\n-1,1\n")), Catch::Contains("left of"));
    CHECK_THAT(fault_of(ground_of_table("")), Catch::Contains("at least 2"));
}
