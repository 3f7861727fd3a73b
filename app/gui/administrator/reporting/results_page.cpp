// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/reporting/results_page.h"

#include <utility>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPixmap>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/figure_card.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "assessment/results/cohort_report.h"

namespace torsio::gui {

namespace {

constexpr int kFigureIdRole = Qt::UserRole;
constexpr int kContentsWidth = 300;

const ReportFigure* figureWith(const ReportModel& model, const std::string& id) {
  for (const ReportSection& section : model.sections) {
    for (const ReportFigure& figure : section.figures) {
      if (figure.id == id) {
        return &figure;
      }
    }
  }
  return nullptr;
}

const ReportTable* tableWith(const ReportModel& model, const std::string& id) {
  for (const ReportSection& section : model.sections) {
    for (const ReportTable& table : section.tables) {
      if (table.id == id) {
        return &table;
      }
    }
  }
  return nullptr;
}

}  // namespace

ResultsPage::ResultsPage(ShellContext& shell)
    : Page(shell),
      digests_(std::make_shared<TrialDigests>(shell.assets())),
      heading_(new PageHeading(this)),
      cohort_(new QComboBox(this)),
      campaign_(new QComboBox(this)),
      contents_(named(new QListWidget(this), "contents")),
      empty_(sentence(this)),
      card_(named(new FigureCard(this), "card")) {
  QHBoxLayout* choices = rowOf();
  cohortLabel_ = addField(choices, cohort_);
  choices->addSpacing(2 * kSpace);
  campaignLabel_ = addField(choices, campaign_);
  choices->addStretch(1);
  for (QComboBox* box : {cohort_, campaign_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  }
  contents_->setWordWrap(true);
  contents_->setMinimumWidth(kContentsWidth * 2 / 3);
  contents_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(contents_);
  splitter->addWidget(card_);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({kContentsWidth, 3 * kContentsWidth});
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(2 * kSpace);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addLayout(choices);
  column->addWidget(empty_);
  column->addWidget(splitter, 1);
  contents_->setVisible(false);
  card_->setVisible(false);

  connect(cohort_, &QComboBox::currentIndexChanged, this, &ResultsPage::compute);
  connect(campaign_, &QComboBox::currentIndexChanged, this, &ResultsPage::compute);
  connect(contents_, &QListWidget::currentItemChanged, this, &ResultsPage::showCurrent);
  applyTheme(theme(shell.themeKind()));
  retranslate();
}

void ResultsPage::enter(const QVariant& argument) {
  attempt(shell(), [&] {
    SessionContext& session = shell().session();
    fillCohorts(cohort_, session, CohortFirst::kStudy);
    fillCampaigns(campaign_, session, tr("none"));
    if (argument.isValid()) {
      chooseId(cohort_, argument.toString().toStdString());
    }
    compute();
  });
}

void ResultsPage::compute() {
  ReportRequest request{.cohortId = chosenId(cohort_), .campaignId = chosenId(campaign_)};
  if (request.cohortId.empty()) {
    model_.reset();
    fill();
    return;
  }
  shell().run(
      this, tr("Computing results"),
      [request, digests = digests_](SessionContext& session, const ProgressCallback& progress) {
        return std::make_shared<ReportModel>(
            cohortReport(reportInputs(session, request, *digests, progress)));
      },
      [this](std::shared_ptr<ReportModel> model) {
        model_ = std::move(model);
        fill();
      });
}

void ResultsPage::fill() {
  const QListWidgetItem* before = contents_->currentItem();
  const QString wanted = before != nullptr ? before->data(kFigureIdRole).toString() : QString();
  const QSignalBlocker quiet(contents_);
  contents_->clear();
  QPixmap indent(kSpace, 1);  // also indents the second line of a long title
  indent.fill(Qt::transparent);
  if (model_) {
    for (const ReportSection& section : model_->sections) {
      if (section.figures.empty() && section.tables.empty()) {
        continue;
      }
      auto* head = new QListWidgetItem(toQString(section.title), contents_);
      QFont bold = head->font();
      bold.setBold(true);
      head->setFont(bold);
      head->setFlags(Qt::NoItemFlags | Qt::ItemIsEnabled);
      const auto add = [&](const std::string& id, const Text& title) {
        auto* item = new QListWidgetItem(toQString(title), contents_);
        item->setData(Qt::DecorationRole, indent);
        item->setData(kFigureIdRole, toQString(id));
      };
      for (const ReportFigure& figure : section.figures) {
        add(figure.id, figure.title);
      }
      for (const ReportTable& table : section.tables) {
        add(table.id, table.title);
      }
    }
  }
  const bool some = contents_->count() > 0;
  contents_->setVisible(some);
  card_->setVisible(some);
  empty_->setVisible(!some);
  if (some) {
    showItem(wanted.isEmpty() ? QStringLiteral("figure-22") : wanted);
  }
}

void ResultsPage::showItem(const QString& id) {
  int first = -1;
  for (int i = 0; i < contents_->count(); ++i) {
    const QString here = contents_->item(i)->data(kFigureIdRole).toString();
    if (first < 0 && !here.isEmpty()) {
      first = i;
    }
    if (here != id) {
      continue;
    }
    first = i;
    break;
  }
  if (first < 0) {
    return;
  }
  contents_->setCurrentRow(first);
  contents_->scrollToItem(contents_->item(first));
  showCurrent();
}

void ResultsPage::settle() {
  shell().waitForJobs();
}

void ResultsPage::showCurrent() {
  const QListWidgetItem* item = contents_->currentItem();
  if (item == nullptr || !model_) {
    return;
  }
  const std::string id = item->data(kFigureIdRole).toString().toStdString();
  if (const ReportFigure* figure = figureWith(*model_, id)) {
    card_->setFigure(*figure);
  } else if (const ReportTable* table = tableWith(*model_, id)) {
    card_->setTable(*table);
  }
}

void ResultsPage::retranslate() {
  heading_->setTexts(tr("Results"),
                     tr("Every figure of the report with its values. Ctrl+C copies what is shown."));
  cohortLabel_->setText(tr("&Cohort"));
  campaignLabel_->setText(tr("&Evaluation of models"));
  contents_->setAccessibleName(tr("Figures and tables"));
  empty_->setText(tr("There is nothing to show yet: no cohort has marks or recordings."));
  if (campaign_->count() > 0) {
    campaign_->setItemText(0, tr("none"));
  }
  if (model_) {
    fill();
  }
}

void ResultsPage::applyTheme(const Theme& theme) {
  card_->setTheme(theme);
}

}  // namespace torsio::gui
