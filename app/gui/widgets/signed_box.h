// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QString>

namespace torsio::gui {

/// A number field that shows a typographic minus, like its surroundings, and accepts both signs. GUI thread.
class SignedBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  [[nodiscard]] QString textFromValue(double value) const override;
  [[nodiscard]] double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& input, int& pos) const override;
};

}  // namespace torsio::gui
