// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/access/audit_labels.h"

#include <map>

namespace torsio {

namespace {

using Words = std::map<std::string, Text>;

const Words& peopleLabels() {
  static const Words words{
      {"user.sign_in", Text("Signed in")},
      {"user.sign_in_practice", Text("Signed in to practise only")},
      {"user.sign_in_failed", Text("Sign-in failed")},
      {"user.sign_out", Text("Signed out")},
      {"user.unlock", Text("Screen unlocked")},
      {"user.add", Text("User added")},
      {"user.set_roles", Text("Roles of a user changed")},
      {"user.enable", Text("User enabled")},
      {"user.disable", Text("User disabled")},
      {"user.change_password", Text("Own password changed")},
      {"user.reset_password", Text("Password of a user reset")},
      {"user.set_pin", Text("PIN set")},
      {"user.remove_pin", Text("PIN removed")},
      {"person.add", Text("Person entered")},
      {"person.change", Text("Person changed")},
      {"person.set_state", Text("State of a person changed")},
      {"person.erase", Text("Identity of a person erased")},
      {"person.export", Text("Everything about a person exported")},
      {"people.export_named", Text("List of people exported with names")},
      {"people.export_coded", Text("List of people exported under codes")},
      {"trial.export_coded", Text("List of recordings exported under codes")},
      {"mark.export_coded", Text("Single marks exported under codes")},
      {"roster.import", Text("Roster imported")},
      {"rater_class.add", Text("Classes of raters set up")},
      {"consent.grant", Text("Consent recorded")},
      {"consent.withdraw", Text("Withdrawal of consent recorded")},
      {"consent.own", Text("Decided about their own consent")},
      {"transcript.make", Text("Training transcript made")},
      {"retention.rule", Text("Rule for keeping records changed")},
      {"retention.remove_rule", Text("Rule for keeping records taken away")},
      {"retention.lock", Text("Record locked against erasing")},
      {"retention.extend", Text("Record kept longer")},
      {"retention.release", Text("Record released for erasing")},
  };
  return words;
}

const Words& studyLabels() {
  static const Words words{
      {"curriculum.add", Text("Curriculum added")},
      {"curriculum.save_draft", Text("Draft of a curriculum saved")},
      {"curriculum.publish", Text("Curriculum published")},
      {"curriculum.running", Text("Curriculum put into use")},
      {"curriculum.closed", Text("Curriculum closed")},
      {"occasion.add", Text("Occasion of scoring added")},
      {"rubric.add", Text("Rubric added")},
      {"rubric.revise", Text("Rubric revised")},
      {"cohort.add", Text("Cohort added")},
      {"cohort.assign_curriculum", Text("Curriculum given to a cohort")},
      {"enrolment.add", Text("Trainee enrolled")},
      {"enrolment.set_state", Text("Taking part in the study changed")},
      {"allocation.draw", Text("Groups drawn")},
      {"allocation.lock", Text("Allocation locked")},
      {"allocation.supersede", Text("Allocation replaced by a new one")},
      {"allocation.override", Text("Group of a trainee changed by hand")},
      {"allocation.reveal", Text("Seed of the allocation opened")},
      {"allocation.cards", Text("Sealed cards printed")},
      {"exposure.record", Text("Training time logged")},
      {"deviation.report", Text("Deviation reported")},
      {"evaluation.add", Text("Evaluation campaign added")},
      {"evaluation.form", Text("Evaluation form submitted")},
      {"evaluation.submit", Text("Evaluation mark submitted")},
      {"evaluation.amend", Text("Evaluation mark amended")},
      {"dataset.freeze", Text("Data set frozen")},
      {"report.export_named", Text("Report exported with names")},
      {"report.export_coded", Text("Report exported under codes")},
  };
  return words;
}

const Words& scoringLabels() {
  static const Words words{
      {"assignment.create", Text("Scoring assigned")},
      {"assignment.reassign", Text("Scoring given to another rater")},
      {"assignment.withdraw", Text("Scoring withdrawn from a rater")},
      {"assignment.third", Text("Adjudicator assigned")},
      {"alignment.keep", Text("Own mark kept in the discrepancy review")},
      {"alignment.move", Text("Own mark amended in the discrepancy review")},
      {"alignment.third", Text("Adjudicator requested")},
      {"sheet.submit", Text("Sheet submitted")},
      {"sheet.amend", Text("Sheet amended")},
      {"mark.submit", Text("Mark submitted")},
      {"mark.amend", Text("Mark amended")},
      {"mark.release", Text("Marks released to trainees")},
      {"mark.retract", Text("Release of marks taken back")},
      {"warmup.score", Text("Reference run scored for rater calibration")},
      {"reference_run.add", Text("Reference run chosen")},
      {"reference_run.withdraw", Text("Reference run withdrawn")},
      {"remark.add", Text("Remark written")},
      {"remark.reply", Text("Remark answered")},
      {"remark.read", Text("Remark read")},
      {"question.ask", Text("Question asked")},
      {"question.answer", Text("Question answered")},
  };
  return words;
}

const Words& stationLabels() {
  static const Words words{
      {"run.start", Text("Training run begun")},
      {"run.stop", Text("Training run stopped")},
      {"trial.finish", Text("Recording finished")},
      {"trial.interrupted", Text("Recording interrupted")},
      {"trial.close_interrupted", Text("Interrupted recording closed")},
      {"trial.import", Text("Recording stored from a file")},
      {"trial.bookmark", Text("Moment of a recording bookmarked")},
      {"trial.self_score", Text("Own recording scored")},
      {"centre.set_up", Text("Centre set up")},
      {"centre.rename", Text("Centre renamed")},
      {"setting.change", Text("Setting changed")},
      {"audit.verify", Text("Audit trail verified")},
      {"database.backup", Text("Record backed up")},
      {"database.check", Text("Database checked")},
      {"database.restore", Text("Backup restored")},
      {"database.restore_begin", Text("Restoring a backup begun")},
      {"database.move", Text("Move to a server begun")},
      {"database.move_given_up", Text("Move to a server given up")},
      {"database.switch", Text("Station turned to the server")},
      {"database.join", Text("Station joined the record of a server")},
      {"demonstration.remove", Text("Demonstration data removed")},
  };
  return words;
}

const Words& objectLabels() {
  static const Words words{
      {"allocation", Text("group of a trainee")},
      {"allocation_design", Text("allocation")},
      {"app_user", Text("user")},
      {"assignment", Text("assignment")},
      {"audit_entry", Text("audit trail")},
      {"cohort", Text("cohort")},
      {"occasion", Text("occasion")},
      {"consent", Text("consent")},
      {"curriculum", Text("curriculum")},
      {"curriculum_draft", Text("draft of a curriculum")},
      {"centre", Text("centre")},
      {"curriculum_version", Text("version of a curriculum")},
      {"database", Text("record")},
      {"demonstration", Text("demonstration data")},
      {"deviation", Text("deviation")},
      {"enrolment", Text("enrolled trainee")},
      {"evaluation_campaign", Text("evaluation campaign")},
      {"evaluation_mark", Text("evaluation mark")},
      {"exposure", Text("training time")},
      {"frozen_dataset", Text("frozen data set")},
      {"mark_release", Text("release of marks")},
      {"person", Text("person")},
      {"rater_class", Text("class of raters")},
      {"rater_warmup", Text("rater calibration")},
      {"reference_run", Text("reference run")},
      {"retention_rule", Text("rule for keeping records")},
      {"rubric_revision", Text("rubric")},
      {"setting", Text("setting")},
      {"training_mark", Text("mark")},
      {"trial", Text("recording")},
      {"trial_question", Text("question")},
      {"trial_remark", Text("remark")},
  };
  return words;
}

}  // namespace

Text auditActionLabel(const std::string& action) {
  for (const Words* words : {&peopleLabels(), &studyLabels(), &scoringLabels(), &stationLabels()}) {
    if (const auto found = words->find(action); found != words->end()) {
      return found->second;
    }
  }
  return action;
}

Text auditObjectLabel(const std::string& objectKind) {
  const auto found = objectLabels().find(objectKind);
  return found == objectLabels().end() ? Text(objectKind) : found->second;
}

}  // namespace torsio
