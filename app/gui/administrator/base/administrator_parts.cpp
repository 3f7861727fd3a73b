// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/base/administrator_parts.h"

#include <span>
#include <utility>

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/outputs/report/report_data.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/rating/assignment.h"

namespace torsio::gui {

QVBoxLayout* pageColumn(QWidget* page) {
  QVBoxLayout* column = columnOf(page, {3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace}, 2 * kSpace);
  return column;
}

QVBoxLayout* scrolledColumn(QWidget* page) {
  QVBoxLayout* outer = columnOf(page, {});
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
  fillCohorts(chooser, cohorts(session), first);
}

void fillCohorts(QComboBox* chooser, std::vector<CohortRow> rows, CohortFirst first) {
  const std::string before = chosenId(chooser);
  const QSignalBlocker quiet(chooser);
  chooser->clear();
  chooser->setPlaceholderText(QCoreApplication::translate("Administration", "no cohort yet"));
  chooser->setMinimumContentsLength(static_cast<int>(chooser->placeholderText().size()));
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

namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("Study", text);
}

}  // namespace

QString occasionName(const Occasion& occasion) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"pre", QT_TRANSLATE_NOOP("Study", "before training")},
      {"mid", QT_TRANSLATE_NOOP("Study", "half-way")},
      {"post", QT_TRANSLATE_NOOP("Study", "after training")}};
  for (const auto& [known, name] : kNames) {
    if (occasion.code == known) {
      return translated(name);
    }
  }
  return occasion.label.empty() ? QStringLiteral("\u2013") : toQString(occasion.label);
}

QString levelName(const std::string& code) {
  if (code.empty()) {
    return translated(QT_TRANSLATE_NOOP("Study", "not known"));
  }
  return toQString(fromStoredText<Sex>(code) ? labelOfStored<Sex>(code) : labelOfStored<Handedness>(code));
}

QString raterClassName(const std::string& code) {
  return code.empty() ? QStringLiteral("\u2013") : toQString(labelOfStored<Seniority>(code));
}

}  // namespace torsio::gui
