// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of an untwisting, tested with handmade states.
#include "app/gui/simulator/detorsion_panel.h"

#include <numbers>
#include <vector>

#include <QApplication>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/simulator/exercise_panel.h"
#include "app/gui/widgets/child.h"
#include "sim/core/angle.h"
#include "sim/scene/hollow_organ.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/support/shipped_scene.h"

namespace torsio::gui {
namespace {

LiveState stateAtAngle(double angle_rad) {
  LiveState state;
  state.response.angle_rad = angle_rad;
  state.hollow.present = true;
  return state;
}

QString said(const DetorsionPanel& panel, const char* name) {
  const auto* label = panel.findChild<QLabel*>(QLatin1String(name));
  return label == nullptr ? QString() : label->text();
}

class UntwistingPanel : public ::testing::Test {
 protected:
  Scene scene_ = hollowScene(twistedTube());
  DetorsionPanel panel_;
  std::vector<ServoCommand> asked_;

  void SetUp() override {
    panel_.setScene(&scene_);
    QObject::connect(&panel_, &DetorsionPanel::asked,
                     [this](const ServoCommand& command) { asked_.push_back(command); });
  }
};

TEST_F(UntwistingPanel, ShowsAnAngleInDegreesTurnsAndDirection) {
  const LiveState state = stateAtAngle(-3.0 * std::numbers::pi);  // 540 degrees: one and a half turns

  panel_.show(state);

  EXPECT_EQ(said(panel_, "angleLeft"), QStringLiteral("540° · 1.50 turns clockwise"));
}

TEST_F(UntwistingPanel, ShowsOnlyTheFlowThatACheckHasFound) {
  LiveState state = stateAtAngle(1.0);
  state.hollow.reading.flow = 0.31;
  panel_.show(state);
  const QString before = said(panel_, "flowTold");
  state.hollow.check.done = FlowCheck::kDoppler;
  state.hollow.check.flow = 0.62;

  panel_.show(state);

  EXPECT_EQ(before, QStringLiteral("not checked"));
  EXPECT_EQ(said(panel_, "flowTold"), QStringLiteral("Doppler: 62 % ± 8 %"));
}

TEST_F(UntwistingPanel, ShowsTheAgeOfACheck) {
  LiveState state = stateAtAngle(1.0);
  state.hollow.check = {.done = FlowCheck::kTouch, .flow = 0.4, .done_us = 5'000'000};
  const auto toldAt = [&](std::int64_t time_us) {
    state.time_us = time_us;
    panel_.show(state);
    return said(panel_, "flowTold");
  };

  EXPECT_EQ(toldAt(14'999'000), QStringLiteral("Feel the pulse: 40 % ± 20 %"));
  EXPECT_EQ(toldAt(15'000'000), QStringLiteral("Feel the pulse: 40 % ± 20 %, 0:10 ago"));
  EXPECT_EQ(toldAt(71'000'000), QStringLiteral("Feel the pulse: 40 % ± 20 %, 1:00 ago"));
}

TEST_F(UntwistingPanel, ShowsOnTheButtonsWhatTheNextPressDoes) {
  LiveState state = stateAtAngle(1.0);
  panel_.show(state);
  const auto* clip = panel_.findChild<QPushButton*>(QStringLiteral("clip"));
  const auto* vent = panel_.findChild<QPushButton*>(QStringLiteral("vent"));
  const QStringList before{clip->text(), vent->text()};
  state.hollow.clipped = true;
  state.hollow.venting = true;

  panel_.show(state);

  EXPECT_EQ(before, (QStringList{QStringLiteral("Clip (C)"), QStringLiteral("Gas out (V)")}));
  EXPECT_EQ(clip->text(), QStringLiteral("Clip off (C)"));
  EXPECT_EQ(vent->text(), QStringLiteral("Gas stop (V)"));
  EXPECT_TRUE(clip->isChecked() && vent->isChecked());
}

TEST_F(UntwistingPanel, SaysWhatToDoNextAndWhenTheTwistGrows) {
  LiveState state = stateAtAngle(4.0);
  panel_.show(state);
  const QString before = panel_.cue();
  state.phase = ExercisePhase::kTwisting;
  state.response.angle_rad = 3.0;
  panel_.show(state);
  const QString holding = panel_.cue();
  state.response.angle_rad = 4.2;  // 0.2 rad more than when the jaw closed
  panel_.show(state);
  const QString wrong = panel_.cue();
  state.hollow.clipped = true;
  panel_.show(state);
  const QString clipped = panel_.cue();
  state = stateAtAngle(0.1);
  state.hollow.reading.patency = 1.0;

  panel_.show(state);

  EXPECT_EQ(before, QString());
  EXPECT_EQ(holding, QStringLiteral("Holding. Turn, set the clip (C), then re-grip."));
  EXPECT_EQ(wrong, QStringLiteral("The twist is increasing. Turn in the opposite direction."));
  EXPECT_EQ(clipped, QStringLiteral("The clip holds the organ. Remove the clip (C), then turn further."));
  EXPECT_EQ(panel_.cue(), QStringLiteral("Within the limits. Keep your hands off and check the blood flow."));
}

TEST_F(UntwistingPanel, SaysWhenTheHandHasReachedItsLimit) {
  LiveState state = stateAtAngle(6.0);
  panel_.show(state);
  state.phase = ExercisePhase::kTwisting;
  state.response.angle_rad = 6.0 - radians(153.0);
  panel_.show(state);
  const QString before = panel_.cue();
  state.response.angle_rad = 6.0 - radians(155.0);

  panel_.show(state);

  EXPECT_EQ(before, QStringLiteral("Holding. Turn, set the clip (C), then re-grip."));
  EXPECT_EQ(panel_.cue(),
            QStringLiteral("Your hand has reached its limit. Set the clip (C), open the jaw and re-grip."));
}

TEST_F(UntwistingPanel, TwoPressesWithinAFrameUndoEachOther) {
  panel_.show(stateAtAngle(1.0));
  panel_.showNormal();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_));

