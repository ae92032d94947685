package simgsm.center.journal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.center.smsc.EsmeOrigin;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.StoreEntry;
import simgsm.center.smsc.StoredState;
import simgsm.octets.OctetString;
import simgsm.sms.SmsAddress;

class JournalTest {
    private static final Instant NOW = Instant.parse("2026-11-21T12:00:00.123456789Z");
    private static final String FIRST_SEGMENT = FileNames.segment(1);

    private final SimulatedDisk disk = new SimulatedDisk(new Random(1));

    private static ShortMessage message(long id) {
        return new ShortMessage(
                id,
                new Msisdn("5550100"),
                new Msisdn("5550200"),
                OctetString.ofHex("31010c9194710000002000" + "00a705e8329bfd06"),
                NOW,
                NOW.plusSeconds(3600));
    }

    private static StoreEntry accepted(long id) {
        return new StoreEntry.Accepted(message(id));
    }

    private static StoreEntry ended(long id, boolean reportFollows) {
        return new StoreEntry.Ended(id, MessageState.DELIVERED, NOW, reportFollows);
    }

    private static List<Long> ids(StoredState restored) {
        return restored.waiting().stream().map(ShortMessage::id).toList();
    }

    private StoredState reopened() throws IOException {
        return Journal.open(disk).stored();
    }

    @Test
    void anEmptyDirectoryIsTheFirstLife() throws IOException {
        assertEquals(StoredState.EMPTY, reopened());
        assertTrue(disk.names().isEmpty());
    }

    @Test
    void everyKindOfEntryReadsBackAsItWasWritten() throws IOException {
        EsmeOrigin origin = new EsmeOrigin("shop", SmsAddress.ofLetters("Shop"), 0xf5, EsmeOrigin.Receipts.ON_FAILURE);
        ShortMessage ofApplication = new ShortMessage(
                2, new Msisdn("1"), new Msisdn("2"), OctetString.ofHex("00"), NOW, NOW, Optional.of(origin));
        EsmeOrigin scheduled = new EsmeOrigin(
                "shop",
                SmsAddress.ofLetters("Shop"),
                0,
                EsmeOrigin.Receipts.ALWAYS,
                new EsmeOrigin.Group(3, 250),
                Optional.of(NOW),
                "");
        EsmeOrigin typed = new EsmeOrigin(
                "shop",
                SmsAddress.ofLetters("Shop"),
                0,
                EsmeOrigin.Receipts.ALWAYS,
                EsmeOrigin.Group.SINGLE,
                Optional.empty(),
                "CMT");
        ShortMessage ofType = new ShortMessage(
                4, new Msisdn("1"), new Msisdn("2"), OctetString.ofHex("00"), NOW, NOW, Optional.of(typed));
        ShortMessage inGroup = new ShortMessage(
                3, new Msisdn("1"), new Msisdn("2"), OctetString.ofHex("00"), NOW, NOW, Optional.of(scheduled));
        for (StoreEntry entry : List.of(
                accepted(1),
                new StoreEntry.Accepted(ofApplication),
                new StoreEntry.Accepted(inGroup),
                new StoreEntry.Accepted(ofType),
                ended(1, true),
                new StoreEntry.Reported(1),
                new StoreEntry.Known(new Msisdn("5550100"), Imsi.ofOpenNumber(new Msisdn("5550100"))),
                new StoreEntry.Known(
                        new Msisdn("5550101"), Imsi.ofOpenNumber(new Msisdn("5550101")), "21=5550102,true;43=true"),
                new StoreEntry.Numbered(7))) {
            assertEquals(entry, EntryCodec.decode(EntryCodec.encode(entry), new SharedValues()));
        }
    }

    @Test
    void whatIsCommittedSurvivesACrashInOrderAndWithItsIds() throws IOException {
        Journal journal = Journal.open(disk);
        assertTrue(journal.commit(List.of(accepted(3), accepted(1), accepted(2))));
        assertTrue(journal.commit(List.of(ended(1, false), accepted(4))));
        disk.crash();
        StoredState restored = reopened();
        assertEquals(List.of(2L, 3L, 4L), ids(restored));
        assertEquals(message(2), restored.waiting().get(0));
        assertEquals(4, restored.lastId());
        assertEquals(4, restored.recent().size(), "the ended one may be sent again by mistake, too");
    }

