package simgsm.center;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import simgsm.console.Arguments;
import simgsm.ui.Display;

/** The demo with a display: three windows side by side, ready to dial; closing the centre's ends them all. */
final class WindowedDemo {
    private WindowedDemo() {}

    static int run(Arguments arguments, CenterSettings settings) throws IOException, InterruptedException {
        DemoLayout layout = DemoLayout.of(Display.usableArea());
        try (DemoPrograms programs = DemoPrograms.open(arguments, settings)) {
            programs.startPhone(
                    Redirect.DISCARD,
                    "--end-with-input",
                    "--window",
                    layout.phone().toString());
            programs.startRobot(
                    Redirect.DISCARD,
                    "--end-with-input",
                    "--window",
                    layout.robot().toString());
            return CenterWindow.run(
                    programs.center(),
                    arguments,
                    settings,
                    programs.children(),
                    settings.place().orElse(layout.center()));
        }
    }
}
