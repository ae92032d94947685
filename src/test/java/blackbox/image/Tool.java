package blackbox.image;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Programs that the build of the image starts: those of the JDK, those of the image, tar and dpkg. */
final class Tool {
    static final boolean IS_WINDOWS = System.getProperty("os.name").startsWith("Windows");

    private Tool() {}

    /** Runs a command; its output is this process's. IOException names a command that fails. */
    static void run(Path folder, List<String> command) throws IOException, InterruptedException {
        int status = new ProcessBuilder(command)
                .directory(folder.toFile())
                .inheritIO()
                .start()
                .waitFor();
        if (status != 0) {
            throw new IOException(command + " ended with status " + status);
        }
    }

    /** The program's file, found by PATH. */
    static Optional<Path> find(String name) {
        return Stream.of(System.getenv("PATH").split(System.getProperty("path.separator")))
                .map(folder -> Path.of(folder, IS_WINDOWS ? name + ".exe" : name))
                .filter(Files::isExecutable)
                .findFirst();
    }

    /** A program of the JDK that runs this build. */
    static String ofJdk(String name) {
        return Path.of(System.getProperty("java.home"), "bin", IS_WINDOWS ? name + ".exe" : name)
                .toString();
    }
}
