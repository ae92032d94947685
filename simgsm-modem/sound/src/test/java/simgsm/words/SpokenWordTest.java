package simgsm.words;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Words from sound: front end, ends of words, comparison with a speaker's templates. The prompts are the speaker. */
class SpokenWordTest {
    private static final List<String> WORDS = List.of("forward", "turn", "stop", "one", "two", "three");

    private final List<SpokenWord> heard = new ArrayList<>();
    private final WordCutter cutter = new WordCutter(frames -> heard.add(SpokenWord.of(frames)));
    private final FrontEnd ear = new FrontEnd(cutter::accept);

    /** Hears half a second of quiet noise, the word, and a second. */
    private void hear(String word, double gain, int seed) {
        Random noise = new Random(seed);
        short[] spoken = Prompts.of(SpokenLanguage.ENGLISH).samples(new Utterance(List.of(word)));
        short[] sound = new short[spoken.length + 12_000];
        for (int i = 0; i < sound.length; i++) {
            int at = i - 4_000;
            double sample = at >= 0 && at < spoken.length ? gain * spoken[at] : 0;
            sound[i] = (short) Math.round(sample + 8 * noise.nextGaussian());
        }
        ear.accept(sound);
    }

    private SpokenWord one(String word, double gain, int seed) {
        heard.clear();
        hear(word, gain, seed);
        assertEquals(1, heard.size(), word);
        return heard.get(0);
    }

    private SpeakerTemplates enrolled() {
        SpeakerTemplates templates = new SpeakerTemplates();
        WORDS.forEach(word -> templates.add(word, one(word, 1, word.hashCode())));
        return templates;
    }

    @Test
    void eachWordIsHeardInOtherNoiseAndAtAnotherLevel() {
        SpeakerTemplates templates = enrolled();
        assertEquals(WORDS, List.copyOf(templates.words()));
        for (String word : WORDS) {
            HeardWord found =
                    templates.hear(one(word, 0.5, 7), templates.words()).orElseThrow();
            assertEquals(word, found.word());
            assertTrue(found.isSure(), found.toString());
            assertFalse(found.second().isEmpty());
        }
    }

    @Test
    void onlyPermittedWordsAreCompared() {
        SpeakerTemplates templates = enrolled();

        assertEquals(
                "two",
                templates.hear(one("stop", 1, 3), List.of("two")).orElseThrow().word());
        assertEquals(Optional.empty(), templates.hear(one("stop", 1, 3), List.of("nine")));
        assertEquals(0, templates.count("nine"));
    }

    @Test
    void silenceAndAClickAreNoWords() {
        ear.accept(new short[16_000]);
        short[] click = new short[8_000];
        click[4_000] = 20_000;
        ear.accept(click);

        assertEquals(List.of(), heard);
        assertFalse(cutter.isInWord());
    }

    @Test
    void aWordThatIsForgottenIsNotTold() {
        ear.accept(new short[4_000]);
        ear.accept(Prompts.of(SpokenLanguage.ENGLISH).samples(new Utterance(List.of("forward"))));
        assertTrue(cutter.isInWord());
        cutter.reset();
        ear.accept(new short[8_000]);

        assertEquals(List.of(), heard);
    }

