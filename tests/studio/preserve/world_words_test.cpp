#include "studio/preserve/world_words.h"

#include "genome/creature_name.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

namespace cambrian {
namespace {

TEST_CASE("the living, and the dead in sight, are called by their names", "[studio][preserve]") {
    const GenomePtr genome = test::crawler(test::kinds().creature.catalog);
    PreservePicture picture;
    picture.residents.resize(1);
    picture.residents.front().life = {.number = 4, .genome = genome};
    picture.museum = std::make_shared<const std::vector<MuseumPiece>>(
        std::vector<MuseumPiece>{{.number = 2, .genome = genome}});
    picture.died = std::make_shared<const std::vector<Life>>(
        std::vector<Life>{{.number = 3, .genome = genome}});
    const std::string name = creature_name(*genome);
    CHECK(called(picture, 4) == name + " 4");
    CHECK(called(picture, 3) == name + " 3");
    CHECK(called(picture, 2) == name + " 2");
    CHECK(called(picture, 1) == "creature 1");
}

}  // namespace
}  // namespace cambrian
