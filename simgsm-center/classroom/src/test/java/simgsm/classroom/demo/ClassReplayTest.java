package simgsm.classroom.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Locale;
import javax.swing.JComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;
import simgsm.ui.Theme;

/** A class's recording is shown as the teacher's windows are. */
class ClassReplayTest {
    private static final Locale LOCALE = JComponent.getDefaultLocale();

    @AfterEach
    void light() {
        Theme.install(Appearance.LIGHT);
        Theme.zoomTo(1);
        JComponent.setDefaultLocale(LOCALE);
    }

    @Test
    void theReplayHasLanguageZoomAndColoursOfTheTeachersWindows() {
        Theme.install(Appearance.DARK);
        Theme.zoomTo(1.2);
        JComponent.setDefaultLocale(new Locale("es"));
        assertEquals(
                List.of(
                        "--replay",
                        "class.rec",
                        "--replay-from",
                        "7",
                        "--end-with-input",
                        "--lang",
                        "es",
                        "--zoom",
                        "120",
                        "--theme",
                        "dark"),
                ClassWindow.replayOptions("class.rec", 7));
    }
}
