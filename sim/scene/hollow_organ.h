// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/core/staged_turn.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/scene/hollow_reach.h"
#include "sim/scene/hollow_swing.h"
#include "sim/scene/organ_state.h"
#include "sim/tissue/hollow/perfusion.h"
#include "sim/tissue/hollow/wrung_organ.h"
#include "sim/tissue/twist/twist_model_tables.h"

namespace torsio {

/// Wall and content of a hollow organ, as a scene file states them; a solid cord has no wall.
struct HollowWall {
  std::vector<std::array<double, 2>> thickness_m;  ///< share of the length, thickness; empty: a solid cord
  double gentLimit = 1.0;
  double restPressure_Pa = 0.0;  ///< at which the organ is drawn
  double pressure_Pa = 0.0;      ///< with which the trial begins
  bool vent = false;             ///< whether the content can be let out
  double ventedPressure_Pa = 0.0;
  bool sealed =
      false;  ///< whether it is a gas that keeps to p V = const until it is let out; else p is given
  bool foldsNeedRoom = false;  ///< TubeWall::foldsNeedRoom; false in scenes from before it was known
  std::string source;
};

/// A stretch of the organ that is wrung between a held section and the mobile part.
struct WrungSpan {
  double held = 0.0;    ///< fraction of the organ's length where it is held
  double mobile = 1.0;  ///< fraction where the mobile part begins; below `held` of a limb that ends the organ
};

/// With which twist a trial begins, drawn from its seed.
struct InitialTwist {
  double least_rad = 0.0;
  double most_rad = 0.0;
  double step_rad = 0.0;       ///< the angle is a multiple of it above `least_rad`; 0: any
  int sign = 1;                ///< usual direction: +1 or -1 about the organ's axis
  double oppositeShare = 0.0;  ///< of trials that turn the other way
  double since_s = 0.0;        ///< tissue time that it has lain so
  std::string source;
};

/// What keeps the organ twisted (docs/model.md): friction at its base, and weight and gas that turn it back.
struct BaseFriction {
  double stickShare = 0.5;    ///< mu_s: of the peak torque
  double relapseShare = 0.3;  ///< of the peak torque, towards the start, beyond relapseFrom_rad
  double relapseFrom_rad = 0.0;
  double relapseTime_s = 3.0;  ///< of a whole relapse
  std::string source;
};

/// Patency from which on a lumen counts as closed.
inline constexpr double kShutPatency = 0.02;

/// What tissue bears, and what counts as done.
struct DetorsionLimits {
  double jawArea_m2 = 12e-6;
  double jawForce_N = 6.0;  ///< of a jaw that is closed fully
  double bruise_Pa = 330e3;
  double bruise_s = 0.3;
  double tear_Pa = 660e3;
  double pull_N = 10.0;       ///< force of the hand on the organ that tears it
  double residual_rad = 0.0;  ///< least turn that counts as undone
  double patency = 0.8;
  double flow = 0.8;
  double handsOff_s = 10.0;
  std::string source;
};

/// The untwisting of a hollow organ, as a scene file states it.
struct Detorsion {
  HollowWall wall;
  std::vector<WrungSpan> spans;           ///< one, or two limbs that are wrung alike
  double cordStiffness_Nm_per_rad = 0.0;  ///< of a solid cord, in place of a wall
  InitialTwist start;
  PerfusionParameters vessels;
  BaseFriction base;
  DetorsionLimits limits;
  TurnStages stages;        ///< in which it is to be undone
  double timeScale = 60.0;  ///< seconds of the tissue for a second of the hand
  std::string briefing;     ///< what is twisted, what surgeons do, what harms; empty: nothing is said
  std::string validity;     ///< in plain words: what of this is measured, sourced, assumed
};

/// A hollow organ that came twisted: its mobile part turns as a whole, the spans beside it are wrung
/// (docs/model.md U). Immutable after construction; queries are noexcept and allocate nothing unless they
/// say otherwise. Those of the tick use + - * / and roots only.
class HollowOrgan {
 public:
  struct Parts {
    const SectionLattice* lattice = nullptr;  ///< needed by the constructor only
    double shearModulus_Pa = 0.0;
    double graspArc = 0.5;  ///< where the pattern grips, as a fraction of the length
    Detorsion detorsion;
    std::span<const Vec3> vertices_m{};       ///< of the mesh that is moved; needed by the constructor only
    const SurfacePatches* patches = nullptr;  ///< of that mesh, for reach(); needed by the constructor only
  };
  /// Solves the tables of the spans, each in a thread, one that is like another only once; at most 1 s.
  /// Throws Error{kBadParameter} for a wall or a vessel out of range, or a grasp off the mobile part.
  explicit HollowOrgan(const Parts& parts);
  /// Lets the organ be turned as a rod, made with twistLaws(): its sections lie where the rod has them, the
  /// turn is that of the gripped section about the line of the rod's task, and a span is wrung by what the
  /// rod twists there. Throws as HollowSwing. Before the first query.
  void swingOn(std::shared_ptr<const RodOrgan> rod);
  /// Returns the torque of each span against its own twist at the pressure with which a trial begins.
  [[nodiscard]] std::vector<TwistLaw> twistLaws() const;
  /// Returns the wall as the rod takes it, nowhere thicker than leaves a tube; empty of a cord.
  [[nodiscard]] WallMap wallMap(const SectionLattice& lattice) const;
  /// Returns how the organ swings as a rod; null where its spans alone are wrung.
  [[nodiscard]] const HollowSwing* swing() const noexcept { return swing_.get(); }
  /// Returns the curve that the surface is drawn from, of an organ that swings: with the widths of its wall.
  /// In the tick.
  [[nodiscard]] RodCurve curveOf(const OrganState& state) const noexcept;
  /// Puts the pose of an organ that swings to its angle; leaves another as it is. In the tick.
  void lay(OrganState& state) const noexcept;
  /// Returns an angle as far as the organ can be turned. In the tick.
  [[nodiscard]] double within_rad(double angle_rad) const noexcept {
    return swing_ ? swing_->within_rad(angle_rad) : angle_rad;
  }
  /// Returns by how much a span is wrung at an angle of the mobile part. In the tick.
  [[nodiscard]] double wrungBy_rad(int span, double angle_rad) const noexcept {
    return swing_ ? swing_->at(angle_rad).twist_rad[static_cast<std::size_t>(span)] : angle_rad;
  }

