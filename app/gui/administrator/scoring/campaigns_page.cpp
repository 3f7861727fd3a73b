// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/scoring/campaigns_page.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/scene_titles.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/campaign.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kRatersOfRow = 6;  // column

}  // namespace

CampaignsPage::CampaignsPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      add_(primaryButton(this)),
      table_(named(new DataTable(QStringLiteral("campaigns"), this), "campaigns")),
      ratersTitle_(named(new QLabel(this), "cardTitle")),
      raters_(new DataTable(QStringLiteral("campaign-raters"), this)) {
  table_->wrapWhatIsCut();
  heading_->addAction(add_);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(table_, 2);
  column->addWidget(ratersTitle_);
  column->addWidget(raters_, 3);
  connect(add_, &QPushButton::clicked, this, &CampaignsPage::askNew);
  connect(table_, &DataTable::currentChanged, this, &CampaignsPage::showRaters);
  retranslate();
}

void CampaignsPage::enter(const QVariant&) {
  read();
  if (table_->currentId().isEmpty() && !rows_.empty()) {
    table_->select(toQString(rows_.back().campaign.id));
  }
}

void CampaignsPage::read() {
  attempt(shell(), [&] {
    rows_ = torsio::campaigns(shell().session());
    showContent();
  });
}

void CampaignsPage::showContent() {
  std::vector<Row> rows;
  for (const CampaignRow& row : rows_) {
    QStringList models;
    for (const CampaignModel& model : row.campaign.models) {
      models << tr("%1 (shown as %2)").arg(toQString(Text(model.label)), toQString(model.hiddenLabel));
    }
    QStringList raters;
    for (const CampaignRow::Rater& rater : row.raters) {
      raters << toQString(rater.code);
    }
    rows.push_back({toQString(row.campaign.id),
                    {{toQString(Text(row.campaign.name))},
                     {QString::number(row.raters.size()), static_cast<qlonglong>(row.raters.size())},
                     {tr("%1 of %2").arg(countText(row.marksSubmitted), countText(row.marksExpected)),
                      static_cast<qlonglong>(row.marksSubmitted)},
                     {row.campaign.demonstration ? tr("demonstration") : QStringLiteral("\u2013")},
                     timeCell(row.campaign.createdUtc_us),
                     {models.join(tr(", "))},
                     {raters.join(QStringLiteral(", "))}}});
  }
  table_->setRows(std::move(rows));
  showRaters();
}

void CampaignsPage::showRaters() {
  add_->setEnabled(shell().may(Operation::kEvaluationSetup));
  const CampaignId id = table_->currentId().toStdString();
  const auto row =
      std::find_if(rows_.begin(), rows_.end(), [&](const CampaignRow& r) { return r.campaign.id == id; });
  std::vector<Row> rows;
  ratersTitle_->setText(row != rows_.end() ? tr("Raters of %1").arg(toQString(Text(row->campaign.name)))
                                           : QString());
  if (row != rows_.end()) {
    for (const CampaignRow::Rater& rater : row->raters) {
      rows.push_back({toQString(rater.id),
                      {{toQString(rater.code)},
                       {raterClassName(rater.classCode)},
                       {tr("%1 of %2").arg(countText(rater.submitted), countText(rater.expected)),
                        static_cast<qlonglong>(rater.submitted)},
                       {rater.submitted == rater.expected ? tr("done")
                        : rater.submitted == 0            ? tr("not begun")
                                                          : tr("begun")}}});
    }
  }
  raters_->setRows(std::move(rows));
}

bool CampaignsPage::add(const CampaignPlan& plan) {
  return attempt(shell(), [&] {
    const CampaignId id = addCampaign(shell().session(), plan);
    read();
    table_->select(toQString(id));
  });
}

void CampaignsPage::askNew() {
  attempt(shell(), [&] {
    std::vector<PersonRow> raters;
    for (PersonRow& person : people(shell().session())) {
      if (person.rater && person.person.state == PersonState::kActive) {
        raters.push_back(std::move(person));
      }
    }
    CampaignDialog dialog(raters, evaluationRecordings(shell().session()), shell().assets(), this);
    if (dialog.exec() == QDialog::Accepted) {
      add(dialog.plan());
    }
  });
}

