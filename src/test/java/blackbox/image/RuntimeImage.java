package blackbox.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import simgsm.console.QuickStart;

/**
 * A Java with the suite's modules and no others, and archives of their classes. One is the image's default archive, which
 * every start uses without an option; a JDK 25 or newer adds a cache of linked classes for each program with a window. None
 * holds a path, so the image can be moved.
 */
final class RuntimeImage {
    /** Modules of the JDK that nothing requires by name: compiler of behaviours, random numbers on 17, Spanish numbers and dates. */
    private static final List<String> FURTHER_MODULES =
            List.of("jdk.compiler", "jdk.zipfs", "jdk.random", "jdk.localedata");

    /** Provides the centre's launcher. */
    private static final String CLASSROOM = "simgsm.classroom";

    /** Caches of linked classes; older JDKs have archives of classes only. */
    private static final boolean HAS_CACHES = Runtime.version().feature() >= 25;

    private static final String TOWERS = "simgsm.cells";
    private static final long TRAINING_SECONDS = 120;
    private static final long QUIET_MILLIS = 2_000;

    private final Path folder;

    RuntimeImage(Path folder) {
        this.folder = folder;
    }

    /** Links the programs' modules with those of the JDK that they require. */
    void link(Path dist, List<ImageProgram> programs) throws IOException, InterruptedException {
        List<String> modules = new ArrayList<>(ImageProgram.modules(programs));
        modules.add(CLASSROOM);
        FURTHER_MODULES.stream()
                .filter(name ->
                        ModuleLayer.boot().configuration().findModule(name).isPresent()
                                || java.lang.module.ModuleFinder.ofSystem()
                                        .find(name)
                                        .isPresent())
                .forEach(modules::add);
        Tool.run(
                dist,
                List.of(
                        Tool.ofJdk("jlink"),
                        "--module-path",
                        dist.toString(),
                        "--add-modules",
                        String.join(",", modules),
                        "--include-locales=en,es",
                        "--no-header-files",
                        "--no-man-pages",
                        "--strip-debug",
                        "--output",
                        folder.toString()));
    }

    String java() {
        return folder.resolve("bin")
                .resolve(Tool.IS_WINDOWS ? "java.exe" : "java")
                .toString();
    }

    /**
     * Plays the demo on the image, without windows and, where there is a display, with them, and archives the classes that it
     * loaded: in the image's default archive and, by a JDK 25 or newer, for each program with a window in a cache of its own. A
     * demo that fails ends the build.
     */
    void archiveClasses(Path work, List<ImageProgram> programs) throws IOException, InterruptedException {
        Path lists = Files.createDirectories(work.resolve("classes"));
        // The demo's children inherit the option; each writes a list of its own.
        String listing = "-XX:DumpLoadedClassList=" + lists.resolve("%p.lst");
        play(demo("--headless"), listing, work.resolve("headless.log"));
        try (VirtualDisplay display = VirtualDisplay.open().orElse(null)) {
            if (display == null) {
                System.out.println("image: neither a display nor Xvfb: windows will start slower");
            } else if (HAS_CACHES) {
                makeCaches(work, programs, display);
            } else {
                listWindows(work, programs, display, lists);
            }
        } catch (IOException e) {
            if (VirtualDisplay.IS_X11) {
                throw e;
            }
            // A session of Windows or macOS may have no screen.
            System.out.println("image: windows will start slower: " + e.getMessage());
        }
        makeDefaultArchive(work, lists);
    }

    /** Adds the classes that the windows load to the lists. */
    private void listWindows(Path work, List<ImageProgram> programs, VirtualDisplay display, Path lists)
            throws IOException, InterruptedException {
        listWindows(demo("--end-with-input"), work, "windows", display, lists);
        if (has(programs, TOWERS)) {
            listWindows(towers(), work, "towers", display, lists);
        }
    }

    private void listWindows(List<String> command, Path work, String name, VirtualDisplay display, Path lists)
            throws IOException, InterruptedException {
        Path more = Files.createDirectories(work.resolve(name));
        String listing = "-XX:DumpLoadedClassList=" + more.resolve("%p.lst");
        playInWindows(command, display, listing, more, work.resolve(name + ".log"));
        for (Path list : files(more)) {
            Files.move(list, lists.resolve(list.getFileName()));
        }
    }

    private void makeDefaultArchive(Path work, Path lists) throws IOException, InterruptedException {
        TreeSet<String> classes = new TreeSet<>();
        for (Path list : files(lists)) {
            Files.readAllLines(list).stream()
                    .filter(line -> line.matches("[^#@].*|@lambda-.*") && !line.contains(" source: "))
                    // Numbers that newer Java machines add hold for one list only.
                    .map(line -> line.replaceFirst(" id: .*", ""))
                    .forEach(classes::add);
        }
        Path all = Files.write(work.resolve("classes.lst"), classes);
        Tool.run(
                work,
                List.of(
                        java(),
                        "-Xshare:dump",
                        "-Xlog:disable",
                        "-Xlog:all=error:stderr",
                        "--add-modules",
                        "ALL-SYSTEM",
                        "-XX:SharedClassListFile=" + all));
    }

