package simgsm.classroom.demo;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.center.app.CenterSettings;
import simgsm.classroom.session.Consoles;
import simgsm.classroom.session.Session;
import simgsm.classroom.session.SessionFailure;
import simgsm.classroom.ui.ClassroomTexts;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.TextBundle;
import simgsm.console.UsageException;

/** The demo without a display: the same programs perform the script {@code demo.txt} and print a transcript. */
public final class HeadlessDemo {
    static final String WORLD = "worlds/demo.map";

    private static final String HEADING = "== ";

    private HeadlessDemo() {}

    public static int run(Arguments arguments, CenterSettings settings)
            throws IOException, InterruptedException, UsageException {
        if (WebLink.isWanted(arguments)) {
            return serve(arguments, settings);
        }
        DemoTranscript transcript = new DemoTranscript(Program.standardOutput());
        TextBundle texts = ClassroomTexts.in(settings.language());
        try (Session session = Session.open(arguments, folder -> settings)) {
            transcript.heading(
                    texts.of("demo.start", Integer.toString(session.center().port())));
            session.consoles().listen(transcript);
            session.center().start(session.centerEvents());
            session.start(
                    "robot",
                    "simrobot",
                    Session.ROBOT_NUMBER,
                    List.of("--headless", "--no-sound", "--speak", "--world", WORLD));
            session.start("phone", "simgsm-phone", Session.PHONE_NUMBER, List.of("--headless", "--no-sound"));
            play(session.consoles(), transcript, texts);
        } catch (SessionFailure failure) {
            transcript.heading(texts.of("demo.failed", failure.getMessage()));
            return ExitStatus.FAILED;
        }
        transcript.heading(texts.of("demo.passed"));
        return ExitStatus.OK;
    }

    private static int serve(Arguments arguments, CenterSettings settings)
            throws IOException, InterruptedException, UsageException {
        try (Session session = Session.open(arguments, folder -> settings)) {
            List<String> options = new ArrayList<>(List.of("--headless", "--no-sound", "--speak", "--world", WORLD));
            WebLink.robotOptions(arguments).forEach(options::add);
            return WebLink.serve(arguments, session, "robot", options, Optional.empty(), List.of());
        } catch (SessionFailure failure) {
            throw new IOException(failure.getMessage(), failure);
        }
    }

    private static void play(Consoles consoles, DemoTranscript transcript, TextBundle texts)
            throws IOException, SessionFailure, InterruptedException {
        for (String line : script()) {
            if (line.startsWith(HEADING)) {
                transcript.heading(texts.of(line.substring(HEADING.length())));
            } else {
                consoles.perform(line.replace("{robot}", Session.ROBOT_NUMBER));
            }
        }
        for (String name : List.of("phone", "robot")) {
            consoles.perform(name + " quit");
            int status = consoles.awaitEnd(name);
            if (status != ExitStatus.OK) {
                throw new SessionFailure(name + ": expected to end with status 0, found " + status);
            }
        }
    }

    private static List<String> script() throws IOException {
        try (InputStream in = HeadlessDemo.class.getResourceAsStream("demo.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> !line.isBlank() && !line.startsWith("#"))
                    .toList();
        }
    }
}
