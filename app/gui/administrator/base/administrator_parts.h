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

class QComboBox;
class QHBoxLayout;
class QPushButton;
class QVBoxLayout;
class QWidget;

namespace torsio {
class SessionContext;
}

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

}  // namespace torsio::gui
