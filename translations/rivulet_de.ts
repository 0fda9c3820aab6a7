<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AccessTexts</name>
    <message>
        <source>Access calibrated on %1 (%2): t = %3; read %4, write %5.</source>
        <translation>Zugriff kalibriert am %1 (%2): t = %3; Lesen %4, Schreiben %5.</translation>
    </message>
    <message>
        <source>list</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>one by one</source>
        <translation>einzeln</translation>
    </message>
    <message>
        <source>array, by count</source>
        <translation>Feld, mit Anzahl</translation>
    </message>
    <message>
        <source>array, by range</source>
        <translation>Feld, mit Bereich</translation>
    </message>
    <message>
        <source>a server without a name</source>
        <translation>ein Server ohne Namen</translation>
    </message>
    <message>
        <source>Access is assumed: %1 for each R-parameter. See Calibration.</source>
        <translation>Der Zugriff ist angenommen: %1 je R-Parameter. Siehe Kalibrierung.</translation>
    </message>
    <message>
        <source>Access is assumed: %1 for each R-parameter. The calibration of %2 belongs to another version of the server and is not used.</source>
        <translation>Der Zugriff ist angenommen: %1 je R-Parameter. Die Kalibrierung vom %2 gehört zu einer anderen Version des Servers und wird nicht verwendet.</translation>
    </message>
    <message numerus="yes">
        <source>99 % of the writes of %n R-parameters end within %1.</source>
        <translation>
            <numerusform>99 % der Schreibzugriffe auf %n R-Parameter enden innerhalb von %1.</numerusform>
            <numerusform>99 % der Schreibzugriffe auf %n R-Parameter enden innerhalb von %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Up to %n R-parameters were measured.</source>
        <translation>
            <numerusform>Gemessen wurde bis zu %n R-Parameter.</numerusform>
            <numerusform>Gemessen wurden bis zu %n R-Parameter.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>AlarmTexts</name>
    <message>
        <source>The control reports alarm %1.</source>
        <translation>Die Steuerung meldet Alarm %1.</translation>
    </message>
    <message>
        <source>The control has stopped or limits the machine; the number says why.</source>
        <translation>Die Steuerung hat die Maschine angehalten oder begrenzt sie; die Nummer sagt, warum.</translation>
    </message>
    <message>
        <source>Look up alarm %1 at the control, remove its cause, then press reset there.</source>
        <translation>Alarm %1 an der Steuerung nachschlagen, Ursache beseitigen, dann dort Reset drücken.</translation>
    </message>
    <message>
        <source>The connection to %1 is lost.</source>
        <translation>Die Verbindung zu %1 ist unterbrochen.</translation>
    </message>
    <message>
        <source>No connection to %1.</source>
        <translation>Keine Verbindung zu %1.</translation>
    </message>
    <message>
        <source>Wrong motion in %1 (points repeated: %2, skipped: %3). The workpiece may be spoilt.</source>
        <translation>Falsche Bewegung in %1 (Punkte wiederholt: %2, ausgelassen: %3). Das Werkstück kann verdorben sein.</translation>
    </message>
    <message>
        <source>Points came too late for this feed with these settings.</source>
        <translation>Die Punkte kamen für diesen Vorschub mit diesen Einstellungen zu spät.</translation>
    </message>
    <message>
        <source>Check workpiece and tool. Choose a smaller feed, or method window.</source>
        <translation>Werkstück und Werkzeug prüfen. Kleineren Vorschub oder das Verfahren Fenster wählen.</translation>
    </message>
    <message>
        <source>The run of %1 was ended by a fault.</source>
        <translation>Der Lauf von %1 wurde durch einen Fehler beendet.</translation>
    </message>
    <message>
        <source>Check tool and workpiece, remove the cause, then resume or start again.</source>
        <translation>Werkzeug und Werkstück prüfen, Ursache beseitigen, dann fortsetzen oder neu starten.</translation>
    </message>
    <message>
        <source>%1 ended before its end: %2 of %3 points were executed.</source>
        <translation>%1 endete zu früh: %2 von %3 Punkten wurden ausgeführt.</translation>
    </message>
    <message>
        <source>The control&apos;s trace lacks the last points.</source>
        <translation>In der Aufzeichnung der Steuerung fehlen die letzten Punkte.</translation>
    </message>
    <message>
        <source>Check tool and workpiece before you go on.</source>
        <translation>Werkzeug und Werkstück prüfen, bevor es weitergeht.</translation>
    </message>
    <message>
        <source>It is not known whether %1 was executed without a fault.</source>
        <translation>Es ist nicht bekannt, ob %1 fehlerfrei ausgeführt wurde.</translation>
    </message>
    <message>
        <source>The control&apos;s trace could not be read, or is shorter than the run.</source>
        <translation>Die Aufzeichnung der Steuerung war nicht lesbar oder ist kürzer als der Lauf.</translation>
    </message>
    <message>
        <source>Check the workpiece.</source>
        <translation>Werkstück prüfen.</translation>
    </message>
    <message>
        <source>The run is not recorded.</source>
        <translation>Der Lauf wird nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>Nothing can be written to the folder %1.</source>
        <translation>In den Ordner %1 kann nichts geschrieben werden.</translation>
    </message>
    <message>
        <source>Check the folder, its permissions and the free space.</source>
        <translation>Ordner, Rechte und freien Speicherplatz prüfen.</translation>
    </message>
    <message>
        <source>The program file %1 has changed since it was read.</source>
        <translation>Die Programmdatei %1 hat sich geändert, seit sie gelesen wurde.</translation>
    </message>
    <message>
        <source>Another program has written the file.</source>
        <translation>Ein anderes Programm hat die Datei geschrieben.</translation>
    </message>
    <message>
        <source>Reload the file before you start.</source>
        <translation>Die Datei vor dem Start neu laden.</translation>
    </message>
    <message>
        <source>The program file %1 is no longer there.</source>
        <translation>Die Programmdatei %1 ist nicht mehr da.</translation>
    </message>
    <message>
        <source>It was deleted or moved, or its drive is not connected.</source>
        <translation>Sie wurde gelöscht oder verschoben, oder ihr Laufwerk ist nicht verbunden.</translation>
    </message>
    <message>
        <source>Bring the file back, or go on with what was read before it disappeared.</source>
        <translation>Die Datei zurückholen oder mit dem weiterarbeiten, was vorher gelesen wurde.</translation>
    </message>
    <message>
        <source>The calibration of %1 has failed.</source>
        <translation>Die Kalibrierung von %1 ist fehlgeschlagen.</translation>
    </message>
    <message>
        <source>Remove the cause, then measure again.</source>
        <translation>Ursache beseitigen, dann neu messen.</translation>
    </message>
    <message>
        <source>The calibration of %1 is not saved.</source>
        <translation>Die Kalibrierung von %1 ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>Check the folder and the free space, then measure again.</source>
        <translation>Ordner und freien Speicherplatz prüfen, dann neu messen.</translation>
    </message>
    <message>
        <source>The history of alarms is not written to %1.</source>
        <translation>Der Alarmverlauf wird nicht in %1 geschrieben.</translation>
    </message>
    <message>
        <source>The audit trail is not written to %1.</source>
        <translation>Das Protokoll der Bedienung wird nicht in %1 geschrieben.</translation>
    </message>
    <message>
        <source>The audit trail %1 was changed: see line %2.</source>
        <translation>Das Protokoll der Bedienung %1 wurde verändert: siehe Zeile %2.</translation>
    </message>
    <message>
        <source>A line was edited, inserted or removed after it was written.</source>
        <translation>Eine Zeile wurde nachträglich geändert, eingefügt oder entfernt.</translation>
    </message>
    <message>
        <source>Keep a copy of the file and find out who changed it.</source>
        <translation>Eine Kopie der Datei aufbewahren und klären, wer sie verändert hat.</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Aktiv</translation>
    </message>
    <message>
        <source>Active, acknowledged</source>
        <translation>Aktiv, quittiert</translation>
    </message>
    <message>
        <source>Gone, not acknowledged</source>
        <translation>Gegangen, nicht quittiert</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>Zurückgestellt</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Gekommen</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>Gegangen</translation>
    </message>
    <message>
        <source>Acknowledged</source>
        <translation>Quittiert</translation>
    </message>
    <message>
        <source>Taken back</source>
        <translation>Zurückgeholt</translation>
    </message>
    <message>
        <source>Shelving expired</source>
        <translation>Zurückstellung abgelaufen</translation>
    </message>
    <message>
        <source>Look at the machine: it may still move. Check cable and control, then connect again.</source>
        <translation>Auf die Maschine sehen: Sie kann sich noch bewegen. Kabel und Steuerung prüfen, neu verbinden.</translation>
    </message>
    <message>
        <source>Wrong motion in %1 after point %2: points are repeated, or the tool has left the path.</source>
        <translation>Falsche Bewegung in %1 nach Punkt %2: Punkte werden wiederholt, oder das Werkzeug hat die Bahn verlassen.</translation>
    </message>
    <message>
        <source>Points came too late for this feed with these settings, or something else moves the axes.</source>
        <translation>Punkte kamen für diesen Vorschub mit diesen Einstellungen zu spät, oder etwas anderes bewegt die Achsen.</translation>
    </message>
    <message>
        <source>Stop the run, then check workpiece and tool.</source>
        <translation>Den Lauf stoppen, dann Werkstück und Werkzeug prüfen.</translation>
    </message>
    <message>
        <source>The recording of %1 was cut off: the first %2 s of the run are in it.</source>
        <translation>Die Aufzeichnung von %1 wurde abgeschnitten: Die ersten %2 s des Laufs sind darin.</translation>
    </message>
    <message>
        <source>Nothing more can be written to the folder %3: its disk is full, or too slow.</source>
        <translation>In den Ordner %3 kann nichts mehr geschrieben werden: Der Datenträger ist voll oder zu langsam.</translation>
    </message>
    <message>
        <source>Make room on the disk. A run in progress goes on without its recording; the next one is recorded.</source>
        <translation>Platz auf dem Datenträger schaffen. Ein Lauf, der gerade läuft, geht ohne Aufzeichnung weiter; der nächste wird aufgezeichnet.</translation>
    </message>
</context>
<context>
    <name>AuditTexts</name>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Online correction</source>
        <translation>Online-Korrektur</translation>
    </message>
    <message>
        <source>Program opened</source>
        <translation>Programm geöffnet</translation>
    </message>
    <message>
        <source>Settings changed</source>
        <translation>Einstellungen geändert</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Release taken back</source>
        <translation>Freigabe zurückgenommen</translation>
    </message>
    <message>
        <source>Alarm acknowledged</source>
        <translation>Alarm quittiert</translation>
    </message>
    <message>
        <source>Alarm shelved</source>
        <translation>Alarm zurückgestellt</translation>
    </message>
    <message>
        <source>Users set up</source>
        <translation>Benutzer eingerichtet</translation>
    </message>
    <message>
        <source>Logged in</source>
        <translation>Angemeldet</translation>
    </message>
    <message>
        <source>Wrong PIN</source>
        <translation>Falsche PIN</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>Rivulet started</source>
        <translation>Rivulet gestartet</translation>
    </message>
    <message>
        <source>Rivulet ended</source>
        <translation>Rivulet beendet</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>Einrichter</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>Trust</source>
        <translation>Vertrauen</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
</context>
<context>
    <name>BlockedTexts</name>
    <message>
        <source>A run is in progress.</source>
        <translation>Ein Lauf ist aktiv.</translation>
    </message>
    <message>
        <source>Asking the control where the run was left.</source>
        <translation>Die Steuerung wird gefragt, wo der Lauf unterbrochen wurde.</translation>
    </message>
    <message>
        <source>A calibration is in progress.</source>
        <translation>Eine Kalibrierung läuft.</translation>
    </message>
    <message>
        <source>Connect to a control first.</source>
        <translation>Zuerst mit einer Steuerung verbinden.</translation>
    </message>
    <message>
        <source>Open a program first.</source>
        <translation>Zuerst ein Programm öffnen.</translation>
    </message>
    <message>
        <source>The file of the program has changed: reload it.</source>
        <translation>Die Programmdatei wurde geändert: bitte neu laden.</translation>
    </message>
    <message>
        <source>The program moves no axis.</source>
        <translation>Das Programm bewegt keine Achse.</translation>
    </message>
    <message>
        <source>The program needs a transformation of the control. No method can stream it.</source>
        <translation>Das Programm braucht eine Transformation der Steuerung. Kein Verfahren kann es streamen.</translation>
    </message>
    <message>
        <source>Parts of the program&apos;s path are not known: see the findings.</source>
        <translation>Die Bahn des Programms ist nicht vollständig bekannt: siehe Befunde.</translation>
    </message>
    <message>
        <source>The program moves rotary axes: choose method window.</source>
        <translation>Das Programm bewegt Rundachsen: Verfahren Fenster wählen.</translation>
    </message>
    <message>
        <source>The program moves %1, but the control does not have all of these axes.</source>
        <translation>Das Programm bewegt %1, aber die Steuerung hat nicht alle diese Achsen.</translation>
    </message>
    <message>
        <source>Not feasible: the control would repeat points. Change F, N or δ.</source>
        <translation>Nicht machbar: Die Steuerung würde Punkte wiederholen. F, N oder δ ändern.</translation>
    </message>
    <message>
        <source>Method credit starts only on a control that has passed its test: choose method window.</source>
        <translation>Das Verfahren Kredit startet nur an einer Steuerung, die den Test bestanden hat: Verfahren Fenster wählen.</translation>
    </message>
    <message>
        <source>The control reports an alarm.</source>
        <translation>Die Steuerung meldet einen Alarm.</translation>
    </message>
    <message>
        <source>A program is running on the control.</source>
        <translation>Auf der Steuerung läuft ein Programm.</translation>
    </message>
    <message>
        <source>There is no interrupted run of method window.</source>
        <translation>Es gibt keinen unterbrochenen Lauf des Verfahrens Fenster.</translation>
    </message>
    <message>
        <source>Only method window can resume an interrupted run.</source>
        <translation>Nur das Verfahren Fenster kann einen unterbrochenen Lauf fortsetzen.</translation>
    </message>
    <message>
        <source>The program is being simulated.</source>
        <translation>Das Programm wird simuliert.</translation>
    </message>
    <message>
        <source>The simulation of this program failed in %1 of %2 runs. Change F, N or δ.</source>
        <translation>Die Simulation dieses Programms schlug in %1 von %2 Läufen fehl. F, N oder δ ändern.</translation>
    </message>
    <message>
        <source>The window is locked: log in.</source>
        <translation>Das Fenster ist gesperrt: anmelden.</translation>
    </message>
    <message>
        <source>Only an engineer may do this.</source>
        <translation>Das darf nur ein Einrichter.</translation>
    </message>
    <message>
        <source>Not released: an engineer has to release this program with these settings.</source>
        <translation>Nicht freigegeben: Ein Einrichter muss dieses Programm mit diesen Einstellungen freigeben.</translation>
    </message>
    <message>
        <source>A test of the control is in progress.</source>
        <translation>Ein Test der Steuerung läuft.</translation>
    </message>
    <message>
        <source>The job is being compared with the machine.</source>
        <translation>Der Auftrag wird mit der Maschine verglichen.</translation>
    </message>
    <message>
        <source>Live points need a machine that waits for them: choose method window or credit.</source>
        <translation>Live-Punkte brauchen eine Maschine, die auf sie wartet: Verfahren Fenster oder Kredit wählen.</translation>
    </message>
    <message>
        <source>Method %1 may execute old points again: if this computer is late for a moment, the tool goes back through the workpiece. Choose method window.</source>
        <translation>Verfahren %1 kann alte Punkte noch einmal ausführen: Ist dieser Rechner einen Moment zu spät, fährt das Werkzeug durch das Werkstück zurück. Verfahren Fenster wählen.</translation>
    </message>
</context>
<context>
    <name>CertificateTexts</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>sich selbst</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>nicht angegeben</translation>
    </message>
</context>
<context>
    <name>ConnectionTexts</name>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>Connecting …</source>
        <translation>Verbindet …</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Verbindung verloren</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation>Unbekannt (%1)</translation>
    </message>
    <message>
        <source>encrypted</source>
        <translation>verschlüsselt</translation>
    </message>
    <message>
        <source>Nobody on the network can read or change what is sent.</source>
        <translation>Niemand im Netz kann mitlesen oder ändern, was gesendet wird.</translation>
    </message>
    <message>
        <source>signed</source>
        <translation>signiert</translation>
    </message>
    <message>
        <source>Nobody can change what is sent, but everybody on the network can read it.</source>
        <translation>Niemand kann ändern, was gesendet wird, aber jeder im Netz kann mitlesen.</translation>
    </message>
    <message>
        <source>weakly encrypted</source>
        <translation>schwach verschlüsselt</translation>
    </message>
    <message>
        <source>This encryption was withdrawn: it can be broken with the means of today.</source>
        <translation>Diese Verschlüsselung wurde zurückgezogen: Sie lässt sich mit heutigen Mitteln brechen.</translation>
    </message>
    <message>
        <source>not protected</source>
        <translation>ungeschützt</translation>
    </message>
    <message>
        <source>Not encrypted. What is sent does not leave this computer.</source>
        <translation>Unverschlüsselt. Was gesendet wird, verlässt diesen Rechner nicht.</translation>
    </message>
    <message>
        <source>Everybody on the network can read what is sent, and move the machine.</source>
        <translation>Jeder im Netz kann mitlesen und die Maschine bewegen.</translation>
    </message>
</context>
<context>
    <name>ControlSettings</name>
    <message>
        <source>R plane of a cycle without R: below the height before it, mm</source>
        <translation>R-Ebene eines Zyklus ohne R: unter der Höhe davor, mm</translation>
    </message>
    <message>
        <source>peck depth of G73 and G83 without Q, mm (0: in one stroke)</source>
        <translation>Zustelltiefe von G73 und G83 ohne Q, mm (0: in einem Zug)</translation>
    </message>
    <message>
        <source>spindle speed of tapping without S, 1/min</source>
        <translation>Spindeldrehzahl beim Gewindebohren ohne S, 1/min</translation>
    </message>
    <message>
        <source>direction in which a boring tool lifts off (X, -X, Y, -Y, Z, -Z)</source>
        <translation>Richtung, in der ein Ausdrehwerkzeug abhebt (X, -X, Y, -Y, Z, -Z)</translation>
    </message>
    <message>
        <source>lift-off of a boring tool without Q, mm</source>
        <translation>Abheben eines Ausdrehwerkzeugs ohne Q, mm</translation>
    </message>
    <message>
        <source>angle of the spindle when a boring tool lifts off, degrees</source>
        <translation>Winkel der Spindel beim Abheben eines Ausdrehwerkzeugs, Grad</translation>
    </message>
    <message>
        <source>an arc without centre and radius is a straight line</source>
        <translation>Ein Kreis ohne Mittelpunkt und Radius ist eine Gerade</translation>
    </message>
    <message>
        <source>settable work offset for G54.1 P1 (507: G507)</source>
        <translation>Einstellbare Nullpunktverschiebung für G54.1 P1 (507: G507)</translation>
    </message>
    <message>
        <source>retraction of G73 and G83 within the hole, mm</source>
        <translation>Rückzug von G73 und G83 in der Bohrung, mm</translation>
    </message>
    <message>
        <source>before the start the tool stands where the first G92 says, in the work offset of the control</source>
        <translation>vor dem Start steht das Werkzeug dort, wo das erste G92 sagt, in der Nullpunktverschiebung der Steuerung</translation>
    </message>
</context>
<context>
    <name>CreditTestTexts</name>
    <message>
        <source>%1 of %2 answers while busy, the slowest after %3</source>
        <translation>%1 von %2 Antworten unter Last, die langsamste nach %3</translation>
    </message>
    <message>
        <source>Method credit lets the axes move on while the next window is on its way. That is safe only on a control that answers while its axes are busy. This test finds out: a program that moves no axis, for a few seconds. The channel must be in reset.</source>
        <translation>Mit dem Verfahren Kredit fahren die Achsen weiter, während das nächste Fenster unterwegs ist. Sicher ist das nur an einer Steuerung, die antwortet, während ihre Achsen beschäftigt sind. Dieser Test stellt es fest: ein Programm, das keine Achse bewegt, einige Sekunden lang. Der Kanal muss im Reset sein.</translation>
    </message>
    <message>
        <source>4. Numbers are sent and must come back while the control is busy.</source>
        <translation>4. Zahlen werden gesendet und müssen zurückkommen, während die Steuerung beschäftigt ist.</translation>
    </message>
    <message>
        <source>Not tested: method credit does not start on this control</source>
        <translation>Nicht getestet: Das Verfahren Kredit startet auf dieser Steuerung nicht</translation>
    </message>
    <message>
        <source>Passed: method credit may run on this control</source>
        <translation>Bestanden: Das Verfahren Kredit darf auf dieser Steuerung laufen</translation>
    </message>
    <message>
        <source>Not passed: method credit does not start. Use method window.</source>
        <translation>Nicht bestanden: Das Verfahren Kredit startet nicht. Verfahren Fenster wählen.</translation>
    </message>
    <message>
        <source>The control answers the client while blocks wait to be executed.</source>
        <translation>Die Steuerung antwortet dem Client, während Sätze auf ihre Ausführung warten.</translation>
    </message>
    <message>
        <source>What a synchronized action writes reaches the client.</source>
        <translation>Was eine Synchronaktion schreibt, kommt beim Client an.</translation>
    </message>
    <message>
        <source>What a synchronized action writes reaches the program without a stop.</source>
        <translation>Was eine Synchronaktion schreibt, kommt ohne Halt beim Programm an.</translation>
    </message>
    <message>
        <source>A synchronized action before a block is executed with that block.</source>
        <translation>Eine Synchronaktion vor einem Satz wird mit diesem Satz ausgeführt.</translation>
    </message>
    <message>
        <source>The program can tell, without a stop, whether blocks are waiting ($AC_IPO_BUF).</source>
        <translation>Das Programm erkennt ohne Halt, ob Sätze warten ($AC_IPO_BUF).</translation>
    </message>
</context>
<context>
    <name>DiagnosticTexts</name>
    <message>
        <source>Note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: the run does not wait here, and no tool is changed.</source>
        <translation>%1 wird nicht an die Steuerung gesendet: Der Lauf wartet hier nicht, und kein Werkzeug wird gewechselt.</translation>
    </message>
    <message>
        <source>A block with &quot;/&quot; is executed: Rivulet reads the program with block skip off.</source>
        <translation>Ein Satz mit „/“ wird ausgeführt: Rivulet liest das Programm ohne Satzausblenden.</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: set spindle, tool and coolant there.</source>
        <translation>%1 wird nicht an die Steuerung gesendet: Spindel, Werkzeug und Kühlmittel dort einstellen.</translation>
    </message>
    <message>
        <source>The character &quot;%1&quot; has no meaning here: remove it or put it into a comment.</source>
        <translation>Das Zeichen „%1“ hat hier keine Bedeutung: entfernen oder in einen Kommentar setzen.</translation>
    </message>
    <message>
        <source>The word %1 has no number.</source>
        <translation>Dem Wort %1 fehlt die Zahl.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number: write digits with a decimal point.</source>
        <translation>„%1“ ist keine Zahl: Ziffern mit Dezimalpunkt schreiben.</translation>
    </message>
    <message>
        <source>A bracket is opened but not closed in this line: the rest of the line is not read.</source>
        <translation>Eine Klammer wird in dieser Zeile geöffnet, aber nicht geschlossen: Der Rest der Zeile wird nicht gelesen.</translation>
    </message>
    <message>
        <source>Rivulet does not know the G function %1: its effect on the path is unknown.</source>
        <translation>Rivulet kennt die G-Funktion %1 nicht: Ihre Wirkung auf die Bahn ist unbekannt.</translation>
    </message>
    <message>
        <source>The word %1 is not understood here: its effect on the path is unknown.</source>
        <translation>Das Wort %1 wird hier nicht verstanden: Seine Wirkung auf die Bahn ist unbekannt.</translation>
    </message>
    <message>
        <source>%1 changes the path or the feed in a way that Rivulet does not support: post-process the program without it.</source>
        <translation>%1 ändert Bahn oder Vorschub auf eine Weise, die Rivulet nicht unterstützt: Das Programm ohne diese Funktion ausgeben.</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: it does not change the path.</source>
        <translation>%1 wird nicht an die Steuerung gesendet: Die Bahn ändert sich dadurch nicht.</translation>
    </message>
    <message>
        <source>%1 contradict each other in one block: keep one of them.</source>
        <translation>%1 widersprechen sich in einem Satz: nur eines davon behalten.</translation>
    </message>
    <message>
        <source>The word %1 appears twice in one block: keep one of them.</source>
        <translation>Das Wort %1 steht zweimal in einem Satz: nur eines davon behalten.</translation>
    </message>
    <message>
        <source>The arc has no centre: give I, J, K, or a radius with an end point that differs from the start.</source>
        <translation>Der Kreisbogen hat keinen Mittelpunkt: I, J, K angeben oder einen Radius mit einem Endpunkt, der nicht der Anfangspunkt ist.</translation>
    </message>
    <message>
        <source>The arc&apos;s radius differs by %1 mm between start and end: check the centre, which is read as an increment from the start.</source>
        <translation>Der Radius des Bogens unterscheidet sich zwischen Anfangs- und Endpunkt um %1 mm: den Mittelpunkt prüfen, er wird relativ zum Anfangspunkt gelesen.</translation>
    </message>
    <message>
        <source>The arc&apos;s radius is too small to reach its end point (radius &lt; half chord, mm: %1).</source>
        <translation>Der Radius des Bogens ist zu klein für seinen Endpunkt (Radius &lt; halbe Sehne, mm: %1).</translation>
    </message>
    <message>
        <source>The arc starts at an unknown position: program %1 with G0 or G1 before it.</source>
        <translation>Der Bogen beginnt an unbekannter Position: vorher %1 mit G0 oder G1 programmieren.</translation>
    </message>
    <message>
        <source>The increment of %1 starts at an unknown position: program %1 with G90 before it.</source>
        <translation>Das Kettenmaß von %1 beginnt an unbekannter Position: vorher %1 mit G90 programmieren.</translation>
    </message>
    <message>
        <source>The feed F%1 is not greater than 0.</source>
        <translation>Der Vorschub F%1 ist nicht größer als 0.</translation>
    </message>
    <message>
        <source>The value of %1 is outside the range that Rivulet accepts.</source>
        <translation>Der Wert von %1 liegt außerhalb des zulässigen Bereichs.</translation>
    </message>
    <message>
        <source>An axis is programmed before any of G0 to G3: G1 is assumed, as after a reset of the control.</source>
        <translation>Eine Achse ist vor dem ersten G0 bis G3 programmiert: Es wird G1 angenommen, wie nach einem Reset der Steuerung.</translation>
    </message>
    <message>
        <source>The centre word %1 is not in the plane of the arc: check G17, G18, G19.</source>
        <translation>Das Mittelpunktwort %1 liegt nicht in der Ebene des Bogens: G17, G18, G19 prüfen.</translation>
    </message>
    <message>
        <source>The program has more than %1 points: it is not read further. Split it.</source>
        <translation>Das Programm hat mehr als %1 Punkte: Es wird nicht weiter gelesen. Das Programm aufteilen.</translation>
    </message>
    <message>
        <source>%1 more findings from here on are not listed.</source>
        <translation>%1 weitere Befunde ab hier sind nicht aufgeführt.</translation>
    </message>
    <message>
        <source>Rivulet does not execute &quot;%1&quot;: its effect on the path is unknown.</source>
        <translation>Rivulet führt „%1“ nicht aus: Die Wirkung auf die Bahn ist unbekannt.</translation>
    </message>
    <message>
        <source>The loop that ends here does not terminate: reading stopped after %1 repeated blocks. Check its condition.</source>
        <translation>Die Schleife, die hier endet, wird nicht verlassen: Nach %1 wiederholten Sätzen wurde nicht weiter gelesen. Ihre Bedingung prüfen.</translation>
    </message>
    <message>
        <source>The calculation has no result: %1.</source>
        <translation>Die Rechnung hat kein Ergebnis: %1.</translation>
    </message>
    <message>
        <source>The sequence of the blocks is not known from here on: %1.</source>
        <translation>Die Reihenfolge der Sätze ist ab hier unbekannt: %1.</translation>
    </message>
    <message>
        <source>The subprogram %1 is neither in this file nor in a file beside it: its points are missing.</source>
        <translation>Das Unterprogramm %1 steht weder in dieser Datei noch in einer Datei daneben: Seine Punkte fehlen.</translation>
    </message>
    <message>
        <source>%1 is a cycle of the control: its motions are missing here.</source>
        <translation>%1 ist ein Zyklus der Steuerung: Seine Bewegungen fehlen hier.</translation>
    </message>
    <message>
        <source>%1 moves in machine coordinates, whose position in the workpiece is not known: the move is left out.</source>
        <translation>%1 fährt in Maschinenkoordinaten, deren Lage im Werkstück unbekannt ist: Die Bewegung wird ausgelassen.</translation>
    </message>
    <message>
        <source>The file holds bytes that do not occur in NC text: choose a text file, not an archive or a picture.</source>
        <translation>Die Datei enthält Bytes, die in NC-Text nicht vorkommen: eine Textdatei wählen, kein Archiv oder Bild.</translation>
    </message>
    <message>
        <source>%1 is left out because you accepted it: the path may differ from the path at the control.</source>
        <translation>%1 wird ausgelassen, wie akzeptiert: Die Bahn kann von der Bahn an der Steuerung abweichen.</translation>
    </message>
    <message>
        <source>All arcs of the program fit if I, J and K are read as %1: check how the post-processor writes them, and load the program that way.</source>
        <translation>Alle Bögen des Programms passen, wenn I, J und K als %1 gelesen werden: prüfen, wie der Postprozessor sie ausgibt, und das Programm so laden.</translation>
    </message>
    <message>
        <source>The program moves no axis: there is nothing to stream. Choose a program with G0, G1, G2 or G3 and X, Y or Z.</source>
        <translation>Das Programm bewegt keine Achse: Es gibt nichts zu streamen. Ein Programm mit G0, G1, G2 oder G3 und X, Y oder Z wählen.</translation>
    </message>
    <message>
        <source>%1 moves on the path: only method window streams it, and only if this axis is selected.</source>
        <translation>%1 bewegt sich auf der Bahn: Nur das Verfahren Fenster streamt diese Achse, und nur, wenn sie gewählt ist.</translation>
    </message>
    <message>
        <source>With %1, X, Y and Z are those of the tool tip while rotary axes turn, and no method switches it on at the control. Post-process the program for the axes of the machine.</source>
        <translation>Mit %1 gelten X, Y und Z für die Werkzeugspitze, während Rundachsen drehen, und kein Verfahren schaltet das an der Steuerung ein. Das Programm für die Achsen der Maschine ausgeben.</translation>
    </message>
    <message>
        <source>%1 give the tool direction. The points keep it, but only the control could convert it to rotary axes. Post-process the program with A, B or C.</source>
        <translation>%1 geben die Werkzeugrichtung an. Die Punkte behalten sie, aber nur die Steuerung könnte sie in Rundachsen umrechnen. Das Programm mit A, B oder C ausgeben.</translation>
    </message>
    <message>
        <source>A block moves with G1, G2 or G3 before a feed F is programmed: only a fixed feed can be used.</source>
        <translation>Ein Satz fährt mit G1, G2 oder G3, bevor ein Vorschub F programmiert ist: Es kann nur ein fester Vorschub verwendet werden.</translation>
    </message>
    <message>
        <source>A blank is inside the number &quot;%1&quot;: this control does not put the parts together. Write the number without blanks.</source>
        <translation>Im Zahlenwert „%1“ steht ein Leerzeichen: Diese Steuerung setzt die Teile nicht zusammen. Die Zahl ohne Leerzeichen schreiben.</translation>
    </message>
    <message>
        <source>An invisible character stands here (%1), as office programs and web pages insert it: replace it by an ordinary blank.</source>
        <translation>Hier steht ein unsichtbares Zeichen (%1), wie es Büroprogramme und Webseiten einfügen: durch ein gewöhnliches Leerzeichen ersetzen.</translation>
    </message>
    <message>
        <source>A bracket is opened within the comment %1, which ends at the first closing bracket. Write it without inner brackets.</source>
        <translation>Im Kommentar %1 wird eine Klammer geöffnet; er endet an der ersten schließenden Klammer. Ohne innere Klammern schreiben.</translation>
    </message>
    <message>
        <source>%1 is a function of the builder of the machine: whether it moves an axis or changes the feed is not known. Accept it if it does not.</source>
        <translation>%1 ist eine Funktion des Maschinenherstellers: Ob sie eine Achse bewegt oder den Vorschub ändert, ist nicht bekannt. Nur annehmen, wenn sie das nicht tut.</translation>
    </message>
    <message>
        <source>The blocks of %1 are never executed: check the end of the program and the jumps before them, or remove them.</source>
        <translation>Die Sätze von %1 werden nie ausgeführt: das Programmende und die Sprünge davor prüfen, oder sie entfernen.</translation>
    </message>
    <message>
        <source>No block calls the subprogram %1: check the calls, or remove it.</source>
        <translation>Kein Satz ruft das Unterprogramm %1 auf: die Aufrufe prüfen, oder es entfernen.</translation>
    </message>
    <message>
        <source>The file holds another main program, %1: which one is to run is not known. Give each main program a file of its own.</source>
        <translation>Die Datei enthält ein weiteres Hauptprogramm, %1: Welches laufen soll, ist nicht bekannt. Jedem Hauptprogramm eine eigene Datei geben.</translation>
    </message>
    <message>
        <source>With M99, a main program begins again at the control, without end: it is executed once here. Write M30 if it is to end.</source>
        <translation>Mit M99 beginnt ein Hauptprogramm an der Steuerung ohne Ende von vorn: Hier wird es einmal ausgeführt. M30 schreiben, wenn es enden soll.</translation>
    </message>
    <message>
        <source>Loops and calls repeat more than %1 blocks for the control: the program is not read further. Check the condition of the loop.</source>
        <translation>Schleifen und Aufrufe wiederholen mehr als %1 Sätze für die Steuerung: Das Programm wird nicht weiter gelesen. Die Bedingung der Schleife prüfen.</translation>
    </message>
    <message>
        <source>The program is for a lathe (%1): X is read as a diameter, U and W as increments, the plane is Z X, and with G99 F is per revolution.</source>
        <translation>Das Programm ist für eine Drehmaschine (%1): X wird als Durchmesser gelesen, U und W als Zuwachs, die Ebene ist Z X, und mit G99 gilt F je Umdrehung.</translation>
    </message>
    <message>
        <source>No block says mm or inch (G21, G20) before the first move: the size is %1, read as mm or as inch. Load it with its unit (--units).</source>
        <translation>Kein Satz sagt vor der ersten Bewegung mm oder Zoll (G21, G20): Die Größe ist %1, als mm oder als Zoll gelesen. Mit seiner Einheit laden (--units).</translation>
    </message>
    <message>
        <source>Coordinates have no decimal point: the size is %1, read as whole units or as least increments. Load it as the control is set (--no-point).</source>
        <translation>Die Koordinaten haben keinen Dezimalpunkt: Die Größe ist %1, als ganze Einheiten oder als kleinste Schritte gelesen. So laden, wie die Steuerung eingestellt ist (--no-point).</translation>
    </message>
    <message>
        <source>The program is larger than a machine (%1): check its unit (G20, G21, --units) and its decimal points.</source>
        <translation>Das Programm ist größer als eine Maschine (%1): die Einheit (G20, G21, --units) und die Dezimalpunkte prüfen.</translation>
    </message>
    <message>
        <source>The words after &quot;;&quot; are read as a block of their own, as on the control. If &quot;;&quot; begins comments here, choose another dialect (--dialect).</source>
        <translation>Die Wörter hinter „;“ werden wie an der Steuerung als eigener Satz gelesen. Wenn „;“ hier Kommentare beginnt, einen anderen Dialekt wählen (--dialect).</translation>
    </message>
    <message>
        <source>The text does not show which control it is for, and they differ from here on: %1. Choose the dialect (--dialect).</source>
        <translation>Der Text zeigt nicht, für welche Steuerung er ist, und ab hier unterscheiden sie sich: %1. Den Dialekt wählen (--dialect).</translation>
    </message>
    <message>
        <source>The file has words of two controls (%1): split it, or choose the dialect (--dialect).</source>
        <translation>Die Datei hat Wörter von zwei Steuerungen (%1): sie teilen, oder den Dialekt wählen (--dialect).</translation>
    </message>
    <message>
        <source>The corner cannot be rounded or chamfered: there must be an element of the contour before and behind it, both long enough.</source>
        <translation>Die Ecke kann nicht gerundet oder gefast werden: Davor und dahinter muss ein genügend langes Konturelement stehen.</translation>
    </message>
    <message>
        <source>The program ends here with its own error (%1): check the values it has been given.</source>
        <translation>Das Programm endet hier mit seinem eigenen Fehler (%1): die Werte prüfen, die es bekommen hat.</translation>
    </message>
    <message>
        <source>The block lacks a word that the control needs (%1): add it.</source>
        <translation>Dem Satz fehlt ein Wort, das die Steuerung braucht (%1): ergänzen.</translation>
    </message>
    <message>
        <source>%1 is not the number of the tool in the spindle: check which length it stands for.</source>
        <translation>%1 ist nicht die Nummer des Werkzeugs in der Spindel: prüfen, für welche Länge sie steht.</translation>
    </message>
    <message>
        <source>%1 executes a text that is put together while the program runs: what it does is not known here. Write the block itself.</source>
        <translation>%1 führt einen Text aus, der erst im Lauf des Programms entsteht: Was er bewirkt, ist hier nicht bekannt. Den Satz selbst schreiben.</translation>
    </message>
    <message>
        <source>%1 limits the speed of an axis, and a stream does not keep the limit: program a feed that keeps it, and remove the word.</source>
        <translation>%1 begrenzt die Geschwindigkeit einer Achse, und ein Strom hält die Grenze nicht ein: einen Vorschub programmieren, der sie einhält, und das Wort entfernen.</translation>
    </message>
    <message>
        <source>%1 calls a subprogram behind each block that moves, and it is neither in this file nor in a file beside it: its motions are missing. Put its file beside the program.</source>
        <translation>%1 ruft nach jedem Satz mit Bewegung ein Unterprogramm auf, das weder in dieser Datei noch in einer Datei daneben steht: Seine Bewegungen fehlen. Seine Datei neben das Programm legen.</translation>
    </message>
    <message>
        <source>What the program leaves out is taken from the settings of a virtual machine: %1. Load it as the control is set (--setting).</source>
        <translation>Was das Programm weglässt, kommt aus den Einstellungen einer virtuellen Maschine: %1. So laden, wie die Steuerung eingestellt ist (--setting).</translation>
    </message>
    <message>
        <source>The number of the last F may mean another feed here, because mm, inch, G94 or G95 was chosen behind it: program F again.</source>
        <translation>Die Zahl des letzten F kann hier einen anderen Vorschub bedeuten, weil danach mm, Zoll, G94 oder G95 gewählt wurde: F erneut programmieren.</translation>
    </message>
</context>
<context>
    <name>EmulatorPageTexts</name>
    <message>
        <source>A run is in progress. Learn after it has ended: both would take the same processor.</source>
        <translation>Ein Lauf ist im Gang. Erst danach lernen: Beides braucht denselben Prozessor.</translation>
    </message>
</context>
<context>
    <name>EmulatorTexts</name>
    <message>
        <source>Position gain</source>
        <translation>Lageverstärkung</translation>
    </message>
    <message>
        <source>The larger it is, the smaller the following error.</source>
        <translation>Je größer, desto kleiner der Schleppfehler.</translation>
    </message>
    <message>
        <source>Feed-forward</source>
        <translation>Vorsteuerung</translation>
    </message>
    <message>
        <source>Share of the speed that needs no following error. With 1 there is none at constant speed.</source>
        <translation>Anteil der Geschwindigkeit, der keinen Schleppfehler braucht. Bei 1 gibt es bei konstanter Geschwindigkeit keinen.</translation>
    </message>
    <message>
        <source>Filter of the feed-forward</source>
        <translation>Filter der Vorsteuerung</translation>
    </message>
    <message>
        <source>How late the feed-forward takes effect.</source>
        <translation>Wie spät die Vorsteuerung wirkt.</translation>
    </message>
    <message>
        <source>Speed gain</source>
        <translation>Drehzahlverstärkung</translation>
    </message>
    <message>
        <source>How quickly the drive reaches the speed it is told.</source>
        <translation>Wie schnell der Antrieb die verlangte Geschwindigkeit erreicht.</translation>
    </message>
    <message>
        <source>Reset time</source>
        <translation>Nachstellzeit</translation>
    </message>
    <message>
        <source>How soon the drive removes the rest of an error in speed.</source>
        <translation>Wie bald der Antrieb den Rest eines Drehzahlfehlers beseitigt.</translation>
    </message>
    <message>
        <source>Lag of the drive</source>
        <translation>Verzug des Antriebs</translation>
    </message>
    <message>
        <source>How late the force follows its command.</source>
        <translation>Wie spät die Kraft ihrem Befehl folgt.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Force against every motion, as the acceleration it costs. It makes the bumps where an axis reverses.</source>
        <translation>Kraft gegen jede Bewegung, als Beschleunigung, die sie kostet. Von ihr kommen die Buckel, wo eine Achse umkehrt.</translation>
    </message>
    <message>
        <source>Speed of friction</source>
        <translation>Geschwindigkeit der Reibung</translation>
    </message>
    <message>
        <source>From this speed on, friction has its full force.</source>
        <translation>Ab dieser Geschwindigkeit wirkt die Reibung voll.</translation>
    </message>
    <message>
        <source>Viscous friction</source>
        <translation>Viskose Reibung</translation>
    </message>
    <message>
        <source>Friction that grows with the speed.</source>
        <translation>Reibung, die mit der Geschwindigkeit wächst.</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Totzeit</translation>
    </message>
    <message>
        <source>Time until a set point takes effect.</source>
        <translation>Zeit, bis ein Sollwert wirkt.</translation>
    </message>
    <message>
        <source>Resonance</source>
        <translation>Resonanz</translation>
    </message>
    <message>
        <source>Frequency at which motor and table swing against each other.</source>
        <translation>Frequenz, mit der Motor und Tisch gegeneinander schwingen.</translation>
    </message>
    <message>
        <source>Damping of the resonance</source>
        <translation>Dämpfung der Resonanz</translation>
    </message>
    <message>
        <source>The smaller it is, the longer the axis oscillates. At 1 it does not oscillate.</source>
        <translation>Je kleiner, desto länger schwingt es nach; bei 1 gar nicht.</translation>
    </message>
    <message>
        <source>On %1, which it was not learned from, positions are right within %2 (RMS), %3 at most.</source>
        <translation>Auf %1, woraus er nicht gelernt wurde, stimmen die Positionen auf %2 (RMS), höchstens %3.</translation>
    </message>
    <message>
        <source>The contour error there is off by %1 of %2 (RMS).</source>
        <translation>Der Konturfehler weicht dort um %1 von %2 ab (RMS).</translation>
    </message>
    <message>
        <source>Good for simulating and timing programs that move %1 at feeds up to %2. What is faster was not tested.</source>
        <translation>Gut, um Programme mit %1 bis %2 zu simulieren und ihre Dauer zu schätzen. Schnelleres ist nicht geprüft.</translation>
    </message>
    <message>
        <source>Do not rely on the contour errors that it predicts.</source>
        <translation>Auf die vorhergesagten Konturfehler ist kein Verlass.</translation>
    </message>
    <message>
        <source>Limits of speed, acceleration and jerk are those of preset %1: correct them in the file if the machine has others.</source>
        <translation>Die Grenzen für Geschwindigkeit, Beschleunigung und Ruck sind die der Vorgabe %1: in der Datei berichtigen, wenn die Maschine andere hat.</translation>
    </message>
    <message>
        <source>Acceleration and jerk are limited as the set points show (%1), all else as in preset %2.</source>
        <translation>Beschleunigung und Ruck sind begrenzt, wie es die Sollwerte zeigen (%1), alles andere wie in der Vorgabe %2.</translation>
    </message>
    <message>
        <source>It was tested only on parts of the same recordings: right within %1 (RMS). Add a recording of another program and use it to test.</source>
        <translation>Er wurde nur an Teilen derselben Aufzeichnungen geprüft: richtig auf %1 (RMS). Die Aufzeichnung eines anderen Programms hinzufügen und zum Prüfen nehmen.</translation>
    </message>
</context>
<context>
    <name>ErrorTexts</name>
    <message>
        <source>Two columns have the same meaning. Choose one of them.</source>
        <translation>Zwei Spalten haben dieselbe Bedeutung. Eine davon auswählen.</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it exists and that you may read it.</source>
        <translation>Die Datei ist nicht lesbar. Prüfen, ob sie vorhanden ist und gelesen werden darf.</translation>
    </message>
    <message>
        <source>The program is empty. Choose a file with NC blocks.</source>
        <translation>Das Programm ist leer. Eine Datei mit NC-Sätzen wählen.</translation>
    </message>
    <message>
        <source>The program moves no axis. Choose a program with G0, G1, G2 or G3.</source>
        <translation>Das Programm bewegt keine Achse. Ein Programm mit G0, G1, G2 oder G3 wählen.</translation>
    </message>
    <message>
        <source>Parts of the program are not understood. See the list of findings.</source>
        <translation>Teile des Programms werden nicht verstanden. Siehe die Liste der Befunde.</translation>
    </message>
    <message>
        <source>The feed F must be between 0.001 and 1 000 000 mm/min.</source>
        <translation>Der Vorschub F muss zwischen 0,001 und 1 000 000 mm/min liegen.</translation>
    </message>
    <message>
        <source>The distance δ must be greater than zero.</source>
        <translation>Der Abstand δ muss größer als null sein.</translation>
    </message>
    <message>
        <source>N is too small. Choose at least 2 points per loop.</source>
        <translation>N ist zu klein. Mindestens 2 Punkte je Schleife wählen.</translation>
    </message>
    <message>
        <source>N is too small for this method. Choose more points per loop.</source>
        <translation>N ist für dieses Verfahren zu klein. Mehr Punkte je Schleife wählen.</translation>
    </message>
    <message>
        <source>N points do not fit the R-parameters of the control. Choose a smaller N, the contiguous layout, or enlarge MD28050.</source>
        <translation>N Punkte passen nicht in die R-Parameter der Steuerung. Ein kleineres N oder das lückenlose Layout wählen oder MD28050 vergrößern.</translation>
    </message>
    <message>
        <source>No axis is chosen. Choose at least one axis.</source>
        <translation>Keine Achse gewählt. Mindestens eine Achse wählen.</translation>
    </message>
    <message>
        <source>The file cannot be written. Choose another folder.</source>
        <translation>Die Datei kann nicht geschrieben werden. Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>This file is not a Rivulet recording.</source>
        <translation>Diese Datei ist keine Rivulet-Aufzeichnung.</translation>
    </message>
    <message>
        <source>The recording was written by a newer Rivulet. Update this program to read it.</source>
        <translation>Die Aufzeichnung stammt von einem neueren Rivulet. Zum Lesen dieses Programm aktualisieren.</translation>
    </message>
    <message>
        <source>The recording is damaged. Everything before the damage was kept.</source>
        <translation>Die Aufzeichnung ist beschädigt. Alles vor dem Schaden blieb erhalten.</translation>
    </message>
    <message>
        <source>The file cannot be written. Check the folder and the free space.</source>
        <translation>Die Datei kann nicht geschrieben werden. Ordner und freien Speicher prüfen.</translation>
    </message>
    <message>
        <source>The program has been changed since the interrupted run. Restore it, or start from the beginning.</source>
        <translation>Das Programm wurde seit dem unterbrochenen Lauf geändert. Wiederherstellen oder von vorn beginnen.</translation>
    </message>
    <message>
        <source>No OPC UA server answers at this endpoint. Check address, port and network.</source>
        <translation>An diesem Endpunkt antwortet kein OPC-UA-Server. Adresse, Port und Netzwerk prüfen.</translation>
    </message>
    <message>
        <source>The connection to the control is lost. Check the machine, then connect again.</source>
        <translation>Die Verbindung zur Steuerung ist verloren. Die Maschine prüfen, dann neu verbinden.</translation>
    </message>
    <message>
        <source>The control did not answer in time. Check the network and its load.</source>
        <translation>Die Steuerung hat nicht rechtzeitig geantwortet. Netzwerk und Auslastung prüfen.</translation>
    </message>
    <message>
        <source>The control does not have a variable that Rivulet needs. Check the configuration of the server.</source>
        <translation>Der Steuerung fehlt eine Variable, die Rivulet braucht. Die Konfiguration des Servers prüfen.</translation>
    </message>
    <message>
        <source>A variable is write-protected. Give this user write access on the control.</source>
        <translation>Eine Variable ist schreibgeschützt. Diesem Benutzer an der Steuerung Schreibrecht geben.</translation>
    </message>
    <message>
        <source>A value cannot be used; nothing was sent.</source>
        <translation>Ein Wert ist nicht verwendbar; es wurde nichts gesendet.</translation>
    </message>
    <message>
        <source>The control rejected the request.</source>
        <translation>Die Steuerung hat die Anfrage abgelehnt.</translation>
    </message>
    <message>
        <source>The server is not a SINUMERIK (no SinumerikVarProvider). Check the endpoint.</source>
        <translation>Der Server ist keine SINUMERIK (kein SinumerikVarProvider). Den Endpunkt prüfen.</translation>
    </message>
    <message>
        <source>The server does not offer this function.</source>
        <translation>Der Server bietet diese Funktion nicht an.</translation>
    </message>
    <message>
        <source>There is no such program on the control. Send the template first.</source>
        <translation>Dieses Programm gibt es auf der Steuerung nicht. Zuerst die Vorlage übertragen.</translation>
    </message>
    <message>
        <source>The channel is not in reset. Press reset at the control, then try again.</source>
        <translation>Der Kanal ist nicht im Reset. An der Steuerung Reset drücken, dann erneut versuchen.</translation>
    </message>
    <message>
        <source>A program of this name is already on the control.</source>
        <translation>Ein Programm dieses Namens liegt schon auf der Steuerung.</translation>
    </message>
    <message>
        <source>The request is larger than the server accepts. Choose a smaller N.</source>
        <translation>Die Anfrage ist größer, als der Server annimmt. Ein kleineres N wählen.</translation>
    </message>
    <message>
        <source>This program cannot be streamed. See the list of findings.</source>
        <translation>Dieses Programm kann nicht gestreamt werden. Siehe die Liste der Befunde.</translation>
    </message>
    <message>
        <source>The control does not run the expected template. Select and start the template for these settings.</source>
        <translation>Auf der Steuerung läuft nicht die erwartete Vorlage. Die Vorlage zu diesen Einstellungen anwählen und starten.</translation>
    </message>
    <message>
        <source>Another program is running on the control. Wait until it has ended, or reset the channel.</source>
        <translation>Auf der Steuerung läuft ein anderes Programm. Das Programmende abwarten oder den Kanal zurücksetzen.</translation>
    </message>
    <message>
        <source>Cycle start was not pressed in time. Start the run again.</source>
        <translation>NC-Start wurde nicht rechtzeitig gedrückt. Den Lauf erneut starten.</translation>
    </message>
    <message>
        <source>The control is running, but the stream makes no progress. Check feed override and feed hold at the control.</source>
        <translation>Die Steuerung läuft, aber das Streaming kommt nicht voran. Vorschub-Override und Vorschub-Halt an der Steuerung prüfen.</translation>
    </message>
    <message>
        <source>The control did not confirm the stop in time. Check the machine.</source>
        <translation>Die Steuerung hat den Stopp nicht rechtzeitig bestätigt. Die Maschine prüfen.</translation>
    </message>
    <message>
        <source>The control ended the program with an alarm. Clear its cause at the control.</source>
        <translation>Die Steuerung hat das Programm mit einem Alarm beendet. Die Ursache an der Steuerung beheben.</translation>
    </message>
    <message>
        <source>The program on the control ended before all of it was executed.</source>
        <translation>Das Programm auf der Steuerung endete, bevor alles ausgeführt war.</translation>
    </message>
    <message>
        <source>Another client is using the program on the control. Rivulet writes nothing more: wait until the other client has finished, or reset the control.</source>
        <translation>Ein anderer Client benutzt das Programm auf der Steuerung. Rivulet schreibt nichts mehr: warten, bis der andere Client fertig ist, oder an der Steuerung Reset drücken.</translation>
    </message>
    <message>
        <source>The program on the control was restarted during the run. Reset the control, then resume.</source>
        <translation>Das Programm auf der Steuerung wurde während des Laufs neu gestartet. An der Steuerung Reset drücken, dann fortsetzen.</translation>
    </message>
    <message>
        <source>The control rejected a window that did not match its check number, and did not execute it. Something else writes these R-parameters, or a value was changed on its way: look for another client, or connect encrypted, then resume.</source>
        <translation>Die Steuerung hat ein Fenster abgelehnt, das nicht zu seiner Prüfzahl passte, und es nicht ausgeführt. Etwas anderes schreibt diese R-Parameter, oder ein Wert wurde unterwegs verfälscht: nach einem anderen Client suchen oder verschlüsselt verbinden, dann fortsetzen.</translation>
    </message>
    <message>
        <source>The control ended its program because it received nothing from Rivulet for too long. Check the network, then resume.</source>
        <translation>Die Steuerung hat ihr Programm beendet, weil sie zu lange nichts von Rivulet empfangen hat. Das Netzwerk prüfen, dann fortsetzen.</translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation>Das Laden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>It is not known for certain where the run was left. Start from the beginning.</source>
        <translation>Die Unterbrechungsstelle ist nicht sicher bekannt. Von vorn beginnen.</translation>
    </message>
    <message>
        <source>The control does not let Rivulet write and read part programs. Grant the OPC UA user these rights, or copy the template to the control by hand.</source>
        <translation>Die Steuerung lässt Rivulet keine Teileprogramme schreiben und lesen. Dem OPC-UA-Benutzer diese Rechte geben oder die Vorlage von Hand übertragen.</translation>
    </message>
    <message>
        <source>Only method window streams rotary axes. Choose it.</source>
        <translation>Nur das Verfahren Fenster streamt Rundachsen. Dieses wählen.</translation>
    </message>
    <message>
        <source>Too many axes. Choose at most five.</source>
        <translation>Zu viele Achsen. Höchstens fünf wählen.</translation>
    </message>
    <message>
        <source>These are not axes. Choose from X, Y, Z, A, B and C.</source>
        <translation>Das sind keine Achsen. Aus X, Y, Z, A, B und C wählen.</translation>
    </message>
    <message>
        <source>This make of control cannot do that. Choose another method or setting.</source>
        <translation>Diese Steuerung kann das nicht. Ein anderes Verfahren oder eine andere Einstellung wählen.</translation>
    </message>
    <message>
        <source>The program needs an axis that is not streamed. Move it to the position in the program, or stream it too.</source>
        <translation>Das Programm braucht eine Achse, die nicht gestreamt wird. Die Achse auf die Position im Programm fahren oder mitstreamen.</translation>
    </message>
    <message>
        <source>The control lacks an axis that the program moves. Use a program for the axes of this machine.</source>
        <translation>Der Steuerung fehlt eine Achse, die das Programm bewegt. Ein Programm für die Achsen dieser Maschine verwenden.</translation>
    </message>
    <message>
        <source>No prediction is possible for this method.</source>
        <translation>Für dieses Verfahren ist keine Vorhersage möglich.</translation>
    </message>
    <message>
        <source>The test was aborted. Reset the control if its program is still running.</source>
        <translation>Der Test wurde abgebrochen. Falls sein Programm noch läuft, an der Steuerung Reset drücken.</translation>
    </message>
    <message>
        <source>Method credit is experimental and starts only on a control that has passed its test. Pass it on the page Credit test, or choose method window.</source>
        <translation>Das Verfahren Kredit ist experimentell und startet nur an einer Steuerung, die seinen Test bestanden hat. Den Test auf der Seite Kredit-Test ausführen oder das Verfahren Fenster wählen.</translation>
    </message>
    <message>
        <source>Online correction is possible with method window, for X, Y and Z, up to 1 mm.</source>
        <translation>Die Online-Korrektur ist mit dem Verfahren Fenster möglich, für X, Y und Z, bis 1 mm.</translation>
    </message>
    <message>
        <source>An overlay is already active on the axes. Remove it at the control: press reset, wait, and check that $AA_OFF is 0.</source>
        <translation>Auf den Achsen ist bereits eine Überlagerung aktiv. An der Steuerung aufheben: Reset drücken, warten und prüfen, ob $AA_OFF 0 ist.</translation>
    </message>
    <message>
        <source>The control adds up overlaid values (MD36750 bit 0). Set the bit to 0, or do without online correction.</source>
        <translation>Die Steuerung summiert überlagerte Werte auf (MD36750 Bit 0). Das Bit auf 0 setzen oder auf die Online-Korrektur verzichten.</translation>
    </message>
    <message>
        <source>This is not a machine file of Rivulet. Move the file away.</source>
        <translation>Das ist keine Maschinendatei von Rivulet. Bitte verschieben.</translation>
    </message>
    <message>
        <source>This was written by another version of Rivulet. Measure again.</source>
        <translation>Die Datei stammt von einer anderen Version von Rivulet. Bitte neu messen.</translation>
    </message>
    <message>
        <source>The calibration is damaged. Measure again.</source>
        <translation>Die Kalibrierung ist beschädigt. Bitte neu messen.</translation>
    </message>
    <message>
        <source>Another client has claimed the R-parameters of this run and is about to start. Nothing was changed. Wait until its run has ended.</source>
        <translation>Ein anderer Client hat die R-Parameter dieses Laufs belegt und startet gleich. Nichts wurde geändert. Warten Sie, bis sein Lauf beendet ist.</translation>
    </message>
    <message>
        <source>A block of the program moves at a feed that is not known: F is missing, G95 has no spindle speed, or G93 no length. Choose one feed for all moves.</source>
        <translation>Ein Satz des Programms fährt mit einem Vorschub, der nicht bekannt ist: F fehlt, zu G95 fehlt die Drehzahl oder zu G93 die Länge. Einen Vorschub für alle Bewegungen wählen.</translation>
    </message>
    <message>
        <source>This method has one feed for all moves, as it was published.</source>
        <translation>Dieses Verfahren hat einen Vorschub für alle Bewegungen, wie veröffentlicht.</translation>
    </message>
    <message>
        <source>The override is out of range: choose 1 to 200 %.</source>
        <translation>Der Override liegt außerhalb des Bereichs: 1 bis 200 % wählen.</translation>
    </message>
    <message>
        <source>The formula is not understood from here on.</source>
        <translation>Ab hier ist die Formel nicht verständlich.</translation>
    </message>
    <message>
        <source>The formula is not complete.</source>
        <translation>Die Formel ist nicht vollständig.</translation>
    </message>
    <message>
        <source>There is no such function. Press F1 for those there are.</source>
        <translation>Diese Funktion gibt es nicht. F1 zeigt die vorhandenen.</translation>
    </message>
    <message>
        <source>The trace has no such signal. The tool tips of the signals have their names.</source>
        <translation>Die Aufzeichnung hat kein solches Signal. Die Namen stehen in den Kurzhinweisen der Signale.</translation>
    </message>
    <message>
        <source>This is no trace that can be read: there are no rows of numbers in it.</source>
        <translation>Keine lesbare Aufzeichnung: Die Datei enthält keine Zeilen mit Zahlen.</translation>
    </message>
    <message>
        <source>The table has no such column.</source>
        <translation>Die Tabelle hat keine solche Spalte.</translation>
    </message>
    <message>
        <source>The trace has no positions: compare it by time.</source>
        <translation>Die Aufzeichnung hat keine Positionen: nach der Zeit vergleichen.</translation>
    </message>
    <message>
        <source>To compare by points, open the NC program that the traces show.</source>
        <translation>Zum Vergleich nach Punkten das NC-Programm öffnen, das die Aufzeichnungen zeigen.</translation>
    </message>
    <message>
        <source>The runs are of different programs: compare them by time or path.</source>
        <translation>Die Läufe gehören zu verschiedenen Programmen: nach Zeit oder Weg vergleichen.</translation>
    </message>
    <message>
        <source>A spectrum needs 16 samples or more between the cursors.</source>
        <translation>Ein Spektrum braucht mindestens 16 Abtastwerte zwischen den Cursorn.</translation>
    </message>
    <message>
        <source>The server does not offer the encryption that is required. Set it up on the control, or allow this machine to be reached without it.</source>
        <translation>Der Server bietet die verlangte Verschlüsselung nicht an. Richten Sie sie an der Steuerung ein, oder erlauben Sie für diese Maschine eine unverschlüsselte Verbindung.</translation>
    </message>
    <message>
        <source>The server&apos;s certificate is not known yet. Compare its fingerprint with the one at the control, then accept it.</source>
        <translation>Das Zertifikat des Servers ist noch nicht bekannt. Vergleichen Sie seinen Fingerabdruck mit dem an der Steuerung und akzeptieren Sie es dann.</translation>
    </message>
    <message>
        <source>The server shows another certificate than the one that was accepted. Find out why before you accept it.</source>
        <translation>Der Server zeigt ein anderes Zertifikat als das akzeptierte. Klären Sie den Grund, bevor Sie es akzeptieren.</translation>
    </message>
    <message>
        <source>A certificate cannot be used: it is damaged or has ended. Create a new one.</source>
        <translation>Ein Zertifikat ist nicht verwendbar: es ist beschädigt oder abgelaufen. Erstellen Sie ein neues.</translation>
    </message>
    <message>
        <source>The server does not trust the certificate of this computer. Accept it at the control, then connect again.</source>
        <translation>Der Server vertraut dem Zertifikat dieses Rechners nicht. Akzeptieren Sie es an der Steuerung und verbinden Sie dann erneut.</translation>
    </message>
    <message>
        <source>The server refuses user name or password. Check both.</source>
        <translation>Der Server lehnt Benutzername oder Passwort ab. Prüfen Sie beides.</translation>
    </message>
    <message>
        <source>The line is neither a point nor end, hold or comment.</source>
        <translation>Die Zeile ist weder ein Punkt noch end, hold oder comment.</translation>
    </message>
    <message>
        <source>A word of the line has no number.</source>
        <translation>Ein Wort der Zeile hat keine Zahl.</translation>
    </message>
    <message>
        <source>The line is too long.</source>
        <translation>Die Zeile ist zu lang.</translation>
    </message>
    <message>
        <source>The source was closed in the middle of the line.</source>
        <translation>Die Quelle wurde mitten in der Zeile geschlossen.</translation>
    </message>
    <message>
        <source>The point is outside the agreed box.</source>
        <translation>Der Punkt liegt außerhalb des vereinbarten Quaders.</translation>
    </message>
    <message>
        <source>The step to the point is longer than agreed.</source>
        <translation>Der Schritt zum Punkt ist länger als vereinbart.</translation>
    </message>
    <message>
        <source>A rotary axis would turn farther in one step than agreed.</source>
        <translation>Eine Rundachse würde in einem Schritt weiter drehen als vereinbart.</translation>
    </message>
    <message>
        <source>F is larger than agreed, or not above 0.</source>
        <translation>F ist größer als vereinbart oder nicht über 0.</translation>
    </message>
    <message>
        <source>The first point is farther from the tool than agreed. Move the tool there, or begin where it is.</source>
        <translation>Der erste Punkt ist weiter vom Werkzeug entfernt als vereinbart. Das Werkzeug dorthin fahren oder dort beginnen, wo es steht.</translation>
    </message>
    <message>
        <source>The point names an axis that is not one of this run.</source>
        <translation>Der Punkt nennt eine Achse, die nicht zu diesem Lauf gehört.</translation>
    </message>
    <message>
        <source>A point is missing or came twice: the numbers are not in order.</source>
        <translation>Ein Punkt fehlt oder kam doppelt: Die Nummern folgen nicht aufeinander.</translation>
    </message>
    <message>
        <source>The source was closed without end.</source>
        <translation>Die Quelle wurde ohne end geschlossen.</translation>
    </message>
    <message>
        <source>The source was silent for longer than agreed.</source>
        <translation>Die Quelle schwieg länger als vereinbart.</translation>
    </message>
    <message>
        <source>The source was faster than the machine and cannot wait. Send fewer points, or use TCP.</source>
        <translation>Die Quelle war schneller als die Maschine und kann nicht warten. Weniger Punkte senden oder TCP verwenden.</translation>
    </message>
    <message>
        <source>The source ended before its first point. Nothing has moved.</source>
        <translation>Die Quelle endete vor ihrem ersten Punkt. Nichts hat sich bewegt.</translation>
    </message>
    <message>
        <source>The source cannot be opened. Choose another port or path.</source>
        <translation>Die Quelle kann nicht geöffnet werden. Anderen Port oder Pfad wählen.</translation>
    </message>
    <message>
        <source>These values cannot be kept together. Check box, step and times.</source>
        <translation>Diese Werte passen nicht zusammen. Quader, Schritt und Zeiten prüfen.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>This source can lose points, so it has to number them: N1 X0.5, then N2.</source>
        <translation>Diese Quelle kann Punkte verlieren und muss sie deshalb nummerieren: N1 X0.5, dann N2.</translation>
    </message>
    <message>
        <source>The file of the source is not as the manual shows it (Live points).</source>
        <translation>Die Datei der Quelle ist nicht so, wie das Handbuch sie zeigt (Live-Punkte).</translation>
    </message>
    <message>
        <source>This Rivulet was built without HDF5. Use CSV, or build it with libhdf5-dev.</source>
        <translation>Dieses Rivulet wurde ohne HDF5 gebaut. CSV verwenden oder mit libhdf5-dev bauen.</translation>
    </message>
    <message>
        <source>Times and positions do not fit together. Record the run again.</source>
        <translation>Zeiten und Positionen passen nicht zusammen. Den Lauf neu aufzeichnen.</translation>
    </message>
    <message>
        <source>A value is not a number. Leave its row out of the file.</source>
        <translation>Ein Wert ist keine Zahl. Seine Zeile aus der Datei nehmen.</translation>
    </message>
    <message>
        <source>An axis does not move in these recordings. Add one that moves it.</source>
        <translation>Eine Achse bewegt sich in diesen Aufzeichnungen nicht. Eine hinzufügen, die sie bewegt.</translation>
    </message>
    <message>
        <source>There are too few samples to learn from. Record a longer program, with set points and actual positions.</source>
        <translation>Es sind zu wenige Messwerte, um daraus zu lernen. Ein längeres Programm aufzeichnen, mit Soll- und Istpositionen.</translation>
    </message>
    <message>
        <source>Set points and actual positions differ by a factor. Check their units.</source>
        <translation>Soll- und Istpositionen unterscheiden sich um einen Faktor. Ihre Einheiten prüfen.</translation>
    </message>
    <message>
        <source>Recording and program do not fit together. Check the program, and that the preset has the machine&apos;s limits.</source>
        <translation>Aufzeichnung und Programm passen nicht zusammen. Das Programm prüfen, und ob die Vorgabe die Grenzen der Maschine hat.</translation>
    </message>
    <message>
        <source>No model follows this recording. Check that set points and positions belong together.</source>
        <translation>Kein Modell folgt dieser Aufzeichnung. Prüfen, ob Sollwerte und Positionen zusammengehören.</translation>
    </message>
    <message>
        <source>Learning was cancelled. What was learned before stays.</source>
        <translation>Das Lernen wurde abgebrochen. Was vorher gelernt wurde, bleibt.</translation>
    </message>
    <message>
        <source>The file is not an emulator, or one of a later version.</source>
        <translation>Die Datei ist kein Emulator, oder einer von einer neueren Version.</translation>
    </message>
    <message>
        <source>Rivulet was built without Qt OPC UA. Connect with open62541.</source>
        <translation>Rivulet wurde ohne Qt OPC UA gebaut. Mit open62541 verbinden.</translation>
    </message>
    <message>
        <source>Qt OPC UA cannot encrypt, log in or use a map here. Connect with open62541.</source>
        <translation>Qt OPC UA kann hier nicht verschlüsseln, anmelden oder eine Zuordnung verwenden. Mit open62541 verbinden.</translation>
    </message>
    <message>
        <source>The map cannot be used. Correct the file at the place that is named.</source>
        <translation>Die Zuordnung ist nicht brauchbar. Die Datei an der genannten Stelle berichtigen.</translation>
    </message>
    <message>
        <source>The map names a node that the server does not have, or one of another type. Correct the map.</source>
        <translation>Die Zuordnung nennt einen Knoten, den der Server nicht hat, oder einen von anderem Typ. Die Zuordnung berichtigen.</translation>
    </message>
    <message>
        <source>No computer of this name is known on the network. Check the name, or give the IP address of the control.</source>
        <translation>Im Netzwerk gibt es keinen Rechner mit diesem Namen. Prüfen Sie den Namen, oder geben Sie die IP-Adresse der Steuerung an.</translation>
    </message>
    <message>
        <source>Too many files and connections are open on this computer. Close other programs, then try again.</source>
        <translation>Auf diesem Rechner sind zu viele Dateien und Verbindungen offen. Schließen Sie andere Programme, und versuchen Sie es dann noch einmal.</translation>
    </message>
    <message>
        <source>The text leaves open what it means. Choose the dialect, the unit or the reading of numbers without a decimal point.</source>
        <translation>Der Text lässt offen, was er bedeutet. Den Dialekt, die Einheit oder die Lesart von Zahlen ohne Dezimalpunkt wählen.</translation>
    </message>
    <message>
        <source>The straight way to the first point passes within what the program cuts. Raise the tool first.</source>
        <translation>Der gerade Weg zum ersten Punkt führt durch den Bereich, in dem das Programm schneidet. Heben Sie zuerst das Werkzeug ab.</translation>
    </message>
    <message>
        <source>This would take more memory than a file may. Choose a smaller one.</source>
        <translation>Das bräuchte mehr Speicher, als eine Datei darf. Eine kleinere wählen.</translation>
    </message>
    <message>
        <source>A factor of the feed would wait here behind points that are not read yet. Send factors over a source of their own.</source>
        <translation>Ein Faktor des Vorschubs würde hier hinter Punkten warten, die noch nicht gelesen sind. Faktoren über eine eigene Quelle senden.</translation>
    </message>
    <message>
        <source>A factor of the override is possible with methods window and credit, from 0.01 to 2, with 1 between its bounds.</source>
        <translation>Einen Faktor des Overrides gibt es mit den Verfahren Fenster und Kredit, von 0,01 bis 2, mit 1 zwischen seinen Grenzen.</translation>
    </message>
    <message>
        <source>The move of the test takes 2 to 30 s at its feed, so that it can be held on its way. Choose another length or feed.</source>
        <translation>Der Weg des Tests dauert mit seinem Vorschub 2 bis 30 s, damit er unterwegs angehalten werden kann. Andere Länge oder anderen Vorschub wählen.</translation>
    </message>
    <message>
        <source>This is no trace, but the refusal of an MTConnect agent. Ask it for /sample.</source>
        <translation>Das ist kein Trace, sondern die Absage eines MTConnect-Agenten. Ihn nach /sample fragen.</translation>
    </message>
    <message>
        <source>The server keeps no history of this node. Have it recorded at the server.</source>
        <translation>Der Server zeichnet keinen Verlauf dieses Knotens auf. Ihn am Server aufzeichnen lassen.</translation>
    </message>
    <message>
        <source>The R-parameters of method window are out of range. Check base, stride and number of windows.</source>
        <translation>Die R-Parameter des Verfahrens Fenster liegen außerhalb des Bereichs. Basis, Schrittweite und Anzahl der Fenster prüfen.</translation>
    </message>
    <message>
        <source>These R-parameters cannot be used. Choose some that exist (MD28050).</source>
        <translation>Diese R-Parameter sind nicht verwendbar. Wählen Sie solche, die es gibt (MD28050).</translation>
    </message>
    <message>
        <source>A program is running on the control: the measurement has ended. The R-parameters have their old values.</source>
        <translation>Auf der Steuerung läuft ein Programm: Die Messung wurde beendet. Die R-Parameter haben ihre alten Werte.</translation>
    </message>
    <message>
        <source>The calibration was cancelled. The R-parameters have their old values.</source>
        <translation>Die Kalibrierung wurde abgebrochen. Die R-Parameter haben ihre alten Werte.</translation>
    </message>
    <message>
        <source>The R-parameters could not be restored and may hold test values. Set them at the control.</source>
        <translation>Die R-Parameter ließen sich nicht zurückschreiben und enthalten vielleicht Testwerte. Setzen Sie sie an der Steuerung.</translation>
    </message>
    <message>
        <source>The control does not obey the override: pause, stop and override would not act. Nothing was moved. Check that a SINUMERIK has synchronized actions, or a LinuxCNC the components of docs/linuxcnc.md.</source>
        <translation>Die Steuerung gehorcht dem Override nicht: Pause, Stopp und Override würden nicht wirken. Es wurde nichts bewegt. Prüfen Sie, ob eine SINUMERIK Synchronaktionen hat und ein LinuxCNC die Komponenten aus docs/linuxcnc.md.</translation>
    </message>
    <message>
        <source>The path cannot be kept within this tolerance. Allow more of it, or none; packed points are moved by up to 0.001 mm.</source>
        <translation>Die Bahn lässt sich innerhalb dieser Toleranz nicht einhalten. Erlauben Sie mehr oder gar keine; gepackte Punkte werden um bis zu 0,001 mm verschoben.</translation>
    </message>
    <message>
        <source>This block cannot be tried: the control of a job would not execute it itself, or it ends the program. Name blocks as a program has them, as in &quot;S500 M3&quot;.</source>
        <translation>Dieser Satz lässt sich nicht erproben: Die Steuerung würde ihn in einem Auftrag nicht selbst ausführen, oder er beendet das Programm. Sätze so eingeben, wie sie im Programm stehen, etwa „S500 M3“.</translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message>
        <source>the character &quot;%1&quot; has no meaning here</source>
        <translation>Das Zeichen „%1“ hat hier keine Bedeutung</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>a comment is not closed</source>
        <translation>Ein Kommentar ist nicht geschlossen</translation>
    </message>
    <message>
        <source>%1 is not known to this machine</source>
        <translation>%1 ist dieser Maschine nicht bekannt</translation>
    </message>
    <message>
        <source>the word %1 is not understood here</source>
        <translation>Das Wort %1 wird hier nicht verstanden</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not understood</source>
        <translation>„%1“ wird nicht verstanden</translation>
    </message>
    <message>
        <source>two functions of one group are in the block: %1</source>
        <translation>Zwei Funktionen einer Gruppe stehen im Satz: %1</translation>
    </message>
    <message>
        <source>the address %1 is programmed more than once in the block</source>
        <translation>Die Adresse %1 ist im Satz mehrfach programmiert</translation>
    </message>
    <message>
        <source>circle end-point error: there is no circle through these points</source>
        <translation>Kreisendpunktfehler: Durch diese Punkte geht kein Kreis</translation>
    </message>
    <message>
        <source>circle end-point error: the radii at start and end differ by %1 mm</source>
        <translation>Kreisendpunktfehler: Die Radien an Anfangs- und Endpunkt unterscheiden sich um %1 mm</translation>
    </message>
    <message>
        <source>circle end-point error: the radius is too small (%1)</source>
        <translation>Kreisendpunktfehler: Der Radius ist zu klein (%1)</translation>
    </message>
    <message>
        <source>the arc starts at an unknown position: %1</source>
        <translation>Der Bogen beginnt an unbekannter Position: %1</translation>
    </message>
    <message>
        <source>the increment of %1 starts at an unknown position</source>
        <translation>Das Kettenmaß von %1 beginnt an unbekannter Position</translation>
    </message>
    <message>
        <source>no feed is programmed</source>
        <translation>Es ist kein Vorschub programmiert</translation>
    </message>
    <message>
        <source>the programmed path speed %1 is not positive</source>
        <translation>Der programmierte Vorschub %1 ist nicht größer als 0</translation>
    </message>
    <message>
        <source>the value of %1 is out of range</source>
        <translation>Der Wert von %1 liegt außerhalb des zulässigen Bereichs</translation>
    </message>
    <message>
        <source>circle end-point error: %1 is not in the plane of the arc</source>
        <translation>Kreisendpunktfehler: %1 liegt nicht in der Ebene des Bogens</translation>
    </message>
    <message>
        <source>%1 is not a cycle of this machine</source>
        <translation>%1 ist kein Zyklus dieser Maschine</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>Ein Wert fehlt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a value</source>
        <translation>„%1“ ist kein Wert</translation>
    </message>
    <message>
        <source>a constant in quotes is written &apos;H1F&apos; or &apos;B101&apos;</source>
        <translation>Eine Konstante in Hochkommas schreibt man &apos;H1F&apos; oder &apos;B101&apos;</translation>
    </message>
    <message>
        <source>a text in quotes is expected</source>
        <translation>Ein Text in Anführungszeichen wird erwartet</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>Eine Klammer ist nicht geschlossen</translation>
    </message>
    <message>
        <source>an operand is missing</source>
        <translation>Ein Operand fehlt</translation>
    </message>
    <message>
        <source>the calculation is nested too deeply</source>
        <translation>Die Rechnung ist zu tief geschachtelt</translation>
    </message>
    <message>
        <source>%1 is neither a variable nor a function</source>
        <translation>%1 ist weder Variable noch Funktion</translation>
    </message>
    <message>
        <source>%1 needs its argument in brackets</source>
        <translation>%1 braucht sein Argument in Klammern</translation>
    </message>
    <message>
        <source>%1 needs more arguments</source>
        <translation>%1 braucht mehr Argumente</translation>
    </message>
    <message>
        <source>ATAN is written ATAN[y]/[x]</source>
        <translation>ATAN schreibt man ATAN[y]/[x]</translation>
    </message>
    <message>
        <source>EXISTS is written EXISTS[#&lt;name&gt;]</source>
        <translation>EXISTS schreibt man EXISTS[#&lt;name&gt;]</translation>
    </message>
    <message>
        <source>R needs a number or an index in brackets</source>
        <translation>R braucht eine Nummer oder einen Index in Klammern</translation>
    </message>
    <message>
        <source>the number of a variable is missing or too large</source>
        <translation>Die Nummer einer Variablen fehlt oder ist zu groß</translation>
    </message>
    <message>
        <source>the name of a variable is not closed with &gt;</source>
        <translation>Der Name einer Variablen ist nicht mit &gt; geschlossen</translation>
    </message>
    <message>
        <source>%1 is not a variable</source>
        <translation>%1 ist keine Variable</translation>
    </message>
    <message>
        <source>%1 needs an axis or an index in brackets</source>
        <translation>%1 braucht eine Achse oder einen Index in Klammern</translation>
    </message>
    <message>
        <source>an equals sign is missing</source>
        <translation>Ein Gleichheitszeichen fehlt</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be assigned to</source>
        <translation>„%1“ kann kein Wert zugewiesen werden</translation>
    </message>
    <message>
        <source>SET and REP need a list in brackets, with commas between its values</source>
        <translation>SET und REP brauchen eine Liste in Klammern mit Kommas zwischen den Werten</translation>
    </message>
    <message>
        <source>the name of a variable is missing</source>
        <translation>Der Name einer Variablen fehlt</translation>
    </message>
    <message>
        <source>%1 is not a type for DEF</source>
        <translation>%1 ist kein Typ für DEF</translation>
    </message>
    <message>
        <source>the size of an array is missing or too large</source>
        <translation>Die Größe eines Felds fehlt oder ist zu groß</translation>
    </message>
    <message>
        <source>the parameters of PROC are written PROC name(type name, ...)</source>
        <translation>Die Parameter von PROC schreibt man PROC Name(Typ Name, ...)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing, or has no meaning here</source>
        <translation>„%1“ fehlt oder hat hier keine Bedeutung</translation>
    </message>
    <message>
        <source>an address needs a number or &quot;=&quot;</source>
        <translation>Eine Adresse braucht eine Zahl oder „=“</translation>
    </message>
    <message>
        <source>the jump has no target</source>
        <translation>Der Sprung hat kein Ziel</translation>
    </message>
    <message>
        <source>only GOTO may follow a condition</source>
        <translation>Nach einer Bedingung darf nur GOTO stehen</translation>
    </message>
    <message>
        <source>FOR is written FOR i = a TO b</source>
        <translation>FOR schreibt man FOR i = a TO b</translation>
    </message>
    <message>
        <source>CASE is written CASE(value) OF constant GOTOF target</source>
        <translation>CASE schreibt man CASE(Wert) OF Konstante GOTOF Ziel</translation>
    </message>
    <message>
        <source>the %1 that begins here is not closed</source>
        <translation>%1 beginnt hier und ist nicht geschlossen</translation>
    </message>
    <message>
        <source>%1 has no beginning</source>
        <translation>%1 hat keinen Anfang</translation>
    </message>
    <message>
        <source>control structures are nested more than 16 deep</source>
        <translation>Kontrollstrukturen sind mehr als 16-fach geschachtelt</translation>
    </message>
    <message>
        <source>a synchronized action needs a number from 1 to 255</source>
        <translation>Eine Synchronaktion braucht eine Nummer von 1 bis 255</translation>
    </message>
    <message>
        <source>a synchronized action is written ID=1 WHEN condition DO assignment</source>
        <translation>Eine Synchronaktion schreibt man ID=1 WHEN Bedingung DO Zuweisung</translation>
    </message>
    <message>
        <source>a synchronized action can only assign to $R and variables of the main run</source>
        <translation>Eine Synchronaktion kann nur $R und Variablen des Hauptlaufs zuweisen</translation>
    </message>
    <message>
        <source>the target %1 is missing</source>
        <translation>Das Ziel %1 fehlt</translation>
    </message>
    <message>
        <source>the program %1 does not exist</source>
        <translation>Das Programm %1 gibt es nicht</translation>
    </message>
    <message>
        <source>%1 is not defined, and there is no program of this name</source>
        <translation>%1 ist nicht definiert, und es gibt kein Programm dieses Namens</translation>
    </message>
    <message>
        <source>subprograms call each other too deeply</source>
        <translation>Unterprogramme rufen sich zu tief geschachtelt auf</translation>
    </message>
    <message>
        <source>a division by zero</source>
        <translation>Division durch null</translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation>%1 hat keinen Wert</translation>
    </message>
    <message>
        <source>the result is too large</source>
        <translation>Das Ergebnis ist zu groß</translation>
    </message>
    <message>
        <source>it needs a value that is not known</source>
        <translation>Ein dafür nötiger Wert ist nicht bekannt</translation>
    </message>
    <message>
        <source>R%1 is read before the program sets it: only the control knows it</source>
        <translation>R%1 wird gelesen, bevor das Programm es setzt: Nur die Steuerung kennt den Wert</translation>
    </message>
    <message>
        <source>R[%1] does not exist</source>
        <translation>R[%1] gibt es nicht</translation>
    </message>
    <message>
        <source>%1 is not defined</source>
        <translation>%1 ist nicht definiert</translation>
    </message>
    <message>
        <source>an array needs its index in brackets</source>
        <translation>Ein Feld braucht seinen Index in Klammern</translation>
    </message>
    <message>
        <source>the array has fewer dimensions</source>
        <translation>Das Feld hat weniger Dimensionen</translation>
    </message>
    <message>
        <source>the array has more dimensions</source>
        <translation>Das Feld hat mehr Dimensionen</translation>
    </message>
    <message>
        <source>the index is outside the array</source>
        <translation>Der Index liegt außerhalb des Felds</translation>
    </message>
    <message>
        <source>a calculation uses a text</source>
        <translation>Mit einem Text wird gerechnet</translation>
    </message>
    <message>
        <source>the value is not of type %1</source>
        <translation>Der Wert ist nicht vom Typ %1</translation>
    </message>
    <message>
        <source>the value is outside the range of type %1</source>
        <translation>Der Wert liegt außerhalb des Bereichs von Typ %1</translation>
    </message>
    <message>
        <source>the list has more values than the array has elements</source>
        <translation>Die Liste hat mehr Werte als das Feld Elemente</translation>
    </message>
    <message>
        <source>only the control knows the value of %1</source>
        <translation>Nur die Steuerung kennt den Wert von %1</translation>
    </message>
    <message>
        <source>a variable of the control would be written</source>
        <translation>Eine Variable der Steuerung würde geschrieben</translation>
    </message>
    <message>
        <source>the subprogram takes %1 values</source>
        <translation>Das Unterprogramm nimmt %1 Werte</translation>
    </message>
    <message>
        <source>the parameter %1 is given by reference and needs a variable</source>
        <translation>Der Parameter %1 wird als Referenz übergeben und braucht eine Variable</translation>
    </message>
    <message>
        <source>the parameter %1 is given by reference and needs a variable of its own type</source>
        <translation>Der Parameter %1 wird als Referenz übergeben und braucht eine Variable des gleichen Typs</translation>
    </message>
    <message>
        <source>a synchronized action reads R or an array by an index of the main run: use $R</source>
        <translation>Eine Synchronaktion liest R oder ein Feld mit einem Index des Hauptlaufs: $R verwenden</translation>
    </message>
    <message>
        <source>GOTO or THEN must follow a condition</source>
        <translation>Auf eine Bedingung muss GOTO oder THEN folgen</translation>
    </message>
    <message>
        <source>WHILE is written WHILE [condition] DO1</source>
        <translation>WHILE schreibt man WHILE [Bedingung] DO1</translation>
    </message>
    <message>
        <source>an O word needs a number or &lt;name&gt;</source>
        <translation>Ein O-Wort braucht eine Nummer oder &lt;name&gt;</translation>
    </message>
    <message>
        <source>%1 is not known</source>
        <translation>%1 ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1 is not in a loop</source>
        <translation>%1 steht nicht in einer Schleife</translation>
    </message>
    <message>
        <source>%1 has no call</source>
        <translation>%1 hat keinen Aufruf</translation>
    </message>
    <message>
        <source>a subprogram is defined inside %1</source>
        <translation>In %1 ist ein Unterprogramm definiert</translation>
    </message>
    <message>
        <source>a blank is inside the number &quot;%1&quot;</source>
        <translation>im Zahlenwert „%1“ steht ein Leerzeichen</translation>
    </message>
    <message>
        <source>the invisible character %1 has no meaning here</source>
        <translation>das unsichtbare Zeichen %1 hat hier keine Bedeutung</translation>
    </message>
    <message>
        <source>a bracket is opened within the comment %1</source>
        <translation>im Kommentar %1 wird eine Klammer geöffnet</translation>
    </message>
    <message>
        <source>the program has more than %1 variables</source>
        <translation>das Programm hat mehr als %1 Variablen</translation>
    </message>
    <message>
        <source>%1 cannot be written by a program here</source>
        <translation>%1 kann hier von einem Programm nicht geschrieben werden</translation>
    </message>
    <message>
        <source>the program stops here with its alarm %1</source>
        <translation>das Programm hält hier mit seinem Alarm %1 an</translation>
    </message>
    <message>
        <source>the file holds two programs of the name %1: rename or remove one of them</source>
        <translation>die Datei enthält zwei Programme mit dem Namen %1: eines umbenennen oder entfernen</translation>
    </message>
    <message>
        <source>the unit of the feed was chosen behind the last F</source>
        <translation>Die Einheit des Vorschubs wurde nach dem letzten F gewählt</translation>
    </message>
    <message>
        <source>the program takes more memory than is allowed: split it</source>
        <translation>Das Programm braucht mehr Speicher, als erlaubt ist: Programm aufteilen</translation>
    </message>
    <message>
        <source>the block lacks a word that the control needs (%1)</source>
        <translation>dem Satz fehlt ein Wort, das die Steuerung braucht (%1)</translation>
    </message>
    <message>
        <source>the block cannot be executed here (%1)</source>
        <translation>der Satz kann hier nicht ausgeführt werden (%1)</translation>
    </message>
</context>
<context>
    <name>FeedTestTexts</name>
    <message>
        <source>no axis was moved</source>
        <translation>keine Achse wurde bewegt</translation>
    </message>
    <message>
        <source>4. The override is changed while the axis moves. Then press cycle start once more: the next program must move at its own feed, and only the control can stop it.</source>
        <translation>4. Der Override wird geändert, während die Achse fährt. Danach noch einmal NC-Start drücken: Das nächste Programm muss mit seinem eigenen Vorschub fahren, und nur die Steuerung kann es anhalten.</translation>
    </message>
    <message>
        <source>4. The override is changed; no axis moves.</source>
        <translation>4. Der Override wird geändert; keine Achse fährt.</translation>
    </message>
    <message>
        <source>Not tested: on this control a stop is sure to act only before the next window</source>
        <translation>Nicht getestet: An dieser Steuerung wirkt ein Stopp sicher erst vor dem nächsten Fenster</translation>
    </message>
    <message>
        <source>Passed: stop, pause and override act at once on this control</source>
        <translation>Bestanden: Stopp, Pause und Override wirken an dieser Steuerung sofort</translation>
    </message>
    <message>
        <source>Passed without motion. Whether the axes obey shows only when one moves.</source>
        <translation>Ohne Bewegung bestanden. Ob die Achsen gehorchen, zeigt sich erst, wenn eine fährt.</translation>
    </message>
    <message>
        <source>Not passed: on this control a stop is sure to act only before the next window</source>
        <translation>Nicht bestanden: An dieser Steuerung wirkt ein Stopp sicher erst vor dem nächsten Fenster</translation>
    </message>
    <message>
        <source>Synchronized actions make the override that is wanted, and keep it.</source>
        <translation>Synchronaktionen bilden den gewünschten Override und halten ihn.</translation>
    </message>
    <message>
        <source>Without a sign of the client the override is 0.</source>
        <translation>Ohne Lebenszeichen des Clients ist der Override 0.</translation>
    </message>
    <message>
        <source>At 50 % the axis takes twice as long.</source>
        <translation>Mit 50 % braucht die Achse doppelt so lange.</translation>
    </message>
    <message>
        <source>At 0 % the axis stands on its way.</source>
        <translation>Mit 0 % steht die Achse unterwegs.</translation>
    </message>
    <message>
        <source>It brakes at once when 0 % is wanted.</source>
        <translation>Sie bremst sofort, wenn 0 % gewünscht ist.</translation>
    </message>
    <message>
        <source>It moves in no interpolation cycle while it is held.</source>
        <translation>Angehalten bewegt sie sich in keinem Interpolationstakt.</translation>
    </message>
    <message>
        <source>The synchronized actions end with their program.</source>
        <translation>Die Synchronaktionen enden mit ihrem Programm.</translation>
    </message>
    <message>
        <source>The next program moves at its own feed.</source>
        <translation>Das nächste Programm fährt mit seinem eigenen Vorschub.</translation>
    </message>
    <message>
        <source>; the tool may be lifted by %1</source>
        <translation>; das Werkzeug darf um %1 abgehoben werden</translation>
    </message>
    <message>
        <source>4. The override is changed while the axis moves; held, the tool goes up and comes back, twice. Then press cycle start once more: the next program must move at its own feed, and only the control can stop it.</source>
        <translation>4. Der Override wird geändert, während die Achse fährt; angehalten hebt das Werkzeug zweimal ab und kommt zurück. Danach noch einmal NC-Start drücken: Das nächste Programm muss mit seinem eigenen Vorschub fahren, und nur die Steuerung kann es anhalten.</translation>
    </message>
    <message>
        <source>The control allows the overlay of Z that the lift needs.</source>
        <translation>Die Steuerung lässt die Überlagerung von Z zu, die das Abheben braucht.</translation>
    </message>
    <message>
        <source>Nothing but 0 to the lift moves the tool.</source>
        <translation>Nur Werte von 0 bis zum Abhub bewegen das Werkzeug.</translation>
    </message>
    <message>
        <source>The tool is lifted while the axis is held.</source>
        <translation>Das Werkzeug wird abgehoben, während die Achse angehalten ist.</translation>
    </message>
    <message>
        <source>The axis stands while the tool is lifted.</source>
        <translation>Die Achse steht, solange das Werkzeug abgehoben ist.</translation>
    </message>
    <message>
        <source>The tool comes back to its path.</source>
        <translation>Das Werkzeug kommt auf seine Bahn zurück.</translation>
    </message>
    <message>
        <source>Let go, the axis moves only when the tool is back.</source>
        <translation>Freigegeben fährt die Achse erst, wenn das Werkzeug zurück ist.</translation>
    </message>
    <message>
        <source>Stop, pause and override act at once because the control obeys an R-parameter in every interpolation cycle. This test finds out whether it does: first without motion, then, if you agree, with one axis that moves back and forth in the air and is held on its way. The channel must be in reset.</source>
        <translation>Stopp, Pause und Override wirken sofort, weil die Steuerung in jedem Interpolationstakt einem R-Parameter gehorcht. Dieser Test stellt fest, ob sie es tut: zuerst ohne Bewegung, dann, wenn Sie zustimmen, mit einer Achse, die in der Luft hin und her fährt und unterwegs angehalten wird. Der Kanal muss im Reset sein.</translation>
    </message>
    <message>
        <source>No other client writes the override of this test.</source>
        <translation>Kein anderer Client schreibt den Override dieses Tests.</translation>
    </message>
    <message>
        <source>; held, it was seen to stand after %1</source>
        <translation>; angehalten stand sie nach %1 still</translation>
    </message>
</context>
<context>
    <name>FileSheetTexts</name>
    <message>
        <source>%1 is already there. Replace it?</source>
        <translation>%1 ist schon vorhanden. Ersetzen?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
</context>
<context>
    <name>FoundRunTexts</name>
    <message>
        <source>A program of Rivulet without a run</source>
        <translation>Ein Programm von Rivulet ohne Lauf</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Lauf %1</translation>
    </message>
    <message>
        <source>Run %1 of %2</source>
        <translation>Lauf %1 von %2</translation>
    </message>
    <message>
        <source>It is not known who started it.</source>
        <translation>Wer ihn gestartet hat, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Started by %1 on %2 at %3.</source>
        <translation>Gestartet von %1 auf %2 am %3.</translation>
    </message>
    <message>
        <source>%1 of %2 points executed</source>
        <translation>%1 von %2 Punkten ausgeführt</translation>
    </message>
    <message>
        <source>%1. Looking for its client …</source>
        <translation>%1. Der Client wird gesucht …</translation>
    </message>
    <message>
        <source>It waits for its first client.</source>
        <translation>Es wartet auf seinen ersten Client.</translation>
    </message>
    <message>
        <source>%1. Its client is gone: the program waits.</source>
        <translation>%1. Der Client ist weg: Das Programm wartet.</translation>
    </message>
    <message>
        <source>%1. Its client is at work.</source>
        <translation>%1. Der Client arbeitet.</translation>
    </message>
    <message>
        <source>It was not completed, and its program is no longer active on the control.</source>
        <translation>Er ist nicht zu Ende, und sein Programm ist auf der Steuerung nicht mehr aktiv.</translation>
    </message>
    <message>
        <source>Stop confirmed after %1.</source>
        <translation>Stopp bestätigt nach %1.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows executed</source>
        <translation>
            <numerusform>%Ln Fenster ausgeführt</numerusform>
            <numerusform>%Ln Fenster ausgeführt</numerusform>
        </translation>
    </message>
    <message>
        <source>The axes stand (%1 after the order), and stay where they are until the run is ended or resumed.</source>
        <translation>Die Achsen stehen (%1 nach dem Befehl) und bleiben, wo sie sind, bis der Lauf beendet oder fortgesetzt wird.</translation>
    </message>
</context>
<context>
    <name>GroupingTexts</name>
    <message>
        <source>Lists</source>
        <translation>Listen</translation>
    </message>
    <message>
        <source>One by one</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>Arrays by count</source>
        <translation>Felder nach Anzahl</translation>
    </message>
    <message>
        <source>Arrays by range</source>
        <translation>Felder nach Bereich</translation>
    </message>
</context>
<context>
    <name>HazardTexts</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>Line %1 (part %2)</source>
        <translation>Zeile %1 (Abschnitt %2)</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>S%1 is %2 1/min more than the spindle can turn; the control reduces it to %3 1/min.</source>
        <translation>S%1 ist um %2 1/min mehr, als die Spindel drehen kann; die Steuerung begrenzt auf %3 1/min.</translation>
    </message>
    <message>
        <source>Tool %1 is not in the tool table of the machine. Enter it there, or choose another tool.</source>
        <translation>Werkzeug %1 ist nicht in der Werkzeugtabelle der Maschine. Dort eintragen oder ein anderes Werkzeug wählen.</translation>
    </message>
    <message>
        <source>The machine would stop with alarm %1: %2</source>
        <translation>Die Maschine würde mit Alarm %1 anhalten: %2</translation>
    </message>
    <message>
        <source>From here on the job cannot be checked, because only the control knows what this block does: %1</source>
        <translation>Ab hier lässt sich der Auftrag nicht prüfen, weil nur die Steuerung weiß, was dieser Satz tut: %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>%1 would go to %2 in machine coordinates, %3 beyond its limit of %4. Move the workpiece or change the work offset.</source>
        <translation>%1 würde auf %2 in Maschinenkoordinaten fahren, %3 über die Grenze von %4 hinaus. Werkstück versetzen oder Nullpunktverschiebung ändern.</translation>
    </message>
    <message>
        <source>Tool %1 is not in the tool table of the machine, but %2 is. Enter %1 there, or write %2 into the program.</source>
        <translation>Werkzeug %1 steht nicht in der Werkzeugtabelle der Maschine, aber %2. Dort %1 eintragen oder im Programm %2 schreiben.</translation>
    </message>
</context>
<context>
    <name>JobTestTexts</name>
    <message>
        <source>In a whole job the control executes blocks of its own between stretches that Rivulet streams. This test finds out whether it does that once, in order and only when it may, and whether stop, pause and a lost connection act in both: one axis moves back and forth in the air. Enter the blocks that your jobs have, one a line, each so that nothing is in its way; other kinds are not released. The channel must be in reset.</source>
        <translation>In einem ganzen Auftrag führt die Steuerung zwischen den gestreamten Abschnitten eigene Sätze aus. Dieser Test stellt fest, ob sie das einmal, in der richtigen Reihenfolge und nur mit Erlaubnis tut, und ob Stopp, Pause und eine verlorene Verbindung in beiden wirken: Eine Achse fährt in der Luft hin und her. Die Sätze eingeben, die Ihre Aufträge haben, einen je Zeile, jeden so, dass ihm nichts im Weg ist; andere Arten werden nicht freigegeben. Der Kanal muss im Reset sein.</translation>
    </message>
    <message>
        <source>4. The job is stopped and left alone, in a block and in a stretch, then it goes through: press cycle start each time, %1 times in all.</source>
        <translation>4. Der Auftrag wird in einem Satz und in einem Abschnitt gestoppt und alleingelassen, dann läuft er durch: jedes Mal NC-Start drücken, insgesamt %1-mal.</translation>
    </message>
    <message>
        <source>Passed: whole jobs may run on this control, with the blocks that were tried</source>
        <translation>Bestanden: Ganze Aufträge dürfen auf dieser Steuerung laufen, mit den erprobten Sätzen</translation>
    </message>
    <message>
        <source>No block is executed before Rivulet permits it.</source>
        <translation>Kein Satz wird ausgeführt, bevor Rivulet es erlaubt.</translation>
    </message>
    <message>
        <source>After a stretch no block is executed before Rivulet permits it.</source>
        <translation>Nach einem Abschnitt wird kein Satz ausgeführt, bevor Rivulet es erlaubt.</translation>
    </message>
    <message>
        <source>A stop in a block ends the job after that block.</source>
        <translation>Ein Stopp in einem Satz beendet den Auftrag nach diesem Satz.</translation>
    </message>
    <message>
        <source>A stop in a stretch ends the job there.</source>
        <translation>Ein Stopp in einem Abschnitt beendet den Auftrag dort.</translation>
    </message>
    <message>
        <source>In a block the axis stands when the connection is lost, and the job can be ended.</source>
        <translation>In einem Satz steht die Achse, wenn die Verbindung verloren ist, und der Auftrag lässt sich beenden.</translation>
    </message>
    <message>
        <source>In a stretch the axis stands when the connection is lost, and the job can be ended.</source>
        <translation>In einem Abschnitt steht die Achse, wenn die Verbindung verloren ist, und der Auftrag lässt sich beenden.</translation>
    </message>
    <message>
        <source>In a block the axis stands while it is held.</source>
        <translation>In einem Satz steht die Achse, solange sie angehalten ist.</translation>
    </message>
    <message>
        <source>In a stretch the axis stands while it is held.</source>
        <translation>In einem Abschnitt steht die Achse, solange sie angehalten ist.</translation>
    </message>
    <message>
        <source>Blocks and stretches are executed in turns, once each.</source>
        <translation>Sätze und Abschnitte werden abwechselnd ausgeführt, jeder einmal.</translation>
    </message>
    <message>
        <source>No block is passed over.</source>
        <translation>Kein Satz wird übergangen.</translation>
    </message>
    <message>
        <source>The override of the job ends with it.</source>
        <translation>Der Override des Auftrags endet mit ihm.</translation>
    </message>
    <message>
        <source>Not tested: on a real control only the motion of a program runs</source>
        <translation>Nicht getestet: Auf einer echten Steuerung läuft nur die Bewegung eines Programms</translation>
    </message>
    <message>
        <source>Not passed: on a real control only the motion of a program runs</source>
        <translation>Nicht bestanden: Auf einer echten Steuerung läuft nur die Bewegung eines Programms</translation>
    </message>
</context>
<context>
    <name>JobTexts</name>
    <message>
        <source>swivels or transforms the coordinates</source>
        <translation>schwenkt oder transformiert die Koordinaten</translation>
    </message>
    <message>
        <source>tool radius compensation</source>
        <translation>Werkzeugradiuskorrektur</translation>
    </message>
    <message>
        <source>cycle of the control</source>
        <translation>Zyklus der Steuerung</translation>
    </message>
    <message>
        <source>subprogram that is not at hand</source>
        <translation>Unterprogramm, das nicht vorliegt</translation>
    </message>
    <message>
        <source>measures, or reads the machine</source>
        <translation>misst oder liest die Maschine</translation>
    </message>
    <message>
        <source>moves in machine coordinates</source>
        <translation>fährt in Maschinenkoordinaten</translation>
    </message>
    <message>
        <source>path made by the control</source>
        <translation>Bahn, die die Steuerung erzeugt</translation>
    </message>
    <message>
        <source>rounded or chamfered corner</source>
        <translation>gerundete oder gefaste Ecke</translation>
    </message>
    <message>
        <source>counts from a position that only the control knows</source>
        <translation>zählt von einer Position, die nur die Steuerung kennt</translation>
    </message>
    <message>
        <source>tool or tool length</source>
        <translation>Werkzeug oder Werkzeuglänge</translation>
    </message>
    <message>
        <source>work offset</source>
        <translation>Nullpunktverschiebung</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>Spindel</translation>
    </message>
    <message>
        <source>coolant</source>
        <translation>Kühlmittel</translation>
    </message>
    <message>
        <source>stops until cycle start</source>
        <translation>hält bis NC-Start</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>Verweilzeit</translation>
    </message>
    <message>
        <source>message at the control</source>
        <translation>Meldung an der Steuerung</translation>
    </message>
    <message>
        <source>how the control moves</source>
        <translation>wie die Steuerung fährt</translation>
    </message>
    <message>
        <source>function of the machine</source>
        <translation>Funktion der Maschine</translation>
    </message>
    <message>
        <source>end of the program</source>
        <translation>Ende des Programms</translation>
    </message>
    <message>
        <source>The control executes this block: %1.</source>
        <translation>Diesen Satz führt die Steuerung aus: %1.</translation>
    </message>
    <message>
        <source>Afterwards the position is read from the control.</source>
        <translation>Danach wird die Position von der Steuerung gelesen.</translation>
    </message>
    <message numerus="yes">
        <source>Part %1 of %2: lines %3 to %4 are streamed, %Ln points.</source>
        <translation>
            <numerusform>Abschnitt %1 von %2: Zeilen %3 bis %4 werden gestreamt, %Ln Punkt.</numerusform>
            <numerusform>Abschnitt %1 von %2: Zeilen %3 bis %4 werden gestreamt, %Ln Punkte.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LimitTexts</name>
    <message>
        <source>rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>line %1: %2, %3</source>
        <translation>Zeile %1: %2, %3</translation>
    </message>
</context>
<context>
    <name>LiveTexts</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>hold after %1, end after %2</source>
        <translation>Halt nach %1, Ende nach %2</translation>
    </message>
    <message>
        <source>median %1, 99 % %2</source>
        <translation>Median %1, 99&#xa0;% %2</translation>
    </message>
    <message>
        <source>in theory %1</source>
        <translation>theoretisch %1</translation>
    </message>
    <message>
        <source>%1 from %2, executed to line %3</source>
        <translation>%1 von %2, ausgeführt bis Zeile %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln points merged</source>
        <translation>
            <numerusform>%Ln Punkt zusammengefasst</numerusform>
            <numerusform>%Ln Punkte zusammengefasst</numerusform>
        </translation>
    </message>
    <message>
        <source>Adaptive feed: %1 % of your override, from %2</source>
        <translation>Adaptiver Vorschub: %1&#xa0;% Ihres Overrides, von %2</translation>
    </message>
    <message>
        <source>Adaptive feed: without %1, until its next factor</source>
        <translation>Adaptiver Vorschub: ohne %1, bis zu ihrem nächsten Faktor</translation>
    </message>
    <message>
        <source>Adaptive feed: the axes are held. %1: %2</source>
        <translation>Adaptiver Vorschub: Die Achsen werden gehalten. %1: %2</translation>
    </message>
    <message>
        <source>Adaptive feed: your override acts alone. %1: %2</source>
        <translation>Adaptiver Vorschub: Nur Ihr Override wirkt. %1: %2</translation>
    </message>
    <message>
        <source>no factor has come yet</source>
        <translation>noch kein Faktor gekommen</translation>
    </message>
    <message>
        <source>no factor has come in time</source>
        <translation>kein Faktor zur rechten Zeit gekommen</translation>
    </message>
    <message>
        <source>%1 % was not agreed</source>
        <translation>%1&#xa0;% war nicht vereinbart</translation>
    </message>
    <message>
        <source>its last line is no factor</source>
        <translation>die letzte Zeile ist kein Faktor</translation>
    </message>
    <message>
        <source>it has closed</source>
        <translation>die Quelle ist geschlossen</translation>
    </message>
</context>
<context>
    <name>MachineCard</name>
    <message>
        <source>No run is known.</source>
        <translation>Kein Lauf bekannt.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Not connected with this window</source>
        <translation>Nicht mit diesem Fenster verbunden</translation>
    </message>
    <message>
        <source>%1, seen %2 ago</source>
        <translation>%1, gesehen vor %2</translation>
    </message>
    <message numerus="yes">
        <source>%n alarms</source>
        <translation>
            <numerusform>%n Alarm</numerusform>
            <numerusform>%n Alarme</numerusform>
        </translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>credit test</source>
        <translation>Kredit-Test</translation>
    </message>
    <message>
        <source>Remove this machine from the list? Its runs and recordings stay on the page Runs.</source>
        <translation>Diese Maschine aus der Liste entfernen? Ihre Läufe und Aufzeichnungen bleiben auf der Seite Läufe.</translation>
    </message>
    <message>
        <source>Put aside as files, and not used any more: %1.</source>
        <translation>Als Dateien beiseitegelegt und nicht mehr verwendet: %1.</translation>
    </message>
    <message>
        <source>Last run %1: %2, %3 of %4 points</source>
        <translation>Letzter Lauf %1: %2, %3 von %4 Punkten</translation>
    </message>
    <message>
        <source>Not connected; its port answered %1 ago</source>
        <translation>Nicht verbunden; ihr Port hat vor %1 geantwortet</translation>
    </message>
    <message>
        <source>Not reachable: no answer %1 ago</source>
        <translation>Nicht erreichbar: vor %1 keine Antwort</translation>
    </message>
    <message>
        <source>stop test</source>
        <translation>Stopp-Test</translation>
    </message>
    <message>
        <source>job test</source>
        <translation>Auftrags-Test</translation>
    </message>
</context>
<context>
    <name>MachinesTexts</name>
    <message>
        <source>During a run, the window stays with its machine.</source>
        <translation>Während eines Laufs bleibt das Fenster bei seiner Maschine.</translation>
    </message>
</context>
<context>
    <name>MoveTexts</name>
    <message>
        <source>%1 moved by %2 at %3</source>
        <translation>%1 fuhr %2 mit %3</translation>
    </message>
</context>
<context>
    <name>NoteTexts</name>
    <message>
        <source>Form of access: %1.</source>
        <translation>Form des Zugriffs: %1.</translation>
    </message>
    <message>
        <source>Program %1: %2, %3, %4.</source>
        <translation>Programm %1: %2, %3, %4.</translation>
    </message>
    <message>
        <source>Nothing has come from the control for %1 s.</source>
        <translation>Seit %1 s ist nichts von der Steuerung gekommen.</translation>
    </message>
    <message>
        <source>The control answers again.</source>
        <translation>Die Steuerung antwortet wieder.</translation>
    </message>
    <message>
        <source>The control answered slowly: accesses took up to %1 s, %2 times as long as expected. Each took at least %3 s: the network is slow, or the server is busy with another OPC UA client.</source>
        <translation>Die Steuerung hat langsam geantwortet: Zugriffe dauerten bis zu %1 s, %2-mal so lange wie erwartet. Jeder dauerte mindestens %3 s: Das Netz ist langsam, oder der Server ist mit einem anderen OPC-UA-Client beschäftigt.</translation>
    </message>
    <message>
        <source>The control answered slowly: accesses took up to %1 s, %2 times as long as expected. Others were fast: another OPC UA client keeps the server busy at times, or the network stalls.</source>
        <translation>Die Steuerung hat langsam geantwortet: Zugriffe dauerten bis zu %1 s, %2-mal so lange wie erwartet. Andere waren schnell: Ein anderer OPC-UA-Client beschäftigt den Server zeitweise, oder das Netz stockt.</translation>
    </message>
    <message>
        <source>Online correction in mm: X %1 Y %2 Z %3</source>
        <translation>Online-Korrektur in mm: X %1 Y %2 Z %3</translation>
    </message>
    <message>
        <source>The control has refused a request: asked again.</source>
        <translation>Die Steuerung hat eine Anfrage abgelehnt: noch einmal gefragt.</translation>
    </message>
    <message>
        <source>No answer in time: asked again.</source>
        <translation>Keine Antwort in der Zeit: noch einmal gefragt.</translation>
    </message>
    <message>
        <source>The stream was given up: %1</source>
        <translation>Der Stream wurde aufgegeben: %1</translation>
    </message>
    <message>
        <source>A signal was out of sequence: a window has been executed again.</source>
        <translation>Ein Signal kam außer der Reihe: Ein Fenster wurde noch einmal ausgeführt.</translation>
    </message>
    <message>
        <source>The place of the run could not be kept, so it cannot be resumed after a crash of this program: %1</source>
        <translation>Der Ort des Laufs ließ sich nicht festhalten, darum kann er nach einem Absturz dieses Programms nicht fortgesetzt werden: %1</translation>
    </message>
    <message>
        <source>The reason why the program ended could not be read.</source>
        <translation>Der Grund, warum das Programm endete, ließ sich nicht lesen.</translation>
    </message>
    <message>
        <source>The trace of the control could not be fetched: %1</source>
        <translation>Die Aufzeichnung der Steuerung ließ sich nicht holen: %1</translation>
    </message>
    <message>
        <source>The trace of the control is incomplete: the run is not judged.</source>
        <translation>Die Aufzeichnung der Steuerung ist unvollständig: Der Lauf wird nicht beurteilt.</translation>
    </message>
    <message>
        <source>The name of the run could not be stored: %1</source>
        <translation>Der Name des Laufs ließ sich nicht speichern: %1</translation>
    </message>
    <message>
        <source>written</source>
        <translation>geschrieben</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>schon da</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>verglichen</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>nicht verglichen</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>angewählt</translation>
    </message>
    <message>
        <source>to be selected</source>
        <translation>anzuwählen</translation>
    </message>
    <message>
        <source>Adaptive feed: the source is followed.</source>
        <translation>Adaptiver Vorschub: Die Quelle wird befolgt.</translation>
    </message>
    <message>
        <source>Adaptive feed: no factor has come yet: %1</source>
        <translation>Adaptiver Vorschub: noch kein Faktor gekommen: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: no factor for %1 s: %2</source>
        <translation>Adaptiver Vorschub: kein Faktor seit %1 s: %2</translation>
    </message>
    <message>
        <source>Adaptive feed: the factor %1 was not agreed: %2 to %3, where 1 is 100 %: %4</source>
        <translation>Adaptiver Vorschub: Der Faktor %1 war nicht vereinbart: %2 bis %3, wobei 1 für 100&#xa0;% steht: %4</translation>
    </message>
    <message>
        <source>Adaptive feed: the line is no factor, as feed 0.85 would be: %1</source>
        <translation>Adaptiver Vorschub: Die Zeile ist kein Faktor, wie feed 0.85 einer wäre: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: the source has closed: %1</source>
        <translation>Adaptiver Vorschub: Die Quelle ist geschlossen: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: the operator goes on without the source.</source>
        <translation>Adaptiver Vorschub: Der Bediener fährt ohne die Quelle fort.</translation>
    </message>
    <message>
        <source>the axes are held.</source>
        <translation>Die Achsen werden gehalten.</translation>
    </message>
    <message>
        <source>the override of the operator acts alone.</source>
        <translation>Nur der Override des Bedieners wirkt.</translation>
    </message>
    <message>
        <source>The axes are told to stand.</source>
        <translation>Die Achsen sollen anhalten.</translation>
    </message>
    <message>
        <source>The axes are told to go on, override %1 %.</source>
        <translation>Die Achsen sollen weiterfahren, Override %1 %.</translation>
    </message>
    <message>
        <source>Override %1 % requested.</source>
        <translation>Override %1 % angefordert.</translation>
    </message>
    <message>
        <source>An override of %1 % is refused: choose %2 to %3 %.</source>
        <translation>Ein Override von %1 % wird abgelehnt: %2 bis %3 % wählen.</translation>
    </message>
    <message>
        <source>Another client has set the override to %1 %: it stays until the next order.</source>
        <translation>Ein anderer Client hat den Override auf %1 % gestellt: Er bleibt bis zur nächsten Anforderung.</translation>
    </message>
    <message>
        <source>Another client has written the factor %1: %2 is written again.</source>
        <translation>Ein anderer Client hat den Faktor %1 geschrieben: %2 wird erneut geschrieben.</translation>
    </message>
    <message>
        <source>The control does not obey: its override is %1 %.</source>
        <translation>Die Steuerung gehorcht nicht: Ihr Override ist %1 %.</translation>
    </message>
    <message>
        <source>The axes stand, %1 s after it was requested.</source>
        <translation>Die Achsen stehen, %1 s nach der Anforderung.</translation>
    </message>
    <message>
        <source>The axes move although the override is 0: what moves now does not obey it. Stop it at the control.</source>
        <translation>Die Achsen fahren, obwohl der Override 0 ist: Was jetzt fährt, gehorcht ihm nicht. An der Steuerung anhalten.</translation>
    </message>
    <message>
        <source>For %1 s no sign of this computer has reached the control: the axes have stood meanwhile.</source>
        <translation>%1 s lang hat die Steuerung kein Lebenszeichen dieses Rechners erreicht: Die Achsen haben so lange gestanden.</translation>
    </message>
    <message>
        <source>Lift of the tool in mm: %1</source>
        <translation>Abheben des Werkzeugs in mm: %1</translation>
    </message>
    <message>
        <source>Stopped: the axes are held, and the program is left.</source>
        <translation>Gestoppt: Die Achsen werden gehalten, und das Programm wird verlassen.</translation>
    </message>
    <message>
        <source>This program has no feed cell: Pause acts before the next window.</source>
        <translation>Dieses Programm hat keine Vorschubzelle: Pause wirkt vor dem nächsten Fenster.</translation>
    </message>
    <message>
        <source>Wrong motion: after point %1 the tool is %2 mm off the path.</source>
        <translation>Falsche Bewegung: Nach Punkt %1 ist das Werkzeug %2 mm neben der Bahn.</translation>
    </message>
    <message>
        <source>Wrong motion: points were repeated after point %1.</source>
        <translation>Falsche Bewegung: Nach Punkt %1 wurden Punkte wiederholt.</translation>
    </message>
    <message>
        <source>The control recorded a dwell of %1 s in line %2.</source>
        <translation>Die Steuerung hat eine Verweilzeit von %1 s in Zeile %2 aufgezeichnet.</translation>
    </message>
    <message>
        <source>The control recorded an auxiliary function of %1 s in line %2.</source>
        <translation>Die Steuerung hat eine Hilfsfunktion von %1 s in Zeile %2 aufgezeichnet.</translation>
    </message>
    <message>
        <source>The control recorded M%1 in line %2.</source>
        <translation>Die Steuerung hat M%1 in Zeile %2 aufgezeichnet.</translation>
    </message>
    <message>
        <source>The override was 0 while the axes stood.</source>
        <translation>Der Override war 0, solange die Achsen standen.</translation>
    </message>
    <message>
        <source>A write of %1 values was answered %2 ms before the axes moved again.</source>
        <translation>Das Schreiben von %1 Werten wurde %2 ms vor der nächsten Bewegung der Achsen beantwortet.</translation>
    </message>
    <message>
        <source>The program on the control has a STOPRE between line %1 and line %2.</source>
        <translation>Das Programm auf der Steuerung hat ein STOPRE zwischen Zeile %1 und Zeile %2.</translation>
    </message>
    <message>
        <source>The program on the control jumps from line %1 back to line %2.</source>
        <translation>Das Programm auf der Steuerung springt von Zeile %1 zurück zu Zeile %2.</translation>
    </message>
    <message>
        <source>The path turns by %1° there.</source>
        <translation>Dort knickt die Bahn um %1°.</translation>
    </message>
    <message>
        <source>Line %1 of the program dwells there.</source>
        <translation>Zeile %1 des Programms verweilt dort.</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Feasibility</source>
        <translation>Machbarkeit</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Configure</source>
        <translation>Konfiguration</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Maschinen</translation>
    </message>
    <message>
        <source>Emulator</source>
        <translation>Emulator</translation>
    </message>
    <message>
        <source>CNC tasks</source>
        <translation>CNC-Aufgaben</translation>
    </message>
</context>
<context>
    <name>ParallelPageTexts</name>
    <message>
        <source>A run is in progress. Execute the program after it has ended: both would take the same processor.</source>
        <translation>Ein Lauf ist im Gang. Das Programm ausführen, wenn er beendet ist: Beide bräuchten denselben Prozessor.</translation>
    </message>
</context>
<context>
    <name>PauseTexts</name>
    <message>
        <source>M</source>
        <comment>letter for a measured pause</comment>
        <translation>G</translation>
    </message>
    <message>
        <source>I</source>
        <comment>letter for an inferred pause</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>P</source>
        <comment>letter for a predicted pause</comment>
        <translation>V</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>inferred</source>
        <translation>abgeleitet</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorhergesagt</translation>
    </message>
</context>
<context>
    <name>ProfileTexts</name>
    <message>
        <source>Axis %1: the travel must end above its beginning.</source>
        <translation>Achse %1: Der Verfahrweg muss über seinem Anfang enden.</translation>
    </message>
    <message>
        <source>Axis %1: the speed must be above zero.</source>
        <translation>Achse %1: Die Geschwindigkeit muss größer als null sein.</translation>
    </message>
    <message>
        <source>Axis %1: the acceleration must be above zero.</source>
        <translation>Achse %1: Die Beschleunigung muss größer als null sein.</translation>
    </message>
    <message>
        <source>Axis %1: the jerk must be above zero.</source>
        <translation>Achse %1: Der Ruck muss größer als null sein.</translation>
    </message>
    <message>
        <source>The rapid must be above zero.</source>
        <translation>Der Eilgang muss größer als null sein.</translation>
    </message>
    <message>
        <source>Tool %1: every tool needs its own number above zero.</source>
        <translation>Werkzeug %1: Jedes Werkzeug braucht eine eigene Nummer über null.</translation>
    </message>
    <message>
        <source>Without this computer the axes stand after 0.2 to 60 s; 0: not at all.</source>
        <translation>Ohne diesen Rechner stehen die Achsen nach 0,2 bis 60 s; 0: gar nicht.</translation>
    </message>
    <message>
        <source>Without a passed stop test a window takes at most 0.5 to 600 s.</source>
        <translation>Ohne bestandenen Stopp-Test dauert ein Fenster höchstens 0,5 bis 600 s.</translation>
    </message>
</context>
<context>
    <name>ProgramTexts</name>
    <message>
        <source>Parts of the path of %1 are not known: see the findings. The program cannot be streamed.</source>
        <translation>Die Bahn von %1 ist nicht vollständig bekannt: siehe Befunde. Das Programm ist nicht streambar.</translation>
    </message>
    <message>
        <source>%1 needs a transformation of the control. No method can stream it.</source>
        <translation>%1 braucht eine Transformation der Steuerung. Kein Verfahren kann das Programm streamen.</translation>
    </message>
    <message>
        <source>%1 moves no axis: there is nothing to stream.</source>
        <translation>%1 bewegt keine Achse: Es gibt nichts zu streamen.</translation>
    </message>
    <message>
        <source>A run is in progress. Open another program after it has ended.</source>
        <translation>Ein Lauf ist aktiv. Ein anderes Programm erst nach dem Ende des Laufs öffnen.</translation>
    </message>
    <message>
        <source>Reading %1 was cancelled.</source>
        <translation>Das Lesen von %1 wurde abgebrochen.</translation>
    </message>
    <message numerus="yes">
        <source>Opened %1 (%2), %Ln points.</source>
        <translation>
            <numerusform>%1 geöffnet (%2), %Ln Punkt.</numerusform>
            <numerusform>%1 geöffnet (%2), %Ln Punkte.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RehearsalTexts</name>
    <message>
        <source>The program is being simulated with these settings.</source>
        <translation>Das Programm wird mit diesen Einstellungen simuliert.</translation>
    </message>
    <message>
        <source>all %1 points</source>
        <translation>allen %1 Punkten</translation>
    </message>
    <message>
        <source>the %1 most difficult points</source>
        <translation>den %1 schwierigsten Punkten</translation>
    </message>
    <message>
        <source>Simulation of %1: wrong points in %2 of %3 runs.</source>
        <translation>Simulation mit %1: falsche Punkte in %2 von %3 Läufen.</translation>
    </message>
    <message numerus="yes">
        <source>Simulation of %1: no wrong point in %n runs.</source>
        <translation>
            <numerusform>Simulation mit %1: kein falscher Punkt in %n Lauf.</numerusform>
            <numerusform>Simulation mit %1: kein falscher Punkt in %n Läufen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RejectedModel</name>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Ausgestellt für</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Gültig</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
</context>
<context>
    <name>RightTexts</name>
    <message>
        <source>read variables</source>
        <translation>Variablen lesen</translation>
    </message>
    <message>
        <source>follows the run</source>
        <translation>verfolgt den Lauf</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with StateRead; if that is not enough, with SinuReadAll.</source>
        <translation>GiveUserAccess mit StateRead aufrufen; reicht das nicht, mit SinuReadAll.</translation>
    </message>
    <message>
        <source>write R-parameters</source>
        <translation>R-Parameter schreiben</translation>
    </message>
    <message>
        <source>sends the points</source>
        <translation>sendet die Punkte</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with StateWrite; if that is not enough, with SinuWriteAll. The protection level of R-parameters (MD51051) must allow it, too.</source>
        <translation>GiveUserAccess mit StateWrite aufrufen; reicht das nicht, mit SinuWriteAll. Auch die Schutzstufe der R-Parameter (MD51051) muss es erlauben.</translation>
    </message>
    <message>
        <source>read programs</source>
        <translation>Programme lesen</translation>
    </message>
    <message>
        <source>checks which program is on the control; without it the operator does</source>
        <translation>prüft, welches Programm auf der Steuerung ist; sonst tut es der Bediener</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with FsRead.</source>
        <translation>GiveUserAccess mit FsRead aufrufen.</translation>
    </message>
    <message>
        <source>write programs</source>
        <translation>Programme schreiben</translation>
    </message>
    <message>
        <source>brings its program to the control; without it the operator copies it</source>
        <translation>bringt sein Programm auf die Steuerung; sonst kopiert es der Bediener</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with FsWrite.</source>
        <translation>GiveUserAccess mit FsWrite aufrufen.</translation>
    </message>
    <message>
        <source>select a program</source>
        <translation>ein Programm anwählen</translation>
    </message>
    <message>
        <source>selects its program; without it the operator does</source>
        <translation>wählt sein Programm an; sonst tut es der Bediener</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with ApWrite.</source>
        <translation>GiveUserAccess mit ApWrite aufrufen.</translation>
    </message>
    <message>
        <source>Let this OPC UA user read the nodes of the map, in the settings of the server.</source>
        <translation>Diesem OPC-UA-Benutzer in den Einstellungen des Servers erlauben, die Knoten der Zuordnung zu lesen.</translation>
    </message>
    <message>
        <source>Let this OPC UA user write the cells of the map, in the settings of the server.</source>
        <translation>Diesem OPC-UA-Benutzer in den Einstellungen des Servers erlauben, die Zellen der Zuordnung zu schreiben.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.read), if the server has one, and let this OPC UA user call it.</source>
        <translation>Die Methode in der Zuordnung nennen (methods.read), wenn der Server eine hat, und diesem OPC-UA-Benutzer erlauben, sie aufzurufen.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.write), if the server has one, and let this OPC UA user call it.</source>
        <translation>Die Methode in der Zuordnung nennen (methods.write), wenn der Server eine hat, und diesem OPC-UA-Benutzer erlauben, sie aufzurufen.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.select), if the server has one, and let this OPC UA user call it.</source>
        <translation>Die Methode in der Zuordnung nennen (methods.select), wenn der Server eine hat, und diesem OPC-UA-Benutzer erlauben, sie aufzurufen.</translation>
    </message>
</context>
<context>
    <name>RunStateTexts</name>
    <message>
        <source>Idle</source>
        <translation>Ruhe</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Stoppt</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Vorbereitung</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fehlgeschlagen</translation>
    </message>
</context>
<context>
    <name>RunTexts</name>
    <message>
        <source>No program is loaded.</source>
        <translation>Kein Programm geladen.</translation>
    </message>
    <message>
        <source>The program has fewer than two points.</source>
        <translation>Das Programm hat weniger als zwei Punkte.</translation>
    </message>
    <message>
        <source>Running: %1, version %2</source>
        <translation>Läuft: %1, Fassung %2</translation>
    </message>
    <message>
        <source>Program: %1, version %2</source>
        <translation>Programm: %1, Fassung %2</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 an %2</translation>
    </message>
    <message>
        <source>program, %1 %</source>
        <translation>Programm, %1 %</translation>
    </message>
    <message>
        <source>Whole jobs need method window or credit.</source>
        <translation>Ganze Aufträge brauchen das Verfahren Fenster oder Kredit.</translation>
    </message>
    <message>
        <source>A whole job cannot be corrected online.</source>
        <translation>Ein ganzer Auftrag kann nicht online korrigiert werden.</translation>
    </message>
    <message>
        <source>Parts of the program are not known: see the findings.</source>
        <translation>Teile des Programms sind nicht bekannt: siehe Befunde.</translation>
    </message>
    <message>
        <source>%1 (line %2) cannot be given to the control.</source>
        <translation>%1 (Zeile %2) kann der Steuerung nicht übergeben werden.</translation>
    </message>
    <message>
        <source>%1 streamed, %2 pauses, %3 tool changes, %4 other blocks of the control, %5 changes between both; %6 in all</source>
        <translation>%1 gestreamt, %2 Pausen, %3 Werkzeugwechsel, %4 andere Sätze der Steuerung, %5 Wechsel zwischen beiden; insgesamt %6</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fehlgeschlagen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Stopped, not judged</source>
        <translation>Gestoppt, nicht beurteilt</translation>
    </message>
    <message>
        <source>Completed, not judged</source>
        <translation>Abgeschlossen, nicht beurteilt</translation>
    </message>
    <message>
        <source>Stopped, with wrong motion</source>
        <translation>Gestoppt, mit falscher Bewegung</translation>
    </message>
    <message>
        <source>Completed with wrong motion</source>
        <translation>Abgeschlossen mit falscher Bewegung</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Credit (experimental)</source>
        <translation>Kredit (experimentell)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Begin with a part</source>
        <translation>Mit einem Abschnitt beginnen</translation>
    </message>
    <message>
        <source>Part (1 to %1). What the machine needs there is listed before anything moves.</source>
        <translation>Abschnitt (1 bis %1). Was die Maschine dort braucht, wird aufgelistet, bevor sich etwas bewegt.</translation>
    </message>
    <message>
        <source>A live source needs no verdict: the machine waits for points that are late.</source>
        <translation>Eine Live-Quelle braucht kein Urteil: Die Maschine wartet auf Punkte, die spät kommen.</translation>
    </message>
    <message>
        <source>Live points from %1</source>
        <translation>Live-Punkte von %1</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Kein Werkzeug</translation>
    </message>
    <message>
        <source>Before the first tool change</source>
        <translation>Vor dem ersten Werkzeugwechsel</translation>
    </message>
    <message>
        <source>%1 in the spindle</source>
        <translation>%1 in der Spindel</translation>
    </message>
    <message>
        <source>%1 change</source>
        <translation>%1 Wechsel</translation>
    </message>
    <message>
        <source>%1 at %2 1/min</source>
        <translation>%1 mit %2 1/min</translation>
    </message>
    <message>
        <source>%1 coolant</source>
        <translation>%1 Kühlmittel</translation>
    </message>
    <message>
        <source>Straight way to the first point</source>
        <translation>Gerader Weg zum ersten Punkt</translation>
    </message>
    <message>
        <source>CLEAR</source>
        <extracomment>What the operator types; a translation may be any one word.</extracomment>
        <translation>FREI</translation>
    </message>
    <message>
        <source>The tool goes straight through the space in which the program cuts. Look whether anything is in its way: workpiece, clamps. If nothing is, type %1.</source>
        <translation>Das Werkzeug fährt gerade durch den Bereich, in dem das Programm schneidet. Sehen Sie nach, ob etwas im Weg ist: Werkstück, Spannmittel. Wenn nicht, geben Sie %1 ein.</translation>
    </message>
    <message>
        <source>Method that may repeat points</source>
        <translation>Verfahren, das Punkte wiederholen kann</translation>
    </message>
    <message>
        <source>this may execute old points again</source>
        <extracomment>What the operator types, word by word.</extracomment>
        <translation>das kann alte Punkte noch einmal ausführen</translation>
    </message>
    <message>
        <source>This method of the publication knows no numbered windows. If this computer is late, the control executes old points again. To start all the same, type:
%1</source>
        <translation>Dieses Verfahren der Veröffentlichung kennt keine nummerierten Fenster. Ist dieser Rechner zu spät, führt die Steuerung alte Punkte noch einmal aus. Um trotzdem zu starten, eintippen:
%1</translation>
    </message>
    <message>
        <source>The path is being measured.</source>
        <translation>Die Bahn wird vermessen.</translation>
    </message>
    <message>
        <source>Whole jobs have not been tested on this machine: Configure, Job test.</source>
        <translation>Ganze Aufträge sind auf dieser Maschine nicht getestet: Konfiguration, Auftrags-Test.</translation>
    </message>
</context>
<context>
    <name>RunsTexts</name>
    <message>
        <source>This is not the report of a run. Choose a file that this page or stream --json has written.</source>
        <translation>Das ist kein Bericht eines Laufs. Eine Datei wählen, die diese Seite oder stream --json geschrieben hat.</translation>
    </message>
    <message>
        <source>The report was written by a later version of Rivulet. Use that one to open it.</source>
        <translation>Der Bericht stammt von einer neueren Version von Rivulet. Mit dieser öffnen.</translation>
    </message>
    <message>
        <source>The report is damaged and cannot be shown.</source>
        <translation>Der Bericht ist beschädigt und kann nicht gezeigt werden.</translation>
    </message>
</context>
<context>
    <name>ServerModel</name>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Zertifikat</translation>
    </message>
    <message>
        <source>none accepted</source>
        <translation>keines angenommen</translation>
    </message>
    <message>
        <source>accepted, not kept</source>
        <translation>angenommen, nicht aufbewahrt</translation>
    </message>
    <message>
        <source>has ended</source>
        <translation>abgelaufen</translation>
    </message>
    <message numerus="yes">
        <source>valid for %Ln days</source>
        <translation>
            <numerusform>noch %Ln Tag gültig</numerusform>
            <numerusform>noch %Ln Tage gültig</numerusform>
        </translation>
    </message>
    <message>
        <source>Protection</source>
        <translation>Schutz</translation>
    </message>
    <message>
        <source>the strongest</source>
        <translation>der stärkste</translation>
    </message>
    <message>
        <source>allowed: %1</source>
        <translation>erlaubt: %1</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Fingerabdruck</translation>
    </message>
</context>
<context>
    <name>ServiceTexts</name>
    <message>
        <source>Connecting …</source>
        <translation>Verbindet …</translation>
    </message>
    <message>
        <source>No answer for some seconds</source>
        <translation>Seit einigen Sekunden keine Antwort</translation>
    </message>
    <message>
        <source>Service does not answer</source>
        <translation>Dienst antwortet nicht</translation>
    </message>
    <message>
        <source>Not connected: needs a decision</source>
        <translation>Nicht verbunden: Entscheidung nötig</translation>
    </message>
    <message>
        <source>Machine does not answer</source>
        <translation>Maschine antwortet nicht</translation>
    </message>
    <message>
        <source>Connecting to the machine …</source>
        <translation>Verbindung zur Maschine …</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Kein Programm</translation>
    </message>
    <message>
        <source>Program loaded</source>
        <translation>Programm geladen</translation>
    </message>
    <message>
        <source>Run interrupted</source>
        <translation>Lauf unterbrochen</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 von %2 Punkten</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, noch %2</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>Suche läuft …</translation>
    </message>
    <message>
        <source>No other services are known there.</source>
        <translation>Dort sind keine weiteren Dienste bekannt.</translation>
    </message>
    <message>
        <source>Only an engineer can do this.</source>
        <translation>Das kann nur ein Einrichter.</translation>
    </message>
    <message>
        <source>This service is on the board.</source>
        <translation>Dieser Dienst ist schon auf der Tafel.</translation>
    </message>
</context>
<context>
    <name>SetUpTexts</name>
    <message>
        <source>Connect first: limits belong to one machine.</source>
        <translation>Zuerst verbinden: Grenzen gehören zu einer Maschine.</translation>
    </message>
    <message>
        <source>Only an engineer can do this, and not during a run.</source>
        <translation>Das kann nur ein Einrichter, und nicht während eines Laufs.</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Credit test</source>
        <translation>Kredit-Test</translation>
    </message>
    <message>
        <source>Certificates</source>
        <translation>Zertifikate</translation>
    </message>
    <message>
        <source>Rights</source>
        <translation>Rechte</translation>
    </message>
    <message>
        <source>Stop test</source>
        <translation>Stopp-Test</translation>
    </message>
    <message>
        <source>Job test</source>
        <translation>Auftrags-Test</translation>
    </message>
</context>
<context>
    <name>SheetTexts</name>
    <message>
        <source>Report of a run</source>
        <translation>Bericht eines Laufs</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Pauses and access</source>
        <translation>Pausen und Zugriff</translation>
    </message>
    <message>
        <source>Path, seen from above; rapids dashed</source>
        <translation>Bahn von oben; Eilgänge gestrichelt</translation>
    </message>
    <message>
        <source>The path was not kept.</source>
        <translation>Die Bahn wurde nicht behalten.</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Datum, Name, Unterschrift</translation>
    </message>
    <message>
        <source>Rivulet %1; run made with version %2</source>
        <translation>Rivulet %1; Lauf mit Version %2</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Version (hash)</source>
        <translation>Fassung (Hash)</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Started by</source>
        <translation>Gestartet von</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>Laufnummer</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Zugriff</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ausgeführt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Neben dem Programm</translation>
    </message>
    <message>
        <source>Out of order</source>
        <translation>Falsche Reihenfolge</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausen</translation>
    </message>
    <message>
        <source>Pauses in all</source>
        <translation>Pausen zusammen</translation>
    </message>
    <message>
        <source>Share of the duration</source>
        <translation>Anteil an der Dauer</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>Access, median</source>
        <translation>Zugriff, Median</translation>
    </message>
    <message>
        <source>Access, 99th percentile</source>
        <translation>Zugriff, 99. Perzentil</translation>
    </message>
    <message>
        <source>Streamed</source>
        <translation>Gestreamt</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>Werkzeugwechsel</translation>
    </message>
    <message>
        <source>Other blocks of the control</source>
        <translation>Andere Sätze der Steuerung</translation>
    </message>
    <message>
        <source>Changes between both</source>
        <translation>Wechsel zwischen beiden</translation>
    </message>
    <message>
        <source>%1, dry run %2 higher</source>
        <translation>%1, Trockenlauf %2 höher</translation>
    </message>
    <message>
        <source>Live lines</source>
        <translation>Live-Zeilen</translation>
    </message>
    <message>
        <source>Delay from arrival to motion</source>
        <translation>Verzug von Ankunft bis Bewegung</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>In the spindle</source>
        <translation>In der Spindel</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Wechsel</translation>
    </message>
    <message>
        <source>Speed, 1/min</source>
        <translation>Drehzahl, 1/min</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Drehend</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Kühlmittel</translation>
    </message>
</context>
<context>
    <name>SignalTexts</name>
    <message>
        <source>Length along the program, actual</source>
        <translation>Länge entlang des Programms, Ist</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>Actual position</source>
        <translation>Istposition</translation>
    </message>
    <message>
        <source>Lag (set point minus actual)</source>
        <translation>Schleppabstand (Soll minus Ist)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Ruck</translation>
    </message>
    <message>
        <source>Contour error</source>
        <translation>Konturabweichung</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Requests to the control</source>
        <translation>Anfragen an die Steuerung</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Spalten der Datei</translation>
    </message>
    <message>
        <source>%1 set point</source>
        <comment>of an axis</comment>
        <translation>%1 Soll</translation>
    </message>
    <message>
        <source>%1 actual</source>
        <comment>of an axis</comment>
        <translation>%1 Ist</translation>
    </message>
    <message>
        <source>%1 lag</source>
        <comment>of an axis</comment>
        <translation>%1 Schleppabstand</translation>
    </message>
    <message>
        <source>%1 speed</source>
        <comment>of an axis</comment>
        <translation>%1 Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 acceleration</source>
        <comment>of an axis</comment>
        <translation>%1 Beschleunigung</translation>
    </message>
    <message>
        <source>%1 jerk</source>
        <comment>of an axis</comment>
        <translation>%1 Ruck</translation>
    </message>
    <message>
        <source>Path speed</source>
        <translation>Bahngeschwindigkeit</translation>
    </message>
    <message>
        <source>Path acceleration</source>
        <translation>Bahnbeschleunigung</translation>
    </message>
    <message>
        <source>Contour error, actual</source>
        <translation>Konturabweichung, Ist</translation>
    </message>
    <message>
        <source>Contour error, set point</source>
        <translation>Konturabweichung, Soll</translation>
    </message>
    <message>
        <source>Line on the control</source>
        <translation>Zeile der Steuerung</translation>
    </message>
    <message>
        <source>Line of the program</source>
        <translation>Zeile des Programms</translation>
    </message>
    <message>
        <source>Point of the program</source>
        <translation>Punkt des Programms</translation>
    </message>
    <message>
        <source>Programmed feed</source>
        <translation>Programmierter Vorschub</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Duration of writes</source>
        <translation>Dauer der Schreibzugriffe</translation>
    </message>
    <message>
        <source>Duration of reads</source>
        <translation>Dauer der Lesezugriffe</translation>
    </message>
    <message>
        <source>Length along the program</source>
        <translation>Weg entlang des Programms</translation>
    </message>
    <message>
        <source>Time since the first sample</source>
        <translation>Zeit seit dem ersten Abtastwert</translation>
    </message>
</context>
<context>
    <name>StopCauseTexts</name>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>Exact stop</source>
        <translation>Genauhalt</translation>
    </message>
    <message>
        <source>Dwell (G4)</source>
        <translation>Verweilzeit (G4)</translation>
    </message>
    <message>
        <source>Programmed stop (M0, M1)</source>
        <translation>Programmierter Halt (M0, M1)</translation>
    </message>
    <message>
        <source>Tool change or auxiliary function</source>
        <translation>Werkzeugwechsel oder Hilfsfunktion</translation>
    </message>
    <message>
        <source>Waiting for data of the client</source>
        <translation>Warten auf Daten des Clients</translation>
    </message>
    <message>
        <source>Preprocessor stop</source>
        <translation>Vorlaufstopp</translation>
    </message>
    <message>
        <source>Pause: override 0</source>
        <translation>Pause: Override 0</translation>
    </message>
</context>
<context>
    <name>StopTexts</name>
    <message>
        <source>That stop and pause act at once has not been tested on this control: see Stop test.</source>
        <translation>Dass Stopp und Pause sofort wirken, ist an dieser Steuerung nicht getestet: siehe Stopp-Test.</translation>
    </message>
    <message>
        <source>That stop and pause act at once was tested with another version of the server: test it again.</source>
        <translation>Dass Stopp und Pause sofort wirken, wurde mit einer anderen Version des Servers getestet: noch einmal testen.</translation>
    </message>
    <message>
        <source>This control has failed the test that stop and pause act at once.</source>
        <translation>Diese Steuerung hat den Test, ob Stopp und Pause sofort wirken, nicht bestanden.</translation>
    </message>
    <message>
        <source>That stop and pause act at once was tested without motion only: see Stop test.</source>
        <translation>Dass Stopp und Pause sofort wirken, wurde nur ohne Bewegung getestet: siehe Stopp-Test.</translation>
    </message>
</context>
<context>
    <name>TemplateSheetTexts</name>
    <message>
        <source>Bring %1 to the control</source>
        <translation>%1 auf die Steuerung bringen</translation>
    </message>
    <message>
        <source>Layout number %1: with another one Rivulet moves nothing</source>
        <translation>Layoutnummer %1: Mit einer anderen bewegt Rivulet nichts</translation>
    </message>
    <message>
        <source>This program runs on the control and moves the axes to the points that Rivulet sends in R-parameters. It is valid for the settings on this page only; with others it has another layout number.</source>
        <translation>Dieses Programm läuft auf der Steuerung und fährt die Achsen zu den Punkten, die Rivulet in R-Parametern sendet. Es gilt nur für die Einstellungen auf diesem Blatt; mit anderen hat es eine andere Layoutnummer.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>File on the control</source>
        <translation>Datei auf der Steuerung</translation>
    </message>
    <message>
        <source>Layout number</source>
        <translation>Layoutnummer</translation>
    </message>
    <message>
        <source>%1 in R%2</source>
        <translation>%1 in R%2</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Points, axes</source>
        <translation>Punkte, Achsen</translation>
    </message>
    <message>
        <source>Make sure that no other program, cycle or client uses R%1 to R%2.</source>
        <translation>Sicherstellen, dass kein anderes Programm, kein Zyklus und kein anderer Client R%1 bis R%2 benutzt.</translation>
    </message>
    <message>
        <source>Copy the file to the part programs of the control, by network or USB stick, as %1. Change nothing in it: Rivulet relies on every line.</source>
        <translation>Die Datei über Netz oder USB-Stick als %1 in die Teileprogramme der Steuerung kopieren. Nichts darin ändern: Rivulet verlässt sich auf jede Zeile.</translation>
    </message>
    <message>
        <source>Copy the file to the folder of the NC programs of the control as %1. Change nothing in it: Rivulet relies on every line.</source>
        <translation>Die Datei als %1 in den Ordner der NC-Programme der Steuerung kopieren. Nichts darin ändern: Rivulet verlässt sich auf jede Zeile.</translation>
    </message>
    <message numerus="yes">
        <source>In Rivulet, column Settings, tick “copied by hand” at Template. Look through what Start shows, then hold Start. From then on Rivulet waits up to %n minutes.</source>
        <translation>
            <numerusform>In Rivulet in der Spalte Einstellungen bei Vorlage „von Hand übertragen“ ankreuzen. Durchsehen, was Start zeigt, dann Start halten. Von da an wartet Rivulet bis zu %n Minute.</numerusform>
            <numerusform>In Rivulet in der Spalte Einstellungen bei Vorlage „von Hand übertragen“ ankreuzen. Durchsehen, was Start zeigt, dann Start halten. Von da an wartet Rivulet bis zu %n Minuten.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the control: select the program in channel 1, close the doors, set the feed override, press cycle start. No axis moves yet.</source>
        <translation>An der Steuerung: das Programm in Kanal 1 anwählen, Türen schließen, Vorschub-Override einstellen, NC-Start drücken. Noch bewegt sich keine Achse.</translation>
    </message>
    <message>
        <source>The program writes its layout number and waits. Only when Rivulet has read the right number, it sends points and the axes move.</source>
        <translation>Das Programm schreibt seine Layoutnummer und wartet. Erst wenn Rivulet die richtige Nummer gelesen hat, sendet es Punkte, und die Achsen fahren.</translation>
    </message>
    <message>
        <source>The control shows this program as running from cycle start until its end, also while the axes stand and it waits for points.</source>
        <translation>Die Steuerung zeigt dieses Programm von NC-Start bis zu seinem Ende als laufend an, auch solange die Achsen stehen und es auf Punkte wartet.</translation>
    </message>
    <message>
        <source>Feed override, feed hold, reset and emergency stop of the machine act as in any other program. Stop and Pause in Rivulet do not replace them.</source>
        <translation>Vorschub-Override, Vorschub-Halt, Reset und Not-Halt der Maschine wirken wie in jedem anderen Programm. Stopp und Pause in Rivulet ersetzen sie nicht.</translation>
    </message>
    <message>
        <source>If Rivulet, its computer or the network fails, nothing new is sent: with numbered windows the axes stand; with methods position and signal they may go to old points again.</source>
        <translation>Fällt Rivulet, sein Rechner oder das Netz aus, wird nichts Neues gesendet: Mit nummerierten Fenstern stehen die Achsen; mit den Verfahren Position und Signal fahren sie womöglich noch einmal zu alten Punkten.</translation>
    </message>
    <message>
        <source>End the run in Rivulet. If the program still runs: press reset at the control.</source>
        <translation>Den Lauf in Rivulet beenden. Läuft das Programm noch: an der Steuerung Reset drücken.</translation>
    </message>
    <message>
        <source>Select another program, then delete the file from the part programs of the control.</source>
        <translation>Ein anderes Programm anwählen, dann die Datei aus den Teileprogrammen der Steuerung löschen.</translation>
    </message>
    <message>
        <source>The R-parameters keep their last values. Set to 0 those that other programs read.</source>
        <translation>Die R-Parameter behalten ihre letzten Werte. Auf 0 setzen, was andere Programme lesen.</translation>
    </message>
    <message>
        <source>Take back the rights that were given for it; on a SINUMERIK with DeleteUserAccess. Remove the certificate of this computer from those that the control trusts if Rivulet is not to connect again.</source>
        <translation>Die dafür gegebenen Rechte zurücknehmen, bei einer SINUMERIK mit DeleteUserAccess. Das Zertifikat dieses Rechners aus denen entfernen, denen die Steuerung vertraut, wenn Rivulet sich nicht mehr verbinden soll.</translation>
    </message>
    <message>
        <source>Rights of the OPC UA user</source>
        <translation>Rechte des OPC-UA-Benutzers</translation>
    </message>
    <message>
        <source>(Not needed for these steps.)</source>
        <translation>(Für diese Schritte nicht nötig.)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>What the operator sees</source>
        <translation>Was der Bediener sieht</translation>
    </message>
    <message>
        <source>Taking it back</source>
        <translation>Alles zurücknehmen</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Datum, Name, Unterschrift</translation>
    </message>
</context>
<context>
    <name>TraceRemarks</name>
    <message>
        <source>The program does not belong to this trace from %1 s on.</source>
        <translation>Ab %1 s gehört das Programm nicht zu dieser Aufzeichnung.</translation>
    </message>
    <message>
        <source>The trace of the control is incomplete: its memory was full.</source>
        <translation>Der Mitschrieb der Steuerung ist unvollständig: Ihr Speicher war voll.</translation>
    </message>
    <message>
        <source>Lines of the recording that cannot be read and were left out: %1.</source>
        <translation>Zeilen der Aufzeichnung, die nicht lesbar sind und weggelassen wurden: %1.</translation>
    </message>
    <message>
        <source>The recording ends before its run: what came before is shown.</source>
        <translation>Die Aufzeichnung endet vor ihrem Lauf: Gezeigt wird, was davor kam.</translation>
    </message>
    <message>
        <source>The columns mean what was said for this layout before: %1.</source>
        <translation>Die Spalten bedeuten, was für diesen Aufbau früher angegeben wurde: %1.</translation>
    </message>
    <message>
        <source>The file does not say the units of its speeds: mm/min is assumed, as the control shows them.</source>
        <translation>Die Datei nennt keine Einheiten der Geschwindigkeiten: mm/min wird angenommen, wie die Steuerung sie anzeigt.</translation>
    </message>
    <message>
        <source>The compressed file is cut or damaged: what came before was read.</source>
        <translation>Die komprimierte Datei ist abgeschnitten oder beschädigt: Was davor kam, wurde gelesen.</translation>
    </message>
    <message>
        <source>The file was cut off: its end is missing.</source>
        <translation>Die Datei wurde abgeschnitten: Ihr Ende fehlt.</translation>
    </message>
    <message>
        <source>The file ends within a row: it was cut off there.</source>
        <translation>Die Datei endet mitten in einer Zeile: Dort wurde sie abgeschnitten.</translation>
    </message>
    <message>
        <source>Cells that are no numbers and were left empty: %1, the first in line %2.</source>
        <translation>Zellen, die keine Zahlen sind, leer gelassen: %1, die erste in Zeile %2.</translation>
    </message>
    <message>
        <source>Rows that do not have %1 columns and were left out: %2, the first in line %3.</source>
        <translation>Zeilen ohne %1 Spalten, weggelassen: %2, die erste in Zeile %3.</translation>
    </message>
    <message>
        <source>The file has %1 columns of time; each belongs to the columns after it.</source>
        <translation>Die Datei hat %1 Zeitspalten; jede gehört zu den Spalten nach ihr.</translation>
    </message>
    <message>
        <source>Values whose time runs backwards and that were left out: %1.</source>
        <translation>Werte, deren Zeit rückwärts läuft, weggelassen: %1.</translation>
    </message>
    <message>
        <source>Rows that repeat the time of the row before and were left out: %1.</source>
        <translation>Zeilen mit derselben Zeit wie die Zeile davor, weggelassen: %1.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; runs backwards at row %2. Rows that were left out until it goes on: %3.</source>
        <translation>Die Zeit „%1“ läuft in Zeile %2 rückwärts. Zeilen, die weggelassen wurden, bis sie weiterläuft: %3.</translation>
    </message>
    <message>
        <source>The file has no column of time: %1 Hz is assumed.</source>
        <translation>Die Datei hat keine Zeitspalte: %1 Hz werden angenommen.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; has no unit: %2 is assumed.</source>
        <translation>Die Zeit „%1“ hat keine Einheit: %2 wird angenommen.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; occurs more than once: this one is called &quot;%2&quot;.</source>
        <translation>Die Spalte „%1“ kommt mehrmals vor: Diese heißt „%2“.</translation>
    </message>
    <message>
        <source>Datasets that are no row of numbers and were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Datensätze, die keine Reihe von Zahlen sind und weggelassen wurden: %1, der erste „%2“.</translation>
    </message>
    <message>
        <source>Datasets that are damaged and were read in part or not at all: %1, the first &quot;%2&quot;.</source>
        <translation>Datensätze, die beschädigt sind und nur teilweise oder gar nicht gelesen wurden: %1, der erste „%2“.</translation>
    </message>
    <message>
        <source>Datasets to whose length no time belongs and that were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Datensätze, zu deren Länge keine Zeit gehört und die weggelassen wurden: %1, der erste „%2“.</translation>
    </message>
    <message>
        <source>The rows are not in the order of their time &quot;%1&quot;, the first at row %2: they were sorted.</source>
        <translation>Die Zeilen stehen nicht in der Reihenfolge ihrer Zeit „%1“, zuerst in Zeile %2: Sie wurden sortiert.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; starts again, the first time at row %2. %3 sections are shown %4 s apart, and the longest one is analysed.</source>
        <translation>Die Zeit „%1“ beginnt von neuem, zuerst in Zeile %2. %3 Abschnitte werden mit %4 s Abstand gezeigt, der längste wird ausgewertet.</translation>
    </message>
    <message>
        <source>The signals stand in rows of their own: straight lines are assumed between the values of each.</source>
        <translation>Jedes Signal steht in eigenen Zeilen: Zwischen seinen Werten werden Geraden angenommen.</translation>
    </message>
    <message>
        <source>Rows of text that hold no values and were left out: %1, the first in line %2.</source>
        <translation>Zeilen aus Text, ohne Werte, weggelassen: %1, die erste ist Zeile %2.</translation>
    </message>
    <message>
        <source>No date tells what comes first in it: day/month is assumed.</source>
        <translation>Kein Datum zeigt, was darin zuerst steht: Tag/Monat wird angenommen.</translation>
    </message>
    <message>
        <source>An MTConnect agent reports a value when it changes: in gaps the last value is held; otherwise straight lines are assumed between values.</source>
        <translation>Ein MTConnect-Agent meldet einen Wert, wenn er sich ändert: In Lücken gilt der letzte Wert weiter; sonst werden zwischen den Werten gerade Linien angenommen.</translation>
    </message>
    <message>
        <source>All positions are known from %1 s on: what comes before is not analysed.</source>
        <translation>Alle Positionen sind ab %1 s bekannt: Was davor liegt, wird nicht ausgewertet.</translation>
    </message>
    <message>
        <source>Values with the time of a later value of the same item, which counts instead: %1.</source>
        <translation>Werte mit der Zeit eines späteren Werts desselben Datenpunkts, der stattdessen gilt: %1.</translation>
    </message>
    <message>
        <source>Observations that are tables or sets of values and were left out: %1, the first of &quot;%2&quot;.</source>
        <translation>Beobachtungen, die Tabellen oder Mengen von Werten sind und ausgelassen wurden: %1, die erste von „%2“.</translation>
    </message>
    <message>
        <source>Series of values without a sample rate that were left out, because their times are not known: %1, the first of &quot;%2&quot;.</source>
        <translation>Wertereihen ohne Abtastrate, die ausgelassen wurden, weil ihre Zeiten nicht bekannt sind: %1, die erste von „%2“.</translation>
    </message>
    <message>
        <source>Observations without a time or a number that can be read and that were left out: %1, the first of &quot;%2&quot;.</source>
        <translation>Beobachtungen ohne lesbare Zeit oder Zahl, die ausgelassen wurden: %1, die erste von „%2“.</translation>
    </message>
    <message>
        <source>Items without any value that were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Datenpunkte ganz ohne Werte, die ausgelassen wurden: %1, der erste „%2“.</translation>
    </message>
    <message>
        <source>Items that mean the same as another one, which is analysed instead: %1.</source>
        <translation>Datenpunkte, die dasselbe bedeuten wie ein anderer, der stattdessen ausgewertet wird: %1.</translation>
    </message>
    <message>
        <source>The unit &quot;%2&quot; of the item &quot;%1&quot; is not known: the item is not analysed.</source>
        <translation>Die Einheit „%2“ des Datenpunkts „%1“ ist nicht bekannt: Er wird nicht ausgewertet.</translation>
    </message>
    <message>
        <source>States and messages of the machine that are too many and were left out: %1.</source>
        <translation>Zustände und Meldungen der Maschine, die zu viele sind und ausgelassen wurden: %1.</translation>
    </message>
    <message>
        <source>The MTConnect agent refused a part: %1.</source>
        <translation>Der MTConnect-Agent hat einen Teil abgelehnt: %1.</translation>
    </message>
    <message>
        <source>Observations between two answers that the MTConnect agent no longer had: %1. The motion is not known there.</source>
        <translation>Beobachtungen zwischen zwei Antworten, die der MTConnect-Agent nicht mehr hatte: %1. Die Bewegung ist dort nicht bekannt.</translation>
    </message>
    <message>
        <source>The MTConnect agent was started again between two answers: what it had kept until then may be incomplete.</source>
        <translation>Der MTConnect-Agent wurde zwischen zwei Antworten neu gestartet: Was er bis dahin behalten hatte, kann unvollständig sein.</translation>
    </message>
</context>
<context>
    <name>TraceTexts</name>
    <message>
        <source>Report of a run</source>
        <translation>Bericht eines Laufs</translation>
    </message>
    <message>
        <source>Report on a motion</source>
        <translation>Bericht über eine Bewegung</translation>
    </message>
    <message>
        <source>Every point executed once, in order</source>
        <translation>Jeder Punkt einmal und in der richtigen Reihenfolge ausgeführt</translation>
    </message>
    <message>
        <source>The motion is not that of the program</source>
        <translation>Die Bewegung ist nicht die des Programms</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Nicht beurteilt</translation>
    </message>
    <message>
        <source>Whether each point was executed is not known: the program or a part of the trace is missing.</source>
        <translation>Ob jeder Punkt ausgeführt wurde, ist nicht bekannt: Das Programm oder ein Teil der Messung fehlt.</translation>
    </message>
    <message>
        <source>The recording was cut off before the end of the run. What it holds is judged here.</source>
        <translation>Die Aufzeichnung bricht vor dem Ende des Laufs ab. Beurteilt ist, was sie enthält.</translation>
    </message>
    <message>
        <source>The motion leaves the program for good before line %1, at X %2 Y %3 Z %4.</source>
        <translation>Die Bewegung verlässt das Programm endgültig vor Zeile %1, bei X %2 Y %3 Z %4.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Client and control</source>
        <translation>Client und Steuerung</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Datum, Name, Unterschrift</translation>
    </message>
    <message>
        <source>File %1, SHA-256 %2</source>
        <translation>Datei %1, SHA-256 %2</translation>
    </message>
    <message>
        <source>Rivulet %1</source>
        <translation>Rivulet %1</translation>
    </message>
    <message>
        <source>Rivulet %1; run made with version %2</source>
        <translation>Rivulet %1; Lauf mit Version %2</translation>
    </message>
    <message>
        <source>Program grey, motion blue</source>
        <translation>Programm grau, Bewegung blau</translation>
    </message>
    <message>
        <source>The trace holds no motion.</source>
        <translation>Die Messung enthält keine Bewegung.</translation>
    </message>
    <message>
        <source>Path speed; stops are orange</source>
        <translation>Bahngeschwindigkeit; Stillstände sind orange</translation>
    </message>
    <message>
        <source>Duration of requests: median blue, longest orange</source>
        <translation>Dauer der Anfragen: Median blau, längste orange</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>mm/min</source>
        <translation>mm/min</translation>
    </message>
    <message>
        <source>The longest of %1 stops</source>
        <translation>Die längsten von %1 Stillständen</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Bei</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Place, mm</source>
        <translation>Ort, mm</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>What limited the run: the client. The machine waited %1 times for its data, %2 in all.</source>
        <translation>Was den Lauf begrenzte: der Client. Die Maschine wartete %1-mal auf seine Daten, insgesamt %2.</translation>
    </message>
    <message>
        <source>What limited the run: the access time. At %1 the client is slower than the machine; up to %2 it keeps up.</source>
        <translation>Was den Lauf begrenzte: die Zugriffszeit. Bei %1 ist der Client langsamer als die Maschine; bis %2 kommt er mit.</translation>
    </message>
    <message>
        <source>What limited the run: the stops between loops or windows, %1 in all.</source>
        <translation>Was den Lauf begrenzte: die Stillstände zwischen Schleifen oder Fenstern, insgesamt %1.</translation>
    </message>
    <message>
        <source>What limited the run: the machine, by braking and accelerating, not the client.</source>
        <translation>Was den Lauf begrenzte: die Maschine durch Bremsen und Beschleunigen, nicht der Client.</translation>
    </message>
    <message>
        <source>With N = %1, feeds up to %2 would have been possible.</source>
        <translation>Mit N = %1 wären Vorschübe bis %2 möglich gewesen.</translation>
    </message>
    <message>
        <source>With arrays that cost as much as one variable, feeds up to %1 would have been possible.</source>
        <translation>Mit Feldern, die so viel kosten wie eine Variable, wären Vorschübe bis %1 möglich gewesen.</translation>
    </message>
    <message>
        <source>Without another change, %1 is the largest feed at which the machine does not wait.</source>
        <translation>Ohne andere Änderung ist %1 der größte Vorschub, bei dem die Maschine nicht wartet.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Art der Datei</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Time between two samples</source>
        <translation>Zeit zwischen zwei Messwerten</translation>
    </message>
    <message>
        <source>Version (hash)</source>
        <translation>Fassung (Hash)</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Started by</source>
        <translation>Gestartet von</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>Laufnummer</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Layout</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ausgeführt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Neben dem Programm</translation>
    </message>
    <message>
        <source>Out of order</source>
        <translation>Falsche Reihenfolge</translation>
    </message>
    <message>
        <source>Not decided by the samples</source>
        <translation>Durch die Messung nicht entschieden</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1 in Zeile %2</translation>
    </message>
    <message>
        <source>Contour error, set point</source>
        <translation>Konturfehler, Sollwert</translation>
    </message>
    <message>
        <source>Contour error, actual</source>
        <translation>Konturfehler, Istwert</translation>
    </message>
    <message>
        <source>Following error XYZ</source>
        <translation>Schleppfehler XYZ</translation>
    </message>
    <message>
        <source>Reversal error XYZ</source>
        <translation>Umkehrfehler XYZ</translation>
    </message>
    <message>
        <source>Strongest vibration</source>
        <translation>Stärkste Schwingung</translation>
    </message>
    <message>
        <source>Programmed feed kept</source>
        <translation>Programmierten Vorschub gehalten</translation>
    </message>
    <message>
        <source>At the programmed feed</source>
        <translation>Mit programmiertem Vorschub</translation>
    </message>
    <message>
        <source>Lost by moving slower</source>
        <translation>Verloren durch langsamere Fahrt</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>Machine waited for the client</source>
        <translation>Maschine wartete auf den Client</translation>
    </message>
    <message>
        <source>%1 times, %2</source>
        <translation>%1-mal, %2</translation>
    </message>
    <message>
        <source>Largest feed without waiting</source>
        <translation>Größter Vorschub ohne Warten</translation>
    </message>
    <message>
        <source>Median, 99 %, longest</source>
        <translation>Median, 99&#xa0;%, längste</translation>
    </message>
    <message>
        <source>Requests made again</source>
        <translation>Wiederholte Anfragen</translation>
    </message>
    <message>
        <source>Margin; of the slowest 1 %</source>
        <translation>Reserve; der langsamsten 1&#xa0;%</translation>
    </message>
    <message>
        <source>Path speed up to %1 mm/min; stops are orange</source>
        <translation>Bahngeschwindigkeit bis %1 mm/min; Stillstände sind orange</translation>
    </message>
</context>
<context>
    <name>TracesPage</name>
    <message>
        <source>The file of the pane layouts is damaged. What can be read of it is used, and the file is kept as %1.</source>
        <translation>Die Datei der Fensteranordnungen ist beschädigt. Was davon lesbar ist, wird verwendet, und die Datei bleibt erhalten als %1.</translation>
    </message>
    <message>
        <source>A run is in progress. Open files after it has ended.</source>
        <translation>Ein Lauf ist im Gang. Dateien nach seinem Ende öffnen.</translation>
    </message>
</context>
<context>
    <name>TrendWords</name>
    <message>
        <source>Trend of the runs</source>
        <translation>Trend der Läufe</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>Tage</translation>
    </message>
    <message>
        <source>Access, ms</source>
        <translation>Zugriff, ms</translation>
    </message>
    <message>
        <source>Paused, s</source>
        <translation>Pausen, s</translation>
    </message>
    <message>
        <source>per run</source>
        <translation>je Lauf</translation>
    </message>
    <message>
        <source>per day</source>
        <translation>je Tag</translation>
    </message>
    <message>
        <source>Access time per run</source>
        <translation>Zugriffszeit je Lauf</translation>
    </message>
    <message>
        <source>Mean access time, ms</source>
        <translation>Mittlere Zugriffszeit, ms</translation>
    </message>
    <message>
        <source>Pauses per run</source>
        <translation>Pausen je Lauf</translation>
    </message>
    <message>
        <source>Time in pauses, s</source>
        <translation>Zeit in Pausen, s</translation>
    </message>
    <message>
        <source>Run of the machine</source>
        <translation>Lauf der Maschine</translation>
    </message>
    <message>
        <source>Days since %1</source>
        <comment>a date</comment>
        <translation>Tage seit %1</translation>
    </message>
    <message>
        <source>%1, trend</source>
        <comment>of a machine</comment>
        <translation>%1, Trend</translation>
    </message>
</context>
<context>
    <name>TrustTexts</name>
    <message>
        <source>Only an engineer can do this.</source>
        <translation>Das kann nur ein Einrichter.</translation>
    </message>
    <message>
        <source>Connect first.</source>
        <translation>Zuerst verbinden.</translation>
    </message>
    <message>
        <source>During a run there is no time for it.</source>
        <translation>Während eines Laufs ist dafür keine Zeit.</translation>
    </message>
</context>
<context>
    <name>UserTexts</name>
    <message>
        <source>At least one user must be an engineer.</source>
        <translation>Mindestens ein Benutzer muss Einrichter sein.</translation>
    </message>
    <message>
        <source>The file of users is damaged. Restore it, or delete it to set the users up again.</source>
        <translation>Die Benutzerdatei ist beschädigt. Sie wiederherstellen oder löschen und die Benutzer neu einrichten.</translation>
    </message>
    <message>
        <source>Give a name.</source>
        <translation>Einen Namen angeben.</translation>
    </message>
    <message>
        <source>The PIN needs at least 4 characters.</source>
        <translation>Die PIN braucht mindestens 4 Zeichen.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Alarms</name>
    <message>
        <source>%1: %2 damaged lines of the history of alarms were left out.</source>
        <translation>%1: %2 beschädigte Zeilen des Alarmverlaufs wurden ausgelassen.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Certificates</name>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Demo</name>
    <message>
        <source>The picture or the report cannot be written to %1.</source>
        <translation>Bild oder Bericht können nicht nach %1 geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Document</name>
    <message>
        <source>Line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>A dry run needs the whole job, but only the motion of this program would be streamed. Choose Whole job.</source>
        <translation>Ein Trockenlauf braucht den ganzen Auftrag, gestreamt würde aber nur die Bewegung dieses Programms. Ganzer Auftrag wählen.</translation>
    </message>
    <message>
        <source>A dry run needs the whole job: choose method window or credit, and no online correction.</source>
        <translation>Ein Trockenlauf braucht den ganzen Auftrag: Verfahren Fenster oder Kredit ohne Online-Korrektur wählen.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::FoundRuns</name>
    <message>
        <source>The run that was watched has ended.</source>
        <translation>Der beobachtete Lauf ist beendet.</translation>
    </message>
    <message>
        <source>There is a run on the control: %1</source>
        <translation>Auf der Steuerung ist ein Lauf: %1</translation>
    </message>
    <message>
        <source>The run has been stopped; confirmed after %1.</source>
        <translation>Der Lauf ist gestoppt; bestätigt nach %1.</translation>
    </message>
    <message>
        <source>Stop of the run on the control requested.</source>
        <translation>Stopp des Laufs auf der Steuerung angefordert.</translation>
    </message>
    <message>
        <source>The file of the program, %1, cannot be found. Open the program, then try again.</source>
        <translation>Die Datei des Programms, %1, ist nicht zu finden. Programm öffnen, dann noch einmal versuchen.</translation>
    </message>
    <message>
        <source>This run was a whole job, and its program cannot be run as one here now. The command rivulet-cli job --resume goes on with it.</source>
        <translation>Dieser Lauf war ein ganzer Auftrag, und sein Programm kann hier jetzt nicht als solcher laufen. Der Befehl rivulet-cli job --resume setzt ihn fort.</translation>
    </message>
    <message>
        <source>The axes of the run on the control are held; they stood after %1.</source>
        <translation>Die Achsen des Laufs auf der Steuerung werden gehalten; sie standen nach %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::LiveSource</name>
    <message>
        <source>A run is in progress. Open a live source after it has ended.</source>
        <translation>Ein Lauf ist im Gang. Eine Live-Quelle nach seinem Ende öffnen.</translation>
    </message>
    <message>
        <source>Listening for live points on %1.</source>
        <translation>Live-Punkte werden an %1 erwartet.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MachineModel</name>
    <message>
        <source>Connected to the virtual machine at %1.</source>
        <translation>Verbunden mit der virtuellen Maschine an %1.</translation>
    </message>
    <message>
        <source>Connected to the control at %1.</source>
        <translation>Verbunden mit der Steuerung an %1.</translation>
    </message>
    <message>
        <source>Calibrated. Saved %1.</source>
        <translation>Kalibriert. %1 gespeichert.</translation>
    </message>
    <message>
        <source>The calibration belongs to another version of the server and is not used.</source>
        <translation>Die Kalibrierung gehört zu einer anderen Version des Servers und wird nicht verwendet.</translation>
    </message>
    <message>
        <source>The map %1 does not name: %2. What needs it does not work.</source>
        <translation>Die Zuordnung %1 nennt nicht: %2. Was das braucht, geht nicht.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MachineProfiles</name>
    <message>
        <source>The limits of %1 have been saved.</source>
        <translation>Die Grenzen von %1 wurden gespeichert.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MainWindow</name>
    <message>
        <source>About Rivulet</source>
        <translation>Über Rivulet</translation>
    </message>
    <message>
        <source>Rivulet %1
Streams a tool path to a CNC machine over OPC UA while the machine moves.

Stop ends the program at the end of its loop. It is not an emergency stop.

GPL-3.0-or-later</source>
        <translation>Rivulet %1
Streamt die Bahn einer CNC-Maschine über OPC UA, während die Maschine fährt.

Stopp beendet das Programm am Ende seiner Schleife. Das ist kein Not-Halt.

GPL-3.0-or-later</translation>
    </message>
    <message>
        <source>%1 – Rivulet</source>
        <translation>%1 – Rivulet</translation>
    </message>
    <message>
        <source>Rivulet</source>
        <translation>Rivulet</translation>
    </message>
    <message>
        <source>&amp;Open program …</source>
        <translation>Programm &amp;öffnen …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;About Rivulet</source>
        <translation>&amp;Über Rivulet</translation>
    </message>
    <message>
        <source>Method, feed and verdict</source>
        <translation>Verfahren, Vorschub und Urteil</translation>
    </message>
    <message>
        <source>&amp;Menu</source>
        <translation>&amp;Menü</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Li&amp;ve points …</source>
        <translation>&amp;Live-Punkte …</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Arbeiten</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Auswerten</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>Einrichten</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>&amp;Einstellungen</translation>
    </message>
    <message>
        <source>La&amp;rge view</source>
        <translation>G&amp;roße Ansicht</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::PastRuns</name>
    <message>
        <source>A run is in progress: the Traces page shows it until it has ended.</source>
        <translation>Ein Lauf ist im Gang: Die Seite Aufzeichnungen zeigt ihn, bis er beendet ist.</translation>
    </message>
    <message>
        <source>A run is in progress. Open another program after it has ended.</source>
        <translation>Ein Lauf ist im Gang. Ein anderes Programm erst öffnen, wenn er beendet ist.</translation>
    </message>
    <message>
        <source>The settings of the run have been taken over. Where its program was is not known: open the program with version %1.</source>
        <translation>Die Werte des Laufs sind eingestellt. Wo sein Programm lag, ist nicht bekannt: das Programm in der Fassung %1 öffnen.</translation>
    </message>
    <message>
        <source>%1 is not the program of that run: version %2 then, %3 now. Its settings are set. Check the path before you start.</source>
        <translation>%1 ist nicht das Programm dieses Laufs: Fassung %2 damals, %3 jetzt. Die Werte sind eingestellt. Vor dem Start die Bahn prüfen.</translation>
    </message>
    <message>
        <source>Program and settings are those of the run of %1. Nothing has started.</source>
        <translation>Programm und Werte sind die des Laufs vom %1. Nichts ist gestartet.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::PipelineRun</name>
    <message>
        <source>The program rivulet-cnc is missing. Install it beside this window.</source>
        <translation>Das Programm rivulet-cnc fehlt. Es neben diesem Fenster installieren.</translation>
    </message>
    <message>
        <source>The tasks have ended without a message. Execute the program again.</source>
        <translation>Die Aufgaben haben ohne Meldung geendet. Das Programm erneut ausführen.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Preflight</name>
    <message>
        <source>In the way</source>
        <translation>Hindernis</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>%1 has changed on disk since version %2 was read.</source>
        <translation>%1 wurde auf dem Datenträger geändert, seit Fassung %2 eingelesen wurde.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>%1: a virtual machine, no real axis moves</source>
        <translation>%1: eine virtuelle Maschine, keine echte Achse bewegt sich</translation>
    </message>
    <message>
        <source>%1: the axes of this machine will move</source>
        <translation>%1: die Achsen dieser Maschine werden sich bewegen</translation>
    </message>
    <message>
        <source>First move</source>
        <translation>Erste Bewegung</translation>
    </message>
    <message>
        <source>The position of the tool is not known.</source>
        <translation>Die Position des Werkzeugs ist nicht bekannt.</translation>
    </message>
    <message>
        <source>From %1 in a straight line over %2 to point 1 at %3</source>
        <translation>Von %1 geradlinig über %2 zu Punkt 1 bei %3</translation>
    </message>
    <message>
        <source>The last run was left at %1 of %2 points. This start does not go on there: it moves from where the tool stands, perhaps in the cut, to the first point.</source>
        <translation>Der letzte Lauf endete bei %1 von %2 Punkten. Dieser Start macht dort nicht weiter: Er fährt von der Stelle, an der das Werkzeug steht, vielleicht im Schnitt, zum ersten Punkt.</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>%1 for every block, set here</source>
        <translation>%1 für jeden Satz, hier eingestellt</translation>
    </message>
    <message>
        <source>%1. The program names no feed.</source>
        <translation>%1. Das Programm nennt keinen Vorschub.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1. The program&apos;s own feed, %2, is not used.</source>
        <translation>%1. Der Vorschub des Programms, %2, wird nicht verwendet.</translation>
    </message>
    <message>
        <source>Some blocks will be cut %1 times as fast as programmed.</source>
        <translation>Manche Sätze werden %1-mal so schnell gefahren wie programmiert.</translation>
    </message>
    <message>
        <source>Use F = %1</source>
        <translation>F = %1 verwenden</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>There is no verdict.</source>
        <translation>Es gibt kein Urteil.</translation>
    </message>
    <message>
        <source>Safe, but the machine will wait for points. Largest feed without waiting: %1.</source>
        <translation>Sicher, aber die Maschine wird auf Punkte warten. Größter Vorschub ohne Warten: %1.</translation>
    </message>
    <message>
        <source>Margin %1 ×, largest feed %2</source>
        <translation>Reserve %1 ×, größter Vorschub %2</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Zugriff</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Freigabe</translation>
    </message>
    <message>
        <source>Released by %1 on %2, who starts: %3</source>
        <translation>Freigegeben von %1 am %2, es startet: %3</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>This program with these settings and this calibration is not released.</source>
        <translation>Dieses Programm ist mit diesen Einstellungen und dieser Kalibrierung nicht freigegeben.</translation>
    </message>
    <message>
        <source>point %1 of %2 at %3</source>
        <translation>Punkt %1 von %2 bei %3</translation>
    </message>
    <message>
        <source>From point %1 on, the program differs from that of the interrupted run.</source>
        <translation>Ab Punkt %1 unterscheidet sich das Programm von dem des unterbrochenen Laufs.</translation>
    </message>
    <message>
        <source>Who starts</source>
        <translation>Wer startet</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 auf %2</translation>
    </message>
    <message>
        <source>The feeds of the program at %1. It names none.</source>
        <translation>Vorschübe des Programms bei %1. Es nennt keinen.</translation>
    </message>
    <message>
        <source>That of the program, %1, at %2</source>
        <translation>Der des Programms, %1, bei %2</translation>
    </message>
    <message>
        <source>Those of the program, %1 to %2, at %3; each block its own</source>
        <translation>Die des Programms, %1 bis %2, bei %3; jeder Satz seinen eigenen</translation>
    </message>
    <message>
        <source>Rapids at %1 at most</source>
        <translation>Eilgänge mit höchstens %1</translation>
    </message>
    <message>
        <source>Blocks will be cut faster than programmed.</source>
        <translation>Sätze werden schneller gefahren als programmiert.</translation>
    </message>
    <message>
        <source>Use 100 %</source>
        <translation>100 % verwenden</translation>
    </message>
    <message>
        <source>%1 for every block: this method has one feed, as it was published</source>
        <translation>%1 für jeden Satz: Dieses Verfahren hat einen Vorschub, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Use the feeds of the program</source>
        <translation>Vorschübe des Programms verwenden</translation>
    </message>
    <message>
        <source>Safe, but the machine will wait for points. Largest override without waiting: %1.</source>
        <translation>Sicher, aber die Maschine wird auf Punkte warten. Größter Override ohne Warten: %1.</translation>
    </message>
    <message>
        <source>Margin %1 ×, largest override %2</source>
        <translation>Reserve %1 ×, größter Override %2</translation>
    </message>
    <message>
        <source>%1 (line %2)</source>
        <translation>%1 (Zeile %2)</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>Whole job</source>
        <translation>Ganzer Auftrag</translation>
    </message>
    <message>
        <source>Motion only</source>
        <translation>Nur Bewegung</translation>
    </message>
    <message>
        <source>Set tool, spindle and coolant at the control.</source>
        <translation>Werkzeug, Spindel und Kühlmittel an der Steuerung einstellen.</translation>
    </message>
    <message>
        <source>Run the whole job</source>
        <translation>Ganzen Auftrag ausführen</translation>
    </message>
    <message>
        <source>First the control executes line %1: %2. Then the tool moves from where it stands to the first point of part 1.</source>
        <translation>Zuerst führt die Steuerung Zeile %1 aus: %2. Dann fährt das Werkzeug von seinem Ort zum ersten Punkt von Abschnitt 1.</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Verfahrweg</translation>
    </message>
    <message>
        <source>Not checked: nobody has entered the limits of this machine.</source>
        <translation>Nicht geprüft: Niemand hat die Grenzen dieser Maschine eingegeben.</translation>
    </message>
    <message>
        <source>Enter …</source>
        <translation>Eingeben …</translation>
    </message>
    <message>
        <source>%1 needs %2, the machine has %3</source>
        <translation>%1 braucht %2, die Maschine hat %3</translation>
    </message>
    <message>
        <source>The path is longer than the travel: %1.</source>
        <translation>Die Bahn ist länger als der Verfahrweg: %1.</translation>
    </message>
    <message>
        <source>The path (%1 mm) is not longer than the travel of the axes. Where the workpiece lies is not known to Rivulet.</source>
        <translation>Die Bahn (%1 mm) ist nicht länger als der Verfahrweg der Achsen. Wo das Werkstück liegt, weiß Rivulet nicht.</translation>
    </message>
    <message>
        <source>Travel, spindle and tools</source>
        <translation>Verfahrweg, Spindel und Werkzeuge</translation>
    </message>
    <message>
        <source>The job is being compared with the machine.</source>
        <translation>Der Auftrag wird mit der Maschine verglichen.</translation>
    </message>
    <message>
        <source>Every block is within the travel of the axes, the speed of the spindle and the tool table.</source>
        <translation>Alle Sätze bleiben innerhalb von Verfahrweg, Spindeldrehzahl und Werkzeugtabelle.</translation>
    </message>
    <message numerus="yes">
        <source>%1, version %2, %Ln points</source>
        <translation>
            <numerusform>%1, Fassung %2, %Ln Punkt</numerusform>
            <numerusform>%1, Fassung %2, %Ln Punkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Streamed: %1; the control executes %Ln blocks: %2</source>
        <translation>
            <numerusform>Gestreamt: %1; die Steuerung führt %Ln Satz aus: %2</numerusform>
            <numerusform>Gestreamt: %1; die Steuerung führt %Ln Sätze aus: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln Abschnitt</numerusform>
            <numerusform>%Ln Abschnitte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln blocks are left out: %1</source>
        <translation>
            <numerusform>%Ln Satz wird ausgelassen: %1</numerusform>
            <numerusform>%Ln Sätze werden ausgelassen: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line over %1 to %2. %Ln points have been executed.</source>
        <translation>
            <numerusform>Geradeaus über %1 zu %2. %Ln Punkt ist ausgeführt.</numerusform>
            <numerusform>Geradeaus über %1 zu %2. %Ln Punkte sind ausgeführt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line to %1. %Ln points have been executed.</source>
        <translation>
            <numerusform>Geradeaus zu %1. %Ln Punkt ist ausgeführt.</numerusform>
            <numerusform>Geradeaus zu %1. %Ln Punkte sind ausgeführt.</numerusform>
        </translation>
    </message>
    <message>
        <source>as a rapid, %1</source>
        <translation>im Eilgang, %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>mit %1</translation>
    </message>
    <message>
        <source>From where the tool stands in a straight line over %1, %2, to where line %3 begins: %4.</source>
        <translation>Von dort, wo das Werkzeug steht, geradlinig über %1, %2, dorthin, wo Zeile %3 beginnt: %4.</translation>
    </message>
    <message>
        <source>From where the tool stands in a straight line, %1, to where line %2 begins: %3.</source>
        <translation>Von dort, wo das Werkzeug steht, geradlinig, %1, dorthin, wo Zeile %2 beginnt: %3.</translation>
    </message>
    <message numerus="yes">
        <source>The %Ln points before it are not executed.</source>
        <translation>
            <numerusform>Der %Ln Punkt davor wird nicht ausgeführt.</numerusform>
            <numerusform>Die %Ln Punkte davor werden nicht ausgeführt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Feeds are those that the program has commanded up to each line, and the work offset is the one that is active at the control.</source>
        <translation>Es gelten die Vorschübe, die das Programm bis zu jeder Zeile befohlen hat, und die Nullpunktverschiebung, die an der Steuerung aktiv ist.</translation>
    </message>
    <message>
        <source>State at this line</source>
        <translation>Zustand an dieser Zeile</translation>
    </message>
    <message>
        <source>Left out before this line, the last one first: %1. Set at the control what holds here.</source>
        <translation>Vor dieser Zeile ausgelassen, der letzte Satz zuerst: %1. An der Steuerung einstellen, was hier gilt.</translation>
    </message>
    <message>
        <source>Begin with a part …</source>
        <translation>Mit einem Abschnitt beginnen …</translation>
    </message>
    <message>
        <source>First the control executes</source>
        <translation>Zuerst führt die Steuerung aus</translation>
    </message>
    <message>
        <source>Then the job goes on in part %1 at point %2 of %3 (line %4).</source>
        <translation>Dann geht der Auftrag in Abschnitt %1 bei Punkt %2 von %3 weiter (Zeile %4).</translation>
    </message>
    <message>
        <source>Then the job goes on at line %1: %2</source>
        <translation>Dann geht der Auftrag bei Zeile %1 weiter: %2</translation>
    </message>
    <message>
        <source>Not done again, because only the control knows their effect: %1</source>
        <translation>Nicht noch einmal ausgeführt, weil nur die Steuerung ihre Wirkung kennt: %1</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Trockenlauf</translation>
    </message>
    <message>
        <source>Everything takes place %1 higher than programmed. The spindle does not turn, and no coolant flows; tools are changed, and retracts in machine coordinates are made.</source>
        <translation>Alles geschieht %1 höher als programmiert. Die Spindel dreht nicht, und kein Kühlmittel fließt; Werkzeuge werden gewechselt und Rückzüge in Maschinenkoordinaten ausgeführt.</translation>
    </message>
    <message>
        <source>Live source</source>
        <translation>Live-Quelle</translation>
    </message>
    <message>
        <source>Change …</source>
        <translation>Ändern …</translation>
    </message>
    <message>
        <source>%1 is open. What it sends is read from the start on.</source>
        <translation>%1 ist geöffnet. Was sie sendet, wird ab dem Start gelesen.</translation>
    </message>
    <message>
        <source>Agreed</source>
        <translation>Vereinbart</translation>
    </message>
    <message>
        <source>No point is outside %1. No step is longer than %2. Anything else ends the run after the last good point.</source>
        <translation>Kein Punkt liegt außerhalb von %1. Kein Schritt ist länger als %2. Alles andere beendet den Lauf nach dem letzten guten Punkt.</translation>
    </message>
    <message>
        <source>The F of the points, at most %1; that is also the feed before the first F.</source>
        <translation>Das F der Punkte, höchstens %1; das ist auch der Vorschub vor dem ersten F.</translation>
    </message>
    <message>
        <source>No points</source>
        <translation>Ohne Punkte</translation>
    </message>
    <message>
        <source>The machine waits at the end of the last window: %1.</source>
        <translation>Die Maschine wartet am Ende des letzten Fensters: %1.</translation>
    </message>
    <message>
        <source>From %1 in a straight line to the first point, which may be %2 away.</source>
        <translation>Von %1 in gerader Linie zum ersten Punkt, der bis zu %2 entfernt sein darf.</translation>
    </message>
    <message>
        <source>The tool is so far outside the box that no first point can be in it. Move the tool, or change the box.</source>
        <translation>Das Werkzeug steht so weit außerhalb des Quaders, dass kein erster Punkt darin liegen kann. Das Werkzeug verfahren oder den Quader ändern.</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Gelesen als</translation>
    </message>
    <message>
        <source>a program for %1</source>
        <translation>Programm für %1</translation>
    </message>
    <message>
        <source>mm, because this machine is metric; the program does not say (%1)</source>
        <translation>mm, weil diese Maschine metrisch ist; das Programm sagt es nicht (%1)</translation>
    </message>
    <message>
        <source>inch where the program does not say it, as chosen</source>
        <translation>Zoll, wo das Programm es nicht sagt, wie gewählt</translation>
    </message>
    <message>
        <source>mm where the program does not say it, as chosen</source>
        <translation>mm, wo das Programm es nicht sagt, wie gewählt</translation>
    </message>
    <message>
        <source>whole units where a number has no decimal point (%1)</source>
        <translation>ganze Einheiten, wo eine Zahl keinen Dezimalpunkt hat (%1)</translation>
    </message>
    <message>
        <source>thousandths where a number has no decimal point, as chosen</source>
        <translation>Tausendstel, wo eine Zahl keinen Dezimalpunkt hat, wie gewählt</translation>
    </message>
    <message>
        <source>whole units where a number has no decimal point, as chosen</source>
        <translation>ganze Einheiten, wo eine Zahl keinen Dezimalpunkt hat, wie gewählt</translation>
    </message>
    <message>
        <source>%1: the control executes %2</source>
        <translation>%1: Die Steuerung führt %2 aus</translation>
    </message>
    <message>
        <source>%1: left out, because nobody has said what this machine does for it (Configure, Limits)</source>
        <translation>%1: weggelassen, weil niemand gesagt hat, was diese Maschine dafür tut (Konfiguration, Grenzen)</translation>
    </message>
    <message>
        <source>%1: left out</source>
        <translation>%1: weggelassen</translation>
    </message>
    <message>
        <source>without %1, which does not change the path, as confirmed</source>
        <translation>ohne %1: bestätigt, dass sich der Weg dadurch nicht ändert</translation>
    </message>
    <message>
        <source>what it leaves out as a virtual machine is set (%1)</source>
        <translation>was es weglässt, wie eine virtuelle Maschine eingestellt ist (%1)</translation>
    </message>
    <message>
        <source>what it leaves out as chosen (%1)</source>
        <translation>was es weglässt, wie gewählt (%1)</translation>
    </message>
    <message>
        <source>M functions and axes of another machine</source>
        <translation>M-Funktionen und Achsen einer anderen Maschine</translation>
    </message>
    <message numerus="yes">
        <source>%1 (line %2, %Ln times)</source>
        <translation>
            <numerusform>%1 (Zeile %2, einmal)</numerusform>
            <numerusform>%1 (Zeile %2, %Ln-mal)</numerusform>
        </translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>The axes stand at once, on the path. How long they brake is not known.</source>
        <translation>Die Achsen stehen sofort, auf der Bahn. Wie lange sie bremsen, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The axes stand on the path within %1; threads and tapping at their end.</source>
        <translation>Die Achsen stehen innerhalb von %1 auf der Bahn; Gewinde an ihrem Ende.</translation>
    </message>
    <message>
        <source>Every block is within the travel of the axes and the speed of the spindle. Tools are not compared: this machine has no tool table here.</source>
        <translation>Jeder Satz liegt im Verfahrweg der Achsen und im Drehzahlbereich der Spindel. Werkzeuge werden nicht verglichen: Für diese Maschine gibt es hier keine Werkzeugtabelle.</translation>
    </message>
    <message>
        <source>The program uses tool %1; there is none in the spindle.</source>
        <translation>Das Programm arbeitet mit Werkzeug %1; in der Spindel ist keines.</translation>
    </message>
    <message>
        <source>The program uses tool %1; %2 is in the spindle.</source>
        <translation>Das Programm arbeitet mit Werkzeug %1; in der Spindel ist %2.</translation>
    </message>
    <message>
        <source>The program works in %1; %2 is active.</source>
        <translation>Das Programm arbeitet in %1; aktiv ist %2.</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>turns at %1 1/min, %2</source>
        <translation>dreht mit %1 1/min, %2</translation>
    </message>
    <message>
        <source>clockwise (M3)</source>
        <translation>rechts (M3)</translation>
    </message>
    <message>
        <source>counterclockwise (M4)</source>
        <translation>links (M4)</translation>
    </message>
    <message>
        <source>In the program the spindle %1; now it %2.</source>
        <translation>Im Programm: Spindel %1; jetzt: Spindel %2.</translation>
    </message>
    <message>
        <source>Confirmed: it starts like this.</source>
        <translation>Bestätigt: Der Start erfolgt so.</translation>
    </message>
    <message>
        <source>Start like this</source>
        <translation>So starten</translation>
    </message>
    <message>
        <source>Then in a straight line over %1 to %2.</source>
        <translation>Dann geradlinig über %1 nach %2.</translation>
    </message>
    <message>
        <source>This way passes within what the program cuts, which reaches up to Z %1.</source>
        <translation>Dieser Weg führt durch den Bereich, in dem das Programm schneidet; er reicht bis Z %1.</translation>
    </message>
    <message>
        <source>Raise the tool …</source>
        <translation>Werkzeug abheben …</translation>
    </message>
    <message>
        <source>Bring the tool to a place from which it is clear.</source>
        <translation>Bringen Sie das Werkzeug an eine Stelle, von der aus er frei ist.</translation>
    </message>
    <message>
        <source>Straight way</source>
        <translation>Gerader Weg</translation>
    </message>
    <message>
        <source>Confirmed: nothing is in the way of the first move.</source>
        <translation>Bestätigt: Der ersten Bewegung ist nichts im Weg.</translation>
    </message>
    <message>
        <source>If nothing is in the way of the first move, confirm it.</source>
        <translation>Wenn der ersten Bewegung nichts im Weg ist, bestätigen Sie es.</translation>
    </message>
    <message>
        <source>It is clear …</source>
        <translation>Er ist frei …</translation>
    </message>
    <message>
        <source>Raise the tool</source>
        <translation>Werkzeug abheben</translation>
    </message>
    <message>
        <source>The tool goes straight up by %1 to Z %2, at %3. Nothing else moves. Then this page comes again.</source>
        <translation>Das Werkzeug fährt gerade nach oben, um %1 auf Z %2, mit %3. Sonst bewegt sich nichts. Danach kommt diese Seite wieder.</translation>
    </message>
    <message>
        <source>After Stop the control still executes its window, of at most %1 moves within the agreed box, and of at most %2: longer moves are divided.</source>
        <translation>Nach Stopp führt die Steuerung ihr Fenster noch aus: höchstens %1 Wege im vereinbarten Quader, die zusammen höchstens %2 dauern. Längere Wege werden geteilt.</translation>
    </message>
    <message>
        <source>After Stop the control still executes its window, at most %1 in %2.</source>
        <translation>Nach Stopp führt die Steuerung ihr Fenster noch aus, höchstens %1 in %2.</translation>
    </message>
    <message>
        <source>The move of line %1 alone takes %2; it is not divided.</source>
        <translation>Der Weg von Zeile %1 dauert allein %2; er wird nicht geteilt.</translation>
    </message>
    <message>
        <source>Method %1 may execute old points again: if this computer is late for a moment, the tool goes back through the workpiece, and nothing stops it before it has moved. Method window does not.</source>
        <translation>Verfahren %1 kann alte Punkte noch einmal ausführen: Ist dieser Rechner einen Moment zu spät, fährt das Werkzeug durch das Werkstück zurück, und nichts hält es auf, bevor es sich bewegt hat. Verfahren Fenster tut das nicht.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Confirmed.</source>
        <translation>Bestätigt.</translation>
    </message>
    <message>
        <source>Accept it …</source>
        <translation>In Kauf nehmen …</translation>
    </message>
    <message>
        <source>Since it was measured how fast this control can be written to, its software has changed: %1 for each R-parameter are assumed.</source>
        <translation>Seit gemessen wurde, wie schnell diese Steuerung beschrieben werden kann, hat sich ihre Software geändert: Angenommen werden %1 je R-Parameter.</translation>
    </message>
    <message>
        <source>It has not been measured how fast this control can be written to: %1 for each R-parameter are assumed.</source>
        <translation>Wie schnell diese Steuerung beschrieben werden kann, ist nicht gemessen: Angenommen werden %1 je R-Parameter.</translation>
    </message>
    <message>
        <source>Measure …</source>
        <translation>Messen …</translation>
    </message>
    <message>
        <source>Back along the path</source>
        <translation>Auf der Bahn zurück</translation>
    </message>
    <message>
        <source>The tool goes back by %1 along the path that it has cut, at %2, to %3. Then this page comes again, and the run goes on from there.</source>
        <translation>Das Werkzeug fährt auf der gefrästen Bahn um %1 zurück, mit %2, bis %3. Danach kommt diese Seite wieder, und der Lauf geht von dort weiter.</translation>
    </message>
    <message>
        <source>Drive back …</source>
        <translation>Zurückfahren …</translation>
    </message>
    <message>
        <source>The first move, to line %1, alone takes %2: bring the tool nearer before the start.</source>
        <translation>Schon die erste Bewegung, zu Zeile %1, dauert %2: Das Werkzeug vor dem Start näher heranfahren.</translation>
    </message>
    <message>
        <source>%1 multiplies your override: %2 to %3, and no more than 120 % in all.</source>
        <translation>%1 multipliziert Ihren Override: mit %2 bis %3, insgesamt höchstens 120&#xa0;%.</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Adaptiver Vorschub</translation>
    </message>
    <message>
        <source>Without a factor for %1 the axes are held; nothing moves before the first.</source>
        <translation>Ohne Faktor seit %1 werden die Achsen gehalten; vor dem ersten bewegt sich nichts.</translation>
    </message>
    <message>
        <source>Without a factor for %1 your override acts alone.</source>
        <translation>Ohne Faktor seit %1 wirkt nur Ihr Override.</translation>
    </message>
    <message>
        <source>With this method, after Stop the control still executes its loop, at most %1 in %2.</source>
        <translation>Mit dieser Methode führt die Steuerung nach Stopp ihre Schleife noch aus, höchstens %1 in %2.</translation>
    </message>
    <message>
        <source>Within the tolerance %1 of %2 points are left, at most %3 off the program.</source>
        <translation>Innerhalb der Toleranz bleiben %1 von %2 Punkten, höchstens %3 neben dem Programm.</translation>
    </message>
    <message>
        <source>All points are streamed: a whole job has no tolerance.</source>
        <translation>Alle Punkte werden gestreamt: Ein ganzer Auftrag hat keine Toleranz.</translation>
    </message>
    <message>
        <source>All points are streamed: fewer cannot be kept within the tolerance.</source>
        <translation>Alle Punkte werden gestreamt: Mit weniger lässt sich die Toleranz nicht einhalten.</translation>
    </message>
    <message>
        <source>The path is being measured.</source>
        <translation>Die Bahn wird vermessen.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::RunController</name>
    <message>
        <source>Stop requested.</source>
        <translation>Stopp angefordert.</translation>
    </message>
    <message>
        <source>Continue requested.</source>
        <translation>Weiter angefordert.</translation>
    </message>
    <message>
        <source>Calibration on R%1 to R%2 started.</source>
        <translation>Kalibrierung auf R%1 bis R%2 gestartet.</translation>
    </message>
    <message>
        <source>The run was left before point %1 of %2.</source>
        <translation>Der Lauf wurde vor Punkt %1 von %2 unterbrochen.</translation>
    </message>
    <message>
        <source>Press Resume first: it asks the control where the run was left.</source>
        <translation>Zuerst Fortsetzen drücken: Dann wird die Steuerung gefragt, wo der Lauf unterbrochen wurde.</translation>
    </message>
    <message>
        <source>The run resumes at point %1.</source>
        <translation>Der Lauf wird bei Punkt %1 fortgesetzt.</translation>
    </message>
    <message>
        <source>Start. The tool first moves %1 in a straight line to the first point.</source>
        <translation>Start. Das Werkzeug fährt zuerst %1 geradlinig zum ersten Punkt.</translation>
    </message>
    <message>
        <source>Save the template on its page as %1, copy it to the part programs of the control, select it in channel 1 and press cycle start. The axes move only after the template has shown its layout number %2.</source>
        <translation>Die Vorlage auf ihrer Seite als %1 speichern, zu den Teileprogrammen der Steuerung kopieren, im Kanal 1 anwählen und NC-Start drücken. Die Achsen fahren erst, wenn die Vorlage ihre Layoutnummer %2 gezeigt hat.</translation>
    </message>
    <message>
        <source>Access: %1.</source>
        <translation>Zugriff: %1.</translation>
    </message>
    <message>
        <source>Run ended: %1 of %2 points executed.</source>
        <translation>Lauf beendet: %1 von %2 Punkten ausgeführt.</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Aufzeichnung: %1</translation>
    </message>
    <message>
        <source>The run has executed wrong points: see the report, and check the workpiece.</source>
        <translation>Der Lauf hat falsche Punkte ausgeführt: Bericht ansehen und Werkstück prüfen.</translation>
    </message>
    <message>
        <source>The run is not in the history: %1</source>
        <translation>Der Lauf ist nicht in der Liste der Läufe: %1</translation>
    </message>
    <message>
        <source>Wrong motion: after point %1 the tool is %2 off the path.</source>
        <translation>Falsche Bewegung: Nach Punkt %1 ist das Werkzeug %2 neben der Bahn.</translation>
    </message>
    <message>
        <source>Wrong motion: the control has repeated points after point %1.</source>
        <translation>Falsche Bewegung: Die Steuerung hat nach Punkt %1 Punkte wiederholt.</translation>
    </message>
    <message>
        <source>The program waits for cycle start at the control (line %1).</source>
        <translation>Das Programm wartet auf NC-Start an der Steuerung (Zeile %1).</translation>
    </message>
    <message numerus="yes">
        <source>Start of a whole job: %1, %Ln blocks for the control.</source>
        <translation>
            <numerusform>Start eines ganzen Auftrags: %1, %Ln Satz für die Steuerung.</numerusform>
            <numerusform>Start eines ganzen Auftrags: %1, %Ln Sätze für die Steuerung.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln Abschnitt</numerusform>
            <numerusform>%Ln Abschnitte</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 and those after it move nothing. Choose an earlier line.</source>
        <translation>Zeile %1 und die danach bewegen nichts. Eine frühere Zeile wählen.</translation>
    </message>
    <message>
        <source>The run starts at point %1.</source>
        <translation>Der Lauf beginnt bei Punkt %1.</translation>
    </message>
    <message>
        <source>A whole job begins at its beginning, or with a part: press Start, then Begin with a part. To begin at this line, choose Motion only in the settings, and set tool, spindle and coolant yourself.</source>
        <translation>Ein ganzer Auftrag beginnt an seinem Anfang oder mit einem Abschnitt: Start drücken, dann Mit einem Abschnitt beginnen. Um bei dieser Zeile zu beginnen, in den Einstellungen Nur Bewegung wählen und Werkzeug, Spindel und Kühlmittel selbst setzen.</translation>
    </message>
    <message numerus="yes">
        <source>The job goes on at line %1, after %Ln blocks of the control.</source>
        <translation>
            <numerusform>Der Auftrag geht bei Zeile %1 weiter, nach %Ln Satz der Steuerung.</numerusform>
            <numerusform>Der Auftrag geht bei Zeile %1 weiter, nach %Ln Sätzen der Steuerung.</numerusform>
        </translation>
    </message>
    <message>
        <source>The tools and offsets of this machine are not known, so the state in which the job goes on cannot be computed. Start from the beginning.</source>
        <translation>Werkzeuge und Verschiebungen dieser Maschine sind nicht bekannt, daher kann der Zustand, in dem der Auftrag weitergeht, nicht berechnet werden. Von vorn beginnen.</translation>
    </message>
    <message>
        <source>The state before this part is not known: only the control knows what an earlier block does. Choose an earlier part, or start from the beginning.</source>
        <translation>Der Zustand vor diesem Abschnitt ist nicht bekannt: Nur die Steuerung weiß, was ein früherer Satz bewirkt. Einen früheren Abschnitt wählen oder von vorn beginnen.</translation>
    </message>
    <message>
        <source>It is not known for certain where the job was left. Press Start, then Begin with a part, or start from the beginning.</source>
        <translation>Es ist nicht sicher bekannt, wo der Auftrag verlassen wurde. Start drücken, dann Mit einem Abschnitt beginnen, oder von vorn beginnen.</translation>
    </message>
    <message>
        <source>Start. The points come from %1.</source>
        <translation>Start. Die Punkte kommen von %1.</translation>
    </message>
    <message>
        <source>Rivulet cannot stop what the control executes now. Press NC STOP at the machine.</source>
        <translation>Rivulet kann nicht anhalten, was die Steuerung jetzt ausführt. An der Maschine NC-STOPP drücken.</translation>
    </message>
    <message>
        <source>Stop: the axes are held on the path.</source>
        <translation>Stopp: Die Achsen werden auf der Bahn gehalten.</translation>
    </message>
    <message>
        <source>Pause requested.</source>
        <translation>Pause angefordert.</translation>
    </message>
    <message>
        <source>The tool is raised to Z %1.</source>
        <translation>Das Werkzeug wird auf Z %1 abgehoben.</translation>
    </message>
    <message>
        <source>The state before the first part is not known: only the control knows what an earlier block does. Start from the beginning.</source>
        <translation>Der Zustand vor dem ersten Abschnitt ist nicht bekannt: Nur die Steuerung weiß, was ein früherer Satz bewirkt. Von vorn beginnen.</translation>
    </message>
    <message>
        <source>The test of the control is aborted. If an axis still moves, press NC STOP at the machine.</source>
        <translation>Der Test der Steuerung ist abgebrochen. Bewegt sich noch eine Achse, an der Maschine NC-STOPP drücken.</translation>
    </message>
    <message>
        <source>The control was reset: its program has ended after %1.</source>
        <translation>Die Steuerung wurde zurückgesetzt: Ihr Programm war nach %1 beendet.</translation>
    </message>
    <message>
        <source>A reset of the control was requested. If an axis still moves, press NC STOP at the machine.</source>
        <translation>Reset der Steuerung angefordert. Bewegt sich noch eine Achse, an der Maschine NC-STOPP drücken.</translation>
    </message>
    <message>
        <source>The file of the run is gone: the run could not go on after the way back.</source>
        <translation>Die Datei des Laufs ist weg: Nach dem Rückweg könnte der Lauf nicht weitergehen.</translation>
    </message>
    <message>
        <source>The tool is driven back by %1 along the path.</source>
        <translation>Das Werkzeug fährt auf der Bahn um %1 zurück.</translation>
    </message>
    <message>
        <source>The tool is to be lifted by %1.</source>
        <translation>Das Werkzeug soll um %1 abheben.</translation>
    </message>
    <message>
        <source>The tool is to be lowered.</source>
        <translation>Das Werkzeug soll absenken.</translation>
    </message>
    <message>
        <source>Line %1: &quot;%2&quot; has not been tried on this machine. Test it on the page Job test, or run the motion only.</source>
        <translation>Zeile %1: „%2“ ist auf dieser Maschine nicht erprobt. Auf der Seite Auftrags-Test erproben, oder nur die Bewegung ausführen.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::VirtualMachine</name>
    <message>
        <source>The virtual machine cannot be started: %1</source>
        <translation>Die virtuelle Maschine lässt sich nicht starten: %1</translation>
    </message>
    <message>
        <source>The virtual machine has ended.</source>
        <translation>Die virtuelle Maschine wurde beendet.</translation>
    </message>
    <message>
        <source>The program rivulet-machine is missing. Install it beside this window.</source>
        <translation>Das Programm rivulet-machine fehlt. Installieren Sie es neben diesem Fenster.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AdvicePanel</name>
    <message>
        <source>F %1 instead of %2: still without wrong points</source>
        <translation>F %1 statt %2: noch immer ohne falsche Punkte</translation>
    </message>
    <message>
        <source>F %1 instead of %2: without waiting</source>
        <translation>F %1 statt %2: ohne Warten</translation>
    </message>
    <message>
        <source>F %1 instead of %2: feasible</source>
        <translation>F %1 statt %2: machbar</translation>
    </message>
    <message>
        <source>N %1 instead of %2: largest feed %3</source>
        <translation>N %1 statt %2: größter Vorschub %3</translation>
    </message>
    <message>
        <source>δ %1 instead of %2: largest feed %3</source>
        <translation>δ %1 statt %2: größter Vorschub %3</translation>
    </message>
    <message>
        <source>Method %1 instead of %2: largest feed %3</source>
        <translation>Verfahren %1 statt %2: größter Vorschub %3</translation>
    </message>
    <message>
        <source>Judging …</source>
        <translation>Wird beurteilt …</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>Kein Urteil</translation>
    </message>
    <message>
        <source>Not feasible: largest feed %1</source>
        <translation>Nicht machbar: größter Vorschub %1</translation>
    </message>
    <message>
        <source>Safe, with waiting above %1</source>
        <translation>Sicher, mit Warten über %1</translation>
    </message>
    <message>
        <source>By the equations feasible up to %1</source>
        <translation>Nach den Gleichungen machbar bis %1</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Looking for better settings …</source>
        <translation>Sucht bessere Werte …</translation>
    </message>
    <message>
        <source>No single change makes this program much faster.</source>
        <translation>Keine einzelne Änderung macht dieses Programm viel schneller.</translation>
    </message>
    <message>
        <source>Each was simulated with this program and made no wrong point.</source>
        <translation>Jede wurde mit diesem Programm simuliert, ohne einen falschen Punkt.</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Empfehlungen</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>Points per loop N</source>
        <translation>Punkte je Schleife N</translation>
    </message>
    <message>
        <source>Distance δ</source>
        <translation>Abstand δ</translation>
    </message>
    <message>
        <source>Feed F</source>
        <translation>Vorschub F</translation>
    </message>
    <message>
        <source>Override %1 instead of %2: still without wrong points</source>
        <translation>Override %1 statt %2: noch ohne falsche Punkte</translation>
    </message>
    <message>
        <source>Override %1 instead of %2: without waiting</source>
        <translation>Override %1 statt %2: ohne Warten</translation>
    </message>
    <message>
        <source>N %1 instead of %2: largest override %3</source>
        <translation>N %1 statt %2: größter Override %3</translation>
    </message>
    <message>
        <source>Safe, with waiting above an override of %1</source>
        <translation>Sicher, mit Warten über einem Override von %1</translation>
    </message>
    <message>
        <source>By the equations without waiting up to %1</source>
        <translation>Nach den Gleichungen ohne Warten bis %1</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmHistoryModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Von</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmLine</name>
    <message>
        <source>Ack</source>
        <translation>Quitt.</translation>
    </message>
    <message>
        <source>Acknowledge: you have seen this alarm</source>
        <translation>Quittieren: Sie haben diesen Alarm gesehen</translation>
    </message>
    <message>
        <source>Acknowledge the alarm</source>
        <translation>Den Alarm quittieren</translation>
    </message>
    <message>
        <source>Show all alarms</source>
        <translation>Alle Alarme zeigen</translation>
    </message>
    <message>
        <source>Dismiss the message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Alarms: %1. Show all</source>
        <translation>Alarme: %1. Alle zeigen</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmModel</name>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmPage</name>
    <message>
        <source>There is no alarm.</source>
        <translation>Es liegt kein Alarm an.</translation>
    </message>
    <message>
        <source>shelved by %1 until %2</source>
        <translation>zurückgestellt von %1 bis %2</translation>
    </message>
    <message>
        <source>Alarms (%1)</source>
        <translation>Alarme (%1)</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Ursache</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Abhilfe</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Alle quittieren</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>Zurückstellen</translation>
    </message>
    <message>
        <source>Put the alarm aside for a time. It stays in this list.</source>
        <translation>Den Alarm für eine Zeit zurückstellen. Er bleibt in dieser Liste.</translation>
    </message>
    <message>
        <source>Show it again</source>
        <translation>Wieder zeigen</translation>
    </message>
    <message numerus="yes">
        <source>For %n minutes</source>
        <translation>
            <numerusform>Für %n Minute</numerusform>
            <numerusform>Für %n Minuten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n hours</source>
        <translation>
            <numerusform>Für %n Stunde</numerusform>
            <numerusform>Für %n Stunden</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AuditModel</name>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AuditPage</name>
    <message>
        <source>Export the audit trail</source>
        <translation>Protokoll der Bedienung exportieren</translation>
    </message>
    <message>
        <source>No audit trail is kept.</source>
        <translation>Es wird kein Protokoll der Bedienung geführt.</translation>
    </message>
    <message>
        <source>The audit trail was changed: line %1 was edited, or lines before it were inserted or removed.</source>
        <translation>Verändert: Zeile %1 wurde bearbeitet, oder vor ihr wurden Zeilen eingefügt oder entfernt.</translation>
    </message>
    <message>
        <source>Unchanged: every line follows from the one before it.</source>
        <translation>Unverändert: Jede Zeile folgt aus der vorigen.</translation>
    </message>
    <message>
        <source>Cut by a loss of power: %1.</source>
        <translation>Durch Stromausfall abgeschnitten: %1.</translation>
    </message>
    <message>
        <source>Last hash: %1 …</source>
        <translation>Letzter Hash: %1 …</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Export as CSV…</source>
        <translation>Als CSV exportieren …</translation>
    </message>
    <message>
        <source>Export as JSON…</source>
        <translation>Als JSON exportieren …</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Protokoll</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::BackDialog</name>
    <message>
        <source>To where the last rapid ended</source>
        <translation>Bis zum Ende des letzten Eilgangs</translation>
    </message>
    <message>
        <source>Back along the path</source>
        <translation>Auf der Bahn zurück</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> mm/min</source>
        <translation> mm/min</translation>
    </message>
    <message>
        <source>Show the way</source>
        <translation>Weg zeigen</translation>
    </message>
    <message>
        <source>Length of the way</source>
        <translation>Länge des Wegs</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::BoardCard</name>
    <message>
        <source>Remove …</source>
        <translation>Entfernen …</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CalibrationPage</name>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Shots of each kind</source>
        <translation>Messungen je Art</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>No program, cycle or other client uses R%1 to R%2: they may be written</source>
        <translation>Kein Programm, Zyklus oder Client nutzt R%1 bis R%2: Schreiben ist erlaubt</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Geraden</translation>
    </message>
    <message>
        <source>Spread (times in ms)</source>
        <translation>Streuung (Zeiten in ms)</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>Testing the forms of access …</source>
        <translation>Zugriffsarten werden geprüft …</translation>
    </message>
    <message>
        <source>First request of each kind …</source>
        <translation>Erste Messung jeder Art …</translation>
    </message>
    <message>
        <source>%1 of %2 shots, %3</source>
        <translation>%1 von %2 Messungen, %3</translation>
    </message>
    <message>
        <source>Takes about %1.</source>
        <translation>Dauert etwa %1.</translation>
    </message>
    <message>
        <source>%1, %2, R%3 to R%4, took %5</source>
        <translation>%1, %2, R%3 bis R%4, Dauer %5</translation>
    </message>
    <message>
        <source>Outdated, not used: the server now has another version. %1</source>
        <translation>Veraltet, nicht verwendet: Der Server hat jetzt eine andere Version. %1</translation>
    </message>
    <message>
        <source>Calibrated: %1.</source>
        <translation>Kalibriert: %1.</translation>
    </message>
    <message>
        <source>There was not enough time for all shots: reduced numbers are bold in the table.</source>
        <translation>Die Zeit reichte nicht für alle Messungen: Verringerte Anzahlen stehen fett in der Tabelle.</translation>
    </message>
    <message>
        <source>Restoring the R-parameters …</source>
        <translation>R-Parameter werden zurückgeschrieben …</translation>
    </message>
    <message>
        <source>The last R-parameter is before the first.</source>
        <translation>Der letzte R-Parameter liegt vor dem ersten.</translation>
    </message>
    <message>
        <source>Confirm the R-parameters to begin.</source>
        <translation>Zum Beginnen die R-Parameter bestätigen.</translation>
    </message>
    <message>
        <source>This machine is not calibrated: %1 for each R-parameter are assumed.</source>
        <translation>Diese Maschine ist nicht kalibriert: Je R-Parameter werden %1 angenommen.</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>R-Parameter</translation>
    </message>
    <message>
        <source>Arrays too: for the test, they hold other values for a moment</source>
        <translation>Auch Felder: Für den Test stehen kurz andere Werte darin</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CellModel</name>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>R-Parameter</translation>
    </message>
    <message>
        <source>Point %1: %2</source>
        <translation>Punkt %1: %2</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Client</translation>
    </message>
    <message>
        <source>NC</source>
        <translation>NC</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Layout number</source>
        <translation>Layoutnummer</translation>
    </message>
    <message>
        <source>Writer</source>
        <translation>Schreiber</translation>
    </message>
    <message>
        <source>Client, NC</source>
        <translation>Client, NC</translation>
    </message>
    <message>
        <source>Feed (mm/min)</source>
        <translation>Vorschub (mm/min)</translation>
    </message>
    <message>
        <source>Window %1: points</source>
        <translation>Fenster %1: Punkte</translation>
    </message>
    <message>
        <source>Window %1: feed (mm/min)</source>
        <translation>Fenster %1: Vorschub (mm/min)</translation>
    </message>
    <message>
        <source>Window %1: check number</source>
        <translation>Fenster %1: Prüfzahl</translation>
    </message>
    <message>
        <source>Window %1 point %2: %3</source>
        <translation>Fenster %1 Punkt %2: %3</translation>
    </message>
    <message>
        <source>Windows delivered</source>
        <translation>Gelieferte Fenster</translation>
    </message>
    <message>
        <source>Windows taken</source>
        <translation>Übernommene Fenster</translation>
    </message>
    <message>
        <source>Windows executed</source>
        <translation>Ausgeführte Fenster</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Number of the run</source>
        <translation>Nummer des Laufs</translation>
    </message>
    <message>
        <source>Run obeyed</source>
        <translation>Befolgter Lauf</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Lebenszeichen</translation>
    </message>
    <message>
        <source>Online correction: %1</source>
        <translation>Online-Korrektur: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CertificatesPage</name>
    <message>
        <source>Save this computer&apos;s certificate</source>
        <translation>Zertifikat dieses Rechners speichern</translation>
    </message>
    <message>
        <source>A certificate is being made …</source>
        <translation>Ein Zertifikat wird erzeugt …</translation>
    </message>
    <message>
        <source>There is none yet. It is made when it is first needed.</source>
        <translation>Es gibt noch keines. Es wird erzeugt, sobald es gebraucht wird.</translation>
    </message>
    <message>
        <source>It has ended (%1). Renew it.</source>
        <translation>Es ist abgelaufen (%1). Erneuern.</translation>
    </message>
    <message numerus="yes">
        <source>Valid for %Ln more days (%1)</source>
        <translation>
            <numerusform>Noch %Ln Tag gültig (%1)</numerusform>
            <numerusform>Noch %Ln Tage gültig (%1)</numerusform>
        </translation>
    </message>
    <message>
        <source>Encryption by %1</source>
        <translation>Verschlüsselung durch %1</translation>
    </message>
    <message>
        <source>Certificate of this computer</source>
        <translation>Zertifikat dieses Rechners</translation>
    </message>
    <message>
        <source>Fingerprint (SHA-256)</source>
        <translation>Fingerabdruck (SHA-256)</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>Speichern …</translation>
    </message>
    <message>
        <source>Writes the certificate, without its key, for the control&apos;s list of trusted clients.</source>
        <translation>Schreibt das Zertifikat ohne seinen Schlüssel, für die Liste vertrauter Clients der Steuerung.</translation>
    </message>
    <message>
        <source>Hold: renew</source>
        <translation>Halten: erneuern</translation>
    </message>
    <message>
        <source>Makes a new one. Every control has to trust it anew.</source>
        <translation>Erzeugt ein neues. Jede Steuerung muss ihm neu vertrauen.</translation>
    </message>
    <message>
        <source>Machines that are known</source>
        <translation>Bekannte Maschinen</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>At the next connection the machine is new.</source>
        <translation>Bei der nächsten Verbindung ist die Maschine neu.</translation>
    </message>
    <message>
        <source>Protect again</source>
        <translation>Wieder schützen</translation>
    </message>
    <message>
        <source>Withdraws what was allowed for this machine: from then on, the strongest encryption or no connection.</source>
        <translation>Nimmt zurück, was für diese Maschine erlaubt wurde: von da an stärkste Verschlüsselung oder keine Verbindung.</translation>
    </message>
    <message>
        <source>Certificates that were refused</source>
        <translation>Abgelehnte Zertifikate</translation>
    </message>
    <message>
        <source>Hold: accept</source>
        <translation>Halten: annehmen</translation>
    </message>
    <message>
        <source>From then on it is trusted at its address, in place of any other one.</source>
        <translation>Von da an gilt es an seiner Adresse als vertraut, anstelle jedes anderen.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes it from the list. It stays refused.</source>
        <translation>Entfernt es aus der Liste. Es bleibt abgelehnt.</translation>
    </message>
    <message>
        <source>Only the very certificates that were accepted are trusted, not who issued them. So revocation lists are not needed: forget the machine instead.</source>
        <translation>Vertraut wird genau den angenommenen Zertifikaten, nicht ihren Ausstellern. Sperrlisten sind deshalb nicht nötig: stattdessen die Maschine vergessen.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CloseBar</name>
    <message>
        <source>Keep the window open</source>
        <translation>Fenster offen lassen</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Stoppen und schließen</translation>
    </message>
    <message>
        <source>A run is in progress. To close the window, its axes are held first, where they are; the run can be resumed from there.</source>
        <translation>Ein Lauf ist aktiv. Zum Schließen werden seine Achsen zuerst angehalten, wo sie sind; von dort kann der Lauf fortgesetzt werden.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ColumnsDialog</name>
    <message>
        <source>The trace can be analysed.</source>
        <translation>Die Aufzeichnung kann ausgewertet werden.</translation>
    </message>
    <message>
        <source>Without a position the columns are shown, but stops and errors are not looked for.</source>
        <translation>Ohne Position werden die Spalten gezeigt, aber keine Stillstände und Fehler gesucht.</translation>
    </message>
    <message>
        <source>Unit of the numbers in the file</source>
        <translation>Einheit der Zahlen in der Datei</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Einheit von %1</translation>
    </message>
    <message>
        <source>What this column is; without a meaning it is shown as it is</source>
        <translation>Was diese Spalte ist; ohne Bedeutung wird sie gezeigt, wie sie ist</translation>
    </message>
    <message>
        <source>Meaning of %1</source>
        <translation>Bedeutung von %1</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Place of the first sample on the time axis that several files share</source>
        <translation>Stelle des ersten Werts auf der gemeinsamen Zeitachse mehrerer Dateien</translation>
    </message>
    <message>
        <source>First sample at</source>
        <translation>Erster Wert bei</translation>
    </message>
    <message>
        <source>For a table without a column of time</source>
        <translation>Für eine Tabelle ohne Zeitspalte</translation>
    </message>
    <message>
        <source>First values</source>
        <translation>Erste Werte</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Means</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Spalten der Datei</translation>
    </message>
    <message>
        <source>What do the columns mean? The answer is kept for all files with the same headings.</source>
        <translation>Was bedeuten die Spalten? Die Antwort gilt für alle Dateien mit denselben Überschriften.</translation>
    </message>
    <message>
        <source>Columns of %1</source>
        <translation>Spalten von %1</translation>
    </message>
    <message>
        <source>Samples per second</source>
        <translation>Werte pro Sekunde</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CommissioningPage</name>
    <message>
        <source>First R-parameter</source>
        <translation>Erster R-Parameter</translation>
    </message>
    <message>
        <source>First R-parameter of the test</source>
        <translation>Erster R-Parameter des Tests</translation>
    </message>
    <message>
        <source>Nobody else uses R%1 to R%2</source>
        <translation>Niemand sonst benutzt R%1 bis R%2</translation>
    </message>
    <message>
        <source>I bring the program to the control myself</source>
        <translation>Ich bringe das Programm selbst auf die Steuerung</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Test starten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Test program</source>
        <translation>Testprogramm</translation>
    </message>
    <message>
        <source>1. Bring the channel to reset, in AUTO.</source>
        <translation>1. Den Kanal in Reset bringen, in AUTO.</translation>
    </message>
    <message>
        <source>2. Store the text below as part program %1 and select it.</source>
        <translation>2. Den Text unten als Teileprogramm %1 speichern und anwählen.</translation>
    </message>
    <message>
        <source>2. The program %1 is transferred, read back and selected.</source>
        <translation>2. Das Programm %1 wird übertragen, zurückgelesen und angewählt.</translation>
    </message>
    <message>
        <source>3. Press cycle start at the control (a virtual machine starts by itself).</source>
        <translation>3. An der Steuerung NC-Start drücken (eine virtuelle Maschine startet von selbst).</translation>
    </message>
    <message>
        <source>Waiting for cycle start</source>
        <translation>Wartet auf NC-Start</translation>
    </message>
    <message>
        <source>The test is in progress</source>
        <translation>Der Test läuft</translation>
    </message>
    <message>
        <source>Tested with another version of the server: test it again</source>
        <translation>Mit einer anderen Version des Servers getestet: bitte erneut testen</translation>
    </message>
    <message>
        <source>Confirm the R-parameters first.</source>
        <translation>Zuerst die R-Parameter bestätigen.</translation>
    </message>
    <message>
        <source>Way of the axis, mm</source>
        <translation>Weg der Achse, mm</translation>
    </message>
    <message>
        <source>Feed of the axis, mm/min</source>
        <translation>Vorschub der Achse, mm/min</translation>
    </message>
    <message>
        <source>by, mm</source>
        <translation>um, mm</translation>
    </message>
    <message>
        <source>F, mm/min</source>
        <translation>F, mm/min</translation>
    </message>
    <message>
        <source>Clear the way of the axis, then type %1.</source>
        <translation>Den Weg der Achse freimachen, dann %1 eintippen.</translation>
    </message>
    <message>
        <source>Nothing is in its way: %1</source>
        <translation>Nichts ist ihr im Weg: %1</translation>
    </message>
    <message>
        <source>Waiting for cycle start, once more</source>
        <translation>Wartet noch einmal auf NC-Start</translation>
    </message>
    <message>
        <source>%1, %2, tested %3; %4</source>
        <translation>%1, %2, getestet %3; %4</translation>
    </message>
    <message>
        <source>An axis moves in the air</source>
        <translation>Eine Achse fährt in der Luft</translation>
    </message>
    <message>
        <source>Axis that moves</source>
        <translation>Achse, die fährt</translation>
    </message>
    <message>
        <source>Confirm that the axis may move</source>
        <translation>Bestätigen, dass die Achse fahren darf</translation>
    </message>
    <message>
        <source>Lift of the tool, mm</source>
        <translation>Abhub des Werkzeugs, mm</translation>
    </message>
    <message>
        <source>While the axis is held, the tool is lifted along Z by so much and comes back; 0: it is not lifted. A run may lift the tool only after that. Not with Z as the axis.</source>
        <translation>Während die Achse angehalten ist, wird das Werkzeug entlang Z um so viel abgehoben und kommt zurück; 0: Es wird nicht abgehoben. Erst danach darf ein Lauf das Werkzeug abheben. Nicht mit Z als Achse.</translation>
    </message>
    <message>
        <source>lift, mm</source>
        <translation>Abhub, mm</translation>
    </message>
    <message>
        <source>One block a line, as a program has it: S500 M3, M8, T1 M6</source>
        <translation>Ein Satz je Zeile, wie er im Programm steht: S500 M3, M8, T1 M6</translation>
    </message>
    <message>
        <source>Blocks to be tried</source>
        <translation>Zu erprobende Sätze</translation>
    </message>
    <message>
        <source>2. The programs of the job are transferred, read back and selected.</source>
        <translation>2. Die Programme des Auftrags werden übertragen, zurückgelesen und angewählt.</translation>
    </message>
    <message>
        <source>the control shows nothing of it; not released</source>
        <translation>die Steuerung zeigt davon nichts; nicht freigegeben</translation>
    </message>
    <message>
        <source>seen by the operator</source>
        <translation>vom Bediener gesehen</translation>
    </message>
    <message>
        <source>I have seen it</source>
        <translation>Ich habe es gesehen</translation>
    </message>
    <message>
        <source>Blocks to be tried, one a line: S500 M3</source>
        <translation>Zu erprobende Sätze, einer je Zeile: S500 M3</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ComparePanel</name>
    <message>
        <source>Open two traces or more to compare them.</source>
        <translation>Zum Vergleichen zwei oder mehr Aufzeichnungen öffnen.</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>Vergleicht …</translation>
    </message>
    <message>
        <source>Each run has the length that it moved itself. With their NC program open, the runs are compared at the same places of the program.</source>
        <translation>Jeder Lauf hat die Weglänge, die er selbst gefahren ist. Ist das NC-Programm geöffnet, werden die Läufe an denselben Stellen des Programms verglichen.</translation>
    </message>
    <message>
        <source>Differences from %1</source>
        <translation>Unterschiede zu %1</translation>
    </message>
    <message>
        <source>%1
%2 minus %3: largest %4 at %5, mean %6, RMS %7</source>
        <translation>%1
%2 minus %3: größter %4 bei %5, Mittel %6, Effektivwert %7</translation>
    </message>
    <message>
        <source>Compare at the same</source>
        <translation>Vergleichen bei gleicher</translation>
    </message>
    <message>
        <source>Axis of the comparison</source>
        <translation>Achse des Vergleichs</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>length of path</source>
        <translation>Weglänge</translation>
    </message>
    <message>
        <source>point of the program</source>
        <translation>Programmstelle (Punkt)</translation>
    </message>
    <message>
        <source>Show the differences as curves</source>
        <translation>Unterschiede als Kurven zeigen</translation>
    </message>
    <message>
        <source>Each pane shows the other traces minus the first one</source>
        <translation>Jedes Feld zeigt die anderen Aufzeichnungen minus die erste</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>At</source>
        <translation>Bei</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektivwert</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ConnectionPanel</name>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>OPC UA endpoint</source>
        <translation>OPC-UA-Endpunkt</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Kanal</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Angewählt</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Virtual machine: no real axis moves</source>
        <translation>Virtuelle Maschine: keine echte Achse bewegt sich</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Aktiv</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation>Unbekannt (%1)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keiner</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ControlFields</name>
    <message>
        <source>Map of the control</source>
        <translation>Zuordnung der Steuerung</translation>
    </message>
    <message>
        <source>Maps (*.toml)</source>
        <translation>Zuordnungen (*.toml)</translation>
    </message>
    <message>
        <source>The control is no SINUMERIK</source>
        <translation>Die Steuerung ist keine SINUMERIK</translation>
    </message>
    <message>
        <source>File with the map (.toml). It is remembered for this machine.</source>
        <translation>Datei mit der Zuordnung (.toml). Sie wird für diese Maschine gemerkt.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Which library connects with the machine. Qt OPC UA is slower, does not encrypt, and takes no map and no user.</source>
        <translation>Mit welcher Bibliothek die Maschine verbunden wird. Qt OPC UA ist langsamer, verschlüsselt nicht und nimmt weder Zuordnung noch Benutzer.</translation>
    </message>
    <message>
        <source>A map says under which names this control has its memory, axes and states. rivulet-cli map proposes one.</source>
        <translation>Eine Zuordnung sagt, unter welchen Namen diese Steuerung ihren Speicher, ihre Achsen und Zustände hat. rivulet-cli map schlägt eine vor.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CorrectionPanel</name>
    <message>
        <source>UDP port %1 cannot be opened: choose another.</source>
        <translation>UDP-Port %1 lässt sich nicht öffnen: einen anderen wählen.</translation>
    </message>
    <message>
        <source>Up to ±%1 per axis, during a run.</source>
        <translation>Bis ±%1 je Achse, während eines Laufs.</translation>
    </message>
    <message>
        <source>By hand, up to ±%1 per axis.</source>
        <translation>Von Hand, bis ±%1 je Achse.</translation>
    </message>
    <message>
        <source>The source is silent: its last value is held.</source>
        <translation>Die Quelle sendet nicht: Ihr letzter Wert wird gehalten.</translation>
    </message>
    <message>
        <source>Nothing has been received from the source yet.</source>
        <translation>Von der Quelle wurde noch nichts empfangen.</translation>
    </message>
    <message>
        <source>Receiving from the source. Lines that are not corrections: %1</source>
        <translation>Die Quelle wird empfangen. Zeilen, die keine Korrektur sind: %1</translation>
    </message>
    <message>
        <source>Receiving from the source.</source>
        <translation>Die Quelle wird empfangen.</translation>
    </message>
    <message>
        <source>Online correction</source>
        <translation>Online-Korrektur</translation>
    </message>
    <message>
        <source>confirmed by the control</source>
        <translation>von der Steuerung bestätigt</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Null</translation>
    </message>
    <message>
        <source>Set the correction of all axes to zero, then continue by hand</source>
        <translation>Korrektur aller Achsen auf null setzen, dann von Hand einstellen</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>UDP on this computer</source>
        <translation>UDP auf diesem Rechner</translation>
    </message>
    <message>
        <source>Datagrams to 127.0.0.1 with lines like X 0.01 Y -0.02, in mm</source>
        <translation>Datagramme an 127.0.0.1 mit Zeilen wie X 0.01 Y -0.02, in mm</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Silent after</source>
        <translation>Stille nach</translation>
    </message>
    <message>
        <source>Correction of %1</source>
        <translation>Korrektur von %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CursorPanel</name>
    <message>
        <source>A %1, B %2, B − A %3</source>
        <translation>A %1, B %2, B − A %3</translation>
    </message>
    <message>
        <source>A %1</source>
        <translation>A %1</translation>
    </message>
    <message>
        <source>B %1</source>
        <translation>B %1</translation>
    </message>
    <message>
        <source>A click on a curve sets cursor A, with Shift cursor B.</source>
        <translation>Ein Klick auf eine Kurve setzt Cursor A, mit Umschalt Cursor B.</translation>
    </message>
    <message>
        <source>The trace has no such place.</source>
        <translation>Diese Stelle gibt es in der Aufzeichnung nicht.</translation>
    </message>
    <message>
        <source>Type a number.</source>
        <translation>Eine Zahl eingeben.</translation>
    </message>
    <message>
        <source>At the cursors and between them</source>
        <translation>An den Cursorn und dazwischen</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>Bei A</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>Bei B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Slope, 1/s</source>
        <translation>Steigung, 1/s</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Effektivwert</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95&#xa0;% darunter</translation>
    </message>
    <message>
        <source>99 % below</source>
        <translation>99&#xa0;% darunter</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Gehe zu</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Number of the place to go to</source>
        <translation>Nummer der Stelle</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Los</translation>
    </message>
    <message>
        <source>Slope, 1/mm</source>
        <translation>Steigung, 1/mm</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Steigung</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DescribedMachineBox</name>
    <message>
        <source>Described by the server</source>
        <translation>Vom Server beschrieben</translation>
    </message>
    <message>
        <source>What the server says of its machine by OPC 40001-1 (Machinery) and OPC 40501-1 (Machine Tools). It is read every 10 s, and not while a run is in progress.</source>
        <translation>Was der Server nach OPC 40001-1 (Machinery) und OPC 40501-1 (Machine Tools) über seine Maschine sagt. Es wird alle 10 s gelesen, aber nicht während eines Laufs.</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Hersteller</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Auftrag</translation>
    </message>
    <message>
        <source>%1 (first of %2)</source>
        <translation>%1 (erste von %2)</translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation>%1 von %2 Läufen</translation>
    </message>
    <message>
        <source>runs completed: %1</source>
        <translation>fertige Läufe: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DiagnosticModel</name>
    <message>
        <source>Severity</source>
        <translation>Schweregrad</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Spalte</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Befund</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DistanceChart</name>
    <message>
        <source>%1 … %2: %3 distances</source>
        <translation>%1 … %2: %3 Abstände</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::EmulatorPage</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Wozu</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>NC program</source>
        <translation>NC-Programm</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>nicht nötig</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Samples per s</source>
        <translation>Werte je s</translation>
    </message>
    <message>
        <source>Largest feed</source>
        <translation>Größter Vorschub</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervall</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Bedeutung</translation>
    </message>
    <message>
        <source>Position RMS, µm</source>
        <translation>Position RMS, µm</translation>
    </message>
    <message>
        <source>at most, µm</source>
        <translation>höchstens, µm</translation>
    </message>
    <message>
        <source>Contour RMS, µm</source>
        <translation>Kontur RMS, µm</translation>
    </message>
    <message>
        <source>emulated, µm</source>
        <translation>emuliert, µm</translation>
    </message>
    <message>
        <source>Speed, %</source>
        <translation>Geschw.,&#xa0;%</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Datei…</translation>
    </message>
    <message>
        <source>Add recordings</source>
        <translation>Aufzeichnungen hinzufügen</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>NC program of %1</source>
        <translation>NC-Programm von %1</translation>
    </message>
    <message>
        <source>Preset of the machine</source>
        <translation>Vorgabe der Maschine</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Als Vorgabe speichern</translation>
    </message>
    <message>
        <source>Use to learn</source>
        <translation>Zum Lernen</translation>
    </message>
    <message>
        <source>Use to test</source>
        <translation>Zum Prüfen</translation>
    </message>
    <message>
        <source>Nothing is learned yet.</source>
        <translation>Noch ist nichts gelernt.</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Liest %1 …</translation>
    </message>
    <message>
        <source>%1 has no set points: choose its NC program.</source>
        <translation>%1 hat keine Sollwerte: ihr NC-Programm wählen.</translation>
    </message>
    <message>
        <source>Record a few programs with different feeds, corners and reversals, and add the recordings here.</source>
        <translation>Einige Programme mit verschiedenen Vorschüben, Ecken und Umkehrungen aufzeichnen und die Aufzeichnungen hier hinzufügen.</translation>
    </message>
    <message>
        <source>All recordings are used to test: use one to learn.</source>
        <translation>Alle Aufzeichnungen sind zum Prüfen: eine zum Lernen nehmen.</translation>
    </message>
    <message>
        <source>Learning axis %1: %2 of %3 models tried, the best is right within %4.</source>
        <translation>Lernt Achse %1: %2 von %3 Modellen probiert, das beste stimmt auf %4.</translation>
    </message>
    <message>
        <source>Learning …</source>
        <translation>Lernt …</translation>
    </message>
    <message>
        <source>Saved as %1. Give it to the virtual machine as its preset.</source>
        <translation>Gespeichert als %1. Der virtuellen Maschine als Vorgabe geben.</translation>
    </message>
    <message>
        <source>Learned and tested. Save it as a preset to use it.</source>
        <translation>Gelernt und geprüft. Zum Benutzen als Vorgabe speichern.</translation>
    </message>
    <message>
        <source>Ready to learn. Recordings used to test show how good the emulator is on programs it has not seen.</source>
        <translation>Bereit zu lernen. Aufzeichnungen zum Prüfen zeigen, wie gut der Emulator bei unbekannten Programmen ist.</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Hinzufügen…</translation>
    </message>
    <message>
        <source>Add recordings of the machine</source>
        <translation>Aufzeichnungen der Maschine hinzufügen</translation>
    </message>
    <message>
        <source>Learn from the recordings how the axes follow their set points</source>
        <translation>Aus den Aufzeichnungen lernen, wie die Achsen ihren Sollwerten folgen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop learning; what was learned before stays</source>
        <translation>Das Lernen beenden; was vorher gelernt wurde, bleibt</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save the emulator as a preset of the virtual machine</source>
        <translation>Den Emulator als Vorgabe der virtuellen Maschine speichern</translation>
    </message>
    <message>
        <source>NC program…</source>
        <translation>NC-Programm…</translation>
    </message>
    <message>
        <source>The program that ran: needed for a recording without set points</source>
        <translation>Das Programm, das lief: nötig für eine Aufzeichnung ohne Sollwerte</translation>
    </message>
    <message>
        <source>A recording used to test is not learned from</source>
        <translation>Aus einer Aufzeichnung zum Prüfen wird nicht gelernt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes the recording from the list; the file stays</source>
        <translation>Nimmt die Aufzeichnung aus der Liste; die Datei bleibt</translation>
    </message>
    <message>
        <source>Bode and step plots</source>
        <translation>Bode und Sprungantwort</translation>
    </message>
    <message>
        <source>For those who know control engineering</source>
        <translation>Für Kenner der Regelungstechnik</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>What recordings do not say</source>
        <translation>Was Aufzeichnungen nicht sagen</translation>
    </message>
    <message>
        <source>Preset that has the limits of the machine; set points of programs are planned with them</source>
        <translation>Vorgabe mit den Grenzen der Maschine; mit ihnen werden Sollwerte aus Programmen geplant</translation>
    </message>
    <message>
        <source>Models tried</source>
        <translation>Probierte Modelle</translation>
    </message>
    <message>
        <source>Error, µm</source>
        <translation>Fehler, µm</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Enter changes the use of a recording</source>
        <translation>Eingabe ändert, wozu eine Aufzeichnung dient</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Prüfungen</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Part of the page</source>
        <translation>Teil der Seite</translation>
    </message>
    <message>
        <source>How far an emulator is off that was learned from one recording alone.</source>
        <translation>Wie weit ein Emulator danebenliegt, der aus nur einer Aufzeichnung gelernt wurde.</translation>
    </message>
    <message>
        <source>Learns from each recording alone and tests on all others. So you see which recordings teach most, and what each parameter is worth.</source>
        <translation>Lernt aus jeder Aufzeichnung allein und prüft an allen anderen. So zeigt sich, welche Aufzeichnungen am meisten lehren und was jeder Parameter wert ist.</translation>
    </message>
    <message>
        <source>How much the positions would change on each recording if a parameter were 10 % larger.</source>
        <translation>Wie stark sich die Positionen auf jeder Aufzeichnung ändern würden, wenn ein Parameter um 10&#xa0;% größer wäre.</translation>
    </message>
    <message>
        <source>Learning from each recording alone …</source>
        <translation>Lernt aus jeder Aufzeichnung allein …</translation>
    </message>
    <message>
        <source>Compare recordings</source>
        <translation>Aufzeichnungen vergleichen</translation>
    </message>
    <message>
        <source>Takes at most as long as learning, for each recording</source>
        <translation>Dauert für jede Aufzeichnung höchstens so lange wie das Lernen</translation>
    </message>
    <message>
        <source>Matrix of errors</source>
        <translation>Matrix der Fehler</translation>
    </message>
    <message>
        <source>Tested on</source>
        <translation>Geprüft an</translation>
    </message>
    <message>
        <source>Learned from (error RMS in µm)</source>
        <translation>Gelernt aus (Fehler RMS in µm)</translation>
    </message>
    <message>
        <source>Worth of the parameters</source>
        <translation>Wert der Parameter</translation>
    </message>
    <message>
        <source>Change of the positions, RMS, µm</source>
        <translation>Änderung der Positionen, RMS, µm</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>On parts that were held out while learning (RMS): %1. A recording used to test was not learned from at all.</source>
        <translation>An Teilen, die beim Lernen zurückgehalten wurden (RMS): %1. Aus einer Aufzeichnung zum Prüfen wurde gar nichts gelernt.</translation>
    </message>
    <message>
        <source>Error on parts held out, while learning</source>
        <translation>Fehler an zurückgehaltenen Teilen beim Lernen</translation>
    </message>
    <message>
        <source>none: what the model leaves is not chance</source>
        <translation>keine: Was das Modell übrig lässt, ist kein Zufall</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FactorPanel</name>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>Smallest factor of your override that may act</source>
        <translation>Kleinster Faktor auf Ihren Override, der wirken darf</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Largest factor that may act; together with your override no more than 120 % of the programmed feed</source>
        <translation>Größter Faktor, der wirken darf; mit Ihrem Override zusammen höchstens 120&#xa0;% des programmierten Vorschubs</translation>
    </message>
    <message>
        <source>Silent after</source>
        <translation>Stille nach</translation>
    </message>
    <message>
        <source>Without a factor</source>
        <translation>Ohne Faktor</translation>
    </message>
    <message>
        <source>Before the first one, when the source is silent or closed, and when it sends what was not agreed</source>
        <translation>Vor dem ersten, wenn die Quelle still oder geschlossen ist, und wenn sie sendet, was nicht vereinbart war</translation>
    </message>
    <message>
        <source>Your override acts alone.</source>
        <translation>Nur Ihr Override wirkt.</translation>
    </message>
    <message>
        <source>It is read from the start on. Nothing moves before its first factor.</source>
        <translation>Sie wird ab dem Start gelesen. Vor ihrem ersten Faktor bewegt sich nichts.</translation>
    </message>
    <message>
        <source>It is read from the start on.</source>
        <translation>Sie wird ab dem Start gelesen.</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Adaptiver Vorschub</translation>
    </message>
    <message>
        <source>A sensor or script that sends lines such as feed 0.85: 85 % of your override, until the next one. Pause and Stop always act.</source>
        <translation>Ein Sensor oder Skript, das Zeilen wie feed 0.85 sendet: 85&#xa0;% Ihres Overrides, bis zur nächsten. Pause und Stopp wirken immer.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>TCP on this computer</source>
        <translation>TCP auf diesem Rechner</translation>
    </message>
    <message>
        <source>UDP on this computer</source>
        <translation>UDP auf diesem Rechner</translation>
    </message>
    <message>
        <source>Hold the axes</source>
        <translation>Achsen halten</translation>
    </message>
    <message>
        <source>Your override alone</source>
        <translation>Nur Ihr Override</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FeasibilityPage</name>
    <message>
        <source>F over d_min</source>
        <translation>F über d_min</translation>
    </message>
    <message>
        <source>F over N</source>
        <translation>F über N</translation>
    </message>
    <message>
        <source>F over δ</source>
        <translation>F über δ</translation>
    </message>
    <message>
        <source>Load a program to see where it can be streamed.</source>
        <translation>Ein Programm laden, um zu sehen, wo es streambar ist.</translation>
    </message>
    <message>
        <source>Drag the ring to change the feed.</source>
        <translation>Den Ring ziehen, um den Vorschub zu ändern.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the feed. Method position does not depend on N.</source>
        <translation>Den Ring ziehen, um N und den Vorschub zu ändern. Das Verfahren Position hängt nicht von N ab.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the feed.</source>
        <translation>Den Ring ziehen, um N und den Vorschub zu ändern.</translation>
    </message>
    <message>
        <source>Drag the ring to change δ and the feed.</source>
        <translation>Den Ring ziehen, um δ und den Vorschub zu ändern.</translation>
    </message>
    <message>
        <source>Operating point</source>
        <translation>Arbeitspunkt</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Machbar</translation>
    </message>
    <message>
        <source>Safety band</source>
        <translation>Sicherheitsband</translation>
    </message>
    <message>
        <source>(1) point distance</source>
        <translation>(1) Punktabstand</translation>
    </message>
    <message>
        <source>(2) distance δ</source>
        <translation>(2) Abstand δ</translation>
    </message>
    <message>
        <source>(3) half a loop</source>
        <translation>(3) halbe Schleife</translation>
    </message>
    <message>
        <source>(3) half a loop, for information</source>
        <translation>(3) halbe Schleife, zur Information</translation>
    </message>
    <message>
        <source>(3ᴺ) half a loop, real path</source>
        <translation>(3ᴺ) halbe Schleife, wirkliche Bahn</translation>
    </message>
    <message>
        <source>dashed: as published</source>
        <translation>gestrichelt: wie veröffentlicht</translation>
    </message>
    <message>
        <source>Smallest distances of the program</source>
        <translation>Kleinste Abstände des Programms</translation>
    </message>
    <message>
        <source>Simulate around the operating point</source>
        <translation>Um den Arbeitspunkt simulieren</translation>
    </message>
    <message>
        <source>Simulating: %p %</source>
        <translation>Simulation läuft: %p %</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Simulated on the virtual machine, %1 points around the tightest place.</source>
        <translation>Simuliert auf der virtuellen Maschine, %1 Punkte um die engste Stelle.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Sometimes fails</source>
        <translation>Schlägt manchmal fehl</translation>
    </message>
    <message>
        <source>Always fails</source>
        <translation>Schlägt immer fehl</translation>
    </message>
    <message>
        <source>Model: 0.1 % to 50 % fail</source>
        <translation>Modell: 0,1 % bis 50 % schlagen fehl</translation>
    </message>
    <message>
        <source>This method does not use δ: the limits do not depend on it.</source>
        <translation>Dieses Verfahren benutzt δ nicht: Die Grenzen hängen nicht davon ab.</translation>
    </message>
    <message>
        <source>Without waiting</source>
        <translation>Ohne Warten</translation>
    </message>
    <message>
        <source>reach: the client keeps up</source>
        <translation>Reichweite: Der Client kommt mit</translation>
    </message>
    <message>
        <source>Runs failed in the simulation</source>
        <translation>In der Simulation scheiterten Läufe</translation>
    </message>
    <message>
        <source>Override over t_min</source>
        <translation>Override über t_min</translation>
    </message>
    <message>
        <source>Override over N</source>
        <translation>Override über N</translation>
    </message>
    <message>
        <source>Override over δ</source>
        <translation>Override über δ</translation>
    </message>
    <message>
        <source>Drag the ring to change the override on the feeds of the program.</source>
        <translation>Den Ring ziehen, um den Override auf die Vorschübe des Programms zu ändern.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the override.</source>
        <translation>Den Ring ziehen, um N und den Override zu ändern.</translation>
    </message>
    <message>
        <source>Largest override: %1.</source>
        <translation>Größter Override: %1.</translation>
    </message>
    <message>
        <source>Shortest moves of the program</source>
        <translation>Kürzeste Bewegungen des Programms</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FileBanner</name>
    <message>
        <source>The file %1 has changed.</source>
        <translation>Die Datei %1 hat sich geändert.</translation>
    </message>
    <message>
        <source>The file %1 is no longer there.</source>
        <translation>Die Datei %1 ist nicht mehr da.</translation>
    </message>
    <message>
        <source>The run keeps version %1.</source>
        <translation>Der Lauf behält Fassung %1.</translation>
    </message>
    <message>
        <source>Reload it?</source>
        <translation>Neu laden?</translation>
    </message>
    <message>
        <source>Version %1 stays loaded.</source>
        <translation>Fassung %1 bleibt geladen.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FileField</name>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Choose the file: %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FitModel</name>
    <message>
        <source>write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Zugriff</translation>
    </message>
    <message>
        <source>Per request (a)</source>
        <translation>Je Anfrage (a)</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Per R-parameter (b)</source>
        <translation>Je R-Parameter (b)</translation>
    </message>
    <message>
        <source>± of b</source>
        <translation>± von b</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FoundRunBar</name>
    <message>
        <source>It can be resumed on the computer where it was started.</source>
        <translation>Er kann an dem Rechner fortgesetzt werden, an dem er gestartet wurde.</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Beobachten</translation>
    </message>
    <message>
        <source>Shows program, position and progress. Nothing is changed.</source>
        <translation>Zeigt Programm, Position und Fortschritt. Es wird nichts verändert.</translation>
    </message>
    <message>
        <source>Stop the run</source>
        <translation>Lauf stoppen</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Fortsetzen …</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>The axes stand at once, whoever started the run.</source>
        <translation>Die Achsen stehen sofort, wer auch immer den Lauf gestartet hat.</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Hier beenden</translation>
    </message>
    <message>
        <source>The axes go on to the end of the window, or of the block of the control, and the program ends there.</source>
        <translation>Die Achsen fahren bis zum Ende des Fensters oder des Satzes der Steuerung, und dort endet das Programm.</translation>
    </message>
    <message>
        <source>Stop requested: still moving, at most %1, about %2</source>
        <translation>Stopp angefordert: fährt noch, höchstens %1, etwa %2</translation>
    </message>
    <message>
        <source>Stop requested, not yet confirmed</source>
        <translation>Stopp angefordert, noch nicht bestätigt</translation>
    </message>
    <message>
        <source>Loads the program, compares it and asks the control where the run was left. Nothing moves yet.</source>
        <translation>Lädt das Programm, vergleicht es und fragt die Steuerung, wo der Lauf verlassen wurde. Noch bewegt sich nichts.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::HelpPage</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Handbuch</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::HistogramChart</name>
    <message>
        <source>Duration, ms</source>
        <translation>Dauer, ms</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>%1 %: %2</source>
        <translation>%1 %: %2</translation>
    </message>
    <message>
        <source>%1 beyond, the longest %2</source>
        <translation>%1 darüber, die längste %2</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LayoutMenu</name>
    <message>
        <source>No layout is kept yet</source>
        <translation>Noch keine Anordnung abgelegt</translation>
    </message>
    <message>
        <source>Keep the present panes as…</source>
        <translation>Jetzige Felder ablegen als …</translation>
    </message>
    <message>
        <source>New traces are shown in</source>
        <translation>Neue Aufzeichnungen zeigen in</translation>
    </message>
    <message>
        <source>the usual panes</source>
        <translation>den üblichen Feldern</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Keep the panes</source>
        <translation>Felder ablegen</translation>
    </message>
    <message>
        <source>Name of the layout; one of the same name is replaced</source>
        <translation>Name der Anordnung; eine gleichen Namens wird ersetzt</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LinesChart</name>
    <message>
        <source>Duration, ms</source>
        <translation>Dauer, ms</translation>
    </message>
    <message>
        <source>write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>R-parameters of the request</source>
        <translation>R-Parameter der Anfrage</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LiveDialog</name>
    <message>
        <source>Live points</source>
        <translation>Live-Punkte</translation>
    </message>
    <message>
        <source>A program or script computes the path while the machine moves and sends its points as lines, such as X1.5 Y2 F500. Nothing moves that is outside what is agreed here.</source>
        <translation>Ein Programm oder Skript berechnet die Bahn, während die Maschine fährt, und sendet ihre Punkte als Zeilen wie X1.5 Y2 F500. Nichts bewegt sich außerhalb dessen, was hier vereinbart ist.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Listens from now on. Nothing moves before the start.</source>
        <translation>Hört von jetzt an zu. Vor dem Start bewegt sich nichts.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>TCP port of this computer</source>
        <translation>TCP-Port dieses Rechners</translation>
    </message>
    <message>
        <source>UDP port of this computer</source>
        <translation>UDP-Port dieses Rechners</translation>
    </message>
    <message>
        <source>UNIX socket</source>
        <translation>UNIX-Socket</translation>
    </message>
    <message>
        <source>Standard input of this window</source>
        <translation>Standardeingabe dieses Fensters</translation>
    </message>
    <message>
        <source>0: any that is free</source>
        <translation>0: irgendein freier</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>File name of the socket, which only this user can write to</source>
        <translation>Dateiname des Sockets; nur dieser Benutzer kann hineinschreiben</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Pfad</translation>
    </message>
    <message>
        <source>Box of all points</source>
        <translation>Quader aller Punkte</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Least coordinate, workpiece frame</source>
        <translation>Kleinste Koordinate, Werkstückkoordinaten</translation>
    </message>
    <message>
        <source>Largest coordinate, workpiece frame</source>
        <translation>Größte Koordinate, Werkstückkoordinaten</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 von</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 bis</translation>
    </message>
    <message>
        <source>Agreed with the source</source>
        <translation>Mit der Quelle vereinbart</translation>
    </message>
    <message>
        <source>First point within</source>
        <translation>Erster Punkt innerhalb</translation>
    </message>
    <message>
        <source>Largest distance of the first point from the tool</source>
        <translation>Größter Abstand des ersten Punkts vom Werkzeug</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Größter Schritt</translation>
    </message>
    <message>
        <source>Largest distance of two points</source>
        <translation>Größter Abstand zweier Punkte</translation>
    </message>
    <message>
        <source>Largest F</source>
        <translation>Größtes F</translation>
    </message>
    <message>
        <source>It is also the feed of points before the first F.</source>
        <translation>Es ist auch der Vorschub der Punkte vor dem ersten F.</translation>
    </message>
    <message>
        <source>Merge below</source>
        <translation>Zusammenfassen unter</translation>
    </message>
    <message>
        <source>Points that are closer are merged with the one before.</source>
        <translation>Nähere Punkte werden mit dem vorigen zusammengefasst.</translation>
    </message>
    <message>
        <source>Largest turn</source>
        <translation>Größte Drehung</translation>
    </message>
    <message>
        <source>Largest turn of a rotary axis between two points</source>
        <translation>Größte Drehung einer Rundachse zwischen zwei Punkten</translation>
    </message>
    <message>
        <source>Points may turn this axis (method window).</source>
        <translation>Punkte dürfen diese Achse drehen (Verfahren Fenster).</translation>
    </message>
    <message>
        <source>Rotary axis %1</source>
        <translation>Rundachse %1</translation>
    </message>
    <message>
        <source>Rotary axes</source>
        <translation>Rundachsen</translation>
    </message>
    <message>
        <source>When no points come</source>
        <translation>Wenn keine Punkte kommen</translation>
    </message>
    <message>
        <source>Window within</source>
        <translation>Fenster binnen</translation>
    </message>
    <message>
        <source>A window that is not full is sent after this time.</source>
        <translation>Ein Fenster, das nicht voll ist, wird nach dieser Zeit gesendet.</translation>
    </message>
    <message>
        <source>Hold after</source>
        <translation>Halt nach</translation>
    </message>
    <message>
        <source>After this much silence the run holds; it goes on with the next point.</source>
        <translation>Nach so langem Schweigen hält der Lauf; er geht mit dem nächsten Punkt weiter.</translation>
    </message>
    <message>
        <source>End after</source>
        <translation>Ende nach</translation>
    </message>
    <message>
        <source>After this much silence the run ends with an error.</source>
        <translation>Nach so langem Schweigen endet der Lauf mit einem Fehler.</translation>
    </message>
    <message>
        <source>Variables of an OPC UA server</source>
        <translation>Variablen eines OPC-UA-Servers</translation>
    </message>
    <message>
        <source>To ports and sockets, only programs on this computer can send.</source>
        <translation>An Ports und Sockets können nur Programme auf diesem Rechner senden.</translation>
    </message>
    <message>
        <source>This file names the server and its variables (TOML).</source>
        <translation>Diese Datei nennt den Server und seine Variablen (TOML).</translation>
    </message>
    <message>
        <source>File of the source</source>
        <translation>Datei der Quelle</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Choose the file of the source</source>
        <translation>Datei der Quelle wählen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Sources (*.toml);;All files (*)</source>
        <translation>Quellen (*.toml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Around the tool</source>
        <translation>Um das Werkzeug</translation>
    </message>
    <message>
        <source>Puts a box of this size around the place where the tool stands.</source>
        <translation>Legt einen Quader dieser Größe um die Stelle, an der das Werkzeug steht.</translation>
    </message>
    <message>
        <source>Where the tool stands is not known.</source>
        <translation>Wo das Werkzeug steht, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>The tool stands at %1.</source>
        <translation>Das Werkzeug steht bei %1.</translation>
    </message>
    <message>
        <source>The tool stands at %1, so far outside that no first point can be in the box.</source>
        <translation>Das Werkzeug steht bei %1, so weit außerhalb, dass kein erster Punkt im Quader liegen kann.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LivePanel</name>
    <message>
        <source>It is read as soon as the control runs the program.</source>
        <translation>Sie wird gelesen, sobald die Steuerung das Programm ausführt.</translation>
    </message>
    <message>
        <source>The run has ended. It listens for the next one.</source>
        <translation>Der Lauf ist zu Ende. Die Quelle wartet auf den nächsten.</translation>
    </message>
    <message>
        <source>Listening. Nothing is read before the start.</source>
        <translation>Hört zu. Vor dem Start wird nichts gelesen.</translation>
    </message>
    <message>
        <source>Waiting for the first line, for %1</source>
        <translation>Wartet seit %1 auf die erste Zeile</translation>
    </message>
    <message>
        <source>Receiving</source>
        <translation>Empfängt</translation>
    </message>
    <message>
        <source>Silent for %1; %2</source>
        <translation>Schweigt seit %1; %2</translation>
    </message>
    <message>
        <source>Ended by the source</source>
        <translation>Von der Quelle beendet</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 von %2 Punkten</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Live points …</source>
        <translation>Live-Punkte …</translation>
    </message>
    <message>
        <source>Another source, or something else agreed with it</source>
        <translation>Andere Quelle oder andere Vereinbarung</translation>
    </message>
    <message>
        <source>Open program …</source>
        <translation>Programm öffnen …</translation>
    </message>
    <message>
        <source>A program takes the place of the live source.</source>
        <translation>Ein Programm tritt an die Stelle der Live-Quelle.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Agreed with the source</source>
        <translation>Mit der Quelle vereinbart</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Puffer</translation>
    </message>
    <message>
        <source>Points that have arrived and are not executed. When it is full, the source is made to wait.</source>
        <translation>Punkte, die angekommen und nicht ausgeführt sind. Ist er voll, muss die Quelle warten.</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Angenommen</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ausgeführt</translation>
    </message>
    <message>
        <source>Merged</source>
        <translation>Vereint</translation>
    </message>
    <message>
        <source>Delay, median</source>
        <translation>Verzug, Median</translation>
    </message>
    <message>
        <source>Delay, 99 %</source>
        <translation>Verzug, 99&#xa0;%</translation>
    </message>
    <message>
        <source>In theory</source>
        <translation>Theoretisch</translation>
    </message>
    <message>
        <source>Points from the source, mean of the last two seconds</source>
        <translation>Punkte von der Quelle, Mittel der letzten zwei Sekunden</translation>
    </message>
    <message>
        <source>Points executed, mean of the last two seconds</source>
        <translation>Ausgeführte Punkte, Mittel der letzten zwei Sekunden</translation>
    </message>
    <message>
        <source>Points of the source within the agreed limits</source>
        <translation>Punkte der Quelle innerhalb der vereinbarten Grenzen</translation>
    </message>
    <message>
        <source>Points that are known to be executed</source>
        <translation>Punkte, die sicher ausgeführt sind</translation>
    </message>
    <message>
        <source>Points too close to the one before, which are left out</source>
        <translation>Punkte zu nahe am vorigen, die weggelassen werden</translation>
    </message>
    <message>
        <source>From the arrival of a point to the beginning of its move; during a run, of the last 500 points</source>
        <translation>Von der Ankunft eines Punkts bis zum Beginn seiner Bewegung; während eines Laufs der letzten 500 Punkte</translation>
    </message>
    <message>
        <source>Of a hundred points, one was later than this.</source>
        <translation>Von hundert Punkten kam einer später.</translation>
    </message>
    <message>
        <source>Least delay, and the delay when all buffers are full</source>
        <translation>Kleinster Verzug, und der Verzug, wenn alle Puffer voll sind</translation>
    </message>
    <message>
        <source>First point within</source>
        <translation>Erster Punkt innerhalb</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Größter Schritt</translation>
    </message>
    <message>
        <source>Largest F</source>
        <translation>Größtes F</translation>
    </message>
    <message>
        <source>Merge below</source>
        <translation>Zusammenfassen unter</translation>
    </message>
    <message>
        <source>When it is silent</source>
        <translation>Wenn sie schweigt</translation>
    </message>
    <message>
        <source>Send lines such as X1.5 Y2 F500 to 127.0.0.1, port %1. The line “end” ends the run.</source>
        <translation>Zeilen wie X1.5 Y2 F500 an 127.0.0.1, Port %1, senden. Die Zeile „end“ beendet den Lauf.</translation>
    </message>
    <message>
        <source>Send lines such as X1.5 Y2 F500 to it. The line “end” ends the run.</source>
        <translation>Zeilen wie X1.5 Y2 F500 an sie senden. Die Zeile „end“ beendet den Lauf.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LoadBar</name>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogInDialog</name>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>Delete the last digit</source>
        <translation>Letzte Ziffer löschen</translation>
    </message>
    <message>
        <source>Wrong PIN. Try again in %1 s.</source>
        <translation>Falsche PIN. Wieder möglich in %1 s.</translation>
    </message>
    <message>
        <source>Wrong PIN.</source>
        <translation>Falsche PIN.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Schweregrad</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogView</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save the messages</source>
        <translation>Meldungen speichern</translation>
    </message>
    <message>
        <source>%1 of %2 messages</source>
        <translation>%1 von %2 Meldungen</translation>
    </message>
    <message>
        <source>All messages</source>
        <translation>Alle Meldungen</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Warnungen und Fehler</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>Nur Fehler</translation>
    </message>
    <message>
        <source>All sources</source>
        <translation>Alle Quellen</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Wrap lines</source>
        <translation>Zeilen umbrechen</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message numerus="yes">
        <source>%Ln messages</source>
        <translation>
            <numerusform>%Ln Meldung</numerusform>
            <numerusform>%Ln Meldungen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LoginFields</name>
    <message>
        <source>This machine lets nobody in without a user. Type user and password.</source>
        <translation>Diese Maschine lässt niemanden ohne Benutzer zu. Benutzer und Passwort eingeben.</translation>
    </message>
    <message>
        <source>Type the password of this user.</source>
        <translation>Das Passwort dieses Benutzers eingeben.</translation>
    </message>
    <message>
        <source>The machine refuses user or password. Check both. After several wrong ones it locks the user for some time.</source>
        <translation>Die Maschine lehnt Benutzer oder Passwort ab. Beides prüfen. Nach mehreren falschen sperrt sie den Benutzer für einige Zeit.</translation>
    </message>
    <message>
        <source>There is no keyring on this computer: the password is asked for each time.</source>
        <translation>Auf diesem Rechner gibt es keinen Schlüsselbund: Das Passwort wird jedes Mal erfragt.</translation>
    </message>
    <message>
        <source>Log in as a user of the machine</source>
        <translation>Als Benutzer der Maschine anmelden</translation>
    </message>
    <message>
        <source>Without it, the connection is anonymous.</source>
        <translation>Sonst ist die Verbindung anonym.</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>User of the OPC UA server, as it is set up on the control.</source>
        <translation>Benutzer des OPC-UA-Servers, wie er auf der Steuerung eingerichtet ist.</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>It is sent encrypted only, and is in no setting, log or recording.</source>
        <translation>Es wird nur verschlüsselt gesendet und steht in keiner Einstellung, keinem Protokoll und keiner Aufzeichnung.</translation>
    </message>
    <message>
        <source>Keep it in the keyring</source>
        <translation>Im Schlüsselbund aufbewahren</translation>
    </message>
    <message>
        <source>The keyring of this computer&apos;s user keeps it encrypted; it is not asked for again.</source>
        <translation>Der Schlüsselbund des Benutzers dieses Rechners bewahrt es verschlüsselt auf; es wird nicht mehr erfragt.</translation>
    </message>
    <message>
        <source>This machine lets nobody in without a user. Choose the user&apos;s certificate.</source>
        <translation>Diese Maschine lässt niemanden ohne Benutzer zu. Zertifikat des Benutzers wählen.</translation>
    </message>
    <message>
        <source>The machine refuses this certificate. Register it for a user on the machine, or choose another one.</source>
        <translation>Die Maschine lehnt dieses Zertifikat ab. Es an der Maschine für einen Benutzer eintragen oder ein anderes wählen.</translation>
    </message>
    <message>
        <source>The user is known by</source>
        <translation>Der Benutzer weist sich aus durch</translation>
    </message>
    <message>
        <source>What the machine asks of its users.</source>
        <translation>Was die Maschine von ihren Benutzern verlangt.</translation>
    </message>
    <message>
        <source>name and password</source>
        <translation>Name und Passwort</translation>
    </message>
    <message>
        <source>a certificate</source>
        <translation>ein Zertifikat</translation>
    </message>
    <message>
        <source>Certificate of the user</source>
        <translation>Zertifikat des Benutzers</translation>
    </message>
    <message>
        <source>PEM or DER. Register it on the machine first. The name of the file is remembered for this machine.</source>
        <translation>PEM oder DER. Zuerst an der Maschine eintragen. Der Dateiname wird für diese Maschine gemerkt.</translation>
    </message>
    <message>
        <source>Key, if it is in another file</source>
        <translation>Schlüssel, falls in eigener Datei</translation>
    </message>
    <message>
        <source>PEM or DER, not locked by a password; only this computer&apos;s user may read the file (mode 0600). The key is not sent.</source>
        <translation>PEM oder DER, nicht durch ein Passwort gesperrt; nur der Benutzer dieses Computers darf die Datei lesen (Modus 0600). Der Schlüssel wird nicht gesendet.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MachineButton</name>
    <message>
        <source>Virtual machine</source>
        <translation>Virtuelle Maschine</translation>
    </message>
    <message>
        <source>%1, silent for %2 s</source>
        <translation>%1, seit %2 s keine Antwort</translation>
    </message>
    <message>
        <source>Connection and state of the machine</source>
        <translation>Verbindung und Zustand der Maschine</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MachinesPage</name>
    <message numerus="yes">
        <source>%Ln virtual machines of this computer do not answer any more, and nothing but their runs is kept.</source>
        <translation>
            <numerusform>%Ln virtuelle Maschine dieses Rechners antwortet nicht mehr, und nur ihre Läufe sind aufbewahrt.</numerusform>
            <numerusform>%Ln virtuelle Maschinen dieses Rechners antworten nicht mehr, und nur ihre Läufe sind aufbewahrt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide them</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <source>One machine at a time is connected with a window. Of the others only the port is looked at, every 30 s while this page is shown: a question would cost them time that another stream may need.</source>
        <translation>Mit einem Fenster ist jeweils eine Maschine verbunden. Bei den anderen wird nur der Port geprüft, alle 30 s, solange diese Seite gezeigt wird: Eine Abfrage würde sie Zeit kosten, die ein anderer Stream vielleicht braucht.</translation>
    </message>
    <message>
        <source>Puts the service with this address on the board.</source>
        <translation>Nimmt den Dienst mit dieser Adresse auf die Tafel.</translation>
    </message>
    <message>
        <source>Asks a discovery server of OPC UA for services: that of the address, or of this computer.</source>
        <translation>Fragt einen Discovery-Server von OPC UA nach Diensten: den der Adresse oder den dieses Rechners.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Services: machines without a window</source>
        <translation>Dienste: Maschinen ohne Fenster</translation>
    </message>
    <message>
        <source>&amp;Address of a service</source>
        <translation>&amp;Adresse eines Dienstes</translation>
    </message>
    <message>
        <source>Address of a service</source>
        <translation>Adresse eines Dienstes</translation>
    </message>
    <message>
        <source>As rivulet-service prints it when it is ready.</source>
        <translation>Wie rivulet-service sie ausgibt, wenn der Dienst bereit ist.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MethodPanel</name>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>N (points per loop)</source>
        <translation>N (Punkte je Schleife)</translation>
    </message>
    <message>
        <source>δ (point reached)</source>
        <translation>δ (Punkt erreicht)</translation>
    </message>
    <message>
        <source>F (path feed)</source>
        <translation>F (Bahnvorschub)</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>R-Parameter</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>Largest feed</source>
        <translation>Größter Vorschub</translation>
    </message>
    <message>
        <source>Limiting place</source>
        <translation>Engste Stelle</translation>
    </message>
    <message>
        <source>Distance from the tool at which a point counts as reached</source>
        <translation>Abstand vom Werkzeug, ab dem ein Punkt als erreicht gilt</translation>
    </message>
    <message>
        <source>Equation (1): the tool must not pass a point between two polls.</source>
        <translation>Gleichung (1): Das Werkzeug darf zwischen zwei Abfragen keinen Punkt überfahren.</translation>
    </message>
    <message>
        <source>Equation (2): the tool must be seen within δ of each point.</source>
        <translation>Gleichung (2): Das Werkzeug muss innerhalb von δ um jeden Punkt gesehen werden.</translation>
    </message>
    <message>
        <source>Equation (3): half a loop must be written before the tool has used it up.</source>
        <translation>Gleichung (3): Eine halbe Schleife muss geschrieben sein, bevor das Werkzeug sie verbraucht hat.</translation>
    </message>
    <message>
        <source>Equation (3) with the real path: half a loop must be written before the tool has used it up.</source>
        <translation>Gleichung (3) mit der wirklichen Bahn: Eine halbe Schleife muss geschrieben sein, bevor das Werkzeug sie verbraucht hat.</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Nicht beurteilt</translation>
    </message>
    <message>
        <source>Load a program to get a verdict.</source>
        <translation>Ein Programm laden, um ein Urteil zu erhalten.</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Machbar</translation>
    </message>
    <message>
        <source>Not feasible</source>
        <translation>Nicht machbar</translation>
    </message>
    <message>
        <source>Closest limit: %1</source>
        <translation>Nächste Grenze: %1</translation>
    </message>
    <message>
        <source>Violated: %1</source>
        <translation>Verletzt: %1</translation>
    </message>
    <message>
        <source>%1 × (must exceed 1)</source>
        <translation>%1 × (muss über 1 liegen)</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>lines %1–%2</source>
        <translation>Zeilen %1–%2</translation>
    </message>
    <message>
        <source>Use δ = %1</source>
        <translation>δ = %1 übernehmen</translation>
    </message>
    <message>
        <source>Use F = %1</source>
        <translation>F = %1 übernehmen</translation>
    </message>
    <message>
        <source>No feed is slow enough: two points of the program nearly coincide.</source>
        <translation>Kein Vorschub ist langsam genug: Zwei Punkte des Programms fallen fast zusammen.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>With gaps (R11, R21 …)</source>
        <translation>Lücken (R11, R21 …)</translation>
    </message>
    <message>
        <source>In a row (R10 …)</source>
        <translation>Fortlaufend (R10 …)</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>N (points per window)</source>
        <translation>N (Punkte je Fenster)</translation>
    </message>
    <message>
        <source>Reach: the next window must be written while the tool executes the current one.</source>
        <translation>Reichweite: Das nächste Fenster muss geschrieben sein, während das Werkzeug das aktuelle abarbeitet.</translation>
    </message>
    <message>
        <source>Largest feed without waiting</source>
        <translation>Größter Vorschub ohne Warten</translation>
    </message>
    <message>
        <source>Safe, with waiting</source>
        <translation>Sicher, mit Wartezeiten</translation>
    </message>
    <message>
        <source>The machine will wait for points: %1</source>
        <translation>Die Maschine wird auf Punkte warten: %1</translation>
    </message>
    <message>
        <source>%1 × (waits below 1)</source>
        <translation>%1 × (unter 1: wartet)</translation>
    </message>
    <message>
        <source>Credit (experimental)</source>
        <translation>Kredit (experimentell)</translation>
    </message>
    <message>
        <source>Windows have a layout of their own</source>
        <translation>Fenster haben eine eigene Belegung</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Zugriff</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Arrays, or no start</source>
        <translation>Felder, sonst kein Start</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>Listen</translation>
    </message>
    <message>
        <source>One by one</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausen</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Geplant</translation>
    </message>
    <message>
        <source>Places where the axes will stop for a moment. Off the cut means after a rapid or a retract, or at a sharp corner; the path shows the places.</source>
        <translation>Stellen, an denen die Achsen kurz anhalten. Außerhalb des Schnitts heißt: nach einem Eilgang oder Rückzug oder an einer scharfen Ecke; die Bahn zeigt die Stellen.</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Zeitverlust</translation>
    </message>
    <message>
        <source>Standstill, braking and acceleration, computed with the axes of the virtual machine</source>
        <translation>Stillstand, Bremsen und Beschleunigen, berechnet mit den Achsen der virtuellen Maschine</translation>
    </message>
    <message>
        <source>Automatic: before anything moves, the forms of access are tested on the control and the best one is used. The report names it.</source>
        <translation>Automatisch: Bevor sich etwas bewegt, werden die Zugriffsformen an der Steuerung geprüft, und die beste wird verwendet. Der Bericht nennt sie.</translation>
    </message>
    <message>
        <source>Automatic: lists, as this method was published. Arrays need the contiguous layout.</source>
        <translation>Automatisch: Listen, wie dieses Verfahren veröffentlicht wurde. Felder brauchen das lückenlose Layout.</translation>
    </message>
    <message>
        <source>%1, of them %2 in the cut</source>
        <translation>%1, davon %2 im Schnitt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>wird berechnet …</translation>
    </message>
    <message>
        <source>Correction up to</source>
        <translation>Korrektur bis</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Largest correction of each axis during the run. The control must not add corrections up (MD36750 bit 0), and its own limit (SD43350) should not be larger.</source>
        <translation>Größte Korrektur jeder Achse während des Laufs. Die Steuerung darf Korrekturen nicht aufsummieren (MD36750 Bit 0), und ihre eigene Grenze (SD43350) soll nicht größer sein.</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Vorlage</translation>
    </message>
    <message>
        <source>copied by hand</source>
        <translation>von Hand übertragen</translation>
    </message>
    <message>
        <source>For a control that gives no right to its part programs: store the template there, select it and press cycle start. The run waits until this is done.</source>
        <translation>Für eine Steuerung, die kein Recht an ihren Teileprogrammen gibt: die Vorlage dort ablegen, anwählen und NC-Start drücken. Der Lauf wartet so lange.</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Of the program</source>
        <translation>Aus dem Programm</translation>
    </message>
    <message>
        <source>One for all moves</source>
        <translation>Fester Vorschub</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Scales the feeds of the program, and its rapids up to the rapid feed of the machine</source>
        <translation>Skaliert die Vorschübe des Programms und seine Eilgänge, diese höchstens bis zum Eilgang der Maschine</translation>
    </message>
    <message>
        <source>This method has one feed for all moves, as it was published</source>
        <translation>Dieses Verfahren hat einen Vorschub für alle Bewegungen, wie veröffentlicht</translation>
    </message>
    <message>
        <source>Of the program: each move has the feed of its own block, rapids are rapids. One for all moves: rapids have it, too.</source>
        <translation>Aus dem Programm: Jede Bewegung hat den Vorschub ihres Satzes, Eilgänge sind Eilgänge. Fester Vorschub: auch Eilgänge haben ihn.</translation>
    </message>
    <message>
        <source>Largest override</source>
        <translation>Größter Override</translation>
    </message>
    <message>
        <source>Use override = %1&#xa0;%</source>
        <translation>Override = %1&#xa0;% verwenden</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>Whole job</source>
        <translation>Ganzer Auftrag</translation>
    </message>
    <message>
        <source>Motion only</source>
        <translation>Nur Bewegung</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Trockenlauf</translation>
    </message>
    <message>
        <source>Above the workpiece</source>
        <translation>Über dem Werkstück</translation>
    </message>
    <message>
        <source>Whole job: the control executes tools, spindle, coolant, cycles and retracts at their place, and Rivulet streams the motion between them. Motion only: these blocks are left out. Dry run: the whole job above the workpiece, without spindle and coolant.</source>
        <translation>Ganzer Auftrag: Werkzeuge, Spindel, Kühlmittel, Zyklen und Rückzüge führt die Steuerung an ihrer Stelle aus, und Rivulet streamt die Bewegung dazwischen. Nur Bewegung: Diese Sätze werden ausgelassen. Trockenlauf: der ganze Auftrag über dem Werkstück, ohne Spindel und Kühlmittel.</translation>
    </message>
    <message>
        <source>The points of a live source have feeds of their own.</source>
        <translation>Die Punkte einer Live-Quelle haben eigene Vorschübe.</translation>
    </message>
    <message>
        <source>Lift while paused</source>
        <translation>Abheben in der Pause</translation>
    </message>
    <message>
        <source>While the axes are held, the tool can be lifted by so much. The control must not add overlays up (MD36750 bit 0), and its limit (SD43350) must not be smaller. Not with a correction or in a whole job; on a real control only after its stop test with a lift.</source>
        <translation>Solange die Achsen angehalten sind, kann das Werkzeug um so viel abgehoben werden. Die Steuerung darf Überlagerungen nicht aufsummieren (MD36750 Bit 0), und ihre Grenze (SD43350) darf nicht kleiner sein. Nicht mit einer Korrektur oder in einem ganzen Auftrag; an einer echten Steuerung erst nach ihrem Stopptest mit Abhub.</translation>
    </message>
    <message>
        <source>packed: one R-parameter each</source>
        <translation>gepackt: je ein R-Parameter</translation>
    </message>
    <message>
        <source>All axes of a point share one R-parameter, in steps of 0.001 mm from the first point of its window: a third of the accesses, so faster where the points are dense. A control that calculates otherwise refuses the first window; nothing moves then.</source>
        <translation>Alle Achsen eines Punkts teilen sich einen R-Parameter, in Schritten von 0,001 mm ab dem ersten Punkt ihres Fensters: ein Drittel der Zugriffe, also schneller, wo die Punkte dicht liegen. Eine Steuerung, die anders rechnet, lehnt das erste Fenster ab; dann bewegt sich nichts.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>This method does not use δ: it watches an R-parameter, not the tool</source>
        <translation>Diese Methode verwendet δ nicht: Sie beobachtet einen R-Parameter, nicht das Werkzeug</translation>
    </message>
    <message>
        <source>Window: the machine waits if the client is late; it never executes a point twice. Position: the client watches the tool and replaces points it has passed. Signal: the client watches an R-parameter in which the program says which half of the loop may be replaced. Credit: like window, without a stop between windows; it starts only on a control that has passed the test on the page Credit test.</source>
        <translation>Fenster: Die Maschine wartet, wenn der Client zu spät kommt; sie führt keinen Punkt zweimal aus. Position: Der Client beobachtet das Werkzeug und ersetzt Punkte, die es passiert hat. Signal: Der Client beobachtet einen R-Parameter, in dem das Programm meldet, welche Hälfte der Schleife ersetzt werden darf. Kredit: wie Fenster, ohne Halt zwischen den Fenstern; startet nur an einer Steuerung, die den Test der Seite Kredit-Test bestanden hat.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Straight moves that stay so near to the path take the place of many short ones (rotary axes: degrees). Corners, feeds and the order of the path stay. Not in whole jobs and live runs.</source>
        <translation>Gerade Sätze, die so nahe an der Bahn bleiben, treten an die Stelle vieler kurzer (Rundachsen: Grad). Ecken, Vorschübe und Reihenfolge der Bahn bleiben. Nicht in ganzen Aufträgen und bei Live-Punkten.</translation>
    </message>
    <message>
        <source>Machine: requests and motion of this machine, followed through the program.</source>
        <translation>Maschine: Anfragen und Bewegung dieser Maschine, durch das Programm verfolgt.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NetCanvas</name>
    <message>
        <source>Only records; holds no tokens.</source>
        <translation>Zeichnet nur auf, hält keine Marken.</translation>
    </message>
    <message>
        <source>Tokens: %1</source>
        <translation>Marken: %1</translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation>Priorität %1</translation>
    </message>
    <message>
        <source>If %1</source>
        <translation>Wenn %1</translation>
    </message>
    <message>
        <source>A page of its own: Enter or a double click opens it.</source>
        <translation>Eine eigene Seite: Eingabetaste oder Doppelklick öffnet sie.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NetPanel</name>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Tokens</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>There is no net.</source>
        <translation>Es gibt kein Netz.</translation>
    </message>
    <message>
        <source>%1, fired %2; next: %3</source>
        <translation>%1, geschaltet %2; als Nächstes: %3</translation>
    </message>
    <message>
        <source>%1, fired %2; nothing more is played</source>
        <translation>%1, geschaltet %2; mehr wird nicht gespielt</translation>
    </message>
    <message>
        <source>Click a place or a transition: what it holds or needs is shown here.</source>
        <translation>Eine Stelle oder Transition anklicken: Hier steht, was sie hält oder braucht.</translation>
    </message>
    <message>
        <source>Cycle %1 ms</source>
        <translation>Zyklus %1 ms</translation>
    </message>
    <message>
        <source>Cycle of position control; the net begins anew</source>
        <translation>Zyklus der Lageregelung; das Netz beginnt von vorn</translation>
    </message>
    <message>
        <source>Task dependency</source>
        <translation>Abhängigkeit der Aufgaben</translation>
    </message>
    <message>
        <source>Data flow</source>
        <translation>Datenfluss</translation>
    </message>
    <message>
        <source>Which task gets the processor; the net begins anew</source>
        <translation>Welche Aufgabe den Prozessor bekommt; das Netz beginnt von vorn</translation>
    </message>
    <message>
        <source>Page of the net</source>
        <translation>Seite des Netzes</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>Show the page on which the next transition fires</source>
        <translation>Die Seite zeigen, auf der die nächste Transition schaltet</translation>
    </message>
    <message>
        <source>%1 per s</source>
        <translation>%1 pro s</translation>
    </message>
    <message>
        <source>Transitions that fire in a second</source>
        <translation>Transitionen, die in einer Sekunde schalten</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Fire one transition</source>
        <translation>Eine Transition schalten</translation>
    </message>
    <message>
        <source>Fire one transition after another</source>
        <translation>Eine Transition nach der anderen schalten</translation>
    </message>
    <message>
        <source>Back to start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>The tokens as they were at the beginning</source>
        <translation>Die Marken, wie sie am Anfang waren</translation>
    </message>
    <message>
        <source>Petri net</source>
        <translation>Petrinetz</translation>
    </message>
    <message>
        <source>A thick frame with a triangle: this transition could fire. Filled: it fires next. Thick lines: it fired last.</source>
        <translation>Ein dicker Rahmen mit Dreieck: Diese Transition könnte schalten. Gefüllt: Sie schaltet als Nächste. Dicke Linien: Sie hat zuletzt geschaltet.</translation>
    </message>
    <message>
        <source>Levels of the buffers</source>
        <translation>Füllstände der Puffer</translation>
    </message>
    <message>
        <source>Time of the net, s</source>
        <translation>Zeit des Netzes, s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Füllstand</translation>
    </message>
    <message>
        <source>Places of this page</source>
        <translation>Stellen dieser Seite</translation>
    </message>
    <message>
        <source>What is chosen</source>
        <translation>Was gewählt ist</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NumberField</name>
    <message>
        <source>%1 can be read in two ways. Type it without a separator between thousands, or with %2 before the decimals.</source>
        <translation>%1 lässt sich auf zwei Arten lesen. Ohne Tausendertrennzeichen eingeben, oder mit %2 vor den Nachkommastellen.</translation>
    </message>
    <message>
        <source>%1 has more than one separator. Type it without separators between thousands.</source>
        <translation>%1 hat mehr als ein Trennzeichen. Ohne Tausendertrennzeichen eingeben.</translation>
    </message>
    <message>
        <source>The field was empty.</source>
        <translation>Das Feld war leer.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 ist keine Zahl.</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 to %3.</source>
        <translation>%1 liegt außerhalb des Bereichs: %2 bis %3.</translation>
    </message>
    <message>
        <source>%1 The value stays %2.</source>
        <translation>%1 Der Wert bleibt %2.</translation>
    </message>
    <message>
        <source>%1 is not a whole number. Type it without separators.</source>
        <translation>%1 ist keine ganze Zahl. Ohne Trennzeichen eingeben.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::OverlayPanel</name>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Emulator</source>
        <translation>Emulator</translation>
    </message>
    <message>
        <source>%1 machine − emulator</source>
        <translation>%1 Maschine − Emulator</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Recording on which machine and emulator are compared</source>
        <translation>Aufzeichnung, an der Maschine und Emulator verglichen werden</translation>
    </message>
    <message>
        <source>Errors drawn larger</source>
        <translation>Fehler vergrößert</translation>
    </message>
    <message>
        <source>How many times larger the distance to the path of the set points is drawn</source>
        <translation>Wievielmal größer der Abstand zur Bahn der Sollwerte gezeichnet wird</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Fehler × %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::OverrideControl</name>
    <message>
        <source>Path override of this run, in percent of the programmed feed. The override of the machine&apos;s own switch multiplies. Ctrl++ and Ctrl+- are a step of 5 %.</source>
        <translation>Bahn-Override dieses Laufs, in Prozent des programmierten Vorschubs. Der Override-Schalter der Maschine wirkt zusätzlich. Strg++ und Strg+- sind ein Schritt von 5 %.</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Override: 5 % less</source>
        <translation>Override: 5 % weniger</translation>
    </message>
    <message>
        <source>Override: 5 % more</source>
        <translation>Override: 5 % mehr</translation>
    </message>
    <message>
        <source>Override %1 %</source>
        <translation>Override %1 %</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ParallelPage</name>
    <message>
        <source>Petri net</source>
        <translation>Petrinetz</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Aufgaben</translation>
    </message>
    <message>
        <source>Part of the page</source>
        <translation>Teil der Seite</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathPane</name>
    <message>
        <source>The path during the time shown. Click: cursor A. Shift and click: cursor B. In 3D, drag or the arrow keys turn it, Home turns it back.</source>
        <translation>Die Bahn der gezeigten Zeit. Klick: Cursor A. Umschalt und Klick: Cursor B. In 3D drehen Ziehen oder die Pfeiltasten sie, Pos1 dreht sie zurück.</translation>
    </message>
    <message>
        <source>Path of the axes</source>
        <translation>Bahn der Achsen</translation>
    </message>
    <message>
        <source>%1: no values here</source>
        <translation>%1: hier keine Werte</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Fehler × %1</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>No X and Y here</source>
        <translation>Hier gibt es kein X und Y</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathPanel</name>
    <message>
        <source>Line %1 was executed %2 times. Cursor A is at number %3; click again for the next.</source>
        <translation>Zeile %1 wurde %2-mal ausgeführt. Cursor A steht bei Nummer %3; noch ein Klick führt zur nächsten.</translation>
    </message>
    <message>
        <source>The line under cursor A is marked. A click on a line puts cursor A where it was executed.</source>
        <translation>Die Zeile unter Cursor A ist markiert. Ein Klick auf eine Zeile setzt Cursor A dorthin, wo sie ausgeführt wurde.</translation>
    </message>
    <message>
        <source>Text of the program</source>
        <translation>Text des Programms</translation>
    </message>
    <message>
        <source>The signal that gives the path its colours</source>
        <translation>Das Signal, das der Bahn ihre Farben gibt</translation>
    </message>
    <message>
        <source>Colour of the path</source>
        <translation>Farbe der Bahn</translation>
    </message>
    <message>
        <source>Enlargement of the error</source>
        <translation>Vergrößerung des Fehlers</translation>
    </message>
    <message>
        <source>Seen from the side; drag the path or press the arrow keys to turn it</source>
        <translation>Von der Seite gesehen; Ziehen oder die Pfeiltasten drehen die Bahn</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>X and Y, seen from above</source>
        <translation>X und Y, von oben gesehen</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>A click on a line puts cursor A where it was executed.</source>
        <translation>Ein Klick auf eine Zeile setzt Cursor A dorthin, wo sie ausgeführt wurde.</translation>
    </message>
    <message>
        <source>Nothing moved in line %1.</source>
        <translation>In Zeile %1 hat sich nichts bewegt.</translation>
    </message>
    <message>
        <source>The trace does not show where it is in the program.</source>
        <translation>Die Aufzeichnung zeigt nicht, wo sie im Programm ist.</translation>
    </message>
    <message>
        <source>Comparing the trace with the program …</source>
        <translation>Die Aufzeichnung wird mit dem Programm verglichen …</translation>
    </message>
    <message>
        <source>The run was made with another program or another version of it. Open that one to see its lines with the cursor.</source>
        <translation>Der Lauf wurde mit einem anderen Programm oder einem anderen Stand gemacht. Jenes öffnen, um seine Zeilen mit dem Cursor zu sehen.</translation>
    </message>
    <message>
        <source>Lines and trace are linked when a trace is shown.</source>
        <translation>Zeilen und Kurven sind verbunden, sobald eine Aufzeichnung gezeigt wird.</translation>
    </message>
    <message>
        <source>Open the NC program of the trace to see its lines with the cursor.</source>
        <translation>Das NC-Programm der Aufzeichnung öffnen, um seine Zeilen mit dem Cursor zu sehen.</translation>
    </message>
    <message>
        <source>Errors can be drawn larger after the trace has been compared with its NC program</source>
        <translation>Fehler lassen sich vergrößern, nachdem die Aufzeichnung mit ihrem NC-Programm verglichen wurde</translation>
    </message>
    <message>
        <source>How many times larger the distance to the programmed path is drawn</source>
        <translation>Wievielmal größer der Abstand zur programmierten Bahn gezeichnet wird</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Fehler × %1</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>Farbe: %1</translation>
    </message>
    <message>
        <source>Colour: the trace</source>
        <translation>Farbe: die Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathView</name>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole path (double click does the same)</source>
        <translation>Die ganze Bahn zeigen (wie ein Doppelklick)</translation>
    </message>
    <message>
        <source>No program is loaded</source>
        <translation>Kein Programm geladen</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ausgeführt</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Farbe nach</translation>
    </message>
    <message>
        <source>Kind of move</source>
        <translation>Art der Bewegung</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Margin of the method</source>
        <translation>Reserve des Verfahrens</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>by point</source>
        <translation>nach Punkt</translation>
    </message>
    <message>
        <source>by time</source>
        <translation>nach Zeit</translation>
    </message>
    <message>
        <source>Walk along the path</source>
        <translation>Die Bahn entlanggehen</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>no feed given</source>
        <translation>ohne Vorschub</translation>
    </message>
    <message>
        <source>margin over %1</source>
        <translation>Reserve über %1</translation>
    </message>
    <message>
        <source>not kept (below %1)</source>
        <translation>nicht eingehalten (unter %1)</translation>
    </message>
    <message>
        <source>Click on the path or move the slider.</source>
        <translation>Auf die Bahn klicken oder den Regler bewegen.</translation>
    </message>
    <message>
        <source>Point %1 of %2, line %3</source>
        <translation>Punkt %1 von %2, Zeile %3</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>wird berechnet …</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausen</translation>
    </message>
    <message>
        <source>Mark where the run will pause</source>
        <translation>Zeigt, wo der Lauf pausieren wird</translation>
    </message>
    <message>
        <source>Pause off the cut, after point %1, line %2</source>
        <translation>Pause außerhalb des Schnitts, nach Punkt %1, Zeile %2</translation>
    </message>
    <message>
        <source>Pause in the cut, after point %1, line %2</source>
        <translation>Pause im Schnitt, nach Punkt %1, Zeile %2</translation>
    </message>
    <message>
        <source>%1 in the cut</source>
        <translation>%1 im Schnitt</translation>
    </message>
    <message>
        <source>then a pause in the cut</source>
        <translation>dann eine Pause im Schnitt</translation>
    </message>
    <message>
        <source>then a pause off the cut</source>
        <translation>dann eine Pause außerhalb des Schnitts</translation>
    </message>
    <message>
        <source>Density of pauses</source>
        <translation>Dichte der Pausen</translation>
    </message>
    <message>
        <source>no pause</source>
        <translation>keine Pause</translation>
    </message>
    <message>
        <source>a pause every %1</source>
        <translation>eine Pause je %1</translation>
    </message>
    <message>
        <source>By the control</source>
        <translation>Von der Steuerung</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>Werkzeugwechsel</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pauses off the cut</source>
        <translation>
            <numerusform>%Ln Pause außerhalb des Schnitts</numerusform>
            <numerusform>%Ln Pausen außerhalb des Schnitts</numerusform>
        </translation>
    </message>
    <message>
        <source>The points appear here as they come</source>
        <translation>Hier erscheinen die Punkte, wie sie kommen</translation>
    </message>
    <message>
        <source>Grid %1</source>
        <translation>Raster %1</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Drag or press the arrow keys to turn it; with Shift, dragging moves it</source>
        <translation>Ziehen oder Pfeiltasten drehen; mit Umschalt verschiebt das Ziehen</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>From above: X, Y</source>
        <translation>Von oben: X, Y</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>From the front: X, Z</source>
        <translation>Von vorn: X, Z</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>From the right: Y, Z</source>
        <translation>Von rechts: Y, Z</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PositionLine</name>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Keine Daten</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Last executed point, %1. The axes were read %2 ago.</source>
        <translation>Zuletzt ausgeführter Punkt, %1. Achsen vor %2 gelesen.</translation>
    </message>
    <message>
        <source>Old: read %1 ago</source>
        <translation>Alt: vor %1 gelesen</translation>
    </message>
    <message>
        <source>to go %1</source>
        <translation>Rest %1</translation>
    </message>
    <message>
        <source>Distance to go: not known, because the stream leaves no time to read the axes.</source>
        <translation>Restweg: nicht bekannt, weil das Streaming keine Zeit lässt, die Achsen zu lesen.</translation>
    </message>
    <message>
        <source>Distance to go: not known. The axes are not on the path of the program, or it is being corrected.</source>
        <translation>Restweg: nicht bekannt. Die Achsen sind nicht auf der Bahn des Programms, oder sie wird gerade korrigiert.</translation>
    </message>
    <message>
        <source>Distance to go: the control does not report it.</source>
        <translation>Restweg: Die Steuerung meldet ihn nicht.</translation>
    </message>
    <message>
        <source>Distance to go to the end of the move in progress, from the position that was read and the path of the program</source>
        <translation>Restweg bis zum Ende der laufenden Bewegung, aus der gelesenen Position und der Bahn des Programms</translation>
    </message>
    <message>
        <source>Distance to go to the end of the block, as the control reports it</source>
        <translation>Restweg bis zum Ende des Satzes, wie ihn die Steuerung meldet</translation>
    </message>
    <message>
        <source>set %1</source>
        <translation>Soll %1</translation>
    </message>
    <message>
        <source>Commanded feed: not known, because no run of this window is in progress.</source>
        <translation>Soll-Vorschub: nicht bekannt, weil kein Lauf dieses Fensters im Gang ist.</translation>
    </message>
    <message>
        <source>Feed of the program, scaled by the override of the run. %1</source>
        <translation>Vorschub des Programms, mit dem Override des Laufs. %1</translation>
    </message>
    <message>
        <source>One feed for all moves, without an override. %1</source>
        <translation>Ein Vorschub für alle Bewegungen, ohne Override. %1</translation>
    </message>
    <message>
        <source>The feed override at the control is not read; it acts in addition.</source>
        <translation>Der Vorschub-Override an der Steuerung wird nicht gelesen; er wirkt zusätzlich.</translation>
    </message>
    <message>
        <source>Up to 1 s old: no time to read more often</source>
        <translation>Bis zu 1 s alt: keine Zeit, öfter zu lesen</translation>
    </message>
    <message>
        <source>No tool in the spindle</source>
        <translation>Kein Werkzeug in der Spindel</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Werkzeug %1</translation>
    </message>
    <message>
        <source>cutting edge D%1</source>
        <translation>Schneide D%1</translation>
    </message>
    <message>
        <source>work offset %1</source>
        <translation>Nullpunktverschiebung %1</translation>
    </message>
    <message>
        <source>Spindle: actual %1, commanded %2 1/min</source>
        <translation>Spindel: Ist %1, Soll %2 1/min</translation>
    </message>
    <message>
        <source>clockwise (M3)</source>
        <translation>Rechtslauf (M3)</translation>
    </message>
    <message>
        <source>counterclockwise (M4)</source>
        <translation>Linkslauf (M4)</translation>
    </message>
    <message>
        <source>direction not known</source>
        <translation>Drehrichtung nicht bekannt</translation>
    </message>
    <message>
        <source>coolant off</source>
        <translation>Kühlmittel aus</translation>
    </message>
    <message>
        <source>coolant on (%1)</source>
        <translation>Kühlmittel ein (%1)</translation>
    </message>
    <message>
        <source>coolant not known</source>
        <translation>Kühlmittel nicht bekannt</translation>
    </message>
    <message>
        <source>%1. The control reports it, about once a second.</source>
        <translation>%1. Die Steuerung meldet es, etwa einmal je Sekunde.</translation>
    </message>
    <message>
        <source>%1. Read %2 ago: it may have changed since.</source>
        <translation>%1. Vor %2 gelesen: Es kann sich seitdem geändert haben.</translation>
    </message>
    <message>
        <source>Live, but tool and spindle: read %1 ago</source>
        <translation>Live, aber Werkzeug und Spindel: vor %1 gelesen</translation>
    </message>
    <message>
        <source>Read %1 ago: the run is being prepared</source>
        <translation>Vor %1 gelesen: der Lauf wird vorbereitet</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PreflightSheet</name>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the machine moves.</source>
        <translation>Noch hat sich nichts bewegt. Start eine Sekunde lang halten: Dann fährt die Maschine.</translation>
    </message>
    <message>
        <source>Start is not possible yet.</source>
        <translation>Start ist noch nicht möglich.</translation>
    </message>
    <message>
        <source>Before the start</source>
        <translation>Vor dem Start</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Resuming is not possible yet.</source>
        <translation>Fortsetzen ist noch nicht möglich.</translation>
    </message>
    <message>
        <source>Before the run is resumed</source>
        <translation>Vor dem Fortsetzen</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message numerus="yes">
        <source>%Ln checks: %1</source>
        <translation>
            <numerusform>%Ln Prüfung: %1</numerusform>
            <numerusform>%Ln Prüfungen: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Einklappen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold the button below for one second: then the machine moves.</source>
        <translation>Noch bewegt sich nichts. Den Knopf unten eine Sekunde lang halten: Dann fährt die Maschine.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the tool is raised, and nothing else.</source>
        <translation>Noch hat sich nichts bewegt. Start eine Sekunde lang halten: Dann wird das Werkzeug abgehoben, sonst nichts.</translation>
    </message>
    <message>
        <source>Before the tool is raised</source>
        <translation>Bevor das Werkzeug abgehoben wird</translation>
    </message>
    <message>
        <source>First move</source>
        <translation>Erste Bewegung</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the tool goes back along the path, and nothing else.</source>
        <translation>Noch hat sich nichts bewegt. Start eine Sekunde lang halten: Dann fährt das Werkzeug auf der Bahn zurück, sonst nichts.</translation>
    </message>
    <message>
        <source>Before the tool goes back</source>
        <translation>Bevor das Werkzeug zurückfährt</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProfilePage</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Werkzeug %1</translation>
    </message>
    <message>
        <source>Number of the tool</source>
        <translation>Nummer des Werkzeugs</translation>
    </message>
    <message>
        <source>Entered by %1 on %2.</source>
        <translation>Eingegeben von %1 am %2.</translation>
    </message>
    <message>
        <source>Nobody has entered the limits of this machine. Feeds and simulations take those of the machine in the paper: %1.</source>
        <translation>Niemand hat die Grenzen dieser Maschine eingegeben. Vorschübe und Simulationen nehmen die der Maschine aus dem Artikel: %1.</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Name der Maschine</translation>
    </message>
    <message>
        <source>Simulated as</source>
        <translation>Simuliert als</translation>
    </message>
    <message>
        <source>Take over its limits</source>
        <translation>Deren Grenzen übernehmen</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Travel from</source>
        <translation>Verfahrweg von</translation>
    </message>
    <message>
        <source>Travel to</source>
        <translation>Verfahrweg bis</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Ruck</translation>
    </message>
    <message>
        <source>Rapid, mm/min</source>
        <translation>Eilgang, mm/min</translation>
    </message>
    <message>
        <source>Spindle up to, 1/min</source>
        <translation>Spindel bis, 1/min</translation>
    </message>
    <message>
        <source>0: no spindle</source>
        <translation>0: keine Spindel</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Länge, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Radius, mm</translation>
    </message>
    <message>
        <source>Add a tool</source>
        <translation>Werkzeug hinzufügen</translation>
    </message>
    <message>
        <source>Save the limits</source>
        <translation>Grenzen speichern</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>M functions: write the number, an equals sign, and ignore, pass or a line for the control. Separate entries with semicolons.</source>
        <translation>M-Funktionen: die Nummer, ein Gleichheitszeichen und ignore, pass oder eine Zeile für die Steuerung schreiben. Einträge mit Semikolon trennen.</translation>
    </message>
    <message>
        <source>M functions of other machines</source>
        <translation>M-Funktionen anderer Maschinen</translation>
    </message>
    <message>
        <source>What this machine does for the M functions of programs made for another: ignore leaves the function out, pass gives it to the control, anything else is a line for it.</source>
        <translation>Was diese Maschine für die M-Funktionen von Programmen tut, die für eine andere gemacht sind: ignore lässt die Funktion weg, pass gibt sie an die Steuerung, alles andere ist eine Zeile für sie.</translation>
    </message>
    <message>
        <source>When nothing has come from this computer for so long, the axes stand on the path until it gives a sign again. 0: not at all.</source>
        <translation>Kommt so lange nichts von diesem Rechner, stehen die Achsen auf der Bahn, bis er sich wieder meldet. 0: gar nicht.</translation>
    </message>
    <message>
        <source>Without this computer the axes stand after, s</source>
        <translation>Ohne diesen Rechner stehen die Achsen nach, s</translation>
    </message>
    <message>
        <source>Where a stop is sure to act only before the next window, because this control has not passed the stop test, no window of several moves takes longer.</source>
        <translation>Wo ein Stopp sicher erst vor dem nächsten Fenster wirkt, weil diese Steuerung den Stopp-Test nicht bestanden hat, dauert kein Fenster aus mehreren Sätzen länger.</translation>
    </message>
    <message>
        <source>Without a passed stop test a window takes at most, s</source>
        <translation>Ohne bestandenen Stopp-Test dauert ein Fenster höchstens, s</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramPage</name>
    <message>
        <source>Program text</source>
        <translation>Programmtext</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramPanel</name>
    <message>
        <source>Open an NC program</source>
        <translation>NC-Programm öffnen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Kennzahlen</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Cutting path</source>
        <translation>Schnittweg</translation>
    </message>
    <message>
        <source>Rapid path</source>
        <translation>Eilgangweg</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>Vorschübe</translation>
    </message>
    <message>
        <source>Smallest distance of neighbouring points</source>
        <translation>Kleinster Abstand benachbarter Punkte</translation>
    </message>
    <message>
        <source>Smallest path length of half a loop (N/2 points, rounded down)</source>
        <translation>Kleinste Bahnlänge einer halben Schleife (N/2 Punkte, abgerundet)</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Kein Programm</translation>
    </message>
    <message>
        <source>Drop a file here or press Open…</source>
        <translation>Datei hier ablegen oder Öffnen… drücken</translation>
    </message>
    <message>
        <source>Hash %1</source>
        <translation>Prüfsumme %1</translation>
    </message>
    <message>
        <source>Errors: %1, warnings: %2, notes: %3</source>
        <translation>Fehler: %1, Warnungen: %2, Hinweise: %3</translation>
    </message>
    <message>
        <source>Cannot be streamed.</source>
        <translation>Nicht streambar.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>lines %1–%2</source>
        <translation>Zeilen %1–%2</translation>
    </message>
    <message>
        <source>No findings</source>
        <translation>Keine Befunde</translation>
    </message>
    <message>
        <source>NC programs (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap *.cnc *.gcode *.h *.H *.txt)</source>
        <translation>NC-Programme (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap *.cnc *.gcode *.h *.H *.txt)</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>Akzeptieren…</translation>
    </message>
    <message>
        <source>The program is read again with this word left out</source>
        <translation>Das Programm wird ohne dieses Wort neu gelesen</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>By kind</source>
        <translation>Nach Art</translation>
    </message>
    <message>
        <source>Time, feeds as programmed</source>
        <translation>Zeit, Vorschübe wie programmiert</translation>
    </message>
    <message>
        <source>Time, as streamed</source>
        <translation>Zeit, wie gestreamt</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Distances of neighbouring points, mm</source>
        <translation>Abstände benachbarter Punkte, mm</translation>
    </message>
    <message>
        <source>%1 (repetitions left out: %2)</source>
        <translation>%1 (Wiederholungen weggelassen: %2)</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>mm and inch</source>
        <translation>mm und Zoll</translation>
    </message>
    <message>
        <source>lines %1</source>
        <translation>Geraden %1</translation>
    </message>
    <message>
        <source>arcs %1</source>
        <translation>Bögen %1</translation>
    </message>
    <message>
        <source>splines %1</source>
        <translation>Splines %1</translation>
    </message>
    <message>
        <source>median %1, largest %2</source>
        <translation>Median %1, größter %2</translation>
    </message>
    <message>
        <source>%1 of 45° and more; sharpest %2° (%3)</source>
        <translation>%1 ab 45°; schärfste %2° (%3)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Befunde (%1)</translation>
    </message>
    <message>
        <source>%1 without pauses</source>
        <translation>%1 ohne Pausen</translation>
    </message>
    <message>
        <source>as detected</source>
        <translation>wie erkannt</translation>
    </message>
    <message>
        <source>Read as %1, as selected.</source>
        <translation>Gelesen als %1, wie gewählt.</translation>
    </message>
    <message>
        <source>Read as %1: the text gives no evidence of its dialect.</source>
        <translation>Gelesen als %1: Der Text lässt keinen Dialekt erkennen.</translation>
    </message>
    <message>
        <source>Read as %1 because of &quot;%2&quot;.</source>
        <translation>Gelesen als %1 wegen „%2“.</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Akzeptiert: %1</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Take back %1</source>
        <translation>%1 zurücknehmen</translation>
    </message>
    <message>
        <source>Accept %1</source>
        <translation>%1 akzeptieren</translation>
    </message>
    <message>
        <source>Rivulet does not understand %1. If you accept it, it is left out wherever the program has it, and the path is taken as if it were not there.

Is it certain that %1 does not change the path of the tool?</source>
        <translation>Rivulet versteht %1 nicht. Wird es hingenommen, bleibt es überall im Programm unbeachtet, und die Bahn gilt, als stünde es nicht da.

Ist sicher, dass %1 die Bahn des Werkzeugs nicht ändert?</translation>
    </message>
    <message>
        <source>Accept and read again</source>
        <translation>Akzeptieren und neu lesen</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>wird berechnet …</translation>
    </message>
    <message>
        <source>Computed with the axes of %1</source>
        <translation>Berechnet mit den Achsen von %1</translation>
    </message>
    <message>
        <source>I, J, K are read as the centre itself</source>
        <translation>I, J, K gelten als Mittelpunkt selbst</translation>
    </message>
    <message>
        <source>I, J, K are read from the centre to the start</source>
        <translation>I, J, K gelten vom Mittelpunkt zum Anfang</translation>
    </message>
    <message>
        <source>Read I, J, K as usual</source>
        <translation>I, J, K wie üblich lesen</translation>
    </message>
    <message>
        <source>Read it that way</source>
        <translation>So lesen</translation>
    </message>
    <message>
        <source>Cannot be streamed: no axis moves.</source>
        <translation>Nicht streambar: Keine Achse bewegt sich.</translation>
    </message>
    <message>
        <source>Cannot be streamed: it needs a transformation of the control.</source>
        <translation>Nicht streambar: Das Programm braucht eine Transformation der Steuerung.</translation>
    </message>
    <message numerus="yes">
        <source>%1 … %2 (%Ln values)</source>
        <translation>
            <numerusform>%1 … %2 (%Ln Wert)</numerusform>
            <numerusform>%1 … %2 (%Ln Werte)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 with %Ln pauses, which cost %2</source>
        <translation>
            <numerusform>%1 mit %Ln Pause, die %2 kostet</numerusform>
            <numerusform>%1 mit %Ln Pausen, die %2 kosten</numerusform>
        </translation>
    </message>
    <message>
        <source>Live …</source>
        <translation>Live …</translation>
    </message>
    <message>
        <source>Points that another program computes while the machine moves</source>
        <translation>Punkte, die ein anderes Programm berechnet, während die Maschine fährt</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message numerus="yes">
        <source>%Ln lines</source>
        <translation>
            <numerusform>%Ln Zeile</numerusform>
            <numerusform>%Ln Zeilen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramTextView</name>
    <message>
        <source>No program is loaded</source>
        <translation>Kein Programm geladen</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ReadingBar</name>
    <message>
        <source>a %1 goes to %2 mm</source>
        <translation>eine %1 fährt nach %2 mm</translation>
    </message>
    <message>
        <source>a %1 does not move</source>
        <translation>eine %1 bewegt sich nicht</translation>
    </message>
    <message>
        <source>Nothing shows for which control this program was made. From line %1 on, %2. Which is it?</source>
        <translation>Nichts zeigt, für welche Steuerung dieses Programm geschrieben ist. Ab Zeile %1: %2. Welche ist es?</translation>
    </message>
    <message>
        <source>The program does not say whether it is in mm or inch. Its size in mm, or in inch: %1.</source>
        <translation>Das Programm sagt nicht, ob es in mm oder in Zoll ist. Seine Größe in mm, oder in Zoll: %1.</translation>
    </message>
    <message>
        <source>Coordinates have no decimal point. Some controls count them in thousandths. The size as whole units, or as thousandths: %1.</source>
        <translation>Die Koordinaten haben keinen Dezimalpunkt. Manche Steuerungen zählen sie in Tausendsteln. Die Größe als ganze Einheiten, oder als Tausendstel: %1.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Whole units</source>
        <translation>Ganze Einheiten</translation>
    </message>
    <message>
        <source>Thousandths</source>
        <translation>Tausendstel</translation>
    </message>
    <message>
        <source>Take them</source>
        <translation>So annehmen</translation>
    </message>
    <message>
        <source>The program leaves values to settings of the control. Enter those of the machine, or take those of a virtual machine.</source>
        <translation>Das Programm überlässt Werte den Einstellungen der Steuerung. Tragen Sie die der Maschine ein, oder nehmen Sie die einer virtuellen Maschine.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RegionChart</name>
    <message>
        <source>F, mm/min</source>
        <translation>F, mm/min</translation>
    </message>
    <message>
        <source>d_min, mm</source>
        <translation>d_min, mm</translation>
    </message>
    <message>
        <source>N, points per loop</source>
        <translation>N, Punkte je Schleife</translation>
    </message>
    <message>
        <source>δ, mm</source>
        <translation>δ, mm</translation>
    </message>
    <message>
        <source>reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>Override %1</source>
        <translation>Override %1</translation>
    </message>
    <message>
        <source>Override, %</source>
        <translation>Override, %</translation>
    </message>
    <message>
        <source>t_min, ms: shortest move at 100 %</source>
        <translation>t_min, ms: kürzeste Bewegung bei 100&#xa0;%</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ReportPanel</name>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausen</translation>
    </message>
    <message>
        <source>Access time per variable</source>
        <translation>Zugriffszeit je Variable</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ausgeführt</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Neben dem Programm</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Anfragen</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95. Perzentil</translation>
    </message>
    <message>
        <source>99th percentile</source>
        <translation>99. Perzentil</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>Stop confirmed</source>
        <translation>Stopp bestätigt</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Noch kein Lauf</translation>
    </message>
    <message>
        <source>%1 of %2 (not judged: longer than the trace of the control)</source>
        <translation>%1 von %2 (nicht beurteilt: länger als die Aufzeichnung der Steuerung)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 (not judged: no trace of the control)</source>
        <translation>%1 von %2 (nicht beurteilt: keine Aufzeichnung der Steuerung)</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>NOT confirmed: check the machine</source>
        <translation>NICHT bestätigt: Maschine prüfen</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>%1, from point %2 on</source>
        <translation>%1, ab Punkt %2</translation>
    </message>
    <message>
        <source>%1 (proved)</source>
        <translation>%1 (erprobt)</translation>
    </message>
    <message>
        <source>Time spent</source>
        <translation>Zeitaufteilung</translation>
    </message>
    <message>
        <source>Live lines</source>
        <translation>Live-Zeilen</translation>
    </message>
    <message>
        <source>Delay from arrival to motion</source>
        <translation>Verzug von Ankunft bis Bewegung</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ResponsePanel</name>
    <message>
        <source>Bode plot: gain</source>
        <translation>Bode-Diagramm: Verstärkung</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>Gain, dB</source>
        <translation>Verstärkung, dB</translation>
    </message>
    <message>
        <source>Bode plot: phase</source>
        <translation>Bode-Diagramm: Phase</translation>
    </message>
    <message>
        <source>Phase, °</source>
        <translation>Phase, °</translation>
    </message>
    <message>
        <source>Answer to a step of 1 mm</source>
        <translation>Antwort auf einen Sprung von 1 mm</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Position, mm</translation>
    </message>
    <message>
        <source>%1 follows up to %2 Hz (−3 dB).</source>
        <translation>%1 folgt bis %2 Hz (−3 dB).</translation>
    </message>
    <message>
        <source>From set point to actual position; the Bode plot is without friction.</source>
        <translation>Vom Sollwert zur Istposition; das Bode-Diagramm ohne Reibung.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ResumeBar</name>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Asking the control where the run was left …</source>
        <translation>Die Steuerung wird gefragt, wo der Lauf unterbrochen wurde …</translation>
    </message>
    <message>
        <source>The run cannot be resumed: %1</source>
        <translation>Der Lauf kann nicht fortgesetzt werden: %1</translation>
    </message>
    <message>
        <source>Press and hold: resume at point %1</source>
        <translation>Gedrückt halten: weiter bei Punkt %1</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Eine Sekunde lang halten. Dann fährt die Maschine.</translation>
    </message>
    <message>
        <source>Press and hold: start at point %1</source>
        <translation>Gedrückt halten: Start bei Punkt %1</translation>
    </message>
    <message>
        <source>Press and hold: go on with the job</source>
        <translation>Gedrückt halten: Auftrag fortsetzen</translation>
    </message>
    <message numerus="yes">
        <source>Before that, the control executes %Ln blocks: see the list.</source>
        <translation>
            <numerusform>Davor führt die Steuerung %Ln Satz aus: siehe Liste.</numerusform>
            <numerusform>Davor führt die Steuerung %Ln Sätze aus: siehe Liste.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing has moved yet. The run will start at point %1 of %2, where line %3 begins: %4.</source>
        <translation>Noch bewegt sich nichts. Der Lauf wird bei Punkt %1 von %2 beginnen, wo Zeile %3 anfängt: %4.</translation>
    </message>
    <message>
        <source>The tool first moves %1 in a straight line to that point.</source>
        <translation>Das Werkzeug fährt zuerst %1 geradeaus zu diesem Punkt.</translation>
    </message>
    <message>
        <source>From point %1 on, the program differs from that of the interrupted run. None of these points has been executed: check the new path before you go on.</source>
        <translation>Ab Punkt %1 unterscheidet sich das Programm von dem des unterbrochenen Laufs. Keiner dieser Punkte wurde ausgeführt: Vor dem Fortsetzen die neue Bahn prüfen.</translation>
    </message>
    <message>
        <source>The program still stands on the control: first it executes the rest of its window, at most %1, and ends.</source>
        <translation>Das Programm steht noch auf der Steuerung: Zuerst arbeitet es den Rest seines Fensters ab, höchstens %1, und endet.</translation>
    </message>
    <message>
        <source>The program still stands on the control, between its windows: it ends without a move.</source>
        <translation>Das Programm steht noch auf der Steuerung, zwischen seinen Fenstern: Es endet ohne Bewegung.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The job will go on in part %1 at point %2 of %3, line %4.</source>
        <translation>Noch hat sich nichts bewegt. Der Auftrag geht in Abschnitt %1 bei Punkt %2 von %3 weiter, Zeile %4.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The job will go on at line %1: %2.</source>
        <translation>Noch hat sich nichts bewegt. Der Auftrag geht bei Zeile %1 weiter: %2.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The run will resume at point %1 of %2, line %3: %4.</source>
        <translation>Noch bewegt sich nichts. Der Lauf wird bei Punkt %1 von %2 fortgesetzt, Zeile %3: %4.</translation>
    </message>
    <message>
        <source>Then the tool moves %1 in a straight line to that point.</source>
        <translation>Dann fährt das Werkzeug %1 geradlinig zu diesem Punkt.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RightsPage</name>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>given</source>
        <translation>vorhanden</translation>
    </message>
    <message>
        <source>Asking the control …</source>
        <translation>Die Steuerung wird befragt …</translation>
    </message>
    <message>
        <source>A run is not possible with these rights.</source>
        <translation>Mit diesen Rechten ist kein Lauf möglich.</translation>
    </message>
    <message>
        <source>A run is possible; some steps remain to the operator.</source>
        <translation>Ein Lauf ist möglich; einige Schritte bleiben beim Bediener.</translation>
    </message>
    <message>
        <source>This user has all rights that a run needs.</source>
        <translation>Dieser Benutzer hat alle Rechte, die ein Lauf braucht.</translation>
    </message>
    <message>
        <source>More than a run needs: %1. Call DeleteUserAccess with them, or use a user of its own for Rivulet.</source>
        <translation>Mehr als ein Lauf braucht: %1. DeleteUserAccess damit aufrufen, oder für Rivulet einen eigenen Benutzer verwenden.</translation>
    </message>
    <message>
        <source>The server does not tell which other rights this user has. Look at the list of users on the control.</source>
        <translation>Der Server sagt nicht, welche anderen Rechte dieser Benutzer hat. In der Liste der Benutzer auf der Steuerung nachsehen.</translation>
    </message>
    <message>
        <source>Asks the control which of the rights that a run needs the user of this connection has. Nothing is changed.</source>
        <translation>Fragt die Steuerung, welche der Rechte, die ein Lauf braucht, der Benutzer dieser Verbindung hat. Nichts wird geändert.</translation>
    </message>
    <message>
        <source>Check the rights</source>
        <translation>Rechte prüfen</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunPanel</name>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ausgeführt</translation>
    </message>
    <message>
        <source>Start is not possible: %1</source>
        <translation>Start ist nicht möglich: %1</translation>
    </message>
    <message>
        <source>Ready to start</source>
        <translation>Startbereit</translation>
    </message>
    <message>
        <source>Stop confirmed after %1</source>
        <translation>Stopp bestätigt nach %1</translation>
    </message>
    <message>
        <source>Stop confirmed</source>
        <translation>Stopp bestätigt</translation>
    </message>
    <message>
        <source>Stop NOT confirmed: check the machine</source>
        <translation>Stopp NICHT bestätigt: Maschine prüfen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Fortsetzen …</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>The machine waits before the next window until you press Continue.</source>
        <translation>Die Maschine wartet vor dem nächsten Fenster, bis Weiter gedrückt wird.</translation>
    </message>
    <message>
        <source>Only method window can hold.</source>
        <translation>Nur das Verfahren Fenster kann anhalten.</translation>
    </message>
    <message>
        <source>Waiting for the test of the template on the virtual machine</source>
        <translation>Wartet auf die Prüfung der Vorlage an der virtuellen Maschine</translation>
    </message>
    <message>
        <source>Waiting for the transfer of the template to the control</source>
        <translation>Wartet auf die Übertragung der Vorlage an die Steuerung</translation>
    </message>
    <message>
        <source>Waiting for cycle start at the control</source>
        <translation>Wartet auf NC-Start an der Steuerung</translation>
    </message>
    <message>
        <source>Waiting for selection of the template and cycle start at the control</source>
        <translation>Wartet auf Anwahl der Vorlage und NC-Start an der Steuerung</translation>
    </message>
    <message>
        <source>Nothing comes from the control. Check cable, switch and server.</source>
        <translation>Die Steuerung antwortet nicht. Kabel, Switch und Server prüfen.</translation>
    </message>
    <message>
        <source>Waiting for the control&apos;s own trace</source>
        <translation>Wartet auf die Aufzeichnung der Steuerung</translation>
    </message>
    <message>
        <source>Waiting for %1</source>
        <translation>Wartet auf %1</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Gedrückt halten</translation>
    </message>
    <message>
        <source>Start over …</source>
        <translation>Von vorn …</translation>
    </message>
    <message>
        <source>Start …</source>
        <translation>Start …</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Eine Sekunde lang halten. Dann fährt die Maschine.</translation>
    </message>
    <message>
        <source>Shows what will happen first. Nothing moves yet.</source>
        <translation>Zeigt, was zuerst geschehen wird. Noch bewegt sich nichts.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>Nicht bereit</translation>
    </message>
    <message>
        <source>Stopped at %1</source>
        <translation>Gestoppt bei %1</translation>
    </message>
    <message>
        <source>Failed at %1</source>
        <translation>Fehlgeschlagen bei %1</translation>
    </message>
    <message>
        <source>Wrong motion</source>
        <translation>Falsche Bewegung</translation>
    </message>
    <message>
        <source>The run has executed wrong points: see the report.</source>
        <translation>Der Lauf hat falsche Punkte ausgeführt: siehe Bericht.</translation>
    </message>
    <message>
        <source>Resume goes on where the run was left.</source>
        <translation>Fortsetzen macht dort weiter, wo der Lauf verlassen wurde.</translation>
    </message>
    <message>
        <source>A new start begins at the first point.</source>
        <translation>Ein neuer Start beginnt beim ersten Punkt.</translation>
    </message>
    <message>
        <source>Waiting until the claim of another client lapses, because it may be dead (10 s)</source>
        <translation>Ein anderer Client hat die R-Parameter belegt, ist aber vielleicht abgestürzt. Die Belegung verfällt nach 10 s</translation>
    </message>
    <message>
        <source>Wrong motion. %1</source>
        <translation>Falsche Bewegung. %1</translation>
    </message>
    <message>
        <source>Watching run %1: it waits</source>
        <translation>Beobachte Lauf %1: er wartet</translation>
    </message>
    <message>
        <source>Watching run %1</source>
        <translation>Beobachte Lauf %1</translation>
    </message>
    <message>
        <source>A program waits on the control</source>
        <translation>Ein Programm wartet auf der Steuerung</translation>
    </message>
    <message>
        <source>Run %1 is on the control</source>
        <translation>Lauf %1 ist auf der Steuerung</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Restzeit</translation>
    </message>
    <message>
        <source>Points that are known to be executed</source>
        <translation>Punkte, die nachweislich ausgeführt sind</translation>
    </message>
    <message>
        <source>Only the computer that streams this run knows it.</source>
        <translation>Das weiß nur der Rechner, der diesen Lauf streamt.</translation>
    </message>
    <message>
        <source>No program is loaded.</source>
        <translation>Kein Programm geladen.</translation>
    </message>
    <message>
        <source>No point has been executed yet.</source>
        <translation>Noch ist kein Punkt ausgeführt.</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>Der Lauf ist beendet.</translation>
    </message>
    <message>
        <source>The time of the run is not estimated yet. During a run nothing is estimated.</source>
        <translation>Die Dauer des Laufs ist noch nicht geschätzt. Während eines Laufs wird nichts geschätzt.</translation>
    </message>
    <message>
        <source>%1, pauses %2</source>
        <translation>%1, Pausen %2</translation>
    </message>
    <message>
        <source>No run of this window is in progress.</source>
        <translation>Kein Lauf dieses Fensters ist im Gang.</translation>
    </message>
    <message>
        <source>Estimate of the time that is left, with the feeds and the planned pauses of this run. Hold and the feed override at the control are not included.</source>
        <translation>Geschätzte verbleibende Zeit mit den Vorschüben und den geplanten Pausen dieses Laufs. Halt und der Vorschub-Override an der Steuerung sind nicht enthalten.</translation>
    </message>
    <message>
        <source>%1: part %2 of %3</source>
        <translation>%1: Abschnitt %2 von %3</translation>
    </message>
    <message>
        <source>%1: the control, line %2</source>
        <translation>%1: Steuerung, Zeile %2</translation>
    </message>
    <message>
        <source>%1: the control</source>
        <translation>%1: Steuerung</translation>
    </message>
    <message>
        <source>The program waits for cycle start at the control</source>
        <translation>Das Programm wartet auf NC-Start an der Steuerung</translation>
    </message>
    <message>
        <source>The job waits before the next block until you press Continue.</source>
        <translation>Der Auftrag wartet vor dem nächsten Satz, bis Weiter gedrückt wird.</translation>
    </message>
    <message>
        <source>Before part %1 of %2</source>
        <translation>Vor Abschnitt %1 von %2</translation>
    </message>
    <message>
        <source>After the last part</source>
        <translation>Nach dem letzten Abschnitt</translation>
    </message>
    <message>
        <source>Streamed %1, pauses %2, tool changes %3, other blocks of the control %4. Cycles, measuring and stops are not included.</source>
        <translation>Gestreamt %1, Pausen %2, Werkzeugwechsel %3, andere Sätze der Steuerung %4. Zyklen, Messen und Stopps sind nicht enthalten.</translation>
    </message>
    <message>
        <source>%1, pauses %2, control %3</source>
        <translation>%1, Pausen %2, Steuerung %3</translation>
    </message>
    <message>
        <source>%1, control %2</source>
        <translation>%1, Steuerung %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows</source>
        <translation>
            <numerusform>%Ln Fenster</numerusform>
            <numerusform>%Ln Fenster</numerusform>
        </translation>
    </message>
    <message>
        <source>Points that are known to be executed, from point %1 on</source>
        <translation>Punkte, die nachweislich ausgeführt sind, ab Punkt %1</translation>
    </message>
    <message>
        <source>%1, dry run</source>
        <translation>%1, Trockenlauf</translation>
    </message>
    <message>
        <source>The live source is silent or wants a hold. The run goes on with its next point.</source>
        <translation>Die Live-Quelle schweigt oder will einen Halt. Der Lauf geht mit ihrem nächsten Punkt weiter.</translation>
    </message>
    <message>
        <source>Waiting for points of the live source</source>
        <translation>Wartet auf Punkte der Live-Quelle</translation>
    </message>
    <message>
        <source>A live source does not say when it ends.</source>
        <translation>Eine Live-Quelle sagt nicht, wann sie endet.</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Hier beenden</translation>
    </message>
    <message>
        <source>Hold for one second: the run ends. First the axes execute what the control still has of the window, with this override.</source>
        <translation>Eine Sekunde halten: Der Lauf endet. Zuvor fahren die Achsen mit diesem Override ab, was die Steuerung vom Fenster noch hat.</translation>
    </message>
    <message>
        <source>What moves now does not obey the override. Press NC STOP at the machine.</source>
        <translation>Was jetzt fährt, folgt dem Override nicht. NC-STOPP an der Maschine drücken.</translation>
    </message>
    <message>
        <source>Another client has set the override to %1 %</source>
        <translation>Ein anderer Client hat den Override auf %1 % gestellt</translation>
    </message>
    <message>
        <source>The axes are braking</source>
        <translation>Die Achsen bremsen</translation>
    </message>
    <message>
        <source>Override 0 %: the axes stand</source>
        <translation>Override 0 %: Die Achsen stehen</translation>
    </message>
    <message>
        <source>The axes stand at once, until you press Continue.</source>
        <translation>Die Achsen stehen sofort, bis Sie Weiter drücken.</translation>
    </message>
    <message>
        <source>The axes stand (%1 after the order). Continue goes on, End here ends the run</source>
        <translation>Die Achsen stehen (%1 nach dem Befehl). Weiter fährt fort, Hier beenden beendet den Lauf</translation>
    </message>
    <message>
        <source>Stop and Pause act at the end of the block</source>
        <translation>Stopp und Pause wirken am Ende des Satzes</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Its axes are held until the run is ended or resumed.</source>
        <translation>Seine Achsen werden gehalten, bis der Lauf beendet oder fortgesetzt wird.</translation>
    </message>
    <message>
        <source>This window only shows it. Stop holds its axes.</source>
        <translation>Dieses Fenster zeigt ihn nur. Stopp hält seine Achsen.</translation>
    </message>
    <message>
        <source>This window did not start it. Stop holds its axes.</source>
        <translation>Dieses Fenster hat ihn nicht gestartet. Stopp hält seine Achsen.</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves yet.</source>
        <translation>Fragt die Steuerung, wo der Lauf unterbrochen wurde. Noch bewegt sich nichts.</translation>
    </message>
    <message>
        <source>Line of the live source of the move that the tool is on</source>
        <translation>Zeile der Live-Quelle zur Bewegung, auf der das Werkzeug ist</translation>
    </message>
    <message>
        <source>Line of the program of the move that the tool is on</source>
        <translation>Programmzeile der Bewegung, auf der das Werkzeug ist</translation>
    </message>
    <message>
        <source>The tool is lifted by %1. Lower it, then the run can go on</source>
        <translation>Das Werkzeug ist um %1 abgehoben. Erst absenken, dann kann der Lauf weitergehen</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Absenken</translation>
    </message>
    <message>
        <source>Lift by %1</source>
        <translation>%1 abheben</translation>
    </message>
    <message>
        <source>The tool goes back to where it stood.</source>
        <translation>Das Werkzeug fährt dahin zurück, wo es stand.</translation>
    </message>
    <message>
        <source>The tool goes straight up; the path waits.</source>
        <translation>Das Werkzeug fährt gerade nach oben; die Bahn wartet.</translation>
    </message>
    <message>
        <source>Continue goes on without it</source>
        <translation>Weiter fährt ohne sie fort</translation>
    </message>
    <message>
        <source>stands in %1</source>
        <translation>steht in %1</translation>
    </message>
    <message>
        <source>The axes stand at once if the program obeys this computer&apos;s override, else at the end of its window. Escape does the same, from anywhere in the window. It does not replace the machine&apos;s emergency stop.</source>
        <translation>Die Achsen stehen sofort, wenn das Programm dem Override dieses Rechners gehorcht, sonst am Ende seines Fensters. Escape tut dasselbe, überall in diesem Fenster. Es ersetzt nicht den Not-Halt der Maschine.</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Datenstrom</translation>
    </message>
    <message>
        <source>Sent to the control: %1, confirmed by it: %2</source>
        <translation>An die Steuerung gesendet: %1, von ihr bestätigt: %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln moves in hand</source>
        <translation>
            <numerusform>%Ln Satz voraus</numerusform>
            <numerusform>%Ln Sätze voraus</numerusform>
        </translation>
    </message>
    <message>
        <source>Moves in hand: what the control has and has not executed yet.</source>
        <translation>Sätze voraus: was die Steuerung hat und noch nicht ausgeführt hat.</translation>
    </message>
    <message>
        <source>late, %1</source>
        <translation>zu spät, %1</translation>
    </message>
    <message>
        <source>on time, %1</source>
        <translation>rechtzeitig, %1</translation>
    </message>
    <message>
        <source>Margin %1: time until the control needs the next point, minus the 99th percentile of the access time</source>
        <translation>Reserve %1: Zeit, bis die Steuerung den nächsten Punkt braucht, minus 99. Perzentil der Zugriffszeit</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunsModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ausgeführt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausen</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Wer</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunsPage</name>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Open a report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>Reports (*.json)</source>
        <translation>Berichte (*.json)</translation>
    </message>
    <message>
        <source>All machines</source>
        <translation>Alle Maschinen</translation>
    </message>
    <message>
        <source>Runs: %1</source>
        <translation>Läufe: %1</translation>
    </message>
    <message>
        <source>Runs: %1 of %2</source>
        <translation>Läufe: %1 von %2</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Noch kein Lauf</translation>
    </message>
    <message>
        <source>No run is selected.</source>
        <translation>Kein Lauf ausgewählt.</translation>
    </message>
    <message>
        <source>%1, %2, version %3, %4</source>
        <translation>%1, %2, Fassung %3, %4</translation>
    </message>
    <message>
        <source>The run was not recorded.</source>
        <translation>Der Lauf wurde nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>Loads the program, compares it with the one of the run, and sets method and settings. Nothing starts.</source>
        <translation>Lädt das Programm, vergleicht es mit dem des Laufs und stellt Verfahren und Werte ein. Nichts startet.</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves.</source>
        <translation>Fragt die Steuerung, wo der Lauf unterbrochen wurde. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Only a run that was left on the connected control, with its program loaded, can be resumed.</source>
        <translation>Fortgesetzt werden kann nur ein Lauf, der auf der verbundenen Steuerung unterbrochen wurde und dessen Programm geladen ist.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Shows runs in which each word stands in some column</source>
        <translation>Zeigt Läufe, bei denen jedes Wort in irgendeiner Spalte steht</translation>
    </message>
    <message>
        <source>Search runs</source>
        <translation>Läufe durchsuchen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>All results</source>
        <translation>Alle Ergebnisse</translation>
    </message>
    <message>
        <source>Faultless</source>
        <translation>Fehlerfrei</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Nicht beurteilt</translation>
    </message>
    <message>
        <source>Failed or wrong</source>
        <translation>Fehlgeschlagen oder falsch</translation>
    </message>
    <message>
        <source>Table as CSV…</source>
        <translation>Tabelle als CSV…</translation>
    </message>
    <message>
        <source>Open a report…</source>
        <translation>Bericht öffnen…</translation>
    </message>
    <message>
        <source>A report that was exported here or printed by stream --json</source>
        <translation>Ein Bericht, der hier exportiert oder von stream --json ausgegeben wurde</translation>
    </message>
    <message>
        <source>Open in Traces</source>
        <translation>In Aufzeichnungen öffnen</translation>
    </message>
    <message>
        <source>Repeat with these settings</source>
        <translation>Mit diesen Werten wiederholen</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Page as PDF…</source>
        <translation>Blatt als PDF…</translation>
    </message>
    <message>
        <source>JSON…</source>
        <translation>JSON…</translation>
    </message>
    <message>
        <source>Keep at most</source>
        <translation>Höchstens behalten</translation>
    </message>
    <message>
        <source> runs</source>
        <translation> Läufe</translation>
    </message>
    <message>
        <source>Number of runs that are kept</source>
        <translation>Zahl der Läufe, die behalten werden</translation>
    </message>
    <message>
        <source>Size of reports and recordings that are kept</source>
        <translation>Größe der Berichte und Aufzeichnungen, die behalten werden</translation>
    </message>
    <message>
        <source>Others that cannot be shown: %1</source>
        <translation>Weitere, die nicht gezeigt werden können: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ScopeCurves</name>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Path, mm</source>
        <translation>Weg, mm</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ScopePane</name>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Remove the pane</source>
        <translation>Feld entfernen</translation>
    </message>
    <message>
        <source>Curves: %1</source>
        <translation>Kurven: %1</translation>
    </message>
    <message>
        <source>%1 to %2, from %3 to %4</source>
        <translation>%1 bis %2, von %3 bis %4</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SeriesModel</name>
    <message>
        <source>The control refused arrays of this size.</source>
        <translation>Die Steuerung hat Felder dieser Größe abgelehnt.</translation>
    </message>
    <message>
        <source>%1 were requested; there was no time for more.</source>
        <translation>%1 waren verlangt; für mehr reichte die Zeit nicht.</translation>
    </message>
    <message>
        <source>write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>read</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Zugriff</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größte</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>R-Parameter</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ServiceCard</name>
    <message>
        <source>Service at %1</source>
        <translation>Dienst %1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Remove this service from the board? It goes on with its work.</source>
        <translation>Diesen Dienst von der Tafel nehmen? Er arbeitet weiter.</translation>
    </message>
    <message>
        <source>Shows what the service says, and what can be done with it.</source>
        <translation>Zeigt, was der Dienst meldet und was mit ihm getan werden kann.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ServicePanel</name>
    <message>
        <source>Service at %1</source>
        <translation>Dienst %1</translation>
    </message>
    <message>
        <source>Service at %1, %2</source>
        <translation>Dienst %1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows late</source>
        <translation>
            <numerusform>%Ln Fenster zu spät</numerusform>
            <numerusform>%Ln Fenster zu spät</numerusform>
        </translation>
    </message>
    <message>
        <source>What Resume will do</source>
        <translation>Das geschieht beim Fortsetzen</translation>
    </message>
    <message>
        <source>What Start will do</source>
        <translation>Das geschieht beim Start</translation>
    </message>
    <message>
        <source>The service is working on it …</source>
        <translation>Der Dienst ist damit beschäftigt …</translation>
    </message>
    <message>
        <source>Nobody is logged in.</source>
        <translation>Niemand ist angemeldet.</translation>
    </message>
    <message>
        <source>Logged in: %1</source>
        <translation>Angemeldet: %1</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Hold to resume</source>
        <translation>Gedrückt halten</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Gedrückt halten</translation>
    </message>
    <message>
        <source>Start …</source>
        <translation>Start …</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Eine Sekunde lang halten. Dann fährt die Maschine.</translation>
    </message>
    <message>
        <source>Shows what will happen first. Nothing moves yet.</source>
        <translation>Zeigt, was zuerst geschehen wird. Noch bewegt sich nichts.</translation>
    </message>
    <message>
        <source>Log in …</source>
        <translation>Anmelden …</translation>
    </message>
    <message>
        <source>Change user …</source>
        <translation>Benutzer wechseln …</translation>
    </message>
    <message>
        <source>All machines</source>
        <translation>Alle Maschinen</translation>
    </message>
    <message>
        <source>Back to the board. The run goes on.</source>
        <translation>Zurück zur Tafel. Der Lauf geht weiter.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Ends the run of this machine after the window in motion. It does not replace the machine&apos;s emergency stop.</source>
        <translation>Beendet den Lauf dieser Maschine nach dem laufenden Fenster. Das ersetzt nicht den Not-Halt der Maschine.</translation>
    </message>
    <message>
        <source>The machine waits before the next window until you press Continue.</source>
        <translation>Die Maschine wartet vor dem nächsten Fenster, bis Weiter gedrückt wird.</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Fortsetzen …</translation>
    </message>
    <message>
        <source>&amp;Program</source>
        <translation>&amp;Programm</translation>
    </message>
    <message>
        <source>The service reads it in its folder of programs.</source>
        <translation>Der Dienst liest sie in seinem Ordner der Programme.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>The service reads the program and judges it. Nothing moves.</source>
        <translation>Der Dienst liest das Programm und beurteilt es. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>This service has users: log in before you give it commands.</source>
        <translation>Dieser Dienst hat Benutzer: erst anmelden, dann Befehle geben.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>P&amp;IN</translation>
    </message>
    <message>
        <source>A user of the service; empty: nobody.</source>
        <translation>Ein Benutzer des Dienstes; leer: niemand.</translation>
    </message>
    <message>
        <source>It is not kept.</source>
        <translation>Sie wird nicht gespeichert.</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Connects again as this user.</source>
        <translation>Verbindet neu als dieser Benutzer.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>These buttons act on %1. Those at the bottom of the window act on the machine that the window is connected with.</source>
        <translation>Diese Tasten wirken auf %1. Die am unteren Rand des Fensters wirken auf die Maschine, mit der das Fenster verbunden ist.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Hier beenden</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves yet.</source>
        <translation>Fragt die Steuerung, wo der Lauf unterbrochen wurde. Noch bewegt sich nichts.</translation>
    </message>
    <message>
        <source>choose or type a file in the folder of the service</source>
        <translation>Datei im Ordner des Dienstes wählen oder eintippen</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SetUpPage</name>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SignalPanel</name>
    <message>
        <source>Say what the columns of the file mean</source>
        <translation>Sagen, was die Spalten der Datei bedeuten</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>Spalten…</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the signals</source>
        <translation>Signale durchsuchen</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Pane</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>Show the signal in a pane of its own (Enter)</source>
        <translation>Das Signal in einem eigenen Feld zeigen (Eingabe)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Dazu</translation>
    </message>
    <message>
        <source>Show the signal in the current pane (Shift+Enter)</source>
        <translation>Das Signal im aktuellen Feld zeigen (Umschalt+Eingabe)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>Remove the signal from the panes (Delete)</source>
        <translation>Das Signal aus den Feldern nehmen (Entf)</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>A formula of signals, then Enter. Their names are in their tool tips.</source>
        <translation>Eine Formel aus Signalen, dann Eingabe. Ihre Namen stehen in ihren Kurzhinweisen.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SpectrumPanel</name>
    <message>
        <source>Frequencies need the time axis: choose it under Compare.</source>
        <translation>Frequenzen brauchen die Zeitachse: unter Vergleich wählen.</translation>
    </message>
    <message>
        <source>No curve is shown.</source>
        <translation>Keine Kurve wird gezeigt.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>Amplitude, %1</source>
        <translation>Amplitude, %1</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>Peak, Hz</source>
        <translation>Spitze, Hz</translation>
    </message>
    <message>
        <source>Between the cursors: %1 samples, %2 Hz</source>
        <translation>Zwischen den Cursorn: %1 Abtastwerte, %2 Hz</translation>
    </message>
    <message>
        <source>In the time shown: %1 samples, %2 Hz</source>
        <translation>In der sichtbaren Zeit: %1 Abtastwerte, %2 Hz</translation>
    </message>
    <message>
        <source>The samples are not evenly spaced: values between them were interpolated.</source>
        <translation>Die Abtastwerte liegen nicht in gleichen Abständen: Werte dazwischen wurden interpoliert.</translation>
    </message>
    <message>
        <source>Curve whose frequencies are shown</source>
        <translation>Kurve, deren Frequenzen gezeigt werden</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Peaks of the spectrum</source>
        <translation>Spitzen des Spektrums</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::StartSteps</name>
    <message>
        <source>Start a virtual machine</source>
        <translation>Virtuelle Maschine starten</translation>
    </message>
    <message>
        <source>Connect to a control …</source>
        <translation>Mit einer Steuerung verbinden …</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>Live …</source>
        <translation>Live …</translation>
    </message>
    <message>
        <source>Points from a program or a sensor, while they are made</source>
        <translation>Punkte aus einem Programm oder von einem Sensor, während sie entstehen</translation>
    </message>
    <message>
        <source>Three steps to a moving machine</source>
        <translation>In drei Schritten zur laufenden Maschine</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Your control by its address, or a virtual machine on this computer: the same program, and nothing real moves.</source>
        <translation>Ihre Steuerung mit ihrer Adresse, oder eine virtuelle Maschine auf diesem Computer: dasselbe Programm, und nichts Wirkliches bewegt sich.</translation>
    </message>
    <message>
        <source>Open a program</source>
        <translation>Programm öffnen</translation>
    </message>
    <message>
        <source>Any CAM program: SINUMERIK, ISO, LinuxCNC, Grbl, Heidenhain. Or the sample.</source>
        <translation>Ein CAM-Programm: SINUMERIK, ISO, LinuxCNC, Grbl, Heidenhain. Oder das Beispiel.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Start, below at the right, checks travel, tools and data rate, shows the first move, and waits for you.</source>
        <translation>Start, unten rechts, prüft Verfahrwege, Werkzeuge und Datenrate, zeigt die erste Bewegung und wartet auf Sie.</translation>
    </message>
    <message>
        <source>Nothing moves before you hold Start.</source>
        <translation>Nichts bewegt sich, bevor Sie Start halten.</translation>
    </message>
    <message>
        <source>Sample: %1</source>
        <translation>Beispiel: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::StopModel</name>
    <message>
        <source>Start</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Ursache</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TaskPanel</name>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>G code receiving</source>
        <translation>G-Code-Empfang</translation>
    </message>
    <message>
        <source>Interpreter</source>
        <translation>Interpreter</translation>
    </message>
    <message>
        <source>Discrete</source>
        <translation>Grobinterpolation</translation>
    </message>
    <message>
        <source>Forward-looking</source>
        <translation>Vorausschau</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Position control</source>
        <translation>Lageregelung</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Starts</translation>
    </message>
    <message>
        <source>Data, ms</source>
        <translation>Daten, ms</translation>
    </message>
    <message>
        <source>Processor, ms</source>
        <translation>Prozessor, ms</translation>
    </message>
    <message>
        <source>Mean, µs</source>
        <translation>Mittel, µs</translation>
    </message>
    <message>
        <source>Min, µs</source>
        <translation>Min., µs</translation>
    </message>
    <message>
        <source>Max, µs</source>
        <translation>Max., µs</translation>
    </message>
    <message>
        <source>Preempted</source>
        <translation>Verdrängt</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Puffer</translation>
    </message>
    <message>
        <source>Open a recording of the tasks</source>
        <translation>Aufzeichnung der Aufgaben öffnen</translation>
    </message>
    <message>
        <source>Save what the scheduler did</source>
        <translation>Speichern, was der Scheduler getan hat</translation>
    </message>
    <message>
        <source>Executes a program on virtual axes. No machine moves.</source>
        <translation>Führt ein Programm auf virtuellen Achsen aus. Keine Maschine bewegt sich.</translation>
    </message>
    <message>
        <source>%1: %2, %3 set points</source>
        <translation>%1: %2, %3 Sollwerte</translation>
    </message>
    <message>
        <source>%1 has ended: %2, %3 set points</source>
        <translation>%1 ist zu Ende: %2, %3 Sollwerte</translation>
    </message>
    <message>
        <source>%1 was stopped: %2, %3 set points</source>
        <translation>%1 wurde beendet: %2, %3 Sollwerte</translation>
    </message>
    <message>
        <source>Recording %1: %2, %3 set points</source>
        <translation>Aufzeichnung %1: %2, %3 Sollwerte</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>Beispiel</translation>
    </message>
    <message>
        <source>Program that the tasks execute</source>
        <translation>Programm, das die Aufgaben ausführen</translation>
    </message>
    <message>
        <source>Task dependency</source>
        <translation>Abhängigkeit der Aufgaben</translation>
    </message>
    <message>
        <source>Data flow</source>
        <translation>Datenfluss</translation>
    </message>
    <message>
        <source>Earliest starvation</source>
        <translation>Frühester Mangel</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Beständig</translation>
    </message>
    <message>
        <source>Which task gets the processor</source>
        <translation>Welche Aufgabe den Prozessor bekommt</translation>
    </message>
    <message>
        <source>Processors: %1</source>
        <translation>Prozessoren: %1</translation>
    </message>
    <message>
        <source>How many tasks run at a time</source>
        <translation>Wie viele Aufgaben gleichzeitig laufen</translation>
    </message>
    <message>
        <source>Cycle %1 ms</source>
        <translation>Zyklus %1 ms</translation>
    </message>
    <message>
        <source>Cycle of position control</source>
        <translation>Zyklus der Lageregelung</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Echtzeit</translation>
    </message>
    <message>
        <source>Position control comes before everything else on this computer</source>
        <translation>Die Lageregelung geht auf diesem Rechner allem anderen vor</translation>
    </message>
    <message>
        <source>Without real time, other programs of this computer can delay position control.</source>
        <translation>Ohne Echtzeit können andere Programme dieses Rechners die Lageregelung verzögern.</translation>
    </message>
    <message>
        <source>This computer does not allow real-time scheduling: position control runs like any other program, and others can delay it.</source>
        <translation>Dieser Rechner erlaubt keine Echtzeit: Die Lageregelung läuft wie jedes andere Programm, und andere können sie verzögern.</translation>
    </message>
    <message>
        <source>Execute</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>Execute the program in six tasks, on virtual axes</source>
        <translation>Das Programm in sechs Aufgaben ausführen, auf virtuellen Achsen</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>End the tasks; the virtual axes stand</source>
        <translation>Die Aufgaben beenden; die virtuellen Achsen stehen</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open a recording of a scheduler</source>
        <translation>Die Aufzeichnung eines Schedulers öffnen</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Tasks: starts, waiting for data and for a processor, time of a step</source>
        <translation>Aufgaben: Starts, Warten auf Daten und auf einen Prozessor, Dauer eines Schritts</translation>
    </message>
    <message>
        <source>Levels of the buffers</source>
        <translation>Füllstände der Puffer</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Füllstand</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TemplatePage</name>
    <message>
        <source>Save the template</source>
        <translation>Vorlage speichern</translation>
    </message>
    <message>
        <source>NC programs (*.MPF *.mpf)</source>
        <translation>NC-Programme (*.MPF *.mpf)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>No template: %1</source>
        <translation>Keine Vorlage: %1</translation>
    </message>
    <message>
        <source>No template yet</source>
        <translation>Noch keine Vorlage</translation>
    </message>
    <message>
        <source>%1, layout number %2</source>
        <translation>%1, Layoutnummer %2</translation>
    </message>
    <message>
        <source>Flexible program</source>
        <translation>Flexibles Programm</translation>
    </message>
    <message>
        <source>Save the steps</source>
        <translation>Schritte speichern</translation>
    </message>
    <message>
        <source>Steps to print…</source>
        <translation>Schritte drucken…</translation>
    </message>
    <message>
        <source>A page with the steps at the control, the rights, what the operator sees, and how it is taken back</source>
        <translation>Ein Blatt mit den Schritten an der Steuerung, den Rechten, was der Bediener sieht, und wie alles zurückgenommen wird</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>R-Parameter</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TextPane</name>
    <message>
        <source>Lines with this text</source>
        <translation>Zeilen mit diesem Text</translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Suchen (Strg+F)</translation>
    </message>
    <message>
        <source>Search the program text</source>
        <translation>Programmtext durchsuchen</translation>
    </message>
    <message>
        <source>Previous line with this text</source>
        <translation>Vorige Zeile mit diesem Text</translation>
    </message>
    <message>
        <source>Next line with this text</source>
        <translation>Nächste Zeile mit diesem Text</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Go to a line (Ctrl+G)</source>
        <translation>Zu einer Zeile gehen (Strg+G)</translation>
    </message>
    <message>
        <source>Go to line</source>
        <translation>Gehe zu Zeile</translation>
    </message>
    <message>
        <source>Follow the run</source>
        <translation>Dem Lauf folgen</translation>
    </message>
    <message>
        <source>The text shows the line that is being executed</source>
        <translation>Der Text zeigt die Zeile, die gerade ausgeführt wird</translation>
    </message>
    <message>
        <source>Previous part, or blocks that the control executes (Ctrl+Page Up)</source>
        <translation>Voriger Abschnitt oder Sätze, die die Steuerung ausführt (Strg+Bild auf)</translation>
    </message>
    <message>
        <source>Next part, or blocks that the control executes (Ctrl+Page Down)</source>
        <translation>Nächster Abschnitt oder Sätze, die die Steuerung ausführt (Strg+Bild ab)</translation>
    </message>
    <message>
        <source>Run from here …</source>
        <translation>Ab hier laufen lassen …</translation>
    </message>
    <message>
        <source>Start at the chosen line. First it is shown what would move.</source>
        <translation>An der gewählten Zeile starten. Zuerst wird gezeigt, was sich bewegen würde.</translation>
    </message>
    <message>
        <source>Search the text (Ctrl+F), or go to a line (Ctrl+G)</source>
        <translation>Im Text suchen (Strg+F) oder zu einer Zeile gehen (Strg+G)</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TimeStrip</name>
    <message>
        <source>Overview of the whole trace</source>
        <translation>Übersicht der ganzen Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TracePage</name>
    <message>
        <source>Trigger</source>
        <translation>Trigger</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Follow the newest samples</source>
        <translation>Den neuesten Messwerten folgen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Summe</translation>
    </message>
    <message>
        <source>No samples yet</source>
        <translation>Noch keine Messwerte</translation>
    </message>
    <message>
        <source>Live samples: read while the stream has time; short pauses may be missing from the curves</source>
        <translation>Live-Messwerte: gelesen, wenn das Streamen Zeit lässt; kurze Pausen können in den Kurven fehlen</translation>
    </message>
    <message>
        <source>The control&apos;s own trace: one sample every %1</source>
        <translation>Aufzeichnung der Steuerung: ein Wert alle %1</translation>
    </message>
    <message>
        <source>%1: pause %2</source>
        <translation>%1: Pause %2</translation>
    </message>
    <message>
        <source>Run of %1, %2. </source>
        <translation>Lauf vom %1, %2. </translation>
    </message>
    <message>
        <source>Open traces</source>
        <translation>Aufzeichnungen öffnen</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Alle Dateien</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Open recordings and traces; several are shown on one time axis</source>
        <translation>Aufzeichnungen öffnen; mehrere auf einer Zeitachse</translation>
    </message>
    <message>
        <source>Wheel: zoom. Drag: move. Ctrl and drag: zoom into a range. Click: cursor A. Shift and click: cursor B. Home: show all.</source>
        <translation>Rad: vergrößern. Ziehen: verschieben. Strg und Ziehen: Bereich vergrößern. Klick: Cursor A. Umschalt und Klick: Cursor B. Pos1: alles zeigen.</translation>
    </message>
    <message>
        <source>Stops, signals and cursors beside the curves</source>
        <translation>Stillstände, Signale und Cursor neben den Kurven</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Stillstände</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>%1: one sample every %2</source>
        <translation>%1: ein Abtastwert alle %2</translation>
    </message>
    <message>
        <source>Looking for stops …</source>
        <translation>Sucht Stillstände …</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Liest %1 …</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Samples as a table</source>
        <translation>Abtastwerte als Tabelle</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Save what the panes show</source>
        <translation>Speichern, was die Felder zeigen</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden. Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Arrangements of panes that are kept by name</source>
        <translation>Anordnungen der Felder, die unter einem Namen abgelegt sind</translation>
    </message>
    <message>
        <source>Save what the panes show: the samples as a table (CSV), or a picture (PNG, SVG, PDF)</source>
        <translation>Speichern, was die Felder zeigen: die Abtastwerte als Tabelle (CSV) oder ein Bild (PNG, SVG, PDF)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Shown beside the panes</source>
        <translation>Neben den Kurven gezeigt</translation>
    </message>
    <message>
        <source>Samples and events as HDF5</source>
        <translation>Abtastwerte und Ereignisse als HDF5</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TriggerPanel</name>
    <message>
        <source>The signal must go back this far before the trigger can fire again</source>
        <translation>So weit muss das Signal zurückgehen, bevor der Trigger wieder auslösen kann</translation>
    </message>
    <message>
        <source>An armed trigger stops the live view when it fires and shows what was before and after</source>
        <translation>Ein scharfer Trigger hält die Live-Anzeige an, wenn er auslöst, und zeigt, was davor und danach war</translation>
    </message>
    <message>
        <source>Once: what was caught stays. Every time: the next one takes its place.</source>
        <translation>Einmal: Was gefangen wurde, bleibt stehen. Jedes Mal: Der nächste tritt an seine Stelle.</translation>
    </message>
    <message>
        <source>How much is shown after the trigger</source>
        <translation>Wie viel nach dem Trigger gezeigt wird</translation>
    </message>
    <message>
        <source>How much is shown before the trigger</source>
        <translation>Wie viel vor dem Trigger gezeigt wird</translation>
    </message>
    <message>
        <source>Upper end of the range</source>
        <translation>Oberes Ende des Bereichs</translation>
    </message>
    <message>
        <source>Lower end of the range</source>
        <translation>Unteres Ende des Bereichs</translation>
    </message>
    <message>
        <source>Value at which the trigger fires</source>
        <translation>Wert, bei dem der Trigger auslöst</translation>
    </message>
    <message>
        <source>What the trigger waits for</source>
        <translation>Worauf der Trigger wartet</translation>
    </message>
    <message>
        <source>The signal that is watched during a run</source>
        <translation>Das Signal, das während eines Laufs beobachtet wird</translation>
    </message>
    <message>
        <source>every time (normal)</source>
        <translation>jedes Mal (normal)</translation>
    </message>
    <message>
        <source>once (single)</source>
        <translation>einmal (single)</translation>
    </message>
    <message>
        <source>an alarm comes</source>
        <translation>ein Alarm kommt</translation>
    </message>
    <message>
        <source>a pause begins</source>
        <translation>eine Pause beginnt</translation>
    </message>
    <message>
        <source>it is outside the range</source>
        <translation>es außerhalb des Bereichs ist</translation>
    </message>
    <message>
        <source>it is within the range</source>
        <translation>es im Bereich ist</translation>
    </message>
    <message>
        <source>it is at the level or below</source>
        <translation>es am Pegel oder darunter ist</translation>
    </message>
    <message>
        <source>it is at the level or above</source>
        <translation>es am Pegel oder darüber ist</translation>
    </message>
    <message>
        <source>it falls through the level</source>
        <translation>es unter den Pegel fällt</translation>
    </message>
    <message>
        <source>it rises through the level</source>
        <translation>es über den Pegel steigt</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Löst aus</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Danach</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Davor</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>Hysterese</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wenn</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Waiting for the next run</source>
        <translation>Wartet auf den nächsten Lauf</translation>
    </message>
    <message>
        <source>Waiting for the trigger</source>
        <translation>Wartet auf den Trigger</translation>
    </message>
    <message>
        <source>Triggered at %1. Waiting for the next</source>
        <translation>Ausgelöst bei %1. Wartet auf den nächsten</translation>
    </message>
    <message>
        <source>Triggered: waiting for the time after it</source>
        <translation>Ausgelöst: wartet auf die Zeit danach</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Nicht scharf</translation>
    </message>
    <message>
        <source>Triggered at %1. Cursor A is there.</source>
        <translation>Ausgelöst bei %1. Dort steht Cursor A.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Entschärfen</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TrustSheet</name>
    <message>
        <source>Is this the right machine?</source>
        <translation>Ist das die richtige Maschine?</translation>
    </message>
    <message>
        <source>The machine shows another certificate</source>
        <translation>Die Maschine zeigt ein anderes Zertifikat</translation>
    </message>
    <message>
        <source>The machine does not offer sufficient encryption</source>
        <translation>Die Maschine bietet keine ausreichende Verschlüsselung an</translation>
    </message>
    <message>
        <source>This computer has not connected to it before. Compare the fingerprint with the one that the control shows. If they are equal, accept it: from then on, only this certificate is trusted at this address.</source>
        <translation>Dieser Rechner war noch nie mit ihr verbunden. Den Fingerabdruck mit dem vergleichen, den die Steuerung zeigt. Sind sie gleich, annehmen: Von da an wird an dieser Adresse nur diesem Zertifikat vertraut.</translation>
    </message>
    <message>
        <source>Either somebody has renewed the certificate of the control, or another computer answers at its address and would get all commands. Ask who looks after the control. Do not connect if nobody has changed anything.</source>
        <translation>Entweder hat jemand das Zertifikat der Steuerung erneuert, oder unter ihrer Adresse antwortet ein anderer Rechner und bekäme alle Befehle. Den Betreuer der Steuerung fragen. Nicht verbinden, wenn niemand etwas geändert hat.</translation>
    </message>
    <message>
        <source>Better: switch encryption on at the control, then connect again. What you allow here is remembered for this machine until you take it back, and is marked as long as it is connected.</source>
        <translation>Besser: die Verschlüsselung an der Steuerung einschalten, dann neu verbinden. Was hier erlaubt wird, wird für diese Maschine gemerkt, bis es zurückgenommen wird, und ist gekennzeichnet, solange sie verbunden ist.</translation>
    </message>
    <message>
        <source>Until now this machine was connected encrypted. Somebody who stands between could hide the encryption.</source>
        <translation>Bisher war diese Maschine verschlüsselt verbunden. Jemand dazwischen könnte die Verschlüsselung verbergen.</translation>
    </message>
    <message>
        <source>Nothing that it offers lets this user in with an encrypted password.</source>
        <translation>Nichts davon lässt diesen Benutzer mit verschlüsseltem Passwort zu.</translation>
    </message>
    <message>
        <source>The certificate is not valid today, so it cannot be accepted. Set the clocks of both computers, or renew it on the control.</source>
        <translation>Das Zertifikat ist heute nicht gültig und kann nicht angenommen werden. Die Uhren beider Rechner stellen, oder es auf der Steuerung erneuern.</translation>
    </message>
    <message>
        <source>not kept</source>
        <translation>nicht aufbewahrt</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Shown now</source>
        <translation>Jetzt gezeigt</translation>
    </message>
    <message>
        <source>Accepted before</source>
        <translation>Früher angenommen</translation>
    </message>
    <message>
        <source>Fingerprint (SHA-256)</source>
        <translation>Fingerabdruck (SHA-256)</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Ausgestellt für</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>Ausgestellt von</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>Anwendung</translation>
    </message>
    <message>
        <source>Made for</source>
        <translation>Gemacht für</translation>
    </message>
    <message>
        <source>%1: not for %2</source>
        <translation>%1: nicht für %2</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Gültig</translation>
    </message>
    <message>
        <source>The control has to trust this computer, too. On a SINUMERIK, switch on in the dialog of the OPC UA server that client certificates are accepted by themselves, connect, and switch it off again; or import the file of this computer&apos;s certificate there. Its fingerprint: %1</source>
        <translation>Auch die Steuerung muss diesem Rechner vertrauen. Auf einer SINUMERIK im Dialog des OPC-UA-Servers einschalten, dass Client-Zertifikate automatisch angenommen werden, verbinden und wieder ausschalten; oder dort die Datei mit dem Zertifikat dieses Rechners importieren. Sein Fingerabdruck: %1</translation>
    </message>
    <message>
        <source>Do not connect</source>
        <translation>Nicht verbinden</translation>
    </message>
    <message>
        <source>Save this computer&apos;s certificate …</source>
        <translation>Zertifikat dieses Rechners speichern …</translation>
    </message>
    <message>
        <source>Hold: allow and connect</source>
        <translation>Halten: erlauben und verbinden</translation>
    </message>
    <message>
        <source>Hold: accept and connect</source>
        <translation>Halten: annehmen und verbinden</translation>
    </message>
    <message>
        <source>Hold it for one second, with the mouse, a finger or the space bar.</source>
        <translation>Eine Sekunde lang halten, mit Maus, Finger oder Leertaste.</translation>
    </message>
    <message>
        <source>%1: the server says that it is %2</source>
        <translation>%1: der Server nennt sich %2</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UserButton</name>
    <message>
        <source>Locked: log in</source>
        <translation>Gesperrt: anmelden</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Only Stop works. Log in with your PIN (Ctrl+L).</source>
        <translation>Nur Stopp wirkt. Mit der PIN anmelden (Strg+L).</translation>
    </message>
    <message>
        <source>Lock the window, or let somebody else in (Ctrl+L).</source>
        <translation>Das Fenster sperren oder jemand anderen anmelden (Strg+L).</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UserModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>set</source>
        <translation>gesetzt</translation>
    </message>
    <message>
        <source>none: user of this computer</source>
        <translation>keine: Benutzer dieses Rechners</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UsersPage</name>
    <message>
        <source>No users are set up: everybody at this window may do everything. To let operators start only what is released, add an engineer (name and PIN), then the operators.</source>
        <translation>Es sind keine Benutzer eingerichtet: Jeder an diesem Fenster darf alles. Damit Bediener nur Freigegebenes starten, zuerst einen Einrichter mit Name und PIN anlegen, dann die Bediener.</translation>
    </message>
    <message>
        <source>An operator starts what an engineer has released in the preflight, holds, stops and acknowledges. An engineer may do everything. In a locked window only Stop works. The user of this computer (%1) needs no PIN.</source>
        <translation>Ein Bediener startet, was ein Einrichter in der Startprüfung freigegeben hat, hält an, stoppt und quittiert. Ein Einrichter darf alles. In einem gesperrten Fenster wirkt nur Stopp. Der Benutzer dieses Rechners (%1) braucht keine PIN.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>PIN, at least 4 characters</source>
        <translation>PIN, mindestens 4 Zeichen</translation>
    </message>
    <message>
        <source>Lock the window if nobody touches it for</source>
        <translation>Fenster sperren, wenn niemand es bedient für</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Add or change</source>
        <translation>Anlegen oder ändern</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Benutzer</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::WrongMotionBar</name>
    <message>
        <source>Stop the run</source>
        <translation>Lauf stoppen</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
</context>
</TS>
