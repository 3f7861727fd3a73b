// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/reminder_text.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QStringList>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

struct ReminderText {
  Q_DECLARE_TR_FUNCTIONS(ReminderText)
};

QString caseText(const SheetAwaited& sheet, const QLocale& locale) {
  const QString label = toQString(sheet.caseLabel);
  if (sheet.live) {
    return (sheet.late ? ReminderText::tr("case %1 (late; called %2)")
                       : ReminderText::tr("case %1 (called %2)"))
        .arg(label, shownTime(sheet.calledUtc_us, locale));
  }
  if (!sheet.dueUtc_us) {
    return ReminderText::tr("case %1").arg(label);
  }
  return (sheet.late ? ReminderText::tr("case %1 (late; was due %2)") : ReminderText::tr("case %1 (due %2)"))
      .arg(label, shownTime(*sheet.dueUtc_us, locale));
}

}  // namespace

QString reminderText(const std::vector<Reminder>& owed, const QLocale& locale) {
  QStringList lines;
  for (const Reminder& reminder : owed) {
    QStringList cases;
    for (const SheetAwaited& sheet : reminder.sheets) {
      cases << caseText(sheet, locale);
    }
    QString whom = toQString(reminder.raterCode);
    if (!reminder.name.empty()) {
      whom += QLatin1Char(' ') + toQString(reminder.name);
    }
    if (!reminder.email.empty()) {
      whom += QStringLiteral(" <%1>").arg(toQString(reminder.email));
    }
    lines << ReminderText::tr("%1: please submit in Torsio: %2").arg(whom, cases.join(QStringLiteral(", ")));
  }
  return lines.join(QLatin1Char('\n'));
}

void copyReminders(ShellContext& shell, const CohortId& cohortId, const QLocale& locale) {
  const std::vector<Reminder> owed = reminders(shell.session(), cohortId);
  if (owed.empty()) {
    shell.notify(ReminderText::tr("No sheets are outstanding."));
    return;
  }
  QGuiApplication::clipboard()->setText(reminderText(owed, locale));
  noteReminders(shell.session(), owed, ReminderWay::kCopied);
  shell.notify(ReminderText::tr("Copied: the outstanding sheets of %n rater(s)", nullptr,
                                static_cast<int>(owed.size())));
}

}  // namespace torsio::gui
