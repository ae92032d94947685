package simrobot.p2os;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.octets.Octets;
import simrobot.robot.SonarRing;
import vericommand.Pose;

/**
 * A client's command as packet data: a {@link P2osCommandNumber}, then nothing or one argument. A command whose argument is
 * missing or of the wrong type has no effect.
 */
public final class P2osCommand {
    private static final int POSITIVE = 0x3B;
    private static final int NEGATIVE = 0x1B;
    private static final int TEXT = 0x2B;
    private static final int TEXT_HEAD = 3;
    private static final int MAX_TEXT = 195;
    private static final int SIM_CTRL_HEAD = 6;
    private static final int POSE_LENGTH = 14;

    private final byte[] data;

    /** @param data data of a packet, at least one byte */
    P2osCommand(byte[] data) {
        this.data = data;
    }

    // ---- encoding -----------------------------------------------------------------------------------------------

    /** Returns a framed command without argument. */
    public static byte[] packet(int number) {
        return P2osPacket.of(new byte[] {(byte) number});
    }

    /** Returns a framed command with an integer argument, -65535 to 65535. */
    public static byte[] packet(int number, int argument) {
        if (Math.abs(argument) > 0xFFFF) {
            throw new IllegalArgumentException("an argument is -65535 to 65535, not " + argument);
        }
        int kind = argument < 0 ? NEGATIVE : POSITIVE;
        return P2osPacket.of(P2osPacket.data()
                .octet(number)
                .octet(kind)
                .twoOctets(Math.abs(argument))
                .toArray());
    }

    /** Returns a framed command with a byte-string argument. */
    public static byte[] packet(int number, byte[] argument) {
        if (argument.length > MAX_TEXT) {
            throw new IllegalArgumentException("at most " + MAX_TEXT + " bytes, not " + argument.length);
        }
        return P2osPacket.of(P2osPacket.data()
                .octet(number)
                .octet(TEXT)
                .octet(argument.length)
                .bytes(argument)
                .toArray());
    }

    // ---- decoding -----------------------------------------------------------------------------------------------

    int number() {
        return data[0] & 0xFF;
    }

    /** True if the argument is an integer. */
    boolean hasInteger() {
        return data.length >= 4 && (data[1] == POSITIVE || data[1] == NEGATIVE);
    }

    /** The integer argument; requires {@link #hasInteger}. */
    int integer() {
        int size = unsigned(2);
        return data[1] == NEGATIVE ? -size : size;
    }

    /** The sonars selected by {@code POLLING}, sonar 0 for 1 on the wire; invalid numbers are ignored. */
    Optional<List<Integer>> sonars() {
        if (!hasText() || (data[2] & 0xFF) > data.length - TEXT_HEAD) {
            return Optional.empty();
        }
        List<Integer> sonars = new ArrayList<>();
        for (byte octet : Octets.range(data, TEXT_HEAD, TEXT_HEAD + (data[2] & 0xFF))) {
            if (octet >= 1 && octet <= SonarRing.COUNT) {
                sonars.add(octet - 1);
            }
        }
        return Optional.of(sonars);
    }

    /** The file that {@code SIM_CTRL} loads: operation 1 or 2, a length, and the name. */
    Optional<String> worldFile() {
        boolean loads = hasInteger() && (integer() == 1 || integer() == 2) && data.length >= SIM_CTRL_HEAD;
        return loads ? Optional.of(text(SIM_CTRL_HEAD, unsigned(SIM_CTRL_HEAD - 2))) : Optional.empty();
    }

    /** The text argument. */
    Optional<String> text() {
        return hasText() ? Optional.of(text(TEXT_HEAD, data[2] & 0xFF)) : Optional.empty();
    }

    /** The pose of {@code SIM_SET_POSE}: three integers of four octets, in mm and degrees. */
    Optional<Pose> pose() {
        return data.length < POSE_LENGTH
                ? Optional.empty()
                : Optional.of(new Pose(signed(2) / 1000.0, signed(6) / 1000.0, signed(10)));
    }

    private boolean hasText() {
        return data.length >= TEXT_HEAD && data[1] == TEXT;
    }

    private String text(int from, int length) {
        int end = from;
        while (end < Math.min(data.length, from + length) && data[end] != 0) {
            end++;
        }
        return new String(data, from, end - from, StandardCharsets.UTF_8);
    }

    private int unsigned(int at) {
        return data[at] & 0xFF | (data[at + 1] & 0xFF) << 8;
    }

    private int signed(int at) {
        return unsigned(at) | unsigned(at + 2) << 16;
    }
}
