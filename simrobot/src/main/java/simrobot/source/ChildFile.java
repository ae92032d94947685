package simrobot.source;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import simrobot.behaviour.BehaviourRequest;
import simrobot.process.Decision;
import simrobot.source.child.ChildMain;
import simrobot.source.child.PipeLine;

/**
 * What a child needs to execute one version of a file.
 *
 * @param command the program and its arguments
 * @param lines what it reads first
 * @param source of the file; empty for a jar
 */
record ChildFile(String name, List<String> command, List<String> lines, SourceLines source, Hints hints) {
    static ChildFile ofSource(
            String name, Map<String, byte[]> classes, SourceLines source, ChildSettings settings) {
        List<String> lines = new ArrayList<>();
        classes.forEach((className, octets) -> lines.add(PipeLine.of(
                "class", "name", className, "octets", Base64.getUrlEncoder().encodeToString(octets))));
        return new ChildFile(name, java(settings, name + ".java"), lines, source, settings.hints());
    }

    static ChildFile ofJar(String name, Path jar, ChildSettings settings) {
        List<String> lines = List.of(PipeLine.of("jar", "path", jar.toString()));
        return new ChildFile(name, java(settings), lines, SourceLines.of(""), settings.hints());
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

    /** Returns a fault with a hint, and with the likely line if the child knows none. @param cause names the hint */
    Decision.Failed failed(int line, String cause, String text, List<BehaviourRequest> asked) {
        return new Decision.Failed(
                line > 0 ? line : source.likely(cause), hints.with(text, cause), List.copyOf(asked));
    }
}
