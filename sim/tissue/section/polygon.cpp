// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/polygon.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <system_error>

#include "sim/core/byte_order_mark.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

struct PolygonEdge {
  Point2 a;
  Point2 b;
  double left = 0.0;
  double right = 0.0;
  int index = 0;
};

std::vector<PolygonEdge> edgesFromLeft(std::span<const Point2> polygon) {
  std::vector<PolygonEdge> edges;
  edges.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    edges.push_back({a, b, std::min(a[0], b[0]), std::max(a[0], b[0]), static_cast<int>(i)});
  }
  std::sort(edges.begin(), edges.end(), [](const PolygonEdge& p, const PolygonEdge& q) {
    return p.left != q.left ? p.left < q.left : p.index < q.index;
  });
  return edges;
}

/// `p` is known to lie on the line through a and b.
bool withinBox(const Point2& a, const Point2& b, const Point2& p) {
  return std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) && std::min(a[1], b[1]) <= p[1] &&
         p[1] <= std::max(a[1], b[1]);
}

bool meet(const PolygonEdge& p, const PolygonEdge& q) {
  const double a = orientation(p.a, p.b, q.a);
  const double b = orientation(p.a, p.b, q.b);
  const double c = orientation(q.a, q.b, p.a);
  const double d = orientation(q.a, q.b, p.b);
  if (((a > 0 && b < 0) || (a < 0 && b > 0)) && ((c > 0 && d < 0) || (c < 0 && d > 0))) {
    return true;
  }
  return (a == 0 && withinBox(p.a, p.b, q.a)) || (b == 0 && withinBox(p.a, p.b, q.b)) ||
         (c == 0 && withinBox(q.a, q.b, p.a)) || (d == 0 && withinBox(q.a, q.b, p.b));
}

/// Edges that follow each other share one point; only running back over each other is a fault.
bool runsBack(const Point2& before, const Point2& shared, const Point2& after) {
  const double along =
      (shared[0] - before[0]) * (after[0] - shared[0]) + (shared[1] - before[1]) * (after[1] - shared[1]);
  return orientation(before, shared, after) == 0.0 && along < 0.0;
}

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

PolygonMoments polygonMoments(std::span<const Point2> polygon) {
  // About the first point: moments about a far origin would cancel.
  const Point2 origin = polygon.front();
  double area2 = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    const double x0 = p[0] - origin[0], y0 = p[1] - origin[1];
    const double x1 = q[0] - origin[0], y1 = q[1] - origin[1];
    const double w = x0 * y1 - x1 * y0;
    area2 += w;
    sx += w * (x0 + x1);
    sy += w * (y0 + y1);
    sxx += w * (x0 * x0 + x0 * x1 + x1 * x1);
    syy += w * (y0 * y0 + y0 * y1 + y1 * y1);
    sxy += w * (x0 * y1 + 2.0 * (x0 * y0 + x1 * y1) + x1 * y0);
  }
  PolygonMoments m;
  m.area = area2 / 2.0;
  if (m.area == 0.0) {
    return m;
  }
  const double cx = sx / (6.0 * m.area);
  const double cy = sy / (6.0 * m.area);
  m.centroid = {origin[0] + cx, origin[1] + cy};
  m.xx = sxx / 12.0 - m.area * cx * cx;
  m.yy = syy / 12.0 - m.area * cy * cy;
  m.xy = sxy / 24.0 - m.area * cx * cy;
  return m;
}

double perimeter(std::span<const Point2> polygon) {
  double length = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    length += std::sqrt(dx * dx + dy * dy);
  }
  return length;
}

std::optional<std::pair<int, int>> firstSelfCrossing(std::span<const Point2> polygon) {
  const int n = static_cast<int>(polygon.size());
  const std::vector<PolygonEdge> edges = edgesFromLeft(polygon);
  for (int i = 0; i < n; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const std::size_t next = (k + 1) % polygon.size();
    if (runsBack(polygon[k], polygon[next], polygon[(k + 2) % polygon.size()])) {
      return std::pair{i, static_cast<int>(next)};
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].left <= edges[i].right; ++j) {
      const int gap = std::abs(edges[i].index - edges[j].index);
      if (gap == 1 || gap == n - 1) {
        continue;
      }
      if (meet(edges[i], edges[j])) {
        return std::minmax(edges[i].index, edges[j].index);
      }
    }
  }
  return std::nullopt;
}

std::optional<std::pair<int, int>> firstCrossing(std::span<const Point2> a, std::span<const Point2> b) {
  const std::vector<PolygonEdge> first = edgesFromLeft(a);
  const std::vector<PolygonEdge> second = edgesFromLeft(b);
  for (const PolygonEdge& p : first) {
    for (const PolygonEdge& q : second) {
      if (q.left > p.right) {
        break;
      }
      if (q.right >= p.left && meet(p, q)) {
        return std::pair{p.index, q.index};
      }
    }
  }
  return std::nullopt;
}

bool contains(std::span<const Point2> polygon, const Point2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    if ((a[1] > point[1]) == (b[1] > point[1])) {
      continue;
    }
    const double x = a[0] + (point[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    if (point[0] < x) {
      inside = !inside;
    }
  }
  return inside;
}

double grazingSine(std::span<const Point2> polygon, const Point2& centre) {
  double least = 1.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    const double ex = b[0] - a[0], ey = b[1] - a[1];
    const double edge = std::sqrt(ex * ex + ey * ey);
    const double twiceArea = orientation(centre, a, b);
    for (const Point2& p : {a, b}) {
      const double rx = p[0] - centre[0], ry = p[1] - centre[1];
      const double ray = std::sqrt(rx * rx + ry * ry);
      if (ray * edge <= 0.0) {
        return -1.0;
      }
      least = std::min(least, twiceArea / (ray * edge));
    }
  }
  return least;
}

std::vector<Point2> readOutline(const std::filesystem::path& file) {
  const std::string text = readFile(file);
  std::string_view rest = withoutByteOrderMark(text);
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
