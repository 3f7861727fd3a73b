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

/// The column in which the parts of an administrator's page stand, with the margins all of them share.
QVBoxLayout* pageColumn(QWidget* page);
/// The same for pages whose content may be taller than the window.
QVBoxLayout* scrolledColumn(QWidget* page);
/// A button among the tools of a list.
QPushButton* listButton(DataTable* table);
/// The cohorts of the record without the archived ones, newest last; keeps the choice when filled anew.
/// Chosen first: cohortShownFirst(), or the study that runs whatever is done today.
enum class CohortFirst { kOfToday, kStudy };
void fillCohorts(QComboBox* chooser, SessionContext& session, CohortFirst first);
/// The evaluation campaigns and "none". Chosen first: the newest that somebody has scored in.
void fillCampaigns(QComboBox* chooser, SessionContext& session, const QString& none);
/// Id of what is chosen; empty: nothing.
[[nodiscard]] std::string chosenId(const QComboBox* chooser);
void chooseId(QComboBox* chooser, const std::string& id);

/// The text, or a dash when there is none.
[[nodiscard]] QString orDash(const std::string& text);
[[nodiscard]] QStringList listOf(const std::vector<std::string>& texts);
/// The first three of some names and how many more there are: "T-01, T-02, T-03 and 5 more".
[[nodiscard]] QString firstFew(const QStringList& names);

}  // namespace torsio::gui
