package simgsm.ui.scope;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.ActionEvent;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.KeyCandidate;
import simgsm.dtmf.ToneShape;
import simgsm.scope.ToneTrace;
import simgsm.scope.ToneTracer;
import simgsm.speech.SpeechCodec;
import simgsm.tone.ToneExperiment;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Painted;
import simgsm.ui.Slider;
import simgsm.ui.Theme;
import simgsm.ui.glossary.Glossary;
import simgsm.ui.glossary.TermPanel;

/** The tone scope, painted without a display. */
class ToneScopeTest {
    @BeforeEach
    void light() {
        Theme.zoomTo(1);
        Theme.install(Appearance.LIGHT);
    }

    private static ToneScope scopeAfter(DtmfKey key, int millis) {
        DtmfGenerator generator = new DtmfGenerator();
        generator.enqueue(key);
        ToneTracer tracer = new ToneTracer();
        for (int i = 0; i < millis / 20; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
        }
        ToneScope scope = new ToneScope(Locale.ENGLISH);
        scope.show(tracer.newest());
        return scope;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.25, 2})
    void aToneShowsTwoBarsAWaveAndItsKey(double scale) {
        int quiet = Painted.count(Painted.at(new ToneScope(Locale.ENGLISH), scale), Ink.ACCENT);
        int sounding = Painted.count(Painted.at(scopeAfter(DtmfKey.HASH, 80), scale), Ink.ACCENT);
        assertTrue(sounding > quiet + 800 * scale * scale, quiet + " and " + sounding);
    }

    @Test
    void theNumbersAreSpoken() {
        String spoken = scopeAfter(DtmfKey.FIVE, 160).getAccessibleContext().getAccessibleName();
        assertTrue(spoken.startsWith("Tone scope: key 5, -"), spoken);
    }

    @Test
    void beforeAnyToneTheScopeSaysItsNameOnly() {
        assertEquals(
                "Tone scope",
                new ToneScope(Locale.ENGLISH).getAccessibleContext().getAccessibleName());
    }

    private static void move(ToneScopePanel panel, String fader, int value) {
        ComponentNames.find(panel, fader)
                .orElseThrow()
                .getAccessibleContext()
                .getAccessibleValue()
                .setCurrentAccessibleValue(value);
    }

    private static String verdict(ToneScopePanel panel) {
        return ((JLabel) ComponentNames.find(panel, "scope.verdict").orElseThrow()).getText();
    }

    @Test
    void theFadersSetAnExperimentAndResetEndsIt() {
        List<ToneExperiment> chosen = new ArrayList<>();
        ToneScopePanel panel = new ToneScopePanel(Locale.ENGLISH, chosen::add);
        move(panel, "scope.noise", 21);
        move(panel, "scope.shift", -15);
        assertEquals(List.of(new ToneExperiment(10, 0), new ToneExperiment(10, -1.5)), chosen);
        ((JButton) ComponentNames.find(panel, "scope.reset").orElseThrow()).doClick();
        assertEquals(ToneExperiment.NONE, chosen.get(chosen.size() - 1));
        move(panel, "scope.shift", 1000);
        assertEquals(5, chosen.get(chosen.size() - 1).shiftPercent());
    }

    @Test
    void theBarSaysThatOnlyTheScopeHearsItAndThenHowManyKeysItHeard() {
        ToneScopePanel panel = new ToneScopePanel(Locale.ENGLISH, experiment -> {});
        assertTrue(verdict(panel).contains("Only this scope"), verdict(panel));
        move(panel, "scope.noise", 16);
        ToneTracer tracer = new ToneTracer();
        tracer.tryOut(new ToneExperiment(15, 0));
        DtmfGenerator generator = new DtmfGenerator();
        generator.enqueue(DtmfKey.ONE);
        generator.enqueue(DtmfKey.TWO);
        for (int i = 0; i < 30; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
        }
        panel.show(tracer.newest());
        assertEquals("Heard 2 of 2 keys", verdict(panel));
    }

    @Test
    void faderKeysGoByStepsByPagesAndBackToRest() {
        Slider fader = new Slider(0, 40, 10, () -> {});
        for (String key : new String[] {"RIGHT", "UP", "PAGE_UP", "LEFT"}) {
            press(fader, key);
        }
        assertEquals(16, fader.getValue());
        press(fader, "HOME");
        assertEquals(10, fader.getValue());
        press(fader, "END");
        assertEquals(40, fader.getValue());
    }

    private static void press(Slider fader, String key) {
        Object id = fader.getInputMap().get(KeyStroke.getKeyStroke(key));
        fader.getActionMap().get(id).actionPerformed(new ActionEvent(fader, ActionEvent.ACTION_PERFORMED, key));
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyTextOfTheExperimentFits(String language) {
        ToneScopePanel panel = new ToneScopePanel(Locale.forLanguageTag(language), experiment -> {});
        move(panel, "scope.noise", 40);
        move(panel, "scope.shift", -50);
        click(panel, "scope.predict");
        focus((JComponent) ComponentNames.find(panel, "scope.guess").orElseThrow(), FocusEvent.FOCUS_GAINED);
        for (int width : new int[] {220, 319, 320, 500}) {
            panel.setSize(width, 326);
            layOut(panel);
            layOut(panel);
            for (Component label : labels(panel, new ArrayList<>())) {
                assertTrue(
                        label.getWidth() >= ((JLabel) label).getUI().getPreferredSize((JLabel) label).width,
                        ((JLabel) label).getText() + " in " + width);
            }
            assertTrue(ComponentNames.find(panel, "scope.noise").orElseThrow().getWidth() > 30, "fader in " + width);
        }
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    private static List<Component> labels(Container container, List<Component> found) {
        for (Component child : container.getComponents()) {
            if (child instanceof JLabel) {
                found.add(child);
            } else if (child instanceof Container inner) {
                labels(inner, found);
            }
        }
        return found;
    }

    @Test
    void eachKeyLooksDifferent() {
        var pictures = new java.util.HashSet<Integer>();
        for (DtmfKey key : DtmfKey.values()) {
            pictures.add(Painted.hash(Painted.at(scopeAfter(key, 80), 1)));
        }
        assertEquals(DtmfKey.values().length, pictures.size());
    }

    /** A panel that has seen one key at 7 dB of twist. */
    private static ToneScopePanel twisted(String language) {
        DtmfGenerator generator = new DtmfGenerator();
        generator.enqueue(DtmfKey.FIVE, new ToneShape(100, 100, -16, -9, 0));
        ToneTracer tracer = new ToneTracer();
        for (int i = 0; i < 4; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
        }
        ToneScopePanel panel = new ToneScopePanel(Locale.forLanguageTag(language), experiment -> {});
        panel.show(tracer.newest());
        return panel;
    }

    private static String spoken(ToneScopePanel panel, String name) {
        return ComponentNames.find(panel, name)
                .orElseThrow()
                .getAccessibleContext()
                .getAccessibleName();
    }

    @ParameterizedTest
    @CsvSource({
        "en, '5: key, log odds ', '5: levels differ by '",
        "es, '5: tecla, verosimilitud ', '5: niveles distintos en '"
    })
    void eachReceiverSaysWhyItTookAKeyOrNot(String language, String modem, String classic) {
        ToneScopePanel panel = twisted(language);
        String accepted = spoken(panel, "scope.candidates.modem");
        assertTrue(accepted.startsWith(modem), accepted);
        String rejected = spoken(panel, "scope.candidates.classic");
        assertTrue(rejected.startsWith(classic), rejected);
    }

    @Test
    void aBarOverTheLineIsAccentedAndOneBelowIsNot() {
        ToneScopePanel panel = twisted("en");
        assertTrue(accent(panel, "scope.candidates.modem") > 100);
        assertEquals(0, accent(panel, "scope.candidates.classic"));
    }

    private static int accent(ToneScopePanel panel, String name) {
        return Painted.count(
                Painted.at((JComponent) ComponentNames.find(panel, name).orElseThrow(), 1), Ink.ACCENT);
    }

    @Test
    void theReceiversButtonSelectsItsLevelsAndItsKey() {
        ToneScopePanel panel = twisted("en");
        assertTrue(spoken(panel, "scope.picture").startsWith("Tone scope: key 5"));
        ((JToggleButton) ComponentNames.find(panel, "scope.receiver.classic").orElseThrow()).doClick();
        assertEquals("Tone scope", spoken(panel, "scope.picture"));
    }

    @Test
    void theLargeScopeHasBothReceiversAndTheSmallOneThatOfPhoneAndModem() {
        ToneScopePanel small = twisted("en");
        assertTrue(isRowVisible(small, "scope.receiver.modem"));
        assertFalse(isRowVisible(small, "scope.receiver.classic"));
        assertFalse(
                ComponentNames.find(small, "scope.receiver.modem").orElseThrow().isVisible());
        ToneScopePanel large = small.enlarged();
        assertTrue(isRowVisible(large, "scope.receiver.classic"));
        large.setCompact(true);
        assertFalse(isRowVisible(large, "scope.receiver.classic"));
    }

    private static boolean isRowVisible(ToneScopePanel panel, String name) {
        return ComponentNames.find(panel, name).orElseThrow().getParent().isVisible();
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyFindingAndMeasureHasItsWords(String language) {
        TextBundle texts = DesktopTexts.in(Locale.forLanguageTag(language));
        for (KeyCandidate.Finding finding : KeyCandidate.Finding.values()) {
            KeyCandidate candidate = new KeyCandidate(DtmfKey.STAR, 0, 1, finding, 1, 2, "LINE", 3, true);
            assertTrue(CandidateWords.of(texts, candidate).startsWith("*: "), finding.name());
        }
        for (String measure : KeyCandidate.measures()) {
            assertFalse(texts.of("scope.measure." + measure, "1").isEmpty(), measure);
        }
    }

    private static void click(ToneScopePanel panel, String name) {
        ((AbstractButton) ComponentNames.find(panel, name).orElseThrow()).doClick();
    }

    private static String question(ToneScopePanel panel) {
        return ((JLabel) ComponentNames.find(panel, "scope.question").orElseThrow()).getText();
    }

    @ParameterizedTest
    @CsvSource({"en, Which key is it?", "es, '\u00bfQu\u00e9 tecla es?'"})
    void aPredictionHidesTheKeyUntilItIsTyped(String language, String asked) {
        ToneScopePanel panel = new ToneScopePanel(Locale.forLanguageTag(language), experiment -> {});
        List<Boolean> hidden = new ArrayList<>();
        panel.whenHiding(hidden::add);
        click(panel, "scope.predict");
        panel.show(fiveIsSounding());
        assertEquals(asked, question(panel));
        assertFalse(spoken(panel, "scope.picture").contains("5"), spoken(panel, "scope.picture"));
        assertFalse(isRowVisible(panel, "scope.receiver.modem"));

        type(panel, '6');
        assertTrue(question(panel).contains("5 (770 + 1336 Hz)"), question(panel));
        assertTrue(isRowVisible(panel, "scope.receiver.modem"));
        assertEquals(List.of(true, false), hidden);
    }

    @Test
    void aPredictionInTheLargeScopeHidesTheKeyInTheSmallOne() {
        ToneScopePanel small = new ToneScopePanel(Locale.ENGLISH, experiment -> {});
        List<Boolean> hidden = new ArrayList<>();
        small.whenHiding(hidden::add);
        ToneScopePanel large = small.enlarged();
        click(large, "scope.predict");
        small.show(fiveIsSounding());
        large.show(fiveIsSounding());
        assertFalse(spoken(small, "scope.picture").contains("5"), spoken(small, "scope.picture"));
        assertFalse(isRowVisible(small, "scope.receiver.modem"));

        type(large, '5');
        assertTrue(spoken(small, "scope.picture").contains("5"), spoken(small, "scope.picture"));
        assertTrue(isRowVisible(small, "scope.receiver.modem"));
        assertEquals(List.of(true, false), hidden);
    }

    private static void escape(ToneScopePanel panel) {
        KeyStroke stroke = KeyStroke.getKeyStroke("ESCAPE");
        Object id =
                panel.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).get(stroke);
        Action leave = panel.getActionMap().get(id);
        if (leave.isEnabled()) {
            leave.actionPerformed(new ActionEvent(panel, 0, ""));
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void aPredictionSaysWhereTheKeyboardGoesAndEscapeEndsIt(String language) {
        ToneScopePanel panel = new ToneScopePanel(Locale.forLanguageTag(language), experiment -> {});
        AbstractButton tool =
                (AbstractButton) ComponentNames.find(panel, "scope.predict").orElseThrow();
        escape(panel);
        assertFalse(tool.isSelected(), "Escape begins nothing");

        click(panel, "scope.predict");
        JLabel keyboard = (JLabel) ComponentNames.find(panel, "scope.keyboard").orElseThrow();
        JComponent field =
                (JComponent) ComponentNames.find(panel, "scope.guess").orElseThrow();
        String elsewhere = keyboard.getText();
        focus(field, FocusEvent.FOCUS_GAINED);
        assertTrue(keyboard.getText().contains("Esc"), keyboard.getText());
        focus(field, FocusEvent.FOCUS_LOST);
        assertEquals(elsewhere, keyboard.getText());

        escape(panel);
        assertFalse(tool.isSelected());
        assertFalse(field.getParent().getParent().isShowing());
    }

    private static void focus(JComponent field, int id) {
        FocusEvent event = new FocusEvent(field, id);
        for (FocusListener listener : field.getFocusListeners()) {
            if (id == FocusEvent.FOCUS_GAINED) {
                listener.focusGained(event);
            } else {
                listener.focusLost(event);
            }
        }
    }

    @Test
    void aQuestionEndsAFrozenPicture() {
        ToneScopePanel panel = new ToneScopePanel(Locale.ENGLISH, experiment -> {});
        AbstractButton freeze =
                (AbstractButton) ComponentNames.find(panel, "scope.freeze").orElseThrow();
        click(panel, "scope.freeze");
        click(panel, "scope.predict");
        assertFalse(freeze.isSelected());
        click(panel, "scope.freeze");
        click(panel, "scope.practise");
        assertFalse(freeze.isSelected());
        assertEquals("Which key is it?", question(panel));
    }

    @Test
    void aPracticeToneIsGuessedWithoutACall() {
        ToneScopePanel panel = new ToneScopePanel(Locale.ENGLISH, experiment -> {});
        click(panel, "scope.predict");
        click(panel, "scope.practise");
        assertEquals("Which key is it?", question(panel));
        type(panel, 'x');
        assertEquals("Which key is it?", question(panel));
        type(panel, '#');
        assertTrue(question(panel).matches("(Right: #|No, it is .) \\(.*"), question(panel));
    }

    private static void type(ToneScopePanel panel, char key) {
        Component field = ComponentNames.find(panel, "scope.guess").orElseThrow();
        KeyEvent event = new KeyEvent(field, KeyEvent.KEY_TYPED, 0, 0, KeyEvent.VK_UNDEFINED, key);
        for (KeyListener listener : field.getKeyListeners()) {
            listener.keyTyped(event);
        }
    }

    private static ToneTrace fiveIsSounding() {
        DtmfGenerator generator = new DtmfGenerator();
        generator.enqueue(DtmfKey.FIVE);
        ToneTracer tracer = new ToneTracer();
        for (int i = 0; i < 4; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
        }
        return tracer.newest();
    }

    @Test
    void theArrowsMoveTheCursorsAndTheDifferenceIsSpoken() {
        ToneScopePanel panel = new ToneScopePanel(Locale.ENGLISH, experiment -> {});
        panel.show(fiveIsSounding());
        click(panel, "scope.cursors");
        assertTrue(spoken(panel, "scope.picture").contains("A 8.00  B 16.00  difference +8.00 ms = 125 Hz"));
        JComponent picture =
                (JComponent) ComponentNames.find(panel, "scope.picture").orElseThrow();
        for (String key : new String[] {"RIGHT", "ctrl RIGHT", "shift LEFT"}) {
            Object id = picture.getInputMap().get(KeyStroke.getKeyStroke(key));
            picture.getActionMap().get(id).actionPerformed(new ActionEvent(picture, 0, key));
        }
        assertTrue(
                spoken(panel, "scope.picture").contains("A 9.13  B 15.88  difference +6.75 ms = 148 Hz"),
                spoken(panel, "scope.picture"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"scope.freeze", "scope.cursors", "scope.spectrogram", "scope.predict"})
    void everyToolChangesThePicture(String tool) {
        ToneScopePanel panel = new ToneScopePanel(Locale.ENGLISH, experiment -> {});
        panel.show(fiveIsSounding());
        JComponent picture =
                (JComponent) ComponentNames.find(panel, "scope.picture").orElseThrow();
        int before = Painted.hash(Painted.at(picture, 1));
        click(panel, tool);
        panel.show(new ToneTracer().newest());
        if (tool.equals("scope.freeze")) {
            panel.show(fiveIsSounding());
        }
        assertNotEquals(before, Painted.hash(Painted.at(picture, 1)));
    }

    @Test
    void theSoundBeforeTheExperimentIsDrawnBehindThatAfterIt() {
        ToneTracer tracer = new ToneTracer();
        tracer.tryOut(new ToneExperiment(0, 0, Optional.of(SpeechCodec.Kind.GSM_FULL_RATE)));
        DtmfGenerator generator = new DtmfGenerator();
        generator.enqueue(DtmfKey.FIVE);
        for (int i = 0; i < 4; i++) {
            short[] frame = new short[160];
            generator.read(frame);
            tracer.accept(frame);
        }
        ToneScopePanel panel = new ToneScopePanel(Locale.ENGLISH, experiment -> {});
        panel.show(tracer.newest());
        JComponent picture =
                (JComponent) ComponentNames.find(panel, "scope.picture").orElseThrow();
        int before = Painted.count(Painted.at(picture, 2), Ink.TEXT);
        click(panel, "scope.compare");
        assertTrue(Painted.count(Painted.at(picture, 2), Ink.TEXT) > before + 300);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void theTermsOfTheScopeOpenInItAndAreInTheGlossary(String language) {
        Locale locale = Locale.forLanguageTag(language);
        Glossary glossary = Glossary.in(locale);
        String[] words = DesktopTexts.in(locale).of("scope.terms.list").split(", ");
        for (String word : words) {
            assertTrue(glossary.find(word).isPresent(), word);
        }
        ToneScopePanel panel = new ToneScopePanel(locale, experiment -> {});
        assertTrue(ComponentNames.find(panel, "terms.links").isEmpty(), "made when asked for");
        click(panel, "scope.terms");
        Component links = ComponentNames.find(panel, "terms.links").orElseThrow();
        Component terms =
                SwingUtilities.getAncestorOfClass(TermPanel.class, links).getParent();
        assertTrue(terms.isVisible());
        assertTrue(links.isFocusable());
        click(panel, "scope.terms");
        assertFalse(terms.isVisible());
        click(panel, "scope.terms");
        assertTrue(terms.isVisible());
        assertSame(links, ComponentNames.find(panel, "terms.links").orElseThrow(), "made once");
        assertEquals(
                words.length,
                glossary.parts(String.join(" \u00b7 ", words)).stream()
                        .filter(part -> !part.term().isEmpty())
                        .count());
        assertEquals(List.of(), ComponentNames.unnamed(panel));
    }
}
