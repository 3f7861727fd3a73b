// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/services/study/day_board.h"

class QLabel;
class QScrollArea;

namespace torsio::gui {

class FoldLine;

/// Alerts of the day: one line with the number of each kind, which expands to a scrolling list. Hidden if
/// there are none.
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
