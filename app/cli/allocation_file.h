// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "assessment/domain/study/allocation.h"

namespace torsio::cli {

// Files of torsio allocate: the plan that it reads, the allocation that it writes and --replay reads. Private
// to app/cli's .cpp files.

/// A design and who is to be allocated.
struct AllocationOrder {
  AllocationDesign design;
  bool jointLeftovers = true;
  std::vector<AllocationPerson> persons;
};
/// Throws Error: kFileMissing; kBadData with file, field and rule.
[[nodiscard]] AllocationOrder readAllocationOrder(const std::string& file);

[[nodiscard]] nlohmann::ordered_json allocationJson(const Allocation& allocation);

/// An allocation as it was kept; its head is the line of the file, signed or not.
struct KeptAllocation {
  Allocation allocation;
  std::optional<bool>
      countsFit{};  ///< the counts of the arms are those of the records; empty: there are none
};
/// Throws Error as readAllocationOrder(), and kBadData for another version of the format.
[[nodiscard]] KeptAllocation readAllocation(const std::string& file);

}  // namespace torsio::cli
