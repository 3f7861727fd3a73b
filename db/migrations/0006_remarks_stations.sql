-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: where a trial belongs and ran; remarks, self-scores, warm-up, alignment, frozen data, stations, holds
-- compatible_from: 1

-- Practice or graded as it counted then, whatever the module says later; null for free practice. The machine that
-- recorded: what a late tick is explained by.
ALTER TABLE trial ADD COLUMN attempt_mode TEXT CHECK (attempt_mode IN ('practice', 'graded'));
ALTER TABLE trial ADD COLUMN host_name TEXT;
ALTER TABLE trial ADD COLUMN host_os TEXT;
ALTER TABLE trial ADD COLUMN host_cpu TEXT;
ALTER TABLE trial ADD COLUMN host_gpu TEXT;
CREATE INDEX trial_phase ON trial (phase_id);

-- What a trainee or an expert wrote at a time of a trial. The author is a user or a person; the person, when there is
-- one, also in a column of its own. A reply may be stored in one transaction with what it answers.
CREATE TABLE trial_remark (
  id TEXT PRIMARY KEY,
  trial_id TEXT NOT NULL REFERENCES trial (id),
  author TEXT NOT NULL,
  author_person_id TEXT REFERENCES person (id),
  purpose TEXT NOT NULL CHECK (purpose IN ('bookmark', 'remark', 'reply')),
  reply_to TEXT REFERENCES trial_remark (id) DEFERRABLE INITIALLY DEFERRED,
  tick BIGINT NOT NULL CHECK (tick >= 0),
  time_us BIGINT NOT NULL CHECK (time_us >= 0),
  text TEXT,
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  CHECK ((purpose = 'reply') = (reply_to IS NOT NULL))
);
CREATE INDEX trial_remark_trial ON trial_remark (trial_id, time_us);
CREATE INDEX trial_remark_author_person ON trial_remark (author_person_id);
CREATE INDEX trial_remark_reply_to ON trial_remark (reply_to);
{{append_only trial_remark}}

CREATE TABLE remark_receipt (
  remark_id TEXT NOT NULL REFERENCES trial_remark (id),
  reader TEXT NOT NULL,
  reader_person_id TEXT REFERENCES person (id),
  read_utc_us BIGINT NOT NULL,
  PRIMARY KEY (remark_id, reader)
);
CREATE INDEX remark_receipt_reader_person ON remark_receipt (reader_person_id);
{{append_only remark_receipt}}

-- The trainee's own sheet about a trial, before the raters' marks are shown. A change of mind is the next version.
CREATE TABLE self_score (
  id TEXT PRIMARY KEY,
  trial_id TEXT NOT NULL REFERENCES trial (id),
  trainee_id TEXT NOT NULL REFERENCES trainee (person_id),
  version BIGINT NOT NULL CHECK (version >= 1),
  rubric_revision_id TEXT REFERENCES rubric_revision (id),
  score_steps BIGINT NOT NULL,
  scale_lo_steps BIGINT NOT NULL,
  scale_hi_steps BIGINT NOT NULL,
  steps_per_point BIGINT NOT NULL CHECK (steps_per_point >= 1),
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  UNIQUE (trial_id, trainee_id, version),
  CHECK (score_steps BETWEEN scale_lo_steps AND scale_hi_steps)
);
CREATE INDEX self_score_trainee ON self_score (trainee_id, created_utc_us);
CREATE INDEX self_score_rubric ON self_score (rubric_revision_id);
{{append_only self_score}}

CREATE TABLE self_score_row (
  self_score_id TEXT NOT NULL REFERENCES self_score (id),
  revision_id TEXT NOT NULL,
  row_code TEXT NOT NULL,
  score_steps BIGINT NOT NULL,
  PRIMARY KEY (self_score_id, row_code),
  FOREIGN KEY (revision_id, row_code) REFERENCES rubric_row (revision_id, row_code)
);
CREATE INDEX self_score_row_rubric ON self_score_row (revision_id, row_code);
{{append_only self_score_row}}

-- A rater's score of a reference trial before the real ones, and how far it lies from the panel (rater minus panel).
CREATE TABLE rater_warmup (
  id TEXT PRIMARY KEY,
  rater_id TEXT NOT NULL REFERENCES rater (person_id),
  reference_trial_id TEXT NOT NULL REFERENCES trial (id),
  rubric_revision_id TEXT REFERENCES rubric_revision (id),
  score_steps BIGINT NOT NULL,
  scale_lo_steps BIGINT NOT NULL,
  scale_hi_steps BIGINT NOT NULL,
  steps_per_point BIGINT NOT NULL CHECK (steps_per_point >= 1),
  panel_offset_steps DOUBLE PRECISION NOT NULL,
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  CHECK (score_steps BETWEEN scale_lo_steps AND scale_hi_steps)
);
CREATE INDEX rater_warmup_rater ON rater_warmup (rater_id, created_utc_us);
CREATE INDEX rater_warmup_trial ON rater_warmup (reference_trial_id);
CREATE INDEX rater_warmup_rubric ON rater_warmup (rubric_revision_id);
{{append_only rater_warmup}}

-- What was done about a mark that lies apart: the rater keeps it, moves it (a new version of the mark), or a third
-- rater is asked. The newest row counts.
CREATE TABLE alignment_decision (
  assignment_id TEXT NOT NULL REFERENCES assignment (id),
  sequence BIGINT NOT NULL CHECK (sequence >= 1),
  decision TEXT NOT NULL CHECK (decision IN ('keep', 'move', 'third')),
  reason TEXT NOT NULL,
  decided_by TEXT NOT NULL,
  decided_utc_us BIGINT NOT NULL,
  PRIMARY KEY (assignment_id, sequence)
);
{{append_only alignment_decision}}

-- A named state of a cohort's data: what went into it stands in the manifest, the hash is over all of it.
CREATE TABLE frozen_dataset (
  id TEXT PRIMARY KEY,
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  name TEXT NOT NULL UNIQUE,
  content_hash TEXT NOT NULL,
  manifest_json TEXT NOT NULL,
  created_by TEXT NOT NULL,
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
CREATE INDEX frozen_dataset_cohort ON frozen_dataset (cohort_id, created_utc_us);
{{append_only frozen_dataset}}

-- What each station does now; overwritten with every sign of life.
CREATE TABLE station_state (
  station TEXT PRIMARY KEY,
  trial_id TEXT REFERENCES trial (id),
  user_id TEXT,
  software_version TEXT NOT NULL,
  heartbeat_utc_us BIGINT NOT NULL
);
CREATE INDEX station_state_trial ON station_state (trial_id);

-- Review of what is due for erasing: locked (until null: for good) or kept longer, with the reason; the newest counts.
CREATE TABLE retention_hold (
  person_id TEXT NOT NULL REFERENCES person (id),
  sequence BIGINT NOT NULL CHECK (sequence >= 1),
  kind TEXT NOT NULL CHECK (kind IN ('lock', 'extend', 'release')),
  until_utc_us BIGINT,
  reason TEXT NOT NULL,
  decided_by TEXT NOT NULL,
  decided_utc_us BIGINT NOT NULL,
  PRIMARY KEY (person_id, sequence),
  CHECK ((kind = 'extend') = (until_utc_us IS NOT NULL))
);
{{append_only retention_hold}}
