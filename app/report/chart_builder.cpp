// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/chart_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <QBarCategoryAxis>
#include <QBarSeries>
#include <QBarSet>
#include <QBoxPlotSeries>
#include <QBoxSet>
#include <QCategoryAxis>
#include <QChart>
#include <QFont>
#include <QGraphicsLayout>
#include <QLegend>
#include <QLegendMarker>
#include <QLineSeries>
#include <QPen>
#include <QScatterSeries>
#include <QValueAxis>

#include "app/report/category_labels.h"
#include "app/report/heat_map_item.h"
#include "app/report/typeface.h"
#include "app/report/upright_title.h"
#include "sim/base/contracts.h"

namespace torsio {

namespace {

constexpr std::size_t kFewPoints = 14;  // lines with no more points carry markers

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  [[nodiscard]] bool empty() const { return !(low <= high); }
};

constexpr std::array kMarkers{
    QScatterSeries::MarkerShapeCircle,   QScatterSeries::MarkerShapeRectangle,
    QScatterSeries::MarkerShapeTriangle, QScatterSeries::MarkerShapeRotatedRectangle,
    QScatterSeries::MarkerShapePentagon, QScatterSeries::MarkerShapeStar};

/// Draws one figure into one chart.
class Builder {
 public:
  Builder(const ReportFigure& figure, const ChartLook& look, const Wording& wording)
      : figure_(figure), look_(look), say_(wording), chart_(std::make_unique<QChart>()) {}

  std::unique_ptr<QChart> take() {
    prepare();
    switch (figure_.kind) {
      case FigureKind::kGroupedBars:
        values(Qt::AlignLeft);
        bars();
        break;
      case FigureKind::kRanges:
        values(Qt::AlignLeft);
        ranges();
        break;
      case FigureKind::kBoxes:
        values(Qt::AlignLeft);
        boxes();
        break;
      case FigureKind::kPoints:
        values(Qt::AlignLeft);
        points();
        break;
      case FigureKind::kLines:
        values(Qt::AlignLeft);
        lines();
        break;
      case FigureKind::kScatter:
        values(Qt::AlignLeft);
        cloud();
        break;
      case FigureKind::kForest:
        values(Qt::AlignBottom);
        forest();
        break;
      case FigureKind::kHeatMap:
        TORSIO_EXPECTS(false);  // buildFigure() draws it
    }
    references();
    const bool courses = std::any_of(figure_.series.begin(), figure_.series.end(),
                                     [](const FigureSeries& series) { return series.faint; });
    chart_->legend()->setVisible(inLegend_ > 1 || !figure_.references.empty() || (courses && inLegend_ > 0));
    return std::move(chart_);
  }

 private:
  [[nodiscard]] QFont font(int pixels) const {
    QFont out = typeface();
    out.setPixelSize(pixels);
    return out;
  }

  void prepare() {
    chart_->setAnimationOptions(QChart::NoAnimation);
    chart_->setDropShadowEnabled(false);
    chart_->setBackgroundVisible(false);
    chart_->setMargins(QMargins(2, 2, 2, 2));
    chart_->layout()->setContentsMargins(0, 0, 0, 0);
    QLegend* legend = chart_->legend();
    legend->setAlignment(Qt::AlignTop);
    legend->setFont(font(look_.label_px));
    legend->setLabelColor(look_.ink);
    // Bars have no marker of their own: asked for one, Qt leaves it white and cuts the names short.
    legend->setMarkerShape(figure_.kind == FigureKind::kGroupedBars ? QLegend::MarkerShapeRectangle
                                                                    : QLegend::MarkerShapeFromSeries);
  }

  /// Instead of the axis' own, which Qt cuts.
  void addUprightTitle(const Text& words) const {
    if (words.empty()) {
      return;
    }
    auto* title = new UprightTitle(say_(words), look_, chart_.get());  // the chart owns it
    QMargins margins = chart_->margins();
    margins.setLeft(margins.left() + static_cast<int>(std::ceil(title->width())));
    chart_->setMargins(margins);
    QObject::connect(chart_.get(), &QChart::plotAreaChanged, chart_.get(),
                     [title](const QRectF& plot) { title->place(plot); });
  }

