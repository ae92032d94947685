package blackbox.face;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import blackbox.SuiteTrace;
import blackbox.VirtualPhone;
import blackbox.VirtualSuite;
import blackbox.face.PaintedTexts.Painted;
import java.awt.geom.Rectangle2D;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.ResourceLock;
import simgsm.center.subscriber.HomeRegister;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.phone.handset.Handset;
import simgsm.phone.handset.HandsetKeys;
import simgsm.phone.handset.HandsetSnapshot;
import simgsm.phone.screen.PhoneKey;
import simgsm.phone.screen.Screen;
import simgsm.phone.store.MessageFolder;
import simgsm.phone.ui.HandsetPanel;
import simgsm.ui.ComponentNames;
import simgsm.ui.Theme;

/**
 * Every page of the phone that keys reach, found by walking through its menus, in both languages: each text stands whole on
 * the display, and none over another. A user's own words (names, messages) may be cut with a mark.
 */
@ResourceLock("the theme, which is one for the process")
class PhoneScreensTest {
    /** Keys from the home screen to a page, six at most. */
    private static final int DEEPEST = 6;

    private static final double TOUCH = 1;

    private static final Map<String, String> KEPT = Map.of(
            "name.0001", "5550200\tRobot",
            "name.0002", "+5550101\tAda",
            "call.0001", "MISSED\t5550101\t1700000000\t0",
            "call.0002", "RECEIVED\t5550200\t1700000000\t71",
            "call.0003", "DIALLED\t5550200\t1700000000\t5",
            "message.0001", "INBOX\t5550200\t1700000000\tfalse\tRECEIVED\t1\t3 Done.",
            "message.0002", "OUTBOX\t5550200\t1700000000\ttrue\tFAILED\t1\t** ### **",
            "message.0003", "DRAFTS\t5550200\t1700000000\ttrue\tDRAFT\t1\tlater",
            "message.0004", "BROADCASTS\t50\t1700000000\tfalse\tRECEIVED\t1\tstorm");

    private final VirtualSuite suite = new VirtualSuite(SuiteTrace.NONE, HomeRegister.OPEN, Optional.empty());
    private int nextNumber = 5551000;
    private final Map<String, HandsetPanel> panels = new HashMap<>();

    @AfterEach
    void lightAgain() {
        Theme.install(Appearance.LIGHT);
        Theme.zoomTo(1);
    }

    /** A phone of its own for each page, so that no page has been changed by another. */
    private Handset at(List<PhoneKey> path, boolean isInCall) {
        VirtualPhone phone = suite.phone(String.valueOf(nextNumber++));
        Handset handset = phone.handset();
        assertEquals(List.of(), handset.restore(KEPT));
        if (isInCall) {
            phone.dial(VirtualSuite.ROBOT);
            suite.seconds(0.1);
        }
        for (PhoneKey key : path) {
            new HandsetKeys(handset).keyDown(key, 0);
            new HandsetKeys(handset).keyUp(key, 0);
            suite.settle();
        }
        return handset;
    }

    /** The keys that lead on from a page. */
    private static List<PhoneKey> keysOn(Screen screen) {
        if (screen instanceof Screen.Listing list && list.numbered()) {
            List<PhoneKey> digits = new ArrayList<>();
            for (int i = 1; i <= list.rows().size(); i++) {
                digits.add(PhoneKey.ofSymbol((char) ('0' + i)).orElseThrow());
            }
            return digits;
        }
        if (screen instanceof Screen.Listing list && !list.rows().isEmpty()) {
            return List.of(PhoneKey.OK, PhoneKey.SOFT_LEFT, PhoneKey.DOWN);
        }
        if (screen instanceof Screen.Entry || screen instanceof Screen.Writing) {
            return List.of(PhoneKey.TWO, PhoneKey.SOFT_LEFT);
        }
        return screen instanceof Screen.HomeView
                ? List.of(PhoneKey.MENU, PhoneKey.SOFT_RIGHT, PhoneKey.CALL, PhoneKey.SOFT_LEFT)
                : List.of(PhoneKey.SOFT_LEFT);
    }

    private List<String> faults(Handset handset, String where) {
        List<String> faults = new ArrayList<>();
        for (String language : List.of("en", "es")) {
            handset.set(handset.snapshot().settings().withLanguage(language));
            for (Painted text : texts(handset.snapshot(), language)) {
                fault(text, handset.snapshot()).ifPresent(what -> faults.add(language + " " + where + ": " + what));
            }
            faults.addAll(covered(texts(handset.snapshot(), language), language + " " + where));
        }
        return faults;
    }

