<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
 <name>goniolux::gui::AccuracyPanel</name>
 <message><source>Accuracy</source><translation>Genauigkeit</translation></message>
 <message><source>Predicted time</source><translation>Voraussichtliche Zeit</translation></message>
 <message><source>Solver</source><translation>Löser</translation></message>
 <message><source>Wavelengths</source><translation>Wellenlängen</translation></message>
 <message><source>Predict the times</source><translation>Zeiten vorhersagen</translation></message>
 <message><source>Tries each accuracy coarsely; takes some seconds</source><translation>Probiert jede Genauigkeit grob; dauert einige Sekunden</translation></message>
 <message><source>What the planner would leave out, and why it chooses as it does, appears here.</source><translation>Hier steht, was der Planer weglassen würde und warum er so wählt.</translation></message>
 <message><source>being predicted</source><translation>wird vorhergesagt</translation></message>
 <message><source>Predict the time for %1</source><translation>Zeit für %1 vorhersagen</translation></message>
 <message><source>about %1</source><translation>etwa %1</translation></message>
 <message><source>At ± %1</source><translation>Bei ± %1</translation></message>
 <message><source>Left out:</source><translation>Weggelassen:</translation></message>
 <message><source>: at most %1 %2</source><translation>: höchstens %1 %2</translation></message>
 <message><source>Because:</source><translation>Weil:</translation></message>
 <message><source>Work–precision chart</source><translation>Aufwand-Genauigkeit-Diagramm</translation></message>
 <message><source>Calculates the project by every solver at several accuracies, against a long reference: what accuracy costs here. Again, it goes on where it ended.</source><translation>Berechnet das Projekt mit jedem Löser in mehreren Genauigkeiten gegen eine lange Vergleichsrechnung: was Genauigkeit hier kostet. Noch einmal gedrückt, geht es weiter.</translation></message>
 <message><source>Time for the chart</source><translation>Zeit für das Diagramm</translation></message>
 <message><source>What accuracy costs in this project appears here.</source><translation>Hier steht, was Genauigkeit in diesem Projekt kostet.</translation></message>
 <message><source>Left out, and why</source><translation>Weggelassen, und warum</translation></message>
 <message><source>Work–precision</source><translation>Aufwand–Genauigkeit</translation></message>
 <message><source>Double click: calculate with this accuracy from now on</source><translation>Doppelklick: von nun an mit dieser Genauigkeit rechnen</translation></message>
</context>
<context>
 <name>goniolux::gui::Document</name>
 <message><source>The project's text is no valid JSON at the moment; mend it in the text panel first.</source><translation>Der Text des Projekts ist im Augenblick kein gültiges JSON; berichtigen Sie ihn zuerst im Textfenster.</translation></message>
</context>
<context>
 <name>goniolux::gui::Field</name>
 <message><source>as usual</source><translation>wie üblich</translation></message>
 <message><source>%1 (as usual)</source><translation>%1 (wie üblich)</translation></message>
 <message><source>yes</source><translation>ja</translation></message>
 <message><source>no</source><translation>nein</translation></message>
 <message><source>Choose a file</source><translation>Datei wählen</translation></message>
 <message><source>Photometric files (*.ies *.IES *.ldt *.LDT *.xml);;All files (*)</source><translation>Photometrische Dateien (*.ies *.IES *.ldt *.LDT *.xml);;Alle Dateien (*)</translation></message>
 <message><source>All files (*)</source><translation>Alle Dateien (*)</translation></message>
 <message><source>different values</source><translation>verschiedene Werte</translation></message>
</context>
<context>
 <name>goniolux::gui::ImageCanvas</name>
 <message><source>Rendered picture</source><translation>Berechnetes Bild</translation></message>
 <message><source>Choose a view and press Render.</source><translation>Wählen Sie eine Ansicht und drücken Sie „Bild berechnen“.</translation></message>
</context>
<context>
 <name>goniolux::gui::Job</name>
 <message><source>There is not enough memory for this; ask for less accuracy, fewer points or a smaller picture.</source><translation>Der Speicher reicht dafür nicht; verlangen Sie weniger Genauigkeit, weniger Punkte oder ein kleineres Bild.</translation></message>
</context>
<context>
 <name>goniolux::gui::JobsPanel</name>
 <message><source>waiting</source><translation>wartet</translation></message>
 <message><source>paused at %1 %</source><translation>angehalten bei %1 %</translation></message>
 <message><source>done</source><translation>fertig</translation></message>
 <message><source>stopped</source><translation>abgebrochen</translation></message>
 <message><source>failed</source><translation>gescheitert</translation></message>
 <message><source>Job</source><translation>Auftrag</translation></message>
 <message><source>State</source><translation>Stand</translation></message>
 <message><source>Time</source><translation>Zeit</translation></message>
 <message><source>Left</source><translation>Noch</translation></message>
 <message><source>What is reached</source><translation>Was erreicht ist</translation></message>
 <message><source>Messages of the engine appear here.</source><translation>Hier erscheinen Meldungen der Berechnung.</translation></message>
 <message><source>%1: %2 (%3)</source><translation>%1: %2 (%3)</translation></message>
 <message><source>%1 failed: %2</source><translation>%1 ist gescheitert: %2</translation></message>
 <message><source>Stop</source><translation>Abbrechen</translation></message>
 <message><source>Copy as command line</source><translation>Als Befehlszeile kopieren</translation></message>
</context>
<context>
 <name>goniolux::gui::Legend</name>
 <message><source>Illuminance</source><translation>Beleuchtungsstärke</translation></message>
 <message><source>in %1</source><translation>in %1</translation></message>
</context>
<context>
 <name>goniolux::gui::LuminairePage</name>
 <message><source> File  </source><translation> Datei  </translation></message>
 <message><source>Import …</source><translation>Einlesen …</translation></message>
 <message><source>Copies a photometric file into the project; or drop it on the window</source><translation>Kopiert eine photometrische Datei in das Projekt; oder ziehen Sie sie auf das Fenster</translation></message>
 <message><source>Use for selection</source><translation>Für Auswahl verwenden</translation></message>
 <message><source>The selected luminaires get this photometry</source><translation>Die ausgewählten Leuchten bekommen diese Photometrie</translation></message>
 <message><source>Replace everywhere</source><translation>Überall ersetzen</translation></message>
 <message><source>All luminaires with the selected one's photometry get this one</source><translation>Alle Leuchten mit der Photometrie der ausgewählten bekommen diese</translation></message>
 <message><source>Choose a photometric file.</source><translation>Wählen Sie eine photometrische Datei.</translation></message>
 <message><source>Polar</source><translation>Polar</translation></message>
 <message><source>Photometric solid</source><translation>Lichtverteilungskörper</translation></message>
 <message><source>Cartesian</source><translation>Kartesisch</translation></message>
