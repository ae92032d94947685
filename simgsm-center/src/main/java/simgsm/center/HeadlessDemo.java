package simgsm.center;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.UsageException;
import simgsm.ui.Texts;

/** The demo without a display: the same programs, played by a script, with a transcript for the reader. */
final class HeadlessDemo {
    private HeadlessDemo() {}

    static int run(Arguments arguments, CenterSettings settings)
            throws IOException, InterruptedException, UsageException {
        Transcript transcript = new Transcript(Program.standardOutput());
        Texts texts = Messages.in(settings.language());
        try (DemoPrograms programs = DemoPrograms.open(arguments, settings)) {
            play(programs, transcript, texts);
        } catch (DemoFailure failure) {
            transcript.heading(texts.of("demo.failed", failure.getMessage()));
            return ExitStatus.FAILED;
        }
        transcript.heading(texts.of("demo.passed"));
        return ExitStatus.OK;
    }

    private static void play(DemoPrograms programs, Transcript transcript, Texts texts)
            throws IOException, DemoFailure, InterruptedException {
        transcript.heading(
                texts.of("demo.start", Integer.toString(programs.center().port())));
        programs.center()
                .start(event ->
                        transcript.line("centre", ConsoleEvents.of(event).toString()));
        DemoConsole robot =
                new DemoConsole("robot", programs.startRobot(Redirect.PIPE, "--headless", "--no-sound"), transcript);
        DemoConsole phone =
                new DemoConsole("phone", programs.startPhone(Redirect.PIPE, "--headless", "--no-sound"), transcript);
        new DemoSession(phone, robot, transcript, texts).play();
    }
}
