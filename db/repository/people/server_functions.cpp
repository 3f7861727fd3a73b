// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/server_functions.h"

#include <array>

#include "db/repository/people/person_data.h"

namespace torsio {

namespace {

// Who has signed in.

/// The user of the session whose token the station holds; with `with_pin` also if a PIN was all that was
/// shown.
constexpr std::string_view kSessionHolder =
    "SELECT s.user_id FROM server_session s JOIN app_user u ON u.id = s.user_id"
    " WHERE s.token_hash = encode(sha256(convert_to(current_setting('torsio.session', true), 'UTF8')), 'hex')"
    " AND s.until_utc_us > extract(epoch FROM clock_timestamp()) * 1000000 AND u.state = 'active'"
    " AND s.client = coalesce(host(inet_client_addr()), 'local') AND (with_pin OR NOT s.practice)";

constexpr std::string_view kSessionAuthor = "SELECT session_holder(TRUE)";
constexpr std::string_view kSessionUser = "SELECT session_holder(FALSE)";

/// The account whose password the station's session may set, and nothing else.
constexpr std::string_view kInvitedAccount =
    "SELECT s.user_id FROM server_session s JOIN app_user u ON u.id = s.user_id"
    " WHERE s.token_hash = encode(sha256(convert_to(current_setting('torsio.session', true), 'UTF8')), 'hex')"
    " AND s.until_utc_us > extract(epoch FROM clock_timestamp()) * 1000000 AND u.state = 'active'"
    " AND s.client = 'invited ' || coalesce(host(inet_client_addr()), 'local')";

constexpr std::string_view kUserMay =
    "SELECT EXISTS (SELECT 1 FROM user_role r JOIN role_operation o ON o.role_code = r.role_code"
    " WHERE r.user_id = account AND o.operation_code = operation)";

constexpr std::string_view kSessionMay = "SELECT user_may(session_user_id(), operation)";

/// Somebody has signed in, with more than a PIN, or this transaction founds the centre.
constexpr std::string_view kIsKnown =
    "SELECT session_user_id() IS NOT NULL OR NOT EXISTS (SELECT 1 FROM app_user"
    " WHERE xmin IS DISTINCT FROM pg_current_xact_id_if_assigned()::xid)";

constexpr std::string_view kActorPerson = "SELECT person_id FROM app_user WHERE id = session_user_id()";

// Whose marks one sees.

/// Operations that permit seeing all marks; one is enough.
constexpr std::string_view kSeesAllMarks =
    "SELECT EXISTS (SELECT 1 FROM user_role r JOIN role_operation o ON o.role_code = r.role_code"
    " WHERE r.user_id = session_user_id() AND o.operation_code IN"
    " ('mark.view_coded', 'mark.release', 'results.compute', 'evaluation.setup', 'audit.view',"
    " 'database.restore'))";

/// Typing paper sheets, importing data sets.
constexpr std::string_view kAddsMarksOfOthers = "SELECT session_may('study.setup')";

/// A rater sees the others' marks once every assigned rater has submitted, to compare disagreements.
constexpr std::string_view kCaseIsCommitted =
    "SELECT EXISTS (SELECT 1 FROM assignment a WHERE a.enrolment_id = case_enrolment AND a.occasion ="
    " case_occasion AND a.rater_id = actor_person()) AND NOT EXISTS (SELECT 1 FROM assignment a WHERE"
    " a.enrolment_id = case_enrolment AND a.occasion = case_occasion"
    " AND NOT EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = a.id)"
    " AND NOT EXISTS (SELECT 1 FROM assignment_withdrawal w WHERE w.assignment_id = a.id AND w.withdrawn"
    " AND NOT EXISTS (SELECT 1 FROM assignment_withdrawal v WHERE v.assignment_id = w.assignment_id"
    " AND v.sequence > w.sequence)))";

/// A trainee sees their own marks once released.
constexpr std::string_view kIsReleasedToActor =
    "SELECT coalesce((SELECT r.released FROM enrolment e JOIN mark_release r ON r.cohort_id = e.cohort_id"
    " WHERE e.id = case_enrolment AND e.trainee_id = actor_person() AND r.occasion = case_occasion"
    " ORDER BY r.sequence DESC LIMIT 1), FALSE)";

// Who is in which group.

/// The enrolment of the trainee who has signed in, or of a case that the rater who has signed in scores.
constexpr std::string_view kIsOwnCase =
    "SELECT EXISTS (SELECT 1 FROM enrolment e WHERE e.id = case_enrolment AND e.trainee_id = actor_person())"
    " OR EXISTS (SELECT 1 FROM assignment a WHERE a.enrolment_id = case_enrolment"
    " AND a.rater_id = actor_person())";

constexpr std::string_view kIsOwnGroup =
    "SELECT EXISTS (SELECT 1 FROM enrolment e WHERE e.group_id = asked_group"
    " AND e.trainee_id = actor_person())";

/// A trainee who agreed that a learning record store is told, while it waits for that.
constexpr std::string_view kIsToldElsewhere =
    "SELECT EXISTS (SELECT 1 FROM learning_event l WHERE l.person_id = trainee AND l.state = 'waiting')"
    " AND coalesce((SELECT c.granted FROM consent c WHERE c.person_id = trainee AND c.purpose ="
    " 'xapi_export' ORDER BY c.sequence DESC LIMIT 1), FALSE)";

constexpr std::string_view kIsSimulatedDesign =
    "SELECT EXISTS (SELECT 1 FROM allocation_design d WHERE d.id = design AND d.demonstration)";

// What needs two people; see app/services/access/two_people.cpp.

constexpr std::string_view kOneIsEnough =
    "SELECT EXISTS (SELECT 1 FROM setting WHERE name = 'two_people' AND value = 'no')";

/// One is enough, or the user who has signed in confirms another one's request in this very transaction.
constexpr std::string_view kTwoDecided =
    "SELECT one_is_enough() OR EXISTS (SELECT 1 FROM duty_request r JOIN duty_decision d"
    " ON d.request_id = r.id WHERE r.act = wanted AND r.subject = about AND d.decision = 'confirmed'"
    " AND d.decided_by = session_user_id() AND d.xmin = pg_current_xact_id_if_assigned()::xid)";

/// The right with which an act is confirmed; see rightToConfirm().
constexpr std::string_view kRightTo =
    "SELECT CASE act WHEN 'erase' THEN 'person.erase' WHEN 'restore' THEN 'database.restore'"
    " WHEN 'reveal_allocation' THEN 'allocation.reveal' WHEN 'freeze_interim' THEN 'results.compute'"
    " WHEN 'one_person' THEN 'settings.edit' ELSE 'user.manage' END";

constexpr std::string_view kMayAsk =
    "SELECT user_may(account, right_to(act)) OR (act = 'reveal_allocation'"
    " AND user_may(account, 'study.setup'))";

/// Nothing of a real person depends on what is asked for.
constexpr std::string_view kIsSimulatedSubject =
    "SELECT CASE WHEN act IN ('reset_password', 'grant_roles', 'invite') THEN"
    " EXISTS (SELECT 1 FROM app_user u WHERE u.id = about AND u.demonstration)"
    " WHEN act = 'erase' THEN EXISTS (SELECT 1 FROM person p WHERE p.id = about AND p.demonstration)"
    " WHEN act = 'reveal_allocation' THEN is_simulated_design(about)"
    " WHEN act = 'freeze_interim' THEN EXISTS (SELECT 1 FROM cohort c WHERE c.id = about"
    " AND c.demonstration) ELSE FALSE END";

/// A request is made now, so that none outlives its two weeks; clocks of stations may differ by a day.
constexpr std::string_view kMayRequest =
    "SELECT asker = session_user_id() AND may_ask(asker, act) AND (is_simulated_subject(act, about)"
    " OR NOT EXISTS (SELECT 1 FROM app_user u WHERE u.id = asker AND u.demonstration))"
    " AND abs(at_us - extract(epoch FROM clock_timestamp()) * 1000000) < 86400000000";

/// Confirmed by another real person than the one who asked, within two weeks (kRequestLife_us). About one's
/// own account one confirms only that roles are taken away.
constexpr std::string_view kMayDecide =
    "SELECT decider = session_user_id() AND (SELECT CASE WHEN made = 'withdrawn' THEN"
    " r.requested_by = decider WHEN made = 'refused' THEN session_may('user.manage') OR"
    " session_may('allocation.reveal') ELSE r.requested_by <> decider AND asker.state = 'active'"
    " AND self.person_id IS NOT DISTINCT FROM NULLIF(self.person_id, asker.person_id)"
    " AND (is_simulated_subject(r.act, r.subject) OR NOT (asker.demonstration OR self.demonstration))"
    " AND r.requested_utc_us > extract(epoch FROM clock_timestamp()) * 1000000 - 1209600000000"
    " AND may_ask(asker.id, r.act) AND session_may(right_to(r.act))"
    " AND (r.act NOT IN ('reset_password', 'grant_roles', 'invite') OR r.subject <> decider"
    " OR (r.act = 'grant_roles' AND only_takes_roles(r.subject, r.detail_json))) END"
    " FROM duty_request r LEFT JOIN app_user asker ON asker.id = r.requested_by"
    " JOIN app_user self ON self.id = decider WHERE r.id = request)";

constexpr std::string_view kOnlyTakesRoles =
    "SELECT NOT EXISTS (SELECT 1 FROM jsonb_array_elements_text(detail::jsonb -> 'roles') AS wanted (code)"
    " WHERE NOT EXISTS (SELECT 1 FROM user_role r WHERE r.user_id = account AND r.role_code = wanted.code))";

constexpr std::string_view kAdministrators =
    "SELECT count(*) FROM app_user u JOIN user_role r ON r.user_id = u.id"
    " WHERE r.role_code = 'administrator' AND u.state = 'active' AND NOT u.demonstration";

constexpr std::string_view kIsGuarded =
    "SELECT NOT one_is_enough() AND given <> 'trainee' AND NOT (simulated AND given = 'rater')"
    " AND NOT (given = 'administrator' AND administrators() < 2)";

constexpr std::string_view kAccountIsGuarded =
    "SELECT EXISTS (SELECT 1 FROM app_user u JOIN user_role r ON r.user_id = u.id WHERE u.id = account"
    " AND role_is_guarded(u.demonstration, r.role_code)) OR (NOT one_is_enough() AND EXISTS (SELECT 1"
    " FROM app_user u JOIN rater p ON p.person_id = u.person_id WHERE u.id = account"
    " AND NOT u.demonstration))";

/// An administrator who could confirm: otherwise one could make the other powerless and go on alone.
constexpr std::string_view kAdministratorIsGuarded =
    "SELECT NOT one_is_enough() AND EXISTS (SELECT 1 FROM app_user u JOIN user_role r ON r.user_id = u.id"
    " WHERE u.id = account AND r.role_code = 'administrator' AND u.state = 'active' AND NOT u.demonstration)";

constexpr std::string_view kMayTakeRole =
    "SELECT session_may('user.manage') AND (taken <> 'administrator' OR NOT administrator_is_guarded(account)"
    " OR EXISTS (SELECT 1 FROM duty_request r JOIN duty_decision d ON d.request_id = r.id"
    " WHERE r.act = 'grant_roles' AND r.subject = account AND d.decision = 'confirmed'"
    " AND d.decided_by = session_user_id() AND d.xmin = pg_current_xact_id_if_assigned()::xid"
    " AND NOT jsonb_exists(r.detail_json::jsonb -> 'roles', taken)))";

constexpr std::string_view kMayGiveRole =
    "SELECT CASE WHEN session_user_id() IS NULL THEN is_known() ELSE session_may('user.manage') AND ("
    "NOT role_is_guarded((SELECT demonstration FROM app_user WHERE id = account), given)"
    " OR EXISTS (SELECT 1 FROM duty_request r JOIN duty_decision d ON d.request_id = r.id"
    " WHERE r.act = 'grant_roles' AND r.subject = account AND d.decision = 'confirmed'"
    " AND d.decided_by = session_user_id() AND d.xmin = pg_current_xact_id_if_assigned()::xid"
    " AND jsonb_exists(r.detail_json::jsonb -> 'roles', given))) END";

/// A rater's account has no password before two people draw one. A person has one account. Another one that
/// is being added is waited for, and seen: at other levels of isolation it would not be.
constexpr std::string_view kMayAddAccount = R"(
BEGIN
  IF NOT (CASE WHEN session_user_id() IS NULL THEN is_known() ELSE session_may('user.manage') END) THEN
    RETURN FALSE;
  END IF;
  IF person IS NULL THEN RETURN TRUE; END IF;
  IF simulated AND EXISTS (SELECT 1 FROM person p WHERE p.id = person AND NOT p.demonstration) THEN
    RETURN FALSE;
  END IF;
  IF session_user_id() IS NOT NULL AND NOT one_is_enough() AND NOT simulated
      AND (password <> '' OR pin IS NOT NULL)
      AND EXISTS (SELECT 1 FROM rater p WHERE p.person_id = person) THEN RETURN FALSE; END IF;
  IF current_setting('transaction_isolation') <> 'read committed' THEN RETURN FALSE; END IF;
  PERFORM pg_advisory_xact_lock(1414484563, hashtext(person));
  RETURN NOT EXISTS (SELECT 1 FROM app_user u WHERE u.person_id = person);
END )";

/// The row is still as it was before this statement.
constexpr std::string_view kMayChangeAccount = R"(
#variable_conflict use_variable
DECLARE
  before app_user;
  me text := session_user_id();
BEGIN
  SELECT * INTO before FROM app_user u WHERE u.id = account;
  IF me IS NULL AND invited_account() IS NULL THEN
    RETURN is_known() AND session_author() IS NULL;
  END IF;
  IF before.id IS NULL OR before.login <> name OR before.person_id IS DISTINCT FROM person
      OR before.demonstration <> simulated THEN RETURN FALSE; END IF;
  IF standing <> before.state AND administrator_is_guarded(account) THEN RETURN FALSE; END IF;
  IF me IS NULL THEN
    RETURN account = invited_account() AND standing = before.state AND before.pin_hash IS NOT DISTINCT FROM pin;
  END IF;
  IF before.password_hash = password AND before.pin_hash IS NOT DISTINCT FROM pin THEN
    RETURN me = account OR session_may('user.manage');
  END IF;
  IF me = account THEN RETURN TRUE; END IF;
  RETURN session_may('user.manage') AND (NOT account_is_guarded(account)
    OR two_decided('reset_password', account) OR two_decided('grant_roles', account));
END )";

