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

/// A sentence beside a field that says what is wrong with it; hidden while nothing is.
[[nodiscard]] QLabel* fieldHint(QWidget* parent = nullptr);
/// Shows what is wrong; empty: nothing.
void sayHint(QLabel* hint, const QString& wrong);

/// What keeps a form from being accepted, said below the field that is meant and at the button that waits for
/// it. A field that nobody has touched says nothing yet: an empty form is not wrong. Lives as long as its
/// form. GUI thread.
class FieldChecks : public QObject {
 public:
  explicit FieldChecks(QWidget* form);

  /// `wrong`: what is wrong with the field and what to do; empty: nothing. It is asked after each change of
  /// any field. The hint goes into the next row of the form, or the next place of the column.
  void add(QFormLayout* form, QWidget* field, std::function<QString()> wrong);
  void add(QBoxLayout* column, QWidget* field, std::function<QString()> wrong);
  /// A field whose hint stands elsewhere already.
  void add(QLabel* hint, QWidget* field, std::function<QString()> wrong);
  /// For one line of text that must not stay empty: `missing` says so.
  void addNeeded(QFormLayout* form, QLineEdit* field, const QString& missing);
  /// The button that needs everything to be right, and `also`; while it waits, its tool tip says for what.
  void decide(QPushButton* accept, std::function<bool()> also = {});

  /// Asks each field anew. True: nothing is wrong.
  bool check();
  /// Says from now on what is wrong with this field, as if somebody had left it.
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
