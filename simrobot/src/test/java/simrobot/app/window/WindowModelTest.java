package simrobot.app.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import simgsm.air.Imei;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.modem.ModemOptions;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simrobot.app.BrokenPipe;
import simrobot.app.SimRobotOptions;
import simrobot.app.ports.ListeningPorts;
import simrobot.control.Fleet;
import simrobot.control.RobotEvent;
import simrobot.control.SimRobot;
import simrobot.control.TelephoneRobot;
import simrobot.process.BehaviourKind;
import simrobot.robot.Placement;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.ui.TelephoneSnapshot;
import simrobot.ui.WindowSnapshot;
import simrobot.ui.inspector.RefusalTexts;
import simrobot.world.World;
import simrobot.world.WorldReader;
import vericommand.Pose;
import vericommand.RobotStatus;
import vericommand.VeriCommandSettings;

/** The window's acts reach the simulation, and its pictures tell of them. */
@Timeout(30)
class WindowModelTest {
    private static final Path WORLDS = Path.of("..", "worlds");

    @TempDir
    Path folder;

    private SimRobot simRobot;
    private SimulatedRobot robot;
    private WindowModel model;
    private Fleet fleet;
    private final RecentWorlds recent = new RecentWorlds(Optional.empty());
    private final List<Placement> placements = new CopyOnWriteArrayList<>();

    @BeforeEach
    void aPausedSimulationWithoutACentre() throws Exception {
        World world = WorldReader.read(WORLDS.resolve("empty.map"));
        Simulation simulation = new Simulation(world, 1);
        robot = simulation.addRobot("robot");
        VeriCommandSettings settings =
                new VeriCommandSettings(Locale.ENGLISH, Set.of(), VeriCommandSettings.OnHangup.STOP);
        // no program listens on port 1: the modem goes on searching
        simRobot = new SimRobot(simulation, new InetSocketAddress("127.0.0.1", 1), settings, AudioOutput.SILENT);
        simRobot.add(robot, new Msisdn("5550200"), Imei.random(new Random(1)), ModemOptions.STANDARD);
        simRobot.simulation().setPaused(true);
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
        model = modelIn(Locale.ENGLISH);
        simRobot.start();
    }

    private WindowModel modelIn(Locale language) throws Exception {
        Arguments plain = SimRobotOptions.all().parse(List.of());
        return new WindowModel(
                simRobot,
                fleet,
                ListeningPorts.open(plain, simRobot),
                WORLDS.resolve("empty.map"),
                recent,
                new RefusalTexts(language));
    }

    @AfterEach
    void end() {
        simRobot.close();
    }

    /** All acts that were posted before are done then. */
    private RobotStatus status() throws Exception {
        return simRobot.onSimulation(robot::status);
    }

    @Test
    void switchesReachTheRobot() throws Exception {
        model.setMotors("robot", false);
        assertEquals(RobotStatus.NO_MOTORS, status());
        model.setPower("robot", false);
        assertEquals(RobotStatus.DISCONNECTED, status());
    }

    @Test
    void aRobotIsPutSomewhereElse() throws Exception {
        model.place("robot", 3, 4, 1, placements::add);
        status();
        assertEquals(3, robot.xMeters());
        model.place("robot", 100, 4, 1, placements::add);
        status();
        assertEquals(List.of(Placement.DONE, Placement.OUTSIDE), placements);
    }

    private String add(String name, String number, Optional<Pose> place) throws Exception {
        CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
        model.addRobot(name, number, place, answer::complete);
        return answer.get(20, TimeUnit.SECONDS).orElse("");
    }

    @Test
    void aRobotIsAddedWithItsOwnTelephoneAndRemovedWithIt() throws Exception {
        assertEquals("", add("anna", "5550209", Optional.of(new Pose(2, 1, 90))));
        assertEquals(
                List.of("robot", "anna"),
                simRobot.robots().stream().map(TelephoneRobot::name).toList());
        assertEquals("5550209", model.snapshot().lines().get(1).number());
        assertTrue(model.snapshot().events().stream()
                .anyMatch(event ->
                        event.robot().equals("anna") && event.line().name().equals("added")));
        model.removeRobot("anna");
        // the same thread does the next act, so the one before is done
        assertEquals("", add("bert", "5550209", Optional.empty()));
        assertEquals(
                List.of("robot", "bert"),
                model.snapshot().lines().stream().map(TelephoneSnapshot::robot).toList());
    }

