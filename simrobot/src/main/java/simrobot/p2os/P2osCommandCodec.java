package simrobot.p2os;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import simgsm.octets.Octets;
import simrobot.robot.SonarRing;

/** Commands as packet data: {@code number}, then nothing or one argument. Every byte sequence decodes to a command. */
public final class P2osCommandCodec {
    private static final int POSITIVE = 0x3B;
    private static final int NEGATIVE = 0x1B;
    private static final int TEXT = 0x2B;

    private static final int MAX_TEXT = 195;
    private static final int SIM_CTRL_HEAD = 6;

    private P2osCommandCodec() {}

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

    /** @param data data of a packet, at least one byte */
    public static P2osCommand decode(byte[] data) {
        int number = data[0] & 0xFF;
        return switch (number) {
            case P2osCommandNumber.PULSE -> new P2osCommand.Pulse();
            case P2osCommandNumber.OPEN -> new P2osCommand.Open();
            case P2osCommandNumber.CLOSE -> new P2osCommand.Close();
            case P2osCommandNumber.SETO -> new P2osCommand.SetOrigin();
            case P2osCommandNumber.STOP -> new P2osCommand.Stop();
            case P2osCommandNumber.E_STOP, P2osCommandNumber.E_STOP_OLD -> new P2osCommand.EmergencyStop();
            case P2osCommandNumber.CONFIG -> new P2osCommand.Configuration();
            case P2osCommandNumber.SIM_RESET -> new P2osCommand.SimReset();
            case P2osCommandNumber.POLLING -> polling(data);
            case P2osCommandNumber.SIM_SET_POSE -> simPose(data);
            case P2osCommandNumber.SIM_CTRL -> simControl(data);
            case P2osCommandNumber.SIM_MESSAGE -> simMessage(data);
            case P2osCommandNumber.SIM_STAT -> new P2osCommand.SimStatus(hasNumber(data) ? argument(data) : 1);
            default -> hasNumber(data) ? withNumber(number, argument(data)) : new P2osCommand.Unheeded(number);
        };
    }

    private static P2osCommand withNumber(int number, int argument) {
        return switch (number) {
            case P2osCommandNumber.ENABLE -> new P2osCommand.Enable(argument != 0);
            case P2osCommandNumber.SETA -> new P2osCommand.Acceleration(argument);
            case P2osCommandNumber.SETRA -> new P2osCommand.TurnAcceleration(argument);
            case P2osCommandNumber.SETV -> new P2osCommand.TopSpeed(argument);
            case P2osCommandNumber.SETRV -> new P2osCommand.TopTurnSpeed(argument);
            case P2osCommandNumber.MOVE -> new P2osCommand.Move(argument);
            case P2osCommandNumber.ROTATE, P2osCommandNumber.RVEL -> new P2osCommand.Rotate(argument);
            case P2osCommandNumber.VEL -> new P2osCommand.Velocity(argument);
            case P2osCommandNumber.VEL2 -> new P2osCommand.WheelVelocities((byte) (argument >> 8), (byte) argument);
            case P2osCommandNumber.HEAD -> new P2osCommand.Heading(argument);
            case P2osCommandNumber.DHEAD -> new P2osCommand.TurnBy(argument);
            case P2osCommandNumber.DCHEAD -> new P2osCommand.TurnByFromTarget(argument);
            case P2osCommandNumber.ENCODER -> new P2osCommand.Encoders(argument);
            case P2osCommandNumber.SONAR -> new P2osCommand.Sonar(argument != 0);
            case P2osCommandNumber.BUMPSTALL -> new P2osCommand.BumpStall((argument & 1) != 0, (argument & 2) != 0);
            case P2osCommandNumber.LASER, P2osCommandNumber.SIM_LRF_ENABLE ->
                laser(P2osCommand.LaserPart.MODE, argument);
            case P2osCommandNumber.LASER_START, P2osCommandNumber.SIM_LRF_START ->
                laser(P2osCommand.LaserPart.START, argument);
            case P2osCommandNumber.LASER_END, P2osCommandNumber.SIM_LRF_END ->
                laser(P2osCommand.LaserPart.END, argument);
            case P2osCommandNumber.LASER_STEP, P2osCommandNumber.SIM_LRF_STEP ->
                laser(P2osCommand.LaserPart.STEP, argument);
            case P2osCommandNumber.BATTEST -> new P2osCommand.BatteryTest(argument);
            default -> new P2osCommand.Unheeded(number);
        };
    }

    private static P2osCommand laser(P2osCommand.LaserPart part, int value) {
        return new P2osCommand.LaserCommand(part, value);
    }

    /** Type, operation 2, length 2, file name; operations 1 and 2 load a world, the others are not served. */
    private static P2osCommand simControl(byte[] data) {
        int operation = hasNumber(data) ? argument(data) : 0;
        boolean loads = operation == 1 || operation == 2;
        if (!loads || data.length < SIM_CTRL_HEAD) {
            return new P2osCommand.Unheeded(P2osCommandNumber.SIM_CTRL);
        }
        int length = data[4] & 0xFF | (data[5] & 0xFF) << 8;
        return new P2osCommand.SimLoad(text(data, SIM_CTRL_HEAD, length));
    }

    private static P2osCommand simMessage(byte[] data) {
        return data.length < 3 || data[1] != TEXT
                ? new P2osCommand.Unheeded(P2osCommandNumber.SIM_MESSAGE)
                : new P2osCommand.SimMessage(text(data, 3, data[2] & 0xFF));
    }

    /** At most {@code length} octets of UTF-8, up to a NUL. */
    private static String text(byte[] data, int from, int length) {
        int end = from;
        while (end < Math.min(data.length, from + length) && data[end] != 0) {
            end++;
        }
        return new String(data, from, end - from, StandardCharsets.UTF_8);
    }

    private static boolean hasNumber(byte[] data) {
        return data.length >= 4 && (data[1] == POSITIVE || data[1] == NEGATIVE);
    }

    private static int argument(byte[] data) {
        int size = data[2] & 0xFF | (data[3] & 0xFF) << 8;
        return data[1] == NEGATIVE ? -size : size;
    }

    /** On the wire sonars are numbered from 1; 0 is a pause in the firing order. */
    private static P2osCommand polling(byte[] data) {
        if (data.length < 3 || data[1] != TEXT || (data[2] & 0xFF) > data.length - 3) {
            return new P2osCommand.Unheeded(P2osCommandNumber.POLLING);
        }
        List<Integer> sonars = new ArrayList<>();
        for (byte octet : Octets.range(data, 3, 3 + (data[2] & 0xFF))) {
            if (octet >= 1 && octet <= SonarRing.COUNT) {
                sonars.add(octet - 1);
            }
        }
        return new P2osCommand.Polling(List.copyOf(sonars));
    }

    private static P2osCommand simPose(byte[] data) {
        return data.length < 14
                ? new P2osCommand.Unheeded(P2osCommandNumber.SIM_SET_POSE)
                : new P2osCommand.SimPose(int4(data, 2), int4(data, 6), int4(data, 10));
    }

    private static int int4(byte[] data, int at) {
        return data[at] & 0xFF | (data[at + 1] & 0xFF) << 8 | (data[at + 2] & 0xFF) << 16 | (data[at + 3] & 0xFF) << 24;
    }
}
