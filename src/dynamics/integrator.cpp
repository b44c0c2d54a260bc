#include "dynamics/integrator.h"

#include <cmath>

namespace cambrian {

double step_error(int coordinates, const PerCoordinate& position_error,
                  const PerCoordinate& speed_error, const PerCoordinate& speed, double tolerance) {
    constexpr double kPerPosition = 10.0;  // 1 / (0.1 m or rad)
    double sum = 0.0;
    for (int c = 0; c < coordinates; ++c) {
        const double position = position_error[c] * kPerPosition;
        const double rate = speed_error[c] / (1.0 + std::fabs(speed[c]));
        sum += position * position + rate * rate;
    }
    return std::sqrt(sum / (2.0 * coordinates)) / tolerance;
}

}  // namespace cambrian