</context>
<context>
 <name>goniolux::gui::MainWindow</name>
 <message><source>Room</source><translation>Raum</translation></message>
 <message><source>Illuminance</source><translation>Beleuchtungsstärke</translation></message>
 <message><source>Picture</source><translation>Bild</translation></message>
 <message><source>Luminaire</source><translation>Leuchte</translation></message>
 <message><source>Spectra</source><translation>Spektren</translation></message>
 <message><source>Project</source><translation>Projekt</translation></message>
 <message><source>Properties</source><translation>Eigenschaften</translation></message>
 <message><source>Results</source><translation>Ergebnisse</translation></message>
 <message><source>Problems</source><translation>Probleme</translation></message>
 <message><source>Jobs and log</source><translation>Aufträge und Protokoll</translation></message>
 <message><source>Project text</source><translation>Projekttext</translation></message>
 <message><source>Accuracy</source><translation>Genauigkeit</translation></message>
 <message><source>Change the accuracy of pictures</source><translation>Genauigkeit der Bilder ändern</translation></message>
 <message><source>Change the accuracy</source><translation>Genauigkeit ändern</translation></message>
 <message><source>%1 failed</source><translation>%1 ist gescheitert</translation></message>
 <message><source>&amp;File</source><translation>&amp;Datei</translation></message>
 <message><source>&amp;New room …</source><translation>&amp;Neuer Raum …</translation></message>
 <message><source>&amp;Open …</source><translation>Ö&amp;ffnen …</translation></message>
 <message><source>&amp;Save</source><translation>&amp;Speichern</translation></message>
 <message><source>Save &amp;as …</source><translation>Speichern &amp;unter …</translation></message>
 <message><source>&amp;Import</source><translation>&amp;Einlesen</translation></message>
 <message><source>Photometric file …</source><translation>Photometrische Datei …</translation></message>
 <message><source>Model (OBJ, PLY, STL, glTF) …</source><translation>Modell (OBJ, PLY, STL, glTF) …</translation></message>
 <message><source>&amp;Export</source><translation>&amp;Ausgeben</translation></message>
 <message><source>Results as CSV …</source><translation>Ergebnisse als CSV …</translation></message>
 <message><source>Illuminance plot as PNG or PDF …</source><translation>Beleuchtungsstärkeplan als PNG oder PDF …</translation></message>
 <message><source>Picture as PNG or OpenEXR …</source><translation>Bild als PNG oder OpenEXR …</translation></message>
 <message><source>3-D view as PNG …</source><translation>3-D-Ansicht als PNG …</translation></message>
 <message><source>&amp;Close project</source><translation>Projekt s&amp;chließen</translation></message>
 <message><source>&amp;Quit</source><translation>&amp;Beenden</translation></message>
 <message><source>&amp;Edit</source><translation>&amp;Bearbeiten</translation></message>
 <message><source>&amp;Undo</source><translation>&amp;Rückgängig</translation></message>
 <message><source>&amp;Redo</source><translation>&amp;Wiederholen</translation></message>
 <message><source>&amp;Duplicate</source><translation>&amp;Verdoppeln</translation></message>
 <message><source>&amp;Remove</source><translation>&amp;Entfernen</translation></message>
 <message><source>&amp;Add</source><translation>&amp;Hinzufügen</translation></message>
 <message><source>Object</source><translation>Objekt</translation></message>
 <message><source>Material</source><translation>Material</translation></message>
 <message><source>Grid</source><translation>Raster</translation></message>
 <message><source>Observer</source><translation>Beobachter</translation></message>
 <message><source>View</source><translation>Ansicht</translation></message>
 <message><source>Requirement</source><translation>Anforderung</translation></message>
 <message><source>&amp;Calculation</source><translation>B&amp;erechnung</translation></message>
 <message><source>&amp;Calculate</source><translation>&amp;Berechnen</translation></message>
 <message><source>&amp;Pause</source><translation>&amp;Anhalten</translation></message>
 <message><source>&amp;Render the chosen view</source><translation>Bild der gewählten Ansicht berechnen</translation></message>
 <message><source>&amp;Copy as command line</source><translation>Als Befehlszeile &amp;kopieren</translation></message>
 <message><source>The last job as a command of goniolux that does the same</source><translation>Der letzte Auftrag als Befehl von goniolux, der dasselbe tut</translation></message>
 <message><source>&amp;Stop</source><translation>A&amp;bbrechen</translation></message>
 <message><source>&amp;View</source><translation>&amp;Ansicht</translation></message>
 <message><source>&amp;Panels</source><translation>&amp;Fenster</translation></message>
 <message><source>&amp;Theme</source><translation>&amp;Farben</translation></message>
 <message><source>Light</source><translation>Hell</translation></message>
 <message><source>Dark</source><translation>Dunkel</translation></message>
 <message><source>&amp;Language</source><translation>&amp;Sprache</translation></message>
 <message><source>The language changes when the program is started again.</source><translation>Die Sprache ändert sich, wenn das Programm neu gestartet wird.</translation></message>
 <message><source>Main toolbar</source><translation>Werkzeugleiste</translation></message>
 <message><source>&amp;Help</source><translation>&amp;Hilfe</translation></message>
 <message><source>&amp;About Goniolux Studio</source><translation>&amp;Über Goniolux Studio</translation></message>
 <message><source>About Goniolux Studio</source><translation>Über Goniolux Studio</translation></message>
 <message><source>&lt;b&gt;Goniolux Studio %1&lt;/b&gt;&lt;p&gt;Calculates the light in a room. Every number comes with an interval that holds the exact answer at the stated confidence.&lt;/p&gt;</source><translation>&lt;b&gt;Goniolux Studio %1&lt;/b&gt;&lt;p&gt;Berechnet das Licht in einem Raum. Zu jeder Zahl gehört ein Intervall, das die genaue Antwort mit der angegebenen Sicherheit enthält.&lt;/p&gt;</translation></message>
 <message><source> Accuracy  </source><translation> Genauigkeit  </translation></message>
 <message><source>Accuracy of illuminances</source><translation>Genauigkeit der Beleuchtungsstärken</translation></message>
 <message><source>The half-width that you are content with: at 95 % confidence the mean, the minimum and 95 % of the points of every grid are known to this share of their value.</source><translation>Die halbe Breite, die Ihnen genügt: Mit 95 % Sicherheit sind Mittelwert, kleinster Wert und 95 % der Punkte jedes Rasters auf diesen Anteil genau bekannt.</translation></message>
 <message><source>New room</source><translation>Neuer Raum</translation></message>
 <message><source>The file cannot be imported</source><translation>Die Datei kann nicht eingelesen werden</translation></message>
 <message><source>%1 is in the project's folder; select luminaires and press “Use for selection”.</source><translation>%1 liegt im Ordner des Projekts; wählen Sie Leuchten aus und drücken Sie „Für Auswahl verwenden“.</translation></message>
 <message><source>Select luminaires in the project first.</source><translation>Wählen Sie zuerst Leuchten im Projekt aus.</translation></message>
 <message><source>Replace the photometry</source><translation>Photometrie ersetzen</translation></message>
 <message><source>Import a photometric file</source><translation>Photometrische Datei einlesen</translation></message>
 <message><source>Photometric files (*.ies *.IES *.ldt *.LDT *.xml);;All files (*)</source><translation>Photometrische Dateien (*.ies *.IES *.ldt *.LDT *.xml);;Alle Dateien (*)</translation></message>
 <message><source>Import a model</source><translation>Modell einlesen</translation></message>
 <message><source>Models (*.obj *.ply *.stl *.gltf *.glb *.rad);;All files (*)</source><translation>Modelle (*.obj *.ply *.stl *.gltf *.glb *.rad);;Alle Dateien (*)</translation></message>
 <message><source>Import %1</source><translation>%1 einlesen</translation></message>
 <message><source>Comma-separated values (*.csv)</source><translation>Kommagetrennte Werte (*.csv)</translation></message>
 <message><source>PNG picture (*.png);;PDF page (*.pdf)</source><translation>PNG-Bild (*.png);;PDF-Seite (*.pdf)</translation></message>
 <message><source>PNG picture (*.png);;OpenEXR, calibrated (*.exr)</source><translation>PNG-Bild (*.png);;OpenEXR, kalibriert (*.exr)</translation></message>
 <message><source>PNG picture (*.png)</source><translation>PNG-Bild (*.png)</translation></message>
 <message><source>Export</source><translation>Ausgeben</translation></message>
 <message><source>There are no results; calculate first.</source><translation>Es gibt keine Ergebnisse; berechnen Sie zuerst.</translation></message>
 <message><source>There is no finished picture; render first.</source><translation>Es gibt kein fertiges Bild; berechnen Sie zuerst eines.</translation></message>
 <message><source>Export %1</source><translation>%1 ausgeben</translation></message>
 <message><source>Nothing was exported</source><translation>Nichts wurde ausgegeben</translation></message>
 <message><source>Written: %1</source><translation>Geschrieben: %1</translation></message>
 <message><source>Unsaved changes were kept</source><translation>Ungespeicherte Änderungen sind erhalten</translation></message>
 <message><source>Goniolux Studio was ended while “%1” had unsaved changes. Go on with them?</source><translation>Goniolux Studio wurde beendet, während „%1“ ungespeicherte Änderungen hatte. Damit weiterarbeiten?</translation></message>
 <message><source>Calculate the grids</source><translation>Raster berechnen</translation></message>
 <message><source>Render “%1”</source><translation>Bild „%1“ berechnen</translation></message>
 <message><source>Copied: %1</source><translation>Kopiert: %1</translation></message>
 <message><source>Nothing has been calculated yet.</source><translation>Noch ist nichts berechnet.</translation></message>
 <message><source>Look for earlier results</source><translation>Frühere Ergebnisse suchen</translation></message>
 <message><source>Write the results</source><translation>Ergebnisse schreiben</translation></message>
 <message><source>  (about %1 left)</source><translation>  (noch etwa %1)</translation></message>
 <message><source>The project cannot be opened</source><translation>Das Projekt kann nicht geöffnet werden</translation></message>
 <message><source>Open a project</source><translation>Projekt öffnen</translation></message>
 <message><source>Goniolux projects (project.json *.json);;All files (*)</source><translation>Goniolux-Projekte (project.json *.json);;Alle Dateien (*)</translation></message>
 <message numerus="yes"><source>%n error(s)</source><translation><numerusform>%n Fehler</numerusform><numerusform>%n Fehler</numerusform></translation></message>
 <message numerus="yes"><source>%n warning(s)</source><translation><numerusform>%n Warnung</numerusform><numerusform>%n Warnungen</numerusform></translation></message>
 <message><source>no problems</source><translation>keine Probleme</translation></message>
 <message><source>Saved.</source><translation>Gespeichert.</translation></message>
 <message><source>The project cannot be saved</source><translation>Das Projekt kann nicht gespeichert werden</translation></message>
 <message><source>Folder for the project</source><translation>Ordner für das Projekt</translation></message>
 <message><source>Unsaved changes</source><translation>Ungespeicherte Änderungen</translation></message>
 <message><source>“%1” has changes that are not saved. Save them?</source><translation>„%1“ hat Änderungen, die nicht gespeichert sind. Speichern?</translation></message>
 <message><source>Cu&amp;t</source><translation>&amp;Ausschneiden</translation></message>
 <message><source>&amp;Copy</source><translation>&amp;Kopieren</translation></message>
 <message><source>&amp;Paste</source><translation>&amp;Einfügen</translation></message>
 <message><source>Report as PDF or HTML …</source><translation>Bericht als PDF oder HTML …</translation></message>
 <message><source>Report</source><translation>Bericht</translation></message>
 <message><source>PDF document (*.pdf);;Web page (*.html)</source><translation>PDF-Dokument (*.pdf);;Webseite (*.html)</translation></message>
 <message><source>&amp;Documentation</source><translation>&amp;Dokumentation</translation></message>
 <message><source>The documentation cannot be opened</source><translation>Die Dokumentation lässt sich nicht öffnen</translation></message>
 <message><source>Move</source><translation>Verschieben</translation></message>
 <message><source>Turn</source><translation>Drehen</translation></message>
 <message><source>Predict the times …</source><translation>Zeiten vorhersagen …</translation></message>
 <message><source>There is no plot yet; calculate first.</source><translation>Es gibt noch keine Darstellung; rechnen Sie zuerst.</translation></message>
 <message><source>%1 cannot be written; choose another folder or ending.</source><translation>%1 kann nicht geschrieben werden; wählen Sie einen anderen Ordner oder eine andere Endung.</translation></message>
 <message><source>It is not installed; it is the folder docs of Goniolux.</source><translation>Sie ist nicht installiert; es ist der Ordner docs von Goniolux.</translation></message>
 <message><source>Open a project or make a room first; then drop the luminaire again.</source><translation>Öffnen Sie zuerst ein Projekt oder legen Sie einen Raum an; ziehen Sie die Leuchte dann noch einmal herein.</translation></message>
