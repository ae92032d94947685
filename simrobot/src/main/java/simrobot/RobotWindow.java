package simrobot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.UsageException;
import simgsm.ui.Appearance;
import simgsm.ui.Display;
import simgsm.ui.WindowPlace;
import simrobot.control.SimRobot;
import simrobot.ui.SimRobotWindow;

/** SimRobot with a window: opens it, waits for its end, and cleans up. */
final class RobotWindow {
    private RobotWindow() {}

    static int run(Arguments arguments, SimRobot simRobot, Path worldFile) throws UsageException, InterruptedException {
        boolean display = Display.isThere();
        Appearance appearance = arguments
                .value("theme", Appearance::parse)
                .orElseGet(() -> display ? Appearance.ofSystem() : Appearance.LIGHT);
        Optional<WindowPlace> place = arguments.value("window", WindowPlace::parse);
        if (!display) {
            System.err.println("simrobot: there is no display; use --headless for the console");
            return ExitStatus.UNAVAILABLE;
        }
        Runtime.getRuntime().addShutdownHook(new Thread(simRobot::close, "detach"));
        CountDownLatch closed = new CountDownLatch(1);
        WindowModel model = new WindowModel(simRobot, worldFile);
        SimRobotWindow.open(
                "SimRobot " + model.firstNumber(),
                arguments.language(),
                appearance,
                place,
                model::snapshot,
                model,
                closed::countDown);
        simRobot.start();
        if (arguments.has("end-with-input")) {
            endWithInput(closed);
        }
        closed.await();
        simRobot.close();
        return ExitStatus.OK;
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
