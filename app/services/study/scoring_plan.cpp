// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/scoring_plan.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/scoring/scoring_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/draw_field.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/remark_repository.h"
#include "sim/core/error.h"
#include "sim/core/random.h"

namespace torsio {

namespace {

constexpr std::uint64_t kCommonLabels = 1;  // random streams
constexpr std::uint64_t kLabelsOfRater = 100'000;

/// One trainee at one occasion.
struct Case {
  Enrolment enrolment;
  std::string occasionCode;
  TrialId trialId;          ///< empty: live
  std::string commonLabel;  ///< of a live case: the same for all raters
};

std::string keyOf(const EnrolmentId& enrolmentId, const std::string& occasionCode) {
  return enrolmentId + " " + occasionCode;
}

std::vector<Enrolment> chosenEnrolments(StudyRepository& study, const ScoringPlan& plan) {
  std::vector<Enrolment> chosen;
  for (Enrolment& enrolment : study.enrolments(plan.cohortId)) {
    const bool wanted = plan.enrolmentIds.empty()
                            ? enrolment.state != EnrolmentState::kWithdrawn
                            : std::find(plan.enrolmentIds.begin(), plan.enrolmentIds.end(), enrolment.id) !=
                                  plan.enrolmentIds.end();
    if (wanted) {
      chosen.push_back(std::move(enrolment));
    }
  }
  if (chosen.empty()) {
    refuseParameter(Text::tr("there is nobody to score"), Text::tr("cohort"),
                    Text::tr("Enrol trainees first"));
  }
  if (!plan.enrolmentIds.empty() && chosen.size() != plan.enrolmentIds.size()) {
    refuseParameter(Text::tr("the list contains a person who is not enrolled here"), Text::tr("cohort"),
                    Text::tr("Choose from the list"));
  }
  return chosen;
}

void checkPlan(SessionContext& session, const ScoringPlan& plan) {
  if (plan.raterIds.empty()) {
    refuseParameter(Text::tr("nobody is asked to score"), Text::tr("raters"),
                    Text::tr("Choose at least one"));
  }
  if (plan.occasionCodes.empty()) {
    refuseParameter(Text::tr("no occasion is chosen"), Text::tr("occasions"),
                    Text::tr("Choose at least one"));
  }
  const Occasions occasions = OccasionRepository(session.connection()).all();
  for (const std::string& point : plan.occasionCodes) {
    if (!occasions.contains(point)) {
      refuseParameter(Text::tr("there is no such occasion"), point, Text::tr("Choose one from the list"));
    }
  }
  if (!RubricRepository(session.connection()).revision(plan.rubricRevisionId)) {
    refuseParameter(Text::tr("there is no such rubric"), plan.rubricRevisionId,
                    Text::tr("Choose one from the list"));
  }
  std::set<std::string> known;
  for (const Rater& rater : PeopleRepository(session.connection()).raters()) {
    if (rater.person.state == PersonState::kActive) {
      known.insert(rater.person.id);
    }
  }
  std::set<std::string> seen;
  for (const std::string& rater : plan.raterIds) {
    if (!known.contains(rater)) {
      refuseParameter(Text::tr("not an active rater"), rater, Text::tr("Choose one from the list"));
    }
    if (!seen.insert(rater).second) {
      refuseParameter(Text::tr("a rater is named twice"), rater, Text::tr("Name each once"));
    }
  }
}

std::vector<Case> casesOf(Connection& connection, StudyRepository& study, const ScoringPlan& plan) {
  std::map<std::string, std::string> recordings;
  QuestionRepository questions(connection);
  for (const CaseRecording& recording : plan.recordings) {
    if (!questions.ofTrial(recording.trialId).empty()) {
      refuseParameter(Text::tr("a physician was asked about this recording by name"), recording.trialId,
                      Text::tr("Choose another recording: a case must be blinded"));
    }
    recordings[keyOf(recording.enrolmentId, recording.occasionCode)] = recording.trialId;
  }
  std::vector<Case> cases;
  for (const Enrolment& enrolment : chosenEnrolments(study, plan)) {
    for (const std::string& point : plan.occasionCodes) {
      const auto recording = recordings.find(keyOf(enrolment.id, point));
      cases.push_back({enrolment, point, recording == recordings.end() ? "" : recording->second, ""});
    }
  }
  return cases;
}

/// Live cases keep the label of an earlier call.
void giveCommonLabels(std::vector<Case>& cases, const std::vector<AssignmentStatus>& present,
                      const std::set<std::string>& taken, std::uint64_t seed) {
  std::map<std::string, std::string> known;
  for (const AssignmentStatus& status : present) {
    if (status.assignment.trialId.empty()) {
      known[keyOf(status.assignment.enrolmentId, status.assignment.occasionCode)] =
          status.assignment.caseLabel;
    }
  }
  const std::vector<std::string> fresh = caseLabels(cases.size(), taken, seed, kCommonLabels);
  std::size_t next = 0;
  for (Case& one : cases) {
    const auto before = known.find(keyOf(one.enrolment.id, one.occasionCode));
    if (one.trialId.empty()) {
      one.commonLabel = before != known.end() ? before->second : fresh.at(next++);
    }
  }
}

/// Returns new assignments of one rater for cases not yet assigned to them.
std::vector<Assignment> assignmentsFor(SessionContext& session, const ScoringPlan& plan,
                                       const std::vector<Case>& cases, std::size_t panelPosition,
                                       std::uint64_t seed) {
  const RaterId& raterId = plan.raterIds.at(panelPosition);
  std::set<std::string> asked;
  std::set<std::string> labels;
  std::int64_t position = 0;
  for (const Assignment& before : SheetRepository(session.connection()).assignmentsOf(raterId)) {
    asked.insert(keyOf(before.enrolmentId, before.occasionCode));
    labels.insert(before.caseLabel);
    position = std::max(position, before.position);
  }
  std::vector<OrderedCase> open;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (asked.contains(keyOf(cases[i].enrolment.id, cases[i].occasionCode))) {
      continue;
    }
    open.push_back({i, cases[i].occasionCode + " " + cases[i].enrolment.groupCode});
  }
  for (const Case& one : cases) {
    labels.insert(one.commonLabel);
  }
  const std::vector<std::string> own = caseLabels(open.size(), labels, seed, kLabelsOfRater + panelPosition);
  std::vector<Assignment> made;
  for (const std::size_t index : counterbalancedOrder(open, seed, panelPosition)) {
    const Case& one = cases.at(index);
    made.push_back({.id = session.ids().newUuid(),
                    .raterId = raterId,
                    .enrolmentId = one.enrolment.id,
                    .occasionCode = one.occasionCode,
                    .trialId = one.trialId,
                    .rubricRevisionId = plan.rubricRevisionId,
                    .caseLabel = one.commonLabel.empty() ? own.at(made.size()) : one.commonLabel,
                    .position = ++position,
                    .dueUtc_us = plan.dueUtc_us,
                    .assignedBy = session.actor().userId,
                    .assignedUtc_us = session.now_us(),
                    .demonstration = one.enrolment.demonstration});
  }
  return made;
}

ScoringCell cellOf(const AssignmentStatus& status) {
  return {status.assignment.id, status.state, status.assignment.caseLabel, status.assignment.dueUtc_us,
          status.changedUtc_us};
}

void setReleased(SessionContext& session, const CohortId& cohortId, const std::string& occasionCode,
                 bool released, const std::string& reason) {
  SheetRepository(session.connection())
      .setReleased(cohortId, occasionCode, released, reason, session.actor().userId, session.now_us());
  session.note(released ? AuditAction::kMarkRelease : AuditAction::kMarkRetract, AuditObject::kMarkRelease,
               cohortId, {{"occasion", occasionCode}}, reason);
}

}  // namespace

