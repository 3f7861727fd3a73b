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
