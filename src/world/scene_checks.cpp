#include "world/scene_checks.h"

#include "core/text/nearest_name.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace cambrian {

Status check_surroundings(const Environment& environment, const SceneSettings& settings) {
    for (const double number :
         {environment.gravity, environment.gravity_direction, environment.friction,
          environment.elasticity, environment.viscosity_linear, environment.viscosity_quadratic,
          settings.motor_speed_limit, settings.motor_frequency}) {
        if (!std::isfinite(number)) return Error{"environment: a number is not finite"};
    }
    for (const double positive :
         {settings.tolerance, settings.contact_step, settings.max_evaluations}) {
        if (!(positive > 0.0))
            return Error{"scene settings: tolerance, contact step and evaluations must be above 0"};
    }
    return {};
}

Error part_error(std::size_t part, const std::string& problem) {
    return {fmt::format("body plan, part {}: {}", part, problem)};
}

Status check_plan(const BodyPlan& plan, double density, std::size_t most_parts,
                  Status (*check)(const BodyPlan& plan, std::size_t part)) {
    if (plan.parts.empty()) return Error{"body plan: no parts"};
    if (plan.parts.size() > most_parts)
        return Error{
            fmt::format("body plan: {} parts, at most {} expected", plan.parts.size(), most_parts)};
    if (!(density > 0.0) || !std::isfinite(density))
        return Error{"environment: density must be above 0"};
    for (std::size_t i = 0; i < plan.parts.size(); ++i) {
        if (Status status = check(plan, i); !status) return status;
    }
    return {};
}

Error unknown_integrator(const std::string& id, std::span<const std::string> known) {
    const std::string nearest = nearest_name(id, known);
    std::string message = fmt::format("scene settings: unknown integrator \"{}\"", id);
    if (!nearest.empty()) return {message + fmt::format("; did you mean \"{}\"?", nearest)};
    message += "; known are";
    for (const std::string& name : known)
        message += fmt::format(" \"{}\"", name);
    return {message};
}

bool has_numbers(const SceneMotion& motion, std::size_t positions, std::size_t speeds,
                 std::size_t targets) {
    if (motion.positions.size() != positions || motion.speeds.size() != speeds ||
        motion.targets.size() != targets)
        return false;
    for (const auto* list : {&motion.positions, &motion.speeds, &motion.targets}) {
        if (!std::all_of(list->begin(), list->end(),
                         [](double number) { return std::isfinite(number); }))
            return false;
    }
    return true;
}

}  // namespace cambrian
