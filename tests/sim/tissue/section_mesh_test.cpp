// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons and the meshes cut from them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/tissue/section/plane_mesh.h"
#include "sim/tissue/section/polygon.h"
#include "sim/tissue/section/section_outline.h"
#include "sim/tissue/section/section_solver.h"
#include "tests/sim/tissue/section_shapes.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

TEST(Polygon, MomentsAreThoseOfTheRectangleWhereverItLies) {
  const PolygonMoments m = polygonMoments(shapes::moved(shapes::rectangle(2.0, 1.0), 1.0, {1000.0, -500.0}));

  EXPECT_DOUBLE_EQ(m.area, 2.0);
  EXPECT_DOUBLE_EQ(m.centroid[0], 1000.0);
  EXPECT_DOUBLE_EQ(m.centroid[1], -500.0);
  EXPECT_NEAR(m.xx, 2.0 * 1.0 * 4.0 / 12.0, 1e-12);  // b h^3 / 12
  EXPECT_NEAR(m.yy, 2.0 * 1.0 / 12.0, 1e-12);
  EXPECT_NEAR(m.xy, 0.0, 1e-12);
}

TEST(Polygon, MomentsOfARightTriangleHaveTheirProduct) {
  const PolygonMoments m = polygonMoments(shapes::Outline{{0, 0}, {3, 0}, {0, 2}});

  EXPECT_DOUBLE_EQ(m.area, 3.0);
  EXPECT_NEAR(m.xx, 3.0 * 9.0 / 18.0, 1e-14);         // A b^2 / 18
  EXPECT_NEAR(m.yy, 3.0 * 4.0 / 18.0, 1e-14);         // A h^2 / 18
  EXPECT_NEAR(m.xy, -3.0 * 3.0 * 2.0 / 36.0, 1e-14);  // -A b h / 36
  EXPECT_LT(polygonMoments(shapes::Outline{{0, 0}, {0, 2}, {3, 0}}).area, 0.0);
}

TEST(Polygon, FindsCrossingsAndTouchesAndNothingElse) {
  EXPECT_FALSE(firstSelfCrossing(shapes::kidney(200)));
  EXPECT_FALSE(
      firstSelfCrossing(shapes::Outline{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}));  // straight on is no fault
  EXPECT_EQ(firstSelfCrossing(shapes::Outline{{0, 0}, {1, 1}, {1, 0}, {0, 1}}), (std::pair{0, 2}));
  EXPECT_TRUE(
      firstSelfCrossing(shapes::Outline{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));  // a point on an edge
  EXPECT_TRUE(firstCrossing(shapes::circle(20), shapes::circle(20, 1.0, {1.0, 0.0})));
  EXPECT_FALSE(firstCrossing(shapes::circle(20), shapes::circle(20, 0.5)));
}

TEST(Polygon, TellsStarShapedFromOthers) {
  EXPECT_GT(grazingSine(shapes::circle(32), {0.0, 0.0}), 0.9);
  EXPECT_LE(grazingSine(shapes::kidney(100), polygonMoments(shapes::kidney(100)).centroid), 0.0);
  EXPECT_LT(grazingSine(shapes::circle(32), {1.5, 0.0}), 0.0);
}

double areaOf(const PlaneMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += 0.5 * orientation(mesh.points[static_cast<std::size_t>(t[0])],
                             mesh.points[static_cast<std::size_t>(t[1])],
                             mesh.points[static_cast<std::size_t>(t[2])]);
  }
  return sum;
}

/// Every triangle anticlockwise, neighbours mutual over the same edge, boundary edges on one loop.
void expectConforming(const PlaneMesh& mesh) {
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto& corners = mesh.triangles[static_cast<std::size_t>(t)];
    EXPECT_GT(orientation(mesh.points[static_cast<std::size_t>(corners[0])],
                          mesh.points[static_cast<std::size_t>(corners[1])],
                          mesh.points[static_cast<std::size_t>(corners[2])]),
              0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
      const int other = mesh.neighbours[static_cast<std::size_t>(t)][k];
      if (other < 0) {
        EXPECT_GE(mesh.loop[static_cast<std::size_t>(a)], 0);
        EXPECT_EQ(mesh.loop[static_cast<std::size_t>(a)], mesh.loop[static_cast<std::size_t>(b)]);
        continue;
      }
      const auto& beyond = mesh.neighbours[static_cast<std::size_t>(other)];
      const auto back = static_cast<std::size_t>(std::find(beyond.begin(), beyond.end(), t) - beyond.begin());
      ASSERT_LT(back, 3U);
      EXPECT_EQ(mesh.triangles[static_cast<std::size_t>(other)][(back + 1) % 3], b);
      EXPECT_EQ(mesh.triangles[static_cast<std::size_t>(other)][(back + 2) % 3], a);
    }
  }
}

