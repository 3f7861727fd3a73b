// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/audit_terms.h"
#include "db/connection/connection.h"

namespace torsio {

/// How long the trail is, and the hash of its newest entry; both empty: nothing was noted yet.
struct TrailHead {
  std::int64_t length = 0;
  std::string hash{};
};

/// The hash-chained trail. append() belongs into the transaction of the change that it tells of.
class AuditRepository {
 public:
  explicit AuditRepository(Connection& connection) : connection_(connection) {}

  /// One transaction, or part of the one that is open. Stations wait for each other here. Returns the
  /// number of the newest entry.
  std::int64_t append(std::span<const NewAuditEntry> entries);
  std::int64_t append(const NewAuditEntry& entry) { return append(std::span(&entry, 1)); }
  /// Newest first; without the seals of rows (AuditAction::kRecordSeal), which tell of no act of anybody.
  [[nodiscard]] std::vector<AuditEntry> entries(const AuditFilter& filter = {});
  /// Entries of a time, both ends included; without the seals of rows.
  [[nodiscard]] std::int64_t count(std::int64_t fromUtc_us, std::int64_t toUtc_us = INT64_MAX) const;

  /// Gives every entry of the chain to `take`, oldest first, one at a time.
  void forEach(const std::function<void(const AuditEntry&)>& take) const;
  /// The newest entry: what a head that is kept elsewhere names.
  [[nodiscard]] TrailHead head() const;
  /// Entries in the chain.
  [[nodiscard]] std::int64_t length() const;

 private:
  Connection& connection_;
};

/// BLAKE2b-256 over the previous hash and every field but the entry hash.
[[nodiscard]] std::string auditHash(const AuditEntry& entry);

}  // namespace torsio
