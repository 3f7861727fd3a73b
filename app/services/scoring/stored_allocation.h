// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/allocation.h"

namespace torsio {

class StudyRepository;

// Stores an allocation design and its records, reads them back, and replays them from the seed.

/// Returns a trainee's value of a BalanceFactor (stored text); empty if not recorded.
[[nodiscard]] std::string factorValue(const Trainee& trainee, const std::string& factor);

/// Returns everything that determines the allocation except the seed.
[[nodiscard]] std::string designJson(const AllocationDesign& design);
/// Restores a stored design. `groups`: codes of the cohort's groups in order, `drawn`: number of records
/// without overrides; both are used for incomplete designs (written before format version 2: one
/// permutation). Throws Error{kBadData}.
[[nodiscard]] AllocationDesign designFromStored(const LockedDesign& stored,
                                                const std::vector<std::string>& groups, std::size_t drawn);

[[nodiscard]] std::string covariatesJson(const AllocationDesign& design, const AllocationPerson& person);
/// Throws Error{kBadData} if a level is not part of the design.
[[nodiscard]] AllocationPerson personFromRecord(const AllocationDesign& design, const std::string& code,
                                                const std::string& covariatesJson);
/// Returns a person's data for the allocation. Throws Error{kBadData} if a factor is not recorded or has an
/// unknown level.
[[nodiscard]] AllocationPerson personForDraw(const AllocationDesign& design, const Trainee& trainee);

[[nodiscard]] std::string numbersJson(const std::vector<std::string>& names,
                                      const std::vector<std::int64_t>& numbers);

/// Returns the drawn records without overrides.
[[nodiscard]] std::vector<AllocationEntry> drawnOf(const std::vector<AllocationEntry>& records);
/// Parses a stored seed. Throws Error{kBadData} naming the design.
[[nodiscard]] std::uint64_t seedFrom(const std::string& text, const DesignId& designId);
/// Returns the trainee codes of a cohort by enrolment id.
[[nodiscard]] std::map<std::string, std::string> codesOf(StudyRepository& study, const CohortId& cohortId);

/// Result of replaying an allocation.
struct AllocationCheck {
  bool sound = true;
  Text finding{};  ///< what is wrong
  std::size_t records = 0;
  std::size_t overrides = 0;
};
/// Replays the allocation of a design and compares it with records, chain, commitment and groups. `seed` and
/// `salt`: as stored. Throws Error{kBadData} if they are invalid.
[[nodiscard]] AllocationCheck repeatedDraw(StudyRepository& study, const LockedDesign& stored,
                                           const std::string& seed, const std::string& salt);

}  // namespace torsio