</context>
<context>
 <name>goniolux::gui::NewRoomDialog</name>
 <message><source>New room</source><translation>Neuer Raum</translation></message>
 <message><source>A rectangular room with luminaires in rows. Their number follows from the lumen method: a start that the calculation then checks.</source><translation>Ein rechteckiger Raum mit Leuchten in Reihen. Ihre Zahl folgt aus dem Wirkungsgradverfahren: ein Anfang, den die Berechnung dann prüft.</translation></message>
 <message><source>Length × width × height</source><translation>Länge × Breite × Höhe</translation></message>
 <message><source>Reflectance of ceiling, walls, floor</source><translation>Reflexionsgrad von Decke, Wänden, Boden</translation></message>
 <message><source>Photometric file</source><translation>Photometrische Datei</translation></message>
 <message><source>Photometric files (*.ies *.IES *.ldt *.LDT *.xml)</source><translation>Photometrische Dateien (*.ies *.IES *.ldt *.LDT *.xml)</translation></message>
 <message><source>Luminaire</source><translation>Leuchte</translation></message>
 <message><source>Mean illuminance, maintained</source><translation>Mittlere Beleuchtungsstärke, Wartungswert</translation></message>
 <message><source>Maintenance factor</source><translation>Wartungsfaktor</translation></message>
 <message><source>Height of the work plane</source><translation>Höhe der Nutzebene</translation></message>
 <message><source>Folder of the project</source><translation>Ordner des Projekts</translation></message>
 <message><source>Folder</source><translation>Ordner</translation></message>
 <message><source>Make the room</source><translation>Raum anlegen</translation></message>
