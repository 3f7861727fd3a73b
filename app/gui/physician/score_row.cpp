// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <utility>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/accessible_role.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/written_words.h"

namespace torsio::gui {

namespace {

constexpr int kMaxCells = 11;
constexpr int kLeastCell_px = 32;
constexpr int kCellGap = 3;
constexpr double kCorner = 4.0;

}  // namespace

ScoreRow::ScoreRow(std::string code, const QString& label, const ScoreScale& scale,
                   std::vector<RubricAnchor> anchors, RowShape shape, QWidget* parent)
    : QWidget(parent),
      code_(std::move(code)),
      label_(label),
      scale_(scale),
      anchors_(std::move(anchors)),
      shape_(shape),
      theme_(&theme(ThemeKind::kLight)),
      name_(new QLabel(label, this)),
      value_(new QLabel(this)),
      strip_(named(new QWidget(this), "scale")),
      anchor_(sentence(this)),
      reason_(new QLineEdit(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleRole(this, QAccessible::Slider);
  setMouseTracking(true);
  strip_->setAttribute(Qt::WA_TransparentForMouseEvents);
  strip_->setFixedHeight(shape_ == RowShape::kLarge ? kTouch_px : kLeastCell_px);
  strip_->setMinimumWidth(cellCount() * (kLeastCell_px + kCellGap));
  name_->setProperty("subheading", shape_ == RowShape::kLarge);
  QFont bold = name_->font();
  bold.setBold(true);
  name_->setFont(bold);
  value_->setFont(bold);
  anchor_->setProperty("small", true);
  anchor_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  reason_->hide();
  reason_->setMaxLength(static_cast<int>(kLongestReason));
  reason_->installEventFilter(this);
  arrange();
  anchor_->setVisible(!anchors_.empty());
  connect(reason_, &QLineEdit::textEdited, this, &ScoreRow::reasoned);
}

void ScoreRow::arrange() {
  QVBoxLayout* column = columnOf(this, {kRowMark_px + kSpace, kSpace / 2, kSpace, kSpace / 2}, kSpace / 2);
  auto* head = new QHBoxLayout;
  if (shape_ == RowShape::kCompact) {
    head->setSpacing(2 * kSpace);
    const QFontMetrics letters(name_->font());
    name_->setMinimumWidth(std::max(letters.horizontalAdvance(QStringLiteral("Deformation efficiency  ")),
                                    letters.horizontalAdvance(label_ + QStringLiteral("  "))));
    value_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("10.0 ")));
    value_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    head->addWidget(name_);
    head->addWidget(strip_, 1);
    head->addWidget(value_);
    column->addLayout(head);
  } else {
    head->addWidget(name_, 1);
    head->addWidget(value_);
    column->addLayout(head);
    column->addWidget(strip_);
  }
  column->addWidget(anchor_);
  column->addWidget(reason_);
}

void ScoreRow::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void ScoreRow::retranslate() {
  reason_->setPlaceholderText(tr("Why can this not be judged? Enter ends, Esc takes it back"));
  reason_->setAccessibleName(tr("Why %1 cannot be judged").arg(label_));
  describe();
  showAnchor();
  keepAnchorRoom();
}

void ScoreRow::setAnswer(const SheetAnswer& answer) {
  answer_ = answer;
  const bool reasoned = !answer.notAssessableReason.empty();
  if (answer.score_steps) {
    value_->setText(scoreText(*answer.score_steps, scale_));
  } else {
    value_->setText(reasoned ? tr("not assessable") : QStringLiteral("\u2013"));
  }
  const QString reason = toQString(answer.notAssessableReason);
  if (reason_->text() != reason) {
    const QSignalBlocker quiet(reason_);
    reason_->setText(reason);
  }
  reason_->setVisible(reasoned || reason_->hasFocus());
  describe();
  showAnchor();
  update();
}

void ScoreRow::setCurrent(bool current) {
  if (current_ == current) {
    return;
  }
  current_ = current;
  showAnchor();
  update();
}

void ScoreRow::setReadOnly(bool readOnly) {
  readOnly_ = readOnly;
  reason_->setReadOnly(readOnly);
}

void ScoreRow::askReason() {
  asked_ = answer_;
  reason_->show();
  reason_->setFocus(Qt::OtherFocusReason);
}

void ScoreRow::describe() {
  setAccessibleName(label_);
  const QString range = tr("%1 to %2").arg(scoreText(scale_.lo, scale_), scoreText(scale_.hi, scale_));
  setAccessibleDescription(tr("%1; now %2").arg(range, value_->text()));
}

QString ScoreRow::nearestAnchor(std::int64_t steps) const {
  const auto nearest =
      std::min_element(anchors_.begin(), anchors_.end(), [steps](const auto& a, const auto& b) {
        return std::abs(a.score_steps - steps) < std::abs(b.score_steps - steps);
      });
  return nearest == anchors_.end()
             ? QString()
             : tr("%1: %2").arg(scoreText(nearest->score_steps, scale_), toQString(Text(nearest->meaning)));
}

QString ScoreRow::allAnchors() const {
  QStringList all;
  for (const RubricAnchor& anchor : anchors_) {
    all << tr("%1: %2").arg(scoreText(anchor.score_steps, scale_), toQString(Text(anchor.meaning)));
  }
  return all.join(QStringLiteral("\u00a0\u00a0\u00a0\u00b7   "));
}

