#include "simulator/audit.h"

#include "support/catch.h"
#include "support/kinds.h"

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

TEST_CASE("an audit is suspect if a body spins itself up", "[simulator][audit]") {
    SceneAudit audit;
    audit.energy_scale = 1.0;
    audit.spin_scale = 4.0;
    audit.spin_gained = 0.0039;
    CHECK(judge(audit) == AuditVerdict::kClean);
    audit.spin_gained = 0.0041;
    CHECK(judge(audit) == AuditVerdict::kSuspect);
}

TEST_CASE("a trial whose motion could not be computed is invalid", "[simulator][audit]") {
    TrialRecord record;
    record.audit.energy_scale = 1.0;
    for (const Outcome outcome : {Outcome::kCompleted, Outcome::kDisqualified}) {
        record.outcome = outcome;
        CHECK(judge(record) == AuditVerdict::kClean);
    }
    for (const Outcome outcome : {Outcome::kDiverged, Outcome::kOverBudget}) {
        record.outcome = outcome;
        CHECK(judge(record) == AuditVerdict::kInvalid);
    }
}

TEST_CASE("finer settings are those of the most accurate integrator, with more work allowed",
          "[simulator][audit]") {
    SceneSettings settings;
    settings.motor_frequency = 31.0;
    const SceneSettings finer = finer_settings(settings, test::kinds().creature.scene);
    CHECK(finer.integrator == "dormand-prince");
    CHECK(finer.tolerance == Approx(0.025 * settings.tolerance));
    CHECK(finer.contact_step == Approx(0.25 * settings.contact_step));
    CHECK(finer.max_evaluations > settings.max_evaluations);
    CHECK(finer.motor_frequency == 31.0);
}
