// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/shortcut_sheet.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/shell/desk.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

void addGroup(QGridLayout* grid, const QString& title, const std::vector<KeyLine>& lines) {
  if (lines.empty()) {
    return;
  }
  auto* heading = new QLabel(title);
  heading->setProperty("subheading", true);
  heading->setContentsMargins(0, kSpace, 0, 2);
  grid->addWidget(heading, grid->rowCount(), 0, 1, 2);
  for (const auto& [what, keys] : lines) {
    const int row = grid->rowCount();
    grid->addWidget(new QLabel(what), row, 0);
    auto* label = new QLabel(keys);
    label->setProperty("quiet", true);
    grid->addWidget(label, row, 1);
  }
}

QString readable(const QKeySequence& keys) {
  return keys.toString(QKeySequence::NativeText);
}

}  // namespace

std::vector<KeyLine> keysOf(const QWidget& page) {
  std::vector<KeyLine> lines;
  for (const QAction* action : page.findChildren<QAction*>()) {
    QString text = action->text();
    if (action->shortcut().isEmpty() || text.isEmpty() || !action->isVisible()) {
      continue;
    }
    lines.emplace_back(text.remove(QLatin1Char('&')), readable(action->shortcut()));
  }
  return lines;
}

ShortcutSheet::ShortcutSheet(Desk* desk, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Keys"));
  auto* list = new QWidget;
  auto* grid = new QGridLayout(list);
  grid->setHorizontalSpacing(5 * kSpace);
  grid->setVerticalSpacing(4);
  addGroup(grid, tr("Everywhere"),
           {{tr("This list"), tr("F1, or ?")},
            {tr("Full screen"), readable(Qt::Key_F11)},
            {tr("Next field, previous field"), tr("Tab, Shift + Tab")},
            {tr("Page of the navigation"), tr("Alt + 1 to Alt + 9")},
            {tr("Lock now"), readable(Qt::CTRL | Qt::ALT | Qt::Key_L)},
            {tr("Close a dialog, release the tissue"), readable(Qt::Key_Escape)}});
  if (desk != nullptr && desk->page() != nullptr) {
    std::vector<KeyLine> lines = keysOf(*desk->page());
    for (const auto& [what, keys] : desk->page()->keys()) {
      lines.emplace_back(what, keys);
    }
    addGroup(grid, tr("On this page"), lines);
  }
  grid->setRowStretch(grid->rowCount(), 1);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setWidget(list);
  scroll->setFocusPolicy(Qt::StrongFocus);
  scroll->setAccessibleName(tr("Keys"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(scroll, 1);
  column->addWidget(buttons);
  resize(list->sizeHint().width() + 8 * kSpace, 560);
}

}  // namespace torsio::gui
