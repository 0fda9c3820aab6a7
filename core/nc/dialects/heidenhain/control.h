// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// @file
/// Executes plain text block by block and makes plain moves of it: rapids, lines and arcs about a
/// centre in workpiece coordinates, and the words for the machine. What a TNC keeps from block to
/// block (Q parameters, datum shift, the cycle that is defined, the corner that is to be rounded)
/// is kept here; whoever takes the blocks needs to know none of it.
///
/// Sources, by chapter: TNC 640 User's Manual Conversational Programming ("Programming contours",
/// "Programming Q parameters", "Miscellaneous functions"), TNC 640 User's Manual Cycle Programming
/// ("Coordinate Transformation", "Drilling"), iTNC 530 User's Manual for the old cycles.
/// @threadsafety one object, one thread.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/vec3.h"
#include "nc/dialects/heidenhain/contour.h"
#include "nc/dialects/heidenhain/cycles.h"
#include "nc/dialects/heidenhain/made.h"
#include "nc/dialects/heidenhain/scanner.h"
#include "nc/modal/frame.h"
#include "nc/modal/vocabulary.h"
#include "nc/syntax/lexer.h"
#include "nc/syntax/tree.h"

namespace rivulet::nc::heidenhain {

class Control {
 public:
  /// @param toolRadius  outlives the control; null: no tool of the machine is known
  explicit Control(const ToolRadius* toolRadius = nullptr);

  /// Takes one block. What it makes of it is there to be taken, but for a contour element whose end
  /// the next block may still change.
  /// @param line  see `Made::line`
  Steering execute(std::string_view block, Place place, base::LineNumber line, bool isSkipped);
  /// There are no more blocks.
  void finish();
  /// @return false: another block is needed
  [[nodiscard]] bool take(Made& made);
  void enterProgram();
  void leaveProgram();
  /// A jump depends on a value that is not known: what comes next is not known.
  [[nodiscard]] bool isLost() const { return m_isLost; }
  /// Of all that a jump may depend on.
  [[nodiscard]] std::uint64_t changes() const { return m_parameters.changes(); }
  /// The last block could not be executed as it says.
  void report(Fault fault);

 private:
  enum class FeedKind : unsigned char { None, PerMinute, PerRevolution, Rapid };
  struct Feed {
    FeedKind kind = FeedKind::None;
    double value = 0.0;
    friend bool operator==(const Feed&, const Feed&) = default;
  };
  using Linear = std::array<bool, base::kAxisCount>;

  /// What is to be told, in order.
  struct Item {
    Place place;
    base::LineNumber line;
    bool isSkipped = false;
    std::vector<Token> tokens;  ///< but for motion and feed
    bool moves = false;
    bool isMade = false;       ///< see `Made`
    bool isInMachine = false;  ///< M91, M92
    base::Vec3 start;          ///< workpiece
    base::Vec3 target;         ///< workpiece
    Linear given{};
    std::array<std::optional<double>, kProgrammedAxisCount> rotary;  ///< from index 3 on
    std::optional<Element> element;                                  ///< in its plane, workpiece
    std::size_t plane = 0;         ///< of the element, by its first axis
    std::optional<double> radius;  ///< as CR has it; none once a corner has changed the arc
    int turns = 0;                 ///< full circles on top of the arc
    Feed feed;
    std::optional<Fault> fault;
    std::string ignored;
  };

  struct MFunction {
    int number = 0;
    int column = 1;
  };
  /// The words of a positioning block.
  struct MotionWords {
    std::array<std::optional<double>, kProgrammedAxisCount> axes;
    std::array<bool, kProgrammedAxisCount> isIncrement{};
    std::optional<double> polarRadius;
    std::optional<double> polarAngle;
    bool radiusIsIncrement = false;
    bool angleIsIncrement = false;
    std::optional<double> radius;
    std::optional<double> centreAngle;
    std::optional<double> length;
    std::optional<bool> clockwise;
    std::optional<int> compensation;
    int compensationColumn = 1;
    std::optional<Feed> feed;
    std::optional<double> spindlePerMin;
    std::optional<double> retractBy;  ///< M140 MB50
    std::optional<Feed> retractFeed;
    std::vector<MFunction> functions;
    std::array<std::optional<double>, base::kAxisCount> normal;
    std::array<std::optional<double>, base::kAxisCount> tool;
    int column = 1;

