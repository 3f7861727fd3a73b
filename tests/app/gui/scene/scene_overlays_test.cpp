// SPDX-License-Identifier: GPL-3.0-or-later
// Overlays of the scene, beyond tissue and instrument, as values. What hides the ends of bodies: cloth over
// the ends of arm and glove, the mesentery of a loop. No renderer. Names of organs and twists in lists: the
// titles of their files, in the window's language.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include <QComboBox>
#include <QRegularExpression>
#include <gtest/gtest.h>

#include "app/gui/base/language.h"
#include "app/gui/base/scene_titles.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/scene/drapery.h"
#include "app/gui/scene/instrument_geometry.h"
#include "app/gui/scene/mesentery.h"
#include "app/gui/scene/organ_surface.h"
#include "app/gui/scene/quality_control.h"
#include "app/gui/scene/shear_map.h"
#include "app/gui/scene/skin_overlays.h"
#include "app/gui/scene/surroundings.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/simulator/exercise_panel.h"
#include "app/gui/simulator/replay_bar.h"
#include "app/gui/widgets/theme.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_file.h"
#include "tests/app/gui/support/bar_view.h"

namespace torsio::gui {

namespace {

float lightness(const std::array<float, 3>& c) {
  return 0.2126F * std::pow(c[0], 2.2F) + 0.7152F * std::pow(c[1], 2.2F) + 0.0722F * std::pow(c[2], 2.2F);
}

TEST(ShearColour, IncreasesInLightnessSoThatItIsReadableWithoutColour) {
  float before = -1.0F;
  for (int i = 0; i <= 60; ++i) {
    const float now = lightness(shearColour(static_cast<float>(i) / 60.0F));
    EXPECT_GT(now, before) << i;
    before = now;
  }
}

TEST(ShearMap, IsZeroAtRestAndReachesTheEndOfItsScaleAtTheTarget) {
  const auto scene = testing::loadBar(testing::requestFor("bar")).scene;
  ShearMap map(scene);
  std::vector<float> share(scene->mesh.vertices_m.size());
  const double grasp_m = scene->pattern.graspArc * scene->lattice().length_m();

  map.evaluate({{grasp_m, 0.0}, {}}, share);
  EXPECT_EQ(*std::max_element(share.begin(), share.end()), 0.0F);

  map.evaluate({{grasp_m, scene->pattern.targetAngle_rad}, {}}, share);
  // Interpolation between the centres of patches lowers the peak slightly.
  EXPECT_GT(*std::max_element(share.begin(), share.end()), 0.5F);
  EXPECT_LE(*std::max_element(share.begin(), share.end()), 1.0F);
}

TEST(ShearMap, GrowsInProportionToASmallAngle) {
  const auto scene = testing::loadBar(testing::requestFor("bar")).scene;
  ShearMap map(scene);
  const double grasp_m = scene->pattern.graspArc * scene->lattice().length_m();
  const double angle_rad = 0.2 * scene->pattern.targetAngle_rad;
  std::vector<float> once(scene->mesh.vertices_m.size());
  std::vector<float> twice(once.size());

  map.evaluate({{grasp_m, angle_rad}, {}}, once);
  map.evaluate({{grasp_m, 2.0 * angle_rad}, {}}, twice);

  for (std::size_t v = 0; v < once.size(); ++v) {
    EXPECT_NEAR(twice[v], 2.0F * once[v], 1e-4F);
  }
}

TEST(OrganMarkers, TheArmHasTheTenPointsOfThePaper) {
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = "forearm";
  const LoadedScene loaded = loadSceneForView(request);

  ASSERT_EQ(loaded.view.markers.size(), 10U);
  for (const SkinAnchor& marker : loaded.view.markers) {
    EXPECT_NEAR(marker.weights[0] + marker.weights[1] + marker.weights[2], 1.0F, 1e-5F);
  }
}

TEST(QualityControl, SwitchesDownWhenThePictureStuttersAndDoesNotRetryImmediately) {
  QualityControl control(Renderer::kGraphicsCard);
  bool changed = false;
  for (int frame = 0; frame < 60 && !changed; ++frame) {
    changed = control.note(0.06);
  }
  ASSERT_TRUE(changed);
  EXPECT_FALSE(control.fine());

  // Two smooth seconds are not enough after a drop.
  for (int frame = 0; frame < 120; ++frame) {
    EXPECT_FALSE(control.note(1.0 / 60.0));
  }
  changed = false;
  for (int frame = 0; frame < 1200 && !changed; ++frame) {
    changed = control.note(1.0 / 60.0);
  }
  EXPECT_TRUE(control.fine());
}

TEST(QualityControl, OneLongFrameAndIdleTimeHaveNoEffect) {
  QualityControl control(Renderer::kGraphicsCard);
  for (int frame = 0; frame < 300; ++frame) {
    EXPECT_FALSE(control.note(frame % 50 == 0 ? 0.12 : 1.0 / 60.0));
    if (frame % 100 == 0) {
      EXPECT_FALSE(control.note(5.0));  // nothing moved for five seconds
    }
  }
  EXPECT_TRUE(control.fine());
}

TEST(QualityControl, NeverTriesTheFinePictureOnASoftwareRenderer) {
  QualityControl control(Renderer::kSoftware);
  ASSERT_FALSE(control.fine());

  // A minute of frames at the display's rate.
  for (int frame = 0; frame < 3600; ++frame) {
    ASSERT_FALSE(control.note(1.0 / 60.0));
  }

  EXPECT_FALSE(control.fine());
}

TEST(FilmStrip, ArrangesFramesWithoutChangingTheirShape) {
  QImage picture(960, 540, QImage::Format_RGB32);
  picture.fill(Qt::red);
  const std::vector<StripFrame> row(5, {QStringLiteral("30"), picture});

  const QImage strip = filmStrip({row, row});

  EXPECT_GT(strip.width(), 5 * 480);
  EXPECT_LT(strip.height(), 2 * (270 + 60));
  EXPECT_EQ(strip.pixelColor(20, 20), QColor(Qt::red));
  EXPECT_TRUE(filmStrip({}).isNull());
}

const std::filesystem::path kAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

/// Counts triangle edges without exactly one neighbour: visible borders.
int openSides(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++sides[std::minmax(t[k], t[(k + 1) % 3])];
    }
  }
  return static_cast<int>(
      std::count_if(sides.begin(), sides.end(), [](const auto& side) { return side.second != 2; }));
}

