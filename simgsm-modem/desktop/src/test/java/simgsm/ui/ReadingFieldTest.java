package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Color;
import java.awt.image.BufferedImage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;

/** A text that is longer than its field has a mark at each edge beyond which it goes on. */
class ReadingFieldTest {
    private static final int WIDTH = 120;
    /** Text is darker, paper and border are lighter. */
    private static final int DARK = 100;

    private static final String BLANKS = " ".repeat(200);

    @BeforeEach
    void light() {
        Theme.zoomTo(1);
        Theme.install(Appearance.LIGHT);
    }

    /** At which edges something is painted, in a text of blanks. */
    private static String marks(String text, int caret) {
        ReadingField field = new ReadingField(8);
        field.setBorder(null);
        field.setText(text);
        field.setSize(WIDTH, 20);
        field.setCaretPosition(caret);
        field.setScrollOffset(caret == 0 ? 0 : field.getHorizontalVisibility().getMaximum() / 2);
        BufferedImage image = Painted.at(field, WIDTH, 20, 1);
        return (hasInk(image, 0) ? "<" : "") + (hasInk(image, WIDTH - 8) ? ">" : "");
    }

    private static boolean hasInk(BufferedImage image, int from) {
        for (int x = from; x < from + 8; x++) {
            for (int y = 4; y < 17; y++) {
                if (new Color(image.getRGB(x, y)).getGreen() < DARK) {
                    return true;
                }
            }
        }
        return false;
    }

    @Test
    void aTextThatFitsHasNone() {
        assertEquals("", marks("   ", 0));
    }

    @Test
    void aTextThatGoesOnIsMarkedBehind() {
        assertEquals(">", marks(BLANKS, 0));
    }

    @Test
    void inItsMiddleATextIsMarkedAtBothEdges() {
        assertEquals("<>", marks(BLANKS, 100));
    }
}
