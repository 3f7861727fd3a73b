// SPDX-License-Identifier: GPL-3.0-or-later
// What a trainee's run draws of the instrument in the tissue: dents, force arrow, closing jaws, the hand; its
// surroundings; and replacing a scene. On a virtual display; inspects the scene graph.
#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <QApplication>
#include <QProcess>
#include <QQuickItem>
#include <QQuickWidget>
#include <QStandardPaths>
#include <QVector3D>
#include <gtest/gtest.h>

#include "app/gui/scene/organ_geometry.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/scene/view_scene.h"
#include "app/outputs/charts/typeface.h"
#include "tests/app/gui/support/trainee_station.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio::gui {
namespace {

using torsio::testing::TrainingCentre;

constexpr int kFrame_ms = 16;
constexpr int kMaxFrames = 1200;

/// Returns the drawn positions of the skin, mm.
std::vector<QVector3D> skinOf(const QQuickItem& root) {
  const QByteArray bytes = root.property("organ").value<OrganGeometry*>()->vertexData();
  std::vector<DrawnVertex> drawn(static_cast<std::size_t>(bytes.size()) / sizeof(DrawnVertex));
  std::memcpy(drawn.data(), bytes.constData(), drawn.size() * sizeof(DrawnVertex));
  std::vector<QVector3D> places;
  for (const DrawnVertex& vertex : drawn) {
    places.emplace_back(vertex.position[0], vertex.position[1], vertex.position[2]);
  }
  return places;
}

/// Maximum displacement of the skin, mm, and its distance from `tip_mm`.
struct Dent {
  float depth_mm = 0.0F;
  float fromTip_mm = 0.0F;
};

Dent dentOf(const std::vector<QVector3D>& before, const std::vector<QVector3D>& now,
            const QVector3D& tip_mm) {
  Dent dent;
  for (std::size_t i = 0; i < std::min(before.size(), now.size()); ++i) {
    const float moved_mm = (now[i] - before[i]).length();
    if (moved_mm > dent.depth_mm) {
      dent = {moved_mm, (before[i] - tip_mm).length()};
    }
  }
  return dent;
}

TEST(RunScene, DrawsDentForceClosingJawsAndHandOfATraineesRun) {
  if (!SceneView::platformCanRender()) {
    GTEST_SKIP() << "no display that draws, and xvfb-run is not installed";
  }
  TrainingCentre centre;
  Station station(centre);
  station.openRun(false, [](const Scene& scene, double target_rad) -> std::unique_ptr<HapticDevice> {
    ScriptedHandOptions hand = practised(scene, target_rad);
    hand.task.tipRadius_m -= 0.004;  // presses, so that there is something visible
    return std::make_unique<ScriptedHand>(hand);
  });
  auto& scene = child<LiveScene>(station.run(), "scene");
  ASSERT_TRUE(testing::eventually([&] {
    const RecordedRun* live = scene.controller().run();
    return !station.run().fetchesDevice() && live != nullptr && live->recorded();
  }));
  auto* quick = scene.findChild<QQuickWidget*>();
  ASSERT_NE(quick, nullptr);
  const QQuickItem& root = *quick->rootObject();
  const auto shown = [&root](const char* property) { return root.property(property).toBool(); };

  RecordedRun& run = *scene.controller().run();
  std::vector<QVector3D> atRest;
  double open_deg = 0.0;
  double closed_deg = 90.0;
  Dent deepest;
  bool handSeen = false;
  bool arrowOfAir = false;
  float longestArrow_mm = 0.0F;
  for (int frame = 0; frame < kMaxFrames && closed_deg > open_deg / 2.0; ++frame) {
    run.step(kFrame_ms);
    scene.frame(kFrame_ms * 1e-3);
    const LiveState state = scene.controller().state();
    const double jaw_deg = root.property("jawAngle").toDouble();
    handSeen = handSeen || shown("handVisible");
    if (state.phase == ExercisePhase::kTracking) {
      atRest = skinOf(root);
      open_deg = std::max(open_deg, jaw_deg);
      arrowOfAir = arrowOfAir || shown("forceVisible");
    } else if (state.phase == ExercisePhase::kContact && norm(state.response.force_N) > 0.1) {
      const Dent dent = dentOf(atRest, skinOf(root), toView(state.tool.position_m));
      deepest = dent.depth_mm > deepest.depth_mm ? dent : deepest;
      EXPECT_TRUE(shown("forceVisible"));
      longestArrow_mm = std::max(longestArrow_mm, root.property("forceLength").toFloat());
      const QVector3D at_mm = root.property("forcePosition").value<QVector3D>();
      EXPECT_LT((at_mm - toView(state.tool.position_m)).length(), 0.1F);
    } else if (state.phase == ExercisePhase::kTwisting) {
      closed_deg = std::min(closed_deg, jaw_deg);
    }
  }

  ASSERT_FALSE(atRest.empty());
  EXPECT_GT(deepest.depth_mm, 0.5F);
  EXPECT_LT(deepest.fromTip_mm, 15.0F) << "the skin gives way where the jaw is";
  EXPECT_FALSE(arrowOfAir);
  EXPECT_GT(longestArrow_mm, 1.0F);
  EXPECT_LT(closed_deg, open_deg / 2.0);
  EXPECT_TRUE(handSeen);
  EXPECT_TRUE(shown("toolVisible"));
}

// Between two cases of a physician, the first organ is released while the window is resized.
TEST(SceneOfTheNextCase, ReplacesTheLastOneInAWindowThatWasResized) {
  if (!SceneView::platformCanRender()) {
    GTEST_SKIP() << "no display that draws, and xvfb-run is not installed";
  }
  const auto organ = std::make_shared<const Scene>(barScene());
  SceneView view;
  view.resize(500, 400);
  view.show();
  view.setScene(makeViewScene(organ));
  ASSERT_TRUE(testing::eventually([&] { return view.framesDrawn() > 0; }));
  const auto* waiting = view.findChild<QWidget*>("waiting");
  ASSERT_NE(waiting, nullptr);
  ASSERT_TRUE(testing::eventually([&] { return !waiting->isVisible(); }));

  view.forgetScene();
  view.resize(640, 480);
  EXPECT_TRUE(testing::eventually([&] { return waiting->isVisible(); }))
      << "the organ of the case before is not left there";
  view.hide();
  view.resize(520, 410);
  view.show();
  view.setScene(makeViewScene(organ));
  EXPECT_TRUE(testing::eventually([&] { return !waiting->isVisible(); }));
}

/// A scene with only the requested surroundings.
struct SceneShown {
  explicit SceneShown(const std::string& id) {
    SceneRequest request;
    request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
    request.id = id;
    scene = std::make_shared<const Scene>(loadScene(request));
    view.resize(600, 480);
    view.setTheme(theme(ThemeKind::kLight));
    view.setQuality(RenderQuality::kFast);
    view.show();
    view.setToolVisible(false);
    view.setScene(makeViewScene(scene));
    EXPECT_TRUE(testing::eventually([&] { return view.framesDrawn() > 0; }));
  }
  QQuickItem& root() { return *view.findChild<QQuickWidget*>()->rootObject(); }

