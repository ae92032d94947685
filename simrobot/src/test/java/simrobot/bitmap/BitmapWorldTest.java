package simrobot.bitmap;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.process.Decision;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Distances;
import simrobot.world.MapReader;
import simrobot.world.MapWriter;
import simrobot.world.Point;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

/** Worlds from pictures, as SLAM programs write them. */
class BitmapWorldTest {
    private static final double CELL = 0.05;

    @TempDir
    Path folder;

    /** Two rooms with a door, 8 by 4 m, walls of 3 pixels, a slanting wall and a speck. */
    private static BufferedImage rooms() {
        BufferedImage picture = new BufferedImage(170, 90, BufferedImage.TYPE_BYTE_GRAY);
        Graphics2D g = picture.createGraphics();
        g.setColor(new Color(205, 205, 205));
        g.fillRect(0, 0, 170, 90);
        g.setColor(Color.WHITE);
        g.fillRect(5, 5, 160, 80);
        g.setColor(Color.BLACK);
        g.fillRect(5, 5, 160, 3);
        g.fillRect(5, 82, 160, 3);
        g.fillRect(5, 5, 3, 80);
        g.fillRect(162, 5, 3, 80);
        g.fillRect(85, 5, 3, 45);
        g.fillRect(85, 70, 3, 15);
        g.drawLine(100, 20, 140, 30);
        g.fillRect(40, 60, 1, 1);
        g.dispose();
        return picture;
    }

    private Path yaml(String image, String more) throws IOException {
        return Files.writeString(
                folder.resolve("map.yaml"),
                "image: " + image + "\nresolution: 0.050000\norigin: [-1.0, -2.0, 0.0] # lower left\nnegate: 0\n"
                        + "occupied_thresh: 0.65\nfree_thresh: 0.196\n" + more);
    }

    private World roomsAsPng(String more) throws IOException {
        ImageIO.write(rooms(), "png", folder.resolve("map.png").toFile());
        return BitmapWorld.read(yaml("map.png", more), OptionalDouble.empty());
    }

    @Test
    void wallsLieWhereThePictureIsDark() throws IOException {
        World world = roomsAsPng("");
        assertEquals(1, world.items(Point.class).size());
        assertEquals(-1 + 40.5 * CELL, world.items(Point.class).get(0).xMeters(), 1e-9);
        assertEquals(-2 + (90 - 60.5) * CELL, world.items(Point.class).get(0).yMeters(), 1e-9);
        assertTrue(
                world.items(Segment.class).size() < 40,
                world.items(Segment.class).size() + " walls");
        // the outer wall's left side
        assertEquals(-1 + 5 * CELL, world.bounds().minXMeters(), 1e-9);
        assertEquals(-2 + 5 * CELL, world.bounds().minYMeters(), 1e-9);
        assertEquals(-1 + 165 * CELL, world.bounds().maxXMeters(), 1e-9);
    }

    @Test
    void everyOutlineLiesWithinACellOfADarkOne() throws IOException {
        BufferedImage picture = rooms();
        for (Segment wall : roomsAsPng("").items(Segment.class)) {
            for (int k = 0; k <= 20; k++) {
                double x = wall.x1Meters() + (wall.x2Meters() - wall.x1Meters()) * k / 20;
                double y = wall.y1Meters() + (wall.y2Meters() - wall.y1Meters()) * k / 20;
                assertTrue(isDarkNear(picture, (x + 1) / CELL, 90 - (y + 2) / CELL), wall.toString());
            }
        }
    }

    private static boolean isDarkNear(BufferedImage picture, double column, double row) {
        for (int x = (int) Math.floor(column - 1.5); x <= column + 1.5; x++) {
            for (int y = (int) Math.floor(row - 1.5); y <= row + 1.5; y++) {
                boolean inside = x >= 0 && y >= 0 && x < picture.getWidth() && y < picture.getHeight();
                if (inside && (picture.getRGB(x, y) & 0xff) < 60) {
                    return true;
                }
            }
        }
        return false;
    }

    @Test
    void aSlantingWallIsAFewStraightOnes() throws IOException {
        World world = roomsAsPng("");
        double x = -1 + 120 * CELL;
        double y = -2 + (90 - 25) * CELL;
        long near = world.items(Segment.class).stream()
                .filter(wall ->
                        Distances.toSegment(x, y, wall.x1Meters(), wall.y1Meters(), wall.x2Meters(), wall.y2Meters())
                                < 1.2)
                .filter(wall -> wall.x1Meters() != wall.x2Meters() && wall.y1Meters() != wall.y2Meters())
                .count();
        assertTrue(near >= 1 && near <= 6, near + " slanting walls");
    }

