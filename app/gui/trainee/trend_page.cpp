// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/trend_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
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
  QHBoxLayout* choices = rowOf();
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

  QHBoxLayout* cards = rowOf({}, 2 * kSpace);
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
  competence_ = named(plainLabel(this, "quiet"), "competence");
  page.column->addWidget(competence_);
  rates_ = named(new FoldedText(this), "rates");
  page.column->addWidget(rates_);

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
          verdict.level == SkillLevel::kWatch || verdict.level == SkillLevel::kRelapsed ||
              verdict.level == SkillLevel::kExpired);
  levelMeaning_->setText(StationLabels::levelMeaning(verdict));
  for (QWidget* ofLevel : std::initializer_list<QWidget*>{competence_, rates_}) {
    ofLevel->setVisible(verdict.planned.attempts > 0);
  }
  if (verdict.planned.attempts > 0) {
    competence_->setText(StationLabels::competenceBeside(verdict));
    rates_->setTexts(StationLabels::howOftenWrong(), StationLabels::competenceErrors(verdict));
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

namespace {

constexpr double kTrendLeft = 62.0;
constexpr double kTrendRight = 20.0;
constexpr double kTrendTop = 26.0;
constexpr double kTrendBottom = 44.0;
constexpr double kMark = 5.0;

}  // namespace

TrendPlot::TrendPlot(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void TrendPlot::setTrend(const Trend& trend) {
  trend_ = trend;
  findRange();
  retranslate();
}

void TrendPlot::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void TrendPlot::retranslate() {
  setAccessibleName(tr("%1 over the attempts").arg(toQString(Text(rowOf(trend_.quantity).name))));
  QStringList values;
  for (const TrendPoint& point : trend_.points) {
    if (point.value) {
      values << toQString(shownValue(trend_.quantity, *point.value));
    }
  }
  setAccessibleDescription(values.join(QStringLiteral(", ")));
  update();
}

void TrendPlot::findRange() {
  std::vector<double> seen;
  for (const TrendPoint& point : trend_.points) {
    if (point.value) {
      seen.push_back(shown(*point.value));
    }
  }
  for (const TrendCurvePoint& point : trend_.curve) {
    seen.push_back(shown(point.value));
  }
  if (trend_.threshold) {
    seen.push_back(shown(*trend_.threshold));
  }
  if (seen.empty()) {
    seen = {0.0, 1.0};
  }
  const auto [low, high] = std::minmax_element(seen.begin(), seen.end());
  // Identical values (no violation in any attempt) still need a meaningful axis.
  const double flat = *high == 0.0 ? 1.0 : 0.05 * std::abs(*high);
  const double room = *high > *low ? std::max(0.12 * (*high - *low), 0.05 * std::abs(*high)) : flat;
  if (isAnswer(trend_.quantity)) {
    low_ = -0.25;
    high_ = 1.25;
    return;
  }
  low_ = *low >= 0.0 ? std::max(0.0, *low - room) : *low - room;
  high_ = *high + room;
}

double TrendPlot::shown(double value) const {
  return value * rowOf(trend_.quantity).shown.scale;
}

double TrendPlot::xOf(double attempt) const {
  const double last = std::max<double>(4.0, static_cast<double>(trend_.points.size()));
  return kTrendLeft + 14.0 + (attempt - 1.0) / (last - 1.0) * (width() - kTrendLeft - kTrendRight - 28.0);
}

double TrendPlot::yOf(double value) const {
  return height() - kTrendBottom - (value - low_) / (high_ - low_) * (height() - kTrendTop - kTrendBottom);
}

std::vector<double> TrendPlot::marks() const {
  const double power = std::pow(10.0, std::floor(std::log10((high_ - low_) / 4.0)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    step = factor * power;
    if ((high_ - low_) / step <= 6.0) {
      break;
    }
  }
  if (rowOf(trend_.quantity).traits.kind != QuantityKind::kMeasure) {
    step = std::max(1.0, std::round(step));
  }
  std::vector<double> all;
  for (auto at = static_cast<std::int64_t>(std::ceil(low_ / step)); static_cast<double>(at) * step <= high_;
       ++at) {
    all.push_back(static_cast<double>(at) * step);
  }
  return all;
}

void TrendPlot::drawGrid(QPainter& painter) const {
  QFont small = font();
  small.setPointSizeF(kSmallText_pt);
  painter.setFont(small);
  const bool answer = isAnswer(trend_.quantity);
  const std::vector<double> values = marks();
  const double step = values.size() > 1 ? values[1] - values[0] : 1.0;
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  for (const double v : values) {
    painter.setPen(theme_->line);
    painter.drawLine(QPointF(kTrendLeft, yOf(v)), QPointF(width() - kTrendRight, yOf(v)));
    painter.setPen(theme_->quietText);
    painter.drawText(QRectF(0.0, yOf(v) - 9.0, kTrendLeft - 8.0, 18.0), Qt::AlignRight | Qt::AlignVCenter,
                     answer ? toQString(shownValue(trend_.quantity, v)) : numberText(v, decimals));
  }
  const std::size_t last = std::max<std::size_t>(4, trend_.points.size());
  const std::size_t every = last > 20 ? last / 10 : 1;
  for (std::size_t a = 1; a <= last; a += every) {
    painter.drawText(QRectF(xOf(static_cast<double>(a)) - 20.0, height() - kTrendBottom + 8.0, 40.0, 16.0),
                     Qt::AlignHCenter, QString::number(a));
  }
  painter.drawText(QRectF(kTrendLeft, height() - 20.0, width() - kTrendLeft - kTrendRight, 18.0),
                   Qt::AlignHCenter, tr("Attempt"));
  painter.drawText(QRectF(0.0, 2.0, width(), 18.0), Qt::AlignLeft, toQString(titleWithUnit(trend_.quantity)));
}

void TrendPlot::drawCurve(QPainter& painter) const {
  if (trend_.curve.empty()) {
    return;
  }
  QPolygonF middle;
  QPolygonF band;
  for (const TrendCurvePoint& point : trend_.curve) {
    middle << QPointF(xOf(point.attempt), yOf(shown(point.value)));
    band << QPointF(xOf(point.attempt), yOf(shown(point.upper)));
  }
  for (auto point = trend_.curve.rbegin(); point != trend_.curve.rend(); ++point) {
    band << QPointF(xOf(point->attempt), yOf(shown(point->lower)));
  }
  QColor shade = theme_->accent;
  shade.setAlphaF(0.13F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(shade);
  painter.drawPolygon(band);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme_->accent, 2.0));
  painter.drawPolyline(middle);
}

void TrendPlot::drawPoints(QPainter& painter) const {
  for (const TrendPoint& point : trend_.points) {
    if (!point.value) {
      continue;
    }
    const QPointF at(xOf(static_cast<double>(point.attempt)), yOf(shown(*point.value)));
    const bool passed = point.outcome == RunOutcome::kPassed;
    const QColor colour = passed                                    ? theme_->good
                          : point.outcome == RunOutcome::kNotJudged ? theme_->quietText
                                                                    : theme_->caution;
    painter.setPen(QPen(colour, 2.0));
    painter.setBrush(passed ? colour : theme_->surface);
    if (passed) {
      painter.drawEllipse(at, kMark, kMark);
    } else if (point.outcome == RunOutcome::kNotJudged) {
      painter.drawRect(QRectF(at.x() - kMark, at.y() - kMark, 2.0 * kMark, 2.0 * kMark));
    } else {
      painter.drawPolygon(QPolygonF({at + QPointF(0.0, -kMark - 1.0), at + QPointF(kMark + 1.0, kMark),
                                     at + QPointF(-kMark - 1.0, kMark)}));
    }
  }
}

void TrendPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawGrid(painter);
  painter.setClipRect(QRectF(kTrendLeft, kTrendTop - 6.0, width() - kTrendLeft - kTrendRight,
                             height() - kTrendTop - kTrendBottom + 12.0));
  if (trend_.threshold) {
    const double y = yOf(shown(*trend_.threshold));
    painter.setPen(QPen(theme_->text, 1.4, Qt::DashLine));
    painter.drawLine(QPointF(kTrendLeft, y), QPointF(width() - kTrendRight, y));
    painter.setPen(theme_->text);
    const bool answer = isAnswer(trend_.quantity);  // its points lie on grid lines
    painter.drawText(
        QRectF(kTrendLeft, y - (answer ? 26.0 : 18.0), width() - kTrendLeft - kTrendRight - 6.0, 16.0),
        Qt::AlignRight, tr("threshold"));
  }
  drawCurve(painter);
  drawPoints(painter);
}

}  // namespace torsio::gui
