package simgsm.classroom.lesson;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import java.util.function.Function;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.classroom.session.Consoles;
import simgsm.classroom.session.Session;
import simgsm.classroom.session.SessionFailure;
import simgsm.classroom.ui.ClassroomTexts;
import simgsm.console.CommandException;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;
import simgsm.console.TextBundle;
import simgsm.lesson.LessonAction;
import simgsm.lesson.LessonProgram;
import simgsm.lesson.LessonRun;

/**
 * The programs of a lesson and their events. Performs the lines of solutions and of the lesson's actions; any thread
 * may call, one at a time.
 */
final class LessonSession implements Consoles.Listener {
    /** Maximum start time of the programs, on a slow machine. */
    private static final double START_SECONDS = 60;

    /** Receives notices for the student; called by the threads of the programs' consoles. */
    interface Watcher {
        default void changed() {}

        /** A program has refused a line of this action. */
        default void refused(String action, String why) {}

        /** A program has ended; {@code isFault}: before it was ready, or with an exit status other than 0. */
        default void ended(String program, int status, boolean isFault) {}

        /** The robot has cleared the call after these seconds without a key. */
        default void idle(String seconds) {}

        /** The user has chosen a lesson in the help of a program's window. */
        default void open(String lesson) {}
    }

    private final LessonRun run;
    private final Session session;
    private final Consoles consoles;
    private final LessonTools tools;
    private final Function<LessonProgram, List<String>> manner;
    private final TextBundle words;
    private final Queue<String> told = new ConcurrentLinkedQueue<>();
    /** True if a tool has failed since the action began. */
    private boolean hasFailed;
    /** The latest action; empty before the first one. */
    private volatile String acted = "";

    private volatile Watcher watcher = new Watcher() {};

    /**
     * @param own folder of a teacher's own lesson
     * @param manner the further options of a program, such as {@code --headless}
     * @param language of the student's texts
     */
    LessonSession(
            LessonRun run,
            Session session,
            Optional<Path> own,
            Function<LessonProgram, List<String>> manner,
            Locale language) {
        this.run = run;
        this.session = session;
        this.manner = manner;
        words = ClassroomTexts.in(language);
        consoles = session.consoles();
        consoles.listen(this);
        tools = new LessonTools(session.children(), session.folder());
        run.put("folder", session.folder().toString());
        own.ifPresent(place -> run.put("lesson", place.toAbsolutePath().toString()));
    }

    @Override
    public void event(String source, Event event) {
        synchronized (run) {
            run.event(source, event);
        }
        watcher.changed();
        report(event, acted, watcher);
    }

    /** @param action the latest one; empty before the first */
    static void report(Event event, String action, Watcher watcher) {
        if (event.name().equals("error") && !action.isEmpty()) {
            watcher.refused(action, event.fields().getOrDefault("text", ""));
        } else if (event.name().equals("call-idle")) {
            watcher.idle(event.fields().getOrDefault("seconds", ""));
        }
    }

    @Override
    public void ended(String name, int status, boolean isFault) {
        watcher.ended(name, status, isFault);
    }

    @Override
    public void lessonChosen(String lesson) {
        watcher.open(lesson);
    }

    void watch(Watcher next) {
        watcher = next;
    }

    /** Queries the run between two events. */
    <T> T ofRun(Function<LessonRun, T> question) {
        synchronized (run) {
            return question.apply(run);
        }
    }

    /** True if the latest action has failed. */
    boolean hasFailed() {
        return hasFailed;
    }

    /** The running programs. */
    Set<String> running() {
        return consoles.running();
    }

    /** Replaces names in braces by their values; {@code isAll}: also by values that students have to find. */
    String replaced(String line, boolean isAll) {
        return ofRun(each -> isAll ? each.solved(line) : each.shown(line));
    }

    /** Receives the centre's events. */
    Consumer<ExchangeEvent> centerEvents() {
        return session.centerEvents();
    }

    /** Receives the centre's ladder. */
    Consumer<ExchangeSnapshot> trace() {
        return new TraceEvents(event -> consoles.add("trace", event));
    }

