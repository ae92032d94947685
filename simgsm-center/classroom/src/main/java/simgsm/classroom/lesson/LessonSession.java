package simgsm.classroom.lesson;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import simgsm.center.app.CenterTexts;
import simgsm.center.app.ChildConsole;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.classroom.demo.DemoPrograms;
import simgsm.console.CommandException;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;
import simgsm.console.TextBundle;
import simgsm.lesson.LessonAction;
import simgsm.lesson.LessonProgram;
import simgsm.lesson.LessonRun;

/**
 * The programs of a lesson and what happens in them. Lines of solutions and of the lesson's actions are performed here; any
 * thread may, one at a time.
 */
final class LessonSession implements AutoCloseable {
    /** Starting Java programs on a slow machine. */
    private static final double START_SECONDS = 60;

    private static final double WAIT_SECONDS = 20;
    private static final double MOST_WAIT_SECONDS = 600;
    private static final int END_SECONDS = 10;

    private static final String CENTRE = "centre";
    private final LessonRun run;
    private final DemoPrograms programs;
    private final LessonEvents events;
    private final LessonTools tools;
    private final Path folder;
    private final Function<LessonProgram, List<String>> manner;
    private final TextBundle words;
    private final Map<String, ChildConsole> consoles = new ConcurrentHashMap<>();
    private final Queue<String> told = new ConcurrentLinkedQueue<>();
    private final Map<String, Integer> atPorts = new ConcurrentHashMap<>();
    /** Whether a tool has failed since the action began. */
    private boolean hasFailed;
    /** The latest action; empty before the first one. */
    private volatile String acted = "";

    private volatile LessonConsole.Troubles troubles = LessonConsole.NONE;

    /**
     * @param folder in which tools run and files are handed in
     * @param own where a teacher's own lesson lies
     * @param manner the further options of a program, such as {@code --headless}
     * @param language of the student's texts
     */
    LessonSession(
            LessonRun run,
            DemoPrograms programs,
            Path folder,
            Optional<Path> own,
            Function<LessonProgram, List<String>> manner,
            Locale language) {
        this.run = run;
        this.programs = programs;
        this.folder = folder;
        this.manner = manner;
        words = CenterTexts.in(language);
        events = new LessonEvents(run);
        tools = new LessonTools(programs.children(), folder);
        events.withRun(each -> each.put("folder", folder.toString()));
        own.ifPresent(place ->
                events.withRun(each -> each.put("lesson", place.toAbsolutePath().toString())));
    }

    LessonEvents events() {
        return events;
    }

    void onTrouble(LessonConsole.Troubles listener) {
        troubles = listener;
    }

    /** Whether the latest action has failed. */
    boolean hasFailed() {
        return hasFailed;
    }

    /** A line with the values of its names in braces; {@code isAll}: also of those that students have to find. */
    String replaced(String line, boolean isAll) {
        String[] text = new String[1];
        events.withRun(each -> text[0] = isAll ? each.solved(line) : each.shown(line));
        return text[0];
    }

    /** Takes the centre's events. */
    Consumer<ExchangeEvent> centerEvents() {
        return event -> events.add(CENTRE, Event.from(event));
    }

    /** Takes the centre's ladder. */
    Consumer<ExchangeSnapshot> trace() {
        return new TraceEvents(event -> events.add("trace", event));
    }

    /** Starts the programs of the lesson, all at once, and waits until they are registered. */
    void start() throws IOException, LessonFailure, InterruptedException {
        List<LessonProgram> first = run.lesson().programs().stream()
                .filter(program -> !program.isLater())
                .toList();
        List<String> started = new ArrayList<>();
        for (LessonProgram program : first) {
            boolean needsPort = program.options().stream()
                    .anyMatch(option -> replaced(option, true).contains("{"));
            if (needsPort) {
                for (String earlier : started) {
                    events.await(earlier, Event.of("ready"), START_SECONDS);
                }
            }
            launch(program);
            started.add(program.name());
        }
        for (LessonProgram program : first) {
            if (isTerminal(program)) {
                events.await(program.name(), Event.of("registered"), START_SECONDS);
            }
        }
    }

    /** Whether it registers with a number. */
    private static boolean isTerminal(LessonProgram program) {
        return program.options().contains("--number");
    }

    private void startAgain(LessonProgram program) throws IOException, LessonFailure {
        if (running().contains(program.name())) {
            throw new LessonFailure(words.of("lesson.program.runs", program.name()));
        }
        launch(program);
    }

