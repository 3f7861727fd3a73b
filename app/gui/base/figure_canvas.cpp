// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/figure_canvas.h"

#include <algorithm>

#include <QClipboard>
#include <QGraphicsScene>
#include <QGraphicsWidget>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMimeData>
#include <QPainter>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/number_text.h"
#include "app/outputs/charts/chart_builder.h"
#include "app/outputs/wording/printed_minus.h"
#include "assessment/results/figure_table.h"

namespace torsio::gui {

namespace {

constexpr QSize kCopiedPicture(1600, 900);
constexpr double kCopiedScale = 2.0;  // laid out at 800 x 450, drawn twice as large
constexpr int kDescribedRows = 12;    // a screen reader refers to the table for more
constexpr int kLabel_px = 13;
constexpr int kRowHeight = 26;
constexpr int kFrameHeight = 110;

/// Figures use the window's language.
const Wording kTranslated = [](const Text& text) { return toQString(text); };

}  // namespace

/// Charts are designed for a few hundred pixels. On a 4K screen, hatches would blend into a tint, and marks,
/// lines and letters would be too small.
bool isWide(int width) {
  constexpr int kPlainUpTo = 1200;
  return width > kPlainUpTo;
}

void growFor(int width, ChartStyle& look) {
  constexpr double kStroke = 1.6;
  constexpr int kWideLabel_px = 17;
  const bool wide = isWide(width);
  look.hatch = wide ? 2.0 : 1.0;
  look.stroke = wide ? kStroke : 1.0;
  look.label_px = wide ? kWideLabel_px : kLabel_px;
}

ChartStyle chartStyle(const Theme& theme) {
  ChartStyle look;
  look.ground = theme.surface;
  look.ink = theme.text;
  look.grid = theme.line;
  look.dark = theme.kind == ThemeKind::kDark;
  look.label_px = kLabel_px;
  look.number = [](double value, int decimals) { return numberText(value, decimals); };
  return look;
}

QString tabbed(const ReportTable& table) {
  QStringList lines;
  const auto line = [](const auto& cells) {
    QStringList parts;
    for (const Text& cell : cells) {
      parts << plainMinus(toQString(cell));
    }
    return parts.join(QLatin1Char('\t'));
  };
  lines << line(table.columns);
  for (const std::vector<ReportCell>& row : table.rows) {
    lines << line(row);
  }
  return lines.join(QLatin1Char('\n'));
}

FigureCanvas::FigureCanvas(QWidget* parent)
    : QGraphicsView(parent), style_(chartStyle(theme(ThemeKind::kLight))) {
  setScene(new QGraphicsScene(this));
  setFrameShape(QFrame::NoFrame);
  setRenderHints(QPainter::Antialiasing | QPainter::NonCosmeticBrushPatterns);  // else hatches do not scale
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setBackgroundBrush(style_.ground);
}

void FigureCanvas::setFigure(const ReportFigure& figure) {
  figure_ = figure;
  rebuild();
  describe();
  updateGeometry();
}

void FigureCanvas::setTheme(const Theme& theme) {
  style_ = chartStyle(theme);
  setBackgroundBrush(style_.ground);
  rebuild();
}

QSize FigureCanvas::sizeHint() const {
  if (!figure_) {
    return {640, 360};
  }
  const std::size_t rows = figure_->kind == FigureKind::kHeatMap  ? figure_->series.size()
                           : figure_->kind == FigureKind::kForest ? figure_->categories.size()
                                                                  : 0;
  return {640, std::max(360, kFrameHeight + kRowHeight * static_cast<int>(rows))};
}

void FigureCanvas::rebuild() {
  scene()->clear();
  item_ = nullptr;
  if (!figure_) {
    return;
  }
  growFor(viewport()->width(), style_);
  item_ = buildFigure(*figure_, style_, kTranslated).release();
  scene()->addItem(item_);
  fit();
}

void FigureCanvas::fit() {
  if (item_ == nullptr) {
    return;
  }
  const QSizeF size(viewport()->size());
  item_->resize(size);
  setSceneRect(QRectF(QPointF(0, 0), size));
}

void FigureCanvas::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  if ((style_.hatch > 1.0) != isWide(viewport()->width())) {
    rebuild();
  } else {
    fit();
  }
}

QImage FigureCanvas::picture(const QSize& size) const {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  if (!figure_) {
    return image;
  }
  QGraphicsScene paper;
  QGraphicsWidget* item = buildFigure(*figure_, {}, kTranslated).release();
  paper.addItem(item);
  item->resize(QSizeF(size) / kCopiedScale);
  paper.setSceneRect(item->geometry());
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::NonCosmeticBrushPatterns);
  paper.render(&painter, QRectF(image.rect()), paper.sceneRect());
  return image;
}

void FigureCanvas::copy() const {
  if (!figure_) {
    return;
  }
  auto* content = new QMimeData;  // owned by the clipboard
  content->setImageData(picture(kCopiedPicture));
  content->setText(tabbed(figureTable(*figure_)));
  QGuiApplication::clipboard()->setMimeData(content);
}

void FigureCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) {
    copy();
    event->accept();
    return;
  }
  QGraphicsView::keyPressEvent(event);
}

void FigureCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    rebuild();
    describe();
  }
  QGraphicsView::changeEvent(event);
}

void FigureCanvas::describe() {
  if (!figure_) {
    return;
  }
  setAccessibleName(toQString(figure_->title));
  const ReportTable table = figureTable(*figure_, 2);
  QStringList said;
  for (std::size_t i = 0; i < table.rows.size() && i < kDescribedRows; ++i) {
    QStringList parts;
    for (std::size_t c = 1; c < table.rows[i].size(); ++c) {
      if (!table.rows[i][c].empty()) {
        parts << QStringLiteral("%1 %2").arg(toQString(table.columns[c]), toQString(table.rows[i][c]));
      }
    }
    said << QStringLiteral("%1: %2").arg(toQString(table.rows[i].front()), parts.join(QStringLiteral(", ")));
  }
  if (table.rows.size() > kDescribedRows) {
    said << tr("%n row(s) more in the table", nullptr, static_cast<int>(table.rows.size()) - kDescribedRows);
  }
  setAccessibleDescription(said.join(QStringLiteral(". ")));
}

}  // namespace torsio::gui