void ScoreRow::showAnchor() {
  if (anchors_.empty()) {
    return;
  }
  // A long form only has room for the anchors of one row: the current one.
  anchor_->setVisible(shape_ != RowShape::kCompact || current_);
  if (hovered_ >= 0) {
    anchor_->setText(nearestAnchor(stepsOf(hovered_)));
    return;
  }
  // The current row shows all anchors; others only the one of their mark.
  anchor_->setText(current_ || !answer_.score_steps ? allAnchors() : nearestAnchor(*answer_.score_steps));
}

/// Reserves the height of all anchors even if only one is shown, so that rows do not move under a finger.
void ScoreRow::keepAnchorRoom() {
  if (anchors_.empty() || !laidOut_) {
    return;
  }
  anchor_->ensurePolished();
  const int wide = std::max(1, width() - kRowMark_px - 2 * kSpace);
  const QRect needed =
      anchor_->fontMetrics().boundingRect(QRect(0, 0, wide, QWIDGETSIZE_MAX), Qt::TextWordWrap, allAnchors());
  anchor_->setMinimumHeight(needed.height());
}

void ScoreRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  laidOut_ = true;
  keepAnchorRoom();
}

int ScoreRow::cellCount() const {
  return static_cast<int>(
      std::min<std::int64_t>((scale_.hi - scale_.lo) / scale_.stepsPerPoint + 1, kMaxCells));
}

std::int64_t ScoreRow::stepsOf(int cell) const {
  const int last = std::max(1, cellCount() - 1);
  const std::int64_t span = (scale_.hi - scale_.lo) / scale_.stepsPerPoint;
  return scale_.lo + span * cell / last * scale_.stepsPerPoint;
}

std::vector<QRect> ScoreRow::cells() const {
  const QRect area = strip_->geometry();
  const int count = cellCount();
  std::vector<QRect> all;
  for (int i = 0; i < count; ++i) {
    const int wide = area.width() + kCellGap;  // no gap behind the last one
    const int left = area.left() + wide * i / count;
    const int right = area.left() + wide * (i + 1) / count;
    all.emplace_back(left, area.top(), right - left - kCellGap, area.height());
  }
  return all;
}

int ScoreRow::cellAt(const QPoint& at) const {
  const std::vector<QRect> all = cells();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].adjusted(0, 0, kCellGap, 0).contains(at)) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

void ScoreRow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (current_) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_->raised);
    painter.drawRoundedRect(rect(), kCorner + 2.0, kCorner + 2.0);
    painter.setBrush(theme_->accent);
    painter.drawRoundedRect(QRectF(0, 0, kRowMark_px, height()), 2.0, 2.0);
  }
  const std::vector<QRect> all = cells();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::int64_t steps = stepsOf(static_cast<int>(i));
    const bool chosen = answer_.score_steps && *answer_.score_steps == steps;
    // Half points are between two cells: outlines both.
    const bool beside =
        answer_.score_steps && !chosen && std::abs(*answer_.score_steps - steps) < scale_.stepsPerPoint;
    const bool hovered = hovered_ == static_cast<int>(i) && !readOnly_;
    painter.setBrush(chosen ? theme_->accent : hovered ? theme_->track : theme_->surface);
    painter.setPen(QPen(chosen || beside || hovered ? theme_->accent : theme_->border, beside ? 2.0 : 1.0));
    painter.drawRoundedRect(QRectF(all[i]).adjusted(0.5, 0.5, -0.5, -0.5), kCorner, kCorner);
    painter.setPen(chosen ? theme_->onAccent : theme_->text);
    painter.drawText(all[i], Qt::AlignCenter, scoreText(steps, scale_));
  }
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme_->accent, 1.5));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.75, 0.75, -0.75, -0.75), kCorner + 2.0, kCorner + 2.0);
  }
}

void ScoreRow::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  underFinger_ = event->reason() == Qt::MouseFocusReason;
  Q_EMIT wanted();
  underFinger_ = false;
}

void ScoreRow::mousePressEvent(QMouseEvent* event) {
  underFinger_ = true;
  Q_EMIT wanted();
  const int cell = cellAt(event->position().toPoint());
  if (cell >= 0 && !readOnly_) {
    Q_EMIT scored(stepsOf(cell));
  }
  underFinger_ = false;
}

int ScoreRow::scaleEnd() const {
  return strip_->geometry().bottom();
}

void ScoreRow::mouseMoveEvent(QMouseEvent* event) {
  const int cell = cellAt(event->position().toPoint());
  if (cell == hovered_) {
    return;
  }
  hovered_ = cell;
  showAnchor();
  update();
}

void ScoreRow::leaveEvent(QEvent* event) {
  hovered_ = -1;
  showAnchor();
  update();
  QWidget::leaveEvent(event);
}

bool ScoreRow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == reason_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Escape) {
      // Esc undoes only what was entered since N: an existing score remains.
      const SheetAnswer before = std::exchange(asked_, std::nullopt).value_or(answer_);
      if (answer_ != before) {
        Q_EMIT takenBack(before);
      }
      Q_EMIT finished();
      setAnswer(answer_);
      return true;
    }
    if ((key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) && key->modifiers() == Qt::NoModifier) {
      asked_.reset();
      Q_EMIT finished();
      return true;
    }
  }
  if (watched == reason_ && event->type() == QEvent::FocusOut) {
    asked_.reset();
  }
  if (watched == reason_ && event->type() == QEvent::FocusIn) {
    asked_ = asked_.value_or(answer_);
    Q_EMIT wanted();
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace torsio::gui
