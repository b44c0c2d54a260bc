#include "studio/widgets/column_widths.h"

#include "support/catch.h"

#include <array>
#include <numeric>

using namespace cambrian;

namespace {

// A column of sentences, one of a header whose words are long, and one of single digits.
constexpr std::array<ColumnContent, 3> kColumns{{{60, 400}, {80, 200}, {10, 10}}};

float sum(const std::vector<float>& widths) {
    return std::accumulate(widths.begin(), widths.end(), 0.0F);
}

}  // namespace

TEST_CASE("columns are as wide as their texts if all of them fit") {
    const std::vector<float> widths = column_widths(kColumns, 1220.0F);
    CHECK(widths[0] == Approx(800));
    CHECK(widths[1] == Approx(400));
    CHECK(widths[2] == Approx(20));
}

TEST_CASE("no column is narrower than its longest word while there is room for all words") {
    for (const float available : {150.0F, 151.0F, 200.0F, 400.0F, 609.0F, 610.0F, 2000.0F}) {
        const std::vector<float> widths = column_widths(kColumns, available);
        REQUIRE(widths.size() == kColumns.size());
        CHECK(sum(widths) == Approx(available));
        for (std::size_t i = 0; i < widths.size(); ++i)
            CHECK(widths[i] >= Approx(kColumns[i].longest_word));
    }
}

TEST_CASE("columns narrower than their words share the width in proportion to these") {
    const std::vector<float> widths = column_widths(kColumns, 75.0F);
    CHECK(widths[0] == Approx(30));
    CHECK(widths[1] == Approx(40));
    CHECK(widths[2] == Approx(5));
}
