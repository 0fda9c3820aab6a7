; SPDX-FileCopyrightText: 2026 The Rivulet authors
; SPDX-License-Identifier: GPL-3.0-or-later

; Installs the programs for one user, without an administrator; they are found by their names from then on. Made by
; scripts/windows: makensis -DVERSION=… -DPROGRAMS=FOLDER -DLICENSE=… -DOUTPUT=…

Unicode true
Target amd64-unicode
!include LogicLib.nsh
!include StrFunc.nsh
!include WinMessages.nsh
${Using:StrFunc} StrLoc
${Using:StrFunc} UnStrRep

!define ENTRY "Software\Microsoft\Windows\CurrentVersion\Uninstall\Rivulet"

Name "Rivulet ${VERSION}"
OutFile "${OUTPUT}"
RequestExecutionLevel user
SetCompressor /SOLID lzma
InstallDir "$LOCALAPPDATA\Programs\Rivulet"
InstallDirRegKey HKCU "${ENTRY}" InstallLocation
Page license
Page directory
Page instfiles
LicenseData "${LICENSE}"
UninstPage uninstConfirm
UninstPage instfiles

; Programs that are started from now on get the new value.
!macro announcePath
  SendMessage ${HWND_BROADCAST} ${WM_SETTINGCHANGE} 0 "STR:Environment" /TIMEOUT=2000
!macroend

; A value that is longer than a text can be here is left as it is: else it would be cut.
Function addToPath
  ClearErrors
  ReadRegStr $0 HKCU Environment Path
  ${If} ${Errors}
    ; There is none, or it is too long.
    StrCpy $1 0
    ${Do}
      ClearErrors
      EnumRegValue $2 HKCU Environment $1
      ${If} ${Errors}
      ${OrIf} $2 == ""
        ${ExitDo}
      ${EndIf}
      ${If} $2 == "Path"
        Goto tooLong
      ${EndIf}
      IntOp $1 $1 + 1
    ${Loop}
    WriteRegExpandStr HKCU Environment Path "$INSTDIR"
    Return
  ${EndIf}
  ${StrLoc} $1 ";$0;" ";$INSTDIR;" ">"
  ${If} $1 != ""
    Return
  ${EndIf}
  StrLen $1 "$0"
  StrLen $2 "$INSTDIR"
  IntOp $1 $1 + $2
  IntOp $1 $1 + 4
  ${If} $1 >= ${NSIS_MAX_STRLEN}
    Goto tooLong
  ${EndIf}
  ${If} $0 == ""
    WriteRegExpandStr HKCU Environment Path "$INSTDIR"
  ${Else}
    WriteRegExpandStr HKCU Environment Path "$0;$INSTDIR"
  ${EndIf}
  Return
tooLong:
  DetailPrint "The variable Path of this user is too long to be changed here. Add $INSTDIR by hand."
FunctionEnd

Function un.removeFromPath
  ClearErrors
  ReadRegStr $0 HKCU Environment Path
  ${If} ${Errors}
    Return
  ${EndIf}
  StrLen $1 "$0"
  IntOp $1 $1 + 4
  ${If} $1 >= ${NSIS_MAX_STRLEN}
    Return
  ${EndIf}
  ${UnStrRep} $1 ";$0;" ";$INSTDIR;" ";"
  ${If} $1 == ";$0;"
    Return
  ${EndIf}
  ${If} $1 == ";"
    DeleteRegValue HKCU Environment Path
    Return
  ${EndIf}
  StrCpy $1 $1 -1 1
  WriteRegExpandStr HKCU Environment Path "$1"
FunctionEnd

Section
  SetOutPath "$INSTDIR"
  File "${PROGRAMS}/*.exe"
  File "/oname=LICENSE.txt" "${LICENSE}"
  WriteUninstaller "$INSTDIR\uninstall.exe"
  WriteRegStr HKCU "${ENTRY}" DisplayName "Rivulet"
  WriteRegStr HKCU "${ENTRY}" DisplayVersion "${VERSION}"
  WriteRegStr HKCU "${ENTRY}" InstallLocation "$INSTDIR"
  WriteRegStr HKCU "${ENTRY}" UninstallString '"$INSTDIR\uninstall.exe"'
  WriteRegStr HKCU "${ENTRY}" QuietUninstallString '"$INSTDIR\uninstall.exe" /S'
  WriteRegDWORD HKCU "${ENTRY}" NoModify 1
  WriteRegDWORD HKCU "${ENTRY}" NoRepair 1
  Call addToPath
  !insertmacro announcePath
SectionEnd

; What a user has recorded, and the settings, stay.
Section Uninstall
  Delete "$INSTDIR\rivulet-*.exe"
  Delete "$INSTDIR\LICENSE.txt"
  Delete "$INSTDIR\uninstall.exe"
  RMDir "$INSTDIR"
  DeleteRegKey HKCU "${ENTRY}"
  Call un.removeFromPath
  !insertmacro announcePath
SectionEnd
