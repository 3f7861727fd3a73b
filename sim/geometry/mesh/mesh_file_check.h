// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// Walks over the lines of a text, with or without a last line end.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}

  /// Returns the next line without its end; nothing after the last.
  [[nodiscard]] std::optional<std::string_view> next();
  /// Returns the number of the line returned last, from 1.
  [[nodiscard]] std::uint64_t number() const noexcept { return number_; }
  /// Returns the text after the line returned last.
  [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

 private:
  std::string_view rest_;
  std::uint64_t number_ = 0;
};

/// Splits a line into its words between white space. `words` is cleared first: one vector serves a whole
/// file.
void splitWords(std::string_view line, std::vector<std::string_view>& words);

/// Reads a non-negative integer of digits only; above 10^12 the result is 10^12, so that products cannot
/// overflow.
[[nodiscard]] std::optional<std::uint64_t> parseCount(std::string_view word);

/// Tells whether a word is a number as C reads one, including nan and inf.
[[nodiscard]] bool isNumber(std::string_view word);

/// Returns a text with A to Z in small letters.
[[nodiscard]] std::string smallLetters(std::string_view text);

/// Returns the ending of a file's name without its dot, in small letters.
[[nodiscard]] std::string lowerExtension(const std::filesystem::path& file);

/// Returns the first 64 kB of a file; empty when it cannot be read.
[[nodiscard]] std::string headOf(const std::filesystem::path& file);

/// Tells from the first bytes of an STL file of `size` bytes whether it is text.
[[nodiscard]] bool isTextStl(std::string_view head, std::uint64_t size);

/// Checks a mesh file before a library reads it. The content must match `extension` (lower case, without
/// dot) and the counts that a header declares must fit in the file, because importers reserve memory for
/// what a header promises. PLY and OFF files are walked to the end: assimp 5.2 crashes on damaged ones.
/// Throws Error{kFileUnreadable} (M02, M04, M05) or Error{kBadMesh} (M06, M08).
void requirePlausibleFile(const std::filesystem::path& file, std::string_view extension);

/// Checks a whole PLY file; `where` names it. Throws as requirePlausibleFile.
void requirePlausiblePly(std::string_view bytes, const std::string& where);
/// Checks a whole OFF file; `where` names it. Throws as requirePlausibleFile.
void requirePlausibleOff(std::string_view bytes, const std::string& where);

/// Checks a whole GLB or glTF 2 file (`extension`: "glb" or "gltf"): everything that its JSON promises lies
/// in its buffers, and what parts of meshes, pictures and animations copy of them is at most 16 times the
/// file. `where` names it. Throws as requirePlausibleFile.
void requirePlausibleGltf(std::string_view bytes, std::string_view extension, const std::string& where);

/// Checks the first bytes of a file of `size` bytes: STL, GLB, glTF, COLLADA, OBJ.
void requirePlausibleHead(std::string_view head, std::uint64_t size, std::string_view extension,
                          const std::string& where);

/// Refuses a file whose content is not of the format.
[[noreturn]] void refuseFormat(const std::string& where, std::string_view format, const Text& why);
/// Refuses a file that is shorter than its header promises.
[[noreturn]] void refuseShort(const std::string& where, const std::string& promised, std::uint64_t size);
/// Refuses a file with a broken line or row.
[[noreturn]] void refuseRow(const std::string& where, const std::string& row, const Text& why);
/// Refuses a file in which a face uses a vertex that is not there.
[[noreturn]] void refuseIndex(const std::string& where, const std::string& row, std::int64_t index,
                              std::uint64_t vertices);

}  // namespace torsio
