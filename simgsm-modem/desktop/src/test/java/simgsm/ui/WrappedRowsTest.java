package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;

class WrappedRowsTest {
    private static final String REPLY = "3 Done: #**20. Stopped at 0.200 -1.450 m, heading 90.0.";
    private final Font face = Theme.small();

    @Test
    void aTextThatFitsStaysInOneRow() {
        assertEquals(List.of(REPLY), Drawing.wrapped(face, REPLY, Drawing.width(face, REPLY), 3));
        assertEquals(List.of(), Drawing.wrapped(face, "", 100, 3));
    }

    @Test
    void aLongerTextBreaksBehindTheLastWordThatFits() {
        assertEquals(
                List.of("3 Done: #**20. Stopped at 0.200 -1.450 m, heading", "90.0."),
                Drawing.wrapped(face, REPLY, Drawing.width(face, REPLY) - 1.0, 3));
    }

    @Test
    void theLastRowIsCutWhereTheRowsDoNotSuffice() {
        List<String> rows = Drawing.wrapped(face, REPLY, Drawing.width(face, REPLY) / 3.0, 2);
        assertEquals(2, rows.size());
        assertTrue(rows.get(1).endsWith("\u2026"), rows.get(1));
    }

    @Test
    void aWordThatIsTooLongIsNotBroken() {
        assertEquals(
                "now",
                Drawing.wrapped(face, "Disconnected now", Drawing.width(face, "Disco"), 2)
                        .get(1));
    }

    @Test
    void aLampThatWrapsAsksForTheRowsOfItsWord() {
        Lamp lamp = new Lamp("Verdict").wrapping();
        lamp.show(StatusMark.TICK, Ink.TEXT, REPLY);
        int row = lamp.getPreferredSize().height;
        int width = lamp.getPreferredSize().width;
        assertEquals(row, lamp.heightFor(width));
        assertEquals(2 * row, lamp.heightFor(width - 10));
        assertEquals(REPLY, lamp.getToolTipText());
    }
}
