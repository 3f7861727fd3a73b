<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ReminderText</name>
    <message numerus="yes">
        <source>Copied: the sheets that %n rater(s) owe</source>
        <translation>
            <numerusform>Copied: the sheets that %n rater owes</numerusform>
            <numerusform>Copied: the sheets that %n raters owe</numerusform>
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
        <source>%n entries saved</source>
        <translation>
            <numerusform>%n entry saved</numerusform>
            <numerusform>%n entries saved</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::CallBar</name>
    <message numerus="yes">
        <source>and %n more late</source>
        <translation>
            <numerusform>and %n more late</numerusform>
            <numerusform>and %n more late</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::CurriculumEditor</name>
    <message numerus="yes">
        <source>Check: %n to mend</source>
        <translation>
            <numerusform>Check: %n to mend</numerusform>
            <numerusform>Check: %n to mend</numerusform>
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
    <name>torsio::gui::HeadsPage</name>
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
        <source>%n recording(s) of this station could not be stored</source>
        <translation>
            <numerusform>%n recording of this station could not be stored</numerusform>
            <numerusform>%n recordings of this station could not be stored</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::ModelComparison</name>
    <message numerus="yes">
        <source>for the whole twist, %n frame(s) of %1; set-up apart: %2</source>
        <translation>
            <numerusform>for the whole twist, %n frame of %1; set-up apart: %2</numerusform>
            <numerusform>for the whole twist, %n frames of %1; set-up apart: %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>torsio::gui::PeopleDialog</name>
    <message numerus="yes">
        <source>Take %n</source>
        <translation>
            <numerusform>Take %n</numerusform>
            <numerusform>Take %n</numerusform>
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
    <name>torsio::gui::RunDayPage</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
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
<context>
    <name>torsio::gui::ScoringPage</name>
    <message numerus="yes">
        <source>%n sheet(s) asked for</source>
        <translation>
            <numerusform>%n sheet asked for</numerusform>
            <numerusform>%n sheets asked for</numerusform>
        </translation>
    </message>
</context>
</TS>
