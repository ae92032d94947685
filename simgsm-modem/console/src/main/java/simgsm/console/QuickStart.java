package simgsm.console;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Options of the Java machine with which a program starts in less CPU time: only the first compiler, on one thread,
 * the serial collector, and an archive of its classes. The archive is a file in the jars' folder, {@code
 * PROGRAM-KEY.jsa}; the first run with a window writes it when it ends. The key depends on the Java machine and the
 * jars, so an archive is never used after a change. An image made by Java 25 or newer has a cache of linked classes
 * for each window program, {@code lib/PROGRAM.aot}; an older one has an archive in the Java machine's default place.
 */
public final class QuickStart {
    /**
     * A system property: the folder in which programs started by an image record the classes they load, {@code
     * PROGRAM.conf} each. The build of an image makes the caches from these.
     */
    public static final String RECORD_FOLDER = "simgsm.record";

    private static final List<String> OPTIONS = List.of(
            "-XX:TieredStopAtLevel=1", "-XX:CICompilerCount=1", "-XX:+UseSerialGC", "-XX:-UsePerfData", "-Xmn16m");
    private static final String WRITE = "-XX:ArchiveClassesAtExit=";
    private static final String RECORD = "-XX:AOTMode=record";
    private static final String JAR = ".jar";
    private static final String ARCHIVE = ".jsa";
    private static final int KEY_DIGITS = 8;
    private static final String CACHE = ".aot";
    /** Silences reports on classes left out of an archive, which concern no user. */
    private static final String QUIET = "-Xlog:cds*=off";

    private static final String QUIET_CACHE = "-Xlog:aot*=off";

    private QuickStart() {}

    /** For a program that uses no archive. */
    public static List<String> options() {
        return OPTIONS;
    }

    /**
     * For a program that uses its archive.
     *
     * @param jar its name in the folder
     * @param mayWrite true if a program without an archive writes one when it ends
     */
    public static List<String> options(ProgramFolder programs, String jar, boolean mayWrite) {
        String program = jar.substring(0, jar.length() - JAR.length());
        List<String> options = new ArrayList<>(OPTIONS);
        if (programs.isImage()) {
            options.addAll(cache(programs.path(), program));
            return options;
        }
        try {
            options.addAll(archive(programs.path(), program, mayWrite));
        } catch (IOException e) {
            // The program starts without it.
        }
        return options;
    }

    /** True if a program with these options writes an archive at its end, which takes seconds. */
    public static boolean writesAtEnd(List<String> options) {
        return options.stream().anyMatch(option -> option.startsWith(WRITE) || option.equals(RECORD));
    }

    private static List<String> cache(Path image, String program) {
        String records = System.getProperty(RECORD_FOLDER);
        if (records != null) {
            return recording(Path.of(records), program);
        }
        Path cache = cacheOf(image, program);
        return Files.isReadable(cache) ? List.of("-XX:AOTCache=" + cache, QUIET_CACHE) : List.of();
    }

    /** The cache of a program. @param image the folder of the Java machine */
    public static Path cacheOf(Path image, String program) {
        return image.resolve("lib").resolve(program + CACHE);
    }

    /**
     * The options of a program of Java 25 or newer that records its loaded classes. Compilation profiles are not
     * recorded: with them each start compiles at once all that the recorded run has compiled, which costs more than
     * it gains.
     */
    public static List<String> recording(Path folder, String program) {
        return List.of(
                "-XX:+UnlockDiagnosticVMOptions",
                "-XX:-AOTRecordTraining",
                RECORD,
                "-XX:AOTConfiguration=" + recordOf(folder, program),
                QUIET_CACHE);
    }

    /** The record of a program. */
    public static Path recordOf(Path folder, String program) {
        return folder.resolve(program + ".conf");
    }

    private static List<String> archive(Path folder, String program, boolean mayWrite) throws IOException {
        Path archive = folder.resolve(program + "-" + key(folder) + ARCHIVE);
        if (isComplete(archive)) {
            return List.of("-XX:SharedArchiveFile=" + archive, QUIET);
        }
        if (!mayWrite || !Files.isWritable(folder)) {
            return List.of();
        }
        for (Path old : files(folder, ARCHIVE)) {
            String name = old.getFileName().toString();
            if (name.startsWith(program + "-")
                    && name.length() == archive.getFileName().toString().length()) {
                Files.deleteIfExists(old);
            }
        }
        return List.of(WRITE + archive, QUIET);
    }

    /** The Java machine writes the head last: the head of an unfinished archive is zero. */
    private static boolean isComplete(Path archive) throws IOException {
        if (!Files.isReadable(archive)) {
            return false;
        }
        try (InputStream in = Files.newInputStream(archive)) {
            return in.read() > 0;
        }
    }

    private static String key(Path folder) throws IOException {
        StringBuilder all = new StringBuilder();
        for (String property : List.of("java.home", "java.vm.name", "java.vm.version")) {
            all.append(System.getProperty(property)).append('\n');
        }
        for (Path file : files(folder, JAR)) {
            all.append(file)
                    .append(Files.size(file))
                    .append(Files.getLastModifiedTime(file).toMillis());
        }
        String key = Integer.toHexString(all.toString().hashCode());
        return "0".repeat(KEY_DIGITS - key.length()) + key;
    }

    /** Sorted. Found without streams, which are slow to start on a Java machine without an archive. */
    private static List<Path> files(Path folder, String ending) throws IOException {
        List<Path> files = new ArrayList<>();
        try (DirectoryStream<Path> all = Files.newDirectoryStream(folder)) {
            for (Path file : all) {
                if (file.getFileName().toString().endsWith(ending)) {
                    files.add(file);
                }
            }
        }
        files.sort(null);
        return files;
    }
}
