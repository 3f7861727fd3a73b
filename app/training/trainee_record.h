// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/access/session_context.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"

namespace torsio {

/// More trials than one trainee ever records: the limit where all of them are wanted.
inline constexpr std::int64_t kAllTrials = 10'000;

/// Where a trainee belongs: what the services of the station read first.
struct TraineeRecord {
  std::string personId{};
  std::string code{};
  bool demonstration = false;
  std::optional<StoredEnrolment> enrolment{};        ///< the newest that is neither completed nor withdrawn
  StoredCohort cohort{};                             ///< of the enrolment
  std::optional<StoredCurriculumVersion> version{};  ///< running or closed: what was begun may be ended
  std::optional<StudyArm> arm{};

  /// Null when the curriculum has no such module.
  [[nodiscard]] const StoredModule* module(const std::string& moduleId) const;
};

/// The record of the actor. Throws Error{kPermission}: no right to `operation`, or no trainee.
[[nodiscard]] TraineeRecord ownRecord(SessionContext& session, Operation operation);

/// A trial of this trainee. Throws Error{kPermission} for somebody else's, {kBadParameter} for none.
[[nodiscard]] TrialListing ownTrial(SessionContext& session, const TraineeRecord& record,
                                    const std::string& trialId);

}  // namespace torsio
