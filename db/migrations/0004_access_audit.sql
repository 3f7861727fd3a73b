-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: roles and permissions, users, audit chain, retention, erasures
-- compatible_from: 1

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

-- Hash of a comment that went into the seal of its mark: the seal still fits after the comment was erased.
ALTER TABLE training_mark ADD COLUMN comment_hash TEXT;

CREATE TABLE retention_rule (
  category TEXT PRIMARY KEY,
  keep_days BIGINT NOT NULL CHECK (keep_days >= 1),
  basis TEXT NOT NULL,
  changed_utc_us BIGINT NOT NULL
);

-- What is left of an erased person besides the coded row: that it happened, when and why.
CREATE TABLE erasure (
  person_id TEXT PRIMARY KEY REFERENCES person (id),
  requested_by TEXT NOT NULL,
  reason TEXT NOT NULL,
  erased_utc_us BIGINT NOT NULL
);
{{immutable erasure}}
