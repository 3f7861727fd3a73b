// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/rail.h"

#include <QFont>
#include <QFontMetrics>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/widgets/accessible_role.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kNarrow = 64;
constexpr int kLeastHeight = 40;  // fits a finger
constexpr int kBesideName = 64;   // icon, gaps and padding of a line
constexpr int kNumberedPages = 9;

}  // namespace

Rail::Rail(const std::vector<RailGroup>& groups, QWidget* parent)
    : QFrame(parent), name_(new QLabel(QStringLiteral("Torsio"), this)), fold_(new QPushButton(this)) {
  setObjectName(QStringLiteral("rail"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kSpace, kSpace + 2, kSpace, kSpace);
  column->setSpacing(2);
  QFont font = name_->font();
  font.setPointSizeF(kTitleText_pt + 2.0);
  font.setWeight(QFont::DemiBold);
  name_->setFont(font);
  name_->setContentsMargins(kSpace + 4, 2, 0, kSpace + 2);
  column->addWidget(name_);

  list_ = new QWidget;
  auto* list = list_;
  list->setObjectName(QStringLiteral("pages"));
  setAccessibleRole(list, QAccessible::List);
  auto* lines = bareLayout<QVBoxLayout>(list, 2);
  for (const RailGroup& group : groups) {
    if (groups.size() > 1) {
      auto* label = new QLabel(list);
      label->setProperty("quiet", true);
      label->setProperty("small", true);
      label->setContentsMargins(kSpace + 4, kSpace, 0, 2);
      lines->addWidget(label);
      headings_.push_back({group.title, label});
    }
    for (const RailItem& item : group.items) {
      addLine(item, lines);
    }
  }
  lines->addStretch(1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(list);
  column->addWidget(scroll, 1);
  fold_->setMinimumHeight(kLeastHeight);
  column->addWidget(fold_);
  connect(fold_, &QPushButton::clicked, this, [this] {
    setNarrow(!narrow_);
    Q_EMIT narrowChanged(narrow_);
  });
  retranslate();
}

void Rail::addLine(const RailItem& item, QVBoxLayout* column) {
  auto* button = new QPushButton;
  setAccessibleRole(button, QAccessible::ListItem);
  button->setCheckable(true);
  button->setMinimumHeight(kLeastHeight);
  button->setIconSize({20, 20});
  const int number = static_cast<int>(lines_.size()) + 1;
  if (number <= kNumberedPages) {
    button->setShortcut(QKeySequence(QStringLiteral("Alt+%1").arg(number)));
  }
  column->addWidget(button);
  lines_.push_back({item, button});
  connect(button, &QPushButton::clicked, this, [this, id = item.id] {
    setCurrent(current_);  // the mark only moves when the page has opened
    Q_EMIT chosen(id);
  });
}

void Rail::setCurrent(std::optional<PageId> id) {
  current_ = id;
  for (const Line& line : lines_) {
    line.button->setChecked(line.item.id == id);
  }
}

void Rail::setWaiting(PageId id, std::size_t count) {
  for (Line& line : lines_) {
    if (line.item.id == id && line.waiting != count) {
      line.waiting = count;
      retranslate();
    }
  }
}

void Rail::setNarrow(bool narrow) {
  narrow_ = narrow;
  retranslate();
}

void Rail::setTheme(const Theme& theme) {
  for (const Line& line : lines_) {
    line.button->setIcon(icon(line.item.icon, theme));
  }
  fold_->setIcon(icon(QStringLiteral("menu"), theme));
}

void Rail::retranslate() {
  setAccessibleName(tr("Pages"));
  list_->setAccessibleName(tr("Pages"));
  name_->setVisible(!narrow_);
  for (const Heading& heading : headings_) {
    heading.label->setText(heading.title());
    heading.label->setVisible(!narrow_);
  }
  for (const Line& line : lines_) {
    const QKeySequence keys = line.button->shortcut();  // setting the text clears the shortcut
    const QString count = QString::number(line.waiting);
    const QString title =
        line.waiting == 0 ? pageTitle(line.item.id) : tr("%1 (%2)").arg(pageTitle(line.item.id), count);
    line.button->setText(!narrow_ ? title : line.waiting == 0 ? QString() : count);
    line.button->setShortcut(keys);
    // The current line is bold: reserves its width, so that nothing is clipped or moves.
    QFont bold = line.button->font();
    bold.setWeight(QFont::DemiBold);
    line.button->setMinimumWidth(narrow_ ? 0 : QFontMetrics(bold).horizontalAdvance(title) + kBesideName);
    line.button->setAccessibleName(title);
    line.button->setToolTip(
        keys.isEmpty() ? title : tr("%1 (%2)").arg(title, keys.toString(QKeySequence::NativeText)));
  }
  fold_->setText(narrow_ ? QString() : tr("Collapse sidebar"));
  fold_->setAccessibleName(narrow_ ? tr("Expand sidebar") : tr("Collapse sidebar"));
  fold_->setToolTip(fold_->accessibleName());
  if (narrow_) {
    setFixedWidth(kNarrow);
  } else {
    setMinimumWidth(0);
    setMaximumWidth(QWIDGETSIZE_MAX);
    setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Preferred);
  }
}

}  // namespace torsio::gui
