<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AccessTexts</name>
    <message numerus="yes">
        <source>99 % of the writes of %n R-parameters end within %1.</source>
        <translation>
            <numerusform>99 % of the writes of %n R-parameter end within %1.</numerusform>
            <numerusform>99 % of the writes of %n R-parameters end within %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Up to %n R-parameters were measured.</source>
        <translation>
            <numerusform>Up to %n R-parameter was measured.</numerusform>
            <numerusform>Up to %n R-parameters were measured.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FoundRunTexts</name>
    <message numerus="yes">
        <source>%Ln windows executed</source>
        <translation>
            <numerusform>%Ln window executed</numerusform>
            <numerusform>%Ln windows executed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>JobTexts</name>
    <message numerus="yes">
        <source>Part %1 of %2: lines %3 to %4 are streamed, %Ln points.</source>
        <translation>
            <numerusform>Part %1 of %2: lines %3 to %4 are streamed, %Ln point.</numerusform>
            <numerusform>Part %1 of %2: lines %3 to %4 are streamed, %Ln points.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LiveTexts</name>
    <message numerus="yes">
        <source>%Ln points merged</source>
        <translation>
            <numerusform>%Ln point merged</numerusform>
            <numerusform>%Ln points merged</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MachineCard</name>
    <message numerus="yes">
        <source>%n alarms</source>
        <translation>
            <numerusform>%n alarm</numerusform>
            <numerusform>%n alarms</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProgramTexts</name>
    <message numerus="yes">
        <source>Opened %1 (%2), %Ln points.</source>
        <translation>
            <numerusform>Opened %1 (%2), %Ln point.</numerusform>
            <numerusform>Opened %1 (%2), %Ln points.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RehearsalTexts</name>
    <message numerus="yes">
        <source>Simulation of %1: no wrong point in %n runs.</source>
        <translation>
            <numerusform>Simulation of %1: no wrong point in %n run.</numerusform>
            <numerusform>Simulation of %1: no wrong point in %n runs.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ServerModel</name>
    <message numerus="yes">
        <source>valid for %Ln days</source>
        <translation>
            <numerusform>valid for %Ln day</numerusform>
            <numerusform>valid for %Ln days</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>TemplateSheetTexts</name>
    <message numerus="yes">
        <source>In Rivulet, column Settings, tick “copied by hand” at Template. Look through what Start shows, then hold Start. From then on Rivulet waits up to %n minutes.</source>
        <translation>
            <numerusform>In Rivulet, column Settings, tick “copied by hand” at Template. Look through what Start shows, then hold Start. From then on Rivulet waits up to %n minute.</numerusform>
            <numerusform>In Rivulet, column Settings, tick “copied by hand” at Template. Look through what Start shows, then hold Start. From then on Rivulet waits up to %n minutes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Preflight</name>
    <message numerus="yes">
        <source>%1, version %2, %Ln points</source>
        <translation>
            <numerusform>%1, version %2, %Ln point</numerusform>
            <numerusform>%1, version %2, %Ln points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln part</numerusform>
            <numerusform>%Ln parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln blocks are left out: %1</source>
        <translation>
            <numerusform>%Ln block is left out: %1</numerusform>
            <numerusform>%Ln blocks are left out: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line over %1 to %2. %Ln points have been executed.</source>
        <translation>
            <numerusform>In a straight line over %1 to %2. %Ln point has been executed.</numerusform>
            <numerusform>In a straight line over %1 to %2. %Ln points have been executed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line to %1. %Ln points have been executed.</source>
        <translation>
            <numerusform>In a straight line to %1. %Ln point has been executed.</numerusform>
            <numerusform>In a straight line to %1. %Ln points have been executed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Streamed: %1; the control executes %Ln blocks: %2</source>
        <translation>
            <numerusform>Streamed: %1; the control executes %Ln block: %2</numerusform>
            <numerusform>Streamed: %1; the control executes %Ln blocks: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The %Ln points before it are not executed.</source>
        <translation>
            <numerusform>The %Ln point before it is not executed.</numerusform>
            <numerusform>The %Ln points before it are not executed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 (line %2, %Ln times)</source>
        <translation>
            <numerusform>%1 (line %2, once)</numerusform>
            <numerusform>%1 (line %2, %Ln times)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::RunController</name>
    <message numerus="yes">
        <source>Start of a whole job: %1, %Ln blocks for the control.</source>
        <translation>
            <numerusform>Start of a whole job: %1, %Ln block for the control.</numerusform>
            <numerusform>Start of a whole job: %1, %Ln blocks for the control.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln part</numerusform>
            <numerusform>%Ln parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The job goes on at line %1, after %Ln blocks of the control.</source>
        <translation>
            <numerusform>The job goes on at line %1, after %Ln block of the control.</numerusform>
            <numerusform>The job goes on at line %1, after %Ln blocks of the control.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmPage</name>
    <message numerus="yes">
        <source>For %n minutes</source>
        <translation>
            <numerusform>For %n minute</numerusform>
            <numerusform>For %n minutes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n hours</source>
        <translation>
            <numerusform>For %n hour</numerusform>
            <numerusform>For %n hours</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CertificatesPage</name>
    <message numerus="yes">
        <source>Valid for %Ln more days (%1)</source>
        <translation>
            <numerusform>Valid for %Ln more day (%1)</numerusform>
            <numerusform>Valid for %Ln more days (%1)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogView</name>
    <message numerus="yes">
        <source>%Ln messages</source>
        <translation>
            <numerusform>%Ln message</numerusform>
            <numerusform>%Ln messages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MachinesPage</name>
    <message numerus="yes">
        <source>%Ln virtual machines of this computer do not answer any more, and nothing but their runs is kept.</source>
        <translation>
            <numerusform>%Ln virtual machine of this computer does not answer any more, and nothing but its runs is kept.</numerusform>
            <numerusform>%Ln virtual machines of this computer do not answer any more, and nothing but their runs is kept.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathView</name>
    <message numerus="yes">
        <source>%Ln pauses off the cut</source>
        <translation>
            <numerusform>%Ln pause off the cut</numerusform>
            <numerusform>%Ln pauses off the cut</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PreflightSheet</name>
    <message numerus="yes">
        <source>%Ln checks: %1</source>
        <translation>
            <numerusform>%Ln check: %1</numerusform>
            <numerusform>%Ln checks: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramPanel</name>
    <message numerus="yes">
        <source>%1 … %2 (%Ln values)</source>
        <translation>
            <numerusform>%1 … %2 (%Ln value)</numerusform>
            <numerusform>%1 … %2 (%Ln values)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 with %Ln pauses, which cost %2</source>
        <translation>
            <numerusform>%1 with %Ln pause, which costs %2</numerusform>
            <numerusform>%1 with %Ln pauses, which cost %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln lines</source>
        <translation>
            <numerusform>%Ln line</numerusform>
            <numerusform>%Ln lines</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ResumeBar</name>
    <message numerus="yes">
        <source>Before that, the control executes %Ln blocks: see the list.</source>
        <translation>
            <numerusform>Before that, the control executes %Ln block: see the list.</numerusform>
            <numerusform>Before that, the control executes %Ln blocks: see the list.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunPanel</name>
    <message numerus="yes">
        <source>%Ln windows</source>
        <translation>
            <numerusform>%Ln window</numerusform>
            <numerusform>%Ln windows</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln moves in hand</source>
        <translation>
            <numerusform>%Ln move in hand</numerusform>
            <numerusform>%Ln moves in hand</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ServicePanel</name>
    <message numerus="yes">
        <source>%Ln windows late</source>
        <translation>
            <numerusform>%Ln window late</numerusform>
            <numerusform>%Ln windows late</numerusform>
        </translation>
    </message>
</context>
</TS>
