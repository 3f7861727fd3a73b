<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>CopiesText</name>
    <message numerus="yes">
        <source>and %n older one(s); torsio db copies lists all</source>
        <translation>
            <numerusform>and %n older one; torsio db copies lists all</numerusform>
            <numerusform>and %n older ones; torsio db copies lists all</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Reassignment</name>
    <message numerus="yes">
        <source>The sheets of %n row(s) of the matrix.</source>
        <translation>
            <numerusform>The sheets of %n row of the matrix.</numerusform>
            <numerusform>The sheets of %n rows of the matrix.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) change hands.</source>
        <translation>
            <numerusform>%n sheet changes hands.</numerusform>
            <numerusform>%n sheets change hands.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stay(s): the other rater is asked about these cases already.</source>
        <translation>
            <numerusform>%n stays: the other rater is asked about this case already.</numerusform>
            <numerusform>%n stay: the other rater is asked about these cases already.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReminderText</name>
    <message numerus="yes">
        <source>Copied: the outstanding sheets of %n rater(s)</source>
        <translation>
            <numerusform>Copied: the outstanding sheets of one rater</numerusform>
            <numerusform>Copied: the outstanding sheets of %n raters</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StationLabels</name>
    <message numerus="yes">
        <source>%n day(s)</source>
        <translation>
            <numerusform>%n day</numerusform>
            <numerusform>%n days</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Competence not shown yet. %n successful run(s) in a row would show it.</source>
        <translation>
            <numerusform>Competence not shown yet. %n successful run would show it.</numerusform>
            <numerusform>Competence not shown yet. %n successful runs in a row would show it.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TwistCoach</name>
    <message numerus="yes">
        <source>%n twist(s), at least %1 asked for</source>
        <translation>
            <numerusform>%n twist, at least %1 asked for</numerusform>
            <numerusform>%n twists, at least %1 asked for</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n twist(s)</source>
        <translation>
            <numerusform>%1 of %n twist</numerusform>
            <numerusform>%1 of %n twists</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::AllocationPage</name>
    <message numerus="yes">
        <source>%n trainee(s) allocated</source>
        <translation>
            <numerusform>%n trainee allocated</numerusform>
            <numerusform>%n trainees allocated</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trainee(s) lack one of these details: %1</source>
        <translation>
            <numerusform>%n trainee lacks one of these details: %1</numerusform>
            <numerusform>%n trainees lack one of these details: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trainee(s) moved by hand; the drawn records stay</source>
        <translation>
            <numerusform>%n trainee moved by hand; the drawn record stays</numerusform>
            <numerusform>%n trainees moved by hand; the drawn records stay</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::AuditPage</name>
    <message numerus="yes">
        <source>⚠ %n finding(s). Do not report from this record before they are explained.</source>
        <translation>
            <numerusform>⚠ %n finding. Do not report from this record before they are explained.</numerusform>
            <numerusform>⚠ %n findings. Do not report from this record before they are explained.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln entries saved</source>
        <translation>
            <numerusform>%Ln entry saved</numerusform>
            <numerusform>%Ln entries saved</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::BriefingPage</name>
    <message numerus="yes">
        <source>Twist at least %n time(s).</source>
        <translation>
            <numerusform>Twist at least once.</numerusform>
            <numerusform>Twist at least %n times.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::CallBar</name>
    <message numerus="yes">
        <source>%1 of %n sheet(s) in</source>
        <translation>
            <numerusform>%1 of %n sheet is in</numerusform>
            <numerusform>%1 of %n sheets are in</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::CampaignDialog</name>
    <message numerus="yes">
        <source>%n rater(s) chosen.</source>
        <translation>
            <numerusform>%n rater chosen.</numerusform>
            <numerusform>%n raters chosen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::CompetenceDialog</name>
    <message numerus="yes">
        <source>%n expert(s): mean error %1°, mean and one standard deviation %2°, bound that covers nine in ten experts %3°.</source>
        <translation>
            <numerusform>%n expert: mean error %1°, mean and one standard deviation %2°, bound that covers nine in ten experts %3°.</numerusform>
            <numerusform>%n experts: mean error %1°, mean and one standard deviation %2°, bound that covers nine in ten experts %3°.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::ConsentDialog</name>
    <message numerus="yes">
        <source>Enter here what all %n of them signed on paper on the same day. Every decision is kept; the newest of a person about a purpose counts.</source>
        <translation>
            <numerusform>Enter here what %n person signed on paper. Every decision is kept; the newest of a person about a purpose counts.</numerusform>
            <numerusform>Enter here what all %n of them signed on paper on the same day. Every decision is kept; the newest of a person about a purpose counts.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::ConsentTextsDialog</name>
    <message numerus="yes">
        <source>%n form(s) written, the last one without a code</source>
        <translation>
            <numerusform>%n form written, without a code</numerusform>
            <numerusform>%n forms written, the last one without a code</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::CurriculaPage</name>
    <message numerus="yes">
        <source>%n version(s): cohorts can begin it again.</source>
        <translation>
            <numerusform>%n version: cohorts can begin it again.</numerusform>
            <numerusform>%n versions: cohorts can begin them again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n version(s): no new cohort can choose it; cohorts that follow it continue.</source>
        <translation>
            <numerusform>%n version: no further cohort can begin it; those who follow it go on.</numerusform>
            <numerusform>%n versions: no further cohort can begin them; those who follow them go on.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::CurriculumEditor</name>
    <message numerus="yes">
        <source>Check: %n to correct</source>
        <translation>
            <numerusform>Check: one to correct</numerusform>
            <numerusform>Check: %n to correct</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::DataTable</name>
    <message numerus="yes">
        <source>%n row(s)</source>
        <translation>
            <numerusform>%n row</numerusform>
            <numerusform>%n rows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n row(s)</source>
        <translation>
            <numerusform>%1 of %n row</numerusform>
            <numerusform>%1 of %n rows</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::DayPlanDialog</name>
    <message numerus="yes">
        <source>&amp;Add %n trainee(s) to the plan</source>
        <translation>
            <numerusform>&amp;Add %n trainee to the plan</numerusform>
            <numerusform>&amp;Add %n trainees to the plan</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::DebriefPage</name>
    <message numerus="yes">
        <source>%n twist(s) not completed and not counted.</source>
        <translation>
            <numerusform>One twist was not completed and is not counted.</numerusform>
            <numerusform>%n twists were not completed and are not counted.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::DeviationsDialog</name>
    <message numerus="yes">
        <source>%n deviation(s) stay as they are; a correction with this reason is added to each, in the report as well.</source>
        <translation>
            <numerusform>%n deviation stays as it is; a correction with this reason stands beside it, in the report as well.</numerusform>
            <numerusform>%n deviations stay as they are; a correction with this reason stands beside each, in the report as well.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::ExportDialog</name>
    <message numerus="yes">
        <source>%1 (%n rows)</source>
        <translation>
            <numerusform>%1 (%n row)</numerusform>
            <numerusform>%1 (%n rows)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Written: %1 (%n files). Hash: %2</source>
        <translation>
            <numerusform>Written: %1 (%n file). Hash: %2</numerusform>
            <numerusform>Written: %1 (%n files). Hash: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The tables below, the paths and forces of %n recordings, parameters of the tissue models, curriculum and definitions of metrics, in a new folder. No recordings that Torsio could replay.</source>
        <translation>
            <numerusform>The tables below, the paths and forces of %n recording, parameters of the tissue models, curriculum and definitions of metrics, in a new folder. No recordings that Torsio could replay.</numerusform>
            <numerusform>The tables below, the paths and forces of %n recordings, parameters of the tissue models, curriculum and definitions of metrics, in a new folder. No recordings that Torsio could replay.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::FigureCanvas</name>
    <message numerus="yes">
        <source>%n row(s) more in the table</source>
        <translation>
            <numerusform>%n row more in the table</numerusform>
            <numerusform>%n rows more in the table</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::HeadNotice</name>
    <message numerus="yes">
        <source>%Ln entry(s), %1 UTC, %2</source>
        <translation>
            <numerusform>%Ln entry, %1 UTC, %2</numerusform>
            <numerusform>%Ln entries, %1 UTC, %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::HeadsComparison</name>
    <message numerus="yes">
        <source>⚠ %n finding(s). Do not report from this record before they are explained.</source>
        <translation>
            <numerusform>⚠ %n finding. Do not report from this record before it is explained.</numerusform>
            <numerusform>⚠ %n findings. Do not report from this record before they are explained.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::MainWindow</name>
    <message numerus="yes">
        <source>The database permanently refused %Ln entries of this station. Please tell its administrator</source>
        <translation>
            <numerusform>The database permanently refused %Ln entry of this station. Please tell its administrator</numerusform>
            <numerusform>The database permanently refused %Ln entries of this station. Please tell its administrator</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::MaintenancePage</name>
    <message numerus="yes">
        <source>✗ Checked: %n finding(s), first: %1</source>
        <translation>
            <numerusform>✗ Checked: one finding: %1</numerusform>
            <numerusform>✗ Checked: %n findings, first: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::ModelComparison</name>
    <message numerus="yes">
        <source>for the whole twist, %n frame(s), median %1; set-up not included: %2</source>
        <translation>
            <numerusform>for the whole twist, %n frame, median %1; set-up not included: %2</numerusform>
            <numerusform>for the whole twist, %n frames, median %1; set-up not included: %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::NextStepPage</name>
    <message numerus="yes">
        <source>%n unread remark(s) from physicians</source>
        <translation>
            <numerusform>One unread remark from a physician</numerusform>
            <numerusform>%n unread remarks from physicians</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s) left</source>
        <translation>
            <numerusform>%n attempt left</numerusform>
            <numerusform>%n attempts left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n run(s)</source>
        <translation>
            <numerusform>One run</numerusform>
            <numerusform>%n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n twist(s)</source>
        <translation>
            <numerusform>one twist</numerusform>
            <numerusform>%n twists</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::OrganFindings</name>
    <message numerus="yes">
        <source>Accepted with %n warning(s), which stay with the organ</source>
        <translation>
            <numerusform>Accepted with %n warning, which stays with the organ</numerusform>
            <numerusform>Accepted with %n warnings, which stay with the organ</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::PeopleDialog</name>
    <message numerus="yes">
        <source>Add %n</source>
        <translation>
            <numerusform>Add one</numerusform>
            <numerusform>Add %n</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::PowerDialog</name>
    <message numerus="yes">
        <source>%n trainee(s)</source>
        <translation>
            <numerusform>%n trainee</numerusform>
            <numerusform>%n trainees</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trainee(s) in each group; %1 when scores are adjusted for the score before</source>
        <translation>
            <numerusform>%n trainee in each group; %1 when scores are adjusted for the score before</numerusform>
            <numerusform>%n trainees in each group; %1 when scores are adjusted for the score before</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::QueuePage</name>
    <message numerus="yes">
        <source>%n case(s) fit into ten minutes, %1</source>
        <translation>
            <numerusform>One case fits into ten minutes, %1</numerusform>
            <numerusform>%n cases fit into ten minutes, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RaterCalibrationDialog</name>
    <message numerus="yes">
        <source>No physician is given the chosen runs any more (%n). Marks given on them stay. A run that is withdrawn cannot be used for rater calibration again.</source>
        <translation>
            <numerusform>No physician is given this run any more. Marks given on it stay. A run that is withdrawn cannot be used for rater calibration again.</numerusform>
            <numerusform>No physician is given these %n runs any more. Marks given on them stay. A run that is withdrawn cannot be used for rater calibration again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Withdrawn from rater calibration: %n run(s)</source>
        <translation>
            <numerusform>Withdrawn from rater calibration: %n run</numerusform>
            <numerusform>Withdrawn from rater calibration: %n runs</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::ReadoutPanel</name>
    <message numerus="yes">
        <source>%1, %n late</source>
        <translation>
            <numerusform>%1, %n late</numerusform>
            <numerusform>%1, %n late</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RemarksPage</name>
    <message numerus="yes">
        <source>Your own marks beside the mean of %n physician(s).</source>
        <translation>
            <numerusform>Your own marks beside those of one physician.</numerusform>
            <numerusform>Your own marks beside the mean of %n physicians.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RemindDialog</name>
    <message numerus="yes">
        <source>&amp;Send %n message(s)</source>
        <translation>
            <numerusform>&amp;Send %n message</numerusform>
            <numerusform>&amp;Send %n messages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>✓ The mail server took %n message(s).</source>
        <translation>
            <numerusform>✓ The mail server took %n message.</numerusform>
            <numerusform>✓ The mail server took %n messages.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::ReplayPanel</name>
    <message numerus="yes">
        <source>at least %n twist(s)</source>
        <translation>
            <numerusform>at least %n twist</numerusform>
            <numerusform>at least %n twists</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RequestsDialog</name>
    <message numerus="yes">
        <source>%1 asks for these %n account(s): %2. Do you know of them, and are they right? What is not about an account is confirmed by itself.</source>
        <translation>
            <numerusform>%1 asks for %n account: %2. Do you know of it, and is it right? What is not about an account is confirmed by itself.</numerusform>
            <numerusform>%1 asks for these %n accounts: %2. Do you know of them, and are they right? What is not about an account is confirmed by itself.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n request(s) are closed and stay in the audit trail.</source>
        <translation>
            <numerusform>%n request is closed and stays in the audit trail.</numerusform>
            <numerusform>%n requests are closed and stay in the audit trail.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RestorePage</name>
    <message numerus="yes">
        <source>Erased after this backup: %n person(s). They stay erased.</source>
        <translation>
            <numerusform>Erased after this backup: one person, who stays erased.</numerusform>
            <numerusform>Erased after this backup: %n people. They stay erased.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RetentionQueue</name>
    <message numerus="yes">
        <source>Kept for another year: %n record(s), %1.</source>
        <translation>
            <numerusform>Kept for another year: %n record, %1.</numerusform>
            <numerusform>Kept for another year: %n records, %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>No longer held: %n record(s), %1.</source>
        <translation>
            <numerusform>No longer held: %n record, %1.</numerusform>
            <numerusform>No longer held: %n records, %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Kept until somebody releases them: %n record(s), %1.</source>
        <translation>
            <numerusform>Kept until somebody releases it: %n record, %1.</numerusform>
            <numerusform>Kept until somebody releases them: %n records, %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The identities of %1 are erased for good, and %n recording(s) with them. Marks stay without a person, so that statistics remain right.</source>
        <translation>
            <numerusform>The identities of %1 are erased for good, and %n recording with them. Marks stay without a person, so that statistics remain right.</numerusform>
            <numerusform>The identities of %1 are erased for good, and %n recordings with them. Marks stay without a person, so that statistics remain right.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RosterImportsDialog</name>
    <message numerus="yes">
        <source>%n import(s) undone</source>
        <translation>
            <numerusform>One import undone</numerusform>
            <numerusform>%n imports undone</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RosterPage</name>
    <message numerus="yes">
        <source>%n record(s) erased</source>
        <translation>
            <numerusform>%n record erased</numerusform>
            <numerusform>%n records erased</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RosterPreviewPage</name>
    <message numerus="yes">
        <source>Comparing %n line(s) with the record…</source>
        <translation>
            <numerusform>Comparing %n line with the record…</numerusform>
            <numerusform>Comparing %n lines with the record…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::RunPage</name>
    <message numerus="yes">
        <source>Only %1 of %n sheet(s) for this occasion are in; the others cannot be made up once training continues. Call the study team. Why should training begin anyway? It is noted as a deviation.</source>
        <translation>
            <numerusform>%1 of %n sheet for this occasion is in; the other cannot be made up once training continues. Call the study team. Why should training begin anyway? It is noted as a deviation.</numerusform>
            <numerusform>Only %1 of %n sheets for this occasion are in; the others cannot be made up once training continues. Call the study team. Why should training begin anyway? It is noted as a deviation.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::ScoringPage</name>
    <message numerus="yes">
        <source>%n sheet(s) asked for</source>
        <translation>
            <numerusform>%n sheet asked for</numerusform>
            <numerusform>%n sheets asked for</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) reassigned. Reassign can also return them.</source>
        <translation>
            <numerusform>One sheet reassigned. Reassign can also return it.</numerusform>
            <numerusform>%n sheets reassigned. Reassign can also return them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::Settling</name>
    <message numerus="yes">
        <source>%n recording(s) of this station could not be stored</source>
        <translation>
            <numerusform>%n recording of this station could not be stored</numerusform>
            <numerusform>%n recordings of this station could not be stored</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::TodaysSessionsPage</name>
    <message numerus="yes">
        <source>Written: %n trainee(s) to call</source>
        <translation>
            <numerusform>Written: %n trainee to call</numerusform>
            <numerusform>Written: %n trainees to call</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Written: %n sheet(s), a page each</source>
        <translation>
            <numerusform>Written: %n sheet, a page each</numerusform>
            <numerusform>Written: %n sheets, a page each</numerusform>
        </translation>
    </message>
</context>
</TS>
