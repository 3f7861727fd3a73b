// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/relief.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torsio {

namespace {

using Vector = std::array<double, 3>;

constexpr Vector kLight{-0.41, 0.49, 0.77};  // unit; towards the light
constexpr QColor kTissue{0xE0, 0xA4, 0x94};  // where the light falls straight on it
constexpr QColor kLine{0x5A, 0x24, 0x24};    // on the surface
constexpr double kAmbient = 0.34;            // of the light
constexpr double kLineWidth = 1.0 / 210.0;   // of the picture
constexpr double kLineStands = 0.006;        // of the box: nearer to the reader than the surface

Vector difference(const ReliefPlace& a, const ReliefPlace& b) {
  return {double{a[0]} - b[0], double{a[1]} - b[1], double{a[2]} - b[2]};
}

/// Returns normals, not of unit length, of the corners.
std::vector<Vector> normalsOf(const ReportRelief& relief) {
  std::vector<Vector> normals(relief.places.size(), Vector{});
  for (const auto& [a, b, c] : *relief.triangles) {
    const Vector u = difference(relief.places[b], relief.places[a]);
    const Vector v = difference(relief.places[c], relief.places[a]);
    const Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    for (const std::uint32_t corner : {a, b, c}) {
      for (std::size_t k = 0; k < 3; ++k) {
        normals[corner][k] += n[k];
      }
    }
  }
  return normals;
}

/// Returns how bright a surface is, 0 to 1; its back as its front.
double brightness(const Vector& normal) {
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  if (length == 0.0) {
    return kAmbient;
  }
  const double facing = normal[2] < 0.0 ? -1.0 : 1.0;
  const double lit =
      facing * (normal[0] * kLight[0] + normal[1] * kLight[1] + normal[2] * kLight[2]) / length;
  return kAmbient + (1.0 - kAmbient) * std::max(0.0, lit);
}

/// A picture with the depth of each pixel.
class Canvas {
 public:
  Canvas(const QRectF& box, int width_px, const QColor& ground)
      : box_(box),
        scale_(width_px / box.width()),
        image_(width_px, std::max(1, static_cast<int>(std::lround(box.height() * scale_))),
               QImage::Format_RGB32),
        depth_(static_cast<std::size_t>(image_.width()) * static_cast<std::size_t>(image_.height()),
               -std::numeric_limits<double>::infinity()) {
    image_.fill(ground);
  }

  /// x and y in pixels, from the upper left; depth in the body's units.
  [[nodiscard]] Vector at(const ReliefPlace& place) const {
    return {(place[0] - box_.left()) * scale_, (box_.bottom() - place[1]) * scale_, double{place[2]}};
  }

