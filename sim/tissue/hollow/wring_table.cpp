// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/wring_table.h"

#include <algorithm>
#include <cmath>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/tissue/hollow/tube_onset.h"

namespace torsio {

namespace {

constexpr double kPacked = 1.02;     // of the packed radius: closed
constexpr double kRateStep = 0.03;   // R dphi/dz of a step on the way
constexpr double kFirstSteps = 6.0;  // on the way to the onset
constexpr double kMaxRate = 4.0;     // R dphi/dz at which a tube that has not closed is given up
constexpr double kLeastPressure = 0.0;
constexpr double kJump = 0.8;  // of the packed radius, within one step
constexpr int kJumpHalvings = 4;
constexpr double kLatestOnset = 0.995;  // of the closing angle
constexpr double kOnsetOfNone = 0.5;    // of the closing angle, of a wall that closes without folding

struct Mean {
  double radius = 0.0;
  double thickness = 0.0;
};

Mean meanOf(const TubeWall& wall) {
  Mean mean;
  const double share = 1.0 / static_cast<double>(wall.radius.size());
  for (std::size_t i = 0; i < wall.radius.size(); ++i) {
    mean.radius += share * wall.radius[i];
    mean.thickness += share * wall.thickness[i];
  }
  return mean;
}

TubePlace placeOf(const TubeWall& wall, double pressure) {
  const Mean mean = meanOf(wall);
  return {mean.thickness / mean.radius, wall.length / mean.radius, pressure * mean.radius / mean.thickness,
          wall.gentLimit};
}

// How far the narrowest node is from packed, over its packed radius.
double openness(const WrungTube& tube, const WrungShape& shape) {
  double least = 1e9;
  for (std::size_t i = 1; i + 1 < shape.nodes.size(); ++i) {
    least = std::min(least, shape.nodes[i].r / tube.packedRadius(i));
  }
  return least - kPacked;
}

WrungState between(const WrungState& a, const WrungState& b, double share) noexcept {
  const auto mix = [share](double from, double to) { return from + share * (to - from); };
  return {mix(a.torque, b.torque),   mix(a.waist, b.waist),   mix(a.waistPlace, b.waistPlace),
          mix(a.patency, b.patency), mix(a.volume, b.volume), mix(a.length, b.length)};
}

WrungPlace between(const WrungPlace& a, const WrungPlace& b, double share) noexcept {
  const auto mix = [share](double from, double to) { return from + share * (to - from); };
  return {mix(a.radius, b.radius), mix(a.turn, b.turn), mix(a.shift, b.shift), mix(a.slack, b.slack),
          mix(a.foldTurn, b.foldTurn)};
}

// Tangent of the angle from the axis, in the unloaded wall, of the larger stretch of an element: folds run
// along it.
double foldSlope(const TubeWall& wall, const WrungShape& shape, std::size_t element) noexcept {
  const WrungShape::Node& from = shape.nodes[element];
  const WrungShape::Node& to = shape.nodes[element + 1];
  const double h = wall.length / static_cast<double>(shape.nodes.size() - 1);
  const double full = 0.5 * (wall.radius[element] + wall.radius[element + 1]);
  const double r = 0.5 * (from.r + to.r);
  const double along = (to.r - from.r) / h;
  const double forth = (to.z - from.z) / h;
  const double round = r * (to.turn_rad - from.turn_rad) / h;
  const double a = along * along + round * round + forth * forth;
  const double b = round * r / full;
  const double c = r * r / (full * full);
  const double root = std::sqrt((a - c) * (a - c) + 4.0 * b * b);
  return root + a - c > 1e-9 ? 2.0 * b / (root + a - c) : 0.0;
}

// The places of a solved tube. `fullest`: radius at the onset of the folds, empty before it.
std::vector<WrungPlace> placesOf(const TubeWall& wall, const WrungShape& shape,
                                 const std::vector<double>& fullest) {
  const std::size_t count = shape.nodes.size();
  const double angle = shape.nodes.back().turn_rad;
  std::vector<WrungPlace> places(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double even = static_cast<double>(i) / static_cast<double>(count - 1);
    WrungPlace& place = places[i];
    place.radius = shape.nodes[i].r;
    place.turn = angle > 0.0 ? shape.nodes[i].turn_rad / angle : even;
    place.shift = shape.nodes[i].z;
    if (!fullest.empty()) {
      place.slack = std::min(place.radius / std::min(fullest[i], wall.radius[i]), 1.0);
    }
    if (i > 0) {
      const double full = 0.5 * (wall.radius[i - 1] + wall.radius[i]);
      place.foldTurn = places[i - 1].foldTurn +
                       foldSlope(wall, shape, i - 1) * wall.length / static_cast<double>(count - 1) / full;
    }
  }
  return places;
}

// Writes places at equal shares of the length between nodes; asks for each node once.
template <typename NodeAt>
void spreadOut(std::size_t nodes, std::span<WrungPlace> places, const NodeAt& nodeAt) noexcept {
  std::size_t node = 0;
  WrungPlace from = nodeAt(0);
  WrungPlace to = nodeAt(1);
  const double step =
      static_cast<double>(nodes - 1) / static_cast<double>(std::max<std::size_t>(places.size(), 2) - 1);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double along = std::min(static_cast<double>(i) * step, static_cast<double>(nodes - 1));
    for (; node + 2 < nodes && along >= static_cast<double>(node + 1); ++node) {
      from = to;
      to = nodeAt(node + 2);
    }
    places[i] = between(from, to, along - static_cast<double>(node));
  }
}

}  // namespace

