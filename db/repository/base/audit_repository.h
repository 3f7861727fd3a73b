// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/audit_terms.h"
#include "db/connection/connection.h"

namespace torsio {

/// Length of the trail and hash of its newest entry; both empty for an empty trail.
struct TrailHead {
  std::int64_t length = 0;
  std::string hash{};
};

/// The hash-chained audit trail. Call append() in the transaction of the change that it records.
class AuditRepository {
 public:
  explicit AuditRepository(Connection& connection) : connection_(connection) {}

  /// Appends in one transaction, or joins the open one; stations serialise here. Returns the sequence number
  /// of the newest entry.
  std::int64_t append(std::span<const NewAuditEntry> entries);
  std::int64_t append(const NewAuditEntry& entry) { return append(std::span(&entry, 1)); }
  /// Newest first; without row seals (AuditAction::kRecordSeal), which are nobody's acts.
  [[nodiscard]] std::vector<AuditEntry> entries(const AuditFilter& filter = {});
  /// Number of entries in a time range, both ends included; without row seals.
  [[nodiscard]] std::int64_t count(std::int64_t fromUtc_us, std::int64_t toUtc_us = INT64_MAX) const;

  /// Calls `take` with every entry of the chain, oldest first.
  void forEach(const std::function<void(const AuditEntry&)>& take) const;
  /// Returns the newest entry as a head to be stored elsewhere.
  [[nodiscard]] TrailHead head() const;
  /// True if the chain has had this head.
  [[nodiscard]] bool contains(const TrailHead& head) const;
  /// Number of entries in the chain.
  [[nodiscard]] std::int64_t length() const;

 private:
  Connection& connection_;
};

/// BLAKE2b-256 of the previous hash and every field except the entry hash.
[[nodiscard]] std::string auditHash(const AuditEntry& entry);

/// Returns display texts for the subjects of audit entries from `fromSequence` on, by object id: a person's
/// code, a login, "R-03: case 7F", the name of a cohort. Objects without one are omitted. Never a person's
/// name. Throws DbError.
[[nodiscard]] std::map<std::string, std::string> auditSubjects(Connection& connection,
                                                               std::int64_t fromSequence);

}  // namespace torsio