/// Whoever may set the account's password, which makes its sealed secret useless.
constexpr std::string_view kMayDropSecondFactor =
    "SELECT account IN (session_user_id(), invited_account()) OR (session_may('user.manage')"
    " AND (NOT account_is_guarded(account) OR two_decided('reset_password', account)"
    " OR two_decided('grant_roles', account)))";

constexpr std::string_view kMayInvite =
    "SELECT session_may('user.manage') AND (NOT account_is_guarded(account)"
    " OR two_decided('invite', account))";

/// What was used or revoked never opens again.
constexpr std::string_view kMayChangeInvitation =
    "SELECT (session_may('user.manage') OR account IN (session_user_id(), invited_account())) AND (wanted <> "
    "'open'"
    " OR EXISTS (SELECT 1 FROM invitation i WHERE i.id = invited AND i.state = 'open'))";

/// Committed by another transaction: not by this one or one of its savepoints, which may be rolled back.
constexpr std::string_view kIsCommitted =
    "SELECT known.id < pg_snapshot_xmax(pg_current_snapshot())::text::bigint"
    " AND coalesce(pg_xact_status(known.id::text::xid8), 'committed') = 'committed' FROM"
    " (SELECT (pg_snapshot_xmax(pg_current_snapshot())::text::bigint >> 32 << 32) + row_xid::text::bigint AS "
    "id)"
    " AS known";

