-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: the first released schema
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

-- People: the coded record, the identity apart from it; consent, how long a record is kept, what an erase leaves.

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

-- Rosters that were imported: a wrong one can be taken back whole while nothing hangs on its people.
CREATE TABLE roster_import (
  id TEXT PRIMARY KEY,
  kind TEXT NOT NULL CHECK (kind IN ('trainees', 'raters')),
  imported_by TEXT NOT NULL,
  imported_utc_us BIGINT NOT NULL,
  added BIGINT NOT NULL,
  changed BIGINT NOT NULL,
  taken_back_utc_us BIGINT
);
{{frozen roster_import kind}}
{{frozen roster_import imported_by}}
{{frozen roster_import imported_utc_us}}
{{frozen roster_import added}}
{{frozen roster_import changed}}

-- What the roster said before and says since; before_json is null for people whom the import added.
CREATE TABLE roster_import_person (
  person_id TEXT NOT NULL REFERENCES person (id),
  import_id TEXT NOT NULL REFERENCES roster_import (id),
  before_json TEXT,
  after_json TEXT NOT NULL,
  PRIMARY KEY (person_id, import_id)
);
CREATE INDEX roster_import_person_import ON roster_import_person (import_id);

-- What people are asked to agree to. The first five mean something to the program; a centre may add its own.
CREATE TABLE consent_purpose (
  code TEXT PRIMARY KEY,
  position BIGINT NOT NULL
);
INSERT INTO consent_purpose (code, position) VALUES
  ('training_record', 1), ('video', 2), ('research', 3), ('xapi_export', 4), ('teaching', 5);

-- The centre's own words; without a version those that ship are shown. Never changes: editing makes the next one.
CREATE TABLE consent_version (
  id TEXT PRIMARY KEY,
  number BIGINT NOT NULL UNIQUE CHECK (number >= 1),
  note TEXT NOT NULL,
  published_by TEXT NOT NULL,
  published_utc_us BIGINT NOT NULL
);
{{append_only consent_version}}

CREATE TABLE consent_text (
  version_id TEXT NOT NULL REFERENCES consent_version (id),
  language TEXT NOT NULL,
  purpose TEXT NOT NULL REFERENCES consent_purpose (code),
  position BIGINT NOT NULL,
  title TEXT NOT NULL,
  words TEXT NOT NULL,
  PRIMARY KEY (version_id, language, purpose)
);
CREATE INDEX consent_text_purpose ON consent_text (purpose);
{{append_only consent_text}}

-- Given or withdrawn, per purpose; the newest row of a person and purpose counts. signed_utc_us: on paper.
CREATE TABLE consent (
  person_id TEXT NOT NULL REFERENCES person (id),
  purpose TEXT NOT NULL REFERENCES consent_purpose (code),
  sequence BIGINT NOT NULL,
  granted BOOLEAN NOT NULL,
  text_version TEXT NOT NULL,
  decided_utc_us BIGINT NOT NULL,
  recorded_by TEXT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  form TEXT NOT NULL CHECK (form IN ('screen', 'paper')),
  signed_utc_us BIGINT,
  PRIMARY KEY (person_id, purpose, sequence),
  CHECK ((form = 'paper') = (signed_utc_us IS NOT NULL))
);
CREATE INDEX consent_purpose_code ON consent (purpose);
{{append_only consent}}

CREATE TABLE retention_rule (
  category TEXT PRIMARY KEY,
  keep_days BIGINT NOT NULL CHECK (keep_days >= 1),
  basis TEXT NOT NULL,
  changed_utc_us BIGINT NOT NULL
);

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

-- What is left of an erased person besides the coded row: that it happened, when and why. The gate
-- opens it, so that the tombstone of a simulated person goes with the demonstration data.
CREATE TABLE erasure (
  person_id TEXT PRIMARY KEY REFERENCES person (id),
  requested_by TEXT NOT NULL,
  reason TEXT NOT NULL,
  erased_utc_us BIGINT NOT NULL
);
{{append_only erasure}}

-- Where the record, or all about one person (person_id), was copied to, so that an erase can say who still holds it.
-- gone_utc_us: when it was seen to be there no more.
CREATE TABLE record_copy (
  id TEXT PRIMARY KEY,
  kind TEXT NOT NULL CHECK (kind IN ('backup', 'before_restore', 'before_schema', 'package', 'moved')),
  place TEXT NOT NULL,
  station TEXT NOT NULL,
  person_id TEXT REFERENCES person (id),
  made_utc_us BIGINT NOT NULL,
  gone_utc_us BIGINT
);
CREATE INDEX record_copy_person ON record_copy (person_id);

