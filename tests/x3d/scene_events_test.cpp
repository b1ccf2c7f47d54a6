// Events of scenes: what time sensors send at given times, what interpolators make of it, how routes carry
// it, and that circles of routes end.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "x3d/interpolate.h"
#include "x3d/read_scene.h"
#include "x3d/scene_events.h"
#include "x3d/write_scene.h"

namespace vo {
namespace {

class SceneEventsTest : public testing::Test
{
protected:
    void read(const std::string& nodes)
    {
        const std::string text = "<X3D profile='Full' version='4.0'><Scene>" + nodes + "</Scene></X3D>";
        ASSERT_TRUE(readSceneText(scene, text, "test"));
        for (const SceneMessage& message : scene.messages)
            ADD_FAILURE() << messageLine(message);
    }
    Node& node(const char* name) { return *scene.names.find(name)->second; }
    template <typename Number>
    std::vector<Number> values(const char* name, const char* field)
    {
        const Node& of = node(name);
        return std::get<std::vector<Number>>(of.value(*of.field(field)));
    }
    float number(const char* name, const char* field) { return values<float>(name, field).at(0); }
    double seconds(const char* name, const char* field) { return values<double>(name, field).at(0); }
    bool truth(const char* name, const char* field)
    {
        const auto found = values<std::int32_t>(name, field);
        return !found.empty() && found[0] != 0;
    }
    void receive(const char* name, const char* field, FieldValue value)
    {
        events.receive(node(name), *node(name).field(field), value);
    }
    std::vector<float> at(const std::string& interpolator, float fraction)
    {
        Scene one;
        EXPECT_TRUE(readSceneText(one, "<X3D version='4.0'><Scene>" + interpolator + "</Scene></X3D>",
                                  "interpolator"));
        const auto made = interpolated(*one.roots.at(0), fraction);
        return made ? std::get<std::vector<float>>(*made) : std::vector<float>();
    }

