#include "comparison/run_table.h"

#include "support/catch.h"
#include "support/temporary_directory.h"

using namespace cambrian;

namespace {

ComparedRun full_row() {
    ComparedRun row;
    row.world = "walking";
    row.arm = "selection.survival=0.1";
    row.seed = 999'999'999'999'999;
    row.trials = 4000;
    row.settings = "00f3a1b2c4d5e6f7";
    row.simulator = "1.1";
    row.score = 0.1 + 0.2;
    row.confirmed = -1e-300;
    row.finer = 1.0 / 3.0;
    row.jump_height = 0.35;
    row.parts = 5;
    row.lines = 4;
    row.plans = 8;
    row.generations = 61;
    row.evaluations = 4013;
    row.audited = 99;
    row.survivors = 1;
    row.time_saved = 0.27;
    row.seconds = 12.5;
    row.curve = {{300, 0.0}, {4013, 0.1 + 0.2}};
    return row;
}

std::string message_of(const std::string& text) {
    const auto runs = parse_run_table(text, "runs.csv");
    return runs ? "no error" : runs.error().message;
}

}  // namespace

TEST_CASE("a table of runs is read back with every bit", "[comparison]") {
    ComparedRun second = full_row();
    second.arm = "other";
    second.curve.clear();
    const std::vector<ComparedRun> runs = {full_row(), second};
    const auto read = parse_run_table(run_table_csv(runs), "runs.csv");
    REQUIRE(read);
    CHECK(*read == runs);
    CHECK(run_table_csv(*read) == run_table_csv(runs));
}

TEST_CASE("a missing table has no runs", "[comparison]") {
    const TemporaryDirectory folder;
    const auto read = load_run_table(folder / "runs.csv");
    REQUIRE(read);
    CHECK(read->empty());
}

TEST_CASE("what is no table of runs is refused with the line", "[comparison]") {
    CHECK(message_of("") == "runs.csv: line 1: expected a table of compared runs");
    CHECK(message_of("a,b\n1,2\n") == "runs.csv: line 1: expected a table of compared runs");
    const std::string text = run_table_csv({full_row(), full_row()});
    CHECK(message_of(text.substr(0, text.size() - 5)) == "runs.csv: line 3: is no run");
    std::string words = text;
    words.replace(words.find("0.35"), 4, "high");
    CHECK(message_of(words) == "runs.csv: line 2: is no run");
}
