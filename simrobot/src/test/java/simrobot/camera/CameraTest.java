package simrobot.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.IntPredicate;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Goal;
import simrobot.world.Point;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import simrobot.world.WorldBuilder;

class CameraTest {
    private static final int MIDDLE = Camera.WIDTH / 2;
    private static final int HORIZON = Camera.HEIGHT / 2;

    private static BufferedImage seen(World world, Position... others) {
        Simulation simulation = new Simulation(world, 1);
        simulation.addRobot("seer", new Position(0, 0), 0);
        for (Position other : others) {
            simulation.addRobot("other" + other, other, Math.PI);
        }
        return seen(simulation);
    }

    private static BufferedImage seen(Simulation simulation) {
        SimulationSnapshot scene = simulation.snapshot();
        return new Camera().picture(scene, scene.robot("seer").orElseThrow());
    }

    private static World wallAt(double x) {
        return World.of("wall", List.of(new Segment(x, -20, x, 20)));
    }

    private static boolean isRed(int rgb) {
        return (rgb >> 16 & 0xFF) > 100 && (rgb >> 16 & 0xFF) > 2 * (rgb >> 8 & 0xFF);
    }

    private static boolean isSky(int rgb) {
        return (rgb & 0xFF) > (rgb >> 16 & 0xFF) + 8;
    }

