// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/site_repository.h"

#include "db/connection/row_reader.h"
#include "db/repository/base/row_columns.h"

namespace torsio {

namespace {

constexpr auto kSites = rowColumns<Site>(
    "site", "centre_id, code, name, public_key, first_utc_us, demonstration", &Site::centreId, &Site::code,
    &Site::name, &Site::publicKey, &Site::firstUtc_us, &Site::demonstration);
constexpr auto kDeliveries = rowColumns<SiteDelivery>(
    "site_delivery",
    "id, centre_id, sequence, package_hash, made_utc_us, trail_length, trail_hash, protocol_hash, rows_added,"
    " left_out, received_by, received_utc_us, demonstration",
    &SiteDelivery::id, &SiteDelivery::centreId, &SiteDelivery::sequence, &SiteDelivery::packageHash,
    &SiteDelivery::madeUtc_us, &SiteDelivery::trailLength, &SiteDelivery::trailHash,
    &SiteDelivery::protocolHash, &SiteDelivery::rowsAdded, &SiteDelivery::leftOut, &SiteDelivery::receivedBy,
    &SiteDelivery::receivedUtc_us, &SiteDelivery::demonstration);

}  // namespace

void SiteRepository::add(const Site& site) {
  connection_.prepare(kSites.insert()).execute(kSites.values(site));
}

std::vector<Site> SiteRepository::sites() const {
  return selectAll(connection_, kSites.select("s") + " FROM site s ORDER BY s.code", {}, kSites);
}

void SiteRepository::add(const SiteDelivery& delivery) {
  connection_.prepare(kDeliveries.insert()).execute(kDeliveries.values(delivery));
}

std::vector<SiteDelivery> SiteRepository::deliveries() const {
  return selectAll(
      connection_,
      kDeliveries.select("d") + " FROM site_delivery d ORDER BY d.received_utc_us, d.centre_id, d.sequence",
      {}, kDeliveries);
}

std::unordered_map<std::string, SiteRepository::Row> SiteRepository::rows() const {
  std::unordered_map<std::string, Row> rows;
  Statement row = connection_.prepare(
      "SELECT d.centre_id, r.table_name, r.row_key, r.site_seal FROM site_row r JOIN site_delivery d"
      " ON d.id = r.delivery_id ORDER BY d.sequence");
  row.execute();
  while (row.step()) {
    rows[row.text(1) + "/" + row.text(2)] = {row.text(0), row.text(3)};
  }
  return rows;
}

std::string SiteRepository::siteOfRow(const std::string& key) const {
  return selectFirst(connection_,
                     "SELECT s.code FROM site s WHERE s.centre_id = ? OR s.centre_id IN"
                     " (SELECT d.centre_id FROM site_delivery d WHERE d.id = ?) OR s.centre_id IN"
                     " (SELECT d.centre_id FROM site_row r JOIN site_delivery d ON d.id = r.delivery_id"
                     " WHERE r.row_key = ?) LIMIT 1",
                     {key, key, key}, readText)
      .value_or("");
}

}  // namespace torsio