ScoringPlanOutcome createAssignments(SessionContext& session, const ScoringPlan& plan) {
  session.require(Operation::kStudySetup);
  Transaction transaction(session.connection());
  StudyRepository study(session.connection());
  const Cohort cohort = study.cohort(plan.cohortId);
  refuseWhenClosed(cohort);
  checkPlan(session, plan);
  ScoringPlanOutcome outcome;
  outcome.seed = plan.seed ? *plan.seed : drawSeed(session.ids());
  std::vector<Case> cases = casesOf(session.connection(), study, plan);
  SheetRepository sheets(session.connection());
  std::set<std::string> taken;
  for (const std::string& rater : plan.raterIds) {
    for (const Assignment& before : sheets.assignmentsOf(rater)) {
      taken.insert(before.caseLabel);
    }
  }
  giveCommonLabels(cases, sheets.assignments(plan.cohortId), taken, outcome.seed);
  for (std::size_t rater = 0; rater < plan.raterIds.size(); ++rater) {
    const std::vector<Assignment> made = assignmentsFor(session, plan, cases, rater, outcome.seed);
    sheets.assign(made);
    outcome.created += made.size();
    outcome.already += cases.size() - made.size();
    if (made.empty()) {
      continue;
    }
    session.note(AuditAction::kAssignmentCreate, AuditObject::kAssignment, plan.raterIds[rater],
                 {{"cohort", cohort.id},
                  {"rater", plan.raterIds[rater]},
                  {"occasions", plan.occasionCodes},
                  {"sheets", made.size()},
                  {"rubric_revision", plan.rubricRevisionId},
                  {"seed", std::to_string(outcome.seed)},
                  {"panel_position", rater}});
  }
  transaction.commit();
  return outcome;
}

