// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/pattern_judgement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <future>
#include <iterator>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/scene/grasp_point.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace {

constexpr int kSteps = 8;     // on the way to the target
constexpr int kFewSteps = 2;  // of a fine surface: a step takes as long as it has triangles
constexpr double kFineTriangles = 30'000.0;
constexpr int kHalvings = 4;  // of the step in which it breaks
constexpr double kEarly_rad = radians(60.1);
// A wall folds by design, and contents escape: not inside out, half its volume left; crossings: a share of
// the triangles, where folds touch.
constexpr FoldLimits kHollowLimits{
    .leastDeterminant = 1e-3, .mostCrossings = 2e-3, .leastVolume = 0.5, .mostVolume = 1.25};

int stepsFor(std::size_t triangles) {
  const double share = kFineTriangles / static_cast<double>(std::max<std::size_t>(triangles, 1));
  return std::clamp(static_cast<int>(kSteps * share), kFewSteps, kSteps);
}

/// Steps of a turn that is judged, on and on until it breaks.
class Turning {
 public:
  Turning(const Scene& scene, PatternJudgement& judgement)
      : scene_(scene), check_(scene.mesh, scene.lattice()), judgement_(judgement) {}

  /// Turns from rest to an angle; tells whether the organ stays whole.
  bool to(double target_rad, const std::function<OrganState(double)>& stateAt) {
    double whole_rad = 0.0;
    const int steps = stepsFor(scene_.mesh.triangles.size());
    for (int step = 1; step <= steps; ++step) {
      const double angle_rad = target_rad * step / steps;
      if (!stays(angle_rad, stateAt)) {
        judgement_.brokenAt_rad = firstBroken_rad(whole_rad, angle_rad, stateAt);
        judgement_.wholeShare = whole_rad / target_rad;
        return false;
      }
      whole_rad = angle_rad;
    }
    judgement_.wholeShare = 1.0;
    return true;
  }

 private:
  bool stays(double angle_rad, const std::function<OrganState(double)>& stateAt) {
    const FoldReport fold = foldOf(scene_, check_, stateAt(angle_rad));
    judgement_.leastDeterminant = std::min(judgement_.leastDeterminant, fold.minDeterminant);
    judgement_.crossings = std::max(judgement_.crossings, fold.crossings);
    if (std::abs(fold.volumeRatio - 1.0) > std::abs(judgement_.volumeRatio - 1.0)) {
      judgement_.volumeRatio = fold.volumeRatio;
    }
    if (std::abs(angle_rad) <= kEarly_rad) {
      judgement_.leastDeterminant60 = std::min(judgement_.leastDeterminant60, fold.minDeterminant);
    }
    BrokenLimit broken = brokenLimit(scene_, fold);
    judgement_.code = std::move(broken.code);
    judgement_.reason = std::move(broken.reason);
    return judgement_.code.empty();
  }

  double firstBroken_rad(double whole_rad, double broken_rad,
                         const std::function<OrganState(double)>& stateAt) const {
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double middle_rad = 0.5 * (whole_rad + broken_rad);
      const FoldReport fold = foldOf(scene_, check_, stateAt(middle_rad));
      (brokenLimit(scene_, fold).code.empty() ? whole_rad : broken_rad) = middle_rad;
    }
    return broken_rad;
  }

  const Scene& scene_;
  FoldCheck check_;
  PatternJudgement& judgement_;
};

/// Calls `use` with the map from a place at rest to where it lies.
template <typename Use>
auto withMap(const Scene& scene, const OrganState& state, const Use& use) {
  if (scene.hollow && scene.hollow->swing() != nullptr) {
    const RodCurve curve = scene.hollow->curveOf(state);
    const RodSkin& skin = scene.hollow->swing()->rod().skin();
    return use([&](const Vec3& rest_m) { return skin.toDeformed_m(rest_m, curve); });
  }
  if (scene.hollow) {
    const HollowMap map(scene.lattice(), *scene.hollow, state);
    return use([&map](const Vec3& rest_m) { return map.forward(rest_m); });
  }
  if (scene.rod && state.pose.count > 0) {
    const RodCurve curve = scene.rod->skin().curveOf(state.pose);
    return use([&](const Vec3& rest_m) { return scene.rod->skin().toDeformed_m(rest_m, curve); });
  }
  return use([&](const Vec3& rest_m) { return scene.toDeformed_m(rest_m, state); });
}

