// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/trend_page.h"

#include <algorithm>
#include <set>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/trainee/trend_plot.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/joined_sentences.h"
#include "assessment/domain/study/curriculum.h"

namespace torsio::gui {

namespace {

constexpr int kTableHeight = 260;
constexpr std::size_t kFewest = 8;

}  // namespace

TrendPage::TrendPage(ShellContext& context, QWidget* parent) : Page(context, parent) {
  const PageColumn page = pageColumn(this);
  heading_ = page.heading;
  auto* choices = new QHBoxLayout;
  choices->setSpacing(kSpace);
  modules_ = new QComboBox(this);
  metrics_ = new QComboBox(this);
  moduleLabel_ = new QLabel(this);
  moduleLabel_->setBuddy(modules_);
  metricLabel_ = new QLabel(this);
  metricLabel_->setBuddy(metrics_);
  for (QWidget* widget : std::initializer_list<QWidget*>{moduleLabel_, modules_, metricLabel_, metrics_}) {
    choices->addWidget(widget);
  }
  choices->addStretch(1);
  page.column->addLayout(choices);

  auto* cards = new QHBoxLayout;
  cards->setSpacing(2 * kSpace);
  const auto card = [this, cards](QLabel*& figure, QLabel*& text) {
    auto* made = new Card(QString(), this);
    figure = plainLabel(made, "heading");
    text = plainLabel(made, "quiet");
    made->content()->addWidget(figure);
    made->content()->addWidget(text);
    made->content()->addStretch(1);
    cards->addWidget(made, 1);
    return made;
  };
  level_ = card(levelName_, levelMeaning_);
  levelName_->setObjectName(QStringLiteral("level"));
  distance_ = card(distanceFigure_, distanceText_);
  left_ = card(leftFigure_, leftText_);
  page.column->addLayout(cards);
  competence_ = plainLabel(this, "quiet");
  competence_->setObjectName(QStringLiteral("competence"));
  page.column->addWidget(competence_);

  chart_ = new Card(QString(), this);
  plot_ = new TrendPlot(chart_);
  chart_->content()->addWidget(plot_, 1);
  note_ = plainLabel(chart_, "quiet");
  chart_->content()->addWidget(note_);
  page.column->addWidget(chart_, 1);
  table_ = new DataTable(QStringLiteral("station.trend"), this);
  table_->setMinimumHeight(kTableHeight);
  page.column->addWidget(table_);

  connect(modules_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (filling_ || index < 0) {
      return;
    }
    module_ = modules_->itemData(index).toString().toStdString();
    metrics_->setCurrentIndex(-1);
    readTrend();
  });
  connect(metrics_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (!filling_ && index >= 0) {
      readTrend();
    }
  });
  connect(table_, &DataTable::activated, this,
          [this](const QString& id) { shell().open(PageId::kDebrief, id); });
}

void TrendPage::enter(const QVariant& argument) {
  attempt(shell(), [&] {
    steps_ = nextSteps(shell().session(), shell().session().actor().personId);
    const std::string wanted = argument.toString().toStdString();
    const auto has = [&](const std::string& id) {
      return std::any_of(steps_.modules.begin(), steps_.modules.end(),
                         [&](const ModuleStep& step) { return step.module.id == id; });
    };
    if (has(wanted)) {
      module_ = wanted;
    }
    if (!has(module_)) {
      module_.clear();
      std::int64_t newest = -1;
      for (const ModuleStep& step : steps_.modules) {
        const std::int64_t at = step.last ? step.last->startedUtc_us : 0;
        if (at > newest) {
          module_ = step.module.id;
        }
        newest = std::max(newest, at);
      }
    }
  });
  readTrend();
}

void TrendPage::readTrend() {
  attempt(shell(), [&] {
    trend_ = {};
    if (!module_.empty()) {
      const QVariant chosen = metrics_->currentData();
      trend_ = torsio::trend(
          shell().session(), steps_.personId, module_,
          chosen.isValid() ? std::optional(static_cast<Quantity>(chosen.toInt())) : std::nullopt);
    }
  });
  fill();
}

void TrendPage::fillChoices() {
  filling_ = true;
  modules_->clear();
  for (const ModuleStep& step : steps_.modules) {
    modules_->addItem(toQString(Text(step.module.title)), toQString(step.module.id));
  }
  modules_->setCurrentIndex(modules_->findData(toQString(module_)));
  metrics_->clear();
  for (const Quantity quantity : trend_.offered) {
    metrics_->addItem(toQString(Text(rowOf(quantity).name)), static_cast<int>(quantity));
  }
  metrics_->setCurrentIndex(metrics_->findData(static_cast<int>(trend_.quantity)));
  filling_ = false;
}

