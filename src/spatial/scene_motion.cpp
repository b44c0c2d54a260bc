#include "spatial/scene_motion.h"

#include "world/scene_checks.h"

#include <algorithm>

namespace cambrian::spatial {
namespace {

constexpr std::size_t kAttitudeNumbers = 4;

}  // namespace

SceneMotion scene_motion_of(const Model& model, const Motion& motion, const double* targets) {
    const int joints = model.degree_count;
    SceneMotion copy{{motion.position, motion.position + joints},
                     {motion.speed, motion.speed + model.coordinate_count()},
                     {targets, targets + joints}};
    const double* center = motion.position + model.place();
    const auto add_attitude = [&copy](const Rotation& turn) {
        copy.positions.insert(copy.positions.end(), {turn.w(), turn.x(), turn.y(), turn.z()});
    };
    add_attitude(motion.root);
    copy.positions.insert(copy.positions.end(), center, center + 3);
    for (int i = 0; i < model.ball_count; ++i)
        add_attitude(motion.ball[model.balls[i]].turn);
    return copy;
}

std::optional<Motion> motion_of(const Model& model, const SceneMotion& numbers) {
    const auto joints = static_cast<std::size_t>(model.degree_count);
    const std::size_t balls = joints + kAttitudeNumbers + 3;
    const std::size_t positions =
        balls + kAttitudeNumbers * static_cast<std::size_t>(model.ball_count);
    if (!has_numbers(numbers, positions, joints + 6, joints)) return std::nullopt;
    const auto attitude_at = [&numbers](std::size_t first) {
        const double* four = numbers.positions.data() + first;
        return Rotation(four[0], four[1], four[2], four[3]);
    };
    for (std::size_t at = balls; at < numbers.positions.size(); at += kAttitudeNumbers) {
        if (!(attitude_at(at).norm() > 0.5)) return std::nullopt;
    }
    const Rotation root = attitude_at(joints);
    if (!(root.norm() > 0.5)) return std::nullopt;
    Motion motion;
    motion.root = normalized(root);
    for (int d = 0; d < model.degree_count; ++d) {
        const bool of_ball = model.bodies[model.degrees[d].body].is_ball;
        motion.position[d] = of_ball ? 0.0 : numbers.positions[static_cast<std::size_t>(d)];
    }
    std::copy_n(numbers.positions.data() + joints + kAttitudeNumbers, 3,
                motion.position + model.place());
    for (std::size_t i = 0; i < static_cast<std::size_t>(model.ball_count); ++i)
        motion.ball[model.balls[i]].turn = normalized(attitude_at(balls + kAttitudeNumbers * i));
    std::copy(numbers.speeds.begin(), numbers.speeds.end(), motion.speed);
    return motion;
}

void add_to_digest(const Model& model, const Motion& motion, Hash64& digest) {
    for (int c = 0; c < model.coordinate_count(); ++c) {
        digest.add(motion.position[c]);
        digest.add(motion.speed[c]);
    }
    const auto add_attitude = [&digest](const Rotation& turn) {
        for (const double number : {turn.w(), turn.x(), turn.y(), turn.z()})
            digest.add(number);
    };
    add_attitude(motion.root);
    for (int i = 0; i < model.ball_count; ++i)
        add_attitude(motion.ball[model.balls[i]].turn);
}

}  // namespace cambrian::spatial
