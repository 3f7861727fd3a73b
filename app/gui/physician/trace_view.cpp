// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/trace_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include "app/gui/physician/review_labels.h"
#include "app/gui/widgets/value_text.h"
#include "sim/core/load_decimals.h"

namespace torsio::gui {

namespace {

constexpr int kLaneGap = 6;
constexpr int kWatchedHeight = 4;
constexpr int kLaneGapOfMany = 3;
constexpr float kWholeScale = 100.0F;  // percent
constexpr float kLostDose = 1.0F;
constexpr float kSmallTorque_Nm = 0.1F;  // torque below which an untwisting is shown in mN m
constexpr float kThousand = 1e3F;
constexpr std::int64_t kTickSteps_us[] = {1'000'000,  2'000'000,   5'000'000,   10'000'000,  30'000'000,
                                          60'000'000, 120'000'000, 300'000'000, 600'000'000, 1'800'000'000};

QString figure(float value, int decimals) {
  return numberText(static_cast<double>(value), decimals);
}

QString withUnit(const QString& size, const QString& unit) {
  const bool close = unit.isEmpty() || unit == QStringLiteral("\u00b0");
  return close ? size + unit : QStringLiteral("%1 %2").arg(size, unit);
}

}  // namespace

TraceView::TraceView(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setCursor(Qt::PointingHandCursor);
  setFocusPolicy(Qt::NoFocus);  // the page's keys move it; needs no focus
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void TraceView::setData(const TraceData* traces) {
  data_ = traces;
  position_us_ = 0;
  bookmarks_us_.clear();
  watched_us_.clear();
  traces_ = QPixmap();
  describe();
  updateGeometry();
  update();
}

void TraceView::setTheme(const Theme& theme) {
  theme_ = &theme;
  traces_ = QPixmap();
  update();
}

void TraceView::retranslate() {
  traces_ = QPixmap();
  describe();
  update();
}

void TraceView::setPosition_us(std::int64_t position_us) {
  if (position_us == position_us_) {
    return;
  }
  position_us_ = position_us;
  update();  // the cursor may not have moved, but the values beside it have changed
}

void TraceView::setBookmarks(std::vector<std::int64_t> times_us) {
  bookmarks_us_ = std::move(times_us);
  describe();
  update();
}

void TraceView::setWatched(std::vector<std::pair<std::int64_t, std::int64_t>> spans_us) {
  watched_us_ = std::move(spans_us);
  update(0, height() - fontMetrics().height() - 3 * kWatchedHeight, width(), height());
}

int TraceView::lineHeights(int ofATwist, int ofALane) const {
  return untwisting() ? 2 + ofALane * static_cast<int>(data_->values.size()) / 4 : ofATwist;
}

QSize TraceView::sizeHint() const {
  return {480, lineHeights(12, 9) * fontMetrics().height()};
}

QSize TraceView::minimumSizeHint() const {
  return {240, lineHeights(9, 7) * fontMetrics().height()};
}

std::int64_t TraceView::duration_us() const noexcept {
  return data_ == nullptr ? 0 : data_->duration_us;
}

QRect TraceView::plot() const {
  const int labels = fontMetrics().horizontalAdvance(QStringLiteral("-0.000 N m ")) + kSpace;
  const int axis = fontMetrics().height() + kWatchedHeight + kSpace;
  return rect().adjusted(std::max(labels, labels_), kSpace / 2, -std::max(kSpace, readings_), -axis);
}

int TraceView::xOf(std::int64_t time_us) const {
  const QRect area = plot();
  const std::int64_t whole = std::max<std::int64_t>(duration_us(), 1);
  return area.left() + static_cast<int>(time_us * (area.width() - 1) / whole);
}

std::size_t TraceView::indexAt(std::int64_t time_us) const {
  const auto found = std::lower_bound(data_->times_us.begin(), data_->times_us.end(), time_us);
  return static_cast<std::size_t>(found - data_->times_us.begin());
}

std::vector<TraceView::Lane> TraceView::lanes() const {
  std::vector<Lane> all;
  for (std::size_t i = 0; data_ != nullptr && i < data_->values.size(); ++i) {
    all.push_back(lane(static_cast<TraceKind>(i)));
  }
  return all;
}

TraceView::Lane TraceView::lane(TraceKind kind) const {
  const RangePyramid& values = data_->values[static_cast<std::size_t>(kind)];
  const RangePyramid::Range whole = values.whole();
  Lane made;
  made.values = &values;
  made.low = std::min(whole.low, 0.0F);
  made.high = std::max(whole.high, made.low + 1e-3F);
  const auto call = [&made](const QString& name, const QString& unit, const QColor& colour) {
    made.name = name;
    made.unit = unit;
    made.colour = colour;
  };
  const auto share = [&](const QString& name, const QColor& colour) {
    call(name, QStringLiteral("%"), colour);
    made.low = 0.0F;
    made.high = kWholeScale;
  };
  switch (kind) {
    case TraceKind::kAngle:
      call(tr("Angle"), QStringLiteral("\u00b0"), theme_->accent);
      break;
    case TraceKind::kTorque:
      call(tr("Torque"), QStringLiteral("N m"), theme_->good);
      break;
    case TraceKind::kForce:
      call(tr("Force"), QStringLiteral("N"), theme_->caution);
      break;
    case TraceKind::kFlow:
      share(tr("Blood flow"), theme_->accent);
      break;
    case TraceKind::kDose:
      call(tr("Ischaemic dose"), QString(), theme_->caution);
      made.high = std::max(made.high, kLostDose);
      made.limit = kLostDose;
      break;
    case TraceKind::kBlack:
      share(tr("Black share"), theme_->text);
      break;
    case TraceKind::kPatency:
      share(tr("Lumen"), theme_->good);
      break;
    case TraceKind::kPressure:
      call(tr("Pressure"), QStringLiteral("mmHg"), theme_->accent);
      break;
  }
  mark(kind, made);
  tellScale(kind, made);
  return made;
}

/// Includes the exercise's target and limits in the scale.
void TraceView::mark(TraceKind kind, Lane& made) const {
  if (!data_->marks) {
    return;
  }
  const TraceMarks& marks = *data_->marks;
  if (kind == TraceKind::kAngle && marks.tolerance_deg > 0.0F && !untwisting()) {
    made.band = {marks.target_deg - marks.tolerance_deg, marks.target_deg + marks.tolerance_deg};
    made.low = std::min(made.low, made.band->first);
    made.high = std::max(made.high, made.band->second);
  }
  // Torque and its limit have the sign of the twist.
  const float sign = kind == TraceKind::kTorque && -made.low > made.high ? -1.0F : 1.0F;
  const std::optional<float> limit = kind == TraceKind::kForce    ? marks.forceLimit_N
                                     : kind == TraceKind::kTorque ? marks.torqueLimit_Nm
                                                                  : std::nullopt;
  if (limit) {
    constexpr float kRoom = 1.05F;
    made.limit = sign * *limit;
    made.low = std::min(made.low, kRoom * *made.limit);
    made.high = std::max(made.high, kRoom * *made.limit);
  }
}

void TraceView::tellScale(TraceKind kind, Lane& made) const {
  const float peak = -made.low > made.high ? made.low : made.high;
  if (untwisting() && kind == TraceKind::kTorque && std::abs(peak) < kSmallTorque_Nm) {
    made.unit = QStringLiteral("mN m");
    made.factor = kThousand;
  }
  const float size = std::abs(peak) * made.factor;
  made.decimals = kind == TraceKind::kForce                           ? kForceDecimals
                  : kind == TraceKind::kTorque && made.factor == 1.0F ? kTorqueDecimals
                  : kind == TraceKind::kDose                          ? 2
                  : size >= 10.0F                                     ? 0
                  : size >= 1.0F                                      ? 1
                                                                      : 2;
  const QString low = made.low == 0.0F ? QStringLiteral("0") : figure(made.low * made.factor, made.decimals);
  made.scale = withUnit(QStringLiteral("%1\u2026%2").arg(low, figure(made.high * made.factor, made.decimals)),
                        made.unit);
}

QStringList TraceView::laneTexts() const {
  QStringList texts;
  for (const Lane& one : lanes()) {
    texts << QStringLiteral("%1 %2").arg(one.name, one.scale);
  }
  return texts;
}

QStringList TraceView::readings() const {
  QStringList texts;
  if (data_ == nullptr || data_->times_us.empty()) {
    return texts;
  }
  // The stretch at the cursor: the last one that begins no later.
  const auto after = std::upper_bound(data_->times_us.begin(), data_->times_us.end(), position_us_);
  const auto index =
      static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - data_->times_us.begin() - 1, 0));
  for (const Lane& one : lanes()) {
    // In a long recording, a stretch has several samples: shows the middle of their range.
    const float value = 0.5F * (one.values->at(2 * index) + one.values->at(2 * index + 1));
    texts << withUnit(figure(value * one.factor, one.decimals), one.unit);
  }
  return texts;
}

void TraceView::layOut() {
  labels_ = 0;
  readings_ = 0;
  for (const Lane& one : lanes()) {
    const auto width = [this](const QString& text) {
      return fontMetrics().horizontalAdvance(text) + 2 * kSpace;
    };
    labels_ = std::max({labels_, width(one.name), width(one.scale)});
    for (const float end : {one.low, one.high}) {
      readings_ = std::max(readings_, width(withUnit(figure(end * one.factor, one.decimals), one.unit)));
    }
  }
}

QRect TraceView::laneArea(std::size_t number) const {
  const QRect area = plot();
  const int count = static_cast<int>(std::max<std::size_t>(data_->values.size(), 1));
  const int gap = untwisting() ? kLaneGapOfMany : kLaneGap;
  const int height = (area.height() - gap * (count - 1)) / count;
  return {area.left(), area.top() + static_cast<int>(number) * (height + gap), area.width(), height};
}

void TraceView::drawTraces() {
  layOut();
  const qreal ratio = devicePixelRatioF();
  traces_ = QPixmap((QSizeF(size()) * ratio).toSize());
  traces_.setDevicePixelRatio(ratio);
  traces_.fill(theme_->window);
  QPainter painter(&traces_);
  painter.setFont(font());
  if (data_ == nullptr || data_->times_us.empty()) {
    return;
  }
  const std::vector<Lane> all = lanes();
  for (std::size_t i = 0; i < all.size(); ++i) {
    drawLane(painter, all[i], laneArea(i));
  }
  drawAxis(painter);
}

void TraceView::drawLane(QPainter& painter, const Lane& lane, const QRect& area) const {
  const auto yOf = [&](float value) {
    const float share = (value - lane.low) / (lane.high - lane.low);
    return area.bottom() - static_cast<int>(std::lround(share * static_cast<float>(area.height() - 3))) - 1;
  };
  painter.fillRect(area, theme_->surface);
  if (lane.band) {
    const auto& [low, high] = *lane.band;
    QColor band = theme_->good;
    band.setAlphaF(0.22F);
    painter.fillRect(QRect(QPoint(area.left(), yOf(high)), QPoint(area.right(), yOf(low))), band);
    painter.setPen(QPen(theme_->good, 1.0, Qt::DashLine));
    const int middle = yOf(0.5F * (low + high));
    painter.drawLine(area.left(), middle, area.right(), middle);
  }
  painter.setPen(theme_->line);
  painter.drawLine(area.left(), yOf(0.0F), area.right(), yOf(0.0F));
  if (lane.limit) {
    painter.setPen(QPen(theme_->quietText, 1.0, Qt::DashLine));
    painter.drawLine(area.left(), yOf(*lane.limit), area.right(), yOf(*lane.limit));
  }
  painter.setPen(lane.colour);
  std::size_t first = 0;
  for (int x = 0; x < area.width(); ++x) {
    const std::int64_t until_us = duration_us() * (x + 1) / area.width();
    const std::size_t last = std::min(std::max(indexAt(until_us), first + 1), data_->times_us.size());
    if (first >= last) {
      break;
    }
    // Overlaps by one stretch to join the columns.
    const RangePyramid::Range range = lane.values->range(2 * (first > 0 ? first - 1 : 0), 2 * last);
    painter.drawLine(area.left() + x, yOf(range.low), area.left() + x, yOf(range.high));
    first = last;
  }
  const int labelWidth = area.left() - kSpace;
  painter.setPen(theme_->text);
  painter.drawText(QRect(0, area.top(), labelWidth, area.height() / 2), Qt::AlignLeft | Qt::AlignBottom,
                   lane.name);
  painter.setPen(theme_->quietText);
  painter.drawText(QRect(0, area.center().y(), labelWidth + kSpace, area.height() / 2),
                   Qt::AlignLeft | Qt::AlignTop, lane.scale);
}

void TraceView::drawReadings(QPainter& painter) const {
  const QStringList texts = readings();
  painter.setPen(theme_->text);
  for (int i = 0; i < texts.size(); ++i) {
    const QRect area = laneArea(static_cast<std::size_t>(i));
    painter.drawText(QRect(area.right() + 1, area.top(), readings_ - kSpace, area.height()),
                     Qt::AlignRight | Qt::AlignVCenter, texts[i]);
  }
}

void TraceView::drawAxis(QPainter& painter) const {
  const QRect area = plot();
  const int width = fontMetrics().horizontalAdvance(QStringLiteral("00:00")) + 2 * kSpace;
  std::int64_t step_us = kTickSteps_us[std::size(kTickSteps_us) - 1];
  for (const std::int64_t candidate : kTickSteps_us) {
    if (xOf(candidate) - area.left() < width) {
      continue;
    }
    step_us = candidate;
    break;
  }
  painter.setPen(theme_->quietText);
  const int top = area.bottom() + kWatchedHeight + kSpace / 2;
  for (std::int64_t time_us = 0; time_us <= duration_us(); time_us += step_us) {
    const int x = xOf(time_us);
    const QString text = clockTime(time_us);
    const int half = fontMetrics().horizontalAdvance(text) / 2;
    const int left = std::clamp(x - half, area.left(), std::max(area.left(), area.right() - 2 * half));
    painter.drawText(left, top + fontMetrics().ascent(), text);
  }
}

void TraceView::paintEvent(QPaintEvent*) {
  if (traces_.isNull()) {
    drawTraces();
  }
  QPainter painter(this);
  painter.drawPixmap(0, 0, traces_);
  const QRect area = plot();
  painter.fillRect(QRect(area.left(), area.bottom() + 2, area.width(), kWatchedHeight), theme_->track);
  for (const auto& [from, to] : watched_us_) {
    const int left = xOf(from);
    painter.fillRect(QRect(left, area.bottom() + 2, std::max(1, xOf(to) - left), kWatchedHeight),
                     theme_->good);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  for (const std::int64_t time_us : bookmarks_us_) {
    const double x = xOf(time_us) + 0.5;
    painter.setPen(QPen(theme_->text, 1.0, Qt::DotLine));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_->text);
    painter.drawPolygon(
        QPolygonF({{x - 5, area.top() - 3.0}, {x + 5, area.top() - 3.0}, {x, area.top() + 5.0}}));
  }
  if (data_ == nullptr) {
    return;
  }
  const double x = xOf(position_us_) + 0.5;
  painter.setPen(QPen(theme_->text, 2.0));
  painter.drawLine(QPointF(x, area.top() - 2), QPointF(x, area.bottom() + kWatchedHeight + 2));
  drawReadings(painter);
}

void TraceView::resizeEvent(QResizeEvent* event) {
  traces_ = QPixmap();
  QWidget::resizeEvent(event);
}

void TraceView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    seek(event->position().toPoint().x());
  }
}

