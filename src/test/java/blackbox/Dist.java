package blackbox;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import simgsm.console.ProgramFolder;
import simgsm.console.QuickStart;

/** Where the build left the programs, and how one starts them. */
public final class Dist {
    /** A run of fewer programs ends sooner without archives. */
    private static final int STARTS_BEFORE_ARCHIVES = 10;

    private static final String WRITES_ARCHIVE = "-XX:ArchiveClassesAtExit=";

    private static int starts;
    private static boolean isWriting;

    private Dist() {}

    public static Path root() {
        return Path.of(System.getProperty("simgsm.root"));
    }

    public static Path jar(String program) {
        return programs().path().resolve(program + ".jar");
    }

    private static ProgramFolder programs() {
        return new ProgramFolder(Path.of(System.getProperty("simgsm.dist")), false);
    }

    /** The command that starts a program's jar on the Java that runs the tests, set for short runs. */
    public static List<String> command(String program, List<String> arguments) {
        try {
            List<String> command = programs().command(program + ".jar", options(program));
            command.addAll(arguments);
            return command;
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static synchronized List<String> options(String program) throws IOException {
        starts++;
        if (starts == STARTS_BEFORE_ARCHIVES) {
            writeArchives();
        }
        List<String> options = QuickStart.options(programs(), program + ".jar", isWriting);
        options.stream()
                .filter(option -> option.startsWith(WRITES_ARCHIVE))
                .forEach(option -> new File(option.substring(WRITES_ARCHIVE.length())).deleteOnExit());
        return options;
    }

    /** Plays a session whose programs archive the classes that they have loaded, by which all later ones start sooner. */
    private static void writeArchives() throws IOException {
        isWriting = true;
        try (Scenario scenario = new Scenario("a session for the archives of classes")) {
            RunningProgram center = scenario.center();
            RunningProgram cells = scenario.cells("village.town");
            RunningProgram robot = scenario.robot("empty.map", "--speed", "10");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press **#**20**");
            phone.expect("tone", "key", "3");
            phone.say("hangup");
            phone.expect("released");
            phone.say("sms " + Scenario.ROBOT + " ** #*#90 **");
            phone.expect("sms", "from", Scenario.ROBOT);
            for (RunningProgram each : List.of(phone, robot, cells, center)) {
                each.quit();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError(e);
        } finally {
            isWriting = false;
        }
    }

    /** As {@link #command}, with a folder of its own for temporary files, for a program that is killed or checked for leftovers. */
    static List<String> command(Path temporary, String program, List<String> arguments) {
        List<String> command = new ArrayList<>(command(program, arguments));
        command.add(1, "-Djava.io.tmpdir=" + temporary);
        return command;
    }
}
