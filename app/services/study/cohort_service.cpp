// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/cohort_service.h"

#include <algorithm>
#include <set>
#include <tuple>

#include <nlohmann/json.hpp>

#include "app/services/base/identifiers.h"
#include "app/services/study/day_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

void checkName(StudyRepository& study, const CohortId& own, const std::string& name) {
  if (name.empty()) {
    refuseParameter(Text::tr("the cohort has no name"), Text::tr("cohort"), Text::tr("Enter one"));
  }
  requireReadable(name, Text::tr("cohort"));
  for (const Cohort& other : study.cohorts()) {
    if (other.id != own && likenessOf(other.name) == likenessOf(name)) {
      refuseParameter(Text::tr("another cohort has this name"), name, Text::tr("Choose another name"));
    }
  }
}

void checkNewCohort(const NewCohort& cohort) {
  const auto bad = [](const Text& what, const Text& remedy) {
    refuseParameter(what, Text::tr("cohort"), remedy);
  };
  if (cohort.groups.empty() && cohort.curriculumVersionId.empty()) {
    bad(Text::tr("the cohort has no groups"),
        Text::tr("Name its groups, or choose a curriculum whose arms they follow"));
  }
  if (cohort.equivalenceMargin &&
      !(*cohort.equivalenceMargin > 0.0 && *cohort.equivalenceMargin <= kLargestMargin)) {
    bad(Text::tr("a margin of equivalence lies above 0 and is at most %1 points", kLargestMargin),
        Text::tr("Enter the largest difference that does not matter, or none"));
  }
  std::set<std::string> codes;
  for (const NewGroup& group : cohort.groups) {
    if (group.code.empty()) {
      bad(Text::tr("a group has no code"), Text::tr("Give each group a short code, such as G1"));
    }
    requireReadable(group.code, Text::tr("cohort"));
    requireReadable(group.label, Text::tr("cohort"));
    if (!codes.insert(likenessOf(group.code)).second) {
      bad(Text::tr("two groups are called %1", group.code), Text::tr("Rename one of them"));
    }
  }
}

/// Returns cohorts with people expected, called or training today, or sheets due by the end of the day.
std::set<CohortId> cohortsOfToday(SessionContext& session) {
  const std::int64_t from_us = session.now_us() - kHalfDay_us;
  const std::int64_t to_us = session.now_us() + kHalfDay_us;
  std::set<CohortId> today;
  for (const CohortId& id : StudyRepository(session.connection()).cohortsAtWork(from_us, to_us)) {
    today.insert(id);
  }
  for (const CohortId& id : SheetRepository(session.connection()).cohortsWithRaterWork(from_us, to_us)) {
    today.insert(id);
  }
  return today;
}

}  // namespace

std::vector<CohortRow> cohorts(SessionContext& session) {
  session.require(Operation::kPersonViewCoded);
  StudyRepository study(session.connection());
  CurriculumRepository curricula(session.connection());
  std::vector<CohortRow> rows;
  const std::set<CohortId> today = cohortsOfToday(session);
  for (Cohort& cohort : study.cohorts()) {
    CohortRow row;
    row.groups = study.groups(cohort.id);
    for (const Enrolment& enrolment : study.enrolments(cohort.id)) {
      row.traineeCodes.push_back(enrolment.traineeCode);
      if (enrolment.state == EnrolmentState::kWithdrawn) {
        ++row.withdrawn;
        continue;
      }
      ++row.enrolled;
      if (!enrolment.groupId.empty()) {
        ++row.allocated;
      }
    }
    if (const auto version = curricula.version(cohort.curriculumVersionId)) {
      row.curriculumNumber = version->number;
      for (const Curriculum& curriculum : curricula.curricula()) {
        if (curriculum.id == version->curriculumId) {
          row.curriculumName = curriculum.name;
        }
      }
    }
    row.today = today.contains(cohort.id);
    row.cohort = std::move(cohort);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::size_t cohortShownFirst(std::span<const CohortRow> rows) {
  const auto rank = [](const CohortRow& row) {
    const CohortState state = row.cohort.state;
    return std::tuple(state != CohortState::kArchived, row.today,
                      row.allocated > 0 && state == CohortState::kRunning, row.allocated > 0, row.allocated);
  };
  std::size_t first = rows.size();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (first == rows.size() || !(rank(rows[i]) < rank(rows[first]))) {
      first = i;
    }
  }
  return first;
}

CohortId addCohort(SessionContext& session, const NewCohort& cohort) {
  session.require(Operation::kStudySetup);
  checkNewCohort(cohort);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  checkName(study, {}, cohort.name);
  const CohortId id = session.ids().newUuid();
  std::vector<NewGroup> names = cohort.groups;
  CurriculumRepository curricula(session.connection());
  if (names.empty()) {
    const auto version = curricula.version(cohort.curriculumVersionId);
    if (!version) {
      refuse(Text::tr("there is no such curriculum"), cohort.curriculumVersionId,
             Text::tr("Choose one from the list"));
    }
    for (const StudyArm& arm : version->arms) {
      names.push_back({arm.code, arm.label});
    }
  }
  std::vector<StudyGroup> groups;
  for (const NewGroup& group : names) {
    groups.push_back(
        {session.ids().newUuid(), id, static_cast<std::int64_t>(groups.size() + 1), group.code, group.label});
  }
  study.addCohort({.id = id,
                   .name = cohort.name,
                   .description = cohort.description,
                   .createdUtc_us = session.now_us(),
                   .demonstration = cohort.demonstration,
                   .equivalenceMargin = cohort.equivalenceMargin},
                  groups);
  nlohmann::json now{{"groups", nlohmann::json::array()}, {"curriculum_version", cohort.curriculumVersionId}};
  for (const StudyGroup& group : groups) {
    now["groups"].push_back(group.code);
  }
  if (cohort.equivalenceMargin) {
    now["equivalence_margin"] = *cohort.equivalenceMargin;
  }
  if (!cohort.curriculumVersionId.empty()) {
    curricula.assign(id, cohort.curriculumVersionId);
  }
  session.note(AuditAction::kCohortAdd, AuditObject::kCohort, id, now);
  transaction.commit();
  return id;
}

void renameCohort(SessionContext& session, const CohortId& cohortId, const std::string& name) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort before = study.cohort(cohortId);
  checkName(study, cohortId, name);
  study.renameCohort(cohortId, name);
  session.noteChange(AuditAction::kCohortRename, AuditObject::kCohort, cohortId, {{"name", before.name}},
                     {{"name", name}});
  transaction.commit();
}

