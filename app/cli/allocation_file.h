// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "assessment/domain/study/allocation.h"

namespace torsio::cli {

// Files of torsio allocate: its input, and the allocation that it writes and --replay reads. Private to
// app/cli's .cpp files.

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

// Signatures of allocation heads. Private to app/cli's .cpp files.

/// Signs the head of an allocation: "torsio-allocation 1 RECORDS HASH TIME PUBLIC SIGNATURE", time in
/// microseconds since 1970 UTC. `key`: file; empty: returns the head unsigned. Throws Error like readKey().
[[nodiscard]] std::string signedAllocationHead(const std::string& head, const std::string& key,
                                               std::int64_t now_us);

/// Returns the first four words of such a line: the signed part except for the time.
[[nodiscard]] std::string unsignedAllocationHead(const std::string& line);

/// Keys for checking signatures, from the command line; empty: those of this station.
struct HeadKeys {
  std::string key{};        ///< file of the expected signing key
  std::string publicKey{};  ///< its public part instead
  std::string witness{};    ///< file with the lines that record replacements of keys
};

/// Result of checking the signatures of an allocation's heads.
struct SignatureFinding {
  std::string flaw{};  ///< empty: no objection
  bool isSigned = false;
  nlohmann::ordered_json json{};  ///< state, key, time, the expected key, and an explanation
};
/// `fileHead`: line of the file; `keptHead`: a line stored elsewhere; empty: none. Throws Error like
/// readKey(), kFileMissing for a given witness.
[[nodiscard]] SignatureFinding checkSignatures(const std::string& fileHead, const std::string& keptHead,
                                               const HeadKeys& keys);

}  // namespace torsio::cli
