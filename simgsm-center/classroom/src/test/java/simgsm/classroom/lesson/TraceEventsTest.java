package simgsm.classroom.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.center.msc.ExchangeSnapshot;
import simgsm.center.msc.LadderEntry;
import simgsm.octets.OctetString;

class TraceEventsTest {
    private static final String ADDRESS = "127.0.0.1:41862";
    private static final Instant START = Instant.parse("2026-11-28T12:00:00Z");

    private final List<String> told = new ArrayList<>();
    private final TraceEvents events = new TraceEvents(
            event -> told.add(event.fields().get("from") + " " + event.fields().get("name")));

    private static LadderEntry up(String from, String name) {
        return new LadderEntry(START, from, LadderEntry.CENTER, name, OctetString.of(new byte[2]));
    }

    private static LadderEntry down(String to, String name) {
        return new LadderEntry(START, LadderEntry.CENTER, to, name, OctetString.of(new byte[2]));
    }

    private void show(int secondsLater, LadderEntry... ladder) {
        events.accept(new ExchangeSnapshot(
                START.plusSeconds(secondsLater),
                1,
                0,
                0,
                0,
                List.of(),
                List.of(),
                List.of(),
                List.of(ladder),
                ladder.length,
                Optional.empty(),
                List.of(),
                List.of()));
    }

    @Test
    void theMessagesOfARegistrationHaveItsNumberWheneverTheLadderIsSeen() {
        show(0, up("5550200", "CP-ACK"), up(ADDRESS, "Authentication Response"));
        assertEquals(List.of("5550200 CP-ACK"), told);

        show(
                0,
                up("5550200", "CP-ACK"),
                up("5550100", "Authentication Response"),
                down("5550100", "Location Updating Accept"));
        assertEquals(List.of("5550200 CP-ACK", "5550100 Authentication Response", "M3 Location Updating Accept"), told);
    }

    @Test
    void aRefusedTerminalHasItsAddressAtTheReleaseOfItsChannel() {
        show(0, up(ADDRESS, "Location Updating Request"), down(ADDRESS, "Location Updating Reject"));
        assertEquals(List.of(), told);

        show(
                0,
                up(ADDRESS, "Location Updating Request"),
                down(ADDRESS, "Location Updating Reject"),
                down(ADDRESS, "Channel Release"));
        assertEquals(
                List.of(ADDRESS + " Location Updating Request", "M3 Location Updating Reject", "M3 Channel Release"),
                told);
    }

    @Test
    void aTerminalThatFallsSilentHoldsTheEventsFor3Seconds() {
        show(2, up(ADDRESS, "Location Updating Request"));
        assertEquals(List.of(), told);

        show(3, up(ADDRESS, "Location Updating Request"));
        assertEquals(List.of(ADDRESS + " Location Updating Request"), told);
    }
}