-- Who may sign in and do what; the audit trail.

CREATE TABLE role (
  code TEXT PRIMARY KEY,
  label TEXT NOT NULL
);
INSERT INTO role (code, label) VALUES
  ('trainee', 'trainee'),
  ('rater', 'physician who scores'),
  ('administrator', 'administrator'),
  ('allocator', 'keeper of the allocation'),
  ('statistician', 'statistician');

CREATE TABLE operation (
  code TEXT PRIMARY KEY,
  label TEXT NOT NULL
);
INSERT INTO operation (code, label) VALUES
  ('practice', 'practise without a record'),
  ('trial.record_own', 'record own trials'),
  ('trial.view_own', 'replay own trials'),
  ('trial.view_assigned', 'replay assigned trials, blinded'),
  ('trial.view_coded', 'see trials under their codes'),
  ('mark.view_own', 'see own released marks'),
  ('mark.submit', 'submit and amend own sheets'),
  ('mark.view_coded', 'see all marks under codes'),
  ('mark.release', 'release and take back marks'),
  ('evaluation.submit', 'score models in an evaluation'),
  ('evaluation.setup', 'set up an evaluation'),
  ('person.view_coded', 'see the coded record of people'),
  ('person.view_identity', 'see names'),
  ('person.edit', 'enter, import and change people'),
  ('person.export', 'export all about one person'),
  ('person.erase', 'erase a person'),
  ('consent.record', 'record consent'),
  ('curriculum.edit', 'write curricula and rubrics'),
  ('study.setup', 'set up cohorts, groups and assignments'),
  ('study.enrol', 'enrol people'),
  ('allocation.run', 'fix the design and allocate'),
  ('allocation.view', 'see who is in which group'),
  ('allocation.reveal', 'reveal the seed'),
  ('results.compute', 'compute and freeze results'),
  ('report.export_coded', 'export coded reports and data'),
  ('report.export_named', 'export reports with names'),
  ('user.manage', 'manage users and roles'),
  ('audit.view', 'read and verify the audit trail'),
  ('database.backup', 'back up and check the database'),
  ('database.restore', 'restore or move the database'),
  ('retention.manage', 'review retention'),
  ('settings.edit', 'change settings of the centre');

-- Whoever has no row here may not. A person may hold several roles.
CREATE TABLE role_operation (
  role_code TEXT NOT NULL REFERENCES role (code),
  operation_code TEXT NOT NULL REFERENCES operation (code),
  PRIMARY KEY (role_code, operation_code)
);
CREATE INDEX role_operation_operation ON role_operation (operation_code);
INSERT INTO role_operation (role_code, operation_code) VALUES
  ('trainee', 'practice'),
  ('trainee', 'trial.record_own'),
  ('trainee', 'trial.view_own'),
  ('trainee', 'mark.view_own'),
  ('trainee', 'evaluation.submit'),
  ('rater', 'practice'),
  ('rater', 'trial.view_assigned'),
  ('rater', 'mark.submit'),
  ('rater', 'evaluation.submit'),
  ('administrator', 'practice'),
  ('administrator', 'trial.view_coded'),
  ('administrator', 'mark.release'),
  ('administrator', 'evaluation.setup'),
  ('administrator', 'person.view_coded'),
  ('administrator', 'person.view_identity'),
  ('administrator', 'person.edit'),
  ('administrator', 'person.export'),
  ('administrator', 'person.erase'),
  ('administrator', 'consent.record'),
  ('administrator', 'curriculum.edit'),
  ('administrator', 'study.setup'),
  ('administrator', 'study.enrol'),
  ('administrator', 'allocation.view'),
  ('administrator', 'results.compute'),
  ('administrator', 'report.export_coded'),
  ('administrator', 'report.export_named'),
  ('administrator', 'user.manage'),
  ('administrator', 'audit.view'),
  ('administrator', 'database.backup'),
  ('administrator', 'database.restore'),
  ('administrator', 'retention.manage'),
  ('administrator', 'settings.edit'),
  ('allocator', 'person.view_coded'),
  ('allocator', 'allocation.run'),
  ('allocator', 'allocation.view'),
  ('allocator', 'allocation.reveal'),
  ('statistician', 'trial.view_coded'),
  ('statistician', 'mark.view_coded'),
  ('statistician', 'person.view_coded'),
  ('statistician', 'allocation.view'),
  ('statistician', 'results.compute'),
  ('statistician', 'report.export_coded'),
  ('statistician', 'audit.view');

