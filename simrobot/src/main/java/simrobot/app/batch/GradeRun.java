package simrobot.app.batch;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.LongStream;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.ProgramFolder;
import simgsm.console.UsageException;
import simrobot.app.RequestedBehaviours;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.world.World;

/**
 * {@code --grade DIR}: runs each process of a folder by {@code --run done}, in a program of its own, with the same world, goal
 * and seeds, and writes a page of results there. What a file does to its program is its own result.
 */
public final class GradeRun {
    private static final long DEFAULT_SEED = 1;
    /** The bound of one run, in seconds of real time. */
    private static final long MOST_SECONDS = 60;

    private static final long MAX_RUNS = 1000;

    /** Options that each run has, too. */
    private static final List<String> PASSED =
            List.of("world", "resolution", "robot", "robots", "power", "motors", "noise", "goal", "limit", "lang");

    private final Arguments arguments;
    private final World world;
    private final Path folder;
    private final long seed;
    private final int runs;

    private GradeRun(Arguments arguments, World world) throws UsageException {
        this.arguments = arguments;
        this.world = world;
        folder = arguments.path("grade").orElseThrow();
        seed = arguments.integer("seed", DEFAULT_SEED, Long.MIN_VALUE, Long.MAX_VALUE - MAX_RUNS);
        runs = (int) arguments.integer("runs", 1, 1, MAX_RUNS);
    }

    /** @return 0 when the page is written, whatever the results are */
    public static int run(Arguments arguments, World world) throws UsageException, IOException, InterruptedException {
        for (String option : List.of("run", "behaviour", "behaviours", "record", "track")) {
            if (arguments.has(option)) {
                throw new UsageException(
                        "--" + option + ": --grade runs each file of its folder, expected one of the two");
            }
        }
        Path folder = arguments.path("grade").orElseThrow();
        if (!Files.isDirectory(folder)) {
            throw new UsageException("--grade: expected a folder, found " + folder);
        }
        if (!Files.isWritable(folder)) {
            throw new UsageException("--grade: expected a folder that can be written, found " + folder);
        }
        Arguments asRun = arguments.with("run", "done").with("behaviours", folder.toString());
        BehaviourList list = new BehaviourList();
        RequestedBehaviours.of(asRun, list).close();
        BatchRun.check(asRun.with("behaviour", BehaviourKind.WANDER.text()), world);
        return new GradeRun(arguments, world).grade(list);
    }

    private int grade(BehaviourList list) throws UsageException, IOException, InterruptedException {
        List<Grade> grades = new ArrayList<>();
        for (BehaviourList.Fault fault : list.faults()) {
            String where = fault.line() == 0 ? "" : "line " + fault.line() + ": ";
            grades.add(told(new Grade(
                    fault.name(),
                    LongStream.range(seed, seed + runs)
                            .mapToObj(each -> Grade.failed(each, where + fault.text()))
                            .toList())));
        }
        for (BehaviourKind kind : list.kinds()) {
            if (!BehaviourKind.BUILT_IN.contains(kind)) {
                grades.add(told(new Grade(kind.text(), rows(kind.text()))));
            }
        }
        List<String> facts = List.of(
                world.name(), arguments.text("goal").orElse("-"), Long.toString(seed), Long.toString(seed + runs - 1));
        GradePage.write(folder, grades, arguments.language(), facts);
        Program.standardOutput().println(Event.of("end").with("of", "grade").with("count", grades.size()));
        return ExitStatus.OK;
    }

    private Grade told(Grade grade) {
        Program.standardOutput()
                .println(Event.of("graded")
                        .with("name", grade.name())
                        .with("done", grade.done())
                        .with("runs", runs)
                        .with("seconds", RunOutcome.threeDecimals(grade.meanSeconds()))
                        .with("text", grade.text()));
        return grade;
    }

    /** The rows of all seeds, each by a program of its own: a file that sleeps or halts costs one run. */
    private List<String> rows(String name) throws IOException, InterruptedException {
        List<String> rows = new ArrayList<>();
        Path output = Files.createTempFile("grade", ".csv");
        try {
            for (long next = seed; next < seed + runs; next++) {
                String end = run(name, next, output);
                String start = next + ",";
                rows.add(Files.readString(output)
                        .lines()
                        .filter(row -> Grade.isRow(row) && row.startsWith(start))
                        .findFirst()
                        .orElse(Grade.failed(next, end)));
            }
        } finally {
            Files.delete(output);
        }
        return rows;
    }

    /** @return how the program has ended */
    private String run(String name, long ofRun, Path output) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(ProgramFolder.of(GradeRun.class)
                .command(
                        "simrobot.jar",
                        List.of(
                                "-Xmx512m",
                                "-XX:+UseSerialGC",
                                "-XX:TieredStopAtLevel=1",
                                "-D" + BatchRun.ENDS_WITH_PARENT + "=true")));
        command.addAll(List.of("--run=done", "--runs=1", "--seed=" + ofRun));
        command.addAll(List.of("--behaviours=" + folder, "--behaviour=" + name));
        for (String option : PASSED) {
            arguments.all(option).forEach(value -> command.add("--" + option + "=" + value));
        }
        Process process = new ProcessBuilder(command)
                .redirectInput(Redirect.PIPE)
                .redirectOutput(output.toFile())
                .redirectError(Redirect.DISCARD)
                .start();
        boolean hasEnded = process.waitFor(MOST_SECONDS, TimeUnit.SECONDS);
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
        return hasEnded
                ? "it has ended its program, exit status " + process.exitValue()
                : "stopped after " + MOST_SECONDS + " s of real time";
    }
}
