-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: an interim state is frozen by two people; what a study says about itself; origin of rows
-- compatible_from: 1
--
-- One more act that needs two people. A CHECK cannot be changed in place, so both tables are made anew with their rows;
-- the decisions go first, as they refer to the requests.
CREATE TABLE duty_request_of_3 (
  id TEXT PRIMARY KEY,
  act TEXT NOT NULL CHECK (act IN ('reset_password', 'grant_roles', 'erase', 'restore', 'reveal_allocation',
    'one_person', 'invite', 'freeze_interim')),
  subject TEXT NOT NULL,
  detail_json TEXT NOT NULL,
  reason TEXT NOT NULL,
  requested_by TEXT NOT NULL,
  requested_utc_us BIGINT NOT NULL
);
CREATE TABLE duty_decision_of_3 (
  request_id TEXT PRIMARY KEY REFERENCES duty_request_of_3 (id),
  decision TEXT NOT NULL CHECK (decision IN ('confirmed', 'refused', 'withdrawn')),
  decided_by TEXT NOT NULL,
  decided_utc_us BIGINT NOT NULL
);
INSERT INTO duty_request_of_3 SELECT id, act, subject, detail_json, reason, requested_by, requested_utc_us
  FROM duty_request;
INSERT INTO duty_decision_of_3 SELECT request_id, decision, decided_by, decided_utc_us FROM duty_decision;
DROP TABLE duty_decision;
DROP TABLE duty_request;
ALTER TABLE duty_request_of_3 RENAME TO duty_request;
ALTER TABLE duty_decision_of_3 RENAME TO duty_decision;
CREATE INDEX duty_request_time ON duty_request (requested_utc_us);
{{append_only duty_request}}
{{append_only duty_decision}}

-- What nobody can compute from the record: registration, ethics approval, eligibility ... The newest of each item
-- counts; an empty statement takes the item back. item: see
-- assessment/domain/study/study_statement.h.
CREATE TABLE study_statement (
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  item TEXT NOT NULL,
  sequence BIGINT NOT NULL CHECK (sequence >= 1),
  statement TEXT NOT NULL,
  stated_by TEXT NOT NULL,
  stated_utc_us BIGINT NOT NULL,
  PRIMARY KEY (cohort_id, item, sequence)
);
{{append_only study_statement}}

-- Where the rows of an imported study came from. earlier_json: where its source had them from, oldest first. signed_by:
-- the public key whose signature of the source was checked; null: nobody signed it.
CREATE TABLE study_import (
  id TEXT PRIMARY KEY,
  cohort_id TEXT NOT NULL REFERENCES cohort (id),
  layout TEXT NOT NULL,
  source TEXT NOT NULL,
  content_hash TEXT NOT NULL,
  earlier_json TEXT NOT NULL,
  signed_by TEXT,
  imported_by TEXT NOT NULL,
  imported_utc_us BIGINT NOT NULL
);
CREATE INDEX study_import_cohort ON study_import (cohort_id, imported_utc_us);
{{append_only study_import}}
-- Null: made in this record.
ALTER TABLE training_mark ADD COLUMN import_id TEXT REFERENCES study_import (id);
ALTER TABLE trial ADD COLUMN import_id TEXT REFERENCES study_import (id);
CREATE INDEX training_mark_import ON training_mark (import_id) WHERE import_id IS NOT NULL;
CREATE INDEX trial_import ON trial (import_id) WHERE import_id IS NOT NULL;