CREATE TABLE app_user (
  id TEXT PRIMARY KEY,
  login TEXT NOT NULL UNIQUE,
  person_id TEXT REFERENCES person (id),
  password_hash TEXT NOT NULL,
  must_change_password BOOLEAN NOT NULL,
  pin_hash TEXT,
  state TEXT NOT NULL CHECK (state IN ('active', 'disabled')),
  failed_count BIGINT NOT NULL,
  locked_until_utc_us BIGINT NOT NULL,
  sessions_ended BIGINT, -- how often all that was open in browsers was ended; null: never
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL
);
CREATE INDEX app_user_person ON app_user (person_id);

CREATE TABLE user_role (
  user_id TEXT NOT NULL REFERENCES app_user (id),
  role_code TEXT NOT NULL REFERENCES role (code),
  PRIMARY KEY (user_id, role_code)
);
CREATE INDEX user_role_role ON user_role (role_code);

-- Failures to sign in under names that nobody has, so that they are answered as those of a known name. By sixteen bits
-- of a hash of what was typed: a password in the wrong field cannot be found from it.
CREATE TABLE sign_in_failure (
  bucket BIGINT PRIMARY KEY CHECK (bucket BETWEEN 0 AND 65535),
  failed_count BIGINT NOT NULL,
  locked_until_utc_us BIGINT NOT NULL
);

-- Codes on the cards of trainees, with which a kiosk lets them in while the centre allows it. Only a hash is kept.
CREATE TABLE kiosk_code (
  id TEXT PRIMARY KEY,
  user_id TEXT NOT NULL REFERENCES app_user (id),
  code_hash TEXT NOT NULL UNIQUE,
  made_utc_us BIGINT NOT NULL,
  revoked_utc_us BIGINT
);
CREATE INDEX kiosk_code_user ON kiosk_code (user_id);
{{frozen kiosk_code user_id}}
{{frozen kiosk_code code_hash}}

-- Links with which somebody sets a password in a browser, each good once and until it expires. Only a hash of what a link
-- says is kept.
CREATE TABLE invitation (
  id TEXT PRIMARY KEY,
  user_id TEXT NOT NULL REFERENCES app_user (id),
  token_hash TEXT NOT NULL UNIQUE,
  made_utc_us BIGINT NOT NULL,
  expires_utc_us BIGINT NOT NULL CHECK (expires_utc_us > made_utc_us),
  state TEXT NOT NULL CHECK (state IN ('open', 'used', 'revoked'))
);
CREATE INDEX invitation_user ON invitation (user_id);
{{frozen invitation user_id}}
{{frozen invitation token_hash}}
{{frozen invitation made_utc_us}}
{{frozen invitation expires_utc_us}}

-- What somebody asked for about their own record: a copy of everything, or that it be erased.
CREATE TABLE person_request (
  id TEXT PRIMARY KEY,
  person_id TEXT NOT NULL REFERENCES person (id),
  kind TEXT NOT NULL CHECK (kind IN ('export', 'erase')),
  asked_utc_us BIGINT NOT NULL,
  answer TEXT CHECK (answer IN ('done', 'declined', 'taken_back')),
  answer_reason TEXT,
  answered_utc_us BIGINT,
  CHECK ((answer IS NULL) = (answered_utc_us IS NULL))
);
CREATE INDEX person_request_person ON person_request (person_id);
{{frozen person_request person_id}}
{{frozen person_request kind}}
{{frozen person_request asked_utc_us}}

-- Acts that need two people: one asks, another one does it or refuses. subject: the id of a user, person or design,
-- the hash of a backup.
CREATE TABLE duty_request (
  id TEXT PRIMARY KEY,
  act TEXT NOT NULL CHECK (act IN ('reset_password', 'grant_roles', 'erase', 'restore', 'reveal_allocation',
    'one_person', 'invite')),
  subject TEXT NOT NULL,
  detail_json TEXT NOT NULL,
  reason TEXT NOT NULL,
  requested_by TEXT NOT NULL,
  requested_utc_us BIGINT NOT NULL
);
CREATE INDEX duty_request_time ON duty_request (requested_utc_us);
{{append_only duty_request}}

CREATE TABLE duty_decision (
  request_id TEXT PRIMARY KEY REFERENCES duty_request (id),
  decision TEXT NOT NULL CHECK (decision IN ('confirmed', 'refused', 'withdrawn')),
  decided_by TEXT NOT NULL,
  decided_utc_us BIGINT NOT NULL
);
{{append_only duty_decision}}