    @Test
    void aNumberOrAPlaceThatIsTakenIsRefusedWithItsReason() throws Exception {
        assertTrue(add("anna", "5550200", Optional.empty()).contains("another robot has the number 5550200"));
        assertTrue(add("anna", "none", Optional.empty()).contains("not a telephone number"));
        assertTrue(add("robot", "5550201", Optional.empty()).contains("there is already"));
        Pose taken = simRobot.onSimulation(robot::pose);
        assertTrue(add("anna", "5550201", Optional.of(taken)).contains("occupied"));
        assertEquals(1, simRobot.robots().size());
    }

    @Test
    void aSpanishWindowRefusesInSpanish() throws Exception {
        model = modelIn(Locale.forLanguageTag("es"));
        assertEquals("otro robot tiene ya el número 5550200", add("anna", "5550200", Optional.empty()));
        assertEquals("\"none\" no es un número de teléfono de 1 a 15 cifras", add("anna", "none", Optional.empty()));
        assertTrue(add("a b", "5550201", Optional.empty()).endsWith("se encontró \"a b\""));
        assertEquals("ya hay un robot robot", add("robot", "5550201", Optional.empty()));
        Pose taken = simRobot.onSimulation(robot::pose);
        assertEquals("el lugar está ocupado", add("anna", "5550201", Optional.of(taken)));
        assertEquals("fuera del mundo", add("anna", "5550201", Optional.of(new Pose(1e5, 0, 0))));
        model.read(Files.writeString(folder.resolve("broken.map"), "2D-Map\nLINES\n1 2 3\n"));
        assertEquals(
                "broken.map:3: se encontró el final de la línea, se esperaba y2 in mm",
                model.snapshot().notice());
        model.read(folder.resolve("nowhere.map"));
        assertTrue(model.snapshot().notice().endsWith("nowhere.map: no existe el archivo"));
        CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
        Path nowhere = folder.resolve("nowhere").resolve("a.map");
        model.save(World.bare(), nowhere, answer::complete);
        assertEquals(Optional.of(nowhere + ": la carpeta no existe"), answer.get(20, TimeUnit.SECONDS));
        CompletableFuture<Optional<String>> picture = new CompletableFuture<>();
        model.export("robot", folder.resolve("nowhere").resolve("a.csv"), picture::complete);
        assertTrue(picture.get(20, TimeUnit.SECONDS).orElse("").endsWith("a.csv: la carpeta no existe"));
    }

    @Test
    void aRobotThatIsNotThereGetsNoActs() throws Exception {
        model.setPower("ghost", false);
        model.place(null, 1, 1, 1, placements::add);
        assertEquals(RobotStatus.STOPPED, status());
    }

    @Test
    void aRecordingThatItsDiskEndsIsToldOfAndNoLongerShown() throws Exception {
        try (BrokenPipe pipe = new BrokenPipe(folder.resolve("session.rec"))) {
            model.record(Optional.of(pipe.path()));
            status();
            assertEquals(Optional.of(pipe.path()), model.snapshot().recording());
            pipe.breakOff();
            model.setBehaviour("robot", BehaviourKind.WANDER);
            simRobot.simulation().withSimulation(owned -> owned.run(60_000));
            status();
            while (model.snapshot().notice().isEmpty()) {
                LockSupport.parkNanos(1_000_000);
            }
            WindowSnapshot told = model.snapshot();
            assertTrue(told.notice().startsWith(pipe.path() + ": "), told.notice());
            assertEquals(Optional.empty(), told.recording());
        }
    }

    @Test
    void pauseStepAndPaceReachTheSimulation() throws Exception {
        long before = simRobot.onSimulation(() -> model.snapshot().simulation().timeNanos());
        model.stepOnce();
        model.setSpeed(5);
        status();
        assertTrue(model.snapshot().paused());
        assertEquals(5, model.snapshot().speed());
        assertTrue(before >= 0);
        model.setPaused(false);
        status();
        assertFalse(model.snapshot().paused());
    }

