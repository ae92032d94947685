package simgsm.center.journal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simgsm.air.Msisdn;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.StoreEntry;
import simgsm.octets.OctetString;

/** A journal on a disk whose synchronisation takes hand-moved time, and a sender who keeps a window full. */
class CommitGroupsTest {
    private static final Instant NOW = Instant.parse("2026-11-21T12:00:00Z");
    private static final long MILLI = 1_000_000;
    private static final long SECOND = 1_000 * MILLI;
    private static final int MAX_GROUP = 4_000;

    private long nanos;
    private long syncNanos = 200 * MILLI;

    private final Disk disk = new Disk() {
        private final SimulatedDisk contents = new SimulatedDisk(new Random(1));

        @Override
        public Set<String> names() throws IOException {
            return contents.names();
        }

        @Override
        public DiskFile create(String name) throws IOException {
            return slow(contents.create(name));
        }

        @Override
        public DiskFile open(String name) throws IOException {
            return slow(contents.open(name));
        }

        @Override
        public void rename(String from, String to) throws IOException {
            contents.rename(from, to);
        }

        @Override
        public void delete(String name) throws IOException {
            contents.delete(name);
        }

        @Override
        public void sync() throws IOException {
            nanos += syncNanos;
            contents.sync();
        }
    };

    private DiskFile slow(DiskFile file) {
        return (DiskFile) java.lang.reflect.Proxy.newProxyInstance(
                DiskFile.class.getClassLoader(), new Class<?>[] {DiskFile.class}, (proxy, method, arguments) -> {
                    nanos += method.getName().equals("sync") ? syncNanos : 0;
                    return method.invoke(file, arguments);
                });
    }

    private record Commit(long atNanos, StoreEntry entry) {}

    private final PriorityQueue<Commit> coming = new PriorityQueue<>((a, b) -> Long.compare(a.atNanos, b.atNanos));
    private long lastId;

    private void submitAt(long atNanos) {
        coming.add(new Commit(
                atNanos,
                new StoreEntry.Accepted(new ShortMessage(
                        ++lastId, new Msisdn("1"), new Msisdn("2"), OctetString.ofHex("00"), NOW, NOW))));
    }

    private Commit next(long waitNanos) {
        if (!coming.isEmpty() && coming.peek().atNanos <= nanos + waitNanos) {
            nanos = Math.max(nanos, coming.peek().atNanos);
            return coming.poll();
        }
        nanos += waitNanos;
        return null;
    }

    /**
     * One sender answers 0.1 ms after the other answer; each message is delivered 3 ms after it was accepted.
     *
     * @return messages a second, and synchronisations
     */
    private Map<String, Long> run(int window, Duration time) throws Exception {
        Journal journal = Journal.open(disk);
        CommitGroups<Commit> groups = new CommitGroups<>(() -> nanos);
        for (int i = 0; i < window; i++) {
            submitAt(i * MILLI / 10);
        }
        long accepted = 0;
        long written = 0;
        while (nanos < time.toNanos()) {
            nanos = Math.max(nanos, coming.peek().atNanos);
            List<Commit> group = new ArrayList<>(List.of(coming.poll()));
            groups.gather(group, MAX_GROUP, this::next);
            long began = nanos;
            assertTrue(journal.commit(group.stream().map(Commit::entry).toList()));
            groups.written(group.size(), nanos - began);
            written++;
            long answerNanos = nanos;
            for (Commit commit : group) {
                if (commit.entry instanceof StoreEntry.Accepted message) {
                    accepted++;
                    answerNanos += MILLI / 10;
                    submitAt(answerNanos + 2 * MILLI);
                    coming.add(new Commit(
                            answerNanos + 3 * MILLI,
                            new StoreEntry.Ended(message.message().id(), MessageState.DELIVERED, NOW, false)));
                }
            }
            journal.compact();
        }
        return Map.of("rate", accepted * SECOND / nanos, "written", written);
    }

    @Test
    void aWindowOf100ServesOver400MessagesASecondWith200MillisASynchronisation() throws Exception {
        long rate = run(100, Duration.ofMinutes(5)).get("rate");
        assertTrue(rate >= 400, rate + " messages a second");
    }

    @Test
    void theEndOfAMessageSharesASynchronisationWithTheNextOfASenderWithoutWindow() throws Exception {
        syncNanos = 100 * MILLI;
        long rate = run(1, Duration.ofMinutes(1)).get("rate");
        assertTrue(rate >= 8, rate + " messages a second");
    }

    @Test
    void onAFastDiskNoGroupWaits() throws Exception {
        CommitGroups<Commit> groups = new CommitGroups<>(() -> nanos);
        groups.written(100, MILLI);
        submitAt(MILLI);

        groups.gather(new ArrayList<>(), MAX_GROUP, this::next);

        assertEquals(0, nanos);
    }
}
