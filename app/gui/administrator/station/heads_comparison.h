// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/gui/widgets/page_parts.h"
#include "app/services/maintenance/station_anchor.h"
#include "sim/core/error.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace torsio::gui {

class FieldChecks;
class ShellContext;

/// Returns a field for heads, which are long words.
[[nodiscard]] QPlainTextEdit* headsField(QWidget* parent, const char* name, int lines);

/// Card that compares saved heads, typed or read from a file, with the record.
class HeadsComparison : public Card {
  Q_OBJECT

 public:
  HeadsComparison(ShellContext& shell, QWidget* parent);

  /// Sets the file that is offered first.
  void setWitness(const std::string& file) { witness_ = file; }
  /// Removes the verdict.
  void forget();
  /// Compares the record with the lines of the field.
  void verify();
  void retranslate();

 Q_SIGNALS:
  /// The record was compared, or the lines could not be read.
  void compared();

 private:
  void addChecks();
  void loadWitness();
  void showVerdict();

  ShellContext& shell_;
  std::string witness_;
  std::optional<HeadsVerdict> found_;  ///< empty: not compared yet
  std::optional<Error> unreadable_;    ///< error of the lines
  QLabel* text_;
  QPlainTextEdit* lines_;
  QPushButton* load_;
  QLabel* publicLabel_ = nullptr;
  QLineEdit* public_;
  QPushButton* verify_;
  QLabel* verdict_;
  FieldChecks* checks_;
};

}  // namespace torsio::gui
