// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/base/printed_cards.h"

#include <algorithm>
#include <array>
#include <string_view>

#include <QBuffer>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/outputs/charts/typeface.h"
#include "app/outputs/pdf/pdf_structure.h"
#include "app/services/access/qr_code.h"
#include "sim/core/contracts.h"
#include "sim/core/file_io.h"

namespace torsio::gui {

namespace {

constexpr int kDotsPerInch = 150;
constexpr double kMargin_mm = 12.0;
constexpr int kCardsOnPage = 4;
constexpr double kSafety = 0.97;                      // printers hint fonts at another size
constexpr std::array kLineHeights{0.25, 0.55, 0.78};  // of a strip's height
constexpr std::array kLinesRoundCode{0.13, 0.74, 0.88};

struct PrintedCards {
  Q_DECLARE_TR_FUNCTIONS(PrintedCards)
};

struct CardLine {
  QString text;
  double points = 9.0;
  bool bold = false;
};

/// One strip of a page: the label of the envelope and the card that goes into it.
struct PrintedCard {
  std::array<CardLine, 3> label;
  std::array<CardLine, 3> inside;
  std::string barcode{};   ///< digits; empty: none
  std::string forPhone{};  ///< shown as a QR code between the lines, for a phone's camera; empty: none
};

/// Draws the lines of a half; shrinks lines that are too wide, so that nothing is cut off in any font.
void drawHalf(QPainter& painter, const QRectF& half, const std::array<CardLine, 3>& lines,
              const std::array<double, 3>& heights = kLineHeights) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    QFont font = printedTypeface();
    font.setBold(lines[i].bold);
    font.setPointSizeF(lines[i].points);
    const double width = QFontMetricsF(font, painter.device()).horizontalAdvance(lines[i].text);
    font.setPointSizeF(lines[i].points * std::min(1.0, kSafety * half.width() / std::max(width, 1.0)));
    painter.setFont(font);
    const QRectF place(half.left(), half.top() + (heights[i] - 0.1) * half.height(), half.width(),
                       0.2 * half.height());
    painter.drawText(place, static_cast<int>(Qt::AlignCenter) | Qt::TextDontClip, lines[i].text);
  }
}

/// Draws a centred barcode with quiet zones of ten narrow bars.
void drawBarcode(QPainter& painter, const QRectF& half, const std::string& digits) {
  constexpr double kQuiet = 10.0;
  const double narrow = half.width() / (code39Width(digits.size()) + 2.0 * kQuiet);
  for (const BarcodeStripe& bar : code39(digits)) {
    painter.fillRect(QRectF(half.left() + (kQuiet + bar.left) * narrow, half.top() + 0.38 * half.height(),
                            bar.width * narrow, 0.32 * half.height()),
                     Qt::black);
  }
}

/// Draws a centred QR code between the first line and the others.
void drawForPhone(QPainter& painter, const QRectF& half, const std::string& text) {
  constexpr double kShare = 0.45;  // of the height of a half: about 30 mm
  constexpr double kMiddle = 0.43;
  constexpr double kQuiet = 4.0;
  const auto dark = qrCode(text).dark;
  const double side = kShare * half.height();
  const double module = side / (static_cast<double>(dark.size()) + 2.0 * kQuiet);
  const QPointF origin(half.center().x() - 0.5 * side + kQuiet * module,
                       half.top() + kMiddle * half.height() - 0.5 * side + kQuiet * module);
  QPainterPath squares;
  squares.setFillRule(Qt::WindingFill);
  for (std::size_t row = 0; row < dark.size(); ++row) {
    for (std::size_t column = 0; column < dark.size(); ++column) {
      if (dark[row][column]) {
        squares.addRect(origin.x() + static_cast<double>(column) * module,
                        origin.y() + static_cast<double>(row) * module, module, module);
      }
    }
  }
  painter.fillPath(squares, Qt::black);
}

void drawCard(QPainter& painter, const QRectF& strip, const PrintedCard& card) {
  QRectF label = strip;
  label.setWidth(strip.width() / 2.0);
  QRectF inside = label.translated(strip.width() / 2.0, 0.0);
  painter.setPen(QPen(Qt::gray, 0, Qt::DashLine));
  painter.drawRect(strip);
  painter.drawLine(label.topRight(), label.bottomRight());
  painter.setPen(Qt::black);
  const double inset = 0.04 * strip.width();
  drawHalf(painter, label.adjusted(inset, 0.0, -inset, 0.0), card.label);
  drawHalf(painter, inside.adjusted(inset, 0.0, -inset, 0.0), card.inside,
           card.forPhone.empty() ? kLineHeights : kLinesRoundCode);
  if (!card.forPhone.empty()) {
    drawForPhone(painter, inside, card.forPhone);
  }
  if (!card.barcode.empty()) {
    drawBarcode(painter, inside, card.barcode);
  }
}

void writeCards(const std::vector<PrintedCard>& cards, const QString& title,
                const std::filesystem::path& file) {
  QBuffer out;
  out.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&out);
    writer.setResolution(kDotsPerInch);
    writer.setTitle(title);
    writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait,
                                     QMarginsF(kMargin_mm, kMargin_mm, kMargin_mm, kMargin_mm),
                                     QPageLayout::Millimeter));
    QPainter painter(&writer);
    const QRectF page(painter.viewport());
    const double height = page.height() / kCardsOnPage;
    for (std::size_t i = 0; i < cards.size(); ++i) {
      const auto place = static_cast<int>(i % kCardsOnPage);
      if (i > 0 && place == 0) {
        writer.newPage();
      }
      drawCard(painter, QRectF(0.0, place * height, page.width(), height), cards[i]);
    }
  }
  writeFileAtomically(file, searchablePdf(out.data().toStdString()));
}

}  // namespace

