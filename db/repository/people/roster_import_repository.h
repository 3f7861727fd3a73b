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

/// An imported roster.
struct StoredRosterImport {
  std::string id{};
  std::string kind{};        ///< "trainees", "raters"
  std::string importedBy{};  ///< id of a user
  std::int64_t importedUtc_us = 0;
  std::int64_t added = 0;    ///< people added
  std::int64_t changed = 0;  ///< known people changed
  std::optional<std::int64_t> takenBackUtc_us{};
};

/// Effect of an import on one person.
struct StoredRosterPerson {
  PersonId personId{};
  std::optional<std::string> beforeJson{};  ///< empty: the import added this person
  std::string afterJson{};
};

/// A row that refers to a person.
struct HangingRow {
  std::string personCode{};
  std::string table{};
};

/// Imported rosters. Each call is one transaction and throws DbError.
class RosterImportRepository {
 public:
  explicit RosterImportRepository(Connection& connection) : connection_(connection) {}

  void add(const StoredRosterImport& import, const std::vector<StoredRosterPerson>& people);
  /// Newest first.
  [[nodiscard]] std::vector<StoredRosterImport> all() const;
  /// By code, without those erased since.
  [[nodiscard]] std::vector<StoredRosterPerson> people(const std::string& importId) const;
  /// Returns the first reference to a person added by the import, apart from what the roster itself wrote and
  /// unused accounts; empty: none.
  [[nodiscard]] std::optional<HangingRow> firstHanging(const std::string& importId) const;
  /// Returns a table that refers to the person as trainee or rater; empty: none.
  [[nodiscard]] std::string tableNaming(PersonPart part, const PersonId& personId) const;
  /// Marks an import as undone. Throws Error{kBadData} if it already is, or does not exist.
  void takeBack(const std::string& importId, std::int64_t utc_us);
  /// Removes the trainee or rater part that an import gave a person. Throws DbError if it is referenced.
  void removePart(PersonPart part, const PersonId& personId);

 private:
  Connection& connection_;
};

}  // namespace torsio
