// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/scene_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QQuickWidget>
#include <QQuickWindow>
#include <QVBoxLayout>

#include "app/gui/scene/organ_geometry.h"
#include "app/gui/scene/shear_map.h"
#include "app/gui/widgets/form.h"
#include "sim/servo/contact_coupling.h"

namespace torsio::gui {

namespace {

// In radii of the organ, so that lines look the same on large and small organs.
constexpr float kGhostDepth_mm = 0.6F;
constexpr float kLatticeWidth = 0.0042F;
constexpr float kGraspWidth = 0.013F;
constexpr float kMarkerRadius = 0.021F;

/// Placeholder of the organ: until it is loaded, or permanently on a display without OpenGL.
class InPlaceOfScene : public QLabel {
 public:
  /// `words`: in the context SceneView.
  InPlaceOfScene(const char* words, QWidget* parent) : QLabel(parent), words_(words) {
    setAlignment(Qt::AlignCenter);
    setWordWrap(true);
    retranslate();
  }

 protected:
  void changeEvent(QEvent* event) override {
    if (event->type() == QEvent::LanguageChange) {
      retranslate();
    }
    QLabel::changeEvent(event);
  }

 private:
  void retranslate() { setText(SceneView::tr(words_)); }

  const char* words_;
};

}  // namespace

SceneView::SceneView(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Organ and instrument"));
  setAccessibleDescription(tr("Three-dimensional view; the numbers beside it say the same in text."));
  setMinimumSize(320, 240);
  canvas_ = new SceneCanvas(*this);
  connect(canvas_, &SceneCanvas::frameDrawn, this, &SceneView::frameDrawn);
  connect(canvas_, &SceneCanvas::frameDrawn, this, &SceneView::endWaiting, Qt::QueuedConnection);
  connect(canvas_, &SceneCanvas::shaderPreferred, this, &SceneView::showAgain);
  legend_ = new StressLegend(this);
  legend_->hide();
  auto* layout = bareLayout<QVBoxLayout>(this);
  if (canvas_->drawn()) {
    layout->addWidget(canvas_->widget());
  } else {
    layout->addWidget(
        new InPlaceOfScene(QT_TR_NOOP("This display cannot show the organ: it has no OpenGL."), this));
  }
  waiting_ = new InPlaceOfScene(QT_TR_NOOP("Loading the organ\u2026"), this);
  waiting_->setObjectName(QStringLiteral("waiting"));
  waiting_->setAutoFillBackground(true);
  showWaiting();
  legend_->raise();
}

SceneView::~SceneView() = default;

void SceneView::prepareGraphics() {
  QQuickWindow::setGraphicsApi(QSGRendererInterface::OpenGL);
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
}

bool SceneView::platformCanRender() {
  return SceneCanvas::platformCanRender();
}

bool SceneView::draws() const {
  return canvas_->drawn() && isVisible();
}

void SceneView::prepareWindow(QWidget& window) {
  if (!platformCanRender()) {
    return;
  }
  auto* surface = new QQuickWidget(&window);  // never shown, draws nothing
  surface->setFocusPolicy(Qt::NoFocus);
  surface->resize(1, 1);
  surface->hide();
}

/// Covers the view in the theme's colour: the scene graph draws black before its first picture.
void SceneView::showWaiting() {
  const Theme& colours = theme(themeKind_);
  QPalette calm = waiting_->palette();
  calm.setColor(QPalette::Window, colours.backdrop);
  calm.setColor(QPalette::WindowText, colours.text);
  waiting_->setPalette(calm);
  waiting_->setGeometry(rect());
}

void SceneView::endWaiting() {
  if (!view_.surface.vertices().empty() || !canvas_->drawn()) {
    waiting_->hide();
  }
}

void SceneView::setScene(const ViewScene& view) {
  view_ = view;
  deformed_m_.assign(view_.surface.vertices().size(), Vec3{});
  shown_ = OrganState{};
  shapeShown_ = 0;
  QVector3D low(1e9F, 1e9F, 1e9F);
  QVector3D high = -low;
  for (const SurfaceVertex& v : view_.surface.vertices()) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v.position[k]);
      high[k] = std::max(high[k], v.position[k]);
    }
  }
  organCentre_ = 0.5F * (low + high);
  organRadius_ = 0.5F * (high - low).length();
  organBack_ = low.z();
  showSurroundings();
  canvas_->hangMesentery(view_.mesentery, view_.surface);
  canvas_->joinContinuations(view_.continuations, view_.surface);
  if (canvas_->drawn()) {
    const SceneCanvas::Parts& parts = canvas_->parts();
    if (view_.skin) {
      parts.skin->setSkin(*view_.skin);
    }
    parts.organ->setSurface(view_.surface, view_.skin.get());
    if (view_.shader) {
      constexpr int kWide = 1024;  // as in organ_place.glsl
      parts.organVertices->setTexels(view_.shader->vertices(), kWide);
      parts.organNeighbours->setNumbers(view_.shader->neighbours(), kWide);
    }
    parts.wire->setSurface(view_.surface);
    parts.lattice->setLines(view_.lines.lattice, kLatticeWidth * organRadius_, view_.surface);
    parts.grasp->setLines(view_.lines.grasp, kGraspWidth * organRadius_, view_.surface,
                          RibbonGeometry::Shape::kStanding);
  }
  setGhost(std::nullopt);
  setForce({}, {});
  legend_->setTop(view_.shear.top_Pa());
  shearShare_.assign(view_.surface.vertices().size(), 0.0F);
  colours_.resize(view_.surface.vertices().size());
  dented_ = false;
  findFollowed();
  byShader_ = false;
  canvas_->setDeformedByShader(false);
  canvas_->setLook(view_.look);
  setShearVisible(shearVisible_);
  setMarkersVisible(markersVisible_);
  frameOrgan();
  if (!canvas_->drawn()) {
    endWaiting();
  }
}

