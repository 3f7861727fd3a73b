// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_file_check.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/text_lines.h"

namespace torsio {

namespace {

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

void checkStl(std::string_view head, std::uint64_t size, const std::string& where) {
  constexpr std::size_t kHeader = 84;
  constexpr std::uint64_t kFacet = 50;
  const std::uint64_t facets = head.size() >= kHeader ? littleEndian32(head.substr(80, 4)) : 0;
  const bool exact = head.size() >= kHeader && kHeader + facets * kFacet == size;
  // Many binary files begin with the word "solid" too: the length decides.
  if (exact || firstWord(head.substr(0, 64)) == "solid") {
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
  if (head.starts_with("\xEF\xBB\xBF")) {
    head.remove_prefix(3);
  }
  if (!firstWord(head).starts_with(mark)) {
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

}  // namespace

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
  std::ifstream in(file, std::ios::binary);
  std::string head(kHeadBytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  std::error_code failed;
  const auto size = std::filesystem::file_size(file, failed);
  if (failed || in.bad() || head.empty()) {
    throw Error(ErrorCode::kFileUnreadable, Text::tr("M01 cannot be read"), file.string(),
                Text::tr("Check that it is a file you may read"));
  }
  requirePlausibleHead(head, size, extension, file.string());
}

}  // namespace torsio
