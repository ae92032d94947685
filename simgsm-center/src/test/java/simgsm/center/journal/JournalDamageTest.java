package simgsm.center.journal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.text.MessageFormat;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.StoreEntry;
import simgsm.octets.OctetString;

/** Files that are empty, cut, overwritten or missing: what is saved, what is counted as lost, and what is put aside. */
class JournalDamageTest {
    private static final Instant NOW = Instant.parse("2026-11-21T12:00:00Z");
    private static final int MESSAGES = 300;
    private static final String FIRST = FileNames.segment(1);
    private static final String SNAPSHOT = FileNames.snapshot(1);

    private final SimulatedDisk disk = new SimulatedDisk(new Random(1));
    private final JournalState state = new JournalState(20_000);

    /** 300 messages in the first segment. */
    @BeforeEach
    void fill() throws IOException {
        Journal journal = Journal.open(disk);
        for (long id = 1; id <= MESSAGES; id++) {
            assertTrue(journal.commit(List.of(accepted(id))));
        }
        journal.close();
    }

    private static StoreEntry accepted(long id) {
        return new StoreEntry.Accepted(new ShortMessage(
                id, new Msisdn("5550100"), new Msisdn("5550200"), OctetString.ofHex("0102"), NOW, NOW.plusSeconds(9)));
    }

    private RecoveryReport recover() throws IOException {
        Recovery recovery = new Recovery(disk, state);
        recovery.run(disk.names());
        return recovery.report();
    }

    private List<Long> saved() {
        return state.stored().waiting().stream().map(ShortMessage::id).toList();
    }

    private static List<Long> ids(long first, long last) {
        return LongStream.rangeClosed(first, last).boxed().toList();
    }

    private void overwrite(String name, byte[] octets) throws IOException {
        try (DiskFile file = disk.create(name)) {
            file.write(ByteBuffer.wrap(octets), 0);
            file.sync();
        }
        disk.sync();
    }

    /** Replaces the segment by a snapshot. */
    private void compact() throws IOException {
        JournalState whole = new JournalState(20_000);
        new Recovery(disk, whole).run(disk.names());
        Compaction compaction = new Compaction(disk, 1, whole.image());
        while (!compaction.step()) {
            assertFalse(disk.names().contains(SNAPSHOT), "it has no name before it is proven");
        }
        assertEquals(Set.of(SNAPSHOT), disk.names());
    }

    /** The positions at which the records of a file end. */
    private List<Integer> recordEnds(String name) throws IOException {
        List<Integer> ends = new ArrayList<>();
        try (DiskFile file = disk.open(name)) {
            RecordReader reader = new RecordReader(name, file, damage -> {});
            while (reader.next() != null) {
                ends.add((int) reader.goodEnd());
            }
        }
        return ends;
    }

    private static List<String> logged(RecoveryReport report, Level level) {
        LogLines lines = new LogLines(level);
        report.log(lines, 7);
        return lines.texts;
    }

    private static final class LogLines implements System.Logger {
        private final Level kept;
        private final List<String> texts = new ArrayList<>();

        LogLines(Level kept) {
            this.kept = kept;
        }

        @Override
        public String getName() {
            return "lines";
        }

        @Override
        public boolean isLoggable(Level level) {
            return true;
        }

        @Override
        public void log(Level level, ResourceBundle bundle, String text, Throwable thrown) {
            log(level, bundle, text, new Object[0]);
        }

        @Override
        public void log(Level level, ResourceBundle bundle, String format, Object... parameters) {
            if (level == kept) {
                texts.add(
                        parameters == null || parameters.length == 0
                                ? format
                                : MessageFormat.format(format, parameters));
            }
        }
    }

    @Test
    void anEmptySnapshotIsNotTakenForTheTruth() throws IOException {
        overwrite(SNAPSHOT, new byte[0]);
        RecoveryReport report = recover();
        assertEquals(ids(1, MESSAGES), saved());
        assertFalse(report.isLossy(), "the segment that it was to replace is there");
        assertTrue(disk.names().contains(FIRST), "nothing is deleted");
    }

    @Test
    void aSnapshotThatIsCutAnywhereNeverHidesTheSegmentsBeforeIt() throws IOException {
        byte[] segment = disk.octets(FIRST);
        compact();
        byte[] snapshot = disk.octets(SNAPSHOT);
        for (int length = 0; length < snapshot.length; length += 97) {
            overwrite(FIRST, segment);
            overwrite(SNAPSHOT, Arrays.copyOf(snapshot, length));
            JournalState restored = new JournalState(20_000);
            new Recovery(disk, restored).run(disk.names());
            assertEquals(MESSAGES, restored.messages(), "cut at " + length);
            assertTrue(disk.names().contains(FIRST), "cut at " + length);
        }
    }

    @Test
    void aWholeSnapshotReplacesTheSegmentsThatAnInterruptedDeletionHasLeft() throws IOException {
        byte[] segment = disk.octets(FIRST);
        compact();
        overwrite(FIRST, segment);
        assertFalse(recover().isLossy());
        assertEquals(ids(1, MESSAGES), saved());
        assertEquals(Set.of(SNAPSHOT), disk.names());
    }

    @Test
    void aSnapshotThatIsCutBetweenTwoRecordsAndStandsAloneIsReportedAsALoss() throws IOException {
        compact();
        byte[] snapshot = disk.octets(SNAPSHOT);
        List<Integer> ends = recordEnds(SNAPSHOT);
        overwrite(SNAPSHOT, Arrays.copyOf(snapshot, ends.get(99)));
        RecoveryReport report = recover();
        // Marks and numbering take two of the hundred records.
        assertEquals(ids(1, 98), saved());
        assertEquals(
                List.of(
                        "snapshot-0000000001: its end is missing",
                        "the journal is damaged: messages saved: 7, records lost: unknown"),
                logged(report, Level.ERROR));
    }

