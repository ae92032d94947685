package simgsm.ui.scope;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.scope.ToneTracer;
import simgsm.ui.ComponentNames;
import simgsm.ui.Painted;
import simgsm.ui.Theme;
import simgsm.words.HeardWord;
import simgsm.words.SpeechFrame;
import simgsm.words.WordComparison;
import simgsm.words.WordComparison.WordDistance;

/** The picture of a spoken word, painted without a display. */
class WordScopeTest {
    private final ToneTracer tracer = new ToneTracer();

    @BeforeEach
    void light() {
        Theme.install(Appearance.LIGHT, 1);
    }

    /** @param distance below 20 of a word of another length */
    private static WordComparison two(double distance) {
        List<SpeechFrame> frames = IntStream.range(0, 40)
                .mapToObj(i -> {
                    float[] bands = new float[23];
                    bands[i / 2] = 4000;
                    return new SpeechFrame(bands, 60);
                })
                .toList();
        return new WordComparison(
                frames,
                new HeardWord("two", "zero", distance < 20 ? 1 : distance / 50, distance >= 20),
                List.of(new WordDistance("two", distance), new WordDistance("zero", 50), new WordDistance("yes", 80)),
                IntStream.range(0, 40).mapToObj(i -> i / 39.0).toList());
    }

    private static AbstractButton button(ToneScopePanel panel) {
        return (AbstractButton) ComponentNames.find(panel, "scope.word").orElseThrow();
    }

    private static JComponent picture(ToneScopePanel panel) {
        return (JComponent) ComponentNames.find(panel, "scope.picture").orElseThrow();
    }

    private ToneScopePanel showing(String language, WordComparison word) {
        tracer.reset();
        ToneScopePanel panel = new ToneScopePanel(Locale.forLanguageTag(language), experiment -> {});
        panel.show(tracer.newest());
        assertFalse(button(panel).isVisible(), "offered without a word");
        tracer.show(word);
        panel.show(tracer.newest());
        assertTrue(button(panel).isVisible());
        button(panel).doClick(0);
        return panel;
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "en | 40 | Tone scope: two 40.0, zero 50.0; ratio 0.80 < 0.92: taken",
                "en | 48 | Tone scope: two 48.0, zero 50.0; ratio 0.96 > 0.92: refused",
                "en | 10 | Tone scope: two 10.0; over 2.2 times as long or short: refused",
                "es | 48 | Osciloscopio de tonos: dos 48.0, cero 50.0; cociente 0.96 > 0.92: rechazada"
            })
    void theReasonIsSaidInWordsWithDistancesAndLimit(String language, double distance, String spoken) {
        ToneScopePanel panel = showing(language, two(distance));
        assertEquals(spoken, picture(panel).getAccessibleContext().getAccessibleName());
    }

    /** Once said to be taken. */
    @Test
    void theOnlyWordAllowedIsRefusedIfItHasAnotherLength() {
        WordComparison compared = two(10);
        WordComparison alone = new WordComparison(
                compared.frames(),
                new HeardWord("two", "", 1, false),
                compared.distances().subList(0, 1),
                compared.path());
        assertEquals(
                "Tone scope: two 10.0; over 2.2 times as long or short: refused",
                picture(showing("en", alone)).getAccessibleContext().getAccessibleName());
    }

    @Test
    void aRefusedWordHasItsBarAndThePathInTheColourOfWarningsAndATakenOneThePathOnly() {
        int taken = Painted.count(Painted.at(picture(showing("en", two(40))), 1), Ink.WARNING);
        int refused = Painted.count(Painted.at(picture(showing("en", two(48))), 1), Ink.WARNING);
        assertTrue(taken > 20 && refused > taken + 200, taken + " and " + refused);
    }

    @Test
    void frequenciesAreNamedAtTheLeftAndTimeBelow() {
        BufferedImage image = Painted.at(picture(showing("en", two(40))), 1);
        BufferedImage left = image.getSubimage(0, 0, 36, image.getHeight() - 36);
        BufferedImage below = image.getSubimage(46, image.getHeight() - 30, 90, 8);
        for (BufferedImage labels : List.of(left, below)) {
            int blank = Painted.count(labels, Ink.CARD);
            assertTrue(labels.getWidth() * labels.getHeight() - blank > 100, "blank: " + blank);
        }
    }

    @Test
    void thePicturesOfWordAndSpectrumReplaceEachOther() {
        ToneScopePanel panel = showing("en", two(40));
        AbstractButton spectrum =
                (AbstractButton) ComponentNames.find(panel, "scope.spectrogram").orElseThrow();
        spectrum.doClick(0);
        assertFalse(button(panel).isSelected());
        button(panel).doClick(0);
        assertFalse(spectrum.isSelected());
    }

    @Test
    void theNextCallBeginsWithoutAWord() {
        showing("en", two(40));
        tracer.reset();
        assertTrue(tracer.newest().word().isEmpty());
    }
}
