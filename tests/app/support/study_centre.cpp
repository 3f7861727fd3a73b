// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/support/study_centre.h"

#include "app/services/people/people_service.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/rubric_service.h"
#include "db/repository/system/setting_repository.h"
#include "tests/support/stored_rows.h"

namespace torsio {

ScoringPlan PaperStudy::plan(std::uint64_t seed) const {
  return {.cohortId = cohortId,
          .occasionCodes = {"pre", "mid", "post"},
          .raterIds = chiefs,
          .rubricRevisionId = rubric,
          .seed = seed};
}

Sheet evenSheet(const RubricRevision& rubric, std::int64_t overall_steps, std::int64_t row_steps) {
  Sheet sheet{.overall_steps = overall_steps};
  for (const RubricLine& row : rubric.rows) {
    sheet.rows.push_back({row.code, row_steps, ""});
  }
  return sheet;
}

StudyCentre::StudyCentre(const std::string& locator) : TestRecord(7, locator) {
  session_->setPasswordCost(PasswordCost::kTest);
  for (const std::string& role : storedRoles(connection())) {
    addUser(role, {}, role, kStudyPassword);
  }
  SettingRepository(connection()).set("two_people", "no", now_us());  // one administrator may do everything
}

SessionContext& StudyCentre::as(const std::string& role) {
  session_->setActor(actorOf(role));
  return *session_;
}

SessionContext& StudyCentre::asRater(const RaterId& raterId) {
  Actor actor = actorOf("rater");
  actor.personId = raterId;
  session_->setActor(actor);
  return *session_;
}

PaperStudy StudyCentre::addStudy(std::size_t trainees, std::size_t chiefs) {
  PaperStudy study{.trainees = addTrainees(trainees)};
  if (chiefs > 0) {
    study.chiefs = addChiefs(chiefs);
    study.rubric = addPaperRubric();
  }
  study.cohortId = addCohort(session(), {.name = "Study", .curriculumVersionId = runPaperCurriculum()});
  study.enrolmentIds = enrolTrainees(session(), study.cohortId, study.trainees);
  return study;
}

void StudyCentre::allocate(const CohortId& cohortId) {
  AllocationPlan plan;
  plan.cohortId = cohortId;
  lockAllocation(as("allocator"), plan);
  allocateAll(session(), cohortId);
}

std::vector<TraineeId> StudyCentre::addTrainees(std::size_t count) {
  as("administrator");
  std::vector<TraineeId> ids;
  for (std::size_t i = 0; i < count; ++i) {
    ids.push_back(addPerson(*session_, {.fullName = "Trainee " + std::to_string(i + 1),
                                        .externalId = "S-" + std::to_string(1001 + i),
                                        .sex = i % 2 == 0 ? "female" : "male",
                                        .level = i % 3 == 0 ? "doctoral student" : "graduate"}));
  }
  return ids;
}

std::vector<RaterId> StudyCentre::addChiefs(std::size_t count) {
  as("administrator");
  std::vector<RaterId> ids;
  for (std::size_t i = 0; i < count; ++i) {
    ids.push_back(addPerson(*session_, {.fullName = "Chief " + std::to_string(i + 1),
                                        .externalId = "C-" + std::to_string(2001 + i),
                                        .trainee = false,
                                        .raterClass = "chief"}));
  }
  return ids;
}

std::string StudyCentre::runPaperCurriculum() {
  as("administrator");
  for (const CurriculumTemplate& shipped : curriculumTemplates(assets())) {
    if (shipped.id != "paper-three-arms") {
      continue;
    }
    const CurriculumId id = addCurriculum(*session_, shipped.title, shipped.description, shipped.content);
    const CurriculumVersionId version = publishCurriculum(*session_, id, "first", assets());
    runCurriculum(*session_, version);
    return version;
  }
  return {};
}

std::string StudyCentre::addPaperRubric() {
  as("administrator");
  const std::vector<RubricTemplate> shipped = rubricTemplates(assets());
  return addRubric(*session_, shipped.at(0).title, shipped.at(0).revision);
}

std::map<std::string, std::int64_t> StudyCentre::rowCounts() {
  std::map<std::string, std::int64_t> counts;
  Statement table = connection().prepare("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
  table.execute();
  std::vector<std::string> names;
  while (table.step()) {
    names.push_back(table.text(0));
  }
  for (const std::string& name : names) {
    Statement row = connection().prepare("SELECT count(*) FROM " + name);
    row.execute();
    if (row.step()) {
      counts[name] = row.int64(0);
    }
  }
  return counts;
}

std::int64_t StudyCentre::audited(const std::string& action) {
  Statement row = connection().prepare("SELECT count(*) FROM audit_entry WHERE action = ?");
  row.execute({action});
  return row.step() ? row.int64(0) : 0;
}

}  // namespace torsio