</context>
<context>
 <name>goniolux::gui::PicturePage</name>
 <message><source> View  </source><translation> Ansicht  </translation></message>
 <message><source>  Accuracy  </source><translation>  Genauigkeit  </translation></message>
 <message><source>Half-width of the luminance of 95 % of the pixels</source><translation>Halbe Breite der Leuchtdichte von 95 % der Bildpunkte</translation></message>
 <message><source>Render</source><translation>Bild berechnen</translation></message>
 <message><source>Export …</source><translation>Ausgeben …</translation></message>
 <message><source>Display</source><translation>Anzeige</translation></message>
 <message><source>Device</source><translation>Gerät</translation></message>
 <message><source>How the luminances of the room become those of the display</source><translation>Wie die Leuchtdichten des Raumes zu denen der Anzeige werden</translation></message>
 <message><source>Luminance</source><translation>Leuchtdichte</translation></message>
 <message><source>Brighter or darker than the automatic exposure, in thirds of a stop</source><translation>Heller oder dunkler als die selbsttätige Belichtung, in Drittelblenden</translation></message>
 <message><source>Exposure</source><translation>Belichtung</translation></message>
 <message><source>Adapted to the room's light</source><translation>An das Licht des Raumes angepasst</translation></message>
 <message><source>The white of the room's light is shown as the display's white (CAT16), as the eye sees it.</source><translation>Das Weiß des Raumlichts wird als Weiß der Anzeige gezeigt (CAT16), wie das Auge es sieht.</translation></message>
 <message><source>Luminance meter</source><translation>Leuchtdichtemesser</translation></message>
 <message><source> px radius</source><translation> px Radius</translation></message>
 <message><source>Before and after</source><translation>Vorher und nachher</translation></message>
 <message><source>Moves the line between the earlier picture (left) and this one</source><translation>Verschiebt die Linie zwischen dem früheren Bild (links) und diesem</translation></message>
 <message><source>%1: %2 % of the pixels within ± %3 %%4</source><translation>%1: %2 % der Bildpunkte auf ± %3 % genau%4</translation></message>
 <message><source>, being refined</source><translation>, wird verfeinert</translation></message>
 <message><source>White is %1 cd/m². </source><translation>Weiß ist %1 cd/m². </translation></message>
 <message><source>Too bright: %1 %, too pure: %2 % of the pixels.</source><translation>Zu hell: %1 %, zu rein: %2 % der Bildpunkte.</translation></message>
 <message><source>Pixel</source><translation>Bildpunkt</translation></message>
 <message><source>CCT</source><translation>Farbtemp.</translation></message>
 <message><source>with spectra</source><translation>mit Spektren</translation></message>
 <message><source>The picture carries the spectral radiance of every pixel from 400 to 700 nm, for the meter: takes several times as long</source><translation>Das Bild trägt die spektrale Strahldichte jedes Bildpunkts von 400 bis 700 nm, für das Messgerät: dauert mehrmals so lange</translation></message>
 <message><source>Circle</source><translation>Kreis</translation></message>
 <message><source>Rectangle</source><translation>Rechteck</translation></message>
 <message><source>Polygon</source><translation>Vieleck</translation></message>
 <message><source>Point at the picture; a click stays there.</source><translation>Zeigen Sie ins Bild; ein Klick bleibt dort.</translation></message>
 <message><source>Drag over the picture.</source><translation>Ziehen Sie über das Bild.</translation></message>
 <message><source>Click the corners; a double click closes it, Escape takes it back.</source><translation>Klicken Sie die Ecken an; ein Doppelklick schließt, Esc nimmt es zurück.</translation></message>
 <message><source>What is measured: the mean of the pixels inside</source><translation>Was gemessen wird: das Mittel der Bildpunkte darin</translation></message>
 <message><source>Luminance L_v: luminous flux per projected area and solid angle (CIE S 017, 17-21-050). x, y: CIE 1931 chromaticity. CCT: temperature of the Planckian radiator whose chromaticity is the nearest (CIE S 017, 17-23-068).</source><translation>Leuchtdichte L_v: Lichtstrom je projizierter Fläche und Raumwinkel (CIE S 017, 17-21-050). x, y: Normfarbwertanteile CIE 1931. CCT: Temperatur des Planckschen Strahlers, dessen Farbart am nächsten liegt (CIE S 017, 17-23-068).</translation></message>
 <message><source>No spectrum here.</source><translation>Hier ist kein Spektrum.</translation></message>
 <message><source>Lowest, highest</source><translation>Kleinste, größte</translation></message>
 <message><source>Uniformity</source><translation>Gleichmäßigkeit</translation></message>
 <message><source>Pixels</source><translation>Bildpunkte</translation></message>
 <message><source>Spectral radiance</source><translation>Spektrale Strahldichte</translation></message>
 <message><source>wavelength / nm</source><translation>Wellenlänge / nm</translation></message>
 <message><source>where the meter points</source><translation>wo das Messgerät hinzeigt</translation></message>
