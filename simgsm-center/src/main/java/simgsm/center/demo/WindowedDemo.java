package simgsm.center.demo;

import java.lang.ProcessBuilder.Redirect;
import java.util.Optional;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.CenterWindow;
import simgsm.console.Arguments;
import simgsm.ui.window.Display;
import simgsm.ui.window.ProgramWindow;

/** The demo with a display: three windows side by side, ready to dial; closing the centre's window ends all. */
public final class WindowedDemo {
    private WindowedDemo() {}

    public static int run(Arguments arguments, CenterSettings settings) throws Exception {
        DemoLayout layout = DemoLayout.of(Display.usableArea());
        ProgramWindow window =
                ProgramWindow.of(arguments, Optional.of(layout.center())).zoomed(arguments, layout.zoomPercent());
        String zoom = arguments.text("zoom").orElse(String.valueOf(layout.zoomPercent()));
        try (DemoPrograms programs = DemoPrograms.open(arguments, settings)) {
            programs.startPhone(
                    Redirect.DISCARD,
                    "--end-with-input",
                    "--zoom",
                    zoom,
                    "--window",
                    layout.phone().toString());
            // On one machine each tone is heard once, from the phone.
            programs.startRobot(
                    Redirect.DISCARD,
                    "--no-sound",
                    "--end-with-input",
                    "--zoom",
                    zoom,
                    "--window",
                    layout.robot().toString());
            return CenterWindow.run(programs.center(), arguments, settings, programs.children(), window);
        }
    }
}
