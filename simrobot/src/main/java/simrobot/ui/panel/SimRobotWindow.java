package simrobot.ui.panel;

import java.awt.Dimension;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import simgsm.ui.SnapshotPoller;
import simgsm.ui.Symbol;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.SuiteWindow;
import simrobot.ui.OperatorActions;
import simrobot.ui.SimRobotTexts;
import simrobot.ui.WindowSnapshot;

/** The content of SimRobot's window: {@link SimRobotPanel} with a poller of snapshots. */
public final class SimRobotWindow {
    private static final Dimension SIZE = new Dimension(1120, 800);

    private SimRobotWindow() {}

    /**
     * Creates the content on the event thread.
     *
     * @param snapshots read by the event thread; the same object until a change
     */
    public static ProgramWindow.Content content(
            String title, Locale language, Supplier<WindowSnapshot> snapshots, OperatorActions operator) {
        SimRobotPanel panel = new SimRobotPanel(language, snapshots.get(), operator);
        SnapshotPoller<WindowSnapshot> newest = new SnapshotPoller<>(snapshots, panel::show);
        newest.start();
        return new ProgramWindow.Content(
                title,
                SimRobotTexts.in(language).of("help"),
                Symbol.ROBOT,
                panel,
                Optional.of(SIZE),
                Optional.of(SuiteWindow.ROBOT.least()),
                panel::leave,
                panel::focusFloor,
                newest::stop);
    }
}
