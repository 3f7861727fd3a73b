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

/// What a transaction made of one row. No personal data: what an erase takes is hashed with a salt that goes
/// with it.
struct RowSeal {
  std::string table;
  std::string key;             ///< SealShape::keyOf()
  bool removed = false;        ///< the row is gone
  std::string rowHash{};       ///< over what an erase leaves; empty: removed
  std::string personalHash{};  ///< over what an erase takes; empty: nothing of it
  bool simulated = false;
  /// `rowHash` and `personalHash` as the row was right before it was changed; empty: it was not there, or
  /// nobody looked. Another one than the seal before says tells of a change behind the trail.
  std::string before{};
  std::string salt{};  ///< of personalHash; kept apart
};

/// Hash over the seals of one transaction, which its entry in the audit trail carries.
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

/// Who changed the rows that are sealed.
struct SealAuthor {
  std::int64_t atUtc_us = 0;
  std::string actor{};
  std::string station{};
  std::int64_t entries = 0;  ///< of the audit trail that tell of the same change and stand just before
  std::string reason{};
};

/// Hears every stored seal in the order of the trail: number of its entry, position in it, the seal without
/// its salt. Throws DbError.
void forEachSeal(
    Connection& connection,
    const std::function<void(std::int64_t sequence, std::int64_t position, const RowSeal& seal)>& hear);

[[nodiscard]] RowSeal sealedRow(const SealShape& shape, std::span<const Value> row, const std::string& seal);

/// Adds the entry and its seals; belongs into the transaction of the change.
void writeSeals(Connection& connection, const std::vector<RowSeal>& seals, const SealAuthor& author);

/// {"entries":1,"rows":2}
[[nodiscard]] std::string sealedJson(std::int64_t entries, std::size_t rows);
/// How many entries before it belong to the same change; 0 when that cannot be read.
[[nodiscard]] std::int64_t entriesOf(const std::string& sealedJson);

}  // namespace torsio