    @Test
    void anotherWorldIsLoaded() throws Exception {
        model.read(WORLDS.resolve("office.map"));
        status();
        assertEquals("office.map", model.snapshot().worldFile().getFileName().toString());
        assertEquals("", model.snapshot().notice());
        assertEquals(9, robot.xMeters());
    }

    @Test
    void aWorldThatTheUserLoadsIsAmongTheRecentOnes() throws Exception {
        Path office = WORLDS.resolve("office.map").toAbsolutePath().normalize();
        model.load(Files.writeString(folder.resolve("broken.map"), "2D-Map\nLINES\n1 2 3\n"));
        model.load(office);
        Path saved = folder.resolve("saved.map").toAbsolutePath();
        save(saved);
        status();
        save(saved);
        assertEquals(List.of(saved, office), model.recentWorlds());
    }

    /** After a crash the next start would show the draft's copy as the user's world. */
    @Test
    void theCopyOfADraftIsNotAmongTheRecentWorlds() throws Exception {
        Path copy = folder.resolve(".mine.map.draft");
        model.keep(World.bare(), copy);
        Path saved = folder.resolve("mine.map").toAbsolutePath();
        save(saved);
        assertTrue(Files.exists(copy));
        assertEquals(List.of(saved), model.recentWorlds());
    }

    /** The next start would begin with it, and end at once for lack of a place. */
    @Test
    void aWorldThatHasNoRoomForTheRobotsIsNotAmongTheRecentOnes() throws Exception {
        String walls = IntStream.rangeClosed(-800, 800)
                .mapToObj(row -> "-320000 " + 400 * row + " 320000 " + 400 * row + "\n")
                .collect(Collectors.joining());
        Path solid = Files.writeString(folder.resolve("solid.map"), "2D-Map\nLINES\n" + walls);
        model.load(solid);
        Path saved = folder.resolve("saved.map").toAbsolutePath();
        save(saved);
        status();
        assertEquals(
                "the robots do not all fit into solid.map", model.snapshot().notice());
        save(saved);
        assertEquals(List.of(saved), model.recentWorlds());
    }

    /** What the window's worker was given before is done then. */
    private void save(Path file) throws Exception {
        CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
        model.save(World.bare(), file, answer::complete);
        assertEquals(Optional.empty(), answer.get(20, TimeUnit.SECONDS));
    }

    @Test
    void aFileThatIsNoWorldLeavesEverythingAndSaysWhy() throws Exception {
        Path broken = Files.writeString(folder.resolve("broken.map"), "2D-Map\nLINES\n1 2 3\n");
        model.read(broken);
        status();
        assertEquals("empty.map", model.snapshot().worldFile().getFileName().toString());
        assertEquals(
                "broken.map:3: found the end of the line, expected y2 in mm",
                model.snapshot().notice());
        model.read(folder.resolve("nowhere.map"));
        assertTrue(model.snapshot().notice().endsWith("nowhere.map: no such file"));
    }

    @Test
    void aRobotWhoseHomeIsOccupiedStandsBesideIt() throws Exception {
        String map = "2D-Map\nCairn: RobotHome 0 0 0 \"\" ICON \"\"\nLINES\n0 0 1 1\n";
        model.read(Files.writeString(folder.resolve("post.map"), map));
        status();
        assertEquals("post.map", model.snapshot().worldFile().getFileName().toString());
        assertTrue(Math.hypot(robot.xMeters(), robot.yMeters()) >= 0.25);
    }

    @Test
    void tonesThatHaveLeftAreRememberedUntilTheNextCall() {
        SentTones tones = new SentTones();
        tones.accept(new RobotEvent.ToneSent('1'));
        tones.accept(new RobotEvent.ToneSent('3'));
        assertEquals("13", tones.keys());
        tones.accept(new RobotEvent.CallReceived("5550100"));
        assertEquals("", tones.keys());
        for (int i = 0; i < 100; i++) {
            tones.accept(new RobotEvent.ToneSent('6'));
        }
        assertEquals("6".repeat(24), tones.keys());
    }
}
