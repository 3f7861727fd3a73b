// SPDX-License-Identifier: GPL-3.0-or-later
// The inputs of the scene's drawing: camera, frames, skin, lines, light. No renderer.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/gui/scene/continuation.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/orbit_camera.h"
#include "app/gui/scene/organ_shadow.h"
#include "app/gui/scene/organ_surface.h"
#include "app/gui/scene/outline.h"
#include "app/gui/scene/skin_overlays.h"
#include "app/gui/scene/studio_light.h"
#include "app/gui/scene/surroundings.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/error.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/scene/tissue_look.h"
#include "tests/app/gui/support/bar_view.h"

namespace torsio::gui {
namespace {

const QSizeF kView(960.0, 680.0);
constexpr double kPixel = 1e-2;       // single precision over a distance of half a metre
constexpr double kMillimetre = 1e-3;  // the same
constexpr double kSingle = 1e-5;

void expectNear(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(ViewFrame, ShowsThePatientUprightAndFacingTheViewer) {
  EXPECT_EQ(toView({0.001, 0.0, 0.0}), QVector3D(1, 0, 0));   // the patient's left at the viewer's right
  EXPECT_EQ(toView({0.0, 0.0, 0.001}), QVector3D(0, 1, 0));   // the head on top
  EXPECT_EQ(toView({0.0, -0.001, 0.0}), QVector3D(0, 0, 1));  // the front towards the viewer
}

TEST(Surroundings, MatchTheOrganAndNeverLookLikeTissue) {
  EXPECT_EQ(surroundingsOf("forearm"), Surroundings::kArm);
  EXPECT_EQ(surroundingsOf("testis"), Surroundings::kDrape);
  EXPECT_EQ(surroundingsOf("a mesh of one's own"), Surroundings::kDrape);
  EXPECT_EQ(surroundingsOf("stomach"), Surroundings::kStomach);
  EXPECT_EQ(surroundingsOf("gastric-organo-axial"), Surroundings::kStomach);
  EXPECT_EQ(surroundingsOf("gastric-mesentero-axial"), Surroundings::kStomach);
  EXPECT_EQ(surroundingsOf("stomach", true), Surroundings::kBareStomach);
  EXPECT_EQ(surroundingsOf("gastric-mesentero-axial", true), Surroundings::kBareTurnedAntrum);
  EXPECT_EQ(surroundingsOf("sigmoid"), Surroundings::kPelvis);
  EXPECT_EQ(surroundingsOf("midgut"), Surroundings::kMidgut);
  EXPECT_EQ(surroundingsOf("midgut", true), Surroundings::kIntestine);
  EXPECT_EQ(surroundingsOf("small-bowel-loop"), Surroundings::kClosedLoop);
  EXPECT_EQ(surroundingsOf("small-bowel-loop", true), Surroundings::kBowelLoop);

  for (const ThemeKind kind : {ThemeKind::kLight, ThemeKind::kDark}) {
    std::vector<QImage> pictures;
    for (const Surroundings around :
         {Surroundings::kDrape, Surroundings::kArm, Surroundings::kStomach, Surroundings::kBareStomach,
          Surroundings::kBareTurnedAntrum, Surroundings::kIntestine, Surroundings::kBowelLoop,
          Surroundings::kClosedLoop, Surroundings::kMidgut, Surroundings::kPelvis}) {
      const QImage picture = paintSurroundings(around, theme(kind));
      int reddish = 0;
      for (int y = 0; y < picture.height(); y += 4) {
        for (int x = 0; x < picture.width(); x += 4) {
          const QColor c = picture.pixelColor(x, y);
          reddish += c.red() > c.blue() + 25 ? 1 : 0;  // only the organ looks like tissue
        }
      }
      EXPECT_EQ(reddish, 0);
      EXPECT_EQ(picture, paintSurroundings(around, theme(kind)));
      for (const QImage& other : pictures) {
        EXPECT_NE(picture, other);
      }
      pictures.push_back(picture);
    }
  }
}

/// Returns the centre of a shadow, in pixels right of and above the middle, and its total.
std::array<double, 3> momentOf(std::span<const std::uint8_t> shade) {
  constexpr int kSide = OrganShadow::kSide_px;
  std::array<double, 3> sum{};
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const double taken = shade[static_cast<std::size_t>(row * kSide + column)];
      sum[0] += taken * (column - 0.5 * kSide);
      sum[1] += taken * (row - 0.5 * kSide);
      sum[2] += taken;
    }
  }
  return {sum[0] / sum[2], sum[1] / sum[2], sum[2]};
}

/// A scene in its initial front view, on a thousand pixels.
class FromTheFront {
 public:
  explicit FromTheFront(const char* id) {
    SceneRequest request;
    request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
    request.id = id;
    const Scene scene = loadScene(request);
    low_ = toView(scene.mesh.vertices_m.front());
    QVector3D high = low_;
    for (const Vec3& v : scene.mesh.vertices_m) {
      const QVector3D p = toView(v);
      for (int k = 0; k < 3; ++k) {
        low_[k] = std::min(low_[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    centre_ = 0.5F * (low_ + high);
    radius_ = 0.5F * (high - low_).length();
    camera_.frame(centre_, radius_, kSize);
  }
  /// Returns the distance in pixels between a place on the square behind the organ, in radii, and a place of
  /// the organ.
  [[nodiscard]] double between(const QPointF& painted, const Vec3& organ_m) const {
    const QVector3D behind(centre_.x() + radius_ * static_cast<float>(painted.x()),
                           centre_.y() + radius_ * static_cast<float>(painted.y()),
                           low_.z() - 0.12F * radius_);
    const QPointF a = camera_.pixel(behind, kSize);
    const QPointF b = camera_.pixel(toView(organ_m), kSize);
    return std::hypot(a.x() - b.x(), a.y() - b.y());
  }

 private:
  const QSizeF kSize{1000.0, 1000.0};
  QVector3D low_;
  QVector3D centre_;
  float radius_ = 0.0F;
  OrbitCamera camera_;
};

/// An end of an organ at rest, and where what is painted behind it goes on.
struct PaintedJoint {
  QPointF painted;
  Vec3 end_m;
};

// Ends of centre lines, from assets/organs/README.md, sim/anatomy and assets/scenes.
std::vector<PaintedJoint> paintedJoints(const std::string& id) {
  if (id == "intestine") {
    return {{kLoopFirstFoot, {0.086, -0.004, -0.003}}, {kLoopSecondFoot, {-0.086, 0.0, -0.003}}};
  }
  if (id == "small-bowel-loop") {
    return {{kClosedFirstFoot, {0.016, 0.0, -0.003}}, {kClosedSecondFoot, {-0.016, 0.0, -0.003}}};
  }
  if (id == "sigmoid") {
    return {{kDescendingEnd, {0.028, 0.0, 0.0}}, {kRectumEnd, {-0.028, 0.0, 0.0}}};
  }
  if (id == "midgut") {
    return {{kStalkRoot, {0.0, 0.052, 0.050}}, {kLimbEnd, {-0.021, 0.058, 0.056}}};
  }
  return {};
}

/// The angles at which an organ is looked at: rest, half-way and the target; of one that comes twisted both
/// ways.
std::vector<double> lookedAt(const Scene& scene) {
  if (!scene.hollow) {
    return {0.0, 0.5 * scene.pattern.targetAngle_rad, scene.pattern.targetAngle_rad};
  }
  const double most_rad = scene.hollow->detorsion().start.most_rad;
  return {0.0, 0.5 * most_rad, -0.5 * most_rad, most_rad, -most_rad};
}

/// Mean of the organ's vertices that lie within some millimetres of a place at rest.
Vec3 endAt_m(const Scene& scene, const std::vector<Vec3>& now_m, const Vec3& rest_m) {
  constexpr double kNear_m = 0.012;
  Vec3 sum_m;
  double count = 0.0;
  for (std::size_t i = 0; i < now_m.size(); ++i) {
    if (norm(scene.mesh.vertices_m[i] - rest_m) < kNear_m) {
      sum_m += now_m[i];
      count += 1.0;
    }
  }
  return sum_m / count;
}

TEST(Joints, WhatIsPaintedGoesOnWhereTheOrganEnds) {
  constexpr double kHalfATube = 50.0;  // pixels
  for (const char* id : {"intestine", "small-bowel-loop", "sigmoid", "midgut"}) {
    const FromTheFront front(id);
    for (const PaintedJoint& joint : paintedJoints(id)) {
      EXPECT_LT(front.between(joint.painted, joint.end_m), kHalfATube) << id;
    }
  }
}

TEST(Joints, HoldOnAtEveryAngleOfEveryPattern) {
  constexpr double kHeld_m = 0.004;        // of an end whose other side is painted
  constexpr double kIntoTheEnd_m = 0.009;  // from the ring at which a tube begins to the middle of the end
  const std::filesystem::path assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  const std::array<Vec3, 2> tips_m{Vec3{0.002, 0.019, 0.072}, Vec3{-0.0585, 0.016, -0.0545}};
  for (const std::string& id : sceneIds(assets)) {
    for (const std::string& pattern : patternIds(assets, id)) {
      SceneRequest request;
      request.assets = assets;
      request.id = id;
      request.pattern = pattern;
      const auto scene = std::make_shared<const Scene>(loadScene(request));
      const std::vector<Continuation> open = stomachContinuations(*scene);
      const bool stomach = surroundingsOf(id) == Surroundings::kStomach;
      ASSERT_EQ(open.size(), stomach ? 2U : 0U) << id;
      ContinuationGeometry tubes;
      OrganSurface surface(scene->mesh);
      tubes.join(open, {{}, 140.0F}, surface);
      for (const double angle_rad : lookedAt(*scene)) {
        SCOPED_TRACE(id + ", " + pattern + " " + std::to_string(angle_rad));
        std::vector<Vec3> now_m(scene->mesh.vertices_m.size());
        scene->deform(scene->stateAt(angle_rad), now_m);
        surface.update(now_m);
        tubes.follow(surface);
        for (std::size_t i = 0; i < open.size(); ++i) {
          const double gap_m =
              1e-3 *
              static_cast<double>((tubes.endsOf(i)[0] - toView(endAt_m(*scene, now_m, tips_m[i]))).length());
          EXPECT_LT(gap_m, kIntoTheEnd_m) << i;
          EXPECT_LT((tubes.endsOf(i)[1] - PaintedGround{{}, 140.0F}.at(open[i].painted)).length(), 15.0F)
              << i;
        }
        for (const PaintedJoint& joint : paintedJoints(id)) {
          const Vec3 rest_m = endAt_m(*scene, scene->mesh.vertices_m, joint.end_m);
          EXPECT_LT(norm(endAt_m(*scene, now_m, joint.end_m) - rest_m), kHeld_m);
        }
      }
    }
  }
}

TEST(OrganShadow, FallsToTheLowerRightIsSoftAndFollowsTheOrgan) {
  const TriangleMesh bar = testing::loadBar({}).scene->mesh;
  OrganSurface organ(bar);
  QVector3D low(1e9F, 1e9F, 1e9F);
  QVector3D high = -low;
  for (const SurfaceVertex& v : organ.vertices()) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v.position[k]);
      high[k] = std::max(high[k], v.position[k]);
    }
  }
  const float radius_mm = 0.5F * (high - low).length();
  OrganShadow shadow(0.5F * (low + high), radius_mm, low.z() - 0.12F * radius_mm);

  const std::span<const std::uint8_t> shade = shadow.cast(organ);

  const std::array<double, 3> rest = momentOf(shade);
  EXPECT_GT(rest[0], 1.0);
  EXPECT_LT(rest[1], -1.0);
  int steepest = 0;
  for (std::size_t i = 1; i < shade.size(); ++i) {
    steepest = std::max(steepest, std::abs(shade[i] - shade[i - 1]));
  }
  EXPECT_LT(steepest, 80);  // of 255: no sharp edge

  std::vector<Vec3> moved_m = bar.vertices_m;
  for (Vec3& p : moved_m) {
    p.x += 0.3e-3 * static_cast<double>(radius_mm);
  }
  organ.update(moved_m);
  const std::array<double, 3> moved = momentOf(shadow.cast(organ));
  const double pixels = 0.3 * OrganShadow::kSide_px / (2.0 * static_cast<double>(kShadowReach));
  EXPECT_NEAR(moved[0] - rest[0], pixels, 0.6);
  EXPECT_NEAR(moved[1], rest[1], 0.2);
  EXPECT_NEAR(moved[2] / rest[2], 1.0, 0.05);
}

TEST(ViewFrame, ConvertsPointsBack) {
  const Vec3 point{0.012, -0.034, 0.056};
  expectNear(fromView(toView(point)), point, 1e-8);
}

TEST(ViewFrame, RotatesAToolLikeTheWorld) {
  const Quat turn = normalized(Quat{0.8, 0.1, -0.5, 0.3});
  const Vec3 axisOfTool{0.2, -0.4, 0.9};

  const QVector3D shown = toolToView(turn).rotatedVector(QVector3D(0.2F, -0.4F, 0.9F));

  expectNear(fromViewDirection(shown), rotate(turn, axisOfTool), kSingle);
}

TEST(ViewFrame, CameraAxesInTheWorldMatchTheCamera) {
  OrbitCamera camera;
  camera.orbit({120.0, -40.0});

  const Quat toWorld = cameraToWorld(camera.rotation());

  expectNear(rotate(toWorld, {1, 0, 0}), fromViewDirection(camera.right()), kSingle);
  expectNear(rotate(toWorld, {0, 1, 0}), fromViewDirection(camera.up()), kSingle);
  expectNear(rotate(toWorld, {0, 0, -1}), fromViewDirection(camera.forward()), kSingle);
}

TEST(OrbitCamera, PixelAndRayAreInverse) {
  OrbitCamera camera;
  camera.frame({10, 20, 30}, 150, kView);
  camera.orbit({70.0, 35.0});

  for (const QPointF pixel : {QPointF(0, 0), QPointF(480, 340), QPointF(900, 120)}) {
    const QVector3D point = camera.atDepth(pixel, 420.0F, kView);
    EXPECT_NEAR(camera.depth(point), 420.0F, kMillimetre);
    EXPECT_NEAR(camera.pixel(point, kView).x(), pixel.x(), kPixel);
    EXPECT_NEAR(camera.pixel(point, kView).y(), pixel.y(), kPixel);
  }
}

TEST(OrbitCamera, FramesABallIntoWideAndTallViews) {
  for (const QSizeF size : {QSizeF(1200, 500), QSizeF(500, 1200)}) {
    OrbitCamera camera;
    camera.frame({5, 5, 5}, 100, size);

    const QPointF top = camera.pixel(QVector3D(5, 105, 5), size);
    const QPointF left = camera.pixel(QVector3D(-95, 5, 5), size);

    EXPECT_GT(top.y(), 0.0);
    EXPECT_GT(left.x(), 0.0);
    EXPECT_LT(std::min(top.y(), left.x()), 0.25 * std::min(size.width(), size.height()));
  }
}

TEST(OrbitCamera, LooksFromThePresetsDirection) {
  OrbitCamera camera;
  camera.frame({0, 0, 0}, 100, kView);

  camera.look(ViewPreset::kSide);
  EXPECT_GT(camera.position().x(), 0.99F * camera.distance());  // the patient's left
  camera.look(ViewPreset::kTop);
  EXPECT_GT(camera.position().y(), 0.99F * camera.distance());
  camera.look(ViewPreset::kFront);
  EXPECT_GT(camera.position().z(), 0.99F * camera.distance());
}

TEST(OrbitCamera, DraggingTheViewMovesThePictureWithTheMouse) {
  OrbitCamera camera;
  camera.frame({0, 0, 0}, 100, kView);
  const QVector3D point = camera.target();
  const QPointF before = camera.pixel(point, kView);

  camera.pan({30.0, -12.0}, kView.height());

  const QPointF way = camera.pixel(point, kView) - before;
  EXPECT_NEAR(way.x(), 30.0, 0.1);
  EXPECT_NEAR(way.y(), -12.0, 0.1);
}

TEST(OrganSurface, NormalsOfARoundBarPointAwayFromItsAxis) {
  const Scene bar = barScene();
  const OrganSurface surface(bar.mesh);

  int checked = 0;
  for (std::size_t i = 0; i < bar.mesh.vertices_m.size(); ++i) {
    const Vec3& p = bar.mesh.vertices_m[i];
    if (p.z < 0.02 || p.z > kBarLength_m - 0.02) {
      continue;  // the rims also belong to the caps
    }
    const SurfaceVertex& v = surface.vertices()[i];
    const Vec3 normal = fromViewDirection({v.normal[0], v.normal[1], v.normal[2]});
    const Vec3 outwards = normalized(Vec3{p.x, p.y, 0.0});
    EXPECT_GT(dot(normal, outwards), 0.999);
    ++checked;
  }
  EXPECT_GT(checked, 500);
}

TEST(OrganSurface, SinkingMovesEveryVertexInwardsByThatAmount) {
  const OrganSurface before(barScene().mesh);
  OrganSurface sunk = before;

  sunk.sink(0.5F);

  for (std::size_t i = 0; i < before.vertices().size(); ++i) {
    const SurfaceVertex& a = before.vertices()[i];
    const SurfaceVertex& b = sunk.vertices()[i];
    float along = 0.0F;
    for (int k = 0; k < 3; ++k) {
      along += (a.position[k] - b.position[k]) * a.normal[k];
    }
    EXPECT_NEAR(along, 0.5F, 1e-4F);
  }
}

TEST(OrganSurface, NormalsFollowTheTwistedVertices) {
  const Scene bar = barScene();
  OrganSurface surface(bar.mesh);
  std::vector<Vec3> turned_m;
  for (const Vec3& p : bar.mesh.vertices_m) {
    turned_m.push_back({p.y, -p.x, p.z});  // a quarter turn
  }
  const SurfaceVertex before = surface.vertices()[100];

  surface.update(turned_m);

  const SurfaceVertex& after = surface.vertices()[100];
  const Vec3 expected = fromViewDirection({before.normal[0], before.normal[1], before.normal[2]});
  expectNear(fromViewDirection({after.normal[0], after.normal[1], after.normal[2]}),
             {expected.y, -expected.x, expected.z}, 1e-4);
}

TEST(OrganSurface, AClosedMeshHasThreeEdgesForTwoTriangles) {
  const Scene bar = barScene();
  const OrganSurface surface(bar.mesh);

  EXPECT_EQ(2 * surface.edges().size(), 3 * surface.triangles().size());
}

TEST(TissueLook, ColoursVaryButStayNearTheTissues) {
  const TissueLook look = tissueLook("stomach");
  double sum = 0.0;
  float low = 10.0F;
  float high = 0.0F;
  for (int i = 0; i < 4000; ++i) {
    const std::array<float, 3> tint = mottle(look, {0.0011 * i, 0.0007 * (i % 97), -0.0013 * (i % 53)});
    for (const float channel : tint) {
      EXPECT_GT(channel, 0.1F);
      EXPECT_LT(channel, 2.0F);
    }
    sum += static_cast<double>(tint[1]);
    low = std::min(low, tint[1]);
    high = std::max(high, tint[1]);
  }
  EXPECT_NEAR(sum / 4000, 1.0, 0.1);
  EXPECT_GT(high - low, 0.2F);  // otherwise it looks like plastic
}

TEST(LatticeLines, HaveOneLineForEveryRidgeAndSection) {
  const Scene bar = barScene();

  const LatticeLines lines = latticeLines(bar);

  EXPECT_EQ(lines.lattice.size(),
            static_cast<std::size_t>(bar.lattice().ridges() + bar.lattice().sections()));
  EXPECT_EQ(lines.grasp.size(), 1U);
  EXPECT_TRUE(lines.grasp.front().closed);
  for (const SkinLine& line : lines.lattice) {
    for (const SkinAnchor& anchor : line.anchors) {
      EXPECT_NEAR(anchor.weights[0] + anchor.weights[1] + anchor.weights[2], 1.0F, 1e-5F);
    }
  }
}

TEST(LatticeLines, TheGraspBandIsAtThePatternsSection) {
  const Scene bar = barScene();
  const LatticeLines lines = latticeLines(bar);

  for (const SkinAnchor& anchor : lines.grasp.front().anchors) {
    Vec3 place;
    for (std::size_t k = 0; k < 3; ++k) {
      place += bar.mesh.vertices_m[anchor.corners[k]] * static_cast<double>(anchor.weights[k]);
    }
    EXPECT_NEAR(place.z, bar.pattern.graspArc * kBarLength_m, 1e-3);
    EXPECT_NEAR(std::hypot(place.x, place.y), kBarRadius_m, 5e-4);  // a polygon of 72 sides
  }
}

TEST(StudioLight, AMirrorShowsTheRoomAndAMattSurfaceItsMean) {
  const Direction up{0.0F, 1.0F, 0.0F};
  const Direction lamp{-0.35F / 1.071F, 0.85F / 1.071F, 0.55F / 1.071F};

  EXPECT_NEAR(mirroredRadiance(up, 0.0F, 64)[0], studioRadiance(up)[0], 1e-4F);
  // Roughness blurs the lamp; a matt surface facing down receives none of it.
  EXPECT_GT(studioRadiance(lamp)[0], 10.0F);
  EXPECT_LT(mirroredRadiance(lamp, 0.8F, 512)[0], studioRadiance(lamp)[0]);
  EXPECT_GT(diffuseRadiance(up, 1024)[1], diffuseRadiance({0.0F, -1.0F, 0.0F}, 1024)[1]);
}

TEST(StudioLight, TheFileHasSixLevelsOfSixSidesInHalfFloats) {
  const std::string file = studioLightFile(32);

  // 12 bytes of identifier, 13 numbers, a note of 4 + 24 bytes; a length before each level; 4 half floats per
  // pixel.
  std::size_t expected = 12 + 13 * 4 + 28;
  for (int level = 0; level < 6; ++level) {
    const auto pixels = static_cast<std::size_t>(32 >> level);
    expected += 4 + 6 * pixels * pixels * 8;
  }
  EXPECT_EQ(file.size(), expected);
  EXPECT_EQ(file.substr(1, 6), "KTX 11");
  EXPECT_NE(file.find("QT_IBL_BAKER_VERSION"), std::string::npos);
}

TEST(Instrument, TheShippedGrasperHasItsPartsAndItsTipAtTheOrigin) {
  const InstrumentParts parts =
      loadInstrument(std::filesystem::path(TORSIO_SOURCE_DIR) / "assets", "grasper");

  EXPECT_FALSE(parts.shaft.triangles.empty());
  EXPECT_FALSE(parts.hand.triangles.empty());
  EXPECT_GT(parts.jawPivot_mm.z(), 10.0F);
  EXPECT_GT(parts.jawOpening_deg, 5.0);
  double lowest_m = 1.0;
  for (const Vec3& v : parts.upperJaw.vertices_m) {
    lowest_m = std::min(lowest_m, v.z);
  }
  EXPECT_NEAR(lowest_m, 0.0, 1e-3);
}

/// A ball of radius 30 about the origin, mm.
struct Ball {
  TriangleMesh mesh;
  std::vector<QVector3D> places;
  Ball() {
    std::vector<std::array<double, 2>> profile_mm;
    for (int i = 0; i <= 24; ++i) {
      const double angle = std::numbers::pi * i / 24.0;
      profile_mm.push_back({30.0 * std::sin(angle), -30.0 * std::cos(angle)});
    }
    mesh = turnedBody(profile_mm, 40);
    for (const Vec3& p : mesh.vertices_m) {
      places.push_back(1e3F *
                       QVector3D(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)));
    }
  }
};

TEST(TurnedBody, IsClosedAndFacesOutward) {
  const Ball ball;
  double volume_m3 = 0.0;
  for (const TriangleMesh::Triangle& t : ball.mesh.triangles) {
    volume_m3 +=
        dot(ball.mesh.vertices_m[t[0]], cross(ball.mesh.vertices_m[t[1]], ball.mesh.vertices_m[t[2]])) / 6.0;
  }
  const double round_m3 = 4.0 / 3.0 * std::numbers::pi * 0.030 * 0.030 * 0.030;
  EXPECT_NEAR(volume_m3 / round_m3, 1.0, 0.03);
}

TEST(Silhouette, OfABallIsARingWhereItTurnsAwayAndPointsOutwards) {
  const Ball ball;
  const QVector3D eye(210.0F, -130.0F, 400.0F);
  Silhouette silhouette(ball.mesh.triangles, ball.places.size());

  const std::span<const Silhouette::Rim> rim = silhouette.find(ball.places, eye);

  ASSERT_GT(rim.size(), 20U);
  ASSERT_LT(rim.size(), 160U);
  std::map<std::uint32_t, int> ends;
  for (const Silhouette::Rim& side : rim) {
    const TriangleMesh::Triangle& corners = silhouette.triangle(side.triangle);
    for (const std::uint32_t vertex : {corners[side.side], corners[(side.side + 1) % 3]}) {
      ++ends[vertex];
      const QVector3D outward = silhouette.outward(vertex);
      const QVector3D sight = (ball.places[vertex] - eye).normalized();
      EXPECT_NEAR(outward.length(), 1.0F, kSingle);
      EXPECT_NEAR(QVector3D::dotProduct(outward, sight), 0.0F, 0.05F);
      EXPECT_GT(QVector3D::dotProduct(outward, ball.places[vertex].normalized()), 0.8F);
      // Where a tangent of the ball passes through the eye, up to one facet.
      EXPECT_LT(std::abs(QVector3D::dotProduct(ball.places[vertex].normalized(), sight)), 0.2F);
    }
  }
  for (const auto& [vertex, count] : ends) {
    EXPECT_EQ(count, 2) << vertex;  // a closed ring, without branches
  }
}

TEST(Silhouette, OfAnOpenSurfaceIncludesItsBorders) {
  const std::vector<TriangleMesh::Triangle> square{{0, 1, 2}, {0, 2, 3}};
  const std::vector<QVector3D> places{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  Silhouette silhouette(square, places.size());

  EXPECT_EQ(silhouette.find(places, {5, 5, 100}).size(), 4U);  // without the diagonal
  EXPECT_TRUE(silhouette.find(places, {5, 5, -100}).empty());  // not drawn from behind
}

TEST(SoftEdge, IsOnePixelWideOnTheScreenAndFadesOut) {
  const Ball ball;
  OrbitCamera camera;
  camera.frame({}, 40.0F, kView);
  constexpr float kHalf_rad = 0.5F * OrbitCamera::kFieldOfView_deg * std::numbers::pi_v<float> / 180.0F;
  const Eye eye{camera.position(), 2.0F * std::tan(kHalf_rad) / static_cast<float>(kView.height())};
  InstrumentGeometry body;
  body.setMesh(ball.mesh);
  std::vector<EdgeVertex> quads;

  body.appendSoftEdge(QMatrix4x4(), QColor(51, 102, 153), 1.0F, eye, quads);

  ASSERT_FALSE(quads.empty());
  ASSERT_EQ(quads.size() % 4, 0U);
  const auto pixel = [&](const EdgeVertex& v) {
    return camera.pixel({v.position[0], v.position[1], v.position[2]}, kView);
  };
  for (std::size_t i = 0; i < quads.size(); i += 4) {
    EXPECT_EQ(quads[i].colour[3], 1.0F);
    EXPECT_EQ(quads[i + 3].colour[3], 0.0F);
    EXPECT_NEAR(quads[i].colour[2], 0.6F, kSingle);
    EXPECT_EQ(quads[i].map[0], 1.0F);
    const QPointF way = pixel(quads[i + 3]) - pixel(quads[i]);
    EXPECT_NEAR(std::hypot(way.x(), way.y()), 1.0, 0.08);
    const QPointF from = pixel(quads[i]) - QPointF(0.5 * kView.width(), 0.5 * kView.height());
    EXPECT_GT(way.x() * from.x() + way.y() * from.y(), 0.0);  // away from the middle of the ball
  }
}

TEST(Instrument, AMissingOneIsRefusedByName) {
  try {
    static_cast<void>(loadInstrument(std::filesystem::path(TORSIO_SOURCE_DIR) / "assets", "spoon"));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kFileMissing);
    EXPECT_NE(error.where().find("spoon"), std::string::npos);
  }
}

}  // namespace
}  // namespace torsio::gui