  void fill(const std::array<Vector, 3>& corners, const std::array<double, 3>& bright) {
    const auto& [a, b, c] = corners;
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area == 0.0) {
      return;
    }
    const auto [left, right] = std::minmax({a[0], b[0], c[0]});
    const auto [top, bottom] = std::minmax({a[1], b[1], c[1]});
    const int lastX = std::min(image_.width() - 1, static_cast<int>(right));
    const int lastY = std::min(image_.height() - 1, static_cast<int>(bottom));
    for (int y = std::max(0, static_cast<int>(top)); y <= lastY; ++y) {
      for (int x = std::max(0, static_cast<int>(left)); x <= lastX; ++x) {
        const double px = x + 0.5;
        const double py = y + 0.5;
        const double wb = ((px - a[0]) * (c[1] - a[1]) - (py - a[1]) * (c[0] - a[0])) / area;
        const double wc = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) / area;
        if (wb >= 0.0 && wc >= 0.0 && wb + wc <= 1.0) {
          const double wa = 1.0 - wb - wc;
          put(x, y, wa * a[2] + wb * b[2] + wc * c[2], kTissue,
              wa * bright[0] + wb * bright[1] + wc * bright[2]);
        }
      }
    }
  }

  /// Draws a line where nothing hides it.
  void line(const Vector& from, const Vector& to) {
    const double stands = kLineStands * std::max(box_.width(), box_.height());
    const int half = std::max(0, static_cast<int>(std::lround(0.5 * kLineWidth * image_.width())));
    const int steps = 1 + static_cast<int>(2.0 * std::hypot(to[0] - from[0], to[1] - from[1]));
    for (int i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      const int x = static_cast<int>(from[0] + share * (to[0] - from[0]));
      const int y = static_cast<int>(from[1] + share * (to[1] - from[1]));
      const double depth = from[2] + share * (to[2] - from[2]) + stands;
      if (!inside(x, y) || depth < depthAt(x, y)) {
        continue;
      }
      for (int dy = -half; dy <= half; ++dy) {
        for (int dx = -half; dx <= half; ++dx) {
          if (inside(x + dx, y + dy)) {
            image_.setPixelColor(x + dx, y + dy, kLine);
          }
        }
      }
    }
  }

  [[nodiscard]] bool sees(const Vector& place) const {
    constexpr double kMarkStands = 5.0;  // times what a line does: a mark is no thin line
    const int x = static_cast<int>(place[0]);
    const int y = static_cast<int>(place[1]);
    return !inside(x, y) ||
           place[2] + kMarkStands * kLineStands * std::max(box_.width(), box_.height()) >= depthAt(x, y);
  }

  [[nodiscard]] const QImage& image() const { return image_; }

 private:
  [[nodiscard]] bool inside(int x, int y) const {
    return x >= 0 && y >= 0 && x < image_.width() && y < image_.height();
  }
  [[nodiscard]] double depthAt(int x, int y) const {
    return depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width()) +
                  static_cast<std::size_t>(x)];
  }
  void put(int x, int y, double depth, const QColor& colour, double bright) {
    double& before = depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width()) +
                            static_cast<std::size_t>(x)];
    if (depth <= before) {
      return;
    }
    before = depth;
    const auto part = [bright](int value) { return static_cast<int>(std::lround(value * bright)); };
    image_.setPixel(x, y, qRgb(part(colour.red()), part(colour.green()), part(colour.blue())));
  }

  QRectF box_;
  double scale_;
  QImage image_;
  std::vector<double> depth_;
};

}  // namespace

QRectF reliefBox(const std::vector<ReportRelief>& reliefs) {
  QRectF box;
  for (const ReportRelief& relief : reliefs) {
    for (const ReliefPlace& place : relief.places) {
      const QPointF at(place[0], place[1]);
      box = box.isNull() ? QRectF(at, QSizeF(1e-6, 1e-6))
                         : QRectF(QPointF(std::min(box.left(), at.x()), std::min(box.top(), at.y())),
                                  QPointF(std::max(box.right(), at.x()), std::max(box.bottom(), at.y())));
    }
  }
  const double margin = 0.03 * std::max(box.width(), box.height());
  return box.adjusted(-margin, -margin, margin, margin);
}

DrawnRelief drawRelief(const ReportRelief& relief, const QRectF& box, int width_px, const ChartStyle& look) {
  Canvas canvas(box, width_px, look.ground);
  const std::vector<Vector> normals = normalsOf(relief);
  for (const auto& [a, b, c] : *relief.triangles) {
    canvas.fill({canvas.at(relief.places[a]), canvas.at(relief.places[b]), canvas.at(relief.places[c])},
                {brightness(normals[a]), brightness(normals[b]), brightness(normals[c])});
  }
  for (const std::vector<ReliefPlace>& line : relief.lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      canvas.line(canvas.at(line[i - 1]), canvas.at(line[i]));
    }
  }
  DrawnRelief drawn{canvas.image(), {}, {}};
  for (const auto& [name, place] : relief.marks) {
    const Vector at = canvas.at(place);
    drawn.marks.emplace_back(at[0], at[1]);
    drawn.seen.push_back(canvas.sees(at));
  }
  return drawn;
}

}  // namespace torsio
