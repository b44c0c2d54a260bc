#include "spatial/cone_solver.h"

#include "core/random.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cambrian {
namespace {

using spatial::ConeProblem;
using spatial::ConeSolver;

// A random problem: the matrix is J J' of more columns than rows, or of fewer and softened.
struct RandomProblem {
    RandomProblem(RandomStream& random, int contacts, int stops, int columns, double softness)
        : rows(static_cast<std::size_t>(3 * contacts + stops)),
          matrix(rows * rows),
          bias(rows),
          impulse(rows) {
        const auto width = static_cast<std::size_t>(columns);
        std::vector<double> directions(rows * width);
        for (double& number : directions)
            number = random.uniform(-1.0, 1.0);
        for (std::size_t i = 0; i < rows; ++i) {
            for (std::size_t j = 0; j < rows; ++j) {
                double& sum = matrix[i * rows + j];
                for (std::size_t k = 0; k < width; ++k)
                    sum += directions[i * width + k] * directions[j * width + k];
            }
            matrix[i * rows + i] += softness;
            bias[i] = random.uniform(-1.0, 0.5);
        }
        problem = {contacts, stops, random.uniform(0.0, 1.2), matrix.data(), bias.data()};
    }

    double rate(std::size_t row) const {
        double sum = bias[row];
        for (std::size_t j = 0; j < rows; ++j)
            sum += matrix[row * rows + j] * impulse[j];
        return sum;
    }

    // Returns how far the impulses are from the law, in m/s.
    double fault() const {
        double worst = 0.0;
        const auto check_push = [&](std::size_t row) {
            worst = std::max({worst, -impulse[row], -rate(row), impulse[row] * rate(row)});
        };
        for (std::size_t c = 0; c < static_cast<std::size_t>(problem.contacts); ++c) {
            const std::size_t row = 3 * c;
            check_push(row);
            const double radius = problem.friction * impulse[row];
            const double pushed = std::hypot(impulse[row + 1], impulse[row + 2]);
            const double slip = std::hypot(rate(row + 1), rate(row + 2));
            worst = std::max(worst, pushed - radius);
            // The most power against the slip: p_t . y_t = -radius |y_t|.
            worst = std::max(worst, impulse[row + 1] * rate(row + 1) +
                                        impulse[row + 2] * rate(row + 2) + radius * slip);
        }
        for (std::size_t row = 3 * static_cast<std::size_t>(problem.contacts); row < rows; ++row)
            check_push(row);
        return worst;
    }

    std::size_t rows;
    std::vector<double> matrix, bias, impulse;
    ConeProblem problem;
};

}  // namespace

TEST_CASE("Impulses of contacts and stops keep their law") {
    int failed = 0;
    int tried = 0;
    for (std::uint64_t turn = 0; turn < 500; ++turn) {
        RandomStream random(stream_seed({110, turn}));
        const int contacts = random.between(0, 6);
        const int stops = random.between(contacts == 0 ? 1 : 0, 6);
        const int rows = 3 * contacts + stops;
        const bool wide = random.chance(0.5);
        RandomProblem each(random, contacts, stops, wide ? rows + 6 : std::max(1, rows / 2),
                           wide ? 0.0 : 1e-2);
        ConeSolver solver(rows);
        ++tried;
        const bool solved = solver.solve(each.problem, each.impulse.data());
        if (!solved) {
            ++failed;
            ConeSolver::sweep(each.problem, 20000, each.impulse.data());
        }
        CAPTURE(turn, contacts, stops, wide, solved);
        CHECK(each.fault() < (solved ? 1e-6 : 1e-3));
    }
    CAPTURE(failed, tried);
    CHECK(failed < tried / 20);
}

TEST_CASE("Without friction contacts have the law of stops") {
    RandomStream random(stream_seed({111}));
    RandomProblem each(random, 4, 2, 20, 0.0);
    each.problem.friction = 0.0;
    ConeSolver solver(14);
    REQUIRE(solver.solve(each.problem, each.impulse.data()));
    CHECK(each.fault() < 1e-6);
    for (std::size_t c = 0; c < 4; ++c) {
        CHECK(each.impulse[3 * c + 1] == 0.0);
        CHECK(each.impulse[3 * c + 2] == 0.0);
    }
}

}  // namespace cambrian
