// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/signed_box.h"

#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/printed_minus.h"

namespace torsio::gui {

QString SignedBox::textFromValue(double value) const {
  return numberText(value, decimals());
}

double SignedBox::valueFromText(const QString& text) const {
  return QDoubleSpinBox::valueFromText(plainMinus(text));
}

QValidator::State SignedBox::validate(QString& input, int& pos) const {
  QString plain = plainMinus(input);
  return QDoubleSpinBox::validate(plain, pos);
}

}  // namespace torsio::gui
