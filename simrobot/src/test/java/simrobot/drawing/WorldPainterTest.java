package simrobot.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.draw.SvgCanvas;
import simgsm.ui.GraphicsCanvas;
import simgsm.ui.Theme;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.ui.panel.WindowBench;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.Instruction;

class WorldPainterTest {
    private static final int WIDTH = 600;
    private static final int HEIGHT = 400;

    @BeforeEach
    @AfterEach
    void light() {
        Theme.install(Appearance.LIGHT);
    }

    private static BufferedImage painted(Simulation simulation, Viewport view, Layers layers, double scale) {
        BufferedImage image =
                new BufferedImage((int) (WIDTH * scale), (int) (HEIGHT * scale), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(scale, scale);
        WorldPainter.paint(new GraphicsCanvas(g), simulation.snapshot(), view, layers, "robot");
        g.dispose();
        return image;
    }

    private static Viewport closeUp() {
        return new Viewport(0, 0, 400, WIDTH, HEIGHT);
    }

    private static Simulation onBareFloor() {
        Simulation simulation = new Simulation(World.bare(), 1);
        simulation.addRobot("robot");
        return simulation;
    }

    /** At the scale in which the demo opens on a screen of 1366x768 Spanish names are wider than some of the boxes. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyNameOfTheDemosWorldIsShown(String language) throws Exception {
        World world = WindowBench.world("demo.map");
        PlaceNames names = PlaceNames.in(Locale.forLanguageTag(language));
        SvgCanvas g = new SvgCanvas(ink -> "#000");
        WorldPainter.floor(g, world, new Viewport(1.5, 0, 54, 688, 332), Layers.ALL.withNames(names));
        String picture = g.elements();
        for (Box box : world.items(Box.class)) {
            for (String word : names.of(box.name()).split(" ", 3)) {
                assertTrue(picture.contains(word), word);
            }
        }
    }

    @Test
    void aNameWiderThanItsBoxIsWrittenBesideItTowardsTheMiddle() {
        List<Box> boxes = List.of(
                new Box("Cupboard", new Area(-1, -2.6, -0.4, -2, 0)),
                new Box("Stairway", new Area(1, 2, 1.6, 2.6, 0)),
                new Box("Sofa", new Area(-3, -2.6, -2.2, -2, 0)));
        Viewport view = new Viewport(0, 0, 60, 600, 400);
        SvgCanvas g = new SvgCanvas(ink -> "#000");
        WorldPainter.floor(g, World.of("room", boxes), view, Layers.ALL);
        for (Box box : boxes) {
            Matcher text = Pattern.compile("<text x=\"[^\"]*\" y=\"([^\"]*)\"[^>]*>" + box.name())
                    .matcher(g.elements());
            assertTrue(text.find(), g.elements());
            double baseline = Double.parseDouble(text.group(1));
            double top = view.screenY(box.area().maxYMeters());
            double bottom = view.screenY(box.area().minYMeters());
            boolean isInside = box.name().equals("Sofa");
            assertEquals(isInside, baseline > top && baseline < bottom, box.name() + " at " + baseline);
            assertTrue(isInside || Math.abs(baseline - view.height() / 2) < 120, box.name() + " at " + baseline);
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 1, es", "0, 1, en", "2, 1, es", "2, 1, en"})
    void aHomeOfANamedRobotHasNoName(double metersAway, int names, String language) throws Exception {
        World world = WindowBench.world("office.map");
        Home home = world.items(Home.class).stream()
                .filter(each -> each.name().equals("Reception"))
                .findFirst()
                .orElseThrow();
        Simulation simulation = new Simulation(world, 1);
        simulation.addRobot(
                "Reception",
                new Position(
                        home.position().xMeters() + metersAway, home.position().yMeters()),
                0);
        simulation.addRobot("Corridor");
        SvgCanvas g = new SvgCanvas(ink -> "#000");
        Layers layers = Layers.ALL.withNames(PlaceNames.in(Locale.forLanguageTag(language)));
        WorldPainter.paint(g, simulation.snapshot(), new Viewport(3, 3, 60, 688, 600), layers, null);
        assertEquals(names, g.elements().split("Recep[tc]i", -1).length - 1, g.elements());
    }

    /** The octagon of 44 x 38 cm has 1,372 cm2; wheels, axle, nose and outline lie on top of it. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1.25, 2})
    void theBodyHasTheSizeOfTheRealOne(double scale) {
        int pixels = WindowBench.count(painted(onBareFloor(), closeUp(), Layers.ALL, scale), Ink.ROBOT);
        double squareMeters = pixels / Math.pow(400 * scale, 2);
        assertTrue(squareMeters > 0.105 && squareMeters < 0.137, squareMeters + " m2");
    }

    @Test
    void theBodyTurnsWithTheHeading() {
        Simulation simulation = onBareFloor();
        SimulatedRobot robot = simulation.robots().get(0);
        // the body's middle lies 4 cm behind the centre of rotation: 26 cm back, 18 cm ahead
        int behind = (int) (WIDTH / 2 - 0.24 * 400);
        assertEquals(
                Theme.color(Ink.ROBOT).getRGB(),
                painted(simulation, closeUp(), Layers.ALL, 1).getRGB(behind, 196));
        robot.place(0, 0, Math.PI);
        assertTrue(Theme.color(Ink.ROBOT).getRGB()
                != painted(simulation, closeUp(), Layers.ALL, 1).getRGB(behind, 196));
    }

    @Test
    void aRobotWithoutPowerIsGrey() {
        Simulation simulation = onBareFloor();
        simulation.robots().get(0).setPower(false);
        assertEquals(0, WindowBench.count(painted(simulation, closeUp(), Layers.ALL, 1), Ink.ROBOT));
    }

    @Test
    void theTrailFadesWithAgeAndCanBeSwitchedOff() {
        Simulation simulation = onBareFloor();
        simulation.robots().get(0).start(new Instruction.Forward(100), ended -> {});
        simulation.run(500);
        Viewport view = new Viewport(0.3, 0, 300, WIDTH, HEIGHT);
        Layers bare = new Layers(false, false, false);
        int none = blueish(painted(simulation, view, bare, 1));
        int fresh = blueish(painted(simulation, view, bare.withTrail(true), 1));
        simulation.run(20_000);
        int old = blueish(painted(simulation, view, bare.withTrail(true), 1));
        assertTrue(fresh > 2 * old, fresh + " then " + old);
        assertTrue(old > none, old + " then " + none);
    }

    /** How much bluer than red the picture is left of the robot. */
    private static int blueish(BufferedImage image) {
        int sum = 0;
        for (int x = 230; x < 380; x++) {
            for (int y = 195; y < 205; y++) {
                int rgb = image.getRGB(x, y);
                sum += Math.max(0, (rgb & 0xFF) - (rgb >> 16 & 0xFF));
            }
        }
        return sum;
    }

    @Test
    void sonarEchoesAreDrawnAndCanBeSwitchedOff() throws Exception {
        Simulation simulation = new Simulation(WindowBench.world("demo.map"), 1);
        simulation.addRobot("robot");
        Viewport view = Viewport.fitting(simulation.world().bounds(), WIDTH, HEIGHT, 20);
        int with = WindowBench.count(painted(simulation, view, Layers.ALL, 2), Ink.FLOOR);
        int without = WindowBench.count(painted(simulation, view, Layers.ALL.withSonar(false), 2), Ink.FLOOR);
        assertTrue(without > with + 2000, with + " and " + without);
    }

    @Test
    void theBeltsChevronsRunWithSimulatedTime() throws Exception {
        Simulation simulation = new Simulation(WindowBench.world("treadmill.map"), 1);
        Viewport view = Viewport.fitting(simulation.world().bounds(), WIDTH, HEIGHT, 20);
        BufferedImage before = painted(simulation, view, Layers.ALL, 1);
        simulation.run(30);
        BufferedImage after = painted(simulation, view, Layers.ALL, 1);
        int changed = 0;
        for (int x = 0; x < WIDTH; x++) {
            changed += before.getRGB(x, HEIGHT / 2 + 2) == after.getRGB(x, HEIGHT / 2 + 2) ? 0 : 1;
        }
        assertTrue(changed > 20, changed + " pixels");
    }

    @Test
    void theScaleBarIsOneTwoOrFiveTimesAPowerOfTen() {
        assertEquals(1, WorldPainter.scaleBarMeters(100));
        assertEquals(2, WorldPainter.scaleBarMeters(50));
        assertEquals(5, WorldPainter.scaleBarMeters(20));
        assertEquals(0.2, WorldPainter.scaleBarMeters(500), 1e-12);
    }

    @Test
    void aWallBelowTheScaleBarIsSeenOnBothSidesOfItsNumber() {
        Viewport view = new Viewport(0, 0, 100, WIDTH, HEIGHT);
        int row = HEIGHT - 20;
        double y = view.centerY() + (HEIGHT / 2.0 - row) / view.pixelsPerMeter();
        World room = World.of("room", List.of(new Segment(-4, y, 4, y)));
        BufferedImage image = painted(new Simulation(room, 1), view, Layers.ALL, 1);
        int wall = Theme.color(Ink.WALL).getRGB();
        for (int x : new int[] {8, 25, 30, 98, 110, 200}) {
            assertEquals(wall, image.getRGB(x, row), "at " + x);
        }
    }

    static List<Path> worlds() throws Exception {
        try (Stream<Path> files = Files.list(Path.of("..", "worlds"))) {
            return files.filter(file -> file.toString().endsWith(".map"))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("worlds")
    void everyWorldOfOursShowsItsWallsInBothAppearances(Path file) throws Exception {
        Simulation simulation =
                new Simulation(WindowBench.world(file.getFileName().toString()), 1);
        Viewport view = Viewport.fitting(simulation.world().bounds(), WIDTH, HEIGHT, 20);
        for (Appearance appearance : Appearance.values()) {
            Theme.install(appearance);
            BufferedImage image = painted(simulation, view, Layers.ALL, 2);
            assertTrue(WindowBench.count(image, Ink.WALL) > 1000, file + " " + appearance);
        }
    }
}
