#pragma once

// Contacts with the ground or between parts and stops of the joints as rows: rates u+ = u- + W p
// with impulses p (spatial/README.md 5 and 6). Impacts are solved as impulses, resting and sliding
// as forces that are constant over a step.

#include "spatial/cone_solver.h"
#include "spatial/contacts.h"
#include "spatial/evaluation.h"
#include "spatial/stops.h"

#include <vector>

namespace cambrian::spatial {

// Forces of contacts, N: the first guess of the next step, and what displays show.
struct HeldContacts {
    struct Item {
        int id = 0;  // Contact::id
        int body = 0;
        int other_body = -1;
        Vec3 point = Vec3::Zero();    // m, of the body
        Vec3 normal = Vec3::UnitY();  // in the axes of the other body
        Vec3 force = Vec3::Zero();    // along the axes of Contact::surface
    };
    int count = 0;
    Item items[kMostContacts];
};

// Changes of the speeds of the joints, the root and the centre of mass.
struct Change {
    double joint[kMostJointDegrees] = {};
    Vec3 root = Vec3::Zero();
    Vec3 center = Vec3::Zero();

    void add(const Model& model, const Response& response, const Push& push);
};

// Works of the constant forces over a step, J.
struct RowWork {
    double contact = 0.0;
    double limit = 0.0;
    double positive = 0.0;  // sum of every contact's and stop's positive work
};

// The moment at which rows are selected.
struct Moment {
    const Model& model;
    const Motion& motion;
    const Evaluation& evaluation;
    const Vec3& gravity;  // m/s^2
};

class Rows {
public:
    explicit Rows(const Model& model);

    // Selects the contacts and stops that may matter in a step of this length, with their gaps and
    // rates and the forces of the last step. Returns whether there are any.
    bool select(const Moment& start, const ContactSet& near, const HeldContacts& held,
                double length);
    // Selects those that touch.
    bool select_touched(const Moment& moment, const ContactSet& near);
    void clear();

    // Computes the impulses of a step of this length whose free accelerations and factors are those
    // of its middle. Returns false if the solver failed and a fallback was used.
    bool solve_step(const Model& model, const Vec3& gravity, double friction,
                    const Evaluation& middle, double length);
    struct Impact {
        double work = 0.0;  // J
        bool settled = true;
    };
    // Computes the impulses of an impact of everything selected.
    Impact solve_impact(const Model& model, double friction, double restitution,
                        const Evaluation& evaluation);

    bool holds_something() const;
    // Adds the impulses, times a scale.
    void add_push(double scale, Push& push) const;
    // Takes away from changes of speeds, in the middle of the step, what rows with impulses do not
    // let happen.
    void absorb(const Model& model, const Evaluation& middle, Change& first, Change& second);
    RowWork work(const Model& model, const Motion& start, const Kinematics& start_kinematics,
                 const Motion& end, const Kinematics& end_kinematics, double length) const;

    int contact_count() const { return contacts_.count; }
    const Contact& contact(int index) const { return contacts_.items[index]; }
    // Whether the contact, or another one of its pair of parts, is selected.
    bool covers(const Contact& contact) const;
    double normal_impulse(int contact) const { return impulse_[first_row(contact)]; }
    // Kinetic energy that an impact took at a contact, J.
    double impact_loss(int contact) const;
    // Stores the forces of a step of this length.
    void store(double length, HeldContacts& held) const;

private:
    Vec3 met_place(const Kinematics& k, int contact) const {
        const int b = contacts_.items[contact].other_body;
        return k.place[b] + k.turn[b] * met_[contact];
    }
    static std::size_t first_row(int contact) { return 3 * static_cast<std::size_t>(contact); }
    int row_count() const { return 3 * contacts_.count + static_cast<int>(stops_.size()); }
    std::size_t index_of(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(row_count()) +
               static_cast<std::size_t>(column);
    }
    double& at(int row, int column) { return matrix_[index_of(row, column)]; }
    double at(int row, int column) const { return matrix_[index_of(row, column)]; }
    void build(const Model& model, const Evaluation& middle, double tangent_softness);
    void place_contacts(const Kinematics& middle);
    void soften(const Model& model, const Kinematics& middle, double tangent_softness);
    void eliminate(const Model& model, const Evaluation& middle, int row);
    void set_step_bias(const Model& model, const Vec3& gravity, const Evaluation& middle,
                       double length);
    bool solve(double friction, int fallback_sweeps);
    double effect(int row) const;
    double impact_work(int row) const;
    double step_work(double length) const;
    ConeProblem problem() const;
    bool factorize_active();
    void absorb_one(const Model& model, const Evaluation& middle, Change& change);

    ContactSet contacts_;
    Vec3 guess_[kMostContacts];  // N, force of the last step, along the axes of the surface
    // The point of the other body that the contact meets in the middle, m, in its axes.
    Vec3 met_[kMostContacts];
    std::vector<Stop> stops_;
    ConeSolver solver_;
    double friction_ = 0.0;       // of the present problem
    std::vector<Six> direction_;  // of the rows of contacts, in the middle
    std::vector<int> body_;       // on which a row acts
    std::vector<int> other_;      // on which it acts back, or -1
    std::vector<double> path_;    // of each row, what its unit impulse does at the degrees
    std::vector<double> root_;    // and at the root, times the inverse of its factor
    std::vector<double> matrix_;  // softened
    std::vector<double> softness_;
    std::vector<double> rate_;  // at the start
    std::vector<double> acceleration_;
    std::vector<double> bias_;
    std::vector<double> impulse_;
    std::vector<double> factor_;  // Cholesky factor of the active rows
    std::vector<int> active_;
    std::vector<double> undone_;
};

}  // namespace cambrian::spatial
