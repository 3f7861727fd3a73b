// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/chart_builder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QBarCategoryAxis>
#include <QBarSeries>
#include <QBarSet>
#include <QBoxPlotSeries>
#include <QBoxSet>
#include <QCategoryAxis>
#include <QChart>
#include <QFontMetricsF>
#include <QGraphicsLayout>
#include <QLegend>
#include <QLegendMarker>
#include <QLineSeries>
#include <QPen>
#include <QScatterSeries>

#include "app/outputs/charts/chart_axes.h"
#include "app/outputs/charts/heat_map_item.h"
#include "app/outputs/charts/relief_item.h"
#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr std::size_t kFewPoints = 14;  // lines with at most this many points have markers
constexpr double kFaint = 0.5;          // opacity of individual curves
constexpr double kCloud = 0.6;          // opacity of the dots of a cloud
constexpr int kEdge_px = 2;             // around a chart

constexpr std::array kMarkers{
    QScatterSeries::MarkerShapeCircle,   QScatterSeries::MarkerShapeRectangle,
    QScatterSeries::MarkerShapeTriangle, QScatterSeries::MarkerShapeRotatedRectangle,
    QScatterSeries::MarkerShapePentagon, QScatterSeries::MarkerShapeStar};

/// A chart whose legend takes as many rows as its names need. Qt cuts the names off instead.
class RowedChart : public QChart {
 protected:
  void resizeEvent(QGraphicsSceneResizeEvent* event) override {
    QChart::resizeEvent(event);
    if (!legend()->isVisible()) {
      return;
    }
    const QFontMetricsF metrics(legend()->font());
    constexpr double kBetween_px = 10.0;
    const double beside_px = 2.0 * metrics.height() + kBetween_px;  // a name's marker and the space round it
    const double width = size().width() - 2.0 * kEdge_px;
    double widest = 0.0;
    int names = 0;
    double oneRow = 0.0;
    for (const QLegendMarker* marker : legend()->markers()) {
      if (marker->isVisible()) {
        const double item = metrics.horizontalAdvance(marker->label()) + beside_px;
        widest = std::max(widest, item);
        oneRow += item;
        ++names;
      }
    }
    if (oneRow <= width) {
      legend()->attachToChart();
      setMargins(QMargins(kEdge_px, kEdge_px, kEdge_px, kEdge_px));
      return;
    }
    const int columns = std::max(1, static_cast<int>(width / widest));
    const int rows = (names + columns - 1) / columns;
    constexpr double kRowGap_px = 12.0;  // that Qt leaves between two rows
    const int height = static_cast<int>(std::ceil(rows * (metrics.height() + kRowGap_px))) + kEdge_px;
    legend()->detachFromChart();
    legend()->setGeometry(kEdge_px, 0.0, width, height);
    setMargins(QMargins(kEdge_px, kEdge_px + height, kEdge_px, kEdge_px));
  }
};

/// Draws one figure into a chart.
class Builder {
 public:
  Builder(const ReportFigure& figure, const ChartStyle& look, const Wording& wording)
      : figure_(figure),
        style_(look),
        say_(wording),
        chart_(std::make_unique<RowedChart>()),
        axes_(figure, look, wording, *chart_) {}

  std::unique_ptr<QChart> take() {
    prepare();
    switch (figure_.kind) {
      case FigureKind::kGroupedBars:
        values_ = axes_.addValues(Qt::AlignLeft);
        bars();
        break;
      case FigureKind::kRanges:
        values_ = axes_.addValues(Qt::AlignLeft);
        ranges();
        break;
      case FigureKind::kBoxes:
        values_ = axes_.addValues(Qt::AlignLeft);
        boxes();
        break;
      case FigureKind::kPoints:
        values_ = axes_.addValues(Qt::AlignLeft);
        points();
        break;
      case FigureKind::kLines:
        values_ = axes_.addValues(Qt::AlignLeft);
        lines();
        break;
      case FigureKind::kScatter:
        values_ = axes_.addValues(Qt::AlignLeft);
        cloud();
        break;
      case FigureKind::kForest:
        values_ = axes_.addValues(Qt::AlignBottom);
        forest();
        break;
      case FigureKind::kHeatMap:
      case FigureKind::kReliefs:
        TORSIO_EXPECTS(false);  // handled by buildFigure()
    }
    references();
    const bool courses = std::any_of(figure_.series.begin(), figure_.series.end(),
                                     [](const FigureSeries& series) { return series.faint; });
    chart_->legend()->setVisible(!figure_.valuesInLabels && (inLegend_ > 1 || !figure_.references.empty() ||
                                                             (courses && inLegend_ > 0)));
    return std::move(chart_);
  }