    [[nodiscard]] bool has(int function) const;
    [[nodiscard]] bool isInMachine() const { return has(91) || has(92); }
    [[nodiscard]] bool movesLinear() const { return axes[0] || axes[1] || axes[2]; }
    [[nodiscard]] bool moves() const;
  };
  /// RND or CHF, until the next element.
  struct CornerWords {
    Place place;
    base::LineNumber line;
    bool isChamfer = false;
    double size = 0.0;
    std::optional<Feed> feed;
  };
  /// APPR, until the first element of the contour.
  struct Approach {
    Place place;
    base::LineNumber line;
    std::string kind;
    Item item;
    Flat start;
    Flat first;  ///< contour point, workpiece
    double length = 0.0;
    double radius = 0.0;
    double centreAngle = 0.0;
    bool turnsLeft = false;  ///< where the radius is positive
    Feed before;             ///< of the way to the auxiliary point
  };
  struct Tool {
    std::optional<double> radius;
  };
  /// What TOOL CALL begins with; neither: the tool stays.
  struct ToolChoice {
    std::optional<double> number;
    std::optional<std::string> name;
  };
  enum class Shift : unsigned char { Datum, Mirror, Rotation, Scale };

  // control.cpp: blocks
  [[nodiscard]] Expected<Steering> statement(Scanner& in);
  [[nodiscard]] Expected<Steering> namedStatement(Scanner& in);
  [[nodiscard]] Expected<Steering> program(Scanner& in, bool isBegin);
  [[nodiscard]] Expected<Steering> callSomething(Scanner& in);
  [[nodiscard]] Expected<Steering> functionNumber(Scanner& in);
  [[nodiscard]] Expected<void> assignment(Scanner& in, const std::string& name);
  [[nodiscard]] Expected<void> assignText(Scanner& in);
  [[nodiscard]] Expected<Steering> conditionalJump(Scanner& in, int function);
  [[nodiscard]] Expected<std::string> labelName(Scanner& in);
  [[nodiscard]] Expected<void> toolCall(Scanner& in);
  [[nodiscard]] Expected<ToolChoice> toolChoice(Scanner& in);
  [[nodiscard]] Expected<void> toolDefinition(Scanner& in);
  [[nodiscard]] Expected<void> stop(Scanner& in);
  void setToolAxis(std::size_t axis);
  void setTool(std::optional<int> number, std::string_view name);
  void tellToolRadius();

  // words.cpp: positioning blocks
  [[nodiscard]] Expected<MotionWords> motionWords(Scanner& in);
  [[nodiscard]] Expected<bool> wordOf(Scanner& in, MotionWords& words);
  [[nodiscard]] Expected<bool> coordinate(Scanner& in, MotionWords& words);
  [[nodiscard]] Expected<void> functionWord(Scanner& in, MotionWords& words);
  [[nodiscard]] Expected<Feed> feedWord(Scanner& in);
  [[nodiscard]] Expected<void> refuseUnused(const MotionWords& words, std::string_view used);

