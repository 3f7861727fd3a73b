// SPDX-License-Identifier: GPL-3.0-or-later
// Overlays of the scene, beyond tissue and instrument, as values.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "app/gui/scene/quality_control.h"
#include "app/gui/scene/shear_map.h"
#include "app/gui/scene/skin_overlays.h"
#include "app/gui/simulator/replay_bar.h"
#include "sim/scene/scene.h"
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

}  // namespace
}  // namespace torsio::gui
