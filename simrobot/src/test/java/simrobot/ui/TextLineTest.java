package simrobot.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Font;
import javax.swing.JToolTip;
import javax.swing.plaf.basic.BasicHTML;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;

class TextLineTest {
    private static final String REPLY = "3 Done: #**20. Stopped at 0.200 -1.450 m, heading 90.0.";
    private final Font face = Theme.small();

    @BeforeAll
    static void asInTheProgram() {
        Theme.install(Appearance.LIGHT);
    }

    @Test
    void theHeightIsThatOfTheRowsThatTheTextTakes() {
        TextLine line = new TextLine("line", Theme::small, Ink.TEXT).overTwoRows();
        line.show(REPLY);
        int row = line.getPreferredSize().height / 2;

        assertEquals(row, line.heightFor(Drawing.width(face, REPLY)));
        assertEquals(2 * row, line.heightFor(Drawing.width(face, REPLY) - 1));
        assertEquals(2 * row, line.heightFor(20));
    }

    @Test
    void twoRowsAreTwiceAsHigh() {
        int one = new TextLine("one", Theme::small, Ink.TEXT).getPreferredSize().height;

        assertEquals(
                2 * one,
                new TextLine("two", Theme::small, Ink.TEXT).overTwoRows().getPreferredSize().height);
        assertTrue(one > 0);
    }

    @Test
    void aTextFromOutsideIsNoMarkupInTheToolTip() {
        TextLine line = new TextLine("line", Theme::small, Ink.TEXT);
        line.show("<html><b>3 Done");
        JToolTip tip = line.createToolTip();
        tip.setTipText(line.getToolTipText());
        assertNull(tip.getClientProperty(BasicHTML.propertyKey));
    }
}