  for (const Qt::Key key : {Qt::Key_V, Qt::Key_V, Qt::Key_C, Qt::Key_C}) {
    QTest::keyClick(&panel_, key);
  }

  ASSERT_EQ(asked_.size(), 4U);
  EXPECT_EQ(asked_[0].value, 1.0);
  EXPECT_EQ(asked_[1].value, 0.0);
  EXPECT_EQ(asked_[2].value, 1.0);
  EXPECT_EQ(asked_[3].value, 0.0);
}

TEST_F(UntwistingPanel, ShowsTheProgressOfACheck) {
  LiveState state = stateAtAngle(1.0);
  state.time_us = 3'000'000;
  state.hollow.check.running = FlowCheck::kDoppler;  // takes 5 s
  state.hollow.check.ready_us = 4'000'000;           // 4 of 5 s have passed

  panel_.show(state);

  const auto* bar = panel_.findChild<QProgressBar*>(QStringLiteral("checking"));
  ASSERT_NE(bar, nullptr);
  EXPECT_FALSE(bar->isHidden());
  EXPECT_EQ(bar->value(), 800);
  EXPECT_FALSE(child<QPushButton>(panel_, "check").isEnabled());
}

TEST_F(UntwistingPanel, CountsHandsOffTimeOnlyWhileNothingHolds) {
  LiveState state = stateAtAngle(0.0);
  panel_.show(state);
  state.time_us = 2'000'000;
  panel_.show(state);
  const QString counted = said(panel_, "handsOffText");
  state.hollow.clipped = true;

  panel_.show(state);

  EXPECT_TRUE(counted.startsWith(QStringLiteral("Hands off: 2 of"))) << counted.toStdString();
  EXPECT_TRUE(child<QProgressBar>(panel_, "handsOff").isHidden());
}

TEST_F(UntwistingPanel, WarnsOfAJawThatPressesTooHardAndOfATear) {
  LiveState state = stateAtAngle(1.0);
  state.hollow.jaw_Pa = 2.0 * scene_.hollow->detorsion().limits.bruise_Pa;
  panel_.show(state);
  const QString pressed = said(panel_, "tissueWarning");
  state.hollow.leaking = true;

  panel_.show(state);

  EXPECT_TRUE(pressed.startsWith(QStringLiteral("The jaw presses too hard"))) << pressed.toStdString();
  EXPECT_EQ(said(panel_, "tissueWarning"), QStringLiteral("The wall is torn: the content leaks."));
}

