// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/table_choice.h"

#include <array>

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>

#include "app/gui/widgets/file_choice.h"

namespace torsio::gui {

namespace {

struct TableKind {
  const char* id;  // in the settings
  CsvStyle look;
  const char* name;
};
constexpr std::array kKinds{
    TableKind{"comma", {',', '.'}, QT_TRANSLATE_NOOP("TableChoice", "Table 1,234.5 with commas (*.csv)")},
    TableKind{"semicolon",
              {';', ','},
              QT_TRANSLATE_NOOP("TableChoice",
                                "Table 1234,5 with semicolons, for Excel in German, French ... (*.csv)")},
    TableKind{"tab", {'\t', '.'}, QT_TRANSLATE_NOOP("TableChoice", "Table with tabulators (*.tsv)")},
};
const QString kKindKey = QStringLiteral("files/table");

const TableKind& usualKind() {
  const QString last = QSettings().value(kKindKey).toString();
  for (const TableKind& kind : kKinds) {
    if (last == QLatin1String(kind.id)) {
      return kind;
    }
  }
  const bool comma = QLocale::system().decimalPoint() == QLatin1String(",");
  return kKinds[comma ? 1 : 0];
}

QString nameOf(const TableKind& kind) {
  return QCoreApplication::translate("TableChoice", kind.name);
}

}  // namespace

CsvStyle usualTableLook() {
  return usualKind().look;
}

TableChoice askTableToSave(QWidget* parent, const QString& title, const QString& name) {
  QStringList filters{nameOf(usualKind())};
  for (const TableKind& kind : kKinds) {
    if (!filters.contains(nameOf(kind))) {
      filters << nameOf(kind);
    }
  }
  QString chosen = filters.front();
  TableChoice choice;
  choice.file = askFileToSave(parent, title, name + QStringLiteral(".csv"),
                              filters.join(QStringLiteral(";;")), &chosen);
  for (const TableKind& kind : kKinds) {
    if (chosen == nameOf(kind)) {
      choice.look = kind.look;
      if (!choice.file.isEmpty()) {
        QSettings().setValue(kKindKey, QLatin1String(kind.id));
      }
    }
  }
  return choice;
}

}  // namespace torsio::gui
