package simrobot.source.child;

import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.BehaviourAnswer;
import simrobot.behaviour.BehaviourRequest;

/**
 * The main class of a child: reads questions from its standard input and writes a decision for each to its standard output.
 * It ends with that input, so no child outlives SimRobot.
 */
public final class ChildMain extends Decider {
    /** Characters that one decision may print; further ones are dropped. */
    private static final int MOST_PRINTED = 2000;

    private final BufferedReader questions;
    private final PrintStream answers;
    private final FaultPlace place;
    private final Map<String, byte[]> classes = new TreeMap<>();
    private final Map<String, String> classNames = new HashMap<>();
    private final Map<String, Behaviour> behaviours = new HashMap<>();
    private ClassLoader loader = new LoadedClasses(classes);
    private final AtomicInteger leftToPrint = new AtomicInteger(MOST_PRINTED);
    private volatile String robot = "0";

    private ChildMain(String file) {
        place = new FaultPlace(file);
        questions = new BufferedReader(
                new InputStreamReader(new FileInputStream(FileDescriptor.in), StandardCharsets.UTF_8), 1 << 16);
        answers = new PrintStream(new FileOutputStream(FileDescriptor.out), false, StandardCharsets.UTF_8);
    }

    /** @param arguments name of the source file; none for a jar */
    public static void main(String[] arguments) throws IOException {
        ChildMain child = new ChildMain(arguments.length == 0 ? null : arguments[0]);
        PrintStream prints = ProcessOutput.of(child::print);
        System.setOut(prints);
        System.setErr(prints);
        System.setIn(new InputStream() {
            @Override
            public int read() {
                throw new UnsupportedOperationException("System.in: a process has no keyboard");
            }
        });
        child.watch();
        try {
            child.answerAll();
        } finally {
            // not exit: threads and shutdown hooks of a student would go on
            halt(0);
        }
    }

    private void answerAll() throws IOException {
        for (String line = questions.readLine(); line != null; line = questions.readLine()) {
            PipeLine question = PipeLine.parse(line).orElseThrow();
            switch (question.word()) {
                case "class" ->
                    classes.put(question.text("name"), Base64.getUrlDecoder().decode(question.text("octets")));
                case "jar" ->
                    loader = new URLClassLoader(
                            LoadedClasses.NAME,
                            new URL[] {Path.of(question.text("path")).toUri().toURL()},
                            Behaviour.class.getClassLoader());
                case "begin" -> classNames.put(question.text("robot"), question.text("class"));
                case "end" -> behaviours.remove(question.text("robot"));
                default -> decide(question);
            }
            if (!questions.ready()) {
                answers.flush();
            }
        }
    }

    private void decide(PipeLine question) {
        robot = question.text("robot");
        leftToPrint.set(MOST_PRINTED);
        decide(place, this::behaviour, PipeSenses.parse(question));
    }

    private Behaviour behaviour() throws Exception {
        if (!behaviours.containsKey(robot)) {
            behaviours.put(robot, LoadedClasses.create(loader.loadClass(classNames.get(robot))));
        }
        return behaviours.get(robot);
    }

    @Override
    protected void decided(BehaviourAnswer made) {
        made.asked().forEach(request -> answer(RequestLine.of(robot, request)));
        answer("go robot=" + robot + " speed=" + made.steering().metersPerSecond() + " turn="
                + made.steering().radiansPerSecond() + " done=" + (made.isDone() ? 1 : 0));
    }

    @Override
    protected void failed(int line, String cause, String text) {
        behaviours.remove(robot);
        tell(line, cause, text);
        if (cause.equals(OutOfMemoryError.class.getSimpleName())) {
            answers.flush();
            halt(1);
        }
    }

    private synchronized void answer(String line) {
        answers.print(line + "\n");
    }

    /** Called on any thread of the file. */
    private void print(String lines) {
        int left = leftToPrint.addAndGet(-lines.length()) + lines.length();
        if (left > 0) {
            String shown = lines.substring(0, Math.min(left, lines.length()));
            answer(RequestLine.of(robot, new BehaviourRequest.Printed(shown)));
        }
    }

    private void tell(int line, String cause, String text) {
        answer(PipeLine.of("failed", "robot", robot, "line", line, "cause", cause, "text", text));
    }

    /**
     * Reports a fault of the robot that decides, or has decided last, and ends the child; no answer of a decision follows, which
     * SimRobot would take for the child's last word.
     */
    @Override
    protected synchronized void end(StackTraceElement[] trace, String cause, String text) {
        try {
            tell(line(trace), cause, text);
            answers.flush();
        } finally {
            halt(1);
        }
    }
}
