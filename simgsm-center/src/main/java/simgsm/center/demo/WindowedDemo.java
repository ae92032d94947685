package simgsm.center.demo;

import java.lang.ProcessBuilder.Redirect;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.CenterWindow;
import simgsm.console.Arguments;
import simgsm.ui.window.Display;
import simgsm.ui.window.ProgramWindow;
import simgsm.ui.window.WindowPlace;

/** The demo with a display: three windows that do not cover each other, ready to dial; closing the centre's window ends all. */
public final class WindowedDemo {
    private static final System.Logger LOG = System.getLogger(WindowedDemo.class.getName());

    private WindowedDemo() {}

    public static int run(Arguments arguments, CenterSettings settings) throws Exception {
        OptionalInt wanted = ProgramWindow.zoomPercent(arguments);
        // Desktop libraries and centre load at the same time; the other programs start before the centre's window.
        CompletableFuture<WindowPlace> screen = CompletableFuture.supplyAsync(Display::usableArea);
        try (DemoPrograms programs = DemoPrograms.open(arguments, settings)) {
            DemoLayout layout = DemoLayout.of(screen.join(), wanted);
            if (wanted.isPresent() && layout.zoomPercent() < wanted.getAsInt()) {
                LOG.log(
                        System.Logger.Level.WARNING,
                        "zoom {0} leaves no room for three windows on this screen; {1} is used",
                        wanted.getAsInt(),
                        layout.zoomPercent());
            }
            String zoom = String.valueOf(layout.zoomPercent());
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
            ProgramWindow window =
                    ProgramWindow.of(arguments, Optional.of(layout.center())).zoomed(layout.zoomPercent());
            return CenterWindow.run(programs.center(), arguments, settings, programs.children(), window);
        }
    }
}
