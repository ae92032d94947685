package simrobot.source;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import simrobot.behaviour.BehaviourRequest;
import simrobot.process.Decision;
import simrobot.source.child.ChildMain;
import simrobot.source.child.LoadedClasses;
import simrobot.source.child.PipeLine;

/**
 * What a child needs to execute one version of a file.
 *
 * @param command the program and its arguments
 * @param lines what it reads first
 * @param source of the file; empty for a jar
 * @param readsLaser whether it mentions the laser, which costs more than all other senses
 */
record ChildFile(
        String name, List<String> command, List<String> lines, SourceLines source, boolean readsLaser, Hints hints) {
    /** Python ends with SimRobot also in an endless loop: its parent is another one then. */
    private static final String PYTHON_START = """
            import os, runpy, sys, threading, time
            parent = os.getppid()
            def watch():
                while os.getppid() == parent:
                    time.sleep(1)
                os._exit(1)
            threading.Thread(target=watch, daemon=True).start()
            sys.path[0] = os.path.dirname(sys.argv[1])
            runpy.run_path(sys.argv[1], run_name="__main__")
            """;

    /** A line of Python's stack traces. */
    private static final Pattern PYTHON_LINE =
            Pattern.compile("\\s*File \"[^\"]*?([^\"/\\\\]+)\\.py\", line (\\d{1,9})\\b.*");

    static ChildFile ofSource(String name, Map<String, byte[]> classes, SourceLines source, ChildSettings settings) {
        List<String> lines = new ArrayList<>();
        classes.forEach((className, octets) -> lines.add(PipeLine.of(
                "class", "name", className, "octets", Base64.getUrlEncoder().encodeToString(octets))));
        boolean readsLaser = LoadedClasses.mention(classes, "laserMeters");
        return new ChildFile(name, java(settings, name + ".java"), lines, source, readsLaser, settings.hints());
    }

    static ChildFile ofJar(String name, Path jar, ChildSettings settings) {
        List<String> lines = List.of(PipeLine.of("jar", "path", jar.toString()));
        return new ChildFile(name, java(settings), lines, SourceLines.of(""), true, settings.hints());
    }

    /** A Python program of a student, executed by the Python of the machine. */
    static ChildFile ofPython(String name, Path file, String source, ChildSettings settings) {
        boolean isWindows = System.getProperty("os.name").startsWith("Windows");
        List<String> command = List.of(isWindows ? "python" : "python3", "-u", "-c", PYTHON_START, file.toString());
        boolean readsLaser = source.contains("laser");
        return new ChildFile(name, command, List.of(), SourceLines.of(source), readsLaser, settings.hints());
    }

    /** A small Java: it compiles fast rather than well, and collects its garbage on one thread. */
    private static List<String> java(ChildSettings settings, String... arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx" + settings.memoryMebibytes() + "m",
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-XX:-UsePerfData",
                "-Xshare:auto",
                "-cp",
                BehaviourCompiler.ownClasses(),
                ChildMain.class.getName()));
        command.addAll(List.of(arguments));
        return command;
    }

    /** Returns why a process has ended without a word of its own. @param last the lines that it has written last */
    Decision.Failed ended(int status, Collection<String> last, List<BehaviourRequest> asked) {
        int line = last.stream()
                .map(PYTHON_LINE::matcher)
                .filter(found -> found.matches() && found.group(1).equals(name))
                .mapToInt(found -> Integer.parseInt(found.group(2)))
                .reduce(0, (earlier, later) -> later);
        if (line == 0) {
            return failed(0, "halt", "it has ended its process, exit status " + status, asked);
        }
        String text = last.stream().reduce("", (earlier, later) -> later);
        return failed(line, text.replaceFirst(":.*", ""), text, asked);
    }

    /** Returns a fault with a hint, and with the likely line if the child knows none. @param cause names the hint */
    Decision.Failed failed(int line, String cause, String text, List<BehaviourRequest> asked) {
        return new Decision.Failed(line > 0 ? line : source.likely(cause), hints.with(text, cause), List.copyOf(asked));
    }
}
