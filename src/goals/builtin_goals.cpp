#include "goals/goal.h"

namespace cambrian {

void register_walking(GoalRegistry& goals);
void register_jumping(GoalRegistry& goals);
void register_swimming(GoalRegistry& goals);
void register_seeking(GoalRegistry& goals);
void register_flying(GoalRegistry& goals);
void register_competition(GoalRegistry& goals);
void register_escape(GoalRegistry& goals);
void register_fleeing(GoalRegistry& goals);
void register_climbing(GoalRegistry& goals);
void register_course(GoalRegistry& goals);

GoalRegistry builtin_goals() {
    GoalRegistry goals;
    register_walking(goals);
    register_jumping(goals);
    register_swimming(goals);
    register_seeking(goals);
    register_flying(goals);
    register_competition(goals);
    register_escape(goals);
    register_fleeing(goals);
    register_climbing(goals);
    register_course(goals);
    return goals;
}

}  // namespace cambrian
