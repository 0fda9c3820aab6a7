<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AccessTexts</name>
    <message>
        <source>Access calibrated on %1 (%2): t = %3; read %4, write %5.</source>
        <translation>Accès étalonné le %1 (%2)&#xa0;: t = %3&#xa0;; lecture %4, écriture %5.</translation>
    </message>
    <message>
        <source>list</source>
        <translation>liste</translation>
    </message>
    <message>
        <source>one by one</source>
        <translation>un par un</translation>
    </message>
    <message>
        <source>array, by count</source>
        <translation>tableau, par nombre</translation>
    </message>
    <message>
        <source>array, by range</source>
        <translation>tableau, par plage</translation>
    </message>
    <message>
        <source>a server without a name</source>
        <translation>un serveur sans nom</translation>
    </message>
    <message>
        <source>Access is assumed: %1 for each R-parameter. See Calibration.</source>
        <translation>L’accès est supposé : %1 par paramètre R. Voir Étalonnage.</translation>
    </message>
    <message>
        <source>Access is assumed: %1 for each R-parameter. The calibration of %2 belongs to another version of the server and is not used.</source>
        <translation>L’accès est supposé : %1 par paramètre R. L’étalonnage du %2 correspond à une autre version du serveur et n’est pas utilisé.</translation>
    </message>
    <message numerus="yes">
        <source>99 % of the writes of %n R-parameters end within %1.</source>
        <translation>
            <numerusform>99 % des écritures de %n paramètre R se terminent en moins de %1.</numerusform>
            <numerusform>99 % des écritures de %n paramètres R se terminent en moins de %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Up to %n R-parameters were measured.</source>
        <translation>
            <numerusform>Mesures faites jusqu’à %n paramètre R.</numerusform>
            <numerusform>Mesures faites jusqu’à %n paramètres R.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>AlarmTexts</name>
    <message>
        <source>The control reports alarm %1.</source>
        <translation>La commande signale l’alarme %1.</translation>
    </message>
    <message>
        <source>The control has stopped or limits the machine; the number says why.</source>
        <translation>La commande a arrêté la machine ou la limite&#xa0;; le numéro indique pourquoi.</translation>
    </message>
    <message>
        <source>Look up alarm %1 at the control, remove its cause, then press reset there.</source>
        <translation>Rechercher l’alarme %1 sur la commande, éliminer la cause, puis y appuyer sur Reset.</translation>
    </message>
    <message>
        <source>The connection to %1 is lost.</source>
        <translation>La connexion à %1 est perdue.</translation>
    </message>
    <message>
        <source>No connection to %1.</source>
        <translation>Pas de connexion à %1.</translation>
    </message>
    <message>
        <source>Wrong motion in %1 (points repeated: %2, skipped: %3). The workpiece may be spoilt.</source>
        <translation>Mouvement erroné dans %1 (points répétés&#xa0;: %2, sautés&#xa0;: %3). La pièce est peut-être abîmée.</translation>
    </message>
    <message>
        <source>Points came too late for this feed with these settings.</source>
        <translation>Les points sont arrivés trop tard pour cette avance avec ces réglages.</translation>
    </message>
    <message>
        <source>Check workpiece and tool. Choose a smaller feed, or method window.</source>
        <translation>Contrôler la pièce et l’outil. Choisir une avance plus faible ou la méthode Fenêtre.</translation>
    </message>
    <message>
        <source>The run of %1 was ended by a fault.</source>
        <translation>L’exécution de %1 a été interrompue par un défaut.</translation>
    </message>
    <message>
        <source>Check tool and workpiece, remove the cause, then resume or start again.</source>
        <translation>Contrôler l’outil et la pièce, éliminer la cause, puis reprendre ou redémarrer.</translation>
    </message>
    <message>
        <source>%1 ended before its end: %2 of %3 points were executed.</source>
        <translation>%1 s’est terminé trop tôt&#xa0;: %2 points sur %3 ont été exécutés.</translation>
    </message>
    <message>
        <source>The control&apos;s trace lacks the last points.</source>
        <translation>Les derniers points manquent dans l’enregistrement de la commande.</translation>
    </message>
    <message>
        <source>Check tool and workpiece before you go on.</source>
        <translation>Contrôler l’outil et la pièce avant de continuer.</translation>
    </message>
    <message>
        <source>It is not known whether %1 was executed without a fault.</source>
        <translation>On ne sait pas si %1 a été exécuté sans erreur.</translation>
    </message>
    <message>
        <source>The control&apos;s trace could not be read, or is shorter than the run.</source>
        <translation>L’enregistrement de la commande n’a pas pu être lu, ou il est plus court que l’exécution.</translation>
    </message>
    <message>
        <source>Check the workpiece.</source>
        <translation>Contrôler la pièce.</translation>
    </message>
    <message>
        <source>The run is not recorded.</source>
        <translation>L’exécution n’est pas enregistrée.</translation>
    </message>
    <message>
        <source>Nothing can be written to the folder %1.</source>
        <translation>Rien ne peut être écrit dans le dossier %1.</translation>
    </message>
    <message>
        <source>Check the folder, its permissions and the free space.</source>
        <translation>Vérifier le dossier, ses droits d’accès et l’espace libre.</translation>
    </message>
    <message>
        <source>The program file %1 has changed since it was read.</source>
        <translation>Le fichier programme %1 a été modifié depuis sa lecture.</translation>
    </message>
    <message>
        <source>Another program has written the file.</source>
        <translation>Un autre logiciel a écrit dans le fichier.</translation>
    </message>
    <message>
        <source>Reload the file before you start.</source>
        <translation>Recharger le fichier avant de démarrer.</translation>
    </message>
    <message>
        <source>The program file %1 is no longer there.</source>
        <translation>Le fichier programme %1 n’existe plus.</translation>
    </message>
    <message>
        <source>It was deleted or moved, or its drive is not connected.</source>
        <translation>Il a été supprimé ou déplacé, ou son lecteur n’est pas connecté.</translation>
    </message>
    <message>
        <source>Bring the file back, or go on with what was read before it disappeared.</source>
        <translation>Remettre le fichier en place, ou continuer avec ce qui a été lu avant sa disparition.</translation>
    </message>
    <message>
        <source>The calibration of %1 has failed.</source>
        <translation>L’étalonnage de %1 a échoué.</translation>
    </message>
    <message>
        <source>Remove the cause, then measure again.</source>
        <translation>Éliminer la cause, puis refaire la mesure.</translation>
    </message>
    <message>
        <source>The calibration of %1 is not saved.</source>
        <translation>L’étalonnage de %1 n’est pas enregistré.</translation>
    </message>
    <message>
        <source>Check the folder and the free space, then measure again.</source>
        <translation>Vérifier le dossier et l’espace libre, puis refaire la mesure.</translation>
    </message>
    <message>
        <source>The history of alarms is not written to %1.</source>
        <translation>L’historique des alarmes n’est pas écrit dans %1.</translation>
    </message>
    <message>
        <source>The audit trail is not written to %1.</source>
        <translation>Le journal d’audit n’est pas écrit dans %1.</translation>
    </message>
    <message>
        <source>The audit trail %1 was changed: see line %2.</source>
        <translation>Le journal d’audit %1 a été modifié&#xa0;: voir la ligne %2.</translation>
    </message>
    <message>
        <source>A line was edited, inserted or removed after it was written.</source>
        <translation>Une ligne a été modifiée, insérée ou supprimée après son écriture.</translation>
    </message>
    <message>
        <source>Keep a copy of the file and find out who changed it.</source>
        <translation>Conserver une copie du fichier et rechercher qui l’a modifié.</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Connexion</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Exécution</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Ordinateur</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Active</translation>
    </message>
    <message>
        <source>Active, acknowledged</source>
        <translation>Active, acquittée</translation>
    </message>
    <message>
        <source>Gone, not acknowledged</source>
        <translation>Disparue, non acquittée</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>Mise de côté</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Apparue</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>Disparue</translation>
    </message>
    <message>
        <source>Acknowledged</source>
        <translation>Acquittée</translation>
    </message>
    <message>
        <source>Taken back</source>
        <translation>Réaffichée</translation>
    </message>
    <message>
        <source>Shelving expired</source>
        <translation>Fin de la mise de côté</translation>
    </message>
    <message>
        <source>Look at the machine: it may still move. Check cable and control, then connect again.</source>
        <translation>Regarder la machine&#xa0;: elle peut encore bouger. Vérifier le câble et la commande, puis se reconnecter.</translation>
    </message>
    <message>
        <source>Wrong motion in %1 after point %2: points are repeated, or the tool has left the path.</source>
        <translation>Mouvement erroné dans %1 après le point %2&#xa0;: des points sont répétés, ou l’outil a quitté la trajectoire.</translation>
    </message>
    <message>
        <source>Points came too late for this feed with these settings, or something else moves the axes.</source>
        <translation>Des points sont arrivés trop tard pour cette avance avec ces réglages, ou autre chose déplace les axes.</translation>
    </message>
    <message>
        <source>Stop the run, then check workpiece and tool.</source>
        <translation>Arrêter l’exécution, puis vérifier la pièce et l’outil.</translation>
    </message>
    <message>
        <source>The recording of %1 was cut off: the first %2 s of the run are in it.</source>
        <translation>L’enregistrement de %1 a été coupé&#xa0;: il contient les %2 premières secondes de l’exécution.</translation>
    </message>
    <message>
        <source>Nothing more can be written to the folder %3: its disk is full, or too slow.</source>
        <translation>Plus rien ne peut être écrit dans le dossier %3&#xa0;: le disque est plein ou trop lent.</translation>
    </message>
    <message>
        <source>Make room on the disk. A run in progress goes on without its recording; the next one is recorded.</source>
        <translation>Libérer de la place sur le disque. Une exécution en cours continue sans enregistrement&#xa0;; la suivante est enregistrée.</translation>
    </message>
</context>
<context>
    <name>AuditTexts</name>
    <message>
        <source>Stop</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprise</translation>
    </message>
    <message>
        <source>Online correction</source>
        <translation>Correction en ligne</translation>
    </message>
    <message>
        <source>Program opened</source>
        <translation>Programme ouvert</translation>
    </message>
    <message>
        <source>Settings changed</source>
        <translation>Réglages modifiés</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connexion</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnexion</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Validé</translation>
    </message>
    <message>
        <source>Release taken back</source>
        <translation>Validation retirée</translation>
    </message>
    <message>
        <source>Alarm acknowledged</source>
        <translation>Alarme acquittée</translation>
    </message>
    <message>
        <source>Alarm shelved</source>
        <translation>Alarme mise de côté</translation>
    </message>
    <message>
        <source>Users set up</source>
        <translation>Utilisateurs définis</translation>
    </message>
    <message>
        <source>Logged in</source>
        <translation>Identifié</translation>
    </message>
    <message>
        <source>Wrong PIN</source>
        <translation>Code PIN erroné</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
    <message>
        <source>Rivulet started</source>
        <translation>Rivulet démarré</translation>
    </message>
    <message>
        <source>Rivulet ended</source>
        <translation>Rivulet arrêté</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>Régleur</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Observer</translation>
    </message>
    <message>
        <source>Trust</source>
        <translation>Confiance</translation>
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
        <translation>Une exécution est en cours.</translation>
    </message>
    <message>
        <source>Asking the control where the run was left.</source>
        <translation>On demande à la commande où l’exécution s’est interrompue.</translation>
    </message>
    <message>
        <source>A calibration is in progress.</source>
        <translation>Un étalonnage est en cours.</translation>
    </message>
    <message>
        <source>Connect to a control first.</source>
        <translation>Se connecter d’abord à une commande.</translation>
    </message>
    <message>
        <source>Open a program first.</source>
        <translation>Ouvrir d’abord un programme.</translation>
    </message>
    <message>
        <source>The file of the program has changed: reload it.</source>
        <translation>Le fichier du programme a été modifié&#xa0;: le recharger.</translation>
    </message>
    <message>
        <source>The program moves no axis.</source>
        <translation>Le programme ne déplace aucun axe.</translation>
    </message>
    <message>
        <source>The program needs a transformation of the control. No method can stream it.</source>
        <translation>Le programme a besoin d’une transformation de la commande. Aucune méthode ne peut le transmettre en continu.</translation>
    </message>
    <message>
        <source>Parts of the program&apos;s path are not known: see the findings.</source>
        <translation>Certaines parties de la trajectoire ne sont pas connues&#xa0;: voir les observations.</translation>
    </message>
    <message>
        <source>The program moves rotary axes: choose method window.</source>
        <translation>Le programme déplace des axes rotatifs&#xa0;: choisir la méthode Fenêtre.</translation>
    </message>
    <message>
        <source>The program moves %1, but the control does not have all of these axes.</source>
        <translation>Le programme déplace %1, mais la commande ne possède pas tous ces axes.</translation>
    </message>
    <message>
        <source>Not feasible: the control would repeat points. Change F, N or δ.</source>
        <translation>Non réalisable&#xa0;: la commande répéterait des points. Modifier F, N ou δ.</translation>
    </message>
    <message>
        <source>Method credit starts only on a control that has passed its test: choose method window.</source>
        <translation>La méthode Crédit ne démarre que sur une commande qui a réussi son test&#xa0;: choisir la méthode Fenêtre.</translation>
    </message>
    <message>
        <source>The control reports an alarm.</source>
        <translation>La commande signale une alarme.</translation>
    </message>
    <message>
        <source>A program is running on the control.</source>
        <translation>Un programme est en cours sur la commande.</translation>
    </message>
    <message>
        <source>There is no interrupted run of method window.</source>
        <translation>Il n’y a pas d’exécution interrompue de la méthode Fenêtre.</translation>
    </message>
    <message>
        <source>Only method window can resume an interrupted run.</source>
        <translation>Seule la méthode Fenêtre peut reprendre une exécution interrompue.</translation>
    </message>
    <message>
        <source>The program is being simulated.</source>
        <translation>Simulation du programme en cours.</translation>
    </message>
    <message>
        <source>The simulation of this program failed in %1 of %2 runs. Change F, N or δ.</source>
        <translation>La simulation de ce programme a échoué %1 fois sur %2. Modifier F, N ou δ.</translation>
    </message>
    <message>
        <source>The window is locked: log in.</source>
        <translation>La fenêtre est verrouillée&#xa0;: s’identifier.</translation>
    </message>
    <message>
        <source>Only an engineer may do this.</source>
        <translation>Réservé au régleur.</translation>
    </message>
    <message>
        <source>Not released: an engineer has to release this program with these settings.</source>
        <translation>Non validé&#xa0;: un régleur doit valider ce programme avec ces réglages.</translation>
    </message>
    <message>
        <source>A test of the control is in progress.</source>
        <translation>Un test de la commande est en cours.</translation>
    </message>
    <message>
        <source>The job is being compared with the machine.</source>
        <translation>La tâche est comparée à la machine.</translation>
    </message>
    <message>
        <source>Live points need a machine that waits for them: choose method window or credit.</source>
        <translation>Des points en direct demandent une machine qui les attend&#xa0;: choisir la méthode Fenêtre ou Crédit.</translation>
    </message>
    <message>
        <source>Method %1 may execute old points again: if this computer is late for a moment, the tool goes back through the workpiece. Choose method window.</source>
        <translation>La méthode %1 peut exécuter à nouveau d’anciens points&#xa0;: si cet ordinateur est en retard un instant, l’outil revient à travers la pièce. Choisir la méthode Fenêtre.</translation>
    </message>
</context>
<context>
    <name>CertificateTexts</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>lui-même</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>non indiqué</translation>
    </message>
</context>
<context>
    <name>ConnectionTexts</name>
    <message>
        <source>Not connected</source>
        <translation>Non connecté</translation>
    </message>
    <message>
        <source>Connecting …</source>
        <translation>Connexion…</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Connecté</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Connexion perdue</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Interrompu</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En attente</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation>Inconnu (%1)</translation>
    </message>
    <message>
        <source>encrypted</source>
        <translation>chiffrée</translation>
    </message>
    <message>
        <source>Nobody on the network can read or change what is sent.</source>
        <translation>Personne sur le réseau ne peut lire ni modifier ce qui est envoyé.</translation>
    </message>
    <message>
        <source>signed</source>
        <translation>signée</translation>
    </message>
    <message>
        <source>Nobody can change what is sent, but everybody on the network can read it.</source>
        <translation>Personne ne peut modifier ce qui est envoyé, mais tous sur le réseau peuvent le lire.</translation>
    </message>
    <message>
        <source>weakly encrypted</source>
        <translation>faiblement chiffrée</translation>
    </message>
    <message>
        <source>This encryption was withdrawn: it can be broken with the means of today.</source>
        <translation>Ce chiffrement a été retiré&#xa0;: il peut être cassé avec les moyens d’aujourd’hui.</translation>
    </message>
    <message>
        <source>not protected</source>
        <translation>non protégée</translation>
    </message>
    <message>
        <source>Not encrypted. What is sent does not leave this computer.</source>
        <translation>Non chiffrée. Ce qui est envoyé ne quitte pas cet ordinateur.</translation>
    </message>
    <message>
        <source>Everybody on the network can read what is sent, and move the machine.</source>
        <translation>Tous sur le réseau peuvent lire ce qui est envoyé et déplacer la machine.</translation>
    </message>
</context>
<context>
    <name>ControlSettings</name>
    <message>
        <source>R plane of a cycle without R: below the height before it, mm</source>
        <translation>Plan R d’un cycle sans R&#xa0;: sous la hauteur qui précède, mm</translation>
    </message>
    <message>
        <source>peck depth of G73 and G83 without Q, mm (0: in one stroke)</source>
        <translation>Profondeur de passe de G73 et G83 sans Q, mm (0&#xa0;: en une fois)</translation>
    </message>
    <message>
        <source>spindle speed of tapping without S, 1/min</source>
        <translation>Vitesse de broche du taraudage sans S, 1/min</translation>
    </message>
    <message>
        <source>direction in which a boring tool lifts off (X, -X, Y, -Y, Z, -Z)</source>
        <translation>Direction dans laquelle un outil d’alésage se dégage (X, -X, Y, -Y, Z, -Z)</translation>
    </message>
    <message>
        <source>lift-off of a boring tool without Q, mm</source>
        <translation>Dégagement d’un outil d’alésage sans Q, mm</translation>
    </message>
    <message>
        <source>angle of the spindle when a boring tool lifts off, degrees</source>
        <translation>Angle de la broche quand un outil d’alésage se dégage, degrés</translation>
    </message>
    <message>
        <source>an arc without centre and radius is a straight line</source>
        <translation>Un arc sans centre ni rayon est une droite</translation>
    </message>
    <message>
        <source>settable work offset for G54.1 P1 (507: G507)</source>
        <translation>Décalage d’origine réglable pour G54.1 P1 (507&#xa0;: G507)</translation>
    </message>
    <message>
        <source>retraction of G73 and G83 within the hole, mm</source>
        <translation>Retrait de G73 et G83 dans le trou, mm</translation>
    </message>
    <message>
        <source>before the start the tool stands where the first G92 says, in the work offset of the control</source>
        <translation>avant le départ, l’outil est là où le dit le premier G92, dans le décalage d’origine de la commande</translation>
    </message>
</context>
<context>
    <name>CreditTestTexts</name>
    <message>
        <source>%1 of %2 answers while busy, the slowest after %3</source>
        <translation>%1 réponses sur %2 en charge, la plus lente après %3</translation>
    </message>
    <message>
        <source>Method credit lets the axes move on while the next window is on its way. That is safe only on a control that answers while its axes are busy. This test finds out: a program that moves no axis, for a few seconds. The channel must be in reset.</source>
        <translation>Avec la méthode Crédit, les axes continuent pendant que la fenêtre suivante est en route. Cela n’est sûr que sur une commande qui répond pendant que ses axes sont occupés. Ce test le vérifie&#xa0;: un programme qui ne déplace aucun axe, pendant quelques secondes. Le canal doit être en Reset.</translation>
    </message>
    <message>
        <source>4. Numbers are sent and must come back while the control is busy.</source>
        <translation>4. Des nombres sont envoyés et doivent revenir pendant que la commande est occupée.</translation>
    </message>
    <message>
        <source>Not tested: method credit does not start on this control</source>
        <translation>Non testé&#xa0;: la méthode Crédit ne démarre pas sur cette commande</translation>
    </message>
    <message>
        <source>Passed: method credit may run on this control</source>
        <translation>Réussi&#xa0;: la méthode Crédit est permise sur cette commande</translation>
    </message>
    <message>
        <source>Not passed: method credit does not start. Use method window.</source>
        <translation>Échoué&#xa0;: la méthode Crédit ne démarre pas. Utiliser la méthode Fenêtre.</translation>
    </message>
    <message>
        <source>The control answers the client while blocks wait to be executed.</source>
        <translation>La commande répond au client pendant que des blocs attendent d’être exécutés.</translation>
    </message>
    <message>
        <source>What a synchronized action writes reaches the client.</source>
        <translation>Ce qu’écrit une action synchrone parvient au client.</translation>
    </message>
    <message>
        <source>What a synchronized action writes reaches the program without a stop.</source>
        <translation>Ce qu’écrit une action synchrone parvient au programme sans arrêt.</translation>
    </message>
    <message>
        <source>A synchronized action before a block is executed with that block.</source>
        <translation>Une action synchrone placée avant un bloc est exécutée avec ce bloc.</translation>
    </message>
    <message>
        <source>The program can tell, without a stop, whether blocks are waiting ($AC_IPO_BUF).</source>
        <translation>Le programme sait, sans arrêt, si des blocs attendent ($AC_IPO_BUF).</translation>
    </message>
</context>
<context>
    <name>DiagnosticTexts</name>
    <message>
        <source>Note</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: the run does not wait here, and no tool is changed.</source>
        <translation>%1 n’est pas envoyé à la commande&#xa0;: l’exécution n’attend pas ici et aucun outil n’est changé.</translation>
    </message>
    <message>
        <source>A block with &quot;/&quot; is executed: Rivulet reads the program with block skip off.</source>
        <translation>Un bloc avec «&#xa0;/&#xa0;» est exécuté&#xa0;: Rivulet lit le programme sans saut de blocs.</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: set spindle, tool and coolant there.</source>
        <translation>%1 n’est pas envoyé à la commande&#xa0;: y régler la broche, l’outil et l’arrosage.</translation>
    </message>
    <message>
        <source>The character &quot;%1&quot; has no meaning here: remove it or put it into a comment.</source>
        <translation>Le caractère «&#xa0;%1&#xa0;» n’a pas de sens ici&#xa0;: le supprimer ou le mettre en commentaire.</translation>
    </message>
    <message>
        <source>The word %1 has no number.</source>
        <translation>Il manque le nombre après le mot %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number: write digits with a decimal point.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre&#xa0;: écrire des chiffres avec un point décimal.</translation>
    </message>
    <message>
        <source>A bracket is opened but not closed in this line: the rest of the line is not read.</source>
        <translation>Une parenthèse est ouverte mais n’est pas fermée sur cette ligne&#xa0;: le reste de la ligne n’est pas lu.</translation>
    </message>
    <message>
        <source>Rivulet does not know the G function %1: its effect on the path is unknown.</source>
        <translation>Rivulet ne connaît pas la fonction G %1&#xa0;: son effet sur la trajectoire est inconnu.</translation>
    </message>
    <message>
        <source>The word %1 is not understood here: its effect on the path is unknown.</source>
        <translation>Le mot %1 n’est pas compris ici&#xa0;: son effet sur la trajectoire est inconnu.</translation>
    </message>
    <message>
        <source>%1 changes the path or the feed in a way that Rivulet does not support: post-process the program without it.</source>
        <translation>%1 modifie la trajectoire ou l’avance d’une façon que Rivulet ne prend pas en charge&#xa0;: refaire le post-traitement du programme sans cette fonction.</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: it does not change the path.</source>
        <translation>%1 n’est pas envoyé à la commande&#xa0;: la trajectoire ne change pas.</translation>
    </message>
    <message>
        <source>%1 contradict each other in one block: keep one of them.</source>
        <translation>%1 se contredisent dans un même bloc&#xa0;: n’en garder qu’un.</translation>
    </message>
    <message>
        <source>The word %1 appears twice in one block: keep one of them.</source>
        <translation>Le mot %1 figure deux fois dans un même bloc&#xa0;: n’en garder qu’un.</translation>
    </message>
    <message>
        <source>The arc has no centre: give I, J, K, or a radius with an end point that differs from the start.</source>
        <translation>L’arc n’a pas de centre&#xa0;: indiquer I, J, K, ou un rayon avec un point final différent du point de départ.</translation>
    </message>
    <message>
        <source>The arc&apos;s radius differs by %1 mm between start and end: check the centre, which is read as an increment from the start.</source>
        <translation>Le rayon de l’arc diffère de %1 mm entre le départ et la fin&#xa0;: vérifier le centre, qui est lu en relatif depuis le départ.</translation>
    </message>
    <message>
        <source>The arc&apos;s radius is too small to reach its end point (radius &lt; half chord, mm: %1).</source>
        <translation>Le rayon de l’arc est trop petit pour atteindre son point final (rayon &lt; demi-corde, mm&#xa0;: %1).</translation>
    </message>
    <message>
        <source>The arc starts at an unknown position: program %1 with G0 or G1 before it.</source>
        <translation>L’arc commence à une position inconnue&#xa0;: programmer d’abord %1 avec G0 ou G1.</translation>
    </message>
    <message>
        <source>The increment of %1 starts at an unknown position: program %1 with G90 before it.</source>
        <translation>La cote relative de %1 part d’une position inconnue&#xa0;: programmer d’abord %1 avec G90.</translation>
    </message>
    <message>
        <source>The feed F%1 is not greater than 0.</source>
        <translation>L’avance F%1 n’est pas supérieure à 0.</translation>
    </message>
    <message>
        <source>The value of %1 is outside the range that Rivulet accepts.</source>
        <translation>La valeur de %1 est hors de la plage que Rivulet accepte.</translation>
    </message>
    <message>
        <source>An axis is programmed before any of G0 to G3: G1 is assumed, as after a reset of the control.</source>
        <translation>Un axe est programmé avant tout G0 à G3&#xa0;: G1 est supposé, comme après un reset de la commande.</translation>
    </message>
    <message>
        <source>The centre word %1 is not in the plane of the arc: check G17, G18, G19.</source>
        <translation>Le mot de centre %1 n’est pas dans le plan de l’arc&#xa0;: vérifier G17, G18, G19.</translation>
    </message>
    <message>
        <source>The program has more than %1 points: it is not read further. Split it.</source>
        <translation>Le programme a plus de %1 points&#xa0;: la lecture s’arrête ici. Diviser le programme.</translation>
    </message>
    <message>
        <source>%1 more findings from here on are not listed.</source>
        <translation>%1 autres observations à partir d’ici ne sont pas listées.</translation>
    </message>
    <message>
        <source>Rivulet does not execute &quot;%1&quot;: its effect on the path is unknown.</source>
        <translation>Rivulet n’exécute pas «&#xa0;%1&#xa0;»&#xa0;: son effet sur la trajectoire est inconnu.</translation>
    </message>
    <message>
        <source>The loop that ends here does not terminate: reading stopped after %1 repeated blocks. Check its condition.</source>
        <translation>La boucle qui finit ici ne se termine pas&#xa0;: la lecture s’est arrêtée après %1 blocs répétés. Vérifier sa condition.</translation>
    </message>
    <message>
        <source>The calculation has no result: %1.</source>
        <translation>Le calcul n’a pas de résultat&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The sequence of the blocks is not known from here on: %1.</source>
        <translation>L’ordre des blocs n’est plus connu à partir d’ici&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The subprogram %1 is neither in this file nor in a file beside it: its points are missing.</source>
        <translation>Le sous-programme %1 ne se trouve ni dans ce fichier ni dans un fichier voisin&#xa0;: ses points manquent.</translation>
    </message>
    <message>
        <source>%1 is a cycle of the control: its motions are missing here.</source>
        <translation>%1 est un cycle de la commande&#xa0;: ses mouvements manquent ici.</translation>
    </message>
    <message>
        <source>%1 moves in machine coordinates, whose position in the workpiece is not known: the move is left out.</source>
        <translation>%1 se déplace en coordonnées machine, dont la position par rapport à la pièce est inconnue&#xa0;: le déplacement est omis.</translation>
    </message>
    <message>
        <source>The file holds bytes that do not occur in NC text: choose a text file, not an archive or a picture.</source>
        <translation>Le fichier contient des octets qui n’existent pas dans un texte CN&#xa0;: choisir un fichier texte, pas une archive ni une image.</translation>
    </message>
    <message>
        <source>%1 is left out because you accepted it: the path may differ from the path at the control.</source>
        <translation>%1 est omis parce que vous l’avez accepté&#xa0;: la trajectoire peut différer de celle de la commande.</translation>
    </message>
    <message>
        <source>All arcs of the program fit if I, J and K are read as %1: check how the post-processor writes them, and load the program that way.</source>
        <translation>Tous les arcs du programme sont justes si I, J et K sont lus comme %1&#xa0;: vérifier comment le post-processeur les écrit et charger le programme ainsi.</translation>
    </message>
    <message>
        <source>The program moves no axis: there is nothing to stream. Choose a program with G0, G1, G2 or G3 and X, Y or Z.</source>
        <translation>Le programme ne déplace aucun axe&#xa0;: il n’y a rien à transmettre. Choisir un programme avec G0, G1, G2 ou G3 et X, Y ou Z.</translation>
    </message>
    <message>
        <source>%1 moves on the path: only method window streams it, and only if this axis is selected.</source>
        <translation>%1 se déplace sur la trajectoire&#xa0;: seule la méthode Fenêtre le transmet, et seulement si cet axe est choisi.</translation>
    </message>
    <message>
        <source>With %1, X, Y and Z are those of the tool tip while rotary axes turn, and no method switches it on at the control. Post-process the program for the axes of the machine.</source>
        <translation>Avec %1, X, Y et Z sont ceux de la pointe de l’outil pendant que les axes rotatifs tournent, et aucune méthode n’active cela sur la commande. Refaire le post-traitement pour les axes de la machine.</translation>
    </message>
    <message>
        <source>%1 give the tool direction. The points keep it, but only the control could convert it to rotary axes. Post-process the program with A, B or C.</source>
        <translation>%1 donnent l’orientation de l’outil. Les points la conservent, mais seule la commande pourrait la convertir en axes rotatifs. Refaire le post-traitement avec A, B ou C.</translation>
    </message>
    <message>
        <source>A block moves with G1, G2 or G3 before a feed F is programmed: only a fixed feed can be used.</source>
        <translation>Un bloc se déplace avec G1, G2 ou G3 avant qu’une avance F soit programmée&#xa0;: seule une avance fixe est possible.</translation>
    </message>
    <message>
        <source>A blank is inside the number &quot;%1&quot;: this control does not put the parts together. Write the number without blanks.</source>
        <translation>Un espace se trouve dans le nombre «&#xa0;%1&#xa0;»&#xa0;: cette commande n’assemble pas les parties. Écrivez le nombre sans espace.</translation>
    </message>
    <message>
        <source>An invisible character stands here (%1), as office programs and web pages insert it: replace it by an ordinary blank.</source>
        <translation>Un caractère invisible se trouve ici (%1), comme en insèrent les logiciels de bureau et les pages Web&#xa0;: remplacez-le par un espace ordinaire.</translation>
    </message>
    <message>
        <source>A bracket is opened within the comment %1, which ends at the first closing bracket. Write it without inner brackets.</source>
        <translation>Une parenthèse est ouverte dans le commentaire %1, qui finit à la première parenthèse fermante. Écrivez-le sans parenthèses internes.</translation>
    </message>
    <message>
        <source>%1 is a function of the builder of the machine: whether it moves an axis or changes the feed is not known. Accept it if it does not.</source>
        <translation>%1 est une fonction du constructeur de la machine&#xa0;: on ne sait pas si elle déplace un axe ou change l’avance. Acceptez-la si ce n’est pas le cas.</translation>
    </message>
    <message>
        <source>The blocks of %1 are never executed: check the end of the program and the jumps before them, or remove them.</source>
        <translation>Les blocs de %1 ne sont jamais exécutés&#xa0;: vérifiez la fin du programme et les sauts qui précèdent, ou supprimez-les.</translation>
    </message>
    <message>
        <source>No block calls the subprogram %1: check the calls, or remove it.</source>
        <translation>Aucun bloc n’appelle le sous-programme %1&#xa0;: vérifiez les appels, ou supprimez-le.</translation>
    </message>
    <message>
        <source>The file holds another main program, %1: which one is to run is not known. Give each main program a file of its own.</source>
        <translation>Le fichier contient un autre programme principal, %1&#xa0;: on ne sait pas lequel doit être exécuté. Donnez à chaque programme principal son propre fichier.</translation>
    </message>
    <message>
        <source>With M99, a main program begins again at the control, without end: it is executed once here. Write M30 if it is to end.</source>
        <translation>Avec M99, un programme principal recommence sans fin sur la commande&#xa0;: il est exécuté une fois ici. Écrivez M30 s’il doit se terminer.</translation>
    </message>
    <message>
        <source>Loops and calls repeat more than %1 blocks for the control: the program is not read further. Check the condition of the loop.</source>
        <translation>Des boucles et des appels répètent plus de %1 blocs pour la commande&#xa0;: la lecture du programme s’arrête. Vérifiez la condition de la boucle.</translation>
    </message>
    <message>
        <source>The program is for a lathe (%1): X is read as a diameter, U and W as increments, the plane is Z X, and with G99 F is per revolution.</source>
        <translation>Le programme est pour un tour (%1)&#xa0;: X est lu comme un diamètre, U et W comme des incréments, le plan est Z X, et avec G99 F est par tour.</translation>
    </message>
    <message>
        <source>No block says mm or inch (G21, G20) before the first move: the size is %1, read as mm or as inch. Load it with its unit (--units).</source>
        <translation>Aucun bloc n’indique mm ou pouces (G21, G20) avant le premier déplacement&#xa0;: la taille est %1, lue en mm ou en pouces. Chargez-le avec son unité (--units).</translation>
    </message>
    <message>
        <source>Coordinates have no decimal point: the size is %1, read as whole units or as least increments. Load it as the control is set (--no-point).</source>
        <translation>Les coordonnées n’ont pas de point décimal&#xa0;: la taille est %1, lue en unités entières ou en plus petits incréments. Chargez-le selon le réglage de la commande (--no-point).</translation>
    </message>
    <message>
        <source>The program is larger than a machine (%1): check its unit (G20, G21, --units) and its decimal points.</source>
        <translation>Le programme est plus grand qu’une machine (%1)&#xa0;: vérifiez son unité (G20, G21, --units) et ses points décimaux.</translation>
    </message>
    <message>
        <source>The words after &quot;;&quot; are read as a block of their own, as on the control. If &quot;;&quot; begins comments here, choose another dialect (--dialect).</source>
        <translation>Les mots après «&#xa0;;&#xa0;» sont lus comme un bloc à part, comme sur la commande. Si «&#xa0;;&#xa0;» commence ici des commentaires, choisissez un autre dialecte (--dialect).</translation>
    </message>
    <message>
        <source>The text does not show which control it is for, and they differ from here on: %1. Choose the dialect (--dialect).</source>
        <translation>Le texte n’indique pas pour quelle commande il est fait, et elles diffèrent à partir d’ici&#xa0;: %1. Choisissez le dialecte (--dialect).</translation>
    </message>
    <message>
        <source>The file has words of two controls (%1): split it, or choose the dialect (--dialect).</source>
        <translation>Le fichier contient des mots de deux commandes (%1)&#xa0;: divisez-le, ou choisissez le dialecte (--dialect).</translation>
    </message>
    <message>
        <source>The corner cannot be rounded or chamfered: there must be an element of the contour before and behind it, both long enough.</source>
        <translation>Le coin ne peut être ni arrondi ni chanfreiné&#xa0;: il faut avant et après un élément de contour assez long.</translation>
    </message>
    <message>
        <source>The program ends here with its own error (%1): check the values it has been given.</source>
        <translation>Le programme se termine ici avec sa propre erreur (%1)&#xa0;: vérifiez les valeurs qu’il a reçues.</translation>
    </message>
    <message>
        <source>The block lacks a word that the control needs (%1): add it.</source>
        <translation>Il manque au bloc un mot dont la commande a besoin (%1)&#xa0;: ajoutez-le.</translation>
    </message>
    <message>
        <source>%1 is not the number of the tool in the spindle: check which length it stands for.</source>
        <translation>%1 n’est pas le numéro de l’outil dans la broche&#xa0;: vérifiez à quelle longueur il correspond.</translation>
    </message>
    <message>
        <source>%1 executes a text that is put together while the program runs: what it does is not known here. Write the block itself.</source>
        <translation>%1 exécute un texte qui n’est composé que pendant l’exécution du programme : son effet n’est pas connu ici. Écrivez le bloc lui-même.</translation>
    </message>
    <message>
        <source>%1 limits the speed of an axis, and a stream does not keep the limit: program a feed that keeps it, and remove the word.</source>
        <translation>%1 limite la vitesse d’un axe, et un flux ne respecte pas cette limite : programmez une avance qui la respecte et supprimez le mot.</translation>
    </message>
    <message>
        <source>%1 calls a subprogram behind each block that moves, and it is neither in this file nor in a file beside it: its motions are missing. Put its file beside the program.</source>
        <translation>%1 appelle après chaque bloc de déplacement un sous-programme qui n’est ni dans ce fichier ni dans un fichier voisin : ses déplacements manquent. Placez son fichier à côté du programme.</translation>
    </message>
    <message>
        <source>What the program leaves out is taken from the settings of a virtual machine: %1. Load it as the control is set (--setting).</source>
        <translation>Ce que le programme omet est pris des réglages d’une machine virtuelle&#xa0;: %1. Chargez-le selon les réglages de la commande (--setting).</translation>
    </message>
    <message>
        <source>The number of the last F may mean another feed here, because mm, inch, G94 or G95 was chosen behind it: program F again.</source>
        <translation>Le nombre du dernier F peut signifier ici une autre avance, parce que mm, pouces, G94 ou G95 ont été choisis après : programmez F de nouveau.</translation>
    </message>
</context>
<context>
    <name>EmulatorPageTexts</name>
    <message>
        <source>A run is in progress. Learn after it has ended: both would take the same processor.</source>
        <translation>Une exécution est en cours. Apprendre ensuite&#xa0;: les deux demanderaient le même processeur.</translation>
    </message>
</context>
<context>
    <name>EmulatorTexts</name>
    <message>
        <source>Position gain</source>
        <translation>Gain de position</translation>
    </message>
    <message>
        <source>The larger it is, the smaller the following error.</source>
        <translation>Plus il est grand, plus l’erreur de poursuite est petite.</translation>
    </message>
    <message>
        <source>Feed-forward</source>
        <translation>Anticipation</translation>
    </message>
    <message>
        <source>Share of the speed that needs no following error. With 1 there is none at constant speed.</source>
        <translation>Part de la vitesse qui se passe d’erreur de poursuite. Avec 1, il n’y en a pas à vitesse constante.</translation>
    </message>
    <message>
        <source>Filter of the feed-forward</source>
        <translation>Filtre de l’anticipation</translation>
    </message>
    <message>
        <source>How late the feed-forward takes effect.</source>
        <translation>Retard avec lequel l’anticipation agit.</translation>
    </message>
    <message>
        <source>Speed gain</source>
        <translation>Gain de vitesse</translation>
    </message>
    <message>
        <source>How quickly the drive reaches the speed it is told.</source>
        <translation>Rapidité avec laquelle l’entraînement atteint la vitesse demandée.</translation>
    </message>
    <message>
        <source>Reset time</source>
        <translation>Temps d’intégration</translation>
    </message>
    <message>
        <source>How soon the drive removes the rest of an error in speed.</source>
        <translation>Délai pour que l’entraînement élimine le reste d’une erreur de vitesse.</translation>
    </message>
    <message>
        <source>Lag of the drive</source>
        <translation>Retard de l’entraînement</translation>
    </message>
    <message>
        <source>How late the force follows its command.</source>
        <translation>Retard de la force sur sa consigne.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Force against every motion, as the acceleration it costs. It makes the bumps where an axis reverses.</source>
        <translation>Force contre tout mouvement, exprimée par l’accélération qu’elle coûte. Elle fait les bosses aux inversions d’un axe.</translation>
    </message>
    <message>
        <source>Speed of friction</source>
        <translation>Vitesse du frottement</translation>
    </message>
    <message>
        <source>From this speed on, friction has its full force.</source>
        <translation>À partir de cette vitesse, le frottement agit pleinement.</translation>
    </message>
    <message>
        <source>Viscous friction</source>
        <translation>Frottement visqueux</translation>
    </message>
    <message>
        <source>Friction that grows with the speed.</source>
        <translation>Frottement qui croît avec la vitesse.</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Retard pur</translation>
    </message>
    <message>
        <source>Time until a set point takes effect.</source>
        <translation>Temps jusqu’à l’effet d’une consigne.</translation>
    </message>
    <message>
        <source>Resonance</source>
        <translation>Résonance</translation>
    </message>
    <message>
        <source>Frequency at which motor and table swing against each other.</source>
        <translation>Fréquence à laquelle le moteur et la table oscillent l’un contre l’autre.</translation>
    </message>
    <message>
        <source>Damping of the resonance</source>
        <translation>Amortissement de la résonance</translation>
    </message>
    <message>
        <source>The smaller it is, the longer the axis oscillates. At 1 it does not oscillate.</source>
        <translation>Plus il est petit, plus l’oscillation dure&#xa0;; avec 1, il n’y en a pas.</translation>
    </message>
    <message>
        <source>On %1, which it was not learned from, positions are right within %2 (RMS), %3 at most.</source>
        <translation>Sur %1, dont il n’a rien appris, les positions sont justes à %2 près (RMS), %3 au plus.</translation>
    </message>
    <message>
        <source>The contour error there is off by %1 of %2 (RMS).</source>
        <translation>L’erreur de contour s’y écarte de %1 sur %2 (RMS).</translation>
    </message>
    <message>
        <source>Good for simulating and timing programs that move %1 at feeds up to %2. What is faster was not tested.</source>
        <translation>Bon pour simuler des programmes qui déplacent %1 jusqu’à %2 et pour estimer leur durée. Au-delà, rien n’est vérifié.</translation>
    </message>
    <message>
        <source>Do not rely on the contour errors that it predicts.</source>
        <translation>Ne pas se fier aux erreurs de contour qu’il prédit.</translation>
    </message>
    <message>
        <source>Limits of speed, acceleration and jerk are those of preset %1: correct them in the file if the machine has others.</source>
        <translation>Les limites de vitesse, d’accélération et de jerk sont celles du préréglage %1&#xa0;: les corriger dans le fichier si la machine en a d’autres.</translation>
    </message>
    <message>
        <source>Acceleration and jerk are limited as the set points show (%1), all else as in preset %2.</source>
        <translation>L’accélération et le jerk sont limités comme le montrent les consignes (%1), tout le reste comme dans le préréglage %2.</translation>
    </message>
    <message>
        <source>It was tested only on parts of the same recordings: right within %1 (RMS). Add a recording of another program and use it to test.</source>
        <translation>Il n’a été vérifié que sur des parties des mêmes enregistrements : juste à %1 près (RMS). Ajouter l’enregistrement d’un autre programme et l’utiliser pour vérifier.</translation>
    </message>
</context>
<context>
    <name>ErrorTexts</name>
    <message>
        <source>Two columns have the same meaning. Choose one of them.</source>
        <translation>Deux colonnes ont le même sens. Choisir l’une d’elles.</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it exists and that you may read it.</source>
        <translation>Le fichier ne peut pas être lu. Vérifier qu’il existe et que vous avez le droit de le lire.</translation>
    </message>
    <message>
        <source>The program is empty. Choose a file with NC blocks.</source>
        <translation>Le programme est vide. Choisir un fichier avec des blocs CN.</translation>
    </message>
    <message>
        <source>The program moves no axis. Choose a program with G0, G1, G2 or G3.</source>
        <translation>Le programme ne déplace aucun axe. Choisir un programme avec G0, G1, G2 ou G3.</translation>
    </message>
    <message>
        <source>Parts of the program are not understood. See the list of findings.</source>
        <translation>Des parties du programme ne sont pas comprises. Voir la liste des observations.</translation>
    </message>
    <message>
        <source>The feed F must be between 0.001 and 1 000 000 mm/min.</source>
        <translation>L’avance F doit être comprise entre 0,001 et 1 000 000 mm/min.</translation>
    </message>
    <message>
        <source>The distance δ must be greater than zero.</source>
        <translation>La distance δ doit être supérieure à zéro.</translation>
    </message>
    <message>
        <source>N is too small. Choose at least 2 points per loop.</source>
        <translation>N est trop petit. Choisir au moins 2 points par boucle.</translation>
    </message>
    <message>
        <source>N is too small for this method. Choose more points per loop.</source>
        <translation>N est trop petit pour cette méthode. Choisir plus de points par boucle.</translation>
    </message>
    <message>
        <source>N points do not fit the R-parameters of the control. Choose a smaller N, the contiguous layout, or enlarge MD28050.</source>
        <translation>N points ne tiennent pas dans les paramètres R de la commande. Choisir un N plus petit ou la disposition contiguë, ou augmenter MD28050.</translation>
    </message>
    <message>
        <source>No axis is chosen. Choose at least one axis.</source>
        <translation>Aucun axe n’est choisi. Choisir au moins un axe.</translation>
    </message>
    <message>
        <source>The file cannot be written. Choose another folder.</source>
        <translation>Le fichier ne peut pas être écrit. Choisir un autre dossier.</translation>
    </message>
    <message>
        <source>This file is not a Rivulet recording.</source>
        <translation>Ce fichier n’est pas un enregistrement de Rivulet.</translation>
    </message>
    <message>
        <source>The recording was written by a newer Rivulet. Update this program to read it.</source>
        <translation>L’enregistrement vient d’un Rivulet plus récent. Mettre ce logiciel à jour pour le lire.</translation>
    </message>
    <message>
        <source>The recording is damaged. Everything before the damage was kept.</source>
        <translation>L’enregistrement est endommagé. Tout ce qui précède a été conservé.</translation>
    </message>
    <message>
        <source>The file cannot be written. Check the folder and the free space.</source>
        <translation>Le fichier ne peut pas être écrit. Vérifier le dossier et l’espace libre.</translation>
    </message>
    <message>
        <source>The program has been changed since the interrupted run. Restore it, or start from the beginning.</source>
        <translation>Le programme a été modifié depuis l’exécution interrompue. Le rétablir, ou recommencer depuis le début.</translation>
    </message>
    <message>
        <source>No OPC UA server answers at this endpoint. Check address, port and network.</source>
        <translation>Aucun serveur OPC UA ne répond à cette adresse. Vérifier l’adresse, le port et le réseau.</translation>
    </message>
    <message>
        <source>The connection to the control is lost. Check the machine, then connect again.</source>
        <translation>La connexion à la commande est perdue. Contrôler la machine, puis se reconnecter.</translation>
    </message>
    <message>
        <source>The control did not answer in time. Check the network and its load.</source>
        <translation>La commande n’a pas répondu à temps. Vérifier le réseau et sa charge.</translation>
    </message>
    <message>
        <source>The control does not have a variable that Rivulet needs. Check the configuration of the server.</source>
        <translation>Il manque à la commande une variable dont Rivulet a besoin. Vérifier la configuration du serveur.</translation>
    </message>
    <message>
        <source>A variable is write-protected. Give this user write access on the control.</source>
        <translation>Une variable est protégée en écriture. Donner à cet utilisateur le droit d’écriture sur la commande.</translation>
    </message>
    <message>
        <source>A value cannot be used; nothing was sent.</source>
        <translation>Une valeur est inutilisable&#xa0;; rien n’a été envoyé.</translation>
    </message>
    <message>
        <source>The control rejected the request.</source>
        <translation>La commande a refusé la requête.</translation>
    </message>
    <message>
        <source>The server is not a SINUMERIK (no SinumerikVarProvider). Check the endpoint.</source>
        <translation>Le serveur n’est pas une SINUMERIK (pas de SinumerikVarProvider). Vérifier l’adresse.</translation>
    </message>
    <message>
        <source>The server does not offer this function.</source>
        <translation>Le serveur ne propose pas cette fonction.</translation>
    </message>
    <message>
        <source>There is no such program on the control. Send the template first.</source>
        <translation>Ce programme n’existe pas sur la commande. Envoyer d’abord le modèle.</translation>
    </message>
    <message>
        <source>The channel is not in reset. Press reset at the control, then try again.</source>
        <translation>Le canal n’est pas en Reset. Appuyer sur Reset sur la commande, puis réessayer.</translation>
    </message>
    <message>
        <source>A program of this name is already on the control.</source>
        <translation>Un programme de ce nom existe déjà sur la commande.</translation>
    </message>
    <message>
        <source>The request is larger than the server accepts. Choose a smaller N.</source>
        <translation>La requête est plus grande que ce que le serveur accepte. Choisir un N plus petit.</translation>
    </message>
    <message>
        <source>This program cannot be streamed. See the list of findings.</source>
        <translation>Ce programme ne peut pas être transmis en continu. Voir la liste des observations.</translation>
    </message>
    <message>
        <source>The control does not run the expected template. Select and start the template for these settings.</source>
        <translation>La commande n’exécute pas le modèle attendu. Sélectionner et démarrer le modèle de ces réglages.</translation>
    </message>
    <message>
        <source>Another program is running on the control. Wait until it has ended, or reset the channel.</source>
        <translation>Un autre programme est en cours sur la commande. Attendre sa fin ou faire un Reset du canal.</translation>
    </message>
    <message>
        <source>Cycle start was not pressed in time. Start the run again.</source>
        <translation>Départ cycle n’a pas été actionné à temps. Redémarrer l’exécution.</translation>
    </message>
    <message>
        <source>The control is running, but the stream makes no progress. Check feed override and feed hold at the control.</source>
        <translation>La commande est en marche, mais la transmission n’avance pas. Vérifier sur la commande l’override d’avance et l’arrêt avance.</translation>
    </message>
    <message>
        <source>The control did not confirm the stop in time. Check the machine.</source>
        <translation>La commande n’a pas confirmé l’arrêt à temps. Contrôler la machine.</translation>
    </message>
    <message>
        <source>The control ended the program with an alarm. Clear its cause at the control.</source>
        <translation>La commande a terminé le programme par une alarme. En éliminer la cause sur la commande.</translation>
    </message>
    <message>
        <source>The program on the control ended before all of it was executed.</source>
        <translation>Le programme de la commande s’est terminé avant d’être entièrement exécuté.</translation>
    </message>
    <message>
        <source>Another client is using the program on the control. Rivulet writes nothing more: wait until the other client has finished, or reset the control.</source>
        <translation>Un autre client utilise le programme sur la commande. Rivulet n’écrit plus rien&#xa0;: attendre que l’autre client ait fini, ou faire un Reset de la commande.</translation>
    </message>
    <message>
        <source>The program on the control was restarted during the run. Reset the control, then resume.</source>
        <translation>Le programme sur la commande a été redémarré pendant l’exécution. Faire un Reset de la commande, puis reprendre.</translation>
    </message>
    <message>
        <source>The control rejected a window that did not match its check number, and did not execute it. Something else writes these R-parameters, or a value was changed on its way: look for another client, or connect encrypted, then resume.</source>
        <translation>La commande a refusé une fenêtre qui ne correspondait pas à son numéro de contrôle et ne l’a pas exécutée. Autre chose écrit dans ces paramètres R, ou une valeur a été altérée en chemin&#xa0;: chercher un autre client, ou se connecter avec chiffrement, puis reprendre.</translation>
    </message>
    <message>
        <source>The control ended its program because it received nothing from Rivulet for too long. Check the network, then resume.</source>
        <translation>La commande a terminé son programme parce qu’elle n’a rien reçu de Rivulet pendant trop longtemps. Vérifier le réseau, puis reprendre.</translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation>Le chargement a été annulé.</translation>
    </message>
    <message>
        <source>It is not known for certain where the run was left. Start from the beginning.</source>
        <translation>On ne sait pas avec certitude où l’exécution s’est interrompue. Recommencer depuis le début.</translation>
    </message>
    <message>
        <source>The control does not let Rivulet write and read part programs. Grant the OPC UA user these rights, or copy the template to the control by hand.</source>
        <translation>La commande ne laisse pas Rivulet écrire et lire des programmes pièce. Donner ces droits à l’utilisateur OPC UA, ou copier le modèle à la main sur la commande.</translation>
    </message>
    <message>
        <source>Only method window streams rotary axes. Choose it.</source>
        <translation>Seule la méthode Fenêtre transmet des axes rotatifs. Choisir cette méthode.</translation>
    </message>
    <message>
        <source>Too many axes. Choose at most five.</source>
        <translation>Trop d’axes. En choisir cinq au plus.</translation>
    </message>
    <message>
        <source>These are not axes. Choose from X, Y, Z, A, B and C.</source>
        <translation>Ce ne sont pas des axes. Choisir parmi X, Y, Z, A, B et C.</translation>
    </message>
    <message>
        <source>This make of control cannot do that. Choose another method or setting.</source>
        <translation>Cette commande ne sait pas faire cela. Choisir une autre méthode ou un autre réglage.</translation>
    </message>
    <message>
        <source>The program needs an axis that is not streamed. Move it to the position in the program, or stream it too.</source>
        <translation>Le programme a besoin d’un axe qui n’est pas transmis. L’amener à la position du programme, ou le transmettre aussi.</translation>
    </message>
    <message>
        <source>The control lacks an axis that the program moves. Use a program for the axes of this machine.</source>
        <translation>Il manque à la commande un axe que le programme déplace. Utiliser un programme pour les axes de cette machine.</translation>
    </message>
    <message>
        <source>No prediction is possible for this method.</source>
        <translation>Aucune prédiction n’est possible pour cette méthode.</translation>
    </message>
    <message>
        <source>The test was aborted. Reset the control if its program is still running.</source>
        <translation>Le test a été interrompu. Faire un Reset de la commande si son programme est encore en cours.</translation>
    </message>
    <message>
        <source>Method credit is experimental and starts only on a control that has passed its test. Pass it on the page Credit test, or choose method window.</source>
        <translation>La méthode Crédit est expérimentale et ne démarre que sur une commande qui a réussi son test. Lancer le test à la page Test crédit, ou choisir la méthode Fenêtre.</translation>
    </message>
    <message>
        <source>Online correction is possible with method window, for X, Y and Z, up to 1 mm.</source>
        <translation>La correction en ligne est possible avec la méthode Fenêtre, pour X, Y et Z, jusqu’à 1 mm.</translation>
    </message>
    <message>
        <source>An overlay is already active on the axes. Remove it at the control: press reset, wait, and check that $AA_OFF is 0.</source>
        <translation>Une superposition est déjà active sur les axes. La supprimer sur la commande&#xa0;: appuyer sur Reset, attendre et vérifier que $AA_OFF est à 0.</translation>
    </message>
    <message>
        <source>The control adds up overlaid values (MD36750 bit 0). Set the bit to 0, or do without online correction.</source>
        <translation>La commande additionne les valeurs superposées (MD36750 bit 0). Mettre le bit à 0, ou renoncer à la correction en ligne.</translation>
    </message>
    <message>
        <source>This is not a machine file of Rivulet. Move the file away.</source>
        <translation>Ce n’est pas un fichier machine de Rivulet. Le déplacer ailleurs.</translation>
    </message>
    <message>
        <source>This was written by another version of Rivulet. Measure again.</source>
        <translation>Ce fichier vient d’une autre version de Rivulet. Refaire la mesure.</translation>
    </message>
    <message>
        <source>The calibration is damaged. Measure again.</source>
        <translation>L’étalonnage est endommagé. Refaire la mesure.</translation>
    </message>
    <message>
        <source>Another client has claimed the R-parameters of this run and is about to start. Nothing was changed. Wait until its run has ended.</source>
        <translation>Un autre client a réservé les paramètres R de cette exécution et va démarrer. Rien n’a été modifié. Attendre la fin de son exécution.</translation>
    </message>
    <message>
        <source>A block of the program moves at a feed that is not known: F is missing, G95 has no spindle speed, or G93 no length. Choose one feed for all moves.</source>
        <translation>Un bloc du programme se déplace à une avance inconnue&#xa0;: il manque F, la vitesse de broche pour G95 ou la longueur pour G93. Choisir une seule avance pour tous les mouvements.</translation>
    </message>
    <message>
        <source>This method has one feed for all moves, as it was published.</source>
        <translation>Cette méthode a une seule avance pour tous les mouvements, comme dans sa publication.</translation>
    </message>
    <message>
        <source>The override is out of range: choose 1 to 200 %.</source>
        <translation>L’override est hors plage&#xa0;: choisir de 1 à 200&#xa0;%.</translation>
    </message>
    <message>
        <source>The formula is not understood from here on.</source>
        <translation>La formule n’est pas comprise à partir d’ici.</translation>
    </message>
    <message>
        <source>The formula is not complete.</source>
        <translation>La formule n’est pas complète.</translation>
    </message>
    <message>
        <source>There is no such function. Press F1 for those there are.</source>
        <translation>Cette fonction n’existe pas. F1 montre celles qui existent.</translation>
    </message>
    <message>
        <source>The trace has no such signal. The tool tips of the signals have their names.</source>
        <translation>Le tracé n’a pas ce signal. Les noms sont dans les infobulles des signaux.</translation>
    </message>
    <message>
        <source>This is no trace that can be read: there are no rows of numbers in it.</source>
        <translation>Ce n’est pas un tracé lisible : le fichier n’a pas de lignes de nombres.</translation>
    </message>
    <message>
        <source>The table has no such column.</source>
        <translation>Le tableau n’a pas cette colonne.</translation>
    </message>
    <message>
        <source>The trace has no positions: compare it by time.</source>
        <translation>Le tracé n’a pas de positions : le comparer selon le temps.</translation>
    </message>
    <message>
        <source>To compare by points, open the NC program that the traces show.</source>
        <translation>Pour comparer par points, ouvrir le programme CN que montrent les tracés.</translation>
    </message>
    <message>
        <source>The runs are of different programs: compare them by time or path.</source>
        <translation>Les exécutions sont de programmes différents : les comparer selon le temps ou le trajet.</translation>
    </message>
    <message>
        <source>A spectrum needs 16 samples or more between the cursors.</source>
        <translation>Un spectre demande au moins 16 échantillons entre les curseurs.</translation>
    </message>
    <message>
        <source>The server does not offer the encryption that is required. Set it up on the control, or allow this machine to be reached without it.</source>
        <translation>Le serveur ne propose pas le chiffrement exigé. Configurez-le sur la commande, ou autorisez une connexion non chiffrée pour cette machine.</translation>
    </message>
    <message>
        <source>The server&apos;s certificate is not known yet. Compare its fingerprint with the one at the control, then accept it.</source>
        <translation>Le certificat du serveur n&apos;est pas encore connu. Comparez son empreinte avec celle de la commande, puis acceptez-le.</translation>
    </message>
    <message>
        <source>The server shows another certificate than the one that was accepted. Find out why before you accept it.</source>
        <translation>Le serveur présente un autre certificat que celui qui a été accepté. Cherchez-en la raison avant de l&apos;accepter.</translation>
    </message>
    <message>
        <source>A certificate cannot be used: it is damaged or has ended. Create a new one.</source>
        <translation>Un certificat est inutilisable : il est endommagé ou expiré. Créez-en un nouveau.</translation>
    </message>
    <message>
        <source>The server does not trust the certificate of this computer. Accept it at the control, then connect again.</source>
        <translation>Le serveur ne fait pas confiance au certificat de cet ordinateur. Acceptez-le sur la commande, puis reconnectez-vous.</translation>
    </message>
    <message>
        <source>The server refuses user name or password. Check both.</source>
        <translation>Le serveur refuse le nom d&apos;utilisateur ou le mot de passe. Vérifiez les deux.</translation>
    </message>
    <message>
        <source>The line is neither a point nor end, hold or comment.</source>
        <translation>La ligne n’est ni un point, ni end, hold ou comment.</translation>
    </message>
    <message>
        <source>A word of the line has no number.</source>
        <translation>Un mot de la ligne n’a pas de nombre.</translation>
    </message>
    <message>
        <source>The line is too long.</source>
        <translation>La ligne est trop longue.</translation>
    </message>
    <message>
        <source>The source was closed in the middle of the line.</source>
        <translation>La source a été fermée au milieu de la ligne.</translation>
    </message>
    <message>
        <source>The point is outside the agreed box.</source>
        <translation>Le point est hors du pavé convenu.</translation>
    </message>
    <message>
        <source>The step to the point is longer than agreed.</source>
        <translation>Le pas vers le point est plus long que convenu.</translation>
    </message>
    <message>
        <source>A rotary axis would turn farther in one step than agreed.</source>
        <translation>Un axe rotatif tournerait plus que convenu en un pas.</translation>
    </message>
    <message>
        <source>F is larger than agreed, or not above 0.</source>
        <translation>F est plus grand que convenu, ou n’est pas supérieur à 0.</translation>
    </message>
    <message>
        <source>The first point is farther from the tool than agreed. Move the tool there, or begin where it is.</source>
        <translation>Le premier point est plus loin de l’outil que convenu. Y amener l’outil, ou commencer là où il est.</translation>
    </message>
    <message>
        <source>The point names an axis that is not one of this run.</source>
        <translation>Le point nomme un axe qui n’est pas de cette exécution.</translation>
    </message>
    <message>
        <source>A point is missing or came twice: the numbers are not in order.</source>
        <translation>Un point manque ou est arrivé deux fois&#xa0;: les numéros ne se suivent pas.</translation>
    </message>
    <message>
        <source>The source was closed without end.</source>
        <translation>La source a été fermée sans end.</translation>
    </message>
    <message>
        <source>The source was silent for longer than agreed.</source>
        <translation>La source est restée muette plus longtemps que convenu.</translation>
    </message>
    <message>
        <source>The source was faster than the machine and cannot wait. Send fewer points, or use TCP.</source>
        <translation>La source était plus rapide que la machine et ne peut pas attendre. Envoyer moins de points, ou utiliser TCP.</translation>
    </message>
    <message>
        <source>The source ended before its first point. Nothing has moved.</source>
        <translation>La source s’est terminée avant son premier point. Rien n’a bougé.</translation>
    </message>
    <message>
        <source>The source cannot be opened. Choose another port or path.</source>
        <translation>La source ne peut pas être ouverte. Choisir un autre port ou chemin.</translation>
    </message>
    <message>
        <source>These values cannot be kept together. Check box, step and times.</source>
        <translation>Ces valeurs ne vont pas ensemble. Vérifier pavé, pas et temps.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>This source can lose points, so it has to number them: N1 X0.5, then N2.</source>
        <translation>Cette source peut perdre des points et doit donc les numéroter : N1 X0.5, puis N2.</translation>
    </message>
    <message>
        <source>The file of the source is not as the manual shows it (Live points).</source>
        <translation>Le fichier de la source n’est pas conforme au manuel (points en direct).</translation>
    </message>
    <message>
        <source>This Rivulet was built without HDF5. Use CSV, or build it with libhdf5-dev.</source>
        <translation>Ce Rivulet a été compilé sans HDF5. Utiliser CSV ou le compiler avec libhdf5-dev.</translation>
    </message>
    <message>
        <source>Times and positions do not fit together. Record the run again.</source>
        <translation>Les temps et les positions ne vont pas ensemble. Enregistrer de nouveau l’exécution.</translation>
    </message>
    <message>
        <source>A value is not a number. Leave its row out of the file.</source>
        <translation>Une valeur n’est pas un nombre. Retirer sa ligne du fichier.</translation>
    </message>
    <message>
        <source>An axis does not move in these recordings. Add one that moves it.</source>
        <translation>Un axe ne bouge pas dans ces enregistrements. En ajouter un qui le déplace.</translation>
    </message>
    <message>
        <source>There are too few samples to learn from. Record a longer program, with set points and actual positions.</source>
        <translation>Il y a trop peu d’échantillons pour apprendre. Enregistrer un programme plus long, avec consignes et positions réelles.</translation>
    </message>
    <message>
        <source>Set points and actual positions differ by a factor. Check their units.</source>
        <translation>Les consignes et les positions réelles diffèrent d’un facteur. Vérifier leurs unités.</translation>
    </message>
    <message>
        <source>Recording and program do not fit together. Check the program, and that the preset has the machine&apos;s limits.</source>
        <translation>L’enregistrement et le programme ne vont pas ensemble. Vérifier le programme et que le préréglage a les limites de la machine.</translation>
    </message>
    <message>
        <source>No model follows this recording. Check that set points and positions belong together.</source>
        <translation>Aucun modèle ne suit cet enregistrement. Vérifier que consignes et positions vont ensemble.</translation>
    </message>
    <message>
        <source>Learning was cancelled. What was learned before stays.</source>
        <translation>L’apprentissage a été annulé. Ce qui a été appris auparavant reste.</translation>
    </message>
    <message>
        <source>The file is not an emulator, or one of a later version.</source>
        <translation>Le fichier n’est pas un émulateur, ou vient d’une version plus récente.</translation>
    </message>
    <message>
        <source>Rivulet was built without Qt OPC UA. Connect with open62541.</source>
        <translation>Rivulet a été compilé sans Qt OPC UA. Connectez-vous avec open62541.</translation>
    </message>
    <message>
        <source>Qt OPC UA cannot encrypt, log in or use a map here. Connect with open62541.</source>
        <translation>Qt OPC UA ne peut ici ni chiffrer, ni ouvrir une session, ni utiliser une table de correspondance. Connectez-vous avec open62541.</translation>
    </message>
    <message>
        <source>The map cannot be used. Correct the file at the place that is named.</source>
        <translation>La table de correspondance est inutilisable. Corrigez le fichier à l&apos;endroit indiqué.</translation>
    </message>
    <message>
        <source>The map names a node that the server does not have, or one of another type. Correct the map.</source>
        <translation>La table de correspondance nomme un nœud que le serveur n&apos;a pas, ou d&apos;un autre type. Corrigez-la.</translation>
    </message>
    <message>
        <source>No computer of this name is known on the network. Check the name, or give the IP address of the control.</source>
        <translation>Aucun ordinateur de ce nom n&apos;est connu sur le réseau. Vérifiez le nom, ou indiquez l&apos;adresse IP de la commande.</translation>
    </message>
    <message>
        <source>Too many files and connections are open on this computer. Close other programs, then try again.</source>
        <translation>Trop de fichiers et de connexions sont ouverts sur cet ordinateur. Fermez d&apos;autres programmes, puis réessayez.</translation>
    </message>
    <message>
        <source>The text leaves open what it means. Choose the dialect, the unit or the reading of numbers without a decimal point.</source>
        <translation>Le texte laisse ouvert ce qu’il signifie. Choisissez le dialecte, l’unité ou la lecture des nombres sans point décimal.</translation>
    </message>
    <message>
        <source>The straight way to the first point passes within what the program cuts. Raise the tool first.</source>
        <translation>Le trajet direct vers le premier point traverse la zone que le programme usine. Relevez d&apos;abord l&apos;outil.</translation>
    </message>
    <message>
        <source>This would take more memory than a file may. Choose a smaller one.</source>
        <translation>Cela prendrait plus de mémoire qu’un fichier ne peut en occuper. En choisir un plus petit.</translation>
    </message>
    <message>
        <source>A factor of the feed would wait here behind points that are not read yet. Send factors over a source of their own.</source>
        <translation>Un facteur de l’avance attendrait ici derrière des points qui ne sont pas encore lus. Envoyer les facteurs par une source à part.</translation>
    </message>
    <message>
        <source>A factor of the override is possible with methods window and credit, from 0.01 to 2, with 1 between its bounds.</source>
        <translation>Un facteur de l’override est possible avec les méthodes Fenêtre et Crédit, de 0,01 à 2, avec 1 entre ses limites.</translation>
    </message>
    <message>
        <source>The move of the test takes 2 to 30 s at its feed, so that it can be held on its way. Choose another length or feed.</source>
        <translation>Le déplacement du test dure de 2 à 30 s à son avance, afin de pouvoir être arrêté en chemin. Choisissez une autre longueur ou une autre avance.</translation>
    </message>
    <message>
        <source>This is no trace, but the refusal of an MTConnect agent. Ask it for /sample.</source>
        <translation>Ceci n’est pas une trace, mais le refus d’un agent MTConnect. Lui demander /sample.</translation>
    </message>
    <message>
        <source>The server keeps no history of this node. Have it recorded at the server.</source>
        <translation>Le serveur ne conserve aucun historique de ce nœud. Le faire enregistrer sur le serveur.</translation>
    </message>
    <message>
        <source>The R-parameters of method window are out of range. Check base, stride and number of windows.</source>
        <translation>Les paramètres R de la méthode Fenêtre sont hors plage. Vérifier la base, le pas et le nombre de fenêtres.</translation>
    </message>
    <message>
        <source>These R-parameters cannot be used. Choose some that exist (MD28050).</source>
        <translation>Ces paramètres R ne peuvent pas servir. Choisissez-en qui existent (MD28050).</translation>
    </message>
    <message>
        <source>A program is running on the control: the measurement has ended. The R-parameters have their old values.</source>
        <translation>Un programme est en cours sur la commande : la mesure a été arrêtée. Les paramètres R ont leurs anciennes valeurs.</translation>
    </message>
    <message>
        <source>The calibration was cancelled. The R-parameters have their old values.</source>
        <translation>L’étalonnage a été annulé. Les paramètres R ont leurs anciennes valeurs.</translation>
    </message>
    <message>
        <source>The R-parameters could not be restored and may hold test values. Set them at the control.</source>
        <translation>Les paramètres R n’ont pas pu être rétablis et contiennent peut-être des valeurs de test. Réglez-les à la commande.</translation>
    </message>
    <message>
        <source>The control does not obey the override: pause, stop and override would not act. Nothing was moved. Check that a SINUMERIK has synchronized actions, or a LinuxCNC the components of docs/linuxcnc.md.</source>
        <translation>La commande n’obéit pas à l’override : pause, arrêt et override n’agiraient pas. Rien n’a bougé. Vérifiez qu’une SINUMERIK a les actions synchrones, ou un LinuxCNC les composants de docs/linuxcnc.md.</translation>
    </message>
    <message>
        <source>The path cannot be kept within this tolerance. Allow more of it, or none; packed points are moved by up to 0.001 mm.</source>
        <translation>La trajectoire ne peut pas être tenue dans cette tolérance. Autorisez davantage, ou aucune ; les points compactés sont déplacés jusqu’à 0,001 mm.</translation>
    </message>
    <message>
        <source>This block cannot be tried: the control of a job would not execute it itself, or it ends the program. Name blocks as a program has them, as in &quot;S500 M3&quot;.</source>
        <translation>Ce bloc ne peut pas être essayé : dans une tâche, la commande ne l’exécuterait pas elle-même, ou il termine le programme. Saisir les blocs comme dans un programme, par exemple « S500 M3 ».</translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message>
        <source>the character &quot;%1&quot; has no meaning here</source>
        <translation>le caractère «&#xa0;%1&#xa0;» n’a pas de sens ici</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>a comment is not closed</source>
        <translation>un commentaire n’est pas fermé</translation>
    </message>
    <message>
        <source>%1 is not known to this machine</source>
        <translation>%1 n’est pas connu de cette machine</translation>
    </message>
    <message>
        <source>the word %1 is not understood here</source>
        <translation>le mot %1 n’est pas compris ici</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not understood</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas compris</translation>
    </message>
    <message>
        <source>two functions of one group are in the block: %1</source>
        <translation>deux fonctions d’un même groupe sont dans le bloc&#xa0;: %1</translation>
    </message>
    <message>
        <source>the address %1 is programmed more than once in the block</source>
        <translation>l’adresse %1 est programmée plusieurs fois dans le bloc</translation>
    </message>
    <message>
        <source>circle end-point error: there is no circle through these points</source>
        <translation>erreur de point final de cercle&#xa0;: aucun cercle ne passe par ces points</translation>
    </message>
    <message>
        <source>circle end-point error: the radii at start and end differ by %1 mm</source>
        <translation>erreur de point final de cercle&#xa0;: les rayons au départ et à la fin diffèrent de %1 mm</translation>
    </message>
    <message>
        <source>circle end-point error: the radius is too small (%1)</source>
        <translation>erreur de point final de cercle&#xa0;: le rayon est trop petit (%1)</translation>
    </message>
    <message>
        <source>the arc starts at an unknown position: %1</source>
        <translation>l’arc commence à une position inconnue&#xa0;: %1</translation>
    </message>
    <message>
        <source>the increment of %1 starts at an unknown position</source>
        <translation>la cote relative de %1 part d’une position inconnue</translation>
    </message>
    <message>
        <source>no feed is programmed</source>
        <translation>aucune avance n’est programmée</translation>
    </message>
    <message>
        <source>the programmed path speed %1 is not positive</source>
        <translation>la vitesse programmée sur la trajectoire %1 n’est pas positive</translation>
    </message>
    <message>
        <source>the value of %1 is out of range</source>
        <translation>la valeur de %1 est hors plage</translation>
    </message>
    <message>
        <source>circle end-point error: %1 is not in the plane of the arc</source>
        <translation>erreur de point final de cercle&#xa0;: %1 n’est pas dans le plan de l’arc</translation>
    </message>
    <message>
        <source>%1 is not a cycle of this machine</source>
        <translation>%1 n’est pas un cycle de cette machine</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>il manque une valeur</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a value</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une valeur</translation>
    </message>
    <message>
        <source>a constant in quotes is written &apos;H1F&apos; or &apos;B101&apos;</source>
        <translation>une constante entre apostrophes s’écrit &apos;H1F&apos; ou &apos;B101&apos;</translation>
    </message>
    <message>
        <source>a text in quotes is expected</source>
        <translation>un texte entre guillemets est attendu</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>une parenthèse n’est pas fermée</translation>
    </message>
    <message>
        <source>an operand is missing</source>
        <translation>il manque un opérande</translation>
    </message>
    <message>
        <source>the calculation is nested too deeply</source>
        <translation>le calcul est imbriqué trop profondément</translation>
    </message>
    <message>
        <source>%1 is neither a variable nor a function</source>
        <translation>%1 n’est ni une variable ni une fonction</translation>
    </message>
    <message>
        <source>%1 needs its argument in brackets</source>
        <translation>%1 demande son argument entre parenthèses</translation>
    </message>
    <message>
        <source>%1 needs more arguments</source>
        <translation>%1 demande plus d’arguments</translation>
    </message>
    <message>
        <source>ATAN is written ATAN[y]/[x]</source>
        <translation>ATAN s’écrit ATAN[y]/[x]</translation>
    </message>
    <message>
        <source>EXISTS is written EXISTS[#&lt;name&gt;]</source>
        <translation>EXISTS s’écrit EXISTS[#&lt;name&gt;]</translation>
    </message>
    <message>
        <source>R needs a number or an index in brackets</source>
        <translation>R demande un numéro ou un indice entre crochets</translation>
    </message>
    <message>
        <source>the number of a variable is missing or too large</source>
        <translation>le numéro d’une variable manque ou est trop grand</translation>
    </message>
    <message>
        <source>the name of a variable is not closed with &gt;</source>
        <translation>le nom d’une variable n’est pas fermé par &gt;</translation>
    </message>
    <message>
        <source>%1 is not a variable</source>
        <translation>%1 n’est pas une variable</translation>
    </message>
    <message>
        <source>%1 needs an axis or an index in brackets</source>
        <translation>%1 demande un axe ou un indice entre crochets</translation>
    </message>
    <message>
        <source>an equals sign is missing</source>
        <translation>il manque un signe égal</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be assigned to</source>
        <translation>on ne peut pas affecter de valeur à «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>SET and REP need a list in brackets, with commas between its values</source>
        <translation>SET et REP demandent une liste entre parenthèses, avec des virgules entre les valeurs</translation>
    </message>
    <message>
        <source>the name of a variable is missing</source>
        <translation>il manque le nom d’une variable</translation>
    </message>
    <message>
        <source>%1 is not a type for DEF</source>
        <translation>%1 n’est pas un type pour DEF</translation>
    </message>
    <message>
        <source>the size of an array is missing or too large</source>
        <translation>la taille d’un tableau manque ou est trop grande</translation>
    </message>
    <message>
        <source>the parameters of PROC are written PROC name(type name, ...)</source>
        <translation>les paramètres de PROC s’écrivent PROC nom(type nom, ...)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing, or has no meaning here</source>
        <translation>«&#xa0;%1&#xa0;» manque ou n’a pas de sens ici</translation>
    </message>
    <message>
        <source>an address needs a number or &quot;=&quot;</source>
        <translation>une adresse demande un nombre ou «&#xa0;=&#xa0;»</translation>
    </message>
    <message>
        <source>the jump has no target</source>
        <translation>le saut n’a pas de destination</translation>
    </message>
    <message>
        <source>only GOTO may follow a condition</source>
        <translation>seul GOTO peut suivre une condition</translation>
    </message>
    <message>
        <source>FOR is written FOR i = a TO b</source>
        <translation>FOR s’écrit FOR i = a TO b</translation>
    </message>
    <message>
        <source>CASE is written CASE(value) OF constant GOTOF target</source>
        <translation>CASE s’écrit CASE(valeur) OF constante GOTOF destination</translation>
    </message>
    <message>
        <source>the %1 that begins here is not closed</source>
        <translation>le %1 qui commence ici n’est pas fermé</translation>
    </message>
    <message>
        <source>%1 has no beginning</source>
        <translation>%1 n’a pas de début</translation>
    </message>
    <message>
        <source>control structures are nested more than 16 deep</source>
        <translation>les structures de contrôle sont imbriquées sur plus de 16 niveaux</translation>
    </message>
    <message>
        <source>a synchronized action needs a number from 1 to 255</source>
        <translation>une action synchrone demande un numéro de 1 à 255</translation>
    </message>
    <message>
        <source>a synchronized action is written ID=1 WHEN condition DO assignment</source>
        <translation>une action synchrone s’écrit ID=1 WHEN condition DO affectation</translation>
    </message>
    <message>
        <source>a synchronized action can only assign to $R and variables of the main run</source>
        <translation>une action synchrone ne peut affecter que $R et des variables du traitement principal</translation>
    </message>
    <message>
        <source>the target %1 is missing</source>
        <translation>la destination %1 manque</translation>
    </message>
    <message>
        <source>the program %1 does not exist</source>
        <translation>le programme %1 n’existe pas</translation>
    </message>
    <message>
        <source>%1 is not defined, and there is no program of this name</source>
        <translation>%1 n’est pas défini et il n’y a pas de programme de ce nom</translation>
    </message>
    <message>
        <source>subprograms call each other too deeply</source>
        <translation>les sous-programmes s’appellent sur trop de niveaux</translation>
    </message>
    <message>
        <source>a division by zero</source>
        <translation>division par zéro</translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation>%1 n’a pas de valeur</translation>
    </message>
    <message>
        <source>the result is too large</source>
        <translation>le résultat est trop grand</translation>
    </message>
    <message>
        <source>it needs a value that is not known</source>
        <translation>une valeur nécessaire n’est pas connue</translation>
    </message>
    <message>
        <source>R%1 is read before the program sets it: only the control knows it</source>
        <translation>R%1 est lu avant que le programme ne l’affecte&#xa0;: seule la commande le connaît</translation>
    </message>
    <message>
        <source>R[%1] does not exist</source>
        <translation>R[%1] n’existe pas</translation>
    </message>
    <message>
        <source>%1 is not defined</source>
        <translation>%1 n’est pas défini</translation>
    </message>
    <message>
        <source>an array needs its index in brackets</source>
        <translation>un tableau demande son indice entre crochets</translation>
    </message>
    <message>
        <source>the array has fewer dimensions</source>
        <translation>le tableau a moins de dimensions</translation>
    </message>
    <message>
        <source>the array has more dimensions</source>
        <translation>le tableau a plus de dimensions</translation>
    </message>
    <message>
        <source>the index is outside the array</source>
        <translation>l’indice est hors du tableau</translation>
    </message>
    <message>
        <source>a calculation uses a text</source>
        <translation>un calcul utilise un texte</translation>
    </message>
    <message>
        <source>the value is not of type %1</source>
        <translation>la valeur n’est pas du type %1</translation>
    </message>
    <message>
        <source>the value is outside the range of type %1</source>
        <translation>la valeur est hors de la plage du type %1</translation>
    </message>
    <message>
        <source>the list has more values than the array has elements</source>
        <translation>la liste a plus de valeurs que le tableau n’a d’éléments</translation>
    </message>
    <message>
        <source>only the control knows the value of %1</source>
        <translation>seule la commande connaît la valeur de %1</translation>
    </message>
    <message>
        <source>a variable of the control would be written</source>
        <translation>une variable de la commande serait écrite</translation>
    </message>
    <message>
        <source>the subprogram takes %1 values</source>
        <translation>le sous-programme attend %1 valeurs</translation>
    </message>
    <message>
        <source>the parameter %1 is given by reference and needs a variable</source>
        <translation>le paramètre %1 est transmis par référence et demande une variable</translation>
    </message>
    <message>
        <source>the parameter %1 is given by reference and needs a variable of its own type</source>
        <translation>le paramètre %1 est transmis par référence et demande une variable de son propre type</translation>
    </message>
    <message>
        <source>a synchronized action reads R or an array by an index of the main run: use $R</source>
        <translation>une action synchrone lit R ou un tableau par un indice du traitement principal&#xa0;: utiliser $R</translation>
    </message>
    <message>
        <source>GOTO or THEN must follow a condition</source>
        <translation>GOTO ou THEN doit suivre une condition</translation>
    </message>
    <message>
        <source>WHILE is written WHILE [condition] DO1</source>
        <translation>WHILE s’écrit WHILE [condition] DO1</translation>
    </message>
    <message>
        <source>an O word needs a number or &lt;name&gt;</source>
        <translation>un mot O demande un numéro ou &lt;name&gt;</translation>
    </message>
    <message>
        <source>%1 is not known</source>
        <translation>%1 n’est pas connu</translation>
    </message>
    <message>
        <source>%1 is not in a loop</source>
        <translation>%1 n’est pas dans une boucle</translation>
    </message>
    <message>
        <source>%1 has no call</source>
        <translation>%1 n’a pas d’appel</translation>
    </message>
    <message>
        <source>a subprogram is defined inside %1</source>
        <translation>un sous-programme est défini à l’intérieur de %1</translation>
    </message>
    <message>
        <source>a blank is inside the number &quot;%1&quot;</source>
        <translation>un espace se trouve dans le nombre «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the invisible character %1 has no meaning here</source>
        <translation>le caractère invisible %1 n’a pas de sens ici</translation>
    </message>
    <message>
        <source>a bracket is opened within the comment %1</source>
        <translation>une parenthèse est ouverte dans le commentaire %1</translation>
    </message>
    <message>
        <source>the program has more than %1 variables</source>
        <translation>le programme a plus de %1 variables</translation>
    </message>
    <message>
        <source>%1 cannot be written by a program here</source>
        <translation>%1 ne peut pas être écrit ici par un programme</translation>
    </message>
    <message>
        <source>the program stops here with its alarm %1</source>
        <translation>le programme s’arrête ici avec son alarme %1</translation>
    </message>
    <message>
        <source>the file holds two programs of the name %1: rename or remove one of them</source>
        <translation>le fichier contient deux programmes du nom %1&#xa0;: renommez ou supprimez l’un d’eux</translation>
    </message>
    <message>
        <source>the unit of the feed was chosen behind the last F</source>
        <translation>l&apos;unité de l&apos;avance a été choisie après le dernier F</translation>
    </message>
    <message>
        <source>the program takes more memory than is allowed: split it</source>
        <translation>le programme prend plus de mémoire qu’il n’est permis&#xa0;: le diviser</translation>
    </message>
    <message>
        <source>the block lacks a word that the control needs (%1)</source>
        <translation>il manque au bloc un mot dont la commande a besoin (%1)</translation>
    </message>
    <message>
        <source>the block cannot be executed here (%1)</source>
        <translation>le bloc ne peut pas être exécuté ici (%1)</translation>
    </message>
</context>
<context>
    <name>FeedTestTexts</name>
    <message>
        <source>no axis was moved</source>
        <translation>aucun axe n’a été déplacé</translation>
    </message>
    <message>
        <source>4. The override is changed while the axis moves. Then press cycle start once more: the next program must move at its own feed, and only the control can stop it.</source>
        <translation>4. L’override est modifié pendant que l’axe se déplace. Appuyez ensuite encore une fois sur Départ cycle&#xa0;: le programme suivant doit se déplacer à sa propre avance, et seule la commande peut l’arrêter.</translation>
    </message>
    <message>
        <source>4. The override is changed; no axis moves.</source>
        <translation>4. L’override est modifié&#xa0;; aucun axe ne se déplace.</translation>
    </message>
    <message>
        <source>Not tested: on this control a stop is sure to act only before the next window</source>
        <translation>Non testé&#xa0;: sur cette commande, un arrêt n’agit avec certitude qu’avant la fenêtre suivante</translation>
    </message>
    <message>
        <source>Passed: stop, pause and override act at once on this control</source>
        <translation>Réussi&#xa0;: arrêt, pause et override agissent aussitôt sur cette commande</translation>
    </message>
    <message>
        <source>Passed without motion. Whether the axes obey shows only when one moves.</source>
        <translation>Réussi sans mouvement. Si les axes obéissent ne se voit que lorsqu’un axe se déplace.</translation>
    </message>
    <message>
        <source>Not passed: on this control a stop is sure to act only before the next window</source>
        <translation>Non réussi&#xa0;: sur cette commande, un arrêt n’agit avec certitude qu’avant la fenêtre suivante</translation>
    </message>
    <message>
        <source>Synchronized actions make the override that is wanted, and keep it.</source>
        <translation>Les actions synchrones forment l’override voulu et le maintiennent.</translation>
    </message>
    <message>
        <source>Without a sign of the client the override is 0.</source>
        <translation>Sans signe de vie du client, l’override est 0.</translation>
    </message>
    <message>
        <source>At 50 % the axis takes twice as long.</source>
        <translation>À 50 %, l’axe met deux fois plus de temps.</translation>
    </message>
    <message>
        <source>At 0 % the axis stands on its way.</source>
        <translation>À 0 %, l’axe s’arrête en chemin.</translation>
    </message>
    <message>
        <source>It brakes at once when 0 % is wanted.</source>
        <translation>Il freine aussitôt que 0 % est demandé.</translation>
    </message>
    <message>
        <source>It moves in no interpolation cycle while it is held.</source>
        <translation>Arrêté, il ne bouge à aucun cycle d’interpolation.</translation>
    </message>
    <message>
        <source>The synchronized actions end with their program.</source>
        <translation>Les actions synchrones se terminent avec leur programme.</translation>
    </message>
    <message>
        <source>The next program moves at its own feed.</source>
        <translation>Le programme suivant se déplace à sa propre avance.</translation>
    </message>
    <message>
        <source>; the tool may be lifted by %1</source>
        <translation>&#xa0;; l’outil peut être relevé de %1</translation>
    </message>
    <message>
        <source>4. The override is changed while the axis moves; held, the tool goes up and comes back, twice. Then press cycle start once more: the next program must move at its own feed, and only the control can stop it.</source>
        <translation>4. L’override est modifié pendant que l’axe se déplace&#xa0;; retenu, l’outil se relève et revient, deux fois. Appuyez ensuite encore une fois sur Départ cycle&#xa0;: le programme suivant doit se déplacer à sa propre avance, et seule la commande peut l’arrêter.</translation>
    </message>
    <message>
        <source>The control allows the overlay of Z that the lift needs.</source>
        <translation>La commande permet la superposition de Z nécessaire au relevage.</translation>
    </message>
    <message>
        <source>Nothing but 0 to the lift moves the tool.</source>
        <translation>Seules les valeurs de 0 à la hauteur de relevage déplacent l’outil.</translation>
    </message>
    <message>
        <source>The tool is lifted while the axis is held.</source>
        <translation>L’outil est relevé pendant que l’axe est retenu.</translation>
    </message>
    <message>
        <source>The axis stands while the tool is lifted.</source>
        <translation>L’axe reste immobile tant que l’outil est relevé.</translation>
    </message>
    <message>
        <source>The tool comes back to its path.</source>
        <translation>L’outil revient sur sa trajectoire.</translation>
    </message>
    <message>
        <source>Let go, the axis moves only when the tool is back.</source>
        <translation>Libéré, l’axe ne se déplace qu’une fois l’outil revenu.</translation>
    </message>
    <message>
        <source>Stop, pause and override act at once because the control obeys an R-parameter in every interpolation cycle. This test finds out whether it does: first without motion, then, if you agree, with one axis that moves back and forth in the air and is held on its way. The channel must be in reset.</source>
        <translation>Arrêt, pause et override agissent aussitôt parce que la commande obéit à un paramètre R à chaque cycle d’interpolation. Ce test établit si elle le fait : d’abord sans mouvement puis, si vous êtes d’accord, avec un axe qui va et vient dans l’air et qui est arrêté en chemin. Le canal doit être en reset.</translation>
    </message>
    <message>
        <source>No other client writes the override of this test.</source>
        <translation>Aucun autre client n’écrit l’override de ce test.</translation>
    </message>
    <message>
        <source>; held, it was seen to stand after %1</source>
        <translation> ; retenu, il était à l’arrêt après %1</translation>
    </message>
</context>
<context>
    <name>FileSheetTexts</name>
    <message>
        <source>%1 is already there. Replace it?</source>
        <translation>%1 existe déjà. Le remplacer ?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
</context>
<context>
    <name>FoundRunTexts</name>
    <message>
        <source>A program of Rivulet without a run</source>
        <translation>Un programme de Rivulet sans exécution</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Exécution %1</translation>
    </message>
    <message>
        <source>Run %1 of %2</source>
        <translation>Exécution %1 de %2</translation>
    </message>
    <message>
        <source>It is not known who started it.</source>
        <translation>On ne sait pas qui l’a démarrée.</translation>
    </message>
    <message>
        <source>Started by %1 on %2 at %3.</source>
        <translation>Démarrée par %1 sur %2 le %3.</translation>
    </message>
    <message>
        <source>%1 of %2 points executed</source>
        <translation>%1 points sur %2 exécutés</translation>
    </message>
    <message>
        <source>%1. Looking for its client …</source>
        <translation>%1. Recherche de son client…</translation>
    </message>
    <message>
        <source>It waits for its first client.</source>
        <translation>Il attend son premier client.</translation>
    </message>
    <message>
        <source>%1. Its client is gone: the program waits.</source>
        <translation>%1. Son client n’est plus là&#xa0;: le programme attend.</translation>
    </message>
    <message>
        <source>%1. Its client is at work.</source>
        <translation>%1. Son client travaille.</translation>
    </message>
    <message>
        <source>It was not completed, and its program is no longer active on the control.</source>
        <translation>Elle n’est pas terminée et son programme n’est plus actif sur la commande.</translation>
    </message>
    <message>
        <source>Stop confirmed after %1.</source>
        <translation>Arrêt confirmé après %1.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows executed</source>
        <translation>
            <numerusform>%Ln fenêtre exécutée</numerusform>
            <numerusform>%Ln fenêtres exécutées</numerusform>
        </translation>
    </message>
    <message>
        <source>The axes stand (%1 after the order), and stay where they are until the run is ended or resumed.</source>
        <translation>Les axes sont à l’arrêt (%1 après l’ordre) et y restent jusqu’à ce que l’exécution soit terminée ou reprise.</translation>
    </message>
</context>
<context>
    <name>GroupingTexts</name>
    <message>
        <source>Lists</source>
        <translation>Listes</translation>
    </message>
    <message>
        <source>One by one</source>
        <translation>Un par un</translation>
    </message>
    <message>
        <source>Arrays by count</source>
        <translation>Tableaux par nombre</translation>
    </message>
    <message>
        <source>Arrays by range</source>
        <translation>Tableaux par plage</translation>
    </message>
</context>
<context>
    <name>HazardTexts</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>Line %1 (part %2)</source>
        <translation>Ligne %1 (tronçon %2)</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>S%1 is %2 1/min more than the spindle can turn; the control reduces it to %3 1/min.</source>
        <translation>S%1 dépasse de %2 1/min ce que la broche peut tourner&#xa0;; la commande le réduit à %3 1/min.</translation>
    </message>
    <message>
        <source>Tool %1 is not in the tool table of the machine. Enter it there, or choose another tool.</source>
        <translation>L’outil %1 n’est pas dans la table d’outils de la machine. L’y saisir ou choisir un autre outil.</translation>
    </message>
    <message>
        <source>The machine would stop with alarm %1: %2</source>
        <translation>La machine s’arrêterait avec l’alarme %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>From here on the job cannot be checked, because only the control knows what this block does: %1</source>
        <translation>À partir d’ici, la tâche ne peut pas être vérifiée, car seule la commande sait ce que fait ce bloc&#xa0;: %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 autres</translation>
    </message>
    <message>
        <source>%1 would go to %2 in machine coordinates, %3 beyond its limit of %4. Move the workpiece or change the work offset.</source>
        <translation>%1 irait à %2 en coordonnées machine, %3 au-delà de sa limite de %4. Déplacer la pièce ou changer le décalage d’origine.</translation>
    </message>
    <message>
        <source>Tool %1 is not in the tool table of the machine, but %2 is. Enter %1 there, or write %2 into the program.</source>
        <translation>L’outil %1 n’est pas dans la table d’outils de la machine, mais %2 y est. Y inscrire %1, ou écrire %2 dans le programme.</translation>
    </message>
</context>
<context>
    <name>JobTestTexts</name>
    <message>
        <source>In a whole job the control executes blocks of its own between stretches that Rivulet streams. This test finds out whether it does that once, in order and only when it may, and whether stop, pause and a lost connection act in both: one axis moves back and forth in the air. Enter the blocks that your jobs have, one a line, each so that nothing is in its way; other kinds are not released. The channel must be in reset.</source>
        <translation>Dans une tâche complète, la commande exécute ses propres blocs entre les sections que Rivulet transmet. Ce test vérifie qu’elle le fait une fois, dans l’ordre et seulement avec permission, et que l’arrêt, la pause et une connexion perdue agissent dans les deux : un axe va et vient dans l’air. Saisir les blocs de vos tâches, un par ligne, chacun sans obstacle ; les autres types ne sont pas libérés. Le canal doit être en reset.</translation>
    </message>
    <message>
        <source>4. The job is stopped and left alone, in a block and in a stretch, then it goes through: press cycle start each time, %1 times in all.</source>
        <translation>4. La tâche est arrêtée et laissée seule, dans un bloc et dans une section, puis elle va jusqu’au bout : appuyer chaque fois sur Départ cycle, %1 fois en tout.</translation>
    </message>
    <message>
        <source>Passed: whole jobs may run on this control, with the blocks that were tried</source>
        <translation>Réussi : des tâches complètes peuvent s’exécuter sur cette commande, avec les blocs essayés</translation>
    </message>
    <message>
        <source>No block is executed before Rivulet permits it.</source>
        <translation>Aucun bloc n’est exécuté avant la permission de Rivulet.</translation>
    </message>
    <message>
        <source>After a stretch no block is executed before Rivulet permits it.</source>
        <translation>Après une section, aucun bloc n’est exécuté avant la permission de Rivulet.</translation>
    </message>
    <message>
        <source>A stop in a block ends the job after that block.</source>
        <translation>Un arrêt dans un bloc termine la tâche après ce bloc.</translation>
    </message>
    <message>
        <source>A stop in a stretch ends the job there.</source>
        <translation>Un arrêt dans une section y termine la tâche.</translation>
    </message>
    <message>
        <source>In a block the axis stands when the connection is lost, and the job can be ended.</source>
        <translation>Dans un bloc, l’axe s’arrête quand la connexion est perdue, et la tâche peut être terminée.</translation>
    </message>
    <message>
        <source>In a stretch the axis stands when the connection is lost, and the job can be ended.</source>
        <translation>Dans une section, l’axe s’arrête quand la connexion est perdue, et la tâche peut être terminée.</translation>
    </message>
    <message>
        <source>In a block the axis stands while it is held.</source>
        <translation>Dans un bloc, l’axe reste arrêté tant qu’il est retenu.</translation>
    </message>
    <message>
        <source>In a stretch the axis stands while it is held.</source>
        <translation>Dans une section, l’axe reste arrêté tant qu’il est retenu.</translation>
    </message>
    <message>
        <source>Blocks and stretches are executed in turns, once each.</source>
        <translation>Blocs et sections sont exécutés tour à tour, une fois chacun.</translation>
    </message>
    <message>
        <source>No block is passed over.</source>
        <translation>Aucun bloc n’est sauté.</translation>
    </message>
    <message>
        <source>The override of the job ends with it.</source>
        <translation>La correction d’avance de la tâche finit avec elle.</translation>
    </message>
    <message>
        <source>Not tested: on a real control only the motion of a program runs</source>
        <translation>Non testé : sur une commande réelle, seul le mouvement d’un programme s’exécute</translation>
    </message>
    <message>
        <source>Not passed: on a real control only the motion of a program runs</source>
        <translation>Échoué : sur une commande réelle, seul le mouvement d’un programme s’exécute</translation>
    </message>
</context>
<context>
    <name>JobTexts</name>
    <message>
        <source>swivels or transforms the coordinates</source>
        <translation>bascule ou transforme les coordonnées</translation>
    </message>
    <message>
        <source>tool radius compensation</source>
        <translation>correction du rayon d’outil</translation>
    </message>
    <message>
        <source>cycle of the control</source>
        <translation>cycle de la commande</translation>
    </message>
    <message>
        <source>subprogram that is not at hand</source>
        <translation>sous-programme qui n’est pas disponible</translation>
    </message>
    <message>
        <source>measures, or reads the machine</source>
        <translation>mesure, ou lit la machine</translation>
    </message>
    <message>
        <source>moves in machine coordinates</source>
        <translation>se déplace en coordonnées machine</translation>
    </message>
    <message>
        <source>path made by the control</source>
        <translation>trajectoire créée par la commande</translation>
    </message>
    <message>
        <source>rounded or chamfered corner</source>
        <translation>angle arrondi ou chanfreiné</translation>
    </message>
    <message>
        <source>counts from a position that only the control knows</source>
        <translation>compte à partir d’une position que seule la commande connaît</translation>
    </message>
    <message>
        <source>tool or tool length</source>
        <translation>outil ou longueur d’outil</translation>
    </message>
    <message>
        <source>work offset</source>
        <translation>décalage d’origine</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>broche</translation>
    </message>
    <message>
        <source>coolant</source>
        <translation>arrosage</translation>
    </message>
    <message>
        <source>stops until cycle start</source>
        <translation>s’arrête jusqu’au Départ cycle</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>temporisation</translation>
    </message>
    <message>
        <source>message at the control</source>
        <translation>message sur la commande</translation>
    </message>
    <message>
        <source>how the control moves</source>
        <translation>comment la commande se déplace</translation>
    </message>
    <message>
        <source>function of the machine</source>
        <translation>fonction de la machine</translation>
    </message>
    <message>
        <source>end of the program</source>
        <translation>fin du programme</translation>
    </message>
    <message>
        <source>The control executes this block: %1.</source>
        <translation>La commande exécute ce bloc : %1.</translation>
    </message>
    <message>
        <source>Afterwards the position is read from the control.</source>
        <translation>Ensuite, la position est lue sur la commande.</translation>
    </message>
    <message numerus="yes">
        <source>Part %1 of %2: lines %3 to %4 are streamed, %Ln points.</source>
        <translation>
            <numerusform>Tronçon %1 sur %2&#xa0;: les lignes %3 à %4 sont transmises en continu, %Ln point.</numerusform>
            <numerusform>Tronçon %1 sur %2&#xa0;: les lignes %3 à %4 sont transmises en continu, %Ln points.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LimitTexts</name>
    <message>
        <source>rapid</source>
        <translation>rapide</translation>
    </message>
    <message>
        <source>line %1: %2, %3</source>
        <translation>ligne %1&#xa0;: %2, %3</translation>
    </message>
</context>
<context>
    <name>LiveTexts</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>hold after %1, end after %2</source>
        <translation>suspension après %1, fin après %2</translation>
    </message>
    <message>
        <source>median %1, 99 % %2</source>
        <translation>médiane %1, 99&#xa0;% %2</translation>
    </message>
    <message>
        <source>in theory %1</source>
        <translation>en théorie %1</translation>
    </message>
    <message>
        <source>%1 from %2, executed to line %3</source>
        <translation>%1 de %2, exécutées jusqu’à la ligne %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln points merged</source>
        <translation>
            <numerusform>%Ln point fusionné</numerusform>
            <numerusform>%Ln points fusionnés</numerusform>
        </translation>
    </message>
    <message>
        <source>Adaptive feed: %1 % of your override, from %2</source>
        <translation>Avance adaptative&#xa0;: %1&#xa0;% de votre override, de %2</translation>
    </message>
    <message>
        <source>Adaptive feed: without %1, until its next factor</source>
        <translation>Avance adaptative&#xa0;: sans %1, jusqu’à son prochain facteur</translation>
    </message>
    <message>
        <source>Adaptive feed: the axes are held. %1: %2</source>
        <translation>Avance adaptative&#xa0;: les axes sont retenus. %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Adaptive feed: your override acts alone. %1: %2</source>
        <translation>Avance adaptative&#xa0;: votre override agit seul. %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>no factor has come yet</source>
        <translation>aucun facteur n’est encore arrivé</translation>
    </message>
    <message>
        <source>no factor has come in time</source>
        <translation>aucun facteur n’est arrivé à temps</translation>
    </message>
    <message>
        <source>%1 % was not agreed</source>
        <translation>%1&#xa0;% n’était pas convenu</translation>
    </message>
    <message>
        <source>its last line is no factor</source>
        <translation>sa dernière ligne n’est pas un facteur</translation>
    </message>
    <message>
        <source>it has closed</source>
        <translation>elle s’est fermée</translation>
    </message>
</context>
<context>
    <name>MachineCard</name>
    <message>
        <source>No run is known.</source>
        <translation>Aucune exécution connue.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connexion</translation>
    </message>
    <message>
        <source>Not connected with this window</source>
        <translation>Pas connectée à cette fenêtre</translation>
    </message>
    <message>
        <source>%1, seen %2 ago</source>
        <translation>%1, vue il y a %2</translation>
    </message>
    <message numerus="yes">
        <source>%n alarms</source>
        <translation>
            <numerusform>%n alarme</numerusform>
            <numerusform>%n alarmes</numerusform>
        </translation>
    </message>
    <message>
        <source>limits</source>
        <translation>limites</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>calibration</translation>
    </message>
    <message>
        <source>credit test</source>
        <translation>test crédit</translation>
    </message>
    <message>
        <source>Remove this machine from the list? Its runs and recordings stay on the page Runs.</source>
        <translation>Retirer cette machine de la liste&#xa0;? Ses exécutions et ses enregistrements restent sur la page Exécutions.</translation>
    </message>
    <message>
        <source>Put aside as files, and not used any more: %1.</source>
        <translation>Mis de côté dans des fichiers, et plus utilisés&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Last run %1: %2, %3 of %4 points</source>
        <translation>Dernière exécution %1&#xa0;: %2, %3 points sur %4</translation>
    </message>
    <message>
        <source>Not connected; its port answered %1 ago</source>
        <translation>Non connectée&#xa0;; son port a répondu il y a %1</translation>
    </message>
    <message>
        <source>Not reachable: no answer %1 ago</source>
        <translation>Injoignable&#xa0;: pas de réponse il y a %1</translation>
    </message>
    <message>
        <source>stop test</source>
        <translation>test d’arrêt</translation>
    </message>
    <message>
        <source>job test</source>
        <translation>test de tâche</translation>
    </message>
</context>
<context>
    <name>MachinesTexts</name>
    <message>
        <source>During a run, the window stays with its machine.</source>
        <translation>Pendant une exécution, la fenêtre reste à sa machine.</translation>
    </message>
</context>
<context>
    <name>MoveTexts</name>
    <message>
        <source>%1 moved by %2 at %3</source>
        <translation>%1 déplacé de %2 à %3</translation>
    </message>
</context>
<context>
    <name>NoteTexts</name>
    <message>
        <source>Form of access: %1.</source>
        <translation>Forme d’accès&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Program %1: %2, %3, %4.</source>
        <translation>Programme %1&#xa0;: %2, %3, %4.</translation>
    </message>
    <message>
        <source>Nothing has come from the control for %1 s.</source>
        <translation>Rien n’est venu de la commande depuis %1 s.</translation>
    </message>
    <message>
        <source>The control answers again.</source>
        <translation>La commande répond de nouveau.</translation>
    </message>
    <message>
        <source>The control answered slowly: accesses took up to %1 s, %2 times as long as expected. Each took at least %3 s: the network is slow, or the server is busy with another OPC UA client.</source>
        <translation>La commande a répondu lentement&#xa0;: les accès ont duré jusqu’à %1 s, %2 fois plus que prévu. Chacun a duré au moins %3 s&#xa0;: le réseau est lent, ou le serveur est occupé par un autre client OPC UA.</translation>
    </message>
    <message>
        <source>The control answered slowly: accesses took up to %1 s, %2 times as long as expected. Others were fast: another OPC UA client keeps the server busy at times, or the network stalls.</source>
        <translation>La commande a répondu lentement&#xa0;: les accès ont duré jusqu’à %1 s, %2 fois plus que prévu. D’autres étaient rapides&#xa0;: un autre client OPC UA occupe parfois le serveur, ou le réseau se bloque.</translation>
    </message>
    <message>
        <source>Online correction in mm: X %1 Y %2 Z %3</source>
        <translation>Correction en ligne en mm&#xa0;: X %1 Y %2 Z %3</translation>
    </message>
    <message>
        <source>The control has refused a request: asked again.</source>
        <translation>La commande a refusé une demande&#xa0;: nouvelle demande.</translation>
    </message>
    <message>
        <source>No answer in time: asked again.</source>
        <translation>Pas de réponse à temps&#xa0;: nouvelle demande.</translation>
    </message>
    <message>
        <source>The stream was given up: %1</source>
        <translation>La transmission a été abandonnée&#xa0;: %1</translation>
    </message>
    <message>
        <source>A signal was out of sequence: a window has been executed again.</source>
        <translation>Un signal était hors séquence&#xa0;: une fenêtre a été exécutée de nouveau.</translation>
    </message>
    <message>
        <source>The place of the run could not be kept, so it cannot be resumed after a crash of this program: %1</source>
        <translation>La place de l’exécution n’a pas pu être gardée, elle ne peut donc pas être reprise après un plantage de ce programme&#xa0;: %1</translation>
    </message>
    <message>
        <source>The reason why the program ended could not be read.</source>
        <translation>La raison de la fin du programme n’a pas pu être lue.</translation>
    </message>
    <message>
        <source>The trace of the control could not be fetched: %1</source>
        <translation>L’enregistrement de la commande n’a pas pu être récupéré&#xa0;: %1</translation>
    </message>
    <message>
        <source>The trace of the control is incomplete: the run is not judged.</source>
        <translation>L’enregistrement de la commande est incomplet&#xa0;: l’exécution n’est pas jugée.</translation>
    </message>
    <message>
        <source>The name of the run could not be stored: %1</source>
        <translation>Le nom de l’exécution n’a pas pu être enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>written</source>
        <translation>écrit</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>déjà là</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>comparé</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>non comparé</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>sélectionné</translation>
    </message>
    <message>
        <source>to be selected</source>
        <translation>à sélectionner</translation>
    </message>
    <message>
        <source>Adaptive feed: the source is followed.</source>
        <translation>Avance adaptative&#xa0;: la source est suivie.</translation>
    </message>
    <message>
        <source>Adaptive feed: no factor has come yet: %1</source>
        <translation>Avance adaptative&#xa0;: aucun facteur n’est encore arrivé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: no factor for %1 s: %2</source>
        <translation>Avance adaptative&#xa0;: aucun facteur depuis %1 s&#xa0;: %2</translation>
    </message>
    <message>
        <source>Adaptive feed: the factor %1 was not agreed: %2 to %3, where 1 is 100 %: %4</source>
        <translation>Avance adaptative&#xa0;: le facteur %1 n’était pas convenu&#xa0;: de %2 à %3, où 1 est 100&#xa0;%&#xa0;: %4</translation>
    </message>
    <message>
        <source>Adaptive feed: the line is no factor, as feed 0.85 would be: %1</source>
        <translation>Avance adaptative&#xa0;: la ligne n’est pas un facteur, comme le serait feed 0.85&#xa0;: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: the source has closed: %1</source>
        <translation>Avance adaptative&#xa0;: la source s’est fermée&#xa0;: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: the operator goes on without the source.</source>
        <translation>Avance adaptative&#xa0;: l’opérateur continue sans la source.</translation>
    </message>
    <message>
        <source>the axes are held.</source>
        <translation>les axes sont retenus.</translation>
    </message>
    <message>
        <source>the override of the operator acts alone.</source>
        <translation>l’override de l’opérateur agit seul.</translation>
    </message>
    <message>
        <source>The axes are told to stand.</source>
        <translation>Les axes doivent s’arrêter.</translation>
    </message>
    <message>
        <source>The axes are told to go on, override %1 %.</source>
        <translation>Les axes doivent continuer, override %1&#xa0;%.</translation>
    </message>
    <message>
        <source>Override %1 % requested.</source>
        <translation>Override %1&#xa0;% demandé.</translation>
    </message>
    <message>
        <source>An override of %1 % is refused: choose %2 to %3 %.</source>
        <translation>Un override de %1&#xa0;% est refusé&#xa0;: choisir de %2 à %3&#xa0;%.</translation>
    </message>
    <message>
        <source>Another client has set the override to %1 %: it stays until the next order.</source>
        <translation>Un autre client a mis l’override à %1&#xa0;%&#xa0;: il reste jusqu’au prochain ordre.</translation>
    </message>
    <message>
        <source>Another client has written the factor %1: %2 is written again.</source>
        <translation>Un autre client a écrit le facteur %1&#xa0;: %2 est écrit de nouveau.</translation>
    </message>
    <message>
        <source>The control does not obey: its override is %1 %.</source>
        <translation>La commande n’obéit pas&#xa0;: son override est de %1&#xa0;%.</translation>
    </message>
    <message>
        <source>The axes stand, %1 s after it was requested.</source>
        <translation>Les axes sont à l’arrêt, %1&#xa0;s après la demande.</translation>
    </message>
    <message>
        <source>The axes move although the override is 0: what moves now does not obey it. Stop it at the control.</source>
        <translation>Les axes bougent bien que l’override soit à 0&#xa0;: ce qui bouge ne lui obéit pas. Arrêter à la commande.</translation>
    </message>
    <message>
        <source>For %1 s no sign of this computer has reached the control: the axes have stood meanwhile.</source>
        <translation>Pendant %1&#xa0;s, aucun signe de cet ordinateur n’est parvenu à la commande&#xa0;: les axes sont restés à l’arrêt.</translation>
    </message>
    <message>
        <source>Lift of the tool in mm: %1</source>
        <translation>Relevage de l’outil en mm&#xa0;: %1</translation>
    </message>
    <message>
        <source>Stopped: the axes are held, and the program is left.</source>
        <translation>Arrêté&#xa0;: les axes sont maintenus à l’arrêt, et le programme est quitté.</translation>
    </message>
    <message>
        <source>This program has no feed cell: Pause acts before the next window.</source>
        <translation>Ce programme n’a pas de cellule d’avance&#xa0;: Pause agit avant la fenêtre suivante.</translation>
    </message>
    <message>
        <source>Wrong motion: after point %1 the tool is %2 mm off the path.</source>
        <translation>Mouvement erroné&#xa0;: après le point %1, l’outil est à %2&#xa0;mm de la trajectoire.</translation>
    </message>
    <message>
        <source>Wrong motion: points were repeated after point %1.</source>
        <translation>Mouvement erroné&#xa0;: des points ont été répétés après le point %1.</translation>
    </message>
    <message>
        <source>The control recorded a dwell of %1 s in line %2.</source>
        <translation>La commande a enregistré une temporisation de %1&#xa0;s à la ligne %2.</translation>
    </message>
    <message>
        <source>The control recorded an auxiliary function of %1 s in line %2.</source>
        <translation>La commande a enregistré une fonction auxiliaire de %1&#xa0;s à la ligne %2.</translation>
    </message>
    <message>
        <source>The control recorded M%1 in line %2.</source>
        <translation>La commande a enregistré M%1 à la ligne %2.</translation>
    </message>
    <message>
        <source>The override was 0 while the axes stood.</source>
        <translation>L’override était à 0 pendant que les axes étaient à l’arrêt.</translation>
    </message>
    <message>
        <source>A write of %1 values was answered %2 ms before the axes moved again.</source>
        <translation>L’écriture de %1 valeurs a reçu sa réponse %2&#xa0;ms avant que les axes ne repartent.</translation>
    </message>
    <message>
        <source>The program on the control has a STOPRE between line %1 and line %2.</source>
        <translation>Le programme sur la commande a un STOPRE entre la ligne %1 et la ligne %2.</translation>
    </message>
    <message>
        <source>The program on the control jumps from line %1 back to line %2.</source>
        <translation>Le programme sur la commande saute de la ligne %1 en arrière à la ligne %2.</translation>
    </message>
    <message>
        <source>The path turns by %1° there.</source>
        <translation>La trajectoire y tourne de %1°.</translation>
    </message>
    <message>
        <source>Line %1 of the program dwells there.</source>
        <translation>La ligne %1 du programme y fait une temporisation.</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Feasibility</source>
        <translation>Faisabilité</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 enregistré.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Audit</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Utilisateurs</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Exécutions</translation>
    </message>
    <message>
        <source>Configure</source>
        <translation>Configurer</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Machines</translation>
    </message>
    <message>
        <source>Emulator</source>
        <translation>Émulateur</translation>
    </message>
    <message>
        <source>CNC tasks</source>
        <translation>Tâches CNC</translation>
    </message>
</context>
<context>
    <name>ParallelPageTexts</name>
    <message>
        <source>A run is in progress. Execute the program after it has ended: both would take the same processor.</source>
        <translation>Une exécution est en cours. Exécuter le programme quand elle est terminée : les deux prendraient le même processeur.</translation>
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
        <translation>mesurée</translation>
    </message>
    <message>
        <source>inferred</source>
        <translation>déduite</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>prévue</translation>
    </message>
</context>
<context>
    <name>ProfileTexts</name>
    <message>
        <source>Axis %1: the travel must end above its beginning.</source>
        <translation>Axe %1&#xa0;: la course doit finir au-dessus de son début.</translation>
    </message>
    <message>
        <source>Axis %1: the speed must be above zero.</source>
        <translation>Axe %1&#xa0;: la vitesse doit être supérieure à zéro.</translation>
    </message>
    <message>
        <source>Axis %1: the acceleration must be above zero.</source>
        <translation>Axe %1&#xa0;: l’accélération doit être supérieure à zéro.</translation>
    </message>
    <message>
        <source>Axis %1: the jerk must be above zero.</source>
        <translation>Axe %1&#xa0;: le jerk doit être supérieur à zéro.</translation>
    </message>
    <message>
        <source>The rapid must be above zero.</source>
        <translation>Le rapide doit être supérieur à zéro.</translation>
    </message>
    <message>
        <source>Tool %1: every tool needs its own number above zero.</source>
        <translation>Outil %1&#xa0;: chaque outil a besoin de son propre numéro, supérieur à zéro.</translation>
    </message>
    <message>
        <source>Without this computer the axes stand after 0.2 to 60 s; 0: not at all.</source>
        <translation>Sans cet ordinateur, les axes s&apos;arrêtent après 0,2 à 60 s ; 0 : jamais.</translation>
    </message>
    <message>
        <source>Without a passed stop test a window takes at most 0.5 to 600 s.</source>
        <translation>Sans test d’arrêt réussi, une fenêtre dure au plus 0,5 à 600 s.</translation>
    </message>
</context>
<context>
    <name>ProgramTexts</name>
    <message>
        <source>Parts of the path of %1 are not known: see the findings. The program cannot be streamed.</source>
        <translation>Des parties de la trajectoire de %1 ne sont pas connues&#xa0;: voir les observations. Le programme ne peut pas être transmis en continu.</translation>
    </message>
    <message>
        <source>%1 needs a transformation of the control. No method can stream it.</source>
        <translation>%1 a besoin d’une transformation de la commande. Aucune méthode ne peut le transmettre en continu.</translation>
    </message>
    <message>
        <source>%1 moves no axis: there is nothing to stream.</source>
        <translation>%1 ne déplace aucun axe&#xa0;: il n’y a rien à transmettre.</translation>
    </message>
    <message>
        <source>A run is in progress. Open another program after it has ended.</source>
        <translation>Une exécution est en cours. Ouvrir un autre programme quand elle sera terminée.</translation>
    </message>
    <message>
        <source>Reading %1 was cancelled.</source>
        <translation>La lecture de %1 a été annulée.</translation>
    </message>
    <message numerus="yes">
        <source>Opened %1 (%2), %Ln points.</source>
        <translation>
            <numerusform>%1 ouvert (%2), %Ln point.</numerusform>
            <numerusform>%1 ouvert (%2), %Ln points.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RehearsalTexts</name>
    <message>
        <source>The program is being simulated with these settings.</source>
        <translation>Simulation du programme avec ces réglages en cours.</translation>
    </message>
    <message>
        <source>all %1 points</source>
        <translation>la totalité des %1 points</translation>
    </message>
    <message>
        <source>the %1 most difficult points</source>
        <translation>les %1 points les plus difficiles</translation>
    </message>
    <message>
        <source>Simulation of %1: wrong points in %2 of %3 runs.</source>
        <translation>Simulation (%1)&#xa0;: points erronés dans %2 passages sur %3.</translation>
    </message>
    <message numerus="yes">
        <source>Simulation of %1: no wrong point in %n runs.</source>
        <translation>
            <numerusform>Simulation (%1)&#xa0;: aucun point erroné en %n passage.</numerusform>
            <numerusform>Simulation (%1)&#xa0;: aucun point erroné en %n passages.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RejectedModel</name>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Délivré à</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Valable</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Empreinte</translation>
    </message>
</context>
<context>
    <name>RightTexts</name>
    <message>
        <source>read variables</source>
        <translation>lire des variables</translation>
    </message>
    <message>
        <source>follows the run</source>
        <translation>suit l’exécution</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with StateRead; if that is not enough, with SinuReadAll.</source>
        <translation>Appeler GiveUserAccess avec StateRead&#xa0;; si cela ne suffit pas, avec SinuReadAll.</translation>
    </message>
    <message>
        <source>write R-parameters</source>
        <translation>écrire des paramètres R</translation>
    </message>
    <message>
        <source>sends the points</source>
        <translation>envoie les points</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with StateWrite; if that is not enough, with SinuWriteAll. The protection level of R-parameters (MD51051) must allow it, too.</source>
        <translation>Appeler GiveUserAccess avec StateWrite&#xa0;; si cela ne suffit pas, avec SinuWriteAll. Le niveau de protection des paramètres R (MD51051) doit aussi le permettre.</translation>
    </message>
    <message>
        <source>read programs</source>
        <translation>lire des programmes</translation>
    </message>
    <message>
        <source>checks which program is on the control; without it the operator does</source>
        <translation>vérifie quel programme est sur la commande&#xa0;; sinon l’opérateur le fait</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with FsRead.</source>
        <translation>Appeler GiveUserAccess avec FsRead.</translation>
    </message>
    <message>
        <source>write programs</source>
        <translation>écrire des programmes</translation>
    </message>
    <message>
        <source>brings its program to the control; without it the operator copies it</source>
        <translation>apporte son programme à la commande&#xa0;; sinon l’opérateur le copie</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with FsWrite.</source>
        <translation>Appeler GiveUserAccess avec FsWrite.</translation>
    </message>
    <message>
        <source>select a program</source>
        <translation>sélectionner un programme</translation>
    </message>
    <message>
        <source>selects its program; without it the operator does</source>
        <translation>sélectionne son programme&#xa0;; sinon l’opérateur le fait</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with ApWrite.</source>
        <translation>Appeler GiveUserAccess avec ApWrite.</translation>
    </message>
    <message>
        <source>Let this OPC UA user read the nodes of the map, in the settings of the server.</source>
        <translation>Autorisez cet utilisateur OPC UA, dans les réglages du serveur, à lire les nœuds de la table de correspondance.</translation>
    </message>
    <message>
        <source>Let this OPC UA user write the cells of the map, in the settings of the server.</source>
        <translation>Autorisez cet utilisateur OPC UA, dans les réglages du serveur, à écrire les cellules de la table de correspondance.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.read), if the server has one, and let this OPC UA user call it.</source>
        <translation>Nommez la méthode dans la table de correspondance (methods.read), si le serveur en a une, et autorisez cet utilisateur OPC UA à l’appeler.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.write), if the server has one, and let this OPC UA user call it.</source>
        <translation>Nommez la méthode dans la table de correspondance (methods.write), si le serveur en a une, et autorisez cet utilisateur OPC UA à l’appeler.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.select), if the server has one, and let this OPC UA user call it.</source>
        <translation>Nommez la méthode dans la table de correspondance (methods.select), si le serveur en a une, et autorisez cet utilisateur OPC UA à l’appeler.</translation>
    </message>
</context>
<context>
    <name>RunStateTexts</name>
    <message>
        <source>Idle</source>
        <translation>Au repos</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Arrêt en cours</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Suspendu</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Préparation</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
</context>
<context>
    <name>RunTexts</name>
    <message>
        <source>No program is loaded.</source>
        <translation>Aucun programme n’est chargé.</translation>
    </message>
    <message>
        <source>The program has fewer than two points.</source>
        <translation>Le programme a moins de deux points.</translation>
    </message>
    <message>
        <source>Running: %1, version %2</source>
        <translation>En cours&#xa0;: %1, version %2</translation>
    </message>
    <message>
        <source>Program: %1, version %2</source>
        <translation>Programme&#xa0;: %1, version %2</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>program, %1 %</source>
        <translation>programme, %1 %</translation>
    </message>
    <message>
        <source>Whole jobs need method window or credit.</source>
        <translation>Les tâches complètes exigent la méthode Fenêtre ou Crédit.</translation>
    </message>
    <message>
        <source>A whole job cannot be corrected online.</source>
        <translation>Une tâche complète ne peut pas être corrigée en ligne.</translation>
    </message>
    <message>
        <source>Parts of the program are not known: see the findings.</source>
        <translation>Certaines parties du programme ne sont pas connues : voir les observations.</translation>
    </message>
    <message>
        <source>%1 (line %2) cannot be given to the control.</source>
        <translation>%1 (ligne %2) ne peut pas être transmis à la commande.</translation>
    </message>
    <message>
        <source>%1 streamed, %2 pauses, %3 tool changes, %4 other blocks of the control, %5 changes between both; %6 in all</source>
        <translation>%1 transmis, %2 pauses, %3 changements d’outil, %4 autres blocs de la commande, %5 passages de l’un à l’autre&#xa0;; %6 au total</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêtée</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Terminée</translation>
    </message>
    <message>
        <source>Stopped, not judged</source>
        <translation>Arrêtée, non évaluée</translation>
    </message>
    <message>
        <source>Completed, not judged</source>
        <translation>Terminée, non évaluée</translation>
    </message>
    <message>
        <source>Stopped, with wrong motion</source>
        <translation>Arrêtée, avec mouvement erroné</translation>
    </message>
    <message>
        <source>Completed with wrong motion</source>
        <translation>Terminée avec mouvement erroné</translation>
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
        <translation>Crédit (expérimental)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Begin with a part</source>
        <translation>Commencer à un tronçon</translation>
    </message>
    <message>
        <source>Part (1 to %1). What the machine needs there is listed before anything moves.</source>
        <translation>Tronçon (1 à %1). Ce qu’il faut à la machine à cet endroit est listé avant tout mouvement.</translation>
    </message>
    <message>
        <source>A live source needs no verdict: the machine waits for points that are late.</source>
        <translation>Une source en direct n’a pas besoin de verdict&#xa0;: la machine attend les points en retard.</translation>
    </message>
    <message>
        <source>Live points from %1</source>
        <translation>Points en direct de %1</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Aucun outil</translation>
    </message>
    <message>
        <source>Before the first tool change</source>
        <translation>Avant le premier changement d’outil</translation>
    </message>
    <message>
        <source>%1 in the spindle</source>
        <translation>%1 dans la broche</translation>
    </message>
    <message>
        <source>%1 change</source>
        <translation>%1 changement</translation>
    </message>
    <message>
        <source>%1 at %2 1/min</source>
        <translation>%1 à %2 tr/min</translation>
    </message>
    <message>
        <source>%1 coolant</source>
        <translation>%1 arrosage</translation>
    </message>
    <message>
        <source>Straight way to the first point</source>
        <translation>Trajet direct vers le premier point</translation>
    </message>
    <message>
        <source>CLEAR</source>
        <extracomment>What the operator types; a translation may be any one word.</extracomment>
        <translation>LIBRE</translation>
    </message>
    <message>
        <source>The tool goes straight through the space in which the program cuts. Look whether anything is in its way: workpiece, clamps. If nothing is, type %1.</source>
        <translation>L&apos;outil traverse en ligne droite la zone que le programme usine. Regardez si quelque chose se trouve sur son trajet : pièce, bridages. Sinon, tapez %1.</translation>
    </message>
    <message>
        <source>Method that may repeat points</source>
        <translation>Méthode qui peut répéter des points</translation>
    </message>
    <message>
        <source>this may execute old points again</source>
        <extracomment>What the operator types, word by word.</extracomment>
        <translation>ceci peut exécuter à nouveau d’anciens points</translation>
    </message>
    <message>
        <source>This method of the publication knows no numbered windows. If this computer is late, the control executes old points again. To start all the same, type:
%1</source>
        <translation>Cette méthode de la publication ne connaît pas de fenêtres numérotées. Si cet ordinateur est en retard, la commande exécute à nouveau d’anciens points. Pour démarrer malgré tout, taper&#xa0;:
%1</translation>
    </message>
    <message>
        <source>The path is being measured.</source>
        <translation>La trajectoire est en cours de mesure.</translation>
    </message>
    <message>
        <source>Whole jobs have not been tested on this machine: Configure, Job test.</source>
        <translation>Les tâches complètes n’ont pas été testées sur cette machine : Configurer, Test tâche.</translation>
    </message>
</context>
<context>
    <name>RunsTexts</name>
    <message>
        <source>This is not the report of a run. Choose a file that this page or stream --json has written.</source>
        <translation>Ce n’est pas le rapport d’une exécution. Choisir un fichier écrit par cette page ou par stream --json.</translation>
    </message>
    <message>
        <source>The report was written by a later version of Rivulet. Use that one to open it.</source>
        <translation>Le rapport a été écrit par une version plus récente de Rivulet. L’ouvrir avec celle-ci.</translation>
    </message>
    <message>
        <source>The report is damaged and cannot be shown.</source>
        <translation>Le rapport est endommagé et ne peut pas être affiché.</translation>
    </message>
</context>
<context>
    <name>ServerModel</name>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificat</translation>
    </message>
    <message>
        <source>none accepted</source>
        <translation>aucun accepté</translation>
    </message>
    <message>
        <source>accepted, not kept</source>
        <translation>accepté, non conservé</translation>
    </message>
    <message>
        <source>has ended</source>
        <translation>a expiré</translation>
    </message>
    <message numerus="yes">
        <source>valid for %Ln days</source>
        <translation>
            <numerusform>valable %Ln jour</numerusform>
            <numerusform>valable %Ln jours</numerusform>
        </translation>
    </message>
    <message>
        <source>Protection</source>
        <translation>Protection</translation>
    </message>
    <message>
        <source>the strongest</source>
        <translation>la plus forte</translation>
    </message>
    <message>
        <source>allowed: %1</source>
        <translation>autorisé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Empreinte</translation>
    </message>
</context>
<context>
    <name>ServiceTexts</name>
    <message>
        <source>Connecting …</source>
        <translation>Connexion…</translation>
    </message>
    <message>
        <source>No answer for some seconds</source>
        <translation>Pas de réponse depuis quelques secondes</translation>
    </message>
    <message>
        <source>Service does not answer</source>
        <translation>Le service ne répond pas</translation>
    </message>
    <message>
        <source>Not connected: needs a decision</source>
        <translation>Non connecté&#xa0;: décision nécessaire</translation>
    </message>
    <message>
        <source>Machine does not answer</source>
        <translation>La machine ne répond pas</translation>
    </message>
    <message>
        <source>Connecting to the machine …</source>
        <translation>Connexion à la machine…</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Pas de programme</translation>
    </message>
    <message>
        <source>Program loaded</source>
        <translation>Programme chargé</translation>
    </message>
    <message>
        <source>Run interrupted</source>
        <translation>Exécution interrompue</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 points sur %2</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, encore %2</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>No other services are known there.</source>
        <translation>Aucun autre service n’y est connu.</translation>
    </message>
    <message>
        <source>Only an engineer can do this.</source>
        <translation>Seul un régleur peut le faire.</translation>
    </message>
    <message>
        <source>This service is on the board.</source>
        <translation>Ce service est déjà sur le tableau.</translation>
    </message>
</context>
<context>
    <name>SetUpTexts</name>
    <message>
        <source>Connect first: limits belong to one machine.</source>
        <translation>Se connecter d’abord&#xa0;: les limites appartiennent à une machine.</translation>
    </message>
    <message>
        <source>Only an engineer can do this, and not during a run.</source>
        <translation>Seul un régleur peut le faire, et pas pendant une exécution.</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Connexion</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Credit test</source>
        <translation>Test crédit</translation>
    </message>
    <message>
        <source>Certificates</source>
        <translation>Certificats</translation>
    </message>
    <message>
        <source>Rights</source>
        <translation>Droits</translation>
    </message>
    <message>
        <source>Stop test</source>
        <translation>Test arrêt</translation>
    </message>
    <message>
        <source>Job test</source>
        <translation>Test tâche</translation>
    </message>
</context>
<context>
    <name>SheetTexts</name>
    <message>
        <source>Report of a run</source>
        <translation>Rapport d’exécution</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Exécution</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Pauses and access</source>
        <translation>Pauses et accès</translation>
    </message>
    <message>
        <source>Path, seen from above; rapids dashed</source>
        <translation>Trajectoire vue de dessus&#xa0;; rapides en tirets</translation>
    </message>
    <message>
        <source>The path was not kept.</source>
        <translation>La trajectoire n’a pas été conservée.</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Date, nom, signature</translation>
    </message>
    <message>
        <source>Rivulet %1; run made with version %2</source>
        <translation>Rivulet %1&#xa0;; exécution faite avec la version %2</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Version (hash)</source>
        <translation>Version (empreinte)</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>Started by</source>
        <translation>Lancée par</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>Numéro d’exécution</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accès</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Fenêtres</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non évalué</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Exécuté</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Répétés</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Sautés</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Hors du programme</translation>
    </message>
    <message>
        <source>Out of order</source>
        <translation>Dans le désordre</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pauses</translation>
    </message>
    <message>
        <source>Pauses in all</source>
        <translation>Pauses au total</translation>
    </message>
    <message>
        <source>Share of the duration</source>
        <translation>Part de la durée</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Requêtes</translation>
    </message>
    <message>
        <source>Access, median</source>
        <translation>Accès, médiane</translation>
    </message>
    <message>
        <source>Access, 99th percentile</source>
        <translation>Accès, 99e centile</translation>
    </message>
    <message>
        <source>Streamed</source>
        <translation>Transmis</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>Changements d’outil</translation>
    </message>
    <message>
        <source>Other blocks of the control</source>
        <translation>Autres blocs de la commande</translation>
    </message>
    <message>
        <source>Changes between both</source>
        <translation>Passages de l’un à l’autre</translation>
    </message>
    <message>
        <source>%1, dry run %2 higher</source>
        <translation>%1, essai à vide %2 plus haut</translation>
    </message>
    <message>
        <source>Live lines</source>
        <translation>Lignes en direct</translation>
    </message>
    <message>
        <source>Delay from arrival to motion</source>
        <translation>Délai de l’arrivée au mouvement</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>In the spindle</source>
        <translation>Dans la broche</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Changement</translation>
    </message>
    <message>
        <source>Speed, 1/min</source>
        <translation>Vitesse, tr/min</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>En rotation</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Arrosage</translation>
    </message>
</context>
<context>
    <name>SignalTexts</name>
    <message>
        <source>Length along the program, actual</source>
        <translation>Longueur le long du programme, réelle</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Actual position</source>
        <translation>Position réelle</translation>
    </message>
    <message>
        <source>Lag (set point minus actual)</source>
        <translation>Écart de poursuite (consigne moins réel)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>À-coup</translation>
    </message>
    <message>
        <source>Contour error</source>
        <translation>Écart de contour</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Requests to the control</source>
        <translation>Requêtes à la commande</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Colonnes du fichier</translation>
    </message>
    <message>
        <source>%1 set point</source>
        <comment>of an axis</comment>
        <translation>%1 consigne</translation>
    </message>
    <message>
        <source>%1 actual</source>
        <comment>of an axis</comment>
        <translation>%1 réel</translation>
    </message>
    <message>
        <source>%1 lag</source>
        <comment>of an axis</comment>
        <translation>%1 écart de poursuite</translation>
    </message>
    <message>
        <source>%1 speed</source>
        <comment>of an axis</comment>
        <translation>%1 vitesse</translation>
    </message>
    <message>
        <source>%1 acceleration</source>
        <comment>of an axis</comment>
        <translation>%1 accélération</translation>
    </message>
    <message>
        <source>%1 jerk</source>
        <comment>of an axis</comment>
        <translation>%1 à-coup</translation>
    </message>
    <message>
        <source>Path speed</source>
        <translation>Vitesse sur trajectoire</translation>
    </message>
    <message>
        <source>Path acceleration</source>
        <translation>Accélération sur trajectoire</translation>
    </message>
    <message>
        <source>Contour error, actual</source>
        <translation>Écart de contour, réel</translation>
    </message>
    <message>
        <source>Contour error, set point</source>
        <translation>Écart de contour, consigne</translation>
    </message>
    <message>
        <source>Line on the control</source>
        <translation>Ligne sur la commande</translation>
    </message>
    <message>
        <source>Line of the program</source>
        <translation>Ligne du programme</translation>
    </message>
    <message>
        <source>Point of the program</source>
        <translation>Point du programme</translation>
    </message>
    <message>
        <source>Programmed feed</source>
        <translation>Avance programmée</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Duration of writes</source>
        <translation>Durée des écritures</translation>
    </message>
    <message>
        <source>Duration of reads</source>
        <translation>Durée des lectures</translation>
    </message>
    <message>
        <source>Length along the program</source>
        <translation>Longueur le long du programme</translation>
    </message>
    <message>
        <source>Time since the first sample</source>
        <translation>Temps depuis le premier échantillon</translation>
    </message>
</context>
<context>
    <name>StopCauseTexts</name>
    <message>
        <source>Unknown</source>
        <translation>Inconnue</translation>
    </message>
    <message>
        <source>Exact stop</source>
        <translation>Arrêt précis</translation>
    </message>
    <message>
        <source>Dwell (G4)</source>
        <translation>Temporisation (G4)</translation>
    </message>
    <message>
        <source>Programmed stop (M0, M1)</source>
        <translation>Arrêt programmé (M0, M1)</translation>
    </message>
    <message>
        <source>Tool change or auxiliary function</source>
        <translation>Changement d’outil ou fonction auxiliaire</translation>
    </message>
    <message>
        <source>Waiting for data of the client</source>
        <translation>Attente de données du client</translation>
    </message>
    <message>
        <source>Preprocessor stop</source>
        <translation>Arrêt du prétraitement</translation>
    </message>
    <message>
        <source>Pause: override 0</source>
        <translation>Pause : correction 0</translation>
    </message>
</context>
<context>
    <name>StopTexts</name>
    <message>
        <source>That stop and pause act at once has not been tested on this control: see Stop test.</source>
        <translation>Que l’arrêt et la pause agissent aussitôt n’a pas été testé sur cette commande&#xa0;: voir Test arrêt.</translation>
    </message>
    <message>
        <source>That stop and pause act at once was tested with another version of the server: test it again.</source>
        <translation>Que l’arrêt et la pause agissent aussitôt a été testé avec une autre version du serveur&#xa0;: testez de nouveau.</translation>
    </message>
    <message>
        <source>This control has failed the test that stop and pause act at once.</source>
        <translation>Cette commande n’a pas réussi le test vérifiant que l’arrêt et la pause agissent aussitôt.</translation>
    </message>
    <message>
        <source>That stop and pause act at once was tested without motion only: see Stop test.</source>
        <translation>Que l’arrêt et la pause agissent aussitôt n’a été testé que sans mouvement&#xa0;: voir Test arrêt.</translation>
    </message>
</context>
<context>
    <name>TemplateSheetTexts</name>
    <message>
        <source>Bring %1 to the control</source>
        <translation>Mettre %1 sur la commande</translation>
    </message>
    <message>
        <source>Layout number %1: with another one Rivulet moves nothing</source>
        <translation>Numéro de disposition %1&#xa0;: avec un autre, Rivulet ne déplace rien</translation>
    </message>
    <message>
        <source>This program runs on the control and moves the axes to the points that Rivulet sends in R-parameters. It is valid for the settings on this page only; with others it has another layout number.</source>
        <translation>Ce programme s’exécute sur la commande et déplace les axes vers les points que Rivulet envoie dans des paramètres R. Il ne vaut que pour les réglages de cette page&#xa0;; avec d’autres, il a un autre numéro de disposition.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>File on the control</source>
        <translation>Fichier sur la commande</translation>
    </message>
    <message>
        <source>Layout number</source>
        <translation>Numéro de disposition</translation>
    </message>
    <message>
        <source>%1 in R%2</source>
        <translation>%1 dans R%2</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Points, axes</source>
        <translation>Points, axes</translation>
    </message>
    <message>
        <source>Make sure that no other program, cycle or client uses R%1 to R%2.</source>
        <translation>S’assurer qu’aucun autre programme, cycle ou client n’utilise R%1 à R%2.</translation>
    </message>
    <message>
        <source>Copy the file to the part programs of the control, by network or USB stick, as %1. Change nothing in it: Rivulet relies on every line.</source>
        <translation>Copier le fichier dans les programmes pièce de la commande, par le réseau ou une clé USB, sous le nom %1. N’y rien changer&#xa0;: Rivulet se fie à chaque ligne.</translation>
    </message>
    <message>
        <source>Copy the file to the folder of the NC programs of the control as %1. Change nothing in it: Rivulet relies on every line.</source>
        <translation>Copier le fichier dans le dossier des programmes CN de la commande sous le nom %1. N’y rien changer&#xa0;: Rivulet se fie à chaque ligne.</translation>
    </message>
    <message numerus="yes">
        <source>In Rivulet, column Settings, tick “copied by hand” at Template. Look through what Start shows, then hold Start. From then on Rivulet waits up to %n minutes.</source>
        <translation>
            <numerusform>Dans Rivulet, colonne Paramètres, cocher «&#xa0;copié à la main&#xa0;» à Modèle. Vérifier ce que montre Démarrer, puis le maintenir. Rivulet attend alors jusqu’à %n minute.</numerusform>
            <numerusform>Dans Rivulet, colonne Paramètres, cocher «&#xa0;copié à la main&#xa0;» à Modèle. Vérifier ce que montre Démarrer, puis le maintenir. Rivulet attend alors jusqu’à %n minutes.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the control: select the program in channel 1, close the doors, set the feed override, press cycle start. No axis moves yet.</source>
        <translation>Sur la commande&#xa0;: sélectionner le programme dans le canal 1, fermer les portes, régler l’override d’avance, appuyer sur Départ cycle. Aucun axe ne bouge encore.</translation>
    </message>
    <message>
        <source>The program writes its layout number and waits. Only when Rivulet has read the right number, it sends points and the axes move.</source>
        <translation>Le programme écrit son numéro de disposition et attend. Ce n’est qu’après avoir lu le bon numéro que Rivulet envoie des points et que les axes bougent.</translation>
    </message>
    <message>
        <source>The control shows this program as running from cycle start until its end, also while the axes stand and it waits for points.</source>
        <translation>La commande montre ce programme en cours du Départ cycle jusqu’à sa fin, aussi pendant que les axes sont à l’arrêt et qu’il attend des points.</translation>
    </message>
    <message>
        <source>Feed override, feed hold, reset and emergency stop of the machine act as in any other program. Stop and Pause in Rivulet do not replace them.</source>
        <translation>L’override d’avance, l’arrêt avance, Reset et l’arrêt d’urgence de la machine agissent comme dans tout autre programme. Arrêt et Pause de Rivulet ne les remplacent pas.</translation>
    </message>
    <message>
        <source>If Rivulet, its computer or the network fails, nothing new is sent: with numbered windows the axes stand; with methods position and signal they may go to old points again.</source>
        <translation>Si Rivulet, son ordinateur ou le réseau tombe en panne, rien de nouveau n’est envoyé&#xa0;: avec des fenêtres numérotées, les axes s’arrêtent&#xa0;; avec les méthodes Position et Signal, ils peuvent retourner à d’anciens points.</translation>
    </message>
    <message>
        <source>End the run in Rivulet. If the program still runs: press reset at the control.</source>
        <translation>Terminer l’exécution dans Rivulet. Si le programme tourne encore&#xa0;: appuyer sur Reset sur la commande.</translation>
    </message>
    <message>
        <source>Select another program, then delete the file from the part programs of the control.</source>
        <translation>Sélectionner un autre programme, puis effacer le fichier des programmes pièce de la commande.</translation>
    </message>
    <message>
        <source>The R-parameters keep their last values. Set to 0 those that other programs read.</source>
        <translation>Les paramètres R gardent leurs dernières valeurs. Mettre à 0 ceux que d’autres programmes lisent.</translation>
    </message>
    <message>
        <source>Take back the rights that were given for it; on a SINUMERIK with DeleteUserAccess. Remove the certificate of this computer from those that the control trusts if Rivulet is not to connect again.</source>
        <translation>Retirer les droits donnés pour cela&#xa0;; sur une SINUMERIK avec DeleteUserAccess. Retirer le certificat de cet ordinateur de ceux auxquels la commande fait confiance si Rivulet ne doit plus se connecter.</translation>
    </message>
    <message>
        <source>Rights of the OPC UA user</source>
        <translation>Droits de l’utilisateur OPC UA</translation>
    </message>
    <message>
        <source>(Not needed for these steps.)</source>
        <translation>(Pas nécessaire pour ces étapes.)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>What the operator sees</source>
        <translation>Ce que voit l’opérateur</translation>
    </message>
    <message>
        <source>Taking it back</source>
        <translation>Tout retirer</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Date, nom, signature</translation>
    </message>
</context>
<context>
    <name>TraceRemarks</name>
    <message>
        <source>The program does not belong to this trace from %1 s on.</source>
        <translation>À partir de %1 s, le programme n’appartient pas à cette trace.</translation>
    </message>
    <message>
        <source>The trace of the control is incomplete: its memory was full.</source>
        <translation>La trace de la commande est incomplète&#xa0;: sa mémoire était pleine.</translation>
    </message>
    <message>
        <source>Lines of the recording that cannot be read and were left out: %1.</source>
        <translation>Lignes illisibles de l’enregistrement, omises&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The recording ends before its run: what came before is shown.</source>
        <translation>L’enregistrement se termine avant son exécution&#xa0;: ce qui précède est affiché.</translation>
    </message>
    <message>
        <source>The columns mean what was said for this layout before: %1.</source>
        <translation>Les colonnes ont le sens indiqué auparavant pour cette disposition&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The file does not say the units of its speeds: mm/min is assumed, as the control shows them.</source>
        <translation>Le fichier ne donne pas les unités des vitesses&#xa0;: mm/min est supposé, comme la commande les affiche.</translation>
    </message>
    <message>
        <source>The compressed file is cut or damaged: what came before was read.</source>
        <translation>Le fichier compressé est coupé ou endommagé&#xa0;: ce qui précède a été lu.</translation>
    </message>
    <message>
        <source>The file was cut off: its end is missing.</source>
        <translation>Le fichier a été coupé&#xa0;: sa fin manque.</translation>
    </message>
    <message>
        <source>The file ends within a row: it was cut off there.</source>
        <translation>Le fichier se termine au milieu d’une ligne&#xa0;: il y a été coupé.</translation>
    </message>
    <message>
        <source>Cells that are no numbers and were left empty: %1, the first in line %2.</source>
        <translation>Cellules laissées vides parce qu’elles ne sont pas des nombres&#xa0;: %1, la première à la ligne %2.</translation>
    </message>
    <message>
        <source>Rows that do not have %1 columns and were left out: %2, the first in line %3.</source>
        <translation>Lignes omises parce qu’elles n’ont pas %1 colonnes&#xa0;: %2, la première à la ligne %3.</translation>
    </message>
    <message>
        <source>The file has %1 columns of time; each belongs to the columns after it.</source>
        <translation>Le fichier a %1 colonnes de temps&#xa0;; chacune vaut pour les colonnes qui la suivent.</translation>
    </message>
    <message>
        <source>Values whose time runs backwards and that were left out: %1.</source>
        <translation>Valeurs omises parce que leur temps recule&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Rows that repeat the time of the row before and were left out: %1.</source>
        <translation>Lignes omises parce qu’elles répètent le temps de la précédente&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; runs backwards at row %2. Rows that were left out until it goes on: %3.</source>
        <translation>Le temps «&#xa0;%1&#xa0;» recule à la ligne %2. Lignes omises jusqu’à ce qu’il reprenne&#xa0;: %3.</translation>
    </message>
    <message>
        <source>The file has no column of time: %1 Hz is assumed.</source>
        <translation>Le fichier n’a pas de colonne de temps&#xa0;: %1 Hz sont supposés.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; has no unit: %2 is assumed.</source>
        <translation>Le temps «&#xa0;%1&#xa0;» n’a pas d’unité&#xa0;: %2 est supposé.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; occurs more than once: this one is called &quot;%2&quot;.</source>
        <translation>La colonne «&#xa0;%1&#xa0;» existe plusieurs fois&#xa0;: celle-ci s’appelle «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Datasets that are no row of numbers and were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Jeux de données qui ne sont pas une suite de nombres et ont été omis&#xa0;: %1, le premier «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Datasets that are damaged and were read in part or not at all: %1, the first &quot;%2&quot;.</source>
        <translation>Jeux de données endommagés, lus en partie ou pas du tout&#xa0;: %1, le premier «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Datasets to whose length no time belongs and that were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Jeux de données sans temps de la même longueur, omis&#xa0;: %1, le premier «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>The rows are not in the order of their time &quot;%1&quot;, the first at row %2: they were sorted.</source>
        <translation>Les lignes ne sont pas dans l’ordre de leur temps «&#xa0;%1&#xa0;», la première est la %2&#xa0;: elles ont été triées.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; starts again, the first time at row %2. %3 sections are shown %4 s apart, and the longest one is analysed.</source>
        <translation>Le temps «&#xa0;%1&#xa0;» recommence, pour la première fois à la ligne %2. %3 sections sont affichées à %4 s d’intervalle, et la plus longue est analysée.</translation>
    </message>
    <message>
        <source>The signals stand in rows of their own: straight lines are assumed between the values of each.</source>
        <translation>Chaque signal est dans ses propres lignes&#xa0;: entre ses valeurs, des droites sont supposées.</translation>
    </message>
    <message>
        <source>Rows of text that hold no values and were left out: %1, the first in line %2.</source>
        <translation>Lignes de texte sans valeurs, omises&#xa0;: %1, la première est la ligne %2.</translation>
    </message>
    <message>
        <source>No date tells what comes first in it: day/month is assumed.</source>
        <translation>Aucune date ne dit ce qui vient en premier&#xa0;: jour/mois est supposé.</translation>
    </message>
    <message>
        <source>An MTConnect agent reports a value when it changes: in gaps the last value is held; otherwise straight lines are assumed between values.</source>
        <translation>Un agent MTConnect signale une valeur quand elle change&#xa0;: dans les lacunes, la dernière valeur est maintenue&#xa0;; sinon, des droites sont supposées entre les valeurs.</translation>
    </message>
    <message>
        <source>All positions are known from %1 s on: what comes before is not analysed.</source>
        <translation>Toutes les positions sont connues à partir de %1 s&#xa0;: ce qui précède n’est pas analysé.</translation>
    </message>
    <message>
        <source>Values with the time of a later value of the same item, which counts instead: %1.</source>
        <translation>Valeurs ayant l’instant d’une valeur ultérieure du même élément, qui compte à leur place&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Observations that are tables or sets of values and were left out: %1, the first of &quot;%2&quot;.</source>
        <translation>Observations qui sont des tableaux ou des ensembles de valeurs et qui ont été omises&#xa0;: %1, la première de «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Series of values without a sample rate that were left out, because their times are not known: %1, the first of &quot;%2&quot;.</source>
        <translation>Séries de valeurs sans fréquence d’échantillonnage, omises parce que leurs instants sont inconnus&#xa0;: %1, la première de «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Observations without a time or a number that can be read and that were left out: %1, the first of &quot;%2&quot;.</source>
        <translation>Observations sans instant ou sans nombre lisible, qui ont été omises&#xa0;: %1, la première de «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Items without any value that were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Éléments sans aucune valeur, qui ont été omis&#xa0;: %1, le premier «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Items that mean the same as another one, which is analysed instead: %1.</source>
        <translation>Éléments qui signifient la même chose qu’un autre, analysé à leur place&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The unit &quot;%2&quot; of the item &quot;%1&quot; is not known: the item is not analysed.</source>
        <translation>L’unité «&#xa0;%2&#xa0;» de l’élément «&#xa0;%1&#xa0;» est inconnue&#xa0;: l’élément n’est pas analysé.</translation>
    </message>
    <message>
        <source>States and messages of the machine that are too many and were left out: %1.</source>
        <translation>États et messages de la machine trop nombreux, qui ont été omis&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The MTConnect agent refused a part: %1.</source>
        <translation>L’agent MTConnect a refusé une partie&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Observations between two answers that the MTConnect agent no longer had: %1. The motion is not known there.</source>
        <translation>Observations entre deux réponses que l’agent MTConnect n’avait plus&#xa0;: %1. Le mouvement n’y est pas connu.</translation>
    </message>
    <message>
        <source>The MTConnect agent was started again between two answers: what it had kept until then may be incomplete.</source>
        <translation>L’agent MTConnect a été redémarré entre deux réponses&#xa0;: ce qu’il avait conservé jusque-là peut être incomplet.</translation>
    </message>
</context>
<context>
    <name>TraceTexts</name>
    <message>
        <source>Report of a run</source>
        <translation>Rapport d’exécution</translation>
    </message>
    <message>
        <source>Report on a motion</source>
        <translation>Rapport sur un mouvement</translation>
    </message>
    <message>
        <source>Every point executed once, in order</source>
        <translation>Chaque point exécuté une fois, dans l’ordre</translation>
    </message>
    <message>
        <source>The motion is not that of the program</source>
        <translation>Le mouvement n’est pas celui du programme</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Non jugé</translation>
    </message>
    <message>
        <source>Whether each point was executed is not known: the program or a part of the trace is missing.</source>
        <translation>On ne sait pas si chaque point a été exécuté&#xa0;: le programme ou une partie de la mesure manque.</translation>
    </message>
    <message>
        <source>The recording was cut off before the end of the run. What it holds is judged here.</source>
        <translation>L’enregistrement s’arrête avant la fin de l’exécution. Ce qu’il contient est jugé ici.</translation>
    </message>
    <message>
        <source>The motion leaves the program for good before line %1, at X %2 Y %3 Z %4.</source>
        <translation>Le mouvement quitte définitivement le programme avant la ligne %1, à X %2 Y %3 Z %4.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Exécution</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Mesure</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Client and control</source>
        <translation>Client et commande</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Date, nom, signature</translation>
    </message>
    <message>
        <source>File %1, SHA-256 %2</source>
        <translation>Fichier %1, SHA-256 %2</translation>
    </message>
    <message>
        <source>Rivulet %1</source>
        <translation>Rivulet %1</translation>
    </message>
    <message>
        <source>Rivulet %1; run made with version %2</source>
        <translation>Rivulet %1&#xa0;; exécution faite avec la version %2</translation>
    </message>
    <message>
        <source>Program grey, motion blue</source>
        <translation>Programme gris, mouvement bleu</translation>
    </message>
    <message>
        <source>The trace holds no motion.</source>
        <translation>La mesure ne contient aucun mouvement.</translation>
    </message>
    <message>
        <source>Path speed; stops are orange</source>
        <translation>Vitesse sur trajectoire&#xa0;; arrêts en orange</translation>
    </message>
    <message>
        <source>Duration of requests: median blue, longest orange</source>
        <translation>Durée des requêtes&#xa0;: médiane bleue, la plus longue orange</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Temps, s</translation>
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
        <translation>Les plus longs de %1 arrêts</translation>
    </message>
    <message>
        <source>At</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Place, mm</source>
        <translation>Lieu, mm</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Cause</translation>
    </message>
    <message>
        <source>What limited the run: the client. The machine waited %1 times for its data, %2 in all.</source>
        <translation>Ce qui a limité l’exécution&#xa0;: le client. La machine a attendu %1 fois ses données, %2 en tout.</translation>
    </message>
    <message>
        <source>What limited the run: the access time. At %1 the client is slower than the machine; up to %2 it keeps up.</source>
        <translation>Ce qui a limité l’exécution&#xa0;: le temps d’accès. À %1, le client est plus lent que la machine&#xa0;; jusqu’à %2, il suit.</translation>
    </message>
    <message>
        <source>What limited the run: the stops between loops or windows, %1 in all.</source>
        <translation>Ce qui a limité l’exécution&#xa0;: les arrêts entre boucles ou fenêtres, %1 en tout.</translation>
    </message>
    <message>
        <source>What limited the run: the machine, by braking and accelerating, not the client.</source>
        <translation>Ce qui a limité l’exécution&#xa0;: la machine, par freinages et accélérations, pas le client.</translation>
    </message>
    <message>
        <source>With N = %1, feeds up to %2 would have been possible.</source>
        <translation>Avec N = %1, des avances jusqu’à %2 auraient été possibles.</translation>
    </message>
    <message>
        <source>With arrays that cost as much as one variable, feeds up to %1 would have been possible.</source>
        <translation>Avec des tableaux qui coûtent autant qu’une variable, des avances jusqu’à %1 auraient été possibles.</translation>
    </message>
    <message>
        <source>Without another change, %1 is the largest feed at which the machine does not wait.</source>
        <translation>Sans autre changement, %1 est la plus grande avance à laquelle la machine n’attend pas.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Type de fichier</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Time between two samples</source>
        <translation>Temps entre deux échantillons</translation>
    </message>
    <message>
        <source>Version (hash)</source>
        <translation>Version (empreinte)</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrage</translation>
    </message>
    <message>
        <source>Started by</source>
        <translation>Lancée par</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>Numéro d’exécution</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposition</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non évalué</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Exécuté</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Répétés</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Sautés</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Hors du programme</translation>
    </message>
    <message>
        <source>Out of order</source>
        <translation>Dans le désordre</translation>
    </message>
    <message>
        <source>Not decided by the samples</source>
        <translation>Non décidé par la mesure</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1 à la ligne %2</translation>
    </message>
    <message>
        <source>Contour error, set point</source>
        <translation>Erreur de contour, consigne</translation>
    </message>
    <message>
        <source>Contour error, actual</source>
        <translation>Erreur de contour, réel</translation>
    </message>
    <message>
        <source>Following error XYZ</source>
        <translation>Erreur de poursuite XYZ</translation>
    </message>
    <message>
        <source>Reversal error XYZ</source>
        <translation>Erreur d’inversion XYZ</translation>
    </message>
    <message>
        <source>Strongest vibration</source>
        <translation>Vibration la plus forte</translation>
    </message>
    <message>
        <source>Programmed feed kept</source>
        <translation>Avance programmée tenue</translation>
    </message>
    <message>
        <source>At the programmed feed</source>
        <translation>À l’avance programmée</translation>
    </message>
    <message>
        <source>Lost by moving slower</source>
        <translation>Perdu par ralentissement</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Requêtes</translation>
    </message>
    <message>
        <source>Machine waited for the client</source>
        <translation>La machine a attendu le client</translation>
    </message>
    <message>
        <source>%1 times, %2</source>
        <translation>%1 fois, %2</translation>
    </message>
    <message>
        <source>Largest feed without waiting</source>
        <translation>Plus grande avance sans attente</translation>
    </message>
    <message>
        <source>Median, 99 %, longest</source>
        <translation>Médiane, 99&#xa0;%, maximum</translation>
    </message>
    <message>
        <source>Requests made again</source>
        <translation>Requêtes répétées</translation>
    </message>
    <message>
        <source>Margin; of the slowest 1 %</source>
        <translation>Marge&#xa0;; des 1&#xa0;% plus lentes</translation>
    </message>
    <message>
        <source>Path speed up to %1 mm/min; stops are orange</source>
        <translation>Vitesse sur trajectoire jusqu’à %1 mm/min&#xa0;; arrêts en orange</translation>
    </message>
</context>
<context>
    <name>TracesPage</name>
    <message>
        <source>The file of the pane layouts is damaged. What can be read of it is used, and the file is kept as %1.</source>
        <translation>Le fichier des dispositions de volets est endommagé. Ce qui en est lisible est utilisé, et le fichier est conservé sous %1.</translation>
    </message>
    <message>
        <source>A run is in progress. Open files after it has ended.</source>
        <translation>Une exécution est en cours. Ouvrir les fichiers quand elle sera terminée.</translation>
    </message>
</context>
<context>
    <name>TrendWords</name>
    <message>
        <source>Trend of the runs</source>
        <translation>Tendance des exécutions</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Exécutions</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>Jours</translation>
    </message>
    <message>
        <source>Access, ms</source>
        <translation>Accès, ms</translation>
    </message>
    <message>
        <source>Paused, s</source>
        <translation>Pauses, s</translation>
    </message>
    <message>
        <source>per run</source>
        <translation>par exécution</translation>
    </message>
    <message>
        <source>per day</source>
        <translation>par jour</translation>
    </message>
    <message>
        <source>Access time per run</source>
        <translation>Temps d’accès par exécution</translation>
    </message>
    <message>
        <source>Mean access time, ms</source>
        <translation>Temps d’accès moyen, ms</translation>
    </message>
    <message>
        <source>Pauses per run</source>
        <translation>Pauses par exécution</translation>
    </message>
    <message>
        <source>Time in pauses, s</source>
        <translation>Temps en pause, s</translation>
    </message>
    <message>
        <source>Run of the machine</source>
        <translation>Exécution de la machine</translation>
    </message>
    <message>
        <source>Days since %1</source>
        <comment>a date</comment>
        <translation>Jours depuis le %1</translation>
    </message>
    <message>
        <source>%1, trend</source>
        <comment>of a machine</comment>
        <translation>%1, tendance</translation>
    </message>
</context>
<context>
    <name>TrustTexts</name>
    <message>
        <source>Only an engineer can do this.</source>
        <translation>Seul un régleur peut le faire.</translation>
    </message>
    <message>
        <source>Connect first.</source>
        <translation>Connecter d’abord.</translation>
    </message>
    <message>
        <source>During a run there is no time for it.</source>
        <translation>Pendant une exécution, il n’y a pas de temps pour cela.</translation>
    </message>
</context>
<context>
    <name>UserTexts</name>
    <message>
        <source>At least one user must be an engineer.</source>
        <translation>Au moins un utilisateur doit être régleur.</translation>
    </message>
    <message>
        <source>The file of users is damaged. Restore it, or delete it to set the users up again.</source>
        <translation>Le fichier des utilisateurs est endommagé. Le restaurer, ou le supprimer et redéfinir les utilisateurs.</translation>
    </message>
    <message>
        <source>Give a name.</source>
        <translation>Indiquer un nom.</translation>
    </message>
    <message>
        <source>The PIN needs at least 4 characters.</source>
        <translation>Le code PIN doit avoir au moins 4 caractères.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Alarms</name>
    <message>
        <source>%1: %2 damaged lines of the history of alarms were left out.</source>
        <translation>%1&#xa0;: %2 lignes endommagées de l’historique des alarmes ont été omises.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Certificates</name>
    <message>
        <source>Saved %1.</source>
        <translation>%1 enregistré.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Demo</name>
    <message>
        <source>The picture or the report cannot be written to %1.</source>
        <translation>L’image ou le rapport ne peut pas être écrit dans %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Document</name>
    <message>
        <source>Line %1</source>
        <translation>Ligne %1</translation>
    </message>
    <message>
        <source>A dry run needs the whole job, but only the motion of this program would be streamed. Choose Whole job.</source>
        <translation>Seule une tâche complète s’exécute à vide, et ce programme n’est que mouvement. Choisir Tâche complète.</translation>
    </message>
    <message>
        <source>A dry run needs the whole job: choose method window or credit, and no online correction.</source>
        <translation>Un essai à vide exige la tâche complète&#xa0;: choisir la méthode Fenêtre ou Crédit, sans correction en ligne.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::FoundRuns</name>
    <message>
        <source>The run that was watched has ended.</source>
        <translation>L’exécution observée est terminée.</translation>
    </message>
    <message>
        <source>There is a run on the control: %1</source>
        <translation>Il y a une exécution sur la commande&#xa0;: %1</translation>
    </message>
    <message>
        <source>The run has been stopped; confirmed after %1.</source>
        <translation>L’exécution est arrêtée&#xa0;; confirmé après %1.</translation>
    </message>
    <message>
        <source>Stop of the run on the control requested.</source>
        <translation>Arrêt de l’exécution sur la commande demandé.</translation>
    </message>
    <message>
        <source>The file of the program, %1, cannot be found. Open the program, then try again.</source>
        <translation>Le fichier du programme, %1, est introuvable. Ouvrir le programme, puis réessayer.</translation>
    </message>
    <message>
        <source>This run was a whole job, and its program cannot be run as one here now. The command rivulet-cli job --resume goes on with it.</source>
        <translation>Cette exécution était une tâche complète, et son programme ne peut pas être exécuté ainsi ici maintenant. La commande rivulet-cli job --resume la poursuit.</translation>
    </message>
    <message>
        <source>The axes of the run on the control are held; they stood after %1.</source>
        <translation>Les axes de l’exécution sur la commande sont maintenus&#xa0;; ils se sont arrêtés après %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::LiveSource</name>
    <message>
        <source>A run is in progress. Open a live source after it has ended.</source>
        <translation>Une exécution est en cours. Ouvrir une source en direct quand elle sera terminée.</translation>
    </message>
    <message>
        <source>Listening for live points on %1.</source>
        <translation>Des points en direct sont attendus sur %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MachineModel</name>
    <message>
        <source>Connected to the virtual machine at %1.</source>
        <translation>Connecté à la machine virtuelle à %1.</translation>
    </message>
    <message>
        <source>Connected to the control at %1.</source>
        <translation>Connecté à la commande à %1.</translation>
    </message>
    <message>
        <source>Calibrated. Saved %1.</source>
        <translation>Étalonné. %1 enregistré.</translation>
    </message>
    <message>
        <source>The calibration belongs to another version of the server and is not used.</source>
        <translation>L’étalonnage correspond à une autre version du serveur et n’est pas utilisé.</translation>
    </message>
    <message>
        <source>The map %1 does not name: %2. What needs it does not work.</source>
        <translation>La table de correspondance %1 ne nomme pas : %2. Ce qui en a besoin ne fonctionne pas.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MachineProfiles</name>
    <message>
        <source>The limits of %1 have been saved.</source>
        <translation>Les limites de %1 ont été enregistrées.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MainWindow</name>
    <message>
        <source>About Rivulet</source>
        <translation>À propos de Rivulet</translation>
    </message>
    <message>
        <source>Rivulet %1
Streams a tool path to a CNC machine over OPC UA while the machine moves.

Stop ends the program at the end of its loop. It is not an emergency stop.

GPL-3.0-or-later</source>
        <translation>Rivulet %1
Transmet une trajectoire d’outil à une machine CNC par OPC UA pendant que la machine se déplace.

Arrêt termine le programme à la fin de sa boucle. Ce n’est pas un arrêt d’urgence.

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
        <translation>&amp;Ouvrir un programme…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>&amp;About Rivulet</source>
        <translation>À &amp;propos de Rivulet</translation>
    </message>
    <message>
        <source>Method, feed and verdict</source>
        <translation>Méthode, avance et verdict</translation>
    </message>
    <message>
        <source>&amp;Menu</source>
        <translation>&amp;Menu</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Contraste élevé</translation>
    </message>
    <message>
        <source>Li&amp;ve points …</source>
        <translation>Points en &amp;direct…</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Analyse</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>Réglages</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>Paramètre&amp;s</translation>
    </message>
    <message>
        <source>La&amp;rge view</source>
        <translation>&amp;Grande vue</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::PastRuns</name>
    <message>
        <source>A run is in progress: the Traces page shows it until it has ended.</source>
        <translation>Une exécution est en cours&#xa0;: la page Courbes la montre jusqu’à sa fin.</translation>
    </message>
    <message>
        <source>A run is in progress. Open another program after it has ended.</source>
        <translation>Une exécution est en cours. Ouvrir un autre programme quand elle sera terminée.</translation>
    </message>
    <message>
        <source>The settings of the run have been taken over. Where its program was is not known: open the program with version %1.</source>
        <translation>Les réglages de l’exécution sont repris. Elle n’indique pas où était son programme&#xa0;: ouvrir le programme de version %1.</translation>
    </message>
    <message>
        <source>%1 is not the program of that run: version %2 then, %3 now. Its settings are set. Check the path before you start.</source>
        <translation>%1 n’est pas le programme de cette exécution&#xa0;: version %2 alors, %3 maintenant. Ses réglages sont repris. Vérifier la trajectoire avant de démarrer.</translation>
    </message>
    <message>
        <source>Program and settings are those of the run of %1. Nothing has started.</source>
        <translation>Programme et réglages sont ceux de l’exécution du %1. Rien n’a démarré.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::PipelineRun</name>
    <message>
        <source>The program rivulet-cnc is missing. Install it beside this window.</source>
        <translation>Le programme rivulet-cnc manque. L’installer à côté de cette fenêtre.</translation>
    </message>
    <message>
        <source>The tasks have ended without a message. Execute the program again.</source>
        <translation>Les tâches se sont terminées sans message. Exécuter de nouveau le programme.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Preflight</name>
    <message>
        <source>In the way</source>
        <translation>Obstacle</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>%1 has changed on disk since version %2 was read.</source>
        <translation>%1 a été modifié sur le disque depuis la lecture de la version %2.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Non connecté</translation>
    </message>
    <message>
        <source>%1: a virtual machine, no real axis moves</source>
        <translation>%1&#xa0;: une machine virtuelle, aucun axe réel ne bouge</translation>
    </message>
    <message>
        <source>%1: the axes of this machine will move</source>
        <translation>%1&#xa0;: les axes de cette machine vont bouger</translation>
    </message>
    <message>
        <source>First move</source>
        <translation>Premier mouvement</translation>
    </message>
    <message>
        <source>The position of the tool is not known.</source>
        <translation>La position de l’outil n’est pas connue.</translation>
    </message>
    <message>
        <source>From %1 in a straight line over %2 to point 1 at %3</source>
        <translation>De %1 en ligne droite sur %2 jusqu’au point 1 à %3</translation>
    </message>
    <message>
        <source>The last run was left at %1 of %2 points. This start does not go on there: it moves from where the tool stands, perhaps in the cut, to the first point.</source>
        <translation>La dernière exécution s’est interrompue à %1 points sur %2. Ce départ ne continue pas là&#xa0;: il va de la position actuelle de l’outil, peut-être en pleine coupe, jusqu’au premier point.</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>%1 for every block, set here</source>
        <translation>%1 pour chaque bloc, réglée ici</translation>
    </message>
    <message>
        <source>%1. The program names no feed.</source>
        <translation>%1. Le programme n’indique aucune avance.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1. The program&apos;s own feed, %2, is not used.</source>
        <translation>%1. L’avance propre au programme, %2, n’est pas utilisée.</translation>
    </message>
    <message>
        <source>Some blocks will be cut %1 times as fast as programmed.</source>
        <translation>Certains blocs seront usinés %1 fois plus vite que programmé.</translation>
    </message>
    <message>
        <source>Use F = %1</source>
        <translation>Utiliser F = %1</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>There is no verdict.</source>
        <translation>Il n’y a pas de verdict.</translation>
    </message>
    <message>
        <source>Safe, but the machine will wait for points. Largest feed without waiting: %1.</source>
        <translation>Sûr, mais la machine attendra des points. Avance maximale sans attente&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Margin %1 ×, largest feed %2</source>
        <translation>Marge %1 ×, avance maximale %2</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accès</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Validation</translation>
    </message>
    <message>
        <source>Released by %1 on %2, who starts: %3</source>
        <translation>Validé par %1 le %2, démarré par&#xa0;: %3</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>This program with these settings and this calibration is not released.</source>
        <translation>Ce programme avec ces réglages et cet étalonnage n’est pas validé.</translation>
    </message>
    <message>
        <source>point %1 of %2 at %3</source>
        <translation>point %1 sur %2 à %3</translation>
    </message>
    <message>
        <source>From point %1 on, the program differs from that of the interrupted run.</source>
        <translation>À partir du point %1, le programme diffère de celui de l’exécution interrompue.</translation>
    </message>
    <message>
        <source>Who starts</source>
        <translation>Qui démarre</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>The feeds of the program at %1. It names none.</source>
        <translation>Les avances du programme à %1. Il n’en indique aucune.</translation>
    </message>
    <message>
        <source>That of the program, %1, at %2</source>
        <translation>Celle du programme, %1, à %2</translation>
    </message>
    <message>
        <source>Those of the program, %1 to %2, at %3; each block its own</source>
        <translation>Celles du programme, %1 à %2, à %3&#xa0;; chaque bloc a la sienne</translation>
    </message>
    <message>
        <source>Rapids at %1 at most</source>
        <translation>Rapides à %1 au plus</translation>
    </message>
    <message>
        <source>Blocks will be cut faster than programmed.</source>
        <translation>Des blocs seront usinés plus vite que programmé.</translation>
    </message>
    <message>
        <source>Use 100 %</source>
        <translation>Utiliser 100&#xa0;%</translation>
    </message>
    <message>
        <source>%1 for every block: this method has one feed, as it was published</source>
        <translation>%1 pour chaque bloc&#xa0;: cette méthode a une seule avance, comme dans sa publication</translation>
    </message>
    <message>
        <source>Use the feeds of the program</source>
        <translation>Utiliser les avances du programme</translation>
    </message>
    <message>
        <source>Safe, but the machine will wait for points. Largest override without waiting: %1.</source>
        <translation>Sûr, mais la machine attendra des points. Override maximal sans attente&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Margin %1 ×, largest override %2</source>
        <translation>Marge %1 ×, override maximal %2</translation>
    </message>
    <message>
        <source>%1 (line %2)</source>
        <translation>%1 (ligne %2)</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 autres</translation>
    </message>
    <message>
        <source>Whole job</source>
        <translation>Tâche complète</translation>
    </message>
    <message>
        <source>Motion only</source>
        <translation>Mouvement seul</translation>
    </message>
    <message>
        <source>Set tool, spindle and coolant at the control.</source>
        <translation>Régler l’outil, la broche et l’arrosage sur la commande.</translation>
    </message>
    <message>
        <source>Run the whole job</source>
        <translation>Exécuter la tâche complète</translation>
    </message>
    <message>
        <source>First the control executes line %1: %2. Then the tool moves from where it stands to the first point of part 1.</source>
        <translation>La commande exécute d’abord la ligne %1 : %2. Puis l’outil va de sa position au premier point du tronçon 1.</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Course</translation>
    </message>
    <message>
        <source>Not checked: nobody has entered the limits of this machine.</source>
        <translation>Non vérifié&#xa0;: personne n’a saisi les limites de cette machine.</translation>
    </message>
    <message>
        <source>Enter …</source>
        <translation>Saisir…</translation>
    </message>
    <message>
        <source>%1 needs %2, the machine has %3</source>
        <translation>%1 demande %2, la machine a %3</translation>
    </message>
    <message>
        <source>The path is longer than the travel: %1.</source>
        <translation>La trajectoire est plus longue que la course&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The path (%1 mm) is not longer than the travel of the axes. Where the workpiece lies is not known to Rivulet.</source>
        <translation>La trajectoire (%1 mm) n’est pas plus longue que la course des axes. Rivulet ne sait pas où se trouve la pièce.</translation>
    </message>
    <message>
        <source>Travel, spindle and tools</source>
        <translation>Courses, broche et outils</translation>
    </message>
    <message>
        <source>The job is being compared with the machine.</source>
        <translation>La tâche est comparée à la machine.</translation>
    </message>
    <message>
        <source>Every block is within the travel of the axes, the speed of the spindle and the tool table.</source>
        <translation>Tous les blocs respectent les courses des axes, la vitesse de la broche et la table d’outils.</translation>
    </message>
    <message numerus="yes">
        <source>%1, version %2, %Ln points</source>
        <translation>
            <numerusform>%1, version %2, %Ln point</numerusform>
            <numerusform>%1, version %2, %Ln points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Streamed: %1; the control executes %Ln blocks: %2</source>
        <translation>
            <numerusform>Transmission en continu&#xa0;: %1&#xa0;; la commande exécute %Ln bloc&#xa0;: %2</numerusform>
            <numerusform>Transmission en continu&#xa0;: %1&#xa0;; la commande exécute %Ln blocs&#xa0;: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln tronçon</numerusform>
            <numerusform>%Ln tronçons</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln blocks are left out: %1</source>
        <translation>
            <numerusform>%Ln bloc est omis&#xa0;: %1</numerusform>
            <numerusform>%Ln blocs sont omis&#xa0;: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line over %1 to %2. %Ln points have been executed.</source>
        <translation>
            <numerusform>En ligne droite sur %1 jusqu’à %2. %Ln point a été exécuté.</numerusform>
            <numerusform>En ligne droite sur %1 jusqu’à %2. %Ln points ont été exécutés.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line to %1. %Ln points have been executed.</source>
        <translation>
            <numerusform>En ligne droite jusqu’à %1. %Ln point a été exécuté.</numerusform>
            <numerusform>En ligne droite jusqu’à %1. %Ln points ont été exécutés.</numerusform>
        </translation>
    </message>
    <message>
        <source>as a rapid, %1</source>
        <translation>en rapide, %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>à %1</translation>
    </message>
    <message>
        <source>From where the tool stands in a straight line over %1, %2, to where line %3 begins: %4.</source>
        <translation>De la position de l’outil en ligne droite sur %1, %2, jusqu’au début de la ligne %3&#xa0;: %4.</translation>
    </message>
    <message>
        <source>From where the tool stands in a straight line, %1, to where line %2 begins: %3.</source>
        <translation>De la position de l’outil en ligne droite, %1, jusqu’au début de la ligne %2&#xa0;: %3.</translation>
    </message>
    <message numerus="yes">
        <source>The %Ln points before it are not executed.</source>
        <translation>
            <numerusform>Le %Ln point qui précède n’est pas exécuté.</numerusform>
            <numerusform>Les %Ln points qui précèdent ne sont pas exécutés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Feeds are those that the program has commanded up to each line, and the work offset is the one that is active at the control.</source>
        <translation>Les avances sont celles que le programme a commandées jusqu’à chaque ligne, et le décalage d’origine est celui qui est actif sur la commande.</translation>
    </message>
    <message>
        <source>State at this line</source>
        <translation>État à cette ligne</translation>
    </message>
    <message>
        <source>Left out before this line, the last one first: %1. Set at the control what holds here.</source>
        <translation>Omis avant cette ligne, le dernier en premier&#xa0;: %1. Régler sur la commande ce qui vaut ici.</translation>
    </message>
    <message>
        <source>Begin with a part …</source>
        <translation>Commencer à un tronçon …</translation>
    </message>
    <message>
        <source>First the control executes</source>
        <translation>La commande exécute d’abord</translation>
    </message>
    <message>
        <source>Then the job goes on in part %1 at point %2 of %3 (line %4).</source>
        <translation>Puis la tâche reprend au tronçon %1, point %2 sur %3 (ligne %4).</translation>
    </message>
    <message>
        <source>Then the job goes on at line %1: %2</source>
        <translation>Puis la tâche reprend à la ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Not done again, because only the control knows their effect: %1</source>
        <translation>Non réexécutés, car seule la commande connaît leur effet&#xa0;: %1</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Essai à vide</translation>
    </message>
    <message>
        <source>Everything takes place %1 higher than programmed. The spindle does not turn, and no coolant flows; tools are changed, and retracts in machine coordinates are made.</source>
        <translation>Tout a lieu %1 plus haut que programmé. La broche ne tourne pas et l’arrosage reste coupé&#xa0;; les outils sont changés et les dégagements en coordonnées machine sont exécutés.</translation>
    </message>
    <message>
        <source>Live source</source>
        <translation>Source en direct</translation>
    </message>
    <message>
        <source>Change …</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>%1 is open. What it sends is read from the start on.</source>
        <translation>%1 est ouverte. Ce qu’elle envoie est lu à partir du démarrage.</translation>
    </message>
    <message>
        <source>Agreed</source>
        <translation>Convenu</translation>
    </message>
    <message>
        <source>No point is outside %1. No step is longer than %2. Anything else ends the run after the last good point.</source>
        <translation>Aucun point n’est hors de %1. Aucun pas n’est plus long que %2. Tout le reste termine l’exécution après le dernier bon point.</translation>
    </message>
    <message>
        <source>The F of the points, at most %1; that is also the feed before the first F.</source>
        <translation>Le F des points, au plus %1&#xa0;; c’est aussi l’avance avant le premier F.</translation>
    </message>
    <message>
        <source>No points</source>
        <translation>Sans points</translation>
    </message>
    <message>
        <source>The machine waits at the end of the last window: %1.</source>
        <translation>La machine attend à la fin de la dernière fenêtre&#xa0;: %1.</translation>
    </message>
    <message>
        <source>From %1 in a straight line to the first point, which may be %2 away.</source>
        <translation>De %1 en ligne droite vers le premier point, qui peut être à %2.</translation>
    </message>
    <message>
        <source>The tool is so far outside the box that no first point can be in it. Move the tool, or change the box.</source>
        <translation>L’outil est si loin du pavé qu’aucun premier point ne peut s’y trouver. Déplacer l’outil ou modifier le pavé.</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Lu comme</translation>
    </message>
    <message>
        <source>a program for %1</source>
        <translation>un programme pour %1</translation>
    </message>
    <message>
        <source>mm, because this machine is metric; the program does not say (%1)</source>
        <translation>mm, car cette machine est métrique&#x202f;; le programme ne le dit pas (%1)</translation>
    </message>
    <message>
        <source>inch where the program does not say it, as chosen</source>
        <translation>pouces là où le programme ne le dit pas, comme choisi</translation>
    </message>
    <message>
        <source>mm where the program does not say it, as chosen</source>
        <translation>mm là où le programme ne le dit pas, comme choisi</translation>
    </message>
    <message>
        <source>whole units where a number has no decimal point (%1)</source>
        <translation>unités entières là où un nombre n’a pas de point décimal (%1)</translation>
    </message>
    <message>
        <source>thousandths where a number has no decimal point, as chosen</source>
        <translation>millièmes là où un nombre n’a pas de point décimal, comme choisi</translation>
    </message>
    <message>
        <source>whole units where a number has no decimal point, as chosen</source>
        <translation>unités entières là où un nombre n’a pas de point décimal, comme choisi</translation>
    </message>
    <message>
        <source>%1: the control executes %2</source>
        <translation>%1&#xa0;: la commande exécute %2</translation>
    </message>
    <message>
        <source>%1: left out, because nobody has said what this machine does for it (Configure, Limits)</source>
        <translation>%1&#xa0;: omise, car personne n’a dit ce que cette machine fait pour elle (Configurer, Limites)</translation>
    </message>
    <message>
        <source>%1: left out</source>
        <translation>%1&#xa0;: omise</translation>
    </message>
    <message>
        <source>without %1, which does not change the path, as confirmed</source>
        <translation>sans %1, qui ne change pas la trajectoire, comme confirmé</translation>
    </message>
    <message>
        <source>what it leaves out as a virtual machine is set (%1)</source>
        <translation>ce qu’il omet selon les réglages d’une machine virtuelle (%1)</translation>
    </message>
    <message>
        <source>what it leaves out as chosen (%1)</source>
        <translation>ce qu’il omet selon le choix (%1)</translation>
    </message>
    <message>
        <source>M functions and axes of another machine</source>
        <translation>Fonctions M et axes d’une autre machine</translation>
    </message>
    <message numerus="yes">
        <source>%1 (line %2, %Ln times)</source>
        <translation>
            <numerusform>%1 (ligne %2, une fois)</numerusform>
            <numerusform>%1 (ligne %2, %Ln fois)</numerusform>
        </translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>The axes stand at once, on the path. How long they brake is not known.</source>
        <translation>Les axes s’arrêtent aussitôt, sur la trajectoire. On ne sait pas combien de temps ils freinent.</translation>
    </message>
    <message>
        <source>The axes stand on the path within %1; threads and tapping at their end.</source>
        <translation>Les axes s’arrêtent sur la trajectoire en %1 au plus&#xa0;; filetages et taraudages à leur fin.</translation>
    </message>
    <message>
        <source>Every block is within the travel of the axes and the speed of the spindle. Tools are not compared: this machine has no tool table here.</source>
        <translation>Chaque bloc est dans la course des axes et la vitesse de la broche. Les outils ne sont pas comparés : cette machine n’a pas de table d’outils ici.</translation>
    </message>
    <message>
        <source>The program uses tool %1; there is none in the spindle.</source>
        <translation>Le programme utilise l’outil %1 ; il n’y en a pas dans la broche.</translation>
    </message>
    <message>
        <source>The program uses tool %1; %2 is in the spindle.</source>
        <translation>Le programme utilise l’outil %1 ; %2 est dans la broche.</translation>
    </message>
    <message>
        <source>The program works in %1; %2 is active.</source>
        <translation>Le programme travaille en %1 ; %2 est actif.</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>est arrêtée</translation>
    </message>
    <message>
        <source>turns at %1 1/min, %2</source>
        <translation>tourne à %1 tr/min, %2</translation>
    </message>
    <message>
        <source>clockwise (M3)</source>
        <translation>sens horaire (M3)</translation>
    </message>
    <message>
        <source>counterclockwise (M4)</source>
        <translation>sens antihoraire (M4)</translation>
    </message>
    <message>
        <source>In the program the spindle %1; now it %2.</source>
        <translation>Dans le programme, la broche %1 ; maintenant elle %2.</translation>
    </message>
    <message>
        <source>Confirmed: it starts like this.</source>
        <translation>Confirmé : le départ se fait ainsi.</translation>
    </message>
    <message>
        <source>Start like this</source>
        <translation>Démarrer ainsi</translation>
    </message>
    <message>
        <source>Then in a straight line over %1 to %2.</source>
        <translation>Ensuite en ligne droite sur %1 jusqu’à %2.</translation>
    </message>
    <message>
        <source>This way passes within what the program cuts, which reaches up to Z %1.</source>
        <translation>Ce trajet traverse la zone que le programme usine, qui monte jusqu&apos;à Z %1.</translation>
    </message>
    <message>
        <source>Raise the tool …</source>
        <translation>Relever l&apos;outil …</translation>
    </message>
    <message>
        <source>Bring the tool to a place from which it is clear.</source>
        <translation>Amenez l&apos;outil à un endroit d&apos;où il est libre.</translation>
    </message>
    <message>
        <source>Straight way</source>
        <translation>Trajet direct</translation>
    </message>
    <message>
        <source>Confirmed: nothing is in the way of the first move.</source>
        <translation>Confirmé : rien ne gêne le premier déplacement.</translation>
    </message>
    <message>
        <source>If nothing is in the way of the first move, confirm it.</source>
        <translation>Si rien ne gêne le premier déplacement, confirmez-le.</translation>
    </message>
    <message>
        <source>It is clear …</source>
        <translation>Il est libre …</translation>
    </message>
    <message>
        <source>Raise the tool</source>
        <translation>Relever l&apos;outil</translation>
    </message>
    <message>
        <source>The tool goes straight up by %1 to Z %2, at %3. Nothing else moves. Then this page comes again.</source>
        <translation>L&apos;outil monte tout droit de %1 jusqu&apos;à Z %2, à %3. Rien d&apos;autre ne bouge. Ensuite cette page revient.</translation>
    </message>
    <message>
        <source>After Stop the control still executes its window, of at most %1 moves within the agreed box, and of at most %2: longer moves are divided.</source>
        <translation>Après Arrêt, la commande exécute encore sa fenêtre&#xa0;: au plus %1 déplacements dans la boîte convenue, qui durent ensemble au plus %2. Les déplacements plus longs sont divisés.</translation>
    </message>
    <message>
        <source>After Stop the control still executes its window, at most %1 in %2.</source>
        <translation>Après Arrêt, la commande exécute encore sa fenêtre, au plus %1 en %2.</translation>
    </message>
    <message>
        <source>The move of line %1 alone takes %2; it is not divided.</source>
        <translation>Le déplacement de la ligne %1 dure à lui seul %2&#xa0;; il n’est pas divisé.</translation>
    </message>
    <message>
        <source>Method %1 may execute old points again: if this computer is late for a moment, the tool goes back through the workpiece, and nothing stops it before it has moved. Method window does not.</source>
        <translation>La méthode %1 peut exécuter à nouveau d’anciens points&#xa0;: si cet ordinateur est en retard un instant, l’outil revient à travers la pièce, et rien ne l’arrête avant qu’il ait bougé. La méthode Fenêtre ne le fait pas.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Confirmed.</source>
        <translation>Confirmé.</translation>
    </message>
    <message>
        <source>Accept it …</source>
        <translation>L’accepter …</translation>
    </message>
    <message>
        <source>Since it was measured how fast this control can be written to, its software has changed: %1 for each R-parameter are assumed.</source>
        <translation>Depuis que la vitesse d’écriture de cette commande a été mesurée, son logiciel a changé&#xa0;: %1 par paramètre R sont supposées.</translation>
    </message>
    <message>
        <source>It has not been measured how fast this control can be written to: %1 for each R-parameter are assumed.</source>
        <translation>La vitesse d’écriture de cette commande n’a pas été mesurée&#xa0;: %1 par paramètre R sont supposées.</translation>
    </message>
    <message>
        <source>Measure …</source>
        <translation>Mesurer …</translation>
    </message>
    <message>
        <source>Back along the path</source>
        <translation>Retour sur la trajectoire</translation>
    </message>
    <message>
        <source>The tool goes back by %1 along the path that it has cut, at %2, to %3. Then this page comes again, and the run goes on from there.</source>
        <translation>L’outil revient de %1 sur la trajectoire qu’il a usinée, à %2, jusqu’à %3. Ensuite cette page revient et l’exécution continue de là.</translation>
    </message>
    <message>
        <source>Drive back …</source>
        <translation>Revenir …</translation>
    </message>
    <message>
        <source>The first move, to line %1, alone takes %2: bring the tool nearer before the start.</source>
        <translation>Le premier déplacement, vers la ligne %1, dure à lui seul %2&#xa0;: approchez l’outil avant le départ.</translation>
    </message>
    <message>
        <source>%1 multiplies your override: %2 to %3, and no more than 120 % in all.</source>
        <translation>%1 multiplie votre override&#xa0;: de %2 à %3, et au plus 120&#xa0;% en tout.</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Avance adaptative</translation>
    </message>
    <message>
        <source>Without a factor for %1 the axes are held; nothing moves before the first.</source>
        <translation>Sans facteur pendant %1, les axes sont retenus&#xa0;; rien ne bouge avant le premier.</translation>
    </message>
    <message>
        <source>Without a factor for %1 your override acts alone.</source>
        <translation>Sans facteur pendant %1, votre override agit seul.</translation>
    </message>
    <message>
        <source>With this method, after Stop the control still executes its loop, at most %1 in %2.</source>
        <translation>Avec cette méthode, après Arrêt, la commande exécute encore sa boucle, au plus %1 en %2.</translation>
    </message>
    <message>
        <source>Within the tolerance %1 of %2 points are left, at most %3 off the program.</source>
        <translation>Dans la tolérance, il reste %1 points sur %2, à %3 au plus du programme.</translation>
    </message>
    <message>
        <source>All points are streamed: a whole job has no tolerance.</source>
        <translation>Tous les points sont transmis : un travail complet n’a pas de tolérance.</translation>
    </message>
    <message>
        <source>All points are streamed: fewer cannot be kept within the tolerance.</source>
        <translation>Tous les points sont transmis : avec moins, la tolérance ne peut pas être tenue.</translation>
    </message>
    <message>
        <source>The path is being measured.</source>
        <translation>La trajectoire est en cours de mesure.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::RunController</name>
    <message>
        <source>Stop requested.</source>
        <translation>Arrêt demandé.</translation>
    </message>
    <message>
        <source>Continue requested.</source>
        <translation>Suite demandée.</translation>
    </message>
    <message>
        <source>Calibration on R%1 to R%2 started.</source>
        <translation>Étalonnage sur R%1 à R%2 démarré.</translation>
    </message>
    <message>
        <source>The run was left before point %1 of %2.</source>
        <translation>L’exécution s’est interrompue avant le point %1 sur %2.</translation>
    </message>
    <message>
        <source>Press Resume first: it asks the control where the run was left.</source>
        <translation>Appuyer d’abord sur Reprendre&#xa0;: la commande dira où l’exécution s’est interrompue.</translation>
    </message>
    <message>
        <source>The run resumes at point %1.</source>
        <translation>L’exécution reprend au point %1.</translation>
    </message>
    <message>
        <source>Start. The tool first moves %1 in a straight line to the first point.</source>
        <translation>Démarrage. L’outil parcourt d’abord %1 en ligne droite jusqu’au premier point.</translation>
    </message>
    <message>
        <source>Save the template on its page as %1, copy it to the part programs of the control, select it in channel 1 and press cycle start. The axes move only after the template has shown its layout number %2.</source>
        <translation>Enregistrer le modèle depuis sa page sous le nom %1, le copier dans les programmes pièce de la commande, le sélectionner dans le canal 1 et actionner Départ cycle. Les axes ne bougent qu’après que le modèle a affiché son numéro de disposition %2.</translation>
    </message>
    <message>
        <source>Access: %1.</source>
        <translation>Accès&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Run ended: %1 of %2 points executed.</source>
        <translation>Exécution terminée&#xa0;: %1 points sur %2 exécutés.</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Enregistrement&#xa0;: %1</translation>
    </message>
    <message>
        <source>The run has executed wrong points: see the report, and check the workpiece.</source>
        <translation>L’exécution a fait des points erronés&#xa0;: voir le rapport et contrôler la pièce.</translation>
    </message>
    <message>
        <source>The run is not in the history: %1</source>
        <translation>L’exécution n’est pas dans l’historique&#xa0;: %1</translation>
    </message>
    <message>
        <source>Wrong motion: after point %1 the tool is %2 off the path.</source>
        <translation>Mouvement erroné&#xa0;: après le point %1, l’outil est à %2 de la trajectoire.</translation>
    </message>
    <message>
        <source>Wrong motion: the control has repeated points after point %1.</source>
        <translation>Mouvement erroné&#xa0;: la commande a répété des points après le point %1.</translation>
    </message>
    <message>
        <source>The program waits for cycle start at the control (line %1).</source>
        <translation>Le programme attend le Départ cycle sur la commande (ligne %1).</translation>
    </message>
    <message numerus="yes">
        <source>Start of a whole job: %1, %Ln blocks for the control.</source>
        <translation>
            <numerusform>Démarrage d’une tâche complète&#xa0;: %1, %Ln bloc pour la commande.</numerusform>
            <numerusform>Démarrage d’une tâche complète&#xa0;: %1, %Ln blocs pour la commande.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln tronçon</numerusform>
            <numerusform>%Ln tronçons</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 and those after it move nothing. Choose an earlier line.</source>
        <translation>La ligne %1 et les suivantes ne déplacent rien. Choisir une ligne antérieure.</translation>
    </message>
    <message>
        <source>The run starts at point %1.</source>
        <translation>L’exécution commence au point %1.</translation>
    </message>
    <message>
        <source>A whole job begins at its beginning, or with a part: press Start, then Begin with a part. To begin at this line, choose Motion only in the settings, and set tool, spindle and coolant yourself.</source>
        <translation>Une tâche complète commence à son début ou à un tronçon&#xa0;: appuyer sur Départ, puis sur Commencer à un tronçon. Pour commencer à cette ligne, choisir Mouvement seul dans les paramètres et régler soi-même outil, broche et arrosage.</translation>
    </message>
    <message numerus="yes">
        <source>The job goes on at line %1, after %Ln blocks of the control.</source>
        <translation>
            <numerusform>La tâche reprend à la ligne %1, après %Ln bloc de la commande.</numerusform>
            <numerusform>La tâche reprend à la ligne %1, après %Ln blocs de la commande.</numerusform>
        </translation>
    </message>
    <message>
        <source>The tools and offsets of this machine are not known, so the state in which the job goes on cannot be computed. Start from the beginning.</source>
        <translation>Les outils et décalages de cette machine ne sont pas connus&#xa0;: l’état dans lequel la tâche reprend ne peut pas être calculé. Recommencer depuis le début.</translation>
    </message>
    <message>
        <source>The state before this part is not known: only the control knows what an earlier block does. Choose an earlier part, or start from the beginning.</source>
        <translation>L’état avant ce tronçon n’est pas connu&#xa0;: seule la commande sait ce que fait un bloc précédent. Choisir un tronçon antérieur ou recommencer depuis le début.</translation>
    </message>
    <message>
        <source>It is not known for certain where the job was left. Press Start, then Begin with a part, or start from the beginning.</source>
        <translation>On ne sait pas avec certitude où la tâche a été interrompue. Appuyer sur Départ, puis sur Commencer à un tronçon, ou recommencer depuis le début.</translation>
    </message>
    <message>
        <source>Start. The points come from %1.</source>
        <translation>Démarrage. Les points viennent de %1.</translation>
    </message>
    <message>
        <source>Rivulet cannot stop what the control executes now. Press NC STOP at the machine.</source>
        <translation>Rivulet ne peut pas arrêter ce que la commande exécute maintenant. Appuyer sur NC STOP à la machine.</translation>
    </message>
    <message>
        <source>Stop: the axes are held on the path.</source>
        <translation>Arrêt : les axes sont retenus sur la trajectoire.</translation>
    </message>
    <message>
        <source>Pause requested.</source>
        <translation>Pause demandée.</translation>
    </message>
    <message>
        <source>The tool is raised to Z %1.</source>
        <translation>L&apos;outil est relevé à Z %1.</translation>
    </message>
    <message>
        <source>The state before the first part is not known: only the control knows what an earlier block does. Start from the beginning.</source>
        <translation>L’état avant le premier tronçon n’est pas connu&#xa0;: seule la commande sait ce que fait un bloc précédent. Recommencer depuis le début.</translation>
    </message>
    <message>
        <source>The test of the control is aborted. If an axis still moves, press NC STOP at the machine.</source>
        <translation>Le test de la commande est interrompu. Si un axe se déplace encore, appuyez sur NC STOP à la machine.</translation>
    </message>
    <message>
        <source>The control was reset: its program has ended after %1.</source>
        <translation>La commande a été réinitialisée : son programme s’est terminé après %1.</translation>
    </message>
    <message>
        <source>A reset of the control was requested. If an axis still moves, press NC STOP at the machine.</source>
        <translation>Un reset de la commande a été demandé. Si un axe se déplace encore, appuyez sur NC STOP à la machine.</translation>
    </message>
    <message>
        <source>The file of the run is gone: the run could not go on after the way back.</source>
        <translation>Le fichier de l’exécution a disparu&#xa0;: après le retour, elle ne pourrait pas continuer.</translation>
    </message>
    <message>
        <source>The tool is driven back by %1 along the path.</source>
        <translation>L’outil revient de %1 sur la trajectoire.</translation>
    </message>
    <message>
        <source>The tool is to be lifted by %1.</source>
        <translation>L’outil doit être relevé de %1.</translation>
    </message>
    <message>
        <source>The tool is to be lowered.</source>
        <translation>L’outil doit être redescendu.</translation>
    </message>
    <message>
        <source>Line %1: &quot;%2&quot; has not been tried on this machine. Test it on the page Job test, or run the motion only.</source>
        <translation>Ligne %1 : « %2 » n’a pas été essayé sur cette machine. L’essayer à la page Test tâche, ou n’exécuter que le mouvement.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::VirtualMachine</name>
    <message>
        <source>The virtual machine cannot be started: %1</source>
        <translation>La machine virtuelle ne peut pas être démarrée : %1</translation>
    </message>
    <message>
        <source>The virtual machine has ended.</source>
        <translation>La machine virtuelle s&apos;est arrêtée.</translation>
    </message>
    <message>
        <source>The program rivulet-machine is missing. Install it beside this window.</source>
        <translation>Le programme rivulet-machine manque. Installez-le à côté de cette fenêtre.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AdvicePanel</name>
    <message>
        <source>F %1 instead of %2: still without wrong points</source>
        <translation>F %1 au lieu de %2&#xa0;: toujours sans point erroné</translation>
    </message>
    <message>
        <source>F %1 instead of %2: without waiting</source>
        <translation>F %1 au lieu de %2&#xa0;: sans attente</translation>
    </message>
    <message>
        <source>F %1 instead of %2: feasible</source>
        <translation>F %1 au lieu de %2&#xa0;: réalisable</translation>
    </message>
    <message>
        <source>N %1 instead of %2: largest feed %3</source>
        <translation>N %1 au lieu de %2&#xa0;: avance maximale %3</translation>
    </message>
    <message>
        <source>δ %1 instead of %2: largest feed %3</source>
        <translation>δ %1 au lieu de %2&#xa0;: avance maximale %3</translation>
    </message>
    <message>
        <source>Method %1 instead of %2: largest feed %3</source>
        <translation>Méthode %1 au lieu de %2&#xa0;: avance maximale %3</translation>
    </message>
    <message>
        <source>Judging …</source>
        <translation>Évaluation…</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>Aucun verdict</translation>
    </message>
    <message>
        <source>Not feasible: largest feed %1</source>
        <translation>Non réalisable&#xa0;: avance maximale %1</translation>
    </message>
    <message>
        <source>Safe, with waiting above %1</source>
        <translation>Sûr, avec des attentes au-delà de %1</translation>
    </message>
    <message>
        <source>By the equations feasible up to %1</source>
        <translation>Selon les équations, réalisable jusqu’à %1</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Looking for better settings …</source>
        <translation>Recherche de meilleurs réglages…</translation>
    </message>
    <message>
        <source>No single change makes this program much faster.</source>
        <translation>Aucun changement seul ne rend ce programme beaucoup plus rapide.</translation>
    </message>
    <message>
        <source>Each was simulated with this program and made no wrong point.</source>
        <translation>Chacun a été simulé avec ce programme, sans point erroné.</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Conseils</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Essayer</translation>
    </message>
    <message>
        <source>Points per loop N</source>
        <translation>Points par boucle N</translation>
    </message>
    <message>
        <source>Distance δ</source>
        <translation>Distance δ</translation>
    </message>
    <message>
        <source>Feed F</source>
        <translation>Avance F</translation>
    </message>
    <message>
        <source>Override %1 instead of %2: still without wrong points</source>
        <translation>Override %1 au lieu de %2&#xa0;: encore sans point faux</translation>
    </message>
    <message>
        <source>Override %1 instead of %2: without waiting</source>
        <translation>Override %1 au lieu de %2&#xa0;: sans attente</translation>
    </message>
    <message>
        <source>N %1 instead of %2: largest override %3</source>
        <translation>N %1 au lieu de %2&#xa0;: override maximal %3</translation>
    </message>
    <message>
        <source>Safe, with waiting above an override of %1</source>
        <translation>Sûr, avec attente au-delà d’un override de %1</translation>
    </message>
    <message>
        <source>By the equations without waiting up to %1</source>
        <translation>Selon les équations, sans attente jusqu’à %1</translation>
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
        <translation>Heure</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Par</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmLine</name>
    <message>
        <source>Ack</source>
        <translation>Acq.</translation>
    </message>
    <message>
        <source>Acknowledge: you have seen this alarm</source>
        <translation>Acquitter&#xa0;: vous avez vu cette alarme</translation>
    </message>
    <message>
        <source>Acknowledge the alarm</source>
        <translation>Acquitter l’alarme</translation>
    </message>
    <message>
        <source>Show all alarms</source>
        <translation>Afficher toutes les alarmes</translation>
    </message>
    <message>
        <source>Dismiss the message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Alarms: %1. Show all</source>
        <translation>Alarmes&#xa0;: %1. Tout afficher</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmModel</name>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Nombre</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmPage</name>
    <message>
        <source>There is no alarm.</source>
        <translation>Il n’y a pas d’alarme.</translation>
    </message>
    <message>
        <source>shelved by %1 until %2</source>
        <translation>mise de côté par %1 jusqu’à %2</translation>
    </message>
    <message>
        <source>Alarms (%1)</source>
        <translation>Alarmes (%1)</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Cause</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Remède</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Acquitter</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Tout acquitter</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>Mettre de côté</translation>
    </message>
    <message>
        <source>Put the alarm aside for a time. It stays in this list.</source>
        <translation>Mettre l’alarme de côté pour un temps. Elle reste dans cette liste.</translation>
    </message>
    <message>
        <source>Show it again</source>
        <translation>Réafficher</translation>
    </message>
    <message numerus="yes">
        <source>For %n minutes</source>
        <translation>
            <numerusform>Pendant %n minute</numerusform>
            <numerusform>Pendant %n minutes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n hours</source>
        <translation>
            <numerusform>Pendant %n heure</numerusform>
            <numerusform>Pendant %n heures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AuditModel</name>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Qui</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AuditPage</name>
    <message>
        <source>Export the audit trail</source>
        <translation>Exporter le journal d’audit</translation>
    </message>
    <message>
        <source>No audit trail is kept.</source>
        <translation>Aucun journal d’audit n’est tenu.</translation>
    </message>
    <message>
        <source>The audit trail was changed: line %1 was edited, or lines before it were inserted or removed.</source>
        <translation>Le journal d’audit a été modifié&#xa0;: la ligne %1 a été changée, ou des lignes ont été insérées ou supprimées avant elle.</translation>
    </message>
    <message>
        <source>Unchanged: every line follows from the one before it.</source>
        <translation>Intact&#xa0;: chaque ligne découle de la précédente.</translation>
    </message>
    <message>
        <source>Cut by a loss of power: %1.</source>
        <translation>Coupé par une panne de courant&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Last hash: %1 …</source>
        <translation>Dernière empreinte&#xa0;: %1…</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Export as CSV…</source>
        <translation>Exporter en CSV…</translation>
    </message>
    <message>
        <source>Export as JSON…</source>
        <translation>Exporter en JSON…</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Audit</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::BackDialog</name>
    <message>
        <source>To where the last rapid ended</source>
        <translation>Jusqu’à la fin du dernier rapide</translation>
    </message>
    <message>
        <source>Back along the path</source>
        <translation>Retour sur la trajectoire</translation>
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
        <translation>Montrer le chemin</translation>
    </message>
    <message>
        <source>Length of the way</source>
        <translation>Longueur du chemin</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Pas maintenant</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::BoardCard</name>
    <message>
        <source>Remove …</source>
        <translation>Retirer…</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CalibrationPage</name>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>Shots of each kind</source>
        <translation>Mesures de chaque type</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sans limite</translation>
    </message>
    <message>
        <source>No program, cycle or other client uses R%1 to R%2: they may be written</source>
        <translation>Aucun programme, cycle ou autre client n’utilise R%1 à R%2&#xa0;: on peut y écrire</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Étalonner</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Droites</translation>
    </message>
    <message>
        <source>Spread (times in ms)</source>
        <translation>Dispersion (temps en ms)</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>encore %1</translation>
    </message>
    <message>
        <source>Testing the forms of access …</source>
        <translation>Test des formes d’accès…</translation>
    </message>
    <message>
        <source>First request of each kind …</source>
        <translation>Première requête de chaque type…</translation>
    </message>
    <message>
        <source>%1 of %2 shots, %3</source>
        <translation>%1 mesures sur %2, %3</translation>
    </message>
    <message>
        <source>Takes about %1.</source>
        <translation>Dure environ %1.</translation>
    </message>
    <message>
        <source>%1, %2, R%3 to R%4, took %5</source>
        <translation>%1, %2, R%3 à R%4, durée %5</translation>
    </message>
    <message>
        <source>Outdated, not used: the server now has another version. %1</source>
        <translation>Périmé, non utilisé&#xa0;: le serveur a maintenant une autre version. %1</translation>
    </message>
    <message>
        <source>Calibrated: %1.</source>
        <translation>Étalonné&#xa0;: %1.</translation>
    </message>
    <message>
        <source>There was not enough time for all shots: reduced numbers are bold in the table.</source>
        <translation>Le temps n’a pas suffi pour toutes les mesures&#xa0;: les nombres réduits sont en gras dans le tableau.</translation>
    </message>
    <message>
        <source>Restoring the R-parameters …</source>
        <translation>Rétablissement des paramètres R …</translation>
    </message>
    <message>
        <source>The last R-parameter is before the first.</source>
        <translation>Le dernier paramètre R est avant le premier.</translation>
    </message>
    <message>
        <source>Confirm the R-parameters to begin.</source>
        <translation>Confirmer les paramètres R pour commencer.</translation>
    </message>
    <message>
        <source>This machine is not calibrated: %1 for each R-parameter are assumed.</source>
        <translation>Cette machine n’est pas étalonnée : %1 par paramètre R sont supposés.</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Paramètres R</translation>
    </message>
    <message>
        <source>Arrays too: for the test, they hold other values for a moment</source>
        <translation>Aussi les tableaux : pour le test, ils ont un instant d’autres valeurs</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CellModel</name>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Paramètres R</translation>
    </message>
    <message>
        <source>Point %1: %2</source>
        <translation>Point %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Client</translation>
    </message>
    <message>
        <source>NC</source>
        <translation>CN</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marche</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Layout number</source>
        <translation>Numéro de disposition</translation>
    </message>
    <message>
        <source>Writer</source>
        <translation>Écrit par</translation>
    </message>
    <message>
        <source>Client, NC</source>
        <translation>Client, CN</translation>
    </message>
    <message>
        <source>Feed (mm/min)</source>
        <translation>Avance (mm/min)</translation>
    </message>
    <message>
        <source>Window %1: points</source>
        <translation>Fenêtre %1&#xa0;: points</translation>
    </message>
    <message>
        <source>Window %1: feed (mm/min)</source>
        <translation>Fenêtre %1&#xa0;: avance (mm/min)</translation>
    </message>
    <message>
        <source>Window %1: check number</source>
        <translation>Fenêtre %1&#xa0;: numéro de contrôle</translation>
    </message>
    <message>
        <source>Window %1 point %2: %3</source>
        <translation>Fenêtre %1 point %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Windows delivered</source>
        <translation>Fenêtres livrées</translation>
    </message>
    <message>
        <source>Windows taken</source>
        <translation>Fenêtres prises</translation>
    </message>
    <message>
        <source>Windows executed</source>
        <translation>Fenêtres exécutées</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Number of the run</source>
        <translation>Numéro de l’exécution</translation>
    </message>
    <message>
        <source>Run obeyed</source>
        <translation>Exécution suivie</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Signe de vie</translation>
    </message>
    <message>
        <source>Online correction: %1</source>
        <translation>Correction en ligne&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CertificatesPage</name>
    <message>
        <source>Save this computer&apos;s certificate</source>
        <translation>Enregistrer le certificat de cet ordinateur</translation>
    </message>
    <message>
        <source>A certificate is being made …</source>
        <translation>Un certificat est en cours de création…</translation>
    </message>
    <message>
        <source>There is none yet. It is made when it is first needed.</source>
        <translation>Il n’y en a pas encore. Il est créé dès qu’il est nécessaire.</translation>
    </message>
    <message>
        <source>It has ended (%1). Renew it.</source>
        <translation>Il a expiré (%1). Le renouveler.</translation>
    </message>
    <message numerus="yes">
        <source>Valid for %Ln more days (%1)</source>
        <translation>
            <numerusform>Valable encore %Ln jour (%1)</numerusform>
            <numerusform>Valable encore %Ln jours (%1)</numerusform>
        </translation>
    </message>
    <message>
        <source>Encryption by %1</source>
        <translation>Chiffrement par %1</translation>
    </message>
    <message>
        <source>Certificate of this computer</source>
        <translation>Certificat de cet ordinateur</translation>
    </message>
    <message>
        <source>Fingerprint (SHA-256)</source>
        <translation>Empreinte (SHA-256)</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Writes the certificate, without its key, for the control&apos;s list of trusted clients.</source>
        <translation>Écrit le certificat, sans sa clé, pour la liste des clients de confiance de la commande.</translation>
    </message>
    <message>
        <source>Hold: renew</source>
        <translation>Maintenir&#xa0;: renouveler</translation>
    </message>
    <message>
        <source>Makes a new one. Every control has to trust it anew.</source>
        <translation>En crée un nouveau. Chaque commande doit de nouveau lui faire confiance.</translation>
    </message>
    <message>
        <source>Machines that are known</source>
        <translation>Machines connues</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
    <message>
        <source>At the next connection the machine is new.</source>
        <translation>À la prochaine connexion, la machine est nouvelle.</translation>
    </message>
    <message>
        <source>Protect again</source>
        <translation>Protéger de nouveau</translation>
    </message>
    <message>
        <source>Withdraws what was allowed for this machine: from then on, the strongest encryption or no connection.</source>
        <translation>Retire ce qui a été autorisé nommément&#xa0;: le chiffrement le plus fort ou aucune connexion.</translation>
    </message>
    <message>
        <source>Certificates that were refused</source>
        <translation>Certificats refusés</translation>
    </message>
    <message>
        <source>Hold: accept</source>
        <translation>Maintenir&#xa0;: accepter</translation>
    </message>
    <message>
        <source>From then on it is trusted at its address, in place of any other one.</source>
        <translation>Dès lors, il est de confiance à son adresse, à la place de tout autre.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Removes it from the list. It stays refused.</source>
        <translation>Le supprime de la liste. Il reste refusé.</translation>
    </message>
    <message>
        <source>Only the very certificates that were accepted are trusted, not who issued them. So revocation lists are not needed: forget the machine instead.</source>
        <translation>Seuls les certificats acceptés sont de confiance, pas ceux qui les délivrent. Les listes de révocation sont donc inutiles&#xa0;: oublier la machine à la place.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CloseBar</name>
    <message>
        <source>Keep the window open</source>
        <translation>Garder la fenêtre ouverte</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Arrêter et fermer</translation>
    </message>
    <message>
        <source>A run is in progress. To close the window, its axes are held first, where they are; the run can be resumed from there.</source>
        <translation>Une exécution est en cours. Pour fermer la fenêtre, ses axes sont d’abord immobilisés là où ils sont&#xa0;; l’exécution pourra être reprise de là.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ColumnsDialog</name>
    <message>
        <source>The trace can be analysed.</source>
        <translation>La trace peut être analysée.</translation>
    </message>
    <message>
        <source>Without a position the columns are shown, but stops and errors are not looked for.</source>
        <translation>Sans position, les colonnes sont affichées, mais ni les arrêts ni les erreurs ne sont recherchés.</translation>
    </message>
    <message>
        <source>Unit of the numbers in the file</source>
        <translation>Unité des nombres du fichier</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Unité de %1</translation>
    </message>
    <message>
        <source>What this column is; without a meaning it is shown as it is</source>
        <translation>Ce qu’est cette colonne&#xa0;; sans sens, elle est affichée telle quelle</translation>
    </message>
    <message>
        <source>Meaning of %1</source>
        <translation>Sens de %1</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Place of the first sample on the time axis that several files share</source>
        <translation>Place du premier échantillon sur l’axe de temps commun à plusieurs fichiers</translation>
    </message>
    <message>
        <source>First sample at</source>
        <translation>Premier échantillon à</translation>
    </message>
    <message>
        <source>For a table without a column of time</source>
        <translation>Pour un tableau sans colonne de temps</translation>
    </message>
    <message>
        <source>First values</source>
        <translation>Premières valeurs</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Means</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonne</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Colonnes du fichier</translation>
    </message>
    <message>
        <source>What do the columns mean? The answer is kept for all files with the same headings.</source>
        <translation>Que signifient les colonnes ? La réponse est conservée pour tous les fichiers qui ont les mêmes en-têtes.</translation>
    </message>
    <message>
        <source>Columns of %1</source>
        <translation>Colonnes de %1</translation>
    </message>
    <message>
        <source>Samples per second</source>
        <translation>Échantillons par seconde</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CommissioningPage</name>
    <message>
        <source>First R-parameter</source>
        <translation>Premier paramètre R</translation>
    </message>
    <message>
        <source>First R-parameter of the test</source>
        <translation>Premier paramètre R du test</translation>
    </message>
    <message>
        <source>Nobody else uses R%1 to R%2</source>
        <translation>Personne d’autre n’utilise R%1 à R%2</translation>
    </message>
    <message>
        <source>I bring the program to the control myself</source>
        <translation>Je transfère moi-même le programme sur la commande</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Lancer le test</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Test program</source>
        <translation>Programme de test</translation>
    </message>
    <message>
        <source>1. Bring the channel to reset, in AUTO.</source>
        <translation>1. Mettre le canal en Reset, en mode AUTO.</translation>
    </message>
    <message>
        <source>2. Store the text below as part program %1 and select it.</source>
        <translation>2. Enregistrer le texte ci-dessous comme programme pièce %1 et le sélectionner.</translation>
    </message>
    <message>
        <source>2. The program %1 is transferred, read back and selected.</source>
        <translation>2. Le programme %1 est transféré, relu et sélectionné.</translation>
    </message>
    <message>
        <source>3. Press cycle start at the control (a virtual machine starts by itself).</source>
        <translation>3. Appuyer sur Départ cycle sur la commande (une machine virtuelle démarre seule).</translation>
    </message>
    <message>
        <source>Waiting for cycle start</source>
        <translation>Attend Départ cycle</translation>
    </message>
    <message>
        <source>The test is in progress</source>
        <translation>Le test est en cours</translation>
    </message>
    <message>
        <source>Tested with another version of the server: test it again</source>
        <translation>Testé avec une autre version du serveur&#xa0;: refaire le test</translation>
    </message>
    <message>
        <source>Confirm the R-parameters first.</source>
        <translation>Confirmer d’abord les paramètres R.</translation>
    </message>
    <message>
        <source>Way of the axis, mm</source>
        <translation>Course de l’axe, mm</translation>
    </message>
    <message>
        <source>Feed of the axis, mm/min</source>
        <translation>Avance de l’axe, mm/min</translation>
    </message>
    <message>
        <source>by, mm</source>
        <translation>de, mm</translation>
    </message>
    <message>
        <source>F, mm/min</source>
        <translation>F, mm/min</translation>
    </message>
    <message>
        <source>Clear the way of the axis, then type %1.</source>
        <translation>Dégagez la course de l’axe, puis tapez %1.</translation>
    </message>
    <message>
        <source>Nothing is in its way: %1</source>
        <translation>Rien n’est sur son chemin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Waiting for cycle start, once more</source>
        <translation>Attend encore une fois Départ cycle</translation>
    </message>
    <message>
        <source>%1, %2, tested %3; %4</source>
        <translation>%1, %2, testé le %3&#xa0;; %4</translation>
    </message>
    <message>
        <source>An axis moves in the air</source>
        <translation>Un axe se déplace dans l’air</translation>
    </message>
    <message>
        <source>Axis that moves</source>
        <translation>Axe qui se déplace</translation>
    </message>
    <message>
        <source>Confirm that the axis may move</source>
        <translation>Confirmer que l’axe peut se déplacer</translation>
    </message>
    <message>
        <source>Lift of the tool, mm</source>
        <translation>Relevage de l’outil, mm</translation>
    </message>
    <message>
        <source>While the axis is held, the tool is lifted along Z by so much and comes back; 0: it is not lifted. A run may lift the tool only after that. Not with Z as the axis.</source>
        <translation>Pendant que l’axe est retenu, l’outil est relevé d’autant selon Z et revient&#xa0;; 0&#xa0;: il n’est pas relevé. Une exécution ne peut relever l’outil qu’après cela. Pas avec Z comme axe.</translation>
    </message>
    <message>
        <source>lift, mm</source>
        <translation>relevage, mm</translation>
    </message>
    <message>
        <source>One block a line, as a program has it: S500 M3, M8, T1 M6</source>
        <translation>Un bloc par ligne, comme dans un programme : S500 M3, M8, T1 M6</translation>
    </message>
    <message>
        <source>Blocks to be tried</source>
        <translation>Blocs à essayer</translation>
    </message>
    <message>
        <source>2. The programs of the job are transferred, read back and selected.</source>
        <translation>2. Les programmes de la tâche sont transférés, relus et sélectionnés.</translation>
    </message>
    <message>
        <source>the control shows nothing of it; not released</source>
        <translation>la commande n’en montre rien ; non libéré</translation>
    </message>
    <message>
        <source>seen by the operator</source>
        <translation>vu par l’opérateur</translation>
    </message>
    <message>
        <source>I have seen it</source>
        <translation>Je l’ai vu</translation>
    </message>
    <message>
        <source>Blocks to be tried, one a line: S500 M3</source>
        <translation>Blocs à essayer, un par ligne : S500 M3</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ComparePanel</name>
    <message>
        <source>Open two traces or more to compare them.</source>
        <translation>Ouvrir deux tracés ou plus pour les comparer.</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>Comparaison …</translation>
    </message>
    <message>
        <source>Each run has the length that it moved itself. With their NC program open, the runs are compared at the same places of the program.</source>
        <translation>Chaque exécution a la longueur qu’elle a parcourue elle-même. Avec le programme CN ouvert, les exécutions sont comparées aux mêmes endroits du programme.</translation>
    </message>
    <message>
        <source>Differences from %1</source>
        <translation>Écarts par rapport à %1</translation>
    </message>
    <message>
        <source>%1
%2 minus %3: largest %4 at %5, mean %6, RMS %7</source>
        <translation>%1
%2 moins %3 : maximum %4 à %5, moyenne %6, valeur efficace %7</translation>
    </message>
    <message>
        <source>Compare at the same</source>
        <translation>Comparer selon</translation>
    </message>
    <message>
        <source>Axis of the comparison</source>
        <translation>Axe de la comparaison</translation>
    </message>
    <message>
        <source>time</source>
        <translation>le temps</translation>
    </message>
    <message>
        <source>length of path</source>
        <translation>la longueur du trajet</translation>
    </message>
    <message>
        <source>point of the program</source>
        <translation>le point du programme</translation>
    </message>
    <message>
        <source>Show the differences as curves</source>
        <translation>Montrer les écarts en courbes</translation>
    </message>
    <message>
        <source>Each pane shows the other traces minus the first one</source>
        <translation>Chaque zone montre ce que les autres tracés ont de plus que le premier</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Écarts</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>At</source>
        <translation>À</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Efficace</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ConnectionPanel</name>
    <message>
        <source>Connection</source>
        <translation>Connexion</translation>
    </message>
    <message>
        <source>OPC UA endpoint</source>
        <translation>Adresse OPC UA</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Canal</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Sélectionné</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnecter</translation>
    </message>
    <message>
        <source>Virtual machine: no real axis moves</source>
        <translation>Machine virtuelle&#xa0;: aucun axe réel ne bouge</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Actif</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Interrompu</translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation>Inconnu (%1)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ControlFields</name>
    <message>
        <source>Map of the control</source>
        <translation>Table de correspondance de la commande</translation>
    </message>
    <message>
        <source>Maps (*.toml)</source>
        <translation>Tables de correspondance (*.toml)</translation>
    </message>
    <message>
        <source>The control is no SINUMERIK</source>
        <translation>La commande n&apos;est pas une SINUMERIK</translation>
    </message>
    <message>
        <source>File with the map (.toml). It is remembered for this machine.</source>
        <translation>Fichier de la table de correspondance (.toml). Il est retenu pour cette machine.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Which library connects with the machine. Qt OPC UA is slower, does not encrypt, and takes no map and no user.</source>
        <translation>Bibliothèque qui établit la connexion avec la machine. Qt OPC UA est plus lent, ne chiffre pas et ne prend ni table de correspondance ni utilisateur.</translation>
    </message>
    <message>
        <source>A map says under which names this control has its memory, axes and states. rivulet-cli map proposes one.</source>
        <translation>Une table de correspondance dit sous quels noms cette commande a sa mémoire, ses axes et ses états. rivulet-cli map en propose une.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CorrectionPanel</name>
    <message>
        <source>UDP port %1 cannot be opened: choose another.</source>
        <translation>Le port UDP %1 ne peut pas être ouvert&#xa0;: en choisir un autre.</translation>
    </message>
    <message>
        <source>Up to ±%1 per axis, during a run.</source>
        <translation>Jusqu’à ±%1 par axe, pendant une exécution.</translation>
    </message>
    <message>
        <source>By hand, up to ±%1 per axis.</source>
        <translation>À la main, jusqu’à ±%1 par axe.</translation>
    </message>
    <message>
        <source>The source is silent: its last value is held.</source>
        <translation>La source est muette&#xa0;: sa dernière valeur est maintenue.</translation>
    </message>
    <message>
        <source>Nothing has been received from the source yet.</source>
        <translation>Rien n’a encore été reçu de la source.</translation>
    </message>
    <message>
        <source>Receiving from the source. Lines that are not corrections: %1</source>
        <translation>Réception de la source. Lignes qui ne sont pas des corrections&#xa0;: %1</translation>
    </message>
    <message>
        <source>Receiving from the source.</source>
        <translation>Réception de la source.</translation>
    </message>
    <message>
        <source>Online correction</source>
        <translation>Correction en ligne</translation>
    </message>
    <message>
        <source>confirmed by the control</source>
        <translation>confirmée par la commande</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Zéro</translation>
    </message>
    <message>
        <source>Set the correction of all axes to zero, then continue by hand</source>
        <translation>Mettre la correction de tous les axes à zéro, puis continuer à la main</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À la main</translation>
    </message>
    <message>
        <source>UDP on this computer</source>
        <translation>UDP sur cet ordinateur</translation>
    </message>
    <message>
        <source>Datagrams to 127.0.0.1 with lines like X 0.01 Y -0.02, in mm</source>
        <translation>Datagrammes vers 127.0.0.1 avec des lignes comme X 0.01 Y -0.02, en mm</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Silent after</source>
        <translation>Muette après</translation>
    </message>
    <message>
        <source>Correction of %1</source>
        <translation>Correction de %1</translation>
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
        <translation>Un clic sur une courbe place le curseur A, avec Maj le curseur B.</translation>
    </message>
    <message>
        <source>The trace has no such place.</source>
        <translation>Le tracé n’a pas cet endroit.</translation>
    </message>
    <message>
        <source>Type a number.</source>
        <translation>Saisir un nombre.</translation>
    </message>
    <message>
        <source>At the cursors and between them</source>
        <translation>Aux curseurs et entre eux</translation>
    </message>
    <message>
        <source>At A</source>
        <translation>En A</translation>
    </message>
    <message>
        <source>At B</source>
        <translation>En B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Slope, 1/s</source>
        <translation>Pente, 1/s</translation>
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
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>Efficace</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95&#xa0;% dessous</translation>
    </message>
    <message>
        <source>99 % below</source>
        <translation>99&#xa0;% dessous</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Échantillons</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Aller à</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Number of the place to go to</source>
        <translation>Numéro de l’endroit</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Aller</translation>
    </message>
    <message>
        <source>Slope, 1/mm</source>
        <translation>Pente, 1/mm</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Pente</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DescribedMachineBox</name>
    <message>
        <source>Described by the server</source>
        <translation>Décrit par le serveur</translation>
    </message>
    <message>
        <source>What the server says of its machine by OPC 40001-1 (Machinery) and OPC 40501-1 (Machine Tools). It is read every 10 s, and not while a run is in progress.</source>
        <translation>Ce que le serveur dit de sa machine selon OPC 40001-1 (Machinery) et OPC 40501-1 (Machine Tools). La lecture a lieu toutes les 10 s, mais pas pendant une exécution.</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Fabricant</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>%1 (first of %2)</source>
        <translation>%1 (première sur %2)</translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation>%1 exécutions sur %2</translation>
    </message>
    <message>
        <source>runs completed: %1</source>
        <translation>exécutions terminées : %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DiagnosticModel</name>
    <message>
        <source>Severity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Colonne</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Observation</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DistanceChart</name>
    <message>
        <source>%1 … %2: %3 distances</source>
        <translation>%1 … %2&#xa0;: %3 distances</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::EmulatorPage</name>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Usage</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Apprendre</translation>
    </message>
    <message>
        <source>NC program</source>
        <translation>Programme CN</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>inutile</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Samples per s</source>
        <translation>Valeurs par s</translation>
    </message>
    <message>
        <source>Largest feed</source>
        <translation>Avance maximale</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervalle</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Signification</translation>
    </message>
    <message>
        <source>Position RMS, µm</source>
        <translation>Position RMS, µm</translation>
    </message>
    <message>
        <source>at most, µm</source>
        <translation>au plus, µm</translation>
    </message>
    <message>
        <source>Contour RMS, µm</source>
        <translation>Contour RMS, µm</translation>
    </message>
    <message>
        <source>emulated, µm</source>
        <translation>émulée, µm</translation>
    </message>
    <message>
        <source>Speed, %</source>
        <translation>Vitesse,&#xa0;%</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Fichier…</translation>
    </message>
    <message>
        <source>Add recordings</source>
        <translation>Ajouter des enregistrements</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Tous les fichiers</translation>
    </message>
    <message>
        <source>NC program of %1</source>
        <translation>Programme CN de %1</translation>
    </message>
    <message>
        <source>Preset of the machine</source>
        <translation>Préréglage de la machine</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Préréglages</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Enregistrer comme préréglage</translation>
    </message>
    <message>
        <source>Use to learn</source>
        <translation>Pour apprendre</translation>
    </message>
    <message>
        <source>Use to test</source>
        <translation>Pour vérifier</translation>
    </message>
    <message>
        <source>Nothing is learned yet.</source>
        <translation>Rien n’est encore appris.</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>%1 has no set points: choose its NC program.</source>
        <translation>%1 n’a pas de consignes&#xa0;: choisir son programme CN.</translation>
    </message>
    <message>
        <source>Record a few programs with different feeds, corners and reversals, and add the recordings here.</source>
        <translation>Enregistrer quelques programmes avec divers avances, angles et inversions, et ajouter ici les enregistrements.</translation>
    </message>
    <message>
        <source>All recordings are used to test: use one to learn.</source>
        <translation>Tous les enregistrements servent à vérifier&#xa0;: en prendre un pour apprendre.</translation>
    </message>
    <message>
        <source>Learning axis %1: %2 of %3 models tried, the best is right within %4.</source>
        <translation>Apprend l’axe %1&#xa0;: %2 modèles essayés sur %3, le meilleur est juste à %4 près.</translation>
    </message>
    <message>
        <source>Learning …</source>
        <translation>Apprentissage…</translation>
    </message>
    <message>
        <source>Saved as %1. Give it to the virtual machine as its preset.</source>
        <translation>Enregistré sous %1. Le donner à la machine virtuelle comme préréglage.</translation>
    </message>
    <message>
        <source>Learned and tested. Save it as a preset to use it.</source>
        <translation>Appris et vérifié. L’enregistrer comme préréglage pour l’utiliser.</translation>
    </message>
    <message>
        <source>Ready to learn. Recordings used to test show how good the emulator is on programs it has not seen.</source>
        <translation>Prêt à apprendre. Les enregistrements pour vérifier montrent ce que vaut l’émulateur sur des programmes inconnus.</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Ajouter…</translation>
    </message>
    <message>
        <source>Add recordings of the machine</source>
        <translation>Ajouter des enregistrements de la machine</translation>
    </message>
    <message>
        <source>Learn from the recordings how the axes follow their set points</source>
        <translation>Apprendre des enregistrements comment les axes suivent leurs consignes</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stop learning; what was learned before stays</source>
        <translation>Arrêter l’apprentissage&#xa0;; ce qui a été appris auparavant reste</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Save the emulator as a preset of the virtual machine</source>
        <translation>Enregistrer l’émulateur comme préréglage de la machine virtuelle</translation>
    </message>
    <message>
        <source>NC program…</source>
        <translation>Programme CN…</translation>
    </message>
    <message>
        <source>The program that ran: needed for a recording without set points</source>
        <translation>Ce qui a tourné&#xa0;: nécessaire pour un enregistrement sans consignes</translation>
    </message>
    <message>
        <source>A recording used to test is not learned from</source>
        <translation>Un enregistrement utilisé pour vérifier ne sert pas à apprendre</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Takes the recording from the list; the file stays</source>
        <translation>Retire l’enregistrement de la liste&#xa0;; le fichier reste</translation>
    </message>
    <message>
        <source>Bode and step plots</source>
        <translation>Bode et réponse indicielle</translation>
    </message>
    <message>
        <source>For those who know control engineering</source>
        <translation>Pour qui connaît l’automatique</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>What recordings do not say</source>
        <translation>Ce que les enregistrements ne disent pas</translation>
    </message>
    <message>
        <source>Preset that has the limits of the machine; set points of programs are planned with them</source>
        <translation>Préréglage avec les limites de la machine&#xa0;; les consignes des programmes sont planifiées avec elles</translation>
    </message>
    <message>
        <source>Models tried</source>
        <translation>Modèles essayés</translation>
    </message>
    <message>
        <source>Error, µm</source>
        <translation>Erreur, µm</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Enregistrements</translation>
    </message>
    <message>
        <source>Enter changes the use of a recording</source>
        <translation>Entrée change l’usage d’un enregistrement</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Vérifications</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>Part of the page</source>
        <translation>Partie de la page</translation>
    </message>
    <message>
        <source>How far an emulator is off that was learned from one recording alone.</source>
        <translation>Écart d’un émulateur appris à partir d’un seul enregistrement.</translation>
    </message>
    <message>
        <source>Learns from each recording alone and tests on all others. So you see which recordings teach most, and what each parameter is worth.</source>
        <translation>Apprend à partir de chaque enregistrement seul et vérifie sur tous les autres. On voit ainsi quels enregistrements apprennent le plus et ce que vaut chaque paramètre.</translation>
    </message>
    <message>
        <source>How much the positions would change on each recording if a parameter were 10 % larger.</source>
        <translation>De combien les positions changeraient sur chaque enregistrement si un paramètre était 10&#xa0;% plus grand.</translation>
    </message>
    <message>
        <source>Learning from each recording alone …</source>
        <translation>Apprentissage à partir de chaque enregistrement seul…</translation>
    </message>
    <message>
        <source>Compare recordings</source>
        <translation>Comparer les enregistrements</translation>
    </message>
    <message>
        <source>Takes at most as long as learning, for each recording</source>
        <translation>Dure au plus autant que l’apprentissage, pour chaque enregistrement</translation>
    </message>
    <message>
        <source>Matrix of errors</source>
        <translation>Matrice des erreurs</translation>
    </message>
    <message>
        <source>Tested on</source>
        <translation>Vérifié sur</translation>
    </message>
    <message>
        <source>Learned from (error RMS in µm)</source>
        <translation>Appris de (erreur RMS en µm)</translation>
    </message>
    <message>
        <source>Worth of the parameters</source>
        <translation>Valeur des paramètres</translation>
    </message>
    <message>
        <source>Change of the positions, RMS, µm</source>
        <translation>Changement des positions, RMS, µm</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matrice</translation>
    </message>
    <message>
        <source>On parts that were held out while learning (RMS): %1. A recording used to test was not learned from at all.</source>
        <translation>Sur des parties mises de côté pendant l’apprentissage (RMS) : %1. D’un enregistrement utilisé pour vérifier, rien n’a été appris.</translation>
    </message>
    <message>
        <source>Error on parts held out, while learning</source>
        <translation>Erreur sur les parties mises de côté, pendant l’apprentissage</translation>
    </message>
    <message>
        <source>none: what the model leaves is not chance</source>
        <translation>aucun : ce que laisse le modèle n’est pas du hasard</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FactorPanel</name>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Au moins</translation>
    </message>
    <message>
        <source>Smallest factor of your override that may act</source>
        <translation>Le plus petit facteur de votre override qui puisse agir</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>Largest factor that may act; together with your override no more than 120 % of the programmed feed</source>
        <translation>Le plus grand facteur qui puisse agir&#xa0;; avec votre override, au plus 120&#xa0;% de l’avance programmée</translation>
    </message>
    <message>
        <source>Silent after</source>
        <translation>Muette après</translation>
    </message>
    <message>
        <source>Without a factor</source>
        <translation>Sans facteur</translation>
    </message>
    <message>
        <source>Before the first one, when the source is silent or closed, and when it sends what was not agreed</source>
        <translation>Avant le premier, quand la source est muette ou fermée, et quand elle envoie ce qui n’était pas convenu</translation>
    </message>
    <message>
        <source>Your override acts alone.</source>
        <translation>Votre override agit seul.</translation>
    </message>
    <message>
        <source>It is read from the start on. Nothing moves before its first factor.</source>
        <translation>Elle est lue à partir du démarrage. Rien ne bouge avant son premier facteur.</translation>
    </message>
    <message>
        <source>It is read from the start on.</source>
        <translation>Elle est lue à partir du démarrage.</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Avance adaptative</translation>
    </message>
    <message>
        <source>A sensor or script that sends lines such as feed 0.85: 85 % of your override, until the next one. Pause and Stop always act.</source>
        <translation>Un capteur ou un script qui envoie des lignes comme feed 0.85&#xa0;: 85&#xa0;% de votre override, jusqu’à la suivante. Pause et Arrêt agissent toujours.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>TCP on this computer</source>
        <translation>TCP sur cet ordinateur</translation>
    </message>
    <message>
        <source>UDP on this computer</source>
        <translation>UDP sur cet ordinateur</translation>
    </message>
    <message>
        <source>Hold the axes</source>
        <translation>Retenir les axes</translation>
    </message>
    <message>
        <source>Your override alone</source>
        <translation>Votre override seul</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FeasibilityPage</name>
    <message>
        <source>F over d_min</source>
        <translation>F selon d_min</translation>
    </message>
    <message>
        <source>F over N</source>
        <translation>F selon N</translation>
    </message>
    <message>
        <source>F over δ</source>
        <translation>F selon δ</translation>
    </message>
    <message>
        <source>Load a program to see where it can be streamed.</source>
        <translation>Charger un programme pour voir où il peut être transmis.</translation>
    </message>
    <message>
        <source>Drag the ring to change the feed.</source>
        <translation>Tirer l’anneau pour changer l’avance.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the feed. Method position does not depend on N.</source>
        <translation>Tirer l’anneau pour changer N et l’avance. La méthode Position ne dépend pas de N.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the feed.</source>
        <translation>Tirer l’anneau pour changer N et l’avance.</translation>
    </message>
    <message>
        <source>Drag the ring to change δ and the feed.</source>
        <translation>Tirer l’anneau pour changer δ et l’avance.</translation>
    </message>
    <message>
        <source>Operating point</source>
        <translation>Point de fonctionnement</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Réalisable</translation>
    </message>
    <message>
        <source>Safety band</source>
        <translation>Bande de sécurité</translation>
    </message>
    <message>
        <source>(1) point distance</source>
        <translation>(1) distance des points</translation>
    </message>
    <message>
        <source>(2) distance δ</source>
        <translation>(2) distance δ</translation>
    </message>
    <message>
        <source>(3) half a loop</source>
        <translation>(3) demi-boucle</translation>
    </message>
    <message>
        <source>(3) half a loop, for information</source>
        <translation>(3) demi-boucle, pour information</translation>
    </message>
    <message>
        <source>(3ᴺ) half a loop, real path</source>
        <translation>(3ᴺ) demi-boucle, trajectoire réelle</translation>
    </message>
    <message>
        <source>dashed: as published</source>
        <translation>en tirets&#xa0;: comme publié</translation>
    </message>
    <message>
        <source>Smallest distances of the program</source>
        <translation>Plus petites distances du programme</translation>
    </message>
    <message>
        <source>Simulate around the operating point</source>
        <translation>Simuler autour du point de fonctionnement</translation>
    </message>
    <message>
        <source>Simulating: %p %</source>
        <translation>Simulation&#xa0;: %p %</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Simulated on the virtual machine, %1 points around the tightest place.</source>
        <translation>Simulé sur la machine virtuelle, %1 points autour de l’endroit le plus serré.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Fonctionne</translation>
    </message>
    <message>
        <source>Sometimes fails</source>
        <translation>Échoue parfois</translation>
    </message>
    <message>
        <source>Always fails</source>
        <translation>Échoue toujours</translation>
    </message>
    <message>
        <source>Model: 0.1 % to 50 % fail</source>
        <translation>Calcul&#xa0;: 0,1&#xa0;% à 50&#xa0;% d’échecs</translation>
    </message>
    <message>
        <source>This method does not use δ: the limits do not depend on it.</source>
        <translation>Cette méthode n’utilise pas δ&#xa0;: les limites n’en dépendent pas.</translation>
    </message>
    <message>
        <source>Without waiting</source>
        <translation>Sans attente</translation>
    </message>
    <message>
        <source>reach: the client keeps up</source>
        <translation>portée&#xa0;: le client suit</translation>
    </message>
    <message>
        <source>Runs failed in the simulation</source>
        <translation>Échecs dans la simulation</translation>
    </message>
    <message>
        <source>Override over t_min</source>
        <translation>Override selon t_min</translation>
    </message>
    <message>
        <source>Override over N</source>
        <translation>Override selon N</translation>
    </message>
    <message>
        <source>Override over δ</source>
        <translation>Override selon δ</translation>
    </message>
    <message>
        <source>Drag the ring to change the override on the feeds of the program.</source>
        <translation>Tirer l’anneau pour changer l’override sur les avances du programme.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the override.</source>
        <translation>Tirer l’anneau pour changer N et l’override.</translation>
    </message>
    <message>
        <source>Largest override: %1.</source>
        <translation>Override maximal&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Shortest moves of the program</source>
        <translation>Mouvements les plus courts du programme</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FileBanner</name>
    <message>
        <source>The file %1 has changed.</source>
        <translation>Le fichier %1 a été modifié.</translation>
    </message>
    <message>
        <source>The file %1 is no longer there.</source>
        <translation>Le fichier %1 n’existe plus.</translation>
    </message>
    <message>
        <source>The run keeps version %1.</source>
        <translation>L’exécution garde la version %1.</translation>
    </message>
    <message>
        <source>Reload it?</source>
        <translation>Le recharger&#xa0;?</translation>
    </message>
    <message>
        <source>Version %1 stays loaded.</source>
        <translation>La version %1 reste chargée.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FileField</name>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Choose the file: %1</source>
        <translation>Choisir le fichier : %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FitModel</name>
    <message>
        <source>write</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accès</translation>
    </message>
    <message>
        <source>Per request (a)</source>
        <translation>Par requête (a)</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Per R-parameter (b)</source>
        <translation>Par paramètre R (b)</translation>
    </message>
    <message>
        <source>± of b</source>
        <translation>± de b</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FoundRunBar</name>
    <message>
        <source>It can be resumed on the computer where it was started.</source>
        <translation>Elle peut être reprise sur l’ordinateur où elle a été démarrée.</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Observer</translation>
    </message>
    <message>
        <source>Shows program, position and progress. Nothing is changed.</source>
        <translation>Affiche le programme, la position et la progression. Rien n’est modifié.</translation>
    </message>
    <message>
        <source>Stop the run</source>
        <translation>Arrêter l’exécution</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Reprendre…</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Pas maintenant</translation>
    </message>
    <message>
        <source>The axes stand at once, whoever started the run.</source>
        <translation>Les axes s’arrêtent aussitôt, quel que soit l’auteur du lancement.</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Terminer ici</translation>
    </message>
    <message>
        <source>The axes go on to the end of the window, or of the block of the control, and the program ends there.</source>
        <translation>Les axes vont jusqu’à la fin de la fenêtre, ou du bloc de la commande, et le programme s’y termine.</translation>
    </message>
    <message>
        <source>Stop requested: still moving, at most %1, about %2</source>
        <translation>Arrêt demandé&#xa0;: encore en mouvement, au plus %1, environ %2</translation>
    </message>
    <message>
        <source>Stop requested, not yet confirmed</source>
        <translation>Arrêt demandé, pas encore confirmé</translation>
    </message>
    <message>
        <source>Loads the program, compares it and asks the control where the run was left. Nothing moves yet.</source>
        <translation>Charge le programme, le compare et demande à la commande où l’exécution s’est interrompue. Rien ne bouge encore.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::HelpPage</name>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::HistogramChart</name>
    <message>
        <source>Duration, ms</source>
        <translation>Durée, ms</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>write</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>%1 %: %2</source>
        <translation>%1&#xa0;%&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 beyond, the longest %2</source>
        <translation>%1 au-delà, la plus longue %2</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LayoutMenu</name>
    <message>
        <source>No layout is kept yet</source>
        <translation>Aucune disposition n’est encore gardée</translation>
    </message>
    <message>
        <source>Keep the present panes as…</source>
        <translation>Garder les zones actuelles sous…</translation>
    </message>
    <message>
        <source>New traces are shown in</source>
        <translation>Les nouveaux tracés s’affichent dans</translation>
    </message>
    <message>
        <source>the usual panes</source>
        <translation>les zones habituelles</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Keep the panes</source>
        <translation>Garder les zones</translation>
    </message>
    <message>
        <source>Name of the layout; one of the same name is replaced</source>
        <translation>Nom de la disposition ; celle du même nom est remplacée</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LinesChart</name>
    <message>
        <source>Duration, ms</source>
        <translation>Durée, ms</translation>
    </message>
    <message>
        <source>write</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>R-parameters of the request</source>
        <translation>Paramètres R de la requête</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LiveDialog</name>
    <message>
        <source>Live points</source>
        <translation>Points en direct</translation>
    </message>
    <message>
        <source>A program or script computes the path while the machine moves and sends its points as lines, such as X1.5 Y2 F500. Nothing moves that is outside what is agreed here.</source>
        <translation>Un programme ou un script calcule la trajectoire pendant que la machine bouge et envoie ses points en lignes telles que X1.5 Y2 F500. Rien ne bouge hors de ce qui est convenu ici.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Listens from now on. Nothing moves before the start.</source>
        <translation>Écoute dès maintenant. Rien ne bouge avant le démarrage.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>TCP port of this computer</source>
        <translation>Port TCP de cet ordinateur</translation>
    </message>
    <message>
        <source>UDP port of this computer</source>
        <translation>Port UDP de cet ordinateur</translation>
    </message>
    <message>
        <source>UNIX socket</source>
        <translation>Socket UNIX</translation>
    </message>
    <message>
        <source>Standard input of this window</source>
        <translation>Entrée standard de cette fenêtre</translation>
    </message>
    <message>
        <source>0: any that is free</source>
        <translation>0&#xa0;: un port libre</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>File name of the socket, which only this user can write to</source>
        <translation>Nom de fichier du socket, où seul cet utilisateur peut écrire</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Chemin</translation>
    </message>
    <message>
        <source>Box of all points</source>
        <translation>Pavé de tous les points</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>Least coordinate, workpiece frame</source>
        <translation>Plus petite coordonnée, repère pièce</translation>
    </message>
    <message>
        <source>Largest coordinate, workpiece frame</source>
        <translation>Plus grande coordonnée, repère pièce</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 de</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 à</translation>
    </message>
    <message>
        <source>Agreed with the source</source>
        <translation>Convenu avec la source</translation>
    </message>
    <message>
        <source>First point within</source>
        <translation>Premier point à moins de</translation>
    </message>
    <message>
        <source>Largest distance of the first point from the tool</source>
        <translation>Plus grande distance du premier point à l’outil</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Plus grand pas</translation>
    </message>
    <message>
        <source>Largest distance of two points</source>
        <translation>Plus grande distance de deux points</translation>
    </message>
    <message>
        <source>Largest F</source>
        <translation>Plus grand F</translation>
    </message>
    <message>
        <source>It is also the feed of points before the first F.</source>
        <translation>C’est aussi l’avance des points avant le premier F.</translation>
    </message>
    <message>
        <source>Merge below</source>
        <translation>Fusionner sous</translation>
    </message>
    <message>
        <source>Points that are closer are merged with the one before.</source>
        <translation>Les points plus proches sont fusionnés avec le précédent.</translation>
    </message>
    <message>
        <source>Largest turn</source>
        <translation>Plus grande rotation</translation>
    </message>
    <message>
        <source>Largest turn of a rotary axis between two points</source>
        <translation>Plus grande rotation d’un axe rotatif entre deux points</translation>
    </message>
    <message>
        <source>Points may turn this axis (method window).</source>
        <translation>Les points peuvent tourner cet axe (méthode Fenêtre).</translation>
    </message>
    <message>
        <source>Rotary axis %1</source>
        <translation>Axe rotatif %1</translation>
    </message>
    <message>
        <source>Rotary axes</source>
        <translation>Axes rotatifs</translation>
    </message>
    <message>
        <source>When no points come</source>
        <translation>Quand aucun point n’arrive</translation>
    </message>
    <message>
        <source>Window within</source>
        <translation>Fenêtre en</translation>
    </message>
    <message>
        <source>A window that is not full is sent after this time.</source>
        <translation>Une fenêtre qui n’est pas pleine est envoyée après ce temps.</translation>
    </message>
    <message>
        <source>Hold after</source>
        <translation>Suspendre après</translation>
    </message>
    <message>
        <source>After this much silence the run holds; it goes on with the next point.</source>
        <translation>Après ce silence, l’exécution est suspendue&#xa0;; elle continue avec le point suivant.</translation>
    </message>
    <message>
        <source>End after</source>
        <translation>Terminer après</translation>
    </message>
    <message>
        <source>After this much silence the run ends with an error.</source>
        <translation>Après ce silence, l’exécution se termine par une erreur.</translation>
    </message>
    <message>
        <source>Variables of an OPC UA server</source>
        <translation>Variables d’un serveur OPC UA</translation>
    </message>
    <message>
        <source>To ports and sockets, only programs on this computer can send.</source>
        <translation>Seuls les programmes de cet ordinateur peuvent envoyer aux ports et aux sockets.</translation>
    </message>
    <message>
        <source>This file names the server and its variables (TOML).</source>
        <translation>Ce fichier nomme le serveur et ses variables (TOML).</translation>
    </message>
    <message>
        <source>File of the source</source>
        <translation>Fichier de la source</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Choisir …</translation>
    </message>
    <message>
        <source>Choose the file of the source</source>
        <translation>Choisir le fichier de la source</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Sources (*.toml);;All files (*)</source>
        <translation>Sources (*.toml);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Around the tool</source>
        <translation>Autour de l’outil</translation>
    </message>
    <message>
        <source>Puts a box of this size around the place where the tool stands.</source>
        <translation>Place une boîte de cette taille autour de l’endroit où se trouve l’outil.</translation>
    </message>
    <message>
        <source>Where the tool stands is not known.</source>
        <translation>On ne sait pas où se trouve l’outil.</translation>
    </message>
    <message>
        <source>The tool stands at %1.</source>
        <translation>L’outil se trouve à %1.</translation>
    </message>
    <message>
        <source>The tool stands at %1, so far outside that no first point can be in the box.</source>
        <translation>L’outil se trouve à %1, si loin dehors qu’aucun premier point ne peut être dans la boîte.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LivePanel</name>
    <message>
        <source>It is read as soon as the control runs the program.</source>
        <translation>Elle est lue dès que la commande exécute le programme.</translation>
    </message>
    <message>
        <source>The run has ended. It listens for the next one.</source>
        <translation>L’exécution est terminée. La source attend la suivante.</translation>
    </message>
    <message>
        <source>Listening. Nothing is read before the start.</source>
        <translation>À l’écoute. Rien n’est lu avant le démarrage.</translation>
    </message>
    <message>
        <source>Waiting for the first line, for %1</source>
        <translation>Attend la première ligne depuis %1</translation>
    </message>
    <message>
        <source>Receiving</source>
        <translation>Reçoit</translation>
    </message>
    <message>
        <source>Silent for %1; %2</source>
        <translation>Muette depuis %1&#xa0;; %2</translation>
    </message>
    <message>
        <source>Ended by the source</source>
        <translation>Terminé par la source</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 points sur %2</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Live points …</source>
        <translation>Points en direct…</translation>
    </message>
    <message>
        <source>Another source, or something else agreed with it</source>
        <translation>Une autre source, ou un autre accord avec elle</translation>
    </message>
    <message>
        <source>Open program …</source>
        <translation>Ouvrir un programme…</translation>
    </message>
    <message>
        <source>A program takes the place of the live source.</source>
        <translation>Un programme prend la place de la source en direct.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Agreed with the source</source>
        <translation>Convenu avec la source</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Tampon</translation>
    </message>
    <message>
        <source>Points that have arrived and are not executed. When it is full, the source is made to wait.</source>
        <translation>Points arrivés et pas encore exécutés. Quand il est plein, la source doit attendre.</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Sortie</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Acceptés</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Exécutés</translation>
    </message>
    <message>
        <source>Merged</source>
        <translation>Fusionnés</translation>
    </message>
    <message>
        <source>Delay, median</source>
        <translation>Délai, médiane</translation>
    </message>
    <message>
        <source>Delay, 99 %</source>
        <translation>Délai, 99&#xa0;%</translation>
    </message>
    <message>
        <source>In theory</source>
        <translation>En théorie</translation>
    </message>
    <message>
        <source>Points from the source, mean of the last two seconds</source>
        <translation>Points de la source, moyenne des deux dernières secondes</translation>
    </message>
    <message>
        <source>Points executed, mean of the last two seconds</source>
        <translation>Points exécutés, moyenne des deux dernières secondes</translation>
    </message>
    <message>
        <source>Points of the source within the agreed limits</source>
        <translation>Points de la source qui respectent ce qui est convenu</translation>
    </message>
    <message>
        <source>Points that are known to be executed</source>
        <translation>Points dont l’exécution est connue</translation>
    </message>
    <message>
        <source>Points too close to the one before, which are left out</source>
        <translation>Points trop proches du précédent, qui sont omis</translation>
    </message>
    <message>
        <source>From the arrival of a point to the beginning of its move; during a run, of the last 500 points</source>
        <translation>De l’arrivée d’un point au début de son mouvement&#xa0;; pendant une exécution, des 500 derniers points</translation>
    </message>
    <message>
        <source>Of a hundred points, one was later than this.</source>
        <translation>Sur cent points, un était plus tard.</translation>
    </message>
    <message>
        <source>Least delay, and the delay when all buffers are full</source>
        <translation>Plus petit délai, et le délai quand tous les tampons sont pleins</translation>
    </message>
    <message>
        <source>First point within</source>
        <translation>Premier point à moins de</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Plus grand pas</translation>
    </message>
    <message>
        <source>Largest F</source>
        <translation>Plus grand F</translation>
    </message>
    <message>
        <source>Merge below</source>
        <translation>Fusionner sous</translation>
    </message>
    <message>
        <source>When it is silent</source>
        <translation>Quand elle est muette</translation>
    </message>
    <message>
        <source>Send lines such as X1.5 Y2 F500 to 127.0.0.1, port %1. The line “end” ends the run.</source>
        <translation>Envoyer des lignes telles que X1.5 Y2 F500 à 127.0.0.1, port %1. La ligne «&#xa0;end&#xa0;» termine l’exécution.</translation>
    </message>
    <message>
        <source>Send lines such as X1.5 Y2 F500 to it. The line “end” ends the run.</source>
        <translation>Lui envoyer des lignes telles que X1.5 Y2 F500. La ligne «&#xa0;end&#xa0;» termine l’exécution.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LoadBar</name>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogInDialog</name>
    <message>
        <source>Log in</source>
        <translation>S’identifier</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utilisateur</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>Code PIN</translation>
    </message>
    <message>
        <source>Delete the last digit</source>
        <translation>Effacer le dernier chiffre</translation>
    </message>
    <message>
        <source>Wrong PIN. Try again in %1 s.</source>
        <translation>Code PIN erroné. Réessayer dans %1 s.</translation>
    </message>
    <message>
        <source>Wrong PIN.</source>
        <translation>Code PIN erroné.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogModel</name>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogView</name>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Save the messages</source>
        <translation>Enregistrer les messages</translation>
    </message>
    <message>
        <source>%1 of %2 messages</source>
        <translation>%1 messages sur %2</translation>
    </message>
    <message>
        <source>All messages</source>
        <translation>Tous les messages</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Avertissements et erreurs</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>Erreurs seulement</translation>
    </message>
    <message>
        <source>All sources</source>
        <translation>Toutes les sources</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Wrap lines</source>
        <translation>Renvoi à la ligne</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message numerus="yes">
        <source>%Ln messages</source>
        <translation>
            <numerusform>%Ln message</numerusform>
            <numerusform>%Ln messages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LoginFields</name>
    <message>
        <source>This machine lets nobody in without a user. Type user and password.</source>
        <translation>Cette machine ne laisse entrer personne sans utilisateur. Saisir utilisateur et mot de passe.</translation>
    </message>
    <message>
        <source>Type the password of this user.</source>
        <translation>Saisir le mot de passe de cet utilisateur.</translation>
    </message>
    <message>
        <source>The machine refuses user or password. Check both. After several wrong ones it locks the user for some time.</source>
        <translation>La machine refuse l’utilisateur ou le mot de passe. Vérifier les deux. Après plusieurs erreurs, elle bloque l’utilisateur pendant un certain temps.</translation>
    </message>
    <message>
        <source>There is no keyring on this computer: the password is asked for each time.</source>
        <translation>Il n’y a pas de trousseau sur cet ordinateur&#xa0;: le mot de passe est demandé à chaque fois.</translation>
    </message>
    <message>
        <source>Log in as a user of the machine</source>
        <translation>Se connecter comme utilisateur de la machine</translation>
    </message>
    <message>
        <source>Without it, the connection is anonymous.</source>
        <translation>Sinon, la connexion est anonyme.</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utilisateur</translation>
    </message>
    <message>
        <source>User of the OPC UA server, as it is set up on the control.</source>
        <translation>Utilisateur du serveur OPC UA, tel qu’il est configuré sur la commande.</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Mot de passe</translation>
    </message>
    <message>
        <source>It is sent encrypted only, and is in no setting, log or recording.</source>
        <translation>Il n’est envoyé que chiffré et ne figure dans aucun réglage, journal ni enregistrement.</translation>
    </message>
    <message>
        <source>Keep it in the keyring</source>
        <translation>Le conserver dans le trousseau</translation>
    </message>
    <message>
        <source>The keyring of this computer&apos;s user keeps it encrypted; it is not asked for again.</source>
        <translation>Le trousseau de l’utilisateur de cet ordinateur le conserve chiffré&#xa0;; il n’est plus demandé.</translation>
    </message>
    <message>
        <source>This machine lets nobody in without a user. Choose the user&apos;s certificate.</source>
        <translation>Cette machine n&apos;accepte personne sans utilisateur. Choisissez le certificat de l&apos;utilisateur.</translation>
    </message>
    <message>
        <source>The machine refuses this certificate. Register it for a user on the machine, or choose another one.</source>
        <translation>La machine refuse ce certificat. Enregistrez-le pour un utilisateur sur la machine, ou choisissez-en un autre.</translation>
    </message>
    <message>
        <source>The user is known by</source>
        <translation>L&apos;utilisateur s&apos;identifie par</translation>
    </message>
    <message>
        <source>What the machine asks of its users.</source>
        <translation>Ce que la machine demande à ses utilisateurs.</translation>
    </message>
    <message>
        <source>name and password</source>
        <translation>nom et mot de passe</translation>
    </message>
    <message>
        <source>a certificate</source>
        <translation>un certificat</translation>
    </message>
    <message>
        <source>Certificate of the user</source>
        <translation>Certificat de l&apos;utilisateur</translation>
    </message>
    <message>
        <source>PEM or DER. Register it on the machine first. The name of the file is remembered for this machine.</source>
        <translation>PEM ou DER. Enregistrez-le d&apos;abord sur la machine. Le nom du fichier est retenu pour cette machine.</translation>
    </message>
    <message>
        <source>Key, if it is in another file</source>
        <translation>Clé, si dans un autre fichier</translation>
    </message>
    <message>
        <source>PEM or DER, not locked by a password; only this computer&apos;s user may read the file (mode 0600). The key is not sent.</source>
        <translation>PEM ou DER, non protégé par un mot de passe ; seul l&apos;utilisateur de cet ordinateur peut lire le fichier (mode 0600). La clé n&apos;est pas envoyée.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MachineButton</name>
    <message>
        <source>Virtual machine</source>
        <translation>Machine virtuelle</translation>
    </message>
    <message>
        <source>%1, silent for %2 s</source>
        <translation>%1, sans réponse depuis %2 s</translation>
    </message>
    <message>
        <source>Connection and state of the machine</source>
        <translation>Connexion et état de la machine</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MachinesPage</name>
    <message numerus="yes">
        <source>%Ln virtual machines of this computer do not answer any more, and nothing but their runs is kept.</source>
        <translation>
            <numerusform>%Ln machine virtuelle de cet ordinateur ne répond plus, et seules ses exécutions sont conservées.</numerusform>
            <numerusform>%Ln machines virtuelles de cet ordinateur ne répondent plus, et seules leurs exécutions sont conservées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide them</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>One machine at a time is connected with a window. Of the others only the port is looked at, every 30 s while this page is shown: a question would cost them time that another stream may need.</source>
        <translation>Une fenêtre n’est connectée qu’à une machine à la fois. Pour les autres, seul le port est vérifié, toutes les 30 s tant que cette page est affichée&#xa0;: une question leur coûterait du temps dont un autre flux peut avoir besoin.</translation>
    </message>
    <message>
        <source>Puts the service with this address on the board.</source>
        <translation>Met le service de cette adresse sur le tableau.</translation>
    </message>
    <message>
        <source>Asks a discovery server of OPC UA for services: that of the address, or of this computer.</source>
        <translation>Demande à un serveur de découverte OPC UA les services&#xa0;: celui de l’adresse, ou celui de cet ordinateur.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Services: machines without a window</source>
        <translation>Services&#xa0;: machines sans fenêtre</translation>
    </message>
    <message>
        <source>&amp;Address of a service</source>
        <translation>&amp;Adresse d’un service</translation>
    </message>
    <message>
        <source>Address of a service</source>
        <translation>Adresse d’un service</translation>
    </message>
    <message>
        <source>As rivulet-service prints it when it is ready.</source>
        <translation>Telle que rivulet-service l’affiche quand il est prêt.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MethodPanel</name>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>N (points per loop)</source>
        <translation>N (points par boucle)</translation>
    </message>
    <message>
        <source>δ (point reached)</source>
        <translation>δ (point atteint)</translation>
    </message>
    <message>
        <source>F (path feed)</source>
        <translation>F (avance)</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Paramètres R</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Largest feed</source>
        <translation>Avance maximale</translation>
    </message>
    <message>
        <source>Limiting place</source>
        <translation>Endroit le plus serré</translation>
    </message>
    <message>
        <source>Distance from the tool at which a point counts as reached</source>
        <translation>Distance à l’outil à partir de laquelle un point est considéré comme atteint</translation>
    </message>
    <message>
        <source>Equation (1): the tool must not pass a point between two polls.</source>
        <translation>Équation (1)&#xa0;: l’outil ne doit dépasser aucun point entre deux lectures.</translation>
    </message>
    <message>
        <source>Equation (2): the tool must be seen within δ of each point.</source>
        <translation>Équation (2)&#xa0;: l’outil doit être vu à moins de δ de chaque point.</translation>
    </message>
    <message>
        <source>Equation (3): half a loop must be written before the tool has used it up.</source>
        <translation>Équation (3)&#xa0;: une demi-boucle doit être écrite avant que l’outil ne l’ait consommée.</translation>
    </message>
    <message>
        <source>Equation (3) with the real path: half a loop must be written before the tool has used it up.</source>
        <translation>Équation (3) avec la trajectoire réelle&#xa0;: une demi-boucle doit être écrite avant que l’outil ne l’ait consommée.</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Non évalué</translation>
    </message>
    <message>
        <source>Load a program to get a verdict.</source>
        <translation>Charger un programme pour obtenir un verdict.</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Réalisable</translation>
    </message>
    <message>
        <source>Not feasible</source>
        <translation>Non réalisable</translation>
    </message>
    <message>
        <source>Closest limit: %1</source>
        <translation>Limite la plus proche&#xa0;: %1</translation>
    </message>
    <message>
        <source>Violated: %1</source>
        <translation>Non respectée&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 × (must exceed 1)</source>
        <translation>%1 × (doit dépasser 1)</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>lines %1–%2</source>
        <translation>lignes %1–%2</translation>
    </message>
    <message>
        <source>Use δ = %1</source>
        <translation>Utiliser δ = %1</translation>
    </message>
    <message>
        <source>Use F = %1</source>
        <translation>Utiliser F = %1</translation>
    </message>
    <message>
        <source>No feed is slow enough: two points of the program nearly coincide.</source>
        <translation>Aucune avance n’est assez lente&#xa0;: deux points du programme sont presque confondus.</translation>
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
        <translation>Espacés (R11, R21 …)</translation>
    </message>
    <message>
        <source>In a row (R10 …)</source>
        <translation>À la suite (R10 …)</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>N (points per window)</source>
        <translation>N (points par fenêtre)</translation>
    </message>
    <message>
        <source>Reach: the next window must be written while the tool executes the current one.</source>
        <translation>Portée&#xa0;: la fenêtre suivante doit être écrite pendant que l’outil exécute la fenêtre en cours.</translation>
    </message>
    <message>
        <source>Largest feed without waiting</source>
        <translation>Avance maximale sans attente</translation>
    </message>
    <message>
        <source>Safe, with waiting</source>
        <translation>Sûr, avec des attentes</translation>
    </message>
    <message>
        <source>The machine will wait for points: %1</source>
        <translation>La machine attendra des points&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 × (waits below 1)</source>
        <translation>%1 × (attend en dessous de 1)</translation>
    </message>
    <message>
        <source>Credit (experimental)</source>
        <translation>Crédit (expérimental)</translation>
    </message>
    <message>
        <source>Windows have a layout of their own</source>
        <translation>Les fenêtres ont leur propre disposition</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accès</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Arrays, or no start</source>
        <translation>Tableaux, sinon pas de départ</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>Listes</translation>
    </message>
    <message>
        <source>One by one</source>
        <translation>Un par un</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pauses</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Prévues</translation>
    </message>
    <message>
        <source>Places where the axes will stop for a moment. Off the cut means after a rapid or a retract, or at a sharp corner; the path shows the places.</source>
        <translation>Endroits où les axes s’arrêteront un instant. Hors coupe&#xa0;: après un rapide ou un dégagement, ou à un angle vif&#xa0;; la trajectoire montre les endroits.</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Temps perdu</translation>
    </message>
    <message>
        <source>Standstill, braking and acceleration, computed with the axes of the virtual machine</source>
        <translation>Arrêt, freinage et accélération, calculés avec les axes de la machine virtuelle</translation>
    </message>
    <message>
        <source>Automatic: before anything moves, the forms of access are tested on the control and the best one is used. The report names it.</source>
        <translation>Automatique&#xa0;: avant tout mouvement, les formes d’accès sont testées sur la commande et la meilleure est utilisée. Le rapport l’indique.</translation>
    </message>
    <message>
        <source>Automatic: lists, as this method was published. Arrays need the contiguous layout.</source>
        <translation>Automatique&#xa0;: listes, comme cette méthode a été publiée. Les tableaux demandent la disposition contiguë.</translation>
    </message>
    <message>
        <source>%1, of them %2 in the cut</source>
        <translation>%1, dont %2 en coupe</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calcul en cours…</translation>
    </message>
    <message>
        <source>Correction up to</source>
        <translation>Correction jusqu’à</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Largest correction of each axis during the run. The control must not add corrections up (MD36750 bit 0), and its own limit (SD43350) should not be larger.</source>
        <translation>Plus grande correction de chaque axe pendant l’exécution. La commande ne doit pas additionner les corrections (MD36750 bit 0), et sa propre limite (SD43350) ne devrait pas être plus grande.</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>copied by hand</source>
        <translation>copié à la main</translation>
    </message>
    <message>
        <source>For a control that gives no right to its part programs: store the template there, select it and press cycle start. The run waits until this is done.</source>
        <translation>Pour une commande qui ne donne pas de droit sur ses programmes pièce&#xa0;: y déposer le modèle, le sélectionner et actionner Départ cycle. L’exécution attend jusque-là.</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Vérification…</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Of the program</source>
        <translation>Celle du programme</translation>
    </message>
    <message>
        <source>One for all moves</source>
        <translation>Avance fixe</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Scales the feeds of the program, and its rapids up to the rapid feed of the machine</source>
        <translation>Agit sur les avances du programme et sur ses rapides, au plus jusqu’à la vitesse rapide de la machine</translation>
    </message>
    <message>
        <source>This method has one feed for all moves, as it was published</source>
        <translation>Cette méthode a une seule avance pour tous les mouvements, comme dans sa publication</translation>
    </message>
    <message>
        <source>Of the program: each move has the feed of its own block, rapids are rapids. One for all moves: rapids have it, too.</source>
        <translation>Celle du programme&#xa0;: chaque mouvement a l’avance de son bloc, les rapides restent des rapides. Avance fixe&#xa0;: les rapides l’ont aussi.</translation>
    </message>
    <message>
        <source>Largest override</source>
        <translation>Override maximal</translation>
    </message>
    <message>
        <source>Use override = %1&#xa0;%</source>
        <translation>Utiliser override = %1&#xa0;%</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Exécuter</translation>
    </message>
    <message>
        <source>Whole job</source>
        <translation>Tâche complète</translation>
    </message>
    <message>
        <source>Motion only</source>
        <translation>Mouvement seul</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Essai à vide</translation>
    </message>
    <message>
        <source>Above the workpiece</source>
        <translation>Au-dessus de la pièce</translation>
    </message>
    <message>
        <source>Whole job: the control executes tools, spindle, coolant, cycles and retracts at their place, and Rivulet streams the motion between them. Motion only: these blocks are left out. Dry run: the whole job above the workpiece, without spindle and coolant.</source>
        <translation>Tâche complète&#xa0;: la commande exécute outils, broche, arrosage, cycles et dégagements à leur place, et Rivulet transmet le mouvement entre eux. Mouvement seul&#xa0;: ces blocs sont omis. Essai à vide&#xa0;: la tâche complète au-dessus de la pièce, sans broche ni arrosage.</translation>
    </message>
    <message>
        <source>The points of a live source have feeds of their own.</source>
        <translation>Les points d’une source en direct ont leurs propres avances.</translation>
    </message>
    <message>
        <source>Lift while paused</source>
        <translation>Relever pendant la pause</translation>
    </message>
    <message>
        <source>While the axes are held, the tool can be lifted by so much. The control must not add overlays up (MD36750 bit 0), and its limit (SD43350) must not be smaller. Not with a correction or in a whole job; on a real control only after its stop test with a lift.</source>
        <translation>Tant que les axes sont retenus, l’outil peut être relevé d’autant. La commande ne doit pas additionner les superpositions (MD36750 bit 0), et sa limite (SD43350) ne doit pas être plus petite. Pas avec une correction ni dans un travail entier&#xa0;; sur une vraie commande seulement après son essai d’arrêt avec relevage.</translation>
    </message>
    <message>
        <source>packed: one R-parameter each</source>
        <translation>groupés&#xa0;: un paramètre R chacun</translation>
    </message>
    <message>
        <source>All axes of a point share one R-parameter, in steps of 0.001 mm from the first point of its window: a third of the accesses, so faster where the points are dense. A control that calculates otherwise refuses the first window; nothing moves then.</source>
        <translation>Tous les axes d’un point partagent un paramètre R, par pas de 0,001 mm à partir du premier point de sa fenêtre&#xa0;: un tiers des accès, donc plus rapide là où les points sont denses. Une commande qui calcule autrement refuse la première fenêtre&#xa0;; rien ne bouge alors.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>This method does not use δ: it watches an R-parameter, not the tool</source>
        <translation>Cette méthode n’utilise pas δ : elle surveille un paramètre R, pas l’outil</translation>
    </message>
    <message>
        <source>Window: the machine waits if the client is late; it never executes a point twice. Position: the client watches the tool and replaces points it has passed. Signal: the client watches an R-parameter in which the program says which half of the loop may be replaced. Credit: like window, without a stop between windows; it starts only on a control that has passed the test on the page Credit test.</source>
        <translation>Fenêtre : la machine attend si le client est en retard ; elle n’exécute jamais un point deux fois. Position : le client suit l’outil et remplace les points déjà passés. Signal : le client surveille un paramètre R où le programme indique quelle moitié de la boucle peut être remplacée. Crédit : comme Fenêtre, sans arrêt entre les fenêtres ; ne démarre que sur une commande qui a réussi le test de la page Test crédit.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Straight moves that stay so near to the path take the place of many short ones (rotary axes: degrees). Corners, feeds and the order of the path stay. Not in whole jobs and live runs.</source>
        <translation>Des mouvements droits qui restent aussi près de la trajectoire remplacent de nombreux courts (axes rotatifs : degrés). Angles, avances et ordre de la trajectoire restent. Pas dans les travaux complets ni avec des points en direct.</translation>
    </message>
    <message>
        <source>Machine: requests and motion of this machine, followed through the program.</source>
        <translation>Machine : requêtes et mouvement de cette machine, suivis à travers le programme.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NetCanvas</name>
    <message>
        <source>Only records; holds no tokens.</source>
        <translation>Enregistre seulement, ne garde pas de jetons.</translation>
    </message>
    <message>
        <source>Tokens: %1</source>
        <translation>Jetons : %1</translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation>Priorité %1</translation>
    </message>
    <message>
        <source>If %1</source>
        <translation>Si %1</translation>
    </message>
    <message>
        <source>A page of its own: Enter or a double click opens it.</source>
        <translation>Une page à part : Entrée ou un double clic l’ouvre.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NetPanel</name>
    <message>
        <source>Place</source>
        <translation>Place</translation>
    </message>
    <message>
        <source>Tokens</source>
        <translation>Jetons</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Jouer</translation>
    </message>
    <message>
        <source>There is no net.</source>
        <translation>Il n’y a pas de réseau.</translation>
    </message>
    <message>
        <source>%1, fired %2; next: %3</source>
        <translation>%1, franchies %2 ; suivante : %3</translation>
    </message>
    <message>
        <source>%1, fired %2; nothing more is played</source>
        <translation>%1, franchies %2 ; rien de plus n’est joué</translation>
    </message>
    <message>
        <source>Click a place or a transition: what it holds or needs is shown here.</source>
        <translation>Cliquer sur une place ou une transition : ce qu’elle contient ou demande s’affiche ici.</translation>
    </message>
    <message>
        <source>Cycle %1 ms</source>
        <translation>Cycle %1 ms</translation>
    </message>
    <message>
        <source>Cycle of position control; the net begins anew</source>
        <translation>Cycle de l’asservissement de position ; le réseau recommence</translation>
    </message>
    <message>
        <source>Task dependency</source>
        <translation>Dépendance des tâches</translation>
    </message>
    <message>
        <source>Data flow</source>
        <translation>Flux de données</translation>
    </message>
    <message>
        <source>Which task gets the processor; the net begins anew</source>
        <translation>Quelle tâche obtient le processeur ; le réseau recommence</translation>
    </message>
    <message>
        <source>Page of the net</source>
        <translation>Page du réseau</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Suivre</translation>
    </message>
    <message>
        <source>Show the page on which the next transition fires</source>
        <translation>Afficher la page où la prochaine transition est franchie</translation>
    </message>
    <message>
        <source>%1 per s</source>
        <translation>%1 par s</translation>
    </message>
    <message>
        <source>Transitions that fire in a second</source>
        <translation>Transitions franchies en une seconde</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Fire one transition</source>
        <translation>Franchir une transition</translation>
    </message>
    <message>
        <source>Fire one transition after another</source>
        <translation>Franchir une transition après l’autre</translation>
    </message>
    <message>
        <source>Back to start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>The tokens as they were at the beginning</source>
        <translation>Les jetons comme au début</translation>
    </message>
    <message>
        <source>Petri net</source>
        <translation>Réseau de Petri</translation>
    </message>
    <message>
        <source>A thick frame with a triangle: this transition could fire. Filled: it fires next. Thick lines: it fired last.</source>
        <translation>Un cadre épais avec un triangle : cette transition pourrait être franchie. Rempli : elle l’est ensuite. Lignes épaisses : elle l’a été en dernier.</translation>
    </message>
    <message>
        <source>Levels of the buffers</source>
        <translation>Niveaux des tampons</translation>
    </message>
    <message>
        <source>Time of the net, s</source>
        <translation>Temps du réseau, s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Places of this page</source>
        <translation>Places de cette page</translation>
    </message>
    <message>
        <source>What is chosen</source>
        <translation>Ce qui est choisi</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NumberField</name>
    <message>
        <source>%1 can be read in two ways. Type it without a separator between thousands, or with %2 before the decimals.</source>
        <translation>%1 peut se lire de deux façons. Le saisir sans séparateur de milliers, ou avec %2 avant les décimales.</translation>
    </message>
    <message>
        <source>%1 has more than one separator. Type it without separators between thousands.</source>
        <translation>%1 a plus d’un séparateur. Le saisir sans séparateur de milliers.</translation>
    </message>
    <message>
        <source>The field was empty.</source>
        <translation>Le champ était vide.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 n’est pas un nombre.</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 to %3.</source>
        <translation>%1 est hors plage&#xa0;: %2 à %3.</translation>
    </message>
    <message>
        <source>%1 The value stays %2.</source>
        <translation>%1 La valeur reste %2.</translation>
    </message>
    <message>
        <source>%1 is not a whole number. Type it without separators.</source>
        <translation>%1 n’est pas un nombre entier. Le saisir sans séparateur.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::OverlayPanel</name>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Emulator</source>
        <translation>Émulateur</translation>
    </message>
    <message>
        <source>%1 machine − emulator</source>
        <translation>%1 machine − émulateur</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>Recording on which machine and emulator are compared</source>
        <translation>Enregistrement sur lequel machine et émulateur sont comparés</translation>
    </message>
    <message>
        <source>Errors drawn larger</source>
        <translation>Erreurs agrandies</translation>
    </message>
    <message>
        <source>How many times larger the distance to the path of the set points is drawn</source>
        <translation>Combien de fois plus grande est dessinée la distance à la trajectoire des consignes</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Erreur × %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::OverrideControl</name>
    <message>
        <source>Path override of this run, in percent of the programmed feed. The override of the machine&apos;s own switch multiplies. Ctrl++ and Ctrl+- are a step of 5 %.</source>
        <translation>Correction d&apos;avance de cette exécution, en pour cent de l&apos;avance programmée. Le potentiomètre de la machine multiplie. Ctrl++ et Ctrl+- font un pas de 5 %.</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Correction d&apos;avance</translation>
    </message>
    <message>
        <source>Override: 5 % less</source>
        <translation>Correction d&apos;avance : 5 % de moins</translation>
    </message>
    <message>
        <source>Override: 5 % more</source>
        <translation>Correction d&apos;avance : 5 % de plus</translation>
    </message>
    <message>
        <source>Override %1 %</source>
        <translation>Avance %1 %</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ParallelPage</name>
    <message>
        <source>Petri net</source>
        <translation>Réseau de Petri</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tâches</translation>
    </message>
    <message>
        <source>Part of the page</source>
        <translation>Partie de la page</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathPane</name>
    <message>
        <source>The path during the time shown. Click: cursor A. Shift and click: cursor B. In 3D, drag or the arrow keys turn it, Home turns it back.</source>
        <translation>La trajectoire du temps affiché. Clic&#xa0;: curseur A. Maj et clic&#xa0;: curseur B. En 3D, glisser ou les flèches la tournent, Début la remet.</translation>
    </message>
    <message>
        <source>Path of the axes</source>
        <translation>Trajectoire des axes</translation>
    </message>
    <message>
        <source>%1: no values here</source>
        <translation>%1&#xa0;: pas de valeurs ici</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Erreur × %1</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>No X and Y here</source>
        <translation>Pas de X ni de Y ici</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathPanel</name>
    <message>
        <source>Line %1 was executed %2 times. Cursor A is at number %3; click again for the next.</source>
        <translation>La ligne %1 a été exécutée %2 fois. Le curseur A est au numéro %3&#xa0;; un autre clic mène au suivant.</translation>
    </message>
    <message>
        <source>The line under cursor A is marked. A click on a line puts cursor A where it was executed.</source>
        <translation>La ligne sous le curseur A est marquée. Un clic sur une ligne place le curseur A là où elle a été exécutée.</translation>
    </message>
    <message>
        <source>Text of the program</source>
        <translation>Texte du programme</translation>
    </message>
    <message>
        <source>The signal that gives the path its colours</source>
        <translation>Le signal qui donne ses couleurs à la trajectoire</translation>
    </message>
    <message>
        <source>Colour of the path</source>
        <translation>Couleur de la trajectoire</translation>
    </message>
    <message>
        <source>Enlargement of the error</source>
        <translation>Agrandissement de l’erreur</translation>
    </message>
    <message>
        <source>Seen from the side; drag the path or press the arrow keys to turn it</source>
        <translation>Vue de côté&#xa0;; glisser la trajectoire ou appuyer sur les flèches pour la tourner</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>X and Y, seen from above</source>
        <translation>X et Y, vus du dessus</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>A click on a line puts cursor A where it was executed.</source>
        <translation>Un clic sur une ligne place le curseur A là où elle a été exécutée.</translation>
    </message>
    <message>
        <source>Nothing moved in line %1.</source>
        <translation>Rien n’a bougé à la ligne %1.</translation>
    </message>
    <message>
        <source>The trace does not show where it is in the program.</source>
        <translation>La trace ne montre pas où elle se trouve dans le programme.</translation>
    </message>
    <message>
        <source>Comparing the trace with the program …</source>
        <translation>Comparaison de la trace avec le programme…</translation>
    </message>
    <message>
        <source>The run was made with another program or another version of it. Open that one to see its lines with the cursor.</source>
        <translation>L’exécution a été faite avec un autre programme ou une autre version. Ouvrir celui-là pour voir ses lignes avec le curseur.</translation>
    </message>
    <message>
        <source>Lines and trace are linked when a trace is shown.</source>
        <translation>Lignes et trace sont liées dès qu’une trace est affichée.</translation>
    </message>
    <message>
        <source>Open the NC program of the trace to see its lines with the cursor.</source>
        <translation>Ouvrir le programme CN de la trace pour voir ses lignes avec le curseur.</translation>
    </message>
    <message>
        <source>Errors can be drawn larger after the trace has been compared with its NC program</source>
        <translation>Les erreurs peuvent être agrandies après la comparaison de la trace avec son programme CN</translation>
    </message>
    <message>
        <source>How many times larger the distance to the programmed path is drawn</source>
        <translation>Combien de fois plus grande la distance à la trajectoire programmée est dessinée</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Erreur × %1</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>Couleur&#xa0;: %1</translation>
    </message>
    <message>
        <source>Colour: the trace</source>
        <translation>Couleur&#xa0;: la trace</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathView</name>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Show the whole path (double click does the same)</source>
        <translation>Afficher toute la trajectoire (comme un double clic)</translation>
    </message>
    <message>
        <source>No program is loaded</source>
        <translation>Aucun programme n’est chargé</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Rapide</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Exécuté</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Couleur selon</translation>
    </message>
    <message>
        <source>Kind of move</source>
        <translation>Type de mouvement</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Margin of the method</source>
        <translation>Marge de la méthode</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>by point</source>
        <translation>par point</translation>
    </message>
    <message>
        <source>by time</source>
        <translation>par temps</translation>
    </message>
    <message>
        <source>Walk along the path</source>
        <translation>Parcourir la trajectoire</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>Arc</translation>
    </message>
    <message>
        <source>Spline</source>
        <translation>Spline</translation>
    </message>
    <message>
        <source>no feed given</source>
        <translation>avance non indiquée</translation>
    </message>
    <message>
        <source>margin over %1</source>
        <translation>marge supérieure à %1</translation>
    </message>
    <message>
        <source>not kept (below %1)</source>
        <translation>non respectée (inférieure à %1)</translation>
    </message>
    <message>
        <source>Click on the path or move the slider.</source>
        <translation>Cliquer sur la trajectoire ou déplacer le curseur.</translation>
    </message>
    <message>
        <source>Point %1 of %2, line %3</source>
        <translation>Point %1 sur %2, ligne %3</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calcul en cours…</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>jusqu’à %1</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pauses</translation>
    </message>
    <message>
        <source>Mark where the run will pause</source>
        <translation>Marquer où l’exécution fera une pause</translation>
    </message>
    <message>
        <source>Pause off the cut, after point %1, line %2</source>
        <translation>Pause hors coupe, après le point %1, ligne %2</translation>
    </message>
    <message>
        <source>Pause in the cut, after point %1, line %2</source>
        <translation>Pause en coupe, après le point %1, ligne %2</translation>
    </message>
    <message>
        <source>%1 in the cut</source>
        <translation>%1 en coupe</translation>
    </message>
    <message>
        <source>then a pause in the cut</source>
        <translation>puis une pause en coupe</translation>
    </message>
    <message>
        <source>then a pause off the cut</source>
        <translation>puis une pause hors coupe</translation>
    </message>
    <message>
        <source>Density of pauses</source>
        <translation>Densité des pauses</translation>
    </message>
    <message>
        <source>no pause</source>
        <translation>sans pause</translation>
    </message>
    <message>
        <source>a pause every %1</source>
        <translation>une pause tous les %1</translation>
    </message>
    <message>
        <source>By the control</source>
        <translation>Par la commande</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>Changement d’outil</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pauses off the cut</source>
        <translation>
            <numerusform>%Ln pause hors coupe</numerusform>
            <numerusform>%Ln pauses hors coupe</numerusform>
        </translation>
    </message>
    <message>
        <source>The points appear here as they come</source>
        <translation>Les points apparaissent ici à leur arrivée</translation>
    </message>
    <message>
        <source>Grid %1</source>
        <translation>Grille %1</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Drag or press the arrow keys to turn it; with Shift, dragging moves it</source>
        <translation>Glisser ou les flèches la tournent ; avec Maj, glisser la déplace</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>From above: X, Y</source>
        <translation>De dessus : X, Y</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>From the front: X, Z</source>
        <translation>De face : X, Z</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>From the right: Y, Z</source>
        <translation>De droite : Y, Z</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PositionLine</name>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>No data</source>
        <translation>Pas de données</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En direct</translation>
    </message>
    <message>
        <source>Last executed point, %1. The axes were read %2 ago.</source>
        <translation>Dernier point exécuté, %1. Les axes ont été lus il y a %2.</translation>
    </message>
    <message>
        <source>Old: read %1 ago</source>
        <translation>Ancien&#xa0;: lu il y a %1</translation>
    </message>
    <message>
        <source>to go %1</source>
        <translation>reste %1</translation>
    </message>
    <message>
        <source>Distance to go: not known, because the stream leaves no time to read the axes.</source>
        <translation>Distance restante&#xa0;: inconnue, car la transmission ne laisse pas le temps de lire les axes.</translation>
    </message>
    <message>
        <source>Distance to go: not known. The axes are not on the path of the program, or it is being corrected.</source>
        <translation>Distance restante&#xa0;: inconnue. Les axes ne sont pas sur la trajectoire du programme, ou elle est en cours de correction.</translation>
    </message>
    <message>
        <source>Distance to go: the control does not report it.</source>
        <translation>Distance restante&#xa0;: la commande ne l’indique pas.</translation>
    </message>
    <message>
        <source>Distance to go to the end of the move in progress, from the position that was read and the path of the program</source>
        <translation>Distance restante jusqu’à la fin du mouvement en cours, d’après la position lue et la trajectoire du programme</translation>
    </message>
    <message>
        <source>Distance to go to the end of the block, as the control reports it</source>
        <translation>Distance restante jusqu’à la fin du bloc, indiquée par la commande</translation>
    </message>
    <message>
        <source>set %1</source>
        <translation>cons. %1</translation>
    </message>
    <message>
        <source>The feed override at the control is not read; it acts in addition.</source>
        <translation>L’override d’avance de la commande n’est pas lu&#xa0;; il agit en plus.</translation>
    </message>
    <message>
        <source>Commanded feed: not known, because no run of this window is in progress.</source>
        <translation>Avance de consigne&#xa0;: inconnue, car aucune exécution de cette fenêtre n’est en cours.</translation>
    </message>
    <message>
        <source>Feed of the program, scaled by the override of the run. %1</source>
        <translation>Avance du programme, avec l’override de l’exécution. %1</translation>
    </message>
    <message>
        <source>One feed for all moves, without an override. %1</source>
        <translation>Une avance pour tous les mouvements, sans override. %1</translation>
    </message>
    <message>
        <source>Up to 1 s old: no time to read more often</source>
        <translation>Âgé de 1 s au plus&#xa0;: pas le temps de lire plus souvent</translation>
    </message>
    <message>
        <source>No tool in the spindle</source>
        <translation>Aucun outil dans la broche</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Outil %1</translation>
    </message>
    <message>
        <source>cutting edge D%1</source>
        <translation>arête de coupe D%1</translation>
    </message>
    <message>
        <source>work offset %1</source>
        <translation>décalage d’origine %1</translation>
    </message>
    <message>
        <source>Spindle: actual %1, commanded %2 1/min</source>
        <translation>Broche&#xa0;: réelle %1, commandée %2 tr/min</translation>
    </message>
    <message>
        <source>clockwise (M3)</source>
        <translation>sens horaire (M3)</translation>
    </message>
    <message>
        <source>counterclockwise (M4)</source>
        <translation>sens antihoraire (M4)</translation>
    </message>
    <message>
        <source>direction not known</source>
        <translation>sens de rotation inconnu</translation>
    </message>
    <message>
        <source>coolant off</source>
        <translation>arrosage arrêté</translation>
    </message>
    <message>
        <source>coolant on (%1)</source>
        <translation>arrosage en marche (%1)</translation>
    </message>
    <message>
        <source>coolant not known</source>
        <translation>arrosage inconnu</translation>
    </message>
    <message>
        <source>%1. The control reports it, about once a second.</source>
        <translation>%1. La commande le signale, environ une fois par seconde.</translation>
    </message>
    <message>
        <source>%1. Read %2 ago: it may have changed since.</source>
        <translation>%1. Lu il y a %2&#xa0;: cela a pu changer depuis.</translation>
    </message>
    <message>
        <source>Live, but tool and spindle: read %1 ago</source>
        <translation>En direct, mais outil et broche&#xa0;: lus il y a %1</translation>
    </message>
    <message>
        <source>Read %1 ago: the run is being prepared</source>
        <translation>Lu il y a %1&#xa0;: l’exécution se prépare</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PreflightSheet</name>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the machine moves.</source>
        <translation>Rien n’a encore bougé. Maintenir Démarrer une seconde&#xa0;: alors la machine se déplace.</translation>
    </message>
    <message>
        <source>Start is not possible yet.</source>
        <translation>Le démarrage n’est pas encore possible.</translation>
    </message>
    <message>
        <source>Before the start</source>
        <translation>Avant le démarrage</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Pas maintenant</translation>
    </message>
    <message>
        <source>Resuming is not possible yet.</source>
        <translation>La reprise n’est pas encore possible.</translation>
    </message>
    <message>
        <source>Before the run is resumed</source>
        <translation>Avant la reprise de l’exécution</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Réussi</translation>
    </message>
    <message numerus="yes">
        <source>%Ln checks: %1</source>
        <translation>
            <numerusform>%Ln contrôle : %1</numerusform>
            <numerusform>%Ln contrôles : %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Replier</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold the button below for one second: then the machine moves.</source>
        <translation>Rien n’a encore bougé. Maintenir une seconde le bouton ci-dessous&#xa0;: alors la machine se déplace.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the tool is raised, and nothing else.</source>
        <translation>Rien n&apos;a encore bougé. Maintenez Démarrer une seconde : l&apos;outil est alors relevé, et rien d&apos;autre.</translation>
    </message>
    <message>
        <source>Before the tool is raised</source>
        <translation>Avant de relever l&apos;outil</translation>
    </message>
    <message>
        <source>First move</source>
        <translation>Premier mouvement</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the tool goes back along the path, and nothing else.</source>
        <translation>Rien n’a encore bougé. Maintenez Démarrer une seconde&#xa0;: alors l’outil revient sur la trajectoire, et rien d’autre.</translation>
    </message>
    <message>
        <source>Before the tool goes back</source>
        <translation>Avant le retour de l’outil</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProfilePage</name>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Outil %1</translation>
    </message>
    <message>
        <source>Number of the tool</source>
        <translation>Numéro de l’outil</translation>
    </message>
    <message>
        <source>Entered by %1 on %2.</source>
        <translation>Saisi par %1 le %2.</translation>
    </message>
    <message>
        <source>Nobody has entered the limits of this machine. Feeds and simulations take those of the machine in the paper: %1.</source>
        <translation>Personne n’a saisi les limites de cette machine. Avances et simulations prennent celles de la machine de l’article&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Pas encore enregistré.</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Nom de la machine</translation>
    </message>
    <message>
        <source>Simulated as</source>
        <translation>Simulée comme</translation>
    </message>
    <message>
        <source>Take over its limits</source>
        <translation>Reprendre ses limites</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Travel from</source>
        <translation>Course de</translation>
    </message>
    <message>
        <source>Travel to</source>
        <translation>Course à</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Jerk</translation>
    </message>
    <message>
        <source>Rapid, mm/min</source>
        <translation>Rapide, mm/min</translation>
    </message>
    <message>
        <source>Spindle up to, 1/min</source>
        <translation>Broche jusqu’à, 1/min</translation>
    </message>
    <message>
        <source>0: no spindle</source>
        <translation>0&#xa0;: pas de broche</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Longueur, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Rayon, mm</translation>
    </message>
    <message>
        <source>Add a tool</source>
        <translation>Ajouter un outil</translation>
    </message>
    <message>
        <source>Save the limits</source>
        <translation>Enregistrer les limites</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Abandonner les modifications</translation>
    </message>
    <message>
        <source>M functions: write the number, an equals sign, and ignore, pass or a line for the control. Separate entries with semicolons.</source>
        <translation>Fonctions M&#xa0;: écrire un numéro, = et ignore, pass ou une ligne pour la commande&#x202f;; un point-virgule entre deux.</translation>
    </message>
    <message>
        <source>M functions of other machines</source>
        <translation>Fonctions M d’autres machines</translation>
    </message>
    <message>
        <source>What this machine does for the M functions of programs made for another: ignore leaves the function out, pass gives it to the control, anything else is a line for it.</source>
        <translation>Ce que cette machine fait pour les fonctions M de programmes faits pour une autre&#xa0;: ignore omet la fonction, pass la donne à la commande, toute autre chose est une ligne pour elle.</translation>
    </message>
    <message>
        <source>When nothing has come from this computer for so long, the axes stand on the path until it gives a sign again. 0: not at all.</source>
        <translation>Si rien n&apos;est venu de cet ordinateur pendant ce temps, les axes s&apos;arrêtent sur la trajectoire jusqu&apos;à ce qu&apos;il se manifeste à nouveau. 0 : jamais.</translation>
    </message>
    <message>
        <source>Without this computer the axes stand after, s</source>
        <translation>Sans cet ordinateur, les axes s&apos;arrêtent après, s</translation>
    </message>
    <message>
        <source>Where a stop is sure to act only before the next window, because this control has not passed the stop test, no window of several moves takes longer.</source>
        <translation>Là où un arrêt n’agit sûrement qu’avant la fenêtre suivante, parce que cette commande n’a pas réussi le test d’arrêt, aucune fenêtre de plusieurs mouvements ne dure plus longtemps.</translation>
    </message>
    <message>
        <source>Without a passed stop test a window takes at most, s</source>
        <translation>Sans test d’arrêt réussi, une fenêtre dure au plus, s</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramPage</name>
    <message>
        <source>Program text</source>
        <translation>Texte du programme</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramPanel</name>
    <message>
        <source>Open an NC program</source>
        <translation>Ouvrir un programme CN</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Données</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Observations</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Lignes</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Mouvements</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Cutting path</source>
        <translation>Parcours en coupe</translation>
    </message>
    <message>
        <source>Rapid path</source>
        <translation>Parcours en rapide</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>Avances</translation>
    </message>
    <message>
        <source>Smallest distance of neighbouring points</source>
        <translation>Plus petite distance entre points voisins</translation>
    </message>
    <message>
        <source>Smallest path length of half a loop (N/2 points, rounded down)</source>
        <translation>Plus petite longueur d’une demi-boucle (N/2 points, arrondi par défaut)</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Aucun programme</translation>
    </message>
    <message>
        <source>Drop a file here or press Open…</source>
        <translation>Déposer un fichier ici ou appuyer sur Ouvrir…</translation>
    </message>
    <message>
        <source>Hash %1</source>
        <translation>Empreinte %1</translation>
    </message>
    <message>
        <source>Errors: %1, warnings: %2, notes: %3</source>
        <translation>Erreurs&#xa0;: %1, avertissements&#xa0;: %2, remarques&#xa0;: %3</translation>
    </message>
    <message>
        <source>Cannot be streamed.</source>
        <translation>Non transmissible en continu.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>lines %1–%2</source>
        <translation>lignes %1–%2</translation>
    </message>
    <message>
        <source>No findings</source>
        <translation>Aucune observation</translation>
    </message>
    <message>
        <source>NC programs (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap *.cnc *.gcode *.h *.H *.txt)</source>
        <translation>Programmes CN (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap *.cnc *.gcode *.h *.H *.txt)</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialecte</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>Accepter…</translation>
    </message>
    <message>
        <source>The program is read again with this word left out</source>
        <translation>Le programme est relu sans ce mot</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>By kind</source>
        <translation>Par type</translation>
    </message>
    <message>
        <source>Time, feeds as programmed</source>
        <translation>Temps, avances programmées</translation>
    </message>
    <message>
        <source>Time, as streamed</source>
        <translation>Temps, en transmission</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distances</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Angles</translation>
    </message>
    <message>
        <source>Distances of neighbouring points, mm</source>
        <translation>Distances entre points voisins, mm</translation>
    </message>
    <message>
        <source>%1 (repetitions left out: %2)</source>
        <translation>%1 (répétitions omises&#xa0;: %2)</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>mm and inch</source>
        <translation>mm et pouce</translation>
    </message>
    <message>
        <source>lines %1</source>
        <translation>droites %1</translation>
    </message>
    <message>
        <source>arcs %1</source>
        <translation>arcs %1</translation>
    </message>
    <message>
        <source>splines %1</source>
        <translation>splines %1</translation>
    </message>
    <message>
        <source>median %1, largest %2</source>
        <translation>médiane %1, maximum %2</translation>
    </message>
    <message>
        <source>%1 of 45° and more; sharpest %2° (%3)</source>
        <translation>%1 de 45° et plus&#xa0;; le plus vif %2° (%3)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Observations (%1)</translation>
    </message>
    <message>
        <source>%1 without pauses</source>
        <translation>%1 sans pauses</translation>
    </message>
    <message>
        <source>as detected</source>
        <translation>comme détecté</translation>
    </message>
    <message>
        <source>Read as %1, as selected.</source>
        <translation>Lu comme %1, selon le choix fait.</translation>
    </message>
    <message>
        <source>Read as %1: the text gives no evidence of its dialect.</source>
        <translation>Lu comme %1&#xa0;: rien dans le texte n’indique son dialecte.</translation>
    </message>
    <message>
        <source>Read as %1 because of &quot;%2&quot;.</source>
        <translation>Lu comme %1 à cause de «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Accepté&#xa0;: %1</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Take back %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>Accept %1</source>
        <translation>Accepter %1</translation>
    </message>
    <message>
        <source>Rivulet does not understand %1. If you accept it, it is left out wherever the program has it, and the path is taken as if it were not there.

Is it certain that %1 does not change the path of the tool?</source>
        <translation>Rivulet ne comprend pas %1. Si vous l’acceptez, ce mot est omis partout dans le programme, et la trajectoire est calculée comme s’il n’y était pas.

Est-il certain que %1 ne change pas la trajectoire de l’outil&#xa0;?</translation>
    </message>
    <message>
        <source>Accept and read again</source>
        <translation>Accepter et relire</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calcul en cours…</translation>
    </message>
    <message>
        <source>Computed with the axes of %1</source>
        <translation>Calculé avec les axes de %1</translation>
    </message>
    <message>
        <source>I, J, K are read as the centre itself</source>
        <translation>I, J, K sont lus comme le centre lui-même</translation>
    </message>
    <message>
        <source>I, J, K are read from the centre to the start</source>
        <translation>I, J, K sont lus du centre vers le départ</translation>
    </message>
    <message>
        <source>Read I, J, K as usual</source>
        <translation>Lire I, J, K comme d’habitude</translation>
    </message>
    <message>
        <source>Read it that way</source>
        <translation>Lire ainsi</translation>
    </message>
    <message>
        <source>Cannot be streamed: no axis moves.</source>
        <translation>Ne peut pas être transmis&#xa0;: aucun axe ne bouge.</translation>
    </message>
    <message>
        <source>Cannot be streamed: it needs a transformation of the control.</source>
        <translation>Ne peut pas être transmis&#xa0;: une transformation de la commande est nécessaire.</translation>
    </message>
    <message numerus="yes">
        <source>%1 … %2 (%Ln values)</source>
        <translation>
            <numerusform>%1 … %2 (%Ln valeur)</numerusform>
            <numerusform>%1 … %2 (%Ln valeurs)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 with %Ln pauses, which cost %2</source>
        <translation>
            <numerusform>%1 avec %Ln pause, qui coûte %2</numerusform>
            <numerusform>%1 avec %Ln pauses, qui coûtent %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Live …</source>
        <translation>En direct…</translation>
    </message>
    <message>
        <source>Points that another program computes while the machine moves</source>
        <translation>Points qu’un autre programme calcule pendant que la machine bouge</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texte</translation>
    </message>
    <message numerus="yes">
        <source>%Ln lines</source>
        <translation>
            <numerusform>%Ln ligne</numerusform>
            <numerusform>%Ln lignes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramTextView</name>
    <message>
        <source>No program is loaded</source>
        <translation>Aucun programme n’est chargé</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ReadingBar</name>
    <message>
        <source>a %1 goes to %2 mm</source>
        <translation>une %1 va à %2 mm</translation>
    </message>
    <message>
        <source>a %1 does not move</source>
        <translation>une %1 ne se déplace pas</translation>
    </message>
    <message>
        <source>Nothing shows for which control this program was made. From line %1 on, %2. Which is it?</source>
        <translation>Rien n’indique pour quelle commande ce programme a été fait. À partir de la ligne %1&#xa0;: %2. Laquelle est-ce&#xa0;?</translation>
    </message>
    <message>
        <source>The program does not say whether it is in mm or inch. Its size in mm, or in inch: %1.</source>
        <translation>Le programme ne dit pas s’il est en mm ou en pouces. Sa taille en mm, ou en pouces&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Coordinates have no decimal point. Some controls count them in thousandths. The size as whole units, or as thousandths: %1.</source>
        <translation>Les coordonnées n’ont pas de point décimal. Certaines commandes les comptent en millièmes. La taille en unités entières, ou en millièmes&#xa0;: %1.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pouce</translation>
    </message>
    <message>
        <source>Whole units</source>
        <translation>Unités entières</translation>
    </message>
    <message>
        <source>Thousandths</source>
        <translation>Millièmes</translation>
    </message>
    <message>
        <source>Take them</source>
        <translation>Les prendre</translation>
    </message>
    <message>
        <source>The program leaves values to settings of the control. Enter those of the machine, or take those of a virtual machine.</source>
        <translation>Le programme laisse des valeurs aux réglages de la commande. Saisissez ceux de la machine, ou prenez ceux d’une machine virtuelle.</translation>
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
        <translation>N, points par boucle</translation>
    </message>
    <message>
        <source>δ, mm</source>
        <translation>δ, mm</translation>
    </message>
    <message>
        <source>reach</source>
        <translation>portée</translation>
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
        <translation>t_min, ms&#xa0;: mouvement le plus court à 100&#xa0;%</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ReportPanel</name>
    <message>
        <source>Run</source>
        <translation>Exécution</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pauses</translation>
    </message>
    <message>
        <source>Access time per variable</source>
        <translation>Temps d’accès par variable</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Exécutés</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Répétés</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Sautés</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Hors du programme</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Requêtes</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Médiane</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>95e centile</translation>
    </message>
    <message>
        <source>99th percentile</source>
        <translation>99e centile</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Stop confirmed</source>
        <translation>Arrêt confirmé</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Aucune exécution</translation>
    </message>
    <message>
        <source>%1 of %2 (not judged: longer than the trace of the control)</source>
        <translation>%1 sur %2 (non évalué&#xa0;: plus long que l’enregistrement de la commande)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>%1 of %2 (not judged: no trace of the control)</source>
        <translation>%1 sur %2 (non évalué&#xa0;: pas d’enregistrement de la commande)</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non évalué</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>après %1</translation>
    </message>
    <message>
        <source>NOT confirmed: check the machine</source>
        <translation>NON confirmé&#xa0;: contrôler la machine</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>%1, from point %2 on</source>
        <translation>%1, à partir du point %2</translation>
    </message>
    <message>
        <source>%1 (proved)</source>
        <translation>%1 (éprouvé)</translation>
    </message>
    <message>
        <source>Time spent</source>
        <translation>Répartition du temps</translation>
    </message>
    <message>
        <source>Live lines</source>
        <translation>Lignes en direct</translation>
    </message>
    <message>
        <source>Delay from arrival to motion</source>
        <translation>Délai de l’arrivée au mouvement</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ResponsePanel</name>
    <message>
        <source>Bode plot: gain</source>
        <translation>Diagramme de Bode&#xa0;: gain</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Fréquence, Hz</translation>
    </message>
    <message>
        <source>Gain, dB</source>
        <translation>Gain, dB</translation>
    </message>
    <message>
        <source>Bode plot: phase</source>
        <translation>Diagramme de Bode&#xa0;: phase</translation>
    </message>
    <message>
        <source>Phase, °</source>
        <translation>Phase, °</translation>
    </message>
    <message>
        <source>Answer to a step of 1 mm</source>
        <translation>Réponse à un échelon de 1 mm</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Temps, s</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Position, mm</translation>
    </message>
    <message>
        <source>%1 follows up to %2 Hz (−3 dB).</source>
        <translation>%1 suit jusqu’à %2 Hz (−3 dB).</translation>
    </message>
    <message>
        <source>From set point to actual position; the Bode plot is without friction.</source>
        <translation>De la consigne à la position réelle&#xa0;; le diagramme de Bode sans frottement.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ResumeBar</name>
    <message>
        <source>Not now</source>
        <translation>Pas maintenant</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Asking the control where the run was left …</source>
        <translation>On demande à la commande où l’exécution s’est interrompue…</translation>
    </message>
    <message>
        <source>The run cannot be resumed: %1</source>
        <translation>L’exécution ne peut pas être reprise&#xa0;: %1</translation>
    </message>
    <message>
        <source>Press and hold: resume at point %1</source>
        <translation>Maintenir appuyé&#xa0;: reprise au point %1</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Maintenir une seconde. Alors la machine se déplace.</translation>
    </message>
    <message>
        <source>Press and hold: start at point %1</source>
        <translation>Maintenir appuyé&#xa0;: départ au point %1</translation>
    </message>
    <message>
        <source>Press and hold: go on with the job</source>
        <translation>Maintenir appuyé&#xa0;: poursuivre la tâche</translation>
    </message>
    <message numerus="yes">
        <source>Before that, the control executes %Ln blocks: see the list.</source>
        <translation>
            <numerusform>Avant cela, la commande exécute %Ln bloc&#xa0;: voir la liste.</numerusform>
            <numerusform>Avant cela, la commande exécute %Ln blocs&#xa0;: voir la liste.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing has moved yet. The run will start at point %1 of %2, where line %3 begins: %4.</source>
        <translation>Rien n’a encore bougé. L’exécution commencera au point %1 sur %2, au début de la ligne %3&#xa0;: %4.</translation>
    </message>
    <message>
        <source>The tool first moves %1 in a straight line to that point.</source>
        <translation>L’outil parcourt d’abord %1 en ligne droite jusqu’à ce point.</translation>
    </message>
    <message>
        <source>From point %1 on, the program differs from that of the interrupted run. None of these points has been executed: check the new path before you go on.</source>
        <translation>À partir du point %1, le programme diffère de celui de l’exécution interrompue. Aucun de ces points n’a été exécuté&#xa0;: vérifier la nouvelle trajectoire avant de continuer.</translation>
    </message>
    <message>
        <source>The program still stands on the control: first it executes the rest of its window, at most %1, and ends.</source>
        <translation>Le programme est encore arrêté sur la commande&#xa0;: il exécute d’abord le reste de sa fenêtre, au plus %1, et se termine.</translation>
    </message>
    <message>
        <source>The program still stands on the control, between its windows: it ends without a move.</source>
        <translation>Le programme est encore arrêté sur la commande, entre ses fenêtres&#xa0;: il se termine sans mouvement.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The job will go on in part %1 at point %2 of %3, line %4.</source>
        <translation>Rien n’a encore bougé. La tâche reprendra au tronçon %1, point %2 sur %3, ligne %4.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The job will go on at line %1: %2.</source>
        <translation>Rien n’a encore bougé. La tâche reprendra à la ligne %1&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The run will resume at point %1 of %2, line %3: %4.</source>
        <translation>Rien n’a encore bougé. L’exécution reprendra au point %1 sur %2, ligne %3&#xa0;: %4.</translation>
    </message>
    <message>
        <source>Then the tool moves %1 in a straight line to that point.</source>
        <translation>Ensuite l’outil parcourt %1 en ligne droite jusqu’à ce point.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RightsPage</name>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manque</translation>
    </message>
    <message>
        <source>given</source>
        <translation>accordé</translation>
    </message>
    <message>
        <source>Asking the control …</source>
        <translation>Interrogation de la commande…</translation>
    </message>
    <message>
        <source>A run is not possible with these rights.</source>
        <translation>Aucune exécution n’est possible avec ces droits.</translation>
    </message>
    <message>
        <source>A run is possible; some steps remain to the operator.</source>
        <translation>Une exécution est possible&#xa0;; quelques étapes restent à l’opérateur.</translation>
    </message>
    <message>
        <source>This user has all rights that a run needs.</source>
        <translation>Cet utilisateur a tous les droits dont une exécution a besoin.</translation>
    </message>
    <message>
        <source>More than a run needs: %1. Call DeleteUserAccess with them, or use a user of its own for Rivulet.</source>
        <translation>Plus que ce dont une exécution a besoin&#xa0;: %1. Appeler DeleteUserAccess avec eux, ou donner à Rivulet son propre utilisateur.</translation>
    </message>
    <message>
        <source>The server does not tell which other rights this user has. Look at the list of users on the control.</source>
        <translation>Le serveur ne dit pas quels autres droits a cet utilisateur. Consulter la liste des utilisateurs sur la commande.</translation>
    </message>
    <message>
        <source>Asks the control which of the rights that a run needs the user of this connection has. Nothing is changed.</source>
        <translation>Demande à la commande lesquels des droits dont une exécution a besoin possède l’utilisateur de cette connexion. Rien n’est modifié.</translation>
    </message>
    <message>
        <source>Check the rights</source>
        <translation>Vérifier les droits</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunPanel</name>
    <message>
        <source>Stop</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Exécutés</translation>
    </message>
    <message>
        <source>Start is not possible: %1</source>
        <translation>Démarrage impossible&#xa0;: %1</translation>
    </message>
    <message>
        <source>Ready to start</source>
        <translation>Prêt à démarrer</translation>
    </message>
    <message>
        <source>Stop confirmed after %1</source>
        <translation>Arrêt confirmé après %1</translation>
    </message>
    <message>
        <source>Stop confirmed</source>
        <translation>Arrêt confirmé</translation>
    </message>
    <message>
        <source>Stop NOT confirmed: check the machine</source>
        <translation>Arrêt NON confirmé&#xa0;: contrôler la machine</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Reprendre…</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>The machine waits before the next window until you press Continue.</source>
        <translation>La machine attend avant la fenêtre suivante jusqu’à l’appui sur Continuer.</translation>
    </message>
    <message>
        <source>Only method window can hold.</source>
        <translation>Seule la méthode Fenêtre peut suspendre.</translation>
    </message>
    <message>
        <source>Waiting for the test of the template on the virtual machine</source>
        <translation>Attend le test du modèle sur la machine virtuelle</translation>
    </message>
    <message>
        <source>Waiting for the transfer of the template to the control</source>
        <translation>Attend le transfert du modèle vers la commande</translation>
    </message>
    <message>
        <source>Waiting for cycle start at the control</source>
        <translation>Attend Départ cycle sur la commande</translation>
    </message>
    <message>
        <source>Waiting for selection of the template and cycle start at the control</source>
        <translation>Attend la sélection du modèle et Départ cycle sur la commande</translation>
    </message>
    <message>
        <source>Nothing comes from the control. Check cable, switch and server.</source>
        <translation>Rien ne vient de la commande. Vérifier le câble, le switch et le serveur.</translation>
    </message>
    <message>
        <source>Waiting for the control&apos;s own trace</source>
        <translation>Attend l’enregistrement de la commande</translation>
    </message>
    <message>
        <source>Waiting for %1</source>
        <translation>Attend %1</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Maintenir appuyé</translation>
    </message>
    <message>
        <source>Start over …</source>
        <translation>Du début…</translation>
    </message>
    <message>
        <source>Start …</source>
        <translation>Démarrer…</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Maintenir une seconde. Alors la machine se déplace.</translation>
    </message>
    <message>
        <source>Shows what will happen first. Nothing moves yet.</source>
        <translation>Montre d’abord ce qui va se passer. Rien ne bouge encore.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>Pas prêt</translation>
    </message>
    <message>
        <source>Stopped at %1</source>
        <translation>Arrêté à %1</translation>
    </message>
    <message>
        <source>Failed at %1</source>
        <translation>Échec à %1</translation>
    </message>
    <message>
        <source>Wrong motion</source>
        <translation>Mouvement erroné</translation>
    </message>
    <message>
        <source>The run has executed wrong points: see the report.</source>
        <translation>L’exécution a fait des points erronés&#xa0;: voir le rapport.</translation>
    </message>
    <message>
        <source>Resume goes on where the run was left.</source>
        <translation>Reprendre continue à cet endroit.</translation>
    </message>
    <message>
        <source>A new start begins at the first point.</source>
        <translation>Un nouveau démarrage commence au premier point.</translation>
    </message>
    <message>
        <source>Waiting until the claim of another client lapses, because it may be dead (10 s)</source>
        <translation>Attend que la réservation d’un autre client expire, car il est peut-être hors service (10 s)</translation>
    </message>
    <message>
        <source>Wrong motion. %1</source>
        <translation>Mouvement erroné. %1</translation>
    </message>
    <message>
        <source>Watching run %1: it waits</source>
        <translation>Observe l’exécution %1&#xa0;: elle attend</translation>
    </message>
    <message>
        <source>Watching run %1</source>
        <translation>Observe l’exécution %1</translation>
    </message>
    <message>
        <source>A program waits on the control</source>
        <translation>Un programme attend sur la commande</translation>
    </message>
    <message>
        <source>Run %1 is on the control</source>
        <translation>L’exécution %1 est sur la commande</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>Points that are known to be executed</source>
        <translation>Points dont on sait qu’ils sont exécutés</translation>
    </message>
    <message>
        <source>Only the computer that streams this run knows it.</source>
        <translation>Seul l’ordinateur qui transmet cette exécution le sait.</translation>
    </message>
    <message>
        <source>No program is loaded.</source>
        <translation>Aucun programme n’est chargé.</translation>
    </message>
    <message>
        <source>No point has been executed yet.</source>
        <translation>Aucun point n’a encore été exécuté.</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>L’exécution est terminée.</translation>
    </message>
    <message>
        <source>The time of the run is not estimated yet. During a run nothing is estimated.</source>
        <translation>La durée de l’exécution n’est pas encore estimée. Rien n’est estimé pendant une exécution.</translation>
    </message>
    <message>
        <source>%1, pauses %2</source>
        <translation>%1, pauses %2</translation>
    </message>
    <message>
        <source>Estimate of the time that is left, with the feeds and the planned pauses of this run. Hold and the feed override at the control are not included.</source>
        <translation>Temps restant estimé, avec les avances et les pauses prévues de cette exécution. La suspension et l’override d’avance de la commande n’y sont pas compris.</translation>
    </message>
    <message>
        <source>No run of this window is in progress.</source>
        <translation>Aucune exécution de cette fenêtre n’est en cours.</translation>
    </message>
    <message>
        <source>%1: part %2 of %3</source>
        <translation>%1 : tronçon %2 sur %3</translation>
    </message>
    <message>
        <source>%1: the control, line %2</source>
        <translation>%1 : commande, ligne %2</translation>
    </message>
    <message>
        <source>%1: the control</source>
        <translation>%1 : commande</translation>
    </message>
    <message>
        <source>The program waits for cycle start at the control</source>
        <translation>Le programme attend le Départ cycle sur la commande</translation>
    </message>
    <message>
        <source>The job waits before the next block until you press Continue.</source>
        <translation>La tâche attend avant le bloc suivant jusqu’à l’appui sur Continuer.</translation>
    </message>
    <message>
        <source>Before part %1 of %2</source>
        <translation>Avant le tronçon %1 sur %2</translation>
    </message>
    <message>
        <source>After the last part</source>
        <translation>Après le dernier tronçon</translation>
    </message>
    <message>
        <source>Streamed %1, pauses %2, tool changes %3, other blocks of the control %4. Cycles, measuring and stops are not included.</source>
        <translation>Transmis %1, pauses %2, changements d’outil %3, autres blocs de la commande %4. Les cycles, les mesures et les arrêts n’y sont pas.</translation>
    </message>
    <message>
        <source>%1, pauses %2, control %3</source>
        <translation>%1, pauses %2, commande %3</translation>
    </message>
    <message>
        <source>%1, control %2</source>
        <translation>%1, commande %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows</source>
        <translation>
            <numerusform>%Ln fenêtre</numerusform>
            <numerusform>%Ln fenêtres</numerusform>
        </translation>
    </message>
    <message>
        <source>Points that are known to be executed, from point %1 on</source>
        <translation>Points dont on sait qu’ils sont exécutés, à partir du point %1</translation>
    </message>
    <message>
        <source>%1, dry run</source>
        <translation>%1, essai à vide</translation>
    </message>
    <message>
        <source>The live source is silent or wants a hold. The run goes on with its next point.</source>
        <translation>La source en direct est muette ou veut une suspension. L’exécution continue avec son prochain point.</translation>
    </message>
    <message>
        <source>Waiting for points of the live source</source>
        <translation>Attend des points de la source en direct</translation>
    </message>
    <message>
        <source>A live source does not say when it ends.</source>
        <translation>Une source en direct ne dit pas quand elle se termine.</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Terminer ici</translation>
    </message>
    <message>
        <source>Hold for one second: the run ends. First the axes execute what the control still has of the window, with this override.</source>
        <translation>Maintenir une seconde : l&apos;exécution se termine. Auparavant, les axes exécutent avec cette avance ce que la commande a encore de la fenêtre.</translation>
    </message>
    <message>
        <source>What moves now does not obey the override. Press NC STOP at the machine.</source>
        <translation>Ce qui bouge maintenant n&apos;obéit pas à la correction d&apos;avance. Appuyez sur NC STOP à la machine.</translation>
    </message>
    <message>
        <source>Another client has set the override to %1 %</source>
        <translation>Un autre client a mis l&apos;avance à %1 %</translation>
    </message>
    <message>
        <source>The axes are braking</source>
        <translation>Les axes freinent</translation>
    </message>
    <message>
        <source>Override 0 %: the axes stand</source>
        <translation>Avance 0 % : les axes sont arrêtés</translation>
    </message>
    <message>
        <source>The axes stand at once, until you press Continue.</source>
        <translation>Les axes s&apos;arrêtent aussitôt, jusqu&apos;à ce que vous appuyiez sur Continuer.</translation>
    </message>
    <message>
        <source>The axes stand (%1 after the order). Continue goes on, End here ends the run</source>
        <translation>Les axes sont arrêtés (%1 après l&apos;ordre). Continuer reprend, Terminer ici termine l&apos;exécution</translation>
    </message>
    <message>
        <source>Stop and Pause act at the end of the block</source>
        <translation>Stop et Pause agissent à la fin du bloc</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Its axes are held until the run is ended or resumed.</source>
        <translation>Ses axes sont maintenus jusqu’à ce que l’exécution soit terminée ou reprise.</translation>
    </message>
    <message>
        <source>This window only shows it. Stop holds its axes.</source>
        <translation>Cette fenêtre ne fait que l’afficher. Arrêt maintient ses axes.</translation>
    </message>
    <message>
        <source>This window did not start it. Stop holds its axes.</source>
        <translation>Cette fenêtre ne l’a pas lancée. Arrêt maintient ses axes.</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves yet.</source>
        <translation>Demande à la commande où l’exécution s’est interrompue. Rien ne bouge encore.</translation>
    </message>
    <message>
        <source>Line of the live source of the move that the tool is on</source>
        <translation>Ligne de la source en direct du déplacement sur lequel se trouve l’outil</translation>
    </message>
    <message>
        <source>Line of the program of the move that the tool is on</source>
        <translation>Ligne du programme du déplacement sur lequel se trouve l’outil</translation>
    </message>
    <message>
        <source>The tool is lifted by %1. Lower it, then the run can go on</source>
        <translation>L’outil est relevé de %1. Redescendez-le, puis l’exécution pourra continuer</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Redescendre</translation>
    </message>
    <message>
        <source>Lift by %1</source>
        <translation>Relever de %1</translation>
    </message>
    <message>
        <source>The tool goes back to where it stood.</source>
        <translation>L’outil revient là où il se trouvait.</translation>
    </message>
    <message>
        <source>The tool goes straight up; the path waits.</source>
        <translation>L’outil monte tout droit&#xa0;; la trajectoire attend.</translation>
    </message>
    <message>
        <source>Continue goes on without it</source>
        <translation>Continuer reprend sans elle</translation>
    </message>
    <message>
        <source>stands in %1</source>
        <translation>arrêt en %1</translation>
    </message>
    <message>
        <source>The axes stand at once if the program obeys this computer&apos;s override, else at the end of its window. Escape does the same, from anywhere in the window. It does not replace the machine&apos;s emergency stop.</source>
        <translation>Les axes s&apos;arrêtent aussitôt si le programme obéit à l&apos;override de cet ordinateur, sinon à la fin de sa fenêtre. Échap fait de même, partout dans la fenêtre. Cela ne remplace pas l&apos;arrêt d&apos;urgence de la machine.</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Flux</translation>
    </message>
    <message>
        <source>Sent to the control: %1, confirmed by it: %2</source>
        <translation>Envoyés à la commande : %1, confirmés par elle : %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln moves in hand</source>
        <translation>
            <numerusform>%Ln mouvement d’avance</numerusform>
            <numerusform>%Ln mouvements d’avance</numerusform>
        </translation>
    </message>
    <message>
        <source>Moves in hand: what the control has and has not executed yet.</source>
        <translation>Mouvements d’avance : ce que la commande a et n’a pas encore exécuté.</translation>
    </message>
    <message>
        <source>late, %1</source>
        <translation>en retard, %1</translation>
    </message>
    <message>
        <source>on time, %1</source>
        <translation>à temps, %1</translation>
    </message>
    <message>
        <source>Margin %1: time until the control needs the next point, minus the 99th percentile of the access time</source>
        <translation>Marge %1 : temps jusqu’à ce que la commande ait besoin du point suivant, moins le 99e centile du temps d’accès</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunsModel</name>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Exécuté</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Répétés</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Sautés</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pauses</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Qui</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunsPage</name>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Open a report</source>
        <translation>Ouvrir un rapport</translation>
    </message>
    <message>
        <source>Reports (*.json)</source>
        <translation>Rapports (*.json)</translation>
    </message>
    <message>
        <source>All machines</source>
        <translation>Toutes les machines</translation>
    </message>
    <message>
        <source>Runs: %1</source>
        <translation>Exécutions&#xa0;: %1</translation>
    </message>
    <message>
        <source>Runs: %1 of %2</source>
        <translation>Exécutions&#xa0;: %1 sur %2</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Aucune exécution</translation>
    </message>
    <message>
        <source>No run is selected.</source>
        <translation>Aucune exécution n’est sélectionnée.</translation>
    </message>
    <message>
        <source>%1, %2, version %3, %4</source>
        <translation>%1, %2, version %3, %4</translation>
    </message>
    <message>
        <source>The run was not recorded.</source>
        <translation>L’exécution n’a pas été enregistrée.</translation>
    </message>
    <message>
        <source>Loads the program, compares it with the one of the run, and sets method and settings. Nothing starts.</source>
        <translation>Charge le programme, le compare à celui de l’exécution et reprend méthode et réglages. Rien ne démarre.</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves.</source>
        <translation>Demande à la commande où l’exécution s’est arrêtée. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Only a run that was left on the connected control, with its program loaded, can be resumed.</source>
        <translation>Seule une exécution interrompue sur la commande connectée, avec son programme chargé, peut être reprise.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Shows runs in which each word stands in some column</source>
        <translation>Montre les exécutions où chaque mot figure dans une colonne</translation>
    </message>
    <message>
        <source>Search runs</source>
        <translation>Rechercher des exécutions</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Exécutions</translation>
    </message>
    <message>
        <source>All results</source>
        <translation>Tous les résultats</translation>
    </message>
    <message>
        <source>Faultless</source>
        <translation>Sans erreur</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Non évalué</translation>
    </message>
    <message>
        <source>Failed or wrong</source>
        <translation>Échec ou erreur</translation>
    </message>
    <message>
        <source>Table as CSV…</source>
        <translation>Tableau en CSV…</translation>
    </message>
    <message>
        <source>Open a report…</source>
        <translation>Ouvrir un rapport…</translation>
    </message>
    <message>
        <source>A report that was exported here or printed by stream --json</source>
        <translation>Un rapport exporté ici ou écrit par stream --json</translation>
    </message>
    <message>
        <source>Open in Traces</source>
        <translation>Ouvrir dans Courbes</translation>
    </message>
    <message>
        <source>Repeat with these settings</source>
        <translation>Répéter avec ces réglages</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Page as PDF…</source>
        <translation>Page en PDF…</translation>
    </message>
    <message>
        <source>JSON…</source>
        <translation>JSON…</translation>
    </message>
    <message>
        <source>Keep at most</source>
        <translation>Garder au plus</translation>
    </message>
    <message>
        <source> runs</source>
        <translation> exécutions</translation>
    </message>
    <message>
        <source>Number of runs that are kept</source>
        <translation>Nombre d’exécutions gardées</translation>
    </message>
    <message>
        <source>Size of reports and recordings that are kept</source>
        <translation>Taille des rapports et enregistrements gardés</translation>
    </message>
    <message>
        <source>Others that cannot be shown: %1</source>
        <translation>Autres qui ne peuvent pas être affichées&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ScopeCurves</name>
    <message>
        <source>Time, s</source>
        <translation>Temps, s</translation>
    </message>
    <message>
        <source>Path, mm</source>
        <translation>Trajet, mm</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>point %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ScopePane</name>
    <message>
        <source>Remove %1</source>
        <translation>Enlever %1</translation>
    </message>
    <message>
        <source>Remove the pane</source>
        <translation>Enlever le volet</translation>
    </message>
    <message>
        <source>Curves: %1</source>
        <translation>Courbes : %1</translation>
    </message>
    <message>
        <source>%1 to %2, from %3 to %4</source>
        <translation>%1 à %2, de %3 à %4</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SeriesModel</name>
    <message>
        <source>The control refused arrays of this size.</source>
        <translation>La commande a refusé des tableaux de cette taille.</translation>
    </message>
    <message>
        <source>%1 were requested; there was no time for more.</source>
        <translation>%1 étaient demandées&#xa0;; le temps n’a pas suffi pour plus.</translation>
    </message>
    <message>
        <source>write</source>
        <translation>écriture</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Accès</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Paramètres R</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ServiceCard</name>
    <message>
        <source>Service at %1</source>
        <translation>Service %1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Remove this service from the board? It goes on with its work.</source>
        <translation>Retirer ce service du tableau&#xa0;? Il continue son travail.</translation>
    </message>
    <message>
        <source>Shows what the service says, and what can be done with it.</source>
        <translation>Montre ce que le service annonce et ce que l’on peut faire avec lui.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ServicePanel</name>
    <message>
        <source>Service at %1</source>
        <translation>Service %1</translation>
    </message>
    <message>
        <source>Service at %1, %2</source>
        <translation>Service %1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows late</source>
        <translation>
            <numerusform>%Ln fenêtre en retard</numerusform>
            <numerusform>%Ln fenêtres en retard</numerusform>
        </translation>
    </message>
    <message>
        <source>What Resume will do</source>
        <translation>Ce que fera la reprise</translation>
    </message>
    <message>
        <source>What Start will do</source>
        <translation>Ce que fera le départ</translation>
    </message>
    <message>
        <source>The service is working on it …</source>
        <translation>Le service y travaille…</translation>
    </message>
    <message>
        <source>Nobody is logged in.</source>
        <translation>Personne n’est connecté.</translation>
    </message>
    <message>
        <source>Logged in: %1</source>
        <translation>Connecté&#xa0;: %1</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Hold to resume</source>
        <translation>Maintenir appuyé</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Maintenir appuyé</translation>
    </message>
    <message>
        <source>Start …</source>
        <translation>Démarrer…</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Maintenir une seconde. Alors la machine se déplace.</translation>
    </message>
    <message>
        <source>Shows what will happen first. Nothing moves yet.</source>
        <translation>Montre d’abord ce qui va se passer. Rien ne bouge encore.</translation>
    </message>
    <message>
        <source>Log in …</source>
        <translation>Se connecter…</translation>
    </message>
    <message>
        <source>Change user …</source>
        <translation>Changer d’utilisateur…</translation>
    </message>
    <message>
        <source>All machines</source>
        <translation>Toutes les machines</translation>
    </message>
    <message>
        <source>Back to the board. The run goes on.</source>
        <translation>Retour au tableau. L’exécution continue.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>Ends the run of this machine after the window in motion. It does not replace the machine&apos;s emergency stop.</source>
        <translation>Termine l’exécution de cette machine après la fenêtre en cours. Cela ne remplace pas l’arrêt d’urgence de la machine.</translation>
    </message>
    <message>
        <source>The machine waits before the next window until you press Continue.</source>
        <translation>La machine attend avant la fenêtre suivante jusqu’à l’appui sur Continuer.</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Reprendre…</translation>
    </message>
    <message>
        <source>&amp;Program</source>
        <translation>&amp;Programme</translation>
    </message>
    <message>
        <source>The service reads it in its folder of programs.</source>
        <translation>Le service le lit dans son dossier de programmes.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charger</translation>
    </message>
    <message>
        <source>The service reads the program and judges it. Nothing moves.</source>
        <translation>Le service lit le programme et le juge. Rien ne bouge.</translation>
    </message>
    <message>
        <source>This service has users: log in before you give it commands.</source>
        <translation>Un service avec utilisateurs n’accepte d’ordres que de qui s’est connecté.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>P&amp;IN</translation>
    </message>
    <message>
        <source>A user of the service; empty: nobody.</source>
        <translation>Un utilisateur du service&#xa0;; vide&#xa0;: personne.</translation>
    </message>
    <message>
        <source>It is not kept.</source>
        <translation>Il n’est pas conservé.</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Se connecter</translation>
    </message>
    <message>
        <source>Connects again as this user.</source>
        <translation>Se reconnecte comme cet utilisateur.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>These buttons act on %1. Those at the bottom of the window act on the machine that the window is connected with.</source>
        <translation>Ces boutons agissent sur %1. Ceux du bas de la fenêtre agissent sur la machine à laquelle la fenêtre est connectée.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Terminer ici</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves yet.</source>
        <translation>Demande à la commande où l’exécution s’est interrompue. Rien ne bouge encore.</translation>
    </message>
    <message>
        <source>choose or type a file in the folder of the service</source>
        <translation>choisir ou taper un fichier du dossier du service</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SetUpPage</name>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SignalPanel</name>
    <message>
        <source>Say what the columns of the file mean</source>
        <translation>Dire ce que signifient les colonnes du fichier</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>Colonnes…</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>affiché</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search the signals</source>
        <translation>Rechercher un signal</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signaux</translation>
    </message>
    <message>
        <source>Pane</source>
        <translation>Volet</translation>
    </message>
    <message>
        <source>Show the signal in a pane of its own (Enter)</source>
        <translation>Afficher le signal dans son propre volet (Entrée)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Show the signal in the current pane (Shift+Enter)</source>
        <translation>Afficher le signal dans le volet actuel (Maj+Entrée)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Enlever</translation>
    </message>
    <message>
        <source>Remove the signal from the panes (Delete)</source>
        <translation>Ne plus afficher le signal (Suppr)</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formule</translation>
    </message>
    <message>
        <source>A formula of signals, then Enter. Their names are in their tool tips.</source>
        <translation>Une formule de signaux, puis Entrée. Leurs noms sont dans leurs infobulles.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SpectrumPanel</name>
    <message>
        <source>Frequencies need the time axis: choose it under Compare.</source>
        <translation>Les fréquences demandent l’axe du temps : le choisir sous Comparer.</translation>
    </message>
    <message>
        <source>No curve is shown.</source>
        <translation>Aucune courbe n’est affichée.</translation>
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
        <translation>Fréquence, Hz</translation>
    </message>
    <message>
        <source>Peak, Hz</source>
        <translation>Pic, Hz</translation>
    </message>
    <message>
        <source>Between the cursors: %1 samples, %2 Hz</source>
        <translation>Entre les curseurs : %1 échantillons, %2 Hz</translation>
    </message>
    <message>
        <source>In the time shown: %1 samples, %2 Hz</source>
        <translation>Dans le temps visible : %1 échantillons, %2 Hz</translation>
    </message>
    <message>
        <source>The samples are not evenly spaced: values between them were interpolated.</source>
        <translation>Les échantillons ne sont pas réguliers : les droites entre eux ont été échantillonnées de nouveau.</translation>
    </message>
    <message>
        <source>Curve whose frequencies are shown</source>
        <translation>Courbe dont les fréquences sont affichées</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>Peaks of the spectrum</source>
        <translation>Pics du spectre</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::StartSteps</name>
    <message>
        <source>Start a virtual machine</source>
        <translation>Démarrer une machine virtuelle</translation>
    </message>
    <message>
        <source>Connect to a control …</source>
        <translation>Connecter une commande …</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Ouvrir …</translation>
    </message>
    <message>
        <source>Live …</source>
        <translation>En direct …</translation>
    </message>
    <message>
        <source>Points from a program or a sensor, while they are made</source>
        <translation>Points d&apos;un programme ou d&apos;un capteur, au fur et à mesure</translation>
    </message>
    <message>
        <source>Three steps to a moving machine</source>
        <translation>Trois étapes vers une machine en mouvement</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Your control by its address, or a virtual machine on this computer: the same program, and nothing real moves.</source>
        <translation>Votre commande par son adresse, ou une machine virtuelle sur cet ordinateur : le même programme, et rien de réel ne bouge.</translation>
    </message>
    <message>
        <source>Open a program</source>
        <translation>Ouvrir un programme</translation>
    </message>
    <message>
        <source>Any CAM program: SINUMERIK, ISO, LinuxCNC, Grbl, Heidenhain. Or the sample.</source>
        <translation>Tout programme FAO : SINUMERIK, ISO, LinuxCNC, Grbl, Heidenhain. Ou l&apos;exemple.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Start, below at the right, checks travel, tools and data rate, shows the first move, and waits for you.</source>
        <translation>Démarrer, en bas à droite, vérifie les courses, les outils et le débit, montre le premier mouvement et vous attend.</translation>
    </message>
    <message>
        <source>Nothing moves before you hold Start.</source>
        <translation>Rien ne bouge avant que vous mainteniez Démarrer.</translation>
    </message>
    <message>
        <source>Sample: %1</source>
        <translation>Exemple : %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::StopModel</name>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Cause</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TaskPanel</name>
    <message>
        <source>Task</source>
        <translation>Tâche</translation>
    </message>
    <message>
        <source>G code receiving</source>
        <translation>Réception du code G</translation>
    </message>
    <message>
        <source>Interpreter</source>
        <translation>Interpréteur</translation>
    </message>
    <message>
        <source>Discrete</source>
        <translation>Interpolation grossière</translation>
    </message>
    <message>
        <source>Forward-looking</source>
        <translation>Anticipation</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>Position control</source>
        <translation>Asservissement de position</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Départs</translation>
    </message>
    <message>
        <source>Data, ms</source>
        <translation>Données, ms</translation>
    </message>
    <message>
        <source>Processor, ms</source>
        <translation>Processeur, ms</translation>
    </message>
    <message>
        <source>Mean, µs</source>
        <translation>Moyenne, µs</translation>
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
        <translation>Préemptions</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Tampon</translation>
    </message>
    <message>
        <source>Open a recording of the tasks</source>
        <translation>Ouvrir un enregistrement des tâches</translation>
    </message>
    <message>
        <source>Save what the scheduler did</source>
        <translation>Enregistrer ce que l’ordonnanceur a fait</translation>
    </message>
    <message>
        <source>Executes a program on virtual axes. No machine moves.</source>
        <translation>Exécute un programme sur des axes virtuels. Aucune machine ne bouge.</translation>
    </message>
    <message>
        <source>%1: %2, %3 set points</source>
        <translation>%1 : %2, %3 consignes</translation>
    </message>
    <message>
        <source>%1 has ended: %2, %3 set points</source>
        <translation>%1 est terminé : %2, %3 consignes</translation>
    </message>
    <message>
        <source>%1 was stopped: %2, %3 set points</source>
        <translation>%1 a été arrêté : %2, %3 consignes</translation>
    </message>
    <message>
        <source>Recording %1: %2, %3 set points</source>
        <translation>Enregistrement %1 : %2, %3 consignes</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>Exemple</translation>
    </message>
    <message>
        <source>Program that the tasks execute</source>
        <translation>Programme que les tâches exécutent</translation>
    </message>
    <message>
        <source>Task dependency</source>
        <translation>Dépendance des tâches</translation>
    </message>
    <message>
        <source>Data flow</source>
        <translation>Flux de données</translation>
    </message>
    <message>
        <source>Earliest starvation</source>
        <translation>Manque le plus proche</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Constant</translation>
    </message>
    <message>
        <source>Which task gets the processor</source>
        <translation>Quelle tâche obtient le processeur</translation>
    </message>
    <message>
        <source>Processors: %1</source>
        <translation>Processeurs : %1</translation>
    </message>
    <message>
        <source>How many tasks run at a time</source>
        <translation>Combien de tâches s’exécutent à la fois</translation>
    </message>
    <message>
        <source>Cycle %1 ms</source>
        <translation>Cycle %1 ms</translation>
    </message>
    <message>
        <source>Cycle of position control</source>
        <translation>Cycle de l’asservissement de position</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Temps réel</translation>
    </message>
    <message>
        <source>Position control comes before everything else on this computer</source>
        <translation>L’asservissement de position passe avant tout le reste sur cet ordinateur</translation>
    </message>
    <message>
        <source>Without real time, other programs of this computer can delay position control.</source>
        <translation>Sans temps réel, d’autres programmes de cet ordinateur peuvent retarder l’asservissement de position.</translation>
    </message>
    <message>
        <source>This computer does not allow real-time scheduling: position control runs like any other program, and others can delay it.</source>
        <translation>Cet ordinateur ne permet pas le temps réel : l’asservissement de position s’exécute comme tout autre programme, et d’autres peuvent le retarder.</translation>
    </message>
    <message>
        <source>Execute</source>
        <translation>Exécuter</translation>
    </message>
    <message>
        <source>Execute the program in six tasks, on virtual axes</source>
        <translation>Exécuter le programme en six tâches, sur des axes virtuels</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>End the tasks; the virtual axes stand</source>
        <translation>Terminer les tâches ; les axes virtuels s’arrêtent</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open a recording of a scheduler</source>
        <translation>Ouvrir l’enregistrement d’un ordonnanceur</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Tasks: starts, waiting for data and for a processor, time of a step</source>
        <translation>Tâches : départs, attente de données et d’un processeur, durée d’un pas</translation>
    </message>
    <message>
        <source>Levels of the buffers</source>
        <translation>Niveaux des tampons</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Temps, s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TemplatePage</name>
    <message>
        <source>Save the template</source>
        <translation>Enregistrer le modèle</translation>
    </message>
    <message>
        <source>NC programs (*.MPF *.mpf)</source>
        <translation>Programmes CN (*.MPF *.mpf)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>No template: %1</source>
        <translation>Pas de modèle&#xa0;: %1</translation>
    </message>
    <message>
        <source>No template yet</source>
        <translation>Pas encore de modèle</translation>
    </message>
    <message>
        <source>%1, layout number %2</source>
        <translation>%1, numéro de disposition %2</translation>
    </message>
    <message>
        <source>Flexible program</source>
        <translation>Programme flexible</translation>
    </message>
    <message>
        <source>Save the steps</source>
        <translation>Enregistrer les étapes</translation>
    </message>
    <message>
        <source>Steps to print…</source>
        <translation>Étapes à imprimer…</translation>
    </message>
    <message>
        <source>A page with the steps at the control, the rights, what the operator sees, and how it is taken back</source>
        <translation>Une page avec les étapes sur la commande, les droits, ce que voit l’opérateur et comment tout retirer</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Paramètres R</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TextPane</name>
    <message>
        <source>Lines with this text</source>
        <translation>Lignes avec ce texte</translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Rechercher (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search the program text</source>
        <translation>Rechercher dans le programme</translation>
    </message>
    <message>
        <source>Previous line with this text</source>
        <translation>Ligne précédente avec ce texte</translation>
    </message>
    <message>
        <source>Next line with this text</source>
        <translation>Ligne suivante avec ce texte</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Go to a line (Ctrl+G)</source>
        <translation>Aller à une ligne (Ctrl+G)</translation>
    </message>
    <message>
        <source>Go to line</source>
        <translation>Aller à la ligne</translation>
    </message>
    <message>
        <source>Follow the run</source>
        <translation>Suivre l’exécution</translation>
    </message>
    <message>
        <source>The text shows the line that is being executed</source>
        <translation>Le texte montre la ligne en cours d’exécution</translation>
    </message>
    <message>
        <source>Previous part, or blocks that the control executes (Ctrl+Page Up)</source>
        <translation>Tronçon précédent, ou blocs exécutés par la commande (Ctrl+Page préc.)</translation>
    </message>
    <message>
        <source>Next part, or blocks that the control executes (Ctrl+Page Down)</source>
        <translation>Tronçon suivant, ou blocs exécutés par la commande (Ctrl+Page suiv.)</translation>
    </message>
    <message>
        <source>Run from here …</source>
        <translation>Exécuter à partir d’ici…</translation>
    </message>
    <message>
        <source>Start at the chosen line. First it is shown what would move.</source>
        <translation>Démarrer à la ligne choisie. Ce qui bougerait est d’abord montré.</translation>
    </message>
    <message>
        <source>Search the text (Ctrl+F), or go to a line (Ctrl+G)</source>
        <translation>Chercher dans le texte (Ctrl+F), ou aller à une ligne (Ctrl+G)</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TimeStrip</name>
    <message>
        <source>Overview of the whole trace</source>
        <translation>Vue d’ensemble du tracé</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TracePage</name>
    <message>
        <source>Trigger</source>
        <translation>Déclencheur</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En direct</translation>
    </message>
    <message>
        <source>Follow the newest samples</source>
        <translation>Suivre les échantillons les plus récents</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>No samples yet</source>
        <translation>Pas encore d’échantillons</translation>
    </message>
    <message>
        <source>Live samples: read while the stream has time; short pauses may be missing from the curves</source>
        <translation>Échantillons en direct&#xa0;: lus quand la transmission en laisse le temps&#xa0;; de courtes pauses peuvent manquer dans les courbes</translation>
    </message>
    <message>
        <source>The control&apos;s own trace: one sample every %1</source>
        <translation>Enregistrement de la commande&#xa0;: un échantillon toutes les %1</translation>
    </message>
    <message>
        <source>%1: pause %2</source>
        <translation>%1&#xa0;: pause %2</translation>
    </message>
    <message>
        <source>Run of %1, %2. </source>
        <translation>Exécution du %1, %2. </translation>
    </message>
    <message>
        <source>Open traces</source>
        <translation>Ouvrir des tracés</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Tracés</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Tous les fichiers</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Open recordings and traces; several are shown on one time axis</source>
        <translation>Ouvrir des enregistrements et des tracés ; plusieurs sur un même axe des temps</translation>
    </message>
    <message>
        <source>Wheel: zoom. Drag: move. Ctrl and drag: zoom into a range. Click: cursor A. Shift and click: cursor B. Home: show all.</source>
        <translation>Molette : agrandir. Glisser : déplacer. Ctrl et glisser : agrandir une plage. Clic : curseur A. Maj et clic : curseur B. Origine : tout afficher.</translation>
    </message>
    <message>
        <source>Stops, signals and cursors beside the curves</source>
        <translation>Arrêts, signaux et curseurs à côté des courbes</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Arrêts</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signaux</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Curseurs</translation>
    </message>
    <message>
        <source>%1: one sample every %2</source>
        <translation>%1 : un échantillon toutes les %2</translation>
    </message>
    <message>
        <source>Looking for stops …</source>
        <translation>Recherche des arrêts…</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>Samples as a table</source>
        <translation>Échantillons en tableau</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Save what the panes show</source>
        <translation>Enregistrer ce que montrent les zones</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 ne peut pas être écrit. Choisir un autre dossier.</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Zones</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Arrangements of panes that are kept by name</source>
        <translation>Dispositions de zones gardées sous un nom</translation>
    </message>
    <message>
        <source>Save what the panes show: the samples as a table (CSV), or a picture (PNG, SVG, PDF)</source>
        <translation>Enregistrer ce que montrent les zones : les échantillons en tableau (CSV) ou une image (PNG, SVG, PDF)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Enregistré : %1</translation>
    </message>
    <message>
        <source>Shown beside the panes</source>
        <translation>Affiché à côté des courbes</translation>
    </message>
    <message>
        <source>Samples and events as HDF5</source>
        <translation>Échantillons et événements en HDF5</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TriggerPanel</name>
    <message>
        <source>The signal must go back this far before the trigger can fire again</source>
        <translation>Le signal doit revenir d’autant avant que le déclencheur puisse agir à nouveau</translation>
    </message>
    <message>
        <source>An armed trigger stops the live view when it fires and shows what was before and after</source>
        <translation>Un déclencheur armé arrête l’affichage en direct quand il agit et montre l’avant et l’après</translation>
    </message>
    <message>
        <source>Once: what was caught stays. Every time: the next one takes its place.</source>
        <translation>Une fois&#xa0;: ce qui a été capturé reste. Chaque fois&#xa0;: le suivant prend sa place.</translation>
    </message>
    <message>
        <source>How much is shown after the trigger</source>
        <translation>Combien est affiché après le déclenchement</translation>
    </message>
    <message>
        <source>How much is shown before the trigger</source>
        <translation>Combien est affiché avant le déclenchement</translation>
    </message>
    <message>
        <source>Upper end of the range</source>
        <translation>Borne supérieure de la plage</translation>
    </message>
    <message>
        <source>Lower end of the range</source>
        <translation>Borne inférieure de la plage</translation>
    </message>
    <message>
        <source>Value at which the trigger fires</source>
        <translation>Valeur à laquelle le déclencheur agit</translation>
    </message>
    <message>
        <source>What the trigger waits for</source>
        <translation>Ce que le déclencheur attend</translation>
    </message>
    <message>
        <source>The signal that is watched during a run</source>
        <translation>Le signal surveillé pendant une exécution</translation>
    </message>
    <message>
        <source>every time (normal)</source>
        <translation>chaque fois (normal)</translation>
    </message>
    <message>
        <source>once (single)</source>
        <translation>une fois (single)</translation>
    </message>
    <message>
        <source>an alarm comes</source>
        <translation>une alarme arrive</translation>
    </message>
    <message>
        <source>a pause begins</source>
        <translation>une pause commence</translation>
    </message>
    <message>
        <source>it is outside the range</source>
        <translation>il est hors de la plage</translation>
    </message>
    <message>
        <source>it is within the range</source>
        <translation>il est dans la plage</translation>
    </message>
    <message>
        <source>it is at the level or below</source>
        <translation>il est au niveau ou au-dessous</translation>
    </message>
    <message>
        <source>it is at the level or above</source>
        <translation>il est au niveau ou au-dessus</translation>
    </message>
    <message>
        <source>it falls through the level</source>
        <translation>il descend sous le niveau</translation>
    </message>
    <message>
        <source>it rises through the level</source>
        <translation>il monte au-delà du niveau</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Déclenche</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>Hystérésis</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Quand</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Waiting for the next run</source>
        <translation>Attente de la prochaine exécution</translation>
    </message>
    <message>
        <source>Waiting for the trigger</source>
        <translation>Attente du déclencheur</translation>
    </message>
    <message>
        <source>Triggered at %1. Waiting for the next</source>
        <translation>Déclenché à %1. Attente du suivant</translation>
    </message>
    <message>
        <source>Triggered: waiting for the time after it</source>
        <translation>Déclenché&#xa0;: attente du temps qui suit</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Non armé</translation>
    </message>
    <message>
        <source>Triggered at %1. Cursor A is there.</source>
        <translation>Déclenché à %1. Le curseur A y est.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armer</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Désarmer</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TrustSheet</name>
    <message>
        <source>Is this the right machine?</source>
        <translation>Est-ce la bonne machine&#xa0;?</translation>
    </message>
    <message>
        <source>The machine shows another certificate</source>
        <translation>La machine présente un autre certificat</translation>
    </message>
    <message>
        <source>The machine does not offer sufficient encryption</source>
        <translation>La machine n’offre pas de chiffrement suffisant</translation>
    </message>
    <message>
        <source>This computer has not connected to it before. Compare the fingerprint with the one that the control shows. If they are equal, accept it: from then on, only this certificate is trusted at this address.</source>
        <translation>Cet ordinateur la rencontre pour la première fois. Comparer l’empreinte avec celle que montre la commande. Si elles sont égales, accepter&#xa0;: dès lors, seul ce certificat est de confiance à cette adresse.</translation>
    </message>
    <message>
        <source>Either somebody has renewed the certificate of the control, or another computer answers at its address and would get all commands. Ask who looks after the control. Do not connect if nobody has changed anything.</source>
        <translation>Soit quelqu’un a renouvelé le certificat de la commande, soit un autre ordinateur répond à son adresse et recevrait tous les ordres. Demander à qui s’occupe de la commande. Ne pas connecter si personne n’a rien changé.</translation>
    </message>
    <message>
        <source>Better: switch encryption on at the control, then connect again. What you allow here is remembered for this machine until you take it back, and is marked as long as it is connected.</source>
        <translation>Mieux&#xa0;: activer le chiffrement sur la commande, puis reconnecter. Ce qui est autorisé ici est retenu pour cette machine jusqu’à son retrait, et reste signalé tant qu’elle est connectée.</translation>
    </message>
    <message>
        <source>Until now this machine was connected encrypted. Somebody who stands between could hide the encryption.</source>
        <translation>Jusqu’ici, cette machine était connectée de façon chiffrée. Quelqu’un placé entre les deux pourrait cacher le chiffrement.</translation>
    </message>
    <message>
        <source>Nothing that it offers lets this user in with an encrypted password.</source>
        <translation>Rien de ce qu’elle offre ne laisse entrer cet utilisateur avec un mot de passe chiffré.</translation>
    </message>
    <message>
        <source>The certificate is not valid today, so it cannot be accepted. Set the clocks of both computers, or renew it on the control.</source>
        <translation>Le certificat n’est pas valable aujourd’hui et ne peut pas être accepté. Régler les horloges des deux ordinateurs, ou le renouveler sur la commande.</translation>
    </message>
    <message>
        <source>not kept</source>
        <translation>non conservé</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Shown now</source>
        <translation>Présenté maintenant</translation>
    </message>
    <message>
        <source>Accepted before</source>
        <translation>Accepté auparavant</translation>
    </message>
    <message>
        <source>Fingerprint (SHA-256)</source>
        <translation>Empreinte (SHA-256)</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Délivré à</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>Délivré par</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>Application</translation>
    </message>
    <message>
        <source>Made for</source>
        <translation>Fait pour</translation>
    </message>
    <message>
        <source>%1: not for %2</source>
        <translation>%1&#xa0;: pas pour %2</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Valable</translation>
    </message>
    <message>
        <source>The control has to trust this computer, too. On a SINUMERIK, switch on in the dialog of the OPC UA server that client certificates are accepted by themselves, connect, and switch it off again; or import the file of this computer&apos;s certificate there. Its fingerprint: %1</source>
        <translation>La commande doit aussi faire confiance à cet ordinateur. Sur une SINUMERIK, activer dans le dialogue du serveur OPC UA l’acceptation automatique des certificats clients, connecter, puis la désactiver&#xa0;; ou y importer le fichier du certificat de cet ordinateur. Son empreinte&#xa0;: %1</translation>
    </message>
    <message>
        <source>Do not connect</source>
        <translation>Ne pas connecter</translation>
    </message>
    <message>
        <source>Save this computer&apos;s certificate …</source>
        <translation>Enregistrer le certificat de cet ordinateur…</translation>
    </message>
    <message>
        <source>Hold: allow and connect</source>
        <translation>Maintenir&#xa0;: autoriser et connecter</translation>
    </message>
    <message>
        <source>Hold: accept and connect</source>
        <translation>Maintenir&#xa0;: accepter et connecter</translation>
    </message>
    <message>
        <source>Hold it for one second, with the mouse, a finger or the space bar.</source>
        <translation>Maintenir une seconde, avec la souris, un doigt ou la barre d’espace.</translation>
    </message>
    <message>
        <source>%1: the server says that it is %2</source>
        <translation>%1&#xa0;: le serveur dit être %2</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UserButton</name>
    <message>
        <source>Locked: log in</source>
        <translation>Verrouillé&#xa0;: s’identifier</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Only Stop works. Log in with your PIN (Ctrl+L).</source>
        <translation>Seul Arrêt agit. S’identifier avec votre code PIN (Ctrl+L).</translation>
    </message>
    <message>
        <source>Lock the window, or let somebody else in (Ctrl+L).</source>
        <translation>Verrouiller la fenêtre, ou laisser entrer quelqu’un d’autre (Ctrl+L).</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UserModel</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>Code PIN</translation>
    </message>
    <message>
        <source>set</source>
        <translation>défini</translation>
    </message>
    <message>
        <source>none: user of this computer</source>
        <translation>aucun&#xa0;: utilisateur de cet ordinateur</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UsersPage</name>
    <message>
        <source>No users are set up: everybody at this window may do everything. To let operators start only what is released, add an engineer (name and PIN), then the operators.</source>
        <translation>Aucun utilisateur n’est défini&#xa0;: chacun peut tout faire à cette fenêtre. Pour que les opérateurs ne démarrent que ce qui est validé, ajouter un régleur (nom et code PIN), puis les opérateurs.</translation>
    </message>
    <message>
        <source>An operator starts what an engineer has released in the preflight, holds, stops and acknowledges. An engineer may do everything. In a locked window only Stop works. The user of this computer (%1) needs no PIN.</source>
        <translation>Un opérateur démarre ce qu’un régleur a validé dans le contrôle avant démarrage, suspend, arrête et acquitte. Un régleur peut tout faire. Dans une fenêtre verrouillée, seul Arrêt agit. L’utilisateur de cet ordinateur (%1) n’a pas besoin de code PIN.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rôle</translation>
    </message>
    <message>
        <source>PIN, at least 4 characters</source>
        <translation>Code PIN, au moins 4 caractères</translation>
    </message>
    <message>
        <source>Lock the window if nobody touches it for</source>
        <translation>Verrouiller la fenêtre si personne ne la touche pendant</translation>
    </message>
    <message>
        <source>never</source>
        <translation>jamais</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Add or change</source>
        <translation>Ajouter ou modifier</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Utilisateurs</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::WrongMotionBar</name>
    <message>
        <source>Stop the run</source>
        <translation>Arrêter l’exécution</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Acquitter</translation>
    </message>
</context>
</TS>