WrungState wrungState(const TubeWall& wall, const WrungShape& shape, int waves) noexcept {
  WrungState state;
  state.torque = shape.torque;
  state.volume = shape.volume;
  state.length = shape.nodes.back().z;
  const double stiff = 0.5 * waves * waves - 1.0;
  double least = 1e9;
  for (std::size_t i = 1; i + 1 < shape.nodes.size(); ++i) {
    const double full = wall.radius[i];
    const double r = shape.nodes[i].r;
    const double packed = 2.0 * full * wall.thickness[i];
    const double fold = std::max((full / r) * (full / r) - 1.0, 0.0) / stiff;
    const double lumen = r * r * std::max(1.0 - 0.5 * fold, 0.0);
    state.patency = std::min(state.patency, std::max((lumen - packed) / (full * full - packed), 0.0));
    if (r / full < least) {
      least = r / full;
      state.waist = r;
      state.waistPlace = shape.nodes[i].z / state.length;
    }
  }
  return state;
}

// The way of a tube from rest to beyond its closing, at one pressure.
struct WringTable::Path {
  struct Step {
    double angle = 0.0;
    WrungShape shape;
  };

  Path(const TubeWall& wall, double held, int waves) : tube(wall, waves), pressure(held) {
    const TubePlace place = placeOf(wall, pressure);
    goUntilClosed(kRateStep * place.slenderness,
                  std::min(kRateStep, foldOnset(place) / kFirstSteps) * place.slenderness,
                  kMaxRate * place.slenderness);
    if (steps.size() < 2) {  // let down from a high pressure a wall is thick and narrow
      refuseParameter(Text::verbatim("the wall leaves no tube before it is turned"), Text::verbatim("wall"),
                      Text::verbatim("Give less pressure, or a stiffer or a thinner wall."));
    }
    refineJump();
    readMarks();
  }

  void goUntilClosed(double step, double first, double most) {
    steps.push_back({0.0, tube.start()});
    tube.solve(0.0, pressure, steps.back().shape);
    while (openness(tube, steps.back().shape) > 0.0 && steps.back().angle < most) {
      const Step& before = steps.back();
      Step next{before.angle + (before.shape.folding > 0.0 ? step : first), before.shape};
      tube.solve(next.angle, pressure, next.shape);
      steps.push_back(std::move(next));
    }
  }

  // A tube under high pressure necks all at once when it begins to fold: the angle is brought nearer by
  // halving. On the way back it opens at a smaller angle; the table is that of the way there.
  void refineJump() {
    std::size_t jump = 0;
    for (std::size_t i = 1; i < steps.size(); ++i) {
      jump = drop(i) > kJump ? i : jump;
    }
    for (int k = 0; jump > 0 && k < kJumpHalvings; ++k) {
      Step middle{0.5 * (steps[jump - 1].angle + steps[jump].angle), steps[jump - 1].shape};
      tube.solve(middle.angle, pressure, middle.shape);
      steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(jump), std::move(middle));
      jump += drop(jump) > drop(jump + 1) ? 0 : 1;
    }
  }
  [[nodiscard]] double drop(std::size_t step) const {
    return openness(tube, steps[step - 1].shape) - openness(tube, steps[step].shape);
  }

  void readMarks() {
    closing = steps.back().angle;
    for (std::size_t i = steps.size(); i-- > 1;) {
      const Step& before = steps[i - 1];
      const Step& after = steps[i];
      if (openness(tube, after.shape) <= 0.0) {
        closing =
            crossing(before.angle, openness(tube, before.shape), after.angle, openness(tube, after.shape));
      }
      if (after.shape.folding >= 0.0) {
        onset = crossing(before.angle, before.shape.folding, after.angle, after.shape.folding);
      }
    }
    onset = onset > 0.0 ? std::min(onset, kLatestOnset * closing) : kOnsetOfNone * closing;
  }

  static double crossing(double from, double low, double to, double high) {
    return low == high ? to : from + (to - from) * low / (low - high);
  }

  // From the step before an angle; later steps follow in order, so that what is added stays sorted.
  [[nodiscard]] WrungShape at(double angle) {
    const auto after = std::upper_bound(steps.begin(), steps.end(), angle,
                                        [](double a, const Step& step) { return a < step.angle; });
    Step found{angle, std::prev(after)->shape};
    if (std::prev(after)->angle != angle) {
      tube.solve(angle, pressure, found.shape);
      steps.insert(after, found);
    }
    return found.shape;
  }

  WrungTube tube;
  double pressure;
  double onset = 0.0;
  double closing = 0.0;
  std::vector<Step> steps;
};

