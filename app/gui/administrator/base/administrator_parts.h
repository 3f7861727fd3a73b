// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/occasion.h"
#include "assessment/domain/study/protocol_terms.h"

class QComboBox;
class QHBoxLayout;
class QPushButton;
class QVBoxLayout;
class QWidget;

namespace torsio {
class SessionContext;
struct CohortRow;
}  // namespace torsio

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Adds the column layout of an administrator's page, with the common margins.
QVBoxLayout* pageColumn(QWidget* page);
/// Like pageColumn(), in a scroll area.
QVBoxLayout* scrolledColumn(QWidget* page);
/// Adds a button to the tools of a list.
QPushButton* listButton(DataTable* table);
/// Fills a chooser with the cohorts that are not archived, newest last; keeps the choice when refilled.
/// Initial choice: cohortShownFirst(), or the running study regardless of today's sessions.
enum class CohortFirst { kOfToday, kStudy };
void fillCohorts(QComboBox* chooser, SessionContext& session, CohortFirst first);
/// The same with cohorts that were read before.
void fillCohorts(QComboBox* chooser, std::vector<CohortRow> rows, CohortFirst first);
/// Fills a chooser with the evaluation campaigns and `none`. Initial choice: the newest one with marks.
void fillCampaigns(QComboBox* chooser, SessionContext& session, const QString& none);
/// Returns the id of the current choice; empty: none.
[[nodiscard]] std::string chosenId(const QComboBox* chooser);
void chooseId(QComboBox* chooser, const std::string& id);

/// Returns the text, or a dash if it is empty.
[[nodiscard]] QString orDash(const std::string& text);
[[nodiscard]] QStringList listOf(const std::vector<std::string>& texts);
/// Returns the first three names and the number of the others: "T-01, T-02, T-03 and 5 more".
[[nodiscard]] QString firstFew(const QStringList& names);

/// Returns the elements of `all` whose `idOf(one)` is selected in a list, in the order of `all`. The pointers
/// are valid as long as `all`.
template <typename One, typename IdOf>
[[nodiscard]] std::vector<const One*> chosenRows(const DataTable& table, const std::vector<One>& all,
                                                 IdOf idOf) {
  const QStringList ids = table.selectedIds();
  std::vector<const One*> chosen;
  for (const One& one : all) {
    if (ids.contains(toQString(idOf(one)))) {
      chosen.push_back(&one);
    }
  }
  return chosen;
}

/// Returns `nameOf(one)` of each selected row.
template <typename One, typename NameOf>
[[nodiscard]] QStringList namesOf(const std::vector<const One*>& chosen, NameOf nameOf) {
  QStringList names;
  for (const One* one : chosen) {
    names << toQString(nameOf(*one));
  }
  return names;
}

/// Returns the heading of a printed card or form: the centre's name, or "Torsio" if it has none.
[[nodiscard]] inline QString centreHeadline(const QString& centre) {
  return centre.isEmpty() ? QStringLiteral("Torsio") : centre;
}

// Codes of the record in the user's language; an unknown code is shown unchanged, an empty one as a dash.

/// "half-way"; occasions that a centre added have the centre's names.
[[nodiscard]] QString occasionName(const Occasion& occasion);
/// A level of a BalanceFactor.
[[nodiscard]] QString levelName(const std::string& code);
/// "chief physician"; a centre's own classes are shown by their code.
[[nodiscard]] QString raterClassName(const std::string& code);

}  // namespace torsio::gui
