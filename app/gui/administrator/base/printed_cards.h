// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/access/first_run.h"
#include "app/services/study/allocation_service.h"

namespace torsio::gui {

/// PDFs to print on A4 and to cut: in each strip on the left the label of an envelope (whose it is), on the
/// right the card that goes into it. Throw Error{kFileUnwritable}.

/// The card tells the group.
void writeSealedCards(const std::vector<SealedCard>& cards, const std::string& cohort,
                      const std::filesystem::path& file);
/// The envelope names the person, where the caller may see names; the card tells sign-in name and start
/// password.
void writeAccountCards(const std::vector<StartAccount>& accounts, const std::string& centre,
                       const std::filesystem::path& file);

/// A card that opens a kiosk: whose it is, the code in digits and as a barcode.
struct KioskCardText {
  std::string personCode{};
  std::string login{};
  std::string code{};
};
/// The label names the person's code and sign-in name; the card bears the barcode.
void writeKioskCards(const std::vector<KioskCardText>& cards, const std::string& centre,
                     const std::filesystem::path& file);

/// A link to the review desk in a browser, or the code that goes with a link of another administrator.
struct InvitationCardText {
  std::string personCode{};
  std::string login{};
  std::string link{};  ///< empty: somebody else hands it over
  std::string code{};  ///< empty: none is needed, or somebody else hands it over
  std::int64_t expiresUtc_us = 0;
};
/// The label names the person's code and sign-in name; the card bears the link or the code.
void writeInvitationCards(const std::vector<InvitationCardText>& cards, const std::string& centre,
                          const std::filesystem::path& file);

}  // namespace torsio::gui