    Scene scene;
    SceneEvents events{scene};
};

void expectNear(const std::vector<float>& found, const std::vector<float>& expected)
{
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-6) << i;
}

constexpr const char* kRamp = "<ScalarInterpolator DEF='R' key='0 1' keyValue='0 1'/>";

TEST_F(SceneEventsTest, fractionIsThePartOfTheCycle)
{
    read("<TimeSensor DEF='T' cycleInterval='4' loop='true'/>");
    events.setTime(0);
    EXPECT_TRUE(events.isRunning());
    EXPECT_TRUE(truth("T", "isActive"));
    EXPECT_EQ(number("T", "fraction_changed"), 0);
    events.setTime(1);
    EXPECT_EQ(number("T", "fraction_changed"), 0.25f);
    events.setTime(4);
    EXPECT_EQ(number("T", "fraction_changed"), 1) << "the end of a cycle";
    EXPECT_EQ(seconds("T", "cycleTime"), 0);
    events.setTime(11);
    EXPECT_EQ(number("T", "fraction_changed"), 0.75f);
    EXPECT_EQ(seconds("T", "cycleTime"), 8);
    EXPECT_EQ(seconds("T", "elapsedTime"), 11);
    EXPECT_EQ(seconds("T", "time"), 11);
    events.setTime(2);
    EXPECT_EQ(number("T", "fraction_changed"), 0.5f) << "time went back";
}

TEST_F(SceneEventsTest, aRunWithoutLoopEndsAfterOneCycle)
{
    read("<TimeSensor DEF='T' cycleInterval='2' startTime='3'/><TimeSensor DEF='Past'/>");
    events.setTime(0);
    EXPECT_FALSE(events.isRunning()) << "what began at 0 is over";
    events.setTime(3.5);
    EXPECT_TRUE(truth("T", "isActive"));
    EXPECT_EQ(number("T", "fraction_changed"), 0.25f);
    events.setTime(9);
    EXPECT_EQ(number("T", "fraction_changed"), 1);
    EXPECT_EQ(seconds("T", "elapsedTime"), 2);
    EXPECT_FALSE(events.isRunning());
    EXPECT_FALSE(truth("T", "isActive"));
    receive("T", "startTime", std::vector<double>{10});
    events.setTime(11);
    EXPECT_EQ(number("T", "fraction_changed"), 0.5f);
}

TEST_F(SceneEventsTest, aRunThatTimeLeapsOverIsTold)
{
    read("<TimeSensor DEF='T' startTime='3'/><Switch DEF='S'/>" + std::string(kRamp) +
         "<TimeSensor DEF='Next' cycleInterval='8' enabled='false'/>"
         "<ROUTE fromNode='T' fromField='fraction_changed' toNode='R' toField='set_fraction'/>"
         "<ROUTE fromNode='T' fromField='isActive' toNode='Next' toField='enabled'/>");
    events.setTime(1);
    events.setTime(100);
    EXPECT_EQ(number("R", "value_changed"), 1);
    EXPECT_TRUE(node("T").isSet(node("T").field("isActive")->slot));
    EXPECT_FALSE(truth("T", "isActive"));
    EXPECT_FALSE(truth("Next", "enabled")) << "both ends of the run arrive";
}

TEST_F(SceneEventsTest, stopTimeEndsAndPauseTimeHolds)
{
    read("<TimeSensor DEF='Stop' cycleInterval='10' loop='true' stopTime='4'/>"
         "<TimeSensor DEF='Hold' cycleInterval='10' loop='true' pauseTime='2' resumeTime='5'/>");
    events.setTime(1);
    events.setTime(3);
    EXPECT_NEAR(number("Hold", "fraction_changed"), 0.2f, 1e-7);
    EXPECT_TRUE(truth("Hold", "isPaused"));
    events.setTime(6);
    EXPECT_NEAR(number("Stop", "fraction_changed"), 0.4f, 1e-7);
    EXPECT_FALSE(truth("Stop", "isActive"));
    EXPECT_NEAR(number("Hold", "fraction_changed"), 0.3f, 1e-7);
    EXPECT_FALSE(truth("Hold", "isPaused"));
}

TEST_F(SceneEventsTest, runsThatEndedBeforeTheFirstTimeAreOver)
{
    read("<TimeSensor DEF='Over' startTime='3'/><TimeSensor DEF='Running' startTime='3' cycleInterval='20'/>"
         "<TimeSensor DEF='Looping' startTime='3' cycleInterval='4' loop='true'/>");
    events.setTime(8);
    EXPECT_FALSE(truth("Over", "isActive"));
    EXPECT_FALSE(node("Over").isSet(node("Over").field("fraction_changed")->slot)) << "nothing is sent";
    EXPECT_TRUE(truth("Running", "isActive"));
    EXPECT_EQ(number("Running", "fraction_changed"), 0.25f);
    EXPECT_EQ(number("Looping", "fraction_changed"), 0.25f);
    EXPECT_EQ(seconds("Looping", "cycleTime"), 7);
    events.setTime(9);
    EXPECT_FALSE(node("Over").isSet(node("Over").field("isActive")->slot));
}

TEST_F(SceneEventsTest, timeInPausesDoesNotElapse)
{
    const std::string paused = "cycleInterval='4' loop='true' pauseTime='2' resumeTime='5'/>";
    read("<TimeSensor DEF='T' stopTime='10' " + paused + "<TimeSensor DEF='Held' stopTime='4' " + paused);
    events.setTime(1);
    events.setTime(3);
    EXPECT_EQ(seconds("T", "elapsedTime"), 2);
    events.setTime(6);
    EXPECT_EQ(seconds("T", "elapsedTime"), 3);
    EXPECT_EQ(seconds("T", "cycleTime"), 0);
    EXPECT_EQ(seconds("Held", "elapsedTime"), 2) << "stopped while it was paused";
    EXPECT_FALSE(truth("Held", "isPaused"));
    EXPECT_FALSE(truth("Held", "isActive"));
    events.setTime(8);
    EXPECT_EQ(seconds("T", "elapsedTime"), 5);
    EXPECT_EQ(seconds("T", "cycleTime"), 7) << "4 seconds, and 3 of the pause";
    events.setTime(20);
    EXPECT_EQ(seconds("T", "elapsedTime"), 7) << "stopped at 10";
    EXPECT_EQ(number("T", "fraction_changed"), 0.75f);
    EXPECT_FALSE(truth("T", "isActive"));
}

TEST_F(SceneEventsTest, timeInPausesThatAreLeaptOverDoesNotElapse)
{
    const std::string paused = "cycleInterval='4' loop='true' pauseTime='2' resumeTime='5'/>";
    read("<TimeSensor DEF='T' stopTime='10' " + paused + "<TimeSensor DEF='Held' stopTime='4' " + paused);
    events.setTime(8);
    EXPECT_EQ(seconds("T", "elapsedTime"), 5);
    EXPECT_EQ(number("T", "fraction_changed"), 0.25f);
    events.setTime(1);
    EXPECT_EQ(seconds("T", "elapsedTime"), 1) << "time went back";
    EXPECT_TRUE(truth("Held", "isActive"));
    events.setTime(20);
    EXPECT_EQ(seconds("T", "elapsedTime"), 7);
    EXPECT_EQ(seconds("Held", "elapsedTime"), 2);
    EXPECT_FALSE(truth("Held", "isPaused"));
    EXPECT_FALSE(truth("Held", "isActive"));
}

TEST_F(SceneEventsTest, cyclesThatBeganBeforeAPauseThatIsLeaptOverKeepTheirTime)
{
    const std::string looping = " cycleInterval='4' loop='true' ";
    read("<TimeSensor DEF='After'" + looping + "pauseTime='5' resumeTime='8'/><TimeSensor DEF='Before'" +
         looping + "pauseTime='3' resumeTime='4.5'/><TimeSensor DEF='At'" + looping +
         "pauseTime='4' resumeTime='8'/>");
    events.setTime(0);
    events.setTime(9);
    EXPECT_EQ(seconds("After", "elapsedTime"), 6);
    EXPECT_EQ(seconds("After", "cycleTime"), 4);
    EXPECT_EQ(seconds("Before", "cycleTime"), 5.5);
    EXPECT_EQ(seconds("At", "cycleTime"), 8) << "the first ends in the pause";
    events.setTime(11.5);
    EXPECT_EQ(seconds("After", "cycleTime"), 11);
    EXPECT_EQ(seconds("Before", "cycleTime"), 9.5);
}

TEST_F(SceneEventsTest, runsThatArePausedAtTheFirstTimeAreNotOver)
{
    const std::string run = "startTime='3' cycleInterval='4' pauseTime=";
    read("<TimeSensor DEF='Held' " + run + "'4' resumeTime='20'/><TimeSensor DEF='Resumed' " + run +
         "'5' resumeTime='6'/><TimeSensor DEF='Endless' " + run + "'6'/><TimeSensor DEF='Over' " + run +
         "'7'/>");
    events.setTime(7.5);
    EXPECT_TRUE(truth("Held", "isPaused"));
    EXPECT_EQ(number("Held", "fraction_changed"), 0.25f);
    EXPECT_EQ(number("Resumed", "fraction_changed"), 0.875f);
    EXPECT_EQ(number("Endless", "fraction_changed"), 0.75f);
    EXPECT_FALSE(node("Over").isSet(node("Over").field("isActive")->slot));
    events.setTime(22);
    EXPECT_EQ(number("Held", "fraction_changed"), 0.75f);
    EXPECT_FALSE(truth("Resumed", "isActive"));
    EXPECT_TRUE(truth("Endless", "isActive"));
}

TEST_F(SceneEventsTest, stopTimesBeforeTheRunAreRefused)
{
    read("<TimeSensor DEF='T' startTime='3' loop='true' stopTime='0'/>");
    events.setTime(4);
    for (const double early : {2.0, 3.0}) {
        receive("T", "stopTime", std::vector<double>{early});
        EXPECT_EQ(seconds("T", "stopTime"), 0);
    }
    receive("T", "stopTime", std::vector<double>{3.5});
    EXPECT_EQ(seconds("T", "stopTime"), 3.5);
    events.setTime(5);
    EXPECT_FALSE(truth("T", "isActive"));
    EXPECT_EQ(seconds("T", "elapsedTime"), 0.5);
    receive("T", "stopTime", std::vector<double>{2});
    EXPECT_EQ(seconds("T", "stopTime"), 2) << "it does not run";
}

TEST_F(SceneEventsTest, loopThatIsTakenAwayEndsWithItsCycle)
{
    read("<TimeSensor DEF='T' cycleInterval='4' loop='true'/>");
    events.setTime(5);
    receive("T", "loop", std::vector<std::int32_t>{0});
    receive("T", "startTime", std::vector<double>{1});
    receive("T", "cycleInterval", std::vector<double>{100});
    EXPECT_EQ(seconds("T", "startTime"), 0) << "not while it runs";
    EXPECT_EQ(seconds("T", "cycleInterval"), 4);
    events.setTime(7);
    EXPECT_TRUE(truth("T", "isActive"));
    events.setTime(8.5);
    EXPECT_EQ(number("T", "fraction_changed"), 1);
    EXPECT_FALSE(truth("T", "isActive"));
}

TEST_F(SceneEventsTest, numbersAndPositionsGoStraight)
{
    const std::string path = "<PositionInterpolator key='0 0.5 1' keyValue='0 0 0 2 4 6 2 0 0'/>";
    expectNear(at(path, 0.25f), {1, 2, 3});
    expectNear(at(path, 0.75f), {2, 2, 3});
    expectNear(at(path, -1), {0, 0, 0});
    expectNear(at(path, 2), {2, 0, 0});
    const std::string leap = "<ScalarInterpolator key='0 0.5 0.5 1' keyValue='0 1 5 6'/>";
    expectNear(at(leap, 0.25f), {0.5f});
    expectNear(at(leap, 0.5f), {5});
    expectNear(at(leap, 0.75f), {5.5f});
    EXPECT_TRUE(at(leap, std::nanf("")).empty());
    EXPECT_TRUE(at("<ScalarInterpolator key='0 1'/>", 0.5f).empty());
    expectNear(at("<ScalarInterpolator key='0 1' keyValue='3'/>", 0.5f), {3});
}

TEST_F(SceneEventsTest, keysThatFallEndTheList)
{
    const std::string falling = "<ScalarInterpolator key='0 0.5 0.2 1' keyValue='0 1 7 9'/>";
    expectNear(at(falling, 0.25f), {0.5f});
    expectNear(at(falling, 0.75f), {1});
    expectNear(at(falling, 1), {1});
    expectNear(at("<ScalarInterpolator key='1 0' keyValue='3 4'/>", 0), {3});
}

TEST_F(SceneEventsTest, orientationsGoTheShorterWayRound)
{
    const std::string quarter = "<OrientationInterpolator key='0 1' keyValue='0 1 0 0  0 2 0 1.5707963'/>";
    expectNear(at(quarter, 0.25f), {0, 1, 0, 0.39269908f});
    const std::string back = "<OrientationInterpolator key='0 1' keyValue='0 0 1 0  0 0 1 4.71238898'/>";
    expectNear(at(back, 0.5f), {0, 0, -1, 0.78539816f});
    // Half way between a quarter about x and one about y: their quaternions' sum, 1 1/2 1/2 0.
    const std::string two =
        "<OrientationInterpolator key='0 1' keyValue='1 0 0 1.57079633  0 1 0 1.57079633'/>";
    const float half = std::sqrt(0.5f);
    expectNear(at(two, 0.5f), {half, half, 0, 2 * std::atan2(half, 1.0f)});
}

TEST_F(SceneEventsTest, rotationsWithoutAxisTurnNothing)
{
    expectNear(at("<OrientationInterpolator key='0 1' keyValue='0 1 0 0  1 0 0 0'/>", 0.5f), {0, 0, 1, 0});
    // One about an axis of no length, and a whole turn.
    Scene one;
    ASSERT_TRUE(readSceneText(one,
                              "<X3D version='4.0'><Scene><OrientationInterpolator key='0 1 2' "
                              "keyValue='0 0 0 2  0 1 0 1  0 1 0 -5.283185307'/></Scene></X3D>",
                              "axis"));
    const auto half = std::get<std::vector<float>>(*interpolated(*one.roots.at(0), 0.5f));
    expectNear(half, {0, 1, 0, 0.5f});
}

TEST_F(SceneEventsTest, coloursGoRoundTheCircleOfHues)
{
    expectNear(at("<ColorInterpolator key='0 1' keyValue='1 0 0 0 1 0'/>", 0.5f), {1, 1, 0});
    expectNear(at("<ColorInterpolator key='0 1' keyValue='1 0 0 0 0 1'/>", 0.5f), {1, 0, 1});
    expectNear(at("<ColorInterpolator key='0 1' keyValue='0 0 0 1 1 1'/>", 0.25f), {0.25f, 0.25f, 0.25f});
    expectNear(at("<ColorInterpolator key='0 1' keyValue='1 1 1 0 0 0.5'/>", 0.5f), {0.375f, 0.375f, 0.75f});
}

TEST_F(SceneEventsTest, eventsCascadeIntoFields)
{
    read("<TimeSensor DEF='T' cycleInterval='8' loop='true'/>"
         "<PositionInterpolator DEF='P' key='0 1' keyValue='0 0 0 8 0 0'/>"
         "<Transform DEF='A'/><Transform DEF='B'/>"
         "<ROUTE fromNode='T' fromField='fraction_changed' toNode='P' toField='set_fraction'/>"
         "<ROUTE fromNode='P' fromField='value_changed' toNode='A' toField='set_translation'/>"
         "<ROUTE fromNode='A' fromField='translation_changed' toNode='B' toField='translation'/>");
    events.setTime(3);
    EXPECT_EQ(number("B", "translation"), 3);
    EXPECT_EQ(number("A", "translation"), 3);
    const auto before = events.changes();
    events.setTime(4);
    EXPECT_EQ(events.changes(), before + 2);
    const std::string written = sceneText(scene, Encoding::xml);
    EXPECT_EQ(written.find("fraction_changed='"), std::string::npos) << "what was sent is no field of a file";
}

TEST_F(SceneEventsTest, circlesOfRoutesEnd)
{
    read("<Transform DEF='A'/><Transform DEF='B'/>"
         "<ROUTE fromNode='A' fromField='scale' toNode='B' toField='scale'/>"
         "<ROUTE fromNode='B' fromField='scale' toNode='A' toField='scale'/>"
         "<ROUTE fromNode='A' fromField='scale' toNode='A' toField='scale'/>");
    receive("A", "scale", std::vector<float>{2, 3, 4});
    EXPECT_EQ(values<float>("B", "scale"), (std::vector<float>{2, 3, 4}));
    EXPECT_LE(events.changes(), 4u);
}

TEST_F(SceneEventsTest, whatAFieldMayNotHoldDoesNotArrive)
{
    read("<VolumeData DEF='V'/><Group DEF='Outer'><Group DEF='Inner'/></Group>");
    receive("V", "dimensions", std::vector<float>{0, 1, 1});
    receive("V", "dimensions", std::vector<float>{1});
    EXPECT_EQ(values<float>("V", "dimensions"), (std::vector<float>{1, 1, 1}));
    receive("Inner", "addChildren", std::vector<Node*>{&node("Outer")});
    EXPECT_TRUE(values<Node*>("Inner", "children").empty()) << "a circle";
    receive("Inner", "addChildren", std::vector<Node*>{&node("V")});
    EXPECT_EQ(values<Node*>("Inner", "children").size(), 1u);
    receive("Inner", "removeChildren", std::vector<Node*>{&node("V")});
    EXPECT_TRUE(values<Node*>("Inner", "children").empty());
}

TEST_F(SceneEventsTest, sensorsStartEachOther)
{
    read("<TimeSensor DEF='A' startTime='1' cycleInterval='2'/><TimeSensor DEF='B' cycleInterval='4'/>"
         "<ROUTE fromNode='A' fromField='cycleTime' toNode='B' toField='startTime'/>"
         "<ROUTE fromNode='B' fromField='cycleTime' toNode='A' toField='startTime'/>");
    events.setTime(0);
    EXPECT_FALSE(events.isRunning());
    events.setTime(2);
    EXPECT_EQ(number("A", "fraction_changed"), 0.5f);
    EXPECT_EQ(number("B", "fraction_changed"), 0.25f) << "in the same moment";
}

TEST_F(SceneEventsTest, setBindChoosesAViewpoint)
{
    read("<Viewpoint DEF='V'/><Viewpoint DEF='W'/>");
    EXPECT_EQ(events.boundViewpoint(), nullptr);
    receive("V", "set_bind", std::vector<std::int32_t>{1});
    receive("W", "set_bind", std::vector<std::int32_t>{1});
    EXPECT_EQ(events.boundViewpoint(), &node("W"));
    EXPECT_FALSE(truth("V", "isBound"));
    EXPECT_TRUE(truth("W", "isBound"));
}

TEST_F(SceneEventsTest, indicesThatAreSetAreKept)
{
    read("<Shape><IndexedTriangleSet DEF='I'/></Shape>");
    receive("I", "set_index", std::vector<std::int32_t>{0, 1, 2});
    EXPECT_EQ(values<std::int32_t>("I", "index"), (std::vector<std::int32_t>{0, 1, 2}));
}

TEST_F(SceneEventsTest, whatDoesNotArriveIsToldOnceForEachField)
{
    const std::string text = "<X3D profile='Full' version='4.0'><Scene>\n"
                             "<PointLight DEF='L'/>\n<Group DEF='G'/></Scene></X3D>";
    ASSERT_TRUE(readSceneText(scene, text, "test"));
    receive("L", "radius", std::vector<float>{-1});
    receive("L", "radius", std::vector<float>{-2});
    receive("L", "ambientIntensity", std::vector<float>{5});
    receive("L", "intensity", std::vector<float>{std::nanf("")});
    receive("G", "children", std::vector<Node*>{&node("G")});
    receive("G", "addChildren", std::vector<Node*>{&node("G")});
    EXPECT_EQ(number("L", "radius"), 100);
    std::string told;
    for (const SceneMessage& message : scene.messages)
        told += messageLine(message) + "\n";
    EXPECT_EQ(
        told,
        "test:2: warning: PointLight.radius of \"L\": an event does not arrive: expected numbers in "
        "[0,inf), found -1\n"
        "test:2: warning: PointLight.ambientIntensity of \"L\": an event does not arrive: expected "
        "numbers in [0,1], found 5\n"
        "test:2: warning: PointLight.intensity of \"L\": an event does not arrive: expected numbers in "
        "[0,inf), found nan\n"
        "test:3: warning: Group.children of \"G\": an event does not arrive: expected nodes that it does "
        "not stand below\n"
        "test:3: warning: Group.addChildren of \"G\": an event does not arrive: expected nodes that it does "
        "not stand below\n");
}

} // namespace
} // namespace vo
