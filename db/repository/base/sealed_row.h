// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "db/connection/connection.h"
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

/// Returns the values of the current row.
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

}  // namespace torsio