/// Smallest angle of the mesh in degrees.
double smallestAngle(const PlaneMesh& mesh) {
  double least = 180.0;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2& a = mesh.points[static_cast<std::size_t>(t[k])];
      const Point2& b = mesh.points[static_cast<std::size_t>(t[(k + 1) % 3])];
      const Point2& c = mesh.points[static_cast<std::size_t>(t[(k + 2) % 3])];
      const double dot = (b[0] - a[0]) * (c[0] - a[0]) + (b[1] - a[1]) * (c[1] - a[1]);
      least = std::min(least, degrees(std::atan2(orientation(a, b, c), dot)));
    }
  }
  return least;
}

TEST(PolarMesh, FillsAStarShapedSectionWithFewerRaysInside) {
  for (const auto& outline : {shapes::circle(128), shapes::organ(97), shapes::rectangle(1.0, 1.0)}) {
    const SectionShape shape = prepareSection(outline, {}, 128);

    const PlaneMesh mesh = polarMesh(shape.outline.boundary, {}, 8);

    expectConforming(mesh);
    EXPECT_NEAR(areaOf(mesh), 1.0, 1e-12);  // sections are scaled to area 1
    EXPECT_LT(mesh.points.size(), 4 * shape.outline.boundary.points.size());
    EXPECT_GT(smallestAngle(mesh), 8.0);
  }
}

TEST(PolarMesh, KeepsItsRaysWhereANotchForbidsToLeaveThemOut) {
  Random random(21);
  for (int k = 0; k < 20; ++k) {
    const SectionShape shape = prepareSection(shapes::randomStar(random, 12), {}, 128);
    if (grazingSine(shape.outline.boundary.points, {}) < 0.05) {
      continue;
    }

    const PlaneMesh mesh = polarMesh(shape.outline.boundary, {}, 8);

    expectConforming(mesh);
    EXPECT_NEAR(areaOf(mesh), 1.0, 1e-12);
  }
}

TEST(PolygonMesh, FillsAnySectionWithWellShapedTriangles) {
  const std::vector<shapes::Outline> holes = {shapes::circle(40, 0.2, {0.5, 0.0}),
                                              shapes::circle(40, 0.25, {-0.4, 0.3})};
  struct Filled {
    shapes::Outline outline;
    std::vector<shapes::Outline> holes;
    double angle;
  };
  for (const Filled& c : {Filled{shapes::kidney(150), {}, 15.0}, Filled{shapes::organ(128), holes, 15.0},
                          Filled{shapes::circle(100), {shapes::circle(100, 0.9)}, 15.0},
                          Filled{shapes::rectangle(20.0, 1.0), {}, 15.0}}) {
    const SectionShape shape = prepareSection(c.outline, c.holes, 128);
    std::vector<BoundaryLoop> loops;
    for (const SampledLoop& hole : shape.holes) {
      loops.push_back(hole.boundary);
    }

    const auto mesh = polygonMesh(shape.outline.boundary, loops);

    ASSERT_TRUE(mesh.has_value());
    expectConforming(*mesh);
    EXPECT_NEAR(areaOf(*mesh), shape.area, 1e-12);
    EXPECT_GT(smallestAngle(*mesh), c.angle);
    std::size_t boundary = shape.outline.boundary.points.size(), edges = 0;
    for (const BoundaryLoop& loop : loops) {
      boundary += loop.points.size();
    }
    for (const auto& n : mesh->neighbours) {
      edges += static_cast<std::size_t>(std::count(n.begin(), n.end(), -1));
    }
    EXPECT_EQ(edges, boundary);  // no boundary edge was split or lost
  }
}

TEST(PolygonMesh, SurvivesRandomPolygons) {
  Random random(22);
  for (int k = 0; k < 40; ++k) {
    const SectionShape shape =
        prepareSection(shapes::randomSimple(random, 8 + k % 20, k % 3 == 0 ? 0.2 : 1.0), {}, 128);

    const auto mesh = polygonMesh(shape.outline.boundary, {});

    ASSERT_TRUE(mesh.has_value());
    expectConforming(*mesh);
    EXPECT_NEAR(areaOf(*mesh), 1.0, 1e-11);
  }
}

