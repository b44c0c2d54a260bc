#include "spatial/rows.h"

#include "core/assert.h"
#include "world/environment.h"

#include <algorithm>
#include <cmath>

namespace cambrian::spatial {
namespace {

constexpr double kReachSteps = 1.5;        // steps in which a closing row may close
constexpr double kStepSoftness = 1e-2;     // of tangents, share of a free body's
constexpr double kImpactSoftness = 1e-5;   // the same in impacts
constexpr double kPushRate = 0.1 * 120.0;  // 1/s; share of a penetration that is undone
constexpr double kUsualRate = 120.0;       // 1/s
constexpr double kWorkAllowance = 1e-3;    // J per (kg m/s^2) of the forces of a step
constexpr double kLeastWork = 1e-9;        // J per (kg m/s^2); smaller works are rounding
constexpr int kStepSweeps = 60;
constexpr int kImpactSweeps = 300;
constexpr int kSweepsFromZero = 200;
constexpr double kCircleShare = 1.0 - 1e-6;  // of the radius; a longer tangent impulse slides

// Returns what is added to the free rate at the end of a step before it must not be negative.
double slack_of(double gap, double rate, double h, double push_speed) {
    if (gap < 0.0) {
        const double back = std::min(push_speed, -kPushRate * gap) * std::min(1.0, kUsualRate * h);
        return std::max(-back, rate - 2.0 * back);
    }
    if (rate <= 0.0) return std::max(0.0, gap / h + 0.5 * rate);
    return std::max(0.0, 2.0 * gap / h + rate);
}

// Returns the acceleration of a body's point at a place from the centre of mass of all.
Vec3 point_acceleration(const Evaluation& evaluation, int body, const Vec3& place,
                        const Vec3& gravity) {
    const Kinematics& k = evaluation.kinematics;
    const Six& acceleration = evaluation.response.body[body];
    const Vec3 velocity = k.motion[body].linear + cross(k.spin[body], place);
    return acceleration.linear + cross(acceleration.angular, place) +
           cross(k.spin[body], velocity) + gravity;
}

// Returns the acceleration of a contact along the axes of its surface (in the world), at a place
// from the centre of mass of all. The surface may turn and move.
Vec3 contact_acceleration(const Evaluation& evaluation, const Contact& contact, const Turn& surface,
                          const Vec3& place, const Vec3& gravity) {
    const Vec3 own = point_acceleration(evaluation, contact.body, place, gravity);
    if (contact.is_on_ground()) return {own.y(), own.x(), own.z()};
    const Kinematics& k = evaluation.kinematics;
    const int b = contact.other_body;
    const Six& motion = k.motion[contact.body];
    const Vec3 slip =
        motion.linear + cross(motion.angular, place) - k.motion[b].linear - cross(k.spin[b], place);
    return surface.back(own - point_acceleration(evaluation, b, place, gravity) -
                        2.0 * cross(k.spin[b], slip));
}

// Whether a slow contact could reach the band within a step of length h.
bool may_touch(const Contact& contact, const Moment& start, double h) {
    const double closing = contact.closing_speed();
    if (closing > kRestingSpeed) return false;
    const Kinematics& k = start.evaluation.kinematics;
    const double acceleration =
        contact_acceleration(start.evaluation, contact, surface_of(k, contact),
                             place_of(k, contact), start.gravity)
            .x();
    return contact.gap < kContactBand + kReachSteps * h * std::max(0.0, closing) +
                             h * h * std::max(0.0, -acceleration);
}

}  // namespace

void Change::add(const Model& model, const Response& response, const Push& push) {
    for (int d = 0; d < model.degree_count; ++d)
        joint[d] += response.joint[d];
    root += response.root_turning();
    Vec3 force = Vec3::Zero();
    for (int b = 0; b < model.body_count; ++b)
        force += push.wrench[b].linear;
    center += force / model.mass;
}

Rows::Rows(const Model& model) : solver_(3 * most_contacts(model) + 2 * model.degree_count) {
    const std::size_t contacts = 3 * static_cast<std::size_t>(most_contacts(model));
    const std::size_t rows = contacts + most_stops(model);
    stops_.reserve(rows - contacts);
    direction_.resize(contacts);
    body_.resize(rows);
    other_.resize(rows);
    active_.reserve(rows);
    path_.resize(rows * static_cast<std::size_t>(model.degree_count));
    root_.resize(6 * rows);
    for (std::vector<double>* matrix : {&matrix_, &factor_})
        matrix->resize(rows * rows);
    for (std::vector<double>* numbers :
         {&softness_, &rate_, &acceleration_, &bias_, &impulse_, &undone_})
        numbers->resize(rows);
}

bool Rows::select(const Moment& start, const ContactSet& near, const HeldContacts& held,
                  double length) {
    contacts_.count = 0;
    int h = 0;
    for (int c = 0; c < near.count; ++c) {
        const Contact& contact = near.items[c];
        if (contact.gap >= kContactBand && !may_touch(contact, start, length)) continue;
        // Both are in the order of their numbers.
        while (h < held.count && held.items[h].id < contact.id)
            ++h;
        const bool known = h < held.count && held.items[h].id == contact.id;
        guess_[contacts_.count] = known ? held.items[h].force : Vec3(Vec3::Zero());
        contacts_.items[contacts_.count++] = contact;
    }
    find_stops(start.model, start.motion, length, stops_);
    return row_count() > 0;
}

bool Rows::select_touched(const Moment& moment, const ContactSet& near) {
    contacts_.count = 0;
    for (int c = 0; c < near.count; ++c) {
        if (near.items[c].gap < kContactBand) contacts_.items[contacts_.count++] = near.items[c];
    }
    find_stops(moment.model, moment.motion, 0.0, stops_);
    return row_count() > 0;
}

void Rows::clear() {
    contacts_.count = 0;
    stops_.clear();
}

// Sets biases and first guesses. The softness of tangents pulls towards the last step's force and
// not towards 0, so that what rests does not creep. Wedged parts keep no more than a few weights.
void Rows::set_step_bias(const Model& model, const Vec3& gravity, const Evaluation& middle,
                         double h) {
    const double most = kAnchorWeights * model.mass * kEarthGravity * h;
    for (int c = 0; c < contacts_.count; ++c) {
        const Contact& contact = contacts_.items[c];
        const Kinematics& k = middle.kinematics;
        const Vec3 acceleration = contact_acceleration(middle, contact, surface_of(k, contact),
                                                       place_of(k, contact), gravity);
        for (std::size_t d = 0; d < 3; ++d) {
            const std::size_t row = first_row(c) + d;
            acceleration_[row] = acceleration[static_cast<int>(d)];
            impulse_[row] = h * guess_[c][static_cast<int>(d)];
            bias_[row] = rate_[row] + h * acceleration_[row];
            if (d == 0)
                bias_[row] += slack_of(contact.gap - kRestingGap, rate_[row], h, kPushSpeed);
            else
                bias_[row] -= softness_[row] * std::clamp(impulse_[row], -most, most);
        }
    }
    for (std::size_t s = 0; s < stops_.size(); ++s) {
        const Stop& stop = stops_[s];
        const std::size_t row = first_row(contacts_.count) + s;
        acceleration_[row] = stop.sum(middle.response.joint) + stop.bias;
        impulse_[row] = 0.0;
        bias_[row] =
            rate_[row] + h * acceleration_[row] + slack_of(stop.gap, rate_[row], h, kStopPushSpeed);
    }
}

ConeProblem Rows::problem() const {
    return {contacts_.count, static_cast<int>(stops_.size()), friction_, matrix_.data(),
            bias_.data()};
}

// The impulses are the first guess. Where the solver fails, it is improved by sweeps instead.
bool Rows::solve(double friction, int fallback_sweeps) {
    friction_ = friction;
    const ConeProblem rows = problem();
    std::copy_n(impulse_.begin(), row_count(), undone_.begin());
    if (solver_.solve(rows, impulse_.data())) return true;
    std::copy_n(undone_.begin(), row_count(), impulse_.begin());
    ConeSolver::sweep(rows, fallback_sweeps, impulse_.data());
    return false;
}

// Returns the change of a row's rate by the impulses.
double Rows::effect(int row) const {
    double sum =
        -softness_[static_cast<std::size_t>(row)] * impulse_[static_cast<std::size_t>(row)];
    for (int j = 0; j < row_count(); ++j)
        sum += at(row, j) * impulse_[static_cast<std::size_t>(j)];
    return sum;
}

double Rows::step_work(double h) const {
    double work = 0.0;
    for (int row = 0; row < row_count(); ++row) {
        const auto r = static_cast<std::size_t>(row);
        if (impulse_[r] == 0.0) continue;
        work += impulse_[r] * (rate_[r] + 0.5 * (h * acceleration_[r] + effect(row)));
    }
    return work;
}

bool Rows::solve_step(const Model& model, const Vec3& gravity, double friction,
                      const Evaluation& middle, double length) {
    build(model, middle, kStepSoftness);
    set_step_bias(model, gravity, middle, length);
    const bool settled = solve(friction, kStepSweeps);
    const double allowed = kWorkAllowance * model.mass * kEarthGravity;
    if (step_work(length) <= allowed) return settled;
    for (const double tried : {friction, 0.0}) {
        friction_ = tried;
        std::fill_n(impulse_.begin(), row_count(), 0.0);
        ConeSolver::sweep(problem(), kSweepsFromZero, impulse_.data());
        if (step_work(length) <= allowed) break;
    }
    return false;
}

double Rows::impact_work(int row) const {
    const auto r = static_cast<std::size_t>(row);
    return impulse_[r] * (rate_[r] + 0.5 * effect(row));
}

// No impact gives energy; one that would is solved again without restitution, and last without
// friction.
Rows::Impact Rows::solve_impact(const Model& model, double friction, double restitution,
                                const Evaluation& evaluation) {
    build(model, evaluation, kImpactSoftness);
    const double allowed = kLeastWork * model.mass * kEarthGravity;
    Impact impact;
    for (int attempt = 0; attempt < 3; ++attempt) {
        for (int row = 0; row < row_count(); ++row) {
            const auto r = static_cast<std::size_t>(row);
            const bool bounces = attempt == 0 && row < 3 * contacts_.count && row % 3 == 0 &&
                                 rate_[r] < -kRestingSpeed;
            bias_[r] = rate_[r] + (bounces ? restitution * rate_[r] : 0.0);
            impulse_[r] = 0.0;
        }
        impact.settled &= solve(attempt < 2 ? friction : 0.0, kImpactSweeps);
        impact.work = 0.0;
        for (int row = 0; row < row_count(); ++row)
            impact.work += impact_work(row);
        if (impact.work <= allowed) break;
        impact.settled = false;
    }
    return impact;
}

bool Rows::holds_something() const {
    for (int row = 0; row < row_count(); ++row) {
        if (impulse_[static_cast<std::size_t>(row)] != 0.0) return true;
    }
    return false;
}

void Rows::add_push(double scale, Push& push) const {
    for (int c = 0; c < contacts_.count; ++c) {
        const Contact& contact = contacts_.items[c];
        for (std::size_t row = first_row(c); row < first_row(c) + 3; ++row) {
            const Six wrench = scale * impulse_[row] * direction_[row];
            push.wrench[contact.body] += wrench;
            if (!contact.is_on_ground()) push.wrench[contact.other_body] += -1.0 * wrench;
        }
    }
    for (std::size_t s = 0; s < stops_.size(); ++s)
        stops_[s].add_effort(scale * impulse_[first_row(contacts_.count) + s], push);
}

// Factorizes the matrix of the rows that push: of contacts that stick all three. Returns false if
// there are none.
bool Rows::factorize_active() {
    active_.clear();
    for (int c = 0; c < contacts_.count; ++c) {
        const double* p = impulse_.data() + first_row(c);
        if (!(p[0] > 0.0)) continue;
        const int first = 3 * c;
        active_.push_back(first);
        if (!(std::sqrt(p[1] * p[1] + p[2] * p[2]) < kCircleShare * friction_ * p[0])) continue;
        active_.push_back(first + 1);
        active_.push_back(first + 2);
    }
    for (int row = 3 * contacts_.count; row < row_count(); ++row) {
        if (impulse_[static_cast<std::size_t>(row)] > 0.0) active_.push_back(row);
    }
    const std::size_t size = active_.size();
    for (std::size_t i = 0; i < size; ++i) {
        double* own = factor_.data() + i * size;
        for (std::size_t j = 0; j <= i; ++j) {
            const double* other = factor_.data() + j * size;
            double sum = at(active_[i], active_[j]);
            for (std::size_t k = 0; k < j; ++k)
                sum -= own[k] * other[k];
            if (i == j && !(sum > 0.0)) return false;
            own[j] = i == j ? std::sqrt(sum) : sum / other[j];
        }
    }
    return size > 0;
}

void Rows::absorb_one(const Model& model, const Evaluation& middle, Change& change) {
    const Kinematics& k = middle.kinematics;
    // Velocities of the bodies whose common centre of mass stays.
    Six velocity[kMostBodies];
    velocity[0] = {change.root, Vec3::Zero()};
    Vec3 mean = cross(change.root, k.place[0]) * model.bodies[0].mass;
    for (int b = 1; b < model.body_count; ++b) {
        const Body& body = model.bodies[b];
        velocity[b] = velocity[body.parent];
        for (int d = body.first_degree; d < body.first_degree + body.degree_count; ++d)
            velocity[b] += change.joint[d] * k.axis[d];
        mean += body.mass * (velocity[b].linear + cross(velocity[b].angular, k.place[b]));
    }
    const Vec3 drift = change.center - mean / model.mass;
    const std::size_t size = active_.size();
    double* x = undone_.data();
    for (std::size_t i = 0; i < size; ++i) {
        const int row = active_[i];
        const int stop = row - 3 * contacts_.count;
        if (stop < 0) {
            const auto r = static_cast<std::size_t>(row);
            const Six& direction = direction_[r];
            x[i] = dot(direction, velocity[body_[r]]);
            x[i] +=
                other_[r] < 0 ? dot(direction.linear, drift) : -dot(direction, velocity[other_[r]]);
        } else {
            x[i] = stops_[static_cast<std::size_t>(stop)].sum(change.joint);
        }
        for (std::size_t j = 0; j < i; ++j)
            x[i] -= factor_[i * size + j] * x[j];
        x[i] /= factor_[i * size + i];
    }
    Push push;
    for (std::size_t i = size; i-- > 0;) {
        for (std::size_t j = i + 1; j < size; ++j)
            x[i] -= factor_[j * size + i] * x[j];
        x[i] /= factor_[i * size + i];
        const int row = active_[i];
        const int stop = row - 3 * contacts_.count;
        if (stop < 0) {
            const auto r = static_cast<std::size_t>(row);
            push.wrench[body_[r]] += -x[i] * direction_[r];
            if (other_[r] >= 0) push.wrench[other_[r]] += x[i] * direction_[r];
        } else {
            stops_[static_cast<std::size_t>(stop)].add_effort(-x[i], push);
        }
    }
    Response response;
    respond(model, k, middle.factors, push, response);
    change.add(model, response, push);
}

void Rows::absorb(const Model& model, const Evaluation& middle, Change& first, Change& second) {
    if (!factorize_active()) return;
    absorb_one(model, middle, first);
    absorb_one(model, middle, second);
}

RowWork Rows::work(const Model& model, const Motion& start, const Kinematics& start_kinematics,
                   const Motion& end, const Kinematics& end_kinematics, double length) const {
    RowWork work;
    const int center = model.place();
    const Vec3 moved =
        coordinate_vector(end.position + center) - coordinate_vector(start.position + center);
    for (int c = 0; c < contacts_.count; ++c) {
        const Contact& contact = contacts_.items[c];
        const double* p = impulse_.data() + first_row(c);
        Vec3 way = place_of(end_kinematics, contact) - place_of(start_kinematics, contact);
        if (contact.is_on_ground())
            way += moved;
        else
            way -= met_place(end_kinematics, c) - met_place(start_kinematics, c);
        double done = 0.0;
        for (std::size_t d = 0; d < 3; ++d)
            done += p[d] * dot(way, direction_[first_row(c) + d].linear);
        done /= length;
        work.contact += done;
        work.positive += std::max(0.0, done);
    }
    for (std::size_t s = 0; s < stops_.size(); ++s) {
        const Stop& stop = stops_[s];
        const double way = stop.sum(end.position) - stop.sum(start.position);
        const double done = impulse_[first_row(contacts_.count) + s] / length * way;
        work.limit += done;
        work.positive += std::max(0.0, done);
    }
    return work;
}

bool Rows::covers(const Contact& contact) const {
    for (int c = 0; c < contacts_.count; ++c) {
        if (are_of_one_pair(contacts_.items[c], contact)) return true;
    }
    return false;
}

double Rows::impact_loss(int contact) const {
    double work = 0.0;
    for (int row = 3 * contact; row < 3 * contact + 3; ++row)
        work += impact_work(row);
    return -work;
}

void Rows::store(double length, HeldContacts& held) const {
    held.count = contacts_.count;
    for (int c = 0; c < contacts_.count; ++c) {
        const Contact& contact = contacts_.items[c];
        const double* p = impulse_.data() + first_row(c);
        held.items[c] = {contact.id,
                         contact.body,
                         contact.other_body,
                         contact.point,
                         contact.surface.axis[0],
                         Vec3(p[0], p[1], p[2]) / length};
    }
}

}  // namespace cambrian::spatial
