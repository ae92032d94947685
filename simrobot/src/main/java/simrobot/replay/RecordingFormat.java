package simrobot.replay;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.zip.CRC32C;
import java.util.zip.DataFormatException;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.Inflater;
import simgsm.octets.OctetReader;
import simgsm.octets.OctetWriter;
import simrobot.process.BehaviourKind;
import simrobot.robot.RobotState;
import simrobot.simulation.Simulation;
import vericommand.RobotStatus;

/**
 * The file. Numbers have their highest octet first; "compact" is LEB128, a text is its length in octets (compact) and UTF-8.
 *
 * <pre>
 *   file    = "SimRobot" version(2) stepNanos(8) { record }
 *   record  = length(4) kind(1) begin(8) end(8) content(length, deflated by RFC 1951) checksum(4)
 *             CRC-32C over kind, begin, end and content; begin and end are simulated times in ns
 *   kinds   = WORLD    name(text) map(text): the world as a .map file
 *             ROBOTS   count(compact) { name(text) }: the robots in their order, from here on
 *             KEY      { entry }; the first has every robot's state and no steps, so reading may begin here
 *             CHANGES  { entry }, goes on where the record before it ended
 *             EVENTS   count(compact) { time(8) robot(text) name(text) line(text) }
 *   entry   = steps since the entry before it(compact) { robots skipped + 1(compact) state } 0(1)
 *   state   = x y heading speed turnSpeed odometryX odometryY odometryHeading (8 each, IEEE 754)
 *             status(1) behaviour(1): its index in {@link BehaviourKind#BUILT_IN}, or 255 name(text)
 * </pre>
 *
 * Records are only ever appended, so after a kill of the writer a file is whole up to its last record but one.
 */
final class RecordingFormat {
    static final String MAGIC = "SimRobot";

    /** Version 1 had predicted states and is refused. */
    static final int VERSION = 2;

    static final int HEADER_OCTETS = MAGIC.length() + 2 + 8;

    /** Far above a writer's maximum; a longer record is damage. */
    private static final int MAX_CONTENT_OCTETS = 256 << 20;

    private static final RobotStatus[] STATUSES = RobotStatus.values();
    private static final List<BehaviourKind> BEHAVIOURS = BehaviourKind.BUILT_IN;

    /** Replaces a built-in behaviour's number; the name follows. */
    private static final int NAMED_BEHAVIOUR = 0xff;

    enum Kind {
        WORLD,
        ROBOTS,
        KEY,
        CHANGES,
        EVENTS
    }

    /** A record as stored in the file, its content deflated. */
    record StoredRecord(Kind kind, long beginNanos, long endNanos, byte[] deflated) {
        private static final int FRAME_OCTETS = 4 + 1 + 8 + 8 + 4;

        static StoredRecord of(Kind kind, long beginNanos, long endNanos, byte[] content) {
            Deflater deflater = new Deflater(Deflater.BEST_SPEED, true);
            try (ByteArrayOutputStream octets = new ByteArrayOutputStream(content.length / 2 + 16)) {
                try (DeflaterOutputStream out = new DeflaterOutputStream(octets, deflater)) {
                    out.write(content);
                }
                return new StoredRecord(kind, beginNanos, endNanos, octets.toByteArray());
            } catch (IOException e) {
                throw new AssertionError("an array throws no IOException", e);
            } finally {
                deflater.end();
            }
        }

        /**
         * The next record of a file; null at the end of the file, also within a record.
         *
         * @throws DamagedException if the checksum or the content is wrong
         */
        static StoredRecord read(DataInputStream in) throws IOException {
            try {
                int length = in.readInt();
                if (length < 0 || length > MAX_CONTENT_OCTETS) {
                    throw new DamagedException("a record of " + length + " octets");
                }
                int kind = in.readUnsignedByte();
                long beginNanos = in.readLong();
                long endNanos = in.readLong();
                // reads the available octets, so a wrong length takes no more memory than the file's size
                byte[] deflated = in.readNBytes(length);
                int checksum = in.readInt();
                if (checksum != checksum(kind, beginNanos, endNanos, deflated)) {
                    throw new DamagedException("a record whose checksum is wrong");
                }
                if (kind >= Kind.values().length) {
                    throw new DamagedException("a record of kind " + kind + ", which this version does not know");
                }
                return new StoredRecord(Kind.values()[kind], beginNanos, endNanos, deflated);
            } catch (EOFException cutOff) {
                return null;
            }
        }

