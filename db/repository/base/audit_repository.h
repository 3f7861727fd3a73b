// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// One line of the audit trail: who, when, where, what, old, new, why. Ids and codes only, never a name.
struct AuditEntry {
  std::int64_t sequence = 0;  ///< given by append()
  std::int64_t atUtc_us = 0;
  std::string actor{};  ///< id of a user or rater; "torsio" for the program itself
  std::string station{};
  std::string action{};      ///< "mark.submit", "report.export_named" ...
  std::string objectKind{};  ///< table of the object: "training_mark"
  std::string objectId{};
  std::string oldJson{};
  std::string newJson{};
  std::string reason{};
  std::string objectHash{};    ///< seals the row that was written; empty: nothing sealed
  std::string previousHash{};  ///< given by append()
  std::string entryHash{};     ///< given by append()
};

/// Action of an entry that tells of a sealed row which went with the demonstration data: it is not missed.
inline constexpr const char* kDemonstrationRemoved = "demonstration.remove";

/// Which entries to list, newest first. Empty texts do not restrict.
struct AuditFilter {
  std::string objectKind{};
  std::string objectId{};
  std::int64_t fromUtc_us = 0;
  std::int64_t toUtc_us = INT64_MAX;
  std::int64_t limit = 500;
};

/// The hash-chained trail. append() belongs into the transaction of the change that it tells of.
class AuditRepository {
 public:
  explicit AuditRepository(Connection& connection) : connection_(connection) {}

  /// One transaction, or part of the one that is open. Stations wait for each other here.
  void append(std::span<const AuditEntry> entries);
  void append(const AuditEntry& entry) { append(std::span(&entry, 1)); }
  [[nodiscard]] std::vector<AuditEntry> entries(const AuditFilter& filter = {});
  /// Entries of a time, both ends included.
  [[nodiscard]] std::int64_t count(std::int64_t fromUtc_us, std::int64_t toUtc_us = INT64_MAX) const;

  /// Gives every entry of the chain to `take`, oldest first, one at a time.
  void forEach(const std::function<void(const AuditEntry&)>& take) const;
  /// Entries in the chain.
  [[nodiscard]] std::int64_t length() const;

 private:
  Connection& connection_;
};

/// BLAKE2b-256 over the previous hash and every field but the entry hash.
[[nodiscard]] std::string auditHash(const AuditEntry& entry);

}  // namespace torsio
