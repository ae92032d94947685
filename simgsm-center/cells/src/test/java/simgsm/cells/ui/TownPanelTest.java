package simgsm.cells.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics2D;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.accessibility.Accessible;
import javax.imageio.ImageIO;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JSpinner;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.cells.snapshot.MobileState;
import simgsm.cells.snapshot.PassingStep;
import simgsm.cells.town.TownPlace;
import simgsm.draw.Appearance;
import simgsm.ui.ComponentNames;
import simgsm.ui.Slider;
import simgsm.ui.Theme;

/** The town's window without a display: what it shows, and what mouse and keys do. */
class TownPanelTest {
    private SampleTown town;
    private TownPanel panel;

    @BeforeEach
    void buildTheVillage() throws Exception {
        Theme.install(Appearance.LIGHT);
        build("village", "en");
    }

    @AfterEach
    void asItWas() {
        Theme.install(Appearance.LIGHT);
        Theme.zoomTo(1);
    }

    private void build(String name, String language) throws IOException {
        town = new SampleTown(name);
        build(language);
    }

    private void build(String language) {
        panel = new TownPanel(
                TownWindow.texts(Locale.forLanguageTag(language)),
                town,
                town.snapshot(),
                town.propagation,
                Runnable::run,
                Runnable::run);
        paint(1100, 760);
    }

