// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/gui/trainee/twist_guide.h"

class QLabel;
class QLayout;
class QProgressBar;
class QPushButton;

namespace torsio {
class TrainingRun;
class RunSession;
}  // namespace torsio

namespace torsio::gui {

class AngleDial;
class Card;
class DetorsionPanel;
class LevelBar;
class SimulationController;
class ValidityButton;
struct Theme;

/// The panel beside a run: module and phase, remaining time, gauges, feedback on the twists, and buttons for
/// a rest and the end.
class RunPanel : public QWidget {
  Q_OBJECT

 public:
  /// `controller` must outlive the panel.
  explicit RunPanel(SimulationController& controller, QWidget* parent = nullptr);

  /// Sets the run to show from the next retranslate() on; null: none. It must stay valid until another is
  /// set.
  void setRun(const RunSession* run);
  /// Called when the controller has another scene.
  void showScene();
  /// Called when a recording starts.
  void beginRecording(bool haptic);
  /// Updates time and buttons. `started`: the clock runs; `mayRest`: a rest is possible now.
  void showTime(bool started, bool mayRest);
  /// `simulated`: the organ is visible, not a notice.
  void showTold(bool simulated);
  void follow(const LiveState& state);
  [[nodiscard]] const TwistCoach& coach() const noexcept { return coach_; }
  [[nodiscard]] bool onTarget() const;
  void setTheme(const Theme& theme);
  void retranslate();

 Q_SIGNALS:
  void restWanted();
  void endWanted();
  void guideWanted();
  /// Torque or force exceeded the module's limit.
  void limitPassed();

 private:
  QLayout* createHeading(QWidget* panel);
  QWidget* createTime(QWidget* panel);
  QWidget* createAngle(QWidget* panel);
  QLayout* createTold();
  QLayout* createButtons();
  void showCount();

  SimulationController& controller_;
  const RunSession* run_ = nullptr;
  TwistCoach coach_;
  bool simulated_ = false;
  bool turning_ = false;  // a hand is turning what it holds
  bool wasOver_ = false;  // above the limit in the previous frame
  QLabel* title_ = nullptr;
  QLabel* mode_ = nullptr;
  ValidityButton* validity_ = nullptr;
  QPushButton* guideMe_ = nullptr;
  Card* time_ = nullptr;
  QLabel* countdown_ = nullptr;
  QLabel* timeName_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* phase_ = nullptr;
  Card* angle_ = nullptr;
  AngleDial* dial_ = nullptr;
  QLabel* jaw_ = nullptr;
  QLabel* goal_ = nullptr;
  QLabel* count_ = nullptr;
  DetorsionPanel* detorsion_ = nullptr;
  Card* load_ = nullptr;
  LevelBar* torque_ = nullptr;
  LevelBar* force_ = nullptr;
  QLabel* verdict_ = nullptr;
  QLabel* cue_ = nullptr;
  QLabel* warning_ = nullptr;
  QPushButton* rest_ = nullptr;
  QPushButton* end_ = nullptr;
};

class ShellContext;
class TrackerPanel;

/// Shown instead of the organ: a rest, the way to the real arm and its timer, a device being prepared, or no
/// run. Contains the tracker's panel, which belongs to the real arm.
class RunNotice : public QWidget {
  Q_OBJECT

 public:
  enum class Device { kReady, kFetchedBeforeStart, kFetchedInRun };

  explicit RunNotice(ShellContext& shell, QWidget* parent = nullptr);

  [[nodiscard]] TrackerPanel& tracker() noexcept { return *tracker_; }
  /// `inFile`: the previous run's recording is waiting for the database.
  void showNoRun(bool inFile);
  /// Returns whether there is a notice; otherwise the organ is shown.
  bool showRun(const TrainingRun& run, Device device, bool tracked);

 Q_SIGNALS:
  void goOn();

 private:
  void say(const QString& title, const QString& figure, const QString& text, const QString& button);

  QLabel* title_;
  QLabel* figure_;
  QLabel* text_;
  QPushButton* goOn_;
  TrackerPanel* tracker_;
};

}  // namespace torsio::gui