void SceneView::showSurroundings() {
  if (!view_.surface.vertices().empty()) {
    canvas_->setSurroundings(view_.surroundings, view_.surface, organCentre_, organRadius_, organBack_,
                             theme(themeKind_));
    canvas_->castShadow(view_.surface);
  }
}

void SceneView::forgetScene() {
  view_ = {};
  deformed_m_ = {};
  shown_.reset();
  if (canvas_->drawn()) {
    waiting_->show();
  }
}

void SceneView::setOrgan(const OrganState& state) {
  if (!view_.deform || !moves(state)) {
    return;
  }
  dented_ = false;
  if (onCard()) {
    showOnCard(state, {});
    return;
  }
  deformSkin(state);
  showSkin();
}

void SceneView::setTissue(const LiveState& state) {
  if (!view_.deform) {
    return;
  }
  const OrganState organ = organStateOf(state);
  const bool touched = state.patches[0].depth_m > 0.0 || state.patches[1].depth_m > 0.0;
  if ((touched || dented_ || moves(organ)) && onCard()) {
    showOnCard(organ, state.patches);
    dented_ = touched;
  } else if (touched || dented_ || moves(organ)) {
    deformSkin(organ);
    dented_ = indentSurface(state, deformed_m_);
    showSkin();
  }
  setForce(state.tool.position_m, state.response.force_N);
}

void SceneView::setForce(const Vec3& at_m, const Vec3& force_N) {
  canvas_->setForce(at_m, force_N, organRadius_);
}

bool SceneView::moves(const OrganState& state) const {
  const bool otherShape = view_.shapeNumber && view_.shapeNumber() != shapeShown_;
  return !shown_.has_value() || *shown_ != state || otherShape || byShader_ != onCard();
}

void SceneView::deformSkin(const OrganState& state) {
  shown_ = state;
  shapeShown_ = view_.shapeNumber ? view_.shapeNumber() : 0;
  if (shapeShown_ > 0) {
    view_.shape(deformed_m_);
  } else {
    view_.deform(state, deformed_m_);
  }
}

void SceneView::paintSkin() {
  if (shearVisible_ && !view_.shear.empty()) {
    view_.shear.evaluate(*shown_, shearShare_);
    for (std::size_t i = 0; i < colours_.size(); ++i) {
      colours_[i] = shearColour(shearShare_[i]);
    }
    view_.surface.paint(colours_);
  } else if (!view_.blood.empty()) {
    view_.blood.evaluate(*shown_, colours_);
    view_.surface.paint(colours_);
  }
}

bool SceneView::onCard() const {
  const bool overlaid = (shearVisible_ && !view_.shear.empty()) || wireframe_ || latticeVisible_ ||
                        (markersVisible_ && !view_.markers.empty());
  return canvas_->prefersShader() && view_.shader != nullptr && !view_.shapeNumber && !overlaid;
}

/// Shows the same state when the way to deform it has changed.
void SceneView::showAgain() {
  if (!view_.deform || !shown_.has_value() || byShader_ == onCard()) {
    return;
  }
  const OrganState state = *shown_;
  if (onCard()) {
    showOnCard(state, {});
  } else {
    deformSkin(state);
    showSkin();
  }
}