ScoringMatrix scoringMatrix(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kStudySetup);
  const std::vector<AssignmentStatus> all = SheetRepository(session.connection()).assignments(cohortId);
  std::map<std::string, std::string> codes;
  for (const Enrolment& enrolment : StudyRepository(session.connection()).enrolments(cohortId)) {
    codes[enrolment.id] = enrolment.traineeCode;
  }
  ScoringMatrix matrix;
  matrix.occasions = occasionsOfCohort(session.connection(), cohortId);
  std::map<std::string, std::size_t> column;
  std::set<std::string> involved;
  for (const AssignmentStatus& status : all) {
    involved.insert(status.assignment.raterId);
  }
  for (const Rater& rater : PeopleRepository(session.connection()).raters()) {
    if (!involved.contains(rater.person.id)) {
      continue;
    }
    column[rater.person.id] = matrix.raters.size();
    matrix.raters.push_back({rater.person.id, rater.person.code, rater.classCode, 0, 0});
  }
  for (const AssignmentStatus& status : all) {
    const Assignment& one = status.assignment;
    const bool sameLine = !matrix.lines.empty() && matrix.lines.back().enrolmentId == one.enrolmentId &&
                          matrix.lines.back().occasion.code == one.occasionCode;
    if (!sameLine) {
      matrix.lines.push_back({one.enrolmentId, codes[one.enrolmentId],
                              matrix.occasions.named(one.occasionCode),
                              std::vector<ScoringCell>(matrix.raters.size()), 0});
    }
    const std::size_t at = column.at(one.raterId);
    matrix.lines.back().cells[at] = cellOf(status);
    const bool missing = isOutstanding(status.state);
    matrix.lines.back().missing += missing ? 1 : 0;
    matrix.raters[at].open += missing ? 1 : 0;
    matrix.raters[at].submitted += status.state == SheetState::kSubmitted ? 1 : 0;
  }
  return matrix;
}

std::vector<ReleaseState> releaseStates(SessionContext& session, const CohortId& cohortId) {
  session.require(Operation::kMarkRelease);
  SheetRepository sheets(session.connection());
  std::vector<ReleaseState> states;
  const std::vector<AssignmentStatus> all = sheets.assignments(cohortId);
  for (const Occasion& occasion : occasionsOfCohort(session.connection(), cohortId)) {
    ReleaseState state{occasion, sheets.isReleased(cohortId, occasion.code), 0, 0};
    for (const AssignmentStatus& status : all) {
      if (status.assignment.occasionCode != occasion.code || status.state == SheetState::kWithdrawn) {
        continue;
      }
      ++state.sheets;
      if (status.state != SheetState::kSubmitted) {
        ++state.missing;
      }
    }
    states.push_back(std::move(state));
  }
  return states;
}

