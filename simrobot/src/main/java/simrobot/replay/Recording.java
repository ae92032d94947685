package simrobot.replay;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.octets.OctetReader;
import simrobot.replay.RecordingFormat.Kind;
import simrobot.replay.RecordingFormat.StoredRecord;
import simrobot.world.MapReader;
import simrobot.world.World;
import simrobot.world.WorldFormatException;

/**
 * An opened recording: its contents and their offsets in the file. States are read on demand.
 *
 * <p>A file without its end is read up to its last whole record ({@link #isTorn}), a damaged one up to the damage
 * ({@link #damage}).
 */
public final class Recording implements AutoCloseable {
    /**
     * A KEY or CHANGES record.
     *
     * @param scene its world and robots
     */
    record Part(long offset, Kind kind, long beginNanos, long endNanos, Scene scene) {}

    /** A world and its robots. */
    record Scene(World world, List<String> robots) {}

    private final Path path;
    private final FileChannel file;
    private final List<Part> parts = new ArrayList<>();
    private final List<RecordedEvent> events = new ArrayList<>();
    private List<TimelineMarker> markers = List.of();
    private boolean torn;
    private String damage = "";

    private Recording(Path path, FileChannel file) {
        this.path = path;
        this.file = file;
    }

    /**
     * Opens a recording.
     *
     * @throws IOException naming the file and the fault: no recording, of a later version, or empty
     */
    public static Recording open(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            throw new IOException(path + ": expected a recording, found a folder");
        }
        long size = Files.size(path);
        Recording recording = new Recording(path, FileChannel.open(path));
        try (DataInputStream in = new DataInputStream(new BufferedInputStream(Files.newInputStream(path), 1 << 16))) {
            try {
                RecordingFormat.checkHeader(in.readNBytes(RecordingFormat.HEADER_OCTETS));
            } catch (IOException e) {
                throw new IOException(path + ": " + e.getMessage(), e);
            }
            recording.scan(in, size);
            recording.markers = recording.events.stream()
                    .flatMap(event -> event.marker().stream())
                    .toList();
            return recording;
        } catch (IOException e) {
            recording.close();
            throw e;
        }
    }

    private void scan(DataInputStream in, long size) throws IOException {
        long offset = RecordingFormat.HEADER_OCTETS;
        World world = World.bare();
        Scene scene = new Scene(world, List.of());
        try {
            for (StoredRecord record = StoredRecord.read(in); record != null; record = StoredRecord.read(in)) {
                switch (record.kind()) {
                    case WORLD -> world = world(record.content());
                    case ROBOTS -> scene = new Scene(world, names(record.content()));
                    case EVENTS -> addEvents(record.content());
                    case KEY, CHANGES -> addPart(offset, record, scene);
                }
                offset += record.length();
            }
            torn = offset != size;
        } catch (DamagedException e) {
            damage = e.getMessage() + " at octet " + offset;
        }
        if (parts.isEmpty()) {
            throw new IOException(path + ": " + (damage.isEmpty() ? "the recording holds nothing yet" : damage));
        }
    }

    private void addPart(long offset, StoredRecord record, Scene scene) {
        boolean isExpected = parts.isEmpty() ? record.kind() == Kind.KEY : record.beginNanos() >= lastNanos();
        if (!isExpected || record.endNanos() < record.beginNanos()) {
            throw new DamagedException("a record from " + record.beginNanos() + " to " + record.endNanos() + " ns");
        }
        parts.add(new Part(offset, record.kind(), record.beginNanos(), record.endNanos(), scene));
    }

    private static World world(OctetReader<DamagedException> in) {
        try {
            return MapReader.read(in.text(), in.text());
        } catch (WorldFormatException | IllegalArgumentException e) {
            throw new DamagedException("a world that cannot be read: " + e.getMessage());
        }
    }

    private static List<String> names(OctetReader<DamagedException> in) {
        int count = in.count();
        List<String> names = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            names.add(in.text());
        }
        if (names.stream().distinct().count() != count) {
            throw new DamagedException("two robots of one name");
        }
        return List.copyOf(names);
    }

    private void addEvents(OctetReader<DamagedException> in) {
        for (int left = in.count(); left > 0; left--) {
            events.add(RecordedEvent.read(in));
        }
    }

    // ---- what it holds -------------------------------------------------------------------------------------------

    public Path path() {
        return path;
    }

    /** Simulated time of its beginning. */
    public long firstNanos() {
        return parts.get(0).beginNanos;
    }

    /** Simulated time of its end. */
    public long lastNanos() {
        return parts.get(parts.size() - 1).endNanos;
    }

    /** The robots at the beginning. */
    public List<String> robots() {
        return parts.get(0).scene.robots;
    }

    /** All events in order. */
    public List<RecordedEvent> events() {
        return List.copyOf(events);
    }

    /** The marks of the timeline in order. */
    public List<TimelineMarker> markers() {
        return markers;
    }

    /** True if the last record is incomplete, as after a kill; the records before it are whole. */
    public boolean isTorn() {
        return torn;
    }

    /** The damage and its octet in the file; records after it are not read. */
    public Optional<String> damage() {
        return damage.isEmpty() ? Optional.empty() : Optional.of(path + ": " + damage);
    }

    // ---- for the cursor ------------------------------------------------------------------------------------------

    List<Part> parts() {
        return parts;
    }

    /** The entries of a part. */
    OctetReader<DamagedException> entries(Part part) throws IOException {
        StoredRecord record =
                StoredRecord.read(new DataInputStream(Channels.newInputStream(file.position(part.offset))));
        if (record == null) {
            throw new DamagedException("a record is missing at octet " + part.offset);
        }
        return record.content();
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