    private List<Painted> texts(HandsetSnapshot snapshot, String language) {
        HandsetPanel panel = panels.computeIfAbsent(language, code -> panel(snapshot, code));
        panel.show(snapshot);
        JComponent lcd = (JComponent) ComponentNames.find(panel, "lcd").orElseThrow();
        PaintedTexts graphics = new PaintedTexts(lcd.getWidth(), lcd.getHeight());
        lcd.print(graphics);
        return graphics.texts();
    }

    private static HandsetPanel panel(HandsetSnapshot snapshot, String language) {
        Locale locale = Locale.forLanguageTag(language);
        TextBundle texts = new TextBundle(
                ResourceBundle.getBundle("simgsm.phone.messages", TextBundle.bundleLocale(locale)), Locale.ROOT);
        HandsetPanel panel =
                new HandsetPanel(texts, locale, Clock.fixed(Instant.EPOCH, ZoneOffset.UTC), snapshot, action -> {});
        panel.setSize(panel.getPreferredSize());
        panel.doLayout();
        return panel;
    }

    private static Optional<String> fault(Painted text, HandsetSnapshot snapshot) {
        Rectangle2D box = text.box();
        Rectangle2D clip = text.clip();
        boolean isInside = box.getX() >= clip.getX()
                && box.getMaxX() <= clip.getMaxX()
                && box.getY() >= clip.getY()
                && box.getMaxY() <= clip.getMaxY();
        boolean isCut = text.text().endsWith("\u2026") && !isOfAMessage(text.text(), snapshot);
        return isCut || !isInside ? Optional.of('"' + text.text() + '"') : Optional.empty();
    }

    private static boolean isOfAMessage(String cut, HandsetSnapshot snapshot) {
        String begin = cut.substring(0, cut.length() - 1);
        return Stream.of(MessageFolder.values())
                .flatMap(folder -> snapshot.in(folder).stream())
                .anyMatch(message -> message.text().startsWith(begin));
    }

    private static List<String> covered(List<Painted> texts, String where) {
        List<String> faults = new ArrayList<>();
        for (int i = 0; i < texts.size(); i++) {
            for (int j = i + 1; j < texts.size(); j++) {
                Rectangle2D common =
                        texts.get(i).box().createIntersection(texts.get(j).box());
                if (common.getWidth() > TOUCH && common.getHeight() > TOUCH) {
                    faults.add(where + ": \"" + texts.get(i).text() + "\" over \""
                            + texts.get(j).text() + '"');
                }
            }
        }
        return faults;
    }

    /** What tells pages apart: their texts in one language. */
    private String look(HandsetSnapshot snapshot) {
        return texts(snapshot, "en").stream().map(Painted::text).collect(Collectors.joining("|"));
    }

    private Set<String> walk(boolean isInCall, Set<String> looks) {
        Set<String> faults = new TreeSet<>();
        Queue<List<PhoneKey>> paths = new ArrayDeque<>(List.of(List.of()));
        while (!paths.isEmpty()) {
            List<PhoneKey> path = paths.remove();
            Handset handset = at(path, isInCall);
            HandsetSnapshot snapshot = handset.snapshot();
            if (!looks.add(look(snapshot).replaceAll("555[1-9][0-9]{3}", "own"))) {
                continue;
            }
            faults.addAll(faults(handset, path.toString()));
            if (path.size() < DEEPEST && snapshot.station().powered()) {
                for (PhoneKey key : keysOn(snapshot.screen())) {
                    List<PhoneKey> next = new ArrayList<>(path);
                    next.add(key);
                    paths.add(next);
                }
            }
        }
        return faults;
    }

    @Test
    void everyPageThatKeysReachStandsWholeInBothLanguages() throws Exception {
        Set<String> faults = new TreeSet<>();
        Set<String> looks = new HashSet<>();
        SwingUtilities.invokeAndWait(() -> {
            Theme.install(Appearance.LIGHT);
            Theme.zoomTo(1);
            faults.addAll(walk(false, looks));
            faults.addAll(walk(true, looks));
        });
        System.out.println(looks.size() + " pages");
        assertEquals("", String.join("\n", faults));
        assertTrue(looks.size() > 80, looks.size() + " pages");
    }
}
