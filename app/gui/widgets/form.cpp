// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/form.h"

#include <algorithm>

#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QVBoxLayout>
#include <QWidget>

#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

/// A card of a given width, wider if a button or long word of the present language would be clipped.
class FittingCard : public QFrame {
 public:
  FittingCard(int width, QWidget* parent) : QFrame(parent), width_(width) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  }
  [[nodiscard]] QSize sizeHint() const override {
    return {std::max(width_, minimumSizeHint().width()), QFrame::sizeHint().height()};
  }

 private:
  int width_;
};

/// Maximum line length, characters, that is easy to read.
constexpr int kLongestLine = 120;

/// Wraps at a readable line length, however wide the window is.
class Sentence : public QLabel {
 public:
  using QLabel::QLabel;
  [[nodiscard]] QSize sizeHint() const override { return QLabel::sizeHint() - unused(); }
  [[nodiscard]] QSize minimumSizeHint() const override { return QLabel::minimumSizeHint() - unused(); }
  [[nodiscard]] int heightForWidth(int width) const override {
    return QLabel::heightForWidth(std::min(width, widest()) + contentsMargins().right());
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QLabel::resizeEvent(event);
    wrap();
  }
  void changeEvent(QEvent* event) override {
    QLabel::changeEvent(event);
    wrap();
  }

 private:
  [[nodiscard]] int widest() const { return kLongestLine * fontMetrics().averageCharWidth(); }
  [[nodiscard]] QSize unused() const { return {contentsMargins().right(), 0}; }
  void wrap() {
    const int rest = std::max(0, width() - widest());
    if (rest != contentsMargins().right()) {
      setContentsMargins(0, 0, rest, 0);
    }
  }
};

class ScrollGap final : public QObject {
 public:
  explicit ScrollGap(QLayout& content) : QObject(&content), content_(content) {}

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Show || event->type() == QEvent::Hide) {
      QMargins margins = content_.contentsMargins();
      margins.setRight(event->type() == QEvent::Show ? kSpace : 0);
      content_.setContentsMargins(margins);
    }
    return QObject::eventFilter(watched, event);
  }

 private:
  QLayout& content_;
};

}  // namespace

QVBoxLayout* centredCard(QWidget* ground, int width) {
  auto* outer = bareLayout<QVBoxLayout>(ground);
  auto* scroll = new QScrollArea(ground);  // at 200 %, a card may be taller than a small screen
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  outer->addWidget(scroll);
  auto* middle = new QWidget;
  scroll->setWidget(middle);
  auto* grid = new QGridLayout(middle);
  grid->setContentsMargins(2 * kSpace, 2 * kSpace, 2 * kSpace, 2 * kSpace);
  grid->setRowStretch(0, 2);
  grid->setRowStretch(2, 3);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(2, 1);
  auto* card = new FittingCard(width, middle);
  card->setObjectName(QStringLiteral("card"));
  grid->addWidget(card, 1, 1);
  auto* content = new QVBoxLayout(card);
  content->setContentsMargins(4 * kSpace, 4 * kSpace, 4 * kSpace, 3 * kSpace);
  content->setSpacing(kSpace);
  return content;
}

QHBoxLayout* rowOf(std::initializer_list<QWidget*> widgets, int spacing) {
  auto* row = new QHBoxLayout;
  row->setSpacing(spacing);
  for (QWidget* widget : widgets) {
    row->addWidget(widget);
  }
  return row;
}

QVBoxLayout* columnOf(QWidget* owner, const QMargins& margins, int spacing) {
  auto* column = new QVBoxLayout(owner);
  column->setContentsMargins(margins);
  column->setSpacing(spacing);
  return column;
}

QLabel* addField(QBoxLayout* layout, QWidget* field) {
  auto* label = new QLabel;
  label->setBuddy(field);
  layout->addWidget(label);
  layout->addWidget(field);
  return label;
}

void nameField(QLabel* label, const QString& text) {
  // Chinese mnemonics are in brackets at the end and not part of the name.
  static const QRegularExpression kMnemonic(QStringLiteral("\\(&.\\)|&"));
  label->setText(text);
  QString plain = text;
  if (label->buddy() != nullptr) {
    label->buddy()->setAccessibleName(plain.remove(kMnemonic));
  }
}

QLineEdit* secretField(QWidget* parent) {
  auto* field = new QLineEdit(parent);
  field->setEchoMode(QLineEdit::Password);
  field->setInputMethodHints(Qt::ImhHiddenText | Qt::ImhNoPredictiveText | Qt::ImhSensitiveData);
  return field;
}

QPushButton* primaryButton(QWidget* parent) {
  auto* button = new QPushButton(parent);
  button->setProperty("primary", true);
  return button;
}

QPushButton* linkButton(QWidget* parent) {
  auto* button = new QPushButton(parent);
  button->setProperty("link", true);
  return button;
}

QLabel* sentence(QWidget* parent, bool quiet) {
  auto* label = new Sentence(parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setProperty("quiet", quiet);
  return label;
}

QLabel* sentence(QWidget* parent, const QString& text, bool quiet) {
  QLabel* label = sentence(parent, quiet);
  label->setText(text);
  return label;
}

void setLook(QWidget* widget, const char* property, bool on) {
  if (widget->property(property).toBool() == on) {
    return;
  }
  widget->setProperty(property, on);
  widget->style()->unpolish(widget);
  widget->style()->polish(widget);
}

void keepOffScrollBar(QScrollArea& area, QLayout& content) {
  QMargins margins = content.contentsMargins();
  margins.setRight(0);
  content.setContentsMargins(margins);
  area.verticalScrollBar()->installEventFilter(new ScrollGap(content));
}

void growToSentences(QWidget* dialog) {
  dialog->layout()->activate();
  const int width = std::max(dialog->width(), dialog->minimumWidth());
  dialog->setMinimumHeight(std::max(dialog->minimumHeight(), dialog->layout()->totalHeightForWidth(width)));
}

}  // namespace torsio::gui
