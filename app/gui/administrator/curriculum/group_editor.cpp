// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/curriculum/group_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/study/curriculum_content.h"

namespace torsio::gui {

namespace {

constexpr double kDefaultPhase_min = 20.0;
constexpr int kFewRows = 2;

enum PhaseColumn { kWhere, kName, kMinutes, kExercise };

std::vector<std::string> groupCodesOf(const CurriculumVersion& content) {
  std::vector<std::string> codes;
  for (const StudyArm& arm : content.arms) {
    codes.push_back(arm.code);
  }
  return codes;
}

QString lineOf(const StudyArm& arm) {
  return QStringLiteral("%1  %2").arg(toQString(arm.code), toQString(arm.label));
}

double minutes(std::int64_t time_us) {
  return static_cast<double>(time_us) / kMicrosecondsOfMinute;
}

}  // namespace

GroupEditor::GroupEditor(CurriculumVersion& content, QWidget* parent)
    : QWidget(parent),
      content_(content),
      label_(new QLineEdit),
      rest_(numberField(0.0, kMaxMinutes, 1)),
      splittable_(new QCheckBox),
      phases_(named(new QTableWidget(0, 4), "phases")),
      totals_(sentence(nullptr)),
      addPhase_(new QPushButton),
      removePhase_(new QPushButton),
      phaseUp_(new QPushButton),
      phaseDown_(new QPushButton) {
  QVBoxLayout* column = columnOf(this, {});
  list_ = new OrderedList(QStringLiteral("groups"), form(), this);
  column->addWidget(list_);
  connect(list_, &OrderedList::chosen, this, &GroupEditor::showContent);
  connect(list_, &OrderedList::addWanted, this, &GroupEditor::add);
  connect(list_, &OrderedList::removeWanted, this, &GroupEditor::remove);
  connect(list_, &OrderedList::moveWanted, this, &GroupEditor::move);
  connect(code_.field(), &QLineEdit::editingFinished, this, &GroupEditor::takeCode);
  connect(label_, &QLineEdit::textEdited, this, [this](const QString& text) {
    take([&](StudyArm& arm) { arm.label = text.trimmed().toStdString(); });
  });
  connect(rest_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    take([=](StudyArm& arm) { arm.restAllowance_us = std::llround(value * kMicrosecondsOfMinute); });
    splittable_->setEnabled(value > 0.0);
  });
  connect(splittable_, &QCheckBox::toggled, this,
          [this](bool on) { take([=](StudyArm& arm) { arm.restSplittable = on; }); });
  connect(addPhase_, &QPushButton::clicked, this, &GroupEditor::addPhase);
  connect(removePhase_, &QPushButton::clicked, this, &GroupEditor::removePhase);
  connect(phaseUp_, &QPushButton::clicked, this, [this] { movePhase(-1); });
  connect(phaseDown_, &QPushButton::clicked, this, [this] { movePhase(+1); });
}

QWidget* GroupEditor::form() {
  auto* fields = new QWidget;
  auto* form = new QFormLayout(fields);
  form->setSpacing(kSpace);
  form->setContentsMargins(0, 0, 0, 0);
  texts_.row(form, {{label_, QT_TR_NOOP("Name of the group")}, {code_.field(), QT_TR_NOOP("Code")}});
  form->addRow(QString(), code_.problem());
  hints_.add(form, CurriculumField::kCode);
  hints_.add(form, CurriculumField::kTitle);
  rest_->setMaximumWidth(16 * kSpace);
  QHBoxLayout* rest = rowOf({rest_, splittable_}, 2 * kSpace);
  rest->addStretch(1);
  form->addRow(texts_.add(rest_, QT_TR_NOOP("Rest")), rest);
  texts_.title(form, QT_TR_NOOP("Phases, one after the other"));
  prepareFieldTable(phases_);
  phases_->horizontalHeader()->setSectionResizeMode(kName, QHeaderView::Stretch);
  phases_->setColumnWidth(kWhere, 14 * kSpace);
  phases_->setColumnWidth(kMinutes, 10 * kSpace);
  phases_->setColumnWidth(kExercise, 20 * kSpace);
  form->addRow(phases_);
  hints_.add(form, CurriculumField::kPhases);
  form->addRow(buttonRow({addPhase_, removePhase_, phaseUp_, phaseDown_}));
  form->addRow(totals_);
  return fields;
}

StudyArm* GroupEditor::group() {
  return list_->chosenOf(content_.arms);
}

QStringList GroupEditor::lines() const {
  QStringList lines;
  for (const StudyArm& arm : content_.arms) {
    lines << lineOf(arm);
  }
  return lines;
}

void GroupEditor::fill() {
  select(std::max(0, list_->row()));
}