WringTable::Row WringTable::solvedRow(const TubeWall& wall, double pressure) {
  const int waves = foldWaves(placeOf(wall, pressure));
  Path path(wall, pressure, waves);
  Row row;
  row.onset = path.onset;
  row.closing = path.closing;
  std::vector<double> fullest;
  for (int k = 0; k < kAngles; ++k) {
    double angle = path.onset * k / kBeforeFolds;
    if (k > kBeforeFolds) {
      const int folded = k - kBeforeFolds;
      const double share = folded <= kFolded ? static_cast<double>(folded) / kFolded
                                             : 1.0 + kBeyondClosing * (folded - kFolded) / kClosed;
      angle = path.onset + share * (path.closing - path.onset);
    }
    const WrungShape shape = path.at(angle);
    row.states[static_cast<std::size_t>(k)] = wrungState(wall, shape, waves);
    std::vector<WrungPlace> places = placesOf(wall, shape, fullest);
    if (k == kBeforeFolds) {
      for (const WrungPlace& place : places) {
        fullest.push_back(place.radius);
      }
    }
    row.places.insert(row.places.end(), places.begin(), places.end());
  }
  const std::size_t nodes = wall.radius.size();
  for (std::size_t i = 0; i < nodes; ++i) {  // at rest the turn is that of a small angle
    row.places[i].turn = row.places[nodes + i].turn;
  }
  for (std::size_t k = 1; k < row.states.size(); ++k) {  // a neck never opens on the way
    row.states[k].patency = std::min(row.states[k].patency, row.states[k - 1].patency);
  }
  return row;
}

WringTable::WringTable(const TubeWall& wall, double highest) : highest_(std::max(highest, kLeastPressure)) {
  const int count = highest_ > 0.0 ? kPressures : 1;
  for (int k = 0; k < count; ++k) {
    const double share = count > 1 ? static_cast<double>(k) / (count - 1) : 0.0;
    rows_.push_back(solvedRow(wall, highest_ * share * share));
  }
}

WringTable::Between WringTable::rowsAt(double pressure) const noexcept {
  if (rows_.size() == 1) {
    return {&rows_.front(), &rows_.front(), 0.0};
  }
  const double share = std::clamp(pressure / highest_, 0.0, 1.0);
  const int last = static_cast<int>(rows_.size()) - 1;
  const int k = std::min(static_cast<int>(std::sqrt(share) * last), last - 1);
  const double low = static_cast<double>(k) / last;
  const double high = static_cast<double>(k + 1) / last;
  const std::size_t at = static_cast<std::size_t>(k);
  return {&rows_[at], &rows_[at + 1], std::clamp((share - low * low) / (high * high - low * low), 0.0, 1.0)};
}

WringTable::Cell WringTable::cellAt(double angle_rad, double pressure) const noexcept {
  const Between rows = rowsAt(pressure);
  const double onset = rows.low->onset + rows.share * (rows.high->onset - rows.low->onset);
  const double closing = rows.low->closing + rows.share * (rows.high->closing - rows.low->closing);
  const double angle = std::abs(angle_rad);
  double u = kBeforeFolds * angle / onset;
  if (angle > onset) {
    const double share = (angle - onset) / (closing - onset);
    u = kBeforeFolds + (share <= 1.0 ? kFolded * share : kFolded + kClosed * (share - 1.0) / kBeyondClosing);
  }
  u = std::min(u, static_cast<double>(kAngles - 1));
  const int k = std::min(static_cast<int>(u), kAngles - 2);
  return {rows, static_cast<std::size_t>(k), u - k};
}