</context>
<context>
 <name>goniolux::gui::PlanPage</name>
 <message><source>The grid that is shown</source><translation>Das gezeigte Raster</translation></message>
 <message><source> Grid  </source><translation> Raster  </translation></message>
 <message><source>  Colours  </source><translation>  Farben  </translation></message>
 <message><source>in bands</source><translation>in Stufen</translation></message>
 <message><source>smooth</source><translation>fließend</translation></message>
 <message><source>Export this plot …</source><translation>Diesen Plan ausgeben …</translation></message>
 <message><source>Draw a line in the plan with the mouse to see the values along it.</source><translation>Ziehen Sie mit der Maus eine Linie im Plan, um die Werte entlang ihr zu sehen.</translation></message>
 <message><source>Press Calculate to see how the values are spread.</source><translation>Drücken Sie Berechnen, um zu sehen, wie die Werte verteilt sind.</translation></message>
 <message><source>Section</source><translation>Schnitt</translation></message>
 <message><source>Histogram</source><translation>Häufigkeit</translation></message>
 <message><source>Values</source><translation>Werte</translation></message>
 <message><source>The line does not cross the grid.</source><translation>Die Linie schneidet das Raster nicht.</translation></message>
 <message><source>Values of the points</source><translation>Werte der Punkte</translation></message>
 <message><source>  Levels  </source><translation>  Stufen  </translation></message>
 <message><source>automatic</source><translation>automatisch</translation></message>
 <message><source>Values of the isolux lines, here and in the 3-D view, such as 100, 200, 300, 500; empty: chosen from the results</source><translation>Werte der Isoluxlinien, hier und in der 3-D-Ansicht, etwa 100, 200, 300, 500; leer: nach den Ergebnissen gewählt</translation></message>
</context>
<context>
 <name>goniolux::gui::PlanView</name>
 <message><source>Illuminance in plan</source><translation>Beleuchtungsstärke im Grundriss</translation></message>
 <message><source>Press Calculate to see the illuminance here.</source><translation>Drücken Sie „Berechnen“, um die Beleuchtungsstärke hier zu sehen.</translation></message>
 <message><source>not counted</source><translation>nicht gezählt</translation></message>
 <message><source>point %1, %2 m: %3</source><translation>Punkt %1, %2 m: %3</translation></message>
 <message><source>%1 cannot be written; choose another folder or ending.</source><translation>%1 kann nicht geschrieben werden; wählen Sie einen anderen Ordner oder eine andere Endung.</translation></message>
</context>
<context>
 <name>goniolux::gui::ProblemsPanel</name>
 <message><source>Problems</source><translation>Probleme</translation></message>
 <message><source>What is wrong, and what to do</source><translation>Was falsch ist und was zu tun ist</translation></message>
 <message><source>Place</source><translation>Stelle</translation></message>
</context>
<context>
 <name>goniolux::gui::ProjectTree</name>
 <message><source>Project</source><translation>Projekt</translation></message>
 <message><source>Objects</source><translation>Objekte</translation></message>
 <message><source>Materials</source><translation>Materialien</translation></message>
 <message><source>Luminaires</source><translation>Leuchten</translation></message>
 <message><source>Lighting scenes</source><translation>Lichtszenen</translation></message>
 <message><source>Grids</source><translation>Raster</translation></message>
 <message><source>Observers</source><translation>Beobachter</translation></message>
 <message><source>Views</source><translation>Ansichten</translation></message>
 <message><source>Requirements</source><translation>Anforderungen</translation></message>
 <message><source>Settings</source><translation>Einstellungen</translation></message>
 <message><source>Add %1</source><translation>%1 hinzufügen</translation></message>
 <message numerus="yes"><source>Duplicate %n entries</source><translation><numerusform>%n Eintrag verdoppeln</numerusform><numerusform>%n Einträge verdoppeln</numerusform></translation></message>
 <message numerus="yes"><source>Paste %n entries</source><translation><numerusform>%n Eintrag einfügen</numerusform><numerusform>%n Einträge einfügen</numerusform></translation></message>
 <message numerus="yes"><source>Remove %n entries</source><translation><numerusform>%n Eintrag entfernen</numerusform><numerusform>%n Einträge entfernen</numerusform></translation></message>
 <message><source>Add</source><translation>Hinzufügen</translation></message>
 <message><source>Duplicate</source><translation>Verdoppeln</translation></message>
 <message><source>Remove</source><translation>Entfernen</translation></message>
 <message><source>Copy</source><translation>Kopieren</translation></message>
 <message><source>Paste</source><translation>Einfügen</translation></message>
</context>
<context>
 <name>goniolux::gui::PropertyPanel</name>
 <message numerus="yes"><source>%n entries</source><translation><numerusform>%n Eintrag</numerusform><numerusform>%n Einträge</numerusform></translation></message>
 <message><source>Select something in the project or in the 3-D view.</source><translation>Wählen Sie etwas im Projekt oder in der 3-D-Ansicht aus.</translation></message>
 <message><source>This entry is edited in the text of the project.</source><translation>Dieser Eintrag wird im Text des Projekts bearbeitet.</translation></message>
 <message><source>Change %1</source><translation>%1 ändern</translation></message>
 <message numerus="yes"><source>%n entries of several kinds: they are moved, turned, copied and removed together. Select entries of one kind to edit their values.</source><translation><numerusform>%n Eintrag.</numerusform><numerusform>%n Einträge verschiedener Art: sie werden gemeinsam bewegt, gedreht, kopiert und entfernt. Wählen Sie Einträge einer Art, um ihre Werte zu ändern.</numerusform></translation></message>
