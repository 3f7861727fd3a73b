// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "db/connection/connection.h"
#include "db/repository/base/audit_terms.h"

namespace torsio {

/// What append() adds to the audit trail: who, when, where, what, old, new, why. Ids and codes only, never a
/// name.
struct NewAuditEntry {
  std::int64_t atUtc_us;
  std::string actor;  ///< id of a user or rater; "torsio" for the program itself
  std::string station;
  AuditAction action;
  AuditObject objectKind;
  std::string objectId{};
  std::string oldJson{};
  std::string newJson{};
  std::string reason{};
  std::string objectHash{};  ///< seals the row that was written; empty: nothing sealed
};

/// One line of the audit trail as it stands in the database, also when another version wrote it.
struct AuditEntry {
  std::int64_t sequence = 0;  ///< 1, 2, 3 ... of the trail
  std::int64_t atUtc_us = 0;
  std::string actor{};  ///< id of a user or rater; "torsio" for the program itself
  std::string station{};
  std::string action{};      ///< text of an AuditAction, known to this version or not
  std::string objectKind{};  ///< text of an AuditObject, known to this version or not
  std::string objectId{};
  std::string oldJson{};
  std::string newJson{};
  std::string reason{};
  std::string objectHash{};    ///< seals the row that was written; empty: nothing sealed
  std::string previousHash{};  ///< entryHash of the entry before
  std::string entryHash{};     ///< auditHash() of this entry
};

/// Which entries to list, newest first. What is empty does not restrict.
struct AuditFilter {
  std::optional<AuditObject> objectKind{};
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
  void append(std::span<const NewAuditEntry> entries);
  void append(const NewAuditEntry& entry) { append(std::span(&entry, 1)); }
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
