<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>AccessTexts</name>
    <message>
        <source>Access calibrated on %1 (%2): t = %3; read %4, write %5.</source>
        <translation>Acceso calibrado el %1 (%2): t = %3; lectura %4, escritura %5.</translation>
    </message>
    <message>
        <source>list</source>
        <translation>lista</translation>
    </message>
    <message>
        <source>one by one</source>
        <translation>de una en una</translation>
    </message>
    <message>
        <source>array, by count</source>
        <translation>matriz, por número</translation>
    </message>
    <message>
        <source>array, by range</source>
        <translation>matriz, por rango</translation>
    </message>
    <message>
        <source>a server without a name</source>
        <translation>un servidor sin nombre</translation>
    </message>
    <message>
        <source>Access is assumed: %1 for each R-parameter. See Calibration.</source>
        <translation>El acceso se supone: %1 por parámetro R. Véase Calibración.</translation>
    </message>
    <message>
        <source>Access is assumed: %1 for each R-parameter. The calibration of %2 belongs to another version of the server and is not used.</source>
        <translation>El acceso se supone: %1 por parámetro R. La calibración del %2 corresponde a otra versión del servidor y no se utiliza.</translation>
    </message>
    <message numerus="yes">
        <source>99 % of the writes of %n R-parameters end within %1.</source>
        <translation>
            <numerusform>El 99 % de las escrituras de %n parámetro R termina en menos de %1.</numerusform>
            <numerusform>El 99 % de las escrituras de %n parámetros R termina en menos de %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Up to %n R-parameters were measured.</source>
        <translation>
            <numerusform>Se midió hasta %n parámetro R.</numerusform>
            <numerusform>Se midieron hasta %n parámetros R.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>AlarmTexts</name>
    <message>
        <source>The control reports alarm %1.</source>
        <translation>El control notifica la alarma %1.</translation>
    </message>
    <message>
        <source>The control has stopped or limits the machine; the number says why.</source>
        <translation>El control ha parado la máquina o la limita; el número indica el motivo.</translation>
    </message>
    <message>
        <source>Look up alarm %1 at the control, remove its cause, then press reset there.</source>
        <translation>Consultar la alarma %1 en el control, eliminar la causa y pulsar allí Reset.</translation>
    </message>
    <message>
        <source>The connection to %1 is lost.</source>
        <translation>Se ha perdido la conexión con %1.</translation>
    </message>
    <message>
        <source>No connection to %1.</source>
        <translation>Sin conexión con %1.</translation>
    </message>
    <message>
        <source>Wrong motion in %1 (points repeated: %2, skipped: %3). The workpiece may be spoilt.</source>
        <translation>Movimiento erróneo en %1 (puntos repetidos: %2, omitidos: %3). La pieza puede estar dañada.</translation>
    </message>
    <message>
        <source>Points came too late for this feed with these settings.</source>
        <translation>Los puntos llegaron demasiado tarde para este avance con estos ajustes.</translation>
    </message>
    <message>
        <source>Check workpiece and tool. Choose a smaller feed, or method window.</source>
        <translation>Comprobar pieza y herramienta. Elegir un avance menor o el método Ventana.</translation>
    </message>
    <message>
        <source>The run of %1 was ended by a fault.</source>
        <translation>Un fallo terminó la ejecución de %1.</translation>
    </message>
    <message>
        <source>Check tool and workpiece, remove the cause, then resume or start again.</source>
        <translation>Comprobar herramienta y pieza, eliminar la causa y después reanudar o volver a iniciar.</translation>
    </message>
    <message>
        <source>%1 ended before its end: %2 of %3 points were executed.</source>
        <translation>%1 terminó antes de su final: se ejecutaron %2 de %3 puntos.</translation>
    </message>
    <message>
        <source>The control&apos;s trace lacks the last points.</source>
        <translation>En el registro del control faltan los últimos puntos.</translation>
    </message>
    <message>
        <source>Check tool and workpiece before you go on.</source>
        <translation>Comprobar herramienta y pieza antes de continuar.</translation>
    </message>
    <message>
        <source>It is not known whether %1 was executed without a fault.</source>
        <translation>No se sabe si %1 se ejecutó sin fallos.</translation>
    </message>
    <message>
        <source>The control&apos;s trace could not be read, or is shorter than the run.</source>
        <translation>El registro del control no se pudo leer o es más corto que la ejecución.</translation>
    </message>
    <message>
        <source>Check the workpiece.</source>
        <translation>Comprobar la pieza.</translation>
    </message>
    <message>
        <source>The run is not recorded.</source>
        <translation>La ejecución no se graba.</translation>
    </message>
    <message>
        <source>Nothing can be written to the folder %1.</source>
        <translation>No se puede escribir nada en la carpeta %1.</translation>
    </message>
    <message>
        <source>Check the folder, its permissions and the free space.</source>
        <translation>Comprobar la carpeta, sus permisos y el espacio libre.</translation>
    </message>
    <message>
        <source>The program file %1 has changed since it was read.</source>
        <translation>El archivo de programa %1 ha cambiado desde que se leyó.</translation>
    </message>
    <message>
        <source>Another program has written the file.</source>
        <translation>Otro programa ha escrito el archivo.</translation>
    </message>
    <message>
        <source>Reload the file before you start.</source>
        <translation>Recargar el archivo antes de iniciar.</translation>
    </message>
    <message>
        <source>The program file %1 is no longer there.</source>
        <translation>El archivo de programa %1 ya no está.</translation>
    </message>
    <message>
        <source>It was deleted or moved, or its drive is not connected.</source>
        <translation>Se ha borrado o movido, o su unidad no está conectada.</translation>
    </message>
    <message>
        <source>Bring the file back, or go on with what was read before it disappeared.</source>
        <translation>Recuperar el archivo, o continuar con lo que se leyó antes de que desapareciera.</translation>
    </message>
    <message>
        <source>The calibration of %1 has failed.</source>
        <translation>La calibración de %1 ha fallado.</translation>
    </message>
    <message>
        <source>Remove the cause, then measure again.</source>
        <translation>Eliminar la causa y volver a medir.</translation>
    </message>
    <message>
        <source>The calibration of %1 is not saved.</source>
        <translation>La calibración de %1 no se ha guardado.</translation>
    </message>
    <message>
        <source>Check the folder and the free space, then measure again.</source>
        <translation>Comprobar la carpeta y el espacio libre, y volver a medir.</translation>
    </message>
    <message>
        <source>The history of alarms is not written to %1.</source>
        <translation>El historial de alarmas no se escribe en %1.</translation>
    </message>
    <message>
        <source>The audit trail is not written to %1.</source>
        <translation>El registro de auditoría no se escribe en %1.</translation>
    </message>
    <message>
        <source>The audit trail %1 was changed: see line %2.</source>
        <translation>El registro de auditoría %1 ha sido modificado: véase la línea %2.</translation>
    </message>
    <message>
        <source>A line was edited, inserted or removed after it was written.</source>
        <translation>Una línea se modificó, insertó o borró después de escribirla.</translation>
    </message>
    <message>
        <source>Keep a copy of the file and find out who changed it.</source>
        <translation>Guardar una copia del archivo y averiguar quién lo cambió.</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Control</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Conexión</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Ordenador</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Activa</translation>
    </message>
    <message>
        <source>Active, acknowledged</source>
        <translation>Activa, acusada</translation>
    </message>
    <message>
        <source>Gone, not acknowledged</source>
        <translation>Desaparecida, sin acusar</translation>
    </message>
    <message>
        <source>Shelved</source>
        <translation>Aplazada</translation>
    </message>
    <message>
        <source>Came</source>
        <translation>Aparecida</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>Desaparecida</translation>
    </message>
    <message>
        <source>Acknowledged</source>
        <translation>Acusada</translation>
    </message>
    <message>
        <source>Taken back</source>
        <translation>Recuperada</translation>
    </message>
    <message>
        <source>Shelving expired</source>
        <translation>Aplazamiento vencido</translation>
    </message>
    <message>
        <source>Look at the machine: it may still move. Check cable and control, then connect again.</source>
        <translation>Mirar la máquina: todavía puede moverse. Comprobar cable y control, y volver a conectar.</translation>
    </message>
    <message>
        <source>Wrong motion in %1 after point %2: points are repeated, or the tool has left the path.</source>
        <translation>Movimiento erróneo en %1 después del punto %2: se repiten puntos, o la herramienta ha dejado la trayectoria.</translation>
    </message>
    <message>
        <source>Points came too late for this feed with these settings, or something else moves the axes.</source>
        <translation>Los puntos llegaron demasiado tarde para este avance con estos ajustes, o algo distinto mueve los ejes.</translation>
    </message>
    <message>
        <source>Stop the run, then check workpiece and tool.</source>
        <translation>Parar la ejecución y comprobar después la pieza y la herramienta.</translation>
    </message>
    <message>
        <source>The recording of %1 was cut off: the first %2 s of the run are in it.</source>
        <translation>El registro de %1 se ha cortado: contiene los primeros %2 s de la ejecución.</translation>
    </message>
    <message>
        <source>Nothing more can be written to the folder %3: its disk is full, or too slow.</source>
        <translation>En la carpeta %3 no se puede escribir nada más: el disco está lleno o es demasiado lento.</translation>
    </message>
    <message>
        <source>Make room on the disk. A run in progress goes on without its recording; the next one is recorded.</source>
        <translation>Liberar espacio en el disco. Una ejecución en curso continúa sin registro; la siguiente se registra.</translation>
    </message>
</context>
<context>
    <name>AuditTexts</name>
    <message>
        <source>Stop</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reanudación</translation>
    </message>
    <message>
        <source>Online correction</source>
        <translation>Corrección en línea</translation>
    </message>
    <message>
        <source>Program opened</source>
        <translation>Programa abierto</translation>
    </message>
    <message>
        <source>Settings changed</source>
        <translation>Ajustes modificados</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conexión</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Desconexión</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Aprobado</translation>
    </message>
    <message>
        <source>Release taken back</source>
        <translation>Aprobación retirada</translation>
    </message>
    <message>
        <source>Alarm acknowledged</source>
        <translation>Alarma acusada</translation>
    </message>
    <message>
        <source>Alarm shelved</source>
        <translation>Alarma aplazada</translation>
    </message>
    <message>
        <source>Users set up</source>
        <translation>Usuarios configurados</translation>
    </message>
    <message>
        <source>Logged in</source>
        <translation>Sesión iniciada</translation>
    </message>
    <message>
        <source>Wrong PIN</source>
        <translation>PIN incorrecto</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloqueado</translation>
    </message>
    <message>
        <source>Rivulet started</source>
        <translation>Rivulet iniciado</translation>
    </message>
    <message>
        <source>Rivulet ended</source>
        <translation>Rivulet cerrado</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operario</translation>
    </message>
    <message>
        <source>Engineer</source>
        <translation>Preparador</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Observar</translation>
    </message>
    <message>
        <source>Trust</source>
        <translation>Confianza</translation>
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
        <translation>Hay una ejecución en curso.</translation>
    </message>
    <message>
        <source>Asking the control where the run was left.</source>
        <translation>Se pregunta al control dónde se interrumpió la ejecución.</translation>
    </message>
    <message>
        <source>A calibration is in progress.</source>
        <translation>Hay una calibración en curso.</translation>
    </message>
    <message>
        <source>Connect to a control first.</source>
        <translation>Conectar primero con un control.</translation>
    </message>
    <message>
        <source>Open a program first.</source>
        <translation>Abrir primero un programa.</translation>
    </message>
    <message>
        <source>The file of the program has changed: reload it.</source>
        <translation>El archivo del programa ha cambiado: recargarlo.</translation>
    </message>
    <message>
        <source>The program moves no axis.</source>
        <translation>El programa no mueve ningún eje.</translation>
    </message>
    <message>
        <source>The program needs a transformation of the control. No method can stream it.</source>
        <translation>El programa necesita una transformación del control. Ningún método puede transmitirlo de forma continua.</translation>
    </message>
    <message>
        <source>Parts of the program&apos;s path are not known: see the findings.</source>
        <translation>Hay partes de la trayectoria que no se conocen: véanse las observaciones.</translation>
    </message>
    <message>
        <source>The program moves rotary axes: choose method window.</source>
        <translation>El programa mueve ejes giratorios: elegir el método Ventana.</translation>
    </message>
    <message>
        <source>The program moves %1, but the control does not have all of these axes.</source>
        <translation>El programa mueve %1, pero el control no tiene todos estos ejes.</translation>
    </message>
    <message>
        <source>Not feasible: the control would repeat points. Change F, N or δ.</source>
        <translation>No viable: el control repetiría puntos. Cambiar F, N o δ.</translation>
    </message>
    <message>
        <source>Method credit starts only on a control that has passed its test: choose method window.</source>
        <translation>El método Crédito solo se inicia en un control que ha superado su prueba: elegir el método Ventana.</translation>
    </message>
    <message>
        <source>The control reports an alarm.</source>
        <translation>El control notifica una alarma.</translation>
    </message>
    <message>
        <source>A program is running on the control.</source>
        <translation>Hay un programa en marcha en el control.</translation>
    </message>
    <message>
        <source>There is no interrupted run of method window.</source>
        <translation>No hay ninguna ejecución interrumpida del método Ventana.</translation>
    </message>
    <message>
        <source>Only method window can resume an interrupted run.</source>
        <translation>Solo el método Ventana puede reanudar una ejecución interrumpida.</translation>
    </message>
    <message>
        <source>The program is being simulated.</source>
        <translation>Se está simulando el programa.</translation>
    </message>
    <message>
        <source>The simulation of this program failed in %1 of %2 runs. Change F, N or δ.</source>
        <translation>La simulación de este programa falló en %1 de %2 pasadas. Cambiar F, N o δ.</translation>
    </message>
    <message>
        <source>The window is locked: log in.</source>
        <translation>La ventana está bloqueada: iniciar sesión.</translation>
    </message>
    <message>
        <source>Only an engineer may do this.</source>
        <translation>Solo para el preparador.</translation>
    </message>
    <message>
        <source>Not released: an engineer has to release this program with these settings.</source>
        <translation>Sin aprobar: un preparador debe aprobar este programa con estos ajustes.</translation>
    </message>
    <message>
        <source>A test of the control is in progress.</source>
        <translation>Hay una prueba del control en curso.</translation>
    </message>
    <message>
        <source>The job is being compared with the machine.</source>
        <translation>El trabajo se está comparando con la máquina.</translation>
    </message>
    <message>
        <source>Live points need a machine that waits for them: choose method window or credit.</source>
        <translation>Los puntos en vivo necesitan una máquina que los espere: elegir el método Ventana o Crédito.</translation>
    </message>
    <message>
        <source>Method %1 may execute old points again: if this computer is late for a moment, the tool goes back through the workpiece. Choose method window.</source>
        <translation>El método %1 puede ejecutar otra vez puntos antiguos: si este ordenador se retrasa un momento, la herramienta vuelve atrás a través de la pieza. Elegir el método Ventana.</translation>
    </message>
</context>
<context>
    <name>CertificateTexts</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>itself</source>
        <translation>sí mismo</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>no indicado</translation>
    </message>
</context>
<context>
    <name>ConnectionTexts</name>
    <message>
        <source>Not connected</source>
        <translation>Sin conexión</translation>
    </message>
    <message>
        <source>Connecting …</source>
        <translation>Conectando…</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Conectado</translation>
    </message>
    <message>
        <source>Connection lost</source>
        <translation>Conexión perdida</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Interrumpido</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Parado</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marcha</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>En espera</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Terminado</translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation>Desconocido (%1)</translation>
    </message>
    <message>
        <source>encrypted</source>
        <translation>cifrada</translation>
    </message>
    <message>
        <source>Nobody on the network can read or change what is sent.</source>
        <translation>Nadie en la red puede leer ni cambiar lo que se envía.</translation>
    </message>
    <message>
        <source>signed</source>
        <translation>firmada</translation>
    </message>
    <message>
        <source>Nobody can change what is sent, but everybody on the network can read it.</source>
        <translation>Nadie puede cambiar lo que se envía, pero todos en la red pueden leerlo.</translation>
    </message>
    <message>
        <source>weakly encrypted</source>
        <translation>cifrado débil</translation>
    </message>
    <message>
        <source>This encryption was withdrawn: it can be broken with the means of today.</source>
        <translation>Este cifrado fue retirado: se puede romper con los medios de hoy.</translation>
    </message>
    <message>
        <source>not protected</source>
        <translation>sin protección</translation>
    </message>
    <message>
        <source>Not encrypted. What is sent does not leave this computer.</source>
        <translation>Sin cifrar. Lo que se envía no sale de este ordenador.</translation>
    </message>
    <message>
        <source>Everybody on the network can read what is sent, and move the machine.</source>
        <translation>Todos en la red pueden leer lo que se envía y mover la máquina.</translation>
    </message>
</context>
<context>
    <name>ControlSettings</name>
    <message>
        <source>R plane of a cycle without R: below the height before it, mm</source>
        <translation>Plano R de un ciclo sin R: bajo la altura anterior, mm</translation>
    </message>
    <message>
        <source>peck depth of G73 and G83 without Q, mm (0: in one stroke)</source>
        <translation>Profundidad de pasada de G73 y G83 sin Q, mm (0: de una vez)</translation>
    </message>
    <message>
        <source>spindle speed of tapping without S, 1/min</source>
        <translation>Velocidad del husillo al roscar sin S, 1/min</translation>
    </message>
    <message>
        <source>direction in which a boring tool lifts off (X, -X, Y, -Y, Z, -Z)</source>
        <translation>Dirección en que se separa una herramienta de mandrinar (X, -X, Y, -Y, Z, -Z)</translation>
    </message>
    <message>
        <source>lift-off of a boring tool without Q, mm</source>
        <translation>Separación de una herramienta de mandrinar sin Q, mm</translation>
    </message>
    <message>
        <source>angle of the spindle when a boring tool lifts off, degrees</source>
        <translation>Ángulo del husillo al separarse una herramienta de mandrinar, grados</translation>
    </message>
    <message>
        <source>an arc without centre and radius is a straight line</source>
        <translation>Un arco sin centro ni radio es una recta</translation>
    </message>
    <message>
        <source>settable work offset for G54.1 P1 (507: G507)</source>
        <translation>Decalaje de origen ajustable para G54.1 P1 (507: G507)</translation>
    </message>
    <message>
        <source>retraction of G73 and G83 within the hole, mm</source>
        <translation>Retirada de G73 y G83 dentro del agujero, mm</translation>
    </message>
    <message>
        <source>before the start the tool stands where the first G92 says, in the work offset of the control</source>
        <translation>antes del inicio, la herramienta está donde dice el primer G92, en el decalaje de origen del control</translation>
    </message>
</context>
<context>
    <name>CreditTestTexts</name>
    <message>
        <source>%1 of %2 answers while busy, the slowest after %3</source>
        <translation>%1 de %2 respuestas con carga, la más lenta tras %3</translation>
    </message>
    <message>
        <source>Method credit lets the axes move on while the next window is on its way. That is safe only on a control that answers while its axes are busy. This test finds out: a program that moves no axis, for a few seconds. The channel must be in reset.</source>
        <translation>Con el método Crédito, los ejes siguen moviéndose mientras la ventana siguiente está en camino. Solo es seguro en un control que responde mientras sus ejes están ocupados. Esta prueba lo comprueba: un programa que no mueve ningún eje, durante unos segundos. El canal debe estar en Reset.</translation>
    </message>
    <message>
        <source>4. Numbers are sent and must come back while the control is busy.</source>
        <translation>4. Se envían números que deben volver mientras el control está ocupado.</translation>
    </message>
    <message>
        <source>Not tested: method credit does not start on this control</source>
        <translation>Sin probar: el método Crédito no se inicia en este control</translation>
    </message>
    <message>
        <source>Passed: method credit may run on this control</source>
        <translation>Superada: el método Crédito está permitido en este control</translation>
    </message>
    <message>
        <source>Not passed: method credit does not start. Use method window.</source>
        <translation>No superada: el método Crédito no se inicia. Usar el método Ventana.</translation>
    </message>
    <message>
        <source>The control answers the client while blocks wait to be executed.</source>
        <translation>El control responde al cliente mientras hay secuencias esperando su ejecución.</translation>
    </message>
    <message>
        <source>What a synchronized action writes reaches the client.</source>
        <translation>Lo que escribe una acción síncrona llega al cliente.</translation>
    </message>
    <message>
        <source>What a synchronized action writes reaches the program without a stop.</source>
        <translation>Lo que escribe una acción síncrona llega al programa sin parada.</translation>
    </message>
    <message>
        <source>A synchronized action before a block is executed with that block.</source>
        <translation>Una acción síncrona antes de una secuencia se ejecuta con esa secuencia.</translation>
    </message>
    <message>
        <source>The program can tell, without a stop, whether blocks are waiting ($AC_IPO_BUF).</source>
        <translation>El programa sabe, sin parada, si hay secuencias esperando ($AC_IPO_BUF).</translation>
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
        <translation>Advertencia</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Error</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: the run does not wait here, and no tool is changed.</source>
        <translation>%1 no se envía al control: la ejecución no espera aquí y no se cambia ninguna herramienta.</translation>
    </message>
    <message>
        <source>A block with &quot;/&quot; is executed: Rivulet reads the program with block skip off.</source>
        <translation>Se ejecuta una secuencia con «/»: Rivulet lee el programa sin omisión de secuencias.</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: set spindle, tool and coolant there.</source>
        <translation>%1 no se envía al control: ajustar allí cabezal, herramienta y refrigerante.</translation>
    </message>
    <message>
        <source>The character &quot;%1&quot; has no meaning here: remove it or put it into a comment.</source>
        <translation>El carácter «%1» no tiene aquí ningún significado: borrarlo o ponerlo en un comentario.</translation>
    </message>
    <message>
        <source>The word %1 has no number.</source>
        <translation>A la palabra %1 le falta el número.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number: write digits with a decimal point.</source>
        <translation>«%1» no es un número: escribir cifras con punto decimal.</translation>
    </message>
    <message>
        <source>A bracket is opened but not closed in this line: the rest of the line is not read.</source>
        <translation>En esta línea se abre un paréntesis que no se cierra: el resto de la línea no se lee.</translation>
    </message>
    <message>
        <source>Rivulet does not know the G function %1: its effect on the path is unknown.</source>
        <translation>Rivulet no conoce la función G %1: se desconoce su efecto en la trayectoria.</translation>
    </message>
    <message>
        <source>The word %1 is not understood here: its effect on the path is unknown.</source>
        <translation>La palabra %1 no se entiende aquí: se desconoce su efecto en la trayectoria.</translation>
    </message>
    <message>
        <source>%1 changes the path or the feed in a way that Rivulet does not support: post-process the program without it.</source>
        <translation>%1 cambia la trayectoria o el avance de una forma que Rivulet no admite: posprocesar el programa sin esta función.</translation>
    </message>
    <message>
        <source>%1 is not sent to the control: it does not change the path.</source>
        <translation>%1 no se envía al control: no cambia la trayectoria.</translation>
    </message>
    <message>
        <source>%1 contradict each other in one block: keep one of them.</source>
        <translation>%1 se contradicen en una misma secuencia: dejar solo una.</translation>
    </message>
    <message>
        <source>The word %1 appears twice in one block: keep one of them.</source>
        <translation>La palabra %1 aparece dos veces en una misma secuencia: dejar solo una.</translation>
    </message>
    <message>
        <source>The arc has no centre: give I, J, K, or a radius with an end point that differs from the start.</source>
        <translation>El arco no tiene centro: indicar I, J, K, o un radio con un punto final distinto del inicial.</translation>
    </message>
    <message>
        <source>The arc&apos;s radius differs by %1 mm between start and end: check the centre, which is read as an increment from the start.</source>
        <translation>El radio del arco difiere en %1 mm entre el inicio y el final: comprobar el centro, que se lee como incremento desde el inicio.</translation>
    </message>
    <message>
        <source>The arc&apos;s radius is too small to reach its end point (radius &lt; half chord, mm: %1).</source>
        <translation>El radio del arco es demasiado pequeño para llegar a su punto final (radio &lt; media cuerda, mm: %1).</translation>
    </message>
    <message>
        <source>The arc starts at an unknown position: program %1 with G0 or G1 before it.</source>
        <translation>El arco empieza en una posición desconocida: programar antes %1 con G0 o G1.</translation>
    </message>
    <message>
        <source>The increment of %1 starts at an unknown position: program %1 with G90 before it.</source>
        <translation>La cota incremental de %1 parte de una posición desconocida: programar antes %1 con G90.</translation>
    </message>
    <message>
        <source>The feed F%1 is not greater than 0.</source>
        <translation>El avance F%1 no es mayor que 0.</translation>
    </message>
    <message>
        <source>The value of %1 is outside the range that Rivulet accepts.</source>
        <translation>El valor de %1 está fuera del rango que acepta Rivulet.</translation>
    </message>
    <message>
        <source>An axis is programmed before any of G0 to G3: G1 is assumed, as after a reset of the control.</source>
        <translation>Se programa un eje antes de cualquiera de G0 a G3: se supone G1, como después de un Reset del control.</translation>
    </message>
    <message>
        <source>The centre word %1 is not in the plane of the arc: check G17, G18, G19.</source>
        <translation>La palabra de centro %1 no está en el plano del arco: comprobar G17, G18, G19.</translation>
    </message>
    <message>
        <source>The program has more than %1 points: it is not read further. Split it.</source>
        <translation>El programa tiene más de %1 puntos: no se sigue leyendo. Dividirlo.</translation>
    </message>
    <message>
        <source>%1 more findings from here on are not listed.</source>
        <translation>A partir de aquí hay %1 observaciones más que no se muestran.</translation>
    </message>
    <message>
        <source>Rivulet does not execute &quot;%1&quot;: its effect on the path is unknown.</source>
        <translation>Rivulet no ejecuta «%1»: se desconoce su efecto en la trayectoria.</translation>
    </message>
    <message>
        <source>The loop that ends here does not terminate: reading stopped after %1 repeated blocks. Check its condition.</source>
        <translation>El bucle que acaba aquí no termina: la lectura se detuvo tras %1 secuencias repetidas. Comprobar su condición.</translation>
    </message>
    <message>
        <source>The calculation has no result: %1.</source>
        <translation>El cálculo no tiene resultado: %1.</translation>
    </message>
    <message>
        <source>The sequence of the blocks is not known from here on: %1.</source>
        <translation>A partir de aquí no se conoce el orden de las secuencias: %1.</translation>
    </message>
    <message>
        <source>The subprogram %1 is neither in this file nor in a file beside it: its points are missing.</source>
        <translation>El subprograma %1 no está ni en este archivo ni en otro archivo junto a él: faltan sus puntos.</translation>
    </message>
    <message>
        <source>%1 is a cycle of the control: its motions are missing here.</source>
        <translation>%1 es un ciclo del control: aquí faltan sus movimientos.</translation>
    </message>
    <message>
        <source>%1 moves in machine coordinates, whose position in the workpiece is not known: the move is left out.</source>
        <translation>%1 se mueve en coordenadas de máquina, cuya posición en la pieza no se conoce: se omite el movimiento.</translation>
    </message>
    <message>
        <source>The file holds bytes that do not occur in NC text: choose a text file, not an archive or a picture.</source>
        <translation>El archivo contiene bytes que no aparecen en un texto CN: elegir un archivo de texto, no un archivo comprimido ni una imagen.</translation>
    </message>
    <message>
        <source>%1 is left out because you accepted it: the path may differ from the path at the control.</source>
        <translation>%1 se omite porque usted lo aceptó: la trayectoria puede diferir de la del control.</translation>
    </message>
    <message>
        <source>All arcs of the program fit if I, J and K are read as %1: check how the post-processor writes them, and load the program that way.</source>
        <translation>Todos los arcos del programa encajan si I, J y K se leen como %1: comprobar cómo los escribe el posprocesador y cargar así el programa.</translation>
    </message>
    <message>
        <source>The program moves no axis: there is nothing to stream. Choose a program with G0, G1, G2 or G3 and X, Y or Z.</source>
        <translation>El programa no mueve ningún eje: no hay nada que transmitir. Elegir un programa con G0, G1, G2 o G3 y X, Y o Z.</translation>
    </message>
    <message>
        <source>%1 moves on the path: only method window streams it, and only if this axis is selected.</source>
        <translation>%1 se mueve en la trayectoria: solo lo transmite el método Ventana, y solo si este eje está seleccionado.</translation>
    </message>
    <message>
        <source>With %1, X, Y and Z are those of the tool tip while rotary axes turn, and no method switches it on at the control. Post-process the program for the axes of the machine.</source>
        <translation>Con %1, X, Y y Z son los de la punta de la herramienta mientras giran los ejes giratorios, y ningún método lo activa en el control. Posprocesar el programa para los ejes de la máquina.</translation>
    </message>
    <message>
        <source>%1 give the tool direction. The points keep it, but only the control could convert it to rotary axes. Post-process the program with A, B or C.</source>
        <translation>%1 indican la dirección de la herramienta. Los puntos la conservan, pero solo el control podría convertirla en ejes giratorios. Posprocesar el programa con A, B o C.</translation>
    </message>
    <message>
        <source>A block moves with G1, G2 or G3 before a feed F is programmed: only a fixed feed can be used.</source>
        <translation>Una secuencia se mueve con G1, G2 o G3 antes de programar un avance F: solo se puede usar un avance fijo.</translation>
    </message>
    <message>
        <source>A blank is inside the number &quot;%1&quot;: this control does not put the parts together. Write the number without blanks.</source>
        <translation>Hay un espacio dentro del número «%1»: este control no une las partes. Escriba el número sin espacios.</translation>
    </message>
    <message>
        <source>An invisible character stands here (%1), as office programs and web pages insert it: replace it by an ordinary blank.</source>
        <translation>Aquí hay un carácter invisible (%1), como los que insertan los programas de oficina y las páginas web: sustitúyalo por un espacio normal.</translation>
    </message>
    <message>
        <source>A bracket is opened within the comment %1, which ends at the first closing bracket. Write it without inner brackets.</source>
        <translation>Se abre un paréntesis dentro del comentario %1, que termina en el primer paréntesis de cierre. Escríbalo sin paréntesis internos.</translation>
    </message>
    <message>
        <source>%1 is a function of the builder of the machine: whether it moves an axis or changes the feed is not known. Accept it if it does not.</source>
        <translation>%1 es una función del fabricante de la máquina: no se sabe si mueve un eje o cambia el avance. Acéptela si no lo hace.</translation>
    </message>
    <message>
        <source>The blocks of %1 are never executed: check the end of the program and the jumps before them, or remove them.</source>
        <translation>Los bloques de %1 no se ejecutan nunca: compruebe el final del programa y los saltos anteriores, o elimínelos.</translation>
    </message>
    <message>
        <source>No block calls the subprogram %1: check the calls, or remove it.</source>
        <translation>Ningún bloque llama al subprograma %1: compruebe las llamadas o elimínelo.</translation>
    </message>
    <message>
        <source>The file holds another main program, %1: which one is to run is not known. Give each main program a file of its own.</source>
        <translation>El archivo contiene otro programa principal, %1: no se sabe cuál debe ejecutarse. Dé a cada programa principal su propio archivo.</translation>
    </message>
    <message>
        <source>With M99, a main program begins again at the control, without end: it is executed once here. Write M30 if it is to end.</source>
        <translation>Con M99, un programa principal vuelve a empezar sin fin en el control: aquí se ejecuta una vez. Escriba M30 si debe terminar.</translation>
    </message>
    <message>
        <source>Loops and calls repeat more than %1 blocks for the control: the program is not read further. Check the condition of the loop.</source>
        <translation>Bucles y llamadas repiten más de %1 bloques para el control: el programa no se lee más. Compruebe la condición del bucle.</translation>
    </message>
    <message>
        <source>The program is for a lathe (%1): X is read as a diameter, U and W as increments, the plane is Z X, and with G99 F is per revolution.</source>
        <translation>El programa es para un torno (%1): X se lee como diámetro, U y W como incrementos, el plano es Z X y con G99 F es por vuelta.</translation>
    </message>
    <message>
        <source>No block says mm or inch (G21, G20) before the first move: the size is %1, read as mm or as inch. Load it with its unit (--units).</source>
        <translation>Ningún bloque dice mm o pulgadas (G21, G20) antes del primer movimiento: el tamaño es %1, leído en mm o en pulgadas. Cárguelo con su unidad (--units).</translation>
    </message>
    <message>
        <source>Coordinates have no decimal point: the size is %1, read as whole units or as least increments. Load it as the control is set (--no-point).</source>
        <translation>Las coordenadas no tienen punto decimal: el tamaño es %1, leído en unidades enteras o en incrementos mínimos. Cárguelo según el ajuste del control (--no-point).</translation>
    </message>
    <message>
        <source>The program is larger than a machine (%1): check its unit (G20, G21, --units) and its decimal points.</source>
        <translation>El programa es más grande que una máquina (%1): compruebe su unidad (G20, G21, --units) y sus puntos decimales.</translation>
    </message>
    <message>
        <source>The words after &quot;;&quot; are read as a block of their own, as on the control. If &quot;;&quot; begins comments here, choose another dialect (--dialect).</source>
        <translation>Las palabras tras «;» se leen como un bloque propio, como en el control. Si «;» inicia aquí comentarios, elija otro dialecto (--dialect).</translation>
    </message>
    <message>
        <source>The text does not show which control it is for, and they differ from here on: %1. Choose the dialect (--dialect).</source>
        <translation>El texto no muestra para qué control es, y difieren a partir de aquí: %1. Elija el dialecto (--dialect).</translation>
    </message>
    <message>
        <source>The file has words of two controls (%1): split it, or choose the dialect (--dialect).</source>
        <translation>El archivo tiene palabras de dos controles (%1): divídalo o elija el dialecto (--dialect).</translation>
    </message>
    <message>
        <source>The corner cannot be rounded or chamfered: there must be an element of the contour before and behind it, both long enough.</source>
        <translation>La esquina no se puede redondear ni achaflanar: antes y después debe haber un elemento de contorno suficientemente largo.</translation>
    </message>
    <message>
        <source>The program ends here with its own error (%1): check the values it has been given.</source>
        <translation>El programa termina aquí con su propio error (%1): compruebe los valores que ha recibido.</translation>
    </message>
    <message>
        <source>The block lacks a word that the control needs (%1): add it.</source>
        <translation>Al bloque le falta una palabra que el control necesita (%1): añádala.</translation>
    </message>
    <message>
        <source>%1 is not the number of the tool in the spindle: check which length it stands for.</source>
        <translation>%1 no es el número de la herramienta del husillo: compruebe a qué longitud corresponde.</translation>
    </message>
    <message>
        <source>%1 executes a text that is put together while the program runs: what it does is not known here. Write the block itself.</source>
        <translation>%1 ejecuta un texto que se compone durante la ejecución del programa: aquí no se sabe qué hace. Escriba el propio bloque.</translation>
    </message>
    <message>
        <source>%1 limits the speed of an axis, and a stream does not keep the limit: program a feed that keeps it, and remove the word.</source>
        <translation>%1 limita la velocidad de un eje, y un flujo no respeta ese límite: programe un avance que lo respete y quite la palabra.</translation>
    </message>
    <message>
        <source>%1 calls a subprogram behind each block that moves, and it is neither in this file nor in a file beside it: its motions are missing. Put its file beside the program.</source>
        <translation>%1 llama tras cada bloque con movimiento a un subprograma que no está ni en este archivo ni en otro junto a él: faltan sus movimientos. Ponga su archivo junto al programa.</translation>
    </message>
    <message>
        <source>What the program leaves out is taken from the settings of a virtual machine: %1. Load it as the control is set (--setting).</source>
        <translation>Lo que el programa omite se toma de los ajustes de una máquina virtual: %1. Cárguelo como está ajustado el control (--setting).</translation>
    </message>
    <message>
        <source>The number of the last F may mean another feed here, because mm, inch, G94 or G95 was chosen behind it: program F again.</source>
        <translation>El número del último F puede significar aquí otro avance, porque después se eligió mm, pulgadas, G94 o G95: programe F de nuevo.</translation>
    </message>
</context>
<context>
    <name>EmulatorPageTexts</name>
    <message>
        <source>A run is in progress. Learn after it has ended: both would take the same processor.</source>
        <translation>Hay una ejecución en curso. Aprender después: ambas usarían el mismo procesador.</translation>
    </message>
</context>
<context>
    <name>EmulatorTexts</name>
    <message>
        <source>Position gain</source>
        <translation>Ganancia de posición</translation>
    </message>
    <message>
        <source>The larger it is, the smaller the following error.</source>
        <translation>Cuanto mayor, menor es el error de seguimiento.</translation>
    </message>
    <message>
        <source>Feed-forward</source>
        <translation>Control anticipativo</translation>
    </message>
    <message>
        <source>Share of the speed that needs no following error. With 1 there is none at constant speed.</source>
        <translation>Parte de la velocidad que no necesita error de seguimiento. Con 1 no lo hay a velocidad constante.</translation>
    </message>
    <message>
        <source>Filter of the feed-forward</source>
        <translation>Filtro del control anticipativo</translation>
    </message>
    <message>
        <source>How late the feed-forward takes effect.</source>
        <translation>Con cuánto retardo actúa el control anticipativo.</translation>
    </message>
    <message>
        <source>Speed gain</source>
        <translation>Ganancia de velocidad</translation>
    </message>
    <message>
        <source>How quickly the drive reaches the speed it is told.</source>
        <translation>Con qué rapidez alcanza el accionamiento la velocidad pedida.</translation>
    </message>
    <message>
        <source>Reset time</source>
        <translation>Tiempo de integración</translation>
    </message>
    <message>
        <source>How soon the drive removes the rest of an error in speed.</source>
        <translation>En cuánto tiempo elimina el accionamiento el resto de un error de velocidad.</translation>
    </message>
    <message>
        <source>Lag of the drive</source>
        <translation>Retardo del accionamiento</translation>
    </message>
    <message>
        <source>How late the force follows its command.</source>
        <translation>Con cuánto retardo sigue la fuerza a su orden.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Fricción</translation>
    </message>
    <message>
        <source>Force against every motion, as the acceleration it costs. It makes the bumps where an axis reverses.</source>
        <translation>Fuerza contra todo movimiento, expresada como la aceleración que cuesta. Causa los picos donde un eje se invierte.</translation>
    </message>
    <message>
        <source>Speed of friction</source>
        <translation>Velocidad de la fricción</translation>
    </message>
    <message>
        <source>From this speed on, friction has its full force.</source>
        <translation>Desde esta velocidad la fricción actúa por completo.</translation>
    </message>
    <message>
        <source>Viscous friction</source>
        <translation>Fricción viscosa</translation>
    </message>
    <message>
        <source>Friction that grows with the speed.</source>
        <translation>Fricción que crece con la velocidad.</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Retardo puro</translation>
    </message>
    <message>
        <source>Time until a set point takes effect.</source>
        <translation>Tiempo hasta que una consigna tiene efecto.</translation>
    </message>
    <message>
        <source>Resonance</source>
        <translation>Resonancia</translation>
    </message>
    <message>
        <source>Frequency at which motor and table swing against each other.</source>
        <translation>Frecuencia con la que motor y mesa oscilan entre sí.</translation>
    </message>
    <message>
        <source>Damping of the resonance</source>
        <translation>Amortiguación de la resonancia</translation>
    </message>
    <message>
        <source>The smaller it is, the longer the axis oscillates. At 1 it does not oscillate.</source>
        <translation>Cuanto menor, más dura la oscilación; con 1 no la hay.</translation>
    </message>
    <message>
        <source>On %1, which it was not learned from, positions are right within %2 (RMS), %3 at most.</source>
        <translation>En %1, de la que no aprendió, las posiciones aciertan dentro de %2 (RMS), %3 como máximo.</translation>
    </message>
    <message>
        <source>The contour error there is off by %1 of %2 (RMS).</source>
        <translation>El error de contorno se desvía allí %1 de %2 (RMS).</translation>
    </message>
    <message>
        <source>Good for simulating and timing programs that move %1 at feeds up to %2. What is faster was not tested.</source>
        <translation>Sirve para simular programas que mueven %1 hasta %2 y estimar su duración. Lo más rápido no está comprobado.</translation>
    </message>
    <message>
        <source>Do not rely on the contour errors that it predicts.</source>
        <translation>No fiarse de los errores de contorno que predice.</translation>
    </message>
    <message>
        <source>Limits of speed, acceleration and jerk are those of preset %1: correct them in the file if the machine has others.</source>
        <translation>Los límites de velocidad, aceleración y sobreaceleración son los del preajuste %1: corregirlos en el archivo si la máquina tiene otros.</translation>
    </message>
    <message>
        <source>Acceleration and jerk are limited as the set points show (%1), all else as in preset %2.</source>
        <translation>La aceleración y la sobreaceleración se limitan como muestran las consignas (%1); todo lo demás, como en el preajuste %2.</translation>
    </message>
    <message>
        <source>It was tested only on parts of the same recordings: right within %1 (RMS). Add a recording of another program and use it to test.</source>
        <translation>Solo se comprobó con partes de las mismas grabaciones: acierta dentro de %1 (RMS). Añadir la grabación de otro programa y usarla para comprobar.</translation>
    </message>
</context>
<context>
    <name>ErrorTexts</name>
    <message>
        <source>Two columns have the same meaning. Choose one of them.</source>
        <translation>Dos columnas tienen el mismo significado. Elegir una de ellas.</translation>
    </message>
    <message>
        <source>The file cannot be read. Check that it exists and that you may read it.</source>
        <translation>No se puede leer el archivo. Comprobar que existe y que se tiene permiso para leerlo.</translation>
    </message>
    <message>
        <source>The program is empty. Choose a file with NC blocks.</source>
        <translation>El programa está vacío. Elegir un archivo con secuencias CN.</translation>
    </message>
    <message>
        <source>The program moves no axis. Choose a program with G0, G1, G2 or G3.</source>
        <translation>El programa no mueve ningún eje. Elegir un programa con G0, G1, G2 o G3.</translation>
    </message>
    <message>
        <source>Parts of the program are not understood. See the list of findings.</source>
        <translation>Hay partes del programa que no se entienden. Véase la lista de observaciones.</translation>
    </message>
    <message>
        <source>The feed F must be between 0.001 and 1 000 000 mm/min.</source>
        <translation>El avance F debe estar entre 0,001 y 1 000 000 mm/min.</translation>
    </message>
    <message>
        <source>The distance δ must be greater than zero.</source>
        <translation>La distancia δ debe ser mayor que cero.</translation>
    </message>
    <message>
        <source>N is too small. Choose at least 2 points per loop.</source>
        <translation>N es demasiado pequeño. Elegir al menos 2 puntos por bucle.</translation>
    </message>
    <message>
        <source>N is too small for this method. Choose more points per loop.</source>
        <translation>N es demasiado pequeño para este método. Elegir más puntos por bucle.</translation>
    </message>
    <message>
        <source>N points do not fit the R-parameters of the control. Choose a smaller N, the contiguous layout, or enlarge MD28050.</source>
        <translation>N puntos no caben en los parámetros R del control. Elegir un N menor o la disposición contigua, o aumentar MD28050.</translation>
    </message>
    <message>
        <source>No axis is chosen. Choose at least one axis.</source>
        <translation>No hay ningún eje seleccionado. Seleccionar al menos uno.</translation>
    </message>
    <message>
        <source>The file cannot be written. Choose another folder.</source>
        <translation>No se puede escribir el archivo. Elegir otra carpeta.</translation>
    </message>
    <message>
        <source>This file is not a Rivulet recording.</source>
        <translation>Este archivo no es una grabación de Rivulet.</translation>
    </message>
    <message>
        <source>The recording was written by a newer Rivulet. Update this program to read it.</source>
        <translation>La grabación es de un Rivulet más nuevo. Actualizar este programa para leerla.</translation>
    </message>
    <message>
        <source>The recording is damaged. Everything before the damage was kept.</source>
        <translation>La grabación está dañada. Se conservó todo lo anterior al daño.</translation>
    </message>
    <message>
        <source>The file cannot be written. Check the folder and the free space.</source>
        <translation>No se puede escribir el archivo. Comprobar la carpeta y el espacio libre.</translation>
    </message>
    <message>
        <source>The program has been changed since the interrupted run. Restore it, or start from the beginning.</source>
        <translation>El programa ha cambiado desde la ejecución interrumpida. Restaurarlo o empezar desde el principio.</translation>
    </message>
    <message>
        <source>No OPC UA server answers at this endpoint. Check address, port and network.</source>
        <translation>Ningún servidor OPC UA responde en esta dirección. Comprobar dirección, puerto y red.</translation>
    </message>
    <message>
        <source>The connection to the control is lost. Check the machine, then connect again.</source>
        <translation>Se ha perdido la conexión con el control. Comprobar la máquina y volver a conectar.</translation>
    </message>
    <message>
        <source>The control did not answer in time. Check the network and its load.</source>
        <translation>El control no respondió a tiempo. Comprobar la red y su carga.</translation>
    </message>
    <message>
        <source>The control does not have a variable that Rivulet needs. Check the configuration of the server.</source>
        <translation>Al control le falta una variable que Rivulet necesita. Comprobar la configuración del servidor.</translation>
    </message>
    <message>
        <source>A variable is write-protected. Give this user write access on the control.</source>
        <translation>Una variable está protegida contra escritura. Dar a este usuario permiso de escritura en el control.</translation>
    </message>
    <message>
        <source>A value cannot be used; nothing was sent.</source>
        <translation>Un valor no es utilizable; no se ha enviado nada.</translation>
    </message>
    <message>
        <source>The control rejected the request.</source>
        <translation>El control rechazó la petición.</translation>
    </message>
    <message>
        <source>The server is not a SINUMERIK (no SinumerikVarProvider). Check the endpoint.</source>
        <translation>El servidor no es un SINUMERIK (falta SinumerikVarProvider). Comprobar la dirección.</translation>
    </message>
    <message>
        <source>The server does not offer this function.</source>
        <translation>El servidor no ofrece esta función.</translation>
    </message>
    <message>
        <source>There is no such program on the control. Send the template first.</source>
        <translation>Este programa no existe en el control. Enviar primero la plantilla.</translation>
    </message>
    <message>
        <source>The channel is not in reset. Press reset at the control, then try again.</source>
        <translation>El canal no está en Reset. Pulsar Reset en el control y volver a intentarlo.</translation>
    </message>
    <message>
        <source>A program of this name is already on the control.</source>
        <translation>En el control ya hay un programa con este nombre.</translation>
    </message>
    <message>
        <source>The request is larger than the server accepts. Choose a smaller N.</source>
        <translation>La petición es mayor de lo que acepta el servidor. Elegir un N menor.</translation>
    </message>
    <message>
        <source>This program cannot be streamed. See the list of findings.</source>
        <translation>Este programa no se puede transmitir de forma continua. Véase la lista de observaciones.</translation>
    </message>
    <message>
        <source>The control does not run the expected template. Select and start the template for these settings.</source>
        <translation>En el control no está en marcha la plantilla esperada. Seleccionar e iniciar la plantilla de estos ajustes.</translation>
    </message>
    <message>
        <source>Another program is running on the control. Wait until it has ended, or reset the channel.</source>
        <translation>En el control está en marcha otro programa. Esperar a que termine o hacer un Reset del canal.</translation>
    </message>
    <message>
        <source>Cycle start was not pressed in time. Start the run again.</source>
        <translation>No se pulsó Marcha CN a tiempo. Volver a iniciar la ejecución.</translation>
    </message>
    <message>
        <source>The control is running, but the stream makes no progress. Check feed override and feed hold at the control.</source>
        <translation>El control está en marcha, pero la transmisión no progresa. Comprobar en el control el override de avance y la parada de avance.</translation>
    </message>
    <message>
        <source>The control did not confirm the stop in time. Check the machine.</source>
        <translation>El control no confirmó la parada a tiempo. Comprobar la máquina.</translation>
    </message>
    <message>
        <source>The control ended the program with an alarm. Clear its cause at the control.</source>
        <translation>El control terminó el programa con una alarma. Eliminar su causa en el control.</translation>
    </message>
    <message>
        <source>The program on the control ended before all of it was executed.</source>
        <translation>El programa del control terminó antes de ejecutarse entero.</translation>
    </message>
    <message>
        <source>Another client is using the program on the control. Rivulet writes nothing more: wait until the other client has finished, or reset the control.</source>
        <translation>Otro cliente está usando el programa del control. Rivulet no escribe nada más: esperar a que el otro cliente termine, o hacer un Reset del control.</translation>
    </message>
    <message>
        <source>The program on the control was restarted during the run. Reset the control, then resume.</source>
        <translation>El programa del control se reinició durante la ejecución. Hacer un Reset del control y reanudar.</translation>
    </message>
    <message>
        <source>The control rejected a window that did not match its check number, and did not execute it. Something else writes these R-parameters, or a value was changed on its way: look for another client, or connect encrypted, then resume.</source>
        <translation>El control rechazó una ventana que no coincidía con su número de comprobación y no la ejecutó. Alguna otra cosa escribe estos parámetros R, o un valor se alteró por el camino: buscar otro cliente o conectarse con cifrado y reanudar.</translation>
    </message>
    <message>
        <source>The control ended its program because it received nothing from Rivulet for too long. Check the network, then resume.</source>
        <translation>El control terminó su programa porque no recibió nada de Rivulet durante demasiado tiempo. Comprobar la red y reanudar.</translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation>Se canceló la carga.</translation>
    </message>
    <message>
        <source>It is not known for certain where the run was left. Start from the beginning.</source>
        <translation>No se sabe con certeza dónde se interrumpió la ejecución. Empezar desde el principio.</translation>
    </message>
    <message>
        <source>The control does not let Rivulet write and read part programs. Grant the OPC UA user these rights, or copy the template to the control by hand.</source>
        <translation>El control no permite a Rivulet escribir y leer programas de pieza. Dar estos permisos al usuario OPC UA, o copiar a mano la plantilla en el control.</translation>
    </message>
    <message>
        <source>Only method window streams rotary axes. Choose it.</source>
        <translation>Solo el método Ventana transmite ejes giratorios. Elegir este método.</translation>
    </message>
    <message>
        <source>Too many axes. Choose at most five.</source>
        <translation>Demasiados ejes. Elegir cinco como máximo.</translation>
    </message>
    <message>
        <source>These are not axes. Choose from X, Y, Z, A, B and C.</source>
        <translation>Estos no son ejes. Elegir entre X, Y, Z, A, B y C.</translation>
    </message>
    <message>
        <source>This make of control cannot do that. Choose another method or setting.</source>
        <translation>Este control no puede hacerlo. Elegir otro método u otro ajuste.</translation>
    </message>
    <message>
        <source>The program needs an axis that is not streamed. Move it to the position in the program, or stream it too.</source>
        <translation>El programa necesita un eje que no se transmite. Llevarlo a la posición del programa, o transmitirlo también.</translation>
    </message>
    <message>
        <source>The control lacks an axis that the program moves. Use a program for the axes of this machine.</source>
        <translation>Al control le falta un eje que el programa mueve. Usar un programa para los ejes de esta máquina.</translation>
    </message>
    <message>
        <source>No prediction is possible for this method.</source>
        <translation>No hay predicción posible para este método.</translation>
    </message>
    <message>
        <source>The test was aborted. Reset the control if its program is still running.</source>
        <translation>La prueba se interrumpió. Hacer un Reset del control si su programa sigue en marcha.</translation>
    </message>
    <message>
        <source>Method credit is experimental and starts only on a control that has passed its test. Pass it on the page Credit test, or choose method window.</source>
        <translation>El método Crédito es experimental y solo se inicia en un control que ha superado su prueba. Ejecutar la prueba en la página Prueba crédito, o elegir el método Ventana.</translation>
    </message>
    <message>
        <source>Online correction is possible with method window, for X, Y and Z, up to 1 mm.</source>
        <translation>La corrección en línea es posible con el método Ventana, para X, Y y Z, hasta 1 mm.</translation>
    </message>
    <message>
        <source>An overlay is already active on the axes. Remove it at the control: press reset, wait, and check that $AA_OFF is 0.</source>
        <translation>Ya hay una superposición activa en los ejes. Quitarla en el control: pulsar Reset, esperar y comprobar que $AA_OFF es 0.</translation>
    </message>
    <message>
        <source>The control adds up overlaid values (MD36750 bit 0). Set the bit to 0, or do without online correction.</source>
        <translation>El control suma los valores superpuestos (MD36750 bit 0). Poner el bit a 0, o prescindir de la corrección en línea.</translation>
    </message>
    <message>
        <source>This is not a machine file of Rivulet. Move the file away.</source>
        <translation>Este no es un archivo de máquina de Rivulet. Moverlo a otro sitio.</translation>
    </message>
    <message>
        <source>This was written by another version of Rivulet. Measure again.</source>
        <translation>El archivo es de otra versión de Rivulet. Volver a medir.</translation>
    </message>
    <message>
        <source>The calibration is damaged. Measure again.</source>
        <translation>La calibración está dañada. Volver a medir.</translation>
    </message>
    <message>
        <source>Another client has claimed the R-parameters of this run and is about to start. Nothing was changed. Wait until its run has ended.</source>
        <translation>Otro cliente ha reservado los parámetros R de esta ejecución y está a punto de iniciar. No se ha cambiado nada. Esperar a que termine su ejecución.</translation>
    </message>
    <message>
        <source>A block of the program moves at a feed that is not known: F is missing, G95 has no spindle speed, or G93 no length. Choose one feed for all moves.</source>
        <translation>Una secuencia del programa se mueve con un avance que no se conoce: falta F, a G95 le falta la velocidad del cabezal o a G93 la longitud. Elegir un solo avance para todos los movimientos.</translation>
    </message>
    <message>
        <source>This method has one feed for all moves, as it was published.</source>
        <translation>Este método tiene un solo avance para todos los movimientos, tal como se publicó.</translation>
    </message>
    <message>
        <source>The override is out of range: choose 1 to 200 %.</source>
        <translation>El override está fuera de rango: elegir de 1 a 200&#xa0;%.</translation>
    </message>
    <message>
        <source>The formula is not understood from here on.</source>
        <translation>La fórmula no se entiende a partir de aquí.</translation>
    </message>
    <message>
        <source>The formula is not complete.</source>
        <translation>La fórmula no está completa.</translation>
    </message>
    <message>
        <source>There is no such function. Press F1 for those there are.</source>
        <translation>Esa función no existe. F1 muestra las que hay.</translation>
    </message>
    <message>
        <source>The trace has no such signal. The tool tips of the signals have their names.</source>
        <translation>El registro no tiene esa señal. Los nombres están en las ayudas de las señales.</translation>
    </message>
    <message>
        <source>This is no trace that can be read: there are no rows of numbers in it.</source>
        <translation>No es un registro legible: el archivo no contiene filas de números.</translation>
    </message>
    <message>
        <source>The table has no such column.</source>
        <translation>La tabla no tiene esa columna.</translation>
    </message>
    <message>
        <source>The trace has no positions: compare it by time.</source>
        <translation>El registro no tiene posiciones: compararlo en el tiempo.</translation>
    </message>
    <message>
        <source>To compare by points, open the NC program that the traces show.</source>
        <translation>Para comparar por puntos, abrir el programa NC que muestran los registros.</translation>
    </message>
    <message>
        <source>The runs are of different programs: compare them by time or path.</source>
        <translation>Las ejecuciones son de programas distintos: compararlas por tiempo o por recorrido.</translation>
    </message>
    <message>
        <source>A spectrum needs 16 samples or more between the cursors.</source>
        <translation>Un espectro necesita al menos 16 muestras entre los cursores.</translation>
    </message>
    <message>
        <source>The server does not offer the encryption that is required. Set it up on the control, or allow this machine to be reached without it.</source>
        <translation>El servidor no ofrece el cifrado exigido. Configúrelo en el control, o permita para esta máquina una conexión sin cifrar.</translation>
    </message>
    <message>
        <source>The server&apos;s certificate is not known yet. Compare its fingerprint with the one at the control, then accept it.</source>
        <translation>El certificado del servidor aún no se conoce. Compare su huella con la del control y después acéptelo.</translation>
    </message>
    <message>
        <source>The server shows another certificate than the one that was accepted. Find out why before you accept it.</source>
        <translation>El servidor muestra un certificado distinto del aceptado. Averigüe el motivo antes de aceptarlo.</translation>
    </message>
    <message>
        <source>A certificate cannot be used: it is damaged or has ended. Create a new one.</source>
        <translation>Un certificado no se puede usar: está dañado o ha caducado. Cree uno nuevo.</translation>
    </message>
    <message>
        <source>The server does not trust the certificate of this computer. Accept it at the control, then connect again.</source>
        <translation>El servidor no confía en el certificado de este equipo. Acéptelo en el control y vuelva a conectar.</translation>
    </message>
    <message>
        <source>The server refuses user name or password. Check both.</source>
        <translation>El servidor rechaza el usuario o la contraseña. Compruebe ambos.</translation>
    </message>
    <message>
        <source>The line is neither a point nor end, hold or comment.</source>
        <translation>La línea no es un punto ni end, hold o comment.</translation>
    </message>
    <message>
        <source>A word of the line has no number.</source>
        <translation>Una palabra de la línea no tiene número.</translation>
    </message>
    <message>
        <source>The line is too long.</source>
        <translation>La línea es demasiado larga.</translation>
    </message>
    <message>
        <source>The source was closed in the middle of the line.</source>
        <translation>La fuente se cerró en medio de la línea.</translation>
    </message>
    <message>
        <source>The point is outside the agreed box.</source>
        <translation>El punto está fuera del volumen acordado.</translation>
    </message>
    <message>
        <source>The step to the point is longer than agreed.</source>
        <translation>El paso hasta el punto es más largo de lo acordado.</translation>
    </message>
    <message>
        <source>A rotary axis would turn farther in one step than agreed.</source>
        <translation>Un eje rotativo giraría en un paso más de lo acordado.</translation>
    </message>
    <message>
        <source>F is larger than agreed, or not above 0.</source>
        <translation>F es mayor de lo acordado, o no está por encima de 0.</translation>
    </message>
    <message>
        <source>The first point is farther from the tool than agreed. Move the tool there, or begin where it is.</source>
        <translation>El primer punto está más lejos de la herramienta de lo acordado. Llevar allí la herramienta o empezar donde está.</translation>
    </message>
    <message>
        <source>The point names an axis that is not one of this run.</source>
        <translation>El punto nombra un eje que no es de esta ejecución.</translation>
    </message>
    <message>
        <source>A point is missing or came twice: the numbers are not in order.</source>
        <translation>Falta un punto o ha llegado dos veces: los números no están en orden.</translation>
    </message>
    <message>
        <source>The source was closed without end.</source>
        <translation>La fuente se cerró sin end.</translation>
    </message>
    <message>
        <source>The source was silent for longer than agreed.</source>
        <translation>La fuente estuvo en silencio más tiempo de lo acordado.</translation>
    </message>
    <message>
        <source>The source was faster than the machine and cannot wait. Send fewer points, or use TCP.</source>
        <translation>La fuente era más rápida que la máquina y no puede esperar. Enviar menos puntos o usar TCP.</translation>
    </message>
    <message>
        <source>The source ended before its first point. Nothing has moved.</source>
        <translation>La fuente terminó antes de su primer punto. No se ha movido nada.</translation>
    </message>
    <message>
        <source>The source cannot be opened. Choose another port or path.</source>
        <translation>La fuente no se puede abrir. Elegir otro puerto u otra ruta.</translation>
    </message>
    <message>
        <source>These values cannot be kept together. Check box, step and times.</source>
        <translation>Estos valores no son compatibles. Comprobar volumen, paso y tiempos.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línea %2</translation>
    </message>
    <message>
        <source>This source can lose points, so it has to number them: N1 X0.5, then N2.</source>
        <translation>Esta fuente puede perder puntos, por eso debe numerarlos: N1 X0.5, luego N2.</translation>
    </message>
    <message>
        <source>The file of the source is not as the manual shows it (Live points).</source>
        <translation>El archivo de la fuente no es como lo muestra el manual (puntos en directo).</translation>
    </message>
    <message>
        <source>This Rivulet was built without HDF5. Use CSV, or build it with libhdf5-dev.</source>
        <translation>Este Rivulet se compiló sin HDF5. Usar CSV o compilarlo con libhdf5-dev.</translation>
    </message>
    <message>
        <source>Times and positions do not fit together. Record the run again.</source>
        <translation>Los tiempos y las posiciones no concuerdan. Grabar de nuevo la ejecución.</translation>
    </message>
    <message>
        <source>A value is not a number. Leave its row out of the file.</source>
        <translation>Un valor no es un número. Quitar su fila del archivo.</translation>
    </message>
    <message>
        <source>An axis does not move in these recordings. Add one that moves it.</source>
        <translation>Un eje no se mueve en estas grabaciones. Añadir una que lo mueva.</translation>
    </message>
    <message>
        <source>There are too few samples to learn from. Record a longer program, with set points and actual positions.</source>
        <translation>Hay muy pocas muestras para aprender. Grabar un programa más largo, con consignas y posiciones reales.</translation>
    </message>
    <message>
        <source>Set points and actual positions differ by a factor. Check their units.</source>
        <translation>Las consignas y las posiciones reales difieren en un factor. Comprobar sus unidades.</translation>
    </message>
    <message>
        <source>Recording and program do not fit together. Check the program, and that the preset has the machine&apos;s limits.</source>
        <translation>La grabación y el programa no concuerdan. Comprobar el programa y que el preajuste tenga los límites de la máquina.</translation>
    </message>
    <message>
        <source>No model follows this recording. Check that set points and positions belong together.</source>
        <translation>Ningún modelo sigue esta grabación. Comprobar que consignas y posiciones van juntas.</translation>
    </message>
    <message>
        <source>Learning was cancelled. What was learned before stays.</source>
        <translation>Se canceló el aprendizaje. Queda lo aprendido antes.</translation>
    </message>
    <message>
        <source>The file is not an emulator, or one of a later version.</source>
        <translation>El archivo no es un emulador, o es de una versión posterior.</translation>
    </message>
    <message>
        <source>Rivulet was built without Qt OPC UA. Connect with open62541.</source>
        <translation>Rivulet se compiló sin Qt OPC UA. Conecte con open62541.</translation>
    </message>
    <message>
        <source>Qt OPC UA cannot encrypt, log in or use a map here. Connect with open62541.</source>
        <translation>Qt OPC UA no puede aquí cifrar, iniciar sesión ni usar un mapa. Conecte con open62541.</translation>
    </message>
    <message>
        <source>The map cannot be used. Correct the file at the place that is named.</source>
        <translation>El mapa no se puede usar. Corrija el archivo en el lugar indicado.</translation>
    </message>
    <message>
        <source>The map names a node that the server does not have, or one of another type. Correct the map.</source>
        <translation>El mapa nombra un nodo que el servidor no tiene, o de otro tipo. Corrija el mapa.</translation>
    </message>
    <message>
        <source>No computer of this name is known on the network. Check the name, or give the IP address of the control.</source>
        <translation>En la red no se conoce ningún ordenador con este nombre. Compruebe el nombre o indique la dirección IP del control.</translation>
    </message>
    <message>
        <source>Too many files and connections are open on this computer. Close other programs, then try again.</source>
        <translation>En este ordenador hay demasiados archivos y conexiones abiertos. Cierre otros programas y vuelva a intentarlo.</translation>
    </message>
    <message>
        <source>The text leaves open what it means. Choose the dialect, the unit or the reading of numbers without a decimal point.</source>
        <translation>El texto deja abierto lo que significa. Elija el dialecto, la unidad o la lectura de los números sin punto decimal.</translation>
    </message>
    <message>
        <source>The straight way to the first point passes within what the program cuts. Raise the tool first.</source>
        <translation>El camino recto al primer punto pasa por la zona que el programa mecaniza. Levante primero la herramienta.</translation>
    </message>
    <message>
        <source>This would take more memory than a file may. Choose a smaller one.</source>
        <translation>Esto necesitaría más memoria de la que puede ocupar un archivo. Elija uno más pequeño.</translation>
    </message>
    <message>
        <source>A factor of the feed would wait here behind points that are not read yet. Send factors over a source of their own.</source>
        <translation>Un factor del avance esperaría aquí detrás de puntos que aún no se han leído. Envíe los factores por una fuente propia.</translation>
    </message>
    <message>
        <source>A factor of the override is possible with methods window and credit, from 0.01 to 2, with 1 between its bounds.</source>
        <translation>Un factor del override es posible con los métodos Ventana y Crédito, de 0,01 a 2, con 1 entre sus límites.</translation>
    </message>
    <message>
        <source>The move of the test takes 2 to 30 s at its feed, so that it can be held on its way. Choose another length or feed.</source>
        <translation>El recorrido de la prueba dura de 2 a 30 s con su avance, para poder detenerlo a mitad de camino. Elija otra longitud u otro avance.</translation>
    </message>
    <message>
        <source>This is no trace, but the refusal of an MTConnect agent. Ask it for /sample.</source>
        <translation>Esto no es una traza, sino el rechazo de un agente MTConnect. Pedirle /sample.</translation>
    </message>
    <message>
        <source>The server keeps no history of this node. Have it recorded at the server.</source>
        <translation>El servidor no guarda ningún historial de este nodo. Hacer que se registre en el servidor.</translation>
    </message>
    <message>
        <source>The R-parameters of method window are out of range. Check base, stride and number of windows.</source>
        <translation>Los parámetros R del método Ventana están fuera de rango. Comprobar base, paso y número de ventanas.</translation>
    </message>
    <message>
        <source>These R-parameters cannot be used. Choose some that exist (MD28050).</source>
        <translation>Estos parámetros R no se pueden usar. Elija unos que existan (MD28050).</translation>
    </message>
    <message>
        <source>A program is running on the control: the measurement has ended. The R-parameters have their old values.</source>
        <translation>Hay un programa en marcha en el control: la medición ha terminado. Los parámetros R tienen sus valores anteriores.</translation>
    </message>
    <message>
        <source>The calibration was cancelled. The R-parameters have their old values.</source>
        <translation>La calibración se canceló. Los parámetros R tienen sus valores anteriores.</translation>
    </message>
    <message>
        <source>The R-parameters could not be restored and may hold test values. Set them at the control.</source>
        <translation>Los parámetros R no se pudieron restablecer y pueden contener valores de prueba. Ajústelos en el control.</translation>
    </message>
    <message>
        <source>The control does not obey the override: pause, stop and override would not act. Nothing was moved. Check that a SINUMERIK has synchronized actions, or a LinuxCNC the components of docs/linuxcnc.md.</source>
        <translation>El control no obedece al override: la pausa, la parada y el override no actuarían. No se ha movido nada. Compruebe que un SINUMERIK tiene acciones síncronas, o un LinuxCNC los componentes de docs/linuxcnc.md.</translation>
    </message>
    <message>
        <source>The path cannot be kept within this tolerance. Allow more of it, or none; packed points are moved by up to 0.001 mm.</source>
        <translation>La trayectoria no se puede mantener dentro de esta tolerancia. Permita más, o ninguna; los puntos empaquetados se desplazan hasta 0,001 mm.</translation>
    </message>
    <message>
        <source>This block cannot be tried: the control of a job would not execute it itself, or it ends the program. Name blocks as a program has them, as in &quot;S500 M3&quot;.</source>
        <translation>Este bloque no se puede probar: en un trabajo el control no lo ejecutaría por sí mismo, o termina el programa. Introducir los bloques como en un programa, por ejemplo «S500 M3».</translation>
    </message>
</context>
<context>
    <name>FaultTexts</name>
    <message>
        <source>the character &quot;%1&quot; has no meaning here</source>
        <translation>el carácter «%1» no tiene aquí ningún significado</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a number</source>
        <translation>«%1» no es un número</translation>
    </message>
    <message>
        <source>a comment is not closed</source>
        <translation>hay un comentario sin cerrar</translation>
    </message>
    <message>
        <source>%1 is not known to this machine</source>
        <translation>%1 no se conoce en esta máquina</translation>
    </message>
    <message>
        <source>the word %1 is not understood here</source>
        <translation>la palabra %1 no se entiende aquí</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not understood</source>
        <translation>«%1» no se entiende</translation>
    </message>
    <message>
        <source>two functions of one group are in the block: %1</source>
        <translation>hay dos funciones de un mismo grupo en la secuencia: %1</translation>
    </message>
    <message>
        <source>the address %1 is programmed more than once in the block</source>
        <translation>la dirección %1 está programada más de una vez en la secuencia</translation>
    </message>
    <message>
        <source>circle end-point error: there is no circle through these points</source>
        <translation>error en el punto final del círculo: ningún círculo pasa por estos puntos</translation>
    </message>
    <message>
        <source>circle end-point error: the radii at start and end differ by %1 mm</source>
        <translation>error en el punto final del círculo: los radios al inicio y al final difieren en %1 mm</translation>
    </message>
    <message>
        <source>circle end-point error: the radius is too small (%1)</source>
        <translation>error en el punto final del círculo: el radio es demasiado pequeño (%1)</translation>
    </message>
    <message>
        <source>the arc starts at an unknown position: %1</source>
        <translation>el arco empieza en una posición desconocida: %1</translation>
    </message>
    <message>
        <source>the increment of %1 starts at an unknown position</source>
        <translation>la cota incremental de %1 parte de una posición desconocida</translation>
    </message>
    <message>
        <source>no feed is programmed</source>
        <translation>no hay ningún avance programado</translation>
    </message>
    <message>
        <source>the programmed path speed %1 is not positive</source>
        <translation>la velocidad de trayectoria programada %1 no es positiva</translation>
    </message>
    <message>
        <source>the value of %1 is out of range</source>
        <translation>el valor de %1 está fuera de rango</translation>
    </message>
    <message>
        <source>circle end-point error: %1 is not in the plane of the arc</source>
        <translation>error en el punto final del círculo: %1 no está en el plano del arco</translation>
    </message>
    <message>
        <source>%1 is not a cycle of this machine</source>
        <translation>%1 no es un ciclo de esta máquina</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>falta un valor</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a value</source>
        <translation>«%1» no es un valor</translation>
    </message>
    <message>
        <source>a constant in quotes is written &apos;H1F&apos; or &apos;B101&apos;</source>
        <translation>una constante entre comillas simples se escribe &apos;H1F&apos; o &apos;B101&apos;</translation>
    </message>
    <message>
        <source>a text in quotes is expected</source>
        <translation>se espera un texto entre comillas</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>hay un paréntesis sin cerrar</translation>
    </message>
    <message>
        <source>an operand is missing</source>
        <translation>falta un operando</translation>
    </message>
    <message>
        <source>the calculation is nested too deeply</source>
        <translation>el cálculo tiene demasiados niveles de anidamiento</translation>
    </message>
    <message>
        <source>%1 is neither a variable nor a function</source>
        <translation>%1 no es ni una variable ni una función</translation>
    </message>
    <message>
        <source>%1 needs its argument in brackets</source>
        <translation>%1 necesita su argumento entre paréntesis</translation>
    </message>
    <message>
        <source>%1 needs more arguments</source>
        <translation>%1 necesita más argumentos</translation>
    </message>
    <message>
        <source>ATAN is written ATAN[y]/[x]</source>
        <translation>ATAN se escribe ATAN[y]/[x]</translation>
    </message>
    <message>
        <source>EXISTS is written EXISTS[#&lt;name&gt;]</source>
        <translation>EXISTS se escribe EXISTS[#&lt;name&gt;]</translation>
    </message>
    <message>
        <source>R needs a number or an index in brackets</source>
        <translation>R necesita un número o un índice entre corchetes</translation>
    </message>
    <message>
        <source>the number of a variable is missing or too large</source>
        <translation>el número de una variable falta o es demasiado grande</translation>
    </message>
    <message>
        <source>the name of a variable is not closed with &gt;</source>
        <translation>el nombre de una variable no se cierra con &gt;</translation>
    </message>
    <message>
        <source>%1 is not a variable</source>
        <translation>%1 no es una variable</translation>
    </message>
    <message>
        <source>%1 needs an axis or an index in brackets</source>
        <translation>%1 necesita un eje o un índice entre corchetes</translation>
    </message>
    <message>
        <source>an equals sign is missing</source>
        <translation>falta un signo de igual</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be assigned to</source>
        <translation>a «%1» no se le puede asignar un valor</translation>
    </message>
    <message>
        <source>SET and REP need a list in brackets, with commas between its values</source>
        <translation>SET y REP necesitan una lista entre paréntesis, con comas entre sus valores</translation>
    </message>
    <message>
        <source>the name of a variable is missing</source>
        <translation>falta el nombre de una variable</translation>
    </message>
    <message>
        <source>%1 is not a type for DEF</source>
        <translation>%1 no es un tipo para DEF</translation>
    </message>
    <message>
        <source>the size of an array is missing or too large</source>
        <translation>el tamaño de una matriz falta o es demasiado grande</translation>
    </message>
    <message>
        <source>the parameters of PROC are written PROC name(type name, ...)</source>
        <translation>los parámetros de PROC se escriben PROC nombre(tipo nombre, ...)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is missing, or has no meaning here</source>
        <translation>«%1» falta, o no tiene aquí ningún significado</translation>
    </message>
    <message>
        <source>an address needs a number or &quot;=&quot;</source>
        <translation>una dirección necesita un número o «=»</translation>
    </message>
    <message>
        <source>the jump has no target</source>
        <translation>el salto no tiene destino</translation>
    </message>
    <message>
        <source>only GOTO may follow a condition</source>
        <translation>a una condición solo le puede seguir GOTO</translation>
    </message>
    <message>
        <source>FOR is written FOR i = a TO b</source>
        <translation>FOR se escribe FOR i = a TO b</translation>
    </message>
    <message>
        <source>CASE is written CASE(value) OF constant GOTOF target</source>
        <translation>CASE se escribe CASE(valor) OF constante GOTOF destino</translation>
    </message>
    <message>
        <source>the %1 that begins here is not closed</source>
        <translation>el %1 que empieza aquí no se cierra</translation>
    </message>
    <message>
        <source>%1 has no beginning</source>
        <translation>%1 no tiene principio</translation>
    </message>
    <message>
        <source>control structures are nested more than 16 deep</source>
        <translation>las estructuras de control están anidadas en más de 16 niveles</translation>
    </message>
    <message>
        <source>a synchronized action needs a number from 1 to 255</source>
        <translation>una acción síncrona necesita un número de 1 a 255</translation>
    </message>
    <message>
        <source>a synchronized action is written ID=1 WHEN condition DO assignment</source>
        <translation>una acción síncrona se escribe ID=1 WHEN condición DO asignación</translation>
    </message>
    <message>
        <source>a synchronized action can only assign to $R and variables of the main run</source>
        <translation>una acción síncrona solo puede asignar valores a $R y a variables del proceso principal</translation>
    </message>
    <message>
        <source>the target %1 is missing</source>
        <translation>falta el destino %1</translation>
    </message>
    <message>
        <source>the program %1 does not exist</source>
        <translation>el programa %1 no existe</translation>
    </message>
    <message>
        <source>%1 is not defined, and there is no program of this name</source>
        <translation>%1 no está definido y no hay ningún programa con este nombre</translation>
    </message>
    <message>
        <source>subprograms call each other too deeply</source>
        <translation>los subprogramas se llaman en demasiados niveles</translation>
    </message>
    <message>
        <source>a division by zero</source>
        <translation>división por cero</translation>
    </message>
    <message>
        <source>%1 has no value</source>
        <translation>%1 no tiene valor</translation>
    </message>
    <message>
        <source>the result is too large</source>
        <translation>el resultado es demasiado grande</translation>
    </message>
    <message>
        <source>it needs a value that is not known</source>
        <translation>hace falta un valor que no se conoce</translation>
    </message>
    <message>
        <source>R%1 is read before the program sets it: only the control knows it</source>
        <translation>R%1 se lee antes de que el programa lo asigne: solo el control lo conoce</translation>
    </message>
    <message>
        <source>R[%1] does not exist</source>
        <translation>R[%1] no existe</translation>
    </message>
    <message>
        <source>%1 is not defined</source>
        <translation>%1 no está definido</translation>
    </message>
    <message>
        <source>an array needs its index in brackets</source>
        <translation>una matriz necesita su índice entre corchetes</translation>
    </message>
    <message>
        <source>the array has fewer dimensions</source>
        <translation>la matriz tiene menos dimensiones</translation>
    </message>
    <message>
        <source>the array has more dimensions</source>
        <translation>la matriz tiene más dimensiones</translation>
    </message>
    <message>
        <source>the index is outside the array</source>
        <translation>el índice está fuera de la matriz</translation>
    </message>
    <message>
        <source>a calculation uses a text</source>
        <translation>un cálculo utiliza un texto</translation>
    </message>
    <message>
        <source>the value is not of type %1</source>
        <translation>el valor no es del tipo %1</translation>
    </message>
    <message>
        <source>the value is outside the range of type %1</source>
        <translation>el valor está fuera del rango del tipo %1</translation>
    </message>
    <message>
        <source>the list has more values than the array has elements</source>
        <translation>la lista tiene más valores que elementos la matriz</translation>
    </message>
    <message>
        <source>only the control knows the value of %1</source>
        <translation>solo el control conoce el valor de %1</translation>
    </message>
    <message>
        <source>a variable of the control would be written</source>
        <translation>se escribiría una variable del control</translation>
    </message>
    <message>
        <source>the subprogram takes %1 values</source>
        <translation>el subprograma recibe %1 valores</translation>
    </message>
    <message>
        <source>the parameter %1 is given by reference and needs a variable</source>
        <translation>el parámetro %1 se pasa por referencia y necesita una variable</translation>
    </message>
    <message>
        <source>the parameter %1 is given by reference and needs a variable of its own type</source>
        <translation>el parámetro %1 se pasa por referencia y necesita una variable de su mismo tipo</translation>
    </message>
    <message>
        <source>a synchronized action reads R or an array by an index of the main run: use $R</source>
        <translation>una acción síncrona lee R o una matriz con un índice del proceso principal: usar $R</translation>
    </message>
    <message>
        <source>GOTO or THEN must follow a condition</source>
        <translation>a una condición le debe seguir GOTO o THEN</translation>
    </message>
    <message>
        <source>WHILE is written WHILE [condition] DO1</source>
        <translation>WHILE se escribe WHILE [condición] DO1</translation>
    </message>
    <message>
        <source>an O word needs a number or &lt;name&gt;</source>
        <translation>una palabra O necesita un número o &lt;name&gt;</translation>
    </message>
    <message>
        <source>%1 is not known</source>
        <translation>%1 no se conoce</translation>
    </message>
    <message>
        <source>%1 is not in a loop</source>
        <translation>%1 no está en un bucle</translation>
    </message>
    <message>
        <source>%1 has no call</source>
        <translation>%1 no tiene llamada</translation>
    </message>
    <message>
        <source>a subprogram is defined inside %1</source>
        <translation>se define un subprograma dentro de %1</translation>
    </message>
    <message>
        <source>a blank is inside the number &quot;%1&quot;</source>
        <translation>hay un espacio dentro del número «%1»</translation>
    </message>
    <message>
        <source>the invisible character %1 has no meaning here</source>
        <translation>el carácter invisible %1 no tiene significado aquí</translation>
    </message>
    <message>
        <source>a bracket is opened within the comment %1</source>
        <translation>se abre un paréntesis dentro del comentario %1</translation>
    </message>
    <message>
        <source>the program has more than %1 variables</source>
        <translation>el programa tiene más de %1 variables</translation>
    </message>
    <message>
        <source>%1 cannot be written by a program here</source>
        <translation>%1 no puede ser escrito aquí por un programa</translation>
    </message>
    <message>
        <source>the program stops here with its alarm %1</source>
        <translation>el programa se detiene aquí con su alarma %1</translation>
    </message>
    <message>
        <source>the file holds two programs of the name %1: rename or remove one of them</source>
        <translation>el archivo contiene dos programas con el nombre %1: cambie el nombre de uno o elimínelo</translation>
    </message>
    <message>
        <source>the unit of the feed was chosen behind the last F</source>
        <translation>la unidad del avance se eligió después del último F</translation>
    </message>
    <message>
        <source>the program takes more memory than is allowed: split it</source>
        <translation>el programa necesita más memoria de la permitida: divídalo</translation>
    </message>
    <message>
        <source>the block lacks a word that the control needs (%1)</source>
        <translation>falta en el bloque una palabra que el control necesita (%1)</translation>
    </message>
    <message>
        <source>the block cannot be executed here (%1)</source>
        <translation>el bloque no se puede ejecutar aquí (%1)</translation>
    </message>
</context>
<context>
    <name>FeedTestTexts</name>
    <message>
        <source>no axis was moved</source>
        <translation>no se ha movido ningún eje</translation>
    </message>
    <message>
        <source>4. The override is changed while the axis moves. Then press cycle start once more: the next program must move at its own feed, and only the control can stop it.</source>
        <translation>4. El override se cambia mientras el eje se mueve. Después pulse Marcha CN otra vez: el programa siguiente debe moverse con su propio avance, y solo el control puede pararlo.</translation>
    </message>
    <message>
        <source>4. The override is changed; no axis moves.</source>
        <translation>4. El override se cambia; ningún eje se mueve.</translation>
    </message>
    <message>
        <source>Not tested: on this control a stop is sure to act only before the next window</source>
        <translation>No probado: en este control una parada actúa con seguridad solo antes de la ventana siguiente</translation>
    </message>
    <message>
        <source>Passed: stop, pause and override act at once on this control</source>
        <translation>Superada: parada, pausa y override actúan de inmediato en este control</translation>
    </message>
    <message>
        <source>Passed without motion. Whether the axes obey shows only when one moves.</source>
        <translation>Superada sin movimiento. Si los ejes obedecen solo se ve cuando uno se mueve.</translation>
    </message>
    <message>
        <source>Not passed: on this control a stop is sure to act only before the next window</source>
        <translation>No superada: en este control una parada actúa con seguridad solo antes de la ventana siguiente</translation>
    </message>
    <message>
        <source>Synchronized actions make the override that is wanted, and keep it.</source>
        <translation>Las acciones síncronas forman el override deseado y lo mantienen.</translation>
    </message>
    <message>
        <source>Without a sign of the client the override is 0.</source>
        <translation>Sin señal de vida del cliente, el override es 0.</translation>
    </message>
    <message>
        <source>At 50 % the axis takes twice as long.</source>
        <translation>Con el 50 % el eje tarda el doble.</translation>
    </message>
    <message>
        <source>At 0 % the axis stands on its way.</source>
        <translation>Con el 0 % el eje se para a mitad de camino.</translation>
    </message>
    <message>
        <source>It brakes at once when 0 % is wanted.</source>
        <translation>Frena de inmediato cuando se pide el 0 %.</translation>
    </message>
    <message>
        <source>It moves in no interpolation cycle while it is held.</source>
        <translation>Detenido, no se mueve en ningún ciclo de interpolación.</translation>
    </message>
    <message>
        <source>The synchronized actions end with their program.</source>
        <translation>Las acciones síncronas terminan con su programa.</translation>
    </message>
    <message>
        <source>The next program moves at its own feed.</source>
        <translation>El programa siguiente se mueve con su propio avance.</translation>
    </message>
    <message>
        <source>; the tool may be lifted by %1</source>
        <translation>; la herramienta puede elevarse %1</translation>
    </message>
    <message>
        <source>4. The override is changed while the axis moves; held, the tool goes up and comes back, twice. Then press cycle start once more: the next program must move at its own feed, and only the control can stop it.</source>
        <translation>4. El override se cambia mientras el eje se mueve; detenido, la herramienta sube y vuelve, dos veces. Después pulse Marcha CN otra vez: el programa siguiente debe moverse con su propio avance, y solo el control puede pararlo.</translation>
    </message>
    <message>
        <source>The control allows the overlay of Z that the lift needs.</source>
        <translation>El control permite la superposición de Z que necesita la elevación.</translation>
    </message>
    <message>
        <source>Nothing but 0 to the lift moves the tool.</source>
        <translation>Solo los valores de 0 a la elevación mueven la herramienta.</translation>
    </message>
    <message>
        <source>The tool is lifted while the axis is held.</source>
        <translation>La herramienta se eleva mientras el eje está detenido.</translation>
    </message>
    <message>
        <source>The axis stands while the tool is lifted.</source>
        <translation>El eje está parado mientras la herramienta está elevada.</translation>
    </message>
    <message>
        <source>The tool comes back to its path.</source>
        <translation>La herramienta vuelve a su trayectoria.</translation>
    </message>
    <message>
        <source>Let go, the axis moves only when the tool is back.</source>
        <translation>Liberado, el eje se mueve solo cuando la herramienta ha vuelto.</translation>
    </message>
    <message>
        <source>Stop, pause and override act at once because the control obeys an R-parameter in every interpolation cycle. This test finds out whether it does: first without motion, then, if you agree, with one axis that moves back and forth in the air and is held on its way. The channel must be in reset.</source>
        <translation>Parada, pausa y override actúan de inmediato porque el control obedece a un parámetro R en cada ciclo de interpolación. Esta prueba averigua si lo hace: primero sin movimiento y después, si usted está de acuerdo, con un eje que va y vuelve en el aire y se detiene a mitad de camino. El canal debe estar en reset.</translation>
    </message>
    <message>
        <source>No other client writes the override of this test.</source>
        <translation>Ningún otro cliente escribe el override de esta prueba.</translation>
    </message>
    <message>
        <source>; held, it was seen to stand after %1</source>
        <translation>; retenido, estaba parado después de %1</translation>
    </message>
</context>
<context>
    <name>FileSheetTexts</name>
    <message>
        <source>%1 is already there. Replace it?</source>
        <translation>%1 ya existe. ¿Reemplazarlo?</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Reemplazar</translation>
    </message>
</context>
<context>
    <name>FoundRunTexts</name>
    <message>
        <source>A program of Rivulet without a run</source>
        <translation>Un programa de Rivulet sin ejecución</translation>
    </message>
    <message>
        <source>Run %1</source>
        <translation>Ejecución %1</translation>
    </message>
    <message>
        <source>Run %1 of %2</source>
        <translation>Ejecución %1 de %2</translation>
    </message>
    <message>
        <source>It is not known who started it.</source>
        <translation>No se sabe quién la inició.</translation>
    </message>
    <message>
        <source>Started by %1 on %2 at %3.</source>
        <translation>Iniciada por %1 en %2 el %3.</translation>
    </message>
    <message>
        <source>%1 of %2 points executed</source>
        <translation>%1 de %2 puntos ejecutados</translation>
    </message>
    <message>
        <source>%1. Looking for its client …</source>
        <translation>%1. Buscando su cliente…</translation>
    </message>
    <message>
        <source>It waits for its first client.</source>
        <translation>Espera a su primer cliente.</translation>
    </message>
    <message>
        <source>%1. Its client is gone: the program waits.</source>
        <translation>%1. Su cliente ya no está: el programa espera.</translation>
    </message>
    <message>
        <source>%1. Its client is at work.</source>
        <translation>%1. Su cliente está trabajando.</translation>
    </message>
    <message>
        <source>It was not completed, and its program is no longer active on the control.</source>
        <translation>No se completó, y su programa ya no está activo en el control.</translation>
    </message>
    <message>
        <source>Stop confirmed after %1.</source>
        <translation>Parada confirmada tras %1.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows executed</source>
        <translation>
            <numerusform>%Ln ventana ejecutada</numerusform>
            <numerusform>%Ln ventanas ejecutadas</numerusform>
        </translation>
    </message>
    <message>
        <source>The axes stand (%1 after the order), and stay where they are until the run is ended or resumed.</source>
        <translation>Los ejes están parados (%1 después de la orden) y así se quedan hasta que la ejecución se termine o se reanude.</translation>
    </message>
</context>
<context>
    <name>GroupingTexts</name>
    <message>
        <source>Lists</source>
        <translation>Listas</translation>
    </message>
    <message>
        <source>One by one</source>
        <translation>De una en una</translation>
    </message>
    <message>
        <source>Arrays by count</source>
        <translation>Matrices por número</translation>
    </message>
    <message>
        <source>Arrays by range</source>
        <translation>Matrices por rango</translation>
    </message>
</context>
<context>
    <name>HazardTexts</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línea %2</translation>
    </message>
    <message>
        <source>Line %1 (part %2)</source>
        <translation>Línea %1 (tramo %2)</translation>
    </message>
    <message>
        <source>Line %1</source>
        <translation>Línea %1</translation>
    </message>
    <message>
        <source>S%1 is %2 1/min more than the spindle can turn; the control reduces it to %3 1/min.</source>
        <translation>S%1 supera en %2 1/min lo que puede girar el cabezal; el control lo reduce a %3 1/min.</translation>
    </message>
    <message>
        <source>Tool %1 is not in the tool table of the machine. Enter it there, or choose another tool.</source>
        <translation>La herramienta %1 no está en la tabla de herramientas de la máquina. Introdúzcala allí o elija otra.</translation>
    </message>
    <message>
        <source>The machine would stop with alarm %1: %2</source>
        <translation>La máquina se pararía con la alarma %1: %2</translation>
    </message>
    <message>
        <source>From here on the job cannot be checked, because only the control knows what this block does: %1</source>
        <translation>A partir de aquí no se puede comprobar el trabajo, porque solo el control sabe qué hace esta secuencia: %1</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>y %1 más</translation>
    </message>
    <message>
        <source>%1 would go to %2 in machine coordinates, %3 beyond its limit of %4. Move the workpiece or change the work offset.</source>
        <translation>%1 iría a %2 en coordenadas de máquina, %3 más allá de su límite de %4. Desplace la pieza o cambie el decalaje de origen.</translation>
    </message>
    <message>
        <source>Tool %1 is not in the tool table of the machine, but %2 is. Enter %1 there, or write %2 into the program.</source>
        <translation>La herramienta %1 no está en la tabla de herramientas de la máquina, pero %2 sí. Introduzca %1 allí o escriba %2 en el programa.</translation>
    </message>
</context>
<context>
    <name>JobTestTexts</name>
    <message>
        <source>In a whole job the control executes blocks of its own between stretches that Rivulet streams. This test finds out whether it does that once, in order and only when it may, and whether stop, pause and a lost connection act in both: one axis moves back and forth in the air. Enter the blocks that your jobs have, one a line, each so that nothing is in its way; other kinds are not released. The channel must be in reset.</source>
        <translation>En un trabajo completo el control ejecuta bloques propios entre los tramos que Rivulet transmite. Esta prueba averigua si lo hace una vez, en orden y solo con permiso, y si la parada, la pausa y una conexión perdida actúan en ambos: un eje se mueve de ida y vuelta en el aire. Introducir los bloques de sus trabajos, uno por línea, cada uno sin obstáculos; los demás tipos no se habilitan. El canal debe estar en reset.</translation>
    </message>
    <message>
        <source>4. The job is stopped and left alone, in a block and in a stretch, then it goes through: press cycle start each time, %1 times in all.</source>
        <translation>4. El trabajo se para y se deja solo, en un bloque y en un tramo, y luego llega al final: pulsar cada vez Marcha CN, %1 veces en total.</translation>
    </message>
    <message>
        <source>Passed: whole jobs may run on this control, with the blocks that were tried</source>
        <translation>Superada: en este control se pueden ejecutar trabajos completos, con los bloques probados</translation>
    </message>
    <message>
        <source>No block is executed before Rivulet permits it.</source>
        <translation>Ningún bloque se ejecuta antes de que Rivulet lo permita.</translation>
    </message>
    <message>
        <source>After a stretch no block is executed before Rivulet permits it.</source>
        <translation>Después de un tramo ningún bloque se ejecuta antes de que Rivulet lo permita.</translation>
    </message>
    <message>
        <source>A stop in a block ends the job after that block.</source>
        <translation>Una parada en un bloque termina el trabajo después de ese bloque.</translation>
    </message>
    <message>
        <source>A stop in a stretch ends the job there.</source>
        <translation>Una parada en un tramo termina allí el trabajo.</translation>
    </message>
    <message>
        <source>In a block the axis stands when the connection is lost, and the job can be ended.</source>
        <translation>En un bloque el eje se para cuando se pierde la conexión, y el trabajo se puede terminar.</translation>
    </message>
    <message>
        <source>In a stretch the axis stands when the connection is lost, and the job can be ended.</source>
        <translation>En un tramo el eje se para cuando se pierde la conexión, y el trabajo se puede terminar.</translation>
    </message>
    <message>
        <source>In a block the axis stands while it is held.</source>
        <translation>En un bloque el eje está parado mientras se retiene.</translation>
    </message>
    <message>
        <source>In a stretch the axis stands while it is held.</source>
        <translation>En un tramo el eje está parado mientras se retiene.</translation>
    </message>
    <message>
        <source>Blocks and stretches are executed in turns, once each.</source>
        <translation>Bloques y tramos se ejecutan por turnos, una vez cada uno.</translation>
    </message>
    <message>
        <source>No block is passed over.</source>
        <translation>Ningún bloque se salta.</translation>
    </message>
    <message>
        <source>The override of the job ends with it.</source>
        <translation>El override del trabajo termina con él.</translation>
    </message>
    <message>
        <source>Not tested: on a real control only the motion of a program runs</source>
        <translation>Sin probar: en un control real solo se ejecuta el movimiento de un programa</translation>
    </message>
    <message>
        <source>Not passed: on a real control only the motion of a program runs</source>
        <translation>No superada: en un control real solo se ejecuta el movimiento de un programa</translation>
    </message>
</context>
<context>
    <name>JobTexts</name>
    <message>
        <source>swivels or transforms the coordinates</source>
        <translation>bascula o transforma las coordenadas</translation>
    </message>
    <message>
        <source>tool radius compensation</source>
        <translation>corrección del radio de la herramienta</translation>
    </message>
    <message>
        <source>cycle of the control</source>
        <translation>ciclo del control</translation>
    </message>
    <message>
        <source>subprogram that is not at hand</source>
        <translation>subprograma que no está disponible</translation>
    </message>
    <message>
        <source>measures, or reads the machine</source>
        <translation>mide, o lee la máquina</translation>
    </message>
    <message>
        <source>moves in machine coordinates</source>
        <translation>se mueve en coordenadas de máquina</translation>
    </message>
    <message>
        <source>path made by the control</source>
        <translation>trayectoria creada por el control</translation>
    </message>
    <message>
        <source>rounded or chamfered corner</source>
        <translation>esquina redondeada o achaflanada</translation>
    </message>
    <message>
        <source>counts from a position that only the control knows</source>
        <translation>cuenta desde una posición que solo conoce el control</translation>
    </message>
    <message>
        <source>tool or tool length</source>
        <translation>herramienta o su longitud</translation>
    </message>
    <message>
        <source>work offset</source>
        <translation>decalaje de origen</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>cabezal</translation>
    </message>
    <message>
        <source>coolant</source>
        <translation>refrigerante</translation>
    </message>
    <message>
        <source>stops until cycle start</source>
        <translation>se detiene hasta Marcha CN</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>tiempo de espera</translation>
    </message>
    <message>
        <source>message at the control</source>
        <translation>mensaje en el control</translation>
    </message>
    <message>
        <source>how the control moves</source>
        <translation>cómo se mueve el control</translation>
    </message>
    <message>
        <source>function of the machine</source>
        <translation>función de la máquina</translation>
    </message>
    <message>
        <source>end of the program</source>
        <translation>fin del programa</translation>
    </message>
    <message>
        <source>The control executes this block: %1.</source>
        <translation>Esta secuencia la ejecuta el control: %1.</translation>
    </message>
    <message>
        <source>Afterwards the position is read from the control.</source>
        <translation>Después se lee la posición en el control.</translation>
    </message>
    <message numerus="yes">
        <source>Part %1 of %2: lines %3 to %4 are streamed, %Ln points.</source>
        <translation>
            <numerusform>Tramo %1 de %2: las líneas %3 a %4 se transmiten de forma continua, %Ln punto.</numerusform>
            <numerusform>Tramo %1 de %2: las líneas %3 a %4 se transmiten de forma continua, %Ln puntos.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LimitTexts</name>
    <message>
        <source>rapid</source>
        <translation>rápido</translation>
    </message>
    <message>
        <source>line %1: %2, %3</source>
        <translation>línea %1: %2, %3</translation>
    </message>
</context>
<context>
    <name>LiveTexts</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>hold after %1, end after %2</source>
        <translation>suspensión tras %1, fin tras %2</translation>
    </message>
    <message>
        <source>median %1, 99 % %2</source>
        <translation>mediana %1, 99&#xa0;% %2</translation>
    </message>
    <message>
        <source>in theory %1</source>
        <translation>en teoría %1</translation>
    </message>
    <message>
        <source>%1 from %2, executed to line %3</source>
        <translation>%1 de %2, ejecutadas hasta la línea %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln points merged</source>
        <translation>
            <numerusform>%Ln punto unido</numerusform>
            <numerusform>%Ln puntos unidos</numerusform>
        </translation>
    </message>
    <message>
        <source>Adaptive feed: %1 % of your override, from %2</source>
        <translation>Avance adaptativo: %1&#xa0;% de su override, de %2</translation>
    </message>
    <message>
        <source>Adaptive feed: without %1, until its next factor</source>
        <translation>Avance adaptativo: sin %1, hasta su próximo factor</translation>
    </message>
    <message>
        <source>Adaptive feed: the axes are held. %1: %2</source>
        <translation>Avance adaptativo: los ejes están retenidos. %1: %2</translation>
    </message>
    <message>
        <source>Adaptive feed: your override acts alone. %1: %2</source>
        <translation>Avance adaptativo: actúa solo su override. %1: %2</translation>
    </message>
    <message>
        <source>no factor has come yet</source>
        <translation>aún no ha llegado ningún factor</translation>
    </message>
    <message>
        <source>no factor has come in time</source>
        <translation>ningún factor ha llegado a tiempo</translation>
    </message>
    <message>
        <source>%1 % was not agreed</source>
        <translation>%1&#xa0;% no estaba acordado</translation>
    </message>
    <message>
        <source>its last line is no factor</source>
        <translation>su última línea no es un factor</translation>
    </message>
    <message>
        <source>it has closed</source>
        <translation>se ha cerrado</translation>
    </message>
</context>
<context>
    <name>MachineCard</name>
    <message>
        <source>No run is known.</source>
        <translation>No se conoce ninguna ejecución.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conexión</translation>
    </message>
    <message>
        <source>Not connected with this window</source>
        <translation>No conectada con esta ventana</translation>
    </message>
    <message>
        <source>%1, seen %2 ago</source>
        <translation>%1, vista hace %2</translation>
    </message>
    <message numerus="yes">
        <source>%n alarms</source>
        <translation>
            <numerusform>%n alarma</numerusform>
            <numerusform>%n alarmas</numerusform>
        </translation>
    </message>
    <message>
        <source>limits</source>
        <translation>límites</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>calibración</translation>
    </message>
    <message>
        <source>credit test</source>
        <translation>prueba crédito</translation>
    </message>
    <message>
        <source>Remove this machine from the list? Its runs and recordings stay on the page Runs.</source>
        <translation>¿Quitar esta máquina de la lista? Sus ejecuciones y grabaciones permanecen en la página Ejecuciones.</translation>
    </message>
    <message>
        <source>Put aside as files, and not used any more: %1.</source>
        <translation>Se apartan como archivos y ya no se usan: %1.</translation>
    </message>
    <message>
        <source>Last run %1: %2, %3 of %4 points</source>
        <translation>Última ejecución %1: %2, %3 de %4 puntos</translation>
    </message>
    <message>
        <source>Not connected; its port answered %1 ago</source>
        <translation>No conectada; su puerto respondió hace %1</translation>
    </message>
    <message>
        <source>Not reachable: no answer %1 ago</source>
        <translation>No accesible: sin respuesta hace %1</translation>
    </message>
    <message>
        <source>stop test</source>
        <translation>prueba de parada</translation>
    </message>
    <message>
        <source>job test</source>
        <translation>prueba de trabajo</translation>
    </message>
</context>
<context>
    <name>MachinesTexts</name>
    <message>
        <source>During a run, the window stays with its machine.</source>
        <translation>Durante una ejecución, la ventana se queda con su máquina.</translation>
    </message>
</context>
<context>
    <name>MoveTexts</name>
    <message>
        <source>%1 moved by %2 at %3</source>
        <translation>%1 movido %2 a %3</translation>
    </message>
</context>
<context>
    <name>NoteTexts</name>
    <message>
        <source>Form of access: %1.</source>
        <translation>Forma de acceso: %1.</translation>
    </message>
    <message>
        <source>Program %1: %2, %3, %4.</source>
        <translation>Programa %1: %2, %3, %4.</translation>
    </message>
    <message>
        <source>Nothing has come from the control for %1 s.</source>
        <translation>Hace %1 s que no llega nada del control.</translation>
    </message>
    <message>
        <source>The control answers again.</source>
        <translation>El control responde de nuevo.</translation>
    </message>
    <message>
        <source>The control answered slowly: accesses took up to %1 s, %2 times as long as expected. Each took at least %3 s: the network is slow, or the server is busy with another OPC UA client.</source>
        <translation>El control ha respondido despacio: los accesos duraron hasta %1 s, %2 veces lo esperado. Cada uno duró al menos %3 s: la red es lenta, o el servidor está ocupado con otro cliente OPC UA.</translation>
    </message>
    <message>
        <source>The control answered slowly: accesses took up to %1 s, %2 times as long as expected. Others were fast: another OPC UA client keeps the server busy at times, or the network stalls.</source>
        <translation>El control ha respondido despacio: los accesos duraron hasta %1 s, %2 veces lo esperado. Otros fueron rápidos: otro cliente OPC UA ocupa el servidor a ratos, o la red se detiene.</translation>
    </message>
    <message>
        <source>Online correction in mm: X %1 Y %2 Z %3</source>
        <translation>Corrección en línea en mm: X %1 Y %2 Z %3</translation>
    </message>
    <message>
        <source>The control has refused a request: asked again.</source>
        <translation>El control ha rechazado una petición: se ha vuelto a preguntar.</translation>
    </message>
    <message>
        <source>No answer in time: asked again.</source>
        <translation>Sin respuesta a tiempo: se ha vuelto a preguntar.</translation>
    </message>
    <message>
        <source>The stream was given up: %1</source>
        <translation>La transmisión se ha abandonado: %1</translation>
    </message>
    <message>
        <source>A signal was out of sequence: a window has been executed again.</source>
        <translation>Una señal llegó fuera de orden: una ventana se ha ejecutado otra vez.</translation>
    </message>
    <message>
        <source>The place of the run could not be kept, so it cannot be resumed after a crash of this program: %1</source>
        <translation>No se ha podido guardar el punto de la ejecución, por eso no se puede reanudar tras un fallo de este programa: %1</translation>
    </message>
    <message>
        <source>The reason why the program ended could not be read.</source>
        <translation>No se ha podido leer por qué terminó el programa.</translation>
    </message>
    <message>
        <source>The trace of the control could not be fetched: %1</source>
        <translation>No se ha podido obtener la grabación del control: %1</translation>
    </message>
    <message>
        <source>The trace of the control is incomplete: the run is not judged.</source>
        <translation>La grabación del control está incompleta: la ejecución no se juzga.</translation>
    </message>
    <message>
        <source>The name of the run could not be stored: %1</source>
        <translation>No se ha podido guardar el nombre de la ejecución: %1</translation>
    </message>
    <message>
        <source>written</source>
        <translation>escrito</translation>
    </message>
    <message>
        <source>already there</source>
        <translation>ya estaba</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>comparado</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>sin comparar</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>seleccionado</translation>
    </message>
    <message>
        <source>to be selected</source>
        <translation>por seleccionar</translation>
    </message>
    <message>
        <source>Adaptive feed: the source is followed.</source>
        <translation>Avance adaptativo: se sigue a la fuente.</translation>
    </message>
    <message>
        <source>Adaptive feed: no factor has come yet: %1</source>
        <translation>Avance adaptativo: aún no ha llegado ningún factor: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: no factor for %1 s: %2</source>
        <translation>Avance adaptativo: ningún factor desde hace %1 s: %2</translation>
    </message>
    <message>
        <source>Adaptive feed: the factor %1 was not agreed: %2 to %3, where 1 is 100 %: %4</source>
        <translation>Avance adaptativo: el factor %1 no estaba acordado: de %2 a %3, donde 1 es el 100&#xa0;%: %4</translation>
    </message>
    <message>
        <source>Adaptive feed: the line is no factor, as feed 0.85 would be: %1</source>
        <translation>Avance adaptativo: la línea no es un factor, como lo sería feed 0.85: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: the source has closed: %1</source>
        <translation>Avance adaptativo: la fuente se ha cerrado: %1</translation>
    </message>
    <message>
        <source>Adaptive feed: the operator goes on without the source.</source>
        <translation>Avance adaptativo: el operario sigue sin la fuente.</translation>
    </message>
    <message>
        <source>the axes are held.</source>
        <translation>los ejes están retenidos.</translation>
    </message>
    <message>
        <source>the override of the operator acts alone.</source>
        <translation>actúa solo el override del operario.</translation>
    </message>
    <message>
        <source>The axes are told to stand.</source>
        <translation>Los ejes deben detenerse.</translation>
    </message>
    <message>
        <source>The axes are told to go on, override %1 %.</source>
        <translation>Los ejes deben continuar, override %1 %.</translation>
    </message>
    <message>
        <source>Override %1 % requested.</source>
        <translation>Override %1 % solicitado.</translation>
    </message>
    <message>
        <source>An override of %1 % is refused: choose %2 to %3 %.</source>
        <translation>Se rechaza un override de %1 %: elegir de %2 a %3 %.</translation>
    </message>
    <message>
        <source>Another client has set the override to %1 %: it stays until the next order.</source>
        <translation>Otro cliente ha puesto el override a %1 %: se mantiene hasta la próxima orden.</translation>
    </message>
    <message>
        <source>Another client has written the factor %1: %2 is written again.</source>
        <translation>Otro cliente ha escrito el factor %1: se escribe de nuevo %2.</translation>
    </message>
    <message>
        <source>The control does not obey: its override is %1 %.</source>
        <translation>El control no obedece: su override es %1 %.</translation>
    </message>
    <message>
        <source>The axes stand, %1 s after it was requested.</source>
        <translation>Los ejes están parados, %1 s después de la solicitud.</translation>
    </message>
    <message>
        <source>The axes move although the override is 0: what moves now does not obey it. Stop it at the control.</source>
        <translation>Los ejes se mueven aunque el override es 0: lo que se mueve no le obedece. Parar en el control.</translation>
    </message>
    <message>
        <source>For %1 s no sign of this computer has reached the control: the axes have stood meanwhile.</source>
        <translation>Durante %1 s no ha llegado al control ninguna señal de este ordenador: entretanto los ejes han estado parados.</translation>
    </message>
    <message>
        <source>Lift of the tool in mm: %1</source>
        <translation>Elevación de la herramienta en mm: %1</translation>
    </message>
    <message>
        <source>Stopped: the axes are held, and the program is left.</source>
        <translation>Detenido: los ejes quedan retenidos y se abandona el programa.</translation>
    </message>
    <message>
        <source>This program has no feed cell: Pause acts before the next window.</source>
        <translation>Este programa no tiene celda de avance: Pausa actúa antes de la siguiente ventana.</translation>
    </message>
    <message>
        <source>Wrong motion: after point %1 the tool is %2 mm off the path.</source>
        <translation>Movimiento erróneo: tras el punto %1 la herramienta está a %2 mm de la trayectoria.</translation>
    </message>
    <message>
        <source>Wrong motion: points were repeated after point %1.</source>
        <translation>Movimiento erróneo: tras el punto %1 se repitieron puntos.</translation>
    </message>
    <message>
        <source>The control recorded a dwell of %1 s in line %2.</source>
        <translation>El control registró una espera de %1 s en la línea %2.</translation>
    </message>
    <message>
        <source>The control recorded an auxiliary function of %1 s in line %2.</source>
        <translation>El control registró una función auxiliar de %1 s en la línea %2.</translation>
    </message>
    <message>
        <source>The control recorded M%1 in line %2.</source>
        <translation>El control registró M%1 en la línea %2.</translation>
    </message>
    <message>
        <source>The override was 0 while the axes stood.</source>
        <translation>El override era 0 mientras los ejes estaban parados.</translation>
    </message>
    <message>
        <source>A write of %1 values was answered %2 ms before the axes moved again.</source>
        <translation>La escritura de %1 valores se respondió %2 ms antes de que los ejes volvieran a moverse.</translation>
    </message>
    <message>
        <source>The program on the control has a STOPRE between line %1 and line %2.</source>
        <translation>El programa en el control tiene un STOPRE entre la línea %1 y la línea %2.</translation>
    </message>
    <message>
        <source>The program on the control jumps from line %1 back to line %2.</source>
        <translation>El programa en el control salta de la línea %1 atrás a la línea %2.</translation>
    </message>
    <message>
        <source>The path turns by %1° there.</source>
        <translation>Allí la trayectoria gira %1°.</translation>
    </message>
    <message>
        <source>Line %1 of the program dwells there.</source>
        <translation>La línea %1 del programa espera allí.</translation>
    </message>
</context>
<context>
    <name>Pages</name>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Feasibility</source>
        <translation>Viabilidad</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 guardado.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmas</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Auditoría</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Usuarios</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>Configure</source>
        <translation>Configurar</translation>
    </message>
    <message>
        <source>Machines</source>
        <translation>Máquinas</translation>
    </message>
    <message>
        <source>Emulator</source>
        <translation>Emulador</translation>
    </message>
    <message>
        <source>CNC tasks</source>
        <translation>Tareas CNC</translation>
    </message>
</context>
<context>
    <name>ParallelPageTexts</name>
    <message>
        <source>A run is in progress. Execute the program after it has ended: both would take the same processor.</source>
        <translation>Hay una ejecución en curso. Ejecutar el programa cuando haya terminado: ambos usarían el mismo procesador.</translation>
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
        <translation>medida</translation>
    </message>
    <message>
        <source>inferred</source>
        <translation>deducida</translation>
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
        <translation>Eje %1: el recorrido debe terminar por encima de su inicio.</translation>
    </message>
    <message>
        <source>Axis %1: the speed must be above zero.</source>
        <translation>Eje %1: la velocidad debe ser mayor que cero.</translation>
    </message>
    <message>
        <source>Axis %1: the acceleration must be above zero.</source>
        <translation>Eje %1: la aceleración debe ser mayor que cero.</translation>
    </message>
    <message>
        <source>Axis %1: the jerk must be above zero.</source>
        <translation>Eje %1: la sacudida debe ser mayor que cero.</translation>
    </message>
    <message>
        <source>The rapid must be above zero.</source>
        <translation>El rápido debe ser mayor que cero.</translation>
    </message>
    <message>
        <source>Tool %1: every tool needs its own number above zero.</source>
        <translation>Herramienta %1: cada herramienta necesita su propio número mayor que cero.</translation>
    </message>
    <message>
        <source>Without this computer the axes stand after 0.2 to 60 s; 0: not at all.</source>
        <translation>Sin este ordenador, los ejes se detienen tras 0,2 a 60 s; 0: nunca.</translation>
    </message>
    <message>
        <source>Without a passed stop test a window takes at most 0.5 to 600 s.</source>
        <translation>Sin prueba de parada superada, una ventana dura como máximo de 0,5 a 600 s.</translation>
    </message>
</context>
<context>
    <name>ProgramTexts</name>
    <message>
        <source>Parts of the path of %1 are not known: see the findings. The program cannot be streamed.</source>
        <translation>Hay partes de la trayectoria de %1 que no se conocen: véanse las observaciones. El programa no se puede transmitir de forma continua.</translation>
    </message>
    <message>
        <source>%1 needs a transformation of the control. No method can stream it.</source>
        <translation>%1 necesita una transformación del control. Ningún método puede transmitirlo de forma continua.</translation>
    </message>
    <message>
        <source>%1 moves no axis: there is nothing to stream.</source>
        <translation>%1 no mueve ningún eje: no hay nada que transmitir.</translation>
    </message>
    <message>
        <source>A run is in progress. Open another program after it has ended.</source>
        <translation>Hay una ejecución en curso. Abrir otro programa cuando haya terminado.</translation>
    </message>
    <message>
        <source>Reading %1 was cancelled.</source>
        <translation>Se canceló la lectura de %1.</translation>
    </message>
    <message numerus="yes">
        <source>Opened %1 (%2), %Ln points.</source>
        <translation>
            <numerusform>%1 abierto (%2), %Ln punto.</numerusform>
            <numerusform>%1 abierto (%2), %Ln puntos.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RehearsalTexts</name>
    <message>
        <source>The program is being simulated with these settings.</source>
        <translation>Se está simulando el programa con estos ajustes.</translation>
    </message>
    <message>
        <source>all %1 points</source>
        <translation>todos los puntos (%1)</translation>
    </message>
    <message>
        <source>the %1 most difficult points</source>
        <translation>los %1 puntos más difíciles</translation>
    </message>
    <message>
        <source>Simulation of %1: wrong points in %2 of %3 runs.</source>
        <translation>Simulación de %1: puntos erróneos en %2 de %3 pasadas.</translation>
    </message>
    <message numerus="yes">
        <source>Simulation of %1: no wrong point in %n runs.</source>
        <translation>
            <numerusform>Simulación de %1: ningún punto erróneo en %n pasada.</numerusform>
            <numerusform>Simulación de %1: ningún punto erróneo en %n pasadas.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RejectedModel</name>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Emitido para</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Válido</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Huella</translation>
    </message>
</context>
<context>
    <name>RightTexts</name>
    <message>
        <source>read variables</source>
        <translation>leer variables</translation>
    </message>
    <message>
        <source>follows the run</source>
        <translation>sigue la ejecución</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with StateRead; if that is not enough, with SinuReadAll.</source>
        <translation>Llamar a GiveUserAccess con StateRead; si no basta, con SinuReadAll.</translation>
    </message>
    <message>
        <source>write R-parameters</source>
        <translation>escribir parámetros R</translation>
    </message>
    <message>
        <source>sends the points</source>
        <translation>envía los puntos</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with StateWrite; if that is not enough, with SinuWriteAll. The protection level of R-parameters (MD51051) must allow it, too.</source>
        <translation>Llamar a GiveUserAccess con StateWrite; si no basta, con SinuWriteAll. También el nivel de protección de los parámetros R (MD51051) debe permitirlo.</translation>
    </message>
    <message>
        <source>read programs</source>
        <translation>leer programas</translation>
    </message>
    <message>
        <source>checks which program is on the control; without it the operator does</source>
        <translation>comprueba qué programa está en el control; si no, lo hace el operario</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with FsRead.</source>
        <translation>Llamar a GiveUserAccess con FsRead.</translation>
    </message>
    <message>
        <source>write programs</source>
        <translation>escribir programas</translation>
    </message>
    <message>
        <source>brings its program to the control; without it the operator copies it</source>
        <translation>lleva su programa al control; si no, lo copia el operario</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with FsWrite.</source>
        <translation>Llamar a GiveUserAccess con FsWrite.</translation>
    </message>
    <message>
        <source>select a program</source>
        <translation>seleccionar un programa</translation>
    </message>
    <message>
        <source>selects its program; without it the operator does</source>
        <translation>selecciona su programa; si no, lo hace el operario</translation>
    </message>
    <message>
        <source>Call GiveUserAccess with ApWrite.</source>
        <translation>Llamar a GiveUserAccess con ApWrite.</translation>
    </message>
    <message>
        <source>Let this OPC UA user read the nodes of the map, in the settings of the server.</source>
        <translation>Permita a este usuario de OPC UA, en los ajustes del servidor, leer los nodos del mapa.</translation>
    </message>
    <message>
        <source>Let this OPC UA user write the cells of the map, in the settings of the server.</source>
        <translation>Permita a este usuario de OPC UA, en los ajustes del servidor, escribir las celdas del mapa.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.read), if the server has one, and let this OPC UA user call it.</source>
        <translation>Nombre el método en el mapa (methods.read), si el servidor tiene uno, y permita a este usuario de OPC UA llamarlo.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.write), if the server has one, and let this OPC UA user call it.</source>
        <translation>Nombre el método en el mapa (methods.write), si el servidor tiene uno, y permita a este usuario de OPC UA llamarlo.</translation>
    </message>
    <message>
        <source>Name the method in the map (methods.select), if the server has one, and let this OPC UA user call it.</source>
        <translation>Nombre el método en el mapa (methods.select), si el servidor tiene uno, y permita a este usuario de OPC UA llamarlo.</translation>
    </message>
</context>
<context>
    <name>RunStateTexts</name>
    <message>
        <source>Idle</source>
        <translation>En reposo</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marcha</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Parando</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminado</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Suspendido</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Preparando</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Parado</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fallido</translation>
    </message>
</context>
<context>
    <name>RunTexts</name>
    <message>
        <source>No program is loaded.</source>
        <translation>No hay ningún programa cargado.</translation>
    </message>
    <message>
        <source>The program has fewer than two points.</source>
        <translation>El programa tiene menos de dos puntos.</translation>
    </message>
    <message>
        <source>Running: %1, version %2</source>
        <translation>En marcha: %1, versión %2</translation>
    </message>
    <message>
        <source>Program: %1, version %2</source>
        <translation>Programa: %1, versión %2</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>program, %1 %</source>
        <translation>programa, %1 %</translation>
    </message>
    <message>
        <source>Whole jobs need method window or credit.</source>
        <translation>Los trabajos completos necesitan el método Ventana o Crédito.</translation>
    </message>
    <message>
        <source>A whole job cannot be corrected online.</source>
        <translation>Un trabajo completo no se puede corregir en línea.</translation>
    </message>
    <message>
        <source>Parts of the program are not known: see the findings.</source>
        <translation>Hay partes del programa que no se conocen: véanse las observaciones.</translation>
    </message>
    <message>
        <source>%1 (line %2) cannot be given to the control.</source>
        <translation>%1 (línea %2) no se puede pasar al control.</translation>
    </message>
    <message>
        <source>%1 streamed, %2 pauses, %3 tool changes, %4 other blocks of the control, %5 changes between both; %6 in all</source>
        <translation>%1 transmitido, %2 pausas, %3 cambios de herramienta, %4 otras secuencias del control, %5 cambios entre ambos; %6 en total</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Fallida</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Completada</translation>
    </message>
    <message>
        <source>Stopped, not judged</source>
        <translation>Parada, sin evaluar</translation>
    </message>
    <message>
        <source>Completed, not judged</source>
        <translation>Completada, sin evaluar</translation>
    </message>
    <message>
        <source>Stopped, with wrong motion</source>
        <translation>Parada, con movimiento erróneo</translation>
    </message>
    <message>
        <source>Completed with wrong motion</source>
        <translation>Completada con movimiento erróneo</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
    </message>
    <message>
        <source>Credit (experimental)</source>
        <translation>Crédito (experimental)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Begin with a part</source>
        <translation>Empezar por un tramo</translation>
    </message>
    <message>
        <source>Part (1 to %1). What the machine needs there is listed before anything moves.</source>
        <translation>Tramo (1 a %1). Lo que la máquina necesita allí se muestra en una lista antes de que nada se mueva.</translation>
    </message>
    <message>
        <source>A live source needs no verdict: the machine waits for points that are late.</source>
        <translation>Una fuente en vivo no necesita veredicto: la máquina espera los puntos que llegan tarde.</translation>
    </message>
    <message>
        <source>Live points from %1</source>
        <translation>Puntos en vivo de %1</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Sin herramienta</translation>
    </message>
    <message>
        <source>Before the first tool change</source>
        <translation>Antes del primer cambio de herramienta</translation>
    </message>
    <message>
        <source>%1 in the spindle</source>
        <translation>%1 en el husillo</translation>
    </message>
    <message>
        <source>%1 change</source>
        <translation>%1 cambio</translation>
    </message>
    <message>
        <source>%1 at %2 1/min</source>
        <translation>%1 a %2 rpm</translation>
    </message>
    <message>
        <source>%1 coolant</source>
        <translation>%1 refrigerante</translation>
    </message>
    <message>
        <source>Straight way to the first point</source>
        <translation>Camino recto al primer punto</translation>
    </message>
    <message>
        <source>CLEAR</source>
        <extracomment>What the operator types; a translation may be any one word.</extracomment>
        <translation>LIBRE</translation>
    </message>
    <message>
        <source>The tool goes straight through the space in which the program cuts. Look whether anything is in its way: workpiece, clamps. If nothing is, type %1.</source>
        <translation>La herramienta cruza en línea recta la zona que el programa mecaniza. Compruebe si hay algo en su camino: pieza, sujeciones. Si no hay nada, escriba %1.</translation>
    </message>
    <message>
        <source>Method that may repeat points</source>
        <translation>Método que puede repetir puntos</translation>
    </message>
    <message>
        <source>this may execute old points again</source>
        <extracomment>What the operator types, word by word.</extracomment>
        <translation>esto puede ejecutar otra vez puntos antiguos</translation>
    </message>
    <message>
        <source>This method of the publication knows no numbered windows. If this computer is late, the control executes old points again. To start all the same, type:
%1</source>
        <translation>Este método de la publicación no conoce ventanas numeradas. Si este ordenador se retrasa, el control ejecuta otra vez puntos antiguos. Para iniciar a pesar de ello, escribir:
%1</translation>
    </message>
    <message>
        <source>The path is being measured.</source>
        <translation>Se está midiendo la trayectoria.</translation>
    </message>
    <message>
        <source>Whole jobs have not been tested on this machine: Configure, Job test.</source>
        <translation>Los trabajos completos no se han probado en esta máquina: Configurar, Prueba trabajo.</translation>
    </message>
</context>
<context>
    <name>RunsTexts</name>
    <message>
        <source>This is not the report of a run. Choose a file that this page or stream --json has written.</source>
        <translation>No es el informe de una ejecución. Elegir un archivo escrito por esta página o por stream --json.</translation>
    </message>
    <message>
        <source>The report was written by a later version of Rivulet. Use that one to open it.</source>
        <translation>El informe es de una versión más reciente de Rivulet. Abrirlo con ella.</translation>
    </message>
    <message>
        <source>The report is damaged and cannot be shown.</source>
        <translation>El informe está dañado y no se puede mostrar.</translation>
    </message>
</context>
<context>
    <name>ServerModel</name>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificado</translation>
    </message>
    <message>
        <source>none accepted</source>
        <translation>ninguno aceptado</translation>
    </message>
    <message>
        <source>accepted, not kept</source>
        <translation>aceptado, no guardado</translation>
    </message>
    <message>
        <source>has ended</source>
        <translation>ha caducado</translation>
    </message>
    <message numerus="yes">
        <source>valid for %Ln days</source>
        <translation>
            <numerusform>válido %Ln día más</numerusform>
            <numerusform>válido %Ln días más</numerusform>
        </translation>
    </message>
    <message>
        <source>Protection</source>
        <translation>Protección</translation>
    </message>
    <message>
        <source>the strongest</source>
        <translation>la más fuerte</translation>
    </message>
    <message>
        <source>allowed: %1</source>
        <translation>permitido: %1</translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation>Huella</translation>
    </message>
</context>
<context>
    <name>ServiceTexts</name>
    <message>
        <source>Connecting …</source>
        <translation>Conectando…</translation>
    </message>
    <message>
        <source>No answer for some seconds</source>
        <translation>Sin respuesta desde hace unos segundos</translation>
    </message>
    <message>
        <source>Service does not answer</source>
        <translation>El servicio no responde</translation>
    </message>
    <message>
        <source>Not connected: needs a decision</source>
        <translation>Sin conexión: hace falta una decisión</translation>
    </message>
    <message>
        <source>Machine does not answer</source>
        <translation>La máquina no responde</translation>
    </message>
    <message>
        <source>Connecting to the machine …</source>
        <translation>Conectando con la máquina…</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Ningún programa</translation>
    </message>
    <message>
        <source>Program loaded</source>
        <translation>Programa cargado</translation>
    </message>
    <message>
        <source>Run interrupted</source>
        <translation>Ejecución interrumpida</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 de %2 puntos</translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation>%1, quedan %2</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>Buscando…</translation>
    </message>
    <message>
        <source>No other services are known there.</source>
        <translation>Allí no se conoce ningún otro servicio.</translation>
    </message>
    <message>
        <source>Only an engineer can do this.</source>
        <translation>Solo puede hacerlo un preparador.</translation>
    </message>
    <message>
        <source>This service is on the board.</source>
        <translation>Este servicio ya está en el tablero.</translation>
    </message>
</context>
<context>
    <name>SetUpTexts</name>
    <message>
        <source>Connect first: limits belong to one machine.</source>
        <translation>Conectar primero: los límites pertenecen a una máquina.</translation>
    </message>
    <message>
        <source>Only an engineer can do this, and not during a run.</source>
        <translation>Solo puede hacerlo un preparador, y no durante una ejecución.</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Conexión</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Plantilla</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Calibración</translation>
    </message>
    <message>
        <source>Credit test</source>
        <translation>Prueba crédito</translation>
    </message>
    <message>
        <source>Certificates</source>
        <translation>Certificados</translation>
    </message>
    <message>
        <source>Rights</source>
        <translation>Derechos</translation>
    </message>
    <message>
        <source>Stop test</source>
        <translation>Prueba parada</translation>
    </message>
    <message>
        <source>Job test</source>
        <translation>Prueba trabajo</translation>
    </message>
</context>
<context>
    <name>SheetTexts</name>
    <message>
        <source>Report of a run</source>
        <translation>Informe de ejecución</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Pauses and access</source>
        <translation>Pausas y accesos</translation>
    </message>
    <message>
        <source>Path, seen from above; rapids dashed</source>
        <translation>Trayectoria vista desde arriba; rápidos a trazos</translation>
    </message>
    <message>
        <source>The path was not kept.</source>
        <translation>La trayectoria no se ha guardado.</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Fecha, nombre, firma</translation>
    </message>
    <message>
        <source>Rivulet %1; run made with version %2</source>
        <translation>Rivulet %1; ejecución hecha con la versión %2</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Version (hash)</source>
        <translation>Versión (hash)</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Started by</source>
        <translation>Iniciada por</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>Número de ejecución</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Acceso</translation>
    </message>
    <message>
        <source>Windows</source>
        <translation>Ventanas</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>sin evaluar</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ejecutado</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Repetidos</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Omitidos</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Fuera del programa</translation>
    </message>
    <message>
        <source>Out of order</source>
        <translation>Fuera de orden</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausas</translation>
    </message>
    <message>
        <source>Pauses in all</source>
        <translation>Pausas en total</translation>
    </message>
    <message>
        <source>Share of the duration</source>
        <translation>Parte de la duración</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Peticiones</translation>
    </message>
    <message>
        <source>Access, median</source>
        <translation>Acceso, mediana</translation>
    </message>
    <message>
        <source>Access, 99th percentile</source>
        <translation>Acceso, percentil 99</translation>
    </message>
    <message>
        <source>Streamed</source>
        <translation>Transmitido</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>Cambios de herramienta</translation>
    </message>
    <message>
        <source>Other blocks of the control</source>
        <translation>Otras secuencias del control</translation>
    </message>
    <message>
        <source>Changes between both</source>
        <translation>Cambios entre ambos</translation>
    </message>
    <message>
        <source>%1, dry run %2 higher</source>
        <translation>%1, ensayo en vacío %2 más alto</translation>
    </message>
    <message>
        <source>Live lines</source>
        <translation>Líneas en vivo</translation>
    </message>
    <message>
        <source>Delay from arrival to motion</source>
        <translation>Retardo de la llegada al movimiento</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>In the spindle</source>
        <translation>En el husillo</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>Speed, 1/min</source>
        <translation>Velocidad, rpm</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Girando</translation>
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
        <translation>Longitud a lo largo del programa, real</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Consigna</translation>
    </message>
    <message>
        <source>Actual position</source>
        <translation>Posición real</translation>
    </message>
    <message>
        <source>Lag (set point minus actual)</source>
        <translation>Error de arrastre (consigna menos real)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Sacudida</translation>
    </message>
    <message>
        <source>Contour error</source>
        <translation>Error de contorno</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Requests to the control</source>
        <translation>Peticiones al control</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Columnas del archivo</translation>
    </message>
    <message>
        <source>%1 set point</source>
        <comment>of an axis</comment>
        <translation>%1 consigna</translation>
    </message>
    <message>
        <source>%1 actual</source>
        <comment>of an axis</comment>
        <translation>%1 real</translation>
    </message>
    <message>
        <source>%1 lag</source>
        <comment>of an axis</comment>
        <translation>%1 arrastre</translation>
    </message>
    <message>
        <source>%1 speed</source>
        <comment>of an axis</comment>
        <translation>%1 velocidad</translation>
    </message>
    <message>
        <source>%1 acceleration</source>
        <comment>of an axis</comment>
        <translation>%1 aceleración</translation>
    </message>
    <message>
        <source>%1 jerk</source>
        <comment>of an axis</comment>
        <translation>%1 sacudida</translation>
    </message>
    <message>
        <source>Path speed</source>
        <translation>Velocidad de trayectoria</translation>
    </message>
    <message>
        <source>Path acceleration</source>
        <translation>Aceleración de trayectoria</translation>
    </message>
    <message>
        <source>Contour error, actual</source>
        <translation>Error de contorno, real</translation>
    </message>
    <message>
        <source>Contour error, set point</source>
        <translation>Error de contorno, consigna</translation>
    </message>
    <message>
        <source>Line on the control</source>
        <translation>Línea en el control</translation>
    </message>
    <message>
        <source>Line of the program</source>
        <translation>Línea del programa</translation>
    </message>
    <message>
        <source>Point of the program</source>
        <translation>Punto del programa</translation>
    </message>
    <message>
        <source>Programmed feed</source>
        <translation>Avance programado</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Duration of writes</source>
        <translation>Duración de las escrituras</translation>
    </message>
    <message>
        <source>Duration of reads</source>
        <translation>Duración de las lecturas</translation>
    </message>
    <message>
        <source>Length along the program</source>
        <translation>Longitud a lo largo del programa</translation>
    </message>
    <message>
        <source>Time since the first sample</source>
        <translation>Tiempo desde la primera muestra</translation>
    </message>
</context>
<context>
    <name>StopCauseTexts</name>
    <message>
        <source>Unknown</source>
        <translation>Desconocida</translation>
    </message>
    <message>
        <source>Exact stop</source>
        <translation>Parada precisa</translation>
    </message>
    <message>
        <source>Dwell (G4)</source>
        <translation>Espera (G4)</translation>
    </message>
    <message>
        <source>Programmed stop (M0, M1)</source>
        <translation>Parada programada (M0, M1)</translation>
    </message>
    <message>
        <source>Tool change or auxiliary function</source>
        <translation>Cambio de herramienta o función auxiliar</translation>
    </message>
    <message>
        <source>Waiting for data of the client</source>
        <translation>Espera de datos del cliente</translation>
    </message>
    <message>
        <source>Preprocessor stop</source>
        <translation>Parada de preprocesamiento</translation>
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
        <translation>Que parada y pausa actúan de inmediato no se ha probado en este control: véase Prueba parada.</translation>
    </message>
    <message>
        <source>That stop and pause act at once was tested with another version of the server: test it again.</source>
        <translation>Que parada y pausa actúan de inmediato se probó con otra versión del servidor: pruébelo otra vez.</translation>
    </message>
    <message>
        <source>This control has failed the test that stop and pause act at once.</source>
        <translation>Este control no ha superado la prueba de que parada y pausa actúan de inmediato.</translation>
    </message>
    <message>
        <source>That stop and pause act at once was tested without motion only: see Stop test.</source>
        <translation>Que parada y pausa actúan de inmediato se probó solo sin movimiento: véase Prueba parada.</translation>
    </message>
</context>
<context>
    <name>TemplateSheetTexts</name>
    <message>
        <source>Bring %1 to the control</source>
        <translation>Llevar %1 al control</translation>
    </message>
    <message>
        <source>Layout number %1: with another one Rivulet moves nothing</source>
        <translation>Número de disposición %1: con otro, Rivulet no mueve nada</translation>
    </message>
    <message>
        <source>This program runs on the control and moves the axes to the points that Rivulet sends in R-parameters. It is valid for the settings on this page only; with others it has another layout number.</source>
        <translation>Este programa se ejecuta en el control y mueve los ejes a los puntos que Rivulet envía en parámetros R. Solo vale para los ajustes de esta hoja; con otros tiene otro número de disposición.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>File on the control</source>
        <translation>Archivo en el control</translation>
    </message>
    <message>
        <source>Layout number</source>
        <translation>Número de disposición</translation>
    </message>
    <message>
        <source>%1 in R%2</source>
        <translation>%1 en R%2</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Points, axes</source>
        <translation>Puntos, ejes</translation>
    </message>
    <message>
        <source>Make sure that no other program, cycle or client uses R%1 to R%2.</source>
        <translation>Asegurarse de que ningún otro programa, ciclo o cliente use R%1 a R%2.</translation>
    </message>
    <message>
        <source>Copy the file to the part programs of the control, by network or USB stick, as %1. Change nothing in it: Rivulet relies on every line.</source>
        <translation>Copiar el archivo a los programas de pieza del control, por red o memoria USB, como %1. No cambiar nada en él: Rivulet depende de cada línea.</translation>
    </message>
    <message>
        <source>Copy the file to the folder of the NC programs of the control as %1. Change nothing in it: Rivulet relies on every line.</source>
        <translation>Copiar el archivo a la carpeta de los programas CN del control como %1. No cambiar nada en él: Rivulet depende de cada línea.</translation>
    </message>
    <message numerus="yes">
        <source>In Rivulet, column Settings, tick “copied by hand” at Template. Look through what Start shows, then hold Start. From then on Rivulet waits up to %n minutes.</source>
        <translation>
            <numerusform>En Rivulet, columna Ajustes, marcar «copiada a mano» en Plantilla. Revisar lo que muestra Inicio y mantenerlo pulsado. Desde entonces Rivulet espera hasta %n minuto.</numerusform>
            <numerusform>En Rivulet, columna Ajustes, marcar «copiada a mano» en Plantilla. Revisar lo que muestra Inicio y mantenerlo pulsado. Desde entonces Rivulet espera hasta %n minutos.</numerusform>
        </translation>
    </message>
    <message>
        <source>At the control: select the program in channel 1, close the doors, set the feed override, press cycle start. No axis moves yet.</source>
        <translation>En el control: seleccionar el programa en el canal 1, cerrar las puertas, ajustar el override de avance, pulsar Marcha CN. Todavía no se mueve ningún eje.</translation>
    </message>
    <message>
        <source>The program writes its layout number and waits. Only when Rivulet has read the right number, it sends points and the axes move.</source>
        <translation>El programa escribe su número de disposición y espera. Solo cuando Rivulet ha leído el número correcto envía puntos y los ejes se mueven.</translation>
    </message>
    <message>
        <source>The control shows this program as running from cycle start until its end, also while the axes stand and it waits for points.</source>
        <translation>El control muestra este programa en marcha desde Marcha CN hasta su fin, también mientras los ejes están parados y espera puntos.</translation>
    </message>
    <message>
        <source>Feed override, feed hold, reset and emergency stop of the machine act as in any other program. Stop and Pause in Rivulet do not replace them.</source>
        <translation>El override de avance, la parada de avance, Reset y la parada de emergencia de la máquina actúan como en cualquier otro programa. Parada y Pausa de Rivulet no los sustituyen.</translation>
    </message>
    <message>
        <source>If Rivulet, its computer or the network fails, nothing new is sent: with numbered windows the axes stand; with methods position and signal they may go to old points again.</source>
        <translation>Si falla Rivulet, su ordenador o la red, no se envía nada nuevo: con ventanas numeradas los ejes se paran; con los métodos Posición y Señal pueden ir otra vez a puntos antiguos.</translation>
    </message>
    <message>
        <source>End the run in Rivulet. If the program still runs: press reset at the control.</source>
        <translation>Terminar la ejecución en Rivulet. Si el programa sigue en marcha: pulsar Reset en el control.</translation>
    </message>
    <message>
        <source>Select another program, then delete the file from the part programs of the control.</source>
        <translation>Seleccionar otro programa y borrar después el archivo de los programas de pieza del control.</translation>
    </message>
    <message>
        <source>The R-parameters keep their last values. Set to 0 those that other programs read.</source>
        <translation>Los parámetros R conservan sus últimos valores. Poner a 0 los que leen otros programas.</translation>
    </message>
    <message>
        <source>Take back the rights that were given for it; on a SINUMERIK with DeleteUserAccess. Remove the certificate of this computer from those that the control trusts if Rivulet is not to connect again.</source>
        <translation>Retirar los derechos que se dieron para ello; en un SINUMERIK con DeleteUserAccess. Quitar el certificado de este ordenador de aquellos en los que confía el control si Rivulet no debe volver a conectarse.</translation>
    </message>
    <message>
        <source>Rights of the OPC UA user</source>
        <translation>Derechos del usuario OPC UA</translation>
    </message>
    <message>
        <source>(Not needed for these steps.)</source>
        <translation>(No es necesario para estos pasos.)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>What the operator sees</source>
        <translation>Lo que ve el operador</translation>
    </message>
    <message>
        <source>Taking it back</source>
        <translation>Deshacerlo</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Fecha, nombre, firma</translation>
    </message>
</context>
<context>
    <name>TraceRemarks</name>
    <message>
        <source>The program does not belong to this trace from %1 s on.</source>
        <translation>A partir de %1 s el programa no corresponde a esta traza.</translation>
    </message>
    <message>
        <source>The trace of the control is incomplete: its memory was full.</source>
        <translation>La traza del control está incompleta: su memoria estaba llena.</translation>
    </message>
    <message>
        <source>Lines of the recording that cannot be read and were left out: %1.</source>
        <translation>Líneas ilegibles de la grabación, omitidas: %1.</translation>
    </message>
    <message>
        <source>The recording ends before its run: what came before is shown.</source>
        <translation>La grabación termina antes que su ejecución: se muestra lo anterior.</translation>
    </message>
    <message>
        <source>The columns mean what was said for this layout before: %1.</source>
        <translation>Las columnas significan lo que se indicó antes para esta disposición: %1.</translation>
    </message>
    <message>
        <source>The file does not say the units of its speeds: mm/min is assumed, as the control shows them.</source>
        <translation>El archivo no indica las unidades de las velocidades: se supone mm/min, como las muestra el control.</translation>
    </message>
    <message>
        <source>The compressed file is cut or damaged: what came before was read.</source>
        <translation>El archivo comprimido está cortado o dañado: se leyó lo anterior.</translation>
    </message>
    <message>
        <source>The file was cut off: its end is missing.</source>
        <translation>El archivo se cortó: falta el final.</translation>
    </message>
    <message>
        <source>The file ends within a row: it was cut off there.</source>
        <translation>El archivo termina en medio de una fila: ahí se cortó.</translation>
    </message>
    <message>
        <source>Cells that are no numbers and were left empty: %1, the first in line %2.</source>
        <translation>Celdas que no son números y quedaron vacías: %1, la primera en la línea %2.</translation>
    </message>
    <message>
        <source>Rows that do not have %1 columns and were left out: %2, the first in line %3.</source>
        <translation>Filas omitidas porque no tienen %1 columnas: %2, la primera en la línea %3.</translation>
    </message>
    <message>
        <source>The file has %1 columns of time; each belongs to the columns after it.</source>
        <translation>El archivo tiene %1 columnas de tiempo; cada una vale para las columnas que la siguen.</translation>
    </message>
    <message>
        <source>Values whose time runs backwards and that were left out: %1.</source>
        <translation>Valores omitidos porque su tiempo retrocede: %1.</translation>
    </message>
    <message>
        <source>Rows that repeat the time of the row before and were left out: %1.</source>
        <translation>Filas omitidas porque repiten el tiempo de la anterior: %1.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; runs backwards at row %2. Rows that were left out until it goes on: %3.</source>
        <translation>El tiempo «%1» retrocede en la fila %2. Filas omitidas hasta que sigue: %3.</translation>
    </message>
    <message>
        <source>The file has no column of time: %1 Hz is assumed.</source>
        <translation>El archivo no tiene columna de tiempo: se suponen %1 Hz.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; has no unit: %2 is assumed.</source>
        <translation>El tiempo «%1» no tiene unidad: se supone %2.</translation>
    </message>
    <message>
        <source>The column &quot;%1&quot; occurs more than once: this one is called &quot;%2&quot;.</source>
        <translation>La columna «%1» aparece varias veces: esta se llama «%2».</translation>
    </message>
    <message>
        <source>Datasets that are no row of numbers and were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Conjuntos de datos que no son una serie de números y se omitieron: %1, el primero «%2».</translation>
    </message>
    <message>
        <source>Datasets that are damaged and were read in part or not at all: %1, the first &quot;%2&quot;.</source>
        <translation>Conjuntos de datos dañados, leídos en parte o nada: %1, el primero «%2».</translation>
    </message>
    <message>
        <source>Datasets to whose length no time belongs and that were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Conjuntos de datos sin un tiempo de la misma longitud, omitidos: %1, el primero «%2».</translation>
    </message>
    <message>
        <source>The rows are not in the order of their time &quot;%1&quot;, the first at row %2: they were sorted.</source>
        <translation>Las filas no están en el orden de su tiempo «%1», la primera es la %2: se han ordenado.</translation>
    </message>
    <message>
        <source>The time &quot;%1&quot; starts again, the first time at row %2. %3 sections are shown %4 s apart, and the longest one is analysed.</source>
        <translation>El tiempo «%1» vuelve a empezar, la primera vez en la fila %2. Se muestran %3 tramos separados %4 s, y se analiza el más largo.</translation>
    </message>
    <message>
        <source>The signals stand in rows of their own: straight lines are assumed between the values of each.</source>
        <translation>Cada señal está en filas propias: entre sus valores se suponen rectas.</translation>
    </message>
    <message>
        <source>Rows of text that hold no values and were left out: %1, the first in line %2.</source>
        <translation>Filas de texto sin valores, omitidas: %1, la primera en la línea %2.</translation>
    </message>
    <message>
        <source>No date tells what comes first in it: day/month is assumed.</source>
        <translation>Ninguna fecha indica qué va primero: se supone día/mes.</translation>
    </message>
    <message>
        <source>An MTConnect agent reports a value when it changes: in gaps the last value is held; otherwise straight lines are assumed between values.</source>
        <translation>Un agente MTConnect comunica un valor cuando cambia: en los huecos se mantiene el último valor; si no, se suponen líneas rectas entre los valores.</translation>
    </message>
    <message>
        <source>All positions are known from %1 s on: what comes before is not analysed.</source>
        <translation>Todas las posiciones se conocen a partir de %1 s: lo anterior no se analiza.</translation>
    </message>
    <message>
        <source>Values with the time of a later value of the same item, which counts instead: %1.</source>
        <translation>Valores con el instante de un valor posterior del mismo elemento, que cuenta en su lugar: %1.</translation>
    </message>
    <message>
        <source>Observations that are tables or sets of values and were left out: %1, the first of &quot;%2&quot;.</source>
        <translation>Observaciones que son tablas o conjuntos de valores y que se han omitido: %1, la primera de «%2».</translation>
    </message>
    <message>
        <source>Series of values without a sample rate that were left out, because their times are not known: %1, the first of &quot;%2&quot;.</source>
        <translation>Series de valores sin frecuencia de muestreo, omitidas porque no se conocen sus instantes: %1, la primera de «%2».</translation>
    </message>
    <message>
        <source>Observations without a time or a number that can be read and that were left out: %1, the first of &quot;%2&quot;.</source>
        <translation>Observaciones sin un instante o un número legible, que se han omitido: %1, la primera de «%2».</translation>
    </message>
    <message>
        <source>Items without any value that were left out: %1, the first &quot;%2&quot;.</source>
        <translation>Elementos sin ningún valor, que se han omitido: %1, el primero «%2».</translation>
    </message>
    <message>
        <source>Items that mean the same as another one, which is analysed instead: %1.</source>
        <translation>Elementos que significan lo mismo que otro, que se analiza en su lugar: %1.</translation>
    </message>
    <message>
        <source>The unit &quot;%2&quot; of the item &quot;%1&quot; is not known: the item is not analysed.</source>
        <translation>No se conoce la unidad «%2» del elemento «%1»: el elemento no se analiza.</translation>
    </message>
    <message>
        <source>States and messages of the machine that are too many and were left out: %1.</source>
        <translation>Estados y mensajes de la máquina que son demasiados y se han omitido: %1.</translation>
    </message>
    <message>
        <source>The MTConnect agent refused a part: %1.</source>
        <translation>El agente MTConnect ha rechazado una parte: %1.</translation>
    </message>
    <message>
        <source>Observations between two answers that the MTConnect agent no longer had: %1. The motion is not known there.</source>
        <translation>Observaciones entre dos respuestas que el agente MTConnect ya no tenía: %1. El movimiento no se conoce ahí.</translation>
    </message>
    <message>
        <source>The MTConnect agent was started again between two answers: what it had kept until then may be incomplete.</source>
        <translation>El agente MTConnect se reinició entre dos respuestas: lo que había conservado hasta entonces puede estar incompleto.</translation>
    </message>
</context>
<context>
    <name>TraceTexts</name>
    <message>
        <source>Report of a run</source>
        <translation>Informe de ejecución</translation>
    </message>
    <message>
        <source>Report on a motion</source>
        <translation>Informe de un movimiento</translation>
    </message>
    <message>
        <source>Every point executed once, in order</source>
        <translation>Cada punto ejecutado una vez, en orden</translation>
    </message>
    <message>
        <source>The motion is not that of the program</source>
        <translation>El movimiento no es el del programa</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>No evaluado</translation>
    </message>
    <message>
        <source>Whether each point was executed is not known: the program or a part of the trace is missing.</source>
        <translation>No se sabe si se ejecutó cada punto: falta el programa o una parte de la medición.</translation>
    </message>
    <message>
        <source>The recording was cut off before the end of the run. What it holds is judged here.</source>
        <translation>La grabación se corta antes del final de la ejecución. Aquí se evalúa lo que contiene.</translation>
    </message>
    <message>
        <source>The motion leaves the program for good before line %1, at X %2 Y %3 Z %4.</source>
        <translation>El movimiento abandona definitivamente el programa antes de la línea %1, en X %2 Y %3 Z %4.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>Medición</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ajustes</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Client and control</source>
        <translation>Cliente y control</translation>
    </message>
    <message>
        <source>Date, name, signature</source>
        <translation>Fecha, nombre, firma</translation>
    </message>
    <message>
        <source>File %1, SHA-256 %2</source>
        <translation>Archivo %1, SHA-256 %2</translation>
    </message>
    <message>
        <source>Rivulet %1</source>
        <translation>Rivulet %1</translation>
    </message>
    <message>
        <source>Rivulet %1; run made with version %2</source>
        <translation>Rivulet %1; ejecución hecha con la versión %2</translation>
    </message>
    <message>
        <source>Program grey, motion blue</source>
        <translation>Programa gris, movimiento azul</translation>
    </message>
    <message>
        <source>The trace holds no motion.</source>
        <translation>La medición no contiene ningún movimiento.</translation>
    </message>
    <message>
        <source>Path speed; stops are orange</source>
        <translation>Velocidad en la trayectoria; paradas en naranja</translation>
    </message>
    <message>
        <source>Duration of requests: median blue, longest orange</source>
        <translation>Duración de las peticiones: mediana azul, la más larga naranja</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Tiempo, s</translation>
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
        <translation>Las más largas de %1 paradas</translation>
    </message>
    <message>
        <source>At</source>
        <translation>En</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Place, mm</source>
        <translation>Lugar, mm</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Causa</translation>
    </message>
    <message>
        <source>What limited the run: the client. The machine waited %1 times for its data, %2 in all.</source>
        <translation>Lo que limitó la ejecución: el cliente. La máquina esperó %1 veces sus datos, %2 en total.</translation>
    </message>
    <message>
        <source>What limited the run: the access time. At %1 the client is slower than the machine; up to %2 it keeps up.</source>
        <translation>Lo que limitó la ejecución: el tiempo de acceso. A %1 el cliente es más lento que la máquina; hasta %2 la sigue.</translation>
    </message>
    <message>
        <source>What limited the run: the stops between loops or windows, %1 in all.</source>
        <translation>Lo que limitó la ejecución: las paradas entre bucles o ventanas, %1 en total.</translation>
    </message>
    <message>
        <source>What limited the run: the machine, by braking and accelerating, not the client.</source>
        <translation>Lo que limitó la ejecución: la máquina, al frenar y acelerar, no el cliente.</translation>
    </message>
    <message>
        <source>With N = %1, feeds up to %2 would have been possible.</source>
        <translation>Con N = %1 habrían sido posibles avances de hasta %2.</translation>
    </message>
    <message>
        <source>With arrays that cost as much as one variable, feeds up to %1 would have been possible.</source>
        <translation>Con matrices que cuestan lo mismo que una variable habrían sido posibles avances de hasta %1.</translation>
    </message>
    <message>
        <source>Without another change, %1 is the largest feed at which the machine does not wait.</source>
        <translation>Sin otro cambio, %1 es el mayor avance con el que la máquina no espera.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Tipo de archivo</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Muestras</translation>
    </message>
    <message>
        <source>Time between two samples</source>
        <translation>Tiempo entre dos muestras</translation>
    </message>
    <message>
        <source>Version (hash)</source>
        <translation>Versión (hash)</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Started by</source>
        <translation>Iniciada por</translation>
    </message>
    <message>
        <source>Run number</source>
        <translation>Número de ejecución</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Disposición</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>sin evaluar</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ejecutado</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Repetidos</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Omitidos</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Fuera del programa</translation>
    </message>
    <message>
        <source>Out of order</source>
        <translation>Fuera de orden</translation>
    </message>
    <message>
        <source>Not decided by the samples</source>
        <translation>No decidido por la medición</translation>
    </message>
    <message>
        <source>%1 in line %2</source>
        <translation>%1 en la línea %2</translation>
    </message>
    <message>
        <source>Contour error, set point</source>
        <translation>Error de contorno, consigna</translation>
    </message>
    <message>
        <source>Contour error, actual</source>
        <translation>Error de contorno, real</translation>
    </message>
    <message>
        <source>Following error XYZ</source>
        <translation>Error de seguimiento XYZ</translation>
    </message>
    <message>
        <source>Reversal error XYZ</source>
        <translation>Error de inversión XYZ</translation>
    </message>
    <message>
        <source>Strongest vibration</source>
        <translation>Vibración más fuerte</translation>
    </message>
    <message>
        <source>Programmed feed kept</source>
        <translation>Avance programado mantenido</translation>
    </message>
    <message>
        <source>At the programmed feed</source>
        <translation>Con el avance programado</translation>
    </message>
    <message>
        <source>Lost by moving slower</source>
        <translation>Perdido por ir más lento</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Peticiones</translation>
    </message>
    <message>
        <source>Machine waited for the client</source>
        <translation>La máquina esperó al cliente</translation>
    </message>
    <message>
        <source>%1 times, %2</source>
        <translation>%1 veces, %2</translation>
    </message>
    <message>
        <source>Largest feed without waiting</source>
        <translation>Mayor avance sin espera</translation>
    </message>
    <message>
        <source>Median, 99 %, longest</source>
        <translation>Mediana, 99&#xa0;%, máxima</translation>
    </message>
    <message>
        <source>Requests made again</source>
        <translation>Peticiones repetidas</translation>
    </message>
    <message>
        <source>Margin; of the slowest 1 %</source>
        <translation>Margen; del 1&#xa0;% más lento</translation>
    </message>
    <message>
        <source>Path speed up to %1 mm/min; stops are orange</source>
        <translation>Velocidad en la trayectoria hasta %1 mm/min; paradas en naranja</translation>
    </message>
</context>
<context>
    <name>TracesPage</name>
    <message>
        <source>The file of the pane layouts is damaged. What can be read of it is used, and the file is kept as %1.</source>
        <translation>El archivo de disposiciones de paneles está dañado. Se usa lo que se puede leer, y el archivo se conserva como %1.</translation>
    </message>
    <message>
        <source>A run is in progress. Open files after it has ended.</source>
        <translation>Hay una ejecución en curso. Abrir archivos cuando haya terminado.</translation>
    </message>
</context>
<context>
    <name>TrendWords</name>
    <message>
        <source>Trend of the runs</source>
        <translation>Tendencia de las ejecuciones</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>Días</translation>
    </message>
    <message>
        <source>Access, ms</source>
        <translation>Acceso, ms</translation>
    </message>
    <message>
        <source>Paused, s</source>
        <translation>Pausas, s</translation>
    </message>
    <message>
        <source>per run</source>
        <translation>por ejecución</translation>
    </message>
    <message>
        <source>per day</source>
        <translation>por día</translation>
    </message>
    <message>
        <source>Access time per run</source>
        <translation>Tiempo de acceso por ejecución</translation>
    </message>
    <message>
        <source>Mean access time, ms</source>
        <translation>Tiempo de acceso medio, ms</translation>
    </message>
    <message>
        <source>Pauses per run</source>
        <translation>Pausas por ejecución</translation>
    </message>
    <message>
        <source>Time in pauses, s</source>
        <translation>Tiempo en pausa, s</translation>
    </message>
    <message>
        <source>Run of the machine</source>
        <translation>Ejecución de la máquina</translation>
    </message>
    <message>
        <source>Days since %1</source>
        <comment>a date</comment>
        <translation>Días desde el %1</translation>
    </message>
    <message>
        <source>%1, trend</source>
        <comment>of a machine</comment>
        <translation>%1, tendencia</translation>
    </message>
</context>
<context>
    <name>TrustTexts</name>
    <message>
        <source>Only an engineer can do this.</source>
        <translation>Solo puede hacerlo un preparador.</translation>
    </message>
    <message>
        <source>Connect first.</source>
        <translation>Conectar primero.</translation>
    </message>
    <message>
        <source>During a run there is no time for it.</source>
        <translation>Durante una ejecución no hay tiempo para ello.</translation>
    </message>
</context>
<context>
    <name>UserTexts</name>
    <message>
        <source>At least one user must be an engineer.</source>
        <translation>Al menos un usuario debe ser preparador.</translation>
    </message>
    <message>
        <source>The file of users is damaged. Restore it, or delete it to set the users up again.</source>
        <translation>El archivo de usuarios está dañado. Restaurarlo, o borrarlo y volver a configurar los usuarios.</translation>
    </message>
    <message>
        <source>Give a name.</source>
        <translation>Indicar un nombre.</translation>
    </message>
    <message>
        <source>The PIN needs at least 4 characters.</source>
        <translation>El PIN debe tener al menos 4 caracteres.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Alarms</name>
    <message>
        <source>%1: %2 damaged lines of the history of alarms were left out.</source>
        <translation>%1: se omitieron %2 líneas dañadas del historial de alarmas.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Certificates</name>
    <message>
        <source>Saved %1.</source>
        <translation>%1 guardado.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Demo</name>
    <message>
        <source>The picture or the report cannot be written to %1.</source>
        <translation>No se puede escribir la imagen o el informe en %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::Document</name>
    <message>
        <source>Line %1</source>
        <translation>Línea %1</translation>
    </message>
    <message>
        <source>A dry run needs the whole job, but only the motion of this program would be streamed. Choose Whole job.</source>
        <translation>Solo un trabajo completo se ejecuta en vacío, y este programa es solo movimiento. Elija Trabajo completo.</translation>
    </message>
    <message>
        <source>A dry run needs the whole job: choose method window or credit, and no online correction.</source>
        <translation>Un ensayo en vacío necesita el trabajo completo: elija el método Ventana o Crédito, sin corrección en línea.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::FoundRuns</name>
    <message>
        <source>The run that was watched has ended.</source>
        <translation>La ejecución observada ha terminado.</translation>
    </message>
    <message>
        <source>There is a run on the control: %1</source>
        <translation>Hay una ejecución en el control: %1</translation>
    </message>
    <message>
        <source>The run has been stopped; confirmed after %1.</source>
        <translation>Se ha parado la ejecución; confirmado tras %1.</translation>
    </message>
    <message>
        <source>Stop of the run on the control requested.</source>
        <translation>Solicitada la parada de la ejecución en el control.</translation>
    </message>
    <message>
        <source>The file of the program, %1, cannot be found. Open the program, then try again.</source>
        <translation>No se encuentra el archivo del programa, %1. Abrir el programa y volver a intentarlo.</translation>
    </message>
    <message>
        <source>This run was a whole job, and its program cannot be run as one here now. The command rivulet-cli job --resume goes on with it.</source>
        <translation>Esta ejecución era un trabajo completo y su programa no puede ejecutarse así aquí ahora. La orden rivulet-cli job --resume lo continúa.</translation>
    </message>
    <message>
        <source>The axes of the run on the control are held; they stood after %1.</source>
        <translation>Los ejes de la ejecución en el control están retenidos; se pararon después de %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::LiveSource</name>
    <message>
        <source>A run is in progress. Open a live source after it has ended.</source>
        <translation>Hay una ejecución en curso. Abrir una fuente en vivo cuando haya terminado.</translation>
    </message>
    <message>
        <source>Listening for live points on %1.</source>
        <translation>Se esperan puntos en vivo en %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MachineModel</name>
    <message>
        <source>Connected to the virtual machine at %1.</source>
        <translation>Conectado con la máquina virtual en %1.</translation>
    </message>
    <message>
        <source>Connected to the control at %1.</source>
        <translation>Conectado con el control en %1.</translation>
    </message>
    <message>
        <source>Calibrated. Saved %1.</source>
        <translation>Calibrado. %1 guardado.</translation>
    </message>
    <message>
        <source>The calibration belongs to another version of the server and is not used.</source>
        <translation>La calibración corresponde a otra versión del servidor y no se utiliza.</translation>
    </message>
    <message>
        <source>The map %1 does not name: %2. What needs it does not work.</source>
        <translation>El mapa %1 no nombra: %2. Lo que lo necesita no funciona.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MachineProfiles</name>
    <message>
        <source>The limits of %1 have been saved.</source>
        <translation>Se han guardado los límites de %1.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::MainWindow</name>
    <message>
        <source>About Rivulet</source>
        <translation>Acerca de Rivulet</translation>
    </message>
    <message>
        <source>Rivulet %1
Streams a tool path to a CNC machine over OPC UA while the machine moves.

Stop ends the program at the end of its loop. It is not an emergency stop.

GPL-3.0-or-later</source>
        <translation>Rivulet %1
Transmite una trayectoria de herramienta a una máquina CNC por OPC UA mientras la máquina se mueve.

Parada termina el programa al final de su bucle. No es una parada de emergencia.

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
        <translation>&amp;Abrir programa…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Claro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Oscuro</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Como el sistema</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ay&amp;uda</translation>
    </message>
    <message>
        <source>&amp;About Rivulet</source>
        <translation>Acerca &amp;de Rivulet</translation>
    </message>
    <message>
        <source>Method, feed and verdict</source>
        <translation>Método, avance y veredicto</translation>
    </message>
    <message>
        <source>&amp;Menu</source>
        <translation>&amp;Menú</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Alto contraste</translation>
    </message>
    <message>
        <source>Li&amp;ve points …</source>
        <translation>Puntos en &amp;vivo…</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>Analyse</source>
        <translation>Análisis</translation>
    </message>
    <message>
        <source>Set up</source>
        <translation>Preparar</translation>
    </message>
    <message>
        <source>&amp;Settings</source>
        <translation>A&amp;justes</translation>
    </message>
    <message>
        <source>La&amp;rge view</source>
        <translation>Vista &amp;grande</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::PastRuns</name>
    <message>
        <source>A run is in progress: the Traces page shows it until it has ended.</source>
        <translation>Hay una ejecución en curso: la página Curvas la muestra hasta que termine.</translation>
    </message>
    <message>
        <source>A run is in progress. Open another program after it has ended.</source>
        <translation>Hay una ejecución en curso. Abrir otro programa cuando haya terminado.</translation>
    </message>
    <message>
        <source>The settings of the run have been taken over. Where its program was is not known: open the program with version %1.</source>
        <translation>Se han tomado los ajustes de la ejecución. No indica dónde estaba su programa: abrir el programa con versión %1.</translation>
    </message>
    <message>
        <source>%1 is not the program of that run: version %2 then, %3 now. Its settings are set. Check the path before you start.</source>
        <translation>%1 no es el programa de esa ejecución: versión %2 entonces, %3 ahora. Se han tomado sus ajustes. Comprobar la trayectoria antes de iniciar.</translation>
    </message>
    <message>
        <source>Program and settings are those of the run of %1. Nothing has started.</source>
        <translation>Programa y ajustes son los de la ejecución del %1. No se ha iniciado nada.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::PipelineRun</name>
    <message>
        <source>The program rivulet-cnc is missing. Install it beside this window.</source>
        <translation>Falta el programa rivulet-cnc. Instalarlo junto a esta ventana.</translation>
    </message>
    <message>
        <source>The tasks have ended without a message. Execute the program again.</source>
        <translation>Las tareas terminaron sin mensaje. Ejecutar de nuevo el programa.</translation>
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
        <translation>Programa</translation>
    </message>
    <message>
        <source>%1 has changed on disk since version %2 was read.</source>
        <translation>%1 ha cambiado en el disco desde que se leyó la versión %2.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Sin conexión</translation>
    </message>
    <message>
        <source>%1: a virtual machine, no real axis moves</source>
        <translation>%1: una máquina virtual, no se mueve ningún eje real</translation>
    </message>
    <message>
        <source>%1: the axes of this machine will move</source>
        <translation>%1: los ejes de esta máquina se moverán</translation>
    </message>
    <message>
        <source>First move</source>
        <translation>Primer movimiento</translation>
    </message>
    <message>
        <source>The position of the tool is not known.</source>
        <translation>No se conoce la posición de la herramienta.</translation>
    </message>
    <message>
        <source>From %1 in a straight line over %2 to point 1 at %3</source>
        <translation>De %1 en línea recta a lo largo de %2 hasta el punto 1 en %3</translation>
    </message>
    <message>
        <source>The last run was left at %1 of %2 points. This start does not go on there: it moves from where the tool stands, perhaps in the cut, to the first point.</source>
        <translation>La última ejecución se interrumpió en %1 de %2 puntos. Este inicio no continúa allí: va desde donde está la herramienta, quizá en pleno corte, hasta el primer punto.</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>%1 for every block, set here</source>
        <translation>%1 para cada secuencia, ajustado aquí</translation>
    </message>
    <message>
        <source>%1. The program names no feed.</source>
        <translation>%1. El programa no indica ningún avance.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>%1. The program&apos;s own feed, %2, is not used.</source>
        <translation>%1. El avance propio del programa, %2, no se utiliza.</translation>
    </message>
    <message>
        <source>Some blocks will be cut %1 times as fast as programmed.</source>
        <translation>Algunas secuencias se mecanizarán %1 veces más rápido de lo programado.</translation>
    </message>
    <message>
        <source>Use F = %1</source>
        <translation>Usar F = %1</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>There is no verdict.</source>
        <translation>No hay veredicto.</translation>
    </message>
    <message>
        <source>Safe, but the machine will wait for points. Largest feed without waiting: %1.</source>
        <translation>Seguro, pero la máquina esperará puntos. Avance máximo sin esperas: %1.</translation>
    </message>
    <message>
        <source>Margin %1 ×, largest feed %2</source>
        <translation>Margen %1 ×, avance máximo %2</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Acceso</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulación</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Aprobación</translation>
    </message>
    <message>
        <source>Released by %1 on %2, who starts: %3</source>
        <translation>Aprobado por %1 el %2, inicia: %3</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>This program with these settings and this calibration is not released.</source>
        <translation>Este programa con estos ajustes y esta calibración no está aprobado.</translation>
    </message>
    <message>
        <source>point %1 of %2 at %3</source>
        <translation>punto %1 de %2 en %3</translation>
    </message>
    <message>
        <source>From point %1 on, the program differs from that of the interrupted run.</source>
        <translation>A partir del punto %1, el programa difiere del de la ejecución interrumpida.</translation>
    </message>
    <message>
        <source>Who starts</source>
        <translation>Quién inicia</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>The feeds of the program at %1. It names none.</source>
        <translation>Los avances del programa al %1. No indica ninguno.</translation>
    </message>
    <message>
        <source>That of the program, %1, at %2</source>
        <translation>El del programa, %1, al %2</translation>
    </message>
    <message>
        <source>Those of the program, %1 to %2, at %3; each block its own</source>
        <translation>Los del programa, %1 a %2, al %3; cada secuencia el suyo</translation>
    </message>
    <message>
        <source>Rapids at %1 at most</source>
        <translation>Rápidos a %1 como máximo</translation>
    </message>
    <message>
        <source>Blocks will be cut faster than programmed.</source>
        <translation>Hay secuencias que se mecanizarán más rápido de lo programado.</translation>
    </message>
    <message>
        <source>Use 100 %</source>
        <translation>Usar 100&#xa0;%</translation>
    </message>
    <message>
        <source>%1 for every block: this method has one feed, as it was published</source>
        <translation>%1 para cada secuencia: este método tiene un solo avance, tal como se publicó</translation>
    </message>
    <message>
        <source>Use the feeds of the program</source>
        <translation>Usar los avances del programa</translation>
    </message>
    <message>
        <source>Safe, but the machine will wait for points. Largest override without waiting: %1.</source>
        <translation>Seguro, pero la máquina esperará puntos. Override máximo sin esperas: %1.</translation>
    </message>
    <message>
        <source>Margin %1 ×, largest override %2</source>
        <translation>Margen %1 ×, override máximo %2</translation>
    </message>
    <message>
        <source>%1 (line %2)</source>
        <translation>%1 (línea %2)</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>Whole job</source>
        <translation>Trabajo completo</translation>
    </message>
    <message>
        <source>Motion only</source>
        <translation>Solo movimiento</translation>
    </message>
    <message>
        <source>Set tool, spindle and coolant at the control.</source>
        <translation>Ajustar herramienta, cabezal y refrigerante en el control.</translation>
    </message>
    <message>
        <source>Run the whole job</source>
        <translation>Ejecutar el trabajo completo</translation>
    </message>
    <message>
        <source>First the control executes line %1: %2. Then the tool moves from where it stands to the first point of part 1.</source>
        <translation>Primero el control ejecuta la línea %1: %2. Después la herramienta va desde donde está al primer punto del tramo 1.</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Not checked: nobody has entered the limits of this machine.</source>
        <translation>No comprobado: nadie ha introducido los límites de esta máquina.</translation>
    </message>
    <message>
        <source>Enter …</source>
        <translation>Introducir…</translation>
    </message>
    <message>
        <source>%1 needs %2, the machine has %3</source>
        <translation>%1 necesita %2, la máquina tiene %3</translation>
    </message>
    <message>
        <source>The path is longer than the travel: %1.</source>
        <translation>La trayectoria es más larga que el recorrido: %1.</translation>
    </message>
    <message>
        <source>The path (%1 mm) is not longer than the travel of the axes. Where the workpiece lies is not known to Rivulet.</source>
        <translation>La trayectoria (%1 mm) no es más larga que el recorrido de los ejes. Rivulet no sabe dónde está la pieza.</translation>
    </message>
    <message>
        <source>Travel, spindle and tools</source>
        <translation>Recorridos, cabezal y herramientas</translation>
    </message>
    <message>
        <source>The job is being compared with the machine.</source>
        <translation>El trabajo se está comparando con la máquina.</translation>
    </message>
    <message>
        <source>Every block is within the travel of the axes, the speed of the spindle and the tool table.</source>
        <translation>Todas las secuencias respetan los recorridos de los ejes, la velocidad del cabezal y la tabla de herramientas.</translation>
    </message>
    <message numerus="yes">
        <source>%1, version %2, %Ln points</source>
        <translation>
            <numerusform>%1, versión %2, %Ln punto</numerusform>
            <numerusform>%1, versión %2, %Ln puntos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Streamed: %1; the control executes %Ln blocks: %2</source>
        <translation>
            <numerusform>Transmisión continua: %1; el control ejecuta %Ln secuencia: %2</numerusform>
            <numerusform>Transmisión continua: %1; el control ejecuta %Ln secuencias: %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln tramo</numerusform>
            <numerusform>%Ln tramos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln blocks are left out: %1</source>
        <translation>
            <numerusform>Se omite %Ln secuencia: %1</numerusform>
            <numerusform>Se omiten %Ln secuencias: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line over %1 to %2. %Ln points have been executed.</source>
        <translation>
            <numerusform>En línea recta a lo largo de %1 hasta %2. Se ha ejecutado %Ln punto.</numerusform>
            <numerusform>En línea recta a lo largo de %1 hasta %2. Se han ejecutado %Ln puntos.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>In a straight line to %1. %Ln points have been executed.</source>
        <translation>
            <numerusform>En línea recta hasta %1. Se ha ejecutado %Ln punto.</numerusform>
            <numerusform>En línea recta hasta %1. Se han ejecutado %Ln puntos.</numerusform>
        </translation>
    </message>
    <message>
        <source>as a rapid, %1</source>
        <translation>en rápido, %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>a %1</translation>
    </message>
    <message>
        <source>From where the tool stands in a straight line over %1, %2, to where line %3 begins: %4.</source>
        <translation>Desde donde está la herramienta en línea recta a lo largo de %1, %2, hasta el comienzo de la línea %3: %4.</translation>
    </message>
    <message>
        <source>From where the tool stands in a straight line, %1, to where line %2 begins: %3.</source>
        <translation>Desde donde está la herramienta en línea recta, %1, hasta el comienzo de la línea %2: %3.</translation>
    </message>
    <message numerus="yes">
        <source>The %Ln points before it are not executed.</source>
        <translation>
            <numerusform>El %Ln punto anterior no se ejecuta.</numerusform>
            <numerusform>Los %Ln puntos anteriores no se ejecutan.</numerusform>
        </translation>
    </message>
    <message>
        <source>Feeds are those that the program has commanded up to each line, and the work offset is the one that is active at the control.</source>
        <translation>Valen los avances que el programa ha mandado hasta cada línea, y el decalaje de origen activo en el control.</translation>
    </message>
    <message>
        <source>State at this line</source>
        <translation>Estado en esta línea</translation>
    </message>
    <message>
        <source>Left out before this line, the last one first: %1. Set at the control what holds here.</source>
        <translation>Omitidas antes de esta línea, la última primero: %1. Ajustar en el control lo que vale aquí.</translation>
    </message>
    <message>
        <source>Begin with a part …</source>
        <translation>Empezar por un tramo …</translation>
    </message>
    <message>
        <source>First the control executes</source>
        <translation>Primero el control ejecuta</translation>
    </message>
    <message>
        <source>Then the job goes on in part %1 at point %2 of %3 (line %4).</source>
        <translation>Después el trabajo continúa en el tramo %1, punto %2 de %3 (línea %4).</translation>
    </message>
    <message>
        <source>Then the job goes on at line %1: %2</source>
        <translation>Después el trabajo continúa en la línea %1: %2</translation>
    </message>
    <message>
        <source>Not done again, because only the control knows their effect: %1</source>
        <translation>No se repiten, porque solo el control conoce su efecto: %1</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Ensayo en vacío</translation>
    </message>
    <message>
        <source>Everything takes place %1 higher than programmed. The spindle does not turn, and no coolant flows; tools are changed, and retracts in machine coordinates are made.</source>
        <translation>Todo ocurre %1 más alto de lo programado. El cabezal no gira y no fluye refrigerante; se cambian las herramientas y se ejecutan las retiradas en coordenadas de máquina.</translation>
    </message>
    <message>
        <source>Live source</source>
        <translation>Fuente en vivo</translation>
    </message>
    <message>
        <source>Change …</source>
        <translation>Cambiar…</translation>
    </message>
    <message>
        <source>%1 is open. What it sends is read from the start on.</source>
        <translation>%1 está abierta. Lo que envía se lee a partir del inicio.</translation>
    </message>
    <message>
        <source>Agreed</source>
        <translation>Acordado</translation>
    </message>
    <message>
        <source>No point is outside %1. No step is longer than %2. Anything else ends the run after the last good point.</source>
        <translation>Ningún punto está fuera de %1. Ningún paso es más largo que %2. Todo lo demás termina la ejecución tras el último punto bueno.</translation>
    </message>
    <message>
        <source>The F of the points, at most %1; that is also the feed before the first F.</source>
        <translation>La F de los puntos, como máximo %1; es también el avance antes de la primera F.</translation>
    </message>
    <message>
        <source>No points</source>
        <translation>Sin puntos</translation>
    </message>
    <message>
        <source>The machine waits at the end of the last window: %1.</source>
        <translation>La máquina espera al final de la última ventana: %1.</translation>
    </message>
    <message>
        <source>From %1 in a straight line to the first point, which may be %2 away.</source>
        <translation>De %1 en línea recta al primer punto, que puede estar a %2.</translation>
    </message>
    <message>
        <source>The tool is so far outside the box that no first point can be in it. Move the tool, or change the box.</source>
        <translation>La herramienta está tan lejos del volumen que ningún primer punto puede estar dentro. Mover la herramienta o cambiar el volumen.</translation>
    </message>
    <message>
        <source>Read as</source>
        <translation>Leído como</translation>
    </message>
    <message>
        <source>a program for %1</source>
        <translation>un programa para %1</translation>
    </message>
    <message>
        <source>mm, because this machine is metric; the program does not say (%1)</source>
        <translation>mm, porque esta máquina es métrica; el programa no lo dice (%1)</translation>
    </message>
    <message>
        <source>inch where the program does not say it, as chosen</source>
        <translation>pulgadas donde el programa no lo dice, como se eligió</translation>
    </message>
    <message>
        <source>mm where the program does not say it, as chosen</source>
        <translation>mm donde el programa no lo dice, como se eligió</translation>
    </message>
    <message>
        <source>whole units where a number has no decimal point (%1)</source>
        <translation>unidades enteras donde un número no tiene punto decimal (%1)</translation>
    </message>
    <message>
        <source>thousandths where a number has no decimal point, as chosen</source>
        <translation>milésimas donde un número no tiene punto decimal, como se eligió</translation>
    </message>
    <message>
        <source>whole units where a number has no decimal point, as chosen</source>
        <translation>unidades enteras donde un número no tiene punto decimal, como se eligió</translation>
    </message>
    <message>
        <source>%1: the control executes %2</source>
        <translation>%1: el control ejecuta %2</translation>
    </message>
    <message>
        <source>%1: left out, because nobody has said what this machine does for it (Configure, Limits)</source>
        <translation>%1: se omite, porque nadie ha dicho qué hace esta máquina para ella (Configurar, Límites)</translation>
    </message>
    <message>
        <source>%1: left out</source>
        <translation>%1: se omite</translation>
    </message>
    <message>
        <source>without %1, which does not change the path, as confirmed</source>
        <translation>sin %1, que no cambia la trayectoria, como se confirmó</translation>
    </message>
    <message>
        <source>what it leaves out as a virtual machine is set (%1)</source>
        <translation>lo que omite según los ajustes de una máquina virtual (%1)</translation>
    </message>
    <message>
        <source>what it leaves out as chosen (%1)</source>
        <translation>lo que omite según lo elegido (%1)</translation>
    </message>
    <message>
        <source>M functions and axes of another machine</source>
        <translation>Funciones M y ejes de otra máquina</translation>
    </message>
    <message numerus="yes">
        <source>%1 (line %2, %Ln times)</source>
        <translation>
            <numerusform>%1 (línea %2, una vez)</numerusform>
            <numerusform>%1 (línea %2, %Ln veces)</numerusform>
        </translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>The axes stand at once, on the path. How long they brake is not known.</source>
        <translation>Los ejes se paran de inmediato, en la trayectoria. No se sabe cuánto tardan en frenar.</translation>
    </message>
    <message>
        <source>The axes stand on the path within %1; threads and tapping at their end.</source>
        <translation>Los ejes se paran en la trayectoria en %1 como máximo; las roscas y los roscados, al final.</translation>
    </message>
    <message>
        <source>Every block is within the travel of the axes and the speed of the spindle. Tools are not compared: this machine has no tool table here.</source>
        <translation>Cada bloque está dentro del recorrido de los ejes y de la velocidad del cabezal. Las herramientas no se comparan: esta máquina no tiene aquí tabla de herramientas.</translation>
    </message>
    <message>
        <source>The program uses tool %1; there is none in the spindle.</source>
        <translation>El programa usa la herramienta %1; no hay ninguna en el cabezal.</translation>
    </message>
    <message>
        <source>The program uses tool %1; %2 is in the spindle.</source>
        <translation>El programa usa la herramienta %1; en el cabezal está %2.</translation>
    </message>
    <message>
        <source>The program works in %1; %2 is active.</source>
        <translation>El programa trabaja en %1; está activo %2.</translation>
    </message>
    <message>
        <source>stands</source>
        <translation>está parado</translation>
    </message>
    <message>
        <source>turns at %1 1/min, %2</source>
        <translation>gira a %1 1/min, %2</translation>
    </message>
    <message>
        <source>clockwise (M3)</source>
        <translation>a la derecha (M3)</translation>
    </message>
    <message>
        <source>counterclockwise (M4)</source>
        <translation>a la izquierda (M4)</translation>
    </message>
    <message>
        <source>In the program the spindle %1; now it %2.</source>
        <translation>En el programa el cabezal %1; ahora %2.</translation>
    </message>
    <message>
        <source>Confirmed: it starts like this.</source>
        <translation>Confirmado: se inicia así.</translation>
    </message>
    <message>
        <source>Start like this</source>
        <translation>Iniciar así</translation>
    </message>
    <message>
        <source>Then in a straight line over %1 to %2.</source>
        <translation>Después en línea recta, %1, hasta %2.</translation>
    </message>
    <message>
        <source>This way passes within what the program cuts, which reaches up to Z %1.</source>
        <translation>Este camino pasa por la zona que el programa mecaniza, que llega hasta Z %1.</translation>
    </message>
    <message>
        <source>Raise the tool …</source>
        <translation>Levantar la herramienta …</translation>
    </message>
    <message>
        <source>Bring the tool to a place from which it is clear.</source>
        <translation>Lleve la herramienta a un lugar desde el que esté libre.</translation>
    </message>
    <message>
        <source>Straight way</source>
        <translation>Camino recto</translation>
    </message>
    <message>
        <source>Confirmed: nothing is in the way of the first move.</source>
        <translation>Confirmado: nada estorba el primer movimiento.</translation>
    </message>
    <message>
        <source>If nothing is in the way of the first move, confirm it.</source>
        <translation>Si nada estorba el primer movimiento, confírmelo.</translation>
    </message>
    <message>
        <source>It is clear …</source>
        <translation>Está libre …</translation>
    </message>
    <message>
        <source>Raise the tool</source>
        <translation>Levantar la herramienta</translation>
    </message>
    <message>
        <source>The tool goes straight up by %1 to Z %2, at %3. Nothing else moves. Then this page comes again.</source>
        <translation>La herramienta sube en línea recta %1 hasta Z %2, a %3. No se mueve nada más. Después vuelve esta página.</translation>
    </message>
    <message>
        <source>After Stop the control still executes its window, of at most %1 moves within the agreed box, and of at most %2: longer moves are divided.</source>
        <translation>Después de Parada el control ejecuta aún su ventana: como máximo %1 movimientos dentro de la caja acordada, que juntos duran como máximo %2. Los movimientos más largos se dividen.</translation>
    </message>
    <message>
        <source>After Stop the control still executes its window, at most %1 in %2.</source>
        <translation>Después de Parada el control ejecuta aún su ventana, como máximo %1 en %2.</translation>
    </message>
    <message>
        <source>The move of line %1 alone takes %2; it is not divided.</source>
        <translation>El movimiento de la línea %1 dura por sí solo %2; no se divide.</translation>
    </message>
    <message>
        <source>Method %1 may execute old points again: if this computer is late for a moment, the tool goes back through the workpiece, and nothing stops it before it has moved. Method window does not.</source>
        <translation>El método %1 puede ejecutar otra vez puntos antiguos: si este ordenador se retrasa un momento, la herramienta vuelve atrás a través de la pieza, y nada la detiene antes de que se haya movido. El método Ventana no lo hace.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Confirmed.</source>
        <translation>Confirmado.</translation>
    </message>
    <message>
        <source>Accept it …</source>
        <translation>Aceptarlo …</translation>
    </message>
    <message>
        <source>Since it was measured how fast this control can be written to, its software has changed: %1 for each R-parameter are assumed.</source>
        <translation>Desde que se midió la rapidez con que se puede escribir en este control, su software ha cambiado: se suponen %1 por parámetro R.</translation>
    </message>
    <message>
        <source>It has not been measured how fast this control can be written to: %1 for each R-parameter are assumed.</source>
        <translation>No se ha medido con qué rapidez se puede escribir en este control: se suponen %1 por parámetro R.</translation>
    </message>
    <message>
        <source>Measure …</source>
        <translation>Medir …</translation>
    </message>
    <message>
        <source>Back along the path</source>
        <translation>Atrás por la trayectoria</translation>
    </message>
    <message>
        <source>The tool goes back by %1 along the path that it has cut, at %2, to %3. Then this page comes again, and the run goes on from there.</source>
        <translation>La herramienta retrocede %1 por la trayectoria que ha cortado, a %2, hasta %3. Después vuelve esta página y la ejecución sigue desde allí.</translation>
    </message>
    <message>
        <source>Drive back …</source>
        <translation>Retroceder …</translation>
    </message>
    <message>
        <source>The first move, to line %1, alone takes %2: bring the tool nearer before the start.</source>
        <translation>El primer movimiento, hasta la línea %1, dura por sí solo %2: acercar la herramienta antes del inicio.</translation>
    </message>
    <message>
        <source>%1 multiplies your override: %2 to %3, and no more than 120 % in all.</source>
        <translation>%1 multiplica su override: de %2 a %3, y no más del 120&#xa0;% en total.</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Avance adaptativo</translation>
    </message>
    <message>
        <source>Without a factor for %1 the axes are held; nothing moves before the first.</source>
        <translation>Sin un factor durante %1 los ejes quedan retenidos; antes del primero no se mueve nada.</translation>
    </message>
    <message>
        <source>Without a factor for %1 your override acts alone.</source>
        <translation>Sin un factor durante %1 actúa solo su override.</translation>
    </message>
    <message>
        <source>With this method, after Stop the control still executes its loop, at most %1 in %2.</source>
        <translation>Con este método, después de Parada el control ejecuta aún su bucle, como máximo %1 en %2.</translation>
    </message>
    <message>
        <source>Within the tolerance %1 of %2 points are left, at most %3 off the program.</source>
        <translation>Dentro de la tolerancia quedan %1 de %2 puntos, como máximo a %3 del programa.</translation>
    </message>
    <message>
        <source>All points are streamed: a whole job has no tolerance.</source>
        <translation>Se transmiten todos los puntos: un trabajo completo no tiene tolerancia.</translation>
    </message>
    <message>
        <source>All points are streamed: fewer cannot be kept within the tolerance.</source>
        <translation>Se transmiten todos los puntos: con menos no se puede mantener la tolerancia.</translation>
    </message>
    <message>
        <source>The path is being measured.</source>
        <translation>Se está midiendo la trayectoria.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::RunController</name>
    <message>
        <source>Stop requested.</source>
        <translation>Parada solicitada.</translation>
    </message>
    <message>
        <source>Continue requested.</source>
        <translation>Continuación solicitada.</translation>
    </message>
    <message>
        <source>Calibration on R%1 to R%2 started.</source>
        <translation>Iniciada la calibración en R%1 a R%2.</translation>
    </message>
    <message>
        <source>The run was left before point %1 of %2.</source>
        <translation>La ejecución se interrumpió antes del punto %1 de %2.</translation>
    </message>
    <message>
        <source>Press Resume first: it asks the control where the run was left.</source>
        <translation>Pulsar primero Reanudar: así se pregunta al control dónde se interrumpió la ejecución.</translation>
    </message>
    <message>
        <source>The run resumes at point %1.</source>
        <translation>La ejecución se reanuda en el punto %1.</translation>
    </message>
    <message>
        <source>Start. The tool first moves %1 in a straight line to the first point.</source>
        <translation>Inicio. La herramienta recorre primero %1 en línea recta hasta el primer punto.</translation>
    </message>
    <message>
        <source>Save the template on its page as %1, copy it to the part programs of the control, select it in channel 1 and press cycle start. The axes move only after the template has shown its layout number %2.</source>
        <translation>Guardar la plantilla desde su página como %1, copiarla a los programas de pieza del control, seleccionarla en el canal 1 y pulsar Marcha CN. Los ejes se mueven solo después de que la plantilla haya mostrado su número de disposición %2.</translation>
    </message>
    <message>
        <source>Access: %1.</source>
        <translation>Acceso: %1.</translation>
    </message>
    <message>
        <source>Run ended: %1 of %2 points executed.</source>
        <translation>Ejecución terminada: %1 de %2 puntos ejecutados.</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Grabación: %1</translation>
    </message>
    <message>
        <source>The run has executed wrong points: see the report, and check the workpiece.</source>
        <translation>La ejecución ha hecho puntos erróneos: ver el informe y comprobar la pieza.</translation>
    </message>
    <message>
        <source>The run is not in the history: %1</source>
        <translation>La ejecución no está en el historial: %1</translation>
    </message>
    <message>
        <source>Wrong motion: after point %1 the tool is %2 off the path.</source>
        <translation>Movimiento erróneo: después del punto %1, la herramienta está a %2 de la trayectoria.</translation>
    </message>
    <message>
        <source>Wrong motion: the control has repeated points after point %1.</source>
        <translation>Movimiento erróneo: el control ha repetido puntos después del punto %1.</translation>
    </message>
    <message>
        <source>The program waits for cycle start at the control (line %1).</source>
        <translation>El programa espera Marcha CN en el control (línea %1).</translation>
    </message>
    <message numerus="yes">
        <source>Start of a whole job: %1, %Ln blocks for the control.</source>
        <translation>
            <numerusform>Inicio de un trabajo completo: %1, %Ln secuencia para el control.</numerusform>
            <numerusform>Inicio de un trabajo completo: %1, %Ln secuencias para el control.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln parts</source>
        <translation>
            <numerusform>%Ln tramo</numerusform>
            <numerusform>%Ln tramos</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1 and those after it move nothing. Choose an earlier line.</source>
        <translation>La línea %1 y las siguientes no mueven nada. Elegir una línea anterior.</translation>
    </message>
    <message>
        <source>The run starts at point %1.</source>
        <translation>La ejecución empieza en el punto %1.</translation>
    </message>
    <message>
        <source>A whole job begins at its beginning, or with a part: press Start, then Begin with a part. To begin at this line, choose Motion only in the settings, and set tool, spindle and coolant yourself.</source>
        <translation>Un trabajo completo empieza por su principio o por un tramo: pulse Inicio y después Empezar por un tramo. Para empezar en esta línea, elija Solo movimiento en los ajustes y ajuste usted mismo herramienta, cabezal y refrigerante.</translation>
    </message>
    <message numerus="yes">
        <source>The job goes on at line %1, after %Ln blocks of the control.</source>
        <translation>
            <numerusform>El trabajo continúa en la línea %1, tras %Ln secuencia del control.</numerusform>
            <numerusform>El trabajo continúa en la línea %1, tras %Ln secuencias del control.</numerusform>
        </translation>
    </message>
    <message>
        <source>The tools and offsets of this machine are not known, so the state in which the job goes on cannot be computed. Start from the beginning.</source>
        <translation>No se conocen las herramientas ni los decalajes de esta máquina, por lo que no se puede calcular el estado en que continúa el trabajo. Empiece desde el principio.</translation>
    </message>
    <message>
        <source>The state before this part is not known: only the control knows what an earlier block does. Choose an earlier part, or start from the beginning.</source>
        <translation>No se conoce el estado antes de este tramo: solo el control sabe qué hace una secuencia anterior. Elija un tramo anterior o empiece desde el principio.</translation>
    </message>
    <message>
        <source>It is not known for certain where the job was left. Press Start, then Begin with a part, or start from the beginning.</source>
        <translation>No se sabe con certeza dónde se dejó el trabajo. Pulse Inicio y después Empezar por un tramo, o empiece desde el principio.</translation>
    </message>
    <message>
        <source>Start. The points come from %1.</source>
        <translation>Inicio. Los puntos llegan de %1.</translation>
    </message>
    <message>
        <source>Rivulet cannot stop what the control executes now. Press NC STOP at the machine.</source>
        <translation>Rivulet no puede parar lo que el control ejecuta ahora. Pulse NC STOP en la máquina.</translation>
    </message>
    <message>
        <source>Stop: the axes are held on the path.</source>
        <translation>Parada: los ejes quedan retenidos en la trayectoria.</translation>
    </message>
    <message>
        <source>Pause requested.</source>
        <translation>Pausa solicitada.</translation>
    </message>
    <message>
        <source>The tool is raised to Z %1.</source>
        <translation>La herramienta sube a Z %1.</translation>
    </message>
    <message>
        <source>The state before the first part is not known: only the control knows what an earlier block does. Start from the beginning.</source>
        <translation>No se conoce el estado antes del primer tramo: solo el control sabe qué hace una secuencia anterior. Empiece desde el principio.</translation>
    </message>
    <message>
        <source>The test of the control is aborted. If an axis still moves, press NC STOP at the machine.</source>
        <translation>La prueba del control se ha interrumpido. Si todavía se mueve un eje, pulse NC STOP en la máquina.</translation>
    </message>
    <message>
        <source>The control was reset: its program has ended after %1.</source>
        <translation>El control se ha reiniciado: su programa ha terminado al cabo de %1.</translation>
    </message>
    <message>
        <source>A reset of the control was requested. If an axis still moves, press NC STOP at the machine.</source>
        <translation>Se ha solicitado un reset del control. Si todavía se mueve un eje, pulse NC STOP en la máquina.</translation>
    </message>
    <message>
        <source>The file of the run is gone: the run could not go on after the way back.</source>
        <translation>El archivo de la ejecución ya no existe: tras el retroceso la ejecución no podría seguir.</translation>
    </message>
    <message>
        <source>The tool is driven back by %1 along the path.</source>
        <translation>La herramienta retrocede %1 por la trayectoria.</translation>
    </message>
    <message>
        <source>The tool is to be lifted by %1.</source>
        <translation>La herramienta debe elevarse %1.</translation>
    </message>
    <message>
        <source>The tool is to be lowered.</source>
        <translation>La herramienta debe bajar.</translation>
    </message>
    <message>
        <source>Line %1: &quot;%2&quot; has not been tried on this machine. Test it on the page Job test, or run the motion only.</source>
        <translation>Línea %1: «%2» no se ha probado en esta máquina. Probarlo en la página Prueba trabajo, o ejecutar solo el movimiento.</translation>
    </message>
</context>
<context>
    <name>rivulet::hmi::VirtualMachine</name>
    <message>
        <source>The virtual machine cannot be started: %1</source>
        <translation>No se puede iniciar la máquina virtual: %1</translation>
    </message>
    <message>
        <source>The virtual machine has ended.</source>
        <translation>La máquina virtual ha terminado.</translation>
    </message>
    <message>
        <source>The program rivulet-machine is missing. Install it beside this window.</source>
        <translation>Falta el programa rivulet-machine. Instálelo junto a esta ventana.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AdvicePanel</name>
    <message>
        <source>F %1 instead of %2: still without wrong points</source>
        <translation>F %1 en lugar de %2: aún sin puntos erróneos</translation>
    </message>
    <message>
        <source>F %1 instead of %2: without waiting</source>
        <translation>F %1 en lugar de %2: sin esperas</translation>
    </message>
    <message>
        <source>F %1 instead of %2: feasible</source>
        <translation>F %1 en lugar de %2: viable</translation>
    </message>
    <message>
        <source>N %1 instead of %2: largest feed %3</source>
        <translation>N %1 en lugar de %2: avance máximo %3</translation>
    </message>
    <message>
        <source>δ %1 instead of %2: largest feed %3</source>
        <translation>δ %1 en lugar de %2: avance máximo %3</translation>
    </message>
    <message>
        <source>Method %1 instead of %2: largest feed %3</source>
        <translation>Método %1 en lugar de %2: avance máximo %3</translation>
    </message>
    <message>
        <source>Judging …</source>
        <translation>Evaluando…</translation>
    </message>
    <message>
        <source>No verdict</source>
        <translation>Sin veredicto</translation>
    </message>
    <message>
        <source>Not feasible: largest feed %1</source>
        <translation>No viable: avance máximo %1</translation>
    </message>
    <message>
        <source>Safe, with waiting above %1</source>
        <translation>Seguro, con esperas por encima de %1</translation>
    </message>
    <message>
        <source>By the equations feasible up to %1</source>
        <translation>Según las ecuaciones, viable hasta %1</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Looking for better settings …</source>
        <translation>Buscando mejores ajustes…</translation>
    </message>
    <message>
        <source>No single change makes this program much faster.</source>
        <translation>Ningún cambio por sí solo hace este programa mucho más rápido.</translation>
    </message>
    <message>
        <source>Each was simulated with this program and made no wrong point.</source>
        <translation>Cada uno se simuló con este programa, sin puntos erróneos.</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>Consejos</translation>
    </message>
    <message>
        <source>Try</source>
        <translation>Probar</translation>
    </message>
    <message>
        <source>Points per loop N</source>
        <translation>Puntos por bucle N</translation>
    </message>
    <message>
        <source>Distance δ</source>
        <translation>Distancia δ</translation>
    </message>
    <message>
        <source>Feed F</source>
        <translation>Avance F</translation>
    </message>
    <message>
        <source>Override %1 instead of %2: still without wrong points</source>
        <translation>Override %1 en lugar de %2: aún sin puntos erróneos</translation>
    </message>
    <message>
        <source>Override %1 instead of %2: without waiting</source>
        <translation>Override %1 en lugar de %2: sin esperas</translation>
    </message>
    <message>
        <source>N %1 instead of %2: largest override %3</source>
        <translation>N %1 en lugar de %2: override máximo %3</translation>
    </message>
    <message>
        <source>Safe, with waiting above an override of %1</source>
        <translation>Seguro, con esperas por encima de un override de %1</translation>
    </message>
    <message>
        <source>By the equations without waiting up to %1</source>
        <translation>Según las ecuaciones, sin esperas hasta %1</translation>
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
        <translation>Hora</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Suceso</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Por</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmLine</name>
    <message>
        <source>Ack</source>
        <translation>Acusar</translation>
    </message>
    <message>
        <source>Acknowledge: you have seen this alarm</source>
        <translation>Acusar: usted ha visto esta alarma</translation>
    </message>
    <message>
        <source>Acknowledge the alarm</source>
        <translation>Acusar la alarma</translation>
    </message>
    <message>
        <source>Show all alarms</source>
        <translation>Mostrar todas las alarmas</translation>
    </message>
    <message>
        <source>Dismiss the message</source>
        <translation>Cerrar el aviso</translation>
    </message>
    <message>
        <source>Alarms: %1. Show all</source>
        <translation>Alarmas: %1. Mostrar todas</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmModel</name>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Veces</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AlarmPage</name>
    <message>
        <source>There is no alarm.</source>
        <translation>No hay ninguna alarma.</translation>
    </message>
    <message>
        <source>shelved by %1 until %2</source>
        <translation>aplazada por %1 hasta %2</translation>
    </message>
    <message>
        <source>Alarms (%1)</source>
        <translation>Alarmas (%1)</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Causa</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Remedio</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Acusar</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Acusar todas</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>Aplazar</translation>
    </message>
    <message>
        <source>Put the alarm aside for a time. It stays in this list.</source>
        <translation>Deja la alarma a un lado por un tiempo. Sigue en esta lista.</translation>
    </message>
    <message>
        <source>Show it again</source>
        <translation>Volver a mostrar</translation>
    </message>
    <message numerus="yes">
        <source>For %n minutes</source>
        <translation>
            <numerusform>Durante %n minuto</numerusform>
            <numerusform>Durante %n minutos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>For %n hours</source>
        <translation>
            <numerusform>Durante %n hora</numerusform>
            <numerusform>Durante %n horas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AuditModel</name>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Quién</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::AuditPage</name>
    <message>
        <source>Export the audit trail</source>
        <translation>Exportar el registro de auditoría</translation>
    </message>
    <message>
        <source>No audit trail is kept.</source>
        <translation>Sin registro de auditoría.</translation>
    </message>
    <message>
        <source>The audit trail was changed: line %1 was edited, or lines before it were inserted or removed.</source>
        <translation>El registro de auditoría ha sido modificado: la línea %1 se cambió, o se insertaron o borraron líneas antes de ella.</translation>
    </message>
    <message>
        <source>Unchanged: every line follows from the one before it.</source>
        <translation>Intacto: cada línea se deduce de la anterior.</translation>
    </message>
    <message>
        <source>Cut by a loss of power: %1.</source>
        <translation>Cortado por un corte de corriente: %1.</translation>
    </message>
    <message>
        <source>Last hash: %1 …</source>
        <translation>Último hash: %1…</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Export as CSV…</source>
        <translation>Exportar como CSV…</translation>
    </message>
    <message>
        <source>Export as JSON…</source>
        <translation>Exportar como JSON…</translation>
    </message>
    <message>
        <source>Audit</source>
        <translation>Auditoría</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::BackDialog</name>
    <message>
        <source>To where the last rapid ended</source>
        <translation>Hasta el final del último avance rápido</translation>
    </message>
    <message>
        <source>Back along the path</source>
        <translation>Atrás por la trayectoria</translation>
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
        <translation>Mostrar el recorrido</translation>
    </message>
    <message>
        <source>Length of the way</source>
        <translation>Longitud del recorrido</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Ahora no</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::BoardCard</name>
    <message>
        <source>Remove …</source>
        <translation>Quitar…</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
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
        <translation>Mediciones de cada tipo</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Como máximo</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>No program, cycle or other client uses R%1 to R%2: they may be written</source>
        <translation>Ningún programa, ciclo u otro cliente usa R%1 a R%2: se pueden escribir</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Calibrar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Rectas</translation>
    </message>
    <message>
        <source>Spread (times in ms)</source>
        <translation>Dispersión (tiempos en ms)</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>faltan %1</translation>
    </message>
    <message>
        <source>Testing the forms of access …</source>
        <translation>Probando las formas de acceso…</translation>
    </message>
    <message>
        <source>First request of each kind …</source>
        <translation>Primera petición de cada tipo…</translation>
    </message>
    <message>
        <source>%1 of %2 shots, %3</source>
        <translation>%1 de %2 mediciones, %3</translation>
    </message>
    <message>
        <source>Takes about %1.</source>
        <translation>Tarda unos %1.</translation>
    </message>
    <message>
        <source>%1, %2, R%3 to R%4, took %5</source>
        <translation>%1, %2, R%3 a R%4, duró %5</translation>
    </message>
    <message>
        <source>Outdated, not used: the server now has another version. %1</source>
        <translation>Obsoleta, no se utiliza: el servidor tiene ahora otra versión. %1</translation>
    </message>
    <message>
        <source>Calibrated: %1.</source>
        <translation>Calibrado: %1.</translation>
    </message>
    <message>
        <source>There was not enough time for all shots: reduced numbers are bold in the table.</source>
        <translation>No hubo tiempo para todas las mediciones: los números reducidos están en negrita en la tabla.</translation>
    </message>
    <message>
        <source>Restoring the R-parameters …</source>
        <translation>Restableciendo los parámetros R …</translation>
    </message>
    <message>
        <source>The last R-parameter is before the first.</source>
        <translation>El último parámetro R está antes del primero.</translation>
    </message>
    <message>
        <source>Confirm the R-parameters to begin.</source>
        <translation>Confirmar los parámetros R para empezar.</translation>
    </message>
    <message>
        <source>This machine is not calibrated: %1 for each R-parameter are assumed.</source>
        <translation>Esta máquina no está calibrada: se suponen %1 por parámetro R.</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parámetros R</translation>
    </message>
    <message>
        <source>Arrays too: for the test, they hold other values for a moment</source>
        <translation>También matrices: para la prueba tienen otros valores por un momento</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CellModel</name>
    <message>
        <source>Role</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parámetros R</translation>
    </message>
    <message>
        <source>Point %1: %2</source>
        <translation>Punto %1: %2</translation>
    </message>
    <message>
        <source>Client</source>
        <translation>Cliente</translation>
    </message>
    <message>
        <source>NC</source>
        <translation>CN</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Marcha</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>Layout number</source>
        <translation>Número de disposición</translation>
    </message>
    <message>
        <source>Writer</source>
        <translation>Escribe</translation>
    </message>
    <message>
        <source>Client, NC</source>
        <translation>Cliente, CN</translation>
    </message>
    <message>
        <source>Feed (mm/min)</source>
        <translation>Avance (mm/min)</translation>
    </message>
    <message>
        <source>Window %1: points</source>
        <translation>Ventana %1: puntos</translation>
    </message>
    <message>
        <source>Window %1: feed (mm/min)</source>
        <translation>Ventana %1: avance (mm/min)</translation>
    </message>
    <message>
        <source>Window %1: check number</source>
        <translation>Ventana %1: número de comprobación</translation>
    </message>
    <message>
        <source>Window %1 point %2: %3</source>
        <translation>Ventana %1 punto %2: %3</translation>
    </message>
    <message>
        <source>Windows delivered</source>
        <translation>Ventanas entregadas</translation>
    </message>
    <message>
        <source>Windows taken</source>
        <translation>Ventanas tomadas</translation>
    </message>
    <message>
        <source>Windows executed</source>
        <translation>Ventanas ejecutadas</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Number of the run</source>
        <translation>Número de la ejecución</translation>
    </message>
    <message>
        <source>Run obeyed</source>
        <translation>Ejecución atendida</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Señal de vida</translation>
    </message>
    <message>
        <source>Online correction: %1</source>
        <translation>Corrección en línea: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CertificatesPage</name>
    <message>
        <source>Save this computer&apos;s certificate</source>
        <translation>Guardar el certificado de este ordenador</translation>
    </message>
    <message>
        <source>A certificate is being made …</source>
        <translation>Se está creando un certificado…</translation>
    </message>
    <message>
        <source>There is none yet. It is made when it is first needed.</source>
        <translation>Aún no hay ninguno. Se crea cuando hace falta.</translation>
    </message>
    <message>
        <source>It has ended (%1). Renew it.</source>
        <translation>Ha caducado (%1). Renovarlo.</translation>
    </message>
    <message numerus="yes">
        <source>Valid for %Ln more days (%1)</source>
        <translation>
            <numerusform>Válido %Ln día más (%1)</numerusform>
            <numerusform>Válido %Ln días más (%1)</numerusform>
        </translation>
    </message>
    <message>
        <source>Encryption by %1</source>
        <translation>Cifrado por %1</translation>
    </message>
    <message>
        <source>Certificate of this computer</source>
        <translation>Certificado de este ordenador</translation>
    </message>
    <message>
        <source>Fingerprint (SHA-256)</source>
        <translation>Huella (SHA-256)</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Writes the certificate, without its key, for the control&apos;s list of trusted clients.</source>
        <translation>Escribe el certificado, sin su clave, para la lista de clientes de confianza del control.</translation>
    </message>
    <message>
        <source>Hold: renew</source>
        <translation>Mantener: renovar</translation>
    </message>
    <message>
        <source>Makes a new one. Every control has to trust it anew.</source>
        <translation>Crea uno nuevo. Cada control debe volver a confiar en él.</translation>
    </message>
    <message>
        <source>Machines that are known</source>
        <translation>Máquinas conocidas</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Olvidar</translation>
    </message>
    <message>
        <source>At the next connection the machine is new.</source>
        <translation>En la próxima conexión la máquina es nueva.</translation>
    </message>
    <message>
        <source>Protect again</source>
        <translation>Volver a proteger</translation>
    </message>
    <message>
        <source>Withdraws what was allowed for this machine: from then on, the strongest encryption or no connection.</source>
        <translation>Retira lo que se permitió por su nombre: el cifrado más fuerte o ninguna conexión.</translation>
    </message>
    <message>
        <source>Certificates that were refused</source>
        <translation>Certificados rechazados</translation>
    </message>
    <message>
        <source>Hold: accept</source>
        <translation>Mantener: aceptar</translation>
    </message>
    <message>
        <source>From then on it is trusted at its address, in place of any other one.</source>
        <translation>Desde entonces se confía en él en su dirección, en lugar de cualquier otro.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Removes it from the list. It stays refused.</source>
        <translation>Lo quita de la lista. Sigue rechazado.</translation>
    </message>
    <message>
        <source>Only the very certificates that were accepted are trusted, not who issued them. So revocation lists are not needed: forget the machine instead.</source>
        <translation>Solo se confía en los certificados aceptados, no en quien los emitió. Por eso no hacen falta listas de revocación: basta con olvidar la máquina.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CloseBar</name>
    <message>
        <source>Keep the window open</source>
        <translation>Dejar la ventana abierta</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Parar y cerrar</translation>
    </message>
    <message>
        <source>A run is in progress. To close the window, its axes are held first, where they are; the run can be resumed from there.</source>
        <translation>Hay una ejecución en curso. Para cerrar la ventana, primero se detienen sus ejes donde están; la ejecución se puede reanudar desde allí.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ColumnsDialog</name>
    <message>
        <source>The trace can be analysed.</source>
        <translation>La traza se puede analizar.</translation>
    </message>
    <message>
        <source>Without a position the columns are shown, but stops and errors are not looked for.</source>
        <translation>Sin posición se muestran las columnas, pero no se buscan paradas ni errores.</translation>
    </message>
    <message>
        <source>Unit of the numbers in the file</source>
        <translation>Unidad de los números del archivo</translation>
    </message>
    <message>
        <source>Unit of %1</source>
        <translation>Unidad de %1</translation>
    </message>
    <message>
        <source>What this column is; without a meaning it is shown as it is</source>
        <translation>Qué es esta columna; sin significado se muestra tal cual</translation>
    </message>
    <message>
        <source>Meaning of %1</source>
        <translation>Significado de %1</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Place of the first sample on the time axis that several files share</source>
        <translation>Lugar de la primera muestra en el eje de tiempo común a varios archivos</translation>
    </message>
    <message>
        <source>First sample at</source>
        <translation>Primera muestra en</translation>
    </message>
    <message>
        <source>For a table without a column of time</source>
        <translation>Para una tabla sin columna de tiempo</translation>
    </message>
    <message>
        <source>First values</source>
        <translation>Primeros valores</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Means</source>
        <translation>Significado</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Columna</translation>
    </message>
    <message>
        <source>Columns of the file</source>
        <translation>Columnas del archivo</translation>
    </message>
    <message>
        <source>What do the columns mean? The answer is kept for all files with the same headings.</source>
        <translation>¿Qué significan las columnas? La respuesta se conserva para todos los archivos con los mismos encabezados.</translation>
    </message>
    <message>
        <source>Columns of %1</source>
        <translation>Columnas de %1</translation>
    </message>
    <message>
        <source>Samples per second</source>
        <translation>Muestras por segundo</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CommissioningPage</name>
    <message>
        <source>First R-parameter</source>
        <translation>Primer parámetro R</translation>
    </message>
    <message>
        <source>First R-parameter of the test</source>
        <translation>Primer parámetro R de la prueba</translation>
    </message>
    <message>
        <source>Nobody else uses R%1 to R%2</source>
        <translation>Nadie más usa R%1 a R%2</translation>
    </message>
    <message>
        <source>I bring the program to the control myself</source>
        <translation>Transfiero yo mismo el programa al control</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Iniciar la prueba</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Test program</source>
        <translation>Programa de prueba</translation>
    </message>
    <message>
        <source>1. Bring the channel to reset, in AUTO.</source>
        <translation>1. Poner el canal en Reset, en AUTO.</translation>
    </message>
    <message>
        <source>2. Store the text below as part program %1 and select it.</source>
        <translation>2. Guardar el texto de abajo como programa de pieza %1 y seleccionarlo.</translation>
    </message>
    <message>
        <source>2. The program %1 is transferred, read back and selected.</source>
        <translation>2. El programa %1 se transfiere, se relee y se selecciona.</translation>
    </message>
    <message>
        <source>3. Press cycle start at the control (a virtual machine starts by itself).</source>
        <translation>3. Pulsar Marcha CN en el control (una máquina virtual arranca sola).</translation>
    </message>
    <message>
        <source>Waiting for cycle start</source>
        <translation>Esperando Marcha CN</translation>
    </message>
    <message>
        <source>The test is in progress</source>
        <translation>La prueba está en curso</translation>
    </message>
    <message>
        <source>Tested with another version of the server: test it again</source>
        <translation>Probado con otra versión del servidor: repetir la prueba</translation>
    </message>
    <message>
        <source>Confirm the R-parameters first.</source>
        <translation>Confirmar primero los parámetros R.</translation>
    </message>
    <message>
        <source>Way of the axis, mm</source>
        <translation>Recorrido del eje, mm</translation>
    </message>
    <message>
        <source>Feed of the axis, mm/min</source>
        <translation>Avance del eje, mm/min</translation>
    </message>
    <message>
        <source>by, mm</source>
        <translation>en, mm</translation>
    </message>
    <message>
        <source>F, mm/min</source>
        <translation>F, mm/min</translation>
    </message>
    <message>
        <source>Clear the way of the axis, then type %1.</source>
        <translation>Despeje el camino del eje y escriba %1.</translation>
    </message>
    <message>
        <source>Nothing is in its way: %1</source>
        <translation>Nada está en su camino: %1</translation>
    </message>
    <message>
        <source>Waiting for cycle start, once more</source>
        <translation>Esperando Marcha CN otra vez</translation>
    </message>
    <message>
        <source>%1, %2, tested %3; %4</source>
        <translation>%1, %2, probado el %3; %4</translation>
    </message>
    <message>
        <source>An axis moves in the air</source>
        <translation>Un eje se mueve en el aire</translation>
    </message>
    <message>
        <source>Axis that moves</source>
        <translation>Eje que se mueve</translation>
    </message>
    <message>
        <source>Confirm that the axis may move</source>
        <translation>Confirmar que el eje puede moverse</translation>
    </message>
    <message>
        <source>Lift of the tool, mm</source>
        <translation>Elevación de la herramienta, mm</translation>
    </message>
    <message>
        <source>While the axis is held, the tool is lifted along Z by so much and comes back; 0: it is not lifted. A run may lift the tool only after that. Not with Z as the axis.</source>
        <translation>Mientras el eje está detenido, la herramienta se eleva esta distancia a lo largo de Z y vuelve; 0: no se eleva. Solo después una ejecución puede elevar la herramienta. No con Z como eje.</translation>
    </message>
    <message>
        <source>lift, mm</source>
        <translation>elevación, mm</translation>
    </message>
    <message>
        <source>One block a line, as a program has it: S500 M3, M8, T1 M6</source>
        <translation>Un bloque por línea, como en un programa: S500 M3, M8, T1 M6</translation>
    </message>
    <message>
        <source>Blocks to be tried</source>
        <translation>Bloques que probar</translation>
    </message>
    <message>
        <source>2. The programs of the job are transferred, read back and selected.</source>
        <translation>2. Los programas del trabajo se transfieren, se vuelven a leer y se seleccionan.</translation>
    </message>
    <message>
        <source>the control shows nothing of it; not released</source>
        <translation>el control no muestra nada de ello; no habilitado</translation>
    </message>
    <message>
        <source>seen by the operator</source>
        <translation>visto por el operador</translation>
    </message>
    <message>
        <source>I have seen it</source>
        <translation>Lo he visto</translation>
    </message>
    <message>
        <source>Blocks to be tried, one a line: S500 M3</source>
        <translation>Bloques que probar, uno por línea: S500 M3</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ComparePanel</name>
    <message>
        <source>Open two traces or more to compare them.</source>
        <translation>Abrir dos registros o más para compararlos.</translation>
    </message>
    <message>
        <source>Comparing …</source>
        <translation>Comparando …</translation>
    </message>
    <message>
        <source>Each run has the length that it moved itself. With their NC program open, the runs are compared at the same places of the program.</source>
        <translation>Cada ejecución tiene la longitud que ella misma recorrió. Con el programa NC abierto, las ejecuciones se comparan en los mismos lugares del programa.</translation>
    </message>
    <message>
        <source>Differences from %1</source>
        <translation>Diferencias respecto a %1</translation>
    </message>
    <message>
        <source>%1
%2 minus %3: largest %4 at %5, mean %6, RMS %7</source>
        <translation>%1
%2 menos %3: máxima %4 en %5, media %6, RMS %7</translation>
    </message>
    <message>
        <source>Compare at the same</source>
        <translation>Comparar por</translation>
    </message>
    <message>
        <source>Axis of the comparison</source>
        <translation>Eje de la comparación</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>length of path</source>
        <translation>longitud del recorrido</translation>
    </message>
    <message>
        <source>point of the program</source>
        <translation>punto del programa</translation>
    </message>
    <message>
        <source>Show the differences as curves</source>
        <translation>Mostrar las diferencias como curvas</translation>
    </message>
    <message>
        <source>Each pane shows the other traces minus the first one</source>
        <translation>Cada panel muestra lo que los otros registros tienen de más que el primero</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Diferencias</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Máxima</translation>
    </message>
    <message>
        <source>At</source>
        <translation>En</translation>
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
        <translation>Conexión</translation>
    </message>
    <message>
        <source>OPC UA endpoint</source>
        <translation>Dirección OPC UA</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Channel</source>
        <translation>Canal</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Selected</source>
        <translation>Seleccionado</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarma</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conectar</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Desconectar</translation>
    </message>
    <message>
        <source>Virtual machine: no real axis moves</source>
        <translation>Máquina virtual: no se mueve ningún eje real</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Activo</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Interrumpido</translation>
    </message>
    <message>
        <source>Unknown (%1)</source>
        <translation>Desconocido (%1)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ControlFields</name>
    <message>
        <source>Map of the control</source>
        <translation>Mapa del control</translation>
    </message>
    <message>
        <source>Maps (*.toml)</source>
        <translation>Mapas (*.toml)</translation>
    </message>
    <message>
        <source>The control is no SINUMERIK</source>
        <translation>El control no es un SINUMERIK</translation>
    </message>
    <message>
        <source>File with the map (.toml). It is remembered for this machine.</source>
        <translation>Archivo con el mapa (.toml). Se recuerda para esta máquina.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Biblioteca</translation>
    </message>
    <message>
        <source>Which library connects with the machine. Qt OPC UA is slower, does not encrypt, and takes no map and no user.</source>
        <translation>Qué biblioteca conecta con la máquina. Qt OPC UA es más lento, no cifra y no admite ni mapa ni usuario.</translation>
    </message>
    <message>
        <source>A map says under which names this control has its memory, axes and states. rivulet-cli map proposes one.</source>
        <translation>Un mapa dice con qué nombres tiene este control su memoria, ejes y estados. rivulet-cli map propone uno.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::CorrectionPanel</name>
    <message>
        <source>UDP port %1 cannot be opened: choose another.</source>
        <translation>No se puede abrir el puerto UDP %1: elegir otro.</translation>
    </message>
    <message>
        <source>Up to ±%1 per axis, during a run.</source>
        <translation>Hasta ±%1 por eje, durante una ejecución.</translation>
    </message>
    <message>
        <source>By hand, up to ±%1 per axis.</source>
        <translation>A mano, hasta ±%1 por eje.</translation>
    </message>
    <message>
        <source>The source is silent: its last value is held.</source>
        <translation>La fuente no envía nada: se mantiene su último valor.</translation>
    </message>
    <message>
        <source>Nothing has been received from the source yet.</source>
        <translation>Aún no se ha recibido nada de la fuente.</translation>
    </message>
    <message>
        <source>Receiving from the source. Lines that are not corrections: %1</source>
        <translation>Recibiendo de la fuente. Líneas que no son correcciones: %1</translation>
    </message>
    <message>
        <source>Receiving from the source.</source>
        <translation>Recibiendo de la fuente.</translation>
    </message>
    <message>
        <source>Online correction</source>
        <translation>Corrección en línea</translation>
    </message>
    <message>
        <source>confirmed by the control</source>
        <translation>confirmada por el control</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Cero</translation>
    </message>
    <message>
        <source>Set the correction of all axes to zero, then continue by hand</source>
        <translation>Poner a cero la corrección de todos los ejes y seguir a mano</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Fuente</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>A mano</translation>
    </message>
    <message>
        <source>UDP on this computer</source>
        <translation>UDP en este ordenador</translation>
    </message>
    <message>
        <source>Datagrams to 127.0.0.1 with lines like X 0.01 Y -0.02, in mm</source>
        <translation>Datagramas a 127.0.0.1 con líneas como X 0.01 Y -0.02, en mm</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>Silent after</source>
        <translation>Sin señal tras</translation>
    </message>
    <message>
        <source>Correction of %1</source>
        <translation>Corrección de %1</translation>
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
        <translation>Un clic en una curva coloca el cursor A, con Mayús el cursor B.</translation>
    </message>
    <message>
        <source>The trace has no such place.</source>
        <translation>El registro no tiene ese lugar.</translation>
    </message>
    <message>
        <source>Type a number.</source>
        <translation>Introducir un número.</translation>
    </message>
    <message>
        <source>At the cursors and between them</source>
        <translation>En los cursores y entre ellos</translation>
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
        <translation>Pendiente, 1/s</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>95 % below</source>
        <translation>95&#xa0;% debajo</translation>
    </message>
    <message>
        <source>99 % below</source>
        <translation>99&#xa0;% debajo</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Muestras</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Ir a</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Number of the place to go to</source>
        <translation>Número del lugar</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Ir</translation>
    </message>
    <message>
        <source>Slope, 1/mm</source>
        <translation>Pendiente, 1/mm</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Pendiente</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DescribedMachineBox</name>
    <message>
        <source>Described by the server</source>
        <translation>Descrita por el servidor</translation>
    </message>
    <message>
        <source>What the server says of its machine by OPC 40001-1 (Machinery) and OPC 40501-1 (Machine Tools). It is read every 10 s, and not while a run is in progress.</source>
        <translation>Lo que el servidor dice de su máquina según OPC 40001-1 (Machinery) y OPC 40501-1 (Machine Tools). Se lee cada 10 s, pero no durante una ejecución.</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Manufacturer</source>
        <translation>Fabricante</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Número de serie</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>%1 (first of %2)</source>
        <translation>%1 (primera de %2)</translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation>%1 de %2 ejecuciones</translation>
    </message>
    <message>
        <source>runs completed: %1</source>
        <translation>ejecuciones terminadas: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DiagnosticModel</name>
    <message>
        <source>Severity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Columna</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Observación</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::DistanceChart</name>
    <message>
        <source>%1 … %2: %3 distances</source>
        <translation>%1 … %2: %3 distancias</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::EmulatorPage</name>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Uso</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Comprobar</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Aprender</translation>
    </message>
    <message>
        <source>NC program</source>
        <translation>Programa CN</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>no hace falta</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Samples per s</source>
        <translation>Valores por s</translation>
    </message>
    <message>
        <source>Largest feed</source>
        <translation>Avance máximo</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parámetro</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Intervalo</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>Meaning</source>
        <translation>Significado</translation>
    </message>
    <message>
        <source>Position RMS, µm</source>
        <translation>Posición RMS, µm</translation>
    </message>
    <message>
        <source>at most, µm</source>
        <translation>como máximo, µm</translation>
    </message>
    <message>
        <source>Contour RMS, µm</source>
        <translation>Contorno RMS, µm</translation>
    </message>
    <message>
        <source>emulated, µm</source>
        <translation>emulado, µm</translation>
    </message>
    <message>
        <source>Speed, %</source>
        <translation>Velocidad,&#xa0;%</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>Archivo…</translation>
    </message>
    <message>
        <source>Add recordings</source>
        <translation>Añadir grabaciones</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Todos los archivos</translation>
    </message>
    <message>
        <source>NC program of %1</source>
        <translation>Programa CN de %1</translation>
    </message>
    <message>
        <source>Preset of the machine</source>
        <translation>Preajuste de la máquina</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preajustes</translation>
    </message>
    <message>
        <source>Save as preset</source>
        <translation>Guardar como preajuste</translation>
    </message>
    <message>
        <source>Use to learn</source>
        <translation>Para aprender</translation>
    </message>
    <message>
        <source>Use to test</source>
        <translation>Para comprobar</translation>
    </message>
    <message>
        <source>Nothing is learned yet.</source>
        <translation>Aún no se ha aprendido nada.</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Leyendo %1…</translation>
    </message>
    <message>
        <source>%1 has no set points: choose its NC program.</source>
        <translation>%1 no tiene consignas: elegir su programa CN.</translation>
    </message>
    <message>
        <source>Record a few programs with different feeds, corners and reversals, and add the recordings here.</source>
        <translation>Grabar algunos programas con distintos avances, esquinas e inversiones, y añadir aquí las grabaciones.</translation>
    </message>
    <message>
        <source>All recordings are used to test: use one to learn.</source>
        <translation>Todas las grabaciones son para comprobar: usar una para aprender.</translation>
    </message>
    <message>
        <source>Learning axis %1: %2 of %3 models tried, the best is right within %4.</source>
        <translation>Aprende el eje %1: probados %2 de %3 modelos, el mejor acierta dentro de %4.</translation>
    </message>
    <message>
        <source>Learning …</source>
        <translation>Aprendiendo…</translation>
    </message>
    <message>
        <source>Saved as %1. Give it to the virtual machine as its preset.</source>
        <translation>Guardado como %1. Darlo a la máquina virtual como preajuste.</translation>
    </message>
    <message>
        <source>Learned and tested. Save it as a preset to use it.</source>
        <translation>Aprendido y comprobado. Guardarlo como preajuste para usarlo.</translation>
    </message>
    <message>
        <source>Ready to learn. Recordings used to test show how good the emulator is on programs it has not seen.</source>
        <translation>Listo para aprender. Las grabaciones para comprobar muestran cómo acierta el emulador en programas que no ha visto.</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Añadir…</translation>
    </message>
    <message>
        <source>Add recordings of the machine</source>
        <translation>Añadir grabaciones de la máquina</translation>
    </message>
    <message>
        <source>Learn from the recordings how the axes follow their set points</source>
        <translation>Aprender de las grabaciones cómo siguen los ejes sus consignas</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stop learning; what was learned before stays</source>
        <translation>Detener el aprendizaje; queda lo aprendido antes</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Save the emulator as a preset of the virtual machine</source>
        <translation>Guardar el emulador como preajuste de la máquina virtual</translation>
    </message>
    <message>
        <source>NC program…</source>
        <translation>Programa CN…</translation>
    </message>
    <message>
        <source>The program that ran: needed for a recording without set points</source>
        <translation>Lo que se ejecutó: necesario para una grabación sin consignas</translation>
    </message>
    <message>
        <source>A recording used to test is not learned from</source>
        <translation>De una grabación usada para comprobar no se aprende</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Takes the recording from the list; the file stays</source>
        <translation>Quita la grabación de la lista; el archivo queda</translation>
    </message>
    <message>
        <source>Bode and step plots</source>
        <translation>Bode y respuesta al escalón</translation>
    </message>
    <message>
        <source>For those who know control engineering</source>
        <translation>Para quien conoce la regulación automática</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>What recordings do not say</source>
        <translation>Lo que las grabaciones no dicen</translation>
    </message>
    <message>
        <source>Preset that has the limits of the machine; set points of programs are planned with them</source>
        <translation>Preajuste con los límites de la máquina; con ellos se planifican las consignas de los programas</translation>
    </message>
    <message>
        <source>Models tried</source>
        <translation>Modelos probados</translation>
    </message>
    <message>
        <source>Error, µm</source>
        <translation>Error, µm</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Grabaciones</translation>
    </message>
    <message>
        <source>Enter changes the use of a recording</source>
        <translation>Intro cambia el uso de una grabación</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Tests</source>
        <translation>Comprobaciones</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparación</translation>
    </message>
    <message>
        <source>Part of the page</source>
        <translation>Parte de la página</translation>
    </message>
    <message>
        <source>How far an emulator is off that was learned from one recording alone.</source>
        <translation>Cuánto se desvía un emulador aprendido de una sola grabación.</translation>
    </message>
    <message>
        <source>Learns from each recording alone and tests on all others. So you see which recordings teach most, and what each parameter is worth.</source>
        <translation>Aprende de cada grabación por separado y comprueba con todas las demás. Así se ve qué grabaciones enseñan más y cuánto vale cada parámetro.</translation>
    </message>
    <message>
        <source>How much the positions would change on each recording if a parameter were 10 % larger.</source>
        <translation>Cuánto cambiarían las posiciones en cada grabación si un parámetro fuera un 10&#xa0;% mayor.</translation>
    </message>
    <message>
        <source>Learning from each recording alone …</source>
        <translation>Aprendiendo de cada grabación por separado…</translation>
    </message>
    <message>
        <source>Compare recordings</source>
        <translation>Comparar grabaciones</translation>
    </message>
    <message>
        <source>Takes at most as long as learning, for each recording</source>
        <translation>Tarda como máximo lo que el aprendizaje, por cada grabación</translation>
    </message>
    <message>
        <source>Matrix of errors</source>
        <translation>Matriz de errores</translation>
    </message>
    <message>
        <source>Tested on</source>
        <translation>Comprobado con</translation>
    </message>
    <message>
        <source>Learned from (error RMS in µm)</source>
        <translation>Aprendido de (error RMS en µm)</translation>
    </message>
    <message>
        <source>Worth of the parameters</source>
        <translation>Valor de los parámetros</translation>
    </message>
    <message>
        <source>Change of the positions, RMS, µm</source>
        <translation>Cambio de las posiciones, RMS, µm</translation>
    </message>
    <message>
        <source>Matrix</source>
        <translation>Matriz</translation>
    </message>
    <message>
        <source>On parts that were held out while learning (RMS): %1. A recording used to test was not learned from at all.</source>
        <translation>En partes reservadas al aprender (RMS): %1. De una grabación usada para comprobar no se aprendió nada.</translation>
    </message>
    <message>
        <source>Error on parts held out, while learning</source>
        <translation>Error en las partes reservadas, al aprender</translation>
    </message>
    <message>
        <source>none: what the model leaves is not chance</source>
        <translation>ninguno: lo que deja el modelo no es azar</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FactorPanel</name>
    <message>
        <source>Source</source>
        <translation>Fuente</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Como mínimo</translation>
    </message>
    <message>
        <source>Smallest factor of your override that may act</source>
        <translation>El menor factor de su override que puede actuar</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Como máximo</translation>
    </message>
    <message>
        <source>Largest factor that may act; together with your override no more than 120 % of the programmed feed</source>
        <translation>El mayor factor que puede actuar; junto con su override no más del 120&#xa0;% del avance programado</translation>
    </message>
    <message>
        <source>Silent after</source>
        <translation>Sin señal tras</translation>
    </message>
    <message>
        <source>Without a factor</source>
        <translation>Sin un factor</translation>
    </message>
    <message>
        <source>Before the first one, when the source is silent or closed, and when it sends what was not agreed</source>
        <translation>Antes del primero, cuando la fuente calla o está cerrada, y cuando envía lo que no estaba acordado</translation>
    </message>
    <message>
        <source>Your override acts alone.</source>
        <translation>Actúa solo su override.</translation>
    </message>
    <message>
        <source>It is read from the start on. Nothing moves before its first factor.</source>
        <translation>Se lee a partir del inicio. Antes de su primer factor no se mueve nada.</translation>
    </message>
    <message>
        <source>It is read from the start on.</source>
        <translation>Se lee a partir del inicio.</translation>
    </message>
    <message>
        <source>Adaptive feed</source>
        <translation>Avance adaptativo</translation>
    </message>
    <message>
        <source>A sensor or script that sends lines such as feed 0.85: 85 % of your override, until the next one. Pause and Stop always act.</source>
        <translation>Un sensor o un script que envía líneas como feed 0.85: 85&#xa0;% de su override, hasta la siguiente. Pausa y Parada actúan siempre.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>TCP on this computer</source>
        <translation>TCP en este ordenador</translation>
    </message>
    <message>
        <source>UDP on this computer</source>
        <translation>UDP en este ordenador</translation>
    </message>
    <message>
        <source>Hold the axes</source>
        <translation>Retener los ejes</translation>
    </message>
    <message>
        <source>Your override alone</source>
        <translation>Solo su override</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FeasibilityPage</name>
    <message>
        <source>F over d_min</source>
        <translation>F según d_min</translation>
    </message>
    <message>
        <source>F over N</source>
        <translation>F según N</translation>
    </message>
    <message>
        <source>F over δ</source>
        <translation>F según δ</translation>
    </message>
    <message>
        <source>Load a program to see where it can be streamed.</source>
        <translation>Cargar un programa para ver dónde se puede transmitir.</translation>
    </message>
    <message>
        <source>Drag the ring to change the feed.</source>
        <translation>Arrastrar el anillo para cambiar el avance.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the feed. Method position does not depend on N.</source>
        <translation>Arrastrar el anillo para cambiar N y el avance. El método Posición no depende de N.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the feed.</source>
        <translation>Arrastrar el anillo para cambiar N y el avance.</translation>
    </message>
    <message>
        <source>Drag the ring to change δ and the feed.</source>
        <translation>Arrastrar el anillo para cambiar δ y el avance.</translation>
    </message>
    <message>
        <source>Operating point</source>
        <translation>Punto de trabajo</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Viable</translation>
    </message>
    <message>
        <source>Safety band</source>
        <translation>Banda de seguridad</translation>
    </message>
    <message>
        <source>(1) point distance</source>
        <translation>(1) distancia entre puntos</translation>
    </message>
    <message>
        <source>(2) distance δ</source>
        <translation>(2) distancia δ</translation>
    </message>
    <message>
        <source>(3) half a loop</source>
        <translation>(3) medio bucle</translation>
    </message>
    <message>
        <source>(3) half a loop, for information</source>
        <translation>(3) medio bucle, informativo</translation>
    </message>
    <message>
        <source>(3ᴺ) half a loop, real path</source>
        <translation>(3ᴺ) medio bucle, trayectoria real</translation>
    </message>
    <message>
        <source>dashed: as published</source>
        <translation>a trazos: tal como se publicó</translation>
    </message>
    <message>
        <source>Smallest distances of the program</source>
        <translation>Distancias mínimas del programa</translation>
    </message>
    <message>
        <source>Simulate around the operating point</source>
        <translation>Simular en torno al punto de trabajo</translation>
    </message>
    <message>
        <source>Simulating: %p %</source>
        <translation>Simulando: %p %</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Simulated on the virtual machine, %1 points around the tightest place.</source>
        <translation>Simulado en la máquina virtual, %1 puntos en torno al lugar más crítico.</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Funciona</translation>
    </message>
    <message>
        <source>Sometimes fails</source>
        <translation>Falla a veces</translation>
    </message>
    <message>
        <source>Always fails</source>
        <translation>Falla siempre</translation>
    </message>
    <message>
        <source>Model: 0.1 % to 50 % fail</source>
        <translation>Cálculo: falla del 0,1&#xa0;% al 50&#xa0;%</translation>
    </message>
    <message>
        <source>This method does not use δ: the limits do not depend on it.</source>
        <translation>Este método no utiliza δ: los límites no dependen de él.</translation>
    </message>
    <message>
        <source>Without waiting</source>
        <translation>Sin esperas</translation>
    </message>
    <message>
        <source>reach: the client keeps up</source>
        <translation>alcance: el cliente mantiene el ritmo</translation>
    </message>
    <message>
        <source>Runs failed in the simulation</source>
        <translation>Fallos en la simulación</translation>
    </message>
    <message>
        <source>Override over t_min</source>
        <translation>Override según t_min</translation>
    </message>
    <message>
        <source>Override over N</source>
        <translation>Override según N</translation>
    </message>
    <message>
        <source>Override over δ</source>
        <translation>Override según δ</translation>
    </message>
    <message>
        <source>Drag the ring to change the override on the feeds of the program.</source>
        <translation>Arrastrar el anillo para cambiar el override sobre los avances del programa.</translation>
    </message>
    <message>
        <source>Drag the ring to change N and the override.</source>
        <translation>Arrastrar el anillo para cambiar N y el override.</translation>
    </message>
    <message>
        <source>Largest override: %1.</source>
        <translation>Override máximo: %1.</translation>
    </message>
    <message>
        <source>Shortest moves of the program</source>
        <translation>Movimientos más cortos del programa</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FileBanner</name>
    <message>
        <source>The file %1 has changed.</source>
        <translation>El archivo %1 ha cambiado.</translation>
    </message>
    <message>
        <source>The file %1 is no longer there.</source>
        <translation>El archivo %1 ya no está.</translation>
    </message>
    <message>
        <source>The run keeps version %1.</source>
        <translation>La ejecución conserva la versión %1.</translation>
    </message>
    <message>
        <source>Reload it?</source>
        <translation>¿Recargarlo?</translation>
    </message>
    <message>
        <source>Version %1 stays loaded.</source>
        <translation>La versión %1 sigue cargada.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FileField</name>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Choose the file: %1</source>
        <translation>Elegir el archivo: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::FitModel</name>
    <message>
        <source>write</source>
        <translation>escritura</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lectura</translation>
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
        <translation>Acceso</translation>
    </message>
    <message>
        <source>Per request (a)</source>
        <translation>Por petición (a)</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Desviación</translation>
    </message>
    <message>
        <source>Per R-parameter (b)</source>
        <translation>Por parámetro R (b)</translation>
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
        <translation>Se puede reanudar en el ordenador donde se inició.</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Observar</translation>
    </message>
    <message>
        <source>Shows program, position and progress. Nothing is changed.</source>
        <translation>Muestra programa, posición y progreso. No se cambia nada.</translation>
    </message>
    <message>
        <source>Stop the run</source>
        <translation>Parar la ejecución</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Reanudar…</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Ahora no</translation>
    </message>
    <message>
        <source>The axes stand at once, whoever started the run.</source>
        <translation>Los ejes se paran de inmediato, sin importar quién inició la ejecución.</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Terminar aquí</translation>
    </message>
    <message>
        <source>The axes go on to the end of the window, or of the block of the control, and the program ends there.</source>
        <translation>Los ejes siguen hasta el final de la ventana, o del bloque del control, y allí termina el programa.</translation>
    </message>
    <message>
        <source>Stop requested: still moving, at most %1, about %2</source>
        <translation>Parada solicitada: aún en movimiento, como máximo %1, unos %2</translation>
    </message>
    <message>
        <source>Stop requested, not yet confirmed</source>
        <translation>Parada solicitada, aún sin confirmar</translation>
    </message>
    <message>
        <source>Loads the program, compares it and asks the control where the run was left. Nothing moves yet.</source>
        <translation>Carga el programa, lo compara y pregunta al control dónde se interrumpió la ejecución. Todavía no se mueve nada.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::HelpPage</name>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manual</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::HistogramChart</name>
    <message>
        <source>Duration, ms</source>
        <translation>Duración, ms</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>write</source>
        <translation>escritura</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lectura</translation>
    </message>
    <message>
        <source>%1 %: %2</source>
        <translation>%1&#xa0;%: %2</translation>
    </message>
    <message>
        <source>%1 beyond, the longest %2</source>
        <translation>%1 por encima, la más larga %2</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LayoutMenu</name>
    <message>
        <source>No layout is kept yet</source>
        <translation>Todavía no se guarda ninguna disposición</translation>
    </message>
    <message>
        <source>Keep the present panes as…</source>
        <translation>Guardar los paneles actuales como…</translation>
    </message>
    <message>
        <source>New traces are shown in</source>
        <translation>Los registros nuevos se muestran en</translation>
    </message>
    <message>
        <source>the usual panes</source>
        <translation>los paneles habituales</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Keep the panes</source>
        <translation>Guardar los paneles</translation>
    </message>
    <message>
        <source>Name of the layout; one of the same name is replaced</source>
        <translation>Nombre de la disposición; una con el mismo nombre se reemplaza</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LinesChart</name>
    <message>
        <source>Duration, ms</source>
        <translation>Duración, ms</translation>
    </message>
    <message>
        <source>write</source>
        <translation>escritura</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lectura</translation>
    </message>
    <message>
        <source>R-parameters of the request</source>
        <translation>Parámetros R de la petición</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LiveDialog</name>
    <message>
        <source>Live points</source>
        <translation>Puntos en vivo</translation>
    </message>
    <message>
        <source>A program or script computes the path while the machine moves and sends its points as lines, such as X1.5 Y2 F500. Nothing moves that is outside what is agreed here.</source>
        <translation>Un programa o script calcula la trayectoria mientras la máquina se mueve y envía sus puntos como líneas, por ejemplo X1.5 Y2 F500. Nada se mueve fuera de lo acordado aquí.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Listens from now on. Nothing moves before the start.</source>
        <translation>Escucha desde ahora. Nada se mueve antes del inicio.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Fuente</translation>
    </message>
    <message>
        <source>TCP port of this computer</source>
        <translation>Puerto TCP de este ordenador</translation>
    </message>
    <message>
        <source>UDP port of this computer</source>
        <translation>Puerto UDP de este ordenador</translation>
    </message>
    <message>
        <source>UNIX socket</source>
        <translation>Socket UNIX</translation>
    </message>
    <message>
        <source>Standard input of this window</source>
        <translation>Entrada estándar de esta ventana</translation>
    </message>
    <message>
        <source>0: any that is free</source>
        <translation>0: uno libre</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Puerto</translation>
    </message>
    <message>
        <source>File name of the socket, which only this user can write to</source>
        <translation>Nombre de archivo del socket, en el que solo puede escribir este usuario</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Ruta</translation>
    </message>
    <message>
        <source>Box of all points</source>
        <translation>Volumen de todos los puntos</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>a</translation>
    </message>
    <message>
        <source>Least coordinate, workpiece frame</source>
        <translation>Coordenada mínima, sistema de la pieza</translation>
    </message>
    <message>
        <source>Largest coordinate, workpiece frame</source>
        <translation>Coordenada máxima, sistema de la pieza</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 de</translation>
    </message>
    <message>
        <source>%1 to</source>
        <translation>%1 a</translation>
    </message>
    <message>
        <source>Agreed with the source</source>
        <translation>Acordado con la fuente</translation>
    </message>
    <message>
        <source>First point within</source>
        <translation>Primer punto a menos de</translation>
    </message>
    <message>
        <source>Largest distance of the first point from the tool</source>
        <translation>Distancia máxima del primer punto a la herramienta</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Paso máximo</translation>
    </message>
    <message>
        <source>Largest distance of two points</source>
        <translation>Distancia máxima entre dos puntos</translation>
    </message>
    <message>
        <source>Largest F</source>
        <translation>F máxima</translation>
    </message>
    <message>
        <source>It is also the feed of points before the first F.</source>
        <translation>Es también el avance de los puntos antes de la primera F.</translation>
    </message>
    <message>
        <source>Merge below</source>
        <translation>Unir por debajo de</translation>
    </message>
    <message>
        <source>Points that are closer are merged with the one before.</source>
        <translation>Los puntos más cercanos se unen al anterior.</translation>
    </message>
    <message>
        <source>Largest turn</source>
        <translation>Giro máximo</translation>
    </message>
    <message>
        <source>Largest turn of a rotary axis between two points</source>
        <translation>Giro máximo de un eje rotativo entre dos puntos</translation>
    </message>
    <message>
        <source>Points may turn this axis (method window).</source>
        <translation>Los puntos pueden girar este eje (método Ventana).</translation>
    </message>
    <message>
        <source>Rotary axis %1</source>
        <translation>Eje rotativo %1</translation>
    </message>
    <message>
        <source>Rotary axes</source>
        <translation>Ejes rotativos</translation>
    </message>
    <message>
        <source>When no points come</source>
        <translation>Cuando no llegan puntos</translation>
    </message>
    <message>
        <source>Window within</source>
        <translation>Ventana en</translation>
    </message>
    <message>
        <source>A window that is not full is sent after this time.</source>
        <translation>Una ventana que no está llena se envía tras este tiempo.</translation>
    </message>
    <message>
        <source>Hold after</source>
        <translation>Suspender tras</translation>
    </message>
    <message>
        <source>After this much silence the run holds; it goes on with the next point.</source>
        <translation>Tras este silencio la ejecución se suspende; continúa con el punto siguiente.</translation>
    </message>
    <message>
        <source>End after</source>
        <translation>Terminar tras</translation>
    </message>
    <message>
        <source>After this much silence the run ends with an error.</source>
        <translation>Tras este silencio la ejecución termina con un error.</translation>
    </message>
    <message>
        <source>Variables of an OPC UA server</source>
        <translation>Variables de un servidor OPC UA</translation>
    </message>
    <message>
        <source>To ports and sockets, only programs on this computer can send.</source>
        <translation>Solo los programas de este ordenador pueden enviar a puertos y sockets.</translation>
    </message>
    <message>
        <source>This file names the server and its variables (TOML).</source>
        <translation>Este archivo indica el servidor y sus variables (TOML).</translation>
    </message>
    <message>
        <source>File of the source</source>
        <translation>Archivo de la fuente</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Elegir …</translation>
    </message>
    <message>
        <source>Choose the file of the source</source>
        <translation>Elegir el archivo de la fuente</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>Sources (*.toml);;All files (*)</source>
        <translation>Fuentes (*.toml);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Around the tool</source>
        <translation>Alrededor de la herramienta</translation>
    </message>
    <message>
        <source>Puts a box of this size around the place where the tool stands.</source>
        <translation>Pone una caja de este tamaño alrededor del lugar donde está la herramienta.</translation>
    </message>
    <message>
        <source>Where the tool stands is not known.</source>
        <translation>No se sabe dónde está la herramienta.</translation>
    </message>
    <message>
        <source>The tool stands at %1.</source>
        <translation>La herramienta está en %1.</translation>
    </message>
    <message>
        <source>The tool stands at %1, so far outside that no first point can be in the box.</source>
        <translation>La herramienta está en %1, tan fuera que ningún primer punto puede estar en la caja.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LivePanel</name>
    <message>
        <source>It is read as soon as the control runs the program.</source>
        <translation>Se lee en cuanto el control ejecuta el programa.</translation>
    </message>
    <message>
        <source>The run has ended. It listens for the next one.</source>
        <translation>La ejecución ha terminado. La fuente espera la siguiente.</translation>
    </message>
    <message>
        <source>Listening. Nothing is read before the start.</source>
        <translation>A la escucha. No se lee nada antes del inicio.</translation>
    </message>
    <message>
        <source>Waiting for the first line, for %1</source>
        <translation>Espera la primera línea desde hace %1</translation>
    </message>
    <message>
        <source>Receiving</source>
        <translation>Recibiendo</translation>
    </message>
    <message>
        <source>Silent for %1; %2</source>
        <translation>En silencio desde hace %1; %2</translation>
    </message>
    <message>
        <source>Ended by the source</source>
        <translation>Terminado por la fuente</translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 de %2 puntos</translation>
    </message>
    <message>
        <source>%1 /s</source>
        <translation>%1 /s</translation>
    </message>
    <message>
        <source>Live points …</source>
        <translation>Puntos en vivo…</translation>
    </message>
    <message>
        <source>Another source, or something else agreed with it</source>
        <translation>Otra fuente u otro acuerdo con ella</translation>
    </message>
    <message>
        <source>Open program …</source>
        <translation>Abrir programa…</translation>
    </message>
    <message>
        <source>A program takes the place of the live source.</source>
        <translation>Un programa ocupa el lugar de la fuente en vivo.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Agreed with the source</source>
        <translation>Acordado con la fuente</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Búfer</translation>
    </message>
    <message>
        <source>Points that have arrived and are not executed. When it is full, the source is made to wait.</source>
        <translation>Puntos que han llegado y no se han ejecutado. Cuando está lleno, la fuente tiene que esperar.</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Out</source>
        <translation>Salida</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Aceptados</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ejecutados</translation>
    </message>
    <message>
        <source>Merged</source>
        <translation>Unidos</translation>
    </message>
    <message>
        <source>Delay, median</source>
        <translation>Retardo, mediana</translation>
    </message>
    <message>
        <source>Delay, 99 %</source>
        <translation>Retardo, 99&#xa0;%</translation>
    </message>
    <message>
        <source>In theory</source>
        <translation>En teoría</translation>
    </message>
    <message>
        <source>Points from the source, mean of the last two seconds</source>
        <translation>Puntos de la fuente, media de los dos últimos segundos</translation>
    </message>
    <message>
        <source>Points executed, mean of the last two seconds</source>
        <translation>Puntos ejecutados, media de los dos últimos segundos</translation>
    </message>
    <message>
        <source>Points of the source within the agreed limits</source>
        <translation>Puntos de la fuente que cumplen lo acordado</translation>
    </message>
    <message>
        <source>Points that are known to be executed</source>
        <translation>Puntos cuya ejecución es conocida</translation>
    </message>
    <message>
        <source>Points too close to the one before, which are left out</source>
        <translation>Puntos demasiado cercanos al anterior, que se omiten</translation>
    </message>
    <message>
        <source>From the arrival of a point to the beginning of its move; during a run, of the last 500 points</source>
        <translation>De la llegada de un punto al comienzo de su movimiento; durante una ejecución, de los últimos 500 puntos</translation>
    </message>
    <message>
        <source>Of a hundred points, one was later than this.</source>
        <translation>De cien puntos, uno llegó más tarde.</translation>
    </message>
    <message>
        <source>Least delay, and the delay when all buffers are full</source>
        <translation>Retardo mínimo, y el retardo con todos los búferes llenos</translation>
    </message>
    <message>
        <source>First point within</source>
        <translation>Primer punto a menos de</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Paso máximo</translation>
    </message>
    <message>
        <source>Largest F</source>
        <translation>F máxima</translation>
    </message>
    <message>
        <source>Merge below</source>
        <translation>Unir por debajo de</translation>
    </message>
    <message>
        <source>When it is silent</source>
        <translation>Cuando calla</translation>
    </message>
    <message>
        <source>Send lines such as X1.5 Y2 F500 to 127.0.0.1, port %1. The line “end” ends the run.</source>
        <translation>Enviar líneas como X1.5 Y2 F500 a 127.0.0.1, puerto %1. La línea «end» termina la ejecución.</translation>
    </message>
    <message>
        <source>Send lines such as X1.5 Y2 F500 to it. The line “end” ends the run.</source>
        <translation>Enviarle líneas como X1.5 Y2 F500. La línea «end» termina la ejecución.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LoadBar</name>
    <message>
        <source>Reading %1</source>
        <translation>Leyendo %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogInDialog</name>
    <message>
        <source>Log in</source>
        <translation>Iniciar sesión</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>Delete the last digit</source>
        <translation>Borrar la última cifra</translation>
    </message>
    <message>
        <source>Wrong PIN. Try again in %1 s.</source>
        <translation>PIN incorrecto. Reintentar dentro de %1 s.</translation>
    </message>
    <message>
        <source>Wrong PIN.</source>
        <translation>PIN incorrecto.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogModel</name>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origen</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LogView</name>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Save the messages</source>
        <translation>Guardar los avisos</translation>
    </message>
    <message>
        <source>%1 of %2 messages</source>
        <translation>%1 de %2 avisos</translation>
    </message>
    <message>
        <source>All messages</source>
        <translation>Todos los avisos</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Advertencias y errores</translation>
    </message>
    <message>
        <source>Errors only</source>
        <translation>Solo errores</translation>
    </message>
    <message>
        <source>All sources</source>
        <translation>Todos los orígenes</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Origen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Wrap lines</source>
        <translation>Ajustar líneas</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Avisos</translation>
    </message>
    <message numerus="yes">
        <source>%Ln messages</source>
        <translation>
            <numerusform>%Ln aviso</numerusform>
            <numerusform>%Ln avisos</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::LoginFields</name>
    <message>
        <source>This machine lets nobody in without a user. Type user and password.</source>
        <translation>Esta máquina no deja entrar a nadie sin usuario. Escribir usuario y contraseña.</translation>
    </message>
    <message>
        <source>Type the password of this user.</source>
        <translation>Escribir la contraseña de este usuario.</translation>
    </message>
    <message>
        <source>The machine refuses user or password. Check both. After several wrong ones it locks the user for some time.</source>
        <translation>La máquina rechaza el usuario o la contraseña. Comprobar ambos. Tras varios errores bloquea al usuario durante un tiempo.</translation>
    </message>
    <message>
        <source>There is no keyring on this computer: the password is asked for each time.</source>
        <translation>En este ordenador no hay ningún llavero: la contraseña se pide cada vez.</translation>
    </message>
    <message>
        <source>Log in as a user of the machine</source>
        <translation>Entrar como usuario de la máquina</translation>
    </message>
    <message>
        <source>Without it, the connection is anonymous.</source>
        <translation>Si no, la conexión es anónima.</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Usuario</translation>
    </message>
    <message>
        <source>User of the OPC UA server, as it is set up on the control.</source>
        <translation>Usuario del servidor OPC UA, tal como está configurado en el control.</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Contraseña</translation>
    </message>
    <message>
        <source>It is sent encrypted only, and is in no setting, log or recording.</source>
        <translation>Solo se envía cifrada y no está en ningún ajuste, registro ni grabación.</translation>
    </message>
    <message>
        <source>Keep it in the keyring</source>
        <translation>Guardarla en el llavero</translation>
    </message>
    <message>
        <source>The keyring of this computer&apos;s user keeps it encrypted; it is not asked for again.</source>
        <translation>El llavero del usuario de este ordenador la guarda cifrada; no se vuelve a pedir.</translation>
    </message>
    <message>
        <source>This machine lets nobody in without a user. Choose the user&apos;s certificate.</source>
        <translation>Esta máquina no admite a nadie sin usuario. Elija el certificado del usuario.</translation>
    </message>
    <message>
        <source>The machine refuses this certificate. Register it for a user on the machine, or choose another one.</source>
        <translation>La máquina rechaza este certificado. Regístrelo para un usuario en la máquina o elija otro.</translation>
    </message>
    <message>
        <source>The user is known by</source>
        <translation>El usuario se identifica con</translation>
    </message>
    <message>
        <source>What the machine asks of its users.</source>
        <translation>Lo que la máquina pide a sus usuarios.</translation>
    </message>
    <message>
        <source>name and password</source>
        <translation>nombre y contraseña</translation>
    </message>
    <message>
        <source>a certificate</source>
        <translation>un certificado</translation>
    </message>
    <message>
        <source>Certificate of the user</source>
        <translation>Certificado del usuario</translation>
    </message>
    <message>
        <source>PEM or DER. Register it on the machine first. The name of the file is remembered for this machine.</source>
        <translation>PEM o DER. Regístrelo primero en la máquina. El nombre del archivo se recuerda para esta máquina.</translation>
    </message>
    <message>
        <source>Key, if it is in another file</source>
        <translation>Clave, si está en otro archivo</translation>
    </message>
    <message>
        <source>PEM or DER, not locked by a password; only this computer&apos;s user may read the file (mode 0600). The key is not sent.</source>
        <translation>PEM o DER, no protegida por contraseña; solo el usuario de este ordenador puede leer el archivo (modo 0600). La clave no se envía.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MachineButton</name>
    <message>
        <source>Virtual machine</source>
        <translation>Máquina virtual</translation>
    </message>
    <message>
        <source>%1, silent for %2 s</source>
        <translation>%1, sin respuesta desde hace %2 s</translation>
    </message>
    <message>
        <source>Connection and state of the machine</source>
        <translation>Conexión y estado de la máquina</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MachinesPage</name>
    <message numerus="yes">
        <source>%Ln virtual machines of this computer do not answer any more, and nothing but their runs is kept.</source>
        <translation>
            <numerusform>%Ln máquina virtual de este ordenador ya no responde, y solo se conservan sus ejecuciones.</numerusform>
            <numerusform>%Ln máquinas virtuales de este ordenador ya no responden, y solo se conservan sus ejecuciones.</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide them</source>
        <translation>Ocultar</translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>One machine at a time is connected with a window. Of the others only the port is looked at, every 30 s while this page is shown: a question would cost them time that another stream may need.</source>
        <translation>Una ventana está conectada con una sola máquina a la vez. De las demás solo se comprueba el puerto, cada 30 s mientras se muestra esta página: una pregunta les costaría tiempo que otro flujo puede necesitar.</translation>
    </message>
    <message>
        <source>Puts the service with this address on the board.</source>
        <translation>Pone el servicio de esta dirección en el tablero.</translation>
    </message>
    <message>
        <source>Asks a discovery server of OPC UA for services: that of the address, or of this computer.</source>
        <translation>Pregunta por servicios a un servidor de descubrimiento OPC UA: el de la dirección o el de este ordenador.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Services: machines without a window</source>
        <translation>Servicios: máquinas sin ventana</translation>
    </message>
    <message>
        <source>&amp;Address of a service</source>
        <translation>&amp;Dirección de un servicio</translation>
    </message>
    <message>
        <source>Address of a service</source>
        <translation>Dirección de un servicio</translation>
    </message>
    <message>
        <source>As rivulet-service prints it when it is ready.</source>
        <translation>Como la muestra rivulet-service cuando está listo.</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::MethodPanel</name>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>N (points per loop)</source>
        <translation>N (puntos por bucle)</translation>
    </message>
    <message>
        <source>δ (point reached)</source>
        <translation>δ (punto alcanzado)</translation>
    </message>
    <message>
        <source>F (path feed)</source>
        <translation>F (avance)</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parámetros R</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Veredicto</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Largest feed</source>
        <translation>Avance máximo</translation>
    </message>
    <message>
        <source>Limiting place</source>
        <translation>Lugar más crítico</translation>
    </message>
    <message>
        <source>Distance from the tool at which a point counts as reached</source>
        <translation>Distancia a la herramienta a partir de la cual un punto se da por alcanzado</translation>
    </message>
    <message>
        <source>Equation (1): the tool must not pass a point between two polls.</source>
        <translation>Ecuación (1): la herramienta no debe rebasar ningún punto entre dos lecturas.</translation>
    </message>
    <message>
        <source>Equation (2): the tool must be seen within δ of each point.</source>
        <translation>Ecuación (2): la herramienta debe verse a menos de δ de cada punto.</translation>
    </message>
    <message>
        <source>Equation (3): half a loop must be written before the tool has used it up.</source>
        <translation>Ecuación (3): medio bucle debe estar escrito antes de que la herramienta lo haya consumido.</translation>
    </message>
    <message>
        <source>Equation (3) with the real path: half a loop must be written before the tool has used it up.</source>
        <translation>Ecuación (3) con la trayectoria real: medio bucle debe estar escrito antes de que la herramienta lo haya consumido.</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Sin evaluar</translation>
    </message>
    <message>
        <source>Load a program to get a verdict.</source>
        <translation>Cargar un programa para obtener un veredicto.</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Viable</translation>
    </message>
    <message>
        <source>Not feasible</source>
        <translation>No viable</translation>
    </message>
    <message>
        <source>Closest limit: %1</source>
        <translation>Límite más cercano: %1</translation>
    </message>
    <message>
        <source>Violated: %1</source>
        <translation>Incumplido: %1</translation>
    </message>
    <message>
        <source>%1 × (must exceed 1)</source>
        <translation>%1 × (debe superar 1)</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>lines %1–%2</source>
        <translation>líneas %1–%2</translation>
    </message>
    <message>
        <source>Use δ = %1</source>
        <translation>Usar δ = %1</translation>
    </message>
    <message>
        <source>Use F = %1</source>
        <translation>Usar F = %1</translation>
    </message>
    <message>
        <source>No feed is slow enough: two points of the program nearly coincide.</source>
        <translation>Ningún avance es lo bastante lento: dos puntos del programa casi coinciden.</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
    </message>
    <message>
        <source>With gaps (R11, R21 …)</source>
        <translation>Huecos (R11, R21 …)</translation>
    </message>
    <message>
        <source>In a row (R10 …)</source>
        <translation>Seguidos (R10 …)</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>N (points per window)</source>
        <translation>N (puntos por ventana)</translation>
    </message>
    <message>
        <source>Reach: the next window must be written while the tool executes the current one.</source>
        <translation>Alcance: la ventana siguiente debe estar escrita mientras la herramienta ejecuta la actual.</translation>
    </message>
    <message>
        <source>Largest feed without waiting</source>
        <translation>Avance máximo sin esperas</translation>
    </message>
    <message>
        <source>Safe, with waiting</source>
        <translation>Seguro, con esperas</translation>
    </message>
    <message>
        <source>The machine will wait for points: %1</source>
        <translation>La máquina esperará puntos: %1</translation>
    </message>
    <message>
        <source>%1 × (waits below 1)</source>
        <translation>%1 × (espera por debajo de 1)</translation>
    </message>
    <message>
        <source>Credit (experimental)</source>
        <translation>Crédito (experimental)</translation>
    </message>
    <message>
        <source>Windows have a layout of their own</source>
        <translation>Las ventanas tienen su propia disposición</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Acceso</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automático</translation>
    </message>
    <message>
        <source>Arrays, or no start</source>
        <translation>Matrices, o no se inicia</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>Listas</translation>
    </message>
    <message>
        <source>One by one</source>
        <translation>De una en una</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausas</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Previstas</translation>
    </message>
    <message>
        <source>Places where the axes will stop for a moment. Off the cut means after a rapid or a retract, or at a sharp corner; the path shows the places.</source>
        <translation>Lugares donde los ejes se detendrán un momento. Fuera del corte significa después de un rápido o una retirada, o en una esquina viva; la trayectoria muestra los lugares.</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Tiempo perdido</translation>
    </message>
    <message>
        <source>Standstill, braking and acceleration, computed with the axes of the virtual machine</source>
        <translation>Detención, frenado y aceleración, calculados con los ejes de la máquina virtual</translation>
    </message>
    <message>
        <source>Automatic: before anything moves, the forms of access are tested on the control and the best one is used. The report names it.</source>
        <translation>Automático: antes de que se mueva nada, se prueban en el control las formas de acceso y se usa la mejor. El informe la indica.</translation>
    </message>
    <message>
        <source>Automatic: lists, as this method was published. Arrays need the contiguous layout.</source>
        <translation>Automático: listas, tal como se publicó este método. Las matrices necesitan la disposición contigua.</translation>
    </message>
    <message>
        <source>%1, of them %2 in the cut</source>
        <translation>%1, de ellas %2 en el corte</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calculando…</translation>
    </message>
    <message>
        <source>Correction up to</source>
        <translation>Corrección hasta</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Largest correction of each axis during the run. The control must not add corrections up (MD36750 bit 0), and its own limit (SD43350) should not be larger.</source>
        <translation>Corrección máxima de cada eje durante la ejecución. El control no debe sumar las correcciones (MD36750 bit 0), y su propio límite (SD43350) no debería ser mayor.</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>Plantilla</translation>
    </message>
    <message>
        <source>copied by hand</source>
        <translation>copiada a mano</translation>
    </message>
    <message>
        <source>For a control that gives no right to its part programs: store the template there, select it and press cycle start. The run waits until this is done.</source>
        <translation>Para un control que no da permisos sobre sus programas de pieza: guardar allí la plantilla, seleccionarla y pulsar Marcha CN. La ejecución espera hasta entonces.</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Comprobando…</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Of the program</source>
        <translation>Del programa</translation>
    </message>
    <message>
        <source>One for all moves</source>
        <translation>Avance fijo</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Scales the feeds of the program, and its rapids up to the rapid feed of the machine</source>
        <translation>Actúa sobre los avances del programa y sobre sus rápidos, estos como máximo hasta el rápido de la máquina</translation>
    </message>
    <message>
        <source>This method has one feed for all moves, as it was published</source>
        <translation>Este método tiene un solo avance para todos los movimientos, tal como se publicó</translation>
    </message>
    <message>
        <source>Of the program: each move has the feed of its own block, rapids are rapids. One for all moves: rapids have it, too.</source>
        <translation>Del programa: cada movimiento tiene el avance de su secuencia, los rápidos siguen siendo rápidos. Avance fijo: también vale para los rápidos.</translation>
    </message>
    <message>
        <source>Largest override</source>
        <translation>Override máximo</translation>
    </message>
    <message>
        <source>Use override = %1&#xa0;%</source>
        <translation>Usar override = %1&#xa0;%</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>Whole job</source>
        <translation>Trabajo completo</translation>
    </message>
    <message>
        <source>Motion only</source>
        <translation>Solo movimiento</translation>
    </message>
    <message>
        <source>Dry run</source>
        <translation>Ensayo en vacío</translation>
    </message>
    <message>
        <source>Above the workpiece</source>
        <translation>Sobre la pieza</translation>
    </message>
    <message>
        <source>Whole job: the control executes tools, spindle, coolant, cycles and retracts at their place, and Rivulet streams the motion between them. Motion only: these blocks are left out. Dry run: the whole job above the workpiece, without spindle and coolant.</source>
        <translation>Trabajo completo: el control ejecuta herramientas, cabezal, refrigerante, ciclos y retiradas en su sitio, y Rivulet transmite el movimiento entre ellos. Solo movimiento: estas secuencias se omiten. Ensayo en vacío: el trabajo completo sobre la pieza, sin cabezal ni refrigerante.</translation>
    </message>
    <message>
        <source>The points of a live source have feeds of their own.</source>
        <translation>Los puntos de una fuente en vivo tienen avances propios.</translation>
    </message>
    <message>
        <source>Lift while paused</source>
        <translation>Elevar en pausa</translation>
    </message>
    <message>
        <source>While the axes are held, the tool can be lifted by so much. The control must not add overlays up (MD36750 bit 0), and its limit (SD43350) must not be smaller. Not with a correction or in a whole job; on a real control only after its stop test with a lift.</source>
        <translation>Mientras los ejes están detenidos, la herramienta puede elevarse esta distancia. El control no debe sumar las superposiciones (MD36750 bit 0), y su límite (SD43350) no debe ser menor. No con una corrección ni en un trabajo completo; en un control real solo después de su prueba de parada con elevación.</translation>
    </message>
    <message>
        <source>packed: one R-parameter each</source>
        <translation>compactos: un parámetro R cada uno</translation>
    </message>
    <message>
        <source>All axes of a point share one R-parameter, in steps of 0.001 mm from the first point of its window: a third of the accesses, so faster where the points are dense. A control that calculates otherwise refuses the first window; nothing moves then.</source>
        <translation>Todos los ejes de un punto comparten un parámetro R, en pasos de 0,001 mm desde el primer punto de su ventana: un tercio de los accesos, y por eso más rápido donde los puntos son densos. Un control que calcula de otra forma rechaza la primera ventana; entonces no se mueve nada.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>This method does not use δ: it watches an R-parameter, not the tool</source>
        <translation>Este método no usa δ: vigila un parámetro R, no la herramienta</translation>
    </message>
    <message>
        <source>Window: the machine waits if the client is late; it never executes a point twice. Position: the client watches the tool and replaces points it has passed. Signal: the client watches an R-parameter in which the program says which half of the loop may be replaced. Credit: like window, without a stop between windows; it starts only on a control that has passed the test on the page Credit test.</source>
        <translation>Ventana: la máquina espera si el cliente se retrasa; nunca ejecuta un punto dos veces. Posición: el cliente sigue la herramienta y sustituye los puntos ya rebasados. Señal: el cliente vigila un parámetro R en el que el programa indica qué mitad del bucle se puede sustituir. Crédito: como Ventana, sin parada entre ventanas; solo se inicia en un control que ha superado la prueba de la página Prueba crédito.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Straight moves that stay so near to the path take the place of many short ones (rotary axes: degrees). Corners, feeds and the order of the path stay. Not in whole jobs and live runs.</source>
        <translation>Movimientos rectos que quedan tan cerca de la trayectoria sustituyen a muchos cortos (ejes rotativos: grados). Esquinas, avances y orden de la trayectoria se mantienen. No en trabajos completos ni con puntos en vivo.</translation>
    </message>
    <message>
        <source>Machine: requests and motion of this machine, followed through the program.</source>
        <translation>Máquina: peticiones y movimiento de esta máquina, seguidos a lo largo del programa.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NetCanvas</name>
    <message>
        <source>Only records; holds no tokens.</source>
        <translation>Solo registra, no guarda marcas.</translation>
    </message>
    <message>
        <source>Tokens: %1</source>
        <translation>Marcas: %1</translation>
    </message>
    <message>
        <source>Priority %1</source>
        <translation>Prioridad %1</translation>
    </message>
    <message>
        <source>If %1</source>
        <translation>Si %1</translation>
    </message>
    <message>
        <source>A page of its own: Enter or a double click opens it.</source>
        <translation>Una página propia: Intro o un doble clic la abre.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NetPanel</name>
    <message>
        <source>Place</source>
        <translation>Lugar</translation>
    </message>
    <message>
        <source>Tokens</source>
        <translation>Marcas</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valores</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>There is no net.</source>
        <translation>No hay ninguna red.</translation>
    </message>
    <message>
        <source>%1, fired %2; next: %3</source>
        <translation>%1, disparadas %2; siguiente: %3</translation>
    </message>
    <message>
        <source>%1, fired %2; nothing more is played</source>
        <translation>%1, disparadas %2; no se reproduce más</translation>
    </message>
    <message>
        <source>Click a place or a transition: what it holds or needs is shown here.</source>
        <translation>Hacer clic en un lugar o una transición: aquí aparece lo que contiene o necesita.</translation>
    </message>
    <message>
        <source>Cycle %1 ms</source>
        <translation>Ciclo %1 ms</translation>
    </message>
    <message>
        <source>Cycle of position control; the net begins anew</source>
        <translation>Ciclo del control de posición; la red empieza de nuevo</translation>
    </message>
    <message>
        <source>Task dependency</source>
        <translation>Dependencia de tareas</translation>
    </message>
    <message>
        <source>Data flow</source>
        <translation>Flujo de datos</translation>
    </message>
    <message>
        <source>Which task gets the processor; the net begins anew</source>
        <translation>Qué tarea obtiene el procesador; la red empieza de nuevo</translation>
    </message>
    <message>
        <source>Page of the net</source>
        <translation>Página de la red</translation>
    </message>
    <message>
        <source>Follow</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Show the page on which the next transition fires</source>
        <translation>Mostrar la página en la que dispara la próxima transición</translation>
    </message>
    <message>
        <source>%1 per s</source>
        <translation>%1 por s</translation>
    </message>
    <message>
        <source>Transitions that fire in a second</source>
        <translation>Transiciones que disparan en un segundo</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Fire one transition</source>
        <translation>Disparar una transición</translation>
    </message>
    <message>
        <source>Fire one transition after another</source>
        <translation>Disparar una transición tras otra</translation>
    </message>
    <message>
        <source>Back to start</source>
        <translation>Al principio</translation>
    </message>
    <message>
        <source>The tokens as they were at the beginning</source>
        <translation>Las marcas como al principio</translation>
    </message>
    <message>
        <source>Petri net</source>
        <translation>Red de Petri</translation>
    </message>
    <message>
        <source>A thick frame with a triangle: this transition could fire. Filled: it fires next. Thick lines: it fired last.</source>
        <translation>Un marco grueso con un triángulo: esta transición podría disparar. Relleno: dispara a continuación. Líneas gruesas: disparó la última.</translation>
    </message>
    <message>
        <source>Levels of the buffers</source>
        <translation>Niveles de los búferes</translation>
    </message>
    <message>
        <source>Time of the net, s</source>
        <translation>Tiempo de la red, s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>Places of this page</source>
        <translation>Lugares de esta página</translation>
    </message>
    <message>
        <source>What is chosen</source>
        <translation>Lo elegido</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::NumberField</name>
    <message>
        <source>%1 can be read in two ways. Type it without a separator between thousands, or with %2 before the decimals.</source>
        <translation>%1 se puede leer de dos formas. Escribirlo sin separador de miles, o con %2 antes de los decimales.</translation>
    </message>
    <message>
        <source>%1 has more than one separator. Type it without separators between thousands.</source>
        <translation>%1 tiene más de un separador. Escribirlo sin separadores de miles.</translation>
    </message>
    <message>
        <source>The field was empty.</source>
        <translation>El campo estaba vacío.</translation>
    </message>
    <message>
        <source>%1 is not a number.</source>
        <translation>%1 no es un número.</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 to %3.</source>
        <translation>%1 está fuera de rango: %2 a %3.</translation>
    </message>
    <message>
        <source>%1 The value stays %2.</source>
        <translation>%1 El valor sigue siendo %2.</translation>
    </message>
    <message>
        <source>%1 is not a whole number. Type it without separators.</source>
        <translation>%1 no es un número entero. Escribirlo sin separadores.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::OverlayPanel</name>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Emulator</source>
        <translation>Emulador</translation>
    </message>
    <message>
        <source>%1 machine − emulator</source>
        <translation>%1 máquina − emulador</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
    <message>
        <source>Recording on which machine and emulator are compared</source>
        <translation>Grabación en la que se comparan máquina y emulador</translation>
    </message>
    <message>
        <source>Errors drawn larger</source>
        <translation>Errores ampliados</translation>
    </message>
    <message>
        <source>How many times larger the distance to the path of the set points is drawn</source>
        <translation>Cuántas veces mayor se dibuja la distancia a la trayectoria de las consignas</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Error × %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::OverrideControl</name>
    <message>
        <source>Path override of this run, in percent of the programmed feed. The override of the machine&apos;s own switch multiplies. Ctrl++ and Ctrl+- are a step of 5 %.</source>
        <translation>Override de trayectoria de esta ejecución, en porcentaje del avance programado. El override del interruptor de la máquina multiplica. Ctrl++ y Ctrl+- son un paso del 5 %.</translation>
    </message>
    <message>
        <source>Override</source>
        <translation>Override</translation>
    </message>
    <message>
        <source>Override: 5 % less</source>
        <translation>Override: 5 % menos</translation>
    </message>
    <message>
        <source>Override: 5 % more</source>
        <translation>Override: 5 % más</translation>
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
        <translation>Red de Petri</translation>
    </message>
    <message>
        <source>Tasks</source>
        <translation>Tareas</translation>
    </message>
    <message>
        <source>Part of the page</source>
        <translation>Parte de la página</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathPane</name>
    <message>
        <source>The path during the time shown. Click: cursor A. Shift and click: cursor B. In 3D, drag or the arrow keys turn it, Home turns it back.</source>
        <translation>La trayectoria del tiempo mostrado. Clic: cursor A. Mayús y clic: cursor B. En 3D la giran el arrastre o las flechas, Inicio la devuelve.</translation>
    </message>
    <message>
        <source>Path of the axes</source>
        <translation>Trayectoria de los ejes</translation>
    </message>
    <message>
        <source>%1: no values here</source>
        <translation>%1: aquí no hay valores</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Error × %1</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>No X and Y here</source>
        <translation>Aquí no hay X ni Y</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathPanel</name>
    <message>
        <source>Line %1 was executed %2 times. Cursor A is at number %3; click again for the next.</source>
        <translation>La línea %1 se ejecutó %2 veces. El cursor A está en la número %3; otro clic lleva a la siguiente.</translation>
    </message>
    <message>
        <source>The line under cursor A is marked. A click on a line puts cursor A where it was executed.</source>
        <translation>La línea bajo el cursor A está marcada. Un clic en una línea pone el cursor A donde se ejecutó.</translation>
    </message>
    <message>
        <source>Text of the program</source>
        <translation>Texto del programa</translation>
    </message>
    <message>
        <source>The signal that gives the path its colours</source>
        <translation>La señal que da los colores a la trayectoria</translation>
    </message>
    <message>
        <source>Colour of the path</source>
        <translation>Color de la trayectoria</translation>
    </message>
    <message>
        <source>Enlargement of the error</source>
        <translation>Ampliación del error</translation>
    </message>
    <message>
        <source>Seen from the side; drag the path or press the arrow keys to turn it</source>
        <translation>Vista de lado; arrastrar la trayectoria o pulsar las flechas para girarla</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>X and Y, seen from above</source>
        <translation>X e Y, vistos desde arriba</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>A click on a line puts cursor A where it was executed.</source>
        <translation>Un clic en una línea pone el cursor A donde se ejecutó.</translation>
    </message>
    <message>
        <source>Nothing moved in line %1.</source>
        <translation>En la línea %1 no se movió nada.</translation>
    </message>
    <message>
        <source>The trace does not show where it is in the program.</source>
        <translation>La traza no muestra en qué punto del programa está.</translation>
    </message>
    <message>
        <source>Comparing the trace with the program …</source>
        <translation>Comparando la traza con el programa…</translation>
    </message>
    <message>
        <source>The run was made with another program or another version of it. Open that one to see its lines with the cursor.</source>
        <translation>La ejecución se hizo con otro programa u otra versión. Abrir aquel para ver sus líneas con el cursor.</translation>
    </message>
    <message>
        <source>Lines and trace are linked when a trace is shown.</source>
        <translation>Las líneas y la traza se enlazan cuando se muestra una traza.</translation>
    </message>
    <message>
        <source>Open the NC program of the trace to see its lines with the cursor.</source>
        <translation>Abrir el programa CN de la traza para ver sus líneas con el cursor.</translation>
    </message>
    <message>
        <source>Errors can be drawn larger after the trace has been compared with its NC program</source>
        <translation>Los errores se pueden ampliar después de comparar la traza con su programa CN</translation>
    </message>
    <message>
        <source>How many times larger the distance to the programmed path is drawn</source>
        <translation>Cuántas veces mayor se dibuja la distancia a la trayectoria programada</translation>
    </message>
    <message>
        <source>Error × %1</source>
        <translation>Error × %1</translation>
    </message>
    <message>
        <source>Colour: %1</source>
        <translation>Color: %1</translation>
    </message>
    <message>
        <source>Colour: the trace</source>
        <translation>Color: la traza</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PathView</name>
    <message>
        <source>Fit</source>
        <translation>Encajar</translation>
    </message>
    <message>
        <source>Show the whole path (double click does the same)</source>
        <translation>Mostrar toda la trayectoria (igual que el doble clic)</translation>
    </message>
    <message>
        <source>No program is loaded</source>
        <translation>No hay ningún programa cargado</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Rápido</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ejecutado</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Herramienta</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Color según</translation>
    </message>
    <message>
        <source>Kind of move</source>
        <translation>Tipo de movimiento</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Margin of the method</source>
        <translation>Margen del método</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>by point</source>
        <translation>por punto</translation>
    </message>
    <message>
        <source>by time</source>
        <translation>por tiempo</translation>
    </message>
    <message>
        <source>Walk along the path</source>
        <translation>Recorrer la trayectoria</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Recta</translation>
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
        <translation>sin avance indicado</translation>
    </message>
    <message>
        <source>margin over %1</source>
        <translation>margen superior a %1</translation>
    </message>
    <message>
        <source>not kept (below %1)</source>
        <translation>no se cumple (inferior a %1)</translation>
    </message>
    <message>
        <source>Click on the path or move the slider.</source>
        <translation>Hacer clic en la trayectoria o mover el control deslizante.</translation>
    </message>
    <message>
        <source>Point %1 of %2, line %3</source>
        <translation>Punto %1 de %2, línea %3</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calculando…</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>hasta %1</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausas</translation>
    </message>
    <message>
        <source>Mark where the run will pause</source>
        <translation>Marcar dónde hará pausas la ejecución</translation>
    </message>
    <message>
        <source>Pause off the cut, after point %1, line %2</source>
        <translation>Pausa fuera del corte, después del punto %1, línea %2</translation>
    </message>
    <message>
        <source>Pause in the cut, after point %1, line %2</source>
        <translation>Pausa en el corte, después del punto %1, línea %2</translation>
    </message>
    <message>
        <source>%1 in the cut</source>
        <translation>%1 en el corte</translation>
    </message>
    <message>
        <source>then a pause in the cut</source>
        <translation>después una pausa en el corte</translation>
    </message>
    <message>
        <source>then a pause off the cut</source>
        <translation>después una pausa fuera del corte</translation>
    </message>
    <message>
        <source>Density of pauses</source>
        <translation>Densidad de pausas</translation>
    </message>
    <message>
        <source>no pause</source>
        <translation>sin pausa</translation>
    </message>
    <message>
        <source>a pause every %1</source>
        <translation>una pausa cada %1</translation>
    </message>
    <message>
        <source>By the control</source>
        <translation>Por el control</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>Cambio de herramienta</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pauses off the cut</source>
        <translation>
            <numerusform>%Ln pausa fuera del corte</numerusform>
            <numerusform>%Ln pausas fuera del corte</numerusform>
        </translation>
    </message>
    <message>
        <source>The points appear here as they come</source>
        <translation>Los puntos aparecen aquí según llegan</translation>
    </message>
    <message>
        <source>Grid %1</source>
        <translation>Cuadrícula %1</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Drag or press the arrow keys to turn it; with Shift, dragging moves it</source>
        <translation>Arrastrar o las flechas la giran; con Mayús, arrastrar la desplaza</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Arriba</translation>
    </message>
    <message>
        <source>From above: X, Y</source>
        <translation>Desde arriba: X, Y</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Frente</translation>
    </message>
    <message>
        <source>From the front: X, Z</source>
        <translation>Desde delante: X, Z</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>From the right: Y, Z</source>
        <translation>Desde la derecha: Y, Z</translation>
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
        <translation>Sin datos</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
    <message>
        <source>Last executed point, %1. The axes were read %2 ago.</source>
        <translation>Último punto ejecutado, %1. Los ejes se leyeron hace %2.</translation>
    </message>
    <message>
        <source>Old: read %1 ago</source>
        <translation>Antiguo: leído hace %1</translation>
    </message>
    <message>
        <source>to go %1</source>
        <translation>resta %1</translation>
    </message>
    <message>
        <source>Distance to go: not known, because the stream leaves no time to read the axes.</source>
        <translation>Recorrido restante: desconocido, porque la transmisión no deja tiempo para leer los ejes.</translation>
    </message>
    <message>
        <source>Distance to go: not known. The axes are not on the path of the program, or it is being corrected.</source>
        <translation>Recorrido restante: desconocido. Los ejes no están en la trayectoria del programa, o se está corrigiendo.</translation>
    </message>
    <message>
        <source>Distance to go: the control does not report it.</source>
        <translation>Recorrido restante: el control no lo comunica.</translation>
    </message>
    <message>
        <source>Distance to go to the end of the move in progress, from the position that was read and the path of the program</source>
        <translation>Recorrido restante hasta el final del movimiento en curso, según la posición leída y la trayectoria del programa</translation>
    </message>
    <message>
        <source>Distance to go to the end of the block, as the control reports it</source>
        <translation>Recorrido restante hasta el final de la secuencia, comunicado por el control</translation>
    </message>
    <message>
        <source>set %1</source>
        <translation>cons. %1</translation>
    </message>
    <message>
        <source>The feed override at the control is not read; it acts in addition.</source>
        <translation>El override de avance del control no se lee; actúa además.</translation>
    </message>
    <message>
        <source>Commanded feed: not known, because no run of this window is in progress.</source>
        <translation>Avance de consigna: desconocido, porque no hay ninguna ejecución de esta ventana en curso.</translation>
    </message>
    <message>
        <source>Feed of the program, scaled by the override of the run. %1</source>
        <translation>Avance del programa, con el override de la ejecución. %1</translation>
    </message>
    <message>
        <source>One feed for all moves, without an override. %1</source>
        <translation>Un avance para todos los movimientos, sin override. %1</translation>
    </message>
    <message>
        <source>Up to 1 s old: no time to read more often</source>
        <translation>Hasta 1 s de antigüedad: sin tiempo para leer más</translation>
    </message>
    <message>
        <source>No tool in the spindle</source>
        <translation>Ninguna herramienta en el cabezal</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Herramienta %1</translation>
    </message>
    <message>
        <source>cutting edge D%1</source>
        <translation>filo D%1</translation>
    </message>
    <message>
        <source>work offset %1</source>
        <translation>decalaje de origen %1</translation>
    </message>
    <message>
        <source>Spindle: actual %1, commanded %2 1/min</source>
        <translation>Cabezal: real %1, ordenado %2 r/min</translation>
    </message>
    <message>
        <source>clockwise (M3)</source>
        <translation>giro a derechas (M3)</translation>
    </message>
    <message>
        <source>counterclockwise (M4)</source>
        <translation>giro a izquierdas (M4)</translation>
    </message>
    <message>
        <source>direction not known</source>
        <translation>sentido de giro desconocido</translation>
    </message>
    <message>
        <source>coolant off</source>
        <translation>refrigerante apagado</translation>
    </message>
    <message>
        <source>coolant on (%1)</source>
        <translation>refrigerante encendido (%1)</translation>
    </message>
    <message>
        <source>coolant not known</source>
        <translation>refrigerante desconocido</translation>
    </message>
    <message>
        <source>%1. The control reports it, about once a second.</source>
        <translation>%1. El control lo comunica, más o menos una vez por segundo.</translation>
    </message>
    <message>
        <source>%1. Read %2 ago: it may have changed since.</source>
        <translation>%1. Leído hace %2: puede haber cambiado desde entonces.</translation>
    </message>
    <message>
        <source>Live, but tool and spindle: read %1 ago</source>
        <translation>En vivo, pero herramienta y cabezal: leídos hace %1</translation>
    </message>
    <message>
        <source>Read %1 ago: the run is being prepared</source>
        <translation>Leído hace %1: se prepara la ejecución</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::PreflightSheet</name>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the machine moves.</source>
        <translation>Todavía no se ha movido nada. Mantener pulsado Iniciar un segundo: entonces la máquina se mueve.</translation>
    </message>
    <message>
        <source>Start is not possible yet.</source>
        <translation>Todavía no se puede iniciar.</translation>
    </message>
    <message>
        <source>Before the start</source>
        <translation>Antes del inicio</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Ahora no</translation>
    </message>
    <message>
        <source>Resuming is not possible yet.</source>
        <translation>Todavía no se puede reanudar.</translation>
    </message>
    <message>
        <source>Before the run is resumed</source>
        <translation>Antes de reanudar la ejecución</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Superado</translation>
    </message>
    <message numerus="yes">
        <source>%Ln checks: %1</source>
        <translation>
            <numerusform>%Ln comprobación: %1</numerusform>
            <numerusform>%Ln comprobaciones: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Plegar</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold the button below for one second: then the machine moves.</source>
        <translation>Todavía no se ha movido nada. Mantener pulsado un segundo el botón de abajo: entonces la máquina se mueve.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the tool is raised, and nothing else.</source>
        <translation>Todavía no se ha movido nada. Mantener pulsado Iniciar un segundo: entonces sube la herramienta, y nada más.</translation>
    </message>
    <message>
        <source>Before the tool is raised</source>
        <translation>Antes de levantar la herramienta</translation>
    </message>
    <message>
        <source>First move</source>
        <translation>Primer movimiento</translation>
    </message>
    <message>
        <source>Nothing has moved yet. Hold Start for one second: then the tool goes back along the path, and nothing else.</source>
        <translation>Todavía no se ha movido nada. Mantener pulsado Iniciar un segundo: entonces la herramienta retrocede por la trayectoria, y nada más.</translation>
    </message>
    <message>
        <source>Before the tool goes back</source>
        <translation>Antes de que la herramienta retroceda</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProfilePage</name>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Herramienta %1</translation>
    </message>
    <message>
        <source>Number of the tool</source>
        <translation>Número de la herramienta</translation>
    </message>
    <message>
        <source>Entered by %1 on %2.</source>
        <translation>Introducido por %1 el %2.</translation>
    </message>
    <message>
        <source>Nobody has entered the limits of this machine. Feeds and simulations take those of the machine in the paper: %1.</source>
        <translation>Nadie ha introducido los límites de esta máquina. Los avances y las simulaciones toman los de la máquina del artículo: %1.</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Aún no guardado.</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>Nombre de la máquina</translation>
    </message>
    <message>
        <source>Simulated as</source>
        <translation>Simulada como</translation>
    </message>
    <message>
        <source>Take over its limits</source>
        <translation>Tomar sus límites</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Travel from</source>
        <translation>Recorrido desde</translation>
    </message>
    <message>
        <source>Travel to</source>
        <translation>Recorrido hasta</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>Jerk</source>
        <translation>Sacudida</translation>
    </message>
    <message>
        <source>Rapid, mm/min</source>
        <translation>Rápido, mm/min</translation>
    </message>
    <message>
        <source>Spindle up to, 1/min</source>
        <translation>Cabezal hasta, 1/min</translation>
    </message>
    <message>
        <source>0: no spindle</source>
        <translation>0: sin cabezal</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Length, mm</source>
        <translation>Longitud, mm</translation>
    </message>
    <message>
        <source>Radius, mm</source>
        <translation>Radio, mm</translation>
    </message>
    <message>
        <source>Add a tool</source>
        <translation>Añadir una herramienta</translation>
    </message>
    <message>
        <source>Save the limits</source>
        <translation>Guardar los límites</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Descartar los cambios</translation>
    </message>
    <message>
        <source>M functions: write the number, an equals sign, and ignore, pass or a line for the control. Separate entries with semicolons.</source>
        <translation>Funciones M: escriba un número, = e ignore, pass o una línea para el control; un punto y coma entre dos.</translation>
    </message>
    <message>
        <source>M functions of other machines</source>
        <translation>Funciones M de otras máquinas</translation>
    </message>
    <message>
        <source>What this machine does for the M functions of programs made for another: ignore leaves the function out, pass gives it to the control, anything else is a line for it.</source>
        <translation>Lo que hace esta máquina para las funciones M de programas hechos para otra: ignore omite la función, pass la entrega al control, cualquier otra cosa es una línea para él.</translation>
    </message>
    <message>
        <source>When nothing has come from this computer for so long, the axes stand on the path until it gives a sign again. 0: not at all.</source>
        <translation>Si durante este tiempo no llega nada de este ordenador, los ejes se detienen en la trayectoria hasta que vuelva a dar señal. 0: nunca.</translation>
    </message>
    <message>
        <source>Without this computer the axes stand after, s</source>
        <translation>Sin este ordenador, los ejes se detienen tras, s</translation>
    </message>
    <message>
        <source>Where a stop is sure to act only before the next window, because this control has not passed the stop test, no window of several moves takes longer.</source>
        <translation>Donde una parada solo actúa con seguridad antes de la ventana siguiente, porque este control no ha superado la prueba de parada, ninguna ventana de varios movimientos dura más.</translation>
    </message>
    <message>
        <source>Without a passed stop test a window takes at most, s</source>
        <translation>Sin prueba de parada superada, una ventana dura como máximo, s</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramPage</name>
    <message>
        <source>Program text</source>
        <translation>Texto del programa</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramPanel</name>
    <message>
        <source>Open an NC program</source>
        <translation>Abrir un programa CN</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recientes</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Datos</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Líneas</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Movimientos</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Cutting path</source>
        <translation>Recorrido de corte</translation>
    </message>
    <message>
        <source>Rapid path</source>
        <translation>Recorrido en rápido</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>Avances</translation>
    </message>
    <message>
        <source>Smallest distance of neighbouring points</source>
        <translation>Distancia mínima entre puntos vecinos</translation>
    </message>
    <message>
        <source>Smallest path length of half a loop (N/2 points, rounded down)</source>
        <translation>Longitud mínima de medio bucle (N/2 puntos, redondeado hacia abajo)</translation>
    </message>
    <message>
        <source>No program</source>
        <translation>Ningún programa</translation>
    </message>
    <message>
        <source>Drop a file here or press Open…</source>
        <translation>Soltar aquí un archivo o pulsar Abrir…</translation>
    </message>
    <message>
        <source>Hash %1</source>
        <translation>Hash %1</translation>
    </message>
    <message>
        <source>Errors: %1, warnings: %2, notes: %3</source>
        <translation>Errores: %1, advertencias: %2, notas: %3</translation>
    </message>
    <message>
        <source>Cannot be streamed.</source>
        <translation>No transmisible de forma continua.</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>lines %1–%2</source>
        <translation>líneas %1–%2</translation>
    </message>
    <message>
        <source>No findings</source>
        <translation>Ninguna observación</translation>
    </message>
    <message>
        <source>NC programs (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap *.cnc *.gcode *.h *.H *.txt)</source>
        <translation>Programas CN (*.mpf *.MPF *.spf *.SPF *.nc *.NC *.ngc *.tap *.cnc *.gcode *.h *.H *.txt)</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialecto</translation>
    </message>
    <message>
        <source>Accept…</source>
        <translation>Aceptar…</translation>
    </message>
    <message>
        <source>The program is read again with this word left out</source>
        <translation>El programa se vuelve a leer sin esta palabra</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>By kind</source>
        <translation>Por tipo</translation>
    </message>
    <message>
        <source>Time, feeds as programmed</source>
        <translation>Tiempo, avances programados</translation>
    </message>
    <message>
        <source>Time, as streamed</source>
        <translation>Tiempo, en transmisión</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Distancias</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Esquinas</translation>
    </message>
    <message>
        <source>Distances of neighbouring points, mm</source>
        <translation>Distancias entre puntos vecinos, mm</translation>
    </message>
    <message>
        <source>%1 (repetitions left out: %2)</source>
        <translation>%1 (repeticiones omitidas: %2)</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>no indicadas</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pulgadas</translation>
    </message>
    <message>
        <source>mm and inch</source>
        <translation>mm y pulgadas</translation>
    </message>
    <message>
        <source>lines %1</source>
        <translation>rectas %1</translation>
    </message>
    <message>
        <source>arcs %1</source>
        <translation>arcos %1</translation>
    </message>
    <message>
        <source>splines %1</source>
        <translation>splines %1</translation>
    </message>
    <message>
        <source>median %1, largest %2</source>
        <translation>mediana %1, máxima %2</translation>
    </message>
    <message>
        <source>%1 of 45° and more; sharpest %2° (%3)</source>
        <translation>%1 de 45° o más; la más viva %2° (%3)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Findings (%1)</source>
        <translation>Observaciones (%1)</translation>
    </message>
    <message>
        <source>%1 without pauses</source>
        <translation>%1 sin pausas</translation>
    </message>
    <message>
        <source>as detected</source>
        <translation>según lo detectado</translation>
    </message>
    <message>
        <source>Read as %1, as selected.</source>
        <translation>Leído como %1, según lo elegido.</translation>
    </message>
    <message>
        <source>Read as %1: the text gives no evidence of its dialect.</source>
        <translation>Leído como %1: el texto no permite reconocer su dialecto.</translation>
    </message>
    <message>
        <source>Read as %1 because of &quot;%2&quot;.</source>
        <translation>Leído como %1 por «%2».</translation>
    </message>
    <message>
        <source>Accepted: %1</source>
        <translation>Aceptado: %1</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Take back %1</source>
        <translation>Retirar %1</translation>
    </message>
    <message>
        <source>Accept %1</source>
        <translation>Aceptar %1</translation>
    </message>
    <message>
        <source>Rivulet does not understand %1. If you accept it, it is left out wherever the program has it, and the path is taken as if it were not there.

Is it certain that %1 does not change the path of the tool?</source>
        <translation>Rivulet no entiende %1. Si lo acepta, se omite en todo el programa y la trayectoria se toma como si no estuviera.

¿Es seguro que %1 no cambia la trayectoria de la herramienta?</translation>
    </message>
    <message>
        <source>Accept and read again</source>
        <translation>Aceptar y volver a leer</translation>
    </message>
    <message>
        <source>computing …</source>
        <translation>calculando…</translation>
    </message>
    <message>
        <source>Computed with the axes of %1</source>
        <translation>Calculado con los ejes de %1</translation>
    </message>
    <message>
        <source>I, J, K are read as the centre itself</source>
        <translation>I, J, K se leen como el centro mismo</translation>
    </message>
    <message>
        <source>I, J, K are read from the centre to the start</source>
        <translation>I, J, K se leen del centro al inicio</translation>
    </message>
    <message>
        <source>Read I, J, K as usual</source>
        <translation>Leer I, J, K como de costumbre</translation>
    </message>
    <message>
        <source>Read it that way</source>
        <translation>Leer así</translation>
    </message>
    <message>
        <source>Cannot be streamed: no axis moves.</source>
        <translation>No se puede transmitir: no se mueve ningún eje.</translation>
    </message>
    <message>
        <source>Cannot be streamed: it needs a transformation of the control.</source>
        <translation>No se puede transmitir: necesita una transformación del control.</translation>
    </message>
    <message numerus="yes">
        <source>%1 … %2 (%Ln values)</source>
        <translation>
            <numerusform>%1 … %2 (%Ln valor)</numerusform>
            <numerusform>%1 … %2 (%Ln valores)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 with %Ln pauses, which cost %2</source>
        <translation>
            <numerusform>%1 con %Ln pausa, que cuesta %2</numerusform>
            <numerusform>%1 con %Ln pausas, que cuestan %2</numerusform>
        </translation>
    </message>
    <message>
        <source>Live …</source>
        <translation>En vivo…</translation>
    </message>
    <message>
        <source>Points that another program computes while the machine moves</source>
        <translation>Puntos que otro programa calcula mientras la máquina se mueve</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Texto</translation>
    </message>
    <message numerus="yes">
        <source>%Ln lines</source>
        <translation>
            <numerusform>%Ln línea</numerusform>
            <numerusform>%Ln líneas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ProgramTextView</name>
    <message>
        <source>No program is loaded</source>
        <translation>No hay ningún programa cargado</translation>
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
        <translation>un %1 no se mueve</translation>
    </message>
    <message>
        <source>Nothing shows for which control this program was made. From line %1 on, %2. Which is it?</source>
        <translation>Nada muestra para qué control se hizo este programa. A partir de la línea %1: %2. ¿Cuál es?</translation>
    </message>
    <message>
        <source>The program does not say whether it is in mm or inch. Its size in mm, or in inch: %1.</source>
        <translation>El programa no dice si está en mm o en pulgadas. Su tamaño en mm, o en pulgadas: %1.</translation>
    </message>
    <message>
        <source>Coordinates have no decimal point. Some controls count them in thousandths. The size as whole units, or as thousandths: %1.</source>
        <translation>Las coordenadas no tienen punto decimal. Algunos controles las cuentan en milésimas. El tamaño en unidades enteras, o en milésimas: %1.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pulgada</translation>
    </message>
    <message>
        <source>Whole units</source>
        <translation>Unidades enteras</translation>
    </message>
    <message>
        <source>Thousandths</source>
        <translation>Milésimas</translation>
    </message>
    <message>
        <source>Take them</source>
        <translation>Tomarlos</translation>
    </message>
    <message>
        <source>The program leaves values to settings of the control. Enter those of the machine, or take those of a virtual machine.</source>
        <translation>El programa deja valores a los ajustes del control. Introduzca los de la máquina, o tome los de una máquina virtual.</translation>
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
        <translation>N, puntos por bucle</translation>
    </message>
    <message>
        <source>δ, mm</source>
        <translation>δ, mm</translation>
    </message>
    <message>
        <source>reach</source>
        <translation>alcance</translation>
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
        <translation>t_min, ms: movimiento más corto al 100&#xa0;%</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ReportPanel</name>
    <message>
        <source>Run</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausas</translation>
    </message>
    <message>
        <source>Access time per variable</source>
        <translation>Tiempo de acceso por variable</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ejecutados</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Repetidos</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Omitidos</translation>
    </message>
    <message>
        <source>Off the program</source>
        <translation>Fuera del programa</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Cantidad</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>Requests</source>
        <translation>Peticiones</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>95th percentile</source>
        <translation>Percentil 95</translation>
    </message>
    <message>
        <source>99th percentile</source>
        <translation>Percentil 99</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Stop confirmed</source>
        <translation>Parada confirmada</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Aún no hay ejecución</translation>
    </message>
    <message>
        <source>%1 of %2 (not judged: longer than the trace of the control)</source>
        <translation>%1 de %2 (sin evaluar: más larga que el registro del control)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 of %2 (not judged: no trace of the control)</source>
        <translation>%1 de %2 (sin evaluar: falta el registro del control)</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>sin evaluar</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>tras %1</translation>
    </message>
    <message>
        <source>NOT confirmed: check the machine</source>
        <translation>SIN confirmar: comprobar la máquina</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>%1, from point %2 on</source>
        <translation>%1, desde el punto %2</translation>
    </message>
    <message>
        <source>%1 (proved)</source>
        <translation>%1 (probada)</translation>
    </message>
    <message>
        <source>Time spent</source>
        <translation>Reparto del tiempo</translation>
    </message>
    <message>
        <source>Live lines</source>
        <translation>Líneas en vivo</translation>
    </message>
    <message>
        <source>Delay from arrival to motion</source>
        <translation>Retardo de la llegada al movimiento</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ResponsePanel</name>
    <message>
        <source>Bode plot: gain</source>
        <translation>Diagrama de Bode: ganancia</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frecuencia, Hz</translation>
    </message>
    <message>
        <source>Gain, dB</source>
        <translation>Ganancia, dB</translation>
    </message>
    <message>
        <source>Bode plot: phase</source>
        <translation>Diagrama de Bode: fase</translation>
    </message>
    <message>
        <source>Phase, °</source>
        <translation>Fase, °</translation>
    </message>
    <message>
        <source>Answer to a step of 1 mm</source>
        <translation>Respuesta a un escalón de 1 mm</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Tiempo, s</translation>
    </message>
    <message>
        <source>Position, mm</source>
        <translation>Posición, mm</translation>
    </message>
    <message>
        <source>%1 follows up to %2 Hz (−3 dB).</source>
        <translation>%1 sigue hasta %2 Hz (−3 dB).</translation>
    </message>
    <message>
        <source>From set point to actual position; the Bode plot is without friction.</source>
        <translation>De la consigna a la posición real; el diagrama de Bode sin fricción.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ResumeBar</name>
    <message>
        <source>Not now</source>
        <translation>Ahora no</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Asking the control where the run was left …</source>
        <translation>Se pregunta al control dónde se interrumpió la ejecución…</translation>
    </message>
    <message>
        <source>The run cannot be resumed: %1</source>
        <translation>La ejecución no se puede reanudar: %1</translation>
    </message>
    <message>
        <source>Press and hold: resume at point %1</source>
        <translation>Mantener pulsado: reanudar en el punto %1</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Mantener pulsado un segundo. Entonces la máquina se mueve.</translation>
    </message>
    <message>
        <source>Press and hold: start at point %1</source>
        <translation>Mantener pulsado: iniciar en el punto %1</translation>
    </message>
    <message>
        <source>Press and hold: go on with the job</source>
        <translation>Mantener pulsado: continuar el trabajo</translation>
    </message>
    <message numerus="yes">
        <source>Before that, the control executes %Ln blocks: see the list.</source>
        <translation>
            <numerusform>Antes, el control ejecuta %Ln secuencia: véase la lista.</numerusform>
            <numerusform>Antes, el control ejecuta %Ln secuencias: véase la lista.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing has moved yet. The run will start at point %1 of %2, where line %3 begins: %4.</source>
        <translation>Todavía no se ha movido nada. La ejecución empezará en el punto %1 de %2, donde comienza la línea %3: %4.</translation>
    </message>
    <message>
        <source>The tool first moves %1 in a straight line to that point.</source>
        <translation>La herramienta recorre primero %1 en línea recta hasta ese punto.</translation>
    </message>
    <message>
        <source>From point %1 on, the program differs from that of the interrupted run. None of these points has been executed: check the new path before you go on.</source>
        <translation>A partir del punto %1, el programa difiere del de la ejecución interrumpida. Ninguno de estos puntos se ha ejecutado: comprobar la nueva trayectoria antes de continuar.</translation>
    </message>
    <message>
        <source>The program still stands on the control: first it executes the rest of its window, at most %1, and ends.</source>
        <translation>El programa sigue detenido en el control: primero ejecuta el resto de su ventana, como máximo %1, y termina.</translation>
    </message>
    <message>
        <source>The program still stands on the control, between its windows: it ends without a move.</source>
        <translation>El programa sigue detenido en el control, entre sus ventanas: termina sin moverse.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The job will go on in part %1 at point %2 of %3, line %4.</source>
        <translation>Aún no se ha movido nada. El trabajo seguirá en el tramo %1, punto %2 de %3, línea %4.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The job will go on at line %1: %2.</source>
        <translation>Aún no se ha movido nada. El trabajo continuará en la línea %1: %2.</translation>
    </message>
    <message>
        <source>Nothing has moved yet. The run will resume at point %1 of %2, line %3: %4.</source>
        <translation>Todavía no se ha movido nada. La ejecución se reanudará en el punto %1 de %2, línea %3: %4.</translation>
    </message>
    <message>
        <source>Then the tool moves %1 in a straight line to that point.</source>
        <translation>Después la herramienta recorre %1 en línea recta hasta ese punto.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RightsPage</name>
    <message>
        <source>not known</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>falta</translation>
    </message>
    <message>
        <source>given</source>
        <translation>concedido</translation>
    </message>
    <message>
        <source>Asking the control …</source>
        <translation>Consultando el control…</translation>
    </message>
    <message>
        <source>A run is not possible with these rights.</source>
        <translation>Con estos derechos no es posible ninguna ejecución.</translation>
    </message>
    <message>
        <source>A run is possible; some steps remain to the operator.</source>
        <translation>Es posible una ejecución; algunos pasos quedan para el operario.</translation>
    </message>
    <message>
        <source>This user has all rights that a run needs.</source>
        <translation>Este usuario tiene todos los derechos que necesita una ejecución.</translation>
    </message>
    <message>
        <source>More than a run needs: %1. Call DeleteUserAccess with them, or use a user of its own for Rivulet.</source>
        <translation>Más de lo que necesita una ejecución: %1. Llamar a DeleteUserAccess con ellos, o usar un usuario propio para Rivulet.</translation>
    </message>
    <message>
        <source>The server does not tell which other rights this user has. Look at the list of users on the control.</source>
        <translation>El servidor no dice qué otros derechos tiene este usuario. Mirar la lista de usuarios en el control.</translation>
    </message>
    <message>
        <source>Asks the control which of the rights that a run needs the user of this connection has. Nothing is changed.</source>
        <translation>Pregunta al control cuáles de los derechos que necesita una ejecución tiene el usuario de esta conexión. No se cambia nada.</translation>
    </message>
    <message>
        <source>Check the rights</source>
        <translation>Comprobar los derechos</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunPanel</name>
    <message>
        <source>Stop</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>Executed</source>
        <translation>Ejecutados</translation>
    </message>
    <message>
        <source>Start is not possible: %1</source>
        <translation>No se puede iniciar: %1</translation>
    </message>
    <message>
        <source>Ready to start</source>
        <translation>Listo para iniciar</translation>
    </message>
    <message>
        <source>Stop confirmed after %1</source>
        <translation>Parada confirmada tras %1</translation>
    </message>
    <message>
        <source>Stop confirmed</source>
        <translation>Parada confirmada</translation>
    </message>
    <message>
        <source>Stop NOT confirmed: check the machine</source>
        <translation>Parada SIN confirmar: comprobar la máquina</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Reanudar…</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>The machine waits before the next window until you press Continue.</source>
        <translation>La máquina espera antes de la ventana siguiente hasta que se pulse Continuar.</translation>
    </message>
    <message>
        <source>Only method window can hold.</source>
        <translation>Solo el método Ventana puede suspender.</translation>
    </message>
    <message>
        <source>Waiting for the test of the template on the virtual machine</source>
        <translation>Esperando la prueba de la plantilla en la máquina virtual</translation>
    </message>
    <message>
        <source>Waiting for the transfer of the template to the control</source>
        <translation>Esperando la transferencia de la plantilla al control</translation>
    </message>
    <message>
        <source>Waiting for cycle start at the control</source>
        <translation>Esperando Marcha CN en el control</translation>
    </message>
    <message>
        <source>Waiting for selection of the template and cycle start at the control</source>
        <translation>Esperando la selección de la plantilla y Marcha CN en el control</translation>
    </message>
    <message>
        <source>Nothing comes from the control. Check cable, switch and server.</source>
        <translation>No llega nada del control. Comprobar cable, switch y servidor.</translation>
    </message>
    <message>
        <source>Waiting for the control&apos;s own trace</source>
        <translation>Esperando el registro del control</translation>
    </message>
    <message>
        <source>Waiting for %1</source>
        <translation>Esperando %1</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Mantener pulsado</translation>
    </message>
    <message>
        <source>Start over …</source>
        <translation>De nuevo…</translation>
    </message>
    <message>
        <source>Start …</source>
        <translation>Iniciar…</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Mantener pulsado un segundo. Entonces la máquina se mueve.</translation>
    </message>
    <message>
        <source>Shows what will happen first. Nothing moves yet.</source>
        <translation>Muestra qué ocurrirá primero. Todavía no se mueve nada.</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>No está listo</translation>
    </message>
    <message>
        <source>Stopped at %1</source>
        <translation>Parado en %1</translation>
    </message>
    <message>
        <source>Failed at %1</source>
        <translation>Fallido en %1</translation>
    </message>
    <message>
        <source>Wrong motion</source>
        <translation>Movimiento erróneo</translation>
    </message>
    <message>
        <source>The run has executed wrong points: see the report.</source>
        <translation>La ejecución ha hecho puntos erróneos: ver el informe.</translation>
    </message>
    <message>
        <source>Resume goes on where the run was left.</source>
        <translation>Reanudar continúa donde se interrumpió.</translation>
    </message>
    <message>
        <source>A new start begins at the first point.</source>
        <translation>Un nuevo inicio empieza en el primer punto.</translation>
    </message>
    <message>
        <source>Waiting until the claim of another client lapses, because it may be dead (10 s)</source>
        <translation>Esperando a que caduque la reserva de otro cliente, porque puede estar bloqueado (10 s)</translation>
    </message>
    <message>
        <source>Wrong motion. %1</source>
        <translation>Movimiento erróneo. %1</translation>
    </message>
    <message>
        <source>Watching run %1: it waits</source>
        <translation>Observando la ejecución %1: espera</translation>
    </message>
    <message>
        <source>Watching run %1</source>
        <translation>Observando la ejecución %1</translation>
    </message>
    <message>
        <source>A program waits on the control</source>
        <translation>Hay un programa esperando en el control</translation>
    </message>
    <message>
        <source>Run %1 is on the control</source>
        <translation>La ejecución %1 está en el control</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Time left</source>
        <translation>Resta</translation>
    </message>
    <message>
        <source>Points that are known to be executed</source>
        <translation>Puntos que constan como ejecutados</translation>
    </message>
    <message>
        <source>Only the computer that streams this run knows it.</source>
        <translation>Solo lo sabe el ordenador que transmite esta ejecución.</translation>
    </message>
    <message>
        <source>No program is loaded.</source>
        <translation>No hay ningún programa cargado.</translation>
    </message>
    <message>
        <source>No point has been executed yet.</source>
        <translation>Aún no se ha ejecutado ningún punto.</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>La ejecución ha terminado.</translation>
    </message>
    <message>
        <source>The time of the run is not estimated yet. During a run nothing is estimated.</source>
        <translation>La duración de la ejecución aún no está estimada. Durante una ejecución no se estima nada.</translation>
    </message>
    <message>
        <source>%1, pauses %2</source>
        <translation>%1, pausas %2</translation>
    </message>
    <message>
        <source>Estimate of the time that is left, with the feeds and the planned pauses of this run. Hold and the feed override at the control are not included.</source>
        <translation>Tiempo restante estimado, con los avances y las pausas previstas de esta ejecución. La suspensión y el override del control no están incluidos.</translation>
    </message>
    <message>
        <source>No run of this window is in progress.</source>
        <translation>No hay ninguna ejecución de esta ventana en curso.</translation>
    </message>
    <message>
        <source>%1: part %2 of %3</source>
        <translation>%1: tramo %2 de %3</translation>
    </message>
    <message>
        <source>%1: the control, line %2</source>
        <translation>%1: control, línea %2</translation>
    </message>
    <message>
        <source>%1: the control</source>
        <translation>%1: control</translation>
    </message>
    <message>
        <source>The program waits for cycle start at the control</source>
        <translation>El programa espera Marcha CN en el control</translation>
    </message>
    <message>
        <source>The job waits before the next block until you press Continue.</source>
        <translation>El trabajo espera antes de la secuencia siguiente hasta que se pulse Continuar.</translation>
    </message>
    <message>
        <source>Before part %1 of %2</source>
        <translation>Antes del tramo %1 de %2</translation>
    </message>
    <message>
        <source>After the last part</source>
        <translation>Después del último tramo</translation>
    </message>
    <message>
        <source>Streamed %1, pauses %2, tool changes %3, other blocks of the control %4. Cycles, measuring and stops are not included.</source>
        <translation>Transmitido %1, pausas %2, cambios de herramienta %3, otras secuencias del control %4. Los ciclos, las mediciones y las paradas no están incluidos.</translation>
    </message>
    <message>
        <source>%1, pauses %2, control %3</source>
        <translation>%1, pausas %2, control %3</translation>
    </message>
    <message>
        <source>%1, control %2</source>
        <translation>%1, control %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows</source>
        <translation>
            <numerusform>%Ln ventana</numerusform>
            <numerusform>%Ln ventanas</numerusform>
        </translation>
    </message>
    <message>
        <source>Points that are known to be executed, from point %1 on</source>
        <translation>Puntos que constan como ejecutados, a partir del punto %1</translation>
    </message>
    <message>
        <source>%1, dry run</source>
        <translation>%1, ensayo en vacío</translation>
    </message>
    <message>
        <source>The live source is silent or wants a hold. The run goes on with its next point.</source>
        <translation>La fuente en vivo calla o quiere una suspensión. La ejecución continúa con su próximo punto.</translation>
    </message>
    <message>
        <source>Waiting for points of the live source</source>
        <translation>Espera puntos de la fuente en vivo</translation>
    </message>
    <message>
        <source>A live source does not say when it ends.</source>
        <translation>Una fuente en vivo no dice cuándo termina.</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Terminar aquí</translation>
    </message>
    <message>
        <source>Hold for one second: the run ends. First the axes execute what the control still has of the window, with this override.</source>
        <translation>Mantener un segundo: la ejecución termina. Antes los ejes ejecutan con este override lo que el control aún tiene de la ventana.</translation>
    </message>
    <message>
        <source>What moves now does not obey the override. Press NC STOP at the machine.</source>
        <translation>Lo que se mueve ahora no obedece al override. Pulse NC STOP en la máquina.</translation>
    </message>
    <message>
        <source>Another client has set the override to %1 %</source>
        <translation>Otro cliente ha puesto el override al %1 %</translation>
    </message>
    <message>
        <source>The axes are braking</source>
        <translation>Los ejes están frenando</translation>
    </message>
    <message>
        <source>Override 0 %: the axes stand</source>
        <translation>Override 0 %: los ejes están parados</translation>
    </message>
    <message>
        <source>The axes stand at once, until you press Continue.</source>
        <translation>Los ejes se paran enseguida, hasta que pulse Continuar.</translation>
    </message>
    <message>
        <source>The axes stand (%1 after the order). Continue goes on, End here ends the run</source>
        <translation>Los ejes están parados (%1 después de la orden). Continuar sigue, Terminar aquí termina la ejecución</translation>
    </message>
    <message>
        <source>Stop and Pause act at the end of the block</source>
        <translation>Parada y Pausa actúan al final del bloque</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Its axes are held until the run is ended or resumed.</source>
        <translation>Sus ejes están retenidos hasta que la ejecución se termine o se reanude.</translation>
    </message>
    <message>
        <source>This window only shows it. Stop holds its axes.</source>
        <translation>Esta ventana solo la muestra. Parada retiene sus ejes.</translation>
    </message>
    <message>
        <source>This window did not start it. Stop holds its axes.</source>
        <translation>Esta ventana no la ha iniciado. Parada retiene sus ejes.</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves yet.</source>
        <translation>Pregunta al control dónde se interrumpió la ejecución. Todavía no se mueve nada.</translation>
    </message>
    <message>
        <source>Line of the live source of the move that the tool is on</source>
        <translation>Línea de la fuente en vivo del movimiento en el que está la herramienta</translation>
    </message>
    <message>
        <source>Line of the program of the move that the tool is on</source>
        <translation>Línea del programa del movimiento en el que está la herramienta</translation>
    </message>
    <message>
        <source>The tool is lifted by %1. Lower it, then the run can go on</source>
        <translation>La herramienta está elevada %1. Bájela y la ejecución podrá seguir</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Bajar</translation>
    </message>
    <message>
        <source>Lift by %1</source>
        <translation>Elevar %1</translation>
    </message>
    <message>
        <source>The tool goes back to where it stood.</source>
        <translation>La herramienta vuelve a donde estaba.</translation>
    </message>
    <message>
        <source>The tool goes straight up; the path waits.</source>
        <translation>La herramienta sube en línea recta; la trayectoria espera.</translation>
    </message>
    <message>
        <source>Continue goes on without it</source>
        <translation>Continuar sigue sin ella</translation>
    </message>
    <message>
        <source>stands in %1</source>
        <translation>parada en %1</translation>
    </message>
    <message>
        <source>The axes stand at once if the program obeys this computer&apos;s override, else at the end of its window. Escape does the same, from anywhere in the window. It does not replace the machine&apos;s emergency stop.</source>
        <translation>Los ejes se paran enseguida si el programa obedece al override de este ordenador; si no, al final de su ventana. Escape hace lo mismo desde cualquier lugar. No sustituye la parada de emergencia de la máquina.</translation>
    </message>
    <message>
        <source>Stream</source>
        <translation>Flujo</translation>
    </message>
    <message>
        <source>Sent to the control: %1, confirmed by it: %2</source>
        <translation>Enviados al control: %1, confirmados por él: %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln moves in hand</source>
        <translation>
            <numerusform>%Ln movimiento listo</numerusform>
            <numerusform>%Ln movimientos listos</numerusform>
        </translation>
    </message>
    <message>
        <source>Moves in hand: what the control has and has not executed yet.</source>
        <translation>Movimientos listos: lo que el control tiene y aún no ha ejecutado.</translation>
    </message>
    <message>
        <source>late, %1</source>
        <translation>con retraso, %1</translation>
    </message>
    <message>
        <source>on time, %1</source>
        <translation>a tiempo, %1</translation>
    </message>
    <message>
        <source>Margin %1: time until the control needs the next point, minus the 99th percentile of the access time</source>
        <translation>Margen %1: tiempo hasta que el control necesita el punto siguiente, menos el percentil 99 del tiempo de acceso</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunsModel</name>
    <message>
        <source>Time</source>
        <translation>Hora</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
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
        <translation>Ejecutado</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Repetidos</translation>
    </message>
    <message>
        <source>Skipped</source>
        <translation>Omitidos</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Pauses</source>
        <translation>Pausas</translation>
    </message>
    <message>
        <source>Who</source>
        <translation>Quién</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::RunsPage</name>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Open a report</source>
        <translation>Abrir un informe</translation>
    </message>
    <message>
        <source>Reports (*.json)</source>
        <translation>Informes (*.json)</translation>
    </message>
    <message>
        <source>All machines</source>
        <translation>Todas las máquinas</translation>
    </message>
    <message>
        <source>Runs: %1</source>
        <translation>Ejecuciones: %1</translation>
    </message>
    <message>
        <source>Runs: %1 of %2</source>
        <translation>Ejecuciones: %1 de %2</translation>
    </message>
    <message>
        <source>No run yet</source>
        <translation>Aún no hay ejecución</translation>
    </message>
    <message>
        <source>No run is selected.</source>
        <translation>No hay ninguna ejecución seleccionada.</translation>
    </message>
    <message>
        <source>%1, %2, version %3, %4</source>
        <translation>%1, %2, versión %3, %4</translation>
    </message>
    <message>
        <source>The run was not recorded.</source>
        <translation>La ejecución no se grabó.</translation>
    </message>
    <message>
        <source>Loads the program, compares it with the one of the run, and sets method and settings. Nothing starts.</source>
        <translation>Carga el programa, lo compara con el de la ejecución y toma método y ajustes. No se inicia nada.</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves.</source>
        <translation>Pregunta al control dónde quedó la ejecución. No se mueve nada.</translation>
    </message>
    <message>
        <source>Only a run that was left on the connected control, with its program loaded, can be resumed.</source>
        <translation>Solo se puede reanudar una ejecución interrumpida en el control conectado, con su programa cargado.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Shows runs in which each word stands in some column</source>
        <translation>Muestra las ejecuciones en las que cada palabra aparece en alguna columna</translation>
    </message>
    <message>
        <source>Search runs</source>
        <translation>Buscar ejecuciones</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>All results</source>
        <translation>Todos los resultados</translation>
    </message>
    <message>
        <source>Faultless</source>
        <translation>Sin errores</translation>
    </message>
    <message>
        <source>Not judged</source>
        <translation>Sin evaluar</translation>
    </message>
    <message>
        <source>Failed or wrong</source>
        <translation>Fallido o erróneo</translation>
    </message>
    <message>
        <source>Table as CSV…</source>
        <translation>Tabla en CSV…</translation>
    </message>
    <message>
        <source>Open a report…</source>
        <translation>Abrir un informe…</translation>
    </message>
    <message>
        <source>A report that was exported here or printed by stream --json</source>
        <translation>Un informe exportado aquí o escrito por stream --json</translation>
    </message>
    <message>
        <source>Open in Traces</source>
        <translation>Abrir en Curvas</translation>
    </message>
    <message>
        <source>Repeat with these settings</source>
        <translation>Repetir con estos ajustes</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reanudar</translation>
    </message>
    <message>
        <source>Page as PDF…</source>
        <translation>Página en PDF…</translation>
    </message>
    <message>
        <source>JSON…</source>
        <translation>JSON…</translation>
    </message>
    <message>
        <source>Keep at most</source>
        <translation>Guardar como máximo</translation>
    </message>
    <message>
        <source> runs</source>
        <translation> ejecuciones</translation>
    </message>
    <message>
        <source>Number of runs that are kept</source>
        <translation>Número de ejecuciones guardadas</translation>
    </message>
    <message>
        <source>Size of reports and recordings that are kept</source>
        <translation>Tamaño de los informes y grabaciones guardados</translation>
    </message>
    <message>
        <source>Others that cannot be shown: %1</source>
        <translation>Otras que no se pueden mostrar: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ScopeCurves</name>
    <message>
        <source>Time, s</source>
        <translation>Tiempo, s</translation>
    </message>
    <message>
        <source>Path, mm</source>
        <translation>Recorrido, mm</translation>
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
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>Remove the pane</source>
        <translation>Quitar el panel</translation>
    </message>
    <message>
        <source>Curves: %1</source>
        <translation>Curvas: %1</translation>
    </message>
    <message>
        <source>%1 to %2, from %3 to %4</source>
        <translation>%1 a %2, de %3 a %4</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SeriesModel</name>
    <message>
        <source>The control refused arrays of this size.</source>
        <translation>El control rechazó matrices de este tamaño.</translation>
    </message>
    <message>
        <source>%1 were requested; there was no time for more.</source>
        <translation>Se solicitaron %1; no hubo tiempo para más.</translation>
    </message>
    <message>
        <source>write</source>
        <translation>escritura</translation>
    </message>
    <message>
        <source>read</source>
        <translation>lectura</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>rechazado</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Access</source>
        <translation>Acceso</translation>
    </message>
    <message>
        <source>Shots</source>
        <translation>Mediciones</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#xa0;%</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parámetros R</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ServiceCard</name>
    <message>
        <source>Service at %1</source>
        <translation>Servicio %1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Remove this service from the board? It goes on with its work.</source>
        <translation>¿Quitar este servicio del tablero? Sigue trabajando.</translation>
    </message>
    <message>
        <source>Shows what the service says, and what can be done with it.</source>
        <translation>Muestra lo que comunica el servicio y lo que se puede hacer con él.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::ServicePanel</name>
    <message>
        <source>Service at %1</source>
        <translation>Servicio %1</translation>
    </message>
    <message>
        <source>Service at %1, %2</source>
        <translation>Servicio %1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln windows late</source>
        <translation>
            <numerusform>%Ln ventana tarde</numerusform>
            <numerusform>%Ln ventanas tarde</numerusform>
        </translation>
    </message>
    <message>
        <source>What Resume will do</source>
        <translation>Lo que hará la reanudación</translation>
    </message>
    <message>
        <source>What Start will do</source>
        <translation>Lo que hará el inicio</translation>
    </message>
    <message>
        <source>The service is working on it …</source>
        <translation>El servicio está en ello…</translation>
    </message>
    <message>
        <source>Nobody is logged in.</source>
        <translation>Nadie ha iniciado sesión.</translation>
    </message>
    <message>
        <source>Logged in: %1</source>
        <translation>Sesión: %1</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Hold to resume</source>
        <translation>Mantener pulsado</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Mantener pulsado</translation>
    </message>
    <message>
        <source>Start …</source>
        <translation>Iniciar…</translation>
    </message>
    <message>
        <source>Hold for one second. Then the machine moves.</source>
        <translation>Mantener pulsado un segundo. Entonces la máquina se mueve.</translation>
    </message>
    <message>
        <source>Shows what will happen first. Nothing moves yet.</source>
        <translation>Muestra qué ocurrirá primero. Todavía no se mueve nada.</translation>
    </message>
    <message>
        <source>Log in …</source>
        <translation>Iniciar sesión…</translation>
    </message>
    <message>
        <source>Change user …</source>
        <translation>Cambiar de usuario…</translation>
    </message>
    <message>
        <source>All machines</source>
        <translation>Todas las máquinas</translation>
    </message>
    <message>
        <source>Back to the board. The run goes on.</source>
        <translation>Volver al tablero. La ejecución continúa.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parada</translation>
    </message>
    <message>
        <source>Ends the run of this machine after the window in motion. It does not replace the machine&apos;s emergency stop.</source>
        <translation>Termina la ejecución de esta máquina tras la ventana en curso. No sustituye la parada de emergencia de la máquina.</translation>
    </message>
    <message>
        <source>The machine waits before the next window until you press Continue.</source>
        <translation>La máquina espera antes de la ventana siguiente hasta que se pulse Continuar.</translation>
    </message>
    <message>
        <source>Resume …</source>
        <translation>Reanudar…</translation>
    </message>
    <message>
        <source>&amp;Program</source>
        <translation>&amp;Programa</translation>
    </message>
    <message>
        <source>The service reads it in its folder of programs.</source>
        <translation>El servicio lo lee en su carpeta de programas.</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programa</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Cargar</translation>
    </message>
    <message>
        <source>The service reads the program and judges it. Nothing moves.</source>
        <translation>El servicio lee el programa y lo juzga. Nada se mueve.</translation>
    </message>
    <message>
        <source>This service has users: log in before you give it commands.</source>
        <translation>Un servicio con usuarios solo acepta órdenes de quien ha iniciado sesión.</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>P&amp;IN</source>
        <translation>P&amp;IN</translation>
    </message>
    <message>
        <source>A user of the service; empty: nobody.</source>
        <translation>Un usuario del servicio; vacío: nadie.</translation>
    </message>
    <message>
        <source>It is not kept.</source>
        <translation>No se guarda.</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Iniciar sesión</translation>
    </message>
    <message>
        <source>Connects again as this user.</source>
        <translation>Se conecta de nuevo como este usuario.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>These buttons act on %1. Those at the bottom of the window act on the machine that the window is connected with.</source>
        <translation>Estos botones actúan sobre %1. Los de la parte inferior de la ventana actúan sobre la máquina con la que está conectada la ventana.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>End here</source>
        <translation>Terminar aquí</translation>
    </message>
    <message>
        <source>Asks the control where the run was left. Nothing moves yet.</source>
        <translation>Pregunta al control dónde se interrumpió la ejecución. Todavía no se mueve nada.</translation>
    </message>
    <message>
        <source>choose or type a file in the folder of the service</source>
        <translation>elegir o escribir un archivo de la carpeta del servicio</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SetUpPage</name>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SignalPanel</name>
    <message>
        <source>Say what the columns of the file mean</source>
        <translation>Decir qué significan las columnas del archivo</translation>
    </message>
    <message>
        <source>Columns…</source>
        <translation>Columnas…</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>mostrado</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search the signals</source>
        <translation>Buscar una señal</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Señales</translation>
    </message>
    <message>
        <source>Pane</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Show the signal in a pane of its own (Enter)</source>
        <translation>Mostrar la señal en un panel propio (Intro)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Show the signal in the current pane (Shift+Enter)</source>
        <translation>Mostrar la señal en el panel actual (Mayús+Intro)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the signal from the panes (Delete)</source>
        <translation>No mostrar más la señal (Supr)</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Fórmula</translation>
    </message>
    <message>
        <source>A formula of signals, then Enter. Their names are in their tool tips.</source>
        <translation>Una fórmula de señales, luego Intro. Sus nombres están en sus ayudas.</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::SpectrumPanel</name>
    <message>
        <source>Frequencies need the time axis: choose it under Compare.</source>
        <translation>Las frecuencias requieren el eje de tiempo: elegirlo en Comparar.</translation>
    </message>
    <message>
        <source>No curve is shown.</source>
        <translation>No se muestra ninguna curva.</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitud</translation>
    </message>
    <message>
        <source>Amplitude, %1</source>
        <translation>Amplitud, %1</translation>
    </message>
    <message>
        <source>Frequency, Hz</source>
        <translation>Frecuencia, Hz</translation>
    </message>
    <message>
        <source>Peak, Hz</source>
        <translation>Pico, Hz</translation>
    </message>
    <message>
        <source>Between the cursors: %1 samples, %2 Hz</source>
        <translation>Entre los cursores: %1 muestras, %2 Hz</translation>
    </message>
    <message>
        <source>In the time shown: %1 samples, %2 Hz</source>
        <translation>En el tiempo visible: %1 muestras, %2 Hz</translation>
    </message>
    <message>
        <source>The samples are not evenly spaced: values between them were interpolated.</source>
        <translation>Las muestras no son regulares: se han muestreado de nuevo las rectas entre ellas.</translation>
    </message>
    <message>
        <source>Curve whose frequencies are shown</source>
        <translation>Curva cuyas frecuencias se muestran</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>Peaks of the spectrum</source>
        <translation>Picos del espectro</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::StartSteps</name>
    <message>
        <source>Start a virtual machine</source>
        <translation>Iniciar una máquina virtual</translation>
    </message>
    <message>
        <source>Connect to a control …</source>
        <translation>Conectar con un control …</translation>
    </message>
    <message>
        <source>Open …</source>
        <translation>Abrir …</translation>
    </message>
    <message>
        <source>Live …</source>
        <translation>En vivo …</translation>
    </message>
    <message>
        <source>Points from a program or a sensor, while they are made</source>
        <translation>Puntos de un programa o de un sensor, mientras se generan</translation>
    </message>
    <message>
        <source>Three steps to a moving machine</source>
        <translation>Tres pasos hasta una máquina en movimiento</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Conectar</translation>
    </message>
    <message>
        <source>Your control by its address, or a virtual machine on this computer: the same program, and nothing real moves.</source>
        <translation>Su control por su dirección, o una máquina virtual en este ordenador: el mismo programa, y nada real se mueve.</translation>
    </message>
    <message>
        <source>Open a program</source>
        <translation>Abrir un programa</translation>
    </message>
    <message>
        <source>Any CAM program: SINUMERIK, ISO, LinuxCNC, Grbl, Heidenhain. Or the sample.</source>
        <translation>Cualquier programa CAM: SINUMERIK, ISO, LinuxCNC, Grbl, Heidenhain. O el ejemplo.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Start, below at the right, checks travel, tools and data rate, shows the first move, and waits for you.</source>
        <translation>Iniciar, abajo a la derecha, comprueba recorridos, herramientas y flujo de datos, muestra el primer movimiento y le espera.</translation>
    </message>
    <message>
        <source>Nothing moves before you hold Start.</source>
        <translation>Nada se mueve antes de que mantenga pulsado Iniciar.</translation>
    </message>
    <message>
        <source>Sample: %1</source>
        <translation>Ejemplo: %1</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::StopModel</name>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Duración</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
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
        <translation>Tarea</translation>
    </message>
    <message>
        <source>G code receiving</source>
        <translation>Recepción de código G</translation>
    </message>
    <message>
        <source>Interpreter</source>
        <translation>Intérprete</translation>
    </message>
    <message>
        <source>Discrete</source>
        <translation>Interpolación gruesa</translation>
    </message>
    <message>
        <source>Forward-looking</source>
        <translation>Anticipación</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolación</translation>
    </message>
    <message>
        <source>Position control</source>
        <translation>Control de posición</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Inicios</translation>
    </message>
    <message>
        <source>Data, ms</source>
        <translation>Datos, ms</translation>
    </message>
    <message>
        <source>Processor, ms</source>
        <translation>Procesador, ms</translation>
    </message>
    <message>
        <source>Mean, µs</source>
        <translation>Media, µs</translation>
    </message>
    <message>
        <source>Min, µs</source>
        <translation>Mín., µs</translation>
    </message>
    <message>
        <source>Max, µs</source>
        <translation>Máx., µs</translation>
    </message>
    <message>
        <source>Preempted</source>
        <translation>Desalojos</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Búfer</translation>
    </message>
    <message>
        <source>Open a recording of the tasks</source>
        <translation>Abrir un registro de las tareas</translation>
    </message>
    <message>
        <source>Save what the scheduler did</source>
        <translation>Guardar lo que hizo el planificador</translation>
    </message>
    <message>
        <source>Executes a program on virtual axes. No machine moves.</source>
        <translation>Ejecuta un programa en ejes virtuales. Ninguna máquina se mueve.</translation>
    </message>
    <message>
        <source>%1: %2, %3 set points</source>
        <translation>%1: %2, %3 consignas</translation>
    </message>
    <message>
        <source>%1 has ended: %2, %3 set points</source>
        <translation>%1 ha terminado: %2, %3 consignas</translation>
    </message>
    <message>
        <source>%1 was stopped: %2, %3 set points</source>
        <translation>%1 se detuvo: %2, %3 consignas</translation>
    </message>
    <message>
        <source>Recording %1: %2, %3 set points</source>
        <translation>Registro %1: %2, %3 consignas</translation>
    </message>
    <message>
        <source>Example</source>
        <translation>Ejemplo</translation>
    </message>
    <message>
        <source>Program that the tasks execute</source>
        <translation>Programa que ejecutan las tareas</translation>
    </message>
    <message>
        <source>Task dependency</source>
        <translation>Dependencia de tareas</translation>
    </message>
    <message>
        <source>Data flow</source>
        <translation>Flujo de datos</translation>
    </message>
    <message>
        <source>Earliest starvation</source>
        <translation>Carencia más próxima</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Constante</translation>
    </message>
    <message>
        <source>Which task gets the processor</source>
        <translation>Qué tarea obtiene el procesador</translation>
    </message>
    <message>
        <source>Processors: %1</source>
        <translation>Procesadores: %1</translation>
    </message>
    <message>
        <source>How many tasks run at a time</source>
        <translation>Cuántas tareas se ejecutan a la vez</translation>
    </message>
    <message>
        <source>Cycle %1 ms</source>
        <translation>Ciclo %1 ms</translation>
    </message>
    <message>
        <source>Cycle of position control</source>
        <translation>Ciclo del control de posición</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>Tiempo real</translation>
    </message>
    <message>
        <source>Position control comes before everything else on this computer</source>
        <translation>El control de posición va antes que todo lo demás en este ordenador</translation>
    </message>
    <message>
        <source>Without real time, other programs of this computer can delay position control.</source>
        <translation>Sin tiempo real, otros programas de este ordenador pueden retrasar el control de posición.</translation>
    </message>
    <message>
        <source>This computer does not allow real-time scheduling: position control runs like any other program, and others can delay it.</source>
        <translation>Este ordenador no permite el tiempo real: el control de posición se ejecuta como cualquier otro programa, y otros pueden retrasarlo.</translation>
    </message>
    <message>
        <source>Execute</source>
        <translation>Ejecutar</translation>
    </message>
    <message>
        <source>Execute the program in six tasks, on virtual axes</source>
        <translation>Ejecutar el programa en seis tareas, en ejes virtuales</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>End the tasks; the virtual axes stand</source>
        <translation>Terminar las tareas; los ejes virtuales se detienen</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>Open a recording of a scheduler</source>
        <translation>Abrir el registro de un planificador</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Tasks: starts, waiting for data and for a processor, time of a step</source>
        <translation>Tareas: inicios, espera de datos y de un procesador, duración de un paso</translation>
    </message>
    <message>
        <source>Levels of the buffers</source>
        <translation>Niveles de los búferes</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Tiempo, s</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TemplatePage</name>
    <message>
        <source>Save the template</source>
        <translation>Guardar la plantilla</translation>
    </message>
    <message>
        <source>NC programs (*.MPF *.mpf)</source>
        <translation>Programas CN (*.MPF *.mpf)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>No template: %1</source>
        <translation>Sin plantilla: %1</translation>
    </message>
    <message>
        <source>No template yet</source>
        <translation>Aún no hay plantilla</translation>
    </message>
    <message>
        <source>%1, layout number %2</source>
        <translation>%1, número de disposición %2</translation>
    </message>
    <message>
        <source>Flexible program</source>
        <translation>Programa flexible</translation>
    </message>
    <message>
        <source>Save the steps</source>
        <translation>Guardar los pasos</translation>
    </message>
    <message>
        <source>Steps to print…</source>
        <translation>Pasos para imprimir…</translation>
    </message>
    <message>
        <source>A page with the steps at the control, the rights, what the operator sees, and how it is taken back</source>
        <translation>Una hoja con los pasos en el control, los derechos, lo que ve el operador y cómo se deshace</translation>
    </message>
    <message>
        <source>R-parameters</source>
        <translation>Parámetros R</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TextPane</name>
    <message>
        <source>Lines with this text</source>
        <translation>Líneas con este texto</translation>
    </message>
    <message>
        <source>Search (Ctrl+F)</source>
        <translation>Buscar (Ctrl+F)</translation>
    </message>
    <message>
        <source>Search the program text</source>
        <translation>Buscar en el programa</translation>
    </message>
    <message>
        <source>Previous line with this text</source>
        <translation>Línea anterior con este texto</translation>
    </message>
    <message>
        <source>Next line with this text</source>
        <translation>Línea siguiente con este texto</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Go to a line (Ctrl+G)</source>
        <translation>Ir a una línea (Ctrl+G)</translation>
    </message>
    <message>
        <source>Go to line</source>
        <translation>Ir a la línea</translation>
    </message>
    <message>
        <source>Follow the run</source>
        <translation>Seguir la ejecución</translation>
    </message>
    <message>
        <source>The text shows the line that is being executed</source>
        <translation>El texto muestra la línea en ejecución</translation>
    </message>
    <message>
        <source>Previous part, or blocks that the control executes (Ctrl+Page Up)</source>
        <translation>Tramo anterior, o secuencias que ejecuta el control (Ctrl+Re Pág)</translation>
    </message>
    <message>
        <source>Next part, or blocks that the control executes (Ctrl+Page Down)</source>
        <translation>Tramo siguiente, o secuencias que ejecuta el control (Ctrl+Av Pág)</translation>
    </message>
    <message>
        <source>Run from here …</source>
        <translation>Ejecutar desde aquí…</translation>
    </message>
    <message>
        <source>Start at the chosen line. First it is shown what would move.</source>
        <translation>Iniciar en la línea elegida. Antes se muestra qué se movería.</translation>
    </message>
    <message>
        <source>Search the text (Ctrl+F), or go to a line (Ctrl+G)</source>
        <translation>Buscar en el texto (Ctrl+F) o ir a una línea (Ctrl+G)</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TimeStrip</name>
    <message>
        <source>Overview of the whole trace</source>
        <translation>Vista general del registro</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TracePage</name>
    <message>
        <source>Trigger</source>
        <translation>Disparo</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trayectoria</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
    <message>
        <source>Follow the newest samples</source>
        <translation>Seguir las muestras más recientes</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Cantidad</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>No samples yet</source>
        <translation>Aún no hay muestras</translation>
    </message>
    <message>
        <source>Live samples: read while the stream has time; short pauses may be missing from the curves</source>
        <translation>Muestras en vivo: se leen mientras la transmisión deja tiempo; en las curvas pueden faltar pausas cortas</translation>
    </message>
    <message>
        <source>The control&apos;s own trace: one sample every %1</source>
        <translation>Registro del control: una muestra cada %1</translation>
    </message>
    <message>
        <source>%1: pause %2</source>
        <translation>%1: pausa %2</translation>
    </message>
    <message>
        <source>Run of %1, %2. </source>
        <translation>Ejecución del %1, %2. </translation>
    </message>
    <message>
        <source>Open traces</source>
        <translation>Abrir registros</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Registros</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Todos los archivos</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>List</source>
        <translation>Lista</translation>
    </message>
    <message>
        <source>Open recordings and traces; several are shown on one time axis</source>
        <translation>Abrir grabaciones y registros; varios en un mismo eje de tiempo</translation>
    </message>
    <message>
        <source>Wheel: zoom. Drag: move. Ctrl and drag: zoom into a range. Click: cursor A. Shift and click: cursor B. Home: show all.</source>
        <translation>Rueda: ampliar. Arrastrar: mover. Ctrl y arrastrar: ampliar un intervalo. Clic: cursor A. Mayús y clic: cursor B. Inicio: mostrar todo.</translation>
    </message>
    <message>
        <source>Stops, signals and cursors beside the curves</source>
        <translation>Paradas, señales y cursores junto a las curvas</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Paradas</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Señales</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursores</translation>
    </message>
    <message>
        <source>%1: one sample every %2</source>
        <translation>%1: una muestra cada %2</translation>
    </message>
    <message>
        <source>Looking for stops …</source>
        <translation>Buscando paradas…</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Leyendo %1…</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>Samples as a table</source>
        <translation>Muestras como tabla</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Save what the panes show</source>
        <translation>Guardar lo que muestran los paneles</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>No se puede escribir %1. Elegir otra carpeta.</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Paneles</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Guardar…</translation>
    </message>
    <message>
        <source>Arrangements of panes that are kept by name</source>
        <translation>Disposiciones de paneles guardadas con un nombre</translation>
    </message>
    <message>
        <source>Save what the panes show: the samples as a table (CSV), or a picture (PNG, SVG, PDF)</source>
        <translation>Guardar lo que muestran los paneles: las muestras como tabla (CSV) o una imagen (PNG, SVG, PDF)</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Guardado: %1</translation>
    </message>
    <message>
        <source>Shown beside the panes</source>
        <translation>Mostrado junto a las curvas</translation>
    </message>
    <message>
        <source>Samples and events as HDF5</source>
        <translation>Muestras y eventos como HDF5</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TriggerPanel</name>
    <message>
        <source>The signal must go back this far before the trigger can fire again</source>
        <translation>La señal debe retroceder esto antes de que pueda dispararse otra vez</translation>
    </message>
    <message>
        <source>An armed trigger stops the live view when it fires and shows what was before and after</source>
        <translation>Un disparo armado detiene la vista en directo y muestra lo que hubo antes y después</translation>
    </message>
    <message>
        <source>Once: what was caught stays. Every time: the next one takes its place.</source>
        <translation>Una vez: lo capturado se queda. Cada vez: el siguiente ocupa su lugar.</translation>
    </message>
    <message>
        <source>How much is shown after the trigger</source>
        <translation>Cuánto se muestra después del disparo</translation>
    </message>
    <message>
        <source>How much is shown before the trigger</source>
        <translation>Cuánto se muestra antes del disparo</translation>
    </message>
    <message>
        <source>Upper end of the range</source>
        <translation>Extremo superior del intervalo</translation>
    </message>
    <message>
        <source>Lower end of the range</source>
        <translation>Extremo inferior del intervalo</translation>
    </message>
    <message>
        <source>Value at which the trigger fires</source>
        <translation>Valor en el que se dispara</translation>
    </message>
    <message>
        <source>What the trigger waits for</source>
        <translation>Qué espera el disparo</translation>
    </message>
    <message>
        <source>The signal that is watched during a run</source>
        <translation>La señal que se vigila durante una ejecución</translation>
    </message>
    <message>
        <source>every time (normal)</source>
        <translation>cada vez (normal)</translation>
    </message>
    <message>
        <source>once (single)</source>
        <translation>una vez (single)</translation>
    </message>
    <message>
        <source>an alarm comes</source>
        <translation>llega una alarma</translation>
    </message>
    <message>
        <source>a pause begins</source>
        <translation>empieza una pausa</translation>
    </message>
    <message>
        <source>it is outside the range</source>
        <translation>está fuera del intervalo</translation>
    </message>
    <message>
        <source>it is within the range</source>
        <translation>está dentro del intervalo</translation>
    </message>
    <message>
        <source>it is at the level or below</source>
        <translation>está en el nivel o debajo</translation>
    </message>
    <message>
        <source>it is at the level or above</source>
        <translation>está en el nivel o encima</translation>
    </message>
    <message>
        <source>it falls through the level</source>
        <translation>baja por el nivel</translation>
    </message>
    <message>
        <source>it rises through the level</source>
        <translation>sube por el nivel</translation>
    </message>
    <message>
        <source>Fires</source>
        <translation>Dispara</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Después</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Hysteresis</source>
        <translation>Histéresis</translation>
    </message>
    <message>
        <source>To</source>
        <translation>A</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Cuando</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Señal</translation>
    </message>
    <message>
        <source>Waiting for the next run</source>
        <translation>Espera la próxima ejecución</translation>
    </message>
    <message>
        <source>Waiting for the trigger</source>
        <translation>Espera el disparo</translation>
    </message>
    <message>
        <source>Triggered at %1. Waiting for the next</source>
        <translation>Disparado en %1. Espera el siguiente</translation>
    </message>
    <message>
        <source>Triggered: waiting for the time after it</source>
        <translation>Disparado: espera el tiempo posterior</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Sin armar</translation>
    </message>
    <message>
        <source>Triggered at %1. Cursor A is there.</source>
        <translation>Disparado en %1. Ahí está el cursor A.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armar</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Desarmar</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::TrustSheet</name>
    <message>
        <source>Is this the right machine?</source>
        <translation>¿Es la máquina correcta?</translation>
    </message>
    <message>
        <source>The machine shows another certificate</source>
        <translation>La máquina muestra otro certificado</translation>
    </message>
    <message>
        <source>The machine does not offer sufficient encryption</source>
        <translation>La máquina no ofrece un cifrado suficiente</translation>
    </message>
    <message>
        <source>This computer has not connected to it before. Compare the fingerprint with the one that the control shows. If they are equal, accept it: from then on, only this certificate is trusted at this address.</source>
        <translation>Este ordenador la encuentra por primera vez. Comparar la huella con la que muestra el control. Si son iguales, aceptar: desde entonces, en esta dirección solo se confía en este certificado.</translation>
    </message>
    <message>
        <source>Either somebody has renewed the certificate of the control, or another computer answers at its address and would get all commands. Ask who looks after the control. Do not connect if nobody has changed anything.</source>
        <translation>O alguien ha renovado el certificado del control, o en su dirección responde otro ordenador que recibiría todas las órdenes. Preguntar a quien cuida del control. No conectar si nadie ha cambiado nada.</translation>
    </message>
    <message>
        <source>Better: switch encryption on at the control, then connect again. What you allow here is remembered for this machine until you take it back, and is marked as long as it is connected.</source>
        <translation>Mejor: activar el cifrado en el control y volver a conectar. Lo que se permite aquí se recuerda para esta máquina hasta que se retire, y se señala mientras está conectada.</translation>
    </message>
    <message>
        <source>Until now this machine was connected encrypted. Somebody who stands between could hide the encryption.</source>
        <translation>Hasta ahora esta máquina se conectaba cifrada. Alguien en medio podría ocultar el cifrado.</translation>
    </message>
    <message>
        <source>Nothing that it offers lets this user in with an encrypted password.</source>
        <translation>Nada de lo que ofrece deja entrar a este usuario con una contraseña cifrada.</translation>
    </message>
    <message>
        <source>The certificate is not valid today, so it cannot be accepted. Set the clocks of both computers, or renew it on the control.</source>
        <translation>El certificado no es válido hoy y no puede aceptarse. Ajustar los relojes de ambos ordenadores, o renovarlo en el control.</translation>
    </message>
    <message>
        <source>not kept</source>
        <translation>no guardado</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Shown now</source>
        <translation>Mostrado ahora</translation>
    </message>
    <message>
        <source>Accepted before</source>
        <translation>Aceptado antes</translation>
    </message>
    <message>
        <source>Fingerprint (SHA-256)</source>
        <translation>Huella (SHA-256)</translation>
    </message>
    <message>
        <source>Issued to</source>
        <translation>Emitido para</translation>
    </message>
    <message>
        <source>Issued by</source>
        <translation>Emitido por</translation>
    </message>
    <message>
        <source>Application</source>
        <translation>Aplicación</translation>
    </message>
    <message>
        <source>Made for</source>
        <translation>Hecho para</translation>
    </message>
    <message>
        <source>%1: not for %2</source>
        <translation>%1: no para %2</translation>
    </message>
    <message>
        <source>Valid</source>
        <translation>Válido</translation>
    </message>
    <message>
        <source>The control has to trust this computer, too. On a SINUMERIK, switch on in the dialog of the OPC UA server that client certificates are accepted by themselves, connect, and switch it off again; or import the file of this computer&apos;s certificate there. Its fingerprint: %1</source>
        <translation>También el control debe confiar en este ordenador. En una SINUMERIK, activar en el diálogo del servidor OPC UA la aceptación automática de certificados de cliente, conectar y volver a desactivarla; o importar allí el archivo del certificado de este ordenador. Su huella: %1</translation>
    </message>
    <message>
        <source>Do not connect</source>
        <translation>No conectar</translation>
    </message>
    <message>
        <source>Save this computer&apos;s certificate …</source>
        <translation>Guardar el certificado de este ordenador…</translation>
    </message>
    <message>
        <source>Hold: allow and connect</source>
        <translation>Mantener: permitir y conectar</translation>
    </message>
    <message>
        <source>Hold: accept and connect</source>
        <translation>Mantener: aceptar y conectar</translation>
    </message>
    <message>
        <source>Hold it for one second, with the mouse, a finger or the space bar.</source>
        <translation>Mantener un segundo, con el ratón, un dedo o la barra espaciadora.</translation>
    </message>
    <message>
        <source>%1: the server says that it is %2</source>
        <translation>%1: el servidor dice que es %2</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UserButton</name>
    <message>
        <source>Locked: log in</source>
        <translation>Bloqueado: iniciar sesión</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Only Stop works. Log in with your PIN (Ctrl+L).</source>
        <translation>Solo funciona Parada. Iniciar sesión con el PIN propio (Ctrl+L).</translation>
    </message>
    <message>
        <source>Lock the window, or let somebody else in (Ctrl+L).</source>
        <translation>Bloquear la ventana, o dar paso a otra persona (Ctrl+L).</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UserModel</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>PIN</source>
        <translation>PIN</translation>
    </message>
    <message>
        <source>set</source>
        <translation>definido</translation>
    </message>
    <message>
        <source>none: user of this computer</source>
        <translation>ninguno: usuario de este ordenador</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::UsersPage</name>
    <message>
        <source>No users are set up: everybody at this window may do everything. To let operators start only what is released, add an engineer (name and PIN), then the operators.</source>
        <translation>No hay usuarios configurados: cualquiera puede hacerlo todo en esta ventana. Para que los operarios solo inicien lo aprobado, añadir un preparador (nombre y PIN) y después los operarios.</translation>
    </message>
    <message>
        <source>An operator starts what an engineer has released in the preflight, holds, stops and acknowledges. An engineer may do everything. In a locked window only Stop works. The user of this computer (%1) needs no PIN.</source>
        <translation>Un operario inicia lo que un preparador ha aprobado en la comprobación previa, suspende, para y acusa. Un preparador puede hacerlo todo. En una ventana bloqueada solo funciona Parada. El usuario de este ordenador (%1) no necesita PIN.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Función</translation>
    </message>
    <message>
        <source>PIN, at least 4 characters</source>
        <translation>PIN, al menos 4 caracteres</translation>
    </message>
    <message>
        <source>Lock the window if nobody touches it for</source>
        <translation>Bloquear la ventana si nadie la toca durante</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nunca</translation>
    </message>
    <message>
        <source> min</source>
        <translation> min</translation>
    </message>
    <message>
        <source>Add or change</source>
        <translation>Añadir o cambiar</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Users</source>
        <translation>Usuarios</translation>
    </message>
</context>
<context>
    <name>rivulet::widgets::WrongMotionBar</name>
    <message>
        <source>Stop the run</source>
        <translation>Parar la ejecución</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Acusar</translation>
    </message>
</context>
</TS>
