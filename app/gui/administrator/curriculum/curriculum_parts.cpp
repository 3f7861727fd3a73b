// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/curriculum/curriculum_parts.h"

#include <algorithm>

#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStringList>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/signed_box.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/joined_sentences.h"

namespace torsio::gui {

namespace {

constexpr int kRowHeight = 5 * kSpace;
constexpr int kFieldWidth = 9 * kSpace;

}  // namespace

QDoubleSpinBox* numberField(double least, double most, int decimals, QWidget* parent) {
  QDoubleSpinBox* field = least < 0.0 ? new SignedBox(parent) : new QDoubleSpinBox(parent);
  field->setRange(least, most);
  field->setDecimals(decimals);
  field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field->setMinimumWidth(kFieldWidth);  // otherwise as wide as its largest possible number
  return field;
}

QBoxLayout* buttonRow(std::initializer_list<QPushButton*> buttons) {
  QHBoxLayout* row = rowOf({}, kSpace / 2);
  for (QPushButton* button : buttons) {
    button->setAutoDefault(false);
    row->addWidget(button);
  }
  row->addStretch(1);
  return row;
}

void prepareFieldTable(QTableWidget* table) {
  table->verticalHeader()->setVisible(false);
  table->verticalHeader()->setDefaultSectionSize(kRowHeight);
  table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table->setTabKeyNavigation(false);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setEditTriggers(QAbstractItemView::AllEditTriggers);
}

void setFieldRows(QTableWidget* table, int rows) {
  for (int row = 0; row < table->rowCount(); ++row) {
    for (int column = 0; column < table->columnCount(); ++column) {
      if (QWidget* before = table->cellWidget(row, column)) {
        before->hide();  // deleteLater() takes effect later
      }
    }
  }
  table->setRowCount(rows);
}

void fitRows(QTableWidget* table, int leastRows) {
  const int rows = std::max(leastRows, table->rowCount());
  const int height = table->horizontalHeader()->sizeHint().height() + rows * kRowHeight + 2;
  table->setMinimumHeight(height);
  table->setMaximumHeight(height);
}

void chooseOrAdd(QComboBox* box, const std::string& value) {
  if (box->findData(toQString(value)) < 0) {
    box->addItem(orDash(value), toQString(value));
  }
  box->setCurrentIndex(box->findData(toQString(value)));
}

int rowOf(const QTableWidget* table, const QWidget* cell) {
  for (int row = 0; row < table->rowCount(); ++row) {
    for (int column = 0; column < table->columnCount(); ++column) {
      if (table->cellWidget(row, column) == cell) {
        return row;
      }
    }
  }
  return -1;
}

std::string freeCode(const std::string& prefix, const std::vector<std::string>& taken) {
  for (std::size_t number = taken.size() + 1;; ++number) {
    std::string code = prefix + std::to_string(number);
    if (std::find(taken.begin(), taken.end(), code) == taken.end()) {
      return code;
    }
  }
}

QLabel* FormTexts::add(QWidget* field, const char* source) {
  auto* label = new QLabel;
  label->setBuddy(field);
  labels_.emplace_back(label, source);
  return label;
}

void FormTexts::row(QFormLayout* form, QWidget* field, const char* source) {
  form->addRow(add(field, source), field);
}

void FormTexts::row(QFormLayout* form, std::initializer_list<std::pair<QWidget*, const char*>> fields) {
  QHBoxLayout* box = rowOf();
  QLabel* first = nullptr;
  for (const auto& [field, source] : fields) {
    QLabel* label = add(field, source);
    if (first == nullptr) {
      first = label;
    } else {
      box->addSpacing(kSpace);
      box->addWidget(label);
    }
    box->addWidget(field, 1);
  }
  form->addRow(first, box);
}

void FormTexts::title(QFormLayout* form, const char* source, QLayout* beside) {
  QLabel* label = named(add(nullptr, source), "cardTitle");
  label->setContentsMargins(0, kSpace, 0, 0);
  label->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  if (beside == nullptr) {
    form->addRow(label);
    return;
  }
  auto* row = new QHBoxLayout;
  row->addWidget(label, 1);
  row->addLayout(beside);
  form->addRow(row);
}

void FormTexts::retranslate(const char* context) {
  for (const auto& [label, source] : labels_) {
    nameField(label, QCoreApplication::translate(context, source));
  }
}

QString problemSentence(const CurriculumProblem& problem) {
  return QCoreApplication::translate("torsio::gui::CurriculumEditor", "%1 %2. %3.")
      .arg(toQString(problem.where), toQString(problem.what), toQString(problem.remedy));
}

void FieldHints::add(QFormLayout* form, CurriculumField field) {
  QLabel* label = fieldHint();
  form->addRow(QString(), label);
  labels_.emplace_back(field, label);
}

void FieldHints::show(const std::vector<CurriculumProblem>& problems, CurriculumSpot::Part part,
                      std::size_t row) {
  for (const auto& [field, label] : labels_) {
    QStringList sentences;
    for (const CurriculumProblem& problem : problems) {
      const CurriculumSpot& spot = problem.spot;
      if (spot.part != part || spot.row != row || spot.field != field) {
        continue;
      }
      sentences << problemSentence(problem);
    }
    sayHint(label, sentences.join(QLatin1Char('\n')));
  }
}

namespace {

struct CurriculumState {
  Q_DECLARE_TR_FUNCTIONS(CurriculumState)
};

}  // namespace

QString draftText(const CurriculumRow& row, bool changed, const QLocale& locale) {
  if (changed) {
    return CurriculumState::tr("%1: changed, not saved. The draft is also saved when you leave.")
        .arg(toQString(Text(row.curriculum.name)));
  }
  QString next = CurriculumState::tr(
                     "Everything may be changed; nobody is affected until it is published as version %1.")
                     .arg(row.versions.size() + 1);
  if (row.hasDraft) {
    next = CurriculumState::tr("Saved %1. %2").arg(shownTime(row.draftChangedUtc_us, locale), next);
  }
  if (row.versions.empty()) {
    return next;
  }
  const CurriculumVersionRow& newest = row.versions.back();
  return CurriculumState::tr("%1 The newest version is %2: %3.")
      .arg(next)
      .arg(newest.number)
      .arg(toQString(labelOf(newest.state)));
}

QString versionText(const CurriculumRow& row, const CurriculumVersionRow& version, const QLocale& locale) {
  QStringList followers;
  for (const std::string& cohort : version.cohorts) {
    followers << toQString(cohort);
  }
  const QString who =
      followers.isEmpty()
          ? CurriculumState::tr("No cohort follows it.")
          : CurriculumState::tr("Followed by: %1.").arg(followers.join(CurriculumState::tr(", ")));
  QString words;
  if (version.state == torsio::CurriculumState::kDraft) {
    words =
        CurriculumState::tr("Published on %1 and never changes. Begin it, so that cohorts can follow it.");
  } else if (version.state == torsio::CurriculumState::kRunning) {
    words = CurriculumState::tr(
        "Published on %1, running: cohorts can choose it. It never changes; to change anything, edit the "
        "draft and publish the next version.");
  } else {
    words = CurriculumState::tr(
        "Published on %1, closed: no new cohort can choose it; cohorts that follow it continue. It is kept "
        "as it was.");
  }
  words = words.arg(shownTime(version.createdUtc_us, locale));
  if (!version.note.empty()) {
    words = joinedSentences({words, CurriculumState::tr("Note: %1.").arg(toQString(version.note))});
  }
  if (version.number < row.versions.back().number) {
    words = joinedSentences(
        {words, CurriculumState::tr("Superseded by version %1.").arg(row.versions.back().number)});
  }
  return joinedSentences({words, who});
}

}  // namespace torsio::gui