 private:
  void prepare() {
    chart_->setAnimationOptions(QChart::NoAnimation);
    chart_->setDropShadowEnabled(false);
    chart_->setBackgroundVisible(false);
    chart_->setMargins(QMargins(kEdge_px, kEdge_px, kEdge_px, kEdge_px));
    chart_->layout()->setContentsMargins(0, 0, 0, 0);
    QLegend* legend = chart_->legend();
    legend->setAlignment(Qt::AlignTop);
    legend->setFont(chartFont(style_.label_px));
    legend->setLabelColor(style_.ink);
    // Bars have no marker shape of their own: if asked for one, Qt draws it white and truncates the names.
    legend->setMarkerShape(figure_.kind == FigureKind::kGroupedBars ? QLegend::MarkerShapeRectangle
                                                                    : QLegend::MarkerShapeFromSeries);
  }

  /// Returns the position of series `s` within its category.
  [[nodiscard]] double slot(std::size_t category, std::size_t s) const {
    const std::size_t count = std::max<std::size_t>(figure_.series.size(), 1);
    const double width = 0.62 / static_cast<double>(count);
    return static_cast<double>(category + 1) +
           width * (static_cast<double>(s) - 0.5 * static_cast<double>(count - 1));
  }

  [[nodiscard]] std::size_t lookOf(std::size_t s) const { return figure_.series[s].look.value_or(s); }

  [[nodiscard]] QPen pen(const QColor& colour, double width, Qt::PenStyle dash = Qt::SolidLine) const {
    return QPen(colour, style_.stroke * width, dash);
  }