void CampaignsPage::retranslate() {
  heading_->setTexts(tr("Evaluation of models"), tr("Raters score tissue models on nine indices; they see "
                                                    "letters, not names, each in a different order."));
  add_->setText(tr("&New evaluation\u2026"));
  table_->setColumns({{tr("Name")},
                      {tr("Raters"), true},
                      {tr("Marks"), true},
                      {tr("Kind")},
                      {tr("Since")},
                      {tr("Models")},
                      {tr("Everybody")}});
  table_->hideAtFirst(kRatersOfRow);  // a search for a rater finds the evaluation
  table_->setEmptyText(
      tr("No evaluation yet. An evaluation asks raters of three classes to score models on nine indices."));
  raters_->setColumns({{tr("Rater")}, {tr("Class")}, {tr("Marks"), true}, {tr("State")}});
  raters_->setEmptyText(tr("Choose an evaluation."));
  showContent();
}

namespace {

constexpr std::int64_t kWhole_milli = 1000;
constexpr int kModelLines = 5;

std::int64_t milli(const QDoubleSpinBox* field) {
  return std::llround(field->value() * static_cast<double>(kWhole_milli));
}

std::int64_t sumOf(const std::vector<QDoubleSpinBox*>& fields) {
  std::int64_t sum = 0;
  for (const QDoubleSpinBox* field : fields) {
    sum += milli(field);
  }
  return sum;
}

QString weightText(std::int64_t weight_milli) {
  return QLocale().toString(static_cast<double>(weight_milli) / static_cast<double>(kWhole_milli), 'f', 3);
}

QDoubleSpinBox* weightField(std::int64_t weight_milli, QWidget* parent) {
  auto* field = ranged(new QDoubleSpinBox(parent), 0.0, 1.0);
  field->setDecimals(3);
  field->setSingleStep(0.05);
  field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field->setValue(static_cast<double>(weight_milli) / static_cast<double>(kWhole_milli));
  return field;
}

/// Returns a model's code in an evaluation, following the paper.
QString codeOf(TissueModel model) {
  switch (model) {
    case TissueModel::kTwist:
      break;
    case TissueModel::kFiniteElements:
      return QStringLiteral("FEM");
    case TissueModel::kMassSpring:
      return QStringLiteral("MSM");
  }
  return QStringLiteral("PM");
}

}  // namespace

CampaignDialog::CampaignDialog(const std::vector<PersonRow>& raters,
                               std::vector<EvaluationRecording> recordings,
                               const std::filesystem::path& assets, QWidget* parent)
    : QDialog(parent),
      instrument_(paperEvaluationInstrument()),
      name_(named(new QLineEdit(this), "name")),
      models_(named(new QPlainTextEdit(this), "models")),
      indexSum_(fieldHint(this)),
      classSum_(fieldHint(this)),
      chosen_(sentence(this)),
      raters_(named(new DataTable(QString(), this), "raters")),
      choice_(std::move(recordings)),
      recordings_(new DataTable(QString(), this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)),
      checks_(new FieldChecks(this)) {
  setWindowTitle(tr("New evaluation"));
  resize(900, 620);
  models_->setTabChangesFocus(true);
  models_->setFixedHeight(kModelLines * models_->fontMetrics().lineSpacing() + 3 * kSpace);
  models_->setPlainText(tr("PM = proposed model\nFEM = finite elements\nMSM = mass-spring"));
  models_->setToolTip(
      tr("Code = name. After a bar (|) you may give the id of a recording made with the model, for all "
         "models or for none: the raters then watch it under its letter."));
  fillRecordings(assets);
  fillRaters(raters);
  auto* form = new QFormLayout;
  form->setSpacing(kSpace);
  auto* left = new QVBoxLayout;
  left->addLayout(form);
  left->addWidget(recordings_, 1);
  left->addWidget(raters_, 2);
  QHBoxLayout* both = rowOf({}, 3 * kSpace);
  both->addLayout(left, 3);
  both->addWidget(weightFields(), 2);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("Create"));
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace});
  column->addLayout(both, 1);
  column->addWidget(buttons_);
  addChecks(form, left);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void CampaignDialog::fillRecordings(const std::filesystem::path& assets) {
  recordings_->setColumns({{tr("Recording")}, {tr("Pattern")}, {tr("Model")}, {tr("Since")}});
  recordings_->setEmptyText(tr("No recordings of free practice yet."));
  std::vector<Row> recorded;
  SceneTitles titles(assets);
  for (const EvaluationRecording& one : choice_) {
    recorded.push_back({toQString(one.trialId),
                        {{titles.scene(one.sceneId)},
                         {titles.pattern(one.sceneId, one.patternId)},
                         {codeOf(one.model)},
                         timeCell(one.startedUtc_us)}});
  }
  recordings_->setRows(std::move(recorded));
  recordings_->view().setSelectionMode(QAbstractItemView::ExtendedSelection);
  recordings_->view().clearSelection();
  recordings_->setToolTip(tr("Choose one recording of each model: the raters watch it under its letter."));
  connect(recordings_, &DataTable::currentChanged, this, &CampaignDialog::takeRecordings);
}

