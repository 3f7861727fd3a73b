// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/arm_form.h"

#include <cstddef>

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>

#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

// Indices of the fields, in the order in which they are added.
constexpr std::size_t kWidth = 0;
constexpr std::size_t kThickness = 1;
constexpr std::size_t kForearm = 2;
constexpr std::size_t kPalm = 3;
constexpr std::size_t kBreadth = 4;
constexpr std::size_t kHand = 5;
constexpr std::size_t kFirstFinger = 6;

}  // namespace

ArmForm::ArmForm(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2 * kSpace);
  auto* hand = new QFormLayout;
  auto* fingers = new QFormLayout;
  for (QFormLayout* form : {hand, fingers}) {
    form->setVerticalSpacing(kSpace);
  }
  row->addLayout(hand, 1);
  row->addLayout(fingers, 1);
  addLength(*hand, "wristWidth", kWristWidth);
  addLength(*hand, "wristThickness", kWristThickness);
  addLength(*hand, "forearmLength", kForearmLength);
  addLength(*hand, "palmLength", kPalmLength);
  addLength(*hand, "handBreadth", kHandBreadth);
  addLength(*hand, "handThickness", kHandThickness);
  for (const char* name : {"thumb", "indexFinger", "middleFinger", "ringFinger", "littleFinger"}) {
    addLength(*fingers, name, kFingers[fields_.size() - kFirstFinger]);
  }
}

void ArmForm::addLength(QFormLayout& form, const char* name, const PersonLength& range) {
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(QLatin1String(name));
  box->setRange(range.least_mm, range.most_mm);
  box->setDecimals(0);
  box->setSuffix(QStringLiteral(" mm"));
  box->setButtonSymbols(QAbstractSpinBox::NoButtons);
  box->setValue(range.man_mm);
  auto* label = new QLabel(this);
  label->setBuddy(box);
  form.addRow(label, box);
  fields_.push_back({box, label, range.man_mm});
}

PersonArm ArmForm::person() const {
  const auto value_mm = [this](std::size_t field) { return fields_[field].box->value(); };
  const auto changed = [this, value_mm](std::size_t field) {
    return value_mm(field) != fields_[field].man_mm;
  };
  PersonArm person;
  if (changed(kWidth) || changed(kThickness)) {
    person.wristWidth_mm = value_mm(kWidth);
    person.wristThickness_mm = value_mm(kThickness);
  }
  person.forearmLength_mm = value_mm(kForearm);
  person.palmLength_mm = value_mm(kPalm);
  person.handBreadth_mm = value_mm(kBreadth);
  person.handThickness_mm = value_mm(kHand);
  for (std::size_t finger = 0; finger < person.fingers_mm.size(); ++finger) {
    person.fingers_mm[finger] = value_mm(kFirstFinger + finger);
  }
  return person;
}

void ArmForm::reset() {
  for (const Field& field : fields_) {
    field.box->setValue(field.man_mm);
  }
}

void ArmForm::retranslate() {
  const QString names[] = {tr("Wrist, width"), tr("Wrist, thickness"), tr("Forearm, elbow to wrist"),
                           tr("Palm, length"), tr("Hand, breadth"),    tr("Hand, thickness"),
                           tr("Thumb"),        tr("Index finger"),     tr("Middle finger"),
                           tr("Ring finger"),  tr("Little finger")};
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    nameField(fields_[i].label, names[i]);
  }
}

}  // namespace torsio::gui
