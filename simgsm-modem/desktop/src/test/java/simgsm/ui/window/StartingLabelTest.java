package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.SwingUtilities;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Theme;

class StartingLabelTest {
    @ParameterizedTest
    @CsvSource({"en, SimRobot is starting ...", "es, SimRobot est\u00e1 arrancando ..."})
    void theWindowSaysThatItStartsAndThePanelFollowsTheFirstPaintingOnce(String language, String words)
            throws Exception {
        Theme.install(Appearance.LIGHT);
        AtomicInteger panels = new AtomicInteger();
        BufferedImage image = new BufferedImage(300, 200, BufferedImage.TYPE_INT_RGB);
        SwingUtilities.invokeAndWait(() -> {
            StartingLabel label =
                    new StartingLabel("SimRobot", Locale.forLanguageTag(language), panels::incrementAndGet);
            assertEquals(words, label.getAccessibleContext().getAccessibleName());
            label.setSize(300, 200);
            Graphics2D g = image.createGraphics();
            label.paint(g);
            label.paint(g);
            g.dispose();
        });
        SwingUtilities.invokeAndWait(() -> assertEquals(1, panels.get()));
        assertEquals(Theme.color(Ink.SURFACE).getRGB(), image.getRGB(2, 2));
    }
}