  // motion.cpp
  [[nodiscard]] Expected<void> line(Scanner& in);
  [[nodiscard]] Expected<void> polarLine(Scanner& in);
  [[nodiscard]] Expected<void> circleCentre(Scanner& in);
  [[nodiscard]] Expected<void> arcAboutCentre(Scanner& in);
  [[nodiscard]] Expected<void> arcWithRadius(Scanner& in);
  [[nodiscard]] Expected<void> polarArc(Scanner& in);
  [[nodiscard]] Expected<void> tangentialArc(Scanner& in, bool isPolar);
  [[nodiscard]] Expected<void> corner(Scanner& in, bool isChamfer);
  // approach.cpp
  [[nodiscard]] Expected<void> placeByPole(std::string& kind, MotionWords& words);
  [[nodiscard]] Expected<void> approach(Scanner& in);
  [[nodiscard]] Expected<void> departure(Scanner& in);
  [[nodiscard]] Expected<void> checkDeparture(Scanner& in, const std::string& kind,
                                              const MotionWords& words);
  [[nodiscard]] Expected<Element> departureWay(Scanner& in, const std::string& kind,
                                               const MotionWords& words);
  [[nodiscard]] Expected<base::Vec3> targetOf(const MotionWords& words);
  [[nodiscard]] Expected<Flat> polarTarget(const MotionWords& words);
  [[nodiscard]] Expected<Item> itemOf(const MotionWords& words);
  /// With its target, in coordinates of the program.
  [[nodiscard]] Expected<Item> itemTo(const MotionWords& words);
  [[nodiscard]] Expected<void> turnRotary(const MotionWords& words, Item& item);
  [[nodiscard]] Expected<void> compensate(const MotionWords& words, Item& item);
  [[nodiscard]] Expected<void> goInMachine(const MotionWords& words, Item& item);
  [[nodiscard]] Expected<void> setTarget(Item& item, base::Vec3 programmed,
                                         const MotionWords& words);
  [[nodiscard]] Expected<void> moveOn(const MotionWords& words, Item item);
  [[nodiscard]] Expected<void> setArc(Item& item, Flat centre, bool clockwise, std::size_t plane);
  [[nodiscard]] Expected<void> afterMotion(const MotionWords& words);
  [[nodiscard]] Expected<void> retract(const MotionWords& words);
  void addFunctions(const MotionWords& words, Item& item);

  // queue.cpp
  void push(Item item);
  void flush();
  void write(Item item);
  void refuse(FaultCode code, std::string argument);
  void ignore(std::string word);
  void tell(std::vector<Token> tokens);
  [[nodiscard]] Expected<void> joinCorner(Item& next);
  [[nodiscard]] Expected<void> joinApproach(const Item& next);
  void forgetPosition();
  [[nodiscard]] Token word(char address, double value) const;
  [[nodiscard]] Token named(std::string_view name, double value) const;
  [[nodiscard]] std::string_view kept(std::string text);

  // transformations.cpp, and the calls of cycles
  [[nodiscard]] Expected<void> cycle(Scanner& in);
  [[nodiscard]] Expected<void> cycleDefinition(Scanner& in);
  [[nodiscard]] Expected<void> oldCycleLine(Scanner& in, int number, int line);
  [[nodiscard]] Expected<void> oldCallLine(Scanner& in, int number, int line);
  [[nodiscard]] Expected<void> oldDwell(Scanner& in);
  [[nodiscard]] Expected<void> oldCycleWords(Scanner& in, int line);
  [[nodiscard]] Expected<void> datumShift(Scanner& in, int line);
  [[nodiscard]] Expected<void> mirror(Scanner& in);
  [[nodiscard]] Expected<void> rotation(Scanner& in);
  [[nodiscard]] Expected<void> scale(Scanner& in);
  [[nodiscard]] Expected<void> swivel(Scanner& in);
  [[nodiscard]] Expected<void> plane(Scanner& in);
  [[nodiscard]] bool rotaryAxesStandAtZero() const;
  /// @param isKnown  the plane is not tilted
  void tellPlaneAngles(bool isKnown);
  [[nodiscard]] Expected<void> translate(Scanner& in);
  [[nodiscard]] Expected<void> selectPreset();
  [[nodiscard]] Expected<void> function(Scanner& in);
  [[nodiscard]] Expected<void> activate(Shift shift, std::string_view name);
  [[nodiscard]] Frame frameOf(const std::vector<Shift>& order) const;
  [[nodiscard]] bool isActive(Shift shift) const;
  [[nodiscard]] Expected<void> pattern(Scanner& in);
  [[nodiscard]] Expected<void> patternPart(Scanner& in, const std::string& kind);
  [[nodiscard]] Expected<void> callPattern(Scanner& in);
  [[nodiscard]] Expected<void> cycleCall(Scanner& in);
  [[nodiscard]] Expected<void> callCycle(double surfaceShift);
  [[nodiscard]] Expected<void> runCycle(const CycleSituation& situation);
  [[nodiscard]] Expected<void> runPattern(int number);
  [[nodiscard]] Expected<void> step(base::Vec3 programmed, Feed feed);
  [[nodiscard]] CycleSituation situation() const;
  void tap(const CycleStep& tapping);
  void bore(const CycleStep& boring);
  void tellHole(std::vector<Token> tokens);

