// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/shell/about_box.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QSysInfo>

#include "app/gui/base/translated_text.h"
#include "app/services/base/build_info.h"

namespace torsio::gui {

namespace {

QString said(const char* text) {
  return QCoreApplication::translate("AboutBox", text);
}

}  // namespace

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