  /// Returns the pixels that a part of the scene changes.
  std::vector<bool> changedBy(const char* part) {
    const QImage with = view.picture();
    root().setProperty(part, false);
    const QImage without = view.picture();
    root().setProperty(part, true);
    std::vector<bool> changed;
    for (int y = 0; y < with.height(); ++y) {
      for (int x = 0; x < with.width(); ++x) {
        changed.push_back(with.pixel(x, y) != without.pixel(x, y));
      }
    }
    return changed;
  }

  std::shared_ptr<const Scene> scene;
  SceneView view;
};

// Red tissue on a plain backdrop: without surroundings and mesentery.
std::vector<bool> organOf(SceneShown& shown) {
  shown.root().setProperty("surroundingsVisible", false);
  const QImage bare = shown.view.picture();
  shown.root().setProperty("surroundingsVisible", true);
  const QRgb backdrop = bare.pixel(0, 0);
  std::vector<bool> organ;
  for (int y = 0; y < bare.height(); ++y) {
    for (int x = 0; x < bare.width(); ++x) {
      organ.push_back(bare.pixel(x, y) != backdrop);
    }
  }
  return organ;
}

TEST(Mesentery, IsVisibleBelowALoopOfBowelAndHidesNothingOfIt) {
  if (!SceneView::platformCanRender()) {
    GTEST_SKIP() << "no display that draws, and xvfb-run is not installed";
  }
  for (const char* id : {"small-bowel-loop", "intestine"}) {
    SceneShown shown(id);
    ASSERT_TRUE(shown.root().property("mesenteryVisible").toBool());
    for (const double angle_rad : {0.0, -std::numbers::pi}) {
      shown.view.setOrgan(shown.scene->stateAt(angle_rad));
      // The last view is from below, where the mesentery is in front of the loop.
      for (const auto& [turn_deg, above_deg] :
           {std::array{0.0F, 0.0F}, {55.0F, 20.0F}, {-70.0F, 20.0F}, {0.0F, -55.0F}}) {
        shown.view.camera().lookFrom(turn_deg, above_deg);
        shown.view.frameOrgan();
        const std::vector<bool> organ = organOf(shown);

        const std::vector<bool> changed = shown.changedBy("mesenteryVisible");

        int seen = 0;
        int hidden = 0;
        int tissue = 0;
        for (std::size_t i = 0; i < organ.size(); ++i) {
          tissue += organ[i] ? 1 : 0;
          seen += changed[i] ? 1 : 0;
          hidden += changed[i] && organ[i] ? 1 : 0;
        }
        EXPECT_GT(tissue, 5000);
        EXPECT_GT(seen, 2000) << id << " from " << turn_deg;
        // The organ's soft edge, one pixel wide, is translucent.
        EXPECT_LT(hidden, tissue / 25) << id << " from " << turn_deg;
      }
    }
  }
}

TEST(Mesentery, AndTheClothDisappearWithTheirSceneAndTheSurroundings) {
  if (!SceneView::platformCanRender()) {
    GTEST_SKIP() << "no display that draws, and xvfb-run is not installed";
  }
  SceneShown shown("forearm");
  EXPECT_TRUE(shown.root().property("drapeVisible").toBool());
  EXPECT_FALSE(shown.root().property("mesenteryVisible").toBool());
  const std::vector<bool> draped = shown.changedBy("drapeVisible");
  EXPECT_GT(std::count(draped.begin(), draped.end(), true), 1000);
  shown.view.setSurroundingsVisible(false);  // inspecting an organ
  const std::vector<bool> bare = shown.changedBy("drapeVisible");
  EXPECT_EQ(std::count(bare.begin(), bare.end(), true), 0);

  shown.view.setScene(makeViewScene(std::make_shared<const Scene>(barScene())));
  EXPECT_FALSE(shown.root().property("drapeVisible").toBool());
}

}  // namespace
}  // namespace torsio::gui

