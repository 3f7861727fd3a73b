-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: a reference run of the warm-up is withdrawn with a reason
-- compatible_from: 1

-- The run, its panel's mark and what raters scored stay; nobody is given it any more.
CREATE TABLE reference_run_withdrawal (
  trial_id TEXT PRIMARY KEY REFERENCES reference_run (trial_id),
  reason TEXT NOT NULL CHECK (reason <> ''),
  withdrawn_by TEXT NOT NULL,
  withdrawn_utc_us BIGINT NOT NULL
);
{{append_only reference_run_withdrawal}}
