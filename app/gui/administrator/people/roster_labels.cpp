// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/roster_labels.h"

#include <QCoreApplication>

#include "app/gui/base/translated_text.h"

namespace torsio::gui {

namespace {

struct RosterTexts {
  Q_DECLARE_TR_FUNCTIONS(RosterTexts)
};

}  // namespace

QString rosterFieldName(RosterField field) {
  return toQString(Text(rosterFieldLabel(field)));
}

QString rosterStatusName(RosterStatus status) {
  switch (status) {
    case RosterStatus::kNew:
      return RosterTexts::tr("+ new");
    case RosterStatus::kSame:
      return RosterTexts::tr("= as it is");
    case RosterStatus::kChanges:
      return RosterTexts::tr("\u2192 changes");
    case RosterStatus::kError:
      return RosterTexts::tr("! error");
  }
  return {};
}

QString rosterNote(const RosterRow& row) {
  QStringList parts;
  if (!row.problem.empty()) {
    parts << RosterTexts::tr("%1. %2.").arg(toQString(row.problem), toQString(row.remedy));
  }
  for (const RosterChange& change : row.changes) {
    parts << RosterTexts::tr("%1: %2 \u2192 %3")
                 .arg(rosterFieldName(change.field),
                      change.from.empty() ? QStringLiteral("\u2013") : toQString(change.from),
                      toQString(change.to));
  }
  if (!row.hint.empty()) {
    parts << toQString(row.hint);
  }
  return parts.join(QStringLiteral("; "));
}

QString rosterProblem(const Error& error) {
  const TranslatedError said = translated(error);
  const QString what =
      said.details.isEmpty() ? said.happened : RosterTexts::tr("%1 (%2)").arg(said.happened, said.details);
  return (said.remedy.isEmpty() ? RosterTexts::tr("%1.").arg(what)
                                : RosterTexts::tr("%1. %2.").arg(what, said.remedy));
}

}  // namespace torsio::gui