-- What somebody signed with the password: a mark, a frozen data set; what the signature means, and why.
CREATE TABLE signature (
  object_kind TEXT NOT NULL CHECK (object_kind IN ('training_mark', 'evaluation_mark', 'frozen_dataset')),
  object_id TEXT NOT NULL,
  user_id TEXT NOT NULL,
  person_id TEXT REFERENCES person (id),
  meaning TEXT NOT NULL CHECK (meaning IN ('scored', 'amended', 'froze')),
  reason TEXT NOT NULL,
  signed_utc_us BIGINT NOT NULL,
  password_shown_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  PRIMARY KEY (object_kind, object_id)
);
CREATE INDEX signature_person ON signature (person_id);
{{append_only signature}}

-- Who, when, where, what, old, new, why; each row carries the hash of the row before. Ids and codes only, never a
-- name, so that it may stay whole when a person is erased. object_hash seals the row that was written.
CREATE TABLE audit_entry (
  sequence BIGINT PRIMARY KEY,
  at_utc_us BIGINT NOT NULL,
  actor TEXT NOT NULL,
  station TEXT NOT NULL,
  action TEXT NOT NULL,
  object_kind TEXT NOT NULL,
  object_id TEXT NOT NULL,
  old_json TEXT NOT NULL,
  new_json TEXT NOT NULL,
  reason TEXT NOT NULL,
  object_hash TEXT NOT NULL,
  previous_hash TEXT NOT NULL,
  entry_hash TEXT NOT NULL
);
CREATE INDEX audit_entry_object ON audit_entry (object_kind, object_id);
CREATE INDEX audit_entry_time ON audit_entry (at_utc_us);
{{immutable audit_entry}}

-- What each transaction made of the rows that a report reads: a hash over the row, sealed by the entry of the trail
-- that the transaction wrote. personal_hash: over what an erase takes, with a salt. No names, so that it stays whole.
CREATE TABLE row_seal (
  entry_sequence BIGINT NOT NULL REFERENCES audit_entry (sequence),
  position BIGINT NOT NULL,
  table_name TEXT NOT NULL,
  row_key TEXT NOT NULL,
  removed BOOLEAN NOT NULL,
  row_hash TEXT NOT NULL,
  personal_hash TEXT NOT NULL,
  simulated BOOLEAN NOT NULL,
  before_hash TEXT NOT NULL, -- both as they were right before the change; empty: the row was added or removed
  PRIMARY KEY (entry_sequence, position)
);
{{immutable row_seal}}

-- The salt of a row's newest personal_hash: replaced with every seal and gone when the row is erased, so that nobody
-- can try out names on the hashes that stay.
CREATE TABLE seal_salt (
  table_name TEXT NOT NULL,
  row_key TEXT NOT NULL,
  salt TEXT NOT NULL,
  PRIMARY KEY (table_name, row_key)
);

-- Curricula.

CREATE TABLE occasion (
  code TEXT PRIMARY KEY,
  label TEXT NOT NULL,
  position BIGINT NOT NULL
);
INSERT INTO occasion (code, label, position) VALUES
  ('pre', 'before training', 1), ('mid', 'after 20 min', 2), ('post', 'after 40 min', 3);

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
  mode TEXT NOT NULL CHECK (mode IN ('practice', 'graded')),
  target_angle_rad DOUBLE PRECISION NOT NULL,
  tolerance_rad DOUBLE PRECISION NOT NULL CHECK (tolerance_rad > 0),
  hold_us BIGINT NOT NULL,
  least_twists BIGINT NOT NULL DEFAULT 1 CHECK (least_twists >= 1),
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

-- By what a trainee is held to be able: an LC-CUSUM over attempts whose two error rates are known. What is registered
-- later counts for those who begin later; without any the design shipped with the program counts. sum_limit: chosen
-- for the other numbers when it was registered. Who registered it stands in the audit trail.
CREATE TABLE competence_design (
  module_id TEXT NOT NULL REFERENCES module (id),
  version BIGINT NOT NULL CHECK (version >= 1),
  registered_utc_us BIGINT NOT NULL,
  tolerance_rad DOUBLE PRECISION NOT NULL CHECK (tolerance_rad > 0),
  tolerance_source TEXT NOT NULL CHECK (tolerance_source IN ('exercise', 'experts', 'chosen')),
  experts BIGINT NOT NULL CHECK (experts >= 0),
  adequate DOUBLE PRECISION NOT NULL CHECK (adequate > 0 AND adequate < inadequate),
  inadequate DOUBLE PRECISION NOT NULL CHECK (inadequate < 1),
  attempts BIGINT NOT NULL CHECK (attempts >= 1),
  false_pass_most DOUBLE PRECISION NOT NULL CHECK (false_pass_most > 0 AND false_pass_most < 1),
  false_fail_most DOUBLE PRECISION NOT NULL CHECK (false_fail_most > 0 AND false_fail_most < 1),
  sum_limit DOUBLE PRECISION NOT NULL CHECK (sum_limit > 0),
  reason TEXT NOT NULL,
  PRIMARY KEY (module_id, version)
);
{{append_only competence_design}}

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
CREATE TABLE curriculum_occasion (
  version_id TEXT NOT NULL REFERENCES curriculum_version (id),
  occasion TEXT NOT NULL REFERENCES occasion (code),
  after_exposure_us BIGINT NOT NULL CHECK (after_exposure_us >= 0),
  PRIMARY KEY (version_id, occasion)
);
{{append_only curriculum_occasion}}

