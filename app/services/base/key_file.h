// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// What may stand behind a key.
enum class ConfiguredKind : std::uint8_t {
  kWords,         ///< anything but nothing
  kYesNo,         ///< "yes" or "no"
  kLanguageCode,  ///< "en" or "zh_CN"
  kThemeName,     ///< "light" or "dark"
  kPath,          ///< an absolute path
  kLogLevel,      ///< "error", "warning", "info" or "debug"
};

/// A key that a file may set.
struct FileKey {
  std::string_view name;
  ConfiguredKind kind = ConfiguredKind::kWords;
  bool repeats = false;  ///< may stand in several lines
};

struct KeyLine {
  std::string_view key;  ///< of the FileKey
  std::string value;
  int number = 0;  ///< from 1
};

/// A file of lines "key = value" in UTF-8; what follows # is a comment; a key stands once unless it repeats.
/// Immutable.
class KeyFile {
 public:
  /// An empty one.
  KeyFile() = default;
  /// The names of `keys` outlive it. Throws Error{kFileMissing, kFileUnreadable}; Error{kBadData} with the
  /// file and the line of the first fault, and what to write.
  [[nodiscard]] static KeyFile read(const std::filesystem::path& file, std::span<const FileKey> keys);

  /// Returns what stands behind the key; empty: nothing.
  [[nodiscard]] std::optional<std::string> at(std::string_view key) const;
  /// Returns all lines of a key.
  [[nodiscard]] std::vector<KeyLine> every(std::string_view key) const;
  /// Returns "FILE, line N" of a key that is set, else an empty text.
  [[nodiscard]] Text placeOf(std::string_view key) const;
  [[nodiscard]] Text placeOf(const KeyLine& line) const;
  /// Empty: there is none.
  [[nodiscard]] const std::filesystem::path& file() const noexcept { return file_; }

 private:
  [[nodiscard]] const KeyLine* find(std::string_view key) const noexcept;
  void add(std::string_view line, int number, std::span<const FileKey> keys);
  std::filesystem::path file_;
  std::vector<KeyLine> lines_;
};

}  // namespace torsio
