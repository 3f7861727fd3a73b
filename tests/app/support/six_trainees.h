// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/study/cohort_service.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "tests/app/support/study_centre.h"

namespace torsio {

/// Six trainees in three groups with the paper's curriculum, three chiefs, the shipped rubric.
struct SixTrainees : PaperStudy {
  StudyCentre centre;

  SixTrainees() { PaperStudy::operator=(centre.addStudy(6, 3)); }
  void allocate() { centre.allocate(cohortId); }
  [[nodiscard]] StudyArm armOf(const EnrolmentId& enrolmentId) {
    SessionContext& session = centre.as("administrator");
    const CohortRow cohort = cohorts(session).at(0);
    const auto version =
        CurriculumRepository(session.connectionWithoutRight()).version(cohort.cohort.curriculumVersionId);
    for (const Enrolment& enrolment : enrolments(session, cohortId)) {
      if (enrolment.id != enrolmentId) {
        continue;
      }
      for (const StudyGroup& group : cohort.groups) {
        for (const StudyArm& arm : version->arms) {
          if (group.id == enrolment.groupId && arm.id == group.armId) {
            return arm;
          }
        }
      }
    }
    return {};
  }
  /// Submits every open sheet like the raters would.
  void submitAll(const std::string& occasionCode) {
    SheetRepository sheets(centre.connection());
    const RubricRevision revision = RubricRepository(centre.connection()).revision(rubric).value();
    for (const AssignmentStatus& status : sheets.assignments(cohortId)) {
      if (status.assignment.occasionCode != occasionCode || status.state != SheetState::kOpen) {
        continue;
      }
      const Sheet sheet = evenSheet(revision, 70, 70);
      sheets.submit(status.assignment.id, centre.session().ids().newUuid(), sheet, "",
                    centre.session().now_us());
    }
  }
};

}  // namespace torsio

namespace torsio::testing {
using torsio::SixTrainees;
}  // namespace torsio::testing
