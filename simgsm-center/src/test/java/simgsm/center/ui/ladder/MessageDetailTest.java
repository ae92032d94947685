package simgsm.center.ui.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.ActionEvent;
import java.util.BitSet;
import java.util.Locale;
import java.util.ResourceBundle;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.center.ui.Scene;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

class MessageDetailTest {
    private MessageDetail detail;

    @BeforeEach
    void showASetup() {
        Theme.install(Appearance.LIGHT);
        detail = new MessageDetail(
                new TextBundle(ResourceBundle.getBundle("simgsm.center.app.messages", Locale.ROOT), Locale.ROOT));
        detail.show(new LadderRow(1, Scene.setup()));
        layOut(700, 200);
    }

    @Test
    void aChosenFieldMarksItsOctets() {
        fields().setRowSelectionInterval(2, 2);

        BitSet called = new BitSet();
        called.set(10, 17);
        assertEquals(called, dump().marked());
        assertEquals("Octets of the message, 17, called", spoken());
    }

    @Test
    void aChosenOctetChoosesItsFieldAndMarksAllOfIt() {
        dump().choose(13);

        assertEquals(2, fields().getSelectedRow());
        assertEquals(7, dump().marked().cardinality());
        assertEquals("octet 13, hexadecimal 55, called", spoken());
    }

    @Test
    void theArrowsGoFromOctetToOctetAndFromLineToLine() {
        press("RIGHT");
        assertTrue(spoken().startsWith("octet 0,"), spoken());
        press("DOWN");
        assertTrue(spoken().startsWith("octet 16,"), spoken());
        press("LEFT");
        assertTrue(spoken().startsWith("octet 15,"), spoken());
    }

    @ParameterizedTest
    @CsvSource({"460, 150", "540, 300", "700, 200", "250, 400", "1500, 500"})
    void aLineOfTheDumpIsNeverBroken(int width, int height) {
        layOut(width, height);

        assertTrue(HexDump.widthOf(4) <= dump().getWidth(), "dump " + dump().getWidth() + " of " + width);
        assertTrue(width < 460 || HexDump.widthOf(8) <= dump().getWidth(), "8 in a line of " + width);
        assertTrue(width < 700 || HexDump.widthOf(16) <= dump().getWidth(), "16 in a line of " + width);
    }

    @Test
    void aLongValueGoesOnBelowItsOwnBeginning() {
        layOut(460, 150);

        assertTrue(fields().getRowHeight(3) > fields().getRowHeight(0), "bearer capability");
    }

    private String spoken() {
        return dump().getAccessibleContext().getAccessibleName();
    }

    private void press(String key) {
        Object action = dump().getInputMap(JComponent.WHEN_FOCUSED).get(KeyStroke.getKeyStroke(key));
        dump().getActionMap().get(action).actionPerformed(new ActionEvent(dump(), 0, key));
    }

    private HexDump dump() {
        return (HexDump) ComponentNames.find(detail, "ladder.octets").orElseThrow();
    }

    private JTable fields() {
        return (JTable) ComponentNames.find(detail, "ladder.detail").orElseThrow();
    }

    private void layOut(int width, int height) {
        detail.setSize(width, height);
        layOut(detail);
        layOut(detail);
    }

    private static void layOut(Container container) {
        container.doLayout();
        for (Component child : container.getComponents()) {
            if (child instanceof Container inner) {
                layOut(inner);
            }
        }
    }
}
