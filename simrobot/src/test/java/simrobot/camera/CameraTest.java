package simrobot.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

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
        return World.ofSegments("wall", List.of(new Segment(x, -20, x, 20)));
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
}
