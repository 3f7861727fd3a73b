// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse and keys over the view, as events of a real widget. The view shows its sentence instead of the
// scene; camera and controls are the real ones. The instrument as drawn while mouse and keys press, grip
// and turn: it never passes through the organ by itself, and moves with the place it holds.

#include <cmath>

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include "app/gui/scene/scene_view.h"
#include "app/gui/scene/view_frame.h"
#include "app/gui/simulator/pointer_controls.h"
#include "app/gui/simulator/shown_tool.h"
#include "app/gui/simulator/simulation_controller.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/theme.h"
#include "sim/core/angle.h"
#include "tests/app/gui/support/bar_view.h"

namespace torsio::gui {

namespace {

constexpr double kNear_px = 0.05;
constexpr double kAngle = 1e-9;

class Controls : public ::testing::Test {
 protected:
  SceneView view_;
  PointerControls controls_{view_};

  void SetUp() override {
    view_.resize(960, 680);
    view_.camera().frame({0, 0, 0}, 120.0F, QSizeF(view_.size()));
    controls_.park({0.0, -0.06, 0.0});
  }

  void move(const QPointF& to, Qt::MouseButtons buttons = Qt::NoButton,
            Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QMouseEvent event(QEvent::MouseMove, to, to, Qt::NoButton, buttons, modifiers);
    QApplication::sendEvent(&view_, &event);
  }
  void press(const QPointF& at, Qt::MouseButton button) {
    QMouseEvent event(QEvent::MouseButtonPress, at, at, button, button, Qt::NoModifier);
    QApplication::sendEvent(&view_, &event);
  }
  void release(const QPointF& at, Qt::MouseButton button) {
    QMouseEvent event(QEvent::MouseButtonRelease, at, at, button, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&view_, &event);
  }
  void wheel(int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event({480, 340}, {480, 340}, {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view_, &event);
  }
  void key(QEvent::Type type, int which) {
    QKeyEvent event(type, which, Qt::NoModifier);
    QApplication::sendEvent(&view_, &event);
  }
  QPointF tipPixel() const {
    return view_.camera().pixel(toView(controls_.input().onPlane_m), QSizeF(view_.size()));
  }
  Quat orientation() const {
    const PointerInput& in = controls_.input();
    return in.view * axisAngle({0, 1, 0}, in.yaw_rad) * axisAngle({1, 0, 0}, in.pitch_rad) *
           axisAngle({0, 0, 1}, in.roll_rad);
  }
  /// Returns the turn about an axis between two orientations, as the servo takes it for the twist.
  static double turnAbout(const Vec3& axis, const Quat& from, const Quat& to) {
    const Quat q = to * conjugate(from);
    return 2.0 * std::atan2(dot({q.x, q.y, q.z}, axis), q.w);
  }
};

TEST_F(Controls, AViewWithoutItsOrganShowsThatItIsLoading) {
  auto& waiting = child<QLabel>(view_, "waiting");
  for (const ThemeKind kind : {ThemeKind::kDark, ThemeKind::kLight}) {
    view_.setTheme(theme(kind));
    EXPECT_FALSE(waiting.isHidden());
    EXPECT_FALSE(waiting.text().isEmpty());
    EXPECT_EQ(waiting.geometry(), view_.rect());
    EXPECT_EQ(view_.grab().toImage().pixelColor(5, 5), theme(kind).backdrop);
  }

  const LoadedScene bar = testing::loadBar(testing::requestFor("bar"));
  view_.setScene(bar.view);

  EXPECT_TRUE(waiting.isHidden());
}

TEST_F(Controls, TheTipStaysUnderTheMouse) {
  move({500, 300});
  EXPECT_NEAR(tipPixel().x(), 500, kNear_px);
  move({620, 410});
  EXPECT_NEAR(tipPixel().x(), 620, kNear_px);
  EXPECT_NEAR(tipPixel().y(), 410, kNear_px);
}

TEST_F(Controls, TheWheelMovesAlongTheLineOfSight) {
  move({600, 250});
  const Vec3 before = controls_.input().onPlane_m;

  wheel(3);

  const Vec3 way = controls_.input().onPlane_m - before;
  EXPECT_GT(way.y, 0.010);  // away from the viewer: backwards in the patient
  EXPECT_NEAR(tipPixel().x(), 600, kNear_px);
  EXPECT_NEAR(tipPixel().y(), 250, kNear_px);
}

TEST_F(Controls, LeftButtonAndSpaceGripWhileHeld) {
  press({480, 340}, Qt::LeftButton);
  EXPECT_EQ(controls_.input().grip, 1.0);
  release({480, 340}, Qt::LeftButton);
  EXPECT_EQ(controls_.input().grip, 0.0);

  key(QEvent::KeyPress, Qt::Key_Space);
  EXPECT_EQ(controls_.input().grip, 1.0);
  key(QEvent::KeyRelease, Qt::Key_Space);
  EXPECT_EQ(controls_.input().grip, 0.0);
}

TEST_F(Controls, GKeepsTheGripUntilPressedAgain) {
  key(QEvent::KeyPress, Qt::Key_G);
  key(QEvent::KeyRelease, Qt::Key_G);
  EXPECT_EQ(controls_.input().grip, 1.0);
  key(QEvent::KeyPress, Qt::Key_G);
  EXPECT_EQ(controls_.input().grip, 0.0);
}

TEST_F(Controls, EscReleasesAKeptGrip) {
  key(QEvent::KeyPress, Qt::Key_G);
  ASSERT_EQ(controls_.input().grip, 1.0);

  key(QEvent::KeyPress, Qt::Key_Escape);

  EXPECT_EQ(controls_.input().grip, 0.0);
  key(QEvent::KeyPress, Qt::Key_G);  // and G keeps it again
  EXPECT_EQ(controls_.input().grip, 1.0);
}

TEST_F(Controls, LosingFocusReleases) {
  key(QEvent::KeyPress, Qt::Key_Space);
  key(QEvent::KeyPress, Qt::Key_E);

  QFocusEvent out(QEvent::FocusOut);
  QApplication::sendEvent(&view_, &out);
  const double roll = controls_.input().roll_rad;
  controls_.advance(1.0);

  EXPECT_EQ(controls_.input().grip, 0.0);
  EXPECT_EQ(controls_.input().roll_rad, roll);
}

TEST_F(Controls, HeldKeysMoveWithTimeNotWithKeyRepeats) {
  key(QEvent::KeyPress, Qt::Key_E);
  for (int frame = 0; frame < 100; ++frame) {
    controls_.advance(0.01);
  }
  const double once = controls_.input().roll_rad;
  controls_.advance(0.5);
  key(QEvent::KeyRelease, Qt::Key_E);
  controls_.advance(5.0);

  EXPECT_NEAR(once, radians(45.0), radians(1.0));
  EXPECT_NEAR(controls_.input().roll_rad, once + radians(30.0), 1e-6);
}

TEST_F(Controls, ATappedKeyTurnsFinely) {
  for (int tap = 1; tap <= 5; ++tap) {
    key(QEvent::KeyPress, Qt::Key_E);
    for (int frame = 0; frame < 5; ++frame) {
      controls_.advance(0.016);
    }
    key(QEvent::KeyRelease, Qt::Key_E);
    controls_.advance(0.016);
    EXPECT_NEAR(controls_.input().roll_rad, tap * radians(1.2), radians(0.01));
  }
}

// On a slow machine a key may be pressed and released between two frames.
TEST_F(Controls, AKeyTappedBetweenTwoFramesTurnsToo) {
  for (const double frame_s : {0.016, 0.2}) {
    const double before = controls_.input().roll_rad;
    key(QEvent::KeyPress, Qt::Key_E);
    key(QEvent::KeyRelease, Qt::Key_E);
    controls_.advance(frame_s);
    const double turned = controls_.input().roll_rad - before;
    EXPECT_GT(turned, radians(0.2)) << frame_s;
    EXPECT_LT(turned, radians(1.0)) << frame_s;
    controls_.advance(frame_s);
    EXPECT_NEAR(controls_.input().roll_rad, before + turned, kAngle) << "once";
  }
}

TEST_F(Controls, TurningWhatIsHeldTurnsTheToolAboutTheTissuesAxis) {
  const Vec3 axis = normalized(Vec3{0.3, 0.1, 0.9});
  press({480, 340}, Qt::LeftButton);
  const Quat gripped = orientation();
  controls_.setHeldAxis(axis);

  // Twelve steps of five degrees, then as many back and further: unwrapped on the way.
  for (int i = 0; i < 12; ++i) {
    wheel(1, Qt::ShiftModifier);
  }
  EXPECT_NEAR(turnAbout(axis, gripped, orientation()), radians(60.0), kAngle);
  for (int i = 0; i < 30; ++i) {
    wheel(-1, Qt::ShiftModifier);
  }
  EXPECT_NEAR(turnAbout(axis, gripped, orientation()), radians(-90.0), kAngle);
}

TEST_F(Controls, AHandTurnsWhatItHoldsNoFurtherThanItReaches) {
  const Vec3 axis{0.0, 0.0, 1.0};
  press({480, 340}, Qt::LeftButton);
  const Quat gripped = orientation();
  controls_.setHeldAxis(axis, radians(155.0));

  for (int i = 0; i < 60; ++i) {  // 300 degrees
    wheel(1, Qt::ShiftModifier);
  }
  const double most_rad = turnAbout(axis, gripped, orientation());
  for (int i = 0; i < 5; ++i) {
    wheel(-1, Qt::ShiftModifier);
  }

  EXPECT_NEAR(most_rad, radians(155.0), kAngle);
  EXPECT_NEAR(turnAbout(axis, gripped, orientation()), radians(130.0), kAngle);
}

TEST_F(Controls, AnglesContinueSmoothlyThroughMoreThanATurn) {
  // The device smooths the angles separately: they must not jump at a pole of a formula.
  press({480, 340}, Qt::LeftButton);
  controls_.setHeldAxis(Vec3{1.0, 0.0, 0.0});  // the shaft passes the camera's vertical
  double yaw = controls_.input().yaw_rad;
  double roll = controls_.input().roll_rad;
  double pitch = controls_.input().pitch_rad;
  for (int i = 0; i < 90; ++i) {
    wheel(1, Qt::ShiftModifier);
    EXPECT_LT(std::abs(controls_.input().yaw_rad - yaw), 0.5);
    EXPECT_LT(std::abs(controls_.input().pitch_rad - pitch), 0.2);
    EXPECT_LT(std::abs(controls_.input().roll_rad - roll), 0.5);
    yaw = controls_.input().yaw_rad;
    pitch = controls_.input().pitch_rad;
    roll = controls_.input().roll_rad;
  }
}

TEST_F(Controls, DraggingTurnsTheNearSideOfTheTissueWithTheMouse) {
  const Vec3 upright{0.0, 0.0, 1.0};
  press({480, 340}, Qt::LeftButton);
  const Quat gripped = orientation();
  controls_.setHeldAxis(upright);
  const Vec3 before = controls_.input().onPlane_m;

  for (int x = 480; x <= 580; x += 10) {
    move(QPointF(x, 340), Qt::LeftButton);
  }

  // To the right: the front of an upright organ moves to the patient's left, which is positive about the
  // head's direction. The tip stays in place.
  EXPECT_NEAR(turnAbout(upright, gripped, orientation()), radians(50.0), kAngle);
  EXPECT_EQ(controls_.input().onPlane_m, before);
}

TEST_F(Controls, AfterATurnTheTipReturnsUnderTheMouse) {
  press({480, 340}, Qt::LeftButton);
  controls_.setHeldAxis(Vec3{0.0, 0.0, 1.0});
  move({580, 340}, Qt::LeftButton);
  release({580, 340}, Qt::LeftButton);
  controls_.setHeldAxis(std::nullopt);

  move({560, 350}, Qt::NoButton);

  EXPECT_NEAR(tipPixel().x(), 560, kNear_px);
  EXPECT_NEAR(tipPixel().y(), 350, kNear_px);
}

TEST_F(Controls, ReleasingReturnsTheShaft) {
  const double yaw = controls_.input().yaw_rad;
  press({480, 340}, Qt::LeftButton);
  controls_.setHeldAxis(Vec3{0.0, 0.0, 1.0});
  for (int i = 0; i < 40; ++i) {
    wheel(1, Qt::ShiftModifier);
  }
  EXPECT_GT(std::abs(controls_.input().yaw_rad - yaw), 1.0);

  release({480, 340}, Qt::LeftButton);
  controls_.setHeldAxis(std::nullopt);
  for (int i = 0; i < 120; ++i) {
    controls_.advance(0.016);
  }

  EXPECT_NEAR(controls_.input().yaw_rad, yaw, 0.01);
}

TEST_F(Controls, TheShaftLeansAwayFromANearbySurface) {
  const Vec3 outwards{-1.0, 0.0, 0.0};
  controls_.leanAwayFrom(outwards);
  for (int i = 0; i < 120; ++i) {
    controls_.advance(0.016);
  }

  const Vec3 shaft = rotate(orientation(), {0.0, 0.0, 1.0});
  EXPECT_GT(dot(shaft, outwards), 0.4);
  EXPECT_LT(shaft.y, 0.0);  // and still towards the viewer
}

TEST_F(Controls, TheRightButtonTurnsTheCameraButNotTheTool) {
  move({480, 340});
  const Vec3 tip = controls_.input().onPlane_m;
  const QVector3D eye = view_.camera().position();

  press({480, 340}, Qt::RightButton);
  move({560, 300}, Qt::RightButton);

  EXPECT_NE(view_.camera().position(), eye);
  EXPECT_EQ(controls_.input().onPlane_m, tip);
}

TEST_F(Controls, FollowReassignedKeys) {
  constexpr std::size_t kGrip = 12;
  PointerKeys keys;
  ASSERT_STREQ(PointerKeys::movements()[kGrip].id, "grip");
  ASSERT_TRUE(keys.assign(kGrip, Qt::Key_J));
  controls_.setKeys(keys);

  key(QEvent::KeyPress, Qt::Key_Space);
  const double bySpace = controls_.input().grip;
  key(QEvent::KeyPress, Qt::Key_J);
  const double byNewKey = controls_.input().grip;
  key(QEvent::KeyRelease, Qt::Key_J);

  EXPECT_EQ(bySpace, 0.0);
  EXPECT_EQ(byNewKey, 1.0);
  EXPECT_EQ(controls_.input().grip, 0.0);
}

TEST(PointerKeys, AKeyHasOneMovement) {
  PointerKeys keys;

  EXPECT_FALSE(keys.assign(0, Qt::Key_Q));  // twists already
  EXPECT_TRUE(keys.assign(6, Qt::Key_J));
  EXPECT_TRUE(keys.assign(0, Qt::Key_Q));  // free now

  EXPECT_EQ(keys.usualFor(Qt::Key_Q), Qt::Key_Left);
  EXPECT_EQ(keys.usualFor(Qt::Key_J), Qt::Key_Q);
  EXPECT_EQ(keys.usualFor(Qt::Key_Left), 0);
  EXPECT_EQ(keys.usualFor(Qt::Key_X), Qt::Key_X);
}

TEST(PointerKeys, AreStoredForTheNextStart) {
  PointerKeys keys;
  ASSERT_TRUE(keys.assign(6, Qt::Key_J));

  keys.store();
  const PointerKeys again = PointerKeys::stored();
  PointerKeys().store();

  EXPECT_EQ(again.keyOf(6), Qt::Key_J);
  EXPECT_EQ(PointerKeys::stored().keyOf(6), Qt::Key_Q);
}

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