    private BufferedImage paint(int width, int height) {
        panel.setSize(width, height);
        layOut(panel);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 2; i++) {
            // the first time asks for the coverage
            Graphics2D g = image.createGraphics();
            panel.paint(g);
            g.dispose();
        }
        return image;
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }

    private <T> T find(String name, Class<T> type) {
        return type.cast(ComponentNames.find(panel, name).orElseThrow(() -> new AssertionError("no " + name)));
    }

    private String spoken(String name) {
        return find(name, Accessible.class).getAccessibleContext().getAccessibleName();
    }

    private void show() {
        panel.show(town.snapshot());
    }

    private void mouse(int id, TownPlace place, int modifiers) {
        TownMap map = find("map", TownMap.class);
        MapScale scale = MapScale.fitting(town.town, map.getWidth(), map.getHeight());
        map.dispatchEvent(new MouseEvent(
                map,
                id,
                0,
                modifiers | InputEvent.BUTTON1_DOWN_MASK,
                (int) Math.round(scale.x(place.xMetres())),
                (int) Math.round(scale.y(place.yMetres())),
                1,
                false,
                MouseEvent.BUTTON1));
        show();
    }

    private void key(int code, int modifiers) {
        JComponent map = find("map", JComponent.class);
        Object id = map.getInputMap(JComponent.WHEN_FOCUSED).get(KeyStroke.getKeyStroke(code, modifiers));
        map.getActionMap().get(id).actionPerformed(new ActionEvent(map, 0, ""));
        show();
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "es"})
    void everyControlHasANameAndEveryTextIsInTheBundle(String language) throws Exception {
        build("city", language);
        for (PassingStep.Kind kind : PassingStep.Kind.values()) {
            String words = PassingStrip.words(
                    TownWindow.texts(Locale.forLanguageTag(language)), new PassingStep(0, "1", kind, "A", "B", 7));
            assertFalse(words.contains("passing."), words);
        }
        assertEquals(List.of(), ComponentNames.unnamed(panel));
        List<String> keys = new ArrayList<>();
        texts(panel, keys);
        assertEquals(
                List.of(),
                keys.stream().filter(text -> text.matches("[a-z]+\\.[a-z.]+")).toList());
    }

    private static void texts(Container container, List<String> into) {
        for (Component child : container.getComponents()) {
            if (child instanceof JComponent component && component.getToolTipText() != null) {
                into.add(component.getToolTipText());
            }
            if (child instanceof AbstractButton button && button.getText() != null) {
                into.add(button.getText());
            }
            if (child instanceof JLabel label && label.getText() != null) {
                into.add(label.getText());
            }
            if (child instanceof Accessible accessible && accessible.getAccessibleContext() != null) {
                String name = accessible.getAccessibleContext().getAccessibleName();
                into.add(name == null ? "" : name);
            }
            if (child instanceof Container inner) {
                texts(inner, into);
            }
        }
    }

    @Test
    void theHeaderNamesTownPortAndController() {
        assertEquals("The village", find("town", JLabel.class).getText());
        assertEquals("port 3013", find("port", JLabel.class).getText());
        assertEquals("Controller: M3 127.0.0.1:3003", spoken("controller"));
    }

    @Test
    void theChosenMobileIsShownWithItsCellLevelsAndTheCountToTheDecision() {
        assertEquals("5550100", find("mobiles", JComboBox.class).getSelectedItem());
        assertEquals("State of the mobile: connected, in a call, ciphered", spoken("mobile.state"));
        assertEquals(
                "RXQUAL 0   TA 1   link 16", find("mobile.radio", JLabel.class).getText());
        assertEquals("decision in 2 reports, margin 3 dB", spoken("decision"));
        assertEquals("speech gap 60 ms", find("mobile.gap", JLabel.class).getText());
        assertTrue(spoken("levels").matches("west -\\d+ dBm, east -\\d+ dBm"), spoken("levels"));
    }

    @Test
    void anIdleMobileShowsC2AndNoDecision() {
        find("mobiles", JComboBox.class).setSelectedItem(SampleTown.ROBOT);

        assertEquals("State of the mobile: idle", spoken("mobile.state"));
        assertEquals("camped on west", find("mobile.radio", JLabel.class).getText());
        assertEquals("no decision in idle mode", spoken("decision"));
        assertTrue(spoken("levels").matches("west -\\d+ dBm C2 \\d+, .*"), spoken("levels"));
    }

    @Test
    void withoutMobilesThePanelSaysSo() {
        town.removeMobiles();
        show();

        assertEquals("State of the mobile: no mobile", spoken("mobile.state"));
        assertEquals("No cell is received.", spoken("levels"));
        assertFalse(find("walk", AbstractButton.class).isEnabled());
        paint(1100, 760);
    }

    @Test
    void aMobileIsDraggedAndStaysWithinTheTown() {
        mouse(MouseEvent.MOUSE_PRESSED, new TownPlace(1_000, -150), 0);
        mouse(MouseEvent.MOUSE_DRAGGED, new TownPlace(2_000, 500), 0);
        mouse(MouseEvent.MOUSE_DRAGGED, new TownPlace(2_000, 9_000), 0);
        mouse(MouseEvent.MOUSE_RELEASED, new TownPlace(2_000, 9_000), 0);

        assertEquals(2, town.acts.size());
        assertTrue(town.acts.get(0).matches("place 5550200 (199|200)\\d (49|50)\\d"), town.acts.toString());
        assertTrue(town.acts.get(1).endsWith(" 1500"), town.acts.toString());
        assertEquals("5550200", find("mobiles", JComboBox.class).getSelectedItem());
    }

    @Test
    void aClickOnATowerSwitchesIt() {
        mouse(MouseEvent.MOUSE_PRESSED, new TownPlace(4_000, 30), 0);
        mouse(MouseEvent.MOUSE_RELEASED, new TownPlace(4_000, 30), 0);
        mouse(MouseEvent.MOUSE_PRESSED, new TownPlace(4_000, 30), 0);

        assertEquals(List.of("east off", "east on"), town.acts);
    }

    @Test
    void withShiftAPathIsDrawnForTheChosenMobile() {
        find("speed", JSpinner.class).setValue(4.0);
        int shift = InputEvent.SHIFT_DOWN_MASK;
        mouse(MouseEvent.MOUSE_PRESSED, new TownPlace(600, 100), shift);
        for (int x = 700; x <= 3_000; x += 100) {
            mouse(MouseEvent.MOUSE_DRAGGED, new TownPlace(x, 0), shift);
        }
        mouse(MouseEvent.MOUSE_RELEASED, new TownPlace(3_000, 0), shift);

        assertEquals(1, town.acts.size());
        assertTrue(town.acts.get(0).matches("walk 5550100 \\d\\d at 4.0"), town.acts.toString());
        assertTrue(find("stand", AbstractButton.class).isEnabled());
    }

    @Test
    void theArrowKeysMoveTheChosenMobile() {
        key(KeyEvent.VK_RIGHT, 0);
        key(KeyEvent.VK_UP, InputEvent.SHIFT_DOWN_MASK);

        // a fiftieth and a five hundredth of 6 km
        assertEquals(List.of("place 5550100 720 100", "place 5550100 720 112"), town.acts);
    }

    @Test
    void theLowestNumberIsShownUntilTheUserChoosesAnother() {
        town.removeMobiles();
        town.connect(SampleTown.ROBOT);
        show();
        town.connect(SampleTown.PHONE);
        show();
        assertEquals(SampleTown.PHONE, find("mobiles", JComboBox.class).getSelectedItem());
        find("mobiles", JComboBox.class).setSelectedItem(SampleTown.ROBOT);
        show();
        assertEquals(SampleTown.ROBOT, find("mobiles", JComboBox.class).getSelectedItem());
    }

    @Test
    void walksOfTheTownStartAndStop() {
        find("walk", AbstractButton.class).doClick();
        show();
        find("stand", AbstractButton.class).doClick();
        show();

        assertEquals(List.of("walk 5550100 2 at 15.0", "stand 5550100"), town.acts);
        assertFalse(find("stand", AbstractButton.class).isEnabled());
    }

    @Test
    void towersAreSwitchedByTheirBoxAndTheirPowerIsSetByTheirFader() {
        find("tower.west", AbstractButton.class).doClick();
        find("power.east", Slider.class).setValue(20);
        find("pause", AbstractButton.class).doClick();
        show();

        assertEquals(List.of("west off", "east 20.0", "pause"), town.acts);
        assertFalse(find("tower.west", AbstractButton.class).isSelected());
        assertEquals("20 dBm", find("dbm.east", JLabel.class).getText());
        assertTrue(find("pause", AbstractButton.class).isSelected());
    }

    @Test
    void aTowersPowerAndSwitchChangeTheCoverage() {
        int before = hash(paint(1100, 760));
        town.switchTower("west", false);
        show();
        int off = hash(paint(1100, 760));
        assertNotEquals(before, off);

        find("layer.levels", AbstractButton.class).doClick();
        assertNotEquals(off, hash(paint(1100, 760)));
    }

    private static int hash(BufferedImage image) {
        return Arrays.hashCode(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()));
    }

    @Test
    void theStripTellsAHandoverInItsSteps() {
        assertEquals("Nothing has passed yet.", spoken("strip"));
        handover();

        assertEquals("gap 60 ms", spoken("strip"));
        assertEquals(
                List.of(
                        "report 16",
                        "report 17",
                        "Handover Command east",
                        "access east",
                        "Physical Information TA 3",
                        "complete east",
                        "gap 60 ms"),
                town.passing.stream()
                        .map(step -> PassingStrip.words(TownWindow.texts(Locale.ENGLISH), step))
                        .toList());
    }

    @Test
    void aRunOfReportsIsOneBoxAndItsLastThree() {
        for (int report = 4; report <= 17; report++) {
            town.pass(PassingStep.Kind.REPORT, report);
        }
        town.pass(PassingStep.Kind.HANDOVER_COMMAND, 0);
        town.pass(PassingStep.Kind.REPORT, 0);
        show();

        assertEquals(
                List.of("reports 4 to 14", "report 15", "report 16", "report 17", "Handover Command east", "report 0"),
                find("strip", PassingStrip.class).words());
    }

    private void handover() {
        town.pass(PassingStep.Kind.REPORT, 16);
        town.pass(PassingStep.Kind.REPORT, 17);
        town.pass(PassingStep.Kind.HANDOVER_COMMAND, 0);
        town.pass(PassingStep.Kind.HANDOVER_ACCESS, 0);
        town.pass(PassingStep.Kind.PHYSICAL_INFORMATION, 3);
        town.pass(PassingStep.Kind.HANDOVER_COMPLETE, 0);
        town.pass(PassingStep.Kind.SPEECH_GAP, 60);
        show();
    }

    @ParameterizedTest
    @EnumSource(MobileState.State.class)
    void everyStateOfAMobileHasAMarkOfItsOwn(MobileState.State state) {
        assertEquals(
                1,
                Arrays.stream(MobileState.State.values())
                        .filter(other -> TownPicture.markOf(other) == TownPicture.markOf(state))
                        .count());
    }

    @ParameterizedTest
    @CsvSource({
        "760, 420, 1, LIGHT",
        "1280, 720, 1, DARK",
        "1920, 1080, 1, CONTRAST",
        "1520, 840, 2, DARK",
        "3840, 2160, 2, LIGHT"
    })
    void atEverySizeTheMapIsVisibleAndNothingOfTheWindowLiesOutside(
            int width, int height, double zoom, Appearance appearance) throws Exception {
        Theme.zoomTo(zoom);
        Theme.install(appearance);
        build("city", "es");
        handover();
        BufferedImage image = paint(width, height);
        Component map = find("map", Component.class);
        assertTrue(
                map.getWidth() >= 250 * zoom && map.getHeight() >= 180 * zoom,
                map.getBounds().toString());
        assertTrue(find("strip", Component.class).getHeight() >= 24 * zoom);
        keep(image, width + "x" + height + "@" + zoom + "-" + appearance);
    }

    /** With {@code -Dpictures=DIR} the pictures are kept for a look at them. */
    private static void keep(BufferedImage image, String name) throws IOException {
        Optional<String> directory = Optional.ofNullable(System.getProperty("pictures"));
        if (directory.isPresent()) {
            ImageIO.write(image, "png", new File(directory.get(), "town-" + name + ".png"));
        }
    }

    @Test
    void theHistoryHasTheChangesOfCellOfTheLastMinuteAndNoneOfAnotherMobile() {
        assertEquals("No change of cell in the last 60 s", spoken("levels.history"));
        town.pass(PassingStep.Kind.HANDOVER_COMMAND, 0);
        town.pass(PassingStep.Kind.REPORT, 1);
        show();
        assertEquals("One change of cell in the last 60 s", spoken("levels.history"));
        town.nanos = 61_000_000_000L;
        town.place(SampleTown.PHONE, new TownPlace(10, 10));
        show();
        assertEquals("No change of cell in the last 60 s", spoken("levels.history"));
        town.pass(PassingStep.Kind.RESELECTION, 0);
        find("mobiles", JComboBox.class).setSelectedItem(SampleTown.ROBOT);
        assertEquals("No change of cell in the last 60 s", spoken("levels.history"));
    }
}