void GroupEditor::select(int row) {
  list_->setLines(lines(), row);
  showContent();
}

void GroupEditor::showContent() {
  if (filling_) {
    return;
  }
  showHints();
  const StudyArm* arm = group();
  const bool change = arm != nullptr && !readOnly_;
  for (QWidget* field : std::initializer_list<QWidget*>{label_, code_.field(), rest_, splittable_, phases_,
                                                        addPhase_, removePhase_, phaseUp_, phaseDown_}) {
    field->setEnabled(change);
  }
  if (arm == nullptr) {
    code_.show({});
    phases_->setRowCount(0);
    totals_->clear();
    return;
  }
  filling_ = true;
  code_.show(arm->code);
  label_->setText(toQString(Text(arm->label)));  // stored unchanged until edited
  rest_->setValue(minutes(arm->restAllowance_us));
  splittable_->setChecked(arm->restSplittable);
  splittable_->setEnabled(change && arm->restAllowance_us > 0);
  filling_ = false;
  showPhases(*arm, phases_->currentRow());
}

void GroupEditor::showProblems(const std::vector<CurriculumProblem>& problems) {
  problems_ = problems;
  showHints();
}

void GroupEditor::showHints() {
  hints_.show(problems_, CurriculumSpot::Part::kArm, static_cast<std::size_t>(std::max(0, list_->row())));
}

void GroupEditor::showPhases(const StudyArm& arm, int current) {
  filling_ = true;
  setFieldRows(phases_, static_cast<int>(arm.phases.size()));
  for (int row = 0; row < phases_->rowCount(); ++row) {
    addPhaseRow(row, arm.phases[static_cast<std::size_t>(row)]);
  }
  fitRows(phases_, kFewRows);
  if (current >= 0 && current < phases_->rowCount()) {
    phases_->setCurrentCell(current, kWhere);
  }
  filling_ = false;
  for (QPushButton* button : {removePhase_, phaseUp_, phaseDown_}) {
    button->setEnabled(!readOnly_ && !arm.phases.empty());
  }
  showTotals(arm);
}

void GroupEditor::addPhaseRow(int row, const TrainingPhase& phase) {
  auto* where = new QComboBox;
  for (const Term<PhaseKind>& term : kPhaseKinds) {
    where->addItem(toQString(labelOf(term.value)), toQString(std::string(term.stored)));
  }
  chooseOrAdd(where, std::string(storedText(phase.kind)));
  auto* name = new QLineEdit(toQString(Text(phase.label)));
  QDoubleSpinBox* time = numberField(0.0, kMaxMinutes, 1);
  time->setValue(minutes(phase.duration_us));
  auto* module = new QComboBox;
  module->addItem(tr("any exercise"), QString());
  for (const TrainingModule& known : content_.modules) {
    module->addItem(QStringLiteral("%1  %2").arg(toQString(known.code), toQString(Text(known.title))),
                    toQString(known.code));
  }
  chooseOrAdd(module, phase.moduleId);
  module->setEnabled(phase.kind != PhaseKind::kReal || !phase.moduleId.empty());
  phases_->setCellWidget(row, kWhere, where);
  phases_->setCellWidget(row, kName, name);
  phases_->setCellWidget(row, kMinutes, time);
  phases_->setCellWidget(row, kExercise, module);
  where->setAccessibleName(tr("Where phase %1 happens").arg(row + 1));
  name->setAccessibleName(tr("Name of phase %1").arg(row + 1));
  time->setAccessibleName(tr("Minutes of phase %1").arg(row + 1));
  module->setAccessibleName(tr("Exercise of phase %1").arg(row + 1));
  connect(where, &QComboBox::activated, this, [this, where, module] {
    takePhase(where, [&](TrainingPhase& changed) {
      changed.kind = fromStoredText<PhaseKind>(chosenId(where)).value_or(changed.kind);
      if (changed.kind == PhaseKind::kReal) {
        changed.moduleId = {};  // only simulator phases have exercises
      }
      module->setCurrentIndex(module->findData(toQString(changed.moduleId)));
      module->setEnabled(changed.kind != PhaseKind::kReal);
    });
  });
  connect(name, &QLineEdit::textEdited, this, [this, name](const QString& text) {
    takePhase(name, [&](TrainingPhase& changed) { changed.label = text.trimmed().toStdString(); });
  });
  connect(time, &QDoubleSpinBox::valueChanged, this, [this, time](double value) {
    takePhase(time, [=](TrainingPhase& changed) {
      changed.duration_us = std::llround(value * kMicrosecondsOfMinute);
    });
  });
  connect(module, &QComboBox::activated, this, [this, module] {
    takePhase(module, [&](TrainingPhase& changed) { changed.moduleId = chosenId(module); });
  });
}

