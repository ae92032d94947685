package simgsm.console;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Options of the Java machine with which a program starts in less CPU time: only the first compiler, the serial collector,
 * and for a window program an archive of its classes. The archive lies beside the jars as {@code PROGRAM-KEY.jsa}; the first
 * run writes it when it ends. The key is made of the Java machine and the jars, so an archive is never used after either has
 * changed. An image has an archive of its own.
 */
public final class QuickStart {
    private static final List<String> OPTIONS = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");
    private static final String JAR = ".jar";
    private static final String ARCHIVE = ".jsa";
    /** The Java machine reports what it leaves out of an archive, which concerns no user. */
    private static final String QUIET = "-Xlog:cds*=off";

    private QuickStart() {}

    /** For a program without a window. */
    public static List<String> options() {
        return OPTIONS;
    }

    /**
     * For a program with a window.
     *
     * @param jar its name in the folder
     */
    public static List<String> options(ProgramFolder programs, String jar) {
        List<String> options = new ArrayList<>(OPTIONS);
        if (!programs.isImage()) {
            try {
                options.addAll(archive(programs.path(), jar));
            } catch (IOException e) {
                // It starts without.
            }
        }
        return options;
    }

    private static List<String> archive(Path folder, String jar) throws IOException {
        String program = jar.substring(0, jar.length() - JAR.length());
        Path archive = folder.resolve(program + "-" + key(folder) + ARCHIVE);
        if (isComplete(archive)) {
            return List.of("-XX:SharedArchiveFile=" + archive, QUIET);
        }
        if (!Files.isWritable(folder)) {
            return List.of();
        }
        for (Path old : files(folder, ".*" + ARCHIVE)) {
            if (old.getFileName().toString().matches(program + "-[0-9a-f]{8}" + ARCHIVE)) {
                Files.deleteIfExists(old);
            }
        }
        return List.of("-XX:ArchiveClassesAtExit=" + archive, QUIET);
    }

    /** The Java machine writes the head last: that of an archive whose writing was ended is zero. */
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
        for (Path file : files(folder, ".*" + JAR)) {
            all.append(file).append(Files.size(file)).append(Files.getLastModifiedTime(file));
        }
        return String.format("%08x", all.toString().hashCode());
    }

    private static List<Path> files(Path folder, String pattern) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(file -> file.getFileName().toString().matches(pattern))
                    .sorted()
                    .toList();
        }
    }
}
