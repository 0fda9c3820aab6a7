// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <QtTest>
#include <map>
#include <string>
#include <vector>

#include "opcua/map_proposal.h"
#include "support/test_program.h"

using namespace rivulet;
using namespace rivulet::opcua;

namespace {

NodeFacts number(bool mayWrite = false) {
  NodeFacts facts;
  facts.type = "Double";
  facts.isNumber = true;
  facts.mayRead = true;
  facts.mayWrite = mayWrite;
  return facts;
}

NodeFacts text() {
  NodeFacts facts;
  facts.type = "String";
  facts.isText = true;
  facts.mayRead = true;
  return facts;
}

NodeFacts array(std::size_t length) {
  NodeFacts facts = number(true);
  facts.isArray = true;
  facts.length = length;
  return facts;
}

/// A server in memory: its own browser, and the clock of the walk.
class Scene final : public NodeBrowser, public Link {
 public:
  Scene& add(const std::string& parent, const std::string& id, const std::string& name,
             NodeKind kind = NodeKind::Object, NodeFacts facts = {}) {
    m_children[parent].push_back({id, 1, name, kind});
    m_facts[id] = std::move(facts);
    return *this;
  }
  base::Result<std::vector<BrowsedNode>> children(const std::string& address) override {
    m_now += std::chrono::milliseconds(10);
    return m_children[address];
  }
  base::Result<std::vector<NodeFacts>> examine(std::span<const std::string> ids) override {
    std::vector<NodeFacts> facts;
    for (const std::string& id : ids) {
      facts.push_back(m_facts[id]);
    }
    return facts;
  }
  [[nodiscard]] base::Instant now() const override { return m_now; }
  base::RequestId read(std::span<const Variable>, base::Duration, Grouping) override { return {}; }
  base::RequestId write(std::span<const Assignment>, base::Duration, Grouping) override {
    return {};
  }
  base::RequestId store(const std::string&, const std::string&, base::Duration) override {
    return {};
  }
  std::optional<Event> wait(base::Instant) override { return std::nullopt; }

  [[nodiscard]] Survey survey(const SurveyLimits& limits = {}) {
    auto survey = surveyServer(*this, *this, limits);
    return survey ? *survey : Survey();
  }

 private:
  std::map<std::string, std::vector<BrowsedNode>> m_children;
  std::map<std::string, NodeFacts> m_facts;
  base::Instant m_now{};
};

const std::string kRoot = kObjectsFolder;

void addCells(Scene& scene, int count, const std::string& id, int idOffset) {
  scene.add(kRoot, "ns=1;s=cells", "Cells");
  for (int i = 0; i < count; ++i) {
    scene.add("ns=1;s=cells", id + std::to_string(i + idOffset), "Cell_" + std::to_string(i),
              NodeKind::Variable, number(true));
  }
}

std::string nodeOf(const MapProposal& proposal, VariableKind kind, int index = 0) {
  const auto found = proposal.map.nodes.find({kind, index});
  return found == proposal.map.nodes.end() ? std::string() : found->second;
}

}  // namespace