/// An allocator reads a sealed seed behind a committed entry of the trail that says so
/// (AuditAction::kAllocationTakeSeed) and is their newest about allocations. Also whoever locks the design,
/// and whoever opens the seal with another.
constexpr std::string_view kMayReadSeed =
    "SELECT is_simulated_design(design) OR EXISTS (SELECT 1 FROM allocation_design d WHERE d.id = design"
    " AND d.xmin = pg_current_xact_id_if_assigned()::xid)"
    " OR (session_may('allocation.reveal') AND NOT one_is_enough()"
    " AND two_decided('reveal_allocation', design))"
    " OR CASE WHEN session_may('allocation.run') THEN coalesce((SELECT e.action = 'allocation.take_seed'"
    " AND e.object_id = design AND is_committed(e.xmin) FROM audit_entry e WHERE e.actor = session_user_id()"
    " AND e.action LIKE 'allocation.%' ORDER BY e.sequence DESC LIMIT 1), FALSE) ELSE FALSE END";

constexpr std::string_view kMayOpenSeed =
    "SELECT is_simulated_design(design) OR (session_may('allocation.reveal')"
    " AND two_decided('reveal_allocation', design))";

/// Moving a record away writes where to.
constexpr std::string_view kMaySet =
    "SELECT CASE WHEN session_user_id() IS NULL THEN is_known()"
    " WHEN named IN ('record.moving_to', 'record.moved_to') THEN session_may('database.restore')"
    " ELSE session_may('settings.edit') AND (named <> 'two_people' OR written = 'yes'"
    " OR administrators() < 2 OR two_decided('one_person', 'two_people')) END";

