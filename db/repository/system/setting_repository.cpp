// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/setting_repository.h"

#include "db/connection/row_reader.h"

namespace torsio {

std::optional<std::string> SettingRepository::value(const std::string& name) const {
  return selectFirst(connection_, "SELECT value FROM setting WHERE name = ?", {name}, readText);
}

std::map<std::string, std::string> SettingRepository::values() const {
  const std::vector<std::pair<std::string, std::string>> all =
      selectAll(connection_, "SELECT name, value FROM setting", {}, [](RowReader& row) {
        return std::pair<std::string, std::string>{row.text(), row.text()};
      });
  return {all.begin(), all.end()};
}

void SettingRepository::set(const std::string& name, const std::string& value, std::int64_t changedUtc_us) {
  connection_.execute(insertInto("setting", "name, value, changed_utc_us") +
                          " ON CONFLICT (name) DO UPDATE SET value = excluded.value, changed_utc_us ="
                          " excluded.changed_utc_us",
                      {name, value, changedUtc_us});
}

}  // namespace torsio