void writeSealedCards(const std::vector<SealedCard>& cards, const std::string& cohort,
                      const std::filesystem::path& file) {
  std::vector<PrintedCard> printed;
  for (const SealedCard& card : cards) {
    printed.push_back(
        {.label = {{{toQString(cohort)},
                    {toQString(card.traineeCode), 24.0, true},
                    {PrintedCards::tr("No. %1. Open when the training begins.").arg(card.sequence)}}},
         .inside = {{{PrintedCards::tr("%1 trains in group").arg(toQString(card.traineeCode))},
                     {toQString(card.groupCode), 24.0, true},
                     {toQString(card.groupLabel), 11.0}}}});
  }
  writeCards(printed, PrintedCards::tr("Sealed cards: %1").arg(toQString(cohort)), file);
}

void writeAccountCards(const std::vector<StartAccount>& accounts, const std::string& centre,
                       const std::filesystem::path& file) {
  std::vector<PrintedCard> printed;
  for (const StartAccount& account : accounts) {
    const QString code = toQString(account.personCode);
    const QString envelope = toQString(envelopeWords(account));
    printed.push_back(
        {.label = {{{centreHeadline(toQString(centre))},
                    account.personName.empty() ? CardLine{code, 24.0, true}
                                               : CardLine{toQString(account.personName), 18.0, true},
                    {account.personName.empty() ? envelope : QStringLiteral("%1. %2").arg(code, envelope)}}},
         .inside = {{{PrintedCards::tr("Sign-in name: %1").arg(toQString(account.login)), 11.0},
                     {toQString(writtenPassword(account)), 15.0, true},
                     {toQString(cardWords(account))}}}});
  }
  writeCards(printed, PrintedCards::tr("Start passwords: %1").arg(centreHeadline(toQString(centre))), file);
}

void writeKioskCards(const std::vector<KioskCardText>& cards, const std::string& centre,
                     const std::filesystem::path& file) {
  std::vector<PrintedCard> printed;
  for (const KioskCardText& card : cards) {
    QString spaced = toQString(card.code);
    for (qsizetype i = spaced.size() - 4; i > 0; i -= 4) {
      spaced.insert(i, QLatin1Char(' '));
    }
    printed.push_back({.label = {{{centreHeadline(toQString(centre))},
                                  {toQString(card.personCode), 24.0, true},
                                  {PrintedCards::tr("Sign-in name: %1").arg(toQString(card.login))}}},
                       .inside = {{{PrintedCards::tr("%1: hold the card to the scanner, or type the code")
                                        .arg(toQString(card.personCode))},
                                   {QString()},
                                   {spaced, 11.0}}},
                       .barcode = card.code});
  }
  writeCards(printed, PrintedCards::tr("Cards for the kiosk: %1").arg(centreHeadline(toQString(centre))),
             file);
}

void writeInvitationCards(const std::vector<InvitationCardText>& cards, const std::string& centre,
                          const std::filesystem::path& file) {
  std::vector<PrintedCard> printed;
  for (const InvitationCardText& card : cards) {
    const std::array<CardLine, 3> link{
        {{PrintedCards::tr("Open this address in a browser, once, and choose a password")},
         {toQString(card.link), 11.0},
         {PrintedCards::tr("For you alone. Your sign-in name: %1").arg(toQString(card.login))}}};
    const std::array<CardLine, 3> code{{{PrintedCards::tr("The code that goes with your link")},
                                        {toQString(card.code), 15.0, true},
                                        {PrintedCards::tr("The link is sent separately.")}}};
    printed.push_back({.label = {{{centreHeadline(toQString(centre))},
                                  {toQString(card.personCode), 24.0, true},
                                  {PrintedCards::tr("Sign-in name: %1").arg(toQString(card.login))}}},
                       .inside = card.link.empty() ? code : link,
                       .forPhone = card.link});
  }
  writeCards(printed, PrintedCards::tr("Invitations: %1").arg(centreHeadline(toQString(centre))), file);
}

namespace {

constexpr double kWide = 2.5;
constexpr std::string_view kBorder = "nwnnwnwnn";  // the character *
// Five bars and four gaps, bar first; w: wide.
constexpr std::array<std::string_view, 10> kDigits{"nnnwwnwnn", "wnnwnnnnw", "nnwwnnnnw", "wnwwnnnnn",
                                                   "nnnwwnnnw", "wnnwwnnnn", "nnwwwnnnn", "nnnwnnwnw",
                                                   "wnnwnnwnn", "nnwwnnwnn"};

void addSign(std::string_view pattern, double& at, std::vector<BarcodeStripe>& bars) {
  bool dark = true;
  for (const char width : pattern) {
    const double wide = width == 'w' ? kWide : 1.0;
    if (dark) {
      bars.push_back({at, wide});
    }
    at += wide;
    dark = !dark;
  }
  at += 1.0;  // gap between characters
}

}  // namespace

std::vector<BarcodeStripe> code39(const std::string& digits) {
  std::vector<BarcodeStripe> bars;
  double at = 0.0;
  addSign(kBorder, at, bars);
  for (const char digit : digits) {
    TORSIO_EXPECTS(digit >= '0' && digit <= '9');
    addSign(kDigits[static_cast<std::size_t>(digit - '0')], at, bars);
  }
  addSign(kBorder, at, bars);
  return bars;
}

double code39Width(std::size_t digits) noexcept {
  constexpr double kSign = 6.0 + 3.0 * kWide;  // three of nine stripes are wide
  return static_cast<double>(digits + 2) * (kSign + 1.0) - 1.0;
}

}  // namespace torsio::gui
