// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_space.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <system_error>

#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/geometry/mesh/mesh_file_check.h"

namespace torsio {

namespace {

constexpr double kMillimetre_m = 1e-3;
constexpr double kSameUnit = 1e-6;  // relative

/// The value of an attribute of the first element with this name; empty: there is none.
std::string_view attributeOf(std::string_view xml, std::string_view element, std::string_view attribute) {
  for (std::size_t at = xml.find(element); at != std::string_view::npos; at = xml.find(element, at + 1)) {
    const std::string_view rest = xml.substr(at + element.size());
    if (rest.empty() || std::string_view(" \t\r\n").find(rest.front()) == std::string_view::npos) {
      continue;  // a longer name
    }
    const std::string_view inside = rest.substr(0, rest.find('>'));
    for (std::size_t name = inside.find(attribute); name != std::string_view::npos;
         name = inside.find(attribute, name + 1)) {
      const std::size_t equals = inside.find_first_not_of(" \t\r\n", name + attribute.size());
      if (equals == std::string_view::npos || inside[equals] != '=' || name == 0 ||
          std::string_view(" \t\r\n").find(inside[name - 1]) == std::string_view::npos) {
        continue;
      }
      const std::size_t open = inside.find_first_of("\"'", equals);
      const std::size_t close = open == std::string_view::npos ? open : inside.find(inside[open], open + 1);
      return close == std::string_view::npos ? std::string_view() : inside.substr(open + 1, close - open - 1);
    }
    return {};
  }
  return {};
}

std::optional<double> colladaUnit_m(std::string_view head) {
  const std::string_view word = attributeOf(head, "<unit", "meter");
  double unit_m = 0.0;
  const auto [end, failed] = std::from_chars(word.data(), word.data() + word.size(), unit_m);
  const bool whole = failed == std::errc() && end == word.data() + word.size();
  return whole && std::isfinite(unit_m) && unit_m > 0.0 ? std::optional(unit_m) : std::nullopt;
}

/// What of a file is its header or its first comments.
std::string_view commentsOf(std::string_view head, std::string_view extension) {
  if (extension == "ply") {
    return head.substr(0, head.find("end_header"));
  }
  if (extension == "stl") {
    constexpr std::size_t kHeader = 80;
    return head.substr(0, std::min(kHeader, head.find('\n')));
  }
  TextLines lines(head);
  std::size_t length = 0;
  while (const auto line = lines.next()) {
    if (!line->empty() && line->front() != '#' && line->front() != '\r') {
      break;
    }
    length = head.size() - lines.rest().size();
  }
  return head.substr(0, length);
}

}  // namespace

MeshSpace meshSpaceIn(std::string_view head, std::string_view extension) {
  MeshSpace space;
  if (extension == "dae") {
    space.unit_m = colladaUnit_m(head);
  } else if (extension == "gltf" || extension == "glb") {
    space.unit_m = 1.0;
  } else if (extension == "stl" || extension == "ply" || extension == "obj") {
    const std::string_view comments = commentsOf(head, extension);
    space.ras = comments.find("SPACE=RAS") != std::string_view::npos;
    if (comments.find("3D Slicer output") != std::string_view::npos) {
      space.unit_m = kMillimetre_m;
    }
  }
  return space;
}

MeshSpace meshSpaceOf(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed)) {
    return {};  // a pipe may never answer
  }
  return meshSpaceIn(headOf(file), lowerExtension(file));
}

double meshUnit_m(const std::filesystem::path& file, std::optional<double> given_m) {
  const std::optional<double> stated_m = meshSpaceOf(file).unit_m;
  if (stated_m && given_m && std::abs(*given_m / *stated_m - 1.0) > kSameUnit) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("the file says that one of its units is %1 mm, not %2 mm",
                         shortNumber(*stated_m / kMillimetre_m), shortNumber(*given_m / kMillimetre_m)),
                file.string(),
                Text::tr("Leave the unit out; if the file is wrong, export it again with its true unit"));
  }
  return stated_m ? *stated_m : given_m.value_or(kMillimetre_m);
}

}  // namespace torsio
