#include "studio/background/people_words.h"

#include "support/catch.h"

namespace cambrian {
namespace {

TEST_CASE("messages have no codes and name genes as the inspector does", "[studio][people_words]") {
    CHECK(people_words("a.creature.json: E01 line 1, column 5: unexpected end") ==
          "a.creature.json: line 1, column 5: unexpected end");
    CHECK(people_words("E07 /nodes/0/width: 7 is outside [0.08, 0.96]") ==
          "part 0 width: 7 is outside [0.08, 0.96]");
    CHECK(people_words("/brain/3/in/0/w: missing") == "brain 3 in 0 w: missing");
    CHECK(people_words("/home/nodes/E01.json is too large; E1 EE01 x") ==
          "/home/nodes/E01.json is too large; E1 EE01 x");
}

}  // namespace
}  // namespace cambrian
