// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_file_check.h"

namespace torsio {

namespace {

using Words = std::vector<std::string_view>;

enum class Encoding { kAscii, kLittleEndian, kBigEndian };

struct PlyType {
  std::uint64_t bytes = 0;
  bool integer = false;
  bool isSigned = false;
};

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> listCount;  // set for lists
  bool indices = false;              // of vertices
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  Encoding format = Encoding::kAscii;
  std::vector<PlyElement> elements;
};

std::optional<PlyType> typeNamed(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> kTypes{{{"char", {1, true, true}},
                                                                         {"int8", {1, true, true}},
                                                                         {"uchar", {1, true, false}},
                                                                         {"uint8", {1, true, false}},
                                                                         {"short", {2, true, true}},
                                                                         {"int16", {2, true, true}},
                                                                         {"ushort", {2, true, false}},
                                                                         {"uint16", {2, true, false}},
                                                                         {"int", {4, true, true}},
                                                                         {"int32", {4, true, true}},
                                                                         {"uint", {4, true, false}},
                                                                         {"uint32", {4, true, false}},
                                                                         {"float", {4, false, true}},
                                                                         {"float32", {4, false, true}},
                                                                         {"double", {8, false, true}},
                                                                         {"float64", {8, false, true}}}};
  for (const auto& [known, type] : kTypes) {
    if (name == known) {
      return type;
    }
  }
  return std::nullopt;
}

void addProperty(PlyHeader& header, const Words& w, const std::string& where) {
  if (header.elements.empty()) {
    refuseFormat(where, "PLY", Text::tr("a property comes before any element"));
  }
  const bool list = w.size() == 5 && w[1] == "list";
  if (!list && w.size() != 3) {
    refuseFormat(where, "PLY", Text::tr("a property without type and name"));
  }
  const auto count = list ? typeNamed(w[2]) : std::nullopt;
  const auto type = typeNamed(list ? w[3] : w[1]);
  if (!type || (list && (!count || !count->integer))) {
    refuseFormat(where, "PLY", Text::tr("a property of unknown type"));
  }
  PlyProperty property{std::string(w.back()), *type, count, false};
  property.indices = list && (property.name == "vertex_indices" || property.name == "vertex_index");
  if (property.indices && !type->integer) {
    refuseFormat(where, "PLY", Text::tr("vertex indices that are not integers"));
  }
  header.elements.back().properties.push_back(std::move(property));
}

void parseHeaderLine(PlyHeader& header, const Words& w, const std::string& where) {
  if (w.empty() || w[0] == "comment" || w[0] == "obj_info") {
    return;
  }
  if (w[0] == "format" && w.size() == 3) {
    if (w[1] == "ascii") {
      header.format = Encoding::kAscii;
    } else if (w[1] == "binary_little_endian") {
      header.format = Encoding::kLittleEndian;
    } else if (w[1] == "binary_big_endian") {
      header.format = Encoding::kBigEndian;
    } else {
      refuseFormat(where, "PLY", Text::tr("unknown kind of format"));
    }
  } else if (w[0] == "element" && w.size() == 3) {
    const auto declared = parseCount(w[2]);
    if (!declared) {
      refuseFormat(where, "PLY", Text::tr("an element without a count"));
    }
    header.elements.push_back({std::string(w[1]), *declared, {}});
  } else if (w[0] == "property") {
    addProperty(header, w, where);
  } else {
    refuseFormat(where, "PLY", "unknown header line \"" + std::string(w[0].substr(0, 20)) + "\"");
  }
}

PlyHeader parseHeader(TextLines& lines, const std::string& where) {
  constexpr std::uint64_t kMaxLines = 10'000;
  PlyHeader header;
  Words words;
  auto line = lines.next();
  if (line) {
    splitWords(*line, words);
  }
  if (!line || words != Words{"ply"}) {
    refuseFormat(where, "PLY", Text::tr("the first line is not \"ply\""));
  }
  while (true) {
    line = lines.next();
    if (!line || lines.number() > kMaxLines) {
      refuseFormat(where, "PLY", Text::tr("the header has no end"));
    }
    splitWords(*line, words);
    if (words == Words{"end_header"}) {
      return header;
    }
    parseHeaderLine(header, words, where);
  }
}

// Bytes that one row has at the least; a face has three corners.
std::uint64_t leastRow(const PlyElement& element, Encoding format) {
  constexpr std::uint64_t kAsciiValue = 2;  // a digit and a separator
  std::uint64_t bytes = 0;
  for (const PlyProperty& p : element.properties) {
    const std::uint64_t items = p.indices ? 3 : 0;
    if (format == Encoding::kAscii) {
      bytes += kAsciiValue * (p.listCount ? 1 + items : 1);
    } else {
      bytes += p.listCount ? p.listCount->bytes + items * p.type.bytes : p.type.bytes;
    }
  }
  return std::max<std::uint64_t>(bytes, 1);
}

// Returns the number of vertices.
std::uint64_t checkElements(const PlyHeader& header, std::uint64_t bodyBytes, std::uint64_t size,
                            const std::string& where) {
  std::uint64_t left = bodyBytes + (header.format == Encoding::kAscii ? 1 : 0);  // no line end at the end
  std::uint64_t vertices = 0;
  bool faces = false;
  for (const PlyElement& element : header.elements) {
    const std::uint64_t row = leastRow(element, header.format);
    if (element.count > left / row) {
      refuseShort(where, std::to_string(element.count) + " of element " + element.name, size);
    }
    left -= element.count * row;
    const auto has = [&element](const char* name) {
      return std::any_of(element.properties.begin(), element.properties.end(),
                         [name](const PlyProperty& p) { return p.name == name && !p.listCount; });
    };
    if (element.name == "vertex" && has("x") && has("y") && has("z")) {
      vertices = element.count;
    }
    faces = faces || (element.name == "face" && element.count > 0 &&
                      std::any_of(element.properties.begin(), element.properties.end(),
                                  [](const PlyProperty& p) { return p.indices; }));
  }
  if (vertices == 0 || !faces) {
    throw Error(ErrorCode::kBadMesh, Text::tr("M06 the file declares no vertices with x, y, z or no faces"),
                where, Text::tr("Give a file with a surface, not points or lines"));
  }
  return vertices;
}

void checkAsciiRow(const PlyElement& element, const Words& words, std::uint64_t vertices,
                   const std::string& row, const std::string& where) {
  std::size_t next = 0;
  const auto take = [&]() {
    if (next >= words.size()) {
      refuseRow(where, row, Text::tr("values are missing"));
    }
    return words[next++];
  };
  for (const PlyProperty& p : element.properties) {
    const auto items = p.listCount ? parseCount(take()) : std::optional<std::uint64_t>(1);
    if (!items || (p.indices && *items == 0)) {
      refuseRow(where, row, Text::tr("the length of a list is not a count"));
    }
    for (std::uint64_t i = 0; i < *items; ++i) {
      const std::string_view word = take();
      if (!p.indices) {
        if (!isNumber(word)) {
          refuseRow(where, row, Text::tr("a value is not a number"));
        }
        continue;
      }
      const auto index = parseCount(word);
      if (!index) {
        refuseRow(where, row, Text::tr("an index is not a whole number"));
      }
      if (*index >= vertices) {
        refuseIndex(where, row, static_cast<std::int64_t>(*index), vertices);
      }
    }
  }
  if (next != words.size()) {
    refuseRow(where, row, Text::tr("it has more values than declared"));
  }
}

void walkAscii(const PlyHeader& header, std::uint64_t vertices, TextLines& lines, const std::string& where) {
  Words words;
  for (const PlyElement& element : header.elements) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      const auto line = lines.next();
      const std::string row = "line " + std::to_string(lines.number());
      if (!line) {
        refuseRow(where, row, Text::tr("the file ends early"));
      }
      splitWords(*line, words);
      checkAsciiRow(element, words, vertices, row, where);
    }
  }
}

