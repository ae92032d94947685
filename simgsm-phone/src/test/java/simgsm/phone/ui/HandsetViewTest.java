package simgsm.phone.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Clock;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
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
    private static final Locale SPANISH = Locale.forLanguageTag("es");

    private final Bench bench = new Bench();
    private final List<Locale> spoken = new ArrayList<>();
    private HandsetView view;

    @BeforeEach
    void show() {
        Theme.zoomTo(1);
        Theme.install(Appearance.LIGHT);
        view = in(Locale.ENGLISH);
        view.show(bench.snapshot());
    }

    private HandsetView in(Locale language) {
        TextBundle texts = new TextBundle(
                ResourceBundle.getBundle("simgsm.phone.messages", TextBundle.bundleLocale(language)), Locale.ROOT);
        Clock clock = Clock.fixed(Bench.NOON, ZoneOffset.UTC);
        return new HandsetView(
                texts,
                language,
                clock,
                bench.snapshot(),
                act -> act.accept(bench.handset, bench.nowNanos),
                spoken::add);
    }

    @AfterEach
    void light() {
        Theme.install(Appearance.LIGHT);
    }

    private String name(String component) {
        return ComponentNames.find(view, component)
                .orElseThrow()
                .getAccessibleContext()
                .getAccessibleName();
    }

    @Test
    void aLanguageSetAtThePhoneIsTheWindowsToo() {
        bench.tap(PhoneKey.MENU);
        bench.key("512");
        view.show(bench.snapshot());
        view.show(bench.snapshot());
        assertEquals(List.of(SPANISH), spoken);
        view = in(SPANISH);
        view.show(bench.snapshot());
        assertEquals("Ajustes: Idioma, Espa\u00f1ol", name("lcd"));
        assertEquals("Colgar", name("key.end"));
        assertEquals(1, spoken.size());
    }

    @Test
    void aLanguageSetInTheWindowIsThePhonesToo() {
        view = in(SPANISH);
        view.show(bench.snapshot());
        assertEquals("es", bench.snapshot().settings().language());
        assertEquals(List.of(), spoken);
    }

    @Test
    void aSnapshotFromBeforeTheWindowsChangeDoesNotTurnItBack() {
        var before = bench.snapshot();
        view = in(SPANISH);
        view.show(before);
        assertEquals(List.of(), spoken);
    }

    @Test
    void coloursAreSetInTheMenu() {
        bench.tap(PhoneKey.MENU);
        bench.key("542");
        view.show(bench.snapshot());
        assertEquals(Appearance.DARK, Theme.appearance());
        bench.tap(PhoneKey.FOUR, PhoneKey.THREE);
        view.show(bench.snapshot());
        assertEquals(Appearance.CONTRAST, Theme.appearance());
    }

    @Test
    void theSettingFollowsTheWindowsOwnChange() {
        Theme.install(Appearance.DARK);
        view.lookAtClock();
        assertEquals(Appearance.DARK, bench.snapshot().settings().appearance());
    }
}
