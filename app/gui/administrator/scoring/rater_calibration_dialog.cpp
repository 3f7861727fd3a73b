// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/scoring/rater_calibration_dialog.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/scene_titles.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/access/all_or_none.h"

namespace torsio::gui {

namespace {

constexpr int kLargestPanel = 99;
constexpr std::ptrdiff_t kUsual = 2;  // usual number of reference runs

}  // namespace

RaterCalibrationDialog::RaterCalibrationDialog(ShellContext& shell, std::vector<RubricRow> rubrics,
                                               QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      rubrics_(std::move(rubrics)),
      state_(new QLabel(this)),
      present_(named(new DataTable(QString(), this), "present")),
      candidates_(named(new DataTable(QStringLiteral("calibration-candidates"), this), "candidates")),
      rubric_(new QComboBox(this)),
      mark_(new QDoubleSpinBox(this)),
      panel_(ranged(new QSpinBox(this), 1, kLargestPanel)),
      withdraw_(new QPushButton(tr("&Withdraw\u2026"), this)),
      add_(new QPushButton(tr("&Add as a reference run"), this)),
      close_(new QPushButton(tr("Close"), this)) {
  setWindowTitle(tr("Reference runs for rater calibration"));
  resize(900, 660);
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace}, kSpace);
  state_->setWordWrap(true);
  column->addWidget(state_);
  present_->setColumns({{tr("Name")},
                        {tr("Recording of")},
                        {tr("Organ")},
                        {tr("Length"), true},
                        {tr("Mark of the panel"), true},
                        {tr("Panel"), true},
                        {tr("Added")},
                        {tr("State")}});
  present_->view().setAccessibleName(tr("Reference runs"));
  present_->setEmptyText(tr("None yet: physicians begin without rater calibration."));
  present_->filter().hide();
  present_->setMaximumHeight(9 * fontMetrics().height());
  column->addWidget(present_);
  withdraw_->setToolTip(tr("No physician is given the chosen run any more; nothing is deleted"));
  column->addWidget(withdraw_, 0, Qt::AlignRight);
  candidates_->setColumns(
      {{tr("Recording of")}, {tr("Organ")}, {tr("Phase")}, {tr("Length"), true}, {tr("Recorded")}});
  candidates_->view().setAccessibleName(tr("Recordings to choose from"));
  candidates_->setEmptyText(
      tr("No recording can be offered: each is being scored, is or was a reference run, or is incomplete."));
  column->addWidget(candidates_, 1);
  createForm();
  connect(candidates_, &DataTable::currentChanged, this, &RaterCalibrationDialog::check);
  connect(present_, &DataTable::currentChanged, this, &RaterCalibrationDialog::check);
  connect(rubric_, &QComboBox::currentIndexChanged, this, &RaterCalibrationDialog::showScale);
  connect(withdraw_, &QPushButton::clicked, this, &RaterCalibrationDialog::withdraw);
  connect(add_, &QPushButton::clicked, this, &RaterCalibrationDialog::add);
  connect(close_, &QPushButton::clicked, this, &QDialog::accept);
  showScale();
  read();
}

void RaterCalibrationDialog::createForm() {
  auto* column = static_cast<QVBoxLayout*>(layout());
  for (const RubricRow& rubric : rubrics_) {
    rubric_->addItem(toQString(Text(rubric.name)), toQString(rubric.id));
  }
  panel_->setValue(2);
  auto* form = new QFormLayout;
  form->setSpacing(kSpace);
  form->addRow(tr("&Rubric"), rubric_);
  form->addRow(tr("&Mark of the panel, points"), mark_);
  form->addRow(tr("&Physicians on the panel"), panel_);
  column->addLayout(form);
  auto* note = new QLabel(tr("The panel scores the run together before it is used. Keep the runs as they are "
                             "where you can, so that every physician calibrates on the same ones."),
                          this);
  note->setWordWrap(true);
  note->setProperty("quiet", true);
  column->addWidget(note);
  add_->setProperty("primary", true);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(close_);
  buttons->addWidget(add_);
  column->addLayout(buttons);
}

const RubricRevision& RaterCalibrationDialog::revision() const {
  return rubrics_.at(static_cast<std::size_t>(std::max(rubric_->currentIndex(), 0))).revisions.back();
}

