// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <QString>

#include "app/services/study/curriculum_content.h"

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

// What the parts of the curriculum editor share.

inline constexpr double kMicrosecondsOfMinute = 60e6;
inline constexpr double kMicrosecondsOfSecond = 1e6;

/// A number that is typed; without the arrows that a wheel turns by accident.
[[nodiscard]] QDoubleSpinBox* numberField(double least, double most, int decimals, QWidget* parent = nullptr);

/// Buttons in a row, as narrow as their texts.
[[nodiscard]] QBoxLayout* buttonRow(std::initializer_list<QPushButton*> buttons);
/// Makes a table one of few rows whose cells are fields.
void prepareFieldTable(QTableWidget* table);
/// Hides the fields of a table and gives it so many rows, whose fields the caller sets anew.
void setFieldRows(QTableWidget* table, int rows);
/// Makes a table of fields as high as its rows, at least `leastRows` of them.
void fitRows(QTableWidget* table, int leastRows);

/// Chooses the entry with this data; one that is not among them is added, so that nothing is ever changed by
/// being shown.
void chooseOrAdd(QComboBox* box, const std::string& value);

/// The row of a table in which this cell widget stands; -1: in none.
[[nodiscard]] int rowOf(const QTableWidget* table, const QWidget* cell);

/// "V7": the first number that no code of `taken` has.
[[nodiscard]] std::string freeCode(const std::string& prefix, const std::vector<std::string>& taken);

/// The labels of a form, with the English text each gets translated from.
class FormTexts {
 public:
  /// A label above or beside `field`; `source` is marked with QT_TR_NOOP in the context of the form.
  QLabel* add(QWidget* field, const char* source);
  /// A row of the form: label and field.
  void row(QFormLayout* form, QWidget* field, const char* source);
  /// A row of several fields, each after its own label but the first.
  void row(QFormLayout* form, std::initializer_list<std::pair<QWidget*, const char*>> fields);
  /// Puts a title over a part of the form; `beside`: what stands at its right, such as buttons.
  void title(QFormLayout* form, const char* source, QLayout* beside = nullptr);
  void retranslate(const char* context);

 private:
  std::vector<std::pair<QLabel*, const char*>> labels_;
};

/// What is wrong and what to do, in one line.
[[nodiscard]] QString problemSentence(const CurriculumProblem& problem);

/// Sentences under the fields of a form that say what is wrong with them; hidden while nothing is.
class FieldHints {
 public:
  /// The next row of the form is for what is wrong with the field above it.
  void add(QFormLayout* form, CurriculumField field);
  /// Says what is wrong with one module or arm of the draft.
  void show(const std::vector<CurriculumProblem>& problems, CurriculumSpot::Part part, std::size_t row);

 private:
  std::vector<std::pair<CurriculumField, QLabel*>> labels_;
};

}  // namespace torsio::gui
