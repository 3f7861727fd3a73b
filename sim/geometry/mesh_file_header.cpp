// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh_file_header.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <optional>
#include <vector>

#include "sim/base/error.h"

namespace torsio {

namespace {

constexpr std::size_t kHeadBytes = 65536;
constexpr std::uint64_t kMostDeclared = 1'000'000'000'000ULL;  // so that products cannot overflow

[[noreturn]] void otherFormat(const std::string& where, std::string_view wanted, const std::string& why) {
  throw Error(ErrorCode::kFileUnreadable, "M02 not a file of the format " + std::string(wanted) + ": " + why,
              where, "Give the file the extension of its format, or export it again");
}

[[noreturn]] void tooShort(const std::string& where, const std::string& promised, std::uint64_t size) {
  throw Error(ErrorCode::kFileUnreadable,
              "M04 the header promises " + promised + ", but the file has " + std::to_string(size) + " bytes",
              where, "The file is damaged or cut off: export it again");
}

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> found;
  std::size_t i = 0;
  while (i < line.size()) {
    while (i < line.size() && std::isspace(static_cast<unsigned char>(line[i])) != 0) ++i;
    const std::size_t start = i;
    while (i < line.size() && std::isspace(static_cast<unsigned char>(line[i])) == 0) ++i;
    if (i > start) found.push_back(line.substr(start, i - start));
  }
  return found;
}

std::optional<std::uint64_t> count(std::string_view word) {
  std::uint64_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') return std::nullopt;
    value = value * 10 + static_cast<std::uint64_t>(c - '0');
    if (value > kMostDeclared) return kMostDeclared;
  }
  return word.empty() ? std::nullopt : std::optional(value);
}

std::uint32_t littleEndian32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return value;
}

// Takes the next line off the front of `rest`; nothing when no line end is left.
std::optional<std::string_view> takeLine(std::string_view& rest) {
  const std::size_t end = rest.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return line;
}

std::optional<std::uint64_t> plyTypeSize(std::string_view type) {
  constexpr std::array<std::pair<std::string_view, std::uint64_t>, 16> kSizes{{{"char", 1},
                                                                               {"int8", 1},
                                                                               {"uchar", 1},
                                                                               {"uint8", 1},
                                                                               {"short", 2},
                                                                               {"int16", 2},
                                                                               {"ushort", 2},
                                                                               {"uint16", 2},
                                                                               {"int", 4},
                                                                               {"int32", 4},
                                                                               {"uint", 4},
                                                                               {"uint32", 4},
                                                                               {"float", 4},
                                                                               {"float32", 4},
                                                                               {"double", 8},
                                                                               {"float64", 8}}};
  const auto* const found =
      std::find_if(kSizes.begin(), kSizes.end(), [type](const auto& entry) { return entry.first == type; });
  if (found == kSizes.end()) return std::nullopt;
  return found->second;
}

// What a PLY header declares.
struct PlyHeader {
  struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::uint64_t leastRowBytes = 0;
    std::vector<std::string> scalars;
    bool hasIndexList = false;
  };
  bool ascii = false;
  std::vector<Element> elements;
};

void addPlyProperty(PlyHeader& header, const std::vector<std::string_view>& w, const std::string& where) {
  if (header.elements.empty()) otherFormat(where, "PLY", "a property stands before any element");
  PlyHeader::Element& element = header.elements.back();
  const bool list = w.size() == 5 && w[1] == "list";
  const auto first = plyTypeSize(w.size() > 1 ? w[list ? 2 : 1] : "");
  const auto item = plyTypeSize(list ? w[3] : "char");
  if ((!list && w.size() != 3) || !first || !item) otherFormat(where, "PLY", "a property of unknown type");
  const bool indices = list && (w[4] == "vertex_indices" || w[4] == "vertex_index");
  const std::uint64_t items = indices ? 3 : 0;  // a face has at least three corners
  constexpr std::uint64_t kAsciiValue = 2;      // a digit and a separator
  element.leastRowBytes += header.ascii ? kAsciiValue * (1 + items) : *first + items * *item;
  element.hasIndexList = element.hasIndexList || indices;
  if (!list) element.scalars.emplace_back(w[2]);
}

void parsePlyLine(PlyHeader& header, const std::vector<std::string_view>& w, const std::string& where) {
  if (w.empty() || w[0] == "comment" || w[0] == "obj_info") return;
  if (w[0] == "format" && w.size() == 3) {
    header.ascii = w[1] == "ascii";
    if (!header.ascii && w[1] != "binary_little_endian" && w[1] != "binary_big_endian") {
      otherFormat(where, "PLY", "unknown kind of format");
    }
  } else if (w[0] == "element" && w.size() == 3) {
    const auto declared = count(w[2]);
    if (!declared) otherFormat(where, "PLY", "an element without a count");
    header.elements.push_back({std::string(w[1]), *declared, 0, {}, false});
  } else if (w[0] == "property") {
    addPlyProperty(header, w, where);
  } else {
    otherFormat(where, "PLY", "unknown header line \"" + std::string(w[0].substr(0, 20)) + "\"");
  }
}

