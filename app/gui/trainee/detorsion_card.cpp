// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/detorsion_card.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <QHBoxLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/training/detorsion_story.h"
#include "sim/core/angle.h"
#include "sim/scene/hollow_organ.h"

namespace torsio::gui {

namespace {

constexpr double kWorthTelling_s = 0.05;

}  // namespace

DetorsionCard::DetorsionCard(QWidget* parent)
    : QWidget(parent),
      line_(new Card(QString(), this)),
      spent_(new Card(QString(), this)),
      measures_(new Card(QString(), this)),
      plot_(new DetorsionPlot(line_)),
      spentText_(plainLabel(spent_)),
      measuresText_(plainLabel(measures_)) {
  setObjectName(QStringLiteral("untwisting"));
  spentText_->setObjectName(QStringLiteral("secondsSpent"));
  measuresText_->setObjectName(QStringLiteral("untwistingVerdicts"));
  QVBoxLayout* column = columnOf(this, {}, 2 * kSpace);
  auto* row = new QHBoxLayout;
  row->setSpacing(2 * kSpace);
  measures_->content()->addWidget(measuresText_);
  measures_->content()->addStretch(1);
  spent_->content()->addWidget(spentText_);
  spent_->content()->addStretch(1);
  row->addWidget(measures_, 2);
  row->addWidget(spent_, 1);
  column->addLayout(row);
  line_->content()->addWidget(plot_, 1);
  column->addWidget(line_, 1);
  retranslate();
}

void DetorsionCard::setStory(const DetorsionStory& story) {
  story_ = story;
  plot_->setStory(story);
  retranslate();
}

void DetorsionCard::setTheme(const Theme& theme) {
  plot_->setTheme(theme);
}

void DetorsionCard::retranslate() {
  line_->setTitle(tr("Over tissue time"));
  spent_->setTitle(tr("How the time was spent"));
  measures_->setTitle(tr("Findings"));
  spentText_->setText(secondsText(story_).join(QLatin1Char('\n')));
  measuresText_->setText(findings(story_).join(QLatin1Char('\n')));
  plot_->retranslate();
}

QStringList DetorsionCard::secondsText(const DetorsionStory& story) {
  const QString names[kDetorsionDoings] = {tr("Searching, not holding"), tr("Turning in the jaw"),
                                           tr("Held by the clip alone"), tr("Checking the blood flow"),
                                           tr("Waiting with hands off")};
  const double whole_s = std::accumulate(story.spent_s.begin(), story.spent_s.end(), 0.0);
  std::vector<std::size_t> order(kDetorsionDoings);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&story](std::size_t a, std::size_t b) { return story.spent_s[a] > story.spent_s[b]; });
  QStringList out;
  const QLocale locale;
  for (const std::size_t doing : order) {
    const double spent_s = story.spent_s[doing];
    if (spent_s >= kWorthTelling_s) {
      out << tr("%1: %2 (%3 %)")
                 .arg(names[doing], clockTenths(spent_s), locale.toString(100.0 * spent_s / whole_s, 'f', 0));
    }
  }
  return out;
}

QStringList DetorsionCard::findings(const DetorsionStory& story) {
  QStringList out;
  for (const UntwistingFinding& finding : findingsOf(story)) {
    out << toQString(finding.text());
  }
  return out;
}

namespace {

constexpr double kLaneLeft = 52.0;
constexpr double kLaneRight = 16.0;
constexpr double kSignRow = 18.0;
constexpr double kQuarterTurn_deg = 90.0;
constexpr double kNameAbove = 18.0;
constexpr double kTimeBelow = 56.0;
constexpr double kLegendBelow = 20.0;
constexpr double kLegendHeight = 34.0;  // two lines
constexpr double kSignRoom = 13.0;
constexpr double kTipWithin = 6.0;
constexpr double kAir = 7.0;  // around the marks, so that zero is distinct from the frame
constexpr double kLegendGap = 16.0;
constexpr int kTimeMarks = 7;
constexpr double kPressureStep_mmHg = 5.0;

/// Returns the smallest round clock step that needs no more than kTimeMarks steps.
double timeStep_s(double whole_s) {
  constexpr std::array kMinutes{1, 2, 5, 10, 15, 30, 60, 120};
  double step_s = 60.0;
  for (const int minutes : kMinutes) {
    step_s = 60.0 * minutes;
    if (whole_s <= step_s * kTimeMarks) {
      return step_s;
    }
  }
  while (whole_s > step_s * kTimeMarks) {
    step_s *= 2.0;
  }
  return step_s;
}

}  // namespace

