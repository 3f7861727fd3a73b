-- SPDX-License-Identifier: GPL-3.0-or-later
-- description: replies to an author's remarks are found by index
-- compatible_from: 1

CREATE INDEX trial_remark_author ON trial_remark (author);