</context>
<context>
 <name>goniolux::gui::ResultsPanel</name>
 <message><source>Grid</source><translation>Raster</translation></message>
 <message><source>Mean</source><translation>Mittelwert</translation></message>
 <message><source>Minimum</source><translation>Kleinster</translation></message>
 <message><source>Maximum</source><translation>Größter</translation></message>
 <message><source>Points</source><translation>Punkte</translation></message>
 <message><source>Results by grid</source><translation>Ergebnisse nach Raster</translation></message>
 <message><source>Mean illuminance of the grid's points, maintained. CIE S 017 17-21-060: illuminance is luminous flux per area of a surface.</source><translation>Mittlere Beleuchtungsstärke der Punkte des Rasters, Wartungswert. CIE S 017 17-21-060: Beleuchtungsstärke ist Lichtstrom je Fläche.</translation></message>
 <message><source>Uniformity: smallest illuminance over mean (EN 12464-1).</source><translation>Gleichmäßigkeit: kleinste durch mittlere Beleuchtungsstärke (EN 12464-1).</translation></message>
 <message><source>Diversity: smallest illuminance over largest.</source><translation>Ungleichmäßigkeit: kleinste durch größte Beleuchtungsstärke.</translation></message>
 <message><source>Requirement</source><translation>Anforderung</translation></message>
 <message><source>Verdict</source><translation>Urteil</translation></message>
 <message><source>Nothing is calculated yet. Choose an accuracy and press Calculate.</source><translation>Noch ist nichts berechnet. Wählen Sie eine Genauigkeit und drücken Sie „Berechnen“.</translation></message>
 <message><source>Being calculated: the half-widths shrink as the work goes on.</source><translation>Wird berechnet: Die Intervalle werden dabei enger.</translation></message>
 <message><source>Intervals at %1 % confidence; %2 s, %3 million rays.</source><translation>Intervalle mit %1 % Sicherheit; %2 s, %3 Millionen Strahlen.</translation></message>
 <message><source>The accuracy asked for was not reached: %1.</source><translation>Die verlangte Genauigkeit wurde nicht erreicht: %1.</translation></message>
 <message><source>pass</source><translation>erfüllt</translation></message>
 <message><source>fail</source><translation>nicht erfüllt</translation></message>
 <message><source>undecided</source><translation>offen</translation></message>
 <message><source>The whole interval keeps the limit.</source><translation>Das ganze Intervall hält die Grenze ein.</translation></message>
 <message><source>The whole interval breaks the limit.</source><translation>Das ganze Intervall verletzt die Grenze.</translation></message>
 <message><source>The limit lies inside the interval: ask for more accuracy.</source><translation>Die Grenze liegt im Intervall: verlangen Sie mehr Genauigkeit.</translation></message>
 <message><source>The project has changed since this was calculated: press Calculate again.</source><translation>Das Projekt hat sich seither geändert: drücken Sie noch einmal „Berechnen“.</translation></message>
 <message><source>UGR, unified glare rating of the luminaires against the luminance that they stand before (CIE 117:1995); EN 12464-1 limits it.</source><translation>UGR, vereinheitlichte Blendungsbewertung der Leuchten gegen die Leuchtdichte, vor der sie stehen (CIE 117:1995); EN 12464-1 begrenzt sie.</translation></message>
</context>
<context>
 <name>goniolux::gui::RoomPage</name>
 <message><source>Perspective</source><translation>Perspektive</translation></message>
 <message><source>Plan</source><translation>Grundriss</translation></message>
 <message><source>Elevation from the front</source><translation>Ansicht von vorn</translation></message>
 <message><source>Elevation from the right</source><translation>Ansicht von rechts</translation></message>
 <message><source>Show everything (double click)</source><translation>Alles zeigen (Doppelklick)</translation></message>
 <message><source>Look through a view of the project</source><translation>Durch eine Ansicht des Projekts sehen</translation></message>
 <message><source>Edges of objects</source><translation>Kanten der Objekte</translation></message>
 <message><source>Aiming lines</source><translation>Ausrichtungen</translation></message>
 <message><source>Calculated illuminance on the grids</source><translation>Berechnete Beleuchtungsstärke auf den Rastern</translation></message>
 <message><source>Measure a distance between two points</source><translation>Abstand zweier Punkte messen</translation></message>
 <message><source>Snap </source><translation>Fang </translation></message>
 <message><source>Steps in which the mouse moves things; hold Ctrl to move freely</source><translation>Schritte, in denen die Maus Dinge verschiebt; mit Strg frei</translation></message>
 <message><source>off</source><translation>aus</translation></message>
 <message><source>Look through …</source><translation>Blick durch …</translation></message>
 <message><source>Photometric solids of selected luminaires</source><translation>Lichtverteilungskörper der gewählten Leuchten</translation></message>
 <message><source>Cut the room open</source><translation>Den Raum aufschneiden</translation></message>
 <message><source>What is cut away</source><translation>Was weggeschnitten wird</translation></message>
 <message><source>above</source><translation>darüber</translation></message>
 <message><source>right of x</source><translation>rechts von x</translation></message>
 <message><source>left of x</source><translation>links von x</translation></message>
 <message><source>behind y</source><translation>hinter y</translation></message>
 <message><source>before y</source><translation>vor y</translation></message>
 <message><source>Place of the cut</source><translation>Ort des Schnitts</translation></message>
</context>
<context>
 <name>goniolux::gui::RoomView</name>
 <message><source>to x %1 m, y %2 m, z %3 m</source><translation>nach x %1 m, y %2 m, z %3 m</translation></message>
 <message><source>measuring: click the second point</source><translation>Messen: klicken Sie den zweiten Punkt an</translation></message>
 <message><source>distance %1 m (x %2, y %3, z %4)</source><translation>Abstand %1 m (x %2, y %3, z %4)</translation></message>
 <message><source>3-D view of the room</source><translation>3-D-Ansicht des Raumes</translation></message>
 <message><source>by x %1 m, y %2 m, z %3 m</source><translation>um x %1 m, y %2 m, z %3 m</translation></message>
 <message><source>turned by %1°</source><translation>um %1° gedreht</translation></message>
</context>
<context>
 <name>goniolux::gui::SpectrumPage</name>
 <message><source>Light on the patch</source><translation>Licht auf der Probe</translation></message>
 <message><source>Choose a material or a luminaire.</source><translation>Wählen Sie ein Material oder eine Leuchte.</translation></message>
 <message><source>Model</source><translation>Modell</translation></message>
 <message><source>CCT</source><translation>Farbtemp.</translation></message>
 <message><source>Melanopic DER</source><translation>Melanopischer Tageslichtwirkfaktor</translation></message>
 <message><source>S/P ratio</source><translation>S/P-Verhältnis</translation></message>
 <message><source>Lines</source><translation>Linien</translation></message>
 <message><source>A ball of this finish in the chosen light, rendered</source><translation>Eine Kugel aus diesem Material im gewählten Licht, gerechnet</translation></message>
 <message><source>Ball of the finish</source><translation>Materialkugel</translation></message>
</context>
<context>
 <name>goniolux::gui::StartPage</name>
 <message><source>Calculates the light in a room. Every number comes with its interval.</source><translation>Berechnet das Licht in einem Raum. Zu jeder Zahl gehört ihr Intervall.</translation></message>
 <message><source>New room …</source><translation>Neuer Raum …</translation></message>
 <message><source>Open a project …</source><translation>Projekt öffnen …</translation></message>
 <message><source>Recent projects</source><translation>Zuletzt bearbeitet</translation></message>
 <message><source>Sample projects</source><translation>Beispielprojekte</translation></message>
 <message><source>None yet.</source><translation>Noch keine.</translation></message>
</context>
<context>
 <name>goniolux::gui::TextPanel</name>
 <message><source>Text of the project</source><translation>Text des Projekts</translation></message>
 <message><source>Typing</source><translation>Tippen</translation></message>
