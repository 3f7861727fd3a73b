// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_file_check.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>
#include <vector>

#include "sim/core/byte_order_mark.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

constexpr std::size_t kHeadBytes = 65536;

std::string_view firstWord(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) {
    return {};
  }
  return text.substr(start, text.find_first_of(" \t\r\n", start) - start);
}

std::uint32_t littleEndian32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return value;
}

constexpr std::size_t kStlHeader = 84;

std::uint64_t stlFacets(std::string_view head) {
  return head.size() >= kStlHeader ? littleEndian32(head.substr(80, 4)) : 0;
}

bool isExactStl(std::string_view head, std::uint64_t size) {
  constexpr std::uint64_t kFacet = 50;
  return head.size() >= kStlHeader && kStlHeader + stlFacets(head) * kFacet == size;
}

void checkStl(std::string_view head, std::uint64_t size, const std::string& where) {
  constexpr std::size_t kHeader = kStlHeader;
  constexpr std::uint64_t kFacet = 50;
  const std::uint64_t facets = stlFacets(head);
  if (isExactStl(head, size) || isTextStl(head, size)) {
    return;
  }
  if (head.size() < kHeader) {
    refuseFormat(where, "STL", Text::tr("neither text nor long enough to be binary"));
  }
  if (kHeader + facets * kFacet > size) {
    refuseShort(where, std::to_string(facets) + " facets", size);
  }
}

void checkGlb(std::string_view head, std::uint64_t size, const std::string& where) {
  constexpr std::size_t kHeader = 12;
  if (head.size() < kHeader || !head.starts_with("glTF")) {
    refuseFormat(where, "GLB", Text::tr("the magic is missing"));
  }
  const std::uint64_t declared = littleEndian32(head.substr(8, 4));
  if (declared > size) {
    refuseShort(where, std::to_string(declared) + " bytes", size);
  }
}

// OBJ, glTF and COLLADA are text; a zero byte means UTF-16 or something binary.
void checkText(std::string_view head, std::string_view format, std::string_view mark,
               const std::string& where) {
  if (head.find('\0') != std::string_view::npos) {
    refuseFormat(where, format, Text::tr("it is not UTF-8 text"));
  }
  if (!firstWord(withoutByteOrderMark(head)).starts_with(mark)) {
    refuseFormat(where, format, Text::tr("it does not begin with %1", std::string(mark)));
  }
}

void checkObj(std::string_view head, const std::string& where) {
  checkText(head, "OBJ", "", where);
  TextLines lines(head);
  while (const auto line = lines.next()) {
    if (firstWord(*line) == "v") {
      return;
    }
  }
  refuseFormat(where, "OBJ", Text::tr("no line of its first 64 kB begins with \"v\""));
}

using Words = std::vector<std::string_view>;

// The next line that holds more than a comment; nothing at the end.
bool nextWords(TextLines& lines, Words& words) {
  while (const auto line = lines.next()) {
    splitWords(line->substr(0, line->find('#')), words);
    if (!words.empty()) {
      return true;
    }
  }
  return false;
}

std::string lineName(const TextLines& lines) {
  return "line " + std::to_string(lines.number());
}

void checkFace(const Words& words, std::uint64_t vertices, const TextLines& lines, const std::string& where) {
  const auto corners = parseCount(words[0]);
  if (!corners || *corners < 1 || *corners >= words.size()) {
    refuseRow(where, lineName(lines), Text::tr("a face needs its number of corners and as many indices"));
  }
  for (std::size_t k = 1; k <= *corners; ++k) {
    const auto index = parseCount(words[k]);
    if (!index) {
      refuseRow(where, lineName(lines), Text::tr("an index is not a whole number"));
    }
    if (*index >= vertices) {
      refuseIndex(where, lineName(lines), static_cast<std::int64_t>(*index), vertices);
    }
  }
}

}  // namespace

std::optional<std::string_view> TextLines::next() {
  if (rest_.empty()) {
    return std::nullopt;
  }
  const std::size_t end = rest_.find('\n');
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++number_;
  return line;
}

void splitWords(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  std::size_t i = 0;
  while (true) {
    while (i < line.size() && isSpace(line[i])) {
      ++i;
    }
    if (i == line.size()) {
      return;
    }
    const std::size_t start = i;
    while (i < line.size() && !isSpace(line[i])) {
      ++i;
    }
    words.push_back(line.substr(start, i - start));
  }
}

std::optional<std::uint64_t> parseCount(std::string_view word) {
  constexpr std::uint64_t kMost = 1'000'000'000'000ULL;
  std::uint64_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') {
      return std::nullopt;
    }
    value = value * 10 + static_cast<std::uint64_t>(c - '0');
    if (value > kMost) {
      value = kMost;
    }
  }
  if (word.empty()) {
    return std::nullopt;
  }
  return value;
}

bool isNumber(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool outOfRange = failed == std::errc::result_out_of_range;
  return (failed == std::errc() || outOfRange) && end == word.data() + word.size();
}

