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

/// Asks something: a sentence, the content that the caller puts into the column, and two buttons. GUI thread.
class QuestionDialog : public QDialog {
 public:
  /// `question`: the sentence above the content; empty: none. It is plain text, since it may hold names.
  QuestionDialog(QWidget* parent, const QString& title, const QString& question = {});

  /// Where the content goes, below the sentence.
  [[nodiscard]] QVBoxLayout* column() const noexcept { return column_; }
  /// Adds a quiet sentence to the column.
  void addNote(const QString& text);
  /// Adds the buttons below the content. Returns the one that accepts, called `accept`, which Enter presses.
  QPushButton* finish(const QString& accept);
  /// Adds a single button below the content, for what is only shown. It accepts.
  QPushButton* finishWithoutCancel(const QString& accept);

 private:
  QPushButton* addButtons(QDialogButtonBox* buttons, const QString& accept);

  QVBoxLayout* column_;
};

/// The hint at a reason that is missing.
[[nodiscard]] QString reasonWanted();

/// Asks for one sentence on why; `title` is the name of the accepting button as well. Empty: given up.
[[nodiscard]] std::optional<std::string> askReason(QWidget* parent, const QString& title,
                                                   const QString& question);

/// Asks, where a form with what is not published is about to be closed, whether that may be lost.
[[nodiscard]] bool mayLoseChanges(QWidget* parent);

/// Enter ends an input in `dialog` and presses none of the buttons that it has now.
void pressNothingByEnter(QDialog& dialog);

}  // namespace torsio::gui