</context>
<context>
 <name>goniolux::gui::gui</name>
 <message><source>must be at least %1</source><translation>muss mindestens %1 sein</translation></message>
 <message><source>must be above %1</source><translation>muss über %1 liegen</translation></message>
 <message><source>must be at most %1</source><translation>darf höchstens %1 sein</translation></message>
 <message><source>is no number</source><translation>ist keine Zahl</translation></message>
 <message><source>must be a whole number</source><translation>muss eine ganze Zahl sein</translation></message>
 <message><source>is needed</source><translation>wird gebraucht</translation></message>
 <message><source>is no value of this kind; lists are written [1, 2, 3]</source><translation>ist kein Wert dieser Art; Listen schreibt man [1, 2, 3]</translation></message>
</context>
<context>
 <name>goniolux::gui::HelpWindow</name>
 <message><source>Documentation of Goniolux</source><translation>Dokumentation von Goniolux</translation></message>
 <message><source>Pages</source><translation>Seiten</translation></message>
 <message><source>Back</source><translation>Zurück</translation></message>
 <message><source>Forward</source><translation>Vor</translation></message>
 <message><source>This program</source><translation>Dieses Programm</translation></message>
 <message><source>Getting started</source><translation>Erste Schritte</translation></message>
 <message><source>The project file</source><translation>Die Projektdatei</translation></message>
</context>
<context>
 <name>goniolux::gui::ValuesModel</name>
 <message><source>not counted</source><translation>nicht gezählt</translation></message>
 <message><source>Value</source><translation>Wert</translation></message>
 <message><source>Half-width</source><translation>Halbbreite</translation></message>
</context>
<context>
 <name>goniolux::gui::GlCanvas</name>
 <message><source>The 3-D view needs OpenGL 3.2, which this display does not offer; everything else works.</source><translation>Die 3-D-Ansicht braucht OpenGL 3.2, das diese Anzeige nicht bietet; alles andere geht.</translation></message>
</context>
<context>
 <name>goniolux::gui::Paper</name>
 <message><source>Double click: large, in a window of its own</source><translation>Doppelklick: groß, in einem eigenen Fenster</translation></message>
