<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it" sourcelanguage="en">
<context>
    <name>AccessTexts</name>
    <message>
        <source>Access calibrated on %1 (%2): t = %3; read %4, write %5.</source>
        <translation>Accesso calibrato il %1 (%2): t = %3; lettura %4, scrittura %5.</translation>
    </message>
    <message>
        <source>list</source>
        <translation>lista</translation>
    </message>
    <message>
        <source>one by one</source>
        <translation>singolarmente</translation>
    </message>
    <message>
        <source>array, by count</source>
        <translation>array, per numero</translation>
    </message>
    <message>
        <source>array, by range</source>
        <translation>array, per intervallo</translation>
    </message>
    <message>
        <source>a server without a name</source>
        <translation>un server senza nome</translation>
    </message>
    <message>
        <source>Access is assumed: %1 for each R-parameter. See Calibration.</source>
        <translation>L’accesso è ipotizzato: %1 per parametro R. Vedere Calibrazione.</translation>
    </message>
    <message>
        <source>Access is assumed: %1 for each R-parameter. The calibration of %2 belongs to another version of the server and is not used.</source>
        <translation>L’accesso è ipotizzato: %1 per parametro R. La calibrazione del %2 appartiene a un’altra versione del server e non viene usata.</translation>
    </message>
    <message numerus="yes">
        <source>99 % of the writes of %n R-parameters end within %1.</source>
        <translation>
            <numerusform>Il 99 % delle scritture di %n parametro R termina entro %1.</numerusform>
            <numerusform>Il 99 % delle scritture di %n parametri R termina entro %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Up to %n R-parameters were measured.</source>
        <translation>
            <numerusform>Misurato fino a %n parametro R.</numerusform>
            <numerusform>Misurati fino a %n parametri R.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>AlarmTexts</name>
    <message>
        <source>The control reports alarm %1.</source>
        <translation>Il controllo segnala l’allarme %1.</translation>
    </message>
    <message>
        <source>The control has stopped or limits the machine; the number says why.</source>
        <translation>Il controllo ha arrestato la macchina o la limita; il numero indica il motivo.</translation>
    </message>
    <message>
        <source>Look up alarm %1 at the control, remove its cause, then press reset there.</source>
        <translation>Consultare l’allarme %1 sul controllo, eliminare la causa, poi premere Reset sul controllo.</translation>
    </message>
    <message>
        <source>The connection to %1 is lost.</source>
        <translation>La connessione a %1 è interrotta.</translation>
    </message>
    <message>
        <source>No connection to %1.</source>
        <translation>Nessuna connessione a %1.</translation>
    </message>
    <message>
        <source>Wrong motion in %1 (points repeated: %2, skipped: %3). The workpiece may be spoilt.</source>
        <translation>Movimento errato in %1 (punti ripetuti: %2, saltati: %3). Il pezzo potrebbe essere rovinato.</translation>
    </message>
    <message>
        <source>Points came too late for this feed with these settings.</source>
        <translation>I punti sono arrivati troppo tardi per questo avanzamento con queste impostazioni.</translation>
    </message>
    <message>
        <source>Check workpiece and tool. Choose a smaller feed, or method window.</source>
        <translation>Controllare pezzo e utensile. Scegliere un avanzamento minore o il metodo Finestra.</translation>
    </message>
    <message>
        <source>The run of %1 was ended by a fault.</source>
        <translation>L’esecuzione di %1 è stata terminata da un errore.</translation>
    </message>
    <message>
        <source>Check tool and workpiece, remove the cause, then resume or start again.</source>
        <translation>Controllare utensile e pezzo, eliminare la causa, poi riprendere o riavviare.</translation>
    </message>
    <message>
        <source>%1 ended before its end: %2 of %3 points were executed.</source>
        <translation>%1 è terminato in anticipo: eseguiti %2 punti su %3.</translation>
    </message>
    <message>
        <source>The control&apos;s trace lacks the last points.</source>
        <translation>Nella registrazione del controllo mancano gli ultimi punti.</translation>
    </message>
    <message>
        <source>Check tool and workpiece before you go on.</source>
        <translation>Controllare utensile e pezzo prima di continuare.</translation>
    </message>
    <message>
        <source>It is not known whether %1 was executed without a fault.</source>
        <translation>Non si sa se %1 è stato eseguito senza errori.</translation>
    </message>
    <message>
        <source>The control&apos;s trace could not be read, or is shorter than the run.</source>
        <translation>La registrazione del controllo non era leggibile o è più corta dell’esecuzione.</translation>
    </message>
    <message>
        <source>Check the workpiece.</source>
        <translation>Controllare il pezzo.</translation>
    </message>
    <message>
        <source>The run is not recorded.</source>
        <translation>L’esecuzione non viene registrata.</translation>
    </message>
    <message>
        <source>Nothing can be written to the folder %1.</source>
        <translation>Nella cartella %1 non si può scrivere nulla.</translation>
    </message>
    <message>
        <source>Check the folder, its permissions and the free space.</source>
        <translation>Controllare la cartella, i permessi e lo spazio libero.</translation>
    </message>
    <message>
        <source>The program file %1 has changed since it was read.</source>
        <translation>Il file programma %1 è cambiato da quando è stato letto.</translation>
    </message>
    <message>
        <source>Another program has written the file.</source>
        <translation>Un altro programma ha scritto il file.</translation>
    </message>
    <message>
        <source>Reload the file before you start.</source>
        <translation>Ricaricare il file prima dell’avvio.</translation>
    </message>
    <message>
        <source>The program file %1 is no longer there.</source>
        <translation>Il file programma %1 non esiste più.</translation>
    </message>
    <message>
        <source>It was deleted or moved, or its drive is not connected.</source>
        <translation>È stato eliminato o spostato, oppure la sua unità non è collegata.</translation>
    </message>
    <message>
        <source>Bring the file back, or go on with what was read before it disappeared.</source>
        <translation>Ripristinare il file, oppure continuare con quanto letto prima che sparisse.</translation>
    </message>
    <message>
        <source>The calibration of %1 has failed.</source>
        <translation>La calibrazione di %1 non è riuscita.</translation>
    </message>
    <message>
        <source>Remove the cause, then measure again.</source>
        <translation>Eliminare la causa, poi ripetere la misura.</translation>
    </message>
    <message>
        <source>The calibration of %1 is not saved.</source>
        <translation>La calibrazione di %1 non è salvata.</translation>
    </message>
    <message>
        <source>Check the folder and the free space, then measure again.</source>
        <translation>Controllare la cartella e lo spazio libero, poi ripetere la misura.</translation>
    </message>
    <message>
        <source>The history of alarms is not written to %1.</source>
        <translation>Lo storico degli allarmi non viene scritto in %1.</translation>
    </message>
    <message>
        <source>The audit trail is not written to %1.</source>
        <translation>Il registro operazioni non viene scritto in %1.</translation>
    </message>
    <message>
        <source>The audit trail %1 was changed: see line %2.</source>
        <translation>Il registro operazioni %1 è stato alterato: vedi riga %2.</translation>
    </message>
    <message>
        <source>A line was edited, inserted or removed after it was written.</source>
        <translation>Una riga è stata modificata, inserita o eliminata dopo la scrittura.</translation>
    </message>
    <message>
        <source>Keep a copy of the file and find out who changed it.</source>
        <translation>Conservare una copia del file e scoprire chi l’ha modificato.</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Controllo</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Connessione</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Esecuzione</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Computer</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Attivo</translation>
    </message>
    <message>
        <source>Active, acknowledged</source>
        <translation>Attivo, tacitato</translation>
    </message>
    <message>
        <source>Gone, not acknowledged</source>
        <translation>Rientrato, non tacitato</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>Accantonato</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Comparso</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>Rientrato</translation>
    </message>
    <message>
        <source>Acknowledged</source>
        <translation>Tacitato</translation>
    </message>
    <message>
        <source>Taken back</source>
        <translation>Ripristinato</translation>
    </message>
    <message>
        <source>Shelving expired</source>
        <translation>Accantonamento scaduto</translation>
    </message>
    <message>
        <source>Look at the machine: it may still move. Check cable and control, then connect again.</source>
        <translation>Guardare la macchina: può ancora muoversi. Controllare cavo e controllo, poi riconnettersi.</translation>
    </message>
    <message>
        <source>Wrong motion in %1 after point %2: points are repeated, or the tool has left the path.</source>
        <translation>Movimento errato in %1 dopo il punto %2: dei punti vengono ripetuti, o l’utensile ha lasciato il percorso.</translation>
    </message>
    <message>
        <source>Points came too late for this feed with these settings, or something else moves the axes.</source>
        <translation>I punti sono arrivati troppo tardi per questo avanzamento con queste impostazioni, o qualcos’altro muove gli assi.</translation>
    </message>
    <message>
        <source>Stop the run, then check workpiece and tool.</source>
        <translation>Fermare l’esecuzione, poi controllare il pezzo e l’utensile.</translation>
    </message>
    <message>
        <source>The recording of %1 was cut off: the first %2 s of the run are in it.</source>
        <translation>La registrazione di %1 è stata interrotta: contiene i primi %2 s dell’esecuzione.</translation>
    </message>
    <message>
        <source>Nothing more can be written to the folder %3: its disk is full, or too slow.</source>
        <translation>Nella cartella %3 non si può più scrivere: il disco è pieno o troppo lento.</translation>
    </message>
    <message>
        <source>Make room on the disk. A run in progress goes on without its recording; the next one is recorded.</source>
        <translation>Liberare spazio sul disco. Un’esecuzione in corso continua senza registrazione; la prossima viene registrata.</translation>
    </message>
</context>
<context>
    <name>AuditTexts</name>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continua</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Avvio</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Ripresa</translation>
    </message>
    <message>
        <source>Online correction</source>
        <translation>Correzione online</translation>
    </message>
    <message>
        <source>Program opened</source>
        <translation>Programma aperto</translation>
    </message>
    <message>
        <source>Settings changed</source>
        <translation>Impostazioni modificate</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connessione</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Disconnessione</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibrazione</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Approvato</translation>
    </message>
    <message>
        <source>Release taken back</source>
        <translation>Approvazione revocata</translation>
    </message>
    <message>
        <source>Alarm acknowledged</source>
        <translation>Allarme tacitato</translation>
    </message>
    <message>
        <source>Alarm shelved</source>
        <translation>Allarme accantonato</translation>
    </message>
    <message>
        <source>Users set up</source>
        <translation>Utenti configurati</translation>
    </message>
    <message>
        <source>Logged in</source>
        <translation>Accesso eseguito</translation>
    </message>
    <message>
        <source>Wrong PIN</source>
        <translation>PIN errato</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloccato</translation>
    </message>
    <message>
        <source>Rivulet started</source>
        <translation>Rivulet avviato</translation>
    </message>
    <message>
        <source>Rivulet ended</source>
        <translation>Rivulet terminato</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operatore</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>Attrezzista</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Osserva</translation>
    </message>
    <message>
        <source>Trust</source>
        <translation>Fiducia</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
</context>
<context>
    <name>BlockedTexts</name>
    <message>
        <source>A run is in progress.</source>
        <translation>Un’esecuzione è in corso.</translation>
    </message>
    <message>
        <source>Asking the control where the run was left.</source>
        <translation>Si chiede al controllo dove l’esecuzione si è interrotta.</translation>
    </message>
    <message>
        <source>A calibration is in progress.</source>
        <translation>Una calibrazione è in corso.</translation>
    </message>
    <message>
        <source>Connect to a control first.</source>
        <translation>Prima connettersi a un controllo.</translation>
    </message>
    <message>
        <source>Open a program first.</source>
        <translation>Prima aprire un programma.</translation>
    </message>
    <message>
        <source>The file of the program has changed: reload it.</source>
        <translation>Il file del programma è cambiato: ricaricarlo.</translation>
    </message>
    <message>
        <source>The program moves no axis.</source>
        <translation>Il programma non muove alcun asse.</translation>
    </message>
    <message>
        <source>The program needs a transformation of the control. No method can stream it.</source>
        <translation>Il programma richiede una trasformazione del controllo. Nessun metodo può trasmetterlo in continuo.</translation>
    </message>
    <message>
        <source>Parts of the program&apos;s path are not known: see the findings.</source>
        <translation>Parti del percorso non sono note: vedi le segnalazioni.</translation>
    </message>
    <message>
        <source>The program moves rotary axes: choose method window.</source>
        <translation>Il programma muove assi rotativi: scegliere il metodo Finestra.</translation>
    </message>
    <message>
        <source>The program moves %1, but the control does not have all of these axes.</source>
        <translation>Il programma muove %1, ma il controllo non ha tutti questi assi.</translation>
    </message>
    <message>
        <source>Not feasible: the control would repeat points. Change F, N or δ.</source>
        <translation>Non fattibile: il controllo ripeterebbe dei punti. Modificare F, N o δ.</translation>
    </message>
    <message>
        <source>Method credit starts only on a control that has passed its test: choose method window.</source>
        <translation>Il metodo Credito si avvia solo su un controllo che ha superato il test: scegliere il metodo Finestra.</translation>
    </message>
    <message>
        <source>The control reports an alarm.</source>
        <translation>Il controllo segnala un allarme.</translation>
    </message>
    <message>
        <source>A program is running on the control.</source>
        <translation>Sul controllo è in corso un programma.</translation>
    </message>
    <message>
        <source>There is no interrupted run of method window.</source>
        <translation>Non c’è alcuna esecuzione interrotta del metodo Finestra.</translation>
    </message>
    <message>
        <source>Only method window can resume an interrupted run.</source>
        <translation>Solo il metodo Finestra può riprendere un’esecuzione interrotta.</translation>
    </message>
    <message>
        <source>The program is being simulated.</source>
        <translation>Simulazione del programma in corso.</translation>
    </message>
    <message>
        <source>The simulation of this program failed in %1 of %2 runs. Change F, N or δ.</source>
        <translation>La simulazione di questo programma è fallita in %1 prove su %2. Modificare F, N o δ.</translation>
    </message>
    <message>
        <source>The window is locked: log in.</source>
        <translation>La finestra è bloccata: eseguire l’accesso.</translation>
    </message>
    <message>
        <source>Only an engineer may do this.</source>
        <translation>Consentito solo all’attrezzista.</translation>
    </message>
    <message>
        <source>Not released: an engineer has to release this program with these settings.</source>
        <translation>Non approvato: un attrezzista deve approvare questo programma con queste impostazioni.</translation>
    </message>
    <message>
        <source>A test of the control is in progress.</source>
        <translation>È in corso una prova del controllo.</translation>
    </message>
    <message>
        <source>The job is being compared with the machine.</source>
        <translation>Il lavoro viene confrontato con la macchina.</translation>
    </message>
    <message>
        <source>Live points need a machine that waits for them: choose method window or credit.</source>
        <translation>I punti in diretta richiedono una macchina che li attenda: scegliere il metodo Finestra o Credito.</translation>
    </message>
    <message>
        <source>Method %1 may execute old points again: if this computer is late for a moment, the tool goes back through the workpiece. Choose method window.</source>
        <translation>Il metodo %1 può eseguire di nuovo punti vecchi: se questo computer è in ritardo per un momento, l’utensile torna indietro attraverso il pezzo. Scegliere il metodo Finestra.</translation>
    </message>
</context>
<context>
    <name>CertificateTexts</name>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>sé stesso</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>non indicato</translation>
    </message>
</context>
<context>
    <name>ConnectionTexts</name>
    <message>
        <source>Not connected</source>
        <translation>Non connesso</translation>
    </message>
    <message>
        <source>Connecting …</source>
        <translation>Connessione…</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Connesso</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Connessione persa</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Interrotto</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrestato</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>In corso</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>In attesa</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Terminato</translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation>Sconosciuto (%1)</translation>
    </message>
    <message>
        <source>encrypted</source>
        <translation>cifrata</translation>
    </message>
    <message>
        <source>Nobody on the network can read or change what is sent.</source>
        <translation>Nessuno in rete può leggere o modificare ciò che viene inviato.</translation>
    </message>
    <message>
        <source>signed</source>
        <translation>firmata</translation>
    </message>
    <message>
        <source>Nobody can change what is sent, but everybody on the network can read it.</source>
        <translation>Nessuno può modificare ciò che viene inviato, ma tutti in rete possono leggerlo.</translation>
    </message>
    <message>
        <source>weakly encrypted</source>
        <translation>cifratura debole</translation>
    </message>
    <message>
        <source>This encryption was withdrawn: it can be broken with the means of today.</source>
        <translation>Questa cifratura è stata ritirata: si può violare con i mezzi di oggi.</translation>
    </message>
    <message>
        <source>not protected</source>
        <translation>non protetta</translation>
    </message>
    <message>
        <source>Not encrypted. What is sent does not leave this computer.</source>
        <translation>Non cifrata. Ciò che viene inviato non lascia questo computer.</translation>
    </message>
    <message>
        <source>Everybody on the network can read what is sent, and move the machine.</source>
        <translation>Tutti in rete possono leggere ciò che viene inviato e muovere la macchina.</translation>
    </message>
</context>
<context>
    <name>ControlSettings</name>
    <message>
        <source>R plane of a cycle without R: below the height before it, mm</source>
        <translation>Piano R di un ciclo senza R: sotto la quota precedente, mm</translation>
    </message>
    <message>
        <source>peck depth of G73 and G83 without Q, mm (0: in one stroke)</source>
        <translation>Profondità di passata di G73 e G83 senza Q, mm (0: in una sola corsa)</translation>
    </message>
    <message>
        <source>spindle speed of tapping without S, 1/min</source>
        <translation>Velocità del mandrino in maschiatura senza S, 1/min</translation>
    </message>
    <message>
        <source>direction in which a boring tool lifts off (X, -X, Y, -Y, Z, -Z)</source>
        <translation>Direzione in cui un utensile per alesare si stacca (X, -X, Y, -Y, Z, -Z)</translation>
    </message>
    <message>
        <source>lift-off of a boring tool without Q, mm</source>
        <translation>Distacco di un utensile per alesare senza Q, mm</translation>
    </message>
    <message>
        <source>angle of the spindle when a boring tool lifts off, degrees</source>
        <translation>Angolo del mandrino quando un utensile per alesare si stacca, gradi</translation>
    </message>
    <message>
        <source>an arc without centre and radius is a straight line</source>
        <translation>Un arco senza centro e raggio è una retta</translation>
    </message>
    <message>
        <source>settable work offset for G54.1 P1 (507: G507)</source>
        <translation>Spostamento origine impostabile per G54.1 P1 (507: G507)</translation>
    </message>
    <message>
        <source>retraction of G73 and G83 within the hole, mm</source>
        <translation>Arretramento di G73 e G83 nel foro, mm</translation>
    </message>
    <message>
        <source>before the start the tool stands where the first G92 says, in the work offset of the control</source>
        <translation>prima dell’avvio l’utensile è dove dice il primo G92, nello spostamento origine del controllo</translation>
    </message>
</context>
<context>
    <name>CreditTestTexts</name>
    <message>
        <source>%1 of %2 answers while busy, the slowest after %3</source>
        <translation>%1 risposte su %2 sotto carico, la più lenta dopo %3</translation>
    </message>
    <message>
        <source>Method credit lets the axes move on while the next window is on its way. That is safe only on a control that answers while its axes are busy. This test finds out: a program that moves no axis, for a few seconds. The channel must be in reset.</source>
        <translation>Con il metodo Credito gli assi proseguono mentre la finestra successiva è in arrivo. È sicuro solo su un controllo che risponde mentre i suoi assi sono occupati. Questo test lo verifica: un programma che non muove alcun asse, per pochi secondi. Il canale deve essere in Reset.</translation>
    </message>
    <message>
        <source>4. Numbers are sent and must come back while the control is busy.</source>
        <translation>4. Vengono inviati numeri che devono tornare mentre il controllo è occupato.</translation>
    </message>
    <message>
        <source>Not tested: method credit does not start on this control</source>
        <translation>Non testato: il metodo Credito non si avvia su questo controllo</translation>
    </message>
    <message>
        <source>Passed: method credit may run on this control</source>
        <translation>Superato: il metodo Credito è ammesso su questo controllo</translation>
    </message>
    <message>
        <source>Not passed: method credit does not start. Use method window.</source>
        <translation>Non superato: il metodo Credito non si avvia. Usare il metodo Finestra.</translation>
    </message>
    <message>
        <source>The control answers the client while blocks wait to be executed.</source>
        <translation>Il controllo risponde al client mentre dei blocchi attendono l’esecuzione.</translation>
    </message>
    <message>
        <source>What a synchronized action writes reaches the client.</source>
        <translation>Ciò che scrive un’azione sincrona arriva al client.</translation>
    </message>
    <message>
        <source>What a synchronized action writes reaches the program without a stop.</source>
        <translation>Ciò che scrive un’azione sincrona arriva al programma senza arresto.</translation>
    </message>
    <message>
        <source>A synchronized action before a block is executed with that block.</source>
        <translation>Un’azione sincrona prima di un blocco viene eseguita con quel blocco.</translation>
    </message>
    <message>
        <source>The program can tell, without a stop, whether blocks are waiting ($AC_IPO_BUF).</source>
        <translation>Il programma sa, senza arresto, se dei blocchi sono in attesa ($AC_IPO_BUF).</translation>
    </message>
</context>
<context>
    <name>DiagnosticTexts</name>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avviso</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Errore</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: the run does not wait here, and no tool is changed.</source>
        <translation>%1 non viene inviato al controllo: qui l’esecuzione non attende e nessun utensile viene cambiato.</translation>
    </message>
    <message>
        <source>A block with &quot;/&quot; is executed: Rivulet reads the program with block skip off.</source>
        <translation>Un blocco con «/» viene eseguito: Rivulet legge il programma senza esclusione dei blocchi.</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: set spindle, tool and coolant there.</source>
        <translation>%1 non viene inviato al controllo: impostare lì mandrino, utensile e refrigerante.</translation>
    </message>
    <message>
        <source>The character &quot;%1&quot; has no meaning here: remove it or put it into a comment.</source>
        <translation>Il carattere «%1» qui non ha significato: eliminarlo o metterlo in un commento.</translation>
    </message>
    <message>
        <source>The word %1 has no number.</source>
        <translation>Alla parola %1 manca il numero.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number: write digits with a decimal point.</source>
        <translation>«%1» non è un numero: scrivere cifre con il punto decimale.</translation>
    </message>
    <message>
        <source>A bracket is opened but not closed in this line: the rest of the line is not read.</source>
        <translation>In questa riga una parentesi viene aperta ma non chiusa: il resto della riga non viene letto.</translation>
    </message>
    <message>
        <source>Rivulet does not know the G function %1: its effect on the path is unknown.</source>
        <translation>Rivulet non conosce la funzione G %1: il suo effetto sul percorso è ignoto.</translation>
    </message>
    <message>
        <source>The word %1 is not understood here: its effect on the path is unknown.</source>
        <translation>La parola %1 qui non è compresa: il suo effetto sul percorso è ignoto.</translation>
    </message>
    <message>
        <source>%1 changes the path or the feed in a way that Rivulet does not support: post-process the program without it.</source>
        <translation>%1 modifica il percorso o l’avanzamento in un modo che Rivulet non supporta: postprocessare il programma senza questa funzione.</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: it does not change the path.</source>
        <translation>%1 non viene inviato al controllo: il percorso non cambia.</translation>
    </message>
    <message>
        <source>%1 contradict each other in one block: keep one of them.</source>
        <translation>%1 si contraddicono nello stesso blocco: tenerne una sola.</translation>
    </message>
    <message>
        <source>The word %1 appears twice in one block: keep one of them.</source>
        <translation>La parola %1 compare due volte nello stesso blocco: tenerne una sola.</translation>
    </message>
    <message>
        <source>The arc has no centre: give I, J, K, or a radius with an end point that differs from the start.</source>
        <translation>L’arco non ha centro: indicare I, J, K, oppure un raggio con un punto finale diverso da quello iniziale.</translation>
    </message>
    <message>
        <source>The arc&apos;s radius differs by %1 mm between start and end: check the centre, which is read as an increment from the start.</source>
        <translation>Il raggio dell’arco differisce di %1 mm tra inizio e fine: controllare il centro, che viene letto come incremento dall’inizio.</translation>
    </message>
    <message>
        <source>The arc&apos;s radius is too small to reach its end point (radius &lt; half chord, mm: %1).</source>
        <translation>Il raggio dell’arco è troppo piccolo per raggiungere il punto finale (raggio &lt; mezza corda, mm: %1).</translation>
    </message>
    <message>
        <source>The arc starts at an unknown position: program %1 with G0 or G1 before it.</source>
        <translation>L’arco inizia da una posizione ignota: programmare prima %1 con G0 o G1.</translation>
    </message>
    <message>
        <source>The increment of %1 starts at an unknown position: program %1 with G90 before it.</source>
        <translation>La quota incrementale di %1 parte da una posizione ignota: programmare prima %1 con G90.</translation>
    </message>
    <message>
        <source>The feed F%1 is not greater than 0.</source>
        <translation>L’avanzamento F%1 non è maggiore di 0.</translation>
    </message>
    <message>
        <source>The value of %1 is outside the range that Rivulet accepts.</source>
        <translation>Il valore di %1 è fuori dal campo ammesso da Rivulet.</translation>
    </message>
    <message>
        <source>An axis is programmed before any of G0 to G3: G1 is assumed, as after a reset of the control.</source>
        <translation>Un asse è programmato prima di qualsiasi G0 … G3: si assume G1, come dopo un Reset del controllo.</translation>
    </message>
    <message>
        <source>The centre word %1 is not in the plane of the arc: check G17, G18, G19.</source>
        <translation>La parola %1 per il centro non è nel piano dell’arco: controllare G17, G18, G19.</translation>
    </message>
    <message>
        <source>The program has more than %1 points: it is not read further. Split it.</source>
        <translation>Il programma ha più di %1 punti: la lettura si ferma qui. Dividerlo.</translation>
    </message>
    <message>
        <source>%1 more findings from here on are not listed.</source>
        <translation>Altre %1 segnalazioni da qui in poi non sono elencate.</translation>
    </message>
    <message>
        <source>Rivulet does not execute &quot;%1&quot;: its effect on the path is unknown.</source>
        <translation>Rivulet non esegue «%1»: il suo effetto sul percorso è ignoto.</translation>
    </message>
    <message>
        <source>The loop that ends here does not terminate: reading stopped after %1 repeated blocks. Check its condition.</source>
        <translation>Il loop che finisce qui non termina: la lettura si è fermata dopo %1 blocchi ripetuti. Controllarne la condizione.</translation>
    </message>
    <message>
        <source>The calculation has no result: %1.</source>
        <translation>Il calcolo non dà risultato: %1.</translation>
    </message>
    <message>
        <source>The sequence of the blocks is not known from here on: %1.</source>
        <translation>Da qui in poi la sequenza dei blocchi non è nota: %1.</translation>
    </message>
    <message>
        <source>The subprogram %1 is neither in this file nor in a file beside it: its points are missing.</source>
        <translation>Il sottoprogramma %1 non si trova né in questo file né in un file accanto: i suoi punti mancano.</translation>
    </message>
    <message>
        <source>%1 is a cycle of the control: its motions are missing here.</source>
        <translation>%1 è un ciclo del controllo: i suoi movimenti qui mancano.</translation>
    </message>
    <message>
        <source>%1 moves in machine coordinates, whose position in the workpiece is not known: the move is left out.</source>
        <translation>%1 si muove in coordinate macchina, la cui posizione rispetto al pezzo non è nota: il movimento viene omesso.</translation>
    </message>
    <message>
        <source>The file holds bytes that do not occur in NC text: choose a text file, not an archive or a picture.</source>
        <translation>Il file contiene byte che non compaiono in un testo NC: scegliere un file di testo, non un archivio o un’immagine.</translation>
    </message>
    <message>
        <source>%1 is left out because you accepted it: the path may differ from the path at the control.</source>
        <translation>%1 viene omesso perché è stato accettato: il percorso può differire da quello sul controllo.</translation>
    </message>
    <message>
        <source>All arcs of the program fit if I, J and K are read as %1: check how the post-processor writes them, and load the program that way.</source>
        <translation>Tutti gli archi del programma tornano se I, J e K sono letti come %1: controllare come li scrive il postprocessor e caricare così il programma.</translation>
    </message>
    <message>
        <source>The program moves no axis: there is nothing to stream. Choose a program with G0, G1, G2 or G3 and X, Y or Z.</source>
        <translation>Il programma non muove alcun asse: non c’è nulla da trasmettere. Scegliere un programma con G0, G1, G2 o G3 e X, Y o Z.</translation>
    </message>
    <message>
        <source>%1 moves on the path: only method window streams it, and only if this axis is selected.</source>
        <translation>%1 si muove lungo il percorso: solo il metodo Finestra lo trasmette, e solo se questo asse è selezionato.</translation>
    </message>
    <message>
        <source>With %1, X, Y and Z are those of the tool tip while rotary axes turn, and no method switches it on at the control. Post-process the program for the axes of the machine.</source>
        <translation>Con %1, X, Y e Z sono quelli della punta dell’utensile mentre gli assi rotativi girano, e nessun metodo lo attiva sul controllo. Postprocessare il programma per gli assi della macchina.</translation>
    </message>
    <message>
        <source>%1 give the tool direction. The points keep it, but only the control could convert it to rotary axes. Post-process the program with A, B or C.</source>
        <translation>%1 indicano la direzione dell’utensile. I punti la mantengono, ma solo il controllo potrebbe convertirla in assi rotativi. Postprocessare il programma con A, B o C.</translation>
    </message>
    <message>
        <source>A block moves with G1, G2 or G3 before a feed F is programmed: only a fixed feed can be used.</source>
        <translation>Un blocco si muove con G1, G2 o G3 prima che sia programmato un avanzamento F: si può usare solo un avanzamento fisso.</translation>
    </message>
    <message>
        <source>A blank is inside the number &quot;%1&quot;: this control does not put the parts together. Write the number without blanks.</source>
        <translation>Nel numero «%1» c’è uno spazio: questo controllo non unisce le parti. Scrivere il numero senza spazi.</translation>
    </message>
    <message>
        <source>An invisible character stands here (%1), as office programs and web pages insert it: replace it by an ordinary blank.</source>
        <translation>Qui c’è un carattere invisibile (%1), come lo inseriscono programmi da ufficio e pagine web: sostituirlo con uno spazio normale.</translation>
    </message>
    <message>
        <source>A bracket is opened within the comment %1, which ends at the first closing bracket. Write it without inner brackets.</source>
        <translation>Nel commento %1 si apre una parentesi; termina alla prima parentesi chiusa. Scriverlo senza parentesi interne.</translation>
    </message>
    <message>
        <source>%1 is a function of the builder of the machine: whether it moves an axis or changes the feed is not known. Accept it if it does not.</source>
        <translation>%1 è una funzione del costruttore della macchina: non si sa se muove un asse o cambia l’avanzamento. Accettarla se non lo fa.</translation>
    </message>
    <message>
        <source>The blocks of %1 are never executed: check the end of the program and the jumps before them, or remove them.</source>
        <translation>I blocchi di %1 non vengono mai eseguiti: controllare la fine del programma e i salti precedenti, oppure eliminarli.</translation>
    </message>
    <message>
        <source>No block calls the subprogram %1: check the calls, or remove it.</source>
        <translation>Nessun blocco chiama il sottoprogramma %1: controllare le chiamate, oppure eliminarlo.</translation>
    </message>
    <message>
        <source>The file holds another main program, %1: which one is to run is not known. Give each main program a file of its own.</source>
        <translation>Il file contiene un altro programma principale, %1: non si sa quale deve essere eseguito. Dare a ogni programma principale un file proprio.</translation>
    </message>
    <message>
        <source>With M99, a main program begins again at the control, without end: it is executed once here. Write M30 if it is to end.</source>
        <translation>Con M99 un programma principale ricomincia senza fine sul controllo: qui viene eseguito una volta. Scrivere M30 se deve terminare.</translation>
    </message>
    <message>
        <source>Loops and calls repeat more than %1 blocks for the control: the program is not read further. Check the condition of the loop.</source>
        <translation>Cicli e chiamate ripetono più di %1 blocchi per il controllo: il programma non viene letto oltre. Controllare la condizione del ciclo.</translation>
    </message>
    <message>
        <source>The program is for a lathe (%1): X is read as a diameter, U and W as increments, the plane is Z X, and with G99 F is per revolution.</source>
        <translation>Il programma è per un tornio (%1): X viene letto come diametro, U e W come incrementi, il piano è Z X e con G99 F è per giro.</translation>
    </message>
    <message>
        <source>No block says mm or inch (G21, G20) before the first move: the size is %1, read as mm or as inch. Load it with its unit (--units).</source>
        <translation>Nessun blocco indica mm o pollici (G21, G20) prima del primo movimento: la dimensione è %1, letta in mm o in pollici. Caricarlo con la sua unità (--units).</translation>
    </message>
    <message>
        <source>Coordinates have no decimal point: the size is %1, read as whole units or as least increments. Load it as the control is set (--no-point).</source>
        <translation>Le coordinate non hanno punto decimale: la dimensione è %1, letta in unità intere o in incrementi minimi. Caricarlo secondo l’impostazione del controllo (--no-point).</translation>
    </message>
    <message>
        <source>The program is larger than a machine (%1): check its unit (G20, G21, --units) and its decimal points.</source>
        <translation>Il programma è più grande di una macchina (%1): controllare l’unità (G20, G21, --units) e i punti decimali.</translation>
    </message>
    <message>
        <source>The words after &quot;;&quot; are read as a block of their own, as on the control. If &quot;;&quot; begins comments here, choose another dialect (--dialect).</source>
        <translation>Le parole dopo «;» vengono lette come un blocco a sé, come sul controllo. Se «;» inizia qui commenti, scegliere un altro dialetto (--dialect).</translation>
    </message>
    <message>
        <source>The text does not show which control it is for, and they differ from here on: %1. Choose the dialect (--dialect).</source>
        <translation>Il testo non mostra per quale controllo è, e da qui differiscono: %1. Scegliere il dialetto (--dialect).</translation>
    </message>
    <message>
        <source>The file has words of two controls (%1): split it, or choose the dialect (--dialect).</source>
        <translation>Il file contiene parole di due controlli (%1): dividerlo, oppure scegliere il dialetto (--dialect).</translation>
    </message>
    <message>
        <source>The corner cannot be rounded or chamfered: there must be an element of the contour before and behind it, both long enough.</source>
        <translation>Lo spigolo non può essere arrotondato né smussato: prima e dopo deve esserci un elemento di contorno abbastanza lungo.</translation>
    </message>
    <message>
        <source>The program ends here with its own error (%1): check the values it has been given.</source>
        <translation>Il programma termina qui con un proprio errore (%1): controllare i valori che ha ricevuto.</translation>
    </message>
    <message>
        <source>The block lacks a word that the control needs (%1): add it.</source>
        <translation>Al blocco manca una parola di cui il controllo ha bisogno (%1): aggiungerla.</translation>
    </message>
    <message>
        <source>%1 is not the number of the tool in the spindle: check which length it stands for.</source>
        <translation>%1 non è il numero dell’utensile nel mandrino: verificare a quale lunghezza corrisponde.</translation>
    </message>
    <message>
        <source>%1 executes a text that is put together while the program runs: what it does is not known here. Write the block itself.</source>
        <translation>%1 esegue un testo che viene composto durante l’esecuzione del programma: qui non si sa che cosa fa. Scrivere il blocco stesso.</translation>
    </message>
    <message>
        <source>%1 limits the speed of an axis, and a stream does not keep the limit: program a feed that keeps it, and remove the word.</source>
        <translation>%1 limita la velocità di un asse, e un flusso non rispetta il limite: programmare un avanzamento che lo rispetti e togliere la parola.</translation>
    </message>
    <message>
        <source>%1 calls a subprogram behind each block that moves, and it is neither in this file nor in a file beside it: its motions are missing. Put its file beside the program.</source>
        <translation>%1 chiama dopo ogni blocco con movimento un sottoprogramma che non è né in questo file né in uno accanto: mancano i suoi movimenti. Mettere il suo file accanto al programma.</translation>
    </message>
    <message>
        <source>What the program leaves out is taken from the settings of a virtual machine: %1. Load it as the control is set (--setting).</source>
        <translation>Ciò che il programma omette è preso dalle impostazioni di una macchina virtuale: %1. Caricarlo come è impostato il controllo (--setting).</translation>
    </message>
    <message>
        <source>The number of the last F may mean another feed here, because mm, inch, G94 or G95 was chosen behind it: program F again.</source>
        <translation>Il numero dell&apos;ultimo F può significare qui un altro avanzamento, perché dopo sono stati scelti mm, pollici, G94 o G95: programmare di nuovo F.</translation>
    </message>
</context>
<context>
    <name>EmulatorPageTexts</name>
    <message>
        <source>A run is in progress. Learn after it has ended: both would take the same processor.</source>
        <translation>È in corso un’esecuzione. Apprendere dopo: entrambe userebbero lo stesso processore.</translation>
    </message>
</context>
<context>
    <name>EmulatorTexts</name>
    <message>
        <source>Position gain</source>
        <translation>Guadagno di posizione</translation>
    </message>
    <message>
        <source>The larger it is, the smaller the following error.</source>
        <translation>Più è grande, più piccolo è l’errore di inseguimento.</translation>
    </message>
    <message>
        <source>Feed-forward</source>
        <translation>Azione in avanti</translation>
    </message>
    <message>
        <source>Share of the speed that needs no following error. With 1 there is none at constant speed.</source>
        <translation>Parte della velocità che non richiede errore di inseguimento. Con 1 non ce n’è a velocità costante.</translation>
    </message>
    <message>
        <source>Filter of the feed-forward</source>
        <translation>Filtro dell’azione in avanti</translation>
    </message>
    <message>
        <source>How late the feed-forward takes effect.</source>
        <translation>Con quale ritardo agisce l’azione in avanti.</translation>
    </message>
    <message>
        <source>Speed gain</source>
        <translation>Guadagno di velocità</translation>
    </message>
    <message>
        <source>How quickly the drive reaches the speed it is told.</source>
        <translation>Quanto in fretta l’azionamento raggiunge la velocità richiesta.</translation>
    </message>
    <message>
        <source>Reset time</source>
        <translation>Tempo integrale</translation>
    </message>
    <message>
        <source>How soon the drive removes the rest of an error in speed.</source>
        <translation>In quanto tempo l’azionamento elimina il resto di un errore di velocità.</translation>
    </message>
    <message>
        <source>Lag of the drive</source>
        <translation>Ritardo dell’azionamento</translation>
    </message>
    <message>
        <source>How late the force follows its command.</source>
        <translation>Con quale ritardo la forza segue il comando.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Attrito</translation>
    </message>
    <message>
        <source>Force against every motion, as the acceleration it costs. It makes the bumps where an axis reverses.</source>
        <translation>Forza contro ogni movimento, espressa dall’accelerazione che costa. Causa i picchi dove un asse si inverte.</translation>
    </message>
    <message>
        <source>Speed of friction</source>
        <translation>Velocità dell’attrito</translation>
    </message>
    <message>
        <source>From this speed on, friction has its full force.</source>
        <translation>Da questa velocità l’attrito agisce per intero.</translation>
    </message>
    <message>
        <source>Viscous friction</source>
        <translation>Attrito viscoso</translation>
    </message>
    <message>
        <source>Friction that grows with the speed.</source>
        <translation>Attrito che cresce con la velocità.</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Ritardo puro</translation>
    </message>
    <message>
        <source>Time until a set point takes effect.</source>
        <translation>Tempo prima che un valore nominale abbia effetto.</translation>
    </message>
    <message>
        <source>Resonance</source>
        <translation>Risonanza</translation>
    </message>
    <message>
        <source>Frequency at which motor and table swing against each other.</source>
        <translation>Frequenza con cui motore e tavola oscillano l’uno contro l’altra.</translation>
    </message>
    <message>
        <source>Damping of the resonance</source>
        <translation>Smorzamento della risonanza</translation>
    </message>
    <message>
        <source>The smaller it is, the longer the axis oscillates. At 1 it does not oscillate.</source>
        <translation>Più è piccolo, più a lungo dura l’oscillazione; con 1 non ce n’è.</translation>
    </message>
    <message>
        <source>On %1, which it was not learned from, positions are right within %2 (RMS), %3 at most.</source>
        <translation>Su %1, da cui non ha appreso, le posizioni sono giuste entro %2 (RMS), al massimo %3.</translation>
    </message>
    <message>
        <source>The contour error there is off by %1 of %2 (RMS).</source>
        <translation>L’errore di contorno lì si scosta di %1 su %2 (RMS).</translation>
    </message>
    <message>
        <source>Good for simulating and timing programs that move %1 at feeds up to %2. What is faster was not tested.</source>
        <translation>Buono per simulare programmi che muovono %1 fino a %2 e stimarne la durata. Oltre non è verificato.</translation>
    </message>
    <message>
        <source>Do not rely on the contour errors that it predicts.</source>
        <translation>Non fare affidamento sugli errori di contorno previsti.</translation>
    </message>
    <message>
        <source>Limits of speed, acceleration and jerk are those of preset %1: correct them in the file if the machine has others.</source>
        <translation>I limiti di velocità, accelerazione e jerk sono quelli del preset %1: correggerli nel file se la macchina ne ha altri.</translation>
    </message>
    <message>
        <source>Acceleration and jerk are limited as the set points show (%1), all else as in preset %2.</source>
        <translation>Accelerazione e jerk sono limitati come mostrano i valori nominali (%1), tutto il resto come nel preset %2.</translation>
    </message>
    <message>
        <source>It was tested only on parts of the same recordings: right within %1 (RMS). Add a recording of another program and use it to test.</source>
        <translation>È stato verificato solo su parti delle stesse registrazioni: giusto entro %1 (RMS). Aggiungere la registrazione di un altro programma e usarla per la verifica.</translation>
    </message>
</context>
<context>
    <name>ErrorTexts</name>
    <message>
        <source>Two columns have the same meaning. Choose one of them.</source>
        <translation>Due colonne hanno lo stesso significato. Sceglierne una.</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it exists and that you may read it.</source>
        <translation>Impossibile leggere il file. Controllare che esista e che sia permesso leggerlo.</translation>
    </message>
    <message>
        <source>The program is empty. Choose a file with NC blocks.</source>
        <translation>Il programma è vuoto. Scegliere un file con blocchi NC.</translation>
    </message>
    <message>
        <source>The program moves no axis. Choose a program with G0, G1, G2 or G3.</source>
        <translation>Il programma non muove alcun asse. Scegliere un programma con G0, G1, G2 o G3.</translation>
    </message>
    <message>
        <source>Parts of the program are not understood. See the list of findings.</source>
        <translation>Parti del programma non sono comprese. Vedi l’elenco delle segnalazioni.</translation>
    </message>
    <message>
        <source>The feed F must be between 0.001 and 1 000 000 mm/min.</source>
        <translation>L’avanzamento F deve essere compreso tra 0,001 e 1 000 000 mm/min.</translation>
    </message>
    <message>
        <source>The distance δ must be greater than zero.</source>
        <translation>La distanza δ deve essere maggiore di zero.</translation>
    </message>
    <message>
        <source>N is too small. Choose at least 2 points per loop.</source>
        <translation>N è troppo piccolo. Scegliere almeno 2 punti per loop.</translation>
    </message>
    <message>
        <source>N is too small for this method. Choose more points per loop.</source>
        <translation>N è troppo piccolo per questo metodo. Scegliere più punti per loop.</translation>
    </message>
    <message>
        <source>N points do not fit the R-parameters of the control. Choose a smaller N, the contiguous layout, or enlarge MD28050.</source>
        <translation>N punti non entrano nei parametri R del controllo. Scegliere un N minore, il layout contiguo, oppure aumentare MD28050.</translation>
    </message>
    <message>
        <source>No axis is chosen. Choose at least one axis.</source>
        <translation>Nessun asse selezionato. Selezionare almeno un asse.</translation>
    </message>
    <message>
        <source>The file cannot be written. Choose another folder.</source>
        <translation>Impossibile scrivere il file. Scegliere un’altra cartella.</translation>
    </message>
    <message>
        <source>This file is not a Rivulet recording.</source>
        <translation>Questo file non è una registrazione di Rivulet.</translation>
    </message>
    <message>
        <source>The recording was written by a newer Rivulet. Update this program to read it.</source>
        <translation>La registrazione è di una versione più recente di Rivulet. Aggiornare questo programma per leggerla.</translation>
    </message>
    <message>
        <source>The recording is damaged. Everything before the damage was kept.</source>
        <translation>La registrazione è danneggiata. Tutto ciò che precede il danno è stato conservato.</translation>
    </message>
    <message>
        <source>The file cannot be written. Check the folder and the free space.</source>
        <translation>Impossibile scrivere il file. Controllare la cartella e lo spazio libero.</translation>
    </message>
    <message>
        <source>The program has been changed since the interrupted run. Restore it, or start from the beginning.</source>
        <translation>Il programma è cambiato dopo l’esecuzione interrotta. Ripristinarlo o ripartire dall’inizio.</translation>
    </message>
    <message>
        <source>No OPC UA server answers at this endpoint. Check address, port and network.</source>
        <translation>Nessun server OPC UA risponde a questo indirizzo. Controllare indirizzo, porta e rete.</translation>
    </message>
    <message>
        <source>The connection to the control is lost. Check the machine, then connect again.</source>
        <translation>La connessione al controllo è persa. Controllare la macchina, poi riconnettersi.</translation>
    </message>
    <message>
        <source>The control did not answer in time. Check the network and its load.</source>
        <translation>Il controllo non ha risposto in tempo. Controllare la rete e il suo carico.</translation>
    </message>
    <message>
        <source>The control does not have a variable that Rivulet needs. Check the configuration of the server.</source>
        <translation>Al controllo manca una variabile necessaria a Rivulet. Controllare la configurazione del server.</translation>
    </message>
    <message>
        <source>A variable is write-protected. Give this user write access on the control.</source>
        <translation>Una variabile è protetta da scrittura. Dare a questo utente il diritto di scrittura sul controllo.</translation>
    </message>
    <message>
        <source>A value cannot be used; nothing was sent.</source>
        <translation>Un valore non è utilizzabile; non è stato inviato nulla.</translation>
    </message>
    <message>
        <source>The control rejected the request.</source>
        <translation>Il controllo ha rifiutato la richiesta.</translation>
    </message>
    <message>
        <source>The server is not a SINUMERIK (no SinumerikVarProvider). Check the endpoint.</source>
        <translation>Il server non è una SINUMERIK (manca SinumerikVarProvider). Controllare l’indirizzo.</translation>
    </message>
    <message>
        <source>The server does not offer this function.</source>
        <translation>Il server non offre questa funzione.</translation>
    </message>
    <message>
        <source>There is no such program on the control. Send the template first.</source>
        <translation>Questo programma non esiste sul controllo. Inviare prima il modello.</translation>
    </message>
    <message>
        <source>The channel is not in reset. Press reset at the control, then try again.</source>
        <translation>Il canale non è in Reset. Premere Reset sul controllo, poi riprovare.</translation>
    </message>
    <message>
        <source>A program of this name is already on the control.</source>
        <translation>Sul controllo c’è già un programma con questo nome.</translation>
    </message>
    <message>
        <source>The request is larger than the server accepts. Choose a smaller N.</source>
        <translation>La richiesta è più grande di quanto accetta il server. Scegliere un N minore.</translation>
    </message>
    <message>
        <source>This program cannot be streamed. See the list of findings.</source>
        <translation>Questo programma non può essere trasmesso in continuo. Vedi l’elenco delle segnalazioni.</translation>
    </message>
    <message>
        <source>The control does not run the expected template. Select and start the template for these settings.</source>
        <translation>Sul controllo non è in corso il modello previsto. Selezionare e avviare il modello di queste impostazioni.</translation>
    </message>
    <message>
        <source>Another program is running on the control. Wait until it has ended, or reset the channel.</source>
        <translation>Sul controllo è in corso un altro programma. Attendere che finisca o resettare il canale.</translation>
    </message>
    <message>
        <source>Cycle start was not pressed in time. Start the run again.</source>
        <translation>Start NC non è stato premuto in tempo. Riavviare l’esecuzione.</translation>
    </message>
    <message>
        <source>The control is running, but the stream makes no progress. Check feed override and feed hold at the control.</source>
        <translation>Il controllo è in marcia, ma la trasmissione non avanza. Controllare sul controllo l’override dell’avanzamento e l’arresto avanzamento.</translation>
    </message>
    <message>
        <source>The control did not confirm the stop in time. Check the machine.</source>
        <translation>Il controllo non ha confermato lo stop in tempo. Controllare la macchina.</translation>
    </message>
    <message>
        <source>The control ended the program with an alarm. Clear its cause at the control.</source>
        <translation>Il controllo ha terminato il programma con un allarme. Eliminarne la causa sul controllo.</translation>
    </message>
    <message>
        <source>The program on the control ended before all of it was executed.</source>
        <translation>Il programma sul controllo è terminato prima di essere eseguito per intero.</translation>
    </message>
    <message>
        <source>Another client is using the program on the control. Rivulet writes nothing more: wait until the other client has finished, or reset the control.</source>
        <translation>Un altro client sta usando il programma sul controllo. Rivulet non scrive più nulla: attendere che l’altro client abbia finito o resettare il controllo.</translation>
    </message>
    <message>
        <source>The program on the control was restarted during the run. Reset the control, then resume.</source>
        <translation>Il programma sul controllo è stato riavviato durante l’esecuzione. Resettare il controllo, poi riprendere.</translation>
    </message>
    <message>
        <source>The control rejected a window that did not match its check number, and did not execute it. Something else writes these R-parameters, or a value was changed on its way: look for another client, or connect encrypted, then resume.</source>
        <translation>Il controllo ha rifiutato una finestra che non corrispondeva al suo numero di controllo e non l’ha eseguita. Qualcos’altro scrive questi parametri R, oppure un valore è stato alterato lungo il percorso: cercare un altro client o connettersi con cifratura, poi riprendere.</translation>
    </message>
    <message>
        <source>The control ended its program because it received nothing from Rivulet for too long. Check the network, then resume.</source>
        <translation>Il controllo ha terminato il suo programma perché per troppo tempo non ha ricevuto nulla da Rivulet. Controllare la rete, poi riprendere.</translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation>Il caricamento è stato annullato.</translation>
    </message>
    <message>
        <source>It is not known for certain where the run was left. Start from the beginning.</source>
        <translation>Non si sa con certezza dove l’esecuzione si è interrotta. Ripartire dall’inizio.</translation>
    </message>
    <message>
        <source>The control does not let Rivulet write and read part programs. Grant the OPC UA user these rights, or copy the template to the control by hand.</source>
        <translation>Il controllo non permette a Rivulet di scrivere e leggere programmi pezzo. Concedere questi diritti all’utente OPC UA, oppure copiare il modello sul controllo a mano.</translation>
    </message>
    <message>
        <source>Only method window streams rotary axes. Choose it.</source>
        <translation>Solo il metodo Finestra trasmette assi rotativi. Scegliere questo metodo.</translation>
    </message>
    <message>
        <source>Too many axes. Choose at most five.</source>
        <translation>Troppi assi. Sceglierne al massimo cinque.</translation>
    </message>
    <message>
        <source>These are not axes. Choose from X, Y, Z, A, B and C.</source>
        <translation>Questi non sono assi. Scegliere tra X, Y, Z, A, B e C.</translation>
    </message>
    <message>
        <source>This make of control cannot do that. Choose another method or setting.</source>
        <translation>Questo controllo non può farlo. Scegliere un altro metodo o un’altra impostazione.</translation>
    </message>
    <message>
        <source>The program needs an axis that is not streamed. Move it to the position in the program, or stream it too.</source>
        <translation>Il programma richiede un asse che non viene trasmesso. Portarlo nella posizione indicata dal programma, o trasmettere anche questo.</translation>
    </message>
    <message>
        <source>The control lacks an axis that the program moves. Use a program for the axes of this machine.</source>
        <translation>Al controllo manca un asse mosso dal programma. Usare un programma per gli assi di questa macchina.</translation>
    </message>
    <message>
        <source>No prediction is possible for this method.</source>
        <translation>Per questo metodo non è possibile alcuna previsione.</translation>
    </message>
    <message>
        <source>The test was aborted. Reset the control if its program is still running.</source>
        <translation>Il test è stato interrotto. Resettare il controllo se il suo programma è ancora in corso.</translation>
    </message>
    <message>
        <source>Method credit is experimental and starts only on a control that has passed its test. Pass it on the page Credit test, or choose method window.</source>
        <translation>Il metodo Credito è sperimentale e si avvia solo su un controllo che ne ha superato il test. Eseguire il test alla pagina Test credito, o scegliere il metodo Finestra.</translation>
    </message>
    <message>
        <source>Online correction is possible with method window, for X, Y and Z, up to 1 mm.</source>
        <translation>La correzione online è possibile con il metodo Finestra, per X, Y e Z, fino a 1 mm.</translation>
    </message>
    <message>
        <source>An overlay is already active on the axes. Remove it at the control: press reset, wait, and check that $AA_OFF is 0.</source>
        <translation>Sugli assi è già attiva una sovrapposizione. Rimuoverla sul controllo: premere Reset, attendere e verificare che $AA_OFF sia 0.</translation>
    </message>
    <message>
        <source>The control adds up overlaid values (MD36750 bit 0). Set the bit to 0, or do without online correction.</source>
        <translation>Il controllo somma i valori sovrapposti (MD36750 bit 0). Impostare il bit a 0, o rinunciare alla correzione online.</translation>
    </message>
    <message>
        <source>This is not a machine file of Rivulet. Move the file away.</source>
        <translation>Questo non è un file macchina di Rivulet. Spostarlo altrove.</translation>
    </message>
    <message>
        <source>This was written by another version of Rivulet. Measure again.</source>
        <translation>Il file è di un’altra versione di Rivulet. Ripetere la misura.</translation>
    </message>
    <message>
        <source>The calibration is damaged. Measure again.</source>
        <translation>La calibrazione è danneggiata. Ripetere la misura.</translation>
    </message>
    <message>
        <source>Another client has claimed the R-parameters of this run and is about to start. Nothing was changed. Wait until its run has ended.</source>
        <translation>Un altro client ha riservato i parametri R di questa esecuzione e sta per avviarsi. Non è stato modificato nulla. Attendere che la sua esecuzione sia terminata.</translation>
    </message>
    <message>
        <source>A block of the program moves at a feed that is not known: F is missing, G95 has no spindle speed, or G93 no length. Choose one feed for all moves.</source>
        <translation>Un blocco del programma si muove con un avanzamento non noto: manca F, per G95 manca il numero di giri, o per G93 la lunghezza. Scegliere un solo avanzamento per tutti i movimenti.</translation>
    </message>
    <message>
        <source>This method has one feed for all moves, as it was published.</source>
        <translation>Questo metodo ha un solo avanzamento per tutti i movimenti, come pubblicato.</translation>
    </message>
    <message>
        <source>The override is out of range: choose 1 to 200 %.</source>
        <translation>L’override è fuori campo: scegliere da 1 a 200&#xa0;%.</translation>
    </message>
    <message>
        <source>The formula is not understood from here on.</source>
        <translation>La formula non è comprensibile da qui in poi.</translation>
    </message>
    <message>
        <source>The formula is not complete.</source>
        <translation>La formula non è completa.</translation>
    </message>
    <message>
        <source>There is no such function. Press F1 for those there are.</source>
        <translation>Questa funzione non esiste. F1 mostra quelle disponibili.</translation>
    </message>
    <message>
        <source>The trace has no such signal. The tool tips of the signals have their names.</source>
        <translation>La traccia non ha questo segnale. I nomi sono nei suggerimenti dei segnali.</translation>
    </message>
    <message>
        <source>This is no trace that can be read: there are no rows of numbers in it.</source>
        <translation>Non è una traccia leggibile: il file non contiene righe di numeri.</translation>
    </message>
    <message>
        <source>The table has no such column.</source>
        <translation>La tabella non ha questa colonna.</translation>
    </message>
    <message>
        <source>The trace has no positions: compare it by time.</source>
        <translation>La traccia non ha posizioni: confrontarla nel tempo.</translation>
    </message>
    <message>
        <source>To compare by points, open the NC program that the traces show.</source>
        <translation>Per confrontare per punti, aprire il programma NC mostrato dalle tracce.</translation>
    </message>
    <message>
        <source>The runs are of different programs: compare them by time or path.</source>
        <translation>Le esecuzioni sono di programmi diversi: confrontarle per tempo o per percorso.</translation>
    </message>
    <message>
        <source>A spectrum needs 16 samples or more between the cursors.</source>
        <translation>Uno spettro richiede almeno 16 campioni tra i cursori.</translation>
    </message>
    <message>
        <source>The server does not offer the encryption that is required. Set it up on the control, or allow this machine to be reached without it.</source>
        <translation>Il server non offre la crittografia richiesta. Configurarla sul controllo, oppure consentire per questa macchina una connessione non cifrata.</translation>
    </message>
    <message>
        <source>The server&apos;s certificate is not known yet. Compare its fingerprint with the one at the control, then accept it.</source>
        <translation>Il certificato del server non è ancora noto. Confrontare la sua impronta con quella sul controllo, poi accettarlo.</translation>
    </message>
    <message>
        <source>The server shows another certificate than the one that was accepted. Find out why before you accept it.</source>
        <translation>Il server presenta un certificato diverso da quello accettato. Chiarire il motivo prima di accettarlo.</translation>
    </message>
    <message>
        <source>A certificate cannot be used: it is damaged or has ended. Create a new one.</source>
        <translation>Un certificato non è utilizzabile: è danneggiato o scaduto. Crearne uno nuovo.</translation>
    </message>
    <message>
        <source>The server does not trust the certificate of this computer. Accept it at the control, then connect again.</source>
        <translation>Il server non considera attendibile il certificato di questo computer. Accettarlo sul controllo, poi collegarsi di nuovo.</translation>
    </message>
    <message>
        <source>The server refuses user name or password. Check both.</source>
        <translation>Il server rifiuta il nome utente o la password. Controllare entrambi.</translation>
    </message>
    <message>
        <source>The line is neither a point nor end, hold or comment.</source>
        <translation>La riga non è né un punto né end, hold o comment.</translation>
    </message>
    <message>
        <source>A word of the line has no number.</source>
        <translation>Una parola della riga non ha un numero.</translation>
    </message>
    <message>
        <source>The line is too long.</source>
        <translation>La riga è troppo lunga.</translation>
    </message>
    <message>
        <source>The source was closed in the middle of the line.</source>
        <translation>La sorgente è stata chiusa a metà della riga.</translation>
    </message>
    <message>
        <source>The point is outside the agreed box.</source>
        <translation>Il punto è fuori dal volume concordato.</translation>
    </message>
    <message>
        <source>The step to the point is longer than agreed.</source>
        <translation>Il passo verso il punto è più lungo di quanto concordato.</translation>
    </message>
    <message>
        <source>A rotary axis would turn farther in one step than agreed.</source>
        <translation>Un asse rotativo girerebbe in un passo più di quanto concordato.</translation>
    </message>
    <message>
        <source>F is larger than agreed, or not above 0.</source>
        <translation>F è maggiore di quanto concordato, o non è sopra 0.</translation>
    </message>
    <message>
        <source>The first point is farther from the tool than agreed. Move the tool there, or begin where it is.</source>
        <translation>Il primo punto è più lontano dall’utensile di quanto concordato. Portarvi l’utensile, o iniziare da dove si trova.</translation>
    </message>
    <message>
        <source>The point names an axis that is not one of this run.</source>
        <translation>Il punto nomina un asse che non fa parte di questa esecuzione.</translation>
    </message>
    <message>
        <source>A point is missing or came twice: the numbers are not in order.</source>
        <translation>Un punto manca o è arrivato due volte: i numeri non sono in ordine.</translation>
    </message>
    <message>
        <source>The source was closed without end.</source>
        <translation>La sorgente è stata chiusa senza end.</translation>
    </message>
    <message>
        <source>The source was silent for longer than agreed.</source>
        <translation>La sorgente è rimasta muta più a lungo di quanto concordato.</translation>
    </message>
    <message>
        <source>The source was faster than the machine and cannot wait. Send fewer points, or use TCP.</source>
        <translation>La sorgente era più veloce della macchina e non può attendere. Inviare meno punti, o usare TCP.</translation>
    </message>
    <message>
        <source>The source ended before its first point. Nothing has moved.</source>
        <translation>La sorgente è finita prima del suo primo punto. Non si è mosso nulla.</translation>
    </message>
    <message>
        <source>The source cannot be opened. Choose another port or path.</source>
        <translation>La sorgente non può essere aperta. Scegliere un’altra porta o un altro percorso.</translation>
    </message>
    <message>
        <source>These values cannot be kept together. Check box, step and times.</source>
        <translation>Questi valori non sono compatibili. Controllare volume, passo e tempi.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, riga %2</translation>
    </message>
    <message>
        <source>This source can lose points, so it has to number them: N1 X0.5, then N2.</source>
        <translation>Questa sorgente può perdere punti, quindi deve numerarli: N1 X0.5, poi N2.</translation>
    </message>
    <message>
        <source>The file of the source is not as the manual shows it (Live points).</source>
        <translation>Il file della sorgente non è come lo mostra il manuale (punti in diretta).</translation>
    </message>
    <message>
        <source>This Rivulet was built without HDF5. Use CSV, or build it with libhdf5-dev.</source>
        <translation>Questo Rivulet è stato compilato senza HDF5. Usare CSV o compilarlo con libhdf5-dev.</translation>
    </message>
    <message>
        <source>Times and positions do not fit together. Record the run again.</source>
        <translation>Tempi e posizioni non concordano. Registrare di nuovo l’esecuzione.</translation>
    </message>
    <message>
        <source>A value is not a number. Leave its row out of the file.</source>
        <translation>Un valore non è un numero. Togliere la sua riga dal file.</translation>
    </message>
    <message>
        <source>An axis does not move in these recordings. Add one that moves it.</source>
        <translation>Un asse non si muove in queste registrazioni. Aggiungerne una che lo muova.</translation>
    </message>
    <message>
        <source>There are too few samples to learn from. Record a longer program, with set points and actual positions.</source>
        <translation>I campioni sono troppo pochi per apprendere. Registrare un programma più lungo, con posizioni nominali e reali.</translation>
    </message>
    <message>
        <source>Set points and actual positions differ by a factor. Check their units.</source>
        <translation>Posizioni nominali e reali differiscono di un fattore. Controllarne le unità.</translation>
    </message>
    <message>
        <source>Recording and program do not fit together. Check the program, and that the preset has the machine&apos;s limits.</source>
        <translation>Registrazione e programma non concordano. Controllare il programma e che il preset abbia i limiti della macchina.</translation>
    </message>
    <message>
        <source>No model follows this recording. Check that set points and positions belong together.</source>
        <translation>Nessun modello segue questa registrazione. Controllare che valori nominali e posizioni vadano insieme.</translation>
    </message>
    <message>
        <source>Learning was cancelled. What was learned before stays.</source>
        <translation>L’apprendimento è stato annullato. Resta ciò che è stato appreso prima.</translation>
    </message>
    <message>
        <source>The file is not an emulator, or one of a later version.</source>
        <translation>Il file non è un emulatore, o è di una versione successiva.</translation>
    </message>
    <message>
        <source>Rivulet was built without Qt OPC UA. Connect with open62541.</source>
        <translation>Rivulet è stato compilato senza Qt OPC UA. Collegarsi con open62541.</translation>
    </message>
    <message>
        <source>Qt OPC UA cannot encrypt, log in or use a map here. Connect with open62541.</source>
        <translation>Qui Qt OPC UA non può criptare, accedere con un utente o usare una mappa. Collegarsi con open62541.</translation>
    </message>
    <message>
        <source>The map cannot be used. Correct the file at the place that is named.</source>
        <translation>La mappa non è utilizzabile. Correggere il file nel punto indicato.</translation>
    </message>
    <message>
        <source>The map names a node that the server does not have, or one of another type. Correct the map.</source>
        <translation>La mappa nomina un nodo che il server non ha, o di un altro tipo. Correggere la mappa.</translation>
    </message>
    <message>
        <source>No computer of this name is known on the network. Check the name, or give the IP address of the control.</source>
        <translation>In rete non è noto nessun computer con questo nome. Controllare il nome oppure indicare l&apos;indirizzo IP del controllo.</translation>
    </message>
    <message>
        <source>Too many files and connections are open on this computer. Close other programs, then try again.</source>
        <translation>Su questo computer sono aperti troppi file e connessioni. Chiudere altri programmi, poi riprovare.</translation>
    </message>
    <message>
        <source>The text leaves open what it means. Choose the dialect, the unit or the reading of numbers without a decimal point.</source>
        <translation>Il testo lascia aperto il suo significato. Scegliere il dialetto, l’unità o la lettura dei numeri senza punto decimale.</translation>
    </message>
    <message>
        <source>The straight way to the first point passes within what the program cuts. Raise the tool first.</source>
        <translation>La via diretta al primo punto passa nella zona che il programma lavora. Sollevare prima l&apos;utensile.</translation>
    </message>
    <message>
        <source>This would take more memory than a file may. Choose a smaller one.</source>
        <translation>Richiederebbe più memoria di quanta ne può occupare un file. Sceglierne uno più piccolo.</translation>
    </message>
    <message>
        <source>A factor of the feed would wait here behind points that are not read yet. Send factors over a source of their own.</source>
        <translation>Un fattore dell’avanzamento aspetterebbe qui dietro punti non ancora letti. Inviare i fattori da una sorgente propria.</translation>
    </message>
    <message>
        <source>A factor of the override is possible with methods window and credit, from 0.01 to 2, with 1 between its bounds.</source>
        <translation>Un fattore dell’override è possibile con i metodi Finestra e Credito, da 0,01 a 2, con 1 tra i suoi limiti.</translation>
    </message>
    <message>
        <source>The move of the test takes 2 to 30 s at its feed, so that it can be held on its way. Choose another length or feed.</source>
        <translation>Il movimento della prova dura da 2 a 30 s al suo avanzamento, per poter essere fermato lungo il percorso. Scegliere un&apos;altra lunghezza o un altro avanzamento.</translation>
    </message>
    <message>
        <source>This is no trace, but the refusal of an MTConnect agent. Ask it for /sample.</source>
        <translation>Questa non è una traccia, ma il rifiuto di un agente MTConnect. Chiedergli /sample.</translation>
    </message>
    <message>
        <source>The server keeps no history of this node. Have it recorded at the server.</source>
        <translation>Il server non conserva lo storico di questo nodo. Farlo registrare sul server.</translation>
    </message>
    <message>
        <source>The R-parameters of method window are out of range. Check base, stride and number of windows.</source>
        <translation>I parametri R del metodo Finestra sono fuori campo. Controllare base, passo e numero di finestre.</translation>
    </message>
    <message>
        <source>These R-parameters cannot be used. Choose some that exist (MD28050).</source>
        <translation>Questi parametri R non si possono usare. Sceglierne di esistenti (MD28050).</translation>
    </message>
    <message>
        <source>A program is running on the control: the measurement has ended. The R-parameters have their old values.</source>
        <translation>Sul controllo è in corso un programma: la misura è terminata. I parametri R hanno i valori di prima.</translation>
    </message>
    <message>
        <source>The calibration was cancelled. The R-parameters have their old values.</source>
        <translation>La calibrazione è stata annullata. I parametri R hanno i valori di prima.</translation>
    </message>
    <message>
        <source>The R-parameters could not be restored and may hold test values. Set them at the control.</source>
        <translation>I parametri R non sono stati ripristinati e possono contenere valori di prova. Impostarli sul controllo.</translation>
    </message>
    <message>
        <source>The control does not obey the override: pause, stop and override would not act. Nothing was moved. Check that a SINUMERIK has synchronized actions, or a LinuxCNC the components of docs/linuxcnc.md.</source>
        <translation>Il controllo non obbedisce all’override: pausa, stop e override non agirebbero. Nulla è stato mosso. Verificare che una SINUMERIK abbia le azioni sincrone, o un LinuxCNC i componenti di docs/linuxcnc.md.</translation>
    </message>
    <message>
        <source>The path cannot be kept within this tolerance. Allow more of it, or none; packed points are moved by up to 0.001 mm.</source>
        <translation>Il percorso non si può mantenere entro questa tolleranza. Consentire di più, o nessuna; i punti compattati si spostano fino a 0,001 mm.</translation>
    </message>
    <message>
        <source>This block cannot be tried: the control of a job would not execute it itself, or it ends the program. Name blocks as a program has them, as in &quot;S500 M3&quot;.</source>
        <translation>Questo blocco non può essere provato: in un lavoro il controllo non lo eseguirebbe da sé, oppure termina il programma. Inserire i blocchi come in un programma, per esempio «S500 M3».</translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message>
        <source>the character &quot;%1&quot; has no meaning here</source>
        <translation>il carattere «%1» qui non ha significato</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>«%1» non è un numero</translation>
    </message>
    <message>
        <source>a comment is not closed</source>
        <translation>un commento non è chiuso</translation>
    </message>
    <message>
        <source>%1 is not known to this machine</source>
        <translation>%1 non è noto a questa macchina</translation>
    </message>
    <message>
        <source>the word %1 is not understood here</source>
        <translation>la parola %1 qui non è compresa</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not understood</source>
        <translation>«%1» non è compreso</translation>
    </message>
    <message>
        <source>two functions of one group are in the block: %1</source>
        <translation>due funzioni di uno stesso gruppo sono nel blocco: %1</translation>
    </message>
    <message>
        <source>the address %1 is programmed more than once in the block</source>
        <translation>l’indirizzo %1 è programmato più volte nel blocco</translation>
    </message>
    <message>
        <source>circle end-point error: there is no circle through these points</source>
        <translation>errore sul punto finale del cerchio: nessun cerchio passa per questi punti</translation>
    </message>
    <message>
        <source>circle end-point error: the radii at start and end differ by %1 mm</source>
        <translation>errore sul punto finale del cerchio: i raggi all’inizio e alla fine differiscono di %1 mm</translation>
    </message>
    <message>
        <source>circle end-point error: the radius is too small (%1)</source>
        <translation>errore sul punto finale del cerchio: il raggio è troppo piccolo (%1)</translation>
    </message>
    <message>
        <source>the arc starts at an unknown position: %1</source>
        <translation>l’arco inizia da una posizione ignota: %1</translation>
    </message>
    <message>
        <source>the increment of %1 starts at an unknown position</source>
        <translation>la quota incrementale di %1 parte da una posizione ignota</translation>
    </message>
    <message>
        <source>no feed is programmed</source>
        <translation>nessun avanzamento è programmato</translation>
    </message>
    <message>
        <source>the programmed path speed %1 is not positive</source>
        <translation>la velocità programmata %1 sul percorso non è positiva</translation>
    </message>
    <message>
        <source>the value of %1 is out of range</source>
        <translation>il valore di %1 è fuori campo</translation>
    </message>
    <message>
        <source>circle end-point error: %1 is not in the plane of the arc</source>
        <translation>errore sul punto finale del cerchio: %1 non è nel piano dell’arco</translation>
    </message>
    <message>
        <source>%1 is not a cycle of this machine</source>
        <translation>%1 non è un ciclo di questa macchina</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>manca un valore</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a value</source>
        <translation>«%1» non è un valore</translation>
    </message>
    <message>
        <source>a constant in quotes is written &apos;H1F&apos; or &apos;B101&apos;</source>
        <translation>una costante tra apici si scrive &apos;H1F&apos; o &apos;B101&apos;</translation>
    </message>
    <message>
        <source>a text in quotes is expected</source>
        <translation>si attende un testo tra virgolette</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>una parentesi non è chiusa</translation>
    </message>
    <message>
        <source>an operand is missing</source>
        <translation>manca un operando</translation>
    </message>
    <message>
        <source>the calculation is nested too deeply</source>
        <translation>il calcolo ha troppi livelli di annidamento</translation>
    </message>
    <message>
        <source>%1 is neither a variable nor a function</source>
        <translation>%1 non è né una variabile né una funzione</translation>
    </message>
    <message>
        <source>%1 needs its argument in brackets</source>
        <translation>%1 richiede il suo argomento tra parentesi</translation>
    </message>
    <message>
        <source>%1 needs more arguments</source>
        <translation>%1 richiede più argomenti</translation>
    </message>
    <message>
        <source>ATAN is written ATAN[y]/[x]</source>
        <translation>ATAN si scrive ATAN[y]/[x]</translation>
    </message>
    <message>
        <source>EXISTS is written EXISTS[#&lt;name&gt;]</source>
        <translation>EXISTS si scrive EXISTS[#&lt;name&gt;]</translation>
    </message>
    <message>
        <source>R needs a number or an index in brackets</source>
        <translation>R richiede un numero o un indice tra parentesi</translation>
    </message>
    <message>
        <source>the number of a variable is missing or too large</source>
        <translation>il numero di una variabile manca o è troppo grande</translation>
    </message>
    <message>
        <source>the name of a variable is not closed with &gt;</source>
        <translation>il nome di una variabile non è chiuso con &gt;</translation>
    </message>
    <message>
        <source>%1 is not a variable</source>
        <translation>%1 non è una variabile</translation>
    </message>
    <message>
        <source>%1 needs an axis or an index in brackets</source>
        <translation>%1 richiede un asse o un indice tra parentesi</translation>
    </message>
    <message>
        <source>an equals sign is missing</source>
        <translation>manca un segno di uguale</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be assigned to</source>
        <translation>a «%1» non si può assegnare un valore</translation>
    </message>
    <message>
        <source>SET and REP need a list in brackets, with commas between its values</source>
        <translation>SET e REP richiedono una lista tra parentesi, con virgole tra i valori</translation>
    </message>
    <message>
        <source>the name of a variable is missing</source>
        <translation>manca il nome di una variabile</translation>
    </message>
    <message>
        <source>%1 is not a type for DEF</source>
        <translation>%1 non è un tipo per DEF</translation>
    </message>
    <message>
        <source>the size of an array is missing or too large</source>
        <translation>la dimensione di un array manca o è troppo grande</translation>
    </message>
    <message>
        <source>the parameters of PROC are written PROC name(type name, ...)</source>
        <translation>i parametri di PROC si scrivono PROC nome(tipo nome, ...)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing, or has no meaning here</source>
        <translation>«%1» manca, o qui non ha significato</translation>
    </message>
    <message>
        <source>an address needs a number or &quot;=&quot;</source>
        <translation>un indirizzo richiede un numero o «=»</translation>
    </message>
    <message>
        <source>the jump has no target</source>
        <translation>il salto non ha destinazione</translation>
    </message>
    <message>
        <source>only GOTO may follow a condition</source>
        <translation>dopo una condizione può seguire solo GOTO</translation>
    </message>
    <message>
        <source>FOR is written FOR i = a TO b</source>
        <translation>FOR si scrive FOR i = a TO b</translation>
    </message>
    <message>
        <source>CASE is written CASE(value) OF constant GOTOF target</source>
        <translation>CASE si scrive CASE(valore) OF costante GOTOF destinazione</translation>
    </message>
    <message>
        <source>the %1 that begins here is not closed</source>
        <translation>il %1 che inizia qui non è chiuso</translation>
    </message>
    <message>
        <source>%1 has no beginning</source>
        <translation>%1 non ha inizio</translation>
    </message>
    <message>
        <source>control structures are nested more than 16 deep</source>
        <translation>le strutture di controllo sono annidate per più di 16 livelli</translation>
    </message>
    <message>
        <source>a synchronized action needs a number from 1 to 255</source>
        <translation>un’azione sincrona richiede un numero da 1 a 255</translation>
    </message>
    <message>
        <source>a synchronized action is written ID=1 WHEN condition DO assignment</source>
        <translation>un’azione sincrona si scrive ID=1 WHEN condizione DO assegnazione</translation>
    </message>
    <message>
        <source>a synchronized action can only assign to $R and variables of the main run</source>
        <translation>un’azione sincrona può assegnare valori solo a $R e a variabili dell’elaborazione principale</translation>
    </message>
    <message>
        <source>the target %1 is missing</source>
        <translation>manca la destinazione %1</translation>
    </message>
    <message>
        <source>the program %1 does not exist</source>
        <translation>il programma %1 non esiste</translation>
    </message>
    <message>
        <source>%1 is not defined, and there is no program of this name</source>
        <translation>%1 non è definito e non c’è alcun programma con questo nome</translation>
    </message>
    <message>
        <source>subprograms call each other too deeply</source>
        <translation>i sottoprogrammi si richiamano per troppi livelli</translation>
    </message>
    <message>
        <source>a division by zero</source>
        <translation>divisione per zero</translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation>%1 non ha valore</translation>
    </message>
    <message>
        <source>the result is too large</source>
        <translation>il risultato è troppo grande</translation>
    </message>
    <message>
        <source>it needs a value that is not known</source>
        <translation>serve un valore che non è noto</translation>
    </message>
    <message>
        <source>R%1 is read before the program sets it: only the control knows it</source>
        <translation>R%1 viene letto prima che il programma lo imposti: solo il controllo lo conosce</translation>
    </message>
    <message>
        <source>R[%1] does not exist</source>
        <translation>R[%1] non esiste</translation>
    </message>
    <message>
        <source>%1 is not defined</source>
        <translation>%1 non è definito</translation>
    </message>
    <message>
        <source>an array needs its index in brackets</source>
        <translation>un array richiede il suo indice tra parentesi</translation>
    </message>
    <message>
        <source>the array has fewer dimensions</source>
        <translation>l’array ha meno dimensioni</translation>
    </message>
    <message>
        <source>the array has more dimensions</source>
        <translation>l’array ha più dimensioni</translation>
    </message>
    <message>
        <source>the index is outside the array</source>
        <translation>l’indice è fuori dall’array</translation>
    </message>
    <message>
        <source>a calculation uses a text</source>
        <translation>un calcolo usa un testo</translation>
    </message>
    <message>
        <source>the value is not of type %1</source>
        <translation>il valore non è del tipo %1</translation>
    </message>
    <message>
        <source>the value is outside the range of type %1</source>
        <translation>il valore è fuori dal campo del tipo %1</translation>
    </message>
    <message>
        <source>the list has more values than the array has elements</source>
        <translation>la lista ha più valori degli elementi dell’array</translation>
    </message>
    <message>
        <source>only the control knows the value of %1</source>
        <translation>solo il controllo conosce il valore di %1</translation>
    </message>
    <message>
        <source>a variable of the control would be written</source>
        <translation>verrebbe scritta una variabile del controllo</translation>
    </message>
    <message>
        <source>the subprogram takes %1 values</source>
        <translation>il sottoprogramma richiede %1 valori</translation>
    </message>
    <message>
        <source>the parameter %1 is given by reference and needs a variable</source>
        <translation>il parametro %1 è passato per riferimento e richiede una variabile</translation>
    </message>
    <message>
        <source>the parameter %1 is given by reference and needs a variable of its own type</source>
        <translation>il parametro %1 è passato per riferimento e richiede una variabile dello stesso tipo</translation>
    </message>
    <message>
        <source>a synchronized action reads R or an array by an index of the main run: use $R</source>
        <translation>un’azione sincrona legge R o un array con un indice dell’elaborazione principale: usare $R</translation>
    </message>
    <message>
        <source>GOTO or THEN must follow a condition</source>
        <translation>dopo una condizione deve seguire GOTO o THEN</translation>
    </message>
    <message>
        <source>WHILE is written WHILE [condition] DO1</source>
        <translation>WHILE si scrive WHILE [condizione] DO1</translation>
    </message>
    <message>
        <source>an O word needs a number or &lt;name&gt;</source>
        <translation>una parola O richiede un numero o &lt;name&gt;</translation>
    </message>
    <message>
        <source>%1 is not known</source>
        <translation>%1 non è noto</translation>
    </message>
    <message>
        <source>%1 is not in a loop</source>
        <translation>%1 non è in un loop</translation>
    </message>
    <message>
        <source>%1 has no call</source>
        <translation>%1 non ha una chiamata</translation>
    </message>
    <message>
        <source>a subprogram is defined inside %1</source>
        <translation>un sottoprogramma è definito dentro %1</translation>
    </message>
    <message>
        <source>a blank is inside the number &quot;%1&quot;</source>
        <translation>nel numero «%1» c’è uno spazio</translation>
    </message>
    <message>
        <source>the invisible character %1 has no meaning here</source>
        <translation>il carattere invisibile %1 qui non ha significato</translation>
    </message>
    <message>
        <source>a bracket is opened within the comment %1</source>
        <translation>nel commento %1 si apre una parentesi</translation>
    </message>
    <message>
        <source>the program has more than %1 variables</source>
        <translation>il programma ha più di %1 variabili</translation>
    </message>
    <message>
        <source>%1 cannot be written by a program here</source>
        <translation>%1 non può essere scritto qui da un programma</translation>
    </message>
    <message>
        <source>the program stops here with its alarm %1</source>
        <translation>il programma si ferma qui con il suo allarme %1</translation>
    </message>
    <message>
        <source>the file holds two programs of the name %1: rename or remove one of them</source>
        <translation>il file contiene due programmi di nome %1: rinominarne o eliminarne uno</translation>
    </message>
    <message>
        <source>the unit of the feed was chosen behind the last F</source>
        <translation>l&apos;unità dell&apos;avanzamento è stata scelta dopo l&apos;ultimo F</translation>
    </message>
    <message>
        <source>the program takes more memory than is allowed: split it</source>
        <translation>il programma richiede più memoria di quanta ne è consentita: dividerlo</translation>
    </message>
    <message>
        <source>the block lacks a word that the control needs (%1)</source>
        <translation>al blocco manca una parola che serve al controllo (%1)</translation>
    </message>
    <message>
        <source>the block cannot be executed here (%1)</source>
        <translation>il blocco non può essere eseguito qui (%1)</translation>
    </message>
</context>
<context>
    <name>FeedTestTexts</name>
    <message>
        <source>no axis was moved</source>
        <translation>nessun asse è stato mosso</translation>
    </message>
    <message>
        <source>4. The override is changed while the axis moves. Then press cycle start once more: the next program must move at its own feed, and only the control can stop it.</source>
        <translation>4. L&apos;override viene cambiato mentre l&apos;asse si muove. Poi premere ancora una volta Start NC: il programma successivo deve muoversi con il proprio avanzamento, e solo il controllo può fermarlo.</translation>
    </message>
    <message>
        <source>4. The override is changed; no axis moves.</source>
        <translation>4. L&apos;override viene cambiato; nessun asse si muove.</translation>
    </message>
    <message>
        <source>Not tested: on this control a stop is sure to act only before the next window</source>
        <translation>Non provato: su questo controllo uno stop agisce con certezza solo prima della finestra successiva</translation>
    </message>
    <message>
        <source>Passed: stop, pause and override act at once on this control</source>
        <translation>Superata: stop, pausa e override agiscono subito su questo controllo</translation>
    </message>
    <message>
        <source>Passed without motion. Whether the axes obey shows only when one moves.</source>
        <translation>Superata senza movimento. Se gli assi obbediscono si vede solo quando uno si muove.</translation>
    </message>
    <message>
        <source>Not passed: on this control a stop is sure to act only before the next window</source>
        <translation>Non superata: su questo controllo uno stop agisce con certezza solo prima della finestra successiva</translation>
    </message>
    <message>
        <source>Synchronized actions make the override that is wanted, and keep it.</source>
        <translation>Le azioni sincrone formano l&apos;override voluto e lo mantengono.</translation>
    </message>
    <message>
        <source>Without a sign of the client the override is 0.</source>
        <translation>Senza segni di vita del client l&apos;override è 0.</translation>
    </message>
    <message>
        <source>At 50 % the axis takes twice as long.</source>
        <translation>Al 50 % l&apos;asse impiega il doppio del tempo.</translation>
    </message>
    <message>
        <source>At 0 % the axis stands on its way.</source>
        <translation>Allo 0 % l&apos;asse si ferma lungo il percorso.</translation>
    </message>
    <message>
        <source>It brakes at once when 0 % is wanted.</source>
        <translation>Frena subito quando si chiede lo 0 %.</translation>
    </message>
    <message>
        <source>It moves in no interpolation cycle while it is held.</source>
        <translation>Fermato, non si muove in nessun ciclo di interpolazione.</translation>
    </message>
    <message>
        <source>The synchronized actions end with their program.</source>
        <translation>Le azioni sincrone terminano con il loro programma.</translation>
    </message>
    <message>
        <source>The next program moves at its own feed.</source>
        <translation>Il programma successivo si muove con il proprio avanzamento.</translation>
    </message>
    <message>
        <source>; the tool may be lifted by %1</source>
        <translation>; l’utensile può essere sollevato di %1</translation>
    </message>
    <message>
        <source>4. The override is changed while the axis moves; held, the tool goes up and comes back, twice. Then press cycle start once more: the next program must move at its own feed, and only the control can stop it.</source>
        <translation>4. L’override viene cambiato mentre l’asse si muove; fermato, l’utensile sale e torna, due volte. Poi premere ancora una volta Start NC: il programma successivo deve muoversi con il proprio avanzamento, e solo il controllo può fermarlo.</translation>
    </message>
    <message>
        <source>The control allows the overlay of Z that the lift needs.</source>
        <translation>Il controllo permette la sovrapposizione di Z che serve al sollevamento.</translation>
    </message>
    <message>
        <source>Nothing but 0 to the lift moves the tool.</source>
        <translation>Solo i valori da 0 al sollevamento muovono l’utensile.</translation>
    </message>
    <message>
        <source>The tool is lifted while the axis is held.</source>
        <translation>L’utensile viene sollevato mentre l’asse è fermato.</translation>
    </message>
    <message>
        <source>The axis stands while the tool is lifted.</source>
        <translation>L’asse sta fermo finché l’utensile è sollevato.</translation>
    </message>
    <message>
        <source>The tool comes back to its path.</source>
        <translation>L’utensile torna sul suo percorso.</translation>
    </message>
    <message>
        <source>Let go, the axis moves only when the tool is back.</source>
        <translation>Rilasciato, l’asse si muove solo quando l’utensile è tornato.</translation>
    </message>
    <message>
        <source>Stop, pause and override act at once because the control obeys an R-parameter in every interpolation cycle. This test finds out whether it does: first without motion, then, if you agree, with one axis that moves back and forth in the air and is held on its way. The channel must be in reset.</source>
        <translation>Stop, pausa e override agiscono subito perché il controllo obbedisce a un parametro R in ogni ciclo di interpolazione. Questa prova accerta se lo fa: prima senza movimento, poi, se si è d&apos;accordo, con un asse che va e torna in aria e viene fermato lungo il percorso. Il canale deve essere in reset.</translation>
    </message>
    <message>
        <source>No other client writes the override of this test.</source>
        <translation>Nessun altro client scrive l’override di questa prova.</translation>
    </message>
    <message>
        <source>; held, it was seen to stand after %1</source>
        <translation>; trattenuto, era fermo dopo %1</translation>
    </message>
</context>
<context>
    <name>FileSheetTexts</name>
    <message>
        <source>%1 is already there. Replace it?</source>
        <translation>%1 esiste già. Sostituirlo?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Sostituisci</translation>
    </message>
</context>
<context>
    <name>FoundRunTexts</name>
    <message>
        <source>A program of Rivulet without a run</source>
        <translation>Un programma di Rivulet senza esecuzione</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Esecuzione %1</translation>
    </message>
    <message>
        <source>Run %1 of %2</source>
        <translation>Esecuzione %1 di %2</translation>
    </message>
    <message>
        <source>It is not known who started it.</source>
        <translation>Non si sa chi l’ha avviata.</translation>
    </message>
    <message>
        <source>Started by %1 on %2 at %3.</source>
        <translation>Avviata da %1 su %2 il %3.</translation>
    </message>
    <message>
        <source>%1 of %2 points executed</source>
        <translation>eseguiti %1 punti su %2</translation>
    </message>
    <message>
        <source>%1. Looking for its client …</source>
        <translation>%1. Ricerca del suo client…</translation>
    </message>
    <message>
        <source>It waits for its first client.</source>
        <translation>Attende il suo primo client.</translation>
    </message>
    <message>
        <source>%1. Its client is gone: the program waits.</source>
        <translation>%1. Il suo client non c’è più: il programma attende.</translation>
    </message>
    <message>
        <source>%1. Its client is at work.</source>
        <translation>%1. Il suo client è al lavoro.</translation>
    </message>
    <message>
        <source>It was not completed, and its program is no longer active on the control.</source>
        <translation>Non è completata e il suo programma non è più attivo sul controllo.</translation>
    </message>
    <message>
        <source>Stop confirmed after %1.</source>
        <translation>Stop confermato dopo %1.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows executed</source>
        <translation>
            <numerusform>eseguita %Ln finestra</numerusform>
            <numerusform>eseguite %Ln finestre</numerusform>
        </translation>
    </message>
    <message>
        <source>The axes stand (%1 after the order), and stay where they are until the run is ended or resumed.</source>
        <translation>Gli assi sono fermi (%1 dopo il comando) e lo restano finché l’esecuzione non viene terminata o ripresa.</translation>
    </message>
</context>
<context>
    <name>GroupingTexts</name>
    <message>
        <source>Lists</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>One by one</source>
        <translation>Singolarmente</translation>
    </message>
    <message>
        <source>Arrays by count</source>
        <translation>Array per numero</translation>
    </message>
    <message>
        <source>Arrays by range</source>
        <translation>Array per intervallo</translation>
    </message>
</context>
<context>
    <name>HazardTexts</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, riga %2</translation>
    </message>
    <message>
        <source>Line %1 (part %2)</source>
        <translation>Riga %1 (tratto %2)</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Riga %1</translation>
    </message>
    <message>
        <source>S%1 is %2 1/min more than the spindle can turn; the control reduces it to %3 1/min.</source>
        <translation>S%1 supera di %2 1/min la velocità massima del mandrino; il controllo la riduce a %3 1/min.</translation>
    </message>
    <message>
        <source>Tool %1 is not in the tool table of the machine. Enter it there, or choose another tool.</source>
        <translation>L’utensile %1 non è nella tabella utensili della macchina. Inserirlo lì o scegliere un altro utensile.</translation>
    </message>
    <message>
        <source>The machine would stop with alarm %1: %2</source>
        <translation>La macchina si fermerebbe con l’allarme %1: %2</translation>
    </message>
    <message>
        <source>From here on the job cannot be checked, because only the control knows what this block does: %1</source>
        <translation>Da qui in poi il lavoro non può essere controllato, perché solo il controllo sa cosa fa questo blocco: %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>e altri %1</translation>
    </message>
    <message>
        <source>%1 would go to %2 in machine coordinates, %3 beyond its limit of %4. Move the workpiece or change the work offset.</source>
        <translation>%1 andrebbe a %2 in coordinate macchina, %3 oltre il limite di %4. Spostare il pezzo o cambiare lo spostamento origine.</translation>
    </message>
    <message>
        <source>Tool %1 is not in the tool table of the machine, but %2 is. Enter %1 there, or write %2 into the program.</source>
        <translation>L’utensile %1 non è nella tabella utensili della macchina, ma %2 sì. Inserirvi %1 oppure scrivere %2 nel programma.</translation>
    </message>
</context>
<context>
    <name>JobTestTexts</name>
    <message>
        <source>In a whole job the control executes blocks of its own between stretches that Rivulet streams. This test finds out whether it does that once, in order and only when it may, and whether stop, pause and a lost connection act in both: one axis moves back and forth in the air. Enter the blocks that your jobs have, one a line, each so that nothing is in its way; other kinds are not released. The channel must be in reset.</source>
        <translation>In un lavoro completo il controllo esegue blocchi propri fra i tratti che Rivulet trasmette. Questo test verifica che lo faccia una volta, nell’ordine e solo con il permesso, e che arresto, pausa e connessione persa agiscano in entrambi: un asse si muove avanti e indietro in aria. Inserire i blocchi dei propri lavori, uno per riga, ciascuno senza ostacoli; gli altri tipi non vengono abilitati. Il canale deve essere in reset.</translation>
    </message>
    <message>
        <source>4. The job is stopped and left alone, in a block and in a stretch, then it goes through: press cycle start each time, %1 times in all.</source>
        <translation>4. Il lavoro viene arrestato e lasciato solo, in un blocco e in un tratto, poi va fino in fondo: premere ogni volta Start NC, %1 volte in tutto.</translation>
    </message>
    <message>
        <source>Passed: whole jobs may run on this control, with the blocks that were tried</source>
        <translation>Superato: su questo controllo possono andare lavori completi, con i blocchi provati</translation>
    </message>
    <message>
        <source>No block is executed before Rivulet permits it.</source>
        <translation>Nessun blocco viene eseguito prima del permesso di Rivulet.</translation>
    </message>
    <message>
        <source>After a stretch no block is executed before Rivulet permits it.</source>
        <translation>Dopo un tratto nessun blocco viene eseguito prima del permesso di Rivulet.</translation>
    </message>
    <message>
        <source>A stop in a block ends the job after that block.</source>
        <translation>Un arresto in un blocco termina il lavoro dopo quel blocco.</translation>
    </message>
    <message>
        <source>A stop in a stretch ends the job there.</source>
        <translation>Un arresto in un tratto termina lì il lavoro.</translation>
    </message>
    <message>
        <source>In a block the axis stands when the connection is lost, and the job can be ended.</source>
        <translation>In un blocco l’asse si ferma quando la connessione è persa, e il lavoro può essere terminato.</translation>
    </message>
    <message>
        <source>In a stretch the axis stands when the connection is lost, and the job can be ended.</source>
        <translation>In un tratto l’asse si ferma quando la connessione è persa, e il lavoro può essere terminato.</translation>
    </message>
    <message>
        <source>In a block the axis stands while it is held.</source>
        <translation>In un blocco l’asse sta fermo finché è trattenuto.</translation>
    </message>
    <message>
        <source>In a stretch the axis stands while it is held.</source>
        <translation>In un tratto l’asse sta fermo finché è trattenuto.</translation>
    </message>
    <message>
        <source>Blocks and stretches are executed in turns, once each.</source>
        <translation>Blocchi e tratti vengono eseguiti a turno, una volta ciascuno.</translation>
    </message>
    <message>
        <source>No block is passed over.</source>
        <translation>Nessun blocco viene saltato.</translation>
    </message>
    <message>
        <source>The override of the job ends with it.</source>
        <translation>L’override del lavoro finisce con esso.</translation>
    </message>
    <message>
        <source>Not tested: on a real control only the motion of a program runs</source>
        <translation>Non provato: su un controllo reale va solo il movimento di un programma</translation>
    </message>
    <message>
        <source>Not passed: on a real control only the motion of a program runs</source>
        <translation>Non superato: su un controllo reale va solo il movimento di un programma</translation>
    </message>
</context>
<context>
    <name>JobTexts</name>
    <message>
        <source>swivels or transforms the coordinates</source>
        <translation>orienta o trasforma le coordinate</translation>
    </message>
    <message>
        <source>tool radius compensation</source>
        <translation>correzione del raggio utensile</translation>
    </message>
    <message>
        <source>cycle of the control</source>
        <translation>ciclo del controllo</translation>
    </message>
    <message>
        <source>subprogram that is not at hand</source>
        <translation>sottoprogramma non disponibile</translation>
    </message>
    <message>
        <source>measures, or reads the machine</source>
        <translation>misura, o legge la macchina</translation>
    </message>
    <message>
        <source>moves in machine coordinates</source>
        <translation>si muove in coordinate macchina</translation>
    </message>
    <message>
        <source>path made by the control</source>
        <translation>percorso creato dal controllo</translation>
    </message>
    <message>
        <source>rounded or chamfered corner</source>
        <translation>angolo raccordato o smussato</translation>
    </message>
    <message>
        <source>counts from a position that only the control knows</source>
        <translation>conta da una posizione che solo il controllo conosce</translation>
    </message>
    <message>
        <source>tool or tool length</source>
        <translation>utensile o lunghezza utensile</translation>
    </message>
    <message>
        <source>work offset</source>
        <translation>spostamento origine</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>mandrino</translation>
    </message>
    <message>
        <source>coolant</source>
        <translation>refrigerante</translation>
    </message>
    <message>
        <source>stops until cycle start</source>
        <translation>si ferma fino a Start NC</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>tempo di sosta</translation>
    </message>
    <message>
        <source>message at the control</source>
        <translation>messaggio sul controllo</translation>
    </message>
    <message>
        <source>how the control moves</source>
        <translation>come il controllo si muove</translation>
    </message>
    <message>
        <source>function of the machine</source>
        <translation>funzione della macchina</translation>
    </message>
    <message>
        <source>end of the program</source>
        <translation>fine del programma</translation>
    </message>
    <message>
        <source>The control executes this block: %1.</source>
        <translation>Questo blocco è eseguito dal controllo: %1.</translation>
    </message>
    <message>
        <source>Afterwards the position is read from the control.</source>
        <translation>Poi la posizione è letta dal controllo.</translation>
    </message>
    <message numerus="yes">
        <source>Part %1 of %2: lines %3 to %4 are streamed, %Ln points.</source>
        <translation>
            <numerusform>Tratto %1 di %2: le righe da %3 a %4 sono trasmesse in continuo, %Ln punto.</numerusform>
            <numerusform>Tratto %1 di %2: le righe da %3 a %4 sono trasmesse in continuo, %Ln punti.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LimitTexts</name>
    <message>
        <source>rapid</source>
        <translation>rapido</translation>
    </message>
    <message>
        <source>line %1: %2, %3</source>
        <translation>riga %1: %2, %3</translation>
    </message>
</context>
<context>
    <name>LiveTexts</name>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>hold after %1, end after %2</source>
        <translation>sospensione dopo %1, fine dopo %2</translation>
    </message>
    <message>
        <source>median %1, 99 % %2</source>
        <translation>mediana %1, 99&#xa0;% %2</translation>
    </message>
    <message>
        <source>in theory %1</source>
        <translation>in teoria %1</translation>
    </message>
    <message>
        <source>%1 from %2, executed to line %3</source>
        <translation>%1 da %2, eseguite fino alla riga %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln points merged</source>
        <translation>
            <numerusform>%Ln punto unito</numerusform>
            <numerusform>%Ln punti uniti</numerusform>
        </translation>
    </message>
    <message>
        <source>Adaptive feed: %1 % of your override, from %2</source>
        <translation>Avanzamento adattivo: %1&#xa0;% del vostro override, da %2</translation>
    </message>
    <message>
        <source>Adaptive feed: without %1, until its next factor</source>
        <translation>Avanzamento adattivo: senza %1, fino al suo prossimo fattore</translation>
    </message>
    <message>
        <source>Adaptive feed: the axes are held. %1: %2</source>
        <translation>Avanzamento adattivo: gli assi sono trattenuti. %1: %2</translation>
    </message>
    <message>
        <source>Adaptive feed: your override acts alone. %1: %2</source>
        <translation>Avanzamento adattivo: agisce solo il vostro override. %1: %2</translation>
    </message>
    <message>
        <source>no factor has come yet</source>
        <translation>nessun fattore è ancora arrivato</translation>
    </message>
    <message>
        <source>no factor has come in time</source>
        <translation>nessun fattore è arrivato in tempo</translation>
    </message>
    <message>
        <source>%1 % was not agreed</source>
        <translation>%1&#xa0;% non era concordato</translation>
    </message>
    <message>
        <source>its last line is no factor</source>
        <translation>la sua ultima riga non è un fattore</translation>
    </message>
    <message>
        <source>it has closed</source>
        <translation>si è chiusa</translation>
    </message>
</context>
<context>
    <name>MachineCard</name>
    <message>
        <source>No run is known.</source>
        <translation>Nessuna esecuzione nota.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connessione</translation>
    </message>
    <message>
        <source>Not connected with this window</source>
        <translation>Non collegata a questa finestra</translation>
    </message>
    <message>
        <source>%1, seen %2 ago</source>
        <translation>%1, vista %2 fa</translation>
    </message>
    <message numerus="yes">
        <source>%n alarms</source>
        <translation>
            <numerusform>%n allarme</numerusform>
            <numerusform>%n allarmi</numerusform>
        </translation>
    </message>
    <message>
        <source>limits</source>
        <translation>limiti</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>calibrazione</translation>
    </message>
    <message>
        <source>credit test</source>
        <translation>test credito</translation>
    </message>
    <message>
        <source>Remove this machine from the list? Its runs and recordings stay on the page Runs.</source>
        <translation>Rimuovere questa macchina dall’elenco? Le sue esecuzioni e registrazioni restano nella pagina Esecuzioni.</translation>
    </message>
    <message>
        <source>Put aside as files, and not used any more: %1.</source>
        <translation>Messi da parte come file e non più usati: %1.</translation>
    </message>
    <message>
        <source>Last run %1: %2, %3 of %4 points</source>
        <translation>Ultima esecuzione %1: %2, %3 di %4 punti</translation>
    </message>
    <message>
        <source>Not connected; its port answered %1 ago</source>
        <translation>Non connessa; la sua porta ha risposto %1 fa</translation>
    </message>
    <message>
        <source>Not reachable: no answer %1 ago</source>
        <translation>Non raggiungibile: nessuna risposta %1 fa</translation>
    </message>
    <message>
        <source>stop test</source>
        <translation>prova di stop</translation>
    </message>
    <message>
        <source>job test</source>
        <translation>test di lavoro</translation>
    </message>
</context>
<context>
    <name>MachinesTexts</name>
    <message>
        <source>During a run, the window stays with its machine.</source>
        <translation>Durante un’esecuzione, la finestra resta alla sua macchina.</translation>
    </message>
</context>
<context>
    <name>MoveTexts</name>
    <message>
        <source>%1 moved by %2 at %3</source>
        <translation>%1 spostato di %2 a %3</translation>
    </message>
</context>
<context>
    <name>NoteTexts</name>
    <message>
        <source>Form of access: %1.</source>
        <translation>Forma di accesso: %1.</translation>
    </message>
    <message>
        <source>Program %1: %2, %3, %4.</source>
        <translation>Programma %1: %2, %3, %4.</translation>
    </message>
    <message>
        <source>Nothing has come from the control for %1 s.</source>
        <translation>Dal controllo non arriva nulla da %1 s.</translation>
    </message>
    <message>
        <source>The control answers again.</source>
        <translation>Il controllo risponde di nuovo.</translation>
    </message>
    <message>
        <source>The control answered slowly: accesses took up to %1 s, %2 times as long as expected. Each took at least %3 s: the network is slow, or the server is busy with another OPC UA client.</source>
        <translation>Il controllo ha risposto lentamente: gli accessi sono durati fino a %1 s, %2 volte il previsto. Ognuno è durato almeno %3 s: la rete è lenta, o il server è occupato con un altro client OPC UA.</translation>
    </message>
    <message>
        <source>The control answered slowly: accesses took up to %1 s, %2 times as long as expected. Others were fast: another OPC UA client keeps the server busy at times, or the network stalls.</source>
        <translation>Il controllo ha risposto lentamente: gli accessi sono durati fino a %1 s, %2 volte il previsto. Altri erano veloci: un altro client OPC UA occupa a tratti il server, o la rete si blocca.</translation>
    </message>
    <message>
        <source>Online correction in mm: X %1 Y %2 Z %3</source>
        <translation>Correzione online in mm: X %1 Y %2 Z %3</translation>
    </message>
    <message>
        <source>The control has refused a request: asked again.</source>
        <translation>Il controllo ha rifiutato una richiesta: chiesto di nuovo.</translation>
    </message>
    <message>
        <source>No answer in time: asked again.</source>
        <translation>Nessuna risposta in tempo: chiesto di nuovo.</translation>
    </message>
    <message>
        <source>The stream was given up: %1</source>
        <translation>La trasmissione è stata abbandonata: %1</translation>
    </message>
    <message>
        <source>A signal was out of sequence: a window has been executed again.</source>
        <translation>Un segnale era fuori sequenza: una finestra è stata eseguita di nuovo.</translation>
    </message>
    <message>
        <source>The place of the run could not be kept, so it cannot be resumed after a crash of this program: %1</source>
        <translation>Il punto dell’esecuzione non si è potuto conservare, perciò non può essere ripresa dopo un arresto anomalo di questo programma: %1</translation>
    </message>
    <message>
        <source>The reason why the program ended could not be read.</source>
        <translation>Non si è potuto leggere perché il programma è terminato.</translation>
    </message>
    <message>
        <source>The trace of the control could not be fetched: %1</source>
        <translation>La registrazione del controllo non si è potuta prelevare: %1</translation>
    </message>
    <message>
        <source>The trace of the control is incomplete: the run is not judged.</source>
        <translation>La registrazione del controllo è incompleta: l’esecuzione non viene giudicata.</translation>
    </message>
    <message>
        <source>The name of the run could not be stored: %1</source>
        <translation>Il nome dell’esecuzione non si è potuto salvare: %1</translation>
    </message>
    <message>
        <source>written</source>
        <translation>scritto</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>già presente</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>confrontato</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>non confrontato</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>selezionato</translation>
    </message>
    <message>
        <source>to be selected</source>
        <translation>da selezionare</translation>
    </message>
    <message>
        <source>Adaptive feed: the source is followed.</source>
        <translation>Avanzamento adattivo: la sorgente viene seguita.</translation>
    </message>
    <message>
        <source>Adaptive feed: no factor has come yet: %1</source>
        <translation>Avanzamento adattivo: nessun fattore è ancora arrivato: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: no factor for %1 s: %2</source>
        <translation>Avanzamento adattivo: nessun fattore da %1 s: %2</translation>
    </message>
    <message>
        <source>Adaptive feed: the factor %1 was not agreed: %2 to %3, where 1 is 100 %: %4</source>
        <translation>Avanzamento adattivo: il fattore %1 non era concordato: da %2 a %3, dove 1 è il 100&#xa0;%: %4</translation>
    </message>
    <message>
        <source>Adaptive feed: the line is no factor, as feed 0.85 would be: %1</source>
        <translation>Avanzamento adattivo: la riga non è un fattore, come lo sarebbe feed 0.85: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: the source has closed: %1</source>
        <translation>Avanzamento adattivo: la sorgente si è chiusa: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: the operator goes on without the source.</source>
        <translation>Avanzamento adattivo: l’operatore prosegue senza la sorgente.</translation>
    </message>
    <message>
        <source>the axes are held.</source>
        <translation>gli assi sono trattenuti.</translation>
    </message>
    <message>
        <source>the override of the operator acts alone.</source>
        <translation>agisce solo l’override dell’operatore.</translation>
    </message>
    <message>
        <source>The axes are told to stand.</source>
        <translation>Gli assi devono fermarsi.</translation>
    </message>
    <message>
        <source>The axes are told to go on, override %1 %.</source>
        <translation>Gli assi devono proseguire, override %1 %.</translation>
    </message>
    <message>
        <source>Override %1 % requested.</source>
        <translation>Override %1 % richiesto.</translation>
    </message>
    <message>
        <source>An override of %1 % is refused: choose %2 to %3 %.</source>
        <translation>Un override di %1 % viene rifiutato: scegliere da %2 a %3 %.</translation>
    </message>
    <message>
        <source>Another client has set the override to %1 %: it stays until the next order.</source>
        <translation>Un altro client ha impostato l’override a %1 %: resta fino al prossimo ordine.</translation>
    </message>
    <message>
        <source>Another client has written the factor %1: %2 is written again.</source>
        <translation>Un altro client ha scritto il fattore %1: %2 viene scritto di nuovo.</translation>
    </message>
    <message>
        <source>The control does not obey: its override is %1 %.</source>
        <translation>Il controllo non obbedisce: il suo override è %1 %.</translation>
    </message>
    <message>
        <source>The axes stand, %1 s after it was requested.</source>
        <translation>Gli assi sono fermi, %1 s dopo la richiesta.</translation>
    </message>
    <message>
        <source>The axes move although the override is 0: what moves now does not obey it. Stop it at the control.</source>
        <translation>Gli assi si muovono benché l’override sia 0: ciò che si muove non gli obbedisce. Fermare sul controllo.</translation>
    </message>
    <message>
        <source>For %1 s no sign of this computer has reached the control: the axes have stood meanwhile.</source>
        <translation>Per %1 s nessun segno di questo computer è arrivato al controllo: nel frattempo gli assi sono rimasti fermi.</translation>
    </message>
    <message>
        <source>Lift of the tool in mm: %1</source>
        <translation>Sollevamento dell’utensile in mm: %1</translation>
    </message>
    <message>
        <source>Stopped: the axes are held, and the program is left.</source>
        <translation>Fermato: gli assi sono tenuti fermi, e il programma viene lasciato.</translation>
    </message>
    <message>
        <source>This program has no feed cell: Pause acts before the next window.</source>
        <translation>Questo programma non ha una cella dell’avanzamento: Pausa agisce prima della prossima finestra.</translation>
    </message>
    <message>
        <source>Wrong motion: after point %1 the tool is %2 mm off the path.</source>
        <translation>Movimento errato: dopo il punto %1 l’utensile è a %2 mm dal percorso.</translation>
    </message>
    <message>
        <source>Wrong motion: points were repeated after point %1.</source>
        <translation>Movimento errato: dopo il punto %1 alcuni punti sono stati ripetuti.</translation>
    </message>
    <message>
        <source>The control recorded a dwell of %1 s in line %2.</source>
        <translation>Il controllo ha registrato una sosta di %1 s alla riga %2.</translation>
    </message>
    <message>
        <source>The control recorded an auxiliary function of %1 s in line %2.</source>
        <translation>Il controllo ha registrato una funzione ausiliaria di %1 s alla riga %2.</translation>
    </message>
    <message>
        <source>The control recorded M%1 in line %2.</source>
        <translation>Il controllo ha registrato M%1 alla riga %2.</translation>
    </message>
    <message>
        <source>The override was 0 while the axes stood.</source>
        <translation>L’override era 0 mentre gli assi erano fermi.</translation>
    </message>
    <message>
        <source>A write of %1 values was answered %2 ms before the axes moved again.</source>
        <translation>La scrittura di %1 valori ha avuto risposta %2 ms prima che gli assi ripartissero.</translation>
    </message>
    <message>
        <source>The program on the control has a STOPRE between line %1 and line %2.</source>
        <translation>Il programma sul controllo ha uno STOPRE tra la riga %1 e la riga %2.</translation>
    </message>
    <message>
        <source>The program on the control jumps from line %1 back to line %2.</source>
        <translation>Il programma sul controllo salta dalla riga %1 indietro alla riga %2.</translation>
    </message>
    <message>
        <source>The path turns by %1° there.</source>
        <translation>Lì il percorso piega di %1°.</translation>
    </message>
    <message>
        <source>Line %1 of the program dwells there.</source>
        <translation>La riga %1 del programma vi sosta.</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Feasibility</source>
        <translation>Fattibilità</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Curve</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 salvato.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Allarmi</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messaggi</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Utenti</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Esecuzioni</translation>
    </message>
    <message>
        <source>Configure</source>
        <translation>Configura</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Macchine</translation>
    </message>
    <message>
        <source>Emulator</source>
        <translation>Emulatore</translation>
    </message>
    <message>
        <source>CNC tasks</source>
        <translation>Compiti CNC</translation>
    </message>
</context>
<context>
    <name>ParallelPageTexts</name>
    <message>
        <source>A run is in progress. Execute the program after it has ended: both would take the same processor.</source>
        <translation>Un’esecuzione è in corso. Eseguire il programma quando è finita: entrambi userebbero lo stesso processore.</translation>
    </message>
</context>
<context>
    <name>PauseTexts</name>
    <message>
        <source>M</source>
        <comment>letter for a measured pause</comment>
        <translation>M</translation>
    </message>
    <message>
        <source>I</source>
        <comment>letter for an inferred pause</comment>
        <translation>D</translation>
    </message>
    <message>
        <source>P</source>
        <comment>letter for a predicted pause</comment>
        <translation>P</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>misurata</translation>
    </message>
    <message>
        <source>inferred</source>
        <translation>dedotta</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>prevista</translation>
    </message>
</context>
<context>
    <name>ProfileTexts</name>
    <message>
        <source>Axis %1: the travel must end above its beginning.</source>
        <translation>Asse %1: la corsa deve finire sopra il suo inizio.</translation>
    </message>
    <message>
        <source>Axis %1: the speed must be above zero.</source>
        <translation>Asse %1: la velocità deve essere maggiore di zero.</translation>
    </message>
    <message>
        <source>Axis %1: the acceleration must be above zero.</source>
        <translation>Asse %1: l’accelerazione deve essere maggiore di zero.</translation>
    </message>
    <message>
        <source>Axis %1: the jerk must be above zero.</source>
        <translation>Asse %1: lo strappo deve essere maggiore di zero.</translation>
    </message>
    <message>
        <source>The rapid must be above zero.</source>
        <translation>Il rapido deve essere maggiore di zero.</translation>
    </message>
    <message>
        <source>Tool %1: every tool needs its own number above zero.</source>
        <translation>Utensile %1: ogni utensile richiede un proprio numero maggiore di zero.</translation>
    </message>
    <message>
        <source>Without this computer the axes stand after 0.2 to 60 s; 0: not at all.</source>
        <translation>Senza questo computer gli assi si fermano dopo 0,2 - 60 s; 0: mai.</translation>
    </message>
    <message>
        <source>Without a passed stop test a window takes at most 0.5 to 600 s.</source>
        <translation>Senza prova di stop superata una finestra dura al massimo da 0,5 a 600 s.</translation>
    </message>
</context>
<context>
    <name>ProgramTexts</name>
    <message>
        <source>Parts of the path of %1 are not known: see the findings. The program cannot be streamed.</source>
        <translation>Parti del percorso di %1 non sono note: vedi le segnalazioni. Il programma non può essere trasmesso in continuo.</translation>
    </message>
    <message>
        <source>%1 needs a transformation of the control. No method can stream it.</source>
        <translation>%1 richiede una trasformazione del controllo. Nessun metodo può trasmetterlo in continuo.</translation>
    </message>
    <message>
        <source>%1 moves no axis: there is nothing to stream.</source>
        <translation>%1 non muove alcun asse: non c’è nulla da trasmettere.</translation>
    </message>
    <message>
        <source>A run is in progress. Open another program after it has ended.</source>
        <translation>Un’esecuzione è in corso. Aprire un altro programma quando sarà terminata.</translation>
    </message>
    <message>
        <source>Reading %1 was cancelled.</source>
        <translation>La lettura di %1 è stata annullata.</translation>
    </message>
    <message numerus="yes">
        <source>Opened %1 (%2), %Ln points.</source>
        <translation>
            <numerusform>Aperto %1 (%2), %Ln punto.</numerusform>
            <numerusform>Aperto %1 (%2), %Ln punti.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RehearsalTexts</name>
    <message>
        <source>The program is being simulated with these settings.</source>
        <translation>Simulazione del programma con queste impostazioni in corso.</translation>
    </message>
    <message>
        <source>all %1 points</source>
        <translation>tutti i %1 punti</translation>
    </message>
    <message>
        <source>the %1 most difficult points</source>
        <translation>i %1 punti più difficili</translation>
    </message>
    <message>
        <source>Simulation of %1: wrong points in %2 of %3 runs.</source>
        <translation>Simulazione (%1): punti errati in %2 prove su %3.</translation>
    </message>
    <message numerus="yes">
        <source>Simulation of %1: no wrong point in %n runs.</source>
        <translation>
            <numerusform>Simulazione (%1): nessun punto errato in %n prova.</numerusform>
            <numerusform>Simulazione (%1): nessun punto errato in %n prove.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RejectedModel</name>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Rilasciato a</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Valido</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Impronta</translation>
    </message>
</context>
<context>
    <name>RightTexts</name>
    <message>
        <source>read variables</source>
        <translation>leggere variabili</translation>
    </message>
    <message>
        <source>follows the run</source>
        <translation>segue l’esecuzione</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with StateRead; if that is not enough, with SinuReadAll.</source>
        <translation>Chiamare GiveUserAccess con StateRead; se non basta, con SinuReadAll.</translation>
    </message>
    <message>
        <source>write R-parameters</source>
        <translation>scrivere parametri R</translation>
    </message>
    <message>
        <source>sends the points</source>
        <translation>invia i punti</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with StateWrite; if that is not enough, with SinuWriteAll. The protection level of R-parameters (MD51051) must allow it, too.</source>
        <translation>Chiamare GiveUserAccess con StateWrite; se non basta, con SinuWriteAll. Anche il livello di protezione dei parametri R (MD51051) deve consentirlo.</translation>
    </message>
    <message>
        <source>read programs</source>
        <translation>leggere programmi</translation>
    </message>
    <message>
        <source>checks which program is on the control; without it the operator does</source>
        <translation>verifica quale programma è sul controllo; altrimenti lo fa l’operatore</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with FsRead.</source>
        <translation>Chiamare GiveUserAccess con FsRead.</translation>
    </message>
    <message>
        <source>write programs</source>
        <translation>scrivere programmi</translation>
    </message>
    <message>
        <source>brings its program to the control; without it the operator copies it</source>
        <translation>porta il suo programma sul controllo; altrimenti lo copia l’operatore</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with FsWrite.</source>
        <translation>Chiamare GiveUserAccess con FsWrite.</translation>
    </message>
    <message>
        <source>select a program</source>
        <translation>selezionare un programma</translation>
    </message>
    <message>
        <source>selects its program; without it the operator does</source>
        <translation>seleziona il suo programma; altrimenti lo fa l’operatore</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with ApWrite.</source>
        <translation>Chiamare GiveUserAccess con ApWrite.</translation>
    </message>
    <message>
        <source>Let this OPC UA user read the nodes of the map, in the settings of the server.</source>
        <translation>Permettere a questo utente OPC UA, nelle impostazioni del server, di leggere i nodi della mappa.</translation>
    </message>
    <message>
        <source>Let this OPC UA user write the cells of the map, in the settings of the server.</source>
        <translation>Permettere a questo utente OPC UA, nelle impostazioni del server, di scrivere le celle della mappa.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.read), if the server has one, and let this OPC UA user call it.</source>
        <translation>Nominare il metodo nella mappa (methods.read), se il server ne ha uno, e permettere a questo utente OPC UA di chiamarlo.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.write), if the server has one, and let this OPC UA user call it.</source>
        <translation>Nominare il metodo nella mappa (methods.write), se il server ne ha uno, e permettere a questo utente OPC UA di chiamarlo.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.select), if the server has one, and let this OPC UA user call it.</source>
        <translation>Nominare il metodo nella mappa (methods.select), se il server ne ha uno, e permettere a questo utente OPC UA di chiamarlo.</translation>
    </message>
</context>
<context>
    <name>RunStateTexts</name>
    <message>
        <source>Idle</source>
        <translation>A riposo</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>In corso</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>In arresto</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Completato</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Sospeso</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Preparazione</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrestato</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fallito</translation>
    </message>
</context>
<context>
    <name>RunTexts</name>
    <message>
        <source>No program is loaded.</source>
        <translation>Nessun programma caricato.</translation>
    </message>
    <message>
        <source>The program has fewer than two points.</source>
        <translation>Il programma ha meno di due punti.</translation>
    </message>
    <message>
        <source>Running: %1, version %2</source>
        <translation>In corso: %1, versione %2</translation>
    </message>
    <message>
        <source>Program: %1, version %2</source>
        <translation>Programma: %1, versione %2</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 su %2</translation>
    </message>
    <message>
        <source>program, %1 %</source>
        <translation>programma, %1 %</translation>
    </message>
    <message>
        <source>Whole jobs need method window or credit.</source>
        <translation>I lavori completi richiedono il metodo Finestra o Credito.</translation>
    </message>
    <message>
        <source>A whole job cannot be corrected online.</source>
        <translation>Un lavoro completo non può essere corretto online.</translation>
    </message>
    <message>
        <source>Parts of the program are not known: see the findings.</source>
        <translation>Parti del programma non sono note: vedi le segnalazioni.</translation>
    </message>
    <message>
        <source>%1 (line %2) cannot be given to the control.</source>
        <translation>%1 (riga %2) non può essere passato al controllo.</translation>
    </message>
    <message>
        <source>%1 streamed, %2 pauses, %3 tool changes, %4 other blocks of the control, %5 changes between both; %6 in all</source>
        <translation>%1 trasmessi, %2 pause, %3 cambi utensile, %4 altri blocchi del controllo, %5 passaggi tra i due; %6 in tutto</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fallita</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrestata</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Completata</translation>
    </message>
    <message>
        <source>Stopped, not judged</source>
        <translation>Arrestata, non valutata</translation>
    </message>
    <message>
        <source>Completed, not judged</source>
        <translation>Completata, non valutata</translation>
    </message>
    <message>
        <source>Stopped, with wrong motion</source>
        <translation>Arrestata, con movimento errato</translation>
    </message>
    <message>
        <source>Completed with wrong motion</source>
        <translation>Completata con movimento errato</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Segnale</translation>
    </message>
    <message>
        <source>Credit (experimental)</source>
        <translation>Credito (sperimentale)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Finestra</translation>
    </message>
    <message>
        <source>Begin with a part</source>
        <translation>Iniziare da un tratto</translation>
    </message>
    <message>
        <source>Part (1 to %1). What the machine needs there is listed before anything moves.</source>
        <translation>Tratto (da 1 a %1). Ciò che serve alla macchina in quel punto è elencato prima di ogni movimento.</translation>
    </message>
    <message>
        <source>A live source needs no verdict: the machine waits for points that are late.</source>
        <translation>Una sorgente in diretta non ha bisogno di esito: la macchina attende i punti in ritardo.</translation>
    </message>
    <message>
        <source>Live points from %1</source>
        <translation>Punti in diretta da %1</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Nessun utensile</translation>
    </message>
    <message>
        <source>Before the first tool change</source>
        <translation>Prima del primo cambio utensile</translation>
    </message>
    <message>
        <source>%1 in the spindle</source>
        <translation>%1 nel mandrino</translation>
    </message>
    <message>
        <source>%1 change</source>
        <translation>%1 cambio</translation>
    </message>
    <message>
        <source>%1 at %2 1/min</source>
        <translation>%1 a %2 giri/min</translation>
    </message>
    <message>
        <source>%1 coolant</source>
        <translation>%1 refrigerante</translation>
    </message>
    <message>
        <source>Straight way to the first point</source>
        <translation>Via diretta al primo punto</translation>
    </message>
    <message>
        <source>CLEAR</source>
        <extracomment>What the operator types; a translation may be any one word.</extracomment>
        <translation>LIBERO</translation>
    </message>
    <message>
        <source>The tool goes straight through the space in which the program cuts. Look whether anything is in its way: workpiece, clamps. If nothing is, type %1.</source>
        <translation>L&apos;utensile attraversa in linea retta la zona che il programma lavora. Controllare se c&apos;è qualcosa sulla sua via: pezzo, staffe. Se non c&apos;è nulla, digitare %1.</translation>
    </message>
    <message>
        <source>Method that may repeat points</source>
        <translation>Metodo che può ripetere punti</translation>
    </message>
    <message>
        <source>this may execute old points again</source>
        <extracomment>What the operator types, word by word.</extracomment>
        <translation>questo può eseguire di nuovo punti vecchi</translation>
    </message>
    <message>
        <source>This method of the publication knows no numbered windows. If this computer is late, the control executes old points again. To start all the same, type:
%1</source>
        <translation>Questo metodo della pubblicazione non conosce finestre numerate. Se questo computer è in ritardo, il controllo esegue di nuovo punti vecchi. Per avviare comunque, digitare:
%1</translation>
    </message>
    <message>
        <source>The path is being measured.</source>
        <translation>Il percorso è in corso di misurazione.</translation>
    </message>
    <message>
        <source>Whole jobs have not been tested on this machine: Configure, Job test.</source>
        <translation>I lavori completi non sono stati provati su questa macchina: Configura, Test lavoro.</translation>
    </message>
</context>
<context>
    <name>RunsTexts</name>
    <message>
        <source>This is not the report of a run. Choose a file that this page or stream --json has written.</source>
        <translation>Non è il rapporto di un’esecuzione. Scegliere un file scritto da questa pagina o da stream --json.</translation>
    </message>
    <message>
        <source>The report was written by a later version of Rivulet. Use that one to open it.</source>
        <translation>Il rapporto è stato scritto da una versione più recente di Rivulet. Aprirlo con quella.</translation>
    </message>
    <message>
        <source>The report is damaged and cannot be shown.</source>
        <translation>Il rapporto è danneggiato e non può essere mostrato.</translation>
    </message>
</context>
<context>
    <name>ServerModel</name>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificato</translation>
    </message>
    <message>
        <source>none accepted</source>
        <translation>nessuno accettato</translation>
    </message>
    <message>
        <source>accepted, not kept</source>
        <translation>accettato, non conservato</translation>
    </message>
    <message>
        <source>has ended</source>
        <translation>è scaduto</translation>
    </message>
    <message numerus="yes">
        <source>valid for %Ln days</source>
        <translation>
            <numerusform>valido ancora %Ln giorno</numerusform>
            <numerusform>valido ancora %Ln giorni</numerusform>
        </translation>
    </message>
    <message>
        <source>Protection</source>
        <translation>Protezione</translation>
    </message>
    <message>
        <source>the strongest</source>
        <translation>la più forte</translation>
    </message>
    <message>
        <source>allowed: %1</source>
        <translation>consentito: %1</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Impronta</translation>
    </message>
</context>
<context>
    <name>ServiceTexts</name>
    <message>
        <source>Connecting …</source>
        <translation>Connessione…</translation>
    </message>
    <message>
        <source>No answer for some seconds</source>
        <translation>Nessuna risposta da alcuni secondi</translation>
    </message>
    <message>
        <source>Service does not answer</source>
        <translation>Il servizio non risponde</translation>
    </message>
    <message>
        <source>Not connected: needs a decision</source>
        <translation>Non connesso: serve una decisione</translation>
    </message>
    <message>
        <source>Machine does not answer</source>
        <translation>La macchina non risponde</translation>
    </message>
    <message>
        <source>Connecting to the machine …</source>
        <translation>Connessione alla macchina…</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Nessun programma</translation>
    </message>
    <message>
        <source>Program loaded</source>
        <translation>Programma caricato</translation>
    </message>
    <message>
        <source>Run interrupted</source>
        <translation>Esecuzione interrotta</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 punti di %2</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, ancora %2</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>Ricerca…</translation>
    </message>
    <message>
        <source>No other services are known there.</source>
        <translation>Lì non sono noti altri servizi.</translation>
    </message>
    <message>
        <source>Only an engineer can do this.</source>
        <translation>Può farlo solo un attrezzista.</translation>
    </message>
    <message>
        <source>This service is on the board.</source>
        <translation>Questo servizio è già sul pannello.</translation>
    </message>
</context>
<context>
    <name>SetUpTexts</name>
    <message>
        <source>Connect first: limits belong to one machine.</source>
        <translation>Prima collegarsi: i limiti appartengono a una macchina.</translation>
    </message>
    <message>
        <source>Only an engineer can do this, and not during a run.</source>
        <translation>Può farlo solo un attrezzista, e non durante un’esecuzione.</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Connessione</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limiti</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Modello</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibrazione</translation>
    </message>
    <message>
        <source>Credit test</source>
        <translation>Test credito</translation>
    </message>
    <message>
        <source>Certificates</source>
        <translation>Certificati</translation>
    </message>
    <message>
        <source>Rights</source>
        <translation>Diritti</translation>
    </message>
    <message>
        <source>Stop test</source>
        <translation>Test stop</translation>
    </message>
    <message>
        <source>Job test</source>
        <translation>Test lavoro</translation>
    </message>
</context>
<context>
    <name>SheetTexts</name>
    <message>
        <source>Report of a run</source>
        <translation>Rapporto di esecuzione</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Esecuzione</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Risultato</translation>
    </message>
    <message>
        <source>Pauses and access</source>
        <translation>Pause e accessi</translation>
    </message>
    <message>
        <source>Path, seen from above; rapids dashed</source>
        <translation>Percorso visto dall’alto; rapidi tratteggiati</translation>
    </message>
    <message>
        <source>The path was not kept.</source>
        <translation>Il percorso non è stato conservato.</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Data, nome, firma</translation>
    </message>
    <message>
        <source>Rivulet %1; run made with version %2</source>
        <translation>Rivulet %1; esecuzione fatta con la versione %2</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Version (hash)</source>
        <translation>Versione (hash)</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Avvio</translation>
    </message>
    <message>
        <source>Started by</source>
        <translation>Avviata da</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>Numero di esecuzione</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Assi</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accesso</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Finestre</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non valutato</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Eseguito</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Ripetuti</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Saltati</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Fuori dal programma</translation>
    </message>
    <message>
        <source>Out of order</source>
        <translation>Fuori ordine</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durata</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Pauses in all</source>
        <translation>Pause in totale</translation>
    </message>
    <message>
        <source>Share of the duration</source>
        <translation>Quota della durata</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Richieste</translation>
    </message>
    <message>
        <source>Access, median</source>
        <translation>Accesso, mediana</translation>
    </message>
    <message>
        <source>Access, 99th percentile</source>
        <translation>Accesso, 99º percentile</translation>
    </message>
    <message>
        <source>Streamed</source>
        <translation>Trasmesso</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>Cambi utensile</translation>
    </message>
    <message>
        <source>Other blocks of the control</source>
        <translation>Altri blocchi del controllo</translation>
    </message>
    <message>
        <source>Changes between both</source>
        <translation>Passaggi tra i due</translation>
    </message>
    <message>
        <source>%1, dry run %2 higher</source>
        <translation>%1, prova a vuoto %2 più in alto</translation>
    </message>
    <message>
        <source>Live lines</source>
        <translation>Righe in diretta</translation>
    </message>
    <message>
        <source>Delay from arrival to motion</source>
        <translation>Ritardo dall’arrivo al movimento</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Utensili</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Utensile</translation>
    </message>
    <message>
        <source>In the spindle</source>
        <translation>Nel mandrino</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>Speed, 1/min</source>
        <translation>Velocità, giri/min</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>In rotazione</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Refrigerante</translation>
    </message>
</context>
<context>
    <name>SignalTexts</name>
    <message>
        <source>Length along the program, actual</source>
        <translation>Lunghezza lungo il programma, effettiva</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Valore nominale</translation>
    </message>
    <message>
        <source>Actual position</source>
        <translation>Posizione reale</translation>
    </message>
    <message>
        <source>Lag (set point minus actual)</source>
        <translation>Errore d’inseguimento (nom. − reale)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accelerazione</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Jerk</translation>
    </message>
    <message>
        <source>Contour error</source>
        <translation>Errore di contorno</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Requests to the control</source>
        <translation>Richieste al controllo</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Colonne del file</translation>
    </message>
    <message>
        <source>%1 set point</source>
        <comment>of an axis</comment>
        <translation>%1 nominale</translation>
    </message>
    <message>
        <source>%1 actual</source>
        <comment>of an axis</comment>
        <translation>%1 reale</translation>
    </message>
    <message>
        <source>%1 lag</source>
        <comment>of an axis</comment>
        <translation>%1 inseguimento</translation>
    </message>
    <message>
        <source>%1 speed</source>
        <comment>of an axis</comment>
        <translation>%1 velocità</translation>
    </message>
    <message>
        <source>%1 acceleration</source>
        <comment>of an axis</comment>
        <translation>%1 accelerazione</translation>
    </message>
    <message>
        <source>%1 jerk</source>
        <comment>of an axis</comment>
        <translation>%1 jerk</translation>
    </message>
    <message>
        <source>Path speed</source>
        <translation>Velocità sul percorso</translation>
    </message>
    <message>
        <source>Path acceleration</source>
        <translation>Accelerazione sul percorso</translation>
    </message>
    <message>
        <source>Contour error, actual</source>
        <translation>Errore di contorno, reale</translation>
    </message>
    <message>
        <source>Contour error, set point</source>
        <translation>Errore di contorno, nominale</translation>
    </message>
    <message>
        <source>Line on the control</source>
        <translation>Riga sul controllo</translation>
    </message>
    <message>
        <source>Line of the program</source>
        <translation>Riga del programma</translation>
    </message>
    <message>
        <source>Point of the program</source>
        <translation>Punto del programma</translation>
    </message>
    <message>
        <source>Programmed feed</source>
        <translation>Avanzamento programmato</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Duration of writes</source>
        <translation>Durata delle scritture</translation>
    </message>
    <message>
        <source>Duration of reads</source>
        <translation>Durata delle letture</translation>
    </message>
    <message>
        <source>Length along the program</source>
        <translation>Lunghezza lungo il programma</translation>
    </message>
    <message>
        <source>Time since the first sample</source>
        <translation>Tempo dal primo campione</translation>
    </message>
</context>
<context>
    <name>StopCauseTexts</name>
    <message>
        <source>Unknown</source>
        <translation>Sconosciuta</translation>
    </message>
    <message>
        <source>Exact stop</source>
        <translation>Arresto preciso</translation>
    </message>
    <message>
        <source>Dwell (G4)</source>
        <translation>Sosta (G4)</translation>
    </message>
    <message>
        <source>Programmed stop (M0, M1)</source>
        <translation>Arresto programmato (M0, M1)</translation>
    </message>
    <message>
        <source>Tool change or auxiliary function</source>
        <translation>Cambio utensile o funzione ausiliaria</translation>
    </message>
    <message>
        <source>Waiting for data of the client</source>
        <translation>Attesa di dati del client</translation>
    </message>
    <message>
        <source>Preprocessor stop</source>
        <translation>Arresto preelaborazione</translation>
    </message>
    <message>
        <source>Pause: override 0</source>
        <translation>Pausa: override 0</translation>
    </message>
</context>
<context>
    <name>StopTexts</name>
    <message>
        <source>That stop and pause act at once has not been tested on this control: see Stop test.</source>
        <translation>Che stop e pausa agiscano subito non è stato provato su questo controllo: vedere Test stop.</translation>
    </message>
    <message>
        <source>That stop and pause act at once was tested with another version of the server: test it again.</source>
        <translation>Che stop e pausa agiscano subito è stato provato con un&apos;altra versione del server: provarlo di nuovo.</translation>
    </message>
    <message>
        <source>This control has failed the test that stop and pause act at once.</source>
        <translation>Questo controllo non ha superato la prova che stop e pausa agiscano subito.</translation>
    </message>
    <message>
        <source>That stop and pause act at once was tested without motion only: see Stop test.</source>
        <translation>Che stop e pausa agiscano subito è stato provato solo senza movimento: vedere Test stop.</translation>
    </message>
</context>
<context>
    <name>TemplateSheetTexts</name>
    <message>
        <source>Bring %1 to the control</source>
        <translation>Portare %1 sul controllo</translation>
    </message>
    <message>
        <source>Layout number %1: with another one Rivulet moves nothing</source>
        <translation>Numero di layout %1: con un altro Rivulet non muove nulla</translation>
    </message>
    <message>
        <source>This program runs on the control and moves the axes to the points that Rivulet sends in R-parameters. It is valid for the settings on this page only; with others it has another layout number.</source>
        <translation>Questo programma viene eseguito sul controllo e muove gli assi verso i punti che Rivulet invia nei parametri R. Vale solo per le impostazioni di questa pagina; con altre ha un altro numero di layout.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>File on the control</source>
        <translation>File sul controllo</translation>
    </message>
    <message>
        <source>Layout number</source>
        <translation>Numero di layout</translation>
    </message>
    <message>
        <source>%1 in R%2</source>
        <translation>%1 in R%2</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>Points, axes</source>
        <translation>Punti, assi</translation>
    </message>
    <message>
        <source>Make sure that no other program, cycle or client uses R%1 to R%2.</source>
        <translation>Accertarsi che nessun altro programma, ciclo o client usi da R%1 a R%2.</translation>
    </message>
    <message>
        <source>Copy the file to the part programs of the control, by network or USB stick, as %1. Change nothing in it: Rivulet relies on every line.</source>
        <translation>Copiare il file nei programmi pezzo del controllo, via rete o chiavetta USB, come %1. Non cambiarvi nulla: Rivulet si basa su ogni riga.</translation>
    </message>
    <message>
        <source>Copy the file to the folder of the NC programs of the control as %1. Change nothing in it: Rivulet relies on every line.</source>
        <translation>Copiare il file nella cartella dei programmi NC del controllo come %1. Non cambiarvi nulla: Rivulet si basa su ogni riga.</translation>
    </message>
    <message numerus="yes">
        <source>In Rivulet, column Settings, tick “copied by hand” at Template. Look through what Start shows, then hold Start. From then on Rivulet waits up to %n minutes.</source>
        <translation>
            <numerusform>In Rivulet, colonna Impostazioni, spuntare «copiato a mano» a Modello. Controllare ciò che mostra Avvio, poi tenerlo premuto. Da allora Rivulet attende fino a %n minuto.</numerusform>
            <numerusform>In Rivulet, colonna Impostazioni, spuntare «copiato a mano» a Modello. Controllare ciò che mostra Avvio, poi tenerlo premuto. Da allora Rivulet attende fino a %n minuti.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the control: select the program in channel 1, close the doors, set the feed override, press cycle start. No axis moves yet.</source>
        <translation>Sul controllo: selezionare il programma nel canale 1, chiudere le porte, impostare l’override di avanzamento, premere Start NC. Nessun asse si muove ancora.</translation>
    </message>
    <message>
        <source>The program writes its layout number and waits. Only when Rivulet has read the right number, it sends points and the axes move.</source>
        <translation>Il programma scrive il suo numero di layout e attende. Solo quando Rivulet ha letto il numero giusto invia punti e gli assi si muovono.</translation>
    </message>
    <message>
        <source>The control shows this program as running from cycle start until its end, also while the axes stand and it waits for points.</source>
        <translation>Il controllo mostra questo programma in esecuzione da Start NC fino alla fine, anche mentre gli assi sono fermi e attende punti.</translation>
    </message>
    <message>
        <source>Feed override, feed hold, reset and emergency stop of the machine act as in any other program. Stop and Pause in Rivulet do not replace them.</source>
        <translation>Override di avanzamento, arresto avanzamento, Reset e arresto di emergenza della macchina agiscono come in ogni altro programma. Stop e Pausa di Rivulet non li sostituiscono.</translation>
    </message>
    <message>
        <source>If Rivulet, its computer or the network fails, nothing new is sent: with numbered windows the axes stand; with methods position and signal they may go to old points again.</source>
        <translation>Se Rivulet, il suo computer o la rete si guastano, non viene inviato nulla di nuovo: con finestre numerate gli assi si fermano; con i metodi Posizione e Segnale possono tornare a punti vecchi.</translation>
    </message>
    <message>
        <source>End the run in Rivulet. If the program still runs: press reset at the control.</source>
        <translation>Terminare l’esecuzione in Rivulet. Se il programma è ancora in corso: premere Reset sul controllo.</translation>
    </message>
    <message>
        <source>Select another program, then delete the file from the part programs of the control.</source>
        <translation>Selezionare un altro programma, poi cancellare il file dai programmi pezzo del controllo.</translation>
    </message>
    <message>
        <source>The R-parameters keep their last values. Set to 0 those that other programs read.</source>
        <translation>I parametri R mantengono gli ultimi valori. Mettere a 0 quelli che altri programmi leggono.</translation>
    </message>
    <message>
        <source>Take back the rights that were given for it; on a SINUMERIK with DeleteUserAccess. Remove the certificate of this computer from those that the control trusts if Rivulet is not to connect again.</source>
        <translation>Revocare i diritti concessi; su un SINUMERIK con DeleteUserAccess. Togliere il certificato di questo computer da quelli fidati del controllo se Rivulet non deve più connettersi.</translation>
    </message>
    <message>
        <source>Rights of the OPC UA user</source>
        <translation>Diritti dell’utente OPC UA</translation>
    </message>
    <message>
        <source>(Not needed for these steps.)</source>
        <translation>(Non necessario per questi passi.)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Passi</translation>
    </message>
    <message>
        <source>What the operator sees</source>
        <translation>Che cosa vede l’operatore</translation>
    </message>
    <message>
        <source>Taking it back</source>
        <translation>Rimuovere tutto</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Data, nome, firma</translation>
    </message>
</context>
<context>
    <name>TraceRemarks</name>
    <message>
        <source>The program does not belong to this trace from %1 s on.</source>
        <translation>Da %1 s in poi il programma non appartiene a questa traccia.</translation>
    </message>
    <message>
        <source>The trace of the control is incomplete: its memory was full.</source>
        <translation>La traccia del controllo è incompleta: la sua memoria era piena.</translation>
    </message>
    <message>
        <source>Lines of the recording that cannot be read and were left out: %1.</source>
        <translation>Righe illeggibili della registrazione, tralasciate: %1.</translation>
    </message>
    <message>
        <source>The recording ends before its run: what came before is shown.</source>
        <translation>La registrazione finisce prima della sua esecuzione: è mostrato quanto precede.</translation>
    </message>
    <message>
        <source>The columns mean what was said for this layout before: %1.</source>
        <translation>Le colonne hanno il significato indicato in precedenza per questa disposizione: %1.</translation>
    </message>
    <message>
        <source>The file does not say the units of its speeds: mm/min is assumed, as the control shows them.</source>
        <translation>Il file non indica le unità delle velocità: si assume mm/min, come le mostra il controllo.</translation>
    </message>
    <message>
        <source>The compressed file is cut or damaged: what came before was read.</source>
        <translation>Il file compresso è troncato o danneggiato: è stato letto quanto precede.</translation>
    </message>
    <message>
        <source>The file was cut off: its end is missing.</source>
        <translation>Il file è stato troncato: manca la fine.</translation>
    </message>
    <message>
        <source>The file ends within a row: it was cut off there.</source>
        <translation>Il file finisce a metà di una riga: lì è stato troncato.</translation>
    </message>
    <message>
        <source>Cells that are no numbers and were left empty: %1, the first in line %2.</source>
        <translation>Celle lasciate vuote perché non sono numeri: %1, la prima alla riga %2.</translation>
    </message>
    <message>
        <source>Rows that do not have %1 columns and were left out: %2, the first in line %3.</source>
        <translation>Righe tralasciate perché non hanno %1 colonne: %2, la prima alla riga %3.</translation>
    </message>
    <message>
        <source>The file has %1 columns of time; each belongs to the columns after it.</source>
        <translation>Il file ha %1 colonne del tempo; ognuna vale per le colonne che la seguono.</translation>
    </message>
    <message>
        <source>Values whose time runs backwards and that were left out: %1.</source>
        <translation>Valori tralasciati perché il loro tempo torna indietro: %1.</translation>
    </message>
    <message>
        <source>Rows that repeat the time of the row before and were left out: %1.</source>
        <translation>Righe tralasciate perché ripetono il tempo della precedente: %1.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; runs backwards at row %2. Rows that were left out until it goes on: %3.</source>
        <translation>Il tempo «%1» torna indietro alla riga %2. Righe tralasciate finché non prosegue: %3.</translation>
    </message>
    <message>
        <source>The file has no column of time: %1 Hz is assumed.</source>
        <translation>Il file non ha una colonna del tempo: si assumono %1 Hz.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; has no unit: %2 is assumed.</source>
        <translation>Il tempo «%1» non ha unità: si assume %2.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; occurs more than once: this one is called &quot;%2&quot;.</source>
        <translation>La colonna «%1» compare più volte: questa si chiama «%2».</translation>
    </message>
    <message>
        <source>Datasets that are no row of numbers and were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Insiemi di dati che non sono una serie di numeri e sono stati tralasciati: %1, il primo «%2».</translation>
    </message>
    <message>
        <source>Datasets that are damaged and were read in part or not at all: %1, the first &quot;%2&quot;.</source>
        <translation>Insiemi di dati danneggiati, letti in parte o per niente: %1, il primo «%2».</translation>
    </message>
    <message>
        <source>Datasets to whose length no time belongs and that were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Insiemi di dati senza un tempo della stessa lunghezza, tralasciati: %1, il primo «%2».</translation>
    </message>
    <message>
        <source>The rows are not in the order of their time &quot;%1&quot;, the first at row %2: they were sorted.</source>
        <translation>Le righe non sono nell’ordine del loro tempo «%1», la prima è la %2: sono state ordinate.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; starts again, the first time at row %2. %3 sections are shown %4 s apart, and the longest one is analysed.</source>
        <translation>Il tempo «%1» ricomincia, la prima volta alla riga %2. %3 sezioni sono mostrate a %4 s di distanza, e si analizza la più lunga.</translation>
    </message>
    <message>
        <source>The signals stand in rows of their own: straight lines are assumed between the values of each.</source>
        <translation>Ogni segnale sta in righe proprie: tra i suoi valori si suppongono rette.</translation>
    </message>
    <message>
        <source>Rows of text that hold no values and were left out: %1, the first in line %2.</source>
        <translation>Righe di testo senza valori, tralasciate: %1, la prima alla riga %2.</translation>
    </message>
    <message>
        <source>No date tells what comes first in it: day/month is assumed.</source>
        <translation>Nessuna data indica che cosa viene prima: si suppone giorno/mese.</translation>
    </message>
    <message>
        <source>An MTConnect agent reports a value when it changes: in gaps the last value is held; otherwise straight lines are assumed between values.</source>
        <translation>Un agente MTConnect segnala un valore quando cambia: nelle lacune resta valido l’ultimo valore; altrimenti tra i valori si assumono linee rette.</translation>
    </message>
    <message>
        <source>All positions are known from %1 s on: what comes before is not analysed.</source>
        <translation>Tutte le posizioni sono note da %1 s in poi: ciò che precede non viene analizzato.</translation>
    </message>
    <message>
        <source>Values with the time of a later value of the same item, which counts instead: %1.</source>
        <translation>Valori con il tempo di un valore successivo dello stesso elemento, che conta al loro posto: %1.</translation>
    </message>
    <message>
        <source>Observations that are tables or sets of values and were left out: %1, the first of &quot;%2&quot;.</source>
        <translation>Osservazioni che sono tabelle o insiemi di valori e che sono state tralasciate: %1, la prima di «%2».</translation>
    </message>
    <message>
        <source>Series of values without a sample rate that were left out, because their times are not known: %1, the first of &quot;%2&quot;.</source>
        <translation>Serie di valori senza frequenza di campionamento, tralasciate perché i loro tempi non sono noti: %1, la prima di «%2».</translation>
    </message>
    <message>
        <source>Observations without a time or a number that can be read and that were left out: %1, the first of &quot;%2&quot;.</source>
        <translation>Osservazioni senza un tempo o un numero leggibile, che sono state tralasciate: %1, la prima di «%2».</translation>
    </message>
    <message>
        <source>Items without any value that were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Elementi senza alcun valore, che sono stati tralasciati: %1, il primo «%2».</translation>
    </message>
    <message>
        <source>Items that mean the same as another one, which is analysed instead: %1.</source>
        <translation>Elementi che significano lo stesso di un altro, che viene analizzato al loro posto: %1.</translation>
    </message>
    <message>
        <source>The unit &quot;%2&quot; of the item &quot;%1&quot; is not known: the item is not analysed.</source>
        <translation>L’unità «%2» dell’elemento «%1» non è nota: l’elemento non viene analizzato.</translation>
    </message>
    <message>
        <source>States and messages of the machine that are too many and were left out: %1.</source>
        <translation>Stati e messaggi della macchina che sono troppi e sono stati tralasciati: %1.</translation>
    </message>
    <message>
        <source>The MTConnect agent refused a part: %1.</source>
        <translation>L’agente MTConnect ha rifiutato una parte: %1.</translation>
    </message>
    <message>
        <source>Observations between two answers that the MTConnect agent no longer had: %1. The motion is not known there.</source>
        <translation>Osservazioni tra due risposte che l’agente MTConnect non aveva più: %1. Il movimento lì non è noto.</translation>
    </message>
    <message>
        <source>The MTConnect agent was started again between two answers: what it had kept until then may be incomplete.</source>
        <translation>L’agente MTConnect è stato riavviato tra due risposte: ciò che aveva conservato fino ad allora può essere incompleto.</translation>
    </message>
</context>
<context>
    <name>TraceTexts</name>
    <message>
        <source>Report of a run</source>
        <translation>Rapporto di esecuzione</translation>
    </message>
    <message>
        <source>Report on a motion</source>
        <translation>Rapporto su un movimento</translation>
    </message>
    <message>
        <source>Every point executed once, in order</source>
        <translation>Ogni punto eseguito una volta, nell’ordine</translation>
    </message>
    <message>
        <source>The motion is not that of the program</source>
        <translation>Il movimento non è quello del programma</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Non valutato</translation>
    </message>
    <message>
        <source>Whether each point was executed is not known: the program or a part of the trace is missing.</source>
        <translation>Non si sa se ogni punto è stato eseguito: manca il programma o una parte della misura.</translation>
    </message>
    <message>
        <source>The recording was cut off before the end of the run. What it holds is judged here.</source>
        <translation>La registrazione si interrompe prima della fine dell’esecuzione. Qui è valutato ciò che contiene.</translation>
    </message>
    <message>
        <source>The motion leaves the program for good before line %1, at X %2 Y %3 Z %4.</source>
        <translation>Il movimento lascia definitivamente il programma prima della riga %1, in X %2 Y %3 Z %4.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Esecuzione</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Misura</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Impostazioni</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Risultato</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimento</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Client and control</source>
        <translation>Client e controllo</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Data, nome, firma</translation>
    </message>
    <message>
        <source>File %1, SHA-256 %2</source>
        <translation>File %1, SHA-256 %2</translation>
    </message>
    <message>
        <source>Rivulet %1</source>
        <translation>Rivulet %1</translation>
    </message>
    <message>
        <source>Rivulet %1; run made with version %2</source>
        <translation>Rivulet %1; esecuzione fatta con la versione %2</translation>
    </message>
    <message>
        <source>Program grey, motion blue</source>
        <translation>Programma grigio, moto blu</translation>
    </message>
    <message>
        <source>The trace holds no motion.</source>
        <translation>La misura non contiene alcun movimento.</translation>
    </message>
    <message>
        <source>Path speed; stops are orange</source>
        <translation>Velocità sul percorso; fermate in arancione</translation>
    </message>
    <message>
        <source>Duration of requests: median blue, longest orange</source>
        <translation>Durata delle richieste: mediana blu, la più lunga arancione</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Tempo, s</translation>
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
        <translation>Le più lunghe di %1 fermate</translation>
    </message>
    <message>
        <source>At</source>
        <translation>A</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durata</translation>
    </message>
    <message>
        <source>Place, mm</source>
        <translation>Luogo, mm</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Riga</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Causa</translation>
    </message>
    <message>
        <source>What limited the run: the client. The machine waited %1 times for its data, %2 in all.</source>
        <translation>Che cosa ha limitato l’esecuzione: il client. La macchina ha atteso %1 volte i suoi dati, %2 in tutto.</translation>
    </message>
    <message>
        <source>What limited the run: the access time. At %1 the client is slower than the machine; up to %2 it keeps up.</source>
        <translation>Che cosa ha limitato l’esecuzione: il tempo di accesso. A %1 il client è più lento della macchina; fino a %2 tiene il passo.</translation>
    </message>
    <message>
        <source>What limited the run: the stops between loops or windows, %1 in all.</source>
        <translation>Che cosa ha limitato l’esecuzione: le fermate tra loop o finestre, %1 in tutto.</translation>
    </message>
    <message>
        <source>What limited the run: the machine, by braking and accelerating, not the client.</source>
        <translation>Che cosa ha limitato l’esecuzione: la macchina, frenando e accelerando, non il client.</translation>
    </message>
    <message>
        <source>With N = %1, feeds up to %2 would have been possible.</source>
        <translation>Con N = %1 sarebbero stati possibili avanzamenti fino a %2.</translation>
    </message>
    <message>
        <source>With arrays that cost as much as one variable, feeds up to %1 would have been possible.</source>
        <translation>Con array che costano quanto una variabile sarebbero stati possibili avanzamenti fino a %1.</translation>
    </message>
    <message>
        <source>Without another change, %1 is the largest feed at which the machine does not wait.</source>
        <translation>Senza altre modifiche, %1 è l’avanzamento massimo al quale la macchina non attende.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Tipo di file</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Campioni</translation>
    </message>
    <message>
        <source>Time between two samples</source>
        <translation>Tempo tra due campioni</translation>
    </message>
    <message>
        <source>Version (hash)</source>
        <translation>Versione (hash)</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Avvio</translation>
    </message>
    <message>
        <source>Started by</source>
        <translation>Avviata da</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>Numero di esecuzione</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Assi</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Layout</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non valutato</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Eseguito</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Ripetuti</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Saltati</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Fuori dal programma</translation>
    </message>
    <message>
        <source>Out of order</source>
        <translation>Fuori ordine</translation>
    </message>
    <message>
        <source>Not decided by the samples</source>
        <translation>Non deciso dalla misura</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1 alla riga %2</translation>
    </message>
    <message>
        <source>Contour error, set point</source>
        <translation>Errore di contorno, riferimento</translation>
    </message>
    <message>
        <source>Contour error, actual</source>
        <translation>Errore di contorno, reale</translation>
    </message>
    <message>
        <source>Following error XYZ</source>
        <translation>Inseguimento XYZ</translation>
    </message>
    <message>
        <source>Reversal error XYZ</source>
        <translation>Inversione XYZ</translation>
    </message>
    <message>
        <source>Strongest vibration</source>
        <translation>Vibrazione più forte</translation>
    </message>
    <message>
        <source>Programmed feed kept</source>
        <translation>Avanzamento programmato tenuto</translation>
    </message>
    <message>
        <source>At the programmed feed</source>
        <translation>All’avanzamento programmato</translation>
    </message>
    <message>
        <source>Lost by moving slower</source>
        <translation>Perso per moto più lento</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Richieste</translation>
    </message>
    <message>
        <source>Machine waited for the client</source>
        <translation>Macchina in attesa del client</translation>
    </message>
    <message>
        <source>%1 times, %2</source>
        <translation>%1 volte, %2</translation>
    </message>
    <message>
        <source>Largest feed without waiting</source>
        <translation>Avanzamento massimo senza attesa</translation>
    </message>
    <message>
        <source>Median, 99 %, longest</source>
        <translation>Mediana, 99&#xa0;%, massima</translation>
    </message>
    <message>
        <source>Requests made again</source>
        <translation>Richieste ripetute</translation>
    </message>
    <message>
        <source>Margin; of the slowest 1 %</source>
        <translation>Margine; dell’1&#xa0;% più lento</translation>
    </message>
    <message>
        <source>Path speed up to %1 mm/min; stops are orange</source>
        <translation>Velocità sul percorso fino a %1 mm/min; fermate in arancione</translation>
    </message>
</context>
<context>
    <name>TracesPage</name>
    <message>
        <source>The file of the pane layouts is damaged. What can be read of it is used, and the file is kept as %1.</source>
        <translation>Il file delle disposizioni dei riquadri è danneggiato. Ciò che è leggibile viene usato e il file è conservato come %1.</translation>
    </message>
    <message>
        <source>A run is in progress. Open files after it has ended.</source>
        <translation>È in corso un’esecuzione. Aprire i file quando sarà terminata.</translation>
    </message>
</context>
<context>
    <name>TrendWords</name>
    <message>
        <source>Trend of the runs</source>
        <translation>Andamento delle esecuzioni</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Esecuzioni</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>Giorni</translation>
    </message>
    <message>
        <source>Access, ms</source>
        <translation>Accesso, ms</translation>
    </message>
    <message>
        <source>Paused, s</source>
        <translation>Pause, s</translation>
    </message>
    <message>
        <source>per run</source>
        <translation>per esecuzione</translation>
    </message>
    <message>
        <source>per day</source>
        <translation>al giorno</translation>
    </message>
    <message>
        <source>Access time per run</source>
        <translation>Tempo di accesso per esecuzione</translation>
    </message>
    <message>
        <source>Mean access time, ms</source>
        <translation>Tempo di accesso medio, ms</translation>
    </message>
    <message>
        <source>Pauses per run</source>
        <translation>Pause per esecuzione</translation>
    </message>
    <message>
        <source>Time in pauses, s</source>
        <translation>Tempo in pausa, s</translation>
    </message>
    <message>
        <source>Run of the machine</source>
        <translation>Esecuzione della macchina</translation>
    </message>
    <message>
        <source>Days since %1</source>
        <comment>a date</comment>
        <translation>Giorni dal %1</translation>
    </message>
    <message>
        <source>%1, trend</source>
        <comment>of a machine</comment>
        <translation>%1, andamento</translation>
    </message>
</context>
<context>
    <name>TrustTexts</name>
    <message>
        <source>Only an engineer can do this.</source>
        <translation>Può farlo solo un attrezzista.</translation>
    </message>
    <message>
        <source>Connect first.</source>
        <translation>Prima connettere.</translation>
    </message>
    <message>
        <source>During a run there is no time for it.</source>
        <translation>Durante un’esecuzione non c’è tempo.</translation>
    </message>
</context>
<context>
    <name>UserTexts</name>
    <message>
        <source>At least one user must be an engineer.</source>
        <translation>Almeno un utente deve essere attrezzista.</translation>
    </message>
    <message>
        <source>The file of users is damaged. Restore it, or delete it to set the users up again.</source>
        <translation>Il file degli utenti è danneggiato. Ripristinarlo, oppure eliminarlo e configurare di nuovo gli utenti.</translation>
    </message>
    <message>
        <source>Give a name.</source>
        <translation>Indicare un nome.</translation>
    </message>
    <message>
        <source>The PIN needs at least 4 characters.</source>
        <translation>Il PIN deve avere almeno 4 caratteri.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Alarms</name>
    <message>
        <source>%1: %2 damaged lines of the history of alarms were left out.</source>
        <translation>%1: omesse %2 righe danneggiate dello storico degli allarmi.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Certificates</name>
    <message>
        <source>Saved %1.</source>
        <translation>%1 salvato.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Demo</name>
    <message>
        <source>The picture or the report cannot be written to %1.</source>
        <translation>Impossibile scrivere l’immagine o il rapporto in %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Document</name>
    <message>
        <source>Line %1</source>
        <translation>Riga %1</translation>
    </message>
    <message>
        <source>A dry run needs the whole job, but only the motion of this program would be streamed. Choose Whole job.</source>
        <translation>Solo un lavoro completo gira a vuoto, e questo programma è solo movimento. Scegliere Lavoro completo.</translation>
    </message>
    <message>
        <source>A dry run needs the whole job: choose method window or credit, and no online correction.</source>
        <translation>Una prova a vuoto richiede il lavoro completo: scegliere il metodo Finestra o Credito, senza correzione in linea.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::FoundRuns</name>
    <message>
        <source>The run that was watched has ended.</source>
        <translation>L’esecuzione osservata è terminata.</translation>
    </message>
    <message>
        <source>There is a run on the control: %1</source>
        <translation>C’è un’esecuzione sul controllo: %1</translation>
    </message>
    <message>
        <source>The run has been stopped; confirmed after %1.</source>
        <translation>L’esecuzione è stata arrestata; confermato dopo %1.</translation>
    </message>
    <message>
        <source>Stop of the run on the control requested.</source>
        <translation>Richiesto lo stop dell’esecuzione sul controllo.</translation>
    </message>
    <message>
        <source>The file of the program, %1, cannot be found. Open the program, then try again.</source>
        <translation>Il file del programma, %1, non si trova. Aprire il programma, poi riprovare.</translation>
    </message>
    <message>
        <source>This run was a whole job, and its program cannot be run as one here now. The command rivulet-cli job --resume goes on with it.</source>
        <translation>Questa esecuzione era un lavoro completo e il suo programma non può essere eseguito come tale qui adesso. Il comando rivulet-cli job --resume lo continua.</translation>
    </message>
    <message>
        <source>The axes of the run on the control are held; they stood after %1.</source>
        <translation>Gli assi dell’esecuzione sul controllo sono trattenuti; si sono fermati dopo %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::LiveSource</name>
    <message>
        <source>A run is in progress. Open a live source after it has ended.</source>
        <translation>Un’esecuzione è in corso. Aprire una sorgente in diretta quando sarà finita.</translation>
    </message>
    <message>
        <source>Listening for live points on %1.</source>
        <translation>Punti in diretta attesi su %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MachineModel</name>
    <message>
        <source>Connected to the virtual machine at %1.</source>
        <translation>Connesso alla macchina virtuale su %1.</translation>
    </message>
    <message>
        <source>Connected to the control at %1.</source>
        <translation>Connesso al controllo su %1.</translation>
    </message>
    <message>
        <source>Calibrated. Saved %1.</source>
        <translation>Calibrato. %1 salvato.</translation>
    </message>
    <message>
        <source>The calibration belongs to another version of the server and is not used.</source>
        <translation>La calibrazione appartiene a un’altra versione del server e non viene usata.</translation>
    </message>
    <message>
        <source>The map %1 does not name: %2. What needs it does not work.</source>
        <translation>La mappa %1 non nomina: %2. Ciò che ne ha bisogno non funziona.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MachineProfiles</name>
    <message>
        <source>The limits of %1 have been saved.</source>
        <translation>I limiti di %1 sono stati salvati.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MainWindow</name>
    <message>
        <source>About Rivulet</source>
        <translation>Informazioni su Rivulet</translation>
    </message>
    <message>
        <source>Rivulet %1
Streams a tool path to a CNC machine over OPC UA while the machine moves.

Stop ends the program at the end of its loop. It is not an emergency stop.

GPL-3.0-or-later</source>
        <translation>Rivulet %1
Trasmette un percorso utensile a una macchina CNC via OPC UA mentre la macchina si muove.

Stop termina il programma alla fine del suo loop. Non è un arresto d’emergenza.

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
        <translation>&amp;Apri programma…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Esci</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Lingua</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Chiaro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Scuro</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Come il sistema</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Guida</translation>
    </message>
    <message>
        <source>&amp;About Rivulet</source>
        <translation>I&amp;nformazioni su Rivulet</translation>
    </message>
    <message>
        <source>Method, feed and verdict</source>
        <translation>Metodo, avanzamento ed esito</translation>
    </message>
    <message>
        <source>&amp;Menu</source>
        <translation>&amp;Menu</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contrasto elevato</translation>
    </message>
    <message>
        <source>Li&amp;ve points …</source>
        <translation>Punti in &amp;diretta…</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Lavoro</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Analisi</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>Preparare</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>Imposta&amp;zioni</translation>
    </message>
    <message>
        <source>La&amp;rge view</source>
        <translation>Vista g&amp;rande</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::PastRuns</name>
    <message>
        <source>A run is in progress: the Traces page shows it until it has ended.</source>
        <translation>Un’esecuzione è in corso: la pagina Curve la mostra finché non è finita.</translation>
    </message>
    <message>
        <source>A run is in progress. Open another program after it has ended.</source>
        <translation>Un’esecuzione è in corso. Aprire un altro programma quando sarà terminata.</translation>
    </message>
    <message>
        <source>The settings of the run have been taken over. Where its program was is not known: open the program with version %1.</source>
        <translation>Le impostazioni dell’esecuzione sono riprese. Non indica dove fosse il programma: aprire il programma con versione %1.</translation>
    </message>
    <message>
        <source>%1 is not the program of that run: version %2 then, %3 now. Its settings are set. Check the path before you start.</source>
        <translation>%1 non è il programma di quell’esecuzione: versione %2 allora, %3 adesso. Le sue impostazioni sono riprese. Controllare il percorso prima di avviare.</translation>
    </message>
    <message>
        <source>Program and settings are those of the run of %1. Nothing has started.</source>
        <translation>Programma e impostazioni sono quelli dell’esecuzione del %1. Nulla è stato avviato.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::PipelineRun</name>
    <message>
        <source>The program rivulet-cnc is missing. Install it beside this window.</source>
        <translation>Manca il programma rivulet-cnc. Installarlo accanto a questa finestra.</translation>
    </message>
    <message>
        <source>The tasks have ended without a message. Execute the program again.</source>
        <translation>I compiti sono finiti senza messaggi. Eseguire di nuovo il programma.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Preflight</name>
    <message>
        <source>In the way</source>
        <translation>Impedimento</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>%1 has changed on disk since version %2 was read.</source>
        <translation>%1 è cambiato sul disco da quando è stata letta la versione %2.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Ricarica</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Non connesso</translation>
    </message>
    <message>
        <source>%1: a virtual machine, no real axis moves</source>
        <translation>%1: una macchina virtuale, nessun asse reale si muove</translation>
    </message>
    <message>
        <source>%1: the axes of this machine will move</source>
        <translation>%1: gli assi di questa macchina si muoveranno</translation>
    </message>
    <message>
        <source>First move</source>
        <translation>Primo movimento</translation>
    </message>
    <message>
        <source>The position of the tool is not known.</source>
        <translation>La posizione dell’utensile non è nota.</translation>
    </message>
    <message>
        <source>From %1 in a straight line over %2 to point 1 at %3</source>
        <translation>Da %1 in linea retta per %2 fino al punto 1 in %3</translation>
    </message>
    <message>
        <source>The last run was left at %1 of %2 points. This start does not go on there: it moves from where the tool stands, perhaps in the cut, to the first point.</source>
        <translation>L’ultima esecuzione si è interrotta a %1 punti su %2. Questo avvio non continua da lì: va da dove si trova l’utensile, forse nel taglio, al primo punto.</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>%1 for every block, set here</source>
        <translation>%1 per ogni blocco, impostato qui</translation>
    </message>
    <message>
        <source>%1. The program names no feed.</source>
        <translation>%1. Il programma non indica alcun avanzamento.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>%1. The program&apos;s own feed, %2, is not used.</source>
        <translation>%1. L’avanzamento del programma, %2, non viene usato.</translation>
    </message>
    <message>
        <source>Some blocks will be cut %1 times as fast as programmed.</source>
        <translation>Alcuni blocchi saranno lavorati %1 volte più veloci del programmato.</translation>
    </message>
    <message>
        <source>Use F = %1</source>
        <translation>Usa F = %1</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Esito</translation>
    </message>
    <message>
        <source>There is no verdict.</source>
        <translation>Nessun esito.</translation>
    </message>
    <message>
        <source>Safe, but the machine will wait for points. Largest feed without waiting: %1.</source>
        <translation>Sicuro, ma la macchina attenderà i punti. Avanzamento massimo senza attese: %1.</translation>
    </message>
    <message>
        <source>Margin %1 ×, largest feed %2</source>
        <translation>Margine %1 ×, avanzamento massimo %2</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accesso</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulazione</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Approvazione</translation>
    </message>
    <message>
        <source>Released by %1 on %2, who starts: %3</source>
        <translation>Approvato da %1 il %2, avvia: %3</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Revoca</translation>
    </message>
    <message>
        <source>This program with these settings and this calibration is not released.</source>
        <translation>Questo programma con queste impostazioni e questa calibrazione non è approvato.</translation>
    </message>
    <message>
        <source>point %1 of %2 at %3</source>
        <translation>punto %1 di %2 in %3</translation>
    </message>
    <message>
        <source>From point %1 on, the program differs from that of the interrupted run.</source>
        <translation>Dal punto %1 il programma è diverso da quello dell’esecuzione interrotta.</translation>
    </message>
    <message>
        <source>Who starts</source>
        <translation>Chi avvia</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 su %2</translation>
    </message>
    <message>
        <source>The feeds of the program at %1. It names none.</source>
        <translation>Gli avanzamenti del programma al %1. Non ne indica alcuno.</translation>
    </message>
    <message>
        <source>That of the program, %1, at %2</source>
        <translation>Quello del programma, %1, al %2</translation>
    </message>
    <message>
        <source>Those of the program, %1 to %2, at %3; each block its own</source>
        <translation>Quelli del programma, da %1 a %2, al %3; ogni blocco il suo</translation>
    </message>
    <message>
        <source>Rapids at %1 at most</source>
        <translation>Rapidi al massimo a %1</translation>
    </message>
    <message>
        <source>Blocks will be cut faster than programmed.</source>
        <translation>Alcuni blocchi saranno lavorati più veloci del programmato.</translation>
    </message>
    <message>
        <source>Use 100 %</source>
        <translation>Usa 100&#xa0;%</translation>
    </message>
    <message>
        <source>%1 for every block: this method has one feed, as it was published</source>
        <translation>%1 per ogni blocco: questo metodo ha un solo avanzamento, come pubblicato</translation>
    </message>
    <message>
        <source>Use the feeds of the program</source>
        <translation>Usa gli avanzamenti del programma</translation>
    </message>
    <message>
        <source>Safe, but the machine will wait for points. Largest override without waiting: %1.</source>
        <translation>Sicuro, ma la macchina attenderà i punti. Override massimo senza attese: %1.</translation>
    </message>
    <message>
        <source>Margin %1 ×, largest override %2</source>
        <translation>Margine %1 ×, override massimo %2</translation>
    </message>
    <message>
        <source>%1 (line %2)</source>
        <translation>%1 (riga %2)</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 e altri %2</translation>
    </message>
    <message>
        <source>Whole job</source>
        <translation>Lavoro completo</translation>
    </message>
    <message>
        <source>Motion only</source>
        <translation>Solo movimento</translation>
    </message>
    <message>
        <source>Set tool, spindle and coolant at the control.</source>
        <translation>Impostare utensile, mandrino e refrigerante sul controllo.</translation>
    </message>
    <message>
        <source>Run the whole job</source>
        <translation>Eseguire il lavoro completo</translation>
    </message>
    <message>
        <source>First the control executes line %1: %2. Then the tool moves from where it stands to the first point of part 1.</source>
        <translation>Prima il controllo esegue la riga %1: %2. Poi l’utensile va da dove si trova al primo punto del tratto 1.</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Corsa</translation>
    </message>
    <message>
        <source>Not checked: nobody has entered the limits of this machine.</source>
        <translation>Non controllato: nessuno ha inserito i limiti di questa macchina.</translation>
    </message>
    <message>
        <source>Enter …</source>
        <translation>Inserisci…</translation>
    </message>
    <message>
        <source>%1 needs %2, the machine has %3</source>
        <translation>%1 richiede %2, la macchina ha %3</translation>
    </message>
    <message>
        <source>The path is longer than the travel: %1.</source>
        <translation>Il percorso è più lungo della corsa: %1.</translation>
    </message>
    <message>
        <source>The path (%1 mm) is not longer than the travel of the axes. Where the workpiece lies is not known to Rivulet.</source>
        <translation>Il percorso (%1 mm) non è più lungo della corsa degli assi. Rivulet non sa dove si trova il pezzo.</translation>
    </message>
    <message>
        <source>Travel, spindle and tools</source>
        <translation>Corse, mandrino e utensili</translation>
    </message>
    <message>
        <source>The job is being compared with the machine.</source>
        <translation>Il lavoro viene confrontato con la macchina.</translation>
    </message>
    <message>
        <source>Every block is within the travel of the axes, the speed of the spindle and the tool table.</source>
        <translation>Tutti i blocchi rientrano nelle corse degli assi, nella velocità del mandrino e nella tabella utensili.</translation>
    </message>
    <message numerus="yes">
        <source>%1, version %2, %Ln points</source>
        <translation>
            <numerusform>%1, versione %2, %Ln punto</numerusform>
            <numerusform>%1, versione %2, %Ln punti</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Streamed: %1; the control executes %Ln blocks: %2</source>
        <translation>
            <numerusform>Trasmissione in continuo: %1; il controllo esegue %Ln blocco: %2</numerusform>
            <numerusform>Trasmissione in continuo: %1; il controllo esegue %Ln blocchi: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln tratto</numerusform>
            <numerusform>%Ln tratti</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln blocks are left out: %1</source>
        <translation>
            <numerusform>%Ln blocco è omesso: %1</numerusform>
            <numerusform>%Ln blocchi sono omessi: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line over %1 to %2. %Ln points have been executed.</source>
        <translation>
            <numerusform>In linea retta per %1 fino a %2. Eseguito %Ln punto.</numerusform>
            <numerusform>In linea retta per %1 fino a %2. Eseguiti %Ln punti.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line to %1. %Ln points have been executed.</source>
        <translation>
            <numerusform>In linea retta fino a %1. Eseguito %Ln punto.</numerusform>
            <numerusform>In linea retta fino a %1. Eseguiti %Ln punti.</numerusform>
        </translation>
    </message>
    <message>
        <source>as a rapid, %1</source>
        <translation>in rapido, %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>a %1</translation>
    </message>
    <message>
        <source>From where the tool stands in a straight line over %1, %2, to where line %3 begins: %4.</source>
        <translation>Da dove si trova l’utensile in linea retta per %1, %2, fino all’inizio della riga %3: %4.</translation>
    </message>
    <message>
        <source>From where the tool stands in a straight line, %1, to where line %2 begins: %3.</source>
        <translation>Da dove si trova l’utensile in linea retta, %1, fino all’inizio della riga %2: %3.</translation>
    </message>
    <message numerus="yes">
        <source>The %Ln points before it are not executed.</source>
        <translation>
            <numerusform>Il %Ln punto precedente non viene eseguito.</numerusform>
            <numerusform>I %Ln punti precedenti non vengono eseguiti.</numerusform>
        </translation>
    </message>
    <message>
        <source>Feeds are those that the program has commanded up to each line, and the work offset is the one that is active at the control.</source>
        <translation>Valgono gli avanzamenti che il programma ha comandato fino a ogni riga, e lo spostamento origine attivo sul controllo.</translation>
    </message>
    <message>
        <source>State at this line</source>
        <translation>Stato a questa riga</translation>
    </message>
    <message>
        <source>Left out before this line, the last one first: %1. Set at the control what holds here.</source>
        <translation>Omessi prima di questa riga, l’ultimo per primo: %1. Impostare sul controllo ciò che vale qui.</translation>
    </message>
    <message>
        <source>Begin with a part …</source>
        <translation>Iniziare da un tratto …</translation>
    </message>
    <message>
        <source>First the control executes</source>
        <translation>Prima il controllo esegue</translation>
    </message>
    <message>
        <source>Then the job goes on in part %1 at point %2 of %3 (line %4).</source>
        <translation>Poi il lavoro continua nel tratto %1 al punto %2 di %3 (riga %4).</translation>
    </message>
    <message>
        <source>Then the job goes on at line %1: %2</source>
        <translation>Poi il lavoro continua alla riga %1: %2</translation>
    </message>
    <message>
        <source>Not done again, because only the control knows their effect: %1</source>
        <translation>Non rieseguiti, perché solo il controllo ne conosce l’effetto: %1</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Prova a vuoto</translation>
    </message>
    <message>
        <source>Everything takes place %1 higher than programmed. The spindle does not turn, and no coolant flows; tools are changed, and retracts in machine coordinates are made.</source>
        <translation>Tutto avviene %1 più in alto del programmato. Il mandrino non gira e il refrigerante resta chiuso; gli utensili vengono cambiati e gli svincoli in coordinate macchina eseguiti.</translation>
    </message>
    <message>
        <source>Live source</source>
        <translation>Sorgente in diretta</translation>
    </message>
    <message>
        <source>Change …</source>
        <translation>Modifica…</translation>
    </message>
    <message>
        <source>%1 is open. What it sends is read from the start on.</source>
        <translation>%1 è aperta. Quello che invia viene letto dall’avvio in poi.</translation>
    </message>
    <message>
        <source>Agreed</source>
        <translation>Concordato</translation>
    </message>
    <message>
        <source>No point is outside %1. No step is longer than %2. Anything else ends the run after the last good point.</source>
        <translation>Nessun punto è fuori da %1. Nessun passo è più lungo di %2. Tutto il resto termina l’esecuzione dopo l’ultimo punto buono.</translation>
    </message>
    <message>
        <source>The F of the points, at most %1; that is also the feed before the first F.</source>
        <translation>L’F dei punti, al massimo %1; è anche l’avanzamento prima del primo F.</translation>
    </message>
    <message>
        <source>No points</source>
        <translation>Senza punti</translation>
    </message>
    <message>
        <source>The machine waits at the end of the last window: %1.</source>
        <translation>La macchina attende alla fine dell’ultima finestra: %1.</translation>
    </message>
    <message>
        <source>From %1 in a straight line to the first point, which may be %2 away.</source>
        <translation>Da %1 in linea retta al primo punto, che può distare %2.</translation>
    </message>
    <message>
        <source>The tool is so far outside the box that no first point can be in it. Move the tool, or change the box.</source>
        <translation>L’utensile è così lontano dal volume che nessun primo punto può trovarsi dentro. Spostare l’utensile o modificare il volume.</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Letto come</translation>
    </message>
    <message>
        <source>a program for %1</source>
        <translation>un programma per %1</translation>
    </message>
    <message>
        <source>mm, because this machine is metric; the program does not say (%1)</source>
        <translation>mm, perché questa macchina è metrica; il programma non lo dice (%1)</translation>
    </message>
    <message>
        <source>inch where the program does not say it, as chosen</source>
        <translation>pollici dove il programma non lo dice, come scelto</translation>
    </message>
    <message>
        <source>mm where the program does not say it, as chosen</source>
        <translation>mm dove il programma non lo dice, come scelto</translation>
    </message>
    <message>
        <source>whole units where a number has no decimal point (%1)</source>
        <translation>unità intere dove un numero non ha il punto decimale (%1)</translation>
    </message>
    <message>
        <source>thousandths where a number has no decimal point, as chosen</source>
        <translation>millesimi dove un numero non ha il punto decimale, come scelto</translation>
    </message>
    <message>
        <source>whole units where a number has no decimal point, as chosen</source>
        <translation>unità intere dove un numero non ha il punto decimale, come scelto</translation>
    </message>
    <message>
        <source>%1: the control executes %2</source>
        <translation>%1: il controllo esegue %2</translation>
    </message>
    <message>
        <source>%1: left out, because nobody has said what this machine does for it (Configure, Limits)</source>
        <translation>%1: omessa, perché nessuno ha detto che cosa fa questa macchina per essa (Configura, Limiti)</translation>
    </message>
    <message>
        <source>%1: left out</source>
        <translation>%1: omessa</translation>
    </message>
    <message>
        <source>without %1, which does not change the path, as confirmed</source>
        <translation>senza %1, che non cambia il percorso, come confermato</translation>
    </message>
    <message>
        <source>what it leaves out as a virtual machine is set (%1)</source>
        <translation>ciò che omette secondo le impostazioni di una macchina virtuale (%1)</translation>
    </message>
    <message>
        <source>what it leaves out as chosen (%1)</source>
        <translation>ciò che omette come scelto (%1)</translation>
    </message>
    <message>
        <source>M functions and axes of another machine</source>
        <translation>Funzioni M e assi di un’altra macchina</translation>
    </message>
    <message numerus="yes">
        <source>%1 (line %2, %Ln times)</source>
        <translation>
            <numerusform>%1 (riga %2, una volta)</numerusform>
            <numerusform>%1 (riga %2, %Ln volte)</numerusform>
        </translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>The axes stand at once, on the path. How long they brake is not known.</source>
        <translation>Gli assi si fermano subito, sulla traiettoria. Non si sa per quanto tempo frenano.</translation>
    </message>
    <message>
        <source>The axes stand on the path within %1; threads and tapping at their end.</source>
        <translation>Gli assi si fermano sulla traiettoria entro %1; filettature e maschiature alla loro fine.</translation>
    </message>
    <message>
        <source>Every block is within the travel of the axes and the speed of the spindle. Tools are not compared: this machine has no tool table here.</source>
        <translation>Ogni blocco è entro la corsa degli assi e la velocità del mandrino. Gli utensili non vengono confrontati: per questa macchina qui non c’è una tabella utensili.</translation>
    </message>
    <message>
        <source>The program uses tool %1; there is none in the spindle.</source>
        <translation>Il programma usa l’utensile %1; nel mandrino non ce n’è nessuno.</translation>
    </message>
    <message>
        <source>The program uses tool %1; %2 is in the spindle.</source>
        <translation>Il programma usa l’utensile %1; nel mandrino c’è %2.</translation>
    </message>
    <message>
        <source>The program works in %1; %2 is active.</source>
        <translation>Il programma lavora in %1; è attivo %2.</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>è fermo</translation>
    </message>
    <message>
        <source>turns at %1 1/min, %2</source>
        <translation>gira a %1 giri/min, %2</translation>
    </message>
    <message>
        <source>clockwise (M3)</source>
        <translation>orario (M3)</translation>
    </message>
    <message>
        <source>counterclockwise (M4)</source>
        <translation>antiorario (M4)</translation>
    </message>
    <message>
        <source>In the program the spindle %1; now it %2.</source>
        <translation>Nel programma il mandrino %1; ora %2.</translation>
    </message>
    <message>
        <source>Confirmed: it starts like this.</source>
        <translation>Confermato: si avvia così.</translation>
    </message>
    <message>
        <source>Start like this</source>
        <translation>Avvia così</translation>
    </message>
    <message>
        <source>Then in a straight line over %1 to %2.</source>
        <translation>Poi in linea retta per %1 fino a %2.</translation>
    </message>
    <message>
        <source>This way passes within what the program cuts, which reaches up to Z %1.</source>
        <translation>Questa via passa nella zona che il programma lavora, che arriva fino a Z %1.</translation>
    </message>
    <message>
        <source>Raise the tool …</source>
        <translation>Solleva l&apos;utensile …</translation>
    </message>
    <message>
        <source>Bring the tool to a place from which it is clear.</source>
        <translation>Portare l&apos;utensile in un punto da cui sia libera.</translation>
    </message>
    <message>
        <source>Straight way</source>
        <translation>Via diretta</translation>
    </message>
    <message>
        <source>Confirmed: nothing is in the way of the first move.</source>
        <translation>Confermato: nulla ostacola il primo movimento.</translation>
    </message>
    <message>
        <source>If nothing is in the way of the first move, confirm it.</source>
        <translation>Se nulla ostacola il primo movimento, confermarlo.</translation>
    </message>
    <message>
        <source>It is clear …</source>
        <translation>È libera …</translation>
    </message>
    <message>
        <source>Raise the tool</source>
        <translation>Sollevare l&apos;utensile</translation>
    </message>
    <message>
        <source>The tool goes straight up by %1 to Z %2, at %3. Nothing else moves. Then this page comes again.</source>
        <translation>L&apos;utensile sale diritto di %1 fino a Z %2, a %3. Nient&apos;altro si muove. Poi torna questa pagina.</translation>
    </message>
    <message>
        <source>After Stop the control still executes its window, of at most %1 moves within the agreed box, and of at most %2: longer moves are divided.</source>
        <translation>Dopo Stop il controllo esegue ancora la sua finestra: al massimo %1 movimenti entro la scatola concordata, che insieme durano al massimo %2. I movimenti più lunghi vengono divisi.</translation>
    </message>
    <message>
        <source>After Stop the control still executes its window, at most %1 in %2.</source>
        <translation>Dopo Stop il controllo esegue ancora la sua finestra, al massimo %1 in %2.</translation>
    </message>
    <message>
        <source>The move of line %1 alone takes %2; it is not divided.</source>
        <translation>Il movimento della riga %1 da solo dura %2; non viene diviso.</translation>
    </message>
    <message>
        <source>Method %1 may execute old points again: if this computer is late for a moment, the tool goes back through the workpiece, and nothing stops it before it has moved. Method window does not.</source>
        <translation>Il metodo %1 può eseguire di nuovo punti vecchi: se questo computer è in ritardo per un momento, l’utensile torna indietro attraverso il pezzo, e nulla lo ferma prima che si sia mosso. Il metodo Finestra non lo fa.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>Confirmed.</source>
        <translation>Confermato.</translation>
    </message>
    <message>
        <source>Accept it …</source>
        <translation>Accettarlo …</translation>
    </message>
    <message>
        <source>Since it was measured how fast this control can be written to, its software has changed: %1 for each R-parameter are assumed.</source>
        <translation>Da quando è stata misurata la velocità di scrittura di questo controllo, il suo software è cambiato: si assumono %1 per ogni parametro R.</translation>
    </message>
    <message>
        <source>It has not been measured how fast this control can be written to: %1 for each R-parameter are assumed.</source>
        <translation>La velocità di scrittura di questo controllo non è stata misurata: si assumono %1 per ogni parametro R.</translation>
    </message>
    <message>
        <source>Measure …</source>
        <translation>Misura …</translation>
    </message>
    <message>
        <source>Back along the path</source>
        <translation>Indietro lungo il percorso</translation>
    </message>
    <message>
        <source>The tool goes back by %1 along the path that it has cut, at %2, to %3. Then this page comes again, and the run goes on from there.</source>
        <translation>L’utensile torna indietro di %1 lungo il percorso che ha lavorato, a %2, fino a %3. Poi questa pagina ritorna e l’esecuzione prosegue da lì.</translation>
    </message>
    <message>
        <source>Drive back …</source>
        <translation>Torna indietro …</translation>
    </message>
    <message>
        <source>The first move, to line %1, alone takes %2: bring the tool nearer before the start.</source>
        <translation>Il primo movimento, fino alla riga %1, dura da solo %2: avvicinare l’utensile prima dell’avvio.</translation>
    </message>
    <message>
        <source>%1 multiplies your override: %2 to %3, and no more than 120 % in all.</source>
        <translation>%1 moltiplica il vostro override: da %2 a %3, e in tutto non più del 120&#xa0;%.</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Avanzamento adattivo</translation>
    </message>
    <message>
        <source>Without a factor for %1 the axes are held; nothing moves before the first.</source>
        <translation>Senza un fattore per %1 gli assi sono trattenuti; prima del primo non si muove nulla.</translation>
    </message>
    <message>
        <source>Without a factor for %1 your override acts alone.</source>
        <translation>Senza un fattore per %1 agisce solo il vostro override.</translation>
    </message>
    <message>
        <source>With this method, after Stop the control still executes its loop, at most %1 in %2.</source>
        <translation>Con questo metodo, dopo Stop il controllo esegue ancora il suo ciclo, al massimo %1 in %2.</translation>
    </message>
    <message>
        <source>Within the tolerance %1 of %2 points are left, at most %3 off the program.</source>
        <translation>Entro la tolleranza restano %1 punti su %2, al massimo a %3 dal programma.</translation>
    </message>
    <message>
        <source>All points are streamed: a whole job has no tolerance.</source>
        <translation>Tutti i punti vengono trasmessi: un lavoro intero non ha tolleranza.</translation>
    </message>
    <message>
        <source>All points are streamed: fewer cannot be kept within the tolerance.</source>
        <translation>Tutti i punti vengono trasmessi: con meno la tolleranza non si può mantenere.</translation>
    </message>
    <message>
        <source>The path is being measured.</source>
        <translation>Il percorso è in corso di misurazione.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::RunController</name>
    <message>
        <source>Stop requested.</source>
        <translation>Stop richiesto.</translation>
    </message>
    <message>
        <source>Continue requested.</source>
        <translation>Ripartenza richiesta.</translation>
    </message>
    <message>
        <source>Calibration on R%1 to R%2 started.</source>
        <translation>Avviata la calibrazione su R%1 … R%2.</translation>
    </message>
    <message>
        <source>The run was left before point %1 of %2.</source>
        <translation>L’esecuzione si è interrotta prima del punto %1 di %2.</translation>
    </message>
    <message>
        <source>Press Resume first: it asks the control where the run was left.</source>
        <translation>Premere prima Riprendi: così si chiede al controllo dove l’esecuzione si è interrotta.</translation>
    </message>
    <message>
        <source>The run resumes at point %1.</source>
        <translation>L’esecuzione riprende dal punto %1.</translation>
    </message>
    <message>
        <source>Start. The tool first moves %1 in a straight line to the first point.</source>
        <translation>Avvio. L’utensile percorre prima %1 in linea retta fino al primo punto.</translation>
    </message>
    <message>
        <source>Save the template on its page as %1, copy it to the part programs of the control, select it in channel 1 and press cycle start. The axes move only after the template has shown its layout number %2.</source>
        <translation>Salvare il modello dalla sua pagina come %1, copiarlo nei programmi pezzo del controllo, selezionarlo nel canale 1 e premere Start NC. Gli assi si muovono solo dopo che il modello ha mostrato il suo numero di layout %2.</translation>
    </message>
    <message>
        <source>Access: %1.</source>
        <translation>Accesso: %1.</translation>
    </message>
    <message>
        <source>Run ended: %1 of %2 points executed.</source>
        <translation>Esecuzione terminata: eseguiti %1 punti su %2.</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Registrazione: %1</translation>
    </message>
    <message>
        <source>The run has executed wrong points: see the report, and check the workpiece.</source>
        <translation>L’esecuzione ha eseguito punti errati: vedi il rapporto e controllare il pezzo.</translation>
    </message>
    <message>
        <source>The run is not in the history: %1</source>
        <translation>L’esecuzione non è nello storico: %1</translation>
    </message>
    <message>
        <source>Wrong motion: after point %1 the tool is %2 off the path.</source>
        <translation>Movimento errato: dopo il punto %1 l’utensile è a %2 dal percorso.</translation>
    </message>
    <message>
        <source>Wrong motion: the control has repeated points after point %1.</source>
        <translation>Movimento errato: il controllo ha ripetuto dei punti dopo il punto %1.</translation>
    </message>
    <message>
        <source>The program waits for cycle start at the control (line %1).</source>
        <translation>Il programma attende Start NC sul controllo (riga %1).</translation>
    </message>
    <message numerus="yes">
        <source>Start of a whole job: %1, %Ln blocks for the control.</source>
        <translation>
            <numerusform>Avvio di un lavoro completo: %1, %Ln blocco per il controllo.</numerusform>
            <numerusform>Avvio di un lavoro completo: %1, %Ln blocchi per il controllo.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln tratto</numerusform>
            <numerusform>%Ln tratti</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 and those after it move nothing. Choose an earlier line.</source>
        <translation>La riga %1 e quelle successive non muovono nulla. Scegliere una riga precedente.</translation>
    </message>
    <message>
        <source>The run starts at point %1.</source>
        <translation>L’esecuzione comincia dal punto %1.</translation>
    </message>
    <message>
        <source>A whole job begins at its beginning, or with a part: press Start, then Begin with a part. To begin at this line, choose Motion only in the settings, and set tool, spindle and coolant yourself.</source>
        <translation>Un lavoro completo inizia dal suo inizio o da un tratto: premere Inizio, poi Iniziare da un tratto. Per iniziare da questa riga, scegliere Solo movimento nelle impostazioni e impostare da sé utensile, mandrino e refrigerante.</translation>
    </message>
    <message numerus="yes">
        <source>The job goes on at line %1, after %Ln blocks of the control.</source>
        <translation>
            <numerusform>Il lavoro continua alla riga %1, dopo %Ln blocco del controllo.</numerusform>
            <numerusform>Il lavoro continua alla riga %1, dopo %Ln blocchi del controllo.</numerusform>
        </translation>
    </message>
    <message>
        <source>The tools and offsets of this machine are not known, so the state in which the job goes on cannot be computed. Start from the beginning.</source>
        <translation>Gli utensili e gli spostamenti di questa macchina non sono noti, quindi lo stato in cui il lavoro continua non può essere calcolato. Ricominciare dall’inizio.</translation>
    </message>
    <message>
        <source>The state before this part is not known: only the control knows what an earlier block does. Choose an earlier part, or start from the beginning.</source>
        <translation>Lo stato prima di questo tratto non è noto: solo il controllo sa che cosa fa un blocco precedente. Scegliere un tratto precedente o ricominciare dall’inizio.</translation>
    </message>
    <message>
        <source>It is not known for certain where the job was left. Press Start, then Begin with a part, or start from the beginning.</source>
        <translation>Non è certo dove il lavoro sia stato interrotto. Premere Inizio, poi Iniziare da un tratto, oppure ricominciare dall’inizio.</translation>
    </message>
    <message>
        <source>Start. The points come from %1.</source>
        <translation>Avvio. I punti arrivano da %1.</translation>
    </message>
    <message>
        <source>Rivulet cannot stop what the control executes now. Press NC STOP at the machine.</source>
        <translation>Rivulet non può fermare ciò che il controllo esegue ora. Premere NC STOP sulla macchina.</translation>
    </message>
    <message>
        <source>Stop: the axes are held on the path.</source>
        <translation>Stop: gli assi sono trattenuti sul percorso.</translation>
    </message>
    <message>
        <source>Pause requested.</source>
        <translation>Pausa richiesta.</translation>
    </message>
    <message>
        <source>The tool is raised to Z %1.</source>
        <translation>L&apos;utensile viene sollevato a Z %1.</translation>
    </message>
    <message>
        <source>The state before the first part is not known: only the control knows what an earlier block does. Start from the beginning.</source>
        <translation>Lo stato prima del primo tratto non è noto: solo il controllo sa che cosa fa un blocco precedente. Ricominciare dall’inizio.</translation>
    </message>
    <message>
        <source>The test of the control is aborted. If an axis still moves, press NC STOP at the machine.</source>
        <translation>Il test del controllo è interrotto. Se un asse si muove ancora, premere NC STOP sulla macchina.</translation>
    </message>
    <message>
        <source>The control was reset: its program has ended after %1.</source>
        <translation>Il controllo è stato resettato: il suo programma è terminato dopo %1.</translation>
    </message>
    <message>
        <source>A reset of the control was requested. If an axis still moves, press NC STOP at the machine.</source>
        <translation>È stato richiesto un reset del controllo. Se un asse si muove ancora, premere NC STOP sulla macchina.</translation>
    </message>
    <message>
        <source>The file of the run is gone: the run could not go on after the way back.</source>
        <translation>Il file dell’esecuzione non c’è più: dopo il ritorno l’esecuzione non potrebbe proseguire.</translation>
    </message>
    <message>
        <source>The tool is driven back by %1 along the path.</source>
        <translation>L’utensile torna indietro di %1 lungo il percorso.</translation>
    </message>
    <message>
        <source>The tool is to be lifted by %1.</source>
        <translation>L’utensile deve essere sollevato di %1.</translation>
    </message>
    <message>
        <source>The tool is to be lowered.</source>
        <translation>L’utensile deve essere riabbassato.</translation>
    </message>
    <message>
        <source>Line %1: &quot;%2&quot; has not been tried on this machine. Test it on the page Job test, or run the motion only.</source>
        <translation>Riga %1: «%2» non è stato provato su questa macchina. Provarlo nella pagina Test lavoro, o eseguire solo il movimento.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::VirtualMachine</name>
    <message>
        <source>The virtual machine cannot be started: %1</source>
        <translation>Impossibile avviare la macchina virtuale: %1</translation>
    </message>
    <message>
        <source>The virtual machine has ended.</source>
        <translation>La macchina virtuale è terminata.</translation>
    </message>
    <message>
        <source>The program rivulet-machine is missing. Install it beside this window.</source>
        <translation>Manca il programma rivulet-machine. Installarlo accanto a questa finestra.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AdvicePanel</name>
    <message>
        <source>F %1 instead of %2: still without wrong points</source>
        <translation>F %1 invece di %2: ancora senza punti errati</translation>
    </message>
    <message>
        <source>F %1 instead of %2: without waiting</source>
        <translation>F %1 invece di %2: senza attese</translation>
    </message>
    <message>
        <source>F %1 instead of %2: feasible</source>
        <translation>F %1 invece di %2: fattibile</translation>
    </message>
    <message>
        <source>N %1 instead of %2: largest feed %3</source>
        <translation>N %1 invece di %2: avanzamento massimo %3</translation>
    </message>
    <message>
        <source>δ %1 instead of %2: largest feed %3</source>
        <translation>δ %1 invece di %2: avanzamento massimo %3</translation>
    </message>
    <message>
        <source>Method %1 instead of %2: largest feed %3</source>
        <translation>Metodo %1 invece di %2: avanzamento massimo %3</translation>
    </message>
    <message>
        <source>Judging …</source>
        <translation>Valutazione…</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>Nessun esito</translation>
    </message>
    <message>
        <source>Not feasible: largest feed %1</source>
        <translation>Non fattibile: avanzamento massimo %1</translation>
    </message>
    <message>
        <source>Safe, with waiting above %1</source>
        <translation>Sicuro, con attese oltre %1</translation>
    </message>
    <message>
        <source>By the equations feasible up to %1</source>
        <translation>Secondo le equazioni fattibile fino a %1</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Applica</translation>
    </message>
    <message>
        <source>Looking for better settings …</source>
        <translation>Ricerca di impostazioni migliori…</translation>
    </message>
    <message>
        <source>No single change makes this program much faster.</source>
        <translation>Nessuna singola modifica rende questo programma molto più veloce.</translation>
    </message>
    <message>
        <source>Each was simulated with this program and made no wrong point.</source>
        <translation>Ognuno è stato simulato con questo programma, senza punti errati.</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Consigli</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Prova</translation>
    </message>
    <message>
        <source>Points per loop N</source>
        <translation>Punti per loop N</translation>
    </message>
    <message>
        <source>Distance δ</source>
        <translation>Distanza δ</translation>
    </message>
    <message>
        <source>Feed F</source>
        <translation>Avanzamento F</translation>
    </message>
    <message>
        <source>Override %1 instead of %2: still without wrong points</source>
        <translation>Override %1 invece di %2: ancora senza punti errati</translation>
    </message>
    <message>
        <source>Override %1 instead of %2: without waiting</source>
        <translation>Override %1 invece di %2: senza attese</translation>
    </message>
    <message>
        <source>N %1 instead of %2: largest override %3</source>
        <translation>N %1 invece di %2: override massimo %3</translation>
    </message>
    <message>
        <source>Safe, with waiting above an override of %1</source>
        <translation>Sicuro, con attese oltre un override di %1</translation>
    </message>
    <message>
        <source>By the equations without waiting up to %1</source>
        <translation>Secondo le equazioni senza attese fino a %1</translation>
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
        <translation>Ora</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Evento</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Allarme</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Da</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmLine</name>
    <message>
        <source>Ack</source>
        <translation>Tacita</translation>
    </message>
    <message>
        <source>Acknowledge: you have seen this alarm</source>
        <translation>Tacitare: conferma di aver visto questo allarme</translation>
    </message>
    <message>
        <source>Acknowledge the alarm</source>
        <translation>Tacita l’allarme</translation>
    </message>
    <message>
        <source>Show all alarms</source>
        <translation>Mostra tutti gli allarmi</translation>
    </message>
    <message>
        <source>Dismiss the message</source>
        <translation>Chiudi il messaggio</translation>
    </message>
    <message>
        <source>Alarms: %1. Show all</source>
        <translation>Allarmi: %1. Mostra tutti</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmModel</name>
    <message>
        <source>Alarm</source>
        <translation>Allarme</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stato</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Ora</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Volte</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmPage</name>
    <message>
        <source>There is no alarm.</source>
        <translation>Non ci sono allarmi.</translation>
    </message>
    <message>
        <source>shelved by %1 until %2</source>
        <translation>accantonato da %1 fino alle %2</translation>
    </message>
    <message>
        <source>Alarms (%1)</source>
        <translation>Allarmi (%1)</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Storico</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Causa</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Rimedio</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Tacita</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Tacita tutti</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>Accantona</translation>
    </message>
    <message>
        <source>Put the alarm aside for a time. It stays in this list.</source>
        <translation>Mette da parte l’allarme per un certo tempo. Resta in questo elenco.</translation>
    </message>
    <message>
        <source>Show it again</source>
        <translation>Mostra di nuovo</translation>
    </message>
    <message numerus="yes">
        <source>For %n minutes</source>
        <translation>
            <numerusform>Per %n minuto</numerusform>
            <numerusform>Per %n minuti</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n hours</source>
        <translation>
            <numerusform>Per %n ora</numerusform>
            <numerusform>Per %n ore</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AuditModel</name>
    <message>
        <source>Line</source>
        <translation>Riga</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Ora</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Chi</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Ruolo</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Azione</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Dettagli</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AuditPage</name>
    <message>
        <source>Export the audit trail</source>
        <translation>Esporta il registro operazioni</translation>
    </message>
    <message>
        <source>No audit trail is kept.</source>
        <translation>Nessun registro operazioni.</translation>
    </message>
    <message>
        <source>The audit trail was changed: line %1 was edited, or lines before it were inserted or removed.</source>
        <translation>Il registro operazioni è stato alterato: la riga %1 è stata modificata, o prima di essa sono state inserite o eliminate righe.</translation>
    </message>
    <message>
        <source>Unchanged: every line follows from the one before it.</source>
        <translation>Integro: ogni riga segue dalla precedente.</translation>
    </message>
    <message>
        <source>Cut by a loss of power: %1.</source>
        <translation>Troncato da una mancanza di corrente: %1.</translation>
    </message>
    <message>
        <source>Last hash: %1 …</source>
        <translation>Ultimo hash: %1…</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>Export as CSV…</source>
        <translation>Esporta come CSV…</translation>
    </message>
    <message>
        <source>Export as JSON…</source>
        <translation>Esporta come JSON…</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Registro</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::BackDialog</name>
    <message>
        <source>To where the last rapid ended</source>
        <translation>Fino alla fine dell’ultimo rapido</translation>
    </message>
    <message>
        <source>Back along the path</source>
        <translation>Indietro lungo il percorso</translation>
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
        <translation>Mostra il tragitto</translation>
    </message>
    <message>
        <source>Length of the way</source>
        <translation>Lunghezza del tragitto</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Non ora</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::BoardCard</name>
    <message>
        <source>Remove …</source>
        <translation>Rimuovi…</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Mantieni</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CalibrationPage</name>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Shots of each kind</source>
        <translation>Misure di ogni tipo</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Al massimo</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>nessun limite</translation>
    </message>
    <message>
        <source>No program, cycle or other client uses R%1 to R%2: they may be written</source>
        <translation>Nessun programma, ciclo o altro client usa R%1 … R%2: si possono scrivere</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Calibra</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Rette</translation>
    </message>
    <message>
        <source>Spread (times in ms)</source>
        <translation>Dispersione (tempi in ms)</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>ancora %1</translation>
    </message>
    <message>
        <source>Testing the forms of access …</source>
        <translation>Prova delle forme di accesso…</translation>
    </message>
    <message>
        <source>First request of each kind …</source>
        <translation>Prima richiesta di ogni tipo…</translation>
    </message>
    <message>
        <source>%1 of %2 shots, %3</source>
        <translation>%1 misure su %2, %3</translation>
    </message>
    <message>
        <source>Takes about %1.</source>
        <translation>Dura circa %1.</translation>
    </message>
    <message>
        <source>%1, %2, R%3 to R%4, took %5</source>
        <translation>%1, %2, R%3 … R%4, durata %5</translation>
    </message>
    <message>
        <source>Outdated, not used: the server now has another version. %1</source>
        <translation>Superata, non usata: il server ora ha un’altra versione. %1</translation>
    </message>
    <message>
        <source>Calibrated: %1.</source>
        <translation>Calibrato: %1.</translation>
    </message>
    <message>
        <source>There was not enough time for all shots: reduced numbers are bold in the table.</source>
        <translation>Il tempo non è bastato per tutte le misure: i numeri ridotti sono in grassetto nella tabella.</translation>
    </message>
    <message>
        <source>Restoring the R-parameters …</source>
        <translation>Ripristino dei parametri R …</translation>
    </message>
    <message>
        <source>The last R-parameter is before the first.</source>
        <translation>L’ultimo parametro R viene prima del primo.</translation>
    </message>
    <message>
        <source>Confirm the R-parameters to begin.</source>
        <translation>Confermare i parametri R per iniziare.</translation>
    </message>
    <message>
        <source>This machine is not calibrated: %1 for each R-parameter are assumed.</source>
        <translation>Questa macchina non è calibrata: si ipotizzano %1 per parametro R.</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parametri R</translation>
    </message>
    <message>
        <source>Arrays too: for the test, they hold other values for a moment</source>
        <translation>Anche array: per il test hanno per un istante altri valori</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CellModel</name>
    <message>
        <source>Role</source>
        <translation>Ruolo</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parametri R</translation>
    </message>
    <message>
        <source>Point %1: %2</source>
        <translation>Punto %1: %2</translation>
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
        <translation>Segnale</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marcia</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Layout number</source>
        <translation>Numero di layout</translation>
    </message>
    <message>
        <source>Writer</source>
        <translation>Scrive</translation>
    </message>
    <message>
        <source>Client, NC</source>
        <translation>Client, NC</translation>
    </message>
    <message>
        <source>Feed (mm/min)</source>
        <translation>Avanzamento (mm/min)</translation>
    </message>
    <message>
        <source>Window %1: points</source>
        <translation>Finestra %1: punti</translation>
    </message>
    <message>
        <source>Window %1: feed (mm/min)</source>
        <translation>Finestra %1: avanzamento (mm/min)</translation>
    </message>
    <message>
        <source>Window %1: check number</source>
        <translation>Finestra %1: numero di controllo</translation>
    </message>
    <message>
        <source>Window %1 point %2: %3</source>
        <translation>Finestra %1 punto %2: %3</translation>
    </message>
    <message>
        <source>Windows delivered</source>
        <translation>Finestre consegnate</translation>
    </message>
    <message>
        <source>Windows taken</source>
        <translation>Finestre prelevate</translation>
    </message>
    <message>
        <source>Windows executed</source>
        <translation>Finestre eseguite</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stato</translation>
    </message>
    <message>
        <source>Number of the run</source>
        <translation>Numero dell’esecuzione</translation>
    </message>
    <message>
        <source>Run obeyed</source>
        <translation>Esecuzione seguita</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Segno di vita</translation>
    </message>
    <message>
        <source>Online correction: %1</source>
        <translation>Correzione online: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CertificatesPage</name>
    <message>
        <source>Save this computer&apos;s certificate</source>
        <translation>Salva il certificato di questo computer</translation>
    </message>
    <message>
        <source>A certificate is being made …</source>
        <translation>Creazione del certificato in corso…</translation>
    </message>
    <message>
        <source>There is none yet. It is made when it is first needed.</source>
        <translation>Non c’è ancora. Viene creato quando serve.</translation>
    </message>
    <message>
        <source>It has ended (%1). Renew it.</source>
        <translation>È scaduto (%1). Rinnovarlo.</translation>
    </message>
    <message numerus="yes">
        <source>Valid for %Ln more days (%1)</source>
        <translation>
            <numerusform>Valido ancora %Ln giorno (%1)</numerusform>
            <numerusform>Valido ancora %Ln giorni (%1)</numerusform>
        </translation>
    </message>
    <message>
        <source>Encryption by %1</source>
        <translation>Cifratura di %1</translation>
    </message>
    <message>
        <source>Certificate of this computer</source>
        <translation>Certificato di questo computer</translation>
    </message>
    <message>
        <source>Fingerprint (SHA-256)</source>
        <translation>Impronta (SHA-256)</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>Writes the certificate, without its key, for the control&apos;s list of trusted clients.</source>
        <translation>Scrive il certificato, senza la chiave, per l’elenco dei client fidati del controllo.</translation>
    </message>
    <message>
        <source>Hold: renew</source>
        <translation>Tenere: rinnova</translation>
    </message>
    <message>
        <source>Makes a new one. Every control has to trust it anew.</source>
        <translation>Ne crea uno nuovo. Ogni controllo deve fidarsene di nuovo.</translation>
    </message>
    <message>
        <source>Machines that are known</source>
        <translation>Macchine conosciute</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Dimentica</translation>
    </message>
    <message>
        <source>At the next connection the machine is new.</source>
        <translation>Alla prossima connessione la macchina è nuova.</translation>
    </message>
    <message>
        <source>Protect again</source>
        <translation>Proteggi di nuovo</translation>
    </message>
    <message>
        <source>Withdraws what was allowed for this machine: from then on, the strongest encryption or no connection.</source>
        <translation>Ritira ciò che è stato consentito per nome: la cifratura più forte o nessuna connessione.</translation>
    </message>
    <message>
        <source>Certificates that were refused</source>
        <translation>Certificati rifiutati</translation>
    </message>
    <message>
        <source>Hold: accept</source>
        <translation>Tenere: accetta</translation>
    </message>
    <message>
        <source>From then on it is trusted at its address, in place of any other one.</source>
        <translation>Da allora è fidato al suo indirizzo, al posto di qualsiasi altro.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Removes it from the list. It stays refused.</source>
        <translation>Lo rimuove dall’elenco. Resta rifiutato.</translation>
    </message>
    <message>
        <source>Only the very certificates that were accepted are trusted, not who issued them. So revocation lists are not needed: forget the machine instead.</source>
        <translation>Sono fidati solo i certificati accettati, non chi li ha rilasciati. Perciò le liste di revoca non servono: dimenticare invece la macchina.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CloseBar</name>
    <message>
        <source>Keep the window open</source>
        <translation>Lascia aperta la finestra</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Arresta e chiudi</translation>
    </message>
    <message>
        <source>A run is in progress. To close the window, its axes are held first, where they are; the run can be resumed from there.</source>
        <translation>Un’esecuzione è in corso. Per chiudere la finestra i suoi assi vengono prima fermati dove sono; l’esecuzione si può riprendere da lì.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ColumnsDialog</name>
    <message>
        <source>The trace can be analysed.</source>
        <translation>La traccia può essere analizzata.</translation>
    </message>
    <message>
        <source>Without a position the columns are shown, but stops and errors are not looked for.</source>
        <translation>Senza posizione le colonne sono mostrate, ma non si cercano fermate né errori.</translation>
    </message>
    <message>
        <source>Unit of the numbers in the file</source>
        <translation>Unità dei numeri nel file</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Unità di %1</translation>
    </message>
    <message>
        <source>What this column is; without a meaning it is shown as it is</source>
        <translation>Che cos’è questa colonna; senza significato è mostrata così com’è</translation>
    </message>
    <message>
        <source>Meaning of %1</source>
        <translation>Significato di %1</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Applica</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Place of the first sample on the time axis that several files share</source>
        <translation>Posto del primo campione sull’asse del tempo comune a più file</translation>
    </message>
    <message>
        <source>First sample at</source>
        <translation>Primo campione a</translation>
    </message>
    <message>
        <source>For a table without a column of time</source>
        <translation>Per una tabella senza colonna del tempo</translation>
    </message>
    <message>
        <source>First values</source>
        <translation>Primi valori</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unità</translation>
    </message>
    <message>
        <source>Means</source>
        <translation>Significato</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonna</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Colonne del file</translation>
    </message>
    <message>
        <source>What do the columns mean? The answer is kept for all files with the same headings.</source>
        <translation>Che cosa significano le colonne? La risposta vale per tutti i file con le stesse intestazioni.</translation>
    </message>
    <message>
        <source>Columns of %1</source>
        <translation>Colonne di %1</translation>
    </message>
    <message>
        <source>Samples per second</source>
        <translation>Campioni al secondo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CommissioningPage</name>
    <message>
        <source>First R-parameter</source>
        <translation>Primo parametro R</translation>
    </message>
    <message>
        <source>First R-parameter of the test</source>
        <translation>Primo parametro R del test</translation>
    </message>
    <message>
        <source>Nobody else uses R%1 to R%2</source>
        <translation>Nessun altro usa R%1 … R%2</translation>
    </message>
    <message>
        <source>I bring the program to the control myself</source>
        <translation>Trasferisco io il programma sul controllo</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Avvia il test</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Test program</source>
        <translation>Programma di test</translation>
    </message>
    <message>
        <source>1. Bring the channel to reset, in AUTO.</source>
        <translation>1. Portare il canale in Reset, in AUTO.</translation>
    </message>
    <message>
        <source>2. Store the text below as part program %1 and select it.</source>
        <translation>2. Salvare il testo sotto come programma pezzo %1 e selezionarlo.</translation>
    </message>
    <message>
        <source>2. The program %1 is transferred, read back and selected.</source>
        <translation>2. Il programma %1 viene trasferito, riletto e selezionato.</translation>
    </message>
    <message>
        <source>3. Press cycle start at the control (a virtual machine starts by itself).</source>
        <translation>3. Premere Start NC sul controllo (una macchina virtuale parte da sola).</translation>
    </message>
    <message>
        <source>Waiting for cycle start</source>
        <translation>Attende Start NC</translation>
    </message>
    <message>
        <source>The test is in progress</source>
        <translation>Il test è in corso</translation>
    </message>
    <message>
        <source>Tested with another version of the server: test it again</source>
        <translation>Testato con un’altra versione del server: ripetere il test</translation>
    </message>
    <message>
        <source>Confirm the R-parameters first.</source>
        <translation>Prima confermare i parametri R.</translation>
    </message>
    <message>
        <source>Way of the axis, mm</source>
        <translation>Corsa dell&apos;asse, mm</translation>
    </message>
    <message>
        <source>Feed of the axis, mm/min</source>
        <translation>Avanzamento dell&apos;asse, mm/min</translation>
    </message>
    <message>
        <source>by, mm</source>
        <translation>di, mm</translation>
    </message>
    <message>
        <source>F, mm/min</source>
        <translation>F, mm/min</translation>
    </message>
    <message>
        <source>Clear the way of the axis, then type %1.</source>
        <translation>Liberare la corsa dell&apos;asse, poi digitare %1.</translation>
    </message>
    <message>
        <source>Nothing is in its way: %1</source>
        <translation>Niente è sulla sua corsa: %1</translation>
    </message>
    <message>
        <source>Waiting for cycle start, once more</source>
        <translation>Attende ancora una volta Start NC</translation>
    </message>
    <message>
        <source>%1, %2, tested %3; %4</source>
        <translation>%1, %2, testato il %3; %4</translation>
    </message>
    <message>
        <source>An axis moves in the air</source>
        <translation>Un asse si muove in aria</translation>
    </message>
    <message>
        <source>Axis that moves</source>
        <translation>Asse che si muove</translation>
    </message>
    <message>
        <source>Confirm that the axis may move</source>
        <translation>Confermare che l&apos;asse può muoversi</translation>
    </message>
    <message>
        <source>Lift of the tool, mm</source>
        <translation>Sollevamento dell’utensile, mm</translation>
    </message>
    <message>
        <source>While the axis is held, the tool is lifted along Z by so much and comes back; 0: it is not lifted. A run may lift the tool only after that. Not with Z as the axis.</source>
        <translation>Mentre l’asse è fermato, l’utensile viene sollevato di questa distanza lungo Z e torna; 0: non viene sollevato. Solo dopo un’esecuzione può sollevare l’utensile. Non con Z come asse.</translation>
    </message>
    <message>
        <source>lift, mm</source>
        <translation>sollevamento, mm</translation>
    </message>
    <message>
        <source>One block a line, as a program has it: S500 M3, M8, T1 M6</source>
        <translation>Un blocco per riga, come in un programma: S500 M3, M8, T1 M6</translation>
    </message>
    <message>
        <source>Blocks to be tried</source>
        <translation>Blocchi da provare</translation>
    </message>
    <message>
        <source>2. The programs of the job are transferred, read back and selected.</source>
        <translation>2. I programmi del lavoro vengono trasferiti, riletti e selezionati.</translation>
    </message>
    <message>
        <source>the control shows nothing of it; not released</source>
        <translation>il controllo non ne mostra nulla; non abilitato</translation>
    </message>
    <message>
        <source>seen by the operator</source>
        <translation>visto dall’operatore</translation>
    </message>
    <message>
        <source>I have seen it</source>
        <translation>L’ho visto</translation>
    </message>
    <message>
        <source>Blocks to be tried, one a line: S500 M3</source>
        <translation>Blocchi da provare, uno per riga: S500 M3</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ComparePanel</name>
    <message>
        <source>Open two traces or more to compare them.</source>
        <translation>Aprire due o più tracce per confrontarle.</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>Confronto …</translation>
    </message>
    <message>
        <source>Each run has the length that it moved itself. With their NC program open, the runs are compared at the same places of the program.</source>
        <translation>Ogni esecuzione ha la lunghezza che ha percorso. Con il programma NC aperto, le esecuzioni sono confrontate negli stessi punti del programma.</translation>
    </message>
    <message>
        <source>Differences from %1</source>
        <translation>Differenze rispetto a %1</translation>
    </message>
    <message>
        <source>%1
%2 minus %3: largest %4 at %5, mean %6, RMS %7</source>
        <translation>%1
%2 meno %3: massima %4 a %5, media %6, RMS %7</translation>
    </message>
    <message>
        <source>Compare at the same</source>
        <translation>Confronta per</translation>
    </message>
    <message>
        <source>Axis of the comparison</source>
        <translation>Asse del confronto</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tempo</translation>
    </message>
    <message>
        <source>length of path</source>
        <translation>lunghezza del percorso</translation>
    </message>
    <message>
        <source>point of the program</source>
        <translation>punto del programma</translation>
    </message>
    <message>
        <source>Show the differences as curves</source>
        <translation>Mostra le differenze come curve</translation>
    </message>
    <message>
        <source>Each pane shows the other traces minus the first one</source>
        <translation>Ogni riquadro mostra quanto le altre tracce hanno in più della prima</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Differenze</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Segnale</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Massima</translation>
    </message>
    <message>
        <source>At</source>
        <translation>A</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ConnectionPanel</name>
    <message>
        <source>Connection</source>
        <translation>Connessione</translation>
    </message>
    <message>
        <source>OPC UA endpoint</source>
        <translation>Indirizzo OPC UA</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Canale</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Selezionato</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Allarme</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Messaggio</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connetti</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Disconnetti</translation>
    </message>
    <message>
        <source>Virtual machine: no real axis moves</source>
        <translation>Macchina virtuale: nessun asse reale si muove</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Attivo</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Interrotto</translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation>Sconosciuto (%1)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuno</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ControlFields</name>
    <message>
        <source>Map of the control</source>
        <translation>Mappa del controllo</translation>
    </message>
    <message>
        <source>Maps (*.toml)</source>
        <translation>Mappe (*.toml)</translation>
    </message>
    <message>
        <source>The control is no SINUMERIK</source>
        <translation>Il controllo non è un SINUMERIK</translation>
    </message>
    <message>
        <source>File with the map (.toml). It is remembered for this machine.</source>
        <translation>File con la mappa (.toml). Viene ricordato per questa macchina.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Libreria</translation>
    </message>
    <message>
        <source>Which library connects with the machine. Qt OPC UA is slower, does not encrypt, and takes no map and no user.</source>
        <translation>Quale libreria si collega con la macchina. Qt OPC UA è più lento, non cripta e non accetta né mappa né utente.</translation>
    </message>
    <message>
        <source>A map says under which names this control has its memory, axes and states. rivulet-cli map proposes one.</source>
        <translation>Una mappa dice con quali nomi questo controllo ha memoria, assi e stati. rivulet-cli map ne propone una.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CorrectionPanel</name>
    <message>
        <source>UDP port %1 cannot be opened: choose another.</source>
        <translation>Impossibile aprire la porta UDP %1: sceglierne un’altra.</translation>
    </message>
    <message>
        <source>Up to ±%1 per axis, during a run.</source>
        <translation>Fino a ±%1 per asse, durante un’esecuzione.</translation>
    </message>
    <message>
        <source>By hand, up to ±%1 per axis.</source>
        <translation>A mano, fino a ±%1 per asse.</translation>
    </message>
    <message>
        <source>The source is silent: its last value is held.</source>
        <translation>La sorgente tace: si mantiene il suo ultimo valore.</translation>
    </message>
    <message>
        <source>Nothing has been received from the source yet.</source>
        <translation>Dalla sorgente non è ancora stato ricevuto nulla.</translation>
    </message>
    <message>
        <source>Receiving from the source. Lines that are not corrections: %1</source>
        <translation>Ricezione dalla sorgente. Righe che non sono correzioni: %1</translation>
    </message>
    <message>
        <source>Receiving from the source.</source>
        <translation>Ricezione dalla sorgente.</translation>
    </message>
    <message>
        <source>Online correction</source>
        <translation>Correzione online</translation>
    </message>
    <message>
        <source>confirmed by the control</source>
        <translation>confermata dal controllo</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Zero</translation>
    </message>
    <message>
        <source>Set the correction of all axes to zero, then continue by hand</source>
        <translation>Porta a zero la correzione di tutti gli assi, poi si continua a mano</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Sorgente</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>A mano</translation>
    </message>
    <message>
        <source>UDP on this computer</source>
        <translation>UDP su questo computer</translation>
    </message>
    <message>
        <source>Datagrams to 127.0.0.1 with lines like X 0.01 Y -0.02, in mm</source>
        <translation>Datagrammi a 127.0.0.1 con righe come X 0.01 Y -0.02, in mm</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Porta</translation>
    </message>
    <message>
        <source>Silent after</source>
        <translation>Tace dopo</translation>
    </message>
    <message>
        <source>Correction of %1</source>
        <translation>Correzione di %1</translation>
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
        <translation>Un clic su una curva posiziona il cursore A, con Maiusc il cursore B.</translation>
    </message>
    <message>
        <source>The trace has no such place.</source>
        <translation>La traccia non ha questo punto.</translation>
    </message>
    <message>
        <source>Type a number.</source>
        <translation>Inserire un numero.</translation>
    </message>
    <message>
        <source>At the cursors and between them</source>
        <translation>Ai cursori e tra di essi</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>In A</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>In B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Slope, 1/s</source>
        <translation>Pendenza, 1/s</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimo</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Massimo</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Efficace</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95&#xa0;% sotto</translation>
    </message>
    <message>
        <source>99 % below</source>
        <translation>99&#xa0;% sotto</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Campioni</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Vai a</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Riga</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Number of the place to go to</source>
        <translation>Numero del punto</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Vai</translation>
    </message>
    <message>
        <source>Slope, 1/mm</source>
        <translation>Pendenza, 1/mm</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Pendenza</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DescribedMachineBox</name>
    <message>
        <source>Described by the server</source>
        <translation>Descritta dal server</translation>
    </message>
    <message>
        <source>What the server says of its machine by OPC 40001-1 (Machinery) and OPC 40501-1 (Machine Tools). It is read every 10 s, and not while a run is in progress.</source>
        <translation>Ciò che il server dice della sua macchina secondo OPC 40001-1 (Machinery) e OPC 40501-1 (Machine Tools). Viene letto ogni 10 s, ma non durante un’esecuzione.</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Costruttore</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modello</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numero di serie</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stato</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Lavoro</translation>
    </message>
    <message>
        <source>%1 (first of %2)</source>
        <translation>%1 (prima di %2)</translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation>%1 esecuzioni su %2</translation>
    </message>
    <message>
        <source>runs completed: %1</source>
        <translation>esecuzioni concluse: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DiagnosticModel</name>
    <message>
        <source>Severity</source>
        <translation>Gravità</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Riga</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonna</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Segnalazione</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DistanceChart</name>
    <message>
        <source>%1 … %2: %3 distances</source>
        <translation>%1 … %2: %3 distanze</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::EmulatorPage</name>
    <message>
        <source>Recording</source>
        <translation>Registrazione</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Verifica</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Apprendi</translation>
    </message>
    <message>
        <source>NC program</source>
        <translation>Programma NC</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manca</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>non serve</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Assi</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durata</translation>
    </message>
    <message>
        <source>Samples per s</source>
        <translation>Valori al s</translation>
    </message>
    <message>
        <source>Largest feed</source>
        <translation>Avanzamento massimo</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Asse</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parametro</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valore</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervallo</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Significato</translation>
    </message>
    <message>
        <source>Position RMS, µm</source>
        <translation>Posizione RMS, µm</translation>
    </message>
    <message>
        <source>at most, µm</source>
        <translation>al massimo, µm</translation>
    </message>
    <message>
        <source>Contour RMS, µm</source>
        <translation>Contorno RMS, µm</translation>
    </message>
    <message>
        <source>emulated, µm</source>
        <translation>emulato, µm</translation>
    </message>
    <message>
        <source>Speed, %</source>
        <translation>Velocità,&#xa0;%</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>File…</translation>
    </message>
    <message>
        <source>Add recordings</source>
        <translation>Aggiungi registrazioni</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Curve</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Tutti i file</translation>
    </message>
    <message>
        <source>NC program of %1</source>
        <translation>Programma NC di %1</translation>
    </message>
    <message>
        <source>Preset of the machine</source>
        <translation>Preset della macchina</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preset</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Salva come preset</translation>
    </message>
    <message>
        <source>Use to learn</source>
        <translation>Per apprendere</translation>
    </message>
    <message>
        <source>Use to test</source>
        <translation>Per verificare</translation>
    </message>
    <message>
        <source>Nothing is learned yet.</source>
        <translation>Non è ancora stato appreso nulla.</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lettura di %1…</translation>
    </message>
    <message>
        <source>%1 has no set points: choose its NC program.</source>
        <translation>%1 non ha valori nominali: scegliere il suo programma NC.</translation>
    </message>
    <message>
        <source>Record a few programs with different feeds, corners and reversals, and add the recordings here.</source>
        <translation>Registrare alcuni programmi con avanzamenti, angoli e inversioni diversi, e aggiungere qui le registrazioni.</translation>
    </message>
    <message>
        <source>All recordings are used to test: use one to learn.</source>
        <translation>Tutte le registrazioni servono a verificare: usarne una per apprendere.</translation>
    </message>
    <message>
        <source>Learning axis %1: %2 of %3 models tried, the best is right within %4.</source>
        <translation>Apprende l’asse %1: provati %2 modelli su %3, il migliore è giusto entro %4.</translation>
    </message>
    <message>
        <source>Learning …</source>
        <translation>Apprendimento…</translation>
    </message>
    <message>
        <source>Saved as %1. Give it to the virtual machine as its preset.</source>
        <translation>Salvato come %1. Darlo alla macchina virtuale come preset.</translation>
    </message>
    <message>
        <source>Learned and tested. Save it as a preset to use it.</source>
        <translation>Appreso e verificato. Salvarlo come preset per usarlo.</translation>
    </message>
    <message>
        <source>Ready to learn. Recordings used to test show how good the emulator is on programs it has not seen.</source>
        <translation>Pronto ad apprendere. Le registrazioni per verificare mostrano quanto vale l’emulatore su programmi mai visti.</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Aggiungi…</translation>
    </message>
    <message>
        <source>Add recordings of the machine</source>
        <translation>Aggiungi registrazioni della macchina</translation>
    </message>
    <message>
        <source>Learn from the recordings how the axes follow their set points</source>
        <translation>Apprendi dalle registrazioni come gli assi seguono i valori nominali</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Stop learning; what was learned before stays</source>
        <translation>Ferma l’apprendimento; resta ciò che è stato appreso prima</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>Save the emulator as a preset of the virtual machine</source>
        <translation>Salva l’emulatore come preset della macchina virtuale</translation>
    </message>
    <message>
        <source>NC program…</source>
        <translation>Programma NC…</translation>
    </message>
    <message>
        <source>The program that ran: needed for a recording without set points</source>
        <translation>Ciò che è stato eseguito: serve per una registrazione senza valori nominali</translation>
    </message>
    <message>
        <source>A recording used to test is not learned from</source>
        <translation>Da una registrazione usata per verificare non si apprende</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Takes the recording from the list; the file stays</source>
        <translation>Toglie la registrazione dall’elenco; il file resta</translation>
    </message>
    <message>
        <source>Bode and step plots</source>
        <translation>Bode e risposta al gradino</translation>
    </message>
    <message>
        <source>For those who know control engineering</source>
        <translation>Per chi conosce la regolazione automatica</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>What recordings do not say</source>
        <translation>Ciò che le registrazioni non dicono</translation>
    </message>
    <message>
        <source>Preset that has the limits of the machine; set points of programs are planned with them</source>
        <translation>Preset con i limiti della macchina; con essi si pianificano i valori nominali dei programmi</translation>
    </message>
    <message>
        <source>Models tried</source>
        <translation>Modelli provati</translation>
    </message>
    <message>
        <source>Error, µm</source>
        <translation>Errore, µm</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Registrazioni</translation>
    </message>
    <message>
        <source>Enter changes the use of a recording</source>
        <translation>Invio cambia l’uso di una registrazione</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametri</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Verifiche</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Confronto</translation>
    </message>
    <message>
        <source>Part of the page</source>
        <translation>Parte della pagina</translation>
    </message>
    <message>
        <source>How far an emulator is off that was learned from one recording alone.</source>
        <translation>Di quanto sbaglia un emulatore appreso da una sola registrazione.</translation>
    </message>
    <message>
        <source>Learns from each recording alone and tests on all others. So you see which recordings teach most, and what each parameter is worth.</source>
        <translation>Apprende da ogni registrazione da sola e verifica su tutte le altre. Così si vede quali registrazioni insegnano di più e quanto vale ogni parametro.</translation>
    </message>
    <message>
        <source>How much the positions would change on each recording if a parameter were 10 % larger.</source>
        <translation>Di quanto cambierebbero le posizioni in ogni registrazione se un parametro fosse maggiore del 10&#xa0;%.</translation>
    </message>
    <message>
        <source>Learning from each recording alone …</source>
        <translation>Apprendimento da ogni registrazione da sola…</translation>
    </message>
    <message>
        <source>Compare recordings</source>
        <translation>Confronta registrazioni</translation>
    </message>
    <message>
        <source>Takes at most as long as learning, for each recording</source>
        <translation>Dura al massimo quanto l’apprendimento, per ogni registrazione</translation>
    </message>
    <message>
        <source>Matrix of errors</source>
        <translation>Matrice degli errori</translation>
    </message>
    <message>
        <source>Tested on</source>
        <translation>Verificato su</translation>
    </message>
    <message>
        <source>Learned from (error RMS in µm)</source>
        <translation>Appreso da (errore RMS in µm)</translation>
    </message>
    <message>
        <source>Worth of the parameters</source>
        <translation>Valore dei parametri</translation>
    </message>
    <message>
        <source>Change of the positions, RMS, µm</source>
        <translation>Variazione delle posizioni, RMS, µm</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrice</translation>
    </message>
    <message>
        <source>On parts that were held out while learning (RMS): %1. A recording used to test was not learned from at all.</source>
        <translation>Su parti escluse dall’apprendimento (RMS): %1. Da una registrazione usata per verificare non si è appreso nulla.</translation>
    </message>
    <message>
        <source>Error on parts held out, while learning</source>
        <translation>Errore sulle parti escluse, durante l’apprendimento</translation>
    </message>
    <message>
        <source>none: what the model leaves is not chance</source>
        <translation>nessuno: ciò che il modello lascia non è casuale</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FactorPanel</name>
    <message>
        <source>Source</source>
        <translation>Sorgente</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Porta</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Almeno</translation>
    </message>
    <message>
        <source>Smallest factor of your override that may act</source>
        <translation>Il fattore più piccolo del vostro override che può agire</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Al massimo</translation>
    </message>
    <message>
        <source>Largest factor that may act; together with your override no more than 120 % of the programmed feed</source>
        <translation>Il fattore più grande che può agire; insieme al vostro override non più del 120&#xa0;% dell’avanzamento programmato</translation>
    </message>
    <message>
        <source>Silent after</source>
        <translation>Tace dopo</translation>
    </message>
    <message>
        <source>Without a factor</source>
        <translation>Senza un fattore</translation>
    </message>
    <message>
        <source>Before the first one, when the source is silent or closed, and when it sends what was not agreed</source>
        <translation>Prima del primo, quando la sorgente tace o è chiusa, e quando invia ciò che non era concordato</translation>
    </message>
    <message>
        <source>Your override acts alone.</source>
        <translation>Agisce solo il vostro override.</translation>
    </message>
    <message>
        <source>It is read from the start on. Nothing moves before its first factor.</source>
        <translation>Viene letta a partire dall’avvio. Prima del suo primo fattore non si muove nulla.</translation>
    </message>
    <message>
        <source>It is read from the start on.</source>
        <translation>Viene letta a partire dall’avvio.</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Avanzamento adattivo</translation>
    </message>
    <message>
        <source>A sensor or script that sends lines such as feed 0.85: 85 % of your override, until the next one. Pause and Stop always act.</source>
        <translation>Un sensore o uno script che invia righe come feed 0.85: 85&#xa0;% del vostro override, fino alla prossima. Pausa e Stop agiscono sempre.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Nessuna</translation>
    </message>
    <message>
        <source>TCP on this computer</source>
        <translation>TCP su questo computer</translation>
    </message>
    <message>
        <source>UDP on this computer</source>
        <translation>UDP su questo computer</translation>
    </message>
    <message>
        <source>Hold the axes</source>
        <translation>Trattenere gli assi</translation>
    </message>
    <message>
        <source>Your override alone</source>
        <translation>Solo il vostro override</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FeasibilityPage</name>
    <message>
        <source>F over d_min</source>
        <translation>F rispetto a d_min</translation>
    </message>
    <message>
        <source>F over N</source>
        <translation>F rispetto a N</translation>
    </message>
    <message>
        <source>F over δ</source>
        <translation>F rispetto a δ</translation>
    </message>
    <message>
        <source>Load a program to see where it can be streamed.</source>
        <translation>Caricare un programma per vedere dove può essere trasmesso.</translation>
    </message>
    <message>
        <source>Drag the ring to change the feed.</source>
        <translation>Trascinare l’anello per cambiare l’avanzamento.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the feed. Method position does not depend on N.</source>
        <translation>Trascinare l’anello per cambiare N e l’avanzamento. Il metodo Posizione non dipende da N.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the feed.</source>
        <translation>Trascinare l’anello per cambiare N e l’avanzamento.</translation>
    </message>
    <message>
        <source>Drag the ring to change δ and the feed.</source>
        <translation>Trascinare l’anello per cambiare δ e l’avanzamento.</translation>
    </message>
    <message>
        <source>Operating point</source>
        <translation>Punto di lavoro</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Fattibile</translation>
    </message>
    <message>
        <source>Safety band</source>
        <translation>Fascia di sicurezza</translation>
    </message>
    <message>
        <source>(1) point distance</source>
        <translation>(1) distanza dei punti</translation>
    </message>
    <message>
        <source>(2) distance δ</source>
        <translation>(2) distanza δ</translation>
    </message>
    <message>
        <source>(3) half a loop</source>
        <translation>(3) mezzo loop</translation>
    </message>
    <message>
        <source>(3) half a loop, for information</source>
        <translation>(3) mezzo loop, per informazione</translation>
    </message>
    <message>
        <source>(3ᴺ) half a loop, real path</source>
        <translation>(3ᴺ) mezzo loop, percorso reale</translation>
    </message>
    <message>
        <source>dashed: as published</source>
        <translation>tratteggiato: come pubblicato</translation>
    </message>
    <message>
        <source>Smallest distances of the program</source>
        <translation>Distanze minime del programma</translation>
    </message>
    <message>
        <source>Simulate around the operating point</source>
        <translation>Simula attorno al punto di lavoro</translation>
    </message>
    <message>
        <source>Simulating: %p %</source>
        <translation>Simulazione: %p %</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Simulated on the virtual machine, %1 points around the tightest place.</source>
        <translation>Simulato sulla macchina virtuale, %1 punti attorno al tratto più critico.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Funziona</translation>
    </message>
    <message>
        <source>Sometimes fails</source>
        <translation>Fallisce a volte</translation>
    </message>
    <message>
        <source>Always fails</source>
        <translation>Fallisce sempre</translation>
    </message>
    <message>
        <source>Model: 0.1 % to 50 % fail</source>
        <translation>Calcolo: fallisce dallo 0,1&#xa0;% al 50&#xa0;%</translation>
    </message>
    <message>
        <source>This method does not use δ: the limits do not depend on it.</source>
        <translation>Questo metodo non usa δ: i limiti non ne dipendono.</translation>
    </message>
    <message>
        <source>Without waiting</source>
        <translation>Senza attese</translation>
    </message>
    <message>
        <source>reach: the client keeps up</source>
        <translation>portata: il client tiene il passo</translation>
    </message>
    <message>
        <source>Runs failed in the simulation</source>
        <translation>Errori nella simulazione</translation>
    </message>
    <message>
        <source>Override over t_min</source>
        <translation>Override rispetto a t_min</translation>
    </message>
    <message>
        <source>Override over N</source>
        <translation>Override rispetto a N</translation>
    </message>
    <message>
        <source>Override over δ</source>
        <translation>Override rispetto a δ</translation>
    </message>
    <message>
        <source>Drag the ring to change the override on the feeds of the program.</source>
        <translation>Trascinare l’anello per cambiare l’override sugli avanzamenti del programma.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the override.</source>
        <translation>Trascinare l’anello per cambiare N e l’override.</translation>
    </message>
    <message>
        <source>Largest override: %1.</source>
        <translation>Override massimo: %1.</translation>
    </message>
    <message>
        <source>Shortest moves of the program</source>
        <translation>Movimenti più brevi del programma</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FileBanner</name>
    <message>
        <source>The file %1 has changed.</source>
        <translation>Il file %1 è cambiato.</translation>
    </message>
    <message>
        <source>The file %1 is no longer there.</source>
        <translation>Il file %1 non esiste più.</translation>
    </message>
    <message>
        <source>The run keeps version %1.</source>
        <translation>L’esecuzione mantiene la versione %1.</translation>
    </message>
    <message>
        <source>Reload it?</source>
        <translation>Ricaricarlo?</translation>
    </message>
    <message>
        <source>Version %1 stays loaded.</source>
        <translation>La versione %1 resta caricata.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Ricarica</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FileField</name>
    <message>
        <source>Choose…</source>
        <translation>Scegli…</translation>
    </message>
    <message>
        <source>Choose the file: %1</source>
        <translation>Scegli il file: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FitModel</name>
    <message>
        <source>write</source>
        <translation>scrittura</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lettura</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accesso</translation>
    </message>
    <message>
        <source>Per request (a)</source>
        <translation>Per richiesta (a)</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Scarto</translation>
    </message>
    <message>
        <source>Per R-parameter (b)</source>
        <translation>Per parametro R (b)</translation>
    </message>
    <message>
        <source>± of b</source>
        <translation>± di b</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FoundRunBar</name>
    <message>
        <source>It can be resumed on the computer where it was started.</source>
        <translation>Si può riprendere sul computer su cui è stata avviata.</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Osserva</translation>
    </message>
    <message>
        <source>Shows program, position and progress. Nothing is changed.</source>
        <translation>Mostra programma, posizione e avanzamento del lavoro. Non cambia nulla.</translation>
    </message>
    <message>
        <source>Stop the run</source>
        <translation>Arresta l’esecuzione</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Riprendi…</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Non ora</translation>
    </message>
    <message>
        <source>The axes stand at once, whoever started the run.</source>
        <translation>Gli assi si fermano subito, chiunque abbia avviato l’esecuzione.</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Termina qui</translation>
    </message>
    <message>
        <source>The axes go on to the end of the window, or of the block of the control, and the program ends there.</source>
        <translation>Gli assi proseguono fino alla fine della finestra, o del blocco del controllo, e lì il programma termina.</translation>
    </message>
    <message>
        <source>Stop requested: still moving, at most %1, about %2</source>
        <translation>Stop richiesto: ancora in movimento, al massimo %1, circa %2</translation>
    </message>
    <message>
        <source>Stop requested, not yet confirmed</source>
        <translation>Stop richiesto, non ancora confermato</translation>
    </message>
    <message>
        <source>Loads the program, compares it and asks the control where the run was left. Nothing moves yet.</source>
        <translation>Carica il programma, lo confronta e chiede al controllo dove l’esecuzione si è interrotta. Ancora non si muove nulla.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::HelpPage</name>
    <message>
        <source>Back</source>
        <translation>Indietro</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuale</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::HistogramChart</name>
    <message>
        <source>Duration, ms</source>
        <translation>Durata, ms</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Misure</translation>
    </message>
    <message>
        <source>write</source>
        <translation>scrittura</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lettura</translation>
    </message>
    <message>
        <source>%1 %: %2</source>
        <translation>%1&#xa0;%: %2</translation>
    </message>
    <message>
        <source>%1 beyond, the longest %2</source>
        <translation>%1 oltre, la più lunga %2</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LayoutMenu</name>
    <message>
        <source>No layout is kept yet</source>
        <translation>Nessuna disposizione ancora conservata</translation>
    </message>
    <message>
        <source>Keep the present panes as…</source>
        <translation>Conserva i riquadri attuali come…</translation>
    </message>
    <message>
        <source>New traces are shown in</source>
        <translation>Le nuove tracce si mostrano in</translation>
    </message>
    <message>
        <source>the usual panes</source>
        <translation>i riquadri abituali</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Keep the panes</source>
        <translation>Conserva i riquadri</translation>
    </message>
    <message>
        <source>Name of the layout; one of the same name is replaced</source>
        <translation>Nome della disposizione; una con lo stesso nome è sostituita</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LinesChart</name>
    <message>
        <source>Duration, ms</source>
        <translation>Durata, ms</translation>
    </message>
    <message>
        <source>write</source>
        <translation>scrittura</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lettura</translation>
    </message>
    <message>
        <source>R-parameters of the request</source>
        <translation>Parametri R della richiesta</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LiveDialog</name>
    <message>
        <source>Live points</source>
        <translation>Punti in diretta</translation>
    </message>
    <message>
        <source>A program or script computes the path while the machine moves and sends its points as lines, such as X1.5 Y2 F500. Nothing moves that is outside what is agreed here.</source>
        <translation>Un programma o uno script calcola il percorso mentre la macchina si muove e invia i suoi punti come righe, ad esempio X1.5 Y2 F500. Nulla si muove fuori da quanto concordato qui.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Listens from now on. Nothing moves before the start.</source>
        <translation>Da ora è in ascolto. Nulla si muove prima dell’avvio.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Sorgente</translation>
    </message>
    <message>
        <source>TCP port of this computer</source>
        <translation>Porta TCP di questo computer</translation>
    </message>
    <message>
        <source>UDP port of this computer</source>
        <translation>Porta UDP di questo computer</translation>
    </message>
    <message>
        <source>UNIX socket</source>
        <translation>Socket UNIX</translation>
    </message>
    <message>
        <source>Standard input of this window</source>
        <translation>Standard input di questa finestra</translation>
    </message>
    <message>
        <source>0: any that is free</source>
        <translation>0: una qualsiasi libera</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Porta</translation>
    </message>
    <message>
        <source>File name of the socket, which only this user can write to</source>
        <translation>Nome di file del socket, in cui può scrivere solo questo utente</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Percorso</translation>
    </message>
    <message>
        <source>Box of all points</source>
        <translation>Volume di tutti i punti</translation>
    </message>
    <message>
        <source>from</source>
        <translation>da</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Least coordinate, workpiece frame</source>
        <translation>Coordinata minima, sistema pezzo</translation>
    </message>
    <message>
        <source>Largest coordinate, workpiece frame</source>
        <translation>Coordinata massima, sistema pezzo</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 da</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 a</translation>
    </message>
    <message>
        <source>Agreed with the source</source>
        <translation>Concordato con la sorgente</translation>
    </message>
    <message>
        <source>First point within</source>
        <translation>Primo punto entro</translation>
    </message>
    <message>
        <source>Largest distance of the first point from the tool</source>
        <translation>Distanza massima del primo punto dall’utensile</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Passo massimo</translation>
    </message>
    <message>
        <source>Largest distance of two points</source>
        <translation>Distanza massima tra due punti</translation>
    </message>
    <message>
        <source>Largest F</source>
        <translation>F massimo</translation>
    </message>
    <message>
        <source>It is also the feed of points before the first F.</source>
        <translation>È anche l’avanzamento dei punti prima del primo F.</translation>
    </message>
    <message>
        <source>Merge below</source>
        <translation>Unire sotto</translation>
    </message>
    <message>
        <source>Points that are closer are merged with the one before.</source>
        <translation>I punti più vicini vengono uniti al precedente.</translation>
    </message>
    <message>
        <source>Largest turn</source>
        <translation>Rotazione massima</translation>
    </message>
    <message>
        <source>Largest turn of a rotary axis between two points</source>
        <translation>Rotazione massima di un asse rotativo tra due punti</translation>
    </message>
    <message>
        <source>Points may turn this axis (method window).</source>
        <translation>I punti possono ruotare questo asse (metodo Finestra).</translation>
    </message>
    <message>
        <source>Rotary axis %1</source>
        <translation>Asse rotativo %1</translation>
    </message>
    <message>
        <source>Rotary axes</source>
        <translation>Assi rotativi</translation>
    </message>
    <message>
        <source>When no points come</source>
        <translation>Quando non arrivano punti</translation>
    </message>
    <message>
        <source>Window within</source>
        <translation>Finestra entro</translation>
    </message>
    <message>
        <source>A window that is not full is sent after this time.</source>
        <translation>Una finestra non piena viene inviata dopo questo tempo.</translation>
    </message>
    <message>
        <source>Hold after</source>
        <translation>Sospendi dopo</translation>
    </message>
    <message>
        <source>After this much silence the run holds; it goes on with the next point.</source>
        <translation>Dopo questo silenzio l’esecuzione si sospende; continua con il punto successivo.</translation>
    </message>
    <message>
        <source>End after</source>
        <translation>Termina dopo</translation>
    </message>
    <message>
        <source>After this much silence the run ends with an error.</source>
        <translation>Dopo questo silenzio l’esecuzione termina con un errore.</translation>
    </message>
    <message>
        <source>Variables of an OPC UA server</source>
        <translation>Variabili di un server OPC UA</translation>
    </message>
    <message>
        <source>To ports and sockets, only programs on this computer can send.</source>
        <translation>Solo i programmi di questo computer possono inviare a porte e socket.</translation>
    </message>
    <message>
        <source>This file names the server and its variables (TOML).</source>
        <translation>Questo file indica il server e le sue variabili (TOML).</translation>
    </message>
    <message>
        <source>File of the source</source>
        <translation>File della sorgente</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Scegli …</translation>
    </message>
    <message>
        <source>Choose the file of the source</source>
        <translation>Scegli il file della sorgente</translation>
    </message>
    <message>
        <source>File</source>
        <translation>File</translation>
    </message>
    <message>
        <source>Sources (*.toml);;All files (*)</source>
        <translation>Sorgenti (*.toml);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Around the tool</source>
        <translation>Intorno all’utensile</translation>
    </message>
    <message>
        <source>Puts a box of this size around the place where the tool stands.</source>
        <translation>Mette una scatola di questa dimensione intorno al punto in cui si trova l’utensile.</translation>
    </message>
    <message>
        <source>Where the tool stands is not known.</source>
        <translation>Non si sa dove si trova l’utensile.</translation>
    </message>
    <message>
        <source>The tool stands at %1.</source>
        <translation>L’utensile si trova a %1.</translation>
    </message>
    <message>
        <source>The tool stands at %1, so far outside that no first point can be in the box.</source>
        <translation>L’utensile si trova a %1, così fuori che nessun primo punto può stare nella scatola.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LivePanel</name>
    <message>
        <source>It is read as soon as the control runs the program.</source>
        <translation>Viene letta appena il controllo esegue il programma.</translation>
    </message>
    <message>
        <source>The run has ended. It listens for the next one.</source>
        <translation>L’esecuzione è finita. La sorgente attende la prossima.</translation>
    </message>
    <message>
        <source>Listening. Nothing is read before the start.</source>
        <translation>In ascolto. Nulla viene letto prima dell’avvio.</translation>
    </message>
    <message>
        <source>Waiting for the first line, for %1</source>
        <translation>Attende la prima riga da %1</translation>
    </message>
    <message>
        <source>Receiving</source>
        <translation>Riceve</translation>
    </message>
    <message>
        <source>Silent for %1; %2</source>
        <translation>Muta da %1; %2</translation>
    </message>
    <message>
        <source>Ended by the source</source>
        <translation>Terminato dalla sorgente</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 punti su %2</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Live points …</source>
        <translation>Punti in diretta…</translation>
    </message>
    <message>
        <source>Another source, or something else agreed with it</source>
        <translation>Un’altra sorgente o un altro accordo</translation>
    </message>
    <message>
        <source>Open program …</source>
        <translation>Apri programma…</translation>
    </message>
    <message>
        <source>A program takes the place of the live source.</source>
        <translation>Un programma prende il posto della sorgente in diretta.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Agreed with the source</source>
        <translation>Concordato con la sorgente</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Buffer</translation>
    </message>
    <message>
        <source>Points that have arrived and are not executed. When it is full, the source is made to wait.</source>
        <translation>Punti arrivati e non ancora eseguiti. Quando è pieno, la sorgente deve attendere.</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Ingresso</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Uscita</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Accettati</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Eseguiti</translation>
    </message>
    <message>
        <source>Merged</source>
        <translation>Uniti</translation>
    </message>
    <message>
        <source>Delay, median</source>
        <translation>Ritardo, mediana</translation>
    </message>
    <message>
        <source>Delay, 99 %</source>
        <translation>Ritardo, 99&#xa0;%</translation>
    </message>
    <message>
        <source>In theory</source>
        <translation>In teoria</translation>
    </message>
    <message>
        <source>Points from the source, mean of the last two seconds</source>
        <translation>Punti dalla sorgente, media degli ultimi due secondi</translation>
    </message>
    <message>
        <source>Points executed, mean of the last two seconds</source>
        <translation>Punti eseguiti, media degli ultimi due secondi</translation>
    </message>
    <message>
        <source>Points of the source within the agreed limits</source>
        <translation>Punti della sorgente che rispettano quanto concordato</translation>
    </message>
    <message>
        <source>Points that are known to be executed</source>
        <translation>Punti di cui è nota l’esecuzione</translation>
    </message>
    <message>
        <source>Points too close to the one before, which are left out</source>
        <translation>Punti troppo vicini al precedente, che vengono omessi</translation>
    </message>
    <message>
        <source>From the arrival of a point to the beginning of its move; during a run, of the last 500 points</source>
        <translation>Dall’arrivo di un punto all’inizio del suo movimento; durante un’esecuzione, degli ultimi 500 punti</translation>
    </message>
    <message>
        <source>Of a hundred points, one was later than this.</source>
        <translation>Su cento punti, uno è stato più in ritardo.</translation>
    </message>
    <message>
        <source>Least delay, and the delay when all buffers are full</source>
        <translation>Ritardo minimo, e il ritardo con tutti i buffer pieni</translation>
    </message>
    <message>
        <source>First point within</source>
        <translation>Primo punto entro</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Passo massimo</translation>
    </message>
    <message>
        <source>Largest F</source>
        <translation>F massimo</translation>
    </message>
    <message>
        <source>Merge below</source>
        <translation>Unire sotto</translation>
    </message>
    <message>
        <source>When it is silent</source>
        <translation>Quando è muta</translation>
    </message>
    <message>
        <source>Send lines such as X1.5 Y2 F500 to 127.0.0.1, port %1. The line “end” ends the run.</source>
        <translation>Inviare righe come X1.5 Y2 F500 a 127.0.0.1, porta %1. La riga «end» termina l’esecuzione.</translation>
    </message>
    <message>
        <source>Send lines such as X1.5 Y2 F500 to it. The line “end” ends the run.</source>
        <translation>Inviarle righe come X1.5 Y2 F500. La riga «end» termina l’esecuzione.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LoadBar</name>
    <message>
        <source>Reading %1</source>
        <translation>Lettura di %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogInDialog</name>
    <message>
        <source>Log in</source>
        <translation>Accedi</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utente</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>Delete the last digit</source>
        <translation>Cancella l’ultima cifra</translation>
    </message>
    <message>
        <source>Wrong PIN. Try again in %1 s.</source>
        <translation>PIN errato. Riprovare tra %1 s.</translation>
    </message>
    <message>
        <source>Wrong PIN.</source>
        <translation>PIN errato.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogModel</name>
    <message>
        <source>Time</source>
        <translation>Ora</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravità</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Messaggio</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origine</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogView</name>
    <message>
        <source>Copy</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>Save the messages</source>
        <translation>Salva i messaggi</translation>
    </message>
    <message>
        <source>%1 of %2 messages</source>
        <translation>%1 messaggi su %2</translation>
    </message>
    <message>
        <source>All messages</source>
        <translation>Tutti i messaggi</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Avvisi ed errori</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>Solo errori</translation>
    </message>
    <message>
        <source>All sources</source>
        <translation>Tutte le origini</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravità</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>Wrap lines</source>
        <translation>A capo automatico</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messaggi</translation>
    </message>
    <message numerus="yes">
        <source>%Ln messages</source>
        <translation>
            <numerusform>%Ln messaggio</numerusform>
            <numerusform>%Ln messaggi</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LoginFields</name>
    <message>
        <source>This machine lets nobody in without a user. Type user and password.</source>
        <translation>Questa macchina non fa entrare nessuno senza utente. Inserire utente e password.</translation>
    </message>
    <message>
        <source>Type the password of this user.</source>
        <translation>Inserire la password di questo utente.</translation>
    </message>
    <message>
        <source>The machine refuses user or password. Check both. After several wrong ones it locks the user for some time.</source>
        <translation>La macchina rifiuta utente o password. Controllare entrambi. Dopo vari errori blocca l’utente per un certo tempo.</translation>
    </message>
    <message>
        <source>There is no keyring on this computer: the password is asked for each time.</source>
        <translation>Su questo computer non c’è un portachiavi: la password viene chiesta ogni volta.</translation>
    </message>
    <message>
        <source>Log in as a user of the machine</source>
        <translation>Accedi come utente della macchina</translation>
    </message>
    <message>
        <source>Without it, the connection is anonymous.</source>
        <translation>Altrimenti la connessione è anonima.</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utente</translation>
    </message>
    <message>
        <source>User of the OPC UA server, as it is set up on the control.</source>
        <translation>Utente del server OPC UA, come configurato sul controllo.</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Password</translation>
    </message>
    <message>
        <source>It is sent encrypted only, and is in no setting, log or recording.</source>
        <translation>Viene inviata solo cifrata e non è in nessuna impostazione, registro o registrazione.</translation>
    </message>
    <message>
        <source>Keep it in the keyring</source>
        <translation>Conserva nel portachiavi</translation>
    </message>
    <message>
        <source>The keyring of this computer&apos;s user keeps it encrypted; it is not asked for again.</source>
        <translation>Il portachiavi dell’utente di questo computer la conserva cifrata; non viene più chiesta.</translation>
    </message>
    <message>
        <source>This machine lets nobody in without a user. Choose the user&apos;s certificate.</source>
        <translation>Questa macchina non accetta nessuno senza utente. Scegliere il certificato dell&apos;utente.</translation>
    </message>
    <message>
        <source>The machine refuses this certificate. Register it for a user on the machine, or choose another one.</source>
        <translation>La macchina rifiuta questo certificato. Registrarlo per un utente sulla macchina, oppure sceglierne un altro.</translation>
    </message>
    <message>
        <source>The user is known by</source>
        <translation>L&apos;utente si identifica con</translation>
    </message>
    <message>
        <source>What the machine asks of its users.</source>
        <translation>Ciò che la macchina chiede ai suoi utenti.</translation>
    </message>
    <message>
        <source>name and password</source>
        <translation>nome e password</translation>
    </message>
    <message>
        <source>a certificate</source>
        <translation>un certificato</translation>
    </message>
    <message>
        <source>Certificate of the user</source>
        <translation>Certificato dell&apos;utente</translation>
    </message>
    <message>
        <source>PEM or DER. Register it on the machine first. The name of the file is remembered for this machine.</source>
        <translation>PEM o DER. Registrarlo prima sulla macchina. Il nome del file viene ricordato per questa macchina.</translation>
    </message>
    <message>
        <source>Key, if it is in another file</source>
        <translation>Chiave, se in un altro file</translation>
    </message>
    <message>
        <source>PEM or DER, not locked by a password; only this computer&apos;s user may read the file (mode 0600). The key is not sent.</source>
        <translation>PEM o DER, non protetta da password; solo l&apos;utente di questo computer può leggere il file (modo 0600). La chiave non viene inviata.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MachineButton</name>
    <message>
        <source>Virtual machine</source>
        <translation>Macchina virtuale</translation>
    </message>
    <message>
        <source>%1, silent for %2 s</source>
        <translation>%1, nessuna risposta da %2 s</translation>
    </message>
    <message>
        <source>Connection and state of the machine</source>
        <translation>Connessione e stato della macchina</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MachinesPage</name>
    <message numerus="yes">
        <source>%Ln virtual machines of this computer do not answer any more, and nothing but their runs is kept.</source>
        <translation>
            <numerusform>%Ln macchina virtuale di questo computer non risponde più, e se ne conservano solo le esecuzioni.</numerusform>
            <numerusform>%Ln macchine virtuali di questo computer non rispondono più, e se ne conservano solo le esecuzioni.</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide them</source>
        <translation>Nascondi</translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>One machine at a time is connected with a window. Of the others only the port is looked at, every 30 s while this page is shown: a question would cost them time that another stream may need.</source>
        <translation>Una finestra è connessa a una macchina alla volta. Delle altre si controlla solo la porta, ogni 30 s finché questa pagina è visibile: una domanda costerebbe loro tempo di cui un altro flusso può avere bisogno.</translation>
    </message>
    <message>
        <source>Puts the service with this address on the board.</source>
        <translation>Mette il servizio con questo indirizzo sul quadro.</translation>
    </message>
    <message>
        <source>Asks a discovery server of OPC UA for services: that of the address, or of this computer.</source>
        <translation>Chiede i servizi a un server di discovery OPC UA: quello dell’indirizzo o quello di questo computer.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Aggiungi %1</translation>
    </message>
    <message>
        <source>Services: machines without a window</source>
        <translation>Servizi: macchine senza finestra</translation>
    </message>
    <message>
        <source>&amp;Address of a service</source>
        <translation>&amp;Indirizzo di un servizio</translation>
    </message>
    <message>
        <source>Address of a service</source>
        <translation>Indirizzo di un servizio</translation>
    </message>
    <message>
        <source>As rivulet-service prints it when it is ready.</source>
        <translation>Come la stampa rivulet-service quando è pronto.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Cerca</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MethodPanel</name>
    <message>
        <source>Method</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>N (points per loop)</source>
        <translation>N (punti per loop)</translation>
    </message>
    <message>
        <source>δ (point reached)</source>
        <translation>δ (punto raggiunto)</translation>
    </message>
    <message>
        <source>F (path feed)</source>
        <translation>F (avanzamento)</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parametri R</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Esito</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margine</translation>
    </message>
    <message>
        <source>Largest feed</source>
        <translation>Avanzamento massimo</translation>
    </message>
    <message>
        <source>Limiting place</source>
        <translation>Tratto più critico</translation>
    </message>
    <message>
        <source>Distance from the tool at which a point counts as reached</source>
        <translation>Distanza dall’utensile entro la quale un punto vale come raggiunto</translation>
    </message>
    <message>
        <source>Equation (1): the tool must not pass a point between two polls.</source>
        <translation>Equazione (1): l’utensile non deve superare alcun punto tra due letture.</translation>
    </message>
    <message>
        <source>Equation (2): the tool must be seen within δ of each point.</source>
        <translation>Equazione (2): l’utensile deve essere visto entro δ da ogni punto.</translation>
    </message>
    <message>
        <source>Equation (3): half a loop must be written before the tool has used it up.</source>
        <translation>Equazione (3): mezzo loop deve essere scritto prima che l’utensile lo abbia consumato.</translation>
    </message>
    <message>
        <source>Equation (3) with the real path: half a loop must be written before the tool has used it up.</source>
        <translation>Equazione (3) con il percorso reale: mezzo loop deve essere scritto prima che l’utensile lo abbia consumato.</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Non valutato</translation>
    </message>
    <message>
        <source>Load a program to get a verdict.</source>
        <translation>Caricare un programma per ottenere un esito.</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Fattibile</translation>
    </message>
    <message>
        <source>Not feasible</source>
        <translation>Non fattibile</translation>
    </message>
    <message>
        <source>Closest limit: %1</source>
        <translation>Limite più vicino: %1</translation>
    </message>
    <message>
        <source>Violated: %1</source>
        <translation>Violato: %1</translation>
    </message>
    <message>
        <source>%1 × (must exceed 1)</source>
        <translation>%1 × (deve superare 1)</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>riga %1</translation>
    </message>
    <message>
        <source>lines %1–%2</source>
        <translation>righe %1–%2</translation>
    </message>
    <message>
        <source>Use δ = %1</source>
        <translation>Usa δ = %1</translation>
    </message>
    <message>
        <source>Use F = %1</source>
        <translation>Usa F = %1</translation>
    </message>
    <message>
        <source>No feed is slow enough: two points of the program nearly coincide.</source>
        <translation>Nessun avanzamento è abbastanza lento: due punti del programma quasi coincidono.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posizione</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Segnale</translation>
    </message>
    <message>
        <source>With gaps (R11, R21 …)</source>
        <translation>Spaziati (R11, R21 …)</translation>
    </message>
    <message>
        <source>In a row (R10 …)</source>
        <translation>Di seguito (R10 …)</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Finestra</translation>
    </message>
    <message>
        <source>N (points per window)</source>
        <translation>N (punti per finestra)</translation>
    </message>
    <message>
        <source>Reach: the next window must be written while the tool executes the current one.</source>
        <translation>Portata: la finestra successiva deve essere scritta mentre l’utensile esegue quella attuale.</translation>
    </message>
    <message>
        <source>Largest feed without waiting</source>
        <translation>Avanz. max. senza attese</translation>
    </message>
    <message>
        <source>Safe, with waiting</source>
        <translation>Sicuro, con attese</translation>
    </message>
    <message>
        <source>The machine will wait for points: %1</source>
        <translation>La macchina attenderà i punti: %1</translation>
    </message>
    <message>
        <source>%1 × (waits below 1)</source>
        <translation>%1 × (attende sotto 1)</translation>
    </message>
    <message>
        <source>Credit (experimental)</source>
        <translation>Credito (sperimentale)</translation>
    </message>
    <message>
        <source>Windows have a layout of their own</source>
        <translation>Le finestre hanno un layout proprio</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accesso</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatico</translation>
    </message>
    <message>
        <source>Arrays, or no start</source>
        <translation>Array, altrimenti nessun avvio</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>One by one</source>
        <translation>Singolarmente</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Previste</translation>
    </message>
    <message>
        <source>Places where the axes will stop for a moment. Off the cut means after a rapid or a retract, or at a sharp corner; the path shows the places.</source>
        <translation>Punti in cui gli assi si fermeranno per un istante. Fuori dal taglio significa dopo un rapido o uno svincolo, o su uno spigolo vivo; il percorso mostra i punti.</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Tempo perso</translation>
    </message>
    <message>
        <source>Standstill, braking and acceleration, computed with the axes of the virtual machine</source>
        <translation>Arresto, frenata e accelerazione, calcolati con gli assi della macchina virtuale</translation>
    </message>
    <message>
        <source>Automatic: before anything moves, the forms of access are tested on the control and the best one is used. The report names it.</source>
        <translation>Automatico: prima di ogni movimento le forme di accesso vengono provate sul controllo e si usa la migliore. Il rapporto la indica.</translation>
    </message>
    <message>
        <source>Automatic: lists, as this method was published. Arrays need the contiguous layout.</source>
        <translation>Automatico: liste, come questo metodo è stato pubblicato. Gli array richiedono il layout contiguo.</translation>
    </message>
    <message>
        <source>%1, of them %2 in the cut</source>
        <translation>%1, di cui %2 nel taglio</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calcolo in corso…</translation>
    </message>
    <message>
        <source>Correction up to</source>
        <translation>Correzione fino a</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuna</translation>
    </message>
    <message>
        <source>Largest correction of each axis during the run. The control must not add corrections up (MD36750 bit 0), and its own limit (SD43350) should not be larger.</source>
        <translation>Correzione massima di ogni asse durante l’esecuzione. Il controllo non deve sommare le correzioni (MD36750 bit 0), e il suo limite (SD43350) non dovrebbe essere maggiore.</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Modello</translation>
    </message>
    <message>
        <source>copied by hand</source>
        <translation>copiato a mano</translation>
    </message>
    <message>
        <source>For a control that gives no right to its part programs: store the template there, select it and press cycle start. The run waits until this is done.</source>
        <translation>Per un controllo che non dà diritti sui suoi programmi pezzo: caricare lì il modello, selezionarlo e premere Start NC. L’esecuzione attende fino ad allora.</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Verifica in corso…</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Of the program</source>
        <translation>Del programma</translation>
    </message>
    <message>
        <source>One for all moves</source>
        <translation>Avanzamento fisso</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Scales the feeds of the program, and its rapids up to the rapid feed of the machine</source>
        <translation>Agisce sugli avanzamenti del programma e sui suoi rapidi, questi al massimo fino al rapido della macchina</translation>
    </message>
    <message>
        <source>This method has one feed for all moves, as it was published</source>
        <translation>Questo metodo ha un solo avanzamento per tutti i movimenti, come pubblicato</translation>
    </message>
    <message>
        <source>Of the program: each move has the feed of its own block, rapids are rapids. One for all moves: rapids have it, too.</source>
        <translation>Del programma: ogni movimento ha l’avanzamento del suo blocco, i rapidi restano rapidi. Avanzamento fisso: vale anche per i rapidi.</translation>
    </message>
    <message>
        <source>Largest override</source>
        <translation>Override massimo</translation>
    </message>
    <message>
        <source>Use override = %1&#xa0;%</source>
        <translation>Usa override = %1&#xa0;%</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Eseguire</translation>
    </message>
    <message>
        <source>Whole job</source>
        <translation>Lavoro completo</translation>
    </message>
    <message>
        <source>Motion only</source>
        <translation>Solo movimento</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Prova a vuoto</translation>
    </message>
    <message>
        <source>Above the workpiece</source>
        <translation>Sopra il pezzo</translation>
    </message>
    <message>
        <source>Whole job: the control executes tools, spindle, coolant, cycles and retracts at their place, and Rivulet streams the motion between them. Motion only: these blocks are left out. Dry run: the whole job above the workpiece, without spindle and coolant.</source>
        <translation>Lavoro completo: il controllo esegue utensili, mandrino, refrigerante, cicli e svincoli al loro posto, e Rivulet trasmette il movimento tra di essi. Solo movimento: questi blocchi sono omessi. Prova a vuoto: il lavoro completo sopra il pezzo, senza mandrino né refrigerante.</translation>
    </message>
    <message>
        <source>The points of a live source have feeds of their own.</source>
        <translation>I punti di una sorgente in diretta hanno avanzamenti propri.</translation>
    </message>
    <message>
        <source>Lift while paused</source>
        <translation>Sollevare in pausa</translation>
    </message>
    <message>
        <source>While the axes are held, the tool can be lifted by so much. The control must not add overlays up (MD36750 bit 0), and its limit (SD43350) must not be smaller. Not with a correction or in a whole job; on a real control only after its stop test with a lift.</source>
        <translation>Finché gli assi sono fermati, l’utensile può essere sollevato di questa distanza. Il controllo non deve sommare le sovrapposizioni (MD36750 bit 0), e il suo limite (SD43350) non deve essere minore. Non con una correzione né in un lavoro intero; su un controllo reale solo dopo la sua prova di stop con sollevamento.</translation>
    </message>
    <message>
        <source>packed: one R-parameter each</source>
        <translation>compatti: un parametro R ciascuno</translation>
    </message>
    <message>
        <source>All axes of a point share one R-parameter, in steps of 0.001 mm from the first point of its window: a third of the accesses, so faster where the points are dense. A control that calculates otherwise refuses the first window; nothing moves then.</source>
        <translation>Tutti gli assi di un punto condividono un parametro R, a passi di 0,001 mm dal primo punto della sua finestra: un terzo degli accessi, quindi più veloce dove i punti sono fitti. Un controllo che calcola diversamente rifiuta la prima finestra; allora non si muove nulla.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>This method does not use δ: it watches an R-parameter, not the tool</source>
        <translation>Questo metodo non usa δ: osserva un parametro R, non l’utensile</translation>
    </message>
    <message>
        <source>Window: the machine waits if the client is late; it never executes a point twice. Position: the client watches the tool and replaces points it has passed. Signal: the client watches an R-parameter in which the program says which half of the loop may be replaced. Credit: like window, without a stop between windows; it starts only on a control that has passed the test on the page Credit test.</source>
        <translation>Finestra: la macchina attende se il client è in ritardo; non esegue mai un punto due volte. Posizione: il client osserva l’utensile e sostituisce i punti già superati. Segnale: il client osserva un parametro R in cui il programma indica quale metà del loop può essere sostituita. Credito: come Finestra, senza arresto tra le finestre; si avvia solo su un controllo che ha superato il test della pagina Test credito.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolleranza</translation>
    </message>
    <message>
        <source>Straight moves that stay so near to the path take the place of many short ones (rotary axes: degrees). Corners, feeds and the order of the path stay. Not in whole jobs and live runs.</source>
        <translation>Movimenti diritti che restano così vicini al percorso prendono il posto di molti corti (assi rotativi: gradi). Spigoli, avanzamenti e ordine del percorso restano. Non nei lavori interi né con punti dal vivo.</translation>
    </message>
    <message>
        <source>Machine: requests and motion of this machine, followed through the program.</source>
        <translation>Macchina: richieste e moto di questa macchina, seguiti lungo il programma.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NetCanvas</name>
    <message>
        <source>Only records; holds no tokens.</source>
        <translation>Registra soltanto, non tiene marche.</translation>
    </message>
    <message>
        <source>Tokens: %1</source>
        <translation>Marche: %1</translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation>Priorità %1</translation>
    </message>
    <message>
        <source>If %1</source>
        <translation>Se %1</translation>
    </message>
    <message>
        <source>A page of its own: Enter or a double click opens it.</source>
        <translation>Una pagina a sé: Invio o un doppio clic la apre.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NetPanel</name>
    <message>
        <source>Place</source>
        <translation>Posto</translation>
    </message>
    <message>
        <source>Tokens</source>
        <translation>Marche</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valori</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Riproduci</translation>
    </message>
    <message>
        <source>There is no net.</source>
        <translation>Non c’è nessuna rete.</translation>
    </message>
    <message>
        <source>%1, fired %2; next: %3</source>
        <translation>%1, scattate %2; prossima: %3</translation>
    </message>
    <message>
        <source>%1, fired %2; nothing more is played</source>
        <translation>%1, scattate %2; non si riproduce altro</translation>
    </message>
    <message>
        <source>Click a place or a transition: what it holds or needs is shown here.</source>
        <translation>Fare clic su un posto o una transizione: qui appare ciò che contiene o richiede.</translation>
    </message>
    <message>
        <source>Cycle %1 ms</source>
        <translation>Ciclo %1 ms</translation>
    </message>
    <message>
        <source>Cycle of position control; the net begins anew</source>
        <translation>Ciclo del controllo di posizione; la rete ricomincia</translation>
    </message>
    <message>
        <source>Task dependency</source>
        <translation>Dipendenza dei compiti</translation>
    </message>
    <message>
        <source>Data flow</source>
        <translation>Flusso di dati</translation>
    </message>
    <message>
        <source>Which task gets the processor; the net begins anew</source>
        <translation>Quale compito ottiene il processore; la rete ricomincia</translation>
    </message>
    <message>
        <source>Page of the net</source>
        <translation>Pagina della rete</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Segui</translation>
    </message>
    <message>
        <source>Show the page on which the next transition fires</source>
        <translation>Mostrare la pagina su cui scatta la prossima transizione</translation>
    </message>
    <message>
        <source>%1 per s</source>
        <translation>%1 al s</translation>
    </message>
    <message>
        <source>Transitions that fire in a second</source>
        <translation>Transizioni che scattano in un secondo</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Fire one transition</source>
        <translation>Far scattare una transizione</translation>
    </message>
    <message>
        <source>Fire one transition after another</source>
        <translation>Far scattare una transizione dopo l’altra</translation>
    </message>
    <message>
        <source>Back to start</source>
        <translation>All’inizio</translation>
    </message>
    <message>
        <source>The tokens as they were at the beginning</source>
        <translation>Le marche come all’inizio</translation>
    </message>
    <message>
        <source>Petri net</source>
        <translation>Rete di Petri</translation>
    </message>
    <message>
        <source>A thick frame with a triangle: this transition could fire. Filled: it fires next. Thick lines: it fired last.</source>
        <translation>Una cornice spessa con un triangolo: questa transizione potrebbe scattare. Piena: scatta per prossima. Linee spesse: è scattata per ultima.</translation>
    </message>
    <message>
        <source>Levels of the buffers</source>
        <translation>Livelli dei buffer</translation>
    </message>
    <message>
        <source>Time of the net, s</source>
        <translation>Tempo della rete, s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Livello</translation>
    </message>
    <message>
        <source>Places of this page</source>
        <translation>Posti di questa pagina</translation>
    </message>
    <message>
        <source>What is chosen</source>
        <translation>Ciò che è scelto</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NumberField</name>
    <message>
        <source>%1 can be read in two ways. Type it without a separator between thousands, or with %2 before the decimals.</source>
        <translation>%1 si può leggere in due modi. Scriverlo senza separatore delle migliaia, o con %2 prima dei decimali.</translation>
    </message>
    <message>
        <source>%1 has more than one separator. Type it without separators between thousands.</source>
        <translation>%1 ha più di un separatore. Scriverlo senza separatori delle migliaia.</translation>
    </message>
    <message>
        <source>The field was empty.</source>
        <translation>Il campo era vuoto.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 non è un numero.</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 to %3.</source>
        <translation>%1 è fuori campo: da %2 a %3.</translation>
    </message>
    <message>
        <source>%1 The value stays %2.</source>
        <translation>%1 Il valore resta %2.</translation>
    </message>
    <message>
        <source>%1 is not a whole number. Type it without separators.</source>
        <translation>%1 non è un numero intero. Scriverlo senza separatori.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::OverlayPanel</name>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Emulator</source>
        <translation>Emulatore</translation>
    </message>
    <message>
        <source>%1 machine − emulator</source>
        <translation>%1 macchina − emulatore</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Registrazione</translation>
    </message>
    <message>
        <source>Recording on which machine and emulator are compared</source>
        <translation>Registrazione su cui si confrontano macchina ed emulatore</translation>
    </message>
    <message>
        <source>Errors drawn larger</source>
        <translation>Errori ingranditi</translation>
    </message>
    <message>
        <source>How many times larger the distance to the path of the set points is drawn</source>
        <translation>Quante volte più grande è disegnata la distanza dal percorso dei valori nominali</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Errore × %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::OverrideControl</name>
    <message>
        <source>Path override of this run, in percent of the programmed feed. The override of the machine&apos;s own switch multiplies. Ctrl++ and Ctrl+- are a step of 5 %.</source>
        <translation>Override di percorso di questa esecuzione, in percento dell&apos;avanzamento programmato. L&apos;override dell&apos;interruttore della macchina moltiplica. Ctrl++ e Ctrl+- sono un passo del 5 %.</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Override: 5 % less</source>
        <translation>Override: 5 % in meno</translation>
    </message>
    <message>
        <source>Override: 5 % more</source>
        <translation>Override: 5 % in più</translation>
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
        <translation>Rete di Petri</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Compiti</translation>
    </message>
    <message>
        <source>Part of the page</source>
        <translation>Parte della pagina</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathPane</name>
    <message>
        <source>The path during the time shown. Click: cursor A. Shift and click: cursor B. In 3D, drag or the arrow keys turn it, Home turns it back.</source>
        <translation>Il percorso del tempo mostrato. Clic: cursore A. Maiusc e clic: cursore B. In 3D lo ruotano il trascinamento o le frecce, Inizio lo riporta.</translation>
    </message>
    <message>
        <source>Path of the axes</source>
        <translation>Percorso degli assi</translation>
    </message>
    <message>
        <source>%1: no values here</source>
        <translation>%1: nessun valore qui</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Errore × %1</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>riga %1</translation>
    </message>
    <message>
        <source>No X and Y here</source>
        <translation>Qui non ci sono X e Y</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathPanel</name>
    <message>
        <source>Line %1 was executed %2 times. Cursor A is at number %3; click again for the next.</source>
        <translation>La riga %1 è stata eseguita %2 volte. Il cursore A è alla numero %3; un altro clic porta alla successiva.</translation>
    </message>
    <message>
        <source>The line under cursor A is marked. A click on a line puts cursor A where it was executed.</source>
        <translation>La riga sotto il cursore A è evidenziata. Un clic su una riga porta il cursore A dove è stata eseguita.</translation>
    </message>
    <message>
        <source>Text of the program</source>
        <translation>Testo del programma</translation>
    </message>
    <message>
        <source>The signal that gives the path its colours</source>
        <translation>Il segnale che dà i colori al percorso</translation>
    </message>
    <message>
        <source>Colour of the path</source>
        <translation>Colore del percorso</translation>
    </message>
    <message>
        <source>Enlargement of the error</source>
        <translation>Ingrandimento dell’errore</translation>
    </message>
    <message>
        <source>Seen from the side; drag the path or press the arrow keys to turn it</source>
        <translation>Vista di lato; trascinare il percorso o premere le frecce per ruotarlo</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>X and Y, seen from above</source>
        <translation>X e Y, visti dall’alto</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Alto</translation>
    </message>
    <message>
        <source>A click on a line puts cursor A where it was executed.</source>
        <translation>Un clic su una riga porta il cursore A dove è stata eseguita.</translation>
    </message>
    <message>
        <source>Nothing moved in line %1.</source>
        <translation>Nella riga %1 non si è mosso nulla.</translation>
    </message>
    <message>
        <source>The trace does not show where it is in the program.</source>
        <translation>La traccia non mostra a che punto del programma si trova.</translation>
    </message>
    <message>
        <source>Comparing the trace with the program …</source>
        <translation>Confronto della traccia con il programma…</translation>
    </message>
    <message>
        <source>The run was made with another program or another version of it. Open that one to see its lines with the cursor.</source>
        <translation>L’esecuzione è stata fatta con un altro programma o un’altra versione. Aprire quello per vederne le righe con il cursore.</translation>
    </message>
    <message>
        <source>Lines and trace are linked when a trace is shown.</source>
        <translation>Righe e traccia sono collegate quando è mostrata una traccia.</translation>
    </message>
    <message>
        <source>Open the NC program of the trace to see its lines with the cursor.</source>
        <translation>Aprire il programma NC della traccia per vederne le righe con il cursore.</translation>
    </message>
    <message>
        <source>Errors can be drawn larger after the trace has been compared with its NC program</source>
        <translation>Gli errori si possono ingrandire dopo il confronto della traccia con il suo programma NC</translation>
    </message>
    <message>
        <source>How many times larger the distance to the programmed path is drawn</source>
        <translation>Quante volte più grande è disegnata la distanza dal percorso programmato</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Errore × %1</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>Colore: %1</translation>
    </message>
    <message>
        <source>Colour: the trace</source>
        <translation>Colore: la traccia</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathView</name>
    <message>
        <source>Fit</source>
        <translation>Adatta</translation>
    </message>
    <message>
        <source>Show the whole path (double click does the same)</source>
        <translation>Mostra tutto il percorso (come il doppio clic)</translation>
    </message>
    <message>
        <source>No program is loaded</source>
        <translation>Nessun programma caricato</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Rapido</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Eseguito</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inizio</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Utensile</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Colore per</translation>
    </message>
    <message>
        <source>Kind of move</source>
        <translation>Tipo di movimento</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Margin of the method</source>
        <translation>Margine del metodo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>by point</source>
        <translation>per punto</translation>
    </message>
    <message>
        <source>by time</source>
        <translation>per tempo</translation>
    </message>
    <message>
        <source>Walk along the path</source>
        <translation>Scorri il percorso</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Retta</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Arco</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>no feed given</source>
        <translation>avanzamento non indicato</translation>
    </message>
    <message>
        <source>margin over %1</source>
        <translation>margine oltre %1</translation>
    </message>
    <message>
        <source>not kept (below %1)</source>
        <translation>non rispettato (sotto %1)</translation>
    </message>
    <message>
        <source>Click on the path or move the slider.</source>
        <translation>Fare clic sul percorso o muovere il cursore.</translation>
    </message>
    <message>
        <source>Point %1 of %2, line %3</source>
        <translation>Punto %1 di %2, riga %3</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calcolo in corso…</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>fino a %1</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Mark where the run will pause</source>
        <translation>Segna dove l’esecuzione farà una pausa</translation>
    </message>
    <message>
        <source>Pause off the cut, after point %1, line %2</source>
        <translation>Pausa fuori dal taglio, dopo il punto %1, riga %2</translation>
    </message>
    <message>
        <source>Pause in the cut, after point %1, line %2</source>
        <translation>Pausa nel taglio, dopo il punto %1, riga %2</translation>
    </message>
    <message>
        <source>%1 in the cut</source>
        <translation>%1 nel taglio</translation>
    </message>
    <message>
        <source>then a pause in the cut</source>
        <translation>poi una pausa nel taglio</translation>
    </message>
    <message>
        <source>then a pause off the cut</source>
        <translation>poi una pausa fuori dal taglio</translation>
    </message>
    <message>
        <source>Density of pauses</source>
        <translation>Densità delle pause</translation>
    </message>
    <message>
        <source>no pause</source>
        <translation>nessuna pausa</translation>
    </message>
    <message>
        <source>a pause every %1</source>
        <translation>una pausa ogni %1</translation>
    </message>
    <message>
        <source>By the control</source>
        <translation>Dal controllo</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>Cambio utensile</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pauses off the cut</source>
        <translation>
            <numerusform>%Ln pausa fuori dal taglio</numerusform>
            <numerusform>%Ln pause fuori dal taglio</numerusform>
        </translation>
    </message>
    <message>
        <source>The points appear here as they come</source>
        <translation>I punti appaiono qui come arrivano</translation>
    </message>
    <message>
        <source>Grid %1</source>
        <translation>Griglia %1</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Drag or press the arrow keys to turn it; with Shift, dragging moves it</source>
        <translation>Trascinare o le frecce la ruotano; con Maiusc, trascinare la sposta</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Sopra</translation>
    </message>
    <message>
        <source>From above: X, Y</source>
        <translation>Dall’alto: X, Y</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Fronte</translation>
    </message>
    <message>
        <source>From the front: X, Z</source>
        <translation>Da davanti: X, Z</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lato</translation>
    </message>
    <message>
        <source>From the right: Y, Z</source>
        <translation>Da destra: Y, Z</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PositionLine</name>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Nessun dato</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>In diretta</translation>
    </message>
    <message>
        <source>Last executed point, %1. The axes were read %2 ago.</source>
        <translation>Ultimo punto eseguito, %1. Assi letti %2 fa.</translation>
    </message>
    <message>
        <source>Old: read %1 ago</source>
        <translation>Vecchio: letto %1 fa</translation>
    </message>
    <message>
        <source>to go %1</source>
        <translation>resta %1</translation>
    </message>
    <message>
        <source>Distance to go: not known, because the stream leaves no time to read the axes.</source>
        <translation>Percorso residuo: non noto, perché la trasmissione non lascia il tempo di leggere gli assi.</translation>
    </message>
    <message>
        <source>Distance to go: not known. The axes are not on the path of the program, or it is being corrected.</source>
        <translation>Percorso residuo: non noto. Gli assi non sono sul percorso del programma, o è in corso una correzione.</translation>
    </message>
    <message>
        <source>Distance to go: the control does not report it.</source>
        <translation>Percorso residuo: il controllo non lo comunica.</translation>
    </message>
    <message>
        <source>Distance to go to the end of the move in progress, from the position that was read and the path of the program</source>
        <translation>Percorso residuo fino alla fine del movimento in corso, dalla posizione letta e dal percorso del programma</translation>
    </message>
    <message>
        <source>Distance to go to the end of the block, as the control reports it</source>
        <translation>Percorso residuo fino alla fine del blocco, comunicato dal controllo</translation>
    </message>
    <message>
        <source>set %1</source>
        <translation>imp. %1</translation>
    </message>
    <message>
        <source>The feed override at the control is not read; it acts in addition.</source>
        <translation>L’override di avanzamento del controllo non viene letto; agisce in aggiunta.</translation>
    </message>
    <message>
        <source>Commanded feed: not known, because no run of this window is in progress.</source>
        <translation>Avanzamento impostato: non noto, perché nessuna esecuzione di questa finestra è in corso.</translation>
    </message>
    <message>
        <source>Feed of the program, scaled by the override of the run. %1</source>
        <translation>Avanzamento del programma, con l’override dell’esecuzione. %1</translation>
    </message>
    <message>
        <source>One feed for all moves, without an override. %1</source>
        <translation>Un avanzamento per tutti i movimenti, senza override. %1</translation>
    </message>
    <message>
        <source>Up to 1 s old: no time to read more often</source>
        <translation>Vecchio fino a 1 s: non c’è tempo per leggere di più</translation>
    </message>
    <message>
        <source>No tool in the spindle</source>
        <translation>Nessun utensile nel mandrino</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Utensile %1</translation>
    </message>
    <message>
        <source>cutting edge D%1</source>
        <translation>tagliente D%1</translation>
    </message>
    <message>
        <source>work offset %1</source>
        <translation>spostamento origine %1</translation>
    </message>
    <message>
        <source>Spindle: actual %1, commanded %2 1/min</source>
        <translation>Mandrino: effettivo %1, comandato %2 giri/min</translation>
    </message>
    <message>
        <source>clockwise (M3)</source>
        <translation>rotazione oraria (M3)</translation>
    </message>
    <message>
        <source>counterclockwise (M4)</source>
        <translation>rotazione antioraria (M4)</translation>
    </message>
    <message>
        <source>direction not known</source>
        <translation>senso di rotazione non noto</translation>
    </message>
    <message>
        <source>coolant off</source>
        <translation>refrigerante spento</translation>
    </message>
    <message>
        <source>coolant on (%1)</source>
        <translation>refrigerante acceso (%1)</translation>
    </message>
    <message>
        <source>coolant not known</source>
        <translation>refrigerante non noto</translation>
    </message>
    <message>
        <source>%1. The control reports it, about once a second.</source>
        <translation>%1. Lo comunica il controllo, circa una volta al secondo.</translation>
    </message>
    <message>
        <source>%1. Read %2 ago: it may have changed since.</source>
        <translation>%1. Letto %2 fa: nel frattempo può essere cambiato.</translation>
    </message>
    <message>
        <source>Live, but tool and spindle: read %1 ago</source>
        <translation>In diretta, ma utensile e mandrino: letti %1 fa</translation>
    </message>
    <message>
        <source>Read %1 ago: the run is being prepared</source>
        <translation>Letto %1 fa: l’esecuzione si prepara</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PreflightSheet</name>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the machine moves.</source>
        <translation>Ancora non si è mosso nulla. Tenere premuto Avvia per un secondo: poi la macchina si muove.</translation>
    </message>
    <message>
        <source>Start is not possible yet.</source>
        <translation>L’avvio non è ancora possibile.</translation>
    </message>
    <message>
        <source>Before the start</source>
        <translation>Prima dell’avvio</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Non ora</translation>
    </message>
    <message>
        <source>Resuming is not possible yet.</source>
        <translation>La ripresa non è ancora possibile.</translation>
    </message>
    <message>
        <source>Before the run is resumed</source>
        <translation>Prima di riprendere l’esecuzione</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Superato</translation>
    </message>
    <message numerus="yes">
        <source>%Ln checks: %1</source>
        <translation>
            <numerusform>%Ln controllo: %1</numerusform>
            <numerusform>%Ln controlli: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Comprimi</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostra</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold the button below for one second: then the machine moves.</source>
        <translation>Ancora non si è mosso nulla. Tenere premuto per un secondo il pulsante in basso: poi la macchina si muove.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the tool is raised, and nothing else.</source>
        <translation>Non si è ancora mosso nulla. Tenere premuto Avvia per un secondo: allora l&apos;utensile viene sollevato, e nient&apos;altro.</translation>
    </message>
    <message>
        <source>Before the tool is raised</source>
        <translation>Prima di sollevare l&apos;utensile</translation>
    </message>
    <message>
        <source>First move</source>
        <translation>Primo movimento</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the tool goes back along the path, and nothing else.</source>
        <translation>Non si è ancora mosso nulla. Tenere premuto Avvia per un secondo: allora l’utensile torna indietro lungo il percorso, e nient’altro.</translation>
    </message>
    <message>
        <source>Before the tool goes back</source>
        <translation>Prima che l’utensile torni indietro</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProfilePage</name>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Utensile %1</translation>
    </message>
    <message>
        <source>Number of the tool</source>
        <translation>Numero dell’utensile</translation>
    </message>
    <message>
        <source>Entered by %1 on %2.</source>
        <translation>Inserito da %1 il %2.</translation>
    </message>
    <message>
        <source>Nobody has entered the limits of this machine. Feeds and simulations take those of the machine in the paper: %1.</source>
        <translation>Nessuno ha inserito i limiti di questa macchina. Avanzamenti e simulazioni usano quelli della macchina dell’articolo: %1.</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Non ancora salvato.</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Nome della macchina</translation>
    </message>
    <message>
        <source>Simulated as</source>
        <translation>Simulata come</translation>
    </message>
    <message>
        <source>Take over its limits</source>
        <translation>Adotta i suoi limiti</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Assi</translation>
    </message>
    <message>
        <source>Travel from</source>
        <translation>Corsa da</translation>
    </message>
    <message>
        <source>Travel to</source>
        <translation>Corsa a</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accelerazione</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Strappo</translation>
    </message>
    <message>
        <source>Rapid, mm/min</source>
        <translation>Rapido, mm/min</translation>
    </message>
    <message>
        <source>Spindle up to, 1/min</source>
        <translation>Mandrino fino a, 1/min</translation>
    </message>
    <message>
        <source>0: no spindle</source>
        <translation>0: nessun mandrino</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Utensili</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numero</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Lunghezza, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Raggio, mm</translation>
    </message>
    <message>
        <source>Add a tool</source>
        <translation>Aggiungi un utensile</translation>
    </message>
    <message>
        <source>Save the limits</source>
        <translation>Salva i limiti</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Annulla le modifiche</translation>
    </message>
    <message>
        <source>M functions: write the number, an equals sign, and ignore, pass or a line for the control. Separate entries with semicolons.</source>
        <translation>Funzioni M: scrivere un numero, = e ignore, pass o una riga per il controllo; un punto e virgola tra due.</translation>
    </message>
    <message>
        <source>M functions of other machines</source>
        <translation>Funzioni M di altre macchine</translation>
    </message>
    <message>
        <source>What this machine does for the M functions of programs made for another: ignore leaves the function out, pass gives it to the control, anything else is a line for it.</source>
        <translation>Che cosa fa questa macchina per le funzioni M di programmi fatti per un’altra: ignore omette la funzione, pass la passa al controllo, qualsiasi altra cosa è una riga per esso.</translation>
    </message>
    <message>
        <source>When nothing has come from this computer for so long, the axes stand on the path until it gives a sign again. 0: not at all.</source>
        <translation>Se per questo tempo non arriva nulla da questo computer, gli assi si fermano sulla traiettoria finché non dà di nuovo segno. 0: mai.</translation>
    </message>
    <message>
        <source>Without this computer the axes stand after, s</source>
        <translation>Senza questo computer gli assi si fermano dopo, s</translation>
    </message>
    <message>
        <source>Where a stop is sure to act only before the next window, because this control has not passed the stop test, no window of several moves takes longer.</source>
        <translation>Dove uno stop agisce con certezza solo prima della finestra successiva, perché questo controllo non ha superato la prova di stop, nessuna finestra di più movimenti dura di più.</translation>
    </message>
    <message>
        <source>Without a passed stop test a window takes at most, s</source>
        <translation>Senza prova di stop superata una finestra dura al massimo, s</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramPage</name>
    <message>
        <source>Program text</source>
        <translation>Testo del programma</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramPanel</name>
    <message>
        <source>Open an NC program</source>
        <translation>Apri un programma NC</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tutti i file (*)</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recenti</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Dati</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Segnalazioni</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Righe</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Movimenti</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Cutting path</source>
        <translation>Percorso in lavoro</translation>
    </message>
    <message>
        <source>Rapid path</source>
        <translation>Percorso in rapido</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>Avanzamenti</translation>
    </message>
    <message>
        <source>Smallest distance of neighbouring points</source>
        <translation>Distanza minima tra punti vicini</translation>
    </message>
    <message>
        <source>Smallest path length of half a loop (N/2 points, rounded down)</source>
        <translation>Lunghezza minima di mezzo loop (N/2 punti, arrotondato per difetto)</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Nessun programma</translation>
    </message>
    <message>
        <source>Drop a file here or press Open…</source>
        <translation>Trascinare qui un file o premere Apri…</translation>
    </message>
    <message>
        <source>Hash %1</source>
        <translation>Hash %1</translation>
    </message>
    <message>
        <source>Errors: %1, warnings: %2, notes: %3</source>
        <translation>Errori: %1, avvisi: %2, note: %3</translation>
    </message>
    <message>
        <source>Cannot be streamed.</source>
        <translation>Non trasmissibile in continuo.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>riga %1</translation>
    </message>
    <message>
        <source>lines %1–%2</source>
        <translation>righe %1–%2</translation>
    </message>
    <message>
        <source>No findings</source>
        <translation>Nessuna segnalazione</translation>
    </message>
    <message>
        <source>NC programs (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap *.cnc *.gcode *.h *.H *.txt)</source>
        <translation>Programmi NC (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap *.cnc *.gcode *.h *.H *.txt)</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialetto</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>Accetta…</translation>
    </message>
    <message>
        <source>The program is read again with this word left out</source>
        <translation>Il programma viene riletto senza questa parola</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unità</translation>
    </message>
    <message>
        <source>By kind</source>
        <translation>Per tipo</translation>
    </message>
    <message>
        <source>Time, feeds as programmed</source>
        <translation>Tempo, avanzamenti programmati</translation>
    </message>
    <message>
        <source>Time, as streamed</source>
        <translation>Tempo, in trasmissione</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distanze</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Spigoli</translation>
    </message>
    <message>
        <source>Distances of neighbouring points, mm</source>
        <translation>Distanze tra punti vicini, mm</translation>
    </message>
    <message>
        <source>%1 (repetitions left out: %2)</source>
        <translation>%1 (ripetizioni tralasciate: %2)</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indicata</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pollici</translation>
    </message>
    <message>
        <source>mm and inch</source>
        <translation>mm e pollici</translation>
    </message>
    <message>
        <source>lines %1</source>
        <translation>rette %1</translation>
    </message>
    <message>
        <source>arcs %1</source>
        <translation>archi %1</translation>
    </message>
    <message>
        <source>splines %1</source>
        <translation>spline %1</translation>
    </message>
    <message>
        <source>median %1, largest %2</source>
        <translation>mediana %1, massima %2</translation>
    </message>
    <message>
        <source>%1 of 45° and more; sharpest %2° (%3)</source>
        <translation>%1 da 45° in su; il più acuto %2° (%3)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Segnalazioni (%1)</translation>
    </message>
    <message>
        <source>%1 without pauses</source>
        <translation>%1 senza pause</translation>
    </message>
    <message>
        <source>as detected</source>
        <translation>come riconosciuto</translation>
    </message>
    <message>
        <source>Read as %1, as selected.</source>
        <translation>Letto come %1, come scelto.</translation>
    </message>
    <message>
        <source>Read as %1: the text gives no evidence of its dialect.</source>
        <translation>Letto come %1: il testo non rivela il suo dialetto.</translation>
    </message>
    <message>
        <source>Read as %1 because of &quot;%2&quot;.</source>
        <translation>Letto come %1 per via di «%2».</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Accettato: %1</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Revoca</translation>
    </message>
    <message>
        <source>Take back %1</source>
        <translation>Revoca %1</translation>
    </message>
    <message>
        <source>Accept %1</source>
        <translation>Accetta %1</translation>
    </message>
    <message>
        <source>Rivulet does not understand %1. If you accept it, it is left out wherever the program has it, and the path is taken as if it were not there.

Is it certain that %1 does not change the path of the tool?</source>
        <translation>Rivulet non comprende %1. Se viene accettato, viene omesso ovunque compaia nel programma e il percorso vale come se non ci fosse.

È certo che %1 non cambia il percorso dell’utensile?</translation>
    </message>
    <message>
        <source>Accept and read again</source>
        <translation>Accetta e rileggi</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calcolo in corso…</translation>
    </message>
    <message>
        <source>Computed with the axes of %1</source>
        <translation>Calcolato con gli assi di %1</translation>
    </message>
    <message>
        <source>I, J, K are read as the centre itself</source>
        <translation>I, J, K sono letti come il centro stesso</translation>
    </message>
    <message>
        <source>I, J, K are read from the centre to the start</source>
        <translation>I, J, K sono letti dal centro all’inizio</translation>
    </message>
    <message>
        <source>Read I, J, K as usual</source>
        <translation>Leggi I, J, K come di consueto</translation>
    </message>
    <message>
        <source>Read it that way</source>
        <translation>Leggi così</translation>
    </message>
    <message>
        <source>Cannot be streamed: no axis moves.</source>
        <translation>Non trasmissibile: nessun asse si muove.</translation>
    </message>
    <message>
        <source>Cannot be streamed: it needs a transformation of the control.</source>
        <translation>Non trasmissibile: richiede una trasformazione del controllo.</translation>
    </message>
    <message numerus="yes">
        <source>%1 … %2 (%Ln values)</source>
        <translation>
            <numerusform>%1 … %2 (%Ln valore)</numerusform>
            <numerusform>%1 … %2 (%Ln valori)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 with %Ln pauses, which cost %2</source>
        <translation>
            <numerusform>%1 con %Ln pausa, che costa %2</numerusform>
            <numerusform>%1 con %Ln pause, che costano %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Live …</source>
        <translation>In diretta…</translation>
    </message>
    <message>
        <source>Points that another program computes while the machine moves</source>
        <translation>Punti che un altro programma calcola mentre la macchina si muove</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Testo</translation>
    </message>
    <message numerus="yes">
        <source>%Ln lines</source>
        <translation>
            <numerusform>%Ln riga</numerusform>
            <numerusform>%Ln righe</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramTextView</name>
    <message>
        <source>No program is loaded</source>
        <translation>Nessun programma caricato</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ReadingBar</name>
    <message>
        <source>a %1 goes to %2 mm</source>
        <translation>un %1 va a %2 mm</translation>
    </message>
    <message>
        <source>a %1 does not move</source>
        <translation>un %1 non si muove</translation>
    </message>
    <message>
        <source>Nothing shows for which control this program was made. From line %1 on, %2. Which is it?</source>
        <translation>Nulla mostra per quale controllo è stato fatto questo programma. Dalla riga %1: %2. Quale è?</translation>
    </message>
    <message>
        <source>The program does not say whether it is in mm or inch. Its size in mm, or in inch: %1.</source>
        <translation>Il programma non dice se è in mm o in pollici. La sua dimensione in mm, o in pollici: %1.</translation>
    </message>
    <message>
        <source>Coordinates have no decimal point. Some controls count them in thousandths. The size as whole units, or as thousandths: %1.</source>
        <translation>Le coordinate non hanno punto decimale. Alcuni controlli le contano in millesimi. La dimensione in unità intere, o in millesimi: %1.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pollici</translation>
    </message>
    <message>
        <source>Whole units</source>
        <translation>Unità intere</translation>
    </message>
    <message>
        <source>Thousandths</source>
        <translation>Millesimi</translation>
    </message>
    <message>
        <source>Take them</source>
        <translation>Usarle</translation>
    </message>
    <message>
        <source>The program leaves values to settings of the control. Enter those of the machine, or take those of a virtual machine.</source>
        <translation>Il programma lascia valori alle impostazioni del controllo. Inserite quelle della macchina, o usate quelle di una macchina virtuale.</translation>
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
        <translation>N, punti per loop</translation>
    </message>
    <message>
        <source>δ, mm</source>
        <translation>δ, mm</translation>
    </message>
    <message>
        <source>reach</source>
        <translation>portata</translation>
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
        <translation>t_min, ms: movimento più breve al 100&#xa0;%</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ReportPanel</name>
    <message>
        <source>Run</source>
        <translation>Esecuzione</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punti</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Access time per variable</source>
        <translation>Tempo di accesso per variabile</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durata</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Eseguiti</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Ripetuti</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Saltati</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Fuori dal programma</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Quantità</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Totale</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Richieste</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95º percentile</translation>
    </message>
    <message>
        <source>99th percentile</source>
        <translation>99º percentile</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Massimo</translation>
    </message>
    <message>
        <source>Stop confirmed</source>
        <translation>Stop confermato</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Nessuna esecuzione</translation>
    </message>
    <message>
        <source>%1 of %2 (not judged: longer than the trace of the control)</source>
        <translation>%1 di %2 (non valutato: più lungo della registrazione del controllo)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>%1 of %2 (not judged: no trace of the control)</source>
        <translation>%1 di %2 (non valutato: manca la registrazione del controllo)</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non valutato</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>dopo %1</translation>
    </message>
    <message>
        <source>NOT confirmed: check the machine</source>
        <translation>NON confermato: controllare la macchina</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>%1, from point %2 on</source>
        <translation>%1, dal punto %2</translation>
    </message>
    <message>
        <source>%1 (proved)</source>
        <translation>%1 (provata)</translation>
    </message>
    <message>
        <source>Time spent</source>
        <translation>Ripartizione del tempo</translation>
    </message>
    <message>
        <source>Live lines</source>
        <translation>Righe in diretta</translation>
    </message>
    <message>
        <source>Delay from arrival to motion</source>
        <translation>Ritardo dall’arrivo al movimento</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Utensili</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ResponsePanel</name>
    <message>
        <source>Bode plot: gain</source>
        <translation>Diagramma di Bode: guadagno</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frequenza, Hz</translation>
    </message>
    <message>
        <source>Gain, dB</source>
        <translation>Guadagno, dB</translation>
    </message>
    <message>
        <source>Bode plot: phase</source>
        <translation>Diagramma di Bode: fase</translation>
    </message>
    <message>
        <source>Phase, °</source>
        <translation>Fase, °</translation>
    </message>
    <message>
        <source>Answer to a step of 1 mm</source>
        <translation>Risposta a un gradino di 1 mm</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Tempo, s</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Posizione, mm</translation>
    </message>
    <message>
        <source>%1 follows up to %2 Hz (−3 dB).</source>
        <translation>%1 segue fino a %2 Hz (−3 dB).</translation>
    </message>
    <message>
        <source>From set point to actual position; the Bode plot is without friction.</source>
        <translation>Dal valore nominale alla posizione reale; il diagramma di Bode senza attrito.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ResumeBar</name>
    <message>
        <source>Not now</source>
        <translation>Non ora</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Asking the control where the run was left …</source>
        <translation>Si chiede al controllo dove l’esecuzione si è interrotta…</translation>
    </message>
    <message>
        <source>The run cannot be resumed: %1</source>
        <translation>L’esecuzione non può essere ripresa: %1</translation>
    </message>
    <message>
        <source>Press and hold: resume at point %1</source>
        <translation>Tenere premuto: riprende dal punto %1</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Tenere premuto per un secondo. Poi la macchina si muove.</translation>
    </message>
    <message>
        <source>Press and hold: start at point %1</source>
        <translation>Tenere premuto: avvia dal punto %1</translation>
    </message>
    <message>
        <source>Press and hold: go on with the job</source>
        <translation>Tenere premuto: continuare il lavoro</translation>
    </message>
    <message numerus="yes">
        <source>Before that, the control executes %Ln blocks: see the list.</source>
        <translation>
            <numerusform>Prima il controllo esegue %Ln blocco: vedere l’elenco.</numerusform>
            <numerusform>Prima il controllo esegue %Ln blocchi: vedere l’elenco.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing has moved yet. The run will start at point %1 of %2, where line %3 begins: %4.</source>
        <translation>Ancora non si è mosso nulla. L’esecuzione comincerà dal punto %1 di %2, dove inizia la riga %3: %4.</translation>
    </message>
    <message>
        <source>The tool first moves %1 in a straight line to that point.</source>
        <translation>L’utensile percorre prima %1 in linea retta fino a quel punto.</translation>
    </message>
    <message>
        <source>From point %1 on, the program differs from that of the interrupted run. None of these points has been executed: check the new path before you go on.</source>
        <translation>Dal punto %1 il programma è diverso da quello dell’esecuzione interrotta. Nessuno di questi punti è stato eseguito: controllare il nuovo percorso prima di continuare.</translation>
    </message>
    <message>
        <source>The program still stands on the control: first it executes the rest of its window, at most %1, and ends.</source>
        <translation>Il programma è ancora fermo sul controllo: prima esegue il resto della sua finestra, al massimo %1, e termina.</translation>
    </message>
    <message>
        <source>The program still stands on the control, between its windows: it ends without a move.</source>
        <translation>Il programma è ancora fermo sul controllo, tra le sue finestre: termina senza movimento.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The job will go on in part %1 at point %2 of %3, line %4.</source>
        <translation>Nulla si è ancora mosso. Il lavoro proseguirà nel tratto %1 al punto %2 di %3, riga %4.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The job will go on at line %1: %2.</source>
        <translation>Nulla si è ancora mosso. Il lavoro continuerà alla riga %1: %2.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The run will resume at point %1 of %2, line %3: %4.</source>
        <translation>Ancora non si è mosso nulla. L’esecuzione riprenderà dal punto %1 di %2, riga %3: %4.</translation>
    </message>
    <message>
        <source>Then the tool moves %1 in a straight line to that point.</source>
        <translation>Poi l’utensile percorre %1 in linea retta fino a quel punto.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RightsPage</name>
    <message>
        <source>not known</source>
        <translation>non noto</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manca</translation>
    </message>
    <message>
        <source>given</source>
        <translation>concesso</translation>
    </message>
    <message>
        <source>Asking the control …</source>
        <translation>Interrogazione del controllo…</translation>
    </message>
    <message>
        <source>A run is not possible with these rights.</source>
        <translation>Con questi diritti nessuna esecuzione è possibile.</translation>
    </message>
    <message>
        <source>A run is possible; some steps remain to the operator.</source>
        <translation>Un’esecuzione è possibile; alcuni passi restano all’operatore.</translation>
    </message>
    <message>
        <source>This user has all rights that a run needs.</source>
        <translation>Questo utente ha tutti i diritti necessari a un’esecuzione.</translation>
    </message>
    <message>
        <source>More than a run needs: %1. Call DeleteUserAccess with them, or use a user of its own for Rivulet.</source>
        <translation>Più di quanto serve a un’esecuzione: %1. Chiamare DeleteUserAccess con essi, o usare un utente proprio per Rivulet.</translation>
    </message>
    <message>
        <source>The server does not tell which other rights this user has. Look at the list of users on the control.</source>
        <translation>Il server non dice quali altri diritti ha questo utente. Vedere l’elenco degli utenti sul controllo.</translation>
    </message>
    <message>
        <source>Asks the control which of the rights that a run needs the user of this connection has. Nothing is changed.</source>
        <translation>Chiede al controllo quali dei diritti necessari a un’esecuzione ha l’utente di questa connessione. Nulla viene modificato.</translation>
    </message>
    <message>
        <source>Check the rights</source>
        <translation>Controlla i diritti</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunPanel</name>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Eseguiti</translation>
    </message>
    <message>
        <source>Start is not possible: %1</source>
        <translation>Avvio non possibile: %1</translation>
    </message>
    <message>
        <source>Ready to start</source>
        <translation>Pronto all’avvio</translation>
    </message>
    <message>
        <source>Stop confirmed after %1</source>
        <translation>Stop confermato dopo %1</translation>
    </message>
    <message>
        <source>Stop confirmed</source>
        <translation>Stop confermato</translation>
    </message>
    <message>
        <source>Stop NOT confirmed: check the machine</source>
        <translation>Stop NON confermato: controllare la macchina</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Riprendi…</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continua</translation>
    </message>
    <message>
        <source>The machine waits before the next window until you press Continue.</source>
        <translation>La macchina attende prima della finestra successiva finché non si preme Continua.</translation>
    </message>
    <message>
        <source>Only method window can hold.</source>
        <translation>Solo il metodo Finestra può sospendere.</translation>
    </message>
    <message>
        <source>Waiting for the test of the template on the virtual machine</source>
        <translation>Attende il test del modello sulla macchina virtuale</translation>
    </message>
    <message>
        <source>Waiting for the transfer of the template to the control</source>
        <translation>Attende il trasferimento del modello al controllo</translation>
    </message>
    <message>
        <source>Waiting for cycle start at the control</source>
        <translation>Attende Start NC sul controllo</translation>
    </message>
    <message>
        <source>Waiting for selection of the template and cycle start at the control</source>
        <translation>Attende la selezione del modello e Start NC sul controllo</translation>
    </message>
    <message>
        <source>Nothing comes from the control. Check cable, switch and server.</source>
        <translation>Dal controllo non arriva nulla. Controllare cavo, switch e server.</translation>
    </message>
    <message>
        <source>Waiting for the control&apos;s own trace</source>
        <translation>Attende la registrazione del controllo</translation>
    </message>
    <message>
        <source>Waiting for %1</source>
        <translation>Attende %1</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Tenere premuto</translation>
    </message>
    <message>
        <source>Start over …</source>
        <translation>Ricomincia…</translation>
    </message>
    <message>
        <source>Start …</source>
        <translation>Avvia…</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Tenere premuto per un secondo. Poi la macchina si muove.</translation>
    </message>
    <message>
        <source>Shows what will happen first. Nothing moves yet.</source>
        <translation>Mostra che cosa accadrà per prima cosa. Ancora non si muove nulla.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Pronto</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>Non pronto</translation>
    </message>
    <message>
        <source>Stopped at %1</source>
        <translation>Arrestato a %1</translation>
    </message>
    <message>
        <source>Failed at %1</source>
        <translation>Fallito a %1</translation>
    </message>
    <message>
        <source>Wrong motion</source>
        <translation>Movimento errato</translation>
    </message>
    <message>
        <source>The run has executed wrong points: see the report.</source>
        <translation>L’esecuzione ha eseguito punti errati: vedi il rapporto.</translation>
    </message>
    <message>
        <source>Resume goes on where the run was left.</source>
        <translation>Riprendi continua da dove l’esecuzione si è interrotta.</translation>
    </message>
    <message>
        <source>A new start begins at the first point.</source>
        <translation>Un nuovo avvio comincia dal primo punto.</translation>
    </message>
    <message>
        <source>Waiting until the claim of another client lapses, because it may be dead (10 s)</source>
        <translation>Attende che scada la prenotazione di un altro client, che potrebbe essere bloccato (10 s)</translation>
    </message>
    <message>
        <source>Wrong motion. %1</source>
        <translation>Movimento errato. %1</translation>
    </message>
    <message>
        <source>Watching run %1: it waits</source>
        <translation>Osserva l’esecuzione %1: attende</translation>
    </message>
    <message>
        <source>Watching run %1</source>
        <translation>Osserva l’esecuzione %1</translation>
    </message>
    <message>
        <source>A program waits on the control</source>
        <translation>Un programma attende sul controllo</translation>
    </message>
    <message>
        <source>Run %1 is on the control</source>
        <translation>L’esecuzione %1 è sul controllo</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Riga</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Resta</translation>
    </message>
    <message>
        <source>Points that are known to be executed</source>
        <translation>Punti che risultano eseguiti</translation>
    </message>
    <message>
        <source>Only the computer that streams this run knows it.</source>
        <translation>Lo sa solo il computer che trasmette questa esecuzione.</translation>
    </message>
    <message>
        <source>No program is loaded.</source>
        <translation>Nessun programma caricato.</translation>
    </message>
    <message>
        <source>No point has been executed yet.</source>
        <translation>Nessun punto è ancora stato eseguito.</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>L’esecuzione è finita.</translation>
    </message>
    <message>
        <source>The time of the run is not estimated yet. During a run nothing is estimated.</source>
        <translation>La durata dell’esecuzione non è ancora stimata. Durante un’esecuzione nulla viene stimato.</translation>
    </message>
    <message>
        <source>%1, pauses %2</source>
        <translation>%1, pause %2</translation>
    </message>
    <message>
        <source>Estimate of the time that is left, with the feeds and the planned pauses of this run. Hold and the feed override at the control are not included.</source>
        <translation>Tempo residuo stimato, con gli avanzamenti e le pause previste di questa esecuzione. La sospensione e l’override del controllo non sono compresi.</translation>
    </message>
    <message>
        <source>No run of this window is in progress.</source>
        <translation>Nessuna esecuzione di questa finestra è in corso.</translation>
    </message>
    <message>
        <source>%1: part %2 of %3</source>
        <translation>%1: tratto %2 di %3</translation>
    </message>
    <message>
        <source>%1: the control, line %2</source>
        <translation>%1: controllo, riga %2</translation>
    </message>
    <message>
        <source>%1: the control</source>
        <translation>%1: controllo</translation>
    </message>
    <message>
        <source>The program waits for cycle start at the control</source>
        <translation>Il programma attende Start NC sul controllo</translation>
    </message>
    <message>
        <source>The job waits before the next block until you press Continue.</source>
        <translation>Il lavoro attende prima del blocco successivo finché si preme Continua.</translation>
    </message>
    <message>
        <source>Before part %1 of %2</source>
        <translation>Prima del tratto %1 di %2</translation>
    </message>
    <message>
        <source>After the last part</source>
        <translation>Dopo l’ultimo tratto</translation>
    </message>
    <message>
        <source>Streamed %1, pauses %2, tool changes %3, other blocks of the control %4. Cycles, measuring and stops are not included.</source>
        <translation>Trasmesso %1, pause %2, cambi utensile %3, altri blocchi del controllo %4. Cicli, misure e arresti non sono compresi.</translation>
    </message>
    <message>
        <source>%1, pauses %2, control %3</source>
        <translation>%1, pause %2, controllo %3</translation>
    </message>
    <message>
        <source>%1, control %2</source>
        <translation>%1, controllo %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows</source>
        <translation>
            <numerusform>%Ln finestra</numerusform>
            <numerusform>%Ln finestre</numerusform>
        </translation>
    </message>
    <message>
        <source>Points that are known to be executed, from point %1 on</source>
        <translation>Punti che risultano eseguiti, a partire dal punto %1</translation>
    </message>
    <message>
        <source>%1, dry run</source>
        <translation>%1, prova a vuoto</translation>
    </message>
    <message>
        <source>The live source is silent or wants a hold. The run goes on with its next point.</source>
        <translation>La sorgente in diretta è muta o vuole una sospensione. L’esecuzione continua con il suo prossimo punto.</translation>
    </message>
    <message>
        <source>Waiting for points of the live source</source>
        <translation>Attende punti della sorgente in diretta</translation>
    </message>
    <message>
        <source>A live source does not say when it ends.</source>
        <translation>Una sorgente in diretta non dice quando finisce.</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Termina qui</translation>
    </message>
    <message>
        <source>Hold for one second: the run ends. First the axes execute what the control still has of the window, with this override.</source>
        <translation>Tenere premuto un secondo: l&apos;esecuzione termina. Prima gli assi eseguono con questo override ciò che il controllo ha ancora della finestra.</translation>
    </message>
    <message>
        <source>What moves now does not obey the override. Press NC STOP at the machine.</source>
        <translation>Ciò che si muove ora non segue l&apos;override. Premere NC STOP sulla macchina.</translation>
    </message>
    <message>
        <source>Another client has set the override to %1 %</source>
        <translation>Un altro client ha impostato l&apos;override al %1 %</translation>
    </message>
    <message>
        <source>The axes are braking</source>
        <translation>Gli assi frenano</translation>
    </message>
    <message>
        <source>Override 0 %: the axes stand</source>
        <translation>Override 0 %: gli assi sono fermi</translation>
    </message>
    <message>
        <source>The axes stand at once, until you press Continue.</source>
        <translation>Gli assi si fermano subito, finché non si preme Continua.</translation>
    </message>
    <message>
        <source>The axes stand (%1 after the order). Continue goes on, End here ends the run</source>
        <translation>Gli assi sono fermi (%1 dopo l&apos;ordine). Continua prosegue, Termina qui termina l&apos;esecuzione</translation>
    </message>
    <message>
        <source>Stop and Pause act at the end of the block</source>
        <translation>Stop e Pausa agiscono alla fine del blocco</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Its axes are held until the run is ended or resumed.</source>
        <translation>I suoi assi sono trattenuti finché l’esecuzione non viene terminata o ripresa.</translation>
    </message>
    <message>
        <source>This window only shows it. Stop holds its axes.</source>
        <translation>Questa finestra la mostra soltanto. Stop trattiene i suoi assi.</translation>
    </message>
    <message>
        <source>This window did not start it. Stop holds its axes.</source>
        <translation>Questa finestra non l’ha avviata. Stop trattiene i suoi assi.</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves yet.</source>
        <translation>Chiede al controllo dove l’esecuzione si è interrotta. Ancora non si muove nulla.</translation>
    </message>
    <message>
        <source>Line of the live source of the move that the tool is on</source>
        <translation>Riga della sorgente live del movimento su cui si trova l’utensile</translation>
    </message>
    <message>
        <source>Line of the program of the move that the tool is on</source>
        <translation>Riga del programma del movimento su cui si trova l’utensile</translation>
    </message>
    <message>
        <source>The tool is lifted by %1. Lower it, then the run can go on</source>
        <translation>L’utensile è sollevato di %1. Abbassarlo, poi l’esecuzione può proseguire</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Abbassa</translation>
    </message>
    <message>
        <source>Lift by %1</source>
        <translation>Solleva di %1</translation>
    </message>
    <message>
        <source>The tool goes back to where it stood.</source>
        <translation>L’utensile torna dove si trovava.</translation>
    </message>
    <message>
        <source>The tool goes straight up; the path waits.</source>
        <translation>L’utensile sale in verticale; il percorso attende.</translation>
    </message>
    <message>
        <source>Continue goes on without it</source>
        <translation>Continua prosegue senza</translation>
    </message>
    <message>
        <source>stands in %1</source>
        <translation>fermo in %1</translation>
    </message>
    <message>
        <source>The axes stand at once if the program obeys this computer&apos;s override, else at the end of its window. Escape does the same, from anywhere in the window. It does not replace the machine&apos;s emergency stop.</source>
        <translation>Gli assi si fermano subito se il programma obbedisce all&apos;override di questo computer, altrimenti alla fine della sua finestra. Esc fa lo stesso, da qualsiasi punto. Non sostituisce l&apos;arresto di emergenza della macchina.</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Flusso</translation>
    </message>
    <message>
        <source>Sent to the control: %1, confirmed by it: %2</source>
        <translation>Inviati al controllo: %1, confermati: %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln moves in hand</source>
        <translation>
            <numerusform>%Ln movimento pronto</numerusform>
            <numerusform>%Ln movimenti pronti</numerusform>
        </translation>
    </message>
    <message>
        <source>Moves in hand: what the control has and has not executed yet.</source>
        <translation>Movimenti pronti: ciò che il controllo ha e non ha ancora eseguito.</translation>
    </message>
    <message>
        <source>late, %1</source>
        <translation>in ritardo, %1</translation>
    </message>
    <message>
        <source>on time, %1</source>
        <translation>in tempo, %1</translation>
    </message>
    <message>
        <source>Margin %1: time until the control needs the next point, minus the 99th percentile of the access time</source>
        <translation>Margine %1: tempo fino a quando il controllo ha bisogno del punto successivo, meno il 99º percentile del tempo di accesso</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunsModel</name>
    <message>
        <source>Time</source>
        <translation>Ora</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Risultato</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metodo</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Eseguito</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 di %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Ripetuti</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Saltati</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durata</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Chi</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunsPage</name>
    <message>
        <source>Save</source>
        <translation>Salva</translation>
    </message>
    <message>
        <source>Open a report</source>
        <translation>Apri un rapporto</translation>
    </message>
    <message>
        <source>Reports (*.json)</source>
        <translation>Rapporti (*.json)</translation>
    </message>
    <message>
        <source>All machines</source>
        <translation>Tutte le macchine</translation>
    </message>
    <message>
        <source>Runs: %1</source>
        <translation>Esecuzioni: %1</translation>
    </message>
    <message>
        <source>Runs: %1 of %2</source>
        <translation>Esecuzioni: %1 di %2</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Nessuna esecuzione</translation>
    </message>
    <message>
        <source>No run is selected.</source>
        <translation>Nessuna esecuzione è selezionata.</translation>
    </message>
    <message>
        <source>%1, %2, version %3, %4</source>
        <translation>%1, %2, versione %3, %4</translation>
    </message>
    <message>
        <source>The run was not recorded.</source>
        <translation>L’esecuzione non è stata registrata.</translation>
    </message>
    <message>
        <source>Loads the program, compares it with the one of the run, and sets method and settings. Nothing starts.</source>
        <translation>Carica il programma, lo confronta con quello dell’esecuzione e riprende metodo e impostazioni. Nulla si avvia.</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves.</source>
        <translation>Chiede al controllo dove si è interrotta l’esecuzione. Nulla si muove.</translation>
    </message>
    <message>
        <source>Only a run that was left on the connected control, with its program loaded, can be resumed.</source>
        <translation>Si può riprendere solo un’esecuzione interrotta sul controllo connesso, con il suo programma caricato.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>Shows runs in which each word stands in some column</source>
        <translation>Mostra le esecuzioni in cui ogni parola compare in una colonna</translation>
    </message>
    <message>
        <source>Search runs</source>
        <translation>Cerca esecuzioni</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Risultato</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Esecuzioni</translation>
    </message>
    <message>
        <source>All results</source>
        <translation>Tutti i risultati</translation>
    </message>
    <message>
        <source>Faultless</source>
        <translation>Senza errori</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Non valutato</translation>
    </message>
    <message>
        <source>Failed or wrong</source>
        <translation>Fallito o errato</translation>
    </message>
    <message>
        <source>Table as CSV…</source>
        <translation>Tabella in CSV…</translation>
    </message>
    <message>
        <source>Open a report…</source>
        <translation>Apri un rapporto…</translation>
    </message>
    <message>
        <source>A report that was exported here or printed by stream --json</source>
        <translation>Un rapporto esportato qui o scritto da stream --json</translation>
    </message>
    <message>
        <source>Open in Traces</source>
        <translation>Apri in Curve</translation>
    </message>
    <message>
        <source>Repeat with these settings</source>
        <translation>Ripeti con queste impostazioni</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Riprendi</translation>
    </message>
    <message>
        <source>Page as PDF…</source>
        <translation>Pagina in PDF…</translation>
    </message>
    <message>
        <source>JSON…</source>
        <translation>JSON…</translation>
    </message>
    <message>
        <source>Keep at most</source>
        <translation>Conservare al massimo</translation>
    </message>
    <message>
        <source> runs</source>
        <translation> esecuzioni</translation>
    </message>
    <message>
        <source>Number of runs that are kept</source>
        <translation>Numero di esecuzioni conservate</translation>
    </message>
    <message>
        <source>Size of reports and recordings that are kept</source>
        <translation>Dimensione di rapporti e registrazioni conservati</translation>
    </message>
    <message>
        <source>Others that cannot be shown: %1</source>
        <translation>Altre che non possono essere mostrate: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ScopeCurves</name>
    <message>
        <source>Time, s</source>
        <translation>Tempo, s</translation>
    </message>
    <message>
        <source>Path, mm</source>
        <translation>Percorso, mm</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>punto %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ScopePane</name>
    <message>
        <source>Remove %1</source>
        <translation>Rimuovi %1</translation>
    </message>
    <message>
        <source>Remove the pane</source>
        <translation>Rimuovi il riquadro</translation>
    </message>
    <message>
        <source>Curves: %1</source>
        <translation>Curve: %1</translation>
    </message>
    <message>
        <source>%1 to %2, from %3 to %4</source>
        <translation>da %1 a %2, da %3 a %4</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SeriesModel</name>
    <message>
        <source>The control refused arrays of this size.</source>
        <translation>Il controllo ha rifiutato array di questa dimensione.</translation>
    </message>
    <message>
        <source>%1 were requested; there was no time for more.</source>
        <translation>Ne erano richieste %1; non c’era tempo per altre.</translation>
    </message>
    <message>
        <source>write</source>
        <translation>scrittura</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lettura</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>rifiutato</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accesso</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Misure</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Massimo</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parametri R</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ServiceCard</name>
    <message>
        <source>Service at %1</source>
        <translation>Servizio %1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Remove this service from the board? It goes on with its work.</source>
        <translation>Togliere questo servizio dal quadro? Il suo lavoro continua.</translation>
    </message>
    <message>
        <source>Shows what the service says, and what can be done with it.</source>
        <translation>Mostra che cosa comunica il servizio e che cosa si può fare.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ServicePanel</name>
    <message>
        <source>Service at %1</source>
        <translation>Servizio %1</translation>
    </message>
    <message>
        <source>Service at %1, %2</source>
        <translation>Servizio %1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows late</source>
        <translation>
            <numerusform>%Ln finestra in ritardo</numerusform>
            <numerusform>%Ln finestre in ritardo</numerusform>
        </translation>
    </message>
    <message>
        <source>What Resume will do</source>
        <translation>Che cosa farà la ripresa</translation>
    </message>
    <message>
        <source>What Start will do</source>
        <translation>Che cosa farà l’avvio</translation>
    </message>
    <message>
        <source>The service is working on it …</source>
        <translation>Il servizio ci sta lavorando…</translation>
    </message>
    <message>
        <source>Nobody is logged in.</source>
        <translation>Nessuno ha effettuato l’accesso.</translation>
    </message>
    <message>
        <source>Logged in: %1</source>
        <translation>Accesso: %1</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continua</translation>
    </message>
    <message>
        <source>Hold to resume</source>
        <translation>Tenere premuto</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Tenere premuto</translation>
    </message>
    <message>
        <source>Start …</source>
        <translation>Avvia…</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Tenere premuto per un secondo. Poi la macchina si muove.</translation>
    </message>
    <message>
        <source>Shows what will happen first. Nothing moves yet.</source>
        <translation>Mostra che cosa accadrà per prima cosa. Ancora non si muove nulla.</translation>
    </message>
    <message>
        <source>Log in …</source>
        <translation>Accedi…</translation>
    </message>
    <message>
        <source>Change user …</source>
        <translation>Cambia utente…</translation>
    </message>
    <message>
        <source>All machines</source>
        <translation>Tutte le macchine</translation>
    </message>
    <message>
        <source>Back to the board. The run goes on.</source>
        <translation>Torna al quadro. L’esecuzione continua.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <source>Ends the run of this machine after the window in motion. It does not replace the machine&apos;s emergency stop.</source>
        <translation>Termina l’esecuzione di questa macchina dopo la finestra in corso. Non sostituisce l’arresto d’emergenza della macchina.</translation>
    </message>
    <message>
        <source>The machine waits before the next window until you press Continue.</source>
        <translation>La macchina attende prima della finestra successiva finché non si preme Continua.</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Riprendi…</translation>
    </message>
    <message>
        <source>&amp;Program</source>
        <translation>&amp;Programma</translation>
    </message>
    <message>
        <source>The service reads it in its folder of programs.</source>
        <translation>Il servizio lo legge nella sua cartella dei programmi.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programma</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Carica</translation>
    </message>
    <message>
        <source>The service reads the program and judges it. Nothing moves.</source>
        <translation>Il servizio legge il programma e lo giudica. Nulla si muove.</translation>
    </message>
    <message>
        <source>This service has users: log in before you give it commands.</source>
        <translation>Un servizio con utenti accetta ordini solo da chi ha effettuato l’accesso.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nome</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>P&amp;IN</translation>
    </message>
    <message>
        <source>A user of the service; empty: nobody.</source>
        <translation>Un utente del servizio; vuoto: nessuno.</translation>
    </message>
    <message>
        <source>It is not kept.</source>
        <translation>Non viene conservato.</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Accedi</translation>
    </message>
    <message>
        <source>Connects again as this user.</source>
        <translation>Si riconnette come questo utente.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>These buttons act on %1. Those at the bottom of the window act on the machine that the window is connected with.</source>
        <translation>Questi pulsanti agiscono su %1. Quelli in fondo alla finestra agiscono sulla macchina a cui è connessa la finestra.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Termina qui</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves yet.</source>
        <translation>Chiede al controllo dove l’esecuzione si è interrotta. Ancora non si muove nulla.</translation>
    </message>
    <message>
        <source>choose or type a file in the folder of the service</source>
        <translation>scegliere o digitare un file nella cartella del servizio</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SetUpPage</name>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SignalPanel</name>
    <message>
        <source>Say what the columns of the file mean</source>
        <translation>Dire che cosa significano le colonne del file</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>Colonne…</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>mostrato</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Cerca</translation>
    </message>
    <message>
        <source>Search the signals</source>
        <translation>Cerca tra i segnali</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Segnali</translation>
    </message>
    <message>
        <source>Pane</source>
        <translation>Riquadro</translation>
    </message>
    <message>
        <source>Show the signal in a pane of its own (Enter)</source>
        <translation>Mostra il segnale in un proprio riquadro (Invio)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Aggiungi</translation>
    </message>
    <message>
        <source>Show the signal in the current pane (Shift+Enter)</source>
        <translation>Mostra il segnale nel riquadro attuale (Maiusc+Invio)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Remove the signal from the panes (Delete)</source>
        <translation>Non mostrare più il segnale (Canc)</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formula</translation>
    </message>
    <message>
        <source>A formula of signals, then Enter. Their names are in their tool tips.</source>
        <translation>Una formula di segnali, poi Invio. I nomi sono nei loro suggerimenti.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SpectrumPanel</name>
    <message>
        <source>Frequencies need the time axis: choose it under Compare.</source>
        <translation>Le frequenze richiedono l’asse del tempo: sceglierlo in Confronto.</translation>
    </message>
    <message>
        <source>No curve is shown.</source>
        <translation>Nessuna curva è mostrata.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Ampiezza</translation>
    </message>
    <message>
        <source>Amplitude, %1</source>
        <translation>Ampiezza, %1</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frequenza, Hz</translation>
    </message>
    <message>
        <source>Peak, Hz</source>
        <translation>Picco, Hz</translation>
    </message>
    <message>
        <source>Between the cursors: %1 samples, %2 Hz</source>
        <translation>Tra i cursori: %1 campioni, %2 Hz</translation>
    </message>
    <message>
        <source>In the time shown: %1 samples, %2 Hz</source>
        <translation>Nel tempo visibile: %1 campioni, %2 Hz</translation>
    </message>
    <message>
        <source>The samples are not evenly spaced: values between them were interpolated.</source>
        <translation>I campioni non sono regolari: le rette tra essi sono state ricampionate.</translation>
    </message>
    <message>
        <source>Curve whose frequencies are shown</source>
        <translation>Curva di cui si mostrano le frequenze</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spettro</translation>
    </message>
    <message>
        <source>Peaks of the spectrum</source>
        <translation>Picchi dello spettro</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::StartSteps</name>
    <message>
        <source>Start a virtual machine</source>
        <translation>Avvia una macchina virtuale</translation>
    </message>
    <message>
        <source>Connect to a control …</source>
        <translation>Collega un controllo …</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Apri …</translation>
    </message>
    <message>
        <source>Live …</source>
        <translation>Dal vivo …</translation>
    </message>
    <message>
        <source>Points from a program or a sensor, while they are made</source>
        <translation>Punti da un programma o da un sensore, mentre nascono</translation>
    </message>
    <message>
        <source>Three steps to a moving machine</source>
        <translation>Tre passi verso una macchina in moto</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Collegare</translation>
    </message>
    <message>
        <source>Your control by its address, or a virtual machine on this computer: the same program, and nothing real moves.</source>
        <translation>Il controllo con il suo indirizzo, o una macchina virtuale su questo computer: lo stesso programma, e nulla di reale si muove.</translation>
    </message>
    <message>
        <source>Open a program</source>
        <translation>Aprire un programma</translation>
    </message>
    <message>
        <source>Any CAM program: SINUMERIK, ISO, LinuxCNC, Grbl, Heidenhain. Or the sample.</source>
        <translation>Qualsiasi programma CAM: SINUMERIK, ISO, LinuxCNC, Grbl, Heidenhain. O l&apos;esempio.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Avviare</translation>
    </message>
    <message>
        <source>Start, below at the right, checks travel, tools and data rate, shows the first move, and waits for you.</source>
        <translation>Avvia, in basso a destra, controlla corse, utensili e flusso di dati, mostra il primo movimento e aspetta.</translation>
    </message>
    <message>
        <source>Nothing moves before you hold Start.</source>
        <translation>Nulla si muove prima che si tenga premuto Avvia.</translation>
    </message>
    <message>
        <source>Sample: %1</source>
        <translation>Esempio: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::StopModel</name>
    <message>
        <source>Start</source>
        <translation>Inizio</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durata</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Riga</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Causa</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TaskPanel</name>
    <message>
        <source>Task</source>
        <translation>Compito</translation>
    </message>
    <message>
        <source>G code receiving</source>
        <translation>Ricezione del codice G</translation>
    </message>
    <message>
        <source>Interpreter</source>
        <translation>Interprete</translation>
    </message>
    <message>
        <source>Discrete</source>
        <translation>Interpolazione grossolana</translation>
    </message>
    <message>
        <source>Forward-looking</source>
        <translation>Look-ahead</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolazione</translation>
    </message>
    <message>
        <source>Position control</source>
        <translation>Controllo di posizione</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Avvii</translation>
    </message>
    <message>
        <source>Data, ms</source>
        <translation>Dati, ms</translation>
    </message>
    <message>
        <source>Processor, ms</source>
        <translation>Processore, ms</translation>
    </message>
    <message>
        <source>Mean, µs</source>
        <translation>Media, µs</translation>
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
        <translation>Interrotto</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Buffer</translation>
    </message>
    <message>
        <source>Open a recording of the tasks</source>
        <translation>Aprire una registrazione dei compiti</translation>
    </message>
    <message>
        <source>Save what the scheduler did</source>
        <translation>Salvare ciò che lo scheduler ha fatto</translation>
    </message>
    <message>
        <source>Executes a program on virtual axes. No machine moves.</source>
        <translation>Esegue un programma su assi virtuali. Nessuna macchina si muove.</translation>
    </message>
    <message>
        <source>%1: %2, %3 set points</source>
        <translation>%1: %2, %3 valori nominali</translation>
    </message>
    <message>
        <source>%1 has ended: %2, %3 set points</source>
        <translation>%1 è finito: %2, %3 valori nominali</translation>
    </message>
    <message>
        <source>%1 was stopped: %2, %3 set points</source>
        <translation>%1 è stato fermato: %2, %3 valori nominali</translation>
    </message>
    <message>
        <source>Recording %1: %2, %3 set points</source>
        <translation>Registrazione %1: %2, %3 valori nominali</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>Esempio</translation>
    </message>
    <message>
        <source>Program that the tasks execute</source>
        <translation>Programma che i compiti eseguono</translation>
    </message>
    <message>
        <source>Task dependency</source>
        <translation>Dipendenza dei compiti</translation>
    </message>
    <message>
        <source>Data flow</source>
        <translation>Flusso di dati</translation>
    </message>
    <message>
        <source>Earliest starvation</source>
        <translation>Prima carenza</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Costante</translation>
    </message>
    <message>
        <source>Which task gets the processor</source>
        <translation>Quale compito ottiene il processore</translation>
    </message>
    <message>
        <source>Processors: %1</source>
        <translation>Processori: %1</translation>
    </message>
    <message>
        <source>How many tasks run at a time</source>
        <translation>Quanti compiti girano insieme</translation>
    </message>
    <message>
        <source>Cycle %1 ms</source>
        <translation>Ciclo %1 ms</translation>
    </message>
    <message>
        <source>Cycle of position control</source>
        <translation>Ciclo del controllo di posizione</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Tempo reale</translation>
    </message>
    <message>
        <source>Position control comes before everything else on this computer</source>
        <translation>Il controllo di posizione viene prima di tutto il resto su questo computer</translation>
    </message>
    <message>
        <source>Without real time, other programs of this computer can delay position control.</source>
        <translation>Senza tempo reale, altri programmi di questo computer possono ritardare il controllo di posizione.</translation>
    </message>
    <message>
        <source>This computer does not allow real-time scheduling: position control runs like any other program, and others can delay it.</source>
        <translation>Questo computer non permette il tempo reale: il controllo di posizione gira come ogni altro programma, e altri possono ritardarlo.</translation>
    </message>
    <message>
        <source>Execute</source>
        <translation>Esegui</translation>
    </message>
    <message>
        <source>Execute the program in six tasks, on virtual axes</source>
        <translation>Eseguire il programma in sei compiti, su assi virtuali</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Termina</translation>
    </message>
    <message>
        <source>End the tasks; the virtual axes stand</source>
        <translation>Terminare i compiti; gli assi virtuali si fermano</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Open a recording of a scheduler</source>
        <translation>Aprire la registrazione di uno scheduler</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>Tasks: starts, waiting for data and for a processor, time of a step</source>
        <translation>Compiti: avvii, attesa di dati e di un processore, durata di un passo</translation>
    </message>
    <message>
        <source>Levels of the buffers</source>
        <translation>Livelli dei buffer</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Tempo, s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Livello</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TemplatePage</name>
    <message>
        <source>Save the template</source>
        <translation>Salva il modello</translation>
    </message>
    <message>
        <source>NC programs (*.MPF *.mpf)</source>
        <translation>Programmi NC (*.MPF *.mpf)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>No template: %1</source>
        <translation>Nessun modello: %1</translation>
    </message>
    <message>
        <source>No template yet</source>
        <translation>Ancora nessun modello</translation>
    </message>
    <message>
        <source>%1, layout number %2</source>
        <translation>%1, numero di layout %2</translation>
    </message>
    <message>
        <source>Flexible program</source>
        <translation>Programma flessibile</translation>
    </message>
    <message>
        <source>Save the steps</source>
        <translation>Salva i passi</translation>
    </message>
    <message>
        <source>Steps to print…</source>
        <translation>Passi da stampare…</translation>
    </message>
    <message>
        <source>A page with the steps at the control, the rights, what the operator sees, and how it is taken back</source>
        <translation>Una pagina con i passi sul controllo, i diritti, che cosa vede l’operatore e come rimuovere tutto</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parametri R</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TextPane</name>
    <message>
        <source>Lines with this text</source>
        <translation>Righe con questo testo</translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Cerca (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search the program text</source>
        <translation>Cerca nel programma</translation>
    </message>
    <message>
        <source>Previous line with this text</source>
        <translation>Riga precedente con questo testo</translation>
    </message>
    <message>
        <source>Next line with this text</source>
        <translation>Riga successiva con questo testo</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Riga</translation>
    </message>
    <message>
        <source>Go to a line (Ctrl+G)</source>
        <translation>Vai a una riga (Ctrl+G)</translation>
    </message>
    <message>
        <source>Go to line</source>
        <translation>Vai alla riga</translation>
    </message>
    <message>
        <source>Follow the run</source>
        <translation>Segui l’esecuzione</translation>
    </message>
    <message>
        <source>The text shows the line that is being executed</source>
        <translation>Il testo mostra la riga in esecuzione</translation>
    </message>
    <message>
        <source>Previous part, or blocks that the control executes (Ctrl+Page Up)</source>
        <translation>Tratto precedente, o blocchi eseguiti dal controllo (Ctrl+Pag su)</translation>
    </message>
    <message>
        <source>Next part, or blocks that the control executes (Ctrl+Page Down)</source>
        <translation>Tratto successivo, o blocchi eseguiti dal controllo (Ctrl+Pag giù)</translation>
    </message>
    <message>
        <source>Run from here …</source>
        <translation>Esegui da qui…</translation>
    </message>
    <message>
        <source>Start at the chosen line. First it is shown what would move.</source>
        <translation>Avvia dalla riga scelta. Prima viene mostrato che cosa si muoverebbe.</translation>
    </message>
    <message>
        <source>Search the text (Ctrl+F), or go to a line (Ctrl+G)</source>
        <translation>Cercare nel testo (Ctrl+F) o andare a una riga (Ctrl+G)</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TimeStrip</name>
    <message>
        <source>Overview of the whole trace</source>
        <translation>Panoramica dell’intera traccia</translation>
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
        <translation>Percorso</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>In diretta</translation>
    </message>
    <message>
        <source>Follow the newest samples</source>
        <translation>Segui i campioni più recenti</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostra tutto</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Quantità</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Totale</translation>
    </message>
    <message>
        <source>No samples yet</source>
        <translation>Ancora nessun campione</translation>
    </message>
    <message>
        <source>Live samples: read while the stream has time; short pauses may be missing from the curves</source>
        <translation>Campioni in diretta: letti quando la trasmissione lascia tempo; nelle curve possono mancare pause brevi</translation>
    </message>
    <message>
        <source>The control&apos;s own trace: one sample every %1</source>
        <translation>Registrazione del controllo: un campione ogni %1</translation>
    </message>
    <message>
        <source>%1: pause %2</source>
        <translation>%1: pausa %2</translation>
    </message>
    <message>
        <source>Run of %1, %2. </source>
        <translation>Esecuzione del %1, %2. </translation>
    </message>
    <message>
        <source>Open traces</source>
        <translation>Apri tracce</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Tracce</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Tutti i file</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Elenco</translation>
    </message>
    <message>
        <source>Open recordings and traces; several are shown on one time axis</source>
        <translation>Apri registrazioni e tracce; più file su un unico asse dei tempi</translation>
    </message>
    <message>
        <source>Wheel: zoom. Drag: move. Ctrl and drag: zoom into a range. Click: cursor A. Shift and click: cursor B. Home: show all.</source>
        <translation>Rotellina: ingrandisci. Trascina: sposta. Ctrl e trascina: ingrandisci un intervallo. Clic: cursore A. Maiusc e clic: cursore B. Home: mostra tutto.</translation>
    </message>
    <message>
        <source>Stops, signals and cursors beside the curves</source>
        <translation>Arresti, segnali e cursori accanto alle curve</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Arresti</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Segnali</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursori</translation>
    </message>
    <message>
        <source>%1: one sample every %2</source>
        <translation>%1: un campione ogni %2</translation>
    </message>
    <message>
        <source>Looking for stops …</source>
        <translation>Ricerca degli arresti…</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lettura di %1…</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Confronto</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spettro</translation>
    </message>
    <message>
        <source>Samples as a table</source>
        <translation>Campioni come tabella</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Immagine</translation>
    </message>
    <message>
        <source>Save what the panes show</source>
        <translation>Salva ciò che mostrano i riquadri</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 non può essere scritto. Scegliere un’altra cartella.</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Riquadri</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>Arrangements of panes that are kept by name</source>
        <translation>Disposizioni dei riquadri conservate con un nome</translation>
    </message>
    <message>
        <source>Save what the panes show: the samples as a table (CSV), or a picture (PNG, SVG, PDF)</source>
        <translation>Salva ciò che mostrano i riquadri: i campioni come tabella (CSV) o un’immagine (PNG, SVG, PDF)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Salvato: %1</translation>
    </message>
    <message>
        <source>Shown beside the panes</source>
        <translation>Mostrato accanto alle curve</translation>
    </message>
    <message>
        <source>Samples and events as HDF5</source>
        <translation>Campioni ed eventi come HDF5</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TriggerPanel</name>
    <message>
        <source>The signal must go back this far before the trigger can fire again</source>
        <translation>Il segnale deve tornare indietro di tanto prima che il trigger possa scattare di nuovo</translation>
    </message>
    <message>
        <source>An armed trigger stops the live view when it fires and shows what was before and after</source>
        <translation>Un trigger armato ferma la vista in diretta quando scatta e mostra il prima e il dopo</translation>
    </message>
    <message>
        <source>Once: what was caught stays. Every time: the next one takes its place.</source>
        <translation>Una volta: ciò che è stato catturato resta. Ogni volta: il prossimo ne prende il posto.</translation>
    </message>
    <message>
        <source>How much is shown after the trigger</source>
        <translation>Quanto si mostra dopo lo scatto</translation>
    </message>
    <message>
        <source>How much is shown before the trigger</source>
        <translation>Quanto si mostra prima dello scatto</translation>
    </message>
    <message>
        <source>Upper end of the range</source>
        <translation>Estremo superiore dell’intervallo</translation>
    </message>
    <message>
        <source>Lower end of the range</source>
        <translation>Estremo inferiore dell’intervallo</translation>
    </message>
    <message>
        <source>Value at which the trigger fires</source>
        <translation>Valore al quale il trigger scatta</translation>
    </message>
    <message>
        <source>What the trigger waits for</source>
        <translation>Che cosa attende il trigger</translation>
    </message>
    <message>
        <source>The signal that is watched during a run</source>
        <translation>Il segnale osservato durante un’esecuzione</translation>
    </message>
    <message>
        <source>every time (normal)</source>
        <translation>ogni volta (normal)</translation>
    </message>
    <message>
        <source>once (single)</source>
        <translation>una volta (single)</translation>
    </message>
    <message>
        <source>an alarm comes</source>
        <translation>arriva un allarme</translation>
    </message>
    <message>
        <source>a pause begins</source>
        <translation>inizia una pausa</translation>
    </message>
    <message>
        <source>it is outside the range</source>
        <translation>è fuori dall’intervallo</translation>
    </message>
    <message>
        <source>it is within the range</source>
        <translation>è nell’intervallo</translation>
    </message>
    <message>
        <source>it is at the level or below</source>
        <translation>è al livello o sotto</translation>
    </message>
    <message>
        <source>it is at the level or above</source>
        <translation>è al livello o sopra</translation>
    </message>
    <message>
        <source>it falls through the level</source>
        <translation>scende sotto il livello</translation>
    </message>
    <message>
        <source>it rises through the level</source>
        <translation>sale oltre il livello</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Scatta</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Dopo</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Prima</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>Isteresi</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Da</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Livello</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Quando</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Segnale</translation>
    </message>
    <message>
        <source>Waiting for the next run</source>
        <translation>Attende la prossima esecuzione</translation>
    </message>
    <message>
        <source>Waiting for the trigger</source>
        <translation>Attende il trigger</translation>
    </message>
    <message>
        <source>Triggered at %1. Waiting for the next</source>
        <translation>Scattato a %1. Attende il prossimo</translation>
    </message>
    <message>
        <source>Triggered: waiting for the time after it</source>
        <translation>Scattato: attende il tempo successivo</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Non armato</translation>
    </message>
    <message>
        <source>Triggered at %1. Cursor A is there.</source>
        <translation>Scattato a %1. Lì si trova il cursore A.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Arma</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Disarma</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TrustSheet</name>
    <message>
        <source>Is this the right machine?</source>
        <translation>È la macchina giusta?</translation>
    </message>
    <message>
        <source>The machine shows another certificate</source>
        <translation>La macchina mostra un altro certificato</translation>
    </message>
    <message>
        <source>The machine does not offer sufficient encryption</source>
        <translation>La macchina non offre una cifratura sufficiente</translation>
    </message>
    <message>
        <source>This computer has not connected to it before. Compare the fingerprint with the one that the control shows. If they are equal, accept it: from then on, only this certificate is trusted at this address.</source>
        <translation>Questo computer la incontra per la prima volta. Confrontare l’impronta con quella mostrata dal controllo. Se sono uguali, accettare: da allora, a questo indirizzo è fidato solo questo certificato.</translation>
    </message>
    <message>
        <source>Either somebody has renewed the certificate of the control, or another computer answers at its address and would get all commands. Ask who looks after the control. Do not connect if nobody has changed anything.</source>
        <translation>O qualcuno ha rinnovato il certificato del controllo, o al suo indirizzo risponde un altro computer che riceverebbe tutti i comandi. Chiedere a chi cura il controllo. Non connettere se nessuno ha cambiato nulla.</translation>
    </message>
    <message>
        <source>Better: switch encryption on at the control, then connect again. What you allow here is remembered for this machine until you take it back, and is marked as long as it is connected.</source>
        <translation>Meglio: attivare la cifratura sul controllo, poi riconnettere. Ciò che si consente qui viene ricordato per questa macchina finché non viene ritirato, ed è segnalato finché è connessa.</translation>
    </message>
    <message>
        <source>Until now this machine was connected encrypted. Somebody who stands between could hide the encryption.</source>
        <translation>Finora questa macchina era connessa con cifratura. Qualcuno nel mezzo potrebbe nascondere la cifratura.</translation>
    </message>
    <message>
        <source>Nothing that it offers lets this user in with an encrypted password.</source>
        <translation>Nulla di ciò che offre fa entrare questo utente con una password cifrata.</translation>
    </message>
    <message>
        <source>The certificate is not valid today, so it cannot be accepted. Set the clocks of both computers, or renew it on the control.</source>
        <translation>Il certificato oggi non è valido e non può essere accettato. Regolare gli orologi dei due computer, o rinnovarlo sul controllo.</translation>
    </message>
    <message>
        <source>not kept</source>
        <translation>non conservato</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Indirizzo</translation>
    </message>
    <message>
        <source>Shown now</source>
        <translation>Mostrato ora</translation>
    </message>
    <message>
        <source>Accepted before</source>
        <translation>Accettato prima</translation>
    </message>
    <message>
        <source>Fingerprint (SHA-256)</source>
        <translation>Impronta (SHA-256)</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Rilasciato a</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>Rilasciato da</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>Applicazione</translation>
    </message>
    <message>
        <source>Made for</source>
        <translation>Fatto per</translation>
    </message>
    <message>
        <source>%1: not for %2</source>
        <translation>%1: non per %2</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Valido</translation>
    </message>
    <message>
        <source>The control has to trust this computer, too. On a SINUMERIK, switch on in the dialog of the OPC UA server that client certificates are accepted by themselves, connect, and switch it off again; or import the file of this computer&apos;s certificate there. Its fingerprint: %1</source>
        <translation>Anche il controllo deve fidarsi di questo computer. Su una SINUMERIK, attivare nella finestra del server OPC UA l’accettazione automatica dei certificati client, connettere e disattivarla; oppure importarvi il file del certificato di questo computer. La sua impronta: %1</translation>
    </message>
    <message>
        <source>Do not connect</source>
        <translation>Non connettere</translation>
    </message>
    <message>
        <source>Save this computer&apos;s certificate …</source>
        <translation>Salva il certificato di questo computer…</translation>
    </message>
    <message>
        <source>Hold: allow and connect</source>
        <translation>Tenere: consenti e connetti</translation>
    </message>
    <message>
        <source>Hold: accept and connect</source>
        <translation>Tenere: accetta e connetti</translation>
    </message>
    <message>
        <source>Hold it for one second, with the mouse, a finger or the space bar.</source>
        <translation>Tenere per un secondo, con mouse, dito o barra spaziatrice.</translation>
    </message>
    <message>
        <source>%1: the server says that it is %2</source>
        <translation>%1: il server dice di essere %2</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UserButton</name>
    <message>
        <source>Locked: log in</source>
        <translation>Bloccato: accedere</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Only Stop works. Log in with your PIN (Ctrl+L).</source>
        <translation>Funziona solo Stop. Accedere con il proprio PIN (Ctrl+L).</translation>
    </message>
    <message>
        <source>Lock the window, or let somebody else in (Ctrl+L).</source>
        <translation>Blocca la finestra, o fa accedere un’altra persona (Ctrl+L).</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UserModel</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Ruolo</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>set</source>
        <translation>impostato</translation>
    </message>
    <message>
        <source>none: user of this computer</source>
        <translation>nessuno: utente di questo computer</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UsersPage</name>
    <message>
        <source>No users are set up: everybody at this window may do everything. To let operators start only what is released, add an engineer (name and PIN), then the operators.</source>
        <translation>Nessun utente configurato: chiunque a questa finestra può fare tutto. Perché gli operatori avviino solo ciò che è approvato, aggiungere un attrezzista (nome e PIN), poi gli operatori.</translation>
    </message>
    <message>
        <source>An operator starts what an engineer has released in the preflight, holds, stops and acknowledges. An engineer may do everything. In a locked window only Stop works. The user of this computer (%1) needs no PIN.</source>
        <translation>Un operatore avvia ciò che un attrezzista ha approvato nel controllo prima dell’avvio, sospende, arresta e tacita. Un attrezzista può fare tutto. In una finestra bloccata funziona solo Stop. L’utente di questo computer (%1) non ha bisogno di PIN.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Ruolo</translation>
    </message>
    <message>
        <source>PIN, at least 4 characters</source>
        <translation>PIN, almeno 4 caratteri</translation>
    </message>
    <message>
        <source>Lock the window if nobody touches it for</source>
        <translation>Blocca la finestra se nessuno la tocca per</translation>
    </message>
    <message>
        <source>never</source>
        <translation>mai</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Add or change</source>
        <translation>Aggiungi o modifica</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Rimuovi</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Utenti</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::WrongMotionBar</name>
    <message>
        <source>Stop the run</source>
        <translation>Arresta l’esecuzione</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Tacita</translation>
    </message>
</context>
</TS>
