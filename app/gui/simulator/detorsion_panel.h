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

/// Status of a twisted organ while it is untwisted, with buttons and keys (C, V, 1, 2, 3) to set a clip, vent
/// gas and check blood flow. Never shows the true flow, only the result of a check, nor the correct
/// direction. Hidden for other scenes.
class DetorsionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit DetorsionPanel(QWidget* parent = nullptr);

  /// Takes the limits of a scene; hides the panel for null or a scene without untwisting.
  void setScene(const Scene* scene);
  /// Connects the buttons to a controller, which must outlive the panel.
  void steer(SimulationController& controller);
  /// Enables or disables buttons and keys; they are disabled during a replay.
  void setUsable(bool usable);
  void show(const LiveState& state);
  void retranslate();

  /// Returns the next instruction for the state shown; empty if the general one applies, and without
  /// untwisting.
  [[nodiscard]] QString cue() const;
  /// Returns the keys of an untwisting: effect and key.
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
  double restTaken_s_ = 0.0;    // rest at the last update of stages_
  double heldFrom_rad_ = 0.0;   // turn of the organ when it was gripped
  double heldLeast_rad_ = 0.0;  // minimum since then
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