TEST_F(UntwistingPanel, RevealsNoDoseOrLossDuringTheRun) {
  const auto texts = [this](double dose) {
    LiveState state = stateAtAngle(1.0);
    state.hollow.reading.dose = dose;
    panel_.show(state);
    QStringList found;
    for (const QWidget* one : panel_.findChildren<QWidget*>()) {
      const auto* label = qobject_cast<const QLabel*>(one);
      found << (label == nullptr ? QString() : label->text()) << one->toolTip() << one->accessibleName()
            << one->accessibleDescription();
    }
    return found;
  };

  const QStringList alive = texts(0.0);
  const QStringList lost = texts(1.3);

  EXPECT_EQ(alive, lost);
  EXPECT_FALSE(lost.join(QLatin1Char(' ')).contains(QStringLiteral("black"), Qt::CaseInsensitive));
}

TEST_F(UntwistingPanel, ItsKeysRequestClipAndChecks) {
  panel_.showNormal();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_));

  QTest::keyClick(&panel_, Qt::Key_C);
  QTest::keyClick(&panel_, Qt::Key_3);

  ASSERT_EQ(asked_.size(), 2U);
  EXPECT_EQ(asked_[0], (ServoCommand{.kind = ServoCommand::Kind::kHoldOrgan, .value = 1.0}));
  EXPECT_EQ(asked_[1], (ServoCommand{.kind = ServoCommand::Kind::kCheckFlow, .value = 3.0}));
}

TEST_F(UntwistingPanel, ItsKeyVentsGasAndClosesTheVentAgain) {
  panel_.showNormal();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_));
  LiveState venting = stateAtAngle(1.0);
  venting.hollow.venting = true;

  QTest::keyClick(&panel_, Qt::Key_V);
  panel_.show(venting);
  QTest::keyClick(&panel_, Qt::Key_V);

  ASSERT_EQ(asked_.size(), 2U);
  EXPECT_EQ(asked_[0], (ServoCommand{.kind = ServoCommand::Kind::kVent, .value = 1.0}));
  EXPECT_EQ(asked_[1], (ServoCommand{.kind = ServoCommand::Kind::kVent, .value = 0.0}));
}

TEST_F(UntwistingPanel, ItsKeyVentsNoGasFromAnOrganWithoutAVent) {
  Detorsion closed = twistedTube();
  closed.wall.vent = false;
  const Scene scene = hollowScene(closed);
  panel_.setScene(&scene);
  panel_.showNormal();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&panel_));

  QTest::keyClick(&panel_, Qt::Key_V);

  EXPECT_TRUE(asked_.empty());
  EXPECT_TRUE(child<QPushButton>(panel_, "vent").isHidden());
}

TEST_F(UntwistingPanel, IsHiddenForASceneWithoutUntwisting) {
  scene_.hollow = nullptr;

  panel_.setScene(&scene_);

  EXPECT_TRUE(panel_.isHidden());
}

/// What the button tells when it is pressed.
QString toldBy(ValidityButton& button) {
  QString told;
  QTimer::singleShot(0, &button, [&told] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    told = box->text();
    box->reject();
  });
  button.click();
  return told;
}

TEST(ValidityBox, SaysUpToWhichTurnTheWallOfASigmoidWasChecked) {
  ValidityButton button;
  button.setScene(&torsio::testing::twistedOrgan("sigmoid"));

  const QString told = toldBy(button);

  EXPECT_TRUE(told.contains(QStringLiteral("104"))) << told.toStdString();
  EXPECT_TRUE(told.contains(QStringLiteral("folds are checked up to 0.5"))) << told.toStdString();
}

TEST(ValidityBox, ShowsTheTextOfItsScene) {
  Detorsion stated = twistedTube();
  stated.validity = "The torque is measured. The blood flow is assumed.";
  const Scene scene = hollowScene(stated);
  ValidityButton button;
  button.setScene(&scene);
  const bool shown = !button.isHidden();

  const QString told = toldBy(button);

  EXPECT_TRUE(shown);
  EXPECT_TRUE(told.startsWith(QStringLiteral("The torque is measured. The blood flow is assumed.")))
      << told.toStdString();  // what is beyond the checked law of the wall follows
}

TEST(ValidityBox, IsHiddenForASceneWithoutAText) {
  const Scene silent = hollowScene(twistedTube());
  const Scene bar = barScene();
  ValidityButton button;

  button.setScene(&silent);
  const bool ofSilent = button.isHidden();
  button.setScene(&bar);

  EXPECT_TRUE(ofSilent);
  EXPECT_TRUE(button.isHidden());
}

}  // namespace
}  // namespace torsio::gui