        private static int checksum(int kind, long beginNanos, long endNanos, byte[] deflated) {
            CRC32C crc = new CRC32C();
            crc.update(new OctetWriter()
                    .octet(kind)
                    .eightOctets(beginNanos)
                    .eightOctets(endNanos)
                    .toArray());
            crc.update(deflated);
            return (int) crc.getValue();
        }

        byte[] octets() {
            return new OctetWriter()
                    .fourOctets(deflated.length)
                    .octet(kind.ordinal())
                    .eightOctets(beginNanos)
                    .eightOctets(endNanos)
                    .bytes(deflated)
                    .fourOctets(checksum(kind.ordinal(), beginNanos, endNanos, deflated))
                    .toArray();
        }

        int length() {
            return FRAME_OCTETS + deflated.length;
        }

        OctetReader<DamagedException> content() {
            Inflater inflater = new Inflater(true);
            try {
                inflater.setInput(deflated);
                ByteArrayOutputStream content = new ByteArrayOutputStream(4 * deflated.length);
                byte[] part = new byte[64 << 10];
                while (!inflater.finished()) {
                    int size = inflater.inflate(part);
                    if (size == 0 || content.size() > MAX_CONTENT_OCTETS) {
                        throw new DamagedException("a record that cannot be inflated");
                    }
                    content.write(part, 0, size);
                }
                return new OctetReader<>(content.toByteArray(), DamagedException::new);
            } catch (DataFormatException e) {
                throw new DamagedException("a record that cannot be inflated");
            } finally {
                inflater.end();
            }
        }
    }

    private RecordingFormat() {}

    static byte[] header() {
        return new OctetWriter()
                .bytes(MAGIC.getBytes(StandardCharsets.US_ASCII))
                .twoOctets(VERSION)
                .eightOctets(Simulation.STEP_NANOS)
                .toArray();
    }

    /** @throws IOException saying what is wrong with the header */
    static void checkHeader(byte[] header) throws IOException {
        byte[] ours = header();
        int magic = MAGIC.length();
        if (header.length < ours.length || !Arrays.equals(header, 0, magic, ours, 0, magic)) {
            throw new IOException("no SimRobot recording, expected a file made by --record");
        }
        OctetReader<IOException> rest = new OctetReader<>(header, magic, header.length, IOException::new);
        int version = rest.twoOctets("the version");
        long stepNanos = rest.eightOctets("the step");
        if (version != VERSION || stepNanos != Simulation.STEP_NANOS) {
            throw new IOException("a recording of version " + version + " with steps of " + stepNanos
                    + " ns, which this SimRobot cannot replay; expected version " + VERSION + " with "
                    + Simulation.STEP_NANOS + " ns");
        }
    }

    static void writeState(RobotState state, OctetWriter out) {
        out.real(state.xMeters()).real(state.yMeters()).real(state.headingRadians());
        out.real(state.speedMetersPerSecond()).real(state.turnRadiansPerSecond());
        out.real(state.odometryXMeters()).real(state.odometryYMeters()).real(state.odometryHeadingRadians());
        out.octet(state.status().ordinal());
        int builtIn = BEHAVIOURS.indexOf(state.behaviour());
        if (builtIn >= 0) {
            out.octet(builtIn);
        } else {
            out.octet(NAMED_BEHAVIOUR).text(state.behaviour().text());
        }
    }

    static RobotState readState(OctetReader<DamagedException> in) {
        double[] values = new double[8];
        for (int i = 0; i < values.length; i++) {
            values[i] = in.real();
        }
        int status = in.octet("a status");
        int behaviour = in.octet("a behaviour");
        if (status >= STATUSES.length || behaviour >= BEHAVIOURS.size() && behaviour != NAMED_BEHAVIOUR) {
            throw new DamagedException("a robot with status " + status + " and behaviour " + behaviour);
        }
        return new RobotState(
                values[0],
                values[1],
                values[2],
                values[3],
                values[4],
                values[5],
                values[6],
                values[7],
                STATUSES[status],
                behaviour == NAMED_BEHAVIOUR ? BehaviourKind.shown(in.text()) : BEHAVIOURS.get(behaviour));
    }
}