  [[nodiscard]] const Detorsion& detorsion() const noexcept { return detorsion_; }
  [[nodiscard]] const Perfusion& vessels() const noexcept { return vessels_; }
  /// Returns how the organ lies at the start of a trial with this seed: turned by an angle drawn from its
  /// range, the other way in the opposite share of trials, and short of blood for as long as it has lain so.
  [[nodiscard]] OrganState start(std::uint64_t seed) const;
  /// Returns how the organ lies when it is turned by an angle and nothing has changed yet; flow has settled.
  [[nodiscard]] OrganState stateAt(double angle_rad) const noexcept;
  /// Returns the torque that holds the mobile part against the wrung spans alone, N m. In the tick.
  [[nodiscard]] double torque_Nm(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns the slope of that torque, N m/rad: negative beyond the peak. In the tick.
  [[nodiscard]] double slope_Nm_per_rad(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns the energy that the spans give while the mobile part turns back to rest, J: the integral of the
  /// torque, by 64 trapezia.
  [[nodiscard]] double storedEnergy_J(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns the largest torque on the way to closing, N m; of a cord that of its largest twist.
  [[nodiscard]] double peakTorque_Nm(double pressure_Pa) const noexcept;
  /// Returns the peak torque at the pressure with which a trial begins, N m: what the friction of the base
  /// and the torque of relapse are shares of. In the tick.
  [[nodiscard]] double basePeak_Nm() const noexcept { return basePeak_Nm_; }
  /// Returns pressure times volume, J, of a gas at a pressure over outside inside the spans and the mobile
  /// part, outside's pressure counted; 0 unless the content is sealed gas. In the tick.
  [[nodiscard]] double gas_J(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns the pressure over outside, Pa, at which this amount of gas fills the organ at an angle: between
  /// 0 and the highest of the table, within 1e-6 of that. 20 queries; in the tick.
  [[nodiscard]] double sealedPressure_Pa(double angle_rad, double gas_J) const noexcept;
  /// Returns the free cross-section of the narrowest place. In the tick.
  [[nodiscard]] double patency(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns the mean radius of the wall at the narrowest place, m; 0 of a cord.
  [[nodiscard]] double waist_m(double angle_rad, double pressure_Pa) const noexcept;
  /// Returns the angles at which folds begin and at which the narrowest place is closed; infinite of a cord.
  /// onset_rad allocates.
  [[nodiscard]] double onset_rad(double pressure_Pa) const;
  [[nodiscard]] double closing_rad(double pressure_Pa) const noexcept;
  /// Returns the least angle, by whole degrees from closing_rad on, at which no more than kShutPatency is
  /// left open: a thick wall is squeezed to its packed radius before it shuts. Infinite of a cord.
  [[nodiscard]] double shut_rad(double pressure_Pa) const noexcept;
  /// Says where a section of the organ lies.
  struct Place {
    int span = -1;       ///< -1: in the mobile part
    double share = 1.0;  ///< of the span: 0 held to 1 mobile; 0 beyond the held section
  };
  [[nodiscard]] Place placeOf(double arc_m) const noexcept;
  /// Says how far a section is turned.
  struct Section {
    double turn_rad = 0.0;
    double radius = 1.0;  ///< mean, against rest
  };
  /// Returns how a section lies at a share of a span, 0 held to 1 mobile. In the tick.
  [[nodiscard]] Section sectionIn(int span, double share, const OrganState& state) const noexcept;
  static constexpr std::size_t kPlaces = WrungOrgan::kPlaces;
  /// How the sections of a span lie at equal shares, from the held one, which lies at rest, to the mobile
  /// part.
  using Sections = std::array<Section, kPlaces>;
  /// Writes the sections of a span. Limbs that are wound round each other share their turn out along their
  /// height, and are drawn together, so that they do not run through each other. In the tick.
  void sectionsOf(int span, const OrganState& state, Sections& sections) const noexcept;
  /// Writes the sections of a span and how its wall lies there; of a cord `walls` stays. In the tick.
  void sectionsOf(int span, const OrganState& state, Sections& sections,
                  WrungOrgan::Profile& walls) const noexcept;
  /// Does so with sections that lie as those of a limb alone. In the tick.
  void wind(Sections& sections) const noexcept;
  /// Returns how free the wall is to change its radius at each place: 0 at the ends of a span to 1.
  [[nodiscard]] const std::array<double, kPlaces>& freedom() const noexcept { return free_; }
  /// Returns how the section at an arc length lies. In the tick.
  [[nodiscard]] Section sectionAt(double arc_m, const OrganState& state) const noexcept;
  /// Returns the place whose turn and shrinking a point has, at rest or as it lies: that of its arc length;
  /// of limbs that are wound round each other that of its height along the line, which winding keeps. So no
  /// two of its points meet. In the tick.
  [[nodiscard]] Place turningPlace(double arc_m, const Vec3& point_m) const noexcept;
  /// What a fold adds to a point of a section.
  struct Fold {
    double turn_rad = 0.0;  ///< with the section; of wound limbs about the section's own axis
    double radius = 1.0;    ///< about the section's own axis
  };
  /// Returns where a point of a section goes (docs/model.md H.8). The mobile part turns rigidly about
  /// line(). A section of a span shrinks and turns about its own axis, whose direction goes over into that of
  /// the line towards the mobile end; where the organ is a loop whose limbs stand side by side, both shrink
  /// and turn about the line, wound round each other. `own`: the section's own axis; `place`, `section`: of
  /// turningPlace(). In the tick.
  [[nodiscard]] Vec3 moved(const Vec3& rest_m, const TwistLine& own, const Place& place,
                           const Section& section, const Fold& fold) const noexcept;
  /// Returns the line that a section at a place turns about; `own`: its own axis. In the tick.
  [[nodiscard]] TwistLine lineOf(const TwistLine& own, const Place& place) const noexcept;
  /// Returns the point that moved() without a fold takes to this one. In the tick.
  [[nodiscard]] Vec3 movedBack(const Vec3& deformed_m, const TwistLine& own, const Place& place,
                               const Section& section) const noexcept;
  /// Returns the vertices of the mesh, each with the section that it belongs to: that of the foot of its
  /// perpendicular on the centreline. Sections of the lattice are neither plane nor upright: turned unlike
  /// their neighbours they would run through one another.
  [[nodiscard]] const std::vector<TwistVertex>& vertices() const noexcept { return vertices_; }
  /// Returns how far the pieces of the mesh's surface reach; empty without patches.
  [[nodiscard]] const HollowReach& reach() const noexcept { return reach_; }
  /// Returns the line that the mobile part turns about: of two spans of a tube that runs on through it the
  /// chord between their mobile ends; of a loop's limbs that stand side by side from between their held to
  /// between their mobile ends; of one span its axis at its mobile end, or that of a stalk with a limb beside
  /// it.
  [[nodiscard]] const TwistLine& line() const noexcept { return line_; }
  /// Returns that line as the axis of a grip: its centre beside a point, e1 towards it.
  [[nodiscard]] AxisFrame graspFrame(const Vec3& held_m) const noexcept;
  /// Tells whether the two limbs are wound round each other, or a limb round its stalk.
  [[nodiscard]] bool wound() const noexcept { return wound_; }
  /// Returns the shear stress of the wall at an arc length, Pa: torque of its span over 2 pi r^2 t; 0 in the
  /// mobile part, beyond the held sections and of a cord.
  [[nodiscard]] double wallShear_Pa(double arc_m, const OrganState& state) const noexcept;
  /// Returns how fast a solid cord is twisted at an arc length, rad/m, positive; 0 elsewhere and of a wall.
  /// In the tick.
  [[nodiscard]] double cordTwist_rad_per_m(double arc_m, const OrganState& state) const noexcept;
  /// Returns the number of spans.
  [[nodiscard]] int spans() const noexcept { return static_cast<int>(detorsion_.spans.size()); }
  /// Returns the wrung tube of a span; null of a cord.
  [[nodiscard]] const WrungOrgan* tube(int span) const noexcept;
  /// Returns the wall of a span at equal shares, from the held section; empty of a cord.
  [[nodiscard]] std::span<const WallPlace> wallOf(int span) const noexcept {
    const auto i = static_cast<std::size_t>(span);
    return i < limbs_.size() ? std::span<const WallPlace>(limbs_[i].wall) : std::span<const WallPlace>{};
  }
  [[nodiscard]] double shearModulus_Pa() const noexcept { return shear_Pa_; }
  /// Returns the organ's length, m.
  [[nodiscard]] double length_m() const noexcept { return length_m_; }

 private:
  static constexpr std::size_t kWallPlaces = 41;
  /// Wall of a span at equal shares, from the held section.
  struct Limb {
    std::shared_ptr<const WrungOrgan> tube;
    std::array<WallPlace, kWallPlaces> wall{};
  };
  void solveLimbs(const Parts& parts);
  [[nodiscard]] double whenWrungBy_rad(int span, double twist_rad) const noexcept;
  void fillMobilePart(const Parts& parts);
  [[nodiscard]] double volume_m3(double angle_rad, double pressure_Pa) const noexcept;
  void drawLine(const SectionLattice& lattice);
  [[nodiscard]] double freeShareOf(double share) const noexcept;
  void measureHeights(const SectionLattice& lattice);
  void measureRoom(const SectionLattice& lattice);

  Detorsion detorsion_;
  Perfusion vessels_;
  std::vector<Limb> limbs_;  // none: a cord
  std::shared_ptr<const HollowSwing> swing_;
  double shear_Pa_ = 0.0;
  double length_m_ = 0.0;
  double graspArc_m_ = 0.0;
  double basePeak_Nm_ = 0.0;
  // Of the mobile part, m^3: at equal steps of the pressure, from 0 to the highest of the table.
  static constexpr std::size_t kGasPressures = 33;
  std::array<double, kGasPressures> mobileVolume_m3_{};
  double highestPressure_Pa_ = 0.0;
  TwistLine line_;
  bool wound_ = false;
  std::vector<TwistVertex> vertices_;
  HollowReach reach_;
  std::array<double, kPlaces> free_{};           // freeShareOf at equal shares
  std::array<double, kPlaces - 1> room_rad_{};   // between equal shares, of limbs at their distance at rest
  std::array<Vec3, 2> ends_{};                   // tangents at the mobile ends
  std::array<double, kWallPlaces> heights_m_{};  // along the line, of limbs wound round each other
};

}  // namespace torsio
