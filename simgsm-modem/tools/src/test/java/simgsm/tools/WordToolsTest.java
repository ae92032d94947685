package simgsm.tools;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.speech.WavWriter;
import simgsm.words.Prompts;
import simgsm.words.SpokenLanguage;
import simgsm.words.Utterance;

class WordToolsTest {
    @TempDir
    private Path folder;

    private String errors = "";
    private int status;

    private Path word(String name) throws IOException {
        Path file = folder.resolve(name.replace(' ', '-') + ".wav");
        try (WavWriter wav = new WavWriter(file, 1)) {
            wav.write(new short[1600]);
            wav.write(Prompts.of(SpokenLanguage.ENGLISH).samples(new Utterance(List.of(name))));
            wav.write(new short[1600]);
        }
        return file;
    }

    private String run(String... words) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        status = ToolsMain.run(List.of(words), new PrintStream(out), new PrintStream(err));
        errors = err.toString(StandardCharsets.UTF_8);
        return out.toString(StandardCharsets.UTF_8);
    }

    @Test
    void anEnrolledWordIsHeardAndAStrangeOneIsRefused() throws IOException {
        String templates = folder.resolve("anna").toString();
        for (String word : List.of("yes", "no", "forward", "seven")) {
            assertEquals(
                    word(word) + "\t" + word + "\t1\n", run("enrol", "--templates", templates, word, "" + word(word)));
        }
        assertEquals(word("yes") + "\tyes\t2\n", run("enrol", "--templates", templates, "yes", "" + word("yes")));
        assertEquals(word("seven") + "\tseven\t0.000\n", run("hear", "--templates", templates, "" + word("seven")));
        String meters = word("meters").toString();
        assertEquals(meters + "\t-\t0.955\n", run("hear", "--templates", templates, meters));
        assertEquals(meters + "\tyes\t0.955\n", run("hear", "--limit", "1", "--templates", templates, meters));
        assertEquals(0, status);
    }

    @Test
    void theFifthTemplateOfAWordTakesThePlaceOfItsOldest() throws IOException {
        Path templates = folder.resolve("anna");
        List<String> line = new ArrayList<>(List.of("enrol", "--templates", templates.toString(), "yes"));
        for (String spoken : List.of("yes", "seven", "no", "forward", "three")) {
            line.add(word(spoken).toString());
        }
        String[] numbers = run(line.subList(0, 8).toArray(String[]::new)).split("\n");
        assertTrue(numbers[3].endsWith("\tyes\t4"), numbers[3]);
        byte[] second = Files.readAllBytes(templates.resolve("yes.2.word"));
        byte[] fourth = Files.readAllBytes(templates.resolve("yes.4.word"));
        String three = run("enrol", "--templates", templates.toString(), "yes", line.get(8));
        assertEquals(line.get(8) + "\tyes\t4\n", three);
        assertArrayEquals(second, Files.readAllBytes(templates.resolve("yes.1.word")));
        assertArrayEquals(fourth, Files.readAllBytes(templates.resolve("yes.3.word")));
        try (Stream<Path> kept = Files.list(templates)) {
            assertEquals(4, kept.count());
        }
        assertTrue(run("hear", "--templates", templates.toString(), line.get(8)).endsWith("\tyes\t0.000\n"));
    }

    @Test
    void aFileWithoutAWordIsNamedAndTheOthersAreHeard() throws IOException {
        Path silence = folder.resolve("silence.wav");
        try (WavWriter wav = new WavWriter(silence, 1)) {
            wav.write(new short[8000]);
        }
        String templates = folder.resolve("anna").toString();
        run("enrol", "--templates", templates, "yes", "" + word("yes"));
        assertEquals(
                word("yes") + "\tyes\t0.000\n", run("hear", "--templates", templates, "" + silence, "" + word("yes")));
        assertEquals("simgsm-modem: " + silence + ": expected a spoken word, found none\n", errors);
        assertEquals(1, status);
    }

    @Test
    void aDamagedTemplateIsNamed() throws IOException {
        Path templates = Files.createDirectory(folder.resolve("bob"));
        Path damaged = Files.write(templates.resolve("yes.1.word"), new byte[] {0, 0, 0, 1});
        run("hear", "--templates", templates.toString(), word("yes").toString());
        assertTrue(errors.contains(damaged + ": template of 1 frames, expected 5 to 300"), errors);
        assertEquals(74, status);
    }

    @ParameterizedTest
    @CsvSource({
        "say, missing DIR",
        "say x, missing WORD",
        "hear, missing FILE.wav",
        "hear x.wav, missing --templates DIR",
        "hear --templates nowhere x.wav, '--templates: expected templates made by enrol, found none'",
        "enrol --templates t, missing WORD",
        "enrol --templates t yes, missing FILE.wav",
        "enrol --templates t a/b x.wav, 'expected a word of letters, digits and hyphens, found a/b'"
    })
    void aCommandLineThatLacksSomethingSaysWhat(String line, String reason) {
        run(line.split(" "));
        assertEquals("simgsm-modem: " + reason + "; see --help\n", errors);
        assertEquals(2, status);
    }

    private short[] said(String... options) throws IOException {
        List<String> words = new ArrayList<>(List.of("say", "" + folder, "seven"));
        words.addAll(List.of(options));
        assertEquals(folder.resolve("seven.wav") + "\n", run(words.toArray(String[]::new)));
        assertEquals("", errors);
        byte[] octets = Files.readAllBytes(folder.resolve("seven.wav"));
        short[] samples = new short[(octets.length - 44) / 2];
        ByteBuffer.wrap(octets, 44, octets.length - 44)
                .order(ByteOrder.LITTLE_ENDIAN)
                .asShortBuffer()
                .get(samples);
        return samples;
    }

    private static double power(short[] samples, int from, int to) {
        return IntStream.range(from, to)
                .mapToDouble(i -> (double) samples[i] * samples[i])
                .average()
                .orElseThrow();
    }

    @Test
    void wordsOfThePromptsAreWrittenWithNoiseAtAnotherPitchOrThroughACodec() throws IOException {
        short[] plain = said();
        assertTrue(power(plain, 0, 2400) < 100, "silence before: " + power(plain, 0, 2400));
        short[] noisy = said("--noise", "10");
        double decibels = 10 * Math.log10(power(noisy, 0, 2400) / power(plain, 2400, plain.length - 2400));
        assertEquals(-10, decibels, 3);
        assertEquals(plain.length, noisy.length);
        int length = plain.length - 4800;
        assertEquals(length / 1.25, said("--pitch", "25").length - 4800, 160);
        short[] coded = said("--codec", "gsm");
        assertEquals(plain.length, coded.length);
        assertTrue(!Arrays.equals(plain, coded));
        assertTrue(!Arrays.equals(noisy, said("--noise", "10", "--seed", "2")));
    }

    @Test
    void aWordOfEitherLanguageIsSaidAndAnUnknownOneIsNamed() {
        assertEquals(folder.resolve("adelante.wav") + "\n", run("say", "" + folder, "adelante"));
        run("say", "" + folder, "anchovy");
        assertEquals(
                "simgsm-modem: expected a word of the prompts, such as forward or adelante, found anchovy; see --help\n",
                errors);
    }
}
