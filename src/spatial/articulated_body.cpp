#include "spatial/articulated_body.h"

#include "core/assert.h"

#include <cmath>

namespace cambrian::spatial {
namespace {

// A symmetric matrix of 6 x 6; the lower triangle is used.
struct Articulated {
    double at[6][6];
};

void read(const Six& six, double (&numbers)[6]) {
    for (int i = 0; i < 3; ++i) {
        numbers[i] = six.angular[i];
        numbers[3 + i] = six.linear[i];
    }
}

Six six_of(const double (&n)[6]) {
    return {Vec3(n[0], n[1], n[2]), Vec3(n[3], n[4], n[5])};
}

// The inertia of a body about the centre of mass of all.
void set_inertia(const Body& body, const Kinematics& k, int b, Articulated& a) {
    Symmetric about = k.inertia[b];
    const Vec3& p = k.place[b];
    const double m = body.mass;
    about += point_inertia(m, p);
    a = {{{about.xx, 0, 0, 0, 0, 0},
          {about.xy, about.yy, 0, 0, 0, 0},
          {about.xz, about.yz, about.zz, 0, 0, 0},
          {0, m * p.z(), -m * p.y(), m, 0, 0},
          {-m * p.z(), 0, m * p.x(), 0, m, 0},
          {m * p.y(), -m * p.x(), 0, 0, 0, m}}};
}

Six times(const Articulated& a, const Six& motion) {
    double v[6];
    read(motion, v);
    double result[6];
    for (int i = 0; i < 6; ++i) {
        double sum = 0.0;
        for (int j = 0; j < 6; ++j)
            sum += (j <= i ? a.at[i][j] : a.at[j][i]) * v[j];
        result[i] = sum;
    }
    return six_of(result);
}

// A -= U U' / D
void take_degree(Articulated& a, const Six& push, double inverse) {
    double u[6];
    read(push, u);
    for (int i = 0; i < 6; ++i) {
        const double scaled = inverse * u[i];
        for (int j = 0; j <= i; ++j)
            a.at[i][j] -= scaled * u[j];
    }
}

void add(Articulated& a, const Articulated& other) {
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j <= i; ++j)
            a.at[i][j] += other.at[i][j];
    }
}

void factorize(const Articulated& a, double (&factor)[6][6]) {
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j <= i; ++j) {
            double sum = a.at[i][j];
            for (int k = 0; k < j; ++k)
                sum -= factor[i][k] * factor[j][k];
            factor[i][j] = i == j ? std::sqrt(sum) : sum / factor[j][j];
        }
    }
}

// Returns -A^-1 b.
Six solve_root(const double (&factor)[6][6], const Six& bias) {
    double x[6];
    read(bias, x);
    for (int i = 0; i < 6; ++i) {
        for (int k = 0; k < i; ++k)
            x[i] -= factor[i][k] * x[k];
        x[i] /= factor[i][i];
    }
    for (int i = 5; i >= 0; --i) {
        for (int k = i + 1; k < 6; ++k)
            x[i] -= factor[k][i] * x[k];
        x[i] /= factor[i][i];
    }
    return -1.0 * six_of(x);
}

// The pass from the root to the leaves: accelerations of all bodies and degrees. `coriolis` has
// each degree's velocity product; without it only the efforts count.
void pass_outwards(const Model& model, const Kinematics& k, const Factors& factors,
                   const double* drive, const Six& root_bias, const Six* coriolis,
                   Response& response) {
    response.body[0] = solve_root(factors.root, root_bias);
    for (int b = 1; b < model.body_count; ++b) {
        const Body& body = model.bodies[b];
        Six a = response.body[body.parent];
        for (int d = body.first_degree; d < body.first_degree + body.degree_count; ++d) {
            if (coriolis != nullptr) a += coriolis[d];
            response.joint[d] = factors.inverse[d] * (drive[d] - dot(factors.push[d], a));
            a += response.joint[d] * k.axis[d];
        }
        response.body[b] = a;
    }
}

}  // namespace

void solve_accelerations(const Model& model, const Kinematics& k, const Loads& loads,
                         Factors& factors, Response& response) {
    Articulated inertia[kMostBodies];
    Six bias[kMostBodies];
    double drive[kMostJointDegrees];
    for (int b = 0; b < model.body_count; ++b) {
        set_inertia(model.bodies[b], k, b, inertia[b]);
        bias[b] = cross_force(k.motion[b], times(inertia[b], k.motion[b]));
        bias[b] += -1.0 * loads.wrench[b];
    }
    for (int b = model.body_count - 1; b > 0; --b) {
        const Body& body = model.bodies[b];
        for (int d = body.first_degree + body.degree_count - 1; d >= body.first_degree; --d) {
            const Six& axis = k.axis[d];
            factors.push[d] = times(inertia[b], axis);
            const Six& push = factors.push[d];
            factors.inverse[d] = 1.0 / (dot(axis, push) + loads.damping[d]);
            drive[d] = loads.effort[d] - dot(axis, bias[b]);
            take_degree(inertia[b], push, factors.inverse[d]);
            bias[b] += times(inertia[b], k.coriolis[d]);
            bias[b] += drive[d] * factors.inverse[d] * push;
        }
        CAMBRIAN_TICK_ASSERT(body.parent >= 0 && body.parent < b, "a parent comes first");
        add(inertia[body.parent], inertia[b]);
        bias[body.parent] += bias[b];
    }
    factorize(inertia[0], factors.root);
    pass_outwards(model, k, factors, drive, bias[0], k.coriolis, response);
}

void respond(const Model& model, const Kinematics& k, const Factors& factors, const Push& push,
             Response& response) {
    Six bias[kMostBodies];
    double drive[kMostJointDegrees];
    for (int b = 0; b < model.body_count; ++b)
        bias[b] = -1.0 * push.wrench[b];
    for (int b = model.body_count - 1; b > 0; --b) {
        const Body& body = model.bodies[b];
        for (int d = body.first_degree + body.degree_count - 1; d >= body.first_degree; --d) {
            drive[d] = push.effort[d] - dot(k.axis[d], bias[b]);
            bias[b] += drive[d] * factors.inverse[d] * factors.push[d];
        }
        bias[body.parent] += bias[b];
    }
    pass_outwards(model, k, factors, drive, bias[0], nullptr, response);
}

void add_push(const Model& model, const Push& push, const Response& response, double* speeds) {
    Six whole;
    for (int b = 0; b < model.body_count; ++b)
        whole += push.wrench[b];
    for (int d = 0; d < model.degree_count; ++d)
        speeds[d] += response.joint[d];
    for (int i = 0; i < 3; ++i) {
        speeds[model.attitude() + i] += whole.angular[i];
        speeds[model.place() + i] += whole.linear[i] / model.mass;
    }
}

}  // namespace cambrian::spatial
