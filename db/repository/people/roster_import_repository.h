// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"

namespace torsio {

/// What makes a person a trainee or a rater.
enum class PersonPart { kTrainee, kRater };

/// A roster that was imported.
struct StoredRosterImport {
  std::string id{};
  std::string kind{};        ///< "trainees", "raters"
  std::string importedBy{};  ///< id of a user
  std::int64_t importedUtc_us = 0;
  std::int64_t added = 0;    ///< people
  std::int64_t changed = 0;  ///< people who were known before
  std::optional<std::int64_t> takenBackUtc_us{};
};

/// What an import did to one person.
struct StoredRosterPerson {
  PersonId personId{};
  std::optional<std::string> beforeJson{};  ///< none: the import added this person
  std::string afterJson{};
};

/// Something in the record that hangs on a person.
struct HangingRow {
  std::string personCode{};
  std::string table{};
};

/// Rosters that were imported. One call, one transaction; every call throws DbError when the database
/// refuses.
class RosterImportRepository {
 public:
  explicit RosterImportRepository(Connection& connection) : connection_(connection) {}

  void add(const StoredRosterImport& import, const std::vector<StoredRosterPerson>& people);
  /// Newest first.
  [[nodiscard]] std::vector<StoredRosterImport> all() const;
  /// In the order of their codes, without those who were erased since.
  [[nodiscard]] std::vector<StoredRosterPerson> people(const std::string& importId) const;
  /// The first person whom the import added and on whom something hangs. What a roster says about somebody,
  /// and an account that nobody has used yet, does not count.
  [[nodiscard]] std::optional<HangingRow> firstHanging(const std::string& importId) const;
  /// A table that names this part of a person; empty: none.
  [[nodiscard]] std::string tableNaming(PersonPart part, const PersonId& personId) const;
  /// Throws Error{kBadData} when it was taken back already, or there is no such import.
  void takeBack(const std::string& importId, std::int64_t utc_us);
  /// Takes a part away again that an import gave a person. Throws DbError when a row of the record names it.
  void removePart(PersonPart part, const PersonId& personId);

 private:
  Connection& connection_;
};

}  // namespace torsio
