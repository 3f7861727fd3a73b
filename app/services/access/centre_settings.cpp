// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/access/centre_settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include <nlohmann/json.hpp>

#include "app/services/access/two_people.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/site.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

constexpr std::size_t kMaxSpeeds = 10;

std::optional<double> numberIn(const CentreSetting& setting, std::string_view text) {
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto [last, fault] = std::from_chars(text.data(), end, number);
  const bool sound = fault == std::errc{} && last == end && number >= setting.least &&
                     number <= setting.most &&
                     (setting.kind != SettingKind::kWhole || number == std::floor(number));
  return sound ? std::optional(number) : std::nullopt;
}

/// Parses a text to numbers, 1 for "yes" and 0 for "no"; empty if invalid.
std::vector<double> numbersIn(const CentreSetting& setting, std::string_view text) {
  if (setting.kind == SettingKind::kYesNo) {
    return text == "yes" ? std::vector{1.0} : text == "no" ? std::vector{0.0} : std::vector<double>();
  }
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end =
        setting.kind == SettingKind::kSpeeds ? std::min(text.find(',', begin), text.size()) : text.size();
    const std::optional<double> number = numberIn(setting, text.substr(begin, end - begin));
    if (!number || numbers.size() == kMaxSpeeds) {
      return {};
    }
    numbers.push_back(*number);
    begin = end + 1;
  }
  if (setting.kind == SettingKind::kSpeeds) {
    numbers.push_back(1.0);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }
  return numbers;
}

/// Returns `written` in the stored format; empty if invalid.
std::optional<std::string> canonical(const CentreSetting& setting, const std::string& written) {
  if (setting.name == kCentreCode.name) {
    return written.empty() || isCentreCode(written) ? std::optional(written) : std::nullopt;
  }
  if (setting.kind == SettingKind::kChoice) {
    const std::vector<std::string> words = choicesOf(setting);
    return std::find(words.begin(), words.end(), written) != words.end() ? std::optional(written)
                                                                         : std::nullopt;
  }
  if (setting.kind == SettingKind::kWords) {
    return static_cast<double>(written.size()) <= setting.most ? std::optional(written) : std::nullopt;
  }
  const std::vector<double> numbers = numbersIn(setting, written);
  return numbers.empty() ? std::nullopt : std::optional(asStored(setting, numbers));
}

std::string inForce(Connection& connection, const CentreSetting& setting) {
  const std::string stored = SettingRepository(connection).value(setting.name).value_or("");
  return canonical(setting, stored).value_or(std::string(setting.initial));
}

Text range(const CentreSetting& setting) {
  if (setting.name == kCentreCode.name) {
    return Text::tr("Write one to eight capital Latin letters, digits or hyphens, a letter first");
  }
  const std::string least = asStored(setting, {setting.least});
  const std::string most = asStored(setting, {setting.most});
  switch (setting.kind) {
    case SettingKind::kYesNo:
      return Text::tr("Choose yes or no");
    case SettingKind::kWhole:
      return Text::tr("Enter a whole number from %1 to %2", least, most);
    case SettingKind::kNumber:
      return Text::tr("Enter a number from %1 to %2", least, most);
    case SettingKind::kSpeeds:
      return Text::tr("Write speeds from %1 to %2 like 0.5,1,1.5", least, most);
    case SettingKind::kChoice:
      return Text::tr("Choose one of %1", std::string(setting.choices));
    case SettingKind::kWords:
      break;
  }
  return Text::tr("Shorten it");
}

Text shownValue(Connection& connection, const CentreSetting& setting) {
  const std::string value = inForce(connection, setting);
  if (setting.kind == SettingKind::kYesNo) {
    return value == "yes" ? Text::tr("yes") : Text::tr("no");
  }
  return setting.shown.empty() ? Text(value) : Text(setting.shown, value);
}

bool inOrder(int warn_min, int lock_min) {
  return warn_min < lock_min;
}

void requireOrder(int warn_min, int lock_min) {
  if (!inOrder(warn_min, lock_min)) {
    refuseParameter(Text::tr("the warning would come after the lock"), Text::tr("idle lock"),
                    Text::tr("Warn at least one minute before"));
  }
}

}  // namespace

std::vector<std::string> choicesOf(const CentreSetting& setting) {
  std::istringstream in{std::string(setting.choices)};
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, ',');) {
    words.push_back(word);
  }
  return words;
}

std::string asStored(const CentreSetting& setting, const std::vector<double>& numbers) {
  if (setting.kind == SettingKind::kYesNo) {
    return numbers.front() != 0.0 ? "yes" : "no";
  }
  std::string text;
  for (const double number : numbers) {
    std::array<char, 32> digits{};
    const auto [end, fault] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    text += (text.empty() ? "" : ",") + std::string(digits.data(), end);
  }
  return text;
}

bool validCentreSetting(const CentreSetting& setting, const std::string& written) {
  return canonical(setting, written).has_value();
}

template <const CentreSetting& Setting>
SettingValue<Setting.kind> centreSetting(Connection& connection) {
  const std::string value = inForce(connection, Setting);
  if constexpr (Setting.kind == SettingKind::kWords || Setting.kind == SettingKind::kChoice) {
    return value;
  } else if constexpr (Setting.kind == SettingKind::kSpeeds) {
    return numbersIn(Setting, value);
  } else {
    return static_cast<SettingValue<Setting.kind>>(numbersIn(Setting, value).front());
  }
}

