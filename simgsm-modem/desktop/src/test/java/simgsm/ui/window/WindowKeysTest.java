package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import simgsm.ui.UserAction;
import simgsm.ui.window.WindowKeys.Unzoomed;

class WindowKeysTest {
    @Test
    void aWindowBesideTheMainOneHasTheColoursAndTheHelp() {
        JRootPane beside = new JRootPane();
        WindowKeys.installBeside(beside, Locale.ENGLISH);
        InputMap keys = beside.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW);
        assertNotNull(keys.get(KeyStroke.getKeyStroke(KeyEvent.VK_L, InputEvent.CTRL_DOWN_MASK)));
        assertNotNull(keys.get(KeyStroke.getKeyStroke(KeyEvent.VK_F1, 0)));

        List<String> opened = new ArrayList<>();
        JRootPane main = new JRootPane();
        new UserAction("window.help", "Help", () -> opened.add("help")).bindInWindow(main);
        WindowKeys.openHelp(Stream.of(null, beside, main).map(JRootPane.class::cast));
        assertEquals(List.of("help"), opened);
    }

    @Test
    void aZoomLimitedByTheScreenIsUndone() {
        Rectangle first = new Rectangle(340, 20, 900, 700);
        Rectangle limited = new Rectangle(120, 20, 1800, 1000);
        Unzoomed large = Unzoomed.of(first, 1, Optional.empty());
        assertEquals(new Rectangle(340, 20, 1800, 1400), large.at(2));
        assertEquals(
                first,
                Unzoomed.of(limited, 2, Optional.of(large.shown(limited))).at(1));
    }

    @Test
    void boundsChosenByTheUserAreKept() {
        Rectangle shown = new Rectangle(0, 0, 1800, 1000);
        Unzoomed last = new Unzoomed(new Point(340, 20), 900, 700, shown);
        assertEquals(
                new Rectangle(340, 20, 500, 300),
                Unzoomed.of(new Rectangle(0, 0, 1000, 600), 2, Optional.of(last))
                        .at(1));
        assertEquals(
                new Rectangle(50, 60, 900, 700),
                Unzoomed.of(new Rectangle(50, 60, 1800, 1000), 2, Optional.of(last))
                        .at(1));
    }
}