void refuseFormat(const std::string& where, std::string_view format, const Text& why) {
  throw Error(ErrorCode::kFileUnreadable,
              Text::tr("M02 not a file of the format %1: %2", std::string(format), why), where,
              Text::tr("Give the file the extension of its format, or export it again"));
}

void refuseShort(const std::string& where, const std::string& promised, std::uint64_t size) {
  throw Error(ErrorCode::kFileUnreadable,
              Text::tr("M04 the header promises %1, but the file has %2 {byte|bytes}", promised,
                       std::to_string(size)),
              where, Text::tr("The file is damaged or cut off: export it again"));
}

void refuseRow(const std::string& where, const std::string& row, const Text& why) {
  throw Error(ErrorCode::kFileUnreadable, Text::tr("M05 %1 is broken: %2", row, why), where,
              Text::tr("Export the mesh again"));
}

void refuseIndex(const std::string& where, const std::string& row, std::int64_t index,
                 std::uint64_t vertices) {
  throw Error(ErrorCode::kBadMesh,
              Text::tr("M08 %1 uses vertex %2 of %3", row, std::to_string(index), std::to_string(vertices)),
              where, Text::tr("Export the mesh again"));
}

std::string smallLetters(std::string_view text) {
  std::string small(text);
  for (char& c : small) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return small;
}

bool isTextStl(std::string_view head, std::uint64_t size) {
  // Many binary files begin with the word "solid" too: the length decides.
  return !isExactStl(head, size) && head.find('\0') == std::string_view::npos &&
         smallLetters(firstWord(withoutByteOrderMark(head))) == "solid";
}

std::string lowerExtension(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return smallLetters(std::string_view(extension).substr(extension.empty() ? 0 : 1));
}

std::string headOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(kHeadBytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return in.bad() ? std::string() : head;
}

void requirePlausibleHead(std::string_view head, std::uint64_t size, std::string_view extension,
                          const std::string& where) {
  if (extension == "stl") {
    checkStl(head, size, where);
  } else if (extension == "glb") {
    checkGlb(head, size, where);
  } else if (extension == "gltf") {
    checkText(head, "glTF", "{", where);
  } else if (extension == "dae") {
    checkText(head, "COLLADA", "<", where);
  } else {
    checkObj(head, where);
  }
}

void requirePlausibleFile(const std::filesystem::path& file, std::string_view extension) {
  if (extension == "ply") {
    return requirePlausiblePly(readFile(file), file.string());
  }
  if (extension == "off") {
    return requirePlausibleOff(readFile(file), file.string());
  }
  const std::string head = headOf(file);
  std::error_code failed;
  const auto size = std::filesystem::file_size(file, failed);
  if (failed || head.empty()) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("M01 cannot be read"), file.string(),
                Text::tr("Check that it is a file you may read"));
  }
  requirePlausibleHead(head, size, extension, file.string());
  if (extension == "glb" || extension == "gltf") {
    requirePlausibleGltf(readFile(file), extension, file.string());
  }
}

void requirePlausibleOff(std::string_view bytes, const std::string& where) {
  TextLines lines(bytes);
  Words words;
  if (bytes.find('\0') != std::string_view::npos) {
    refuseFormat(where, "OFF", Text::tr("it is not text"));
  }
  if (!nextWords(lines, words) || (words[0] != "OFF" && words[0] != "COFF")) {
    refuseFormat(where, "OFF", Text::tr("it does not begin with OFF or COFF"));
  }
  words.erase(words.begin());
  if (words.empty()) {
    nextWords(lines, words);
  }
  const auto vertices = !words.empty() ? parseCount(words[0]) : std::nullopt;
  const auto faces = words.size() > 1 ? parseCount(words[1]) : std::nullopt;
  if (!vertices || !faces) {
    refuseFormat(where, "OFF", Text::tr("no counts follow the first word"));
  }
  constexpr std::uint64_t kLeastVertex = 6;  // "0 0 0\n"
  constexpr std::uint64_t kLeastFace = 8;    // "3 0 1 2\n"
  if (*vertices * kLeastVertex + *faces * kLeastFace > bytes.size() + 1) {
    refuseShort(where, std::to_string(*vertices) + " vertices and " + std::to_string(*faces) + " faces",
                bytes.size());
  }
  for (std::uint64_t v = 0; v < *vertices; ++v) {
    if (!nextWords(lines, words)) {
      refuseShort(where, std::to_string(*vertices) + " vertices", bytes.size());
    }
    if (words.size() < 3 || !std::all_of(words.begin(), words.begin() + 3, isNumber)) {
      refuseRow(where, lineName(lines), Text::tr("a vertex needs three numbers"));
    }
  }
  for (std::uint64_t f = 0; f < *faces; ++f) {
    if (!nextWords(lines, words)) {
      refuseShort(where, std::to_string(*faces) + " faces", bytes.size());
    }
    checkFace(words, *vertices, lines, where);
  }
}

}  // namespace torsio
