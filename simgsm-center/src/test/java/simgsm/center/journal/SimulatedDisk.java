package simgsm.center.journal;

import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.random.RandomGenerator;

/**
 * A disk with a cache that dies with the machine: what was not synchronised survives a crash in part, torn anywhere, or
 * not at all; the same for names. It can be set to fail, and to end its machine or its process between any two operations or
 * within a write.
 */
public final class SimulatedDisk implements Disk {
    /** The machine or the process has died; nothing that the process does any more has an effect. */
    public static final class MachineDied extends Error {
        private static final long serialVersionUID = 1;

        MachineDied(boolean isPowerCut) {
            super(isPowerCut ? "the simulated machine has died" : "the simulated process has died");
        }
    }

    private static final class Contents {
        byte[] octets = {};
        byte[] durable = {};
    }

    private final RandomGenerator random;
    private final Map<String, Contents> files = new HashMap<>();
    private final Map<String, Contents> durableFiles = new HashMap<>();
    private final List<Runnable> unsyncedNames = new ArrayList<>();
    private int operationsToLive = Integer.MAX_VALUE;
    private boolean isPowerCut;
    private boolean isDead;
    private long operations;
    /** Each operation that writes fails with this probability. */
    public double failureRate;
    /** Room for the contents of all files; a write beyond it writes what fits. */
    public long capacity = Long.MAX_VALUE;

    public SimulatedDisk(RandomGenerator random) {
        this.random = random;
    }

    /** The power is cut at the disk operation after this number of further ones. */
    public void dieAfter(int count) {
        operationsToLive = count;
        isPowerCut = true;
    }

    /** The process is killed at the disk operation after this number of further ones; the machine and its cache go on. */
    public void killAfter(int count) {
        operationsToLive = count;
        isPowerCut = false;
    }

    /** Another process begins after {@link MachineDied}, with what the kind of death has left. */
    public void comeBack() {
        if (isPowerCut) {
            crash();
        } else {
            restart();
        }
    }

    public long operations() {
        return operations;
    }

    /** The power comes back: what is durable is there, and of the rest what chance has left. */
    public void crash() {
        for (Runnable change : unsyncedNames) {
            if (random.nextBoolean()) {
                change.run();
            }
        }
        unsyncedNames.clear();
        files.clear();
        files.putAll(durableFiles);
        files.values().forEach(this::tear);
        isDead = false;
        operationsToLive = Integer.MAX_VALUE;
    }

    /** The process has died and another one lives; the machine, and with it the cache, goes on. */
    public void restart() {
        isDead = false;
        operationsToLive = Integer.MAX_VALUE;
    }

    private void tear(Contents contents) {
        byte[] now = contents.octets;
        byte[] left = contents.durable;
        if (!Arrays.equals(now, left) && random.nextBoolean()) {
            int common = Arrays.mismatch(now, left);
            left = Arrays.copyOf(now, common + random.nextInt(now.length - common + 1));
            if (left.length > common && random.nextBoolean()) {
                left[common + random.nextInt(left.length - common)] ^= (byte) (1 + random.nextInt(255));
            }
        }
        contents.octets = left;
        contents.durable = left;
    }

    /** Changes one octet of a file, as failing media do. */
    public void spoil(String name, int position) {
        Contents contents = files.get(name);
        contents.octets = contents.octets.clone();
        contents.octets[position] ^= 0x55;
        contents.durable = contents.octets;
    }

    public byte[] octets(String name) {
        return files.get(name).octets;
    }

    private void operate() {
        operations++;
        if (isDead || operationsToLive-- <= 0) {
            isDead = true;
            throw new MachineDied(isPowerCut);
        }
    }

    private void operateOrFail() throws IOException {
        operate();
        if (random.nextDouble() < failureRate) {
            throw new IOException("no space left on the simulated disk");
        }
    }

    @Override
    public Set<String> names() throws IOException {
        operate();
        return new TreeSet<>(files.keySet());
    }

    @Override
    public DiskFile create(String name) throws IOException {
        operateOrFail();
        Contents fresh = new Contents();
        files.put(name, fresh);
        unsyncedNames.add(() -> durableFiles.put(name, fresh));
        return new OpenFile(fresh);
    }

    @Override
    public DiskFile open(String name) throws IOException {
        operate();
        return new OpenFile(existing(name));
    }

    private Contents existing(String name) throws FileNotFoundException {
        Contents found = files.get(name);
        if (found == null) {
            throw new FileNotFoundException(name);
        }
        return found;
    }

    @Override
    public void rename(String from, String to) throws IOException {
        operateOrFail();
        Contents moved = existing(from);
        files.remove(from);
        files.put(to, moved);
        unsyncedNames.add(() -> {
            durableFiles.remove(from, moved);
            durableFiles.put(to, moved);
        });
    }

    @Override
    public void delete(String name) throws IOException {
        operateOrFail();
        Contents gone = existing(name);
        files.remove(name);
        unsyncedNames.add(() -> durableFiles.remove(name, gone));
    }

    @Override
    public void sync() throws IOException {
        operateOrFail();
        unsyncedNames.clear();
        durableFiles.clear();
        durableFiles.putAll(files);
    }

    private final class OpenFile implements DiskFile {
        private final Contents contents;

        OpenFile(Contents contents) {
            this.contents = contents;
        }

        @Override
        public long size() {
            operate();
            return contents.octets.length;
        }

        @Override
        public void read(ByteBuffer into, long position) {
            operate();
            int start = (int) Math.min(position, contents.octets.length);
            into.put(contents.octets, start, Math.min(into.remaining(), contents.octets.length - start));
        }

        /** A failing write, and one within which the process dies, may have written a part. */
        @Override
        public void write(ByteBuffer octets, long position) throws IOException {
            boolean isWhole = random.nextDouble() >= failureRate && further(octets, position) <= room();
            boolean isLast = !isDead && operationsToLive <= 0;
            int count = isWhole && !isLast ? octets.remaining() : random.nextInt(octets.remaining() + 1);
            count = (int) Math.min(count, contents.octets.length - position + room());
            if (!isDead) {
                write(octets, (int) position, count);
            }
            operate();
            if (!isWhole) {
                throw new IOException("no space left on the simulated disk");
            }
        }

        private long further(ByteBuffer octets, long position) {
            return Math.max(0, position + octets.remaining() - contents.octets.length);
        }

        private long room() {
            return Math.max(
                    0,
                    capacity
                            - files.values().stream()
                                    .mapToLong(each -> each.octets.length)
                                    .sum());
        }

        private void write(ByteBuffer octets, int start, int count) {
            byte[] written = Arrays.copyOf(contents.octets, Math.max(contents.octets.length, start + count));
            octets.get(written, start, count);
            contents.octets = written;
        }

        @Override
        public void truncate(long size) throws IOException {
            operateOrFail();
            if (size < contents.octets.length) {
                contents.octets = Arrays.copyOf(contents.octets, (int) size);
            }
        }

        @Override
        public void sync() throws IOException {
            operateOrFail();
            contents.durable = contents.octets;
        }

        @Override
        public void close() {
            // The cache outlives the file's being open.
        }
    }
}