</context>
<context>
 <name>format</name>
 <message><source>accuracy</source><translation>Genauigkeit</translation></message>
 <message><source>adaptive</source><translation>anpassend</translation></message>
 <message><source>aim</source><translation>Ausstrahlrichtung</translation></message>
 <message><source>ambient</source><translation>Umgebung</translation></message>
 <message><source>area</source><translation>Fläche</translation></message>
 <message><source>array</source><translation>Anordnung</translation></message>
 <message><source>as printed</source><translation>wie gedruckt</translation></message>
 <message><source>attenuation per</source><translation>Schwächung je</translation></message>
 <message><source>axis</source><translation>Achse</translation></message>
 <message><source>base</source><translation>Fuß</translation></message>
 <message><source>basis</source><translation>Basis</translation></message>
 <message><source>border</source><translation>Rand</translation></message>
 <message><source>bump</source><translation>Relief</translation></message>
 <message><source>c0</source><translation>C0-Richtung</translation></message>
 <message><source>calibrated</source><translation>kalibriert</translation></message>
 <message><source>caps</source><translation>Deckel</translation></message>
 <message><source>center</source><translation>Mitte</translation></message>
 <message><source>chord error</source><translation>Sehnenfehler</translation></message>
 <message><source>colour de</source><translation>Farbabstand</translation></message>
 <message><source>confidence</source><translation>Vertrauen</translation></message>
 <message><source>constant</source><translation>konstant</translation></message>
 <message><source>contrast</source><translation>Kontrast</translation></message>
 <message><source>control</source><translation>Stützpunkte</translation></message>
 <message><source>counts</source><translation>Anzahlen</translation></message>
 <message><source>curve</source><translation>Kurve</translation></message>
 <message><source>cutoff</source><translation>Abbruch</translation></message>
 <message><source>degree u</source><translation>Grad u</translation></message>
 <message><source>degree v</source><translation>Grad v</translation></message>
 <message><source>degrees</source><translation>Grad</translation></message>
 <message><source>depth</source><translation>Tiefe</translation></message>
 <message><source>detail</source><translation>Einzelheiten</translation></message>
 <message><source>diameter</source><translation>Durchmesser</translation></message>
 <message><source>diffuse</source><translation>diffus</translation></message>
 <message><source>dimming</source><translation>Dimmung</translation></message>
 <message><source>direction</source><translation>Richtung</translation></message>
 <message><source>exitance lm m2</source><translation>spezifische Lichtausstrahlung</translation></message>
 <message><source>exitance</source><translation>spezifische Lichtausstrahlung</translation></message>
 <message><source>eye</source><translation>Auge</translation></message>
 <message><source>faces</source><translation>Flächen</translation></message>
 <message><source>facing</source><translation>zeigt nach</translation></message>
 <message><source>file</source><translation>Datei</translation></message>
 <message><source>filter</source><translation>Filter</translation></message>
 <message><source>flux</source><translation>Lichtstrom</translation></message>
 <message><source>format</source><translation>Format</translation></message>
 <message><source>fov</source><translation>Bildwinkel</translation></message>
 <message><source>gloss</source><translation>Glanz</translation></message>
 <message><source>grid</source><translation>Raster</translation></message>
 <message><source>grids</source><translation>Raster</translation></message>
 <message><source>group</source><translation>Gruppe</translation></message>
 <message><source>groups</source><translation>Gruppen</translation></message>
 <message><source>height</source><translation>Höhe</translation></message>
 <message><source>holes</source><translation>Löcher</translation></message>
 <message><source>image</source><translation>Bild</translation></message>
 <message><source>ior</source><translation>Brechzahl</translation></message>
 <message><source>joint</source><translation>Fuge</translation></message>
 <message><source>k</source><translation>k</translation></message>
 <message><source>lamp flux</source><translation>Lampenlichtstrom</translation></message>
 <message><source>luminaires</source><translation>Leuchten</translation></message>
 <message><source>maintenance</source><translation>Wartungsfaktor</translation></message>
 <message><source>mapping</source><translation>Abbildung</translation></message>
 <message><source>material</source><translation>Material</translation></message>
 <message><source>materials</source><translation>Materialien</translation></message>
 <message><source>max depth</source><translation>größte Tiefe</translation></message>
 <message><source>max</source><translation>Maximum</translation></message>
 <message><source>max samples</source><translation>größte Strahlenzahl</translation></message>
 <message><source>mean</source><translation>Mittelwert</translation></message>
 <message><source>min samples</source><translation>kleinste Strahlenzahl</translation></message>
 <message><source>min</source><translation>Minimum</translation></message>
 <message><source>model</source><translation>Modell</translation></message>
 <message><source>name</source><translation>Name</translation></message>
 <message><source>normal</source><translation>Normale</translation></message>
 <message><source>normals</source><translation>Normalen</translation></message>
 <message><source>objects</source><translation>Objekte</translation></message>
 <message><source>observer</source><translation>Beobachter</translation></message>
 <message><source>observers</source><translation>Beobachter</translation></message>
 <message><source>origin</source><translation>Ursprung</translation></message>
 <message><source>patch rows</source><translation>Fleckenreihen</translation></message>
 <message><source>pattern</source><translation>Muster</translation></message>
 <message><source>photometry</source><translation>Lichtverteilung</translation></message>
 <message><source>pixel</source><translation>Bildpunkt</translation></message>
 <message><source>points</source><translation>Punkte</translation></message>
 <message><source>position</source><translation>Ort</translation></message>
 <message><source>preset</source><translation>Voreinstellung</translation></message>
 <message><source>profile</source><translation>Profil</translation></message>
 <message><source>projection</source><translation>Projektion</translation></message>
 <message><source>quantity</source><translation>Größe</translation></message>
 <message><source>ra</source><translation>Ra</translation></message>
 <message><source>radius</source><translation>Radius</translation></message>
 <message><source>reflectance</source><translation>Reflexionsgrad</translation></message>
 <message><source>reflection model</source><translation>Reflexionsmodell</translation></message>
 <message><source>repeats</source><translation>Wiederholungen</translation></message>
 <message><source>requirements</source><translation>Anforderungen</translation></message>
 <message><source>ring radius</source><translation>Ringradius</translation></message>
 <message><source>rms slope</source><translation>mittlere Neigung</translation></message>
 <message><source>rotate</source><translation>Drehung</translation></message>
 <message><source>rotation</source><translation>Drehung</translation></message>
 <message><source>roughness</source><translation>Rauheit</translation></message>
 <message><source>samples</source><translation>Stützstellen</translation></message>
 <message><source>scale</source><translation>Maßstab</translation></message>
 <message><source>scenes</source><translation>Lichtszenen</translation></message>
 <message><source>scheme</source><translation>Verfahren</translation></message>
 <message><source>seed</source><translation>Startzahl</translation></message>
 <message><source>settings</source><translation>Einstellungen</translation></message>
 <message><source>shape</source><translation>Form</translation></message>
 <message><source>share</source><translation>Anteil</translation></message>
 <message><source>shear</source><translation>Scherung</translation></message>
 <message><source>shift</source><translation>Verschiebung</translation></message>
 <message><source>size</source><translation>Größe</translation></message>
 <message><source>smooth</source><translation>geglättet</translation></message>
 <message><source>solver</source><translation>Löser</translation></message>
 <message><source>spacing</source><translation>Abstand</translation></message>
 <message><source>span</source><translation>Spannweite</translation></message>
 <message><source>spectral</source><translation>spektral</translation></message>
 <message><source>spectrum</source><translation>Spektrum</translation></message>
 <message><source>specular</source><translation>gerichtet</translation></message>
 <message><source>stagger</source><translation>Versatz</translation></message>
 <message><source>target</source><translation>Ziel</translation></message>
 <message><source>texture</source><translation>Textur</translation></message>
 <message><source>thickness</source><translation>Dicke</translation></message>
 <message><source>tilt</source><translation>Neigung</translation></message>
 <message><source>time limit</source><translation>Zeitgrenze</translation></message>
 <message><source>top radius</source><translation>oberer Radius</translation></message>
 <message><source>top</source><translation>Oberseite</translation></message>
 <message><source>transform</source><translation>Transformation</translation></message>
 <message><source>translate</source><translation>Verschiebung</translation></message>
 <message><source>transmission</source><translation>Transmissionsgrad</translation></message>
 <message><source>transmittance per</source><translation>Transmissionsgrad je</translation></message>
 <message><source>tree</source><translation>Strahlenbaum</translation></message>
 <message><source>tube radius</source><translation>Rohrradius</translation></message>
 <message><source>turn</source><translation>Achsdrehung</translation></message>
 <message><source>u0</source><translation>U0</translation></message>
 <message><source>u</source><translation>u</translation></message>
 <message><source>ud</source><translation>Ud</translation></message>
 <message><source>ugr</source><translation>UGR</translation></message>
 <message><source>units</source><translation>Einheit</translation></message>
 <message><source>up</source><translation>oben</translation></message>
 <message><source>v</source><translation>v</translation></message>
 <message><source>version</source><translation>Version</translation></message>
 <message><source>vertices</source><translation>Ecken</translation></message>
 <message><source>views</source><translation>Ansichten</translation></message>
 <message><source>width</source><translation>Breite</translation></message>
 <message><source>with</source><translation>mit</translation></message>
 <message><source>x</source><translation>x</translation></message>
 <message><source>a luminaire</source><translation>eine Leuchte</translation></message>
 <message><source>a grid</source><translation>ein Raster</translation></message>
 <message><source>a material</source><translation>ein Material</translation></message>
 <message><source>a view</source><translation>eine Ansicht</translation></message>
 <message><source>an observer</source><translation>ein Beobachter</translation></message>
 <message><source>a requirement</source><translation>eine Anforderung</translation></message>
 <message><source>a scene</source><translation>eine Lichtszene</translation></message>
 <message><source>the project</source><translation>das Projekt</translation></message>
 <message><source>a box</source><translation>ein Quader</translation></message>
 <message><source>a sphere</source><translation>eine Kugel</translation></message>
 <message><source>a cylinder</source><translation>ein Zylinder</translation></message>
 <message><source>a disc</source><translation>eine Scheibe</translation></message>
 <message><source>a rectangle</source><translation>ein Rechteck</translation></message>
 <message><source>an object</source><translation>ein Objekt</translation></message>
 <message><source>a group</source><translation>eine Gruppe</translation></message>
 <message><source>xx</source><translation>xx</translation></message>
 <message><source>yy</source><translation>yy</translation></message>
 <message><source>zz</source><translation>zz</translation></message>
 <message><source>xy</source><translation>xy</translation></message>
 <message><source>xz</source><translation>xz</translation></message>
 <message><source>y</source><translation>y</translation></message>
 <message><source>yx</source><translation>yx</translation></message>
 <message><source>yz</source><translation>yz</translation></message>
 <message><source>z</source><translation>z</translation></message>
 <message><source>zx</source><translation>zx</translation></message>
 <message><source>zy</source><translation>zy</translation></message>
</context>
</TS>
