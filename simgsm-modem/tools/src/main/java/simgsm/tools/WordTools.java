package simgsm.tools;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.console.Arguments;
import simgsm.console.ExitStatus;
import simgsm.console.UsageException;
import simgsm.file.FileErrors;
import simgsm.tools.audio.NotAudioException;
import simgsm.tools.audio.SpeechFile;
import simgsm.words.FrontEnd;
import simgsm.words.HeardWord;
import simgsm.words.SpeakerTemplates;
import simgsm.words.SpeechFrame;
import simgsm.words.SpokenWord;
import simgsm.words.TemplateFolder;
import simgsm.words.WordCutter;

/** {@code enrol WORD FILE...} and {@code hear FILE...}: templates of a speaker's words, and the words in sound files. */
final class WordTools {
    private static final int BLOCK_SAMPLES = 8000;

    private WordTools() {}

    /** Handles the word of a file. @return the line's end */
    private interface Use {
        String of(SpokenWord word) throws IOException;
    }

    static int enrol(Arguments arguments, PrintStream out, PrintStream err) throws Exception {
        List<String> rest = arguments.rest();
        if (rest.size() < 2) {
            throw new UsageException("missing " + (rest.isEmpty() ? "WORD" : "FILE.wav"));
        }
        String word = rest.get(0);
        if (!word.matches("[\\p{L}\\p{Nd}-]+")) {
            throw new UsageException("expected a word of letters, digits and hyphens, found " + word);
        }
        TemplateFolder folder = folder(arguments);
        SpeakerTemplates known = folder.read();
        return run(rest.subList(1, rest.size()), out, err, heard -> {
            int number = folder.add(word, known.count(word) + 1, heard);
            known.add(word, heard);
            return word + "\t" + number;
        });
    }

    static int hear(Arguments arguments, PrintStream out, PrintStream err) throws Exception {
        if (arguments.rest().isEmpty()) {
            throw new UsageException("missing FILE.wav");
        }
        double limit = arguments.number("limit", HeardWord.MOST_RATIO, 0, 1);
        SpeakerTemplates templates = folder(arguments).read();
        if (templates.words().isEmpty()) {
            throw new UsageException("--templates: expected templates made by enrol, found none");
        }
        return run(arguments.rest(), out, err, word -> {
            Optional<HeardWord> heard = templates.hear(word, templates.words());
            String name = heard.filter(found -> found.ratio() <= limit)
                    .map(HeardWord::word)
                    .orElse("-");
            double ratio = heard.map(HeardWord::ratio).orElse(1.0);
            return String.format(Locale.ROOT, "%s\t%.3f", name, ratio);
        });
    }

    private static TemplateFolder folder(Arguments arguments) throws UsageException {
        return new TemplateFolder(
                arguments.path("templates").orElseThrow(() -> new UsageException("missing --templates DIR")));
    }

    private static int run(List<String> names, PrintStream out, PrintStream err, Use use) throws IOException {
        int status = ExitStatus.OK;
        for (String name : names) {
            Path file = Path.of(name);
            try {
                Optional<SpokenWord> word = FileErrors.naming(file, () -> word(file));
                if (word.isPresent()) {
                    out.println(name + "\t" + use.of(word.get()));
                    continue;
                }
                err.println("simgsm-modem: " + name + ": expected a spoken word, found none");
                status = Math.max(status, ExitStatus.FAILED);
            } catch (NotAudioException e) {
                err.println("simgsm-modem: " + e.getMessage());
                status = Math.max(status, ExitStatus.FAILED);
            }
        }
        return status;
    }

    /** The loudest word of the file. */
    private static Optional<SpokenWord> word(Path path) throws IOException {
        List<SpeechFrame> frames = new ArrayList<>();
        FrontEnd frontEnd = new FrontEnd(frames::add);
        try (SpeechFile file = SpeechFile.open(path)) {
            short[] block = new short[BLOCK_SAMPLES];
            for (int n; (n = file.read(block)) >= 0; ) {
                frontEnd.accept(Arrays.copyOf(block, n));
            }
        }
        return WordCutter.cut(frames).map(SpokenWord::of);
    }
}
