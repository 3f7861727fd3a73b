// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/scoring/campaigns_page.h"

#include <algorithm>

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/administrator/scoring/campaign_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/campaign.h"

namespace torsio::gui {

namespace {

constexpr int kRatersOfRow = 6;  // column

}  // namespace

CampaignsPage::CampaignsPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      add_(new QPushButton(this)),
      table_(new DataTable(QStringLiteral("campaigns"), this)),
      ratersTitle_(new QLabel(this)),
      raters_(new DataTable(QStringLiteral("campaign-raters"), this)) {
  table_->wrapWhatIsCut();
  table_->setObjectName(QStringLiteral("campaigns"));
  add_->setProperty("primary", true);
  heading_->addAction(add_);
  ratersTitle_->setObjectName(QStringLiteral("cardTitle"));
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

}  // namespace torsio::gui
