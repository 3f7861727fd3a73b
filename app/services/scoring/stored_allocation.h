// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/allocation_entry.h"

namespace torsio {

class StudyRepository;

// How a design and its records are written into the database, read back, and repeated from the seed.

/// "sex", "level", "experience" or "handedness" of a trainee; empty: not recorded.
[[nodiscard]] std::string factorValue(const Trainee& trainee, const std::string& factor);

/// Everything that decides the allocation except the seed.
[[nodiscard]] std::string designJson(const AllocationDesign& design);
/// From the stored design. `groups`: codes of the cohort's groups in order, `drawn`: number of records that
/// are no overrides; both are used for records that hold no whole design (written before version 2 of the
/// format: one permutation). Throws Error{kBadData}.
[[nodiscard]] AllocationDesign designFromStored(const LockedDesign& stored,
                                                const std::vector<std::string>& groups, std::size_t drawn);

[[nodiscard]] std::string covariatesJson(const AllocationDesign& design, const AllocationPerson& person);
/// Throws Error{kBadData} when a level is not one of the design's.
[[nodiscard]] AllocationPerson personFromRecord(const AllocationDesign& design, const std::string& code,
                                                const std::string& covariatesJson);
/// The person as the draw takes them. Throws Error{kBadData} when a factor is not recorded or has a new
/// level.
[[nodiscard]] AllocationPerson personForDraw(const AllocationDesign& design, const Trainee& trainee);

[[nodiscard]] std::string numbersJson(const std::vector<std::string>& names,
                                      const std::vector<std::int64_t>& numbers);

/// Gives the records that were drawn, without those that were moved by hand.
[[nodiscard]] std::vector<AllocationEntry> drawnOf(const std::vector<AllocationEntry>& records);
/// Reads a seed as it is stored. Throws Error{kBadData} naming the design.
[[nodiscard]] std::uint64_t seedFrom(const std::string& text, const DesignId& designId);
/// Gives the codes of a cohort's trainees by the ids of their enrolments.
[[nodiscard]] std::map<std::string, std::string> codesOf(StudyRepository& study, const CohortId& cohortId);

/// What repeating a draw found.
struct AllocationCheck {
  bool sound = true;
  Text finding{};  ///< what is wrong
  std::size_t records = 0;
  std::size_t overrides = 0;
};
/// Repeats the draw of a design and compares it with records, chain, commitment and groups. `seed` and
/// `salt`: as they are stored. Throws Error{kBadData} where they cannot be read.
[[nodiscard]] AllocationCheck repeatedDraw(StudyRepository& study, const LockedDesign& stored,
                                           const std::string& seed, const std::string& salt);

}  // namespace torsio