DetorsionPlot::DetorsionPlot(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  retranslate();
}

void DetorsionPlot::setStory(const DetorsionStory& story) {
  story_ = story;
  retranslate();
}

void DetorsionPlot::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void DetorsionPlot::retranslate() {
  setAccessibleName(presses() ? tr("Angle, blood flow, dose and pressure over the time of the tissue")
                              : tr("Angle, blood flow and dose over the time of the tissue"));
  if (!story_.time_s.empty()) {
    const QLocale locale;
    QStringList told;
    told << tr("Angle from %1 to %2, blood flow from %3 to %4 %, dose from %5 to %6, in %7 of the tissue.")
                .arg(DetorsionPanel::angleText(story_.angle_rad.front()),
                     DetorsionPanel::angleText(story_.angle_rad.back()),
                     locale.toString(100.0 * story_.flow.front(), 'f', 0),
                     locale.toString(100.0 * story_.flow.back(), 'f', 0),
                     locale.toString(story_.dose.front(), 'f', 2),
                     locale.toString(story_.dose.back(), 'f', 2),
                     DetorsionPanel::clockText(story_.time_s.back() * story_.timeScale));
    if (presses()) {
      told << tr("Pressure from %1 to %2 mmHg.")
                  .arg(locale.toString(story_.pressure_Pa.front() / kPascalsPerMmHg, 'f', 1),
                       locale.toString(story_.pressure_Pa.back() / kPascalsPerMmHg, 'f', 1));
    }
    for (const DetorsionStory::Event& event : story_.events) {
      told << momentText(event);
    }
    setAccessibleDescription(told.join(QLatin1Char('\n')));
  }
  update();
}

QString DetorsionPlot::momentName(DetorsionMoment moment) {
  switch (moment) {
    case DetorsionMoment::kGrip:
      return tr("grip");
    case DetorsionMoment::kLetGo:
      return tr("release");
    case DetorsionMoment::kClipOn:
      return tr("clip on");
    case DetorsionMoment::kClipOff:
      return tr("clip off");
    case DetorsionMoment::kVentOpen:
      return tr("gas out");
    case DetorsionMoment::kVentShut:
      return tr("way out closed");
    case DetorsionMoment::kCheck:
      return tr("check");
    case DetorsionMoment::kBruise:
      return tr("bruise");
    case DetorsionMoment::kTear:
      return tr("tear");
    case DetorsionMoment::kSlip:
      return tr("slipped off");
    case DetorsionMoment::kRelapse:
      return tr("turns back");
  }
  return {};
}

QString DetorsionPlot::momentSign(DetorsionMoment moment) {
  switch (moment) {
    case DetorsionMoment::kGrip:
      return QStringLiteral("\u25bc");
    case DetorsionMoment::kLetGo:
      return QStringLiteral("\u25b3");
    case DetorsionMoment::kClipOn:
      return QStringLiteral("\u25a0");
    case DetorsionMoment::kClipOff:
      return QStringLiteral("\u25a1");
    case DetorsionMoment::kVentOpen:
      return QStringLiteral("V");
    case DetorsionMoment::kVentShut:
      return QStringLiteral("v");
    case DetorsionMoment::kCheck:
      return QStringLiteral("?");
    case DetorsionMoment::kBruise:
      return QStringLiteral("\u25cf");
    case DetorsionMoment::kTear:
      return QStringLiteral("\u00d7");
    case DetorsionMoment::kSlip:
      return QStringLiteral("\u25c6");
    case DetorsionMoment::kRelapse:
      return QStringLiteral("\u21ba");
  }
  return {};
}

QString DetorsionPlot::momentText(const DetorsionStory::Event& event) const {
  return tr("%1 at %2 (%3 of the tissue)")
      .arg(momentName(event.what), clockTenths(event.at_s),
           DetorsionPanel::clockText(event.at_s * story_.timeScale));
}

QString DetorsionPlot::tipAt(double x) const {
  QStringList lines;
  for (const DetorsionStory::Event& event : story_.events) {
    if (std::abs(xOf(event.at_s) - x) <= kTipWithin) {
      lines << momentText(event);
    }
  }
  return lines.join(QLatin1Char('\n'));
}

bool DetorsionPlot::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) {
    return QWidget::event(event);
  }
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString tip = tipAt(help->pos().x());
  if (tip.isEmpty()) {
    QToolTip::hideText();
    event->ignore();
  } else {
    QToolTip::showText(help->globalPos(), tip, this);
  }
  return true;
}

