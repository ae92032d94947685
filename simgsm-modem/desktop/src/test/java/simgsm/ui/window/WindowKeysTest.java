package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.awt.Dimension;
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
import simgsm.ui.window.WindowKeys.SizeAtOne;

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
        Dimension limited = new Dimension(1800, 1000);
        SizeAtOne large = SizeAtOne.of(new Dimension(900, 700), 1, Optional.empty());
        assertEquals(1400, large.height(2));
        SizeAtOne undone = SizeAtOne.of(limited, 2, Optional.of(large.shown(limited)));
        assertEquals(List.of(900, 700), List.of(undone.width(1), undone.height(1)));
    }

    @Test
    void aSizeChosenByTheUserIsZoomed() {
        SizeAtOne large = SizeAtOne.of(new Dimension(900, 700), 1, Optional.empty());
        SizeAtOne chosen = SizeAtOne.of(new Dimension(1000, 600), 2, Optional.of(large));
        assertEquals(List.of(500, 300), List.of(chosen.width(1), chosen.height(1)));
    }
}
