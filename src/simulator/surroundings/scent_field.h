#pragma once

// Scent on a grid of cells, which diffuses and decays (simulator/README.md 6).

#include "math/types.h"

#include <cstddef>
#include <vector>

namespace cambrian {

// The place and size of a field, and which of its edges keep scent in.
struct ScentArea {
    double left = 0.0, bottom = 0.0;  // m
    int columns = 1, rows = 1;        // of cells of kScentCell
    // Whether an edge is a wall. Scent that passes another edge is gone.
    bool wall_left = false, wall_right = false, wall_bottom = false, wall_top = false;
    // Whether scent that passes one of two walls that are opposite enters at the other one.
    bool sides_meet = false, ends_meet = false;
};

inline constexpr double kScentCell = 0.5;      // m, side of a cell
inline constexpr int kTicksPerScentStep = 6;   // an update lasts 0.1 s
inline constexpr double kScentHalfLife = 8.0;  // s
inline constexpr double kScentSpread = 0.2;    // m^2/s, coefficient of diffusion

class ScentField {
public:
    explicit ScentField(const ScentArea& area);

    // Adds an amount to the cell of a point; outside of the area it is lost.
    void add(const Vec3& point, double amount);
    // Lets scent diffuse and decay for 0.1 s. Allocates nothing.
    void step();
    void clear();

    // Returns the amount in a cell at a point, between the centres of cells by bilinear
    // interpolation; beyond the edges 0, or behind a wall as in the cell in front of it.
    double at(const Vec3& point) const;
    // Returns whether there is any scent, which may still change.
    bool any() const { return any_; }
    double total() const;

    const ScentArea& area() const { return area_; }
    std::size_t cell_count() const { return cells_.size(); }  // with the margin
    double cell(int column, int row) const { return cells_[index(column, row)]; }

    struct Moment {
        std::vector<double> cells;  // empty if there is no scent
        bool any = false;
    };
    Moment save() const;
    void restore(const Moment& moment);

private:
    // Cells have a margin of one on each side, which holds what lies beyond the edge.
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row + 1) * stride_ + static_cast<std::size_t>(column + 1);
    }
    void fill_margin();
    void step_row(int row);

    ScentArea area_;
    std::size_t stride_;
    std::vector<double> cells_;
    std::vector<double> next_;
    bool any_ = false;
};

}  // namespace cambrian