/// An interim state, of which sheets are missing, needs two people.
constexpr std::string_view kMayFreeze =
    "SELECT simulated OR (session_may('results.compute') AND (two_decided('freeze_interim', of_cohort)"
    " OR NOT EXISTS (SELECT 1 FROM assignment a JOIN enrolment e ON e.id = a.enrolment_id"
    " WHERE e.cohort_id = of_cohort AND NOT EXISTS (SELECT 1 FROM training_mark m"
    " WHERE m.assignment_id = a.id) AND NOT coalesce((SELECT w.withdrawn FROM assignment_withdrawal w"
    " WHERE w.assignment_id = a.id ORDER BY w.sequence DESC LIMIT 1), FALSE))))";

/// No entry of the trail names somebody who has an account but has not signed in.
constexpr std::string_view kMayWriteAs =
    "SELECT who = session_author() OR who = actor_person() OR adds_marks_of_others() OR NOT EXISTS"
    " (SELECT 1 FROM app_user u WHERE (u.id = who OR u.person_id = who) AND NOT u.demonstration)"
    " OR (session_author() IS NULL AND is_known())";

// Signing in.

/// HMAC in all but name, so that what is known of it tells nothing about the pepper.
constexpr std::string_view kPeppered =
    "SELECT encode(sha256(convert_to(p.pepper || encode(sha256(convert_to(p.pepper || nonce || hash,"
    " 'UTF8')), 'hex'), 'UTF8')), 'hex') FROM password_pepper p";

