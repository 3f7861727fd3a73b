// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/office/sealed_cards.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

#include "app/gui/office/office_parts.h"
#include "sim/base/file_io.h"

namespace torsio::gui {

namespace {

constexpr int kDotsPerInch = 150;
constexpr double kMargin_mm = 12.0;
constexpr int kCardsOnPage = 4;
constexpr double kFirstLine = 0.25;  // of a strip's height
constexpr double kSecondLine = 0.55;
constexpr double kThirdLine = 0.78;

QString words(const char* text) {
  return QCoreApplication::translate("SealedCards", text);
}

void line(QPainter& painter, const QRectF& half, double height, double points, bool bold,
          const QString& text) {
  QFont font = painter.font();
  font.setPointSizeF(points);
  font.setBold(bold);
  painter.setFont(font);
  const QRectF place(half.left(), half.top() + height * half.height() - 0.1 * half.height(), half.width(),
                     0.2 * half.height());
  painter.drawText(place, Qt::AlignCenter,
                   painter.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(half.width())));
}

void drawCard(QPainter& painter, const QRectF& strip, const SealedCard& card, const QString& cohort) {
  QRectF label = strip;
  label.setWidth(strip.width() / 2.0);
  QRectF inside = label.translated(strip.width() / 2.0, 0.0);
  painter.setPen(QPen(Qt::gray, 0, Qt::DashLine));
  painter.drawRect(strip);
  painter.drawLine(label.topRight(), label.bottomRight());
  painter.setPen(Qt::black);
  const double inset = 0.04 * strip.width();
  label.adjust(inset, 0.0, -inset, 0.0);
  inside.adjust(inset, 0.0, -inset, 0.0);
  line(painter, label, kFirstLine, 9.0, false, cohort);
  line(painter, label, kSecondLine, 24.0, true, shown(card.traineeCode));
  line(painter, label, kThirdLine, 9.0, false,
       words(QT_TRANSLATE_NOOP("SealedCards", "No. %1. Open when the training begins.")).arg(card.sequence));
  line(painter, inside, kFirstLine, 9.0, false,
       words(QT_TRANSLATE_NOOP("SealedCards", "%1 trains in group")).arg(shown(card.traineeCode)));
  line(painter, inside, kSecondLine, 24.0, true, shown(card.groupCode));
  line(painter, inside, kThirdLine, 11.0, false, shown(card.groupLabel));
}

}  // namespace

void writeSealedCards(const std::vector<SealedCard>& cards, const std::string& cohort,
                      const std::filesystem::path& file) {
  QBuffer out;
  out.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&out);
    writer.setResolution(kDotsPerInch);
    writer.setTitle(words(QT_TRANSLATE_NOOP("SealedCards", "Sealed cards: %1")).arg(shown(cohort)));
    writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait,
                                     QMarginsF(kMargin_mm, kMargin_mm, kMargin_mm, kMargin_mm),
                                     QPageLayout::Millimeter));
    QPainter painter(&writer);
    const QRectF page(painter.viewport());
    const double height = page.height() / kCardsOnPage;
    for (std::size_t i = 0; i < cards.size(); ++i) {
      const auto place = static_cast<int>(i % kCardsOnPage);
      if (i > 0 && place == 0) writer.newPage();
      drawCard(painter, QRectF(0.0, place * height, page.width(), height), cards[i], shown(cohort));
    }
  }
  writeFileAtomically(file, out.data().toStdString());
}

}  // namespace torsio::gui
