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

/// One cohort in a list.
struct CohortRow {
  Cohort cohort{};
  std::vector<StudyGroup> groups{};
  std::size_t enrolled = 0;   ///< not withdrawn
  std::size_t allocated = 0;  ///< of these: in a group
  std::size_t withdrawn = 0;
  std::vector<std::string> traineeCodes{};  ///< of all who are or were enrolled
  std::string curriculumName{};             ///< empty: follows none yet
  std::int64_t curriculumNumber = 0;
  bool today = false;  ///< somebody is expected, called or training today, or sheets are due by now
};

/// All cohorts, oldest first. kPersonViewCoded.
[[nodiscard]] std::vector<CohortRow> cohorts(SessionContext& session);
/// Which cohort a page shows first: the one of today; of several, or of none, the largest of those that run
/// and are in groups; then the largest that is in groups; the newest one else. Archived ones never, unless
/// nothing else is there. Position in `rows`; their number when there are none. Of equals the newest.
[[nodiscard]] std::size_t cohortShownFirst(std::span<const CohortRow> rows);

/// Enrolments in order of group and number. Without kAllocationView the groups are left out.
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
  std::vector<NewGroup> groups{};             ///< empty: taken from the arms of the curriculum
  CurriculumVersionId curriculumVersionId{};  ///< may be empty: assignCurriculum() later
  bool demonstration = false;
  /// Smaller differences of scores do not matter, points; part of the plan, so that it never changes. Empty:
  /// equivalence is not tested.
  std::optional<double> equivalenceMargin{};
};
/// Returns the id. Audited. kStudySetup. Throws Error{kBadParameter}: no name or that of another cohort, no
/// groups, a code twice, a margin that is not above 0 and at most kLargestMargin; kBadData when the
/// curriculum is not running or has not an arm a group.
CohortId addCohort(SessionContext& session, const NewCohort& cohort);
/// Ties the groups, number by number, to the arms of a running version. Audited. kStudySetup. Refused once
/// training has begun.
void assignCurriculum(SessionContext& session, const CohortId& cohortId,
                      const CurriculumVersionId& versionId);

/// Audited. kStudySetup. Throws Error{kBadParameter} for an empty name or one that another cohort has.
void renameCohort(SessionContext& session, const CohortId& cohortId, const std::string& name);
/// Closes a cohort, archives a closed one, or opens either again (kRunning). The reason is required. Audited.
/// kStudySetup. Throws Error: {kBadParameter} without a reason; {kBadData} for a step that is none (only a
/// closed cohort can be archived), while somebody trains, or when sheets of a cohort to be archived are still
/// open.
void setCohortState(SessionContext& session, const CohortId& cohortId, CohortState state,
                    const std::string& reason);
/// Throws Error{kBadData} when a cohort takes nothing new: it is closed or archived.
void refuseWhenClosed(const Cohort& cohort);

/// Enrols trainees (ids of people), before allocation. Returns the ids of the enrolments. Audited.
/// kStudyEnrol. Throws Error{kBadData} for somebody who is no active trainee or is enrolled already, and in a
/// closed cohort.
std::vector<EnrolmentId> enrolTrainees(SessionContext& session, const CohortId& cohortId,
                                       const std::vector<TraineeId>& traineeIds);
/// Completed or withdrawn (or back to enrolled); what was recorded stays. Audited. kStudyEnrol.
void setEnrolmentState(SessionContext& session, const CohortId& cohortId, const EnrolmentId& enrolmentId,
                       EnrolmentState state, const std::string& reason);

/// Something that did not go by the protocol.
struct NewDeviation {
  CohortId cohortId{};
  EnrolmentId enrolmentId{};  ///< empty: the whole cohort
  std::string kind{};         ///< stored text of a DeviationKind
  std::string description{};
  std::int64_t happenedUtc_us = 0;  ///< 0: now
};
/// Audited. kStudySetup.
DeviationId reportDeviation(SessionContext& session, const NewDeviation& deviation);
/// What happened to several at once: all are noted or none. As reportDeviation().
void reportDeviations(SessionContext& session, std::span<const NewDeviation> deviations);
/// Notes of each of these deviations that it was entered in error: what stands stays, the correction stands
/// beside it. All or none. Audited. kStudySetup. Throws Error{kBadData}: no reason, or none of this cohort.
void correctDeviations(SessionContext& session, const CohortId& cohortId,
                       std::span<const DeviationId> deviationIds, const std::string& reason);
/// Oldest first. kPersonViewCoded.
[[nodiscard]] std::vector<ProtocolDeviation> deviations(SessionContext& session, const CohortId& cohortId);

/// Time spent on the virtual or real arm, or resting.
struct NewExposure {
  CohortId cohortId{};
  EnrolmentId enrolmentId{};
  PhaseId phaseId{};  ///< empty: outside any phase
  ExposureKind kind = ExposureKind::kVirtual;
  std::int64_t startedUtc_us = 0;
  std::int64_t duration_us = 0;
  std::string reason{};  ///< why, where the arm of the trainee spends no time on this; without names
};
/// Append-only. One's own at the station: kTrialRecordOwn; anybody's, on the day of training: kStudySetup.
/// Audited. Time outside any phase that the arm does not plan (isPlanned()) is noted as a deviation. Throws
/// Error{kBadData}: not enrolled, a phase of another arm, a kind that is not the phase's, no time, time that
/// is not planned without a reason.
ExposureId recordExposure(SessionContext& session, const NewExposure& exposure);

/// Lists the occasions that curricula can name, in order of time. kPersonViewCoded (whoever administers
/// the study).
[[nodiscard]] Occasions knownOccasions(SessionContext& session);

/// Adds an occasion after all others, for every later curriculum ("six months later"). Returns it. Audited.
/// kCurriculumEdit. Throws Error{kBadParameter} without a name or when another occasion has it.
Occasion addOccasion(SessionContext& session, const std::string& label);

}  // namespace torsio