void checkPly(std::string_view head, std::uint64_t size, const std::string& where) {
  std::string_view rest = head;
  const auto magic = takeLine(rest);
  if (!magic || words(*magic) != std::vector<std::string_view>{"ply"}) {
    otherFormat(where, "PLY", "the first line is not \"ply\"");
  }
  PlyHeader header;
  while (true) {
    const auto line = takeLine(rest);
    if (!line) otherFormat(where, "PLY", "the header has no end");
    const auto w = words(*line);
    if (w.size() == 1 && w[0] == "end_header") break;
    parsePlyLine(header, w, where);
  }
  const std::uint64_t body = size - (head.size() - rest.size());
  std::uint64_t left = body + (header.ascii ? 1 : 0);  // the last line may lack its end
  bool positions = false;
  bool faces = false;
  for (const PlyHeader::Element& element : header.elements) {
    const auto has = [&element](const char* name) {
      return std::find(element.scalars.begin(), element.scalars.end(), name) != element.scalars.end();
    };
    if (element.count > 0 && element.count > left / std::max<std::uint64_t>(element.leastRowBytes, 1)) {
      tooShort(where, std::to_string(element.count) + " of element " + element.name, size);
    }
    left -= element.count * element.leastRowBytes;
    positions = positions || (element.name == "vertex" && has("x") && has("y") && has("z"));
    faces = faces || (element.name == "face" && element.hasIndexList);
  }
  if (!positions || !faces) {
    throw Error(ErrorCode::kBadMesh, "M06 the file declares no vertices with x, y, z or no faces", where,
                "Give a file with a surface, not points or lines");
  }
}

void checkOff(std::string_view head, std::uint64_t size, const std::string& where) {
  std::vector<std::string_view> tokens;
  std::string_view rest = head;
  for (auto line = takeLine(rest); line && tokens.size() < 4; line = takeLine(rest)) {
    for (const std::string_view w : words(line->substr(0, line->find('#')))) tokens.push_back(w);
  }
  if (tokens.empty() || !tokens[0].ends_with("OFF")) otherFormat(where, "OFF", "it does not begin with OFF");
  const auto vertices = tokens.size() > 1 ? count(tokens[1]) : std::nullopt;
  const auto faces = tokens.size() > 2 ? count(tokens[2]) : std::nullopt;
  if (!vertices || !faces) otherFormat(where, "OFF", "no counts follow the first word");
  constexpr std::uint64_t kLeastVertex = 6;  // "0 0 0\n"
  constexpr std::uint64_t kLeastFace = 8;    // "3 0 1 2\n"
  if (*vertices * kLeastVertex + *faces * kLeastFace > size) {
    tooShort(where, std::to_string(*vertices) + " vertices and " + std::to_string(*faces) + " faces", size);
  }
}

void checkStl(std::string_view head, std::uint64_t size, const std::string& where) {
  constexpr std::size_t kHeader = 84;
  constexpr std::uint64_t kFacet = 50;
  const auto first = words(head.substr(0, 64));
  const std::uint64_t facets = head.size() >= kHeader ? littleEndian32(head.substr(80, 4)) : 0;
  const bool exact = head.size() >= kHeader && kHeader + facets * kFacet == size;
  // Many binary files begin with the word "solid" too: the length decides.
  if (exact || (!first.empty() && first[0] == "solid")) return;
  if (head.size() < kHeader) otherFormat(where, "STL", "neither text nor long enough to be binary");
  if (kHeader + facets * kFacet > size) tooShort(where, std::to_string(facets) + " facets", size);
}

void checkGlb(std::string_view head, std::uint64_t size, const std::string& where) {
  constexpr std::size_t kHeader = 12;
  if (head.size() < kHeader || !head.starts_with("glTF")) otherFormat(where, "GLB", "the magic is missing");
  const std::uint64_t declared = littleEndian32(head.substr(8, 4));
  if (declared > size) tooShort(where, std::to_string(declared) + " bytes", size);
}

// OBJ, glTF and COLLADA are text; a zero byte means UTF-16 or something binary.
void checkText(std::string_view head, std::string_view format, std::string_view mark,
               const std::string& where) {
  if (head.find('\0') != std::string_view::npos) otherFormat(where, format, "it is not UTF-8 text");
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  const auto first = words(head.substr(0, 256));
  if (!mark.empty() && (first.empty() || !first[0].starts_with(mark))) {
    otherFormat(where, format, "it does not begin with " + std::string(mark));
  }
}

}  // namespace

void requirePlausibleHeader(std::string_view head, std::uint64_t size, std::string_view extension,
                            const std::string& where) {
  if (extension == "ply") {
    checkPly(head, size, where);
  } else if (extension == "off") {
    checkOff(head, size, where);
  } else if (extension == "stl") {
    checkStl(head, size, where);
  } else if (extension == "glb") {
    checkGlb(head, size, where);
  } else if (extension == "gltf") {
    checkText(head, "glTF", "{", where);
  } else if (extension == "dae") {
    checkText(head, "COLLADA", "<", where);
  } else {
    checkText(head, "OBJ", "", where);
    const bool vertex = head.starts_with("v ") || head.find("\nv ") != std::string_view::npos ||
                        head.find("\nv\t") != std::string_view::npos;
    if (!vertex) otherFormat(where, "OBJ", "no line of its first 64 kB begins with \"v\"");
  }
}

void requirePlausibleHeader(const std::filesystem::path& file, std::string_view extension) {
  std::ifstream in(file, std::ios::binary);
  std::string head(kHeadBytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  std::error_code failed;
  const auto size = std::filesystem::file_size(file, failed);
  if (failed || in.bad() || head.empty()) {
    throw Error(ErrorCode::kFileUnreadable, "M01 cannot be read", file.string(),
                "Check that it is a file you may read");
  }
  requirePlausibleHeader(head, size, extension, file.string());
}

}  // namespace torsio
