// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <QLocale>
#include <QString>

#include "app/services/study/curriculum_content.h"
#include "app/services/study/curriculum_service.h"

class QBoxLayout;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLayout;
class QPushButton;
class QTableWidget;
class QWidget;

namespace torsio::gui {

// Shared by the parts of the curriculum editor.

inline constexpr double kMicrosecondsOfMinute = 60e6;
inline constexpr double kMicrosecondsOfSecond = 1e6;

/// Returns a number field without arrows, which the mouse wheel would turn by accident.
[[nodiscard]] QDoubleSpinBox* numberField(double least, double most, int decimals, QWidget* parent = nullptr);

/// Lays out buttons in a row, at their minimum widths.
[[nodiscard]] QBoxLayout* buttonRow(std::initializer_list<QPushButton*> buttons);
/// Configures a short table whose cells are fields.
void prepareFieldTable(QTableWidget* table);
/// Hides the fields of a table and sets the number of rows; the caller sets new fields.
void setFieldRows(QTableWidget* table, int rows);
/// Fits the height of a table of fields to its rows, at least `leastRows`.
void fitRows(QTableWidget* table, int leastRows);

/// Selects the entry with this data; adds a missing one, so that showing a value never changes it.
void chooseOrAdd(QComboBox* box, const std::string& value);

/// Returns the row of a cell widget; -1: not in the table.
[[nodiscard]] int rowOf(const QTableWidget* table, const QWidget* cell);

/// Returns prefix and first unused number, such as "V7".
[[nodiscard]] std::string freeCode(const std::string& prefix, const std::vector<std::string>& taken);

/// The labels of a form with their English source texts, for retranslation.
class FormTexts {
 public:
  /// Creates a label above or beside `field`; `source` is marked with QT_TR_NOOP in the context of the form.
  QLabel* add(QWidget* field, const char* source);
  /// Adds a row with label and field.
  void row(QFormLayout* form, QWidget* field, const char* source);
  /// Adds a row of several fields, each but the first behind its own label.
  void row(QFormLayout* form, std::initializer_list<std::pair<QWidget*, const char*>> fields);
  /// Adds a section title; `beside`: layout at its right, such as buttons.
  void title(QFormLayout* form, const char* source, QLayout* beside = nullptr);
  void retranslate(const char* context);

 private:
  std::vector<std::pair<QLabel*, const char*>> labels_;
};

/// Returns the problem and its remedy in one line.
[[nodiscard]] QString problemSentence(const CurriculumProblem& problem);

/// Error messages under the fields of a form; hidden if there is no error.
class FieldHints {
 public:
  /// Adds a row for the errors of the field above it.
  void add(QFormLayout* form, CurriculumField field);
  /// Shows the errors of one module or arm of the draft.
  void show(const std::vector<CurriculumProblem>& problems, CurriculumSpot::Part part, std::size_t row);

 private:
  std::vector<std::pair<CurriculumField, QLabel*>> labels_;
};

/// Returns the status line of a draft: when it was saved, its next version number, the latest published
/// version. `changed`: it has unsaved edits.
[[nodiscard]] QString draftText(const CurriculumRow& row, bool changed, const QLocale& locale);
/// Returns the status line of a published version: date, state, cohorts that follow it, version that
/// superseded it.
[[nodiscard]] QString versionText(const CurriculumRow& row, const CurriculumVersionRow& version,
                                  const QLocale& locale);

}  // namespace torsio::gui
