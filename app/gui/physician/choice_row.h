// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <QString>
#include <QWidget>

class QButtonGroup;
class QHBoxLayout;

namespace torsio::gui {

/// A row of alternatives, one of which is selected: models of an evaluation, reference runs of a calibration.
/// GUI thread.
class ChoiceRow : public QWidget {
  Q_OBJECT

 public:
  explicit ChoiceRow(QWidget* parent = nullptr);

  /// Replaces the buttons; `chosen` is selected, none if out of range. Emits nothing.
  void setChoices(const std::vector<QString>& texts, std::size_t chosen);

 Q_SIGNALS:
  /// A button was pressed; its index.
  void chosen(std::size_t position);

 private:
  QHBoxLayout* row_;
  QButtonGroup* group_;
};

}  // namespace torsio::gui
