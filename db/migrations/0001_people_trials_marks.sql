-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: centre, people, cohorts, allocation, trials, marks, evaluation, results
-- compatible_from: 1
--
-- Ids are UUID text made by the application. Times are microseconds since 1970 UTC (_utc_us) or since the start
-- of the trial (_us). Scores are whole steps of their scale (_steps; points = steps / steps_per_point), weights whole
-- thousandths (_milli): both exact.

CREATE TABLE centre (
  id TEXT PRIMARY KEY,
  name TEXT NOT NULL,
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);

CREATE TABLE setting (
  name TEXT PRIMARY KEY,
  value TEXT NOT NULL,
  changed_utc_us BIGINT NOT NULL
);

-- Holds a row only inside the transaction of a person erase or of the removal of demonstration data.
CREATE TABLE erasure_gate (
  id TEXT PRIMARY KEY,
  reason TEXT NOT NULL,
  opened_utc_us BIGINT NOT NULL
);
{{append_only_support}}

-- People: the coded record, the identity apart from it.

CREATE TABLE person (
  id TEXT PRIMARY KEY,
  code TEXT NOT NULL UNIQUE,
  sex TEXT CHECK (sex IN ('female', 'male', 'other')),
  level TEXT,
  experience TEXT,
  age_years BIGINT CHECK (age_years BETWEEN 0 AND 150),
  state TEXT NOT NULL CHECK (state IN ('active', 'left', 'erased')),
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
{{frozen person code}}
{{frozen person demonstration}}

CREATE TABLE person_identity (
  person_id TEXT PRIMARY KEY REFERENCES person (id),
  full_name TEXT NOT NULL,
  email TEXT,
  external_id TEXT UNIQUE
);

CREATE TABLE trainee (
  person_id TEXT PRIMARY KEY REFERENCES person (id),
  handedness TEXT CHECK (handedness IN ('left', 'right'))
);

CREATE TABLE rater_class (
  code TEXT PRIMARY KEY,
  label TEXT NOT NULL,
  position BIGINT NOT NULL
);

CREATE TABLE rater (
  person_id TEXT PRIMARY KEY REFERENCES person (id),
  class_code TEXT NOT NULL REFERENCES rater_class (code)
);
CREATE INDEX rater_class_code ON rater (class_code);

-- The training study.

CREATE TABLE cohort (
  id TEXT PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  description TEXT NOT NULL,
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);

CREATE TABLE training_group (
  id TEXT PRIMARY KEY,
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  number BIGINT NOT NULL,
  code TEXT NOT NULL,
  label TEXT NOT NULL,
  UNIQUE (cohort_id, number),
  UNIQUE (cohort_id, code)
);

CREATE TABLE enrolment (
  id TEXT PRIMARY KEY,
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  trainee_id TEXT NOT NULL REFERENCES trainee (person_id),
  group_id TEXT REFERENCES training_group (id),
  number_in_group BIGINT,
  state TEXT NOT NULL CHECK (state IN ('enrolled', 'completed', 'withdrawn')),
  enrolled_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  UNIQUE (cohort_id, trainee_id),
  UNIQUE (group_id, number_in_group)
);
CREATE INDEX enrolment_trainee ON enrolment (trainee_id);

CREATE TABLE allocation_design (
  id TEXT PRIMARY KEY,
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  algorithm TEXT NOT NULL,
  algorithm_version TEXT NOT NULL,
  parameters_json TEXT NOT NULL,
  generator TEXT NOT NULL,
  seed_commitment TEXT NOT NULL,
  locked_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
CREATE INDEX allocation_design_cohort ON allocation_design (cohort_id);
{{append_only allocation_design}}

-- The seed lies apart from the design, so that who may read the design need not see it before the end.
CREATE TABLE allocation_seed (
  design_id TEXT PRIMARY KEY REFERENCES allocation_design (id),
  seed TEXT NOT NULL,
  revealed_utc_us BIGINT
);
{{frozen allocation_seed seed}}

CREATE TABLE allocation (
  id TEXT PRIMARY KEY,
  design_id TEXT NOT NULL REFERENCES allocation_design (id),
  sequence BIGINT NOT NULL,
  enrolment_id TEXT NOT NULL REFERENCES enrolment (id),
  group_id TEXT NOT NULL REFERENCES training_group (id),
  number_in_group BIGINT NOT NULL,
  covariates_json TEXT NOT NULL,
  counts_before_json TEXT NOT NULL,
  scores_json TEXT NOT NULL,
  draw_before BIGINT NOT NULL,
  draw_after BIGINT NOT NULL,
  enrolled_by TEXT NOT NULL,
  allocated_by TEXT NOT NULL,
  software_version TEXT NOT NULL,
  override_reason TEXT,
  allocated_utc_us BIGINT NOT NULL,
  previous_hash TEXT NOT NULL,
  record_hash TEXT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  UNIQUE (design_id, sequence)
);
CREATE INDEX allocation_enrolment ON allocation (enrolment_id);
{{append_only allocation}}

-- Trials: a trial without a row in trial_end is running or was interrupted.

CREATE TABLE trial (
  id TEXT PRIMARY KEY,
  trainee_id TEXT REFERENCES trainee (person_id),
  enrolment_id TEXT REFERENCES enrolment (id),
  station TEXT NOT NULL,
  scene_id TEXT NOT NULL,
  pattern_id TEXT NOT NULL,
  organ_hash TEXT NOT NULL,
  parameter_hash TEXT NOT NULL,
  parameters_json TEXT NOT NULL,
  device_model TEXT NOT NULL,
  device_max_force_n DOUBLE PRECISION NOT NULL,
  device_continuous_force_n DOUBLE PRECISION NOT NULL,
  device_max_stiffness_n_per_m DOUBLE PRECISION NOT NULL,
  workspace_min_x_m DOUBLE PRECISION NOT NULL,
  workspace_min_y_m DOUBLE PRECISION NOT NULL,
  workspace_min_z_m DOUBLE PRECISION NOT NULL,
  workspace_max_x_m DOUBLE PRECISION NOT NULL,
  workspace_max_y_m DOUBLE PRECISION NOT NULL,
  workspace_max_z_m DOUBLE PRECISION NOT NULL,
  software_version TEXT NOT NULL,
  phase_label TEXT NOT NULL,
  drive BIGINT NOT NULL,
  target_angle_rad DOUBLE PRECISION NOT NULL,
  force_scale DOUBLE PRECISION NOT NULL,
  tick_period_us BIGINT NOT NULL,
  started_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
CREATE INDEX trial_started ON trial (started_utc_us);
CREATE INDEX trial_trainee_started ON trial (trainee_id, started_utc_us);
CREATE INDEX trial_enrolment ON trial (enrolment_id);
{{append_only trial}}

CREATE TABLE trial_chunk (
  trial_id TEXT NOT NULL REFERENCES trial (id),
  chunk_index BIGINT NOT NULL,
  first_tick BIGINT NOT NULL,
  sample_count BIGINT NOT NULL,
  digest TEXT NOT NULL,
  output_digest TEXT NOT NULL,
  stored_utc_us BIGINT NOT NULL,
  bytes {{blob}} NOT NULL,
  PRIMARY KEY (trial_id, chunk_index)
);
{{append_only trial_chunk}}

CREATE TABLE trial_event (
  trial_id TEXT NOT NULL REFERENCES trial (id),
  sequence BIGINT NOT NULL,
  tick BIGINT NOT NULL,
  time_us BIGINT NOT NULL,
  kind TEXT NOT NULL,
  label TEXT NOT NULL,
  value DOUBLE PRECISION,
  PRIMARY KEY (trial_id, sequence)
);
{{append_only trial_event}}

CREATE TABLE trial_end (
  trial_id TEXT PRIMARY KEY REFERENCES trial (id),
  sample_count BIGINT NOT NULL,
  refused_samples BIGINT NOT NULL,
  late_ticks BIGINT NOT NULL,
  outcome TEXT NOT NULL CHECK (outcome IN ('completed', 'interrupted')),
  content_hash TEXT NOT NULL,
  ended_utc_us BIGINT NOT NULL
);
{{append_only trial_end}}

-- Training marks (paper section 6): one row a trainee, rater and scoring point; a correction is a new version.

CREATE TABLE scoring_point (
  code TEXT PRIMARY KEY,
  label TEXT NOT NULL,
  position BIGINT NOT NULL
);
INSERT INTO scoring_point (code, label, position) VALUES
  ('pre', 'before training', 1), ('mid', 'after 20 min', 2), ('post', 'after 40 min', 3);

CREATE TABLE training_mark (
  id TEXT PRIMARY KEY,
  enrolment_id TEXT NOT NULL REFERENCES enrolment (id),
  rater_id TEXT NOT NULL REFERENCES rater (person_id),
  scoring_point TEXT NOT NULL REFERENCES scoring_point (code),
  version BIGINT NOT NULL CHECK (version >= 1),
  trial_id TEXT REFERENCES trial (id),
  score_steps BIGINT,
  scale_lo_steps BIGINT NOT NULL,
  scale_hi_steps BIGINT NOT NULL,
  steps_per_point BIGINT NOT NULL CHECK (steps_per_point >= 1),
  not_assessable_reason TEXT,
  comment TEXT,
  amend_reason TEXT,
  submitted_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  UNIQUE (enrolment_id, rater_id, scoring_point, version),
  CHECK (score_steps BETWEEN scale_lo_steps AND scale_hi_steps),
  CHECK ((score_steps IS NULL) = (not_assessable_reason IS NOT NULL)),
  CHECK ((version = 1) = (amend_reason IS NULL))
);
CREATE INDEX training_mark_rater ON training_mark (rater_id, submitted_utc_us);
{{append_only training_mark}}

-- The nine-index evaluation (paper section 5.3).

CREATE TABLE evaluation_campaign (
  id TEXT PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  scale_lo_steps BIGINT NOT NULL,
  scale_hi_steps BIGINT NOT NULL,
  steps_per_point BIGINT NOT NULL CHECK (steps_per_point >= 1),
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
{{append_only evaluation_campaign}}

CREATE TABLE evaluation_class (
  campaign_id TEXT NOT NULL REFERENCES evaluation_campaign (id),
  class_code TEXT NOT NULL REFERENCES rater_class (code),
  position BIGINT NOT NULL,
  weight_milli BIGINT NOT NULL CHECK (weight_milli BETWEEN 0 AND 1000),
  PRIMARY KEY (campaign_id, class_code)
);
{{append_only evaluation_class}}

CREATE TABLE evaluation_index (
  campaign_id TEXT NOT NULL REFERENCES evaluation_campaign (id),
  index_number BIGINT NOT NULL,
  code TEXT NOT NULL,
  label TEXT NOT NULL,
  weight_milli BIGINT NOT NULL CHECK (weight_milli BETWEEN 0 AND 1000),
  PRIMARY KEY (campaign_id, index_number),
  UNIQUE (campaign_id, code)
);
{{append_only evaluation_index}}

CREATE TABLE evaluation_model (
  campaign_id TEXT NOT NULL REFERENCES evaluation_campaign (id),
  model_code TEXT NOT NULL,
  label TEXT NOT NULL,
  hidden_label TEXT NOT NULL,
  position BIGINT NOT NULL,
  PRIMARY KEY (campaign_id, model_code),
  UNIQUE (campaign_id, hidden_label)
);
{{append_only evaluation_model}}

-- The class that counted at the time, whatever the rater becomes later.
CREATE TABLE evaluation_rater (
  campaign_id TEXT NOT NULL,
  rater_id TEXT NOT NULL REFERENCES rater (person_id),
  class_code TEXT NOT NULL,
  model_order TEXT NOT NULL,
  PRIMARY KEY (campaign_id, rater_id),
  FOREIGN KEY (campaign_id, class_code) REFERENCES evaluation_class (campaign_id, class_code)
);
CREATE INDEX evaluation_rater_rater ON evaluation_rater (rater_id);
{{append_only evaluation_rater}}

CREATE TABLE evaluation_mark (
  id TEXT PRIMARY KEY,
  campaign_id TEXT NOT NULL,
  rater_id TEXT NOT NULL,
  model_code TEXT NOT NULL,
  index_number BIGINT NOT NULL,
  version BIGINT NOT NULL CHECK (version >= 1),
  score_steps BIGINT NOT NULL,
  amend_reason TEXT,
  submitted_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  UNIQUE (campaign_id, rater_id, model_code, index_number, version),
  CHECK ((version = 1) = (amend_reason IS NULL)),
  FOREIGN KEY (campaign_id, rater_id) REFERENCES evaluation_rater (campaign_id, rater_id),
  FOREIGN KEY (campaign_id, model_code) REFERENCES evaluation_model (campaign_id, model_code),
  FOREIGN KEY (campaign_id, index_number) REFERENCES evaluation_index (campaign_id, index_number)
);
{{append_only evaluation_mark}}

-- Results: what a formula made of which inputs, when. Computed anew, never changed.

CREATE TABLE assessment_run (
  id TEXT PRIMARY KEY,
  campaign_id TEXT REFERENCES evaluation_campaign (id),
  cohort_id TEXT REFERENCES cohort (id),
  formula_version TEXT NOT NULL,
  policy TEXT NOT NULL,
  inputs_hash TEXT NOT NULL,
  flags TEXT NOT NULL,
  software_version TEXT NOT NULL,
  computed_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  CHECK ((campaign_id IS NULL) <> (cohort_id IS NULL))
);
CREATE INDEX assessment_run_campaign ON assessment_run (campaign_id, computed_utc_us);
CREATE INDEX assessment_run_cohort ON assessment_run (cohort_id, computed_utc_us);
{{append_only assessment_run}}

CREATE TABLE evaluation_result (
  run_id TEXT NOT NULL REFERENCES assessment_run (id),
  model_code TEXT NOT NULL,
  index_number BIGINT NOT NULL,
  weighted_mean DOUBLE PRECISION NOT NULL,
  variance DOUBLE PRECISION NOT NULL,
  rater_count BIGINT NOT NULL,
  missing_count BIGINT NOT NULL,
  lowest DOUBLE PRECISION NOT NULL,
  highest DOUBLE PRECISION NOT NULL,
  plain_mean DOUBLE PRECISION NOT NULL,
  population_variance DOUBLE PRECISION NOT NULL,
  sample_variance DOUBLE PRECISION,
  standard_error DOUBLE PRECISION,
  flags TEXT NOT NULL,
  PRIMARY KEY (run_id, model_code, index_number)
);
{{append_only evaluation_result}}

CREATE TABLE composite_result (
  run_id TEXT NOT NULL REFERENCES assessment_run (id),
  model_code TEXT NOT NULL,
  composite DOUBLE PRECISION NOT NULL,
  standard_error DOUBLE PRECISION,
  flags TEXT NOT NULL,
  PRIMARY KEY (run_id, model_code)
);
{{append_only composite_result}}

CREATE TABLE training_result (
  run_id TEXT NOT NULL REFERENCES assessment_run (id),
  enrolment_id TEXT NOT NULL REFERENCES enrolment (id),
  scoring_point TEXT NOT NULL REFERENCES scoring_point (code),
  mean DOUBLE PRECISION NOT NULL,
  variance DOUBLE PRECISION NOT NULL,
  rater_count BIGINT NOT NULL,
  missing_count BIGINT NOT NULL,
  flags TEXT NOT NULL,
  PRIMARY KEY (run_id, enrolment_id, scoring_point)
);
CREATE INDEX training_result_enrolment ON training_result (enrolment_id);
{{append_only training_result}}

CREATE TABLE training_group_result (
  run_id TEXT NOT NULL REFERENCES assessment_run (id),
  group_id TEXT NOT NULL REFERENCES training_group (id),
  scoring_point TEXT NOT NULL REFERENCES scoring_point (code),
  trainee_count BIGINT NOT NULL,
  mean DOUBLE PRECISION NOT NULL,
  variance_n DOUBLE PRECISION NOT NULL,
  variance_n_minus_1 DOUBLE PRECISION,
  flags TEXT NOT NULL,
  PRIMARY KEY (run_id, group_id, scoring_point)
);
CREATE INDEX training_group_result_group ON training_group_result (group_id);
{{append_only training_group_result}}