bool DetorsionPlot::presses() const {
  return std::any_of(story_.pressure_Pa.begin(), story_.pressure_Pa.end(), [](double p) { return p != 0.0; });
}

double DetorsionPlot::signsBottom() const {
  // Actions, and mishaps below them.
  const bool mishaps = std::any_of(story_.events.begin(), story_.events.end(),
                                   [](const DetorsionStory::Event& event) { return isMishap(event.what); });
  return (mishaps ? 2.0 : 1.0) * kSignRow + 2.0;
}

int DetorsionPlot::lanes() const {
  return presses() ? 4 : 3;
}

DetorsionPlot::Lane DetorsionPlot::lane(int number, double low, double high) const {
  const double top = signsBottom();
  const double each = (height() - top - kTimeBelow) / lanes();
  return {QRectF(kLaneLeft, top + number * each + kNameAbove, width() - kLaneLeft - kLaneRight,
                 each - kNameAbove - 4.0),
          low, 0.5 * (low + high), high};
}

double DetorsionPlot::xOf(double time_s) const {
  const double whole_s = std::max(1e-3, story_.time_s.back());
  return kLaneLeft + time_s / whole_s * (width() - kLaneLeft - kLaneRight);
}

void DetorsionPlot::drawLane(QPainter& painter, const Lane& lane, const QString& name,
                             const std::vector<double>& values, double scale,
                             std::optional<double> limit) const {
  const auto yOf = [&lane](double value) {
    return lane.area.bottom() - kAir -
           (value - lane.low) / (lane.high - lane.low) * (lane.area.height() - 2.0 * kAir);
  };
  painter.setPen(theme_->quietText);
  painter.drawText(
      QRectF(lane.area.left(), lane.area.top() - kNameAbove, lane.area.width(), kNameAbove - 2.0),
      Qt::AlignLeft | Qt::AlignVCenter, name);
  const int decimals = lane.high - lane.low <= 5.0 ? 1 : 0;
  for (const double value : {lane.low, lane.middle, lane.high}) {
    painter.setPen(theme_->line);
    painter.drawLine(QPointF(lane.area.left(), yOf(value)), QPointF(lane.area.right(), yOf(value)));
    painter.setPen(theme_->quietText);
    painter.drawText(QRectF(0.0, yOf(value) - 8.0, kLaneLeft - 6.0, 16.0), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(value, decimals));
  }
  if (limit) {
    painter.setPen(QPen(theme_->caution, 1.3, Qt::DashLine));
    painter.drawLine(QPointF(lane.area.left(), yOf(*limit)), QPointF(lane.area.right(), yOf(*limit)));
  }
  QPolygonF curve;
  for (std::size_t i = 0; i < story_.time_s.size(); ++i) {
    curve << QPointF(xOf(story_.time_s[i]), yOf(std::clamp(values[i] * scale, lane.low, lane.high)));
  }
  painter.setPen(QPen(theme_->accent, 1.8));
  painter.drawPolyline(curve);
  painter.setPen(theme_->border);
  painter.drawRect(lane.area);
}

void DetorsionPlot::drawTime(QPainter& painter, double bottom) const {
  painter.setPen(theme_->quietText);
  const double whole_s = story_.time_s.back() * story_.timeScale;  // of the tissue's time
  const double step_s = timeStep_s(whole_s);
  for (double at_s = 0.0; at_s <= whole_s; at_s += step_s) {
    const double x = xOf(at_s / story_.timeScale);
    const bool last = x + 40.0 > width();
    const Qt::Alignment side = at_s == 0.0 ? Qt::AlignLeft : last ? Qt::AlignRight : Qt::AlignHCenter;
    const double left = at_s == 0.0 ? 0.0 : last ? 80.0 : 40.0;
    painter.drawText(QRectF(x - left, bottom + 2.0, 80.0, 16.0), static_cast<int>(side.toInt()),
                     DetorsionPanel::clockText(at_s));
  }
}

void DetorsionPlot::drawEvents(QPainter& painter, double bottom) const {
  std::vector<DetorsionMoment> told;
  for (const DetorsionStory::Event& event : story_.events) {
    const double x = xOf(event.at_s);
    QColor faint = isMishap(event.what) ? theme_->caution : theme_->quietText;
    faint.setAlphaF(isMishap(event.what) ? 0.8F : 0.35F);
    painter.setPen(QPen(faint, 1.0));
    for (int i = 0; i < lanes(); ++i) {  // not through the names between the lanes
      const QRectF area = lane(i, 0.0, 1.0).area;
      painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    }
    if (std::find(told.begin(), told.end(), event.what) == told.end()) {
      told.push_back(event.what);
    }
  }
  drawSigns(painter, false);
  drawSigns(painter, true);
  drawLegend(painter, told, bottom + kLegendBelow);
}

