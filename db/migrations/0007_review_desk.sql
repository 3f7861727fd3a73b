-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: what a rater has watched, drafts of evaluations, reference runs
-- compatible_from: 1

-- How a sheet comes about while it is a draft: stretches of the recording that were played ("0-1200;1500-1600", in
-- hundredths of a second), speeds, time at work. Overwritten with every save, deleted when the sheet is submitted.
CREATE TABLE draft_viewing (
  assignment_id TEXT PRIMARY KEY REFERENCES assignment (id),
  watched TEXT NOT NULL,
  slowest_permille BIGINT NOT NULL,
  fastest_permille BIGINT NOT NULL,
  worked_us BIGINT NOT NULL
);

-- The same, sealed with the mark. Without a recording (live, on the real arm) the share is null.
CREATE TABLE mark_viewing (
  mark_id TEXT PRIMARY KEY REFERENCES training_mark (id),
  watched_permille BIGINT CHECK (watched_permille BETWEEN 0 AND 1000),
  slowest_permille BIGINT NOT NULL,
  fastest_permille BIGINT NOT NULL,
  worked_us BIGINT NOT NULL CHECK (worked_us >= 0)
);
{{append_only mark_viewing}}

-- The unfinished evaluation form of one rater, saved on each keystroke; deleted with the submission.
CREATE TABLE evaluation_draft (
  campaign_id TEXT NOT NULL,
  rater_id TEXT NOT NULL,
  model_code TEXT NOT NULL,
  index_number BIGINT NOT NULL,
  score_steps BIGINT NOT NULL,
  changed_utc_us BIGINT NOT NULL,
  PRIMARY KEY (campaign_id, rater_id, model_code, index_number),
  FOREIGN KEY (campaign_id, rater_id) REFERENCES evaluation_rater (campaign_id, rater_id),
  FOREIGN KEY (campaign_id, model_code) REFERENCES evaluation_model (campaign_id, model_code),
  FOREIGN KEY (campaign_id, index_number) REFERENCES evaluation_index (campaign_id, index_number)
);
CREATE INDEX evaluation_draft_model ON evaluation_draft (campaign_id, model_code);
CREATE INDEX evaluation_draft_index ON evaluation_draft (campaign_id, index_number);

-- Runs that a panel has marked together; every rater scores them before the first real case.
CREATE TABLE reference_run (
  trial_id TEXT PRIMARY KEY REFERENCES trial (id),
  position BIGINT NOT NULL,
  rubric_revision_id TEXT NOT NULL REFERENCES rubric_revision (id),
  panel_steps DOUBLE PRECISION NOT NULL,
  panel_raters BIGINT NOT NULL CHECK (panel_raters >= 1),
  set_by TEXT NOT NULL,
  set_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
CREATE INDEX reference_run_rubric ON reference_run (rubric_revision_id);
{{append_only reference_run}}