void TrendPage::chooseQuantity(Quantity quantity) {
  metrics_->setCurrentIndex(metrics_->findData(static_cast<int>(quantity)));
}

void TrendPage::retranslate() {
  fill();
}

void TrendPage::applyTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

void TrendPage::fill() {
  heading_->setTexts(tr("Trend"), tr("Every attempt is kept and shown."));
  moduleLabel_->setText(tr("&Module"));
  metricLabel_->setText(tr("&Quantity"));
  fillChoices();
  level_->setTitle(tr("Level"));
  const CompetenceVerdict& verdict = trend_.competence;
  levelName_->setText(StationLabels::level(verdict));
  setLook(levelName_, "good", verdict.level == SkillLevel::kSteady);
  setLook(levelName_, "caution",
          verdict.level == SkillLevel::kWatch || verdict.level == SkillLevel::kRelapsed);
  levelMeaning_->setText(StationLabels::levelMeaning(verdict));
  competence_->setVisible(verdict.errors.attempts > 0);
  if (verdict.errors.attempts > 0) {
    competence_->setText(StationLabels::competenceRule(verdict) + QLatin1Char('\n') +
                         StationLabels::competenceErrors(verdict));
  }
  distance_->setTitle(tr("Distance to the threshold"));
  const bool answer = isAnswer(trend_.quantity);
  const QString threshold = toQString(shownValue(trend_.quantity, trend_.threshold));
  const bool missed = trend_.distance && *trend_.distance > 0.0;
  distanceFigure_->setText(!trend_.distance ? QStringLiteral("\u2013")
                           : !missed        ? tr("Reached")
                           : answer         ? tr("Not reached")
                                            : toQString(shownValue(trend_.quantity, *trend_.distance)));
  distanceText_->setText(!trend_.distance ? tr("This quantity has no threshold in this module.")
                         : answer         ? tr("in the last run; wanted: %1").arg(threshold)
                         : missed         ? tr("missing in the last run; threshold %1").arg(threshold)
                                          : tr("in the last run; threshold %1").arg(threshold));
  left_->setTitle(tr("Attempts"));
  leftFigure_->setText(QString::number(trend_.points.size()));
  leftText_->setText(trend_.attemptsLeft ? tr("Graded attempts left: %1").arg(*trend_.attemptsLeft)
                                         : tr("No limit in this module."));
  chart_->setTitle(tr("Attempts over time"));
  plot_->setTrend(trend_);
  const QString marks = tr("Filled circle: passed. Triangle: not passed. Grey square: not judged.");
  const bool few = trend_.points.size() < kFewest;
  const QString curve = !trend_.curve.empty() ? tr("Line and band: learning curve with its 95 % band.")
                        : answer              ? tr("A yes or no has no learning curve.")
                        : few                 ? tr("A learning curve is drawn from eight attempts on.")
                                              : tr("No learning curve fits these values.");
  note_->setText(joinedSentences({marks, curve}));
  table_->setColumns({{tr("Attempt"), true},
                      {tr("When")},
                      {tr("Mode")},
                      {toQString(Text(rowOf(trend_.quantity).name)), true},
                      {tr("Result")}});
  table_->setEmptyText(tr("No attempt yet. Your runs at this module appear here."));
  std::vector<Row> rows;
  for (const TrendPoint& point : trend_.points) {
    Row row;
    row.id = toQString(point.trialId);
    row.cells.push_back({QString::number(point.attempt), QVariant::fromValue<qlonglong>(point.attempt)});
    row.cells.push_back(
        {shownTime(point.startedUtc_us), QVariant::fromValue<qlonglong>(point.startedUtc_us)});
    row.cells.push_back({point.mode == AttemptMode::kGraded ? tr("Graded") : tr("Practice")});
    row.cells.push_back({toQString(shownValue(trend_.quantity, point.value)),
                         point.value ? QVariant(*point.value) : QVariant()});
    row.cells.push_back({capitalised(toQString(wordOf(point.outcome)))});
    rows.push_back(std::move(row));
  }
  table_->setRows(std::move(rows));
}

}  // namespace torsio::gui
