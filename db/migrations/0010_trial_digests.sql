-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: everything that is derived from a recording, measured once and kept beside it
-- compatible_from: 1

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