    @Test
    void aPgmGivesTheSameWorld() throws IOException {
        World fromPng = roomsAsPng("");
        BufferedImage picture = rooms();
        ByteArrayOutputStream pgm = new ByteArrayOutputStream();
        pgm.writeBytes("P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n170 90\n255\n".getBytes(StandardCharsets.US_ASCII));
        for (int y = 0; y < 90; y++) {
            for (int x = 0; x < 170; x++) {
                pgm.write(picture.getRaster().getSample(x, y, 0));
            }
        }
        Files.write(folder.resolve("map.pgm"), pgm.toByteArray());
        assertEquals(fromPng, BitmapWorld.read(yaml("map.pgm", ""), OptionalDouble.empty()));
    }

    @Test
    void aPngAloneNeedsAResolution() throws IOException {
        Path file = folder.resolve("map.png");
        ImageIO.write(rooms(), "png", file.toFile());
        World world = BitmapWorld.read(file, OptionalDouble.of(0.1));
        assertEquals(16.5, world.bounds().maxXMeters(), 1e-9);
        IOException refused = assertThrows(IOException.class, () -> BitmapWorld.read(file, OptionalDouble.empty()));
        assertTrue(refused.getMessage().contains("expected --resolution METRES"), refused.getMessage());
    }

    @Test
    void itIsSavedAsAMapAndReadAgain() throws IOException {
        World world = roomsAsPng("");
        World again = MapReader.read("map.yaml", MapWriter.text(world));
        assertEquals(world.items(Segment.class), again.items(Segment.class));
        assertEquals(world.items(Point.class), again.items(Point.class));
        assertEquals(CELL, again.pointDiameterMeters(), 1e-9);
    }

    @Test
    void aRobotFindsItsWayThroughTheDoor() throws IOException {
        World world = roomsAsPng("");
        Simulation simulation = new Simulation(world, 1);
        SimulatedRobot robot = simulation.addRobot("robot", new Position(0, 0), 0);
        Decision.End[] ended = {null};
        robot.autonomy().addEndListener((kind, how) -> ended[0] = how);
        robot.autonomy().begin(simulation.destinations().to("there", new Position(6, 0)));
        for (int second = 0; ended[0] == null && second < 120; second++) {
            simulation.run(100);
        }
        assertEquals(new Decision.Arrived(), ended[0]);
    }

    @Test
    void aTurnedOriginTurnsTheWorldAboutIt() throws IOException {
        ImageIO.write(rooms(), "png", folder.resolve("map.png").toFile());
        Path yaml = Files.writeString(
                folder.resolve("turned.yaml"),
                "\uFEFFimage: 'map.png'\nresolution: 0.05\norigin:\n- 1.0\n- 2.0\n- 1.5707963267948966\n");
        World world = BitmapWorld.read(yaml, OptionalDouble.empty());
        assertEquals(1 - 85 * CELL, world.bounds().minXMeters(), 1e-3);
        assertEquals(2 + 165 * CELL, world.bounds().maxYMeters(), 1e-3);
    }

