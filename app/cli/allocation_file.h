// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "assessment/domain/study/allocation.h"

namespace torsio::cli {

// Files of torsio allocate: its input, and the allocation that it writes and --replay reads. Private to
// app/cli's .cpp files.

/// A design and the persons to allocate.
struct AllocationOrder {
  AllocationDesign design;
  bool jointLeftovers = true;
  std::vector<AllocationPerson> persons;
};
/// Throws Error: kFileMissing; kBadData with file, field and rule.
[[nodiscard]] AllocationOrder readAllocationOrder(const std::string& file);

[[nodiscard]] nlohmann::ordered_json allocationJson(const Allocation& allocation);

/// A stored allocation; its head is the file's line, signed or not.
struct KeptAllocation {
  Allocation allocation;
  std::optional<bool> countsFit{};  ///< whether the stored counts match the records; empty: no counts stored
};
/// Throws Error like readAllocationOrder(), and kBadData for another format version.
[[nodiscard]] KeptAllocation readAllocation(const std::string& file);

}  // namespace torsio::cli
