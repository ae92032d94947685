package simgsm.center.ui.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.event.ListDataEvent;
import javax.swing.event.ListDataListener;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.air.Msisdn;
import simgsm.center.msc.LadderEntry;
import simgsm.center.ui.Scene;

class LadderModelTest {
    private final LadderModel model = new LadderModel();
    private final List<String> events = new ArrayList<>();

    LadderModelTest() {
        model.addListDataListener(new ListDataListener() {
            @Override
            public void intervalAdded(ListDataEvent event) {
                events.add("+" + event.getIndex0() + ".." + event.getIndex1());
            }

            @Override
            public void intervalRemoved(ListDataEvent event) {
                events.add("-" + event.getIndex0() + ".." + event.getIndex1());
            }

            @Override
            public void contentsChanged(ListDataEvent event) {
                events.add("~" + event.getIndex0() + ".." + event.getIndex1());
            }
        });
    }

    @Test
    void onlyWhatIsNewIsAdded() {
        model.update(entries(1, 3), 3);
        model.update(entries(1, 3), 3);
        model.update(entries(1, 5), 5);

        assertEquals(List.of("+0..2", "+3..4"), events);
        assertEquals(List.of("1", "2", "3", "4", "5"), shown());
    }

    @Test
    void inColumnsEmptyElementsGoBeforeTheFirstSoThatTheLastColumnIsFull() {
        model.arrange(2, 3);
        model.update(entries(1, 6), 6);
        assertEquals(0, model.firstIndex());
        model.update(entries(1, 7), 7);
        assertEquals(2, model.firstIndex());
        assertEquals(List.of("+0..5", "+6..6", "+0..1"), events);
        model.update(entries(1, 8), 8);
        assertEquals(List.of("+9..9", "-0..0"), events.subList(3, 5));
        assertEquals(9, model.getSize());
        assertNull(model.getElementAt(0));
        assertEquals(1, model.getElementAt(1).number());

        model.arrange(1, 3);
        assertEquals(List.of("1", "2", "3", "4", "5", "6", "7", "8"), shown());
    }

    @Test
    void whatTheExchangeHasForgottenIsDropped() {
        model.update(entries(1, 4), 4);
        model.update(entries(3, 6), 6);

        assertEquals(List.of("+0..3", "-0..1", "+2..3"), events);
        assertEquals(List.of("3", "4", "5", "6"), shown());
    }

    @Test
    void anExchangeThatBeginsAnewIsShownFromItsBeginning() {
        model.update(entries(1, 4), 4);
        model.clear();
        model.update(entries(1, 2), 2);

        assertEquals(List.of("1", "2"), shown());
    }

    @Test
    void aBurstMayReplaceAll() {
        model.update(entries(1, 3), 3);
        model.update(entries(8, 9), 9);

        assertEquals(List.of("8", "9"), shown());
    }

    @Test
    void aFilterShowsOneTerminalAndTakesNothingAway() {
        model.update(entries(1, 4), 4);
        model.filter(of("3"));
        assertEquals(List.of("3"), shown());

        model.update(entries(1, 5), 5);
        assertEquals(List.of("3"), shown());
        assertEquals(List.of("5", "4", "3", "2", "1"), model.terminals());

        model.filter(LadderFilter.ALL);
        assertEquals(List.of("1", "2", "3", "4", "5"), shown());
    }

    @Test
    void clearingHidesWhatHasPassed() {
        model.update(entries(1, 3), 3);
        model.clear();
        assertEquals(List.of(), shown());
        assertEquals(List.of(), model.terminals());

        model.update(entries(1, 4), 4);
        assertEquals(List.of("4"), shown());
        model.filter(of("1"));
        assertEquals(List.of(), shown());
    }

    @Test
    void aTerminalThatGetsItsNumberIsRenamedInPlace() {
        List<LadderEntry> before = new ArrayList<>(entries(1, 3));
        model.update(before, 3);
        LadderEntry old = before.get(1);
        before.set(1, new LadderEntry(old.time(), "5550100", old.to(), old.name(), old.octets()));
        model.update(before, 3);

        assertEquals(List.of("1", "5550100", "3"), shown());
        assertEquals(List.of("+0..2", "~1..1"), events);
    }

    @Test
    void aClearingIsTakenBack() {
        model.update(entries(1, 3), 3);
        model.clear();
        model.update(entries(1, 4), 4);
        assertTrue(model.isCleared());

        model.unclear();

        assertEquals(List.of("1", "2", "3", "4"), shown());
        assertFalse(model.isCleared());
    }

    @Test
    void onlyTheLastOfTwoClearingsIsTakenBack() {
        model.update(entries(1, 2), 2);
        model.clear();
        model.update(entries(1, 4), 4);
        model.clear();
        model.unclear();

        assertEquals(List.of("3", "4"), shown());
    }

    @Test
    void aPauseKeepsTheRowsAndCountsWhatPassesMeanwhile() {
        model.update(entries(1, 3), 3);
        model.pause(true);
        model.update(entries(3, 6), 6);
        assertEquals(List.of("1", "2", "3"), shown());
        assertEquals(3, model.heldBack());
        model.filter(of("2"));
        assertEquals(List.of("2"), shown());

        model.filter(LadderFilter.ALL);
        model.pause(false);
        assertEquals(List.of("3", "4", "5", "6"), shown());
        assertEquals(0, model.heldBack());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "SETUP; 1",
                "5550200; 3",
                "full rate; 1",
                "81 55 05 02; 2",
                "#*#90; 1",
                "attention; 1",
                "nothing; 0",
                "'  '; 6"
            })
    void aTextIsLookedForInNamesNumbersFieldsAndOctets(String text, int found) {
        model.update(Scene.everyKind(), 6);
        model.filter(new LadderFilter(Optional.empty(), Optional.empty(), text));

        assertEquals(found, model.getSize(), shown().toString());
    }

    @ParameterizedTest
    @CsvSource({
        "CALL_CONTROL, 3",
        "MOBILITY_MANAGEMENT, 1",
        "SHORT_MESSAGES, 1",
        "COMMON_CHANNEL, 1",
        "RADIO_RESOURCE, 0"
    })
    void aProtocolIsPickedOut(Protocol kind, int found) {
        model.update(Scene.everyKind(), 6);
        model.filter(new LadderFilter(Optional.empty(), Optional.of(kind), ""));

        assertEquals(found, model.getSize());
    }

    private static LadderFilter of(String terminal) {
        return new LadderFilter(Optional.of(terminal), Optional.empty(), "");
    }

    private List<String> shown() {
        return IntStream.range(0, model.getSize())
                .mapToObj(index -> model.getElementAt(index).terminal())
                .toList();
    }

    /** Messages whose senders bear their numbers. */
    private static List<LadderEntry> entries(int from, int to) {
        return IntStream.rangeClosed(from, to)
                .mapToObj(number -> Scene.alerting(new Msisdn(String.valueOf(number))))
                .toList();
    }
}