void GroupEditor::showTotals(const StudyArm& arm) {
  std::int64_t virtual_us = 0;
  std::int64_t real_us = 0;
  for (const TrainingPhase& phase : arm.phases) {
    (phase.kind == PhaseKind::kReal ? real_us : virtual_us) += phase.duration_us;
  }
  totals_->setText(
      tr("In all %1 min of training: %2 on the simulator, %3 on the real arm. Rest does not count.")
          .arg(locale().toString(minutes(virtual_us + real_us), 'g', 6),
               locale().toString(minutes(virtual_us), 'g', 6), locale().toString(minutes(real_us), 'g', 6)));
}

void GroupEditor::take(const std::function<void(StudyArm&)>& change) {
  StudyArm* arm = group();
  if (filling_ || arm == nullptr) {
    return;
  }
  change(*arm);
  list_->setCurrentLine(lineOf(*arm));
  showTotals(*arm);
  Q_EMIT edited();
}

void GroupEditor::takePhase(const QWidget* cell, const std::function<void(TrainingPhase&)>& change) {
  const int row = rowOf(phases_, cell);
  take([&](StudyArm& arm) {
    if (row >= 0 && row < std::ssize(arm.phases)) {
      change(arm.phases[static_cast<std::size_t>(row)]);
    }
  });
}

void GroupEditor::takeCode() {
  const StudyArm* arm = group();
  if (filling_ || arm == nullptr) {
    return;
  }
  const std::string before = arm->code;
  const std::optional<std::string> code = code_.changed(
      before, groupCodesOf(content_), tr("A group needs a code; it keeps %1.").arg(toQString(before)),
      tr("Another group has this code; this one keeps %1.").arg(toQString(before)));
  if (!code) {
    return;
  }
  take([&](StudyArm& changed) { changed.code = changed.id = *code; });
}

void GroupEditor::add() {
  StudyArm arm = group() != nullptr ? *group() : StudyArm{};
  arm.code = freeCode("G", groupCodesOf(content_));
  arm.id = arm.code;
  arm.label = tr("New group").toStdString();
  content_.arms.push_back(std::move(arm));
  select(static_cast<int>(content_.arms.size()) - 1);
  label_->setFocus();
  label_->selectAll();
  Q_EMIT edited();
}

void GroupEditor::remove() {
  showOrder(list_->removeChosen(content_.arms));
}

void GroupEditor::move(int by) {
  showOrder(list_->moveChosen(content_.arms, by));
}

void GroupEditor::showOrder(std::optional<int> row) {
  if (row) {
    select(*row);
    Q_EMIT edited();
  }
}

void GroupEditor::addPhase() {
  StudyArm* arm = group();
  if (arm == nullptr) {
    return;
  }
  TrainingPhase phase;
  phase.label = tr("New phase").toStdString();
  phase.duration_us = std::llround(kDefaultPhase_min * kMicrosecondsOfMinute);
  arm->phases.push_back(phase);
  showPhases(*arm, static_cast<int>(arm->phases.size()) - 1);
  Q_EMIT edited();
}

void GroupEditor::removePhase() {
  StudyArm* arm = group();
  const int row = phases_->currentRow() >= 0 ? phases_->currentRow() : phases_->rowCount() - 1;
  if (arm == nullptr || row < 0) {
    return;
  }
  arm->phases.erase(arm->phases.begin() + row);
  showPhases(*arm, std::min(row, static_cast<int>(arm->phases.size()) - 1));
  Q_EMIT edited();
}

void GroupEditor::movePhase(int by) {
  StudyArm* arm = group();
  if (arm == nullptr) {
    return;
  }
  const int row = phases_->currentRow();
  const int to = moved(arm->phases, row, by);
  if (to == row) {
    return;
  }
  showPhases(*arm, to);
  Q_EMIT edited();
}

void GroupEditor::setReadOnly(bool readOnly) {
  readOnly_ = readOnly;
  list_->setReadOnly(readOnly);
  showContent();
}

void GroupEditor::retranslate() {
  texts_.retranslate(staticMetaObject.className());
  rest_->setSuffix(tr(" min"));
  rest_->setSpecialValueText(tr("none"));
  splittable_->setText(tr("may be taken in parts"));
  list_->retranslate();
  list_->setListName(tr("Groups, in their order"));
  phases_->setAccessibleName(tr("Phases, one after the other"));
  addPhase_->setText(tr("Add phase"));
  removePhase_->setText(tr("Remove phase"));
  phaseUp_->setText(tr("Earlier"));
  phaseDown_->setText(tr("Later"));
  phases_->setHorizontalHeaderLabels({tr("Where"), tr("Name"), tr("Minutes"), tr("Exercise")});
  showContent();
}

}  // namespace torsio::gui