    @Test
    void whatAnEarlierProcessLeftInTheCacheIsMadeDurableBeforeItCounts() throws IOException {
        for (int seed = 0; seed < 20; seed++) {
            SimulatedDisk other = new SimulatedDisk(new Random(seed));
            Journal killed = Journal.open(other);
            other.killAfter(5);
            assertThrows(SimulatedDisk.MachineDied.class, () -> killed.commit(List.of(accepted(1))));
            other.restart();
            assertEquals(List.of(1L), ids(Journal.open(other).stored()), "read from the cache");
            other.crash();
            assertEquals(List.of(1L), ids(Journal.open(other).stored()), "seed " + seed);
        }
    }

    @Test
    void aMessageIsKeptUntilItsReportIsDelivered() throws IOException {
        Journal journal = Journal.open(disk);
        journal.commit(List.of(accepted(1), ended(1, true)));
        StoredState restored = reopened();
        assertTrue(restored.waiting().isEmpty());
        assertEquals(
                List.of(new StoredState.Unreported(message(1), (StoreEntry.Ended) ended(1, true))),
                restored.unreported());
        journal.commit(List.of(new StoreEntry.Reported(1)));
        assertTrue(reopened().unreported().isEmpty());
    }

    @Test
    void aTornTailIsCutAtTheLastGoodRecordWhereverItIsTorn() throws IOException {
        Journal journal = Journal.open(disk);
        journal.commit(List.of(accepted(1)));
        int good = disk.octets(FIRST_SEGMENT).length;
        journal.commit(List.of(accepted(2)));
        byte[] whole = disk.octets(FIRST_SEGMENT);
        for (int length = good; length < whole.length; length++) {
            try (DiskFile file = disk.create(FIRST_SEGMENT)) {
                file.write(ByteBuffer.wrap(whole, 0, length), 0);
            }
            List<Damage> damages = new ArrayList<>();
            assertEquals(1, entriesOf(FIRST_SEGMENT, damages), "cut at " + length);
            assertEquals(length == good ? List.of() : List.of(new Damage(FIRST_SEGMENT, good, length, true)), damages);
            assertEquals(List.of(1L), ids(reopened()));
            assertEquals(good, disk.octets(FIRST_SEGMENT).length);
        }
    }

    private int entriesOf(String name, List<Damage> damages) throws IOException {
        int count = 0;
        try (DiskFile file = disk.open(name)) {
            RecordReader reader = new RecordReader(name, file, damages::add);
            for (byte[] record = reader.next(); record != null; record = reader.next()) {
                count += FileMark.decode(record).isEmpty() ? 1 : 0;
            }
        }
        return count;
    }

    @Test
    void aDamagedRecordInTheMiddleIsReportedByPositionAndTheRestSaved() throws IOException {
        Journal journal = Journal.open(disk);
        int[] ends = new int[4];
        for (int id = 1; id <= 3; id++) {
            journal.commit(List.of(accepted(id)));
            ends[id] = disk.octets(FIRST_SEGMENT).length;
        }
        byte[] whole = disk.octets(FIRST_SEGMENT);
        for (int position = ends[1]; position < ends[2]; position++) {
            disk.spoil(FIRST_SEGMENT, position);
            List<Damage> damages = new ArrayList<>();
            assertEquals(2, entriesOf(FIRST_SEGMENT, damages), "spoilt at " + position);
            assertEquals(List.of(new Damage(FIRST_SEGMENT, ends[1], ends[2], false)), damages);
            assertEquals(List.of(1L, 3L), ids(reopened()));
            disk.spoil(FIRST_SEGMENT, position);
        }
        assertArrayEquals(whole, disk.octets(FIRST_SEGMENT));
        assertEquals(
                "segment-0000000001: damaged from octet 10 to 19; the records around it are saved",
                new Damage(FIRST_SEGMENT, 10, 20, false).toString());
    }

