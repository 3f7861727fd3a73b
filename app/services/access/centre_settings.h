// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/services/access/idle_guard.h"
#include "app/services/access/session_context.h"
#include "assessment/domain/people/learning_event.h"
#include "sim/core/text.h"

namespace torsio {

class Connection;

/// Type and stored format of a setting: "yes" or "no"; a number; ascending playback speeds including 1
/// ("0.5,1,1.5"); a text; one of some words.
enum class SettingKind { kYesNo, kWhole, kNumber, kSpeeds, kWords, kChoice };

/// A setting of the centre, the same for all stations. Changing it requires kSettingsEdit and is audited with
/// the old and the new value. Stored names never change.
struct CentreSetting {
  std::string_view name;
  SettingKind kind;
  std::string_view initial;  ///< stored format; default if nothing or an invalid value is stored
  double least;              ///< range of a number and of each speed
  double most;
  Phrase label;
  Phrase shown{};            ///< pattern of a number: "%1 min"
  bool inReport = false;     ///< stated in each report
  std::string_view setBy{};  ///< the only function that sets it, if it makes no sense without other settings
  std::string_view choices{};  ///< of kChoice, in order, with commas between: "nobody,everybody"
};

namespace setting {

constexpr CentreSetting yesNo(std::string_view name, std::string_view initial, Phrase label,
                              bool inReport = false) {
  return {name, SettingKind::kYesNo, initial, 0, 1, label, {}, inReport};
}
constexpr CentreSetting whole(std::string_view name, std::string_view initial, double least, double most,
                              Phrase label, Phrase shown) {
  return {name, SettingKind::kWhole, initial, least, most, label, shown};
}
/// Stated in each report.
constexpr CentreSetting number(std::string_view name, std::string_view initial, double least, double most,
                               Phrase label, Phrase shown) {
  return {name, SettingKind::kNumber, initial, least, most, label, shown, true};
}
/// `longest`: characters.
constexpr CentreSetting words(std::string_view name, double longest, Phrase label, std::string_view setBy) {
  return {name, SettingKind::kWords, "", 0, longest, label, {}, false, setBy};
}

}  // namespace setting

inline constexpr CentreSetting kTwoPeople =
    setting::yesNo("two_people", "yes",
                   Text::tr("Two people for passwords, roles, erasing, restoring and the allocation"), true);
inline constexpr CentreSetting kMinimumWatched_percent =
    setting::number("review.minimum_watched_percent", "80", 0, 100,
                    Text::tr("Share of a recording that a rater must have watched"), Text::tr("%1 %"));
inline constexpr CentreSetting kPlaybackSpeeds{"review.speeds",
                                               SettingKind::kSpeeds,
                                               "1",
                                               0.1,
                                               4,
                                               Text::tr("Playback speeds that raters may use"),
                                               {},
                                               true};
inline constexpr CentreSetting kDiscrepancy_points =
    setting::number("review.alignment_points", "2", 0.1, 100,
                    Text::tr("Distance from the other raters' mean that calls for a discrepancy review"),
                    Text::tr("%1 points"));
inline constexpr CentreSetting kPanelWaits = setting::yesNo(
    "review.panel_waits", "yes",
    Text::tr("Raters see the panel's marks only after all their own sheets of the occasion"), true);
inline constexpr CentreSetting kSignMinutes = setting::whole(
    "sign_minutes", "15", 0, 60, Text::verbatim("Ask for the password again after (0: at every signature)"),
    Text::verbatim("%1 min"));
inline constexpr CentreSetting kIdleWarn_min = setting::whole(
    "idle_warn_minutes", "4", 1, 59, Text::verbatim("An idle station warns after"), Text::verbatim("%1 min"));
inline constexpr CentreSetting kIdleLock_min = setting::whole(
    "idle_lock_minutes", "5", 2, 60, Text::verbatim("An idle station locks after"), Text::verbatim("%1 min"));
inline constexpr CentreSetting kCopyKeep_days =
    setting::whole("copy_keep_days", "365", 1, 36'500, Text::verbatim("Copies of the record are kept for"),
                   Text::verbatim("%1 days"));
inline constexpr CentreSetting kGradedWithMouse =
    setting::yesNo("graded_with_mouse", "no", Text::verbatim("Runs with mouse and keyboard are graded"));
inline constexpr CentreSetting kSoundAtLimit =
    setting::yesNo("sound_at_limit", "no", Text::verbatim("A sound plays when a limit is reached"));
inline constexpr CentreSetting kKioskCodes =
    setting::yesNo("kiosk_codes", "no", Text::verbatim("Kiosks admit trainees by the code on their card"));
inline constexpr CentreSetting kSecondFactor{
    "second_factor",
    SettingKind::kChoice,
    "nobody",
    0,
    0,
    Text::verbatim("Who is asked for a second factor (nobody, administrators, everybody)"),
    {},
    false,
    {},
    "nobody,administrators,everybody"};
inline constexpr CentreSetting kBrowserAddress =
    setting::words("browser_address", 200, Text::verbatim("Address of the review desk in invitations"),
                   "torsio invite --address");
inline constexpr CentreSetting kMailServer =
    setting::words("mail_server", 4000, Text::verbatim("Server that sends reminders"), "Campaigns, Remind");
inline constexpr CentreSetting kLearningRecords{
    kLearningSetting, SettingKind::kYesNo, "no", 0, 1, Text::verbatim("Learning records are sent"), {}, false,
    "torsio xapi set"};
inline constexpr CentreSetting kLearningRecordStore = setting::words(
    "learning_record_store", 4000, Text::verbatim("Store of the learning records"), "torsio xapi set");
inline constexpr CentreSetting kStampAuthority = setting::words(
    "stamp_authority", 40'000, Text::verbatim("Authority that stamps checkpoints of the trail"),
    "torsio audit authority");
inline constexpr CentreSetting kLanguage =
    setting::words("language", 10, Text::verbatim("Language at sign-in"), "the first run");

inline constexpr CentreSetting kCentreCode =
    setting::words("centre.code", 8, Text::verbatim("Short code of the centre, as NJ in NJ/T-07"), "");

inline constexpr std::array kCentreSettings{&kTwoPeople,
                                            &kMinimumWatched_percent,
                                            &kPlaybackSpeeds,
                                            &kDiscrepancy_points,
                                            &kPanelWaits,
                                            &kSignMinutes,
                                            &kIdleWarn_min,
                                            &kIdleLock_min,
                                            &kCopyKeep_days,
                                            &kGradedWithMouse,
                                            &kSoundAtLimit,
                                            &kKioskCodes,
                                            &kSecondFactor,
                                            &kBrowserAddress,
                                            &kMailServer,
                                            &kLearningRecords,
                                            &kLearningRecordStore,
                                            &kStampAuthority,
                                            &kLanguage,
                                            &kCentreCode};

template <SettingKind Kind>
using SettingValue =
    std::tuple_element_t<static_cast<std::size_t>(Kind),
                         std::tuple<bool, int, double, std::vector<double>, std::string, std::string>>;

/// Returns the value in use. Requires no right: the shell reads some settings before anybody signs in, and
/// services read their own. Instantiated for each setting in centre_settings.cpp, so that .ci/unreachable
/// finds settings that nobody reads.
template <const CentreSetting& Setting>
[[nodiscard]] SettingValue<Setting.kind> centreSetting(Connection& connection);

/// Changes a setting to `written`, in the stored format; does nothing if the value is already in use.
/// Audited. kSettingsEdit. Throws Error{kBadParameter} for an invalid value; SecondPersonNeeded.
void changeCentreSetting(SessionContext& session, const CentreSetting& setting, const std::string& written);
/// Like changeCentreSetting(), without a second person, for a service that has checked its own right, inside
/// its transaction.
void keepCentreSetting(SessionContext& session, const CentreSetting& setting, const std::string& written,
                       const std::string& reason = {});
/// Returns the words of a kChoice, in order.
[[nodiscard]] std::vector<std::string> choicesOf(const CentreSetting& setting);
/// Formats numbers for storage; 1 for "yes", 0 for "no".
[[nodiscard]] std::string asStored(const CentreSetting& setting, const std::vector<double>& numbers);
/// Returns whether changeCentreSetting() accepts a value.
[[nodiscard]] bool validCentreSetting(const CentreSetting& setting, const std::string& written);
/// Like changeCentreSetting().
template <const CentreSetting& Setting>
void setCentreSetting(SessionContext& session,
                      const std::type_identity_t<SettingValue<Setting.kind>>& value) {
  if constexpr (Setting.kind == SettingKind::kWords || Setting.kind == SettingKind::kChoice) {
    changeCentreSetting(session, Setting, value);
  } else if constexpr (Setting.kind == SettingKind::kSpeeds) {
    changeCentreSetting(session, Setting, asStored(Setting, value));
  } else {
    changeCentreSetting(session, Setting, asStored(Setting, {static_cast<double>(value)}));
  }
}

/// Audits a setting stored outside the record (a file of this station, the open review desk). For a service,
/// inside its transaction.
void noteSetting(const SessionContext& session, std::string_view name, const nlohmann::json& before,
                 const nlohmann::json& after, const std::string& reason = {});

/// Sets a setting by name, for the command line; only those that make sense alone. kSettingsEdit. Throws
/// Error{kBadParameter} for an unknown name and for what changeCentreSetting() rejects.
void setCentreSettingNamed(SessionContext& session, const std::string& name, const std::string& value);
/// Returns the stored or default value. kSettingsEdit.
[[nodiscard]] std::string storedCentreSetting(SessionContext& session, const CentreSetting& setting);
/// Returns name and value of each setting stated in reports.
[[nodiscard]] std::vector<std::pair<Text, Text>> settingsInReport(Connection& connection);

/// Sets the name shown at sign-in and on new transcripts and reports. Audited. kSettingsEdit. Throws
/// Error{kBadParameter} for an empty name.
void setCentreName(SessionContext& session, const std::string& name);

/// Returns the code by which the centre is told from others: "NJ". Without one in the settings, the one that
/// its name and id suggest; without a centre empty.
[[nodiscard]] std::string centreCode(Connection& connection);

/// Returns the idle times after which the window warns and locks, for every station of the centre. Called by
/// the shell before anybody signs in: without permission.
[[nodiscard]] IdleLimits centreIdleLimits(Connection& connection);
/// Audited. kSettingsEdit. Throws Error{kBadParameter} unless the warning comes before the lock and both are
/// within their ranges.
void setCentreIdleLimits(SessionContext& session, int warn_min, int lock_min);

}  // namespace torsio
