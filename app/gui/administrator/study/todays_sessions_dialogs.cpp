// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/todays_sessions_dialogs.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("DayBoard", text);
}

/// A form that starts with the trainee's code.
class FormDialog : public QuestionDialog {
 public:
  FormDialog(QWidget* parent, const QString& title, const QString& trainee) : QuestionDialog(parent, title) {
    form = new QFormLayout;
    form->setSpacing(kSpace);
    form->addRow(translated(QT_TRANSLATE_NOOP("DayBoard", "Trainee")), new QLabel(trainee, this));
    column()->addLayout(form);
  }

  QFormLayout* form;
};

}  // namespace

std::optional<NewExposure> askExposure(QWidget* parent, const QString& trainee,
                                       const std::map<ExposureKind, QStringList>& unplanned) {
  FormDialog dialog(parent, translated(QT_TRANSLATE_NOOP("DayBoard", "Log time")), trainee);
  auto* kind = named(new QComboBox(&dialog), "exposureKind");
  for (const ExposureKind one : {ExposureKind::kReal, ExposureKind::kVirtual, ExposureKind::kRest}) {
    kind->addItem(toQString(labelOf(one)), QVariant::fromValue(static_cast<int>(one)));
  }
  const auto beside = [kind, &unplanned] {
    const auto found = unplanned.find(static_cast<ExposureKind>(kind->currentData().toInt()));
    return found == unplanned.end() ? QStringList() : found->second;
  };
  while (!beside().isEmpty()) {  // rest is planned for everybody
    kind->setCurrentIndex(kind->currentIndex() + 1);
  }
  auto* minutes = ranged(new QDoubleSpinBox(&dialog), 0.5, 240.0);
  minutes->setDecimals(1);
  minutes->setButtonSymbols(QAbstractSpinBox::NoButtons);
  minutes->setValue(20.0);
  minutes->setSuffix(translated(QT_TRANSLATE_NOOP("DayBoard", " min")));
  dialog.form->addRow(translated(QT_TRANSLATE_NOOP("DayBoard", "&What")), kind);
  dialog.form->addRow(translated(QT_TRANSLATE_NOOP("DayBoard", "&How long")), minutes);
  auto* caution = named(new QLabel(&dialog), "besideThePlan");
  caution->setWordWrap(true);
  setLook(caution, "caution", true);
  auto* reason = named(new QLineEdit(&dialog), "reason");
  reason->setPlaceholderText(translated(QT_TRANSLATE_NOOP("DayBoard", "Why, without names")));
  dialog.form->addRow(caution);
  dialog.form->addRow(translated(QT_TRANSLATE_NOOP("DayBoard", "&Reason")), reason);
  FieldChecks checks(&dialog);
  checks.add(dialog.form, reason, [&] {
    return beside().isEmpty() || !reason->text().trimmed().isEmpty() ? QString() : reasonWanted();
  });
  const auto showPlan = [&] {
    const QStringList codes = beside();
    caution->setText(translated(QT_TRANSLATE_NOOP("DayBoard",
                                                  "! The plan of %1 has no such time. It is logged all the "
                                                  "same, and noted as a deviation."))
                         .arg(firstFew(codes)));
    dialog.form->setRowVisible(caution, !codes.isEmpty());
    dialog.form->setRowVisible(reason, !codes.isEmpty());
    checks.check();
  };
  QObject::connect(kind, &QComboBox::currentIndexChanged, &dialog, showPlan);
  showPlan();
  if (!dialog.ask(translated(QT_TRANSLATE_NOOP("DayBoard", "Log time")), &checks)) {
    return std::nullopt;
  }
  NewExposure exposure{.kind = static_cast<ExposureKind>(kind->currentData().toInt()),
                       .duration_us = static_cast<std::int64_t>(minutes->value() * 60e6),
                       .reason = beside().isEmpty() ? std::string() : reason->text().trimmed().toStdString()};
  return exposure;
}

std::optional<NewDeviation> askDeviation(QWidget* parent, const QString& trainee) {
  FormDialog dialog(parent, translated(QT_TRANSLATE_NOOP("DayBoard", "Report a deviation")), trainee);
  auto* kind = new QComboBox(&dialog);
  for (const Term<DeviationKind>& term : kDeviationKinds) {
    if (term.value < DeviationKind::kTrainedBeforeScoring) {
      kind->addItem(toQString(term.label), toQString(std::string(term.stored)));
    }
  }
  auto* text = new QPlainTextEdit(&dialog);
  text->setTabChangesFocus(true);
  text->setPlaceholderText(translated(QT_TRANSLATE_NOOP("DayBoard", "What happened, without names")));
  dialog.form->addRow(translated(QT_TRANSLATE_NOOP("DayBoard", "&Kind")), kind);
  dialog.form->addRow(translated(QT_TRANSLATE_NOOP("DayBoard", "&What happened")), text);
  if (!dialog.ask(translated(QT_TRANSLATE_NOOP("DayBoard", "Report")))) {
    return std::nullopt;
  }
  NewDeviation deviation{.kind = kind->currentData().toString().toStdString(),
                         .description = text->toPlainText().trimmed().toStdString()};
  return deviation;
}

std::optional<Swap> askSwap(QWidget* parent, const QString& trainee,
                            const std::vector<std::pair<std::string, QString>>& others) {
  FormDialog dialog(parent, translated(QT_TRANSLATE_NOOP("DayBoard", "Swap turns")), trainee);
  auto* other = new QComboBox(&dialog);
  for (const auto& [id, code] : others) {
    other->addItem(code, toQString(id));
  }
  auto* reason = new QLineEdit(&dialog);
  reason->setPlaceholderText(translated(QT_TRANSLATE_NOOP("DayBoard", "Why, without names")));
  dialog.form->addRow(translated(QT_TRANSLATE_NOOP("DayBoard", "&With")), other);
  dialog.form->addRow(translated(QT_TRANSLATE_NOOP("DayBoard", "&Reason")), reason);
  dialog.addNote(translated(QT_TRANSLATE_NOOP(
      "DayBoard", "Their groups stay as drawn; a deviation is noted for both and appears in the report.")));
  other->setFocus();
  if (!dialog.ask(translated(QT_TRANSLATE_NOOP("DayBoard", "Swap")))) {
    return std::nullopt;
  }
  return Swap{other->currentData().toString().toStdString(), reason->text().trimmed().toStdString()};
}

}  // namespace torsio::gui
