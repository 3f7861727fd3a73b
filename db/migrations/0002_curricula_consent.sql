-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: curricula with versions, arms, phases and scoring points; consent; exposure, rest, deviations
-- compatible_from: 1

CREATE TABLE curriculum (
  id TEXT PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  description TEXT NOT NULL,
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);

-- What is being written, before it becomes a version. One a curriculum; revision counts the saves.
CREATE TABLE curriculum_draft (
  curriculum_id TEXT PRIMARY KEY REFERENCES curriculum (id),
  revision BIGINT NOT NULL,
  content_json TEXT NOT NULL,
  changed_by TEXT NOT NULL,
  changed_utc_us BIGINT NOT NULL
);

-- A version and all that hangs on it never changes; only its state moves on, in curriculum_state.
CREATE TABLE curriculum_version (
  id TEXT PRIMARY KEY,
  curriculum_id TEXT NOT NULL REFERENCES curriculum (id),
  number BIGINT NOT NULL CHECK (number >= 1),
  note TEXT NOT NULL,
  created_utc_us BIGINT NOT NULL,
  UNIQUE (curriculum_id, number)
);
{{append_only curriculum_version}}

CREATE TABLE curriculum_state (
  version_id TEXT NOT NULL REFERENCES curriculum_version (id),
  sequence BIGINT NOT NULL,
  state TEXT NOT NULL CHECK (state IN ('draft', 'running', 'closed')),
  changed_by TEXT NOT NULL,
  changed_utc_us BIGINT NOT NULL,
  PRIMARY KEY (version_id, sequence)
);
{{append_only curriculum_state}}

CREATE TABLE module (
  id TEXT PRIMARY KEY,
  version_id TEXT NOT NULL REFERENCES curriculum_version (id),
  position BIGINT NOT NULL,
  code TEXT NOT NULL,
  title TEXT NOT NULL,
  scene_id TEXT NOT NULL,
  pattern_id TEXT NOT NULL,
  exercise_kind TEXT NOT NULL,
  mode TEXT NOT NULL CHECK (mode IN ('practice', 'graded')),
  target_angle_rad DOUBLE PRECISION NOT NULL,
  tolerance_rad DOUBLE PRECISION NOT NULL CHECK (tolerance_rad > 0),
  hold_us BIGINT NOT NULL,
  max_force_n DOUBLE PRECISION,
  max_torque_nm DOUBLE PRECISION,
  attempt_limit BIGINT CHECK (attempt_limit >= 1),
  UNIQUE (version_id, code)
);
{{append_only module}}

CREATE TABLE module_prerequisite (
  module_id TEXT NOT NULL REFERENCES module (id),
  requires_module_id TEXT NOT NULL REFERENCES module (id),
  PRIMARY KEY (module_id, requires_module_id),
  CHECK (module_id <> requires_module_id)
);
CREATE INDEX module_prerequisite_requires ON module_prerequisite (requires_module_id);
{{append_only module_prerequisite}}

-- Mastered: the metric reached the threshold in so many attempts in a row.
CREATE TABLE mastery_rule (
  module_id TEXT NOT NULL REFERENCES module (id),
  metric TEXT NOT NULL,
  comparison TEXT NOT NULL CHECK (comparison IN ('at_least', 'at_most')),
  threshold DOUBLE PRECISION NOT NULL,
  unit TEXT NOT NULL,
  consecutive BIGINT NOT NULL CHECK (consecutive >= 1),
  PRIMARY KEY (module_id, metric)
);
{{append_only mastery_rule}}

CREATE TABLE curriculum_arm (
  id TEXT PRIMARY KEY,
  version_id TEXT NOT NULL REFERENCES curriculum_version (id),
  number BIGINT NOT NULL,
  code TEXT NOT NULL,
  label TEXT NOT NULL,
  rest_allowance_us BIGINT NOT NULL CHECK (rest_allowance_us >= 0),
  rest_splittable BOOLEAN NOT NULL,
  UNIQUE (version_id, number),
  UNIQUE (version_id, code)
);
{{append_only curriculum_arm}}

CREATE TABLE curriculum_phase (
  id TEXT PRIMARY KEY,
  arm_id TEXT NOT NULL REFERENCES curriculum_arm (id),
  position BIGINT NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('virtual', 'real')),
  label TEXT NOT NULL,
  duration_us BIGINT NOT NULL CHECK (duration_us > 0),
  module_id TEXT REFERENCES module (id),
  UNIQUE (arm_id, position)
);
CREATE INDEX curriculum_phase_module ON curriculum_phase (module_id);
{{append_only curriculum_phase}}

-- When marks are taken: after so much exposure (0: before training).
CREATE TABLE curriculum_scoring_point (
  version_id TEXT NOT NULL REFERENCES curriculum_version (id),
  scoring_point TEXT NOT NULL REFERENCES scoring_point (code),
  after_exposure_us BIGINT NOT NULL CHECK (after_exposure_us >= 0),
  PRIMARY KEY (version_id, scoring_point)
);
{{append_only curriculum_scoring_point}}

ALTER TABLE cohort ADD COLUMN curriculum_version_id TEXT REFERENCES curriculum_version (id);
ALTER TABLE training_group ADD COLUMN arm_id TEXT REFERENCES curriculum_arm (id);
ALTER TABLE trial ADD COLUMN module_id TEXT REFERENCES module (id);
ALTER TABLE trial ADD COLUMN phase_id TEXT REFERENCES curriculum_phase (id);
CREATE INDEX trial_module ON trial (module_id);

-- Time on the virtual or real arm, as it was spent: the dose of the study.
CREATE TABLE exposure (
  id TEXT PRIMARY KEY,
  enrolment_id TEXT NOT NULL REFERENCES enrolment (id),
  phase_id TEXT REFERENCES curriculum_phase (id),
  kind TEXT NOT NULL CHECK (kind IN ('virtual', 'real', 'rest')),
  started_utc_us BIGINT NOT NULL,
  duration_us BIGINT NOT NULL CHECK (duration_us >= 0),
  recorded_by TEXT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
CREATE INDEX exposure_enrolment ON exposure (enrolment_id, started_utc_us);
{{append_only exposure}}

CREATE TABLE deviation (
  id TEXT PRIMARY KEY,
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  enrolment_id TEXT REFERENCES enrolment (id),
  kind TEXT NOT NULL,
  description TEXT,
  happened_utc_us BIGINT NOT NULL,
  reported_by TEXT NOT NULL,
  reported_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
CREATE INDEX deviation_cohort ON deviation (cohort_id, happened_utc_us);
CREATE INDEX deviation_enrolment ON deviation (enrolment_id);
{{append_only deviation}}

-- Given or withdrawn, per purpose; the newest row of a person and purpose counts.
CREATE TABLE consent (
  person_id TEXT NOT NULL REFERENCES person (id),
  purpose TEXT NOT NULL CHECK (purpose IN ('training_record', 'video', 'research', 'xapi_export', 'teaching')),
  sequence BIGINT NOT NULL,
  granted BOOLEAN NOT NULL,
  text_version TEXT NOT NULL,
  decided_utc_us BIGINT NOT NULL,
  recorded_by TEXT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  PRIMARY KEY (person_id, purpose, sequence)
);
{{append_only consent}}
