// SPDX-License-Identifier: GPL-3.0-or-later
// The organ's painted skin: its charts, its painting, and that it moves with the organ. No renderer.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <set>
#include <vector>

#include <QColor>
#include <QImage>
#include <QQmlComponent>
#include <QQmlEngine>
#include <QQmlListReference>
#include <gtest/gtest.h>

#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/organ_geometry.h"
#include "app/gui/scene/scene_canvas.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/shear_map.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/angle.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/skin/skin_charts.h"
#include "sim/scene/skin/tissue_skin.h"
#include "sim/scene/skin/vessels.h"
#include "tests/app/gui/support/bar_view.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio::gui {

namespace {

constexpr double kPixel_m = 0.0005;
constexpr int kMaxPixels = 4'000'000;
constexpr double kPolygon_m = 5e-4;  // a bar of 72 flat sides is narrower than a round one by this amount

double signedArea(const SkinCharts& charts, const TriangleMesh::Triangle& t) {
  const auto& a = charts.corners[t[0]].place;
  const auto& b = charts.corners[t[1]].place;
  const auto& c = charts.corners[t[2]].place;
  return 0.5 * static_cast<double>((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

TEST(SurfaceWalk, AStraightPathAroundABarReturnsToItsStart) {
  const Scene bar = barScene();
  const SurfaceWalk walk(bar.mesh);
  std::uint32_t start = 0;
  for (std::uint32_t t = 0; t < bar.mesh.triangles.size(); ++t) {
    const Vec3& p = bar.mesh.vertices_m[bar.mesh.triangles[t][0]];
    if (std::abs(p.z - 0.5 * kBarLength_m) < 0.01 && std::abs(walk.normal(t).z) < 0.1) {
      start = t;
    }
  }
  Vec3 middle_m;
  for (const std::uint32_t v : bar.mesh.triangles[start]) {
    middle_m += bar.mesh.vertices_m[v] / 3.0;
  }
  SurfaceWalker walker{middle_m, {}, start};
  walk.head(walker, cross(Vec3{0, 0, 1}, walk.normal(start)));

  double farthest_m = 0.0;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(walk.step(walker, 2.0 * std::numbers::pi * kBarRadius_m / 1000.0));
    farthest_m = std::max(farthest_m, norm(walker.place_m - middle_m));
  }

  EXPECT_NEAR(norm(walker.place_m - middle_m), 0.0, kPolygon_m);
  EXPECT_NEAR(farthest_m, 2.0 * kBarRadius_m, kPolygon_m);
}

TEST(SkinCharts, EveryTriangleHasItsPlaceAndKeepsItsOrientation) {
  const Scene bar = barScene();

  const SkinCharts charts = layFlat(bar.mesh, kPixel_m, kMaxPixels);

  ASSERT_EQ(charts.triangles.size(), bar.mesh.triangles.size());
  for (std::size_t t = 0; t < charts.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const SkinCharts::Corner& corner = charts.corners[charts.triangles[t][k]];
      EXPECT_EQ(corner.vertex, bar.mesh.triangles[t][k]);
      EXPECT_GE(corner.place[0], static_cast<float>(kChartMargin));
      EXPECT_LE(corner.place[0], static_cast<float>(charts.width - kChartMargin));
      EXPECT_GE(corner.place[1], static_cast<float>(kChartMargin));
      EXPECT_LE(corner.place[1], static_cast<float>(charts.height - kChartMargin));
    }
    EXPECT_GT(signedArea(charts, charts.triangles[t]), 0.0);
  }
  // Few charts: hardly more corners than in the mesh.
  EXPECT_LT(charts.corners.size(), bar.mesh.vertices_m.size() * 13 / 10);
}

TEST(SkinCharts, NoTwoTrianglesShareAPixel) {
  const Scene bar = barScene();
  const SkinCharts charts = layFlat(bar.mesh, kPixel_m, kMaxPixels);
  std::set<std::pair<int, int>> taken;

  for (const TriangleMesh::Triangle& t : charts.triangles) {
    float x = 0.0F;
    float y = 0.0F;
    for (const std::uint32_t corner : t) {
      x += charts.corners[corner].place[0] / 3.0F;
      y += charts.corners[corner].place[1] / 3.0F;
    }
    // The bar's triangles are several pixels wide, so their centres are in different pixels.
    EXPECT_TRUE(taken.emplace(static_cast<int>(x), static_cast<int>(y)).second);
  }
}

TEST(SkinCharts, ALargeSurfaceIsPaintedMoreCoarselyInsteadOfOnALargerMap) {
  const Scene bar = barScene();

  const SkinCharts charts = layFlat(bar.mesh, kPixel_m, 60'000);

  EXPECT_LE(charts.width * charts.height, 60'000);
  EXPECT_GT(charts.pixel_m, kPixel_m);
}

TEST(Vessels, AreOnTheSkinAndNoThickerThanTheMainOnes) {
  const Scene bar = barScene();

  const std::vector<VesselPiece> vessels = growVessels(bar.mesh, bar.lattice(), tissueLook("stomach"));

  ASSERT_GT(vessels.size(), 500U);
  for (const VesselPiece& piece : vessels) {
    const bool onTheEnd = piece.to_m.z < kPolygon_m || piece.to_m.z > kBarLength_m - kPolygon_m;
    if (!onTheEnd) {
      EXPECT_NEAR(std::hypot(piece.to_m.x, piece.to_m.y), kBarRadius_m, kPolygon_m);
    }
    EXPECT_GT(piece.radius_m, 0.0F);
    EXPECT_LE(piece.radius_m, 0.0016F + 1e-6F);
  }
}

TEST(TissueSkin, VariesInColourAndHeightReproduciblyAndDiffersBetweenTissues) {
  const Scene bar = barScene();

  const TissueSkin skin = paintSkin(bar, tissueLook("stomach"));

  EXPECT_EQ(skin.rgba, paintSkin(bar, tissueLook("stomach")).rgba);
  std::set<std::uint8_t> greens;
  std::set<std::uint8_t> heights;
  for (std::size_t i = 0; i < skin.rgba.size(); i += 4) {
    greens.insert(skin.rgba[i + 1]);
    heights.insert(skin.rgba[i + 3]);
    ASSERT_GE(skin.rgba[i], skin.rgba[i + 2]);  // tissue is never bluish
  }
  EXPECT_GT(greens.size(), 40U);
  EXPECT_GT(heights.size(), 40U);
  EXPECT_NE(skin.rgba, paintSkin(bar, tissueLook("forearm")).rgba);
}

/// Colour, 0 to 255, of the skin in the middle of the bar near a ridge angle.
struct MeanColour {
  double green = 0.0;   // mean
  double yellow = 0.0;  // excess of green over blue, at its maximum
};

MeanColour colourAt(const Scene& bar, const TissueSkin& skin, double angle_rad) {
  MeanColour sum;
  int count = 0;
  const auto coordinates = bar.lattice().vertexCoordinates();
  for (std::size_t t = 0; t < bar.mesh.triangles.size(); ++t) {
    float x = 0.0F;
    float y = 0.0F;
    bool near = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const LatticeCoordinate& c = coordinates[bar.mesh.triangles[t][k]];
      const double share = c.arc_m / bar.lattice().length_m();
      near = near && share > 0.3 && share < 0.7 &&
             std::abs(std::remainder(c.angle_rad - angle_rad, kTurn)) < 0.2;
      x += skin.charts.corners[skin.charts.triangles[t][k]].place[0] / 3.0F;
      y += skin.charts.corners[skin.charts.triangles[t][k]].place[1] / 3.0F;
    }
    if (near) {
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(skin.charts.width) +
                         static_cast<std::size_t>(x);
      sum.green += skin.rgba[4 * pixel + 1];
      sum.yellow =
          std::max(sum.yellow, static_cast<double>(skin.rgba[4 * pixel + 1] - skin.rgba[4 * pixel + 2]));
      ++count;
    }
  }
  EXPECT_GT(count, 0);
  return {sum.green / std::max(count, 1), sum.yellow};
}

double greenAt(const Scene& bar, const TissueSkin& skin, double angle_rad) {
  return colourAt(bar, skin, angle_rad).green;
}

TEST(TissueSkin, LinesRunAlongTheOrganSoThatItsTurnIsVisible) {
  const Scene bar = barScene();
  constexpr double kSeen = 12.0;  // of 255: a line distinguishable from its surroundings
  const double apart_rad = kTurn / 4.0;

  const TissueSkin bowel = paintSkin(bar, tissueLook("small-bowel-loop"));
  const double beside = 0.5 * (greenAt(bar, bowel, apart_rad) + greenAt(bar, bowel, -apart_rad));
  EXPECT_GT(greenAt(bar, bowel, 0.0), beside + kSeen);          // opposite the mesentery
  EXPECT_GT(greenAt(bar, bowel, kTurn / 2.0), beside + kSeen);  // its fat

  const TissueSkin colon = paintSkin(bar, tissueLook("sigmoid"));
  for (int taenia = 0; taenia < 3; ++taenia) {
    const double at_rad = taenia * kTurn / 3.0;
    EXPECT_GT(greenAt(bar, colon, at_rad), greenAt(bar, colon, at_rad + kTurn / 12.0) + kSeen) << taenia;
  }

  // Lobules of fat, the yellowest areas, along the curvatures of a stomach.
  const TissueSkin stomach = paintSkin(bar, tissueLook("stomach"));
  const double fat = std::max(colourAt(bar, stomach, 0.0).yellow, colourAt(bar, stomach, kTurn / 2.0).yellow);
  EXPECT_GT(
      fat,
      std::max(colourAt(bar, stomach, apart_rad).yellow, colourAt(bar, stomach, -apart_rad).yellow) + kSeen);
}

TEST(OrganGeometry, RestPositionsStayWhileTheTissueMoves) {
  const Scene bar = barScene();
  const TissueSkin skin = paintSkin(bar, tissueLook("stomach"));
  OrganSurface surface(bar.mesh);
  OrganGeometry geometry;
  geometry.setSurface(surface, &skin);
  const QByteArray before = geometry.vertexData();
  std::vector<Vec3> turned_m;
  for (const Vec3& p : bar.mesh.vertices_m) {
    turned_m.push_back({p.y, -p.x, p.z});
  }

  surface.update(turned_m);
  geometry.updateVertices(surface);

  const QByteArray after = geometry.vertexData();
  ASSERT_EQ(before.size(), after.size());
  ASSERT_EQ(before.size() % static_cast<qsizetype>(sizeof(DrawnVertex)), 0);
  int moved = 0;
  for (qsizetype at = 0; at < before.size(); at += static_cast<qsizetype>(sizeof(DrawnVertex))) {
    DrawnVertex a{};
    DrawnVertex b{};
    std::memcpy(&a, before.constData() + at, sizeof a);
    std::memcpy(&b, after.constData() + at, sizeof b);
    EXPECT_EQ(std::memcmp(a.map, b.map, sizeof a.map), 0);
    EXPECT_EQ(std::memcmp(a.along, b.along, sizeof a.along), 0);
    EXPECT_EQ(std::memcmp(a.rest, b.rest, sizeof a.rest), 0);
    moved += std::abs(a.position[0] - b.position[0]) > 1.0F ? 1 : 0;
  }
  EXPECT_GT(moved, 1000);
}

/// The scene graph without a renderer.
class SceneGraph : public ::testing::Test {
 protected:
  SceneGraph() {
    SceneCanvas::registerTypes();
    QQmlComponent component(&engine_, QUrl(QStringLiteral("qrc:/torsio/scene/scene_view.qml")));
    root_.reset(component.create());
    EXPECT_NE(root_, nullptr) << component.errorString().toStdString();
  }

  QObject* materialOfOrgan() {
    QObject* organ = nullptr;
    for (QObject* child : root_->findChildren<QObject*>()) {
      if (child->objectName() == QLatin1String("organ")) {
        organ = child;
      }
    }
    if (organ == nullptr) {
      return nullptr;
    }
    QQmlListReference materials(organ, "materials");
    return materials.size() == 1 ? materials.at(0) : nullptr;
  }

  QQmlEngine engine_;
  std::unique_ptr<QObject> root_;
};

/// Returns how a custom material is lit: by its own lamps (0) or the scene's (1).
int shading(const QObject* material) {
  return material != nullptr ? material->property("shadingMode").toInt() : -1;
}

TEST_F(SceneGraph, OnlyTheFineLevelEvaluatesLampsAndRoomForEachPixel) {
  ASSERT_NE(root_, nullptr);
  root_->setProperty("fine", false);
  ASSERT_NE(materialOfOrgan(), nullptr);
  EXPECT_EQ(shading(materialOfOrgan()), 0);

  root_->setProperty("fine", true);
  EXPECT_EQ(shading(materialOfOrgan()), 1);
}

TEST_F(SceneGraph, TheFastLevelDrawsSoftEdgesDirectlyIntoTheWindowAndTheFineOneNeedsNone) {
  ASSERT_NE(root_, nullptr);
  const auto shown = [this](const char* name) {
    const QObject* model = root_->findChild<QObject*>(QLatin1String(name));
    return model != nullptr && model->property("visible").toBool();
  };
  EXPECT_TRUE(shown("organEdge"));
  EXPECT_TRUE(shown("solidEdge"));

  root_->setProperty("fine", true);
  EXPECT_FALSE(shown("organEdge"));
  EXPECT_FALSE(shown("solidEdge"));
}

TEST_F(SceneGraph, EverySolidDefinesColourAndKindOfItsEdge) {
  ASSERT_NE(root_, nullptr);
  const QVariantList solids = root_->property("solids").toList();
  EXPECT_EQ(solids.size(), 11);
  for (const QVariant& entry : solids) {
    const auto* model = entry.value<QObject*>();
    ASSERT_NE(model, nullptr);
    EXPECT_TRUE(model->property("colour").value<QColor>().isValid());
    EXPECT_TRUE(model->property("surface").isValid());
    EXPECT_NE(model->property("geometry").value<InstrumentGeometry*>(), nullptr);
  }
}

TEST_F(SceneGraph, NothingIsPaintedOverTheStressMapAtAnyLevel) {
  ASSERT_NE(root_, nullptr);
  root_->setProperty("stressVisible", true);

  for (const bool fine : {false, true}) {
    root_->setProperty("fine", fine);
    ASSERT_NE(materialOfOrgan(), nullptr);
    EXPECT_EQ(shading(materialOfOrgan()), 0);
    EXPECT_FALSE(materialOfOrgan()->property("skinMap").isValid());
  }
}

TEST(StressLegend, ShowsTheColoursOfTheMapUnmixed) {
  StressLegend legend;
  legend.setTheme(theme(ThemeKind::kLight));
  legend.setTop(2000.0);
  legend.resize(legend.sizeHint());

  const QImage picture = legend.grab().toImage();

  // The two ends of cividis: (0, 0.135, 0.305) and (0.995, 0.909, 0.218).
  bool dark = false;
  bool yellow = false;
  for (int y = 0; y < picture.height(); ++y) {
    const QColor c = picture.pixelColor(kSpace + 5, y);
    dark = dark || (c.red() == 0 && std::abs(c.green() - 34) <= 1 && std::abs(c.blue() - 78) <= 1);
    yellow = yellow ||
             (std::abs(c.red() - 254) <= 1 && std::abs(c.green() - 232) <= 1 && std::abs(c.blue() - 56) <= 1);
  }
  EXPECT_TRUE(dark);
  EXPECT_TRUE(yellow);
}

using Factors = std::vector<std::array<float, 3>>;

std::shared_ptr<const Scene> twistedScene() {
  static const auto kScene = std::make_shared<const Scene>(hollowScene(twistedTube()));
  return kScene;
}

Factors factorsOf(const OrganState& state) {
  Factors factors(twistedScene()->mesh.vertices_m.size());
  BloodMap(twistedScene()).evaluate(state, factors);
  return factors;
}

// Returns the vertex whose arc length is nearest to a fraction of the length.
std::size_t vertexAt(double share) {
  const auto& vertices = twistedScene()->model.tables().vertices;
  std::size_t best = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const auto miss = [&](std::size_t i) {
      return std::abs(vertices[i].arc_m - share * twistedScene()->lattice().length_m());
    };
    best = miss(v) < miss(best) ? v : best;
  }
  return best;
}

TEST(BloodMap, DoesNotChangeAnOrganThatIsNotHollow) {
  EXPECT_TRUE(BloodMap(std::make_shared<const Scene>(barScene())).empty());
}

TEST(BloodMap, HealthyTissueKeepsItsColour) {
  OrganState state = twistedScene()->stateAt(0.0);
  state.hollow.saturation = 0.78;

  for (const auto& factor : factorsOf(state)) {
    for (const float channel : factor) {
      EXPECT_NEAR(channel, 1.0F, 1e-3F);
    }
  }
}

TEST(BloodMap, CongestedBloodIsPurpleOnlyBeyondTheHeldSection) {
  OrganState state = twistedScene()->stateAt(0.0);
  state.hollow.congestion = 1.0;
  state.hollow.reading.flow = 0.3;

  const Factors factors = factorsOf(state);

  const auto& twisted = factors[vertexAt(0.9)];
  EXPECT_LT(twisted[1], 0.6F * twisted[0] + 0.1F);
  EXPECT_LT(twisted[1], twisted[2]);
  EXPECT_EQ(factors[vertexAt(0.0)], (std::array<float, 3>{1.0F, 1.0F, 1.0F}));
}

TEST(BloodMap, AMarkIsDarkOnlyWhereTheJawWas) {
  const std::size_t there = vertexAt(0.5);
  const auto& vertex = twistedScene()->model.tables().vertices[there];
  OrganState state = twistedScene()->stateAt(0.0);
  const Factors before = factorsOf(state);
  state.hollow.markCount = 1;
  state.hollow.marks[0].arc_m = vertex.arc_m;
  state.hollow.marks[0].round_rad = twistedScene()->lattice().vertexCoordinates()[there].angle_rad;

  const Factors after = factorsOf(state);

  EXPECT_LT(after[there][1], 0.5F * before[there][1]);
  EXPECT_EQ(after[vertexAt(0.9)], before[vertexAt(0.9)]);
}

TEST(BloodMap, AClipIsVisibleWhereItHolds) {
  OrganState state = twistedScene()->stateAt(0.0);
  const Factors open = factorsOf(state);
  state.hollow.clipped = true;

  EXPECT_NE(factorsOf(state), open);
}

TEST(ShearMap, OfATwistedOrganEndsAtTheLargestShearOnTheWay) {
  const ShearMap map(twistedScene());

  EXPECT_GT(map.top_Pa(), twistedScene()->peakShear_Pa(twistedScene()->stateAt(radians(45.0))));
  EXPECT_LT(map.top_Pa(), 1e5);
}

}  // namespace

}  // namespace torsio::gui
