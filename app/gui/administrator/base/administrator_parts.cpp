// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/administrator_parts.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/theme.h"
#include "app/outputs/report/report_data.h"
#include "app/services/study/cohort_service.h"

namespace torsio::gui {

QVBoxLayout* pageColumn(QWidget* page) {
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  column->setSpacing(2 * kSpace);
  return column;
}

QVBoxLayout* scrolledColumn(QWidget* page) {
  auto* outer = new QVBoxLayout(page);
  outer->setContentsMargins(0, 0, 0, 0);
  auto* scroll = new QScrollArea(page);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  outer->addWidget(scroll);
  auto* content = new QWidget;
  scroll->setWidget(content);
  return pageColumn(content);
}

QPushButton* listButton(DataTable* table) {
  auto* button = new QPushButton(table);
  button->setAutoDefault(false);  // Enter presses the dialog's default button, never a row's
  table->addTool(button);
  return button;
}

void fillCohorts(QComboBox* chooser, SessionContext& session, CohortFirst first) {
  const std::string before = chosenId(chooser);
  const QSignalBlocker quiet(chooser);
  chooser->clear();
  chooser->setPlaceholderText(QCoreApplication::translate("Administration", "no cohort yet"));
  chooser->setMinimumContentsLength(static_cast<int>(chooser->placeholderText().size()));
  std::vector<CohortRow> rows = cohorts(session);
  for (CohortRow& row : rows) {
    row.today = row.today && first == CohortFirst::kOfToday;
    if (row.cohort.state != CohortState::kArchived) {
      chooser->addItem(toQString(Text(row.cohort.name)), toQString(row.cohort.id));
    }
  }
  if (const std::size_t shown = cohortShownFirst(rows); shown < rows.size()) {
    chooseId(chooser, rows[shown].cohort.id);
  }
  if (!before.empty()) {
    chooseId(chooser, before);
  }
}

void fillCampaigns(QComboBox* chooser, SessionContext& session, const QString& none) {
  const std::string before = chosenId(chooser);
  const QSignalBlocker quiet(chooser);
  chooser->clear();
  chooser->addItem(none, QString());
  int first = 0;
  for (const ReportableCampaign& campaign : reportableCampaigns(session)) {
    chooser->addItem(toQString(Text(campaign.name)), toQString(campaign.id));
    if (campaign.hasMarks) {
      first = chooser->count() - 1;
    }
  }
  chooser->setCurrentIndex(first);
  if (!before.empty()) {
    chooseId(chooser, before);
  }
}

std::string chosenId(const QComboBox* chooser) {
  return chooser->currentData().toString().toStdString();
}

void chooseId(QComboBox* chooser, const std::string& id) {
  const int at = chooser->findData(toQString(id));
  if (at >= 0) {
    chooser->setCurrentIndex(at);
  }
}

QString orDash(const std::string& text) {
  return text.empty() ? QStringLiteral("\u2013") : toQString(text);
}

QStringList listOf(const std::vector<std::string>& texts) {
  QStringList all;
  for (const std::string& text : texts) {
    all << toQString(text);
  }
  return all;
}

QString firstFew(const QStringList& names) {
  constexpr qsizetype kFew = 3;
  const QString first = names.mid(0, kFew).join(QCoreApplication::translate("Administration", ", "));
  const qsizetype more = names.size() - kFew;
  return more > 0 ? QCoreApplication::translate("Administration", "%1 and %2 more").arg(first).arg(more)
                  : first;
}

}  // namespace torsio::gui
