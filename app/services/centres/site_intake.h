// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "app/services/centres/site_package.h"
#include "assessment/domain/study/site.h"
#include "db/connection/connection.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/base/seal_rules.h"
#include "db/repository/system/schema_tables.h"
#include "db/repository/system/site_repository.h"
#include "db/repository/system/site_tables.h"

namespace torsio {

/// Takes the rows of one package into a pooled record; knows which ids of plan rows stand here for those of
/// the package. Inside a transaction, which the caller gives up if anything is thrown.
class SiteIntake {
 public:
  SiteIntake(Connection& connection, const SiteManifest& manifest, Site site, SiteDeliveryId delivery);

  /// Throws Error: kVerifyFailed if a row is, or refers to, one of another centre, or differs from the one
  /// delivered before under its id; kBadData if rows do not fit together, or real and simulated ones are
  /// mixed; kNewerSchema for an unknown column; DbError.
  void take(const SitePackageRow& row);
  /// Stores which rows came with this delivery.
  void finish();

  [[nodiscard]] std::int64_t added() const { return added_; }
  [[nodiscard]] std::int64_t changed() const { return changed_; }
  [[nodiscard]] std::vector<RowSeal> changedSeals() && { return std::move(changedSeals_); }

 private:
  struct Brought {
    std::string table;
    std::string key;
    std::string seal;
  };
  /// A reference of the current table to rows that a centre delivers.
  struct Reference {
    std::string parent;
    std::vector<std::size_t> places;  // of the parent's key, in its order
    bool delivered = true;            // false: a table of which no centre delivers anything
  };

  [[noreturn]] void breaksRules() const;
  [[noreturn]] void differs(const std::string& table, const std::string& key, const Phrase& how) const;
  void adopt(Value& value) const;
  void beginTable(const SiteTable& table, const std::vector<std::string>& columns);
  void beginReferences(const SchemaTable& schema, const std::vector<std::string>& columns);
  [[nodiscard]] bool leadsHere(const SitePackageRow& row, const std::string& key) const;
  [[nodiscard]] std::size_t positionOf(const std::vector<std::string>& columns,
                                       std::string_view column) const;
  [[nodiscard]] std::optional<std::string> found(const SitePackageRow& row);
  void insert(const SitePackageRow& row);
  [[nodiscard]] std::int64_t nextInGroup(const std::string& group);
  void takePlan(const SitePackageRow& row);
  void takeRow(const SitePackageRow& row, const std::string& key);
  void takeChunk(const SitePackageRow& row, const std::string& key);
  void change(const SitePackageRow& row, const SealRule& rule, const std::string& key);

  Connection& connection_;
  const SiteManifest& manifest_;
  Site site_;
  SiteDeliveryId delivery_;
  SiteSealer sealer_;
  std::map<std::string, SchemaTable> tables_;
  std::unordered_map<std::string, SiteRepository::Row> known_;  // by "table/key"
  std::unordered_set<std::string> wholeTrials_;                 // ended when they came
  std::unordered_map<std::string, std::string> ids_;            // of plan rows, by the package's
  std::unordered_map<std::string, std::int64_t> lastInGroup_;
  std::unordered_set<std::string> newParents_;
  std::vector<Brought> brought_;
  std::vector<RowSeal> changedSeals_;
  std::int64_t added_ = 0;
  std::int64_t changed_ = 0;
  const SiteTable* table_ = nullptr;
  std::vector<char> boolean_;
  std::vector<std::size_t> place_;
  std::vector<Reference> references_;
  std::optional<Statement> insert_;
  std::optional<Statement> find_;
};

}  // namespace torsio
