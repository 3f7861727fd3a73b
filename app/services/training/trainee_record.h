// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/services/access/session_context.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"

namespace torsio {

/// More trials than a trainee ever records: the limit for reading all of them.
inline constexpr std::int64_t kAllTrials = 10'000;

/// A trainee's enrolment and curriculum, read first by the station's services.
struct TraineeRecord {
  PersonId personId{};
  std::string code{};
  bool demonstration = false;
  std::optional<Enrolment> enrolment{};        ///< latest that is neither completed nor withdrawn
  Cohort cohort{};                             ///< of the enrolment
  std::optional<CurriculumVersion> version{};  ///< running or closed: what was begun may be finished
  std::optional<StudyArm> arm{};

  /// Returns null if the curriculum has no such module.
  [[nodiscard]] const TrainingModule* module(const ModuleId& moduleId) const;
};

/// Returns the actor's record. Throws Error{kPermission} without the right to `operation`, or if the actor is
/// not a trainee.
[[nodiscard]] TraineeRecord ownRecord(SessionContext& session, Operation operation);

/// Returns a trial of this trainee. Throws Error{kPermission} for somebody else's, {kBadParameter} for an
/// unknown one.
[[nodiscard]] TrialListing ownTrial(SessionContext& session, const TraineeRecord& record,
                                    const TrialId& trialId);

/// Stores a bookmark of the actor in a run, in the caller's transaction; the caller has checked that the run
/// is the actor's. Returns its id. Throws Error{kBadParameter} for a time outside the recording.
RemarkId keepBookmark(SessionContext& session, const TrialListing& trial, double at_s,
                      const std::string& text);

}  // namespace torsio
