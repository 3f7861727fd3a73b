-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: rubrics with revisions, assignments, drafts, sheet rows, release of marks
-- compatible_from: 1

CREATE TABLE rubric (
  id TEXT PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);

-- Never changes: editing a rubric makes the next revision, and old sheets keep theirs.
CREATE TABLE rubric_revision (
  id TEXT PRIMARY KEY,
  rubric_id TEXT NOT NULL REFERENCES rubric (id),
  number BIGINT NOT NULL CHECK (number >= 1),
  note TEXT NOT NULL,
  scale_lo_steps BIGINT NOT NULL,
  scale_hi_steps BIGINT NOT NULL,
  steps_per_point BIGINT NOT NULL CHECK (steps_per_point >= 1),
  created_by TEXT NOT NULL,
  created_utc_us BIGINT NOT NULL,
  UNIQUE (rubric_id, number)
);
{{append_only rubric_revision}}

CREATE TABLE rubric_row (
  revision_id TEXT NOT NULL REFERENCES rubric_revision (id),
  row_code TEXT NOT NULL,
  position BIGINT NOT NULL,
  label TEXT NOT NULL,
  scale_lo_steps BIGINT NOT NULL,
  scale_hi_steps BIGINT NOT NULL,
  steps_per_point BIGINT NOT NULL CHECK (steps_per_point >= 1),
  PRIMARY KEY (revision_id, row_code)
);
{{append_only rubric_row}}

CREATE TABLE rubric_anchor (
  revision_id TEXT NOT NULL,
  row_code TEXT NOT NULL,
  score_steps BIGINT NOT NULL,
  meaning TEXT NOT NULL,
  PRIMARY KEY (revision_id, row_code, score_steps),
  FOREIGN KEY (revision_id, row_code) REFERENCES rubric_row (revision_id, row_code)
);
{{append_only rubric_anchor}}

-- One rater is asked for one sheet. The rater sees the case label only: no name, group or stage.
CREATE TABLE assignment (
  id TEXT PRIMARY KEY,
  rater_id TEXT NOT NULL REFERENCES rater (person_id),
  enrolment_id TEXT NOT NULL REFERENCES enrolment (id),
  scoring_point TEXT NOT NULL REFERENCES scoring_point (code),
  trial_id TEXT REFERENCES trial (id),
  rubric_revision_id TEXT NOT NULL REFERENCES rubric_revision (id),
  case_label TEXT NOT NULL,
  position BIGINT NOT NULL,
  due_utc_us BIGINT,
  assigned_by TEXT NOT NULL,
  assigned_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  UNIQUE (rater_id, enrolment_id, scoring_point),
  UNIQUE (rater_id, case_label)
);
CREATE INDEX assignment_enrolment ON assignment (enrolment_id, scoring_point);
CREATE INDEX assignment_trial ON assignment (trial_id);
CREATE INDEX assignment_rubric ON assignment (rubric_revision_id);
{{append_only assignment}}

CREATE TABLE assignment_withdrawal (
  assignment_id TEXT PRIMARY KEY REFERENCES assignment (id),
  reason TEXT NOT NULL,
  withdrawn_by TEXT NOT NULL,
  withdrawn_utc_us BIGINT NOT NULL
);
{{append_only assignment_withdrawal}}

-- The unfinished sheet, saved on each keystroke; deleted when it is submitted.
CREATE TABLE mark_draft (
  assignment_id TEXT PRIMARY KEY REFERENCES assignment (id),
  revision BIGINT NOT NULL,
  overall_steps BIGINT,
  not_assessable_reason TEXT,
  comment TEXT,
  changed_utc_us BIGINT NOT NULL
);

CREATE TABLE mark_draft_row (
  assignment_id TEXT NOT NULL REFERENCES mark_draft (assignment_id),
  row_code TEXT NOT NULL,
  score_steps BIGINT,
  not_assessable_reason TEXT,
  PRIMARY KEY (assignment_id, row_code)
);

ALTER TABLE training_mark ADD COLUMN assignment_id TEXT REFERENCES assignment (id);
CREATE INDEX training_mark_assignment ON training_mark (assignment_id);
CREATE INDEX training_mark_trial ON training_mark (trial_id);

CREATE TABLE training_mark_row (
  mark_id TEXT NOT NULL REFERENCES training_mark (id),
  revision_id TEXT NOT NULL,
  row_code TEXT NOT NULL,
  score_steps BIGINT,
  not_assessable_reason TEXT,
  PRIMARY KEY (mark_id, row_code),
  CHECK ((score_steps IS NULL) = (not_assessable_reason IS NOT NULL)),
  FOREIGN KEY (revision_id, row_code) REFERENCES rubric_row (revision_id, row_code)
);
{{append_only training_mark_row}}

-- Marks of a cohort at a scoring point shown to trainees, or taken back; the newest row counts.
CREATE TABLE mark_release (
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  scoring_point TEXT NOT NULL REFERENCES scoring_point (code),
  sequence BIGINT NOT NULL,
  released BOOLEAN NOT NULL,
  reason TEXT NOT NULL,
  decided_by TEXT NOT NULL,
  decided_utc_us BIGINT NOT NULL,
  PRIMARY KEY (cohort_id, scoring_point, sequence)
);
{{append_only mark_release}}
