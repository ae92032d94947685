package simgsm.phone.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.swing.AbstractButton;
import javax.swing.ButtonModel;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.phone.handset.Bench;
import simgsm.phone.screen.PhoneKey;
import simgsm.sim.CardPin;
import simgsm.sim.PinLock;
import simgsm.station.context.StationEvent;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/** The handset's panel, built and painted without a display. */
class HandsetPanelTest {
    private static final Locale SPANISH = Locale.forLanguageTag("es");

    @BeforeEach
    void light() {
        Theme.zoomTo(1);
        Theme.install(Appearance.LIGHT);
    }

    @AfterEach
    void asItWas() {
        light();
    }

    private static void press(PanelBench bench, String name) {
        ButtonModel model = ((AbstractButton) bench.find(name)).getModel();
        model.setArmed(true);
        model.setPressed(true);
    }

    private static void letGo(PanelBench bench, String name) {
        ButtonModel model = ((AbstractButton) bench.find(name)).getModel();
        model.setPressed(false);
        model.setArmed(false);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyControlHasANameAndTheDisplayCanBeReached(String language) {
        PanelBench bench = new PanelBench(Locale.forLanguageTag(language));
        assertEquals(List.of(), ComponentNames.unnamed(bench.panel));
        assertTrue(bench.find("lcd").isFocusable());
    }

    @Test
    void aNumberIsPressedAndCalled() {
        PanelBench bench = new PanelBench(Locale.ENGLISH);
        for (String key : List.of("5", "5", "5", "0", "2", "0", "0", "call")) {
            press(bench, "key." + key);
            letGo(bench, "key." + key);
        }
        assertEquals(List.of("calling 5550200"), bench.bench.events);
    }

    @Test
    void aKeyIsDownAsLongAsTheMouseHoldsIt() {
        PanelBench bench = new PanelBench(Locale.ENGLISH);
        press(bench, "key.#");
        assertEquals(List.of("down HASH"), bench.acts);
        letGo(bench, "key.#");
        assertEquals(List.of("down HASH", "up HASH"), bench.acts);
    }

    @Test
    void aKeyIsUpWhenTheMouseIsDraggedOffIt() {
        PanelBench bench = new PanelBench(Locale.ENGLISH);
        press(bench, "key.1");
        ((AbstractButton) bench.find("key.1")).getModel().setArmed(false);
        assertEquals(List.of("down ONE", "up ONE"), bench.acts);
    }

    @ParameterizedTest
    @EnumSource(PhoneKey.class)
    void everyKeyHasANameForTestsAndOneForTheEar(PhoneKey key) {
        PanelBench bench = new PanelBench(Locale.ENGLISH);
        Component button = bench.find(PhoneKeyButton.nameOf(key));
        String spoken = button.getAccessibleContext().getAccessibleName();
        assertFalse(spoken.startsWith("key."), spoken);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void noTwoKeysSoundAlikeToTheEar(String language) {
        PanelBench bench = new PanelBench(Locale.forLanguageTag(language));
        Set<String> names = new HashSet<>();
        for (PhoneKey key : PhoneKey.values()) {
            names.add(bench.find(PhoneKeyButton.nameOf(key))
                    .getAccessibleContext()
                    .getAccessibleName());
        }
        assertEquals(PhoneKey.values().length, names.size());
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.25, 2})
    void theHandsetIsPaintedAtEveryScale(double scale) {
        BufferedImage image = new PanelBench(Locale.ENGLISH).paint(scale);
        double area = scale * scale;
        assertTrue(PanelBench.count(image, Ink.LCD_PAPER) > 30_000 * area);
        assertTrue(PanelBench.count(image, Ink.KEY_FACE) > 40_000 * area);
        assertTrue(PanelBench.count(image, Ink.CALL_FACE) > 1_500 * area);
        assertTrue(PanelBench.count(image, Ink.END_FACE) > 1_500 * area);
        assertTrue(PanelBench.count(image, Ink.LCD_INK) > 300 * area);
    }

    @Test
    void lightAndDarkAreTwoPicturesAndTheDisplayIsTheSameInBoth() {
        PanelBench bench = new PanelBench(Locale.ENGLISH);
        BufferedImage light = bench.paint(1);
        Theme.install(Appearance.DARK);
        BufferedImage dark = bench.paint(1);
        assertNotEquals(light.getRGB(160, 330), dark.getRGB(160, 330));
        assertEquals(light.getRGB(160, 60), dark.getRGB(160, 60));
    }

    @Test
    void theHandsetScalesAsAWholeWithThePanel() {
        PanelBench bench = new PanelBench(Locale.ENGLISH);
        Rectangle before = bench.find("key.5").getBounds();
        bench.resize(bench.panel.getWidth() * 2, bench.panel.getHeight() * 2);
        Rectangle after = bench.find("key.5").getBounds();
        assertEquals(before.width * 2, after.width, 1);
        assertEquals(before.y * 2, after.y, 1);
    }

    @ParameterizedTest
    @CsvSource({"en, emergency only, 112", "es, emergencias, 112"})
    void aLockedCardShowsWhichCallsArePossible(String language, String lamp, String number) {
        Bench locked = new Bench();
        locked.station.card = new PinLock(Optional.of(new CardPin("1234", "12345678", true, 3, 10)), kept -> {});
        locked.handset.powerOn();
        PanelBench bench = new PanelBench(locked, Locale.forLanguageTag(language));
        String link = bench.find("lamp.link").getAccessibleContext().getAccessibleName();
        String display = bench.find("lcd").getAccessibleContext().getAccessibleName();
        assertTrue(link.contains(lamp), link);
        assertTrue(display.contains(number), display);
    }

    @Test
    void noTwoKeysOverlap() {
        PanelBench bench = new PanelBench(Locale.ENGLISH);
        for (PhoneKey one : PhoneKey.values()) {
            for (PhoneKey other : PhoneKey.values()) {
                Rectangle a = bench.find(PhoneKeyButton.nameOf(one)).getBounds();
                Rectangle b = bench.find(PhoneKeyButton.nameOf(other)).getBounds();
                assertFalse(one != other && a.intersects(b), one + " and " + other);
            }
        }
    }

    @Test
    void theKeyWhoseToneSoundsIsLit() {
        PanelBench bench = new PanelBench(Bench.connected(), Locale.ENGLISH);
        int before = PanelBench.count(bench.paint(1), Ink.ACCENT_WASH);
        bench.bench.handset.press(simgsm.dtmf.DtmfKey.sequence("5"));
        bench.bench.speechMillis(40);
        assertTrue(PanelBench.count(bench.paint(1), Ink.ACCENT_WASH) > before + 2_000);
    }

    @Test
    void theScopeFoldsOpenAndShowsTheTone() {
        PanelBench bench = new PanelBench(Bench.connected(), Locale.ENGLISH);
        int closed = bench.panel.getPreferredSize().height;
        assertFalse(bench.find("scope").isVisible());
        ((AbstractButton) bench.find("scope.switch")).doClick(0);
        assertTrue(bench.find("scope").isVisible());
        assertTrue(bench.panel.getPreferredSize().height > closed + 100);
        int quiet = PanelBench.count(bench.paint(1), Ink.ACCENT);
        bench.bench.handset.press(simgsm.dtmf.DtmfKey.sequence("5"));
        bench.bench.speechMillis(80);
        assertTrue(PanelBench.count(bench.paint(1), Ink.ACCENT) > quiet + 300);
    }

    @ParameterizedTest
    @CsvSource({
        "1.5, 1050, SCOPE, 912, 936",
        "1, 1050, SCOPE, 320, 1000",
        "1, 740, SCOPE, 608, 624",
        "1, 740, EVENTS, 320, 764"
    })
    void aFoldOpensBesideTheKeysWhereTheScreenIsTooLowForItBelow(
            double zoom, int screenHeight, HandsetFold fold, int width, int height) {
        HandsetLayout layout = new HandsetLayout();
        layout.setFold(fold);
        assertEquals(new Dimension(width, height), layout.sized(zoom, screenHeight));
        assertEquals(width > height / 2, layout.isBeside(new Dimension(width, height)));
    }

    @Test
    void inAWideHandsetTheScopeStandsBesideTheKeysWhichKeepTheirSize() {
        PanelBench bench = new PanelBench(Bench.connected(), Locale.ENGLISH);
        Rectangle key = bench.find("key.5").getBounds();
        ((AbstractButton) bench.find("scope.switch")).doClick(0);
        bench.resize(608, 624);
        assertEquals(key, bench.find("key.5").getBounds());
        assertEquals(new Rectangle(318, 24, 260, 574), bench.find("scope").getBounds());
    }

    @Test
    void aReaderOfTheEventsKeepsThePlaceWhenTheOldestMakeRoom() throws Exception {
        PanelBench bench = new PanelBench(Bench.connected(), Locale.ENGLISH);
        JTextArea events = (JTextArea) bench.find("events");
        receive(bench, 0, 299);
        bench.paint(1);
        events.setCaretPosition(events.getText().indexOf("message from 5550200: 100\n"));
        receive(bench, 299, 310);
        // A caret follows changes of the event thread only.
        SwingUtilities.invokeAndWait(() -> bench.paint(1));
        assertEquals(events.getText().indexOf("message from 5550200: 100\n"), events.getCaretPosition());
        assertTrue(events.getText().startsWith("12:00  message from 5550200: 10\n"));
        assertEquals("12:00  message from 5550200: 309", lastLineOf(events));
        assertEquals(300, events.getText().lines().count());
    }

    @Test
    void theEventsOpenAtTheNewest() throws Exception {
        PanelBench bench = new PanelBench(Bench.connected(), Locale.ENGLISH);
        receive(bench, 0, 40);
        SwingUtilities.invokeAndWait(() -> {
            bench.paint(1);
            ((AbstractButton) bench.find("events.switch")).doClick(0);
            bench.panel.setSize(bench.panel.getPreferredSize());
            bench.paint(1);
        });
        SwingUtilities.invokeAndWait(() -> {}); // the sizes have been set
        JTextArea events = (JTextArea) bench.find("events");
        Rectangle seen = events.getVisibleRect();
        assertTrue(seen.height > 0 && seen.height < events.getHeight(), seen.toString());
        assertEquals(events.getHeight(), seen.y + seen.height);
    }

    private static void receive(PanelBench bench, int from, int to) {
        for (int i = from; i < to; i++) {
            bench.bench.handset.accept(new StationEvent.ShortMessageReceived("5550200", String.valueOf(i)));
        }
    }

    @Test
    void aHighPanelOpensTheEventsUntilTheUserClosesThem() {
        PanelBench bench = new PanelBench(Bench.connected(), Locale.ENGLISH);
        bench.panel.setSize(320, 763);
        bench.panel.doLayout();
        assertEquals(HandsetFold.NONE, bench.panel.fold());
        bench.panel.setSize(320, 764);
        bench.panel.doLayout();
        assertEquals(HandsetFold.EVENTS, bench.panel.fold());
        ((AbstractButton) bench.find("events.switch")).doClick(0);
        bench.panel.doLayout();
        assertEquals(HandsetFold.NONE, bench.panel.fold());
    }

    @Test
    void theEventsFoldOpenInPlaceOfTheScopeAndFollow() {
        PanelBench bench = new PanelBench(Bench.connected(), Locale.ENGLISH);
        ((AbstractButton) bench.find("scope.switch")).doClick(0);
        ((AbstractButton) bench.find("events.switch")).doClick(0);
        assertFalse(bench.find("scope").isVisible());
        bench.bench.farEndPlays('6');
        bench.paint(1);
        JTextArea events = (JTextArea) bench.find("events");
        assertEquals("12:00  heard 6: executing", lastLineOf(events));
        assertEquals(events.getText().length(), events.getCaretPosition(), "it follows");
        SwingUtilities.updateComponentTreeUI(bench.panel);
        assertNull(events.getKeymap(), "digits go on to the phone");
        assertEquals(events.getText().length(), events.getCaretPosition(), "it still follows");
        bench.bench.farEndPlays('3');
        bench.paint(1);
        assertEquals("12:00  heard 3: executed", lastLineOf(events));
        assertEquals(events.getDocument().getLength(), events.getCaretPosition());
    }

    @Test
    void whoReadsAnEarlierEventStaysThereWhenMoreHappens() {
        PanelBench bench = new PanelBench(Bench.connected(), SPANISH);
        bench.bench.farEndPlays('6');
        bench.paint(1);
        JTextArea events = (JTextArea) bench.find("events");
        events.setCaretPosition(3);
        bench.bench.farEndPlays('3');
        bench.paint(1);
        assertEquals("12:00  o\u00eddo 3: ejecutada", lastLineOf(events));
        assertEquals(3, events.getCaretPosition());
    }

    private static String lastLineOf(JTextArea area) {
        String text = area.getText().stripTrailing();
        return text.substring(text.lastIndexOf('\n') + 1);
    }

    @Test
    void withoutASoundDeviceAQuietNoteSaysSo() {
        PanelBench bench = new PanelBench(SPANISH);
        assertEquals("sin sonido", ((javax.swing.JLabel) bench.find("sound")).getText());
    }

    @Test
    void theLampTellsTheLinkInWords() {
        PanelBench bench = new PanelBench(Locale.ENGLISH);
        assertEquals(
                "Link to the centre: in service",
                bench.find("lamp.link").getAccessibleContext().getAccessibleName());
        bench.bench.handset.powerOff();
        bench.paint(1);
        assertEquals(
                "Link to the centre: off",
                bench.find("lamp.link").getAccessibleContext().getAccessibleName());
    }

    @Test
    void theDisplaySpeaksTheToneThatCameBack() {
        PanelBench bench = new PanelBench(Bench.connected(), SPANISH);
        bench.bench.farEndPlays('4');
        bench.paint(1);
        assertEquals(
                "conectado 5550200, 4 (robot: choque)",
                bench.find("lcd").getAccessibleContext().getAccessibleName());
    }
}
