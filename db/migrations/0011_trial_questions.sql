-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: a trainee asks a named physician about a moment of a practice trial
-- compatible_from: 1

-- The moment and the words are the trainee's bookmark; the answer is the physician's reply to it. Both know each other
-- by name, so that such a trial can never become a blinded case.
CREATE TABLE trial_question (
  remark_id TEXT PRIMARY KEY REFERENCES trial_remark (id),
  rater_id TEXT NOT NULL REFERENCES rater (person_id),
  asked_utc_us BIGINT NOT NULL
);
CREATE INDEX trial_question_rater ON trial_question (rater_id, asked_utc_us);
{{append_only trial_question}}
