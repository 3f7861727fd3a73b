// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "app/services/base/key_file.h"
#include "sim/core/text.h"

namespace torsio {

/// Whether people may choose otherwise at the station.
enum class ConfiguredForce : std::uint8_t {
  kRules,    ///< no: whoever looks after the computer decides
  kInitial,  ///< yes: holds until somebody chooses
};

/// A key of the configuration of a computer. The words of an option on the command line outrank both.
struct ConfiguredKey {
  std::string_view name;
  ConfiguredKind kind;
  ConfiguredForce force;
  Phrase label;
};

inline constexpr ConfiguredKey kConfiguredRecord{
    "record", ConfiguredKind::kWords, ConfiguredForce::kRules,
    Text::verbatim("Record: a file, or postgresql://user@server/database?sslmode=verify-full")};
inline constexpr ConfiguredKey kConfiguredPassfile{"passfile", ConfiguredKind::kPath, ConfiguredForce::kRules,
                                                   Text::verbatim("File with the password for the server")};
inline constexpr ConfiguredKey kConfiguredStation{"station", ConfiguredKind::kWords, ConfiguredForce::kRules,
                                                  Text::verbatim("Name of the station")};
inline constexpr ConfiguredKey kConfiguredKiosk{
    "kiosk", ConfiguredKind::kYesNo, ConfiguredForce::kRules,
    Text::verbatim("The window fills the screen of a training station")};
inline constexpr ConfiguredKey kConfiguredDevice{
    "device", ConfiguredKind::kWords, ConfiguredForce::kInitial,
    Text::verbatim("Haptic device, as torsio device list names it")};
inline constexpr ConfiguredKey kConfiguredLanguage{"language", ConfiguredKind::kLanguageCode,
                                                   ConfiguredForce::kInitial,
                                                   Text::verbatim("Language: en or zh_CN")};
inline constexpr ConfiguredKey kConfiguredTheme{
    "theme", ConfiguredKind::kThemeName, ConfiguredForce::kInitial, Text::verbatim("Colours: light or dark")};
inline constexpr ConfiguredKey kConfiguredListen{
    "serve.listen", ConfiguredKind::kWords, ConfiguredForce::kRules,
    Text::verbatim("Review desk: address and port at which it listens")};
inline constexpr ConfiguredKey kConfiguredCertificate{
    "serve.certificate", ConfiguredKind::kPath, ConfiguredForce::kRules,
    Text::verbatim("Review desk: PEM file of the certificate with its chain")};
inline constexpr ConfiguredKey kConfiguredCertificateKey{"serve.key", ConfiguredKind::kPath,
                                                         ConfiguredForce::kRules,
                                                         Text::verbatim("Review desk: PEM file of the key")};
inline constexpr ConfiguredKey kConfiguredPublicUrl{
    "serve.public-url", ConfiguredKind::kWords, ConfiguredForce::kRules,
    Text::verbatim("Review desk: address for browsers through a proxy")};

inline constexpr ConfiguredKey kConfiguredMetrics{
    "serve.metrics", ConfiguredKind::kYesNo, ConfiguredForce::kRules,
    Text::verbatim("Review desk: everybody who reaches it may read /metrics")};
inline constexpr ConfiguredKey kConfiguredBackupFolder{"backup.folder", ConfiguredKind::kPath,
                                                       ConfiguredForce::kRules,
                                                       Text::verbatim("Backups: folder into which they go")};
inline constexpr ConfiguredKey kConfiguredBackupKeep{
    "backup.keep", ConfiguredKind::kWords, ConfiguredForce::kRules,
    Text::verbatim("Backups: newest of so many days, weeks and months that stay; 7,5,12")};

inline constexpr ConfiguredKey kConfiguredLogLevel{
    "log.level", ConfiguredKind::kLogLevel, ConfiguredForce::kRules,
    Text::verbatim("Log: the least grave lines that are written: error, warning, info or debug")};
inline constexpr ConfiguredKey kConfiguredLogFile{
    "log.file", ConfiguredKind::kPath, ConfiguredForce::kRules,
    Text::verbatim("Log: file that gets it, instead of the journal or standard error")};

inline constexpr std::array kConfiguredKeys{
    &kConfiguredRecord,       &kConfiguredPassfile,       &kConfiguredStation,   &kConfiguredKiosk,
    &kConfiguredDevice,       &kConfiguredLanguage,       &kConfiguredTheme,     &kConfiguredListen,
    &kConfiguredCertificate,  &kConfiguredCertificateKey, &kConfiguredPublicUrl, &kConfiguredMetrics,
    &kConfiguredBackupFolder, &kConfiguredBackupKeep,     &kConfiguredLogLevel,  &kConfiguredLogFile};

/// The configuration of a computer: one file that its window, commands and review desk read at their start.
/// Looks that a user chose are not in it but in the user's own settings. Immutable.
class Configuration {
 public:
  /// A computer without a configuration.
  Configuration() = default;
  /// Throws like KeyFile::read().
  [[nodiscard]] static Configuration read(const std::filesystem::path& file);

  /// Returns what stands behind the key; empty: nothing.
  [[nodiscard]] std::optional<std::string> at(const ConfiguredKey& key) const { return lines_.at(key.name); }
  /// Returns "FILE, line N" of a key that is set.
  [[nodiscard]] Text placeOf(const ConfiguredKey& key) const { return lines_.placeOf(key.name); }
  /// Empty: there is none.
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return lines_.file(); }

 private:
  KeyFile lines_;
};

/// Returns the file: $TORSIO_CONFIG if set (empty: none), else /etc/torsio/torsio.conf if that exists.
[[nodiscard]] std::filesystem::path configurationFile();

/// Reads the configuration of this computer for configuration(), and tells the PostgreSQL client where the
/// passwords are, unless $PGPASSFILE does. Call once, before other threads start. Throws like
/// Configuration::read().
void loadConfiguration();

/// Returns what loadConfiguration() read; without it, an empty one. Any thread.
[[nodiscard]] const Configuration& configuration() noexcept;

/// Returns what this computer's configuration says of a key; empty: nothing.
[[nodiscard]] inline std::optional<std::string> configured(const ConfiguredKey& key) {
  return configuration().at(key);
}

/// Throws Error{kUsage} that says where a key is set, if it is: nobody can choose `what` at the station.
void requireNotConfigured(const ConfiguredKey& key, Text what);

}  // namespace torsio
