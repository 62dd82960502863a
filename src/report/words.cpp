#include "report/words.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "plot/number_text.h"

namespace goniolux::report {
namespace {

struct Text {
  const char *english, *german;
};

// German terms after DIN EN 12665 and DIN EN 12464-1.
constexpr std::array texts = {
    Text{"Lighting report", "Lichttechnischer Bericht"},
    Text{"Results at a glance", "Ergebnisse im Überblick"},
    Text{"Requirements", "Anforderungen"},
    Text{"requirements met", "Anforderungen erfüllt"},
    Text{"Requirement", "Anforderung"},
    Text{"Required", "Gefordert"},
    Text{"Calculated", "Berechnet"},
    Text{"Verdict", "Urteil"},
    Text{"met", "erfüllt"},
    Text{"not met", "nicht erfüllt"},
    Text{"undecided", "unentschieden"},
    Text{
        "A requirement is undecided where its limit lies inside the interval of the calculated value: a finer accuracy "
        "decides it.",
        "Unentschieden ist eine Anforderung, deren Grenzwert im Intervall des berechneten Wertes liegt: eine höhere "
        "Genauigkeit entscheidet sie."},
    Text{"Area", "Fläche"},
    Text{"Quantity", "Größe"},
    Text{"Mean", "Mittelwert"},
    Text{"Minimum", "Minimum"},
    Text{"Maximum", "Maximum"},
    Text{"Uniformity U₀", "Gleichmäßigkeit U₀"},
    Text{"Diversity", "Verhältnis min/max"},
    Text{"Points", "Punkte"},
    Text{"Mean illuminance", "Mittlere Beleuchtungsstärke"},
    Text{"Minimum illuminance", "Minimale Beleuchtungsstärke"},
    Text{"Maximum illuminance", "Maximale Beleuchtungsstärke"},
    Text{"Unified glare rating UGR", "Blendungsbewertung UGR"},
    Text{"Colour rendering Ra", "Farbwiedergabe Ra"},
    Text{"Illuminance", "Beleuchtungsstärke"},
    Text{"cylindrical", "zylindrisch"},
    Text{"semi-cylindrical", "halbzylindrisch"},
    Text{"hemispherical", "halbsphärisch"},
    Text{"spherical", "sphärisch"},
    Text{"illuminance", "Beleuchtungsstärke"},
    Text{"melanopic-edi", "melanopische tageslichtäquivalente Beleuchtungsstärke"},
    Text{"Observer", "Beobachter"},
    Text{"figures unconfirmed", "Zahlen unbestätigt"},
    Text{"Glares most", "Blendet am stärksten"},
    Text{"Group", "Gruppe"},
    Text{"Level", "Stellwert"},
    Text{"Contribution of each group of luminaires", "Beitrag jeder Leuchtengruppe"},
    Text{"Speed against accuracy", "Rechenzeit und Genauigkeit"},
    Text{"Error against calculation time of this project, held against a long reference",
         "Fehler über der Rechenzeit dieses Projekts, gemessen an einer langen Vergleichsrechnung"},
    Text{"Value", "Wert"},
    Text{"Luminaires", "Leuchten"},
    Text{"Luminaire schedule", "Leuchtenliste"},
    Text{"Luminaire", "Leuchte"},
    Text{"Count", "Anzahl"},
    Text{"Flux", "Lichtstrom"},
    Text{"Power", "Leistung"},
    Text{"Efficacy", "Lichtausbeute"},
    Text{"Total", "Summe"},
    Text{"Connected load", "Anschlussleistung"},
    Text{"Mounting height", "Lichtpunkthöhe"},
    Text{"Maintenance factor", "Wartungsfaktor"},
    Text{"Dimming", "Dimmung"},
    Text{"Photometric file", "Lichtverteilungsdatei"},
    Text{"Distribution", "Lichtverteilung"},
    Text{"Manufacturer", "Hersteller"},
    Text{"Catalogue number", "Bestellnummer"},
    Text{"Luminous opening", "Leuchtende Fläche"},
    Text{"Largest intensity", "Größte Lichtstärke"},
    Text{"Beam angle (50 %)", "Halbstreuwinkel (50 %)"},
    Text{"Field angle (10 %)", "Zehntelstreuwinkel (10 %)"},
    Text{"Light downward", "Lichtstrom nach unten"},
    Text{"Luminous intensity", "Lichtstärkeverteilung"},
    Text{"not stated", "ohne Angabe"},
    Text{"none", "keiner"},
    Text{"Plan", "Grundriss"},
    Text{"Plan with luminaires", "Grundriss mit Leuchten"},
    Text{"calculation area", "Berechnungsfläche"},
    Text{"Positions", "Positionen"},
    Text{"Room", "Raum"},
    Text{"Size", "Abmessungen"},
    Text{"Floor area", "Grundfläche"},
    Text{"Surfaces", "Oberflächen"},
    Text{"wall", "Wand"},
    Text{"Colour of light", "Lichtfarbe"},
    Text{"point", "Punkt"},
    Text{"line", "Linie"},
    Text{"rectangle", "Rechteck"},
    Text{"disc", "Kreis"},
    Text{"ellipse", "Ellipse"},
    Text{"box", "Quader"},
    Text{"sphere", "Kugel"},
    Text{"ellipsoid", "Ellipsoid"},
    Text{"upright rectangle", "stehendes Rechteck"},
    Text{"upright disc", "stehender Kreis"},
    Text{"upright cylinder", "stehender Zylinder"},
    Text{"horizontal cylinder", "liegender Zylinder"},
    Text{"all C planes", "alle C-Ebenen"},
    Text{"C0 (right) – C180", "C0 (rechts) – C180"},
    Text{"C90 (right) – C270", "C90 (rechts) – C270"},
    Text{"Method", "Rechenverfahren"},
    Text{"Spectral sampling", "Spektrale Abtastung"},
    Text{"Wavelengths", "Wellenlängen"},
    Text{"Accuracy asked for", "Geforderte Genauigkeit"},
    Text{"grids", "Berechnungsflächen"},
    Text{"images", "Bilder"},
    Text{"colour", "Farbe"},
    Text{"Surface", "Oberfläche"},
    Text{"Material", "Material"},
    Text{"Reflectance", "Reflexionsgrad"},
    Text{"floor", "Boden"},
    Text{"walls", "Wände"},
    Text{"ceiling", "Decke"},
    Text{"Value table", "Wertetabelle"},
    Text{"all points are in", "alle Punkte stehen in"},
    Text{"Renderings", "Visualisierungen"},
    Text{"Calculated luminance, shown for a monitor", "Berechnete Leuchtdichte, dargestellt für einen Bildschirm"},
    Text{"How it was calculated", "Wie gerechnet wurde"},
    Text{
        "Every number comes with an interval: the exact answer for the room as it is described lies in value ± "
        "half-width "
        "at the confidence stated. Differences between the room as described and the room as built are not part of it.",
        "Jede Zahl hat ein Intervall: die exakte Antwort für den Raum, wie er beschrieben ist, liegt mit der genannten "
        "Sicherheit in Wert ± Halbbreite. Unterschiede zwischen beschriebenem und gebautem Raum gehören nicht dazu."},
    Text{"Confidence", "Sicherheit"},
    Text{"Settings", "Einstellungen"},
    Text{"Left out", "Weggelassen"},
    Text{"Provenance", "Herkunft"},
    Text{"Program", "Programm"},
    Text{"Project hash", "Prüfsumme des Projekts"},
    Text{"Seed", "Startwert"},
    Text{"Calculation time", "Rechenzeit"},
    Text{"Light paths", "Strahlen"},
    Text{"Lighting scene", "Lichtszene"},
    Text{"Inputs", "Eingangsdaten"},
    Text{"File", "Datei"},
    Text{"The accuracy asked for was not reached", "Die geforderte Genauigkeit wurde nicht erreicht"},
    Text{"Please note", "Bitte beachten"},
    Text{"in", "in"},
    Text{"of", "von"},
    Text{"luminaire", "Leuchte"},
    Text{"highest value", "größter Wert"},
    Text{"lowest value", "kleinster Wert"},
    Text{"not counted", "nicht gezählt"},
    Text{"distance along the plane", "Abstand entlang der Ebene"},
    Text{"height z", "Höhe z"},
    Text{"distance up the plane", "Abstand die Ebene hinauf"},
    Text{"at least", "mindestens"},
    Text{"at most", "höchstens"},
    Text{"high", "hoch"},
    Text{"maintained", "Wartungswert"},
    Text{"page", "Seite"},
};

const Text* textFor(const std::string& english) {
  for (const Text& text : texts)
    if (english == text.english) return &text;
  return nullptr;
}

void replaceAll(std::string& text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
}

}  // namespace

std::string Words::operator()(const std::string& english) const {
  const Text* text = german_ ? textFor(english) : nullptr;
  return text ? text->german : english;
}

bool Words::hasTranslation(const std::string& english) const {
  return textFor(english) != nullptr;
}

std::string Words::number(double value, int decimals) const {
  if (!std::isfinite(value)) return "–";
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const std::size_t point = text.find('.');
  std::size_t whole = point == std::string::npos ? text.size() : point;
  if (german_ && point != std::string::npos) text[point] = ',';
  if (whole > 4)
    for (; whole > 3; whole -= 3) text.insert(whole - 3, "\u202f");  // narrow no-break space, ISO 80000-1
  return (value < 0 ? "−" : "") + text;
}

double Words::factor(const std::string& metric) const {
  if (!imperial_) return 1;
  // The foot is 0.3048 m exactly; 1 fc = 1 lm/ft2.
  constexpr double foot = 0.3048;
  if (metric == "m") return 1 / foot;
  if (metric == "m2") return 1 / (foot * foot);
  if (metric == "lx" || metric == "W/m2") return foot * foot;
  return 1;
}

std::string Words::unitName(const std::string& metric) const {
  if (metric == "m2") return imperial_ ? "ft²" : "m²";
  if (metric == "W/m2") return imperial_ ? "W/ft²" : "W/m²";
  if (metric == "1") return "";
  if (!imperial_) return metric;
  if (metric == "lx") return "fc";
  if (metric == "m") return "ft";
  return metric;
}

std::string Words::estimate(const core::Estimate& e, const std::string& unit) const {
  if (!std::isfinite(e.value)) return "–";
  const double f = factor(unit);
  std::string text = plot::uncertaintyText(f * e.value, f * e.halfWidth());
  if (german_) replaceAll(text, ".", ",");
  return text;
}

std::string Words::value(double value, const std::string& unit) const {
  if (!std::isfinite(value)) return "";
  const double v = factor(unit) * value;
  const double size = std::abs(v);
  return number(v, size >= 100 ? 0 : size >= 10 ? 1 : 2);
}

std::string Words::length(double metres, int decimals) const {
  return number(factor("m") * metres, decimals);
}

std::string limitName(const std::string& key) {
  if (key == "mean_lx") return "Mean illuminance";
  if (key == "min_lx") return "Minimum illuminance";
  if (key == "max_lx") return "Maximum illuminance";
  if (key == "u0") return "Uniformity U₀";
  if (key == "ud") return "Diversity";
  if (key == "ugr") return "Unified glare rating UGR";
  if (key == "ra") return "Colour rendering Ra";
  return key;
}

std::string limitUnit(const std::string& key) {
  return key.ends_with("_lx") ? "lx" : "";
}

}  // namespace goniolux::report
