-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: the last mark of an enrolment and what is simulated are found by index
-- compatible_from: 1

CREATE INDEX training_mark_submitted ON training_mark (enrolment_id, submitted_utc_us);
CREATE INDEX training_mark_demonstration ON training_mark (id) WHERE demonstration = TRUE;
CREATE INDEX trial_demonstration ON trial (id) WHERE demonstration = TRUE;
