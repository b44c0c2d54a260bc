#include "simulator/audit.h"

#include "support/catch.h"

using namespace cambrian;

TEST_CASE("an audit is suspect above 5 % unexplained or 10 % given energy", "[simulator][audit]") {
    SceneAudit audit;
    audit.energy_scale = 2.0;
    CHECK(judge(audit) == AuditVerdict::kClean);
    audit.energy_residual = -0.099;
    audit.positive_work = 0.199;
    CHECK(judge(audit) == AuditVerdict::kClean);
    audit.energy_residual = -0.101;
    CHECK(judge(audit) == AuditVerdict::kSuspect);
    audit.energy_residual = 0.0;
    audit.positive_work = 0.201;
    CHECK(judge(audit) == AuditVerdict::kSuspect);
}
