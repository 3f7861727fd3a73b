// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/access/settings_service.h"

#include <nlohmann/json.hpp>

#include "db/repository/setting_repository.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

constexpr std::size_t kLongestValue = 4000;

}  // namespace

std::map<std::string, std::string> centreSettings(Workplace& workplace) {
  workplace.require(Operation::kSettingsEdit);
  return SettingRepository(workplace.connection()).values();
}

void setCentreSetting(Workplace& workplace, const std::string& name, const std::string& value,
                      const std::string& reason) {
  workplace.require(Operation::kSettingsEdit);
  if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos) {
    throw Error(ErrorCode::kBadParameter, "this is no name of a setting", name, "Choose one from the list");
  }
  if (value.size() > kLongestValue) {
    throw Error(ErrorCode::kBadParameter, "the value is too long", name, "Shorten it");
  }
  Transaction transaction(workplace.connection());
  SettingRepository settings(workplace.connection());
  const std::string before = settings.value(name).value_or("");
  settings.set(name, value, workplace.now_us());
  workplace.note({.action = "setting.change",
                  .objectKind = "setting",
                  .objectId = name,
                  .oldJson = nlohmann::json{{"value", before}}.dump(),
                  .newJson = nlohmann::json{{"value", value}}.dump(),
                  .reason = reason});
  transaction.commit();
}

}  // namespace torsio