TEST(Bisection, KeepsTheMeshConformingAndTheAnglesAboveHalf) {
  const SectionShape shape = prepareSection(shapes::kidney(100), {}, 100);
  auto mesh = polygonMesh(shape.outline.boundary, {});
  ASSERT_TRUE(mesh.has_value());
  const double angle = smallestAngle(*mesh);
  Random random(23);

  for (int round = 0; round < 6; ++round) {
    std::vector<char> marked(mesh->triangles.size(), 0);
    for (char& m : marked) {
      m = random.uniform() < 0.2 ? 1 : 0;
    }
    const std::size_t before = mesh->triangles.size();
    bisect(*mesh, marked);
    EXPECT_GE(mesh->triangles.size(),
              before + static_cast<std::size_t>(std::count(marked.begin(), marked.end(), 1)) / 2);
  }

  expectConforming(*mesh);
  EXPECT_NEAR(areaOf(*mesh), 1.0, 1e-12);
  EXPECT_GE(smallestAngle(*mesh), 0.5 * angle * (1.0 - 1e-9));
  // New boundary points know their way along the outline: the way and the place agree.
  const BoundaryLoop& loop = shape.outline.boundary;
  for (std::size_t i = 0; i < mesh->points.size(); ++i) {
    if (mesh->loop[i] < 0) {
      continue;
    }
    const auto after = std::upper_bound(loop.arc.begin(), loop.arc.end(), mesh->arc[i]);
    const auto k = static_cast<std::size_t>(after - loop.arc.begin()) - 1;
    const Point2& a = loop.points[k];
    EXPECT_NEAR(std::hypot(mesh->points[i][0] - a[0], mesh->points[i][1] - a[1]), mesh->arc[i] - loop.arc[k],
                1e-12);
  }
}

using ::testing::HasSubstr;

using testing::refusal;

Error refusalOf(const shapes::Outline& outline, const std::vector<shapes::Outline>& holes = {}) {
  const Error error = refusal([&] { static_cast<void>(solveSection(outline, {}, holes)); });
  EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
  EXPECT_FALSE(error.remedy().empty());
  return error;
}

TEST(SectionInput, RefusesFewerThanThreePoints) {
  const Error error = refusalOf({{0, 0}, {1, 0}});

  EXPECT_THAT(error.happened(), HasSubstr("at least 3 points, this one has 2"));
  EXPECT_EQ(error.where(), "outline");
}

TEST(SectionInput, RefusesNumbersThatAreNotFiniteAndNamesThePoint) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Error error = refusalOf({{0, 0}, {1, 0}, {1, bad}, {0, 1}});

    EXPECT_THAT(error.happened(), HasSubstr("not a finite number"));
    EXPECT_EQ(error.where(), "outline, point 3");
  }
}

TEST(SectionInput, NamesTheEdgesThatCross) {
  const Error bowTie = refusalOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  EXPECT_THAT(bowTie.happened(), HasSubstr("edge 1 (points 1 and 2) and edge 3 (points 3 and 4)"));

  // The edge that closes the outline runs from the last point to the first.
  const Error closing = refusalOf({{0, 0}, {2, 0}, {2, 2}, {1, -1}, {0, 2}, {3, 1}});
  EXPECT_THAT(closing.happened(), HasSubstr("crosses or touches itself"));

  const Error back = refusalOf({{0, 0}, {2, 0}, {1, 0}, {1, 1}});
  EXPECT_THAT(back.happened(), HasSubstr("edge 1 (points 1 and 2) and edge 2 (points 2 and 3)"));

  const Error touching = refusalOf({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}});
  EXPECT_THAT(touching.happened(), HasSubstr("crosses or touches itself"));
}

