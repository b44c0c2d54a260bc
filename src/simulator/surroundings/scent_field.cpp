#include "simulator/surroundings/scent_field.h"

#include "core/assert.h"
#include "math/elementary.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kStepTime = 0.1;  // s
// Share of a cell's difference to a neighbour that flows in a step. Up to 1/4 is stable.
constexpr double kFlow = kScentSpread * kStepTime / (kScentCell * kScentCell);
static_assert(kFlow <= 0.25, "diffusion is stable");
constexpr double kNothing = 1e-30;  // units in a cell; less counts as none

double share_left() {
    static const double left = exponential(-logarithm(2.0) * kStepTime / kScentHalfLife);
    return left;
}

}  // namespace

ScentField::ScentField(const ScentArea& area)
    : area_(area),
      stride_(static_cast<std::size_t>(area.columns) + 2),
      cells_(stride_ * (static_cast<std::size_t>(area.rows) + 2), 0.0),
      next_(cells_.size(), 0.0) {
    CAMBRIAN_ASSERT(area.columns > 0 && area.rows > 0, "a field has cells");
}

void ScentField::add(const Vec3& point, double amount) {
    const double column = std::floor((point.x() - area_.left) / kScentCell);
    const double row = std::floor((point.y() - area_.bottom) / kScentCell);
    const bool inside = column >= 0.0 && column < area_.columns && row >= 0.0 && row < area_.rows;
    if (!inside || !(amount > 0.0)) return;
    cells_[index(static_cast<int>(column), static_cast<int>(row))] += amount;
    any_ = true;
    const bool at_edge =
        column == 0.0 || column == area_.columns - 1 || row == 0.0 || row == area_.rows - 1;
    if (at_edge) fill_margin();
}

void ScentField::clear() {
    std::fill(cells_.begin(), cells_.end(), 0.0);
    any_ = false;
}

// Behind a wall is the mirror image of the cell in front of it or, where edges meet, the cell at
// the opposite edge; behind an open edge is nothing.
void ScentField::fill_margin() {
    const int right = area_.columns - 1;
    const int top = area_.rows - 1;
    const int behind_left = area_.sides_meet ? right : 0;
    const int behind_bottom = area_.ends_meet ? top : 0;
    for (int row = 0; row < area_.rows; ++row) {
        cells_[index(-1, row)] = area_.wall_left ? cells_[index(behind_left, row)] : 0.0;
        cells_[index(area_.columns, row)] =
            area_.wall_right ? cells_[index(right - behind_left, row)] : 0.0;
    }
    for (int column = -1; column <= area_.columns; ++column) {
        cells_[index(column, -1)] = area_.wall_bottom ? cells_[index(column, behind_bottom)] : 0.0;
        cells_[index(column, area_.rows)] =
            area_.wall_top ? cells_[index(column, top - behind_bottom)] : 0.0;
    }
}

void ScentField::step_row(int row) {
    const double left = share_left();
    const double* here = &cells_[index(0, row)];
    const double* below = &cells_[index(0, row - 1)];
    const double* above = &cells_[index(0, row + 1)];
    double* next = &next_[index(0, row)];
    for (int i = 0; i < area_.columns; ++i) {
        const double around = (here[i - 1] + here[i + 1]) + (below[i] + above[i]);
        next[i] = left * (here[i] + kFlow * (around - 4.0 * here[i]));
    }
}

void ScentField::step() {
    if (!any_) return;
    fill_margin();
    for (int row = 0; row < area_.rows; ++row)
        step_row(row);
    std::swap(cells_, next_);
    fill_margin();
    if (*std::max_element(cells_.begin(), cells_.end()) < kNothing) clear();
}

double ScentField::at(const Vec3& point) const {
    if (!any_) return 0.0;
    const double x = (point.x() - area_.left) / kScentCell - 0.5;
    const double y = (point.y() - area_.bottom) / kScentCell - 0.5;
    const double column = std::floor(x);
    const double row = std::floor(y);
    const bool inside = column >= -1.0 && column < area_.columns && row >= -1.0 && row < area_.rows;
    if (!inside) return 0.0;
    const double right = x - column;
    const double up = y - row;
    const double* low = &cells_[index(static_cast<int>(column), static_cast<int>(row))];
    const double* high = low + stride_;
    return (1.0 - up) * ((1.0 - right) * low[0] + right * low[1]) +
           up * ((1.0 - right) * high[0] + right * high[1]);
}

double ScentField::total() const {
    double sum = 0.0;
    for (int row = 0; row < area_.rows; ++row) {
        for (int column = 0; column < area_.columns; ++column)
            sum += cell(column, row);
    }
    return sum;
}

ScentField::Moment ScentField::save() const {
    if (!any_) return {};
    return {cells_, true};
}

void ScentField::restore(const Moment& moment) {
    clear();
    if (!moment.any) return;
    CAMBRIAN_ASSERT(moment.cells.size() == cells_.size(), "a moment of this field");
    cells_ = moment.cells;
    any_ = true;
}

}  // namespace cambrian
