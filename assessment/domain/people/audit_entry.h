// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/people/audit_terms.h"

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

/// Something that verifyAuditTrail() found.
struct AuditFinding {
  std::int64_t sequence = 0;  ///< of the entry; 0: no entry
  std::string objectKind{};
  std::string objectId{};
  std::string what{};
};

}  // namespace torsio