/// How a surface of the organ lies half as far as the organ stays whole, and there.
std::vector<TurnedShape> shapesOf(const Scene& scene, const PatternJudgement& judgement,
                                  const TriangleMesh& drawn) {
  double whole_rad = judgement.wholeShare * scene.pattern.targetAngle_rad;
  if (scene.hollow) {
    const InitialTwist& start = scene.hollow->detorsion().start;
    whole_rad = judgement.wholeShare * start.sign * start.most_rad;
  }
  std::vector<TurnedShape> shapes;
  for (const double angle_rad : {0.5 * whole_rad, whole_rad}) {
    TurnedShape shape{angle_rad, {}};
    withMap(scene, scene.stateAt(angle_rad), [&](const auto& map) {
      std::transform(drawn.vertices_m.begin(), drawn.vertices_m.end(), std::back_inserter(shape.places_m),
                     map);
    });
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

double valueOf(const PatternJudgement& pattern) {
  return pattern.code == "M23"   ? pattern.leastDeterminant
         : pattern.code == "M24" ? static_cast<double>(pattern.crossings)
         : pattern.code == "M26" ? pattern.volumeRatio
                                 : degrees(pattern.brokenAt_rad.value_or(0.0));
}

Text brokenWords(const PatternJudgement& pattern) {
  return pattern.brokenAt_rad && pattern.code != "M27"
             ? Text::tr("%1 breaks at %2 degrees: %3", pattern.id,
                        shortNumber(degrees(*pattern.brokenAt_rad)), pattern.reason)
             : Text::verbatim("%1: %2", pattern.id, pattern.reason);
}

/// All twists with which a hollow organ may come.
void judgeHollow(const Scene& scene, PatternJudgement& judgement) {
  const InitialTwist& start = scene.hollow->detorsion().start;
  const auto stateAt = [&scene](double angle_rad) { return scene.stateAt(angle_rad); };
  Turning turning(scene, judgement);
  judgement.accepted = turning.to(start.sign * start.most_rad, stateAt) &&
                       (start.oppositeShare <= 0.0 || turning.to(-start.sign * start.most_rad, stateAt));
}

void judgeTurn(const Scene& scene, PatternJudgement& judgement) {
  const double target_rad = scene.pattern.targetAngle_rad;
  const bool ends = scene.rod && !reaches(scene.rod->path(), target_rad);
  const double last_rad = ends ? scene.rod->path().back().angle_rad : target_rad;
  const bool back = last_rad * target_rad < 0.0;
  if (last_rad != 0.0 && !back) {
    judgement.accepted = Turning(scene, judgement).to(last_rad, [&scene](double angle_rad) {
      return scene.stateAt(angle_rad);
    });
    judgement.wholeShare *= last_rad / target_rad;
  }
  if (ends && judgement.code.empty()) {
    judgement.accepted = false;
    judgement.code = "M27";
    judgement.reason = turnEndsAt(last_rad, scene.rod->pathEnd());
    judgement.brokenAt_rad = last_rad;
  }
}

/// The scene of a pattern; none if it cannot be built, which `judgement` then says. `same`: of the same
/// organ.
std::optional<Scene> builtFor(const std::filesystem::path& assets, const OrganFile& organ,
                              PatternJudgement& judgement, const Scene* same) {
  SceneRequest request;
  request.assets = assets;
  request.organFile = std::filesystem::path(organ.source.empty() ? "organ" : organ.source);
  request.pattern = judgement.id;
  try {
    return sceneOfOrgan(request, organ, same);
  } catch (const Error& refusal) {
    judgement.code = "M27";
    judgement.reason = refusal.happenedText();
    return std::nullopt;
  }
}

}  // namespace

FoldReport foldOf(const Scene& scene, const FoldCheck& check, const OrganState& state) {
  std::vector<Vec3> turned = scene.mesh.vertices_m;
  scene.deform(state, turned);
  return withMap(scene, state, [&](const auto& map) { return check.judge(turned, map); });
}

BrokenLimit brokenLimit(const Scene& scene, const FoldReport& fold) {
  static constexpr std::array kCodes{"", "M23", "M24", "M26"};  // of FoldLimit
  FoldLimits limits;
  if (scene.hollow) {
    limits = kHollowLimits;
    limits.mostCrossings *= static_cast<double>(scene.mesh.triangles.size());
  }
  return {kCodes.at(static_cast<std::size_t>(fold.passed(limits))), fold.reason(limits)};
}

Text turnEndsAt(double angle_rad, TurnEnd end) {
  const std::string at_deg = shortNumber(degrees(angle_rad));
  switch (end) {
    case TurnEnd::kFolds:
      if (angle_rad == 0.0) {
        return Text::tr("it bends so sharply at rest that any turn folds it");
      }
      return Text::tr("the turn ends at %1 degrees: beyond it the organ folds", at_deg);
    case TurnEnd::kSlipsBack:
      return Text::tr("the turn ends at %1 degrees: beyond it a part of the organ slips back by a whole turn",
                      at_deg);
    case TurnEnd::kHandAlone:
      return Text::tr("the turn ends at %1 degrees: beyond it the hand turns without the organ", at_deg);
    case TurnEnd::kNoBalance:
    case TurnEnd::kThere:
      break;
  }
  return Text::tr("the turn ends at %1 degrees: beyond it the organ finds no balance", at_deg);
}

PatternJudgement judgePattern(const Scene& scene, const TriangleMesh* drawn) {
  PatternJudgement judgement;
  judgement.id = scene.pattern.id;
  if (!graspPoint(scene)) {
    judgement.code = "M27";
    judgement.reason = Text::tr("no instrument reaches the section that the pattern grips");
    return judgement;
  }
  scene.hollow ? judgeHollow(scene, judgement) : judgeTurn(scene, judgement);
  if (drawn != nullptr) {
    judgement.shapes = shapesOf(scene, judgement, *drawn);
  }
  return judgement;
}

std::vector<PatternJudgement> judgePatterns(const std::filesystem::path& assets, const OrganFile& organ,
                                            std::size_t most, const TriangleMesh* drawn) {
  std::vector<std::string> ids = patternIds(assets, organ.anatomy.empty() ? kOwnOrganScene : organ.anatomy);
  ids.resize(std::min(ids.size(), most));
  std::vector<PatternJudgement> judgements(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    judgements[i].id = ids[i];
  }
  const std::optional<Scene> first =
      judgements.empty() ? std::nullopt : builtFor(assets, organ, judgements[0], nullptr);
  const auto everySecond = [&](std::size_t from) {
    for (std::size_t i = from; i < ids.size(); i += 2) {
      if (i == 0 && first) {
        judgements[i] = judgePattern(*first, drawn);
      } else if (i > 0) {
        const std::optional<Scene> scene = builtFor(assets, organ, judgements[i], first ? &*first : nullptr);
        judgements[i] = scene ? judgePattern(*scene, drawn) : judgements[i];
      }
    }
  };
  std::future<void> others = std::async(std::launch::async, everySecond, 1);
  everySecond(0);
  others.get();
  return judgements;
}

std::vector<std::string> acceptedAmong(const std::vector<PatternJudgement>& patterns) {
  std::vector<std::string> ids;
  for (const PatternJudgement& one : patterns) {
    if (one.accepted) {
      ids.push_back(one.id);
    }
  }
  return ids;
}

OrganFinding brokenFinding(const PatternJudgement& pattern) {
  return {pattern.code,         FindingWeight::kRefusal,
          brokenWords(pattern), Text::tr("the whole organ"),
          valueOf(pattern),     Text::tr("Name the ends of the organ, or take a part of it that bends less")};
}

void replaceBroken(const std::vector<PatternJudgement>& patterns, std::vector<OrganFinding>& findings) {
  std::erase_if(findings, [](const OrganFinding& one) {
    return one.code == "M23" || one.code == "M24" || one.code == "M26" || one.code == "M27";
  });
  const bool none = acceptedAmong(patterns).empty();
  const auto best = std::max_element(
      patterns.begin(), patterns.end(),
      [](const PatternJudgement& a, const PatternJudgement& b) { return a.wholeShare < b.wholeShare; });
  for (auto one = patterns.begin(); one != patterns.end(); ++one) {
    if (one->accepted) {
      continue;
    }
    OrganFinding finding = brokenFinding(*one);
    if (none && one == best) {
      finding.what = Text::tr("no pattern leaves the organ whole; %1", finding.what);
    } else {
      finding.weight = FindingWeight::kNote;
      finding.what = Text::tr("a pattern is left out; %1", finding.what);
      finding.remedy = Text();
    }
    findings.push_back(std::move(finding));
  }
}

}  // namespace torsio
