// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QObject>
#include <QString>

class QBoxLayout;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QWidget;

namespace torsio::gui {

/// Creates an error message for a field; hidden if there is none.
[[nodiscard]] QLabel* fieldHint(QWidget* parent = nullptr);
/// Shows an error; empty: none.
void sayHint(QLabel* hint, const QString& wrong);

/// Validates a form: shows errors below the fields and at the button that waits for them. An untouched field
/// shows no error: an empty form is not wrong. Lives as long as its form. GUI thread.
class FieldChecks : public QObject {
 public:
  explicit FieldChecks(QWidget* form);

  /// `wrong`: returns the field's error and remedy; empty: none. Called after each change of any field. The
  /// message goes into the next row of the form or column.
  void add(QFormLayout* form, QWidget* field, std::function<QString()> wrong);
  void add(QBoxLayout* column, QWidget* field, std::function<QString()> wrong);
  /// Adds a field whose message is already placed elsewhere.
  void add(QLabel* hint, QWidget* field, std::function<QString()> wrong);
  /// Adds a required line edit; `missing`: its message.
  void addNeeded(QFormLayout* form, QLineEdit* field, const QString& missing);
  /// Sets the button that needs all fields to be valid, and `also`; while disabled, its tool tip says why.
  void decide(QPushButton* accept, std::function<bool()> also = {});

  /// Validates all fields. True: valid.
  bool check();
  /// Shows this field's errors from now on, as if the user had left it.
  void touch(const QWidget* field);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Check {
    QWidget* field = nullptr;
    QLabel* hint = nullptr;
    std::function<QString()> wrong;
    bool touched = false;
  };
  void watch(QWidget* field);

  std::vector<Check> checks_;
  QPushButton* accept_ = nullptr;
  std::function<bool()> also_;
};

}  // namespace torsio::gui
