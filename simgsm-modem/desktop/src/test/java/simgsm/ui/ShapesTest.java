package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;

/** Lamps, bars, keycaps, chips and symbols, painted without a display. */
class ShapesTest {
    @BeforeEach
    void light() {
        Theme.zoomTo(1);
        Theme.install(Appearance.LIGHT);
    }

    private static Lamp lamp(StatusMark mark, Ink ink, String word) {
        Lamp lamp = new Lamp("Status");
        lamp.show(mark, ink, word);
        return lamp;
    }

    @Test
    void everyMarkHasAShapeOfItsOwnEvenWithoutColour() {
        Set<Integer> pictures = new HashSet<>();
        for (StatusMark mark : StatusMark.values()) {
            pictures.add(Painted.hash(Painted.at(lamp(mark, Ink.TEXT, ""), 2)));
        }
        assertEquals(StatusMark.values().length, pictures.size());
    }

    @Test
    void everyLinkStateHasAMarkOfItsOwn() {
        Set<StatusMark> marks = new HashSet<>();
        for (LinkState state : LinkState.values()) {
            marks.add(state.mark());
        }
        assertEquals(LinkState.values().length, marks.size());
    }

    @Test
    void aLampTellsItsWordAndSaysWhenItChanges() {
        Lamp lamp = lamp(StatusMark.SQUARE, Ink.GOOD, "Stopped");
        StringBuilder heard = new StringBuilder();
        lamp.getAccessibleContext().addPropertyChangeListener(change -> heard.append(change.getNewValue()));
        lamp.show(StatusMark.ARROW, Ink.ACCENT, "Moving");
        assertEquals("Status: Moving", lamp.getAccessibleContext().getAccessibleName());
        assertEquals("Status: Moving", heard.toString());
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.1, 1.46, 2, 3})
    void aLampsWordFitsAtEveryZoom(double zoom) {
        Theme.zoomTo(zoom);
        Lamp lamp = lamp(StatusMark.DISC, Ink.GOOD, "Disconnected");
        int preferred = Painted.count(Painted.at(lamp, 1), Ink.TEXT);
        int roomy = Painted.count(Painted.at(lamp, lamp.getWidth() + 50, lamp.getHeight(), 1), Ink.TEXT);
        assertEquals(roomy, preferred);
    }

    @Test
    void aLampThatIsNotLitShowsNoColourOfItsOwn() {
        Lamp lamp = lamp(StatusMark.SQUARE, Ink.GOOD, "Stopped");
        assertTrue(Painted.count(Painted.at(lamp, 1), Ink.GOOD) > 50);
        lamp.setLit(false);
        assertEquals(0, Painted.count(Painted.at(lamp, 1), Ink.GOOD));
    }

    @Test
    void theLinkLampSpeaksBothLanguages() {
        assertEquals(
                "Link to the centre: searching",
                Lamp.ofLink(Locale.ENGLISH).getAccessibleContext().getAccessibleName());
        assertEquals(
                "Enlace con la central: buscando",
                Lamp.ofLink(Locale.forLanguageTag("es")).getAccessibleContext().getAccessibleName());
    }

    @Test
    void moreSignalIsMoreInk() {
        SignalBars bars = new SignalBars("Signal");
        int before = -1;
        for (int level = 0; level <= SignalBars.BARS; level++) {
            bars.show(level);
            int ink = Painted.count(Painted.at(bars, 1), Ink.TEXT);
            assertTrue(ink > before, "level " + level);
            before = ink;
        }
        assertEquals("Signal: 5/5", bars.getAccessibleContext().getAccessibleName());
        assertThrows(IllegalArgumentException.class, () -> bars.show(6));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.25, 1.5, 2})
    void barsHaveCrispEdgesAtEveryScale(double scale) {
        SignalBars bars = new SignalBars("Signal");
        bars.show(SignalBars.BARS);
        BufferedImage image = Painted.at(bars, scale);
        int inked = Painted.count(image, Ink.TEXT);
        int blank = Painted.count(image, Ink.CARD);
        assertEquals(image.getWidth() * image.getHeight(), inked + blank);
    }

    @Test
    void aFaultIsMarkedAtItsPlaceOnly() {
        Keycaps keys = new Keycaps("Keys");
        keys.show("**#**20**", 0);
        assertEquals(0, Painted.count(Painted.at(keys, 1), Ink.DANGER));
        keys.show("**#***", 6);
        BufferedImage image = Painted.at(keys, 1);
        assertTrue(Painted.count(image, Ink.DANGER) > 20);
        assertEquals(0, Painted.count(image.getSubimage(0, 0, 5 * 25 - 2, image.getHeight()), Ink.DANGER));
    }

    @Test
    void everyReplyToneHasAChip() {
        for (char tone = '1'; tone <= '8'; tone++) {
            NumberedLabel chip = new NumberedLabel(String.valueOf(tone), "word", NumberedLabel.inkOfTone(tone));
            assertTrue(Painted.count(Painted.at(chip, 1), NumberedLabel.inkOfTone(tone)) > 100);
            assertEquals(tone + " word", chip.getAccessibleContext().getAccessibleName());
        }
    }

    @ParameterizedTest
    @EnumSource(Symbol.class)
    void everySymbolIsDrawnWithinItsSquare(Symbol symbol) {
        int side = 64;
        int margin = 16;
        BufferedImage image = new BufferedImage(side + 2 * margin, side + 2 * margin, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = Drawing.on(image.createGraphics());
        g.setColor(Theme.color(Ink.TEXT));
        symbol.paint(g, margin + side / 2.0, margin + side / 2.0, side);
        g.dispose();
        int inside = 0;
        int outside = 0;
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                boolean in = x >= margin - 1 && x <= margin + side && y >= margin - 1 && y <= margin + side;
                boolean ink = image.getRGB(x, y) >>> 24 > 40;
                inside += in && ink ? 1 : 0;
                outside += !in && ink ? 1 : 0;
            }
        }
        assertTrue(inside > 60, symbol + " has " + inside + " points");
        assertEquals(0, outside, symbol.toString());
    }

    @Test
    void noTwoSymbolsLookAlike() {
        Set<Integer> pictures = new HashSet<>();
        for (Symbol symbol : Symbol.values()) {
            pictures.add(Painted.hash(Painted.at(new javax.swing.JLabel(symbol.icon(48)), 1)));
        }
        assertEquals(Symbol.values().length, pictures.size());
    }
}