TEST(SectionInput, RefusesSectionsWithoutArea) {
  EXPECT_THAT(refusalOf({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).happened(), HasSubstr("no area"));
  EXPECT_THAT(refusalOf({{1, 1}, {1, 1}, {1, 1}}).happened(), HasSubstr("no area"));
  EXPECT_THAT(refusalOf(shapes::rectangle(1.0, 1e-7)).happened(), HasSubstr("too thin"));
}

TEST(SectionInput, RefusesHolesThatAreNotInside) {
  const shapes::Outline square = shapes::rectangle(2, 2);
  EXPECT_THAT(refusalOf(square, {shapes::circle(16, 0.5, {0.8, 0})}).happened(),
              HasSubstr("crosses or touches the outline"));
  EXPECT_THAT(refusalOf(square, {shapes::circle(16, 0.5, {3, 0})}).happened(),
              HasSubstr("outside the outline"));
  const Error overlap = refusalOf(square, {shapes::circle(16, 0.5), shapes::circle(16, 0.2, {0.4, 0})});
  EXPECT_THAT(overlap.happened(), HasSubstr("hole 1 and hole 2"));
  const Error inside = refusalOf(square, {shapes::circle(16, 0.5), shapes::circle(16, 0.2)});
  EXPECT_THAT(inside.happened(), HasSubstr("hole 1 and hole 2"));
  EXPECT_EQ(refusalOf(square, {{{0, 0}, {0.1, 0}}}).where(), "hole 1");
}

TEST(SectionInput, RefusesOptionsOutOfRange) {
  const auto with = [](const SectionSolverOptions& options) {
    return refusal([&] { const SectionSolver solver(options); }).happened();
  };
  EXPECT_THAT(with({.outlinePoints = 2}), HasSubstr("outlinePoints"));
  EXPECT_THAT(with({.rings = 0}), HasSubstr("rings"));
  EXPECT_THAT(with({.bracket = std::numeric_limits<double>::quiet_NaN()}), HasSubstr("bracket"));
  EXPECT_THAT(with({.maxNodes = 0}), HasSubstr("maxNodes"));
}

class OutlineFile : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    return file_;
  }
  void TearDown() override { std::filesystem::remove(file_); }

  Error refusalOfText(const std::string& text) const {
    write(text);
    return refusal([this] { static_cast<void>(readOutline(file_)); });
  }

  std::filesystem::path file_ = std::filesystem::temp_directory_path() /
                                (std::string("torsio_outline_") +
                                 ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv");
};

TEST_F(OutlineFile, ReadsPointsCommentsHeaderAndClosedOutlines) {
  const std::vector<Point2> points = readOutline(
      write("\xEF\xBB\xBF# made by hand\r\nx,y\r\n0,0\r\n 1.5 , -2e-1\r\n\r\n# half way\n+3;4\n0,0\n"));

  EXPECT_EQ(points, (std::vector<Point2>{{0, 0}, {1.5, -0.2}, {3, 4}}));
}

TEST_F(OutlineFile, NamesTheLineThatIsWrong) {
  const Error text = refusalOfText("0,0\n1,zero\n1,1\n");
  EXPECT_EQ(text.code(), ErrorCode::kBadData);
  EXPECT_THAT(text.happened(), HasSubstr("'zero' is not a number"));
  EXPECT_THAT(text.where(), HasSubstr("line 2"));

  EXPECT_THAT(refusalOfText("x,y\n0,0\n1,0,0\n").where(), HasSubstr("line 3"));
  EXPECT_THAT(refusalOfText("0,0\n1\n").happened(), HasSubstr("expected 2 values, found 1"));
  EXPECT_THAT(refusalOfText("0,0\nnan,1\n").happened(), HasSubstr("not a finite number"));
  EXPECT_THAT(refusalOfText("0,0\n1e999,1\n").happened(), HasSubstr("not a number"));
  // Only one line of names, and only before the points.
  EXPECT_THAT(refusalOfText("x,y\nmm,mm\n0,0\n").where(), HasSubstr("line 2"));
  EXPECT_THAT(refusalOfText("0,0\nx,y\n").where(), HasSubstr("line 2"));
}

TEST_F(OutlineFile, RefusesFilesWithoutASection) {
  EXPECT_THAT(refusalOfText("").happened(), HasSubstr("this file has 0"));
  EXPECT_THAT(refusalOfText("0,0\n1,0\n0,0\n").happened(), HasSubstr("this file has 2"));
  std::filesystem::remove(file_);
  EXPECT_EQ(refusal([this] { static_cast<void>(readOutline(file_)); }).code(), ErrorCode::kFileMissing);
  EXPECT_EQ(refusal([] { static_cast<void>(readOutline(std::filesystem::temp_directory_path())); }).code(),
            ErrorCode::kFileUnreadable);
}

}  // namespace
}  // namespace torsio
