// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/setting_repository.h"

#include "db/connection/row_reader.h"

namespace torsio {

std::optional<std::string> SettingRepository::value(std::string_view name) const {
  return selectFirst(connection_, "SELECT value FROM setting WHERE name = ?", {std::string(name)}, readText);
}

void SettingRepository::set(std::string_view name, const std::string& value, std::int64_t changedUtc_us) {
  connection_.execute(insertInto("setting", "name, value, changed_utc_us") +
                          " ON CONFLICT (name) DO UPDATE SET value = excluded.value, changed_utc_us ="
                          " excluded.changed_utc_us",
                      {std::string(name), value, changedUtc_us});
}

}  // namespace torsio
