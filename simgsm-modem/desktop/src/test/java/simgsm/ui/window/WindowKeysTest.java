package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.swing.InputMap;
import javax.swing.JComponent;
import javax.swing.JRootPane;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import simgsm.ui.UserAction;

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
}
