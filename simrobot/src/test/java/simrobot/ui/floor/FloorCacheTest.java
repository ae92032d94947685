package simrobot.ui.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.draw.Appearance;
import simgsm.ui.Theme;
import simrobot.drawing.Layers;
import simrobot.drawing.Viewport;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.Point;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import simrobot.world.WorldBuilder;

/** A floor that is shifted while it is dragged looks as one that is painted anew. */
class FloorCacheTest {
    private static final int WIDTH = 420;
    private static final int HEIGHT = 300;

    @BeforeEach
    void theme() {
        Theme.install(Appearance.LIGHT);
    }

    private static World world() {
        Random chance = new Random(2);
        List<Segment> walls = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            double x = chance.nextDouble() * 30;
            double y = chance.nextDouble() * 30;
            walls.add(new Segment(x, y, x + chance.nextGaussian(), y + chance.nextGaussian()));
        }
        WorldBuilder world = World.of("w", walls).toBuilder();
        for (int i = 0; i < 500; i++) {
            world.add(new Point(chance.nextDouble() * 30, chance.nextDouble() * 30));
        }
        return world.add(new Box("desk", new Area(8, 8, 10, 11, 0.3)))
                .add(new Home("a home with a name", new Position(15, 15), 1, Optional.empty()))
                .build();
    }

    private static int[] painted(FloorCache cache, World world, Viewport view, double scale) {
        BufferedImage screen =
                new BufferedImage((int) (WIDTH * scale), (int) (HEIGHT * scale), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = screen.createGraphics();
        g.scale(scale, scale);
        cache.paint(g, world, view, Layers.ALL);
        g.dispose();
        return screen.getRGB(0, 0, screen.getWidth(), screen.getHeight(), null, 0, screen.getWidth());
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 2})
    void aDraggedFloorIsThatOfItsPlace(double scale) {
        World world = world();
        Random chance = new Random(3);
        FloorCache dragged = new FloorCache();
        Viewport view = new Viewport(15, 15, 24, WIDTH, HEIGHT);
        for (int i = 0; i < 40; i++) {
            view = view.draggedBy(chance.nextInt(120) - 60, chance.nextInt(120) - 60);
            if (i % 10 == 9) {
                view = view.zoomedAt(100, 100, i % 20 == 9 ? 1.3 : 0.8);
            }
            int[] expected = painted(new FloorCache(), world, view, scale);
            int[] found = painted(dragged, world, view, scale);
            int different = 0;
            for (int pixel = 0; pixel < expected.length; pixel++) {
                for (int shift = 0; shift < 24; shift += 8) {
                    int difference = (expected[pixel] >> shift & 255) - (found[pixel] >> shift & 255);
                    different += Math.abs(difference) > 8 ? 1 : 0;
                }
            }
            assertEquals(0, different, "pixels after drag " + i);
        }
    }
}
