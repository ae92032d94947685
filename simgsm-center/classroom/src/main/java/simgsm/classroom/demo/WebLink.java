package simgsm.classroom.demo;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import simgsm.center.app.CenterCommands;
import simgsm.classroom.session.Session;
import simgsm.classroom.session.SessionFailure;
import simgsm.console.Arguments;
import simgsm.console.Console;
import simgsm.console.Event;
import simgsm.console.Program;
import simgsm.console.UsageException;

/** {@code --web PORT}: a gateway for the demo, so that browsers are phones of its network. */
final class WebLink {
    private static final String OPTION = "web";
    /** The gateway's console. */
    static final String GATEWAY = "gateway";

    private static final double START_SECONDS = 120;
    private static final Logger LOG = System.getLogger(WebLink.class.getName());

    private WebLink() {}

    static boolean isWanted(Arguments arguments) {
        return arguments.has(OPTION);
    }

    /** SimRobot's options that let the pages show its map; none without {@code --web}. */
    static Stream<String> robotOptions(Arguments arguments) {
        return isWanted(arguments) ? Stream.of("--http", "0") : Stream.of();
    }

    /**
     * Starts the gateway once SimRobot is ready.
     *
     * @param robots the name of SimRobot's console
     * @param numbers range for browsers, as FROM-TO; empty for the gateway's choice
     * @return the link; empty without {@code --web}
     */
    static Optional<String> start(Arguments arguments, Session session, String robots, Optional<String> numbers)
            throws IOException, SessionFailure, InterruptedException {
        if (!isWanted(arguments)) {
            return Optional.empty();
        }
        String http = session.consoles()
                .await(robots, "ready", START_SECONDS)
                .fields()
                .get("http");
        List<String> options = new ArrayList<>(List.of(
                "--headless", "--web", arguments.text(OPTION).orElseThrow(), "--robots", "http://127.0.0.1:" + http));
        arguments.text("bind").ifPresent(address -> options.addAll(List.of("--bind", address)));
        numbers.ifPresent(range -> options.addAll(List.of("--numbers", range)));
        session.start(GATEWAY, "simgsm-gateway", "", options);
        return Optional.of(session.consoles()
                .await(GATEWAY, "ready", START_SECONDS)
                .fields()
                .get("link"));
    }

    /** Locks new browsers out, or admits them again. */
    static void lock(Session session, boolean isLocked) {
        try {
            session.consoles().perform(GATEWAY + " lock " + (isLocked ? "on" : "off"));
        } catch (SessionFailure ended) {
            LOG.log(Level.WARNING, "the link cannot be locked: {0}", ended.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Runs without a display: starts SimRobot and, if wanted, the gateway, prints the link and the students' commands,
     * and performs the centre's commands until the input ends.
     */
    static int serve(
            Arguments arguments,
            Session session,
            String robots,
            List<String> options,
            Optional<String> numbers,
            List<Event> students)
            throws IOException, SessionFailure, InterruptedException, UsageException {
        try (Console console = Console.onStandardOutput()) {
            session.center().start(session.centerEvents().andThen(console::tell));
            session.start(robots, "simrobot", Session.ROBOT_NUMBER, options);
            Optional<String> link = start(arguments, session, robots, numbers);
            Event ready = session.center().ready();
            console.ready(link.map(url -> ready.with("link", url)).orElse(ready));
            students.forEach(console::emit);
            Program.runConsole(console, arguments, new CenterCommands(session.center(), console));
            return console.exitStatus();
        }
    }
}
