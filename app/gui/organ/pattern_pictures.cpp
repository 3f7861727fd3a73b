// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/pattern_pictures.h"

#include <algorithm>
#include <utility>

#include <QGridLayout>
#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <QVBoxLayout>

#include "app/gui/base/figure_card.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/charts/relief.h"
#include "sim/core/angle.h"
#include "sim/scene/scene_file.h"

namespace torsio::gui {

namespace {

constexpr int kPictureWidth = 112;
constexpr int kTallestPicture = 150;

ReportRelief reliefOf(const std::shared_ptr<const TriangleMesh>& mesh, const std::vector<Vec3>& places_m) {
  ReportRelief relief;
  relief.triangles = std::shared_ptr<const std::vector<TriangleMesh::Triangle>>(mesh, &mesh->triangles);
  for (const Vec3& place_m : places_m) {
    relief.places.push_back(seenFromFront(place_m));
  }
  return relief;
}

}  // namespace

PatternPictures::PatternPictures(std::filesystem::path assets, QWidget* parent)
    : QWidget(parent), titles_(std::move(assets)), lines_(bareLayout<QVBoxLayout>(this, kSpace / 2)) {}

bool PatternPictures::show(const OrganImport& import) {
  anatomy_ = import.organ.anatomy.empty() ? kOwnOrganScene : import.organ.anatomy;
  patterns_ = import.patterns;
  drawn_ = import.drawn;
  fill();
  return !patterns_.empty();
}

void PatternPictures::retranslate() {
  fill();
}

void PatternPictures::setTheme(const Theme& theme) {
  style_ = chartStyle(theme);
  fill();
}

QWidget* PatternPictures::pictureRow(const PatternJudgement& pattern) {
  std::vector<ReportRelief> reliefs{reliefOf(drawn_, drawn_->vertices_m)};
  QStringList captions{tr("at rest")};
  for (const TurnedShape& shape : pattern.shapes) {
    reliefs.push_back(reliefOf(drawn_, shape.places_m));
    captions << tr("%1\u00b0").arg(numberText(degrees(shape.angle_rad), 0));
  }
  const QRectF box = reliefBox(reliefs);
  const double ratio = devicePixelRatioF();
  const double scale = std::min(kPictureWidth / box.width(), kTallestPicture / box.height());
  auto* row = new QWidget(this);
  auto* grid = bareLayout<QGridLayout>(row, kSpace / 2);
  for (std::size_t i = 0; i < reliefs.size(); ++i) {
    QImage image = drawRelief(reliefs[i], box, static_cast<int>(ratio * scale * box.width()), style_).image;
    image.setDevicePixelRatio(ratio);
    auto* picture = new QLabel(row);
    picture->setObjectName(QStringLiteral("patternPicture"));
    picture->setPixmap(QPixmap::fromImage(image));
    picture->setAlignment(Qt::AlignCenter);
    picture->setAccessibleName(captions[static_cast<qsizetype>(i)]);
    auto* caption = new QLabel(captions[static_cast<qsizetype>(i)], row);
    caption->setAlignment(Qt::AlignCenter);
    setLook(caption, "quiet", true);
    grid->addWidget(picture, 0, static_cast<int>(i));
    grid->addWidget(caption, 1, static_cast<int>(i));
  }
  return row;
}

void PatternPictures::addPattern(const PatternJudgement& pattern) {
  const auto add = [this](QWidget* line) {
    lines_->addWidget(line);
    shown_.push_back(line);
  };
  QLabel* head = sentence(this);
  const QString title = titles_.pattern(anatomy_, pattern.id);
  head->setText(pattern.accepted ? tr("%1: offered").arg(title) : tr("%1: left out").arg(title));
  head->setObjectName(QStringLiteral("patternHead"));
  setLook(head, "caution", !pattern.accepted);
  QFont bold = head->font();
  bold.setBold(true);
  head->setFont(bold);
  add(head);
  if (!pattern.reason.empty()) {
    QLabel* why = sentence(this, true);
    const QString reason = toQString(pattern.reason);
    why->setText(
        pattern.brokenAt_rad && pattern.code != "M27"
            ? tr("Breaks at %1\u00b0: %2.").arg(numberText(degrees(*pattern.brokenAt_rad), 0), reason)
            : tr("%1.").arg(capitalised(reason)));
    add(why);
  }
  if (drawn_ != nullptr && !pattern.shapes.empty()) {
    add(pictureRow(pattern));
  }
}

void PatternPictures::fill() {
  for (QWidget* line : shown_) {
    lines_->removeWidget(line);
    delete line;
  }
  shown_.clear();
  for (const PatternJudgement& pattern : patterns_) {
    addPattern(pattern);
  }
}

}  // namespace torsio::gui