WrungState WringTable::at(double angle_rad, double pressure) const noexcept {
  const auto [rows, at, share] = cellAt(angle_rad, pressure);
  WrungState state = between(between(rows.low->states[at], rows.low->states[at + 1], share),
                             between(rows.high->states[at], rows.high->states[at + 1], share), rows.share);
  state.torque = angle_rad < 0.0 ? -state.torque : state.torque;
  return state;
}

double WringTable::torqueAt(double angle_rad, double pressure) const noexcept {
  const auto [rows, at, share] = cellAt(angle_rad, pressure);
  const auto mix = [](double from, double to, double part) { return from + part * (to - from); };
  const double torque =
      mix(mix(rows.low->states[at].torque, rows.low->states[at + 1].torque, share),
          mix(rows.high->states[at].torque, rows.high->states[at + 1].torque, share), rows.share);
  return angle_rad < 0.0 ? -torque : torque;
}

WrungPlace WringTable::placeAt(double share, double angle_rad, double pressure) const noexcept {
  const Cell cell = cellAt(angle_rad, pressure);
  const std::size_t nodes = cell.rows.low->places.size() / kAngles;
  const double along = std::clamp(share, 0.0, 1.0) * static_cast<double>(nodes - 1);
  const std::size_t node = std::min(static_cast<std::size_t>(along), nodes - 2);
  const auto in = [&](const Row& row, std::size_t angle) {
    const WrungPlace* place = row.places.data() + angle * nodes + node;
    return between(place[0], place[1], along - static_cast<double>(node));
  };
  WrungPlace place =
      between(between(in(*cell.rows.low, cell.angle), in(*cell.rows.low, cell.angle + 1), cell.share),
              between(in(*cell.rows.high, cell.angle), in(*cell.rows.high, cell.angle + 1), cell.share),
              cell.rows.share);
  place.foldTurn = angle_rad < 0.0 ? -place.foldTurn : place.foldTurn;
  return place;
}

void WringTable::placesAt(double angle_rad, double pressure, std::span<WrungPlace> places) const noexcept {
  const Cell cell = cellAt(angle_rad, pressure);
  const std::size_t nodes = cell.rows.low->places.size() / kAngles;
  const std::size_t begin = cell.angle * nodes;
  const WrungPlace* low = cell.rows.low->places.data() + begin;
  const WrungPlace* high = cell.rows.high->places.data() + begin;
  spreadOut(nodes, places, [&](std::size_t i) {
    return between(between(low[i], low[nodes + i], cell.share), between(high[i], high[nodes + i], cell.share),
                   cell.rows.share);
  });
  for (WrungPlace& place : places) {
    place.foldTurn = angle_rad < 0.0 ? -place.foldTurn : place.foldTurn;
  }
}

WringTable::Mix WringTable::mixAt(double angle_rad, double pressure) const noexcept {
  const Cell cell = cellAt(angle_rad, pressure);
  const auto solved = [&](const Row* row) {
    return static_cast<std::size_t>(row - rows_.data()) * kAngles + cell.angle;
  };
  const std::size_t low = solved(cell.rows.low);
  const std::size_t high = solved(cell.rows.high);
  const double highShare = cell.rows.share;
  const double lowShare = 1.0 - highShare;
  return {{low, low + 1, high, high + 1},
          {lowShare * (1.0 - cell.share), lowShare * cell.share, highShare * (1.0 - cell.share),
           highShare * cell.share}};
}

void WringTable::solvedPlaces(std::size_t solved, std::span<WrungPlace> places) const noexcept {
  const Row& row = rows_[solved / kAngles];
  const std::size_t nodes = row.places.size() / kAngles;
  const WrungPlace* first = row.places.data() + solved % kAngles * nodes;
  spreadOut(nodes, places, [first](std::size_t i) { return first[i]; });
}

double WringTable::taut_rad(double pressure) const noexcept {
  const Between rows = rowsAt(pressure);
  const auto taut = [](const Row& row) {
    return row.onset == kOnsetOfNone * row.closing ? row.closing : row.onset;
  };
  return taut(*rows.low) + rows.share * (taut(*rows.high) - taut(*rows.low));
}

double WringTable::closing_rad(double pressure) const noexcept {
  const Between rows = rowsAt(pressure);
  return rows.low->closing + rows.share * (rows.high->closing - rows.low->closing);
}

double WringTable::peakTorque(double pressure) const noexcept {
  const Between rows = rowsAt(pressure);
  double peak = 0.0;
  for (std::size_t k = 0; k <= kBeforeFolds + kFolded; ++k) {
    peak = std::max(peak, between(rows.low->states[k], rows.high->states[k], rows.share).torque);
  }
  return peak;
}

}  // namespace torsio