    private void launch(LessonProgram program) throws IOException {
        List<String> options = new ArrayList<>();
        program.options().forEach(option -> options.add(replaced(option, true)));
        options.addAll(manner.apply(program));
        int number = options.indexOf("--number");
        String name = program.name();
        events.skip(name);
        events.begun(name);
        Process process = programs.start(
                program.jar() + ".jar", number < 0 ? "" : options.get(number + 1), Redirect.PIPE, options);
        LessonConsole listener = new LessonConsole(name, process, events) {
            @Override
            String action() {
                return acted;
            }

            @Override
            Troubles troubles() {
                return troubles;
            }

            @Override
            void atPort(int port) {
                atPorts.put(name, port);
            }
        };
        consoles.put(name, new ChildConsole(name, process, listener));
    }

    /**
     * Performs one line: {@code answer NAME TEXT}, {@code start} or {@code stop PROGRAM}, {@code tool WORDS}, {@code java
     * FILE WORDS}, {@code at} or {@code submit PROGRAM TEXT}, {@code act NAME INPUT}, {@code SOURCE wait EVENT
     * [FIELD=VALUE]... [SECONDS]}, or a command of a program's console, {@code PROGRAM COMMAND}.
     */
    void perform(String line) throws LessonFailure, InterruptedException {
        String[] parts = line.strip().split("\\s+", 2);
        String rest = parts.length == 2 ? parts[1] : "";
        try {
            switch (parts[0]) {
                case "predict" -> events.withRun(each -> each.predict(rest));
                case "answer" -> answer(rest);
                case "start" -> startAgain(program(rest));
                case "stop" -> stop(rest);
                case "tool" -> tell(tools.tool(words(rest)));
                case "java" -> tell(tools.source(words(rest)));
                case "drive" -> drive(words(rest));
                case "capture" -> capture();
                case "give" -> give(rest);
                case "use" -> throw new LessonFailure("use: expected in a solution's file");
                case "at", "submit" -> at(parts[0], rest);
                case "act" -> act(rest);
                default -> command(parts[0], rest);
            }
        } catch (IOException | IllegalArgumentException e) {
            throw new LessonFailure(line + ": " + e.getMessage());
        }
    }

    /** {@code drive PROCESS WORLD}; the process is in a file of the lesson's folder. */
    private void drive(List<String> words) throws LessonFailure, IOException, InterruptedException {
        if (words.size() != 2) {
            throw new LessonFailure("expected drive PROCESS WORLD");
        }
        Event event = WallRun.run(tools, folder, words.get(0), words.get(1));
        tell(event);
    }

    private void capture() throws LessonFailure, IOException {
        events.add(
                "tool",
                CapturedMessage.setup(folder.resolve(LessonNetwork.CAPTURE))
                        .orElseThrow(() -> new LessonFailure(words.of("lesson.capture.none"))));
    }