void RaterCalibrationDialog::showScale() {
  const ScoreScale& scale = revision().overall;
  mark_->setDecimals(1);  // the mean of a panel
  mark_->setRange(pointsFromSteps(scale.lo, scale), pointsFromSteps(scale.hi, scale));
  mark_->setSingleStep(0.5);
}

void RaterCalibrationDialog::read() {
  const QLocale locale = this->locale();
  const std::vector<ReferenceRow> runs = referenceRows(shell_.session());
  const auto given = std::count_if(runs.begin(), runs.end(),
                                   [](const ReferenceRow& run) { return run.withdrawnBecause.empty(); });
  state_->setText(given < kUsual ? tr("Every physician scores these runs before the first real case "
                                      "and sees how far the own mark is "
                                      "from the panel's. Two are usual: one weak, one good.")
                                 : tr("Every physician scores these runs before the first real case "
                                      "and sees how far the own mark is "
                                      "from the panel's."));
  std::vector<Row> present;
  withdrawn_.clear();
  SceneTitles titles(shell_.assets());
  for (const ReferenceRow& run : runs) {
    const bool out = !run.withdrawnBecause.empty();
    if (out) {
      withdrawn_.insert(toQString(run.trialId));
    }
    present.push_back(
        {toQString(run.trialId),
         {{out ? QStringLiteral("\u2013") : tr("Reference %1").arg(run.number), static_cast<int>(run.number)},
          {orDash(run.traineeCode)},
          {titles.scene(run.sceneId)},
          {clockTenthsOf(run.length_us.value_or(0)), static_cast<qlonglong>(run.length_us.value_or(0))},
          {locale.toString(run.panel_points, 'f', 1), run.panel_points},
          {locale.toString(static_cast<qlonglong>(run.panelRaters))},
          timeCell(run.setUtc_us),
          {out ? tr("Withdrawn: %1").arg(toQString(run.withdrawnBecause)) : tr("In use")}}});
  }
  present_->setRows(std::move(present));
  std::vector<Row> rows;
  for (const ReferenceCandidate& one : referenceCandidates(shell_.session())) {
    rows.push_back({toQString(one.trialId),
                    {{orDash(one.traineeCode)},
                     {titles.scene(one.sceneId)},
                     {orDash(toQString(Text(one.phaseLabel)).toStdString())},
                     {clockTenthsOf(one.length_us), static_cast<qlonglong>(one.length_us)},
                     timeCell(one.startedUtc_us)}});
  }
  candidates_->setRows(std::move(rows));
  check();
}

void RaterCalibrationDialog::check() {
  add_->setEnabled(!candidates_->currentId().isEmpty());
  withdraw_->setEnabled(!chosenRuns().isEmpty());
}

void RaterCalibrationDialog::add() {
  attempt(shell_, [this] {
    addReferenceRuns(shell_.session(), {{candidates_->currentId().toStdString(), revision().id,
                                         mark_->value(), panel_->value(), false}});
    read();
    shell_.notify(tr("The reference run is added to rater calibration"));
  });
}

QStringList RaterCalibrationDialog::chosenRuns() const {
  QStringList runs;
  for (const QString& id : present_->selectedIds()) {
    if (!withdrawn_.contains(id)) {
      runs << id;
    }
  }
  return runs;
}

void RaterCalibrationDialog::withdraw() {
  const QStringList chosen = chosenRuns();
  const std::optional<std::string> reason = askReason(
      this, chosen.size() == 1 ? tr("Withdraw a reference run") : tr("Withdraw reference runs"),
      tr("No physician is given the chosen runs any more (%n). Marks given on them stay. A run that "
         "is withdrawn cannot be used for rater calibration again.",
         nullptr, static_cast<int>(chosen.size())));
  if (!reason) {
    return;
  }
  attempt(shell_, [&] {
    allOrNone(shell_.session(), chosen, [&](const QString& run) {
      withdrawReferenceRun(shell_.session(), run.toStdString(), *reason);
    });
    read();
    shell_.notify(
        tr("Withdrawn from rater calibration: %n run(s)", nullptr, static_cast<int>(chosen.size())));
  });
}

}  // namespace torsio::gui
