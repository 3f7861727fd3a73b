// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/services/scoring/stored_allocation.h"
#include "app/services/study/allocation_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/cohort.h"

namespace torsio {

class IdSource;

/// A cohort as the draw sees it.
struct DrawField {
  Cohort cohort;
  std::vector<StudyGroup> groups;
  std::vector<Enrolment> enrolments;        ///< not withdrawn
  std::map<std::string, Trainee> trainees;  ///< by id

  /// Gives the codes of the groups, in their order.
  [[nodiscard]] std::vector<std::string> groupCodes() const;
  /// Gives who is enrolled without a group, in the order of codes.
  [[nodiscard]] std::vector<Enrolment> waiting() const;
};

/// Reads a cohort for the draw. Throws Error{kBadData} when there is no such cohort.
[[nodiscard]] DrawField readDrawField(SessionContext& session, const CohortId& cohortId);
/// Gives the levels that a factor has among the people who wait.
[[nodiscard]] AllocationFactor factorOf(const DrawField& field, const std::string& name);
/// Makes the design that a plan means for the people who wait. Throws Error{kBadParameter} where it cannot be
/// drawn by.
[[nodiscard]] AllocationDesign designOf(const DrawField& field, const AllocationPlan& plan);

/// A seed from the same source as record ids: the machine's random numbers, or a test's fixed stream. Private
/// to the services that draw.
[[nodiscard]] std::uint64_t drawSeed(IdSource& ids);

/// 256 bits for a commitment (seedCommitment), from the same source.
[[nodiscard]] std::string drawSalt(IdSource& ids);

}  // namespace torsio
