package simrobot.p2os;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Commands as packet data: {@code number}, then nothing or one argument. Every byte sequence decodes to something. */
public final class CommandCodec {
    private static final int POSITIVE = 0x3B;
    private static final int NEGATIVE = 0x1B;
    private static final int TEXT = 0x2B;

    private static final int MAX_TEXT = 195;

    private CommandCodec() {}

    // ---- what a client sends ------------------------------------------------------------------------------------

    /** A command without argument, framed. */
    public static byte[] packet(int number) {
        return Packet.of(new byte[] {(byte) number});
    }

    /** A command with a number of -65535 to 65535, framed. */
    public static byte[] packet(int number, int argument) {
        if (Math.abs(argument) > 0xFFFF) {
            throw new IllegalArgumentException("an argument is -65535 to 65535, not " + argument);
        }
        int kind = argument < 0 ? NEGATIVE : POSITIVE;
        return Packet.of(
                new Octets().int1(number).int1(kind).int2(Math.abs(argument)).toBytes());
    }

    /** A command with bytes, framed. */
    public static byte[] packet(int number, byte[] argument) {
        if (argument.length > MAX_TEXT) {
            throw new IllegalArgumentException("at most " + MAX_TEXT + " bytes, not " + argument.length);
        }
        return Packet.of(new Octets()
                .int1(number)
                .int1(TEXT)
                .int1(argument.length)
                .raw(argument)
                .toBytes());
    }

    // ---- what a robot hears -------------------------------------------------------------------------------------

    /** @param data of a packet, at least one byte */
    public static P2osCommand decode(byte[] data) {
        int number = data[0] & 0xFF;
        return switch (number) {
            case CommandNumber.PULSE -> new P2osCommand.Pulse();
            case CommandNumber.OPEN -> new P2osCommand.Open();
            case CommandNumber.CLOSE -> new P2osCommand.Close();
            case CommandNumber.SETO -> new P2osCommand.SetOrigin();
            case CommandNumber.STOP -> new P2osCommand.Stop();
            case CommandNumber.E_STOP, CommandNumber.E_STOP_OLD -> new P2osCommand.EmergencyStop();
            case CommandNumber.CONFIG -> new P2osCommand.Configuration();
            case CommandNumber.SIM_RESET -> new P2osCommand.SimReset();
            case CommandNumber.POLLING -> polling(data);
            case CommandNumber.SIM_SET_POSE -> simPose(data);
            case CommandNumber.SIM_STAT -> new P2osCommand.SimStatus(hasNumber(data) ? argument(data) : 1);
            default -> hasNumber(data) ? withNumber(number, argument(data)) : new P2osCommand.Unheeded(number);
        };
    }

    private static P2osCommand withNumber(int number, int argument) {
        return switch (number) {
            case CommandNumber.ENABLE -> new P2osCommand.Enable(argument != 0);
            case CommandNumber.SETA -> new P2osCommand.Acceleration(argument);
            case CommandNumber.SETRA -> new P2osCommand.TurnAcceleration(argument);
            case CommandNumber.SETV -> new P2osCommand.TopSpeed(argument);
            case CommandNumber.SETRV -> new P2osCommand.TopTurnSpeed(argument);
            case CommandNumber.MOVE -> new P2osCommand.Move(argument);
            case CommandNumber.ROTATE, CommandNumber.RVEL -> new P2osCommand.Rotate(argument);
            case CommandNumber.VEL -> new P2osCommand.Velocity(argument);
            case CommandNumber.VEL2 -> new P2osCommand.WheelVelocities((byte) (argument >> 8), (byte) argument);
            case CommandNumber.HEAD -> new P2osCommand.Heading(argument);
            case CommandNumber.DHEAD -> new P2osCommand.TurnBy(argument);
            case CommandNumber.DCHEAD -> new P2osCommand.TurnByFromTarget(argument);
            case CommandNumber.ENCODER -> new P2osCommand.Encoders(argument);
            case CommandNumber.SONAR -> new P2osCommand.Sonar(argument != 0);
            case CommandNumber.BUMPSTALL -> new P2osCommand.BumpStall((argument & 1) != 0, (argument & 2) != 0);
            case CommandNumber.BATTEST -> new P2osCommand.Battery(argument);
            default -> new P2osCommand.Unheeded(number);
        };
    }

    private static boolean hasNumber(byte[] data) {
        return data.length >= 4 && (data[1] == POSITIVE || data[1] == NEGATIVE);
    }

    private static int argument(byte[] data) {
        int size = data[2] & 0xFF | (data[3] & 0xFF) << 8;
        return data[1] == NEGATIVE ? -size : size;
    }

    /** The wire counts sonars from 1; 0 is a pause in the firing order. */
    private static P2osCommand polling(byte[] data) {
        if (data.length < 3 || data[1] != TEXT || (data[2] & 0xFF) > data.length - 3) {
            return new P2osCommand.Unheeded(CommandNumber.POLLING);
        }
        List<Integer> sonars = new ArrayList<>();
        for (byte octet : Arrays.copyOfRange(data, 3, 3 + (data[2] & 0xFF))) {
            if (octet >= 1 && octet <= StandardSip.SONARS) {
                sonars.add(octet - 1);
            }
        }
        return new P2osCommand.Polling(List.copyOf(sonars));
    }

    private static P2osCommand simPose(byte[] data) {
        return data.length < 14
                ? new P2osCommand.Unheeded(CommandNumber.SIM_SET_POSE)
                : new P2osCommand.SimPose(int4(data, 2), int4(data, 6), int4(data, 10));
    }

    private static int int4(byte[] data, int at) {
        return data[at] & 0xFF | (data[at + 1] & 0xFF) << 8 | (data[at + 2] & 0xFF) << 16 | (data[at + 3] & 0xFF) << 24;
    }
}
