#include "brain/functions/families.h"
#include "brain/signal.h"

namespace cambrian {
namespace {

double sum_threshold(const double* in, double* /*memory*/, double /*dt*/) {
    return truth(in[0] + in[1] > in[2]);
}
double greater_than(const double* in, double* /*memory*/, double /*dt*/) {
    return truth(in[0] > in[1]);
}
double choose(const double* in, double* /*memory*/, double /*dt*/) {
    return in[0] > 0.0 ? in[1] : in[2];
}

}  // namespace

void add_logic_functions(NeuronFunctionRegistry& functions) {
    functions.add(
        {.id = "sum-threshold", .label = "Sum threshold", .arity = 3, .evaluate = sum_threshold});
    functions.add(
        {.id = "greater-than", .label = "Greater than", .arity = 2, .evaluate = greater_than});
    functions.add({.id = "if", .label = "If", .arity = 3, .evaluate = choose});
}

}  // namespace cambrian
