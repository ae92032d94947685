package blackbox;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Where the build left the programs, and how one starts them. */
public final class Dist {
    private Dist() {}

    public static Path root() {
        return Path.of(System.getProperty("simgsm.root"));
    }

    public static Path jar(String program) {
        return Path.of(System.getProperty("simgsm.dist"), program + ".jar");
    }

    /** The command that starts a program's jar on the Java that runs the tests, set for short runs. */
    public static List<String> command(String program, List<String> arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-Xshare:auto",
                "-jar",
                jar(program).toString()));
        command.addAll(arguments);
        return command;
    }

    /** As {@link #command}, with a folder of its own for temporary files, for a program that is killed or checked for leftovers. */
    static List<String> command(Path temporary, String program, List<String> arguments) {
        List<String> command = command(program, arguments);
        command.add(1, "-Djava.io.tmpdir=" + temporary);
        return command;
    }
}