class TestMapProposal : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void namesHaveWords_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("words");
    const auto row = [](const char* name, const char* words) {
      QTest::newRow(name) << QString::fromUtf8(name) << QString::fromUtf8(words);
    };
    row("actPos_X1", "act pos x 1");
    row("XActualPosition", "x actual position");
    row("CNCStatus", "cnc status");
    row("alarm-number", "alarm number");
    row("R12", "r 12");
    row("FEED", "feed");
    row("", "");
  }
  void namesHaveWords() {
    QFETCH(QString, name);
    QFETCH(QString, words);
    QStringList found;
    for (const std::string& word : wordsOf(name.toStdString())) {
      found << QString::fromStdString(word);
    }
    QCOMPARE(found.join(QLatin1Char(' ')), words);
  }

  void cellsAreFoundByTheirNumbers() {
    Scene scene;
    addCells(scene, 40, "ns=1;i=", 5000);
    const CellNodes cells = proposeMap(scene.survey()).map.cells;
    QCOMPARE(cells.node, std::string("ns=1;i={}"));
    QCOMPARE(cells.first, 0);
    QCOMPARE(cells.last, 39);
    QCOMPARE(cells.offset, 5000);
  }

  /// Node ids that have nothing to do with the numbers: the names have.
  void cellsMayHavePaths() {
    Scene scene;
    scene.add(kRoot, "ns=1;s=cells", "Cells/A");
    for (int i = 0; i < 20; ++i) {
      scene.add("ns=1;s=cells", "ns=1;i=" + std::to_string(900 - i), "C" + std::to_string(i + 5),
                NodeKind::Variable, number(true));
    }
    const CellNodes cells = proposeMap(scene.survey()).map.cells;
    QCOMPARE(cells.node, std::string("/Cells&/A/C{}"));
    QCOMPARE(cells.first, 5);
    QCOMPARE(cells.last, 24);
    QCOMPARE(cells.offset, 0);
  }

  void cellsMayBeAnArray() {
    Scene scene;
    addCells(scene, 20, "ns=1;i=", 0);
    scene.add(kRoot, "ns=1;s=R", "R", NodeKind::Variable, array(100));
    const CellNodes cells = proposeMap(scene.survey()).map.cells;
    QVERIFY(cells.isArray);
    QCOMPARE(cells.last, 99);
  }

  void whatCannotBeWrittenIsNoCell() {
    Scene scene;
    for (int i = 0; i < 40; ++i) {
      scene.add(kRoot, "ns=1;i=" + std::to_string(i), "C" + std::to_string(i), NodeKind::Variable,
                number(false));
    }
    QVERIFY(proposeMap(scene.survey()).map.cells.last < 0);
  }

  void variablesAreFoundByTheirWords() {
    Scene scene;
    scene.add(kRoot, "ns=1;s=m", "Machine")
        .add("ns=1;s=m", "ns=1;s=x", "Axes")
        .add("ns=1;s=x", "ns=1;s=x1", "XCommandPosition", NodeKind::Variable, number())
        .add("ns=1;s=x", "ns=1;s=x2", "XActualPosition", NodeKind::Variable, number())
        .add("ns=1;s=x", "ns=1;s=x3", "XDistanceToGo", NodeKind::Variable, number())
        .add("ns=1;s=m", "ns=1;s=f1", "FeedOverride", NodeKind::Variable, number())
        .add("ns=1;s=m", "ns=1;s=f2", "ActualFeed", NodeKind::Variable, number())
        .add("ns=1;s=m", "ns=1;s=st", "State", NodeKind::Variable, text())
        .add("ns=1;s=m", "ns=1;s=al", "AlarmText", NodeKind::Variable, text())
        .add("ns=1;s=m", "ns=1;s=pn", "ProgramName", NodeKind::Variable, text())
        .add("ns=1;s=m", "ns=1;s=w", "WriteProgram", NodeKind::Method);
    const MapProposal proposal = proposeMap(scene.survey());
    QCOMPARE(nodeOf(proposal, VariableKind::ActualPosition), std::string("ns=1;s=x2"));
    QCOMPARE(nodeOf(proposal, VariableKind::DistanceToGo), std::string("ns=1;s=x3"));
    QCOMPARE(nodeOf(proposal, VariableKind::PathFeed), std::string("ns=1;s=f2"));
    QCOMPARE(nodeOf(proposal, VariableKind::ChannelStatus), std::string("ns=1;s=st"));
    QCOMPARE(nodeOf(proposal, VariableKind::ProgramName), std::string("ns=1;s=pn"));
    QCOMPARE(nodeOf(proposal, VariableKind::Alarm), std::string());  // a text has no number
    QCOMPARE(nodeOf(proposal, VariableKind::ActualPosition, 1), std::string());
    QCOMPARE(proposal.methods.size(), std::size_t{1});
    QCOMPARE(proposal.methods.front().object, std::string("ns=1;s=m"));
  }

  /// What has to be said by a person is missing in the file, so the file is refused.
  void aProposalHasToBeCompleted() {
    Scene scene;
    scene.add(kRoot, "ns=1;s=m", "Machine")
        .add("ns=1;s=m", "ns=1;s=st", "State", NodeKind::Variable, text());
    std::string file = proposalText(proposeMap(scene.survey()), "ready");
    QVERIFY(file.find("It shows ready now.") != std::string::npos);
    QVERIFY(!parseControlMap(file, "proposed"));
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"# reset = []", "reset = [1]"},
          {"# active = []", "active = [2]"}}) {
      file.replace(file.find(from), from.size(), to);
    }
    QVERIFY(parseControlMap(file, "proposed"));
  }

  void theWalkIsBounded() {
    Scene scene;
    addCells(scene, 200, "ns=1;i=", 0);
    QVERIFY(scene.survey().incomplete.empty());
    QCOMPARE(scene.survey().nodes.size(), std::size_t{202});
    const Survey few = scene.survey({50, 8, std::chrono::seconds(60)});
    QCOMPARE(few.nodes.size(), std::size_t{50});
    QCOMPARE(few.incomplete, std::string("Only the first 50 nodes were looked at."));
    const Survey flat = scene.survey({1000, 1, std::chrono::seconds(60)});
    QCOMPARE(flat.nodes.size(), std::size_t{2});
    QVERIFY(!flat.incomplete.empty());
    const Survey late = scene.survey({1000, 8, std::chrono::seconds(1)});
    QCOMPARE(late.incomplete, std::string("Not all nodes were seen in 1 s."));
  }

  /// A node that is its own grandchild, and the standard's own nodes.
  void noNodeIsVisitedTwice() {
    Scene scene;
    scene.add(kRoot, "ns=1;s=a", "A")
        .add("ns=1;s=a", "ns=1;s=b", "B")
        .add("ns=1;s=b", "ns=1;s=a", "A")
        .add(kRoot, "i=2253", "Server");
    QCOMPARE(scene.survey().nodes.size(), std::size_t{3});
    QVERIFY(scene.survey().incomplete.empty());
  }

  void aSinumerikNeedsNoMap() {
    Scene scene;
    scene.add(kRoot, "nsu=SinumerikVarProvider;s=Sinumerik", "Sinumerik");
    QVERIFY(proposeMap(scene.survey()).isSinumerik);
  }
};

RIVULET_TEST(TestMapProposal)
#include "tst_map_proposal.moc"