/// Returns whether a closed mesh contains a point: an odd number of triangles is on one side of it.
bool encloses(const TriangleMesh& mesh, const Vec3& point_m) {
  const Vec3 way = Vec3{0.8123, 0.4711, 0.3432};
  int crossed = 0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_m[t[0]];
    const Vec3 ab = mesh.vertices_m[t[1]] - a;
    const Vec3 ac = mesh.vertices_m[t[2]] - a;
    const Vec3 across = cross(way, ac);
    const double scale = dot(ab, across);
    if (scale == 0.0) {
      continue;
    }
    const Vec3 from = point_m - a;
    const double u = dot(from, across) / scale;
    const Vec3 other = cross(from, ab);
    const double v = dot(way, other) / scale;
    crossed += u >= 0.0 && v >= 0.0 && u + v <= 1.0 && dot(ac, other) / scale > 0.0 ? 1 : 0;
  }
  return crossed % 2 == 1;
}

struct Arm {
  Arm() {
    SceneRequest request;
    request.assets = kAssets;
    request.id = "forearm";
    const Scene scene = loadScene(request);
    surface = OrganSurface(scene.mesh);
    for (const SurfaceVertex& v : surface.vertices()) {
      low_mm = std::min(low_mm, v.position[1]);
      back_mm = std::min(back_mm, v.position[2]);
    }
  }
  OrganSurface surface;
  float low_mm = 1e9F;
  float back_mm = 1e9F;
};

