// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/campaign_service.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/study/draw_field.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/random.h"

namespace torsio {

namespace {

constexpr std::size_t kAllOrdersUpTo = 4;  // 24 orders; five models would already have 120
constexpr std::int64_t kMaxRecordings = 1'000;
constexpr std::uint64_t kLabelStream = 1;
constexpr std::uint64_t kOrderStream = 2;

/// Chooses X, Y, Z, then W, V ...: easy to tell apart, and unlike the models' own names.
std::vector<std::string> hiddenLabels(std::size_t count, Random& random) {
  constexpr std::string_view kLabels = "XYZWVUTSRQPN";
  if (count > kLabels.size()) {
    refuseParameter(Text::tr("more than %1 models cannot be compared", kLabels.size()), Text::tr("models"),
                    Text::tr("Split the evaluation"));
  }
  std::vector<std::string> labels;
  for (const char letter : kLabels.substr(0, count)) {
    labels.emplace_back(1, letter);
  }
  random.shuffle(std::span<std::string>(labels));
  return labels;
}

/// Returns orders of models as lists of positions: every permutation, or the rows of a Latin square.
std::vector<std::vector<std::size_t>> ordersOf(std::size_t models) {
  std::vector<std::size_t> order(models);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::vector<std::size_t>> orders;
  if (models <= kAllOrdersUpTo) {
    do {
      orders.push_back(order);
    } while (std::next_permutation(order.begin(), order.end()));
    return orders;
  }
  for (std::size_t row = 0; row < models; ++row) {
    orders.push_back(order);
    std::rotate(order.begin(), order.begin() + 1, order.end());
  }
  return orders;
}

bool isRecorded(const NewModel& model) {
  return !model.trialId.empty();
}

/// Throws unless the recordings are finished, each by a different model and none by a real trainee. Returns
/// whether a simulated hand made any of them: the evaluation is then a demonstration.
bool checkRecordings(SessionContext& session, const std::vector<NewModel>& models) {
  if (std::none_of(models.begin(), models.end(), isRecorded)) {
    return false;
  }
  bool simulated = false;
  TrialRepository trials(session.connection());
  std::set<TissueModel> met;
  for (const NewModel& model : models) {
    const Trial trial = trials.load(model.trialId);
    if (trial.summary.contentHash.empty()) {
      refuseParameter(Text::tr("this recording has no end"), model.code, Text::tr("Choose a finished one"));
    }
    if (!trial.header.traineeCode.empty() && !trial.header.demonstration) {
      refuseParameter(Text::tr("this recording belongs to a trainee"), model.code,
                      Text::tr("Choose one of free practice"));
    }
    if (!met.insert(trial.header.model).second) {
      refuseParameter(Text::tr("two recordings were made with the same model"), model.code,
                      Text::tr("Choose one of each model"));
    }
    simulated = simulated || trial.header.demonstration;
  }
  return simulated;
}

/// Returns the raters of the plan by class, ordered by code.
std::map<std::string, std::vector<Rater>> ratersByClass(SessionContext& session, const CampaignPlan& plan) {
  std::map<std::string, std::int64_t> weight_milli;
  for (const RaterClass& raterClass : plan.instrument.classes) {
    weight_milli[raterClass.id] = raterClass.weight_milli;
  }
  const std::set<std::string> wanted(plan.raterIds.begin(), plan.raterIds.end());
  std::map<std::string, std::vector<Rater>> byClass;
  std::size_t found = 0;
  for (Rater& rater : PeopleRepository(session.connection()).raters()) {
    if (!wanted.contains(rater.person.id) || rater.person.state != PersonState::kActive) {
      continue;
    }
    ++found;
    const auto known = weight_milli.find(rater.classCode);
    if (known == weight_milli.end() || known->second == 0) {
      refuseParameter(Text::tr("the class %1 has no weight in this evaluation", rater.classCode),
                      rater.person.code, Text::tr("Give the class a weight, or leave the rater out"));
    }
    byClass[rater.classCode].push_back(std::move(rater));
  }
  if (found != wanted.size()) {
    refuseParameter(Text::tr("the list contains a person who is not an active rater"), Text::tr("raters"),
                    Text::tr("Choose from the list"));
  }
  for (const auto& [code, weight] : weight_milli) {
    if (weight > 0 && byClass[code].empty()) {
      refuseParameter(Text::tr("nobody scores in the class %1, which has a weight", code), Text::tr("raters"),
                      Text::tr("Choose raters of this class, or take its weight away"));
    }
  }
  return byClass;
}

}  // namespace

void requireComparableModels(const std::vector<NewModel>& models) {
  if (models.size() < 2) {
    refuseParameter(Text::tr("there is nothing to compare"), Text::tr("models"),
                    Text::tr("Name at least two models"));
  }
  std::set<std::string> codes;
  for (const NewModel& model : models) {
    if (model.code.empty() || model.label.empty()) {
      refuseParameter(Text::tr("a model has no code or no name"), model.code + model.label,
                      Text::tr("Fill both in"));
    }
    if (model.code.find(',') != std::string::npos) {
      refuseParameter(Text::tr("the code of a model holds a comma"), model.code,
                      Text::tr("Use letters and digits"));
    }
    if (!codes.insert(model.code).second) {
      refuseParameter(Text::tr("two models have the same code"), model.code, Text::tr("Rename one"));
    }
  }
  if (std::any_of(models.begin(), models.end(), isRecorded)) {
    const auto without = std::find_if_not(models.begin(), models.end(), isRecorded);
    if (without != models.end()) {
      refuseParameter(Text::tr("a model has no recording"), without->code,
                      Text::tr("Choose one for each model, or for none"));
    }
  }
}

EvaluationInstrument paperEvaluationInstrument() {
  EvaluationInstrument instrument = paperInstrument();
  for (std::size_t i = 0; i < instrument.classes.size(); ++i) {
    instrument.classes[i].id = kSeniorities.at(i).stored;
  }
  return instrument;
}

std::vector<EvaluationRecording> evaluationRecordings(SessionContext& session) {
  session.require(Operation::kEvaluationSetup);
  std::vector<EvaluationRecording> found;
  for (const TrialListing& trial : TrialRepository(session.connection()).list({.limit = kMaxRecordings})) {
    if (trial.summary && trial.traineeCode.empty()) {
      found.push_back({trial.trialId, trial.sceneId, trial.patternId, trial.model, trial.startedUtc_us});
    }
  }
  return found;
}

CampaignId addCampaign(SessionContext& session, const CampaignPlan& plan) {
  session.require(Operation::kEvaluationSetup);
  if (plan.name.empty()) {
    refuseParameter(Text::tr("the evaluation has no name"), Text::tr("name"), Text::tr("Enter one"));
  }
  requireComparableModels(plan.models);
  const bool simulated = checkRecordings(session, plan.models);
  validateInstrument(plan.instrument);
  Transaction transaction(session.connection());
  const std::uint64_t seed = plan.seed ? *plan.seed : drawSeed(session.ids());
  Campaign campaign;
  campaign.id = session.ids().newUuid();
  campaign.name = plan.name;
  campaign.instrument = plan.instrument;
  campaign.createdUtc_us = session.now_us();
  campaign.demonstration = plan.demonstration || simulated;
  Random labelDraw = Random::forStream(seed, kLabelStream);
  const std::vector<std::string> labels = hiddenLabels(plan.models.size(), labelDraw);
  for (std::size_t i = 0; i < plan.models.size(); ++i) {
    campaign.models.push_back({plan.models[i].code, plan.models[i].label, labels[i],
                               static_cast<std::int64_t>(i + 1), plan.models[i].trialId});
  }
  Random orderDraw = Random::forStream(seed, kOrderStream);
  for (const auto& [classCode, raters] : ratersByClass(session, plan)) {
    // Each class uses all orders before one is repeated; which rater gets which is random.
    std::vector<std::vector<std::size_t>> orders;
    for (std::size_t i = 0; i < raters.size(); ++i) {
      if (orders.empty()) {
        orders = ordersOf(plan.models.size());
        orderDraw.shuffle(std::span<std::vector<std::size_t>>(orders));
      }
      std::string text;
      for (const std::size_t model : orders.back()) {
        text += (text.empty() ? "" : ",") + plan.models[model].code;
      }
      orders.pop_back();
      campaign.raters.push_back({raters[i].person.id, classCode, text});
    }
  }
  EvaluationRepository(session.connection()).addCampaign(campaign);
  session.note(
      AuditAction::kEvaluationAdd, AuditObject::kEvaluationCampaign, campaign.id,
      {{"models", plan.models.size()}, {"raters", campaign.raters.size()}, {"seed", std::to_string(seed)}});
  transaction.commit();
  return campaign.id;
}

std::vector<CampaignRow> campaigns(SessionContext& session) {
  session.require(Operation::kEvaluationSetup);
  EvaluationRepository repository(session.connection());
  std::map<std::string, std::string> codes;
  for (const Rater& rater : PeopleRepository(session.connection()).raters()) {
    codes[rater.person.id] = rater.person.code;
  }
  std::vector<CampaignRow> rows;
  for (const auto& [id, name] : repository.campaigns()) {
    CampaignRow row;
    row.campaign = repository.campaign(id).value();
    const std::size_t each = row.campaign.models.size() * row.campaign.instrument.indices.size();
    std::map<std::string, std::size_t> submitted;
    for (const EvaluationMark& mark : repository.marks(id)) {
      ++submitted[mark.raterId];
    }
    for (const CampaignRater& rater : row.campaign.raters) {
      row.raters.push_back(
          {rater.raterId, codes[rater.raterId], rater.classCode, submitted[rater.raterId], each});
      row.marksExpected += each;
      row.marksSubmitted += submitted[rater.raterId];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace torsio
