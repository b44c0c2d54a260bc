#pragma once

// The tables of an experiment file; assets/help/experiment_file.md describes them for users.

#include "core/result.h"
#include "evolution/individual/individual.h"
#include "persist/records/statistics_columns.h"
#include "persist/sqlite/columns.h"
#include "persist/sqlite/database.h"

#include <array>

namespace cambrian {

// Identifies experiment files in the SQLite header, also for the command `file`: "Camb".
inline constexpr std::int64_t kExperimentApplication = 0x43616d62;
// The same of files of a preserve: "Camp".
inline constexpr std::int64_t kPreserveApplication = 0x43616d70;
// The version rises whenever a table changes; older files are upgraded step by step.
inline constexpr std::int64_t kExperimentVersion = 4;
// Limits the settings that are read and checked when an experiment is opened.
inline constexpr std::int64_t kMostSettingsChanges = 5000;

// Columns of a score; outcome, verdict and finer trial have columns of their own.
inline constexpr std::array kResultColumns = {
    Column<EvaluationResult>{"fitness", &EvaluationResult::fitness},
    Column<EvaluationResult>{"reason", &EvaluationResult::reason},
    Column<EvaluationResult>{"digest", &EvaluationResult::digest},
    Column<EvaluationResult>{"phenotype", &EvaluationResult::phenotype},
    Column<EvaluationResult>{"body_length", &EvaluationResult::body_length},
    Column<EvaluationResult>{"mass", &EvaluationResult::mass},
    Column<EvaluationResult>{"parts", &EvaluationResult::parts},
    Column<EvaluationResult>{"neurons", &EvaluationResult::neurons},
    Column<EvaluationResult>{"computed_time", &EvaluationResult::computed_time},
    Column<EvaluationResult>{"work", &EvaluationResult::work},
    Column<EvaluationResult>{"hopeless", &EvaluationResult::terminable},
};
// Columns added by version 3.
inline constexpr std::array kLaterResultColumns = {
    Column<EvaluationResult>{"plan", &EvaluationResult::plan},
};
inline constexpr std::array kBehaviorColumns = {
    Column<Behavior>{"settled_height", &Behavior::settled_height},
    Column<Behavior>{"contact_share", &Behavior::contact_share},
    Column<Behavior>{"joint_frequency", &Behavior::joint_frequency},
    Column<Behavior>{"mean_joint_frequency", &Behavior::mean_joint_frequency},
    Column<Behavior>{"travel", &Behavior::travel},
    Column<Behavior>{"stir", &Behavior::stir},
    Column<Behavior>{"movable_joints", &Behavior::movable_joints},
};
inline constexpr std::array kAuditColumns = {
    Column<SceneAudit>{"motor_work", &SceneAudit::motor_work},
    Column<SceneAudit>{"gross_motor_work", &SceneAudit::gross_motor_work},
    Column<SceneAudit>{"drag_work", &SceneAudit::drag_work},
    Column<SceneAudit>{"contact_work", &SceneAudit::contact_work},
    Column<SceneAudit>{"limit_work", &SceneAudit::limit_work},
    Column<SceneAudit>{"impulse_work", &SceneAudit::impulse_work},
    Column<SceneAudit>{"positive_work", &SceneAudit::positive_work},
    Column<SceneAudit>{"energy_residual", &SceneAudit::energy_residual},
    Column<SceneAudit>{"energy_scale", &SceneAudit::energy_scale},
    Column<SceneAudit>{"max_penetration", &SceneAudit::max_penetration},
    Column<SceneAudit>{"max_limit_overrun", &SceneAudit::max_limit_overrun},
    Column<SceneAudit>{"max_part_speed", &SceneAudit::max_part_speed},
    Column<SceneAudit>{"max_part_spin", &SceneAudit::max_part_spin},
    Column<SceneAudit>{"acceleration_evaluations", &SceneAudit::evaluations},
    Column<SceneAudit>{"steps", &SceneAudit::steps},
    Column<SceneAudit>{"rejections", &SceneAudit::rejections},
    Column<SceneAudit>{"events", &SceneAudit::events},
    Column<SceneAudit>{"fallbacks", &SceneAudit::fallbacks},
};

// Upgrades the tables from version 2 to version 3: founder lines, body plans, confirmed scores.
void add_lines_and_confirmations(Database& database);

// Creates the tables in an empty database.
void create_tables(Database& database);

// Returns the version of an experiment's tables. Fails if the file is not an experiment or is newer
// than this program; the message says what it is.
Result<std::int64_t> version_of_tables(const Database& database);
// Checks that every table is as this version creates it.
Status check_tables(const Database& database);

}  // namespace cambrian
