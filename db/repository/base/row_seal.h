// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "db/connection/connection.h"
#include "db/repository/base/field_digest.h"
#include "db/repository/base/sealed_row.h"

namespace torsio {

/// The state of one row after a transaction. Contains no personal data: what an erase removes is hashed with
/// a salt that is removed with it.
struct RowSeal {
  std::string table;
  std::string key;             ///< SealShape::keyOf()
  bool removed = false;        ///< the row was deleted
  std::string rowHash{};       ///< of the columns that an erase keeps; empty: removed
  std::string personalHash{};  ///< of the columns that an erase removes; empty: the row has none
  bool simulated = false;
  /// `rowHash` and `personalHash` right before the change; empty: the row was new, or not checked. A
  /// difference from the previous seal reveals a change outside the audit trail.
  std::string before{};
  std::string salt{};  ///< of personalHash; stored apart
};

/// Hash of the seals of one transaction, stored in its entry of the audit trail.
class SealDigest {
 public:
  void add(std::int64_t position, const RowSeal& seal) {
    digest_.add(position)
        .add(seal.table)
        .add(seal.key)
        .add(seal.removed)
        .add(seal.rowHash)
        .add(seal.personalHash);
    digest_.add(seal.simulated).add(seal.before);
  }
  [[nodiscard]] std::string hex() const { return digest_.hex(); }

 private:
  FieldDigest digest_{"torsio seals 1"};
};

/// Author of a sealed change.
struct SealAuthor {
  std::int64_t atUtc_us = 0;
  std::string actor{};
  std::string station{};
  std::int64_t entries = 0;  ///< audit entries about the same change, immediately before this one
  std::string reason{};
};

/// Calls back with every stored seal in the order of the trail: number of its entry, position in it, the seal
/// without its salt. Throws DbError.
void forEachSeal(
    Connection& connection,
    const std::function<void(std::int64_t sequence, std::int64_t position, const RowSeal& seal)>& hear);

[[nodiscard]] RowSeal sealedRow(const SealShape& shape, std::span<const Value> row, const std::string& seal);

/// Appends the entry and its seals; call it in the transaction of the change.
void writeSeals(Connection& connection, const std::vector<RowSeal>& seals, const SealAuthor& author);

/// Returns {"entries":1,"rows":2}.
[[nodiscard]] std::string sealedJson(std::int64_t entries, std::size_t rows);
/// Returns the number of preceding entries about the same change; 0 if unreadable.
[[nodiscard]] std::int64_t entriesOf(const std::string& sealedJson);

}  // namespace torsio
