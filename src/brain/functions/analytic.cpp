#include "brain/functions/families.h"
#include "math/elementary.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kSmallestArgument = 0.001;  // least argument of logarithms and powers
constexpr double kMaxExponent = 4.0;

double positive(double x) {
    return std::fmax(std::fabs(x), kSmallestArgument);
}

double sine_of(const double* in, double* /*memory*/, double /*dt*/) {
    return sine(in[0]);
}
double cosine_of(const double* in, double* /*memory*/, double /*dt*/) {
    return cosine(in[0]);
}
double arc_tangent_of(const double* in, double* /*memory*/, double /*dt*/) {
    return arc_tangent(in[0]);
}
double logarithm_of(const double* in, double* /*memory*/, double /*dt*/) {
    return logarithm(positive(in[0]));
}
double power_of(const double* in, double* /*memory*/, double /*dt*/) {
    return power(positive(in[0]), std::fmin(std::fmax(in[1], -kMaxExponent), kMaxExponent));
}
// The range is centred at zero, so that the function can drive a joint in both directions.
double sigmoid(const double* in, double* /*memory*/, double /*dt*/) {
    return 2.0 / (1.0 + exponential(-in[0])) - 1.0;
}

}  // namespace

void add_analytic_functions(NeuronFunctionRegistry& functions) {
    functions.add({.id = "sin", .label = "Sine", .arity = 1, .evaluate = sine_of});
    functions.add({.id = "cos", .label = "Cosine", .arity = 1, .evaluate = cosine_of});
    functions.add({.id = "atan", .label = "Arc tangent", .arity = 1, .evaluate = arc_tangent_of});
    functions.add({.id = "log", .label = "Logarithm", .arity = 1, .evaluate = logarithm_of});
    functions.add({.id = "expt", .label = "Power", .arity = 2, .evaluate = power_of});
    functions.add({.id = "sigmoid", .label = "Sigmoid", .arity = 1, .evaluate = sigmoid});
}

}  // namespace cambrian
