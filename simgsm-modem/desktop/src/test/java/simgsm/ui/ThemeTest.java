package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.event.ActionEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JSpinner;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;

/** Colours that can be read, and an appearance and a zoom that take hold everywhere. */
class ThemeTest {
    @AfterEach
    void asItWas() {
        Theme.zoomTo(1);
        Theme.install(Appearance.LIGHT);
    }

    /** Relative luminance and contrast as WCAG 2.1 defines them. */
    private static double contrast(Ink one, Ink other, Appearance appearance) {
        double a = luminance(new Color(one.rgb(appearance))) + 0.05;
        double b = luminance(new Color(other.rgb(appearance))) + 0.05;
        return Math.max(a, b) / Math.min(a, b);
    }

    private static double luminance(Color color) {
        return 0.2126 * linear(color.getRed()) + 0.7152 * linear(color.getGreen()) + 0.0722 * linear(color.getBlue());
    }

    private static double linear(int component) {
        double share = component / 255.0;
        return share <= 0.03928 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }

    @ParameterizedTest
    @CsvSource({
        "TEXT, SURFACE",
        "TEXT, CARD",
        "TEXT, HOVER",
        "TEXT, PRESSED",
        "TEXT, ACCENT_WASH",
        "TEXT, BODY",
        "TEXT, KEY_FACE",
        "TEXT, DANGER_WASH",
        "TEXT, WARNING_WASH",
        "TEXT, GOOD_WASH",
        "TEXT, FLOOR",
        "QUIET, SURFACE",
        "QUIET, CARD",
        "QUIET, BODY",
        "QUIET, KEY_FACE",
        "QUIET, ACCENT_WASH",
        "QUIET, FLOOR",
        "ACCENT, SURFACE",
        "ACCENT, CARD",
        "ON_ACCENT, ACCENT",
        "GOOD, SURFACE",
        "GOOD, CARD",
        "WARNING, SURFACE",
        "WARNING, CARD",
        "DANGER, SURFACE",
        "DANGER, CARD",
        "ON_SIGNAL, GOOD",
        "ON_SIGNAL, DANGER",
        "ON_SIGNAL, WARNING",
        "ON_SIGNAL, ACCENT",
        "ON_SIGNAL, QUIET",
        "ON_FACE, CALL_FACE",
        "ON_FACE, END_FACE",
        "LCD_INK, LCD_PAPER",
        "LCD_QUIET, LCD_PAPER"
    })
    void textCanBeReadInEachAppearance(Ink ink, Ink ground) {
        for (Appearance appearance : Appearance.values()) {
            double contrast = contrast(ink, ground, appearance);
            boolean isHint = ink == Ink.LCD_QUIET;
            double least = appearance == Appearance.CONTRAST || isHint ? 7 : 4.5;
            assertTrue(contrast >= least, ink + " on " + ground + ", " + appearance + ": " + contrast);
        }
    }

    @ParameterizedTest
    @CsvSource({"CONTROL_LINE, CARD", "CONTROL_LINE, SURFACE", "WALL, FLOOR", "ROBOT, FLOOR"})
    void whatMustBeSeenStandsOut(Ink ink, Ink ground) {
        for (Appearance appearance : Appearance.values()) {
            assertTrue(contrast(ink, ground, appearance) >= 3, ink + " on " + ground + ", " + appearance);
        }
    }

    @ParameterizedTest
    @EnumSource(Appearance.class)
    void swingsOwnComponentsTakeOurColours(Appearance appearance) {
        Theme.install(appearance);
        assertEquals(
                0xFF000000 | Ink.CARD.rgb(appearance),
                UIManager.getColor("nimbusLightBackground").getRGB());
        assertEquals(
                0xFF000000 | Ink.TEXT.rgb(appearance),
                UIManager.getColor("text").getRGB());
    }