QColor DetorsionPlot::signColour(DetorsionMoment moment) const {
  return isMishap(moment) ? theme_->caution : theme_->text;
}

/// Draws each symbol in the colour it has above.
void DetorsionPlot::drawLegend(QPainter& painter, const std::vector<DetorsionMoment>& told,
                               double top) const {
  const QFontMetricsF metrics(painter.font());
  const double line = kLegendHeight / 2.0;
  double x = kLaneLeft;
  for (const DetorsionMoment moment : told) {
    const QString sign = momentSign(moment);
    const QString name = momentName(moment);
    const double signWidth = std::max(metrics.horizontalAdvance(sign), kSignRoom);
    const double wide = signWidth + 3.0 + metrics.horizontalAdvance(name);
    if (x > kLaneLeft && x + wide > width() - kLaneRight) {
      x = kLaneLeft;
      top += line;
    }
    painter.setPen(signColour(moment));
    painter.drawText(QRectF(x, top, signWidth, line), Qt::AlignCenter, sign);
    painter.setPen(theme_->text);
    painter.drawText(QRectF(x + signWidth + 3.0, top, metrics.horizontalAdvance(name) + 1.0, line),
                     Qt::AlignLeft | Qt::AlignVCenter, name);
    x += wide + kLegendGap;
  }
}

void DetorsionPlot::drawSigns(QPainter& painter, bool mishaps) const {
  double free = -1e9;
  for (const DetorsionStory::Event& event : story_.events) {
    if (isMishap(event.what) != mishaps) {
      continue;
    }
    double x = xOf(event.at_s);
    if (x < free) {
      if (!mishaps) {
        continue;  // symbols would overlap; the line remains
      }
      x = free;  // mishaps are never omitted
    }
    free = x + kSignRoom;
    painter.setPen(signColour(event.what));
    painter.drawText(QRectF(x - 10.0, mishaps ? kSignRow : 0.0, 20.0, kSignRow), Qt::AlignCenter,
                     momentSign(event.what));
  }
}

void DetorsionPlot::paintEvent(QPaintEvent*) {
  if (story_.time_s.size() < 2) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont small = font();
  small.setPointSizeF(kSmallText_pt);
  painter.setFont(small);
  double low = 0.0;
  double high = 0.0;
  for (const double angle : story_.angle_rad) {
    low = std::min(low, degrees(angle));
    high = std::max(high, degrees(angle));
  }
  const double dose = *std::max_element(story_.dose.begin(), story_.dose.end());
  low = kQuarterTurn_deg * std::floor(low / kQuarterTurn_deg);
  high = std::max(low + kQuarterTurn_deg, kQuarterTurn_deg * std::ceil(high / kQuarterTurn_deg));
  Lane angles = lane(0, low, high);
  if (high - low > 2.0 * kQuarterTurn_deg) {
    angles.middle = kQuarterTurn_deg * std::round(angles.middle / kQuarterTurn_deg);
  }
  const Lane doses = lane(2, 0.0, std::max(1.0, 1.1 * dose));
  drawLane(painter, angles, tr("Angle in degrees"), story_.angle_rad, kDegreesPerRadian, 0.0);
  drawLane(painter, lane(1, 0.0, 100.0), tr("Blood flow in % of the untwisted organ"), story_.flow, 100.0,
           100.0 * story_.enoughFlow);
  drawLane(painter, doses, tr("Ischaemic dose: from 1 on the tissue is lost"), story_.dose, 1.0, 1.0);
  double bottom = doses.area.bottom();
  if (presses()) {
    const double most_Pa = *std::max_element(story_.pressure_Pa.begin(), story_.pressure_Pa.end());
    const double steps = std::ceil(most_Pa / kPascalsPerMmHg / kPressureStep_mmHg);
    const Lane pressures = lane(3, 0.0, kPressureStep_mmHg * std::max(1.0, steps));
    drawLane(painter, pressures, tr("Pressure of the content in mmHg"), story_.pressure_Pa,
             1.0 / kPascalsPerMmHg, std::nullopt);
    bottom = pressures.area.bottom();
  }
  drawTime(painter, bottom);
  drawEvents(painter, bottom);
}

}  // namespace torsio::gui
