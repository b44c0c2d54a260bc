#include "simulator/audit.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kMaxResidualShare = 0.05;
constexpr double kMaxPositiveShare = 0.10;

}  // namespace

AuditVerdict judge(const SceneAudit& audit) {
    const bool clean = std::fabs(audit.energy_residual) <= kMaxResidualShare * audit.energy_scale &&
                       audit.positive_work <= kMaxPositiveShare * audit.energy_scale;
    return clean ? AuditVerdict::kClean : AuditVerdict::kSuspect;
}

}  // namespace cambrian
