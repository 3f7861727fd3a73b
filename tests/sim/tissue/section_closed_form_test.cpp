// SPDX-License-Identifier: GPL-3.0-or-later
// Sections whose torsion is known in closed form. References: classical series (rectangle), conformal-map
// series (regular polygons) and closed forms, evaluated to 30 digits with mpmath; docs/model.md.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/tissue/section/section_solver.h"
#include "sim/tissue/section/wall_section.h"
#include "tests/sim/tissue/section_shapes.h"
#include "tests/support/refusal.h"

namespace torsio {

namespace {

// The default bracket is at most 2e-4 of J, so that its mean is within 1e-4 of the true J.
constexpr double kMeanTolerance = 1e-4;
// The sag is a point value on about a thousand nodes.
constexpr double kSagTolerance = 1e-4;
constexpr double kVolumeRatioTolerance = 2e-4;
// The stress on the outline is a mean over one spacing (1/128 of the outline), corrected to second order.
constexpr double kShearTolerance = 1e-3;

void expectRelative(double value, double reference, double tolerance, const char* what) {
  EXPECT_NEAR(value / reference, 1.0, tolerance) << what << " is " << value << ", should be " << reference;
}

struct Polygon {
  int corners;
  double torsionConstant;
  double sag;
};

class RegularPolygon : public ::testing::TestWithParam<Polygon> {};

TEST_P(RegularPolygon, HasTheTorsionConstantAndSagOfTheConformalMap) {
  const Polygon reference = GetParam();

  const SectionProperties section = solveSection(shapes::circle(reference.corners));

  EXPECT_LE(section.torsionLower, reference.torsionConstant * (1.0 + 1e-8));  // 9 digits printed
  EXPECT_GE(section.torsionUpper, reference.torsionConstant * (1.0 - 1e-8));
  expectRelative(section.torsionConstant, reference.torsionConstant, kMeanTolerance, "J");
  expectRelative(section.sag, reference.sag, kSagTolerance, "sag");
}

INSTANTIATE_TEST_SUITE_P(
    Section, RegularPolygon,
    ::testing::Values(Polygon{5, 0.84475626, 0.18224235}, Polygon{6, 1.035458950, 0.20239407},
                      Polygon{8, 1.253104082, 0.22308635}, Polygon{12, 1.425364842, 0.23810114},
                      Polygon{16, 1.488519673, 0.24334979}, Polygon{24, 1.534238759, 0.24707068},
                      Polygon{36, 1.554605519, 0.24870762}, Polygon{48, 1.561714057, 0.24927601},
                      Polygon{72, 1.566773542, 0.24967963}, Polygon{100, 1.568715508, 0.24983435},
                      Polygon{180, 1.570155878, 0.24994903}, Polygon{360, 1.570636514, 0.24998728}));

struct Rectangle {
  double width;  // height 1
  double torsionConstant;
  double sag;
  double volumeRatio;  // V / (l S_c)
};

class RectangularSection : public ::testing::TestWithParam<Rectangle> {};

TEST_P(RectangularSection, MatchesTheSeries) {
  const Rectangle reference = GetParam();

  const SectionProperties section = solveSection(shapes::rectangle(reference.width, 1.0));

  EXPECT_LE(section.torsionLower, reference.torsionConstant);
  EXPECT_GE(section.torsionUpper, reference.torsionConstant);
  expectRelative(section.torsionConstant, reference.torsionConstant, kMeanTolerance, "J");
  expectRelative(section.sag, reference.sag, kSagTolerance, "sag");
  EXPECT_NEAR(section.volume / (section.sag * section.area), reference.volumeRatio, kVolumeRatioTolerance);
  EXPECT_DOUBLE_EQ(section.area, reference.width);
  expectRelative(section.polarMoment, reference.width * (1.0 + reference.width * reference.width) / 12.0,
                 1e-14, "Ip");
}

INSTANTIATE_TEST_SUITE_P(Section, RectangularSection,
                         ::testing::Values(Rectangle{1.0, 0.140577014955, 0.0736713532815, 0.477040968753},
                                           Rectangle{1.2, 0.199342692095, 0.0867405879423, 0.478780793454},
                                           Rectangle{1.5, 0.293641063313, 0.100771384782, 0.485655499572},
                                           Rectangle{2.0, 0.457363354239, 0.113871832127, 0.502059361054},
                                           Rectangle{2.5, 0.623412686770, 0.119918462690, 0.519863808112},
                                           Rectangle{3.0, 0.789950793005, 0.122682394600, 0.536582555019},
                                           Rectangle{4.0, 1.12325183323, 0.124518178594, 0.563799120495},
                                           Rectangle{5.0, 1.45658377094, 0.124899838824, 0.583100740825},
                                           Rectangle{10.0, 3.12325037457, 0.124999961117, 0.624650269220}));

TEST(SectionSolver, FindsTheLargestShearOfRectanglesInTheMiddleOfTheLongSide) {
  // Width to height, largest tau / (G theta short side): series.
  const std::vector<std::pair<double, double>> references = {
      {1.0, 0.675314483}, {1.5, 0.847562233}, {2.0, 0.930060270}, {3.0, 0.985437882}, {5.0, 0.999370669}};

  for (const auto& [width, shear] : references) {
    const SectionProperties section = solveSection(shapes::rectangle(width, 1.0));

    expectRelative(section.maxShear, shear, kShearTolerance, "largest shear");
    for (const double corner : section.outlineShear) {
      EXPECT_EQ(corner, 0.0);
    }
  }
}

TEST(SectionSolver, SolvesTheEquilateralTriangle) {
  const SectionProperties section = solveSection(shapes::equilateralTriangle(1.0));

  const double exact = 0.0216506350946;  // sqrt(3) / 80
  EXPECT_LE(section.torsionLower, exact);
  EXPECT_GE(section.torsionUpper, exact);
  expectRelative(section.torsionConstant, exact, kMeanTolerance, "J");
  expectRelative(section.sag, 1.0 / 36.0, kSagTolerance, "sag");
  EXPECT_NEAR(section.volume / (section.sag * section.area), 0.45, kVolumeRatioTolerance);
  expectRelative(section.maxShear, std::sqrt(3.0) / 4.0, kShearTolerance, "largest shear");  // z is a cubic
}

struct Ellipse {
  double a;
  double torsionConstant;  // pi a^3 b^3 / (a^2 + b^2), b = 1
  double sag;              // a^2 b^2 / (2 (a^2 + b^2))
};

class EllipticSection : public ::testing::TestWithParam<Ellipse> {};

TEST_P(EllipticSection, MatchesTheClosedForm) {
  const Ellipse reference = GetParam();
  // The polygon lies inside the ellipse: J falls short by about (2 pi / N)^2 / 3, 2.5e-5 at 720 points.
  const SectionProperties section = solveSection(shapes::ellipse(720, reference.a, 1.0));

  expectRelative(section.torsionConstant, reference.torsionConstant, kMeanTolerance, "J");
  expectRelative(section.sag, reference.sag, kSagTolerance, "sag");
  EXPECT_NEAR(section.volume / (section.sag * section.area), 0.5, kVolumeRatioTolerance);
  // Largest at the end of the short axis: 2 a^2 b / (a^2 + b^2).
  expectRelative(section.maxShear, 2.0 * reference.a * reference.a / (reference.a * reference.a + 1.0),
                 kShearTolerance, "largest shear");
}

INSTANTIATE_TEST_SUITE_P(Section, EllipticSection,
                         ::testing::Values(Ellipse{1.0, 1.57079632679, 0.25},
                                           Ellipse{1.5, 3.26242314027, 0.346153846154},
                                           Ellipse{2.0, 5.02654824574, 0.4},
                                           Ellipse{3.0, 8.48230016469, 0.45}));

TEST(SectionSolver, WarpsAnEllipseByExactlyMinusKxy) {
  // psi is quadratic, so quadratic elements hold it; on points at equal parameter steps the chords spoil
  // nothing (their errors cancel at each point). Only rounding is left.
  constexpr double kRounding = 1e-10;
  const shapes::Outline outline = shapes::ellipse(128, 2.0, 1.0);

  const SectionProperties section = solveSection(outline);

  for (std::size_t i = 0; i < outline.size(); ++i) {
    EXPECT_NEAR(section.outlineWarping[i], -0.6 * outline[i][0] * outline[i][1], kRounding);
  }
  EXPECT_NEAR(section.warpingMin, -0.6, kRounding);
  EXPECT_NEAR(section.warpingMax, 0.6, kRounding);
}

TEST(SectionSolver, DoesNotWarpACircle) {
  const SectionProperties section = solveSection(shapes::circle(128));

  for (const double psi : section.outlineWarping) {
    EXPECT_NEAR(psi, 0.0, 1e-12);
  }
  for (const double shear : section.outlineShear) {
    EXPECT_NEAR(shear, 1.0, kShearTolerance);  // tau = G theta r
  }
}

struct WarpingPoint {
  double halfWidth;  // half height 0.5
  double x, y;
  double psi;
};

class RectangleWarping : public ::testing::TestWithParam<WarpingPoint> {};

TEST_P(RectangleWarping, MatchesTheSeriesInsideAndOnTheOutline) {
  constexpr double kWarpingTolerance =
      2e-4;  // of b^2-sized values; worst at the corners, where psi has a log term
  const WarpingPoint p = GetParam();
  SectionField field;

  static_cast<void>(SectionSolver().solve(shapes::rectangle(2.0 * p.halfWidth, 1.0), {}, &field));

  const auto value = field.at({p.x, p.y});
  ASSERT_TRUE(value.has_value());
  EXPECT_NEAR(value->warping, p.psi, kWarpingTolerance);
}

// psi = xy - (32 a^2 / pi^3) sum over odd n of (-1)^((n-1)/2) n^-3 sinh(n pi y / 2a) / cosh(n pi b / 2a)
// sin(n pi x / 2a).
INSTANTIATE_TEST_SUITE_P(
    Section, RectangleWarping,
    ::testing::Values(
        WarpingPoint{0.5, 0.375, 0.125, 0.008508010492}, WarpingPoint{0.5, 0.25, 0.25, 0.0},
        WarpingPoint{0.5, 0.5, 0.25, 0.03473524529}, WarpingPoint{0.5, 0.5, 0.5, 0.0},
        WarpingPoint{1.0, 0.75, 0.125, -0.05002006381}, WarpingPoint{1.0, 0.5, 0.25, -0.08884180975},
        WarpingPoint{1.0, 1.0, 0.25, -0.07583106369}, WarpingPoint{1.0, 1.0, 0.5, -0.229584593001},
        WarpingPoint{1.5, 1.125, 0.125, -0.1105081783}, WarpingPoint{1.5, 0.75, 0.25, -0.1703705700},
        WarpingPoint{1.5, 1.5, 0.25, -0.2001803767}, WarpingPoint{1.5, 1.5, 0.5, -0.478664382352},
        WarpingPoint{0.75, 0.75, 0.5, -0.108217083178}));

TEST(SectionField, GivesTheStressInsideTheTriangle) {
  // z is the product of the three distances from the sides over the height; tau = 2 (dz/dy, -dz/dx).
  const double side = 1.0, h = side * std::sqrt(3.0) / 2.0;
  SectionField field;
  static_cast<void>(SectionSolver().solve(shapes::equilateralTriangle(side), {}, &field));

  for (const Point2& p : {Point2{0.0, 0.0}, Point2{0.1, -0.05}, Point2{-0.12, 0.1}}) {
    const auto value = field.at(p);
    ASSERT_TRUE(value.has_value());
    // Distances from the sides: d1 = y + h/3, d2,3 = h/3 - y/2 -+ x sqrt(3)/2; z = d1 d2 d3 / h.
    const double d1 = p[1] + h / 3, d2 = h / 3 - p[1] / 2 - p[0] * std::sqrt(3.0) / 2,
                 d3 = h / 3 - p[1] / 2 + p[0] * std::sqrt(3.0) / 2;
    EXPECT_NEAR(value->membrane, d1 * d2 * d3 / h, 1e-5);
    const double dzdx = d1 * std::sqrt(3.0) / 2 * (d2 - d3) / h;
    const double dzdy = (d2 * d3 - d1 * (d2 + d3) / 2) / h;
    EXPECT_NEAR(value->shear[0], 2.0 * dzdy, 3e-3);
    EXPECT_NEAR(value->shear[1], -2.0 * dzdx, 3e-3);
  }
  EXPECT_FALSE(field.at({2.0, 0.0}).has_value());
}

TEST(SectionSolver, CarriesThePlateauOverTheHoleOfATube) {
  for (const double k : {0.3, 0.5, 0.8}) {
    const std::vector<shapes::Outline> hole = {shapes::circle(360, k)};

    const SectionProperties tube = solveSection(shapes::circle(360), {}, hole);

    // 360 points: the polygons make J smaller by 1e-4.
    constexpr double kPolygon = 1.1e-4;
    expectRelative(tube.torsionConstant, kPi / 2 * (1.0 - k * k * k * k), kMeanTolerance + kPolygon, "J");
    expectRelative(tube.sag, (1.0 - k * k) / 4.0, kSagTolerance + kPolygon, "plateau");
    expectRelative(tube.area, kPi * (1.0 - k * k), kPolygon, "area");
    expectRelative(tube.maxShear, 1.0, kShearTolerance, "largest shear");
    for (const double shear : tube.holeShear.at(0)) {
      EXPECT_NEAR(shear, k, 2e-3);
    }
    EXPECT_LE(tube.torsionLower, tube.torsionUpper);
    EXPECT_LE((tube.torsionUpper - tube.torsionLower) / tube.torsionConstant, 2e-4);
  }
}

TEST(SectionSolver, ApproachesBredtsFormulaOnAThinSquareTube) {
  const double thickness = 0.02;  // relative to the middle line of side 1
  const std::vector<shapes::Outline> hole = {shapes::rectangle(1.0 - thickness, 1.0 - thickness)};

  const SectionProperties tube = solveSection(shapes::rectangle(1.0 + thickness, 1.0 + thickness), {}, hole);

  // 4 Am^2 t / perimeter; the corners add terms of relative order t.
  expectRelative(tube.torsionConstant, 4.0 * thickness / 4.0, 1.5 * thickness, "J");
}

TEST(SectionSolver, FindsTrefftzsShearCentreOfAHalfDisc) {
  shapes::Outline half;
  for (int i = 0; i <= 128; ++i) {
    half.push_back({std::cos(kPi * (i / 128.0 - 0.5)), std::sin(kPi * (i / 128.0 - 0.5))});
  }

  const SectionProperties section = solveSection(half);

  EXPECT_NEAR(section.centroid[0], 4.0 / (3.0 * kPi), 1e-4);
  EXPECT_NEAR(section.shearCentre[0], 8.0 / (5.0 * kPi),
              2e-4);  // Timoshenko and Goodier, without Poisson's ratio
  EXPECT_NEAR(section.shearCentre[1], 0.0, 1e-5);
  expectRelative(section.torsionConstant, kPi / 2 - 4.0 / kPi, 4e-4, "J");  // 129 points on the arc
}

TEST(SectionSolver, BracketsTheLShape) {
  // Three unit squares: integral of z = 0.2140758 (benchmark of adaptive finite elements: energy of -lap u =
  // 1 on the L-shape), the re-entrant corner included.
  const shapes::Outline shape = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

  const SectionProperties section = solveSection(shape, {.bracket = 1e-5});

  expectRelative(section.torsionConstant, 4.0 * 0.2140758, 1e-5, "J");
  EXPECT_LE((section.torsionUpper - section.torsionLower) / section.torsionConstant, 1e-5);
}

}  // namespace

namespace {

constexpr int kPoints = 180;

/// A closed curve as kPoints chords of equal length.
std::vector<Point2> outlineOf(const std::function<Point2(double)>& curve) {
  constexpr int kFine = 7200;
  std::vector<Point2> fine;
  std::vector<double> way{0.0};
  for (int i = 0; i <= kFine; ++i) {
    fine.push_back(curve(kTurn * i / kFine));
    if (i > 0) {
      const Point2& a = fine[fine.size() - 2];
      way.push_back(way.back() + std::hypot(fine.back()[0] - a[0], fine.back()[1] - a[1]));
    }
  }
  std::vector<Point2> points;
  std::size_t at = 0;
  for (int k = 0; k < kPoints; ++k) {
    while (way[at + 1] < way.back() * k / kPoints) {
      ++at;
    }
    points.push_back(fine[at]);
  }
  return points;
}

struct Shape {
  std::string name;
  std::function<Point2(double)> curve;
};

Point2 polar(double radius, double stretch, double angle) {
  return {stretch * radius * std::cos(angle), radius * std::sin(angle)};
}

std::vector<Shape> shapes() {
  const auto kidney = [](double a) {
    const double dent = (a - 0.5 * kPi) / 0.45;
    return polar(1.0 - 0.5 * std::exp(-dent * dent), 1.3, a);
  };
  return {
      {"circle", [](double a) { return polar(1.0, 1.0, a); }},
      {"ellipse 1.5:1",
       [](double a) {
         return Point2{1.2247 * std::cos(a), 0.8165 * std::sin(a)};
       }},
      {"ellipse 2:1",
       [](double a) {
         return Point2{1.4142 * std::cos(a), 0.70711 * std::sin(a)};
       }},
      {"bean",
       [](double a) { return polar(1.0 + 0.45 * std::cos(a) * std::cos(a) - 0.35 * std::sin(a), 1.0, a); }},
      {"kidney", kidney}};
}

TEST(WallSection, AgreesWithTheSolverWithAHoleWithinOneInAHundred) {
  for (const Shape& shape : shapes()) {
    const std::vector<Point2> outline = outlineOf(shape.curve);
    const double radius = perimeter(outline) / kTurn;
    for (const double share : {0.02, 0.05, 0.10, 0.20, 0.30}) {
      const double thickness[] = {share * radius};
      const std::vector<std::vector<Point2>> hole{innerOutline(outline, thickness[0])};

      const WallSection wall = wallSection(outline, thickness);

      const SectionProperties solved = solveSection(outline, {}, hole);
      const double tolerance = share <= 0.2 ? 0.005 : 0.0115;  // by the solver 0.0102 at most
      EXPECT_NEAR(wall.torsionConstant / solved.torsionConstant, 1.0, tolerance)
          << shape.name << ' ' << share;
      EXPECT_NEAR(wall.area / solved.area, 1.0, 1e-3) << shape.name << ' ' << share;
    }
  }
}

TEST(WallSection, OfARoundTubeIsTheClosedFormButForTheStrip) {
  // J = 2 pi R^3 t (1 + t^2 / (4 R^2)) exactly; the strip's third in place of a quarter adds t^2 / (12 R^2).
  constexpr int kMany = 2000;
  std::vector<Point2> outline;
  for (int i = 0; i < kMany; ++i) {
    outline.push_back(polar(1.05, 1.0, kTurn * i / kMany));
  }
  const double thickness[] = {0.1};

  const WallSection wall = wallSection(outline, thickness);

  EXPECT_NEAR(wall.radius, 1.0, 1e-5);
  EXPECT_NEAR(wall.torsionConstant, kTurn * 0.1 * (1.0 + 0.01 / 3.0), 2e-5);
  EXPECT_NEAR(wall.area, kTurn * 0.1, 1e-5);
  EXPECT_NEAR(wall.maxShear, 1.0, 0.005);
  EXPECT_NEAR(wall.mostThickness, 1.05, 0.005);
}

TEST(WallSection, TakesAThicknessForEachPoint) {
  // R = 1 on the middle line, t = 0.05 (1 + 0.5 cos): closed integral of ds / t = 2 pi / (0.05 sqrt(1 -
  // 0.25)), of t^3 ds = 2 pi 0.05^3 (1 + 1.5 * 0.25).
  constexpr int kMany = 2000;
  std::vector<Point2> outline;
  std::vector<double> thickness;
  for (int i = 0; i < kMany; ++i) {
    const double angle = kTurn * i / kMany;
    outline.push_back(polar(1.025, 1.0, angle));
    thickness.push_back(0.05 * (1.0 + 0.5 * std::cos(angle)));
  }

  const WallSection wall = wallSection(outline, thickness);

  const double bredt = 4.0 * kPi * kPi / (kTurn / (0.05 * std::sqrt(0.75)));
  const double strip = kTurn * 0.05 * 0.05 * 0.05 * 1.375 / 3.0;
  EXPECT_NEAR(wall.torsionConstant / (bredt + strip), 1.0, 1e-4);
  EXPECT_NEAR(wall.thickest, 0.075, 1e-12);
}

TEST(WallSection, RefusesAWallThatLeavesNoTube) {
  const std::vector<Point2> outline = outlineOf(shapes()[0].curve);
  const auto refused = [&](std::vector<double> thickness) {
    return testing::refusalCode([&] { return wallSection(outline, thickness); }) == ErrorCode::kBadParameter;
  };

  EXPECT_TRUE(refused({0.0}));
  EXPECT_TRUE(refused({-1.0}));
  EXPECT_TRUE(refused({std::nan("")}));
  EXPECT_TRUE(refused({0.4}));  // 0.5 of the middle line's radius
  EXPECT_TRUE(refused({0.1, 0.1}));
  EXPECT_TRUE(refused({1e-320}));
  EXPECT_FALSE(refused({0.3}));
}

TEST(WallSection, RefusesAWallThatIsThickerThanTheSectionIsWide) {
  const std::vector<Point2> flat{{0, 0}, {100, 0}, {100, 2}, {0, 2}};  // its radius is 32
  const double thin[] = {0.9};
  const double thick[] = {1.5};

  EXPECT_LT(wallSection(flat, thin).area, 200.0);
  EXPECT_THROW(static_cast<void>(wallSection(flat, thick)), Error);
}

TEST(WallSection, NamesTheThickestWallThatItTakes) {
  const std::vector<Point2> outline = outlineOf(shapes()[0].curve);
  const double below[] = {0.367};
  const double above[] = {0.368};

  EXPECT_GT(wallSection(outline, below).torsionConstant, 0.0);
  const Error error = testing::refusal([&] { return wallSection(outline, above); });
  EXPECT_NE(error.remedy().find("0.367 here"), std::string::npos) << error.remedy();
}

TEST(WallSection, TakesPointsThatRepeatAsTheSolverDoes) {
  const std::vector<Point2> square{{0, 0}, {0, 0}, {10, 0}, {10, 10}, {10, 10}, {0, 10}};
  const std::vector<Point2> once{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const double each[] = {1.0, 9.0, 1.1, 1.2, 9.0, 1.3};
  const double four[] = {1.0, 1.1, 1.2, 1.3};

  EXPECT_EQ(wallSection(square, each).torsionConstant, wallSection(once, four).torsionConstant);
}

}  // namespace

}  // namespace torsio
