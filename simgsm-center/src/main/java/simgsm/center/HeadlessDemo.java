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

    static int run(Arguments arguments) throws IOException, UsageException, InterruptedException {
        Transcript transcript = new Transcript(Program.standardOutput());
        Texts texts = Messages.in(arguments.language());
        try (DemoPrograms programs = DemoPrograms.open(arguments)) {
            programs.center()
                    .start(
                            CenterMain.seed(arguments),
                            event -> transcript.line(
                                    "centre", ConsoleEvents.of(event).toString()));
            transcript.heading(
                    texts.of("demo.start", Integer.toString(programs.center().port())));
            DemoConsole robot = new DemoConsole("robot", programs.startRobot(Redirect.PIPE, "--headless"), transcript);
            DemoConsole phone = new DemoConsole(
                    "phone", programs.startPhone(Redirect.PIPE, "--headless", "--no-sound"), transcript);
            new DemoSession(phone, robot, transcript, texts).play();
            transcript.heading(texts.of("demo.passed"));
            return ExitStatus.OK;
        } catch (DemoFailure failure) {
            transcript.heading(texts.of("demo.failed", failure.getMessage()));
            return ExitStatus.FAILED;
        }
    }
}