template bool centreSetting<kTwoPeople>(Connection&);
template double centreSetting<kMinimumWatched_percent>(Connection&);
template std::vector<double> centreSetting<kPlaybackSpeeds>(Connection&);
template double centreSetting<kDiscrepancy_points>(Connection&);
template bool centreSetting<kPanelWaits>(Connection&);
template int centreSetting<kSignMinutes>(Connection&);
template int centreSetting<kIdleWarn_min>(Connection&);
template int centreSetting<kIdleLock_min>(Connection&);
template int centreSetting<kCopyKeep_days>(Connection&);
template bool centreSetting<kGradedWithMouse>(Connection&);
template bool centreSetting<kSoundAtLimit>(Connection&);
template bool centreSetting<kKioskCodes>(Connection&);
template std::string centreSetting<kSecondFactor>(Connection&);
template std::string centreSetting<kBrowserAddress>(Connection&);
template std::string centreSetting<kMailServer>(Connection&);
template bool centreSetting<kLearningRecords>(Connection&);
template std::string centreSetting<kLearningRecordStore>(Connection&);
template std::string centreSetting<kStampAuthority>(Connection&);
template std::string centreSetting<kLanguage>(Connection&);
template std::string centreSetting<kCentreCode>(Connection&);

void changeCentreSetting(SessionContext& session, const CentreSetting& setting, const std::string& written) {
  session.require(Operation::kSettingsEdit);
  Transaction transaction(session.connection());
  if (&setting == &kTwoPeople && written == "no" && needsTwoPeople(session.connection()) &&
      !mayDropTheRule(session)) {
    requireSecondPerson(session, DutyAct::kOnePerson, std::string(setting.name));
  }
  keepCentreSetting(session, setting, written);
  transaction.commit();
}

void keepCentreSetting(SessionContext& session, const CentreSetting& setting, const std::string& written,
                       const std::string& reason) {
  const std::string name(setting.name);
  const std::optional<std::string> value = canonical(setting, written);
  if (!value) {
    refuseParameter(Text::tr("invalid value for this setting"), name, range(setting));
  }
  const std::string before = inForce(session.connection(), setting);
  if (before == *value) {
    return;
  }
  SettingRepository(session.connection()).set(setting.name, *value, session.now_us());
  noteSetting(session, setting.name, {{"value", before}}, {{"value", *value}}, reason);
}

void noteSetting(const SessionContext& session, std::string_view name, const nlohmann::json& before,
                 const nlohmann::json& after, const std::string& reason) {
  session.noteChange(AuditAction::kSettingChange, AuditObject::kSetting, std::string(name), before, after,
                     reason);
}

void setCentreSettingNamed(SessionContext& session, const std::string& name, const std::string& value) {
  session.require(Operation::kSettingsEdit);
  const auto* const found = std::find_if(kCentreSettings.begin(), kCentreSettings.end(),
                                         [&](const CentreSetting* one) { return one->name == name; });
  if (found == kCentreSettings.end()) {
    refuseParameter(Text::tr("there is no such setting"), name,
                    Text::tr("torsio settings list shows them all"));
  }
  if (!(*found)->setBy.empty()) {
    refuseParameter(Text::tr("this setting needs more than one value"), name,
                    Text::tr("Set it by: %1", (*found)->setBy));
  }
  Transaction transaction(session.connection());
  changeCentreSetting(session, **found, value);
  requireOrder(centreSetting<kIdleWarn_min>(session.connection()),
               centreSetting<kIdleLock_min>(session.connection()));
  transaction.commit();
}

std::string storedCentreSetting(SessionContext& session, const CentreSetting& setting) {
  session.require(Operation::kSettingsEdit);
  return inForce(session.connection(), setting);
}

std::vector<std::pair<Text, Text>> settingsInReport(Connection& connection) {
  std::vector<std::pair<Text, Text>> told;
  for (const CentreSetting* setting : kCentreSettings) {
    if (setting->inReport) {
      told.emplace_back(setting->label, shownValue(connection, *setting));
    }
  }
  return told;
}

void setCentreName(SessionContext& session, const std::string& name) {
  session.require(Operation::kSettingsEdit);
  if (name.empty()) {
    refuseParameter(Text::tr("the centre has no name"), Text::tr("centre"),
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
  session.noteChange(AuditAction::kCentreRename, AuditObject::kCentre, centre.id,
                     {{"name", before ? before->name : ""}}, {{"name", name}});
  transaction.commit();
}

std::string centreCode(Connection& connection) {
  const std::string stored = centreSetting<kCentreCode>(connection);
  if (!stored.empty()) {
    return stored;
  }
  const std::optional<Centre> centre = StudyRepository(connection).centre();
  return centre ? firstCentreCode(centre->name, centre->id) : std::string();
}

IdleLimits centreIdleLimits(Connection& connection) {
  const int warn_min = centreSetting<kIdleWarn_min>(connection);
  const int lock_min = centreSetting<kIdleLock_min>(connection);
  return inOrder(warn_min, lock_min)
             ? IdleLimits{.warn_us = warn_min * kMinute_us, .lock_us = lock_min * kMinute_us}
             : IdleLimits{};
}

void setCentreIdleLimits(SessionContext& session, int warn_min, int lock_min) {
  session.require(Operation::kSettingsEdit);
  requireOrder(warn_min, lock_min);
  Transaction transaction(session.connection());
  setCentreSetting<kIdleWarn_min>(session, warn_min);
  setCentreSetting<kIdleLock_min>(session, lock_min);
  transaction.commit();
}

}  // namespace torsio
