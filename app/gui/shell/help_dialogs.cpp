// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/help_dialogs.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QScrollArea>
#include <QSysInfo>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/shell/desk.h"
#include "app/gui/widgets/theme.h"
#include "app/services/base/build_info.h"

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

QString said(const char* text) {
  return QCoreApplication::translate("AboutBox", text);
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

QString aboutText() {
  const QString paragraph = QStringLiteral("<p>%1</p>");
  QString text = QStringLiteral("<h3>Torsio %1</h3>").arg(toQString(softwareVersion()));
  text +=
      paragraph.arg(said(QT_TRANSLATE_NOOP("AboutBox", "Training and assessment of surgical twist skills.")));
  text += QStringLiteral("<p><b>%1</b></p>")
              .arg(said(QT_TRANSLATE_NOOP(
                  "AboutBox",
                  "This is a training tool and not a medical device. It holds no patient data "
                  "and must not be used to decide about a patient.")));
  text += paragraph.arg(said(QT_TRANSLATE_NOOP("AboutBox", "Built with Qt %1 for %2, running on %3."))
                            .arg(QLatin1String(QT_VERSION_STR), QSysInfo::buildAbi(),
                                 QSysInfo::prettyProductName().toHtmlEscaped()));
  text += paragraph.arg(said(QT_TRANSLATE_NOOP(
      "AboutBox",
      "Free software under the GNU General Public License, version 3 or later, without any warranty.")));
  return text;
}

void showAboutBox(QWidget* parent) {
  QMessageBox box(QMessageBox::NoIcon, said(QT_TRANSLATE_NOOP("AboutBox", "About Torsio")), aboutText(),
                  QMessageBox::Close, parent);
  box.setTextFormat(Qt::RichText);
  box.exec();
}

}  // namespace torsio::gui
