// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

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

/// Which entries to list, newest first. Empty texts do not restrict.
struct AuditFilter {
  std::string objectKind{};
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