  [[nodiscard]] std::size_t thirdAxis() const { return m_tool.axis; }
  [[nodiscard]] std::size_t firstAxis() const { return (m_tool.axis + 1) % base::kAxisCount; }
  [[nodiscard]] std::size_t secondAxis() const { return (m_tool.axis + 2) % base::kAxisCount; }
  [[nodiscard]] Flat flat(base::Vec3 place) const { return flatIn(firstAxis(), place); }
  /// @param plane  its first axis
  [[nodiscard]] static Flat flatIn(std::size_t plane, base::Vec3 place) {
    return {place[plane], place[(plane + 1) % base::kAxisCount]};
  }
  [[nodiscard]] std::size_t poleSecondAxis() const { return (m_pole.axis + 1) % base::kAxisCount; }
  [[nodiscard]] base::Vec3 programmed() const { return m_coordinates.frame.toProgrammed(m_at); }
  /// Of the plane: a mirror image turns arcs round.
  [[nodiscard]] Expected<bool> mirrorsPlane(std::size_t plane) const;

  /// The block that is executed.
  struct Block {
    Place place;
    base::LineNumber line;
    bool isSkipped = false;
  };
  struct ToolInSpindle {
    std::size_t axis = 2;
    std::optional<double> radius;  ///< without DR
    double radiusDelta = 0.0;
    double lengthDelta = 0.0;
    Feed feed;  ///< of TOOL CALL, for FAUTO
  };
  /// Of CC: programmed.
  struct Pole {
    std::optional<Flat> place;
    std::size_t axis = 0;  ///< first axis of the plane in which it lies
  };
  /// Cycles 7, 8, 10, 11 and 19, and the frame that they make.
  struct Coordinates {
    Frame frame;
    std::vector<Shift> order;
    base::Vec3 datum;
    std::array<bool, base::kAxisCount> isMirrored{};
    double turn = 0.0;
    std::size_t turnAxis = 2;
    double scale = 1.0;
    bool isSwivelled = false;
  };
  /// PATTERN DEF: places in the plane, and the surface there.
  struct PatternPoint {
    Flat place;
    double surface = 0.0;
  };
  struct Cycles {
    CycleDefinition defined;
    std::vector<PatternPoint> pattern;
    bool callsAlways = false;  ///< M89
    int beingDefined = 0;      ///< of the old cycles
  };

  Parameters m_parameters;
  Block m_block;
  bool m_isLost = false;
  /// Faults told, by file, line and column: a loop tells each of them once.
  std::set<std::array<std::uint32_t, 3>> m_faults;
  std::deque<Made> m_made;
  std::optional<Item> m_pending;
  std::optional<CornerWords> m_corner;
  std::optional<Approach> m_approach;
  std::set<std::string, std::less<>> m_texts;  ///< that tokens point into

  int m_depth = 0;  ///< programs within each other
  bool m_isInch = false;
  const ToolRadius* m_radiusOfMachine;
  std::map<int, Tool> m_tools;  ///< of TOOL DEF
  ToolInSpindle m_tool;
  double m_spindlePerMin = 0.0;
  Feed m_feed;
  bool m_perRevolution = false;  ///< M136
  bool m_wasRapid = false;       ///< the last positioning block
  Feed m_told;
  int m_compensation = 0;

  base::Vec3 m_at;  ///< workpiece; NaN: not known
  std::array<double, kProgrammedAxisCount> m_rotary{};
  std::optional<Flat> m_direction;  ///< of the last element, workpiece
  Pole m_pole;
  std::size_t m_toldPlane = 0;  ///< by its first axis

  Coordinates m_coordinates;
  bool m_tipIsOn = false;  ///< M128
  bool m_hasMoved = false;
  std::optional<double> m_preset;  ///< of Cycle 247

  Cycles m_cycles;
};

}  // namespace rivulet::nc::heidenhain
