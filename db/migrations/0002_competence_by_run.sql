-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: competence is judged by whole runs, which depend on each other
-- compatible_from: 1
--
-- How the runs of a trainee depend on each other, by which the limit was chosen. dependence_runs: how many runs it was
-- estimated from; 0: assumed. Null in designs registered before this step: they keep their limit, and what is stated
-- beside it follows from the dependence that is assumed.
ALTER TABLE competence_design ADD COLUMN session_correlation DOUBLE PRECISION
  CHECK (session_correlation >= 0 AND session_correlation < 1);
ALTER TABLE competence_design ADD COLUMN lag_correlation DOUBLE PRECISION
  CHECK (lag_correlation >= 0 AND lag_correlation < 1);
ALTER TABLE competence_design ADD COLUMN runs_per_session BIGINT CHECK (runs_per_session >= 1);
ALTER TABLE competence_design ADD COLUMN dependence_runs BIGINT CHECK (dependence_runs >= 0);
-- How many days a verdict lasts after the last run; null: it does not expire.
ALTER TABLE competence_design ADD COLUMN valid_days BIGINT CHECK (valid_days >= 1);

-- An interrupted run counts as failed unless somebody with the right has excused it: judgement beside the recording,
-- which stays as it is.
CREATE TABLE run_excuse (
  trial_id TEXT PRIMARY KEY REFERENCES trial (id),
  excused_by TEXT NOT NULL,
  excused_utc_us BIGINT NOT NULL,
  reason TEXT
);
{{append_only run_excuse}}
