package simgsm.classroom.lesson;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.Optional;
import simgsm.console.Event;

/** Finds a mobile's first SETUP in a capture of the centre, and names its octets. */
final class CapturedMessage {
    private static final int FILE_HEADER = 24;
    private static final int RECORD_HEADER = 16;
    private static final int CAPTURED_LENGTH_AT = 8;
    private static final int TCP = 6;
    /** Length of an RSL DATA INDICATION's header: discriminator, type, channel, link, and the length's element. */
    private static final int RSL_HEADER = 9;

    private static final int IPA_HEADER = 3;
    private static final int CALL_CONTROL = 0x03;
    private static final int SETUP = 0x05;
    /** Excludes bits 7 and 8 of a mobile's message type, its send sequence number (TS 24.007, 11.2.3.2.1). */
    private static final int TYPE_MASK = 0x3f;

    private static final int PROTOCOL_MASK = 0x0f;
    private static final int CALLED_NUMBER = 0x5e;
    private static final int RSL_RADIO_LINK = 0x03;
    private static final int RSL_DISCRIMINATOR_MASK = 0xfe;

    private CapturedMessage() {}

    /**
     * Reads a capture.
     *
     * @return an event {@code setup length= stream= rsl= protocol= type= digits= at=}: hexadecimal octets, and the number of the
     *     call control message's first octet in the TCP segment, counted from 0; empty if there is no SETUP
     */
    static Optional<Event> setup(Path file) throws IOException {
        ByteBuffer all = ByteBuffer.wrap(Files.readAllBytes(file));
        int at = FILE_HEADER;
        while (at + RECORD_HEADER <= all.limit()) {
            int length = all.getInt(at + CAPTURED_LENGTH_AT);
            int packet = at + RECORD_HEADER;
            if (length < 0 || packet + length > all.limit()) {
                break; // the capture is still being written
            }
            Optional<Event> found = inPacket(all, packet, packet + length);
            if (found.isPresent()) {
                return found;
            }
            at = packet + length;
        }
        return Optional.empty();
    }

    private static Optional<Event> inPacket(ByteBuffer all, int packet, int end) {
        int version = octet(all, packet) >> 4;
        int header = version == 4 ? 4 * (octet(all, packet) & 0x0f) : 40;
        int protocol = octet(all, packet + (version == 4 ? 9 : 6));
        if (protocol != TCP) {
            return Optional.empty();
        }
        int payload = packet + header + 4 * (octet(all, packet + header + 12) >> 4);
        int message = payload + IPA_HEADER + RSL_HEADER;
        boolean isSetup = message + 2 < end
                && octet(all, payload + 2) == 0
                && (octet(all, payload + IPA_HEADER) & RSL_DISCRIMINATOR_MASK)
                        == (RSL_RADIO_LINK & RSL_DISCRIMINATOR_MASK)
                && (octet(all, message) & PROTOCOL_MASK) == CALL_CONTROL
                && octet(all, message) < 0x80
                && (octet(all, message + 1) & TYPE_MASK) == SETUP;
        return isSetup
                ? number(all, message, end)
                        .map(digits -> Event.of("setup")
                                .with("length", hex(all, payload, 2))
                                .with("stream", hex(all, payload + 2, 1))
                                .with("rsl", hex(all, payload + IPA_HEADER + 1, 1))
                                .with("protocol", hex(all, message, 1))
                                .with("type", hex(all, message + 1, 1))
                                .with("digits", digits)
                                .with("at", message - payload))
                : Optional.empty();
    }

    /** Decodes the called party's number. */
    private static Optional<String> number(ByteBuffer all, int message, int end) {
        for (int at = message + 2; at + 2 < end; at++) {
            int length = octet(all, at + 1);
            if (octet(all, at) == CALLED_NUMBER && length > 1 && at + 2 + length <= end) {
                return Optional.of(hex(all, at + 3, length - 1));
            }
        }
        return Optional.empty();
    }

    private static int octet(ByteBuffer all, int at) {
        return all.get(at) & 0xff;
    }

    private static String hex(ByteBuffer all, int at, int length) {
        byte[] octets = new byte[length];
        all.get(at, octets);
        return HexFormat.of().formatHex(octets);
    }
}
