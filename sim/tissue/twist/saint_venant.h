// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/tissue/twist/kriging.h"

namespace torsio {

/// A value and its derivative.
struct ValueSlope {
  double value = 0.0;
  double slope = 0.0;
};

/// A smooth function on equally spaced nodes: cubic Hermite pieces, continuous with its derivative, the node
/// values exact. The look-up is noexcept, allocates nothing and uses + - * / only: it serves the servo tick.
class HermiteTable {
 public:
  HermiteTable() = default;
  /// Makes the function from `values`: at least 2, at first, first + step ... `monotone`: slopes are
  /// limited so that rising or falling values are never overshot (Fritsch and Carlson 1980).
  HermiteTable(double first, double step, std::vector<double> values, bool monotone);

  /// Returns value and slope at x; outside the nodes the nearer end value and slope 0.
  [[nodiscard]] ValueSlope at(double x) const noexcept;
  [[nodiscard]] double value(double x) const noexcept { return at(x).value; }

  [[nodiscard]] double first() const noexcept { return first_; }
  [[nodiscard]] double step() const noexcept { return step_; }
  [[nodiscard]] int nodes() const noexcept { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] double node(int index) const { return nodes_[static_cast<std::size_t>(index)].value; }

 private:
  void limitSlopes();

  double first_ = 0.0;
  double step_ = 1.0;
  double inverseStep_ = 1.0;
  std::vector<ValueSlope> nodes_;  // slope per step
};

/// How the ends of the organ are held.
enum class EndCondition {
  kClampedFree,  ///< fixed at s = 0, free at s = length: the arm
  kBothHeld,     ///< fixed at both ends: the stomach between cardia and pylorus
};

/// Properties of one section that Saint-Venant's torsion needs (section_solver.h), about its centroid.
struct TorsionSection {
  double torsionConstant_m4 = 0.0;  ///< J
  double polarMoment_m4 = 0.0;      ///< Ip >= J, equal for a circle
  double area_m2 = 0.0;
};

class HeldWarping;

/// Corrections to 1 / (G J), all off unless asked for.
struct TorsionCorrections {
  /// Whether 1 / (G J) is multiplied by 1 + (2/3) r'^2, r the radius of the circle of equal area: the mean
  /// turn of a flat section of an exact cone (1.0206 against 1.0207 at 10 degrees half-angle).
  bool taper = false;
  /// Whether a held end keeps its section flat: sections warp as HeldWarping says, not at all there.
  bool restrainedEnds = false;
};

/// J, Ip, A along the organ from sections at `arcs_m`, kriged as lengths (J^(1/4), Ip^(1/4), A^(1/2)), which
/// are linear along a taper and therefore reproduced exactly there.
class SectionProfile {
 public:
  /// Makes the profile; `arcs_m` strictly increasing, one a section, at least 2. Throws
  /// Error{kBadParameter} for a section whose J or area is not positive.
  SectionProfile(std::span<const double> arcs_m, std::span<const TorsionSection> sections,
                 const KrigingOptions& kriging);

  [[nodiscard]] TorsionSection at(double arc_m) const;
  /// Returns the radius of the circle of equal area.
  [[nodiscard]] double radius_m(double arc_m) const;

