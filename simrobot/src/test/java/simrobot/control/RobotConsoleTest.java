package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.StringReader;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.modem.ModemOptions;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simrobot.process.BehaviourKind;
import simrobot.process.RobotProcess;
import simrobot.process.Wander;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import simrobot.world.WorldReader;
import vericommand.VeriCommandSettings;

/** The console's commands on two robots whose modems have no centre and whose simulation stands. */
class RobotConsoleTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private SimRobot simRobot;
    private Fleet fleet;

    @BeforeEach
    void twoRobots() {
        World world = World.of("wall", List.of(new Segment(1, -2, 1, 2)));
        Simulation simulation = new Simulation(world, 1);
        simRobot = new SimRobot(simulation, new InetSocketAddress(0), VeriCommandSettings.DEFAULT, AudioOutput.SILENT);
        for (int i = 0; i < 2; i++) {
            simRobot.add(
                    simulation.addRobot("r" + i, new Position(0, i), 0),
                    new Msisdn("555020" + i),
                    Imei.random(new Random(i)),
                    ModemOptions.STANDARD);
        }
        fleet = new Fleet(
                simRobot,
                new Fleet.Kit(
                        1,
                        true,
                        true,
                        BehaviourKind.NONE,
                        SpeechCodec.Kind.A_LAW,
                        1500,
                        Optional.empty(),
                        Optional.empty(),
                        robot -> CallAudioListener.NONE,
                        number -> Optional.empty()));
        simRobot.simulation().setPaused(true);
        simRobot.simulation().start();
    }

    @AfterEach
    void close() {
        simRobot.close();
    }

    private List<String> answers(String... commands) throws Exception {
        out.reset();
        Console console = new Console(new PrintStream(out, true, StandardCharsets.UTF_8));
        console.ready(Event.of("ready"));
        simRobot.robots().forEach(robot -> robot.listen(event -> console.emit(event.line(robot.name()))));
        RobotConsole robotConsole = new RobotConsole(
                simRobot,
                fleet,
                new FileExports(simRobot.tracks()::csv, (scene, robot, ending) -> (robot + ending).getBytes()),
                WorldReader::read,
                console::emit);
        console.run(new BufferedReader(new StringReader(String.join("\n", commands))), robotConsole);
        List<String> lines = out.toString(StandardCharsets.UTF_8).lines().toList();
        return lines.subList(1, lines.size());
    }

    @Test
    void aRobotThatIsAddedLaterRunsTheNewestVersionOfTheProcess() throws Exception {
        Fleet.Kit kit = new Fleet.Kit(
                1,
                true,
                true,
                new BehaviourKind("Mine", around -> {
                    throw new AssertionError("the version of the start");
                }),
                SpeechCodec.Kind.A_LAW,
                1500,
                Optional.empty(),
                Optional.empty(),
                robot -> CallAudioListener.NONE,
                number -> Optional.empty());
        fleet = new Fleet(simRobot, kit);
        fleet.add(RobotName.parse("r2=5550202"), Optional.empty());
        List<String> begun = new ArrayList<>();
        BehaviourKind version = new BehaviourKind("Mine", around -> {
            begun.add("new version");
            return RobotProcess.inPlace(new Wander(around.robotNumber()));
        });
        simRobot.simulation().withSimulation(owned -> owned.behaviours().put(version));
        fleet.add(RobotName.parse("r3=5550203"), Optional.empty());
        assertEquals(List.of("new version"), begun);
    }

    @Test
    void statusPoseAndSonarAreAnswered() throws Exception {
        List<String> answers = answers("status", "pose", "sonar");
        assertEquals("status robot=r0 value=Stopped", answers.get(0));
        assertEquals("pose robot=r0 x=0.0000 y=0.0000 heading=0.00", answers.get(1));
        assertTrue(answers.get(2).matches("sonar robot=r0 ranges=([0-9]+,){15}[0-9]+"), answers.get(2));
    }

    @Test
    void theSimulationIsPausedSteppedAndGivenItsSpeed() throws Exception {
        assertEquals(
                List.of("speed value=0", "step count=1 time=0.01", "step count=250 time=2.51"),
                answers("speed 0", "step", "step 250"));
        List<String> answers = answers("speed 2.5", "step", "speed 1000", "speed 0");
        assertEquals("speed value=2.5", answers.get(0));
        assertTrue(answers.get(1).startsWith("error text=\"step: the simulation runs"), answers.get(1));
        assertEquals(List.of("speed value=1000", "speed value=0"), answers.subList(2, 4));
    }

    @Test
    void speedsAndStepsThatAreNoneAreErrorsAndChangeNothing() throws Exception {
        answers("speed 0");
        for (String command : List.of(
                "speed",
                "speed -1",
                "speed fast",
                "speed 1001",
                "speed NaN",
                "speed 1d",
                "speed 0x1p3",
                "step 0",
                "step 10001",
                "step x")) {
            assertTrue(answers(command).get(0).startsWith("error text="), command);
        }
        assertEquals(List.of("step count=1 time=0.01"), answers("step"));
    }

    @Test
    void theLaserAnswersWith181Ranges() throws Exception {
        List<String> answers = answers("laser");
        assertTrue(answers.get(0).matches("laser robot=r0 ranges=([0-9]+,){180}[0-9]+"), answers.get(0));
    }

    @Test
    void switchesAnswerWithTheStatusOnceWhetherItChangesOrNot() throws Exception {
        assertEquals(
                List.of(
                        "status robot=r0 value=Stopped",
                        "status robot=r0 value=Disconnected",
                        "status robot=r0 value=Disconnected",
                        "status robot=r0 value=Disconnected",
                        "status robot=r0 value=\"No motors\"",
                        "status robot=r0 value=Stopped"),
                answers("power on", "power off", "power off", "motors off", "power on", "motors on"));
    }

    @Test
    void theRobotThatIsNamedIsMeantElseTheFirst() throws Exception {
        assertEquals(
                List.of(
                        "pose robot=r1 x=0.0000 y=1.0000 heading=0.00",
                        "status robot=r1 value=\"No motors\"",
                        "status robot=r0 value=Stopped"),
                answers("@r1 pose", "@r1 motors off", "status"));
    }

    @Test
    void aPlacedRobotBeginsAnewWithoutItsTrail() throws Exception {
        answers("step", "place -1.5 .25 -90", "step");
        assertEquals(1, simRobot.scene().robots().get(0).trail().size());
    }

    @Test
    void placePutsTheRobotThereAndTellsItsPose() throws Exception {
        assertEquals(List.of("pose robot=r0 x=-1.5000 y=0.2500 heading=270.00"), answers("place -1.5 .25 -90"));
    }

    @Test
    void aWorldIsLoadedWhileRunningAndAgainWhenItsFileHasChanged(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("a hall.map");
        Files.writeString(
                file, "2D-Map\nCairn: RobotHome 1000 2000 90 \"\" ICON \"a\"\nLINES\n0 0 9000 0\nDATA\n4 4\n");
        assertEquals(
                List.of(
                        "world name=\"a hall.map\" lines=1 points=1 homes=1",
                        "pose robot=r0 x=1.0000 y=2.0000 heading=90.00"),
                answers("world " + file, "pose"));
        Files.writeString(
                file, "2D-Map\nCairn: RobotHome 3000 2000 0 \"\" ICON \"a\"\nLINES\n0 0 9000 0\n0 0 0 9000\n");
        assertEquals(
                List.of(
                        "world name=\"a hall.map\" lines=2 points=0 homes=1",
                        "pose robot=r0 x=3.0000 y=2.0000 heading=0.00",
                        "world name=\"a hall.map\" lines=2 points=0 homes=1"),
                answers("world \"" + file + "\"", "pose", "world"));
    }

    @Test
    void aFileThatIsNoWorldChangesNothing(@TempDir Path folder) throws Exception {
        Path text = Files.writeString(folder.resolve("text.map"), "hello\n");
        String before = answers("world").get(0);
        List<String> answers = answers("world " + text, "world " + folder.resolve("gone.map"), "world");
        assertTrue(answers.get(0).matches("error text=\"world: .*text.map:1: found .*expected .*"), answers.get(0));
        assertTrue(answers.get(1).matches("error text=\"world: .*gone.map: no such file\""), answers.get(1));
        assertEquals(before, answers.get(2));
    }

    @Test
    void cameraWritesWhatTheRobotSeesAsItsFilesNameSays(@TempDir Path folder) throws Exception {
        Path png = folder.resolve("a view.png");
        Path jpeg = folder.resolve("view.JPG");
        List<String> answers = answers("camera " + png, "@r1 camera \"" + jpeg + "\"");
        assertEquals("camera robot=r0 file=\"" + png + "\" width=320 height=240", answers.get(0));
        assertTrue(answers.get(1).startsWith("camera robot=r1 file="), answers.get(1));
        assertEquals(240, ImageIO.read(png.toFile()).getHeight());
        assertEquals(0xFFD8, ByteBuffer.wrap(Files.readAllBytes(jpeg)).getShort() & 0xFFFF);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "camera|expected a file that ends in .png, .jpg or .jpeg, found nothing after it",
                "camera view.gif|found view.gif",
                "camera nowhere-at-all/view.png|expected a folder that is there",
                "place 1 0 0|in the way",
                "place 0 1 0|in the way",
                "place 0 0|expected X Y HEADING",
                "place 0 0 0 0|expected X Y HEADING",
                "place 100 100 0|place 100 100 0: outside the world",
                "place 0 -10.01 0|outside the world",
                "place a 0 0|a number for X, found a",
                "place 0 NaN 0|a number for Y, found NaN",
                "place 0 0 1e99|a number for HEADING",
                "power|expected on or off",
                "power maybe|found maybe",
                "motors off now|expected on or off",
                "status please|expected nothing after it",
                "bogus|unknown command bogus",
                "@r9 status|no robot r9, expected one of r0, r1",
                "@r1|unknown command behind @r1",
                "@|no robot"
            })
    void aCommandThatCannotBeDoneIsAnErrorAndTheProgramGoesOn(String command, String words) throws Exception {
        List<String> answers = answers(command, "status");
        assertTrue(answers.get(0).startsWith("error text=") && answers.get(0).contains(words), answers.get(0));
        assertEquals("status robot=r0 value=Stopped", answers.get(1));
        assertEquals(2, answers.size());
    }

    @Test
    void aSimulationThatDoesNotAnswerIsAnErrorWithinABound() throws Exception {
        simRobot.close();
        Simulation simulation = new Simulation(World.bare(), 1);
        simRobot = new SimRobot(
                simulation,
                new InetSocketAddress(0),
                VeriCommandSettings.DEFAULT,
                AudioOutput.SILENT,
                Duration.ofMillis(1));
        simRobot.add(
                simulation.addRobot("r0"), new Msisdn("5550200"), Imei.random(new Random(1)), ModemOptions.STANDARD);
        assertEquals(
                List.of("error text=\"the simulation does not answer, expected an answer within 0.001 s\""),
                answers("place 1 1 0"));
        CompletableFuture<Double> later = new CompletableFuture<>();
        simRobot.simulation()
                .withSimulation(here -> later.complete(here.robots().get(0).xMeters()));
        simRobot.simulation().start();
        assertEquals(0, later.get(20, TimeUnit.SECONDS), "what was given up is not done later");
    }

    @Test
    void motorsOfARobotThatIsOffStayOff() throws Exception {
        List<String> answers = answers("power off", "motors on");
        assertTrue(answers.get(1).contains("the robot is off"), answers.get(1));
    }

    @Test
    void aMovingRobotIsNotPlaced() throws Exception {
        simRobot.onSimulation(() -> {
            simRobot.robots().get(0).robot().start(new vericommand.Instruction.Turn(90), outcome -> {});
            return null;
        });
        List<String> answers = answers("place -1 0 0", "status");
        assertTrue(answers.get(0).contains("moving"), answers.get(0));
        assertEquals("status robot=r0 value=Moving", answers.get(1));
    }

    @Test
    void aRobotIsAddedWithItsNumberAndItsPlaceAndAnswersByItsName() throws Exception {
        assertEquals(
                List.of(
                        "added robot=r2 number=5550202",
                        "pose robot=r2 x=-1.0000 y=-1.0000 heading=90.00",
                        "status robot=r2 value=Stopped"),
                answers("add r2=5550202 -1 -1 90", "@r2 status"));
    }

    @Test
    void aRobotWithoutAPlaceIsAddedWhereItFits() throws Exception {
        List<String> answers = answers("add r2=5550202");
        assertEquals("added robot=r2 number=5550202", answers.get(0));
        assertTrue(answers.get(1).startsWith("pose robot=r2 "), answers.get(1));
    }

    @Test
    void aRobotThatIsRemovedIsNoLongerThereAndTheNextOneIsTheFirst() throws Exception {
        List<String> answers = answers("@r0 remove", "robots", "pose", "@r0 pose");
        assertEquals("status robot=r0 value=Disconnected", answers.get(0));
        assertEquals("removed robot=r0 number=5550200", answers.get(1));
        assertEquals("robot robot=r1 number=5550201", answers.get(2));
        assertEquals("end of=robots count=1", answers.get(3));
        assertEquals("pose robot=r1 x=0.0000 y=1.0000 heading=0.00", answers.get(4));
        assertEquals("error text=\"no robot r0, expected one of r1\"", answers.get(5));
    }

    @Test
    void withoutAnyRobotTheConsoleSaysHowToMakeOne() throws Exception {
        List<String> answers = answers("remove", "remove", "status");
        assertEquals(
                "error text=\"there is no robot, expected add NAME=NUMBER first\"", answers.get(answers.size() - 1));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "add r1=5550209|robot r1 is there already",
                "add r9=5550200|another robot has the number 5550200",
                "add r9|expected NAME=NUMBER, found r9",
                "add|expected NAME=NUMBER [X Y HEADING], found nothing after it",
                "add r9=5550209 1 2|expected NAME=NUMBER [X Y HEADING]",
                "add r9=abc|is not a telephone number",
                "add a b=5550209|expected",
                "add r9=5550209 0 0 0|something is in the way there",
                "add r9=5550209 90 0 0|outside the world",
                "add r9=5550209 x 0 0|add: expected a number for X, found x",
                "robots now|expected nothing after it",
                "@r1 remove it|expected nothing after it"
            })
    void whatCannotBeAddedIsNamed(String command, String fault) throws Exception {
        String answer = answers(command).get(0);
        assertTrue(answer.startsWith("error text=") && answer.contains(fault), answer);
    }

    @Test
    void aPictureAndATrackAreExportedByTheFilesEnding(@TempDir Path folder) throws Exception {
        Path svg = folder.resolve("world.svg");
        Path csv = folder.resolve("r1.csv");
        assertEquals(
                List.of("exported robot=r0 file=" + svg, "exported robot=r1 file=" + csv),
                answers("export " + svg, "@r1 export " + csv));
        assertEquals("r0svg", Files.readString(svg));
        assertEquals("time s,x m,y m,heading degrees,status\n0.00,0.0000,1.0000,0.00,Stopped\n", Files.readString(csv));
    }

    @Test
    void whatCannotBeExportedIsNamed(@TempDir Path folder) throws Exception {
        List<String> answers = answers(
                "export", "export world.gif", "export " + folder.resolve("no").resolve("w.svg"));
        assertTrue(answers.get(0).contains("expected a file that ends in .png, .svg or .csv, found nothing after it"));
        assertTrue(answers.get(1).contains("found world.gif"), answers.get(1));
        assertTrue(answers.get(2).contains("expected a folder that is there"), answers.get(2));
    }
}
