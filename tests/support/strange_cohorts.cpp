// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/strange_cohorts.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "tests/support/demonstration_cohort.h"

namespace torsio::testing {

CohortInputs soundCohort() {
  CohortInputs in = demonstrationCohort();
  in.demonstration = false;
  in.simulated.clear();
  in.allocation.method = Text::verbatim("complete permutation");
  in.allocation.replayed = true;
  in.equivalenceMargin = 0.5;
  const double planned[3][2] = {{40.0, 0.0}, {20.0, 20.0}, {0.0, 40.0}};
  for (std::size_t g = 0; g < 3; ++g) {
    in.groups[g].plannedVirtual_min = planned[g][0];
    in.groups[g].plannedReal_min = planned[g][1];
  }
  for (const CohortTrainee& trainee : in.trainees) {
    in.doses.push_back({trainee.code, planned[trainee.group][0], planned[trainee.group][1], 0.0});
  }
  return in;
}

namespace {

using Change = std::function<void(CohortInputs&)>;

CohortInputs with(const Change& change) {
  CohortInputs in = soundCohort();
  change(in);
  return in;
}

CohortInputs withMarks(const std::function<void(TrainingMark&)>& change) {
  return with([&](CohortInputs& in) {
    for (TrainingMark& mark : in.trainingMarks) {
      change(mark);
    }
    in = scored(std::move(in));
  });
}

CohortInputs without(const std::function<bool(const TrainingMark&)>& lost) {
  return with([&](CohortInputs& in) {
    std::erase_if(in.trainingMarks, lost);
    in = scored(std::move(in));
  });
}

Change doses(std::size_t group, double virtual_min, double real_min) {
  return [=](CohortInputs& in) {
    for (std::size_t i = 0; i < in.trainees.size(); ++i) {
      if (in.trainees[i].group == group) {
        in.doses[i].virtual_min = virtual_min;
        in.doses[i].real_min = real_min;
      }
    }
  };
}

constexpr const char* kDrawn = "Groups: drawn at random (complete permutation).";
constexpr const char* kNeedNot = "a difference need not be an effect of the training";
constexpr const char* kAsPlanned =
    "Training: by the times noted, all 30 trainees received what was planned for their group";
constexpr const char* kToTreat = "compared in the group to which they were allocated (intention to treat)";

}  // namespace

CohortInputs enteredTwice(int changed) {
  return with([changed](CohortInputs& in) {
    std::map<std::pair<std::string, std::size_t>, std::int64_t> first;
    for (const TrainingMark& mark : in.trainingMarks) {
      if (mark.trainee == "x101") {
        first[{mark.rater, mark.occasion}] = mark.steps;
      }
    }
    int left = changed;
    for (TrainingMark& mark : in.trainingMarks) {
      if (mark.trainee == "z110") {
        mark.steps = first.at({mark.rater, mark.occasion});
        mark.steps += left-- > 0 ? (mark.steps < 90 ? 10 : -10) : 0;
      }
    }
    in = scored(std::move(in));
  });
}

std::vector<StrangeCohort> strangeAllocations() {
  return {
      {"sound",
       soundCohort(),
       {kDrawn, kAsPlanned},
       {kNeedNot, kNoPlanSaid, kTwiceSaid, "withdrew:", "unlike before", "HC3"}},
      {"allocation not recorded",
       with([](CohortInputs& in) { in.allocation = {}; }),
       {"how trainees came into them is not in the record", kNeedNot},
       {"Groups: drawn"}},
      {"moved by hand",
       with([](CohortInputs& in) { in.allocation.movedByHand = 2; }),
       {"2 trainees were moved by hand after the draw", kNeedNot},
       {kDrawn}},
      {"moved by hand, and one untrained",
       with([](CohortInputs& in) {
         in.allocation.movedByHand = 2;
         in.doses.erase(in.doses.begin());
       }),
       {"Everybody is compared in the group in which the record has them."},
       {"intention to treat", kDrawn}},
      {"one moved by hand",
       with([](CohortInputs& in) { in.allocation.movedByHand = 1; }),
       {"1 trainee was moved by hand after the draw"}},
      {"the draw cannot be repeated",
       with([](CohortInputs& in) { in.allocation.replayDiffers = true; }),
       {"could not be repeated from its seed", kNeedNot},
       {kDrawn}},
      {"a draw that nobody repeated",
       with([](CohortInputs& in) { in.allocation.replayed = false; }),
       {"the draw has not been repeated from its seed"},
       {kDrawn}},
      {"some are in no group",
       with([](CohortInputs& in) { in.notAllocated = 6; }),
       {"6 trainees were enrolled but are in no group and in no comparison. The record does not say why."}},
      {"no plan of the analysis",
       with([](CohortInputs& in) { in.equivalenceMargin.reset(); }),
       {kNoPlanSaid},
       {"Planned and used"}},
      {"unlike before",
       withMarks([](TrainingMark& mark) { mark.steps += mark.group == 1 && mark.occasion == 0 ? 30 : 0; }),
       {"The groups were unlike before the training, in standard deviations: Group 1 - Group 2: -"},
       {"Group 1 - Group 3: 0.0;"}}};
}

std::vector<StrangeCohort> strangeTrainings() {
  return {{"nobody trained, nothing noted",
           with([](CohortInputs& in) { in.doses.clear(); }),
           {"no training time is in the record", "Nothing shows that the groups trained as their names say"},
           {kAsPlanned, kToTreat}},
          {"nobody trained",
           with([](CohortInputs& in) {
             for (CohortDose& dose : in.doses) {
               dose.virtual_min = dose.real_min = 0.0;
             }
           }),
           {"30 of 30 trainees did not receive what was planned", "no training: 30", kToTreat,
            "cannot be compared by themselves"},
           {kAsPlanned}},
          {"times without a plan",
           with([](CohortInputs& in) { in.groups[1].plannedReal_min.reset(); }),
           {"no plan for every group to compare them with"},
           {kAsPlanned}},
          {"group 1 trained on the real arm",
           with(doses(0, 0.0, 40.0)),
           {"10 of 30 trainees did not receive", "training that was not planned for the group: 10", kToTreat,
            "Only those who were trained as planned (per protocol, analysis of covariance), in points with "
            "95 % intervals after Holm: Group 2 - Group 3: "},
           {kAsPlanned}},
          {"groups 1 and 3 crossed over",
           with([](CohortInputs& in) {
             doses(0, 0.0, 40.0)(in);
             doses(2, 40.0, 0.0)(in);
           }),
           {"20 of 30 trainees did not receive", "training that was not planned for the group: 20", kToTreat,
            "cannot be compared by themselves"},
           {kAsPlanned}},
          {"group 3 trained two of forty minutes",
           with(doses(2, 0.0, 2.0)),
           {"10 of 30 trainees did not receive", "too little training: 10", kToTreat},
           {kAsPlanned}},
          {"group 1 trained twice as long",
           with(doses(0, 80.0, 0.0)),
           {"too much training: 10", kToTreat},
           {kAsPlanned}},
          {"one untrained",
           with([](CohortInputs& in) { in.doses.erase(in.doses.begin()); }),
           {"1 of 30 trainees did not receive what was planned", "no training: 1",
            "Only those who were trained as planned (per protocol, analysis of covariance), in points with "
            "95 % intervals after Holm: Group 1 - Group 2: "},
           {kAsPlanned}},
          {"a minute short", with(doses(0, 39.0, 0.0)), {kAsPlanned}, {kToTreat}},
          {"a look at the arm", with(doses(0, 40.0, 0.5)), {kAsPlanned}, {kToTreat}}};
}

std::vector<StrangeCohort> strangePeople() {
  return {
      {"all withdrew",
       with([](CohortInputs& in) {
         for (CohortTrainee& trainee : in.trainees) {
           trainee.withdrew = true;
         }
       }),
       {"Everybody withdrew. The answer rests on the marks of people who left the study",
        "30 of them withdrew"}},
      {"a third withdrew",
       with([](CohortInputs& in) {
         for (std::size_t i = 0; i < 10; ++i) {
           in.trainees[i].withdrew = true;
         }
       }),
       {"10 of 30 trainees withdrew (Group 1: 10; Group 2: 0; Group 3: 0). Where their marks are missing, "
        "the answer holds only for people like those who stayed"},
       {"Everybody withdrew"}},
      {"one withdrew",
       with([](CohortInputs& in) { in.trainees[0].withdrew = true; }),
       {"1 of them withdrew"},
       {"may hold only"}},
      {"dropout related to the outcome",
       with([](CohortInputs& in) {
         std::set<std::string> weak;
         for (const TraineeScore& score : in.scores) {
           if (score.group == 2 && score.occasion == 1 && score.score < 4.6) {
             weak.insert(score.trainee);
           }
         }
         for (CohortTrainee& trainee : in.trainees) {
           trainee.withdrew = weak.contains(trainee.code);
         }
         std::erase_if(in.trainingMarks, [&](const TrainingMark& mark) {
           return mark.occasion == 2 && weak.contains(mark.trainee);
         });
         in = scored(std::move(in));
       }),
       {"trainees withdrew (Group 1: 0; Group 2: 0; Group 3: ", "people like those who stayed",
        "could, at worst, leave open", "linear mixed model", "26 of them compared at the end, 4 of them"},
       {}},
      {"stopped early",
       with([](CohortInputs& in) {
         in.freeze = CohortFreeze{"stopped", "b", 1, "admin", true, 900, 540, "a difference was seen"};
         std::erase_if(in.trainingMarks,
                       [](const TrainingMark& mark) { return mark.trainee.substr(1) > "106"; });
         in = scored(std::move(in));
       }),
       {"Interim: these data were frozen when 540 of 900 sheets were in (a difference was seen)",
        "Looking at results before the end of a study makes false findings more likely."}},
      {"many entered twice",
       withMarks([](TrainingMark& mark) {
         mark.steps = 40 + (mark.trainee.back() - '0') % 2 * 20 +
                      (mark.rater.back() + static_cast<std::int64_t>(mark.occasion) * 3) % 7 * 5;
       }),
       {kTwiceSaid, " more pairs. Check whether somebody was entered twice."}},
      {"entered twice",
       enteredTwice(0),
       {"x101 and z110 in 30 of 30. Check whether somebody was entered twice."}},
      {"entered twice, one mark changed", enteredTwice(1), {kTwiceSaid, "x101 and z110 in 29 of 30."}},
      {"entered twice, three marks changed", enteredTwice(3), {kTwiceSaid, "x101 and z110 in 27 of 30."}},
      {"everything equal",
       withMarks([](TrainingMark& mark) { mark.steps = 70; }),
       {"Answer: none"},
       {"entered twice", "Answer, adjusted"}},
      {"a group of one",
       without([](const TrainingMark& mark) { return mark.group == 0 && mark.trainee != "x103"; }),
       {"A single trainee has a score at both occasions in: Group 1"}},
      {"an arm drops out",
       without([](const TrainingMark& mark) { return mark.group == 2 && mark.occasion > 0; }),
       {"nobody has a score at both occasions: Group 3"},
       {"Group 1 - Group 3"}},
      {"one group only",
       without([](const TrainingMark& mark) { return mark.group > 0; }),
       {"Answer: none", "0 of them compared at the end"},
       {"Answer, adjusted", "A difference that was not shown"}},
      {"changed after the freeze",
       with([](CohortInputs& in) {
         in.freeze = CohortFreeze{"final", "b", 1, "admin", false};
       }),
       {"has changed since it was frozen as \"final\""}},
      {"frozen with sheets missing",
       with([](CohortInputs& in) {
         in.freeze = CohortFreeze{"first look", "b", 1, "admin", true, 900, 2, "the board meets"};
       }),
       {"Interim: these data were frozen when 2 of 900 sheets were in (the board meets). One person alone "
        "decided to look."}},
      {"frozen by two with sheets missing",
       with([](CohortInputs& in) {
         in.freeze = CohortFreeze{"first look", "b", 1, "second", true, 900, 2, "the board meets", "admin"};
       }),
       {"admin asked for this look, and second agreed."},
       {"One person alone"}},
      {"imported",
       with([](CohortInputs& in) {
         in.imported = CohortOrigin{"Torsio", "set", std::string(64, 'c'), "admin", 1'767'600'000'000'000};
         in.imported->marks = 900;
         in.imported->recordings = 1;
         in.allocation = {};
       }),
       {"This study was imported: from set (Torsio, hash cccccccccccccccc) by admin on 2026-01-05 08:00 "
        "UTC, not signed, so nothing proves that its marks are real",
        "How its marks (900) were given", kNeedNot, kNoPlanSaid},
       {kDrawn}},
      {"imported with a signature",
       with([](CohortInputs& in) {
         in.imported = CohortOrigin{.layout = "Torsio",
                                    .source = "set",
                                    .contentHash = std::string(64, 'c'),
                                    .importedBy = "admin",
                                    .importedUtc_us = 1'767'600'000'000'000,
                                    .signedBy = std::string(64, 'd'),
                                    .marks = 900,
                                    .recordings = 1};
         in.allocation = {};
       }),
       {"signed with the key dddd"},
       {"marks are real"}},
      {"simulated",
       with([](CohortInputs& in) { in.demonstration = true; }),
       {kAsPlanned},
       {"This study was imported"}},
      {"as frozen",
       with([](CohortInputs& in) {
         in.freeze = CohortFreeze{"final", "b", 1, "admin", true};
       }),
       {},
       {"has changed since"}}};
}

std::vector<StrangeCohort> strangeMarks() {
  return {{"a rater is absent at the end",
           without([](const TrainingMark& mark) { return mark.rater == "R104" && mark.occasion == 2; }),
           {"Answer, adjusted"}},
          {"blinded", with([](CohortInputs& in) { in.markWays = {.blinded = 900}; }), {}, {"linded"}},
          {"unblinded",
           with([](CohortInputs& in) { in.markWays = {.live = 900}; }),
           {"Raters were not blinded: all marks of the training study (900) were given live"}},
          {"blinded in part",
           with([](CohortInputs& in) { in.markWays = {.blinded = 600, .live = 300}; }),
           {"Raters were blinded in part: of 900 marks"}},
          {"nothing shows how marks were given",
           with([](CohortInputs& in) { in.markWays = {.entered = 900}; }),
           {"Nothing shows that raters were blinded"}},
          {"one arm rated by one rater",
           without([](const TrainingMark& mark) { return mark.group == 0 && mark.rater != "R101"; }),
           {"linear mixed model"}},
          {"a mark is missing",
           without([](const TrainingMark& mark) {
             return mark.rater == "R104" && mark.occasion == 2 && mark.trainee == "x101";
           }),
           {"Of 600 marks 1 is missing, so the answer is that of the linear mixed model"}},
          {"spreads differ",
           withMarks([](TrainingMark& mark) {
             const std::int64_t person = (mark.trainee.back() - '0') % 10;
             const std::int64_t noise = mark.rater.back() % 2;
             mark.steps = mark.occasion == 0 ? 40 + 2 * person + noise
                          : mark.group == 0  ? (person % 2 == 0 ? 95 : 15) + noise
                                             : 60 + person + noise;
           }),
           {"Scores vary more in some groups than in others",
            "The standard errors of the answer allow for that (HC3)."}},
          {"slopes differ",
           withMarks([](TrainingMark& mark) {
             const std::int64_t person = mark.trainee.back() - '0';
             mark.steps = mark.occasion == 0 ? 20 + 6 * person + (mark.rater.back() - '0')
                          : mark.group == 0
                              ? 90 - 7 * person + (mark.rater.back() - '0')
                              : 30 + 6 * person + (mark.rater.back() - '0') + person * person % 4;
           }),
           {"The difference depends on the score before"}}};
}

}  // namespace torsio::testing
