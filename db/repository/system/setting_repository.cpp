// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/setting_repository.h"

namespace torsio {

std::optional<std::string> SettingRepository::value(const std::string& name) {
  Statement row = connection_.prepare("SELECT value FROM setting WHERE name = ?");
  row.execute({name});
  if (!row.step()) return std::nullopt;
  return row.text(0);
}

std::map<std::string, std::string> SettingRepository::values() {
  std::map<std::string, std::string> values;
  Statement row = connection_.prepare("SELECT name, value FROM setting");
  row.execute();
  while (row.step()) values.emplace(row.text(0), row.text(1));
  return values;
}

void SettingRepository::set(const std::string& name, const std::string& value, std::int64_t changedUtc_us) {
  connection_.execute(
      "INSERT INTO setting (name, value, changed_utc_us) VALUES (?, ?, ?) ON CONFLICT (name) DO UPDATE SET"
      " value = excluded.value, changed_utc_us = excluded.changed_utc_us",
      {name, value, changedUtc_us});
}

}  // namespace torsio
