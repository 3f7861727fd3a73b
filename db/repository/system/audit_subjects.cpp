// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/audit_subjects.h"

#include <array>

#include "db/connection/row_reader.h"

namespace torsio {

namespace {

/// One query per kind of object for its display text; a condition on `x.id` is appended.
constexpr std::array kSubjects{
    "SELECT x.id, x.code FROM person x WHERE x.id",
    "SELECT x.id, x.login FROM app_user x WHERE x.id",
    "SELECT x.id, p.code FROM enrolment x JOIN person p ON p.id = x.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM trial x JOIN person p ON p.id = x.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM exposure x JOIN enrolment e ON e.id = x.enrolment_id"
    " JOIN person p ON p.id = e.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM deviation x JOIN enrolment e ON e.id = x.enrolment_id"
    " JOIN person p ON p.id = e.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM person_request x JOIN person p ON p.id = x.person_id WHERE x.id",
    "SELECT x.id, p.code FROM live_call x JOIN enrolment e ON e.id = x.enrolment_id"
    " JOIN person p ON p.id = e.trainee_id WHERE x.id",
    "SELECT x.id, p.code || ': ' || x.case_label FROM assignment x JOIN person p ON p.id = x.rater_id WHERE "
    "x.id",
    "SELECT x.id, p.code || ': ' || a.case_label FROM training_mark x JOIN assignment a ON a.id = "
    "x.assignment_id"
    " JOIN person p ON p.id = x.rater_id WHERE x.id",
    "SELECT x.id, p.code FROM allocation x JOIN enrolment e ON e.id = x.enrolment_id"
    " JOIN person p ON p.id = e.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM evaluation_mark x JOIN person p ON p.id = x.rater_id WHERE x.id",
    "SELECT x.id, p.code FROM rater_warmup x JOIN person p ON p.id = x.rater_id WHERE x.id",
    "SELECT x.id, p.code FROM trial_remark x JOIN trial t ON t.id = x.trial_id"
    " JOIN person p ON p.id = t.trainee_id WHERE x.id",  // a question has the id of its remark
    "SELECT x.id, p.code FROM duty_request x JOIN person p ON p.id = x.subject WHERE x.id",
    "SELECT x.id, u.login FROM duty_request x JOIN app_user u ON u.id = x.subject WHERE x.id",
    "SELECT x.id, c.name FROM allocation_design x JOIN cohort c ON c.id = x.cohort_id WHERE x.id",
    "SELECT x.id, c.name || ': ' || x.number FROM curriculum_version x"
    " JOIN curriculum c ON c.id = x.curriculum_id WHERE x.id",
    "SELECT x.id, c.name FROM deviation x JOIN cohort c ON c.id = x.cohort_id"
    " WHERE x.enrolment_id IS NULL AND x.id",
    "SELECT x.id, x.name FROM frozen_dataset x WHERE x.id",
    "SELECT x.id, x.name FROM cohort x WHERE x.id",
    "SELECT x.id, x.name FROM curriculum x WHERE x.id",
    "SELECT x.id, x.name FROM evaluation_campaign x WHERE x.id",
};

}  // namespace

std::map<std::string, std::string> auditSubjects(Connection& connection, std::int64_t fromSequence) {
  std::map<std::string, std::string> subjects;
  for (const char* select : kSubjects) {
    Statement statement = connection.prepare(
        std::string(select) + " IN (SELECT n.object_id FROM audit_entry n WHERE n.sequence >= ?)");
    statement.execute({fromSequence});
    while (statement.step()) {
      RowReader row(statement);
      std::string id = row.text();
      subjects.emplace(std::move(id), row.text());
    }
  }
  return subjects;
}

}  // namespace torsio
