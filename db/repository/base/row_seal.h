// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "db/connection/connection.h"
#include "db/repository/base/field_digest.h"
#include "db/repository/base/seal_rules.h"
#include "sim/core/digest.h"

namespace torsio {

/// Hashes of the rows that are part of another row's seal, by that row's key.
using SealedParts = std::unordered_map<std::string, std::vector<Digest::Value>>;

/// The columns of one table, classified by its rule. Null columns add nothing to the hash, so that a
/// migration may add a column.
class SealShape {
 public:
  /// `columns`: in the order of a SELECT of the whole row. Throws Error (kVerifyFailed) if a key column is
  /// missing.
  SealShape(const SealRule& rule, std::vector<std::string> columns);

  [[nodiscard]] const SealRule& rule() const { return *rule_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  /// Returns the key of a row: its values joined by "/".
  [[nodiscard]] std::string keyOf(std::span<const Value> row) const;
  [[nodiscard]] std::vector<Value> keyValuesOf(std::span<const Value> row) const;
  /// Returns the first value of the key: the row whose seal includes this one (Sealing::kWithParent).
  [[nodiscard]] std::string parentKeyOf(std::span<const Value> row) const;
  /// Hashes the columns that an erase keeps.
  [[nodiscard]] Digest::Value kept(std::span<const Value> row) const;
  /// Hashes the columns that an erase removes, with the salt; empty if the row has none.
  [[nodiscard]] std::string personal(std::span<const Value> row, std::string_view salt) const;
  [[nodiscard]] bool hasPersonal(std::span<const Value> row) const;
  [[nodiscard]] bool simulated(std::span<const Value> row) const;

 private:
  enum class Part { kKept, kPersonal, kUnsealed };

  const SealRule* rule_;
  std::vector<std::string> columns_;
  std::vector<Part> parts_;
  std::vector<std::size_t> key_;  ///< positions of the key's columns
  int flag_ = -1;                 ///< position of "demonstration"
};

/// Returns the hash of a row and the rows in its seal as 64 hexadecimal digits.
[[nodiscard]] std::string sealOf(const Digest::Value& kept, std::vector<Digest::Value> parts);

/// Formats a key: "a/7/0.25".
[[nodiscard]] std::string keyText(std::span<const Value> key);

[[nodiscard]] std::vector<Value> valuesOf(const Statement& row);
[[nodiscard]] std::vector<std::string> columnNamesOf(const Statement& row);

/// Returns the rules of the tables whose rows are part of a table's seals.
[[nodiscard]] std::vector<const SealRule*> rulesOfParts(std::string_view parent);

/// Calls `take` for every row of a SELECT without placeholders, fetching some hundred at a time. Inside a
/// transaction only.
void forEachSelected(Connection& connection, const std::string& select,
                     const std::function<void(const Statement&)>& take);

/// Returns the hashes of all rows that are part of this table's seals. Inside a transaction only.
[[nodiscard]] SealedParts partsOf(Connection& connection, std::string_view parent);

/// Calls `take` for every row with a seal of its own, with its shape and the hash of the row and its parts,
/// and `orphan` for the key of each missing row that has parts. Inside a transaction only.
using TakeSealable =
    std::function<void(const SealShape& shape, std::span<const Value> row, const std::string& seal)>;
void forEachSealable(Connection& connection, const SealRule& rule, const TakeSealable& take,
                     const std::function<void(const std::string& key)>& orphan = {});

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