void releaseMarks(SessionContext& session, const CohortId& cohortId, const std::string& occasionCode,
                  const std::string& reason) {
  session.require(Operation::kMarkRelease);
  Transaction transaction(session.connection());
  for (const ReleaseState& state : releaseStates(session, cohortId)) {
    if (state.occasion.code != occasionCode) {
      continue;
    }
    if (state.released) {
      refuse(Text::tr("these marks are released already"), occasionCode, Text::tr("Nothing to do"));
    }
    if (state.missing > 0 && reason.empty()) {
      refuse(Text::tr("%1 of %2 {sheet is|sheets are} not submitted", state.missing, state.sheets),
             occasionCode, Text::tr("Wait for them, or give a reason"));
    }
    setReleased(session, cohortId, occasionCode, true, reason);
    transaction.commit();
    return;
  }
  refuse(Text::tr("there is no such occasion"), occasionCode, Text::tr("Choose one from the list"));
}

void retractMarks(SessionContext& session, const CohortId& cohortId, const std::string& occasionCode,
                  const std::string& reason) {
  session.require(Operation::kMarkRelease);
  if (reason.empty()) {
    refuse(Text::tr("taking marks back needs a reason"), occasionCode, Text::tr("Say why"));
  }
  Transaction transaction(session.connection());
  if (!SheetRepository(session.connection()).isReleased(cohortId, occasionCode)) {
    refuse(Text::tr("these marks are not released"), occasionCode, Text::tr("Nothing to do"));
  }
  setReleased(session, cohortId, occasionCode, false, reason);
  transaction.commit();
}

namespace {

constexpr std::uint64_t kCaseOrderStream = 1000;
constexpr std::string_view kLetters = "ABCDEFGHJKLMNPQRSTUVWXYZ";

}  // namespace

std::vector<std::size_t> counterbalancedOrder(std::vector<OrderedCase> cases, std::uint64_t seed,
                                              std::uint64_t rater) {
  Random random = Random::forStream(seed, kCaseOrderStream + rater);
  std::map<std::string, std::vector<std::size_t>> strata;
  for (const OrderedCase& one : cases) {
    strata[one.stratum].push_back(one.index);
  }
  std::size_t rounds = 0;
  for (auto& [name, members] : strata) {
    random.shuffle(std::span<std::size_t>(members));
    rounds = std::max(rounds, members.size());
  }
  std::vector<std::size_t> order;
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<std::size_t> together;
    for (const auto& [name, members] : strata) {
      // Spread small strata over all rounds instead of using them up in the first ones.
      const std::size_t from = round * members.size() / rounds;
      const std::size_t to = (round + 1) * members.size() / rounds;
      for (std::size_t i = from; i < to; ++i) {
        together.push_back(members[i]);
      }
    }
    random.shuffle(std::span<std::size_t>(together));
    order.insert(order.end(), together.begin(), together.end());
  }
  return order;
}

std::vector<std::string> caseLabels(std::size_t count, const std::set<std::string>& taken, std::uint64_t seed,
                                    std::uint64_t stream) {
  Random random = Random::forStream(seed, stream);
  std::vector<std::string> labels;
  for (std::size_t first = 1; labels.size() < count; first *= 10) {
    std::vector<std::string> pool;
    for (std::size_t number = first; number < first * 10; ++number) {
      for (const char letter : kLetters) {
        std::string label = std::to_string(number) + letter;
        if (!taken.contains(label)) {
          pool.push_back(std::move(label));
        }
      }
    }
    random.shuffle(std::span<std::string>(pool));
    const std::size_t wanted = std::min(count - labels.size(), pool.size());
    labels.insert(labels.end(), pool.begin(), pool.begin() + static_cast<std::ptrdiff_t>(wanted));
  }
  // Longer labels must not gather at the end, where their place would be informative.
  random.shuffle(std::span<std::string>(labels));
  return labels;
}

}  // namespace torsio