    @ParameterizedTest
    @ValueSource(
            ints = {
                BufferedImage.TYPE_BYTE_GRAY,
                BufferedImage.TYPE_BYTE_BINARY,
                BufferedImage.TYPE_3BYTE_BGR,
                BufferedImage.TYPE_4BYTE_ABGR,
                BufferedImage.TYPE_BYTE_INDEXED,
                BufferedImage.TYPE_USHORT_GRAY
            })
    void pngOfEveryKindIsReadAsTheJdkReadsIt(int type) throws IOException {
        Random random = new Random(type);
        BufferedImage picture = new BufferedImage(37, 23, type);
        for (int i = 0; i < 37 * 23; i++) {
            picture.setRGB(i % 37, i / 37, random.nextInt() | 0xff000000);
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(picture, "png", png);
        GrayPicture read = PngReader.read("test", png.toByteArray());
        byte[] expected = new byte[37 * 23];
        for (int i = 0; i < expected.length; i++) {
            int rgb = picture.getRGB(i % 37, i / 37);
            boolean gray = picture.getColorModel().getNumComponents() == 1
                    && picture.getRaster().getNumBands() == 1
                    && type != BufferedImage.TYPE_BYTE_INDEXED
                    && type != BufferedImage.TYPE_BYTE_BINARY;
            int sample = gray ? picture.getRaster().getSample(i % 37, i / 37, 0) : 0;
            expected[i] = (byte)
                    (gray
                            ? type == BufferedImage.TYPE_USHORT_GRAY ? sample >> 8 : sample
                            : ((rgb >> 16 & 0xff) + (rgb >> 8 & 0xff) + (rgb & 0xff)) / 3);
        }
        assertArrayEquals(expected, read.gray());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "image: map.png;resolution: 1|found no origin",
                "image: map.png;resolution: x;origin: [0,0,0]|found \"x\" for resolution, expected a number",
                "image: map.png;resolution: 0;origin: [0,0,0]|expected metres above 0",
                "image: map.png;resolution: 1;origin: [0]|expected [x, y, yaw]",
                "image: map.yaml;resolution: 1;origin: [0,0,0]|neither PNG nor PGM"
            })
    void aDescriptionThatIsNotWholeSaysWhatIsExpected(String yaml, String text) throws IOException {
        ImageIO.write(rooms(), "png", folder.resolve("map.png").toFile());
        Path file = Files.writeString(folder.resolve("map.yaml"), yaml.replace(";", "\n"));
        IOException refused = assertThrows(IOException.class, () -> BitmapWorld.read(file, OptionalDouble.empty()));
        assertTrue(refused.getMessage().contains(text), refused.getMessage());
    }

    @Test
    void brokenPicturesAreRefusedAndNeverHang() throws IOException {
        ByteArrayOutputStream whole = new ByteArrayOutputStream();
        ImageIO.write(rooms(), "png", whole);
        byte[] png = whole.toByteArray();
        Random random = new Random(3);
        Path file = folder.resolve("broken.png");
        for (int i = 0; i < 300; i++) {
            byte[] broken = java.util.Arrays.copyOf(png, i % 3 == 0 ? random.nextInt(png.length) : png.length);
            for (int k = 0; k < 3 && broken.length > 0; k++) {
                broken[random.nextInt(broken.length)] = (byte) random.nextInt();
            }
            Files.write(file, broken);
            try {
                BitmapWorld.read(file, OptionalDouble.of(0.05));
            } catch (IOException expected) {
                assertTrue(expected.getMessage().contains("expected"), expected.getMessage());
            }
        }
    }

    /** A device has size 0 and no end. */
    @ParameterizedTest
    @ValueSource(strings = {"device.map", "device.wld", "device.yaml"})
    @DisabledOnOs(OS.WINDOWS)
    void whatIsNoRegularFileIsRefused(String name) throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve(name), Path.of("/dev/null"));
        IOException refusal = assertThrows(IOException.class, () -> BitmapWorld.read(link, OptionalDouble.empty()));
        assertEquals(link + ": expected a regular file, found a folder, a device or a pipe", refusal.getMessage());
    }

    /** Each part has 3 octets, as many encoders write parts of a fixed size. */
    @Test
    void pixelsInManyPartsAreReadAsInOne() throws IOException {
        ByteArrayOutputStream whole = new ByteArrayOutputStream();
        ImageIO.write(rooms(), "png", whole);
        ByteBuffer in = ByteBuffer.wrap(whole.toByteArray());
        ByteBuffer split = ByteBuffer.allocate(8 * in.capacity());
        split.putLong(in.getLong());
        while (in.hasRemaining()) {
            int length = in.getInt();
            int kind = in.getInt();
            int part = kind == 0x49444154 ? 3 : Math.max(1, length);
            for (int done = 0; done == 0 || done < length; done += part) {
                int size = Math.min(part, length - done);
                byte[] content = new byte[size];
                in.get(content);
                split.putInt(size).putInt(kind).put(content).putInt(0);
            }
            in.getInt();
        }
        byte[] parts = Arrays.copyOf(split.array(), split.position());
        assertArrayEquals(shades(PngReader.read("whole", whole.toByteArray())), shades(PngReader.read("parts", parts)));
    }

    private static int[] shades(GrayPicture picture) {
        return IntStream.range(0, picture.width() * picture.height())
                .map(i -> picture.at(i % picture.width(), i / picture.width()))
                .toArray();
    }
}