// Every vertex that a line, a mesentery or a continuation is tied to; and some hundreds, evenly, for the
// shadow.
void SceneView::findFollowed() {
  constexpr std::size_t kMaxShading = 1200;
  followed_.clear();
  shading_.clear();
  coversCurrent_ = false;
  const auto add = [this](std::span<const SkinAnchor> anchors) {
    for (const SkinAnchor& anchor : anchors) {
      followed_.insert(followed_.end(), anchor.corners.begin(), anchor.corners.end());
    }
  };
  for (const SkinLine& line : view_.lines.grasp) {
    add(line.anchors);
  }
  for (const MesenteryHold& hold : view_.mesentery) {
    add(hold);
  }
  for (const Continuation& one : view_.continuations) {
    add(one.end);
    add(one.before);
  }
  std::sort(followed_.begin(), followed_.end());
  followed_.erase(std::unique(followed_.begin(), followed_.end()), followed_.end());
  const std::size_t count = view_.surface.vertices().size();
  const std::size_t step = std::max<std::size_t>(1, (count + kMaxShading - 1) / kMaxShading);
  for (std::size_t v = 0; v < count; v += step) {
    shading_.push_back(static_cast<std::uint32_t>(v));
  }
}

void SceneView::showOnCard(const OrganState& state, std::span<const ContactPatch> dents) {
  shown_ = state;
  byShader_ = true;
  view_.shader->update(state);
  placeFollowed(dents);
  coverSkin(state);
  const SceneCanvas::Parts& parts = canvas_->parts();
  parts.organRows->setTexels(view_.shader->rows(), static_cast<int>(ShaderSkin::kRowTexels));
  canvas_->setDents(dents);
  canvas_->setDeformedByShader(true);
  canvas_->castShadow(view_.surface, shading_);
  parts.organ->setReach(view_.surface, shading_);
  parts.mesentery->follow(view_.surface);
  parts.continuations->follow(view_.surface);
  parts.grasp->follow(view_.surface);
}

void SceneView::placeFollowed(std::span<const ContactPatch> dents) {
  const auto dented = [dents](Vec3 place_m) {
    Vec3 sum;
    for (const ContactPatch& patch : dents) {
      sum += indentationAt(patch, place_m);
    }
    return place_m + sum;
  };
  for (const std::uint32_t vertex : shading_) {
    view_.surface.place(vertex, view_.shader->place_m(vertex), {0.0, 0.0, 1.0});
  }
  for (const std::uint32_t vertex : followed_) {
    view_.surface.place(vertex, dented(view_.shader->place_m(vertex)), view_.shader->normal_m2(vertex));
  }
}

/// Passes the colour of the blood, and what covers it where that has changed.
void SceneView::coverSkin(const OrganState& state) {
  const HollowPose& pose = state.hollow;
  const std::array<float, 3> blood =
      view_.blood.empty() ? std::array{1.0F, 1.0F, 1.0F} : BloodMap::twistedFactor(pose);
  canvas_->set("organBlood", QVector3D(blood[0], blood[1], blood[2]));
  const bool same =
      covered_.markCount == pose.markCount && covered_.clipped == pose.clipped &&
      std::equal(pose.marks.begin(), pose.marks.begin() + pose.markCount, covered_.marks.begin());
  if (coversCurrent_ && same) {
    return;
  }
  covered_ = pose;
  coversCurrent_ = true;
  covers_.assign(view_.surface.vertices().size(), {0.0F, 0.0F, 0.0F, 1.0F});
  if (!view_.blood.empty()) {
    view_.blood.cover(state, covers_);
  }
  canvas_->parts().organ->setCovers(covers_);
}

void SceneView::showSkin() {
  byShader_ = false;
  coversCurrent_ = false;
  canvas_->setDeformedByShader(false);
  view_.surface.update(deformed_m_);
  paintSkin();
  if (!canvas_->drawn()) {
    return;
  }
  canvas_->castShadow(view_.surface);
  const SceneCanvas::Parts& parts = canvas_->parts();
  parts.organ->updateVertices(view_.surface);
  canvas_->edgeOrgan(view_.surface);
  parts.mesentery->follow(view_.surface);
  parts.continuations->follow(view_.surface);
  parts.grasp->follow(view_.surface);
  if (wireframe_) {
    parts.wire->updateVertices(view_.surface);
  }
  if (latticeVisible_) {
    parts.lattice->follow(view_.surface);
  }
  if (markersVisible_) {
    placeMarkers();
  }
}

