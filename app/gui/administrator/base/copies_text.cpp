// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/copies_text.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QCoreApplication>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/maintenance/copies.h"

namespace torsio::gui {

namespace {

constexpr std::size_t kShown = 5;  // a year of daily backups does not fit on a screen

struct CopiesText {
  Q_DECLARE_TR_FUNCTIONS(CopiesText)
};

}  // namespace

QString copiesText(SessionContext& session, std::span<const PersonId> people, const QLocale& locale) {
  std::vector<ListedCopy> copies;
  std::set<std::string> known;
  for (const PersonId& person : people) {
    for (ListedCopy& listed : copiesHolding(session, person)) {
      if (known.insert(listed.copy.id).second) {
        copies.push_back(std::move(listed));
      }
    }
  }
  if (copies.empty()) {
    return {};
  }
  QString text =
      QStringLiteral("\n\n") +
      (people.size() == 1
           ? CopiesText::tr("These copies still contain this person; Torsio does not delete them:")
           : CopiesText::tr("These copies still contain these people; Torsio does not delete them:"));
  for (std::size_t i = 0; i < std::min(copies.size(), kShown); ++i) {
    const ListedCopy& listed = copies[i];
    text += QLatin1Char('\n') + CopiesText::tr("%1 at %2: %3, to be deleted by %4")
                                    .arg(toQString(labelOf(listed.copy.kind)), toQString(listed.copy.station),
                                         toQString(listed.copy.place), shownTime(listed.dueUtc_us, locale));
  }
  if (copies.size() > kShown) {
    text += QLatin1Char('\n') + CopiesText::tr("and %n older one(s); torsio db copies lists all", nullptr,
                                               static_cast<int>(copies.size() - kShown));
  }
  return text;
}

}  // namespace torsio::gui