    private static int redPixels(BufferedImage picture, int fromColumn, int toColumn) {
        int count = 0;
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = fromColumn; x < toColumn; x++) {
                count += isRed(picture.getRGB(x, y)) ? 1 : 0;
            }
        }
        return count;
    }

    /** The first row from above that shows no sky. */
    private static int topOfWhatStands(BufferedImage picture, int column) {
        int row = 0;
        while (row < HORIZON && isSky(picture.getRGB(column, row))) {
            row++;
        }
        return row;
    }

    @Test
    void aPictureHasTheContractsSize() {
        BufferedImage picture = seen(World.bare());
        assertEquals(320, picture.getWidth());
        assertEquals(240, picture.getHeight());
    }

    @Test
    void anOpenFloorShowsSkyAboveAndFloorBelowTheHorizon() {
        BufferedImage picture = seen(World.bare());
        assertTrue(isSky(picture.getRGB(MIDDLE, 5)));
        assertFalse(isSky(picture.getRGB(MIDDLE, Camera.HEIGHT - 5)));
    }

    @Test
    void aWallIsAsHighAsItsDistanceSays() {
        double focal = Camera.WIDTH / 2.0 / Math.tan(Math.toRadians(31));
        for (double x : new double[] {2, 3, 5, 8}) {
            double expected = HORIZON - focal * (WallPainter.HEIGHT_METERS - 0.35) / (x - 0.1);
            assertEquals(expected, topOfWhatStands(seen(wallAt(x)), MIDDLE), 1.0, "wall at " + x + " m");
        }
    }

    @Test
    void aWallBehindIsNotSeen() {
        assertEquals(HORIZON, topOfWhatStands(seen(wallAt(-1)), MIDDLE), 8);
        assertTrue(isSky(seen(wallAt(-1)).getRGB(MIDDLE, HORIZON / 2)));
    }

    @Test
    void aWallThatTheRobotTouchesFillsThePicture() {
        BufferedImage picture = seen(wallAt(0.2501));
        for (int row : new int[] {0, HORIZON, Camera.HEIGHT - 1}) {
            assertFalse(isSky(picture.getRGB(MIDDLE, row)), "row " + row);
        }
    }

    @Test
    void aRobotOnTheLeftIsRedOnTheLeft() {
        BufferedImage picture = seen(World.bare(), new Position(2, 0.7));
        assertTrue(redPixels(picture, 0, MIDDLE) > 200);
        assertEquals(0, redPixels(picture, MIDDLE, Camera.WIDTH));
    }

    @Test
    void aRobotTwiceAsFarIsAQuarterAsLarge() {
        int near = redPixels(seen(World.bare(), new Position(1.6, 0)), 0, Camera.WIDTH);
        int far = redPixels(seen(World.bare(), new Position(3.1, 0)), 0, Camera.WIDTH);
        assertEquals(0.25, (double) far / near, 0.06);
    }

    @Test
    void aRobotBehindAWallIsNotSeen() {
        assertEquals(0, redPixels(seen(wallAt(2), new Position(3, 0)), 0, Camera.WIDTH));
        assertTrue(redPixels(seen(wallAt(4), new Position(3, 0)), 0, Camera.WIDTH) > 100);
    }

    @Test
    void theNearerOfTwoRobotsHidesTheOther() {
        int one = redPixels(seen(World.bare(), new Position(1, 0)), 0, Camera.WIDTH);
        int both = redPixels(seen(World.bare(), new Position(1, 0), new Position(3, 0)), 0, Camera.WIDTH);
        assertEquals(one, both, one / 10);
    }

    @Test
    void turningTheRobotMovesWhatItSeesTheOtherWay() {
        Simulation simulation = new Simulation(World.bare(), 1);
        SimulatedRobot seer = simulation.addRobot("seer", new Position(0, 0), 0);
        simulation.addRobot("other", new Position(2, 0), 0);
        seer.place(0, 0, Math.toRadians(20));
        BufferedImage picture = seen(simulation);
        assertEquals(0, redPixels(picture, 0, MIDDLE));
        assertTrue(redPixels(picture, MIDDLE, Camera.WIDTH) > 200);
    }

    @Test
    void aRobotThatIsSwitchedOffSeesNothing() {
        Simulation simulation = new Simulation(wallAt(2), 1);
        simulation.addRobot("seer", new Position(0, 0), 0).setPower(false);
        BufferedImage picture = seen(simulation);
        assertEquals(picture.getRGB(0, 0), picture.getRGB(MIDDLE, HORIZON));
        assertTrue((picture.getRGB(0, 0) & 0xFF) < 0x40);
    }

    @Test
    void theSameSceneGivesTheSamePictureTwice() {
        Simulation simulation = new Simulation(wallAt(3), 1);
        simulation.addRobot("seer", new Position(0, 0), 0.3);
        SimulationSnapshot scene = simulation.snapshot();
        Camera camera = new Camera();
        BufferedImage first = camera.picture(scene, scene.robots().get(0));
        BufferedImage second = camera.picture(scene, scene.robots().get(0));
        assertEquals(pixels(first), pixels(second));
    }

    private static List<Integer> pixels(BufferedImage picture) {
        int[] rgb = picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
        return java.util.Arrays.stream(rgb).boxed().toList();
    }

    @Test
    void bothFormatsCanBeReadAgain() throws Exception {
        BufferedImage picture = seen(wallAt(2), new Position(1, 0.3));
        BufferedImage png = ImageIO.read(new ByteArrayInputStream(PictureFile.png(picture)));
        assertEquals(pixels(picture), pixels(png));
        BufferedImage jpeg = ImageIO.read(new ByteArrayInputStream(PictureFile.jpeg(picture)));
        assertEquals(320, jpeg.getWidth());
        assertEquals(240, jpeg.getHeight());
    }

    @Test
    void theFilesNameSaysItsKind() {
        assertTrue(PictureFile.hasKnownEnding(Path.of("a.PNG")));
        assertTrue(PictureFile.hasKnownEnding(Path.of("a.jpg")));
        assertTrue(PictureFile.hasKnownEnding(Path.of("a.jpeg")));
        assertFalse(PictureFile.hasKnownEnding(Path.of("a.gif")));
        assertFalse(PictureFile.hasKnownEnding(Path.of("png")));
    }

    // ---- what one finds one's way by
    // ---------------------------------------------------------------------------------

    private static int count(BufferedImage picture, IntPredicate colour) {
        return (int) pixels(picture).stream().filter(colour::test).count();
    }

    /** Neither wall nor floor, whose red, green and blue are nearly the same, nor sky. */
    private static boolean isColoured(int rgb) {
        int red = rgb >> 16 & 0xFF;
        int green = rgb >> 8 & 0xFF;
        int blue = rgb & 0xFF;
        return Math.max(red, Math.max(green, blue)) - Math.min(red, Math.min(green, blue)) > 60;
    }

    @Test
    void aLongWallHasPostersThatDiffer() {
        Simulation simulation = new Simulation(wallAt(2), 1);
        SimulatedRobot seer = simulation.addRobot("seer", new Position(0, 0), 0);
        Set<List<Integer>> pictures = new HashSet<>();
        for (int poster = 0; poster < 8; poster++) {
            seer.place(0.8, -19.1 + 2.5 * poster, 0);
            BufferedImage picture = seen(simulation);
            pictures.add(pixels(picture));
            assertTrue(count(picture, rgb -> (rgb & 0xFFFFFF) < 0x404040) > 100, "its rim is dark");
        }
        assertEquals(8, pictures.size());
    }

    @Test
    void aShortWallHasNone() {
        World world = World.of("short", List.of(new Segment(2, -0.5, 2, 0.5)));
        assertEquals(0, count(seen(world), CameraTest::isColoured));
    }

    @Test
    void aDoorHasItsNumberOnBothSides() {
        Simulation simulation = new Simulation(
                World.of("door", List.of(new Segment(2, -1.2, 2, -0.5), new Segment(2, 0.5, 2, 1.2))), 1);
        SimulatedRobot seer = simulation.addRobot("seer", new Position(0, 0), 0);
        IntPredicate blue = rgb -> (rgb & 0xFF) - (rgb >> 16 & 0xFF) > 40 && (rgb & 0xFF) < 130;
        for (double x : new double[] {1.2, 2.8}) {
            seer.place(x, -0.69, x < 2 ? 0 : Math.PI);
            assertTrue(count(seen(simulation), blue) > 1500, "from x = " + x);
        }
        seer.place(1.2, 0.69, 0);
        assertEquals(0, count(seen(simulation), blue), "the other side of the door has none");
    }

    @Test
    void goalsHaveFlagsInColoursOfTheirOwn() {
        List<Integer> colours = new ArrayList<>();
        for (double y : new double[] {0, 3}) {
            WorldBuilder world = World.bare().toBuilder();
            world.add(new Goal("Goal", "one", new Position(1.5, y), 0));
            world.add(new Goal("Goal", "two", new Position(1.5, 3 - y), 0));
            BufferedImage picture = seen(world.build());
            int flag = picture.getRGB(MIDDLE - 15, (int) (HORIZON - 266 * 0.12 / 1.4));
            assertTrue(isColoured(flag), Integer.toHexString(flag));
            colours.add(flag);
        }
        assertEquals(2, Set.copyOf(colours).size());
    }

    /** A laser's points lie up to 1 cm beside the wall; as posts they looked like corrugated iron. */
    @Test
    void aWallOfScannedPointsIsSmooth() {
        Random noise = new Random(1);
        WorldBuilder world = World.bare().toBuilder();
        for (double y = -2; y < 2; y += 0.03) {
            world.add(new Point(2 + noise.nextGaussian() * 0.005, y));
        }
        BufferedImage picture = seen(world.build());
        for (int column = 1; column < Camera.WIDTH; column++) {
            int here = picture.getRGB(column, HORIZON) & 0xFF;
            int before = picture.getRGB(column - 1, HORIZON) & 0xFF;
            assertEquals(before, here, 3, "column " + column);
        }
        assertFalse(isSky(picture.getRGB(MIDDLE, HORIZON - 10)), "and without gaps");
    }
}