    /** Starts all programs of the lesson at once, and waits until they are registered. */
    void start() throws IOException, SessionFailure, InterruptedException {
        Optional<String> handover = Optional.ofNullable(run.lesson().center().get("handover"));
        if (handover.isPresent()) {
            center("handover " + handover.get());
        }
        List<LessonProgram> first = run.lesson().programs().stream()
                .filter(program -> !program.isLater())
                .toList();
        List<String> started = new ArrayList<>();
        for (LessonProgram program : first) {
            boolean needsPort = program.options().stream()
                    .anyMatch(option -> replaced(option, true).contains("{"));
            if (needsPort) {
                for (String earlier : started) {
                    consoles.await(earlier, "ready", START_SECONDS);
                }
            }
            launch(program);
            started.add(program.name());
        }
        for (LessonProgram program : first) {
            if (program.options().contains("--number")) {
                consoles.await(program.name(), "registered", START_SECONDS);
            }
        }
    }

    private void startAgain(LessonProgram program) throws IOException, SessionFailure {
        if (consoles.isRunning(program.name())) {
            throw new SessionFailure(words.of("lesson.program.runs", program.name()));
        }
        launch(program);
    }

    private void launch(LessonProgram program) throws IOException {
        List<String> options = new ArrayList<>();
        program.options().forEach(option -> options.add(replaced(option, true)));
        options.addAll(manner.apply(program));
        int number = options.indexOf("--number");
        session.start(program.name(), program.jar(), number < 0 ? "" : options.get(number + 1), options);
    }

    /**
     * Performs one line: {@code answer NAME TEXT}, {@code start} or {@code stop PROGRAM}, {@code tool WORDS}, {@code java
     * FILE WORDS}, {@code at} or {@code submit PROGRAM TEXT}, {@code act NAME INPUT}, {@code SOURCE wait EVENT
     * [FIELD=VALUE]... [SECONDS]}, or a command of a program's console, {@code PROGRAM COMMAND}.
     */
    void perform(String line) throws SessionFailure, InterruptedException {
        String[] parts = line.strip().split("\\s+", 2);
        String rest = parts.length == 2 ? parts[1] : "";
        try {
            switch (parts[0]) {
                case "predict" -> change(each -> each.predict(rest));
                case "answer" -> answer(rest);
                case "hint" -> change(each -> each.hint(rest));
                case "start" -> startAgain(program(rest));
                case "stop" -> {
                    requireRunning(rest);
                    consoles.perform(line);
                }
                case "tool" -> tell(tools.tool(words(rest)));
                case "java" -> tell(tools.source(words(rest)));
                case "drive" -> drive(words(rest));
                case "capture" -> capture();
                case "give" -> give(rest);
                case "use" -> throw new SessionFailure("use: expected in a solution's file");
                case "at", "submit" -> at(parts[0], rest);
                case "act" -> act(rest);
                default -> command(parts[0], rest, line);
            }
        } catch (IOException | IllegalArgumentException e) {
            throw new SessionFailure(line + ": " + e.getMessage());
        }
    }

    /** Performs {@code drive PROCESS WORLD} with a process in a file of the lesson's folder. */
    private void drive(List<String> words) throws SessionFailure, IOException, InterruptedException {
        if (words.size() != 2) {
            throw new SessionFailure("expected drive PROCESS WORLD");
        }
        tell(WallRun.run(tools, session.folder(), words.get(0), words.get(1)));
    }

    private void capture() throws SessionFailure, IOException {
        consoles.add(
                "tool",
                CapturedMessage.setup(session.folder().resolve(LessonNetwork.CAPTURE))
                        .orElseThrow(() -> new SessionFailure(words.of("lesson.capture.none"))));
    }