 private:
  Kriging1d kriging_;
  std::vector<double> torsionLength_;
  std::vector<double> polarLength_;
  std::vector<double> areaLength_;
  double smallest_ = 0.0;
};

/// Returns the factor of TorsionCorrections::taper at an arc length, from the profile within half a step to
/// either side.
[[nodiscard]] double taperCompliance(const SectionProfile& profile, double arc_m, double length_m,
                                     double step_m);

/// Computes the compliance coordinate C(s_j) = integral from 0 to s_j of ds / (G J), rad/(N m), at places
/// s_j = j length / (places - 1), by Gauss's rule on the profile: exact to 1e-9 for tapers, whatever the
/// number of places. `taper`: see TorsionCorrections; `held`: how held ends keep the sections from warping,
/// null: they do not. Throws Error{kBadParameter}: G or length not positive and finite.
[[nodiscard]] std::vector<double> sectionCompliances(const SectionProfile& profile, int places,
                                                     double length_m, double shearModulus_Pa,
                                                     bool taper = false, const HeldWarping* held = nullptr);

/// Computes what the paper's formulation interpolates between the sections: kriged from the M values onto a
/// fine grid of nodes that contains the sections, at least 257 nodes.
[[nodiscard]] std::vector<double> krigedNodes(std::span<const double> atSections, double length_m,
                                              const KrigingOptions& kriging);
/// Returns the number of nodes of krigedNodes for M sections.
[[nodiscard]] int fineNodes(int sections) noexcept;

/// Green's function of the bar: the angle at x when the section at g is turned, as a share of the angle at g.
/// One factor rises from the fixed end, one falls to the other end: share = A(x)/A(g) up to g and B(x)/B(g)
/// beyond it. Clamped-free: A = C, B = 1, so that the angle is T min(C(x), C(g)), exact at the kink. Both
/// ends held: B = 1 - C / C(end). On an elastic foundation (G J phi')' = k phi, A and B are the two solutions
/// of the tridiagonal system on the nodes, factored once.
class TorsionTable {
 public:
  /// An arc length with both factors there.
  struct Place {
    double arc_m = 0.0;
    ValueSlope rising;   ///< A
    ValueSlope falling;  ///< B
  };
  struct Foundation {
    double length_m = 0.0;  ///< sqrt(G J / k) with the mean G J; 0: none
  };

  TorsionTable() = default;
  /// Makes the table. `compliance`: at equally spaced nodes from `first` on, not falling, with some rise.
  /// `paperAngles`: values are H theta of the paper, which need not rise; sections beyond the grasp follow
  /// it rigidly.
  TorsionTable(double first, double step, std::vector<double> compliance, EndCondition ends,
               const Foundation& foundation, bool paperAngles = false);

  /// Returns phi(g) for 1 N m at g: A(g) B(g), rad/(N m). `g` is kept off the held ends (kHeldMargin).
  [[nodiscard]] double compliance(double g) const noexcept;
  /// Returns the share phi(x) / phi(g) and its derivative with x (one-sided from the fixed end at g
  /// itself).
  [[nodiscard]] ValueSlope share(double x, double g) const noexcept;
  /// Returns the share phi(x) / phi(g) with its slope blended over `width` about g, so that quantities that
  /// follow the slope do not jump there.
  [[nodiscard]] ValueSlope blendedShare(double x, double g, double width) const noexcept;
  /// Returns the factors at x.
  [[nodiscard]] Place placeAt(double x) const noexcept { return {x, rising_.at(x), falling_.at(x)}; }
  /// Returns the value of share() at a place that is known, for a grasp at graspAt(g).
  [[nodiscard]] static double shareOf(const Place& x, const Place& grasp) noexcept {
    return x.arc_m <= grasp.arc_m ? x.rising.value / grasp.rising.value
                                  : x.falling.value / grasp.falling.value;
  }
  /// Returns the slope of blendedShare() at a place that is known, for a grasp at graspAt(g).
  [[nodiscard]] static double blendedSlopeOf(const Place& x, const Place& grasp, double width) noexcept;
  /// Returns the factor A(x).
  [[nodiscard]] ValueSlope rising(double x) const noexcept { return rising_.at(x); }
  /// Returns the factor B(x).
  [[nodiscard]] ValueSlope falling(double x) const noexcept { return falling_.at(x); }
  /// Returns where a grasp at `g` acts: off the held ends.
  [[nodiscard]] double graspAt(double g) const noexcept;
  /// Tells whether A = C and B is linear in C, as the fast view kernels assume.
  [[nodiscard]] bool plain() const noexcept { return plain_; }
  [[nodiscard]] EndCondition ends() const noexcept { return ends_; }

  /// Share of the length by which a grasp on a held end is moved inside, because there it would need an
  /// infinite torque.
  static constexpr double kHeldMargin = 0.005;

 private:
  HermiteTable rising_;
  HermiteTable falling_;
  EndCondition ends_ = EndCondition::kClampedFree;
  double lowestGrasp_ = 0.0;
  double highestGrasp_ = 0.0;
  bool plain_ = true;
};

}  // namespace torsio