  template <typename Axis>
  Axis* styled(Axis* axis, const Text& title) const {
    axis->setLabelsFont(font(look_.label_px - 1));
    axis->setTitleFont(font(look_.label_px));
    axis->setTitleText(say_(title).toHtmlEscaped());
    axis->setLabelsColor(look_.ink);
    axis->setTitleBrush(look_.ink);
    axis->setGridLineColor(look_.grid);
    axis->setLinePenColor(look_.ink);
    return axis;
  }

  [[nodiscard]] Range valueRange() const {
    Range range;
    for (const FigureSeries& series : figure_.series) {
      for (const auto& y : series.y) {
        if (y) {
          range.take(*y);
        }
      }
      for (const double v : series.low) {
        range.take(v);
      }
      for (const double v : series.high) {
        range.take(v);
      }
    }
    for (const FigureReference& reference : figure_.references) {
      range.take(reference.value);
    }
    if (range.empty()) {
      range = {0.0, 1.0};
    }
    if (figure_.kind == FigureKind::kGroupedBars) {
      range.take(0.0);
    }
    if (range.low == range.high) {
      range.high = range.low + 1.0;
    }
    return range;
  }

  void values(Qt::Alignment side) {
    const bool upright = side == Qt::AlignLeft;
    auto* axis = styled(new QValueAxis, upright ? Text() : figure_.yLabel);
    const Range range = valueRange();
    axis->setRange(figure_.yMin.value_or(range.low), figure_.yMax.value_or(range.high));
    axis->setTickCount(6);
    if (!figure_.yMin || !figure_.yMax) {
      axis->applyNiceNumbers();
    }
    const double span = axis->max() - axis->min();
    axis->setLabelFormat(span >= 8.0 ? "%.0f" : span >= 0.8 ? "%.1f" : "%.2f");
    if (upright) {
      addUprightTitle(figure_.yLabel);
    }
    chart_->addAxis(axis, side);
    values_ = axis;
  }

  /// Categories on a continuous axis at 1, 2, 3 ..., so that marks may stand beside each other.
  QCategoryAxis* slotAxis() {
    auto* axis = styled(new QCategoryAxis, figure_.xLabel);
    axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
    QStringList categories;
    for (const Text& category : figure_.categories) {
      categories << say_(category);
    }
    const auto [names, letters] = categoryLabels(categories, look_.label_px - 1);
    for (qsizetype i = 0; i < names.size(); ++i) {
      axis->append(names[i], static_cast<double>(i + 1));
    }
    axis->setLabelsFont(letters);
    axis->setRange(0.5, static_cast<double>(figure_.categories.size()) + 0.5);
    axis->setGridLineVisible(false);
    chart_->addAxis(axis, Qt::AlignBottom);
    range_ = {0.5, static_cast<double>(figure_.categories.size()) + 0.5};
    return axis;
  }

  QValueAxis* numberAxis() {
    auto* axis = styled(new QValueAxis, figure_.xLabel);
    Range range;
    for (const FigureSeries& series : figure_.series) {
      for (const double x : series.x) {
        range.take(x);
      }
    }
    if (range.empty()) {
      range = {0.0, 1.0};
    }
    if (range.low == range.high) {
      range.high = range.low + 1.0;
    }
    axis->setRange(range.low, range.high);
    if (figure_.kind == FigureKind::kScatter) {
      axis->setTickCount(6);
      axis->applyNiceNumbers();
    } else {
      countAlong(*axis, range);
    }
    const bool whole = figure_.kind != FigureKind::kScatter || axis->max() - axis->min() >= 4.0;
    axis->setLabelFormat(whole ? "%.0f" : "%.1f");
    chart_->addAxis(axis, Qt::AlignBottom);
    range_ = {axis->min(), axis->max()};
    return axis;
  }