-- The training study.

CREATE TABLE cohort (
  id TEXT PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,
  description TEXT NOT NULL,
  created_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  curriculum_version_id TEXT REFERENCES curriculum_version (id),
  equivalence_margin DOUBLE PRECISION CHECK (equivalence_margin > 0)
);

-- Decided by hand; without a row a cohort is a draft until somebody is allocated or trains.
CREATE TABLE cohort_state (
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  sequence BIGINT NOT NULL CHECK (sequence >= 1),
  state TEXT NOT NULL CHECK (state IN ('running', 'closed', 'archived')),
  reason TEXT NOT NULL,
  changed_by TEXT NOT NULL,
  changed_utc_us BIGINT NOT NULL,
  PRIMARY KEY (cohort_id, sequence)
);
{{append_only cohort_state}}

CREATE TABLE training_group (
  id TEXT PRIMARY KEY,
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  number BIGINT NOT NULL,
  code TEXT NOT NULL,
  label TEXT NOT NULL,
  arm_id TEXT REFERENCES curriculum_arm (id),
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

-- The seed lies apart from the design, so that who may read the design need not see it before the end. salt: 256
-- random bits without which no seed can be guessed from the commitment.
CREATE TABLE allocation_seed (
  design_id TEXT PRIMARY KEY REFERENCES allocation_design (id),
  seed TEXT NOT NULL,
  salt TEXT NOT NULL,
  revealed_utc_us BIGINT
);
{{frozen allocation_seed seed}}
{{frozen allocation_seed salt}}

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

-- Trials, what was measured on them and said about them, and the stations that record them.

-- A trial without a row in trial_end is running or was interrupted. attempt_mode: practice or graded as it counted
-- then, whatever the module says later; null for free practice. host_*: the machine that recorded, what a late tick is
-- explained by. The scene 'foreign' is that of recordings of other equipment: no model answered, so there is none.
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
  demonstration BOOLEAN NOT NULL,
  tissue_model TEXT CHECK (tissue_model IN ('twist', 'fem', 'msm')),
  module_id TEXT REFERENCES module (id),
  phase_id TEXT REFERENCES curriculum_phase (id),
  attempt_mode TEXT CHECK (attempt_mode IN ('practice', 'graded')),
  host_name TEXT,
  host_os TEXT,
  host_cpu TEXT,
  host_gpu TEXT,
  CHECK ((tissue_model IS NULL) = (scene_id = 'foreign'))
);
CREATE INDEX trial_newest ON trial (started_utc_us, id);
CREATE INDEX trial_station ON trial (station, started_utc_us);
CREATE INDEX trial_trainee_started ON trial (trainee_id, started_utc_us);
CREATE INDEX trial_enrolment ON trial (enrolment_id);
CREATE INDEX trial_module ON trial (module_id);
CREATE INDEX trial_phase ON trial (phase_id);
CREATE INDEX trial_demonstration ON trial (id) WHERE demonstration = TRUE;
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

-- How the machine kept the servo's time: null of a trial that did not run in real time.
CREATE TABLE trial_end (
  trial_id TEXT PRIMARY KEY REFERENCES trial (id),
  sample_count BIGINT NOT NULL,
  refused_samples BIGINT NOT NULL,
  late_ticks BIGINT NOT NULL,
  real_time_priority BOOLEAN,
  memory_locked BOOLEAN,
  skipped_ticks BIGINT,
  force_cuts BIGINT,
  outcome TEXT NOT NULL CHECK (outcome IN ('completed', 'interrupted')),
  content_hash TEXT NOT NULL,
  ended_utc_us BIGINT NOT NULL
);
{{append_only trial_end}}

