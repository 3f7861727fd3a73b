// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/index_meaning.h"

namespace torsio {

std::optional<IndexMeaning> indexMeaning(std::string_view indexId) {
  if (indexId == "effectiveness") {
    return IndexMeaning{Text::tr("How well practising with this model prepares for twisting a real organ."),
                        Text::tr("teaches nothing or wrong habits"), Text::tr("useful beside other training"),
                        Text::tr("prepares as well as the real thing")};
  }
  if (indexId == "force_feedback") {
    return IndexMeaning{
        Text::tr("How far the force in the hand is what tissue would answer, in size and course."),
        Text::tr("no force, or one that misleads"), Text::tr("right in direction, not in size"),
        Text::tr("feels like tissue")};
  }
  if (indexId == "real_time") {
    return IndexMeaning{Text::tr("How promptly picture and force follow the hand."),
                        Text::tr("clearly behind the hand"), Text::tr("a delay that can be noticed"),
                        Text::tr("no delay to be noticed")};
  }
  if (indexId == "stability") {
    return IndexMeaning{Text::tr("Whether organ and force stay calm through grip, twist, hold and release."),
                        Text::tr("shakes, jumps or breaks off"), Text::tr("calm but for single moments"),
                        Text::tr("calm throughout")};
  }
  if (indexId == "deformation_efficiency") {
    return IndexMeaning{Text::tr("How quickly the shape of the organ follows a large or fast twist."),
                        Text::tr("the shape lags or stands still"), Text::tr("keeps up with slow twists"),
                        Text::tr("keeps up with every twist")};
  }
  if (indexId == "fidelity") {
    return IndexMeaning{Text::tr("How true the twisted shape is: where it turns, folds and gives way."),
                        Text::tr("no organ twists like that"), Text::tr("right as a whole, wrong in places"),
                        Text::tr("like the organ itself")};
  }
  if (indexId == "fluency") {
    return IndexMeaning{Text::tr("How evenly the picture moves."), Text::tr("stops and jumps"),
                        Text::tr("stutters now and then"), Text::tr("even throughout")};
  }
  if (indexId == "telepresence") {
    return IndexMeaning{Text::tr("How far one forgets the device and works on the organ itself."),
                        Text::tr("one steers a device"), Text::tr("at times one works on the organ"),
                        Text::tr("one works on the organ")};
  }
  if (indexId == "texture") {
    return IndexMeaning{
        Text::tr("How much the surface looks like living tissue: colour, gloss, grain, vessels."),
        Text::tr("like plastic"), Text::tr("tissue at a glance"), Text::tr("like living tissue")};
  }
  return std::nullopt;
}

}  // namespace torsio