  /// Marks at whole numbers, some air at both ends, so that the first and the last point are drawn whole.
  static void countAlong(QValueAxis& axis, const Range& range) {
    constexpr double kMostTicks = 8.0;
    const double span = range.high - range.low;
    double step = 1.0;
    for (const double wider : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
      if (span / step > kMostTicks) {
        step = wider;
      }
    }
    axis.setTickType(QValueAxis::TicksDynamic);
    axis.setTickAnchor(0.0);
    axis.setTickInterval(step);
    axis.setRange(range.low - 0.03 * span, range.high + 0.03 * span);
  }

  /// Where series `s` stands within its category.
  [[nodiscard]] double slot(std::size_t category, std::size_t s) const {
    const std::size_t count = std::max<std::size_t>(figure_.series.size(), 1);
    const double width = 0.62 / static_cast<double>(count);
    return static_cast<double>(category + 1) +
           width * (static_cast<double>(s) - 0.5 * static_cast<double>(count - 1));
  }

  [[nodiscard]] std::size_t lookOf(std::size_t s) const { return figure_.series[s].look.value_or(s); }

  [[nodiscard]] QScatterSeries* marks(std::size_t number, const Text& name, double size) const {
    auto* points = new QScatterSeries;
    points->setName(say_(name));
    points->setMarkerShape(kMarkers[number % kMarkers.size()]);
    points->setMarkerSize(size);
    points->setColor(seriesColour(number, look_));
    points->setBorderColor(look_.dark ? look_.ground : seriesColour(number, look_).darker(150));
    return points;
  }

  void add(QAbstractSeries* series, QAbstractAxis* x, QAbstractAxis* y, bool inLegend) {
    chart_->addSeries(series);
    series->attachAxis(x);
    series->attachAxis(y);
    for (QLegendMarker* marker : chart_->legend()->markers(series)) {
      marker->setVisible(inLegend);
    }
    inLegend_ += inLegend ? 1 : 0;
  }

  void bars() {
    slotAxis();  // what is seen: the axis of bars would leave its labels less room
    auto* axis = new QBarCategoryAxis;
    for (std::size_t i = 0; i < figure_.categories.size(); ++i) {
      axis->append(QString::number(i));
    }
    axis->setVisible(false);
    chart_->addAxis(axis, Qt::AlignBottom);
    auto* all = new QBarSeries;
    all->setBarWidth(0.75);
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      auto* set = new QBarSet(say_(figure_.series[s].name));
      set->setBrush(seriesFill(lookOf(s), look_));
      set->setPen(QPen(seriesColour(lookOf(s), look_).darker(look_.dark ? 100 : 130), 1.2));
      for (const auto& value : figure_.series[s].y) {
        *set << value.value_or(0.0);
      }
      all->append(set);
    }
    add(all, axis, values_, true);
    inLegend_ = static_cast<int>(figure_.series.size());
  }

  /// A line with caps from low to high; across the axis of values when `lying`.
  QLineSeries* whisker(std::size_t number, double at, double low, double high, double cap, bool lying) const {
    auto* line = new QLineSeries;
    line->setPen(QPen(seriesColour(number, look_), 2.0));
    const auto point = [lying](double along, double value) {
      return lying ? QPointF(value, along) : QPointF(along, value);
    };
    line->append({point(at - cap, low), point(at + cap, low), point(at, low), point(at, high),
                  point(at - cap, high), point(at + cap, high)});
    return line;
  }

