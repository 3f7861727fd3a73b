// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assessment/domain/people/person.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/allocation_entry.h"

namespace torsio {

// How a design and its records are written into the database, and read back. Private to the allocation
// service.

/// "sex", "level", "experience" or "handedness" of a trainee; empty: not recorded.
[[nodiscard]] std::string factorValue(const Trainee& trainee, const std::string& factor);

[[nodiscard]] std::string allocationMethodName(AllocationMethod method);

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

}  // namespace torsio
