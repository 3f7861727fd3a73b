// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/administrator/base/printed_cards.h"
#include "app/gui/administrator/people/shown_once_dialog.h"

namespace torsio::gui {

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
