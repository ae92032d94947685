package simgsm.ui.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.ComponentNames;
import simgsm.ui.DesktopTexts;
import simgsm.ui.Theme;

class SettingsPanelTest {
    private final List<String> done = new ArrayList<>();

    @BeforeEach
    void theme() {
        Theme.install(Appearance.LIGHT, 1);
    }

    @Test
    void languageColoursAndSizeAreChosen() throws Exception {
        SettingsPanel panel = panel(true);
        choose(panel, "settings.language", 1);
        choose(panel, "settings.theme", 2);
        choose(panel, "settings.zoom", 2);
        assertEquals(List.of("es", "CONTRAST", "125"), done);
    }

    @Test
    void theHelpClosesBeforeAnotherLanguageIsShown() {
        SettingsPanel.Actions actions = actions(true).beforeLanguage(() -> done.add("closed"));
        actions.language().orElseThrow().accept(Locale.forLanguageTag("es"));
        assertEquals(List.of("closed", "es"), done);
    }

    @Test
    void aProgramWithASettingOfItsOwnOffersNoLanguage() {
        SettingsPanel panel = panel(false);
        assertTrue(ComponentNames.find(panel, "settings.language").isEmpty());
        assertTrue(ComponentNames.find(panel, "settings.language.own").isPresent());
        assertTrue(ComponentNames.find(panel, "settings.fresh").isPresent());
    }

    @Test
    void theGroundFollowsTheColours() {
        SettingsPanel panel = panel(true);
        Theme.install(Appearance.DARK);
        Theme.refresh(panel);
        assertEquals(Theme.color(Ink.SURFACE), panel.getBackground());
        Theme.install(Appearance.LIGHT);
    }

    @Test
    void theBoxesShowAZoomAndColoursChosenByKeys() throws Exception {
        SettingsPanel panel = panel(true);
        Theme.install(Appearance.DARK, 1.1);
        Theme.refresh(panel);
        SwingUtilities.invokeAndWait(() -> {});
        assertEquals("110 %", box(panel, "settings.zoom").getSelectedItem());
        assertEquals(Appearance.DARK.ordinal(), box(panel, "settings.theme").getSelectedIndex());
        assertEquals(List.of(), done);
        Theme.install(Appearance.LIGHT, 1);
    }

    private static JComboBox<?> box(SettingsPanel panel, String name) {
        return (JComboBox<?>) ComponentNames.find(panel, name).orElseThrow();
    }

    private static void choose(SettingsPanel panel, String name, int index) throws Exception {
        box(panel, name).setSelectedIndex(index);
        SwingUtilities.invokeAndWait(() -> {});
    }

    private SettingsPanel panel(boolean speaks) {
        return new SettingsPanel(Locale.ENGLISH, DesktopTexts.in(Locale.ENGLISH), actions(speaks));
    }

    private SettingsPanel.Actions actions(boolean speaks) {
        return new SettingsPanel.Actions(
                speaks ? Optional.of(chosen -> done.add(chosen.getLanguage())) : Optional.empty(),
                chosen -> done.add(chosen.name()),
                chosen -> done.add(chosen.toString()),
                Optional.empty());
    }
}