-- One row a trial, version of the formulas and rules of the exercise (a limit below 0: none): judgement beside the
-- samples, never in their place. A newer version adds a row. attempts: for each completed twist in its order the
-- absolute error in degrees (8 bytes, little-endian double) and whether it was on target (1 byte). measures: for each
-- metric the length of its id (1 byte), the id, and its value (8 bytes).
CREATE TABLE trial_digest (
  trial_id TEXT NOT NULL REFERENCES trial (id),
  formula_version BIGINT NOT NULL,
  tolerance_rad DOUBLE PRECISION NOT NULL,
  force_limit_n DOUBLE PRECISION NOT NULL,
  torque_limit_nm DOUBLE PRECISION NOT NULL,
  content_hash TEXT NOT NULL,
  model TEXT NOT NULL,
  duration_us BIGINT NOT NULL,
  unfinished_twists BIGINT NOT NULL,
  mean_absolute_error_deg DOUBLE PRECISION,
  peak_torque_nm DOUBLE PRECISION,
  peak_force_n DOUBLE PRECISION,
  attempts {{blob}} NOT NULL,
  measures {{blob}} NOT NULL,
  computed_utc_us BIGINT NOT NULL,
  PRIMARY KEY (trial_id, formula_version, tolerance_rad, force_limit_n, torque_limit_nm)
);
{{append_only trial_digest}}

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
CREATE INDEX trial_remark_author ON trial_remark (author);
CREATE INDEX trial_remark_trial ON trial_remark (trial_id, time_us);
CREATE INDEX trial_remark_author_person ON trial_remark (author_person_id);
CREATE INDEX trial_remark_reply_to ON trial_remark (reply_to);
{{append_only trial_remark}}

-- What an author made of a remark afterwards, beside the first words, which are version 1. The newest is what is read.
CREATE TABLE remark_revision (
  remark_id TEXT NOT NULL REFERENCES trial_remark (id),
  version BIGINT NOT NULL CHECK (version >= 2),
  author TEXT NOT NULL,
  author_person_id TEXT REFERENCES person (id),
  text TEXT,
  created_utc_us BIGINT NOT NULL,
  PRIMARY KEY (remark_id, version)
);
CREATE INDEX remark_revision_author_person ON remark_revision (author_person_id);
{{append_only remark_revision}}

CREATE TABLE remark_receipt (
  remark_id TEXT NOT NULL REFERENCES trial_remark (id),
  reader TEXT NOT NULL,
  version BIGINT NOT NULL CHECK (version >= 1),
  reader_person_id TEXT REFERENCES person (id),
  read_utc_us BIGINT NOT NULL,
  PRIMARY KEY (remark_id, reader, version)
);
CREATE INDEX remark_receipt_reader_person ON remark_receipt (reader_person_id);
{{append_only remark_receipt}}

-- The moment and the words are the trainee's bookmark; the answer is the physician's reply to it. Both know each other
-- by name, so that such a trial can never become a blinded case.
CREATE TABLE trial_question (
  remark_id TEXT PRIMARY KEY REFERENCES trial_remark (id),
  rater_id TEXT NOT NULL REFERENCES rater (person_id),
  asked_utc_us BIGINT NOT NULL
);
CREATE INDEX trial_question_rater ON trial_question (rater_id, asked_utc_us);
{{append_only trial_question}}

-- What each station does now; overwritten with every sign of life. device_*: which device stands there (null: no
-- training station) and what its last check found (null before the first one); the problem is a sentence with its
-- arguments, so that whoever looks reads it in their own language.
CREATE TABLE station_state (
  station TEXT PRIMARY KEY,
  trial_id TEXT REFERENCES trial (id),
  user_id TEXT,
  software_version TEXT NOT NULL,
  heartbeat_utc_us BIGINT NOT NULL,
  device_json TEXT,
  device_haptic BOOLEAN,
  device_light TEXT CHECK (device_light IN ('green', 'amber', 'red')),
  device_problem_json TEXT,
  device_checked_utc_us BIGINT
);
CREATE INDEX station_state_trial ON station_state (trial_id);

-- What the learning system of the centre is told (xAPI), written with what happened while the centre sends and the
-- trainee agrees. object_id: of the enrolment, trial, exposure or remark. statement: what is sent, made before the first
-- try and never changed, so that a second try is the same statement.
CREATE TABLE learning_event (
  kind TEXT NOT NULL CHECK (kind IN ('registered', 'launched', 'completed', 'judged', 'rested', 'remark_read')),
  object_id TEXT NOT NULL,
  person_id TEXT NOT NULL REFERENCES person (id),
  happened_utc_us BIGINT NOT NULL,
  statement TEXT,
  state TEXT NOT NULL CHECK (state IN ('waiting', 'delivered', 'dead')),
  tries BIGINT NOT NULL,
  next_try_utc_us BIGINT NOT NULL,
  answer TEXT,
  answered_utc_us BIGINT,
  PRIMARY KEY (kind, object_id)
);
CREATE INDEX learning_event_person ON learning_event (person_id);
CREATE INDEX learning_event_next ON learning_event (state, next_try_utc_us);