    @Test
    void whatTheDiskDoesNotTakeIsRefusedAndForgottenAndWhatHasHappenedIsWrittenLater() throws IOException {
        Journal journal = Journal.open(disk);
        journal.commit(List.of(accepted(1)));
        disk.failureRate = 1;
        assertFalse(journal.commit(List.of(accepted(2))));
        assertFalse(journal.commit(List.of(ended(1, false))));
        assertTrue(journal.isFailing());
        disk.failureRate = 0;
        assertTrue(journal.commit(List.of()));
        assertFalse(journal.isFailing());
        assertTrue(ids(reopened()).isEmpty(), "neither the refused one nor the delivered one");
        assertTrue(journal.commit(List.of(accepted(3))));
        assertEquals(List.of(3L), ids(reopened()));
    }

    /** Accepts and delivers until a compaction has begun and ended. */
    private int trafficUntilCompacted(Journal journal) {
        int id = 10;
        boolean hasBegun = false;
        while (!hasBegun || journal.isCompacting()) {
            assertTrue(id < 1_000, "compaction begins and ends at some time");
            journal.commit(List.of(accepted(id), ended(id, false)));
            journal.compact();
            hasBegun |= journal.isCompacting();
            id++;
        }
        return id;
    }

    @Test
    void compactionKeepsWhatIsNeededAndGivesTheRoomBack() throws IOException {
        Journal journal = Journal.open(disk, new Journal.Limits(3_000, 3));
        journal.commit(List.of(
                accepted(1),
                accepted(2),
                ended(2, true),
                new StoreEntry.Known(new Msisdn("1"), Imsi.ofOpenNumber(new Msisdn("1")))));
        int last = trafficUntilCompacted(journal);
        assertFalse(disk.names().contains(FIRST_SEGMENT));
        disk.crash();
        StoredState restored = reopened();
        assertEquals(List.of(1L), ids(restored));
        assertEquals(1, restored.unreported().size());
        assertEquals(1, restored.subscribers().size());
        assertEquals(last - 1, restored.lastId());
    }

    @Test
    void aDeathAtAnyStepOfACompactionLosesNothing() throws IOException {
        SimulatedDisk counting = new SimulatedDisk(new Random(1));
        trafficUntilCompacted(prepared(counting));
        for (int steps = (int) counting.operations() - 40; steps <= counting.operations(); steps++) {
            for (int chance = 0; chance < 8; chance++) {
                SimulatedDisk dying = new SimulatedDisk(new Random(chance));
                Journal journal = prepared(dying);
                int left = steps - (int) dying.operations();
                if (chance % 2 == 0) {
                    dying.dieAfter(left);
                } else {
                    dying.killAfter(left);
                }
                try {
                    trafficUntilCompacted(journal);
                } catch (SimulatedDisk.MachineDied death) {
                    // As ordered.
                }
                dying.comeBack();
                StoredState restored = Journal.open(dying).stored();
                assertTrue(ids(restored).contains(1L), "death at operation " + steps);
                assertTrue(ids(restored).size() <= 2, "only the one that was being written may be there besides");
            }
        }
    }

    private static Journal prepared(Disk disk) throws IOException {
        Journal journal = Journal.open(disk, new Journal.Limits(3_000, 3));
        journal.commit(List.of(accepted(1)));
        return journal;
    }

    @Test
    void manyShortLivesLeaveFewFiles() throws IOException {
        for (int life = 1; life <= 200; life++) {
            Journal journal = Journal.open(disk);
            journal.commit(List.of(accepted(life)));
            journal.compact();
            while (journal.isCompacting()) {
                journal.compact();
            }
            journal.close();
        }
        assertEquals(200, ids(reopened()).size());
        assertTrue(disk.names().size() < 40);
    }

    @Test
    void aRealDirectoryKeepsTheSame(@TempDir Path directory) throws IOException {
        Journal journal = Journal.open(new FileDisk(directory), new Journal.Limits(3_000, 3));
        journal.commit(List.of(accepted(1)));
        trafficUntilCompacted(journal);
        journal.commit(List.of(accepted(2)));
        journal.close();
        assertTrue(ids(Journal.open(new FileDisk(directory)).stored()).containsAll(List.of(1L, 2L)));
    }
}
