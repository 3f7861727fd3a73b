// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/key_file.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "app/services/base/nearest_name.h"
#include "sim/core/byte_order_mark.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

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
    case ConfiguredKind::kLogLevel:
      return value == "error" || value == "warning" || value == "info"
                 ? Text()
                 : either("error, warning, info", "debug");
    case ConfiguredKind::kPath:
      return std::filesystem::path(value).is_absolute() ? Text()
                                                        : Text(Text::tr("a path that begins with /"));
    case ConfiguredKind::kWords:
      break;
  }
  return {};
}

Text lineOf(const std::filesystem::path& file, int number) {
  return Text::tr("%1, line %2", file.string(), number);
}

[[noreturn]] void refuseLine(const std::filesystem::path& file, int number, Text what, Text remedy) {
  throw Error(ErrorCode::kBadData, std::move(what), lineOf(file, number), std::move(remedy));
}

Text remedyForKey(const std::string& name, std::span<const FileKey> keys) {
  std::vector<std::string> names;
  for (const FileKey& key : keys) {
    names.emplace_back(key.name);
  }
  const std::string nearest = nearestOf(names, name);
  return nearest.empty() ? Text(Text::tr("Write one of: %1", joined(names)))
                         : Text(Text::tr("Did you mean %1?", nearest));
}

}  // namespace

KeyFile KeyFile::read(const std::filesystem::path& file, std::span<const FileKey> keys) {
  KeyFile read;
  read.file_ = file;
  if (std::error_code missing; std::filesystem::is_fifo(file, missing)) {  // would be waited for
    throw Error(ErrorCode::kFileUnreadable, Text::tr("%1 cannot be read", file.string()), "",
                Text::tr("Check that the file exists and that this account may read it"));
  }
  std::istringstream text{std::string(withoutByteOrderMark(readFile(file)))};
  std::string whole;
  for (int number = 1; std::getline(text, whole); ++number) {
    if (const std::string line = withoutBlanks(withoutComment(whole)); !line.empty()) {
      read.add(line, number, keys);
    }
  }
  return read;
}

void KeyFile::add(std::string_view line, int number, std::span<const FileKey> keys) {
  const std::size_t equals = line.find('=');
  const std::string name = withoutBlanks(line.substr(0, equals));
  if (equals == std::string_view::npos) {
    refuseLine(file_, number, Text::tr("this is not \"key = value\": %1", std::string(line)),
               Text::tr("Write the line as key = value, or put # before it"));
  }
  const auto key =
      std::find_if(keys.begin(), keys.end(), [&name](const FileKey& one) { return one.name == name; });
  if (key == keys.end()) {
    refuseLine(file_, number, Text::tr("\"%1\" is no key of this file", name), remedyForKey(name, keys));
  }
  if (const KeyLine* twin = find(key->name); twin != nullptr && !key->repeats) {
    refuseLine(file_, number, Text::tr("\"%1\" is already set in line %2", name, twin->number),
               Text::tr("Remove one of the two lines"));
  }
  std::string value = withoutBlanks(line.substr(equals + 1));
  if (value.empty()) {
    refuseLine(file_, number, Text::tr("\"%1\" has no value", name),
               Text::tr("Write the value, or put # before the line"));
  }
  if (const Text wanted = wantedInsteadOf(value, key->kind); !wanted.empty()) {
    refuseLine(file_, number, Text::tr("\"%1\" cannot be %2", name, value), Text::tr("Write %1", wanted));
  }
  lines_.push_back({key->name, std::move(value), number});
}

const KeyLine* KeyFile::find(std::string_view key) const noexcept {
  const auto found =
      std::find_if(lines_.begin(), lines_.end(), [&key](const KeyLine& line) { return line.key == key; });
  return found == lines_.end() ? nullptr : &*found;
}

std::optional<std::string> KeyFile::at(std::string_view key) const {
  const KeyLine* line = find(key);
  return line == nullptr ? std::nullopt : std::optional(line->value);
}

std::vector<KeyLine> KeyFile::every(std::string_view key) const {
  std::vector<KeyLine> all;
  std::copy_if(lines_.begin(), lines_.end(), std::back_inserter(all),
               [&key](const KeyLine& line) { return line.key == key; });
  return all;
}

Text KeyFile::placeOf(std::string_view key) const {
  const KeyLine* line = find(key);
  return line == nullptr ? Text() : placeOf(*line);
}

Text KeyFile::placeOf(const KeyLine& line) const {
  return lineOf(file_, line.number);
}

}  // namespace torsio
