// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/base/row_seal.h"

namespace torsio {

/// One table of what a centre gives to a pooled record.
struct SiteTable {
  std::string_view table;
  /// Plan tables: the columns by which a row is the same one in every record of the protocol. Empty: rows are
  /// known by their key, a UUID of their centre.
  std::string_view sameBy{};
  std::string_view condition{};  ///< which rows; {cohort} {campaign} {version} {people} {trainees}
                                 ///< {withdrawn} {enrolments}
  std::string_view withheld{};   ///< "recorded_by, reason": nobody outside needs them
};

/// Every table that is given, parents first. Rows of other tables stay in their centre.
[[nodiscard]] const std::vector<SiteTable>& siteTables();
/// Null: not given.
[[nodiscard]] const SiteTable* siteTableOf(std::string_view table);

/// The people of a cohort whose rows may leave their centre.
struct SiteScope {
  CohortId cohortId{};
  CampaignId campaignId{};  ///< empty: no evaluation
  CurriculumVersionId versionId{};

  /// Returns a SELECT of rows of the table with these columns.
  [[nodiscard]] std::string select(const SiteTable& table, const std::string& columns) const;
};

/// Counts trainees of the cohort: those who agree to research or are simulated, and the others.
struct SiteConsent {
  std::int64_t given = 0;
  std::int64_t leftOut = 0;
};
[[nodiscard]] SiteConsent siteConsent(Connection& connection, const SiteScope& scope);

/// Returns the codes of a centre's trainees in a pooled record whose newest decision is against research.
[[nodiscard]] std::vector<std::string> withdrawnPeople(Connection& connection, const CentreId& site);

/// Hashes rows of a table as their own record seals them; a row of another row's seal adds to that.
class SiteSealer {
 public:
  /// Returns the key of a row of any given table, as a seal has it. Throws Error (kVerifyFailed) if a column
  /// of the key is missing.
  [[nodiscard]] std::string keyOf(const std::string& table, const std::vector<std::string>& columns,
                                  const std::vector<Value>& row);
  /// Adds a row. Rows of tables without seals are ignored.
  void add(const std::string& table, const std::vector<std::string>& columns, const std::vector<Value>& row);
  /// Returns the seals by key, of a table or of all.
  [[nodiscard]] std::map<std::string, std::string> seals(const std::string& table);

 private:
  [[nodiscard]] const SealShape& shapeOf(const std::string& table, const std::vector<std::string>& columns);

  std::map<std::string, SealShape> shapes_;
  std::map<std::string, std::map<std::string, Digest::Value>> kept_;
  std::map<std::string, SealedParts> parts_;  // by parent table
};

}  // namespace torsio
