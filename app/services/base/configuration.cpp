// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/configuration.h"

#include <algorithm>
#include <array>

#include <QByteArray>
#include <QtGlobal>

#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr const char* kOwnFile = "TORSIO_CONFIG";
constexpr const char* kDefaultFile = "/etc/torsio/torsio.conf";
constexpr const char* kPasswords = "PGPASSFILE";

Configuration& ofThisComputer() {
  static Configuration one;
  return one;
}

}  // namespace

Configuration Configuration::read(const std::filesystem::path& file) {
  std::array<FileKey, kConfiguredKeys.size()> keys{};
  std::transform(kConfiguredKeys.begin(), kConfiguredKeys.end(), keys.begin(), [](const ConfiguredKey* key) {
    return FileKey{key->name, key->kind};
  });
  Configuration read;
  read.lines_ = KeyFile::read(file, keys);
  return read;
}

std::filesystem::path configurationFile() {
  if (qEnvironmentVariableIsSet(kOwnFile)) {
    return qgetenv(kOwnFile).toStdString();
  }
  std::error_code missing;
  return std::filesystem::exists(kDefaultFile, missing) ? kDefaultFile : "";
}

void loadConfiguration() {
  const std::filesystem::path file = configurationFile();
  ofThisComputer() = file.empty() ? Configuration() : Configuration::read(file);
  if (const auto passwords = configured(kConfiguredPassfile);
      passwords && !qEnvironmentVariableIsSet(kPasswords)) {
    qputenv(kPasswords, QByteArray::fromStdString(*passwords));
  }
}

const Configuration& configuration() noexcept {
  return ofThisComputer();
}

void requireNotConfigured(const ConfiguredKey& key, Text what) {
  if (const Text place = configuration().placeOf(key); !place.empty()) {
    throw Error(ErrorCode::kUsage, Text::tr("%1 is set for this computer", what), place,
                Text::tr("Ask whoever looks after this computer to change it there"));
  }
}

}  // namespace torsio
