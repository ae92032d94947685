package simgsm.center.journal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.StoreEntry;
import simgsm.octets.OctetString;

/** What is recorded when the disk is full. */
class DiskReserveTest {
    private static final Instant NOW = Instant.parse("2026-11-21T12:00:00Z");
    private static final int RESERVE_OCTETS = 10_000;

    private final SimulatedDisk disk = new SimulatedDisk(new Random(1));

    private static StoreEntry accepted(long id) {
        return new StoreEntry.Accepted(new ShortMessage(
                id, new Msisdn("1"), new Msisdn("2"), OctetString.ofHex("00"), NOW, NOW.plusSeconds(3600)));
    }

    private static StoreEntry ended(long id) {
        return new StoreEntry.Ended(id, MessageState.DELIVERED, NOW, false);
    }

    private Journal opened() throws IOException {
        Journal journal = Journal.open(disk);
        journal.holdReserve(RESERVE_OCTETS);
        return journal;
    }

    private List<Long> waitingAfterAKill() throws IOException {
        disk.restart();
        return Journal.open(disk).stored().waiting().stream()
                .map(ShortMessage::id)
                .toList();
    }

    /** Accepts messages until the disk is full. @return the id of the first that is refused */
    private long filled(Journal journal) {
        disk.capacity = 20_000;
        long id = 1;
        while (journal.commit(List.of(accepted(id)))) {
            id++;
        }
        return id;
    }

    @Test
    void endsAreDurableOnAFullDiskAndNewMessagesAreRefused() throws IOException {
        Journal journal = opened();
        long refused = filled(journal);
        for (long id = 2; id < refused; id++) {
            assertTrue(journal.commit(List.of(ended(id))), "end of " + id);
            assertFalse(journal.commit(List.of(accepted(refused + id))));
        }

        assertTrue(journal.isFailing());
        assertEquals(List.of(1L), waitingAfterAKill());
    }

    @Test
    void anEndInAGroupWithARefusedMessageIsDurable() throws IOException {
        Journal journal = opened();
        long refused = filled(journal);

        assertFalse(journal.commit(List.of(accepted(refused), ended(1))));

        assertFalse(waitingAfterAKill().contains(1L));
    }

    @Test
    void aFullDiskIsNotSaidToTakeTheJournalAgainBecauseNothingIsWritten() throws IOException {
        Journal journal = opened();
        filled(journal);

        assertTrue(journal.commit(List.of()));

        assertTrue(journal.isFailing());
    }

    @Test
    void theUnusedRoomIsNoDamage() throws IOException {
        Journal journal = opened();
        filled(journal);
        journal.commit(List.of(ended(1)));
        JournalState state = new JournalState(20_000);

        Recovery recovery = new Recovery(disk, state);
        recovery.run(disk.names());

        assertFalse(recovery.report().isLossy());
        assertEquals(
                0,
                disk.names().stream().filter(name -> name.endsWith(".damaged")).count());
        assertTrue(disk.octets(FileNames.segment(2)).length < 200, "the rest is given back");
    }

    @Test
    void withRoomAgainMessagesAreAcceptedAndTheReserveIsWhole() throws IOException {
        Journal journal = opened();
        long refused = filled(journal);
        journal.commit(List.of(ended(1)));
        disk.capacity = 200_000;

        assertTrue(journal.commit(List.of(accepted(refused))));

        assertFalse(journal.isFailing());
        assertEquals(RESERVE_OCTETS, disk.octets(FileNames.reserve()).length);
        assertTrue(waitingAfterAKill().contains(refused));
    }

    @Test
    void aDiskWithRoomForAFewMessagesStaysClosedUntilTheReserveIsWhole() throws IOException {
        Journal journal = opened();
        long refused = filled(journal);
        journal.commit(List.of(ended(1)));
        disk.capacity += RESERVE_OCTETS - 1;

        assertFalse(journal.commit(List.of(accepted(refused))));
        assertTrue(journal.commit(List.of(ended(2))));
    }

    @Test
    void aDeathAtAnyStepLosesNeitherAMessageNorAnEnd() throws IOException {
        for (int step = 0; step < 60; step++) {
            SimulatedDisk dying = new SimulatedDisk(new Random(step));
            Journal journal = Journal.open(dying);
            journal.holdReserve(RESERVE_OCTETS);
            dying.capacity = 20_000;
            long accepted = 0;
            while (journal.commit(List.of(accepted(accepted + 1)))) {
                accepted++;
            }
            List<Long> waiting =
                    new ArrayList<>(LongStream.rangeClosed(1, accepted).boxed().toList());
            dying.dieAfter(step);
            long id = 1;
            try {
                for (; id <= accepted; id++) {
                    assertTrue(journal.commit(List.of(ended(id))));
                    waiting.remove(id);
                }
            } catch (SimulatedDisk.MachineDied death) {
                // As ordered.
            }
            dying.comeBack();
            List<Long> saved = Journal.open(dying).stored().waiting().stream()
                    .map(ShortMessage::id)
                    .toList();
            long underWay = id;
            assertEquals(
                    waiting.stream().filter(each -> each != underWay).toList(),
                    saved.stream().filter(each -> each != underWay).toList(),
                    "death at step " + step);
        }
    }
}
