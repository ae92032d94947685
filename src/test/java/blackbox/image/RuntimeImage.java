package blackbox.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A Java with the suite's modules and no others, and an archive of their classes. The archive is the image's default one, so
 * every start uses it without an option; it holds no paths, so the image can be moved.
 */
final class RuntimeImage {
    /** Modules that nothing requires by name: compiler of behaviours, random numbers on 17, Spanish numbers and dates. */
    private static final List<String> FURTHER_MODULES =
            List.of("jdk.compiler", "jdk.zipfs", "jdk.random", "jdk.localedata");

    private static final long TRAINING_SECONDS = 120;
    private static final long QUIET_MILLIS = 2_000;

    private final Path folder;

    RuntimeImage(Path folder) {
        this.folder = folder;
    }

    /** Links the programs' modules with those of the JDK that they require. */
    void link(Path dist, List<ImageProgram> programs) throws IOException, InterruptedException {
        List<String> modules = new ArrayList<>(ImageProgram.modules(programs));
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
     * loaded. A demo that fails ends the build.
     */
    void archiveClasses(Path work) throws IOException, InterruptedException {
        Path lists = Files.createDirectories(work.resolve("classes"));
        play(lists, "--headless");
        if (!Tool.IS_WINDOWS && System.getenv("DISPLAY") != null) {
            play(lists, "--end-with-input");
        }
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

    private void play(Path lists, String option) throws IOException, InterruptedException {
        ProcessBuilder demo = new ProcessBuilder(
                java(), "-m", "simgsm.center", "--demo", "--port", "0", "--no-sound", "--fresh", option);
        // The demo's children inherit it; each writes a list of its own.
        demo.environment().put("JDK_JAVA_OPTIONS", "-XX:DumpLoadedClassList=" + lists.resolve("%p.lst"));
        Path log = lists.resolveSibling("demo" + option + ".log");
        Process process =
                demo.redirectErrorStream(true).redirectOutput(log.toFile()).start();
        if (option.equals("--end-with-input")) {
            awaitQuiet(lists);
        }
        process.getOutputStream().close();
        if (!process.waitFor(TRAINING_SECONDS, TimeUnit.SECONDS)) {
            process.destroy();
            throw new IOException("the demo does not end; " + log + " has its output");
        }
        if (process.exitValue() != 0) {
            throw new IOException("the demo failed; its output was\n" + Files.readString(log));
        }
    }

    /** Waits until the windows have loaded all that they load, seen by lists that no longer grow. */
    private static void awaitQuiet(Path lists) throws IOException, InterruptedException {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(TRAINING_SECONDS);
        long before = -1;
        long size = 0;
        while ((size != before || size == 0) && System.nanoTime() < deadline) {
            before = size;
            TimeUnit.MILLISECONDS.sleep(QUIET_MILLIS);
            size = 0;
            for (Path list : files(lists)) {
                size += Files.size(list);
            }
        }
    }

    private static List<Path> files(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.toList();
        }
    }
}
