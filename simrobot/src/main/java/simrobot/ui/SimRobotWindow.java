package simrobot.ui;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import simgsm.ui.Appearance;
import simgsm.ui.Newest;
import simgsm.ui.Symbol;
import simgsm.ui.Theme;
import simgsm.ui.WindowIcon;
import simgsm.ui.WindowKeys;
import simgsm.ui.WindowPlace;

/** The frame about {@link SimRobotPanel}; it shows the newest snapshot as long as it is open. */
public final class SimRobotWindow {
    private static final Dimension SIZE = new Dimension(1120, 800);
    private static final Dimension LEAST = new Dimension(640, 480);

    private SimRobotWindow() {}

    /**
     * Opens the window; returns at once.
     *
     * @param snapshots asked by the event thread; the same object as long as nothing has changed
     * @param closed told once, by the event thread
     */
    public static void open(
            String title,
            Locale language,
            Appearance appearance,
            Optional<WindowPlace> place,
            Supplier<WindowSnapshot> snapshots,
            Operator operator,
            Runnable closed) {
        SwingUtilities.invokeLater(() -> {
            Theme.install(appearance);
            SimRobotPanel panel = new SimRobotPanel(language, snapshots.get(), operator);
            JFrame frame = frame(title, language, panel);
            put(frame, place);
            Newest<WindowSnapshot> newest = new Newest<>(snapshots, panel::show);
            frame.addWindowListener(new WindowAdapter() {
                @Override
                public void windowClosed(WindowEvent event) {
                    newest.stop();
                    closed.run();
                }
            });
            newest.start();
            frame.setVisible(true);
            panel.focusFloor();
        });
    }

    private static JFrame frame(String title, Locale language, SimRobotPanel panel) {
        JFrame frame = new JFrame(title);
        frame.setContentPane(panel);
        frame.setIconImages(WindowIcon.images(Symbol.ROBOT));
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        WindowKeys.install(frame.getRootPane(), language);
        return frame;
    }

    private static void put(JFrame frame, Optional<WindowPlace> place) {
        Rectangle screen = frame.getGraphicsConfiguration().getBounds();
        frame.setMinimumSize(LEAST);
        frame.setSize(Math.min(SIZE.width, screen.width), Math.min(SIZE.height, screen.height));
        place.ifPresentOrElse(given -> given.take(frame), () -> frame.setLocationByPlatform(true));
    }
}