namespace {

/// Throws unless the cohort can change to this state.
void checkStep(SessionContext& session, const Cohort& cohort, CohortState state) {
  const bool closes = state == CohortState::kClosed && cohort.state == CohortState::kRunning;
  const bool archives = state == CohortState::kArchived && cohort.state == CohortState::kClosed;
  const bool opens = state == CohortState::kRunning &&
                     (cohort.state == CohortState::kClosed || cohort.state == CohortState::kArchived);
  if (!closes && !archives && !opens) {
    refuse(Text::tr("the cohort is %1 and cannot become %2", std::string(storedText(cohort.state)),
                    std::string(storedText(state))),
           cohort.name, Text::tr("Close a running cohort, archive a closed one, or open it again"));
  }
  if (closes && !StudyRepository(session.connection()).runningTrials(cohort.id).empty()) {
    refuse(Text::tr("a trainee of this cohort is training now"), cohort.name,
           Text::tr("Wait for the end of the run, or close what was cut off at its station"));
  }
  const std::int64_t open = archives ? SheetRepository(session.connection()).openAssignments(cohort.id) : 0;
  if (open > 0) {
    refuse(Text::tr("%1 {sheet is|sheets are} still open", open), cohort.name,
           Text::tr("Wait for them, or withdraw them under Scoring"));
  }
}

}  // namespace

void setCohortState(SessionContext& session, const CohortId& cohortId, CohortState state,
                    const std::string& reason) {
  session.require(Operation::kStudySetup);
  if (reason.empty()) {
    refuseParameter(Text::tr("it is not said why"), cohortId, Text::tr("Say in a few words why"));
  }
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort before = study.cohort(cohortId);
  checkStep(session, before, state);
  study.setCohortState(cohortId, state, reason, session.actor().userId, session.now_us());
  session.noteChange(AuditAction::kCohortSetState, AuditObject::kCohort, cohortId,
                     {{"state", storedText(before.state)}}, {{"state", storedText(state)}}, reason);
  transaction.commit();
}

void refuseWhenClosed(const Cohort& cohort) {
  if (cohort.state == CohortState::kClosed || cohort.state == CohortState::kArchived) {
    refuse(Text::tr("this cohort is closed"), cohort.name,
           Text::tr("Choose another cohort, or have an administrator open it again"));
  }
}

void assignCurriculum(SessionContext& session, const CohortId& cohortId,
                      const CurriculumVersionId& versionId) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort before = study.cohort(cohortId);
  refuseWhenClosed(before);
  if (!study.exposures(cohortId).empty()) {
    refuse(Text::tr("training has begun: the curriculum of this cohort stays"), before.name,
           Text::tr("Make another cohort for the other curriculum"));
  }
  CurriculumRepository(session.connection()).assign(cohortId, versionId);
  session.noteChange(AuditAction::kCohortAssignCurriculum, AuditObject::kCohort, cohortId,
                     {{"curriculum_version", before.curriculumVersionId}},
                     {{"curriculum_version", versionId}});
  transaction.commit();
}

Occasions knownOccasions(SessionContext& session) {
  session.require(Operation::kPersonViewCoded);
  return OccasionRepository(session.connection()).all();
}

Occasion addOccasion(SessionContext& session, const std::string& label) {
  session.require(Operation::kCurriculumEdit);
  if (label.empty()) {
    refuseParameter(Text::tr("the occasion has no name"), Text::tr("occasion"), Text::tr("Enter one"));
  }
  requireReadable(label, Text::tr("occasion"));
  Transaction transaction(session.connection());
  OccasionRepository repository(session.connection());
  const Occasions known = repository.all();
  for (const Occasion& other : known) {
    if (likenessOf(other.label) == likenessOf(label)) {
      refuseParameter(Text::tr("another occasion has this name"), label, Text::tr("Choose another name"));
    }
  }
  std::size_t number = known.size() + 1;
  while (known.contains("occasion-" + std::to_string(number))) {
    ++number;
  }
  const Occasion added{"occasion-" + std::to_string(number), label, {}};
  repository.add(added);
  session.note(AuditAction::kOccasionAdd, AuditObject::kOccasion, added.code, {{"label", label}});
  transaction.commit();
  return added;
}

}  // namespace torsio
