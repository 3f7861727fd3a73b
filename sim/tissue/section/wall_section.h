// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/tissue/section/polygon.h"

namespace torsio {

/// Thickness of a wall along an organ: linear between places, constant beyond the outermost. Empty: a filled
/// organ.
class WallMap {
 public:
  WallMap() = default;
  /// Takes pairs of a place, as a share of the length, and a thickness in metres. Throws Error{kBadParameter}
  /// for places outside 0..1 or not ascending, and for a thickness that is not above 0.
  explicit WallMap(std::vector<std::array<double, 2>> places);

  [[nodiscard]] bool empty() const noexcept { return places_.empty(); }
  /// Returns the thickness at a share of the length, m; 0 for an empty map.
  [[nodiscard]] double thickness_m(double share) const noexcept;

 private:
  std::vector<std::array<double, 2>> places_;
};

/// The unit in which a message gives lengths: what one unit of an outline is in it, and its name.
struct SaidUnit {
  double ofOutline = 1.0;
  std::string_view name = "";

  /// Returns a length of the outline in words.
  [[nodiscard]] std::string length(double length) const;
  [[nodiscard]] std::string area(double area) const;
};
/// Of an outline in metres.
inline constexpr SaidUnit kSaidInMillimetres{1000.0, "mm"};

/// A closed wall inside an outline, by the middle line of the wall. Lengths in the unit of the outline.
struct WallSection {
  double areaMid = 0.0;          ///< A_m inside the middle line, L^2
  double perimeterMid = 0.0;     ///< s_m of the middle line, L
  double radius = 0.0;           ///< s_m / (2 pi): folds keep the perimeter, so the equal circle does too, L
  double area = 0.0;             ///< of the wall itself, L^2
  double torsionConstant = 0.0;  ///< J, L^4
  double maxShear = 0.0;         ///< mean of |tau| across the wall where it is thinnest, G = 1, unit rate, L
  double thickest = 0.0;         ///< L
  /// Thickness at which the offset of the outline crosses itself: the smaller of the least radius of
  /// curvature of a convex corner and of half the narrowest place, L.
  double mostThickness = 0.0;
};

/// Computes the torsion constant of a closed wall from its outer outline: Bredt's closed tube on the middle
/// line, whose area and perimeter follow from the outline by Steiner's formula, plus the open strip,
/// J = 4 A_m^2 / closed integral ds / t + (1/3) closed integral t^3 ds (docs/model.md H.1). `outline`: a
/// simple polygon of at least 3 points, either orientation, first point not repeated. `thickness`: one
/// number, or one for each point of the outline, linear between them. Throws Error{kBadParameter} for an
/// outline that is no simple polygon, a thickness that is not above 0 or above 0.45 of `radius`, a wall that
/// has more area than the outline, or another number of thicknesses; lengths in its message are `said`.
[[nodiscard]] WallSection wallSection(std::span<const Point2> outline, std::span<const double> thickness,
                                      const SaidUnit& said = {});

/// Returns the inner outline of a wall: every point moved inwards along the normal there. It may cross itself
/// where the wall is thicker than `mostThickness`; moments of area stay usable. Inputs as for wallSection;
/// the outline anticlockwise.
[[nodiscard]] std::vector<Point2> innerOutline(std::span<const Point2> outline, double thickness);

}  // namespace torsio
