package simgsm.classroom.lesson;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import simgsm.air.Msisdn;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.NewSims;
import simgsm.classroom.demo.DemoPrograms;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.lesson.Lesson;

/** The folder of a lesson and its centre, closed or with a capture as the lesson asks. */
final class LessonNetwork {
    /** In the lesson's folder. */
    static final String CAPTURE = "lesson.pcap";

    static final String SIMS = "class.hlr";

    private LessonNetwork() {}

    static Path newFolder() throws IOException {
        return Files.createTempDirectory("simgsm-lesson");
    }

    /** @throws UsageException naming the lesson where an option of its centre is wrong */
    private static CenterSettings settings(Lesson lesson, Arguments own) throws IOException, UsageException {
        try {
            return CenterSettings.read(own);
        } catch (UsageException e) {
            boolean isLessons = lesson.center().keySet().stream()
                    .anyMatch(option -> e.getMessage().startsWith("--" + option + ":"));
            throw isLessons ? new UsageException(lesson.name() + ": centre " + e.getMessage()) : e;
        }
    }

    /** Opens the centre of a lesson; nothing is started. */
    static DemoPrograms open(Lesson lesson, Path folder, Arguments arguments) throws IOException, UsageException {
        // The seed is that of the student's numbers; with it all phones would be one equipment. The user's own network
        // and messages stay out of a lesson.
        Arguments own = arguments.without(
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
                "handover");
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
        DemoPrograms programs = DemoPrograms.open(own, settings(lesson, own));
        programs.removeAtEnd(folder);
        return programs;
    }
}
