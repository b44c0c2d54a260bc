#include "simulator/trial_record.h"

#include <algorithm>

namespace cambrian {

void TrialRecord::repeat_supports(const Vec3& moved) {
    if (supports.empty()) return;
    Supports next = supports.back();
    for (std::size_t k = 0; k < kHeadings; ++k)
        next[k] += moved.dot(headings()[k]);
    supports.push_back(next);
}

bool is_invalid(Outcome outcome) {
    return outcome == Outcome::kDiverged || outcome == Outcome::kDisqualified ||
           outcome == Outcome::kOverBudget;
}

int shortfall(Outcome outcome) {
    switch (outcome) {
        case Outcome::kCompleted:
            return 0;
        case Outcome::kStoppedEarly:
            return 1;
        case Outcome::kRejected:
            return 2;
        default:
            return 3;
    }
}

std::string_view outcome_name(Outcome outcome) {
    switch (outcome) {
        case Outcome::kCompleted:
            return "completed";
        case Outcome::kStoppedEarly:
            return "stopped-early";
        case Outcome::kRejected:
            return "rejected";
        case Outcome::kDiverged:
            return "diverged";
        case Outcome::kDisqualified:
            return "cheated";
        case Outcome::kOverBudget:
            return "over-budget";
        case Outcome::kInterrupted:
            return "interrupted";
    }
    return "unknown";
}

void LightLegs::reserve(std::size_t legs) {
    legs_.reserve(legs);
}

void LightLegs::begin(double time, const Vec3& way, double length) {
    const double distance = way.norm();
    legs_.push_back({.time = time,
                     .direction = distance > 0.0 ? Vec3(way / distance) : Vec3(Vec3::Zero()),
                     .start = distance,
                     .unit = length,
                     .end = distance,
                     .nearest = distance});
}

void LightLegs::watch(double distance) {
    if (legs_.empty()) return;
    LightLeg& leg = legs_.back();
    leg.end = distance;
    leg.nearest = std::min(leg.nearest, distance);
    leg.mean += (distance - leg.mean) / ++leg.ticks;
}

void LightLegs::rest(std::size_t legs, double end) {
    if (legs_.empty()) return;
    const LightLeg& last = legs_.back();
    const LightLeg resting = {end,      last.direction, last.end, last.unit,
                              last.end, last.end,       last.end, 1};
    while (legs_.size() < legs)
        legs_.push_back(resting);
}

}  // namespace cambrian