    /** Records what the demo's three programs and the towers load, and makes a cache of each record (JEP 483, 514). */
    private void makeCaches(Path work, List<ImageProgram> programs, VirtualDisplay display)
            throws IOException, InterruptedException {
        Path records = Files.createDirectories(work.resolve("records"));
        List<String> demo = recorded(records, "simgsm-center", demo("--end-with-input"));
        demo.add(1, "-D" + QuickStart.RECORD_FOLDER + "=" + records);
        playListed(demo, display, work, "windows");
        if (has(programs, TOWERS)) {
            playListed(recorded(records, TOWERS.replace('.', '-'), towers()), display, work, "towers");
        }
        for (ImageProgram program : programs) {
            Path record = QuickStart.recordOf(records, program.cacheName());
            Path cache = QuickStart.cacheOf(folder, program.cacheName());
            if (Files.exists(record) && !Files.exists(cache)) {
                List<String> command = new ArrayList<>(List.of(java()));
                command.addAll(QuickStart.options());
                command.addAll(List.of(
                        "-Xlog:aot*=off",
                        "-XX:AOTMode=create",
                        "-XX:AOTConfiguration=" + record,
                        "-XX:AOTCache=" + cache,
                        "-m",
                        program.module()));
                Tool.run(work, command);
            }
        }
    }

    private void playListed(List<String> command, VirtualDisplay display, Path work, String name)
            throws IOException, InterruptedException {
        Path lists = Files.createDirectories(work.resolve(name));
        String listing = "-Xlog:class+load:file=" + lists.resolve("%p.lst");
        playInWindows(command, display, listing, lists, work.resolve(name + ".log"));
    }

    /** A command that also records what it loads. */
    private static List<String> recorded(Path records, String program, List<String> command) {
        List<String> recording = new ArrayList<>(command);
        recording.addAll(1, QuickStart.recording(records, program));
        recording.addAll(1, QuickStart.options());
        return recording;
    }

    private static boolean has(List<ImageProgram> programs, String module) {
        return programs.stream().anyMatch(program -> program.module().equals(module));
    }

    /** The towers' window, without a centre. */
    private List<String> towers() {
        return List.of(
                java(),
                "-m",
                TOWERS,
                "--town",
                "village.town",
                "--center",
                "127.0.0.1:9",
                "--port",
                "0",
                "--fresh",
                "--end-with-input");
    }

    private List<String> demo(String option) {
        return List.of(java(), "-m", "simgsm.center", "--demo", "--port", "0", "--no-sound", "--fresh", option);
    }

    private void play(List<String> command, String javaOption, Path log) throws IOException, InterruptedException {
        Process process = start(command, javaOption, log, Map.of());
        process.getOutputStream().close();
        end(process, log);
    }

    /** Opens the windows, and closes them when they have loaded all that they load, seen by lists that no longer grow. */
    private void playInWindows(List<String> command, VirtualDisplay display, String javaOption, Path lists, Path log)
            throws IOException, InterruptedException {
        Map<String, String> environment = new HashMap<>();
        display.in(environment);
        Process process = start(command, javaOption, log, environment);
        awaitQuiet(lists);
        process.getOutputStream().close();
        end(process, log);
    }

    private static Process start(List<String> command, String javaOption, Path log, Map<String, String> environment)
            throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command);
        builder.environment().put("JDK_JAVA_OPTIONS", javaOption);
        builder.environment().putAll(environment);
        return builder.redirectErrorStream(true).redirectOutput(log.toFile()).start();
    }

    private static void end(Process process, Path log) throws IOException, InterruptedException {
        if (!process.waitFor(TRAINING_SECONDS, TimeUnit.SECONDS)) {
            process.destroy();
            throw new IOException("the demo does not end; " + log + " has its output");
        }
        if (process.exitValue() != 0) {
            throw new IOException("the demo failed; its output was\n" + Files.readString(log));
        }
    }

    private static void awaitQuiet(Path lists) throws IOException, InterruptedException {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(TRAINING_SECONDS);
        long before = -1;
        long size = size(lists);
        while ((size != before || size == 0) && System.nanoTime() < deadline) {
            before = size;
            TimeUnit.MILLISECONDS.sleep(QUIET_MILLIS);
            size = size(lists);
        }
    }

    private static long size(Path lists) throws IOException {
        long size = 0;
        for (Path list : files(lists)) {
            size += Files.size(list);
        }
        return size;
    }

    private static List<Path> files(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.toList();
        }
    }
}
