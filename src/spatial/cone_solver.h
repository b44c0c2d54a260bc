#pragma once

// Impulses of contacts with friction and of stops (spatial/README.md 6). A semismooth Newton method
// on projections (P. Alart, A. Curnier, Comput. Methods Appl. Mech. Eng. 92, 1991) follows a few
// sweeps of Gauss and Seidel over the contacts. It knows nothing of bodies.

#include <vector>

namespace cambrian::spatial {

// Rates y = bias + matrix p. Contacts have three rows each, along the normal and two tangents:
//
//     p_n >= 0,  y_n >= 0,  p_n y_n = 0,  |p_t| <= friction p_n,  y_t = 0 inside that circle and
//     against p_t on its edge
//
// Stops have one row each, behind those of the contacts, with the law of normals.
struct ConeProblem {
    int contacts = 0;
    int stops = 0;
    double friction = 0.0;
    const double* matrix = nullptr;  // symmetric, rows() x rows()
    const double* bias = nullptr;

    int rows() const { return 3 * contacts + stops; }
};

class ConeSolver {
public:
    // Reserves memory, so that problems of so many rows allocate nothing.
    explicit ConeSolver(int most_rows);

    // Solves from a first guess. Returns false, with impulses that keep the bounds, if it did not
    // settle.
    bool solve(const ConeProblem& problem, double* impulse);
    // Improves impulses by so many sweeps at most.
    static void sweep(const ConeProblem& problem, int sweeps, double* impulse);

private:
    void compute_rates(const ConeProblem& problem, const double* impulse);
    double linearize(const ConeProblem& problem, const double* impulse);
    void linearize_slip(const ConeProblem& problem, const double* impulse, int first,
                        const double (&z)[2]);
    bool step(const ConeProblem& problem, double* impulse);

    std::vector<double> scale_;     // of each row, 1 / a bound of its block of the matrix
    std::vector<double> rate_;      // y
    std::vector<double> residual_;  // of each row
    std::vector<double> jacobian_;  // of the residuals of the rows that push, whole rows
    std::vector<double> reduced_;   // of these rows and columns
    std::vector<double> direction_;
    std::vector<int> pushing_;  // rows that are not off
    std::vector<char> is_off_;
};

}  // namespace cambrian::spatial
