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

/// More trials than one trainee ever records: the limit where all of them are wanted.
inline constexpr std::int64_t kAllTrials = 10'000;

/// Where a trainee belongs: what the services of the station read first.
struct TraineeRecord {
  PersonId personId{};
  std::string code{};
  bool demonstration = false;
  std::optional<Enrolment> enrolment{};        ///< the newest that is neither completed nor withdrawn
  Cohort cohort{};                             ///< of the enrolment
  std::optional<CurriculumVersion> version{};  ///< running or closed: what was begun may be ended
  std::optional<StudyArm> arm{};

  /// Null when the curriculum has no such module.
  [[nodiscard]] const TrainingModule* module(const ModuleId& moduleId) const;
};

/// The record of the actor. Throws Error{kPermission}: no right to `operation`, or no trainee.
[[nodiscard]] TraineeRecord ownRecord(SessionContext& session, Operation operation);

/// A trial of this trainee. Throws Error{kPermission} for somebody else's, {kBadParameter} for none.
[[nodiscard]] TrialListing ownTrial(SessionContext& session, const TraineeRecord& record,
                                    const TrialId& trialId);

}  // namespace torsio
