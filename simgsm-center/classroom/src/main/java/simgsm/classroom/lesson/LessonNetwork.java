package simgsm.classroom.lesson;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import simgsm.air.Msisdn;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.NewSims;
import simgsm.classroom.session.Session;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.lesson.Lesson;

/** Creates the centre of a lesson, closed or with a capture as the lesson requires. */
final class LessonNetwork {
    /** The capture's file name in the folder of the session. */
    static final String CAPTURE = "lesson.pcap";

    private static final String SIMS = "class.hlr";

    /** Options of the command line that the centre ignores; the seed is that of the student's numbers. */
    private static final String[] REMOVED = {
        "seed",
        "data",
        "hlr",
        "barred-imeis",
        "smpp",
        "http",
        "cdr",
        "capture",
        "call-waiting",
        "tones",
        "t303",
        "handover"
    };

    private LessonNetwork() {}

    /** Opens the centre without starting programs. */
    static Session open(Lesson lesson, Arguments arguments) throws IOException, UsageException {
        Arguments own = arguments.without(REMOVED);
        return Session.open(own, folder -> settings(lesson, own, folder));
    }

    /** @throws UsageException naming the lesson if an option of its centre is wrong */
    private static CenterSettings settings(Lesson lesson, Arguments arguments, Path folder)
            throws IOException, UsageException {
        Arguments own = arguments;
        for (Map.Entry<String, String> option : lesson.center().entrySet()) {
            own = own.with(option.getKey(), option.getValue());
        }
        if (!lesson.closed().isEmpty()) {
            Set<Msisdn> numbers = new LinkedHashSet<>();
            lesson.closed().forEach(number -> numbers.add(new Msisdn(number)));
            PrintStream nowhere = new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
            NewSims.make(folder.resolve(SIMS), numbers, nowhere);
            own = own.with("hlr", folder.resolve(SIMS).toString());
        }
        if (lesson.isCaptured()) {
            own = own.with("capture", folder.resolve(CAPTURE).toString());
        }
        try {
            return CenterSettings.read(own);
        } catch (UsageException e) {
            boolean isLessons = lesson.center().keySet().stream()
                    .anyMatch(option -> e.getMessage().startsWith("--" + option + ":"));
            throw isLessons ? new UsageException(lesson.name() + ": centre " + e.getMessage()) : e;
        }
    }
}
