package simgsm.phone.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Clock;
import java.time.ZoneOffset;
import java.util.Locale;
import java.util.ResourceBundle;
import javax.swing.AbstractButton;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.phone.handset.Bench;
import simgsm.phone.screen.PhoneKey;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/** Language and colours change while the phone is on. */
class HandsetViewTest {
    private final Bench bench = new Bench();
    private HandsetView view;

    @BeforeEach
    void show() {
        Theme.zoomTo(1);
        Theme.install(Appearance.LIGHT);
        Clock clock = Clock.fixed(Bench.NOON, ZoneOffset.UTC);
        view = new HandsetView(
                HandsetViewTest::texts, clock, bench.snapshot(), act -> act.accept(bench.handset, bench.nowNanos));
    }

    @AfterEach
    void light() {
        Theme.install(Appearance.LIGHT);
    }

    private static TextBundle texts(Locale language) {
        return new TextBundle(
                ResourceBundle.getBundle("simgsm.phone.messages", TextBundle.bundleLocale(language)), Locale.ROOT);
    }

    private String spoken(String name) {
        return ComponentNames.find(view, name)
                .orElseThrow()
                .getAccessibleContext()
                .getAccessibleName();
    }

    @Test
    void theDisplaySpeaksSpanishAtOnceAndTheScopeStaysOpen() {
        ((AbstractButton) ComponentNames.find(view, "scope.switch").orElseThrow()).doClick(0);
        bench.tap(PhoneKey.MENU);
        bench.key("512");
        view.show(bench.snapshot());
        assertEquals("Ajustes: Idioma, Espa\u00f1ol", spoken("lcd"));
        assertEquals("Colgar", spoken("key.end"));
        assertTrue(ComponentNames.find(view, "scope").orElseThrow().isVisible());
    }

    @Test
    void darkColoursAreSetInTheMenu() {
        bench.tap(PhoneKey.MENU);
        bench.key("542");
        view.show(bench.snapshot());
        assertEquals(Appearance.DARK, Theme.appearance());
    }

    @Test
    void theSettingFollowsTheWindowsOwnChange() {
        Theme.install(Appearance.DARK);
        view.lookAtClock();
        assertEquals(Appearance.DARK, bench.snapshot().settings().appearance());
    }
}
