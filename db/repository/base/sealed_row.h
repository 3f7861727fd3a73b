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

/// Hashes of the rows that go into the seal of another, by the key of that one.
using SealedParts = std::unordered_map<std::string, std::vector<Digest::Value>>;

/// The columns of one table, sorted into what its rule says of them. A column without a value adds nothing,
/// so that a step of the schema may add one.
class SealShape {
 public:
  /// `columns`: as a SELECT of the whole row gives them. Throws Error (kVerifyFailed) when one of the key is
  /// not among them.
  SealShape(const SealRule& rule, std::vector<std::string> columns);

  [[nodiscard]] const SealRule& rule() const { return *rule_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  /// Which row it is: the values of its key, divided by "/".
  [[nodiscard]] std::string keyOf(std::span<const Value> row) const;
  [[nodiscard]] std::vector<Value> keyValuesOf(std::span<const Value> row) const;
  /// The first value of the key: the row whose seal a row with Sealing::kWithParent goes into.
  [[nodiscard]] std::string parentKeyOf(std::span<const Value> row) const;
  /// Over what an erase leaves.
  [[nodiscard]] Digest::Value kept(std::span<const Value> row) const;
  /// Over what an erase takes, with the salt; empty when the row holds nothing of it.
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

/// 64 hexadecimal digits over a row and those that go into its seal.
[[nodiscard]] std::string sealOf(const Digest::Value& kept, std::vector<Digest::Value> parts);

/// "a/7/0.25"
[[nodiscard]] std::string keyText(std::span<const Value> key);

/// The values of the current row.
[[nodiscard]] std::vector<Value> valuesOf(const Statement& row);
[[nodiscard]] std::vector<std::string> columnNamesOf(const Statement& row);

/// Rules of the rows that go into the seals of a table.
[[nodiscard]] std::vector<const SealRule*> rulesOfParts(std::string_view parent);

/// Calls `take` for every row of a SELECT without placeholders; holds only some hundred of them. Inside a
/// transaction only.
void forEachSelected(Connection& connection, const std::string& select,
                     const std::function<void(const Statement&)>& take);

/// Hashes of all rows of the tables that go into the seals of this one. Inside a transaction only.
[[nodiscard]] SealedParts partsOf(Connection& connection, std::string_view parent);

/// Calls `take` for every row of a table that has a seal of its own, with its shape and with the hash over
/// the row and its parts, and `orphan` for the key of each row that is not there although it has parts.
/// Inside a transaction only.
using TakeSealable =
    std::function<void(const SealShape& shape, std::span<const Value> row, const std::string& seal)>;
void forEachSealable(Connection& connection, const SealRule& rule, const TakeSealable& take,
                     const std::function<void(const std::string& key)>& orphan = {});

}  // namespace torsio
