// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QString>

namespace torsio::gui {

/// A field for a number that may be negative: shows the minus of print, as everything round it does, and
/// takes both signs. GUI thread.
class SignedBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  [[nodiscard]] QString textFromValue(double value) const override;
  [[nodiscard]] double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& input, int& pos) const override;
};

}  // namespace torsio::gui
