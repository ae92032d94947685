package simgsm.ui.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Locale;
import javax.accessibility.AccessibleRole;
import javax.accessibility.AccessibleValue;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import simgsm.ui.Theme;

class DividedPanelTest {
    private final JPanel list = new JPanel();
    private final JPanel detail = new JPanel();
    private final Divider divider = new Divider("divider", "Divider: the detail", Locale.ENGLISH, 50);
    private final DividedPanel panel = new DividedPanel(false, list, detail, divider, 80, room -> room / 4);

    @AfterEach
    void normalZoom() {
        Theme.zoomTo(1);
    }

    private void lay(int height) {
        panel.setSize(200, height);
        panel.doLayout();
    }

    private void press(int key) {
        press(key, 0);
    }

    private void press(int key, int modifiers) {
        Object bound = divider.getInputMap().get(KeyStroke.getKeyStroke(key, modifiers));
        divider.getActionMap().get(bound).actionPerformed(new ActionEvent(divider, 0, ""));
        panel.doLayout();
    }

    @Test
    void theSecondPartHasItsOwnShareUntilTheDividerIsMoved() {
        lay(408);
        assertEquals(100, detail.getHeight());
        lay(808);
        assertEquals(200, detail.getHeight());
        press(KeyEvent.VK_UP);
        assertEquals(216, detail.getHeight());
        lay(408);
        assertEquals(216, detail.getHeight());
        press(KeyEvent.VK_ENTER);
        assertEquals(100, detail.getHeight());
    }

    @Test
    void bothPartsKeepTheirLeastSizes() {
        lay(408);
        press(KeyEvent.VK_HOME);
        assertEquals(80, list.getHeight());
        press(KeyEvent.VK_END);
        assertEquals(50, detail.getHeight());
        lay(120);
        assertEquals(50, detail.getHeight());
        assertEquals(62, list.getHeight());
    }

    @Test
    void withoutTheSecondPartThereIsNoDivider() {
        panel.showSecond(false);
        lay(400);
        assertFalse(divider.isVisible());
        assertEquals(400, list.getHeight());
        panel.showSecond(true);
        lay(400);
        assertTrue(divider.isVisible());
        assertTrue(list.getHeight() < 400);
    }

    @Test
    void aMovedDividerFollowsTheZoom() {
        lay(408);
        press(KeyEvent.VK_UP);
        Theme.zoomTo(2);
        lay(816);
        assertEquals(232, detail.getHeight());
    }

    /** At zoom 2 a step of one pixel was half a unit, which rounding took back. */
    @Test
    void withShiftADividerMovesByOneUnitAtEveryZoom() {
        for (double zoom : new double[] {0.8, 1, 1.25, 1.5, 2, 3}) {
            Theme.zoomTo(zoom);
            divider.reset();
            lay(Theme.px(808));
            press(KeyEvent.VK_UP);
            AccessibleValue value = divider.getAccessibleContext().getAccessibleValue();
            int before = value.getCurrentAccessibleValue().intValue();
            press(KeyEvent.VK_DOWN, InputEvent.SHIFT_DOWN_MASK);
            assertEquals(before - 1, value.getCurrentAccessibleValue(), "zoom " + zoom);
            press(KeyEvent.VK_UP, InputEvent.SHIFT_DOWN_MASK);
            press(KeyEvent.VK_UP, InputEvent.SHIFT_DOWN_MASK);
            assertEquals(before + 1, value.getCurrentAccessibleValue(), "zoom " + zoom);
        }
    }

    @Test
    void assistiveTechnologyReadsNameAndSize() {
        lay(408);
        assertEquals("Divider: the detail", divider.getAccessibleContext().getAccessibleName());
        assertEquals(AccessibleRole.SEPARATOR, divider.getAccessibleContext().getAccessibleRole());
        AccessibleValue value = divider.getAccessibleContext().getAccessibleValue();
        assertEquals(100, value.getCurrentAccessibleValue());
        assertEquals(50, value.getMinimumAccessibleValue());
        assertEquals(320, value.getMaximumAccessibleValue());
        value.setCurrentAccessibleValue(150);
        panel.doLayout();
        assertEquals(150, detail.getHeight());
    }
}
