package simgsm.classroom.demo;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.CenterTexts;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.TextBundle;
import simgsm.console.UsageException;

/** The demo without a display: the same programs, driven by a script, with a printed transcript. */
public final class HeadlessDemo {
    private HeadlessDemo() {}

    public static int run(Arguments arguments, CenterSettings settings)
            throws IOException, InterruptedException, UsageException {
        DemoTranscript transcript = new DemoTranscript(Program.standardOutput());
        TextBundle texts = CenterTexts.in(settings.language());
        try (DemoPrograms programs = DemoPrograms.open(arguments, settings)) {
            play(programs, transcript, texts);
        } catch (DemoFailure failure) {
            transcript.heading(texts.of("demo.failed", failure.getMessage()));
            return ExitStatus.FAILED;
        }
        transcript.heading(texts.of("demo.passed"));
        return ExitStatus.OK;
    }

    private static void play(DemoPrograms programs, DemoTranscript transcript, TextBundle texts)
            throws IOException, DemoFailure, InterruptedException {
        transcript.heading(
                texts.of("demo.start", Integer.toString(programs.center().port())));
        programs.center()
                .start(event -> transcript.line("centre", Event.from(event).toString()));
        DemoConsole robot =
                new DemoConsole("robot", programs.startRobot(Redirect.PIPE, "--headless", "--no-sound"), transcript);
        DemoConsole phone =
                new DemoConsole("phone", programs.startPhone(Redirect.PIPE, "--headless", "--no-sound"), transcript);
        new DemoSession(phone, robot, transcript, texts).play();
    }
}