-- Rubrics, and what is scored by them apart from the study: the trainee about themselves, the rater before the first
-- case.

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
  weight_milli BIGINT NOT NULL CHECK (weight_milli >= 0),
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

-- The run, its panel's mark and what raters scored stay; nobody is given it any more.
CREATE TABLE reference_run_withdrawal (
  trial_id TEXT PRIMARY KEY REFERENCES reference_run (trial_id),
  reason TEXT NOT NULL CHECK (reason <> ''),
  withdrawn_by TEXT NOT NULL,
  withdrawn_utc_us BIGINT NOT NULL
);
{{append_only reference_run_withdrawal}}

-- Training marks (paper section 6).

-- One rater is asked for one sheet. The rater sees the case label only: no name, group or stage.
CREATE TABLE assignment (
  id TEXT PRIMARY KEY,
  rater_id TEXT NOT NULL REFERENCES rater (person_id),
  enrolment_id TEXT NOT NULL REFERENCES enrolment (id),
  occasion TEXT NOT NULL REFERENCES occasion (code),
  trial_id TEXT REFERENCES trial (id),
  rubric_revision_id TEXT NOT NULL REFERENCES rubric_revision (id),
  case_label TEXT NOT NULL,
  position BIGINT NOT NULL,
  due_utc_us BIGINT,
  assigned_by TEXT NOT NULL,
  assigned_utc_us BIGINT NOT NULL,
  demonstration BOOLEAN NOT NULL,
  UNIQUE (rater_id, enrolment_id, occasion),
  UNIQUE (rater_id, case_label)
);
CREATE INDEX assignment_enrolment ON assignment (enrolment_id, occasion);
CREATE INDEX assignment_trial ON assignment (trial_id);
CREATE INDEX assignment_rubric ON assignment (rubric_revision_id);
{{append_only assignment}}

-- Sheets that were taken back from their rater, and given back to the same one: the newest row counts.
CREATE TABLE assignment_withdrawal (
  assignment_id TEXT NOT NULL REFERENCES assignment (id),
  sequence BIGINT NOT NULL,
  withdrawn BOOLEAN NOT NULL,
  reason TEXT NOT NULL,
  decided_by TEXT NOT NULL,
  decided_utc_us BIGINT NOT NULL,
  PRIMARY KEY (assignment_id, sequence)
);
{{append_only assignment_withdrawal}}

-- Who is expected when and where: the plan of a day, which changes as the day goes. What came of it stands in exposure,
-- trial and live_call.
CREATE TABLE day_slot (
  id TEXT PRIMARY KEY,
  enrolment_id TEXT NOT NULL REFERENCES enrolment (id),
  place TEXT NOT NULL,
  starts_utc_us BIGINT NOT NULL,
  duration_us BIGINT NOT NULL CHECK (duration_us > 0)
);
CREATE INDEX day_slot_start ON day_slot (starts_utc_us);
CREATE INDEX day_slot_enrolment ON day_slot (enrolment_id);

-- A trainee is called to the real arm: the live sheets of that case open for every rater who is asked. One call a room
-- at a time. Cancelled: somebody else stood there; the sheets are closed again.
CREATE TABLE live_call (
  id TEXT PRIMARY KEY,
  enrolment_id TEXT NOT NULL REFERENCES enrolment (id),
  occasion TEXT NOT NULL REFERENCES occasion (code),
  room TEXT NOT NULL,
  called_by TEXT NOT NULL,
  called_utc_us BIGINT NOT NULL,
  ended_utc_us BIGINT,
  cancelled BOOLEAN NOT NULL
);
CREATE INDEX live_call_case ON live_call (enrolment_id, occasion);
CREATE UNIQUE INDEX live_call_room ON live_call (room) WHERE ended_utc_us IS NULL;
{{frozen live_call enrolment_id}}
{{frozen live_call occasion}}
{{frozen live_call room}}
{{frozen live_call called_by}}
{{frozen live_call called_utc_us}}

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

-- How a sheet comes about while it is a draft: stretches of the recording that were played ("0-1200;1500-1600", in
-- hundredths of a second), speeds, time at work. Overwritten with every save, deleted when the sheet is submitted.
CREATE TABLE draft_viewing (
  assignment_id TEXT PRIMARY KEY REFERENCES assignment (id),
  watched TEXT NOT NULL,
  slowest_permille BIGINT NOT NULL,
  fastest_permille BIGINT NOT NULL,
  worked_us BIGINT NOT NULL
);

