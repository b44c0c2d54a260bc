// The field of scent: how it decays and spreads, and what lies at its edges.
#include "simulator/surroundings/scent_field.h"
#include "support/catch.h"

#include <cmath>

using namespace cambrian;

namespace {

constexpr double kStep = 0.1;  // s

ScentArea closed(int columns, int rows) {
    return {.columns = columns,
            .rows = rows,
            .wall_left = true,
            .wall_right = true,
            .wall_bottom = true,
            .wall_top = true};
}

Vec3 center_of(const ScentArea& area, int column, int row) {
    return {area.left + (column + 0.5) * kScentCell, area.bottom + (row + 0.5) * kScentCell, 0.0};
}

void run(ScentField& field, int steps) {
    for (int i = 0; i < steps; ++i)
        field.step();
}

// Variance of the places of a field's scent along x, in m^2.
double variance(const ScentField& field) {
    const ScentArea& area = field.area();
    double sum = 0.0;
    double first = 0.0;
    double second = 0.0;
    for (int row = 0; row < area.rows; ++row) {
        for (int column = 0; column < area.columns; ++column) {
            const double amount = field.cell(column, row);
            const double x = center_of(area, column, row).x();
            sum += amount;
            first += amount * x;
            second += amount * x * x;
        }
    }
    const double mean = first / sum;
    return second / sum - mean * mean;
}

}  // namespace

TEST_CASE("within walls all that happens to scent is that it halves in 8 s", "[simulator][scent]") {
    ScentField field(closed(12, 7));
    field.add({0.1, 0.1, 0.0}, 2.0);
    field.add({5.9, 3.4, 0.0}, 1.0);
    double expected = 3.0;
    CHECK(field.total() == 3.0);
    for (int step = 1; step <= 400; ++step) {
        field.step();
        expected = 3.0 * std::exp(-std::log(2.0) * step * kStep / kScentHalfLife);
        REQUIRE(std::fabs(field.total() / expected - 1.0) < 1e-12);
    }
    CHECK(expected == Approx(3.0 / 32.0));
}

TEST_CASE("the variance of a puff grows by 2 D t", "[simulator][scent]") {
    const ScentArea area{.columns = 128, .rows = 64};
    ScentField field(area);
    field.add(center_of(area, 64, 32), 1.0);
    for (int second = 1; second <= 10; ++second) {
        run(field, 10);
        CHECK(variance(field) == Approx(2.0 * kScentSpread * second).epsilon(0.02));
    }
}

TEST_CASE("the field of a source one cell on is the field one cell on, bit for bit",
          "[simulator][scent]") {
    const ScentArea area{.columns = 40, .rows = 30};
    ScentField field(area);
    ScentField right(area);
    ScentField up(area);
    for (int tick = 0; tick < 60; ++tick) {
        const double amount = 0.01 + 0.003 * tick;
        field.add(center_of(area, 20, 14), amount);
        right.add(center_of(area, 21, 14), amount);
        up.add(center_of(area, 20, 15), amount);
        if (tick % 6 != 5) continue;
        field.step();
        right.step();
        up.step();
    }
    for (int row = 0; row + 1 < area.rows; ++row) {
        for (int column = 0; column + 1 < area.columns; ++column) {
            REQUIRE(right.cell(column + 1, row) == field.cell(column, row));
            REQUIRE(up.cell(column, row + 1) == field.cell(column, row));
        }
    }
}

TEST_CASE("where edges meet, scent spreads across them as anywhere else", "[simulator][scent]") {
    ScentArea area = closed(7, 5);
    area.sides_meet = true;
    area.ends_meet = true;
    ScentField field(area);
    ScentField across(area);
    field.add(center_of(area, 2, 2), 3.0);
    across.add(center_of(area, 6, 4), 3.0);
    run(field, 80);
    run(across, 80);
    for (int row = 0; row < area.rows; ++row) {
        for (int column = 0; column < area.columns; ++column)
            REQUIRE(across.cell((column + 4) % area.columns, (row + 2) % area.rows) ==
                    Approx(field.cell(column, row)).epsilon(1e-12));
    }
    CHECK(across.total() == Approx(0.5 * 3.0));
    // Both sides of an edge are one place.
    CHECK(across.at({0.0, 1.0, 0.0}) == Approx(across.at({3.5, 1.0, 0.0})));
    CHECK(across.at({1.0, 0.0, 0.0}) == Approx(across.at({1.0, 2.5, 0.0})));
}

TEST_CASE("scent is lost at open edges and stays behind walls", "[simulator][scent]") {
    ScentArea area{.columns = 6, .rows = 6};
    ScentField open(area);
    area.wall_left = true;
    ScentField half(area);
    ScentField shut(closed(6, 6));
    for (ScentField* field : {&open, &half, &shut}) {
        field->add({0.25, 1.6, 0.0}, 1.0);
        field->add({-0.1, 1.6, 0.0}, 100.0);
        field->add({1.0, 3.01, 0.0}, 100.0);
        run(*field, 50);
    }
    CHECK(open.total() < 0.7 * half.total());
    CHECK(half.total() < 0.95 * shut.total());
    CHECK(open.at({-0.3, 1.6, 0.0}) == 0.0);
    CHECK(open.at({-50.0, 1e9, 0.0}) == 0.0);
    // Beside a wall, scent is as strong as in the middle of the cell there.
    CHECK(half.at({0.01, 1.75, 0.0}) == Approx(half.cell(0, 3)));
}

TEST_CASE("between the centres of cells scent changes evenly", "[simulator][scent]") {
    const ScentArea area{.left = -1.0, .bottom = 2.0, .columns = 5, .rows = 5};
    ScentField field(area);
    field.add(center_of(area, 2, 2), 4.0);
    CHECK(field.at(center_of(area, 2, 2)) == 4.0);
    CHECK(field.at(center_of(area, 2, 2) + Vec3(0.25, 0.0, 0.0)) == 2.0);
    CHECK(field.at(center_of(area, 2, 2) + Vec3(-0.25, 0.25, 0.0)) == 1.0);
    CHECK(field.at(center_of(area, 3, 2)) == 0.0);
}

TEST_CASE("a restored field goes on with the same bits, and an old one is empty",
          "[simulator][scent]") {
    ScentField field(closed(9, 9));
    CHECK_FALSE(field.any());
    const ScentField::Moment nothing = field.save();
    CHECK(nothing.cells.empty());
    field.add({0.2, 0.2, 0.0}, 1.0);
    run(field, 7);
    const ScentField::Moment moment = field.save();
    run(field, 9);
    ScentField other(closed(9, 9));
    other.restore(moment);
    run(other, 9);
    CHECK(other.save().cells == field.save().cells);
    other.restore(nothing);
    CHECK(other.total() == 0.0);
    run(field, 9000);  // 112 half-lives
    CHECK_FALSE(field.any());
    CHECK(field.total() == 0.0);
}
