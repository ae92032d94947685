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

    /** @return the lesson that the user has chosen in one of the windows, if any */
    public static Optional<String> run(Arguments arguments, CenterSettings settings) throws Exception {
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
            LessonChoice choice = new LessonChoice();
            choice.listenTo(programs.startPhone(
                    Redirect.PIPE,
                    "--console",
                    "--zoom",
                    zoom,
                    "--window",
                    layout.phone().toString()));
            // On one machine each tone is heard once, from the phone.
            choice.listenTo(programs.startRobot(
                    Redirect.PIPE,
                    "--no-sound",
                    "--console",
                    "--zoom",
                    zoom,
                    "--window",
                    layout.robot().toString()));
            ProgramWindow window =
                    ProgramWindow.of(arguments, Optional.of(layout.center())).zoomed(layout.zoomPercent());
            choice.onChosen(window::close);
            Optional<String> chosen = CenterWindow.run(
                    programs.center(), arguments, settings, programs.children(), window, CenterWindow.Watch.NONE);
            return chosen.or(choice::chosen);
        }
    }
}