/// What is stored of a password: with a nonce of the server, so that asking again gives another answer.
constexpr std::string_view kSealedSecret = R"(
DECLARE
  nonce text := replace(gen_random_uuid()::text, '-', '');
BEGIN
  RETURN 'server1$' || nonce || '$' || peppered(nonce, hash) || regexp_replace(hash, '\$[^$]*$', '');
END )";

constexpr std::string_view kNewSession = R"(
DECLARE
  token text := replace(gen_random_uuid()::text || gen_random_uuid()::text, '-', '');
  now_us bigint := extract(epoch FROM clock_timestamp()) * 1000000;
BEGIN
  DELETE FROM server_session WHERE until_utc_us < now_us;
  INSERT INTO server_session (token_hash, user_id, practice, client, begun_utc_us, until_utc_us)
    VALUES (encode(sha256(convert_to(token, 'UTF8')), 'hex'), account, pin,
      coalesce(host(inet_client_addr()), 'local'), now_us, now_us + 86400000000);
  PERFORM set_config('torsio.session', token, false);
  RETURN token;
END )";

/// A quarter of a second for each wrong try.
constexpr std::string_view kOpenSession = R"(
DECLARE
  found app_user;
  kept text;
BEGIN
  SELECT * INTO found FROM app_user u WHERE u.login = name;
  kept := CASE WHEN pin THEN found.pin_hash ELSE found.password_hash END;
  IF kept IS NULL OR split_part(kept, '$', 1) <> 'server1'
      OR peppered(split_part(kept, '$', 2), hash) <> split_part(kept, '$', 3) THEN
    PERFORM pg_sleep(0.25);
    RETURN NULL;
  END IF;
  IF found.state <> 'active' THEN RETURN ''; END IF;
  RETURN new_session(found.id, pin);