  void ranges() {
    QCategoryAxis* axis = slotAxis();
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      TORSIO_EXPECTS(series.low.size() == series.y.size() && series.high.size() == series.y.size());
      auto* middle = marks(lookOf(s), series.name, 9.0);
      for (std::size_t c = 0; c < series.y.size(); ++c) {
        if (!series.y[c]) {
          continue;
        }
        const double x = slot(c, s);
        add(whisker(lookOf(s), x, series.low[c], series.high[c], 0.05, false), axis, values_, false);
        middle->append(x, *series.y[c]);
      }
      add(middle, axis, values_, true);
    }
  }

  void points() {
    QCategoryAxis* axis = slotAxis();
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      auto* dots = marks(lookOf(s), series.name, 8.0);
      for (std::size_t i = 0; i < series.y.size(); ++i) {
        if (!series.y[i]) {
          continue;
        }
        const double category = i < series.x.size() ? series.x[i] : static_cast<double>(i);
        dots->append(category + slot(0, s), *series.y[i]);
      }
      add(dots, axis, values_, true);
    }
  }

  [[nodiscard]] double abscissa(const FigureSeries& series, std::size_t i) const {
    const double x = i < series.x.size() ? series.x[i] : static_cast<double>(i);
    return figure_.categories.empty() ? (series.x.empty() ? x + 1.0 : x) : x + 1.0;
  }

  void lines() {
    QAbstractAxis* axis = figure_.categories.empty() ? static_cast<QAbstractAxis*>(numberAxis()) : slotAxis();
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      const std::size_t number = lookOf(s);
      auto* line = new QLineSeries;
      QColor colour = seriesColour(number, look_);
      if (series.faint) {
        colour.setAlpha(130);
      }
      QPen pen(colour, series.faint ? 1.1 : 2.2);
      pen.setStyle(static_cast<Qt::PenStyle>(Qt::SolidLine + static_cast<int>(number % 4)));
      line->setPen(pen);
      line->setName(say_(series.name));
      for (std::size_t i = 0; i < series.y.size(); ++i) {
        if (series.y[i]) {
          line->append(abscissa(series, i), *series.y[i]);
        }
      }
      add(line, axis, values_, !series.faint);
      if (!series.faint) {
        ornaments(series, number, axis);
      }
    }
  }

  /// Intervals and markers of a line.
  void ornaments(const FigureSeries& series, std::size_t number, QAbstractAxis* axis) {
    const double cap = figure_.categories.empty() ? 0.004 * (range_.high - range_.low) : 0.03;
    if (series.low.size() == series.y.size() && series.high.size() == series.y.size()) {
      for (std::size_t i = 0; i < series.y.size(); ++i) {
        if (series.y[i] && series.low[i] < series.high[i]) {
          QLineSeries* bar = whisker(number, abscissa(series, i), series.low[i], series.high[i], cap, false);
          bar->setPen(QPen(seriesColour(number, look_), 1.3));
          add(bar, axis, values_, false);
        }
      }
    }
    if (series.y.size() > kFewPoints) {
      return;
    }
    auto* dots = marks(number, series.name, 8.0);
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      if (series.y[i]) {
        dots->append(abscissa(series, i), *series.y[i]);
      }
    }
    add(dots, axis, values_, false);
  }

  void cloud() {
    QValueAxis* axis = numberAxis();
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      auto* dots = marks(lookOf(s), series.name, series.y.size() > 150 ? 4.5 : 6.5);
      QColor fill = seriesColour(lookOf(s), look_);
      fill.setAlpha(150);
      dots->setColor(fill);
      for (std::size_t i = 0; i < series.y.size(); ++i) {
        if (series.y[i]) {
          dots->append(series.x[i], *series.y[i]);
        }
      }
      add(dots, axis, values_, true);
    }
  }

  void forest() {
    const auto rows = static_cast<double>(figure_.categories.size());
    auto* axis = styled(new QCategoryAxis, figure_.xLabel);
    axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
    for (std::size_t i = 0; i < figure_.categories.size(); ++i) {
      axis->append(say_(figure_.categories[i]).toHtmlEscaped(), static_cast<double>(i + 1));
    }
    axis->setRange(0.4, rows + 0.6);
    axis->setReverse(true);  // first row on top
    axis->setGridLineVisible(false);
    chart_->addAxis(axis, Qt::AlignLeft);
    range_ = {0.4, rows + 0.6};
    rows_ = axis;
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      TORSIO_EXPECTS(series.low.size() == series.y.size() && series.high.size() == series.y.size());
      auto* middle = marks(lookOf(s), series.name, 10.0);
      for (std::size_t c = 0; c < series.y.size(); ++c) {
        if (!series.y[c]) {
          continue;
        }
        const double at = slot(c, s);
        add(whisker(lookOf(s), at, series.low[c], series.high[c], 0.08, true), values_, axis, false);
        middle->append(*series.y[c], at);
      }
      add(middle, values_, axis, true);
    }
  }

  void boxes() {
    auto* axis = styled(new QBarCategoryAxis, figure_.xLabel);
    axis->setGridLineVisible(false);
    auto* all = new QBoxPlotSeries;
    auto* means = marks(3, Text("mean"), 9.0);
    auto* outliers = marks(0, Text("outside the whiskers"), 6.0);
    outliers->setColor(look_.ground);
    outliers->setBorderColor(look_.ink);
    all->setBoxWidth(0.45);
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      TORSIO_EXPECTS(series.box.has_value());
      const BoxSummary& box = *series.box;
      auto* set = new QBoxSet(box.lowerWhisker, box.lowerQuartile, box.median, box.upperQuartile,
                              box.upperWhisker, say_(series.name));
      set->setBrush(paler(seriesColour(lookOf(s), look_)));
      set->setPen(QPen(look_.ink, 1.4));
      all->append(set);
      means->append(static_cast<double>(s), box.mean);
      for (const double value : box.outliers) {
        outliers->append(static_cast<double>(s), value);
      }
    }
    chart_->addAxis(axis, Qt::AlignBottom);
    add(all, axis, values_, false);
    add(means, axis, values_, true);
    if (outliers->count() > 0) {
      add(outliers, axis, values_, true);
    } else {
      delete outliers;
    }
    inLegend_ = 2;  // even alone, the mark needs its name
  }

  /// Half way to the ground: a fill on which the median line stays readable.
  [[nodiscard]] QColor paler(const QColor& colour) const {
    return QColor((colour.red() + look_.ground.red()) / 2, (colour.green() + look_.ground.green()) / 2,
                  (colour.blue() + look_.ground.blue()) / 2);
  }

  void references() {
    static const std::array<Qt::PenStyle, 3> kStyles{Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    const bool lying = figure_.kind == FigureKind::kForest;
    for (std::size_t i = 0; i < figure_.references.size(); ++i) {
      const FigureReference& reference = figure_.references[i];
      auto* line = new QLineSeries;
      line->setName(say_(reference.label));
      line->setPen(QPen(look_.ink, 1.2, kStyles[i % kStyles.size()]));
      if (lying) {
        line->append({{reference.value, range_.low}, {reference.value, range_.high}});
        add(line, values_, rows_, true);
      } else {
        line->append({{range_.low, reference.value}, {range_.high, reference.value}});
        add(line, chart_->axes(Qt::Horizontal).value(0), values_, true);
      }
    }
  }

  const ReportFigure& figure_;
  const ChartLook& look_;
  const Wording& say_;
  std::unique_ptr<QChart> chart_;
  QAbstractAxis* values_ = nullptr;
  QAbstractAxis* rows_ = nullptr;
  Range range_{0.0, 1.0};  // of the other axis
  int inLegend_ = 0;
};

}  // namespace

std::unique_ptr<QChart> buildChart(const ReportFigure& figure, const ChartLook& look,
                                   const Wording& wording) {
  return Builder(figure, look, wording).take();
}

std::unique_ptr<QGraphicsWidget> buildFigure(const ReportFigure& figure, const ChartLook& look,
                                             const Wording& wording) {
  if (figure.kind == FigureKind::kHeatMap) {
    return std::make_unique<HeatMapItem>(figure, look, wording);
  }
  return buildChart(figure, look, wording);
}

}  // namespace torsio
