// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace torsio {
class TrainingRun;
}

namespace torsio::gui {

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
