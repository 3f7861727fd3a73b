// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/occasion.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// A cohort in a list.
struct CohortRow {
  Cohort cohort{};
  std::vector<StudyGroup> groups{};
  std::size_t enrolled = 0;   ///< not withdrawn
  std::size_t allocated = 0;  ///< of these, those in a group
  std::size_t withdrawn = 0;
  std::vector<std::string> traineeCodes{};  ///< of all ever enrolled
  std::string curriculumName{};             ///< empty: none yet
  std::int64_t curriculumNumber = 0;
  bool today = false;  ///< somebody is expected, called or training today, or sheets are due
};

/// Returns all cohorts, oldest first. kPersonViewCoded.
[[nodiscard]] std::vector<CohortRow> cohorts(SessionContext& session);
/// Returns the index of the cohort that a page shows first: the one active today; if there are several or
/// none, the largest running one with groups; then the largest one with groups; otherwise the latest.
/// Archived ones only if there are no others. rows.size() if empty. Ties go to the latest.
[[nodiscard]] std::size_t cohortShownFirst(std::span<const CohortRow> rows);

/// Returns enrolments ordered by group and number; without kAllocationView, the groups are omitted.
/// kPersonViewCoded.
[[nodiscard]] std::vector<Enrolment> enrolments(SessionContext& session, const CohortId& cohortId);

struct NewGroup {
  std::string code{};   ///< "G1"
  std::string label{};  ///< "40 min virtual"
};
inline constexpr int kLargestMargin = 100;  // points
struct NewCohort {
  std::string name{};
  std::string description{};
  std::vector<NewGroup> groups{};             ///< empty: from the curriculum's arms
  CurriculumVersionId curriculumVersionId{};  ///< may be empty; then use assignCurriculum() later
  bool demonstration = false;
  /// Differences of scores below this are irrelevant, points; part of the plan, so it never changes. Empty:
  /// equivalence is not tested.
  std::optional<double> equivalenceMargin{};
};
/// Returns the id. Audited. kStudySetup. Throws Error{kBadParameter} for a missing or duplicate name, no
/// groups, a duplicate code, a margin that is not above 0 and at most kLargestMargin; kBadData if the
/// curriculum is not running or does not have one arm per group.
CohortId addCohort(SessionContext& session, const NewCohort& cohort);
/// Assigns the arms of a running version to the groups, in order. Audited. kStudySetup. Refused once training
/// has begun.
void assignCurriculum(SessionContext& session, const CohortId& cohortId,
                      const CurriculumVersionId& versionId);

/// Audited. kStudySetup. Throws Error{kBadParameter} for an empty or duplicate name.
void renameCohort(SessionContext& session, const CohortId& cohortId, const std::string& name);
/// Closes a cohort, archives a closed one, or reopens either (kRunning), with a reason. Audited. kStudySetup.
/// Throws Error: {kBadParameter} without a reason; {kBadData} for an invalid change (only a closed cohort can
/// be archived), while somebody is training, or if sheets of a cohort to be archived are open.
void setCohortState(SessionContext& session, const CohortId& cohortId, CohortState state,
                    const std::string& reason);
/// Throws Error{kBadData} if a cohort is closed or archived.
void refuseWhenClosed(const Cohort& cohort);

/// Enrols trainees (person ids) before allocation. Returns the enrolment ids. Audited. kStudyEnrol. Throws
/// Error{kBadData} for a person who is not an active trainee or is already enrolled, and in a closed cohort.
std::vector<EnrolmentId> enrolTrainees(SessionContext& session, const CohortId& cohortId,
                                       const std::vector<TraineeId>& traineeIds);
/// Sets completed, withdrawn or enrolled; recorded data stay. Audited. kStudyEnrol.
void setEnrolmentState(SessionContext& session, const CohortId& cohortId, const EnrolmentId& enrolmentId,
                       EnrolmentState state, const std::string& reason);

/// A deviation from the protocol.
struct NewDeviation {
  CohortId cohortId{};
  EnrolmentId enrolmentId{};  ///< empty: whole cohort
  std::string kind{};         ///< stored text of a DeviationKind
  std::string description{};
  std::int64_t happenedUtc_us = 0;  ///< 0: now
};
/// Audited. kStudySetup.
DeviationId reportDeviation(SessionContext& session, const NewDeviation& deviation);
/// Reports several deviations, all or nothing. Like reportDeviation().
void reportDeviations(SessionContext& session, std::span<const NewDeviation> deviations);
/// Marks deviations as entered in error: the entries stay, each with its correction. All or nothing. Audited.
/// kStudySetup. Throws Error{kBadData} without a reason, or for a deviation of another cohort.
void correctDeviations(SessionContext& session, const CohortId& cohortId,
                       std::span<const DeviationId> deviationIds, const std::string& reason);
/// Oldest first. kPersonViewCoded.
[[nodiscard]] std::vector<ProtocolDeviation> deviations(SessionContext& session, const CohortId& cohortId);

/// Time spent on the virtual or real arm, or resting.
struct NewExposure {
  CohortId cohortId{};
  EnrolmentId enrolmentId{};
  PhaseId phaseId{};  ///< empty: no phase
  ExposureKind kind = ExposureKind::kVirtual;
  std::int64_t startedUtc_us = 0;
  std::int64_t duration_us = 0;
  std::string reason{};  ///< needed if the trainee's arm does not plan this time; without names
};
/// Append-only. The actor's own at the station: kTrialRecordOwn; anybody's on the day of training:
/// kStudySetup. Audited. Time that the arm does not plan (isPlanned()) is recorded as a deviation. Throws
/// Error{kBadData} for a person not enrolled, a phase of another arm, a kind other than the phase's, no time,
/// unplanned time without a reason.
ExposureId recordExposure(SessionContext& session, const NewExposure& exposure);

/// Lists the occasions available to curricula, in order of time. kPersonViewCoded.
[[nodiscard]] Occasions knownOccasions(SessionContext& session);

/// Adds an occasion after all others, for later curricula ("six months later"), and returns it. Audited.
/// kCurriculumEdit. Throws Error{kBadParameter} for a missing or duplicate name.
Occasion addOccasion(SessionContext& session, const std::string& label);

}  // namespace torsio