// An integer of the file at `at`, which lies inside.
std::int64_t integerAt(std::string_view bytes, std::uint64_t at, const PlyType& type, Encoding format) {
  TORSIO_EXPECTS(type.bytes >= 1 && type.bytes <= 4);
  std::uint64_t value = 0;
  for (std::uint64_t i = 0; i < type.bytes; ++i) {
    const std::uint64_t byte = format == Encoding::kBigEndian ? at + i : at + type.bytes - 1 - i;
    value = value << 8U | static_cast<unsigned char>(bytes[byte]);
  }
  const std::uint64_t signBit = std::uint64_t{1} << (8 * type.bytes - 1);
  if (type.isSigned && (value & signBit) != 0) {
    return static_cast<std::int64_t>(value) - static_cast<std::int64_t>(signBit << 1U);
  }
  return static_cast<std::int64_t>(value);
}

void walkBinary(const PlyHeader& header, std::uint64_t vertices, std::string_view body,
                const std::string& where) {
  std::uint64_t at = 0;
  const auto need = [&](std::uint64_t bytes, const std::string& row) {
    if (bytes > body.size() - at) {
      refuseRow(where, row, Text::tr("the file ends early"));
    }
  };
  for (const PlyElement& element : header.elements) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      const std::string row = element.name + " " + std::to_string(i);
      for (const PlyProperty& p : element.properties) {
        std::int64_t items = 1;
        if (p.listCount) {
          need(p.listCount->bytes, row);
          items = integerAt(body, at, *p.listCount, header.format);
          at += p.listCount->bytes;
          if (items < (p.indices ? 1 : 0)) {
            refuseRow(where, row, Text::tr("the length of a list is not a count"));
          }
        }
        need(static_cast<std::uint64_t>(items) * p.type.bytes, row);
        for (std::int64_t k = 0; k < items && p.indices; ++k) {
          const std::int64_t index =
              integerAt(body, at + static_cast<std::uint64_t>(k) * p.type.bytes, p.type, header.format);
          if (index < 0 || static_cast<std::uint64_t>(index) >= vertices) {
            refuseIndex(where, row, index, vertices);
          }
        }
        at += static_cast<std::uint64_t>(items) * p.type.bytes;
      }
    }
  }
}

}  // namespace

void requirePlausiblePly(std::string_view bytes, const std::string& where) {
  TextLines lines(bytes);
  const PlyHeader header = parseHeader(lines, where);
  const std::uint64_t vertices = checkElements(header, lines.rest().size(), bytes.size(), where);
  if (header.format == Encoding::kAscii) {
    walkAscii(header, vertices, lines, where);
  } else {
    walkBinary(header, vertices, lines.rest(), where);
  }
}

}  // namespace torsio
