// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/settings_service.h"

#include <charconv>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/services/access/two_people.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::size_t kLongestValue = 4000;
constexpr const char* kIdleWarn = "idle_warn_minutes";
constexpr const char* kIdleLock = "idle_lock_minutes";

bool sensible(int warn_min, int lock_min) {
  return warn_min >= 1 && warn_min < lock_min && lock_min >= kShortestIdleLock_min &&
         lock_min <= kLongestIdleLock_min;
}

/// 0 for what is no small number.
int minutesOf(const std::optional<std::string>& text) {
  int minutes = 0;
  if (text) {
    std::from_chars(text->data(), text->data() + text->size(), minutes);
  }
  return minutes;
}

}  // namespace

void setCentreSetting(SessionContext& session, const std::string& name, const std::string& value,
                      const std::string& reason) {
  session.require(Operation::kSettingsEdit);
  if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos) {
    throw Error(ErrorCode::kBadParameter, Text::tr("this is no name of a setting"), name,
                Text::tr("Choose one from the list"));
  }
  if (value.size() > kLongestValue) {
    throw Error(ErrorCode::kBadParameter, Text::tr("the value is too long"), name, Text::tr("Shorten it"));
  }
  Transaction transaction(session.connection());
  if (name == kTwoPeopleSetting && value == "no" && !mayDropTheRule(session)) {
    requireSecondPerson(session, DutyAct::kOnePerson, name);
  }
  SettingRepository settings(session.connection());
  const std::string before = settings.value(name).value_or("");
  settings.set(name, value, session.now_us());
  session.note({.action = AuditAction::kSettingChange,
                .objectKind = AuditObject::kSetting,
                .objectId = name,
                .oldJson = nlohmann::json{{"value", before}}.dump(),
                .newJson = nlohmann::json{{"value", value}}.dump(),
                .reason = reason});
  transaction.commit();
}

void setCentreName(SessionContext& session, const std::string& name) {
  session.require(Operation::kSettingsEdit);
  if (name.empty()) {
    throw Error(ErrorCode::kBadParameter, Text::tr("the centre has no name"), Text::tr("centre"),
                Text::tr("Enter the name of your centre"));
  }
  Transaction transaction(session.connection());
  StudyRepository studies(session.connection());
  const std::optional<Centre> before = studies.centre();
  if (before && before->name == name) {
    return;
  }
  Centre centre = before.value_or(Centre{.id = session.ids().newUuid()});
  centre.name = name;
  centre.demonstration = false;
  if (!before) {
    centre.createdUtc_us = session.now_us();
  }
  studies.setCentre(centre);
  session.note({.action = AuditAction::kCentreRename,
                .objectKind = AuditObject::kCentre,
                .objectId = centre.id,
                .oldJson = nlohmann::json{{"name", before ? before->name : ""}}.dump(),
                .newJson = nlohmann::json{{"name", name}}.dump()});
  transaction.commit();
}

IdleLimits centreIdleLimits(Connection& connection) {
  SettingRepository settings(connection);
  const int warn_min = minutesOf(settings.value(kIdleWarn));
  const int lock_min = minutesOf(settings.value(kIdleLock));
  if (!sensible(warn_min, lock_min)) {
    return {};
  }
  return {.warn_us = warn_min * kMinute_us, .lock_us = lock_min * kMinute_us};
}

void setCentreIdleLimits(SessionContext& session, int warn_min, int lock_min) {
  session.require(Operation::kSettingsEdit);
  if (!sensible(warn_min, lock_min)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("these minutes make no sense"), Text::tr("idle lock"),
                Text::tr("Lock after %1 to %2 minutes, and warn at least one minute before",
                         kShortestIdleLock_min, kLongestIdleLock_min));
  }
  Transaction transaction(session.connection());
  setCentreSetting(session, kIdleWarn, std::to_string(warn_min));
  setCentreSetting(session, kIdleLock, std::to_string(lock_min));
  transaction.commit();
}

void setGradedWithMouse(SessionContext& session, bool graded) {
  setCentreSetting(session, "graded_with_mouse", graded ? "yes" : "no");
}

void setSoundAtLimit(SessionContext& session, bool sound) {
  setCentreSetting(session, "sound_at_limit", sound ? "yes" : "no");
}

}  // namespace torsio
