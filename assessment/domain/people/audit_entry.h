// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/people/audit_terms.h"

namespace torsio {

/// Input of append() to the audit trail: who, when, where, what, old and new value, why. Ids and codes only,
/// never a name.
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
  std::string objectHash{};  ///< hash of the row that was written; empty: nothing is sealed
};

/// One entry of the audit trail as stored, including entries of other program versions.
struct AuditEntry {
  std::int64_t sequence = 0;  ///< 1, 2, 3 ... in the trail
  std::int64_t atUtc_us = 0;
  std::string actor{};  ///< id of a user or rater; "torsio" for the program itself
  std::string station{};
  std::string action{};      ///< stored text of an AuditAction, possibly unknown to this version
  std::string objectKind{};  ///< stored text of an AuditObject, possibly unknown to this version
  std::string objectId{};
  std::string oldJson{};
  std::string newJson{};
  std::string reason{};
  std::string objectHash{};    ///< hash of the row that was written; empty: nothing is sealed
  std::string previousHash{};  ///< entryHash of the entry before
  std::string entryHash{};     ///< auditHash() of this entry
};

/// Filter of audit entries, which are listed newest first. Empty members do not restrict.
struct AuditFilter {
  std::optional<AuditObject> objectKind{};
  std::string objectId{};
  std::int64_t fromUtc_us = 0;
  std::int64_t toUtc_us = INT64_MAX;
  std::int64_t limit = 500;
};

/// A fault found by verifyAuditTrail().
struct AuditFinding {
  std::int64_t sequence = 0;  ///< of the entry; 0: concerns no single entry
  std::string objectKind{};
  std::string objectId{};
  std::string what{};
};

}  // namespace torsio
