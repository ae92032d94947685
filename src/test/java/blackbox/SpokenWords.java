package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import simgsm.speech.WavWriter;
import simgsm.words.Prompts;
import simgsm.words.SpokenLanguage;
import simgsm.words.Utterance;

/** Words of the prompts' voice, as files, and a caller who enrolled with it. */
public final class SpokenWords {
    private static final List<String> WORDS = List.of(
            "forward", "turn", "right", "stop", "status", "yes", "no", "zero", "one", "two", "three", "four", "five",
            "six", "seven", "eight", "nine");

    private SpokenWords() {}

    /** One after the other with 0.7 s of silence, in one file, so that no word depends on the test's own time. */
    public static Path file(Path folder, String... words) throws IOException {
        Path file = folder.resolve(String.join("-", words) + ".wav");
        try (WavWriter wav = new WavWriter(file, 1)) {
            for (String word : words) {
                wav.write(new short[1600]);
                wav.write(Prompts.of(SpokenLanguage.ENGLISH).samples(new Utterance(List.of(word))));
                wav.write(new short[4000]);
            }
        }
        return file;
    }

    /** Enrols each word four times for {@link Scenario#PHONE} in the data of a robot. */
    public static void enrol(Path data, Path folder) throws IOException, InterruptedException {
        String voice = data.resolve("voices").resolve(Scenario.PHONE).toString();
        for (String word : WORDS) {
            String same = file(folder, word).toString();
            FinishedProgram tool =
                    FinishedProgram.run("simgsm-modem", "enrol", "--templates", voice, word, same, same, same, same);
            assertEquals(0, tool.status(), tool.error());
        }
    }
}
