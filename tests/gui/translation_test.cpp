// The German interface: every sentence of the sources and every key of the project file has its translation, and a
// window speaks it.
#include <QDirIterator>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTranslator>
#include <QXmlStreamReader>

#include <map>
#include <set>

#include "app/gui/forms/sections.h"
#include "app/gui/window/project_tree.h"
#include "gui/studio_fixture.h"
#include "project/format.h"

namespace goniolux::test {
namespace {

/// Source -> translation, by context.
using Catalogue = std::map<QString, std::map<QString, QString>>;

Catalogue german() {
  Catalogue all;
  QFile file(QString(GONIOLUX_SOURCE_DIR) + "/data/translations/goniolux-studio_de.ts");
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  QString context, source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == "name") context = xml.readElementText().section("::", -1);
    if (xml.name() == "source") source = xml.readElementText();
    if (xml.name() == "translation")
      all[context][source] = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return all;
}

/// What a file's tr("…") say, with the class that they stand in.
std::vector<std::pair<QString, QString>> sentencesOf(const QString& code) {
  // In the order of the text: a method's beginning names the class, a tr belongs to the last one named.
  static const QRegularExpression place(
      R"re(^(?! )(?:[\w:<>&*, ]+[ *&])?(?<class>\w+)::~?\w+\(|(?:(?<of>\w+)::)?\btr\(\s*(?<text>(?:"(?:[^"\\]|\\.)*"\s*)+))re",
      QRegularExpression::MultilineOption);
  static const QRegularExpression piece(R"re("((?:[^"\\]|\\.)*)")re");
  std::vector<std::pair<QString, QString>> found;
  QString inside = "gui";  // outside of classes
  for (auto at = place.globalMatch(code); at.hasNext();) {
    const QRegularExpressionMatch match = at.next();
    if (const QString name = match.captured("class"); !name.isEmpty()) {
      inside = name;
      continue;
    }
    QString sentence;
    for (auto part = piece.globalMatch(match.captured("text")); part.hasNext();) sentence += part.next().captured(1);
    sentence.replace("\\\"", "\"").replace("\\n", "\n");
    found.emplace_back(match.captured("of").isEmpty() ? inside : match.captured("of"), sentence);
  }
  return found;
}

void collect(const project::Section& section, std::set<const project::Section*>& seen, std::set<std::string>& keys) {
  if (!seen.insert(&section).second) return;
  for (const project::Key& key : section.keys) {
    keys.insert(gui::labelOf(key.name));
    if (key.section != nullptr) collect(*key.section, seen, keys);
  }
}

TEST(Translation, EverySentenceOfTheSourcesIsGerman) {
  const Catalogue catalogue = german();
  int count = 0;
  QDirIterator files(QString(GONIOLUX_SOURCE_DIR) + "/src/app/gui", {"*.cpp"}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext()) {
    QFile file(files.next());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    for (const auto& [context, sentence] : sentencesOf(QString::fromUtf8(file.readAll()))) {
      ++count;
      const auto words = catalogue.find(context);
      EXPECT_TRUE(words != catalogue.end() && words->second.count(sentence) == 1 &&
                  !words->second.at(sentence).isEmpty())
          << context.toStdString() << ": " << sentence.toStdString() << " (" << file.fileName().toStdString() << ")";
    }
  }
  EXPECT_GT(count, 250);
  const auto planted = sentencesOf("void Page::draw() {\n  show(tr(\"not \"\n \"there\"));\n}");
  ASSERT_EQ(planted.size(), 1u);
  EXPECT_EQ(planted.front(), std::pair(QString("Page"), QString("not there")));
}

TEST(Translation, EveryLabelOfTheFormsIsGerman) {
  const Catalogue catalogue = german();
  const auto& words = catalogue.at("format");
  std::set<const project::Section*> seen;
  std::set<std::string> keys;
  collect(project::rootSection(), seen, keys);
  for (const project::MaterialForm& form : project::materialForms()) collect(form.section, seen, keys);
  for (const geometry::ObjectType& type : geometry::objectTypes()) {
    const project::Section section = project::objectSection(type);
    for (const project::Key& key : section.keys) keys.insert(gui::labelOf(key.name));
  }
  EXPECT_GT(keys.size(), 80u);
  for (const std::string& key : keys)
    EXPECT_EQ(words.count(QString::fromStdString(key)), 1u) << "\"" << key << "\" has no German word";
}

class German : public StudioFixture {
 protected:
  void SetUp() override {
    if (displayIsThere()) {
      ASSERT_TRUE(translator_.load(QString(GONIOLUX_BINARY_DIR) + "/src/app/gui/goniolux-studio_de.qm"));
      QApplication::installTranslator(&translator_);
    }
    StudioFixture::SetUp();
  }
  void TearDown() override {
    StudioFixture::TearDown();
    QApplication::removeTranslator(&translator_);
  }
  QTranslator translator_;
};

TEST_F(German, AWindowSpeaksIt) {
  ASSERT_TRUE(window_->openProject(copyOf("small-office")));
  ASSERT_TRUE(waitForCheck());
  ASSERT_TRUE(waitForJobs());
  EXPECT_EQ(window_->menuBar()->actions().front()->text(), "&Datei");
  window_->tree().select("/luminaires/0");
  QTest::qWait(400);
  screenshot("german");
}

}  // namespace
}  // namespace goniolux::test
