// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/icons.h"

#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

#include "app/gui/widgets/theme.h"
#include "sim/core/contracts.h"

/// Names the resources, which the linker would otherwise drop from a static library.
static void initIconResources() {
  Q_INIT_RESOURCE(torsio_icons);
}

namespace torsio::gui {

namespace {

constexpr int kSizes[] = {20, 40, 60};  // 100 to 300 %

QByteArray drawing(const QString& name) {
  initIconResources();
  QFile file(QStringLiteral(":/torsio/icons/%1.svg").arg(name));
  const bool found = file.open(QIODevice::ReadOnly);
  TORSIO_EXPECTS(found);
  return file.readAll();
}

QPixmap pixmap(const QByteArray& svg, const QColor& colour, int size) {
  QByteArray tinted = svg;
  tinted.replace("currentColor", colour.name().toLatin1());
  QSvgRenderer renderer(tinted);
  QPixmap picture(size, size);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  renderer.render(&painter);
  return picture;
}

}  // namespace

QIcon icon(const QString& name, const Theme& theme) {
  const QByteArray svg = drawing(name);
  QIcon result;
  for (const int size : kSizes) {
    result.addPixmap(pixmap(svg, theme.text, size), QIcon::Normal, QIcon::Off);
    result.addPixmap(pixmap(svg, theme.accent, size), QIcon::Normal, QIcon::On);
    result.addPixmap(pixmap(svg, theme.disabledText, size), QIcon::Disabled, QIcon::Off);
  }
  return result;
}

QIcon applicationIcon() {
  const QByteArray svg = drawing(QStringLiteral("application"));
  QIcon result;
  for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
    result.addPixmap(pixmap(svg, Qt::white, size));
  }
  return result;
}

QIcon icon(const QString& name, const QColor& colour) {
  const QByteArray svg = drawing(name);
  QIcon result;
  for (const int size : kSizes) {
    result.addPixmap(pixmap(svg, colour, size));
  }
  return result;
}

}  // namespace torsio::gui
