// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/repository/base/row_seal.h"

namespace torsio {

/// Replays the row seals along the audit trail, then compares the rows with them. Call take() with every
/// entry of the chain, oldest first, then compareRows(), inside one transaction.
class SealVerification {
 public:
  SealVerification(Connection& connection, std::vector<AuditFinding>& findings)
      : connection_(connection), findings_(findings) {}

  void take(const AuditEntry& entry);
  /// Reads all seals and all rows. Throws DbError.
  void compareRows();
  /// Returns the people whose erase is in the trail with its tombstone: their recordings are missing
  /// legitimately.
  [[nodiscard]] const std::set<std::string>& erased() const { return erased_; }

 private:
  /// An entry that seals nothing.
  struct Act {
    std::string actor;
    std::string erased{};  // person
    bool removesDemonstration = false;
  };
  /// An entry that seals rows, with the other entries of its transaction.
  struct SealEntry {
    std::int64_t sequence = 0;
    std::string hash{};
    std::set<std::string> erasedPeople{};
    bool removesDemonstration = false;
  };
  /// The newest seal of a row.
  struct Last {
    std::string rowHash{};
    std::string personalHash{};
    bool removed = false;
    bool simulated = false;
    bool seen = false;
  };
  using Rows = std::unordered_map<std::string, Last>;

  void report(std::int64_t sequence, std::string_view table, const std::string& key, const Phrase& what);
  void readSeals();
  void apply(const SealEntry& entry, const RowSeal& seal);
  void requireGenuine(const SealEntry& entry, const RowSeal& seal, const Last& before);
  /// True if the table has a demonstration flag.
  [[nodiscard]] bool hasFlag(const std::string& table);
  [[nodiscard]] bool concernsErased(const SealEntry& entry, const RowSeal& seal);
  void readSchemaRows();
  void compareTable(const SealRule& rule);

  Connection& connection_;
  std::vector<AuditFinding>& findings_;
  std::vector<Act> recent_;  // since the last seal
  std::vector<SealEntry> entries_;
  std::unordered_map<std::string, Rows> tables_;
  std::unordered_map<std::string, std::unordered_map<std::string, std::string>> salts_;
  std::unordered_map<std::string, std::set<std::string>> ofPeople_;  // keys of a person's rows
  std::unordered_map<std::string, bool> flagged_;
  std::set<std::string> erased_;
};

}  // namespace torsio
