#pragma once

// Contacts and joint limits at one state: impacts are solved as impulses, resting and sliding as
// forces that are constant over a step (planar/README.md 11 and 12).

#include "planar/constraints/complementarity_solver.h"
#include "planar/constraints/rows.h"
#include "planar/contact/contact.h"
#include "planar/contact/self_contacts.h"
#include "world/fixed_box.h"
#include "world/terrain.h"

#include <span>

namespace cambrian {

struct ContactLaw {
    double friction = 0.0;     // Coulomb's coefficient
    double restitution = 0.0;  // coefficient of restitution, 0 to 1
    bool has_ground = true;
    std::span<const FixedBox> fixed = {};
    const Terrain* terrain = nullptr;  // the shape of the ground, if it is not flat
};

// Forces of the last solved step, the first guess of the next.
struct WarmStart {
    int count = 0;
    int id[kMaxContacts] = {};           // of the contacts, in the order of detection
    double normal[kMaxContacts] = {};    // N
    double friction[kMaxContacts] = {};  // N; of pairs of boxes, at one of their contacts
    PerBody ground_friction = {};        // N
    PerBody limit = {};                  // N m or N, signed as the effort
};

// Works of the constant forces over a step, J.
struct HeldWork {
    double contact = 0.0;
    double limit = 0.0;
    double positive = 0.0;  // sum of every contact's and stop's positive work
};

inline constexpr int kMostLooks = 128;  // at a motion within a step

struct ImpactResult {
    double work = 0.0;  // J
    bool fell_back = false;
};

class ContactSolver {
public:
    // Detects all near contacts at the given positions.
    void detect(const PlanarModel& model, const ContactLaw& law, const Kinematics& kinematics);
    const ContactSet& near() const { return near_; }
    // Returns into how many equal parts the motion between the last two detections must be divided
    // so that no two boxes, of which one may be fixed or a ridge of the ground, can pass each other
    // unseen within one of them; 1 if they cannot within the whole. Not more than kMostLooks + 1.
    int count_looks(const PlanarModel& model, const ContactLaw& law, const Kinematics& from,
                    const Kinematics& to);
    // Before another one.
    void forget_model() {
        pair_list_.forget();
        has_sides_ = false;
    }

    // Whether a touching contact closes faster than kRestingSpeed.
    bool has_impact() const;

    // Solves the impact of everything that touches and changes the motion's speeds. The cache must
    // belong to the motion.
    ImpactResult solve_impact(const PlanarModel& model, const ContactLaw& law, double restitution,
                              const EvaluationCache& cache, Motion& motion);

    // Selects the contacts and limits of a step of length h from the near ones. Returns false if
    // there are none. The cache belongs to the step's start.
    bool select_active(const PlanarModel& model, EvaluationCache& cache, double h);
    // Contacts of the last select_active() or solve_impact().
    const ContactSet& selected() const { return selected_; }
    // Whether the contact, or another of the same overlapping pair, was selected.
    bool covers(const Contact& contact) const;

    // Build the rows of the selected contacts and limits: at the step's start, or with the rates of
    // the start and everything else of the middle.
    void build(const PlanarModel& model, const ContactLaw& law, EvaluationCache& start);
    void build_between(const PlanarModel& model, const ContactLaw& law, const Kinematics& start,
                       const EvaluationCache& middle);

    // Solves the rows for a step of length h; held() has the forces. Returns false if the active
    // set failed and a fallback was used.
    bool solve_resting(const PlanarModel& model, const ContactLaw& law, double h, WarmStart& warm);
    // Replaces solve_resting() for a step without rows: sets all forces to 0.
    void clear();
    const HeldForces& held() const { return held_; }
    // Adds the forces to the loads, at the positions of the rows.
    void add_held(double h, Loads& loads) const {
        add_row_impulses(rows_, rows_.impulse, 1.0 / h, loads);
    }
    // Whether some of these forces are not 0.
    bool holds_something() const;
    // Adds to the loads the impulses by which active rows undo changes of the bodies' velocities.
    // Returns false if all are 0.
    bool absorb(const PlanarModel& model, const ContactLaw& law, const BodyResponse (&changes)[2],
                Loads (&loads)[2]);
    // Normal force of a selected contact after solve_resting(), N.
    double held_normal(int contact) const { return normal_force_[contact]; }
    // Normal impulse of a selected contact after solve_impact(), N s.
    double normal_impulse_of(int contact) const;
    // Work of the impact at a selected contact after solve_impact(), J. The friction that contacts
    // share counts for the first of them.
    double impact_work_of(int contact) const;

    // Work of the constant forces between the positions at the ends of a step.
    HeldWork held_work(const PlanarModel& model, const Kinematics& begin,
                       const Kinematics& end) const;

private:
    void select_limits(const PlanarModel& model, const EvaluationCache& cache, double h);
    void add_limits(const PlanarModel& model, const Kinematics& kinematics, int first, unsigned low,
                    unsigned high);
    void set_resting_bias(const PlanarModel& model, double h, const WarmStart& warm);
    bool solve_rows(const PlanarModel& model, const ContactLaw& law, double h);
    double resting_work(double h) const;
    double impact_work_of_row(int row) const;
    double impact_work() const;
    void store_forces(int body_count, double h, WarmStart& warm);

    PairList pair_list_;
    PartPlaces places_[2];  // of the last two detections
    int latest_ = 0;        // of them
    BoxSides sides_;        // of the model, or at the last two detections if it deforms
    bool has_sides_ = false;
    int terrain_guess_ = 0;  // near the piece of the terrain that was found last
    ContactSet near_;
    ContactSet selected_;
    LimitSet limits_;
    HeldForces held_;
    ConstraintSystem rows_;
    ComplementaritySolver solver_;
    double bias_[kMaxRows];
    double normal_force_[kMaxContacts];
};

}  // namespace cambrian
