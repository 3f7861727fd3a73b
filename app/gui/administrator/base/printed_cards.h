// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/access/first_run.h"
#include "app/services/study/allocation_service.h"

namespace torsio::gui {

/// Writers of PDFs to print on A4 and cut: each strip has an envelope's label on the left and the card for it
/// on the right. Throw Error{kFileUnwritable}.

/// The card names the group.
void writeSealedCards(const std::vector<SealedCard>& cards, const std::string& cohort,
                      const std::filesystem::path& file);
/// The envelope shows the person's name, if the caller may see names; the card shows sign-in name and start
/// password.
void writeAccountCards(const std::vector<StartAccount>& accounts, const std::string& centre,
                       const std::filesystem::path& file);

/// A card that signs in at a kiosk: its owner, and the code in digits and as a barcode.
struct KioskCardText {
  std::string personCode{};
  std::string login{};
  std::string code{};
};
/// The label shows the person's code and sign-in name; the card shows the barcode.
void writeKioskCards(const std::vector<KioskCardText>& cards, const std::string& centre,
                     const std::filesystem::path& file);

/// A link to the review desk for browsers, or the code that goes with another administrator's link.
struct InvitationCardText {
  std::string personCode{};
  std::string login{};
  std::string link{};  ///< empty: handed over by somebody else
  std::string code{};  ///< empty: not needed, or handed over by somebody else
  std::int64_t expiresUtc_us = 0;
};
/// The label shows the person's code and sign-in name; the card shows the link or the code.
void writeInvitationCards(const std::vector<InvitationCardText>& cards, const std::string& centre,
                          const std::filesystem::path& file);

/// A bar or a gap of a barcode.
struct BarcodeStripe {
  double left = 0.0;  ///< in units of the narrowest bar
  double width = 1.0;
};

/// Returns the dark bars of digits as Code 39 (ISO/IEC 16388) with start and stop character, which every hand
/// scanner reads; wide bars are 2.5 narrow ones. Throws ContractError for anything but digits.
[[nodiscard]] std::vector<BarcodeStripe> code39(const std::string& digits);
/// Returns the total width without the quiet zones of ten on either side, in narrow bars.
[[nodiscard]] double code39Width(std::size_t digits) noexcept;

}  // namespace torsio::gui
