#include "cluster/coordinator/unit_ledger.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cambrian {

UnitLedger::UnitLedger(std::vector<double> seconds)
    : seconds_(std::move(seconds)),
      open_(seconds_.size()),
      open_seconds_(std::accumulate(seconds_.begin(), seconds_.end(), 0.0)),
      is_open_(seconds_.size(), true),
      answered_(seconds_.size()),
      at_home_(seconds_.size()) {
    std::iota(open_.begin(), open_.end(), std::size_t{0});
}

std::size_t UnitLedger::take_open(bool from_front) {
    const std::size_t creature = from_front ? open_.front() : open_.back();
    if (from_front)
        open_.pop_front();
    else
        open_.pop_back();
    is_open_[creature] = false;
    open_seconds_ = open_.empty() ? 0.0 : open_seconds_ - seconds_[creature];
    return creature;
}

std::vector<std::size_t> UnitLedger::take_for_unit(double seconds, std::size_t most) {
    std::vector<std::size_t> creatures;
    double sum = 0.0;
    while (!open_.empty() && creatures.size() < most && (creatures.empty() || sum < seconds)) {
        creatures.push_back(take_open(true));
        sum += seconds_[creatures.back()];
    }
    return creatures;
}

std::optional<std::size_t> UnitLedger::take_for_home() {
    if (open_.empty()) return std::nullopt;
    return take_open(false);
}

void UnitLedger::reopen(const std::vector<std::size_t>& creatures) {
    for (auto each = creatures.rbegin(); each != creatures.rend(); ++each) {
        if (answered_[*each] || is_open_[*each]) continue;
        at_home_[*each] = false;
        is_open_[*each] = true;
        open_.push_front(*each);
        open_seconds_ += seconds_[*each];
    }
}

double UnitLedger::seconds_of(const std::vector<std::size_t>& creatures) const {
    return std::accumulate(creatures.begin(), creatures.end(), 0.0,
                           [&](double sum, std::size_t each) { return sum + seconds_[each]; });
}

void UnitLedger::publish(std::uint32_t unit, std::vector<std::size_t> creatures, double now,
                         double due) {
    OutstandingUnit& out = units_[unit];
    out.seconds = seconds_of(creatures);
    out.creatures = std::move(creatures);
    out.published = now;
    out.due = due;
    outstanding_seconds_ += out.seconds;
}

std::vector<std::size_t> UnitLedger::close(std::uint32_t unit) {
    const auto found = units_.find(unit);
    if (found == units_.end()) return {};
    std::vector<std::size_t> creatures = std::move(found->second.creatures);
    outstanding_seconds_ -= found->second.seconds;
    units_.erase(found);
    if (units_.empty()) outstanding_seconds_ = 0.0;
    return creatures;
}

void UnitLedger::expect_no_more(std::uint32_t unit) {
    const auto found = units_.find(unit);
    if (found != units_.end()) found->second.due = 0.0;
}

void UnitLedger::answered(std::size_t creature) {
    answered_[creature] = true;
    if (!is_open_[creature]) return;
    is_open_[creature] = false;
    std::erase(open_, creature);
    open_seconds_ = open_.empty() ? 0.0 : open_seconds_ - seconds_[creature];
}

void UnitLedger::unanswered(std::size_t creature) {
    answered_[creature] = false;
    reopen({creature});
}

bool UnitLedger::has_wanted(const OutstandingUnit& unit) const {
    return std::any_of(unit.creatures.begin(), unit.creatures.end(),
                       [this](std::size_t each) { return wanted(each); });
}

std::optional<UnitLedger::Late> UnitLedger::take_late(double now, std::size_t parts) {
    auto latest = units_.end();
    for (auto unit = units_.begin(); unit != units_.end(); ++unit) {
        if (unit->second.due > now || !has_wanted(unit->second)) continue;
        if (latest == units_.end() || unit->second.due < latest->second.due) latest = unit;
    }
    if (latest == units_.end()) return std::nullopt;
    OutstandingUnit& unit = latest->second;
    Late late{.unit = latest->first,
              .first = !unit.taken,
              .published = unit.published,
              .due = unit.due,
              .creatures = {}};
    unit.taken = true;
    const std::size_t share = (unit.creatures.size() + parts - 1) / parts;
    // Takes the last creatures first, because a living worker starts with the first.
    for (auto each = unit.creatures.rbegin(); each != unit.creatures.rend(); ++each) {
        if (late.creatures.size() == share) break;
        if (!wanted(*each)) continue;
        at_home_[*each] = true;
        late.creatures.push_back(*each);
    }
    return late;
}

std::optional<double> UnitLedger::next_due() const {
    std::optional<double> next;
    for (const auto& [number, unit] : units_) {
        if (has_wanted(unit) && (!next || unit.due < *next)) next = unit.due;
    }
    return next;
}

}  // namespace cambrian
