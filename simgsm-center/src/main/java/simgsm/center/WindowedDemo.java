package simgsm.center;

import java.awt.Point;
import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.util.Optional;
import simgsm.console.Arguments;
import simgsm.console.UsageException;

/** The demo with a display: three windows side by side, ready to dial; closing the centre's ends them all. */
final class WindowedDemo {
    /** Top left corners: the phone on the left, SimRobot beside it, the centre lower down between them. */
    private static final String PHONE_PLACE = "0,0";

    private static final String ROBOT_PLACE = "340,0";
    private static final Point CENTER_PLACE = new Point(420, 340);

    private WindowedDemo() {}

    static int run(Arguments arguments) throws IOException, UsageException, InterruptedException {
        try (DemoPrograms programs = DemoPrograms.open(arguments)) {
            programs.startPhone(Redirect.DISCARD, "--end-with-input", "--window", PHONE_PLACE);
            programs.startRobot(Redirect.DISCARD, "--end-with-input", "--window", ROBOT_PLACE);
            return CenterWindow.run(programs.center(), arguments, programs.children(), Optional.of(CENTER_PLACE));
        }
    }
}