void TraceView::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) != 0) {
    seek(event->position().toPoint().x());
  }
}

void TraceView::seek(int x) {
  if (data_ == nullptr) {
    return;
  }
  const QRect area = plot();
  const std::int64_t along = std::clamp(x - area.left(), 0, area.width() - 1);
  Q_EMIT soughtTo(along * duration_us() / std::max(1, area.width() - 1));
}

void TraceView::describe() {
  layOut();
  QStringList hints;
  if (data_ != nullptr && data_->marks && !untwisting()) {
    hints << tr("Shaded: within the tolerance of the target.");
  }
  if (data_ != nullptr && data_->marks) {
    hints << tr("Dashed across torque and force: the limit of the exercise.");
  }
  if (untwisting()) {
    hints << tr(
        "Dashed: from an ischaemic dose of 1 on the tissue is lost. The black share tells "
        "how much of the outside has turned black from loss");
  }
  setToolTip(hints.join(QLatin1Char('\n')));
  setAccessibleName(untwisting() ? tr("Traces of an untwisting") : tr("Traces of angle, torque and force"));
  if (data_ == nullptr || data_->times_us.empty()) {
    setAccessibleDescription(tr("Nothing is loaded"));
    return;
  }
  const QLocale locale;
  const QString bookmarks = locale.toString(static_cast<qlonglong>(bookmarks_us_.size()));
  if (untwisting()) {
    setAccessibleDescription(tr("%1 long; scales: %2; bookmarks: %3")
                                 .arg(clockTenthsOf(duration_us()), laneTexts().join(tr(", ")), bookmarks));
    return;
  }
  const auto largest = [this, &locale](TraceKind kind, int decimals) {
    const RangePyramid::Range whole = data_->values[static_cast<std::size_t>(kind)].whole();
    return locale.toString(static_cast<double>(std::max(-whole.low, whole.high)), 'f', decimals);
  };
  setAccessibleDescription(
      tr("%1 long; greatest angle %2 degrees, torque %3 newton metres, force %4 newtons; bookmarks: %5")
          .arg(clockTenthsOf(duration_us()), largest(TraceKind::kAngle, 0),
               largest(TraceKind::kTorque, kTorqueDecimals), largest(TraceKind::kForce, kForceDecimals),
               bookmarks));
}

}  // namespace torsio::gui