    @Test
    void theEndOfAClosedSegmentThatIsMissingIsCountedThoughItIsCutBetweenTwoRecords() throws IOException {
        Journal second = Journal.open(disk);
        second.commit(List.of(accepted(1_000)));
        second.close();
        overwrite(FIRST, Arrays.copyOf(disk.octets(FIRST), recordEnds(FIRST).get(MESSAGES - 5)));
        RecoveryReport report = recover();
        assertEquals(MESSAGES - 5 + 1, saved().size());
        assertEquals(5, report.lostRecords());
    }

    @Test
    void recordsLostInTheMiddleAreCounted() throws IOException {
        List<Integer> ends = recordEnds(FIRST);
        byte[] octets = disk.octets(FIRST).clone();
        Arrays.fill(octets, ends.get(9), ends.get(19), (byte) 0);
        overwrite(FIRST, octets);
        RecoveryReport report = recover();
        assertEquals(10, report.lostRecords());
        assertEquals(MESSAGES - 10, saved().size());
        assertEquals(ends.get(19) - ends.get(9), disk.octets(FileNames.damaged(FIRST, ends.get(9))).length);
        assertEquals(
                List.of(
                        "segment-0000000001: 10 records are lost",
                        "the journal is damaged: messages saved: 7, records lost: 10"),
                logged(report, Level.ERROR));
    }

    @Test
    void aSegmentThatIsOverwrittenIsPutAsideBeforeItIsCut() throws IOException {
        byte[] rubbish = new byte[20_000];
        new Random(5).nextBytes(rubbish);
        overwrite(FIRST, rubbish);
        RecoveryReport report = recover();
        assertTrue(saved().isEmpty());
        assertTrue(report.isLossy());
        assertArrayEquals(rubbish, disk.octets(FileNames.damaged(FIRST, 0)));
        assertEquals(0, disk.octets(FIRST).length);
    }

    @Test
    void aTailThatIsTornByADeathIsPutAsideAndNoLoss() throws IOException {
        byte[] whole = disk.octets(FIRST);
        int lastEnd = recordEnds(FIRST).get(MESSAGES - 1);
        byte[] torn = Arrays.copyOf(whole, whole.length - 3);
        overwrite(FIRST, torn);
        RecoveryReport report = recover();
        assertEquals(ids(1, MESSAGES - 1), saved());
        assertFalse(report.isLossy());
        assertArrayEquals(
                Arrays.copyOfRange(torn, lastEnd, torn.length), disk.octets(FileNames.damaged(FIRST, lastEnd)));
        assertEquals(
                List.of("segment-0000000001: torn at octet " + lastEnd + "; the last " + (torn.length - lastEnd)
                        + " octets are cut off; kept in segment-0000000001-" + lastEnd + ".damaged"),
                logged(report, Level.WARNING));
    }

    @Test
    void aTailThatCannotBePutAsideIsSaidToBeLeftInPlace() throws IOException {
        byte[] whole = disk.octets(FIRST);
        int lastEnd = recordEnds(FIRST).get(MESSAGES - 1);
        overwrite(FIRST, Arrays.copyOf(whole, whole.length - 3));
        disk.capacity = 0;

        List<String> logged = logged(recover(), Level.WARNING);

        assertEquals(
                List.of("segment-0000000001: torn at octet " + lastEnd + "; left in place: segment-0000000001-"
                        + lastEnd + ".damaged: cannot be written: no space left on the simulated disk"),
                logged);
        assertEquals(whole.length - 3, disk.octets(FIRST).length);
    }

    @Test
    void aMissingSegmentIsALoss() throws IOException {
        Journal.open(disk).commit(List.of(accepted(1_000)));
        Journal.open(disk).commit(List.of(accepted(1_001)));
        disk.delete(FileNames.segment(2));
        assertEquals(
                List.of(
                        "segment-0000000002: is missing",
                        "the journal is damaged: messages saved: 7, records lost: unknown"),
                logged(recover(), Level.ERROR));
    }

    @Test
    void aSnapshotThatDoesNotReadBackReplacesNothing() throws IOException {
        JournalState whole = new JournalState(20_000);
        new Recovery(disk, whole).run(disk.names());
        Compaction compaction = new Compaction(disk, 1, whole.image());
        assertFalse(compaction.step());
        disk.spoil(FileNames.unfinished(), 1_000);
        assertEquals(
                "the snapshot does not read back as it was written",
                assertThrows(IOException.class, compaction::step).getMessage());
        compaction.abandon();
        assertEquals(Set.of(FIRST), disk.names());
    }

    @Test
    void filesOfTheFirstFormatAreReadWithoutALoss() throws IOException {
        ByteArrayOutputStream segment = new ByteArrayOutputStream();
        ByteArrayOutputStream snapshot = new ByteArrayOutputStream();
        for (int id = 1; id <= 3; id++) {
            RecordFormat.write(snapshot, id, EntryCodec.encode(accepted(id)));
            RecordFormat.write(segment, id, EntryCodec.encode(accepted(id + 10)));
        }
        disk.delete(FIRST);
        overwrite(FileNames.snapshot(4), snapshot.toByteArray());
        overwrite(FileNames.segment(5), segment.toByteArray());
        assertFalse(recover().isLossy());
        assertEquals(List.of(1L, 2L, 3L, 11L, 12L, 13L), saved());
        Journal.open(disk).commit(List.of(accepted(20)));
        assertFalse(recover().isLossy());
    }
}