    @Test
    void aButtonIsPaintedFlat() {
        Theme.install(Appearance.LIGHT);
        JButton button = new JButton();
        button.setSize(80, 32);
        BufferedImage image = new BufferedImage(80, 32, BufferedImage.TYPE_INT_RGB);
        button.paint(image.getGraphics());
        assertEquals(Theme.color(Ink.CARD).getRGB(), image.getRGB(40, 8));
        assertEquals(Theme.color(Ink.CARD).getRGB(), image.getRGB(40, 24));
    }

    @Test
    void aSpinnersFieldHasALineAroundItOnACard() {
        Theme.install(Appearance.LIGHT);
        JSpinner spinner = new JSpinner();
        SwingUtilities.updateComponentTreeUI(spinner);
        JComponent field = ((JSpinner.DefaultEditor) spinner.getEditor()).getTextField();

        BufferedImage image = Painted.at(field, 60, 30, 1);

        assertTrue(Painted.count(image, Ink.CONTROL_LINE) > 100, "the line");
    }

    @Test
    void zoomGrowsFontsAndDistances() {
        Theme.zoomTo(2);
        assertEquals(16, Theme.px(8));
        assertEquals(26, Theme.base().getSize());
        assertEquals(26, UIManager.getFont("defaultFont").getSize());
    }

    @ParameterizedTest
    @CsvSource({"0.01, 0.5", "99, 3.0", "1.25, 1.25"})
    void zoomKeepsWithinItsBounds(double asked, double given) {
        Theme.zoomTo(asked);
        assertEquals(given, Theme.zoom());
    }

    @Test
    void aDistanceAboveNothingIsNeverNothing() {
        Theme.zoomTo(0.5);
        assertEquals(1, Theme.px(0.5));
        assertEquals(0, Theme.px(0));
    }

    @Test
    void theAppearanceIsRead() {
        assertEquals(Appearance.DARK, Appearance.parse("Dark"));
        assertEquals(Appearance.LIGHT, Appearance.parse("light"));
        assertThrows(IllegalArgumentException.class, () -> Appearance.parse("pink"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"TEXT", "SURFACE", "CARD", "ACCENT"})
    void lightAndDarkAreNotTheSame(Ink ink) {
        assertNotEquals(ink.rgb(Appearance.LIGHT), ink.rgb(Appearance.DARK));
    }

    @Test
    void anInkCanBeSeenThrough() {
        assertEquals(128, Theme.color(Ink.ACCENT, 0.5).getAlpha());
        assertEquals(
                Theme.color(Ink.ACCENT).getBlue(), Theme.color(Ink.ACCENT, 0.5).getBlue());
    }

    @Test
    void keysInAnOpenListChangeNothingUntilEnter() {
        Theme.install(Appearance.LIGHT);
        boolean[] open = {true};
        JComboBox<String> box = new JComboBox<>(new String[] {"none", "wander", "goto Behind"}) {
            @Override
            public boolean isPopupVisible() {
                return open[0];
            }
        };
        Action toEnd = SwingUtilities.getUIActionMap(box).get("endPassThrough");
        toEnd.actionPerformed(new ActionEvent(box, ActionEvent.ACTION_PERFORMED, ""));
        assertEquals("none", box.getSelectedItem());
        open[0] = false;
        toEnd.actionPerformed(new ActionEvent(box, ActionEvent.ACTION_PERFORMED, ""));
        assertEquals("goto Behind", box.getSelectedItem(), "a closed box shows what it takes");
    }

    @ParameterizedTest
    @EnumSource(Appearance.class)
    void menusCanBeRead(Appearance appearance) {
        Theme.install(appearance);
        for (String item : List.of("Menu", "MenuItem", "CheckBoxMenuItem", "RadioButtonMenuItem")) {
            assertEquals(Theme.color(Ink.TEXT), UIManager.getColor(item + "[Enabled].textForeground"), item);
            assertEquals(Theme.color(Ink.DISABLED), UIManager.getColor(item + "[Disabled].textForeground"), item);
        }
    }
}
