package simrobot;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.UsageException;
import simgsm.ui.Appearance;
import simgsm.ui.Display;
import simgsm.ui.Newest;
import simgsm.ui.Theme;
import simgsm.ui.WindowKeys;
import simgsm.ui.WindowPlace;
import simrobot.control.SimRobot;
import simrobot.ui.SimRobotPanel;
import simrobot.ui.WindowIcon;
import simrobot.ui.WindowSnapshot;

/** SimRobot in a window: builds it, shows it, and cleans up once it is closed. */
final class RobotWindow {
    private static final Dimension SIZE = new Dimension(1120, 800);
    private static final Dimension LEAST = new Dimension(640, 480);

    private RobotWindow() {}

    static int run(Arguments arguments, SimRobot simRobot, Path worldFile) throws UsageException, InterruptedException {
        Appearance appearance = arguments
                .value("theme", Appearance::parse)
                .orElseGet(() -> Display.isThere() ? Appearance.ofSystem() : Appearance.LIGHT);
        WindowPlace place = arguments.value("window", WindowPlace::parse).orElse(null);
        Locale language = arguments.language();
        if (!Display.isThere()) {
            System.err.println("simrobot: there is no display; use --headless for the console");
            return ExitStatus.UNAVAILABLE;
        }
        Runtime.getRuntime().addShutdownHook(new Thread(simRobot::close, "detach"));
        CountDownLatch closed = new CountDownLatch(1);
        WindowModel model = new WindowModel(simRobot, worldFile);
        SwingUtilities.invokeLater(() -> {
            Theme.install(appearance);
            open(model, language, place, closed);
        });
        simRobot.start();
        if (arguments.has("end-with-input")) {
            endWithInput(closed);
        }
        closed.await();
        simRobot.close();
        return ExitStatus.OK;
    }

    private static void open(WindowModel model, Locale language, WindowPlace place, CountDownLatch closed) {
        SimRobotPanel panel = new SimRobotPanel(language, model.snapshot(), model);
        JFrame frame = new JFrame("SimRobot " + model.firstNumber());
        frame.setContentPane(panel);
        frame.setIconImages(WindowIcon.images());
        WindowKeys.install(frame.getRootPane(), language);
        Newest<WindowSnapshot> newest = new Newest<>(model::snapshot, panel::show);
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosed(WindowEvent event) {
                newest.stop();
                closed.countDown();
            }
        });
        Rectangle screen = frame.getGraphicsConfiguration().getBounds();
        frame.setMinimumSize(LEAST);
        frame.setSize(Math.min(SIZE.width, screen.width), Math.min(SIZE.height, screen.height));
        if (place == null) {
            frame.setLocationByPlatform(true);
        } else {
            place.take(frame);
        }
        newest.start();
        frame.setVisible(true);
        panel.focusFloor();
    }

    /** Whoever started the program holds its input open; when that ends, the program ends. */
    private static void endWithInput(CountDownLatch closed) {
        Thread reader = new Thread(
                () -> {
                    try (var input = Program.standardInput()) {
                        while (input.readLine() != null) {
                            // nothing is expected here but the end
                        }
                    } catch (IOException e) {
                        // an input that breaks has ended, too
                    }
                    closed.countDown();
                },
                "input");
        reader.setDaemon(true);
        reader.start();
    }
}
