#include "studio/preserve/world_pins.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

ResidentPicture resident(std::uint64_t number, std::uint64_t parent = 0) {
    ResidentPicture picture;
    picture.life.number = number;
    picture.life.parents[0] = parent;
    return picture;
}

TEST_CASE("pins are taken off, and those of the dead are forgotten", "[studio][preserve]") {
    PreservePicture picture;
    picture.residents = {resident(1), resident(2), resident(3)};
    WorldPins pins;
    pins.begin(Pins{{2}, false}, picture);
    CHECK_FALSE(pins.take_change());
    pins.toggle(1);
    pins.toggle(2);
    pins.toggle(3);
    CHECK(pins.pins() == Pins{{1, 3}, false});
    CHECK(pins.take_change());
    picture.residents.pop_back();
    pins.follow(picture);
    CHECK(pins.pins() == Pins{{1}, false});
    CHECK(pins.take_change());
    pins.follow(picture);
    CHECK_FALSE(pins.take_change());
}

TEST_CASE("descendants born from now on are pinned while pins are inherited",
          "[studio][preserve]") {
    PreservePicture picture;
    picture.residents = {resident(1), resident(2), resident(3, 1)};
    WorldPins pins;
    pins.begin(Pins{{1}, false}, picture);
    picture.residents.push_back(resident(4, 1));
    pins.follow(picture);
    CHECK(pins.pins() == Pins{{1}, false});
    pins.toggle_inheritance();
    picture.residents.push_back(resident(5, 2));
    picture.residents.push_back(resident(6, 1));
    picture.residents.push_back(resident(7, 6));
    pins.follow(picture);
    CHECK(pins.pins() == Pins{{1, 6, 7}, true});
    pins.toggle(7);
    pins.follow(picture);
    CHECK(pins.pins() == Pins{{1, 6}, true});
    picture.residents.erase(picture.residents.begin());
    picture.residents.push_back(resident(8, 1));
    pins.follow(picture);
    CHECK(pins.pins() == Pins{{6, 8}, true});
}

}  // namespace
}  // namespace cambrian
