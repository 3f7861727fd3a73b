// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <QDialog>
#include <QString>

class QDialogButtonBox;
class QPushButton;
class QVBoxLayout;

namespace torsio::gui {

/// Dialog with a sentence, the caller's content and two buttons. GUI thread.
class QuestionDialog : public QDialog {
 public:
  /// `question`: plain text above the content, since it may contain names; empty: none.
  QuestionDialog(QWidget* parent, const QString& title, const QString& question = {});

  /// Returns the column for the content, below the sentence.
  [[nodiscard]] QVBoxLayout* column() const noexcept { return column_; }
  /// Adds an unobtrusive note to the column.
  void addNote(const QString& text);
  /// Adds the buttons below the content. Returns the default button, named `accept`.
  QPushButton* finish(const QString& accept);
  /// Adds a single button below the content, for dialogs that only show something. It accepts.
  QPushButton* finishWithoutCancel(const QString& accept);

 private:
  QPushButton* addButtons(QDialogButtonBox* buttons, const QString& accept);

  QVBoxLayout* column_;
};

/// Returns the hint for a missing reason.
[[nodiscard]] QString reasonWanted();

/// Asks for a one-sentence reason; `title` also labels the accepting button. Empty: cancelled.
[[nodiscard]] std::optional<std::string> askReason(QWidget* parent, const QString& title,
                                                   const QString& question);

/// Asks whether unpublished changes in a form may be discarded. True: yes.
[[nodiscard]] bool mayLoseChanges(QWidget* parent);

/// Makes Enter finish an input in `dialog` without pressing any of its present buttons.
void pressNothingByEnter(QDialog& dialog);

}  // namespace torsio::gui