void CampaignDialog::fillRaters(const std::vector<PersonRow>& raters) {
  raters_->setColumns({{tr("Rater")}, {tr("Class")}});
  raters_->setEmptyText(tr("No raters yet: import them under Roster."));
  std::vector<Row> rows;
  for (const PersonRow& rater : raters) {
    rows.push_back(
        {toQString(rater.person.id), {{toQString(rater.person.code)}, {raterClassName(rater.raterClass)}}});
    classOf_[toQString(rater.person.id)] = rater.raterClass;
  }
  raters_->setRows(std::move(rows));
  raters_->view().setSelectionMode(QAbstractItemView::ExtendedSelection);
  raters_->view().selectAll();
}

QWidget* CampaignDialog::weightFields() {
  auto* box = new QWidget(this);
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  form->setSpacing(kSpace / 2);
  const auto addTitle = [&](const QString& title) {
    auto* label = named(new QLabel(title, box), "cardTitle");
    form->addRow(label);
  };
  const auto add = [&](const std::string& name, std::int64_t weight, std::vector<QDoubleSpinBox*>& fields) {
    fields.push_back(weightField(weight, box));
    form->addRow(toQString(Text(name)), fields.back());
  };
  addTitle(tr("Weights of the indices"));
  for (const EvaluationIndex& index : instrument_.indices) {
    add(index.name, index.weight_milli, indexWeights_);
  }
  form->addRow(indexSum_);
  addTitle(tr("Weights of the classes of raters"));
  for (const RaterClass& raterClass : instrument_.classes) {
    add(raterClass.name, raterClass.weight_milli, classWeights_);
  }
  form->addRow(classSum_);
  return box;
}

void CampaignDialog::addChecks(QFormLayout* form, QVBoxLayout* left) {
  form->addRow(tr("&Name"), name_);
  checks_->addNeeded(form, name_, tr("Enter a name."));
  form->addRow(tr("&Models, one per line"), models_);
  checks_->add(form, models_, [this] { return wrongModels(); });
  checks_->add(left, raters_, [this] { return wrongRaters(); });
  left->addWidget(chosen_);
  const auto addSum = [this](QLabel* hint, const std::vector<QDoubleSpinBox*>& fields) {
    checks_->add(hint, fields.back(), [&fields] {
      return sumOf(fields) == kWhole_milli
                 ? QString()
                 : tr("The weights must sum to 1; they sum to %1.").arg(weightText(sumOf(fields)));
    });
    for (const QDoubleSpinBox* field : fields) {
      connect(field, &QDoubleSpinBox::valueChanged, this, [this, &fields] { checks_->touch(fields.back()); });
    }
  };
  addSum(indexSum_, indexWeights_);
  addSum(classSum_, classWeights_);
  for (const QDoubleSpinBox* field : classWeights_) {  // a class with a weight needs raters
    connect(field, &QDoubleSpinBox::valueChanged, this, [this] { checks_->touch(raters_); });
  }
  connect(models_, &QPlainTextEdit::textChanged, this, [this] { checks_->touch(models_); });
  connect(raters_, &DataTable::currentChanged, this, [this] {
    countRaters();
    checks_->touch(raters_);
  });
  countRaters();
  checks_->decide(buttons_->button(QDialogButtonBox::Ok));
  checks_->touch(raters_);  // with all raters listed, a missing one cannot be chosen here
}

