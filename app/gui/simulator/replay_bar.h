// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace torsio {
class TrialPlayback;
}

namespace torsio::gui {

struct Theme;

/// Play, pause, scrub and speed of a recording; shown below the scene while one is played.
class ReplayBar : public QWidget {
  Q_OBJECT

 public:
  explicit ReplayBar(QWidget* parent = nullptr);

  void setTheme(const Theme& theme);
  void retranslate();
  /// Shows this playback; null clears the bar.
  void show(const TrialPlayback* playback);

 Q_SIGNALS:
  void playToggled();
  void soughtTo(qint64 position_us);
  void speedChosen(double speed);
  void closed();

 private:
  const Theme* theme_;
  QToolButton* play_;
  QSlider* position_;
  QLabel* time_;
  QComboBox* speed_;
  QToolButton* close_;
  bool playing_ = false;
};

}  // namespace torsio::gui