TEST(Drapery, HidesTheEndOfTheArmFromEverySideAndLittleElse) {
  const Arm arm;
  const float ground_mm = arm.back_mm - 28.0F;

  const TriangleMesh drape = drapeOverArm(arm.surface, ground_mm);

  EXPECT_EQ(surroundingsOf("forearm"), Surroundings::kArm);
  EXPECT_FALSE(throughPort(Surroundings::kArm));
  EXPECT_EQ(openSides(drape), 0);
  EXPECT_GT(signedVolume_m3(drape), 0.0);
  constexpr float kRim_mm = 8.0F;   // the cut and its rounded rim
  constexpr float kHem_mm = 30.0F;  // of 443 mm
  int hidden = 0;
  for (const SurfaceVertex& v : arm.surface.vertices()) {
    const float above_mm = v.position[1] - arm.low_mm;
    const Vec3 place_m = 1e-3 * Vec3{static_cast<double>(v.position[0]), static_cast<double>(v.position[1]),
                                     static_cast<double>(v.position[2])};
    if (above_mm < kRim_mm) {
      EXPECT_TRUE(encloses(drape, place_m)) << above_mm;
      ++hidden;
    } else if (above_mm > kHem_mm) {
      EXPECT_FALSE(encloses(drape, place_m)) << above_mm;
    }
  }
  EXPECT_GT(hidden, 20);
  double lowest_m = 0.0;
  for (const Vec3& v : drape.vertices_m) {
    EXPECT_GE(v.z, 1e-3 * static_cast<double>(ground_mm) - 1e-6);  // on the table, but not through it
    lowest_m = std::min(lowest_m, v.y);
  }
  EXPECT_LT(lowest_m, -0.5);  // out of the picture
}

TEST(Drapery, TheGownContinuesTheGlovesCuffOutOfThePicture) {
  const InstrumentParts grasper = loadInstrument(kAssets, "grasper");
  ASSERT_FALSE(grasper.hand.triangles.empty());

  const TriangleMesh sleeve = gownSleeve(grasper.hand);

  EXPECT_EQ(openSides(sleeve), 0);
  EXPECT_GT(signedVolume_m3(sleeve), 0.0);
  double end_m = 0.0;
  for (const Vec3& v : grasper.hand.vertices_m) {
    end_m = std::max(end_m, v.z);
  }
  constexpr double kRim_m = 0.010;
  constexpr double kHand_m = 0.050;
  for (const Vec3& v : grasper.hand.vertices_m) {
    if (v.z > end_m - kRim_m) {
      EXPECT_TRUE(encloses(sleeve, v)) << v.z;
    } else if (v.z < end_m - kHand_m) {
      EXPECT_FALSE(encloses(sleeve, v)) << v.z;
    }
  }
  double reach_m = 0.0;
  for (const Vec3& v : sleeve.vertices_m) {
    reach_m = std::max(reach_m, v.z);
  }
  EXPECT_GT(reach_m - end_m, 0.5);
}

TEST(Mesentery, HangsFromTheMiddleOfTheLoopToARootBehindIt) {
  SceneRequest request;
  request.assets = kAssets;
  request.id = "intestine";
  const Scene scene = loadScene(request);
  const OrganSurface surface(scene.mesh);
  const std::vector<MesenteryHold> holds = mesenteryHolds(scene);
  ASSERT_GT(holds.size(), 10U);
  constexpr float kRadius_mm = 100.0F;
  constexpr float kGround_mm = -40.0F;

  const MesenteryRoot root = mesenteryRoot(holds, surface, kRadius_mm, kGround_mm);

  const auto middle = [&](const MesenteryHold& hold) {
    QVector3D sum;
    for (const SkinAnchor& anchor : hold) {
      sum += markerPlace(anchor, surface) / static_cast<float>(hold.size());
    }
    return sum;
  };
  const QVector3D first = middle(holds.front());
  const QVector3D last = middle(holds.back());
  std::size_t inside = 0;  // where the loop hides the edge of the fan
  for (const MesenteryHold& hold : holds) {
    const Vec3 place_m = fromView(middle(hold));
    inside += encloses(scene.mesh, place_m) ? 1 : 0;
  }
  EXPECT_GE(inside, holds.size() - 2);  // its two ends are on the feet
  EXPECT_LT(root.from.y(), std::min(first.y(), last.y()));
  EXPECT_NEAR(root.from.z(), kGround_mm, 0.05F * kRadius_mm);
  EXPECT_GT(root.from.z(), kGround_mm);
  EXPECT_GT((root.from - root.to).x() * (first - last).x(), 0.0F);  // does not cross itself
  EXPECT_LT(std::abs((root.from - root.to).x()), 0.5F * std::abs((first - last).x()));
}

