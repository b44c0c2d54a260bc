// The matrix of rows: the rates that unit impulses cause (spatial/README.md 5).

#include "spatial/rows.h"

#include <algorithm>
#include <cmath>

namespace cambrian::spatial {
namespace {

constexpr double kStopSoftness = 1e-7;    // share of the diagonal
constexpr double kNormalSoftness = 1e-4;  // share of a free body's
constexpr double kLeastDiagonal = 0.02;   // share of a free body's

// Calls take(degree) for the degrees of a body, outermost first.
template <class Take>
void visit_degrees(const Body& body, Take&& take) {
    for (int d = body.first_degree + body.degree_count - 1; d >= body.first_degree; --d)
        take(d);
}

// Calls take(degree) for the degrees between a body and the root, outermost first, and for those
// between another one (or -1) and the root that are not among them.
template <class Take>
void visit_paths(const Model& model, int body, int other, Take&& take) {
    int a = body;
    int b = other;
    while (a > 0) {
        if (b > a) {
            visit_degrees(model.bodies[b], take);
            b = model.bodies[b].parent;
            continue;
        }
        if (b == a) b = -1;
        visit_degrees(model.bodies[a], take);
        a = model.bodies[a].parent;
    }
    for (; b > 0; b = model.bodies[b].parent)
        visit_degrees(model.bodies[b], take);
}

}  // namespace

// Follows the unit impulse of a row from its bodies to the root (R. Featherstone, Rigid Body
// Dynamics Algorithms, 2008, chapter 8). Where their paths meet, what arrives is added up.
void Rows::eliminate(const Model& model, const Evaluation& middle, int row) {
    const auto r = static_cast<std::size_t>(row);
    const Factors& factors = middle.factors;
    double* path = path_.data() + r * static_cast<std::size_t>(model.degree_count);
    const int stop = row - 3 * contacts_.count;
    const Stop* driven = stop < 0 ? nullptr : &stops_[static_cast<std::size_t>(stop)];
    const auto pass = [&](const Body& body, Six& bias) {
        visit_degrees(body, [&](int d) {
            path[d] = -dot(middle.kinematics.axis[d], bias);
            if (driven != nullptr && driven->moves(d)) path[d] += driven->share[d - driven->degree];
            bias += path[d] * factors.inverse[d] * factors.push[d];
        });
    };
    Six bias;
    if (stop < 0) bias = -1.0 * direction_[r];
    Six back;
    int a = body_[r];
    int b = other_[r];
    if (b >= 0) back = direction_[r];
    while (b >= 0 && a != b) {
        int& outer = a > b ? a : b;
        pass(model.bodies[outer], a > b ? bias : back);
        outer = model.bodies[outer].parent;
    }
    if (b >= 0) bias += back;
    for (; a > 0; a = model.bodies[a].parent)
        pass(model.bodies[a], bias);
    double* root = root_.data() + 6 * r;
    for (int i = 0; i < 3; ++i) {
        root[i] = -bias.angular[i];
        root[3 + i] = -bias.linear[i];
    }
    for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < i; ++k)
            root[i] -= factors.root[i][k] * root[k];
        root[i] /= factors.root[i][i];
    }
}

// Sets what rows of contacts and stops act on, and their rates at the start.
void Rows::place_contacts(const Kinematics& k) {
    for (int c = 0; c < contacts_.count; ++c) {
        const Contact& contact = contacts_.items[c];
        const Vec3 place = place_of(k, contact);
        const Turn surface = surface_of(k, contact);
        const int b = contact.other_body;
        if (b >= 0) met_[c] = k.turn[b].back(place - k.place[b]);
        for (std::size_t d = 0; d < 3; ++d) {
            const std::size_t row = first_row(c) + d;
            direction_[row] = {cross(place, surface.axis[d]), surface.axis[d]};
            body_[row] = contact.body;
            other_[row] = b;
            rate_[row] = contact.rate[static_cast<int>(d)];
        }
    }
}

void Rows::build(const Model& model, const Evaluation& middle, double tangent_softness) {
    const int n = row_count();
    place_contacts(middle.kinematics);
    turn_stops(model, middle.kinematics, stops_);
    for (std::size_t s = 0; s < stops_.size(); ++s) {
        const std::size_t row = first_row(contacts_.count) + s;
        body_[row] = model.degrees[stops_[s].degree].body;
        other_[row] = -1;
        rate_[row] = stops_[s].rate;
    }
    const auto degrees = static_cast<std::size_t>(model.degree_count);
    std::fill_n(path_.begin(), static_cast<std::size_t>(n) * degrees, 0.0);
    for (int row = 0; row < n; ++row)
        eliminate(model, middle, row);
    int visited[kMostJointDegrees];
    double scaled[kMostJointDegrees];
    for (int row = 0; row < n; ++row) {
        const auto r = static_cast<std::size_t>(row);
        const double* path = path_.data() + r * degrees;
        const double* root = root_.data() + 6 * r;
        int count = 0;
        visit_paths(model, body_[r], other_[r], [&](int d) {
            scaled[count] = path[d] * middle.factors.inverse[d];
            visited[count++] = d;
        });
        for (int column = 0; column <= row; ++column) {
            const auto s = static_cast<std::size_t>(column);
            const double* other = path_.data() + s * degrees;
            double sum = 0.0;
            for (std::size_t i = 0; i < 6; ++i)
                sum += root[i] * root_[6 * s + i];
            for (int i = 0; i < count; ++i)
                sum += scaled[i] * other[visited[i]];
            at(row, column) = sum;
            at(column, row) = sum;
        }
    }
    soften(model, middle.kinematics, tangent_softness);
}

// Adds to the diagonal, for contacts in shares of what it would be if the bodies had no joints.
void Rows::soften(const Model& model, const Kinematics& k, double tangent_softness) {
    for (int c = 0; c < contacts_.count; ++c) {
        const Contact& contact = contacts_.items[c];
        double free[3] = {};
        const auto add_body = [&](int b, const Vec3& arm) {
            for (std::size_t d = 0; d < 3; ++d) {
                const Vec3 lever = cross(arm, direction_[first_row(c) + d].linear);
                free[d] += 1.0 / model.bodies[b].mass + dot(lever, solved(k.inertia[b], lever));
            }
        };
        add_body(contact.body, k.turn[contact.body] * contact.point);
        if (!contact.is_on_ground())
            add_body(contact.other_body, k.turn[contact.other_body] * met_[c]);
        const int first = 3 * c;
        // The same for both tangents, so that it does not depend on the direction of the body.
        const double tangent = tangent_softness * 0.5 * (free[1] + free[2]);
        softness_[first_row(c)] =
            std::max(kNormalSoftness * free[0], kLeastDiagonal * free[0] - at(first, first));
        softness_[first_row(c) + 1] = tangent;
        softness_[first_row(c) + 2] = tangent;
    }
    for (int row = 3 * contacts_.count; row < row_count(); ++row)
        softness_[static_cast<std::size_t>(row)] = kStopSoftness * at(row, row);
    for (int row = 0; row < row_count(); ++row)
        at(row, row) += softness_[static_cast<std::size_t>(row)];
}

}  // namespace cambrian::spatial
