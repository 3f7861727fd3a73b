// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/picture.h"

#include <string_view>

#include <QBuffer>
#include <QByteArray>
#include <QGuiApplication>
#include <QImage>

#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio::gui {

void writePicture(const QImage& picture, const std::filesystem::path& file) {
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  if (picture.isNull() || !picture.save(&buffer, "PNG")) {
    throw Error(ErrorCode::kDevice, Text::tr("this display cannot draw the scene"),
                Text::tr("platform %1", QGuiApplication::platformName().toStdString()),
                Text::tr("Use a display with OpenGL"));
  }
  writeFileAtomically(file, std::string_view(png.constData(), static_cast<std::size_t>(png.size())));
}

}  // namespace torsio::gui