    /** Performs {@code give FILE}: copies a file of the student into the lesson's folder. */
    private void give(String file) throws SessionFailure, IOException {
        Path from = Path.of(file);
        if (!Files.isRegularFile(from)) {
            throw new SessionFailure("expected a file, found " + (file.isEmpty() ? "nothing" : file));
        }
        Path to = session.folder().resolve(from.getFileName());
        if (!from.toAbsolutePath().equals(to.toAbsolutePath())) {
            Files.copy(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Reports a tool's result to the student and to the conditions. */
    private void tell(Event event) {
        hasFailed |= !event.fields().getOrDefault("status", "0").equals("0");
        String line = ToolTexts.of(event, words);
        if (!line.isEmpty()) {
            told.add(line);
        }
        consoles.add("tool", event);
    }

    /** The output of tools since the last call, a line each. */
    String told() {
        List<String> lines = new ArrayList<>();
        for (String line = told.poll(); line != null; line = told.poll()) {
            lines.add(line);
        }
        return String.join("\n\n", lines);
    }

    private void change(Consumer<LessonRun> change) {
        synchronized (run) {
            change.accept(run);
        }
    }

    private void answer(String rest) {
        String[] parts = rest.split("\\s+", 2);
        change(each -> each.answer(parts[0], parts.length == 2 ? parts[1] : ""));
    }

    private LessonProgram program(String name) throws SessionFailure {
        return run.lesson()
                .program(name)
                .orElseThrow(() -> new SessionFailure("expected a program of the lesson, found " + name));
    }

    private void requireRunning(String name) throws SessionFailure {
        program(name);
        if (!consoles.isRunning(name)) {
            throw new SessionFailure(words.of("lesson.program.off", name));
        }
    }

    private void at(String verb, String rest) throws SessionFailure, IOException {
        String[] parts = rest.split("\\s+", 2);
        requireRunning(parts[0]);
        int port = consoles.ready(parts[0]).map(LessonSession::atPort).orElse(0);
        if (port == 0 || parts.length < 2) {
            throw new SessionFailure("expected a program with --at and a text, found " + rest);
        }
        try (AtLine line = new AtLine(port)) {
            Event answer = verb.equals("at") ? line.command(parts[1]) : line.submit(parts[1].replace(" ", ""));
            told.add(answer.fields().get("command") + ": " + answer.fields().get("answer"));
            consoles.add(parts[0], answer);
        }
    }

    /** The first AT port of a program; 0 for none. */
    static int atPort(Event ready) {
        return Integer.parseInt("0" + ready.fields().getOrDefault("at", "").split(",")[0]);
    }

    private void act(String rest) throws SessionFailure, InterruptedException {
        String[] parts = rest.split("\\s+", 2);
        LessonAction action = run.lesson()
                .action(parts[0])
                .orElseThrow(() -> new SessionFailure("expected an action of the lesson, found " + parts[0]));
        String given = parts.length == 2 ? parts[1].replace('\\', '/') : "";
        String input = action.input() instanceof LessonAction.Range range ? number(range, given) : given;
        String name = input.substring(input.lastIndexOf('/') + 1).replaceFirst("[.][a-z]+$", "");
        hasFailed = false;
        acted = action.name();
        for (String line : action.lines()) {
            if (hasFailed) {
                return; // the next lines would use the files of an earlier try
            }
            // the input is inserted last: a name in braces in it would be replaced by the solution's value
            perform(replaced(line, true).replace("{input}", input).replace("{name}", name));
        }
    }

    private String number(LessonAction.Range range, String given) throws SessionFailure {
        String text = range.isWhole() ? "lesson.integer" : "lesson.number";
        return range.number(given)
                .orElseThrow(() -> new SessionFailure(
                        words.of(text, String.valueOf(range.least()), String.valueOf(range.most()), given)));
    }

    private void command(String name, String command, String line) throws SessionFailure, InterruptedException {
        if (command.startsWith("wait ")) {
            consoles.perform(line);
        } else if (name.equals(Session.CENTRE)) {
            center(command);
        } else {
            requireRunning(name);
            consoles.perform(line);
        }
    }

    /** Performs {@code handover ALGORITHM[,NAME=N]...}, the centre's only command in lessons. */
    private void center(String command) throws SessionFailure {
        List<String> words = words(command);
        if (words.size() != 2 || !words.get(0).equals("handover")) {
            throw new SessionFailure("centre: expected handover ALGORITHM[,NAME=N]..., found " + command);
        }
        consoles.add(Session.CENTRE, session.center().setHandover(words.get(1)));
    }

    private static List<String> words(String text) throws SessionFailure {
        try {
            List<String> words = new ConsoleCommand("", text).words();
            if (words.isEmpty()) {
                throw new SessionFailure("expected more words in this line");
            }
            return words;
        } catch (CommandException e) {
            throw new SessionFailure(e.getMessage());
        }
    }

    /** Writes a file into the lesson's folder. */
    void handIn(String name, byte[] content) throws IOException {
        Files.write(session.folder().resolve(name), content);
    }
}
