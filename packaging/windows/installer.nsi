; The installer of Gearwright for Windows: the folder of the zip, links in the start menu, the user's PATH.
;
;   makensis -DVERSION=0.1.0 -DFOLDER=gearwright-0.1.0-windows-x86_64 -DOUTPUT=setup.exe installer.nsi
;
; It installs for the current user, so it needs no administrator. `setup.exe /S` installs without windows,
; `/D=C:\folder` (last, without quotes) into another folder, and `uninstall.exe /S` removes it again.
; `/NOPATH` leaves PATH as it is.

; The program needs a 64-bit Windows, and so does its installer.
Target amd64-unicode
!include MUI2.nsh
!include FileFunc.nsh
!include LogicLib.nsh
!include StrFunc.nsh
!include WinMessages.nsh
${StrStr}
${UnStrRep}

!define KEY "Software\Microsoft\Windows\CurrentVersion\Uninstall\Gearwright"
; A variable of NSIS contains fewer characters than a PATH may have. A longer PATH is not changed.
!define PATH_MAX_CHANGED 900

Name "Gearwright ${VERSION}"
OutFile "${OUTPUT}"
InstallDir "$LOCALAPPDATA\Programs\Gearwright"
InstallDirRegKey HKCU "${KEY}" "InstallLocation"
RequestExecutionLevel user
SetCompressor /SOLID lzma
VIProductVersion "${VERSION}.0"
VIAddVersionKey ProductName "Gearwright"
VIAddVersionKey ProductVersion "${VERSION}"
VIAddVersionKey FileVersion "${VERSION}"
VIAddVersionKey FileDescription "Gearwright: design, check and export cylindrical gears"
VIAddVersionKey LegalCopyright "The Gearwright developers"

!insertmacro MUI_PAGE_LICENSE "${FOLDER}/LICENSE"
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"

; $1 is true if the user has a PATH variable. $0 contains its text, or is empty if it is too long to be
; read.
!macro READ_PATH
  ClearErrors
  ReadRegStr $0 HKCU "Environment" "Path"
  StrCpy $1 0
  StrCpy $2 0
  ${Do}
    EnumRegValue $3 HKCU "Environment" $2
    ${If} $3 == "Path"
      StrCpy $1 1
    ${EndIf}
    IntOp $2 $2 + 1
  ${LoopUntil} $3 == ""
!macroend

!macro ANNOUNCE_PATH
  SendMessage ${HWND_BROADCAST} ${WM_SETTINGCHANGE} 0 "STR:Environment" /TIMEOUT=2000
!macroend

Section
  ; An older version in this folder is removed by its own uninstaller, which deletes only the files that it
  ; installed. Other files in the folder belong to the user.
  ReadRegStr $0 HKCU "${KEY}" "InstallLocation"
  ${If} $0 == $INSTDIR
  ${AndIf} ${FileExists} "$INSTDIR\uninstall.exe"
    ExecWait '"$INSTDIR\uninstall.exe" /S _?=$INSTDIR'
  ${EndIf}
  SetOutPath "$INSTDIR"
  File /r "${FOLDER}/*"
  WriteUninstaller "$INSTDIR\uninstall.exe"

  CreateDirectory "$SMPROGRAMS\Gearwright"
  ${If} ${FileExists} "$INSTDIR\gearwright.html"
    CreateShortcut "$SMPROGRAMS\Gearwright\Gearwright page.lnk" "$INSTDIR\gearwright.html"
  ${EndIf}
  CreateShortcut "$SMPROGRAMS\Gearwright\Examples.lnk" "$INSTDIR\examples"
  ; The console starts in the user's documents, because the program writes next to the spec.
  SetOutPath "$DOCUMENTS"
  CreateShortcut "$SMPROGRAMS\Gearwright\Gearwright console.lnk" "$SYSDIR\cmd.exe" \
    '/k set "PATH=$INSTDIR;%PATH%" && gearwright --version'
  SetOutPath "$INSTDIR"
  CreateShortcut "$SMPROGRAMS\Gearwright\Uninstall.lnk" "$INSTDIR\uninstall.exe"

  WriteRegStr HKCU "${KEY}" "DisplayName" "Gearwright"
  WriteRegStr HKCU "${KEY}" "DisplayVersion" "${VERSION}"
  WriteRegStr HKCU "${KEY}" "Publisher" "The Gearwright developers"
  WriteRegStr HKCU "${KEY}" "DisplayIcon" "$INSTDIR\gearwright.exe"
  WriteRegStr HKCU "${KEY}" "InstallLocation" "$INSTDIR"
  WriteRegStr HKCU "${KEY}" "UninstallString" '"$INSTDIR\uninstall.exe"'
  WriteRegStr HKCU "${KEY}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
  WriteRegDWORD HKCU "${KEY}" "NoModify" 1
  WriteRegDWORD HKCU "${KEY}" "NoRepair" 1

  ${GetParameters} $4
  ClearErrors
  ${GetOptions} $4 "/NOPATH" $5
  ${IfNot} ${Errors}
    Return
  ${EndIf}
  !insertmacro READ_PATH
  StrLen $2 $0
  ${If} $1 = 0
    WriteRegExpandStr HKCU "Environment" "Path" "$INSTDIR"
  ${ElseIf} $2 = 0
  ${OrIf} $2 > ${PATH_MAX_CHANGED}
    MessageBox MB_OK|MB_ICONINFORMATION "Your PATH is too long for this installer to change. Add $INSTDIR to it \
      yourself to start gearwright from any console, or use the console in the start menu." /SD IDOK
    Return
  ${Else}
    ${StrStr} $3 ";$0;" ";$INSTDIR;"
    ${If} $3 != ""
      Return
    ${EndIf}
    WriteRegExpandStr HKCU "Environment" "Path" "$0;$INSTDIR"
  ${EndIf}
  !insertmacro ANNOUNCE_PATH
SectionEnd

Section "Uninstall"
  ; The list of files was made with the installer. Other files in the folder belong to the user.
  !include "${FILES}"
  Delete "$INSTDIR\uninstall.exe"
  RMDir "$INSTDIR"
  Delete "$SMPROGRAMS\Gearwright\*.lnk"
  RMDir "$SMPROGRAMS\Gearwright"
  DeleteRegKey HKCU "${KEY}"

  !insertmacro READ_PATH
  StrLen $2 $0
  ${If} $2 > 0
  ${AndIf} $2 <= ${PATH_MAX_CHANGED}
    ${UnStrRep} $3 ";$0;" ";$INSTDIR;" ";"
    ${If} $3 != ";$0;"
      StrCpy $3 $3 -1 1
      ${If} $3 == ""
        DeleteRegValue HKCU "Environment" "Path"
      ${Else}
        WriteRegExpandStr HKCU "Environment" "Path" $3
      ${EndIf}
      !insertmacro ANNOUNCE_PATH
    ${EndIf}
  ${EndIf}
SectionEnd