-- One row a trainee, rater and scoring point; a correction is a new version.
CREATE TABLE training_mark (
  id TEXT PRIMARY KEY,
  enrolment_id TEXT NOT NULL REFERENCES enrolment (id),
  rater_id TEXT NOT NULL REFERENCES rater (person_id),
  occasion TEXT NOT NULL REFERENCES occasion (code),
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
  assignment_id TEXT REFERENCES assignment (id),
  UNIQUE (enrolment_id, rater_id, occasion, version),
  CHECK (score_steps BETWEEN scale_lo_steps AND scale_hi_steps),
  CHECK ((score_steps IS NULL) = (not_assessable_reason IS NOT NULL)),
  CHECK ((version = 1) = (amend_reason IS NULL))
);
CREATE INDEX training_mark_rater ON training_mark (rater_id, submitted_utc_us);
CREATE INDEX training_mark_assignment ON training_mark (assignment_id);
CREATE INDEX training_mark_trial ON training_mark (trial_id);
CREATE INDEX training_mark_submitted ON training_mark (enrolment_id, submitted_utc_us);
CREATE INDEX training_mark_demonstration ON training_mark (id) WHERE demonstration = TRUE;
{{append_only training_mark}}

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

-- Marks that were given on paper, as one person typed them. They count once another one has typed the same, and are
-- deleted then; until then each sees only their own.
CREATE TABLE paper_entry (
  assignment_id TEXT NOT NULL REFERENCES assignment (id),
  entered_by TEXT NOT NULL,
  overall_steps BIGINT,
  not_assessable_reason TEXT,
  comment TEXT,
  entered_utc_us BIGINT NOT NULL,
  PRIMARY KEY (assignment_id, entered_by)
);

CREATE TABLE paper_entry_row (
  assignment_id TEXT NOT NULL,
  entered_by TEXT NOT NULL,
  row_code TEXT NOT NULL,
  score_steps BIGINT,
  not_assessable_reason TEXT,
  PRIMARY KEY (assignment_id, entered_by, row_code),
  FOREIGN KEY (assignment_id, entered_by) REFERENCES paper_entry (assignment_id, entered_by)
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

-- Marks of a cohort at a scoring point shown to trainees, or taken back; the newest row counts.
CREATE TABLE mark_release (
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  occasion TEXT NOT NULL REFERENCES occasion (code),
  sequence BIGINT NOT NULL,
  released BOOLEAN NOT NULL,
  reason TEXT NOT NULL,
  decided_by TEXT NOT NULL,
  decided_utc_us BIGINT NOT NULL,
  PRIMARY KEY (cohort_id, occasion, sequence)
);
{{append_only mark_release}}

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

-- trial_id: the recording that the raters watch; null: they have met the model elsewhere.
CREATE TABLE evaluation_model (
  campaign_id TEXT NOT NULL REFERENCES evaluation_campaign (id),
  model_code TEXT NOT NULL,
  label TEXT NOT NULL,
  hidden_label TEXT NOT NULL,
  position BIGINT NOT NULL,
  trial_id TEXT REFERENCES trial (id),
  PRIMARY KEY (campaign_id, model_code),
  UNIQUE (campaign_id, hidden_label)
);
CREATE INDEX evaluation_model_trial ON evaluation_model (trial_id);
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
  occasion TEXT NOT NULL REFERENCES occasion (code),
  mean DOUBLE PRECISION NOT NULL,
  variance DOUBLE PRECISION NOT NULL,
  rater_count BIGINT NOT NULL,
  missing_count BIGINT NOT NULL,
  flags TEXT NOT NULL,
  PRIMARY KEY (run_id, enrolment_id, occasion)
);
CREATE INDEX training_result_enrolment ON training_result (enrolment_id);
{{append_only training_result}}

CREATE TABLE training_group_result (
  run_id TEXT NOT NULL REFERENCES assessment_run (id),
  group_id TEXT NOT NULL REFERENCES training_group (id),
  occasion TEXT NOT NULL REFERENCES occasion (code),
  trainee_count BIGINT NOT NULL,
  mean DOUBLE PRECISION NOT NULL,
  variance_n DOUBLE PRECISION NOT NULL,
  variance_n_minus_1 DOUBLE PRECISION,
  flags TEXT NOT NULL,
  PRIMARY KEY (run_id, group_id, occasion)
);
CREATE INDEX training_group_result_group ON training_group_result (group_id);
{{append_only training_group_result}}
