package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;

class StartErrorWindowTest {
    @Test
    void theErrorCanBeReadAndTheWindowClosed() {
        Theme.install(Appearance.LIGHT);
        List<String> closed = new ArrayList<>();
        JPanel content = StartErrorWindow.content(
                "simrobot",
                "nope.map: no such file",
                DesktopTexts.in(Locale.forLanguageTag("es")),
                () -> closed.add("closed"));
        JTextArea text = (JTextArea) ComponentNames.find(content, "failed.text").orElseThrow();
        assertEquals("nope.map: no such file", text.getText());
        assertEquals("simrobot no puede arrancar", text.getAccessibleContext().getAccessibleName());
        ((JButton) ComponentNames.find(content, "failed.close").orElseThrow()).doClick();
        assertEquals(List.of("closed"), closed);
    }
}
