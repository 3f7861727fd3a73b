// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <QDialog>
#include <QString>

#include "app/services/access/start_password.h"
#include "app/services/access/two_people.h"
#include "app/services/people/people_service.h"

class QDialogButtonBox;
class QPushButton;
class QVBoxLayout;
class QWidget;

namespace torsio::gui {

class FieldChecks;

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
  /// Adds the buttons and shows the dialog; `checks` decide when it may be accepted. True: accepted.
  [[nodiscard]] bool ask(const QString& accept, FieldChecks* checks = nullptr);
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

class DataTable;

/// Selects people from a list; initially all are selected.
class PeopleDialog : public QDialog {
  Q_OBJECT

 public:
  PeopleDialog(const QString& title, const QString& question, const std::vector<PersonRow>& people,
               QWidget* parent);

  [[nodiscard]] std::vector<PersonId> chosen() const;

 private:
  DataTable* table_;
};

class ShellContext;

/// Shows a start password, or the half that the actor may know, once, with a copy button.
void showStartPassword(QWidget* parent, const StartAccount& account);

/// Says that a second person was asked. Where the centre has set a mail server and knows an address, offers
/// to tell the other administrators by mail. Throws Error.
void sayAsked(QWidget* parent, ShellContext& shell);

/// Runs `act`. If a second person is needed and has not been asked, offers to ask, and shows the first half
/// of a start password if one is made for `login`. Returns true if `act` succeeded. Throws any other error of
/// `act`.
bool actOrAsk(QWidget* parent, ShellContext& shell, const DutyWish& wish, const std::function<void()>& act,
              const QString& login = {});
/// Like actOrAsk() for several wishes without start passwords: `act` handles one of them; for those that need
/// a second person, offers once to ask. Returns how many were done.
std::size_t actOrAskForAll(QWidget* parent, ShellContext& shell, const std::vector<DutyWish>& wishes,
                           const std::function<void(const DutyWish&)>& act);
/// Offers once to ask a second person for several wishes without start passwords. Returns true if asked.
/// Throws Error.
bool offerToAskForAll(QWidget* parent, ShellContext& shell, const std::vector<DutyWish>& wishes);
/// Offers to ask a second person. Returns true if asked. Throws Error.
bool offerToAsk(QWidget* parent, ShellContext& shell, const DutyWish& wish, const QString& login = {});

}  // namespace torsio::gui
