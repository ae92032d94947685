package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Rectangle;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DisplayTest {
    /** On a screen of 1000 by 700 with a bar of 30 at its top. */
    @ParameterizedTest
    @CsvSource({
        // fits where it is
        "10, 40, 300, 400,  10, 40, 300, 400",
        // grows over the right and lower edge: moves
        "900, 500, 300, 400,  700, 300, 300, 400",
        // is larger than the room: is cut
        "50, 60, 2000, 900,  0, 30, 1000, 670",
        // has its title above the screen: moves down
        "10, 5, 300, 400,  10, 30, 300, 400",
        // stands to the left of the screen, as its user wished
        "-20, 30, 300, 400,  -20, 30, 300, 400",
    })
    void aWindowStaysWithinItsScreen(int x, int y, int w, int h, int atX, int atY, int width, int height) {
        assertEquals(
                new Rectangle(atX, atY, width, height),
                Display.within(new Rectangle(x, y, w, h), new Rectangle(0, 30, 1000, 670)));
    }
}
