// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/site.h"
#include "db/connection/connection.h"

namespace torsio {

/// Centres whose packages were pooled into a record, and what they brought.
class SiteRepository {
 public:
  explicit SiteRepository(Connection& connection) : connection_(connection) {}

  void add(const Site& site);
  /// By code.
  [[nodiscard]] std::vector<Site> sites() const;
  void add(const SiteDelivery& delivery);
  /// Oldest first, of all sites.
  [[nodiscard]] std::vector<SiteDelivery> deliveries() const;

  /// A row that came with a delivery.
  struct Row {
    CentreId centreId{};
    std::string seal{};
  };
  /// Returns the newest state of every delivered row, by "table/key".
  [[nodiscard]] std::unordered_map<std::string, Row> rows() const;
  /// Returns the code of the site that delivered a row; empty: nobody. `key`: as a seal has it, or the id of
  /// a site or delivery.
  [[nodiscard]] std::string siteOfRow(const std::string& key) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
