// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <QDialog>
#include <QString>

#include "app/gui/administrator/base/printed_cards.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/access/first_run.h"

class QPushButton;

namespace torsio::gui {

/// Secrets shown once, one row per person, to copy or to save as cards. Asks before closing if neither was
/// done. GUI thread.
class ShownOnceDialog : public QDialog {
  Q_OBJECT

 public:
  /// Throws Error{kFileUnwritable}.
  void saveCards(const std::filesystem::path& file);
  void copy();
  void reject() override;

 protected:
  /// `fileName`: suggested name of the cards' file.
  ShownOnceDialog(const QString& title, const QString& words, const QString& fileName, QWidget* parent);
  void setLines(const std::vector<Column>& columns, std::vector<Row> rows);
  [[nodiscard]] QString linesAsText() const;

  virtual void writeCards(const std::filesystem::path& file) const = 0;
  /// Returns the text for "Copy"; by default the lines.
  [[nodiscard]] virtual QString copied() const { return linesAsText(); }

 private:
  void askCards();

  QString fileName_;
  DataTable* table_;
  QPushButton* copy_;
  QPushButton* cards_;
  bool taken_ = false;
};

/// Start passwords of new accounts.
class AccountsDialog : public ShownOnceDialog {
  Q_OBJECT

 public:
  /// `centre`: printed on the cards.
  AccountsDialog(const std::vector<StartAccount>& accounts, const std::string& centre, QWidget* parent);

 private:
  void writeCards(const std::filesystem::path& file) const override;

  std::vector<StartAccount> accounts_;
  std::string centre_;
};

/// Codes of new kiosk cards.
class KioskCardsDialog : public ShownOnceDialog {
  Q_OBJECT

 public:
  KioskCardsDialog(std::vector<KioskCardText> cards, std::string centre, QWidget* parent);

 private:
  void writeCards(const std::filesystem::path& file) const override;

  std::vector<KioskCardText> cards_;
  std::string centre_;
};

/// New links, and codes for other people's links: as cards, or as the text of a mail for each person.
class InvitationsDialog : public ShownOnceDialog {
  Q_OBJECT

 public:
  InvitationsDialog(std::vector<InvitationCardText> cards, std::string centre, QWidget* parent);

 private:
  void writeCards(const std::filesystem::path& file) const override;
  [[nodiscard]] QString copied() const override;

  std::vector<InvitationCardText> cards_;
  std::string centre_;
};

/// An administrator's input for invitations.
struct InvitationWish {
  std::string address{};  ///< address of the review desk for browsers
  std::string reason{};   ///< required if two people are needed
};
/// Asks for address and reason. Empty: cancelled.
[[nodiscard]] std::optional<InvitationWish> askInvitation(QWidget* parent, const QString& logins,
                                                          const std::string& address, bool byTwo);

}  // namespace torsio::gui