END )";

/// What is kept of the proof of a card or link (keptOfProof()).
constexpr std::string_view kKeptOfProof =
    "SELECT 'kept1$' || encode(sha256(convert_to(proof, 'UTF8')), 'hex')";

/// With the proof of a trainee's card, while the centre allows it. Returns id, state and token.
constexpr std::string_view kOpenWithCode = R"(
DECLARE
  found app_user;
BEGIN
  SELECT u.* INTO found FROM kiosk_code k JOIN app_user u ON u.id = k.user_id
    WHERE k.code_hash = kept_of_proof(proof) AND k.revoked_utc_us IS NULL
      AND EXISTS (SELECT 1 FROM setting s WHERE s.name = 'kiosk_codes' AND s.value = 'yes')
      AND NOT EXISTS (SELECT 1 FROM user_role r WHERE r.user_id = u.id AND r.role_code <> 'trainee');
  IF found.id IS NULL THEN
    PERFORM pg_sleep(0.25);
    RETURN NULL;
  END IF;
  RETURN found.id || ' ' || found.state || ' ' ||
    CASE WHEN found.state = 'active' THEN new_session(found.id, FALSE) ELSE '' END;
END )";

/// With the proof of a link: ten minutes in which nothing but its account's password can be set.
constexpr std::string_view kOpenInvited = R"(
DECLARE
  account text;
  token text;
BEGIN
  SELECT u.id INTO account FROM invitation i JOIN app_user u ON u.id = i.user_id
    WHERE i.token_hash = kept_of_proof(proof) AND i.state = 'open' AND u.state = 'active'
      AND i.expires_utc_us > extract(epoch FROM clock_timestamp()) * 1000000;
  IF account IS NULL THEN
    PERFORM pg_sleep(0.25);
    RETURN NULL;
  END IF;
  token := new_session(account, TRUE);
  UPDATE server_session SET client = 'invited ' || client, until_utc_us = begun_utc_us + 600000000
    WHERE token_hash = encode(sha256(convert_to(token, 'UTF8')), 'hex');
  RETURN token;
END )";

/// An administrator looks round as a simulated trainee or physician.
constexpr std::string_view kOpenSimulated = R"(
BEGIN
  IF NOT session_may('user.manage') OR NOT EXISTS (SELECT 1 FROM app_user u WHERE u.id = account
      AND u.demonstration AND u.state = 'active') OR EXISTS (SELECT 1 FROM user_role r
      WHERE r.user_id = account AND r.role_code NOT IN ('trainee', 'rater')) THEN
    RETURN NULL;
  END IF;
  RETURN new_session(account, FALSE);
END )";

constexpr std::string_view kEndOwnSession =
    "DELETE FROM server_session WHERE token_hash ="
    " encode(sha256(convert_to(current_setting('torsio.session', true), 'UTF8')), 'hex')";

constexpr std::string_view kEndOtherSessions =
    "DELETE FROM server_session WHERE user_id = account"
    " AND (account IN (session_user_id(), invited_account()) OR session_may('user.manage')) AND token_hash "
    "IS DISTINCT FROM"
    " encode(sha256(convert_to(current_setting('torsio.session', true), 'UTF8')), 'hex')";