    /** {@code give FILE}: copies a file that the student has chosen into the lesson's folder. */
    private void give(String file) throws LessonFailure, IOException {
        Path from = Path.of(file);
        if (!Files.isRegularFile(from)) {
            throw new LessonFailure("expected a file, found " + (file.isEmpty() ? "nothing" : file));
        }
        Path to = folder.resolve(from.getFileName());
        if (!from.toAbsolutePath().equals(to.toAbsolutePath())) {
            Files.copy(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** What a tool has found, for the student and for the conditions. */
    private void tell(Event event) {
        hasFailed |= !event.fields().getOrDefault("status", "0").equals("0");
        String line = ToolTexts.of(event, words);
        if (!line.isEmpty()) {
            told.add(line);
        }
        events.add("tool", event);
    }

    /** What tools have printed since the last call, a line each. */
    String told() {
        List<String> lines = new ArrayList<>();
        for (String line = told.poll(); line != null; line = told.poll()) {
            lines.add(line);
        }
        return String.join("\n\n", lines);
    }

    private void answer(String rest) {
        String[] parts = rest.split("\\s+", 2);
        events.withRun(each -> each.answer(parts[0], parts.length == 2 ? parts[1] : ""));
    }

    private LessonProgram program(String name) throws LessonFailure {
        return run.lesson()
                .program(name)
                .orElseThrow(() -> new LessonFailure("expected a program of the lesson, found " + name));
    }

    private void stop(String name) throws LessonFailure, IOException, InterruptedException {
        ChildConsole console = console(name);
        console.process().getOutputStream().close();
        if (!console.process().waitFor(END_SECONDS, TimeUnit.SECONDS)) {
            throw new LessonFailure(name + ": expected to end within " + END_SECONDS + " s");
        }
    }

    /** The programs that run. */
    Set<String> running() {
        return consoles.entrySet().stream()
                .filter(each -> each.getValue().process().isAlive())
                .map(Map.Entry::getKey)
                .collect(Collectors.toSet());
    }

    private ChildConsole console(String name) throws LessonFailure {
        program(name);
        ChildConsole console = consoles.get(name);
        if (console == null || !console.process().isAlive()) {
            throw new LessonFailure(words.of("lesson.program.off", name));
        }
        return console;
    }

    private void at(String verb, String rest) throws LessonFailure, IOException {
        String[] parts = rest.split("\\s+", 2);
        console(parts[0]);
        Integer port = atPorts.get(parts[0]);
        if (port == null || parts.length < 2) {
            throw new LessonFailure("expected a program with --at and a text, found " + rest);
        }
        try (AtLine line = new AtLine(port)) {
            Event answer = verb.equals("at") ? line.command(parts[1]) : line.submit(parts[1].replace(" ", ""));
            told.add(answer.fields().get("command") + ": " + answer.fields().get("answer"));
            events.add(parts[0], answer);
        }
    }

    private void act(String rest) throws LessonFailure, InterruptedException {
        String[] parts = rest.split("\\s+", 2);
        LessonAction action = run.lesson()
                .action(parts[0])
                .orElseThrow(() -> new LessonFailure("expected an action of the lesson, found " + parts[0]));
        String given = parts.length == 2 ? parts[1].replace('\\', '/') : "";
        String input = action.input() instanceof LessonAction.Range range ? number(range, given) : given;
        String name = input.substring(input.lastIndexOf('/') + 1).replaceFirst("[.][a-z]+$", "");
        hasFailed = false;
        acted = action.name();
        for (String line : action.lines()) {
            if (hasFailed) {
                return; // what follows would work on the files of an earlier try
            }
            // The input comes last: a name in braces in it would be replaced by what the student has to find.
            perform(replaced(line, true).replace("{input}", input).replace("{name}", name));
        }
    }

    private String number(LessonAction.Range range, String given) throws LessonFailure {
        String text = range.isWhole() ? "lesson.integer" : "lesson.number";
        return range.number(given)
                .orElseThrow(() -> new LessonFailure(
                        words.of(text, String.valueOf(range.least()), String.valueOf(range.most()), given)));
    }

    private void command(String name, String command) throws LessonFailure, IOException, InterruptedException {
        if (command.startsWith("wait ")) {
            await(name, command);
        } else if (name.equals(CENTRE)) {
            center(command);
        } else {
            console(name).command(command);
        }
    }

    /** {@code handover ALGORITHM[,NAME=N]...} is the one command of the centre that lessons have. */
    private void center(String command) throws LessonFailure {
        List<String> words = words(command);
        if (words.size() != 2 || !words.get(0).equals("handover")) {
            throw new LessonFailure("centre: expected handover ALGORITHM[,NAME=N]..., found " + command);
        }
        events.add(CENTRE, programs.center().setHandover(words.get(1)));
    }

    private void await(String source, String command) throws LessonFailure, InterruptedException {
        List<String> words = new ArrayList<>(words(command));
        words.remove(0);
        double seconds = WAIT_SECONDS;
        String last = words.isEmpty() ? "" : words.get(words.size() - 1);
        if (last.matches("[0-9]+(\\.[0-9]+)?")) {
            seconds = Double.parseDouble(last);
            if (seconds > MOST_WAIT_SECONDS) {
                throw new LessonFailure("wait: expected at most " + (int) MOST_WAIT_SECONDS + " s, found " + last);
            }
            words.remove(words.size() - 1);
        }
        if (words.isEmpty()) {
            throw new LessonFailure("wait: expected EVENT [FIELD=VALUE]... [SECONDS]");
        }
        Event wanted = Event.of(words.get(0));
        for (String word : words.subList(1, words.size())) {
            int equals = word.indexOf('=');
            if (equals <= 0) {
                throw new LessonFailure("wait: expected FIELD=VALUE, found " + word);
            }
            wanted = wanted.with(word.substring(0, equals), word.substring(equals + 1));
        }
        events.await(source, wanted, seconds);
    }

    private static List<String> words(String text) throws LessonFailure {
        try {
            List<String> words = new ConsoleCommand("", text).words();
            if (words.isEmpty()) {
                throw new LessonFailure("expected more words in this line");
            }
            return words;
        } catch (CommandException e) {
            throw new LessonFailure(e.getMessage());
        }
    }

    /** Puts a file into the lesson's folder. */
    void handIn(String name, byte[] content) throws IOException {
        Files.write(folder.resolve(name), content);
    }

    @Override
    public void close() {
        programs.close();
    }
}
