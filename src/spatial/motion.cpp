#include "spatial/motion.h"

namespace cambrian::spatial {

Vec3 coordinate_vector(const double* coordinates) {
    return {coordinates[0], coordinates[1], coordinates[2]};
}

void set_coordinate_vector(double* coordinates, const Vec3& vector) {
    coordinates[0] = vector.x();
    coordinates[1] = vector.y();
    coordinates[2] = vector.z();
}

Motion rest_motion(const Model& model) {
    Motion motion;
    motion.root = rotation_of(model.root_turn);
    set_coordinate_vector(motion.position + model.place(), model.center);
    return motion;
}

Rotation ball_attitude(const Model& model, const Motion& motion, int body) {
    const double* chart = motion.position + model.bodies[body].first_degree;
    return product(motion.ball[body].turn, rotation_by(ball_vector(chart)));
}

Vec3 ball_spin(const Model& model, const Motion& motion, int body) {
    return turn_of(ball_attitude(model, motion, body)) *
           ball_vector(motion.speed + model.bodies[body].first_degree);
}

namespace {

// Turns the joint frame of a ball, whose three axes are those of the body.
void follow_ball(const Model& model, const Motion& motion, int b, const Vec3& pivot, Turn& frame,
                 Vec3& spin, Kinematics& k) {
    const int first = model.bodies[b].first_degree;
    frame = frame * turn_of(ball_attitude(model, motion, b));
    for (int d = first; d < first + 3; ++d)
        k.axis[d] = {frame.axis[model.degrees[d].axis], pivot};
    spin += frame * ball_vector(motion.speed + first);
}

// Places a body and its degrees from its parent's. Axes of hinges have no moment yet.
void follow_joint(const Model& model, const Motion& motion, int b, Kinematics& k) {
    const Body& body = model.bodies[b];
    const int parent = body.parent;
    Turn frame = k.turn[parent] * body.joint_frame;
    const Vec3 arm = k.turn[parent] * body.pivot_in_parent;
    Vec3 pivot = k.place[parent] + arm;
    Vec3 spin = k.spin[parent];
    Vec3 velocity = k.velocity[parent] + cross(spin, arm);
    const int hinges = body.is_ball ? 0 : body.degree_count;
    if (body.is_ball) follow_ball(model, motion, b, pivot, frame, spin, k);
    for (int d = body.first_degree; d < body.first_degree + hinges; ++d) {
        const Degree& degree = model.degrees[d];
        const Vec3 axis = frame.axis[degree.axis];
        if (degree.slides) {
            const Vec3 way = motion.position[d] * axis;
            pivot += way;
            velocity += cross(spin, way) + motion.speed[d] * axis;
            k.axis[d] = {Vec3::Zero(), axis};
        } else {
            spin += motion.speed[d] * axis;
            frame.turn_about(degree.axis, sine_cosine(motion.position[d]));
            k.axis[d] = {axis, pivot};  // the pivot, until places are final
        }
    }
    const Vec3 back = frame * body.pivot_in_body;
    k.turn[b] = frame;
    k.place[b] = pivot - back;
    k.spin[b] = spin;
    k.velocity[b] = velocity - cross(spin, back);
}

// Moves the origin to the centre of mass, which is at rest there.
void center(const Model& model, Kinematics& k) {
    Vec3 place = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    for (int b = 0; b < model.body_count; ++b) {
        place += model.bodies[b].mass * k.place[b];
        velocity += model.bodies[b].mass * k.velocity[b];
    }
    place /= model.mass;
    velocity /= model.mass;
    for (int b = 0; b < model.body_count; ++b) {
        k.place[b] -= place;
        k.velocity[b] -= velocity;
    }
    for (int d = 0; d < model.degree_count; ++d) {
        if (!model.degrees[d].slides)
            k.axis[d].linear = cross(k.axis[d].linear - place, k.axis[d].angular);
    }
}

// Turns all bodies such that the angular momentum is that of the motion.
void spin_up(const Model& model, const Vec3& momentum, Kinematics& k) {
    Vec3 relative = Vec3::Zero();
    k.whole_inertia = {};
    for (int b = 0; b < model.body_count; ++b) {
        const Body& body = model.bodies[b];
        k.inertia[b] = turned(body.inertia, k.turn[b]);
        k.whole_inertia += k.inertia[b];
        k.whole_inertia += point_inertia(body.mass, k.place[b]);
        relative += k.inertia[b] * k.spin[b] + body.mass * cross(k.place[b], k.velocity[b]);
    }
    const Vec3 spin = solved(k.whole_inertia, momentum - relative);
    for (int b = 0; b < model.body_count; ++b) {
        k.spin[b] += spin;
        k.velocity[b] += cross(spin, k.place[b]);
        k.motion[b] = {k.spin[b], k.velocity[b] - cross(k.spin[b], k.place[b])};
    }
}

}  // namespace

void compute_kinematics(const Model& model, const Motion& motion, Kinematics& k) {
    k.turn[0] = turn_of(
        product(rotation_by(coordinate_vector(motion.position + model.attitude())), motion.root));
    k.place[0] = Vec3::Zero();
    k.spin[0] = Vec3::Zero();
    k.velocity[0] = Vec3::Zero();
    for (int b = 1; b < model.body_count; ++b)
        follow_joint(model, motion, b, k);
    center(model, k);
    spin_up(model, coordinate_vector(motion.speed + model.attitude()), k);
    for (int b = 1; b < model.body_count; ++b) {
        const Body& body = model.bodies[b];
        Six before = k.motion[body.parent];
        for (int d = body.first_degree; d < body.first_degree + body.degree_count; ++d) {
            const Six added = motion.speed[d] * k.axis[d];
            k.coriolis[d] = cross_motion(before, added);
            if (!body.is_ball) before += added;
        }
    }
}

void restart_chart(const Model& model, Motion& motion) {
    double* chart = motion.position + model.attitude();
    motion.root = normalized(product(rotation_by(coordinate_vector(chart)), motion.root));
    set_coordinate_vector(chart, Vec3::Zero());
    for (int i = 0; i < model.ball_count; ++i) {
        const int b = model.balls[i];
        motion.ball[b].turn = normalized(ball_attitude(model, motion, b));
        set_coordinate_vector(motion.position + model.bodies[b].first_degree, Vec3::Zero());
    }
}

void restart_chart_rates(const Model& model, const Motion& motion, const Vec3& root_spin,
                         MotionRate& rate) {
    set_coordinate_vector(rate.position + model.attitude(), root_spin);
    for (int i = 0; i < model.ball_count; ++i) {
        const int first = model.bodies[model.balls[i]].first_degree;
        set_coordinate_vector(rate.position + first, coordinate_vector(motion.speed + first));
    }
}

void copy_attitudes(const Model& model, const Motion& from, Motion& to) {
    to.root = from.root;
    for (int i = 0; i < model.ball_count; ++i)
        to.ball[model.balls[i]] = from.ball[model.balls[i]];
}

double kinetic_energy(const Model& model, const Motion& motion, const Kinematics& k) {
    const Vec3 drift = coordinate_vector(motion.speed + model.place());
    double twice = model.mass * dot(drift, drift);
    for (int b = 0; b < model.body_count; ++b) {
        twice += model.bodies[b].mass * dot(k.velocity[b], k.velocity[b]) +
                 dot(k.spin[b], k.inertia[b] * k.spin[b]);
    }
    return 0.5 * twice;
}

}  // namespace cambrian::spatial