QString CampaignDialog::wrongModels() const {
  try {
    requireComparableModels(plan().models);
    return {};
  } catch (const Error& error) {
    const QString where = translated(error).details;
    return where.isEmpty() ? translatedLine(error) : tr("%1: %2").arg(where, translatedLine(error));
  }
}

QString CampaignDialog::wrongRaters() const {
  std::set<std::string> present;
  for (const QString& id : raters_->selectedIds()) {
    present.insert(classOf_.at(id));
  }
  QStringList empty;
  QStringList useless;
  for (std::size_t i = 0; i < classWeights_.size(); ++i) {
    const std::string& code = instrument_.classes[i].id;
    const bool counts = milli(classWeights_[i]) > 0;
    if (counts != present.contains(code)) {
      (counts ? empty : useless) << raterClassName(code);
    }
  }
  if (!empty.isEmpty()) {
    return tr("Choose raters of every class that has a weight. Missing: %1.").arg(empty.join(tr(", ")));
  }
  return useless.isEmpty()
             ? QString()
             : tr("Leave out raters of a class without a weight: %1.").arg(useless.join(tr(", ")));
}

void CampaignDialog::countRaters() {
  chosen_->setText(tr("%n rater(s) chosen.", nullptr, static_cast<int>(raters_->selectedIds().size())));
}

void CampaignDialog::takeRecordings() {
  QStringList lines;
  for (const QString& id : recordings_->selectedIds()) {
    for (const EvaluationRecording& one : choice_) {
      if (toQString(one.trialId) == id) {
        lines << QStringLiteral("%1 = %2 | %3").arg(codeOf(one.model), modelName(one.model), id);
      }
    }
  }
  if (!lines.isEmpty()) {
    models_->setPlainText(lines.join(QLatin1Char('\n')));
  }
}

QString CampaignDialog::modelName(TissueModel model) {
  switch (model) {
    case TissueModel::kTwist:
      break;
    case TissueModel::kFiniteElements:
      return tr("finite elements");
    case TissueModel::kMassSpring:
      return tr("mass-spring");
  }
  return tr("proposed model");
}

CampaignPlan CampaignDialog::plan() const {
  CampaignPlan out{.name = name_->text().trimmed().toStdString(), .instrument = instrument_};
  for (std::size_t i = 0; i < indexWeights_.size(); ++i) {
    out.instrument.indices[i].weight_milli = milli(indexWeights_[i]);
  }
  for (std::size_t i = 0; i < classWeights_.size(); ++i) {
    out.instrument.classes[i].weight_milli = milli(classWeights_[i]);
  }
  for (const QString& line : models_->toPlainText().split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
    const QString code = line.section(QLatin1Char('='), 0, 0).trimmed();
    const QString said = line.section(QLatin1Char('='), 1);
    const QString label = said.section(QLatin1Char('|'), 0, 0).trimmed();
    const QString recording = said.section(QLatin1Char('|'), 1).trimmed();
    if (!line.trimmed().isEmpty()) {
      out.models.push_back(
          {code.toStdString(), (label.isEmpty() ? code : label).toStdString(), recording.toStdString()});
    }
  }
  for (const QString& id : raters_->selectedIds()) {
    out.raterIds.push_back(id.toStdString());
  }
  return out;
}

}  // namespace torsio::gui