/// Restarts itself on a virtual display if available; listing tests needs none.
int main(int argc, char** argv) {
  const QString display = QStandardPaths::findExecutable(QStringLiteral("xvfb-run"));
  bool lists = false;
  for (int i = 1; i < argc; ++i) {
    lists = lists || qstrcmp(argv[i], "--gtest_list_tests") == 0;
  }
  if (!lists && !display.isEmpty() && qEnvironmentVariableIsEmpty("TORSIO_ON_VIRTUAL_DISPLAY")) {
    qputenv("TORSIO_ON_VIRTUAL_DISPLAY", "1");
    qputenv("QT_QPA_PLATFORM", "xcb");
    qputenv("LIBGL_ALWAYS_SOFTWARE", "1");
    QStringList again{QStringLiteral("-a"), QStringLiteral("-s"),
                      QStringLiteral("-screen 0 1400x900x24 +extension GLX -noreset")};
    for (int i = 0; i < argc; ++i) {
      again << QString::fromLocal8Bit(argv[i]);
    }
    return QProcess::execute(display, again);
  }
  if (display.isEmpty() || lists) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  torsio::gui::SceneView::prepareGraphics();
  QApplication application(argc, argv);
  torsio::useTypeface(application);
  QApplication::setOrganizationName("torsio-tests");
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
