#include "simulator/audit.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kMaxResidualShare = 0.05;
constexpr double kMaxPositiveShare = 0.10;
constexpr double kMaxSpinShare = 1e-3;
constexpr double kFinerTolerance = 0.025;
constexpr double kFinerContactStep = 0.25;
constexpr double kFinerWork = 10.0;  // limit for the work, as a multiple of the original's

}  // namespace

std::string_view verdict_name(AuditVerdict verdict) {
    switch (verdict) {
        case AuditVerdict::kClean:
            return "clean";
        case AuditVerdict::kSuspect:
            return "suspect";
        case AuditVerdict::kInvalid:
            return "invalid";
    }
    return "unknown";
}

AuditVerdict judge(const SceneAudit& audit) {
    const bool clean = std::fabs(audit.energy_residual) <= kMaxResidualShare * audit.energy_scale &&
                       audit.positive_work <= kMaxPositiveShare * audit.energy_scale &&
                       audit.spin_gained <= kMaxSpinShare * audit.spin_scale;
    return clean ? AuditVerdict::kClean : AuditVerdict::kSuspect;
}

AuditVerdict judge(const TrialRecord& record) {
    const bool aborted =
        record.outcome == Outcome::kDiverged || record.outcome == Outcome::kOverBudget;
    return aborted ? AuditVerdict::kInvalid : judge(record.audit);
}

SceneSettings finer_settings(const SceneSettings& settings, const SceneKind& scene) {
    SceneSettings finer = settings;
    finer.integrator = scene.accurate_integrator;
    finer.tolerance *= kFinerTolerance;
    finer.contact_step *= kFinerContactStep;
    finer.max_evaluations *= kFinerWork;
    return finer;
}

}  // namespace cambrian