constexpr std::array kFunctions{
    ServerFunction{"session_holder", "with_pin boolean", "text", "sql STABLE", kSessionHolder, false},
    ServerFunction{"session_author", "", "text", "sql STABLE", kSessionAuthor},
    ServerFunction{"session_user_id", "", "text", "sql STABLE", kSessionUser},
    ServerFunction{"invited_account", "", "text", "sql STABLE", kInvitedAccount},
    ServerFunction{"user_may", "account text, operation text", "boolean", "sql STABLE", kUserMay, false},
    ServerFunction{"session_may", "operation text", "boolean", "sql STABLE", kSessionMay},
    ServerFunction{"is_known", "", "boolean", "sql STABLE", kIsKnown},
    ServerFunction{"actor_person", "", "text", "sql STABLE", kActorPerson},
    ServerFunction{"sees_all_marks", "", "boolean", "sql STABLE", kSeesAllMarks},
    ServerFunction{"adds_marks_of_others", "", "boolean", "sql STABLE", kAddsMarksOfOthers},
    ServerFunction{"case_is_committed", "case_enrolment text, case_occasion text", "boolean", "sql STABLE",
                   kCaseIsCommitted},
    ServerFunction{"is_released_to_actor", "case_enrolment text, case_occasion text", "boolean", "sql STABLE",
                   kIsReleasedToActor},
    ServerFunction{"is_own_case", "case_enrolment text", "boolean", "sql STABLE", kIsOwnCase},
    ServerFunction{"is_own_group", "asked_group text", "boolean", "sql STABLE", kIsOwnGroup},
    ServerFunction{"is_told_elsewhere", "trainee text", "boolean", "sql STABLE", kIsToldElsewhere},
    ServerFunction{"is_simulated_design", "design text", "boolean", "sql STABLE", kIsSimulatedDesign},
    ServerFunction{"one_is_enough", "", "boolean", "sql STABLE", kOneIsEnough},
    ServerFunction{"two_decided", "wanted text, about text", "boolean", "sql STABLE", kTwoDecided},
    ServerFunction{"right_to", "act text", "text", "sql IMMUTABLE", kRightTo, false},
    ServerFunction{"may_ask", "account text, act text", "boolean", "sql STABLE", kMayAsk, false},
    ServerFunction{"is_simulated_subject", "act text, about text", "boolean", "sql STABLE",
                   kIsSimulatedSubject, false},
    ServerFunction{"may_request", "act text, about text, asker text, at_us bigint", "boolean", "sql STABLE",
                   kMayRequest},
    ServerFunction{"only_takes_roles", "account text, detail text", "boolean", "sql STABLE", kOnlyTakesRoles,
                   false},
    ServerFunction{"may_decide", "request text, made text, decider text", "boolean", "sql STABLE",
                   kMayDecide},
    ServerFunction{"administrators", "", "bigint", "sql STABLE", kAdministrators},
    ServerFunction{"role_is_guarded", "simulated boolean, given text", "boolean", "sql STABLE", kIsGuarded},
    ServerFunction{"account_is_guarded", "account text", "boolean", "sql STABLE", kAccountIsGuarded},
    ServerFunction{"administrator_is_guarded", "account text", "boolean", "sql STABLE",
                   kAdministratorIsGuarded, false},
    ServerFunction{"may_take_role", "account text, taken text", "boolean", "sql STABLE", kMayTakeRole},
    ServerFunction{"may_add_account", "person text, password text, pin text, simulated boolean", "boolean",
                   "plpgsql", kMayAddAccount},
    ServerFunction{"may_give_role", "account text, given text", "boolean", "sql STABLE", kMayGiveRole},
    ServerFunction{"may_change_account",
                   "account text, name text, person text, password text, pin text, simulated boolean,"
                   " standing text",
                   "boolean", "plpgsql STABLE", kMayChangeAccount},
    ServerFunction{"may_drop_second_factor", "account text", "boolean", "sql STABLE", kMayDropSecondFactor},
    ServerFunction{"may_invite", "account text", "boolean", "sql STABLE", kMayInvite},
    ServerFunction{"may_change_invitation", "invited text, account text, wanted text", "boolean",
                   "sql STABLE", kMayChangeInvitation},
    ServerFunction{"is_committed", "row_xid xid", "boolean", "sql VOLATILE", kIsCommitted, false},
    ServerFunction{"may_read_seed", "design text", "boolean", "sql STABLE", kMayReadSeed},
    ServerFunction{"may_open_seed", "design text", "boolean", "sql STABLE", kMayOpenSeed},
    ServerFunction{"may_set", "named text, written text", "boolean", "sql STABLE", kMaySet},
    ServerFunction{"may_freeze", "of_cohort text, simulated boolean", "boolean", "sql STABLE", kMayFreeze},
    ServerFunction{"may_write_as", "who text", "boolean", "sql STABLE", kMayWriteAs},
    ServerFunction{"peppered", "nonce text, hash text", "text", "sql STABLE", kPeppered, false},
    ServerFunction{"sealed_secret", "hash text", "text", "plpgsql", kSealedSecret},
    ServerFunction{"new_session", "account text, pin boolean", "text", "plpgsql", kNewSession, false},
    ServerFunction{"open_session", "name text, hash text, pin boolean", "text", "plpgsql", kOpenSession},
    ServerFunction{"kept_of_proof", "proof text", "text", "sql IMMUTABLE", kKeptOfProof, false},
    ServerFunction{"open_session_with_code", "proof text", "text", "plpgsql", kOpenWithCode},
    ServerFunction{"open_invited_session", "proof text", "text", "plpgsql", kOpenInvited},
    ServerFunction{"open_simulated_session", "account text", "text", "plpgsql", kOpenSimulated},
    ServerFunction{"end_own_session", "", "void", "sql", kEndOwnSession},
    ServerFunction{"end_other_sessions", "account text", "void", "sql", kEndOtherSessions},
    ServerFunction{
        "erase_person", "erased_id text, erased_by text, why text, at_us bigint", "void", "plpgsql", {}}};

