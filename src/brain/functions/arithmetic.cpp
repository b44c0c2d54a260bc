#include "brain/functions/families.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kSmallestDivisor = 0.01;

double sum(const double* in, double* /*memory*/, double /*dt*/) {
    return in[0] + in[1] + in[2];
}
double product(const double* in, double* /*memory*/, double /*dt*/) {
    return in[0] * in[1];
}
double divide(const double* in, double* /*memory*/, double /*dt*/) {
    const double size = std::fmax(std::fabs(in[1]), kSmallestDivisor);
    return in[0] / (in[1] < 0.0 ? -size : size);
}
double sign_of(const double* in, double* /*memory*/, double /*dt*/) {
    return in[0] > 0.0 ? 1.0 : (in[0] < 0.0 ? -1.0 : 0.0);
}
// Takes the first of 0 and -0, between which fmin and fmax may choose freely.
double minimum(const double* in, double* /*memory*/, double /*dt*/) {
    return std::min(in[0], in[1]);
}
double maximum(const double* in, double* /*memory*/, double /*dt*/) {
    return std::max(in[0], in[1]);
}
double absolute(const double* in, double* /*memory*/, double /*dt*/) {
    return std::fabs(in[0]);
}
double interpolate(const double* in, double* /*memory*/, double /*dt*/) {
    const double share = std::clamp(in[0], 0.0, 1.0);
    return in[1] + (in[2] - in[1]) * share;
}

}  // namespace

void add_arithmetic_functions(NeuronFunctionRegistry& functions) {
    functions.add({.id = "sum", .label = "Sum", .arity = 3, .evaluate = sum});
    functions.add({.id = "product", .label = "Product", .arity = 2, .evaluate = product});
    functions.add({.id = "divide", .label = "Divide", .arity = 2, .evaluate = divide});
    functions.add({.id = "sign-of", .label = "Sign", .arity = 1, .evaluate = sign_of});
    functions.add({.id = "min", .label = "Minimum", .arity = 2, .evaluate = minimum});
    functions.add({.id = "max", .label = "Maximum", .arity = 2, .evaluate = maximum});
    functions.add({.id = "abs", .label = "Absolute", .arity = 1, .evaluate = absolute});
    functions.add(
        {.id = "interpolate", .label = "Interpolate", .arity = 3, .evaluate = interpolate});
}

}  // namespace cambrian
