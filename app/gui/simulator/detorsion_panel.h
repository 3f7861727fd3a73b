// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <QString>
#include <QWidget>

#include "sim/core/live_types.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace torsio::gui {

class Card;
class SimulationController;

/// Shows how an organ that came twisted lies while it is undone, and lets the hand set a clip, let gas out
/// and check the blood flow: by buttons and by the keys C, V, 1, 2 and 3. The true flow is never shown, only
/// what a check has told; nor is said which way round is the right one. Hidden for other scenes.
class DetorsionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DetorsionPanel(QWidget* parent = nullptr);

  /// Takes the limits of a scene; null, or a scene that is not undone: hides the panel.
  void setScene(const Scene* scene);
  /// Sends what the buttons ask for to a controller, which must outlive the panel.
  void steer(SimulationController& controller);
  /// Allows or forbids the buttons and their keys; they are forbidden while a recording is replayed.
  void setUsable(bool usable);
  void show(const LiveState& state);
  void retranslate();

  /// Returns what to do next by what is shown; empty where any exercise says the same, and without an
  /// untwisting.
  [[nodiscard]] QString cue() const;
  /// Returns the keys of an untwisting, what and how.
  [[nodiscard]] static std::vector<std::pair<QString, QString>> keys();
  /// Names a check in the user's language.
  [[nodiscard]] static QString checkName(FlowCheck check);
  /// Returns an angle as degrees, turns and direction, seen from the fixed end along the organ's axis.
  [[nodiscard]] static QString angleText(double angle_rad);
  /// Returns the tissue's time in seconds as hours and minutes.
  [[nodiscard]] static QString clockText(double scaled_s);

 Q_SIGNALS:
  void asked(const torsio::ServoCommand& command);

 private:
  struct Row {
    QLabel* name = nullptr;
    QLabel* value = nullptr;
  };
  void createButtons();
  void addKey(int key, const std::function<void()>& action);
  void showRows();
  void showCheck();
  void showRest();
  void showHandsOff();
  void showWarning();
  [[nodiscard]] bool liesWithinLimits() const;
  [[nodiscard]] bool handAtItsEnd() const;
  void enable();

  Detorsion detorsion_;
  bool present_ = false;
  bool usable_ = true;
  LiveState shown_;
  std::int64_t handsOffSince_us_ = -1;
  StagedTurn stages_{{}, 1.0};
  double restTaken_s_ = 0.0;    // when stages_ was last told
  double heldFrom_rad_ = 0.0;   // how far the organ was turned when the jaw took hold of it
  double heldLeast_rad_ = 0.0;  // and since then
  double heldMost_rad_ = 0.0;
  Card* card_;
  Row angle_;
  Row lumen_;
  Row pressure_;
  Row time_;
  Row flow_;
  QLabel* compression_;
  QPushButton* clip_;
  QPushButton* vent_;
  QPushButton* check_;
  std::vector<std::pair<FlowCheck, QAction*>> checks_;
  QProgressBar* checking_;
  QLabel* restText_;
  QProgressBar* rest_;
  QLabel* handsOffText_;
  QProgressBar* handsOff_;
  QLabel* warning_;
};

}  // namespace torsio::gui
