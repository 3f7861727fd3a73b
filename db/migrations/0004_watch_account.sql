-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: one account of watched time a rater, over all browsers and windows
-- compatible_from: 1
--
-- The time that a rater may still be credited with, see assessment/domain/rating/watch_account.h. recording: a case or a
-- model of an evaluation; player: who reported last; charged_utc_us: up to when the time has been used.
CREATE TABLE watch_account (
  rater_id TEXT PRIMARY KEY REFERENCES person (id),
  recording TEXT NOT NULL,
  player TEXT NOT NULL,
  charged_utc_us BIGINT NOT NULL,
  slack_us BIGINT NOT NULL CHECK (slack_us >= 0)
);
