-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: what a report says of a recording, measured once and kept beside it
-- compatible_from: 1

-- One row a trial, version of the formula and tolerance: judgement beside the samples, never in their place. A newer
-- formula adds a row. attempts: for each twist in its order the absolute error in degrees (8 bytes, little-endian
-- double) and whether it was on target (1 byte).
CREATE TABLE trial_digest (
  trial_id TEXT NOT NULL REFERENCES trial (id),
  formula_version TEXT NOT NULL,
  tolerance_rad DOUBLE PRECISION NOT NULL,
  content_hash TEXT NOT NULL,
  model TEXT NOT NULL,
  minutes DOUBLE PRECISION NOT NULL,
  mean_absolute_error_deg DOUBLE PRECISION,
  peak_torque_nm DOUBLE PRECISION,
  peak_force_n DOUBLE PRECISION,
  attempts {{blob}} NOT NULL,
  computed_utc_us BIGINT NOT NULL,
  PRIMARY KEY (trial_id, formula_version, tolerance_rad)
);
{{append_only trial_digest}}
