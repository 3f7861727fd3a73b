// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/setting_repository.h"

#include "db/connection/row_reader.h"

namespace torsio {

std::optional<std::string> SettingRepository::value(const std::string& name) const {
  return selectFirst(connection_, "SELECT value FROM setting WHERE name = ?", {name}, readText);
}

void SettingRepository::set(const std::string& name, const std::string& value, std::int64_t changedUtc_us) {
  connection_.execute(insertInto("setting", "name, value, changed_utc_us") +
                          " ON CONFLICT (name) DO UPDATE SET value = excluded.value, changed_utc_us ="
                          " excluded.changed_utc_us",
                      {name, value, changedUtc_us});
}

}  // namespace torsio
