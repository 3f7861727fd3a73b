-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: one-time codes beside the password of an account
-- compatible_from: 1
--
-- An account whose password alone opens nothing. last_step: the latest step of thirty seconds whose code was accepted,
-- so that none is accepted twice; recovery_codes: what is kept of those not used yet, with blanks between.
CREATE TABLE second_factor (
  user_id TEXT PRIMARY KEY REFERENCES app_user (id) ON DELETE CASCADE,
  made_utc_us BIGINT NOT NULL,
  last_step BIGINT NOT NULL,
  recovery_codes TEXT NOT NULL
);

-- The secret that makes the codes, encrypted under a key that only the account's password gives. Apart, so that no
-- administrator of a server reads what words could be tried on.
CREATE TABLE second_factor_secret (
  user_id TEXT PRIMARY KEY REFERENCES second_factor (user_id) ON DELETE CASCADE,
  sealed TEXT NOT NULL
);
