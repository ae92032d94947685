package simgsm.phone.ui;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.time.Clock;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.ObjLongConsumer;
import javax.swing.SwingUtilities;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.phone.handset.Bench;
import simgsm.phone.handset.Handset;
import simgsm.phone.screen.PhoneKey;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/**
 * A handset's panel on a bench: acts are noted and go into a handset at once; pictures are painted without a display. Panels are
 * made, laid out and painted by the event thread: the look's styles are for one thread, and sizes that are set become events.
 */
final class PanelBench {
    final Bench bench;
    final List<String> acts = new ArrayList<>();
    HandsetPanel panel;

    PanelBench(Locale language) {
        this(new Bench(), language);
    }

    PanelBench(Bench bench, Locale language) {
        this.bench = bench;
        TextBundle texts = new TextBundle(
                ResourceBundle.getBundle("simgsm.phone.messages", TextBundle.bundleLocale(language)), Locale.ROOT);
        Clock clock = Clock.fixed(Bench.NOON, ZoneOffset.UTC);
        onEventThread(() -> {
            panel = new HandsetPanel(texts, language, clock, bench.snapshot(), new Controls());
            panel.setSize(panel.getPreferredSize());
            layOut();
        });
    }

    private static void onEventThread(Runnable act) {
        if (SwingUtilities.isEventDispatchThread()) {
            act.run();
            return;
        }
        try {
            SwingUtilities.invokeAndWait(act);
        } catch (InvocationTargetException e) {
            throw new AssertionError(e.getCause());
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private void layOut() {
        layOut(panel);
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    Component find(String name) {
        return ComponentNames.find(panel, name).orElseThrow(() -> new AssertionError("no component named " + name));
    }

    void resize(int width, int height) {
        onEventThread(() -> {
            panel.setSize(width, height);
            panel.doLayout();
        });
    }

    /** Shows the handset's newest snapshot and paints it at a scale. */
    BufferedImage paint(double scale) {
        AtomicReference<BufferedImage> picture = new AtomicReference<>();
        onEventThread(() -> picture.set(painted(scale)));
        return picture.get();
    }

    private BufferedImage painted(double scale) {
        panel.show(bench.snapshot());
        Dimension size = panel.getPreferredSize();
        panel.setSize(size);
        layOut();
        BufferedImage image = new BufferedImage(
                (int) Math.ceil(size.width * scale), (int) Math.ceil(size.height * scale), BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.scale(scale, scale);
        panel.printAll(g);
        g.dispose();
        return image;
    }

    /** How many pixels of the picture have the ink's colour exactly. */
    static int count(BufferedImage image, Ink ink) {
        int count = 0;
        int wanted = Theme.color(ink).getRGB();
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                count += image.getRGB(x, y) == wanted ? 1 : 0;
            }
        }
        return count;
    }

    /** Notes each action and performs it at once. */
    private final class Controls implements HandsetControls {
        @Override
        public void perform(ObjLongConsumer<Handset> action) {
            action.accept(bench.handset, bench.nowNanos);
        }

        @Override
        public void keyDown(PhoneKey key) {
            acts.add("down " + key);
            HandsetControls.super.keyDown(key);
        }

        @Override
        public void keyUp(PhoneKey key) {
            acts.add("up " + key);
            HandsetControls.super.keyUp(key);
        }

        @Override
        public void enterDown() {
            acts.add("down ENTER");
            HandsetControls.super.enterDown();
        }

        @Override
        public void enterUp() {
            acts.add("up ENTER");
            HandsetControls.super.enterUp();
        }

        @Override
        public void charDown(char character) {
            acts.add("down " + character);
            HandsetControls.super.charDown(character);
        }

        @Override
        public void charUp(char character) {
            acts.add("up " + character);
            HandsetControls.super.charUp(character);
        }
    }
}