TEST(Mesentery, IsThinAndNeverLooksLikeTheTreatedTissue) {
  for (const ThemeKind kind : {ThemeKind::kLight, ThemeKind::kDark}) {
    const QImage fan = paintMesentery(theme(kind));
    EXPECT_EQ(fan, paintMesentery(theme(kind)));
    for (int y = 0; y < fan.height(); y += 3) {
      for (int x = 0; x < fan.width(); x += 3) {
        const QColor c = fan.pixelColor(x, y);
        EXPECT_LE((c.red() - c.blue()) * c.alpha() / 255, 25);
        EXPECT_LT(c.alpha(), 235);
      }
    }
    for (int y = 0; y < fan.height(); ++y) {  // no visible border at the sides and the root
      EXPECT_LT(fan.pixelColor(0, y).alpha(), 40);
      EXPECT_LT(fan.pixelColor(fan.width() - 1, y).alpha(), 40);
    }
    EXPECT_LT(fan.pixelColor(fan.width() / 2, fan.height() - 1).alpha(), 40);
  }
}

const std::filesystem::path kShipped = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

bool isChinese(const QString& text) {
  static const QRegularExpression kHan(QStringLiteral("\\p{Han}"));
  return kHan.match(text).hasMatch();
}

TEST(SceneTitles, NameAVolvulusAsInItsFileAndNotByItsId) {
  SceneTitles titles(kShipped);

  EXPECT_EQ(titles.scene("gastric-organo-axial"), QStringLiteral("Stomach, organo-axial volvulus"));
  EXPECT_EQ(titles.pattern("gastric-organo-axial", "detorse"),
            QStringLiteral("Untwist an organo-axial volvulus"));
  EXPECT_EQ(titles.pattern("midgut", "detorse"), QStringLiteral("Untwist a midgut volvulus"));
}

TEST(SceneTitles, AreChineseForEveryShippedSceneWithItsPatternsBriefingAndValidity) {
  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  SceneTitles titles(kShipped);

  std::size_t undone = 0;
  for (const std::string& id : sceneIds(kShipped)) {
    EXPECT_TRUE(isChinese(titles.scene(id))) << id;
    for (const PatternDescription& one : readSceneFile(kShipped, id).patterns) {
      EXPECT_TRUE(isChinese(titles.pattern(id, one.pattern.id))) << id << " " << one.pattern.id;
      if (one.pattern.detorsion) {
        ++undone;
        EXPECT_TRUE(isChinese(toQString(Text(one.pattern.detorsion->briefing)))) << id;
        EXPECT_TRUE(isChinese(toQString(Text(one.pattern.detorsion->validity)))) << id;
      }
    }
  }

  EXPECT_EQ(undone, 6U);  // scenes that come twisted, assets/scenes/README.md
}

TEST(SceneTitles, FallBackToTheIdOfARecordingFromElsewhere) {
  SceneTitles titles(kShipped);

  EXPECT_EQ(titles.scene("own_organ"), QStringLiteral("Own organ"));
  EXPECT_EQ(titles.pattern("own_organ", "half-turn"), QStringLiteral("Half-turn"));
  EXPECT_EQ(titles.pattern("stomach", "no_such"), QStringLiteral("No such"));
}

TEST(SceneTitles, AreShownInTheListOfOrgansAlsoAfterAChangeOfLanguage) {
  ExercisePanel panel;
  panel.setOrgans(kShipped);
  const auto boxes = panel.findChildren<QComboBox*>();
  const auto organ = std::find_if(boxes.begin(), boxes.end(), [](const QComboBox* box) {
    return box->findData(QStringLiteral("sigmoid")) >= 0;
  });
  ASSERT_NE(organ, boxes.end());
  const int row = (*organ)->findData(QStringLiteral("sigmoid"));
  EXPECT_EQ((*organ)->itemText(row), QStringLiteral("Sigmoid volvulus"));

  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  panel.retranslate();

  EXPECT_EQ((*organ)->itemText(row), QStringLiteral("乙状结肠扭转"));
}

}  // namespace

}  // namespace torsio::gui
