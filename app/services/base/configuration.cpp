// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/configuration.h"

#include <algorithm>
#include <sstream>

#include <QtGlobal>

#include "app/services/base/nearest_name.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

constexpr const char* kOwnFile = "TORSIO_CONFIG";
constexpr const char* kDefaultFile = "/etc/torsio/torsio.conf";
constexpr const char* kPasswords = "PGPASSFILE";

std::string withoutBlanks(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  return begin == std::string_view::npos
             ? std::string()
             : std::string(text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1));
}

/// Cuts a comment off. Inside a word # is a letter, as in an address.
std::string_view withoutComment(std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) {
      return line.substr(0, i);
    }
  }
  return line;
}

/// What may stand behind a key, as words for people; empty: the value is good.
Text wantedInsteadOf(const std::string& value, ConfiguredKind kind) {
  const auto either = [&value](const char* a, const char* b) {
    return value == a || value == b ? Text() : Text(Text::tr("%1 or %2", a, b));
  };
  switch (kind) {
    case ConfiguredKind::kYesNo:
      return either("yes", "no");
    case ConfiguredKind::kLanguageCode:
      return either("en", "zh_CN");
    case ConfiguredKind::kThemeName:
      return either("light", "dark");
    case ConfiguredKind::kPath:
      return std::filesystem::path(value).is_absolute() ? Text()
                                                        : Text(Text::tr("a path that begins with /"));
    case ConfiguredKind::kWords:
      break;
  }
  return {};
}

std::vector<std::string> namesOfKeys() {
  std::vector<std::string> names;
  for (const ConfiguredKey* key : kConfiguredKeys) {
    names.emplace_back(key->name);
  }
  return names;
}

Text lineOf(const std::filesystem::path& file, int number) {
  return Text::tr("%1, line %2", file.string(), number);
}

[[noreturn]] void refuseLine(const std::filesystem::path& file, int number, Text what, Text remedy) {
  throw Error(ErrorCode::kBadData, std::move(what), lineOf(file, number), std::move(remedy));
}

Text remedyForKey(const std::string& name) {
  const std::string nearest = nearestOf(namesOfKeys(), name);
  return nearest.empty() ? Text(Text::tr("Write one of: %1", joined(namesOfKeys())))
                         : Text(Text::tr("Did you mean %1?", nearest));
}

Configuration& ofThisComputer() {
  static Configuration one;
  return one;
}

}  // namespace

Configuration Configuration::read(const std::filesystem::path& file) {
  Configuration read;
  read.file_ = file;
  if (std::error_code missing; std::filesystem::is_fifo(file, missing)) {  // would be waited for
    throw Error(ErrorCode::kFileUnreadable, Text::tr("%1 cannot be read", file.string()), "",
                Text::tr("Check that the file exists and that this account may read it"));
  }
  std::istringstream text{std::string(withoutByteOrderMark(readFile(file)))};
  std::string whole;
  for (int number = 1; std::getline(text, whole); ++number) {
    const std::string line = withoutBlanks(withoutComment(whole));
    if (line.empty()) {
      continue;
    }
    const std::size_t equals = line.find('=');
    const std::string name = withoutBlanks(line.substr(0, equals));
    if (equals == std::string::npos) {
      refuseLine(file, number, Text::tr("this is not \"key = value\": %1", line),
                 Text::tr("Write the line as key = value, or put # before it"));
    }
    const auto key = std::find_if(kConfiguredKeys.begin(), kConfiguredKeys.end(),
                                  [&name](const ConfiguredKey* one) { return one->name == name; });
    if (key == kConfiguredKeys.end()) {
      refuseLine(file, number, Text::tr("\"%1\" is no key of the configuration", name), remedyForKey(name));
    }
    if (const Line* twin = read.find(**key)) {
      refuseLine(file, number, Text::tr("\"%1\" is already set in line %2", name, twin->number),
                 Text::tr("Remove one of the two lines"));
    }
    std::string value = withoutBlanks(line.substr(equals + 1));
    if (value.empty()) {
      refuseLine(file, number, Text::tr("\"%1\" has no value", name),
                 Text::tr("Write the value, or put # before the line"));
    }
    if (const Text wanted = wantedInsteadOf(value, (*key)->kind); !wanted.empty()) {
      refuseLine(file, number, Text::tr("\"%1\" cannot be %2", name, value), Text::tr("Write %1", wanted));
    }
    read.lines_.push_back({(*key)->name, std::move(value), number});
  }
  return read;
}

const Configuration::Line* Configuration::find(const ConfiguredKey& key) const noexcept {
  const auto found =
      std::find_if(lines_.begin(), lines_.end(), [&key](const Line& line) { return line.key == key.name; });
  return found == lines_.end() ? nullptr : &*found;
}

std::optional<std::string> Configuration::at(const ConfiguredKey& key) const {
  const Line* line = find(key);
  return line == nullptr ? std::nullopt : std::optional(line->value);
}

Text Configuration::placeOf(const ConfiguredKey& key) const {
  const Line* line = find(key);
  return line == nullptr ? Text() : lineOf(file_, line->number);
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
