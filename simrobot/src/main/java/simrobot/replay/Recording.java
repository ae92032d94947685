package simrobot.replay;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import simgsm.octets.OctetReader;
import simrobot.simulation.Simulation;
import simrobot.world.World;

/**
 * A recorded session that was opened: what it holds and where in the file it is. States are read as they are asked for.
 *
 * <p>A file whose end is missing is read as far as it goes ({@link #isTorn}); one that is damaged within is read up to
 * there ({@link #damage}).
 */
public final class Recording implements AutoCloseable {
    /** A KEY or CHANGES record. @param scene which world and cast it belongs to */
    record Part(long offset, RecordingFormat.Kind kind, long beginNanos, long endNanos, Scene scene) {}

    /** A world and the robots in it. */
    record Scene(World world, List<String> robots) {}

    private final Path path;
    private final RandomAccessFile file;
    private final List<Part> parts = new ArrayList<>();
    private final List<RecordedEvent> events = new ArrayList<>();
    private List<TimelineMarker> markers = List.of();
    private boolean torn;
    private String damage = "";

    private Recording(Path path, RandomAccessFile file) {
        this.path = path;
        this.file = file;
    }

    /**
     * Opens a recording.
     *
     * @throws IOException naming the file and what is wrong: no recording, of a later version, or with nothing in it
     */
    public static Recording open(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            throw new IOException(path + ": expected a recording, found a folder");
        }
        long size = Files.size(path);
        Recording recording = new Recording(path, new RandomAccessFile(path.toFile(), "r"));
        try (DataInputStream in = new DataInputStream(new BufferedInputStream(Files.newInputStream(path), 1 << 16))) {
            recording.readHeader(in);
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

    private void readHeader(DataInputStream in) throws IOException {
        byte[] header = in.readNBytes(RecordingFormat.HEADER_OCTETS);
        byte[] ours = RecordCodec.header();
        int magic = RecordingFormat.MAGIC.length();
        if (header.length < ours.length || !Arrays.equals(header, 0, magic, ours, 0, magic)) {
            throw new IOException(path + ": no SimRobot recording, expected a file made by --record");
        }
        OctetReader<DamagedException> rest =
                new OctetReader<>(Arrays.copyOfRange(header, magic, header.length), DamagedException::new);
        long version = rest.twoOctets("the version");
        long stepNanos = rest.eightOctets("a time");
        if (version != RecordingFormat.VERSION || stepNanos != Simulation.STEP_NANOS) {
            throw new IOException(path + ": a recording of version " + version + " with steps of " + stepNanos
                    + " ns, expected version " + RecordingFormat.VERSION + " with " + Simulation.STEP_NANOS);
        }
    }

    private void scan(DataInputStream in, long size) throws IOException {
        long offset = RecordingFormat.HEADER_OCTETS;
        World world = World.bare();
        Scene scene = new Scene(world, List.of());
        try {
            RecordCodec.Stored record = RecordCodec.read(in);
            while (record != null) {
                switch (record.meaning()) {
                    case WORLD -> world = WorldCodec.read(new OctetReader<>(record.inflated(), DamagedException::new));
                    case CAST ->
                        scene = new Scene(world, names(new OctetReader<>(record.inflated(), DamagedException::new)));
                    case EVENTS -> addEvents(new OctetReader<>(record.inflated(), DamagedException::new));
                    case KEY, CHANGES -> addPart(offset, record, scene);
                }
                offset += RecordingFormat.FRAME_OCTETS + record.content().length;
                record = RecordCodec.read(in);
            }
            torn = offset != size;
        } catch (DamagedException e) {
            damage = e.getMessage() + " at octet " + offset;
        }
        if (parts.isEmpty()) {
            throw new IOException(path + ": " + (damage.isEmpty() ? "the recording holds nothing yet" : damage));
        }
    }

    private void addPart(long offset, RecordCodec.Stored record, Scene scene) {
        OctetReader<DamagedException> times = new OctetReader<>(record.content(), DamagedException::new);
        Part part = new Part(offset, record.meaning(), times.eightOctets("a time"), times.eightOctets("a time"), scene);
        boolean first = parts.isEmpty();
        if (part.endNanos < part.beginNanos
                || (first ? part.kind != RecordingFormat.Kind.KEY : part.beginNanos < lastNanos())) {
            throw new DamagedException("a record from " + part.beginNanos + " to " + part.endNanos + " ns");
        }
        parts.add(part);
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
        long before = 0;
        for (int left = in.count(); left > 0; left--) {
            RecordedEvent event = RecordedEvent.read(in, before);
            before = event.timeNanos();
            events.add(event);
        }
    }

    // ---- what it holds -------------------------------------------------------------------------------------------

    public Path path() {
        return path;
    }

    /** Simulated time at which it begins. */
    public long firstNanos() {
        return parts.get(0).beginNanos;
    }

    /** Simulated time at which it ends. */
    public long lastNanos() {
        return parts.get(parts.size() - 1).endNanos;
    }

    /** The robots at the beginning. */
    public List<String> robots() {
        return parts.get(0).scene.robots;
    }

    /** All that was told, in its order. */
    public List<RecordedEvent> events() {
        return List.copyOf(events);
    }

    /** What a timeline shows, in its order. */
    public List<TimelineMarker> markers() {
        return markers;
    }

    /** Whether the program that wrote it was cut off; what was written before is whole. */
    public boolean isTorn() {
        return torn;
    }

    /** What is wrong within the file and where; nothing behind it is read. */
    public Optional<String> damage() {
        return damage.isEmpty() ? Optional.empty() : Optional.of(path + ": " + damage);
    }

    // ---- for the cursor ------------------------------------------------------------------------------------------

    List<Part> parts() {
        return parts;
    }

    /** The entries of a part. */
    OctetReader<DamagedException> entries(Part part) throws IOException {
        file.seek(part.offset);
        int length = file.readInt();
        int kind = file.readUnsignedByte();
        byte[] content = new byte[length];
        file.readFully(content);
        OctetReader<DamagedException> in =
                new OctetReader<>(new RecordCodec.Stored(kind, content).inflated(), DamagedException::new);
        in.eightOctets("a time");
        in.eightOctets("a time");
        return in;
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
