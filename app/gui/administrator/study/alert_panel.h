// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/services/study/day_board.h"

class QLabel;
class QScrollArea;

namespace torsio::gui {

class FoldLine;

/// Everything that needs attention on the board of the day: one line that says how many of each kind there
/// are, and each of them behind it, to be scrolled when there are many. Hidden when there is nothing.
class AlertPanel : public QWidget {
 public:
  explicit AlertPanel(QWidget* parent);

  void showAlerts(const std::vector<DayAlert>& alerts);
  void retranslate();

 private:
  [[nodiscard]] QString textOf(const DayAlert& alert) const;

  FoldLine* line_;
  QScrollArea* scroll_;
  QLabel* lines_;
};

}  // namespace torsio::gui
