package simgsm.classroom.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/** The window of the link, without a display. */
class LinkFrameTest {
    @Test
    void aTickLetsNoMoreBrowsersInUntilItIsTakenAway() {
        Theme.install(Appearance.LIGHT);
        List<Boolean> told = new ArrayList<>();
        LinkFrame frame = new LinkFrame(Locale.ENGLISH, "http://10.0.0.1:8080/#1f", Optional.empty(), told::add);
        JPanel panel = frame.content(ClassroomTexts.in(Locale.ENGLISH));
        JCheckBox lock = (JCheckBox) ComponentNames.find(panel, "link.lock").orElseThrow();
        lock.doClick();
        lock.doClick();
        assertEquals(List.of(true, false), told);
        assertEquals(List.of(), ComponentNames.unnamed(panel));
    }

    @Test
    void theLinksLettersGrowWithTheWindow() {
        LinkFrame frame = new LinkFrame(Locale.ENGLISH, "http://10.0.0.1:8080/#1f", Optional.empty(), isLocked -> {});
        JPanel panel = frame.content(ClassroomTexts.in(Locale.ENGLISH));
        Component letters = ComponentNames.find(panel, "link.letters").orElseThrow();
        try {
            Theme.zoomTo(2);
            Theme.refresh(panel);
            assertEquals(2 * 21, letters.getFont().getSize2D());
        } finally {
            Theme.zoomTo(1);
        }
    }
}