  [[nodiscard]] QScatterSeries* marks(std::size_t number, const Text& name, double size) const {
    auto* points = new QScatterSeries;
    points->setName(say_(name));
    points->setMarkerShape(kMarkers[number % kMarkers.size()]);
    points->setMarkerSize(style_.stroke * size);
    points->setColor(seriesColour(number, style_));
    points->setBorderColor(style_.dark ? style_.ground : seriesColour(number, style_).darker(150));
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
    axes_.addCategories();  // the visible axis: a bar axis would leave less room for labels
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
      set->setBrush(seriesFill(lookOf(s), style_));
      set->setPen(pen(seriesColour(lookOf(s), style_).darker(style_.dark ? 100 : 130), 1.2));
      for (const auto& value : figure_.series[s].y) {
        *set << value.value_or(0.0);
      }
      all->append(set);
    }
    add(all, axis, values_, true);
    inLegend_ = static_cast<int>(figure_.series.size());
    ChartStyle fine = style_;  // the coarse pattern of wide bars would not be visible in a small area
    fine.hatch = 1.0;
    const QList<QLegendMarker*> fields = chart_->legend()->markers(all);
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      fields[static_cast<qsizetype>(s)]->setBrush(seriesFill(lookOf(s), fine));
    }
  }

  /// Adds a line with caps from low to high; along the horizontal axis if `lying`.
  QLineSeries* whisker(std::size_t number, double at, double low, double high, double cap, bool lying) const {
    auto* line = new QLineSeries;
    line->setPen(pen(seriesColour(number, style_), 2.0));
    cap /= style_.hatch;  // smaller in a wide chart, where caps would look like a fence
    const auto point = [lying](double along, double value) {
      return lying ? QPointF(value, along) : QPointF(along, value);
    };
    line->append({point(at - cap, low), point(at + cap, low), point(at, low), point(at, high),
                  point(at - cap, high), point(at + cap, high)});
    return line;
  }

  void ranges() {
    QCategoryAxis* axis = axes_.addCategories();
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
    QCategoryAxis* axis = axes_.addCategories();
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      auto* dots = marks(lookOf(s), series.name, 8.0);
      for (std::size_t i = 0; i < series.y.size(); ++i) {
        if (!series.y[i]) {
          continue;
        }
        const double category = i < series.x.size() ? series.x[i] : static_cast<double>(i);
        dots->append(category + slot(0, s), figure_.logarithmic ? std::log10(*series.y[i]) : *series.y[i]);
      }
      add(dots, axis, values_, true);
    }
  }

  [[nodiscard]] double abscissa(const FigureSeries& series, std::size_t i) const {
    const double x = i < series.x.size() ? series.x[i] : static_cast<double>(i);
    return figure_.categories.empty() ? (series.x.empty() ? x + 1.0 : x) : x + 1.0;
  }

  void lines() {
    QAbstractAxis* axis =
        figure_.categories.empty() ? static_cast<QAbstractAxis*>(axes_.addNumbers()) : axes_.addCategories();
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      const std::size_t number = lookOf(s);
      auto* line = new QLineSeries;
      QColor colour = seriesColour(number, style_);
      if (series.faint) {
        colour = paled(colour, kFaint, style_);
      }
      line->setPen(pen(colour, series.faint ? 1.1 : 2.2,
                       static_cast<Qt::PenStyle>(Qt::SolidLine + static_cast<int>(number % 4))));
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

  /// Adds the intervals and markers of a line.
  void ornaments(const FigureSeries& series, std::size_t number, QAbstractAxis* axis) {
    const double cap = figure_.categories.empty() ? 0.004 * (axes_.across().high - axes_.across().low) : 0.03;
    if (series.low.size() == series.y.size() && series.high.size() == series.y.size()) {
      for (std::size_t i = 0; i < series.y.size(); ++i) {
        if (series.y[i] && series.low[i] < series.high[i]) {
          QLineSeries* bar = whisker(number, abscissa(series, i), series.low[i], series.high[i], cap, false);
          bar->setPen(pen(seriesColour(number, style_), 1.3));
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
    QCategoryAxis* axis = axes_.addNumbers();
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      if (series.faint) {
        through(series, axis);
        continue;
      }
      auto* dots = marks(lookOf(s), series.name, series.y.size() > 150 ? 5.0 : 8.0);
      dots->setColor(paled(seriesColour(lookOf(s), style_), kCloud, style_));
      for (std::size_t i = 0; i < series.y.size(); ++i) {
        if (series.y[i]) {
          dots->append(series.x[i], *series.y[i]);
        }
      }
      add(dots, axis, values_, true);
    }
  }

  /// Adds a thin line through the points of a reference series.
  void through(const FigureSeries& series, QAbstractAxis* axis) {
    auto* line = new QLineSeries;
    line->setName(say_(series.name));
    line->setPen(pen(style_.ink, 1.2, Qt::DashLine));
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      line->append(series.x[i], series.y[i].value_or(0.0));
    }
    add(line, axis, values_, true);
  }

  void forest() {
    QCategoryAxis* axis = axes_.addRows();
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
    auto* all = new QBoxPlotSeries;
    auto* means = marks(3, Text::tr("mean"), 9.0);
    auto* outliers = marks(0, Text::tr("outside the whiskers"), 6.0);
    outliers->setColor(style_.ground);
    outliers->setBorderColor(style_.ink);
    all->setBoxWidth(0.45);
    for (std::size_t s = 0; s < figure_.series.size(); ++s) {
      const FigureSeries& series = figure_.series[s];
      TORSIO_EXPECTS(series.box.has_value());
      const BoxSummary& box = *series.box;
      auto* set = new QBoxSet(box.lowerWhisker, box.lowerQuartile, box.median, box.upperQuartile,
                              box.upperWhisker, say_(series.name));
      set->setBrush(paler(seriesColour(lookOf(s), style_)));
      set->setPen(pen(style_.ink, 1.4));
      all->append(set);
      means->append(static_cast<double>(s), box.mean);
      for (const double value : box.outliers) {
        outliers->append(static_cast<double>(s), value);
      }
    }
    QBarCategoryAxis* axis = axes_.addBoxes();
    add(all, axis, values_, false);
    add(means, axis, values_, true);
    if (outliers->count() > 0) {
      add(outliers, axis, values_, true);
    } else {
      delete outliers;
    }
    inLegend_ = 2;  // the marker needs its name even if it is the only series
  }

  /// Blends the colour halfway to the background, so that the median line stays visible on the fill.
  [[nodiscard]] QColor paler(const QColor& colour) const {
    return QColor((colour.red() + style_.ground.red()) / 2, (colour.green() + style_.ground.green()) / 2,
                  (colour.blue() + style_.ground.blue()) / 2);
  }

  void references() {
    static const std::array<Qt::PenStyle, 3> kStyles{Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    const bool lying = figure_.kind == FigureKind::kForest;
    for (std::size_t i = 0; i < figure_.references.size(); ++i) {
      const FigureReference& reference = figure_.references[i];
      auto* line = new QLineSeries;
      line->setName(say_(reference.label));
      line->setPen(pen(style_.ink, 1.2, kStyles[i % kStyles.size()]));
      if (lying) {
        line->append({{reference.value, axes_.across().low}, {reference.value, axes_.across().high}});
        add(line, values_, rows_, true);
      } else {
        line->append({{axes_.across().low, reference.value}, {axes_.across().high, reference.value}});
        add(line, chart_->axes(Qt::Horizontal).value(0), values_, true);
      }
    }
  }

  const ReportFigure& figure_;
  const ChartStyle& style_;
  const Wording& say_;
  std::unique_ptr<QChart> chart_;
  ChartAxes axes_;
  QAbstractAxis* values_ = nullptr;
  QAbstractAxis* rows_ = nullptr;
  int inLegend_ = 0;
};

}  // namespace

std::unique_ptr<QChart> buildChart(const ReportFigure& figure, const ChartStyle& look,
                                   const Wording& wording) {
  return Builder(figure, look, wording).take();
}

std::unique_ptr<QGraphicsWidget> buildFigure(const ReportFigure& figure, const ChartStyle& look,
                                             const Wording& wording) {
  if (figure.kind == FigureKind::kHeatMap) {
    return std::make_unique<HeatMapItem>(figure, look, wording);
  }
  if (figure.kind == FigureKind::kReliefs) {
    return std::make_unique<ReliefItem>(figure, look, wording);
  }
  return buildChart(figure, look, wording);
}

}  // namespace torsio