/// Replaces each `?` of an erase statement by the person's id.
std::string withPerson(std::string condition) {
  for (std::size_t at = condition.find('?'); at != std::string::npos; at = condition.find('?', at)) {
    condition.replace(at, 1, "erased_id");
  }
  return condition;
}

}  // namespace

std::span<const ServerFunction> serverFunctions() {
  return kFunctions;
}

std::string eraseBody() {
  std::string body =
      "\n#variable_conflict use_variable\nBEGIN\n"
      "  IF erased_by IS DISTINCT FROM session_user_id() OR NOT session_may('person.erase') THEN\n"
      "    RAISE EXCEPTION 'nobody who may erase is signed in' USING ERRCODE = '42501';\n"
      "  END IF;\n"
      // One is enough for a simulated person, and for one whom an import brought that is taken back in this
      // transaction and of whom nothing is in the record.
      "  IF NOT two_decided('erase', erased_id) AND NOT EXISTS (SELECT 1 FROM person p WHERE p.id = erased_id"
      " AND p.demonstration) AND (NOT EXISTS (SELECT 1 FROM roster_import_person p JOIN roster_import i"
      " ON i.id = p.import_id WHERE p.person_id = erased_id AND p.before_json IS NULL"
      " AND i.xmin = pg_current_xact_id()::xid) OR EXISTS (SELECT 1 FROM enrolment e"
      " WHERE e.trainee_id = erased_id) OR EXISTS (SELECT 1 FROM trial t WHERE t.trainee_id = erased_id)"
      " OR EXISTS (SELECT 1 FROM assignment a WHERE a.rater_id = erased_id)"
      " OR EXISTS (SELECT 1 FROM consent c WHERE c.person_id = erased_id)) THEN\n"
      "    RAISE EXCEPTION 'nobody else has asked for this' USING ERRCODE = '42501';\n"
      "  END IF;\n"
      "  INSERT INTO erasure_gate (id, reason, opened_utc_us) VALUES (erased_id, why, at_us);\n";
  for (const PersonRule& rule : kPersonRules) {
    if (rule.condition.empty() || rule.onErase == OnErase::kKeep) {
      continue;
    }
    const std::string table(rule.table);
    body += "  " +
            (rule.onErase == OnErase::kDelete ? "DELETE FROM " + table
                                              : "UPDATE " + table + " SET " + std::string(rule.cleared)) +
            " WHERE " + withPerson(std::string(rule.condition)) + ";\n";
  }
  return body +
         "  DELETE FROM erasure_gate WHERE id = erased_id;\n"
         "  INSERT INTO erasure (person_id, requested_by, reason, erased_utc_us)"
         " VALUES (erased_id, erased_by, why, at_us);\n"
         "END ";
}

}  // namespace torsio
