package simgsm.center.journal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Known faults, put into the source one at a time: the simulation must break within {@link #MOST_SEEDS} seeds.
 */
class MutantsTest {
    private static final int MOST_SEEDS = 400;

    private static final Path SOURCES = Path.of("src", "main", "java", "simgsm", "center");

    /**
     * A fault.
     *
     * @param seed broke when last looked for: tried first, and all the others only if it no longer breaks
     * @param file below the centre's sources
     * @param right stands there once
     * @param wrong replaces it
     */
    record Mutant(String fault, int seed, String file, String right, String wrong) {
        @Override
        public String toString() {
            return fault;
        }
    }

    static List<Mutant> mutants() {
        return List.of(
                new Mutant(
                        "compaction deletes before the rename",
                        79,
                        "journal/Compaction.java",
                        "        disk.rename(FileNames.unfinished(), FileNames.snapshot(number));\n"
                                + "        disk.sync();\n"
                                + "        removeSuperseded();",
                        "        removeSuperseded();\n"
                                + "        disk.rename(FileNames.unfinished(), FileNames.snapshot(number));\n"
                                + "        disk.sync();"),
                new Mutant(
                        "compaction deletes before the new name is durable",
                        1,
                        "journal/Compaction.java",
                        "        disk.sync();\n        removeSuperseded();",
                        "        removeSuperseded();"),
                new Mutant(
                        "T308 never ends",
                        25,
                        "msc/call/CallLeg.java",
                        "boolean isAgain = timer == NetworkTimer.T308 && isReleaseRepeated;",
                        "boolean isAgain = false;"),
                new Mutant(
                        "available() does not cancel the pause",
                        2,
                        "smsc/ReceiverQueue.java",
                        "        availabilities++;\n        endPause();",
                        "        availabilities++;"),
                new Mutant(
                        "a message is acknowledged before it is stored",
                        1,
                        "smsc/ShortMessageCenter.java",
                        "isDurable -> stored(accepted, isDurable, answer));",
                        "isDurable -> stored(accepted, isDurable, any -> {})); answer.accept(Optional.empty());"),
                new Mutant(
                        "a group is not synchronised",
                        1,
                        "journal/JournalSegment.java",
                        "        if (isSynchronised) {\n            file.sync();\n        }",
                        ""),
                new Mutant(
                        "a new segment's name is not synchronised",
                        1,
                        "journal/Journal.java",
                        "            disk.sync();",
                        "            if (lastNumber < 0) { disk.sync(); }"),
                new Mutant(
                        "what an earlier process left in the cache counts as durable",
                        15,
                        "journal/Recovery.java",
                        "            file.sync();\n            return contents;",
                        "            return contents;"),
                new Mutant(
                        "the end of a message is not stored",
                        2,
                        "smsc/ShortMessageCenter.java",
                        "store(new StoreEntry.Ended(message.id(), state, now(), false));",
                        ""),
                new Mutant(
                        "what a failing disk did not take is forgotten",
                        1,
                        "journal/Journal.java",
                        "owed.add(entry);",
                        ""),
                new Mutant("ids begin anew", 1, "smsc/ShortMessageCenter.java", "nextId = stored.lastId() + 1;", ""),
                new Mutant(
                        "repetitions are not recognised",
                        2,
                        "smsc/ShortMessageCenter.java",
                        "Optional<Long> original = isRepeated || unit.rejectDuplicates()",
                        "Optional<Long> original = false"),
                new Mutant(
                        "a report is sent before its message's end is stored",
                        97,
                        "smsc/ShortMessageCenter.java",
                        "            storeEnd(reportOf(message, state, now()));",
                        "            report(reportOf(message, state, now()));\n"
                                + "            storeEnd(reportOf(message, state, now()));"));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("mutants")
    void theSimulationCatches(Mutant mutant, @TempDir Path directory) throws Exception {
        String source = Files.readString(SOURCES.resolve(mutant.file));
        assertEquals(2, source.split(Pattern.quote(mutant.right), -1).length, "the right text stands there once");
        Path file = directory.resolve(Path.of(mutant.file).getFileName());
        Files.writeString(file, source.replace(mutant.right, mutant.wrong));
        Path classes = Files.createDirectory(directory.resolve("classes"));
        StringWriter compiled = new StringWriter();
        PrintWriter printed = new PrintWriter(compiled);
        int status = ToolProvider.findFirst("javac")
                .orElseThrow()
                .run(printed, printed, "-nowarn", "-d", classes.toString(), "-cp", classPath(), file.toString());
        assertEquals(0, status, compiled::toString);
        assertTrue(isBroken(classes + File.pathSeparator + classPath(), mutant.seed, MOST_SEEDS), "no seed broke");
    }

    @Test
    void theSimulationOfTheRightSourceBreaksInNoSeed() throws Exception {
        assertFalse(isBroken(classPath(), 2, 1));
    }

    /** Runs a seed, then those from 1 on, in classes of their own, until one breaks. @return whether one did */
    private static boolean isBroken(String classPath, int first, int seeds) throws Exception {
        List<URL> places = new ArrayList<>();
        for (String place : classPath.split(File.pathSeparator)) {
            places.add(Path.of(place).toUri().toURL());
        }
        // the platform's loader would find the right classes: it asks the modules of the boot layer
        try (URLClassLoader classes = new URLClassLoader(places.toArray(URL[]::new), null)) {
            Class<?> simulation = classes.loadClass(Simulation.class.getName());
            Constructor<?> constructor = simulation.getDeclaredConstructor(long.class);
            Method run = simulation.getDeclaredMethod("run");
            constructor.setAccessible(true);
            run.setAccessible(true);
            for (int next = 0; next <= seeds; next++) {
                int seed = next == 0 ? first : next;
                try {
                    run.invoke(constructor.newInstance((long) seed));
                } catch (InvocationTargetException broken) {
                    return true;
                }
            }
            return false;
        }
    }

    /** Test classes, classes and the modules that they use. */
    private static String classPath() {
        return Stream.of(
                        Path.of("target", "test-classes").toString(),
                        Path.of("target", "classes").toString(),
                        System.getProperty("jdk.module.path", ""),
                        System.getProperty("java.class.path", ""))
                .filter(path -> !path.isEmpty())
                .collect(Collectors.joining(File.pathSeparator));
    }
}
