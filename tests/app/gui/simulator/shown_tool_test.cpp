// SPDX-License-Identifier: GPL-3.0-or-later
// The instrument as drawn while mouse and keys press, grip and turn: it never passes through the organ by
// itself, and moves with the place it holds.
#include "app/gui/simulator/shown_tool.h"

#include <cmath>

#include <QApplication>
#include <QKeyEvent>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/pointer_controls.h"
#include "app/gui/simulator/simulation_controller.h"
#include "sim/core/angle.h"
#include "tests/app/gui/support/bar_view.h"

namespace torsio::gui {
namespace {

constexpr int kFrame_ms = 16;
constexpr double kAlike_rad = radians(2.0);
constexpr double kAlike_m = 0.001;

Vec3 across(const Vec3& point_m) {
  return {point_m.x, point_m.y, 0.0};  // the bar is along z
}

/// Window and servo without a screen, stepped by the test.
class Desk {
 public:
  Desk() {
    controller_.setRealTime(false);
    QObject::connect(&pointer_, &PointerControls::changed, &view_,
                     [this] { controller_.steer(pointer_.input()); });
    view_.resize(960, 680);
    controller_.load(testing::requestFor("bar"));
    EXPECT_TRUE(testing::eventually([this] { return !controller_.loading(); }));
    view_.setScene(controller_.viewScene());
    pointer_.park(controller_.parkingPoint_m());
  }
  /// Runs a frame; returns what is drawn.
  LiveState frame() {
    pointer_.advance(kFrame_ms * 1e-3);
    controller_.advance(kFrame_ms * 1e-3);
    if (RecordedRun* run = controller_.run()) {
      run->step(kFrame_ms);
    }
    return tool_.show(controller_.state());
  }
  [[nodiscard]] LiveState state() { return controller_.state(); }
  void wheel(int notches) {
    const QPointF at(480, 340);
    QWheelEvent event(at, at, {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view_, &event);
  }
  void key(QEvent::Type type, int which) {
    QKeyEvent event(type, which, Qt::NoModifier);
    QApplication::sendEvent(&view_, &event);
  }

 private:
  SimulationController controller_{testing::loadBar, TrialRecording{}};
  SceneView view_;
  PointerControls pointer_{view_};
  ShownTool tool_{controller_, pointer_, view_};
};

TEST(ShownTool, AfterSixtyStepsAndATurnTheShaftPointsOutwardsFromThePlaceItHolds) {
  Desk desk;
  for (int i = 0; i < 30; ++i) {
    desk.frame();
  }
  Vec3 arrivedFrom = normalized(across(desk.state().tool.position_m));
  desk.wheel(60);
  for (int i = 0; i < 120; ++i) {
    desk.frame();
    const Vec3 tip = across(desk.state().tool.position_m);
    if (norm(tip) >= kBarRadius_m) {
      arrivedFrom = normalized(tip);
    }
    ASSERT_GT(dot(tip, arrivedFrom), 0.0) << "frame " << i;
  }
  ASSERT_EQ(desk.state().phase, ExercisePhase::kContact);

  desk.key(QEvent::KeyPress, Qt::Key_G);
  desk.key(QEvent::KeyPress, Qt::Key_Q);
  for (int i = 0; i < 400 && desk.state().response.angle_rad > radians(-103.0); ++i) {
    const LiveState drawn = desk.frame();
    const LiveState felt = desk.state();
    if (felt.phase != ExercisePhase::kTwisting) {
      continue;
    }
    const Vec3 tip = across(felt.tool.position_m);
    ASSERT_GT(dot(tip, arrivedFrom), 0.0) << "the hand stays on its side";
    const Vec3 shown = across(drawn.tool.position_m);
    const Vec3 turned = rotateAbout(tip, {0.0, 0.0, 1.0}, felt.response.angle_rad);
    ASSERT_LT(norm(shown - turned), kAlike_m) << "at " << degrees(felt.response.angle_rad);
    const Vec3 handle = rotate(drawn.tool.orientation, {0.0, 0.0, 1.0});
    ASSERT_GT(dot(handle, shown), 0.0)
        << "the shaft would run through the organ at " << degrees(felt.response.angle_rad);
  }
  EXPECT_LE(desk.state().response.angle_rad, radians(-103.0));
  desk.key(QEvent::KeyRelease, Qt::Key_Q);

  desk.key(QEvent::KeyPress, Qt::Key_G);
  LiveState drawn;
  for (int i = 0; i < 300 && (i < 2 || std::abs(desk.state().response.angle_rad) > kAlike_rad); ++i) {
    drawn = desk.frame();
    ASSERT_GT(dot(across(desk.state().tool.position_m), arrivedFrom), 0.0);
  }
  EXPECT_LT(norm(drawn.tool.position_m - desk.state().tool.position_m), 2.0 * kAlike_m)
      << "with the organ the instrument comes back";
}

}  // namespace
}  // namespace torsio::gui
