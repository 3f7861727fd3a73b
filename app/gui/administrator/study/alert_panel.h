// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/study/run_day.h"

class QLabel;
class QScrollArea;

namespace torsio::gui {

/// Everything that needs attention on the board of the day: how many of each kind, and each of them, to be
/// scrolled when there are many. Hidden when there is nothing.
class AlertPanel : public QWidget {
 public:
  explicit AlertPanel(QWidget* parent);

  void showAlerts(const std::vector<RunDayAlert>& alerts);

 private:
  [[nodiscard]] QString textOf(const RunDayAlert& alert) const;

  QLabel* counts_;
  QScrollArea* scroll_;
  QLabel* lines_;
};

}  // namespace torsio::gui
