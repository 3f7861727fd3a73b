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

/// A cohort's data for the allocation.
struct DrawField {
  Cohort cohort;
  std::vector<StudyGroup> groups;
  std::vector<Enrolment> enrolments;        ///< not withdrawn
  std::map<std::string, Trainee> trainees;  ///< by id

  /// Returns the codes of the groups in order.
  [[nodiscard]] std::vector<std::string> groupCodes() const;
  /// Returns the enrolments without a group, ordered by code.
  [[nodiscard]] std::vector<Enrolment> waiting() const;
};

/// Reads a cohort for allocation. Throws Error{kBadData} if there is no such cohort.
[[nodiscard]] DrawField readDrawField(SessionContext& session, const CohortId& cohortId);
/// Returns the levels of a factor among the unallocated people.
[[nodiscard]] AllocationFactor factorOf(const DrawField& field, const std::string& name);
/// Returns the design of a plan for the unallocated people. Throws Error{kBadParameter} for an invalid plan.
[[nodiscard]] AllocationDesign designOf(const DrawField& field, const AllocationPlan& plan);

/// Draws a seed from the source of record ids: the machine's random numbers, or a fixed stream in tests.
/// Private to the services that allocate.
[[nodiscard]] std::uint64_t drawSeed(IdSource& ids);

/// Draws 256 bits for a commitment (seedCommitment) from the same source.
[[nodiscard]] std::string drawSalt(IdSource& ids);

}  // namespace torsio
