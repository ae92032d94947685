package simrobot.ui.floor;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import simgsm.draw.Appearance;
import simgsm.ui.Theme;
import simrobot.drawing.Layers;
import simrobot.drawing.Viewport;
import simrobot.world.World;
import simrobot.world.WorldReader;

/**
 * How long a picture of the floor takes while it is dragged, in CPU milliseconds of the painting thread, painted without a display:
 *
 * <pre>
 *   java -cp ... simrobot.ui.floor.DragBench columbia.map
 * </pre>
 */
public final class DragBench {
    private static final int WIDTH = 1600;
    private static final int HEIGHT = 1000;
    private static final int FRAMES = 300;

    private static final ThreadMXBean CPU = ManagementFactory.getThreadMXBean();

    private DragBench() {}

    public static void main(String[] args) throws Exception {
        Theme.install(Appearance.LIGHT);
        World world = WorldReader.read(Path.of(args[0]));
        Viewport whole = Viewport.fitting(world.bounds(), WIDTH, HEIGHT, 36);
        for (double zoom : new double[] {1, 2, 5}) {
            measure(world, whole.zoomedAt(WIDTH / 2.0, HEIGHT / 2.0, zoom), zoom);
        }
    }

    private static void measure(World world, Viewport from, double zoom) {
        BufferedImage screen = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        FloorCache cache = new FloorCache();
        double[] millis = new double[FRAMES];
        Viewport view = from;
        for (int i = 0; i < FRAMES; i++) {
            // there and back, as a hand does
            view = view.draggedBy(i / 60 % 2 == 0 ? 9 : -9, i / 90 % 2 == 0 ? 4 : -4);
            Graphics2D g = screen.createGraphics();
            long began = CPU.getCurrentThreadCpuTime();
            cache.paint(g, world, view, Layers.ALL);
            millis[i] = (CPU.getCurrentThreadCpuTime() - began) / 1e6;
            g.dispose();
        }
        Arrays.sort(millis, FRAMES / 3, FRAMES);
        double[] warm = Arrays.copyOfRange(millis, FRAMES / 3, FRAMES);
        System.out.println(String.format(
                Locale.ROOT,
                "zoom %.0f: median %.1f ms, 95 %% %.1f ms, most %.1f ms",
                zoom,
                warm[warm.length / 2],
                warm[warm.length * 95 / 100],
                warm[warm.length - 1]));
    }
}
