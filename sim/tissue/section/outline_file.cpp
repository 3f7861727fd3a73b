// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/outline_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

constexpr std::string_view kSeparators = " \t,;\r";
constexpr Phrase kRemedy = Text::verbatim("Write one point a line as x,y");

/// The values between separators.
std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t from = line.find_first_not_of(kSeparators); from != std::string_view::npos;
       from = line.find_first_not_of(kSeparators, from)) {
    const std::size_t to = std::min(line.find_first_of(kSeparators, from), line.size());
    fields.push_back(line.substr(from, to - from));
    from = to;
  }
  return fields;
}

bool parse(std::string_view field, double& value) {
  if (!field.empty() && field.front() == '+') {
    field.remove_prefix(1);
  }
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return error == std::errc() && end == field.data() + field.size();
}

Point2 pointOf(const std::vector<std::string_view>& fields, const std::string& where) {
  if (fields.size() != 2) {
    throw Error(ErrorCode::kBadData,
                Text::verbatim("expected 2 values, found %1", std::to_string(fields.size())), where, kRemedy);
  }
  Point2 point{};
  for (std::size_t k = 0; k < 2; ++k) {
    if (!parse(fields[k], point[k])) {
      throw Error(ErrorCode::kBadData, Text::tr("'%1' is not a number", std::string(fields[k].substr(0, 40))),
                  where, kRemedy);
    }
    if (!std::isfinite(point[k])) {
      throw Error(ErrorCode::kBadData, Text::verbatim("a coordinate is not a finite number"), where, kRemedy);
    }
  }
  return point;
}

/// A line of column names: no field of it is a number.
bool isHeader(const std::vector<std::string_view>& fields) {
  double value = 0.0;
  for (const std::string_view field : fields) {
    if (parse(field, value)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Point2> readOutline(const std::filesystem::path& file) {
  const std::string text = readFile(file);
  std::string_view rest = text;
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (rest.starts_with(kByteOrderMark)) {
    rest.remove_prefix(kByteOrderMark.size());
  }
  std::vector<Point2> points;
  bool headerSeen = false;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::vector<std::string_view> fields = fieldsOf(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (fields.empty() || fields.front().front() == '#') {
      continue;
    }
    if (points.empty() && !headerSeen && isHeader(fields)) {
      headerSeen = true;
      continue;
    }
    points.push_back(pointOf(fields, file.string() + ", line " + std::to_string(number)));
  }
  if (points.size() > 1 && points.front() == points.back()) {
    points.pop_back();
  }
  if (points.size() < 3) {
    throw Error(
        ErrorCode::kBadData,
        Text::verbatim("a section needs at least 3 points, this file has %1", std::to_string(points.size())),
        file.string(), kRemedy);
  }
  return points;
}

}  // namespace torsio
