#pragma once

// Contacts and joint stops of one moment: impacts as impulses, resting and sliding as forces held
// over a step (physics.md 7.3, 7.4).

#include "dynamics/constraints/row_solver.h"
#include "dynamics/constraints/rows.h"
#include "dynamics/contact/contact.h"
#include "dynamics/contact/self_contacts.h"

namespace cambrian {

struct ContactLaw {
    double friction = 0.0;    // Coulomb
    double elasticity = 0.0;  // share of the normal speed kept
    bool has_ground = true;
};

// Forces of the last solved step; first guess of the next.
struct WarmStart {
    int count = 0;
    int id[kMaxContacts] = {};           // of the contacts, as collected
    double normal[kMaxContacts] = {};    // N
    double friction[kMaxContacts] = {};  // N; of pairs of boxes, at any one of their contacts
    PerBody ground_friction = {};        // N
    PerBody limit = {};                  // N m or N, signed as the effort
};

// Works of the held forces over a step, J.
struct HeldWork {
    double contact = 0.0;
    double limit = 0.0;
    double positive = 0.0;  // sum of every contact's and stop's positive work
};

struct ImpactResult {
    double work = 0.0;  // J
    bool fell_back = false;
};

class ContactSolver {
public:
    // Looks for everything near at the given place.
    void collect(const PlanarModel& model, const ContactLaw& law, const Kinematics& kinematics);
    const ContactSet& near() const { return near_; }

    // Whether a touching contact closes faster than kRestingSpeed.
    bool has_impact() const;

    // Solves the impact of everything that touches: changes the motion's speeds. The frame must be
    // that of the motion.
    ImpactResult strike(const PlanarModel& model, const ContactLaw& law, double elasticity,
                        const Frame& frame, Motion& motion);

    // Chooses the contacts and stops of a step of length h from what is near. False if there are
    // none. The frame is that of the step's start.
    bool choose(const PlanarModel& model, Frame& frame, double h);
    // Contacts of the last choose() or strike().
    const ContactSet& chosen() const { return chosen_; }
    bool covers(const Contact& contact) const;  // whether it or one in its place was chosen

    // Makes rows of what was chosen: at the step's start, or with the rates of its start and all
    // else as in the middle.
    void build(const PlanarModel& model, const ContactLaw& law, Frame& start);
    void build_between(const PlanarModel& model, const ContactLaw& law, const Kinematics& start,
                       const Frame& middle);

    // Solves the built rows for a step of length h, for the held forces. False if the active set
    // failed and a fallback was taken.
    bool hold(const PlanarModel& model, const ContactLaw& law, double h, WarmStart& warm);
    // Instead of hold(): nothing is held.
    void let_go();
    const HeldForces& held() const { return held_; }
    // The same as loads, at the places of the rows.
    void add_held(double h, Loads& loads) const {
        add_row_impulses(rows_, rows_.impulse, 1.0 / h, loads);
    }
    // Adds to the loads the impulses by which the rows that hold would take up changes of the
    // bodies' velocities.
    void absorb(const PlanarModel& model, const ContactLaw& law, const BodyResponse (&changes)[2],
                Loads (&loads)[2]);
    // Normal force of a chosen contact after hold(), N.
    double held_normal(int contact) const { return normal_force_[contact]; }
    // Normal impulse of a chosen contact after strike(), N s.
    double struck_normal(int contact) const;

    // Work of the held forces between two places.
    HeldWork held_work(const PlanarModel& model, const Kinematics& begin,
                       const Kinematics& end) const;

private:
    void choose_limits(const PlanarModel& model, const Frame& frame, double h);
    void pose_resting(const PlanarModel& model, double h, const WarmStart& warm);
    bool solve_resting(const PlanarModel& model, const ContactLaw& law, double h);
    double resting_work(double h) const;
    double impact_work() const;
    void store_forces(int body_count, double h, WarmStart& warm);

    PairList pair_list_;
    ContactSet near_;
    ContactSet chosen_;
    LimitSet limits_;
    HeldForces held_;
    RowSystem rows_;
    RowSolver solver_;
    double bias_[kMaxRows];
    double normal_force_[kMaxContacts];
};

}  // namespace cambrian