void SceneView::setShearVisible(bool visible) {
  const bool possible = !view_.shear.empty();
  shearVisible_ = visible;
  legend_->setVisible(visible && possible);
  placeLegend();
  if (view_.surface.vertices().empty() || !possible) {
    return;
  }
  if (!visible) {
    view_.surface.paint({});
  }
  canvas_->set("stressVisible", visible);
  if (!shown_.has_value()) {
    shown_ = OrganState{};
  }
  if (visible || !view_.blood.empty()) {
    view_.deform(*shown_, deformed_m_);
    showSkin();
  } else if (canvas_->drawn()) {
    if (byShader_) {
      return;
    }
    canvas_->parts().organ->updateVertices(view_.surface);
    canvas_->edgeOrgan(view_.surface);
  }
  showAgain();
}

void SceneView::setMarkersVisible(bool visible) {
  markersVisible_ = visible;
  showAgain();
  canvas_->set("markersVisible", visible && !view_.markers.empty());
  if (visible && canvas_->drawn() && !view_.surface.vertices().empty()) {
    placeMarkers();
  }
}

void SceneView::setMarkers(std::vector<SkinAnchor> markers) {
  view_.markers = std::move(markers);
  setMarkersVisible(markersVisible_);
}

void SceneView::placeMarkers() {
  std::vector<QVector3D> places;
  for (const SkinAnchor& marker : view_.markers) {
    places.push_back(markerPlace(marker, view_.surface));
  }
  canvas_->parts().markers->setMarkers(places, kMarkerRadius * organRadius_);
}

void SceneView::setGhost(const std::optional<OrganState>& state) {
  canvas_->set("ghostVisible", state.has_value());
  if (!state || !canvas_->drawn() || !view_.deform) {
    return;
  }
  OrganSurface ghost = view_.surface;
  std::vector<Vec3> vertices_m(ghost.vertices().size());
  view_.deform(*state, vertices_m);
  ghost.update(vertices_m);
  ghost.sink(kGhostDepth_mm);  // parts that do not move would flicker between ghost and tissue
  ghost.paint(std::vector<std::array<float, 3>>(ghost.vertices().size(), {1.0F, 1.0F, 1.0F}));  // one colour
  canvas_->parts().ghost->setSurface(ghost);
}

void SceneView::placeLegend() {
  legend_->resize(legend_->sizeHint());
  legend_->move(2 * kSpace, height() - legend_->height() - 2 * kSpace);
}

void SceneView::setSurroundingsVisible(bool visible) {
  canvas_->set("surroundingsVisible", visible);
}

void SceneView::setToolVisible(bool visible) {
  canvas_->set("toolVisible", visible);
}

void SceneView::setWireframe(bool visible) {
  wireframe_ = visible;
  showAgain();
  if (canvas_->drawn() && visible && !view_.surface.vertices().empty()) {
    canvas_->parts().wire->updateVertices(view_.surface);
  }
  canvas_->set("wireVisible", visible);
}

void SceneView::setLattice(bool visible) {
  latticeVisible_ = visible;
  showAgain();
  if (canvas_->drawn() && visible && !view_.surface.vertices().empty()) {
    canvas_->parts().lattice->follow(view_.surface);
  }
  canvas_->set("latticeVisible", visible);
}

void SceneView::setQuality(RenderQuality quality) {
  canvas_->setQuality(quality);
}

void SceneView::setTheme(const Theme& theme) {
  canvas_->setTheme(theme);
  legend_->setTheme(theme);
  if (std::exchange(themeKind_, theme.kind) != theme.kind) {
    showSurroundings();
    showWaiting();
  }
}

void SceneView::setInstrument(const InstrumentParts& parts) {
  canvas_->setInstrument(parts);
}

void SceneView::setTool(const Pose& pose, double grip) {
  canvas_->setTool(pose, grip);
}

void SceneView::applyCamera() {
  canvas_->setCamera(camera_, 8.0F * organRadius_);
  if (!byShader_) {
    canvas_->edgeOrgan(view_.surface);
  }
  Q_EMIT cameraChanged();
}

void SceneView::frameOrgan() {
  camera_.frame(organCentre_, organRadius_, QSizeF(size()));
  applyCamera();
}

void SceneView::redraw() {
  canvas_->redraw();
}

QImage SceneView::picture() {
  return canvas_->picture();
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeLegend();
  showWaiting();
  applyCamera();
}

}  // namespace torsio::gui
