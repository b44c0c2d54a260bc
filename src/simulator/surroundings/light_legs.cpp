#include "simulator/surroundings/light_legs.h"

#include <algorithm>

namespace cambrian {

void LightLegs::reserve(std::size_t legs) {
    legs_.reserve(legs);
}

void LightLegs::begin(double distance, double length) {
    legs_.push_back({.start = distance, .unit = length, .end = distance, .nearest = distance});
}

void LightLegs::watch(double distance) {
    if (legs_.empty()) return;
    LightLeg& leg = legs_.back();
    leg.end = distance;
    leg.nearest = std::min(leg.nearest, distance);
    leg.mean += (distance - leg.mean) / ++leg.ticks;
}

void LightLegs::rest(std::size_t legs) {
    if (legs_.empty()) return;
    const double distance = legs_.back().end;
    const double unit = legs_.back().unit;
    while (legs_.size() < legs)
        legs_.push_back({distance, unit, distance, distance, distance, 1});
}

}  // namespace cambrian
