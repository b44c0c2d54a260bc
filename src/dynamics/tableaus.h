#pragma once

// Coefficients of embedded pairs of Runge-Kutta formulas: the nodes c, the rows of a, of which the
// last one has the propagated weights b, and b minus b^. They know nothing of what moves.

#include <cstddef>

namespace cambrian::tableau {

// P. Bogacki, L. F. Shampine, A 3(2) pair of Runge-Kutta formulas, Appl. Math. Lett. 2 (1989).
struct BogackiShampine {
    static constexpr std::size_t kStages = 4;
    static constexpr double kNodes[4] = {0.0, 1.0 / 2, 3.0 / 4, 1.0};
    static constexpr double kRows[4][3] = {
        {0.0, 0.0, 0.0}, {1.0 / 2, 0.0, 0.0}, {0.0, 3.0 / 4, 0.0}, {2.0 / 9, 1.0 / 3, 4.0 / 9}};
    static constexpr double kErrors[4] = {-5.0 / 72, 1.0 / 12, 1.0 / 9, -1.0 / 8};
};

// J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6
// (1980): 5(4) with seven stages.
struct DormandPrince {
    static constexpr std::size_t kStages = 7;
    static constexpr double kNodes[7] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
    static constexpr double kRows[7][6] = {
        {},
        {1.0 / 5},
        {3.0 / 40, 9.0 / 40},
        {44.0 / 45, -56.0 / 15, 32.0 / 9},
        {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
        {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
        {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
    static constexpr double kErrors[7] = {71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                          -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
};

}  // namespace cambrian::tableau
