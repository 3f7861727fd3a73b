// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/sheet_panel.h"

#include <algorithm>

#include <QApplication>
#include <QFrame>
#include <QLabel>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/widgets/form.h"

namespace torsio::gui {

SheetPanel::SheetPanel(bool largeTargets, QWidget* parent)
    : QWidget(parent),
      shape_(largeTargets ? RowShape::kLarge : RowShape::kUsual),
      theme_(&theme(ThemeKind::kLight)),
      scroll_(new QScrollArea(this)),
      edge_(named(new QFrame(this), "edge")),
      commentLabel_(new QLabel(this)),
      comment_(named(new QPlainTextEdit(this), "comment")) {
  QVBoxLayout* column = columnOf(this, {}, kSpace / 2);
  auto* ground = new QWidget;
  rowsLayout_ = new QVBoxLayout(ground);
  rowsLayout_->setContentsMargins(0, 0, 0, 0);
  keepOffScrollBar(*scroll_, *rowsLayout_);
  rowsLayout_->setSpacing(kSpace / 2);
  scroll_->setWidget(ground);
  ground->installEventFilter(this);
  scroll_->setWidgetResizable(true);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setMinimumHeight(6 * kSpace);  // a row or two on a small screen
  scroll_->installEventFilter(this);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  column->addWidget(scroll_, 1);
  edge_->setProperty("edge", true);
  edge_->setFixedHeight(1);
  QSizePolicy kept = edge_->sizePolicy();
  kept.setRetainSizeWhenHidden(true);  // rows do not move
  edge_->setSizePolicy(kept);
  edge_->hide();
  connect(scroll_->verticalScrollBar(), &QScrollBar::rangeChanged, edge_,
          [this](int, int most) { edge_->setVisible(most > 0); });
  column->addWidget(edge_);
  overallLayout_ = new QVBoxLayout;
  overallLayout_->setContentsMargins(0, 0, 0, 0);
  column->addLayout(overallLayout_);
  commentLabel_->setBuddy(comment_);
  comment_->setTabChangesFocus(true);
  comment_->setFixedHeight(2 * fontMetrics().lineSpacing() + 2 * kSpace);
  commentLayout_ = new QVBoxLayout;
  commentLayout_->setContentsMargins(kRowMark_px + kSpace, 0, kSpace, 0);
  commentLayout_->setSpacing(kSpace / 2);
  commentLabel_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  commentLayout_->addWidget(commentLabel_);
  commentLayout_->addWidget(comment_);
  column->addLayout(commentLayout_);
  column->addStretch();  // on a tall page, extra space goes below the sheet
  connect(comment_, &QPlainTextEdit::textChanged, this, [this] {
    if (filling_ || editor_ == nullptr) {
      return;
    }
    if (editor_->setComment(comment_->toPlainText().toStdString())) {
      changed();
    }
  });
}

/// Limits the height to the rows, so that the overall mark follows them at the same width.
void SheetPanel::fitRows() {
  const int wide = scroll_->viewport()->width();
  const int frame = scroll_->frameWidth();
  const int beside = scroll_->width() - frame - wide;  // width of the scroll bar, if any
  const int right = rowsLayout_->contentsMargins().right() + beside;
  overallLayout_->setContentsMargins(frame, 0, right, 0);
  commentLayout_->setContentsMargins(frame + kRowMark_px + kSpace, 0, right + kSpace, 0);
  const int high = rowsLayout_->hasHeightForWidth() ? rowsLayout_->totalHeightForWidth(wide)
                                                    : rowsLayout_->totalSizeHint().height();
  scroll_->setMaximumHeight(std::max(scroll_->minimumHeight(), high + 2 * frame));
}

bool SheetPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == scroll_->widget() &&
      (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize)) {
    QTimer::singleShot(0, this, &SheetPanel::fitRows);
  }
  if (watched == scroll_ && event->type() == QEvent::Resize) {
    QTimer::singleShot(0, this, &SheetPanel::showCurrentRow);  // after layout of the rows
  }
  if (watched == scroll_ && event->type() == QEvent::KeyPress) {
    event->ignore();  // arrow keys move between rows instead of scrolling
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

bool SheetPanel::focusNextPrevChild(bool next) {
  std::vector<QWidget*> stops(rows_.begin(), rows_.end());
  if (comment_->isVisibleTo(this)) {
    stops.push_back(comment_);
  }
  const QWidget* now = focusWidget();
  const auto at = std::find_if(stops.begin(), stops.end(), [now](const QWidget* stop) {
    return now != nullptr && (stop == now || stop->isAncestorOf(now));
  });
  if (at == stops.end()) {
    return QWidget::focusNextPrevChild(next);
  }
  const auto count = std::ssize(stops);
  const auto to = (at - stops.begin() + (next ? 1 : count - 1)) % count;
  stops[static_cast<std::size_t>(to)]->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  return true;
}

void SheetPanel::setTheme(const Theme& theme) {
  theme_ = &theme;
  for (ScoreRow* row : rows_) {
    row->setTheme(theme);
  }
}

void SheetPanel::retranslate() {
  nameField(commentLabel_, tr("Co&mment for the trainee"));
  comment_->setPlaceholderText(tr("What would help most next time?"));
  const bool focused = isAncestorOf(QApplication::focusWidget());
  build();
  if (editor_ != nullptr && focused) {
    takeFocus();  // focus moved to another widget when the rows were removed
  }
}

void SheetPanel::setEditor(SheetEditor* editor) {
  editor_ = editor;
  current_ = editor_ != nullptr ? editor_->order().front() : std::string();
  typed_points_.reset();
  build();
}

void SheetPanel::setScoresOnly(RowShape shape) {
  scoresOnly_ = true;
  shape_ = shape;
  commentLabel_->hide();
  comment_->hide();
}

void SheetPanel::setReadOnly(bool readOnly) {
  readOnly_ = readOnly;
  comment_->setReadOnly(readOnly);
  for (ScoreRow* row : rows_) {
    row->setReadOnly(readOnly);
  }
}

void SheetPanel::build() {
  for (ScoreRow* row : rows_) {
    row->disconnect(this);  // removal moves focus through all of them, not the user
  }
  for (ScoreRow* row : rows_) {
    row->hide();
    row->deleteLater();
  }
  rows_.clear();
  for (QVBoxLayout* rows : {rowsLayout_, overallLayout_}) {
    while (QLayoutItem* item = rows->takeAt(0)) {
      delete item;
    }
  }
  if (editor_ == nullptr) {
    return;
  }
  const auto add = [this](const std::string& code, const QString& label, const ScoreScale& scale,
                          const std::vector<RubricAnchor>& anchors) {
    auto* row = new ScoreRow(code, label, scale, anchors, shape_, this);
    row->setTheme(*theme_);
    row->setReadOnly(readOnly_);
    row->retranslate();
    (code == kOverallRow ? overallLayout_ : rowsLayout_)->addWidget(row);
    row->show();  // immediately: it may get the focus before layout
    rows_.push_back(row);
    connect(row, &ScoreRow::wanted, this, [this, code] { setCurrentRow(code); });
    connect(row, &ScoreRow::finished, this, &SheetPanel::takeFocus);
    connect(row, &ScoreRow::scored, this, [this, code](qint64 steps) { choose(code, steps); });
    connect(row, &ScoreRow::takenBack, this, [this, code](const SheetAnswer& before) {
      const bool changes =
          !readOnly_ && (before.score_steps ? editor_->setScore(code, *before.score_steps)
                                            : editor_->setNotAssessable(code, before.notAssessableReason));
      if (changes) {
        changed();
      }
    });
    connect(row, &ScoreRow::reasoned, this, [this, code](const QString& reason) {
      if (!readOnly_ && editor_->setNotAssessable(code, reason.toStdString())) {
        changed();
      }
    });
  };
  for (const RubricLine& row : editor_->rubric().rows) {
    add(row.code, toQString(Text(row.label)), row.scale, row.anchors);
  }
  if (editor_->order().back() == kOverallRow) {
    add(kOverallRow, tr("Overall"), editor_->rubric().overall, {});
  }
  rowsLayout_->addStretch(1);
  scroll_->setVisible(!editor_->rubric().rows.empty());
  // No horizontal scrolling: a hidden score could not be given.
  scroll_->setMinimumWidth(rowsLayout_->minimumSize().width() +
                           scroll_->verticalScrollBar()->sizeHint().width());
  QWidget* before = nullptr;
  for (ScoreRow* row : rows_) {
    if (before != nullptr) {
      setTabOrder(before, row);
    }
    before = row;
  }
  if (before != nullptr) {
    setTabOrder(before, comment_);
  }
  refresh();
}

void SheetPanel::refresh() {
  if (editor_ == nullptr) {
    return;
  }
  for (ScoreRow* row : rows_) {
    row->setAnswer(editor_->answer(row->code()));
    row->setCurrent(row->code() == current_);
  }
  const QString comment = toQString(editor_->sheet().comment);
  if (comment_->toPlainText() == comment) {
    return;
  }
  filling_ = true;
  comment_->setPlainText(comment);
  comment_->moveCursor(QTextCursor::End);  // so that typing continues at the end
  filling_ = false;
}

void SheetPanel::setCurrentRow(const std::string& row) {
  if (row != current_) {
    typed_points_.reset();
  }
  current_ = row;
  for (ScoreRow* line : rows_) {
    line->setCurrent(line->code() == current_);
  }
  showCurrentRow();
  Q_EMIT rowChanged();
}

void SheetPanel::showCurrentRow() {
  const bool still =
      std::any_of(rows_.begin(), rows_.end(), [](const ScoreRow* line) { return line->underFinger(); });
  for (ScoreRow* line : rows_) {
    if (line->code() != current_ || !scroll_->isAncestorOf(line)) {
      continue;
    }
    if (still) {  // a row with a visible scale does not scroll
      const int top = line->mapTo(scroll_->widget(), QPoint(0, 0)).y();
      scroll_->ensureVisible(0, top + line->scaleEnd(), 0, 0);
      scroll_->ensureVisible(0, top, 0, 0);
    } else {
      scroll_->ensureWidgetVisible(line, 0, kSpace);
    }
  }
}

void SheetPanel::takeFocus() {
  for (ScoreRow* row : rows_) {
    if (row->code() == current_) {
      row->setFocus(Qt::OtherFocusReason);
    }
  }
}

void SheetPanel::changed() {
  refresh();
  Q_EMIT edited();
}

void SheetPanel::choose(const std::string& row, std::int64_t steps) {
  if (readOnly_ || editor_ == nullptr) {
    return;
  }
  setCurrentRow(row);
  typed_points_.reset();
  if (editor_->setScore(row, steps)) {
    changed();
  }
  if (advancing_) {
    step(+1);
  }
}

void SheetPanel::step(int direction) {
  const std::vector<std::string> order = editor_->order();
  const auto at = std::find(order.begin(), order.end(), current_) - order.begin();
  const auto next =
      std::clamp<std::ptrdiff_t>(at + direction, 0, static_cast<std::ptrdiff_t>(order.size()) - 1);
  setCurrentRow(order[static_cast<std::size_t>(next)]);
  takeFocus();
}

void SheetPanel::adjust(std::int64_t steps) {
  typed_points_.reset();
  const ScoreScale& scale = editor_->scale(current_);
  const auto score = editor_->answer(current_).score_steps;
  if (!score) {
    return;  // an arrow adjusts an existing score only
  }
  if (editor_->setScore(current_, std::clamp(*score + steps, scale.lo, scale.hi))) {
    changed();
  }
}

void SheetPanel::digit(int value) {
  const auto longer = [this](std::int64_t points, int next) {
    const std::optional<std::int64_t> steps = stepsForDigit(editor_->scale(current_), next, points);
    return points > 0 && steps && *steps / editor_->scale(current_).stepsPerPoint == points * 10 + next;
  };
  if (advancing_ && typed_points_ && !longer(*typed_points_, value)) {
    step(+1);  // the previous digit was complete
  }
  const ScoreScale& scale = editor_->scale(current_);
  const auto steps = stepsForDigit(scale, value, typed_points_);
  if (!steps) {
    return;
  }
  const bool joins = typed_points_.has_value() && *steps / scale.stepsPerPoint > 9;
  const std::int64_t points = *steps / scale.stepsPerPoint;
  typed_points_ = points;
  if (editor_->setScore(current_, *steps, joins)) {
    changed();
  }
  if (advancing_ && (joins || !longer(points, 0))) {
    step(+1);
  }
}

bool SheetPanel::handleKey(int key, Qt::KeyboardModifiers modifiers) {
  if (editor_ == nullptr) {
    return false;
  }
  const bool plain = (modifiers & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
  if (!plain) {
    return false;
  }
  if (key == Qt::Key_Up || key == Qt::Key_Down) {
    step(key == Qt::Key_Up ? -1 : +1);
    return true;
  }
  if (readOnly_) {
    return false;
  }
  if (key >= Qt::Key_0 && key <= Qt::Key_9) {
    digit(key - Qt::Key_0);
    return true;
  }
  const ScoreScale& scale = editor_->scale(current_);
  const std::int64_t fine = (modifiers & Qt::ShiftModifier) != 0 ? 1 : arrowSteps(scale);
  switch (key) {
    case Qt::Key_Left:
      adjust(-fine);
      return true;
    case Qt::Key_Right:
      adjust(fine);
      return true;
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      typed_points_.reset();
      if (editor_->clear(current_)) {
        changed();
      }
      return true;
    case Qt::Key_N:
      if (scoresOnly_) {
        return false;
      }
      for (ScoreRow* row : rows_) {
        if (row->code() == current_) {
          row->askReason();
        }
      }
      return true;
    default:
      return false;
  }
}

}  // namespace torsio::gui