    @Test
    void aTemplateIsReadAsItWasWritten() throws IOException {
        SpokenWord word = one("three", 1, 5);
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        word.write(new DataOutputStream(octets));

        SpokenWord read = SpokenWord.read(new DataInputStream(new ByteArrayInputStream(octets.toByteArray())));

        assertEquals(word.length(), read.length());
        assertEquals(0, TimeWarping.distance(word, read), 1e-9);
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 4, 301})
    void aTemplateOfAnotherLengthIsRefused(int length) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        new DataOutputStream(octets).writeInt(length);

        IOException refusal = assertThrows(
                IOException.class,
                () -> SpokenWord.read(new DataInputStream(new ByteArrayInputStream(octets.toByteArray()))));

        assertTrue(refusal.getMessage().contains("expected 5 to 300"), refusal.getMessage());
    }

    @Test
    void aComparisonHasAllDistancesInOrderAndAPathThatNeverGoesBack() {
        SpeakerTemplates templates = enrolled();
        List<List<SpeechFrame>> words = new ArrayList<>();
        WordCutter frames = new WordCutter(words::add);
        FrontEnd frontEnd = new FrontEnd(frames::accept);
        short[] spoken = Prompts.of(SpokenLanguage.ENGLISH).samples(new Utterance(List.of("three")));
        frontEnd.accept(new short[4_000]);
        frontEnd.accept(spoken);
        frontEnd.accept(new short[8_000]);
        WordComparison compared =
                templates.compare(words.get(0), templates.words()).orElseThrow();
        assertEquals("three", compared.result().word());
        assertEquals(WORDS.size(), compared.distances().size());
        assertEquals(compared.result().second(), compared.distances().get(1).word());
        double ratio = compared.distances().get(0).distance()
                / compared.distances().get(1).distance();
        assertEquals(ratio, compared.result().ratio(), 1e-9);
        assertEquals(words.get(0).size(), compared.path().size());
        assertEquals(compared.path().stream().sorted().toList(), compared.path());
        assertEquals(1, compared.path().get(compared.path().size() - 1));
        assertTrue(compared.path().get(0) < 0.1, compared.path().toString());
    }

    @Test
    void thePathIsThatOfTheLeastDistance() {
        for (int seed = 0; seed < 20; seed++) {
            SpokenWord heard = noise(20 + seed, seed);
            SpokenWord template = noise(40 - seed, seed + 100);
            List<Double> path = TimeWarping.path(heard, template);
            double sum = 0;
            int before = -1;
            for (int i = 0; i < heard.length(); i++) {
                int to = (int) Math.round(path.get(i) * (template.length() - 1));
                double within = 0;
                for (int j = before + 2; j <= to; j++) {
                    within += heard.distance(i, template, j);
                }
                int next = Math.min(before + 1, to);
                double both = 2 * heard.distance(i, template, next) + within;
                double one = i == 0
                        ? Double.POSITIVE_INFINITY
                        : heard.distance(i, template, before)
                                + (to > before ? heard.distance(i, template, before + 1) + within : 0);
                sum += to == before ? one : Math.min(both, one);
                before = to;
            }
            double least = TimeWarping.distance(heard, template);
            assertEquals(least, sum / (heard.length() + template.length()), 1e-9);
        }
    }

    private static SpokenWord noise(int frames, int seed) {
        Random random = new Random(seed);
        List<SpeechFrame> made = new ArrayList<>();
        FrontEnd frontEnd = new FrontEnd(made::add);
        short[] sound = new short[FrontEnd.SHIFT * (frames + 2)];
        for (int i = 0; i < sound.length; i++) {
            sound[i] = (short) (1000 * random.nextGaussian());
        }
        frontEnd.accept(sound);
        return SpokenWord.of(made.subList(0, frames));
    }

    @ParameterizedTest
    @ValueSource(ints = {300, 1000, 3000})
    void aToneIsLoudestInTheBandOfItsFrequency(int hertz) {
        List<SpeechFrame> made = new ArrayList<>();
        short[] tone = new short[400];
        for (int i = 0; i < tone.length; i++) {
            tone[i] = (short) (8000 * Math.sin(2 * Math.PI * hertz * i / 8000));
        }
        new FrontEnd(made::add).accept(tone);
        float[] bands = made.get(1).bands();
        int loudest = 0;
        for (int band = 1; band < bands.length; band++) {
            loudest = bands[band] > bands[loudest] ? band : loudest;
        }
        assertEquals(FrontEnd.band(hertz), loudest, 0.7);
    }

    /** Once, a long noise was taken for the only word that was as long. */
    @Test
    void aWordThatOnlyOneTemplateIsLongEnoughForIsNotSure() {
        SpeakerTemplates templates = new SpeakerTemplates();
        templates.add("long", noise(90, 1));
        templates.add("short", noise(30, 2));
        HeardWord heard = templates.hear(noise(150, 3), templates.words()).orElseThrow();
        assertFalse(heard.isSure(), heard.toString());
    }

    @Test
    void aWordOfAnotherLengthThanTheNearestIsRefusedWithTheRatioOne() {
        SpeakerTemplates templates = new SpeakerTemplates();
        templates.add("short", noise(30, 2));
        HeardWord heard = templates.hear(noise(90, 3), templates.words()).orElseThrow();
        assertEquals(new HeardWord("short", "", 1, false), heard);
        assertFalse(heard.isSure());
    }
}
