// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <QString>
#include <QWidget>

class QButtonGroup;
class QHBoxLayout;

namespace torsio::gui {

/// Offers a few things side by side, one of which is open: the models of an evaluation, the reference runs of
/// a calibration. GUI thread.
class ChoiceRow : public QWidget {
  Q_OBJECT

 public:
  explicit ChoiceRow(QWidget* parent = nullptr);

  /// Shows a button a text in place of those before; `chosen` is pressed, none where it is out of range.
  /// Emits nothing.
  void setChoices(const std::vector<QString>& texts, std::size_t chosen);

 Q_SIGNALS:
  /// A button was pressed: its position among the texts.
  void chosen(std::size_t position);

 private:
  QHBoxLayout* row_;
  QButtonGroup* group_;
};

}  // namespace torsio::gui
