// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "sim/geometry/mesh/mesh_file_check.h"
#include "sim/geometry/mesh/text_lines.h"

namespace torsio {

namespace {

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
